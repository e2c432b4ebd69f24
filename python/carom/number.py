"""Numbers on their way in, which are exact, and out, which are exact or enclosed."""

from __future__ import annotations

import decimal
import math
import numbers
import operator
import re
import warnings
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Callable, Dict, Iterable, List, Optional, Tuple, Union

from . import _engine
from ._engine import LimitReached

if TYPE_CHECKING:
    from ._engine import Found
    from .chain import Chain

    Source = Union[Chain, Tuple[Any, Any, Any, Any]]

Exact = Union[int, str, Fraction, decimal.Decimal, "Number", Tuple[Any, Any]]
"""What a number may be given as. A text may be measured, ``"57.1 ± 0.1"`` or ``"[0.84, 0.90]"``; so may a pair of
ends and a result. Rationals of SymPy and flint are taken as well; balls of flint and intervals of mpmath are measured.
"""

_SHORT = 1 << 60
"""Integers below it are written at once."""


class WrongType(TypeError, ValueError):
    """An argument of the wrong type, such as a float: a :class:`TypeError`, and as all bad input a ValueError."""


_MAX_BITS = 14_000
"""Longer integers have more digits than Python writes without being asked."""

_MAX_DIGITS = 1_000
"""Digits up to which :func:`float` refines an enclosure before it gives up."""


def text_of(value: Any, name: str) -> str:
    """The text of an exact number for the engine, which judges it."""
    if isinstance(value, str):
        return value
    if type(value) is int and -_SHORT < value < _SHORT:
        return str(value)
    if isinstance(value, bool):
        raise WrongType(f"{name}: {value} is not a number")
    value = _foreign(value)
    if isinstance(value, tuple) and len(value) == 2:
        return f"[{text_of(value[0], name)}, {text_of(value[1], name)}]"
    if isinstance(value, (int, numbers.Rational)):
        parts = (int(value.numerator), int(value.denominator))
        if max(part.bit_length() for part in parts) > _MAX_BITS:
            raise LimitReached(f"{name}: limit reached: bits of a number: {_MAX_BITS} allowed")
        return f"{parts[0]}/{parts[1]}" if parts[1] != 1 else str(parts[0])
    if isinstance(value, decimal.Decimal):
        if not value.is_finite():
            raise ValueError(f"{name}: {value} is not a number; a finite one is expected")
        return str(value)
    if isinstance(value, numbers.Real):
        meant = Fraction(repr(float(value))) if math.isfinite(value) else None
        hint = f'"{meant}", or Fraction({float(value)!r}) for the float itself' if meant is not None else "a number"
        raise WrongType(f"{name}: the float {float(value)!r} is not exact; write {hint}")
    try:
        return str(operator.index(value))
    except TypeError:
        raise WrongType(f"{name}: {value!r} is not a number; give an int, a str or a Fraction") from None


def count_of(value: Any, name: str) -> int:
    """A natural number that fits a machine word."""
    try:
        found = operator.index(value)
    except TypeError:
        raise WrongType(f"{name}: {value!r} is no natural number") from None
    if isinstance(value, bool):
        raise WrongType(f"{name}: {value!r} is no natural number")
    if found < 0:
        raise ValueError(f"{name}: {value!r} is no natural number")
    if found >= 1 << 64:
        raise LimitReached(f"{name}: limit reached: {2**64 - 1} allowed")
    return found


def fraction_of(pair: Tuple[str, str]) -> Fraction:
    """The fraction that the engine sends."""
    return Fraction(int(pair[0], 16), int(pair[1], 16))


def _foreign(value: Any) -> Any:
    """A number of another library as Python's: a fraction, or the pair of its ends."""
    if isinstance(value, Number):
        exact = value.exact
        return exact if exact is not None else (value.exact_lo, value.exact_hi)
    module = type(value).__module__.partition(".")[0]
    if module == "flint":
        if type(value).__name__ == "fmpz":
            return Fraction(int(value))
        if hasattr(value, "p") and hasattr(value, "q"):
            return Fraction(int(value.p), int(value.q))
        if type(value).__name__ == "arb":
            ends = tuple(end.fmpq() for end in (value.lower(), value.upper()))
            return tuple(Fraction(int(end.p), int(end.q)) for end in ends)
    if module == "mpmath" and hasattr(value, "_mpi_"):
        return tuple(_of_mpmath(end) for end in value._mpi_)
    return value


def _of_mpmath(parts: Tuple[int, Any, int, int]) -> Fraction:
    """The fraction that a tuple of mpmath stands for: sign, mantissa, exponent, bits."""
    sign, mantissa, exponent, _ = parts
    return (-1) ** sign * Fraction(int(mantissa)) * Fraction(2) ** exponent


class Undecided(ValueError):
    """A comparison that the ends of enclosures leave open: neither answer would be certain."""


class UndecidedWarning(UserWarning):
    """An ``==`` that enclosures leave open was answered with False."""


_SPEC = re.compile(
    r"(?:.?[<>^])?(?P<rest>=?[+\- ]?[z#0]*)\d*(?P<comma>[,_]?)(?P<precision>\.\d+)?(?P<type>[a-zA-Z%]?)", re.S
)
"""The specification of a format."""


def _short(value: Any) -> str:
    """A value in a message: not longer than a line."""
    text = str(value)
    return text if len(text) <= 60 else f"{text[:60]}…"


_REFINED = (25, 60, 200, _MAX_DIGITS)
"""Digits to which both sides of an open comparison are narrowed, in turn."""


_Ends = Tuple[Fraction, Fraction]


class Number:
    """A result: an exact rational number, or one that lies between two known ends.

    Every result has ``exact`` (a fraction, or None), ``lo`` and ``hi`` (doubles rounded outwards), ``exact_lo`` and
    ``exact_hi`` (fractions), :meth:`digits` and :meth:`narrower`. Sums, products, quotients and powers of results with
    results and exact numbers are results again, and hold every possible value. A comparison narrows both sides until
    it is decided, and is :class:`Undecided` where that does not help. ``==`` never raises: it is True for equal
    fractions, closed forms and objects, and False, with an :class:`UndecidedWarning`, where no number of digits tells.

    A rational result is a :class:`fractions.Fraction` as well.
    """

    __slots__ = ()

    # What each kind of result says of itself.

    @property
    def exact(self) -> Optional[Fraction]:
        """The number itself, where it is known and rational."""
        raise NotImplementedError

    @property
    def exact_lo(self) -> Fraction:
        """At most the number, exactly."""
        raise NotImplementedError

    @property
    def exact_hi(self) -> Fraction:
        """At least the number, exactly."""
        raise NotImplementedError

    @property
    def radical(self) -> Optional[str]:
        """The closed form in the claim language, where the number is irrational and one is known."""
        return None

    @property
    def measured(self) -> bool:
        """Whether it is wide because inputs are measured: more digits do not narrow it."""
        return False

    _measured: bool

    def narrower(self, count: int) -> Tuple[Fraction, Fraction]:
        """Ends that agree to about so many digits, where nothing is measured."""
        raise NotImplementedError

    # What follows from it.

    @property
    def lo(self) -> float:
        """A double at most the number."""
        return _outward(self.exact_lo, -math.inf)

    @property
    def hi(self) -> float:
        """A double at least the number."""
        return _outward(self.exact_hi, math.inf)

    @property
    def mid(self) -> Fraction:
        """The middle between the ends, exactly."""
        return (self.exact_lo + self.exact_hi) / 2

    @property
    def radius(self) -> Fraction:
        """How far the ends are from the middle, exactly."""
        return (self.exact_hi - self.exact_lo) / 2

    def digits(self, count: int, *, rounding: str = "nearest") -> str:
        """The number with so many significant digits, each of them right.

        ``rounding`` is ``nearest``, ``up``, ``down``, ``zero`` or ``away``. Where more than one decimal is possible
        this is :class:`Undecided`.
        """
        return self._settled(lambda end: _rounded(end, count, rounding), count_of(count, "digits"))

    def _settled(self, function: Callable[[Fraction], Any], digits: int = 0) -> Any:
        """The value of a function that grows, if both ends have the same."""
        for more in _REFINED:
            lo, hi = (function(end) for end in self.narrower(digits + more))
            if lo == hi:
                return lo
            if self.measured:
                break
        raise Undecided(f"what is asked is open: the ends of the enclosure give {_short(lo)} and {_short(hi)}")

    def __contains__(self, value: Exact) -> bool:
        """Whether an exact number lies between the ends."""
        number = Fraction(text_of(value, "value"))
        return self.exact_lo <= number <= self.exact_hi

    # Arithmetic.

    def __add__(self, other: Any) -> Number:
        return _result("+", self, other)

    def __radd__(self, other: Any) -> Number:
        return _result("+", other, self)

    def __sub__(self, other: Any) -> Number:
        if isinstance(other, Number) and _same(self, other):
            return Rational(0)
        return _result("-", self, other)

    def __rsub__(self, other: Any) -> Number:
        return _result("-", other, self)

    def __mul__(self, other: Any) -> Number:
        return _result("*", self, other)

    def __rmul__(self, other: Any) -> Number:
        return _result("*", other, self)

    def __truediv__(self, other: Any) -> Number:
        return _result("/", self, other)

    def __rtruediv__(self, other: Any) -> Number:
        return _result("/", other, self)

    def __pow__(self, exponent: Any) -> Number:
        if isinstance(exponent, Fraction) and exponent.denominator != 1:
            return _broken_power(self, exponent)
        if isinstance(exponent, bool) or not isinstance(exponent, (int, Fraction)):
            return NotImplemented
        return _result("**", self, int(exponent))

    def __rpow__(self, base: Any) -> Number:
        return NotImplemented

    def sqrt(self) -> Number:
        """The square root, exact where it is rational.

        >>> mean([4, 9]).sqrt().digits(10)
        '2.549509757'
        """
        return self ** Fraction(1, 2)

    def __neg__(self) -> Number:
        return _result("-", 0, self)

    def __pos__(self) -> Number:
        return self

    def __abs__(self) -> Number:
        return _result("abs", self, 0)

    # Comparisons.

    def __lt__(self, other: Any) -> bool:
        return _decided(self, other, "<")

    def __le__(self, other: Any) -> bool:
        return _decided(self, other, "<=")

    def __gt__(self, other: Any) -> bool:
        return _decided(self, other, ">")

    def __ge__(self, other: Any) -> bool:
        return _decided(self, other, ">=")

    def __eq__(self, other: object) -> bool:
        return _equal(self, other)

    def __ne__(self, other: object) -> bool:
        found = _equal(self, other)
        return found if found is NotImplemented else not found

    def __hash__(self) -> int:
        # Equal numbers have one closed form, or are one object.
        radical = None if self.measured else self.radical
        return object.__hash__(self) if radical is None else hash(radical)

    def __bool__(self) -> bool:
        return not _decided(self, 0, "==")

    # Whole numbers and decimals.

    def __trunc__(self) -> int:
        return int(self._settled(math.trunc))

    def __int__(self) -> int:
        return self.__trunc__()

    def __floor__(self) -> int:
        return int(self._settled(math.floor))

    def __ceil__(self) -> int:
        return int(self._settled(math.ceil))

    def __round__(self, places: Optional[int] = None) -> Any:
        if places is None:
            return self._settled(lambda end: round(end))
        return self._settled(lambda end: round(end, places))

    def __format__(self, spec: str) -> str:
        found = _SPEC.fullmatch(spec)
        if found and not (found["rest"] or found["precision"] or found["type"]):
            # Width and alignment alone: of what str shows.
            return format(str(self), spec)
        if found and not found["precision"] and found["type"] in tuple("eEfFgG%"):
            # As a float has it: six digits.
            spec = f"{spec[:-1]}.6{found['type']}"
        return self._settled(lambda end: _formatted(end, spec))

    def to_fraction(self) -> Fraction:
        """The exact fraction; :class:`Undecided` where the number is not known to be one."""
        if self.exact is None:
            raise Undecided(f"{self} is not known as a fraction; exact_lo and exact_hi are its ends")
        return self.exact

    def to_decimal(self, digits: int = 28, *, rounding: str = "nearest") -> decimal.Decimal:
        """A :class:`decimal.Decimal` with so many digits, each of them right."""
        return decimal.Decimal(self.digits(digits, rounding=rounding))

    def to_mpmath(self) -> Any:
        """An interval of ``mpmath.iv`` that holds the number, at the precision set there."""
        from mpmath import iv  # type: ignore[import-untyped,import-not-found,unused-ignore]

        below, above = self.narrower(int(iv.dps) + 5)
        ends = [iv.mpf(end.numerator) / iv.mpf(end.denominator) for end in (below, above)]
        return iv.mpf([ends[0].a, ends[1].b])

    def _mpmath_(self, prec: int, rounding: str) -> Any:
        from mpmath import libmp, mp  # type: ignore[import-untyped,import-not-found,unused-ignore]

        def made(end: Fraction) -> Any:
            return libmp.from_rational(end.numerator, end.denominator, prec, rounding)

        return mp.make_mpf(self._settled(made, prec // 3))

    def to_sympy(self) -> Any:
        """The exact number in SymPy: a rational, or its closed form."""
        import sympy  # type: ignore[import-untyped,import-not-found,unused-ignore]

        if self.exact is not None:
            return sympy.Rational(self.exact.numerator, self.exact.denominator)
        if self.radical is None:
            raise Undecided(f"{self} has no closed form here; to_decimal gives digits")
        return sympy.sympify(self.radical.replace("^", "**"), rational=True)

    _sympy_ = to_sympy

    def to_flint(self) -> Any:
        """A ``flint.fmpq`` where the number is rational, else a ``flint.arb`` that holds it, at flint's precision."""
        import flint  # type: ignore[import-untyped,import-not-found,unused-ignore]

        def fraction(end: Fraction) -> Any:
            return flint.fmpq(end.numerator, end.denominator)

        if self.exact is not None:
            return fraction(self.exact)
        below, above = self.narrower(int(flint.ctx.dps) + 5)
        return flint.arb(fraction(below)).union(flint.arb(fraction(above)))


class Rational(Number, Fraction):  # type: ignore[misc]  # fractions of fractions are results here
    """A result that is known exactly: a fraction with the methods of every result."""

    __slots__ = ("_fixed",)

    _measured = False

    _fixed: Optional[_Fixed]

    def __new__(cls, numerator: Any = 0, denominator: Any = None) -> Rational:
        made = super().__new__(cls, numerator, denominator)
        made._fixed = None
        return made

    def _leaf(self, bits: int) -> Tuple[int, int]:
        above, below = self.numerator << bits, self.denominator
        return above // below, -(-above // below)

    def __reduce__(self) -> Tuple[Any, ...]:
        return (Rational, (self.numerator, self.denominator))

    def __repr__(self) -> str:
        return f"Fraction({self.numerator}, {self.denominator})"

    __str__ = Fraction.__str__

    def __hash__(self) -> int:  # type: ignore[override]
        return Fraction.__hash__(self)

    __float__ = Fraction.__float__

    @property
    def exact(self) -> Fraction:
        return Fraction(self.numerator, self.denominator)

    exact_lo = exact
    exact_hi = exact

    def narrower(self, count: int) -> Tuple[Fraction, Fraction]:
        exact = self.exact
        return exact, exact

    def digits(self, count: int, *, rounding: str = "nearest") -> str:
        return _rounded(self.exact, count_of(count, "digits"), rounding)


class Enclosure(Number):
    """A number between two others: an irrational one, or all values that measured inputs allow.

    ``lo`` and ``hi`` are doubles rounded outwards, ``exact_lo`` and ``exact_hi`` the fractions that they were rounded
    from. The number is never outside. An irrational number can be had to any number of digits: :meth:`digits`,
    :meth:`narrower`. ``x in enclosure`` asks whether a number lies between the ends.
    """

    __slots__ = ()

    _fixed: Optional[_Fixed]
    """What is remembered of the number: bits, and the ends of the number in units of 2^-bits, rounded outwards."""

    _measured: bool

    @property
    def exact(self) -> None:
        return None

    def _leaf(self, bits: int) -> Tuple[int, int]:
        """The ends in units of 2^-bits, rounded outwards."""
        digits = bits * 3 // 10 + 5
        lo, hi = self.narrower(digits)
        size = max(abs(lo.numerator), abs(hi.numerator)).bit_length() - hi.denominator.bit_length()
        if size > 0:
            lo, hi = self.narrower(digits + size * 3 // 10)
        return (lo.numerator << bits) // lo.denominator, -((-hi.numerator << bits) // hi.denominator)

    # Operators of two enclosures, without a look at what the other side could else be.

    def __add__(self, other: Any) -> Number:
        if isinstance(other, Enclosure):
            return Computed("+", self, other)
        return _result("+", self, other)

    def __rsub__(self, other: Any) -> Number:
        if type(other) is int and other in _INTEGERS:
            return Computed("-", _INTEGERS[other], self)
        return _result("-", other, self)

    def __rmul__(self, other: Any) -> Number:
        if type(other) is int and other in _INTEGERS:
            return Computed("*", _INTEGERS[other], self)
        return _result("*", other, self)

    def __sub__(self, other: Any) -> Number:
        if isinstance(other, Enclosure) and (type(self) is Computed or type(other) is Computed) and self is not other:
            return Computed("-", self, other)
        return super().__sub__(other)

    def __mul__(self, other: Any) -> Number:
        if isinstance(other, Enclosure):
            return Computed("*", self, other)
        return _result("*", self, other)

    def __lt__(self, other: Any) -> bool:
        if isinstance(other, Enclosure):
            a, b = self._fixed, other._fixed
            if a is not None and b is not None and a[0] == b[0]:
                if a[2] < b[1]:
                    return True
                if a[1] > b[2]:
                    return False
        return _decided(self, other, "<")

    def __gt__(self, other: Any) -> bool:
        if isinstance(other, Enclosure):
            return other < self
        return _decided(self, other, ">")

    def as_integer_ratio(self) -> Tuple[int, int]:
        """Refused: ``statistics.mean`` and its neighbours ask for it, and an irrational number has none."""
        # No ValueError: statistics would take that for a sign of infinity.
        raise TypeError(
            f"{_short(self)} is no quotient of integers; carom.mean and carom.stdev take any results, "
            "statistics.fmean takes their nearest doubles"
        )

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
        hint = "; float(x.mid) is its middle, float(x.radius) how far it reaches" if self.measured else ""
        raise ValueError(f"{self} has no one nearest double{hint}")

    def __str__(self) -> str:
        if self.measured:
            return _plus_minus(self.exact_lo, self.exact_hi)
        try:
            return self.digits(_SHOWN)
        except Undecided:
            return f"[{self.lo!r}, {self.hi!r}]"

    def __repr__(self) -> str:
        return f"Enclosure([{self.lo!r}, {self.hi!r}])" if self.measured else f"Enclosure({self})"

    def _repr_html_(self) -> str:
        """The closed form as MathML, which browsers show by themselves, and the digits."""
        if self.measured:
            return f"[{_html(repr(self.lo))}, {_html(repr(self.hi))}]"
        form = self._mathml()
        return f"{form} ≈ {_html(str(self))}" if form else f"≈ {_html(str(self))}"

    def _mathml(self) -> Optional[str]:
        """The closed form, where one is known."""
        return None

    def _repr_latex_(self) -> str:
        if self.measured:
            return f"$[{_latex(repr(self.lo))},\\; {_latex(repr(self.hi))}]$"
        return f"$\\approx {_latex(str(self))}$"


_SHOWN = 20
"""Digits that a computed number shows."""


class Answer(Enclosure):
    """An answer of the engine that is not exact."""

    __slots__ = ("_fixed", "_found", "_measured", "_place", "_quantity", "_source")

    def __init__(self, source: Source, quantity: str, place: Tuple[int, ...], found: Found) -> None:
        self._source = source
        self._quantity = quantity
        self._place = place
        self._found = found
        self._fixed = None
        self._measured = not (isinstance(source, tuple) or source.is_exact)

    def __reduce__(self) -> Tuple[Any, ...]:
        return (_answered, (self._chain(), self._quantity, self._place))

    def _chain(self) -> Chain:
        """The chain that the number is of; it is made where it is needed."""
        if isinstance(self._source, tuple):
            from .chain import Chain

            m1, m2, e, n = self._source
            self._source = Chain(m1, m2, e=e, n=n)
        return self._source

    @property
    def lo(self) -> float:
        """A double at most the number."""
        # The engine's zero may have a sign.
        return self._found.lo + 0.0

    @property
    def hi(self) -> float:
        """A double at least the number; at most two doubles above ``lo`` where nothing is measured."""
        return self._found.hi + 0.0

    @property
    def exact_lo(self) -> Fraction:
        """The lower end of the enclosure, exactly."""
        return _end(self._found.lower)

    @property
    def exact_hi(self) -> Fraction:
        """The upper end of the enclosure, exactly."""
        return _end(self._found.upper)

    @property
    def radical(self) -> str | None:
        """The closed form in the claim language, where the number is irrational and one is known."""
        return self._found.radical

    @property
    def measured(self) -> bool:
        """Whether it is wide because inputs are measured."""
        return self._measured

    def digits(self, count: int, *, rounding: str = "nearest") -> str:
        """The number with so many significant digits, each of them right.

        ``rounding`` is ``nearest``, ``up``, ``down``, ``zero`` or ``away``. A number over measured inputs has
        digits only as far as all its values round to the same; otherwise this is a :class:`ValueError`.
        """
        found = self._again(count, rounding).decimal
        if found is None:
            raise Undecided(
                f"the values over the measured inputs do not round to one decimal of {count} digits: {self}"
            )
        return found

    def narrower(self, count: int) -> Tuple[Fraction, Fraction]:
        """Ends that agree to about so many digits, where nothing is measured."""
        found = self._again(count, "nearest")
        return _end(found.lower), _end(found.upper)

    def _again(self, count: int, rounding: str) -> Found:
        answer: Any = self._chain()._answer(self._quantity, count_of(count, "digits"), rounding)
        return _at(answer, self._place)

    def __str__(self) -> str:
        found = None if self.measured else self._found.decimal
        return super().__str__() if found is None else found

    def _mathml(self) -> Optional[str]:
        return self._found.mathml

    def _repr_latex_(self) -> str:
        if self.measured:
            return f"$[{_latex(repr(self.lo))},\\; {_latex(repr(self.hi))}]$"
        form = self._found.latex
        shown = _latex(str(self))
        return f"$\\displaystyle {form} \\approx {shown}$" if form else f"$\\approx {shown}$"


def _at(answer: Any, place: Tuple[int, ...]) -> Found:
    """One number of an answer."""
    for index in place:
        answer = answer[index]
    return answer


def _answered(chain: Chain, quantity: str, place: Tuple[int, ...]) -> Answer:
    """An answer once more."""
    return Answer(chain, quantity, place, _at(chain._shown(quantity), place))


def _end(pair: Optional[Tuple[str, str]]) -> Fraction:
    if pair is None:
        raise LimitReached("limit reached: the exponent or the length of an exact end; its digits can be had")
    return fraction_of(pair)


def _html(numeral: str) -> str:
    mantissa, _, exponent = numeral.partition("e")
    return f"{mantissa} × 10<sup>{int(exponent)}</sup>" if exponent else mantissa.replace("inf", "∞")


def _latex(numeral: str) -> str:
    mantissa, _, exponent = numeral.partition("e")
    return f"{mantissa} \\cdot 10^{{{int(exponent)}}}" if exponent else mantissa.replace("inf", "\\infty")


class Root(Enclosure):
    """A root of a fraction that is no fraction itself."""

    __slots__ = ("_ends", "_fixed", "_index", "_radicand")

    _measured = False

    def __init__(self, radicand: Fraction, index: int) -> None:
        self._radicand, self._index = radicand, index
        self._fixed = None
        self._ends = self.narrower(_SHOWN)

    def __reduce__(self) -> Tuple[Any, ...]:
        return (Root, (self._radicand, self._index))

    @property
    def exact_lo(self) -> Fraction:
        return self._ends[0]

    @property
    def exact_hi(self) -> Fraction:
        return self._ends[1]

    @property
    def radical(self) -> str:
        return f"({self._radicand})^(1/{self._index})"

    def narrower(self, count: int) -> Tuple[Fraction, Fraction]:
        above, below, index = self._radicand.numerator, self._radicand.denominator, self._index
        # The root is at least 2^-(lost/index).
        lost = max(0, below.bit_length() - above.bit_length() + 1)
        places = count * 10 // 3 + 5 + lost // index
        floor = _floor_root((above << places * index) // below, index)
        return Fraction(floor, 1 << places), Fraction(floor + 1, 1 << places)


def _floor_root(number: int, index: int) -> int:
    """The greatest integer whose power is not above a natural number, by Newton's method from above."""
    found = 1 << -(-number.bit_length() // index)
    while True:
        lower = ((index - 1) * found + number // found ** (index - 1)) // index
        if lower >= found:
            return found
        found = lower


class Computed(Enclosure):
    """What arithmetic makes of results.

    Where nothing is measured it is only written down: what is asked of it narrows it as far as that needs. Its ends
    are whole numbers of units of 2^-bits. Each part remembers them, and is computed once, however often it occurs.
    """

    __slots__ = ("_ends", "_fixed", "_left", "_measured", "_operation", "_right")

    _ends: Optional[_Ends]

    def __init__(self, operation: str, left: Number, right: Number) -> None:
        self._operation = operation
        self._left: Any = left
        self._right: Any = right
        self._fixed = self._ends = None
        self._measured = self._left._measured or self._right._measured
        if self._measured or operation not in "+-*":
            self._check()

    def _check(self) -> None:
        """The ends of what is measured; whether a divisor is apart from 0, and a radicand not below it."""
        left, right = self._left, self._right
        if not self._measured and self._operation in ("/", "root"):
            side = right if self._operation == "/" else left
            for bits in _BITS:
                known = side._fixed
                try:
                    _, lo, hi = known if known is not None else _fixed(side, bits)
                except _Open:
                    continue
                if lo > 0 or (hi < 0 and side is right):
                    return
                side._fixed = None
        if self._measured or self._operation in ("/", "root"):
            ends = ((left.exact_lo, left.exact_hi), (right.exact_lo, right.exact_hi))
            try:
                found = _ENDS[self._operation](*ends)
            except Undecided:
                # A divisor that is not seen to be apart from 0 yet, or a radicand.
                found = _ENDS[self._operation](*(side.narrower(_MAX_DIGITS) for side in (left, right)))
            self._ends = _shortened(found, _LONG) if _is_long(found) else found

    def __reduce__(self) -> Tuple[Any, ...]:
        return (Computed, (self._operation, self._left, self._right))

    @property
    def exact_lo(self) -> Fraction:
        return self._shown()[0]

    @property
    def exact_hi(self) -> Fraction:
        return self._shown()[1]

    def _shown(self) -> _Ends:
        if self._ends is None:
            self._ends = self.narrower(_SHOWN)
        return self._ends

    @property
    def measured(self) -> bool:
        return self._measured

    def digits(self, count: int, *, rounding: str = "nearest") -> str:
        if self._measured:
            return super().digits(count, rounding=rounding)
        count = count_of(count, "digits")
        for bits in _BITS:
            if bits > count * 10 // 3 + 16:
                try:
                    _, lo, hi = _fixed(self, bits)
                except _Open:
                    continue
                if (hi - lo).bit_length() + count * 10 // 3 < max(-lo, hi).bit_length():
                    ends = [_engine.rounded((f"{end:x}", f"{1 << bits:x}"), count, rounding) for end in {lo, hi}]
                    if ends[0] == ends[-1]:
                        return ends[0]
        return super().digits(count, rounding=rounding)

    def narrower(self, count: int) -> Tuple[Fraction, Fraction]:
        if self._measured:
            return self._shown()
        for bits in _BITS:
            if bits > count * 10 // 3 + 8:
                try:
                    _, lo, hi = _fixed(self, bits)
                except _Open:
                    continue
                if (hi - lo) * 10**count <= max(-lo, hi):
                    return Fraction(lo, 1 << bits), Fraction(hi, 1 << bits)
        for more in _REFINED:
            ends = self._evaluated(count + more)
            if (ends[1] - ends[0]) * 10**count <= max(abs(end) for end in ends):
                break
        return ends

    def _evaluated(self, digits: int) -> Tuple[Fraction, Fraction]:
        """The ends from parts with so many digits: each part once, however often it occurs, and without recursion."""
        bits = digits * 10 // 3 + 64
        done: Dict[int, _Ends] = {}
        stack: List[Tuple[Number, bool]] = [(self, False)]
        while stack:
            part, ready = stack.pop()
            if id(part) in done:
                continue
            if not isinstance(part, Computed) or part.measured:
                done[id(part)] = part.narrower(digits)
            elif ready:
                sides = done[id(part._left)], done[id(part._right)]
                done[id(part)] = _shortened(_ENDS[part._operation](*sides), bits)
            else:
                stack.extend(((part, True), (part._right, False), (part._left, False)))
        return done[id(self)]


_Fixed = Tuple[int, int, int]
"""Bits, and the ends of a number in units of 2^-bits."""

_BITS = tuple(256 << place for place in range(8))
"""Bits after the point that are tried in turn. Numbers of very different sizes need more, and are narrowed by their
significant digits instead."""


class _Open(Exception):
    """So many bits do not show that a divisor is apart from 0, or that a radicand is not below it."""


def _fixed(number: Any, bits: int) -> _Fixed:
    """The ends of a number that is not measured, in units of 2^-bits: each part once, and without recursion."""
    stack = [number]
    while stack:
        part = stack[-1]
        known = part._fixed
        if known is not None and known[0] == bits:
            stack.pop()
            continue
        if type(part) is not Computed:
            part._fixed = (bits, *part._leaf(bits))
            stack.pop()
            continue
        left, right = part._left._fixed, part._right._fixed
        if left is None or left[0] != bits:
            stack.append(part._left)
            continue
        if right is None or right[0] != bits:
            stack.append(part._right)
            continue
        operation = part._operation
        if operation == "+":
            part._fixed = (bits, left[1] + right[1], left[2] + right[2])
        elif operation == "*":
            low, high = left[1] * right[1], left[2] * right[2]
            if left[1] < 0 or right[1] < 0:
                low, _, _, high = sorted((low, high, left[1] * right[2], left[2] * right[1]))
            part._fixed = (bits, low >> bits, -(-high >> bits))
        elif operation == "-":
            part._fixed = (bits, left[1] - right[2], left[2] - right[1])
        else:
            part._fixed = (bits, *_FIXED[operation](left, part._right, right))
        stack.pop()
    return number._fixed  # type: ignore[no-any-return]


def _fixed_quotient(a: _Fixed, _: Number, b: _Fixed) -> Tuple[int, int]:
    if b[1] <= 0 <= b[2]:
        raise _Open
    bits = a[0]
    below = [(end << bits) // divisor for end in a[1:] for divisor in b[1:]]
    return min(below), max(below) + 1


def _fixed_power(a: _Fixed, exponent: Number, _: _Fixed) -> Tuple[int, int]:
    power, bits = int(exponent), a[0]
    low, high = a[1:]
    if power < 0:
        if low <= 0 <= high:
            raise _Open
        low, high = _fixed_power(a, Rational(-power), a)
        return _fixed_quotient((bits, 1 << bits, 1 << bits), exponent, (bits, low, high))
    even = power % 2 == 0
    straddles = low < 0 < high
    if even or low >= 0:
        # By the sizes: the power of the smaller one is below.
        small, large = sorted((abs(low), abs(high)))
        down = 0 if straddles else _power_down(small, power, bits)
        return down, _power_up(large, power, bits)
    # An odd power rises.
    down = -_power_up(-low, power, bits)
    return down, (_power_up(high, power, bits) if high >= 0 else -_power_down(-high, power, bits))


def _power_down(base: int, power: int, bits: int) -> int:
    """At most the power of a number that is not negative."""
    found = 1 << bits
    while power:
        if power & 1:
            found = found * base >> bits
        base, power = base * base >> bits, power >> 1
    return found


def _power_up(base: int, power: int, bits: int) -> int:
    """At least the power of a number that is not negative."""
    found = 1 << bits
    while power:
        if power & 1:
            found = -(-found * base >> bits)
        base, power = -(-base * base >> bits), power >> 1
    return found


def _fixed_root(a: _Fixed, index: Number, _: _Fixed) -> Tuple[int, int]:
    bits, low, high = a
    if low < 0:
        raise _Open
    count = int(index)
    roots = [_floor_root(end << bits * (count - 1), count) if end else 0 for end in (low, high)]
    return roots[0], roots[1] + 1


def _fixed_absolute(a: _Fixed, _: Number, __: _Fixed) -> Tuple[int, int]:
    low, high = a[1:]
    small, large = sorted((abs(low), abs(high)))
    return (0 if low < 0 < high else small), large


_FIXED: Dict[str, Callable[[_Fixed, Any, _Fixed], Tuple[int, int]]] = {
    "/": _fixed_quotient,
    "**": _fixed_power,
    "root": _fixed_root,
    "abs": _fixed_absolute,
}
"""For each operation that :func:`_fixed` does not do itself the ends of the result, in the same units, outwards."""


# In Python's own messages both have the name that they show.
Answer.__name__ = Computed.__name__ = "Enclosure"

_LONG = 4_096
"""Bits beyond which the ends of a computed number are rounded outwards."""


def _is_long(ends: _Ends) -> bool:
    return any(max(end.numerator.bit_length(), end.denominator.bit_length()) > _LONG for end in ends)


def _shortened(ends: _Ends, bits: int) -> _Ends:
    """Ends outside of these, with so many significant bits."""

    def rounded(end: Fraction, up: bool) -> Fraction:
        places = bits - (end.numerator.bit_length() - end.denominator.bit_length())
        scaled = end * (1 << places) if places >= 0 else end / (1 << -places)
        whole = -(-scaled.numerator // scaled.denominator) if up else scaled.numerator // scaled.denominator
        return Fraction(whole, 1 << places) if places >= 0 else Fraction(whole << -places)

    return rounded(ends[0], False), rounded(ends[1], True)


def _broken_power(base: Number, exponent: Fraction) -> Number:
    """A broken power of a number that is not negative."""
    exact = base.exact
    if exact is None:
        return _result("root", base ** Fraction(exponent.numerator), exponent.denominator)
    if exact < 0:
        raise ValueError(f"{exact} to the power {exponent} is no real number")
    if exact == 0 and exponent < 0:
        raise ZeroDivisionError("0 to a negative power")
    radicand, index = exact**exponent.numerator, exponent.denominator
    roots = [_floor_root(part, index) if part else 0 for part in (radicand.numerator, radicand.denominator)]
    root = Fraction(roots[0], roots[1])
    return Rational(root) if root**index == radicand else Root(radicand, index)


def _product(a: _Ends, b: _Ends) -> _Ends:
    all_four = [x * y for x in a for y in b]
    return min(all_four), max(all_four)


def _quotient(a: _Ends, b: _Ends) -> _Ends:
    if b[0] <= 0 <= b[1]:
        if b[0] == b[1]:
            raise ZeroDivisionError("division by 0")
        raise Undecided("the divisor may be 0")
    return _product(a, (1 / b[1], 1 / b[0]))


def _power(a: _Ends, b: _Ends) -> _Ends:
    exponent = int(b[0])
    if exponent < 0:
        return _quotient((Fraction(1), Fraction(1)), _power(a, (-b[0], -b[1])))
    powers = sorted((a[0] ** exponent, a[1] ** exponent))
    if exponent % 2 == 0 and exponent > 0 and a[0] < 0 < a[1]:
        return Fraction(0), powers[1]
    return powers[0], powers[1]


def _root(a: _Ends, b: _Ends) -> _Ends:
    if a[0] < 0:
        if a[1] < 0:
            raise ValueError(f"a number below 0, {_short(float(a[1]))}, has no real root")
        raise Undecided("the radicand may be below 0")
    index = int(b[0])
    # As many bits as the ends have, and some: a root is less wide than its radicand.
    bits = 64 + max(max(end.numerator.bit_length(), end.denominator.bit_length()) for end in a)

    def floor(end: Fraction) -> int:
        scaled = (end.numerator << bits * index) // end.denominator
        return _floor_root(scaled, index) if scaled else 0

    return Fraction(floor(a[0]), 1 << bits), Fraction(floor(a[1]) + 1, 1 << bits)


def _absolute(a: _Ends, _: _Ends) -> _Ends:
    if a[0] < 0 < a[1]:
        return Fraction(0), max(-a[0], a[1])
    sizes = sorted((abs(a[0]), abs(a[1])))
    return sizes[0], sizes[1]


_ENDS: Dict[str, Callable[[_Ends, _Ends], _Ends]] = {
    "+": lambda a, b: (a[0] + b[0], a[1] + b[1]),
    "-": lambda a, b: (a[0] - b[1], a[1] - b[0]),
    "*": _product,
    "/": _quotient,
    "**": _power,
    "root": _root,
    "abs": _absolute,
}
"""For each operation the ends of the result from those of its sides: no possible value is outside."""


_INTEGERS = {number: Rational(number) for number in range(-16, 1025)}
"""Integers that are often written in formulas; what is remembered of them is shared."""


def _operand(value: Any) -> Optional[Number]:
    """An exact number or a result; None for anything else, a float too, which is seldom the number that is meant."""
    if type(value) is int:
        found = _INTEGERS.get(value)
        return Rational(value) if found is None else found
    if isinstance(value, Number):
        return value
    if isinstance(value, bool):
        return None
    if isinstance(value, (int, numbers.Rational)):
        return Rational(int(value.numerator), int(value.denominator))
    if isinstance(value, decimal.Decimal) and value.is_finite():
        return Rational(Fraction(value))
    exact = _foreign(value)
    return Rational(exact) if isinstance(exact, Fraction) else None


def _result(operation: str, left: Any, right: Any) -> Number:
    sides = _operand(left), _operand(right)
    if sides[0] is None or sides[1] is None:
        for value in (left, right):
            if isinstance(value, float):
                text_of(value, operation)
        return NotImplemented
    if isinstance(sides[0], Rational) and isinstance(sides[1], Rational):
        exact = sides[0].exact, sides[1].exact
        return Rational(_ENDS[operation]((exact[0], exact[0]), (exact[1], exact[1]))[0])
    return Computed(operation, sides[0], sides[1])


def _decided(left: Number, right: Any, relation: str) -> bool:
    """A comparison, narrowed until it is decided."""
    if isinstance(right, float) and not isinstance(right, Number):
        if math.isnan(right):
            return False
        if math.isinf(right):
            return {"<": right > 0, "<=": right > 0, ">": right < 0, ">=": right < 0, "==": False}[relation]
        # A comparison with the double itself: exact.
        right = Fraction(right)
    other = _operand(right)
    if other is None:
        return NotImplemented
    if relation == "==" and left is other and not left.measured:
        return True
    if not (left._measured or other._measured):
        for bits in _BITS[:2]:
            try:
                fixed = _fixed(left, bits)[1:], _fixed(other, bits)[1:]
            except _Open:
                continue
            found = answer_of(fixed[0], fixed[1], relation)
            # Both may be rounded: that ends meet says nothing.
            if found is not None and (relation != "==" or not found):
                return found
    for digits in _REFINED:
        a, b = left.narrower(digits), other.narrower(digits)
        found = answer_of(a, b, relation)
        if found is not None:
            return found
        if left.measured or other.measured:
            break
    raise Undecided(f"{left} {relation} {other} is open: their enclosures overlap")


def _same(left: Number, right: Number) -> bool:
    """Whether they are one object or have one closed form; a measured value may be any in its range."""
    if left.measured or right.measured:
        return False
    return left is right or (left.radical is not None and left.radical == right.radical)


def _equal(left: Number, right: Any) -> bool:
    """Whether two numbers are known to be equal; a warning where they may be and nothing tells."""
    other = right if isinstance(right, Number) else None
    if other is not None and _same(left, other):
        return True
    try:
        return _decided(left, right, "==")
    except Undecided as error:
        if left.measured or (other is not None and other.measured):
            # A range is one number only by chance.
            return False
        warnings.warn(f"{error}; == is False", UndecidedWarning, stacklevel=3)
        return False


def answer_of(a: Tuple[Any, Any], b: Tuple[Any, Any], relation: str) -> Optional[bool]:
    if relation in (">", ">="):
        return answer_of(b, a, "<" if relation == ">" else "<=")
    below, above = a[1] < b[0], a[0] > b[1]
    if relation == "==":
        return True if a[0] == a[1] == b[0] == b[1] else False if below or above else None
    if relation == "<":
        return True if below else False if a[0] >= b[1] else None
    return True if a[1] <= b[0] else False if above else None


def _rounded(number: Fraction, digits: int, rounding: str) -> str:
    sign = "-" if number < 0 else ""
    return _engine.rounded((f"{sign}{abs(number.numerator):x}", f"{number.denominator:x}"), digits, rounding)


def _plus_minus(lo: Fraction, hi: Fraction) -> str:
    """A centre and a reach of two digits, which hold both ends: no possible value is outside."""
    centre, reach = (lo + hi) / 2, (hi - lo) / 2
    if not reach:
        return str(centre)
    place = 1 - decimal.Decimal(_rounded(reach, 2, "up")).adjusted()
    scale = Fraction(10) ** place
    middle = round(centre * scale)
    width = math.ceil(max(hi * scale - middle, middle - lo * scale))
    if 0 <= place <= _SHOWN:
        return f"{_decimal_of(middle, place)} ± {_decimal_of(width, place)}"
    return f"({middle} ± {width})e{-place}"


def _decimal_of(whole: int, places: int) -> str:
    """A whole number of units of the last place as a decimal."""
    digits = str(abs(whole)).rjust(places + 1, "0")
    point = f".{digits[-places:]}" if places else ""
    return f"{'-' if whole < 0 else ''}{digits[: len(digits) - places]}{point}"


def _outward(number: Fraction, towards: float) -> float:
    """The double next to a fraction in a direction."""
    try:
        nearest = number.numerator / number.denominator
    except OverflowError:
        nearest = math.inf if number > 0 else -math.inf
    outside = nearest >= number if towards > 0 else nearest <= number
    return nearest if outside else math.nextafter(nearest, towards)


def _formatted(number: Fraction, spec: str) -> str:
    """As :class:`decimal.Decimal` is formatted, with so many digits that rounding twice changes nothing."""
    length = (abs(number.numerator).bit_length() + number.denominator.bit_length()) // 3
    places = re.search(r"\.(\d+)", spec)
    digits = 2 * length + 50 + (int(places.group(1)) if places else 0)
    with decimal.localcontext() as context:
        context.prec = min(digits, 100_000)
        context.Emax, context.Emin = decimal.MAX_EMAX, decimal.MIN_EMIN
        return format(decimal.Decimal(number.numerator) / decimal.Decimal(number.denominator), spec)


def mean(values: Iterable[Any]) -> Number:
    """The mean of results and exact numbers; ``statistics.mean`` takes rational ones only.

    >>> mean([1, Fraction(1, 2)])
    Fraction(3, 4)
    """
    numbers_ = _operands(values)
    if not numbers_:
        raise ValueError("mean: give at least one number")
    return _total(numbers_) / len(numbers_)


def stdev(values: Iterable[Any]) -> Number:
    """The standard deviation of a sample.

    It is the root of the sum of the squared distances from the mean, divided by one less than their count.

    >>> stdev([1, 2, 3])
    Fraction(1, 1)
    """
    numbers_ = _operands(values)
    if len(numbers_) < 2:
        raise ValueError("stdev: give at least two numbers")
    middle = _total(numbers_) / len(numbers_)
    squares = [(number - middle) ** 2 for number in numbers_]
    return (_total(squares) / (len(numbers_) - 1)).sqrt()


def _operands(values: Iterable[Any]) -> List[Number]:
    found = []
    for value in values:
        number = _operand(value)
        if number is None:
            raise WrongType(f"{value!r} is no exact number; give results, integers, fractions or decimals")
        found.append(number)
    return found


def _total(values: List[Number]) -> Number:
    """A sum, halved again and again: no part of it is deep."""
    while len(values) > 1:
        pairs = [a + b for a, b in zip(values[::2], values[1::2])]
        values = pairs + values[len(values) - len(values) % 2 :]
    return values[0]


def number_of(chain: Chain, quantity: str, place: Tuple[int, ...], found: Found) -> Number:
    """An exact answer as a fraction, any other as an enclosure."""
    exact = found.exact
    if exact is not None:
        return Rational(fraction_of(exact))
    return Answer(chain, quantity, place, found)
