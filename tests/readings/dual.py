"""Numbers with derivatives: a + b·ε with ε² = 0, where each derivative that is taken has an ε of its own.

A `Dual` has the tag of its ε; a and b are numbers, or duals of smaller tags. Every function here takes numbers (`mpf`)
and duals. `Undefined` means that there is certainly no value, `Unclear` that the question is too close to decide.
Numbers have `DIGITS` digits. What is below `ZERO` counts as 0; what is above `CLEAR` does not.
"""

import itertools

import mpmath
from mpmath import mpf

DIGITS = 80
mpmath.mp.dps = DIGITS
ZERO, CLEAR = mpf(10) ** -55, mpf(10) ** -35
HUGE = mpf(10) ** 6

new_tag = itertools.count(1).__next__


class Undefined(Exception):
    """The expression certainly has no value here."""


class Unclear(Exception):
    """The evaluator cannot tell."""


class Dual:
    """a + b·ε"""

    __slots__ = ("tag", "a", "b")

    def __init__(self, tag, a, b):
        self.tag, self.a, self.b = tag, a, b

    def __neg__(self):
        return Dual(self.tag, -self.a, -self.b)

    def __add__(self, other):
        a, b = split(other, self.tag)
        if b is None:
            return NotImplemented if a is None else Dual(self.tag, self.a + a, self.b)
        return Dual(self.tag, self.a + a, self.b + b)

    def __sub__(self, other):
        return self + (-other)

    def __rsub__(self, other):
        return (-self) + other

    def __mul__(self, other):
        a, b = split(other, self.tag)
        if b is None:
            return NotImplemented if a is None else Dual(self.tag, self.a * a, self.b * a)
        return Dual(self.tag, self.a * a, self.a * b + self.b * a)

    __radd__ = __add__
    __rmul__ = __mul__


def split(x, tag):
    """The parts of a number for a tag; no second part where it has none, and neither where its tag is larger."""
    if isinstance(x, Dual):
        if x.tag == tag:
            return x.a, x.b
        if x.tag > tag:
            return None, None
    return x, None


def real(x):
    """The value without derivatives."""
    while isinstance(x, Dual):
        x = x.a
    return x


def slope(x, tag):
    """The factor of ε of this tag."""
    if isinstance(x, list):
        return [[slope(entry, tag) for entry in row] for row in x]
    return x.b if isinstance(x, Dual) and x.tag == tag else mpf(0)


def moves(x):
    """Whether any derivative of a number is other than 0."""
    return isinstance(x, Dual) and (moves(x.a) or moves(x.b) or abs(real(x.b)) > CLEAR)


def is_zero(x):
    """Whether a number is 0; raises `Unclear` where it is too close."""
    size = abs(real(x))
    if size >= CLEAR:
        return False
    if size <= ZERO:
        return True
    raise Unclear


def divide(x, y):
    if is_zero(y):
        raise Undefined
    return x * inverse(y)


def inverse(y):
    if not isinstance(y, Dual):
        return 1 / y
    over = inverse(y.a)
    return Dual(y.tag, over, -(y.b * over * over))


def apply(x, function, derivative):
    """A differentiable function; `derivative` gives its derivative and takes duals, too."""
    if isinstance(x, Dual):
        return Dual(x.tag, apply(x.a, function, derivative), derivative(x.a) * x.b)
    return function(x)


def exp(x):
    if abs(real(x)) > HUGE:
        raise Unclear
    return apply(x, mpmath.exp, exp)


def sin(x):
    return apply(x, mpmath.sin, cos)


def cos(x):
    return apply(x, mpmath.cos, lambda a: -sin(a))


def tan(x):
    return divide(sin(x), cos(x))


def arctan(x):
    return apply(x, mpmath.atan, lambda a: inverse(1 + a * a))


def arcsin(x):
    """At 1 and -1 an arcsin has no derivative. What is too near to them is taken for them, as under a root."""
    room = (1 - x) * (1 + x)
    if is_zero(room):
        if isinstance(x, Dual):
            if moves(x):
                raise Undefined
            raise Unclear
        return mpmath.sign(x) * mpmath.pi / 2
    if real(room) < 0:
        raise Undefined
    return apply(x, mpmath.asin, lambda a: inverse(root((1 - a) * (1 + a), 2)))


def arccos(x):
    return mpmath.pi / 2 - arcsin(x)


def ln(x):
    if is_zero(x) or real(x) < 0:
        raise Undefined
    return apply(x, mpmath.log, inverse)


def root(x, k):
    """The k-th root of what is at least 0. At 0 a root has no derivative."""
    if is_zero(x):
        if isinstance(x, Dual):
            if moves(x):
                raise Undefined
            raise Unclear
        return mpf(0)
    if real(x) < 0:
        raise Undefined
    if isinstance(x, Dual):
        return exp(ln(x) * (mpf(1) / k))
    return mpmath.sqrt(x) if k == 2 else mpmath.root(x, k)


def size(x):
    """|x|, which has no derivative at 0."""
    if is_zero(x):
        if isinstance(x, Dual):
            if moves(x):
                raise Undefined
            raise Unclear
        return mpf(0)
    return -x if real(x) < 0 else x


def cosh(x):
    return (exp(x) + exp(-x)) * mpf("0.5")


def sinh(x):
    return (exp(x) - exp(-x)) * mpf("0.5")


def tanh(x):
    return divide(sinh(x), cosh(x))


def sech(x):
    return inverse(cosh(x))


def largest(values):
    out = values[0]
    for other in values[1:]:
        out = (out + other + size(out - other)) * mpf("0.5")
    return out


def whole_part(x):
    """floor(x); it has no derivative at a whole number."""
    value = real(x)
    near = mpmath.nint(value)
    if abs(value - near) <= ZERO:
        if isinstance(x, Dual) and moves(x):
            raise Undefined
        return near
    if abs(value - near) < CLEAR:
        raise Unclear
    return mpmath.floor(value)


def whole(x):
    """A whole number as an `int`; raises `Undefined` for any other number."""
    if isinstance(x, Dual):
        if moves(x):
            raise Unclear
        x = real(x)
    near = mpmath.nint(x)
    if abs(x - near) <= ZERO:
        return int(near)
    if abs(x - near) < CLEAR:
        raise Unclear
    raise Undefined


def whole_power(x, n):
    """xⁿ for a whole number n. Anything to the power 0 is 1."""
    if n < 0:
        return divide(mpf(1), whole_power(x, -n)) if not is_zero(x) else divide(mpf(1), x)
    if n > 10**6 and not isinstance(x, Dual):
        return far_power(x, n)
    if n > 10**6:
        raise Unclear
    if not isinstance(x, Dual):
        return x**n
    out, square = mpf(1), x
    while n:
        if n & 1:
            out = out * square
        n >>= 1
        if n:
            square = square * square
    return out


def far_power(x, n):
    """A power to more than a million, where its value can be written."""
    magnitude = abs(x)
    sign = -1 if x < 0 and n % 2 else 1
    if magnitude <= ZERO:
        return mpf(0)
    if abs(magnitude - 1) <= ZERO:
        return mpf(sign)
    if abs(mpmath.log(magnitude) * n) > HUGE:
        raise Unclear
    return sign * mpmath.exp(mpmath.log(magnitude) * n)


def real_power(x, e):
    """x^e for an exponent that is not whole by its form: x has to be positive."""
    if is_zero(x) or real(x) < 0:
        raise Undefined
    return exp(ln(x) * e)
