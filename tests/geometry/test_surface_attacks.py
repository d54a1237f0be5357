"""Surfaces that a hostile reader would inspect: true answers, or an open box, never a wrong one."""

from fractions import Fraction

import pytest
from gmpy2 import mpq

from exactspline import NurbsSurface, analyse, example
from exactspline.bivariate.borders import Edge
from exactspline.display.answer_forms import surface_inspection_data
from tests.support.squares import parameters
from tests.support.surface_oracle import gaussian_curvature

# ---- patches are those of the surface, also where forms have no knot


PLAIN = ["hyperbolic_paraboloid", "monkey_saddle", "paraboloid", "enneper", "cross_cap", "developable"]


@pytest.mark.parametrize(("raised", "at"), [(2, mpq(1, 3))])
@pytest.mark.parametrize("name", PLAIN)
def test_knots_of_raised_degrees_change_nothing(name, raised, at):
    """A raised degree leaves knots behind across which everything is smooth: forms of a lower degree lose them."""
    surface = example(name)
    (a, b), (c, d) = surface.domain
    cut = surface.elevate_degree(raised, raised)
    cut = cut.insert_knot("u", a + (b - a) * at).insert_knot("v", (c + 2 * d) / 3)
    found, plain = analyse(cut), analyse(surface)
    assert found.complete
    assert len(found.patches) == 4 * len(plain.patches)
    assert {joint.kind for joint in found.joints} == {"continuous curvature"}
    assert [one.place.exact for one in found.umbilics] == [one.place.exact for one in plain.umbilics]
    assert [place.exact for place in found.singular_points] == [place.exact for place in plain.singular_points]
    assert set(plain.kinds) <= set(found.kinds)
    strict = {"elliptic except at parabolic points": "elliptic", "hyperbolic except at parabolic points": "hyperbolic"}
    assert {strict.get(kind, kind) for kind in found.kinds} == {strict.get(kind, kind) for kind in plain.kinds}


def test_patches_of_a_planar_map_that_is_less_than_its_degree():
    surface = example("planar_map").elevate_degree(2, 2).insert_knot("u", "1/2").insert_knot("v", "1/2")
    assert analyse(surface).kind == "orientation kept: det > 0"
    u, v = parameters(-1, 1)
    shear = NurbsSurface.from_splines([u, v + u * u]).elevate_degree(1, 2).insert_knot("u", 0).insert_knot("v", 0)
    assert analyse(shear).kind == "orientation kept: det > 0"


def test_places_of_both_signs_are_where_the_determinant_has_them():
    """A folded patch, its negative corner at a knot behind which the map is the identity: at the knot itself the
    determinant is the one from the right.
    """
    net = [[(0, 0), (0, 1), (0, 1), (0, 2)], [(1, 0), (-1, 1), (1, 1), (1, 2)]]
    folded = NurbsSurface((1, 1), [0, 0, 1, 1], [0, 0, 1, 1, 2, 2], net)
    for surface in (folded, folded.transposed()):
        found = analyse(surface)
        assert found.kind == "folded: det has both signs"
        for place, sign in ((found.positive, 1), (found.negative, -1)):
            (a, b), (c, d) = surface.partial(1, 0, *place), surface.partial(0, 1, *place)
            assert (a * d - b * c) * sign > 0


# ---- points and curves without a tangent plane


def sphere(a, b):
    """The unit sphere by stereographic projection of a map of the plane."""
    return NurbsSurface.from_splines([2 * a, 2 * b, a * a + b * b - 1], a * a + b * b + 1)


def test_a_sphere_without_a_tangent_plane_in_the_middle_of_a_patch():
    u, v = parameters(-1, 1)
    folded = analyse(sphere(u * u * u, v))
    assert [(one.kind, one.radius_squared) for one in folded.patches] == [("spherical", 1)]
    assert folded.patches[0].singular.of_factor.along_curve
    branched = analyse(sphere(u * u - v * v, 2 * u * v))
    assert [(one.kind, one.radius_squared) for one in branched.patches] == [("spherical", 1)]
    assert [place.exact for place in branched.singular_points] == [(0, 0)]
    assert not branched.patches[0].singular.of_factor.along_curve


@pytest.mark.parametrize("height", [lambda a, b: 3 * a, lambda a, b: a * b])
def test_a_branch_point_is_a_point_and_no_curve(height):
    """The normal has the factor (u − 1/3)² + (v − 1/5)², whose only zero is a point."""
    u, v = parameters(-1, 1)
    s, t = u - mpq(1, 3), v - mpq(1, 5)
    a, b = s * s - t * t, 2 * s * t
    found = analyse(NurbsSurface.from_splines([a, b, height(a, b)]))
    assert [place.exact for place in found.singular_points] == [(mpq(1, 3), mpq(1, 5))]
    assert not surface_inspection_data(found, 5)["patches"][0]["singular_curve"]
    assert (found.umbilics.points, found.complete) == ((), True)


@pytest.mark.parametrize(
    ("bend", "kind", "corner"), [(1, "elliptic", True), (-1, "hyperbolic", True), (-1, "hyperbolic", False)]
)
def test_a_singular_point_is_no_parabolic_one(bend, kind, corner):
    """(p, pq, q² ± p² + …) near p = q = 0: K has one sign wherever there is a tangent plane."""
    u, v = parameters()
    p, q = (u + v, u - v) if corner else (u - mpq(1, 2), v - mpq(1, 2))
    found = analyse(NurbsSurface.from_splines([p, p * q, q * q + p * p * bend + p * p * p * bend / 9]))
    assert [place.exact for place in found.singular_points] == [(0, 0) if corner else (mpq(1, 2), mpq(1, 2))]
    signs = {(x > 0) - (x < 0) for x in curvatures(found.surface)}
    assert signs == {1 if kind == "elliptic" else -1}
    assert (found.kinds, found.complete) == ((kind,), True)


def curvatures(surface):
    """K at some points with a tangent plane, by the oracle."""
    places = [(Fraction(i, 7), Fraction(j, 7)) for i in range(8) for j in range(8)]
    return [x for place in places if (x := gaussian_curvature(surface, *place)) is not None]


# ---- umbilics


def bowl(profile, at=(0, 0)):
    """A graph over the square whose height depends on the distance from a point."""
    u, v = parameters(-1, 1)
    s, t = u - at[0], v - at[1]
    return NurbsSurface.from_splines([u, v, profile(s * s + t * t)])


@pytest.mark.parametrize("at", [(0, 0), (mpq(1, 3), mpq(1, 5))])
def test_a_single_umbilic_is_no_curve_of_umbilics(at):
    """z = r⁴ + r²: the curvatures of a surface of revolution, z″/(1 + z′²) and z′/r, are equal for r = 0 alone."""
    found = analyse(bowl(lambda square: square * square + square, at))
    assert [one.place.exact for one in found.umbilics] == [at]
    assert found.patches[0].umbilics.of_factor.curve is None
    assert not surface_inspection_data(found, 5)["patches"][0]["curve_of_umbilics"]
    assert found.complete


def test_a_circle_of_umbilics_that_leaves_the_patch_has_no_single_ones():
    """z = r⁴: the curvatures are equal where 16 r⁶ = 2; the circle crosses the edge u = 1 twice."""
    found = analyse(bowl(lambda square: square * square, (mpq(1, 3), mpq(1, 5))))
    assert [one.place.exact for one in found.umbilics] == [(mpq(1, 3), mpq(1, 5))]
    assert found.patches[0].umbilics.of_factor.curve is not None


def test_the_ends_of_an_edge_of_umbilics_are_no_single_ones():
    """z = (1 − v)³: a cylinder, both of whose curvatures vanish along v = 1."""
    u, v = parameters()
    edge = NurbsSurface.from_splines([u, v, (1 - v) * (1 - v) * (1 - v)])
    for surface in (edge, edge.insert_knot("u", "3/7")):
        found = analyse(surface)
        assert found.umbilics.points == ()
        assert len(found.umbilics.everywhere) == len(found.patches)
        assert all(one.umbilics.edges == (Edge(1, 1),) for one in found.patches)


# ---- parabolic lines


def strips(*heights):
    """A surface of strips over u from −1 to 1, each a cubic in u with these Bézier ordinates, plus v²."""
    n = len(heights)
    columns = [(mpq(-1) + mpq(2 * (3 * k + i), 3 * n), z) for k, own in enumerate(heights) for i, z in enumerate(own)]
    kept = [point for i, point in enumerate(columns) if i % 4 or i == 0]
    net = [[(x, mpq(y), mpq(z) + w) for y, w in ((0, 0), (mpq(1, 2), 0), (1, 1))] for x, z in kept]
    breaks = [mpq(-1) + mpq(2 * k, n) for k in range(n + 1)]
    knots = [breaks[0], *[t for t in breaks for _ in range(3)], breaks[-1]]
    return NurbsSurface((3, 2), knots, [0, 0, 0, 1, 1, 1], net)


def test_a_parabolic_line_seen_from_one_side_only():
    """z = u³ + v² for u ≤ 0 and u² + v² for u ≥ 0 have one tangent plane, but K = 0 on one side of u = 0 alone."""
    cubic, square = (-1, 0, 0, 0), (0, 0, mpq(1, 3), 1)
    found = analyse(strips(cubic, square))
    assert [(line.value, line.one_sided) for line in found.parabolic_lines] == [(0, True)]
    assert surface_inspection_data(found, 5)["parabolic_lines"][0]["one_sided"]
    both = analyse(strips(cubic, (0, 0, 0, 1)))
    assert [(line.value, line.one_sided) for line in both.parabolic_lines] == [(0, False)]
    # a cylinder behind: K = 0 on both sides
    flat = analyse(strips(cubic, (0, 0, 0, 0)))
    assert [(line.value, line.one_sided) for line in flat.parabolic_lines] == [(0, False)]
    assert all(not line.one_sided for line in analyse(example("torus")).parabolic_lines)
