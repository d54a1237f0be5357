"""Several contours as one region, by the command line; and the parts of a file that have a name."""

import csv
import json
import shlex

import pytest
from gmpy2 import mpq

from exactspline import read
from exactspline.errors import CurveFileError
from tests.support.command import run

SVG = """<svg xmlns="http://www.w3.org/2000/svg">
<g id="both" transform="translate(10 0)"><path id="framed" d="M0 0L4 0L4 4Q2 6 0 4ZM1 1L1 2L2 2L2 1Z"/>
<circle id="round" r="1" cx="20"/></g>
<path id="other" d="M0 0L3 0L3 3L0 3Z"/><text>left out</text>
<use id="copy" href="#framed" x="50"/></svg>"""
TRIANGLE = [(8, "A"), (70, "1"), (90, "3"), (10, "0"), (20, "0"), (10, "1"), (20, "0"), (10, "0"), (20, "1")]
SQUARE = [
    (8, "B"),
    (70, "1"),
    (90, "4"),
    *[(c, str(v)) for p in ((9, 9), (8, 9), (8, 8), (9, 8)) for c, v in zip((10, 20), p)],
]
#: By which rule and question, and the answer in numbers or words.
ANSWERS = [
    ("even-odd", "area", "53/3"),
    ("nonzero", "area", "53/3"),
    ("nonzero", "winding_number:10.5,2", 1),
    ("nonzero", "winding_number:11.5,3/2", 0),
    ("even-odd", "contains:11.5,3/2", "outside"),
    ("even-odd", "contains:10.5,3/2", "inside"),
    ("even-odd", "contains:11,3/2", "on a curve"),
]


@pytest.fixture
def drawing(tmp_path):
    path = tmp_path / "drawing.svg"
    path.write_text(SVG)
    return path


def dxf(tmp_path):
    pairs = [(0, "SECTION"), (2, "ENTITIES"), (0, "LWPOLYLINE"), *TRIANGLE, (0, "LWPOLYLINE"), *SQUARE]
    path = tmp_path / "layers.dxf"
    path.write_text("".join(f"{a}\n{b}\n" for a, b in [*pairs, (0, "ENDSEC"), (0, "EOF")]))
    return path


def asked(place, question, rule, *more):
    done = run("inspect", place, "--ask", question, "--region", rule, *more)
    return done.returncode, done.stdout, done.stderr


@pytest.mark.parametrize(("rule", "question", "answer"), ANSWERS)
def test_a_path_as_one_region_in_all_forms(drawing, rule, question, answer):
    place = f"{drawing}:framed"
    status, shown, _ = asked(place, question, rule, "--json")
    [row] = json.loads(shown)["rows"]
    found = row["answer"]["exact"] if isinstance(row["answer"], dict) else row["answer"]
    assert (status, found, row["error"]) == (0, answer, "")
    assert row["curve"] == f"region of 2 curves, {rule}"
    [line] = csv.DictReader(asked(place, question, rule, "--csv")[1].splitlines())
    assert str(answer) == line["value"]
    assert str(answer) in asked(place, question, rule)[1]


def test_moments_of_a_region_by_the_command(drawing):
    rows = csv.DictReader(asked(f"{drawing}:framed", "moments:1", "nonzero", "--csv")[1].splitlines())
    # 16 and the parabola's 8/3 about x = 12, without the square about x = 23/2
    assert [row["value"] for row in rows][2] == str(12 * (16 + mpq(8, 3)) - mpq(23, 2))


def test_several_files_are_one_region(tmp_path):
    for name, size in (("outer", 4), ("inner", 1)):
        corners = [[0, 0], [size, 0], [size, size], [0, size], [0, 0]]
        moved = [[x + (name == "inner"), y + (name == "inner")] for x, y in corners]
        curve = {"name": name, "degree": 1, "knots": [0, 0, 1, 2, 3, 4, 4], "control_points": moved}
        (tmp_path / f"{name}.json").write_text(json.dumps(curve))
    files = [str(tmp_path / f"{name}.json") for name in ("outer", "inner")]
    found = [
        json.loads(run("inspect", *files, "--ask", "area", "--region", rule, "--json").stdout)
        for rule in ("even-odd", "nonzero")
    ]
    assert [x["rows"][0]["answer"]["exact"] for x in found] == ["15", "16"]


def test_one_layer_is_one_part(tmp_path):
    path = dxf(tmp_path)
    for layer, area in (("A", "1/2"), ("B", "1")):
        assert (
            json.loads(asked(f"{path}:{layer}", "area", "nonzero", "--json")[1])["rows"][0]["answer"]["exact"] == area
        )
    assert json.loads(asked(path, "area", "nonzero", "--json")[1])["rows"][0]["answer"]["exact"] == "3/2"
    status, _, told = asked(f"{path}:C", "area", "nonzero")
    assert status == 2
    assert "there is no part 'C'; the nearest are A, B" in told


@pytest.mark.parametrize(("part", "names"), [
    ("framed", ["framed.1", "framed.2"]),
    ("both", ["framed.1", "framed.2", "round"]),
    ("other", ["other"]),
    ("copy", ["framed.1", "framed.2"]),
])  # fmt: skip
def test_parts_of_a_drawing_are_its_elements_where_they_are_drawn(drawing, part, names):
    whole, found = read(drawing), read(f"{drawing}:{part}")
    assert [each.name for each in found.curves] == names
    assert not found.skipped
    assert whole.skipped
    assert all(any(each.curve == other.curve for other in whole.curves) for each in found.curves)


def test_what_has_no_such_part_says_so(drawing, tmp_path):
    with pytest.raises(CurveFileError, match=r"no part 'fram'; the nearest are framed, round, other"):
        read(f"{drawing}:fram")
    place = tmp_path / "line.json"
    place.write_text('{"degree": 1, "knots": [0, 0, 1, 1], "control_points": [[0, 0], [1, 1]]}')
    with pytest.raises(CurveFileError, match="parts are glyphs of fonts, ids of SVG, layers of DXF"):
        read(f"{place}:a")


@pytest.mark.parametrize(("command", "told"), [
    ("inspect circle --region nonzero", "--region without --ask; add --ask area"),
    ("inspect circle --ask area --region even", "there are nonzero, even-odd"),
    ("inspect circle --ask inflections --region nonzero", "inflections of a region of several curves; it is asked of"),
    ("inspect circle --ask contains:1,1", "region of several curves (--region even-odd, in Python Region(curves))"),
    ("inspect torus --ask area --region nonzero", "--region and a surface"),
])  # fmt: skip
def test_what_does_not_fit_says_what_would(command, told):
    done = run(*shlex.split(command))
    assert done.returncode == 2
    assert told in " ".join(f"{done.stdout} {done.stderr}".split())


def test_contours_that_have_no_area_are_named(drawing):
    status, shown, _ = asked(drawing, "area", "nonzero")
    assert status == 0
    assert "133/3 + π" in shown
    drawing.write_text(SVG.replace('<circle id="round" r="1" cx="20"/>', '<path id="q" d="M3 3L9 3L9 9"/>'))
    status, shown, _ = asked(drawing, "area", "nonzero")
    assert status == 2
    assert "q: the area of a curve that is not closed and in the plane" in " ".join(shown.split())
    drawing.write_text(SVG.replace('<circle id="round" r="1" cx="20"/>', '<path id="q" d="M3 3L9 3L9 9Z"/>'))
    shown = " ".join(asked(f"{drawing}:both", "area", "nonzero")[1].split())
    assert "framed.1 and q: contours that meet each other; remove overlaps first" in shown
