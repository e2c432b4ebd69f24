"""One result type: arithmetic that encloses, comparisons that refuse what is open, formats, other libraries."""

from __future__ import annotations

import copy
import decimal
import math
import pickle
import random
import re
import statistics
from fractions import Fraction

import pytest

import carom


def step_of(step, a, k, power):
    """One operation, the same for a result and for a fraction."""
    return [lambda: a + k, lambda: k - a, lambda: a * k, lambda: a**power, lambda: abs(a), lambda: a * a - a][step]()


def test_every_result_has_the_same_attributes():
    for x in (carom.eta(64, 1, e="44/81", n=2), carom.eta(10, 1, e="9/10", n=7), carom.eta(10, 1, e="0.9 ± 0.01", n=0)):
        assert isinstance(x, carom.Number) and x.lo <= x.hi and Fraction(x.lo) <= x.exact_lo <= x.exact_hi
        assert x.exact is None or x.exact_lo == x.exact == x.exact_hi
        assert x.measured or x.digits(12)
    exact = carom.eta(64, 1, e="44/81", n=2)
    assert isinstance(exact, Fraction) and repr(exact) == "Fraction(15625000000, 282429536481)"
    assert exact.digits(5) == "0.055324" and hash(exact) == hash(Fraction(exact)) and {exact: 1}[Fraction(exact)] == 1
    for x in (exact, carom.eta(10, 1, e="9/10", n=7), carom.eta(10, 1, e="9/10", n=7) * 2):
        for again in (pickle.loads(pickle.dumps(x)), copy.deepcopy(x)):
            assert type(again) is type(x) and again.digits(30) == x.digits(30)


def test_arithmetic_never_leaves_the_true_value_outside():
    rng = random.Random(20261122)
    root = carom.masses(2, 1, n=1)[1]
    for _ in range(300):
        # sqrt(2) with 200 digits, independent of the engine.
        true = Fraction(math.isqrt(2 * 10**400), 10**200)
        x, value = root, true
        for _ in range(rng.randint(1, 5)):
            k = Fraction(rng.randint(-9, 9), rng.randint(1, 9))
            power = rng.choice([-2, -1, 0, 1, 2, 3])
            if value == 0:
                break
            step = rng.randrange(6)
            x, value = step_of(step, x, k, power), step_of(step, value, k, power)
        slack = Fraction(1, 10**150) * (abs(value) + 1)
        assert x.exact_lo - slack <= value <= x.exact_hi + slack
        lo, hi = x.narrower(40)
        assert lo - slack <= value <= hi + slack
        if value and x.exact is None:
            assert hi - lo <= abs(value) * Fraction(1, 10**38), (x, value)
            assert abs(Fraction(x.digits(30)) - value) <= abs(value) * Fraction(1, 10**29)


def test_a_measured_result_shows_a_centre_and_a_reach_that_hold_all_its_values():
    for e, n in (("0.9 ± 0.01", 7), ("[0.1, 0.9]", 0), ("0.5 ± 0.0000001", 3)):
        share = carom.eta(10, 1, e=e, n=n)
        for x in (share, -share, share * 10**30, share / 10**30, share - share):
            centre, reach = re.sub(r"[()]|e.*", "", str(x)).split(" ± ")
            scale = Fraction("1e" + str(x).partition(")e")[2]) if ")e" in str(x) else 1
            lo, hi = ((Fraction(centre) + sign * Fraction(reach)) * scale for sign in (-1, 1))
            assert lo <= x.exact_lo < x.exact_hi <= hi and hi - lo < 3 * (x.exact_hi - x.exact_lo), (x, repr(x))
            assert x.mid - x.radius == x.exact_lo and x.mid + x.radius == x.exact_hi
    assert str(carom.eta("10 ± 0.1", 1, e="9/10", n=2)) == "0.4775 ± 0.0018"


def test_a_number_less_itself_is_zero():
    x = carom.eta(10, 1, e="9/10", n=7)
    assert x - x == 0 and not x - carom.eta(10, 1, e="9/10", n=7) and isinstance(x - x, Fraction)


def test_messages_name_the_type_that_is_shown():
    x = carom.eta(10, 1, e="9/10", n=7)
    for number in (x, 2 * x):
        with pytest.raises(AttributeError, match="'Enclosure' object"):
            number.nothing()
        with pytest.raises(TypeError, match="0.5 is not exact; write"):
            bool(number + 0.5)
        assert str(pickle.loads(pickle.dumps(number))) == str(number)


def test_zero_has_no_sign():
    lo = carom.velocities("[1, 2]", 1, e="[0.5, 1]", masses=[1])[0].lo
    assert math.copysign(1, lo) == 1


def test_measured_results_stay_ranges():
    x = carom.eta(10, 1, e="[0.8, 0.9]", n=0)
    assert x.measured and (x - x).exact_lo < 0 < (x - x).exact_hi and (2 * x).exact_hi == 2 * x.exact_hi
    assert x < 1 and not x > 1
    with pytest.raises(carom.Undecided):
        bool(x < (x.exact_lo + x.exact_hi) / 2)
    with pytest.raises(carom.Undecided):
        x.digits(5)


def test_comparisons_are_decided_or_refused():
    a, b = carom.eta(10, 1, e="9/10", n=2), carom.eta(10, 1, e="9/10", n=1)
    assert a > b and b < a and a >= b and a != b and not a == b and a > 0 and a < 1 and sorted([a, b]) == [b, a]
    assert a < 0.9 < a + 1 and a != "a" and a == a and a < math.inf and not a == math.nan
    # Far closer than doubles tell.
    near = Fraction(a.digits(40, rounding="down"))
    assert a > near and a < near + Fraction(1, 10**40) and float(a) == float(near)
    root = carom.masses(2, 1, n=1)[1]
    two = root * root
    for open_ in (lambda: two < 2, lambda: math.floor(two), lambda: bool(two - 2)):
        with pytest.raises(carom.Undecided):
            open_()
    assert issubclass(carom.Undecided, ValueError)
    with pytest.raises(TypeError):
        a + 0.5
    with pytest.raises(TypeError):
        assert a < "1"
    with pytest.raises(ZeroDivisionError):
        a / 0
    with pytest.raises(carom.Undecided):
        1 / (two - 2)
    with pytest.raises(TypeError):
        a**0.5


def test_equality_never_raises_and_says_where_nothing_tells():
    a, again = carom.eta(10, 1, e="9/10", n=7), carom.eta(10, 1, e="9/10", n=7)
    assert a == again and not a != again and hash(a) == hash(again) and {a: 1}[again] == 1
    assert a != carom.eta(10, 1, e="9/10", n=6) and carom.eta(10, 1, e="[0.8, 0.9]", n=0) != a
    root = carom.masses(2, 1, n=1)[1]
    with pytest.warns(carom.UndecidedWarning, match="is open"):
        assert not root * root == 2


def test_sums_of_many_terms_and_parts_that_occur_often():
    y = carom.eta(10, 1, e="9/10", n=7)
    assert sum([y] * 10_000).digits(30) == (y * 10_000).digits(30)
    x = y
    for _ in range(10):
        x = x * (1 - x) * 3
    assert x.digits(40) and 0 < x < 1


def test_formats_without_a_number_of_digits_have_six():
    x, measured = carom.eta(10, 1, e="9/10", n=7), carom.eta(10, 1, e="[0.8, 0.9]", n=0)
    assert f"{x:f}" == "0.373138" and f"{x:g}" == "0.373138" and f"{x:e}" == "3.731375e-1" and f"{x:%}" == "37.313751%"
    assert f"{x:>30}" == str(x).rjust(30) and f"{measured:>60}" == str(measured).rjust(60)
    with pytest.raises(carom.Undecided) as refused:
        f"{measured:.30f}"
    assert len(str(refused.value)) < 300


def test_broken_powers_of_fractions_are_exact():
    four, two = carom.eta(1, 1, e=1, n=0) * 4, carom.eta(1, 1, e=1, n=0) * 2
    assert repr(four ** Fraction(1, 2)) == "Fraction(2, 1)"
    assert (two ** Fraction(1, 2)).digits(30) == "1.41421356237309504880168872421"


def test_means_and_deviations_of_results():
    shares = [carom.eta(10, 1, e="9/10", n=n) for n in range(8)]
    floats = [float(share) for share in shares]
    assert carom.mean(shares).digits(15) == f"{statistics.mean(floats):.15f}"
    assert abs(float(carom.stdev(shares)) - statistics.stdev(floats)) < 1e-15
    assert carom.mean([1, Fraction(1, 2)]) == Fraction(3, 4) and carom.stdev([1, 2, 3]) == 1
    assert carom.mean(share * k for k, share in enumerate(shares * 500)).digits(30)
    exact = carom.eta(64, 1, e="44/81", n=2)
    assert statistics.mean([exact, 2 * exact]) == 3 * exact / 2
    for function in (statistics.mean, statistics.stdev):
        with pytest.raises(TypeError, match="carom.mean and carom.stdev take any results"):
            function(shares)
    with pytest.raises(ValueError, match="at least one"):
        carom.mean([])
    with pytest.raises(ValueError, match="at least two"):
        carom.stdev(shares[:1])
    with pytest.raises(carom.WrongType, match="0.5"):
        carom.mean([0.5])


def test_roots_of_results_hold_the_true_value():
    share = carom.eta(10, 1, e="9/10", n=7)
    for power in (Fraction(1, 2), Fraction(1, 3), Fraction(5, 2), Fraction(-3, 2)):
        lo, hi = (share**power).narrower(60)
        below, above = sorted(end**power.denominator for end in (lo, hi))
        true = (share**power.numerator).narrower(200)
        assert below <= true[0] and true[1] <= above and hi - lo < Fraction(1, 10**55)
    assert share.sqrt().digits(25) == "0.6108498275138813318818770"
    assert carom.eta(64, 1, e="44/81", n=2).sqrt() == Fraction(125000, 531441)
    measured = carom.eta(10, 1, e="[0.8, 0.9]", n=0)
    lo, hi = measured.sqrt().exact_lo, measured.sqrt().exact_hi
    assert lo**2 <= measured.exact_lo and measured.exact_hi <= hi**2 and hi - lo < measured.exact_hi - measured.exact_lo
    with pytest.raises(ValueError, match="no real root"):
        (share - 1).sqrt()


def test_formats_are_right_in_every_digit():
    x = carom.eta(10, 1, e="9/10", n=7)
    assert f"{x:.5g}" == "0.37314" and f"{x:.3f}" == "0.373" and f"{x:.2%}" == "37.31%" and f"{x:>8.3f}" == "   0.373"
    assert f"{x:.3e}" == "3.731e-1" and f"{x}" == str(x) and f"{x:.40f}"[:25] == x.digits(23, rounding="down")
    third = carom.eta(3, 1, e=1, n=0)  # 3/4
    assert f"{third:.1f}" == "0.8" and f"{third:.3f}" == "0.750" and round(third, 1) == Fraction(4, 5)
    assert round(x, 3) == Fraction(373, 1000) and round(x) == 0 and int(x * 10) == 3 and math.ceil(x) == 1
    for places in range(0, 60, 7):
        assert f"{carom.eta(2, 1, e=1, n=0) / 7:.{places}f}" == f"{decimal_of(Fraction(8, 63)):.{places}f}"


def decimal_of(number: Fraction) -> decimal.Decimal:
    with decimal.localcontext() as context:
        context.prec = 200
        return decimal.Decimal(number.numerator) / decimal.Decimal(number.denominator)


def test_other_numbers_go_in_and_come_out():
    x, exact = carom.eta(10, 1, e="9/10", n=7), carom.eta(64, 1, e="44/81", n=2)
    assert x.to_decimal(10) == decimal.Decimal("0.3731375118") and exact.to_fraction() == exact
    with pytest.raises(carom.Undecided):
        x.to_fraction()
    # A result as an input: an exact one as such, any other as a range that holds it.
    masses = carom.masses(10, 1, n=2)
    again = carom.eta(10, 1, e="9/10", masses=masses[1:-1])
    assert again.measured and again.exact_lo <= carom.eta(10, 1, e="9/10", n=2).exact_lo <= again.exact_hi
    assert carom.eta(64, 1, e=1, masses=carom.masses(64, 1, n=2)[1:-1]).exact is not None
    with pytest.raises(ValueError, match="float"):
        carom.eta(10, 1, e=(0.8, "0.9"), n=0)


def test_mpmath_sympy_and_flint():
    x, exact = carom.eta(10, 1, e="9/10", n=1), carom.eta(64, 1, e="44/81", n=2)
    mpmath = pytest.importorskip("mpmath")
    interval = x.to_mpmath()
    assert interval.a <= mpmath.iv.mpf(x.digits(30)).b and mpmath.mpf(x) == mpmath.mpf(float(x))
    assert carom.eta(10, 1, e=mpmath.iv.mpf(["0.5", "0.75"]), n=0).measured
    sympy = pytest.importorskip("sympy")
    assert sympy.sympify(exact) == sympy.Rational(exact.numerator, exact.denominator)
    closed = sympy.sympify(x)
    assert not closed.has(sympy.Float) and str(sympy.N(closed, 40))[:30] == x.digits(40)[:30]
    assert carom.eta(10, 1, e=sympy.Rational(1, 2), n=0) == carom.eta(10, 1, e="1/2", n=0)
    flint = pytest.importorskip("flint")
    assert x.to_flint().overlaps(flint.arb(x.digits(40))) and exact.to_flint() == flint.fmpq(15625000000, 282429536481)
    assert carom.eta(10, 1, e=flint.fmpq(1, 2), n=0) == carom.eta(10, 1, e="1/2", n=0)
    assert carom.eta(10, 1, e=flint.arb("0.5", "0.01"), n=0).measured
    x = carom.eta(10, 1, e="9/10", n=2)
    half = flint.fmpq(1, 2)
    assert str(x + half) == str(half + x) == str(x + Fraction(1, 2)) and x < flint.fmpz(1)


def test_operators_give_the_digits_of_flint():
    flint = pytest.importorskip("flint")
    flint.ctx.prec = 4000
    rng = random.Random(33)
    shares = [carom.eta(10, 1, e="9/10", n=n) for n in (2, 3, 7)] + [carom.masses(2, 1, n=1)[1]]
    balls = [flint.arb(x.digits(1100)) for x in shares]
    for _ in range(120):
        pool = list(zip(shares, balls))
        for _ in range(8):
            (x, a), (y, b) = rng.choice(pool), rng.choice(pool)
            k = rng.randint(-5, 5)
            step = rng.randrange(8)
            if step == 0:
                pool.append((x + y, a + b))
            elif step == 1 and x is not y:
                pool.append((x - y, a - b))
            elif step == 2:
                pool.append((x * y, a * b))
            elif step == 3 and not b.contains(0):
                pool.append((x / y, a / b))
            elif step == 4 and not (k <= 0 and a.contains(0)):
                pool.append((x**k, a**k))
            elif step == 5:
                pool.append((abs(x), abs(a)))
            elif step == 6 and not a.contains(0):
                pool.append((abs(x).sqrt(), abs(a).sqrt()))
            elif step == 7:
                pool.append((k - x * k, k - a * k))
        for x, a in pool:
            if a.contains(0):
                continue
            lo, hi = x.narrower(60)
            true = a.mid().fmpq()
            value, slack = (
                Fraction(int(true.p), int(true.q)),
                Fraction(1, 10**900) * (1 + abs(int(true.p) // int(true.q))),
            )
            assert lo - slack <= value <= hi + slack and hi - lo <= abs(value) * Fraction(1, 10**58)
            assert x.digits(40) == carom.Number.digits(x, 40)


def test_numbers_of_very_different_sizes_keep_their_digits():
    x = carom.eta(10, 1, e="9/10", n=7)
    small = x / 10**20_000
    assert (small * 10**20_000).digits(40) == x.digits(40) and 0 < small < x
    assert (small + x).digits(40) == x.digits(40) and small.digits(5) == "3.7314e-20001"
    with pytest.raises(ZeroDivisionError):
        x / (x - x)
    root = carom.masses(2, 1, n=1)[1]
    with pytest.raises(carom.Undecided):
        x / (root * root - 2)


def test_what_is_written_down_is_computed_once():
    x = carom.eta(10, 1, e="9/10", n=7)
    for _ in range(200):
        # 2^200 paths lead to the first number.
        x = (x + x) / 2 * (3 - x) / 3
    assert 0 < x < 1 and len(x.digits(40)) >= 40
