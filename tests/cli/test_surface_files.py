"""Commands on the surfaces of files, alone and beside curves."""

import json

import pytest

from exactspline import example
from exactspline.interchange import read
from exactspline.interchange.files import encoded, encoded_surfaces, write
from tests.support.command import run


@pytest.fixture
def mixed(tmp_path):
    """A g2 file with a curve and two surfaces."""
    place = tmp_path / "mixed.g2"
    surfaces, _ = encoded_surfaces([example("sphere"), example("torus")], "g2")
    curve, _ = encoded([example("cusp")], "g2")
    place.write_bytes(surfaces + curve)
    return place


@pytest.fixture
def alone(tmp_path):
    place = tmp_path / "alone.itd"
    write([example("sphere"), example("torus")], place)
    return place


def rows(done):
    return json.loads(done.stdout)["rows"]


def test_a_file_of_surfaces_is_inspected(alone):
    done = run("inspect", alone, "--json", "--strict")
    assert done.returncode == 0, done.stderr
    assert [(row["surface"], row["curvature"]) for row in rows(done)] == [("sphere", "1"), ("torus", None)]


def test_of_a_mixed_file_either_is_taken_and_the_other_named(mixed):
    curves, surfaces = run("inspect", mixed, "--json"), run("inspect", mixed, "--json", "--surfaces")
    assert [row["curve"] for row in rows(curves)] == ["g2 1"]
    assert "2 surfaces" in curves.stderr
    assert len(rows(surfaces)) == 2
    assert "1 curve" in surfaces.stderr
    assert (curves.returncode, surfaces.returncode) == (0, 0)
    for given in ((), ("--surfaces",)):
        assert run("inspect", mixed, "--strict", *given).returncode == 2


def test_exact_answers_about_surfaces(alone):
    done = run("inspect", alone, "--json", "--ask", "curvature@1/3,1/2", "--ask", "umbilics", "--ask", "value@0,0")
    sphere, umbilics, value, torus, *_ = rows(done)
    assert {name: x["exact"] for name, x in sphere["answer"]["values"].items()} == {"K": "1", "H": "-1"}
    assert umbilics["answer"]["everywhere"]
    assert [x["double"] for x in value["answer"]["values"].values()] == [float(x) for x in example("sphere")(0, 0)]
    # on the tube of radius 1 around a circle of radius 2, where cos θ = 3/5: K = cos θ / (2 + cos θ), and outwards
    # 2 H = −1 − K
    assert [torus["answer"]["values"][name]["exact"] for name in "KH"] == ["3/13", "-8/13"]
    assert run("inspect", alone, "--ask", "curvature@0,0,0").returncode == 2
    assert run("inspect", alone, "--ask", "inflections").returncode == 2


def test_surfaces_are_converted(mixed, tmp_path):
    place = tmp_path / "surfaces.igs"
    done = run("convert", mixed, place, "--surfaces", "--json")
    assert [row["degree"] for row in rows(done)] == [[2, 2], [2, 2]]
    assert read(place).surfaces == (example("sphere"), example("torus"))
    assert run("convert", mixed, tmp_path / "curve.igs", "--strict").returncode == 2
    assert run("convert", mixed, tmp_path / "curve.svg", "--surfaces").returncode == 2


def test_a_sweep_names_surfaces(mixed, tmp_path):
    lines = [json.loads(line) for line in run("sweep", mixed, "-o", "-").stdout.splitlines()]
    assert [(line["error"] or {}).get("kind") for line in lines] == [None, "Skipped", "Skipped"]
    assert "torus" in lines[2]["error"]["message"] or "surface" in lines[2]["error"]["message"]
    assert run("sweep", mixed, "-o", tmp_path / "x.jsonl", "--strict").returncode == 2
