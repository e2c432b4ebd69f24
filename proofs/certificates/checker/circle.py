"""Cosines and sines of sums of angles, exactly: section 14.5 of docs/certificates.md.

A letter is (rank, name): the name of a cosine, of a sine, the roots of 2, 3 and 5, √(2 + √2) and √(10 − 2·√5). A polynomial is
{monomial: number}, a monomial the sorted tuple of (letter, exponent). A point is a cosine and a sine.
"""
from fractions import Fraction as Q

from .claims import compare, N, num, room

COSINE, SINE, ROOT, EIGHTH, FIFTH = range(5)
TWO, THREE, FIVE = ((ROOT, p) for p in (2, 3, 5))
# What the square of a letter is: a number, and a number times a root.
SQUARES = {TWO: (2, 0, None), THREE: (3, 0, None), FIVE: (5, 0, None), (EIGHTH, 0): (2, 1, TWO), (FIFTH, 0): (10, -2, FIVE)}
MULTIPLE_LIMIT, TERMS_LIMIT = 24, 10_000
TURNED = {"<": ">", "<=": ">=", ">": "<", ">=": "<="}


def add(p, monomial, c):
    """Adds a term to p; the squares of roots are put in."""
    square = next((letter for letter, k in monomial if k >= 2 and letter in SQUARES), None)
    if square is None:
        p[monomial] = p.get(monomial, 0) + c
        if not p[monomial]:
            del p[monomial]
        return
    number, times, root = SQUARES[square]
    rest = tuple((letter, k - 2 * (letter == square)) for letter, k in monomial if (letter, k) != (square, 2))
    add(p, rest, c * number)
    if root:
        add(p, product_of(rest, ((root, 1),)), c * times)


def product_of(m, n):
    powers = dict(m)
    for letter, k in n:
        powers[letter] = powers.get(letter, 0) + k
    return tuple(sorted(powers.items()))


def combined(*parts):
    """The sum of c·p·q for (c, p, q)."""
    out = {}
    for c, p, q in parts:
        for m, a in p.items():
            for n, b in q.items():
                add(out, product_of(m, n), c * a * b)
    return out


def polynomial(*terms):
    out = {}
    for c, *letters in terms:
        add(out, tuple(sorted((letter, 1) for letter in letters)), Q(c))
    return out


UNIT = polynomial((1,))
ZERO = (UNIT, {})
TWELFTH = (polynomial((Q(1, 4), TWO, THREE), (Q(1, 4), TWO)), polynomial((Q(1, 4), TWO, THREE), (Q(-1, 4), TWO)))
EIGHTH_TURN = (polynomial((Q(1, 2), (EIGHTH, 0))), polynomial((Q(1, 2), TWO, (EIGHTH, 0)), (Q(-1, 2), (EIGHTH, 0))))
FIFTH_TURN = (polynomial((Q(1, 4),), (Q(1, 4), FIVE)), polynomial((Q(1, 4), (FIFTH, 0))))


def named(cos, sin):
    """The point whose cosine and sine have these names."""
    return polynomial((1, (COSINE, cos))), polynomial((1, (SINE, sin)))


def opposite(point):
    return point[0], combined((-1, point[1], UNIT))


def together(u, v):
    """The cosine and the sine of a sum."""
    terms = (len(u[0]) + len(u[1])) * (len(v[0]) + len(v[1]))
    room(terms <= TERMS_LIMIT, "a cosine or sine of a sum needs too many products")
    return combined((1, u[0], v[0]), (-1, u[1], v[1])), combined((1, u[1], v[0]), (1, u[0], v[1]))


def multiple(point, k):
    room(abs(k) <= MULTIPLE_LIMIT, f"an angle is multiplied by {k}")
    out = ZERO
    for _ in range(abs(k)):
        out = together(out, point)
    return opposite(out) if k < 0 else out


def of_turns(turns):
    """The cosine and the sine of so many times π; None where it is no multiple of π/120."""
    m = turns * 120
    if m.denominator != 1:
        return None
    c, b = next((c, b) for c in range(10) for b in range(16) if (m - 15 * b - 24 * c) % 10 == 0)
    a = int((m - 15 * b - 24 * c) / 10) % 24
    return together(together(multiple(TWELFTH, a), multiple(EIGHTH_TURN, b)), multiple(FIFTH_TURN, c))


def written(p):
    """The polynomial over its common denominator."""
    below = max((c.denominator for c in p.values()), default=1)
    terms = [(c < 0, term(m, abs(c) * below)) for m, c in sorted(p.items())]
    terms.sort(key=lambda t: t[0])
    minus = bool(terms) and terms[0][0]
    summands = tuple((-1 if negative and not minus else 1, e) for negative, e in terms)
    e = N("sum", summands) if len(summands) > 1 else summands[0][1] if summands else num(0)
    e = e if below == 1 else N("prod", (("*", e), ("/", num(below))))
    return N("neg", e) if minus else e


def term(monomial, c):
    """A positive number times a monomial; the roots of whole numbers come last, as one root."""
    factors, radicand = [], 1
    for (kind, letter), k in monomial:
        if kind == ROOT:
            radicand *= letter
            continue
        base = N("name", letter) if kind in (COSINE, SINE) else NESTED[kind]
        factors.append(base if k == 1 else N("pow", base, num(k)))
    if radicand > 1:
        factors.append(root(num(radicand)))
    if c != 1 or not factors:
        factors.insert(0, num(c))
    return factors[0] if len(factors) == 1 else N("prod", tuple(("*", f) for f in factors))


def root(e):
    return N("call", "sqrt", (e,))


NESTED = {EIGHTH: root(N("sum", ((1, num(2)), (1, root(num(2)))))),
          FIFTH: root(N("sum", ((1, num(10)), (-1, N("prod", (("*", num(2)), ("*", root(num(5)))))))))}


def sign_of_sine(point, relation):
    """The sine compared with 0, over what is positive in all its terms."""
    sine = dict(point[1])
    for letter in (TWO, THREE, FIVE):
        if all((letter, 1) in m for m in sine):
            sine = {tuple(part for part in m if part != (letter, 1)): c for m, c in sine.items()}
    turned = bool(sine) and all(c < 0 for c in sine.values())
    scale = max((c.denominator for c in sine.values()), default=1) * (-1 if turned else 1)
    sine = {m: c * scale for m, c in sine.items()}
    return compare(written(sine), TURNED[relation] if turned else relation, num(0))
