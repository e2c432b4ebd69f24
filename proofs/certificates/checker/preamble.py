"""The preamble, whose declarations the claims of a file or folder share: section 14.3 of docs/certificates.md."""
from .author import ABBREVIATIONS, OF_ANGLES
from .claims import BINDERS, FUNCTIONS, mentioned, N, need, Node, PI
from .walk import bound as bound_in, declared

WORDS = FUNCTIONS | set(ABBREVIATIONS) | {*OF_ANGLES, "floor", "ceil", "ceiling"}


def free(x, bound):
    """The names in an expression, proposition or binding that nothing declares or binds around them."""
    tag, out = x[0], set()
    if tag in ("name", "call") and x[1] not in bound and not (tag == "call" and x[1] in WORDS):
        out.add(x[1])
    if tag == "deriv":
        out |= set(x[2]) - bound
    if tag in ("limit", "approach"):
        out |= {x[2]} - bound
    if tag in BINDERS:
        return free(x[3], bound) | free(x[4], bound) | free(x[5], within(bound, [x[2]]))
    if tag in ("all", "exists"):
        return free_of_bindings(x[1], bound) | free(x[2], within(bound, names_bound(x[1])))
    if tag == "extremum":
        outside = set().union(free(x[6], bound), *(free(e, bound) for _, e in x[5]))
        return outside | free_of_bindings(x[4], bound) | free(x[3], within(bound, names_bound(x[4])))
    return out.union(*(free(y, bound) for y in below(x)))


def below(x):
    """The nodes below x."""
    for y in x[1:]:
        yield from [y] if isinstance(y, Node) else below((None, *y)) if isinstance(y, tuple) else []


def within(bound, names):
    """The names that are bound inside. None has another meaning outside, and none is a function."""
    again = [n for n in names if n in bound or n in FUNCTIONS]
    need(not again and len(set(names)) == len(names), f"{', '.join(again or names)} is declared twice")
    return bound | set(names)


def names_bound(bindings):
    return [n for b in bindings for n, _ in b[1]]


def free_of_bindings(bindings, bound):
    out = set()
    for b in bindings:
        for n, index in b[1]:
            inside = within(bound, [index] if index else [])
            out |= set().union(*(free(y, inside) for y in below(N("bind", (), b[2], b[3], None))))
            out |= set().union(*(free(e, bound) for e in b[4] or ()))
            bound = within(bound, [n])
    return out


def free_of_item(item, bound):
    """The names that an item mentions and does not declare."""
    if item[0] == "given":
        return free_of_bindings(item[1], bound)
    if item[0] == "let":
        return free(item[3], within(bound, item[2]))
    if item[0] == "define":
        return free(item[2], bound) | free(item[4], within(bound, [item[1], item[3]]))
    return free(item[2], bound) if item[0] == "assume" else set()


def apart(items):
    """The items, in which no parameter of a `let` and no index of a `define` has the name of something that they declare."""
    names = {n for item in items for n in declared(item)}
    out = []
    for item in items:
        if item[0] in ("let", "define"):
            bound, body = (item[2], item[3]) if item[0] == "let" else ((item[3],), item[4])
            inside = mentioned(body)
            new = {}
            for v in bound:
                if v in names and v != PI and is_number_in(v, body):
                    new[v] = next(w for k in range(2, 10**6) if (w := f"{v}_{k}") not in names | inside | set(new.values()))
            bound, body = tuple(new.get(v, v) for v in bound), renamed(body, new)
            item = Node(("let", item[1], bound, body) if item[0] == "let" else (*item[:3], *bound, body))
        out.append(item)
    return out


def is_number_in(v, x):
    """Whether a name stands in an expression for a number alone: nothing in it binds or applies the name."""
    own = x[1] != v if x[0] == "call" else x[2] != v if x[0] in BINDERS else True
    return own and all(is_number_in(v, y) for y in below(x))


def renamed(x, new):
    """An expression with names for others, none of which it binds."""
    if not isinstance(x, (Node, tuple)):
        return x
    if isinstance(x, Node) and x[0] == "name":
        return N("name", new.get(x[1], x[1]))
    if isinstance(x, Node) and x[0] == "deriv":
        return N("deriv", renamed(x[1], new), tuple(new.get(v, v) for v in x[2]))
    return type(x)(renamed(y, new) for y in x)


def free_of_steps(steps, bound):
    """The names that an argument mentions; what `obtain` declares holds up to the end of its block."""
    out = set()
    for step in steps:
        if step[0] == "have":
            out |= free(step[2], bound) | free_of_steps(step[3], bound)
        elif step[0] == "obtain":
            out |= free(step[4], bound) | free_of_bindings(step[1:2], bound)
            bound = within(bound, names_bound(step[1:2]))
            out |= free(step[3], bound)
        else:
            out |= set().union(*(free(e, bound) for e in step[2])) | free_of_steps(step[3], bound)
    return out


def free_of_claim(claim):
    """The names that a claim uses and does not declare itself."""
    out, bound = set(), set()
    for item in claim.items:
        out |= free_of_item(item, bound)
        bound = within(bound, declared(item))
    out |= free(claim.goal, bound) | free_of_steps(claim.argument, bound)
    return out | {n for _, n, _ in claim.sample} - bound | set().union(*(free(e, bound) for *_, e in claim.sample))


def need_one_pi(items, others=()):
    """Only a declaration gives `pi` another meaning than π, before it is used as that number."""
    used = False
    for item in items:
        inside = {i for b in item[1] for _, i in b[1]} if item[0] == "given" else bound_in(item)
        need(PI not in inside, f"nothing but a declaration is called {PI}")
        used = used or PI in free_of_item(item, set())
        need(not (used and PI in declared(item)), f"{PI} is used before it is declared")
    need(not any(PI in bound_in(x) for x in others), f"nothing but a declaration is called {PI}")


def cited(steps):
    """The facts that an argument cites."""
    own = {fact for step in steps if step[0] == "by" for fact in step[1]}
    return own.union(*(cited(step[3]) for step in steps if step[0] in ("have", "by")))


class Preamble:
    """Declarations and hypotheses in their order."""

    def __init__(self, items=()):
        self.items = tuple(apart(items))
        self.names = {n for item in self.items for n in declared(item)}

    def speaks_of(self):
        """What each item mentions, with what the definitions before it mention in turn."""
        out = [free_of_item(item, set()) for item in self.items]
        for place, names in enumerate(out):
            for before in reversed(range(place)):
                item = self.items[before]
                if item[0] in ("let", "define") and names & set(declared(item)):
                    names |= out[before]
        return out

    def put_before(self, claim):
        """Inserts what the claim needs: the declarations of its free names, and every hypothesis about them."""
        again = [n for item in claim.items for n in declared(item) if n in self.names]
        need(not again, f"the preamble already declares {', '.join(again)}")
        claim.items = apart(claim.items)
        wanted, labels, taken, speaks_of = free_of_claim(claim), cited(claim.argument), set(), self.speaks_of()

        def is_wanted(place):
            item, names = self.items[place], speaks_of[place]
            if item[0] != "assume":
                return bool(wanted & set(declared(item)))
            return item[1] in labels or not names or bool(wanted & names)

        while more := [k for k in range(len(self.items)) if k not in taken and is_wanted(k)]:
            taken.add(more[0])
            wanted |= speaks_of[more[0]]
        claim.items = apart([only(self.items[k], wanted) for k in sorted(taken)] + claim.items)


def only(item, wanted):
    """The item; of a `given` the names that are wanted."""
    if item[0] != "given":
        return item
    (binding,) = item[1]
    names = tuple(pair for pair in binding[1] if pair[0] in wanted)
    return Node(("given", (N("bind", names, *binding[2:]),)))
