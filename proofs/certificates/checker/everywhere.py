"""Which expressions have a value everywhere by how they are written: section 14.6 of docs/certificates.md."""
from .claims import nodes
from .signs import number

EVERYWHERE = ("abs", "max", "min", "exp", "cos", "sin", "arctan", "cosh", "sinh", "sech", "tanh")


def has_a_value(e, named, positive):
    """`named` says of a name whether what it stands for has a value, `positive` whether it is declared positive."""
    tag = e[0]
    if tag == "prod":
        here = all(operator == "*" or number(part) or is_positive(part, positive) for operator, part in e[1])
    elif tag == "call" and e[1] in ("sqrt", "cbrt", "ln"):
        here = all(is_positive(part, positive) for part in nodes(e))
    elif tag == "call":
        here = e[1] in EVERYWHERE and named(e[1])
    elif tag == "name":
        here = named(e[1])
    elif tag == "pow":
        k = number(e[2])
        here = k is not None and k.denominator == 1 and k >= 0
    else:
        here = tag in ("num", "neg", "sum")
    return bool(here) and all(has_a_value(part, named, positive) for part in nodes(e))


def is_positive(e, positive):
    """Whether e is a sum, product, quotient, whole power, root or arctan of positive numbers and names, or an exponential."""
    tag, inner = e[0], lambda part: is_positive(part, positive)
    if tag == "num":
        return number(e) > 0
    if tag == "name":
        return positive(e[1])
    if tag == "call":
        return e[1] == "exp" or e[1] in ("sqrt", "cbrt", "arctan") and all(inner(part) for part in nodes(e))
    if tag == "sum":
        return all(sign == 1 and inner(part) for sign, part in e[1])
    if tag == "prod":
        return all(inner(part) for _, part in e[1])
    if tag == "pow":
        k = number(e[2])
        return inner(e[1]) and k is not None and k.denominator == 1
    return False


def is_above_zero(c):
    """Whether a constraint keeps a name above 0."""
    bound = number(c[2])
    if bound is None or c[0] == "relation" and c[1] not in (">", ">="):
        return False
    included = c[1] == ">=" if c[0] == "relation" else c[1]
    return bound > 0 or bound == 0 and not included


class Values:
    """What the items of a claim, in their order, tell of the names that they declare."""

    def __init__(self):
        self.partial, self.positive = set(), set()

    def learn(self, item):
        if item[0] == "given":
            for b in item[1]:
                self.partial.update(n for n, index in b[1] if index)
                if any(map(is_above_zero, b[3])):
                    self.positive.update(n for n, index in b[1] if not index)
        elif item[0] == "define" or item[0] == "let" and (item[2] or not self.exist_for(item[3])):
            self.partial.add(item[1])

    def exist_for(self, e):
        """Whether e has a value wherever the hypotheses hold."""
        return has_a_value(e, lambda n: n not in self.partial, self.positive.__contains__)
