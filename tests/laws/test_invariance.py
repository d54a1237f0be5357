"""Whatever tells something of a curve tells the same of the same curve written differently: moved, turned round, with
idle knots, of a higher degree, with other weights, in another parameter, in two parts, from another seam.
"""

import pytest
from gmpy2 import mpq
from hypothesis import assume, given
from hypothesis import strategies as st

from exactspline import BSpline, Nurbs
from exactspline.errors import ExactSplineError
from exactspline.geometry.analysis.curves import analyse
from exactspline.geometry.bisectors.two_curves import curve_bisector
from exactspline.interchange.examples import example
from tests.support.same_curves import CHANGES, from_rows, homogeneous, mirrored
from tests.support.strategies import nurbs

PLANE = [
    "ellipse",
    "rational_cubic",
    "cubic_s",
    "cusp",
    "jump",
    "six_segment_cubic",
    "straight_between_arcs",
    "flat_point",
]
SPACE = ["rational_space_cubic", "twisted_cubic", "space_quartic", "planar_in_space", "rational_space_cubic_spline"]
OPPOSITE = {"maximum": "minimum", "minimum": "maximum"}
#: What turns the sign of the curvature of a plane curve.
TURNING = ("backwards", "mirrored")
SHAPES = CHANGES | {"mirrored": mirrored}
POINTS = ("singular_points", "inflections", "critical_points", "torsion_zeros")
PIECES = ("straight_pieces", "constant_pieces")


def told(curve):
    """The features by list: kinds with roots, and intervals."""
    found = analyse(curve)
    points = {
        name: [(f.kind, f.of_absolute, f.by_jump, f.root) for f in getattr(found, name)]
        for name in POINTS[: found.curve.dimension + 1]
    }
    return points, {name: list(getattr(found, name)) for name in PIECES} | {
        "planar": [i for i, _ in found.planar_pieces]
    }


def ends(root, image):
    return sorted(image(x) for x in root.refine(30))


def placed(features, curve, image=lambda t: t, *, flipped=False):
    """The features in the order of another parameter; at the seam of a closed curve they belong to its beginning."""
    a, b = curve.domain
    found = []
    for kind, *rest, root in features:
        place = ends(root, image)[0]
        seam = curve.closed and place == b
        found.append((a if seam else place, OPPOSITE.get(kind, kind) if flipped else kind, *rest))
    return sorted(found, key=lambda row: [str(x) if i else x for i, x in enumerate(row)])


def assert_same_features(found, expected):
    assert [rest for _, *rest in found] == [rest for _, *rest in expected]
    for (x, *_), (y, *_) in zip(found, expected, strict=True):
        assert abs(x - y) <= mpq(1, 10**25) * (1 + abs(y))


def assert_same(curve, other, image, *, flipped=False):
    (points, pieces), (others, other_pieces) = told(curve), told(other)
    for name, features in points.items():
        moved = placed(features, other, image, flipped=flipped and name == "critical_points")
        assert_same_features(moved, placed(others[name], other))
    for name, found in pieces.items():
        moved = [tuple(sorted((image(a), image(b)))) for piece in found for a, b in piece.parts]
        assert sorted(moved) == sorted(part for piece in other_pieces[name] for part in piece.parts), name


@pytest.mark.parametrize("change", SHAPES)
@pytest.mark.parametrize("name", [*PLANE, *SPACE])
def test_features_of_the_same_curve(name, change):
    curve = example(name)
    other, image = SHAPES[change](curve)
    assert_same(curve, other, image, flipped=change in TURNING and curve.dimension == 2)


@given(nurbs(low=1, high=4), st.sampled_from(sorted(SHAPES)))
def test_features_of_random_plane_curves(curve, change):
    assume(not curve.closed)
    other, image = SHAPES[change](curve)
    assert_same(curve, other, image, flipped=change in TURNING)


@pytest.mark.parametrize("name", ["rational_cubic", "cubic_s", "rational_space_cubic", "space_quartic"])
def test_features_of_two_parts_are_those_of_the_whole(name):
    """Split where nothing is."""
    curve = example(name)
    a, b = curve.domain
    middle = (4 * a + 5 * b) / 9
    columns = [BSpline(curve.degree, list(curve.knots), c).split(middle) for c in homogeneous(curve)]
    parts = [
        from_rows(curve.degree, list(half[0].knots), list(zip(*[c.control_points for c in half], strict=True)))
        for half in zip(*columns, strict=True)
    ]
    whole, halves = told(curve)[0], [told(part)[0] for part in parts]
    for feature in whole:
        joined = [f for half in halves for f in half[feature]]
        assert_same_features(placed(joined, curve), placed(whole[feature], curve))


def chain(points):
    """A closed chain of quadratic pieces, full multiplicity between them."""
    count = (len(points) - 1) // 2
    return Nurbs(2, [0, 0, *[t for t in range(count + 1) for _ in range(2)], count, count][1:-1], points)


ROUND = [(0, 0), (1, 0), (2, 0), (3, 1), (2, 2), (1, 2), (0, 2), (0, 1), (0, 0)]
WAVY = [(0, 0), (1, -1), (2, 0), (3, 1), (2, 2), (1, 3), (0, 2), (-1, 1), (0, 0)]


def rotated(points, by):
    """The same chain from the seam that many pieces later."""
    return [*points[2 * by : -1], *points[: 2 * by + 1]]


@pytest.mark.parametrize("by", [1, 2, 3])
@pytest.mark.parametrize("points", [WAVY], ids=["wavy"])
def test_the_seam_of_a_closed_curve_is_no_place_of_its_own(points, by):
    assert_rotated(points, by)


@pytest.mark.parametrize("by", [1, 2])
def test_pieces_of_a_closed_curve_from_every_seam(by):
    assert_rotated(ROUND, by)


def test_no_parameter_outside_the_domain_is_told():
    curve = chain(ROUND)
    a, b = curve.domain
    for pieces in told(curve)[1].values():
        assert all(a <= low <= high <= b for piece in pieces for low, high in piece.parts)


def assert_rotated(points, by):
    count = (len(points) - 1) // 2
    curve, other = chain(points), chain(rotated(points, by))

    def image(t):
        return (t - by) % count

    (features, pieces), (others, other_pieces) = told(curve), told(other)
    for name, found in features.items():
        assert_same_features(placed(found, other, image), placed(others[name], other))
    for name, found in pieces.items():
        own = sorted((image(piece.start), length(piece)) for piece in found)
        assert own == sorted((piece.start % count, length(piece)) for piece in other_pieces[name])


def length(piece):
    return sum(b - a for a, b in piece.parts)


def test_the_bisector_does_not_know_which_curve_is_the_first():
    first, second = example("rational_space_cubic"), example("space_quartic")
    surface, swapped = curve_bisector(first, second), curve_bisector(second, first)
    for s, t in ((mpq(1, 3), mpq(2, 7)), (mpq(5, 8), mpq(1, 2))):
        assert surface(s, t) == swapped(t, s)
    with pytest.raises(ExactSplineError):
        swapped(mpq(99), mpq(99))
