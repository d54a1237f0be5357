"""Checks a certificate of the common zeros of functions of two parameters, or of the common points of two plane curves,
with only the standard library.

On each patch the functions are given by integers: Bernstein coefficients on the unit square, up to a positive constant
for each of them. The square is halved repeatedly, as the certificate says. On every remaining box, some combination of
the functions has Bernstein coefficients of one strict sign, or the box is inside the region of a zero.

In the region of a simple zero the Jacobian of two combinations is regular, even if its rows are taken at different
points: at most one point is a common zero there. The existence of the zero is proved by opposite signs on opposite
sides (Miranda), by its rational parameters, or by a common divisor on an edge of the patch. In the region of any other
zero all of this is proved by elimination (`exactspline.certificates.elimination`).

Points of two segments are common zeros of two functions of both parameters, the differences of the coordinates times
both weights, which are computed here from the control points. A segment consists of three lists of integers: for every
control point its coordinates times the weight, and the weight.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from functools import reduce
from itertools import combinations, pairwise, product
from math import comb
from typing import Any, TypeVar

from exactspline.certificates.elimination import (
    SINGLE_ZERO,
    changes_sign,
    check_single_zero,
    common_divisor,
    powers_of_net,
)
from exactspline.certificates.numbers import count, each, fraction, integer, one_of, read, require, require_each_once
from exactspline.certificates.zeros import halves_at, values_on

Found = TypeVar("Found")
Net = list[list[int]]
Side = tuple[Fraction, Fraction]
Box = tuple[Side, Side]

#: The cuts of a box: at the middle of its first side, and of its second.
FIRST, SECOND = "first", "second"
#: The ways in which the existence of a zero is proved.
CROSSED, POINT, EDGE, ELIMINATED = "crossed", "point", "edge", "eliminated"
HALF = Fraction(1, 2)
NET = [[integer]]
REGION = (fraction, fraction), (fraction, fraction)


def check_common_zeros(certificate: Mapping[str, object]) -> dict[str, int]:
    """The number of common zeros that a certificate proves, one for each patch that has it; of two functions also the
    sum of the intersection multiplicities.
    """
    found = on_each_patch(certificate, {"functions": [NET], **ZEROS}, _on_patch)
    counts = {count for count, _ in found}
    require(len(counts) == 1, "another number of functions on another patch")
    multiplicities = [times for _, own in found for times in own]
    return {"zeros": len(multiplicities)} | ({"multiplicity": sum(multiplicities)} if counts == {2} else {})


def on_each_patch(
    certificate: Mapping[str, object], form: Mapping[str, object], check: Callable[[dict[str, object]], Found]
) -> list[Found]:
    """The results on the patches between the knots in both directions; every patch must be given exactly once."""
    patch = {"patch": (count, count), **form}
    data = read(certificate, {"knots": ([fraction], [fraction]), "patches": [patch]})
    ascend = all(len(knots) > 1 and all(a < b for a, b in pairwise(knots)) for knots in data["knots"])
    require(ascend, "fewer knots than two in a direction, or knots that do not ascend")
    intervals = [knots[1:] for knots in data["knots"]]
    require_each_once(
        [own["patch"] for own in data["patches"]],
        intervals,
        "patches between the knots that are not given exactly once",
    )
    return each("patches", check, data["patches"])


#: A zero on a patch, by the way in which its existence is proved.
SIMPLE: dict[str, object] = {"region": REGION, "combinations": ([integer], [integer])}
_zero = one_of(
    "by",
    {
        CROSSED: SIMPLE,
        POINT: {**SIMPLE, "point": (fraction, fraction)},
        EDGE: {**SIMPLE, "edge": (count, count)},
        ELIMINATED: {"region": REGION, **SINGLE_ZERO},
    },
)


def _token(given: Any) -> Any:
    """A cut, the number of a region, or the coefficients of a combination."""
    if given in (FIRST, SECOND) or type(given) is int:
        return given
    require(type(given) is list, "neither a cut, a region nor a combination")
    return read(given, [integer])


#: The form of the proof of the common zeros of functions on a patch.
ZEROS: dict[str, object] = {"zeros": [_zero], "boxes": [_token]}


def _on_patch(patch: Mapping[str, Any]) -> tuple[int, list[int]]:
    """The number of functions on a patch, and the multiplicities of their zeros."""
    functions = patch["functions"]
    require(len(functions) >= 2, "fewer functions than two")
    sizes = {(len(net), len(row)) for net in functions for row in net}
    require(len(sizes) == 1 and all(map(all, sizes)) and all(functions), "functions of different degrees")
    return len(functions), _multiplicities_on_patch(functions, patch["zeros"], patch["boxes"])


def _multiplicities_on_patch(
    functions: Sequence[Net], zeros: Iterable[Mapping[str, object]], boxes: Sequence[object]
) -> list[int]:
    """The multiplicities of all common zeros of functions on the unit square, as `ZEROS` prove them."""
    proved = each("zeros", lambda zero: _region(functions, zero), zeros)
    regions = [region for region, _ in proved]
    for one, other in combinations(regions, 2):
        apart = any(a[1] < b[0] or b[1] < a[0] for a, b in zip(one, other, strict=True))
        require(apart, "regions of two zeros that meet")
    _check_boxes(functions, boxes, regions)
    return [times for _, times in proved]


# ---- boxes


def _check_boxes(functions: Sequence[Net], tokens: Sequence[Any], regions: Sequence[Box]) -> None:
    """The boxes in the order in which they are reached, the lower half of a box first: its cut, the number of a region,
    or the coefficients of a combination.
    """
    unit = (Fraction(0), Fraction(1))
    todo = [((unit, unit), list(functions))]
    for token in tokens:
        require(bool(todo), "more boxes than the cuts leave")
        box, nets = todo.pop()
        if token in (FIRST, SECOND):
            todo += cut(box, nets, int(token == SECOND))
        elif type(token) is int:
            require(0 <= token < len(regions), "the number of a region that does not exist")
            inside = all(a <= low <= high <= b for (low, high), (a, b) in zip(box, regions[token], strict=True))
            require(inside, "a box that is not inside the region of a zero")
        else:
            require(sign_on(_combined(nets, token)) != 0, "a box on which the combination does not have one sign")
    require(not todo, "boxes that are missing")


def cut(box: Box, nets: Sequence[Net], direction: int) -> list[tuple[Box, list[Net]]]:
    """The upper and the lower half of a box, with the functions there."""
    low, high = box[direction]
    middle, pairs = (low + high) / 2, [_halves(net, direction) for net in nets]
    sides = (middle, high), (low, middle)
    boxes = [(box[0], side) if direction else (side, box[1]) for side in sides]
    return [(half, [pair[end] for pair in pairs]) for half, end in zip(boxes, (1, 0), strict=True)]


def _halves(net: Net, direction: int) -> tuple[Net, Net]:
    """The Bernstein coefficients on both halves in a direction, up to a positive constant.

    >>> _halves([[0, 1], [2, 3]], 0)
    ([[0, 2], [2, 4]], [[2, 4], [4, 6]])
    """
    rows = [halves_at(row, HALF) for row in (net if direction else turned(net))]
    low, high = ([pair[k] for pair in rows] for k in (0, 1))
    return (low, high) if direction else (turned(low), turned(high))


def turned(net: Net) -> Net:
    """The function with the parameters exchanged.

    >>> turned([[1, 2], [3, 4]])
    [[1, 3], [2, 4]]
    """
    return [list(column) for column in zip(*net, strict=True)]


def part(net: Net, box: Box) -> Net:
    """The Bernstein coefficients on a box, up to a positive constant that depends on the box and the degrees alone."""
    return turned([values_on(column, *box[0]) for column in turned([values_on(row, *box[1]) for row in net])])


def _combined(nets: Sequence[Net], coefficients: Sequence[int]) -> Net:
    """The combination of functions with these coefficients."""
    require(len(coefficients) == len(nets), "a combination of another number of functions")
    return [
        [sum(c * x for c, x in zip(coefficients, values, strict=True)) for values in zip(*rows, strict=True)]
        for rows in zip(*nets, strict=True)
    ]


def sign_on(net: Net) -> int:
    """The strict sign of all coefficients, otherwise 0.

    >>> sign_on([[1, 2], [3, 4]]), sign_on([[0, 2], [3, 4]])
    (1, 0)
    """
    values = [x for row in net for x in row] or [0]
    return 1 if min(values) > 0 else -1 if max(values) < 0 else 0


# ---- the region of a zero


def _region(functions: Sequence[Net], zero: Mapping[str, Any]) -> tuple[Box, int]:
    """The region of a zero, and its multiplicity."""
    box = zero["region"]
    require(all(0 <= low < high <= 1 for low, high in box), "a region that is not in the square")
    if zero["by"] == ELIMINATED:
        return box, check_single_zero([powers_of_net(net) for net in functions], box, zero)
    parts = [part(net, box) for net in functions]
    one, other = (_combined(parts, row) for row in zero["combinations"])
    require(_is_regular(one, other), "a region in which the Jacobian may be singular")
    PROOFS[zero["by"]](functions, box, (one, other), zero)
    return box, 1


def _is_regular(one: Net, other: Net) -> bool:
    """Whether the determinant of the ranges of the derivatives, as independent intervals, does not contain 0: then two
    points with the same values would give, by the mean value theorem in each row, a singular matrix in these ranges.
    """
    (a, b), (c, d) = ([_range(slopes) for slopes in _slopes(net)] for net in (one, other))
    (low, high), (least, most) = _product(a, d), _product(b, c)
    return low > most or high < least


def _slopes(net: Net) -> tuple[list[int], list[int]]:
    """Differences of the coefficients in both directions."""
    first = [y - x for p, q in pairwise(net) for x, y in zip(p, q, strict=True)]
    second = [y - x for row in net for x, y in pairwise(row)]
    return first or [0], second or [0]


def _range(values: list[int]) -> tuple[int, int]:
    return min(values), max(values)


def _product(one: tuple[int, int], other: tuple[int, int]) -> tuple[int, int]:
    return _range([x * y for x, y in product(one, other)])


def _is_crossed(functions: Sequence[Net], box: Box, pair: tuple[Net, Net], zero: Mapping[str, Any]) -> None:
    require(len(functions) == 2, "signs of two combinations for more functions")
    one, other = pair[0], turned(pair[1])
    signs = [sign_on([net[0]]) * sign_on([net[-1]]) for net in (one, other)]
    require(signs == [-1, -1], "sides without opposite signs")


def _is_at_point(functions: Sequence[Net], box: Box, pair: tuple[Net, Net], zero: Mapping[str, Any]) -> None:
    point = zero["point"]
    require(all(low <= x <= high for x, (low, high) in zip(point, box, strict=True)), "a point outside its region")
    require(all(_value(net, point) == 0 for net in functions), "a point at which a function is not zero")


def _value(net: Net, point: Sequence[Fraction]) -> Fraction:
    return _blended([_blended(row, point[1]) for row in net], point[0])


def _blended(values: Sequence[Any], t: Fraction) -> Fraction:
    n = len(values) - 1
    return sum((comb(n, i) * (1 - t) ** (n - i) * t**i * x for i, x in enumerate(values)), Fraction(0))


def _is_on_edge(functions: Sequence[Net], box: Box, pair: tuple[Net, Net], zero: Mapping[str, Any]) -> None:
    direction, end = zero["edge"]
    require(direction in (0, 1) and end in (0, 1) and box[direction][end] == end, "an edge that is not in the region")
    edges = [(turned(net) if direction else net)[-end] for net in functions]
    common = reduce(common_divisor, ([comb(len(b) - 1, i) * x for i, x in enumerate(b)] for b in edges))
    require(len(common) > 1 and changes_sign(common, *box[1 - direction]), "an edge without a zero")


Proof = Callable[[Sequence[Net], Box, tuple[Net, Net], Mapping[str, Any]], None]
PROOFS: dict[str, Proof] = {CROSSED: _is_crossed, POINT: _is_at_point, EDGE: _is_on_edge}


SEGMENT = {"x": [integer], "y": [integer], "w": [integer]}
FORM = {"first": [SEGMENT], "second": [SEGMENT], "pairs": [{"segments": (count, count), **ZEROS}]}


def check_intersections(certificate: Mapping[str, object]) -> dict[str, int]:
    """The number of common points that a certificate proves, one for each pair of segments that has it, and the sum of
    their intersection multiplicities.
    """
    data = read(certificate, FORM)
    curves = [each(name, _segment, data[name]) for name in ("first", "second")]
    require(all(curves), "a curve without segments")
    require_each_once(
        [pair["segments"] for pair in data["pairs"]], curves, "pairs of segments that are not given exactly once"
    )

    def proved(pair: Mapping[str, Any]) -> list[int]:
        first, second = (curve[i] for curve, i in zip(curves, pair["segments"], strict=True))
        functions = [_difference(first, second, axis) for axis in (0, 1)]
        return _multiplicities_on_patch(functions, pair["zeros"], pair["boxes"])

    found = [times for own in each("pairs", proved, data["pairs"]) for times in own]
    return {"points": len(found), "multiplicity": sum(found)}


def _segment(given: Mapping[str, Any]) -> list[list[int]]:
    rows = [given[name] for name in ("x", "y", "w")]
    require(len({len(row) for row in rows}) == 1 and len(rows[0]) > 1, "rows of different lengths, or a single point")
    require(all(w > 0 for w in rows[2]), "a weight that is not positive")
    return rows


def _difference(first: list[list[int]], second: list[list[int]], axis: int) -> Net:
    """The Bernstein coefficients of the difference of a coordinate, times both weights."""
    others = list(zip(second[axis], second[2], strict=True))
    return [[x * v - y * w for y, v in others] for x, w in zip(first[axis], first[2], strict=True)]
