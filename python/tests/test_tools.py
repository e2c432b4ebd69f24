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
    for scene, sign in (("", "body"), (SCENE.replace('"1/2"', "2"), "from 0 to 1"), (CHAIN, "chain")):
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


def test_versions_of_worksheets_and_pages():
    both = [carom.worksheet(CHAIN, versions=2, seed=seed, sheet="blank") for seed in (7, 7, 8)]
    assert both[0] == both[1] != both[2] and both[0].count("version B") >= 1
    assert carom.worksheet_pdf(CHAIN, versions=2).startswith(b"%PDF-")
    assert carom.worksheet(CHAIN, places=1) != carom.worksheet(CHAIN, places=3)
    with pytest.raises(carom.LimitReached, match="26"):
        carom.worksheet(CHAIN, versions=27)


def test_pictures_look_as_they_are_asked_to():
    asked = {"ratio": [1, 20], "e": "0.8", "n": [0, 1]}
    plain = carom.plot("eta-x", **asked)
    assert "Ours" in carom.plot("eta-x", title="Ours", **asked) and carom.plot("eta-x", grey=True, **asked) != plain
    marked = carom.plot("eta-x", mark=[("10.6 ± 0.4", "0.31(2)")], xlim=(1, 15), **asked)
    assert "measured" in marked
    for wrong in ({"xlim": (2, 1)}, {"xlim": "0,1"}, {"mark": [(1, "x")]}, {"mark": [("1000", "0.5")]}):
        with pytest.raises(ValueError):
            carom.plot("eta-x", **asked, **wrong)


def test_a_table_is_written_as_the_command_writes_it(tmp_path):
    asked = {"ratio": "1/3,9", "e": ["1/2", "2/3"], "n": "0:2:1"}
    for form, sign in (
        ("csv", "# formula"),
        ("latex", "toprule"),
        ("json", '"rows"'),
        ("markdown", "| --: |"),
        ("text", "eta"),
    ):
        assert sign in carom.table_text(form=form, **asked), form
    for form in ("spreadsheet", "spreadsheet-comma"):
        text = carom.table_text(form=form, **asked)
        assert text[0] == "\ufeff" and "/" not in text and "1\u20444" in text
        (tmp_path / "t.csv").write_text(text, encoding="utf-8")
        assert all(cell.right for cell in carom.check_table(tmp_path / "t.csv"))
    assert carom.table_text(ratio=2, n=1, want="threshold", places=2, rounding="up", form="csv").endswith("0.95,\n")
    for wrong in ({"form": "docx"}, {"rounding": "odd"}, {"want": "mass"}, {"digits": 0}):
        with pytest.raises(ValueError):
            carom.table_text(**{**asked, **wrong})
    with pytest.raises(carom.LimitReached):
        carom.table_text(ratio="1:10000000:1", e=1, n=1)


def test_a_refuted_claim_is_repaired():
    found = carom.repair("c", 'claim c "C"\ngiven x real\nprove x^2 > 0\n')
    assert (found.hypothesis, found.exact) == ("x != 0", False) and "x != 0" in carom.check(
        found.claim, found.certificate
    )
    with pytest.raises(ValueError, match="is proved; only a refuted claim"):
        carom.repair("mine", CLAIM)
    with pytest.raises(ValueError, match="no claim is called"):
        carom.repair("eq99")


def test_the_catalogue_is_listed_and_claims_are_formatted():
    listed = carom.catalogue()
    assert len(listed) >= 90 and {"eq13", "b-grow"} <= {claim.id for claim in listed}
    assert next(claim for claim in listed if claim.id == "eq13").statement[-1].startswith("prove")
    assert carom.format_claims('claim a "A"\ngiven x>0\nprove x*x=x²') == 'claim a "A"\ngiven x > 0\nprove x*x = x²\n'
    with pytest.raises(ValueError, match=":3"):
        carom.format_claims('claim a "A"\ngiven x > 0\nprove x*x == 1\n')
    assert "chain" in carom.scene_schema()["properties"]


def test_a_simulator_is_judged(tmp_path):
    answers = carom.referee_answers()
    assert bool(carom.referee(answers)) and len(carom.referee_scenes()) >= 100
    (tmp_path / "r.csv").write_text(answers.replace("two-stop,", "two-stopp,", 1), encoding="utf-8")
    with pytest.raises(ValueError, match=r"line \d+: column 1 \(scene\).*did you mean"):
        carom.referee(tmp_path / "r.csv")
    name = carom.referee_scenes()[0]["name"]
    bodies = len(carom.referee_scenes()[0]["masses"])
    wrong = carom.referee({name: {"velocities": [5.5] * bodies}})
    assert not wrong and wrong.data["wrong"] == 1 and wrong.data["missing"] >= 99 and "wrong" in str(wrong)
    for results in ({name: {"speed": []}}, "a,b\n1,2\n", ""):
        with pytest.raises(ValueError):
            carom.referee(results)


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
        ([{"eta": 1, "ratio": 1, "e": 1, "n": "1/2"}], "n is a number of bodies"),
    ):
        with pytest.raises(ValueError, match=sign):
            carom.check_table(rows)


def test_tables_are_checked_as_lists_and_as_columns():
    heading, right, wrong = ["ratio", "e", "n", "eta"], [4, 1, 0, "0.64"], ["4", "1", "0", "0.65"]
    columns = {name: [right[i], wrong[i]] for i, name in enumerate(heading)}
    for table in ([heading, right, wrong], columns):
        assert [(cell.line, cell.right) for cell in carom.check_table(table)] == [(2, True), (3, False)]
    for table, sign in (
        ([heading, [1]], "line 2: the heading has 4 fields, the line has 1"),
        ([["m1", "m2"], [1, 2]], "no column is called eta"),
        ([1], "line 1: a row is a dictionary or a list"),
        ({"ratio": [1], "e": []}, "not equally long"),
    ):
        with pytest.raises(ValueError, match=sign):
            carom.check_table(table)


def test_scenes_are_dictionaries_as_well():
    half = Fraction(1, 2)
    bodies = [{"mass": 1, "position": 0, "velocity": 1}, {"mass": "3", "position": half}]
    found = carom.replay({"restitution": half, "body": bodies})
    (collision,) = found.collisions
    assert (collision.time, collision.after, collision.lost) == (half, (Fraction(-1, 8), 3 * half**3), Fraction(9, 32))
    assert found.energy == {"initial": half, "final": Fraction(7, 32), "lost": Fraction(9, 32)}
    chain = {"first": 2, "last": 1, "inserted": [Fraction(3, 2)], "restitution": half}
    assert "<svg" in carom.plot("velocities", scene={"chain": chain})
    with pytest.raises(carom.WrongType, match="restitution: the float 0.5"):
        carom.replay({"restitution": 0.5, "body": bodies})


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
    out = run("plot", "eta-n", "--ratio", "1,5", "-e", "0.9", "-n", "3")
    assert out.returncode == 2 and "two readings" in out.stderr
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


def test_a_fault_of_a_scene_has_its_line():
    for text, line in [
        ('restitution = "1/2"\n[[body]]\nmass = \n', "scene:3:8"),
        ('restitution = "1/2"\n[[body]]\nmas = 1\nposition = 0\n', "scene:3:1"),
    ]:
        with pytest.raises(ValueError, match=line):
            carom.replay(text)
