"""What the names of a claim lead to: through its definitions, and whether they are angles."""

from parse import names_in, parts


def reach(claim, names):
    """These names, and those that definitions and sequences among them use."""
    out, open_names = set(), list(names)
    while open_names:
        name = open_names.pop()
        if name in out:
            continue
        out.add(name)
        if name in claim.lets:
            open_names += names_in(claim.lets[name][1])
        if name in claim.sequences:
            first, (_, _, step) = claim.sequences[name]
            for e in [*first.values(), step]:
                open_names += names_in(e)
    return out


def angles_of(claim):
    """The names inside sin, cos and tan, and those bounded by multiples of π."""
    out = set()

    def visit(tree):
        if tree[0] == "call" and tree[1] in ("sin", "cos", "tan"):
            out.update(reach(claim, names_in(tree)))
        for part in parts(tree):
            visit(part)

    for tree in [claim.goal, *claim.hypotheses, *(body for _, body in claim.lets.values())]:
        visit(tree)
    for first, (_, _, step) in claim.sequences.values():
        for e in [*first.values(), step]:
            visit(e)
    for binding in claim.given:
        for constraint in binding.constraints:
            if any("pi" in names_in(part) for part in constraint[1:] if isinstance(part, tuple)):
                out.update(name for name, _ in binding.names)
    for hypothesis in claim.hypotheses:
        if hypothesis[0] == "compare" and "pi" in names_in(hypothesis):
            out.update(n for n in names_in(hypothesis) if n in claim.declared())
    return out - {"pi", "sin", "cos", "tan"}
