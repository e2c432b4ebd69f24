"""Limits at a point, from one side, and infinite ones: section 14.6 of docs/certificates.md."""
from .claims import compare, N, names_in, need, Node, num, plus, put
from .walk import children, fits


class Limits:
    """The limits of one claim, written out as limits at infinity."""

    def __init__(self, claim, fresh):
        self.claim, self.fresh, self.names = claim, fresh, {}
        bindings = [b for item in claim.items if item[0] == "given" for b in item[1]]
        self.natural = {n: b[2] for b in bindings for n, index in b[1] if not b[3] and index is None}

    def write_out(self):
        items, self.claim.items = self.claim.items, []
        for item in items:
            self.claim.items.append(self.clause(item))
        self.claim.goal = self.clause(self.claim.goal)
        self.claim.argument = [self.clause(step) for step in self.claim.argument]

    def clause(self, x):
        if x[0] == "approach":
            parts = self.written(*x[1:])
            return parts[0] if len(parts) == 1 else N("and", tuple(parts))
        return children(x, self.clause)

    def written(self, of, v, _, point, sides, value):
        natural = self.natural.get(v)
        need(natural is False or natural and point is None, f"{v} is no variable that only this limit declares")
        definitions, tied = self.that_mention(v)
        of = put(of, definitions, None)
        need(not names_in(of) & tied, f"a sequence depends on {v}, which moves")
        fixed = [e for e in (point, value) if isinstance(e, Node)]
        need(not any(names_in(e) & {v, *definitions, *tied} for e in fixed), f"the point or value of a limit depends on {v}")
        near = [of]
        if point is not None:
            near = [fits(put(of, {v: beside(point, side, v)}, None)) for side in sides]
        out = [p for f in near for p in self.says(f, v, natural, value)]
        # Nothing is left of the point, and it has to have a value.
        return out if point is None or v in names_in(of) else out + [compare(point, "=", point)]

    def that_mention(self, v):
        """The definitions that speak of a variable, directly or through others, and the sequences that do."""
        definitions, tied = {}, set()
        for item in self.claim.items:
            if item[0] == "let":
                value = put(item[3], {n: x for n, x in definitions.items() if n not in item[2]}, None)
                if (names_in(value) - set(item[2])) & {v, *tied}:
                    definitions[item[1]] = Node(("define", item[2], value))
            elif item[0] == "define":
                names = names_in(put(item[2], definitions, None)) | names_in(put(item[4], definitions, None)) - {item[3]}
                if names & {v, *tied}:
                    tied.add(item[1])
        return definitions, tied

    def says(self, of, v, natural, value):
        """The limit of a function whose variable grows. An infinite one: it is beyond 0 from some value on, and 1/F tends to 0."""
        if isinstance(value, Node):
            return [N("limit", of, v, value)]
        if v not in self.names:
            self.names[v] = self.fresh.name(f"{v}_from"), self.fresh.name(f"{v}_later")
        start, later = self.names[v]
        there = compare(put(of, {v: N("name", later)}, None), ">" if value else "<", num(0))
        from_there = N("bind", ((later, None),), natural, (("relation", ">=", N("name", start)),), None)
        some = N("bind", ((start, None),), natural, (("relation", ">", num(0)),), None)
        inverse = N("prod", (("*", num(1)), ("/", of)))
        return [N("exists", (some,), N("all", (from_there,), there)), N("limit", inverse, v, num(0))]


def beside(point, side, v):
    """point + 1/v or point - 1/v"""
    step = N("prod", (("*", num(1)), ("/", N("name", v))))
    if point != num(0):
        return plus(point, step, side)
    return step if side == 1 else N("neg", step)


def write_out(claim, fresh):
    Limits(claim, fresh).write_out()
