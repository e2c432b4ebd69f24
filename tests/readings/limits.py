"""Random claims about limits: at a point, from one side, infinite, at infinity; of definitions and of derivatives."""

import re

from algebra import differentiated, put, read, show, spoiled
from maker import SMOOTH, given


def at_a_point(m):
    other = m.pick((None, None, "b"))
    e = m.template(SMOOTH, "t", other)
    place = m.pick(("1", "2", "3", "-1", "0", "a", "a + 1", "1/2"))
    declared = given(f"{other} real" if other else "", m.pick(("a real", "a > 0")) if "a" in place else "")
    side = m.pick(("", "", " from above", " from below"))
    if m.chance(0.15):
        there = show(put(e, {"t": read(place)}))
        lets, text, value = [], f"({show(e)} - ({there}))/(t - ({place}))", differentiated(e, "t")
    else:
        lets, text, value = m.through(e, "t")
        if m.chance(0.4):
            text, value = f"derivative({text}, t)", differentiated(value, "t")
    if m.chance(0.1):
        text = f"{m.pick(('2', 'cos(0)', 't'))}*{text}" if "+" not in text else f"t*({text})"
        value = None
    said = "1" if value is None else m.said_or(put(value, {"t": read(place)}), "0", "1", place)
    return declared + lets + [f"prove limit of {text} as t -> {place}{side} is {said}"]


def infinite(m):
    place = m.pick(("0", "1", "2", "a"))
    shift = "t" if place == "0" else f"(t - {place})"
    shapes = ("1/{}^2", "1/{}", "-1/{}^2", "-3/{}", "t/{}^2", "1/{}^3", "2/{}^4", "1/{}^2 + 1/{}")
    e = read(m.pick(shapes).format(shift, shift))
    lets, text, _ = m.through(e, "t")
    if m.chance(0.35):
        text = f"derivative({text}, t)"
    side = m.pick(("", " from above", " from below"))
    target = m.pick(("infinity", "-infinity", "0"))
    return given("a > 0" if place == "a" else "") + lets + [f"prove limit of {text} as t -> {place}{side} is {target}"]


def at_infinity(m):
    name, natural = m.pick((("n", " natural"), ("x", ""), ("x", ""), ("t", " real"), ("t", "")))
    other = m.pick((None, "a"))
    shapes = (
        ("(k*t + m)/(t + 1)", None),
        ("k/t", "0"),
        ("(t^2 + k)/(t^2 + 1)", "1"),
        ("t^2", "infinity"),
        ("k*t", "infinity"),
        ("-t^2", "-infinity"),
        ("-t^3 + k*t^2", "-infinity"),
        ("c*t/(t + c)", "a"),
        ("c/t", "0"),
        ("t/(t^2 + k)", "0"),
        ("(c*t + k)/(t + m)", "a"),
        ("k*t - t^2", "-infinity"),
        ("c + 1/t", "a"),
        ("(t + k)/t", "1"),
        ("k*t^2 + c", "infinity"),
    )
    shape, known = m.pick([s for s in shapes if other or "c" not in s[0]])
    e = m.template((shape,), name, other)
    if known is None:
        known = show(read(re.search(r"\d", show(e)).group()))
    lets, text, value = m.through(e, name)
    if value != e:
        known = None
    target = known if m.is_true and known else m.pick(("infinity", "-infinity", "0", "1", "2", "1/2", other or "3"))
    return (
        given(f"{other} {m.pick(('real', '> 0'))}" if other else "")
        + lets
        + [f"prove limit of {text} as {name}{natural} -> infinity is {target}"]
    )


def of_a_derivative_at_infinity(m):
    """Sums of a derivative and something else, which may go elsewhere than the derivative."""
    name = m.pick(("t", "x"))
    e = m.template(
        ("t^2", "-t^2", "k*t^2", "-k*t^2", "t^3", "-t^3", "1/t", "c*t", "-c*t", "k*t - t^2"), name, m.pick((None, "a"))
    )
    lets, text, _ = m.through(e, name) if m.chance(0.5) else ([], show(e), e)
    rest = m.pick(("", "", f" + {name}", f" - {name}", f" + {name}^2", f"/{name}", f"*{name}", " + 1", f" + 3*{name}"))
    slope = f"derivative({text}, {name})"
    goal = slope + rest if m.chance(0.8) else f"{name} - {slope}"
    target = m.pick(("infinity", "infinity", "-infinity", "-infinity", "0", "1", "2", "a" if "a" in text else "1"))
    declared = given(m.pick(("a > 0", "a real"))) if "a" in re.findall(r"\b\w+\b", show(e)) else []
    return declared + lets + [f"prove limit of {goal} as {name} -> infinity is {target}"]


def of_several_kinds(m):
    """Limits with floors, powers of matrices, quantifiers and angles in them."""
    lines = m.pick(
        (
            ["prove limit of floor(t)/t as t -> infinity is 1"],
            ["given x real", "prove limit of floor(x)/n as n natural -> infinity is 0"],
            ["given x real", "prove limit of floor(x)*(1 + t) as t -> 0 is floor(x)"],
            ["given theta real", "prove limit of sin(theta)/n as n natural -> infinity is 0"],
            ["given theta real", "prove limit of cos(theta) + t as t -> 0 is cos(theta)"],
            ["given theta real", "prove limit of derivative(sin(theta), theta)*t as t -> 2 is 2*cos(theta)"],
            ["given theta real", "let g = t*sin(theta)", "prove limit of g as t -> 1 is sin(theta)"],
            ["given theta real", "prove limit of t + derivative(t*cos(theta), theta) as t -> 1 is 1 - sin(theta)"],
            ["prove limit of sin(theta)^2 + cos(theta)^2 as theta -> infinity is 1"],
            ["prove limit of sin(theta) as theta -> infinity is 0"],
            ["prove limit of det([1/t, 0; 0, 1]^2) as t -> infinity is 0"],
            ["given n natural; a real", "prove limit of trace([1, a; 0, 1]^n) as n -> infinity is 2"],
            ["given a in (0, 1); n natural", "prove limit of det([a, 0; 0, 1]^n) as n -> infinity is 0"],
            ["define u by u(0) = 1, u(k + 1) = u(k)/2", "prove limit of u(n) as n natural -> infinity is 0"],
            ["define u by u(0) = 1, u(k + 1) = u(k)/2 + t", "prove limit of u(2) as t -> 1 is 7/4"],
            ["prove for all a > 0: (limit of a*t as t -> 2 is 2*a)"],
            ["prove exists a > 0: (limit of a + t as t -> 0 is a)"],
            ["let g(a) = a*t", "prove for all a > 0: (limit of g(a) as t -> 2 is 2*a)"],
            ["given x > 0", "prove (limit of 1/(x + t) as t -> 0 is 1/x) and (limit of x*t as t -> 1 is x)"],
            ["given x real", "prove limit of |t - x| as t -> x is 0"],
            ["given x real", "prove limit of max(t, x) as t -> x from above is x"],
            ["prove limit of |t|/t as t -> 0 from below is -1"],
            ["prove not (limit of 1/t as t -> 0 is 0)"],
            ["prove limit of sum(i = 1..3, t^i) as t -> 1 is 3"],
            ["prove limit of product(i = 1..2, t + i) as t -> 1 is 6"],
            ["given x real", "prove derivative(x^2, x) = 2*x and (limit of derivative(t^2, t) as t -> x is 2*x)"],
        )
    )
    if m.is_true:
        return lines
    goal = lines[-1]
    head, middle, value = goal.rpartition(" is ")
    if middle and m.chance(0.6) and not value.endswith(")"):
        return lines[:-1] + [f"{head} is {show(spoiled(read(value), m.rng))}"]
    return lines[:-1] + ["prove " + m.rewritten(goal[6:])]
