"""The numbers that a declaration allows: whether one lies within, and which are worth trying."""

import mpmath
from mpmath import mpf

from dual import ZERO, Unclear, Undefined, real, whole
from matrix import related, same


class Domain:
    """The values that a binding allows a name at a point."""

    def __init__(self, evaluator, binding, name, env):
        self.evaluator, self.binding, self.name = evaluator, binding, name
        self.low = self.high = None
        self.but = []
        self.low_closed = self.high_closed = True
        for constraint in binding.constraints:
            if constraint[0] == "in":
                self.raise_to(evaluator.number(constraint[1], env), constraint[2])
                self.lower_to(evaluator.number(constraint[3], env), constraint[4])
            elif constraint[0] == "..":
                self.raise_to(evaluator.number(constraint[1], env), True)
                self.lower_to(evaluator.number(constraint[2], env), True)
            else:
                v = evaluator.number(constraint[1], env)
                if constraint[0] in (">", ">="):
                    self.raise_to(v, constraint[0] == ">=")
                elif constraint[0] in ("<", "<="):
                    self.lower_to(v, constraint[0] == "<=")
                elif constraint[0] == "=":
                    self.raise_to(v, True)
                    self.lower_to(v, True)
                else:
                    self.but.append(real(v))
        if binding.kind == "natural":
            self.raise_to(mpf(0), True)

    def raise_to(self, v, closed):
        v = real(v)
        if self.low is None or v > self.low or v == self.low and not closed:
            self.low, self.low_closed = v, closed

    def lower_to(self, v, closed):
        v = real(v)
        if self.high is None or v < self.high or v == self.high and not closed:
            self.high, self.high_closed = v, closed

    def is_bounded(self):
        return self.low is not None and self.high is not None

    def contains(self, v):
        """Whether a number is allowed; raises `Unclear` where it is too close to an end."""
        if self.low is not None and not related(v, ">=" if self.low_closed else ">", self.low):
            return False
        if self.high is not None and not related(v, "<=" if self.high_closed else "<", self.high):
            return False
        if any(same(v, other) for other in self.but):
            return False
        return self.binding.kind == "real" or abs(v - mpmath.nint(v)) < ZERO

    def allowed(self, values):
        out = []
        for v in values:
            try:
                if self.contains(v):
                    out.append(v)
            except Unclear:
                pass
        return out

    def values(self, count):
        """Up to so many values: the ends, special ones, and random ones."""
        rng = self.evaluator.random
        if self.binding.kind != "real":
            low = mpmath.ceil(self.low) if self.low is not None else mpf(-4)
            values = [low + k for k in range(min(count, 12))]
            if self.low is None:
                values.sort(key=abs)
            if self.high is not None:
                values += [mpmath.floor(self.high) - k for k in range(3)]
            return self.allowed(values)[:count]
        is_angle = self.name in self.evaluator.angles
        special = list(self.evaluator.hints.get(self.name, ()))
        if self.is_bounded():
            width = self.high - self.low
            special += [self.low, self.high]
            if is_angle:
                special += multiples(self.low, self.high)
            special += [
                self.low + width * t for t in (mpf("1e-6"), mpf("0.5"), 1 - mpf("1e-6"), mpf("0.1"), mpf("0.9"))
            ]
            loose = [self.low + width * mpf(rng.random()) for _ in range(count)]
        elif is_angle:
            base = self.low if self.low is not None else self.high if self.high is not None else mpf(0)
            special += [base] + multiples(base - 7, base + 7)
            loose = [base + mpf(rng.uniform(-7, 7)) for _ in range(count)]
        else:
            base = self.low if self.low is not None else self.high if self.high is not None else mpf(0)
            offsets = ("0", "1", "-1", "0.5", "-0.5", "2", "-2", "3", "-3", "0.001", "-0.001", "10", "-10", "30")
            special += [base + mpf(t) for t in offsets] + [mpf(k) for k in range(-3, 4)]
            loose = [base + mpf(rng.choice((-1, 1)) * 10 ** rng.uniform(-2, 1.5)) for _ in range(count)]
        special = self.allowed(special)
        if len(special) > count * 2 // 3:
            hinted = special[: len(self.evaluator.hints.get(self.name, ()))]
            special = hinted + rng.sample(special, count * 2 // 3)
        return (special + self.allowed(loose))[:count]

    def grid(self):
        """Sorted values for a search, dense where numbers usually matter."""
        if self.is_bounded():
            values = [self.low + (self.high - self.low) * k / 96 for k in range(97)]
        else:
            base = self.low if self.low is not None else self.high if self.high is not None else mpf(0)
            offsets = [mpf(k) / 8 for k in range(-56, 57)] + [
                s * mpf(10) ** k for k in (-3, -2, 1, 2, 3, 4, 6) for s in (1, -1)
            ]
            values = [base + t for t in offsets]
        values += [mpf(k) for k in range(-3, 4)]
        return sorted(set(self.allowed(values)))


class Family:
    """A family of numbers: each member is drawn from its domain when it is first asked for."""

    def __init__(self, evaluator, name, index, binding, env):
        self.evaluator, self.name, self.index, self.binding, self.env = evaluator, name, index, binding, env
        self.known = {}

    def __call__(self, k, env):
        k = whole(k)
        if k < 0:
            raise Undefined
        if self.binding.indices:
            low, high = (whole(self.evaluator.number(end, self.env)) for end in self.binding.indices)
            if not low <= k <= high:
                raise Undefined
        if k not in self.known:
            inner = {**self.env, self.index: mpf(k), "#" + self.index: True}
            values = Domain(self.evaluator, self.binding, self.name, inner).values(8)
            if not values:
                raise Unclear
            self.known[k] = self.evaluator.random.choice(values)
        return self.known[k]


def multiples(low, high):
    """The multiples of π/12 in a range that is not too long."""
    if high - low > 60:
        return []
    twelfth = mpmath.pi / 12
    first, last = int(mpmath.ceil(low / twelfth - ZERO)), int(mpmath.floor(high / twelfth + ZERO))
    return [twelfth * k for k in range(first, last + 1)]
