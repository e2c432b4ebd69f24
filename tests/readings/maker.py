"""The random choices for one claim, and what several kinds of claims are made of."""

import re
from fractions import Fraction

from algebra import number, put, read, show, spoiled

ANGLES = ("theta", "alpha", "beta", "phi", "x")
# Functions of t, smooth where they have a value; k and m stand for small numerals, c for another variable.
POLYNOMIAL = (
    "t^2", "t^3", "k*t^2 + m*t", "(t + k)^2", "t*(k - t)", "t^3 - m*t", "k*t - t^2", "-t^2", "k*t + m", "t^4 - k*t^2",
)  # fmt: skip
SMOOTH = POLYNOMIAL + (
    "1/t", "k/(t + m)", "1/(1 + t^2)", "t/(1 + t^2)", "c*t", "c*t^2 + k", "t^2/(k + t^2)", "k - t", "c/t", "(t + c)^2",
    "m*t + c", "sqrt(t^2 + k)", "1/t^2", "arctan(t)", "arctan(t/k)", "t*arctan(c*t)",
)  # fmt: skip
CIRCULAR = (
    "sin(t)", "cos(t)", "sin(t)^2", "cos(t)^2", "sin(2*t)", "cos(2*t)", "sin(t)*cos(t)", "k*sin(t) + m*cos(t)",
    "cos(3*t)", "sin(t/2)", "cos(t/2)", "sin(t + pi/3)", "cos(t - pi/4)", "1/(k + cos(t))", "sin(t)/(2 + cos(t))",
    "c*cos(t)", "c*sin(t) + cos(t)", "exp(sin(t))", "sqrt(2 + cos(t))", "cos(t/3)", "(c + cos(t))^2", "tan(t)",
    "-cos(t)", "sin(t)^3", "c/(2 + sin(t))", "sin(t/2)^2", "2*sin(t/2)*cos(t/2)", "arctan(sin(t))", "arcsin(cos(t)/2)",
)  # fmt: skip


class Maker:
    """`is_true` says whether the claim is to be true, as far as its kind knows how."""

    def __init__(self, rng):
        self.rng = rng
        self.pick = rng.choice
        self.is_true = rng.random() < 0.5

    def chance(self, p):
        return self.rng.random() < p

    def template(self, texts, name, other=None):
        """A template as an expression of a name, with small numerals and perhaps another variable."""
        fits = [text for text in texts if other or not re.search(r"\bc\b", text)]
        k, m = self.rng.randint(1, 5), self.rng.randint(1, 4)
        values = {"t": ("name", name), "k": number(k), "m": number(m), "c": ("name", other or "c")}
        return put(read(self.pick(fits)), values)

    def said(self, e):
        """The text of an expression, spoiled where the claim is to be false."""
        return show(e if self.is_true else spoiled(e, self.rng))

    def said_or(self, e, *others):
        """The same; a false claim may say one of these instead."""
        return self.pick(others) if not self.is_true and self.chance(0.4) else self.said(e)

    def range(self, name, widest=36):
        """A range for an angle: its clause, its ends in twelfths of π, and whether they are closed."""
        step = self.pick((6, 6, 6, 3, 4, 2, 1))
        low = self.rng.randint(-12 // step, 12 // step) * step if self.chance(0.5) else 0
        high = low + self.rng.randint(1, max(1, widest // step)) * step
        left, right = self.pick("[("), self.pick("])")
        return f"{name} in {left}{turns(low)}, {turns(high)}{right}", low, high, left == "[", right == "]"

    def otherwise(self, clause):
        """A range as it stands under `given`, sometimes as a chain."""
        name, left, low, high, right = re.fullmatch(r"(\w+) in (.)(.*), (.*)(.)", clause).groups()
        if self.chance(0.85):
            return clause
        return f"{low} {'<=' if left == '[' else '<'} {name} {'<=' if right == ']' else '<'} {high}"

    def multiple(self, name):
        """A multiple or a part of an angle."""
        return self.pick(
            (name, name, name, f"2*{name}", f"{name}/2", f"{name}/2", f"3*{name}", f"{name}/3", f"-{name}")
        )

    def through(self, e, name):
        """An expression behind a definition: the clauses, the text to use, and the expression it stands for."""
        text = show(e)
        double = ("*", number(2), e)
        parameter = show(put(e, {name: ("name", "w")}))
        return self.pick(
            (
                ([], text, e),
                ([], text, e),
                ([f"let g = {text}"], "g", e),
                ([f"let g = {text}", "let h = 2*g"], "h", double),
                ([f"let g(w) = {parameter}"], f"g({name})", e),
                ([f"let g(w) = w*({text})"], "g(2)", double),
                ([f"let f = {text}", "let g(w) = f*w"], "g(1)", e),
                ([f"define u by u(0) = {text}, u(k + 1) = u(k)"], f"u({self.rng.randint(0, 2)})", e),
                ([f"define u by u(0) = 1, u(k + 1) = ({text})*u(k)"], "u(1)", e),
                ([f"define u by u(0) = 0, u(k + 1) = u(k) + ({text})"], "u(2)", double),
                (
                    [f"define F by F(0) = 0, F(1) = {text}, F(k + 2) = F(k + 1) + F(k)"],
                    f"F({self.rng.randint(1, 2)})",
                    e,
                ),
                ([f"let A = [{text}, 1; 0, 1]"], "det(A)", e),
                ([f"let A = [{text}, 1; 0, 1]"], "(trace(A) - 1)", e),
            )
        )

    def rewritten(self, text):
        """A text with one numeral, relation, sign or function changed."""
        places = list(re.finditer(r"\d+|<=|>=|(?<= )[-+<>=](?= )|\b(?:sin|cos|max|min|arcsin|arccos|arctan)\b", text))
        if not places:
            return text
        found = self.pick(places)
        old = found.group()
        if old.isdigit():
            new = str(max(0, int(old) + self.pick((1, -1))))
        else:
            swaps = {"+": "-", "-": "+", "<": ">=", ">": "<=", "sin": "cos", "cos": "sin", "max": "min", "min": "max"}
            swaps |= {"arcsin": "arccos", "arccos": "arcsin", "arctan": "arcsin"}
            swaps |= {"<=": self.pick(("<", ">=")), ">=": self.pick((">", "<=")), "=": self.pick(("<=", "!=", "<"))}
            new = swaps[old]
        return text[: found.start()] + new + text[found.end() :]


def given(*clauses):
    """The clause that declares these, if there are any."""
    named = [c for c in clauses if c]
    return ["given " + "; ".join(named)] if named else []


def turns(k):
    """k·π/12 as text."""
    q = Fraction(k) / 12
    if q == 0:
        return "0"
    top = {1: "pi", -1: "-pi"}.get(q.numerator, f"{q.numerator}*pi")
    return top if q.denominator == 1 else f"{top}/{q.denominator}"
