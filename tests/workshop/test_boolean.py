"""The judge of Boolean results: right ones, wrong ones with witnesses, and engines that are installed."""

import json
import random
import re
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path

import pytest
from gmpy2 import mpq

from exactspline import read, winding_number
from exactspline.errors import CurveFileError, ShapeError
from exactspline.geometry.pairs.winding import FillRule
from workshop.boolean.__main__ import main
from workshop.boolean.angles import confirms, suspects
from workshop.boolean.grading import ENGINES, Outcome, graded, started
from workshop.boolean.judge import Operation, judged, judged_at
from workshop.boolean.pairs import Pair, pairs
from workshop.boolean.pieces import Region, is_far
from workshop.boolean.shrink import shrunk, smaller

A, B = "M0 0H2V2H0Z", "M1 1H3V3H1Z"
RIGHT = {
    "union": "M0 0H2V1H3V3H1V2H0Z",
    "intersection": "M1 1H2V2H1Z",
    "difference": "M0 0H2V1H1V2H0Z",
    "xor": "M0 0H2V1H1V2H0ZM2 1H3V3H1V2H2Z",
}
WITHIN = mpq(1, 16)


def judgement(operation, result, rule=FillRule.NONZERO, first=A, second=B, within=WITHIN):
    return judged(Region.of(first), Region.of(second), Operation(operation), Region.of(result, rule), within)


@pytest.mark.parametrize("operation", RIGHT)
@pytest.mark.parametrize("result", RIGHT)
def test_only_the_right_result_is_right(operation, result):
    found = judgement(operation, RIGHT[result])
    assert found.right is (operation == result)
    if not found.right:
        x, y = found.witness
        inside = [0 < x < 2 and 0 < y < 2, 1 < x < 3 and 1 < y < 3]
        assert found.inside == Operation(operation).holds(*inside)
        assert is_far([*Region.of(A).pieces, *Region.of(B).pieces], found.witness, WITHIN)


def test_the_tube_and_the_fill_rule():
    """A side that is moved by less than ε is right, one that is moved by more wrong; both paths together are the
    exclusive or by one rule alone.
    """
    near, far = "M0 0H1.95V1H3V3H1V2H0Z", "M0 0H1.9V1H3V3H1V2H0Z"
    assert judgement("union", near).right
    found = judgement("union", far)
    assert not found.right
    assert mpq("1.9") < found.witness[0] < 2 - WITHIN
    assert judgement("xor", A + B, FillRule.EVEN_ODD).right
    assert judgement("xor", A + B).witness is not None
    # lines and curves to and fro through the middle change nothing; it was looked at their two sides without end
    assert judgement("union", "M0 0H2V1H3V3H1V2H0ZM0 1.5H.8H.2L-1 1.5ZM.5 .5Q1 2 1.5 1Q1 2 .5 .5").right
    # one that is not run through back bounds something
    assert judgement("union", "M0 0H2V1H3V3H1V2H0ZM4 4H5H4V5H5Z").right is False
    with pytest.raises(ShapeError, match="above 0"):
        judgement("union", A, within=mpq(0))
    with pytest.raises(ShapeError, match="arc"):
        Region.of("M0 0A1 1 0 0 1 2 0Z")
    with pytest.raises(CurveFileError, match="not path data"):
        Region.of("M0 0#")


def test_winding_numbers_are_those_of_the_library():
    chance = random.Random("winding")
    for pair in pairs(12, seed=4):
        region = Region.of(pair.second)
        [curve] = [each.curve for each in read(f'<svg><path d="{pair.second}"/></svg>'.encode()).curves]
        for _ in range(20):
            point = (mpq(chance.randint(0, 160), 16) + mpq(1, 77), mpq(chance.randint(0, 160), 16) + mpq(1, 99))
            assert region.winding(point) == winding_number(curve, point)
        # on the height of a corner
        corner = region.pieces[0].points[0]
        point = (corner[0] - mpq(1, 7), corner[1])
        assert region.winding(point) == winding_number(curve, point)


def test_results_of_pairs_with_a_dial():
    """The paths themselves: of the union either is right within more than the dial, of the exclusive or none is."""
    for pair in pairs(6, seed=2):
        first, second = Region.of(pair.first), Region.of(pair.second)
        assert judged(first, second, Operation.UNION, second, WITHIN + mpq(1, 64)).right
        assert judged(first, second, Operation.XOR, Region(()), WITHIN + mpq(1, 64)).right
        wrong = judged(first, second, Operation.XOR, first, WITHIN)
        if wrong.right is False:
            assert confirms(wrong, first, second, Operation.XOR, first)


def test_the_command(capsys, tmp_path):
    assert main(["judge", A, "union", B, RIGHT["union"]]) == 0
    assert "right further than 1/16" in capsys.readouterr().out
    assert main(["judge", A, "union", B, A]) == 1
    assert "should be inside" in capsys.readouterr().out
    with pytest.raises(CurveFileError, match="no engine called"):
        main(["grade", "skia"])


class Last:
    """An engine whose results are the second path, wrong but for what the dial hides; an exclusive or it does not
    offer, and what has a control point (9, 9) it refuses.
    """

    library = "last"

    def exchange(self, request):
        if request["operation"] == "xor":
            return {"declined": "no"}
        if " 9 9 " in request["first"]:
            return {"raised": "ValueError: nine"}
        return {"path": request["second"], "rule": "nonzero"}


def test_a_failure_is_shrunk_to_a_smaller_pair_with_the_same_failure():
    """A difference that is the second path; whatever is left cannot be left out or made smaller."""
    pair = Pair(((2, 1), (3, 9), (8, 7), (9, 2), (5, 0), (4, 3)), 12)
    assert [each.operation for each in graded(Last(), [pair], Operation, WITHIN)] == [*Operation][:3]
    [found] = graded(Last(), [pair], [Operation.DIFFERENCE], WITHIN)
    assert found.outcome is Outcome.WRONG
    assert found.confirmed
    least = shrunk(Last(), found, WITHIN)
    assert least.outcome is Outcome.WRONG
    assert len(least.pair.points) == 3
    for each in smaller(least.pair):
        tried = next(graded(Last(), [each], [Operation.DIFFERENCE], WITHIN, whole=False))
        assert tried.outcome is not Outcome.WRONG
    nine = replace(pair, points=(*pair.points[:4], (9, 9), (4, 3)))
    [raised] = graded(Last(), [nine], [Operation.UNION], WITHIN)
    assert "9 9" in shrunk(Last(), raised, WITHIN).pair.first


def test_a_suspected_point_is_judged_exactly():
    """The sums of angles only propose: what they take for wrong, near a path or on the result, is not a witness."""
    a, b, result = map(Region.of, (A, B, A))
    points = suspects(a, b, Operation.UNION, result, float(WITHIN))
    assert all(2 < z.real < 3 or 2 < z.imag < 3 for z in points)
    assert judged_at((mpq(5, 2), mpq(5, 2)), a, b, Operation.UNION, result, WITHIN).inside
    for point in ((mpq(1, 2), mpq(1, 2)), (mpq(5, 2), 3 - WITHIN), (mpq(9), mpq(9))):
        assert judged_at(point, a, b, Operation.UNION, result, WITHIN) is None
    on_it = Region.of("M0 0H2.5V2H0Z")
    assert judged_at((mpq(5, 2), mpq(3, 2)), a, b, Operation.UNION, on_it, WITHIN) is None


PAGE = Path(__file__).parents[2] / "docs" / "measurements.md"
ROW = re.compile(
    r"\| (?P<engine>[\w-]+) (?P<version>[\w.]+) \| (?P<operation>\w+) \| `(?P<path>M[^`]*)` \| "
    r"2⁻(?P<k>[⁰¹²³⁴-⁹]+) in (?P<axis>[xy]) \| \((?P<x>[\d/]+), (?P<y>[\d/]+)\) (?P<should>inside|outside) \|"
)
#: The lines of the page with a witness.
WITNESSES = [row.groupdict() for row in map(ROW.match, PAGE.read_text(encoding="utf-8").splitlines()) if row]


@pytest.mark.parametrize("row", WITNESSES, ids=lambda row: f"{row['engine']}-{row['operation']}-{row['path']}")
def test_a_witness_of_the_page(row):
    """It is far from both paths and inside or outside as the page says; an engine of that version is wrong there."""
    numbers = [int(x) for x in re.findall(r"\d+", row["path"])]
    exponent = int("".join(str("⁰¹²³⁴⁵⁶⁷⁸⁹".index(c)) for c in row["k"]))
    pair = Pair(tuple(zip(numbers[:-2:2], numbers[1:-2:2], strict=True)), exponent, row["axis"] == "y")
    assert pair.first == row["path"]
    first, second, operation = Region.of(pair.first), Region.of(pair.second), Operation(row["operation"])
    point, nothing, whole = (mpq(row["x"]), mpq(row["y"])), Region(()), Region.of("M-99 -99H99V99H-99Z")
    wrong, right = (nothing, whole) if row["should"] == "inside" else (whole, nothing)
    assert judged_at(point, first, second, operation, wrong, WITHIN)
    assert judged_at(point, first, second, operation, right, WITHIN) is None
    try:
        worker = started(row["engine"])
    except ImportError:
        return
    try:
        if worker.version == row["version"]:
            reply = worker.exchange({"first": pair.first, "second": pair.second, "operation": operation.value})
            result = Region.of(reply["path"], FillRule(reply["rule"]))
            assert judged_at(point, first, second, operation, result, WITHIN)
    finally:
        worker.close()


@pytest.mark.parametrize("name", ENGINES)
def test_an_engine_that_is_installed_makes_a_union(name):
    """Two discs. ``layer.exclude`` of FontForge 20230101 says that it takes the argument from the layer, and takes the
    layer from the argument.
    """
    try:
        worker = started(name)
    except ImportError:
        pytest.skip(f"{name} is not installed")
    try:
        pair = Pair(((0, 4), (0, 8), (8, 8), (8, 4), (8, 0), (0, 0)), 1)
        outcomes = [each.outcome for each in graded(worker, [pair], [Operation.UNION, Operation.DIFFERENCE], WITHIN)]
    finally:
        worker.close()
    assert outcomes == [Outcome.RIGHT, Outcome.WRONG if name == "FontForge" else Outcome.RIGHT]
    assert worker.version


@pytest.mark.skipif(find_spec("pathops") is None, reason="needs skia-pathops")
def test_an_engine_is_graded(capsys, tmp_path):
    """Also the exclusive or of which skia-pathops 0.9.2 says what it is not."""
    assert main(["grade", "skia-pathops", "--count", "3", "--json", "--failures", str(tmp_path / "f.jsonl")]) == 0
    rows = json.loads(capsys.readouterr().out)["rows"]
    assert [row["asked"] for row in rows] == [3] * 4
