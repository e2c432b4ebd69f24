"""Derivatives by an angle, carried out, and the hypotheses that forbid them: section 14.5 of docs/certificates.md."""
from .author import ABBREVIATIONS
from .claims import constraints, FUNCTIONS, N, names_in, need, Node, nodes, num, put
from .everywhere import has_a_value
from .signs import number
from .walk import fits, parts

NOT_KNOWN = "this cannot be differentiated by an angle"
STRICT = {"<", ">", "!="}
ZERO = num(0)


def derivative(of, cos, sin, over, applied):
    """The derivative of a function of cos and sin, the point of θ/over, by θ. A function that may have no value is added 0 times."""
    def d(e):
        tag = e[0]
        if tag == "name" and e[1] in (cos, sin):
            out = N("neg", N("name", sin)) if e[1] == cos else N("name", cos)
            return out if over == 1 else N("prod", (("*", out), ("/", num(over))))
        if tag in ("num", "name"):
            return ZERO
        if tag == "neg":
            inner = d(e[1])
            return inner if inner == ZERO else N("neg", inner)
        if tag == "sum":
            return added([(sign, inner) for sign, part in e[1] if (inner := d(part)) != ZERO])
        if tag == "prod":
            return added([term for place in range(len(e[1])) if (term := of_factor(e[1], place))])
        if tag == "pow":
            return of_power(e[1], e[2])
        need(tag == "call" and e[1] not in applied and e[1] in {*FUNCTIONS, *ABBREVIATIONS, "floor", "ceil", "ceiling"},
             NOT_KNOWN)
        inner = [d(x) for x in e[2]]
        if all(x == ZERO for x in inner):
            return ZERO
        outer = {"sqrt": (("/", num(2)), ("/", e)), "exp": (("*", e),), "ln": (("/", e[2][0]),)}.get(e[1])
        need(outer and len(inner) == 1, NOT_KNOWN)
        return N("prod", (("*", inner[0]), *outer))

    def of_factor(factors, place):
        """A term of the rule for products, with its sign; 1/a has the derivative −a′/a²."""
        operator, a = factors[place]
        inner = d(a)
        if inner == ZERO:
            return None
        if operator == "*":
            return 1, N("prod", (*factors[:place], ("*", inner), *factors[place + 1:]))
        square = ("/", N("pow", a, num(2)))
        return -1, N("prod", (*factors[:place], square, *factors[place + 1:], ("*", inner)))

    def of_power(base, exponent):
        inner, k = d(base), number(exponent)
        if inner == ZERO and d(exponent) == ZERO or k == 0:
            return ZERO
        need(k is not None and k.denominator == 1, NOT_KNOWN)
        less = num(k - 1) if k >= 1 else N("neg", num(1 - k))
        return N("prod", (("*", exponent), ("*", N("pow", base, less)), ("*", inner)))

    out = fits(d(of))
    if has_a_value(of, lambda name: name not in applied, lambda name: False):
        return out
    return N("sum", ((1, out), (1, N("prod", (("*", ZERO), ("*", of))))))


def added(terms):
    """A sum; one that would begin with a minus sign begins with 0."""
    if not terms:
        return ZERO
    if len(terms) == 1:
        return terms[0][1] if terms[0][0] == 1 else N("neg", terms[0][1])
    return N("sum", tuple([(1, ZERO)] * (terms[0][0] == -1) + terms))


class Ties:
    """The names that hypotheses, domains and premises tie to each other, definitions put in."""

    def __init__(self, claim, is_variable):
        self.is_variable, self.sets, self.lets = is_variable, [], {}
        for item in claim.items:
            if item[0] == "given":
                self.domains(item[1])
            elif item[0] == "let":
                hidden = {n: v for n, v in self.lets.items() if n not in item[2]}
                self.lets[item[1]] = Node(("define", item[2], put(item[3], hidden, None)))
            elif item[0] == "assume":
                self.tie(item[2])
        self.premises(claim.goal)

    def tie(self, p):
        """A strict comparison leaves a whole neighbourhood, so it ties nothing. A conjunction is said part by part."""
        if p[0] == "and":
            for part in p[1]:
                self.tie(part)
        elif p[0] != "cmp" or not set(p[2]) <= STRICT:
            self.sets.append({n for n in names_in(put(p, self.lets, None)) if self.is_variable(n)})

    def domains(self, bindings):
        for b in bindings:
            for n, _ in b[1]:
                for p in constraints(b, N("name", n)):
                    self.tie(p)
            for e in b[4] or ():
                self.tie(N("cmp", (e, *(N("name", n) for n, _ in b[1])), ("=",) * len(b[1])))

    def premises(self, p):
        """What a part of the goal is said under."""
        if p[0] == "imp":
            self.tie(p[1])
        if p[0] in ("or", "iff"):
            for part in p[1]:
                if all(x[0] != "deriv" for x in parts(part)):
                    self.tie(part)
        if p[0] in ("all", "exists"):
            self.domains(p[1])
        if p[0] == "extremum":
            self.domains(p[4])
        for part in nodes(p) if p[0] in ("and", "or", "iff", "not", "all", "exists") else p[2:] if p[0] == "imp" else ():
            if part[0] != "bind":
                self.premises(part)

    def need_free(self, angle):
        tied = set().union(*(names for names in self.sets if angle in names)) - {angle}
        need(not tied, f"a derivative by {angle} is ambiguous: a hypothesis ties it to {', '.join(sorted(tied))}")
