"""Which expressions have a value wherever the hypotheses hold by how they are written: section 14.2 of docs/certificates.md."""
from .claims import nodes
from .signs import number

EVERYWHERE = ("abs", "max", "min", "exp", "cos", "sin", "arctan", "cosh", "sinh", "sech", "tanh")
UP = {"<": (0, 1, True), "<=": (0, 1, False), ">": (1, 0, True), ">=": (1, 0, False)}


def is_above_zero(c):
    """Whether a constraint keeps a name above 0."""
    bound = number(c[2])
    if bound is None or c[0] == "relation" and c[1] not in (">", ">="):
        return False
    included = c[1] == ">=" if c[0] == "relation" else c[1]
    return bound > 0 or bound == 0 and not included


class Values:
    """What the items of a claim, in their order, tell of the names that they declare. Below, `index` are the names that are natural
    numbers within a recurrence or sum, and `members` the sequences that the last item declares."""

    def __init__(self):
        self.partial, self.positive, self.natural, self.families, self.members = set(), set(), set(), {}, set()

    def learn(self, item):
        if item[0] == "given":
            self.members = {n for b in item[1] for n, index in b[1] if index and not b[3] and b[4] is None}
            for b in item[1]:
                above = any(map(is_above_zero, b[3]))
                for n, index in b[1]:
                    if index:
                        self.partial.add(n)
                        if b[4] is None:
                            self.families[n] = above, b[2]
                        continue
                    if above:
                        self.positive.add(n)
                    if b[2]:
                        self.natural.add(n)
        elif item[0] == "define" or item[0] == "let" and (item[2] or not self.exist_for(item[3])):
            self.partial.add(item[1])
        elif item[0] == "assume":
            self.suppose(item[2])

    def suppose(self, p):
        """A hypothesis puts variables above what is positive, or strictly above what is not negative."""
        if p[0] == "and":
            for q in p[1]:
                self.suppose(q)
        elif p[0] == "cmp":
            pairs = [(p[1][k:], *UP[r]) for k, r in enumerate(p[2]) if r in UP]
            for sides, low, high, strict in pairs if p[2][0] in ("<", "<=") else pairs[::-1] if p[2][0] in (">", ">=") else pairs:
                above = self.is_positive(sides[low], ()) or strict and self.is_not_negative(sides[low], ())
                if above and sides[high][0] == "name":
                    self.positive.add(sides[high][1])

    def exist_for(self, e):
        """Whether e has a value wherever the hypotheses hold."""
        return self.exists(e, frozenset(), ())

    def exists(self, e, index, members):
        tag, inner = e[0], index
        if tag == "name":
            here = e[1] in index or e[1] in self.natural or e[1] not in self.partial
        elif tag == "prod":
            here = all(operator == "*" or self.is_not_zero(part, index) for operator, part in e[1])
        elif tag == "pow":
            k = number(e[2])
            if k is None:
                here = self.is_positive(e[1], index) or self.is_whole(e[2], index)
            elif k.denominator == 1:
                here = k >= 0 or self.is_not_zero(e[1], index)
            else:
                here = self.is_not_negative(e[1], index) if k > 0 else self.is_positive(e[1], index)
        elif tag == "call":
            word, arguments = e[1], list(nodes(e))
            if word in ("sqrt", "cbrt"):
                here = all(self.is_not_negative(a, index) for a in arguments)
            elif word == "ln":
                here = all(self.is_positive(a, index) for a in arguments)
            elif word in EVERYWHERE:
                here = word not in self.partial
            else:
                here = word in members or word in self.families and all(self.is_whole(a, index) for a in arguments)
        elif tag == "over":
            here = number(e[3]) in (0, 1) and self.is_whole(e[4], index)
            inner = index | {e[2]}
        else:
            here = tag in ("num", "neg", "sum")
        return bool(here) and all(self.exists(part, inner, members) for part in nodes(e))

    def is_not_zero(self, e, index):
        tag = e[0]
        if tag == "num":
            return number(e) != 0
        if tag == "neg":
            return self.is_not_zero(e[1], index)
        if tag == "prod":
            return all(self.is_not_zero(part, index) for _, part in e[1])
        if tag == "pow":
            return self.is_not_zero(e[1], index)
        return self.is_positive(e, index)

    def is_positive(self, e, index):
        tag = e[0]
        if tag == "num":
            return number(e) > 0
        if tag == "name":
            return e[1] in self.positive
        if tag == "sum":
            parts = [part for _, part in e[1]]
            plain = all(sign == 1 for sign, _ in e[1]) and all(self.is_not_negative(part, index) for part in parts)
            return plain and any(self.is_positive(part, index) for part in parts)
        if tag == "prod":
            return all(self.is_positive(part, index) for _, part in e[1])
        if tag == "pow":
            return self.is_positive(e[1], index)
        if tag == "call" and e[1] in ("sqrt", "cbrt", "arctan"):
            return all(self.is_positive(a, index) for a in nodes(e))
        return tag == "call" and (e[1] in ("exp", "cosh", "sech") or self.families.get(e[1], (False,))[0])

    def is_not_negative(self, e, index):
        tag = e[0]
        if tag == "num":
            return number(e) >= 0
        if tag == "sum":
            return all(sign == 1 and self.is_not_negative(part, index) for sign, part in e[1])
        if tag == "prod":
            return all(self.is_not_negative(part, index) for _, part in e[1])
        if tag == "pow":
            k = number(e[2])
            return k is not None and k.denominator == 1 and k % 2 == 0 or self.is_not_negative(e[1], index)
        return tag == "call" and e[1] in ("abs", "sqrt") or self.is_whole(e, index) or self.is_positive(e, index)

    def is_whole(self, e, index):
        """Whether e is a natural number by its form."""
        tag = e[0]
        if tag == "num":
            return number(e).denominator == 1
        if tag == "name":
            return e[1] in index or e[1] in self.natural
        if tag == "sum":
            return all(sign == 1 and self.is_whole(part, index) for sign, part in e[1])
        if tag == "prod":
            return all(operator == "*" and self.is_whole(part, index) for operator, part in e[1])
        if tag == "pow":
            return self.is_whole(e[1], index) and self.is_whole(e[2], index)
        return tag == "call" and self.families.get(e[1], (False, False))[1]
