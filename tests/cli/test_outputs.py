"""What the command line writes: never over its input, never half, and a full disk is not a verdict."""

import json
import os
import subprocess
import sys

import pytest

from exactspline import derive, example, read
from tests.support.command import run

CURVE = {"degree": 2, "knots": [0, 0, 0, 1, 1, 1], "control_points": [[0, 0], [1, 1], [2, 0]]}


@pytest.mark.parametrize("command", [("derive", "evolute"), ("bisector",)])
def test_the_input_is_not_written_over(tmp_path, command):
    file = tmp_path / "curve.json"
    file.write_text(json.dumps(CURVE))
    done = run(*command, file, "-o", file, *(["--point", "5,5"] if command[0] == "bisector" else []))
    assert done.returncode == 2
    assert "is the curve that is read" in done.stderr
    assert json.loads(file.read_text()) == CURVE


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="a device that is always full is needed")
def test_a_full_disk_is_bad_output_and_no_verdict():
    command = [sys.executable, "-m", "exactspline", "prove", "--claim", "C4.1c"]
    with open("/dev/full", "w") as full:
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True, check=False)
    assert done.returncode == 2
    assert "cannot be written" in done.stderr
    assert "Traceback" not in done.stderr


def test_a_formula_has_two_forms():
    done = run("derive", "g2", "circle", "--variant", "best")
    assert done.returncode == 2
    assert "no variant 'best'" in done.stderr
    assert json.loads(run("derive", "g2", "ellipse", "--variant", "naive").stdout)["pieces"][0]["degree"] == 12


def test_the_torsion_at_its_zero_is_zero():
    data = json.loads(run("inspect", "rational_space_cubic_spline", "--json").stdout)["rows"][0]
    assert {f["torsion"] for f in data["torsion_zeros"]["points"] if not f["by_jump"]} <= {"0"}


def test_text_in_an_error_is_taken_literally():
    assert "x:smile:" in run("inspect", "x:smile:.json").stderr


@pytest.mark.parametrize(
    ("name", "curve"), [("evolute", "ellipse_skew"), ("evolute", "parabola"), ("focal_curve", "rational_space_cubic")]
)
def test_a_derived_curve_can_be_read_again(tmp_path, name, curve):
    file = tmp_path / "derived.json"
    assert run("derive", name, curve, "-o", file).returncode == 0
    found, expected = read(file).curve, derive(name, example(curve))
    for t in ("1/7", "3/5"):
        assert found(t) == expected(t)


def test_what_is_no_curve_is_not_read_as_one(tmp_path):
    file = tmp_path / "derived.json"
    for name, curve in (
        ("zero_curvature", "ellipse"),
        ("evolute", "straight_between_arcs"),
        ("tangent_developable", "twisted_cubic"),
    ):
        assert run("derive", name, curve, "-o", file).returncode == 0
        done = run("inspect", file)
        assert done.returncode == 2
        assert "no curve" in done.stderr or "not one curve" in done.stderr
    for net in ([[1, "x", 1]], [1], None, [[]], [["1", "1"]]):
        piece = {"kind": "rational", "degree": 1, "knots": [0, 0, 1, 1], "homogeneous_control_points": net}
        file.write_text(json.dumps({"pieces": [piece]}))
        done = run("inspect", file)
        assert done.returncode == 2
        assert done.stderr.count("\n") == 1


@pytest.mark.parametrize(
    "arguments",
    [
        ("inspect", "torus", "torus", "--ask", "umbilics"),
        ("inspect", "folded_map", "--ask", "kind", "--ask", "kind"),
        ("inspect", "circle", "--ask", "area", "--ask", "area"),
        ("between", "circle", "ellipse", "--ask", "distance", "--ask", "distance"),
    ],
)
def test_what_is_asked_twice_has_two_rows_with_keys_of_their_own(arguments):
    """Of surfaces, pairs and regions a KeyError."""
    keys = [row["key"] for row in json.loads(run(*arguments, "--json").stdout)["rows"]]
    assert len({*keys}) == len(keys) == 2
