"""Scalar answers against bounds from Python's own integers, and everything that is refused."""

from __future__ import annotations

import decimal
import doctest
import importlib
import math
import pickle
import random
import subprocess
import sys
from fractions import Fraction

import pytest

import carom


def digits_are_right(text: str, low: Fraction, high: Fraction, count: int) -> None:
    value = Fraction(text)
    unit = Fraction(1)
    while unit > value:
        unit /= 10
    while unit * 10 <= value:
        unit *= 10
    unit /= 10 ** (count - 1)
    # Both bounds round to it.
    assert abs(value - low) <= unit / 2 and abs(value - high) <= unit / 2


def test_the_documentation_strings_are_true():
    for name in ("carom", "carom.bounces", "carom.chain", "carom.table", "carom.audit", "carom.tools"):
        found = doctest.testmod(importlib.import_module(name))
        assert found.failed == 0 and found.attempted > 0, name


def test_exact_answers_are_fractions():
    assert carom.eta(64, 1, e="44/81", n=2) == Fraction(15625000000, 282429536481)
    assert carom.threshold(64, 1, n=2) == Fraction(44, 81)
    assert carom.helps(64, 1, e="44/81", n=2) == "exactly on the threshold"
    assert carom.masses(64, 1, e=1, n=2) == [64, 16, 4, 1]
    assert carom.velocities(3, 1, e="1/2", n=0, speed=2) == [Fraction(5, 4), Fraction(9, 4)]
    assert carom.losses(3, 1, e="1/2", n=0, speed=2) == [Fraction(9, 8)]
    assert carom.last_velocity(3, 1, e="1/2", n=0) == Fraction(9, 8)
    assert carom.eta(4, 1, e=1, masses=[2]) == Fraction(64, 81)
    assert carom.matrices(1, 1, e=1, n=0) == [[[0, 1], [1, 0]]]
    best = carom.best_n(64, 1, e="44/81")
    assert (int(best), best.tie) == (2, True)
    assert carom.best_n(2, 1, e=1).least == math.inf and carom.best_n(1, 1, e=1).least is None
    with pytest.raises(ValueError):
        int(carom.best_n(2, 1, e=1))


def test_a_condition_is_true_only_where_the_answer_is_yes():
    assert carom.helps(10, 1, e="9/10", n=2) and not carom.helps(10, 1, e="9/10", n=7)
    assert carom.recollides(2, 1, e="1/2", n=2) and not carom.recollides(64, 1, e="1/2", n=2)
    depends = carom.helps(10, 1, e="[0.1, 0.9]", n=1)
    threshold = carom.helps(64, 1, e="44/81", n=2)
    meets = carom.recollides("[9, 11]", 1, e="1/2", masses=["[2, 4]"])
    each = carom.helps(10, 1, e="9/10", masses=[5, 2])
    for unclear in (depends, threshold, meets, each, carom.Recollides.NOT_SETTLED):
        with pytest.raises(ValueError, match="compare with|all"):
            bool(unclear)
    # The former texts still compare, hash, print and come back from pickles.
    assert (depends, threshold, meets) == ("depends", "exactly on the threshold", "depends")
    assert depends != "yes" and {"depends": 1}[depends] == 1 and f"{depends} {depends!s}" == "depends depends"
    assert pickle.loads(pickle.dumps(threshold)) is carom.Helps.ON_THE_THRESHOLD


def test_given_masses_are_asked_about_themselves():
    assert carom.helps(10, 1, e="9/10", masses=[1000, "0.001"]) == (carom.Helps.NO, carom.Helps.NO)
    assert carom.threshold(10, 1, masses=[1000, "0.001"]) == [Fraction(100000001, 1000100), Fraction(999001, 1000)]
    rng = random.Random(11)
    seen = set()
    for _ in range(2000):
        a, b = Fraction(rng.randint(1, 60), rng.randint(1, 20)), Fraction(rng.randint(1, 60), rng.randint(1, 20))
        m = a + (b - a) * Fraction(rng.randint(-1, 9), 8)
        if m <= 0:
            continue
        (least,) = carom.threshold(a, b, masses=[m])
        e = rng.choice([least, Fraction(rng.randint(0, 40), 40)])
        if e > 1:
            continue
        (found,) = carom.helps(a, b, e=e, masses=[m])
        change = carom.eta(a, b, e=e, masses=[m]) - carom.eta(a, b, e=e, n=0)
        assert found == ("yes" if change > 0 else "no" if change < 0 else "exactly on the threshold"), (a, m, b, e)
        seen.add(found)
    assert len(seen) == 3
    measured = carom.Chain(10, 1, e="[0.7, 0.8]", masses=["[2, 5]"])
    (bounds,) = measured.threshold()
    assert Fraction(7, 11) in bounds and bounds.exact_hi >= Fraction(7, 11) and all(measured.helps())


def test_only_needed_inputs_are_asked_for():
    assert carom.Chain(64, 1, n=2).threshold() == Fraction(44, 81)
    assert carom.Chain(64, 1, n=2).masses() == [64, 16, 4, 1] == carom.masses(64, 1, n=2)
    part = carom.Chain(64, 1, e="44/81")
    assert int(part.best_n()) == 2 and part.n is None and repr(part) == "Chain(64, 1, e='44/81', speed=1)"
    assert pickle.loads(pickle.dumps(part)).best_n() == part.best_n()


def test_the_written_form_of_a_chain_makes_the_same_chain():
    for chain in (
        carom.Chain("0.1", Fraction(3, 7), e=["1/2", 1], n=1),
        carom.Chain("57.1 ± 0.1", 46, e="[0.84, 0.90]", masses=["50", 7], speed="3/2"),
        carom.Chain(3, 1, masses=["2"], e=1, velocities=[2, "-1/2", 0]),
    ):
        again = eval(repr(chain), {"Chain": carom.Chain})  # what is printed is Python
        assert repr(again) == repr(chain) and again.is_exact == chain.is_exact


def test_thousands_of_enclosures_contain_and_their_doubles_point_outwards(bounds):
    eta_bounds, threshold_bounds = bounds
    rng = random.Random(7)
    irrational = 0
    for _ in range(2000):
        r = Fraction(rng.randint(1, 10 ** rng.randint(1, 12)), rng.randint(1, 10 ** rng.randint(1, 6)))
        e, n = Fraction(rng.randint(0, 40), 40), rng.randint(0, 12)
        cases = [(carom.eta(r, 1, e=e, n=n), eta_bounds(r, e, n))]
        if n > 0:
            cases.append((carom.threshold(r, 1, n=n), threshold_bounds(r, n)))
        for found, (low, high) in cases:
            if isinstance(found, Fraction):
                assert low <= found <= high
                continue
            irrational += 1
            assert found.exact_lo <= low and high <= found.exact_hi, (r, e, n)
            assert Fraction(found.lo) <= found.exact_lo and found.exact_hi <= Fraction(found.hi)
            assert found.hi <= math.nextafter(math.nextafter(found.lo, math.inf), math.inf)
            assert found.lo <= float(found) <= found.hi
            assert found.exact_lo in found and found.exact_hi + 1 not in found
    assert irrational > 3000


def test_digits_are_right_in_every_direction(bounds):
    eta_bounds, _ = bounds
    x = carom.eta(10, 1, e="9/10", n=7)
    low, high = eta_bounds(Fraction(10), Fraction(9, 10), 7)
    for count in range(1, 41):
        digits_are_right(x.digits(count), low, high, count)
        assert Fraction(x.digits(count, rounding="down")) <= low < high <= Fraction(x.digits(count, rounding="up"))
    assert len(x.digits(50)) == 52
    assert x.digits(50)[:-2] in x.digits(5000)
    below, above = x.narrower(60)
    assert x.exact_lo <= below < above <= x.exact_hi and above - below < Fraction(1, 10**59)
    assert float(x) == float(Fraction(x.digits(60)))


def test_velocities_are_enclosed_each_with_its_own_digits():
    chain = carom.Chain(10, 1, e="9/10", n=3)
    found = chain.velocities()
    assert len(found) == 5 and isinstance(found[4], carom.Enclosure)
    # The last one squared, times the ratio of masses, is the energy's share.
    low, high = found[4].narrower(60)
    share = chain.eta().narrower(60)
    assert low**2 / 10 <= share[1] and share[0] <= high**2 / 10
    again = pickle.loads(pickle.dumps(found[4]))
    assert again.digits(30) == found[4].digits(30) and again.exact_lo == found[4].exact_lo
    assert pickle.loads(pickle.dumps(chain)).eta().digits(20) == chain.eta().digits(20)
    assert found[4].radical and "\\frac" in found[4]._repr_latex_()


def test_best_numbers_are_ordered_where_they_are_one_number():
    best = carom.best_n(100, 1, e="0.9")
    assert 2 < best > 2 and best >= best and best < math.inf and not best <= 2
    assert sorted([best, carom.best_n(10, 1, e="0.9")])[1] is best and carom.best_n(2, 1, e=1) > 10**9
    assert carom.best_n(10, 1, e="[0.5, 0.9]") >= 0
    for open_ in (carom.best_n(10, 1, e="[0.5, 0.9]"), carom.best_n(1, 1, e=1)):
        with pytest.raises(carom.Undecided, match="is open"):
            bool(open_ > 1)
    with pytest.raises(TypeError):
        bool(best < "a")


def test_measured_inputs_give_wide_enclosures():
    x = carom.eta("57.1 ± 0.1", 46, e="[0.84, 0.90]", n=0)
    assert x.measured and x.lo < x.hi
    for m1 in ("57.0", "57.2"):
        for e in ("0.84", "0.9"):
            assert carom.eta(m1, 46, e=e, n=0) in x
    with pytest.raises(ValueError, match="do not round"):
        x.digits(10)
    with pytest.raises(ValueError, match="nearest double; float\\(x.mid\\) is its middle"):
        float(x)
    assert carom.helps(10, 1, e="[0.1, 0.9]", n=1) == "depends"
    best = carom.best_n(10, 1, e="[0.5, 0.9]")
    assert best.least < best.greatest
    assert "\\;" in x._repr_latex_()


def test_numbers_go_in_exactly():
    same = carom.eta(10, 1, e=Fraction(1, 2), n=0)
    for e in ("1/2", "0.5", "5e-1", Fraction(2, 4), decimal.Decimal("0.50")):
        assert carom.eta(10, 1, e=e, n=0) == same
    assert carom.eta(10, 1, e=["1/2"], n=0) == same
    assert carom.Chain(4, 1, e=["1/2", 1], n=1).eta() == carom.Chain(4, 1, e=(Fraction(1, 2), "1"), n=1).eta()
    for value in (0.5, float("nan"), float("inf")):
        with pytest.raises(ValueError, match="is not exact"):
            carom.eta(10, 1, e=value)
    with pytest.raises(ValueError, match='write "9/10", or Fraction'):
        carom.eta(10, 1, e=0.9)
    numpy = pytest.importorskip("numpy")
    assert carom.eta(numpy.int64(10), 1, e="1/2", n=numpy.int32(0)) == same
    with pytest.raises(ValueError, match="is not exact"):
        carom.eta(numpy.float32(10), 1, e="1/2")


@pytest.mark.parametrize(
    ("call", "sign"),
    [
        (lambda: carom.eta("ten", 1, e=1), "m1"),
        (lambda: carom.eta(10, 0, e=1), "m2"),
        (lambda: carom.eta(10, 1, e="1.5"), "e"),
        (lambda: carom.eta(10, 1, e=[1, 1], n=0), "coefficients of restitution"),
        (lambda: carom.eta(10, 1, e=1, n=-1), "n: -1 is no natural number"),
        (lambda: carom.eta(10, 1, e=1, n="7"), "n: '7' is no natural number"),
        (lambda: carom.eta(10, 1, e=1, n=2.0), "natural number"),
        (lambda: carom.eta(10, 1, e=True), "True is not a number"),
        (lambda: carom.eta(None, 1, e=1), "None is not a number"),
        (lambda: carom.eta(10, 1, e=1, masses="2"), "a list is expected"),
        (lambda: carom.eta(10, 1, e=1, n=1, masses=[1, 2]), "do not agree"),
        (lambda: carom.eta("[2, 1]", 1, e=1), "above its upper end"),
        (lambda: carom.threshold(10, 1, n=0), "n >= 1"),
        (lambda: carom.Chain(10, 1, e=1, speed=1, velocities=[1, 0]), "cannot be combined"),
        (lambda: carom.Chain(10, 1, e=1, masses=[], velocities=[1]), "velocities"),
        (lambda: carom.eta(10, 1, e="9/10", n=7).digits(0), "no significant digit"),
        (lambda: carom.eta(10, 1, e="9/10", n=7).digits(5, rounding="sideways"), "sideways"),
        (lambda: carom.helps(10, 1, e=["1/2", "1/3"], n=1), "helps"),
        (lambda: carom.eta("\x00\u202e1", 1, e=1), "m1"),
        (lambda: carom.eta(10, 1, e=1), "eta needs n, the number of inserted bodies"),
        (lambda: carom.velocities(10, 1, e=1), "velocities needs n"),
        (lambda: carom.Chain(10, 1, n=2).recollides(), "recollides needs e, the coefficient"),
        (lambda: carom.Chain(10, 1).threshold(), "threshold needs n"),
        (lambda: carom.Chain(10, 1, e=1, masses=[3]).best_n(), "bodies of optimal mass"),
    ],
)
def test_bad_input_is_a_value_error_with_the_program_s_message(call, sign):
    with pytest.raises(ValueError, match=sign):
        call()


@pytest.mark.parametrize(
    "call",
    [
        lambda: carom.eta(10, 1, e=1, n=10**19),
        lambda: carom.eta(10, 1, e=1, n=10**40),
        lambda: carom.eta("1e99999", 1, e=1),
        lambda: carom.eta(10**5000, 1, e=1),
        lambda: carom.eta(10, 1, e="9/10", n=7).digits(10**12),
        lambda: carom.velocities(10, 1, e="9/10", n=10**9),
        lambda: carom.eta(10, 1, e="9/10", n=10**15).exact_lo,
    ],
)
def test_limits_are_an_exception_of_their_own(call):
    assert not issubclass(carom.LimitReached, ValueError)
    with pytest.raises(carom.LimitReached, match="."):
        call()


def test_numbers_beyond_doubles_are_still_enclosed():
    tiny = carom.eta(10, 1, e="1/2", n=10**4)
    assert 0 <= tiny.lo <= tiny.hi and tiny.digits(3).count("e-") == 1
    assert carom.eta(10, 1, e="1/2", n=10**15).lo == 0.0 and carom.eta(10, 1, e="1/2", n=10**15).hi == 5e-324
    huge = carom.velocities("1e400", "1e-400", e=1, n=1)[1]
    assert not isinstance(huge, Fraction) or huge > 0


def test_long_exact_answers_have_no_limit_of_their_digits():
    chain = carom.Chain(3, 1, e="7/9", masses=[k for k in range(2, 3000)])
    exact = chain.last_velocity()
    assert isinstance(exact, Fraction) and exact.denominator.bit_length() > 15_000


def test_wrong_types_are_type_errors_and_value_errors():
    for wrong in (
        lambda: carom.eta(None, 1, e=1, n=0),
        lambda: carom.eta(1, 1, e=0.5, n=0),
        lambda: carom.eta(1, 1, e=1, n="2"),
    ):
        with pytest.raises(TypeError):
            wrong()
        with pytest.raises(ValueError):
            wrong()
    for infinite in ("inf", "nan"):
        with pytest.raises(ValueError, match="finite"):
            carom.eta(1, 1, e=decimal.Decimal(infinite), n=0)


def test_the_quick_way_answers_as_the_chain_does():
    random.seed(11)
    for _ in range(300):
        m1, m2 = random.randrange(1, 10**9), Fraction(random.randrange(1, 99), random.randrange(1, 99))
        e, n = random.choice(["1/2", "0.9", Fraction(7, 9), 1]), random.randrange(0, 30)
        quick, chain = carom.eta(m1, m2, e=e, n=n), carom.Chain(m1, m2, e=e, n=n).eta()
        assert quick.exact == chain.exact and quick.digits(30) == chain.digits(30) and quick.radical == chain.radical
        assert quick.lo <= quick.exact_lo <= quick.exact_hi <= quick.hi and math.nextafter(quick.lo, 2) >= quick.hi
        again = pickle.loads(pickle.dumps(quick))
        assert again.digits(20) == quick.digits(20)
    huge = carom.eta(10**40, 1, e="1/2", n=3)
    assert huge.digits(5) == carom.Chain(10**40, 1, e="1/2", n=3).eta().digits(5)


def test_a_best_number_is_equal_to_its_integer():
    best = carom.best_n(10, 1, e="9/10")
    assert best == int(best) and best != int(best) + 1 and best == carom.best_n(10, 1, e="9/10")
    assert carom.best_n(2, 1, e=1) != 1 and len({best, carom.best_n(10, 1, e="9/10")}) == 1


def test_numbers_are_shown_without_a_formula_engine():
    shown = carom.eta(10, 1, e="9/10", n=7)._repr_html_()
    assert shown.startswith("<math") and shown.endswith("≈ 0.37313751177373857462") and "$" not in shown
    assert carom.eta("57.1 ± 0.1", 46, e="0.9", n=0)._repr_html_().startswith("[0.")
    tiny = carom.eta(10, 1, e=0, n=1000)
    assert " × 10<sup>-" in tiny._repr_html_()


def test_many_digits_end_at_once_when_interrupted():
    code = (
        "import carom, signal, time\n"
        "x = carom.eta(10, 1, e='9/10', n=7)\n"
        "signal.signal(signal.SIGALRM, signal.default_int_handler)\n"
        "signal.setitimer(signal.ITIMER_REAL, 0.5)\n"
        "begin = time.monotonic()\n"
        "try:\n    x.digits(10**7)\n"
        "except KeyboardInterrupt:\n    print(time.monotonic() - begin, flush=True)\n"
        "import os; os._exit(0)\n"
    )
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=300)
    assert float(out.stdout) < 2, out


def test_bodies_that_all_move_are_asked_as_the_chain_asks_them() -> None:
    given: dict = {"e": ["1/2", "3/4"], "masses": [3], "velocities": [4, "1/2", -1]}
    chain = carom.Chain(2, 1, **given)
    assert carom.velocities(2, 1, **given) == chain.velocities()
    assert carom.last_velocity(2, 1, **given) == chain.velocities()[-1]
    assert carom.losses(2, 1, **given) == chain.losses()
    momentum = sum(m * v for m, v in zip([2, 3, 1], chain.velocities()))
    assert momentum == Fraction(17, 2)
    for wrong in ({"speed": 1}, {"velocities": [1, 0]}):
        with pytest.raises(ValueError):
            carom.velocities(2, 1, **{**given, **wrong})
