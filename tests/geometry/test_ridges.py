"""Ridges, held against the derivative of each principal curvature along its own direction: a difference quotient to
sixty digits of the eigenvalues of the shape operator of `tests.support.surface_oracle`, which knows no forms of ridges.
"""

import pickle
from functools import cache
from itertools import pairwise
from math import hypot
from random import Random

import pytest
from gmpy2 import mpq
from mpmath import mp, mpf

from exactspline import NurbsSurface, analyse, example
from exactspline.geometry.surfaces import ridges
from exactspline.numbers.exact import sign
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.polynomials.cost import Budget, drawing_on
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.polynomials.two_parameters import S, T, as_form, as_polynomial, at
from exactspline.roots.of_polynomials import roots_in
from tests.support.command import run
from tests.support.sampled import FULL
from tests.support.surface_oracle import shape_operator
from tests.support.vectors import mpf_of

STEP = mpf(10) ** -20
#: Half the distance of two points on both sides of a ridge.
NEAR = mpq(1, 1 << 12)


def principal(surface, place):
    """Both principal curvatures in order, each with its direction in the parameters."""
    rows, area = shape_operator(surface, *place, mp.mpmathify)
    a, b, c, d = (x / mp.sqrt(area) for x in rows)
    root = mp.sqrt((a - d) ** 2 + 4 * b * c)
    found = []
    for k in ((a + d - root) / 2, (a + d + root) / 2):
        p, q = max([(b, k - a), (k - d, c)], key=lambda way: mp.hypot(*way))
        found.append((k, (p / mp.hypot(p, q), q / mp.hypot(p, q))))
    return found


def slopes(surface, place, before=((1, 0), (1, 0))):
    """The derivatives of both curvatures along their directions, each in the sense of the one `before`."""
    found, ways = [], []
    for k, (_, (p, q)) in enumerate(principal(surface, place)):
        way = (p, q) if p * before[k][0] + q * before[k][1] > 0 else (-p, -q)
        ahead, behind = (
            principal(surface, [x + step * t for x, t in zip(place, way, strict=True)])[k][0] for step in (STEP, -STEP)
        )
        ways.append(way)
        found.append(ahead - behind if abs(ahead - behind) > STEP**2 else 0)
    return found, ways


def as_mpf(place):
    return [mpf_of(x) for x in place]


def changes(surface, start, end):
    """How many of the two derivatives change their signs between two near points."""
    first, ways = slopes(surface, as_mpf(start))
    second, _ = slopes(surface, as_mpf(end), ways)
    return sum(x * y < 0 for x, y in zip(first, second, strict=True))


def generic(seed, m, n, weights=0):
    """A patch with random heights, and weights up to a number."""
    random = Random(seed)
    net = [
        [[4 * i + random.randint(-1, 1), 4 * j + random.randint(-1, 1), random.randint(-6, 6)] for j in range(n + 1)]
        for i in range(m + 1)
    ]
    own = [[random.randint(1, weights) for _ in range(n + 1)] for _ in range(m + 1)] if weights else None
    return NurbsSurface((m, n), [0] * (m + 1) + [1] * (m + 1), [0] * (n + 1) + [1] * (n + 1), net, own)


@cache
def a_node():
    """A surface whose ridges have a node, with its answers."""
    return analyse(generic(2, 3, 1))


def beside(place, direction, by):
    """The two points on both sides of another one."""
    return [tuple(x + by * side * (k == direction) for k, x in enumerate(place)) for side in (-1, 1)]


def see_that_all_are_ridges(found, surface):
    """Across every arc one of the derivatives changes its sign."""
    for curve in found.curves:
        for piece in curve.pieces:
            for arc in piece.part.arcs:
                place = piece.sides.at(*piece.curve.points(arc, 2)[1])
                assert changes(surface, *beside(place, arc.direction, NEAR * arc.box[arc.direction].width)) == 1


def see_that_these_are_all(found, surface, steps):
    """Where a derivative changes its sign along a line there is an arc, or it is said that it is not decided."""
    boxes = [box.sides for box in found.undecided]
    for curve in found.curves:
        for piece in curve.pieces:
            boxes += [piece.sides.part(box) for box in (*(arc.box for arc in piece.part.arcs), *piece.part.cells)]
    whole_u, whole_v = surface.domain
    seen = 0
    for k in (1, 3, 5):
        u = whole_u.at(mpq(k, 7))
        along, ways = [], ((1, 0), (1, 0))
        for v in (whole_v.at(mpq(i, steps)) for i in range(1, steps)):
            found_here, ways = slopes(surface, as_mpf((u, v)), ways)
            along.append((v, found_here))
        for (v, before), (then, behind) in pairwise(along):
            if any(x * y < 0 for x, y in zip(before, behind, strict=True)):
                seen += 1
                assert any(b.low <= u <= b.high and c.low <= then and v <= c.high for b, c in boxes)
    return seen


@pytest.mark.parametrize(
    ("surface", "steps"),
    [(generic(0, 1, 1), 20), (generic(3, 1, 1, 4), 20), (generic(2, 3, 1), 20), (example("developable"), 20)],
    ids=["bilinear", "rational", "cubic by line", "developable"],
)
def test_ridges_are_where_a_curvature_is_stationary_and_nowhere_else(surface, steps):
    found = analyse(surface).ridges
    with mp.workdps(80):
        see_that_all_are_ridges(found, surface)
        assert see_that_these_are_all(found, surface, steps)
    assert found == pickle.loads(pickle.dumps(found))


@pytest.mark.skipif(not FULL, reason="a minute: EXACTSPLINE_FULL=1")
@pytest.mark.parametrize("surface", [example("bicubic"), example("monkey_saddle"), generic(4, 2, 2)])
def test_ridges_of_higher_degree_are_true_and_complete(surface):
    found = analyse(surface).ridges
    with mp.workdps(80):
        see_that_all_are_ridges(found, surface)
        assert see_that_these_are_all(found, surface, 40)


def test_the_ridges_of_both_curvatures_cross_in_a_node():
    """Would be an open box otherwise: it is proved by signs alone, the degree is too high for elimination."""
    found = a_node().ridges
    pieces = [piece for curve in found.curves for piece in curve.pieces]
    (node,) = [joint for piece in pieces for joint in piece.part.joints]
    assert found.complete
    assert len(node.ends) == 4
    m, n = pieces[0].curve.form.degree
    assert m * n > ridges.FEW


def test_four_signs_that_do_not_wind_prove_no_node():
    """Would pass otherwise: two branches of the ridges of one curvature, or of both, that do not cross in the box."""
    cross = as_form((2 * S - 1) * (2 * T - 1))

    def winds(first, second, form=cross):
        return ridges.winds_once(form, UNIT, lambda x, y: (sign(first(x, y)), sign(second(x, y))))

    assert winds(lambda x, y: 2 * x - 1, lambda x, y: 2 * y - 1)
    assert not winds(lambda x, y: (2 * x - 1) * (2 * y - 1), lambda x, y: 1)
    assert not winds(lambda x, y: x + y - mpq(1, 2), lambda x, y: x + y - mpq(3, 2))
    # two parallel lines: four zeros on the border, three pairs of signs
    assert not winds(lambda x, y: 3 * x - 1, lambda x, y: 3 * x - 2, as_form((3 * S - 1) * (3 * S - 2)))
    # a double zero on the border is none of four simple ones
    assert not winds(lambda x, y: 2 * x - 1, lambda x, y: 2 * y - 1, as_form((2 * S - 1) ** 2 * (2 * T - 1)))


def test_known_ridges():
    """The diagonals of z = xy; the planes of symmetry of an ellipsoid; nothing at the vertex of a paraboloid, which is
    an umbilic; both curvatures of a torus, and one of a surface of revolution, are constant along their lines.
    """
    (cross,) = analyse(example("hyperbolic_paraboloid")).ridges.curves
    (a, b), (c, d) = example("hyperbolic_paraboloid").domain
    ends = {end for arc in cross.arcs(Box(Interval(a, b), Interval(c, d))) for end in arc[:2]}
    assert {(a, c), (a, d), (b, c), (b, d)} < ends
    assert len(ends) == 5
    ellipsoid = analyse(example("ellipsoid")).ridges
    assert {(line.along.value, line.value) for line in ellipsoid.lines} == {("u", 1), *(("v", k) for k in range(4))}
    assert not ellipsoid.curves
    assert all(box.umbilics for box in ellipsoid.undecided)
    paraboloid = analyse(example("paraboloid")).ridges
    assert not paraboloid.curves
    assert [curvatures for _, curvatures in paraboloid.stationary] == [1]
    assert {curvatures for _, curvatures in analyse(example("torus")).ridges.stationary} == {2}
    assert not analyse(example("sphere")).ridges


def test_why_there_are_no_ridges_is_said():
    """A sphere, a plane and a curve had "nowhere" alone: there is no principal direction in which to look."""
    flat = NurbsSurface((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])
    line = flat.transform([[1, 0, 0], [1, 0, 0], [1, 0, 0]])
    for surface, why in ((example("sphere"), "umbilic"), (flat, "umbilic"), (line, "tangent plane")):
        found = analyse(surface).ridges
        assert repr(found).startswith("nowhere; ")
        assert why in repr(found)
        assert [why in str(reason) for _, reason in found.excluded] == [True] * surface.patches[0] * surface.patches[1]
        assert (bool(found), found.complete) == (False, True)
    assert "every point is an umbilic" in run("inspect", "sphere", "--ask", "ridges").stdout
    assert repr(analyse(example("hyperbolic_paraboloid")).ridges) == "branches that cross"


def test_the_border_of_a_patch_with_ridges_everywhere_is_no_line():
    """A cylinder, behind it the surface of revolution r = 1 + y²: y = 0 was a line, and one "from one side"."""
    profile = [(1, -1), (1, mpq(-1, 2)), (1, 0), (1, mpq(1, 2)), (2, 1)]
    net = [[(x * r, y, z * r) for r, y in profile] for x, z in ((1, 0), (1, 1), (0, 1))]
    knots = [-1, -1, -1, 0, 0, 1, 1, 1]
    found = analyse(NurbsSurface((2, 2), [0, 0, 0, 1, 1, 1], knots, net, [[1] * 5, [1] * 5, [2] * 5])).ridges
    assert (found.lines, [curvatures for _, curvatures in found.stationary]) == ((), [2, 1])


def test_what_exceeds_the_bound_is_undecided(monkeypatch):
    """Would pass otherwise: no ridges, where the search was too long."""
    monkeypatch.setattr(ridges, "WORK", 10**8)
    found = analyse(generic(2, 3, 1)).ridges
    assert not found.complete
    covered = [box.sides for box in found.undecided]
    covered += [x.sides.part(a.box) for c in found.curves for x in c.pieces for a in x.part.arcs]
    assert covered
    monkeypatch.undo()
    for curve in a_node().ridges.curves:
        for piece in curve.pieces:
            for arc in piece.part.arcs:
                u, v = piece.sides.at(*piece.curve.points(arc, 2)[1])
                near = mpq(1, 1 << 20)
                assert any(a - near <= u <= b + near and c - near <= v <= d + near for (a, b), (c, d) in covered)


def test_the_other_family_of_lines_of_curvature():
    """From a quadratic form by its two factors, and a cubic one that has one of them or both."""
    random, x, y = Random(5), (S + 1, S - 2 * T), (T + 3, 2 * S - T * T)
    for _ in range(20):
        (a, b), (c, d) = ([random.choice((*x, *y, S * 0 + 1, S * T - 2)) for _ in range(2)] for _ in range(2))
        if random.random() < 0.3:
            a = S * 0
        if not (a * d - b * c):
            continue
        lines = [a * c, a * d + b * c, b * d]
        rest = [S + 5, T - 3 * S, S * S + T]
        # (a p + b q) times a quadratic form
        cubic = [a * rest[0], a * rest[1] + b * rest[0], a * rest[2] + b * rest[1], b * rest[2]]
        p, q = d, -c
        value = cubic[0] * p**3 + cubic[1] * p**2 * q + cubic[2] * p * q**2 + cubic[3] * q**3
        found, shared = ridges.other_family(lines, cubic), greatest_common_divisor([c, d])
        expected = value / shared**3
        assert found is not None
        assert found * expected.leading_coefficient() == expected * found.leading_coefficient()
        e, f = S - T + 4, S * T + 1
        both = [lines[0] * e, lines[1] * e + lines[0] * f, lines[2] * e + lines[1] * f, lines[2] * f]
        assert ridges.other_family(lines, both) is None


def test_directions_solve_their_equation_and_do_not_jump():
    random = Random(6)
    for _ in range(60):
        uu, uv, vv = (mpq(random.choice([0, 0, 1, 1, 1]) * random.randint(-9, 9), 4) for _ in range(3))
        if uv * uv <= 4 * uu * vv:
            continue
        for a, b, c in ((sign(uu), 0, 0), (0, 0, sign(vv)), (0, sign(uv), 0)):
            if not (a or b or c):
                continue
            ways = ridges.principal_directions(uu, uv, vv, a, b, c)
            assert all(uu * p * p + uv * p * q + vv * q * q == 0 for p, q in ways)
            (p, q), (r, s) = ways
            assert p * s != q * r
            by = mpq(1, 10**6)
            moved = ridges.principal_directions(uu + by, uv - by, vv + by, a, b, c)
            for way, after in zip(ways, moved, strict=True):
                p, q, r, s = map(float, (*way, *after))
                assert p * r + q * s > 0.99 * hypot(p, q) * hypot(r, s)


def test_zeros_are_in_the_boxes_of_a_bisection(monkeypatch):
    """In a finished box one derivative has a sign; what is cut too often, or too dear, remains."""
    form = as_form((2 * S - 1) ** 2 - (3 * T - 1) ** 2 * (T + 1))
    monkeypatch.setattr(ridges, "DEPTH", 8)
    boxes, remaining = ridges.bisected(form)
    assert boxes
    assert remaining
    for part in boxes:
        assert any(form.part(part.box).derivative(k).sign for k in (0, 1))
    assert all(part.box.first.width * part.box.second.width >= mpq(1, 2**8) for part in boxes)
    assert {mpq(1, 2**8)} == {box.first.width * box.second.width for box in remaining}
    assert all(box.first.low <= mpq(1, 2) <= box.first.high and box.second.low <= mpq(1, 3) for box in remaining)
    every = [part.box for part in boxes] + remaining
    for k in range(1, 40):
        for root in roots_in(at(as_polynomial(form), 0, mpq(k, 40)), mpq(0), mpq(1)):
            assert any(b.low <= mpq(k, 40) <= b.high and c.low <= root <= c.high for b, c in every)
    assert ridges.bisected(as_form((3 * S - 1) ** 2 + (2 * T - 1) ** 2 - 1))[1] == []
    with drawing_on(Budget(0)):
        assert ridges.bisected(form) == ([], [UNIT])


def test_a_node_is_proved_only_where_what_is_divided_out_has_no_zeros(monkeypatch):
    """The product of both derivatives may have other factors: where one has a zero in the box, none is proved."""
    proved, found = ridges.RidgeSearch._node, []

    def node(self, form, whole, box):
        cell = proved(self, form, whole, box)
        if cell is not None:
            middle = box.first.middle
            line = int(middle.denominator) * S - int(middle.numerator)
            assert proved(self, form, as_form(as_polynomial(whole) * line), box) is None
            assert proved(self, form, as_form(as_polynomial(whole) * (S + 1)), box).box == cell.box == box
            found.append(cell)
        return cell

    monkeypatch.setattr(ridges.RidgeSearch, "_node", node)
    assert analyse(generic(2, 3, 1)).ridges.complete
    assert len(found) == 1
