"""Random claims about what the reader abbreviates or makes of whole numbers: floors, matrices, sequences, exponents."""

import re

from algebra import differentiated, number, put, read, show, spoiled, times
from maker import POLYNOMIAL, SMOOTH, given

FLOORS = (
    "floor(x) <= x", "x < floor(x) + 1", "floor(x + 1) = floor(x) + 1", "floor(x + n) = floor(x) + n", "ceil(x) >= x",
    "ceil(x) = -floor(-x)", "floor(2*x) >= 2*floor(x)", "floor(2*x) <= 2*floor(x) + 1", "floor(n/2) <= n/2",
    "floor(x) = x", "ceil(x) - floor(x) <= 1", "floor(x + y) >= floor(x) + floor(y)", "floor(n) = n", "floor(k) = k",
    "ceil(k/2) >= k/2", "floor(x)^2 <= x^2", "floor(x^2) >= 0", "floor(sin(theta)) <= 1",
    "floor(sin(theta) + 2) >= 1", "floor(-x) = -floor(x)", "floor(x) + floor(-x) >= -1", "floor(floor(x)) = floor(x)",
    "ceil(floor(x)) = floor(x)", "floor(max(x, 0)) >= 0", "floor(|x|) >= 0", "(-1)^floor(x) <= 1", "floor(7/2) = 3",
    "floor(-7/2) = -4", "ceil(7/2) = 4", "floor(x/2) <= floor(x)", "floor_1 = floor(x)", "floor(floor_1) <= floor_1",
    "x - floor(x) < 1", "x^floor(2) = x^2", "floor(cos(theta/2)) <= 1", "floor(x)*y <= x*y",
    "floor(x) >= floor_1 - floor_1", "ceil(x) >= floor(x)",
)  # fmt: skip


def floors(m):
    text = m.pick(FLOORS)
    reals = ("real", "real", "real", ">= 0", "in [0, 1]", "in (-1, 1)", "integer")
    domains = {
        "x": m.pick(reals),
        "y": "real",
        "floor_1": m.pick(("real", "natural")),
        "theta": "real",
        "n": "natural",
        "k": "integer",
    }
    names = [n for n in dict.fromkeys(re.findall(r"\w+", text)) if n in domains]
    declared = given(*(f"{n} {domains[n]}" for n in names))
    if m.chance(0.08) and "x" in names:
        goal = m.pick(("x >= 2", "x < 1", "x < 3", "x > -2", "ceil(x) <= 3", "floor(x + 1) = 3"))
        return declared + [f"assume floor(x) = {m.pick(('2', '0', '-1'))}", f"prove {goal}"]
    if not m.is_true:
        text = m.rewritten(text)
    if m.chance(0.15) and "floor(x)" in text:
        return declared + ["let h = floor(x)", f"prove {text.replace('floor(x)', 'h')}"]
    return declared + [f"prove {text}"]


ROTATION = "[cos(theta), -sin(theta); sin(theta), cos(theta)]"
MATRICES = (
    ("a, b real", "[a, b; 0, 1]^2 = [a^2, a*b + b; 0, 1]"),
    ("a real; n natural", "[1, a; 0, 1]^n = [1, n*a; 0, 1]"),
    ("a real", "[1, a; 0, 1]^3 = [1, 3*a; 0, 1]"),
    ("a, b real", "trace([a, b; b, a]^2) = 2*a^2 + 2*b^2"),
    ("a, b, c, d real", "det([a, b; c, d]^2) = (a*d - b*c)^2"),
    ("theta real", ROTATION + "^2 = [cos(2*theta), -sin(2*theta); sin(2*theta), cos(2*theta)]"),
    ("theta real", f"det({ROTATION}^3) = 1"),
    ("theta real", ROTATION + "^-1 = [cos(theta), sin(theta); -sin(theta), cos(theta)]"),
    ("a, b > 0", "[a, 0; 0, b]^-1 = [1/a, 0; 0, 1/b]"),
    ("a, b real", "[a, 0; 0, b]^-1 = [1/a, 0; 0, 1/b]"),
    ("a, b > 0; n natural", "det([a, 0; 0, b]^n) = (a*b)^n"),
    ("a real; n natural", "trace([1, a; 0, 1]^n) = 2"),
    ("a, b real; n natural", "[a, 0; 0, b]^(n + 1) = [a^(n + 1), 0; 0, b^(n + 1)]"),
    ("a real", "derivative(trace([a, 1; 1, a]^2), a) = 4*a"),
    ("a real", "derivative(det([a, 1; 1, a]), a) = 2*a"),
    ("a real; n natural", "derivative(trace([1, a; 0, 1]^n), a) = 0"),
    ("a real; n natural", "derivative(det([a, 0; 0, 1]^n), a) = n*a^n/a"),
    ("a real", "derivative(det([a, 0; 0, 1]^3), a) = 3*a^2"),
    ("theta real", "derivative(trace([cos(theta), 0; 0, 1]^2), theta) = -2*cos(theta)*sin(theta)"),
    ("theta real", f"derivative(det({ROTATION}), theta) = 0"),
    ("a > 1", "inverse([a, 1; 1, a])*[a, 1; 1, a] = [1, 0; 0, 1]"),
    ("a, b real", "[a, b; 0, 1]^0 = [1, 0; 0, 1]"),
    ("M_11 real; a real; n natural", "det([1, a; 0, 1]^n) = 1 and M_11*0 = 0"),
    ("n natural", "[0, 1; 1, 0]^(2*n) = [1, 0; 0, 1]"),
    ("n natural", "[2, 0; 0, 3]^n = [2^n, 0; 0, 3^n]"),
    ("theta real; n natural", f"det({ROTATION}^n) = 1"),
    ("a, b real", "transpose([a, b; 0, 1])^2 = [a^2, 0; a*b + b, 1]"),
    ("k integer; a real", "[1, a; 0, 1]^2 = [1, 2*a; 0, 1] and k^2 >= 0"),
)


def matrices(m):
    declared, goal = m.pick(MATRICES)
    lets = []
    found = re.search(r"\[[^\[\]]*\]", goal)
    if m.chance(0.4):
        lets = [f"let M = {found.group()}"]
        goal = goal.replace(found.group(), "M")
    if not m.is_true:
        goal = m.rewritten(goal)
    return given(*declared.split("; ")) + lets + [f"prove {goal}"]


INTEGERS = (
    ("k integer", "k^2 >= k"), ("k integer", "k*(k + 1) >= 0"), ("k integer", "k^2 >= 0"),
    ("k integer", "(-1)^(2*k) = 1"), ("k integer; x > 0", "x^k > 0"), ("k integer; x real", "x^(2*k) >= 0"),
    ("k integer >= 1", "k >= 1"), ("k integer", "k >= 0"), ("k integer in [-2, 2]", "k^2 <= 4"),
    ("k integer > 0", "k >= 1"), ("k integer", "k != 1/2"), ("n natural", "(-1)^(2*n) = 1"),
    ("n natural", "n^2 >= n"), ("n natural; i in 1..n", "i <= n"), ("i in 1..3", "i^2 <= 9"),
    ("n natural; i in 0..n", "i*(n - i) >= 0"), ("k integer; m integer", "(k - m)^2 >= k - m"),
    ("k integer; x > 0", "x^(k + 1) = x*x^k"), ("n natural", "sum(i = 1..n, i) = n*(n + 1)/2"),
    ("n natural", "sum(i = 0..n, 1) = n + 1"), ("n natural", "for all i in 1..n: i^2 >= i"),
    ("n natural >= 1", "exists i in 1..n: i = n"), ("n natural", "binomial(n, 2) = n*(n - 1)/2"),
    ("n natural", "binomial(n, 1) = n"), ("n natural", "(n + 1)! = (n + 1)*n!"),
    ("n natural", "binomial(n + 1, 2) = binomial(n, 2) + n"), ("", "5! = 120"),
    ("x real", "binomial(x, 2) = x*(x - 1)/2"), ("", "binomial(5, 2) = 10"),
    ("x, y real", "max(x, y) + min(x, y) = x + y"), ("x, y real", "max(x, y) >= x"),
    ("x, y real", "|x + y| <= |x| + |y|"), ("x, y real", "max(x, y) - min(x, y) = |x - y|"),
    ("x, y, z real", "max(x, y, z) >= (x + y + z)/3"), ("x real", "|x|^2 = x^2"), ("x real", "|x| >= x"),
    ("x real", "min(x, -x) <= 0"), ("x >= 0", "derivative(|x|, x) = 1"), ("x > 0", "derivative(|x|, x) = 1"),
    ("x > 0; y real", "derivative(max(x, -x)*y, x) = y"), ("x < 0", "derivative(|x|, x) = -1"),
    ("x real", "derivative(|x|, x)*|x| = x"), ("n natural", "product(i = 1..n, 2) = 2^n"),
    ("n natural; x real", "sum(i = 1..n, x) = n*x"), ("x real; n natural", "derivative(x^n, x)*x = n*x^n"),
    ("x real", "derivative(sum(i = 1..3, x^i), x) = 1 + 2*x + 3*x^2"), ("mu(k) > 0", "mu(1) + mu(2) > 0"),
    ("mu(k) in [0, 1]; n natural", "sum(i = 0..n, mu(i)) <= n + 1"),
    ("mu(k) real; x real", "derivative(mu(1)*x^2, x) = 2*mu(1)*x"),
    ("n natural; theta real", "(cos(theta)^2 + sin(theta)^2)^n = 1"),
    ("k integer; theta real", "cos(theta)^2 + k^2 >= sin(theta)^2 - 1"), ("k integer", "floor(k/2) + ceil(k/2) = k"),
    ("n natural", "n*(n - 1)*(n - 2) >= 0"), ("k integer", "|k| >= k"),
)  # fmt: skip


def whole_numbers(m):
    declared, goal = m.pick(INTEGERS)
    return given(*declared.split("; ")) + [f"prove {goal if m.is_true else m.rewritten(goal)}"]


def sequences(m):
    a = m.pick(("1", "2", "x", "cos(theta)", "x"))
    declared = {"x": "x real", "cos(theta)": "theta real"}.get(a, "")
    k = m.rng.randint(1, 4)
    fibonacci = times(number((0, 1, 1, 2, 3)[k]), read(a))
    return m.pick(
        (
            given(declared)
            + [f"define u by u(0) = {a}, u(k + 1) = 2*u(k)", f"prove u({k}) = {m.said(read(f'2^{k}*{a}'))}"],
            given(declared)
            + [f"define F by F(0) = 0, F(1) = {a}, F(k + 2) = F(k + 1) + F(k)", f"prove F({k}) = {m.said(fibonacci)}"],
            given(declared, "n natural")
            + [
                f"define u by u(0) = {a}, u(k + 1) = u(k) + 2",
                f"prove u(n) = {m.said(read(f'{a} + 2*n'))} by induction on n",
            ],
            given(declared, "n natural")
            + [
                f"define u by u(0) = {a}, u(k + 1) = -u(k)",
                f"prove u(n) = {m.said(read(f'(-1)^n*{a}'))} by induction on n",
            ],
            given(declared)
            + [f"define u by u(0) = {a}, u(k + 1) = u(k)^2 + k", f"prove u(2) = {m.said(read(f'({a})^4 + 1'))}"],
        )
    )


def exponents(m):
    """Whole exponents by their form, some of them beyond the machine's words."""
    e = m.pick(
        (
            "1e39",
            "1e38",
            "(2*10^38)",
            "(10^40)",
            "(1e40 + 1)",
            "2.00000000000000000000000000000000000000",
            "(2*10^38/10^38)",
            "(4/2)",
            "1e2",
            "(3*10^39/10^39)",
            "9223372036854775808",
            "(2^200)",
            "(1e39/1e39)",
            "(10^39 - 10^39)",
            "(1/2)",
            "0.5",
            "(-2)",
        )
    )
    return m.pick(
        (
            [f"prove (-1)^{e} = {m.pick(('1', '-1'))}"],
            ["given x real", f"prove x^{e} >= 0"],
            ["given x real", f"prove x^{e} = x^2"],
            ["given x < 0", f"prove x^{e} {m.pick(('> 0', '< 0'))}"],
            [f"prove 0^{e} = 0"],
            [f"prove 1^{e} = 1"],
            ["given x real; n natural", f"prove x^(2*n) {m.pick(('>= 0', '> 0', '= x^(n + n)'))}"],
            ["given x real", f"let p = {e}", "prove x^p = x^p"],
        )
    )


def quantified(m):
    e = m.template(SMOOTH, "x", m.pick((None, "a")))
    right = differentiated(e, "x")
    inner = show(put(e, {"x": ("name", "w")}))
    polynomial = show(m.template(POLYNOMIAL, "x"))
    domain = m.pick(("real", "> 0", "in [0, 1]", "in (0, 2)"))
    slope = m.pick(("a*t", "a*t^2", "t^2 + a", "a/t", "t^3"))
    value = m.pick(("a", "2*a", "2*a^2", "-1/a", "0", "3*a^2", "-1"))
    wanted = m.pick(("x^2 = a", "x > 2*a", "x*a = 1", "x < a", "x^2 > a", "derivative(a*x^2, x) = a"))
    return m.pick(
        (
            ["given a real", f"prove for all x > 0: derivative({show(e)}, x) = {m.said_or(right, '0')}"],
            [
                "given a real",
                f"let f(w) = {inner}",
                f"prove for all x > 0: derivative(f(x), x) = {m.said_or(right, '0')}",
            ],
            [f"prove exists x {domain}: {polynomial} {m.pick('==<>')} {m.rng.randint(-3, 6)}"],
            [f"prove for all x {domain}: {polynomial} {m.pick(('>=', '<=', '>'))} {m.rng.randint(-4, 3)}"],
            ["given a > 0", f"let f(t) = derivative({slope}, t)", f"prove f(a) = {value}"],
            [f"prove for all a > 0: exists x > {m.pick('0a')}: {wanted}"],
            [
                "given a > 0",
                f"prove exists t > 0: derivative({slope}, t) = {value}" + m.pick(("", " by witness t = a")),
            ],
            [
                "given a real",
                f"prove for all y in [a, a]: derivative({m.pick(('y', 'y*a', 'a^2'))}, a) = {m.pick('0y1')}",
            ],
            [f"prove (for all x {domain}: {polynomial} >= {m.pick('0123')}) and (exists x > 0: x^2 = {m.pick('02')})"],
        )
    )


def parameters(m):
    """Definitions whose parameters have names of the claim, and derivatives by a parameter, at a variable and elsewhere."""
    x, y = m.pick((("t", "a"), ("x", "k"), ("n_2", "n")))
    bodies = ("{b}*{a}^2", "{a}^2 + {b}", "{a}^3 - {b}*{a}", "cos({b}*{a})", "exp({a})*{b}", "c*{a}", "c + {b}*{a}")
    body = m.pick(bodies)
    # The parameter, and the name that stands free in the definition.
    parameter, other = m.pick(((x, y), (y, x), ("s", y)))
    slope = m.pick((x, "r"))
    lets = [
        f"let c = {x}*{y}",
        f"let f({parameter}) = {body.format(a=parameter, b=other)}",
        f"let g({m.pick((x, 'r'))}) = f({m.pick((x, y))}) + {x}",
        f"let v({slope}) = derivative(f({slope}), {slope})",
    ]
    goals = (
        f"f({x}) = {body.format(a=x, b=other)}",
        f"f({y}) = {body.format(a=x, b=y)}",
        f"g({x}) = f({x}) + {x}",
        f"g({y}) = f({x}) + {x}",
        f"g({y}) = f({y}) + {y}",
        f"v({x}) = derivative({body.format(a=x, b=y)}, {x})",
        f"v({y}) = derivative({body.format(a=y, b=x)}, {y})",
        f"v({x}) = f({x})",
        f"v({y}) = derivative(f({y}), {y})",
        "for all z real, w real: v(z) + w = derivative(f(z), z) + w",
    )
    more = m.pick(("", f"; {x} > 1", f"; {y} < 2, {x} >= {y}", ", q > 0"))
    return [f"given {x}, {y} real{more}", *lets, f"prove {m.pick(goals)}"]


def preamble(m):
    """Declarations and hypotheses before the claim, some of which it takes."""
    e = spoiled(read("sin(2*theta)"), m.rng) if not m.is_true else read("sin(2*theta)")
    shared, goals = m.pick(
        (
            (
                ["given theta in [0, pi/2]", "let c = cos(theta)", "assume c > 0"],
                [
                    "tan(theta) >= 0",
                    f"2*c*sin(theta) = {show(e)}",
                    "derivative(c, theta) = -sin(theta)",
                    "c >= 1",
                    "c <= 1",
                ],
            ),
            (
                ["given a, b > 0", "let s = a + b", "assume a > b"],
                ["s > 2*b", "s < 2*b", "derivative(s^2, a) = 2*s", "s >= a", "b > 1"],
            ),
            (
                ["given alpha, beta in (0, pi)", "assume alpha + beta = pi"],
                ["sin(alpha) = sin(beta)", "cos(alpha) = cos(beta)", "derivative(sin(alpha), alpha) = cos(alpha)"],
            ),
            (
                ["given x real", "let g = x*t"],
                [
                    "limit of g as t -> 2 is 2*x",
                    "limit of g as t -> 2 is 0",
                    "limit of derivative(g, t) as t -> 2 is x",
                ],
            ),
            (
                ["given k integer", "given x real", "assume x > k"],
                ["x >= floor(x)", "x > k - 1", "floor(x) >= k", "k >= 0"],
            ),
        )
    )
    return shared, [f"prove {m.pick(goals)}"]
