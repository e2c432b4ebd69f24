#!/usr/bin/env python3
"""Checks certificates by docs/certificates.md. It shares no code with Carom.

    check.py CLAIMS... -- CERTIFICATES...      files, or folders of *.claim and *.cert files

It reads each claim as its author wrote it, and writes it out by itself. Prints `accepted NAME`, `refuted NAME`, `rejected NAME:
step LABEL (RULE): reason`, or `not covered NAME: reason` for what it cannot read or has no room for; then how many proved claims it
covers. Exit code: 0 if every certificate is accepted, 1 if one is rejected, 2 if a file cannot be read, 3 if none is rejected
and some are not covered.
"""
import collections
import hashlib
import itertools
import os
import re
import sys
from fractions import Fraction as Q

from checker import circle, reading, refutation
from checker.numbers import evaluate
from checker.claims import (
    as_power, bindings_of, bound_once, compare, conjuncts, constraints, domain, FUNCTIONS, mentioned, N, names_in, need,
    nodes, NotCovered, num, Parser, PI, plus, put, Refused, same, single, subtrees, text,
)
from checker.logic import Logic
from checker.signs import ANY, NOT_NEGATIVE, NOT_ZERO, PLUS, POSITIVE, sign, SIGNS, TIMES, whole_by_form
from checker.terms import atom, coefficients, F, multiple, ONE, primes, total, ZERO

sys.setrecursionlimit(20000)
LEMMA = "the weighted mean inequality for two values"
TANGENT = "exp lies above its tangent"
MEAN_VALUE = "the mean value theorem"
INTERMEDIATE_VALUE = "the intermediate value theorem"
NO_FACT = "no fact and no accepted claim under `using` is called {}"
ONE_VALUE = "each variable has one value, and nothing else has any"
ONE_VARIABLE = "a statement `for all` one variable is needed"


def is_natural(e, naturals):
    """Whether an expression is whole by its form, and no minus sign stands in it."""
    if e[0] in ("sum", "prod"):
        return all(sign in (1, "*") and is_natural(x, naturals) for sign, x in e[1])
    if e[0] == "pow":
        return is_natural(e[1], naturals) and whole_by_form(e, lambda x: x[1] in naturals)
    return (e[0] in ("num", "name", "call")) and whole_by_form(e, lambda x: x[1] in naturals)


def begins(x, naturals):
    """The sums and products over an index below x: each with its lower end, and the names of natural numbers there. What an
    integral binds is none of these."""
    inner = naturals | {n for b in bindings_of(x) if b[2] for n, _ in b[1]}
    if x[0] == "over":
        yield x, x[3], naturals
        yield from begins(x[3], naturals)
        yield from begins(x[4], naturals)
        yield from begins(x[5], naturals | {x[2]})
    elif x[0] == "integral":
        for end in x[3:5]:
            yield from begins(end, naturals)
        yield from begins(x[5], naturals - {x[2]})
    else:
        for y in nodes(x):
            yield from begins(y, inner)


def on_an_interval(binding):
    """The one real variable of a binding, and its bounds. They do not move with it, so its domain is an interval."""
    _, ((t, index),), natural, limits, _ = binding
    bounds = all(c[0] == "interval" or c[0] == "relation" and c[1] not in ("=", "!=") for c in limits)
    need(bounds and not natural and index is None and not any(t in names_in(e) for c in limits for e in nodes(c)),
         "a real variable with bounds `<`, `<=`, `>`, `>=` that do not mention it is needed")
    return t, limits


def real(t, limits):
    return N("bind", ((t, None),), False, limits, None)


def with_ends(t, limits):
    """The domain as it is, where its intervals have their ends, and with all its ends. Each contains the one before."""
    weak = {"<": "<=", ">": ">="}
    some = tuple((c[0], True, c[2], c[3], True) if c[0] == "interval" else c for c in limits)
    ends = tuple(c[:1] + (weak.get(c[1], c[1]), c[2]) if c[0] == "relation" else c for c in some)
    return [real(t, bounds) for bounds in (limits, some, ends)]


def without_ends(t, limits):
    """The domain without all its ends: what lies strictly between two of its numbers is in it."""
    strict = {"<=": "<", ">=": ">"}
    return real(t, tuple((c[0], False, c[2], c[3], False) if c[0] == "interval" else
                         c[:1] + (strict.get(c[1], c[1]), c[2]) for c in limits))


class Checker(Logic):
    """The facts, the open blocks and the rules: sections 3, 4 and 8 of the page."""

    def __init__(self, claim, accepted):
        super().__init__(claim)
        self.accepted, self.rests_on, self.facts, self.blocks = accepted, set(), {}, []
        self.statement()

    def statement(self):
        claim, count = self.claim, itertools.count(1)
        for b in claim.given:
            self.declare(b)
        moving = {x[2] for p in claim.assumptions + [claim.goal] for x in subtrees(p) if x[0] == "limit"}
        later = set(self.sequences)
        facts = [p for b in claim.given for p in self.domains(b)] + claim.assumptions
        for u, initial, k, step in claim.sequences:
            names = names_in(initial) | names_in(step) - {k}
            later.discard(u)
            once = [x for x in subtrees(step) if x[0] == "call" and x[1] == u]
            free = put(step, {k: N("name", "!")})
            same = sum(x == N("call", u, (N("name", "!"),)) for x in subtrees(free))
            need(u not in names_in(initial) and same == len(once) and not names & later and not names & moving,
                 f"the sequence {u} is not defined by the member before")
            self.need_declared(names, initial, step)
        for v in moving:
            need(v in self.scope, f"{v} is not declared here")
            for p in facts:
                bound = p[0] == "cmp" and p[1][0] == N("name", v) and p[2] in ((">",), (">=",)) and p[1][1][0] == "num"
                need(bound or v not in names_in(p), f"{v} grows without bound and is tied to something else")
        self.need_declared(set().union(*map(names_in, [*facts, claim.goal])), *facts, claim.goal)
        for p in facts:
            self.know(f"h{next(count)}", p)
        self.begin_at_naturals(facts)
        for sequence in claim.sequences:
            for signs in (ANY, POSITIVE, NOT_NEGATIVE):
                try:
                    self.members(*sequence, signs)
                    self.signs_of_members[sequence[0]] = signs
                    break
                except Refused:
                    if signs == NOT_NEGATIVE:
                        raise

    def need_declared(self, names, *where):
        """Whether names are declared. π needs no declaration, but it takes no argument, and nothing differentiates by it."""
        for n in names:
            other = n == PI and any(x[0] == "call" and x[1] == PI or x[0] == "deriv" and PI in x[2]
                                    for e in where for x in subtrees(e))
            need(n in FUNCTIONS or self.is_declared(n) or n == PI and not other, f"{n} is not declared here")

    def begin_at_naturals(self, facts):
        """Sums and products in hypotheses begin at natural numbers: by their form, or by hypotheses without sums."""
        claimed = frozenset(n for b in self.claim.given if b[2] for n, _ in b[1])
        left = [(e, low) for p in facts for e, low, naturals in begins(p, claimed) if not is_natural(low, naturals)]
        without_sums = [label for label, p in self.facts.items() if not any(x[0] == "over" for x in subtrees(p))]
        known = self.known(without_sums if left else [], ())
        for e, low in left:
            try:
                shown = self.has(low, NOT_NEGATIVE, known)
            except Refused:
                shown = False
            need(shown, f"the range or index of {text(e)} is not shown to be one")

    def members(self, u, initial, k, step, signs):
        """Whether each member of a sequence has a value and one of these signs, by induction."""
        known = self.known(self.facts, ())
        self.defined(initial, known)
        self.show(initial, signs, known)
        def inside():
            self.note(self.read(N("call", u, (N("name", k),))), signs, known)
            self.defined(step, known)
            self.show(step, signs, known)
        self.inside({k: self.variable(k, True)}, inside)

    def domains(self, b):
        yield from domain([b])
        for n, i in b[1]:
            facts = list(constraints(b, N("call", n, (N("name", i),)))) if i is not None else []
            if facts:
                index = N("bind", ((i, None),), True, (("range", True, *b[4], True),) if b[4] else (), None)
                yield N("all", (index,), facts[0] if len(facts) == 1 else N("and", tuple(facts)))

    # Facts and blocks.
    def fact(self, label):
        need(label in self.facts, NO_FACT.format(label))
        return self.facts[label]

    def know(self, label, p):
        need(label not in self.facts and label not in [b[0] for b in self.blocks], f"the label {label} is in use")
        self.facts[label] = p

    def end(self, conclusion):
        need(self.blocks, "no block is open")
        label, goal, facts, scope = self.blocks[-1]
        need(same(self.fact(conclusion), goal[2]), f"the fact {conclusion} is not the block's conclusion")
        self.blocks.pop()
        self.facts, self.scope = facts, scope
        self.know(label, goal)

    def step(self, s):
        goal = s.goal
        bound_once(goal, ({*self.scope, *self.families, *self.sequences}) - self.claim.again, indices=False)
        known = self.known(s.by, s.using)
        need(s.label not in self.facts and s.label not in [b[0] for b in self.blocks], f"the label {s.label} is in use")
        facts, scope = dict(self.facts), dict(self.scope)
        getattr(self, "rule_" + s.rule)(goal, s, known)
        if s.rule not in ("suppose", "let"):
            return self.know(s.label, goal)
        new = [goal[1]] if s.rule == "suppose" else domain(goal[1])
        for k, p in enumerate(new):
            self.know(f"{s.label}s" if s.rule == "suppose" else f"{s.label}d{k + 1}", p)
        if s.rule == "let":
            for b in goal[1]:
                self.declare(b)
        self.blocks.append((s.label, goal, facts, scope))

    def finish(self):
        need(not self.blocks, "a block is open at the end")
        shown = list(self.facts.values())[-1:]
        need(shown and same(shown[0], self.claim.goal), "the last step does not show the goal")

    # Rules.
    def rule_suppose(self, goal, s, known):
        need(goal[0] == "imp", "an implication is needed")
        self.has_value(goal[1], known)

    def rule_let(self, goal, s, known):
        need(goal[0] == "all", "a statement `for all` is needed")
        self.within(goal[1], known, lambda inner: None)

    def holds(self, p, s, known):
        """Whether p is a cited fact or a part of one, or a comparison that signs show."""
        if any(same(p, part) for label in s.sources for part in [self.fact(label), *conjuncts(self.fact(label))]):
            return
        if p[0] == "and":
            for part in p[1]:
                self.holds(part, s, known)
            return
        need(p[0] == "cmp", f"needs {text(p)}")
        self.has_value(p, known)
        for a, r, b in zip(p[1], p[2], p[1][1:]):
            difference = self.read(a, known.equations) - self.read(b, known.equations)
            need(not self.signs(difference, known) & ~SIGNS[r], f"needs {text(p)}")

    def rule_instance(self, goal, s, known):
        source, *sources = s.sources
        s = s._replace(sources=sources)
        if source in self.facts:
            fact = self.facts[source]
            need(fact[0] == "all", "a statement `for all` is needed")
            bindings, assumptions, shown = fact[1], [], fact[2]
        else:
            need(source in self.accepted and source in self.claim.using, NO_FACT.format(source))
            cited, rests_on = self.accepted[source]
            need(not cited.sequences or not s.values and all(u in self.claim.sequences for u in cited.sequences),
                 "a sequence of the cited claim is another here")
            own = {n for b in cited.given for n, _ in b[1]} | {u[0] for u in cited.sequences}
            speaks_of_pi = PI in words((cited.given, cited.sequences, cited.assumptions, cited.goal)) - own
            need(not (speaks_of_pi and self.is_declared(PI)), f"{PI} would be captured")
            bindings, assumptions, shown = cited.given, cited.assumptions, cited.goal
            self.rests_on |= rests_on | {source}
        m = self.values(bindings, s.values, known)
        for p in domain(bindings) + assumptions:
            self.holds(put(p, m), s, known)
        need(same(put(shown, m), goal), f"with these values it says {text(put(shown, m))}")

    def values(self, bindings, given, known):
        """The values for the variables of bindings; one without a value keeps its name."""
        names, m = [n for n, _ in given], {}
        need(len(set(names)) == len(names) and set(names) <= {n for b in bindings for n, _ in b[1]},
             ONE_VALUE)
        for b in bindings:
            for n, index in b[1]:
                e = m[n] = dict(given).get(n, N("name", n))
                if index is not None:
                    need(e[0] == "name" and e[1] in self.families, "a family is put for a family")
                    here, said = self.families[e[1]], lambda c: list(constraints(c, N("name", "!")))
                    free = set().union(*map(names_in, said(b))) - {"!"}
                    plain = not free and b[4] is None and here[4] is None
                    need(plain and said(b) == said(here) and b[2] == here[2], f"the family {e[1]} has another domain")
                    continue
                self.number_defined(e, known)
                if b[2]:
                    self.show_whole(e)
                    self.show(e, NOT_NEGATIVE, known)
        return m

    def rule_induction(self, goal, s, known):
        need(goal[0] == "all" and len(goal[1]) == 1, ONE_VARIABLE)
        (_, names, natural, limits, indices), = goal[1]
        (n, index), *more = names
        need(not more and index is None and natural and len(limits) < 2, "induction is on one natural variable")
        need(not self.is_declared(n), f"the name {n} is in use")
        first = num(0)
        for c in limits:
            first = c[2]
            digits = first[0] == "num" and first[1].isdigit()
            need(c[:2] == ("relation", ">=") and digits, "the bound of an induction is a numeral")
        advance = N("imp", goal[2], put(goal[2], {n: plus(N("name", n), num(1))}, None))
        for label, p in zip(s.sources, (put(goal[2], {n: first}), N("all", goal[1], advance))):
            need(same(self.fact(label), p), f"needs {text(p)}")

    def rule_existence(self, goal, s, known):
        some, every = map(self.fact, s.sources)
        need(every[0] == "all" and every[2][0] == "imp", "`for all …: P => Q` is needed")
        need(all(i is None for b in every[1] for _, i in b[1]), "families are declared by the claim only")
        need(not {n for b in every[1] for n, _ in b[1]} & mentioned(goal), "what is concluded speaks of what exists")
        needed = N("exists", every[1], every[2][1])
        need(same(every[2][2], goal), f"the fact says {text(every[2][2])}")
        need(same(some, needed), f"needs {text(needed)}")

    def rule_witness(self, goal, s, known):
        need(goal[0] == "exists", "`exists` is needed")
        need(all(i is None for b in goal[1] for _, i in b[1]), "families are declared by the claim only")
        need(len(s.values) == sum(len(b[1]) for b in goal[1]), ONE_VALUE)
        m = self.values(goal[1], s.values, known)
        for p in domain(goal[1]) + [goal[2]]:
            self.holds(put(p, m), s, known)

    def rule_extremum(self, goal, s, known):
        need(goal[0] == "extremum", "an extremum is needed")
        _, word, only, of, over, at, value = goal
        names, m = [n for b in over for n, _ in b[1]], dict(at)
        free = names_in(value).union(*(names_in(e) for _, e in at))
        need(sorted(names) == sorted(n for n, _ in at) == sorted(set(names)) and not free & set(names) and
             not any(b[2] or i is not None for b in over for _, i in b[1]),
             "an extremum is over real variables, with a value for each")
        for _, e in at:
            self.number_defined(e, known)
        there = [compare(N("name", n), "=", e) for n, e in at]
        there = there[0] if len(there) == 1 else N("and", tuple(there))
        parts = [put(p, m) for p in domain(over)] + [compare(put(of, m), "=", value)]
        parts.append(N("all", over, compare(of, "<=" if word == "maximum" else ">=", value)))
        if only:
            parts.append(N("all", over, N("imp", compare(of, "=", value), there)))
        for p in parts:
            self.holds(p, s, known)

    def difference(self, p, known):
        a, relation, b = single(p)
        return self.read(a, known.equations) - self.read(b, known.equations), SIGNS[relation]

    def rule_combination(self, goal, s, known):
        self.has_value(goal, known)
        a, relation, b = single(goal)
        x = self.value(a, known.equations)
        if not isinstance(x, F):
            need(relation == "=" and not s.terms and s.times is None, "the signs do not show this")
            for row, other in zip(x, self.value(b, known.equations)):
                for f, g in zip(row, other):
                    need(self.signs(f - g, known) == 2, "the signs do not show this")
            return
        difference, wanted = self.difference(goal, known)
        if not s.terms and s.times is None:
            signs = self.signs(difference, known) & self.signs(self.read(a) - self.read(b), known)
            return need(not signs & ~wanted, "the signs do not show this")
        times = ONE
        if s.times is not None:
            self.defined(s.times, known)
            times = self.read(s.times, known.equations)
        signs, summands = 2, [-(times * difference)]
        for facts, e in s.terms:
            self.defined(e, known)
            summand = self.read(e, known.equations)
            part = self.signs(self.read(e), known) & self.signs(summand, known)
            for label in facts:
                f, relation = self.difference(self.fact(label), known)
                summand, part = summand * f, TIMES[part][relation]
            signs = PLUS[signs][part]
            summands.append(summand)
        need(not total(summands).c, "the two sides of the identity differ")
        divisor = self.signs(times, known)
        need(not divisor & 2, "the multiplier may be 0")
        need(not TIMES[signs][divisor] & ~wanted, "the signs do not show this")

    def rule_power(self, goal, s, known):
        self.has_value(goal, known)
        a, relation, b = single(goal)
        need(relation == "=", "an equation is needed")
        a, b = self.read(a, known.equations), self.read(b, known.equations)
        if not self.expanded_logarithms(a - b, known).c:
            return
        why = "the powers on both sides are not shown to be the same"
        bases, logs = {}, []

        def collect(f, e, whole, side):
            """Whether f is the opposite of the product of what is collected."""
            c, factors = self.turned(f, known)
            for p, k in primes(abs(c)):
                bases.setdefault(F(p), []).append((e * F(k), whole, side))
            for p, k in factors:
                (a, _), exponent = p.single() or (None, 1), e * F(k)
                inner = self.atoms[a] if a is not None else (None,)
                if inner[0] == "power":
                    need(not collect(inner[1], exponent * inner[2], whole and self.is_whole(inner[2]), side), why)
                elif inner[0] == "exp":
                    logs.append(exponent * inner[1] * F(side))
                else:
                    bases.setdefault(p, []).append((exponent, whole, side))
            return c < 0

        need(a.c and b.c and collect(a, ONE, True, 1) == collect(b, ONE, True, -1), why)
        for base, places in bases.items():
            balance, signs = total([e * F(side) for e, _, side in places]), self.signs(base, known)
            if not signs & ~POSITIVE:
                logs.append(balance * atom(self.intern(("ln", base))))
                continue
            exponents = [self.signs(e, known) for e, _, _ in places]
            whole = all(w for _, w, _ in places) and (not signs & 2 or not any(e & 1 for e in exponents))
            both = len({side for _, _, side in places}) == 2
            root = both and not signs & 1 and not any(e & ~POSITIVE for e in exponents)
            need(not balance.c and (whole or root), why)
        need(not self.expanded_logarithms(total(logs), known).c, why)

    def expanded_logarithms(self, f, known):
        for a in f.atoms():
            if self.atoms[a][0] == "ln":
                value = self.logarithm_of(self.atoms[a][1], known)
                if value != atom(a):
                    f = self.replaced_all(f, [(a, value, None)])
        return f

    def turned(self, f, known):
        """A number and the factors of f, with -p for each factor p <= 0 that is not known to be 0: p^k is (-1)^k * (-p)^k. A power stays."""
        c, factors = f.c, []
        for p, k in f.factors.items():
            p = F(1, {p: 1})
            inner = self.atoms[p.single()[0]] if p.single() else (None,)
            signs = self.signs(p, known)
            if inner[0] != "power" and not signs & ~3 and signs != 2:
                p, c = p * F(-1), c * (-1) ** abs(k)
            factors.append((p, k))
        return c, factors

    def logarithm_of(self, x, known):
        """ln of a product of factors of known sign as a sum."""
        c, factors = self.turned(x, known)
        if c <= 0 or any(self.signs(p, known) & ~POSITIVE for p, _ in factors):
            return atom(self.intern(("ln", x)))
        terms = [atom(self.intern(("ln", F(p)))) * F(k) for p, k in primes(c)]
        for p, k in factors:
            inner = self.atoms[p.single()[0]] if p.single() else (None,)
            if inner[0] == "exp":
                log = inner[1]
            elif inner[0] == "power":
                log = self.logarithm_of(inner[1], known) * inner[2]
            else:
                log = atom(self.intern(("ln", p)))
            terms.append(log * F(k))
        return total(terms)

    def rule_monotone(self, goal, s, known):
        self.has_value(goal, known)
        fact = self.fact(s.sources[0])
        def raised(low, high):
            (a, r, b), (c, q, d) = single(low), single(high)
            c, d = as_power(c), as_power(d)
            return c and d and r == q and same(c[1], d[1]) and same(c[0], a) and same(d[0], b) and (a, b, c[1])
        found = raised(fact, goal) or raised(goal, fact)
        need(found, "these are not powers of the fact's sides with one exponent, nor the other way round")
        for e, signs in zip(found, (NOT_NEGATIVE, NOT_NEGATIVE, POSITIVE)):
            self.show(e, signs, known)

    def rule_unfold(self, goal, s, known):
        self.has_value(goal, known)
        left, relation, right = single(goal)
        need(relation == "=", "an equation is needed")
        if left[0] == "call":
            need(left[1] in self.sequences, "a member of a sequence, a sum or a product is needed")
            _, initial, k, step = self.sequences[left[1]]
            before = plus(left[2][0], num(1), -1)
            candidates = [initial]
            if self.read(left[2][0]).c:
                self.show(before, NOT_NEGATIVE, known)
                candidates = [put(step, {k: before})]
        else:
            need(left[0] == "over", "a member of a sequence, a sum or a product is needed")
            _, kind, i, low, high, body = left
            room, is_sum = total([self.read(high), ONE, -self.read(low)]), kind == "sum"
            candidates = [num(0 if is_sum else 1)]
            if room.c:
                self.in_range(left, [room - ONE], known)
                join = lambda rest, e: plus(rest, e) if is_sum else N("prod", (("*", rest), ("*", e)))
                candidates = [join(N("over", kind, i, low, plus(high, num(1), -1), body), put(body, {i: high})),
                              join(N("over", kind, i, plus(low, num(1)), high, body), put(body, {i: low}))]
        need(any(not (self.read(e) - self.read(right)).c for e in candidates), "this is not what the definition says")

    def rule_termwise(self, goal, s, known):
        self.has_value(goal, known)
        fact, (left, relation, right) = self.fact(s.sources[0]), single(goal)
        why = "two sums or products over one range are needed, and a fact for all of it"
        need(fact[0] == "all" and len(fact[1]) == 1 and len(fact[1][0][1]) == 1, ONE_VARIABLE)
        (binding,), body = fact[1:]
        need(left[0] == right[0] == "over" and left[1] == right[1], why)
        need(relation in (("=", "<=", ">=") if left[1] == "sum" else ("=",)), why)
        low, high = self.read(left[3]), self.read(left[4])
        need(not (low - self.read(right[3])).c and not (high - self.read(right[4])).c, why)
        at = lambda n, x: put(x, {n: N("name", "!")})
        n = binding[1][0][0]
        members = compare(at(left[2], left[5]), relation, at(right[2], right[5]))
        need(same(at(n, body), members), "needs the comparison of the members")
        def inside():
            for p in constraints(binding, N("name", n)):
                f, wanted = self.difference(p, known)
                need(not self.signs(f, known) & ~wanted, why)
        self.at_index(n, low, high, known, inside)

    def rule_mean(self, goal, s, known):
        self.has_value(goal, known)
        given = dict(s.values)
        need(sorted(n for n, _ in s.values) == ["a", "b", "p"], ONE_VALUE)
        a, b, p = given["a"], given["b"], given["p"]
        q = plus(num(1), p, -1)
        left = N("prod", (("*", N("pow", a, q)), ("*", N("pow", b, p))))
        right = plus(N("prod", (("*", q), ("*", a))), N("prod", (("*", p), ("*", b))))
        strict = same(goal, compare(left, "<", right))
        weak, weight = compare(left, "<=", right), POSITIVE if strict else NOT_NEGATIVE
        need(strict or same(goal, weak), f"with these values it says {text(weak)}")
        for e, signs in ((a, POSITIVE), (b, POSITIVE), (p, weight), (q, weight)):
            self.show(e, signs, known)
        if strict:
            need(self.has(plus(a, b, -1), NOT_ZERO, known), f"needs {text(compare(a, '!=', b))}")
        self.rests_on.add(LEMMA)

    def rule_tangent(self, goal, s, known):
        self.has_value(goal, known)
        need([n for n, _ in s.values] == ["x"], ONE_VALUE)
        (_, x), = s.values
        says = lambda relation: compare(plus(num(1), x), relation, N("call", "exp", (x,)))
        strict = same(goal, says("<"))
        need(strict or same(goal, says("<=")), f"with these values it says {text(says('<='))}")
        if strict:
            need(self.has(x, NOT_ZERO, known), f"needs {text(compare(x, '!=', num(0)))}")
        self.rests_on.add(TANGENT)

    def rule_circle(self, goal, s, known):
        """Sound: (cos u, sin u) is a point of the unit circle. u − sin u rises strictly from 0 on, sin u − u·cos u up to π, and
        (cos u + i·sin u)^k is cos(k·u) + i·sin(k·u)."""
        self.has_value(goal, known)
        need([n for n, _ in s.values] == ["u"], ONE_VALUE)
        (_, u), = s.values
        self.number_defined(u, known)
        functions = cos, sin = [N("call", f, (u,)) for f in ("cos", "sin")]
        squares = N("sum", tuple((1, N("pow", f, num(2))) for f in functions))
        on_circle = compare(squares, "=", num(1))
        ends = [compare(f, r, e) for f in functions for r, e in (("<=", num(1)), (">=", N("neg", num(1))))]
        if any(same(goal, p) for p in [on_circle, *ends]):
            return
        a, relation, b = single(goal)
        if same(goal, compare(sin, relation, u)) and relation in ("<", "<="):
            return self.show(u, POSITIVE if relation == "<" else NOT_NEGATIVE, known)
        pi = N("name", PI)
        line = N("prod", (("*", u), ("*", cos)))
        if same(goal, compare(line, relation, sin)) and relation in ("<", "<=") and not self.is_declared(PI):
            for e in (u, plus(pi, u, -1)):
                self.show(e, POSITIVE if relation == "<" else NOT_NEGATIVE, known)
            return
        need(relation == "=" and a[0] == "call" and a[1] in ("cos", "sin"), f"with these values it says {text(on_circle)}")
        of, whole, said = self.read(u), self.read(a[2][0]), self.read(b)
        k = (whole * of.power(-1)).integer
        need(k is not None and 0 <= k <= circle.MULTIPLE_LIMIT, f"{text(a[2][0])} is no small multiple of {text(u)}")
        value = multiple(self.point(of), k)[a[1] == "sin"]
        need(not (value - said).c, "the two sides of the identity differ")

    def rule_arc(self, goal, s, known):
        """Sound: arcsin and arctan rise strictly, arccos falls. A number Y strictly between −3·π/2 and 3·π/2 lies between −π/2
        and π/2 where its cosine is not negative, and strictly where it is positive. There Y is the arcsin of its sine, or the
        arctan of its tangent."""
        self.has_value(goal, known)
        (left, relation, right), why = single(goal), "this is no comparison of two arcs, and no equation for an arc"
        arcs = [e[1] if e[0] == "call" and e[1] in ("arcsin", "arccos", "arctan") else None for e in (left, right)]
        need(arcs[0], why)
        if arcs[0] == arcs[1]:
            ends = [e[2][0] for e in ((left, right) if arcs[0] != "arccos" else (right, left))]
            if self.has(plus(*ends, -1), SIGNS[relation], known):
                return
            need(relation == "=" and arcs[0] != "arccos", f"needs {text(compare(ends[0], relation, ends[1]))}")
        need(relation == "=" and arcs[0] != "arccos", why)
        of, (cos, sin) = left[2][0], [N("call", f, (right,)) for f in ("cos", "sin")]
        line = of if arcs[0] == "arcsin" else N("prod", (("*", of), ("*", cos)))
        need(self.has(plus(sin, line, -1), SIGNS["="], known), f"needs {text(compare(sin, '=', line))}")
        self.show(cos, NOT_NEGATIVE if arcs[0] == "arcsin" else POSITIVE, known)
        for side in (-1, 1):
            need(self.within_three_quarters(right, side, known), f"{text(right)} is not shown to be less than 3/4 of a turn")

    def within_three_quarters(self, e, side, known):
        """Whether 3·π/2 + e is positive, or 3·π/2 − e for the side −1. π is the number, whatever has its name."""
        ends = atom(self.intern(("pi",))) * F(Q(3, 2))
        found = self.fraction_signs(total([ends, self.read(e) * F(side)]), known, {})
        if known.equations:
            ends = self.replaced_all(ends, known.equations)
            found &= self.fraction_signs(total([ends, self.read(e, known.equations) * F(side)]), known, {})
        return not found & ~POSITIVE

    def rule_slope(self, goal, s, known):
        self.has_value(goal, known)
        fact, s, relation = self.fact(s.sources[0]), s._replace(sources=s.sources[1:]), single(goal)[1]
        need(fact[0] == "all" and len(fact[1]) == 1 and len(fact[1][0][1]) == 1, ONE_VARIABLE)
        t, limits = on_an_interval(fact[1][0])
        derivative, slope, f = single(fact[2])
        need(derivative[0] == "deriv" and derivative[2] == (t,), "a fact `for all t …: derivative(F, t) relation f` is needed")
        a, b = self.two_points(s, known)
        of = derivative[1]
        at_a, at_b = (put(of, {t: e}) for e in (a, b))
        says = compare(plus(at_b, at_a, -1), relation, N("integral", "integral", t, a, b, f))
        needed = [of, f]
        if f == num(0) and not same(goal, says):
            says, needed = compare(at_b, relation, at_a), [of]
        need(same(goal, says), f"with these values it says {text(says)}")
        self.within((real(t, limits),), known, lambda inner: self.number_defined(derivative, inner))
        self.domain_with(with_ends(t, limits), (a, b), needed, s, known)
        signs = TIMES[self.signs(self.read(plus(b, a, -1)), known)][SIGNS[slope]]
        need(not signs & ~SIGNS[relation], "the signs do not show this")
        self.rests_on.add(MEAN_VALUE)

    def two_points(self, s, known):
        """The values for a and b, and for nothing else."""
        need(sorted(n for n, _ in s.values) == ["a", "b"], ONE_VALUE)
        points = [dict(s.values)[n] for n in "ab"]
        for e in points:
            self.number_defined(e, known)
        return points

    def domain_with(self, domains, points, needed, s, known):
        """The first of these domains of one variable in which the points lie and the expressions needed have values."""
        for domain_of in domains:
            try:
                for e in points:
                    for p in constraints(domain_of, e):
                        self.holds(p, s, known)
                self.within((domain_of,), known, lambda inner: [self.number_defined(e, inner) for e in needed])
                return domain_of
            except Refused:
                if domain_of is domains[-1]:
                    raise

    def rule_intermediate(self, goal, s, known):
        """An equation has a solution between a number where its left side is not above the right one and a number where it is
        not below. The difference of the sides has values on an interval in which both numbers lie, and a derivative inside.
        So it is continuous there. If the interval has ends that the domain leaves out, the difference is not 0 at the two
        numbers. Then the solution lies strictly between them, in the domain."""
        self.has_value(goal, known)
        need(goal[0] == "exists" and len(goal[1]) == 1 and len(goal[1][0][1]) == 1, "`exists` with one variable is needed")
        x, limits = on_an_interval(goal[1][0])
        left, relation, right = single(goal[2])
        need(relation == "=", "an equation is needed")
        points, found = self.two_points(s, known), []
        for label, e, relations in zip(s.sources, points, (("<", "<=", "="), (">", ">=", "="))):
            said, at_e = self.fact(label), [compare(put(left, {x: e}), r, put(right, {x: e})) for r in relations]
            need(any(same(said, p) for p in at_e), f"needs {text(at_e[1])}")
            found.append(single(said)[1])
        s, difference, domains = s._replace(sources=s.sources[2:]), plus(left, right, -1), with_ends(x, limits)
        shown = self.domain_with(domains, points, [difference], s, known)
        need(shown is domains[0] or found == ["<", ">"], "an end that does not belong to the domain may be the only solution")
        derivative = N("deriv", difference, (x,))
        self.within((without_ends(x, limits),), known, lambda inner: self.number_defined(derivative, inner))
        self.rests_on.add(INTERMEDIATE_VALUE)

    def grows(self, goal):
        """The number of the variable that grows in a limit."""
        need(goal[0] == "limit", "a limit is needed")
        v = goal[2]
        need(v in self.scope, f"{v} is not declared here")
        for _, initial, k, step in self.sequences.values():
            need(v not in names_in(initial) | names_in(step) - {k}, f"{v} is tied to something else")
        return self.is_natural(self.scope[v])

    def rule_limit(self, goal, s, known):
        denied, goal = goal[0] == "not", goal[1] if goal[0] == "not" else goal
        natural = self.grows(goal)
        x = self.variable(goal[2], natural)
        known = known.copy()
        if s.values:
            (word, e), = s.values[:1]
            need(len(s.values) == 1 and word == "from" and e[0] == "num", "`with from = NUMERAL` is needed")
            least = F(Q(e[1]))
            self.learn_signs(atom(x) - least, NOT_NEGATIVE, known)
            self.learn_signs(atom(x), PLUS[NOT_NEGATIVE][sign(least.c)], known)
        if natural:
            self.learn_for_all(x, known, True)
        def run():
            for e in (goal[1], goal[3]):
                self.defined(e, known)
            f, value = self.read(goal[1]), self.read(goal[3])
            top, bottom = (coefficients(p.expanded(), self.exponents(x)) for p in f.parts())
            for p in [*top.values(), *bottom.values(), value]:
                need(x not in self.free_in(p), "a quotient of sums of powers of the variable that grows is needed")
            degree = max(bottom)
            need(not self.signs(bottom[degree], known) & 2, "the leading coefficient of the divisor may be 0")
            grows, quotient = max(top, default=degree) > degree, top.get(degree, ZERO) * bottom[degree].power(-1)
            if denied:
                apart = top[max(top)] if grows else quotient - value
                return need(not self.signs(apart, known) & 2, "the limit is another")
            need(not grows and not (quotient - value).c, "the limit is another")
        self.inside({goal[2]: x}, run)

    def rule_squeeze(self, goal, s, known):
        natural = self.grows(goal)
        lower, upper, lower_limit, upper_limit = map(self.fact, s.sources)
        at = lambda n, x: put(x, {n: N("name", "!")})
        for bound, limit, below in ((lower, lower_limit, True), (upper, upper_limit, False)):
            need(limit[0] == "limit", "a limit is needed")
            need(limit[2] == goal[2] and same(limit[3], goal[3]), "the limit is another")
            need(bound[0] == "all" and len(bound[1]) == 1 and len(bound[1][0][1]) == 1, ONE_VARIABLE)
            (_, ((n, index),), over_naturals, limits, _), = bound[1]
            unbounded = not limits or len(limits) == 1 and limits[0][0] == "relation" and limits[0][1] in (">", ">=")
            unbounded = unbounded and not (limits and {n, goal[2]} & names_in(limits[0][2]))
            need(unbounded and index is None, "the bound does not hold for all large values")
            need(natural or not over_naturals, "the bound holds for natural numbers only")
            a, f = at(goal[2], limit[1]), at(goal[2], goal[1])
            expected = compare(a, "<=", f) if below else compare(f, "<=", a)
            need(same(at(n, bound[2]), expected), f"needs {text(expected)}")

    def rule_along(self, goal, s, known):
        """The limit of F as x grows from that of F with exp(y) for x as y grows: ln(x) grows without bound, and x is its exponential.
        What holds for all great real numbers holds for the natural ones."""
        self.grows(goal)
        fact = self.fact(s.sources[0])
        need(not self.grows(fact), "the bound holds for natural numbers only")
        x, y = goal[2], fact[2]
        need(not {x, y} & names_in(goal[3]) and same(goal[3], fact[3]), "the limit is another")
        need(x == y or y not in names_in(goal[1]), "the limit is another")
        need(same(put(goal[1], {x: N("call", "exp", (N("name", y),))}), fact[1]), "the limit is another")

    def rule_eventually(self, goal, s, known):
        """`exists N …: for all k …: CHAIN` from the limit L of G as v grows. Each comparison of the chain is one of G, with k for
        v, and of an expression c.

        Sound: c and L mention neither N nor k, and L not the v that grows. So they are fixed numbers, the same inside as here.
        They differ, on the side that the comparison says. From a number on, G is nearer to L than every c is, so all comparisons
        hold. N is a number above that one and above its own bounds, which are lower ones and do not move with it. What holds for
        all great real numbers holds for the natural ones. G has values there, since the statement has one."""
        fact = self.fact(s.sources[0])
        natural = self.grows(fact)
        _, of, v, limit = fact
        need(goal[0] == "exists" and len(goal[1]) == 1 and len(goal[1][0][1]) == 1, "`exists` with one variable is needed")
        every = goal[2]
        need(every[0] == "all" and len(every[1]) == 1 and len(every[1][0][1]) == 1, ONE_VARIABLE)
        (_, ((start, family),), _, limits, _), = goal[1]
        (_, ((k, index),), over_naturals, bounds, _), = every[1]
        need(family is None and index is None, "families are declared by the claim only")
        own, why = {start, k}, "the bound does not hold for all large values"
        need(all(c[0] == "relation" and c[1] in (">", ">=") and not own & names_in(c[2]) for c in limits), why)
        need(len(bounds) == 1 and bounds[0] in [("relation", r, N("name", start)) for r in (">", ">=")], why)
        need(over_naturals or not natural, why)
        need(not own & names_in(fact) and v not in names_in(limit), "the limit is another")
        need(every[2][0] == "cmp", "a single comparison is needed, not a chain")
        at = lambda n, x: put(x, {n: N("name", "!")})
        grows, strict = at(v, of), {"<=": "<", ">=": ">"}
        for a, r, b in zip(every[2][1], every[2][2], every[2][1][1:]):
            need(r != "=", "the signs do not show this")
            left, right = (same(at(k, e), grows) for e in (a, b))
            need(left != right and not own & names_in(b if left else a), "the limit is another")
            a, b, r = limit if left else a, limit if right else b, strict.get(r, r)
            need(self.has(plus(a, b, -1), SIGNS[r], known), f"needs {text(compare(a, r, b))}")
        self.has_value(goal, known)

    def rule_name(self, goal, s, known):
        e, relation, new = single(goal)
        need(relation == "=" and new[0] == "name", "the right side must be a new name")
        self.number_defined(e, known)
        claim = self.claim
        used = words((claim.given, claim.sequences, claim.assumptions, claim.goal, [b[1] for b in self.blocks]))
        need(new[1] not in used and not self.is_declared(new[1]) and new[1] != PI, f"the name {new[1]} is in use")
        self.scope[new[1]] = self.variable(new[1], False)

    def rule_evaluate(self, goal, s, known):
        evaluate(self, goal, [self.fact(label) for label in s.using])

    def rule_integer(self, goal, s, known):
        self.has_value(goal, known)
        (f, relation), (g, claimed) = self.difference(self.fact(s.sources[0]), known), self.difference(goal, known)
        need(relation in (1, 4) and claimed in (3, 6), "`<` or `>` is needed, and `<=` or `>=` as the conclusion")
        f, g = f if relation == 4 else -f, g if claimed == 6 else -g
        self.whole(f)
        need(not (f - ONE - g).c, "the two sides of the identity differ")


def words(x):
    return {x} if isinstance(x, str) else set().union(*map(words, x)) if isinstance(x, (tuple, list)) else set()


# --------------------------------------------------------------------------------------------------- certificates
Step = collections.namedtuple("Step", "label rule goal sources by using values times terms")
# How many facts stand behind `from`, at least and at most.
COUNTS = {"suppose": (0, 0), "let": (0, 0), "logic": (0, 999), "instance": (1, 999), "induction": (2, 2),
          "existence": (2, 2), "witness": (0, 999), "extremum": (0, 999), "combination": (0, 0), "name": (0, 0), "power": (0, 0),
          "monotone": (1, 1), "unfold": (0, 0), "termwise": (1, 1), "mean": (0, 0), "tangent": (0, 0), "circle": (0, 0),
          "arc": (0, 0),
          "limit": (0, 0), "slope": (1, 999), "intermediate": (2, 999),
          "squeeze": (4, 4), "along": (1, 1), "eventually": (1, 1), "integer": (1, 1), "evaluate": (0, 0)}

WITH = ("instance", "witness", "mean", "tangent", "circle", "slope", "intermediate", "limit")


def expression(source):
    parser = Parser(source)
    return parser.whole(parser.expr)


def steps(lines):
    """The steps after the three lines of the head; a step `end` is its label."""
    labels = lambda t: [(need(re.fullmatch("[A-Za-z0-9]+", w), f"{w!r} is no label"), w)[1] for w in t.split(" ")]
    need(lines and lines[-1] == "qed", "the last line is `qed`")
    out = []
    for line in lines[:-1]:
        line = line.lstrip(" ")
        if line.startswith("end "):
            out.append(labels(line[4:])[0])
        elif line.startswith("| "):
            need(out and isinstance(out[-1], Step), "a step before its fields")
            s, field = out[-1], re.match(r"\| (by|using|with|times|term)\b ?(.*)$", line)
            need(field, f"unknown field: {line}")
            word, rest = field.groups()
            if word in ("by", "using"):
                need(not getattr(s, word), f"the field `{word}` stands twice")
                s = s._replace(**{word: labels(rest)})
            elif word == "with":
                name, _, value = rest.partition(" = ")
                need(s.rule in WITH, "`with` is no field of this rule")
                s.values.append((name, expression(value)))
            else:
                need(s.rule == "combination", f"`{word}` is no field of this rule")
                if word == "times":
                    need(s.times is None, "the field `times` stands twice")
                    s = s._replace(times=expression(rest))
                else:
                    facts, _, value = (" " + rest).partition(": ")
                    s.terms.append((labels(facts.strip(" ")) if facts.strip(" ") else [], expression(value)))
            out[-1] = s
        else:
            head, _, goal = line.partition(": ")
            label, rule, *sources = head.split(" ") + [""] * (" " not in head)
            need(rule in COUNTS and sources[:1] in ([], ["from"]), f"unknown rule: {head}")
            sources = sources[1:]
            least, most = COUNTS[rule]
            need(least <= len(sources) <= most, f"the rule {rule} reads another number of facts behind `from`")
            parser = Parser(goal)
            out.append(Step(labels(label)[0], rule, parser.whole(parser.proposition), sources, [], [], [], None, []))
    return out


def stated(claim, lines):
    """The statement that steps show, and how many lines in front of them say where and how the claim is false."""
    lines = [line.lstrip(" ") for line in lines]
    if lines[:1] != ["refutes"]:
        return claim, 0
    places = list(itertools.takewhile(lambda line: line.startswith("at ") and ": " not in line, lines[1:]))
    point = [line[3:].partition(" = ") for line in places]
    undefined = [line[10:] for line in lines[len(places) + 1:][:1] if line.startswith("undefined ") and ": " not in line]
    point = [(expression(place), expression(value)) for place, _, value in point]
    claim = refutation.of(claim, point, *map(expression, undefined))
    return claim, 1 + len(places) + len(undefined)


def check(claim, source, accepted):
    """What an accepted certificate rests on, and whether it refutes the claim. Refused says why one is not accepted, NotCovered
    that this checker has no room for it."""
    lines = source.split("\n")
    lines = lines[:-1] if lines[-1] == "" else lines
    where = "head"
    try:
        claim, places = stated(claim, lines[3:])
        digest = hashlib.sha256(claim.text().encode()).hexdigest()
        need(lines[:2] == ["carom-certificate 2", f"claim {claim.name}"], "it is no certificate of this claim in format 2")
        need(lines[2:3] == [f"statement sha256 {digest}"], "the digest is of another statement than this checker reads")
        where = "statement"
        checker = Checker(claim, accepted)
        for s in steps(lines[3 + places:]):
            where = f"step {s.label} ({s.rule})" if isinstance(s, Step) else f"end {s}"
            checker.step(s) if isinstance(s, Step) else checker.end(s)
        where = "qed"
        checker.finish()
    except (Refused, NotCovered) as why:
        raise type(why)(f"{where}: {why}")
    except reading.TOO_LARGE as fault:
        raise NotCovered(f"{where}: it is too large for this checker: {fault!r}")
    except (ArithmeticError, LookupError, TypeError, AttributeError, ValueError) as fault:
        raise Refused(f"{where}: it makes no sense: {fault!r}")
    return checker.rests_on, places > 0


def files(paths, ending):
    for path in paths:
        inside = [os.path.join(folder, name) for folder, _, names in os.walk(path) for name in sorted(names)]
        for file in [f for f in inside if f.endswith(ending)] if os.path.isdir(path) else [path]:
            with open(file, encoding="utf-8") as stream:
                yield file, stream.read()


class Claims:
    """The claims of files by their names, each read when it is asked for."""

    def __init__(self, paths):
        self.files, self.read, folders = {}, {}, {}
        for path, source in files(paths, ".claim"):
            folder, name = os.path.split(path)
            if folder not in folders:
                shared = os.path.join(folder, "paper.claim")
                folders[folder] = reading.File(next(files([shared], ""))[1]) if os.path.exists(shared) else None
            file = reading.File(source, folders[folder] if name != "paper.claim" else None)
            for claim in file.places:
                need(claim not in self.files, f"{path}: another file has a claim {claim}")
                self.files[claim] = file

    def __contains__(self, name):
        return name in self.files

    def __getitem__(self, name):
        if name not in self.read:
            self.read[name] = self.files[name].claim(name)
        return self.read[name]


def main(arguments):
    if "--" not in arguments:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    split, texts, accepted, open_, done, counts = arguments.index("--"), {}, {}, set(), set(), collections.Counter()
    try:
        claims = Claims(arguments[:split])
        for file, source in files(arguments[split + 1:], ".cert"):
            name = source.split("\n")[1:2]
            name = name[0].removeprefix("claim ") if name else ""
            need(name in claims, f"{file}: no claim {name!r} is given")
            need(name not in texts, f"{file}: the claim {name} has another certificate")
            texts[name] = source
    except (OSError, UnicodeDecodeError, Refused) as fault:
        print(f"check.py: {fault}", file=sys.stderr)
        return 2

    def visit(name):
        if name in done or name not in texts:
            return
        done.add(name)
        missing = []
        try:
            claim = claims[name]
            for cited in claim.using:
                visit(cited)
            missing = [cited for cited in claim.using if cited in open_]
            rests_on, refuted = check(claim, texts[name], accepted)
        except (Refused, NotCovered) as why:
            if missing:
                why = NotCovered(f"it may rest on {', '.join(missing)}, not covered; {why}")
            if isinstance(why, NotCovered):
                open_.add(name)
            kind = "not covered" if name in open_ else "rejected"
            counts[kind] += 1
            print(f"{kind} {name}: {why}")
            return
        if not refuted:
            accepted[name] = claim, rests_on
        counts["refuted" if refuted else "accepted"] += 1
        lemmas = [lemma for lemma in (LEMMA, TANGENT, MEAN_VALUE, INTERMEDIATE_VALUE) if lemma in rests_on]
        print(", by ".join([f"{'refuted' if refuted else 'accepted'} {name}", *lemmas]))

    for name in texts:
        visit(name)
    proofs = sum(source.split("\n")[3:4] != ["refutes"] for source in texts.values())
    print(f"{counts['accepted'] + counts['refuted']} of {len(texts)} certificates accepted")
    print(f"covered by the second checker: {counts['accepted']} of {proofs} proved claims")
    return 1 if counts["rejected"] else 3 if open_ else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
