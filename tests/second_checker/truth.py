#!/usr/bin/env python3
"""Random single steps: what proofs/certificates/check.py accepts must be true, with a value, at sample points.

    truth.py COUNT [SEED]      exit code 1 if an accepted step is false somewhere

A step shows that two random expressions are equal, one made from the other by laws of powers, logarithms and sums that
hold for some values only; or that a random expression is positive, not negative or not zero. The sample points satisfy
the hypotheses. They include 0, negative numbers and natural numbers.
"""
import hashlib
import itertools
import math
import os
import random
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "proofs", "certificates"))
import check  # noqa: E402
from checker.claims import N, Node, Parser, compare, names_in, nodes, num, plus, put, subtrees, text  # noqa: E402
from checker.signs import number  # noqa: E402

DOMAINS = {
    "x": ("real", (-2, -1, 0, 0.5, 3)), "y": ("> 0", (0.5, 2)), "z": (">= 0", (0, 1.5)), "v": ("< 0", (-0.5, -2)),
    "p": ("real", (-1.5, -1, 0, 0.5, 2)), "q": ("> 0", (0.5, 3)), "n": ("natural", (0, 1, 2, 3)),
    "m": ("natural >= 1", (1, 2, 3)), "r": ("in [-1, 1]", (-1, -0.6, 0, 0.8, 1)),
}
ARCS = ("arcsin", "arccos", "arctan")
NATURAL = {"n", "m", "i", "j"}


class Undefined(Exception):
    """The expression has no value."""


def whole(e):
    v = number(e)
    if v is not None:
        return v.denominator == 1
    if e[0] == "pow":
        k = number(e[2])
        return whole(e[1]) and k is not None and k >= 0 and k.denominator == 1
    if e[0] == "prod" and any(o == "/" for o, _ in e[1]):
        return False
    return e[1] in NATURAL if e[0] == "name" else e[0] in ("neg", "sum", "prod") and all(map(whole, nodes(e)))


def exact(out, base):
    """A power, which is 0 for the base 0 only: what is too small for this arithmetic says nothing."""
    if out == 0 and base != 0:
        raise OverflowError
    return out


def value(e, at):
    """The value at a point, by the table of section 7 of the page on the format."""
    tag = e[0]
    if tag == "num":
        return float(e[1])
    if tag == "name":
        return math.pi if e[1] == "pi" else float(at[e[1]])
    if tag == "neg":
        return -value(e[1], at)
    if tag == "sum":
        return sum(s * value(part, at) for s, part in e[1])
    if tag == "prod":
        out = 1.0
        for operator, part in e[1]:
            v = value(part, at)
            if operator == "/" and v == 0:
                raise Undefined
            out = out * v if operator == "*" else out / v
        return out
    if tag == "pow":
        b, k = value(e[1], at), value(e[2], at)
        given = number(e[2])
        if whole(e[2]):
            if k < 0 and b == 0:
                raise Undefined
            return exact(b ** round(k), b)
        root = given is not None and given > 0
        if b < 0 or (b == 0 and not root):
            raise Undefined
        return exact(b**k, b)
    if tag == "over":
        low, high = round(value(e[3], at)), round(value(e[4], at))
        if low < 0 or high + 1 < low:
            raise Undefined
        parts = [value(e[5], {**at, e[2]: k}) for k in range(low, high + 1)]
        return math.fsum(parts) if e[1] == "sum" else math.prod(parts)
    if tag == "deriv":
        h, x = 1e-5, e[2][0]
        return (value(e[1], {**at, x: at[x] + h}) - value(e[1], {**at, x: at[x] - h})) / (2 * h)
    a = value(e[2][0], at)
    if e[1] in ("sqrt", "cbrt"):
        if a < 0:
            raise Undefined
        return a ** (1 / 2 if e[1] == "sqrt" else 1 / 3)
    if e[1] == "ln":
        if a <= 0:
            raise Undefined
        return math.log(a)
    if e[1] in ARCS:
        if e[1] != "arctan":
            if abs(a) > 1 + 1e-9:
                raise Undefined
            a = max(-1, min(1, a))  # what is beyond 1 by rounding
        return getattr(math, "a" + e[1][3:])(a)
    return exact(getattr(math, e[1])(a), 1)


class Maker:
    def __init__(self, chance):
        self.chance, self.names = chance, chance.sample(sorted(DOMAINS), 4)

    def expr(self, depth, names=None):
        names, pick = names or self.names, self.chance.choice
        if depth == 0 or self.chance.random() < 0.15:
            return pick(names) if self.chance.random() < 0.8 else pick(("0", "1", "2", "3"))
        sub = lambda: self.expr(depth - 1, names)
        kind = self.chance.randrange(12)
        if kind < 3:
            return f"({sub()}{pick(('+', '-', '*', '/'))}({sub()}))"
        if kind < 8:
            naturals = [n for n in names if n in NATURAL]
            exponents = ["2", "(-1)", "(1/2)", "(1/3)", "(-1/2)", "3", "0"] + names
            exponents += [f"({k}{c})" for k in naturals for c in ("-1", "*2", "+1", "/2")] + [f"(-{k})" for k in naturals]
            return f"({sub()})^{pick(exponents)}"
        if kind < 10:
            return f"{pick(('sqrt', 'cbrt', 'exp', 'ln', 'exp', 'cosh', 'arctan', 'arcsin', 'sin'))}({sub()})"
        naturals = [n for n in names if n in NATURAL]
        if naturals and "i" not in names:
            return f"{pick(('sum', 'product'))}(i = {pick(('0', '1'))}..{pick(naturals)}, {self.expr(depth - 1, names + ['i'])})"
        return f"(-{sub()})"

    def of_arcs(self):
        """A law of arcs, with the right sign or the wrong one."""
        pick = self.chance.choice
        x, sign, other = pick(self.names + ["r", "r", "r"]), pick("+-"), pick(("sqrt(2)/2", "sqrt(3)/2", "1/2", "1", "sqrt(3)", "1/sqrt(3)"))
        f, g = pick(("sin", "cos", "tan")), pick(("arcsin", "arctan"))
        return pick((
            f"cos(arcsin({x})) = sqrt(1 {sign} {x}^2)", f"sin(arccos({x})) = sqrt(1 {sign} {x}^2)", f"sin(arcsin({x})) = {sign} {x}",
            f"cos(arctan({x})) = 1/sqrt(1 {sign} {x}^2)", f"sin(arctan({x})) = {x}/sqrt(1 {sign} {x}^2)",
            f"sin(2*arctan({x})) = 2*{x}/(1 {sign} {x}^2)", f"cos(2*arccos({x})) = 2*{x}^2 {sign} 1",
            f"arccos({x}) = pi/2 {sign} arcsin({x})", f"arccos(-{x}) = pi {sign} arccos({x})", f"{g}(-{x}) = 0 {sign} {g}({x})",
            f"arc{f}({other}) = pi/{pick('23456')}", f"arccos({x}) {pick(('<=', '<'))} pi", f"{g}({x}) {pick(('<=', '<'))} pi/2",
            f"derivative(arctan({x}), {x}) = 1/(1 {sign} {x}^2)",
        )).replace("= + ", "= ")

    def changed(self, e):
        """The tree with one law applied somewhere, whether it holds there or not."""
        places = [t for t in subtrees(e)]
        place = self.chance.choice(places)
        laws = list(self.laws(place))
        if not laws:
            return e
        new = self.chance.choice(laws)
        swap = lambda t: new if t is place else t if not isinstance(t, Node) else \
            N(t[0], *(shaped(part, swap) for part in t[1:]))
        return swap(e)

    def laws(self, e):
        times = lambda a, b: N("prod", (("*", a), ("*", b)))
        if e[0] == "pow":
            a, k = e[1], e[2]
            yield N("prod", (("*", num(1)), ("/", N("pow", a, N("neg", k)))))
            yield times(a, N("pow", a, plus(k, num(1), -1)))
            yield N("call", "exp", (times(k, N("call", "ln", (a,))),))
            if a[0] == "prod":
                yield N("prod", tuple((o, N("pow", part, k)) for o, part in a[1]))
            if a[0] == "pow":
                yield N("pow", a[1], times(a[2], k))
                yield N("pow", N("pow", a[1], k), a[2])
            if k[0] == "sum":
                yield N("prod", tuple(("*" if s > 0 else "/", N("pow", a, part)) for s, part in k[1]))
        if e[0] == "call":
            (a,) = e[2]
            if e[1] in ("sqrt", "cbrt") and a[0] == "prod":
                yield N("prod", tuple((o, N("call", e[1], (part,))) for o, part in a[1]))
            if e[1] == "sqrt" and a[0] == "pow":
                yield N("pow", a[1], N("prod", (("*", a[2]), ("/", num(2)))))
            if e[1] == "ln" and a[0] == "pow":
                yield times(a[2], N("call", "ln", (a[1],)))
            if e[1] == "ln" and a[0] == "prod":
                yield N("sum", tuple((1 if o == "*" else -1, N("call", "ln", (part,))) for o, part in a[1]))
            if e[1] == "exp" and a[0] == "sum":
                yield N("prod", tuple(("*" if s > 0 else "/", N("call", "exp", (part,))) for s, part in a[1]))
            if e[1] in ("exp", "ln") and a[0] == "call" and a[1] in ("exp", "ln") and a[1] != e[1]:
                yield a[2][0]
        yield from self.laws_of_arcs(e)
        if e[0] == "over":
            if e[5][0] == ("sum" if e[1] == "sum" else "prod"):
                yield N(e[5][0], tuple((o, N(*e[:5], part)) for o, part in e[5][1]))
            count = plus(plus(e[4], num(1)), e[3], -1)
            if e[2] not in names_in(e[5]):
                yield times(count, e[5]) if e[1] == "sum" else N("pow", e[5], count)
        if e[0] == "prod":
            yield N("prod", (*e[1], ("*", e[1][0][1]), ("/", e[1][0][1])))
        if e[0] not in ("over", "num"):
            yield N("pow", N("call", "sqrt", (e,)), num(2))
            yield N("call", "sqrt", (N("pow", e, num(2)),))
            yield N("prod", (("*", N("pow", e, num(2))), ("/", e)))

    def laws_of_arcs(self, e):
        call = lambda f, a: N("call", f, (a,))
        over = lambda a, b: N("prod", (("*", a), ("/", b)))
        square = lambda a: N("pow", a, num(2))
        if e[0] != "call":
            return
        (a,), quarter = e[2], over(N("name", "pi"), num(2))
        if e[1] in ("sin", "cos", "arcsin", "arctan") and a[0] == "neg":
            yield N("neg", call(e[1], a[1]))
        if e[1] in ("sin", "cos", "arcsin", "arccos") and a[0] == "call" and a[1].removeprefix("arc") == e[1].removeprefix("arc") != a[1]:
            yield a[2][0]
        if e[1] == "cos" and a[0] == "call" and a[1] in ("arcsin", "arctan"):
            root = call("sqrt", plus(num(1), square(a[2][0]), 1 if a[1] == "arctan" else -1))
            yield root if a[1] == "arcsin" else over(num(1), root)
        if e[1] == "sin" and a[0] == "call" and a[1] in ("arccos", "arctan"):
            root = call("sqrt", plus(num(1), square(a[2][0]), 1 if a[1] == "arctan" else -1))
            yield root if a[1] == "arccos" else over(a[2][0], root)
        if e[1] in ("arcsin", "arccos"):
            yield plus(quarter, call("arccos" if e[1] == "arcsin" else "arcsin", a), -1)
            yield call("arctan", over(a, call("sqrt", plus(num(1), square(a), -1))))
        if e[1] == "arctan":
            yield plus(quarter, call("arctan", over(num(1), a)), -1)
            yield call("arcsin", over(a, call("sqrt", plus(num(1), square(a)))))


def shaped(part, swap):
    if isinstance(part, Node):
        return swap(part)
    return tuple(shaped(p, swap) for p in part) if isinstance(part, tuple) else part


def holds(goal, at):
    (a, b), (relation,) = goal[1], goal[2]
    a, b = value(a, at), value(b, at)
    if not (math.isfinite(a) and math.isfinite(b)):
        raise OverflowError  # beyond the floating-point numbers nothing is compared
    near = abs(a - b) <= 1e-4 * max(1, abs(a), abs(b))
    holding = {"=": near, ">": a > b or near, ">=": a > b or near, "<": a < b or near, "<=": a < b or near, "!=": True}
    return holding[relation] and not (relation in "<>" and a == b)


def step(chance):
    """(claim, steps, goal, the variables, the sides of the equation that is supposed, or None)."""
    maker = Maker(chance)
    arcs = chance.choice(("law", "order")) if chance.random() < 0.2 else None
    if arcs and "r" not in maker.names:
        maker.names[0] = "r"
    names = [n for n in maker.names]
    given = [f"{n} {DOMAINS[n][0]}" for n in names]
    equation = left = None
    naturals = [n for n in names if n in NATURAL]
    if chance.random() < 0.3 and naturals and len(naturals) < 4:
        left, right = chance.choice(naturals), chance.choice([n for n in names if n not in NATURAL])
        left, right = chance.choice(((left, right), (right, left)))
        equation = N("name", right)
    elif chance.random() < 0.6:
        left, equation = "w", Parser(maker.expr(2)).expr()
        maker.names.append("w")
        given.append("w real")
    a = Parser(maker.expr(chance.choice((1, 2, 2, 3)))).expr()
    rule = chance.choice(("combination", "combination", "power"))
    if arcs == "law":
        rule, goal = "combination", Parser(maker.of_arcs()).prop()
    elif arcs:
        f, simple = chance.choice(ARCS), ("0", "1", "1/2", "-1", "r", "r", "r/2", "0 - r")
        inside = (maker.expr(1) if chance.random() < 0.3 else chance.choice(simple) for _ in range(2))
        a, b = (N("call", f, (Parser(e).expr(),)) for e in inside)
        rule, goal = "arc", compare(a, chance.choice(("<", "<=", ">", ">=", "=", "!=")), b)
    elif chance.random() < 0.7:
        if chance.random() < 0.15:
            rule = chance.choice(("arc", "combination"))
            a = N("call", chance.choice(ARCS), (a if rule == "combination" else Parser(maker.expr(1)).expr(),))
        b = a
        for _ in range(chance.choice((1, 1, 2, 3))):
            b = maker.changed(b)
        if equation and chance.random() < 0.5:
            b = put(b, {left: equation}, None)
        goal = compare(a, "=", b)
    else:
        rule, goal = "combination", compare(a, chance.choice((">", ">=", "!=")), num(0))
    shown = text(goal)[1:-1]
    facts = sum(0 if DOMAINS[n][0] in ("real", "natural") else 2 if n == "r" else 1 for n in names) + (equation is not None)
    by = [f"h{k + 1}" for k in range(facts) if chance.random() < 0.9]
    lines = [f"1 {rule}: {shown}"] + (["    | by " + " ".join(by)] if by else [])
    if equation and chance.random() < 0.8:
        lines.append(f"    | using h{facts}")
    claim = "given " + ";  ".join(given) + (f"\nassume {left} = {text(equation)}" if equation else "") + f"\nprove {shown}\n"
    return 'claim t "t"\n' + claim, "\n".join(lines) + "\n", goal, names, (left, equation) if equation else None


def main(count, seed="1"):
    chance, accepted, false = random.Random(seed), 0, 0
    for _ in range(int(count)):
        try:
            source, steps, goal, names, equation = step(chance)
            claim = check.reading.File(source).claim("t")
            digest = hashlib.sha256(claim.text().encode()).hexdigest()
            check.check(claim, f"carom-certificate 2\nclaim t\nstatement sha256 {digest}\n{steps}qed\n", {})
        except (check.Refused, check.NotCovered):
            continue
        accepted += 1
        for values in itertools.product(*(DOMAINS[n][1] for n in names)):
            at = dict(zip(names, values))
            try:
                if equation and equation[0] == "w":
                    at["w"] = value(equation[1], at)
                elif equation and at[equation[0]] != value(equation[1], at):
                    continue
            except (Undefined, OverflowError):
                continue
            try:
                good = holds(goal, at)
            except Undefined:
                good = False
            except OverflowError:
                good = True
            if not good:
                false += 1
                print(f"FALSE at {at}\n{source}--\n{steps}")
                break
    print(f"{count} random steps, {accepted} accepted, {false} of them false")
    return 1 if false or not accepted else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
