"""Chains of bodies: energy transfer, thresholds, best numbers of bodies, velocities."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, List, Optional, Sequence, Tuple, Union

from . import _engine
from .number import Exact, Number, count_of, number_of, text_of

_DIGITS = 15
"""Digits of the decimal that an enclosure shows; its ends agree to three more at least."""

_ENCLOSED = 20
"""Digits asked for where an enclosure is made: more than doubles have."""


@dataclass(frozen=True)
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


class Chain:
    """A chain: ``m1`` moves towards inserted bodies and ``m2``, which are at rest.

    ``e`` is one coefficient of restitution for all collisions, or a list of one for each. ``n`` bodies of optimal mass
    are inserted, or those of the list ``masses``. ``speed`` is that of the first body; ``velocities`` gives those of
    all bodies instead, with ``masses``.

    >>> Chain(64, 1, e="44/81", n=2).masses()
    [Fraction(64, 1), Fraction(16, 1), Fraction(4, 1), Fraction(1, 1)]
    """

    def __init__(
        self,
        m1: Exact,
        m2: Exact,
        *,
        e: Union[Exact, Sequence[Exact]],
        n: Optional[int] = None,
        masses: Optional[Sequence[Exact]] = None,
        speed: Optional[Exact] = None,
        velocities: Optional[Sequence[Exact]] = None,
    ) -> None:
        if n is not None and masses is not None and count_of(n, "n") != len(masses):
            raise ValueError(f"n and masses: {n} bodies and {len(masses)} masses do not agree; give one of them")
        if speed is not None and velocities is not None:
            raise ValueError("speed and velocities exclude each other")
        common = isinstance(e, str) or not hasattr(e, "__iter__")
        coefficients = [text_of(e, "e")] if common else _texts(e, "e")
        ends = (text_of(m1, "m1"), text_of(m2, "m2"))
        self._arguments: Tuple[Any, ...] = (
            ends,
            (common, coefficients),
            0 if n is None else count_of(n, "n"),
            None if masses is None else _texts(masses, "masses"),
            "1" if speed is None else text_of(speed, "speed"),
            None if velocities is None else _texts(velocities, "velocities"),
        )
        self._engine = _engine.Chain(*self._arguments)

    def __reduce__(self) -> Tuple[Any, ...]:
        return (_again, self._arguments)

    def __repr__(self) -> str:
        (m1, m2), (common, e), n, masses, speed, velocities = self._arguments
        parts = [m1, m2, f"e={e[0] if common else e}"]
        parts.append(f"n={n}" if masses is None else f"masses={masses}")
        parts.append(f"speed={speed}" if velocities is None else f"velocities={velocities}")
        return f"Chain({', '.join(parts)})"

    @property
    def n(self) -> int:
        """How many bodies are inserted."""
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

    def threshold(self) -> Number:
        """L_n, the least restitution with which the n-th inserted body helps, equation (19)."""
        return self._number("threshold")

    def helps(self) -> str:
        """``"yes"``, ``"no"``, ``"exactly on the threshold"``, or ``"depends"`` on the measured inputs."""
        return self._answer("helps", _DIGITS)

    def best_n(self) -> BestN:
        """The best number of inserted bodies for these ends and this restitution."""
        least, greatest, tie = self._answer("best-n", _DIGITS)
        return BestN(_count(least), _count(greatest), tie)

    def masses(self) -> List[Number]:
        """All masses, first to last."""
        return self._list("masses")

    def velocities(self) -> List[Number]:
        """All velocities after the pass; :meth:`recollides` tells whether they are final."""
        return self._list("velocities")

    def last_velocity(self) -> Number:
        """The last body's velocity alone, for long chains."""
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

    def recollides(self) -> str:
        """Whether bodies meet again after the pass: ``"yes"``, ``"no"``, or in words where inputs are measured."""
        return self._answer("recollides", _DIGITS)


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


def _count(text: str) -> Union[int, float, None]:
    return {"infinite": math.inf, "any": None}[text] if text in ("infinite", "any") else int(text, 16)


_Restitution = Union[Exact, Sequence[Exact]]


def eta(
    m1: Exact,
    m2: Exact,
    *,
    e: _Restitution,
    n: Optional[int] = None,
    masses: Optional[Sequence[Exact]] = None,
) -> Number:
    """The share of the first body's energy that the last one gets.

    >>> eta(10, 1, e="9/10")
    Fraction(361, 1210)
    >>> eta(10, 1, e="9/10", n=7)
    Enclosure(0.37313751177373857462)
    """
    return Chain(m1, m2, e=e, n=n, masses=masses).eta()


def threshold(m1: Exact, m2: Exact, *, n: int) -> Number:
    """L_n, the least restitution with which the n-th inserted body helps, equation (19).

    >>> threshold(64, 1, n=2)
    Fraction(44, 81)
    """
    return Chain(m1, m2, e=1, n=n).threshold()


def helps(m1: Exact, m2: Exact, *, e: Exact, n: int) -> str:
    """Whether the n-th inserted body helps: ``"yes"``, ``"no"``, ``"exactly on the threshold"`` or ``"depends"``.

    >>> helps(64, 1, e="44/81", n=2)
    'exactly on the threshold'
    """
    return Chain(m1, m2, e=e, n=n).helps()


def best_n(m1: Exact, m2: Exact, *, e: Exact) -> BestN:
    """The best number of inserted bodies.

    >>> best_n(64, 1, e="44/81")
    BestN(least=2, greatest=2, tie=True)
    """
    return Chain(m1, m2, e=e).best_n()


def masses(m1: Exact, m2: Exact, *, e: _Restitution, n: int) -> List[Number]:
    """The optimal masses, those of the ends among them."""
    return Chain(m1, m2, e=e, n=n).masses()


def velocities(
    m1: Exact,
    m2: Exact,
    *,
    e: _Restitution,
    n: Optional[int] = None,
    masses: Optional[Sequence[Exact]] = None,
    speed: Exact = 1,
) -> List[Number]:
    """The velocities after one pass; they are final only where :func:`recollides` says ``"no"``."""
    return Chain(m1, m2, e=e, n=n, masses=masses, speed=speed).velocities()


def last_velocity(
    m1: Exact,
    m2: Exact,
    *,
    e: _Restitution,
    n: Optional[int] = None,
    masses: Optional[Sequence[Exact]] = None,
    speed: Exact = 1,
) -> Number:
    """The last body's velocity alone, for long chains."""
    return Chain(m1, m2, e=e, n=n, masses=masses, speed=speed).last_velocity()


def losses(
    m1: Exact,
    m2: Exact,
    *,
    e: _Restitution,
    n: Optional[int] = None,
    masses: Optional[Sequence[Exact]] = None,
    speed: Exact = 1,
) -> List[Number]:
    """The kinetic energy lost in each collision."""
    return Chain(m1, m2, e=e, n=n, masses=masses, speed=speed).losses()


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
) -> str:
    """Whether bodies meet again after the pass."""
    return Chain(m1, m2, e=e, n=n, masses=masses).recollides()
