"""Zeros of a function of one number between the points of a grid."""

import mpmath
from mpmath import mpf

from dual import ZERO, Unclear, Undefined


def crossings(gap, grid):
    """The zeros that a grid shows, and how near to 0 the function comes; None for that where it cannot be told."""
    found = []
    try:
        known = [(v, gap(v)) for v in grid]
    except (Undefined, Unclear):
        return [], None
    least = min(abs(g) for _, g in known)
    found += [v for v, g in known if abs(g) <= ZERO]
    for (v, g), (w, h) in zip(known, known[1:]):
        if g * h < 0 and abs(g) > ZERO and abs(h) > ZERO:
            zero = bisected(gap, v, w)
            if zero is None:
                # It jumps, or has a pole.
                return found, None
            found.append(zero)
    for (u, f), (_, g), (w, h) in zip(known, known[1:], known[2:]):
        if abs(g) <= min(abs(f), abs(h)) and f * g > 0 and g * h > 0:
            try:
                least = min(least, dip(gap, u, w))
            except (Undefined, Unclear):
                return found, None
    return found, least


def dip(gap, low, high):
    """How near to 0 a function comes between two places, by thirds of the interval."""
    least = None
    for _ in range(30):
        a, b = low + (high - low) / 3, high - (high - low) / 3
        s, t = abs(gap(a)), abs(gap(b))
        low, high = (low, b) if s < t else (a, high)
        least = min(s, t) if least is None else min(least, s, t)
    return least


def bisected(gap, low, high):
    """A zero between two places with opposite signs; None where there is none."""
    try:
        zero = mpmath.findroot(gap, (low, high), solver="anderson", tol=mpf(10) ** -140, maxsteps=400, verify=False)
        return zero if abs(gap(zero)) < ZERO else None
    except (Undefined, Unclear, ValueError, ZeroDivisionError):
        return None
