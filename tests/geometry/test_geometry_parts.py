"""The parts of what is told of curves and surfaces, each held against what it means on small cases."""

from itertools import pairwise
from math import comb

import pytest
from flint import arb, fmpz_poly
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st
from mpmath.libmp import to_rational

from exactspline import BSpline, Nurbs, NurbsSurface, zeros
from exactspline.errors import FormulaError, OpenError
from exactspline.geometry.angles import Angle
from exactspline.geometry.bisector import cusps
from exactspline.geometry.bisector.components import Solutions
from exactspline.geometry.bisector.correspondence import graph_intervals
from exactspline.geometry.bisector.lines import Path, along
from exactspline.geometry.bisector.polynomials import vanish_together
from exactspline.geometry.bisector.single_pairs import zeros_of_vector
from exactspline.geometry.bisector.special_pairs import runs_on
from exactspline.geometry.bisector.system import System, piece
from exactspline.geometry.bisector.trimmed import PieceKind, trimmed_bisector
from exactspline.geometry.constructions import Variant, all_constructions
from exactspline.geometry.curvature import curvature_function
from exactspline.geometry.derived import derive
from exactspline.geometry.domain import intervals_where
from exactspline.geometry.floats import at_floats
from exactspline.geometry.joints import curvature_of
from exactspline.geometry.surface import singular
from exactspline.geometry.surface.borders import is_inside, vanishes_at
from exactspline.geometry.surface.forms import SurfaceForms, lowest
from exactspline.geometry.surface.inspection import inspect_surface
from exactspline.geometry.surface.joints import SurfaceJointKind
from exactspline.geometry.surface.places import InnerZero, Place
from exactspline.geometry.surface.singular import SingularPoints
from exactspline.interchange.examples import example
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.polynomials.common_zeros import isolate
from exactspline.polynomials.elimination import discriminant
from exactspline.polynomials.patch_forms import PatchForm, clusters
from exactspline.polynomials.two_parameters import S, T
from exactspline.questions.answers import CurvePiece
from exactspline.reals.ball import InBalls
from exactspline.reals.digits import Digits
from exactspline.splines.tensor import TensorSpline
from tests.support.bisector_oracle import FAMILIES

# ---- curves


@given(st.lists(st.booleans(), min_size=1, max_size=8))
def test_intervals_are_maximal(holds):
    """Neighbours are one; what is inside is exactly where it holds."""
    breaks = [mpq(k * k) for k in range(len(holds) + 1)]
    found = intervals_where(breaks, holds)
    assert all(a[1] < b[0] for a, b in pairwise(found))
    for (a, b), here in zip(pairwise(breaks), holds, strict=True):
        assert here == any(low <= a and b <= high for low, high in found)


@given(st.integers(1, 10**9), st.integers(0, 40), st.integers(1, 12), st.sampled_from([1, -1]), st.integers(0, 8))
def test_significant_digits_are_certain(top, power, digits, sign, shift):
    """However small the number, and wherever it lies in its enclosures, which are 10⁻ⁿ wide."""
    exact, asked = mpq(sign * top, 10**power * 7), []

    class Given(Digits):
        def _enclosed(self, n):
            asked.append(n)
            width = mpq(1, 10**n)
            return Interval(exact - width * mpq(shift, 9), exact + width * mpq(9 - shift, 9))

        def _against_number(self, t):
            return (exact > t) - (exact < t)

    told = mpq(*to_rational(Given().significant(digits)._mpf_))
    assert asked == sorted(asked)
    assert abs(told - exact) * 10**digits <= abs(exact)


@pytest.mark.parametrize("order", [-1, True, 1.0, "1", None])
def test_orders_of_derivatives_are_natural_numbers(order):
    with pytest.raises(FormulaError, match="orders are 0, 1, 2"):
        at_floats(example("circle"), [0.5], order=order)


@given(st.tuples(*[st.integers(-5, 5)] * 6), st.integers(1, 4), st.integers(-3, 3))
def test_curvature_is_that_of_the_plane_and_of_space_whatever_the_speed(jet, k, m):
    """κ = ‖γ′ × γ″‖/‖γ′‖³; with γ(kt + mt²) for γ(t) it stays the same."""
    first, second = jet[:3], jet[3:]
    if not any(first):
        return
    faster = [k * x for x in first], [k * k * y + 2 * m * x for x, y in zip(first, second, strict=True)]
    at = (0, 0, 0)
    assert curvature_of((at, *faster, at)) == curvature_of((at, first, second, at))
    (a, b, c), (d, e, f) = first, second
    across = (b * f - c * e) ** 2 + (c * d - a * f) ** 2 + (a * e - b * d) ** 2
    assert curvature_of((at, first, second, at)) ** 2 == mpq(across, (a * a + b * b + c * c) ** 3)
    if a or b:
        flat = curvature_of((at[:2], first[:2], second[:2], at[:2]))
        assert flat**2 == curvature_of((at, (a, b, 0), (d, e, 0), at)) ** 2
        assert (flat > 0, flat < 0) == (a * e > b * d, a * e < b * d)


def test_a_piece_across_the_seam_contains_its_ends():
    piece = CurvePiece(((mpq(3), mpq(4)), (mpq(0), mpq(1, 2))))
    assert (piece.start, piece.end, piece.across_seam) == (3, mpq(1, 2), True)
    assert not CurvePiece(piece.parts[:1]).across_seam
    assert [t in piece for t in map(mpq, (0, "1/4", "1/2", "3/4", 2, 3, 4))] == [True] * 3 + [False] * 2 + [True] * 2


@given(st.integers(1, 9), st.integers(1, 60))
def test_right_angles_are_whole_numbers_of_degrees(k, digits):
    one = mpq(1), mpq(0)
    told = [Angle(one, other).degrees(digits) for other in ((k, 0), (0, k), (-k, 0), (0, -k))]
    assert told == [0, 90, 180, -90]
    assert (-1 < Angle(one, (mpq(k), mpq(1, 100))).degrees(digits) < 90) is True


def test_a_ball_is_not_told_from_what_it_may_be():
    """1/2 is neither above nor below itself."""
    half = mpq(1, 2)
    with pytest.raises(OpenError, match="undecided at"):
        InBalls(lambda bits: arb("0.5")) > half  # noqa: B015
    for other, sign in ((mpq(1, 2) + mpq(1, 10**30), -1), (mpq(1, 2) - mpq(1, 10**30), 1), (mpq(0), 1), (mpq(1), -1)):
        assert (InBalls(lambda bits: arb("0.5")) - other).sign == sign


@pytest.mark.parametrize("name", [c.name for c in all_constructions().values() if c.zero_set])
def test_the_minimal_form_has_the_sign_of_the_first_whatever_that_of_w(name):
    made = all_constructions()[name]
    curve = example("rational_cubic" if made.dimension == 2 else "rational_space_cubic")
    first = next(iter(made.variants))
    for sign in (1, -1):
        own = Nurbs(curve.degree, curve.knots, curve.control_points, [sign * w for w in curve.weights])
        minimal, form = made.on(own, Variant.MINIMAL), made.on(own, first)
        assert any(minimal.forms[0][0])
        for k in range(1, 12):
            t = mpq(k, 12)
            assert minimal(t) * form(t) >= 0
            assert bool(minimal(t)) or not form(t)


@pytest.mark.parametrize("name", [c.name for c in all_constructions().values() if c.zero_set])
def test_the_sign_of_a_form_is_that_of_an_odd_power_of_w(name):
    """Also where w > 0 has a negative weight in the middle."""
    made = all_constructions()[name]
    points = [(0, 0, 0)[: made.dimension], (1, 2, 0)[: made.dimension], (3, 1, 1)[: made.dimension]]
    for sign in (1, -1):
        net = [(*p, sign * w) for p, w in zip(points, (4, -1, 4), strict=True)]
        curve = Nurbs.from_homogeneous(2, [0] * 3 + [1] * 3, net)
        for variant in (*[v for v in made.variants if v != "squaring"], Variant.LIFTED):
            assert made.sign(curve, variant) == sign ** (made.power_of_w(variant) % 2)


def test_curvature_where_the_speed_is_a_polynomial_and_where_it_is_none():
    """Of (t − t³/3, t²) it is 2/(1 + t²)²; with γ′ = t (1 − t², 2t) there is a pole, and a cubic has no such speed."""
    t = BSpline.identity(-1, 1)

    def on(x, y):
        return curvature_function(Nurbs.from_splines([x, y]))[0]

    for sign in (1, -1):
        told = on(t - t**3 * mpq(1, 3), t * t * sign)
        assert [told.value(x) for x in (-1, 0, mpq(1, 2))] == [mpq(sign, 2), 2 * sign, sign * mpq(32, 25)]
        assert told.radicand == 1
    for none in (on(t**2 * mpq(1, 2) - t**4 * mpq(1, 4), t**3 * mpq(2, 3)), *curvature_function(example("cubic_s"))):
        assert (none.radicand, none.value) == (0, None)
        assert none.reason


def test_a_derived_object_has_the_values_of_its_pieces():
    curve = example("rational_cubic")
    point, number = derive("evolute", curve)(mpq(1, 3)), derive("zero_curvature", curve)(mpq(1, 3))
    assert isinstance(point, tuple)
    assert len(point) == 2
    assert number == derive("zero_curvature", curve).pieces[0].value(mpq(1, 3))


# ---- bisectors


@pytest.mark.parametrize("root", range(-6, 7))
@pytest.mark.parametrize("degree", [1, 2])
def test_the_discriminant_of_a_quadratic_is_known_wherever_it_is_none(root, degree):
    """b² − 4ac, also where a vanishes at an integer."""
    a, b, c = fmpz_poly([-root, 1]) ** degree, fmpz_poly([2, 0, 3][: degree + 1]), fmpz_poly([1, -1, 5])
    assert discriminant([c, b, a]) == b * b - 4 * a * c


@pytest.mark.parametrize(("meet", "expected"), [(True, Solutions.SPACE), (False, Solutions.PLANE), (None, None)])
def test_cusps_have_all_of_space_only_where_they_certainly_meet(monkeypatch, meet, expected):
    monkeypatch.setattr(cusps, "vanish_together", lambda polynomials, s, t: meet)
    first, second = FAMILIES["two cusps in one point"]
    found = cusps.over_both_cusps(System(piece(first, 0), piece(second, 0)))
    assert [pair.solutions for pair in found.pairs] == ([] if expected is None else [expected])
    assert len(found.left_out) == (expected is None)


def test_a_piece_has_no_factor_in_common():
    """Of (2t, t², 1 − t)/(1 + t) with numerators and denominator times 1 + t²."""
    own = [fmpz_poly(p) for p in ([0, 2], [0, 0, 1], [1, -1], [1, 1])]

    def curve(degree, factor):
        rows = [
            [sum(mpq(comb(i, k), comb(degree, k)) * int((p * factor)[k]) for k in range(i + 1)) for p in own]
            for i in range(degree + 1)
        ]
        return Nurbs.from_homogeneous(degree, [0] * (degree + 1) + [1] * (degree + 1), rows)

    plain, more = piece(curve(2, fmpz_poly([1])), 0), piece(curve(4, fmpz_poly([1, 0, 1])), 0)
    assert (plain.p, plain.w) == (own[:3], own[3])
    assert (more.p, more.w, more.tangent, more.cusps) == (plain.p, plain.w, plain.tangent, ())


def test_tangents_of_a_piece_have_no_zero_and_its_cusps_are_told():
    """Of (t², t³, 0)."""
    half = Nurbs(3, [-1] * 4 + [1] * 4, [("1", -1, 0), ("-1/3", 1, 0), ("-1/3", -1, 0), (1, 1, 0)])
    own = piece(half, 0)
    assert [f.degree() for f in own.tangent] == [0, 1, -1]
    assert own.cusps == (fmpz_poly([0, 1]),)
    assert not own.stands_still


def test_polynomials_of_one_of_two_irrational_parameters_vanish_at_that_one():
    """At s = √½ and t = √⅓."""
    (s,), (t,) = zeros(BSpline.bezier([-1, -1, 1])), zeros(BSpline.bezier([-1, -1, 2]))
    for p, expected in ((2 * S * S - 1, True), (3 * T * T - 1, True), (3 * S * S - 1, False), (2 * T * T - 1, False)):
        assert vanish_together([p], s, t) is expected
    assert vanish_together([6 * S * S * T * T - 1, 2 * S * S - 3 * T * T], s, t) is True
    assert vanish_together([6 * S * T - 1], s, t) is False


def test_where_a_vector_vanishes_the_condition_beside_it_holds():
    """(A C, B D, 0) with the condition A B, whose zeros are not all: none with C = D = 0."""
    a, b, c, d = 4 * S - 1, 4 * T - 1, 4 * S - 3, 4 * T - 3
    sides = UNIT
    places, left_out = zeros_of_vector(a * b, [a * c, b * d, S * 0], sides)
    assert ({tuple(map(mpq, p)) for p in places}, left_out) == (
        {(mpq(1, 4), mpq(1, 4)), (mpq(1, 4), mpq(3, 4)), (mpq(3, 4), mpq(1, 4))},
        (),
    )
    assert zeros_of_vector(None, [a * c, b * d, S * 0], sides)[1] == ()
    assert len(zeros_of_vector(None, [a * c, b * d, S * 0], sides)[0]) == 4


def test_a_quotient_that_touches_the_end_of_its_range_stays_inside():
    """(2t − 1)² touches 0; (2t − 1)² − 1/4 leaves [0, 1] in between; −(2t − 1)² has one parameter there."""
    unit = mpq(0), mpq(1)
    square = fmpz_poly([1, -4, 4])
    assert graph_intervals(square, fmpz_poly([1]), unit, unit) == [unit]
    assert graph_intervals(4 * square - 1, fmpz_poly([4]), unit, unit) == [(0, mpq(1, 4)), (mpq(3, 4), 1)]
    assert graph_intervals(-square, fmpz_poly([1]), unit, unit) == [(mpq(1, 2), mpq(1, 2))]


def test_polynomials_along_a_path_are_their_values_times_one_power():
    """With s = z/2 and t = (z + 1)/(z + 3), of degrees 1 and 2."""
    z = fmpz_poly([0, 1])
    first, second = along([S * T * T + 1, 3 * S - T], Path((z, fmpz_poly([2])), (z + 1, z + 3)))
    power = 2 * (z + 3) ** 2
    assert 2 * first == z * (z + 1) ** 2 * 2 + 2 * power
    assert second == 3 * z * (z + 3) ** 2 - 2 * (z + 1) * (z + 3)


def test_the_line_of_a_corner_runs_from_its_middle_to_both_sides_alike():
    """At −u and u as far from the middle of the point and the corner, and everywhere as far from both."""
    polygon = Nurbs(1, [0, 0, 1, 2, 2], [(1, 0), (3, 1), (1, 2)])
    found = [one for one in trimmed_bisector(polygon, (6, 1)).pieces if one.kind is PieceKind.CORNER]
    assert found
    corner, q = (mpq(3), mpq(1)), (mpq(6), mpq(1))
    for one in found:
        for k in range(8):
            ends = [[f(u) / one.value.denominator(u) for f in one.value.vector] for u in (mpq(k, 8), mpq(-k, 8))]
            assert [a + b for a, b in zip(*ends, strict=True)] == [a + b for a, b in zip(corner, q, strict=True)]
            for end in ends:
                to_corner, to_q = (sum((x - y) ** 2 for x, y in zip(end, each, strict=True)) for each in (corner, q))
                assert to_corner == to_q


@pytest.mark.parametrize("direction", [(1, 2, 3), (2, 4, 7), (-1, -2, -3), (0, 0, 1), (1, 2, 0)])
@pytest.mark.parametrize("speed", [1, 5])
def test_a_polygon_runs_on_where_its_sides_have_one_direction(direction, speed):
    """Whatever their lengths; of (−1, −2, −3) the other way it turns back on the same line."""
    first = (1, 2, 3)
    points = [(0, 0, 0), first, tuple(a + speed * b for a, b in zip(first, direction, strict=True))]
    polygon = Nurbs(1, [0, 0, 1, 2, 2], points)
    assert runs_on(polygon, mpq(1)) is (direction in (first, (-1, -2, -3)))


# ---- surfaces


def test_a_patch_is_regular_where_its_normal_vanishes_along_edges_at_most():
    edge, place = singular.EDGES[0], Place(((0, 0),), None, mpq(0), mpq(0))
    assert SingularPoints(edges=(edge,)).regular
    for told in ({"degenerate": True}, {"places": (place,)}, {"undecided": (UNIT,)}, {"along_curve": True}):
        assert not SingularPoints(edges=(edge,), **told).regular


def test_whether_an_irrational_zero_is_inside_is_decided_by_the_roots_on_the_border():
    """y = ε (4x − 1)(7 − 8x) meets 2x² = 1 so near to the border that only its roots tell it apart from one of them,
    with others on both sides of it; for ε = 0 it is a root itself, and for ε < 0 not on the patch.
    """
    ends = [0, 0, 1, 1]
    x, y = TensorSpline((1, 1), ends, ends, [[0, 0], [1, 1]]), TensorSpline((1, 1), ends, ends, [[0, 1], [0, 1]])
    sides = (x * 4 - 1) * (x * 8 - 7)
    for near in (0, mpq(1, 2**20), mpq(-1, 2**20), *[mpq(1, 2**k) for k in (50, 100, 200, 300)]):
        line, other = y + sides * near, sides * (x * x * 2 - 1) + y * 0
        found = isolate(*(f.elevated_to(g).patch_form(0, 0) for f, g in ((line, other), (other, line)))).zeros
        told = {tuple(round(float(a), 3) for a, _ in zero.refine(60)): is_inside(zero, UNIT) for zero in found}
        assert told.pop((0.707, 0.0), False) is (near > 0)
        assert told == {(0.25, 0.0): False, (0.875, 0.0): False}


def test_a_point_of_the_border_lies_on_a_form_in_corners_too():
    """x − y vanishes at (0, 0), not at (0, 1/3), whichever side the point was found on."""
    form = PatchForm.of_net([[0, -1], [1, 0]])
    (start,) = zeros(BSpline.bezier([0, 1]))
    (third,) = zeros(BSpline.bezier([-1, 2]))
    assert (start == 0, third == mpq(1, 3)) == (True, True)
    for place, on in (
        (Place(((0, 0),), None, start, mpq(0)), True),
        (Place(((0, 0),), None, mpq(0), start), True),
        (Place(((0, 0),), None, mpq(0), third), False),
        (Place(((0, 0),), None, third, mpq(0)), False),
    ):
        assert vanishes_at(form, place.spot, UNIT) is on


@pytest.mark.parametrize("digits", [3, 30, 90])
def test_the_box_of_an_inner_zero_is_as_small_as_asked_for(digits):
    """Of x² + y² = 1 and x = y, on a patch that is 1000 long."""
    circle, line = (
        PatchForm.of_net([[-1, -1, 0], [-1, -1, 0], [0, 0, 1]]),
        PatchForm.of_net([[0, -1, -2], [1, 0, -1], [2, 1, 0]]),
    )
    (zero,) = isolate(circle, line).zeros
    sides = Box(Interval(mpq(0), mpq(1000)), Interval(mpq(-1), mpq(2)))
    (a, b), (c, d) = InnerZero(zero, sides).box(digits)
    assert max(b - a, d - c) <= mpq(1, 10**digits)
    assert 2 * a * a <= 1000**2 <= 2 * b * b
    assert 2 * (c + 1) ** 2 <= 9 <= 2 * (d + 1) ** 2


@pytest.mark.parametrize(("steps", "torn"), [((0, 0, 1), [False, True]), ((0, 1, 1), [True, False])])
def test_a_surface_is_torn_at_its_own_knot(steps, torn):
    """Of three strips in either direction two neighbours do not fit."""
    ends = [0, 0, 1, 1, 2, 2, 3, 3]
    rows = [(x, z) for k, z in enumerate(steps) for x in (k, k + 1)]
    along_u = NurbsSurface((1, 1), ends, [0, 0, 1, 1], [[(x, y, z) for y in (0, 1)] for x, z in rows])
    along_v = NurbsSurface((1, 1), [0, 0, 1, 1], ends, [[(x, y, z) for x, z in rows] for y in (0, 1)])
    for surface, direction in ((along_u, "u"), (along_v, "v")):
        met = inspect_surface(surface).joints
        told = [(one.across.value, one.value, one.kind is SurfaceJointKind.TORN) for one in met]
        assert told == [(direction, 1, torn[0]), (direction, 2, torn[1])]


@pytest.mark.parametrize("rows", [[[0, 0], [1, 1], [2, 2]], [[3, 3], [3, 3], [3, 3]], [[0, 1], [0, 1], [0, 1]]])
def test_lowest_degrees_are_the_true_ones(rows):
    """u, a constant, and v, as forms of degree (2, 1)."""
    f = TensorSpline((2, 1), [0, 0, 0, 2, 2, 2], [0, 0, 1, 1], rows)
    assert lowest(f).degree == f.true_degree
    assert lowest(f)(mpq(2, 3), mpq(1, 5)) == f(mpq(2, 3), mpq(1, 5))


def test_a_zero_of_two_components_alone_is_no_singular_point(monkeypatch):
    """Of the normal (f, g, h) with f = g = 0 at the middle, whether h vanishes there decides."""
    surface = example("monkey_saddle")
    normal = [PatchForm.of_net([[-1, -1], [1, 1]]), PatchForm.of_net([[-1, 1], [-1, 1]]), None]
    for verdict, count, left in ((True, 1, 0), (False, 0, 0), (None, 0, 1)):
        monkeypatch.setattr(singular, "_is_singular", lambda zero, components, third, told=verdict: told)
        found, undecided = singular._inner(SurfaceForms(surface), (0, 0), normal, UNIT)
        assert (len(found), len(undecided)) == (count, left)


def test_boxes_that_touch_are_one_cluster():
    """Of boxes in two groups, each of which touches in a chain."""

    def box(a, b):
        return Box(Interval(mpq(a), mpq(a + 1)), Interval(mpq(b), mpq(b + 1)))

    near, far = [box(0, 0), box(2, 1), box(1, 0)], [box(7, 7), box(8, 8)]
    for boxes in ([near[0], far[0], *near[1:], far[1]], [far[1], *near, far[0]]):
        assert sorted(hull for hull, _ in clusters(boxes)) == [((0, 3), (0, 2)), ((7, 9), (7, 9))]
    assert sorted(hull for hull, _ in clusters([near[0], *far])) == [near[0], ((7, 9), (7, 9))]
