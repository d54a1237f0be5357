"""The true bisector of a point and a plane curve: closed forms, distances by brute force, and the convexity of the cell
it bounds.
"""

from fractions import Fraction
from random import Random

import pytest
from flint import Ordering, fmpz_mpoly_ctx, fmpz_poly
from gmpy2 import mpq
from mpmath import mp

from exactspline import BSpline, Nurbs, Root, example, formula_of, zeros
from exactspline.errors import ShapeError
from exactspline.geometry.bisectors import trimmed as module
from exactspline.geometry.bisectors.trimmed import trimmed_bisector
from exactspline.polynomials.elimination import discriminant
from tests.support.dials import factors, over_dials
from tests.support.vectors import mpf_of

LINE = Nurbs(1, [0, 0, 1, 1], [(-4, 0), (4, 0)])
CASES = [
    (LINE, (0, 2)),
    (example("circle"), ("1/2", 0)),
    (example("circle"), (0, 0)),
    (example("circle"), (3, 0)),
    (example("ellipse"), (0, 0)),
    (example("ellipse"), (1, "1/3")),
    (example("ellipse_skew"), (2, "-1/3")),
    (example("rational_cubic"), (1, 1)),
    (example("rational_cubic_spline"), ("1/2", -1)),
    (example("six_segment_cubic"), (0, 0)),
    (example("parabola"), (0, 1)),
    (example("cusp"), (0, 1)),
    (example("straight_between_arcs"), (1, 1)),
    (Nurbs(1, [0, 0, 1, 2, 2], [(-3, 1), (0, 0), (3, 1)]), (0, -2)),
    (Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (2, 0), (2, 2), (0, 2), (0, 0)]), ("1/2", "3/4")),
]
over_cases = pytest.mark.parametrize(("curve", "point"), CASES, ids=lambda x: getattr(x, "name", None) or str(x))


def exact(point):
    return tuple(mpq(Fraction(x)) for x in point)


def clearance(curve, point, b):
    """‖γ − Q‖² − 2 (B − Q)·(γ − Q), times w², as a spline: nowhere negative when B is on the true bisector."""
    (qx, qy), (bx, by) = exact(point), b
    x, y = curve.p[0] - curve.w * qx, curve.p[1] - curve.w * qy
    return x * x + y * y - 2 * curve.w * ((bx - qx) * x + (by - qy) * y)


def inner(low, high, part):
    """A rational number inside an interval with roots for ends."""
    a = low.refine(12)[1] if isinstance(low, Root) else mpq(low)
    b = high.refine(12)[0] if isinstance(high, Root) else mpq(high)
    return a + (b - a) * part


@over_cases
def test_random_points_of_the_untrimmed_bisector_against_distances(curve, point):
    """A parameter is kept exactly where no point of the curve lies inside the circle around B through Q."""
    random, result = Random(7), trimmed_bisector(curve, point)
    untrimmed = formula_of("plane_bisector_polynomial")(curve.with_point(exact(point)))
    a, b = curve.domain
    places = [a + (b - a) * mpq(k, 60) for k in range(61)]
    decided = 0
    while decided < 30:
        s = a + (b - a) * mpq(random.randrange(1, 10**6), 10**6)
        decided += 1
        if untrimmed.denominator(s) == 0:
            continue
        f = clearance(curve, point, untrimmed(s))
        assert f(s) == 0
        kept = any(arc.low <= s <= arc.high for arc in result.arcs)
        if any(f(t) < 0 for t in places):
            assert not kept
        else:
            # nothing inside at 61 places: decided by the zeros of the clearance, another way than that of the module
            crossings = [root for root in zeros(f) if root.sign_change] + [
                jump for jump in zeros(f).jumps if jump.sign_change
            ]
            assert kept == (not crossings)
        if kept:
            arc = next(arc for arc in result.arcs if arc.low <= s <= arc.high)
            assert arc(s) == untrimmed(s)


@over_cases
def test_points_of_the_straight_pieces(curve, point):
    """They are as far from Q as from the corner, and no point of the curve is nearer; behind the ends some is."""
    q = exact(point)
    for piece in trimmed_bisector(curve, point).pieces:
        if piece.foot is None:
            continue
        foot = curve(piece.foot)
        for part in (mpq(1, 5), mpq(1, 2), mpq(6, 7)):
            b = piece(inner(piece.low, piece.high, part))
            assert sum((x - y) ** 2 for x, y in zip(b, q, strict=True)) == sum(
                (x - y) ** 2 for x, y in zip(b, foot, strict=True)
            )
            assert not any(root.sign_change for root in zeros(clearance(curve, point, b)))
        for end, outwards in ((piece.low, -1), (piece.high, 1)):
            if end not in (-1, 1):
                t = (end.refine(6)[outwards > 0] if isinstance(end, Root) else end) + outwards * mpq(1, 10**5)
                f = clearance(curve, point, piece.value(t))
                assert any(root.sign_change for root in zeros(f)) or f((f.domain[0] + f.domain[1]) / 2) < 0


@over_cases
def test_the_pieces_close_up(curve, point):
    """The true bisector bounds a convex cell around Q: every finite end of a piece is the end of exactly one other."""
    ends = []
    with mp.workdps(60):
        for piece in trimmed_bisector(curve, point).pieces:
            for end in (piece.low, piece.high):
                t = end.refine(40)[0] if isinstance(end, Root) else end
                w = piece.value.denominator(t, "left" if end is piece.high else "right")
                if abs(w) > mpq(1, 10**20):
                    x, y = (c(t, "left" if end is piece.high else "right") / w for c in piece.value.numerator)
                    ends.append((mpf_of(x), mpf_of(y)))
        for x, y in ends:
            assert sum(abs(x - u) + abs(y - v) < mp.mpf(10) ** -15 * (1 + abs(x) + abs(y)) for u, v in ends) == 2


@over_cases
def test_the_cell_is_convex(curve, point):
    """The middle of two points of the bisector is nowhere nearer to the curve than to Q."""
    result = trimmed_bisector(curve, point)
    points = [piece(inner(piece.low, piece.high, part)) for piece in result.pieces for part in (mpq(1, 7), mpq(5, 8))]
    for b in points:
        for c in points[:3]:
            middle = tuple((x + y) / 2 for x, y in zip(b, c, strict=True))
            assert not any(root.sign_change for root in zeros(clearance(curve, point, middle)))


def test_a_point_on_the_curve_is_refused():
    for point in ((0, 1), (1, 0), ("3/5", "4/5")):
        with pytest.raises(ShapeError, match="lies on the curve"):
            trimmed_bisector(example("circle"), point)


def test_a_segment_on_a_line_through_the_point_has_no_arc():
    result = trimmed_bisector(LINE, (5, 0))
    assert result.arcs == []
    assert "passes through the point" in result.missing[0]
    assert [piece.foot for piece in result.pieces] == [1]
    assert result.pieces[0].low == -1
    assert result.pieces[0].high == 1


def test_curves_in_pieces_and_in_space_are_refused():
    with pytest.raises(ShapeError, match="jumps"):
        trimmed_bisector(example("jump"), (0, 5))
    with pytest.raises(ShapeError, match="R3"):
        trimmed_bisector(example("twisted_cubic"), (0, 5))
    with pytest.raises(ShapeError, match="3 coordinates"):
        trimmed_bisector(LINE, (0, 5, 1))


def test_an_irrational_singular_point_is_named():
    """A cusp at the root of 2t² = 1: its line has irrational coordinates."""
    f = BSpline.bezier([0, 0, 1])
    x = (f * 2 - 1) * (f * 2 - 1)
    y = x * (f * 2 - 1)
    n = max(x.degree, y.degree)
    points = list(
        zip(x.elevate_degree(n - x.degree).control_points, y.elevate_degree(n - y.degree).control_points, strict=True)
    )
    curve = Nurbs(n, [0] * (n + 1) + [1] * (n + 1), points)
    assert any("irrational" in reason for reason in trimmed_bisector(curve, (-3, 0)).missing)


def test_where_the_curve_stands_still_its_point_has_one_line():
    """The same pieces as without the stretch, and the reason for what is missing."""
    standing = Nurbs(1, [0, 0, 1, 2, 3, 3], [(0, 0), (1, 1), (1, 1), (3, 0)])
    going = Nurbs(1, [0, 0, 1, 2, 2], [(0, 0), (1, 1), (3, 0)])
    one, other = trimmed_bisector(standing, (1, 4)), trimmed_bisector(going, (1, 4))
    assert (
        [piece.kind for piece in one.pieces]
        == [piece.kind for piece in other.pieces]
        == ["arc", "arc", "end point", "end point", "corner"]
    )
    assert len(one.missing) == 1
    assert "stands still" in one.missing[0]
    at_start = trimmed_bisector(Nurbs(1, [0, 0, 1, 2, 2], [(0, 0), (0, 0), (3, 0)]), (1, 4))
    assert [piece.foot for piece in at_start.pieces if piece.foot is not None] == [0, 2]


def test_corners_at_one_point_have_one_line():
    """Two triangles that share a vertex: the curve passes it twice, at its seam and half way."""
    curve = Nurbs(1, [0, 0, 1, 2, 3, 4, 5, 6, 6], [(0, 0), (-2, 1), (-1, 2), (0, 0), (1, 2), (2, 1), (0, 0)])
    assert [piece.foot for piece in trimmed_bisector(curve, (0, -1)).pieces if piece.foot is not None].count(0) == 1
    assert [piece.foot for piece in trimmed_bisector(curve, (0, -1)).pieces].count(3) == 0


def test_an_arc_of_a_circle_through_the_point_has_no_arc():
    """All normals meet in the centre: what is left are the lines of the two ends, which meet there."""
    quarter = Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], [1, 1, 2])
    result = trimmed_bisector(quarter, (0, -1))
    assert [(piece.kind, piece.foot) for piece in result.pieces] == [("end point", 0), ("end point", 1)]
    assert "circle through the point" in result.missing[0]
    for piece in result.pieces:
        assert [piece(inner(end, end, 0)) for end in (piece.low, piece.high) if end not in (-1, 1)] == [(0, 0)]


def test_the_infinite_end_of_a_piece_is_a_pole():
    end = next(piece for piece in trimmed_bisector(LINE, (0, 2)).pieces if piece.kind == "end point")
    infinite = next(t for t in (end.low, end.high) if t in (-1, 1))
    with pytest.raises(ZeroDivisionError):
        end(infinite)
    with pytest.raises(ShapeError, match="outside"):
        end(2 * infinite)


@pytest.mark.parametrize("weights", [None, (2, 3), (-1, -1)])
def test_a_curve_that_is_one_point_has_the_line_between(weights):
    """The points as far from Q as from that point: all of the perpendicular bisector."""
    found = trimmed_bisector(Nurbs(1, [0, 0, 1, 1], [(4, 4), (4, 4)], weights=weights), (2, 0))
    (piece,) = found.pieces
    assert (piece.low, piece.high) == (-1, 1)
    assert piece(0) == (3, 2)
    assert all((x - 2) ** 2 + y**2 == (x - 4) ** 2 + (y - 4) ** 2 for x, y in (piece(mpq(k, 7)) for k in range(-6, 7)))


def test_discriminants_by_values_are_those_by_elimination():
    context = fmpz_mpoly_ctx.get(("z", "u"), Ordering.lex)
    z, u = context.gens()
    numbers = Random(4)
    for m in (2, 3, 5):
        rows = [fmpz_poly([numbers.randint(-9, 9) for _ in range(4)]) for _ in range(m + 1)]
        # a leading row with zeros among the small integers
        rows[-1] = fmpz_poly([0, 1]) * fmpz_poly([2, 1]) * fmpz_poly([-1, 1])
        p = sum(
            (x * z**i * u**j for j, row in enumerate(rows) for i, x in enumerate(row.coeffs())), context.constant(0)
        )
        wanted = p.discriminant(1)
        found = discriminant(rows)
        assert sum((x * z**i for i, x in enumerate(found.coeffs())), context.constant(0)) == wanted


def test_an_arc_between_two_poles_beside_a_long_curve():
    """Many segments, few pieces: what is left to elimination does not depend on how many segments there are."""
    calls = []
    numbers = Random(1)
    curve = Nurbs(3, [0] * 4 + list(range(1, 30)) + [30] * 4, [(2 * i, numbers.randint(-9, 9)) for i in range(33)])
    original = module._candidates
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(module, "_candidates", lambda *a: calls.append(1) or original(*a))
        assert len(trimmed_bisector(curve, (3, 20)).pieces) == 8
    assert len(calls) < 30


@over_dials
def test_a_similar_curve_has_the_similar_bisector(number):
    """Every dial: a turned, scaled and moved curve has the same pieces. Before: some cases of doubles were a traceback,
    `OverflowError` from the ordering of factors.
    """
    random = Random(5)
    for curve, point in CASES:
        a, b, c, d = factors(number, random, 4)

        def moved(x, y, a=a, b=b, c=c, d=d):
            return a * x - b * y + c, b * x + a * y + d

        weights = curve.weights
        similar = Nurbs(curve.degree, curve.knots, [moved(*p) for p in curve.control_points], weights)
        one, other = trimmed_bisector(curve, point), trimmed_bisector(similar, moved(*exact(point)))
        assert one.undecided == other.undecided == ()
        assert [(p.kind, p.foot, p.low, p.high) for p in one.pieces] == [
            (p.kind, p.foot, p.low, p.high) for p in other.pieces
        ]


def test_the_line_of_a_corner_runs_from_its_middle_to_both_sides_alike():
    """At −u and u as far from the middle of the point and the corner, and everywhere as far from both."""
    polygon = Nurbs(1, [0, 0, 1, 2, 2], [(1, 0), (3, 1), (1, 2)])
    found = [one for one in trimmed_bisector(polygon, (6, 1)).pieces if one.kind == "corner"]
    assert found
    corner, q = (mpq(3), mpq(1)), (mpq(6), mpq(1))
    for one in found:
        for k in range(8):
            ends = [[f(u) / one.value.denominator(u) for f in one.value.vector] for u in (mpq(k, 8), mpq(-k, 8))]
            assert [a + b for a, b in zip(*ends, strict=True)] == [a + b for a, b in zip(corner, q, strict=True)]
            for end in ends:
                to_corner, to_q = (sum((x - y) ** 2 for x, y in zip(end, each, strict=True)) for each in (corner, q))
                assert to_corner == to_q
