"""J9 in Python: the pairs in a heap, each body with its own time, in doubles and in exact fractions.

Tried and not taken: looking at all pairs for each collision (a hundred times slower with 1000 bodies), positions of all
bodies brought up to date at each collision (the same, and longer fractions), gmpy2's rationals (three times faster than
fractions, but then it is no longer the loop that needs nothing but Python).
"""
import heapq
from fractions import Fraction

import peer
from peer import LINES


def line(work, bodies, number):
    with open(work / f"J9-{bodies}.txt") as file:
        rows = [tuple(map(int, row.split())) for row in file]
    quotient = (lambda p, q: Fraction(p, q)) if number is Fraction else (lambda p, q: p / q)
    return [(number(m), quotient(p, q), quotient(a, b), quotient(c, d)) for m, p, q, a, b, c, d in rows]


def replay(rows, zero):
    """The number of collisions, and the sum of the places of their pairs, up to ten a body."""
    mass, x, v, e = map(list, zip(*rows))
    # x is where a body would have been at time 0 on its present course.
    n, count, total = len(mass), 0, 0
    version, heap = [0] * n, []
    now = zero

    def push(i):
        version[i] += 1
        if v[i] > v[i + 1]:
            heapq.heappush(heap, ((x[i + 1] - x[i]) / (v[i] - v[i + 1]), i, version[i]))

    for i in range(n - 1):
        push(i)
    while heap and count < 10 * n:
        now, i, of = heapq.heappop(heap)
        if of != version[i]:
            continue
        change = (1 + e[i]) * (v[i] - v[i + 1]) / (mass[i] + mass[i + 1])
        left, right = change * mass[i + 1], change * mass[i]
        v[i], v[i + 1] = v[i] - left, v[i + 1] + right
        x[i], x[i + 1] = x[i] + left * now, x[i + 1] - right * now
        count, total = count + 1, total + i + 1
        for k in (i - 1, i, i + 1):
            if 0 <= k < n - 1:
                push(k)
    return count, total


def job(number, zero):
    def cases(work):
        for bodies in LINES:
            rows = line(work, bodies, number)
            # The unit is a collision: they are counted first.
            count, _ = replay(line(work, bodies, float), 0.0)
            yield str(bodies), lambda: replay(rows, zero), lambda found: "{} {}".format(*found), count

    return cases


if __name__ == "__main__":
    peer.run({"J9-doubles": job(float, 0.0), "J9-fractions": job(Fraction, Fraction(0))})
