"""Expressions as quotients of polynomials: section 5 of docs/certificates.md."""
import math
from fractions import Fraction as Q

from checker import circle
from checker.claims import as_power, BINDERS, FUNCTIONS, need, PI, room


# A polynomial is a dict {monomial: whole number}, a monomial a sorted tuple of (atom, exponent).
def monomial_product(m, n):
    powers = dict(m)
    for atom, k in n:
        powers[atom] = powers.get(atom, 0) + k
    return tuple(sorted(powers.items()))


def poly_product(p, q):
    out = {}
    for m, c in p.items():
        for n, d in q.items():
            both = monomial_product(m, n)
            out[both] = out.get(both, 0) + c * d
    return {m: c for m, c in out.items() if c}


class F:
    """c·∏ pᵢ^kᵢ: c a rational number, the pᵢ polynomials as sorted tuples, each an atom or without an atom as a factor,
    its coefficients without common divisor, the last one positive. Two fractions are equal iff their difference is 0."""

    def __init__(self, c, factors=()):
        self.c, self.factors = Q(c), dict(factors) if c else {}
        self.key = (self.c, tuple(sorted(self.factors.items())))
        self.integer = int(c) if not self.factors and self.c.denominator == 1 else None

    def __eq__(self, other):
        return self.key == other.key

    def __hash__(self):
        return hash(self.key)

    def __mul__(self, other):
        factors = dict(self.factors)
        for p, k in other.factors.items():
            factors[p] = factors.get(p, 0) + k
        return F(self.c * other.c, {p: k for p, k in factors.items() if k})

    def __neg__(self):
        return F(-self.c, self.factors)

    def __sub__(self, other):
        return total([self, -other])

    def power(self, k):
        unit = not self.factors and self.c in (0, 1, -1)
        room(unit or abs(k) <= 1000, "an exponent too large for this checker")
        need(self.c or k >= 0, "a division by 0")
        return F(self.c ** k, {p: j * k for p, j in self.factors.items()}) if k else ONE

    def expanded(self):
        """(c, polynomial), for a fraction without divisors."""
        out = {(): 1}
        for p, k in self.factors.items():
            for _ in range(k):
                out = poly_product(out, dict(p))
        return self.c, out

    def terms(self):
        """[(coefficient, monomial)], or None for a fraction with divisors."""
        if any(k < 0 for k in self.factors.values()):
            return None
        c, poly = self.expanded()
        return [(c * d, m) for m, d in sorted(poly.items())] if c else []

    def summands(self):
        """The terms, each over the divisors, where these are atoms; else itself."""
        top, bottom = self.parts()
        if any(the_atom(p) is None for p in bottom.factors):
            return [self]
        over = bottom.power(-1)
        return [monomial(m) * F(c) * over for c, m in top.terms()]

    def parts(self):
        top = F(self.c, {p: k for p, k in self.factors.items() if k > 0})
        return top, F(1, {p: -k for p, k in self.factors.items() if k < 0})

    def atoms(self):
        return {a for p in self.factors for m, _ in p for a, _ in m}

    def single(self):
        """(atom, k) if it is the k-th power of an atom."""
        if self.c == 1 and len(self.factors) == 1:
            (p, k), = self.factors.items()
            return (the_atom(p), k) if the_atom(p) is not None else None


ONE, ZERO = F(1), F(0)
NO_DERIVATIVE = "a derivative of a member of a family or sequence, of a product over an index, or of what stands in an integral"
# What a sum or product over an index, and an integral, binds in its body. While the body is read it is open: its number is minus
# that of these around it. In an atom it is closed: its number is 1 more than all that are bound in the body.
BOUND = {"over": "index", "integral": "place"}
# The atoms of arctan and arcsin, and where one is a known part of π: by the square of an argument that is positive.
ARCS = ("arctangent", "arcsine")
PARTS_OF_PI = {
    "arctangent": {Q(1, 3): Q(1, 6), Q(1): Q(1, 4), Q(3): Q(1, 3)},
    "arcsine": {Q(1, 4): Q(1, 6), Q(1, 2): Q(1, 4), Q(3, 4): Q(1, 3), Q(1): Q(1, 2)},
}


def turned(u, v):
    """The cosine and the sine of a sum from those of its two parts."""
    (c, s), (d, t) = u, v
    return total([c * d, -(s * t)]), total([s * d, c * t])


def multiple(point, k):
    """The cosine and the sine of k times what has this point."""
    out = ONE, ZERO
    for _ in range(k):
        out = turned(out, point)
    return out


def the_atom(p):
    return p[0][0][0][0] if len(p) == 1 and p[0][1] == 1 and len(p[0][0]) == 1 and p[0][0][0][1] == 1 else None


def atom(a):
    return F(1, {((((a, 1),), 1),): 1})


def numerator(c):
    """That of the number of an exponent; only its sign where it is above 100."""
    return c.numerator if abs(c.numerator) <= 100 else 1 if c > 0 else -1


def monomial(m):
    return F(1, {((((a, 1),), 1),): k for a, k in m})


def factored(scale, poly):
    """A polynomial with its number and its atoms set apart."""
    if not poly or not scale:
        return ZERO
    common = dict(min(poly, key=len))
    for m in poly:
        m = dict(m)
        common = {a: min(k, m[a]) for a, k in common.items() if a in m}
    rest = sorted((tuple((a, k - common.get(a, 0)) for a, k in m if k > common.get(a, 0)), c) for m, c in poly.items())
    content = math.gcd(*poly.values()) * (1 if rest[-1][1] > 0 else -1)
    rest = tuple((m, c // content) for m, c in rest)
    out = monomial(common.items()) * F(scale * content)
    return out * F(1, {rest: 1}) if len(rest) > 1 else out


def total(list_):
    """The sum: what all summands share is set apart, the rest multiplied out."""
    list_ = [f for f in list_ if f.c]
    if len(list_) < 2:
        return list_[0] if list_ else ZERO
    common = {p: min(f.factors.get(p, 0) for f in list_) for f in list_ for p in f.factors}
    common = F(1, {p: k for p, k in common.items() if k})
    expanded = [(f * common.power(-1)).expanded() for f in list_]
    below, out = math.lcm(*(c.denominator for c, _ in expanded)), {}
    for c, poly in expanded:
        for m, d in poly.items():
            out[m] = out.get(m, 0) + int(c * below) * d
    return factored(Q(1, below), {m: c for m, c in out.items() if c}) * common


def primes(c):
    """c > 0 as [(number, exponent)]; what has no divisor below 1000 is kept whole."""
    for rest, sign in ((c.numerator, 1), (c.denominator, -1)):
        for p in range(2, 1000):
            k = 0
            while rest % p == 0 and rest > 1:
                rest, k = rest // p, k + 1
            if k:
                yield p, sign * k
        if rest > 1:
            yield rest, sign


def coefficients(expanded, exponents):
    """The coefficients by powers of a number, of which these atoms are the powers with these exponents."""
    scale, poly = expanded
    out = {}
    for m, c in poly.items():
        degree = sum((exponents[a] * k for a, k in m if a in exponents), Q(0))
        own, rest = out.setdefault(degree, {}), tuple((a, k) for a, k in m if a not in exponents)
        own[rest] = own.get(rest, 0) + c
    out = {k: factored(scale, {m: c for m, c in p.items() if c}) for k, p in out.items()}
    return {k: p for k, p in out.items() if p.c}


def size(x):
    return None if isinstance(x, F) else (len(x), len(x[0]))


def each(change, x):
    return change(x) if isinstance(x, F) else [list(map(change, row)) for row in x]


def product(x, y):
    if isinstance(x, F) or isinstance(y, F):
        x, y = (x, y) if isinstance(x, F) else (y, x)
        return each(lambda f: f * x, y)
    need(len(x[0]) == len(y), "matrices of different sizes, or in order")
    return [[total([f * g for f, g in zip(row, column)]) for column in zip(*y)] for row in x]


def determinant(x):
    need(len(x) == len(x[0]) <= 5, "matrices of different sizes, or in order")
    minor = lambda j: [row[:j] + row[j + 1:] for row in x[1:]]
    return x[0][0] if len(x) == 1 else total([f * determinant(minor(j)) * F((-1) ** j) for j, f in enumerate(x[0])])


class Terms:
    """Names in scope, and expressions as fractions: section 5 of the page."""

    def __init__(self, claim):
        self.claim, self.scope = claim, {}
        self.atoms, self.ids, self.free, self.heights = [], {}, [], []
        self.equations, self.depth, self.serial = [], 0, 0
        self.families = {n: b for b in claim.given for n, i in b[1] if i is not None}
        self.sequences = {u[0]: u for u in claim.sequences}
        self.signs_of_members = {}

    # Names and atoms.
    def is_declared(self, n):
        return n in self.scope or n in self.families or n in self.sequences

    def declare(self, b):
        for n, index in b[1]:
            if index is None:
                need(not self.is_declared(n), f"the name {n} is in use")
                self.scope[n] = self.variable(n, b[2])

    def variable(self, n, natural):
        self.serial += 1
        return self.intern(("variable", n, natural, self.serial))

    def inside(self, names, run):
        """Runs something where names stand for atoms."""
        scope, self.scope = self.scope, {**self.scope, **names}
        try:
            return run()
        finally:
            self.scope = scope

    def intern(self, a):
        """The number of an atom. `free` holds the variables, indices and places on which it depends."""
        if a not in self.ids:
            self.ids[a] = len(self.atoms)
            self.atoms.append(a)
            free = set().union(*(self.free_in(f) for f in a if isinstance(f, F)))
            self.heights.append(max([self.height(f) for f in a if isinstance(f, F)] + [a[-4] if a[0] in BOUND else 0]))
            if a[0] in BOUND:
                *_, low, high, body = a
                free = self.free_in(low) | self.free_in(high) | self.free_in(body) - {self.bound_by(a)}
            self.free.append(free | ({self.ids[a]} if a[0] in ("variable", *BOUND.values()) else {"sequence"}
                                     if a[0] == "member" and a[1] in self.sequences else set()))
        return self.ids[a]

    def bound_by(self, a):
        """The number of the atom that an atom binds in its body."""
        return self.intern((BOUND[a[0]], a[-4]))

    def height(self, f):
        """The greatest number that is bound in a fraction."""
        return max((self.heights[a] for a in f.atoms()), default=0)

    def opened(self, run):
        """Runs something with the number of what one more sum, product or integral binds."""
        self.depth += 1
        try:
            return run(-self.depth)
        finally:
            self.depth -= 1

    def closed(self, tag, own, body):
        """The number that an atom binds in its body, and the body with it."""
        number = 1 + self.height(body)
        return number, self.renamed(tag, body, own, number)

    def renamed(self, tag, body, old, new):
        old, new = (self.intern((BOUND[tag], number)) for number in (old, new))
        return self.replaced(body, old, atom(new), {new: atom(new)})

    def free_in(self, f):
        return set().union(*(self.free[a] for a in f.atoms()))

    def atom(self, *a):
        number = self.intern(a)
        return next((value for left, value, _ in self.equations if left == number), None) or atom(number)

    def kind(self, p, *tags):
        """The parts of the single atom p, if it is of one of these kinds."""
        a = the_atom(p)
        return self.atoms[a] if a is not None and self.atoms[a][0] in tags else None

    def exponents(self, x):
        """The atoms that are powers of the atom x with a rational number as exponent: itself, and its roots."""
        roots = {n: a[2].c for n, a in enumerate(self.atoms) if a[0] == "power" and a[1] == atom(x) and not a[2].factors}
        return {**roots, x: Q(1)}

    def is_natural(self, a):
        kind, *parts = self.atoms[a]
        if kind == "member":
            return parts[0] in self.families and self.families[parts[0]][2]
        return kind == "index" or (kind == "variable" and parts[1])

    def is_whole(self, f):
        terms = f.terms()
        whole = lambda c, m: c.denominator == 1 and all(self.is_natural(a) for a, _ in m)
        return terms is not None and all(whole(c, m) for c, m in terms)

    def whole(self, f):
        need(self.is_whole(f), "an index or exponent that is not a whole number by its form")
        return f

    # Expressions as fractions: numbers are F, matrices lists of rows.
    def read(self, e, equations=()):
        f = self.value(e, equations)
        need(isinstance(f, F), "a number is needed where a matrix stands")
        return f

    def value(self, e, equations=()):
        before, self.equations = self.equations, equations
        try:
            return self.of(e)
        finally:
            self.equations = before

    def scalar(self, e):
        f = self.of(e)
        need(isinstance(f, F), "a number is needed where a matrix stands")
        return f

    def written(self, e):
        """The power or exponential that an expression is, read without equations; its exponent is no numeral."""
        if e[0] == "call" and e[1] == "exp" and len(e[2]) == 1:
            return "exp", self.read(e[2][0])
        if e := as_power(e):
            base, exponent = self.read(e[0]), self.read(e[1])
            return ("power", base, exponent) if exponent.integer is None else None

    def put_in(self, written):
        """What equals this power or exponential, or None."""
        return next((right for _, right, left in self.equations if left and left == written), None)

    def of(self, e):
        tag = e[0]
        if any(left for _, _, left in self.equations) and (found := self.put_in(self.written(e))):
            return found
        if tag == "num":
            return F(Q(e[1]))
        if tag == "name":
            if e[1] == PI and not self.is_declared(PI):
                return self.atom("pi")
            need(e[1] in self.scope, f"{e[1]} is not declared here")
            return self.atom(*self.atoms[self.scope[e[1]]])
        if tag == "neg":
            return each(lambda f: -f, self.of(e[1]))
        if tag == "sum":
            parts = [each(lambda f: f * F(s), self.of(part)) for s, part in e[1]]
            if all(isinstance(f, F) for f in parts):
                return total(parts)
            need(len(set(map(size, parts))) == 1, "matrices of different sizes, or in order")
            return [[total(column) for column in zip(*rows)] for rows in zip(*parts)]
        if tag == "prod":
            out = ONE
            for operator, part in e[1]:
                out = product(out, self.scalar(part).power(-1) if operator == "/" else self.of(part))
            return out
        if tag == "pow":
            return self.power(self.scalar(e[1]), self.exponent(e[2]))
        if tag == "over":
            low, high = self.whole(self.scalar(e[3])), self.whole(self.scalar(e[4]))
            need(e[2] != PI, f"the name {PI} is in use")
            body = lambda own: self.inside({e[2]: self.intern(("index", own))}, lambda: self.scalar(e[5]))
            return self.opened(lambda own: self.over(e[1], own, low, high, body(own)))
        if tag == "integral":
            return self.integral(*e[2:])
        if tag == "deriv":
            # An equation is true at the point, not around it: none is put in before all derivatives are taken.
            equations, self.equations = self.equations, ()
            try:
                f = self.scalar(e[1])
                for x in e[2]:
                    need(x in self.scope and not self.is_natural(self.scope[x]), f"{x} is no real variable")
                    f = self.derivative(f, self.scope[x])
                return self.replaced_all(f, equations)
            finally:
                self.equations = equations
        if tag == "matrix":
            return [[self.scalar(part) for part in row] for row in e[1]]
        return self.call(e[1], e[2])

    def integral(self, x, low, high, body):
        """An atom. Its variable is new, and known by its number, as an index is, so that its name does not matter."""
        ends = self.scalar(low), self.scalar(high)
        need(x != PI and not self.is_declared(x), f"the name {x} is in use")
        inside = lambda own: self.inside({x: self.intern(("place", own))}, lambda: self.scalar(body))
        return self.opened(lambda own: self.integral_of(own, *ends, inside(own)))

    def integral_of(self, own, low, high, body):
        own, body = self.closed("integral", own, body)
        return self.atom("integral", own, low, high, body)

    def call(self, f, arguments):
        need(len(arguments) == 1, f"{f} has one argument")
        if f in self.families or f in self.sequences:
            return self.atom("member", f, self.whole(self.scalar(arguments[0])))
        need(f in FUNCTIONS, f"{f} is not declared here")
        x = self.of(arguments[0])
        need(isinstance(x, F) != (f in ("det", "transpose")), "a number is needed where a matrix stands, or a matrix")
        if f == "det":
            return determinant(x)
        if f == "transpose":
            return [list(column) for column in zip(*x)]
        if f in ("sqrt", "cbrt"):
            return self.power(x, F(Q(1, 2 if f == "sqrt" else 3)))
        if f in ("exp", "ln"):
            return self.exponential(x) if f == "exp" else self.logarithm(x)
        if f in ("cos", "sin"):
            return self.point(x)[f == "sin"]
        if f in ("arcsin", "arccos", "arctan"):
            arc = self.arc("arctangent" if f == "arctan" else "arcsine", x)
            return total([self.atom("pi") * F(Q(1, 2)), -arc]) if f == "arccos" else arc
        up, down, half, plain = self.exponential(x), self.exponential(-x), F(Q(1, 2)), self.read(arguments[0])
        up, down = self.put_in(("exp", plain)) or up, self.put_in(("exp", -plain)) or down
        cosh, sinh = total([up, down]) * half, total([up, -down]) * half
        return {"cosh": cosh, "sinh": sinh, "sech": cosh.power(-1), "tanh": sinh * cosh.power(-1)}[f]

    def exponent(self, e):
        """A whole exponent stays one: an equation that makes another number of it is not put in."""
        new = self.scalar(e)
        plain = self.read(e) if self.equations and not self.is_whole(new) else new
        return plain if self.is_whole(plain) else new

    def power(self, b, e):
        if e.integer is not None:
            return b.power(e.integer)
        if b.integer == 1:
            return ONE
        if self.is_whole(e):
            terms = e.terms()
            if b.integer == -1:
                return self.sign_power(terms)
            if all(c > 0 for c, _ in terms):
                return self.natural_power(b, e, terms)
            return self.power(b, -e).power(-1) if all(c < 0 for c, _ in terms) else self.atom("power", b, e)
        out = ONE
        for part in e.summands():
            out *= self.power(b, part) if self.is_whole(part) else self.real_power(b, part)
        return out

    def real_power(self, b, e):
        """b^e for e that is not whole, so that b > 0, or b >= 0 under a root: (c^F)^E = c^(F*E)."""
        a, k = b.single() or (None, 1)
        inner = self.atoms[a] if a is not None else (None,)
        if inner[0] == "power" and not self.is_whole(inner[2]):
            return self.power(inner[1], inner[2] * e * F(k))
        if inner[0] == "exp":
            return self.exponential(inner[1] * e * F(k))
        top = numerator(e.c)
        return self.atom("power", b, e * F(Q(1, top))).power(top)

    def sign_power(self, terms):
        """(-1)^e: terms with even coefficients say nothing, and (-1)^-m is (-1)^m."""
        out = ONE
        for c, m in terms:
            if c % 2:
                out *= self.atom("power", F(-1), monomial(m)) if m else F(-1)
        return out

    def natural_power(self, b, e, terms):
        """b^e by the factors of b, for a sum e of products of natural numbers."""
        def plain(factor):
            out = ONE
            for c, m in terms:
                out *= (self.atom("power", factor, monomial(m)) if m else factor).power(int(c))
            return out
        if not b.c:
            return plain(b)
        out = self.sign_power(terms) if b.c < 0 else ONE
        for p, k in primes(abs(b.c)):
            out *= plain(F(p)).power(k)
        for p, k in b.factors.items():
            inner = self.kind(p, "power", "exp") or (None,)
            if inner[0] == "exp":
                factor = self.exponential(inner[1] * e)
            elif inner[0] == "power" and not self.is_whole(inner[2]) and inner[2].factors:
                factor = self.power(inner[1], inner[2] * e)
            elif inner[0] == "power" and self.is_whole(inner[2]):
                factor = ONE
                for c, m in terms:
                    factor *= self.atom("power", inner[1], inner[2] * monomial(m)).power(int(c))
            else:
                factor = plain(F(1, {p: 1}))
            out *= factor.power(k)
        return out

    def exponential(self, x):
        """exp(E + F) = exp E * exp F, exp(E*ln x) = x^E."""
        out = ONE
        for part in x.summands():
            logs = [p for p, k in part.factors.items() if k == 1 and self.kind(p, "ln")]
            if len(logs) == 1:
                rest = F(part.c, {p: k for p, k in part.factors.items() if p != logs[0]})
                out *= self.power(self.kind(logs[0], "ln")[1], rest)
            else:
                top = numerator(part.c)
                out *= self.atom("exp", part * F(Q(1, top))).power(top)
        return out

    def logarithm(self, x):
        a, k = x.single() or (None, 1)
        inner = self.atoms[a] if a is not None else (None,)
        if inner[0] == "exp":
            return inner[1] * F(k)
        if inner[0] == "power" and not self.is_whole(inner[2]):
            return self.logarithm(inner[1]) * inner[2] * F(k)
        return ZERO if x.integer == 1 else self.atom("ln", x)

    def point(self, u):
        """The cosine and the sine of u, by those of its terms."""
        out = ONE, ZERO
        for part in u.summands():
            out = turned(out, self.point_of_term(part))
        return out

    def point_of_term(self, part):
        pi = atom(self.intern(("pi",)))
        turns = part * pi.power(-1)
        if not turns.factors:
            if known := circle.of_turns(turns.c):
                return tuple(self.scalar(circle.written(p)) for p in known)
            # Full turns change nothing.
            part = pi * F((turns.c + 1) % 2 - 1)
        elif self.is_whole(turns * F(Q(1, 2))):
            return ONE, ZERO
        elif self.is_whole(turns):
            return self.power(F(-1), turns), ZERO
        # The terms p·v and −p·v have the same atoms.
        p = abs(part.c.numerator)
        p = p if p <= circle.MULTIPLE_LIMIT else 1
        v = part * F(Q(1 if part.c > 0 else -1, p))
        c, s = multiple(self.point_of_arc(v) or (self.atom("cos", v), self.atom("sin", v)), p)
        return (c, s) if part.c > 0 else (c, -s)

    def point_of_arc(self, v):
        """The cosine and the sine of an arctangent or arcsine, or None. Both arcs lie between −π/2 and π/2. There the cosine is
        not negative, so it is a root, read as one that is written."""
        a, k = v.single() or (None, 1)
        if k != 1 or a is None or self.atoms[a][0] not in ARCS:
            return None
        kind, f = self.atoms[a]
        root = self.power(total([ONE, f * f if kind == "arctangent" else -(f * f)]), F(Q(1, 2)))
        return (root, f) if kind == "arcsine" else (root.power(-1), f * root.power(-1))

    def arc(self, kind, f):
        """arctan or arcsin of f. Both are odd. A square tells which positive number it belongs to only where f is positive, as
        constant roots are: the square of sqrt(x^2)/x is 1 as well."""
        if f.c <= 0:
            return -self.arc(kind, -f) if f.c else ZERO
        part = PARTS_OF_PI[kind].get(self.square_of_root(f))
        return self.atom("pi") * F(part) if part else self.atom(kind, f)

    def square_of_root(self, f):
        """The square of a number, or of a number times roots of positive numbers, where it is rational; else None."""
        out = F(f.c * f.c)
        for p, k in f.factors.items():
            _, base, e = self.kind(p, "power") or (None, ZERO, ONE)
            twice = 2 * k * e.c
            if base.factors or e.factors or base.c <= 0 or twice.denominator != 1:
                return None
            out *= base.power(int(twice))
        return out.c

    def over(self, kind, own, low, high, body):
        """A sum term by term, a product factor by factor; what does not depend on the index is taken out. Divisors are
        taken out only where the range is not empty by its form: an empty sum of 1/n is 0, and not n·(1/n) for n = 0."""
        index, room = self.intern(("index", own)), total([high, ONE, -low])
        rest = room - ONE
        filled = self.is_whole(rest) and all(c > 0 for c, _ in rest.terms())

        def over(f):
            number, inner = self.closed("over", own, f)
            return self.atom("over", kind, number, low, high, inner)

        def free(p):
            return index not in self.free_in(F(1, {p: 1}))

        def divided(p):
            """Whether a power or exponential with a divisor in its exponent occurs."""
            atoms = [self.atoms[a] for a in F(1, {p: 1}).atoms()]
            return any(k < 0 for a in atoms if a[0] in ("power", "exp") for k in a[-1].factors.values())

        def split(f):
            out = {p: k for p, k in f.factors.items() if free(p) and (filled or k > 0 and not divided(p))}
            return F(f.c, out), F(1, {p: k for p, k in f.factors.items() if p not in out})

        if kind == "sum":
            outside, inner = split(body)
            below = F(1, {p: k for p, k in inner.factors.items() if k < 0 and free(p)})
            terms = (inner * below.power(-1)).terms()
            if terms is None:
                return over(inner) * outside
            parts = [split(monomial(m) * F(c)) for c, m in terms] if body.c else []
            parts = [(out, rest * below) for out, rest in parts]
            return total([out * (room if rest.integer == 1 else over(rest)) for out, rest in parts]) * outside
        if not body.c:
            return over(body)
        counted = self.is_whole(room) and all(c > 0 for c, _ in room.terms())
        constant = F(body.c)
        out = ONE if body.c == 1 else self.power(constant, room) if counted else over(constant)
        for p, k in body.factors.items():
            factor, taken = F(1, {p: 1}), free(p) and counted and (filled or not divided(p))
            out *= (self.power(factor, room) if taken else over(factor)).power(k)
        return out

    def derivative(self, f, x):
        """f·Σ kᵢ·pᵢ′/pᵢ."""
        need("sequence" not in self.free_in(f), NO_DERIVATIVE)
        terms = []
        for p, k in f.factors.items():
            by_atom = {}
            for m, c in p:
                for a, j in m:
                    if x in self.free[a]:
                        by_atom.setdefault(a, []).append(monomial(m) * atom(a).power(-1) * F(c * j * k))
            slope = total([total(parts) * self.atom_derivative(a, x) for a, parts in by_atom.items()])
            terms.append(slope * F(1, {p: -1}) * f)
        return total(terms)

    def atom_derivative(self, a, x):
        kind, *inner = self.atoms[a]
        if kind in ("variable", "place"):
            return ONE
        if kind == "integral":
            return self.integral_derivative(a, x)
        if kind == "over":
            word, bound, low, high, body = inner
            need(word == "sum", NO_DERIVATIVE)
            # The ends are whole numbers: they do not move.
            inside = lambda own: self.derivative(self.renamed(kind, body, bound, own), x)
            return self.opened(lambda own: self.over(word, own, low, high, inside(own)))
        need(kind in ("ln", "exp", "power", "cos", "sin", *ARCS), NO_DERIVATIVE)
        slope = self.derivative(inner[0], x)
        if kind == "ln":
            return slope * inner[0].power(-1)
        if kind in ("cos", "sin"):
            other = atom(self.intern(("sin" if kind == "cos" else "cos", inner[0])))
            return slope * (-other if kind == "cos" else other)
        if kind == "arctangent":
            return slope * total([ONE, inner[0] * inner[0]]).power(-1)
        if kind == "arcsine":
            return slope * self.power(total([ONE, -(inner[0] * inner[0])]), F(Q(1, 2))).power(-1)
        if kind == "exp":
            return slope * atom(a)
        base, e = inner
        terms = [slope * base.power(-1) * e]
        if x in self.free_in(e):
            terms.append(self.derivative(e, x) * self.logarithm(base))
        return total(terms) * atom(a)

    def integral_derivative(self, a, x):
        """What moves with an end is the value of the body there."""
        _, _, low, high, body = self.atoms[a]
        need(x not in self.free_in(body), NO_DERIVATIVE)
        place, terms = self.bound_by(self.atoms[a]), []
        for end, side in ((high, 1), (low, -1)):
            slope = self.derivative(end, x)
            if slope.c:
                terms.append(self.replaced_all(body, [(place, end, None)]) * slope * F(side))
        return total(terms)

    def replaced_all(self, f, equations):
        for left, value, _ in equations:
            if left is not None:
                f = self.replaced(f, left, value, {a: atom(a) for a in value.atoms() if a != left})
        return f

    def replaced(self, f, left, value, done):
        """f with an atom replaced by what equals it, also inside atoms; atoms of the value itself stay."""
        for a in f.atoms():
            if a not in done:
                done[a] = value if a == left else self.replaced_atom(a, left, value, done)
        if all(done[a] == atom(a) for a in f.atoms()):
            return f
        out = F(f.c)
        for p, k in f.factors.items():
            terms = []
            for m, c in p:
                term = F(c)
                for a, j in m:
                    term *= done[a].power(j)
                terms.append(term)
            out *= total(terms).power(k)
        return out

    def replaced_atom(self, a, left, value, done):
        kind, *inner = self.atoms[a]
        if kind in ("variable", "pi", *BOUND.values()):
            return atom(a)
        put_in = lambda f: self.replaced(f, left, value, done)
        if kind in BOUND:
            *word, bound, low, high, body = inner
            low, high = put_in(low), put_in(high)
            # The body is opened: nothing else in it, and nothing that is put in, has that number.
            inside = lambda own: put_in(self.renamed(kind, body, bound, own))
            if kind == "integral":
                return self.opened(lambda own: self.integral_of(own, low, high, inside(own)))
            return self.opened(lambda own: self.over(*word, own, self.whole(low), self.whole(high), inside(own)))
        new = [put_in(y) if isinstance(y, F) else y for y in inner]
        if new == inner:
            return atom(a)
        if kind == "member":
            return self.atom(kind, new[0], self.whole(new[1]))
        if kind == "power":
            return self.power(new[0], inner[1] if self.is_whole(inner[1]) and not self.is_whole(new[1]) else new[1])
        if kind in ("cos", "sin"):
            return self.point(new[0])[kind == "sin"]
        if kind in ARCS:
            return self.arc(kind, new[0])
        return self.exponential(new[0]) if kind == "exp" else self.logarithm(new[0])
