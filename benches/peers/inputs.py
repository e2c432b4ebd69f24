"""The input of every job, written once into the work folder so that all programs read the same numbers."""
import random
from fractions import Fraction
from pathlib import Path

import numpy

CELLS = 100_000
SIDE = 1_000
LINES = (10, 100, 1_000, 10_000)
BODIES = (100, 1_000, 10_000, 100_000, 1_000_000)
# A prime: long answers are compared by their remainders.
PRIME = 2**127 - 1


def cells(work):
    """J2a: restitution, mass ratio and number of collisions of scattered cells, as doubles one after the other."""
    rng = numpy.random.default_rng(2015)
    e = rng.random(CELLS)
    r = 2.0 ** (12 * rng.random(CELLS) - 6)
    n = rng.integers(2, 14, CELLS).astype(float)
    numpy.concatenate([e, r, n]).tofile(work / "J2a.bin")


def grid(work):
    """J2b: the restitutions, then the ratios of a square grid; 8 collisions in each cell."""
    numpy.concatenate([numpy.arange(SIDE) / (SIDE - 1), 1.0 + numpy.arange(SIDE)]).tofile(work / "J2b.bin")


def floor_root(x, k):
    """The largest integer whose k-th power is at most x."""
    low, high = 0, 1 << (x.bit_length() // k + 1)
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if middle**k <= x else (low, middle)
    return low


def threshold_cut(r, n, places):
    """L_n rounded down to so many places, in integers."""
    scale = 10 ** (places + 20)
    a, b = (Fraction(floor_root(r * scale**k, k), scale) for k in (n + 1, n))
    value = (1 + a) ** (n + 1) / (1 + b) ** n - 1
    return Fraction(int(value * 10**places), 10**places)


def signs(work):
    """J4: case, n, e, r: equality, 1e-30 above it, 1e-30 below an irrational L_n, and far away."""
    lines = []
    for n in range(1, 13):
        t = Fraction(3, 2)
        r = t ** (n * (n + 1))
        exact = (1 + t**n) ** (n + 1) / (1 + t ** (n + 1)) ** n - 1
        lines.append((f"equal/{n}", n, exact, r))
        lines.append((f"above/{n}", n, exact + Fraction(1, 10**30), r))
        lines.append((f"below/{n}", n, threshold_cut(10, n, 30), Fraction(10)))
        lines.append((f"far/{n}", n, Fraction(1, 10), Fraction(10)))
    (work / "J4.txt").write_text("".join(" ".join(map(str, line)) + "\n" for line in lines))


def chains(work):
    """J6: mass (numerator, denominator) and restitution (the same) of each body, 32 bits each."""
    for bodies in BODIES:
        rng = random.Random(bodies)
        word = lambda: rng.getrandbits(32) | 1
        with open(work / f"J6-{bodies}.txt", "w") as file:
            for _ in range(bodies):
                low, high = sorted((word(), word()))
                file.write(f"{word()} {word()} {low} {high}\n")


def best(work):
    """J7: case, r, e."""
    nine = Fraction(10**16 - 1, 10**16)
    (work / "J7.txt").write_text(f"3 10 9/10\n1e9 10000000000 {nine}\n")


def lines(work):
    """J9: mass, position (numerator, denominator), velocity and restitution (the same) of the bodies of dilute lines."""
    for bodies in LINES:
        rng, at = random.Random(bodies), 0
        with open(work / f"J9-{bodies}.txt", "w") as file:
            for _ in range(bodies):
                at += 997 + rng.randrange(997)
                file.write(f"{1 + rng.randrange(4)} {at} 997 {rng.randrange(2001) - 1000} 1009 {9 + rng.randrange(2)} 10\n")


def write(work):
    work = Path(work)
    work.mkdir(parents=True, exist_ok=True)
    # A folder made before there was a job lacks its input alone.
    parts = {"complete": (cells, grid, signs, chains, best), "complete-J9": (lines,)}
    for mark, written in parts.items():
        if not (work / mark).exists():
            for part in written:
                part(work)
            (work / mark).touch()


if __name__ == "__main__":
    import sys

    write(sys.argv[1])
