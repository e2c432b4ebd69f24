"""Audits of claims: proved, refuted with an exact counterexample, or undecided with the reason."""

from __future__ import annotations

import html
import json
import os
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Dict, Iterator, List, Optional, Sequence, Union

from . import _engine
from .number import count_of
from .source import PAPERS, claims_of, is_paper, source_of

_LONGEST = 400
"""Characters of a value that a display shows."""


@dataclass(frozen=True)
class Broken:
    """A comparison that fails at a witness, with the values of its sides."""

    statement: str
    left: str
    right: str


@dataclass(frozen=True)
class Witness:
    """An exact point where all hypotheses hold and the claim does not."""

    point: Dict[str, Union[Fraction, str]]
    """Values of the variables: fractions, or texts where they are none."""
    broken: List[Broken]
    """What is false there."""


@dataclass(frozen=True)
class Line:
    """A line of an argument."""

    depth: int
    rule: str
    text: str


@dataclass(frozen=True)
class Claim:
    """What the audit says of one claim."""

    id: str
    title: str
    number: Union[int, str, None]
    source: Optional[str]
    section: Optional[str]
    reading: Optional[str]
    verdict: str
    """``"proved"``: the kernel accepted a certificate in this run; ``"refuted"`` or ``"undecided"``."""
    expected: str
    as_expected: bool
    method: str
    statement: str
    latex: str
    mathml: str
    hypotheses: List[str]
    argument: List[Line]
    used: List[str]
    unused: List[str]
    sample: Optional[Dict[str, Union[Fraction, str]]]
    witness: Optional[Witness]
    reason: Optional[str]
    """Why it is undecided."""
    certificate: Optional[str]
    """The SHA-256 of the certificate's text, of a proved claim."""
    certificate_text: Optional[str]
    """The certificate that the kernel accepted, which :func:`carom.check` and `carom check` read."""
    explanation: str
    """The statement with its whole proof in words, as `carom explain` prints it."""
    notes: List[str]

    def __repr__(self) -> str:
        return f"Claim({self.id!r}, {self.verdict!r}, {_shown(self.statement)!r})"

    def __str__(self) -> str:
        return str(Audit([self])).partition("\n\n")[0]

    def _repr_html_(self) -> str:
        return f"<table>{_row(self)}</table>"

    def _repr_latex_(self) -> str:
        return f"$$\\begin{{array}}{{lll}}\n{_latex_row(self)}\n\\end{{array}}$$"


@dataclass(frozen=True)
class Unread:
    """What of a paper was not read."""

    id: str
    """The equation, as a claim would be called; empty for a comment outside of equations."""
    file: str
    line: int
    message: str
    text: str
    """The message with its place, the line and a caret; empty where an equation waits for what was not read."""

    def __str__(self) -> str:
        return f"{self.file}:{self.line}: {self.message}"


class Audit:
    """The claims of an audit, in their order; a notebook shows it as a table."""

    def __init__(self, claims: List[Claim], unread: Sequence[Unread] = ()) -> None:
        self.claims = claims
        self.unread = list(unread)
        """What of a paper was not read; a text in the claim language is read whole or refused."""

    def __iter__(self) -> Iterator[Claim]:
        return iter(self.claims)

    def __len__(self) -> int:
        return len(self.claims)

    def __bool__(self) -> bool:
        """Whether every verdict is the expected one: not whether there are claims."""
        return self.as_expected

    def __getitem__(self, key: Union[str, int]) -> Claim:
        if isinstance(key, int):
            return self.claims[key]
        for claim in self.claims:
            if claim.id == key:
                return claim
        raise KeyError(key)

    @property
    def as_expected(self) -> bool:
        """Whether everything was read, and every verdict is the one that its claim expects."""
        return not self.unread and all(claim.as_expected for claim in self.claims)

    @property
    def summary(self) -> Dict[str, int]:
        """How many are proved, refuted, undecided, and not as expected."""
        counts = {verdict: 0 for verdict in ("proved", "refuted", "undecided")}
        for claim in self.claims:
            counts[claim.verdict] += 1
        counts["unexpected"] = sum(not claim.as_expected for claim in self.claims)
        return counts

    def __repr__(self) -> str:
        return f"Audit({self._counted()})"

    def _counted(self) -> str:
        unread = f"; {len(self.unread)} not read" if self.unread else ""
        return _counts(self.summary) + unread

    def __str__(self) -> str:
        """The verdicts, a claim on each line, with its counterexample or what its proof lacks; what was not read."""
        width = max((len(claim.id) for claim in self.claims), default=0)
        lines = []
        for claim in self.claims:
            lines.append(f"{claim.verdict:<10}  {claim.id:<{width}}  {claim.title}".rstrip())
            lines.extend(f"            {line}" for line in _evidence(claim))
        lines.extend(f"not read    {unread}" for unread in self.unread)
        return "\n".join([*lines, "", self._counted()] if lines else [self._counted()])

    def to_dicts(self) -> List[Dict[str, Any]]:
        """A dictionary for each claim, without its formulas: for JSON, or for a data frame."""
        names = ("id", "title", "number", "verdict", "expected", "as_expected", "method", "statement", "reason")
        return [{name: getattr(claim, name) for name in names} for claim in self.claims]

    def to_pandas(self) -> Any:
        """A data frame with a row for each claim."""
        import pandas  # type: ignore[import-untyped,unused-ignore]

        return pandas.DataFrame(self.to_dicts())

    def _repr_html_(self) -> str:
        names = ("verdict", "claim", "statement")
        head = "".join(f'<th style="text-align:left">{name}</th>' for name in names)
        rows = "".join(_row(claim) for claim in self.claims)
        unread = "".join(f"<p><b>not read</b> {_html(str(unread))}</p>" for unread in self.unread)
        counts = html.escape(self._counted())
        return f"<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>{unread}<p>{counts}</p>"

    def _repr_latex_(self) -> str:
        rows = " \\\\\n".join(_latex_row(claim) for claim in self.claims)
        return f"$$\\begin{{array}}{{lll}}\n{rows}\n\\end{{array}}$$"


def _counts(summary: Dict[str, int]) -> str:
    parts = [f"{summary[key]} {key}" for key in ("proved", "refuted", "undecided")]
    total = sum(summary[key] for key in ("proved", "refuted", "undecided"))
    return f"{total} claim{'' if total == 1 else 's'}: {', '.join(parts)}; {summary['unexpected']} not as expected"


def _shown(value: object) -> str:
    text = str(value)
    return text if len(text) <= _LONGEST else f"{text[:_LONGEST]}… ({len(text)} characters)"


def _evidence(claim: Claim) -> List[str]:
    lines = []
    if claim.witness is not None:
        point = ", ".join(f"{name} = {_shown(value)}" for name, value in claim.witness.point.items())
        lines.append(f"fails at {point}" if point else "fails")
        for broken in claim.witness.broken:
            if broken.right:
                lines.append(f"left side {_shown(broken.left)}, right side {_shown(broken.right)}")
            else:
                lines.append(_shown(broken.statement))
    if claim.reason:
        lines.append(_shown(claim.reason))
    if not claim.as_expected:
        lines.append(f"expected: {claim.expected}")
    return lines


_MARKS = {"proved": "✓ proved", "refuted": "✗ refuted", "undecided": "? undecided"}


def _html(text: str) -> str:
    # Notebooks look for formulas between dollars and after backslashes, and a formula may hold a link.
    escaped = html.escape(text)
    for sign in "$\\":
        escaped = escaped.replace(sign, f"<span>{sign}</span>")
    return f'<span class="mathjax_ignore tex2jax_ignore">{escaped}</span>'


def _row(claim: Claim) -> str:
    # All text of a claim file is escaped; the formula is the engine's own MathML. It stands there on a line as well,
    # since what shows notebooks to others may drop the tags, and a power would be read as a digit.
    line = f"<br><small><code>{html.escape(_shown(claim.statement))}</code></small>"
    evidence = "".join(f"<br><small>{_html(line)}</small>" for line in _evidence(claim))
    number = f"({claim.number}) " if claim.number is not None else ""
    return (
        f'<tr><td style="text-align:left;white-space:nowrap"><b>{_MARKS[claim.verdict]}</b></td>'
        f'<td style="text-align:left">{number}<code>{html.escape(claim.id)}</code><br>{_html(claim.title)}</td>'
        f'<td style="text-align:left">{claim.mathml}{line}{evidence}</td></tr>'
    )


_ESCAPES = {
    "\\": "\\backslash ",
    "{": "\\{",
    "}": "\\}",
    "$": "\\$",
    "&": "\\&",
    "#": "\\#",
    "%": "\\%",
    "_": "\\_",
    "^": "\\hat{\\ }",
    "~": "\\sim ",
}


def _latex_text(text: str) -> str:
    # Signs that a formula treats as its own leave the text: what stands there is the same in TeX and MathJax.
    out, plain = [], ""
    for c in text:
        if c in _ESCAPES:
            out += [f"\\text{{{plain}}}" if plain else "", _ESCAPES[c]]
            plain = ""
        else:
            plain += " " if c.isspace() else c
    return "".join(out) + (f"\\text{{{plain}}}" if plain else "")


def _latex_row(claim: Claim) -> str:
    return f"\\text{{{claim.verdict}}} & {_latex_text(claim.id)} & {claim.latex}"


def _value(text: str) -> Union[Fraction, str]:
    try:
        return Fraction(text)
    except ValueError:
        return text


def _point(pairs: Optional[List[List[str]]]) -> Optional[Dict[str, Union[Fraction, str]]]:
    return None if pairs is None else {name: _value(value) for name, value in pairs}


def _claim(facts: Dict[str, Any]) -> Claim:
    witness = facts.pop("witness")
    if witness is not None:
        witness = Witness(_point(witness["point"]) or {}, [Broken(*broken) for broken in witness["broken"]])
    facts["argument"] = [Line(*line) for line in facts["argument"]]
    facts["sample"] = _point(facts["sample"])
    return Claim(witness=witness, **facts)


def audit(
    text: Union[str, os.PathLike[str], None] = None,
    *,
    latex: Union[str, os.PathLike[str], None] = None,
    only: Union[str, Sequence[str]] = (),
    seconds: int = 10,
    file: str = "text",
) -> Audit:
    """Judges the claims of a text in the claim language, of a file, or those of the built-in catalogue.

    A :class:`pathlib.Path` is read as a file, and so is a text of one line that ends in ``.claim``. ``only`` names the
    claims to judge; ``seconds`` limits the time for each; ``file`` is what errors call the text. A fault of the text
    is a :class:`ValueError` that shows its line with a caret. A text without the line ``claim NAME "Title"`` is one
    claim that is called ``law``.

    ``latex`` is a paper instead, whose displayed equations are judged: a text in LaTeX with its comments, or the path
    of a file that ends in ``.tex`` or ``.md``. What of it was not read is listed in ``unread``.

    >>> audit('claim mine "Mine"\\ngiven m > 0\\nprove m^2 = m')["mine"].verdict
    'refuted'
    >>> audit(latex=r"\\begin{equation} (a + b)^2 \\ge 4 a b %carom given a, b real" "\\n" r"\\end{equation}")
    Audit(1 claim: 1 proved, 0 refuted, 0 undecided; 0 not as expected)
    """
    names = [only] if isinstance(only, str) else list(only)
    for name, given in (("text", text), ("latex", latex)):
        if given is not None and not isinstance(given, (str, os.PathLike)):
            raise ValueError(f"{name}: claims are a str or a path, not {type(given).__name__}")
    if text is not None and latex is not None:
        raise ValueError("latex: give a text in the claim language or a paper, not both")
    if text is not None and is_paper(text):
        text, latex = None, text
    limit = count_of(seconds, "seconds")
    if latex is not None:
        paper = source_of(latex, *PAPERS)
        found = json.loads(_engine.audit_paper(paper.text, paper.path, names, limit))
        return Audit([_claim(facts) for facts in found["claims"]], [Unread(**facts) for facts in found["unread"]])
    source = None if text is None else claims_of(text)
    if source is not None and source.path is not None:
        file = source.path
    listed = json.loads(_engine.audit(None if source is None else source.text, file, names, limit))
    return Audit([_claim(facts) for facts in listed])
