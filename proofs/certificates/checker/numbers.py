"""Propositions at a point, by arithmetic: the rule `evaluate` of docs/certificates.md.

A number is a pair of fractions: it lies between them, and is known exactly where they are equal.
"""
import functools
import math
from fractions import Fraction as Q

from checker.claims import FUNCTIONS, names_in, need, PI, room, text, to_the_ends
from checker.signs import exponent, NOT_NEGATIVE, NOT_ZERO, POSITIVE, SHOWN, sign, SIGNS

BITS, EXACT, LONGEST = 256, 10_000, 100_000
UNITS = 2 ** 320
OPEN, TOO_LONG = "enclosures do not decide it", "a number too long for this checker"


def length(q):
    return max(q.numerator.bit_length(), q.denominator.bit_length())


def between(low, high):
    """The two numbers as an enclosure, rounded outwards where they are long."""
    long = max(length(low), length(high))
    room(long <= LONGEST, TOO_LONG)
    if long <= (EXACT if low == high else 2 * BITS):
        return low, high
    def rounded(q, whole):
        scale = Q(2) ** (BITS - q.numerator.bit_length() + q.denominator.bit_length())
        return whole(q * scale) / scale
    return rounded(low, math.floor), rounded(high, math.ceil)


def exactly(k):
    return Q(k), Q(k)


def plus(x, y):
    return between(x[0] + y[0], x[1] + y[1])


def negated(x):
    return -x[1], -x[0]


def times(x, y):
    ends = [a * b for a in x for b in y]
    return between(min(ends), max(ends))


def signs_of(x):
    return sign(x[0]) | sign(x[1]) | (2 if x[0] < 0 < x[1] else 0)


def inverse(x):
    need(signs_of(x) in (1, 4), OPEN)
    return between(1 / x[1], 1 / x[0])


def whole_power(x, k):
    """x^k for a whole number k of at least 0."""
    if x in (exactly(0), exactly(1), exactly(-1)):
        return x if k % 2 or x == exactly(0) and k else exactly(1)
    room(k <= 1_000_000, TOO_LONG)
    def of(q):
        out, square, left = exactly(1), exactly(q), k
        while left:
            out = times(out, square) if left % 2 else out
            left //= 2
            square = times(square, square) if left else square
        return out
    low, high = of(x[0]), of(x[1])
    if k % 2 or x[0] >= 0:
        return between(low[0], high[1])
    return between(Q(0) if x[1] > 0 else high[0], max(low[1], high[1]))


def whole_root(n, k):
    """The whole part of the k-th root."""
    if n < 2:
        return n
    x = 1 << -(-n.bit_length() // k)
    while (y := ((k - 1) * x + n // x ** (k - 1)) // k) < x:
        x = y
    return x


def root(x, k):
    def of(q):
        top, bottom = whole_root(q.numerator, k), whole_root(q.denominator, k)
        if (top ** k, bottom ** k) == (q.numerator, q.denominator):
            return exactly(Q(top, bottom))
        bits = BITS + max(0, q.denominator.bit_length() - q.numerator.bit_length()) // k + 1
        near = whole_root(math.floor(q * 2 ** (bits * k)), k)
        return Q(near, 2 ** bits), Q(near + 1, 2 ** bits)
    need(x[0] >= 0, OPEN)
    return between(of(x[0])[0], of(x[1])[1])


def widened(x, bits):
    return between(x[0] - Q(1, 2 ** bits), x[1] + Q(1, 2 ** bits))


def exponential(x):
    def of(q):
        halvings = abs(math.trunc(q)).bit_length() + 1
        room(halvings <= 18, TOO_LONG)
        if not q:
            return exactly(1)
        total_, term = exactly(1), exactly(1)
        for n in range(1, 61):
            term = times(term, exactly(q / 2 ** halvings / n))
            total_ = plus(total_, term)
        # 61! > 2^277, and |q/2^halvings| is at most 1/2.
        out = widened(total_, 330)
        for _ in range(halvings):
            out = times(out, out)
        return out
    return between(of(x[0])[0], of(x[1])[1])


def artanh(z):
    total_, power = exactly(0), between(z, z)
    square = times(power, power)
    for j in range(100):
        total_ = plus(total_, times(power, exactly(Q(1, 2 * j + 1))))
        power = times(power, square)
    return widened(total_, 318) if z else exactly(0)


def logarithm(x):
    def of(q):
        e = q.numerator.bit_length() - q.denominator.bit_length()
        m = q / Q(2) ** e
        out = plus(artanh((m - 1) / (m + 1)), times(artanh(Q(1, 3)), exactly(e)) if e else exactly(0))
        return times(out, exactly(2))
    need(x[0] > 0, OPEN)
    return between(of(x[0])[0], of(x[1])[1])


@functools.cache
def pi():
    """π = 16·arctan(1/5) − 4·arctan(1/239). The terms alternate and get smaller, so one sum is below and the next above."""
    def arctan(k):
        return [sum(Q((-1) ** j, (2 * j + 1) * k ** (2 * j + 1)) for j in range(n)) for n in (64, 65)]
    (low, high), (less, more) = arctan(5), arctan(239)
    return 16 * low - 4 * more, 16 * high - 4 * less


def cosine_and_sine(x):
    """Neither changes by more than its argument does."""
    width = x[1] - x[0]
    return [between(low - width, high + width) for low, high in of_circle(x[0])]


def of_circle(q):
    """The cosine and the sine of q by their series, in whole multiples of 1/UNITS."""
    room(abs(math.trunc(q)).bit_length() <= 18, TOO_LONG)
    if not q:
        return exactly(1), exactly(0)
    low, high = pi()
    turns = round(q / (2 * low))
    low, high = sorted((q - 2 * turns * low, q - 2 * turns * high))
    t = math.floor(low * UNITS)
    need(abs(t) < 4 * UNITS, OPEN)
    term, sums = UNITS, [0, 0]
    for n in range(120):
        sums[n % 2] += term if n % 4 < 2 else -term
        term = term * t // (UNITS * (n + 1))
    # The error of a term is at most 4/n times that of the one before, and 1: never above 6. What is left is at most
    # 4^120/120! < 2^-400, and t stands for a number between low and high.
    error = high - low + Q(1000, UNITS)
    return [(Q(both, UNITS) - error, Q(both, UNITS) + error) for both in sums]


def arctangent(x):
    """It rises."""
    return between(arctangent_of(x[0])[0], arctangent_of(x[1])[1])


def arctangent_of(q):
    """The arctangent of q by its series, in whole multiples of 1/UNITS. It is odd, for q > 0 it is π/2 less that of 1/q, and
    twice that of q/(1 + √(1 + q²))."""
    if q <= 0:
        return negated(arctangent_of(-q)) if q else exactly(0)
    if q > 1:
        low, high = arctangent_of(1 / q)
        return pi()[0] / 2 - high, pi()[1] / 2 - low
    t = math.floor(q * UNITS)
    for _ in range(8):
        t = t * UNITS // (UNITS + math.isqrt(UNITS * UNITS + t * t))
    # q/(1 + √(1 + q²)) changes at most half as much as q. Rounding the root makes t less than 1 too great, and rounding the
    # quotient less than 1 too small. So the error of t stays below 2 units, and the arctangent changes no more than t does.
    # t is now below UNITS/256, for tan(π/1024) < 1/256.
    total_, power = 0, t
    for n in range(20):
        total_ += (-power if n % 2 else power) // (2 * n + 1)
        power = power * t // UNITS * t // UNITS
    # The error of a power is below 2: of that of the one before 1/256² remains, of the first rounding less than 1/256, of the
    # second less than 1. So that of a term is below 3, and that of the sum below 60. The terms alternate and get smaller, so
    # what is left out is less than the next one, which is below 1/256^41 = 2^-328. With the error of t all that is below 64
    # units, and 256 times as much in the end: 2^-306.
    error = Q(64, UNITS)
    return 256 * (Q(total_, UNITS) - error), 256 * (Q(total_, UNITS) + error)


def arcsine(x):
    """It rises from −1 to 1."""
    return between(arcsine_of(x[0])[0], arcsine_of(x[1])[1])


def arcsine_of(q):
    """For 0 <= q <= 1 it is twice the arctangent of q/(1 + √(1 − q²)). That quotient is at most 1, so it changes by less than
    1/UNITS where the root is rounded to a multiple of that."""
    if q <= 0:
        return negated(arcsine_of(-q)) if q else exactly(0)
    root_ = math.isqrt(math.floor((1 - q * q) * UNITS * UNITS))
    low, high = (q * UNITS / (UNITS + r) for r in (root_ + 1, root_))
    return 2 * arctangent_of(low)[0], 2 * arctangent_of(high)[1]


def real_power(b, e):
    """b^E for b > 0, or b >= 0 under a positive number E."""
    if e[0] == e[1] and e[0].denominator <= 64:
        out = whole_power(b if e[0].denominator == 1 else root(b, e[0].denominator), abs(e[0].numerator))
        return inverse(out) if e[0] < 0 else out
    return b if b == exactly(0) else exponential(times(e, logarithm(b)))


def determinant(rows):
    need(len(rows) <= 5 and all(len(row) == len(rows) for row in rows), "matrices of different sizes, or in order")
    out = exactly(0 if rows else 1)
    for j, x in enumerate(rows[0] if rows else ()):
        part = times(x, determinant([row[:j] + row[j + 1:] for row in rows[1:]]))
        out = plus(out, part if j % 2 == 0 else negated(part))
    return out


def every(truths):
    """Whether all are true: True, False, or None where that is open."""
    return False if False in truths else None if None in truths else True


def denied(truth):
    return None if truth is None else not truth


class Point:
    """Numbers for names and members, from equations; matrices are lists of rows."""

    def __init__(self, checker, facts):
        self.checker, self.scope = checker, checker.scope
        self.values, self.members, self.indices = {}, {}, {}
        for p in facts:
            need(p[0] == "cmp" and p[2] == ("=",), "an equation is needed")
            place, value = p[1]
            value = self.exact(value)
            if place[0] == "name":
                self.values[place[1]] = value
            else:
                need(place[0] == "call" and place[1] not in FUNCTIONS and len(place[2]) == 1, "no name and no member")
                self.members[place[1], self.whole(place[2][0])] = value, value

    def inside(self, indices, run):
        before, self.indices = self.indices, indices
        new = {k: self.checker.variable(k, True) for k in indices}
        scope, self.checker.scope = self.checker.scope, {**self.scope, **new}
        try:
            return run()
        finally:
            self.indices, self.checker.scope = before, scope

    def number(self, e, signs=7):
        x = self.value(e)
        need(isinstance(x, tuple), "a number is needed where a matrix stands")
        need(not signs_of(x) & ~signs, f"{text(e)} is not shown to be {SHOWN.get(signs)}")
        return x

    def exact(self, e):
        low, high = self.number(e)
        need(low == high, OPEN)
        return low

    def whole(self, e):
        q = self.exact(e)
        need(self.checker.is_whole_form(e) and q.denominator == 1, "an index or exponent that is not a whole number")
        return int(q)

    def value(self, e):
        tag = e[0]
        if tag == "num":
            return exactly(e[1])
        if tag == "name":
            found = self.indices.get(e[1], self.values.get(e[1]))
            if found is None and e[1] == PI and not self.checker.is_declared(PI):
                return between(*pi())
            need(found is not None, f"{e[1]} has no number here")
            return exactly(found)
        if tag == "neg":
            return each(negated, self.value(e[1]))
        if tag == "sum":
            parts = [x if s == 1 else each(negated, x) for s, x in ((s, self.value(part)) for s, part in e[1])]
            need(len(set(map(size, parts))) == 1, "matrices of different sizes, or in order")
            out = parts[0]
            for x in parts[1:]:
                out = plus(out, x) if isinstance(x, tuple) else [list(map(plus, r, s)) for r, s in zip(out, x)]
            return out
        if tag == "prod":
            out = exactly(1)
            for operator, part in e[1]:
                out = product(out, inverse(self.number(part, NOT_ZERO)) if operator == "/" else self.value(part))
            return out
        if tag == "pow":
            k, whole = exponent(e[2], self.checker.is_whole_form)
            if whole:
                k = self.whole(e[2])
                return inverse(whole_power(self.number(e[1], NOT_ZERO), -k)) if k < 0 else whole_power(self.number(e[1]), k)
            power = self.number(e[2])
            return real_power(self.number(e[1], NOT_NEGATIVE if k is not None and k > 0 else POSITIVE), power)
        if tag == "over":
            low, high = self.whole(e[3]), self.whole(e[4])
            need(0 <= low <= high + 1, f"the range or index of {text(e)} is not shown to be one")
            out = exactly(0 if e[1] == "sum" else 1)
            for k in range(low, high + 1):
                x = self.inside({**self.indices, e[2]: k}, lambda: self.number(e[5]))
                out = plus(out, x) if e[1] == "sum" else times(out, x)
            return out
        if tag == "matrix":
            return [[self.number(x) for x in row] for row in e[1]]
        need(tag == "call" and len(e[2]) == 1, "derivatives and integrals are not evaluated")
        return self.call(e[1], e[2][0])

    def call(self, f, e):
        if f in ("sqrt", "cbrt"):
            return root(self.number(e, NOT_NEGATIVE), 2 if f == "sqrt" else 3)
        if f == "ln":
            return logarithm(self.number(e, POSITIVE))
        if f in ("det", "transpose"):
            x = self.value(e)
            need(isinstance(x, list), "a matrix is needed")
            return determinant(x) if f == "det" else [list(column) for column in zip(*x)]
        if f in ("cos", "sin"):
            return cosine_and_sine(self.number(e))[f == "sin"]
        if f == "arctan":
            return arctangent(self.number(e))
        if f in ("arcsin", "arccos"):
            x = self.number(e)
            for part, room_ in zip(to_the_ends(e), (negated(x), x)):
                signs = signs_of(plus(exactly(1), room_))
                need(not signs & ~NOT_NEGATIVE, f"{text(part)} is not shown to be {SHOWN[NOT_NEGATIVE]}")
            arc = arcsine(x)
            return arc if f == "arcsin" else plus(times(between(*pi()), exactly(Q(1, 2))), negated(arc))
        if f in FUNCTIONS:
            x = self.number(e)
            up, down, half = exponential(x), exponential(negated(x)), exactly(Q(1, 2))
            if f in ("exp", "cosh", "sinh"):
                return up if f == "exp" else times(half, plus(up, down if f == "cosh" else negated(down)))
            both = inverse(plus(up, down))
            return times(exactly(2), both) if f == "sech" else times(plus(up, negated(down)), both)
        k = self.whole(e)
        need(k >= 0, f"{text(e)} is not shown to be at least 0")
        if (f, k) not in self.members:
            need(f in self.checker.sequences, f"{f} has no number here")
            _, initial, index, step = self.checker.sequences[f]
            self.members[f, 0] = self.inside({}, lambda: self.number(initial))
            for j in range(k):
                self.members[f, j + 1] = self.inside({index: j}, lambda: self.number(step))
        return self.members[f, k]

    def truth(self, p):
        """True, False or None. Behind `=>` no value is needed where what stands before it is false."""
        tag = p[0]
        if tag == "cmp":
            sides = list(map(self.value, p[1]))
            return every([compared(x, r, y) for x, r, y in zip(sides, p[2], sides[1:])])
        if tag in ("and", "or", "iff"):
            truths = list(map(self.truth, p[1]))
            if tag == "iff":
                return False if {True, False} <= set(truths) else None if None in truths else True
            return every(truths) if tag == "and" else denied(every(list(map(denied, truths))))
        if tag == "not":
            return denied(self.truth(p[1]))
        if tag == "imp":
            before = self.truth(p[1])
            behind = True if before is False else self.truth(p[2])
            return True if behind else behind if before else None
        need(tag in ("all", "exists"), "limits and extrema are not evaluated")
        truths = self.truths([(n, b) for b in p[1] for n in b[1]], p[2])
        return every(truths) if tag == "all" else denied(every(list(map(denied, truths))))

    def truths(self, names, body):
        """The truths of a proposition for all natural numbers in ranges."""
        if not names:
            return [self.truth(body)]
        ((n, index), b), *rest = names
        plain = index is None and b[2] and [c[0] for c in b[3]] == ["range"]
        need(plain, "statements about more than ranges are not evaluated")
        out, high = [], self.exact(b[3][0][3])
        for k in range(max(0, math.ceil(self.exact(b[3][0][2]))), math.floor(high) + 1):
            out += self.inside({**self.indices, n: k}, lambda: self.truths(rest, body))
        return out


def each(change, x):
    return change(x) if isinstance(x, tuple) else [list(map(change, row)) for row in x]


def size(x):
    return None if isinstance(x, tuple) else tuple(map(len, x))


def product(x, y):
    if isinstance(x, tuple) or isinstance(y, tuple):
        number_, other = (x, y) if isinstance(x, tuple) else (y, x)
        return each(lambda z: times(number_, z), other)
    need(len(x[0]) == len(y), "matrices of different sizes, or in order")
    def cell(row, column):
        out = exactly(0)
        for a, b in zip(row, column):
            out = plus(out, times(a, b))
        return out
    return [[cell(row, column) for column in zip(*y)] for row in x]


def compared(x, relation, y):
    need(size(x) == size(y), "matrices of different sizes, or in order")
    if isinstance(x, list):
        need(relation in ("=", "!="), "matrices of different sizes, or in order")
        same = every([compared(a, "=", b) for r, s in zip(x, y) for a, b in zip(r, s)])
        return same if relation == "=" else denied(same)
    signs = signs_of(plus(x, negated(y)))
    return True if not signs & ~SIGNS[relation] else False if not signs & SIGNS[relation] else None


def evaluate(checker, goal, facts):
    for n in names_in(goal):
        need(n in FUNCTIONS or n == PI or checker.is_declared(n), f"{n} is not declared here")
    truth = Point(checker, facts).truth(goal)
    need(truth is not False, "it is false")
    need(truth, OPEN)
