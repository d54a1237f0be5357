"""Checks a certificate of the common points of two plane curves, with only the standard library.

Points of two segments are common zeros of two functions of both parameters, the differences of the coordinates times
both weights; these are computed here from the control points, and their zeros are proved as those of any functions
(`exactspline.certificates.common_zeros`).

A segment consists of three lists of integers: for every control point its coordinates times the weight, and the weight.
"""

from collections.abc import Mapping
from typing import Any

from exactspline.certificates.common_zeros import ZEROS, Net, multiplicities_on_patch
from exactspline.certificates.numbers import count, each, integer, read, require, require_each_once

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
        return multiplicities_on_patch(functions, pair["zeros"], pair["boxes"])

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
