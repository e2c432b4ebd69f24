"""floor and ceil, written out as whole numbers with their bounds: section 14.7 of docs/certificates.md."""
from .author import MADE
from .claims import N, need, Node, num, plus, room
from .everywhere import Values
from .walk import bottom_up, bound_inside, clauses, declared, every, expressions, used

WORDS = ("floor", "ceil", "ceiling")
FLOORS_LIMIT = 20


def write_out(claim, fresh):
    own = {n for item in claim.items for n in declared(item)}
    if not set().union(*map(used, clauses(claim))) & set(WORDS):
        return
    inside, values, floors, open_ = bound_inside(claim), Values(), {}, []

    def floor(of):
        if of in floors:
            return N("name", floors[of])
        need(not (used(of) & inside), "a floor depends on a bound variable")
        need(values.exist_for(of), "the argument of a floor may have no value")
        room(len(floors) < FLOORS_LIMIT, f"more than {FLOORS_LIMIT} floors")
        name = floors[of] = fresh.name(f"floor_{len(floors) + 1}")
        open_.extend(whole(name, fresh))
        here = N("name", name)
        open_.append(Node(("assume", MADE, N("cmp", (here, of, plus(here, num(1))), ("<=", "<")))))
        return here

    def change(e):
        if e[0] != "call" or e[1] not in WORDS or e[1] in own | inside:
            return e
        need(len(e[2]) == 1, f"{e[1]} takes one argument")
        return floor(e[2][0]) if e[1] == "floor" else N("neg", floor(N("neg", e[2][0])))

    def clause(x):
        return expressions(x, lambda e: bottom_up(e, change))

    items = []
    for item in claim.items:
        item = clause(item)
        values.learn(item)
        items += open_ + [item]
        open_.clear()
    every(claim, clause)
    claim.items = items + open_


def whole(name, fresh):
    """The declaration of an integer: the difference of two natural numbers."""
    up, down = fresh.name(f"{name}_up"), fresh.name(f"{name}_down")
    binding = N("bind", ((up, None), (down, None)), True, (), None)
    difference = plus(N("name", up), N("name", down), -1)
    return [Node(("given", (binding,))), Node(("let", name, (), difference))]
