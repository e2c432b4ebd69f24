"""The coefficient of restitution from a class's measurements of bounces."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, List, Optional, Sequence, Tuple, Union

from . import _engine
from .number import Exact, Number, Rational, Root, WrongType, count_of, fraction_of, text_of
from .source import Text, source_of

if TYPE_CHECKING:
    from ._engine import _Bound

_Readings = Union[Sequence[Exact], Sequence[Sequence[Exact]]]


@dataclass(frozen=True)
class Bounces:
    """What measurements say about e: what they allow lies from ``lower`` to ``upper``, and each of those is possible.

    Where they contradict each other ``consistent`` is False, and ``lower`` is above ``upper``. As a condition it is
    ``consistent``. ``print`` says all of it in words.
    """

    consistent: bool
    """Whether one e explains all readings."""
    lower: Number
    """e is at least this."""
    upper: Number
    """e is at most this."""
    lower_from: Optional[Tuple[Tuple[int, str], Tuple[int, str]]]
    """The two readings that tell so: the line of each, or its place in the list, and its text."""
    upper_from: Optional[Tuple[Tuple[int, str], Tuple[int, str]]]
    """The same for ``upper``; None where it is 1, which no e exceeds."""
    readings: int
    """How many readings there are."""
    words: str

    def __bool__(self) -> bool:
        return self.consistent

    def __str__(self) -> str:
        return self.words.rstrip("\n")

    def __repr__(self) -> str:
        lower, upper = self.lower.digits(4, rounding="down"), self.upper.digits(4, rounding="up")
        said = f"e from {lower} to {upper}" if self.consistent else "no e fits"
        return f"Bounces({said}, readings={self.readings})"


def restitution(
    measured: Optional[Text] = None,
    *,
    heights: Optional[_Readings] = None,
    times: Optional[_Readings] = None,
    within: Optional[Exact] = None,
    digits: int = 4,
) -> Bounces:
    """The coefficient of restitution from bounce heights or times: all values that the readings allow, and no other.

    ``heights`` are those of the fall and of the bounces after it, ``times`` those of the flights between bounces: a
    list for one ball, or a list of lists. Or ``measured`` is a table as `carom restitution` reads it: a file that ends
    in ``.csv``, or its text. A reading has its own uncertainty, ``"0.86 ± 0.01"``, or ``within`` is that of all others:
    ``"0.01"`` or ``"2 %"``.

    >>> found = restitution(heights=["1.20", "0.86", "0.63"], within="0.01")
    >>> found
    Bounces(e from 0.8460 to 0.8551, readings=3)
    >>> bool(restitution(heights=["1.00", "0.81", "0.40"], within="0.01"))
    False
    """
    given = [
        name for name, value in (("measured", measured), ("heights", heights), ("times", times)) if value is not None
    ]
    if len(given) != 1:
        said = " and ".join(given) if given else "nothing"
        raise ValueError(f"give one of a table, heights and times; {said} is given")
    reach = None if within is None else text_of(within, "within")
    if measured is not None:
        table: Any = source_of(measured, ".csv").text
    else:
        readings = heights if heights is not None else times
        table = (heights is not None, _runs(readings, given[0]))
    consistent, lower, upper, count, words = _engine.restitution(table, reach, count_of(digits, "digits"))
    return Bounces(consistent, _number(lower), _number(upper), _pair(lower), _pair(upper), count, words)


def _runs(readings: Any, name: str) -> List[List[str]]:
    if isinstance(readings, str) or not hasattr(readings, "__iter__"):
        raise WrongType(f"{name}: a list of readings is expected, not {readings!r}")
    listed = list(readings)
    several = [not isinstance(one, (str, tuple)) and hasattr(one, "__iter__") for one in listed]
    if not any(several):
        return [[text_of(one, name) for one in listed]]
    if not all(several):
        raise WrongType(f"{name}: give readings, or a list of readings for each ball, not both")
    return [[text_of(one, name) for one in run] for run in listed]


def _number(bound: _Bound) -> Number:
    exact, radicand, index, _ = bound
    return Rational(fraction_of(exact)) if exact is not None else Root(fraction_of(radicand), index)


def _pair(bound: _Bound) -> Optional[Tuple[Tuple[int, str], Tuple[int, str]]]:
    return None if bound[3] is None else (bound[3][0], bound[3][1])
