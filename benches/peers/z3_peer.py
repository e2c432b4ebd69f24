"""Z3 (nonlinear real arithmetic). J4 twice: the solver asked which sign is impossible, and Z3's algebraic numbers.

Tried: default solver, `qfnra-nlsat`, `smt` and `simplify; propagate-values; qfnra-nlsat`. nlsat alone is the fastest on
both jobs. With t = r^(1/(n(n+1))) as the only unknown it is faster than with two roots.
"""
import math

import z3

import peer


def solver():
    return z3.Tactic("qfnra-nlsat").solver()


def impossible(*conditions):
    s = solver()
    s.add(*conditions)
    return s.check() == z3.unsat


def j4(work):
    for case, n, e, r in peer.signs(work):
        def sign():
            t = z3.Real("t")
            r_q, e_q = z3.Q(r.numerator, r.denominator), z3.Q(e.numerator, e.denominator)
            given = [t > 0, t ** (n * (n + 1)) == r_q]
            d = (1 + e_q) * (1 + t ** (n + 1)) ** n - (1 + t**n) ** (n + 1)
            if impossible(*given, d != 0):
                return 0
            return 1 if impossible(*given, d < 0) else -1

        yield case, sign, str


def j4_numbers(work):
    """z3num: algebraic numbers with exact comparison."""
    from z3.z3num import Numeral

    for case, n, e, r in peer.signs(work):
        def sign():
            a, b = (Numeral(str(r)).root(k) for k in (n + 1, n))
            one = Numeral(1)
            d = (one + Numeral(str(e))) * (one + b) ** n - (one + a) ** (n + 1)
            return (d > 0) - (d < 0)

        yield case, sign, str


def j5(work):
    for n in range(1, 25):
        def proved():
            y = z3.Real("y")
            lcm = math.lcm(n, n + 1, n + 2)
            a, b, c = ((1 + y ** (lcm // k)) ** k for k in (n, n + 1, n + 2))
            return impossible(y > 0, a * c < b * b)

        yield str(n), proved, lambda ok: str(ok).lower()


if __name__ == "__main__":
    peer.run({"J4": j4, "J4-numbers": j4_numbers, "J5": j5})
