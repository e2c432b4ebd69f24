"""Operators on results beside python-flint's balls of 200 bits: the same numbers and digits, in processor time.

An operator here only writes down what is to be computed; the lines with digits compute it. With the wheel and
python-flint installed: `python3 -P python/operators.py`. Ends with 1 where a job takes more than AIM times its time.
"""

import statistics
import sys
import time
from typing import Callable

from flint import arb, ctx, fmpq

import carom

ctx.prec = 200
AIM = 10.0

# The share that seven and eight inserted bodies pass on, and the same numbers as balls.
x, y = (carom.eta(10, 1, e="9/10", n=n) for n in (7, 8))


def ball(number: carom.Number) -> arb:
    low, high = (fmpq(end.numerator, end.denominator) for end in number.narrower(60))
    return arb(low).union(arb(high))


a, b = ball(x), ball(y)


def logistic(value, count: int):
    for _ in range(count):
        value = 3 * value * (1 - value)
    return value


def total(values):
    result = values[0]
    for value in values[1:]:
        result = result + value
    return result


JOBS: list[tuple[str, int, Callable[[], object], Callable[[], object]]] = [
    ("x + y", 2000, lambda: x + y, lambda: a + b),
    ("x * y", 2000, lambda: x * y, lambda: a * b),
    ("x / y", 2000, lambda: x / y, lambda: a / b),
    ("x < y", 2000, lambda: x < y, lambda: a < b),
    ("40 digits of x + y", 200, lambda: (x + y).digits(40), lambda: (a + b).str(40, radius=False)),
    (
        "40 digits of a sum of 100",
        20,
        lambda: total([x, y] * 50).digits(40),
        lambda: total([a, b] * 50).str(40, radius=False),
    ),
    (
        "40 digits of a sum of 10,000",
        1,
        lambda: total([x, y] * 5000).digits(40),
        lambda: total([a, b] * 5000).str(40, radius=False),
    ),
    (
        "40 digits after 50 logistic steps",
        20,
        lambda: logistic(x, 50).digits(40),
        lambda: logistic(a, 50).str(40, radius=False),
    ),
    (
        "10 digits of a mean of 1,000",
        2,
        lambda: carom.mean([x, y] * 500).digits(10),
        lambda: (total([a, b] * 500) / 1000).str(10, radius=False),
    ),
    (
        "rows: eta of 1,000 chains",
        2,
        lambda: carom.eta(list(range(2, 1002)), 1, e="9/10", n=7),
        lambda: [shared(m) for m in range(2, 1002)],
    ),
    ("eta of one chain", 200, lambda: carom.eta(10, 1, e="9/10", n=7).lo, lambda: shared(10)),
]


def shared(m: int) -> arb:
    """The share for seven bodies of the best masses between, as equation (25) says it."""
    root = arb(m).root(8)
    return (arb(361) / 100 * root / (1 + root) ** 2) ** 8


def seconds(job: Callable[[], object], times: int) -> float:
    begin = time.process_time()
    for _ in range(times):
        job()
    return (time.process_time() - begin) / times


missed = 0
for name, times, here, there in JOBS:
    pairs = [(seconds(here, times), seconds(there, times)) for _ in range(7)]
    ratio = statistics.median(own / flint for own, flint in pairs if flint > 0)
    least = [min(pair[i] for pair in pairs) * 1e6 for i in (0, 1)]
    missed += ratio > AIM
    print(f"{name:36} {least[0]:12.2f} µs {least[1]:12.2f} µs {ratio:9.2f} times")
print(f"{missed} of {len(JOBS)} jobs above {AIM:g} times")
sys.exit(missed > 0)
