"""Where values go, by looking at them ever further out: coming to a number, growing, or swinging."""

from mpmath import mpf

from dual import ZERO
from names import reach
from parse import FOLDS, names_in, parts

# How far numbers must lie from what a sequence of points suggests.
MARGIN = mpf("1e-3")
# How far out a limit is looked at: as a rule, where each value costs work, and where values grow fast.
FAR = [mpf(10) ** k for k in (2, 4, 6, 8)]
LONG = [mpf(k) for k in (4, 16, 64, 256)]
STEEP = [mpf(k) for k in (2, 5, 12, 28)]
JITTER = (mpf(1), mpf("1.37"), mpf("2.11"), mpf("3.03"))


def is_long(claim, body):
    """Whether the work for a value grows with its index: sums, integrals, sequences, factorials, powers of matrices."""
    if body[0] in (*FOLDS, "matrix") or body[0] == "call" and body[1] in ("factorial", "binomial"):
        return True
    if reach(claim, names_in(body)) & set(claim.sequences):
        return True
    return any(is_long(claim, part) for part in parts(body)) or any(
        is_long(claim, claim.lets[n][1]) for n in names_in(body) if n in claim.lets
    )


def settles(rows, target):
    """Whether rows of values, each row further out, come to a target: a number, "infinity" or "-infinity".

    Without a target, whether they come to any number: False if they swing. None where it is not clear.
    """
    last, before = rows[-1], rows[-2]
    spread = max(last) - min(last)
    scale = 1 + max(abs(v) for v in last)
    grows = [all(abs(v) > abs(u) + mpf("0.5") for u, v in zip(r, s)) for r, s in zip(rows, rows[1:])]
    step = max(abs(v - u) for u, v in zip(before, last))
    earlier = max(abs(v - u) for u, v in zip(rows[-3], before))
    settled = step <= ZERO * scale or step < 10 * MARGIN * scale and step * 3 < earlier
    swings = min(spread, max(before) - min(before)) > mpf("0.02") * scale and spread * 2 > max(before) - min(before)
    if isinstance(target, str):
        sign = 1 if target == "infinity" else -1
        if all(grows) and all(v * sign > 0 for v in last + before):
            return True
        if settled or all(v * sign < -MARGIN for v in last + before):
            return False
        return False if swings and min(v * sign for v in last) < 0 and not all(grows) else None
    if target is None:
        return False if swings and not all(grows[1:]) else None
    apart = [max(abs(v - target) for v in row) for row in rows]
    near = min(abs(v - target) for v in last)
    shrinks = apart[-1] * 3 < apart[-2] and apart[-2] * 3 < apart[-3]
    if apart[-1] <= ZERO * scale or apart[-1] < 10 * MARGIN * (1 + abs(target)) and shrinks:
        return True
    far = near > MARGIN * (1 + abs(target))
    if settled and far and near > 20 * step:
        return False
    if all(grows) and far and abs(last[0]) > 10 * abs(target) + 2:
        return False
    if swings and spread > mpf("0.05") * (1 + abs(target)) and not all(grows[1:]):
        return False
    return None
