"""The paper's identities checked with SymPy, for comparison with `carom audit`.

Needs SymPy: pip install sympy. Prints each identity with its time, then the total.
"""

import time

START = time.perf_counter()
import sympy as sp  # noqa: E402

IMPORTED = time.perf_counter() - START

m1, m2, mu, mu1, mu2, x, v1, v2 = sp.symbols("m1 m2 mu mu1 mu2 x v1 v2", positive=True)
e, e1, e2, e3 = sp.symbols("e e1 e2 e3", nonnegative=True)
w1, w2 = sp.symbols("w1 w2", real=True)
i, n = sp.symbols("i n", integer=True, nonnegative=True)


def zero(expression):
    return sp.simplify(expression) == 0


def laws():
    solution = sp.solve([m1 * v1 + m2 * v2 - m1 * w1 - m2 * w2, w2 - w1 + e * (v2 - v1)], [w1, w2], dict=True)[0]
    return zero(solution[w1] - ((m1 - e * m2) * v1 + m2 * (1 + e) * v2) / (m1 + m2)) and zero(
        solution[w2] - (m1 * (1 + e) * v1 + (m2 - e * m1) * v2) / (m1 + m2)
    )


def share(*masses):
    total = sp.Integer(1)
    for (a, b), r in zip(zip(masses, masses[1:]), (e1, e2, e3)):
        total *= a * (1 + r) / (a + b)
    return masses[-1] * total**2 / masses[0]


def laws_hold(first, second, restitution, v, w, v_after, w_after):
    """Momentum and restitution with these velocities after the collision."""
    return zero(first * v + second * w - first * v_after - second * w_after) and zero(
        w_after - v_after + restitution * (w - v)
    )


def matrix(first, second, restitution, v, w):
    factor = sp.Matrix(
        [
            [first - restitution * second, second * (1 + restitution)],
            [first * (1 + restitution), second - restitution * first],
        ]
    )
    return factor / (first + second) * sp.Matrix([v, w])


def eq07():
    after = matrix(m1, m2, e, v1, v2)
    ratio = m1 / m2
    other = sp.Matrix([[ratio - e, 1 + e], [ratio * (1 + e), 1 - e * ratio]]) / (ratio + 1) * sp.Matrix([v1, v2])
    return laws_hold(m1, m2, e, v1, v2, *after) and all(zero(entry) for entry in after - other)


def eq12():
    w = mu * (1 + e2) / (mu + m2) * m1 * (1 + e1) / (m1 + mu) * v1
    return zero(w - (1 + e1) * (1 + e2) * m1 * mu / ((m1 + mu) * (mu + m2)) * v1) and zero(
        m2 * w**2 / 2 - ETA13 * m1 * v1**2 / 2
    )


def eq24_step():
    gain = x * (1 + e) / (x + 1)
    return zero(sp.simplify(gain * gain**n / gain ** (n + 1)) - 1)


def eq25():
    # With m1 = a^(n+1), m2 = b^(n+1), so that the ratio is a/b.
    a, b = sp.symbols("a b", positive=True)
    number = n + 1
    speed = (a / b * (1 + e) / (a / b + 1)) ** number * v1
    share_handed_on = b**number * speed**2 / (a**number * v1**2)
    printed = (1 + e) ** (2 * number) * a**number * b**number / (a + b) ** (2 * number)
    return zero(sp.powsimp(sp.expand_power_base(sp.simplify(share_handed_on / printed), force=True)) - 1)


def u1():
    after = matrix(m1, m2, e, v1, v2)
    return zero(after[1] - after[0] + e * (v2 - v1)) and zero(
        m1 * v1 + m2 * v2 - (m1 + m2) * after[0] + e * m2 * (v2 - v1)
    )


def u6():
    second = K1 * (
        (m1 * m2 - 3 * mu**2) * (m1 + mu) * (mu + m2) - 3 * mu * (m1 * m2 - mu**2) * (m1 + m2 + 2 * mu)
    ) / ((m1 + mu) ** 4 * (mu + m2) ** 4)
    return zero(sp.diff(ETA13, mu, 2) - second)


ETA13 = (1 + e1) ** 2 * (1 + e2) ** 2 * m1 * m2 * mu**2 / ((m1 + mu) ** 2 * (mu + m2) ** 2)
K1 = 2 * (1 + e1) ** 2 * (1 + e2) ** 2 * m1 * m2
ETA9 = (1 + e) ** 2 * x / (1 + x) ** 2
CHECKS = {
    "eq05, eq06": laws,
    "eq08": lambda: zero(m2 * (m1 * (1 + e) / (m1 + m2)) ** 2 / m1 - (1 + e) ** 2 * m1 * m2 / (m1 + m2) ** 2),
    "eq09": lambda: zero((1 + e) ** 2 * m1 * m2 / (m1 + m2) ** 2 - ETA9.subs(x, m1 / m2)),
    "eq13": lambda: zero(share(m1, mu, m2) - ETA13),
    "eq16": lambda: zero(
        share(m1, mu1, mu2, m2)
        - (1 + e1) ** 2 * (1 + e2) ** 2 * (1 + e3) ** 2 * m1 * m2 * mu1**2 * mu2**2
        / ((m1 + mu1) ** 2 * (mu1 + mu2) ** 2 * (mu2 + m2) ** 2)
    ),
    "eq23": lambda: zero((m1 - e * mu1) / (m1 + mu1) - (m1 / mu1 - e) / (m1 / mu1 + 1)),
    "eq22 step": lambda: zero(
        sp.powsimp(sp.expand_power_exp((x * (1 + e)) ** (i + 1) / (x + 1) ** (i + 2) - x * (1 + e) / (x + 1) * (x * (1 + e)) ** i / (x + 1) ** (i + 1)))
    ),
    "eq07": eq07,
    "eq12": eq12,
    "eq24 step": eq24_step,
    "eq25": eq25,
    "u1": u1,
    "u2": lambda: zero(
        m2 / 2 * (m1 * (1 + e) / (m1 + m2)) ** 2 * v1**2 - (1 + e) ** 2 * m1 * m2 / (m1 + m2) ** 2 * m1 * v1**2 / 2
    ),
    "u4": lambda: laws_hold(m1, mu, e1, v1, v2, *matrix(m1, mu, e1, v1, v2)),
    "u6": u6,
    "u3": lambda: zero(sp.diff(ETA9, x) - (1 + e) ** 2 * (1 - x) / (1 + x) ** 3),
    "u5": lambda: zero(sp.diff(ETA13, mu) - K1 * mu * (m1 * m2 - mu**2) / ((m1 + mu) ** 3 * (mu + m2) ** 3)),
    "u7": lambda: zero(
        16 * m1 * m2 / (sp.sqrt(m1) + sp.sqrt(m2)) ** 4 / (4 * m1 * m2 / (m1 + m2) ** 2)
        - 4 * (m1 + m2) ** 2 / (sp.sqrt(m1) + sp.sqrt(m2)) ** 4
    ),
}

if __name__ == "__main__":
    print(f"import sympy {sp.__version__}: {IMPORTED:.3f} s")
    for name, check in CHECKS.items():
        begin = time.perf_counter()
        result = check()
        print(f"{name:12} {'true' if result else 'NOT SHOWN':10} {time.perf_counter() - begin:.3f} s")
    print(f"total {time.perf_counter() - START:.3f} s")
