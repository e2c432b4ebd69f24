"""Matrices whose entries are written: entries, trace, inverse and powers (section 14.8 of docs/certificates.md)."""
from .claims import N, need, num, room
from .walk import fits

POWER_LIMIT = 100
NOT_WRITTEN = "a matrix whose entries are written is needed"


class Matrices:
    """The definitions that are matrices, by their names."""

    def __init__(self):
        self.known = {}

    def entries(self, e):
        """The rows of a matrix by how it is written; None for a number."""
        tag = e[0]
        if tag == "matrix":
            return e[1]
        if tag == "name":
            return self.known.get(e[1])
        if tag == "call" and e[1] == "transpose" and len(e[2]) == 1:
            rows = self.entries(e[2][0])
            return rows and tuple(zip(*rows))
        if tag == "neg":
            return each(self.entries(e[1]), lambda x: N("neg", x))
        if tag == "sum":
            parts = [self.entries(part) for _, part in e[1]]
            if None in parts or len({(len(rows), len(rows[0])) for rows in parts}) > 1:
                return None
            signs = [sign for sign, _ in e[1]]
            return tuple(tuple(N("sum", tuple(zip(signs, cells))) for cells in zip(*rows)) for rows in zip(*parts))
        return self.entries_of_product(e[1]) if tag == "prod" else None

    def entries_of_product(self, factors):
        rows, scalars = None, []
        for operator, factor in factors:
            more = self.entries(factor)
            if more is None:
                scalars.append((operator, factor))
            elif operator == "/" or rows is not None and len(rows[0]) != len(more):
                return None
            else:
                rows = more if rows is None else tuple(tuple(cell(row, column) for column in zip(*more)) for row in rows)
                fits(N("matrix", rows))
        return each(rows, lambda x: N("prod", (("*", x), *scalars)) if scalars else x)

    def square(self, e):
        rows = self.entries(e)
        need(rows, NOT_WRITTEN)
        need(len(rows) == len(rows[0]), "a square matrix is needed")
        return rows

    def trace(self, e):
        rows = self.square(e)
        return added([rows[i][i] for i in range(len(rows))])

    def inverse(self, e):
        """The matrix of cofactors, turned over its diagonal, over the determinant."""
        rows = self.square(e)
        places = range(len(rows))

        def cofactor(i, j):
            minor = tuple(tuple(row[l] for l in places if l != j) for k, row in enumerate(rows) if k != i)
            value = determinant(minor) if len(minor) > 1 else minor[0][0] if minor else num(1)
            return N("neg", value) if (i + j) % 2 else value

        turned = N("matrix", tuple(tuple(cofactor(i, j) for i in places) for j in places))
        return N("prod", (("*", turned), ("/", determinant(rows))))

    def power(self, base, k):
        """The power of a matrix to a whole number."""
        n = len(self.square(base))
        if k == 0:
            return N("matrix", tuple(tuple(num(int(i == j)) for j in range(n)) for i in range(n)))
        room(abs(k) <= POWER_LIMIT, f"a matrix to the power {k}")
        factor = base if k > 0 else self.inverse(base)
        return factor if abs(k) == 1 else N("prod", (("*", factor),) * abs(k))


def determinant(rows):
    return N("call", "det", (N("matrix", rows),))


def added(terms):
    return terms[0] if len(terms) == 1 else N("sum", tuple((1, e) for e in terms))


def cell(row, column):
    return added([N("prod", (("*", a), ("*", b))) for a, b in zip(row, column)])


def each(rows, change):
    return rows and tuple(tuple(map(change, row)) for row in rows)
