"""eta for rows: columns of m1, m2, e and n as NumPy arrays or as columns of a data frame."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, List, Optional, Tuple

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
    return getattr(value, "ndim", 0) > 0 and hasattr(value, "dtype")


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
    arrays = {name: numpy.asarray(value) for name, value in given.items() if is_column(value)}
    shape = numpy.broadcast_shapes(*(array.shape for array in arrays.values()))
    whole = {name: numpy.broadcast_to(array, shape).ravel() for name, array in arrays.items()}

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
    size = 1
    for length in shape:
        size *= length
    lo, hi = filled(size, rows.fill)
    return Cells(lo.reshape(shape), hi.reshape(shape))


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
        number = str(value) if getattr(value, "dtype", None) is not None and floats == "decimal" else value
        try:
            found.append(text_of(plain(number, floats), name))
        except (TypeError, ValueError) as error:
            raise type(error)(f"row {row}: {error}") from None
    return (False, found)


def _counts(array: Any) -> bytes:
    if array.dtype.kind not in "iu":
        raise WrongType("n: a column of whole numbers is expected")
    if array.dtype.kind == "i" and (array < 0).any():
        raise ValueError(f"row {int((array < 0).argmax())}: n: {int(array[(array < 0).argmax()])} is no natural number")
    return array.astype("u8").tobytes()
