"""The command `bisector` as a user meets it."""

import json

import pytest
from gmpy2 import mpq

from exactspline.geometry.bisectors import curve_bisector
from exactspline.splines.curve_files import curve_from_text
from exactspline.splines.examples import example
from tests.test_cli import run


def test_two_curves():
    done = run("bisector", "rational_space_cubic", "twisted_cubic")
    assert done.returncode == 0
    assert "10 × 8" in done.stdout


def test_the_control_net_is_the_surface():
    data = json.loads(
        run("bisector", "rational_space_cubic", "twisted_cubic", "--variant", "symmetric", "--json").stdout
    )["rows"][0]
    patch = data["patches"][0]
    assert patch["degree"] == [11, 8]
    net = patch["homogeneous_control_net"]
    assert (len(net), len(net[0]), len(net[0][0])) == (12, 9, 4)
    corner = [mpq(x) for x in net[-1][-1]]
    value = curve_bisector(example("rational_space_cubic"), example("twisted_cubic"))(1, 1)
    assert value == tuple(x / corner[3] for x in corner[:3])


def test_a_point_and_a_space_curve(tmp_path):
    file = tmp_path / "out.json"
    done = run("bisector", "ellipse_in_space", "--point", "1,1,2", "-o", file)
    assert done.returncode == 0
    data = json.loads(file.read_text())
    assert [piece["moved"] for piece in data["pieces"]] == ["x", "y", "z"]
    assert run("bisector", "ellipse_in_space", "--point", "1,1,2").stdout.count("ruled surface") == 3


def test_a_point_and_a_plane_curve_is_trimmed():
    done = run("bisector", "ellipse", "--point", "-1,1/3", "--digits", "8")
    assert done.returncode == 0
    assert done.stdout.count("arc") == 2
    data = json.loads(run("bisector", "parabola", "--point", "0,1", "--json").stdout)["rows"][0]
    assert [piece["piece"] for piece in data["pieces"]] == ["arc", "end point", "end point"]
    low = data["pieces"][1]["high"]
    assert mpq(low["interval"][0]) <= mpq(-1, 5) <= mpq(low["interval"][1])


@pytest.mark.parametrize(
    "arguments",
    [
        ("circle",),
        ("circle", "circle"),
        ("circle", "--point", "1,x"),
        ("circle", "--point", "1,0"),
        ("circle", "--point", "1,2,3"),
        ("helix_like", "--point", "1,2"),
        ("helix_like", "--point", "1,2,3", "--variant", "best"),
        ("circle", "--point", "5,5", "--variant", "naive"),
        ("no_such_curve", "--point", "1,2"),
        ("helix_like", "twisted_cubic", "--point", "0,0,0"),
    ],
)
def test_bad_input_ends_in_one_line_and_status_2(arguments):
    done = run("bisector", *arguments)
    assert done.returncode == 2
    assert done.stdout == ""
    assert done.stderr.count("\n") == 1
    assert "Traceback" not in done.stderr


def test_gaps_are_told_with_their_place(tmp_path):
    file = tmp_path / "stands.json"
    points = [["0", "0", "0"], ["1", "0", "0"], ["1", "0", "0"], ["1", "2", "3"]]
    file.write_text(json.dumps({"degree": 1, "knots": ["0", "0", "1", "2", "3", "3"], "control_points": points}))
    assert "missing: [1, 2]: the curve stands still" in run("bisector", file, "--point=-1,5,0").stdout
    assert "no surface: [1, 2] × [0, 1]: the curve stands still" in run("bisector", file, "twisted_cubic").stdout


def test_a_derived_net_can_be_read_back():
    """The directrix of a ruled piece as a curve file."""
    data = json.loads(run("bisector", "helix_like", "--point", "0,0,1", "--json").stdout)["rows"][0]
    directrix = data["pieces"][0]["directrix"]
    points = [[mpq(x) for x in row] for row in directrix["homogeneous_control_points"]]
    curve = curve_from_text(
        json.dumps(
            {
                "degree": directrix["degree"],
                "knots": directrix["knots"],
                "control_points": [[str(x / row[3]) for x in row[:3]] for row in points],
                "weights": [str(row[3]) for row in points],
            }
        )
    )
    assert curve("1/2")[2] == 0
