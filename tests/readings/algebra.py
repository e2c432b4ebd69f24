"""Expressions for random claims: read from templates, put into each other, differentiated, written as text.

The rules of differentiation here are those of a textbook. The evaluator has its own way, by numbers with derivatives,
so that a mistake in either shows as a difference.
"""

from parse import FOLDS, Parser

LEVELS = {"+": 1, "-": 1, "*": 2, "/": 2, "neg": 1.5, "^": 3}


def read(text):
    """The expression of a text."""
    parser = Parser(text)
    out = parser.expr()
    if parser.kind() != "end":
        raise ValueError(text)
    return out


def show(e, level=0):
    """An expression as text, with the parentheses that it needs."""
    kind = e[0]
    if kind in ("num", "name"):
        return e[1]
    if kind == "call":
        return f"{e[1]}({', '.join(show(a) for a in e[2])})"
    if kind in FOLDS:
        return f"{kind}({e[1]} = {show(e[2])}..{show(e[3])}, {show(e[4])})"
    if kind == "derivative":
        return f"derivative({show(e[1])}, {', '.join(e[2])})"
    if kind == "matrix":
        return "[" + "; ".join(", ".join(show(entry) for entry in row) for row in e[1]) + "]"
    own = LEVELS[kind]
    if kind == "neg":
        out = "-" + show(e[1], 2)
    elif kind == "^":
        out = f"{show(e[1], 4)}^{show(e[2], 4)}"
    else:
        sign = f" {kind} " if own == 1 else kind
        out = show(e[1], own) + sign + show(e[2], own + 1)
    return f"({out})" if own < level else out


def put(e, values):
    """An expression with expressions put for names."""
    kind = e[0]
    if kind == "name":
        return values.get(e[1], e)
    if kind == "num":
        return e
    if kind == "call":
        return kind, e[1], [put(a, values) for a in e[2]]
    if kind in FOLDS:
        return kind, e[1], *(put(part, values) for part in e[2:])
    if kind == "derivative":
        return kind, put(e[1], values), e[2]
    if kind == "matrix":
        return kind, [[put(entry, values) for entry in row] for row in e[1]]
    return kind, *(put(part, values) for part in e[1:])


def number(k):
    return ("num", str(k)) if k >= 0 else ("neg", ("num", str(-k)))


ZERO, ONE = number(0), number(1)


def plus(a, b):
    if ZERO in (a, b):
        return b if a == ZERO else a
    if b[0] == "neg":
        return "-", a, b[1]
    return "+", a, b


def minus(a, b):
    if b == ZERO:
        return a
    return negated(b) if a == ZERO else ("-", a, b)


def negated(a):
    return a[1] if a[0] == "neg" else ZERO if a == ZERO else ("neg", a)


def times(a, b):
    if ZERO in (a, b):
        return ZERO
    if ONE in (a, b):
        return b if a == ONE else a
    if a[0] == "neg":
        return negated(times(a[1], b))
    return "*", a, b


def over(a, b):
    if a == ZERO or b == ONE:
        return a
    return negated(over(a[1], b)) if a[0] == "neg" else ("/", a, b)


def differentiated(e, name):
    """The derivative by a name; all other names are constants."""
    kind = e[0]
    if kind == "name":
        return ONE if e[1] == name else ZERO
    if kind == "num":
        return ZERO
    if kind == "neg":
        return negated(differentiated(e[1], name))
    if kind in "+-":
        a, b = (differentiated(part, name) for part in e[1:])
        return plus(a, b) if kind == "+" else minus(a, b)
    if kind == "*":
        a, b = e[1:]
        return plus(times(differentiated(a, name), b), times(a, differentiated(b, name)))
    if kind == "/":
        a, b = e[1:]
        da, db = differentiated(a, name), differentiated(b, name)
        if db == ZERO:
            return over(da, b)
        return over(minus(times(da, b), times(a, db)), ("^", b, number(2)))
    if kind == "^":
        base, exponent = e[1:]
        inner = differentiated(base, name)
        if exponent[0] == "num":
            k = int(exponent[1])
            power = ONE if k == 1 else base if k == 2 else ("^", base, number(k - 1))
            return times(times(number(k), power), inner)
        return times(times(exponent, ("^", base, ("-", exponent, ONE))), inner)
    if kind == "call":
        a = e[2][0]
        inner = differentiated(a, name)
        outer = {
            "sin": lambda: ("call", "cos", [a]),
            "cos": lambda: negated(("call", "sin", [a])),
            "tan": lambda: ("/", ONE, ("^", ("call", "cos", [a]), number(2))),
            "exp": lambda: e,
            "ln": lambda: ("/", ONE, a),
            "sqrt": lambda: ("/", ONE, times(number(2), e)),
            "arctan": lambda: ("/", ONE, plus(ONE, ("^", a, number(2)))),
            "arcsin": lambda: ("/", ONE, ("call", "sqrt", [minus(ONE, ("^", a, number(2)))])),
            "arccos": lambda: negated(("/", ONE, ("call", "sqrt", [minus(ONE, ("^", a, number(2)))]))),
        }[e[1]]()
        return times(outer, inner)
    raise ValueError(kind)


# What a function is changed to where a claim is to be false.
OTHERS = {"sin": "cos", "cos": "sin", "arcsin": "arccos", "arccos": "arcsin", "arctan": "arcsin"}


def spoiled(e, rng):
    """An expression with one place changed: a numeral, a sign, a function, an operation."""
    places = []

    def walk(node, path):
        kind = node[0]
        if kind == "num" or kind == "neg" or kind in "+-" or kind == "call" and node[1] in OTHERS:
            places.append(path)
        children = node[2] if kind == "call" else node[1:] if kind in LEVELS else ()
        for i, child in enumerate(children):
            walk(child, path + (i,))

    walk(e, ())
    if not places:
        return plus(e, ONE)
    return changed(e, rng.choice(places), rng)


def changed(e, path, rng):
    kind = e[0]
    if path:
        children = list(e[2] if kind == "call" else e[1:])
        children[path[0]] = changed(children[path[0]], path[1:], rng)
        return (kind, e[1], children) if kind == "call" else (kind, *children)
    if kind == "num":
        return number(int(e[1]) + 1) if e[1].isdigit() else number(1)
    if kind == "neg":
        return e[1]
    if kind == "call":
        return kind, OTHERS[e[1]], e[2]
    return ("-" if kind == "+" else "+"), e[1], e[2]
