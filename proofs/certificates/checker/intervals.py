"""Intervals of atoms and of polynomials, from bounds among the known facts: section 6 of docs/certificates.md.

An end is (p, q, open): the number p + q·π, and whether it is not reached. None: no end. An interval is its low and its high end.
It says that a number lies between its ends, and is no open one.
"""
from fractions import Fraction as Q
from functools import reduce

ABOUT_PI = Q("3.14159265358979323846"), Q("3.14159265358979323847")
LONGEST = 10_000
OPEN, REACHED, NONE = (Q(0), Q(0), True), (Q(0), Q(0), False), (None, None)
ONE, PI = ((Q(1), Q(0), False),) * 2, ((Q(0), Q(1), False),) * 2
QUARTERS = ((Q(0), Q(-1, 2), False), (Q(0), Q(1, 2), False))
INSIDE_QUARTERS = tuple((*end[:2], True) for end in QUARTERS)
TURNING, NATURAL, ABOVE = ((Q(-1), Q(0), False), ONE[1]), (REACHED, None), (OPEN, None)
# The interval of a set of signs: 1 for negative, 2 for zero, 4 for positive. Facts that contradict each other leave none.
OF_SIGNS = {0: (OPEN, OPEN), 1: (None, OPEN), 2: (REACHED, REACHED), 3: (None, REACHED), 4: ABOVE, 6: NATURAL}


def order(p, q):
    """Whether p + q·π is below 0, 0 or above, as -1, 0 or 1. None: the digits of π here do not tell."""
    signs = {(r > 0) - (r < 0) for r in ((p + q * pi for pi in ABOUT_PI) if q else (p,))}
    return signs.pop() if len(signs) == 1 else None


def bits(q):
    return max(q.numerator.bit_length(), q.denominator.bit_length())


def scaled(x, c):
    """c·x for a number c that is not 0."""
    ends = tuple(end and (c * end[0], c * end[1], end[2]) for end in x)
    return ends if c > 0 else ends[::-1]


def plus(x, y):
    """A sum reaches an end only where both summands reach theirs."""
    return tuple(a and b and (a[0] + b[0], a[1] + b[1], a[2] or b[2]) for a, b in zip(x, y))


def both(x, y):
    """What lies in two intervals: of two ends the inner one, of equal ones the open one."""
    def inner(old, new, side):
        if not old or not new:
            return old or new
        way = order(new[0] - old[0], new[1] - old[1])
        return (*old[:2], old[2] or new[2]) if way == 0 else new if way == side else old
    return inner(x[0], y[0], 1), inner(x[1], y[1], -1)


def rational(x):
    """With rational ends farther out. They are not reached, since π is irrational."""
    def end(e, outward):
        return (e[0] + e[1] * ABOUT_PI[(e[1] > 0) == (outward > 0)], Q(0), True) if e and e[1] else e
    return end(x[0], -1), end(x[1], 1)


def is_not_negative(x):
    return x[0] is not None and x[0][0] >= 0


def power(x, k):
    """x^k for rational ends. It rises where k is odd or x is not negative, and falls where k is even and x not positive. Else
    it is not negative, and no greater than at the end farther from 0."""
    def raised(end):
        return end and (end[0] ** k, Q(0), end[2]) if end and bits(end[0]) * k <= LONGEST else None
    if k == 1:
        return x
    if k % 2 or is_not_negative(x):
        return tuple(map(raised, x))
    if is_not_negative(scaled(x, -1)):
        return tuple(map(raised, x[::-1]))
    return REACHED, None not in x and raised(max(x, key=lambda end: (abs(end[0]), not end[2]))) or None


def product(x, y):
    """x·y for rational ends. For a fixed y it is linear in x, and the other way round: so its least value and its greatest are
    those at corners. One is reached elsewhere only if x or y is 0, and not at an open end of it: then x·y is 0."""
    def corner(a, b):
        is_reached = not (a[2] or b[2]) or any(end[0] == 0 and not end[2] for end in (a, b))
        value = a[0] * b[0]
        return None if bits(value) > LONGEST else (value, Q(0), not is_reached)
    if None not in (*x, *y):
        corners = [corner(a, b) for a in x for b in y]
        if None in corners:
            return NONE
        return min(corners, key=lambda c: (c[0], c[2])), max(corners, key=lambda c: (c[0], not c[2]))
    turned = 1
    for z in (x, y):
        if not is_not_negative(z):
            turned = -turned
            if not is_not_negative(scaled(z, -1)):
                return NONE
    x, y = (z if is_not_negative(z) else scaled(z, -1) for z in (x, y))
    return scaled(tuple(a and b and corner(a, b) for a, b in zip(x, y)), turned)


def signs_within(x):
    """The signs of the numbers of an interval."""
    out = 7
    for end, side, beyond in ((x[0], 1, 4), (x[1], -1, 1)):
        way = order(*end[:2]) if end else None
        if way == side or way == 0:
            out &= beyond | (2 if way == 0 and not end[2] else 0)
    return out


class Bounds:
    """Which noted signs bound which atoms, and the intervals that follow."""

    def __init__(self, other=None):
        # By atom: the polynomials in which it is one term, with a number, and occurs in no other.
        self.of = {a: list(ps) for a, ps in other.of.items()} if other else {}
        self.ends = {}

    def note(self, p, is_new):
        """The sign of p is noted, or more of it."""
        self.ends.clear()
        if is_new and len(p) <= 4:
            atoms = [a for m, _ in p for a, _ in m]
            for m, c in p:
                if len(m) == 1 and m[0][1] == 1 and atoms.count(m[0][0]) == 1:
                    self.of.setdefault(m[0][0], []).append((p, m, c))


class Intervals:
    """Intervals at the point of which the facts speak."""

    def form(self, a):
        kind = self.atoms[a][0]
        if kind in ("arctangent", "arcsine"):
            return QUARTERS if kind == "arcsine" else INSIDE_QUARTERS
        if kind in ("cos", "sin", "pi"):
            return PI if kind == "pi" else TURNING
        return ABOVE if kind == "exp" else NATURAL if self.is_natural(a) else NONE

    def atom_interval(self, a, known, deep=4):
        """A bound s = c·x + r, of which the sign is known, gives x = (s − r)/c. What r is, other bounds may tell, four deep. All
        of them are true, so a bound that comes back to x does no harm. The index of a range stands for other numbers as well,
        of which the facts say nothing: it is natural."""
        if (a, deep) not in known.bounds.ends:
            out = self.form(a)
            for p, m, c in known.bounds.of.get(a, ()) if deep and all(a != r[0] for r in known.ranges) else ():
                s = OF_SIGNS.get(known.notes[p])
                # An equation of several terms is put in, it bounds nothing.
                if s and not (known.notes[p] == 2 and len(p) > 1):
                    r = self.interval([term for term in p if term[0] != m], known, deep - 1)
                    out = both(out, scaled(plus(s, scaled(r, Q(-1))), Q(1, c)))
            known.bounds.ends[a, deep] = out
        return known.bounds.ends[a, deep]

    def interval(self, terms, known, deep=4):
        """The interval of a polynomial."""
        out = (REACHED, REACHED)
        for m, c in terms:
            if not c:
                continue
            if len(m) == 1 and m[0][1] == 1:
                term = self.atom_interval(m[0][0], known, deep)
            else:
                parts = [power(rational(self.atom_interval(a, known, deep)), k) for a, k in m]
                term = reduce(product, parts) if parts else ONE
            out = plus(out, scaled(term, Q(c)))
            if out == NONE:
                break
        return out

    def interval_signs(self, terms, known):
        """The signs that the interval of a polynomial leaves: of one atom with other terms, or of cosines, sines, arcs and π, but
        not where a fact is noted; and in the arguments of cosines and sines."""
        terms = list(terms)
        atoms = {a for m, _ in terms for a, _ in m}
        turns = any(self.atoms[a][0] in ("cos", "sin", "pi", "arctangent", "arcsine") for a in atoms)
        if not self.arguments and (self.noting or not (turns or len(atoms) == 1 and len(terms) > 1)):
            return 7
        return signs_within(self.interval(terms, known))
