"""Verdicts, and how a notebook shows them."""

from __future__ import annotations

import html.parser
import random
import re
from fractions import Fraction

import pytest

import carom

MARKUP = 'claim mine "<img src=x onerror=alert(1)> & \\\\ $x$ 100% {a}_b^c"\ngiven m > 0\nprove m^2 = m\n'
GOOD = 'claim half "Half"\ngiven x > 0\nprove x/(2*x) = 1/2\n'


def test_verdicts_come_with_their_evidence():
    audit = carom.audit(
        GOOD + '\nclaim mine "Equal masses"\ngiven m, v > 0;  e in [0, 1]\nprove (1 + e)^2*m*m/(m + m)^2 = 1\n'
    )
    assert audit.summary == {"proved": 1, "refuted": 1, "undecided": 0, "unexpected": 1} and not audit.as_expected
    assert [claim.id for claim in audit] == ["half", "mine"] and audit[0].verdict == "proved"
    mine = audit["mine"]
    e = mine.witness.point["e"]
    assert isinstance(e, Fraction) and 0 <= e < 1
    assert Fraction(mine.witness.broken[0].left) == (1 + e) ** 2 / 4 and mine.witness.broken[0].right == "1"
    assert repr(audit) == "Audit(2 claims: 1 proved, 1 refuted, 0 undecided; 1 not as expected)"
    with pytest.raises(KeyError):
        audit["other"]


def test_the_catalogue_is_at_hand():
    audit = carom.audit(only=["eq13", "p-final"])
    assert audit["eq13"].verdict == "proved" and audit["eq13"].number == 13 and audit["eq13"].argument
    assert audit["p-final"].verdict == "refuted" and audit.as_expected
    with pytest.raises(ValueError, match="did you mean"):
        carom.audit(only="eq133")


def test_a_law_and_an_audit_read_a_claim_without_its_head():
    text = "given x > 0\nprove x^2 = x"
    pytest.importorskip("hypothesis")
    for claim in (carom.audit(text)[0], carom.law(text)(lambda at: None).law.claim):
        assert (claim.id, claim.verdict) == ("law", "refuted")
    assert carom.audit(f'# a remark\nclaim mine "Mine"\n{text}')[0].id == "mine"


def test_faults_show_their_place():
    with pytest.raises(ValueError) as caught:
        carom.audit('claim a "A"\ngiven x > 0\nprove x = y\n', file="mine.claim")
    assert "mine.claim:3" in str(caught.value) and "^" in str(caught.value)
    with pytest.raises(ValueError, match="contradict each other"):
        carom.audit('claim a "A"\ngiven x > 0\nassume x < 0\nprove x = 1\n')
    for text in (b"claim", 7):
        with pytest.raises(ValueError, match="a str"):
            carom.audit(text)


def test_deep_and_random_texts_end_in_words():
    rng = random.Random(1)
    tokens = GOOD.split() + ["(", ")", "^", "sum", "\u0000", "\u202e", "i", "=", "<", "given", "prove", '"', "\n"]
    deep = "(" * 50_000 + "x" + ")" * 50_000
    texts = [f'claim a "A"\ngiven x > 0\nprove {deep} = x\n', "claim", "", "\x00"]
    texts += [f'claim a "A"\ngiven x > 0\nprove {"-" * 20_000}x = x\n']
    texts += [" ".join(rng.choice(tokens) for _ in range(rng.randint(1, 40))) for _ in range(300)]
    for text in texts:
        try:
            carom.audit(text, seconds=1)
        except (ValueError, carom.LimitReached) as error:
            assert str(error)


class Tags(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.tags, self.text = set(), ""

    def handle_starttag(self, tag, attributes):
        self.tags.add(tag)
        assert not any(name.startswith("on") for name, _ in attributes)

    def handle_data(self, data):
        self.text += data


def test_markup_in_a_title_stays_text():
    audit = carom.audit(MARKUP)
    title = audit[0].title
    assert "<img" in title
    for shown in (audit._repr_html_(), audit[0]._repr_html_()):
        page = Tags()
        page.feed(shown)
        assert "img" not in page.tags and title in page.text and "math" in page.tags
        assert "<img" not in shown
        # Nor does it become a formula: no text between two tags holds a pair of dollars, or a command.
        assert not any(re.search(r"\$[^<]*\$|\\[^<]", text) for text in re.findall(r">([^<]+)", shown))


def test_latex_holds_a_row_for_each_claim():
    audit = carom.audit(GOOD + MARKUP)
    latex = audit._repr_latex_()
    assert latex.startswith("$$\\begin{array}") and latex.count("\\\\\n") == 1 and "\\frac" in latex
    assert "onerror" not in latex
    assert carom.audit(GOOD)[0]._repr_latex_().count("\\text{proved}") == 1


PAPER = r"""\input{given}
\begin{equation}\label{eq:share} \frac{4 m_1 m_2}{(m_1 + m_2)^2} \le 1 \end{equation}
\begin{equation} m_1 = m_2 \end{equation}
\begin{equation} \oint m_1 = 0 \end{equation}
"""


def test_a_paper_is_judged_and_what_is_not_read_is_said(tmp_path):
    (tmp_path / "given.tex").write_text("%carom given m_1, m_2 > 0\n")
    path = tmp_path / "paper.tex"
    path.write_text(PAPER)
    for audit in (carom.audit(path), carom.audit(str(path)), carom.audit(latex=path)):
        assert [(claim.id, claim.verdict) for claim in audit] == [("share", "proved"), ("eq-2", "refuted")]
        [unread] = audit.unread
        assert (unread.id, unread.file, unread.line) == ("eq-3", str(path), 4) and "oint" in unread.message
        assert "^" in unread.text and "not read" in str(audit) and "1 not read" in repr(audit)
        assert not audit.as_expected and "oint" in audit._repr_html_()
    # A text is no file: it calls for none.
    [missing, *waiting] = carom.audit(latex=PAPER).unread
    assert "input is not followed" in missing.message and all("waits" in unread.message for unread in waiting)
    assert carom.audit(latex=r"\[ (-1)^2 = 1 \]").as_expected
    with pytest.raises(ValueError, match="no displayed equation"):
        carom.audit(latex="Text.")
    with pytest.raises(ValueError, match="not both"):
        carom.audit("given x real\nprove x = x", latex="\\[ 1 = 1 \\]")
    with pytest.raises(ValueError, match="did you mean share"):
        carom.audit(path, only="shore")
