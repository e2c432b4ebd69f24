"""J6 with gmpy2 (mpz product tree, one reduction at the end), and with Python's fractions (fold).

Tried and not taken: `math.prod` over mpz (quadratic), mpq in the tree (a gcd at every node), fractions with a tree.
"""
import operator
import sys
from fractions import Fraction

import gmpy2
from gmpy2 import mpq, mpz

import peer
from peer import BODIES, PRIME


def product(factors):
    while len(factors) > 1:
        half = list(map(operator.mul, factors[::2], factors[1::2]))
        factors = half + factors[len(factors) & ~1 :]
    return factors[0]


def factors(rows):
    up, down = [], []
    for (a, b, _, _), (c, d, p, q) in zip(rows, rows[1:]):
        ad = a * d
        up.append(ad * (p + q))
        down.append((ad + b * c) * q)
    return up, down


def parts(v):
    return f"{int(v.numerator % PRIME)}/{int(v.denominator % PRIME)}"


def last(integer, rational):
    def job(work):
        yield from everyone(work, rational)
        for bodies in BODIES:
            rows = peer.chain(work, bodies, integer)

            def compute():
                up, down = factors(rows)
                return rational(product(up), product(down))

            yield f"last/{bodies}", compute, parts

    return job


def everyone(work, rational):
    chain = peer.chain(work, 1_000)
    masses = [rational(a, b) for a, b, _, _ in chain]
    restitutions = [rational(c, d) for _, _, c, d in chain]

    def compute():
        v, out = rational(1), []
        for m1, m2, e in zip(masses, masses[1:], restitutions[1:]):
            total = m1 + m2
            out.append((m1 - e * m2) / total * v)
            v = m1 * (1 + e) / total * v
        return out + [v]

    yield "all/1000", compute, lambda vs: peer.all_answer([(int(v.numerator), int(v.denominator)) for v in vs])


if __name__ == "__main__":
    peer.run({"J6-gmpy2": last(mpz, mpq), "J6-fractions": last(int, Fraction)})
