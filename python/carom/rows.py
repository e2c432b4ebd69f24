"""eta for rows: columns of m1, m2, e and n as NumPy arrays or as columns of a data frame."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Optional, Tuple

from . import _engine
from .number import WrongType, count_of, text_of
from .table import filled

if TYPE_CHECKING:
    import numpy
    import pandas

_MEANINGS = ("decimal", "exact")


@dataclass(frozen=True, eq=False)
class Cells:
    """A number for each row: its value lies between ``lo`` and ``hi``, arrays of doubles as long as the columns.

    The ends are at most ``2**-50`` apart, relatively, in the ordinary range of masses: a few doubles.
    """

    lo: numpy.ndarray
    """Doubles at most the values."""
    hi: numpy.ndarray
    """Doubles at least the values."""

    def to_pandas(self) -> pandas.DataFrame:
        """A data frame with the columns ``lo`` and ``hi``."""
        import pandas

        return pandas.DataFrame({"lo": self.lo.ravel(), "hi": self.hi.ravel()})

    def __len__(self) -> int:
        return int(self.lo.size)

    def __getitem__(self, place: Any) -> Tuple[Any, Any]:
        return self.lo[place], self.hi[place]

    def __repr__(self) -> str:
        return f"Cells({len(self)} rows)"


def is_column(value: Any) -> bool:
    """Whether it is an array or a column of a data frame."""
    return hasattr(value, "dtype") and (getattr(value, "ndim", 0) > 0 or hasattr(value, "to_numpy"))


def is_list(value: Any) -> bool:
    """Whether it has a number for each row: a column, or a list."""
    return isinstance(value, list) or is_column(value)


def plain(value: Any, floats: Optional[str]) -> Any:
    """A float as the exact number that it is said to mean; anything else as it is."""
    if floats is not None and floats not in _MEANINGS:
        raise ValueError(f"floats: {floats!r} is unknown; write decimal or exact")
    if floats is None or not isinstance(value, float):
        return value
    return repr(float(value)) if floats == "decimal" else Fraction(float(value))


def etas(m1: Any, m2: Any, e: Any, n: Any, floats: Optional[str]) -> Cells:
    """eta of each row; what is no column is the same in each."""
    import numpy

    given = {"m1": m1, "m2": m2, "e": e, "n": n}
    shape, whole = _whole(given)

    def column(name: str) -> Any:
        if name in whole:
            return _column(name, whole[name], floats)
        return (True, [text_of(plain(given[name], floats), name)])

    rows = _engine.Rows(
        column("m1"),
        column("m2"),
        column("e"),
        _counts(whole["n"] if "n" in whole else numpy.array([count_of(n, "n")], "u8")),
    )
    lo, hi = filled(math.prod(shape), rows.fill)
    return Cells(lo.reshape(shape), hi.reshape(shape))


def each_row(given: Dict[str, Any], floats: Optional[str], ends: Callable[[Dict[str, Any]], Tuple[Any, Any]]) -> Cells:
    """The ends of an answer for each row, one chain after the other."""
    import numpy

    shape, whole = _whole(given)
    found = numpy.empty((2, math.prod(shape)))
    for row in range(found.shape[1]):
        try:
            values = {
                name: _meant(whole[name][row] if name in whole else value, floats) for name, value in given.items()
            }
            found[:, row] = ends(values)
        except (TypeError, ValueError) as error:
            raise type(error)(f"row {row}: {error}") from None
    return Cells(found[0].reshape(shape), found[1].reshape(shape))


def _whole(given: Dict[str, Any]) -> Tuple[Tuple[int, ...], Dict[str, Any]]:
    """The shape that all columns have together, and each of them in that shape, without a missing value."""
    import numpy

    arrays = {name: _array(name, value) for name, value in given.items() if is_list(value)}
    shape = numpy.broadcast_shapes(*(array.shape for array in arrays.values()))
    return shape, {name: numpy.broadcast_to(array, shape).ravel() for name, array in arrays.items()}


def _array(name: str, value: Any) -> Any:
    import numpy

    # Of a list the numbers themselves: NumPy would make texts of a text and a number, floats of a float and an integer.
    array = numpy.array(value, object) if isinstance(value, list) else numpy.asarray(value)
    if isinstance(value, list) and all(type(one) is int for one in value):
        array = numpy.array(value)
    missing = numpy.isnan(array) if array.dtype.kind == "f" else [one is None for one in array.flat]
    if numpy.any(missing):
        raise ValueError(f"row {int(numpy.argmax(missing))}: {name}: the value is missing")
    return array


def _meant(value: Any, floats: Optional[str]) -> Any:
    """An entry of a column as the number that it is said to mean."""
    # A number of 32 bits is printed shorter than the double next to it.
    number = str(value) if getattr(getattr(value, "dtype", None), "kind", "") == "f" and floats == "decimal" else value
    return plain(number, floats)


def _column(name: str, array: Any, floats: Optional[str]) -> Any:
    kind = array.dtype.kind
    if kind == "b":
        raise WrongType(f"{name}: a column of truth values holds no numbers")
    if kind == "i" or (kind == "u" and array.dtype.itemsize < 8):
        return ("integers", array.astype("i8").tobytes())
    if kind == "f" and array.dtype.itemsize <= 8:
        if floats is None:
            raise WrongType(
                f'{name}: a column of floats; say what they mean: floats="decimal" (0.9 is nine tenths) or '
                'floats="exact" (the doubles themselves)'
            )
        plain(0.0, floats)
        # A number of 32 bits is printed shorter than the double next to it.
        exact = floats == "exact" or array.dtype.itemsize == 8
        return _texts(name, array, floats) if not exact else (floats, array.astype("f8").tobytes())
    return _texts(name, array, floats)


def _texts(name: str, array: Any, floats: Optional[str]) -> Tuple[bool, List[str]]:
    found = []
    for row, value in enumerate(array):
        try:
            found.append(text_of(_meant(value, floats), name))
        except (TypeError, ValueError) as error:
            raise type(error)(f"row {row}: {error}") from None
    return (False, found)


def _counts(array: Any) -> bytes:
    if array.dtype.kind not in "iu":
        raise WrongType("n: a column of whole numbers is expected")
    if array.dtype.kind == "i" and (array < 0).any():
        raise ValueError(f"row {int((array < 0).argmax())}: n: {int(array[(array < 0).argmax()])} is no natural number")
    return array.astype("u8").tobytes()
