"""What is refused where a spline, a curve or a surface's function is made: the error names the place."""

import pytest

from exactspline import BSpline, Nurbs, TensorSpline
from exactspline.errors import KnotError, NumberError, ShapeError

GOOD = (2, [0, 0, 0, 1, 1, 1], [0, 1, 2])
SPLINES = {
    "decreasing knots": ((2, [0, 0, 0, 1, "1/2", 1], GOOD[2]), KnotError, "knots[4]"),
    "multiplicity above degree + 1": ((1, [0, 0, 1, 1, 1, 2, 2], [0] * 5), KnotError, "knots[2]"),
    "multiplicity above degree + 1 at the end": ((1, [0, 0, 0, 1, 1], [0] * 3), KnotError, "knots[0]"),
    "empty domain": ((1, [0, 1, 1, 2], [0, 0]), KnotError, "knots"),
    "too few knots": ((2, [0, 0, 1, 1], [0]), KnotError, "knots"),
    "no knots": ((0, [], []), KnotError, "knots"),
    "too few points": ((*GOOD[:2], [0, 1]), ShapeError, "control_points"),
    "too many points": ((*GOOD[:2], [0, 1, 2, 3]), ShapeError, "control_points"),
    "a float knot": ((2, [0, 0, 0.0, 1, 1, 1], GOOD[2]), NumberError, "knots[2]"),
    "a float point": ((*GOOD[:2], [0, 1, 2.5]), NumberError, "control_points[2]"),
    "a point that is none": ((*GOOD[:2], [0, None, 2]), NumberError, "control_points[1]"),
    "negative degree": ((-1, *GOOD[1:]), ShapeError, "degree"),
    "float degree": ((2.0, *GOOD[1:]), ShapeError, "degree"),
    "true degree": ((True, [0, 0, 1, 1], [0, 1]), ShapeError, "degree"),
    "huge degree": ((10**6, *GOOD[1:]), ShapeError, "degree"),
    "degree too long to print": ((10**5000, *GOOD[1:]), ShapeError, "degree"),
}

KNOTS, POINTS = [0, 0, 0, 1, 1, 1], [(0, 0), (1, 1), (2, 0)]
CURVES = {
    "too few points": ((2, KNOTS, POINTS[:2]), ShapeError, "control_points"),
    "too many points": ((2, KNOTS, [*POINTS, (3, 3)]), ShapeError, "control_points"),
    "no points": ((2, KNOTS, []), ShapeError, "control_points"),
    "too few weights": ((2, KNOTS, POINTS, [1, 2]), ShapeError, "weights"),
    "too many weights": ((2, KNOTS, POINTS, [1, 2, 3, 4]), ShapeError, "weights"),
    "no weights": ((2, KNOTS, POINTS, []), ShapeError, "weights"),
    "mixed dimensions": ((2, KNOTS, [(0, 0), (1, 1), (2, 0, 0)]), ShapeError, "control_points[2]"),
    "one coordinate": ((2, KNOTS, [(0,), (1,), (2,)]), ShapeError, "control_points[0]"),
    "no coordinate": ((2, KNOTS, [(), (), ()]), ShapeError, "control_points[0]"),
    "a number for a point": ((2, KNOTS, [(0, 0), 1, (2, 0)]), ShapeError, "control_points[1]"),
    "a text for a point": ((2, KNOTS, [(0, 0), "11", (2, 0)]), ShapeError, "control_points[1]"),
    "decreasing knots": ((2, [0, 0, 0, 1, "1/2", 1], POINTS), KnotError, "knots[4]"),
    "multiplicity above degree + 1": ((1, [0, 0, 1, 1, 1, 2, 2], [(0, 0)] * 5), KnotError, "knots[2]"),
    "empty domain": ((1, [0, 1, 1, 2], [(0, 0), (1, 1)]), KnotError, "knots"),
    "too few knots": ((2, [0, 0, 1, 1], [(0, 0)]), KnotError, "knots"),
    "a float knot": ((2, [0, 0, 0, 1, 1, 1.0], POINTS), NumberError, "knots[5]"),
    "a float coordinate": ((2, KNOTS, [(0, 0), (1, 0.5), (2, 0)]), NumberError, "control_points[1][1]"),
    "a float weight": ((2, KNOTS, POINTS, [1, 1, 0.5]), NumberError, "weights[2]"),
    "no number": ((2, KNOTS, POINTS, [1, "1/0", 1]), NumberError, "weights[1]"),
    "negative degree": ((-1, KNOTS, POINTS), ShapeError, "degree"),
    "float degree": ((2.0, KNOTS, POINTS), ShapeError, "degree"),
    "huge degree": ((10**6, KNOTS, POINTS), ShapeError, "degree"),
}

NET = ((1, 2), [0, 0, 1, 1], [0, 0, 0, 1, 1, 1], [[0, 1, 2], [3, 4, 5]])
TENSORS = {
    "decreasing knots": ((*NET[:2], [0, 0, 0, 1, "1/2", 1], NET[3]), KnotError, "knots_t[4]"),
    "decreasing knots in s": ((NET[0], [0, 0, 1, "1/2"], *NET[2:]), KnotError, "knots_s[3]"),
    "multiplicity above degree + 1": (
        (NET[0], [0, 0, "1/2", "1/2", "1/2", 1, 1], NET[2], [[0, 1, 2]] * 5),
        KnotError,
        "knots_s[2]",
    ),
    "empty domain": ((NET[0], [0, 1, 1, 2], *NET[2:]), KnotError, "knots_s"),
    "too few knots": ((NET[0], [0, 1, 1], *NET[2:]), KnotError, "knots_s"),
    "no knots": ((*NET[:2], [], NET[3]), KnotError, "knots_t"),
    "a float knot": ((*NET[:2], [0, 0, 0.0, 1, 1, 1], NET[3]), NumberError, "knots_t[2]"),
    "a float knot in s": ((NET[0], [0.0, 0, 1, 1], *NET[2:]), NumberError, "knots_s[0]"),
    "no points": ((*NET[:3], []), ShapeError, "control_points"),
    "too few rows": ((*NET[:3], [[0, 1, 2]]), ShapeError, "control_points"),
    "too many rows": ((*NET[:3], [[0, 1, 2]] * 3), ShapeError, "control_points"),
    "a short row": ((*NET[:3], [[0, 1, 2], [3, 4]]), ShapeError, "control_points[1]"),
    "an empty row": ((*NET[:3], [[], []]), ShapeError, "control_points[0]"),
    "a row that is none": ((*NET[:3], [[0, 1, 2], 3]), ShapeError, "control_points[1]"),
    "a net that is none": ((*NET[:3], 3), ShapeError, "control_points"),
    "a float point": ((*NET[:3], [[0, 1, 2], [3, 4.5, 5]]), NumberError, "control_points[1][1]"),
    "a point that is none": ((*NET[:3], [[0, 1, None], [3, 4, 5]]), NumberError, "control_points[0][2]"),
    "a negative degree": (((1, -1), *NET[1:]), ShapeError, "degrees[1]"),
    "a float degree": (((1.0, 2), *NET[1:]), ShapeError, "degrees[0]"),
    "a huge degree": (((10**6, 2), *NET[1:]), ShapeError, "degrees[0]"),
    "one degree": ((3, *NET[1:]), ShapeError, "degrees"),
    "three degrees": (((1, 2, 3), *NET[1:]), ShapeError, "degrees"),
}

BAD = {BSpline: SPLINES, Nurbs: CURVES, TensorSpline: TENSORS}


@pytest.mark.parametrize(("make", "what"), [(make, what) for make, cases in BAD.items() for what in cases])
def test_bad_input_names_the_place(make, what):
    arguments, kind, where = BAD[make][what]
    with pytest.raises(kind) as caught:
        make(*arguments)
    assert caught.value.where == where
    assert caught.value.remedy
    assert "\n" not in str(caught.value)
