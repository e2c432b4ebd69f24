"""Claim files as trees, as they are written: nothing is expanded, renamed or simplified.

The grammar is that of `docs/language.md`. An expression is a tuple that begins with its kind:

    ("num", text)  ("name", n)  ("call", f, arguments)  ("neg", a)  ("+", a, b) and so for - * / ^
    ("sum", index, from, to, body)  ("product", ...)  ("integral", ...)  ("derivative", body, names)
    ("matrix", rows)

A proposition likewise: `compare`, `and`, `or`, `not`, `=>`, `<=>`, `all`, `exists`, `extremum`, `limit`. Arguments are
not read: they guide a search and change no statement.
"""

import copy
import re
from dataclasses import dataclass, field

CLAUSES = (
    "claim paper text source section number reading note using given let define assume sample prove expect"
).split()
FUNCTIONS = (
    "sqrt cbrt exp ln cosh sinh tanh sech det transpose abs max min factorial binomial trace inverse floor ceil ceiling"
    " sin cos tan arcsin arccos arctan"
).split()
# Words with an index, its range and a body.
FOLDS = ("sum", "product", "integral")
RELATIONS = ("=", "!=", "<", "<=", ">", ">=")
GREEK = dict(zip("αβγδεθλμπρστφψωΔΘΦΨΩ", (
    "alpha beta gamma delta epsilon theta lambda mu pi rho sigma tau phi psi omega Delta Theta Phi Psi Omega"
).split()))  # fmt: skip
SIGNS = {"≤": "<=", "≥": ">=", "≠": "!=", "⇒": "=>", "⇔": "<=>", "·": "*", "×": "*", "−": "-", "→": "->", "…": ".."}
WORDS = {"∞": " infinity ", "∈": " in ", "∧": " and ", "∨": " or ", "¬": " not "}
RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
LOWERED = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
TOKEN = re.compile(
    r'(?P<number>\d+(?:\.(?!\.)\d+)?(?:[eE][+-]?\d+)?)|(?P<word>[A-Za-z][A-Za-z0-9_]*\'*)|(?P<text>"[^"\n]*")'
    r"|(?P<sign><=>|=>|->|<=|>=|!=|\.\.|[-+*/^()\[\]{},;:=<>|!√])"
)


class Unreadable(Exception):
    """The text is no claim file, or uses what this parser does not know."""


@dataclass
class Binding:
    """Names with one domain. A constraint is `(relation, e)`, `("in", low, closed, high, closed)` or `("..", a, b)`."""

    names: list
    kind: str = "real"
    constraints: list = field(default_factory=list)
    indices: tuple = None


@dataclass
class Claim:
    """A claim: its declarations in order, its hypotheses, its goal."""

    name: str
    given: list = field(default_factory=list)
    lets: dict = field(default_factory=dict)
    sequences: dict = field(default_factory=dict)
    hypotheses: list = field(default_factory=list)
    goal: tuple = None
    moving: dict = field(default_factory=dict)

    def declared(self):
        """The names under `given`, without families."""
        return [name for binding in self.given for name, index in binding.names if index is None]


def tokens(text):
    """The tokens as (kind, text, whether it is the first on its line)."""
    out = []
    for line in text.split("\n"):
        line = line.split("#")[0]
        line = re.sub("[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+", lambda m: "^(" + m.group().translate(RAISED) + ")", line).translate(LOWERED)
        for table in (SIGNS, WORDS, GREEK):
            for sign, ascii_form in table.items():
                line = line.replace(sign, ascii_form)
        at, first = 0, True
        while at < len(line):
            if line[at].isspace():
                at += 1
                continue
            match = TOKEN.match(line, at)
            if not match:
                raise Unreadable(f"cannot read {line[at:]!r}")
            out.append((match.lastgroup, match.group(), first))
            at, first = match.end(), False
            # A claim's name may hold dashes.
            if len(out) >= 2 and out[-2][1] == "claim" and out[-2][2]:
                rest = re.match(r"[-\w]*", line[at:]).group()
                out[-1] = ("word", out[-1][1] + rest, False)
                at += len(rest)
    return out + [("end", "", True)]


class Parser:
    """Reads claims, one clause after another."""

    def __init__(self, text):
        self.list, self.at = tokens(text), 0

    # Tokens.

    def peek(self, ahead=0):
        return self.list[min(self.at + ahead, len(self.list) - 1)][1]

    def kind(self, ahead=0):
        return self.list[min(self.at + ahead, len(self.list) - 1)][0]

    def take(self, *wanted):
        if wanted and self.peek() not in wanted:
            raise Unreadable(f"expected {wanted}, found {[t[1] for t in self.list[self.at : self.at + 6]]}")
        self.at += 1
        return self.list[self.at - 1][1]

    def next(self, *words):
        if self.peek() in words and self.kind() != "end":
            self.at += 1
            return True
        return False

    def name(self):
        if self.kind() != "word":
            raise Unreadable(f"expected a name, found {self.peek()!r}")
        return self.take()

    def at_clause(self):
        kind, text, first = self.list[self.at]
        return kind == "end" or first and text in CLAUSES

    def tried(self, read):
        """What a reader returns; nothing, and no token is taken, where it cannot read."""
        start = self.at
        try:
            return read()
        except Unreadable:
            self.at = start
            return None

    # Clauses.

    def claims(self):
        out, preamble = [], Claim("")
        self.growing = {}
        self.clauses(preamble)
        while self.kind() != "end":
            self.take("claim")
            out.append(self.claim(preamble))
        return out

    def clauses(self, claim):
        """Reads clauses up to the next claim."""
        while not (self.at_clause() and self.peek() in ("claim", "text", "")):
            clause = self.take()
            if clause == "given":
                self.given(claim)
            elif clause == "let":
                self.let(claim)
            elif clause == "define":
                self.define(claim)
            elif clause == "assume":
                if self.kind() == "word" and self.peek(1) == ":":
                    self.at += 2
                claim.hypotheses.append(self.prop())
            elif clause == "prove":
                claim.goal = self.prop()
            while not self.at_clause():
                self.at += 1

    def claim(self, preamble):
        """A claim, which begins with what the preamble says."""
        claim = copy.deepcopy(preamble)
        claim.name = self.name()
        self.take()
        self.growing = {}
        self.clauses(claim)
        if claim.goal is None:
            raise Unreadable(f"{claim.name} proves nothing")
        known = set(claim.declared())
        claim.moving = {n: kind for n, kind in self.growing.items() if n not in known}
        return claim

    def given(self, claim):
        known = set(claim.declared()) | set(claim.lets) | set(claim.sequences) | {"pi"}
        known |= {name for binding in claim.given for name, _ in binding.names}
        while True:
            prop = self.tried(lambda: self.relation_given(known - {"pi"}))
            if prop:
                claim.hypotheses.append(prop)
                new = [n for n in sorted(names_in(prop)) if n not in known and n not in FUNCTIONS]
                if new:
                    claim.given.append(Binding([(n, None) for n in new]))
                known.update(new)
            else:
                binding = self.binding()
                claim.given.append(binding)
                known.update(name for name, _ in binding.names)
            if not self.next(";", ",") or self.at_clause():
                return

    def relation_given(self, known):
        """A relation between variables: a chain, or a comparison whose left side is no new name by itself."""
        prop = self.comparison()
        _, sides, relations = prop
        is_new = sides[0][0] == "name" and sides[0][1] not in known
        is_new = is_new or sides[0][0] == "call" and sides[0][1] not in FUNCTIONS
        if len(relations) == 1 and is_new:
            raise Unreadable("a declaration")
        return prop

    def let(self, claim):
        name, parameters = self.name(), []
        if self.next("("):
            parameters = [self.name()]
            while self.next(","):
                parameters.append(self.name())
            self.take(")")
        self.take("=")
        claim.lets[name] = (parameters, self.expr())

    def define(self, claim):
        names = [self.name()]
        while self.next(","):
            names.append(self.name())
        self.take("by")
        found = {name: ({}, []) for name in names}
        while True:
            name = self.name()
            self.take("(")
            index = None if self.kind() == "number" else self.name()
            if index:
                self.take("+")
            shift = int(self.take())
            self.take(")")
            self.take("=")
            value = self.expr()
            if index:
                found[name][1].append((index, shift, value))
            else:
                found[name][0][shift] = value
            if not self.next(","):
                break
        for name, (first, steps) in found.items():
            claim.sequences[name] = (first, steps[0])

    # Declarations.

    def bindings(self):
        out = [self.binding()]
        while self.next(";", ","):
            out.append(self.binding())
        return out

    def binding(self):
        binding = Binding([self.declared()])
        while self.next(","):
            binding.names.append(self.declared())
        said = False
        while True:
            if said:
                self.next("and")
            if self.peek() in ("real", "natural", "integer"):
                kind = self.take()
                binding.kind = kind if kind != "real" else binding.kind
            elif self.peek() in RELATIONS:
                binding.constraints.append((self.take(), self.expr()))
            elif self.next("in"):
                constraint = self.tried(self.interval)
                if not constraint:
                    low = self.expr()
                    self.take("..")
                    constraint = ("..", low, self.expr())
                    binding.kind = "natural"
                binding.constraints.append(constraint)
            else:
                break
            said = True
        if not said:
            raise Unreadable(f"expected a domain, found {self.peek()!r}")
        if self.next("for"):
            self.name()
            self.take("in")
            low = self.expr()
            self.take("..")
            binding.indices = (low, self.expr())
        return binding

    def declared(self):
        name, index = self.name(), None
        if self.next("("):
            index = self.name()
            self.take(")")
        return name, index

    def interval(self):
        low_closed = self.take("[", "(") == "["
        low = self.expr()
        self.take(",")
        high = self.expr()
        return "in", low, low_closed, high, self.take("]", ")") == "]"

    # Propositions.

    def prop(self):
        return self.joined("<=>", self.implication)

    def joined(self, sign, part):
        parts = [part()]
        while self.next(sign):
            parts.append(part())
        return parts[0] if len(parts) == 1 else (sign, parts)

    def implication(self):
        left = self.joined("or", lambda: self.joined("and", self.negation))
        return ("=>", left, self.implication()) if self.next("=>") else left

    def negation(self):
        return ("not", self.negation()) if self.next("not") else self.atomic()

    def atomic(self):
        if self.peek() in ("exists", "for"):
            kind = "exists" if self.take() == "exists" else "all"
            if kind == "all":
                self.take("all", "each")
            bindings = self.bindings()
            self.take(":")
            return kind, bindings, self.prop()
        if self.peek() in ("maximum", "minimum"):
            return self.extremum()
        if self.next("limit"):
            return self.limit()
        compared = self.tried(self.comparison)
        if compared:
            return compared
        self.take("(")
        inner = self.prop()
        self.take(")")
        return inner

    def comparison(self):
        sides, relations = [self.expr()], []
        while self.peek() in RELATIONS:
            relations.append(self.take())
            sides.append(self.expr())
        if not relations:
            raise Unreadable("no comparison")
        return "compare", sides, relations

    def extremum(self):
        kind = self.take()
        self.take("of")
        body = self.expr()
        self.take("over")
        over = self.bindings()
        only, place = self.next("only"), {}
        if self.next("at"):
            while True:
                name = self.name()
                self.take("=")
                place[name] = self.expr()
                if not self.next(","):
                    break
        self.take("is")
        return "extremum", kind == "maximum", body, over, only, place, self.expr()

    def limit(self):
        """The body, the variable, whether it is natural, the point or None, the signs of the sides, the value.

        The value may be "infinity" or "-infinity".
        """
        self.take("of")
        body = self.expr()
        self.take("as")
        variable = self.name()
        said = self.take() if self.peek() in ("natural", "real") else None
        self.growing.setdefault(variable, said or "real")
        self.take("->")
        point, sides = None, (1,)
        if not self.next("infinity"):
            point, sides = self.expr(), (1, -1)
            if self.next("from"):
                sides = (1,) if self.take("above", "below") == "above" else (-1,)
        self.take("is")
        if self.peek() == "-" and self.peek(1) == "infinity":
            self.at += 2
            value = "-infinity"
        else:
            value = self.take() if self.peek() == "infinity" else self.expr()
        return "limit", body, variable, said == "natural", point, sides, value

    # Expressions.

    def expr(self):
        out = self.signed()
        while self.peek() in ("+", "-"):
            out = (self.take(), out, self.product())
        return out

    def signed(self):
        return ("neg", self.signed()) if self.next("-") else self.product()

    def product(self):
        out = self.power()
        while self.peek() in ("*", "/"):
            out = (self.take(), out, self.signed_power())
        return out

    def signed_power(self):
        return ("neg", self.signed_power()) if self.next("-") else self.power()

    def power(self):
        base = self.atom()
        if self.next("!"):
            base = ("call", "factorial", [base])
        return ("^", base, self.signed_power()) if self.next("^") else base

    def atom(self):
        kind, text = self.kind(), self.peek()
        if kind == "number":
            return "num", self.take()
        if self.next("("):
            inner = self.expr()
            self.take(")")
            return inner
        if self.next("|"):
            inner = self.expr()
            self.take("|")
            return "call", "abs", [inner]
        if self.next("√"):
            return "call", "sqrt", [self.atom()]
        if self.next("["):
            rows = [[self.expr()]]
            while self.peek() in (",", ";"):
                if self.take() == ";":
                    rows.append([])
                rows[-1].append(self.expr())
            self.take("]")
            return "matrix", rows
        if kind != "word" or text in (
            "is",
            "and",
            "or",
            "infinity",
            "exists",
            "for",
            "limit",
            "maximum",
            "minimum",
            "not",
        ):
            raise Unreadable(f"expected an expression, found {text!r}")
        self.take()
        if text in FOLDS and self.next("("):
            index = self.name()
            self.take("=")
            low = self.expr()
            self.take("..")
            high = self.expr()
            self.take(",")
            body = self.expr()
            self.take(")")
            return text, index, low, high, body
        if text == "derivative" and self.next("("):
            body, names = self.expr(), []
            while self.next(","):
                names.append(self.name())
            self.take(")")
            return "derivative", body, names
        if self.next("("):
            arguments = [self.expr()]
            while self.next(","):
                arguments.append(self.expr())
            self.take(")")
            return "call", text, arguments
        return "name", text


def parts(tree):
    """The trees directly within a tree, be it an expression or a proposition."""
    for part in tree[1:]:
        if isinstance(part, tuple) and part and isinstance(part[0], str):
            yield part
        elif isinstance(part, list):
            for item in part:
                if isinstance(item, tuple):
                    yield item
                elif isinstance(item, list):
                    yield from item
                elif isinstance(item, Binding):
                    yield from within(item)
        elif isinstance(part, dict):
            yield from part.values()


def within(binding):
    """The expressions in a binding."""
    for constraint in binding.constraints:
        yield from (part for part in constraint[1:] if isinstance(part, tuple))
    yield from binding.indices or ()


def names_in(tree):
    """Every name that occurs, bound ones and functions included."""
    out = set()
    if tree[0] == "name":
        out.add(tree[1])
    elif tree[0] == "call":
        out.add(tree[1])
    elif tree[0] == "derivative":
        out.update(tree[2])
    for part in parts(tree):
        out |= names_in(part)
    return out


def parse(text):
    """The claims of a text; raises `Unreadable`."""
    return Parser(text).claims()
