"""The command `between` as a user meets it."""

import json

import pytest

from exactspline import Nurbs, write
from tests.support.command import run, schema_of


def test_points_with_parameters_coordinates_and_multiplicities():
    done = run("between", "circle", "ellipse")
    assert done.returncode == 0
    assert done.stdout.count("touching") == 2
    assert "multiplicity 2" in done.stdout


def test_json_follows_its_schema():
    jsonschema = pytest.importorskip("jsonschema")
    for pair in (("circle", "ellipse"), ("circle", "circle"), ("twisted_cubic", "helix_like")):
        data = json.loads(run("between", *pair, "--json").stdout)
        jsonschema.validate(data, schema_of("between"))
    (row,) = json.loads(run("between", "circle", "circle", "--json").stdout)["rows"]
    assert [arc["numerator"] for arc in row["intersections"]["everywhere"]] == [["0", "1"]] * 4
    assert row["distance"]["value"]["exact"] == "0"


def test_curves_that_do_not_meet_have_nearest_points():
    done = run("between", "twisted_cubic", "helix_like", "--digits", "6")
    assert "nearest" in done.stdout
    assert "distance 0.202627" in done.stdout


def test_a_map_between_arcs_is_shown(tmp_path):
    parabola = Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), ("1/2", 0), (1, 1)], name="parabola")
    part = parabola.restrict("1/4", "3/4").reverse()
    for name, curve in (("one", parabola), ("other", part)):
        write(curve, tmp_path / f"{name}.json")
    assert "s = 1 - t" in run("between", tmp_path / "one.json", tmp_path / "other.json").stdout


def test_two_dimensions_are_bad_input():
    done = run("between", "circle", "twisted_cubic")
    assert done.returncode == 2
    assert "R3" in done.stderr


def test_a_picture_of_the_plane_and_the_parameters(tmp_path):
    pytest.importorskip("matplotlib")
    file = tmp_path / "both.svg"
    assert run("between", "circle", "ellipse", "--plot", file).returncode == 0
    assert file.read_text(encoding="utf-8").count("<path") > 10


def test_questions_about_two_curves_are_answered_as_those_of_one():
    """Refused before; `inspect circle --ask distance:ellipse_skew` had the answer."""
    asked = ("--ask", "distance", "--ask", "intersections_within:1/1000")
    done = run("between", "circle", "ellipse_skew", *asked, "--json")
    document = json.loads(done.stdout)
    pytest.importorskip("jsonschema").validate(document, schema_of("answers"))
    of_one = run("inspect", "circle", "--ask", "distance:ellipse_skew", "--json")
    assert document["rows"][0]["answer"] == json.loads(of_one.stdout)["rows"][0]["answer"] is not None
    assert run("between", "circle", "ellipse", "--ask", "intersections_within", "--epsilon", "1e-3").returncode == 0
    for wrong in ("length", "distance@1/2", "distance:7", "distances"):
        refused = run("between", "circle", "ellipse", "--ask", wrong)
        assert refused.returncode == 2
        assert "Traceback" not in refused.stderr


@pytest.mark.parametrize("option", ["--plot", "--emit-coq"])
def test_an_option_without_effect_beside_a_question_is_refused(option, tmp_path):
    """Passed before: the picture that was asked for was not drawn, without a word."""
    refused = run("between", "circle", "ellipse", "--ask", "distance", option, tmp_path / "a.svg")
    assert refused.returncode == 2
    assert f"{option} and --ask" in refused.stderr
    assert not list(tmp_path.iterdir())
