"""The rule `logic` of docs/certificates.md."""
from checker.claims import compare, need, put, Refused
from checker.signs import sign, SIGNS, TIMES, Values
from checker.terms import F


class Logic(Values):
    """What follows by connectives and the order of the reals."""

    def rule_logic(self, goal, s, known):
        pairs, statements, fixed, asked = {}, {}, {}, {}

        def form(p):
            if p[0] == "cmp":
                return ("and", [order(a, r, b) for a, r, b in zip(p[1], p[2], p[1][1:])])
            if p[0] in ("and", "or", "iff"):
                return (p[0], [form(part) for part in p[1]])
            if p[0] in ("not", "imp"):
                return (p[0], [form(part) for part in p[1:]])
            key = ("statement", put(p, {}))
            asked[key] = [p]
            return ("is", statements.setdefault(key, key), 4)

        def order(a, r, b):
            x, y = put(a, {}), put(b, {})
            key, signs = ((x, y), SIGNS[r]) if (y, x) not in pairs else ((y, x), TIMES[SIGNS[r]][1])
            asked.setdefault(key, []).append(compare(a, r, b))
            if key not in pairs:
                pairs[key] = key
                sides = self.value(a), self.value(b)
                difference = sides[0] - sides[1] if isinstance(sides[0], F) and isinstance(sides[1], F) else None
                if difference is not None and not difference.factors:
                    fixed[key] = sign(difference.c)
            return ("is", key, signs)

        premises, conclusion = [form(self.fact(label)) for label in s.sources], form(goal)
        always = set()
        for key, props in asked.items():
            try:
                for p in props:
                    self.has_value(p, known)
                always.add(key)
            except Refused:
                pass

        def holds(p, state):
            """True, False, or None where the state leaves it open."""
            if p[0] == "is":
                return None if p[1] not in state else state[p[1]] & p[2] != 0
            parts = [holds(part, state) for part in p[1]]
            if p[0] == "not":
                return None if parts[0] is None else not parts[0]
            if p[0] == "iff":
                return None if None in parts else len(set(parts)) == 1
            if p[0] == "imp":
                parts = [None if parts[0] is None else not parts[0], parts[1]]
            end = p[0] != "and"
            return end if end in parts else None if None in parts else not end

        def provides(p, state, premise=(True,)):
            """Its parts, but those of Q in P => Q only where P is one of these."""
            if p[0] == "is":
                return {p[1]}
            parts = p[1][:1] if p[0] == "imp" and holds(p[1][0], state) not in premise else p[1]
            return set().union(*(provides(part, state, premise) for part in parts))

        def search(state, open_):
            if any(holds(p, state) is False for p in premises):
                return
            if holds(conclusion, state) and provides(conclusion, state, (True, None)) <= always:
                return
            if open_:
                for value in (1, 2, 4) if open_[0] in pairs else (1, 4):
                    search({**state, open_[0]: value}, open_[1:])
                return
            need(holds(conclusion, state), "it does not follow from the cited facts")
            valued = always.union(*(provides(p, state) for p in premises))
            need(provides(conclusion, state) <= valued, "a part of it may have no value where the cited facts hold")

        search(fixed, [key for key in [*pairs, *statements] if key not in fixed])
