"""Curves and points across patches: the same whatever knots cut them, and wherever a closed surface is cut open."""

from random import Random

import pytest
from gmpy2 import mpq

from exactspline import NurbsSurface, analyse, example
from tests.support.squares import graph, parameters


def shapes(found):
    return sorted(curve.shape for curve in found.parabolic_curves)


def pieces(found):
    return sum(len(curve.pieces) for curve in found.parabolic_curves)


def tube(shift, seed=5, count=5):
    """A tube, cubic with continuous curvature around, cut open at another knot for every shift."""
    random = Random(seed)
    ring = [(8, 0), (3, 7), (-6, 5), (-7, -4), (2, -8)]
    net = [[(x + random.randint(-2, 2), y + random.randint(-2, 2), 4 * j) for j in range(4)] for x, y in ring[:count]]
    rows = [net[(shift + i) % count] for i in range(count + 3)]
    return NurbsSurface((3, 3), list(range(count + 7)), [0] * 4 + [1] * 4, rows)


def test_where_a_closed_surface_is_cut_open_does_not_matter():
    found = [analyse(tube(shift)) for shift in range(3)]
    assert [one.closed[0].value for one in found] == ["u"] * 3
    assert all(one.complete for one in found)
    assert shapes(found[0]) == shapes(found[1]) == shapes(found[2])
    assert "arc that ends where patches meet" not in shapes(found[0])
    assert max(len(curve.patches) for curve in found[0].parabolic_curves) > 1
    arcs = [
        sorted(
            (ends is None, closed)
            for curve in one.parabolic_curves
            for ends, _, closed in curve.arcs(domain, one.closed)
        )
        for one, domain in zip(found, (tube(shift).domain for shift in range(3)), strict=True)
    ]
    assert arcs[0] == arcs[1] == arcs[2]


def test_where_the_curvature_jumps_the_curves_end():
    """Quadratic splines: K of one patch is not that of the next one on the knot between them."""
    random = Random(3)
    net = [[(i, j, random.randint(-3, 3)) for j in range(3)] for i in range(4)]
    found = analyse(NurbsSurface((2, 2), [0, 0, 0, 1, 2, 2, 2], [0, 0, 0, 1, 1, 1], net))
    assert "arc that ends where patches meet" in shapes(found)
    assert all(
        len(curve.patches) == 1 for curve in found.parabolic_curves if curve.shape == "arc that ends where patches meet"
    )


def test_ends_that_differ_are_not_joined():
    """The two halves of a cut surface, the second one moved: its curves end elsewhere on the border."""
    surface = example("bicubic")
    cut = surface.insert_knot("u", mpq(3, 5), 3)
    plain = analyse(cut)
    rows = [[p if i < 5 else (p[0], p[1], p[2] * 2) for p in row] for i, row in enumerate(cut.control_points)]
    bent = analyse(NurbsSurface(cut.degree, *cut.knots, rows))
    assert shapes(plain) == shapes(analyse(surface))
    assert shapes(bent) != shapes(plain)
    assert "arc that ends where patches meet" in shapes(bent)


# ---- single points beside curves


def power(x, n):
    return x if n == 1 else x * power(x, n - 1)


U, V = parameters()
A, B = U - mpq(1, 2), V - mpq(1, 2)
#: A third of v − 1/3 at both ends.
HEIGHTS = [(0, mpq(-1, 9)), (1, mpq(2, 9))]


@pytest.mark.parametrize(
    ("surface", "knots", "points"),
    [
        (graph(lambda u, v: power(u - v, 4)), "uv", []),
        (graph(lambda u, v: power(u + v - 1, 4)), "", []),
        (graph(lambda u, v: power(u * u - v, 3)), "uv", []),
        # on the line u = v the other factors vanish together at (1/2, 1/2)
        (graph(lambda u, v: power(u - v, 3) * (u + v - 1)), "", []),
        # a circle of umbilics about the middle, which touches the corners from outside
        (graph(lambda u, v: power(A * A + B * B, 2)), "uv", [(0, 0), (0, 1), (mpq(1, 2), mpq(1, 2)), (1, 0), (1, 1)]),
        # no tangent plane along u = v, and along v = 1/2
        (NurbsSurface.from_splines([U, power(V - U, 2), power(V - U, 3)]), "uv", []),
        (NurbsSurface.from_splines([U, power(B, 3) * mpq(1, 3) + A * B * B, A * B * B]), "", []),
    ],
)
def test_a_point_on_a_curve_of_any_patch_is_no_single_one(surface, knots, points):
    """Passed before: corners on curves of umbilics, also those that knots make, were told as single "multiple" umbilics
    beside them; so were corners on singular curves, and points inside at which the equations without the factor of the
    curve vanish.
    """
    for along in knots:
        surface = surface.insert_knot(along, mpq(1, 2))
    found = analyse(surface)
    assert sorted(one.place.exact for one in found.umbilics) == points
    assert found.singular_points.points == ()
    assert found.umbilics.undecided == found.singular_points.undecided == ()
    assert points or found.umbilics.everywhere or found.singular_points.everywhere


def test_a_point_on_an_edge_of_the_next_patch_is_no_single_one():
    """z = (u − 1)³ for u ≤ 1 is flat along u = 1, z = (u − 1)² (v − 1/3) behind it where v = 1/3: (1, 1/3) was told."""
    left = [[(mpq(i, 3), mpq(j), -1 if i == 0 else 0) for j in range(2)] for i in range(4)]
    right = [[(1 + mpq(i, 3), mpq(j), 0 if i < 2 else (i - 2) * 2 * h + h) for j, h in HEIGHTS] for i in range(4)]
    found = analyse(NurbsSurface((3, 1), [0] * 4 + [1] * 4 + [2] * 4, [0, 0, 1, 1], left + right))
    assert (found.umbilics.points, len(found.umbilics.everywhere)) == ((), 1)
