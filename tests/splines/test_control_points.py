"""Points of weight 0 and directions: what they add to a curve, how they are written and read back; pieces in files."""

import json

import pytest
from gmpy2 import mpq

from exactspline import Direction, Nurbs, read, write
from exactspline.errors import CurveFileError, NumberError, ShapeError, WeightError
from exactspline.interchange import text

KNOTS = [0, 0, 0, 1, 1, 1]
POINTS = [(0, 0), (5, 7), (1, 0)]
PLACES = [mpq(k, 7) for k in range(8)]


def by_definition(weights, t):
    """Σ wᵢ Pᵢ Nᵢ / Σ wᵢ Nᵢ for the quadratic Bézier basis."""
    basis = [(1 - t) ** 2, 2 * t * (1 - t), t**2]
    w = sum(mpq(x) * b for x, b in zip(weights, basis, strict=True))
    rows = zip(*POINTS, strict=True)
    return tuple(sum(mpq(x) * c * b for x, c, b in zip(weights, row, basis, strict=True)) / w for row in rows)


@pytest.mark.parametrize("weights", [(1, 0, 1), (2, 0, 2), (1, "1e-30", 1), (1, "-1e-30", 1), (0, 0, 0, 1)], ids=str)
def test_a_point_is_weighed_as_the_definition_says(weights):
    if len(weights) == 4:
        with pytest.raises(WeightError):
            Nurbs(3, [0] * 4 + [1] * 4, [*POINTS, (9, 9)], weights)
        return
    curve = Nurbs(2, KNOTS, POINTS, weights)
    for t in PLACES:
        assert curve(t) == by_definition(weights, t)


def test_weight_0_is_the_limit_of_small_weights():
    without = Nurbs(2, KNOTS, POINTS, [1, 0, 1])
    assert without == Nurbs(2, KNOTS, POINTS, [2, 0, 2])
    assert without == Nurbs(2, KNOTS, [(0, 0), (-3, 11), (1, 0)], [1, 0, 1]), "where the point is does not matter"
    assert without("1/2") == (mpq(1, 2), 0)
    for exponent in (3, 30, 300):
        small = Nurbs(2, KNOTS, POINTS, [1, mpq(1, 10**exponent), 1])
        assert small != without
        assert all(
            abs(x - y) <= mpq(30, 10**exponent) for t in PLACES for x, y in zip(small(t), without(t), strict=True)
        )


def test_a_direction_is_the_limit_of_far_points_of_small_weights():
    half_circle = Nurbs(2, KNOTS, [(1, 0), Direction(0, 1), (-1, 0)])
    assert half_circle.weights == (1, 0, 1)
    assert half_circle == Nurbs.from_homogeneous(2, KNOTS, [(1, 0, 1), (0, 1, 0), (-1, 0, 1)])
    assert half_circle == Nurbs(2, KNOTS, [(1, 0), Direction(0, 1), (-1, 0)], [1, 0, 1])
    assert half_circle != Nurbs(2, KNOTS, [(1, 0), (0, 1), (-1, 0)], [1, 0, 1])
    for t in PLACES:
        x, y = half_circle(t)
        assert x * x + y * y == 1
        assert y >= 0
    small = mpq(1, 10**40)
    near = Nurbs(2, KNOTS, [(1, 0), (0, 1 / small), (-1, 0)], [1, small, 1])
    assert all(abs(x - y) <= 10 * small for t in PLACES for x, y in zip(near(t), half_circle(t), strict=True))


def test_a_direction_is_no_point():
    assert Direction(0, 1) != (0, 1)
    assert Direction(0, 1) != (0, 1)
    assert Direction(0, "1/2") == Direction(0, mpq(1, 2))
    assert hash(Direction(0, "1/2")) == hash(Direction(0, mpq(1, 2)))
    assert repr(Direction(0, "1/2")) == "Direction(0, 1/2)"
    with pytest.raises(NumberError):
        Direction(0, 0.5)


def test_a_direction_has_the_weight_0_and_no_other():
    with pytest.raises(ShapeError, match="weight 1 of a direction") as caught:
        Nurbs(2, KNOTS, [(1, 0), Direction(0, 1), (-1, 0)], [1, 1, 1])
    assert caught.value.where == "weights[1]"
    with pytest.raises(ShapeError, match="3 coordinates"):
        Nurbs(2, KNOTS, [(1, 0), Direction(0, 1, 0), (-1, 0)])
    with pytest.raises(WeightError):
        Nurbs(1, [0, 0, 1, 1], [Direction(0, 1), Direction(1, 1)])


CURVES = {
    "a direction": Nurbs(2, KNOTS, [(1, 0), Direction(0, 1), (-1, 0)], name="half", note="a note"),
    "a point of weight 0": Nurbs(2, KNOTS, POINTS, [1, 0, 1], name="chord"),
    "nothing at all": Nurbs.from_homogeneous(2, KNOTS, [(1, 0, 1), (0, 0, 0), (-1, 0, 1)], name="nothing"),
    "polynomial": Nurbs(2, KNOTS, POINTS, [3, 3, 3], name="parabola", source="here"),
    "rational": Nurbs(2, KNOTS, POINTS, [1, "1/3", 2], name="arc"),
}


@pytest.mark.parametrize("name", CURVES)
def test_a_curve_is_read_back_as_it_was_written(name, tmp_path):
    curve = CURVES[name]
    write(curve, tmp_path / "curve.json")
    back = read(str(tmp_path / "curve.json")).curve
    assert back == curve
    assert (back.knots, back.control_points, back.name) == (curve.knots, curve.control_points, curve.name)
    assert (back.source, back.note) == (curve.source, curve.note)
    assert [type(p) for p in back.control_points] == [type(p) for p in curve.control_points]


def test_the_notation_of_a_direction_in_a_file():
    data = json.loads(text(CURVES["a direction"]))
    assert data["control_points"] == [["1", "0"], {"vector": ["0", "1"]}, ["-1", "0"]]
    assert data["weights"] == ["1", "0", "1"]
    assert read(json.dumps(data | {"weights": None}).encode()).curve == CURVES["a direction"]


@pytest.mark.parametrize(
    ("point", "kind", "where"),
    [
        ({"vector": 3}, CurveFileError, "control_points[1]"),
        ({"direction": [0, 1]}, CurveFileError, "control_points[1]"),
        ({"vector": [0, 1], "weight": 2}, CurveFileError, "control_points[1]"),
        ({"vector": [0, "x"]}, NumberError, "control_points[1].vector[1]"),
        ({"vector": [0]}, ShapeError, "control_points[1]"),
    ],
)
def test_a_direction_that_is_none_is_named(point, kind, where):
    data = {"degree": 2, "knots": KNOTS, "control_points": [[1, 0], point, [-1, 0]]}
    with pytest.raises(kind) as caught:
        read(json.dumps(data).encode())
    assert caught.value.where == where


# ---- pieces

PIECE = {
    "kind": "rational",
    "degree": 2,
    "knots": ["0", "0", "0", "1", "1", "1"],
    "homogeneous_control_points": [["1", "0", "1"], ["0", "1", "0"], ["-1", "0", "1"]],
}
WHOLE = CURVES["a direction"]


def end(t):
    return {"exact": t, "low": t, "high": t}


@pytest.mark.parametrize(
    ("said", "part"),
    [
        ({}, WHOLE),
        ({"interval": ["0", "1"]}, WHOLE),
        ({"interval": ["1/4", "1/2"]}, WHOLE.restrict("1/4", "1/2")),
        ({"interval": ["0", "1"], "low": end("1/3"), "high": end("1/2")}, WHOLE.restrict("1/3", "1/2")),
        ({"interval": ["0", "1"], "high": end("0.75")}, WHOLE.restrict(0, "3/4")),
    ],
)
def test_a_piece_is_read_over_the_part_of_the_domain_that_it_has(said, part):
    alone = read(json.dumps(PIECE | said).encode()).curve
    inside = read(json.dumps({"kind": "trimmed bisector", "pieces": [PIECE | said], "missing": []}).encode()).curve
    assert alone == inside == part
    assert alone.domain == part.domain


def test_a_piece_that_ends_at_an_irrational_parameter_is_refused():
    cut = {"exact": None, "low": "7/10", "high": "71/100"}
    with pytest.raises(CurveFileError, match="irrational parameter") as caught:
        read(json.dumps(PIECE | {"interval": ["0", "1"], "high": cut}).encode())
    assert caught.value.where == "high"
    assert caught.value.remedy


def test_a_piece_may_lead_to_infinity_outside_its_part():
    """A weight function with a zero at the end of the knots, of which the piece keeps clear."""
    piece = PIECE | {"homogeneous_control_points": [["1", "0", "0"], ["0", "1", "1"], ["-1", "0", "1"]]}
    with pytest.raises(WeightError):
        read(json.dumps(piece).encode())
    assert read(json.dumps(piece | {"interval": ["1/2", "1"]}).encode()).curve.domain == (mpq(1, 2), 1)


@pytest.mark.parametrize("change", [{"kind": "function"}, {"knots": None}, {"interval": "01"}, {"degree": 2.5}])
def test_a_broken_piece_is_refused(change):
    with pytest.raises(ValueError, match=r"."):
        read(json.dumps(PIECE | change).encode())
