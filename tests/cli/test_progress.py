"""Long work speaks where no terminal shows a bar."""

import json

import pytest

from exactspline.cli import output
from tests.support.command import run


@pytest.fixture
def every_step(monkeypatch):
    """As if ten seconds went by between two steps."""
    monkeypatch.setattr(output, "BETWEEN", 0)


@pytest.mark.parametrize(
    ("arguments", "line"),
    [
        (("sweep", "--random", "degree=3 count=30 seed=1", "--json"), "1 curves, "),
        (("prove", "--claim", "C4.1a", "--json"), "1 of "),
        (("inspect", "six_segment_cubic", "--json"), "refining: 1 of "),
    ],
)
def test_a_line_says_how_far_it_is(arguments, line, every_step):
    done = run(*arguments)
    assert done.returncode == 0
    assert any(line in each for each in done.stderr.splitlines())
    json.loads(done.stdout)
    assert run(*arguments, "--quiet").stderr == ""


def test_what_is_short_says_nothing():
    assert run("inspect", "six_segment_cubic", "--json").stderr == ""
