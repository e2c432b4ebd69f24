"""Signs, and when an expression has a value: sections 6 and 7 of docs/certificates.md."""
from copy import copy
from fractions import Fraction as Q

from checker.claims import conjuncts, constraints, domain, N, names_in, need, nodes, Refused, single, text, to_the_ends
from checker.intervals import Bounds, Intervals
from checker.terms import ARCS, atom, F, factored, NO_DERIVATIVE, ONE, poly_product, size, Terms, the_atom, total

# A set of signs is a sum of 1 for negative, 2 for zero, 4 for positive.
SIGNS = {"=": 2, "!=": 5, "<": 1, "<=": 3, ">": 4, ">=": 6}
NOT_ZERO, POSITIVE, NOT_NEGATIVE, ANY = 5, 4, 6, 7
SETTLED = (1, 2, 4)
SHOWN = {5: "other than 0", 4: "positive", 6: "at least 0", 7: "a number"}


def sign(q):
    return 4 if q > 0 else 1 if q < 0 else 2


def table(rule):
    """The signs of a op b for all sets of signs of a and b."""
    return [[sum({1 << k for a in (-1, 0, 1) if s & 1 << a + 1 for b in (-1, 0, 1) if t & 1 << b + 1
                  for k in (0, 1, 2) if rule(a, b) & 1 << k}) for t in range(8)] for s in range(8)]


TIMES = table(lambda a, b: sign(a * b))
PLUS = table(lambda a, b: 7 if a * b < 0 else sign(a + b))


def sign_power(s, k):
    s = (s & 2) | (4 if s & 5 else 0) if k % 2 == 0 else s
    return s & NOT_ZERO if k < 0 else s


class Known:
    """What a step reads from the facts under `by` and `using`."""

    def __init__(self, notes=(), equations=(), for_all=(), ranges=(), bounds=None):
        self.notes, self.equations, self.for_all = dict(notes), list(equations), list(for_all)
        # (the atom of an index, its first value, its last)
        self.ranges, self.bounds = list(ranges), Bounds(bounds)

    def copy(self):
        return Known(self.notes, self.equations, self.for_all, self.ranges, self.bounds)

    def under(self, *range_):
        """The same with one more range, to read signs only."""
        out = copy(self)
        out.ranges, out.bounds = self.ranges + [range_], Bounds(self.bounds)
        return out

    def keep(self, p, signs):
        """Notes that the polynomial p has one of these signs."""
        self.bounds.note(p, p not in self.notes)
        self.notes[p] = self.notes.get(p, ANY) & signs


class TooLong(Refused):
    """A number in an exponent that is longer than this checker computes."""


def short(q):
    if max(q.numerator.bit_length(), q.denominator.bit_length()) > 1024:
        raise TooLong("limit reached: digits of an exponent")
    return q


def in_numerals(e):
    return e[0] == "num" or e[0] in ("neg", "sum", "prod", "pow") and all(map(in_numerals, nodes(e)))


def number(e):
    """The value of an expression of numerals alone, or None. A numeral by itself may have any length."""
    return Q(e[1]) if e[0] == "num" else value(e) if in_numerals(e) else None


def value(e):
    tag = e[0]
    if tag == "num":
        return short(Q(e[1]))
    parts = [value(y) for y in nodes(e)]
    if None in parts:
        return None
    if tag == "neg":
        return -parts[0]
    if tag == "sum":
        out = Q(0)
        for (s, _), v in zip(e[1], parts):
            out = short(out + s * v)
        return out
    if tag == "pow":
        base, k = parts
        if k.denominator != 1 or not base and k < 0:
            return None
        # A number of n bits is at least 2^(n - 1), and 0, 1 and -1 have one bit at most.
        bits = max(base.numerator.bit_length(), base.denominator.bit_length())
        short(Q(1 << min((bits - 1) * abs(int(k)), 2000)))
        return short(base ** int(k))
    out = Q(1)
    for (operator, _), v in zip(e[1], parts):
        if operator == "/" and not v:
            return None
        out = short(out * v if operator == "*" else out / v)
    return out


def exponent(e, is_whole):
    """The value of an exponent, None if it is not in numerals or too long, and whether its power is a whole one. `is_whole`
    says of an expression whether it is whole by its form."""
    try:
        k = number(e)
        return k, is_whole(e) if k is None else k.denominator == 1
    except TooLong:
        if is_whole(e):
            return None, True
        raise


def whole_by_form(e, is_whole_name):
    """Whether an expression is whole by its form; `is_whole_name` says it of a name or family."""
    inner = lambda y: whole_by_form(y, is_whole_name)
    try:
        v = number(e)
    except TooLong:
        v = None
    if v is not None:
        return v.denominator == 1
    if e[0] in ("name", "call"):
        return is_whole_name(e)
    if e[0] == "pow":
        k = number(e[2])
        return inner(e[1]) and k is not None and k >= 0 and k.denominator == 1
    divides = e[0] == "prod" and any(operator == "/" for operator, _ in e[1])
    return e[0] in ("neg", "sum", "prod") and not divides and all(map(inner, nodes(e)))


def put_in(p, atom, value, degree=20):
    """The polynomial p with another for an atom, if its degree in the atom is at most this."""
    out = {}
    for m, c in p:
        powers = dict(m)
        k = powers.pop(atom, 0)
        if k > degree:
            return None
        term = {tuple(sorted(powers.items())): c}
        for _ in range(k):
            term = poly_product(term, value)
        for m, d in term.items():
            out[m] = out.get(m, 0) + d
    return out


class Values(Intervals, Terms):
    """Signs of expressions and whether they have values, from what a step cites."""

    # Signs: in how many arguments of sines and cosines a question stands, and whether a fact is being noted.
    arguments, noting = 0, False

    def known(self, by, using):
        known = Known()
        for label in using:
            a, relation, b = single(self.fact(label))
            left, right = self.read(a, known.equations), self.read(b, known.equations)
            need(relation == "=", "an equation is needed")
            number, = left.atoms() if len(left.factors) == 1 and len(left.atoms()) == 1 else (None,)
            if number is not None and left != atom(number) * F(left.c):
                number = None
            written = self.written(a)
            need(number is not None or written, "the left side of an equation is no atom, power or exponential")
            # c*A = B says A = B/c. A value for a power is that of the left side as it is written.
            new = [(number, right * F(1 / left.c), None)] if number is not None else []
            known.equations = [(n, self.replaced_all(f, new), w) for n, f, w in known.equations] + new
            known.equations += [(None, right, written)] if written else []
        for label in by:
            self.learn(self.fact(label), known)
        return known

    def learn(self, p, known):
        if p[0] == "and":
            for part in p[1]:
                self.learn(part, known)
        if p[0] == "all" and len(p[1]) == 1 and len(p[1][0][1]) == 1:
            known.for_all.append(p)
        if p[0] == "cmp":
            for side in p[1]:
                self.learn_needs(side, known)
            for a, relation, b in zip(p[1], p[2], p[1][1:]):
                sides = self.value(a), self.value(b)
                if isinstance(sides[0], F) and isinstance(sides[1], F):
                    self.note(sides[0] - sides[1], SIGNS[relation], known)
                    if known.equations:
                        replaced = self.read(a, known.equations) - self.read(b, known.equations)
                        self.note(replaced, SIGNS[relation], known)

    def learn_needs(self, e, known):
        """A fact has a value, so that its divisors are not 0, and so on."""
        if e[0] not in ("over", "integral", "deriv"):
            for part in nodes(e):
                self.learn_needs(part, known)
        for part, signs, other in self.needs(e):
            if other is None:
                self.note(self.read(part), signs, known)
                if known.equations:
                    self.note(self.read(part, known.equations), signs, known)

    def learn_signs(self, f, signs, known):
        self.note(f, signs, known)
        if known.equations:
            self.note(self.replaced_all(f, known.equations), signs, known)

    def note(self, f, allowed, known):
        """Keeps what the sign of a fraction says of the one factor whose sign is open."""
        rest, open_ = sign(f.c), []
        for p, k in f.factors.items():
            self.noting = True
            signs = sign_power(self.poly_signs(p, known, {}), k)
            self.noting = False
            if signs in (1, 4):
                rest = TIMES[rest][signs]
            else:
                open_.append((p, k))
        if allowed & 2 == 0:
            for p, _ in open_:
                known.keep(p, NOT_ZERO)
        if len(open_) == 1 and rest in (1, 4):
            (p, k), = open_
            possible = (1, 4) if k < 0 else (1, 2, 4)
            signs = sum(s for s in possible if not TIMES[sign_power(s, k)][rest] & ~allowed)
            if not signs:
                return
            known.keep(p, signs)
            c = dict(p).get((), 0)
            beyond = POSITIVE if c < 0 and not signs & ~NOT_NEGATIVE else 1 if c > 0 and not signs & ~3 else 0
            if beyond:
                moved = factored(1, {m: d for m, d in p if m})
                if len(moved.factors) == 1 and set(moved.factors.values()) == {1}:
                    known.keep(next(iter(moved.factors)), TIMES[sign(moved.c)][beyond])

    def signs(self, f, known):
        signs = self.fraction_signs(f, known, {})
        if known.equations:
            signs &= self.fraction_signs(self.replaced_all(f, known.equations), known, {})
        return signs

    def fraction_signs(self, f, known, found):
        out = sign(f.c)
        for p, k in f.factors.items():
            out = TIMES[out][sign_power(self.poly_signs(p, known, found), k)]
        return out

    def poly_signs(self, p, known, found):
        one = the_atom(p)
        out = self.sum_signs(p, known, found) if one is None else self.atom_signs(one, known, found)
        out &= known.notes.get(p, ANY)
        for index, *ends in known.ranges:
            atoms = F(1, {p: 1}).atoms()
            if out not in (1, 2, 4) and index in atoms and not any(index in self.free_in(atom(a)) for a in atoms - {index}):
                # index = first + j = last - k with natural j and k; its atom stands for them.
                for end, one in zip(ends, (1, -1)):
                    c, end = end.expanded()
                    read = put_in(p, index, {((index, 1),): one, **{m: c * d for m, d in end.items()}})
                    if read is not None:
                        out &= self.sum_signs(read.items(), known, {**found, index: NOT_NEGATIVE})
        return out

    def sum_signs(self, terms, known, found):
        out = 2
        for m, c in terms:
            term = sign(c)
            for a, k in m:
                term = TIMES[term][sign_power(self.atom_signs(a, known, found), k)]
            out = PLUS[out][term]
        return out if out in SETTLED else out & self.interval_signs(terms, known)

    def atom_signs(self, a, known, found):
        if a not in found:
            signs = known.notes.get(next(iter(atom(a).factors)), ANY) & self.form_signs(a, known, found)
            found[a] = signs if signs in SETTLED else signs & self.interval_signs([(((a, 1),), 1)], known)
        return found[a]

    def form_signs(self, a, known, found):
        kind, *inner = self.atoms[a]
        if self.is_natural(a):
            return NOT_NEGATIVE
        if kind in ("exp", "pi"):
            return POSITIVE
        if kind == "ln":
            return self.fraction_signs(inner[0] - ONE, known, found)
        if kind in ARCS:
            # Both are 0 at 0 and rise.
            return self.fraction_signs(inner[0], known, found)
        if kind in ("cos", "sin"):
            return self.arc_signs(kind, inner[0], known)
        if kind == "power":
            base = self.fraction_signs(inner[0], known, found)
            if not self.is_whole(inner[1]):
                return POSITIVE if not base & 2 or inner[1].factors else NOT_NEGATIVE
            return next((s for s in (POSITIVE, NOT_NEGATIVE, NOT_ZERO) if not base & ~s), ANY)
        if kind == "over":
            kind, own, low, high, body = inner
            index = self.intern(("index", own))
            body = self.fraction_signs(body, known.under(index, low, high), {})
            if kind == "sum" and body in (1, 4) and not self.fraction_signs(high - low, known, found) & ~NOT_NEGATIVE:
                return body
            kinds = (NOT_NEGATIVE, 3) if kind == "sum" else (POSITIVE, NOT_NEGATIVE, NOT_ZERO)
            return next((s for s in kinds if not body & ~s), ANY)
        out = ANY
        if kind == "member":
            out = self.signs_of_members.get(inner[0], ANY)
            indices = self.families[inner[0]][4] if inner[0] in self.families else None
            whole = [("range", True, *indices, True)] if indices else []
            for _, (binding,), body in known.for_all:
                (k, index), limits = binding[1][0], list(binding[3])
                for p in conjuncts(body) if binding[2] and index is None and limits in ([], whole) else []:
                    left = p[1][0] if p[0] == "cmp" and len(p[2]) == 1 else p
                    if left[0] == "call" and left[1] == inner[0] and list(left[2]) == [N("name", k)] and p[1][1][0] == "num":
                        out &= PLUS[SIGNS[p[2][0]]][sign(Q(p[1][1][1]))]
        return out

    def arc_signs(self, kind, u, known):
        """The sine is positive for u from 0 to π and negative from −π to 0, the cosine positive for u from −π/2 to π/2 and
        negative from there to 3π/2. At the ends of these arcs it is 0."""
        pi = atom(self.intern(("pi",)))

        def signs(sign, turns):
            self.arguments += 1
            out = self.fraction_signs(total([u * F(sign), pi * F(turns)]), known, {})
            self.arguments -= 1
            return out
        # The length to the end that two arcs share, and that to the other end, on either side.
        shared, ends = (signs(1, 0), ((-1, 1), (1, 1))) if kind == "sin" else (signs(-1, Q(1, 2)), ((1, Q(1, 2)), (-1, Q(3, 2))))
        for length, end, beyond in zip((shared, TIMES[1][shared]), ends, (POSITIVE, 1)):
            if not length & 1:
                length |= signs(*end)
                if not length & 1:
                    return beyond | length & 2
        return ANY

    # Values.
    def is_whole_form(self, e):
        def is_natural(x):
            if x[0] == "name":
                return x[1] in self.scope and self.is_natural(self.scope[x[1]])
            return x[1] in self.families and self.families[x[1]][2]
        return whole_by_form(e, is_natural)

    def needs(self, e):
        """(part, signs it needs, None); or (base, NOT_ZERO, exponent), if the exponent may be not negative instead."""
        if e[0] == "prod":
            yield from ((part, NOT_ZERO, None) for operator, part in e[1] if operator == "/")
        elif e[0] == "pow":
            k, whole = exponent(e[2], self.is_whole_form)
            if not whole:
                yield e[1], NOT_NEGATIVE if k is not None and k > 0 else POSITIVE, None
            elif k is None or k < 0:
                yield e[1], NOT_ZERO, e[2] if k is None else None
        elif e[0] == "call" and e[1] in ("sqrt", "cbrt", "ln"):
            yield e[2][0], POSITIVE if e[1] == "ln" else NOT_NEGATIVE, None
        elif e[0] == "call" and e[1] in ("arcsin", "arccos"):
            yield from ((part, NOT_NEGATIVE, None) for part in to_the_ends(e[2][0]))

    def has(self, e, signs, known):
        found = self.fraction_signs(self.read(e), known, {})
        if known.equations:
            found &= self.fraction_signs(self.read(e, known.equations), known, {})
        return not found & ~signs

    def show(self, e, signs, known):
        need(self.has(e, signs, known), f"{text(e)} is not shown to be {SHOWN[signs]}")

    def in_range(self, e, differences, known):
        for f in differences:
            need(not self.signs(f, known) & ~NOT_NEGATIVE, f"the range or index of {text(e)} is not shown to be one")

    def show_whole(self, e):
        need(self.is_whole_form(e), "an index or exponent that is not a whole number by its form")

    def number_defined(self, e, known):
        """Whether e has a value and is a number; reading it shows that every name in it is declared."""
        self.defined(e, known)
        self.read(e)

    def defined(self, e, known):
        if e[0] == "over":
            for end in e[3:5]:
                self.defined(end, known)
                self.show_whole(end)
            low, high = self.read(e[3]), self.read(e[4])
            self.show(e[3], NOT_NEGATIVE, known)
            self.in_range(e, [total([high, ONE, -low])], known)
            known = known.copy()
            self.at_index(e[2], low, high, known, lambda: self.defined(e[5], known))
            return
        if e[0] == "integral":
            for end in e[3:5]:
                self.number_defined(end, known)
            self.between_ends(e, known, lambda inner: self.number_defined(e[5], inner))
            return
        for part in nodes(e):
            self.defined(part, known)
        if e[0] == "call" and self.is_declared(e[1]):
            for argument in e[2]:
                self.show_whole(argument)
                self.show(argument, NOT_NEGATIVE, known)
                ends = self.families[e[1]][4] if e[1] in self.families else None
                if ends:
                    index = self.read(argument)
                    self.in_range(e, [index - self.read(ends[0]), self.read(ends[1]) - index], known)
        for part, signs, exponent in self.needs(e):
            if exponent is None or not self.has(exponent, NOT_NEGATIVE, known):
                self.show(part, signs, known)
        if e[0] == "deriv":
            self.smooth(e[1], e[2], known)

    def between_ends(self, e, known, run):
        """Runs something where the variable of an integral is a new real number between its ends; if signs do not tell which of
        them is the lower one, it is any real number. A sign that both ends have is that of all numbers between."""
        _, _, x, low, high, _ = e
        signs, limits = self.signs(self.read(high) - self.read(low), known), ()
        if not signs & 1:
            limits = (("interval", True, low, high, True),)
        elif not signs & 4:
            limits = (("interval", True, high, low, True),)
        both = self.signs(self.read(low), known) | self.signs(self.read(high), known)
        for side in (">", ">=", "<", "<="):
            if not both & ~SIGNS[side]:
                limits += (("relation", side, N("num", "0")),)
                break
        self.within((N("bind", ((x, None),), False, limits, None),), known, run)

    def at_index(self, name, low, high, known, run):
        """Runs something where a name is a natural number between low and high."""
        index = self.variable(name, True)
        known.ranges.append((index, low, high))
        for f in (atom(index) - low, high - atom(index)):
            self.learn_signs(f, NOT_NEGATIVE, known)
        self.learn_for_all(index, known, True)
        return self.inside({name: index}, run)

    def learn_for_all(self, index, known, natural):
        """What cited facts `for all` numbers of a kind say of an index or bound variable of that kind that lies in their domain."""
        for _, (binding,), body in list(known.for_all):
            (name, family), kind = binding[1][0], bool(binding[2])
            if family is not None or kind != natural:
                continue
            def learn():
                for p in constraints(binding, N("name", name)):
                    a, relation, b = single(p)
                    if self.signs(self.read(a) - self.read(b), known) & ~SIGNS[relation]:
                        return
                for part in conjuncts(body):
                    if part[0] != "all":
                        self.learn(part, known)
            self.inside({name: index}, learn)

    def smooth(self, e, by, known):
        """Whether what has a value can be differentiated: what is needed holds nearby as well."""
        if e[0] == "over":
            need(e[2] not in by, "a derivative by an index")
            if set(by) & names_in(e):
                need(e[1] == "sum", "a derivative of a product over an index")
                known = known.copy()
                self.at_index(e[2], self.read(e[3]), self.read(e[4]), known, lambda: self.smooth(e[5], by, known))
            return
        if e[0] == "integral":
            # Only its ends move. All around them, and between them, the body keeps its value and its own derivatives.
            need(not set(by) & ({e[2]} | names_in(e[5])), NO_DERIVATIVE)
            for end in e[3:5]:
                self.smooth(end, by, known)
            self.between_ends(e, known, lambda inner: self.smooth(e[5], (e[2],), inner))
            return
        for part, signs, exponent in self.needs(e):
            if e[0] != "prod":
                self.show(part, POSITIVE if signs == NOT_NEGATIVE else signs, known)
        for part in nodes(e):
            self.smooth(part, by, known)

    def has_value(self, p, known):
        tag = p[0]
        if tag == "cmp":
            sizes = set()
            for e in p[1]:
                self.defined(e, known)
                sizes.add(size(self.value(e)))
            ordered = any(r not in ("=", "!=") for r in p[2])
            need(len(sizes) == 1 and not (ordered and sizes != {None}), "matrices of different sizes, or in order")
        elif tag in ("all", "exists"):
            self.within(p[1], known, lambda inner: self.has_value(p[2], inner))
        elif tag == "extremum":
            for e in [e for _, e in p[5]] + [p[6]]:
                self.number_defined(e, known)
            self.within(p[4], known, lambda inner: self.number_defined(p[3], inner))
        elif tag == "imp":
            self.has_value(p[1], known)
            known = known.copy()
            self.learn(p[1], known)
            self.has_value(p[2], known)
        else:
            need(tag != "limit", "a limit cannot be supposed")
            for part in nodes(p):
                self.has_value(part, known)

    def within(self, bindings, known, run):
        """Runs something where the names of bindings are declared and their domains known."""
        known = known.copy()
        def enter():
            for b in bindings:
                need(all(i is None for _, i in b[1]), "families are declared by the claim only")
                self.declare(b)
                for p in domain([b]):
                    for e in p[1]:
                        self.defined(e, known)
                    self.learn(p, known)
                if len(b[1]) == 1 and not b[2]:
                    self.learn_for_all(self.scope[b[1][0][0]], known, False)
            return run(known)
        return self.inside({}, enter)
