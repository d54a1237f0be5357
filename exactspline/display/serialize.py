"""Features and derived objects as data: control points as exact text, roots as certified intervals."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from exactspline.errors import ExactSplineError
from exactspline.exact import mpq
from exactspline.geometry.analysis import analyse
from exactspline.geometry.angles import Angle
from exactspline.geometry.derived import Derived
from exactspline.geometry.enclosures import curvature_value, torsion_value
from exactspline.geometry.extent import turning_points
from exactspline.geometry.inspection import Inspection
from exactspline.geometry.joints import Joint
from exactspline.geometry.kinds import CurvePiece, Feature, Interval
from exactspline.language.choices import Side
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector
from exactspline.roots.root import Root, knot_root
from exactspline.splines.bspline import BSpline
from exactspline.splines.common import with_common_knots
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surd import Surd, significant
from exactspline.splines.values import SplineVector


def feature_data(curve: Nurbs, f: Feature, digits: int) -> dict[str, object]:
    """A feature as data: the parameter exactly, as an interval and to so many digits; κ there where
    γ′ ≠ 0, in space also τ; and the angle of a corner.
    """
    low, high = f.root.refine(digits)
    joint = analyse(curve).joint(f.root.low) if f.at_knot else None
    data: dict[str, Any] = {
        "kind": str(f.kind),
        "parameter": str(f.root.exact) if f.root.exact is not None else None,
        "interval": [str(low), str(high)],
        "decimal": decimal_of(f.root, digits),
        "at_knot": f.at_knot,
        "by_jump": f.by_jump,
        "of_absolute": str(f.of_absolute or ""),
        "angle": angle_data(joint.angle if joint else None, digits),
    }
    if f.form != "D1":
        data["curvature"] = value_of(curvature_value, curve, f.root, digits)
        if curve.dimension == 3:
            data["torsion"] = value_of(torsion_value, curve, f.root, digits)
    return data


def angle_data(angle: Angle | None, digits: int) -> dict[str, str] | None:
    """An angle: its cosine and sine exactly, and degrees to so many digits."""
    from mpmath import nstr

    if angle is None:
        return None
    degrees = str(nstr(angle.degrees(digits), digits, strip_zeros=True)).removesuffix(".0")
    return {"cosine": exactly(angle.cosine), "sine": exactly(angle.sine), "degrees": degrees}


def exactly(number: mpq | Surd) -> str:
    """A number ``a√b`` with an ASCII minus sign."""
    return str(number).replace("−", "-")


def joint_data(curve: Nurbs, joint: Joint, digits: int) -> dict[str, object]:
    """A joint as data: its kind and order of geometric continuity, the angle of a corner, the width of a
    gap, and the curvatures of both sides where they differ, exactly and to so many digits.
    """
    from mpmath import nstr

    root = knot_root(joint.parameter)
    jump = joint.curvatures is not None
    return {
        "kind": str(joint.kind),
        "parameter": str(joint.parameter),
        "decimal": decimal_of(root, digits),
        "at_seam": joint.at_seam,
        "geometric_continuity": joint.order,
        "angle": angle_data(joint.angle, digits),
        "gap": None if joint.gap is None else exactly(joint.gap),
        "gap_decimal": None
        if joint.gap is None
        else str(nstr(significant(joint.gap, digits + 8), digits, strip_zeros=True)),
        "curvatures": [exactly(x) for x in joint.curvatures] if joint.curvatures is not None else None,
        "curvature": value_of(curvature_value, curve, root, digits) if jump else None,
    }


def decimal_of(root: Root, digits: int) -> str:
    """A root to so many digits behind the point."""
    from mpmath import mp, nstr

    with mp.workdps(digits + 10):
        value = root.mpf(digits + 2)
        return str(
            nstr(value, digits + max(int(mp.floor(mp.log10(abs(value)))) + 1, 1) if value else 1, strip_zeros=True)
        )


def value_of(quantity: Callable[[Nurbs, Root, int, str], object], curve: Nurbs, root: Root, digits: int) -> str:
    """κ or τ at a root to so many significant digits, 0 where it is exactly 0; at a joint the limits from both sides
    where they differ; the reason where there is none.
    """
    from mpmath import mp, nstr

    facts = analyse(curve)
    joint = facts.joint(root.low) if root.at_knot else None

    def shown(side: Side | str) -> str:
        at = root if joint is None else knot_root(facts.sides(root.low)[side == Side.RIGHT])
        with mp.workdps(digits + 10):
            value = quantity(curve, at, digits + 8, side)
            return str(nstr(value, digits, strip_zeros=True)) if value else "0"

    try:
        values = [shown(side) for side in ((Side.LEFT, Side.RIGHT) if joint is not None else (Side.RIGHT,))]
    except ExactSplineError as error:
        return str(error)
    return " | ".join(dict.fromkeys(values))


def inspection_data(
    curve: Nurbs, found: Inspection, digits: int, tick: Callable[[], None] = lambda: None
) -> dict[str, object]:
    """The whole inspection as data; `tick` is called after every feature.

    A piece is the list of its intervals: two where it runs across the seam of a closed curve.
    """
    groups = {name: getattr(found, name) for name in groups_of(curve)}
    data: dict[str, Any] = {"curve": curve.name, "approach": found.approach, "closed": curve.closed, "digits": digits}
    for name, features in groups.items():
        data[name] = []
        for f in features:
            data[name].append(feature_data(curve, f, digits))
            tick()
    data["joints"] = [joint_data(curve, joint, digits) for joint in found.joints]
    data |= {
        "straight": [intervals_data(piece) for piece in found.straight],
        "constant_curvature": [intervals_data(piece) for piece in found.constant],
        "standing_still": [intervals_data(piece) for piece in found.standing],
    }
    if curve.dimension == 3:
        data["planar"] = [
            {"intervals": intervals_data(piece), "plane": str(lies_in)} for piece, lies_in in found.planar
        ]
        data["plane"] = str(found.plane) if found.plane else None
    return data


def coordinate_extrema_data(curve: Nurbs, digits: int) -> list[dict[str, object]]:
    """The extrema of coordinates, as data."""
    return [
        feature_data(curve, f, digits) | {"coordinate": axis}
        for axis in range(curve.dimension)
        for f in turning_points(curve, axis)
    ]


def intervals_data(piece: CurvePiece) -> list[list[str]]:
    """The intervals of a piece."""
    return [[str(a), str(b)] for a, b in piece.parts]


def groups_of(curve: Nurbs) -> tuple[str, ...]:
    """The lists of features of an `Inspection` that a curve has."""
    return ("singular_points", "inflections", "critical", *(("torsion",) if curve.dimension == 3 else ()))


def derived_data(derived: Derived, curve: str) -> dict[str, object]:
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


def piece_data(interval: Interval, value: BSpline | SplineVector) -> dict[str, object]:
    """A spline, a vector of them or a `Rational` over an interval, by its control points."""
    head: dict[str, object] = {"interval": [str(t) for t in interval]}
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


def _net(components: list[Any], field: str) -> dict[str, object]:
    """Control points of several splines over the knots that carry them all."""
    raised = with_common_knots(components)
    knots = raised[0].knots
    return {
        "degree": raised[0].degree,
        "knots": [str(t) for t in knots],
        field: [[str(x) for x in row] for row in zip(*[c.control_points for c in raised])],
    }
