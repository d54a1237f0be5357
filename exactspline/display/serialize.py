"""Bisectors as data for programs: control nets as exact text, ends of pieces as certified roots."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from exactspline.errors import ExactSplineError
from exactspline.exact import text
from exactspline.geometry.bisectors import CurveBisector, PointBisector
from exactspline.geometry.continuity import inside, sides
from exactspline.geometry.derived import Derived
from exactspline.geometry.enclosures import curvature_value, torsion_value
from exactspline.geometry.inspection import Inspection
from exactspline.geometry.trimmed_bisector import TrimmedBisector
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector
from exactspline.roots.root import Root, knot_root
from exactspline.splines.common import with_common_knots
from exactspline.splines.tensor import TensorSpline


def curve_bisector_data(found: CurveBisector) -> dict[str, Any]:
    """The patches of the bisector of two curves, by homogeneous control nets ``(w x, w y, w z, w)`` with rows along
    s.
    """
    patches = []
    for patch in found.patches:
        numerator, w = patch.value.elevated()
        patches.append({"sides": [[text(x) for x in side] for side in patch.sides]} | _control_net([*numerator, w]))
    missing = [
        {"sides": [[text(x) for x in side] for side in sides], "reason": reason} for sides, reason in found.missing
    ]
    return {"kind": "bisector of two curves", "variant": found.variant, "patches": patches, "missing": missing}


def _control_net(splines: list[TensorSpline]) -> dict[str, Any]:
    """The control nets of several splines over the knots that carry them all."""
    splines = with_common_knots(splines)
    first = splines[0]
    rows = zip(*[x.control_points for x in splines], strict=True)
    return {
        "degree": list(first.degree),
        "knots": [[text(t) for t in knots] for knots in first.knots],
        "homogeneous_control_net": [[[text(x) for x in point] for point in zip(*row, strict=True)] for row in rows],
    }


def point_bisector_data(found: PointBisector, digits: int) -> dict[str, Any]:
    """The pieces of the ruled bisector of a point and a curve: directrix and generator by homogeneous control
    points.
    """
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
    return {
        "kind": "ruled bisector",
        "variant": found.variant,
        "pieces": pieces,
        "singular": singular,
        "missing": missing,
    }


def trimmed_data(found: TrimmedBisector, digits: int) -> dict[str, Any]:
    """The pieces of the true bisector of a point and a plane curve."""
    pieces = []
    for piece in found.pieces:
        ends = {"low": parameter_data(piece.low, digits), "high": parameter_data(piece.high, digits)}
        foot = {} if piece.foot is None else {"foot": text(piece.foot)}
        pieces.append({"piece": piece.kind} | foot | ends | piece_data(piece.value.denominator.domain, piece.value))
    return {"kind": "trimmed bisector", "pieces": pieces, "missing": list(found.missing)}


def parameter_data(t: Any, digits: int) -> dict[str, Any]:
    """A parameter, rational or a certified root: exactly where it is rational, in an interval, and to so many
    digits.
    """
    if not isinstance(t, Root):
        return {
            "parameter": text(t),
            "interval": [text(t), text(t)],
            "decimal": decimal_of(Root(t, t, (1, 1), (0, 0)), digits),
        }
    low, high = t.refine(digits)
    return {
        "parameter": None if t.exact is None else text(t.exact),
        "interval": [text(low), text(high)],
        "decimal": decimal_of(t, digits),
    }


def degree_of(value: Any) -> str:
    """The degree of a piece, for people."""
    d = value.degree
    return f"{d[0]} × {d[1]}" if isinstance(d, tuple) else str(d)


def counted(value: Any) -> int:
    """The number of control points of a patch."""
    top = value.numerator[0] if isinstance(value.numerator, Vector) else value.numerator
    m, n = top.elevated_to(value.denominator).control_point_counts
    return int(m * n)


def feature_data(curve: Any, f: Any, digits: int) -> dict[str, Any]:
    """A feature as data for programs: the parameter exactly, as an interval and to so many digits, and κ there."""
    low, high = f.root.refine(digits)
    data = {
        "kind": f.kind,
        "parameter": str(f.root.exact) if f.root.exact is not None else None,
        "interval": [str(low), str(high)],
        "decimal": decimal_of(f.root, digits),
        "at_knot": f.at_knot,
        "by_jump": f.by_jump,
    }
    regular = curve.dimension == 3 and f.form != "D1"
    if f.of_absolute or regular:
        data |= {"of_absolute": f.of_absolute, "curvature": value_of(curvature_value, curve, f, digits)}
    if regular:
        zero = f.kind in ("torsion zero", "torsion touch", "torsion end") and not f.by_jump
        data |= {"torsion": "0" if zero else value_of(torsion_value, curve, f, digits)}
    return data


def decimal_of(root: Root, digits: int) -> str:
    """A root to so many digits behind the point."""
    from mpmath import mp, nstr

    with mp.workdps(digits + 10):
        value = root.mpf(digits + 2)
        return str(
            nstr(value, digits + max(int(mp.floor(mp.log10(abs(value)))) + 1, 1) if value else 1, strip_zeros=True)
        )


def value_of(quantity: Callable[..., Any], curve: Any, f: Any, digits: int) -> str:
    """κ or τ at a feature to so many digits, where it jumps its limits from both sides; the reason where it cannot be
    told.
    """
    from mpmath import mp, nstr

    def shown(side: str) -> str:
        at = sides(curve, f.root.low)[side == "right"] if f.at_knot else None
        root = f.root if at is None else knot_root(at)
        with mp.workdps(digits + 10):
            return str(nstr(quantity(curve, root, digits + 5, side), digits, strip_zeros=True))

    try:
        values = [
            shown(side)
            for side in (
                ("left", "right") if curve.dimension == 3 and f.at_knot and inside(curve, f.root.low) else ("right",)
            )
        ]
    except ExactSplineError as error:
        return str(error)
    return " | ".join(dict.fromkeys(values))


def inspection_data(
    curve: Any, found: Inspection, digits: int, tick: Callable[[], None] = lambda: None
) -> dict[str, Any]:
    """All of it as data for programs; `tick` is called after every feature."""
    groups = {name: getattr(found, name) for name in groups_of(curve)}
    data: dict[str, Any] = {"curve": curve.name, "approach": found.approach, "closed": curve.closed, "digits": digits}
    for name, features in groups.items():
        data[name] = []
        for f in features:
            data[name].append(feature_data(curve, f, digits))
            tick()
    intervals = {"straight": found.straight, "constant_curvature": found.constant}
    data |= {name: [[str(a), str(b)] for a, b in pieces] for name, pieces in intervals.items()}
    if curve.dimension == 3:
        data["planar"] = [{"interval": [str(a), str(b)], "plane": str(lies_in)} for (a, b), lies_in in found.planar]
        data["plane"] = str(found.plane) if found.plane else None
    return data


def groups_of(curve: Any) -> tuple[str, ...]:
    """The lists of features of an `Inspection` that a curve has."""
    return ("singularities", "inflections", "critical", *(("torsion",) if curve.dimension == 3 else ()))


def derived_data(derived: Derived, curve: str) -> dict[str, Any]:
    """A derived object as JSON data: control points as exact text, piece by piece.

    A quotient is given by homogeneous control points ``(w x, w y, …, w)``, a scalar one by ``(w f, w)``.
    """
    return {
        "name": derived.name,
        "variant": derived.variant,
        "curve": curve,
        "layout": "directrix, generator" if derived.ruled else "",
        "pieces": [piece_data(piece.interval, piece.value) for piece in derived.pieces],
        "missing": [{"interval": [str(a), str(b)], "reason": reason} for (a, b), reason in derived.missing],
    }


def piece_data(interval: Any, value: Any) -> dict[str, Any]:
    """A spline, a vector of them or a `Rational` over an interval, by its control points."""
    head = {"interval": [str(t) for t in interval]}
    if isinstance(value, Rational):
        numerator, denominator = value.elevated()
        components = [*(numerator if isinstance(numerator, Vector) else [numerator]), denominator]
        return head | {"kind": "rational"} | _net(components, "homogeneous_control_points")
    if isinstance(value, Vector):
        return head | {"kind": "polynomial"} | _net(list(value), "control_points")
    points = [str(b) for b in value.control_points]
    return head | {
        "kind": "function",
        "degree": value.degree,
        "knots": [str(t) for t in value.knots],
        "control_points": points,
    }


def _net(components: list[Any], field: str) -> dict[str, Any]:
    """Control points of several splines over the knots that carry them all."""
    raised = with_common_knots(components)
    knots = raised[0].knots
    return {
        "degree": raised[0].degree,
        "knots": [str(t) for t in knots],
        field: [[str(x) for x in row] for row in zip(*[c.control_points for c in raised])],
    }
