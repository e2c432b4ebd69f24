"""Random claims about arcsin, arccos and arctan: values, order, equations, derivatives, integrals, limits, other words around them."""

import re

import mpmath

from algebra import differentiated, read, show
from maker import given, turns

FUNCTIONS = ("arcsin", "arccos", "arctan")
# Smooth functions of t that have values between -1 and 1; k and m stand for small numerals, c for another variable.
TEMPLATES = (
    "arctan(t)", "arctan(k*t)", "arctan(t^2)", "t*arctan(t)", "arctan(1/t)", "arctan(c*t)", "arctan(t)^2", "k/arctan(t)",
    "arcsin(t)", "arccos(t)", "arcsin(t/2)", "arccos(t/k)", "t*arcsin(t)", "arcsin(t^2)", "arccos(-t)", "arcsin(t)^2",
    "arcsin(t/(1 + t^2))", "arctan(t/(1 + t))", "arctan(sqrt(t + k))", "sqrt(arctan(t) + k)", "exp(arctan(t))",
    "ln(k + arctan(t))", "arctan(arctan(t))", "arcsin(c*t)", "arctan(k/(t + m))", "arccos(t)*arcsin(t)",
)  # fmt: skip
DOMAINS = (
    "real",
    "> 0",
    "< 0",
    ">= 0",
    "in [-1, 1]",
    "in (-1, 1)",
    "in [0, 1]",
    "in (0, 1]",
    "in [-1, 0)",
    "in (1, 2)",
)
# Equations and orders, each with domains for its variables under which it is true.
TRUE = (
    ("x in [-1, 1]", "arcsin(x) + arccos(x) = pi/2"),
    ("x in [-1, 1]", "sin(arcsin(x)) = x"),
    ("x in [-1, 1]", "cos(arcsin(x)) = sqrt(1 - x^2)"),
    ("x in [-1, 1]", "sin(arccos(x)) = sqrt(1 - x^2)"),
    ("x in [-1, 1]", "cos(2*arccos(x)) = 2*x^2 - 1"),
    ("x in (-1, 1)", "tan(arcsin(x)) = x/sqrt(1 - x^2)"),
    ("x real", "cos(arctan(x)) = 1/sqrt(1 + x^2)"),
    ("x real", "tan(arctan(x)) = x"),
    ("x real", "sin(2*arctan(x)) = 2*x/(1 + x^2)"),
    ("x in [-1, 1]", "arccos(-x) = pi - arccos(x)"),
    ("x real", "arctan(-x) = -arctan(x)"),
    ("x > 0", "arctan(1/x) = pi/2 - arctan(x)"),
    ("x < 0", "arctan(1/x) = -pi/2 - arctan(x)"),
    ("x real", "arctan(x) = arcsin(x/sqrt(1 + x^2))"),
    ("x in (-1, 1)", "arcsin(x) = arctan(x/sqrt(1 - x^2))"),
    ("x in [0, 1]", "arcsin(x) = arccos(sqrt(1 - x^2))"),
    ("x in [0, 1]", "2*arccos(x) = arccos(2*x^2 - 1)"),
    ("x in [-1, 0]", "2*arccos(x) = 2*pi - arccos(2*x^2 - 1)"),
    ("x >= 0", "arctan(x) <= x"),
    ("x <= 0", "arctan(x) >= x"),
    ("x in [0, 1]", "arcsin(x) >= x"),
    ("x >= 0", "arctan(x) >= x/(1 + x^2)"),
    ("x real", "|arctan(x)| <= |x|"),
    ("x real", "arctan(x) < pi/2"),
    ("x in [-1, 1]", "arccos(x) >= 0"),
    ("x in [-1, 1]", "arcsin(x)^2 <= pi^2/4"),
    ("x in [-1, 1]", "arccos(x) <= pi"),
    ("x, y real", "(arctan(x) - arctan(y))*(x - y) >= 0"),
    ("x in [0, 1]; y in [0, x]", "arcsin(y) <= arcsin(x)"),
    ("x in [0, 1]; y in [0, x]", "arccos(y) >= arccos(x)"),
    ("x, y in (0, 1)", "arctan(x) + arctan(y) = arctan((x + y)/(1 - x*y))"),
    ("x, y > 1", "arctan(x) + arctan(y) = pi + arctan((x + y)/(1 - x*y))"),
    ("x real", "max(arctan(x), 0) <= pi/2"),
    ("x real", "floor(arctan(x)) <= 1"),
    ("x real", "floor(arctan(x)/2) >= -1"),
    ("x in [-1, 1]", "ceil(arccos(x)) <= 4"),
    ("x real", "arctan(floor(x)) <= arctan(x)"),
    ("n natural", "arctan(n) < arctan(n + 1)"),
    ("n natural", "sum(i = 0..n, arctan(i + 1) - arctan(i)) = arctan(n + 1)"),
    ("n natural", "arccos((-1)^n) >= 0"),
    ("k integer", "arctan(k)*k >= 0"),
    ("theta in (-pi/2, pi/2)", "arctan(tan(theta)) = theta"),
    ("theta in [-pi/2, pi/2]", "arcsin(sin(theta)) = theta"),
    ("theta in [0, pi]", "arccos(cos(theta)) = theta"),
    ("theta in [pi, 2*pi]", "arccos(cos(theta)) = 2*pi - theta"),
    ("theta in [pi/2, pi]", "arcsin(sin(theta)) = pi - theta"),
    ("theta in (pi/2, 3*pi/2)", "arctan(tan(theta)) = theta - pi"),
    ("theta real", "arcsin(sin(theta)) <= pi/2"),
    ("pi > 4", "arctan(pi) < pi/2"),
    ("x real", "exists y real: arctan(y) = arctan(x)/2"),
    ("x in (0, 1)", "exists theta in [0, pi]: cos(theta) = x"),
    ("", "for all x in [-1, 1]: arcsin(x) <= pi/2"),
    ("", "for all x in [0, 1]: arccos(x) <= pi/2"),
    ("a > 0", "for all x > a: arctan(x) > arctan(a)"),
    ("x real", "x > 1 => arctan(x) > pi/4"),
    ("x real", "x in_range => arcsin(x) <= pi/2"),
    ("a real", "arctan(x) = a or arctan(x) != a"),
)  # fmt: skip
OF_ANGLES = (
    ("cos(theta) = c", "theta = arccos(c)", "[0, pi]"),
    ("sin(theta) = c", "theta = arcsin(c)", "[-pi/2, pi/2]"),
    ("tan(theta) = c", "theta = arctan(c)", "(-pi/2, pi/2)"),
    ("theta = arctan(c)", "tan(theta) = c", "(-pi/2, pi/2)"),
    ("theta = arccos(c)", "cos(theta) = c", "[0, pi]"),
    ("theta = arccos(c)", "sin(theta) >= 0", "[0, pi]"),
    ("theta = arcsin(c)", "cos(theta) >= 0", "[0, pi]"),
)
LIMITS = (
    ("arctan(t)", "infinity", "pi/2"),
    ("arctan(-t)", "infinity", "-pi/2"),
    ("arctan(t)/t", "infinity", "0"),
    ("t*arctan(1/t)", "infinity", "1"),
    ("arctan(t)/t", "0", "1"),
    ("arcsin(t)/t", "0", "1"),
    ("arctan(1/t)", "0 from above", "pi/2"),
    ("arctan(1/t)", "0 from below", "-pi/2"),
    ("arctan(1/t^2)", "0", "pi/2"),
    ("arcsin(t)", "1 from below", "pi/2"),
    ("arccos(t)", "-1 from above", "pi"),
    ("arccos(t)", "1 from below", "0"),
    ("arcsin(t/(t + 1))", "infinity", "pi/2"),
    ("(arctan(t) - t)/t^3", "0", "-1/3"),
    ("t*arctan(t)", "infinity", "infinity"),
    ("t - arctan(t)", "infinity", "infinity"),
    ("arctan(t)", "1", "pi/4"),
    ("arcsin(t)", "1/2", "pi/6"),
    ("arctan(t^2) - arctan(t)", "infinity", "0"),
)
EXTREMA = (
    ("maximum", "arctan(t)", "[0, 1]", "1", "pi/4"),
    ("minimum", "arctan(t)", "[-1, 2]", "-1", "-pi/4"),
    ("maximum", "arccos(t)", "[0, 1]", "0", "pi/2"),
    ("minimum", "arcsin(t)", "[-1, 1]", "-1", "-pi/2"),
    ("minimum", "arctan(t)^2", "[-1, 1]", "0", "0"),
    ("maximum", "arctan(2*t/(1 + t^2))", "[0, 2]", "1", "pi/4"),
    ("minimum", "arccos(t)*t", "[0, 1]", "0", "0"),
    ("maximum", "arcsin(t)", "[0, 1)", "1", "pi/2"),
)


def equation(m):
    """A known truth; a false claim has another domain, or another place changed."""
    declared, goal = m.pick(TRUE)
    if "in_range" in goal:
        goal = goal.replace("x in_range", m.pick(("-1 <= x and x <= 1", "0 <= x and x < 1", "x^2 <= 1")))
    if declared == "a real":
        declared, goal = "a, x real", m.pick((goal, "arctan(x) = a => tan(a) = x", "a = arctan(x) => cos(a) > 0"))
    if not m.is_true:
        way = m.rng.randrange(3)
        if way and declared.startswith("x ") and ";" not in declared:
            declared = f"x {m.pick(DOMAINS)}"
        elif way and declared.startswith("theta"):
            declared = m.range("theta")[0]
        else:
            goal = m.rewritten(goal)
    return given(*declared.split("; ")) + m.pick(([f"prove {goal}"], defined(goal)))


def defined(goal):
    """The goal with an arc behind a definition."""
    found = re.search(r"(arc(?:sin|cos|tan))\(x\)", goal)
    if not found or "for all" in goal or "exists" in goal:
        return [f"prove {goal}"]
    return [f"let f(w) = {found.group(1)}(w)", f"prove {goal.replace(found.group(), 'f(x)')}"]


def of_an_angle(m):
    """What an equation for a cosine says of the angle, which depends on the range of the angle."""
    assumed, goal, over = m.pick(OF_ANGLES)
    if not m.is_true:
        over = m.pick(
            ("[0, pi]", "[0, 2*pi]", "[-pi, pi]", "[pi, 2*pi]", "[-pi/2, pi/2]", "(-pi/2, pi/2)", "[0, pi/2)")
        )
        goal = m.pick((goal, m.rewritten(goal)))
    sure = "" if "tan" in assumed + goal else "c in [-1, 1]"
    return given(f"theta in {over}", sure or "c real") + [f"assume {assumed}", f"prove {goal}"]


def of_numbers(m):
    """A comparison of numbers made of arcs, decided by evaluation."""

    def term():
        top, bottom = m.rng.randint(-6, 6), m.rng.randint(1, 7)
        f = m.pick(FUNCTIONS)
        if f != "arctan" and abs(top) > bottom:
            top, bottom = bottom, top
        text = m.pick(
            (f"{top}/{bottom}", f"{top}/{bottom}", "sqrt(2)/2", "-sqrt(3)/2", "1/sqrt(3)", "1", "-1", "0", "1/2")
        )
        return f"{m.pick(('', '', '2*', '3*'))}{f}({text})"

    def number_of(text):
        words = {f: getattr(mpmath, f.replace("arc", "a")) for f in FUNCTIONS}
        return eval(text, {**words, "sqrt": mpmath.sqrt, "pi": mpmath.pi, "floor": mpmath.floor})

    left = term() if m.chance(0.4) else f"{term()} {m.pick('+-')} {term()}"
    right = m.pick(
        (term(), turns(m.rng.randint(-18, 18)), str(m.rng.randint(-3, 3)), "22/7", "arctan(1/2) + arctan(1/3)")
    )
    if m.chance(0.1):
        left, right = f"floor({left})", str(m.rng.randint(-4, 4))
    known = (
        ("arctan(1/2) + arctan(1/3)", "pi/4"),
        ("4*arctan(1/5) - arctan(1/239)", "pi/4"),
        ("arctan(1) + arctan(2) + arctan(3)", "pi"),
        ("2*arctan(1/3) + arctan(1/7)", "pi/4"),
        ("arcsin(3/5)", "arctan(3/4)"),
        ("arccos(3/5) + arccos(4/5)", "pi/2"),
        ("2*arcsin(1/4)", "arccos(7/8)"),
    )
    if m.chance(0.3):
        left, right = m.pick(known)
    gap = number_of(left) - number_of(right)
    holding = ("=", "<=", ">=") if abs(gap) < 1e-40 else ("!=", "<", "<=") if gap < 0 else ("!=", ">", ">=")
    relations = holding if m.is_true else [r for r in ("=", "!=", "<", "<=", ">", ">=") if r not in holding]
    return [f"prove {left} {m.pick(relations)} {right}"]


def order(m):
    """Arcs of two arguments beside each other."""
    f = m.pick(FUNCTIONS)
    arguments = ("x", "y", "x^2", "x/2", "-x", "x*y", "1", "0", "1/2", "(x + y)/2", "x^3", "1/(1 + x^2)", "x/(1 + x)")
    domain = m.pick(("in [0, 1]", "in (0, 1)", "in [-1, 1]", "> 0", "real"))
    left, right = m.pick(arguments), m.pick(arguments)
    g = f if m.chance(0.85) else m.pick(FUNCTIONS)
    lines = given(f"x {domain}", m.pick(("y in [0, 1]", "y in [-1, 1]")))
    tie = m.pick(("", "", "assume x < y", "assume x <= y", "assume x^2 = y"))
    relation = m.pick(("<", "<=", ">", ">=", "=", "!="))
    goal = f"{f}({left}) {relation} {g}({right})"
    if m.chance(0.2):
        goal = f"{left} {m.pick(('<', '<=', '>'))} {right} => {goal}"
    return lines + ([tie] if tie else []) + [f"prove {goal}"]


def derivative(m):
    e = m.template(TEMPLATES, "x", m.pick((None, "c")))
    lets, text, value = m.through(e, "x")
    domain = m.pick(DOMAINS) if m.chance(0.5) else "in (0, 1)"
    constant = "c in (0, 1)" if re.search(r"\bc\b", text + show(e)) else ""
    goal = f"derivative({text}, x) = {m.said_or(differentiated(value, 'x'), '0')}"
    if m.chance(0.15) and not lets:
        return given(constant) + [f"prove for all x {domain}: {goal}"]
    return given(f"x {domain}", constant) + lets + [f"prove {goal}"]


def integral(m):
    """Of what has an arc as its antiderivative, or of an arc."""
    body, value = m.pick(
        (
            ("1/(1 + x^2)", "arctan({})"),
            ("1/(k^2 + x^2)", "arctan(({})/k)/k"),
            ("1/sqrt(1 - x^2)", "arcsin({})"),
            ("1/sqrt(4 - x^2)", "arcsin(({})/2)"),
            ("x/(1 + x^4)", "arctan(({})^2)/2"),
            ("exp(x)/(1 + exp(2*x))", "arctan(exp({}))"),
            ("arctan(x)/(1 + x^2)", "arctan({})^2/2"),
            ("arctan(x)", "(({0})*arctan({0}) - ln(1 + ({0})^2)/2)"),
        )
    )
    low, high = m.pick(("0", "0", "0", "-1/2", "a", "-1")), m.pick(("1", "1/2", "a", "1", "sqrt(3)/2", "-1/2"))
    k = str(m.rng.randint(1, 3))
    left = f"integral(x = {low}..{high}, {re.sub('k', k, body)})"
    value = re.sub(r"\bk\b", k, value)
    right = f"{value.format(high)} - {value.format(low)}"
    if not m.is_true:
        right = m.pick((m.rewritten(right), value.format(high), "pi/2"))
    constant = f"a {m.pick(('in (0, 1)', 'in [0, 1]', 'real', 'in (-1, 1)'))}" if "a" in (low, high) else ""
    return given(constant) + [f"prove {left} = {right}"]


def limit(m):
    body, place, value = m.pick(LIMITS)
    if not m.is_true:
        value = m.pick(("0", "pi/2", "1", "-pi/2", "infinity", "pi"))
        place = m.pick((place, place, place.partition(" ")[0]))
    return [f"prove limit of {body} as t -> {place} is {value}"]


def extremum(m):
    kind, body, over, place, value = m.pick(EXTREMA)
    if not m.is_true:
        kind = m.pick(("maximum", "minimum"))
        over = m.pick((over, "[0, 1)", "(0, 1)", "[-1, 1]"))
        value = m.pick((value, "pi/2", "1"))
    where = m.pick((f" at t = {place}", f" at t = {place}", f" only at t = {place}", ""))
    return [f"prove {kind} of {body} over t in {over}{where} is {value}"]


def sequence(m):
    k = m.rng.randint(1, 3)
    f = m.pick(FUNCTIONS)
    lines, goals = m.pick(
        (
            (["define u by u(0) = x, u(k + 1) = arctan(u(k))"], (f"u({k}) <= x", f"u({k}) < 2", "u(1) = arctan(x)")),
            (["define u by u(0) = x/2, u(k + 1) = u(k)/2"], (f"{f}(u({k})) >= 0", f"{f}(u({k})) <= {f}(u(0))")),
            (["define u by u(0) = x, u(k + 1) = -u(k)"], (f"{f}(u(2)) = {f}(x)", f"{f}(u(1)) = -{f}(x)")),
            (["let A = [arctan(x), 1; 0, 1]"], ("det(A) >= 0", "trace(A^2) = arctan(x)^2 + 1", "det(A) < 2")),
        )
    )
    goal = m.pick(goals)
    return (
        given(f"x {m.pick(('in [0, 1]', 'in [-1, 1]', '>= 0', 'real'))}")
        + lines
        + [f"prove {goal if m.is_true else m.rewritten(goal)}"]
    )


def any_kind(m):
    kinds = (equation, equation, equation, of_an_angle, of_numbers, order, order, derivative, integral, limit, extremum)
    return m.pick(kinds + (sequence,))(m)
