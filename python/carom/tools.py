"""Replays, worksheets, pictures, checks of tables, exports and certificates: what the commands of these names do."""

from __future__ import annotations

import csv
import io
import json
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple, Union

from . import _engine
from .number import Exact, WrongType, count_of, text_of
from .rows import is_list
from .source import Text, source_of

_MOST = 1_000_000
"""Collisions of one replay, unless told otherwise."""


class Picture(str):
    """A picture: SVG as text, which a notebook shows."""

    def _repr_svg_(self) -> str:
        return str(self)

    def save(self, path: str) -> None:
        """Writes the picture to a file whose name ends in ``.svg``; ``carom plot`` writes PNG and PDF."""
        if not str(path).lower().endswith(".svg"):
            raise ValueError(f"{path}: a picture is SVG; write a name that ends in .svg")
        with open(path, "w", encoding="utf-8") as file:
            file.write(self)


@dataclass(frozen=True)
class Collision:
    """One collision: when, between which bodies (from 1; 0 is the left wall), and their velocities."""

    time: Union[Fraction, str]
    pair: Tuple[int, int]
    before: Tuple[Union[Fraction, str], Union[Fraction, str]]
    after: Tuple[Union[Fraction, str], Union[Fraction, str]]
    lost: Union[Fraction, str]
    """The kinetic energy lost in it."""


Scene = Union[Text, Mapping[str, Any]]
"""The text of a scene file, a file that ends in ``.toml``, or what such a file says as a dictionary."""


def _scene_of(scene: Scene) -> str:
    """The text of a scene."""
    if not isinstance(scene, Mapping):
        return source_of(scene, ".toml").text
    return "".join(f"{json.dumps(str(key))} = {_toml(value, str(key))}\n" for key, value in scene.items())


def _toml(value: Any, name: str) -> str:
    """A value as TOML writes it; a number that is no whole one is a text there."""
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{json.dumps(str(key))} = {_toml(one, str(key))}" for key, one in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_toml(one, name) for one in value) + "]"
    if isinstance(value, (bool, str)):
        return json.dumps(value)
    text = text_of(value, name)
    return text if isinstance(value, int) else json.dumps(text)


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
        self.energy = {name: _number(text) for name, text in (self.data["energy"] or {}).items()}
        """The kinetic energy at the beginning, ``initial``, in the end, ``final``, and what was ``lost``."""

    @cached_property
    def collisions(self) -> List[Collision]:
        """Those that are listed, in order."""
        losses = [row["energy_lost"] for row in csv.DictReader(_lines(self.csv()))]
        return [_collision(entry, lost) for entry, lost in zip(self.data["collisions"], losses)]

    def _form(self, form: str, digits: Optional[int] = None) -> str:
        until, most, listed, through, orders = self._options
        return _engine.replay(self._scene, form, until, most, listed, through, orders, digits)

    def __iter__(self) -> Iterator[Collision]:
        return iter(self.collisions)

    def __len__(self) -> int:
        return len(self.data["collisions"])

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


def _lines(text: str) -> Iterator[str]:
    """The lines of a CSV text that are no comments."""
    return (line for line in text.splitlines() if line[:1] != "#")


def _collision(entry: Mapping[str, Any], lost: str) -> Collision:
    before, after = ((_number(pair[0]), _number(pair[1])) for pair in (entry["before"], entry["after"]))
    return Collision(_number(entry["time"]), (entry["pair"][0], entry["pair"][1]), before, after, _number(lost))


def replay(
    scene: Scene,
    *,
    until: Optional[Exact] = None,
    max_events: int = _MOST,
    list_at_most: int = 10_000,
    through_collapse: bool = False,
    orders: bool = False,
) -> Replay:
    """Follows bodies on a line from one collision to the next, exactly, as ``carom replay`` does.

    ``scene`` is the text of a scene file, a file that ends in ``.toml``, or a dictionary.

    >>> bodies = [{"mass": 1, "position": 0, "velocity": 1}, {"mass": 3, "position": 1}]
    >>> replay({"restitution": 1, "body": bodies}).velocities
    [Fraction(-1, 2), Fraction(1, 2)]
    """
    time = None if until is None else text_of(until, "until")
    most, listed = count_of(max_events, "max_events"), count_of(list_at_most, "list_at_most")
    return Replay(_scene_of(scene), (time, most, listed, through_collapse, orders))


def worksheet(
    scene: Scene,
    *,
    form: str = "text",
    sheet: str = "both",
    title: Optional[str] = None,
    standard: Optional[str] = None,
    digits: int = 4,
    places: Optional[int] = None,
    exact: bool = False,
    paper: str = "a4",
    versions: int = 0,
    seed: int = 1,
) -> str:
    """A worksheet of a scene and its key: ``text``, ``markdown``, ``latex`` or ``html``.

    With ``versions`` as many sheets with other simple masses, the same ones for the same ``seed``.
    :func:`worksheet_pdf` makes the pages.
    """
    count = (places is not None, count_of(digits if places is None else places, "digits"))
    if form == "pdf":
        raise ValueError("form: a PDF file is bytes; worksheet_pdf makes it")
    made = _sheets(scene, form, sheet, title, standard, count, exact, paper, (versions, seed))
    return made.decode("utf-8")


def worksheet_pdf(
    scene: Scene,
    *,
    sheet: str = "both",
    title: Optional[str] = None,
    standard: Optional[str] = None,
    digits: int = 4,
    exact: bool = False,
    paper: str = "a4",
    versions: int = 0,
    seed: int = 1,
) -> bytes:
    """The same as :func:`worksheet`, as a PDF file."""
    count = (False, count_of(digits, "digits"))
    return _sheets(scene, "pdf", sheet, title, standard, count, exact, paper, (versions, seed))


def _sheets(
    scene: Scene,
    form: str,
    sheet: str,
    title: Optional[str],
    standard: Optional[str],
    digits: Tuple[bool, int],
    exact: bool,
    paper: str,
    versions: Tuple[int, int],
) -> bytes:
    if paper not in ("a4", "letter"):
        raise ValueError(f"paper: {paper!r} is unknown; write a4 or letter")
    text = _scene_of(scene)
    drawn = (count_of(versions[0], "versions"), count_of(versions[1], "seed"))
    return _engine.worksheet(text, form, sheet, title, standard, digits, exact, paper == "letter", drawn)


Point = Tuple[Exact, Exact]
"""Two numbers; in a picture each may be measured: ``("10.6 ± 0.4", "0.31(2)")``."""


def plot(
    picture: str,
    *,
    ratio: Union[Exact, Sequence[Exact]] = (),
    e: Union[Exact, Sequence[Exact]] = (),
    n: Union[int, Sequence[int]] = (),
    scene: Optional[Scene] = None,
    title: Optional[str] = None,
    xlim: Optional[Point] = None,
    ylim: Optional[Point] = None,
    mark: Sequence[Point] = (),
    grey: bool = False,
) -> Picture:
    """A picture as SVG: ``eta-n``, ``eta-x``, ``threshold``, ``map``, or ``velocities`` of a scene.

    ``xlim`` and ``ylim`` are the ends of the axes, ``mark`` measurements of your own; ``grey`` leaves colours out.

    >>> plot("eta-n", ratio=100, e=["0.8", "0.9"], n=12).startswith("<svg")
    True
    """
    looks = (title, _ends(xlim, "xlim"), _ends(ylim, "ylim"), [_point(one, "mark") for one in mark], grey)
    if picture == "velocities":
        if scene is None:
            raise ValueError("the picture velocities needs a scene")
        return Picture(_engine.plot_velocities(_scene_of(scene), looks))
    ratios = [text_of(value, "ratio") for value in _several(ratio)]
    coefficients = [text_of(value, "e") for value in _several(e)]
    numbers = [count_of(value, "n") for value in _several(n)]
    return Picture(_engine.plot(picture, ratios, coefficients, numbers, looks))


def _point(point: Point, name: str) -> Tuple[str, str]:
    if isinstance(point, str) or len(point) != 2:
        raise ValueError(f"{name}: write two numbers, as in (10, '0.31')")
    return text_of(point[0], name), text_of(point[1], name)


def _ends(ends: Optional[Point], name: str) -> Optional[Tuple[str, str]]:
    return None if ends is None else _point(ends, name)


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
    """Judges somebody's table: a CSV file, a data frame, a dictionary of columns, or rows.

    A row is a dictionary, or a list if the first one is the heading.

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
                    raise ValueError(f"line {line}: n is a number of bodies, not {count}")
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
            # A table for a spreadsheet has the sign U+2044 in its fractions.
            plain = {key: value.replace("\u2044", "/") for key, value in row.items()}
            values = {key: value.replace(",", ".") if separator == ";" else value for key, value in plain.items()}
            yield at, values
        return
    if isinstance(table, Mapping):
        columns = [value if is_list(value) else [value] for value in table.values()]
        if len({len(column) for column in columns}) > 1:
            raise ValueError("the columns are not equally long")
        table = [table.keys(), *zip(*columns)]
    yield from _named(list(table))


def _named(rows: List[Any]) -> Iterator[Tuple[int, Mapping[str, Any]]]:
    """Rows by their headings; where rows are lists the first one has these, and is line 1."""
    heading = None
    for line, row in enumerate(rows, 1):
        if isinstance(row, Mapping):
            yield line, row
            continue
        if isinstance(row, str) or not hasattr(row, "__iter__"):
            raise WrongType(f"line {line}: a row is a dictionary or a list, not {row!r}")
        fields = list(row)
        if heading is None:
            heading = fields
        elif len(fields) == len(heading):
            yield line, dict(zip(heading, fields))
        else:
            raise ValueError(f"line {line}: the heading has {len(heading)} fields, the line has {len(fields)}")


def _written(value: Any) -> str:
    return value.strip() if isinstance(value, str) else str(value)


def _exact(text: str, line: int) -> Fraction:
    try:
        return Fraction(text)
    except (ValueError, ZeroDivisionError):
        raise ValueError(f"line {line}: {text!r} is not a number") from None


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


def format_claims(claims: Text) -> str:
    """Claims in the one style, as ``carom fmt`` writes them.

    >>> format_claims('claim a "A"\\ngiven x>0\\nprove x*x=x^2')
    'claim a "A"\\ngiven x > 0\\nprove x*x = x^2\\n'
    """
    return _engine.format_claims(source_of(claims, ".claim").text)


@dataclass(frozen=True)
class Listed:
    """A claim of the built-in catalogue, not judged."""

    id: str
    number: Union[int, str, None]
    title: str
    section: Optional[str]
    source: Optional[str]
    expected: str
    """The verdict that the claim file expects."""
    statement: List[str]
    """Hypotheses and goal, one a line."""


def catalogue() -> List[Listed]:
    """The claims of the built-in catalogue, in their order; :func:`audit` judges them."""
    return [Listed(**entry) for entry in json.loads(_engine.catalogue())]


@dataclass(frozen=True)
class Repair:
    """The hypothesis that a refuted claim lacks."""

    hypothesis: str
    exact: bool
    """Whether the goal is proved to hold nowhere else."""
    claim: str
    """The repaired claim."""
    certificate: str
    """Its certificate, which the kernel accepted: :func:`check` has it check it again."""

    def __str__(self) -> str:
        return f"holds {'exactly where' if self.exact else 'where'} {self.hypothesis}"


def repair(id: str, claims: Optional[Text] = None, *, seconds: int = 10) -> Repair:
    """The hypothesis that a refuted claim lacks; :class:`ValueError` where none is found, or the claim is not refuted.

    >>> str(repair("c", 'claim c "C"\\ngiven x real\\nprove x^2 > 0'))
    'holds where x != 0'
    """
    source = None if claims is None else source_of(claims, ".claim")
    text, path = (None, "text") if source is None else (source.text, source.path or "text")
    found, why_not = _engine.repair(text, path, id, count_of(seconds, "seconds"))
    if found is None:
        raise ValueError(why_not)
    return Repair(*found)


@dataclass(frozen=True)
class Judgement:
    """A simulator's results beside the exact ones. As a condition it says whether every scene is right."""

    data: Dict[str, Any]
    """What ``carom referee --format json`` writes."""
    right: bool
    words: str

    def __bool__(self) -> bool:
        return self.right

    def __str__(self) -> str:
        return self.words.rstrip("\n")


def referee_scenes() -> List[Dict[str, Any]]:
    """The reference scenes: masses, positions, velocities and restitutions, with what is right at the end."""
    scenes: List[Dict[str, Any]] = json.loads(_engine.referee_file(False))["scenes"]
    return scenes


def referee_answers() -> str:
    """The right answers, as the CSV that :func:`referee` reads."""
    return _engine.referee_file(True)


def referee(results: Union[Text, Mapping[str, Mapping[str, Any]]], *, digits: int = 9) -> Judgement:
    """Judges a simulator: a CSV file, or ``{scene: {"velocities": […], …}}`` with ``positions``, ``times``, ``count``.

    >>> bool(referee(referee_answers()))
    True
    """
    text = _results(results) if isinstance(results, Mapping) else source_of(results, ".csv").text
    found, words = _engine.judge_simulator(text, count_of(digits, "digits"))
    data = json.loads(found)
    return Judgement(data, not data["wrong"] and not data["missing"], words)


def _results(results: Mapping[str, Mapping[str, Any]]) -> str:
    columns = ["velocities", "positions", "collisions", "times", "count"]
    for name, answer in results.items():
        for key in answer:
            if key not in columns:
                raise ValueError(f"{name}: no column is called {key!r}; there are {', '.join(columns)}")
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(["scene", *columns])
    for name, answer in results.items():
        cells = (answer.get(column, "") for column in columns)
        writer.writerow([name, *(_cell(cell) for cell in cells)])
    return out.getvalue()


def _cell(cell: Any) -> str:
    if isinstance(cell, str) or not hasattr(cell, "__iter__"):
        return str(cell)
    # A pair (1, 2) of bodies is written 1-2. A float is the double that it is: a simulator computes with doubles.
    parts = ("-".join(map(str, part)) if isinstance(part, (tuple, list)) else str(part) for part in cell)
    return " ".join(parts)


def scene_schema() -> Dict[str, Any]:
    """The JSON schema of scene files."""
    found: Dict[str, Any] = json.loads(_engine.scene_schema())
    return found
