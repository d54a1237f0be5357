"""Checks a certificate of the common zeros of two functions of two parameters, with only the standard library.

On each patch the functions are given by integers: Bernstein coefficients on the unit square, up to a positive constant
for each of them. The square is halved again and again, as the certificate says; on every box that remains a
combination of both functions has Bernstein coefficients of one strict sign, or the box is inside the region of a zero.
In a region the Jacobian of two combinations is regular, even if its rows are taken at different points: at most one
point is a common zero there. That there is one is proved by opposite signs on opposite sides (Miranda), by its rational
parameters, or by a common divisor on an edge of the patch.
"""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from itertools import combinations, pairwise, product
from math import comb
from typing import Any

from exactspline.certificates.intersections import changes_sign, common_divisor
from exactspline.certificates.numbers import count, fraction, integer, require
from exactspline.certificates.zeros import halves_at, values_on

Net = list[list[int]]
Side = tuple[Fraction, Fraction]
Box = tuple[Side, Side]

#: The cuts of a box: at the middle of its first side, and of its second.
FIRST, SECOND = "first", "second"
#: How the existence of a zero is proved.
CROSSED, POINT, EDGE = "crossed", "point", "edge"
HALF = Fraction(1, 2)


def check_common_zeros(certificate: Mapping[str, object]) -> dict[str, int]:
    """The number of common zeros that a certificate proves, all of them simple, one for each patch that has it."""
    return _of_all_patches(certificate)


def _of_all_patches(certificate: Mapping[str, Any]) -> dict[str, int]:
    return {"zeros": sum(map(_on_patch, certificate["patches"]))}


def _on_patch(patch: Mapping[str, Any]) -> int:
    require(len(patch["functions"]) == 2, "another number of functions than two")
    f, g = ([[integer(x) for x in row] for row in net] for net in patch["functions"])
    sizes = {len(row) for row in (*f, *g)}
    require(len(f) == len(g) and len(sizes) == 1 and 0 not in sizes, "functions of different degrees")
    regions = [_region(f, g, zero) for zero in patch["zeros"]]
    for one, other in combinations(regions, 2):
        apart = any(a[1] < b[0] or b[1] < a[0] for a, b in zip(one, other, strict=True))
        require(apart, "regions of two zeros that meet")
    _check_boxes(f, g, patch["boxes"], regions)
    return len(regions)


# ---- boxes


def _check_boxes(f: Net, g: Net, tokens: Sequence[Any], regions: Sequence[Box]) -> None:
    """The boxes in the order in which they are reached, the lower half of a box first: its cut, the number of a region,
    or the coefficients of a combination.
    """
    unit = (Fraction(0), Fraction(1))
    todo = [((unit, unit), f, g)]
    for token in tokens:
        require(bool(todo), "more boxes than the cuts leave")
        box, p, q = todo.pop()
        if token in (FIRST, SECOND):
            k = int(token == SECOND)
            low, high = box[k]
            middle = (low + high) / 2
            pairs = [_halves(net, k) for net in (p, q)]
            for end in (1, 0):
                side = (low, middle) if end == 0 else (middle, high)
                half = (box[0], side) if k else (side, box[1])
                todo.append((half, pairs[0][end], pairs[1][end]))
        elif type(token) is int:
            require(0 <= token < len(regions), "the number of a region that does not exist")
            inside = all(a <= low <= high <= b for (low, high), (a, b) in zip(box, regions[token], strict=True))
            require(inside, "a box that is not inside the region of a zero")
        else:
            require(type(token) is list, "neither a cut, a region nor a combination")
            a, b = map(integer, token)
            require(_sign(_combined(p, a, q, b)) != 0, "a box on which the combination has not one sign")
    require(not todo, "boxes that are missing")


def _halves(net: Net, direction: int) -> tuple[Net, Net]:
    rows = [halves_at(row, HALF) for row in (net if direction else _turned(net))]
    low, high = ([pair[k] for pair in rows] for k in (0, 1))
    return (low, high) if direction else (_turned(low), _turned(high))


def _turned(net: Net) -> Net:
    return [list(column) for column in zip(*net, strict=True)]


def _part(net: Net, box: Box) -> Net:
    """The Bernstein coefficients on a box, up to a positive constant that depends on the box and the degrees alone."""
    rows = [values_on(row, *box[1]) for row in net]
    return _turned([values_on(column, *box[0]) for column in _turned(rows)])


def _combined(f: Net, a: int, g: Net, b: int) -> Net:
    return [[a * x + b * y for x, y in zip(p, q, strict=True)] for p, q in zip(f, g, strict=True)]


def _sign(net: Net) -> int:
    """The strict sign of all coefficients, else 0."""
    values = [x for row in net for x in row]
    return 1 if min(values) > 0 else -1 if max(values) < 0 else 0


# ---- the region of a zero


def _region(f: Net, g: Net, zero: Mapping[str, Any]) -> Box:
    first, second = ((fraction(low), fraction(high)) for low, high in zero["region"])
    require(0 <= first[0] < first[1] <= 1 and 0 <= second[0] < second[1] <= 1, "a region that is not in the square")
    box = first, second
    parts = _part(f, box), _part(g, box)
    one, other = (_combined(parts[0], integer(a), parts[1], integer(b)) for a, b in zero["combinations"])
    require(_is_regular(one, other), "a region in which the Jacobian may be singular")
    require(zero["by"] in PROOFS, "a zero without a proof")
    PROOFS[zero["by"]](f, g, box, (one, other), zero)
    return box


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


def _is_crossed(f: Net, g: Net, box: Box, pair: tuple[Net, Net], zero: Mapping[str, Any]) -> None:
    one, other = pair[0], _turned(pair[1])
    signs = [_sign([net[0]]) * _sign([net[-1]]) for net in (one, other)]
    require(signs == [-1, -1], "sides without opposite signs")


def _is_at_point(f: Net, g: Net, box: Box, pair: tuple[Net, Net], zero: Mapping[str, Any]) -> None:
    point = [fraction(x) for x in zero["point"]]
    require(all(low <= x <= high for x, (low, high) in zip(point, box, strict=True)), "a point outside its region")
    require(all(_value(net, point) == 0 for net in (f, g)), "a point at which a function is not zero")


def _value(net: Net, point: Sequence[Fraction]) -> Fraction:
    return _blended([_blended(row, point[1]) for row in net], point[0])


def _blended(values: Sequence[Any], t: Fraction) -> Fraction:
    n = len(values) - 1
    return sum((comb(n, i) * (1 - t) ** (n - i) * t**i * x for i, x in enumerate(values)), Fraction(0))


def _is_on_edge(f: Net, g: Net, box: Box, pair: tuple[Net, Net], zero: Mapping[str, Any]) -> None:
    direction, end = (count(x) for x in zero["edge"])
    require(direction in (0, 1) and end in (0, 1) and box[direction][end] == end, "an edge that is not in the region")
    edges = [(_turned(net) if direction else net)[-end] for net in (f, g)]
    common = common_divisor(*([comb(len(b) - 1, i) * x for i, x in enumerate(b)] for b in edges))
    require(len(common) > 1 and changes_sign(common, *box[1 - direction]), "an edge without a zero")


Proof = Callable[[Net, Net, Box, tuple[Net, Net], Mapping[str, Any]], None]
PROOFS: dict[str, Proof] = {CROSSED: _is_crossed, POINT: _is_at_point, EDGE: _is_on_edge}
