"""Tables over grids as NumPy arrays and data frames."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Sequence, Tuple, Union

from . import _engine
from .number import Exact, text_of

if TYPE_CHECKING:
    import numpy
    import pandas

Grid = Union[Exact, Sequence[Exact]]
"""An axis: a number, a list of them, or a text ``"1,2,10"``, ``"start:stop:step"``, ``"start:stop:xFACTOR"``."""


@dataclass(frozen=True)
class Table:
    """A quantity over its axes.

    ``lo`` and ``hi`` have one dimension for each axis, in the order of ``axes``. Each cell's value lies between its two
    entries, which are neighbouring doubles, or the same one where the value is a double. A best number that is infinite
    has infinite entries; where any number is as good as any other they are 0 and infinity.
    """

    want: str
    """The quantity."""
    axes: Dict[str, List[str]]
    """The exact values of each axis as texts."""
    lo: numpy.ndarray
    """Doubles at most the values."""
    hi: numpy.ndarray
    """Doubles at least the values."""

    def to_pandas(self) -> pandas.DataFrame:
        """One row for each cell: the axes as categories of exact texts, ``lo`` and ``hi``."""
        import numpy
        import pandas

        places = numpy.indices(self.lo.shape, dtype=numpy.int32).reshape(len(self.axes), -1)
        columns: Dict[str, Any] = {}
        for (name, labels), codes in zip(self.axes.items(), places):
            # Two values of a list may be written alike; a category is one text.
            unique = list(dict.fromkeys(labels))
            if len(unique) < len(labels):
                codes = numpy.array([unique.index(label) for label in labels], dtype=numpy.int32)[codes]
            columns[name] = pandas.Categorical.from_codes(codes, categories=pandas.Index(unique))
        columns["lo"] = self.lo.ravel()
        columns["hi"] = self.hi.ravel()
        return pandas.DataFrame(columns)

    def __len__(self) -> int:
        return int(self.lo.size)


def grid_of(values: Any, name: str) -> Optional[str]:
    """The text of an axis."""
    if values is None or isinstance(values, str):
        return values
    if not hasattr(values, "__iter__"):
        return text_of(values, name)
    texts = [text_of(value, name) for value in values]
    if any("," in text or ":" in text for text in texts):
        raise ValueError(f"{name}: in a list each value is one number")
    return ",".join(texts)


def plan(want: str, ratio: Any, e: Any, n: Any) -> _engine.Plan:
    """The engine's table."""
    ratio = grid_of(ratio, "ratio")
    return _engine.Plan(want, "" if ratio is None else ratio, grid_of(e, "e"), grid_of(n, "n"))


def ends(plan: _engine.Plan, start: int, stop: int) -> Tuple[numpy.ndarray, numpy.ndarray]:
    """The doubles around the rows from one up to another; Ctrl-C ends it between chunks of rows."""
    import numpy

    lo, hi = numpy.empty(stop - start), numpy.empty(stop - start)

    def sink(offset: int, below: bytes, above: bytes) -> None:
        stop = offset + len(below) // 8
        lo[offset:stop] = numpy.frombuffer(below)
        hi[offset:stop] = numpy.frombuffer(above)

    plan.fill(start, stop, sink)
    return lo, hi


def table(*, ratio: Grid, e: Optional[Grid] = None, n: Optional[Grid] = None, want: str = "eta") -> Table:
    """All cells of a grid.

    ``want`` is ``"eta"``, which depends on ``ratio`` (m1/m2), ``e`` and ``n``, ``"threshold"`` on ``ratio`` and ``n``,
    or ``"best-n"`` on ``ratio`` and ``e``. Needs NumPy.

    >>> table(ratio="1:3:1", e=["1/2", 1], n=[0, 1]).lo.shape
    (3, 2, 2)
    """
    found = plan(want, ratio, e, n)
    shape = found.shape()
    lo, hi = ends(found, 0, found.rows())
    axes = {name: found.labels(i, 0, length) for i, (name, length) in enumerate(shape)}
    lengths = [length for _, length in shape]
    return Table(want, axes, lo.reshape(lengths), hi.reshape(lengths))
