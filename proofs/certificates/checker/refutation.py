"""What has to be shown so that a claim is false at a point, or has no value there: section 9 of docs/certificates.md."""
import operator
import re
from fractions import Fraction

from .claims import (
    PI, Claim, N, compare, constraints, domain, names_in, need, nodes, num, plus, put, subtrees, text, to_the_ends,
)
from .signs import exponent, whole_by_form

COMPARE = {"=": operator.eq, "!=": operator.ne, "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge}


def natural(e):
    return e[0] == "num" and re.fullmatch("0|[1-9][0-9]*", e[1]) is not None


def number(e):
    """p, -p, p/q or -p/q as a fraction; else None."""
    if natural(e):
        return Fraction(int(e[1]))
    if e[0] == "neg" and e[1][0] != "neg":
        return None if number(e[1]) is None else -number(e[1])
    if e[0] == "prod" and len(e[1]) == 2:
        (first, p), (second, q) = e[1]
        if (first, second) == ("*", "/") and natural(p) and natural(q) and q != num(0):
            return Fraction(int(p[1]), int(q[1]))
    return None


def real(e, is_pi):
    """Whether e has a value, because of its form: section 9, "values of a point"."""
    if number(e) is not None:
        return True
    if e[0] == "name":
        return is_pi and e[1] == PI
    if e[0] in ("neg", "sum"):
        return all(real(part, is_pi) for part in nodes(e))
    if e[0] == "prod":
        return all(
            real(p, is_pi) if sign == "*" else number(p) not in (None, 0) or positive(p, is_pi) for sign, p in e[1]
        )
    if e[0] == "call" and len(e[2]) == 1:
        a = e[2][0]
        if e[1] in ("exp", "arctan"):
            return real(a, is_pi)
        return e[1] in ("sqrt", "ln") and positive(a, is_pi) or e[1] == "sqrt" and number(a) == 0
    return e[0] == "pow" and positive(e[1], is_pi) and number(e[2]) is not None


def positive(e, is_pi):
    """Whether e has a positive value, because of its form."""
    if number(e) is not None:
        return number(e) > 0
    if e[0] == "name":
        return is_pi and e[1] == PI
    if e[0] == "sum":
        return all(sign == 1 and positive(p, is_pi) for sign, p in e[1])
    if e[0] == "prod":
        return all(positive(p, is_pi) for _, p in e[1])
    if e[0] == "call" and len(e[2]) == 1:
        a = e[2][0]
        if e[1] == "ln":
            return number(a) is not None and number(a) > 1
        return real(a, is_pi) if e[1] == "exp" else e[1] in ("sqrt", "arctan") and positive(a, is_pi)
    return e[0] == "pow" and positive(e[1], is_pi) and number(e[2]) is not None


def denied(p):
    """What is shown of a statement that fails."""
    families = p[0] == "exists" and any(i is not None for b in p[1] for _, i in b[1])
    return N("all", p[1], N("not", p[2])) if p[0] == "exists" and not families else N("not", p)


def whole(e, point):
    """A sum of numerals and variables of the point as a whole number; else None."""
    if natural(e):
        return int(e[1])
    if e[0] == "name":
        value = next((v for place, v in point if place == e), None)
        return int(value[1]) if value is not None and natural(value) else None
    if e[0] == "sum":
        parts = [(sign, whole(part, point)) for sign, part in e[1]]
        return None if any(p is None for _, p in parts) else sum(sign * p for sign, p in parts)
    return None


def peeled(bindings, goal):
    """The bindings with those in front of the goal, and what is left of the goal."""
    while goal[0] == "all":
        bindings, goal = bindings + list(goal[1]), goal[2]
    if goal[0] != "extremum":
        return bindings, goal
    _, word, only, of, over, at, value = goal
    parts = [compare(put(of, dict(at), None), "=", value), compare(of, "<=" if word == "maximum" else ">=", value)]
    there = [compare(N("name", n), "=", e) for n, e in at]
    if only and there:
        there = there[0] if len(there) == 1 else N("and", tuple(there))
        parts.append(N("imp", compare(of, "=", value), there))
    return bindings + list(over), N("and", tuple(parts))


def only(bindings, families):
    for b in bindings:
        names = tuple(n for n in b[1] if (n[1] is not None) == families)
        if names:
            yield N("bind", names, *b[2:])


def without_value(e, bindings, goal, sequences):
    """The bindings around an expression of the goal, the premises before it, and what it needs for its value."""
    def way(p, bound, premises):
        """The way to the first place where e stands."""
        if p == e:
            return bound, premises
        if p[0] in ("exists", "extremum", "limit"):
            return None
        parts = [(q, bound, premises) for q in nodes(p) if q[0] != "bind"]
        if p[0] == "imp":
            parts[1] = (p[2], bound, premises + [p[1]])
        if p[0] == "all":
            parts = [(p[2], bound + list(p[1]), premises)]
        if p[0] == "over":
            index = N("bind", ((p[2], None),), True, (("range", True, p[3], p[4], True),), None)
            parts[2] = (p[5], bound + [index], premises)
        if p[0] == "integral":
            # Which end is the lower one is not said, so what a point of the interval is stays open.
            del parts[2]
        return next((found for part in parts if (found := way(*part)) is not None), None)

    found = way(goal, [], [])
    nothing = f"{text(e)} is no expression of the goal, or nothing is needed for its value"
    need(found is not None and not any(i is not None for b in found[0] for _, i in b[1]), nothing)
    bound, premises = found
    natural = {n for b in bindings + bound if b[2] for n, _ in b[1]}

    zero, needed = num(0), []
    if e[0] == "prod":
        needed = [compare(part, "!=", zero) for operator, part in e[1] if operator == "/"]
    elif e[0] == "pow":
        k, whole = exponent(e[2], lambda x: whole_by_form(x, lambda y: y[1] in natural))
        if not whole:
            needed = [compare(e[1], ">=" if k is not None and k > 0 else ">", zero)]
        elif k is not None:
            needed = [compare(e[1], "!=", zero)] if k < 0 else []
        else:
            needed = [N("or", (compare(e[1], "!=", zero), compare(e[2], ">=", zero)))]
    elif e[0] == "over":
        needed = [compare(e[3], "<=", plus(e[4], num(1)))]
    elif e[0] == "call" and e[1] in ("sqrt", "cbrt", "ln"):
        needed = [compare(e[2][0], ">" if e[1] == "ln" else ">=", zero)]
    elif e[0] == "call" and e[1] in ("arcsin", "arccos"):
        needed = [compare(part, ">=", zero) for part in to_the_ends(e[2][0])]
    elif e[0] == "call" and len(e[2]) == 1:
        family = next((b for b in bindings if any(n == e[1] and i is not None for n, i in b[1])), None)
        if family or e[1] in [u[0] for u in sequences]:
            needed = [compare(e[2][0], ">=", zero)]
        if family and family[4]:
            needed += [compare(family[4][0], "<=", e[2][0]), compare(e[2][0], "<=", family[4][1])]
    need(needed, nothing)
    return bound, premises, needed[0] if len(needed) == 1 else N("and", tuple(needed))


def tells_how_it_grows(p, moving):
    """Whether a domain or hypothesis is a lower bound of a variable that grows; it may say nothing else of one."""
    grows = sorted(names_in(p) & moving)
    bound = p[0] == "cmp" and p[2] in ((">",), (">=",)) and p[1][0][0] == "name" and p[1][1][0] == "num"
    need(not grows or bound and p[1][0][1] == grows[0], f"{grows} grows without bound and is tied to something else")
    return bool(grows)


def of(claim, point, undefined=None):
    """The claim that another one is false at a point, or that an expression of it has no value there."""
    bindings, goal = peeled(claim.given, claim.goal)
    premises = []
    if undefined is not None:
        bound, premises, goal = without_value(undefined, bindings, goal, claim.sequences)
        bindings = bindings + bound
    plain, families = list(only(bindings, False)), list(only(bindings, True))
    is_pi = PI not in {n for b in bindings for n, _ in b[1]} | {u[0] for u in claim.sequences}
    seen, equations = set(), []
    for place, value in point:
        no_place = f"{place[1]} is no place of a point here, or its value is no number for it"
        if place[0] == "name":
            found = [b for b in plain if place[1] in [n for n, _ in b[1]]]
        else:
            need(place[0] == "call" and len(place[2]) == 1 and natural(place[2][0]), no_place)
            found = [b for b in families if place[1] in [n for n, _ in b[1]]]
            for b in found[:1]:
                for c in constraints(b, value):
                    sides = [number(e) for e in c[1]]
                    need(None not in sides and COMPARE[c[2][0]](*sides), no_place)
                if b[4]:
                    low, index, high = whole(b[4][0], point), int(place[2][0][1]), whole(b[4][1], point)
                    need(low is not None and high is not None and low <= index <= high, no_place)
        need(found and place not in seen, no_place)
        has_value = number(value) is not None or place[0] == "name" and real(value, is_pi)
        need(natural(value) if found[0][2] else has_value, no_place)
        seen.add(place)
        equations.append(compare(place, "=", value))
    for b in families:
        for n, _ in b[1]:
            given = any(place[0] == "call" and place[1] == n for place in seen)
            need(given or not b[3], f"{n} may have no other members in its domain")
    moving = {p[2] for p in subtrees(goal) if p[0] == "limit"}
    parts = [p for p in domain(plain) + claim.assumptions if not tells_how_it_grows(p, moving)]
    parts += premises + [denied(goal)]
    free = [N("bind", b[1], b[2], (), b[4]) for b in plain]
    out = Claim(claim.name, [], [], parts[0] if len(parts) == 1 else N("and", tuple(parts)))
    out.given, out.sequences, out.assumptions = free + families, claim.sequences, equations
    declared = lambda bindings: {n for b in bindings for n, _ in b[1]}
    out.again = declared(bindings) - declared(claim.given)
    return out
