"""Random claims about definite integrals: values by an antiderivative, orders, derivatives by an end and by a letter."""

from algebra import differentiated, minus, put, read, show, times
from derivatives import speaks_of
from maker import CIRCULAR, POLYNOMIAL, SMOOTH, given

GROWING = ("exp(t)", "exp(k*t)", "exp(-t/m)", "t*exp(t)", "ln(t + k)", "t*ln(t + k)", "exp(-t^2)", "cos(k*t)*exp(t)")
ENDS = ("0", "1", "2", "-1", "1/2", "pi", "pi/2", "-pi/3", "a", "b", "2*a", "a + 1", "-b")


def any_of(m, name, other=None):
    return m.template(m.pick((POLYNOMIAL, SMOOTH, CIRCULAR, GROWING)), name, other)


def declared(m, *texts):
    """The letters of these texts, with domains."""
    used = [n for n in ("a", "b", "c") if speaks_of(n, *texts)]
    return given(*(f"{n} {m.pick(('real', '> 0', '> 1', 'in [0, 1]', '< 0'))}" for n in used))


def value(m):
    """The integral of a derivative between two ends."""
    name, low, high = m.pick(("x", "t", "theta")), m.pick(ENDS), m.pick(ENDS)
    e = any_of(m, name, m.pick((None, "c")))
    body = show(differentiated(e, name))
    right = minus(put(e, {name: read(high)}), put(e, {name: read(low)}))
    left, lets = f"integral({name} = {low}..{high}, {body})", []
    if m.chance(0.3):
        lets, left = m.pick(
            (
                ([f"let f({name}) = {body}"], f"integral(s = {low}..{high}, f(s))"),
                ([f"let F(s) = integral({name} = {low}..s, {body})"], f"F({high})"),
                ([f"let I = {left}"], "I"),
            )
        )
    relation = "=" if m.is_true else m.pick(("=", "=", "!=", "<"))
    said = m.said_or(right, "0")
    return declared(m, low, high, body, said) + lets + [f"prove {left} {relation} {said}"]


def order(m):
    """Integrals beside each other and beside numbers."""
    f, g = (show(any_of(m, "x")) for _ in range(2))
    low, high = m.pick((("0", "1"), ("1", "2"), ("0", "b"), ("a", "a + 1"), ("0", "pi"), ("b", "0")))
    left = f"integral(x = {low}..{high}, {f})"
    relation = m.pick(("<", "<=", ">", ">="))
    right = m.pick(
        ("0", "1", m.pick(ENDS), f"integral(x = {low}..{high}, {g})", f"integral(x = {high}..{low}, {g})")
    )
    return declared(m, low, high, right) + [f"prove {left} {relation} {right}"]


def derivative(m):
    """By an end, by a letter of the integrand, or by both."""
    e = any_of(m, "s", m.pick((None, "c")))
    low = m.pick(("0", "1", "b"))
    way = m.rng.randrange(3)
    if way == 0:
        left, right = f"derivative(integral(s = {low}..x, {show(e)}), x)", put(e, {"s": ("name", "x")})
    elif way == 1:
        left = f"derivative(integral(s = {low}..2*x, {show(e)}), x)"
        right = times(("num", "2"), put(e, {"s": read("2*x")}))
    else:
        left = f"derivative(integral(s = x..{low}, {show(e)}), x)"
        right = ("neg", put(e, {"s": ("name", "x")}))
    domain = m.pick(("> 0", "> 1", "real", "in (0, 1)"))
    said = m.said_or(right, "0")
    return declared(m, low, left, said) + given(f"x {domain}") + [f"prove {left} = {said}"]


def limit(m):
    """Of the integral as an end moves."""
    e = any_of(m, "t")
    body = show(differentiated(e, "t"))
    point = m.pick(("0", "1", "2"))
    right = minus(put(e, {"t": read("1")}), put(e, {"t": read(point)}))
    side = m.pick((" from above", " from below", ""))
    return [f"prove limit of integral(t = s..1, {body}) as s -> {point}{side} is {m.said_or(right, '0')}"]


def any_kind(m):
    return m.pick((value, value, order, order, derivative, limit))(m)
