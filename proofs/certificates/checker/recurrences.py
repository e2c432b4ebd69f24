"""Recurrences that are written out as hypotheses have values by their form: section 14.2 of docs/certificates.md.

A hypothesis says of its expressions that they have values, which a definition does not.
"""
from .author import MADE
from .claims import need
from .everywhere import Values


def need_values(items):
    """Refuses a recurrence whose right side may have no value, in the items of a claim as its author wrote them."""
    known = Values()
    for item in items:
        known.learn(item)
        if item[0] == "assume" and item[1] == MADE:
            p, index = item[2], set()
            if p[0] == "all":
                index, p = {n for b in p[1] for n, _ in b[1]}, p[2]
            need(known.exists(p[1][1], index, known.members), f"a member of {p[1][0][1]} may have no value")
