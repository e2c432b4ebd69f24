"""Integrals by weighted sums of values, of numbers and of numbers with derivatives.

The interval is cut at a place without symmetry, so that values on both sides of a pole do not cancel. Each part is
summed by the rules of Gauss with 12, 24 and 48 places. Two rules in a row that agree give the value. For a root at an
end, the rule of Takahasi and Mori stands behind them. The places are a + (b - a)·t, so that derivatives by the ends and
by what the integrand holds come with the sum.
"""

from functools import cache

import mpmath
from mpmath import mpf

from dual import CLEAR, Unclear, real

CUT = mpf("0.3819")
AGREE = CLEAR * mpf("1e-8")
# Places nearer to an end are moved here: at the end of a root, values would be too close to 0 to be told from it.
NEAREST = mpf("1e-30")


@cache
def rules():
    """Lists of places between 0 and 1 with their weights."""
    gauss, ends = mpmath.calculus.quadrature.GaussLegendre(mpmath.mp), mpmath.calculus.quadrature.TanhSinh(mpmath.mp)
    found = [gauss.calc_nodes(degree, mpmath.mp.prec) for degree in (3, 4, 5)]
    long = []
    for degree in range(1, 8):
        long = long + list(ends.calc_nodes(degree, mpmath.mp.prec))
        if degree >= 6:
            found.append([(x, w * mpf(2) ** -degree) for x, w in long])
    return [[((1 + x) / 2, w / 2) for x, w in places] for places in found]


def quadrature(f, low, high):
    """The integral of f from `low` to `high`; raises `Unclear` where the sums do not settle."""
    f(low), f(high)
    middle = low + (high - low) * CUT
    return part(f, low, middle) + part(f, middle, high)


def part(f, low, high):
    width, before = high - low, None
    for places in rules():
        total = mpf(0)
        for t, weight in places:
            t = min(max(t, NEAREST), 1 - NEAREST)
            total = total + f(low + width * t) * weight
        if before is not None and agree(total, before):
            return total * width
        before = total
    raise Unclear


def agree(x, y):
    """Whether two sums are the same in their values and all their derivatives."""
    gap = x - y
    parts = [gap]
    while parts:
        at = parts.pop()
        if hasattr(at, "tag"):
            parts += [at.a, at.b]
        elif abs(at) > AGREE:
            return False
    return True
