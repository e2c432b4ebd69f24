"""Abbreviations: |x|, max, min, n!, binomial, and those of matrices (section 14.8 of docs/certificates.md)."""
import itertools

from .author import ABBREVIATIONS, MADE
from .claims import compare, N, need, Node, num, plus, room
from .everywhere import Values
from .matrices import added, Matrices
from .signs import number
from .walk import bottom_up, bound, bound_inside, clauses, declared, every, expressions, names_of, used

ROWS_LIMIT = 9
LETTERS = ("i", "j", "k", "l")


class Abbreviations:
    """The abbreviations of one claim, written out item by item."""

    def __init__(self, claim, fresh):
        self.claim, self.fresh = claim, fresh
        self.own = {n for item in claim.items for n in declared(item)}.union(*map(bound, clauses(claim)))
        self.inside, self.values, self.matrices = bound_inside(claim), Values(), Matrices()
        self.names, self.powers, self.open = names_of(claim), {}, []

    def write_out(self):
        items = []
        for item in self.claim.items:
            item = self.clause(item)
            if item[0] == "let" and not item[2] and (rows := self.matrices.entries(item[3])):
                self.matrices.known[item[1]] = rows
            self.values.learn(item)
            items += self.open + [item]
            self.open = []
        every(self.claim, self.clause)
        self.claim.items = items + self.open

    def clause(self, x):
        return expressions(x, lambda e: bottom_up(e, self.change))

    def change(self, e):
        if e[0] == "call" and e[1] in ABBREVIATIONS and e[1] not in self.own:
            least, most = ABBREVIATIONS[e[1]]
            need(least <= len(e[2]) <= most, f"{e[1]} takes {least} to {most} arguments")
            return getattr(self, "of_" + e[1])(*e[2])
        if e[0] == "pow" and self.matrices.entries(e[1]):
            k = number(e[2])
            if k is None:
                return self.variable_power(e[1], e[2])
            need(k.denominator == 1, "the exponent of a matrix is a whole number")
            return self.matrices.power(e[1], int(k))
        return e

    # Numbers.
    def of_abs(self, x):
        return root_of_square(x)

    def of_max(self, a, *others):
        return self.extreme(a, others, 1)

    def of_min(self, a, *others):
        return self.extreme(a, others, -1)

    def extreme(self, a, others, sign):
        for b in others:
            top = N("sum", ((1, a), (1, b), (sign, root_of_square(plus(a, b, -1)))))
            a = N("prod", (("*", top), ("/", num(2))))
        return a

    def of_factorial(self, n):
        i = self.index()
        return N("over", "product", i, num(1), n, N("name", i))

    def of_binomial(self, n, k):
        i = self.index(n, k)
        top = N("sum", ((1, n), (1, num(1)), (-1, N("name", i))))
        return N("over", "product", i, num(1), k, N("prod", (("*", top), ("/", N("name", i)))))

    def index(self, *parts):
        """An index that occurs nowhere in the claim, nor in what is written out already."""
        taken = self.names.union(*map(used, parts))
        return next(n for n in itertools.chain(LETTERS, (f"i{k}" for k in itertools.count(1))) if n not in taken)

    # Matrices.
    def of_trace(self, e):
        return self.matrices.trace(e)

    def of_inverse(self, e):
        return self.matrices.inverse(e)

    def variable_power(self, base, exponent):
        """base^exponent as a matrix of members of families."""
        rows = self.matrices.square(base)
        if rows not in self.powers:
            self.powers[rows] = self.families(base, rows)
        return N("matrix", tuple(tuple(N("call", u, (exponent,)) for u in row) for row in self.powers[rows]))

    def families(self, base, rows):
        """Declares families for the entries of the powers of a matrix: M^0 = 1 and M^(k + 1) = M·M^k."""
        places = range(len(rows))
        room(len(rows) <= ROWS_LIMIT, f"a power of a matrix of {len(rows)} rows")
        entries = [e for row in rows for e in row]
        need(not set().union(*map(used, entries)) & self.inside, "a power of a matrix depends on a bound variable")
        need(all(map(self.values.exist_for, entries)), "the entries of a matrix may have no value")
        first = [base[1]] if base[0] == "name" else ["P", "Q", "R", "S"]
        stems = itertools.chain(first, (f"{stem}{k}" for k in itertools.count(2) for stem in first))
        all_names = ([[f"{stem}_{i + 1}{j + 1}" for j in places] for i in places] for stem in stems)
        names = next(names for names in all_names if all(self.fresh.is_free(u) for row in names for u in row))
        for row in names:
            for u in row:
                self.names.add(self.fresh.take(u))
        k = self.index(*entries)
        member = lambda u, index: N("call", u, (index,))
        binding = N("bind", tuple((u, k) for row in names for u in row), False, (), None)
        self.open.append(Node(("given", (binding,))))
        for i in places:
            for j in places:
                u = names[i][j]
                column = [member(names[l][j], N("name", k)) for l in places]
                step = compare(member(u, plus(N("name", k), num(1))), "=", sum_of_products(rows[i], column))
                index = N("bind", ((k, None),), True, (), None)
                for p in (compare(member(u, num(0)), "=", num(int(i == j))), N("all", (index,), step)):
                    self.open.append(Node(("assume", MADE, p)))
        return names


def root_of_square(x):
    return N("call", "sqrt", (N("pow", x, num(2)),))


def sum_of_products(row, column):
    """a·x + b·y + …, without what is 0 and without the factor 1."""
    terms = [x if a == num(1) else N("prod", (("*", a), ("*", x))) for a, x in zip(row, column) if a != num(0)]
    return added(terms) if terms else num(0)


def write_out(claim, fresh):
    Abbreviations(claim, fresh).write_out()
