"""Points that satisfy the hypotheses of a claim, and what the claim says at them.

A point gives a number to every declared variable. Numbers are drawn from the domains, with their ends and other special
ones among them. An equation in the hypotheses is solved for one of its variables by Newton's method, several equations
for several variables together. Special points follow: those at which a divisor, or what stands under a root, is 0.
"""

import itertools

import mpmath
from mpmath import mpf

from domain import Domain
from dual import ZERO, Dual, Unclear, Undefined, new_tag, real, slope
from evaluate import Evaluator
from names import reach
from parse import FOLDS, names_in, parts
from values import bound

TRIES = 6


class Points:
    """Points of one claim."""

    def __init__(self, claim, seed):
        self.claim = claim
        self.evaluator = Evaluator(claim, seed)
        self.random = self.evaluator.random
        self.names = [(name, index, binding) for binding in claim.given for name, index in binding.names]
        self.equations = list(equations(claim.hypotheses))

    def drawn(self, put=None):
        """A point from the domains, with some numbers put; nothing if a domain is empty."""
        env = {}
        for name, index, binding in self.names:
            if put and name in put:
                env = bound(env, {name: put[name]}, binding)
                continue
            try:
                env = self.evaluator.bind(name, index, binding, env)
            except (Undefined, Unclear):
                return None
            if env is None:
                return None
        return env

    def satisfies(self, env):
        """Whether a point lies in the domains and satisfies the hypotheses; None where it is unclear."""
        self.evaluator.steps = 0
        answer = True
        try:
            for name, index, binding in self.names:
                if index is None and not Domain(self.evaluator, binding, name, env).contains(env[name]):
                    return False
        except Undefined:
            return False
        except Unclear:
            answer = None
        for hypothesis in self.claim.hypotheses:
            held = self.evaluator.judged(hypothesis, env)
            if held is False or held == "undefined":
                return False
            if held is None:
                answer = None
        return answer

    def goal(self, env):
        """What the goal says at a point: `True`, `False`, "undefined" or None."""
        self.evaluator.steps = 0
        return self.evaluator.judged(self.claim.goal, env)

    def some(self, count, fixed=()):
        """Up to so many points; `fixed` names variables that keep their drawn numbers when equations are solved."""
        for _ in range(count):
            for _ in range(TRIES):
                env = self.solved(self.drawn(), self.equations, fixed)
                if env is not None and self.satisfies(env) is True:
                    yield env
                    break

    def special(self):
        """Points at which a divisor or what stands under a root is 0, or an arcsin or arccos ends."""
        seen = set()
        for zero in itertools.islice(critical(self.claim, self.claim.goal), 6):
            if str(zero) in seen:
                continue
            seen.add(str(zero))
            for _ in range(3):
                env = self.solved(self.drawn(), self.equations + [(zero, ("num", "0"))], ())
                if env is not None and self.satisfies(env) is True:
                    yield env
                    break

    def solved(self, env, wanted, fixed):
        """The point moved until equations hold; nothing if it cannot be."""
        if env is None:
            return None
        self.evaluator.steps = 0
        try:
            open_equations = [e for e in wanted if abs(self.gap(e, env)) > ZERO]
            if not open_equations:
                return env
            real_names = {name for name, index, binding in self.names if index is None and binding.kind == "real"}
            chosen = []
            for left, right in wanted:
                inside = reach(self.claim, names_in(left) | names_in(right)) & real_names
                free = sorted(inside - set(chosen) - set(fixed))
                if free:
                    chosen.append(self.random.choice(free))
                elif (left, right) in open_equations:
                    return None
                else:
                    chosen.append(None)
            pairs = [(e, name) for e, name in zip(wanted, chosen) if name]
            return self.newton(env, [e for e, _ in pairs], [name for _, name in pairs])
        except (Undefined, Unclear, ZeroDivisionError, OverflowError, TypeError):
            # mpmath raises a TypeError for a singular matrix of zeros.
            return None

    def gap(self, equation, env):
        left, right = (self.evaluator.number(side, env) for side in equation)
        return real(left) - real(right)

    def newton(self, env, wanted, names):
        for _ in range(40):
            rows, gaps = [], []
            for left, right in wanted:
                row = []
                for name in names:
                    tag = new_tag()
                    inner = bound(env, {name: Dual(tag, env[name], mpf(1))})
                    row.append(
                        real(slope(self.evaluator.number(left, inner) - self.evaluator.number(right, inner), tag))
                    )
                rows.append(row)
                gaps.append(self.gap((left, right), env))
            if all(abs(g) <= ZERO * mpf("1e-10") for g in gaps):
                return env
            if len(names) == 1:
                steps = [gaps[0] / rows[0][0]]
            else:
                steps = list(mpmath.lu_solve(mpmath.matrix(rows), mpmath.matrix(gaps)))
            if any(abs(s) > 10**6 for s in steps):
                return None
            env = bound(env, {name: env[name] - step for name, step in zip(names, steps)})
        return None


def equations(hypotheses):
    """The equations that the hypotheses say."""
    for hypothesis in hypotheses:
        if hypothesis[0] == "and":
            yield from equations(hypothesis[1])
        elif hypothesis[0] == "compare":
            sides, relations = hypothesis[1:]
            for left, relation, right in zip(sides, relations, sides[1:]):
                if relation == "=" and "matrix" not in (left[0], right[0]):
                    yield left, right


def critical(claim, tree, inside=frozenset()):
    """What must not be 0, or where a root begins or an arcsin ends, in a goal: expressions of the claim's own variables."""
    if tree[0] in ("all", "exists"):
        inside = inside | {name for binding in tree[1] for name, _ in binding.names}
    if tree[0] in FOLDS:
        inside = inside | {tree[1]}
    if tree[0] == "limit":
        inside = inside | {tree[2]}
    found = None
    if tree[0] == "/":
        found = tree[2]
    if tree[0] == "call" and tree[1] in ("sqrt", "abs", "ln"):
        found = tree[2][0]
    if tree[0] == "call" and tree[1] in ("arcsin", "arccos"):
        found = ("-", ("num", "1"), ("^", tree[2][0], ("num", "2")))
    if tree[0] == "call" and tree[1] == "tan":
        found = ("call", "cos", tree[2])
    if found is not None and found[0] != "num" and not names_in(found) & inside:
        yield found
    for part in parts(tree):
        yield from critical(claim, part, inside)
    if tree[0] in ("name", "call") and tree[1] in claim.lets and not claim.lets[tree[1]][0]:
        yield from critical(claim, claim.lets[tree[1]][1], inside)
