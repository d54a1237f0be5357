"""``inspect`` as a user sees it: corners, gaps and jumps each in a row, orders of continuity, pieces across the
seam.
"""

import json
import re

import pytest

from exactspline import analyse, rational, read
from tests.geometry.test_shared_curves import FILES
from tests.support.command import invoke

SQUARE = {"degree": 1, "knots": [0, 0, 1, 2, 3, 4, 4], "control_points": [[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]}
#: Through (1, 0) in the middle of a side, with a gap of √2 after the first corner.
TURNED = {
    "degree": 1,
    "knots": [0, 0, 1, 1, 2, 3, 4, 4],
    "control_points": [[1, 0], [2, 0], [3, 1], [0, 5], [0, 0], [1, 0]],
}


@pytest.fixture
def inspected(tmp_path, monkeypatch):
    monkeypatch.setenv("COLUMNS", "200")

    def inspect(curve):
        file = tmp_path / "curve.json"
        file.write_text(json.dumps(curve))
        return invoke("inspect", file).output, json.loads(invoke("inspect", file, "--json").output)["rows"][0]

    return inspect


def test_a_square_has_four_corners_with_their_angles(inspected):
    output, data = inspected(SQUARE)
    rows = [line for line in output.splitlines() if line.startswith("corner ")]
    assert len(rows) == 4
    assert all("turns by 90° (cos = 0, sin = 1), G0" in row for row in rows)
    assert "at the seam" in rows[0]
    assert "joints: 4 G0" in output
    told = [{name: x["exact"] for name, x in joint["angle"].items()} for joint in data["joints"]]
    assert told == [{"cosine": "0", "sine": "1", "degrees": "90"}] * 4
    assert [joint["geometric_continuity"] for joint in data["joints"]] == [0] * 4


def test_gaps_corners_and_a_smooth_seam_are_told(inspected):
    output, data = inspected(TURNED)
    assert [(joint["kind"], joint["geometric_continuity"]) for joint in data["joints"]] == [
        ("continuous curvature", 3),
        ("gap", -1),
        ("corner", 0),
        ("corner", 0),
    ]
    assert data["joints"][1]["gap"]["exact"] == "√2"
    assert "√2 wide" in output
    assert "[3, 4] ∪ [0, 1]" in output
    assert data["straight_pieces"] == [[["1", "2"]], [["2", "3"]], [["3", "4"], ["0", "1"]]]
    assert "joints: 1 with a gap, 2 G0, 1 G3 or higher" in output


def test_jumps_of_the_curvature_are_told_with_both_values(inspected):
    curve = {"degree": 2, "knots": [0, 0, 0, 1, 2, 2, 2], "control_points": [[0, 0], [1, 1], [3, -1], [4, 0]]}
    output, data = inspected(curve)
    (joint,) = data["joints"]
    assert joint["kind"] == "jump of the curvature"
    assert [x["exact"] for x in joint["curvatures"]] == ["-√2/4", "√2/4"]
    assert "-√2/4 | √2/4" in output
    assert "G1" in output
    (inflection,) = data["inflections"]["points"]
    assert inflection["curvature"] == joint["curvatures"]


def test_a_corner_at_rest_has_its_angle_too(inspected):
    curve = {"degree": 2, "knots": [0, 0, 0, 1, 1, 2, 2, 2], "control_points": [[0, 0], [1, 0], [1, 0], [1, 3], [1, 3]]}
    _, data = inspected(curve)
    corner = next(f for f in data["singular_points"]["points"] if f["kind"] == "corner")
    assert (corner["parameter"]["exact"], corner["angle"]["degrees"]["exact"]) == ("1", "90")


@pytest.mark.parametrize("file", [f for f in FILES if "font" in f.stem], ids=lambda f: f.stem)
def test_every_corner_of_a_glyph_has_a_row(file, monkeypatch):
    monkeypatch.setenv("COLUMNS", "200")
    curve = read(file).curve
    rows = [line.split()[0] for line in invoke("inspect", file, "--digits", 5).output.splitlines() if line]
    told = [joint for joint in analyse(curve).joints if joint.kind == "corner"]
    assert rows.count("corner") >= len(told)
    a, b = curve.domain
    for joint in analyse(curve).joints:
        # the definition: the tangent of the chords on both sides, a millionth of the domain away
        t, h = joint.parameter, (b - a) / 10**9
        left = b if joint.at_seam else t
        before = [x - y for x, y in zip(curve(left, "left"), curve(left - h), strict=True)]
        behind = [x - y for x, y in zip(curve(t + h), curve(t), strict=True)]
        cosine = sum(x * y for x, y in zip(before, behind, strict=True))
        squares = sum(x * x for x in before) * sum(x * x for x in behind)
        turns = cosine < 0 or cosine**2 * 10**10 < squares * (10**10 - 1)
        if turns or (joint.angle is not None and joint.angle.sine**2 * 10**8 > 1):
            assert (joint.angle is not None) == turns


def test_a_drawing_of_several_curves_is_one_picture(tmp_path):
    pytest.importorskip("matplotlib")
    drawing, picture = tmp_path / "drawing.svg", tmp_path / "features.svg"
    drawing.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg"><path id="s" d="M0 0C1 2 2 -2 3 0"/><path id="v" d="M0 1L1 2L2 1"/>'
        "<text>skipped</text></svg>"
    )
    done = invoke("inspect", str(drawing), "--coordinates", "--plot", str(picture), "--json")
    assert done.exit_code == 0
    assert f"skipped: {drawing}: text at line 1: " in done.stderr
    assert done.stderr.endswith(f"written: {picture}\n")
    rows = json.loads(done.stdout)["rows"]
    assert [row["curve"] for row in rows] == ["s", "v"]
    assert [f["parameter"]["exact"] for f in rows[0]["inflections"]["points"]] == ["1/2"]
    turns = [(f["coordinate"], f["kind"]) for row in rows for f in row["coordinate_extrema"]]
    assert turns == [(1, "maximum"), (1, "minimum"), (1, "maximum")]
    assert picture.read_text(encoding="utf-8").count("inflections (1)") >= 1


def test_what_is_printed_is_explained():
    """“By a jump” did not say of what, the columns of --stability were explained nowhere, and features came in another
    order there.
    """
    printed = invoke("inspect", "six_segment_cubic", "--stability", "--digits", "4").output
    table, stability, legend = printed.split("\n\n")
    assert "at a knot, by a jump of κ′" in " ".join(table.split())
    explained = {line.partition(": ")[0] for line in legend.splitlines()}
    assert explained >= {"by a jump of κ′", "maximum of |κ|", "G2", "stable up to", "destroyed by"}
    assert "by a jump of κ" not in explained
    kinds = [
        [line[:12] for line in part.splitlines() if line[:3] in ("inf", "max", "min")] for part in (table, stability)
    ]
    assert kinds[0] == kinds[1]


def test_a_curve_that_is_skipped_is_named_with_its_file(tmp_path):
    """Neither the file nor the curve was named."""
    good = '{"degree": 1, "knots": [0, 0, 1, 1], "control_points": [[0, 0], [1, 1]]}'
    file = tmp_path / "two.json"
    file.write_text(f'{{"curves": [{good}, {{"name": "second", "degree": 1}}, {{"degree": 1}}]}}')
    done = invoke("inspect", str(file))
    assert f"skipped: {file}: curve (2 times: curve 2 (second), curve 3): the field 'knots' is missing" in done.stderr
    file.write_text(f'{{"curves": [{good}, {{"name": "second", "degree": 1}}]}}')
    assert f"skipped: {file}: curve 2 (second): the field" in invoke("inspect", str(file)).stderr


def test_what_holds_of_all_curves_near_one_by_the_oracle_and_in_sweeps():
    """`--ask inflections --epsilon E` ignored the distance and answered about the one curve; ends were rounded to the
    nearest decimals, so that an interval might lack what it was said to contain; sweeps gave what some curves may have
    as if the curve had it.
    """
    exact = json.loads(invoke("inspect", "cubic_s", "--ask", "features_within:1e-3", "--json").output)["rows"][0][
        "answer"
    ]
    lines = invoke("inspect", "cubic_s", "--ask", "features_within", "--epsilon", "1e-3").output.splitlines()
    intervals = [re.findall(r"intervals \[([^],]+), ([^],]+)\]", line) for line in lines]
    shown = [rational(end) for found in intervals for pair in found for end in pair]
    own = [rational(end) for item in exact for interval in item["intervals"] for end in interval]
    assert len(own) == 6
    unit = rational("1e-12")
    assert all(0 < (x - y) * (-1) ** k < unit for k, (x, y) in enumerate(zip(own, shown, strict=True)))
    refused = str(invoke("inspect", "cubic_s", "--ask", "inflections", "--epsilon", "1e-3").exception)
    assert "features_within" in refused
    asked = invoke("sweep", "ellipse", "--epsilon", "1e-3", "--backend", "serial", "-o", "-").output
    found = json.loads(asked.splitlines()[0])["found"]
    assert {one["kind"] for one in found["features_within:1e-3"]} == {
        f"possible {kind}" for kind in ("maximum", "minimum", "corner")
    }
    (seam,) = found["self_intersections_within:1e-3"]
    assert (seam["kind"], seam["low"], seam["other_high"]) == ("possible crossing", "0", "4")


@pytest.mark.parametrize(
    "options",
    [("--plot", "a.svg"), ("--certificate", "a.json"), ("--emit-coq", "a.v"), ("--stability",), ("--coordinates",)],
)
def test_an_option_without_effect_beside_a_question_is_refused(options):
    """Passed before: `inspect circle --ask length --plot FILE` drew nothing, and said nothing."""
    for asked in (("circle", "--ask", "length"), ("torus", "--ask", "umbilics")):
        assert f"{options[0]} and --ask" in str(invoke("inspect", *asked, *options).exception)


def test_certificates_without_a_question_are_refused():
    assert "add --ask QUESTION" in str(invoke("inspect", "circle", "--certificates").exception)
