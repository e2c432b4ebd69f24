"""Random claims in short natural shapes, of the constructs that the reader rewrites. About half of them are true.

The same seed gives the same claims. Each function of `KINDS` makes the clauses of one claim. Where it can, it works out
the right value by algebra, and spoils it half of the time. Nothing relies on that: the evaluator judges every claim.
"""

import pathlib
import random
import re

import abbreviations
import angles
import arcs
import derivatives
import integrals
import limits
from maker import Maker

TESTS = pathlib.Path(__file__).parent.parent
KNOWN = "known claims, changed"
SIGNS = "other signs"
PREAMBLE = "preambles"
# The kinds, and how often each is made.
KINDS = {
    "limits at a point": (limits.at_a_point, 10),
    "infinite limits": (limits.infinite, 4),
    "limits at infinity": (limits.at_infinity, 5),
    "limits of derivatives at infinity": (limits.of_a_derivative_at_infinity, 5),
    "limits of several kinds": (limits.of_several_kinds, 4),
    "derivatives by an angle": (derivatives.by_an_angle, 9),
    "derivatives by a parameter": (derivatives.by_a_parameter, 5),
    "derivatives by a number": (derivatives.by_a_number, 6),
    "derivatives that are tied": (derivatives.tied, 3),
    "derivatives of sequences": (derivatives.of_sequences, 4),
    "integrals": (integrals.any_kind, 6),
    "bounds of angles": (angles.bounds, 12),
    "equations of angles": (angles.equation, 12),
    "identities of angles": (angles.identity, 8),
    "names that the reader makes": (angles.made_names, 6),
    "quantified angles": (angles.quantified, 6),
    "extrema over an angle": (angles.extremum, 8),
    "extrema over a number": (angles.extremum_of_a_number, 3),
    "floors": (abbreviations.floors, 6),
    "matrices": (abbreviations.matrices, 5),
    "whole numbers and abbreviations": (abbreviations.whole_numbers, 6),
    "sequences": (abbreviations.sequences, 3),
    "exponents": (abbreviations.exponents, 2),
    "arcs": (arcs.any_kind, 12),
    "quantified numbers": (abbreviations.quantified, 5),
    "parameters": (abbreviations.parameters, 3),
    PREAMBLE: (abbreviations.preamble, 2),
    SIGNS: (None, 3),
    KNOWN: (None, 6),
}


def known_claims():
    """The claims of deceptions and truths that stand alone."""
    paths = [
        path for folder in ("deceptions", "truths") for path in sorted((TESTS / folder).glob("*.claim"))
    ]
    claims = [re.sub(r"(?m)#.*$", "", text) for path in paths for text in claims_of(path)]
    return [claim for claim in claims if not re.search(r"\busing\b|[{}]|\bexpect\b", claim)]


def claims_of(path):
    """The texts of the claims of a file, without a preamble."""
    texts = re.split(r"(?m)^(?=claim )", pathlib.Path(path).read_text(encoding="utf-8"))
    return [text for text in texts if text.startswith("claim ")]


def changed(m, known):
    """A known claim with up to two places changed."""
    body = m.pick(known).partition("\n")[2]
    swaps = (("[", "("), ("]", ")"), ("real", "> 0"), ("pi", "2*pi"), ("derivative(", "2*derivative("), ("/2", "/3"))
    for _ in range(m.rng.randint(0, 2)):
        body = m.rewritten(body) if m.chance(0.8) else body.replace(*m.pick(swaps), 1)
    return [line for line in body.split("\n") if line.strip()]


def in_other_signs(m):
    """The same shapes with Greek letters, raised powers and other signs."""
    shapes = (derivatives.by_an_angle, angles.identity, angles.bounds, limits.at_a_point, abbreviations.floors)
    text = "\n".join(m.pick(shapes)(m))
    for word, sign in (("theta", "θ"), ("alpha", "α"), ("beta", "β"), ("pi", "π"), ("phi", "φ")):
        text = re.sub(rf"\b{word}\b", sign, text)
    text = re.sub(r"\^2\b(?![*/^.])", "²", text)
    return text.replace("<=", "≤").replace(">=", "≥").replace("->", "→").split("\n")


def claim(seed, index, known):
    """The kind and the text of one random claim."""
    rng = random.Random(f"{seed}/{index}")
    kind = rng.choices(list(KINDS), [weight for _, weight in KINDS.values()])[0]
    maker, shared = Maker(rng), []
    if kind == KNOWN:
        lines = changed(maker, known)
    elif kind == SIGNS:
        lines = in_other_signs(maker)
    elif kind == PREAMBLE:
        shared, lines = abbreviations.preamble(maker)
    else:
        lines = KINDS[kind][0](maker)
    return kind, "\n".join([*shared, f'claim c{index} "{kind}"', *lines, ""])
