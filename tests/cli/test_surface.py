"""``inspect`` of surfaces, and the list of them, as a user sees them."""

import json
import os
import re
import subprocess
import sys

import jsonschema
import pytest

from exactspline import ExactSplineError, analyse, example, write
from tests.support.command import invoke, schema_of


@pytest.fixture(autouse=True)
def wide(monkeypatch):
    monkeypatch.setenv("COLUMNS", "120")


def test_a_torus_as_text():
    output = invoke("inspect", "torus", "-q").output
    assert [line.split()[0] for line in output.splitlines()[2:]] == [*["elliptic"] * 2, "hyperbolic", "torus"] + [
        "parabolic"
    ] * 2
    assert "closed in u and v" in output


def test_umbilics_to_any_number_of_digits():
    (row,) = json.loads(invoke("inspect", "ellipsoid", "--digits", "40", "--json").output)["rows"]
    assert len(row["umbilics"]["points"]) == 4
    for umbilic in row["umbilics"]["points"]:
        assert umbilic["index"] == "1/2"
        assert umbilic["u"]["exact"] in ("0", "2")
        low, high = (umbilic["v"][name].split("/") for name in ("low", "high"))
        assert abs(int(low[0]) / int(low[1]) - umbilic["v"]["double"]) < 1e-15
        assert int(high[0]) * int(low[1]) - int(low[0]) * int(high[1]) <= int(high[1]) * int(low[1]) // 10**40 + 1


def test_shapes_within_a_distance():
    document = json.loads(invoke("inspect", "hyperbolic_paraboloid", "cylinder", "--epsilon", "1e-3", "--json").output)
    jsonschema.validate(document, schema_of("inspect surface"))
    none, found = (row["shapes"] for row in document["rows"])
    assert none == []
    (part,) = found
    assert (part["kind"], part["whole"]) == ("cylinder", True)
    assert [x["exact"] for x in part["numbers"]["within"]] == ["0"]
    asked = json.loads(invoke("inspect", "sphere", "--ask", "shapes_within:1e-3", "--json").output)
    assert asked["rows"][0]["answer"][0]["numbers"]["radius"][0]["exact"] == "1"


def test_answers_about_surfaces_are_read_by_people():
    words = invoke("inspect", "cone", "torus", "--ask", "shapes", "--ask", "poles", "--ask", "umbilics").output
    assert not set("{}'\"") & set(words)
    assert "pole: an edge of a patch" in words
    apex = [line.split()[1:] for line in words.splitlines() if line.split()[1:2] == ["apex"]]
    assert apex == [["apex", "1", "0", "0.0"], ["apex", "2", "0", "0.0"], ["apex", "3", "2", "2.0"]]
    assert "nothing: it is proved that there is none" in words


@pytest.mark.parametrize("name", ["cone", "cross_cap", "planar_map"])
def test_json_fits_its_schema(name):
    schema = jsonschema.Draft202012Validator(schema_of("inspect surface"))
    schema.validate(json.loads(invoke("inspect", name, "--json").output))


def test_the_list_of_surfaces():
    document = json.loads(invoke("list", "surfaces", "--json").output)
    jsonschema.validate(document, schema_of("surfaces"))
    assert {"sphere", "torus", "cyclide"} <= {row["name"] for row in document["rows"]}
    assert "Whitney" in invoke("list", "surfaces").output


def test_files_of_surfaces(tmp_path):
    good, bad = tmp_path / "good.json", tmp_path / "bad.json"
    write(example("monkey_saddle"), good)
    bad.write_text('{"degree": [1, 1], "knots": [[0, 0, 1, 1], [0, 0, 1, 1]], "points": [[[0, 0], [0, 1]], [[1]]]}')
    found = invoke("inspect", bad, good)
    assert found.exit_code == 2
    assert "control_points[1]" in found.output
    assert "umbilic" in found.output
    # what is wrong with a curve is told of curves, and a surface where a curve is expected
    assert "holds 1 surface" in str(invoke("derive", "evolute", good).exception)
    assert "one after the other" in str(invoke("inspect", good, "circle").exception)


@pytest.mark.parametrize("option", [["--coordinates"], ["--certificate", "x.json"], ["--emit-coq", "x.v"]])
def test_options_that_are_for_curves(option):
    found = invoke("inspect", "torus", *option)
    assert isinstance(found.exception, ExactSplineError)
    assert option[0] in str(found.exception)


def test_the_picture(tmp_path):
    path = tmp_path / "a.svg"
    assert invoke("inspect", "biquadratic", "--plot", path).exit_code == 0
    assert len(path.read_bytes()) > 10_000


def test_what_is_not_drawn(tmp_path):
    assert invoke("inspect", "folded_map", "--plot", tmp_path / "a.png").exit_code == 2
    assert "--plot" in str(invoke("inspect", "torus", "sphere", "--plot", tmp_path / "a.png").exception)
    assert not list(tmp_path.iterdir())


def test_a_page_that_turns_has_the_regions_the_parabolic_curve_and_the_umbilics(tmp_path):
    pytest.importorskip("matplotlib")
    path = tmp_path / "bicubic.html"
    assert invoke("inspect", "bicubic", "--plot", path).exit_code == 0
    [data] = json.loads(re.search(r"^turning\(document.*?, (\[.*\])\);$", path.read_text(), re.MULTILINE)[1])
    assert [one["label"] for one in data["surfaces"]] == ["K > 0", "K < 0"]
    found = analyse(example("bicubic"))
    [umbilics] = [one for one in data["dots"] if one["label"] == "umbilics"]
    assert len(umbilics["places"]) == len(found.umbilics) == 4
    [curve] = [one for one in data["lines"] if one["label"] == "parabolic curve"]
    # every point of the curve lies between the two colours: on faces of both there are points near it
    cloud = {one["label"]: one["points"] for one in data["surfaces"]}
    for place in [run[0] for run in curve["runs"]]:
        for points in cloud.values():
            assert min(sum((a - b) ** 2 for a, b in zip(place, p, strict=True)) for p in points) < 0.1


def test_answers_do_not_depend_on_hashes():
    command = [sys.executable, "-m", "exactspline", "inspect", "bicubic", "--json"]
    seeds = [os.environ | {"PYTHONHASHSEED": seed} for seed in "12"]
    told = {subprocess.run(command, capture_output=True, text=True, check=True, env=seed).stdout for seed in seeds}
    assert len(told) == 1
