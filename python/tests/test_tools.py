"""Replays, worksheets, pictures, checks of tables, exports, certificates, and `python -m carom`."""

from __future__ import annotations

import pathlib
import subprocess
import sys
from fractions import Fraction

import pytest

import carom

SCENE = """title = "Three"
restitution = "1/2"
[[body]]
mass = 1
position = 0
velocity = 1
[[body]]
mass = 1
position = 1
[[body]]
mass = 1
position = 2
"""
CHAIN = 'title = "Cars"\n[chain]\nfirst = 10\ninserted = ["3"]\nlast = 1\nrestitution = "1/2"\n'
CLAIM = 'claim mine "Mine"\ngiven a, b real\nprove a^2 + b^2 >= 2*a*b\n'


def test_a_replay_is_exact():
    found = carom.replay(SCENE)
    assert (found.status, found.count, len(found)) == ("complete", 3, 3) and found.collisions[0].pair == (1, 2)
    assert sum(found.velocities) == 1 and all(isinstance(v, Fraction) for v in found.velocities)
    assert found.collisions[0].after == (Fraction(1, 4), Fraction(3, 4)) and "Three" in str(found)
    assert found.svg().startswith("<svg") and found._repr_svg_() == found.svg() and "<html" in found.html()
    assert carom.replay(SCENE, until="1/2").count == 0
    collapse = carom.replay(SCENE.replace("1/2", "1/20"))
    assert collapse.status == "collapse" and carom.replay(collapse._scene, through_collapse=True).status == "complete"
    for scene, sign in (("", "body"), (SCENE.replace('"1/2"', "2"), "outside"), (CHAIN, "chain")):
        with pytest.raises(ValueError, match=sign):
            carom.replay(scene)


def test_files_are_read_by_path_and_by_ending(tmp_path):
    (tmp_path / "s.toml").write_text(SCENE, encoding="utf-8")
    (tmp_path / "c.claim").write_text(CLAIM, encoding="utf-8")
    assert carom.replay(tmp_path / "s.toml").count == carom.replay(str(tmp_path / "s.toml")).count == 3
    assert carom.audit(tmp_path / "c.claim")["mine"].verdict == "proved"
    assert carom.audit(str(tmp_path / "c.claim"))["mine"].verdict == "proved"
    with pytest.raises(OSError):
        carom.audit("missing.claim")
    (tmp_path / "bad.claim").write_text(CLAIM.replace("2*", "2"), encoding="utf-8")
    with pytest.raises(ValueError, match=r"bad\.claim:3"):
        carom.audit(tmp_path / "bad.claim")


def test_an_audit_prints_its_verdicts():
    found = carom.audit(CLAIM + '\nclaim no "No"\ngiven x > 0\nprove x^2 > x\n')
    shown = str(found)
    assert "proved      mine  Mine" in shown and "refuted     no    No" in shown and "fails at x = " in shown
    assert shown.endswith("2 claims: 1 proved, 1 refuted, 0 undecided; 1 not as expected")
    assert repr(found["mine"]).startswith("Claim('mine', 'proved', ") and len(repr(found["mine"])) < 200
    pandas = pytest.importorskip("pandas")
    assert list(found.to_pandas()["verdict"]) == ["proved", "refuted"] and isinstance(
        found.to_pandas(), pandas.DataFrame
    )


def test_certificates_are_checked_by_the_kernel():
    claim = carom.audit(CLAIM)["mine"]
    assert "a" in carom.check(CLAIM, claim.certificate_text)
    with pytest.raises(ValueError, match="reject|another|statement"):
        carom.check(CLAIM.replace(">=", ">"), claim.certificate_text)
    assert "Proof" in carom.explain(CLAIM) and carom.explain(CLAIM, "mine") == claim.explanation
    with pytest.raises(ValueError, match="no claim is called"):
        carom.explain(CLAIM, "other")


def test_an_audit_is_written_as_the_command_writes_it(tmp_path):
    assert carom.report(CLAIM).startswith("#") and '"verdict": "proved"' in carom.report(CLAIM, form="json")
    (tmp_path / "c.claim").write_text(CLAIM, encoding="utf-8")
    assert "mine" in carom.report(tmp_path / "c.claim", form="text")
    with pytest.raises(ValueError, match="form"):
        carom.report(CLAIM, form="docx")


def test_the_package_brings_its_licences():
    from importlib import metadata

    files = {path.name for path in metadata.files("carom") or []}
    assert {"LICENSE-MIT", "LICENSE-APACHE", "LICENSE-DEJAVU", "LGPL-3.0", "GPL-3.0"} <= files
    about = metadata.metadata("carom")
    assert "LGPL-3.0-only" in about["License-Expression"] and about["Author"] == "The Carom authors"


def test_statements_are_exported():
    assert "(check-sat)" in carom.export(CLAIM, "smt2") and "Definition" in carom.export(CLAIM, "coq")
    with pytest.raises(ValueError, match="language"):
        carom.export(CLAIM, "lean")
    with pytest.raises(ValueError, match="natural"):
        carom.export('claim n "N"\ngiven n natural\nprove n + 1 > n\n', "smt2")


def test_worksheets_and_pictures():
    assert "Name" in carom.worksheet(CHAIN, sheet="blank", form="html")
    assert "answer key" in carom.worksheet(CHAIN) and "\\begin{document}" in carom.worksheet(CHAIN, form="latex")
    for wrong in ({"form": "pdf"}, {"sheet": "half"}, {"paper": "a5"}):
        with pytest.raises(ValueError):
            carom.worksheet(CHAIN, **wrong)
    picture = carom.plot("eta-n", ratio=100, e=["0.8", "0.9"], n=12)
    assert picture.startswith("<svg") and picture._repr_svg_() == picture
    assert carom.plot("eta-x", ratio=[1, 20], e="0.8", n=[0, 1]).startswith("<svg")
    assert carom.plot("threshold", ratio=[1, 100], n=[1, 2]).startswith("<svg")
    assert carom.plot("velocities", scene=CHAIN).startswith("<svg")
    for arguments in (("map", {}), ("pie", {"ratio": 1}), ("velocities", {}), ("eta-n", {"ratio": 10})):
        with pytest.raises(ValueError):
            carom.plot(arguments[0], **arguments[1])


def test_tables_are_checked_cell_by_cell(tmp_path):
    text = "# mine\nratio;e;n;eta\n4;1;0;0,64\n4;1;0;0,65\n\n100;0,9;2;0,2\n"
    (tmp_path / "t.csv").write_text(text, encoding="utf-8")
    cells = carom.check_table(tmp_path / "t.csv")
    assert [(c.line, c.right) for c in cells] == [(3, True), (4, False), (6, cells[2].right)]
    assert cells[1].judgement == "wrong from significant digit 2 on" and cells[1].certified == "0.64"
    assert carom.check_table([{"m1": 64, "m2": 1, "n": 2, "threshold": "44/81"}])[0].right
    assert carom.check_table([{"ratio": 64, "e": "44/81", "best-n": "2"}])[0].right
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame({"ratio": [4], "e": [1], "n": [0], "eta": ["0.64"]})
    assert carom.check_table(frame)[0].right
    for rows, sign in (
        ([{"a": 1}], "no column is called eta"),
        ([{"eta": 1, "e": 1, "n": 0}], "a column ratio"),
        ([{"eta": 1, "ratio": "x", "e": 1, "n": 0}], "ratio"),
        ([{"eta": 1, "ratio": 1, "e": 2, "n": 0}], "line 1: a coefficient of restitution"),
        ([{"eta": 1, "ratio": 1, "e": 1, "n": "1/2"}], "n counts bodies"),
    ):
        with pytest.raises(ValueError, match=sign):
            carom.check_table(rows)


def run(*arguments):
    return subprocess.run([sys.executable, "-m", "carom", *arguments], capture_output=True, text=True, timeout=300)


def test_the_module_is_a_command(tmp_path):
    (tmp_path / "s.toml").write_text(SCENE, encoding="utf-8")
    (tmp_path / "c.claim").write_text(CLAIM + '\nclaim no "No"\ngiven x > 0\nprove x^2 > x\n', encoding="utf-8")
    assert "3 collisions" in run("replay", str(tmp_path / "s.toml")).stdout
    out = run("audit", str(tmp_path / "c.claim"))
    assert out.returncode == 1 and "1 proved, 1 refuted" in out.stdout
    out = run("eval", "--m1", "64", "--m2", "1", "-e", "44/81", "-n", "2", "--want", "eta,helps")
    assert (out.returncode, out.stdout.split()) == (
        0,
        ["eta", "15625000000/282429536481", "helps", "exactly", "on", "the", "threshold"],
    )
    for arguments in (("eval", "--m1", "0", "--m2", "1"), ("audit", "no.claim"), ("replay", str(tmp_path / "c.claim"))):
        out = run(*arguments)
        assert out.returncode == 2 and out.stderr.startswith("error: ") and "Traceback" not in out.stderr, out.stderr


EXAMPLES = sorted((pathlib.Path(__file__).parent.parent / "examples").glob("*.py"))


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_examples_run_as_they_stand(example, tmp_path):
    needed = {"energy_curve": "matplotlib", "students_table": "pandas", "my_simulator": "hypothesis"}
    if example.stem in needed:
        pytest.importorskip(needed[example.stem])
    out = subprocess.run([sys.executable, str(example)], capture_output=True, text=True, timeout=600, cwd=tmp_path)
    assert out.returncode == 0, out.stderr
