"""Degrees of derived curves, and bisectors, of curves that are written otherwise: what belongs to a parameter or to a
point must go where the change puts it. All questions of the registry: `tests/laws/test_matrix.py`.
"""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import product
from random import Random

import pytest
from gmpy2 import mpq

from exactspline import Nurbs, derive
from exactspline.errors import ExactSplineError
from exactspline.geometry.bisectors.point_and_curve import point_bisector
from exactspline.geometry.bisectors.trimmed import PieceKind, trimmed_bisector
from exactspline.geometry.bisectors.two_curves import curve_bisector
from exactspline.interchange.examples import example
from exactspline.reals.real import Real
from tests.geometry.test_bisector_pairs import assert_complete_on_a_grid
from tests.support.bisector_answers import of_family, random_pair
from tests.support.bisector_oracle import FAMILIES, dimension, planes, point_and_tangent, spans
from tests.support.changes import OF_CURVES

NEAR = mpq(1, 10**20)


@dataclass(frozen=True)
class Change:
    """A curve written otherwise: where a parameter goes and where a point goes."""

    curve: Nurbs
    parameter: Callable
    point: Callable


WAYS = ["rotated", "reversed", "knot far away", "constant weight", "common factor", "affine", "moebius", "degree"]
over_ways = pytest.mark.parametrize("way", WAYS)


def changed(curve, way):
    other, image = OF_CURVES[way](curve, Random(way))
    return Change(other, image.ways[0].to, image.motion)


# ---- values that must be equal, each known to many digits


def number(x):
    """A number as a rational within 10⁻³⁰ of it, relative to large ones."""
    return x.enclosure(30).middle if isinstance(x, Real) else mpq(x)


def agree(a, b):
    return abs(a - b) <= NEAR * (1 + abs(a))


def assert_agree(found, expected):
    """Rows of words and numbers, in whatever order."""
    found, expected = sorted(found, key=in_order), sorted(expected, key=in_order)
    assert [words for words, _ in found] == [words for words, _ in expected]
    for (_, one), (_, other) in zip(found, expected, strict=True):
        assert len(one) == len(other)
        assert all(agree(a, b) for a, b in zip(one, other, strict=True)), (one, other)


def in_order(row):
    words, numbers = row
    return words, [round(x * 10**24) for x in numbers]


# ---- degrees of what is derived

DERIVED = {
    2: ["evolute", "curvature_squared", "f2", "g2", "evolute_lifted"],
    3: ["focal_curve", "torsion", "D1_D2_D3", "curvature_squared_in_space"],
}


def degrees(curve):
    found = {}
    for name in DERIVED[curve.dimension]:
        try:
            found[name] = derive(name, curve).true_degree
        except ExactSplineError as error:
            found[name] = type(error).__name__
    return found


@over_ways
@pytest.mark.parametrize(
    "name", ["ellipse", "rational_cubic", "cubic_s", "cusp", "rational_space_cubic", "twisted_cubic"]
)
def test_degrees_of_derived_curves(name, way):
    """Of a curve written in another parameter those of values: forms of zero-set problems take a factor."""
    curve = example(name)
    expected, found = degrees(curve), degrees(changed(curve, way).curve)
    values = [each for each in expected if each not in ("f2", "g2", "D1_D2_D3")]
    assert {each: found[each] for each in values} == {each: expected[each] for each in values}


# ---- bisectors of a point and a curve


def arcs(pieces, image):
    """The parameters of arcs, joined where one goes on at a knot."""
    ends = sorted(
        sorted(image(number(t)) for t in (p.low, p.high)) for p in pieces if p.kind is PieceKind.ARC and p.low != p.high
    )
    joined = ends[:1]
    for low, high in ends[1:]:
        if agree(joined[-1][1], low):
            joined[-1] = [joined[-1][0], high]
        else:
            joined.append([low, high])
    return [(("arc",), each) for each in joined]


def lines(pieces, image, move):
    """The pieces of straight lines by their feet and by their finite ends."""
    found = []
    for piece in pieces:
        if piece.kind is not PieceKind.ARC:
            ends = [move(piece.value(number(t))) for t in (piece.low, piece.high) if abs(number(t)) < 1]
            found.append(
                ((str(piece.kind), str(len(ends))), [image(piece.foot), *[x for p in sorted(ends) for x in p]])
            )
    return found


@over_ways
@pytest.mark.parametrize("name", ["rational_cubic", "cubic_s", "cusp", "straight_between_arcs"])
def test_the_trimmed_bisector(name, way):
    curve, point = example(name), (mpq(1, 3), mpq(7, 5))
    change = changed(curve, way)
    expected, found = trimmed_bisector(curve, point).pieces, trimmed_bisector(change.curve, change.point(point)).pieces
    assert_agree(arcs(found, lambda t: t), arcs(expected, change.parameter))
    assert_agree(lines(found, lambda t: t, tuple), lines(expected, change.parameter, change.point))


def on_one_line(points):
    a, *others = points
    b = max(others, key=lambda p: sum((x - y) ** 2 for x, y in zip(p, a, strict=True)))
    d = [y - x for x, y in zip(a, b, strict=True)]
    for p in others:
        v = [y - x for x, y in zip(a, p, strict=True)]
        if any(d[i] * v[j] != d[j] * v[i] for i in range(3) for j in range(i)):
            return False
    return True


@over_ways
@pytest.mark.parametrize("name", ["rational_space_cubic", "twisted_cubic", "space_quartic"])
def test_the_bisector_of_a_point(name, way):
    """Its lines, and the parameters at which there is none."""
    curve, point = example(name), (mpq(1, 3), mpq(7, 5), mpq(-1, 2))
    change = changed(curve, way)
    one, other = point_bisector(curve, point), point_bisector(change.curve, change.point(point))

    def line(found, s):
        piece = next(p for p in found.pieces if number(p.interval[0]) <= s <= number(p.interval[1]))
        return [piece.surface.at(z)(s) for z in (0, 1)]

    a, b = curve.domain
    for s in (a + (b - a) * mpq(k, 7) for k in range(1, 7)):
        assert on_one_line([*map(change.point, line(one, s)), *line(other, change.parameter(s))])
    assert_agree(
        [((), [number(t)]) for t in other.singular], [((), [change.parameter(number(t))]) for t in one.singular]
    )


# ---- bisectors of two curves

PAIRS = [
    "coaxial circles of one radius",
    "a spline and its mirror image",
    "a cubic and its mirror image",
    "a cubic and a translated copy",
    "parabolas in one plane",
    "a cusp and a cubic",
    "two cusps",
    "skew lines",
    "crossing lines",
    "parallel lines",
]


def both_changed(pair, way):
    """Both curves moved, or the second written otherwise."""
    first, second = pair
    second = changed(second, way)
    return (changed(first, way).curve if way == "rotated" else first), second


def beside(found, parameter=lambda t: t):
    """What there is beside the surface: lines and planes by what they are, single pairs by their place."""
    lines = [((str(x.cause), str(x.correspondence)), []) for x in found.lines]
    planes = [((str(x.cause), str(x.solutions)), []) for x in found.planes]
    return (
        lines,
        planes,
        [((str(x.cause), str(x.solutions)), [number(x.s), parameter(number(x.t))]) for x in found.pairs],
    )


#: Each pair with every second way.
@pytest.mark.parametrize(("name", "way"), [*product(PAIRS[::2], WAYS[::2]), *product(PAIRS[1::2], WAYS[1::2])])
def test_the_bisector_of_two_curves(name, way):
    """Its surface, and what lies beside it."""
    first, change = both_changed(FAMILIES[name], way)
    one, other = of_family(name), curve_bisector(first, change.curve)
    if way != "knot far away":
        for expected, found in zip(beside(one, change.parameter), beside(other), strict=True):
            assert_agree(found, expected)
        assert len(one.poles) == len(other.poles)
    (a, b), (c, d) = (x.domain for x in FAMILIES[name])
    for k in range(1, 5):
        s, t = a + (b - a) * mpq(k, 11), c + (d - c) * mpq(3 * k % 11, 11)
        moved = s, change.parameter(t)
        rows = [planes(point_and_tangent(x, i, s), point_and_tangent(y, j, t)) for x, y, i, j in placed(name, s, t)]
        if one.patches and all(dimension(each) == 0 for each in rows):
            assert other(*moved) == change.point(one(s, t))
        elif one.patches and all(dimension(each) < 0 for each in rows):
            with pytest.raises(ZeroDivisionError):
                other(*moved)


def placed(name, s, t):
    """The curves of a family with the spans of two parameters."""
    first, second = FAMILIES[name]
    i = [k for k, (low, high) in spans(first) if low <= s <= high]
    j = [k for k, (low, high) in spans(second) if low <= t <= high]
    return [(first, second, k, m) for k in i for m in j]


@pytest.mark.parametrize("way", ["knot far away", "moebius", "degree", "constant weight", "reversed"])
@pytest.mark.parametrize("seed", [3, 17, 40, 58])
def test_every_pair_of_curves_written_otherwise(seed, way):
    """Complete by the oracle's own count, whatever the curves are written as."""
    first, second = random_pair(seed)
    first, second = changed(first, way).curve, changed(second, way).curve
    assert_complete_on_a_grid(curve_bisector(first, second), first, second, 3)


def test_a_bisector_of_parts_is_the_part_of_a_bisector():
    first, second = FAMILIES["a cubic and a translated copy"]
    whole = of_family("a cubic and a translated copy")
    for own, half in zip(((0, mpq(1, 3)), (mpq(1, 3), 1)), second.split(mpq(1, 3)), strict=True):
        part = curve_bisector(first, half)
        for s in (mpq(1, 5), mpq(7, 9)):
            t = (own[0] * 2 + own[1]) / 3
            assert part(s, t) == whole(s, t)
        inside = [p for p in whole.pairs if own[0] < number(p.t) < own[1]]
        assert_agree(
            [((str(p.solutions),), [number(p.s), number(p.t)]) for p in part.pairs],
            [((str(p.solutions),), [number(p.s), number(p.t)]) for p in inside],
        )
