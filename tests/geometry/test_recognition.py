"""Lines, circles and conics that are recognized, exactly or within a proved distance."""

from pathlib import Path
from random import Random

import pytest
from gmpy2 import mpq

import exactspline as xs
from exactspline.errors import ShapeError
from exactspline.geometry.recognition.pieces import recognized, rounded_up, signs
from exactspline.geometry.recognition.shapes import Circle, Conic, Line, ShapeKind
from tests.campaigns import recognition as campaign

SHARED = Path(__file__).parents[3] / "shared" / "curves"


def test_arcs_that_are_exact_rounded_moved_and_none():
    """A bound without the gradient's condition, or one read off sample points, is refuted by distances of 50 digits."""
    found = campaign.campaign(40)
    assert not [what for what, count in found.items() if count and what.startswith("WRONG")]
    assert found["arcs moved by a tenth of epsilon"] == 40


def test_a_circle_that_runs_around_twice_is_two_pieces():
    """ "The curve runs over the arc once" was true of a circle run over twice."""
    knots = [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 6]
    exact = xs.Nurbs.from_homogeneous(2, knots, rows_of_turns(3))
    pieces = recognized(exact)
    assert [piece.shape.kind for piece in pieces] == [ShapeKind.CIRCLE] * len(pieces)
    assert len(pieces) >= 2
    assert pieces[0].exact


def rows_of_turns(halves):
    """Half circles one after the other, each as two arcs of degree 2: (1 − t², 2t, 1 + t²) on [−1, 0] and [0, 1]."""
    arc = [(0, -1, 1), (1, -1, 1), (1, 0, 1)], [(1, 0, 1), (1, 1, 1), (0, 2, 2)]
    rows = []
    for k in range(halves):
        turn = (-1) ** k
        for points in arc:
            scale = mpq(1) if not rows else rows[-1][2] / mpq(points[0][2])
            new = [tuple(scale * x for x in (turn * p[0], turn * p[1], p[2])) for p in points]
            rows += new if not rows else new[1:]
    return rows


def test_what_turns_back_or_has_a_gap_is_not_one_arc():
    back = xs.Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (2, 0), (-1, 0), (1, 0)])
    assert recognized(back) == ()
    gap = xs.Nurbs(1, [0, 0, 1, 1, 2, 2], [(0, 0), (1, 0), (2, 0), (3, 0)])
    assert [str(piece.piece) for piece in recognized(gap)] == ["[0, 1]", "[1, 2]"]


def test_a_chain_of_a_line_and_arcs():
    stadium = [(-1, -1, 1), (0, -1, 1), (1, -1, 1), (2, -1, 1), (4, 0, 2), (4, 2, 2), (4, 4, 4)]
    curve = xs.Nurbs.from_homogeneous(2, [0, 0, 0, 1, 1, 2, 2, 3, 3, 3], stadium)
    line, circle = recognized(curve)
    assert isinstance(line.shape, Line)
    assert str(line.piece) == "[0, 1]"
    assert isinstance(circle.shape, Circle)
    assert circle.shape.centre == (1, 0)
    assert str(circle.piece) == "[1, 3]"


@pytest.mark.parametrize(
    ("name", "kind"),
    [("ellipse_turned", "ellipse"), ("parabola", "parabola"), ("hyperbola", "hyperbola"), ("circle", "circle")],
)
def test_exact_conics(name, kind):
    (found,) = recognized(xs.example(name))
    assert found.shape.kind == kind
    assert found.exact
    assert found.whole == (kind in ("ellipse", "circle"))


def test_circles_in_space_with_rounded_data():
    """The plane and the sphere both count: a helix lies near a sphere nowhere, a bent arc near no plane."""
    random = Random(7)
    for _ in range(20):
        tilt = [[2, -1, 2, 1], [2, 2, -1, 5], [-1, 2, 2, -3]]
        rows = [(1, 0, 1), (1, 1, 1), (0, 2, 2)]
        curve = xs.Nurbs.from_homogeneous(2, [0, 0, 0, 1, 1, 1], [(x, y, 0, w) for x, y, w in rows])
        moved = curve.transform(tilt)
        points = [tuple(x + mpq(random.randint(-9, 9), 10**9) for x in p) for p in moved.control_points]
        noisy = xs.Nurbs(2, moved.knots, points, moved.weights)
        (found,) = recognized(noisy, "1e-6")
        assert isinstance(found.shape, Circle)
        assert 0 < found.within < mpq(1, 10**7)
        for i in range(41):
            point = noisy(mpq(i, 40))
            offset = [float(x - c) for x, c in zip(point, found.shape.centre, strict=True)]
            normal = [float(n) for n in found.shape.normal]
            size = sum(n * n for n in normal) ** 0.5
            height = sum(x * n for x, n in zip(offset, normal, strict=True)) / size
            radial = (sum(x * x for x in offset) - height * height) ** 0.5 - float(found.shape.radius)
            assert (height**2 + radial**2) ** 0.5 <= float(found.within) + 1e-14
    assert recognized(xs.example("helix_like")) == ()


def test_words_and_errors():
    assert isinstance(recognized(xs.example("ellipse"))[0].shape, Conic)
    for epsilon in (0, "-1/2"):
        with pytest.raises(ShapeError, match="above 0"):
            recognized(xs.example("circle"), epsilon)
    with pytest.raises(ShapeError, match="plane or in space"):
        recognized(xs.Nurbs(1, [0, 0, 1, 1], [(0, 0, 0, 0), (1, 0, 0, 0)]))
    assert rounded_up(mpq(12345)) == 12350
    t = xs.BSpline.identity(0, 1)
    assert signs(t * (t - 1)) == {-1}


#: Circles and arcs in files of kernels, one of them exact.
WRITTEN = (
    "3dm_circle_9cp",
    "brep_crankarm_conic_arc",
    "dxf_squircle_rational",
    "gismo_quarter_circle",
    "gte_half_circle_deg3",
    "step_linkrods_circle_7cp",
)


@pytest.mark.skipif(not SHARED.is_dir(), reason="the shared curves are not at hand")
@pytest.mark.parametrize("name", WRITTEN)
def test_circles_as_kernels_write_them(name):
    (found,) = recognized(xs.read(SHARED / f"{name}.json").curve)
    assert found.shape.kind is ShapeKind.CIRCLE
    assert found.within <= found.shape.radius * mpq(1, 10**9)
