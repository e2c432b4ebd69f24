"""Recurrences that are written out as hypotheses have values by their form: section 14.2 of docs/certificates.md.

A hypothesis says of its expressions that they have values, which a definition does not.
"""
from .author import MADE
from .claims import need, nodes
from .everywhere import EVERYWHERE, is_above_zero, Values
from .signs import number


def need_values(items):
    """Refuses a recurrence whose right side may have no value, in the items of a claim as its author wrote them."""
    known = Known()
    for item in items:
        known.learn(item)
        if item[0] == "assume" and item[1] == MADE:
            p, index = item[2], set()
            if p[0] == "all":
                index, p = {n for b in p[1] for n, _ in b[1]}, p[2]
            need(known.exists(p[1][1], index), f"a member of {p[1][0][1]} may have no value")


class Known:
    """What the items so far tell of the names that they declare."""

    def __init__(self):
        self.values, self.natural, self.families, self.members = Values(), set(), {}, set()

    def learn(self, item):
        self.values.learn(item)
        if item[0] == "given":
            self.members = {n for b in item[1] for n, index in b[1] if index and not b[3] and b[4] is None}
            for b in item[1]:
                above = any(map(is_above_zero, b[3]))
                for n, index in b[1]:
                    if index and b[4] is None:
                        self.families[n] = above, b[2]
                    elif not index and b[2] and not above:
                        self.natural.add(n)

    def exists(self, e, index):
        tag, inner = e[0], index
        if tag == "name":
            here = e[1] in index or e[1] in self.natural or e[1] not in self.values.partial
        elif tag == "prod":
            here = all(operator == "*" or self.not_zero(part, index) for operator, part in e[1])
        elif tag == "pow":
            k = number(e[2])
            if k is None:
                here = self.positive(e[1], index) or self.whole(e[2], index)
            elif k.denominator == 1:
                here = k >= 0 or self.not_zero(e[1], index)
            else:
                here = self.not_negative(e[1], index) if k > 0 else self.positive(e[1], index)
        elif tag == "call":
            word, arguments = e[1], list(nodes(e))
            if word in ("sqrt", "cbrt"):
                here = all(self.not_negative(a, index) for a in arguments)
            elif word == "ln":
                here = all(self.positive(a, index) for a in arguments)
            elif word in EVERYWHERE:
                here = word not in self.values.partial
            else:
                here = word in self.members or word in self.families and all(self.whole(a, index) for a in arguments)
        elif tag == "over":
            here = number(e[3]) in (0, 1) and self.whole(e[4], index)
            inner = index | {e[2]}
        else:
            here = tag in ("num", "neg", "sum")
        return bool(here) and all(self.exists(part, inner) for part in nodes(e))

    def not_zero(self, e, index):
        tag = e[0]
        if tag == "num":
            return number(e) != 0
        if tag == "neg":
            return self.not_zero(e[1], index)
        if tag == "prod":
            return all(self.not_zero(part, index) for _, part in e[1])
        if tag == "pow":
            return self.not_zero(e[1], index)
        return self.positive(e, index)

    def positive(self, e, index):
        tag = e[0]
        if tag == "num":
            return number(e) > 0
        if tag == "name":
            return e[1] in self.values.positive
        if tag == "sum":
            parts = [part for _, part in e[1]]
            plain = all(sign == 1 for sign, _ in e[1]) and all(self.not_negative(part, index) for part in parts)
            return plain and any(self.positive(part, index) for part in parts)
        if tag == "prod":
            return all(self.positive(part, index) for _, part in e[1])
        if tag == "pow":
            return self.positive(e[1], index)
        if tag == "call" and e[1] in ("sqrt", "cbrt"):
            return all(self.positive(a, index) for a in nodes(e))
        return tag == "call" and (e[1] in ("exp", "cosh", "sech") or self.families.get(e[1], (False,))[0])

    def not_negative(self, e, index):
        tag = e[0]
        if tag == "num":
            return number(e) >= 0
        if tag == "sum":
            return all(sign == 1 and self.not_negative(part, index) for sign, part in e[1])
        if tag == "prod":
            return all(self.not_negative(part, index) for _, part in e[1])
        if tag == "pow":
            k = number(e[2])
            return k is not None and k.denominator == 1 and k % 2 == 0 or self.not_negative(e[1], index)
        return tag == "call" and e[1] in ("abs", "sqrt") or self.whole(e, index) or self.positive(e, index)

    def whole(self, e, index):
        """Whether e is a natural number by its form."""
        tag = e[0]
        if tag == "num":
            return number(e).denominator == 1
        if tag == "name":
            return e[1] in index or e[1] in self.natural
        if tag == "sum":
            return all(sign == 1 and self.whole(part, index) for sign, part in e[1])
        if tag == "prod":
            return all(operator == "*" and self.whole(part, index) for operator, part in e[1])
        if tag == "pow":
            return self.whole(e[1], index) and self.whole(e[2], index)
        return tag == "call" and self.families.get(e[1], (False, False))[1]
