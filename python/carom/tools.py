"""Replays, worksheets, pictures, checks of tables, exports and certificates: what the commands of these names do."""

from __future__ import annotations

import csv
import io
import json
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple, Union

from . import _engine
from .number import Exact, count_of, text_of
from .source import Text, source_of

_MOST = 1_000_000
"""Collisions of one replay, unless told otherwise."""


class Picture(str):
    """A picture: SVG as text, which a notebook shows."""

    def _repr_svg_(self) -> str:
        return str(self)

    def save(self, path: str) -> None:
        """Writes the picture to a file."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self)


@dataclass(frozen=True)
class Collision:
    """One collision: when, between which bodies (from 1; 0 is the left wall), and their velocities."""

    time: Union[Fraction, str]
    pair: Tuple[int, int]
    before: Tuple[Union[Fraction, str], Union[Fraction, str]]
    after: Tuple[Union[Fraction, str], Union[Fraction, str]]


class Replay:
    """Every collision of a scene. Exact numbers are fractions; what is irrational or enclosed is a text."""

    def __init__(self, scene: str, options: Tuple[Any, ...]) -> None:
        self._scene, self._options = scene, options
        self.data: Dict[str, Any] = json.loads(self._form("json"))
        self.status: str = self.data["status"]
        """``"complete"``, ``"collapse"``, ``"ambiguous"`` or ``"limit"``."""
        self.count: int = self.data["count"]
        self.velocities = [_number(text) for text in self.data["final"]]
        """The velocities at the end: final, where the replay is complete."""
        self.positions = [_number(text) for text in self.data["positions"]]
        self.time = _number(self.data["time"])
        self.collisions = [_collision(entry) for entry in self.data["collisions"]]

    def _form(self, form: str, digits: Optional[int] = None) -> str:
        until, most, listed, through, orders = self._options
        return _engine.replay(self._scene, form, until, most, listed, through, orders, digits)

    def __iter__(self) -> Iterator[Collision]:
        return iter(self.collisions)

    def __len__(self) -> int:
        return len(self.collisions)

    def __repr__(self) -> str:
        return f"Replay({self.status!r}, count={self.count})"

    def __str__(self) -> str:
        return self._form("text")

    def svg(self) -> Picture:
        """The space-time diagram, time upward."""
        return Picture(self._form("svg"))

    def html(self) -> str:
        """A page that moves, in one file."""
        return self._form("html")

    def csv(self) -> str:
        """A line for each collision."""
        return self._form("csv")

    def _repr_svg_(self) -> str:
        return self._form("svg")

    def to_pandas(self) -> Any:
        """A data frame with a row for each collision."""
        import pandas  # type: ignore[import-untyped,unused-ignore]

        return pandas.read_csv(io.StringIO(self.csv()), comment="#")


def _number(text: str) -> Union[Fraction, str]:
    try:
        return Fraction(text)
    except ValueError:
        return text


def _collision(entry: Mapping[str, Any]) -> Collision:
    before, after = ((_number(pair[0]), _number(pair[1])) for pair in (entry["before"], entry["after"]))
    return Collision(_number(entry["time"]), (entry["pair"][0], entry["pair"][1]), before, after)


def replay(
    scene: Text,
    *,
    until: Optional[Exact] = None,
    max_events: int = _MOST,
    list_at_most: int = 10_000,
    through_collapse: bool = False,
    orders: bool = False,
) -> Replay:
    """Follows bodies on a line from one collision to the next, exactly, as ``carom replay`` does.

    ``scene`` is the text of a scene file, or a file that ends in ``.toml``.

    >>> bodies = ["mass = 1\\nposition = 0\\nvelocity = 1", "mass = 3\\nposition = 1"]
    >>> replay("\\n[[body]]\\n".join(["restitution = 1", *bodies])).velocities
    [Fraction(-1, 2), Fraction(1, 2)]
    """
    time = None if until is None else text_of(until, "until")
    most, listed = count_of(max_events, "max_events"), count_of(list_at_most, "list_at_most")
    return Replay(source_of(scene, ".toml").text, (time, most, listed, through_collapse, orders))


def worksheet(
    scene: Text,
    *,
    form: str = "text",
    sheet: str = "both",
    title: Optional[str] = None,
    standard: Optional[str] = None,
    digits: int = 4,
    exact: bool = False,
    paper: str = "a4",
) -> str:
    """A worksheet of a scene and its key: ``text``, ``markdown``, ``latex`` or ``html``."""
    if paper not in ("a4", "letter"):
        raise ValueError(f"paper: {paper!r} is unknown; write a4 or letter")
    text = source_of(scene, ".toml").text
    return _engine.worksheet(text, form, sheet, title, standard, count_of(digits, "digits"), exact, paper == "letter")


def plot(
    picture: str,
    *,
    ratio: Union[Exact, Sequence[Exact]] = (),
    e: Union[Exact, Sequence[Exact]] = (),
    n: Union[int, Sequence[int]] = (),
    scene: Optional[Text] = None,
    title: Optional[str] = None,
) -> Picture:
    """A picture as SVG: ``eta-n``, ``eta-x``, ``threshold``, ``map``, or ``velocities`` of a scene.

    >>> plot("eta-n", ratio=100, e=["0.8", "0.9"], n=12).startswith("<svg")
    True
    """
    if picture == "velocities":
        if scene is None:
            raise ValueError("the picture velocities needs a scene")
        return Picture(_engine.plot_velocities(source_of(scene, ".toml").text, title))
    ratios = [text_of(value, "ratio") for value in _several(ratio)]
    coefficients = [text_of(value, "e") for value in _several(e)]
    numbers = [count_of(value, "n") for value in _several(n)]
    return Picture(_engine.plot(picture, ratios, coefficients, numbers))


def _several(values: Any) -> List[Any]:
    return [values] if isinstance(values, str) or not hasattr(values, "__iter__") else list(values)


@dataclass(frozen=True)
class CheckedCell:
    """A cell of somebody's table beside the certified value."""

    line: int
    quantity: str
    written: str
    certified: str
    right: bool
    judgement: str


def check_table(table: Any, *, rounding: str = "nearest") -> List[CheckedCell]:
    """Judges somebody's table: a CSV file, rows as dictionaries, or a data frame.

    Columns: ``ratio`` (or ``m1`` and ``m2``), ``e``, ``n``, and one or more of ``eta``, ``threshold``, ``best-n``. A
    number is right if it is the value rounded to as many places as are written.

    >>> [cell.judgement for cell in check_table([{"ratio": "4", "e": "1", "n": "0", "eta": "0.65"}])]
    ['wrong from significant digit 2 on']
    """
    cells = []
    for line, row in _rows(table):
        fields = {str(name).strip().lower(): _written(value) for name, value in row.items() if name is not None}
        quantities = [name for name in ("eta", "threshold", "best-n") if name in fields]
        if not quantities:
            raise ValueError(
                f"line {line}: no column is called eta, threshold or best-n; there are {', '.join(fields)}"
            )
        ratio = fields.get("ratio")
        if ratio is None:
            if not fields.get("m1") or not fields.get("m2"):
                raise ValueError(f"line {line}: a column ratio, or m1 and m2, is missing")
            ratio = str(_exact(fields["m1"], line) / _exact(fields["m2"], line))
        for quantity in quantities:
            if not fields[quantity]:
                continue
            n = None
            if quantity != "best-n":
                count = _exact(fields.get("n", ""), line)
                if count.denominator != 1 or count < 0:
                    raise ValueError(f"line {line}: n counts bodies, {count} does not")
                n = count_of(int(count), "n")
            e = fields.get("e") if quantity != "threshold" else None
            if quantity != "threshold" and not e:
                raise ValueError(f"line {line}: e is missing")
            try:
                found = _engine.judged(fields[quantity], quantity, ratio, e, n, rounding)
            except ValueError as error:
                raise ValueError(f"line {line}: {error}") from None
            cells.append(CheckedCell(line, quantity, fields[quantity], found[2], found[0], found[1]))
    return cells


def _rows(table: Any) -> Iterator[Tuple[int, Mapping[str, Any]]]:
    if hasattr(table, "to_dict") and hasattr(table, "columns"):
        table = table.to_dict("records")
    if isinstance(table, str) or hasattr(table, "__fspath__"):
        text = source_of(table, ".csv").text
        lines = [(at, line) for at, line in enumerate(text.splitlines(), 1) if line.strip() and line[:1] != "#"]
        separator = next((c for c in ";\t" if lines and c in lines[0][1]), ",")
        reader = csv.DictReader((line for _, line in lines), delimiter=separator)
        for (at, _), row in zip(lines[1:], reader):
            if None in row or None in row.values():
                raise ValueError(f"line {at}: the heading has {len(reader.fieldnames or ())} fields, the line has not")
            values = {key: value.replace(",", ".") if separator == ";" else value for key, value in row.items()}
            yield at, values
    else:
        yield from enumerate(table, 1)


def _written(value: Any) -> str:
    return value.strip() if isinstance(value, str) else str(value)


def _exact(text: str, line: int) -> Fraction:
    try:
        return Fraction(text)
    except (ValueError, ZeroDivisionError):
        raise ValueError(f"line {line}: {text!r} is no number") from None


def export(claims: Text, language: str) -> str:
    """The statements of claims for other provers: ``coq``, or ``smt2`` for SMT solvers."""
    return _engine.export(source_of(claims, ".claim").text, language)


def check(claims: Text, certificate: str) -> str:
    """Has the kernel check a certificate: the statement that it accepted. A rejected one is a :class:`ValueError`."""
    return _engine.check(source_of(claims, ".claim").text, certificate)


def report(
    claims: Optional[Text] = None, *, only: Union[str, Sequence[str]] = (), form: str = "markdown", seconds: int = 10
) -> str:
    """An audit as `carom audit` writes it: ``markdown``, ``json`` or ``text``. Without claims: of the catalogue."""
    source = None if claims is None else source_of(claims, ".claim")
    names = [only] if isinstance(only, str) else list(only)
    path = source.path if source is not None and source.path is not None else "text"
    text = None if source is None else source.text
    return _engine.audit_report(text, path, names, count_of(seconds, "seconds"), form)


def explain(claims: Text, id: Optional[str] = None) -> str:
    """A claim with its whole proof in words; ``id`` names it where there are several."""
    from .audit import audit

    found = audit(claims, only=[] if id is None else [id])
    if len(found) != 1:
        raise ValueError(f"there are {len(found)} claims; name one of {', '.join(claim.id for claim in found)}")
    return found[0].explanation
