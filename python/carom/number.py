"""Numbers on their way in, which are exact, and out, which are exact or enclosed."""

from __future__ import annotations

import decimal
import math
import numbers
import operator
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Tuple, Union

from ._engine import LimitReached

if TYPE_CHECKING:
    from ._engine import Found
    from .chain import Chain

Exact = Union[int, str, Fraction, decimal.Decimal]
"""What a number may be given as; a text may also be measured, ``"57.1 ± 0.1"`` or ``"[0.84, 0.90]"``."""

Number = Union[Fraction, "Enclosure"]
"""What a number comes out as."""

_MAX_BITS = 14_000
"""Longer integers have more digits than Python writes without being asked."""

_MAX_DIGITS = 1_000
"""Digits up to which :func:`float` refines an enclosure before it gives up."""


def text_of(value: Any, name: str) -> str:
    """The text of an exact number for the engine, which judges it."""
    if isinstance(value, str):
        return value
    if isinstance(value, bool):
        raise ValueError(f"{name}: {value} is no number")
    if isinstance(value, (int, numbers.Rational)):
        parts = (int(value.numerator), int(value.denominator))
        if max(part.bit_length() for part in parts) > _MAX_BITS:
            raise LimitReached(f"{name}: limit reached: bits of a number: {_MAX_BITS} allowed")
        return f"{parts[0]}/{parts[1]}" if parts[1] != 1 else str(parts[0])
    if isinstance(value, decimal.Decimal):
        return str(value)
    if isinstance(value, numbers.Real):
        meant = Fraction(repr(float(value))) if math.isfinite(value) else None
        hint = f'"{meant}", or Fraction({float(value)!r}) for the float itself' if meant is not None else "a number"
        raise ValueError(f"{name}: the float {float(value)!r} is not exact; write {hint}")
    try:
        return str(operator.index(value))
    except TypeError:
        raise ValueError(f"{name}: {value!r} is no number; give an int, a str or a Fraction") from None


def count_of(value: Any, name: str) -> int:
    """A natural number that fits a machine word."""
    try:
        found = operator.index(value)
    except TypeError:
        found = -1
    if isinstance(value, bool) or found < 0:
        raise ValueError(f"{name}: {value!r} is no natural number")
    if found >= 1 << 64:
        raise LimitReached(f"{name}: limit reached: {2**64 - 1} allowed")
    return found


def fraction_of(pair: Tuple[str, str]) -> Fraction:
    """The fraction that the engine sends."""
    return Fraction(int(pair[0], 16), int(pair[1], 16))


class Enclosure:
    """A number between two others: an irrational one, or all values that measured inputs allow.

    ``lo`` and ``hi`` are doubles rounded outwards, ``exact_lo`` and ``exact_hi`` the fractions that they were rounded
    from. The number is never outside. An irrational number can be had to any number of digits: :meth:`digits`,
    :meth:`narrower`. Two enclosures are never compared by ``==``; ``x in enclosure`` asks whether a number lies between
    the ends.
    """

    __slots__ = ("_chain", "_found", "_place", "_quantity")

    def __init__(self, chain: Chain, quantity: str, place: Tuple[int, ...], found: Found) -> None:
        self._chain = chain
        self._quantity = quantity
        self._place = place
        self._found = found

    def __reduce__(self) -> Tuple[Any, ...]:
        return (Enclosure, (self._chain, self._quantity, self._place, self._found))

    @property
    def lo(self) -> float:
        """A double at most the number."""
        return self._found["lo"]

    @property
    def hi(self) -> float:
        """A double at least the number; at most two doubles above ``lo`` where nothing is measured."""
        return self._found["hi"]

    @property
    def exact_lo(self) -> Fraction:
        """The lower end of the enclosure, exactly."""
        return _end(self._found, "lower")

    @property
    def exact_hi(self) -> Fraction:
        """The upper end of the enclosure, exactly."""
        return _end(self._found, "upper")

    @property
    def radical(self) -> str | None:
        """The closed form in the claim language, where the number is irrational and one is known."""
        return self._found["radical"]

    @property
    def measured(self) -> bool:
        """Whether it is wide because inputs are measured."""
        return not self._chain.is_exact

    def digits(self, count: int, *, rounding: str = "nearest") -> str:
        """The number with so many significant digits, each of them right.

        ``rounding`` is ``nearest``, ``up``, ``down``, ``zero`` or ``away``. A number over measured inputs has
        digits only as far as all its values round to the same; otherwise this is a :class:`ValueError`.
        """
        found = self._again(count, rounding)["decimal"]
        if found is None:
            raise ValueError(
                f"the values over the measured inputs do not round to one decimal of {count} digits: {self}"
            )
        return found

    def narrower(self, count: int) -> Tuple[Fraction, Fraction]:
        """Ends that agree to about so many digits, where nothing is measured."""
        found = self._again(count, "nearest")
        return _end(found, "lower"), _end(found, "upper")

    def _again(self, count: int, rounding: str) -> Found:
        answer: Any = self._chain._answer(self._quantity, count_of(count, "digits"), rounding)
        for place in self._place:
            answer = answer[place]
        return answer

    def __float__(self) -> float:
        """The nearest double."""
        lo, hi = self.lo, self.hi
        digits = 25
        while not self.measured and digits <= _MAX_DIGITS and math.isfinite(hi):
            below, above = self.narrower(digits)
            # Division of integers rounds to the nearest double.
            lo, hi = (end.numerator / end.denominator for end in (below, above))
            if lo == hi:
                return lo
            digits *= 2
        if lo == hi:
            return lo
        raise ValueError(f"{self} has no one nearest double")

    def __contains__(self, value: Exact) -> bool:
        """Whether an exact number lies between the ends."""
        number = Fraction(text_of(value, "value"))
        return self.exact_lo <= number <= self.exact_hi

    def __str__(self) -> str:
        decimal_ = self._found["decimal"]
        if decimal_ is not None and not self.measured:
            return decimal_
        return f"[{self.lo!r}, {self.hi!r}]"

    def __repr__(self) -> str:
        return f"Enclosure({self})"

    def _repr_latex_(self) -> str:
        if self.measured:
            return f"$[{_latex(repr(self.lo))},\\; {_latex(repr(self.hi))}]$"
        form = self._found["latex"]
        shown = _latex(str(self))
        return f"$\\displaystyle {form} \\approx {shown}$" if form else f"$\\approx {shown}$"


def _end(found: Found, end: str) -> Fraction:
    pair = found["lower"] if end == "lower" else found["upper"]
    if pair is None:
        raise LimitReached("limit reached: the exponent or the length of an exact end; its digits can be had")
    return fraction_of(pair)


def _latex(numeral: str) -> str:
    mantissa, _, exponent = numeral.partition("e")
    return f"{mantissa} \\cdot 10^{{{int(exponent)}}}" if exponent else mantissa.replace("inf", "\\infty")


def number_of(chain: Chain, quantity: str, place: Tuple[int, ...], found: Found) -> Number:
    """An exact answer as a fraction, any other as an enclosure."""
    if found["exact"] is not None:
        return fraction_of(found["exact"])
    return Enclosure(chain, quantity, place, found)
