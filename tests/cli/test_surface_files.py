"""Commands on the surfaces of files, alone and beside curves."""

import io
import json
import re

import jsonschema
import pytest

from exactspline import example, read, write
from exactspline.batch.lines import line_schema
from exactspline.interchange.files import encoded
from tests.support.command import run, schema_of


@pytest.fixture
def mixed(tmp_path):
    """A g2 file with a curve and two surfaces."""
    place = tmp_path / "mixed.g2"
    surfaces, _ = encoded([example("cylinder"), example("biquadratic")], "g2")
    curve, _ = encoded([example("cusp")], "g2")
    place.write_bytes(surfaces + curve)
    return place


@pytest.fixture
def alone(tmp_path):
    place = tmp_path / "alone.itd"
    write([example("cylinder"), example("biquadratic")], place)
    return place


def rows(done):
    return json.loads(done.stdout)["rows"]


def test_a_file_of_surfaces_is_inspected(alone):
    done = run("inspect", alone, "--json", "--strict")
    assert done.returncode == 0, done.stderr
    assert [(row["surface"], row["curvature"]) for row in rows(done)] == [("cylinder", "0"), ("biquadratic", None)]


def test_of_a_mixed_file_either_is_taken_and_the_other_named(mixed):
    curves, surfaces = run("inspect", mixed, "--json"), run("inspect", mixed, "--json", "--surfaces")
    assert [row["curve"] for row in rows(curves)] == ["g2 1"]
    assert "2 surfaces" in curves.stderr
    assert len(rows(surfaces)) == 2
    assert "1 curve" in surfaces.stderr
    assert (curves.returncode, surfaces.returncode) == (0, 0)
    for given in ((), ("--surfaces",)):
        assert run("inspect", mixed, "--strict", *given).returncode == 2


def test_exact_answers_about_surfaces(tmp_path):
    round_ones = tmp_path / "round.itd"
    write([example("sphere"), example("torus")], round_ones)
    done = run("inspect", round_ones, "--json", "--ask", "curvature@1/3,1/2", "--ask", "umbilics", "--ask", "value@0,0")
    sphere, umbilics, value, torus, *_ = rows(done)
    assert {name: x["exact"] for name, x in sphere["answer"][0]["values"].items()} == {"K": "1", "H": "-1"}
    assert umbilics["answer"]["everywhere"]
    assert [x["double"] for x in value["answer"][0]["values"].values()] == [float(x) for x in example("sphere")(0, 0)]
    # on the tube of radius 1 around a circle of radius 2, where cos θ = 3/5: K = cos θ / (2 + cos θ), and outwards
    # 2 H = −1 − K
    assert [torus["answer"][0]["values"][name]["exact"] for name in "KH"] == ["3/13", "-8/13"]
    assert run("inspect", round_ones, "--ask", "curvature@0,0,0").returncode == 2
    assert run("inspect", round_ones, "--ask", "inflections").returncode == 2


def test_surfaces_are_converted(mixed, tmp_path):
    place = tmp_path / "surfaces.igs"
    done = run("convert", mixed, place, "--surfaces", "--json")
    assert [row["degree"] for row in rows(done)] == [[2, 1], [2, 2]]
    assert read(place).surfaces == (example("cylinder"), example("biquadratic"))
    assert run("convert", mixed, tmp_path / "curve.igs", "--strict").returncode == 2
    assert run("convert", mixed, tmp_path / "curve.svg", "--surfaces").returncode == 2


def test_a_sweep_names_surfaces(mixed, tmp_path):
    lines = [json.loads(line) for line in run("sweep", mixed, "-o", "-").stdout.splitlines()]
    assert [(line["error"] or {}).get("kind") for line in lines] == [None, "Skipped", "Skipped"]
    assert "surface" in lines[2]["error"]["message"]
    assert run("sweep", mixed, "-o", tmp_path / "x.jsonl", "--strict").returncode == 2


def test_a_sweep_of_surfaces(mixed, tmp_path):
    """Sweeps named the surfaces of files and answered nothing about them."""
    lines = [json.loads(line) for line in run("sweep", mixed, "--surfaces", "-o", "-").stdout.splitlines()]
    cylinder, biquadratic, skipped = lines
    assert (cylinder["degrees"], cylinder["patches"], biquadratic["patches"]) == ([2, 1], 4, 1)
    inspected = rows(run("inspect", mixed, "--surfaces", "--json", "--digits", "10"))
    for line, row in zip((cylinder, biquadratic), inspected, strict=True):
        assert line["answers"] == {name: row[name] for name in line["answers"]}
        assert "patches" in line["answers"]
    assert skipped["error"] == {"kind": "Skipped", "message": "curve: g2 1: not a surface", "bad_input": True}
    # a sweep that is continued, its summary, and a question at a place
    place = tmp_path / "lines.jsonl"
    command = ("sweep", mixed, "--surfaces", "--find", "umbilics", "--find", "value@0,0", "-o", place, "--json")
    first, again = run(*command), run(*command)
    counts = {(row["what"], row["name"]): row["count"] for row in rows(first)}
    assert counts["surfaces", ""] == 2
    assert counts["patches", ""] == 5
    assert {("filter", "computed before")} <= {(row["what"], row["name"]) for row in rows(again)}
    assert run("sweep", mixed, "--find", "inflections", "-o", place).returncode == 2


def test_the_elements_of_answers_have_types():
    """Passed before: a point without a parameter, and a kind that there is not, in rows of ``inspect`` and in lines."""
    schemas = [jsonschema.Draft202012Validator(each) for each in (schema_of("inspect"), schema_of("inspect surface"))]
    for name, schema in zip(("ellipse", "folded_map"), schemas, strict=True):
        document = json.loads(run("inspect", name, "--json").stdout)
        schema.validate(document)
        answers = document["rows"][0]
        spoiled = answers["critical_points"]["points"] if name == "ellipse" else answers["zero_curves"]
        del spoiled[0]["parameter" if name == "ellipse" else "u"]
        with pytest.raises(jsonschema.ValidationError):
            schema.validate(document)
    line = json.loads(run("sweep", "--surfaces", "enneper", "--find", "umbilics", "-o", "-").stdout)
    schema = jsonschema.Draft202012Validator(line_schema())
    schema.validate(line)
    for answers in ({"umbilics": []}, {"umbilic": line["answers"]["umbilics"]}, {"value@0,0": 1}):
        with pytest.raises(jsonschema.ValidationError):
            schema.validate(line | {"answers": answers})


def test_what_a_sweep_of_surfaces_refuses(mixed, tmp_path):
    for options in (("--claim", "S1.1"), ("--values",), ("--random", "count=2"), ("--find", "inflections")):
        done = run("sweep", mixed, "--surfaces", *options)
        assert done.returncode == 2, options
        assert "Traceback" not in done.stderr
    assert run("sweep", mixed, "--surfaces", "-o", tmp_path / "x.parquet").returncode == 2
    assert run("sweep", "planar_map", "--surfaces", "--strict").returncode == 0


@pytest.fixture
def standard_input_of(monkeypatch):
    """Standard input that holds these bytes."""

    def given(data):
        monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(data)))

    return given


def test_surfaces_of_any_format_on_standard_input(alone, mixed, standard_input_of):
    """Only our JSON was taken as surfaces there; of other files it was said that they hold no curves."""
    standard_input_of(alone.read_bytes())
    done = run("inspect", "-", "--json")
    assert [row["surface"] for row in rows(done)] == ["cylinder", "biquadratic"], done.stderr
    standard_input_of(mixed.read_bytes())
    assert len(rows(run("inspect", "-", "--json", "--surfaces"))) == 2
    standard_input_of(mixed.read_bytes())
    assert [row["curve"] for row in rows(run("inspect", "-", "--json"))] == ["g2 1"]


def test_formulas_and_claims_on_surfaces_of_files(alone, tmp_path, standard_input_of):
    """Only our JSON was read."""
    one = tmp_path / "one.g2"
    write(example("biquadratic"), one)
    expected = json.loads(run("derive", "surfaces:gaussian_curvature", "biquadratic").stdout) | {"surface": None}
    for given in (one, "-"):
        standard_input_of(one.read_bytes())
        done = run("derive", "surfaces:gaussian_curvature", given)
        assert done.returncode == 0, done.stderr
        assert json.loads(done.stdout) | {"surface": None} == expected
    several = run("derive", "surfaces:gaussian_curvature", alone)
    assert several.returncode == 2
    assert "2 surfaces, where one is expected" in several.stderr
    done = run("prove", "--surface", alone, "--claim", "S1", "--json")
    assert {row["curve"] for row in rows(done)} >= {"cylinder", "biquadratic"}, done.stderr


def test_what_holds_no_surface_is_named(tmp_path):
    place = tmp_path / "curve.g2"
    write(example("cusp"), place)
    done = run("derive", "surfaces:gaussian_curvature", place)
    assert done.returncode == 2
    assert "holds no surface" in done.stderr
    assert "Traceback" not in done.stderr


def test_notes_on_curves_that_are_not_taken_are_not_told(tmp_path):
    """`inspect --surfaces` told the notes of the curves that it left out."""
    place = tmp_path / "both.stp"
    surface, _ = encoded([example("sphere")], "step")
    curve, _ = encoded([example("circle")], "step")
    entities = curve.split(b"DATA;")[1].split(b"ENDSEC;")[0]
    shifted = re.sub(rb"#(\d+)", lambda found: b"#%d" % (int(found[1]) + 10_000), entities)
    place.write_bytes(surface.replace(b"DATA;", b"DATA;" + shifted, 1))
    reading = read(place)
    assert (len(reading.curves), len(reading.surfaces)) == (1, 1)
    for option, told in ((), True), (("--surfaces",), False):
        done = run("inspect", place, *option)
        assert all((note in done.stderr) == told for note in reading.curves[0].notes), done.stderr
