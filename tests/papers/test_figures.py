"""The figures of the paper: what their captions count is what the paper's captions claim (or what was found instead),
and every file is whole.
"""

import re
from functools import cache
from pathlib import Path
from xml.etree import ElementTree

import pytest

pytest.importorskip("matplotlib")

from click.testing import CliRunner

from exactspline import Nurbs, analyse, example
from exactspline.cli import app
from exactspline.display.figures import figures, folder, make
from exactspline.display.plot import PlotError
from exactspline.display.plot.functions import inspect_figure
from exactspline.verification.claims import all_claims
from tests.support.looking import laid_out, unreadable

runner = CliRunner()
#: What the claims of a caption call what the figure's own caption says in a part of the sentence.
COUNTED = ("degree", "control points", "roots", "extrema")


@pytest.fixture(scope="module")
def place(tmp_path_factory):
    return tmp_path_factory.mktemp("figures")


@cache
def drawn(number):
    """A figure, its caption and its scenes."""
    return figures()[number]()


def counts_of(number):
    """The counts of a caption that hold: as printed, or what must be said instead."""
    claims = [
        claim
        for claim in all_claims()
        if claim.id == f"Fig. {number}" and claim.kind == "count" and claim.expected != "REFUTED"
    ]
    assert claims or number in (6,)
    return [
        part.strip() for claim in claims for part in claim.claimed.split(",") if any(word in part for word in COUNTED)
    ]


@pytest.mark.parametrize("number", figures())
def test_a_caption_says_what_was_counted_words_can_be_read_and_files_are_whole(number, place):
    # to draw a surface takes long: as PNG one in the plane and one in space
    suffixes = ("svg", "png") if number in (1, 4) else ("svg",)
    made = make(number, place, drawn(number), suffixes)
    assert unreadable(laid_out(drawn(number).figure)) == []
    for part in counts_of(number):
        value, word = re.search(r"\d+", part)[0], re.sub(r"[\d ]+", " ", part).strip()
        assert re.search(rf"\b{value} (and \d+ )?{word}|{word} {value}\b", made.caption), part
    assert {path.rsplit(".", 1)[1] for path in made.files} == {*suffixes} | ({"html"} if number > 3 else set())
    for path in made.files:
        data = Path(path).read_bytes()
        if path.endswith(".svg"):
            assert ElementTree.fromstring(data).tag.endswith("svg")
        elif path.endswith(".png"):
            assert data.startswith(b"\x89PNG\r\n")
        else:
            assert not re.search(rb"<script[^>]+src=", data), "a page needs no network"
            assert b"explicit directrix" in data


def test_a_refuted_count_is_not_repeated():
    (refuted,) = [claim for claim in all_claims() if claim.id == "Fig. 1" and claim.expected == "REFUTED"]
    assert refuted.claimed not in drawn(1).caption


def test_the_axes_of_the_figures_hold_the_objects():
    figure = drawn(2).figure
    points = [line for ax in figure.axes for line in ax.lines if line.get_label() == "_control points"]
    titles = [ax.get_title() for ax in figure.axes]
    counted = [
        sum(len(line.get_xdata()) for line in ax.lines if line.get_label() == "_control points")
        for ax in figure.axes[:2]
    ]
    assert points
    for title, count in zip(titles, counted, strict=False):
        assert f"{count} control points" in title


def test_the_command_writes_into_a_new_folder(tmp_path):
    result = runner.invoke(app, ["paper", "figures", "--out", str(tmp_path / "new" / "folder"), "--figure", "3"])
    assert result.exit_code == 0
    assert sorted(p.name for p in (tmp_path / "new" / "folder").iterdir()) == ["figure3.png", "figure3.svg"]
    assert "Fig. 3" in result.output


def test_errors_say_what_would_be_right(tmp_path):
    with pytest.raises(PlotError, match="figures are 1, 2"):
        make(7, tmp_path)
    (tmp_path / "file").write_text("")
    with pytest.raises(PlotError, match="folder that can be written"):
        folder(tmp_path / "file" / "below")


def test_figure_1_shows_the_curve_and_marks_its_inflections():
    curve, top = example("six_segment_cubic"), drawn(1).figure.axes[0]
    lines = {line.get_label(): line for line in top.lines}
    assert len(lines["inflections, κ = 0"].get_xdata()) == len(analyse(curve).inflections) > 0
    # jumps are hollow here as in the graphs below
    assert lines["κ′ changes its sign by a jump"].get_markerfacecolor() == "white"
    for values, (low, high) in zip(
        zip(*curve.control_points, strict=True), (top.get_xlim(), top.get_ylim()), strict=True
    ):
        assert low < min(values)
        assert high > max(values)
        assert high - low < 2 * (max(values) - min(values))


def test_the_picture_of_inspect_marks_corners_and_cusps():
    square = Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)])
    labels = [line.get_label() for line in inspect_figure(square, []).axes[0].lines]
    assert f"corners ({len(analyse(square).corners)})" in labels
    labels = [line.get_label() for line in inspect_figure(example("cusp"), []).axes[0].lines]
    assert "cusps (1)" in labels
