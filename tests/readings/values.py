"""Values of expressions at a point, which is a dictionary from names to numbers (or matrices, or families).

An angle is a real number, π is π, a derivative is the derivative of a function, by numbers with derivatives
(`dual.py`), through `let`, parameters and sequences. Nothing is expanded. An entry `#x` of a point says how the form of
x counts in exponents: `True` for a whole number, or the argument of a parameter with the point where that is read.
"""

from fractions import Fraction

import mpmath
from mpmath import mpf

from dual import (
    HUGE,
    Dual,
    Unclear,
    Undefined,
    arccos,
    arcsin,
    arctan,
    cos,
    cosh,
    divide,
    exp,
    is_zero,
    largest,
    ln,
    new_tag,
    real,
    real_power,
    root,
    sech,
    sin,
    sinh,
    size,
    slope,
    tan,
    tanh,
    whole,
    whole_part,
    whole_power,
)
from matrix import added, det, inverse, matrix_power, product, scaled, trace, transpose
from quadrature import quadrature

FUNCTIONS = {"exp": exp, "ln": ln, "sin": sin, "cos": cos, "tan": tan, "cosh": cosh, "sinh": sinh, "tanh": tanh}
FUNCTIONS |= {"arcsin": arcsin, "arccos": arccos, "arctan": arctan}
FUNCTIONS |= {"sech": sech, "abs": size, "floor": whole_part}
FUNCTIONS |= {"sqrt": lambda x: root(x, 2), "cbrt": lambda x: root(x, 3)}
FUNCTIONS |= {"ceil": lambda x: -whole_part(-x), "ceiling": lambda x: -whole_part(-x)}
# Beyond 2 to this power the digits may not suffice for a difference.
MAGNITUDE = 150
# The largest arguments at which these functions keep their digits, and an arctan is not too near to π/2.
ARGUMENTS = {"exp": 75, "cosh": 75, "sinh": 75, "sech": 75, "tanh": 38, "arctan": mpf(10) ** 30}
STEPS_LIMIT = 60_000
MEMBERS_LIMIT = 2_000


class Values:
    """Evaluates the expressions of one claim; `steps` bounds the work of a question."""

    def __init__(self, claim):
        self.claim = claim
        self.steps = 0
        self.in_limit = False
        self.natural = {n for b in claim.given for n, _ in b.names if b.kind in ("natural", "integer")}
        self.natural |= {n for n, kind in claim.moving.items() if kind == "natural"}

    def value(self, e, env):
        self.steps += 1
        if self.steps > STEPS_LIMIT:
            raise Unclear
        return getattr(self, VALUES[e[0]])(e, env)

    def number(self, e, env):
        out = self.value(e, env)
        if isinstance(out, list):
            raise Unclear
        return out

    def value_num(self, e, env):
        return numeral(e[1])

    def value_name(self, e, env):
        name = e[1]
        if name in env:
            return env[name]
        if name in self.claim.lets:
            parameters, body = self.claim.lets[name]
            if not parameters:
                return self.value(body, env.get("#outside", env))
        if name == "pi":
            return +mpmath.pi
        raise Unclear

    def value_neg(self, e, env):
        return scaled(self.value(e[1], env), mpf(-1))

    def value_add(self, e, env):
        return added(self.value(e[1], env), self.value(e[2], env))

    def value_subtract(self, e, env):
        return added(self.value(e[1], env), scaled(self.value(e[2], env), mpf(-1)))

    def value_times(self, e, env):
        a, b = self.value(e[1], env), self.value(e[2], env)
        if isinstance(a, list) and isinstance(b, list):
            return product(a, b)
        return scaled(a, b) if isinstance(a, list) else scaled(b, a)

    def value_over(self, e, env):
        a, b = self.value(e[1], env), self.number(e[2], env)
        if isinstance(a, list):
            return [[divide(entry, b) for entry in row] for row in a]
        return divide(a, b)

    def value_power(self, e, env):
        out = self.power(e, env)
        if not isinstance(out, list) and real(out):
            magnitude = mpmath.mag(real(out))
            if (
                magnitude > MAGNITUDE
                or magnitude < -115
                and not self.in_limit
                and not is_zero(real(self.value(e[1], env)))
            ):
                raise Unclear
        return out

    def power(self, e, env):
        base = self.value(e[1], env)
        if isinstance(base, list):
            n = whole(self.number(e[2], env))
            if abs(n) > MEMBERS_LIMIT:
                raise Unclear
            if n < 0 and not is_numeral(e[2]):
                raise Undefined
            return matrix_power(base, n)
        fixed = self.numerals(e[2], env)
        if fixed is not None:
            if fixed.denominator == 1:
                return whole_power(base, fixed.numerator)
            if fixed > 0:
                if is_zero(base):
                    if isinstance(base, Dual):
                        return root(base, 2)
                    return mpf(0)
                if real(base) < 0:
                    raise Undefined
            return real_power(base, mpf(fixed.numerator) / fixed.denominator)
        exponent = self.number(e[2], env)
        if self.whole_form(e[2], env):
            return whole_power(base, whole(exponent))
        return real_power(base, exponent)

    def value_call(self, e, env):
        name, arguments = e[1], e[2]
        if name in self.claim.lets:
            return self.applied(name, arguments, env)
        if name in self.claim.sequences:
            return self.member(name, self.number(arguments[0], env), env)
        if name in env:
            return env[name](self.number(arguments[0], env), env)
        if name in ("det", "trace", "inverse", "transpose"):
            matrix = self.value(arguments[0], env)
            return {"det": det, "trace": trace, "inverse": inverse, "transpose": transpose}[name](matrix)
        values = [self.number(a, env) for a in arguments]
        if name in FUNCTIONS:
            if abs(real(values[0])) > ARGUMENTS.get(name, HUGE) and not self.in_limit:
                raise Unclear
            return FUNCTIONS[name](values[0])
        if name == "max":
            return largest(values)
        if name == "min":
            return -largest([-v for v in values])
        if name == "factorial":
            n = whole(values[0])
            if n < 0:
                raise Undefined
            if n > MEMBERS_LIMIT:
                raise Unclear
            return mpmath.factorial(n)
        if name == "binomial":
            k, out = whole(values[1]), mpf(1)
            if k < 0:
                raise Undefined
            if k > MEMBERS_LIMIT:
                raise Unclear
            for i in range(1, k + 1):
                out = out * (values[0] + (1 - i)) * (mpf(1) / i)
            return out
        raise Unclear

    def applied(self, name, arguments, env):
        """A definition with parameters is a function: the value of its body, where the parameters have these values."""
        parameters, body = self.claim.lets[name]
        values = [self.value(a, env) for a in arguments]
        # What else stands in the body has its meaning where the definition stands, not where it is applied.
        outside = env.get("#outside", env)
        inner = bound(outside, dict(zip(parameters, values)))
        inner["#outside"] = outside
        for parameter, argument in zip(parameters, arguments):
            inner["#" + parameter] = argument, env
        return self.value(body, inner)

    def member(self, name, index, env):
        """A member of a sequence, by its recurrence. The members so far are kept while no variable changes."""
        index = whole(index)
        if index < 0:
            raise Undefined
        if index > MEMBERS_LIMIT:
            raise Unclear
        known = env.get("members")
        if known is None:
            known = {}
            env = {**env, "members": known}
            # One after another, so that the recursion is not as deep as the index is large.
            for k in range(index):
                self.member(name, mpf(k), env)
        if (name, index) in known:
            if known[name, index] is None:
                # It is defined by itself.
                raise Undefined
            return known[name, index]
        known[name, index] = None
        first, (k, shift, step) = self.claim.sequences[name]
        if index in first:
            out = self.number(first[index], env)
        else:
            out = self.number(step, {**env, k: mpf(index - shift), "#" + k: True})
        known[name, index] = out
        return out

    def value_fold(self, e, env):
        kind, index, low, high, body = e
        low, high = whole(self.number(low, env)), whole(self.number(high, env))
        if high < low - 1:
            raise Undefined
        if high - low > MEMBERS_LIMIT:
            raise Unclear
        out = None
        for k in range(low, high + 1):
            v = self.value(body, {**env, index: mpf(k), "#" + index: True})
            if out is None:
                out = v
            elif kind == "sum":
                out = added(out, v)
            else:
                out = product(out, v) if isinstance(out, list) else out * v
        return mpf(kind == "product") if out is None else out

    def value_integral(self, e, env):
        _, name, low, high, body = e
        low, high = self.number(low, env), self.number(high, env)
        return quadrature(lambda x: self.number(body, bound(env, {name: x})), low, high)

    def value_derivative(self, e, env):
        return self.derived(e[1], e[2], env)

    def derived(self, body, names, env):
        if not names:
            return self.value(body, env)
        name = names[-1]
        if name not in env or isinstance(env[name], list) or self.is_whole(name, env):
            raise Unclear
        tag = new_tag()
        out = self.derived(body, names[:-1], bound(env, {name: Dual(tag, env[name], mpf(1))}))
        return slope(out, tag)

    def value_matrix(self, e, env):
        return [[self.number(entry, env) for entry in row] for row in e[1]]

    # Exponents by their form.

    def put_in(self, e, env):
        """What a name stands for, a definition or the argument of a parameter, with the point where that is read."""
        if e[0] == "name":
            said = env.get("#" + e[1])
            if isinstance(said, tuple):
                return said
            if e[1] not in env and e[1] in self.claim.lets and not self.claim.lets[e[1]][0]:
                return self.claim.lets[e[1]][1], env.get("#outside", env)
        return None

    def numerals(self, e, env):
        """The value of an expression of numerals alone; nothing for others."""
        inner = self.put_in(e, env)
        if inner:
            return self.numerals(*inner)
        kind = e[0]
        if kind == "num":
            return Fraction(e[1])
        if kind not in ("neg", "+", "-", "*", "/", "^"):
            return None
        values = [self.numerals(part, env) for part in e[1:]]
        if None in values:
            return None
        if kind == "neg":
            return -values[0]
        a, b = values
        if kind == "^":
            if b.denominator != 1 or abs(b) > 1000 or a == 0 and b < 0:
                return None
            return a**b.numerator
        if kind == "/":
            return a / b if b else None
        return a + b if kind == "+" else a - b if kind == "-" else a * b

    def is_whole(self, name, env):
        """Whether a name is declared as a whole number."""
        return env.get("#" + name) is True or name in self.natural

    def whole_form(self, e, env):
        """Whether an exponent is whole by its form."""
        inner = self.put_in(e, env)
        if inner:
            return self.whole_form(*inner)
        kind = e[0]
        fixed = self.numerals(e, env)
        if fixed is not None:
            return fixed.denominator == 1
        if kind == "name":
            return self.is_whole(e[1], env)
        if kind == "call":
            if e[1] in self.claim.lets:
                parameters, body = self.claim.lets[e[1]]
                return self.whole_form(body, {**env, **{"#" + p: (a, env) for p, a in zip(parameters, e[2])}})
            return e[1] in ("floor", "ceil", "ceiling") or e[1] in self.natural
        if kind == "^":
            fixed = self.numerals(e[2], env)
            return fixed is not None and fixed >= 0 and fixed.denominator == 1 and self.whole_form(e[1], env)
        return kind in ("neg", "+", "-", "*") and all(self.whole_form(part, env) for part in e[1:])


VALUES = {"num": "num", "name": "name", "neg": "neg", "+": "add", "-": "subtract", "*": "times", "/": "over"}
VALUES |= {
    "^": "power",
    "call": "call",
    "sum": "fold",
    "product": "fold",
    "integral": "integral",
    "derivative": "derivative",
    "matrix": "matrix",
}
VALUES = {kind: "value_" + name for kind, name in VALUES.items()}


def bound(env, values, binding=None):
    """An environment in which names have new values: what was computed with the old ones is forgotten."""
    inner = {**env, **values}
    inner.pop("members", None)
    for name in values:
        inner.pop("#" + name, None)
        if binding is not None and binding.kind != "real":
            inner["#" + name] = True
    return inner


def numeral(text):
    fraction = Fraction(text)
    return mpf(fraction.numerator) / fraction.denominator


def is_numeral(e):
    return e[0] == "num" or e[0] == "neg" and is_numeral(e[1])
