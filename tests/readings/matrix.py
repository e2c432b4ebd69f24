"""Numbers and matrices together: a matrix is a list of rows. Sums, products, powers, and comparisons."""

from mpmath import mpf

from dual import CLEAR, ZERO, Unclear, divide, real


def scaled(a, k):
    return [[entry * k for entry in row] for row in a] if isinstance(a, list) else a * k


def added(a, b):
    if isinstance(a, list) != isinstance(b, list):
        raise Unclear
    if isinstance(a, list):
        if len(a) != len(b) or len(a[0]) != len(b[0]):
            raise Unclear
        return [[x + y for x, y in zip(r, s)] for r, s in zip(a, b)]
    return a + b


def product(a, b):
    if len(a[0]) != len(b):
        raise Unclear
    return [[total(x * row[j] for x, row in zip(line, b)) for j in range(len(b[0]))] for line in a]


def total(values):
    out = mpf(0)
    for v in values:
        out = v + out
    return out


def det(a):
    if not isinstance(a, list) or len(a) != len(a[0]):
        raise Unclear
    if len(a) == 1:
        return a[0][0]
    signs = (mpf(1), mpf(-1))
    minors = ([row[:j] + row[j + 1 :] for row in a[1:]] for j in range(len(a)))
    return total(a[0][j] * det(minor) * signs[j % 2] for j, minor in enumerate(minors))


def trace(a):
    if not isinstance(a, list) or len(a) != len(a[0]):
        raise Unclear
    return total(row[i] for i, row in enumerate(a))


def transpose(a):
    return [list(row) for row in zip(*a)]


def inverse(a):
    over, n = det(a), len(a)
    signs = (mpf(1), mpf(-1))
    if n == 1:
        return [[divide(mpf(1), over)]]
    minor = {(i, j): [row[:j] + row[j + 1 :] for k, row in enumerate(a) if k != i] for i in range(n) for j in range(n)}
    return [[divide(det(minor[j, i]) * signs[(i + j) % 2], over) for j in range(n)] for i in range(n)]


def matrix_power(a, n):
    if len(a) != len(a[0]):
        raise Unclear
    factor = inverse(a) if n < 0 else a
    out = [[mpf(i == j) for j in range(len(a))] for i in range(len(a))]
    n = abs(n)
    while n:
        if n & 1:
            out = product(out, factor)
        n >>= 1
        factor = product(factor, factor) if n else factor
    return out


def same(a, b):
    """Whether two numbers are equal; raises `Unclear` where they are too close to tell."""
    distance, scale = abs(a - b), max(1, abs(a), abs(b))
    if distance <= ZERO * scale:
        return True
    if distance >= CLEAR * scale:
        return False
    raise Unclear


def related(a, relation, b):
    if isinstance(a, list) or isinstance(b, list):
        if not (isinstance(a, list) and isinstance(b, list)) or relation not in ("=", "!="):
            raise Unclear
        if len(a) != len(b) or len(a[0]) != len(b[0]):
            raise Unclear
        equal = all([same(real(x), real(y)) for r, s in zip(a, b) for x, y in zip(r, s)])
        return equal == (relation == "=")
    a, b = real(a), real(b)
    if same(a, b):
        return relation in ("=", "<=", ">=")
    return relation == "!=" or relation in (("<", "<=") if a < b else (">", ">="))
