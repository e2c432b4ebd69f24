"""A claim file as its author wrote it: sections 14.1 and 14.2 of docs/certificates.md.

A clause is a node: ("given", bindings), ("integer", name), ("let", name, parameters, value), ("define", u, initial, index, step),
("assume", label, proposition). A step of an argument is a node, too: ("have", label, proposition, steps), ("obtain", binding,
label, proposition, value), ("by", the facts and claims that it cites, what else it mentions, steps); a value for a name is
("value", name, expression).
"""
from .claims import (
    BEGINNINGS, BINDERS, compare, constraints, FUNCTIONS, N, need, Node, nodes, num, Parser, PI, plus, RELATIONS, RESERVED, subtrees,
)

ABBREVIATIONS = {"abs": (1, 1), "max": (2, 8), "min": (2, 8), "factorial": (1, 1), "binomial": (2, 2), "trace": (1, 1),
                 "inverse": (1, 1)}
OF_ANGLES = ("sin", "cos", "tan")
SHARED = ("paper", "source", "section", "reading", "given", "let", "define", "assume")
ORDER_LIMIT = 20


# The label of a hypothesis that defines what this reading makes: a floor, or a recurrence as a family.
MADE = "made"


class Written:
    """A claim as it is written: clauses that declare or suppose in their order, sample, goal and argument."""

    def __init__(self, name):
        self.name, self.using, self.items, self.sample, self.goal, self.argument = name, [], [], [], None, []


class Author(Parser):
    """Reads claims. `declared` are the names that the clauses so far, or the preamble, declare."""

    from_author = True

    def __init__(self, source):
        super().__init__(source)
        self.declared, self.moving, self.integer = set(), [], False

    # Expressions and propositions.
    def base(self):
        e = self.atom()
        if self.take("!"):
            need(not self.at("!"), "there is no n!!")
            e = N("call", "factorial", (e,))
        return e

    def need_no_power(self):
        super().need_no_power()
        need(not self.at("!"), "a factorial that is read in two ways")

    def atom(self):
        if self.take("|"):
            e = self.expr()
            self.want("|")
            return N("call", "abs", (e,))
        return super().atom()

    def last(self):
        return N("name", "infinity") if self.take("infinity") else self.expr()

    def negation(self):
        p = super().negation()
        return self.without_end(p) if p[0] == "cmp" else p

    def without_end(self, p):
        """`S = L` or `L = S` for S up to infinity: S up to a new variable tends to L."""
        infinite = [S for S in subtrees(p) if S[0] in ("over", "integral") and S[-2] == N("name", "infinity")]
        if not infinite:
            return p
        need(len(infinite) == 1 and p[2] == ("=",) and infinite[0] in p[1], "a sum without an end stands alone on one side of an equation")
        S = infinite[0]
        value = p[1][1] if p[1][0] == S else p[1][0]
        domain = "real" if S[0] == "integral" else "natural"
        v = self.unused("X" if domain == "real" else "N")
        if all(other != v for other, _ in self.moving):
            self.moving.append((v, domain))
        end, low = N("name", v), S[3]
        if domain == "natural" and low not in (N("num", "0"), N("num", "1")):
            end = plus(end, low)
        return N("limit", N(*S[:-2], end, S[-1]), v, value)

    def unused(self, letter):
        """The letter, or the first of the letter with 1, 2, … that is no word of this claim."""
        begins = [i for i, (kind, text, first) in enumerate(self.tokens) if kind == "word" and text == "claim" and first]
        start = max((i for i in begins if i < self.at_token), default=0)
        end = min((i for i in begins if i > start), default=len(self.tokens))
        words = {text for kind, text, _ in self.tokens[start:end] if kind == "word"} | self.declared
        return next(n for k in range(len(words) + 2) if (n := letter + (str(k) if k else "")) not in words)

    def extremum(self, word):
        """`maximum of F over x in D is M` says that M is a bound of F over D, and a value of F there."""
        start = self.at_token
        _, of, _, over = self.read("of E over B")
        if not self.take("is"):
            self.at_token = start
            return super().extremum(word)
        value = self.expr()
        bound = N("all", over, compare(of, "<=" if word == "maximum" else ">=", value))
        return N("and", (bound, N("exists", over, compare(of, "=", value))))

    def limit(self):
        """A limit to infinity whose value is a number is ("limit", F, x, value). Any other is ("approach", F, x, whether x is
        natural, the point or None, the sides, the value, or True or False for infinity with its sign)."""
        _, of, _, v = self.read("of E as N")
        domain = self.take("natural", "real")
        self.moving.append((v, domain))
        self.want("->")
        point, sides = None, (1,)
        if not self.take("infinity"):
            need(not domain, f"the variable {v} of a limit at a point is real")
            point, sides = self.expr(), (1, -1)
            if self.take("from"):
                sides = (1,) if self.take("above") else (-1,)
                need(sides == (1,) or self.take("below"), "expected `above` or `below`")
        self.want("is")
        start, down = self.at_token, bool(self.take("-"))
        value = not down
        if not self.take("infinity"):
            self.at_token = start
            value = self.expr()
            if point is None:
                return N("limit", of, v, value)
        return N("approach", of, v, domain == "natural", point, sides, value)

    def bindings(self):
        out = super().bindings()
        need(not self.integer, "an `integer` is declared under `given` only")
        return out

    # Declarations.
    def given(self):
        """`m1, m2 > 0; 0 < a < b; k integer`: a relation declares the names in it that are new, and is a hypothesis."""
        out = []
        while True:
            relates, self.integer = self.begins_relation(), False
            out += self.related() if relates else self.domain()
            self.integer = False
            if not self.take(";", ",") or self.at_clause():
                return out

    def related(self):
        sides = self.many(self.expr, *RELATIONS)
        need(len(sides) > 1, "expected a comparison")
        p = N("cmp", tuple(e for _, e in sides), tuple(r for r, _ in sides[1:]))
        new = [n for n in dict.fromkeys(free_in_order(p)) if n != PI and n not in self.declared]
        self.declared.update(new)
        binding = N("bind", tuple((n, None) for n in new), False, (), None)
        return [Node(("given", (binding,)))] * bool(new) + [Node(("assume", None, p))]

    def domain(self):
        """A binding; of an `integer` its bounds are hypotheses."""
        b = self.binding()
        self.declared.update(n for n, _ in b[1])
        if not self.integer:
            return [Node(("given", (b,)))]
        need(not b[2] and not b[4] and all(i is None for _, i in b[1]),
             "`integer` cannot be combined with a family, a range or `natural`")
        out = []
        for n, _ in b[1]:
            out.append(Node(("integer", n)))
            out += [Node(("assume", None, p)) for p in constraints(b, N("name", n))]
        return out

    def ahead(self, k):
        return (self.tokens[self.at_token + k:] or self.tokens[-1:])[0]

    def begins_relation(self):
        """Whether a comparison of expressions begins here, and not a name with its domain."""
        (kind, word, _), (next_kind, sign, _) = self.ahead(0), self.ahead(1)
        if kind != "word":
            return True
        if sign == "(":
            # `abs(k) > 0` with a new name k declares a family.
            family = self.ahead(2)[0] == "word" and self.ahead(2)[1] not in self.declared and self.ahead(3)[1] == ")"
            return word in FUNCTIONS or word in self.declared or word in (*ABBREVIATIONS, *OF_ANGLES) and not family
        if next_kind == "raised" or sign in ("+", "-", "*", "/", "^", "!"):
            return True
        if sign not in RELATIONS:
            return False
        relations, chains = set(self.relations_ahead()), ({"<", "<="}, {">", ">="})
        one = len(self.relations_ahead()) == 1
        need(one or any(relations <= chain for chain in chains), "these comparison signs do not form a chain")
        return not one or word in self.declared

    def relations_ahead(self):
        """The signs of comparison up to the end of the declaration, or to a word of the language."""
        out, level, at = [], 0, self.at_token
        while True:
            kind, text, first = self.tokens[at]
            at += 1
            level = max(level + (text in ("(", "[")) - (text in (")", "]")), 0)
            ends = text in (",", ";") or kind == "word" and text in RESERVED
            if kind == "end" or first and text in BEGINNINGS or level == 0 and ends:
                return out
            if level == 0 and text in RELATIONS:
                out.append(text)

    def define(self):
        """One sequence by the member before is kept; all others are families with equations."""
        names = [n for _, n in self.many(self.name, ",")]
        self.want("by")
        equations = [e for _, e in self.many(self.equation, ",")]
        self.declared.update(names)
        need({u for u, *_ in equations} <= set(names), "a definition by recurrence reads `u(0) = …, u(k + 1) = …`")
        steps = [e for e in equations if e[1]]
        need(sorted(u for u, *_ in steps) == sorted(names), "each sequence needs one step")
        for u, _, shift, _ in steps:
            first = sorted(at for other, index, at, _ in equations if other == u and not index)
            need(first == list(range(shift)), f"{u} needs its members before the step, each once")
        (u, k, order, step), *more = steps
        if order == 1 and not more:
            (initial,) = [value for _, index, _, value in equations if not index]
            return [Node(("define", u, initial, k, step))]
        binding = N("bind", tuple((n, k) for n in names), False, (), None)
        return [Node(("given", (binding,)))] + [Node(("assume", MADE, stated(*e))) for e in equations]

    def equation(self):
        """(u, k, shift, value) of `u(k + shift) = value`; k is None for a first member."""
        u, _ = self.read("N (")
        index = None
        if self.tokens[self.at_token][0] != "number":
            index, _ = self.read("N +")
        shift = self.kind("number")
        need(shift.isdigit() and bool(index) <= int(shift) <= ORDER_LIMIT, "a member is defined by those before it")
        _, _, value = self.read(") = E")
        return u, index, int(shift), value

    def item(self, word):
        """What a clause `given`, `let`, `define` or `assume` declares or supposes."""
        if word in ("given", "define"):
            return getattr(self, word)()
        if word == "let":
            name, parameters = self.name(), ()
            if self.take("("):
                parameters = tuple(n for _, n in self.many(self.name, ","))
                self.want(")")
            self.declared.add(name)
            return [Node(("let", name, parameters, self.read("= E")[1]))]
        label = None
        if self.ahead(0)[0] == "word" and self.ahead(1)[1] == ":":
            label, _ = self.read("N :")
        return [Node(("assume", label, self.proposition()))]

    # Arguments.
    def argument(self):
        """`by METHOD`, `{ STEPS }` or nothing."""
        if self.take("by"):
            return (self.method(),)
        return self.block() if self.take("{") else ()

    def block(self):
        steps = []
        while not self.take("}"):
            concludes = self.take("conclude")
            if self.take("by"):
                steps.append(self.method())
                self.want("}")
                break
            need(not concludes, "expected `by` and a method")
            if self.take("obtain"):
                bindings, _, label, _, p, _, name, _, value = self.labelled("B with N : P by N = E")
                need(len(bindings) == 1 and bindings[0][1] == ((name, None),), "`obtain` names one variable")
                steps.append(Node(("obtain", bindings[0], label, p, value)))
            else:
                need(self.take("have", "case"), "expected `have`, `obtain`, `case`, `conclude by` or `}`")
                label, _, p = self.labelled("N : P")
                steps.append(Node(("have", label, p, self.argument())))
        return tuple(steps)

    def labelled(self, pattern):
        """Like `read`, with P for a proposition."""
        front, _, back = pattern.partition(" P")
        return [*self.read(front), self.proposition(), *self.read(back)]

    def method(self):
        """("by", facts and claims that it cites, what it mentions, its steps)"""
        cited, parts, steps = (), (), ()
        if self.take("product"):
            self.want("of")
            factors = [f for _, f in self.many(self.factor, ",")]
            return Node(("by", tuple(f for f, _ in factors), tuple(e for _, e in factors if e), ()))
        word = self.name()
        if word == "algebra":
            cited = tuple(n for _, n in self.many(self.name, ",")) if self.take("from") else ()
        elif word == "induction":
            self.read("on N")
            steps = self.block() if self.take("{") else ()
        elif word == "power":
            _, fact, _, e = self.read("of N to E")
            cited, parts = (fact,), (e,)
        elif word == "mean":
            parts = tuple(self.read("of E , E with weight E")[1::2])
        elif word == "hoelder":
            parts = tuple(e for e in self.read("of ( E , E ) , ( E , E ) with weight E") if isinstance(e, Node))
        elif word == "witness":
            parts = self.values()
        elif word == "squeeze":
            parts = tuple(self.read("between E and E")[1::2])
        else:
            cited, parts = (word,), self.values() if self.take("with") else ()
        return Node(("by", cited, parts, steps))

    def factor(self):
        """A fact, and the power to which it is raised."""
        fact, e = self.name(), None
        if self.take("^"):
            e = self.atom() if self.at("(") or self.tokens[self.at_token][0] == "number" else N("name", self.name())
        return fact, e

    def values(self):
        return tuple(Node(("value", n, e)) for n, e in self.assignments())

    # Claims.
    def claim(self):
        """One claim, from the word `claim` on."""
        self.want("claim")
        out, self.moving = Written(self.kind("word")), []
        self.kind("text")
        while self.tokens[self.at_token][0] != "end" and not self.at("claim", "text"):
            need(self.at_clause(), f"expected a clause, found `{self.tokens[self.at_token][1]}`")
            word = self.kind("word")
            if word == "using":
                out.using += [n for _, n in self.many(lambda: self.kind("word"), ",")]
            elif word in ("given", "let", "define", "assume"):
                out.items += self.item(word)
            elif word == "sample":
                out.sample += self.values()
            elif word == "prove":
                need(out.goal is None, "two goals")
                out.goal, out.argument = self.proposition(), list(self.argument())
            else:
                self.skip()
            need(self.at_clause(), f"expected the end of the clause, found `{self.tokens[self.at_token][1]}`")
        need(out.goal, f"{out.name} has no goal")
        declared, seen = set(self.declared), set()
        for v, domain in self.moving:
            if v not in seen and (domain or v not in declared):
                binding = N("bind", ((v, None),), domain == "natural", (), None)
                out.items.insert(0, Node(("given", (binding,))))
            seen.add(v)
        return out

    def skip(self):
        while not self.at_clause():
            self.at_token += 1


def stated(u, k, shift, value):
    """The equation of a recurrence as a hypothesis."""
    if k is None:
        return compare(N("call", u, (num(shift),)), "=", value)
    binding = N("bind", ((k, None),), True, (), None)
    return N("all", (binding,), compare(N("call", u, (plus(N("name", k), num(shift)),)), "=", value))


def free_in_order(x, bound=()):
    """The names that stand free in an expression or comparison, without those that are applied, from left to right."""
    if x[0] == "name":
        return [] if x[1] in bound else [x[1]]
    if x[0] in BINDERS:
        ends = free_in_order(x[3], bound) + free_in_order(x[4], bound)
        return ends + free_in_order(x[5], (*bound, x[2]))
    return [n for y in nodes(x) for n in free_in_order(y, bound)]
