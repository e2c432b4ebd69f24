"""sin, cos, tan and π, written out in cosines and sines as numbers: section 14.5 of docs/certificates.md."""
from fractions import Fraction as Q
from math import lcm

from . import circle
from .arcs import Bounds, linear, total
from .author import OF_ANGLES
from .claims import compare, N, need, Node, nodes, NotCovered, num, PI, put, Refused, room
from .walk import bottom_up, bound, children, clauses, declared, every, expressions, need_room, parts, size, used

NO_ANGLE = "an angle is a sum of variables and pi with rational coefficients"
OTHERWISE = "an angle is used otherwise than in sin, cos and tan, in bounds and in equations"


def conjunction(list_):
    return list_[0] if len(list_) == 1 else N("and", tuple(list_))


class Angles:
    """The angles of one claim."""

    def __init__(self, claim, fresh):
        self.claim, self.fresh = claim, fresh
        own = {n for item in claim.items for n in declared(item)}.union(*map(bound, clauses(claim)))
        self.words = [w for w in OF_ANGLES if w not in own]
        self.is_pi = PI not in own
        # The angles, each with the denominator d of the part θ/d that is named, and the names of its cosine and sine.
        self.over, self.names, self.declared = {}, {}, set()
        self.bounds, self.equations, self.definitions, self.nodes = {}, [], {}, 0

    def occur(self):
        """Whether the claim speaks of angles."""
        mentioned = set().union(*map(used, clauses(self.claim)))
        return bool(mentioned & set(self.words)) or self.is_pi and PI in mentioned

    def write_out(self):
        claim = self.claim
        self.put_in_functions()
        self.find()
        for clause in clauses(claim):
            for x in parts(clause):
                need(x[0] != "deriv" or not set(x[2]) & set(self.over), "a derivative by an angle is that of a function")
                need(x[0] != "integral" or x[2] not in self.over, "an integral over an angle is that of a function")
        for name, over in sorted(self.over.items()):
            part = name if over == 1 else f"{name}_over_{over}"
            self.names[name] = self.fresh.name(f"cos_{part}"), self.fresh.name(f"sin_{part}")
        items, claim.items = claim.items, []
        for item in items:
            claim.items += self.item(item)
        claim.sample = self.values(claim.sample, False)
        claim.goal = self.statement(claim.goal)
        claim.argument = [self.step(step) for step in claim.argument]
        need(self.declared == set(self.over), "an angle is a natural number, an index or a member of a family")

    def spend(self, count):
        """Counts nodes that are written."""
        self.nodes += count
        need_room(self.nodes)

    def tangents(self):
        """Writes tan(u) as sin(u)/cos(u)."""
        def change(e):
            if "tan" not in self.words or e[0] != "call" or e[1] != "tan":
                return e
            return N("prod", (("*", N("call", "sin", e[2])), ("/", N("call", "cos", e[2]))))

        clause = lambda x: expressions(x, lambda e: bottom_up(e, change))
        self.claim.items = list(map(clause, self.claim.items))
        every(self.claim, clause)

    # What the angles are.
    def function(self, e):
        """The function and the argument of `sin(u)`, `cos(u)` or `tan(u)`."""
        return (e[1], e[2][0]) if e[0] == "call" and e[1] in self.words else None

    def angle(self, e):
        x = linear(e, self.definitions, self.is_pi)
        return None if x is None or x[0] else x[1:]

    def put_in_functions(self):
        """Definitions with parameters that use sin, cos or tan are put in where they are applied."""
        functions, items = {}, []

        def changed(e):
            e = put(e, functions, None)
            self.spend(size(e))
            return e

        def clause(x):
            return expressions(x, changed) if functions else x

        for item in self.claim.items:
            item = clause(item)
            if item[0] == "let" and item[2] and any(map(self.function, parts(item[3]))):
                functions[item[1]] = Node(("define", *item[2:]))
            else:
                items.append(item)
        self.claim.items = list(map(clause, items))
        every(self.claim, clause)

    def find(self):
        for item in self.claim.items:
            if item[0] == "let" and not item[2] and (value := linear(item[3], self.definitions, self.is_pi)):
                self.definitions[item[1]] = value
        for clause in clauses(self.claim):
            for e in parts(clause):
                if found := self.function(e):
                    angle = self.angle(found[1])
                    need(angle, NO_ANGLE)
                    self.note(angle)
        for item in self.claim.items:
            for b in item[1] if item[0] == "given" else ():
                ends = [self.angle(e) for c in b[3] for e in c if isinstance(e, Node)]
                if any(angle and angle[0] for angle in ends):
                    self.note((Q(0), {n: Q(1) for n, _ in b[1]}))
        before = None
        while before != self.over:
            before = dict(self.over)
            self.equations, comparisons = [], list(self.comparisons())
            for a, relation, b in comparisons:
                if relation == "=":
                    self.note(self.difference(a, b))
        for a, relation, b in comparisons:
            turns, of = difference = self.difference(a, b)
            if relation == "=":
                self.equations.append(difference)
                continue
            need(len(of) == 1, OTHERWISE)
            ((name, k),) = of.items()
            relation = circle.TURNED.get(relation, relation) if k < 0 else relation
            need(self.bounds.setdefault(name, Bounds()).narrow(relation, -turns / k), OTHERWISE)

    def comparisons(self):
        """The comparisons of angles among the hypotheses."""
        for item in self.claim.items:
            if item[0] == "assume" and item[2][0] == "cmp" and self.is_about_angles(item[2]):
                yield from zip(item[2][1], item[2][2], item[2][1][1:])

    def note(self, angle):
        for name, k in angle[1].items():
            self.over[name] = lcm(self.over.get(name, 1), k.denominator)
            room(self.over[name] <= circle.MULTIPLE_LIMIT, f"the angle {name} is divided by {self.over[name]}")

    def difference(self, a, b):
        out = [self.angle(a), self.angle(b)]
        need(None not in out, OTHERWISE)
        return total([(1, (Q(0), *out[0])), (-1, (Q(0), *out[1]))])[1:]

    def is_angle(self, name):
        if name in self.over:
            return True
        number, turns, of = self.definitions.get(name, (1, 0, {}))
        return not number and bool(turns or set(of) & set(self.over))

    def is_about_angles(self, x):
        """Whether an angle occurs outside sin, cos and tan."""
        if x[0] == "call" and self.function(x):
            return False
        return x[0] == "name" and self.is_angle(x[1]) or any(map(self.is_about_angles, nodes(x)))

    # Expressions.
    def point(self, angle):
        """The cosine and the sine of an angle in those of the named ones."""
        turns, of = angle
        out = circle.of_turns(turns)
        need(out, "the cosine and sine of this multiple of pi are not known")
        for name, k in sorted(of.items()):
            need(name in self.over, NO_ANGLE)
            part = circle.named(*self.names[name])
            out = circle.together(out, circle.multiple(part, int(k * self.over[name])))
        self.spend(10 * (len(out[0]) + len(out[1])))
        return out

    def written(self, angle):
        """The cosine and the sine as expressions."""
        return [circle.written(p) for p in self.point(angle)]

    def expression(self, e):
        if found := self.function(e):
            cos, sin = self.written(self.angle(found[1]))
            return {"cos": cos, "sin": sin}.get(found[0]) or N("prod", (("*", sin), ("/", cos)))
        if e[0] == "name":
            need(not self.is_angle(e[1]) and not (e[1] == PI and self.is_pi), OTHERWISE)
        return children(e, self.expression)

    # Propositions.
    def statement(self, p):
        if p[0] in ("exists", "all"):
            bindings, conditions = self.bindings(p[1], False)
            body = self.statement(p[2])
            if conditions:
                body = N("and", (*conditions, body)) if p[0] == "exists" else N("imp", conjunction(conditions), body)
            return N(p[0], bindings, body)
        if p[0] == "extremum" and any(n in self.over for b in p[4] for n, _ in b[1]):
            need(all(n in self.over for b in p[4] for n, _ in b[1]), "an extremum over angles and numbers together")
            return self.extremum(p)
        if p[0] in ("limit", "approach"):
            need(not self.is_angle(p[2]), "the variable of a limit is an angle")
        if p[0] in ("cmp", "limit", "approach", "extremum"):
            return expressions(p, self.expression)
        return children(p, self.statement)

    def extremum(self, p):
        """No value is beyond the one at the place; with `only`, no other angles have it."""
        _, word, only, of, over, at, value = p
        bindings, conditions = self.bindings(over, False)
        of, value, place, there = self.expression(of), self.expression(value), {}, []
        for name, e in at:
            angle = self.angle(e)
            bounds = self.bounds.get(name, Bounds())
            need(angle and not angle[1] and bounds.hold(angle[0]), "the place of an extremum is an angle within")
            need(not only or bounds.are_less_than_a_turn(), "an extremum over all angles has more than one place")
            values = self.written((angle[0] / self.over[name], {}))
            for n, v in zip(self.names[name], values):
                place[n] = v
                there.append(compare(N("name", n), "=", v))
        said = [compare(of, "<=" if word == "maximum" else ">=", value), compare(put(of, place, None), "=", value)]
        if only:
            said.append(N("imp", compare(of, "=", value), conjunction(there)))
        body = N("and", tuple(said))
        return N("all", bindings, N("imp", conjunction(conditions), body))

    def bindings(self, bindings, is_given):
        """The bindings with cosine and sine in place of angles, and what holds of these."""
        out, conditions = [], []
        for b in bindings:
            others = tuple(pair for pair in b[1] if pair[0] not in self.over)
            if others:
                out.append(expressions(N("bind", others, *b[2:]), self.expression))
            for name, index in b[1]:
                if name not in self.over:
                    continue
                need(not b[2] and not b[4] and index is None, f"{name} cannot be an angle")
                bounds = self.bounds.get(name, Bounds()) if is_given else Bounds()
                bounds = self.bounds[name] = self.narrowed(Bounds(bounds.low, bounds.high), b)
                self.declared.add(name)
                cos, sin = self.names[name]
                out.append(N("bind", ((cos, None), (sin, None)), False, (), None))
                squares = [(1, N("pow", N("name", n), num(2))) for n in (cos, sin)]
                conditions.append(compare(N("sum", tuple(squares)), "=", num(1)))
                more = bounds.conditions(circle.named(cos, sin), self.over[name])
                need(more is not None, f"these bounds of {name} cannot be used")
                conditions += more
        return tuple(out), conditions

    def narrowed(self, bounds, b):
        for c in b[3]:
            ends = [(c[1], c[2])] if c[0] == "relation" else \
                [(">=" if c[1] else ">", c[2]), ("<=" if c[4] else "<", c[3])]
            for relation, e in ends:
                angle = self.angle(e)
                need(c[0] != "range" and angle and not angle[1] and bounds.narrow(relation, angle[0]), OTHERWISE)
        return bounds

    # Clauses.
    def item(self, item):
        if item[0] == "given":
            bindings, conditions = self.bindings(item[1], True)
            return [Node(("given", bindings))] + [Node(("assume", None, p)) for p in conditions]
        if item[0] == "let" and self.is_angle(item[1]):
            return []
        if item[0] == "let":
            hidden = {p: self.over.pop(p) for p in item[2] if p in self.over}
            item = expressions(item, self.expression)
            self.over.update(hidden)
            return [item]
        if item[0] != "assume":
            return [expressions(item, self.expression)]
        if item[2][0] != "cmp" or not self.is_about_angles(item[2]):
            return [Node(("assume", item[1], self.statement(item[2])))]
        sides, relations = item[2][1:]
        said = [p for a, r, b in zip(sides, relations, sides[1:]) if r == "=" for p in self.equation(a, b)]
        need(said or item[1] is None, "bounds of an angle have no label")
        return [Node(("assume", item[1], conjunction(said)))] if said else []

    def equation(self, a, b):
        """An equation between angles as two equations of cosines and sines."""
        turns, of = self.difference(a, b)
        single = [name for name, k in sorted(of.items()) if abs(k * self.over[name]) == 1]
        alone = [name for name in single if self.is_free(name)]
        need(alone or self.turns_are_known(turns, of), "the two sides may differ by a multiple of 2*pi")
        if not single:
            cos, sin = self.written((turns, of))
            return [compare(cos, "=", num(1)), compare(sin, "=", num(0))]
        name = (alone or single)[-1]
        sign = -1 if of[name] > 0 else 1
        rest = sign * turns, {n: sign * k for n, k in of.items() if n != name}
        return [compare(N("name", n), "=", e) for n, e in zip(self.names[name], self.written(rest))]

    def is_free(self, name):
        """Whether an angle has no bounds and occurs in one equation only."""
        bounds = self.bounds.get(name, Bounds())
        return bounds.low is bounds.high is None and sum(name in of for _, of in self.equations) == 1

    def turns_are_known(self, turns, of):
        """Whether the bounds exclude every multiple of 2π but 0 as a value of the sum."""
        low, high = (turns, True), (turns, True)
        for name, k in of.items():
            bounds = self.bounds.get(name, Bounds())
            if bounds.low is None or bounds.high is None:
                return False
            ends = (bounds.low, bounds.high) if k > 0 else (bounds.high, bounds.low)
            low, high = ((x + k * end, attained and belongs) for (x, attained), (end, belongs) in zip((low, high), ends))
        return (low[0] > -2 or low == (-2, False)) and (high[0] < 2 or high == (2, False))

    # Arguments and samples, which may hold floors.
    def step(self, step):
        if step[0] == "have":
            return Node(("have", step[1], self.statement(step[2]), tuple(map(self.step, step[3]))))
        if step[0] == "obtain":
            _, b, label, p, value = step
            return Node(("obtain", expressions(b, self.expression), label, self.statement(p), self.expression(value)))
        are_values = step[2] and step[2][0][0] == "value"
        mentioned = self.values(step[2], bool(step[1])) if are_values else tuple(map(self.expression, step[2]))
        return Node(("by", step[1], tuple(mentioned), tuple(map(self.step, step[3]))))

    def values(self, values, are_cited):
        """The values without those of angles. Those for a cited claim are for its variables: there an angle stands for an angle."""
        out = []
        for _, n, e in values:
            angle = self.angle(e)
            if angle and (n in self.over or are_cited and (angle[0] or set(angle[1]) & set(self.over))):
                over = self.over.get(n, 1)
                self.point((angle[0] / over, {name: k / over for name, k in angle[1].items()}))
            else:
                need(n not in self.over, OTHERWISE)
                out.append(Node(("value", n, self.expression(e))))
        return out


def write_out(claim, fresh):
    """Writes the angles of a claim out; where something is no use of an angle, sin, cos and pi stay, and tan alone is written out."""
    angles = Angles(claim, fresh)
    if not angles.occur():
        return
    for clause in clauses(claim):
        for e in parts(clause):
            need(not angles.function(e) or len(e[2]) == 1, f"{e[1]} takes one argument")
    before, taken = dict(vars(claim)), set(fresh.taken)
    try:
        angles.write_out()
    except (Refused, NotCovered):
        vars(claim).update(before)
        fresh.taken = taken
        angles.tangents()
