"""Laws: points of claims for Hypothesis, and what is proved is not tried."""

from __future__ import annotations

from fractions import Fraction

import pytest

import carom

hypothesis = pytest.importorskip("hypothesis")

from carom import laws  # noqa: E402

GAIN = "given m1, m2 > 0;  e in [0, 1]\nprove (1 + e)*m1/(m1 + m2) <= 2"


def test_points_satisfy_the_hypotheses():
    text = "given a > 0;  b in [a, 2*a];  n natural in 1..4;  mu(k) in (0, 1)\nprove b*mu(n) < 7"

    @hypothesis.given(laws.points(text))
    def each(at):
        mu = at[f"mu({at['n']})"]
        assert 0 < at["a"] <= at["b"] <= 2 * at["a"] and 1 <= at["n"] <= 4 and 0 < mu < 1
        assert at.holds is (at["b"] * mu < 7)

    each()


def test_a_law_that_is_proved_is_reported_and_not_tried(capsys):
    seen = []

    @carom.law(GAIN)
    def mine(at):
        seen.append(at)
        assert (1 + at["e"]) * at["m1"] / (at["m1"] + at["m2"]) <= 2

    mine()
    assert mine.law.proved and len(seen) > 10 and "proved for all values" in capsys.readouterr().out
    assert mine.__name__ == "mine"


def test_a_law_that_is_false_fails_at_a_point():
    @carom.law(GAIN.replace("<= 2", "<= 1"))
    def wrong(at):
        pass

    with pytest.raises(AssertionError, match="is false at"):
        wrong()
    assert wrong.law.claim.verdict == "refuted"


def test_ones_own_mistake_is_shrunk_to_a_simple_point():
    @carom.law(GAIN)
    def doubles(at):
        assert at["e"] < Fraction(1, 2), dict(at)

    with pytest.raises(AssertionError) as caught:
        doubles()
    assert "'e': Fraction(1, " in str(caught.value) or "'e': Fraction(" in str(caught.value)


def test_a_fault_of_the_text_is_told_at_once():
    with pytest.raises(ValueError, match="nothing declares"):
        laws.points("given x > 0\nprove y > 0")


@hypothesis.given(laws.chains())
def test_chains_lose_no_momentum(chain):
    masses, velocities = chain.masses(), chain.velocities()
    assert sum(m * v for m, v in zip(masses, velocities)) == masses[0]


@hypothesis.given(laws.chains(extreme=True, same_e=True))
def test_extreme_chains_lose_none_either(chain):
    masses, velocities = chain.masses(), chain.velocities()
    assert sum(m * v for m, v in zip(masses, velocities)) == masses[0]


def test_thresholds_are_met_exactly():
    answers = set()

    @hypothesis.settings(max_examples=300)
    @hypothesis.given(laws.near_threshold())
    def each(chain):
        answers.add(str(chain.helps()))

    each()
    assert answers == {"yes", "no", "exactly on the threshold"}


@hypothesis.given(laws.near_insertion())
def test_a_body_on_its_threshold_changes_nothing(chain):
    for threshold, helps in zip(chain.threshold(), chain.helps()):
        assert helps in ("yes", "no", "exactly on the threshold") and isinstance(threshold, Fraction)
