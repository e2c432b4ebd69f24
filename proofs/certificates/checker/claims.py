"""Expressions, propositions and statements as trees: sections 2, 3 and 4 of docs/certificates.md."""
import re


class Refused(Exception):
    """Why a text is malformed or a step is not taken."""


class NotCovered(Exception):
    """What this checker cannot read or has no room for: neither accepted nor rejected."""


def need(holds, why):
    if not holds:
        raise Refused(why)


def room(holds, why):
    if not holds:
        raise NotCovered(why)


class Node(tuple):
    """(tag, parts...): an expression, a proposition or a binding. Tuples in it are lists."""


EXPRESSIONS = {"num", "name", "call", "neg", "sum", "prod", "pow", "over", "integral", "deriv", "matrix"}
# (tag, word, name, from, to, body): the name is bound in the body, as a natural number in a sum or product over an index, and as
# a real number in an integral.
BINDERS = ("over", "integral")


def nodes(x):
    """The nodes directly below x."""
    for y in x:
        if isinstance(y, Node):
            yield y
        elif isinstance(y, tuple):
            yield from nodes(y)


def N(tag, *parts):
    x = Node((tag,) + parts)
    arithmetic = tag in EXPRESSIONS or tag in ("cmp", "bind", "limit", "approach")
    for y in nodes(x):
        if y[0] != "bind" and tag != "extremum":
            need((y[0] in EXPRESSIONS) == arithmetic, "a statement where a number is needed, or a number for one")
    return x


def num(k):
    return N("num", str(k))


def plus(a, b, sign=1):
    return N("sum", ((1, a), (sign, b)))


def compare(a, relation, b):
    return N("cmp", (a, b), (relation,))


def to_the_ends(x):
    """1 − x and 1 + x: neither is negative where arcsin(x) and arccos(x) have values."""
    return plus(num(1), x, -1), plus(num(1), x)


def names_in(x, out=None):
    """Every name in a tree but those that are bound in it."""
    out = set() if out is None else out
    if x[0] in ("name", "call"):
        out.add(x[1])
    if x[0] == "deriv":
        out.update(x[2])
    if x[0] == "limit":
        out.add(x[2])
    inner = set()
    for y in nodes(x):
        names_in(y, inner)
    bound = {x[2]} if x[0] in BINDERS else {n for b in bindings_of(x) for n, _ in b[1]}
    if x[0] in BINDERS:
        names_in(x[3], out), names_in(x[4], out)
    out |= inner - bound
    return out


def mentioned(x):
    """Every name in a tree."""
    own = {x[1]} if x[0] in ("name", "call") else set(x[2]) if x[0] == "deriv" else {x[2]} if x[0] == "limit" else set()
    return own.union(*map(mentioned, nodes(x)))


def bindings_of(x):
    return {"all": x[1:2], "exists": x[1:2], "extremum": x[4:5]}.get(x[0], ((),))[0]


def moves(m, v):
    """Nothing may be put in for a variable that moves in a derivative or limit, nor may what is put in depend on it. A definition
    may: it is only written out."""
    for key, value in m.items():
        if value[0] == "define":
            need(key != v, f"{v}, which moves, is no variable")
        elif not (value[0] == "name" and value[1].startswith("#")):
            members = any(y[0] == "call" and y[1] not in FUNCTIONS for y in subtrees(value))
            moved = key == v or v in names_in(value) or members
            need(not moved, f"a value is put in that {v}, which moves, may change")


def subtrees(x):
    yield x
    for y in nodes(x):
        yield from subtrees(y)


def of_arguments(x, m):
    """The variables of a derivative in a definition whose parameters get these arguments; None if an argument for one of
    them is no variable, or stands elsewhere in the derivative or in another argument."""
    out = []
    for v in x[2]:
        z = m.get(v, (None, None))
        elsewhere = mentioned(x[1]) - {v}
        elsewhere = elsewhere.union(*(mentioned(value) for key, value in m.items() if key != v))
        if z[0] != "name" or z[1] == PI or z[1] in elsewhere:
            return None
        out.append(z[1])
    return tuple(out)


def put(x, m, depth=0, arguments=False):
    """x with values put in for free names, all at once, and bound names by number: two propositions are the same if they
    are equal after put(x, {}). With depth None bound names are kept, and one that would capture a name is refused.
    Arguments of a definition are put in for its parameters."""
    go = lambda y: put(y, m, depth, arguments)
    tag = x[0]

    def under(names):
        if depth is not None:
            return {**m, **{v: N("name", f"#{depth + k}") for k, v in enumerate(names)}}, depth + len(names)
        inner = {key: value for key, value in m.items() if key not in names}
        for value in inner.values():
            free = names_in(value[2]) - set(value[1]) if value[0] == "define" else names_in(value)
            need(not free & set(names), "a bound name would capture a name that is put in")
        return inner, None

    new = lambda v, inner: inner[v][1] if depth is not None else v
    if tag == "name":
        value = m.get(x[1], x)
        return value if value[0] != "define" else value[2] if not value[1] else x
    if tag == "call":
        value, given = m.get(x[1]), tuple(map(go, x[2]))
        if value is None:
            return N("call", x[1], given)
        if value[0] == "define" and len(value[1]) == len(given):
            return put(value[2], dict(zip(value[1], given)), None, True)
        need(value[0] == "name", f"{x[1]} is not a function")
        return N("call", value[1], given)
    if tag in BINDERS:
        inner, below = under([x[2]])
        return N(tag, x[1], new(x[2], inner), go(x[3]), go(x[4]), put(x[5], inner, below, arguments))
    if tag == "deriv" and arguments and any(v in m for v in x[2]) and (by := of_arguments(x, m)):
        return N(tag, go(x[1]), by)
    if tag in ("deriv", "limit"):
        for v in x[2] if tag == "deriv" else [x[2]]:
            moves(m, v)
        rename = lambda v: m[v][1] if v in m and m[v][0] == "name" else v
        by = tuple(map(rename, x[2])) if tag == "deriv" else rename(x[2])
        return N(tag, go(x[1]), by, *map(go, x[3:]))
    if tag in ("all", "exists", "extremum"):
        inner, below = under([n for b in bindings_of(x) for n, _ in b[1]])
        bind = lambda b: N("bind", tuple((new(n, inner), i) for n, i in b[1]), b[2],
                           *(shaped(y, lambda z: put(z, inner, below)) for y in b[3:]))
        if tag != "extremum":
            return N(tag, tuple(map(bind, x[1])), put(x[2], inner, below))
        at = tuple((new(n, inner) if n in inner else n, go(e)) for n, e in x[5])
        return N(tag, x[1], x[2], put(x[3], inner, below), tuple(map(bind, x[4])), at, go(x[6]))
    return N(tag, *(shaped(y, go) for y in x[1:]))


def shaped(y, go):
    return go(y) if isinstance(y, Node) else tuple(shaped(z, go) for z in y) if isinstance(y, tuple) else y


def taken_with(names, taken, hides_pi=False):
    """The names that are taken where these begin, each of them for the first time. None of them hides π, unless the claim
    declares it."""
    for n in names:
        need(n not in taken and n not in FUNCTIONS and (hides_pi or n != PI), f"the name {n} is in use")
        taken = taken | {n}
    return taken


def declared_with(bindings, taken, indices, hides_pi=False):
    """The names that are taken behind bindings. A bound of a family may mention its index."""
    for b in bindings:
        for i in {i for _, i in b[1]}:
            inner = taken_with([i] if i is not None and indices else [], taken)
            for y in nodes(b):
                bound_once(y, inner, indices)
        taken = taken_with([n for n, _ in b[1]], taken, hides_pi)
    return taken


def bound_once(x, taken, indices=True):
    """Whether each name that x binds is new where it begins; those of sums, products and integrals are looked at on demand."""
    inner = taken
    need(x[0] not in BINDERS or x[2] != PI, f"the name {PI} is in use")
    if x[0] in BINDERS and indices:
        inner = taken_with([x[2]], taken)
    elif bindings_of(x):
        inner = declared_with(bindings_of(x), taken, indices)
    outside = x[3:5] if x[0] in BINDERS else [*(e for _, e in x[5]), x[6]] if x[0] == "extremum" else ()
    for y in nodes(x):
        if y[0] != "bind":
            bound_once(y, taken if any(y is z for z in outside) else inner, indices)


def constraints(binding, value):
    """What a binding says of a value."""
    for c in binding[3]:
        if c[0] == "relation":
            yield compare(value, c[1], c[2])
        else:
            yield compare(value, ">=" if c[1] else ">", c[2])
            yield compare(value, "<=" if c[4] else "<", c[3])


def domain(bindings):
    return [p for b in bindings for n, index in b[1] if index is None for p in constraints(b, N("name", n))]


# ---------------------------------------------------------------------------------------------------- reading text
GREEK = dict(zip("αβγδεζηθικλμνξπρστυφχψωΓΔΘΛΞΦΨΩ", """alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu
    nu xi pi rho sigma tau upsilon phi chi psi omega Gamma Delta Theta Lambda Xi Phi Psi Omega""".split()))
OTHER = {"≤": "<=", "≥": ">=", "≠": "!=", "⇒": "=>", "⇔": "<=>", "·": "*", "×": "*", "−": "-", "→": "->",
         "∧": " and ", "∨": " or ", "¬": " not ", "∞": " infinity ", "∈": " in ", "…": ".."}
LOWERED, RAISED = (str.maketrans(signs, "0123456789") for signs in ("₀₁₂₃₄₅₆₇₈₉", "⁰¹²³⁴⁵⁶⁷⁸⁹"))
TOKEN = re.compile(r'''(?a:(?P<skip>[ \t\r\ufeff]+|\#[^\n]*|\n)|(?P<number>\d+(\.\d+)?([eE][+-]?\d+)?)
    |(?P<word>[A-Za-z][A-Za-z0-9₀-₉]*(_[A-Za-z0-9₀-₉]+)*'*(?![\w'₀-₉]))|(?P<text>"[^"\n]*")|(?P<raised>⁻?[⁰¹²³⁴-⁹]+)
    |(?P<sign><=>|<=|>=|!=|=>|->|\.\.|[-+*/^()\[\]{},;:=<>√|!]))''', re.X)
MIXED = re.compile("[0-9][₀-₉]|[₀-₉][0-9]")
DASHED = re.compile(r"(?a:(?P<word>[A-Za-z]([\w₀-₉]|-(?=[\w₀-₉]))*'*))")
PRINTED = re.compile(r"(?a:(?P<text>\w[-\w.'′*]*))")
CLAUSES = set("claim source section number reading note using given let define assume prove expect".split())
RESERVED = CLAUSES | set("""and or not exists for all each in is at over of as by with maximum minimum limit infinity have
    obtain case real natural sum product integral derivative only conclude""".split())
FUNCTIONS = set("det transpose sqrt cbrt exp ln cos sin arcsin arccos arctan cosh sinh sech tanh".split())
# The number π, wherever the claim declares nothing of this name.
PI = "pi"
RELATIONS = ("=", "!=", "<", "<=", ">", ">=")
# Words that begin a clause. Those that are not in CLAUSES may also be names.
BEGINNINGS = CLAUSES | {"paper", "text", "sample"}


class Parser:
    """Reads the language of the kernel. For an author's language, see author.py."""

    from_author = False

    def __init__(self, source):
        for printed, word in (("Σ(", "sum("), ("Π(", "product("), ("∫(", "integral(")):
            source = source.replace(printed, word)
        source = source.translate(str.maketrans({**GREEK, **OTHER}))
        self.tokens, self.at_token, at, first, in_list = [], 0, 0, True, False
        while at < len(source):
            # The names of claims, behind `claim` and `by` and in the list behind `using`, may hold dashes.
            last = self.tokens[-1][1] if self.tokens else ""
            in_list = last == "using" or (in_list and last not in CLAUSES and self.tokens[-1][0] in ("word", "sign"))
            dashed = last in ("claim", "by") or (in_list and last in ("using", ","))
            numbered = last == "number" and self.tokens[-1][2]
            found = (dashed and DASHED.match(source, at)) or (numbered and PRINTED.match(source, at)) or \
                TOKEN.match(source, at)
            if not found:
                self.tokens.append(("fault", source[at], first))
                at += 1
                continue
            at = found.end()
            text, kind = found.group(), found.lastgroup
            if kind == "skip":
                first = first or "\n" in text
                continue
            if kind == "number":
                digits, _, exponent = text.lower().partition("e")
                short = len(digits) <= 10_000 and len(exponent) <= 6 and abs(int(exponent or 0)) <= 10_000
                kind = kind if short else "fault"
            if kind == "word":
                # In print x₁2 could be x₁ times 2, or one name.
                kind, text = "fault" if MIXED.search(text) else kind, text.translate(LOWERED)
            self.tokens.append((kind, text, first))
            first = False
        self.tokens.append(("end", "", True))

    def at(self, *texts):
        return self.tokens[self.at_token][1] in texts

    def at_clause(self):
        kind, text, first = self.tokens[self.at_token]
        return kind == "end" or (first and text in BEGINNINGS)

    def take(self, *texts):
        if self.at(*texts):
            self.at_token += 1
            return self.tokens[self.at_token - 1][1]

    def want(self, text):
        need(self.at(text), f"expected `{text}`, found `{self.tokens[self.at_token][1]}`")
        return self.take(text)

    def kind(self, kind):
        found = self.tokens[self.at_token]
        need(found[0] == kind, f"expected a {kind}, found `{found[1]}`")
        self.at_token += 1
        return found[1]

    def name(self):
        need(self.tokens[self.at_token][1] not in RESERVED, "a word of the language is no name")
        return self.kind("word")

    def read(self, pattern):
        """Reads by a pattern: E is an expression, N a name, B bindings, A assignments; anything else is itself."""
        readers = {"E": self.expr, "N": self.name, "B": self.bindings, "A": self.assignments}
        return [readers[part]() if part in readers else self.want(part) for part in pattern.split()]

    def many(self, read, *signs):
        """Parts with signs between them: [(sign before the part, part)]."""
        parts = [(None, read())]
        while sign := self.take(*signs):
            parts.append((sign, read()))
        return parts

    def whole(self, read):
        x = read()
        need(self.tokens[self.at_token][0] == "end", f"unexpected `{self.tokens[self.at_token][1]}`")
        return x

    # Expressions. A parenthesis may hold a statement: N refuses it where a number is needed.
    def expr(self):
        e = self.sum()
        need(e[0] in EXPRESSIONS, "a number is needed")
        return e

    def sum(self):
        terms = [(1, self.signed())]
        while sign := self.take("+", "-"):
            terms.append((1 if sign == "+" else -1, self.product()))
        return terms[0][1] if len(terms) == 1 else N("sum", tuple(terms))

    def signed(self):
        return N("neg", self.signed()) if self.take("-") else self.product()

    def product(self):
        factors = [("*", self.power())]
        while operator := self.take("*", "/"):
            factors.append((operator, self.signed_power()))
        return factors[0][1] if len(factors) == 1 else N("prod", tuple(factors))

    def signed_power(self):
        return N("neg", self.signed_power()) if self.take("-") else self.power()

    def base(self):
        return self.atom()

    def power(self):
        base = self.base()
        if self.tokens[self.at_token][0] == "raised":
            # x² is x^2; x²^3 would be read in two ways.
            _, minus, digits = self.kind("raised").translate(RAISED).rpartition("⁻")
            room(len(digits) <= 10_000, "a numeral too long for this checker")
            self.need_no_power()
            return N("pow", base, N("neg", N("num", digits)) if minus else N("num", digits))
        return N("pow", base, self.signed_power()) if self.take("^") else base

    def need_no_power(self):
        need(not self.at("^") and self.tokens[self.at_token][0] != "raised", "a power that is read in two ways")

    def atom(self):
        if self.tokens[self.at_token][0] == "number":
            return N("num", self.kind("number"))
        if self.take("("):
            inner = self.prop()
            self.want(")")
            return inner
        if self.take("√"):
            x = N("call", "sqrt", (self.atom(),))
            self.need_no_power()
            return x
        if self.take("["):
            rows = []
            for sign, entry in self.many(self.expr, ",", ";"):
                rows[-1].append(entry) if sign == "," else rows.append([entry])
            self.want("]")
            need(len(set(map(len, rows))) == 1, "the rows of a matrix differ in length")
            return N("matrix", tuple(map(tuple, rows)))
        if word := self.take("sum", "product", "integral"):
            _, v, _, low, _ = self.read("( N = E ..")
            high = self.last()
            _, body, _ = self.read(", E )")
            return N("integral" if word == "integral" else "over", word, v, low, high, body)
        if self.take("derivative"):
            _, body, _, first = self.read("( E , N")
            by = [first] + [self.name() for _ in iter(lambda: self.take(","), None)]
            self.want(")")
            return N("deriv", body, tuple(by))
        name = self.name()
        if not self.take("("):
            return N("name", name)
        arguments = [e for _, e in self.many(self.expr, ",")]
        self.want(")")
        return N("call", name, tuple(arguments))

    def last(self):
        """The last value of an index."""
        return self.expr()

    # Propositions.
    def prop(self):
        return self.chain("iff", "<=>", self.implication)

    def proposition(self):
        p = self.prop()
        need(p[0] not in EXPRESSIONS, "a comparison is needed")
        return p

    def chain(self, tag, sign, part):
        parts = [p for _, p in self.many(part, sign)]
        return parts[0] if len(parts) == 1 else N(tag, tuple(parts))

    def implication(self):
        left = self.chain("or", "or", lambda: self.chain("and", "and", self.negation))
        return N("imp", left, self.implication()) if self.take("=>") else left

    def negation(self):
        if self.take("not"):
            return N("not", self.negation())
        if word := self.take("exists", "for"):
            need(word == "exists" or self.take("all", "each"), "expected `all`")
            bindings, _ = self.read("B :")
            return N("exists" if word == "exists" else "all", bindings, self.proposition())
        if word := self.take("maximum", "minimum"):
            return self.extremum(word)
        if self.take("limit"):
            return self.limit()
        sides = self.many(self.sum, *RELATIONS)
        relations = tuple(r for r, _ in sides[1:])
        return N("cmp", tuple(e for _, e in sides), relations) if relations else sides[0][1]

    def extremum(self, word):
        _, of, _, over = self.read("of E over B")
        only = bool(self.take("only"))
        _, at, _, value = self.read("at A is E")
        return N("extremum", word, only, of, over, at, value)

    def limit(self):
        _, of, _, v, _, _, _, value = self.read("of E as N -> infinity is E")
        return N("limit", of, v, value)

    def assignments(self):
        return tuple((n, e) for _, (n, _, e) in self.many(lambda: self.read("N = E"), ","))

    def bindings(self):
        out = []
        while True:
            out.append(self.binding())
            if not self.take(";", ",") or self.at_clause():
                return tuple(out)

    def binding(self):
        names, natural, limits, indices, any_domain = [], False, [], None, False
        while not names or self.take(","):
            name, index = self.name(), None
            if self.take("("):
                index = self.name()
                self.want(")")
            names.append((name, index))
        while True:
            joined = any_domain and self.take("and")
            if self.take("real"):
                pass
            elif self.take("natural"):
                natural = True
            elif self.from_author and self.take("integer"):
                self.integer = True
            elif relation := self.take(*RELATIONS):
                alone = joined or not limits or limits[-1][0] != "relation"
                need(alone or not self.from_author, "two conditions need `and` between them")
                limits.append(("relation", relation, self.expr()))
            elif self.take("in"):
                limits.append(self.interval())
                natural = natural or limits[-1][0] == "range"
            else:
                break
            any_domain = True
        need(any_domain, "expected a domain such as `real`, `natural` or `> 0`")
        if self.take("for"):
            index, _, low, _, high = self.read("N in E .. E")
            need(index in {i for _, i in names}, "not the index of this family")
            indices = (low, high)
        return N("bind", tuple(names), natural, tuple(limits), indices)

    def interval(self):
        start = self.at_token
        if opening := self.take("[", "("):
            try:
                low = self.expr()
                self.want(",")
                high = self.expr()
                need(self.at("]", ")"), "expected `]` or `)` to close the interval")
                return ("interval", opening == "[", low, high, self.take("]", ")") == "]")
            except Refused:
                self.at_token = start
        low, _, high = self.read("E .. E")
        return ("range", True, low, high, True)


# ------------------------------------------------------------------------------------------------------- statements
def need_new_names(items, goal):
    """A claim declares and binds each name once where it has a meaning."""
    taken = frozenset()
    for word, *parts in items:
        if word == "given":
            taken = declared_with(parts[0], taken, True, hides_pi=True)
        elif word == "let":
            name, parameters, value = parts
            bound_once(value, taken_with(parameters, taken))
            taken = taken_with([name], taken, hides_pi=True)
        elif word == "define":
            name, initial, index, step = parts
            bound_once(initial, taken)
            taken = taken_with([name], taken, hides_pi=True)
            bound_once(step, taken_with([index], taken))
        else:
            bound_once(parts[-1], taken)
    bound_once(goal, taken)


class Claim:
    """A statement: definitions by `let` are put in place. A quantifier may bind again what is in `again`."""

    def __init__(self, name, using, items, goal):
        self.name, self.using, self.given, self.sequences, self.assumptions = name, using, [], [], []
        lets, self.again = {}, set()
        for item in items:
            if item[0] == "given":
                for b in item[1]:
                    without = {k: v for k, v in lets.items() if k not in [i for _, i in b[1]]}
                    bounds = (shaped(y, lambda e: put(e, without, None)) for y in b[3:])
                    self.given.append(N("bind", b[1], b[2], *bounds))
            elif item[0] == "let":
                outside = {k: v for k, v in lets.items() if k not in item[2]}
                lets[item[1]] = Node(("define", item[2], put(item[3], outside, None)))
            elif item[0] == "define":
                step = put(item[4], {k: v for k, v in lets.items() if k != item[3]}, None)
                self.sequences.append((item[1], put(item[2], lets, None), item[3], step))
            else:
                self.assumptions.append(put(item[2], lets, None))
        self.goal = put(goal, lets, None)

    def text(self):
        out = [f"claim {self.name}"] + [f"given {text(b)}" for b in self.given]
        for u, initial, k, step in self.sequences:
            out.append(f"define {u} by {u}(0) = {text(initial)}, {u}({k} + 1) = {text(step)}")
        return "\n".join(out + [f"assume {text(p)}" for p in self.assumptions] + [f"prove {text(self.goal)}"]) + "\n"


def text(x):
    """The text of a tree, every compound part in parentheses: what the digest is taken of."""
    tag = x[0]
    each = lambda between, list_: between.join(map(text, list_))
    signed = lambda parts, signs: text(parts[0][1]) + "".join(signs[s] + text(e) for s, e in parts[1:])
    if tag in ("num", "name"):
        return x[1]
    if tag == "call":
        return f"{x[1]}({each(', ', x[2])})"
    if tag in BINDERS:
        return f"{x[1]}({x[2]} = {text(x[3])}..{text(x[4])}, {text(x[5])})"
    if tag == "deriv":
        return f"derivative({text(x[1])}, {', '.join(x[2])})"
    if tag == "matrix":
        return "[" + "; ".join(each(", ", row) for row in x[1]) + "]"
    if tag == "bind":
        out = ", ".join(n if i is None else f"{n}({i})" for n, i in x[1]) + (" natural" if x[2] else " real")
        for c in x[3]:
            if c[0] == "relation":
                out += f" {c[1]} {text(c[2])}"
            elif c[0] == "range":
                out += f" in {text(c[2])}..{text(c[3])}"
            else:
                out += f" in {'[' if c[1] else '('}{text(c[2])}, {text(c[3])}{']' if c[4] else ')'}"
        return out + (f" for indices in {text(x[4][0])}..{text(x[4][1])}" if x[4] else "")
    return "(" + {
        "neg": lambda: "-" + text(x[1]),
        "sum": lambda: signed(x[1], {1: " + ", -1: " - "}),
        "prod": lambda: signed(x[1], {"*": "*", "/": "/"}),
        "pow": lambda: text(x[1]) + "^" + text(x[2]),
        "cmp": lambda: text(x[1][0]) + "".join(f" {r} {text(e)}" for r, e in zip(x[2], x[1][1:])),
        "and": lambda: each(" and ", x[1]), "or": lambda: each(" or ", x[1]), "iff": lambda: each(" <=> ", x[1]),
        "not": lambda: "not " + text(x[1]),
        "imp": lambda: text(x[1]) + " => " + text(x[2]),
        "exists": lambda: f"exists {each('; ', x[1])}: {text(x[2])}",
        "all": lambda: f"for all {each('; ', x[1])}: {text(x[2])}",
        "extremum": lambda: f"{x[1]} of {text(x[3])} over {each('; ', x[4])} {'only ' if x[2] else ''}at "
                            + ", ".join(f"{n} = {text(e)}" for n, e in x[5]) + f" is {text(x[6])}",
        "limit": lambda: f"limit of {text(x[1])} as {x[2]} -> infinity is {text(x[3])}",
    }[tag]() + ")"


def same(p, q):
    return put(p, {}) == put(q, {})


def single(p):
    need(p[0] == "cmp" and len(p[2]) == 1, "a single comparison is needed, not a chain")
    return p[1][0], p[2][0], p[1][1]


def conjuncts(p):
    return [q for part in p[1] for q in conjuncts(part)] if p[0] == "and" else [p]


def as_power(e):
    if e[0] == "pow":
        return e[1], e[2]
    if e[0] == "call" and e[1] in ("sqrt", "cbrt"):
        return e[2][0], N("prod", (("*", num(1)), ("/", num(2 if e[1] == "sqrt" else 3))))
