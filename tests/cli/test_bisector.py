"""The command `bisector` as a user meets it."""

import json
from types import SimpleNamespace

import pytest
from gmpy2 import mpq

from exactspline import Nurbs, bisector, example, read, write
from exactspline.display import bisector_data
from exactspline.geometry.bisectors.two_curves import curve_bisector
from exactspline.numbers.intervals import Interval
from tests.support.bisector_oracle import FAMILIES
from tests.support.command import invoke, run
from tests.support.sampled import sample


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
    assert run("bisector", "ellipse_in_space", "--point", "1,1,2", "-q").stdout.count("ruled surface") == 3


def test_a_point_and_a_plane_curve_is_trimmed():
    done = run("bisector", "ellipse", "--point", "-1,1/3", "--digits", "8", "-q")
    assert done.returncode == 0
    assert done.stdout.count("arc") == 2
    data = json.loads(run("bisector", "parabola", "--point", "0,1", "--json").stdout)["rows"][0]
    assert [piece["piece"] for piece in data["pieces"]] == ["arc", "end point", "end point"]
    low = data["pieces"][1]["high"]
    assert mpq(low["low"]) <= mpq(-1, 5) <= mpq(low["high"])


def test_two_plane_curves():
    """They were refused, with the advice to write Python."""
    row = json.loads(run("bisector", "parabola", "straight_line", "--json").stdout)["rows"][0]
    found = bisector(example("parabola"), example("straight_line"))
    assert [piece["piece"] for piece in row["pieces"]] == ["correspondence of parameters"] * len(found.pieces)
    for piece, arc in zip(row["pieces"], found.pieces, strict=True):
        for end, place in (("start", arc.start), ("end", arc.end)):
            for told, number in zip(piece[end], place, strict=True):
                low, high = mpq(told["low"]), mpq(told["high"])
                assert low <= number <= high
    assert row["complete"]
    assert row["true_feet"] == [[[str(x) for x in side] for side in box] for box in found.trimmed.kept]
    shown = shown_at(80, "straight_line", "straight_line")
    assert "rectangle of pairs  s in [0, 1], t in [0, 1]" in shown
    assert max(map(len, shown.splitlines())) <= 80


def test_pairs_of_plane_curves_are_shown_by_their_kind(monkeypatch):
    """An arc that ends in an undecided box was shown like one that ends at its start."""
    pair, one, kinds = (mpq(0), mpq(1, 3)), mpq(1, 2), bisector_data.PairsKind
    told = [
        bisector_data.Pairs(kinds("correspondence of parameters"), None, pair),
        bisector_data.Pairs(kinds("closed correspondence of parameters")),
        bisector_data.Pairs(kinds("pair"), pair, pair),
        bisector_data.Pairs(kinds("line of pairs"), sides=((one, one), pair)),
    ]
    monkeypatch.setattr(bisector_data, "pairs_of", lambda bisector: told)
    boxes = SimpleNamespace(kept=(), undecided=())
    box = (Interval(mpq(0), mpq(1, 2)), Interval(mpq(0), mpq(1)))
    rows, notes = bisector_data.of_plane_curves(SimpleNamespace(trimmed=boxes, missing=[box]), 12)
    assert [row.where for row in rows] == [
        "an undecided box to s = 0, t = 1/3",
        "",
        "s = 0, t = 1/3",
        "s = 1/2, t in [0, 1/3]",
    ]
    assert notes[1] == "undecided: [0, 1/2] × [0, 1]"


@pytest.mark.parametrize(
    "arguments",
    [
        ("circle",),
        ("circle", "twisted_cubic"),
        ("circle", "parabola", "--variant", "naive"),
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
    curve = read(
        json.dumps(
            {
                "degree": directrix["degree"],
                "knots": directrix["knots"],
                "control_points": [[str(x / row[3]) for x in row[:3]] for row in points],
                "weights": [str(row[3]) for row in points],
            }
        ).encode()
    ).curve
    assert curve("1/2")[2] == 0


# ---- two curves: everything beside the surface


def files(folder, name):
    paths = []
    for i, curve in enumerate(FAMILIES[name]):
        paths.append(folder / f"curve_{i}.json")
        write(curve, paths[-1])
    return paths


def shown_at(width, *arguments):
    done = invoke("bisector", "-q", *map(str, arguments), env={"COLUMNS": str(width)})
    assert done.exit_code == 0
    return done.stdout


def words(text):
    return " ".join(text.split())


def test_coaxial_circles_at_80_columns(tmp_path):
    shown = shown_at(80, *files(tmp_path, "coaxial circles of one radius"))
    assert max(map(len, shown.splitlines())) <= 80
    assert "one point: (0, 0, 1/2)" in words(shown)
    assert "s - t = 0: s in" in shown
    assert "s - t = 0: s in [0, 1]; s in [1, 2]" in shown_at(200, *files(tmp_path, "coaxial circles of one radius"))
    assert shown.endswith("complete: nothing is undecided\n")


@pytest.mark.parametrize("name", [x for x in sample(list(FAMILIES), 12) if x != "a circle and itself"])  # 10 s
def test_the_table_at_80_columns_loses_nothing(name, tmp_path):
    paths = files(tmp_path, name)
    wide, shown = shown_at(300, *paths), shown_at(80, *paths)
    assert max(map(len, shown.splitlines())) <= 80
    assert sorted("".join(wide.split())) == sorted("".join(shown.split()))


def test_json_has_all_components(tmp_path):
    data = json.loads(run("bisector", *files(tmp_path, "a cusp and a curve through it"), "--json").stdout)["rows"][0]
    assert data["complete"]
    assert data["undecided"] == []
    (line,) = [x for x in data["lines"] if x["cause"] == "the first curve has no tangent"]
    assert line["equation"]["text"] == "s = 0"
    assert line["pieces"][0]["parameter"] == "t"
    (plane,) = [x for x in data["pairs"] if x["solutions"] == "plane"]
    assert plane["s"]["exact"] == "0"
    # the normal plane of the second curve where it runs through the cusp
    t, second = mpq(plane["t"]["exact"]), FAMILIES["a cusp and a curve through it"][1]
    assert second(t) == tuple(mpq(x) for x in plane["point"])


def test_lines_in_json_are_the_lines(tmp_path):
    """Directrix and generator of the plane between two circles, from their control points."""
    data = json.loads(run("bisector", *files(tmp_path, "coaxial circles of one radius"), "--json").stdout)["rows"][0]
    pieces = [piece for line in data["lines"] if line["equation"]["text"] == "s - t = 0" for piece in line["pieces"]]
    assert len(pieces) == 2
    for piece in pieces:
        assert all(mpq(z) * 2 == mpq(w) for *_, z, w in piece["directrix"]["homogeneous_control_points"])
        assert all(mpq(z) == 0 for *_, z in piece["generator"]["control_points"])


def test_irrational_pairs_have_their_polynomials():
    data = json.loads(run("bisector", "rational_space_cubic", "twisted_cubic", "--json").stdout)["rows"][0]
    (irrational, *_) = [pair["s"] for pair in data["pairs"] if "polynomial" in pair["s"]]
    p, (low, high) = list(map(mpq, irrational["polynomial"])), map(mpq, (irrational["low"], irrational["high"]))
    values = [sum(c * t**k for k, c in enumerate(p)) for t in (low, high)]
    assert values[0] * values[1] < 0


# ---- what is written is read back as what it is


def test_an_arc_is_written_trimmed(tmp_path):
    """A line so long that only a part of its parabola is kept; its ends are rational."""
    line, file = tmp_path / "line.json", tmp_path / "arc.json"
    write(Nurbs(1, [0, 0, 1, 1], [(-4, 0), (4, 0)]), line)
    data = json.loads(run("bisector", line, "--point", "0,2", "--json").stdout)["rows"][0]
    for piece in data["pieces"]:
        low, high = mpq(piece["low"]["exact"]), mpq(piece["high"]["exact"])
        assert [mpq(piece["knots"][0]), mpq(piece["knots"][-1])] == [low, high]
        assert [mpq(x) for x in piece["interval"]] == [low, high]
        assert "cut" not in piece
    file.write_text(json.dumps(data | {"pieces": [data["pieces"][0]]}))
    arc = read(file).curve
    assert arc.domain == (0, 1)
    assert all(x * x + 4 == 4 * y for x, y in (arc(mpq(k, 5)) for k in range(6)))


def test_an_arc_with_an_irrational_end_is_refused_by_the_reader(tmp_path):
    file = tmp_path / "arc.json"
    data = json.loads(run("bisector", "circle", "--point", "3,0", "--json").stdout)["rows"][0]
    piece = next(x for x in data["pieces"] if x["piece"] == "arc")
    assert piece["cut"]
    irrational = [end["polynomial"] for end in (piece["low"], piece["high"]) if "polynomial" in end]
    assert irrational
    assert set(map(tuple, irrational)) <= {("-1", "0", "2"), ("31", "-16", "2")}
    file.write_text(json.dumps(data | {"pieces": [piece]}))
    done = run("inspect", file)
    assert done.returncode == 2
    assert "irrational parameter" in done.stderr


# ---- pictures


@pytest.mark.parametrize(
    "arguments",
    [("planar_in_space", "planar_in_space"), ("ellipse", "--point", "-1,1/3"), ("parabola", "straight_line")],
)
def test_a_picture_is_written(arguments, tmp_path):
    file = tmp_path / "picture.svg"
    done = run("bisector", *arguments, "--plot", file)
    assert (done.returncode, done.stdout) == (0, "")
    assert done.stderr == f"written: {file}\n"
    assert file.read_text().rstrip().endswith("</svg>")


def test_a_picture_of_another_kind_is_refused(tmp_path):
    done = run("bisector", "circle", "--point", "3,0", "--plot", tmp_path / "picture.gif")
    assert done.returncode == 2
    assert "neither SVG nor PNG nor PDF" in done.stderr
