"""Laws for Hypothesis: claims of the language as strategies and tests, and strategies for chains, in exact fractions.

Hypothesis is needed for this module only. Every point that is drawn satisfies the hypotheses of its claim for certain.
"""

from __future__ import annotations

import functools
from fractions import Fraction
from typing import Any, Callable, Dict, List, Optional, Tuple, TypeVar

from hypothesis import assume, given
from hypothesis import strategies as st

from . import _engine, chain
from .audit import Claim, audit
from .source import Text, claims_of

_RANDOM = 64
"""Random numbers from which a point is made; what exceeds them is the simplest choice."""

_SIZE = 60
"""The largest numerator and denominator of a random number."""

_Test = TypeVar("_Test", bound=Callable[..., None])


class Point(Dict[str, Fraction]):
    """The values of a claim's variables, by name; a member of a family is called ``mu(2)``."""

    holds: Optional[bool]
    """Whether the goal holds here; None where that is left open."""


def points(text: Text) -> st.SearchStrategy[Point]:
    """Points that satisfy the hypotheses of a claim; simpler ones while a test fails.

    >>> points("given m1, m2 > 0;  e in [0, 1]\\nprove m1 > 0").example().keys()  # doctest: +SKIP
    dict_keys(['m1', 'm2', 'e'])
    """
    claim = claims_of(text).text
    # A fault of the text is told here and now.
    _engine.law_point(claim, [])

    def drawn(random: List[int]) -> Optional[Point]:
        found = _engine.law_point(claim, random)
        if found is None:
            return None
        point = Point((name, Fraction(value)) for name, value in found[0])
        point.holds = found[1]
        return point

    random = st.lists(st.integers(0, 2**32 - 1), min_size=_RANDOM, max_size=_RANDOM)
    found: st.SearchStrategy[Any] = random.map(drawn)
    return found.filter(lambda point: point is not None)


class Law:
    """What :func:`law` makes of a test: calling it proves the claim, or tries it."""

    def __init__(self, text: str, test: Callable[..., None]) -> None:
        self.text = text
        self._test = test
        functools.update_wrapper(self, test)
        # Otherwise test runners would ask for the arguments of the function inside.
        del self.__wrapped__  # type: ignore[attr-defined]
        self._verdict: Optional[Claim] = None

    @property
    def claim(self) -> Claim:
        """The claim with its verdict."""
        if self._verdict is None:
            self._verdict = audit(self.text)[0]
        return self._verdict

    @property
    def proved(self) -> bool:
        """Whether the kernel accepted a proof: then the claim itself is not tried at points."""
        return self.claim.verdict == "proved"

    def __repr__(self) -> str:
        return f"Law({self.claim.id!r}, {self.claim.verdict!r})"

    def __call__(self) -> None:
        if self.proved:
            print(f"{self.claim.id}: proved for all values, certificate {self.claim.certificate}; not tried")
        proved = self.proved

        @given(points(self.text))
        def at(point: Point) -> None:
            if not proved:
                assert point.holds is not False, f"{self.claim.statement} is false at {dict(point)}"
            self._test(point)

        at()


def law(text: Text) -> Callable[[Callable[[Point], None]], Any]:
    """Makes a test of a claim and of your own code: the function is called at points where the hypotheses hold.

    The claim is judged first. A claim that is proved is reported as proved and not tried; any other must hold at every
    point. Either way your function runs at the points, and may compare them with your own code::

        @carom.law("given m1, m2 > 0;  e in [0, 1]\\nprove (1 + e)*m1/(m1 + m2) <= 2")
        def test_gain(at):
            assert my_gain(at["m1"], at["m2"], at["e"]) <= 2
    """

    def made(test: Callable[[Point], None]) -> Any:
        return _as_function(Law(claims_of(text).text, test))

    return made


def _as_function(found: Law) -> Callable[[], None]:
    """A plain function, which pytest collects, with the law as its attribute."""

    def test() -> None:
        found()

    test.__name__ = getattr(found, "__name__", "test")
    test.__qualname__ = test.__name__
    test.__doc__ = found.__doc__
    test.__module__ = found.__module__
    test.law = found  # type: ignore[attr-defined]
    return test


def positive() -> st.SearchStrategy[Fraction]:
    """A fraction above 0."""
    return st.builds(Fraction, st.integers(1, _SIZE), st.integers(1, _SIZE))


def restitutions() -> st.SearchStrategy[Fraction]:
    """A coefficient of restitution from 0 to 1, the ends among them."""
    pair = st.tuples(st.integers(0, _SIZE), st.integers(1, _SIZE))
    return pair.map(lambda parts: Fraction(min(parts), parts[1]))


def masses(least: int = 2, most: int = 7) -> st.SearchStrategy[List[Fraction]]:
    """The masses of a chain."""
    return st.lists(positive(), min_size=least, max_size=most)


def extreme_masses(least: int = 2, most: int = 7) -> st.SearchStrategy[List[Fraction]]:
    """The masses of a chain with neighbours up to 10**30 apart: what is lost in doubles."""
    steps = st.lists(st.tuples(positive(), st.integers(-30, 30)), min_size=least - 1, max_size=most - 1)

    def made(found: List[Tuple[Fraction, int]]) -> List[Fraction]:
        list_ = [Fraction(1)]
        for factor, exponent in found:
            list_.append(list_[-1] * factor * Fraction(10) ** exponent)
        return list_

    return steps.map(made)


@st.composite
def chains(draw: Any, *, extreme: bool = False, same_e: bool = False) -> chain.Chain:
    """A chain of given masses with a coefficient for each collision, or one for all."""
    found = draw(extreme_masses() if extreme else masses())
    count = 1 if same_e or draw(st.booleans()) else len(found) - 1
    e = [draw(restitutions()) for _ in range(count)]
    return chain.Chain(found[0], found[-1], e=e[0] if len(e) == 1 else e, masses=found[1:-1])


_DISTANCES = st.one_of(
    st.just(Fraction(0)), st.builds(lambda k, s: s * Fraction(1, 10**k), st.integers(1, 30), st.sampled_from([1, -1]))
)
"""From a threshold: none, or a power of ten on either side."""


@st.composite
def near_threshold(draw: Any) -> chain.Chain:
    """A chain of optimal masses whose restitution is L_n exactly, or differs from it by 10**-k.

    The ratio of the ends is t**(n*(n + 1)), so that L_n is rational.
    """
    t = draw(st.builds(Fraction, st.integers(1, 6), st.integers(1, 6)))
    n = draw(st.integers(1, 4))
    ratio = t ** (n * (n + 1))
    e = chain.threshold(ratio, 1, n=n).to_fraction() + draw(_DISTANCES)
    assume(0 <= e <= 1)
    return chain.Chain(ratio, 1, e=e, n=n)


@st.composite
def near_insertion(draw: Any) -> chain.Chain:
    """A chain of given masses whose restitution is the threshold of one of its inserted bodies, or nearly."""
    found = sorted(draw(masses(least=3)))
    place = draw(st.integers(0, len(found) - 3))
    threshold = chain.threshold(found[0], found[-1], masses=found[1:-1])[place]
    e = threshold.to_fraction() + draw(_DISTANCES)
    assume(0 <= e <= 1)
    return chain.Chain(found[0], found[-1], e=e, masses=found[1:-1])
