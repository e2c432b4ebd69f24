"""Angles as sums of variables and π, and their bounds: section 14.5 of docs/certificates.md.

An angle is (turns, {name: coefficient}): turns·π and the variables. An end of a range is (turns, whether it belongs to it).
"""
from fractions import Fraction as Q

from .circle import of_turns, opposite, sign_of_sine, together, TURNED, written
from .claims import compare, N, num, PI, Refused
from .signs import number


def linear(e, definitions, is_pi):
    """(number, turns, {name: coefficient}) of a sum of numbers, π and variables with rational coefficients, else None."""
    if e[0] in ("num", "pow"):
        value = short(e)
        return None if value is None else (value, Q(0), {})
    if e[0] == "name":
        if e[1] == PI and is_pi:
            return Q(0), Q(1), {}
        return definitions.get(e[1], (Q(0), Q(0), {e[1]: Q(1)}))
    if e[0] == "neg":
        return total([(-1, linear(e[1], definitions, is_pi))])
    if e[0] == "sum":
        return total([(sign, linear(part, definitions, is_pi)) for sign, part in e[1]])
    if e[0] != "prod":
        return None
    out = Q(1), Q(0), {}
    for operator, part in e[1]:
        part = linear(part, definitions, is_pi)
        if part is None:
            return None
        numbers = [x[0] if not x[1] and not x[2] else None for x in (out, part)]
        if numbers[1] is not None and (operator == "*" or numbers[1]):
            out = total([(numbers[1] if operator == "*" else 1 / numbers[1], out)])
        elif numbers[0] is not None and operator == "*":
            out = total([(numbers[0], part)])
        else:
            return None
    return out


def short(e):
    """The value of a numeral or a power in numerals, if numerator and denominator are below 2^127."""
    try:
        value = number(e)
    except Refused:
        return None
    return value if value is not None and max(abs(value.numerator), value.denominator) < 2 ** 127 else None


def total(parts):
    """The sum of k·x for (k, x)."""
    if any(x is None for _, x in parts):
        return None
    of = {}
    for k, x in parts:
        for name, c in x[2].items():
            of[name] = of.get(name, 0) + k * c
    plain = [sum((k * x[place] for k, x in parts), Q(0)) for place in (0, 1)]
    return *plain, {name: c for name, c in sorted(of.items()) if c}


class Bounds:
    """The range of an angle, in units of π."""

    def __init__(self, low=None, high=None):
        self.low, self.high = low, high

    def narrow(self, relation, turns):
        """Whether the relation is a bound."""
        end = turns, relation in ("<=", ">=")
        if relation in ("<", "<="):
            if self.high is None or (turns, end[1]) < self.high:
                self.high = end
        elif relation in (">", ">="):
            if self.low is None or (-turns, end[1]) < (-self.low[0], self.low[1]):
                self.low = end
        return relation in TURNED

    def hold(self, turns):
        above = self.low is None or turns > self.low[0] or turns == self.low[0] and self.low[1]
        below = self.high is None or turns < self.high[0] or turns == self.high[0] and self.high[1]
        return above and below

    def are_less_than_a_turn(self):
        if self.low is None or self.high is None:
            return False
        length = self.high[0] - self.low[0]
        return length < 2 or length == 2 and not (self.low[1] and self.high[1])

    def conditions(self, part, over):
        """What they say of the point of a part θ/over; None where an end is not known or the range is empty."""
        if self.low is None or self.high is None:
            return []
        alpha, beta = self.low[0] / over, self.high[0] / over
        length, closed = beta - alpha, (self.low[1], self.high[1])
        if length <= 0:
            return None
        if length > 2 or length == 2 and any(closed):
            return []
        start, end = of_turns(-alpha), of_turns(beta)
        if start is None or end is None:
            return None
        after = together(part, start)
        cosine_is_not = lambda value: compare(written(after[0]), "!=", value)
        at_least = lambda is_closed: ">=" if is_closed else ">"
        if length == 2:
            return [cosine_is_not(num(1))]
        if length == 1:
            excluded = {(False, True): [num(1)], (True, False): [N("neg", num(1))]}.get(closed, [])
            return [sign_of_sine(after, at_least(any(closed)))] + [cosine_is_not(e) for e in excluded]
        before = together(opposite(part), end)
        both = [sign_of_sine(after, at_least(closed[0])), sign_of_sine(before, at_least(closed[1]))]
        return both if length < 1 else [N("or", tuple(both))]
