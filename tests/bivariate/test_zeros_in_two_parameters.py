"""Functions of two parameters: all their common zeros, and all zeros of one with their topology."""

from dataclasses import replace
from math import isqrt
from random import Random

import pytest
from gmpy2 import mpq

from exactspline import TensorSpline, common_zeros, intersections, zero_curve
from exactspline.bivariate import common_zeros as elimination
from exactspline.bivariate import zeros as zeros_in_two_parameters
from exactspline.bivariate.joined_curves import chained
from exactspline.bivariate.singular_points import sign_at_point, singular_on_patch
from exactspline.errors import DomainError, ReachError, ShapeError
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.polynomials.two_parameters import S, T, as_form
from tests.support.bisector_oracle import bezier
from tests.support.squares import function


def differences(first, second):
    m, n = first.degree, second.degree
    return [
        TensorSpline(
            (m, n),
            [0] * (m + 1) + [1] * (m + 1),
            [0] * (n + 1) + [1] * (n + 1),
            [[p[k] - q[k] for q in second.control_points] for p in first.control_points],
        )
        for k in (0, 1)
    ]


def places(found):
    return [(point.first, point.second) for point in found]


def test_two_crossings_that_a_kernel_merges():
    first, second = bezier((2, 8), (2, 3), (3, 0), (2, 5)), bezier((2, 2), (8, 8), (5, 8), (10, 8))
    zeros = common_zeros(*differences(first, second))
    assert sorted(point.first.decimal(6) for point in zeros) == ["0.612913", "0.671842"]
    assert [point.multiplicity for point in zeros] == [1, 1]
    assert zeros.undecided == ()


def test_common_zeros_of_differences_are_the_intersections():
    """By Bézout's matrix and by elimination in two parameters: the same numbers, the same multiplicities."""
    count = 0
    for seed in range(14):
        random = Random(seed)
        points = [[(random.randint(-4, 4), random.randint(-4, 4)) for _ in range(4)] for _ in range(2)]
        if seed % 2:
            points[1][0] = points[0][0]
        if seed % 4 == 3:
            points[1][1] = points[0][1]
        first, second = (bezier(*own) for own in points)
        found, zeros = intersections(first, second), common_zeros(*differences(first, second))
        assert places(found) == places(zeros)
        assert [x.multiplicity for x in found] == [x.multiplicity for x in zeros]
        count += len(zeros)
    assert count > 14


def test_what_vanishes_along_curves_is_said():
    factor = function(lambda s, t: s * s + t * t - mpq(3, 4))
    point = function(lambda s, t: (2 * s - 1) ** 2 + (3 * t - 1) ** 2)
    f, g = function(lambda s, t: s - t), function(lambda s, t: 3 * s - 1)
    found = common_zeros(factor * f, factor * g)
    assert places(found) == [(mpq(1, 3), mpq(1, 3))]
    assert [str(part) for part in found.everywhere] == ["a curve in [0, 1] × [0, 1]"]
    found = common_zeros(point * f, point * g)
    assert places(found) == [(mpq(1, 3), mpq(1, 3)), (mpq(1, 2), mpq(1, 3))]
    assert [x.multiplicity for x in found] == [1, None]
    assert found.everywhere == ()
    edge = function(lambda s, t: s)
    found = common_zeros(edge * f, edge * g)
    assert [str(part) for part in found.everywhere] == ["[0, 0] × [0, 1]"]
    assert places(found) == [(mpq(1, 3), mpq(1, 3))]
    nothing = f - f
    assert [str(part) for part in common_zeros(nothing, nothing).everywhere] == ["[0, 1] × [0, 1]"]


def test_a_zero_at_a_crossing_of_knot_lines_is_one():
    knots = [0, 0, 1, 2, 2]
    f = TensorSpline((1, 1), knots, knots, [[-2, -1, 0], [-1, 0, 1], [0, 1, 3]])
    g = TensorSpline((1, 1), knots, knots, [[0, -1, -2], [1, 0, -1], [2, 1, 0]])
    (point,) = common_zeros(f, g)
    assert (point.first, point.second, point.multiplicity, len(point.patches)) == (1, 1, 1, 4)
    assert [own.shape.value for own in zero_curve(f).curves] == ["arc from border to border"]
    assert len(zero_curve(f).curves[0].patches) == 4


@pytest.mark.parametrize(
    ("p", "shown"),
    [
        (lambda s, t: (2 * s - 1) ** 2 + (2 * t - 1) ** 2 - mpq(1, 2), "closed loop"),
        (lambda s, t: (2 * s - 1) ** 2 - (3 * t - 1) ** 2, "branches that cross"),
        (lambda s, t: (2 * s - 1) ** 3 - (2 * t - 1) ** 2, "arc from border to border"),
        (lambda s, t: (2 * s * s - 1) ** 2 + (3 * t * t - 1) ** 2, "<zero at √2/2 and √3/3>"),
        (lambda s, t: s * s + t * t, "<zero at 0 and 0>"),
        (lambda s, t: s * (s * s + t * t), "a line"),
        (lambda s, t: (2 * s - 1) * ((2 * s - 1) ** 2 + (2 * t - 1) ** 2), "a line"),
        (lambda s, t: (2 * s * s - 1) * (3 * t - s - 1), "a line, arc from border to border"),
        (lambda s, t: s * s + t * t + 1, "nowhere"),
    ],
)
def test_zeros_of_one_function(p, shown):
    found = zero_curve(function(p))
    assert repr(found) == shown
    assert found.complete
    assert bool(found) == (shown != "nowhere")


def around(p):
    """A polynomial in x and y on the square from −2 to 2."""
    return function(lambda s, t: p(4 * s - 2, 4 * t - 2))


@pytest.mark.parametrize(
    ("p", "shape", "kind", "milnor"),
    [
        (lambda x, y: x**2 * (x + 1) - y**2, "branches that cross", "node", 1),
        (lambda x, y: (x * x + y * y) ** 2 - 2 * (x * x - y * y), "branches that cross", "node", 1),  # lemniscate
        (lambda x, y: x**3 - y**2, "arc from border to border", "cusp", 2),
        (lambda x, y: y * y - x**5, "arc from border to border", "cusp", 4),
        (lambda x, y: x**4 - y**2, "branches that cross", "tacnode", 3),
        (lambda x, y: x**6 - y**2, "branches that cross", "tacnode", 5),
        (lambda x, y: x**4 + y**2, None, "isolated point", 3),
        (lambda x, y: x**2 * (x - 1) - y**2, "arc from border to border", "isolated point", 1),  # acnode
    ],
)
def test_double_points_of_known_curves(p, shape, kind, milnor):
    found = zero_curve(around(p))
    (point,) = found.singular_points
    assert (point.first, point.second, str(point.kind), point.multiplicity) == (mpq(1, 2), mpq(1, 2), kind, 2)
    assert point.milnor == milnor
    assert [curve.shape.value for curve in found.curves] == [shape] * (shape is not None)


@pytest.mark.parametrize(
    ("p", "times"),
    [
        (lambda x, y: (x * x + y * y) ** 2 - x * (x * x - 3 * y * y), 3),  # three leaves
        (lambda x, y: y**3 - x**4, 3),
        (lambda x, y: x * y * (x - y) * (x + 2 * y), 4),
    ],
)
def test_points_of_higher_multiplicity(p, times):
    (point,) = zero_curve(around(p)).singular_points
    assert (str(point.kind), point.multiplicity, point.milnor) == ("multiple point", times, None)
    assert repr(point) == f"<multiple point at 1/2 and 1/2, multiplicity {times}>"


def test_four_leaves():
    """The multiple point of (x² + y²)³ = 4 x² y², and those of a circle, a line, and a point on the circle."""
    leaves = as_form((S * S + T * T) ** 3 - 4 * S * S * T * T)
    assert [found[1:] for found in singular_on_patch(leaves, UNIT, ())] == [("multiple point", 4, None)]
    x, y = 2 * S - 1, 2 * T - 1
    more = as_form((x * x + y * y - 1) * (x * x + (y - 1) ** 2) * (x - y))
    found = [(str(kind), order) for _, kind, order, _ in singular_on_patch(more, UNIT, ())]
    assert sorted(found) == [("multiple point", 3), ("node", 2), ("node", 2)]


def test_singular_points_at_irrational_places_and_of_multiple_factors():
    cusps = zero_curve(function(lambda s, t: ((2 * s * s - 1) ** 3 - (3 * t * t - 1) ** 2) ** 2))
    (cusp,) = cusps.singular_points
    assert (str(cusp.kind), cusp.first.minimal_polynomial()) == ("cusp", [-1, 0, 2])
    (crossing,) = zero_curve(function(lambda s, t: (2 * s * s - 1) ** 2 * (t - s))).singular_points
    assert (str(crossing.kind), crossing.first == crossing.second) == ("node", True)
    assert zero_curve(function(lambda s, t: s * s + t * t - 1)).singular_points == ()


def test_a_singular_point_at_a_knot():
    """x y has its node at a knot of both parameters; with another slope on one patch it is still one on all of them."""
    knots = [0, 0, 1, 2, 2]
    same = zero_curve(TensorSpline((1, 1), knots, knots, [[1, 0, -1], [0, 0, 0], [-1, 0, 1]]))
    (node,) = same.singular_points
    assert (node.first, node.second, str(node.kind), len(node.patches)) == (1, 1, "node", 4)
    wide = [0, 0, 0, 1, 1, 2, 2, 2]
    p, q = (
        TensorSpline((2, 0), wide, [0, 2], [[1], [0], [0], [0], [1]]),
        TensorSpline((0, 2), [0, 2], wide, [[1, 0, 0, 0, 2]]),
    )
    turned = TensorSpline((2, 0), wide, [0, 2], [[1], [0], [0], [0], [-1]])
    assert [str(x.kind) for x in zero_curve(p + q).singular_points] == ["isolated point"]
    (mixed,) = zero_curve(turned + q).singular_points
    assert (str(mixed.kind), mixed.multiplicity, mixed.milnor) == ("at a knot", 2, None)


def test_an_arc_from_the_border_that_ends_at_a_jump_is_broken():
    f = TensorSpline((1, 1), [0, 0, 1, 1, 2, 2], [0, 0, 1, 1], [[-1, 2], [-2, 1], [1, 1], [1, 1]])
    (curve,) = zero_curve(f).curves
    assert curve.shape == "arc that ends where patches meet"
    with pytest.raises(ReachError, match="something is undecided"):
        type(zero_curve(f))().certificate()


def test_a_line_on_a_knot_may_be_one_from_one_side():
    """At s = 1 the function jumps: it vanishes there from the left, or from both sides."""
    for right, one_sided in (([1, 2], True), ([-1, 2], True), ([0, 0], False)):
        f = TensorSpline((1, 1), [0, 0, 1, 1, 2, 2], [0, 0, 1, 1], [[1, 1], [0, 0], right, [1, 1]])
        (line,) = zero_curve(f).lines
        assert (line.value, line.one_sided) == (1, one_sided)


#: The size of the numbers of a place: small fractions, and the doubles next to them.
DIALS = {"small": lambda x: x, "doubles": lambda x: mpq(float(x) * 1.0000000000000002)}


@pytest.mark.parametrize("dial", DIALS)
@pytest.mark.parametrize(
    ("f", "g", "kind", "times", "contact"),
    [
        (lambda x, y: x + y * y, lambda x, y: y - x * x, "transversal", 1, 0),
        (lambda x, y: y - x * x, lambda x, y: y, "touching", 2, 1),
        (lambda x, y: y - x**3, lambda x, y: y + y * x, "touching", 3, 2),
        (lambda x, y: y - x * x, lambda x, y: y - x * x - x**4 + y**3, "touching", 4, 3),
        (lambda x, y: x * x - y * y, lambda x, y: x + 2 * y, "multiple", 2, None),  # a node and a line
        (lambda x, y: x * x - y * y, lambda x, y: x - y + x * x, "multiple", 3, None),  # touching one of its branches
        (lambda x, y: y * y - x**3, lambda x, y: x * x - y**3, "multiple", 4, None),  # two cusps
        (lambda x, y: x * x + y * y, lambda x, y: x, "multiple", 2, None),
    ],
)
def test_kinds_of_common_zeros(f, g, kind, times, contact, dial):
    """Said before: only the multiplicity, so that a node on a line and two curves that touch were alike."""
    a, b = (DIALS[dial](x) for x in (mpq(1, 3), mpq(2, 5)))
    zeros = common_zeros(*(function(lambda s, t, p=p: p(s - a, t - b)) for p in (f, g)))
    (point,) = [x for x in zeros if (x.first, x.second) == (a, b)]
    assert (point.kind, point.multiplicity, point.contact, point.where) == (kind, times, contact, "inside a patch")
    more = common_zeros(*(function(lambda s, t, p=p: p(s - a, t - b)) for p in (f, g, f)))
    (point,) = [x for x in more if (x.first, x.second) == (a, b)]
    assert (point.kind, point.multiplicity) == (kind, 1 if times == 1 else None)


def test_where_common_zeros_are():
    f, g = function(lambda s, t: s * (s - 1) * t), function(lambda s, t: (s - t) * (2 * t - 1))
    assert [(x.place, str(x.where), str(x.kind), x.multiplicity) for x in common_zeros(f, g)] == [
        ((0, 0), "at a corner", "multiple", 2),
        ((0, mpq(1, 2)), "on the border", "transversal", 1),
        ((1, mpq(1, 2)), "on the border", "transversal", 1),
        ((1, 1), "at a corner", "transversal", 1),
    ]
    assert common_zeros(f, g)[1].box(5) == ((0, 0), (mpq(1, 2), mpq(1, 2)))
    knots = [0, 0, 0, 1, 1, 2, 2, 2]
    bent = TensorSpline((2, 0), knots, [0, 2], [[1], [0], [0], [0], [4]])  # (s − 1)² and 4 (s − 1)²
    line = TensorSpline((0, 1), [0, 2], [0, 0, 2, 2], [[-1, 1]])
    (point,) = common_zeros(bent, line)
    assert (str(point.where), str(point.kind), point.multiplicity) == ("on a knot line", "multiple", 2)
    turned = TensorSpline((2, 0), knots, [0, 2], [[1], [0], [0], [1], [2]])
    (point,) = common_zeros(turned, line)
    assert (str(point.kind), point.multiplicity) == ("different on patches that meet", 1)


@pytest.mark.parametrize(
    ("p", "ends"),
    [
        (lambda x, y: x * x + y * y - 1, [None]),
        (lambda x, y: x**2 * (x + 1) - y**2, [("border", "node"), ("border", "node"), ("node", "node")]),
        (lambda x, y: (x * x + y * y) ** 2 - 2 * (x * x - y * y), [("node", "node")] * 2),
        (lambda x, y: x**3 - y**2, [("border", "cusp")] * 2),
        (lambda x, y: x**4 - y**2, [("border", "tacnode")] * 4),
        (lambda x, y: (x * x + y * y) ** 2 - x * (x * x - 3 * y * y), [("multiple point", "multiple point")] * 3),
        (lambda x, y: x**2 * (x - 1) - y**2, [("border", "border")]),
        (lambda x, y: (x * x - 2 * y * y) * (y - 3 * x - 1), [("border", "node")] * 6 + [("node", "node")] * 3),
    ],
)
def test_arcs_between_singular_points(p, ends):
    found = zero_curve(around(p))
    kinds = {(x.first, x.second): str(x.kind) for x in found.singular_points}

    def end(place):
        return kinds.get(place, "border")

    arcs = [None if arc.closed else tuple(sorted(map(end, (arc.start, arc.end)))) for arc in found.arcs]
    assert sorted(arcs, key=str) == sorted(ends, key=str)


@pytest.mark.parametrize(
    ("p", "ends"),
    [
        (lambda s, t: (2 * t - 1 - s) * (2 * t - 1 + s), [(0, mpq(1, 2))] * 2),  # a node
        (lambda s, t: (2 * t - s) * (2 * s - t), [(0, 0)] * 2),
        (lambda s, t: (2 * t - 1) ** 2 - s**3, [(0, mpq(1, 2))] * 2),  # a cusp
        (lambda s, t: 1 - t - (2 * s - 1) ** 2, [(mpq(1, 2), 1)] * 2),  # touches the border
    ],
)
def test_arcs_end_on_the_border(p, ends):
    """An arc ran through a point on the border at which two arcs meet, singular or not."""
    assert [end for arc in zero_curve(function(p)).arcs for end in (arc.start, arc.end) if end in ends] == ends


def test_arcs_end_in_a_cusp_on_a_knot_line():
    """An arc ran through it."""
    knots = [0, 0, 1, 2, 2]
    s = TensorSpline((1, 0), knots, [0, 2], [[0], [1], [2]])
    t = TensorSpline((0, 1), [0, 2], knots, [[0, 1, 2]])
    found = zero_curve((t - 1) ** 2 - (s - 1) ** 3)
    assert [(x.start, x.end) for x in found.arcs] == [((2, 0), (1, 1)), ((1, 1), (2, 2))]
    assert [str(x.kind) for x in found.singular_points] == ["cusp"]


def test_arcs_run_on_over_knots():
    """A circle around a crossing of knot lines is one loop; a node on a knot line has four arcs."""
    knots = [0, 0, 0, 1, 1, 2, 2, 2]
    circle = TensorSpline((2, 0), knots, [0, 2], [[2], [0], [0], [0], [2]])
    circle = circle + TensorSpline((0, 2), [0, 2], knots, [[2, 0, 0, 0, 2]])
    (arc,) = zero_curve(circle - TensorSpline((0, 0), [0, 2], [0, 2], [[1]])).arcs
    assert arc.closed
    cross = TensorSpline((1, 1), [0, 0, 1, 2, 2], [0, 0, 2, 2], [[1, -1], [-1, -1], [-3, -1]])
    assert [(arc.start[0], arc.end[0]) for arc in zero_curve(cross).arcs] == [(mpq(0), mpq(1, 2))]


def test_what_is_refused():
    f = function(lambda s, t: s - t)
    with pytest.raises(ShapeError, match="where a function of two parameters is expected"):
        zero_curve(bezier((0, 0), (1, 1)))
    with pytest.raises(DomainError):
        common_zeros(f, function(lambda s, t: s - t, high=2))


def test_what_is_out_of_reach_is_undecided(monkeypatch):
    f, g = function(lambda s, t: 2 * s * s - t - mpq(1, 3)), function(lambda s, t: 2 * t * t - s - mpq(1, 5))
    assert len(common_zeros(f, g)) == 1
    monkeypatch.setattr(zeros_in_two_parameters, "QUESTION", 0)
    found = common_zeros(f, g)
    assert (len(found), bool(found), len(found.undecided)) == (0, True, 1)


def test_a_zero_of_what_remains_on_a_common_line_is_no_single_one():
    """A mutant passed: (1/2, 1/2) as a point beside the line s = 1/2, on which it is."""
    found = common_zeros(function(lambda s, t: (2 * s - 1) * (t - s)), function(lambda s, t: (2 * s - 1) * (t + s - 1)))
    assert (found.points, len(found.everywhere)) == ((), 1)


def test_a_point_on_a_patch_that_vanishes_is_no_single_one():
    """On the other side of a jump: (s − 1)² + (2t − 1)², beside a patch on which the function is zero."""
    knots = [0, 0, 0, 1, 1, 1, 2, 2, 2]
    sides = TensorSpline((2, 2), knots, [0, 0, 0, 1, 1, 1], [*[[0, 0, 0]] * 3, [1, -1, 1], [1, -1, 1], [2, 0, 2]])
    found = zero_curve(sides)
    assert (found.points, found.curves, [str(part) for part in found.everywhere]) == ((), (), ["[0, 1] × [0, 1]"])
    turned = TensorSpline((2, 2), knots, [0, 0, 0, 1, 1, 1], [[2, 0, 2], [1, -1, 1], [1, -1, 1], *[[1, 1, 1]] * 3])
    assert places(zero_curve(turned).points) == [(1, mpq(1, 2))]


# ---- what does not depend on how functions are given

PAIRS = [
    (lambda s, t: 2 * s * s + t - 1, lambda s, t: 3 * t * t - s),
    (lambda s, t: (2 * s - 1) ** 2 - t * t, lambda s, t: (2 * s - 1) * (3 * t - s)),  # on the border, at 1/2
    (lambda s, t: (s - t) * (2 * t - 1), lambda s, t: s * (s - 1) * t),
    (lambda s, t: (3 * s - 1) ** 2 - (2 * t - 1) ** 3, lambda s, t: (3 * s - 1) ** 3 - (2 * t - 1) ** 2),
    (lambda s, t: (s + t - 1) * (2 * s * s - 1), lambda s, t: (s + t - 1) * (t - s)),  # on a curve
    (lambda s, t: (2 * s - 1) * (s - t), lambda s, t: (2 * s - 1) * (3 * t - 1)),  # on a line
    (lambda s, t: s * (2 * s - t), lambda s, t: s * (s + t - 1)),  # on an edge
    (lambda s, t: ((2 * s - 1) ** 2 + t * t) * (t - s), lambda s, t: ((2 * s - 1) ** 2 + t * t) * (3 * t - 1)),
]


def facts(found):
    return [(x.first, x.second, x.multiplicity, x.kind, x.where) for x in found]


@pytest.mark.parametrize(("p", "q"), PAIRS)
def test_common_zeros_of_exchanged_stretched_and_divided_functions(p, q):
    """The parameters exchanged; other domains; knots where there is none; multiples of one and of both."""
    f, g = function(p), function(q)
    found = common_zeros(f, g)
    assert facts(common_zeros(g, f)) == facts(found)
    assert facts(common_zeros(f.scaled(mpq(-3, 7)), g.scaled(2))) == facts(found)
    assert places(common_zeros(f, g, f + g)) == places(found)
    turned = common_zeros(f.transposed(), g.transposed())
    exchanged = [(x.second, x.first, x.multiplicity, x.kind, x.where) for x in turned]
    assert sorted(exchanged, key=lambda x: x[:2]) == facts(found)
    assert len(turned.everywhere) == len(found.everywhere)
    stretched = common_zeros(
        *(function(lambda s, t, r=r: r(s.scaled(mpq(1, 3)), t.scaled(mpq(1, 3))), 0, 3) for r in (p, q))
    )
    assert [(x / 3, y / 3, *rest) for x, y, *rest in facts(stretched)] == facts(found)
    for at in (mpq(3, 7), mpq(1, 2)):
        cut = common_zeros(*(h.insert_knot(0, at).insert_knot(1, mpq(4, 9)) for h in (f, g)))
        assert places(cut) == places(found)
        for one, other in zip(found, cut, strict=True):
            assert (one.multiplicity, one.kind) == (other.multiplicity, other.kind)
            assert len(other.patches) == 1 + (other.first == at)
        whole = {(part.sides, part.along_curve) for part in cut.everywhere}
        assert bool(whole) == bool(found.everywhere)
        # the edges are those of all patches together
        edges = [part.sides for part in found.everywhere if not part.along_curve]
        assert sum(len(set(map(tuple, sides))) > 1 for sides, along in whole if not along) >= len(edges)


@pytest.mark.parametrize("is_turned", [False, True])
def test_isolated_points_of_a_common_factor_on_its_lines(is_turned):
    """One on the line is part of it; one at another place is not."""
    f, g = function(lambda s, t: s + t - 3), function(lambda s, t: 2 * s + t - 4)
    for a, points in ((mpq(1, 2), []), (mpq(1, 3), [(mpq(1, 3), mpq(1, 5))])):
        shared = function(lambda s, t, a=a: (2 * s - 1) * ((s - a) ** 2 + (5 * t - 1) ** 2))
        found = common_zeros(*((shared.transposed() if is_turned else shared) * h for h in (f, g)))
        assert places(found) == [place[::-1] if is_turned else place for place in points]
        assert [part.sides[is_turned] for part in found.everywhere] == [(mpq(1, 2), mpq(1, 2))]


def test_signs_at_points_that_are_all_but_zeros():
    """√(1/2) and √(1/3), and lines that pass them in the hundredth digit."""
    (zero,) = elimination.common_zeros([2 * S * S - 1, 3 * T * T - 1], UNIT)
    for digits in (3, 20, 100):
        one, other = isqrt(10 ** (2 * digits) // 2), isqrt(10 ** (2 * digits) // 3)
        assert [sign_at_point(10**digits * S - one - k, zero) for k in (0, 1)] == [1, -1]
        assert [sign_at_point(10**digits * T - other - k, zero) for k in (0, 1)] == [1, -1]
    # much smaller than the coefficients
    assert {sign_at_point((1000 * S - 707) ** k, zero) for k in range(30, 45)} == {1}


def test_a_curve_that_ends_at_an_undecided_box_of_the_next_patch_is_open():
    """It said: it ends on the border, or where patches meet."""
    line = TensorSpline((0, 1), [0, 2], [0, 0, 2, 2], [[-1, 1]])
    f = line + TensorSpline((1, 0), [0, 0, 1, 2, 2], [0, 2], [[mpq(-1, 2)], [0], [mpq(1, 2)]])
    (whole,) = zero_curve(f).curves
    assert (whole.shape, len(whole.pieces)) == ("arc from border to border", 2)
    for box, shape in (
        (Box(Interval(mpq(1), mpq(2)), Interval(mpq(1), mpq(2))), "arc into an undecided box"),
        (Box(Interval(mpq(1), mpq(2)), Interval(mpq(3, 2), mpq(2))), "arc that ends where patches meet"),
    ):
        (one,) = chained(whole.pieces[:1], f.domain, (), [box])
        assert one.shape == shape
        (both,) = chained(whole.pieces, f.domain, (), [box])
        assert both.shape == (
            "arc into an undecided box" if shape == "arc into an undecided box" else "arc from border to border"
        )
    for shape in ("arc into an undecided box", "branches that cross"):
        first, second = whole.pieces
        for pieces in ([first._replace(part=replace(first.part, shape=shape)), second], whole.pieces):
            (both,) = chained(pieces, f.domain, ())
            assert both.shape == ("arc from border to border" if pieces is whole.pieces else shape)


def test_three_arcs_that_meet_on_a_knot_line_cross():
    """One on the left, two on the right, where the function jumps but its zeros do not."""
    left = [[mpq(4 * j + i, 4) for j in (-1, 0, 1)] for i in (-2, -1, 0)]  # t − 1 + (s − 1)/2
    right = [[1, -1, 1], [1, -1, 1], [0, -2, 0]]  # (t − 1)² − (s − 1)²
    found = zero_curve(TensorSpline((2, 2), [0] * 3 + [1] * 3 + [2] * 3, [0] * 3 + [2] * 3, left + right))
    (crossed,) = found.curves
    assert (crossed.shape, [piece.part.shape for piece in crossed.pieces]) == (
        "branches that cross",
        ["arc from border to border", "arc from border to border"],
    )
    assert [{arc.start, arc.end} for arc in found.arcs].count({(1, 1), (0, mpq(3, 2))}) == 1
    assert len(found.arcs) == 3


#: Two segments over [0, 2], and those with jumps between them.
TWO, TORN = [0, 0, 1, 2, 2], [0, 0, 1, 1, 2, 2]
#: x² of x = s − 1, on both sides of a knot that is simple for it, or with the other sign on the left.
SQUARE, TURNED = ([[1], [0], [0], [0], [1]], [[-1], [0], [0], [0], [1]])
WIDE = [0, 0, 0, 1, 1, 2, 2, 2]


@pytest.mark.parametrize(
    ("f", "multiplicity", "patches", "arcs"),
    [
        # on every patch a straight line to the corner (1, 1), along its diagonal
        (TensorSpline((1, 1), TWO, TWO, [[0, 1, 0], [-1, 0, -1], [0, 1, 0]]), 1, 4, 4),
        # (t − 1)² = |s − 1|: two parabolas with one vertex
        (
            TensorSpline((0, 2), [0, 2], [0, 0, 0, 2, 2, 2], [[1, -1, 1]])
            - TensorSpline((1, 0), TWO, [0, 2], [[1], [0], [1]]),
            1,
            2,
            4,
        ),
        # |s − 1| for t ≤ 1, from there on |s − 1| − (t − 1): one curve runs by the end of a line
        (TensorSpline((1, 1), TWO, TWO, [[1, 1, 0], [0, 0, -1], [1, 1, 0]]), 1, 4, 1),
        # x² − y² on the right of the knot line, −x² − y² on the left
        (
            TensorSpline((2, 0), WIDE, [0, 2], TURNED) - TensorSpline((0, 2), [0, 2], [0, 0, 0, 2, 2, 2], [[1, -1, 1]]),
            2,
            2,
            2,
        ),
        # x y on the right, 1 + x on the left: no zero of that
        (TensorSpline((1, 1), TORN, [0, 0, 2, 2], [[1, 1], [2, 2], [0, 0], [-1, 1]]), 2, 1, 0),
    ],
)
def test_branches_of_several_patches_that_meet_are_singular_points(f, multiplicity, patches, arcs):
    """In no list of singular points before, or as nodes, if they were nodes on one of the patches."""
    found = zero_curve(f)
    (point,) = found.singular_points
    assert (str(point.kind), point.multiplicity, point.milnor) == ("at a knot", multiplicity, None)
    assert (point.first, point.second) == (1, 1)
    assert (len(point.patches), len(found.arcs)) == (patches, arcs)


def test_the_border_of_a_patch_on_which_all_vanishes_is_no_line():
    """It was one: 0 for s ≤ 1, then s − 1. Of a line that runs on beside other patches that part is left."""
    found = zero_curve(TensorSpline((1, 1), TWO, [0, 0, 2, 2], [[0, 0], [0, 0], [1, 2]]))
    assert (found.lines, [str(part) for part in found.everywhere]) == ((), ["[0, 1] × [0, 2]"])
    longer = zero_curve(TensorSpline((1, 1), TWO, TWO, [[0, 0, 1], [0, 0, 0], [1, 1, 2]]))
    assert [(line.value, line.interval, line.one_sided) for line in longer.lines] == [(1, (1, 2), False)]


def test_a_corner_on_a_line_of_common_zeros_is_no_single_one():
    """(1/2, 1/2) was one, as seen from the two patches off the line s = t."""
    f, g = function(lambda s, t: (s - t) * (s + t + 1)), function(lambda s, t: (s - t) * (s - 2 * t + 3))
    for count in (1, 4):
        found = common_zeros(f, g)
        assert (found.points, found.undecided) == ((), ())
        assert len({part.patch for part in found.everywhere}) == (1 if count == 1 else 2)
        f, g = (h.insert_knot(0, mpq(1, 2)).insert_knot(1, mpq(1, 2)) for h in (f, g))
