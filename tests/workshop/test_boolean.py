"""The judge of Boolean results: right ones, wrong ones with witnesses, and engines that are installed."""

import json
import random
from importlib.util import find_spec

import pytest
from gmpy2 import mpq

from exactspline.errors import CurveFileError, ShapeError
from exactspline.geometry.winding import FillRule, winding_number
from exactspline.interchange import read
from workshop.boolean.__main__ import main
from workshop.boolean.angles import confirms
from workshop.boolean.judge import Operation, judged
from workshop.boolean.pairs import pairs
from workshop.boolean.pieces import Region, is_far

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
    # a line to and fro through the middle changes nothing, but its two sides are looked at without end
    assert judgement("union", "M0 0H2V1H3V3H1V2H0ZM0 1.5H.8Z").right is not False
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


@pytest.mark.skipif(find_spec("pathops") is None, reason="needs skia-pathops")
def test_an_engine_is_graded(capsys, tmp_path):
    """Also the exclusive or of which skia-pathops 0.9.2 says what it is not."""
    assert main(["grade", "skia-pathops", "--count", "3", "--json", "--failures", str(tmp_path / "f.jsonl")]) == 0
    rows = json.loads(capsys.readouterr().out)["rows"]
    assert [row["asked"] for row in rows] == [3] * 4
