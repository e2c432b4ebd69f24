"""What a reading makes, and what that depends on: section 14.9 of docs/certificates.md.

floor(x) becomes a number with k <= x < k + 1. A power of a matrix, and a recurrence of higher order, become families with their
equations. A derivative takes all of these for constants, so none may stand in one by a variable on which it depends.
"""
from .author import MADE
from .claims import names_in, need, subtrees


def need_constants(written, claim):
    """The hypotheses of the claim are those of its clauses as they are written out, in the same order."""
    labels, depends = [item[1] for item in written.items if item[0] == "assume"], {}
    for label, p in zip(labels, claim.assumptions):
        for name in defined(p) if label == MADE else ():
            depends.setdefault(name, set()).update(names_in(p))
    for statement in [claim.goal, *claim.assumptions] if depends else ():
        for x in subtrees(statement):
            for name in names_in(x[1]) & set(depends) if x[0] == "deriv" else ():
                moved = reached(name, depends) & set(x[2])
                need(not moved, f"a derivative by {', '.join(moved)} of {name}, which depends on it")


def defined(p):
    """The names that a hypothesis `k <= x < k + 1`, `u(0) = A` or `for all k natural: u(k + 1) = B` defines."""
    left = (p[2] if p[0] == "all" else p)[1][0]
    return {left[1]} if left[0] == "call" else names_in(left)


def reached(name, depends):
    """All names on which a name depends, directly or through others."""
    out, open_ = set(), [name]
    while open_:
        new = depends.get(open_.pop(), set()) - out
        out |= new
        open_ += new
    return out
