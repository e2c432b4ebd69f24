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
