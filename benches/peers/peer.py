"""What every Python peer shares: reading the input, timing, and the line of JSON for each case.

A peer is started as `program JOB WORK [CASE …]` and prints {"case", "seconds", "answer"} a line; seconds are those of
one unit, without start-up, imports, reading of input and the writing of answers.
"""
import json
import sys
import time
from fractions import Fraction
from pathlib import Path

PRIME = 2**127 - 1
DIGITS = (100, 150, 200, 600, 1_000, 10_000, 100_000, 1_000_000)
BODIES = (100, 1_000, 10_000, 100_000, 1_000_000)
# J9: bodies in a line; ten collisions each.
LINES = (10, 100, 1_000, 10_000)
# Leading digits that may differ between a number rounded up and one rounded down are not compared.
SPARE = 10


def measure(compute, budget=0.2):
    """The median time of one call, and the value. A call below a tenth of the budget is repeated."""
    begin = time.perf_counter()
    value = compute()
    once = time.perf_counter() - begin
    if once > budget / 10:
        return once, value
    calls = max(1, int(budget / 10 / max(once, 1e-7)))
    rounds = []
    for _ in range(9):
        begin = time.perf_counter()
        for _ in range(calls):
            compute()
        rounds.append((time.perf_counter() - begin) / calls)
    return sorted(rounds)[len(rounds) // 2], value


def run(jobs):
    """`jobs` gives for each job a function that yields (case, the timed computation, what makes an answer of its
    value), and the number of units in it where that is not one."""
    sys.set_int_max_str_digits(0)
    job, work, *wanted = sys.argv[1:]
    for case, compute, answer, *units in jobs[job](Path(work)):
        if not wanted or case in wanted:
            seconds, value = measure(compute)
            per = seconds / units[0] if units else seconds
            print(json.dumps({"case": case, "seconds": per, "answer": answer(value)}), flush=True)


def signs(work):
    for line in (work / "J4.txt").read_text().splitlines():
        case, n, e, r = line.split()
        yield case, int(n), Fraction(e), Fraction(r)


def best(work):
    for line in (work / "J7.txt").read_text().splitlines():
        case, r, e = line.split()
        yield case, Fraction(r), Fraction(e)


def chain(work, bodies, integer=int):
    """The rows of a chain: mass numerator and denominator, restitution numerator and denominator."""
    with open(work / f"J6-{bodies}.txt") as file:
        return [tuple(map(integer, line.split())) for line in file]


def all_answer(pairs):
    """One number for all velocities, given in lowest terms."""
    return str(sum((i + 1) * (p + 3 * q) for i, (p, q) in enumerate(pairs)) % PRIME)


def ends(work, name, lower, upper):
    """Writes the ends of all enclosures for the comparison."""
    import numpy

    path = work / f"{name}.ends"
    numpy.concatenate([numpy.asarray(lower, float).ravel(), numpy.asarray(upper, float).ravel()]).tofile(path)
    return str(path)
