"""A verdict of Carom against the evaluation of the claim as it is written.

Wrong is a verdict

- *proved*, if the claim is false or has no value at a point that satisfies its hypotheses;
- *refuted*, if the printed counterexample does not satisfy the hypotheses, or the claim is true there; where none can
  be read, if the claim is true at every point tried;
- *contradictory hypotheses*, if a point satisfies them;
- any of a derivative whose variable a hypothesis ties to another one in it: the manual promises *undecided*.
"""

import itertools
from dataclasses import dataclass

from mpmath import nstr

from names import reach
from parse import Unreadable, names_in, parse, parts
from points import Points, equations
from witness import Witness

POINTS = 14
# How many steps of evaluation the points of a claim may take together.
WORK = 60_000


@dataclass
class Comparison:
    """Whether a verdict could be compared, and what is wrong with it, if anything."""

    evaluated: bool
    fault: str = ""


def compare(text, verdict, witness, seed):
    """Compares one verdict: "proved", "refuted" or "contradictory"."""
    try:
        (claim,) = parse(text)
    except Unreadable as fault:
        return Comparison(False, f"the evaluator cannot read it: {fault}")
    points = Points(claim, seed)
    tie = tied(claim)
    if tie and verdict in ("proved", "refuted"):
        return Comparison(
            True,
            f"{verdict}, but a hypothesis ties the variable of a derivative to {tie}: the manual promises undecided",
        )
    return {"proved": proved, "refuted": refuted, "contradictory": contradictory}[verdict](points, witness or {})


def proved(points, _):
    decided, work = False, 0
    for env in itertools.chain(points.some(POINTS), points.special()):
        held = points.goal(env)
        work += points.evaluator.steps
        if held in (False, "undefined"):
            what = "has no value" if held == "undefined" else "is false"
            return Comparison(True, f"proved, but it {what} at {shown(env)}")
        decided = decided or held is True
        if not env or work > WORK:
            break
    return Comparison(decided)


def refuted(points, printed):
    witness = Witness(points, printed)
    witness.hint(bound_names(points.claim.goal))
    outside = 0
    said = []
    for env in witness.environments():
        holds = points.satisfies(env)
        if holds is True:
            held = points.goal(env)
            if held in (False, "undefined"):
                return Comparison(True)
            said.append((held, env))
            if held is None:
                break
        elif holds is None:
            said.append((None, env))
        else:
            outside += 1
    if said and all(held is True for held, _ in said) and witness.is_complete():
        return Comparison(True, f"refuted, but it is true at the counterexample {shown(said[0][1])}")
    if not said and outside and witness.is_complete():
        return Comparison(True, f"refuted, but the counterexample {printed} does not satisfy the hypotheses")
    true = work = 0
    for env in itertools.chain(points.some(POINTS), points.special()):
        held = points.goal(env)
        work += points.evaluator.steps
        if held in (False, "undefined"):
            return Comparison(True)
        true += held is True
        if held is None or not env or work > WORK:
            break
    # Where the counterexample itself is not decided (for which m is 5 = 3*m?), other points tell nothing against it.
    is_open = any(held is None for held, _ in said)
    if true and not is_open and (true >= POINTS // 2 or not points.names):
        return Comparison(True, f"refuted, but it is true at all {true} points tried")
    return Comparison(False)


def contradictory(points, _):
    for env in points.some(POINTS):
        return Comparison(True, f"the hypotheses are called contradictory, but they hold at {shown(env)}")
    return Comparison(False)


def tied(claim):
    """A name in a derivative that an equation in the hypotheses ties to the derivative's variable; or ""."""
    ties = []
    for left, right in equations(claim.hypotheses):
        ties.append(reach(claim, names_in(left) | names_in(right)) & set(claim.declared()))

    def visit(tree):
        if tree[0] == "derivative":
            inside = reach(claim, names_in(tree[1]))
            for name in tree[2]:
                for tie in ties:
                    others = (tie - {name}) & inside
                    if name in tie and others:
                        return min(others)
        for part in parts(tree):
            found = visit(part)
            if found:
                return found
        return ""

    return visit(claim.goal)


def bound_names(tree):
    """The variables of quantifiers, extrema and limits in a goal."""
    out = set()
    if tree[0] in ("all", "exists"):
        out |= {name for binding in tree[1] for name, _ in binding.names}
    if tree[0] == "extremum":
        out |= {name for binding in tree[3] for name, _ in binding.names}
    for part in parts(tree):
        out |= bound_names(part)
    return out


def shown(env):
    """A point as text."""
    values = [f"{name} = {nstr(v, 12)}" for name, v in env.items() if not name.startswith("#") and hasattr(v, "_mpf_")]
    return ", ".join(values) or "every point"
