"""A format, and a judge, of somebody else's own."""

import re
from pathlib import Path

import pytest

from exactspline import Verdict, read
from exactspline.interchange import formats
from exactspline.verification import judges
from exactspline.verification.claims import select
from exactspline.verification.verdict import Finding
from tests.support.command import run

PAGE = Path(__file__).parents[2] / "docs" / "formats.md"


@pytest.mark.skipif(not PAGE.exists(), reason="the page is in the checkout only")
def test_a_format_that_was_added_is_read_like_the_others(monkeypatch, tmp_path):
    monkeypatch.setattr(formats, "_added", [])
    blocks = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    (block,) = (each for each in blocks if "add_format" in each)
    exec(block, {})
    place = tmp_path / "curve.pts"
    place.write_text("points\n0 0\n1/2 1\n1 0\n", encoding="utf-8")
    assert read(place).curve.degree == 2
    assert run("inspect", place).stdout.startswith("points: polynomial, degree 2")


def test_a_judge_that_was_added_is_asked_like_the_others(monkeypatch):
    class Credulous:
        name = column = "credulous"

        def __init__(self, claims):
            self.claims = claims

        def decide(self, claim):
            return Finding(Verdict.PROVED)

    monkeypatch.setattr(judges, "_others", dict(judges._others))
    judges.add_judge("credulous", Credulous)
    claim = select(["C4.1a"])[0]
    assert judges.judge_named("credulous", [claim]).decide(claim).verdict == Verdict.PROVED
    done = run("prove", "--claim", "C4.2b", "--judge", "credulous")
    assert done.returncode == 1
    assert "CONTRADICTION" in done.stdout
