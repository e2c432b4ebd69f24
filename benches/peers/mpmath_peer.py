"""mpmath over gmpy2: `iv` (enclosures) for cells, `mp` (uncertified) for digits and n*.

Tried and not taken: `iv` with a root by exp(log/k) (wider and slower than `**`); `mp` roots by `power` (slower than
`root`).
"""
from mpmath import iv, mp, mpf

import peer
from peer import DIGITS, PRIME, SPARE

FEW = 5_000  # of the 10^5 cells: the time is for one cell


def j2a(work):
    import numpy

    iv.prec = 64
    e, r, n = numpy.fromfile(work / "J2a.bin").reshape(3, -1)
    cells = [(iv.mpf(a), iv.mpf(b), int(c)) for a, b, c in list(zip(e.tolist(), r.tolist(), n.tolist()))[:FEW]]
    out = []

    def compute():
        out.clear()
        for e, r, n in cells:
            t = r ** (iv.mpf(1) / n)
            out.append(((1 + e) ** 2 * t / (1 + t) ** 2) ** n)

    def answer(_):
        down = numpy.nextafter([float(x.a) for x in out], 0)
        return peer.ends(work, "J2a-mpmath", down, numpy.nextafter([float(x.b) for x in out], 2))

    yield "one of 100000 cells", compute, answer, len(cells)


def j3(work):
    for count in DIGITS:
        def eta(count=count):
            mp.prec = int(count * 3.3219280948874) + 40
            t = mp.root(10, 8)
            return ((mpf(19) / 10) ** 2 * t / (1 + t) ** 2) ** 8

        def threshold(count=count):
            mp.prec = int(count * 3.3219280948874) + 40
            return (1 + mp.root(10, 8)) ** 8 / (1 + mp.root(10, 7)) ** 7 - 1

        def answer(x, count=count):
            return str(int(mp.floor(x * mpf(10) ** (count - SPARE))) % PRIME)

        yield f"eta/{count}", eta, answer
        yield f"L_7/{count}", threshold, answer


def j10(work):
    from mpmath import iv

    def call():
        iv.prec = 64
        t = iv.mpf(10) ** (iv.mpf(1) / 8)
        gain = 1 + iv.mpf(9) / 10
        return (gain * gain * t / (1 + t) ** 2) ** 8

    ends = lambda x: (float(x.a), float(x.b))
    outwards = lambda x: peer.ends(work, "J10-mpmath", [x[0] * (1 - 2**-52)], [x[1] * (1 + 2**-52)])
    yield "one call", call, lambda x: outwards(ends(x))
    yield "one call, two doubles", lambda: ends(call()), outwards


def j7(work):
    for case, r, e in peer.best(work):
        def best():
            mp.prec = 160
            ratio, limit = mpf(r.numerator) / r.denominator, mpf(e.numerator) / e.denominator
            c = mp.log(2 / (1 + limit))
            u = mp.findroot(lambda u: u * mp.tanh(u) - mp.log(mp.cosh(u)) - c, mp.sqrt(2 * c))
            n = int(mp.log(ratio) / 2 / u - 0.5)
            helps = lambda n: 2 * ((1 + mp.root(ratio, n + 1)) / 2) ** (n + 1) / ((1 + mp.root(ratio, n)) / 2) ** n - 1 <= limit
            while not helps(n):
                n -= 1
            while helps(n + 1):
                n += 1
            return n

        yield case, best, str


if __name__ == "__main__":
    peer.run({"J2a": j2a, "J3": j3, "J7": j7, "J10": j10})
