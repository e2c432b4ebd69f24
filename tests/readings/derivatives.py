"""Random claims about derivatives: by angles and numbers, through definitions, by parameters, tied by hypotheses."""

import re

from algebra import differentiated, number, plus, put, read, show, times
from maker import ANGLES, CIRCULAR, SMOOTH, given


def speaks_of(name, *texts):
    return any(name in re.findall(r"\b\w+\b", text) for text in texts)


def by_an_angle(m):
    name = m.pick(ANGLES)
    other = m.pick((None, "a", "a"))
    e = m.template(CIRCULAR, name, other)
    if m.chance(0.3):
        e = m.pick((plus, times))(e, m.template(CIRCULAR, name, other))
    if m.chance(0.1):
        left, right, lets = f"derivative({show(e)}, {name}, {name})", differentiated(differentiated(e, name), name), []
    else:
        lets, text, value = m.through(e, name)
        left, right = f"derivative({text}, {name})", differentiated(value, name)
    declared = given(
        m.pick((f"{name} real", f"{name} real", m.otherwise(m.range(name)[0]))), f"{other} real" if other else ""
    )
    relation = "=" if m.is_true else m.pick(("=", "=", "=", "!=", "<="))
    return declared + lets + [f"prove {left} {relation} {m.said_or(right, '0')}"]


def by_a_parameter(m):
    """A definition that differentiates by its parameter, applied to something else."""
    is_angle = m.chance(0.5)
    e = m.template(CIRCULAR if is_angle else SMOOTH, "w", m.pick((None, "c")))
    name = m.pick(("theta", "alpha")) if is_angle else m.pick(("x", "y"))
    argument = m.pick((name, name, f"2*{name}" if is_angle else f"{name} + 1"))
    right = put(differentiated(e, "w"), {"w": read(argument)})
    constant = given("c real") if speaks_of("c", show(e)) else []
    lets = [f"let f(w) = derivative({show(e)}, w)"]
    if m.chance(0.3):
        lets = [f"let g(v) = {show(put(e, {'w': ('name', 'v')}))}", "let f(w) = derivative(g(w), w)"]
    # The parameter may have the name of a variable that is declared behind the definition.
    declared = given(f"{name} real", m.pick(("w real", "")))
    return constant + lets + declared + [f"prove f({argument}) = {m.said_or(right, '0')}"]


def by_a_number(m):
    name, other = m.pick((("x", "y"), ("a", "b"), ("y", "x")))
    e = m.template(SMOOTH, name, m.pick((None, other)))
    lets, text, value = m.through(e, name)
    if m.chance(0.2):
        factor = read(m.pick((f"floor({other})", f"abs({other})", f"max({other}, 1)", f"cos({other})", f"{other}^2")))
        lets, value = [], times(factor, e)
        text = show(value)
        right = times(factor, differentiated(e, name))
    else:
        right = differentiated(value, name)
    domain = m.pick(("real", "> 0", "> 0"))
    goal = f"derivative({text}, {name}) = {m.said_or(right, '0')}"
    if m.chance(0.2) and not speaks_of(name, *lets):
        return given(f"{other} real") + lets + [f"prove for all {name} {domain}: {goal}"]
    return given(f"{name} {domain}", f"{other} real") + lets + [f"prove {goal}"]


def tied(m):
    """A hypothesis ties the variable of a derivative to another, which may or may not be in the derivative."""
    e = m.template(CIRCULAR, "theta")
    slope = m.said(differentiated(e, "theta"))
    lines = m.pick(
        (
            ("given theta real; x real", f"assume x = {show(e)}", ("x", "theta", ("0", slope))),
            ("given theta real; x real", f"assume 2*x = {show(e)}", ("x^2", "theta", ("0", "2*x"))),
            ("given theta real; a, x real", "assume x = 2*a", (f"a*({show(e)})", "theta", (f"a*({slope})",))),
            ("given theta real; x real", "assume x = cos(theta)", (show(e), "theta", (slope,))),
            (
                "given alpha, beta in (0, pi)",
                f"assume alpha + beta = {m.pick(('pi', 'pi/2', '3*pi/2'))}",
                (
                    m.pick(("cos(beta)", "sin(beta)", "cos(alpha) + cos(beta)")),
                    "alpha",
                    ("0", "-sin(alpha)", "-cos(beta)"),
                ),
            ),
            (
                "given alpha in [0, pi]; beta real",
                f"assume beta = {m.pick(('2*alpha', 'alpha', 'alpha + pi/2'))}",
                (m.pick(("cos(beta)", "sin(alpha)*cos(beta)")), "alpha", ("0", "cos(alpha)*cos(beta)", "-2*sin(beta)")),
            ),
            (
                "given x, y real",
                f"assume {m.pick(('x*y = 1', 'y = x^2', 'x + y = 3', 'x^2 + y^2 = 1'))}",
                (m.pick(("y", "x*y", "x^2")), "x", ("0", "y", "2*x")),
            ),
            ("given x, y, z real", "assume y = z^2", (m.pick(("y*x", "z + x", "x^2")), "x", ("y", "1", "2*x"))),
            (
                "given theta real; y real",
                f"let c = {show(e)}\nassume y = c",
                (m.pick(("y", "y*c", "c")), "theta", ("0", slope, "y")),
            ),
        )
    )
    declared, assumed, (body, name, values) = lines
    return [declared, *assumed.split("\n"), f"prove derivative({body}, {name}) = {m.pick(values)}"]


def of_sequences(m):
    way = m.rng.randrange(4)
    e = m.template(CIRCULAR, "theta")
    slope = differentiated(e, "theta")
    if way == 0:
        k = m.rng.randint(1, 3)
        step = f"define u by u(0) = 0, u(k + 1) = u(k) + ({show(e)})"
        return [
            "given theta real",
            step,
            f"prove derivative(u({k}), theta) = {m.said_or(times(number(k), slope), '0')}",
        ]
    if way == 1:
        goals = (
            "V(2) = a",
            "u(1) = a",
            "V(1) = a",
            "u(2) = 0",
            "V(3) = 0",
            "derivative(V(2), a) = 1",
            "derivative(u(1), a) = 0",
            "derivative(V(2), a) = 0",
            "derivative(u(1), a) = 1",
            "derivative(a*V(2), a) = 2*a",
        )
        step = "define V, u by V(0) = a, u(0) = 0, V(k + 1) = u(k), u(k + 1) = V(k)"
        return ["given a real", step, f"prove {m.pick(goals)}"]
    if way == 2:
        f = m.template(SMOOTH, "x")
        step, right = m.pick((("u(k)", differentiated(f, "x")), ("2*u(k)", times(number(2), differentiated(f, "x")))))
        lines = ["given x > 0", f"define u by u(0) = {show(f)}, u(k + 1) = {step}"]
        return lines + [f"prove derivative(u(1), x) = {m.said_or(right, '0')}"]
    goal = m.pick(
        (
            "derivative(mu(1)*cos(theta), theta) = -mu(1)*sin(theta)",
            "derivative(mu(0) + sin(theta), theta) = cos(theta)",
            "derivative(mu(1), theta) = 0",
            "derivative(sin(theta)*mu(2)^2, theta) = cos(theta)*mu(2)^2",
        )
    )
    return ["given mu(k) real; theta real", f"prove {goal if m.is_true else m.rewritten(goal)}"]
