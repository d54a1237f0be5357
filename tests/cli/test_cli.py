"""The command line as a user meets it: tables, JSON, exit status, one-line errors."""

import json
import re

import pytest

from tests.support.command import invoke, run, run_alone


def test_prove_on_a_curve_shows_the_cancelled_factor():
    done = run_alone("prove", "--curve", "rational_cubic", "--claim", "C4.1")
    assert done.returncode == 0
    assert "f0 = w⁻³ · f2" in done.stdout
    assert "all as recorded" in done.stdout


def test_equal_weights_are_told_to_be_polynomial(tmp_path):
    file = tmp_path / "equal.json"
    file.write_text(
        '{"degree": 2, "knots": [0,0,0,1,1,1], "control_points": [[0,0],[1,1],[2,0.5]], "weights": [0.5, "1/2", 5e-1]}'
    )
    done = run("prove", "--curve", file)
    assert done.returncode == 0
    assert "polynomial (equal weights)" in done.stdout


def test_degrees_of_formulas_on_a_curve():
    assert "3d − 3" in run("formula", "degrees", "--curve", "ellipse", "--formulas").stdout
    found = {
        row["formula"]: row
        for row in json.loads(run("formula", "degrees", "--curve", "ellipse", "--formulas", "--json").stdout)["rows"]
    }
    f2 = found["f2"]
    assert (f2["nominal"], f2["represented"], f2["true"], f2["control_points"]) == ("3d − 3", 3, 0, 16)


@pytest.mark.parametrize("name", ["straight_line", "planar_in_space", "space_line", "jump", "twisted_cubic"])
def test_degrees_go_on_where_an_object_does_not_exist(name):
    for option in ([], ["--formulas"]):
        rows = json.loads(invoke("formula", "degrees", "--curve", name, "--json", *option).stdout)["rows"]
        assert len(rows) > 5


def test_a_ruled_surface_is_written_with_directrix_and_generator(tmp_path):
    file = tmp_path / "surface.json"
    assert invoke("derive", "tangent_developable_reduced", "rational_space_cubic", "-o", str(file)).exit_code == 0
    data = json.loads(file.read_text())
    assert data["layout"] == "directrix, generator"
    assert all(len(point) == 7 for point in data["pieces"][0]["homogeneous_control_points"])


def test_what_does_not_exist_says_why():
    for name, curve, reason in [
        ("focal_curve", "planar_in_space", "planar"),
        ("evolute", "straight_cubic", "straight"),
        ("torsion", "space_line", "straight"),
    ]:
        done = run("derive", name, curve)
        assert (done.returncode, done.stderr.count("\n")) == (2, 1)
        assert reason in done.stderr


def test_status_1_when_a_verdict_differs_from_the_record(monkeypatch):
    from dataclasses import replace

    from exactspline.verification import claims

    wrong = tuple(replace(c, factor="w^2") if c.id == "C4.1a" else c for c in claims.all_claims())
    monkeypatch.setattr(claims, "claims_in", lambda sources: wrong)
    result = invoke("prove", "--claim", "C4.1a")
    assert result.exit_code == 1
    assert "DIFFER" in result.output


GOOD = {"degree": 2, "knots": [0, 0, 0, 1, 1, 1], "control_points": [[0, 0], [1, 1], [2, 0]]}
BAD = {
    "knots that decrease": (GOOD | {"knots": [0, 0, 0, 1, "1/2", 1]}, "knots[4]"),
    "a weight function with a rational zero": (GOOD | {"weights": [1, -1, 1]}, "zero at the parameter 1/2"),
    "a weight function that changes sign": (GOOD | {"weights": [1, 1, -1]}, "between the parameters"),
    "a zero denominator": (GOOD | {"knots": [0, 0, 0, "1/0", 1, 1]}, "zero denominator"),
    "a fractional degree": (GOOD | {"degree": "2.5"}, "is not a degree"),
    "a degree that is not a number": (GOOD | {"degree": None}, "is not a degree"),
    "a missing field": ({"degree": 2}, "'knots' is missing"),
    "an unknown field": (GOOD | {"wieghts": [1, 1, 1]}, "'wieghts' is unknown"),
    "a list": ([1, 2], "not an object"),
    "a point that is not a list": (GOOD | {"control_points": [0, 1, 2]}, "control_points[0]"),
    "knots that are not a list": (GOOD | {"knots": 3}, "not a list"),
}


TEXTS = {what: (json.dumps(data), message) for what, (data, message) in BAD.items()} | {
    "not JSON": ("degree: 2", "not JSON"),
    "NaN": ('{"degree": 2, "knots": [NaN], "control_points": []}', "NaN is not a number"),
    "infinity": ('{"degree": 2, "knots": [-Infinity], "control_points": []}', "Infinity is not a number"),
    "nested too deep": ("[" * 100_000 + "]" * 100_000, "nested too deep"),
    "an exponent that would fill the memory": (
        '{"degree": 1, "knots": [0,0,1,1], "control_points": [[1e999999999,0],[1,1]]}',
        "exponent",
    ),
    "empty": ("", "is empty"),
}


@pytest.mark.parametrize("what", TEXTS)
def test_bad_curves_give_one_line_and_status_2(what, tmp_path):
    text, message = TEXTS[what]
    file = tmp_path / "bad.json"
    file.write_text(text)
    for command in (["prove"], ["formula", "degrees"]):
        done = run(*command, "--curve", file)
        assert (done.returncode, done.stderr.count("error:")) == (2, 1)
        assert done.stderr.count("\n") == 1 + done.stderr.startswith("skipped: ")
        assert message in done.stderr
        assert str(file) in done.stderr


def test_bad_files_give_one_line_and_status_2(tmp_path):
    huge = tmp_path / "huge.json"
    with huge.open("wb") as stream:
        stream.truncate(500 * 1024 * 1024)
    binary = tmp_path / "binary.json"
    binary.write_bytes(b"\xff\xfe\x00")
    for file, message in [
        (tmp_path, "is a directory"),
        (tmp_path / "none.json", "cannot be read"),
        (huge, "at most"),
        (binary, "not UTF-8"),
    ]:
        done = run("prove", "--curve", file)
        assert (done.returncode, done.stderr.count("\n")) == (2, 1), done.stderr
        assert message in done.stderr


def test_one_bad_curve_in_a_batch_is_reported_and_the_rest_goes_on(tmp_path):
    done = run("prove", "--claim", "C4.1", "--curve", tmp_path / "none.json", "--curve", "cusp")
    assert done.returncode == 2
    assert "cusp: polynomial" in done.stdout
    assert "none.json" in done.stderr


def test_unknown_claims_and_options_are_bad_input():
    assert run("prove", "--claim", "C99").returncode == 2
    assert run("prove", "--nonsense").returncode == 2
    assert run("nonsense").returncode == 2


def test_digits_show_decimals_beside_exact_numbers():
    done = run("prove", "--claim", "C3c", "--curve", "rational_space_cubic", "--digits", "12")
    assert "1/15 ≈ 0.0666666666667" in done.stdout


def test_reduce_on_a_formula_of_the_library():
    (part,) = json.loads(invoke("formula", "reduce", "curvature_squared_derivative", "--json").stdout)["rows"]
    assert (part["naive"], part["reduced"], part["true"]) == ("48d", "[X X′ X″ X‴]·f2", "11d − 18")
    assert part["meaning"]["f2"] == "may have zeros"
    table = run("formula", "reduce", "rectifying_developable").stdout
    assert "10d − 18" in table
    assert "positive where the curve is regular" in table


OWN = """
from exactspline.language import det, dot, norm2, perp

def pedal(c):
    normal = perp(c.gamma.d(1))
    return normal * dot(c.gamma, normal) / norm2(normal)

def broken(c):
    return 1 / 0

def five(c):
    return 5

not_a_function = 3
"""


def test_reduce_on_a_function_of_a_stranger(tmp_path, monkeypatch):
    (tmp_path / "strange_formulas.py").write_text(OWN)
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(tmp_path)
    for target in (
        "strange_formulas.py:pedal",
        "strange_formulas:pedal",
        str(tmp_path / "strange_formulas.py") + ":pedal",
    ):
        done = run("formula", "reduce", target, "--trust")
        assert done.returncode == 0
        assert "4d − 4" in done.stdout
    (tmp_path / "checked.py").write_text(OWN.partition("def broken")[0])
    assert "4d − 4" in run("formula", "reduce", "checked.py:pedal").stdout


def test_a_module_runs_with_trust_alone_and_it_is_said(tmp_path, monkeypatch):
    """Before: any module was imported without --trust, and nothing said that it ran unchecked."""
    (tmp_path / "mine.py").write_text("open('ran', 'w').close()\n\n\ndef speed(c):\n    return c.gamma.d(1)\n")
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(tmp_path)
    done = run("formula", "reduce", "mine:speed")
    assert (done.returncode, done.stdout) == (2, "")
    assert "--trust" in done.stderr
    assert not (tmp_path / "ran").exists()
    done = run("formula", "reduce", "mine:speed", "--trust")
    assert done.returncode == 0
    assert "formulas that ran unchecked (--trust): mine" in done.stdout


@pytest.mark.parametrize(
    ("target", "message"),
    [
        ("strange.py:broken", "ZeroDivisionError"),
        ("strange.py:five", "the value is the number 5"),
        ("strange.py:nothing", "no function"),
        ("strange.py:not_a_function", "no function"),
        ("missing.py:f", "no such file"),
        ("no_such_module:f", "No module named"),
        ("wrong.py:f", "SyntaxError"),
        ("leaves.py:f", "SystemExit"),
        ("T1", "Table 1"),
        ("nonsense", "no formula"),
    ],
)
def test_reduce_reports_errors_of_the_user_in_one_line(target, message, tmp_path, monkeypatch):
    (tmp_path / "strange.py").write_text(OWN)
    (tmp_path / "wrong.py").write_text("def f(c:\n")
    (tmp_path / "leaves.py").write_text("raise SystemExit(0)\n")
    monkeypatch.chdir(tmp_path)
    done = run("formula", "reduce", target, "--trust")
    assert (done.returncode, done.stdout) == (2, "")
    assert message in done.stderr
    assert done.stderr.count("error:") == 1
    assert "Traceback" not in done.stderr


def test_the_generic_degree_table():
    found = json.loads(invoke("formula", "degrees", "--generic", "--json").stdout)["rows"]
    rows = {row["object"]: row for row in found if row["curves"] == "rational"}
    row = rows["critical curvature"]
    assert (row["naive"], row["paper"], row["true"]) == ("48d", "9d − 6", "8d − 12")
    assert all(row["j"] == 0 and row["true"] for row in rows.values())
    assert not any(row["differ"] for row in found)
    assert all(row["attained"][-1] == 6 for row in found)


def test_certificates_from_the_command_line():
    from exactspline import check_certificate

    chosen = ["--curve", "ellipse_skew", "--curve", "circle"]
    rows = json.loads(invoke("formula", "degrees", "--certify", *chosen).stdout)["rows"]
    checked = {row["key"]: check_certificate(row["certificate"])["degree"] for row in rows if not row["missing"]}
    assert checked["ellipse_skew: critical_curvature"] == 4
    assert any("vanishes" in row["missing"] for row in rows)


def test_an_error_points_to_what_was_meant(tmp_path):
    """`teach exercise --hint` and `formula degrees f2` named what is like them only; a name was listed three times; the
    end of a file of one line was line 2.
    """
    assert "`exactspline teach check` has it" in run("teach", "exercise", "--hint").stderr
    assert "write `exactspline errata 5.4`" in run("errata", "--section", "5.4").stderr
    assert "add --formulas" in run("formula", "degrees", "f2").stderr
    assert "add --generic, or --at D" in run("formula", "degrees", "bisector").stderr
    names = re.search(r"the nearest are (.*?);", run("errata", "6.9").stderr)[1].split(", ")
    assert len(set(names)) == len(names) == 3
    file = tmp_path / "cut.json"
    file.write_text('{"degree": 2,\n')
    assert "line 1, column 14" in run("inspect", str(file)).stderr


@pytest.mark.parametrize(
    ("typed", "remedy"),
    [
        (("intersections", "circle", "ellipse"), "did you mean 'between'; "),
        (("degrees",), "did you mean 'formula degrees'; "),
        (("teach", "check", "--topic", "evaluation", "-6, -7"), 'write `exactspline teach check --text "-6, -7"`'),
        (("identity", "-f1 = f1"), 'write `exactspline identity -- "-2*f1 = -f1 - f1"`'),
        (("identity", "norm2(γ').d(1) = 2*dot(γ', γ'')"), "write a prime for each derivative: norm2(γ')', γ''"),
    ],
)
def test_the_remedy_of_an_error_is_one_that_works(typed, remedy):
    done = run_alone(*typed)
    assert (done.returncode, remedy in done.stderr) == (2, True), done.stderr


def test_what_remedies_name_works():
    assert run("identity", "--", "-2*f1 = -f1 - f1").returncode == 0
    assert run("identity", "norm2(γ')' = 2*dot(γ', γ'')").returncode == 0
    assert run("teach", "check", "--topic", "evaluation", "--text", "-6, -7").stdout.startswith("wrong")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("f1 = f2", "the quotient is w; on the example curve rational_cubic: the sides differ by"),
        ("γ' = γ''", "they are not parallel; on the example curve rational_cubic: the sides differ by"),
        ("speed = f1", "not speed = f1 in R2: they differ"),  # a square root is not a spline
    ],
)
def test_a_false_identity_comes_with_a_counterexample(text, said):
    done = run("identity", text)
    assert done.returncode == 1
    assert said in " ".join(done.stdout.split())


def test_triangles_have_no_legend_of_other_tables():
    assert "parameter" not in run("teach", "triangle", "parabola", "--at", "1/3").stdout
