"""Whether a claim is true at a point, as it is written.

An angle is a real number, π is π, a derivative is the derivative of a function (by numbers with derivatives, `dual.py`,
through `let`, parameters and sequences), a limit is looked at ever closer, the power of a matrix is that matrix.
Nothing is expanded. The answer is `True`, `False`, or one of the exceptions `Undefined` (it certainly has no value) and
`Unclear` (too close, or not to be told by evaluation).

`False` is sure of comparisons up to rounding with 80 digits. For what speaks of infinitely many numbers it is careful:
a limit is false if the values clearly settle elsewhere, grow, or keep swinging; `for all` and an extremum are false at
a number that shows it; `exists` is false if a fine grid, refined at every change of sign, leaves a clear distance.
`True` of these three means that such a grid found nothing against it.
"""

import random

from mpmath import mpf

from domain import Domain, Family
from dual import CLEAR, Unclear, Undefined, real
from limit import FAR, JITTER, LONG, MARGIN, STEEP, is_long, settles
from matrix import related, same
from names import angles_of, reach
from parse import names_in
from values import Values, bound
from zeros import crossings


class Evaluator(Values):
    """Judges the statements of one claim. `hints` names numbers to try for bound variables."""

    def __init__(self, claim, seed=0):
        super().__init__(claim)
        self.random = random.Random(seed)
        self.hints = {}
        self.angles = angles_of(claim)

    def truth(self, p, env):
        """Whether a statement holds; raises `Undefined` and `Unclear`."""
        return getattr(self, TRUTHS[p[0]])(p, env)

    def judged(self, p, env):
        """`True`, `False`, "undefined" or None where it is unclear."""
        try:
            return self.truth(p, env)
        except Undefined:
            return "undefined"
        except (Unclear, OverflowError, ZeroDivisionError, RecursionError):
            return None

    def truth_compare(self, p, env):
        values = [self.value(side, env) for side in p[1]]
        return all([related(a, relation, b) for a, relation, b in zip(values, p[2], values[1:])])

    def truth_and(self, p, env):
        held = [self.judged(part, env) for part in p[1]]
        if "undefined" in held:
            raise Undefined
        if None in held:
            # What is unclear may be without a value, so that something false beside it decides nothing.
            raise Unclear
        return all(held)

    def truth_or(self, p, env):
        held = [self.judged(part, env) for part in p[1]]
        if "undefined" in held:
            raise Undefined
        if None in held:
            raise Unclear
        return any(held)

    def truth_not(self, p, env):
        return not self.truth(p[1], env)

    def truth_implies(self, p, env):
        return not self.truth(p[1], env) or self.truth(p[2], env)

    def truth_equivalent(self, p, env):
        held = [self.truth(part, env) for part in p[1]]
        return len(set(held)) == 1

    def truth_all(self, p, env):
        """False at a number that shows it. What is unclear somewhere is unclear."""
        unclear = tried = 0
        for inner in self.environments(p[1], env, 30):
            held = self.judged(p[2], inner)
            if held is False:
                return False
            if held == "undefined":
                raise Undefined
            unclear += held is None
            tried += 1
        if unclear or not tried:
            raise Unclear
        return True

    def truth_exists(self, p, env):
        bindings, body = p[1], p[2]
        names = [name for binding in bindings for name, _ in binding.names]
        conjuncts = body[1] if body[0] == "and" else [body]
        tried = []
        for inner in self.environments(bindings, env, 60):
            held = self.judged(body, inner)
            if held is True:
                # Among so many tries one may hold at all numbers that were looked at by luck.
                if speaks_for_all(body):
                    raise Unclear
                return True
            tried.append(inner)
        if not tried:
            raise Unclear
        # What does not speak of the bound variables decides by itself.
        for part in conjuncts:
            if not self.speaks_of(part, names):
                held = self.judged(part, env)
                if held is False:
                    return False
        if len(names) != 1 or bindings[0].kind != "real" or bindings[0].names[0][1] is not None:
            raise Unclear
        return self.exists_one(names[0], bindings[0], conjuncts, body, env)

    def speaks_of(self, part, names):
        """Whether something uses these names, perhaps through definitions."""
        return bool(reach(self.claim, names_in(part)) & set(names))

    def exists_one(self, name, binding, conjuncts, body, env):
        """One real number: true at a zero of an equation, false if some part is nowhere near to being true."""
        domain = Domain(self, binding, name, env)
        grid = domain.grid()
        for part in conjuncts:
            if part[0] != "compare" or len(part[2]) != 1 or not grid:
                continue
            found, least = self.crossings(part, name, grid, env)
            held = [self.judged(body, bound(env, {name: v})) for v in found if domain.contains(v)]
            if True in held:
                return True
            is_equation = part[2][0] == "="
            if least is None:
                continue
            if not found and least > MARGIN:
                if is_equation or self.judged(part, bound(env, {name: grid[0]})) is False:
                    return False
            # Every solution of an equation fails elsewhere.
            if is_equation and held and domain.is_bounded() and all(h is False for h in held):
                return False
        raise Unclear

    def crossings(self, part, name, grid, env):
        """Where the sides of a comparison meet on a grid, and how near they come; None where that is not known."""
        left, right = part[1]

        def gap(v):
            inner = bound(env, {name: v})
            return real(self.number(left, inner)) - real(self.number(right, inner))

        return crossings(gap, grid)

    def truth_extremum(self, p, env):
        _, is_maximum, body, over, only, place, value = p
        names = [name for binding in over for name, _ in binding.names]
        best = real(self.number(value, env))
        put = {name: real(self.number(place[name], env)) for name in place}
        sign = 1 if is_maximum else -1
        attained = False
        if place:
            at = bound(env, {})
            for binding in over:
                for name, _ in binding.names:
                    at = bound(at, {name: put[name]}, binding)
                    if not Domain(self, binding, name, at).contains(put[name]):
                        return False
            if not same(real(self.number(body, at)), best):
                return False
            attained = True
        unclear = tried = 0
        top = None
        for inner in self.environments(over, env, 40 if len(names) == 1 else 60):
            try:
                v = real(self.number(body, inner))
            except Unclear:
                unclear += 1
                continue
            tried += 1
            if related(v * sign, ">", best * sign):
                return False
            if same(v, best):
                attained = True
                if only and any(not same(inner[name], put[name]) for name in names):
                    return False
            if top is None or v * sign > top[0]:
                top = v * sign, inner
        if unclear or not tried:
            raise Unclear
        if len(names) == 1 and over[0].kind == "real":
            try:
                climbed = self.climb(body, names[0], over[0], env, top, sign)
            except Unclear:
                if attained:
                    return True
                raise
            if related(climbed, ">", best * sign):
                return False
            if not attained and climbed > best * sign - CLEAR:
                attained = True
            if not attained and climbed < best * sign - MARGIN:
                return False
        if not attained:
            raise Unclear
        return True

    def climb(self, body, name, binding, env, top, sign):
        """The largest value near the best one found, by ever smaller steps."""
        domain = Domain(self, binding, name, env)
        best, at = top[0], real(top[1][name])
        step = max(mpf(1), abs(at)) / 3
        for _ in range(200):
            if step < mpf("1e-9"):
                return best
            for v in (at + step, at - step):
                try:
                    if domain.contains(v):
                        found = real(self.number(body, bound(env, {name: v}))) * sign
                        if found > best:
                            best, at = found, v
                            break
                except (Undefined, Unclear):
                    pass
            else:
                step /= 3
        raise Unclear

    def truth_limit(self, p, env):
        _, body, name, natural, point, sides, value = p
        natural = natural or self.claim.moving.get(name) == "natural" or name in self.natural
        if not isinstance(value, str) and self.speaks_of(value, [name]):
            # No number that the values could come to.
            target = None
        else:
            target = value if isinstance(value, str) else real(self.number(value, env))
        center = None if point is None else real(self.number(point, env))
        answers = []
        for side in sides:
            answers.append(self.one_sided(body, name, natural, center, side, target, env))
        if False in answers:
            return False
        if None in answers:
            raise Unclear
        return True

    def one_sided(self, body, name, natural, center, side, target, env):
        """Whether the values come to the target; None where that is not clear."""
        scales = [LONG, STEEP] if natural and is_long(self.claim, body) else [FAR, LONG, STEEP]
        # Powers of a number so near to 1 show only far out where they go: x/1.001^x grows at first.
        slow = any(isinstance(v, (int, mpf)) and 0 < abs(v - 1) < mpf("0.05") for v in env.values())
        for scale in scales:
            before, self.in_limit = self.in_limit, True
            try:
                held, whole = self.along(scale, body, name, natural, center, side, target, env)
            except Undefined:
                # Only as far out as we look: (sqrt(a + h) - sqrt(a))/h has values as soon as |h| <= a.
                if scale is scales[0]:
                    raise
                held, whole = None, False
            finally:
                self.in_limit = before
            if held or held is False and (scale is FAR and whole or not slow):
                return held
        return None

    def along(self, scale, body, name, natural, center, side, target, env):
        """Whether the values come to the target along a scale, and whether they could be looked at to its end."""
        rows, undefined = [], 0
        for distance in scale:
            if undefined:
                # A limit says nothing about what lies before the last point without a value.
                rows, undefined = [], 0
            row = []
            for factor in JITTER:
                v = distance * factor
                if natural:
                    # Even and odd numbers.
                    v = mpf(int(v) + len(row) % 2)
                at = v if center is None else center + side / v
                inner = bound(env, {name: at})
                if natural:
                    inner["#" + name] = True
                try:
                    row.append(real(self.number(body, inner)))
                except Undefined:
                    undefined += 1
                except (Unclear, OverflowError):
                    break
            if len(row) < len(JITTER) and not undefined:
                break
            if row:
                rows.append(row)
        if undefined and not rows:
            raise Undefined
        if undefined or len(rows) < 3:
            return None, False
        return settles(rows, target), len(rows) == len(scale)

    # The values of bound variables.

    def environments(self, bindings, env, count):
        """Environments with values for bound variables: each of several for one variable, random ones for more."""
        names = [(name, index, binding) for binding in bindings for name, index in binding.names]
        if len(names) == 1 and names[0][1] is None:
            name, _, binding = names[0]
            for v in Domain(self, binding, name, env).values(count):
                yield bound(env, {name: v}, binding)
            return
        for _ in range(count):
            inner = env
            for name, index, binding in names:
                inner = self.bind(name, index, binding, inner)
                if inner is None:
                    break
            else:
                yield inner

    def bind(self, name, index, binding, env):
        """The environment with one random value more; nothing if the domain is empty."""
        if index is not None:
            return bound(env, {name: Family(self, name, index, binding, env)}, binding)
        values = Domain(self, binding, name, env).values(8)
        if not values:
            return None
        return bound(env, {name: self.random.choice(values)}, binding)


def speaks_for_all(p):
    """Whether `for all` or an extremum stands in a statement."""
    return isinstance(p, (tuple, list)) and (p[:1] in (("all",), ("extremum",)) or any(speaks_for_all(part) for part in p))


TRUTHS = {"=>": "implies", "<=>": "equivalent"}
TRUTHS |= {name: name for name in ("compare", "and", "or", "not", "all", "exists", "extremum", "limit")}
TRUTHS = {kind: "truth_" + name for kind, name in TRUTHS.items()}
