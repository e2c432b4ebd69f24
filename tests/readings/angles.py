"""Random claims about angles: bounds, equations, identities, quantifiers, extrema, and names that the reader makes."""

import math
import re
from fractions import Fraction

from algebra import differentiated, put, read, show, times
from derivatives import speaks_of
from maker import ANGLES, CIRCULAR, POLYNOMIAL, given, turns


def comparison(m, u):
    """A comparison of a cosine or sine with a number."""
    value = m.pick(("0", "0", "0", "1/2", "-1/2", "1", "-1", "sqrt(2)/2", "sqrt(3)/2", "cos(pi/12)", "sin(pi/5)"))
    return f"{m.pick(('sin', 'cos'))}({u}) {m.pick(('>=', '>=', '<=', '>', '<', '!='))} {value}"


def fitting(m, name, low, high, left, right):
    """A comparison with the least or greatest value over a range, strict where that is not attained; or nearly so."""
    u, scale = m.pick(
        ((name, 1), (name, 1), (f"2*{name}", 2), (f"{name}/2", 0.5), (f"{name}/3", 1 / 3), (f"-{name}", -1))
    )
    f = m.pick(("sin", "cos"))
    up = m.chance(0.5)
    values = [(getattr(math, f)(scale * k * math.pi / 48), k / 4) for k in range(4 * low, 4 * high + 1)]
    best, where = (min if up else max)(values)
    attained = any(
        abs(v - best) < 1e-9 and (low < k < high or k == low and left or k == high and right) for v, k in values
    )
    strict = not attained
    if not m.is_true:
        if m.chance(0.6):
            strict = not strict
        else:
            best, where = m.pick(values)
    known = {0: "0", 1: "1", -1: "-1", 0.5: "1/2", -0.5: "-1/2"}
    # The reader knows cosines and sines of multiples of π/120.
    value = known.get(round(best, 9)) or f"{f}({turns(Fraction(round(scale * where * 10), 10))})"
    return f"{f}({u}) {'>' if up else '<'}{'' if strict else '='} {value}"


def bounds(m):
    name = m.pick(ANGLES)
    clause, *ends = m.range(name, m.pick((12, 24, 24, 36)))
    goal = fitting(m, name, *ends) if m.chance(0.75) else comparison(m, m.multiple(name))
    if m.chance(0.15):
        goal += m.pick((" or ", " and ", " => ")) + comparison(m, m.multiple(name))
    left, low, high, right = re.fullmatch(r"\w+ in (.)(.*), (.*)(.)", clause).groups()
    below, above = "<=" if right == "]" else "<", ">=" if left == "[" else ">"
    way = m.rng.randrange(12)
    if way == 0:
        return [f"prove for all {clause}: {goal}"]
    if way == 1:
        return [f"given {name} real", f"assume {name} {above} {low}", f"assume {name} {below} {high}", f"prove {goal}"]
    if way == 2:
        return [f"prove exists {clause}: {goal}"]
    if way == 3:
        # The bounds of a definition.
        return [
            f"given {name} real",
            f"let h = {name}/2",
            f"assume h {above} {low}",
            f"assume h {below} {high}",
            f"prove {goal}",
        ]
    if way == 4:
        other = m.pick([n for n in ANGLES if n != name])
        goal = goal.replace(name, other)
        hypotheses = [f"assume {low} {'<=' if left == '[' else '<'} {name} {below} {high}", f"assume {other} = {name}"]
        m.rng.shuffle(hypotheses)
        return [f"given {name}, {other} real", *hypotheses, f"prove {goal}"]
    return given(m.otherwise(clause)) + [f"prove {goal}"]


def equation(m):
    names = m.pick((("alpha", "beta"), ("alpha", "beta"), ("theta", "phi"), ("alpha", "beta", "gamma")))
    ranges = [m.range(name, m.pick((6, 12, 12, 18, 24))) for name in names]
    signs = [1] + [m.pick((1, 1, 1, -1, 2)) for _ in names[1:]]
    lows = sum(s * (r[1] if s > 0 else r[2]) for s, r in zip(signs, ranges))
    highs = sum(s * (r[2] if s > 0 else r[1]) for s, r in zip(signs, ranges))
    inside = [k for k in (0, 6, 12, 18, 24, 36, -12, -6) if lows <= k <= highs]
    # A sum within the ranges; or one at which an end of the ranges differs from it by a full turn.
    total = m.pick((m.pick(inside or [0]), lows + 24, highs - 24, lows, highs, lows + 6))
    clauses = [m.otherwise(r[0]) for r in ranges]
    if m.chance(0.15):
        clauses[-1] = f"{names[-1]} real"
    left = " + ".join(f"{s}*{n}" if abs(s) != 1 else n if s > 0 else f"-{n}" for s, n in zip(signs, names))
    hypothesis = f"{left.replace('+ -', '- ')} = {turns(total)}"
    i = m.rng.randrange(len(names))
    rest = " + ".join(names[:-1])
    f, a, b = m.pick(("sin", "cos")), names[0], names[-1]
    goals = (
        fitting(m, names[i], *ranges[i][1:]),
        comparison(m, names[i]),
        comparison(m, names[i]),
        comparison(m, names[i] + "/2"),
        f"{f}({b}) = {f}({turns(total)} - ({rest}))",
        f"{f}({rest}) = {m.pick(('', '-'))}{f}({b})",
        f"sin({a}) = cos({b})",
        f"cos({a})*sin({b}) = sin({a})*cos({b})",
        f"tan({a}) = tan({b})",
        f"cos({a})^2 + cos({b})^2 <= 2",
        f"{f}({b}/2) = {f}(({turns(total)} - ({rest}))/2)",
        f"cos({b}/2) = sin(({rest})/2)",
    )
    lets = [f"let h = {a} + {b}"] if m.chance(0.1) and len(names) == 2 and signs[1] == 1 else []
    if lets:
        hypothesis = f"h = {turns(total)}"
    return given(*clauses) + lets + [f"assume {hypothesis}", f"prove {m.pick(goals)}"]


IDENTITIES = (
    "sin(2*u) = 2*sin(u)*cos(u)", "cos(2*u) = cos(u)^2 - sin(u)^2", "cos(2*u) = 1 - 2*sin(u)^2",
    "sin(u)^2 + cos(u)^2 = 1", "sin(u + v) = sin(u)*cos(v) + cos(u)*sin(v)",
    "cos(u - v) = cos(u)*cos(v) + sin(u)*sin(v)", "cos(-u) = cos(u)", "sin(u + pi) = -sin(u)",
    "cos(pi/2 - u) = sin(u)", "sin(3*u) = 3*sin(u) - 4*sin(u)^3", "cos(u)^2 = (1 + cos(2*u))/2",
    "2*sin(u)*sin(v) = cos(u - v) - cos(u + v)", "cos(u + 2*pi) = cos(u)", "sin(u)*cos(u) <= 1/2",
    "cos(u) + sin(u) <= sqrt(2)", "1 + cos(2*u) >= 0", "abs(sin(u)) <= 1", "2*cos(u/2)^2 = 1 + cos(u)",
    "sin(u) = 2*sin(u/2)*cos(u/2)", "sin(u/2)^2 <= 1", "max(sin(u), cos(u)) >= -1", "tan(u)*cos(u) = sin(u)",
    "cos(3*u/2) = 4*cos(u/2)^3 - 3*cos(u/2)", "cos(u/3)^2 + sin(u/3)^2 = 1", "4*cos(u/3)^3 - 3*cos(u/3) = cos(u)",
    "cos(u) = cos(u/2)^2 - sin(u/2)^2", "2*sin(u/2)^2 = 1 - cos(u)", "1 + tan(u)^2 = 1/cos(u)^2",
)  # fmt: skip


def identity(m):
    u, v = m.rng.sample(ANGLES, 2)
    left, relation, right = re.split(r" (=|<=|>=) ", m.pick(IDENTITIES))
    wrap = m.pick(("{u}", "{u}", "{u}", "2*{u}", "{u} + pi/6", "{u}/2", "{u} + {v}")).format(u=u, v=v)
    names = {"u": read(wrap), "v": ("name", v)}
    goal = f"{show(put(read(left), names))} {relation} {m.said(put(read(right), names))}"
    lets, hypotheses = [], []
    if m.chance(0.2):
        meaning = m.pick((f"{u}/2", f"2*{u}", f"{u} + pi/3"))
        lets = [f"let h = {meaning}"]
        goal += " and " + m.pick(
            ("cos(2*h) = 2*cos(h)^2 - 1", f"cos(h) = cos({meaning})", "sin(h) <= 1", f"sin(h) = sin({u})")
        )
    declared = [m.pick((f"{n} real", m.otherwise(m.range(n)[0]))) for n in (u, v) if speaks_of(n, goal, *lets)]
    if m.chance(0.12) and not lets:
        f, part, value = m.pick(("cos", "sin")), m.pick(("", "/2", "/2", "/3")), m.pick(("0", "1", "1/2", "3/5"))
        hypotheses = [f"assume {f}({u}{part}) = {value}"]
        declared = [f"{n} real" for n in (u, v) if speaks_of(n, goal, *hypotheses)]
        goal = m.pick((goal, comparison(m, u), comparison(m, f"{u}/2")))
        declared = [f"{n} real" for n in (u, v) if speaks_of(n, goal, *hypotheses)]
    return given(*declared) + lets + hypotheses + [f"prove {goal}"]


def made_names(m):
    """Names that look like those that the reader makes, given by the author."""
    u = m.pick(("theta", "x", "alpha"))
    ends = ("{}_over_2", "{}_over_2", "{}_over_3", "cos_{}", "sin_{}", "cos_{}_over_2", "sin_{}_over_2", "{}_2")
    own = m.pick(ends).format(u)
    k = 3 if own.endswith("3") else 2
    is_number = own.startswith(("cos", "sin"))
    f, g = m.pick(("cos", "sin")), m.pick(("cos", "sin"))
    value, other = m.pick(("0", "1", "-1", "1/2")), m.pick(("0", "1", "-1", "1/2"))
    mine = f"{own} = {value}" if is_number else f"{f}({own}) = {value}"
    part = f"{g}({u}/{k}) = {other}"
    inner = f"{own} = {g}({u}/{k})" if is_number else f"{f}({own}) = {f}({u}/{k})"
    tame = f"{own}^2 >= {m.pick(('0', '1'))}" if is_number else f"{f}({own})^2 + {g}({own})^2 >= {m.pick(('0', '1'))}"
    domain = m.pick(("real", "real", "in [2, 3]" if is_number else "in [0, pi]"))
    return m.pick(
        (
            [
                f"given {u} real",
                f"assume {g}({u}/{k}) = {m.pick(('0', value))}",
                f"prove exists {own} real: {mine} and {part}",
            ],
            [f"prove for all {u} real: exists {own} real: {mine} and {part}"],
            [f"given {u} real; {own} real", f"assume {part}", f"prove {mine}"],
            [f"given {u} real; {own} {domain}", f"prove {tame} and {g}({u}/{k}) <= 1"],
            [f"given {own} {'in [2, 3]' if is_number else 'real'}", f"prove {own + ' >= 2' if is_number else tame}"],
            [f"given {u} real", f"prove exists {own} real: {mine} or {part}"],
            [
                f"given {u} real",
                f"let {own} = {m.pick((f'{u}/2', f'2*{u}', '1/2'))}",
                f"prove {mine if is_number else tame} or {part}",
            ],
            [
                f"prove for all {u} real: exists {own} real: {inner}"
                + m.pick(("", f" and {part}", f" and {g}({u}/{k}) <= 1"))
            ],
        )
    )


def quantified(m):
    u = m.pick(("theta", "alpha", "x"))
    clause = m.range(u, 24)[0]
    f = m.pick(("sin", "cos"))
    value = m.pick(("0", "1", "-1", "1/2", "sqrt(2)/2", "a", "sin(pi/12)"))
    e = m.template(CIRCULAR, u)
    word = m.pick(("or", "=>", "and", "<=>"))
    solved = m.pick(
        (
            f"{f}({u}) = {f}(phi/2)",
            f"{f}({u}) = {f}(2*phi)",
            f"{f}({u}) = {f}(phi) and {comparison(m, u)}",
            f"sin({u}) = -sin(phi) and cos({u}) = cos(phi)",
            f"{f}({u}/2) = {f}(phi)",
        )
    )
    other = m.range(u, 12)[0]
    return m.pick(
        (
            given(m.pick(("a in [-1, 1]", "a in [0, 1]"))) * (value == "a")
            + [f"prove exists {clause}: {f}({m.multiple(u)}) = {value}"],
            [f"prove exists {clause}: {comparison(m, u)} and {comparison(m, m.pick((u, u + '/2')))}"],
            [f"prove for all {clause}: {comparison(m, u)} {word} {comparison(m, m.multiple(u))}"],
            [f"prove not (exists {clause}: {comparison(m, u)})"],
            [f"prove for all {clause}: derivative({show(e)}, {u}) = {m.said_or(differentiated(e, u), '0')}"],
            ["given phi real", f"prove exists {u} real: {solved}"],
            # The same name twice, with bounds of its own each time.
            [f"prove (for all {clause}: {comparison(m, u)}) {word} (for all {other}: {comparison(m, u)})"],
            [f"assume for all {clause}: {comparison(m, u)}", f"prove {m.pick(('1 = 1', '1 = 2'))}"],
        )
    )


def rough(e, name, x):
    """A rough value, to choose places by."""
    names = {n: getattr(math, n) for n in ("sin", "cos", "tan", "sqrt", "exp", "pi")}
    try:
        return eval(show(e).replace("^", "**"), {"__builtins__": {}}, {**names, name: x})
    except (ZeroDivisionError, ValueError):
        return None


def extremum(m):
    name = m.pick(("theta", "phi", "x"))
    shapes = (
        "sin(t)",
        "cos(t)",
        "sin(2*t)",
        "cos(2*t)",
        "sin(t)^2",
        "k*cos(t)",
        "cos(t)^2",
        "sin(t)*cos(t)",
        "cos(t/2)",
        "k - cos(t)",
        "sin(t + pi/6)",
        "sin(t) + cos(t)",
        "2*cos(t)^2 - 1",
        "-sin(t)",
        "1/(2 + cos(t))",
        "sin(t/2)",
    )
    e = m.template(shapes, name)
    lets, text, target = extremum_of(m, e, name)
    clause, low, high, _, _ = m.range(name, m.pick((6, 12, 24)))
    kind = m.pick(("maximum", "minimum"))
    values = [(rough(target, name, k * math.pi / 12), k) for k in range(low, high + 1)]
    best, where = (max if kind == "maximum" else min)(values)
    if not m.is_true and m.chance(0.6):
        best, where = m.pick(values)
    short = {0: "0", 1: "1", -1: "-1", 0.5: "1/2", -0.5: "-1/2", 2: "2", -2: "-2"}
    value = short.get(round(best, 9)) or show(put(target, {name: read(turns(where))}))
    if not m.is_true and m.chance(0.4):
        value = m.pick(("0", "1", "-1", "1/2", "2"))
    place = f"{m.pick(('', '', 'only '))}at {name} = {turns(where)} " if m.chance(0.85) else ""
    return lets + [f"prove {kind} of {text} over {clause} {place}is {value}"]


def extremum_of(m, e, name):
    """An expression or its derivative, perhaps through a definition: the clauses, the text, and what it stands for."""
    inner = show(put(e, {name: ("name", "w")}))
    slope = differentiated(e, name)
    return m.pick(
        (
            ([], show(e), e),
            ([f"let f(w) = {inner}"], f"f({name})", e),
            ([], f"derivative({show(e)}, {name})", slope),
            ([f"let g(w) = {inner}"], f"derivative(g({name}), {name})", slope),
            ([f"let f(w) = derivative({inner}, w)"], f"f({name})", slope),
            ([], f"2*derivative({show(e)}, {name})", times(("num", "2"), slope)),
        )
    )


def extremum_of_a_number(m):
    e = m.template(POLYNOMIAL, "t")
    lets, text, target = extremum_of(m, e, "t")
    low, high = m.rng.randint(-2, 1), m.rng.randint(2, 3)
    kind = m.pick(("maximum", "minimum"))
    values = [(rough(target, "t", k), k) for k in range(low, high + 1)]
    best, where = (max if kind == "maximum" else min)(values) if m.is_true else m.pick(values)
    left, right = ("[", "]") if m.chance(0.8) else (m.pick("[("), m.pick("])"))
    place = f"{m.pick(('', '', 'only '))}at t = {where} " if m.chance(0.8) else ""
    if m.chance(0.15):
        a = m.pick(("a", "a^2", "a + 1"))
        value = m.pick((f"2*({a})", "0", "2"))
        return [
            "given a > 0",
            f"prove {kind} of derivative({a}*t^2, t) over t in [0, 1] at t = {m.pick((0, 1))} is {value}",
        ]
    return lets + [f"prove {kind} of {text} over t in {left}{low}, {high}{right} {place}is {best}"]
