"""`exactspline convert` as a user meets it."""

import io
import json
import re
from functools import partial

import pytest

import exactspline as xs
from exactspline import read
from exactspline.errors import CurveFileError, NumberError
from exactspline.interchange import Limits, files
from tests.support.command import invoke
from tests.support.interchange_seeds import G2, SVG, dxf, truetype


def run(*arguments, **options):
    return invoke("convert", *map(str, arguments), **options)


def test_from_one_format_to_another(tmp_path):
    source, target = tmp_path / "a.g2", tmp_path / "a.igs"
    source.write_bytes(G2)
    done = run(source, target)
    assert done.exit_code == 2  # 0 before, although a curve is left out
    assert re.search(
        rf"^skipped: {re.escape(str(source))}: circle \(.+\): not read; write it as a spline$",
        done.stderr,
        re.MULTILINE,
    )
    assert "2 curves from g2 to" in done.stderr
    assert [named.curve.degree for named in read(target).curves] == [1, 2]


def test_from_standard_input_to_standard_output():
    done = run("-", "-", "--to", "json", input=SVG)
    assert done.exit_code == 0
    assert len(read(io.BytesIO(done.stdout_bytes).read()).curves) == 4


def test_a_curve_without_a_name_is_called_by_its_file(tmp_path):
    """It was called "arc.json", by `inspect` "arc"."""
    source = tmp_path / "arc.json"
    source.write_text('{"degree": 1, "knots": [0, 0, 1, 1], "control_points": [[0, 0], [1, 1]]}')
    assert read(source).curve.name == "arc"


def test_one_glyph_only(tmp_path):
    pytest.importorskip("fontTools")
    source, target = tmp_path / "f.ttf", tmp_path / "a.svg"
    source.write_bytes(truetype())
    assert run(f"{source}:both", target, "--only", "both.2").exit_code == 0
    assert len(read(target).curves) == 1


def test_what_cannot_be_exact_is_refused_unless_asked_for(tmp_path):
    source, target = tmp_path / "a.json", tmp_path / "a.g2"
    source.write_text('{"degree": 1, "knots": [0, 0, 1, 1], "control_points": [[0, 0], ["1/3", 1]]}')
    refused = run(source, target)
    assert isinstance(refused.exception, NumberError)
    assert not target.exists()
    rounded = run(source, target, "--round")
    assert rounded.exit_code == 0
    assert "1 numbers were rounded" in rounded.stderr


def test_nothing_to_convert_and_no_overwriting_of_the_source(tmp_path):
    source = tmp_path / "a.cptw"
    source.write_text("0,0,1\n1,1,1\n")
    assert isinstance(run(source, tmp_path / "b.g2").exception, CurveFileError)
    assert run(source, tmp_path / "b.g2", "--degree", "1").exit_code == 0
    assert isinstance(run(tmp_path / "b.g2", tmp_path / "b.g2").exception, CurveFileError)


def test_what_was_converted_is_told_as_json_under_its_schema(tmp_path):
    jsonschema = pytest.importorskip("jsonschema")
    from tests.support.command import schema_of

    source, target = tmp_path / "drawing.svg", tmp_path / "curves.json"
    source.write_bytes(SVG if isinstance(SVG, bytes) else SVG.encode())
    done = run(source, target, "--json")
    assert done.exit_code == 0
    data = json.loads(done.stdout)
    jsonschema.validate(data, schema_of("convert"))
    assert [row["format"] for row in data["rows"]] == ["svg"] * len(data["rows"])
    # thirds among them: *.json is the format that holds everything
    assert read(target).format == "json"
    assert "name a file" in str(run(source, "-", "--json").exception)
    # what is skipped is said however quiet it is
    assert {line.split(":")[0] for line in run(source, target, "--quiet").stderr.splitlines()} == {"skipped"}


def test_a_message_names_its_file_and_a_note_its_curve_once(tmp_path, monkeypatch):
    """Before: "big.svg: big.svg: more than …", "note: a: note: …"."""
    monkeypatch.setattr(files, "Limits", partial(Limits, objects=99))
    big = tmp_path / "big.svg"
    big.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path d="M0 0' + " L1 1" * 99 + '"/></svg>'
    )
    refused = run(big, tmp_path / "out.json")
    assert "more than 99 objects" in str(refused.exception)
    assert str(refused.exception).count("big.svg") == 1
    noted = tmp_path / "two.json"
    curve = '{"degree": 1, "knots": [0, 0, 1, 1], "control_points": [[0, 0], [1, 1]], "note": "drawn by hand"}'
    noted.write_text(f"[{curve}, {curve}]")
    assert "note: 2 curves: drawn by hand\n" in invoke("inspect", str(noted)).stderr


def test_pieces_are_replaced_on_request_and_each_is_listed(tmp_path):
    source, target = tmp_path / "arc.json", tmp_path / "exact.json"
    arc = xs.Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], [1, "0.70710678", 1], name="arc")
    xs.write(arc, source)
    found = run(source, target, "--snap", "line,circle", "--epsilon", "written", "--json")
    assert found.exit_code == 0, (found.output, found.exception)
    (row,) = json.loads(found.output)["rows"]
    (piece,) = row["replaced"]
    assert (found.exit_code, piece["kind"], row["kept"]) == (0, "circle", [])
    assert row["notes"][0] == "[0, 1] replaced by a circle: centre (0, 0), radius 1, within 3.059e-10"
    assert list(xs.read(target).curves[0].curve.weights) == [2, 1, 1]
    assert "without --snap" in str(run(source, target, "--epsilon", "1").exception)
    assert "'helix' is unknown" in str(run(source, target, "--snap", "helix").exception)


def test_a_curve_that_cannot_be_repaired_is_named_and_the_others_are(tmp_path):
    """Before, one curve of a file that jumps ended the command, and where nothing was near enough it said nothing."""
    arc = xs.Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], [1, "0.7071067811865476", 1], name="arc")
    points = [(0, 0), (1, "1e-12"), (2, 0), (5, 5), (6, 6), (7, 9)]
    gap = xs.Nurbs(2, [0, 0, 0, 1, 1, 1, 2, 2, 2], points, name="gap")
    source, target = tmp_path / "both.json", tmp_path / "exact.json"
    xs.write([xs.interchange.NamedCurve("gap", gap), xs.interchange.NamedCurve("arc", arc)], source)
    done = run(source, target, "--snap", "line,circle")
    assert "not replaced: gap: " in done.stderr
    assert "arc: [0, 1] replaced by a circle" in done.stderr
    assert xs.read(target).curves[0].curve == gap
    assert "no piece is near enough" in run(source, target, "--only", "arc", "--snap", "line").stderr


ONE_PERIOD = (
    "0 SPLINE 5 A 70 10 71 3 72 5 73 4"
    + "".join(f" 40 {t}" for t in range(5))
    + "".join(f" 10 {x} 20 {y}" for x, y in ((0, 0), (3, 1), (2, 4), (-1, 2)))
)


@pytest.mark.parametrize("suffix", ["json", "g2", "itd", "xml", "igs", "stp", "brep", "dxf"])
def test_a_closed_spline_listed_by_one_period_there_and_back(tmp_path, suffix):
    source, target, back = tmp_path / "a.dxf", tmp_path / f"b.{suffix}", tmp_path / "c.json"
    source.write_bytes(dxf(ONE_PERIOD))
    assert run(source, target).exit_code == 0
    assert run(target, back).exit_code == 0
    first, last = read(source).curve, read(back).curve
    assert last.closed
    assert last.knots == first.knots
    assert [p[:2] for p in last.control_points] == list(first.control_points)


def test_a_lost_arc_has_a_line_and_a_status_and_the_option_reads_it(tmp_path):
    source, target = tmp_path / "a.dxf", tmp_path / "b.json"
    source.write_bytes(dxf("0 ARC 10 0 20 0 40 1 50 10 51 50 0 LINE 10 0 20 0 11 1 21 1"))
    done = run(source, target)
    assert done.exit_code == 2
    assert re.search(r"^skipped: .*ARC at line 5.*an angle that is not a multiple of 90°", done.stderr, re.M)
    assert "--approximate E takes one within E" in done.stderr
    assert len(read(target).curves) == 1
    done = run(source, target, "--approximate", "1e-9")
    assert done.exit_code == 0
    assert "its ends are moved along the curve by at most 1/1000000000" in done.stderr
    assert len(read(target).curves) == 2
