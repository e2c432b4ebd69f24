"""The coefficient of restitution from measured bounces."""

from __future__ import annotations

import random
import subprocess
import sys
from fractions import Fraction

import pytest

import carom


def test_the_true_coefficient_is_never_outside():
    random.seed(3)
    for _ in range(1000):
        e = Fraction(random.randrange(300, 1000), 1000)
        power = random.choice((1, 2))
        height, readings = Fraction(random.randrange(50, 300), 100), []
        for _ in range(random.randrange(2, 6)):
            wrong = Fraction(random.randrange(-100, 101), 100) * Fraction(1, 500)
            readings.append(f"{height + wrong} ± 1/500")
            height *= e**power
            if height < Fraction(1, 20):
                break
        if len(readings) < 2:
            continue
        found = carom.restitution(**{"times" if power == 1 else "heights": readings})
        assert found and found.lower <= e <= found.upper, (e, readings)


def test_bounds_are_numbers_with_their_readings():
    found = carom.restitution(heights=["1.00", "0.64 ± 0.15"])
    assert found.lower == Fraction(7, 10) and found.lower_from == ((1, "1.00"), (2, "0.64 ± 0.15"))
    assert found.upper.radical == "(79/100)^(1/2)" and found.upper.digits(12) == "0.888819441732"
    assert found.upper * found.upper < Fraction(80, 100) and found.readings == 2 and found.consistent
    assert str(found).startswith("e = ") and "consistent with one e: 2 readings" in str(found)
    assert carom.restitution(times=[1, "1.1"], within="0.2").upper_from is None


def test_a_contradiction_names_both_pairs():
    found = carom.restitution(heights=[["1.00", "0.64"], ["1.00", "0.49"]], within="0.01")
    assert not found and found.lower > found.upper
    assert (found.lower_from, found.upper_from) == (((1, "1.00"), (2, "0.64")), ((3, "1.00"), (4, "0.49")))
    assert "readings 1 and 2 (1.00 and 0.64)" in str(found) and repr(found) == "Bounces(no e fits, readings=4)"


def test_a_file_is_read_as_the_command_reads_it(tmp_path):
    path = tmp_path / "b.csv"
    path.write_text("# ours\nrun;height\na;1,20\na;0,86\nb;1,00\nb;0,71\n", encoding="utf-8")
    found = carom.restitution(path, within="1 %")
    assert found and found.readings == 4 and "lines " in str(found)
    assert carom.restitution("drop,bounce\n1.0,0.7\n", within="0.01").readings == 2
    run = [sys.executable, "-m", "carom", "restitution", str(path), "--within", "0.001"]
    out = subprocess.run(run, capture_output=True, text=True, timeout=300)
    assert out.returncode == 1 and "no e fits 4 readings" in out.stdout


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({}, "nothing is given"),
        ({"heights": [1], "times": [1]}, "heights and times is given"),
        ({"heights": [1]}, "2 .*needed|needs|readings"),
        ({"heights": "1.0"}, "a list of readings"),
        ({"heights": [1, [2]]}, "not both"),
        ({"heights": [1, "-1"]}, "reading 2: .*above 0"),
        ({"heights": [1, 0.5]}, "float"),
        ({"heights": [1, "1/2"], "within": "x"}, "within x"),
        ({"measured": "a,b\n1,2\n"}, "expected a column height"),
    ],
)
def test_bad_measurements_are_refused(arguments, message):
    with pytest.raises(ValueError, match=message):
        carom.restitution(**arguments)
