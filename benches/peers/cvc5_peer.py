"""cvc5 (nonlinear real arithmetic). Tried: incremental linearisation (the default), `nl-cov` (cylindrical coverings over
libpoly) with and without `nl-ext=none`: coverings alone are the fastest."""
import math

import cvc5
from cvc5 import Kind

import peer


class Query:
    def __init__(self):
        self.solver = cvc5.Solver()
        self.solver.setLogic("QF_NRA")
        self.solver.setOption("nl-cov", "true")
        self.solver.setOption("nl-ext", "none")

    def number(self, x):
        return self.solver.mkReal(x.numerator, x.denominator) if hasattr(x, "numerator") else self.solver.mkReal(x)

    def call(self, kind, *terms):
        return self.solver.mkTerm(kind, *terms)

    def power(self, x, k):
        return self.call(Kind.MULT, *([x] * k)) if k > 1 else x

    def one_plus(self, x):
        return self.call(Kind.ADD, self.number(1), x)

    def unknown(self):
        return self.solver.mkConst(self.solver.getRealSort(), "t")

    def impossible(self, *conditions):
        for condition in conditions:
            self.solver.assertFormula(condition)
        return self.solver.checkSat().isUnsat()


def impossible_sign(kind, n, e, r):
    q = Query()
    t, zero = q.unknown(), q.number(0)
    given = [q.call(Kind.GT, t, zero), q.call(Kind.EQUAL, q.power(t, n * (n + 1)), q.number(r))]
    left = q.call(Kind.MULT, q.number(1 + e), q.power(q.one_plus(q.power(t, n + 1)), n))
    d = q.call(Kind.SUB, left, q.power(q.one_plus(q.power(t, n)), n + 1))
    wrong = q.call(Kind.DISTINCT, d, zero) if kind is None else q.call(kind, d, zero)
    return q.impossible(*given, wrong)


def j4(work):
    for case, n, e, r in peer.signs(work):
        def sign():
            if impossible_sign(None, n, e, r):
                return 0
            return 1 if impossible_sign(Kind.LT, n, e, r) else -1

        yield case, sign, str


def j5(work):
    for n in range(1, 25):
        def proved():
            q = Query()
            y = q.unknown()
            lcm = math.lcm(n, n + 1, n + 2)
            a, b, c = (q.power(q.one_plus(q.power(y, lcm // k)), k) for k in (n, n + 1, n + 2))
            below = q.call(Kind.LT, q.call(Kind.MULT, a, c), q.call(Kind.MULT, b, b))
            return q.impossible(q.call(Kind.GT, y, q.number(0)), below)

        yield str(n), proved, lambda ok: str(ok).lower()


if __name__ == "__main__":
    peer.run({"J4": j4, "J5": j5})
