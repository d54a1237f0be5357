"""Checks a certificate of the zeros of a function of two parameters and of their topology, with only the standard
library.

On each patch the function is given by integers, its Bernstein coefficients on the unit square up to a positive
constant, and by factors whose powers multiply to it up to a constant. Factors in one parameter have lines as zeros. The
product of the others, each taken once, is examined: the square is cut along some lines, and its parts are halved, as
the certificate says, until in each box the product has Bernstein coefficients of one strict sign, or one of its
derivatives has. In the second case the zeros are a graph over the other direction, and signs at rational points between
the zeros on the sides show which of these zeros are joined. Every singular point has its own box, in which the number
of branches that leave it is proved. An isolated point counts unless it is on one of the lines.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import reduce
from itertools import pairwise
from math import comb, gcd, lcm
from typing import Any

from exactspline.certificates.common_zeros import (
    FIRST,
    NET,
    REGION,
    SECOND,
    Box,
    Net,
    Side,
    cut,
    on_each_patch,
    part,
    sign_on,
    turned,
)
from exactspline.certificates.elimination import (
    SINGLE_ZERO,
    Polynomial,
    at_height,
    check_single_zero,
    common_divisor,
    composed,
    integral,
    is_free,
    powers_of_net,
    quotient_by,
    quotient_over,
    require_only_root,
    require_place,
    sign_over,
    subresultant,
    total,
    trimmed,
    value_of,
    value_over,
    zero_at,
)
from exactspline.certificates.numbers import count, each, fraction, integer, one_of, read, require, within
from exactspline.certificates.zeros import ISOLATION, isolated_zeros, product_of, values_on

#: A zero on a line: its direction (0: x is constant), the value, and the index there; or both coordinates.
Vertex = tuple[Any, ...]
UNIT = Fraction(0), Fraction(1)
#: The kinds of boxes: the product has one sign, or its zeros are a graph, since a derivative has one sign.
SIGN, ACROSS = "sign", ("first monotone", "second monotone")
#: The form of the proof for the box of a singular point.
NODE, POINT, BRANCHES = "node", "point", "branches"


def check_zero_curves(certificate: Mapping[str, object]) -> dict[str, int]:
    """The numbers of lines, closed loops, arcs, curves with crossings and single points that a certificate proves, each
    counted on every patch that has it.
    """
    found = on_each_patch(certificate, PATCH, lambda patch: _OnPatch(patch).counts)
    return {key: sum(one[key] for one in found) for key in ("lines", "loops", "arcs", "crossed", "points")}


def _net(given: object) -> Net:
    net: Net = read(given, NET)
    require(len(net) > 0 and len({len(row) for row in net}) == 1 and len(net[0]) > 0, "rows of different lengths")
    return net


def _factor(given: object) -> dict[str, Any]:
    """A factor and its power, in one parameter also its zeros."""
    factor = read(given, {"net": _net, "power": count})
    return {**factor, **(read(given, {"isolation": ISOLATION}) if _is_line(factor["net"]) else {})}


def _token(given: object) -> int | str:
    """A cut, the statement that is proved about a box, or the number of a cell."""
    return given if isinstance(given, str) and given in (FIRST, SECOND, SIGN, *ACROSS) else count(given)


CELL: dict[str, object] = {"box": REGION, "region": REGION, "zero": SINGLE_ZERO}
MONIC = {"minimal": [integer], "factor": [[integer]], "below": integer, "power": count}
PATCH = {
    "function": _net,
    "factors": [_factor],
    "cuts": ([fraction], [fraction]),
    "boxes": [_token],
    "cells": [one_of("kind", {NODE: CELL, POINT: CELL, BRANCHES: {"box": REGION, "region": REGION, **MONIC}})],
    "zeros": [(count, fraction, {"isolation": ISOLATION, "places": [(fraction, fraction)]})],
}


class _OnPatch:
    """The zeros on one patch."""

    def __init__(self, patch: Mapping[str, Any]) -> None:
        factors = patch["factors"]
        _check_product(patch["function"], factors)
        self.lines = _lines(factors)
        count = sum(each("factors", _zeros_of, factors))
        self.counts = {"lines": count, "loops": 0, "arcs": 0, "crossed": 0, "points": 0}
        self.net: Net = reduce(net_product, [own["net"] for own in factors if not _is_line(own["net"])], [[1]])
        self._ways: list[tuple[Vertex, Vertex]] = []
        self._vertices: dict[Vertex, None] = {}
        self._crossed: list[Vertex] = []
        self._factors: dict[tuple[int, Fraction], list[Polynomial]] = {}
        self.zeros = dict(each("zeros", self._line, patch["zeros"]))
        self.cells = patch["cells"]
        self._subdivide(patch["cuts"], patch["boxes"])
        self._join()

    def _line(self, given: tuple[int, Fraction, Mapping[str, Any]]) -> tuple[tuple[int, Fraction], list[Side]]:
        """A line, and the places of all zeros of the product on it, in order."""
        direction, at, own = given
        require(direction in (0, 1) and 0 <= at <= 1, "a line that does not cross the square")
        form = on_line(self.net, direction, at)
        zeros = isolated_zeros([comb(len(form) - 1, i) * x for i, x in enumerate(form)], own["isolation"])
        places = own["places"]
        require(len(places) == len(zeros), "another number of zeros on a line")
        for (a, b), zero in zip(places, zeros, strict=True):
            require_place(zero, a, b)
        self._factors[direction, at] = [factor for _, _, factor, _, _ in zeros]
        return (direction, at), places

    def _on_side(self, direction: int, at: Fraction, side: Side) -> list[tuple[Vertex, Side]]:
        """The zeros on a part of a line, with their places on it."""
        require((direction, at) in self.zeros, "a line whose zeros are not given")
        found = list[tuple[Vertex, Side]]()
        for k, (a, b) in enumerate(self.zeros[direction, at]):
            if a == b:
                if side[0] <= a <= side[1]:
                    found.append((("point", *((at, a) if direction == 0 else (a, at))), (a, b)))
                continue
            require(not any(a <= end <= b for end in side), "a place that is not apart from an end of the box")
            if side[0] < a and b < side[1]:
                found.append((("line", direction, at, k), (a, b)))
        return found

    # ---- boxes

    def _subdivide(self, cuts: Sequence[Sequence[Fraction]], tokens: Sequence[Any]) -> None:
        require(all(len(ends) > 1 and (ends[0], ends[-1]) == UNIT for ends in cuts), "cuts that miss the border")
        require(all(a < b for ends in cuts for a, b in pairwise(ends)), "cuts that do not ascend")
        boxes = [(first, second) for first in pairwise(cuts[0]) for second in pairwise(cuts[1])]
        todo = [(box, [part(self.net, box)]) for box in boxes[::-1]]
        seen = set[int]()
        for token in tokens:
            require(bool(todo), "more boxes than the cuts leave")
            box, (net,) = todo.pop()
            if token in (FIRST, SECOND):
                todo += cut(box, [net], int(token == SECOND))
            elif token == SIGN:
                require(sign_on(net) != 0, "a box on which the function does not have one sign")
            elif token in ACROSS:
                k = ACROSS.index(token)
                require(sign_on(_differences(net, k)) != 0, "a box on which the derivative does not have one sign")
                self._graph(box, k)
            else:
                require(0 <= token < len(self.cells), "a cell that does not exist")
                within("cells", within, token, self._cell, box, self.cells[token])
                seen.add(token)
        require(not todo, "boxes that are missing")
        require(len(seen) == len(self.cells), "a cell that is not a box")

    def _graph(self, box: Box, direction: int) -> None:
        """The zeros in a box in which there is at most one zero on every line of this direction."""
        (a, b), (c, d) = box[direction], box[1 - direction]
        events: dict[Vertex, Side] = {}
        for at in (a, b):
            events.update(self._on_side(direction, at, (c, d)))
        for at in (c, d):
            events.update({vertex: (at, at) for vertex, _ in self._on_side(1 - direction, at, (a, b))})
        self._vertices.update(dict.fromkeys(events))
        for (first, (_, low)), (last, (high, _)) in pairwise(sorted(events.items(), key=lambda event: event[1])):
            require(low < high, "zeros whose order is not proved")
            middle = (low + high) / 2
            ends = [self._value_of((at, middle) if direction == 0 else (middle, at)) for at in (a, b)]
            if ends[0] * ends[1] < 0:
                self._ways.append((first, last))

    def _value_of(self, point: tuple[Fraction, Fraction]) -> int:
        return on_line(turned([on_line(self.net, 0, point[0])]), 0, point[1])[0]

    # ---- singular points

    def _cell(self, box: Box, cell: Mapping[str, Any]) -> None:
        require(cell["box"] == box, "a box that is not that of its cell")
        powers = powers_of_net(self.net)
        if cell["kind"] == BRANCHES:
            self._branches(box, cell, powers)
            return
        require(all(low > 0 and high < 1 for low, high in box), "a box on the border")
        slopes, region, zero = [_slope(powers, k) for k in (0, 1)], cell["region"], cell["zero"]
        inside = all(a <= low <= high <= b for (low, high), (a, b) in zip(region, box, strict=True))
        require(inside, "a region that is not in its box")
        check_single_zero([powers, *slopes], region, zero)
        bend = kind_by_hessian(part(self.net, box))
        if cell["kind"] == POINT:
            require(bend == POINT, "a Hessian that may not be definite")
            x = [Fraction(c, zero["below"]) for c in zero["above"]]
            y = total([Fraction(0), Fraction(1)], [-zero["slope"] * c for c in x])
            places = zip(self.lines, (x, y), strict=True)
            self._count_point([not composed([[c] for c in p], own, zero["minimal"]) for p, own in places], region)
            return
        require(bend == NODE, "a Hessian that may not be indefinite")
        ends = {v for k in (0, 1) for at in box[k] for v, _ in self._on_side(k, at, box[1 - k])}
        require(len(ends) == 4, "a node without four branches")
        self._meet(sorted(ends, key=repr), ("cell", box))

    def _meet(self, ends: Sequence[Vertex], at: Vertex) -> None:
        self._vertices.update(dict.fromkeys((*ends, at)))
        self._ways += [(at, end) for end in ends]
        if len(ends) > 2:
            self._crossed.append(at)

    def _branches(self, box: Box, cell: Mapping[str, Any], powers: Sequence[Sequence[int]]) -> None:
        """In the box no other line x = constant than that of the point has a multiple zero, and there is only one zero
        on it; no zero is on the sides below and above: all zeros on the sides left and right are ends of branches from
        that point.
        """
        (first, second), rows = box, [trimmed(column) for column in zip(*powers, strict=True)]
        slopes = trimmed([[j * x for x in row] for j, row in enumerate(rows)][1:])
        minimal, below, power, region = trimmed(cell["minimal"]), cell["below"], cell["power"], cell["region"]
        low, high = region[0]
        require_only_root(minimal, (low, high), first)
        # the discriminant: the resultant without the leading coefficient
        rest = quotient_by(subresultant(trimmed(rows), slopes, 0), trimmed(rows)[-1])
        require(bool(rest) and is_free(rest or [], minimal, first), "another multiple zero in the box")
        # over the root: the function is a power of the factor in y, whose only zero is the point, times another one
        require(below > 0, "a denominator that is not positive")
        factor = [[Fraction(x, below) for x in row] for row in cell["factor"]]
        require(len(factor) > 1 and trimmed(factor[-1]) == [1], "a factor that is not monic")
        require(all(len(row) < len(minimal) for row in factor), "a factor that is not reduced")
        require(power > 0, "a power that is not positive")
        other: list[list[Fraction]] | None = [[Fraction(x) for x in row] for row in rows]
        for _ in range(power):
            other = quotient_over(other or [], factor, minimal)
            require(other is not None, "a factor that does not divide")
        require(sign_over(other or [], (low, high), second) != 0, "another zero over the root")
        slope = [[j * x for x in row] for j, row in enumerate(factor)][1:]
        require(sign_over(slope, (low, high), second) != 0, "several zeros over the root")
        ends = [value_over(factor, at, (low, high), minimal) for at in second]
        require(ends[0] * ends[1] <= 0, "no zero over the root")
        for at, sign in zip(second, ends, strict=True):
            along = integral(at_height(rows, at))
            require(bool(along) and (sign != 0 or at in UNIT), "a point on a side of its box")
            require(is_free(along, [] if sign else minimal, first), "another zero on the side below or above")
        here = {low} if low == high and low in UNIT else set()
        require(all(x in here or not low <= x <= high for x in first), "a side that may be at the point")
        found = [v for x in first if x not in here for v, _ in self._on_side(0, x, second)]
        corner = self._corner(box, bool(here) and low in first, low, ends)
        if found or corner:
            self._meet(found, corner or ("cell", box))
            return
        ends = [value_over(factor, at, (low, high), minimal) for at in region[1]]
        require(second[0] <= region[1][0] and region[1][1] <= second[1], "a region that is not in its box")
        require(ends[0] * ends[1] <= 0, "a point that may be outside its region")
        across = quotient_over([[Fraction(c)] for c in self.lines[1]], factor, minimal)
        self._count_point([quotient_by(self.lines[0], minimal) is not None, across is not None], region)

    def _count_point(self, on_line: Sequence[bool], region: Box) -> None:
        """Count a point unless it is on one of the lines. The lines on which it is not must not meet its region."""
        for is_on, p, side in zip(on_line, self.lines, region, strict=True):
            require(is_on or is_free(p, [], side), "a point that may be on a line")
        self.counts["points"] += not any(on_line)

    def _corner(self, box: Box, on_side: bool, x: Fraction, ends: Sequence[int]) -> Vertex | None:
        """The point itself, if it is on the border of the square."""
        lines = [(0, x)] if on_side else [(1, at) for at, sign in zip(box[1], ends, strict=True) if sign == 0]
        for k, at in lines:
            own = self._on_side(k, at, box[1 - k])
            require(len(own) == 1, "a point that is not found on its border")
            return own[0][0]
        return None

    # ---- the topology

    def _join(self) -> None:
        parents = {vertex: vertex for vertex in self._vertices}

        def root(vertex: Vertex) -> Vertex:
            while parents[vertex] != vertex:
                vertex = parents[vertex]
            return vertex

        for one, other in self._ways:
            parents[root(one)] = root(other)
        degrees: dict[Vertex, int] = dict.fromkeys(self._vertices, 0)
        for vertex in (v for way in self._ways for v in way):
            degrees[vertex] += 1
        groups: dict[Vertex, list[int]] = {}
        for vertex, degree in degrees.items():
            groups.setdefault(root(vertex), []).append(degree)
        crossed = {root(vertex) for vertex in self._crossed}
        for group, own in groups.items():
            if not any(own) and self._is_on_line(group):
                continue
            shape = "crossed" if group in crossed else "points" if not any(own) else "arcs" if 1 in own else "loops"
            self.counts[shape] += 1

    def _is_on_line(self, vertex: Vertex) -> bool:
        """Whether a zero on the border is on one of the lines."""
        kind, *data = vertex
        if kind == "point":
            return any(value_of(p, x) == 0 for p, x in zip(self.lines, data, strict=True))
        direction, at, k = data
        along = self.lines[1 - direction]
        n = len(along) - 1
        form = [sum(comb(n - j, i - j) * along[j] for j in range(i + 1)) for i in range(n + 1)]
        own = self._factors[direction, at][k], *self.zeros[direction, at][k]
        return value_of(self.lines[direction], at) == 0 or zero_at(form, *own)


# ---- nets


def _is_line(net: Net) -> bool:
    """Whether a net is that of a function of one parameter."""
    return len(net) == 1 or len(net[0]) == 1


def net_product(one: Net, other: Net) -> Net:
    """The product, up to a positive constant."""
    m, n = len(one) + len(other) - 2, len(one[0]) + len(other[0]) - 2
    scaled = [
        [[comb(len(net) - 1, i) * comb(len(row) - 1, j) * x for j, x in enumerate(row)] for i, row in enumerate(net)]
        for net in (one, other)
    ]
    rows: list[list[int]] = [[0] * (n + 1) for _ in range(m + 1)]
    for i, first in enumerate(scaled[0]):
        for j, second in enumerate(scaled[1]):
            rows[i + j] = total(rows[i + j], product_of(first, second))
    weights = [[comb(m, i) * comb(n, j) for j in range(n + 1)] for i in range(m + 1)]
    common = lcm(*(x for row in weights for x in row))
    found = [[x * (common // c) for x, c in zip(*pair, strict=True)] for pair in zip(rows, weights, strict=True)]
    size = gcd(*(x for row in found for x in row)) or 1
    return [[x // size for x in row] for row in found]


def _check_product(function: Net, factors: Sequence[Mapping[str, Any]]) -> None:
    """Check that powers of factors multiply to a function, up to a constant that is not zero."""
    product: Net = [[1]]
    for net, power in ((own["net"], own["power"]) for own in factors):
        require(power > 0, "a factor whose power is not positive")
        require(power < len(function) + len(function[0]), "a factor whose power is too high")
        for _ in range(power):
            product = net_product(product, net)
    one, other = (_trimmed_powers(powers_of_net(net)) for net in (function, product))
    require(one != {} and one.keys() == other.keys(), "factors that do not multiply to the function")
    key = next(iter(one))
    require(
        all(one[k] * other[key] == other[k] * one[key] for k in one), "factors that do not multiply to the function"
    )


def _trimmed_powers(powers: Sequence[Sequence[int]]) -> dict[tuple[int, int], int]:
    return {(i, j): x for i, row in enumerate(powers) for j, x in enumerate(row) if x}


def _lines(factors: Sequence[Mapping[str, Any]]) -> tuple[Polynomial, Polynomial]:
    """The products of the factors in each parameter, after checking that no line is a zero of two factors, or of one of
    the curves.
    """
    known: tuple[list[Polynomial], list[Polynomial]] = [], []
    for net in (own["net"] for own in factors):
        powers = powers_of_net(net)
        for rows, others in zip((turned(powers), powers), known, strict=True):
            own = reduce(common_divisor, rows, list[int]())
            require(len(own) == 1 or _is_line(net), "a line among the curves")
            require(all(len(common_divisor(own, p)) == 1 for p in others), "a line of two factors")
            others.append(own)
    first, second = (reduce(product_of, own, [1]) for own in known)
    return first, second


def _zeros_of(factor: Mapping[str, Any]) -> int:
    """The number of lines on which a factor in one parameter vanishes; 0 for a factor in both parameters."""
    net = factor["net"]
    if not _is_line(net):
        return 0
    form = net[0] if len(net) == 1 else [x for (x,) in net]
    return len(isolated_zeros([comb(len(form) - 1, i) * x for i, x in enumerate(form)], factor["isolation"]))


def on_line(net: Net, direction: int, at: Fraction) -> list[int]:
    """The Bernstein coefficients on a line, up to a positive constant."""
    rows = net if direction else turned(net)
    return [values_on(row, at, at)[0] for row in rows] if 0 < at < 1 else [row[-int(at)] for row in rows]


def extremes(net: Net) -> tuple[int, int]:
    """The least and the largest coefficient; 0 and 0 for an empty net."""
    values = [x for row in net for x in row] or [0]
    return min(values), max(values)


def _differences(net: Net, direction: int) -> Net:
    if direction:
        return [[y - x for x, y in pairwise(row)] for row in net]
    return [[y - x for x, y in zip(p, q, strict=True)] for p, q in pairwise(net)]


def kind_by_hessian(net: Net) -> str:
    """The kind of a singular point in a box, if the Hessian is definite or indefinite on the whole box; otherwise
    empty.
    """
    second = [_differences(_differences(net, i), j) for i, j in ((0, 0), (0, 1), (1, 1))]
    # the differences are derivatives up to these factors
    m, n = len(net) - 1, len(net[0]) - 1
    scales = m * (m - 1), m * n, n * (n - 1)
    (a, b), (c, d), (e, f) = ((k * low, k * high) for k, (low, high) in zip(scales, map(extremes, second), strict=True))
    products, squares = [x * y for x in (a, b) for y in (e, f)], [c * c, d * d] + [0] * (c <= 0 <= d)
    if min(products) > max(squares) and (a > 0 or b < 0):
        return POINT
    return NODE if max(products) < min(squares) else ""


def _slope(powers: Sequence[Sequence[int]], k: int) -> list[list[int]]:
    if k == 0:
        return [[i * x for x in row] for i, row in enumerate(powers)][1:]
    return [[j * x for j, x in enumerate(row)][1:] for row in powers]
