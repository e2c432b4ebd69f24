"""SymPy. J1 twice: `simplify` as people write it (`benches/sympy_identities.py`), and the sparse fields of
`sympy.polys`, which are much faster. J5 twice: roots counted, and the coefficients that a reader of the paper would
look at. Tried and not taken: `minimal_polynomial` for J4 (minutes from n = 3 on), `Expr.equals` (slower than sign).
"""
import functools
import sys
from pathlib import Path

import sympy as sp
from sympy.polys.fields import field

import identities
import peer

sys.path.append(str(Path(__file__).resolve().parent.parent))


def j1_simplify(work):
    import sympy_identities

    def compute():
        sp.core.cache.clear_cache()
        return all(check() for check in sympy_identities.CHECKS.values())

    yield "19 identities", compute, lambda ok: str(ok).lower()


def j1(work):
    generators = field(identities.NAMES, sp.ZZ)
    rational_functions, variables = generators[0], dict(zip(identities.NAMES, generators[1:]))
    slope = lambda f, name: f.diff(variables[name])
    ring = identities.Ring(variables, rational_functions, lambda a, b: a == b, slope)
    yield "19 identities", lambda: all(check(ring) for check in identities.CHECKS), lambda ok: str(ok).lower()


def j4(work):
    for case, n, e, r in peer.signs(work):
        e, r = sp.Rational(e), sp.Rational(r)

        def sign():
            sp.core.cache.clear_cache()
            l = (1 + r ** sp.Rational(1, n + 1)) ** (n + 1) / (1 + r ** sp.Rational(1, n)) ** n - 1
            return sp.sign(e - l)

        yield case, sign, str


def difference(n):
    """A_n·A_(n+2) − A_(n+1)², divided by the power of y in it."""
    y = sp.Symbol("y")
    lcm = sp.ilcm(n, n + 1, n + 2)
    a, b, c = (sp.Poly(1 + y ** (lcm // k), y) ** k for k in (n, n + 1, n + 2))
    return (a * c - b * b).terms_gcd()[1], sp.Poly((y - 1) ** 2, y)


def j5_roots(work):
    """No positive root after (y − 1)² is divided out, and positive at 1."""
    for n in range(1, 25):
        def proved():
            p, square = difference(n)
            q = p.exquo(square)
            return q.count_roots(0, None) == 0 and q.eval(1) > 0

        yield str(n), proved, lambda ok: str(bool(ok)).lower()


def j5(work):
    for n in range(1, 25):
        def proved():
            p, square = difference(n)
            return min(p.exquo(square).all_coeffs()) >= 0

        yield str(n), proved, lambda ok: str(bool(ok)).lower()


if __name__ == "__main__":
    peer.run({"J1": j1, "J1-simplify": j1_simplify, "J4": j4, "J5": j5, "J5-roots": j5_roots})
