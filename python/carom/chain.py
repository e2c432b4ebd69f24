"""Chains of bodies: energy transfer, thresholds, best numbers of bodies, velocities."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from typing import Any, List, Optional, Protocol, Sequence, Tuple, Union, overload

from . import _engine
from .number import Answer, Exact, Number, Rational, Undecided, answer_of, count_of, number_of, text_of
from .rows import Cells, each_row, etas, is_column, is_list, plain


class Column(Protocol):
    """A NumPy array or a column of a data frame, of which type checkers know this much without stubs for either."""

    @property
    def ndim(self) -> int:
        """How many axes it has."""

    @property
    def dtype(self) -> Any:
        """The type of its entries."""


_Rows = Union[Exact, Column, List[Exact]]
"""A number, or one for each row."""

_DIGITS = 15
"""Digits of the decimal that an enclosure shows; its ends agree to three more at least."""

_ENCLOSED = 20
"""Digits asked for where an enclosure is made: more than doubles have."""

_Restitution = Union[Exact, Sequence[Exact]]
"""One coefficient for all collisions, or one for each."""


class Helps(str, Enum):
    """Whether an inserted body helps: whether the last body gets more energy with it than without it.

    A member is equal to its text, ``Helps.YES == "yes"``. As a condition, ``YES`` is true and ``NO`` is false. The
    others are neither: ``bool()`` of them is a :class:`ValueError`.

    >>> "worth it" if helps(10, 1, e="9/10", n=2) else "not worth it"
    'worth it'
    """

    YES = "yes"
    NO = "no"
    ON_THE_THRESHOLD = "exactly on the threshold"
    DEPENDS = "depends"

    def __bool__(self) -> bool:
        if self is Helps.ON_THE_THRESHOLD:
            raise ValueError("the body changes nothing: compare with Helps.ON_THE_THRESHOLD")
        if self is Helps.DEPENDS:
            raise ValueError("whether the body helps depends on the inputs: compare with Helps.DEPENDS")
        return self is Helps.YES

    def __str__(self) -> str:
        return self.value


class EachHelps(Tuple[Helps, ...]):
    """Whether each inserted body of given mass helps, in order.

    ``bool()`` of it is a :class:`ValueError`: ask ``all(...)`` or ``any(...)``.
    """

    def __bool__(self) -> bool:
        raise ValueError("there is an answer for each inserted body: ask all(...) or any(...)")


class Recollides(str, Enum):
    """Whether bodies meet again after the pass.

    A member is equal to its text, ``Recollides.NO == "no"``. As a condition, ``YES`` is true and ``NO`` is false.
    ``bool()`` of ``DEPENDS`` (on the measured inputs) and of ``NOT_SETTLED`` is a :class:`ValueError`.
    """

    YES = "yes"
    NO = "no"
    DEPENDS = "depends"
    NOT_SETTLED = "not settled"

    def __bool__(self) -> bool:
        if self is Recollides.DEPENDS:
            raise ValueError("whether bodies meet again depends on the inputs: compare with Recollides.DEPENDS")
        if self is Recollides.NOT_SETTLED:
            raise ValueError("it is not settled whether bodies meet again: compare with Recollides.NOT_SETTLED")
        return self is Recollides.YES

    def __str__(self) -> str:
        return self.value


@dataclass(frozen=True, eq=False)
class BestN:
    """The best number of inserted bodies.

    ``least`` and ``greatest`` differ only where inputs are measured. They are ints, ``math.inf`` where every further
    body helps (e = 1), or None where any number does as well as any other (e = 1 and equal masses). With ``tie`` one
    body fewer transfers exactly as much.
    """

    least: Union[int, float, None]
    greatest: Union[int, float, None]
    tie: bool

    def __index__(self) -> int:
        if not isinstance(self.least, int) or self.least != self.greatest:
            raise ValueError(f"{self} is not one integer")
        return self.least

    __int__ = __index__

    def __eq__(self, other: object) -> bool:
        """Equal to another best number in all three, and to an int that it is."""
        if isinstance(other, BestN):
            return (self.least, self.greatest, self.tie) == (other.least, other.greatest, other.tie)
        if isinstance(other, int) and not isinstance(other, bool):
            return self.least == other == self.greatest
        return NotImplemented

    def _compared(self, other: Any, relation: str) -> bool:
        number = isinstance(other, (int, float)) and not isinstance(other, bool)
        if not number and not isinstance(other, BestN):
            return NotImplemented
        ends = [(other, other) if number else (other.least, other.greatest), (self.least, self.greatest)]
        found = None if None in (*ends[0], *ends[1]) else answer_of(ends[1], ends[0], relation)
        if found is None:
            raise Undecided(f"{self} {relation} {other} is open")
        return found

    def __lt__(self, other: Any) -> bool:
        return self._compared(other, "<")

    def __le__(self, other: Any) -> bool:
        return self._compared(other, "<=")

    def __gt__(self, other: Any) -> bool:
        return self._compared(other, ">")

    def __ge__(self, other: Any) -> bool:
        return self._compared(other, ">=")

    def __hash__(self) -> int:
        return hash(self.least) if self.least == self.greatest else hash((self.least, self.greatest))


class Chain:
    """A chain: ``m1`` moves towards inserted bodies and ``m2``, which are at rest.

    ``e`` is one coefficient of restitution for all collisions, or a list of one for each. ``n`` bodies of optimal mass
    are inserted, or those of the list ``masses``; ``n=0`` means none. ``speed`` is that of the first body;
    ``velocities`` gives those of all bodies instead, with ``masses``.

    An answer asks only for what it needs: thresholds and masses do not need ``e``, the best number of bodies does not
    need ``n``. Where an input is missing, the :class:`ValueError` names it.

    >>> Chain(64, 1, e="44/81", n=2).masses()
    [Fraction(64, 1), Fraction(16, 1), Fraction(4, 1), Fraction(1, 1)]
    """

    def __init__(
        self,
        m1: Exact,
        m2: Exact,
        *,
        e: Optional[_Restitution] = None,
        n: Optional[int] = None,
        masses: Optional[Sequence[Exact]] = None,
        speed: Optional[Exact] = None,
        velocities: Optional[Sequence[Exact]] = None,
    ) -> None:
        if n is not None and masses is not None and count_of(n, "n") != len(masses):
            raise ValueError(f"n and masses: {n} bodies and {len(masses)} masses do not agree; give one of them")
        if speed is not None and velocities is not None:
            raise ValueError("speed and velocities cannot be combined")
        common = isinstance(e, str) or not hasattr(e, "__iter__")
        ends = (text_of(m1, "m1"), text_of(m2, "m2"))
        self._arguments: Tuple[Any, ...] = (
            ends,
            None if e is None else (common, [text_of(e, "e")] if common else _texts(e, "e")),
            None if n is None else count_of(n, "n"),
            None if masses is None else _texts(masses, "masses"),
            "1" if speed is None else text_of(speed, "speed"),
            None if velocities is None else _texts(velocities, "velocities"),
        )
        self._engine = _engine.Chain(*self._arguments)

    def __reduce__(self) -> Tuple[Any, ...]:
        return (_again, self._arguments)

    def __repr__(self) -> str:
        (m1, m2), e, n, masses, speed, velocities = self._arguments
        parts = [_written(m1), _written(m2)]
        if e is not None:
            parts.append(f"e={_written(e[1][0]) if e[0] else _list_written(e[1])}")
        if masses is not None:
            parts.append(f"masses={_list_written(masses)}")
        elif n is not None:
            parts.append(f"n={n}")
        parts.append(f"speed={_written(speed)}" if velocities is None else f"velocities={_list_written(velocities)}")
        return f"Chain({', '.join(parts)})"

    @property
    def n(self) -> Optional[int]:
        """How many bodies are inserted, or None where the chain was made without saying so."""
        return self._engine.count()

    @property
    def is_exact(self) -> bool:
        """Whether no input is measured."""
        return self._engine.is_exact()

    def _answer(self, quantity: str, digits: int, rounding: str = "nearest") -> Any:
        return self._engine.answer(quantity, digits, rounding)

    def _number(self, quantity: str) -> Number:
        return number_of(self, quantity, (), self._shown(quantity))

    def _list(self, quantity: str) -> List[Number]:
        return [number_of(self, quantity, (i,), found) for i, found in enumerate(self._shown(quantity))]

    def _shown(self, quantity: str) -> Any:
        return self._answer(quantity, _DIGITS if not self.is_exact else _ENCLOSED)

    def eta(self) -> Number:
        """The share of the energy that the last body gets, equation (25) for equal e."""
        return self._number("eta")

    def threshold(self) -> Union[Number, List[Number]]:
        """The least restitution with which an inserted body helps.

        For bodies of optimal mass L_n of equation (19): it tells whether n bodies do better than n - 1. For given
        masses a list with the threshold of each inserted body, (a*b + m**2)/(m*(a + b)) for mass m between a and b.
        A body whose threshold is above 1 never helps.
        """
        found = self._shown("threshold")
        if isinstance(found, list):
            return [number_of(self, "threshold", (i,), one) for i, one in enumerate(found)]
        return number_of(self, "threshold", (), found)

    def helps(self) -> Union[Helps, EachHelps]:
        """Whether the last inserted body helps; for given masses, whether each of them does.

        Bodies of optimal mass: whether n of them hand on more energy than n - 1. Given masses: whether the chain
        hands on more with the body than without it. Where its two collisions have different coefficients, that
        of its neighbours' direct collision is taken to be any number between them.
        """
        found = self._answer("helps", _DIGITS)
        return EachHelps(map(Helps, found)) if isinstance(found, list) else Helps(found)

    def best_n(self) -> BestN:
        """The best number of inserted bodies of optimal mass for these ends and this restitution."""
        least, greatest, tie = self._answer("best-n", _DIGITS)
        return BestN(_count(least), _count(greatest), tie)

    def masses(self) -> List[Number]:
        """All masses, first to last."""
        return self._list("masses")

    def velocities(self) -> List[Number]:
        """All velocities after the pass; :meth:`recollides` tells whether they are final."""
        return self._list("velocities")

    def last_velocity(self) -> Number:
        """The last body's velocity alone, for long chains; its arguments are those of :func:`velocities`."""
        return self._number("last-velocity")

    def losses(self) -> List[Number]:
        """The kinetic energy lost in each collision."""
        return self._list("losses")

    def matrices(self) -> List[List[List[Number]]]:
        """The transfer matrix of each collision, or a single one where all are the same."""
        return [
            [[number_of(self, "matrix", (i, j, k), x) for k, x in enumerate(row)] for j, row in enumerate(rows)]
            for i, rows in enumerate(self._shown("matrix"))
        ]

    def recollides(self) -> Recollides:
        """Whether bodies meet again after the pass."""
        return Recollides(self._answer("recollides", _DIGITS))


def _again(*arguments: Any) -> Chain:
    """A chain from the texts that another one was made of."""
    chain = Chain.__new__(Chain)
    chain._arguments = arguments
    chain._engine = _engine.Chain(*arguments)
    return chain


def _texts(values: Any, name: str) -> List[str]:
    if isinstance(values, str) or not hasattr(values, "__iter__"):
        raise ValueError(f"{name}: a list is expected, not {values!r}")
    return [text_of(value, name) for value in values]


def _written(text: str) -> str:
    """A number as Python reads it back: an integer, or a text in quotes."""
    return text if text.isascii() and text.isdigit() and not text.startswith("0") else repr(text)


def _list_written(texts: List[str]) -> str:
    return f"[{', '.join(map(_written, texts))}]"


def _count(text: str) -> Union[int, float, None]:
    return {"infinite": math.inf, "any": None}[text] if text in ("infinite", "any") else int(text, 16)


@overload
def eta(  # type: ignore[overload-overlap]
    m1: Exact,
    m2: Exact,
    *,
    e: _Restitution,
    n: Optional[int] = None,
    masses: Optional[Sequence[Exact]] = None,
    floats: Optional[str] = None,
) -> Number: ...
@overload
def eta(
    m1: _Rows,
    m2: _Rows,
    *,
    e: Union[Exact, Column],
    n: Union[int, Column, List[int]],
    floats: Optional[str] = None,
) -> Cells: ...
def eta(
    m1: Any, m2: Any, *, e: Any, n: Any = None, masses: Optional[Sequence[Exact]] = None, floats: Optional[str] = None
) -> Union[Number, Cells]:
    """The share of the first body's energy that the last one gets.

    ``n`` bodies of optimal mass are inserted, or those of ``masses``. One of the two is needed; ``n=0`` means none.

    Any of ``m1``, ``m2``, ``e`` and ``n`` may be a NumPy array or a column of a data frame, and all but ``e`` a list:
    the answer is then a :class:`Cells`, with an enclosure for each row. ``floats`` says what doubles mean:
    ``"decimal"``, the number that is printed (0.9 is nine tenths), or ``"exact"``, the double itself. Without it a
    float is refused.

    >>> eta(10, 1, e="9/10", n=0)
    Fraction(361, 1210)
    >>> eta(10, 1, e="9/10", n=7)
    Enclosure(0.37313751177373857462)
    """
    if masses is None:
        found = _engine.eta(m1, m2, e, n)
        if found is not None:
            return Rational(*found) if isinstance(found, tuple) else Answer((m1, m2, e, n), "eta", (), found)
        # A list for e has a coefficient for each collision.
        if any(map(is_list, (m1, m2, n))) or is_column(e):
            return etas(m1, m2, e, n, floats)
    if floats is not None:
        m1, m2, e = (plain(value, floats) for value in (m1, m2, e))
    return Chain(m1, m2, e=e, n=n, masses=masses).eta()


@overload
def threshold(  # type: ignore[overload-overlap]
    m1: Exact, m2: Exact, *, n: int, floats: Optional[str] = None
) -> Number: ...
@overload
def threshold(m1: Exact, m2: Exact, *, masses: Sequence[Exact]) -> List[Number]: ...
@overload
def threshold(m1: _Rows, m2: _Rows, *, n: Union[int, Column, List[int]], floats: Optional[str] = None) -> Cells: ...
def threshold(
    m1: Any, m2: Any, *, n: Any = None, masses: Optional[Sequence[Exact]] = None, floats: Optional[str] = None
) -> Union[Number, List[Number], Cells]:
    """The least restitution with which an inserted body helps: L_n of equation (19), or one for each of given masses.

    ``m1``, ``m2`` and ``n`` may be columns, as for :func:`eta`.

    >>> threshold(64, 1, n=2)
    Fraction(44, 81)
    >>> threshold(10, 1, masses=[2])
    [Fraction(7, 11)]
    """
    if masses is None and any(map(is_list, (m1, m2, n))):
        return each_row({"m1": m1, "m2": m2, "n": n}, floats, lambda row: _ends(Chain(**row).threshold()))
    return Chain(plain(m1, floats), plain(m2, floats), n=n, masses=masses).threshold()


@overload
def helps(m1: Exact, m2: Exact, *, e: _Restitution, n: int) -> Helps: ...
@overload
def helps(m1: Exact, m2: Exact, *, e: _Restitution, masses: Sequence[Exact]) -> EachHelps: ...
def helps(
    m1: Exact,
    m2: Exact,
    *,
    e: _Restitution,
    n: Optional[int] = None,
    masses: Optional[Sequence[Exact]] = None,
) -> Union[Helps, EachHelps]:
    """Whether the n-th inserted body helps, or whether each of given masses does.

    >>> helps(64, 1, e="44/81", n=2)
    <Helps.ON_THE_THRESHOLD: 'exactly on the threshold'>
    >>> helps(10, 1, e="9/10", masses=[9, 3])
    (<Helps.NO: 'no'>, <Helps.YES: 'yes'>)
    """
    return Chain(m1, m2, e=e, n=n, masses=masses).helps()


@overload
def best_n(  # type: ignore[overload-overlap]
    m1: Exact, m2: Exact, *, e: Exact, floats: Optional[str] = None
) -> BestN: ...
@overload
def best_n(m1: _Rows, m2: _Rows, *, e: _Rows, floats: Optional[str] = None) -> Cells: ...
def best_n(m1: Any, m2: Any, *, e: Any, floats: Optional[str] = None) -> Union[BestN, Cells]:
    """The best number of inserted bodies of optimal mass.

    ``m1``, ``m2`` and ``e`` may be columns, as for :func:`eta`. A best number that is infinite has infinite ends;
    where any number is as good as any other they are 0 and infinity.

    >>> best_n(64, 1, e="44/81")
    BestN(least=2, greatest=2, tie=True)
    """
    if any(map(is_list, (m1, m2, e))):
        return each_row({"m1": m1, "m2": m2, "e": e}, floats, lambda row: _ends(Chain(**row).best_n()))
    return Chain(*(plain(value, floats) for value in (m1, m2)), e=plain(e, floats)).best_n()


def _ends(answer: Any) -> Tuple[float, float]:
    """The doubles around an answer."""
    if not isinstance(answer, BestN):
        return answer.lo, answer.hi
    return (0, math.inf) if answer.least is None or answer.greatest is None else (answer.least, answer.greatest)


def masses(m1: Exact, m2: Exact, *, n: int, e: Optional[_Restitution] = None) -> List[Number]:
    """The optimal masses, those of the ends among them. They do not depend on ``e``."""
    return Chain(m1, m2, e=e, n=n).masses()


def velocities(
    m1: Exact,
    m2: Exact,
    *,
    e: _Restitution,
    n: Optional[int] = None,
    masses: Optional[Sequence[Exact]] = None,
    speed: Optional[Exact] = None,
    velocities: Optional[Sequence[Exact]] = None,
) -> List[Number]:
    """The velocities after one pass; they are final only where :func:`recollides` says ``"no"``.

    ``velocities`` gives a velocity before for each body, with ``masses``. Without it the first body has ``speed``, 1 by
    default, and all others rest.

    >>> velocities(2, 1, e="1/2", masses=[], velocities=[1, -1])
    [Fraction(0, 1), Fraction(1, 1)]
    """
    return Chain(m1, m2, e=e, n=n, masses=masses, speed=speed, velocities=velocities).velocities()


def last_velocity(
    m1: Exact,
    m2: Exact,
    *,
    e: _Restitution,
    n: Optional[int] = None,
    masses: Optional[Sequence[Exact]] = None,
    speed: Optional[Exact] = None,
    velocities: Optional[Sequence[Exact]] = None,
) -> Number:
    """The last body's velocity alone, for long chains. ``speed`` and ``velocities`` are those of :func:`velocities`."""
    return Chain(m1, m2, e=e, n=n, masses=masses, speed=speed, velocities=velocities).last_velocity()


def losses(
    m1: Exact,
    m2: Exact,
    *,
    e: _Restitution,
    n: Optional[int] = None,
    masses: Optional[Sequence[Exact]] = None,
    speed: Optional[Exact] = None,
    velocities: Optional[Sequence[Exact]] = None,
) -> List[Number]:
    """The kinetic energy lost in each collision. ``speed`` and ``velocities`` are those of :func:`velocities`."""
    return Chain(m1, m2, e=e, n=n, masses=masses, speed=speed, velocities=velocities).losses()


def matrices(
    m1: Exact,
    m2: Exact,
    *,
    e: _Restitution,
    n: Optional[int] = None,
    masses: Optional[Sequence[Exact]] = None,
) -> List[List[List[Number]]]:
    """The transfer matrix of each collision, or a single one where all are the same."""
    return Chain(m1, m2, e=e, n=n, masses=masses).matrices()


def recollides(
    m1: Exact,
    m2: Exact,
    *,
    e: _Restitution,
    n: Optional[int] = None,
    masses: Optional[Sequence[Exact]] = None,
) -> Recollides:
    """Whether bodies meet again after the pass."""
    return Chain(m1, m2, e=e, n=n, masses=masses).recollides()
