"""Tables over grids as NumPy arrays and data frames."""

from __future__ import annotations

import html
import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

from . import _engine
from ._engine import LimitReached
from .number import Exact, count_of, text_of

if TYPE_CHECKING:
    import numpy
    import pandas

Grid = Union[Exact, Sequence[Exact]]
"""An axis: a number, a list of them, or a text ``"1; 2; 10"``, ``"start:stop:step"``, ``"start:stop:xFACTOR"``."""


@dataclass(frozen=True, eq=False)
class Table:
    """A quantity over its axes.

    Two tables are equal if all of their cells are. ``table[i, j, k]`` is the pair of ends of a cell, or of a part.
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

    def __getitem__(self, place: Any) -> Tuple[Any, Any]:
        return self.lo[place], self.hi[place]

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Table):
            return NotImplemented
        same = self.want == other.want and self.axes == other.axes
        return same and bool((self.lo == other.lo).all() and (self.hi == other.hi).all())

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        axes = ", ".join(f"{name}: {len(values)}" for name, values in self.axes.items())
        return f"Table({self.want!r}, {axes})"

    def _repr_html_(self) -> str:
        """The first cells as a table."""
        import numpy

        heads = "".join(f"<th>{html.escape(name)}</th>" for name in (*self.axes, "lo", "hi"))
        rows = []
        for cell in range(min(len(self), _SHOWN)):
            place = numpy.unravel_index(cell, self.lo.shape)
            labels = [values[int(i)] for values, i in zip(self.axes.values(), place)]
            ends = (repr(float(end)) for end in self[place])
            rows.append("".join(f"<td>{html.escape(text)}</td>" for text in (*labels, *ends)))
        body = "".join(f"<tr>{row}</tr>" for row in rows)
        more = f"<p>{len(self)} cells, {len(rows)} shown</p>" if len(self) > len(rows) else ""
        caption = f"<caption>{html.escape(self.want)}</caption>"
        return f"<table>{caption}<thead><tr>{heads}</tr></thead><tbody>{body}</tbody></table>{more}"


MAX_CELLS = 50_000_000
"""The most cells of a table in memory: their ends take 800 MB."""

_SHOWN = 12
"""Cells that a notebook shows."""


def grid_of(values: Any, name: str) -> Optional[str]:
    """The text of an axis."""
    if values is None:
        return None
    if isinstance(values, str):
        return separated(values, name)
    if not hasattr(values, "__iter__"):
        return text_of(values, name)
    texts = [text_of(value, name) for value in values]
    if any("," in text or ":" in text for text in texts):
        raise ValueError(f"{name}: in a list each value is one number")
    return ",".join(texts)


_DECIMAL = re.compile(r"(?<![\d.,/])(\d+),(\d+)(?![\d.,/:])")
"""A comma that may be a decimal point: the only one between two whole numbers."""


def separated(text: str, name: str) -> str:
    """A text whose commas separate; one of which a comma may be a decimal point has two readings."""
    if ";" in text:
        # The commas of such a list are decimal ones.
        elements = [element.strip() for element in text.split(";")]
        if any("," in element for element in elements):
            raise ValueError(f"{name}: {text!r}: write decimal points instead of commas")
        return ",".join(elements)
    # A list of whole numbers has no decimal commas.
    if name == "n" or not _DECIMAL.search(text):
        return text
    decimal = re.sub(r",\s+", "; ", _DECIMAL.sub(r"\1.\2", text))
    listed = re.sub(r",\s*", "; ", text)
    raise ValueError(
        f"{name}: {text!r} has two readings: write {decimal!r} if the comma is a decimal point, "
        f"{listed!r} if it separates two numbers"
    )


def plan(want: str, ratio: Any, e: Any, n: Any) -> _engine.Plan:
    """The engine's table."""
    ratio = grid_of(ratio, "ratio")
    return _engine.Plan(want, "" if ratio is None else ratio, grid_of(e, "e"), grid_of(n, "n"))


def ends(plan: _engine.Plan, start: int, stop: int) -> Tuple[numpy.ndarray, numpy.ndarray]:
    """The doubles around the rows from one up to another; Ctrl-C ends it between chunks of rows."""
    return filled(stop - start, lambda sink: plan.fill(start, stop, sink))


def filled(count: int, fill: Callable[[Callable[[int, bytes, bytes], None]], None]) -> Tuple[Any, Any]:
    """So many ends as arrays; ``fill`` hands them over piece by piece."""
    import numpy

    try:
        lo, hi = numpy.empty(count), numpy.empty(count)
    except MemoryError as error:
        message = f"{count} cells do not fit into memory ({error}); carom.sweep writes tables of any size as files"
        raise MemoryError(message) from None

    def sink(offset: int, below: bytes, above: bytes) -> None:
        stop = offset + len(below) // 8
        lo[offset:stop] = numpy.frombuffer(below)
        hi[offset:stop] = numpy.frombuffer(above)

    fill(sink)
    return lo, hi


def table(*, ratio: Grid, e: Optional[Grid] = None, n: Optional[Grid] = None, want: str = "eta") -> Table:
    """All cells of a grid.

    ``want`` is ``"eta"``, which depends on ``ratio`` (m1/m2), ``e`` and ``n``, ``"threshold"`` on ``ratio`` and ``n``,
    or ``"best-n"`` on ``ratio`` and ``e``. Needs NumPy. More than :data:`MAX_CELLS` cells are :class:`LimitReached`.

    >>> table(ratio="1:3:1", e=["1/2", 1], n=[0, 1]).lo.shape
    (3, 2, 2)
    """
    found = plan(want, ratio, e, n)
    if found.rows() > MAX_CELLS:
        raise LimitReached(
            f"limit reached: cells of a table in memory: {MAX_CELLS} allowed, {found.rows()} asked for; "
            "carom.sweep writes tables of any size as files"
        )
    shape = found.shape()
    lo, hi = ends(found, 0, found.rows())
    axes = {name: found.labels(i, 0, length) for i, (name, length) in enumerate(shape)}
    lengths = [length for _, length in shape]
    return Table(want, axes, lo.reshape(lengths), hi.reshape(lengths))


def table_text(
    *,
    ratio: Grid,
    e: Optional[Grid] = None,
    n: Optional[Grid] = None,
    want: str = "eta",
    digits: int = 6,
    places: Optional[int] = None,
    rounding: str = "nearest",
    form: str = "text",
) -> str:
    """The same table as ``carom table`` prints it, every digit right.

    ``text``, ``csv``, ``spreadsheet`` (which Excel opens well), ``spreadsheet-comma``, ``json``, ``markdown`` or
    ``latex``.

    >>> print(table_text(ratio="9", e="1", n=1, form="spreadsheet").splitlines()[1].replace("\u2044", "|"))
    9,1,1,0.562500,9|16
    """
    axes = (grid_of(ratio, "ratio") or "", grid_of(e, "e"), grid_of(n, "n"))
    count = (places is not None, count_of(digits if places is None else places, "digits"))
    return _engine.table_text(want, axes, count, rounding, form)
