"""Walks through claims as they are written: their expressions in order, their names, and new names."""
import itertools
import re

from .claims import BINDERS, EXPRESSIONS, N, Node, nodes, room, shaped

NODES_LIMIT = 100_000


def children(x, go):
    """x with go of each node directly below it, in the order of the text; of an extremum the domain comes first."""
    if x[0] == "extremum":
        over = shaped(x[4], go)
        of, at, value = go(x[3]), shaped(x[5], go), go(x[6])
        return N("extremum", x[1], x[2], of, over, at, value)
    parts = (shaped(y, go) for y in x[1:])
    return N(x[0], *parts) if x[0] in EXPRESSIONS else Node((x[0], *parts))


def expressions(x, change):
    """x with change of each expression in it that is no part of another."""
    return change(x) if x[0] in EXPRESSIONS else children(x, lambda y: expressions(y, change))


def bottom_up(e, change):
    """e with change of each part, after the parts of that part."""
    return change(children(e, lambda y: bottom_up(y, change)))


def every(claim, change):
    """Changes each clause of a claim that is no declaration or hypothesis: sample, goal and argument."""
    claim.sample = [change(x) for x in claim.sample]
    claim.goal = change(claim.goal)
    claim.argument = [change(x) for x in claim.argument]


def clauses(claim):
    return [*claim.items, *claim.sample, claim.goal, *claim.argument]


def declared(item):
    """The names that an item declares."""
    if item[0] == "given":
        return [n for b in item[1] for n, _ in b[1]]
    return [item[1]] if item[0] in ("integer", "let", "define") else []


def bound(x):
    """The names that quantifiers, extrema, `obtain`, sums, integrals, parameters and indices bind in x, with those of `given`."""
    own = {"bind": lambda: [n for pair in x[1] for n in pair if n], "let": lambda: x[2], "define": lambda: [x[3]],
           **dict.fromkeys(BINDERS, lambda: [x[2]])}.get(x[0], list)()
    return set(own).union(*map(bound, nodes(x)))


def used(x):
    """The names that the expressions of x mention, also bound ones and those of functions."""
    own = {"name": lambda: [x[1]], "call": lambda: [x[1]], "deriv": lambda: x[2],
           **dict.fromkeys(BINDERS, lambda: [x[2]])}.get(x[0], list)()
    return set(own).union(*map(used, nodes(x)))


def names_of(claim):
    """Every name of a claim: declared, bound or used."""
    return set().union(*map(declared, claim.items), *map(bound, clauses(claim)), *map(used, clauses(claim)))


def bound_inside(claim):
    """The names that stand for several values in one claim: bound, and not declared for the whole of it."""
    own = {n for item in claim.items for n in declared(item)}
    indices = {x[2] for clause in clauses(claim) for x in parts(clause) if x[0] in BINDERS}
    return set().union(*map(bound, clauses(claim))) - own | indices


def parts(x):
    yield x
    for y in nodes(x):
        yield from parts(y)


class Fresh:
    """Gives new names for one claim: none is a name of the claim as it was written, nor given before, nor printed like one."""

    def __init__(self, claim):
        moving = {x[2] for clause in clauses(claim) for x in parts(clause) if x[0] in ("limit", "approach")}
        self.taken = {printed(n) for n in names_of(claim) | moving}

    def name(self, wanted):
        """The first free name of `wanted`, `wanted_2`, `wanted_3`, …"""
        names = itertools.chain([wanted], (f"{wanted}_{k}" for k in itertools.count(2)))
        return self.take(next(n for n in names if self.is_free(n)))

    def is_free(self, name):
        return printed(name) not in self.taken

    def take(self, name):
        self.taken.add(printed(name))
        return name


def printed(name):
    """The same for two names that look alike in print: x1 and x_1."""
    return re.sub(r"(?<=[A-Za-z])([0-9]+)$", r"_\1", name)


def size(x):
    """The number of nodes of a tree, counted up to a limit."""
    count, open_ = 0, [x]
    while open_ and count <= NODES_LIMIT:
        count += 1
        open_.extend(nodes(open_.pop()))
    return count


def fits(x):
    """Refuses trees with more than a limit of nodes, in time up to that limit."""
    need_room(size(x))
    return x


def need_room(count):
    room(count <= NODES_LIMIT, f"more than {NODES_LIMIT} nodes are written out")
