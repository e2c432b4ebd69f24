#!/usr/bin/env python3
"""Lets `carom audit` judge random claims, and judges its verdicts by evaluating the claims at many points.

    cargo build --release --locked
    python3 benches/claim_oracle.py [--kind all] [--claims 1000] [--seed 1] [--carom PATH]

The kinds: `scalars` (comparisons, equivalences and the like with hypotheses, roots, powers, exp, ln), `sums` (families
with ranges, sums and products over their members), `sequences` (defined by recurrence, by induction), `limits`,
`signs` (polynomials of one variable with roots at the ends of its domain), `extrema`; `--claims` counts for each.

Values are fractions as long as they are rational, and beyond that enclosures that are widened by more than the
rounding, so that a comparison is either certain or left out; limits are looked at at n = 10^6 and 10^9, extrema on a
grid, which can deny that a point is the best, not confirm it. Wrong is: a claim that is proved and fails, or has no
value, at a point where its hypotheses hold; a claim that is refuted and holds at the witness, or whose hypotheses do
not hold there (or at no point, where no witness is printed); hypotheses that are said to contradict each other and hold
at a point; an audit that gives no verdict; a proved claim that, without the hypotheses which the audit calls not needed,
is refuted or fails at a point. Each wrong claim is printed. Exit code 0 if there is none, 1 if there is
one, 2 for bad usage. The same seed writes the same claims.

The standard library of Python 3.10 suffices, except for limits: those need mpmath (`pip install mpmath`).
"""
import argparse
import ast
import itertools
import json
import math
import operator
import random
import subprocess
import sys
import tempfile
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import partial
from typing import Callable

POINTS = 300
BATCH = 200
BITS = 20_000
GRID = [Fraction(v) for v in "0 1/4 1/2 1 3/2 2 3 4 -1/2 -1 -2 -3".split()]
RELATIONS = {"=": operator.eq, "!=": operator.ne, "<": operator.lt, "<=": operator.le, ">": operator.gt}
RELATIONS[">="] = operator.ge
SIGNS = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.Pow: "^"}
INDICES = ("i", "j", "k", "m", "n")


class NoValue(Exception):
    """The expression certainly has no value at this point."""


class Unclear(Exception):
    """The enclosures do not decide the question at this point."""


def tree(text, **put):
    """The expression that a text such as `t*(c - t)` stands for, with other expressions put for names."""

    def walk(node):
        match node:
            case ast.BinOp(left=left, op=op, right=right):
                return SIGNS[type(op)], walk(left), walk(right)
            case ast.UnaryOp(operand=inner):
                return "neg", walk(inner)
            case ast.Call(func=ast.Name(id=name), args=[inner]):
                return name, walk(inner)
            case ast.Name(id=name):
                return put.get(name, name)
        return node.value

    return walk(ast.parse(text.replace("^", "**"), mode="eval").body)


def show(e):
    """An expression or a statement as a claim file has it."""
    if not isinstance(e, tuple):
        return f"({e})" if isinstance(e, Fraction) and e.denominator != 1 else str(e)
    op, *parts = e
    if op in ("sum", "product"):
        index, first, last, body = map(show, parts)
        return f"{op}({index} = {first}..{last}, {body})"
    if op == "of":
        return f"{parts[0]}({show(parts[1])})"
    if op in RELATIONS:
        return f"{show(parts[0])} {op} {show(parts[1])}"
    if op in ("neg", "not"):
        return f"(-{show(parts[0])})" if op == "neg" else f"not ({show(parts[0])})"
    if len(parts) == 1:
        return f"{op}({show(parts[0])})"
    if op in ("and", "or", "=>", "<=>"):
        return f" {op} ".join(f"({show(part)})" for part in parts)
    return f"({show(parts[0])}){op}({show(parts[1])})" if op == "^" else f"({show(parts[0])} {op} {show(parts[1])})"


def point(v):
    """The bounds of a rational number."""
    return Fraction(v), Fraction(v)


def exact(v):
    """Whether bounds are the value itself."""
    return isinstance(v[0], Fraction)


def whole(e):
    """Whether an exponent is a whole number by the way it is written."""
    if isinstance(e, tuple):
        return e[0] in ("+", "*") and all(map(whole, e[1:]))
    return isinstance(e, int) or e in INDICES


def root(v, k):
    """The k-th root of a positive fraction, if it is a fraction."""
    parts = [round(part ** (1 / k)) for part in (v.numerator, v.denominator)]
    return Fraction(*parts) if [part**k for part in parts] == [v.numerator, v.denominator] else None


class Evaluator:
    """Values as pairs of bounds: twice the same fraction, or numbers of `functions` rounded outward."""

    def __init__(self, functions, number, relative, least):
        self.functions, self.number, self.relative, self.least = functions, number, relative, least

    def widened(self, low, high):
        """Bounds that hold the value although they were rounded."""
        low, high = self.number(low), self.number(high)
        low, high = low - abs(low) * self.relative - self.least, high + abs(high) * self.relative + self.least
        if low - low != 0 or high - high != 0:
            raise Unclear
        return low, high

    def value(self, e, env):
        """The bounds of an expression at a point; raises NoValue where it certainly has none."""
        if isinstance(e, str):
            return env[e]
        if not isinstance(e, tuple):
            return point(e)
        op, *parts = e
        if op in ("sum", "product"):
            return self.fold(*e, env)
        if op == "of":
            return env[parts[0]][int(self.value(parts[1], env)[0])]
        values = [self.value(part, env) for part in parts]
        if op == "^":
            if whole(parts[1]):
                return self.whole_power(values[0], int(values[1][0]))
            return self.power(*values, isinstance(parts[1], Fraction))
        if op in ("sqrt", "cbrt"):
            return self.power(values[0], point(Fraction(1, 2 if op == "sqrt" else 3)), True)
        return self.function(op, values[0]) if op in ("exp", "ln") else self.combine(op, *values)

    def combine(self, op, a, b=None):
        """The four operations, and the opposite."""
        if op == "neg":
            return -a[1], -a[0]
        if op == "/" and b[0] <= 0 <= b[1]:
            raise NoValue if exact(b) else Unclear
        if exact(a) and exact(b):
            apply = {"+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv}[op]
            return point(apply(a[0], b[0]))
        a, b = self.widened(*a), self.widened(*b)
        if op in "+-":
            return self.widened(*((a[0] + b[0], a[1] + b[1]) if op == "+" else (a[0] - b[1], a[1] - b[0])))
        if op == "/" and b[0] <= 0 <= b[1]:
            raise Unclear
        ends = [u * v if op == "*" else u / v for u in a for v in b]
        return self.widened(min(ends), max(ends))

    def fold(self, op, index, first, last, body, env):
        """A sum or product; a range that ends before its beginning by more than one has none."""
        first, last = (int(self.value(end, env)[0]) for end in (first, last))
        if first < 0 or last < first - 1:
            raise NoValue
        total = point(op == "product")
        for k in range(first, last + 1):
            total = self.combine("*" if op == "product" else "+", total, self.value(body, {**env, index: point(k)}))
        return total

    def function(self, name, v):
        """exp and ln, exact at 0 and 1."""
        argument, result = {"exp": (0, 1), "ln": (1, 0)}[name]
        if exact(v) and v[0] == argument:
            return point(result)
        if name == "ln" and v[0] <= 0:
            raise NoValue if exact(v) or v[1] < 0 else Unclear
        if abs(v[0]) > 10**40 or abs(v[1]) > 10**40:
            raise Unclear
        apply = getattr(self.functions, "log" if name == "ln" else name)
        low, high = self.widened(*v)
        if name == "ln" and low <= 0:
            raise Unclear
        return self.widened(apply(low), apply(high))

    def whole_power(self, b, n):
        """A power with a whole exponent; anything to the power 0 is 1."""
        if n < 0:
            return self.combine("/", point(1), self.whole_power(b, -n))
        if exact(b) and n * (b[0].numerator.bit_length() + b[0].denominator.bit_length() - 2) <= BITS:
            return point(b[0] ** n)
        low, high = self.widened(*b)
        ends = [low**n, high**n] + [0] * (low < 0 < high)
        return self.widened(min(ends), max(ends))

    def power(self, b, q, fraction):
        """A power that is not whole by its exponent; of numbers up to 0 only those by a fraction are judged."""
        if b[0] <= 0:
            if fraction and (exact(b) or b[1] < 0):
                if b[0] == 0 < q[0]:
                    return point(0)
                raise NoValue
            raise Unclear
        if exact(b) and exact(q) and q[0].denominator < 10 and abs(q[0].numerator) < 10:
            if (r := root(b[0], q[0].denominator)) is not None:
                return point(r ** q[0].numerator)
        return self.function("exp", self.combine("*", q, self.function("ln", b)))

    def truth(self, p, env):
        """Whether a statement holds. What a premise that fails implies may be without a value; nothing else may."""
        op, *parts = p
        if op in RELATIONS:
            a, b = (self.value(part, env) for part in parts)
            if (exact(a) and exact(b)) or a[1] < b[0] or b[1] < a[0]:
                return RELATIONS[op](a[0], b[0])
            raise Unclear
        if op == "=>":
            return not self.truth(parts[0], env) or self.truth(parts[1], env)
        held = [self.truth(part, env) for part in parts]
        return {"not": not held[0], "and": all(held), "or": any(held), "<=>": held[0] == held[-1]}[op]


FLOATS = Evaluator(math, float, 1e-14, 1e-300)


@dataclass
class Domain:
    """The values that a variable or the members of a family may have; bounds are expressions."""

    low: object = None
    high: object = None
    ends: str = "()"
    natural: bool = False
    but: object = None
    near: list = field(default_factory=list)

    def show(self):
        """The domain as it stands after a name."""
        if self.natural:
            return f"natural >= {self.low}" if self.low else "natural"
        if self.low is not None and self.high is not None:
            return f"in {self.ends[0]}{show(self.low)}, {show(self.high)}{self.ends[1]}"
        if self.low is not None:
            return f"{'>=' if self.ends[0] == '[' else '>'} {show(self.low)}"
        if self.high is not None:
            return f"{'<=' if self.ends[1] == ']' else '<'} {show(self.high)}"
        return "real" if self.but is None else f"real != {self.but}"

    def without(self, name, unused):
        """The domain of a variable without what is not needed of it."""
        gone = {said.split()[1] for said in unused if said.split()[0] == name}
        return replace(
            self,
            low=(0 if self.natural else None) if gone & {">", ">="} else self.low,
            high=None if gone & {"<", "<="} else self.high,
            but=None if "!=" in gone else self.but,
        )

    def contains(self, v, env):
        """Whether a value (with its bounds) lies in the domain."""
        tests = [("<=" if self.ends[0] == "[" or self.natural else "<", self.low, "value")]
        tests += [("<=" if self.ends[1] == "]" else "<", "value", self.high), ("!=", "value", self.but)]
        inside = all(FLOATS.truth(t, {**env, "value": v}) for t in tests if None not in t)
        return inside and not (self.natural and (v[0] < 0 or v[0] != int(v[0])))

    def sample(self, rng, env):
        """A value of the domain, often at or near an end of it."""
        if self.natural:
            return Fraction((self.low or 0) + rng.randrange(4))
        low, high = (None if end is None else FLOATS.value(end, env)[0] for end in (self.low, self.high))
        if low is not None and high is not None:
            candidates = [low + (high - low) * Fraction(step, 100) for step in (0, 1, 25, 50, 75, 99, 100)]
        else:
            candidates = [g if low is None and high is None else low + g if high is None else high - g for g in GRID]
        candidates += self.near
        while not self.contains(point(found := rng.choice(candidates)), env):
            pass
        return found


class Family(dict):
    """Members of a family: sampled when first asked for, without a value below 0 and outside the range."""

    def __init__(self, domain, ends, env, rng):
        self.domain, self.ends, self.env, self.rng = domain, ends, env, rng

    def __missing__(self, k):
        first, last = (FLOATS.value(end, self.env)[0] for end in self.ends or (0, k))
        if k < 0 or not first <= k <= last:
            raise NoValue
        self[k] = point(self.domain.sample(self.rng, {**self.env, "k": point(k)}))
        return self[k]


class Sequence(dict):
    """Terms of a sequence: the first, and the step from `u(k)` to `u(k + 1)`, none after one without a value."""

    def __init__(self, first, step, env):
        self.first, self.step, self.env = first, step, env

    def __missing__(self, k):
        if k == 0:
            return self.setdefault(0, FLOATS.value(self.first, self.env))
        _ = self[k - 1]
        return self.setdefault(k, FLOATS.value(self.step, {**self.env, "k": point(k - 1)}))


@dataclass
class Claim:
    """A claim: what it declares, its hypotheses, its goal (a statement, or a test at a point and its text)."""

    variables: dict
    goal: tuple | Callable
    assumed: list = field(default_factory=list)
    prove: str = ""
    family: tuple = None
    inside: bool = False
    sequence: tuple = None
    points: int = POINTS

    def text(self, name):
        """The claim as a claim file has it."""
        lines = [f'claim {name} "A random claim"']
        lines += ["given " + "; ".join(f"{v} {domain.show()}" for v, domain in self.variables.items())]
        goal = self.prove or show(self.goal)
        if self.family:
            domain, ends = self.family
            binding = f"mu(k) {domain.show()}" + (f" for k in {show(ends[0])}..{show(ends[1])}" if ends else "")
            if self.inside:
                goal = f"for all {binding}: ({goal})"
            else:
                lines.append(f"given {binding}")
        if self.sequence:
            lines.append(f"define u by u(0) = {show(self.sequence[0])}, u(k + 1) = {show(self.sequence[1])}")
        lines += [f"assume h{i}: {show(h)}" for i, h in enumerate(self.assumed)]
        return "\n".join(lines + [f"prove {goal}", ""])

    def without(self, unused):
        """The claim without hypotheses, which are given as an audit prints them."""
        labels = {said.split(":")[0] for said in unused}
        assumed = [h for i, h in enumerate(self.assumed) if f"h{i}" not in labels]
        variables = {name: domain.without(name, unused) for name, domain in self.variables.items()}
        family = self.family
        if family and not self.inside and any(said.startswith("mu(") for said in unused):
            family = (Domain(), family[1])
        return replace(self, variables=variables, assumed=assumed, family=family)

    def place(self, rng, given):
        """A point: the given values, and samples for the rest."""
        env = {}
        for name, domain in self.variables.items():
            env[name] = point(given[name]) if name in given else point(domain.sample(rng, env))
        if self.family:
            env["mu"] = Family(*self.family, env, rng)
            env["mu"].update({int(name[3:-1]): point(v) for name, v in given.items() if name.startswith("mu(")})
        if self.sequence:
            env["u"] = Sequence(*self.sequence, env)
        return env

    def allowed(self, env):
        """Whether domains and hypotheses hold."""
        inside = [domain.contains(env[name], env) for name, domain in self.variables.items()]
        inside += [self.family[0].contains(v, {**env, "k": point(k)}) for k, v in env.get("mu", {}).items()]
        return all(inside) and all(FLOATS.truth(h, env) for h in self.assumed)

    def holds(self, env):
        """Whether the goal holds."""
        return self.goal(env) if callable(self.goal) else FLOATS.truth(self.goal, env)


def settled(test, env):
    """What a test says of a point: True, False, "no value" or "unclear"."""
    try:
        return test(env)
    except NoValue:
        return "no value"
    except (Unclear, OverflowError):
        return "unclear"


def printed(env):
    """A point as text."""
    members = [(f"{name}({k})", v) for name, vs in env.items() if isinstance(vs, dict) for k, v in vs.items()]
    numbers = [(name, v) for name, v in env.items() if isinstance(v, tuple)]
    return ", ".join(f"{name} = {v[0]}" for name, v in numbers + members)


class Grower:
    """Grows random expressions and statements from leaves (a function of the indices in scope)."""

    def __init__(self, rng, leaf, operations, exponents=lambda bound: [2, 2, 3, 4, 6, -1, -2], ends=("n",)):
        self.rng, self.leaf, self.operations, self.exponents, self.ends = rng, leaf, operations, exponents, ends

    def expression(self, depth, bound=()):
        """An expression that is at most so deep."""
        if depth <= 0 or self.rng.random() < 0.15:
            return self.leaf(bound)
        op = self.rng.choice(self.operations)
        if op in ("sum", "product"):
            if len(bound) == 2:
                return self.expression(depth - 1, bound)
            index, last = "ij"[len(bound)], self.rng.choice([*self.ends, *self.ends, 2, 3, *bound])
            return op, index, self.rng.choice([0, 1, 1, 1, 2]), last, self.expression(depth - 1, (*bound, index))
        first = self.expression(depth - 1, bound)
        if op == "^":
            return op, first, self.rng.choice(self.exponents(bound))
        return (op, first, self.expression(depth - 1, bound)) if op in "+-*/" else (op, first)

    def comparison(self, depth, relations=("=", "=", ">=", ">=", "!=", "<", "<=", ">")):
        """A comparison with a right side that is often the simpler one."""
        right = self.expression(self.rng.choice([0, 1, depth]))
        return self.rng.choice(relations), self.expression(depth), right

    def hypothesis(self):
        """An equation, mostly."""
        equation, zero = self.comparison(2, ("=",)), ("=", ("*", self.expression(1), self.expression(1)), 0)
        one, other = self.comparison(1), self.comparison(1)
        joined = (self.rng.choice(["or", "=>", "<=>"]), one, other)
        return self.rng.choice([equation, equation, equation, zero, one, one, joined, joined, ("not", joined)])

    def goal(self):
        """A comparison, one that is rewritten by a plausible rule, or several in a statement."""
        e, one, other = self.expression(3), self.comparison(1), self.comparison(1)
        rewritten = (self.rng.choice(["=", "=", "<=", ">="]), e, self.rewritten(e))
        both = (self.rng.choice(["=>", "<=>"]), *self.rng.sample([one, self.applied(one)], 2))
        joined = (self.rng.choice(["and", "or", "=>", "=>", "<=>"]), one, other)
        plain = self.comparison(2)
        return self.rng.choice([plain, plain, rewritten, rewritten, both, both, both, joined, joined, ("not", joined)])

    def applied(self, comparison):
        """The comparison with the same done to both of its sides."""
        op = self.rng.choice([o for o in self.operations if o not in ("sum", "product")])
        other = self.rng.choice(self.exponents(())) if op == "^" else self.expression(1)
        relation, *sides = comparison
        return relation, *((op, side, other) if op in "+-*/^" else (op, side) for side in sides)

    def rewritten(self, e):
        """The expression with rules applied here and there, of which some hold only for positive numbers."""
        if not isinstance(e, tuple) or e[0] in ("sum", "product", "of") or self.rng.random() < 0.2:
            return e
        match (e[0], *map(self.rewritten, e[1:])):
            case ("sqrt" | "cbrt" as op, ("*" | "/" as inner, a, b)):
                return inner, (op, a), (op, b)
            case ("sqrt", ("^", a, 2)) | ("ln", ("exp", a)) | ("exp", ("ln", a)):
                return a
            case ("^", ("*" | "/" as inner, a, b), q):
                return inner, ("^", a, q), ("^", b, q)
            case ("^", ("^", a, 2 | 3 | 4 as q), 2 | 3 | -1 as r):
                return "^", a, q * r
            case ("ln", ("*" | "/" as inner, a, b)):
                return "+" if inner == "*" else "-", ("ln", a), ("ln", b)
            case ("ln", ("^", a, q)):
                return "*", q, ("ln", a)
            case ("exp", ("+" | "-" as inner, a, b)):
                return "*" if inner == "+" else "/", ("exp", a), ("exp", b)
            case ("/", a, b):
                return "*", a, ("^", b, -1)
            case ("+" | "-" | "*" as inner, a, b):
                return inner, b, a
            case same:
                return same


def real_domain(rng):
    """A domain of real numbers, with fixed ends."""
    bounds = [(0, None), (0, None), (None, 0), (None, None), (None, None), (1, None), (-1, 1), (0, 1), (-2, 1)]
    low, high = rng.choice([*bounds, (-3, -1)])
    but = rng.choice([None, 0, 1]) if low is None and high is None else None
    return Domain(low, high, rng.choice("[(") + rng.choice(")]"), but=but)


def scalars(rng):
    """Statements about a few numbers, some of them natural, with hypotheses."""
    names = rng.sample(["x", "y", "z", "n", "m"], rng.choice([1, 2, 2, 3]))
    naturals = [name for name in names if name in INDICES]
    variables = {
        name: Domain(rng.choice([0, 0, 1]), natural=True) if name in naturals else real_domain(rng) for name in names
    }
    operations, exponents = ["+", "-", "*", "*", "/", "^", "^", "neg"], [2, 2, 3, 4, 6, -1, -2]
    if rng.random() < 0.6:
        operations += ["sqrt", "exp", "ln", "cbrt", "^"] + ["sum", "product"] * bool(naturals)
        exponents += [Fraction(q) for q in ("1/2", "3/2", "-1/2", "2/3", "1/4")] + names

    def leaf(bound):
        return rng.choice([*bound, *bound, *names, *names, *names, 0, 1, 2, 3, Fraction(1, 2)])

    grower = Grower(rng, leaf, operations, lambda bound: exponents + list(bound), naturals or (2,))
    assumed = [grower.hypothesis() for _ in range(rng.choice([0, 1, 1, 2]))]
    goal = grower.goal()
    return Claim(variables, goal, assumed)


def sums(rng):
    """Families, with a range or not, under `for all` or not; sums and products of their members."""
    bounds = [(0, None), (0, None), (0, None), (None, None), (None, 0), (1, None), (1, 2), ("k", None), ("x", None)]
    bounds += [(0, ("+", "k", 1)), (0, "k"), ("k", ("+", "k", 1)), (0, "n"), ("x", ("+", "x", 1))]
    bounds += [(("sum", "j", 1, "k", ("-", "j", "k")), None)] * 2
    low, high = rng.choice(bounds)
    narrow = high in ("k", "n")
    domain = Domain(low, high, "[]" if narrow else rng.choice("[(") + rng.choice(")]"))
    up = ("+", "n", 1)
    ends = rng.choice([None, None, None, (0, "n"), (1, "n"), (0, ("-", "n", 1)), (1, up), ("m", "n"), (0, "m")])

    def leaf(bound):
        kind = rng.random()
        if kind < 0.55:
            near = [bound[-1]] * 6 + [("+", bound[-1], 1), ("-", bound[-1], 1)] if bound else []
            return "of", "mu", rng.choice(near + ["n", "m", ("-", "n", 1), up, 0, 1, 2, ("-", "n", "m")])
        return rng.choice([*bound, *bound, "n", "m", "x", "y", 1, 2])

    def exponents(bound):
        return [2, 3, -1, "n", "m", Fraction(1, 2), ("/", 1, "n"), ("/", 1, up), ("/", "n", "m"), *bound]

    operations = ["+", "-", "*", "/", "sum", "sum", "sum", "product", "product", "^", "^", "sqrt", "ln", "exp"]
    grower = Grower(rng, leaf, operations, exponents, ("n", "n", up, ("-", "n", 1), "m"))
    goal = grower.comparison(rng.choice([1, 2, 2, 3]), ("=", ">=", ">=", ">", "<=", "!="))
    shape = rng.random()
    if shape < 0.4:
        folded = (rng.choice(["sum", "product"]), "i", 1, rng.choice(["n", "m"]), grower.expression(1, ("i",)))
        goal = (rng.choice([">=", ">=", ">", "!="]), rng.choice([goal[1], folded, folded, ("sqrt", leaf(()))]), 0)
    elif shape < 0.5:
        e, last = grower.expression(rng.choice([0, 1])), rng.choice(["n", up])
        fold = rng.choice([("sum", ("/", e, last)), ("product", ("^", e, ("/", 1, last)))])
        goal = ("=", (fold[0], "h", 1, last, fold[1]), e)
    sides = [(">", "n", 0), (">=", "n", 2), ("<=", "m", "n"), (">", "x", 0), ("<", "m", up)]
    if rng.random() < 0.6:
        goal = (rng.choice(["and", "and", "=>", "or"]), goal, rng.choice(sides))
    assumed = [rng.choice(sides + [(">=", "m", 1)])] if rng.random() < 0.5 else []
    inside = not {low, high}.isdisjoint({"k", "n", "x"}) or isinstance(low, tuple) or isinstance(high, tuple)
    inside = inside or rng.random() < 0.5
    if not inside and rng.random() < 0.4:
        assumed.append(grower.comparison(rng.choice([1, 2])))
        goal = rng.choice([goal, rng.choice(sides)])
    variables = {"n": Domain(0, natural=True), "m": Domain(0, natural=True), "x": Domain(), "y": Domain(0)}
    return Claim(variables, goal, assumed, family=(domain, ends), inside=inside)


def sequences(rng):
    """A sequence defined by recurrence, and a comparison of its terms, half of them by induction."""
    variables = {"x": real_domain(rng), "n": Domain(rng.choice([0, 1, 2]), natural=True)}
    operations = ["+", "+", "-", "*", "*", "/", "^", "sqrt", "exp"]

    def grower(leaves, index, more=()):
        def leaf(bound):
            terms = [("of", "u", bound[-1])] * 2 if bound and more else []
            return rng.choice([*leaves, *terms, *bound, *bound])

        return Grower(rng, leaf, operations + list(more), lambda bound: [2, 3, -1, index], (index,))

    first = grower(["x", 1], 2).expression(1)
    now = ("of", "u", "k")
    step = grower([now, now, "x", "k", 1, 2], "k").expression(2)
    now, after = ("of", "u", "n"), ("of", "u", ("+", "n", 1))
    goals = grower([now, now, after, "x", "n", 1, 2], "n", ("sum", "product"))
    right = rng.choice([0, goals.expression(1), goals.expression(2)])
    goal = (rng.choice([">=", ">", "=", "<=", "!="]), goals.expression(rng.choice([0, 1, 1, 2])), right)
    text = show(goal) + rng.choice(["", " by induction on n"])
    return Claim(variables, goal, prove=text, sequence=(first, step))


def limits(rng):
    """Limits of sequences with two parameters, mostly beside a value that fits at some of their values."""
    try:
        import mpmath
    except ImportError:
        print("limits are judged with mpmath, which is not installed: pip install mpmath", file=sys.stderr)
        sys.exit(2)
    mpmath.mp.dps = 80

    def digits(v):
        return mpmath.mpf(v.numerator) / v.denominator if isinstance(v, Fraction) else v

    deep = Evaluator(mpmath, digits, 1e-75, 0)
    variables = {"a": real_domain(rng), "b": real_domain(rng), "n": Domain(rng.choice([1, 2, 5]), natural=True)}
    powers = [2, 3, -1, "n", "n", ("+", "n", 1), "b", *map(Fraction, ("1/2", "1/3", "3/2", "-1/2"))]
    powers += map(tree, ("1/n", "a*n", "a/n", "-n", "2*n", "n/2"))
    leaves = ["n", "n", "n", "a", "b", 1, 2, 3, *map(tree, ("a + b", "a/n", "(a - b)*n", "-n"))]
    operations = ["+", "+", "-", "-", "*", "*", "/", "/", "/", "^", "^", "exp", "ln", "sqrt"]
    e = Grower(rng, lambda _: rng.choice(leaves), operations, lambda _: powers).expression(rng.choice([2, 3, 3, 4]))

    def tends(env, value):
        """Whether the terms at a million and at a billion come near the value, and the second far nearer."""
        deep.value(e, env)
        limit, gaps = deep.widened(*deep.value(value, env)), []
        for n in (10**6, 10**9):
            gap = deep.combine("-", deep.widened(*deep.value(e, {**env, "n": point(n)})), limit)
            if gap[1] - gap[0] > 1e-20 * (1 + abs(limit[0])):
                raise Unclear
            gaps.append(max(map(abs, gap)))
        if gaps[1] > 1e-2 * (1 + abs(limit[0])) and gaps[1] > 0.99 * gaps[0]:
            return False
        if gaps[1] > 1e-20 and gaps[1] > min(gaps[0] / 5, 1e-2):
            raise Unclear
        return True

    values = "0 1 a b a/b a*b exp(a) a+b a-b sqrt(a) ln(a) 1/2 2 a^2 exp(-a) 1/a a/2 ln(a)-ln(b) exp(a*b)".split()
    claims = [
        Claim(variables, partial(tends, value=v), prove=f"limit of {show(e)} as n -> infinity is {show(v)}", points=20)
        for v in map(tree, values)
    ]
    places = [claims[0].place(rng, {}) for _ in range(2)]
    return max(claims, key=lambda claim: sum(settled(claim.holds, env) is True for env in places) + rng.random())


def signs(rng):
    """The sign of a polynomial of one variable on an interval that ends at or near its roots."""
    roots = [Fraction(v) for v in ("0", "1", "-1", "1/2", "2", "3/2", "1/3")]
    coefficients, chosen = [Fraction(rng.choice([1, 1, -1, 2]))], []
    for _ in range(rng.randrange(1, 5)):
        factor, times = [rng.choice([1, 2, 5, -1, -2, -3]), rng.choice([0, -1, 1, 2]), 1], 1
        if rng.random() < 0.6:
            chosen.append(rng.choice(roots))
            factor, times = [-chosen[-1], 1], rng.choice([1, 1, 2, 3])
        for _ in range(times):
            coefficients = [
                sum(c * factor[k - i] for i, c in enumerate(coefficients) if 0 <= k - i < len(factor))
                for k in range(len(coefficients) + len(factor) - 1)
            ]
    if rng.random() < 0.2:
        coefficients[0] += rng.choice([-1, 1]) * Fraction(1, 1000)
    low, high = sorted(rng.sample(sorted(set(chosen + roots)), 2))
    low, high = rng.choice([(low, high), (low, high), (low, high), (low, None), (None, high), (None, None)])
    near = [r + s * Fraction(1, d) for r in chosen + roots for d in (10**6, 100, 10, 3) for s in (-1, 0, 1)]
    domain = Domain(low, high, rng.choice("[(") + rng.choice(")]"), near=near)
    polynomial = Fraction(0)
    for power, c in enumerate(coefficients):
        polynomial = ("+", polynomial, ("*", c, ("^", "x", power))) if c else polynomial
    return Claim({"x": domain}, (rng.choice([">=", ">=", "<=", "<=", ">", "<", "!="]), polynomial, 0))


def extrema(rng):
    """The maximum or minimum over one or two variables, said to be at a point that often is right."""
    maxima = {"t*(c - t)": "c/2", "t/(t + c)^2": "c", "-(t - c)^2*(t - 1)^2": "c", "sqrt(t)*(c - t)": "c/3"}
    maxima |= {"t*s - s^2 - t^2/c": "0", "s*t*(c - s - t)": "c/3", "(t - c)/(t^2 + 1)": "c + 1"}
    minima = {"(t - c)^2": "c", "t + c/t": "sqrt(c)", "t^2/(t^2 + c)": "0", "t^3 - 3*c^2*t": "c"}
    minima |= {"(t - c)^2 + (s - t)^2": "c", "t^2 + c*s^2 + s": "0", "t*ln(t/c)": "c*exp(-1)"}
    kind, known = rng.choice([("maximum", maxima), ("minimum", minima)])
    points = [tree(p) for p in "0;1;a;b;a/2;sqrt(a);(a + b)/2;a + b;-a;2;1/2;a - b;(a + b)/3;a/3".split(";")]
    form, c = rng.choice(list(known)), tree(rng.choice(["a", "a", "b", "1", "2", "a + b", "a - b"]))
    body, right = tree(form, c=c), tree(known[form], c=c)
    moving = ["t", "s"] if "s" in form.replace("sqrt", "") else ["t"]
    at = dict.fromkeys(moving, right) if rng.random() < 0.7 else {v: rng.choice(points) for v in moving}
    bounds = [(0, 1), (0, "a"), ("a", "b"), (-1, 1), (0, tree("a + 1")), (None, None), (None, None)]
    domain = Domain(*rng.choice([*bounds, (0, None), (0, None), (0, None)]), rng.choice("[(") + rng.choice(")]"))
    kind = rng.choice([kind, kind, kind, "maximum", "minimum"])
    only, value = rng.random() < 0.5, tree(form, c=c, **at)

    def best(env):
        """Whether the point lies in the domain and no point of a grid is better, or as good where that counts."""
        # What no point of the grid denies stays open: such a claim may hold or not.
        place = {v: FLOATS.value(at[v], env) for v in moving}
        if not all(domain.contains(v, env) for v in place.values()):
            return False
        top, low, high = (None if e is None else FLOATS.value(e, env) for e in (value, domain.low, domain.high))
        low = low[0] if low else Fraction(-4)
        steps = [point(low + ((high[0] if high else low + 10) - low) * Fraction(i, 12)) for i in range(13)]
        steps = [v for v in [*steps, *place.values()] if domain.contains(v, env)]
        for spot in itertools.product(steps, repeat=len(moving)):
            found = FLOATS.value(body, {**env, **dict(zip(moving, spot))})
            if found[0] > top[1] if kind == "maximum" else found[1] < top[0]:
                return False
            apart = any(exact(v) and exact(w) and v != w for v, w in zip(spot, place.values()))
            if only and apart and found == top and exact(top):
                return False
        raise Unclear

    over = "; ".join(f"{v} {domain.show()}" for v in moving)
    there = ", ".join(f"{v} = {show(at[v])}" for v in moving)
    text = f"{kind} of {show(body)} over {over} {'only ' if only else ''}at {there} is {show(value)}"
    return Claim({"a": real_domain(rng), "b": real_domain(rng)}, best, prove=text, points=20)


KINDS = {"scalars": scalars, "sums": sums, "sequences": sequences, "limits": limits, "signs": signs, "extrema": extrema}


def finding(claim, verdict, witness):
    """What is wrong with a verdict, or nothing."""
    rng = random.Random(claim.text(""))
    if verdict == "refuted":
        try:
            given = {name: Fraction(v) for name, v in (witness or {}).items()}
        except ValueError:
            return None  # Rounded values are no witness to evaluate at.
        places = [claim.place(rng, given) for _ in range(1 if witness else claim.points)]
        found = [(settled(claim.allowed, env), settled(claim.holds, env)) for env in places]
        if any(len(env.get("mu", ())) > sum(name.startswith("mu(") for name in given) for env in places):
            return None  # The witness leaves out members that are asked for.
        if all(allowed in (False, "no value") for allowed, _ in found):
            return f"refuted, but its hypotheses do not hold at {printed(places[0])}"
        return f"refuted, but it holds at {printed(places[0])}" if witness and found[0][1] is True else None
    for _ in range(claim.points if verdict != "undecided" else 0):
        env = claim.place(rng, {})
        if settled(claim.allowed, env) is not True:
            continue
        if verdict == "contradictory":
            return f"hypotheses said to contradict each other, which hold at {printed(env)}"
        if (held := settled(claim.holds, env)) in (False, "no value"):
            return f"proved, but {held or 'false'} at {printed(env)}"
    return None


def judged(carom, claims):
    """The verdict, the witness and the hypotheses not needed of each claim, by its place in the list; ends the program where one has none."""
    with tempfile.NamedTemporaryFile("w", suffix=".claim") as file:
        file.write("\n".join(claim.text(f"c{i}") for i, claim in enumerate(claims)))
        file.flush()
        command = [carom, "audit", "--format", "json", "--time", "1", "--max-steps", "10000", file.name]
        try:
            out = subprocess.run(command, capture_output=True, text=True)
        except OSError as error:
            print(f"{carom}: {error}", file=sys.stderr)
            sys.exit(2)
        report = json.loads(out.stdout or '{"claims": [], "errors": []}')
        verdicts = {int(c["id"][1:]): (c["verdict"], c["witness"], c["unused"]) for c in report["claims"]}
        for error in report["errors"]:
            if "contradict each other" in error["message"]:
                verdicts[int(error["claim"][1:])] = ("contradictory", None, [])
        if len(verdicts) < len(claims):
            missing = next(claim for i, claim in enumerate(claims) if i not in verdicts)
            print(f"# NO VERDICT, exit code {out.returncode}: {out.stderr[:2000]}\n{missing.text('missing')}")
            sys.exit(2 if out.returncode == 2 else 1)
    return verdicts


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--kind", choices=[*KINDS, "all"], default="all")
    parser.add_argument("--claims", type=int, default=1000, help="of each kind")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--carom", default="target/release/carom")
    a = parser.parse_args()
    wrong = 0
    print(f"seed {a.seed}")
    for kind in KINDS if a.kind == "all" else [a.kind]:
        rng = random.Random(f"{kind} {a.seed}")
        counts = dict.fromkeys(("proved", "refuted", "undecided", "contradictory", "reduced", "wrong"), 0)
        for done in range(0, a.claims, BATCH):
            claims = [KINDS[kind](rng) for _ in range(min(BATCH, a.claims - done))]
            reduced, names = [], []
            for i, (verdict, witness, unused) in sorted(judged(a.carom, claims).items()):
                counts[verdict] += 1
                reason = finding(claims[i], verdict, witness)
                if reason:
                    counts["wrong"] += 1
                    print(f"# WRONG: {reason}\n{claims[i].text(f'{kind}-{a.seed}-{done + i}')}")
                if verdict == "proved" and unused:
                    reduced.append(claims[i].without(unused))
                    names.append(f"{kind}-{a.seed}-{done + i}")
            counts["reduced"] += len(reduced)
            for i, (verdict, _, _) in sorted(judged(a.carom, reduced).items() if reduced else ()):
                reason = "refuted" if verdict == "refuted" else finding(reduced[i], "proved", None)
                if reason:
                    counts["wrong"] += 1
                    print(f"# WRONG without what is not needed: {reason}\n{reduced[i].text(names[i])}")
        wrong += counts["wrong"]
        print(f"  {kind:<10}{a.claims:>7} claims" + "".join(f"{n:>7} {name}" for name, n in counts.items()), flush=True)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
