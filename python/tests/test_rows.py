"""eta of columns of numbers, row by row."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest

import carom

numpy = pytest.importorskip("numpy")


def test_thresholds_and_best_numbers_have_columns_as_eta_has():
    ratios = [64, 10, "1/3"]
    found = carom.threshold(ratios, 1, n=numpy.array([1, 2, 3]))
    best = carom.best_n(numpy.array([64.0, 10.0, 1.0]), 1, e=["44/81", "0.9", 1], floats="decimal")
    for row, (m1, n) in enumerate(zip(ratios, (1, 2, 3))):
        one = carom.threshold(m1, 1, n=n)
        assert (found.lo[row], found.hi[row]) == (one.lo, one.hi)
    assert list(best.lo) == [2, int(carom.best_n(10, 1, e="0.9")), 0] and best.hi[2] == numpy.inf
    with pytest.raises(carom.WrongType, match="row 1: .*0.5 is not exact"):
        carom.threshold([1, 0.5], 1, n=1)


def test_lists_and_columns_of_polars_are_columns():
    known = carom.eta(numpy.array([10, 20]), 1, e="0.9", n=2)
    assert (carom.eta([10, "20"], 1, e="0.9", n=[2, 2]).lo == known.lo).all()
    polars = pytest.importorskip("polars")
    assert (carom.eta(polars.Series([10, 20]), 1, e=polars.Series(["0.9", "0.9"]), n=2).lo == known.lo).all()


def test_a_missing_value_is_named_by_its_row():
    pandas = pytest.importorskip("pandas")
    for column in (pandas.Series([1, None], dtype="Int64"), [1, None], numpy.array([1.0, numpy.nan])):
        with pytest.raises(ValueError, match="row 1: m1: the value is missing"):
            carom.eta(column, 1, e="0.9", n=2)
        with pytest.raises(ValueError, match="row 1: n: the value is missing"):
            carom.eta(1, 1, e="0.9", n=column)


def test_each_row_is_enclosed_as_the_call_for_it_alone():
    random.seed(7)
    count = 400
    m1 = numpy.array([random.randrange(1, 10**6) for _ in range(count)])
    m2 = [Fraction(random.randrange(1, 1000), random.randrange(1, 1000)) for _ in range(count)]
    e = numpy.array([random.randrange(0, 1001) / 1000 for _ in range(count)])
    n = numpy.array([random.randrange(0, 12) for _ in range(count)])
    found = carom.eta(m1, numpy.array(m2, object), e=e, n=n, floats="decimal")
    assert len(found) == count and (found.hi - found.lo <= 2.0**-50 * found.lo).all()
    for row in range(count):
        alone = carom.eta(int(m1[row]), m2[row], e=repr(float(e[row])), n=int(n[row]))
        # Both hold the same number: two enclosures of it have a common point.
        assert found.lo[row] <= alone.hi and alone.lo <= found.hi[row], row
        if alone.exact is not None:
            assert Fraction(float(found.lo[row])) <= alone <= Fraction(float(found.hi[row]))


def test_what_a_double_means_is_asked_for():
    e = numpy.array([0.9, 0.5])
    with pytest.raises(TypeError, match='floats="decimal"'):
        carom.eta(10, 1, e=e, n=7)
    decimal, exact = (carom.eta(10, 1, e=e, n=40, floats=meaning) for meaning in ("decimal", "exact"))
    nine_tenths, double = carom.eta(10, 1, e="9/10", n=40), carom.eta(10, 1, e=Fraction(0.9), n=40)
    assert decimal.lo[0] <= nine_tenths.lo and nine_tenths.hi <= decimal.hi[0]
    assert exact.lo[0] <= double.lo and double.hi <= exact.hi[0]
    assert carom.eta(10, 1, e=0.9, n=7, floats="decimal") > carom.eta(10, 1, e="0.8", n=7)
    single = carom.eta(10, 1, e=numpy.array([0.9], "f4"), n=40, floats="decimal")
    assert single.lo[0] <= nine_tenths.lo and nine_tenths.hi <= single.hi[0]
    with pytest.raises(ValueError, match="floats"):
        carom.eta(10, 1, e=e, n=1, floats="some")


def test_columns_of_a_data_frame_and_shapes():
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame({"m1": ["10", "64"], "m2": [1, 1], "e": ["9/10", "44/81"], "n": [7, 2]})
    found = carom.eta(frame.m1, frame.m2, e=frame.e, n=frame.n)
    assert list(found.to_pandas().columns) == ["lo", "hi"] and found[1][0] <= 15625000000 / 282429536481
    square = carom.eta(numpy.array([[1], [2]]), 1, e="1/2", n=numpy.array([0, 1, 2]))
    assert square.lo.shape == (2, 3) and len(square) == 6 and repr(square) == "Cells(6 rows)"
    assert len(carom.eta(numpy.array([], "i8"), 1, e=1, n=0)) == 0


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"m1": numpy.array([1, 0])}, "row 1: m1: a mass must be above 0"),
        ({"e": numpy.array(["1/2", "3/2"])}, "row 1: e: "),
        ({"e": numpy.array(["1/2", "x"])}, "e: "),
        ({"n": numpy.array([1, -2])}, "row 1: n: -2"),
        ({"n": numpy.array([1.0, 2.0])}, "n: a column of whole numbers"),
        ({"m1": numpy.array([True])}, "m1: a column of truth values"),
        ({"m1": numpy.array([1, 2]), "n": numpy.array([1, 2, 3])}, "shape"),
        ({"m1": numpy.array([1.5, float("nan")]), "floats": "exact"}, "row 1: m1: the value is missing"),
        ({"m1": numpy.array([None, 1], object)}, "row 0: m1: the value is missing"),
    ],
)
def test_a_bad_row_is_named(arguments, message):
    with pytest.raises(ValueError, match=message):
        carom.eta(**{"m1": 10, "m2": 1, "e": "9/10", "n": 1, **arguments})


def test_a_limit_is_a_limit_in_rows_too():
    with pytest.raises(carom.LimitReached, match="row 1: n: "):
        carom.eta(10, 1, e="1/2", n=numpy.array([1, 2**63], "u8"))
