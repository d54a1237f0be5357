"""Everything that is told of a curve, against every way to write the same curve: a matrix, row by row.

Rows are what is told: joints and corners, degrees of derived curves, answers of the oracle, bisectors of points and of
curves (inflections, extrema, singular points, zeros of the torsion and pieces: `tests/laws/test_invariance.py`).
Columns are changes of the curve. What belongs to a parameter or to a point must go where the change puts it.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from exactspline import Nurbs, derive
from exactspline.batch.oracle import oracle
from exactspline.errors import ExactSplineError
from exactspline.geometry.analysis.curves import analyse
from exactspline.geometry.bisectors.point_and_curve import point_bisector
from exactspline.geometry.bisectors.trimmed import PieceKind, trimmed_bisector
from exactspline.geometry.bisectors.two_curves import curve_bisector
from exactspline.interchange.examples import example
from exactspline.reals.real import Real
from tests.geometry.test_bisector_pairs import assert_complete_on_a_grid
from tests.laws.test_invariance import OPPOSITE, assert_same, chain, rotated
from tests.support.bisector_answers import of_family, random_pair
from tests.support.bisector_oracle import FAMILIES, dimension, planes, point_and_tangent, spans
from tests.support.same_curves import CHANGES as WAYS
from tests.support.same_curves import similar
from tests.support.strategies import nurbs

NEAR = mpq(1, 10**20)


@dataclass(frozen=True)
class Change:
    """A curve written otherwise: where a parameter goes and where a point goes, by how much lengths grow, and whether
    the curve runs the other way.
    """

    curve: Nurbs
    parameter: Callable = lambda t: t
    point: Callable = tuple
    scale: mpq | int = 1
    backwards: bool = False


over_ways = pytest.mark.parametrize("way", WAYS)


def changed(curve, way):
    other, image = WAYS[way](curve)
    moved = {"point": similar, "scale": mpq(7, 2)} if way == "turned" else {}
    return Change(other, image, **moved, backwards=way == "backwards")


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


def place(change, curve, t):
    """Where a parameter goes; the end of a closed curve is its beginning."""
    t = change.parameter(number(t))
    a, b = change.curve.domain
    return a if curve.closed and abs(t - b) <= NEAR * (b - a) else t


# ---- joints and corners


def joints(curve):
    """What is not a smooth knot: kind, order, place, cosine and sine of the angle, gap."""
    found = []
    for j in analyse(curve).joints:
        if j.kind != "standing still" and (j.order is None or j.order < 3):
            angle = (j.angle.cosine, j.angle.sine) if j.angle is not None else ()
            gap = () if j.gap is None else (j.gap,)
            found.append(((str(j.kind), str(j.order)), j.parameter, angle, gap))
    return found


def assert_same_joints(curve, change):
    sign = -1 if change.backwards and curve.dimension == 2 else 1

    def row(words, t, angle, gap, scale=1, flip=1):
        angle = [squared(angle[0]), squared(angle[1]) * flip] if angle else []
        return words, [t, *angle, *[squared(x) * scale * abs(scale) for x in gap]]

    expected = [
        row(words, place(change, curve, t), angle, gap, change.scale, sign) for words, t, angle, gap in joints(curve)
    ]
    assert_agree([row(*each) for each in joints(change.curve)], expected)


def squared(x):
    """The square of a rational or of a√b, with its sign."""
    square = x**2
    return square if x > 0 else -square


JOINED = [
    "jump",
    "straight_between_arcs",
    "six_segment_cubic",
    "cusp",
    "flat_point",
    "rational_space_cubic_spline",
    "ellipse",
]
CORNERED = {
    "a closed chain with corners": chain([(0, 0), (1, -1), (2, 0), (3, 1), (2, 2), (1, 3), (0, 2), (0, 1), (0, 0)]),
    "a polygon in space": Nurbs(1, [0, 0, 1, 2, 3, 3], [(0, 0, 0), (1, 2, 2), (3, 1, 4), (0, 1, 0)]),
    "gaps": Nurbs(1, [0, 0, 1, 1, 2, 2, 3, 3], [(0, 0), (1, 0), (1, 3), (2, 2), (2, 2), (5, 1)]),
    "a closed polygon in space": Nurbs(1, [0, 0, 1, 2, 3, 3], [(0, 0, 0), (1, 2, 2), (3, 1, 4), (0, 0, 0)]),
}


@over_ways
@pytest.mark.parametrize("name", [*JOINED, *CORNERED])
def test_joints(name, way):
    curve = CORNERED[name] if name in CORNERED else example(name)
    assert_same_joints(curve, changed(curve, way))


@settings(max_examples=20)
@given(nurbs(dimension=2, low=1, most=2), st.sampled_from(sorted(WAYS)))
def test_joints_of_random_plane_curves(curve, way):
    assert_same_joints(curve, changed(curve, way))


@settings(max_examples=12)
@given(nurbs(dimension=3, low=1, most=2), st.sampled_from(sorted(WAYS)))
def test_joints_of_random_space_curves(curve, way):
    assert_same_joints(curve, changed(curve, way))


@given(nurbs(dimension=3, low=1, high=4), st.sampled_from(sorted(WAYS)))
def test_features_of_random_space_curves(curve, way):
    change = changed(curve, way)
    if not curve.closed:
        assert_same(curve, change.curve, change.parameter)


@pytest.mark.parametrize("by", [1, 2, 3])
def test_joints_from_every_seam(by):
    points = [(0, 0), (1, 0), (2, 0), (3, 1), (2, 2), (1, 2), (0, 2), (0, 1), (0, 0)]
    curve, other = chain(points), chain(rotated(points, by))
    assert_same_joints(curve, Change(other, lambda t: (t - by) % 4))


@pytest.mark.parametrize("name", [*JOINED, *CORNERED])
def test_joints_and_pieces_of_two_parts_are_those_of_the_whole(name):
    curve = CORNERED[name] if name in CORNERED else example(name)
    a, b = curve.domain
    middle = next(t for t in (a + (b - a) * mpq(k, 29) for k in (13, 14)) if t not in curve.breakpoints)
    parts = curve.split(middle)
    inner = [j for j in joints(curve) if not (curve.closed and j[1] in (a, b))]
    halves = [j for part in parts for j in joints(part)]
    assert_agree([(w, [t]) for w, t, *_ in halves], [(w, [t]) for w, t, *_ in inner])
    for group in ("straight_pieces", "constant_pieces"):
        whole = {t for piece in getattr(analyse(curve), group) for low, high in piece.parts for t in (low, high)}
        whole |= (
            {middle}
            if any(low < middle < high for piece in getattr(analyse(curve), group) for low, high in piece.parts)
            else set()
        )
        of_parts = {t for part in parts for x in getattr(analyse(part), group) for ends in x.parts for t in ends}
        assert of_parts == whole


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


# ---- the oracle


@cache
def answers(curve, asked, parameters=()):
    question = f"{asked}@{','.join(map(str, parameters))}" if parameters else asked
    try:
        return oracle(curve, question).items
    except ExactSplineError as error:
        return type(error).__name__


def rows_of(items, change, curve):
    """The items as they must be on the changed curve: parameters and points moved, lengths scaled."""
    if isinstance(items, str):
        return [((items,), [])]
    rows = []
    for item in items:
        values = {name: number(x) for name, x in item.values.items()}
        plane_turn = -1 if change.backwards and curve.dimension == 2 else 1
        numbers = []
        if "parameter" in values:
            numbers.append(place(change, curve, values["parameter"]))
        names = [name for name in "xyz" if name in values]
        if names:
            numbers += change.point([values[name] for name in names])
        for name, x in values.items():
            power = {"curvature": -1, "torsion": -1, "length": 1, "gap": 1, "area": 2}.get(name)
            sign = plane_turn if name in ("curvature", "degrees", "sine") else 1
            sign = -1 if name == "area" and change.backwards else sign
            if power is not None:
                numbers.append(x * sign * change.scale**power)
            elif name in ("degrees", "sine", "cosine"):
                numbers.append(x * sign)
            elif name in ("low", "high"):
                numbers.append(x)
        what = OPPOSITE.get(item.what, item.what) if plane_turn < 0 else item.what
        facts = {k: item.facts[k] for k in ("by_jump", "multiplicity", "geometric_continuity") if k in item.facts}
        rows.append(((what, repr(sorted(facts.items()))), numbers))
    return rows


ASKED = [
    "inflections",
    "curvature_extrema",
    "torsion_zeros",
    "cusps",
    "singular_points",
    "corners",
    "length",
    "bounding_box",
    "area",
]
ASKED_AT = ["value", "curvature", "torsion"]


#: A box is turned by no similarity; areas are told of polynomial curves.
NOT_TOLD = {("bounding_box", "turned"), ("area", "moebius")}


def assert_same_answers(curve, way, asked):
    change = changed(curve, way)
    if (asked, way) in NOT_TOLD:
        return
    same = Change(change.curve)
    assert_agree(
        rows_of(answers(change.curve, asked), same, change.curve), rows_of(answers(curve, asked), change, curve)
    )


@over_ways
@pytest.mark.parametrize(
    "name", ["rational_cubic", "cusp", "straight_between_arcs", "rational_space_cubic", "space_quartic"]
)
def test_answers_of_the_oracle(name, way):
    for asked in ASKED:
        assert_same_answers(example(name), way, asked)


@over_ways
def test_answers_of_the_oracle_about_a_closed_curve(way):
    for asked in ASKED:
        assert_same_answers(CORNERED["a closed chain with corners"], way, asked)


@over_ways
@pytest.mark.parametrize("name", ["rational_cubic", "cubic_s", "rational_space_cubic", "space_quartic"])
def test_values_of_the_oracle_at_parameters(name, way):
    curve = example(name)
    change, (a, b) = changed(curve, way), curve.domain
    at = tuple(a + (b - a) * x for x in (mpq(1, 7), mpq(2, 3)))
    for asked in ASKED_AT:
        moved = answers(change.curve, asked, tuple(map(change.parameter, at)))
        assert_agree(rows_of(moved, Change(change.curve), curve), rows_of(answers(curve, asked, at), change, curve))


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
    return (changed(first, way).curve if way == "turned" else first), second


def beside(found, parameter=lambda t: t):
    """What there is beside the surface: lines and planes by what they are, single pairs by their place."""
    lines = [((str(x.cause), str(x.correspondence)), []) for x in found.lines]
    planes = [((str(x.cause), str(x.solutions)), []) for x in found.planes]
    return (
        lines,
        planes,
        [((str(x.cause), str(x.solutions)), [number(x.s), parameter(number(x.t))]) for x in found.pairs],
    )


@over_ways
@pytest.mark.parametrize("name", PAIRS)
def test_the_bisector_of_two_curves(name, way):
    """Its surface, and what lies beside it."""
    first, change = both_changed(FAMILIES[name], way)
    one, other = of_family(name), curve_bisector(first, change.curve)
    if way != "with_idle_knots":
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


@pytest.mark.parametrize("way", ["with_idle_knots", "moebius", "elevated", "negated_weights", "backwards"])
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
