"""What several tests use."""

from __future__ import annotations

from fractions import Fraction
from typing import Tuple

import pytest


def root(r: Fraction, k: int, bits: int = 160) -> Tuple[Fraction, Fraction]:
    """Bounds of the k-th root in integers: independent of the engine."""
    scaled = (r.numerator << (k * bits)) // r.denominator
    low, high = 0, 1 << (scaled.bit_length() // k + 1)
    while low < high:
        middle = (low + high + 1) // 2
        low, high = (middle, high) if middle**k <= scaled else (low, middle - 1)
    return Fraction(low, 1 << bits), Fraction(low + 1, 1 << bits)


def eta_bounds(r: Fraction, e: Fraction, n: int) -> Tuple[Fraction, Fraction]:
    """Bounds of equation (25)."""
    low, high = root(r, n + 1)
    gain = (1 + e) ** (2 * (n + 1)) * r
    return gain / (1 + high) ** (2 * (n + 1)), gain / (1 + low) ** (2 * (n + 1))


def threshold_bounds(r: Fraction, n: int) -> Tuple[Fraction, Fraction]:
    """Bounds of equation (19)."""
    a, b = root(r, n + 1), root(r, n)
    return (1 + a[0]) ** (n + 1) / (1 + b[1]) ** n - 1, (1 + a[1]) ** (n + 1) / (1 + b[0]) ** n - 1


@pytest.fixture
def bounds():
    return eta_bounds, threshold_bounds
