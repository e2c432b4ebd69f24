"""A law of the language as a test of one's own code. Needs Hypothesis; `pytest my_simulator.py` runs it as well."""

from fractions import Fraction
from typing import Tuple

from carom.laws import Point, law


def collide(m1: Fraction, m2: Fraction, v: Fraction, e: Fraction) -> Tuple[Fraction, Fraction]:
    """Somebody's collision with a body at rest."""
    impulse = (1 + e) * m1 * m2 / (m1 + m2) * v
    return v - impulse / m1, impulse / m2


@law("given m1, m2, v > 0;  e in [0, 1]\nprove (1 + e)^2*m1*m2/(m1 + m2)^2 <= 1")
def test_no_energy_is_made(at: Point) -> None:
    w1, w2 = collide(at["m1"], at["m2"], at["v"], at["e"])
    assert at["m1"] * w1**2 + at["m2"] * w2**2 <= at["m1"] * at["v"] ** 2


if __name__ == "__main__":
    test_no_energy_is_made()
