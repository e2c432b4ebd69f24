#!/usr/bin/env python3
"""Checks by evaluation that the claims of this folder are true or false as their files say.

    pip install mpmath
    python3 tests/corpus/check.py [FILE ...]
    python3 tests/corpus/check.py --unneeded REPORT [FILE ...]   # of `carom audit --format json FILE ... > REPORT`

Reads the claim files with a parser of its own and shares nothing with Carom. A claim without `expect refuted` must
hold at every point that is tried: the points of its `# holds at` comments, and random points at which its hypotheses
hold (equations are solved by Newton's method for variables picked at random; recurrences are followed). A claim with
`expect refuted` must fail at the point of its `# false at` comment or, where it has none, at some point that is tried.
Numbers have 200 digits; two that agree to 50 count as equal, in hypotheses to 150. Limits are looked at far out, extrema on random grids.
With `--unneeded`, each hypothesis that the report calls not needed is dropped, and a point is looked for
at which the claim fails without it. A comment `# by hand: ...` gives the proof of what points cannot show. Exit code 0 if every claim passes, 1 if not.
"""
import copy
import json
import pathlib
import random
import re
import sys

import mpmath
from mpmath import mpf

mpmath.mp.dps = 200
CLOSE = mpf(10) ** -50
SOLVED = mpf(10) ** -150
POINTS = 40
TOKEN = re.compile(r"\s*(?:(\d+(?:\.(?!\.)\d+)?)|([A-Za-z][\w']*)|(<=>|=>|->|<=|>=|!=|\.\.|[-+*/^()\[\],;:=<>|!]))")
FUNCTIONS = {name: getattr(mpmath, name) for name in ("exp", "cosh", "sinh", "tanh", "sech", "sin", "cos", "tan", "factorial")}
FUNCTIONS |= {"abs": abs, "floor": mpmath.floor, "ceil": mpmath.ceil}
SEVERAL = {"min": min, "max": max, "binomial": mpmath.binomial}


class Undefined(Exception):
    """An expression has no value here."""


def tokens(text):
    out, at = [], 0
    text = text.rstrip()
    while at < len(text):
        match = TOKEN.match(text, at)
        if not match:
            raise SyntaxError(f"cannot read {text[at:at + 20]!r}")
        out.append(match.group().strip())
        at = match.end()
    return out + [""]


class Parser:
    """Statements and expressions as nested tuples."""

    def __init__(self, text):
        self.list, self.at = tokens(text), 0

    def take(self, *wanted):
        if wanted and self.list[self.at] not in wanted:
            raise SyntaxError(f"expected {wanted}, found {self.list[self.at:self.at + 5]}")
        self.at += 1
        return self.list[self.at - 1]

    def next(self, *words):
        if self.list[self.at] in words:
            self.at += 1
            return True
        return False

    def chain(self, sign, part):
        parts = [part()]
        while self.next(sign):
            parts.append(part())
        return parts[0] if len(parts) == 1 else (sign, *parts)

    def statement(self):
        return self.chain("<=>", self.implication)

    def implication(self):
        left = self.chain("or", lambda: self.chain("and", self.negation))
        return ("=>", left, self.implication()) if self.next("=>") else left

    def negation(self):
        return ("not", self.negation()) if self.next("not") else self.atom()

    def atom(self):
        if self.next("for"):
            self.take("all")
            return "all", self.bindings(":"), self.statement()
        if self.next("exists"):
            return "exists", self.bindings(":"), self.statement()
        if self.next("limit"):
            self.take("of")
            body = self.sum()
            self.take("as")
            name = self.take()
            self.take("->")
            point = None if self.next("infinity") else self.sum()
            sides = [] if point is None else [1, -1]
            if self.next("from"):
                sides = [1 if self.take() == "above" else -1]
            self.take("is")
            minus = self.list[self.at : self.at + 2] == ["-", "infinity"] and self.take()
            infinite = self.next("infinity") and (-1 if minus else 1)
            return "limit", body, name, point, sides, infinite, None if infinite else self.sum()
        if self.list[self.at] in ("maximum", "minimum"):
            kind = self.take()
            self.take("of")
            body = self.sum()
            self.take("over")
            domains, last = self.bindings("at", "only", "is"), self.list[self.at - 1]
            only = last == "only"
            if only:
                self.take("at")
            place = {}
            while last != "is" and (not place or self.next(",")):
                name = self.take()
                self.take("=")
                place[name] = self.sum()
            if last != "is":
                self.take("is")
            return kind, body, domains, only, place, self.sum()
        start = self.at
        try:
            parts = [self.sum()]
            while self.list[self.at] in ("=", "!=", "<", "<=", ">", ">="):
                parts += [self.take(), self.sum()]
            if len(parts) == 1:
                raise SyntaxError("no comparison")
            return "compare", *parts
        except SyntaxError:
            self.at = start
            self.take("(")
            inner = self.statement()
            self.take(")")
            return inner

    def bindings(self, *ends):
        """Declarations up to one of the words: name, whether a family, domain."""
        out = []
        while True:
            names = [self.declared()]
            while self.next(","):
                names.append(self.declared())
            domain = self.domain()
            out += [(name, family, domain) for name, family in names]
            if self.take(";", *ends) != ";":
                return out

    def declared(self):
        name = self.take()
        family = self.next("(")
        if family:
            self.take(), self.take(")")
        return name, family

    def domain(self):
        if self.next("in"):
            opening = self.take() if self.list[self.at] in "[(" else ""
            low = self.sum()
            if self.next(".."):
                return "natural", low, self.sum()
            self.take(",")
            high = self.sum()
            return "range", opening, low, high, self.take("]", ")")
        if self.next("natural"):
            return "natural", self.sum() if self.next(">=") else ("number", mpf(0)), None
        if self.next("integer"):
            return ("integer",)
        if self.next("real"):
            return ("but", self.sum()) if self.next("!=") else ("real",)
        sign, bound = self.take(">", ">=", "<", "<="), self.sum()
        return ("range", "[" if "=" in sign else "(", bound, None, "") if ">" in sign else ("range", "", None, bound, "]" if "=" in sign else ")")

    def sum(self):
        left = self.product()
        while self.list[self.at] in ("+", "-"):
            left = (self.take(), left, self.product())
        return left

    def product(self):
        left = self.unary()
        while self.list[self.at] in ("*", "/"):
            left = (self.take(), left, self.unary())
        return left

    def unary(self):
        return ("negative", self.unary()) if self.next("-") else self.power()

    def power(self):
        base = self.primary()
        while self.next("!"):
            base = "call", "factorial", base
        return ("^", base, self.unary()) if self.next("^") else base

    def primary(self):
        word = self.take()
        if word == "(":
            inner = self.sum()
            self.take(")")
            return inner
        if word == "|":
            inner = self.sum()
            self.take("|")
            return "call", "abs", inner
        if word == "[":
            rows = [[self.sum()]]
            while (sign := self.take(",", ";", "]")) != "]":
                if sign == ";":
                    rows.append([])
                rows[-1].append(self.sum())
            return "matrix", rows
        if re.fullmatch(r"\d+(\.\d+)?", word):
            return "number", mpf(word)
        if not re.fullmatch(r"[A-Za-z][\w']*", word) or word in ("and", "or", "not", "is", "as", "over", "at", "only"):
            raise SyntaxError(f"no expression begins with {word!r}")
        if not self.next("("):
            return "name", word
        if word in ("sum", "product"):
            index = self.take()
            self.take("=")
            low = self.sum()
            self.take("..")
            high = self.sum()
            self.take(",")
            out = word, index, low, high, self.sum()
        elif word == "derivative":
            out = [word, self.sum()]
            while self.next(","):
                out.append(self.take())
            out = tuple(out)
        elif word in SEVERAL:
            out = [self.sum()]
            while self.next(","):
                out.append(self.sum())
            out = "several", word, out
        else:
            out = "call", word, self.sum()
        self.take(")")
        return out


def equal(a, b):
    return abs(a - b) <= tolerance * (1 + abs(a) + abs(b))


tolerance = CLOSE


def compare(sign, a, b):
    if isinstance(a, list):
        same = all(equal(x, y) for r, s in zip(a, b) for x, y in zip(r, s))
        return same == (sign == "=")
    same = equal(a, b)
    return {"=": same, "!=": not same, "<": a < b and not same, ">": a > b and not same, "<=": a <= b or same, ">=": a >= b or same}[sign]


def value(e, env):
    op = e[0]
    if op == "number":
        return e[1]
    if op == "name":
        return +mpmath.pi if e[1] == "pi" else env[e[1]]
    if op == "negative":
        return -value(e[1], env)
    if op in ("sum", "product"):
        low, high = (int(value(end, env)) for end in e[2:4])
        if low < 0 or high < low - 1:
            raise Undefined
        total = mpf(op == "product")
        for i in range(low, high + 1):
            term = value(e[4], {**env, e[1]: mpf(i)})
            total = total * term if op == "product" else total + term
        return total
    if op == "derivative":
        body, names = e[1], e[2:]
        (name,) = set(names)
        return mpmath.diff(lambda t: value(body, {**env, name: t}), env[name], len(names))
    if op == "matrix":
        return [[value(x, env) for x in row] for row in e[1]]
    if op == "call":
        return call(e[1], e[2], env)
    if op == "several":
        return SEVERAL[e[1]](*(value(x, env) for x in e[2]))
    a, b = value(e[1], env), value(e[2], env)
    if isinstance(a, list) and op == "^":
        return matrix_power(a, b)
    if isinstance(a, list) or isinstance(b, list):
        return matrices(op, a, b)
    if op == "/":
        if b == 0:
            raise Undefined
        return a / b
    if op == "^":
        return power(a, b)
    return a + b if op == "+" else a - b if op == "-" else a * b


def matrices(op, a, b):
    if op == "*" and not isinstance(a, list):
        return [[a * x for x in row] for row in b]
    if op == "*":
        return [[sum(x * b[k][j] for k, x in enumerate(row)) for j in range(len(b[0]))] for row in a]
    return [[x + y if op == "+" else x - y for x, y in zip(r, s)] for r, s in zip(a, b)]


def matrix_power(a, k):
    if k != int(k):
        raise Undefined
    factor, out = a if k >= 0 else inverse(a), [[mpf(i == j) for j in range(len(a))] for i in range(len(a))]
    for _ in range(abs(int(k))):
        out = matrices("*", out, factor)
    return out


def inverse(rows):
    d = determinant(rows)
    if d == 0:
        raise Undefined
    minor = lambda i, j: [[x for c, x in enumerate(row) if c != j] for r, row in enumerate(rows) if r != i]
    n = range(len(rows))
    return [[(-1) ** (i + j) * determinant(minor(i, j)) / d for i in n] for j in n]


def power(a, b):
    if b == int(b) if abs(b) < 10**15 else False:
        if a == 0 and b < 0:
            raise Undefined
        return a ** int(b)
    if a < 0 or (a == 0 and b < 0):
        raise Undefined
    return a**b


def call(name, argument, env):
    v = value(argument, env)
    if name in ("sqrt", "cbrt"):
        if v < 0:
            # A difference that is 0 but for rounding.
            if v > -CLOSE * CLOSE:
                return mpf(0)
            raise Undefined
        return mpmath.sqrt(v) if name == "sqrt" else mpmath.cbrt(v)
    if name == "ln":
        if v <= 0:
            raise Undefined
        return mpmath.log(v)
    if name in ("arcsin", "arccos"):
        if abs(v) > 1:
            # As above; the root of a sum of squares may lie above 1 by rounding.
            if abs(v) > 1 + CLOSE * CLOSE:
                raise Undefined
            v = mpmath.sign(v)
        return mpmath.asin(v) if name == "arcsin" else mpmath.acos(v)
    if name == "arctan":
        return mpmath.atan(v)
    if name == "tan" and abs(mpmath.cos(v)) < CLOSE:
        raise Undefined
    if name == "det":
        return determinant(v)
    if name == "inverse":
        return inverse(v)
    if name == "trace":
        return sum(v[i][i] for i in range(len(v)))
    if name == "transpose":
        return [list(column) for column in zip(*v)]
    if name == "factorial" and (v < 0 or v != int(v)):
        raise Undefined
    if name in FUNCTIONS:
        return FUNCTIONS[name](v)
    return env[name](int(v))


def determinant(rows):
    if not rows:
        return mpf(1)
    first, rest = rows[0], rows[1:]
    return sum((-1) ** j * x * determinant([r[:j] + r[j + 1 :] for r in rest]) for j, x in enumerate(first))


def truth(p, env, rng):
    op = p[0]
    if op == "compare":
        values = [value(e, env) for e in p[1::2]]
        return all(compare(sign, a, b) for sign, a, b in zip(p[2::2], values, values[1:]))
    if op in ("and", "or"):
        return (all if op == "and" else any)(truth(q, env, rng) for q in p[1:])
    if op == "not":
        return not truth(p[1], env, rng)
    if op == "=>":
        return not truth(p[1], env, rng) or truth(p[2], env, rng)
    if op == "<=>":
        return len({truth(q, env, rng) for q in p[1:]}) == 1
    if op == "all":
        return all(truth(p[2], place(p[1], env, rng), rng) for _ in range(60))
    if op == "exists":
        return exists(p, env, rng)
    if op == "limit":
        return limit(p, env)
    return extremum(p, env, rng)


def exists(p, env, rng):
    samples = [place(p[1], env, rng) for _ in range(400)]
    if any(truth(p[2], s, rng) for s in samples):
        return True
    (name, _, domain), = p[1]
    if p[2][0] != "compare" or p[2][2] != "=":
        return False
    gap = lambda t: value(p[2][1], {**env, name: t}) - value(p[2][3], {**env, name: t})
    spots = sorted(s[name] for s in samples)
    for a, b in zip(spots, spots[1:]):
        if gap(a) * gap(b) < 0:
            return inside(domain, mpmath.findroot(gap, (a, b), solver="anderson"), env)
    return False


def limit(p, env):
    _, body, name, point, sides, infinite, target = p
    spots = (50, 400, 3000) if "sum" in str(body) or "product" in str(body) else (10**3, 10**6, 10**12)
    if point is not None:
        a = value(point, env)
        near = lambda side, n: value(body, {**env, name: a + side / mpf(n)})
        return all(tends(lambda n: near(side, n), spots, infinite, target, env) for side in sides)
    return tends(lambda n: value(body, {**env, name: mpf(n)}), spots, infinite, target, env)


def tends(body, spots, infinite, target, env):
    if infinite:
        here = [infinite * body(n) for n in spots]
        return 0 < here[0] < here[1] < here[2] and here[2] - here[1] > (here[1] - here[0]) / 2
    goal = value(target, env)
    gaps = [abs(body(n) - goal) for n in spots]
    return gaps[2] < mpf("1e-3") * (1 + abs(goal)) and gaps[2] <= gaps[0] + CLOSE


def nearest(gap, spot, domains, env):
    """The least gap that small steps from a spot lead to, one variable after the other."""
    for name, _, domain in domains * 3:
        step = abs(spot[name]) / 2 + mpf(1) / 10
        while step > mpf("1e-12"):
            tried = [{**spot, name: spot[name] + s * step} for s in (-1, 1)]
            better = [t for t in tried if inside(domain, t[name], env) and gap(t) < gap(spot)]
            spot, step = (better[0], step) if better else (spot, step / 2)
    return gap(spot)


def extremum(p, env, rng):
    kind, body, domains, only, at, best = p
    at = {name: value(e, env) for name, e in at.items()}
    if not at:
        bound = "compare", body, "<=" if kind == "maximum" else ">=", best
        spots = [place(domains, env, rng) for _ in range(300)]
        gap = lambda s: abs(value(body, s) - value(best, env))
        return all(truth(bound, s, rng) for s in spots) and nearest(gap, min(spots, key=gap), domains, env) < mpf("1e-9")
    best = value(best, env)
    if not all(inside(d, at[n], env) for n, _, d in domains) or not equal(value(body, {**env, **at}), best):
        return False
    near = [{n: at[n] * (1 + mpf(s) / 1000) for n in at} for s in (-9, -1, 1, 9)]
    for spot in [place(domains, env, rng) for _ in range(300)] + [{**env, **n} for n in near]:
        if not all(inside(d, spot[n], env) for n, _, d in domains):
            continue
        here = value(body, spot)
        if here > best if kind == "maximum" else here < best:
            if not equal(here, best):
                return False
        if only and equal(here, best) and not all(equal(spot[n], v) for n, v in at.items()):
            return False
    return True


def inside(domain, v, env):
    kind = domain[0]
    if kind == "natural":
        low, high = value(domain[1], env), domain[2] and value(domain[2], env)
        return v == int(v) and v >= low and (high is None or v <= high)
    if kind == "range":
        _, opening, low, high, closing = domain
        left = low is None or compare(">=" if opening == "[" else ">", v, value(low, env))
        return left and (high is None or compare("<=" if closing == "]" else "<", v, value(high, env)))
    if kind == "integer":
        return v == int(v)
    return kind != "but" or v != value(domain[1], env)


def draw(domain, env, rng):
    """A value of a domain: small whole numbers and fractions, far ones, and the ends."""
    if domain[0] == "natural":
        low = int(value(domain[1], env))
        return mpf(rng.randint(low, int(value(domain[2], env)))) if domain[2] else mpf(low + rng.choice([0, 1, 2, 3, 4, 5, 9, 17]))
    if domain[0] == "integer":
        return mpf(rng.randint(-6, 6))
    low = high = None
    if domain[0] == "range":
        low, high = (None if e is None else value(e, env) for e in domain[2:4])
    for _ in range(100):
        if low is not None and high is not None:
            v = low + (high - low) * rng.choice([mpf(0), mpf(1), mpf(1) / 2, mpf(rng.random()), mpf(rng.random()), mpf(1) / 10**4])
        else:
            size = rng.choice([0, mpf(rng.randint(1, 5)), mpf(rng.randint(1, 9)) / rng.randint(1, 9), mpf(rng.random()) * 3, mpf(rng.randint(1, 60)), mpf(rng.random()) / 50])
            v = low + size if low is not None else high - size if high is not None else size * rng.choice([-1, 1])
        if inside(domain, v, env):
            return v
    raise Undefined


class Family:
    """Members drawn when asked for, given, or computed by a recurrence."""

    def __init__(self, domain, env, rng):
        self.domain, self.env, self.rng, self.members, self.step = domain, env, rng, {}, None

    def __call__(self, k):
        if k < 0:
            raise Undefined
        if k not in self.members:
            if self.step and k >= self.step[0]:
                shift, factor, right = self.step
                env = {**self.env, "k": mpf(k - shift)}
                self.members[k] = value(right, env) / value(factor, env)
            else:
                self.members[k] = draw(self.domain, self.env, self.rng)
        return self.members[k]


def place(domains, env, rng):
    env = dict(env)
    for name, family, domain in domains:
        env[name] = Family(domain, env, rng) if family else draw(domain, env, rng)
        if family:
            env[name].env = env
    return env


def member(e):
    """Name and index of a family's member, perhaps with a factor before it."""
    if e[0] == "*" and e[2][0] == "call":
        return e[2][1], e[2][2], e[1]
    return (e[1], e[2], ("number", mpf(1))) if e[0] == "call" else None


class Claim:
    def __init__(self, text):
        self.name = text.split()[1]
        self.refuted = re.search(r"^expect refuted", text, re.M) is not None
        self.by_hand = re.search(r"^# by hand: ", text, re.M) is not None
        self.points = [dict(part.split(" = ") for part in line.split(", ")) for line in re.findall(r"^# (?:holds|false) at (.*)", text, re.M)]
        body = re.sub(r"#.*", "", text)
        clauses = re.split(r"^(?=given|assume|let|define|prove|expect|claim|source|section|number|reading|note)", body, flags=re.M)
        read = lambda word: [" ".join(c.split()[1:]) for c in clauses if c.startswith(word)]
        self.domains = [d for g in read("given") for d in Parser(g + " :").bindings(":")]
        self.families = {name for name, family, _ in self.domains if family}
        self.names = {}
        for text in read("let"):
            name, right = text.split(" = ", 1)
            self.names[name] = self.replaced(Parser(right).sum())
        equations = []
        # Where equations define families, they hold nowhere where a member has no value; a `define` of one sequence from
        # u(k) to u(k + 1) is a definition, and the claim has to see to it that there are values.
        self.by_equations = any(re.search(r"^\S+,|\(k \+ [^1]", t) for t in read("define"))
        for text in read("define"):
            names, _, right = text.partition(" by ")
            for name in names.split(", "):
                self.domains += Parser(f"{name}(k) real :").bindings(":")
                self.families.add(name)
            each = re.split(r", (?=\w+\(\w[^=]*\) = )", right)
            equations += [("for all k natural: " if "(k + " in e.split(" = ")[0] else "") + e for e in each]
        assumed = [self.replaced(Parser(re.sub(r"^\w+: ", "", a)).statement()) for a in read("assume") + equations]
        self.written = list(zip((re.sub(r"^\w+: ", "", a) for a in read("assume")), assumed))
        assumed = [part for a in assumed for part in (a[1:] if a[0] == "and" else [a])]
        self.recurrences = [a for a in assumed if self.defines(a)]
        self.assumed = [a for a in assumed if a not in self.recurrences and a[0] != "all"]
        self.open = [a for a in assumed if a[0] == "all" and a not in self.recurrences]
        (goal,) = read("prove")
        # What follows `by` is an argument, of which only the witness of `exists` is of use here.
        goal, _, argument = goal.partition(" by ")
        self.goal = self.replaced(Parser(goal).statement())
        if self.goal[0] == "exists" and argument.startswith("witness "):
            for text in re.split(r", (?=\w+ = )", argument.removeprefix("witness ")):
                name, right = text.split(" = ", 1)
                self.names[name] = self.replaced(Parser(right).sum())
            self.goal = self.replaced(self.goal[2])

    def replaced(self, tree):
        """A tree with what its abbreviations stand for."""
        if isinstance(tree, tuple) and len(tree) == 2 and tree[0] == "name":
            return self.names.get(tree[1], tree)
        if isinstance(tree, (tuple, list)):
            return type(tree)(self.replaced(part) for part in tree)
        return {n: self.replaced(e) for n, e in tree.items()} if isinstance(tree, dict) else tree

    def without(self, text):
        """The claim without the hypothesis that a report prints so, or None if there is none such."""
        same = lambda a, b: a.replace(" ", "") == b.replace(" ", "")
        other = copy.copy(self)
        for written, tree in self.written:
            if same(written, re.sub(r"^\w+: ", "", text)):
                other.assumed = [a for a in self.assumed if a is not tree]
                return other if len(other.assumed) < len(self.assumed) else None
        match = re.fullmatch(r"(\w+)(?:\(\w\))? (>=|>|<=|<) \S+", text)
        if not match:
            return None
        other.domains = [(n, f, relaxed(d, match[2])) if n == match[1] else (n, f, d) for n, f, d in self.domains]
        return other if other.domains != self.domains else None

    def counterexample(self, tries=1500):
        """A point at which the hypotheses hold and the claim does not, or None."""
        return self.sample(tries, lambda env, rng: not self.holds(env, rng))

    def sample(self, tries, wanted=lambda env, rng: True):
        """A point at which the hypotheses hold, and what is wanted, or None."""
        rng = random.Random(self.name)
        for _ in range(tries):
            try:
                env = self.start(rng, {})
                env = self.solved(env, rng) if rng.random() < 0.7 else env
                if self.allowed(env, rng) and wanted(env, rng):
                    return ", ".join(f"{n} = {mpmath.nstr(v, 12)}" for n, v in env.items() if not callable(v)) or "every point"
            except (Undefined, ValueError, ZeroDivisionError, OverflowError, TypeError):
                continue
        return None

    def defines(self, a):
        """Whether a hypothesis gives members of a family: `u(0) = ...` or `for all k natural: u(k + 1) = ...`."""
        inner = a[2] if a[0] == "all" else a
        if inner[0] != "compare" or inner[2] != "=" or not (found := member(inner[1])) or found[0] not in self.families:
            return False
        return found[1][0] in (("+",) if a[0] == "all" else ("number",))

    def start(self, rng, given):
        env = {}
        for name, family, domain in self.domains:
            if name in given:
                env[name] = value(Parser(given[name]).sum(), {})
                if not inside(domain, env[name], env):
                    raise AssertionError(f"{name} = {given[name]} is outside its domain")
            else:
                env[name] = Family(domain, env, rng) if family else draw(domain, env, rng)
        for name, text in given.items():
            # Carom also names entries of powers of matrices; here they follow from the matrix.
            if "(" in name and name.split("(")[0] in env:
                env[name.split("(")[0]].members[int(name.split("(")[1][:-1])] = value(Parser(text).sum(), {})
        for a in self.recurrences:
            left, right = (a[2] if a[0] == "all" else a)[1::2]
            name, index, factor = member(left)
            if a[0] == "all":
                env[name].step = int(index[2][1]), factor, right
            else:
                found = value(right, env)
                if not equal(env[name].members.setdefault(int(index[1]), found), found):
                    raise Undefined  # Two hypotheses give the member different values.
        return env

    def solved(self, env, rng):
        """The point with its equations solved for variables picked at random."""
        equations = [a for a in self.assumed if a[0] == "compare" and a[2] == "=" and len(a) == 4]
        free = [name for name, family, domain in self.domains if not family and domain[0] != "natural"]
        if not equations or len(free) < len(equations):
            return env
        chosen = rng.sample(free, len(equations))
        gaps = lambda *vs: [value(("-", a[1], a[3]), {**env, **dict(zip(chosen, vs))}) for a in equations]
        found = [env[c] for c in chosen]
        for _ in range(60):
            here, step = gaps(*found), mpf(10) ** -100
            if max(map(abs, here)) < SOLVED**1.2:
                break
            moved = [gaps(*found[:i], found[i] + step, *found[i + 1:]) for i in range(len(found))]
            slopes = mpmath.matrix([[(m[j] - here[j]) / step for m in moved] for j in range(len(here))])
            found = list(mpmath.matrix(found) - mpmath.lu_solve(slopes, mpmath.matrix(here)))
        return {**env, **dict(zip(chosen, found))}

    def allowed(self, env, rng):
        global tolerance
        tolerance = SOLVED
        try:
            if self.by_equations:
                for name in self.families:
                    [env[name](k) for k in range(6)]
            domains = all(family or inside(domain, env[name], env) for name, family, domain in self.domains)
            return domains and all(truth(a, env, rng) for a in self.assumed)
        finally:
            tolerance = CLOSE

    def check(self):
        """What is wrong, or nothing, and the number of points."""
        rng, tried, failed = random.Random(self.name), 0, 0
        for given in self.points:
            env = self.start(rng, given)
            if not self.allowed(env, rng):
                return f"the hypotheses do not hold at {given}", 0
            if self.holds(env, rng) == self.refuted:
                return f"is {'true' if self.refuted else 'false'} at {given}", 0
            tried += 1
        if self.refuted and self.points:
            return None, tried
        if self.open:
            return None if self.by_hand else "a hypothesis for all members is no recurrence; say `# by hand: ...`", tried
        wanted = (POINTS if self.goal[0] != "limit" else 8) if self.domains else 1
        for _ in range(wanted * 15):
            if tried >= wanted:
                break
            try:
                env = self.start(rng, {})
                env = self.solved(env, rng)
                if not self.allowed(env, rng):
                    continue
            except (Undefined, ValueError, ZeroDivisionError, OverflowError, TypeError):
                continue
            tried += 1
            if not self.holds(env, rng):
                if self.refuted:
                    return None, tried
                return "is false at " + ", ".join(f"{n} = {mpmath.nstr(v, 12)}" for n, v in env.items() if not callable(v)), tried
        if self.refuted:
            return None if self.by_hand else "holds at every point tried", tried
        few = tried < min(wanted, 5) and not self.by_hand
        return (f"only {tried} points were found" if few else None), tried

    def holds(self, env, rng):
        try:
            return truth(self.goal, env, rng)
        except Undefined:
            return False


def relaxed(domain, sign):
    """A domain without its lower or its upper bound."""
    if domain[0] == "natural" and domain[2] is None:
        return "natural", ("number", mpf(0)), None
    if domain[0] != "range":
        return domain
    _, opening, low, high, closing = domain
    if ">" in sign:
        return ("range", "", None, high, closing) if high is not None else ("real",)
    return ("range", opening, low, None, "") if low is not None else ("real",)


def unneeded(report, paths):
    """Prints what a report calls not needed, and is: without it the claim fails at a point."""
    known = {claim.name: claim for path in paths for claim in claims(path)}
    checked = wrong = 0
    for entry in json.loads(pathlib.Path(report).read_text())["claims"]:
        for text in entry["unused"] if entry["id"] in known else []:
            other = known[entry["id"]].without(text)
            found = other and other.counterexample()
            checked += other is not None
            if found:
                wrong += 1
                print(f"{entry['id']}: without {text} it fails at {found}")
    print(f"{checked} hypotheses said not to be needed, {wrong} wrongly")
    return wrong


def claims(path):
    for text in re.split(r"^(?=claim )", path.read_text(), flags=re.M)[1:]:
        yield Claim(text)


def main():
    folder = pathlib.Path(__file__).parent
    report = sys.argv[2] if sys.argv[1:2] == ["--unneeded"] else None
    paths = [pathlib.Path(p) for p in sys.argv[3 if report else 1 :]] or sorted(folder.glob("*.claim"))
    if report:
        sys.exit(1 if unneeded(report, paths) else 0)
    wrong = count = points = hand = 0
    for path in paths:
        for claim in claims(path):
            fault, tried = claim.check()
            count, points, hand = count + 1, points + tried, hand + claim.by_hand
            if fault:
                wrong += 1
                print(f"{path.name}: {claim.name}: {fault}")
    print(f"{count} claims, {points} points, {hand} by hand, {wrong} wrong")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
