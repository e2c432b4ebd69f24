"""J1: the catalogue's identities over any ring of rational functions; `flint_peer.py` and `sympy_peer.py` give rings.

Powers with a symbolic exponent and roots are variables of their own (p for the i-th power of the gain, g, h for
the roots of the masses): the trick with which a polynomial tool can say them at all.
"""
from collections import namedtuple

NAMES = tuple("m1 m2 mu mu1 mu2 x e e1 e2 e3 v1 v2 p g h".split())
Ring = namedtuple("Ring", "variables number same derivative")


def laws(ring, a, b, e, after):
    """The velocities satisfy momentum and restitution; they are the only ones, as the determinant a + b is not 0."""
    v, w = ring.variables["v1"], ring.variables["v2"]
    momentum = ring.same(a * v + b * w, a * after[0] + b * after[1])
    return momentum and ring.same(after[1] - after[0], -(e * (w - v)))


def after(ring, a, b, e):
    v, w = ring.variables["v1"], ring.variables["v2"]
    one = ring.number(1)
    return ((a - e * b) * v + b * (one + e) * w) / (a + b), (a * (one + e) * v + (b - e * a) * w) / (a + b)


def two_bodies(ring):
    """(5), (6), u1, u4"""
    g = ring.variables
    return laws(ring, g["m1"], g["m2"], g["e"], after(ring, g["m1"], g["m2"], g["e"])) and laws(
        ring, g["m1"], g["mu"], g["e1"], after(ring, g["m1"], g["mu"], g["e1"])
    )


def matrix(ring):
    """(7)"""
    g, one = ring.variables, ring.number(1)
    x, e, v, w = g["m1"] / g["m2"], g["e"], g["v1"], g["v2"]
    other = ((x - e) * v + (one + e) * w) / (x + one), (x * (one + e) * v + (one - e * x) * w) / (x + one)
    return all(ring.same(a, b) for a, b in zip(after(ring, g["m1"], g["m2"], e), other))


def share(ring, masses, restitutions):
    total = ring.number(1)
    for a, b, e in zip(masses, masses[1:], restitutions):
        total = total * a * (ring.number(1) + e) / (a + b)
    return masses[-1] * total**2 / masses[0]


def eta2(ring):
    g, one = ring.variables, ring.number(1)
    return (one + g["e"]) ** 2 * g["m1"] * g["m2"] / (g["m1"] + g["m2"]) ** 2


def eta3(ring):
    g, one = ring.variables, ring.number(1)
    m1, m2, mu = g["m1"], g["m2"], g["mu"]
    return (one + g["e1"]) ** 2 * (one + g["e2"]) ** 2 * m1 * m2 * mu**2 / ((m1 + mu) ** 2 * (mu + m2) ** 2)


def eq08(ring):
    g = ring.variables
    return ring.same(share(ring, [g["m1"], g["m2"]], [g["e"]]), eta2(ring))


def eq09(ring):
    g, one = ring.variables, ring.number(1)
    x = g["m1"] / g["m2"]
    return ring.same(eta2(ring), (one + g["e"]) ** 2 * x / (one + x) ** 2)


def eq12(ring):
    g, one = ring.variables, ring.number(1)
    m1, m2, mu, e1, e2, v = (g[k] for k in ("m1", "m2", "mu", "e1", "e2", "v1"))
    w = mu * (one + e2) / (mu + m2) * (m1 * (one + e1) / (m1 + mu)) * v
    printed = (one + e1) * (one + e2) * m1 * mu / ((m1 + mu) * (mu + m2)) * v
    return ring.same(w, printed) and ring.same(m2 * w**2, eta3(ring) * m1 * v**2)


def eq13(ring):
    g = ring.variables
    return ring.same(share(ring, [g["m1"], g["mu"], g["m2"]], [g["e1"], g["e2"]]), eta3(ring))


def eq16(ring):
    g, one = ring.variables, ring.number(1)
    m1, m2, a, b = g["m1"], g["m2"], g["mu1"], g["mu2"]
    gains = ((one + g["e1"]) * (one + g["e2"]) * (one + g["e3"])) ** 2
    printed = gains * m1 * m2 * a**2 * b**2 / ((m1 + a) ** 2 * (a + b) ** 2 * (b + m2) ** 2)
    return ring.same(share(ring, [m1, a, b, m2], [g["e1"], g["e2"], g["e3"]]), printed)


def eq22(ring):
    """Base and step of the induction on i; p stands for (x(1+e))^i and g for (x+1)^i."""
    v, one = ring.variables, ring.number(1)
    x, e, p, g = v["x"], v["e"], v["p"], v["g"]
    formula = lambda up, down: up * (x - e) / (down * (x + one))
    gain = x * (one + e) / (x + one)
    base = ring.same((x - e) / (x + one), formula(one, one))
    return base and ring.same(gain * formula(p, g), formula(p * x * (one + e), g * (x + one)))


def eq23(ring):
    g, one = ring.variables, ring.number(1)
    x = g["m1"] / g["mu1"]
    return ring.same((g["m1"] - g["e"] * g["mu1"]) / (g["m1"] + g["mu1"]) * g["v1"], (x - g["e"]) / (x + one) * g["v1"])


def eq24(ring):
    """The step: p stands for the gain's power."""
    g, one = ring.variables, ring.number(1)
    gain = g["x"] * (one + g["e"]) / (g["x"] + one)
    return ring.same(gain * (g["p"] * gain * g["v1"]), g["p"] * gain**2 * g["v1"])


def eq25(ring):
    """m1 = g^N, m2 = h^N. N-th powers of products are products of N-th powers: what is left is the base."""
    g, one = ring.variables, ring.number(1)
    a, b, e = g["g"], g["h"], g["e"]
    x = a / b
    return ring.same(b / a * (x * (one + e) / (x + one)) ** 2, (one + e) ** 2 * a * b / (a + b) ** 2)


def u2(ring):
    g, one = ring.variables, ring.number(1)
    w = g["m1"] * (one + g["e"]) / (g["m1"] + g["m2"]) * g["v1"]
    return ring.same(g["m2"] * w**2, eta2(ring) * g["m1"] * g["v1"] ** 2)


def u3(ring):
    g, one = ring.variables, ring.number(1)
    x, up = g["x"], (one + g["e"]) ** 2
    slope = ring.derivative(up * x / (one + x) ** 2, "x")
    middle = up * ((one + x) ** 2 - ring.number(2) * x * (one + x)) / (one + x) ** 4
    return ring.same(slope, middle) and ring.same(slope, up * (one - x) / (one + x) ** 3)


def u5(ring):
    g, one = ring.variables, ring.number(1)
    m1, m2, mu = g["m1"], g["m2"], g["mu"]
    k = ring.number(2) * (one + g["e1"]) ** 2 * (one + g["e2"]) ** 2 * m1 * m2
    slope, below = ring.derivative(eta3(ring), "mu"), (m1 + mu) ** 3 * (mu + m2) ** 3
    middle = k * mu * ((m1 + mu) * (mu + m2) - mu * (m1 + m2 + mu + mu)) / below
    return ring.same(slope, middle) and ring.same(slope, k * mu * (m1 * m2 - mu**2) / below)


def u6(ring):
    """And the sign at mu = sqrt(m1·m2): with m1 = g², m2 = h² the bracket is −2g³h³(g + h)²."""
    v, one = ring.variables, ring.number(1)
    three = ring.number(3)

    def bracket(m1, m2, t):
        return (m1 * m2 - three * t**2) * (m1 + t) * (t + m2) - three * t * (m1 * m2 - t**2) * (m1 + m2 + t + t)

    m1, m2, mu = v["m1"], v["m2"], v["mu"]
    k = ring.number(2) * (one + v["e1"]) ** 2 * (one + v["e2"]) ** 2 * m1 * m2
    second = ring.derivative(ring.derivative(eta3(ring), "mu"), "mu")
    g, h = v["g"], v["h"]
    negative = -(ring.number(2) * g**3 * h**3 * (g + h) ** 2)
    holds = ring.same(second, k * bracket(m1, m2, mu) / ((m1 + mu) ** 4 * (mu + m2) ** 4))
    return holds and ring.same(bracket(g * g, h * h, g * h), negative)


def u7(ring):
    """With m1 = g², m2 = h²."""
    v, one = ring.variables, ring.number(1)
    a, b = v["g"], v["h"]
    two = ring.number(4) * a**2 * b**2 / (a**2 + b**2) ** 2
    three = ring.number(16) * a**2 * b**2 / (a + b) ** 4
    return ring.same(three / two, ring.number(4) * (a**2 + b**2) ** 2 / (a + b) ** 4)


CHECKS = [two_bodies, matrix, eq08, eq09, eq12, eq13, eq16, eq22, eq23, eq24, eq25, u2, u3, u5, u6, u7]
