"""python-flint: exact polynomials and rationals, Arb's balls, qqbar through the generic rings.

Tried and not taken: a root by exp(log/k) (4 times slower at 10^5 digits than `root`), one 56th root instead of an
eighth and a seventh (twice as slow), `root(8)` instead of three square roots (twice as slow), `**` for a power of two
instead of squarings.
"""
import functools

from flint import arb, ctx, fmpq, fmpq_mpoly_ctx, fmpz, fmpz_mpoly_ctx, fmpz_poly

import identities
import peer
from peer import BODIES, DIGITS, PRIME, SPARE


def quotient(x):
    return fmpq(x.numerator, x.denominator)


# J1: a rational function as a pair of polynomials, equal iff the cross product vanishes. No gcd is ever needed.
class Quotient:
    def __init__(self, up, down):
        self.up, self.down = up, down

    def __add__(self, other):
        if self.down == other.down:
            return Quotient(self.up + other.up, self.down)
        return Quotient(self.up * other.down + other.up * self.down, self.down * other.down)

    def __neg__(self):
        return Quotient(-self.up, self.down)

    def __sub__(self, other):
        return self + -other

    def __mul__(self, other):
        return Quotient(self.up * other.up, self.down * other.down)

    def __truediv__(self, other):
        return Quotient(self.up * other.down, self.down * other.up)

    def __pow__(self, k):
        return Quotient(self.up**k, self.down**k)

    def derivative(self, name):
        up, down = self.up, self.down
        return Quotient(up.derivative(name) * down - up * down.derivative(name), down * down)


def same(a, b):
    return a.up * b.down == b.up * a.down


def ring(kind):
    names = identities.NAMES
    context = {"fmpz": fmpz_mpoly_ctx, "fmpq": fmpq_mpoly_ctx}[kind].get(names, "degrevlex")
    variables = {name: Quotient(g, g**0) for name, g in zip(names, context.gens())}
    one = variables["x"].up ** 0
    number = lambda k: Quotient(k * one, one)
    return identities.Ring(variables, number, same, lambda f, name: f.derivative(name))


def holds(ring):
    return all(check(ring) for check in identities.CHECKS)


def j1(kind):
    def job(work):
        compute = lambda: holds(ring(kind))
        yield "19 identities", compute, lambda ok: str(ok).lower()

    return job


def eta(e, r, n):
    """The t-form at the context's precision."""
    t = r.root(n)
    return (e * e * t / (1 + t) ** 2) ** n


def j2a(work):
    import numpy

    ctx.prec = 64
    e, r, n = numpy.fromfile(work / "J2a.bin").reshape(3, -1)
    cells = [(arb(1) + arb(a), arb(b), int(c)) for a, b, c in zip(e.tolist(), r.tolist(), n.tolist())]
    out = []

    def answer(_):
        ends = [(float(x.lower()), float(x.upper())) for x in out]
        # float() rounds to nearest: a step outwards.
        a = numpy.array(ends)
        return peer.ends(work, "J2a-flint", numpy.nextafter(a[:, 0], 0), numpy.nextafter(a[:, 1], 2))

    def compute():
        out[:] = [eta(*cell) for cell in cells]

    yield "one of 100000 cells", compute, answer, len(cells)


def j10(work):
    import numpy

    # The numbers go in as they are written down: integers and a fraction.
    def call():
        ctx.prec = 64
        return eta(1 + arb(fmpq(9, 10)), arb(fmpq(10, 1)), 8)

    def doubles(x):
        return float(x.lower()), float(x.upper())

    def answer(name, low, high):
        return peer.ends(work, f"J10-flint-{name}", numpy.nextafter(low, 0), numpy.nextafter(high, 2))

    yield "one call", call, lambda x: answer("one", [float(x.lower())], [float(x.upper())])
    yield "one call, two doubles", lambda: doubles(call()), lambda x: answer("two", [x[0]], [x[1]])
    e, r, n = numpy.fromfile(work / "J2a.bin").reshape(3, -1)

    def rows():
        ctx.prec = 64
        low, high = numpy.empty(len(e)), numpy.empty(len(e))
        for i, (a, b, c) in enumerate(zip(e.tolist(), r.tolist(), n.tolist())):
            low[i], high[i] = doubles(eta(1 + arb(a), arb(b), int(c)))
        return low, high

    yield "one of 100000 rows", rows, lambda x: answer("rows", *x), len(e)


def j2b(work):
    import numpy

    ctx.prec = 64
    e, r = numpy.fromfile(work / "J2b.bin").reshape(2, -1).tolist()
    out = []

    def compute():
        a = [((1 + arb(x)) / 2) ** 16 for x in e]
        roots = [arb(x).root(8) for x in r]
        b = [(4 * t / (1 + t) ** 2) ** 8 for t in roots]
        out[:] = [x * y for x in a for y in b]

    def answer(_):
        a = numpy.array([(float(x.lower()), float(x.upper())) for x in out])
        return peer.ends(work, "J2b-flint", numpy.nextafter(a[:, 0], 0), numpy.nextafter(a[:, 1], 2))

    yield "one of 1000000 cells", compute, answer, len(e) * len(r)


def floor_remainder(x, places):
    scaled = (x * arb(10) ** places).floor().unique_fmpz()
    return str(int(scaled % fmpz(PRIME)))


def j3(work):
    for count in DIGITS:
        def set_precision(extra=40, count=count):
            ctx.prec = int(count * 3.3219280948874) + extra

        def eta_digits():
            set_precision()
            t = arb(10).sqrt().sqrt().sqrt()
            y = t / (1 + t) ** 2
            for _ in range(3):
                y = y * y
            return y * (fmpz(19) ** 16) / fmpz(10) ** 16

        def l_digits():
            set_precision()
            a = 1 + arb(10).sqrt().sqrt().sqrt()
            for _ in range(3):
                a = a * a
            b = 1 + arb(10).root(7)
            c = b * b
            return a / (c * c * c * b) - 1

        for name, compute in (("eta", eta_digits), ("L_7", l_digits)):
            yield f"{name}/{count}", compute, lambda x, count=count: floor_remainder(x, count - SPARE)


def sign_by_balls(n, e, r):
    """The best user's way: exact where r is an n(n+1)-th power, balls of growing precision otherwise."""
    k = n * (n + 1)
    p, q = fmpz(r.p).root(k), fmpz(r.q).root(k)
    if p**k == r.p and q**k == r.q:
        t = fmpq(p, q)
        difference = e + 1 - (1 + t**n) ** (n + 1) / (1 + t ** (n + 1)) ** n
        return (difference > 0) - (difference < 0)
    bits = 64
    while True:
        ctx.prec = bits
        difference = (1 + arb(r).root(n + 1)) ** (n + 1) / (1 + arb(r).root(n)) ** n - (1 + arb(e))
        if difference > 0:
            return -1
        if difference < 0:
            return 1
        bits *= 2


def j4(work):
    for case, n, e, r in peer.signs(work):
        e, r = quotient(e), quotient(r)
        yield case, functools.partial(sign_by_balls, n, e, r), str


def j4_qqbar(work):
    """The field of real algebraic numbers decides by itself."""
    from flint.types._gr import gr_real_qqbar_ctx

    field = gr_real_qqbar_ctx.new()
    for case, n, e, r in peer.signs(work):
        e, r = quotient(e), quotient(r)

        def sign():
            a, b = (field(r) ** field(fmpq(1, k)) for k in (n + 1, n))
            difference = field(e + 1) * (1 + b) ** n - (1 + a) ** (n + 1)
            return 0 if difference.is_zero() else 1 if difference.sgn().is_one() else -1

        yield case, sign, str


def j5(work):
    """L_(n+1) >= L_n as A_n·A_(n+2) − A_(n+1)² = y^k·(y−1)²·Q(y), Q without negative coefficients; exact."""
    y = fmpz_poly([0, 1])
    for n in range(1, 25):
        def proved():
            lcm = int(fmpz(n).lcm(fmpz(n + 1)).lcm(fmpz(n + 2)))
            a, b, c = ((1 + y ** (lcm // k)) ** k for k in (n, n + 1, n + 2))
            q, rest = divmod(a * c - b * b, (y - 1) ** 2)
            return rest == 0 and min(q.coeffs()) >= 0

        yield str(n), proved, lambda ok: str(ok).lower()


def product(factors):
    while len(factors) > 1:
        half = [a * b for a, b in zip(factors[::2], factors[1::2])]
        factors = half + factors[len(factors) & ~1 :]
    return factors[0]


def parts(v):
    return f"{int(v.p % PRIME)}/{int(v.q % PRIME)}"


def j6(work):
    chain = peer.chain(work, 1_000)
    masses = [fmpq(a, b) for a, b, _, _ in chain]
    restitutions = [fmpq(c, d) for _, _, c, d in chain]

    def everyone():
        v, out = fmpq(1), []
        for m1, m2, e in zip(masses, masses[1:], restitutions[1:]):
            total = m1 + m2
            out.append((m1 - e * m2) / total * v)
            v = m1 * (1 + e) / total * v
        return out + [v]

    yield "all/1000", everyone, lambda vs: peer.all_answer([(int(v.p), int(v.q)) for v in vs])
    for bodies in BODIES:
        rows = peer.chain(work, bodies, fmpz)

        def last():
            # m(1+e)/(m+m') with m = a/b, m' = c/d, e = p/q is a·d·(p+q) over (a·d + b·c)·q: one reduction at the end.
            up, down = [], []
            for (a, b, _, _), (c, d, p, q) in zip(rows, rows[1:]):
                ad = a * d
                up.append(ad * (p + q))
                down.append((ad + b * c) * q)
            return fmpq(product(up), product(down))

        yield f"last/{bodies}", last, parts


def j7(work):
    for case, r, e in peer.best(work):
        yield case, functools.partial(best, quotient(r), quotient(e)), str


def best(r, e):
    """The same guess as Carom's, from the continuous optimum, then two certified signs."""
    import math

    c = math.log1p(-float((1 - e) / 2)) * -1
    u = math.sqrt(2 * c)
    for _ in range(30):
        value = u * math.tanh(u) - math.log(math.cosh(u)) if u > 1e-2 else u * u / 2 - u**4 / 4
        u += (c - value) * math.cosh(u) ** 2 / u
    n = int(math.log(float(r)) / 2 / u - 0.5)
    while not helps(n, e, r):
        n -= 1
    while helps(n + 1, e, r):
        n += 1
    return n


def helps(n, e, r):
    bits = 64 + 3 * n.bit_length()
    while True:
        ctx.prec = bits
        log = arb(r).log()
        a, b = (log / (n + 1)).exp(), (log / n).exp()
        # In halves: nothing grows.
        l = 2 * ((1 + a) / 2) ** (n + 1) / ((1 + b) / 2) ** n - 1 - arb(e)
        if l > 0 or l < 0:
            return bool(l < 0)
        bits *= 2


if __name__ == "__main__":
    jobs = {"J1": j1("fmpz"), "J1-fmpq": j1("fmpq"), "J2a": j2a, "J2b": j2b, "J3": j3, "J4": j4, "J4-qqbar": j4_qqbar}
    peer.run({**jobs, "J5": j5, "J6": j6, "J7": j7, "J10": j10})
