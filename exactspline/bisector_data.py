"""Bisectors as data for programs: control nets as exact text, ends of pieces as certified roots."""

from __future__ import annotations

from typing import Any

from exactspline.bisectors import CurveBisector, PointBisector
from exactspline.exact import text
from exactspline.inspection import decimal_of
from exactspline.language import Vector
from exactspline.surface import TensorSpline
from exactspline.tables import piece_data
from exactspline.trimming import TrimmedBisector
from exactspline.zeros import Root


def curve_bisector_data(found: CurveBisector) -> dict[str, Any]:
    """The patches of the bisector of two curves, by homogeneous control nets ``(w x, w y, w z, w)`` with rows along s."""
    patches = []
    for patch in found.patches:
        numerator, w = patch.value.raised()
        patches.append({"sides": [[text(x) for x in side] for side in patch.sides]} | _net([*numerator, w]))
    missing = [{"sides": [[text(x) for x in side] for side in sides], "reason": reason} for sides, reason in found.missing]
    return {"kind": "bisector of two curves", "form": found.form, "patches": patches, "missing": missing}


def _net(splines: list[TensorSpline]) -> dict[str, Any]:
    """The control nets of several splines over the knots that carry them all."""
    common = splines[0] * 0
    for x in splines[1:]:
        common = common + x * 0
    splines = [x + common for x in splines]
    first = splines[0]
    rows = zip(*[x.control_points for x in splines], strict=True)
    return {
        "degree": list(first.degree),
        "knots": [[text(t) for t in knots] for knots in first.knots],
        "homogeneous_control_net": [[[text(x) for x in point] for point in zip(*row, strict=True)] for row in rows],
    }


def point_bisector_data(found: PointBisector, digits: int) -> dict[str, Any]:
    """The pieces of the ruled bisector of a point and a curve: directrix and generator by homogeneous control points."""
    pieces = [
        {
            "interval": [text(x) for x in piece.interval],
            "moved": piece.moved,
            "directrix": piece_data(piece.interval, piece.surface.directrix),
            "generator": piece_data(piece.interval, piece.surface.generator),
        }
        for piece in found.pieces
    ]
    missing = [{"interval": [text(a), text(b)], "reason": reason} for (a, b), reason in found.missing]
    singular = [parameter_data(root, digits) for root in found.singular]
    return {"kind": "ruled bisector", "form": found.form, "pieces": pieces, "singular": singular, "missing": missing}


def trimmed_data(found: TrimmedBisector, digits: int) -> dict[str, Any]:
    """The pieces of the true bisector of a point and a plane curve."""
    pieces = []
    for piece in found.pieces:
        ends = {"low": parameter_data(piece.low, digits), "high": parameter_data(piece.high, digits)}
        foot = {} if piece.foot is None else {"foot": text(piece.foot)}
        pieces.append({"piece": piece.kind} | foot | ends | piece_data(piece.value.denominator.domain, piece.value))
    return {"kind": "trimmed bisector", "pieces": pieces, "missing": list(found.missing)}


def parameter_data(t: Any, digits: int) -> dict[str, Any]:
    """A parameter, rational or a certified root: exactly where it is rational, in an interval, and to so many digits."""
    if not isinstance(t, Root):
        return {"parameter": text(t), "interval": [text(t), text(t)], "decimal": decimal_of(Root(t, t, (1, 1), (0, 0)), digits)}
    low, high = t.refine(digits)
    return {"parameter": None if t.exact is None else text(t.exact), "interval": [text(low), text(high)], "decimal": decimal_of(t, digits)}


def degree_of(value: Any) -> str:
    """The degree of a piece, for people."""
    d = value.degree
    return f"{d[0]} × {d[1]}" if isinstance(d, tuple) else str(d)


def counted(value: Any) -> int:
    """The number of control points of a patch."""
    top = value.numerator[0] if isinstance(value.numerator, Vector) else value.numerator
    m, n = top.raised_to(value.denominator).control_point_counts
    return int(m * n)
