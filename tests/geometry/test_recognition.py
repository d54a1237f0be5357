"""Lines, circles and conics that are recognized, exactly or within a proved distance."""

from pathlib import Path
from random import Random

import pytest
from gmpy2 import mpq

import exactspline as xs
from exactspline.errors import ShapeError
from exactspline.geometry.recognition.candidates import off_every_conic
from exactspline.geometry.recognition.pieces import recognized, rounded_up, signs
from tests.campaigns import recognition as campaign

SHARED = Path(__file__).parents[3] / "shared" / "curves"


def test_arcs_that_are_exact_rounded_moved_and_none():
    """A bound without the gradient's condition, or one read off sample points, is refuted by distances of 50 digits."""
    found = campaign.campaign(40)
    assert not [what for what, count in found.items() if count and what.startswith("WRONG")]
    assert found["arcs moved by a tenth of epsilon"] == 40


@pytest.mark.parametrize("seed", range(4))
def test_points_near_a_conic_are_not_said_to_beoff_every_conic(seed):
    """Points of conics and of pairs of lines, each moved by almost the limit; those of a cubic are off all."""
    chance, off = Random(seed), 0
    for _ in range(60):
        size, limit, kind = mpq(10) ** chance.randint(-3, 3), mpq(10) ** chance.randint(-9, -1), chance.randrange(3)
        a, b, c, d, e = [mpq(chance.randint(-99, 99), 7) for _ in range(5)]
        ts = [mpq(t) for t in sorted(chance.sample(range(-30, 30), chance.randint(6, 9)))]
        w = [t * t + 1 if kind == 1 else mpq(1) for t in ts]
        bent = [abs(t) if kind == 2 else t * t for t in ts]
        exact = [((a + b * t + c * u) / v, (d * t + e * u) / v) for t, u, v in zip(ts, bent, w, strict=True)]
        moves = [chance.choice(((1, 0), (0, -1), (mpq(3, 5), mpq(4, 5)))) for _ in ts]
        almost = limit * mpq(999, 1000)
        points = [
            tuple(size * (x + almost * y) for x, y in zip(point, move, strict=True))
            for point, move in zip(exact, moves, strict=True)
        ]
        assert not off_every_conic(points, size * limit)
        off += off_every_conic([(size * t, size * t**3 / 100) for t in ts], size * limit / 1000)
    assert off > 30


def test_surfaces_and_curves_in_space():
    """A surface "is" what a few of its points are near to; a parabola in space was an ellipse or a hyperbola."""
    found = campaign.in_space_campaign(5)
    assert not [what for what in found if what.startswith("WRONG")]


def test_the_numbers_of_conics_in_space():
    """Half axes in a plane that is not a coordinate plane, of which a frame has irrational lengths."""
    tilt = [[2, -1, 2, 1], [2, 2, -1, 5], [-1, 2, 2, -3]]  # 3 times a rotation
    for name in ("ellipse", "parabola", "hyperbola"):
        flat = xs.example(name)
        points = [(*p, 0) for p in flat.control_points]
        (found,) = recognized(xs.Nurbs(flat.degree, flat.knots, points, flat.weights).transform(tilt))
        (plane_one,) = recognized(flat)
        assert found.exact
        assert found.whole == plane_one.whole
        if name == "parabola":
            (x, y), (u, v) = (plane_one.shape.numbers[key] for key in ("vertex", "axis"))
            turned = [[r[0] * x + r[1] * y + r[3] for r in tilt], [r[0] * u + r[1] * v for r in tilt]]
            assert list(found.shape.numbers["vertex"]) == turned[0]
            a, b = turned[1], found.shape.numbers["axis"]
            assert all((a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2]).sign == 0 for i in range(3))
            assert sum(p * q for p, q in zip(a, b, strict=True)) > 0
        else:
            assert found.shape.semi_axes == tuple(3 * axis for axis in plane_one.shape.semi_axes)


def test_where_a_parabola_opens():
    """y² = 4 (x − 1) opens to the right; its mirror image to the left."""
    for s in (1, -1):
        (found,) = recognized(xs.Nurbs(2, [0, 0, 0, 1, 1, 1], [(s, 0), (s, 1), (2 * s, 2)]))
        vertex, axis = found.shape.numbers["vertex"], found.shape.numbers["axis"]
        assert (vertex, axis[1]) == ((s, 0), 0)
        assert axis[0].sign == s


def test_pieces_near_a_plane():
    """Four points of space are in no plane; those of a cubic that was flat before they were written nearly are."""
    flat = [(0, 0, 0), (1, 2, 0), (3, -1, 0), (4, 1, mpq(1, 10**9))]
    curve = xs.Nurbs(3, [0] * 4 + [1] * 4, flat)
    (found,) = recognized(curve, "1e-8")
    assert found.kind == "plane"
    assert mpq(1, 10**11) < found.within < mpq(1, 10**9)
    assert recognized(curve, "1e-11") == ()


def test_patches_that_share_a_shape_are_given_together():
    """A gutter: a half cylinder between two planes, of which the first and the last patch are one plane each."""
    profile = [
        (-1, -2, 1),
        (-1, -1, 1),
        (-1, 0, 1),
        (-1, 1, 1),
        (0, 2, 2),
        (2, 2, 2),
        (4, 0, 4),
        (4, -4, 4),
        (4, -8, 4),
    ]
    knots = [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4]
    net = [[(mpq(x, w), mpq(y, w), z) for z in (0, 1)] for x, y, w in profile]
    weights = [[w, w] for *_, w in profile]
    gutter = xs.NurbsSurface((2, 1), knots, [0, 0, 1, 1], net, weights)
    found = xs.analyse(gutter).shapes
    assert [(str(part.kind), part.patches, part.exact) for part in found] == [
        ("plane", ((0, 0),), True),
        ("cylinder", ((1, 0), (2, 0)), True),
        ("plane", ((3, 0),), True),
    ]
    assert not any(part.whole for part in found)
    assert xs.analyse(gutter).shapes == found


@pytest.mark.parametrize("scale", [1, mpq("0.12345678901234567"), mpq(10) ** 300])
@pytest.mark.parametrize("far", [0, 1, 4])
def test_a_surface_without_a_tangent_plane_has_no_shape(far, scale):
    """Was a ValueError: patches that are a point or a segment have no regular point to begin from."""
    net = [[(0, 0, 0), (far * scale, 0, 0)], [(2 * far * scale, 0, 0), (3 * far * scale, 0, 0)]]
    assert xs.analyse(xs.NurbsSurface((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], net)).shapes == ()


def test_a_circle_that_runs_around_twice_is_two_pieces():
    """ "The curve runs over the arc once" was true of a circle run over twice."""
    knots = [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 6]
    exact = xs.Nurbs.from_homogeneous(2, knots, rows_of_turns(3))
    pieces = recognized(exact)
    assert [piece.shape.kind for piece in pieces] == ["circle"] * len(pieces)
    assert len(pieces) >= 2
    assert pieces[0].exact


def rows_of_turns(halves):
    """Half circles one after the other, each as two arcs of degree 2: (1 − t², 2t, 1 + t²) on [−1, 0] and [0, 1]."""
    arc = [(0, -2, 2), (1, -1, 1), (1, 0, 1)], [(1, 0, 1), (1, 1, 1), (0, 2, 2)]
    rows = []
    for k in range(halves):
        turn = (-1) ** k
        for points in arc:
            scale = mpq(1) if not rows else rows[-1][2] / mpq(points[0][2])
            new = [tuple(scale * x for x in (turn * p[0], turn * p[1], p[2])) for p in points]
            rows += new if not rows else new[1:]
    return rows


def turned_around(halves, profile):
    """A profile of homogeneous points (ρ, z, w) turned around the z axis by this many half turns."""
    rows = rows_of_turns(halves)
    net = [[(mpq(x) * r, mpq(y) * r, mpq(w) * z, mpq(w) * v) for r, z, v in profile] for x, y, w in rows]
    points = [[tuple(x / p[3] for x in p[:3]) for p in row] for row in net]
    weights = [[p[3] for p in row] for row in net]
    sides = [[0, *sorted([*range(len(own) // 2 + 1)] * 2), len(own) // 2] for own in (rows, profile)]
    return xs.NurbsSurface((2, 2), *sides, points, weights)


@pytest.mark.parametrize(
    ("kind", "profile"),
    [
        ("cone", [(2, 0, 1), (3, 1, 1), (4, 2, 1)]),
        ("plane", [(0, 0, 1), (3, 0, 1), (4, 0, 1)]),
        ("sphere", [(1, 0, 1), (1, 1, 1), (0, 2, 2)]),
        ("torus", [(2 * w + x, y, w) for x, y, w in rows_of_turns(2)]),
    ],
)
def test_what_runs_over_a_surface_once(kind, profile):
    """A whole turn is proved to cover once, one and a half are not, though the Jacobian has one sign."""
    for halves, once in ((2, True), (3, False)):
        surface = turned_around(halves, profile)
        part, *_ = xs.analyse(surface).shapes
        assert (part.kind, part.exact, part.once) == (kind, True, once)
        assert campaign.layers(surface, part.shape) == 2 - once


@pytest.mark.parametrize("profile", [[(2, 0, 1), (0, 2, 1), (-2, 4, 1)], [(-1, 0, 1), (1, 3, 2), (2, 3, 1)]])
@pytest.mark.parametrize("away", [0, mpq(1, 10**12)])
def test_both_halves_of_a_cone_are_one(profile, away):
    """No shape at all before, without a knot at the apex: the profile was taken for a line on one side of the axis."""
    surface = turned_around(2, profile)
    rows = [[(x, y, z + away * ((7 * i) % 5 == 3)) for x, y, z in row] for i, row in enumerate(surface.control_points)]
    (part,) = xs.analyse(xs.NurbsSurface(surface.degree, *surface.knots, rows, surface.weights)).shapes
    assert (part.kind, part.exact, part.whole, part.once) == ("cone", not away, True, False)
    assert part.shape.tangent_squared == 1


def test_patches_that_are_all_of_a_surface_are_whole():
    """They were not where the torus is proposed by one patch, and not by all together."""
    for halves in (2, 3):
        (part,) = xs.analyse(turned_around(halves, [(4, 0, 1), (4, 1, 1), (6, 2, 2)])).shapes
        assert (part.kind, len(part.patches), part.whole) == ("torus", 2 * halves, True)


def test_a_sphere_as_kernels_write_it():
    """Weights of doubles: the centre by least squares is beside the axis through both poles, about which it turns."""
    half = mpq(0.5**0.5)
    around = [(1, 0, 1), (1, 1, half), (0, 1, 1), (-1, 1, half), (-1, 0, 1), (-1, -1, half), (0, -1, 1), (1, -1, half)]
    profile = [(0, -1, 1), (1, -1, half), (1, 0, 1), (1, 1, half), (0, 1, 1)]
    net = [[(x * r, y * r, z) for r, z, _ in profile] for x, y, _ in (*around, around[0])]
    weights = [[v * w for *_, w in profile] for *_, v in (*around, around[0])]
    surface = xs.NurbsSurface((2, 2), [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4], [0, 0, 0, 1, 1, 2, 2, 2], net, weights)
    (part,) = xs.analyse(surface).shapes
    assert (part.kind, part.exact, part.whole, part.once) == ("sphere", False, True, True)
    assert part.within < mpq(1, 10**15)


def test_folds_of_a_plane_are_not_covered_once():
    """A quadrilateral is; one whose sides cross, and a strip that turns back, are not."""
    for ends, once in ((((0, 0), (0, 1), (2, 0), (1, 1)), True), (((0, 0), (0, 1), (1, 1), (1, 0)), False)):
        a, b, c, d = ((*p, 0) for p in ends)
        (part,) = xs.analyse(xs.NurbsSurface((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[a, b], [c, d]])).shapes
        assert part.once == once
    strip = [[(x, y, 0) for y in (0, 1)] for x in (0, 2, 1)]
    (part,) = xs.analyse(xs.NurbsSurface((2, 1), [0, 0, 0, 1, 1, 1], [0, 0, 1, 1], strip)).shapes
    assert not part.once


def test_what_turns_back_or_has_a_gap_is_not_one_arc():
    back = xs.Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (2, 0), (-1, 0), (1, 0)])
    assert recognized(back) == ()
    gap = xs.Nurbs(1, [0, 0, 1, 1, 2, 2], [(0, 0), (1, 0), (2, 0), (3, 0)])
    assert [str(piece.piece) for piece in recognized(gap)] == ["[0, 1]", "[1, 2]"]


def test_a_chain_of_a_line_and_arcs():
    stadium = [(-1, -1, 1), (0, -1, 1), (1, -1, 1), (2, -1, 1), (4, 0, 2), (4, 2, 2), (4, 4, 4)]
    curve = xs.Nurbs.from_homogeneous(2, [0, 0, 0, 1, 1, 2, 2, 3, 3, 3], stadium)
    line, circle = recognized(curve)
    assert type(line.shape).__name__ == "Line"
    assert str(line.piece) == "[0, 1]"
    assert type(circle.shape).__name__ == "Circle"
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
        assert type(found.shape).__name__ == "Circle"
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
    assert type(recognized(xs.example("ellipse"))[0].shape).__name__ == "Conic"
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
    assert found.shape.kind == "circle"
    assert found.within <= found.shape.radius * mpq(1, 10**9)
