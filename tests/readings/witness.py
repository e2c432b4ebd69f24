"""A counterexample as a report prints it, turned back into numbers for the variables of the claim.

Carom prints cosines and sines for an angle, and two natural numbers for an integer. An angle is known up to full turns
of the part of it that has a name, so there are several points to try.
"""

import itertools
import re

import mpmath

from domain import Family
from dual import Unclear, Undefined, real
from evaluate import Evaluator
from parse import Parser, Unreadable


class Witness:
    """A counterexample as a report prints it, in the numbers that Carom made of the claim's variables."""

    def __init__(self, points, printed):
        self.points = points
        self.own = set(points.claim.declared()) | set(points.claim.lets)
        self.numbers = {}
        for name, text in printed.items():
            try:
                self.numbers[name] = read_number(text)
            except (Unreadable, Undefined, Unclear):
                pass

    def angle(self, name):
        """An angle by the cosine and sine of a part of it: the smallest such angle, and its period."""
        forms = (f"cos_{name}(?:_over_(\\d+))?(?:_\\d+)?", rf"cos\({name}(?:/(\d+))?\)")
        for key, cosine in self.numbers.items():
            match = next(filter(None, (re.fullmatch(form, key) for form in forms)), None)
            sine = self.numbers.get("sin" + key[3:])
            # What the author named so is no cosine.
            if match and sine is not None and key not in self.own:
                over = int(match.group(1) or 1)
                return over * mpmath.atan2(sine, cosine), 2 * mpmath.pi * over
        return None

    def value(self, name):
        """The possible values of a variable: one number, or an angle and others by full turns; None if not printed."""
        if name in self.points.evaluator.angles:
            found = self.angle(name)
            if found:
                return [found[0] + found[1] * k for k in (0, 1, -1, 2, -2)]
        if name in self.numbers:
            return [self.numbers[name]]
        if name + "_up" in self.numbers and name + "_down" in self.numbers:
            return [self.numbers[name + "_up"] - self.numbers[name + "_down"]]
        return None

    def hint(self, names):
        """Values of bound variables to try first."""
        for name in names:
            found = self.value(name)
            if found is None and self.angle(name):
                found = [self.angle(name)[0]]
            if found:
                self.points.evaluator.hints[name] = found

    def environments(self):
        """The points that it may be."""
        points = self.points
        known = {}
        for name, index, _ in points.names:
            found = self.value(name) if index is None else None
            if found:
                known[name] = found
        for values in itertools.islice(itertools.product(*known.values()), 200):
            put = dict(zip(known, values))
            env = points.drawn(put)
            for name, index, _ in points.names:
                if env is not None and index is not None:
                    self.members(name, env[name])
            if env is not None and len(known) < len(points.names):
                env = points.solved(env, points.equations, tuple(known)) or env
            if env is not None:
                yield env

    def is_complete(self):
        """Whether every variable of the claim is printed."""
        return all(index is None and self.value(name) for name, index, _ in self.points.names)

    def members(self, name, family):
        if isinstance(family, Family):
            for key, number in self.numbers.items():
                match = re.fullmatch(re.escape(name) + r"\((\d+)\)", key)
                if match:
                    family.known[int(match.group(1))] = number


def read_number(text):
    """A printed number: digits, fractions, roots."""
    parser = Parser(text)
    e = parser.expr()
    if parser.kind() != "end":
        raise Unreadable(text)
    return real(Evaluator(NOTHING).number(e, {}))


class Nothing:
    """A claim without content, in which numbers are evaluated."""

    lets, sequences, moving, given, hypotheses, goal = {}, {}, {}, [], [], ("name", "nothing")


NOTHING = Nothing()
