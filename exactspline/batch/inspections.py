"""The features that a sweep can search for, by name."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from exactspline.batch.lines import Found
from exactspline.errors import FormulaError, nearest
from exactspline.geometry import features
from exactspline.geometry.joints import Joint
from exactspline.geometry.kinds import CurvePiece, Feature
from exactspline.roots.root import Root
from exactspline.splines.nurbs import Nurbs

Points = Sequence[Feature] | Sequence[Joint] | Sequence[CurvePiece]
#: Name → the function that finds it.
INSPECTIONS: dict[str, Callable[[Nurbs], Points]] = {
    "inflections": features.inflections,
    "extrema": features.curvature_extrema,
    "corners": features.corners,
    "critical_points": features.critical_points,
    "singular_points": features.singular_points,
    "joints": features.joints,
    "straight_pieces": features.straight_pieces,
    "constant_pieces": features.constant_pieces,
    "torsion_zeros": features.torsion_zeros,
}
#: The default inspections.
USUAL = ("inflections", "extrema", "corners")
#: Digits that are found beyond those that are told: an interval as wide as a decimal's last place is rarely inside.
BEYOND = 4
#: Inspections of space curves only.
IN_SPACE = ("torsion_zeros",)


def checked_names(names: Iterable[str]) -> tuple[str, ...]:
    """The names of inspections, each once; ``all`` is all of them.

    Raises `FormulaError` with the nearest names.
    """
    chosen: dict[str, None] = {}
    for name in names:
        if name != "all" and name not in INSPECTIONS:
            raise FormulaError(
                f"nothing called {name!r} can be looked for", remedy=nearest(name, [*INSPECTIONS, "all"])
            )
        chosen |= dict.fromkeys(INSPECTIONS if name == "all" else [name])
    return tuple(chosen)


def inspected(curve: Nurbs, names: Iterable[str], digits: int) -> dict[str, tuple[Found, ...]]:
    """The features of a curve, by name; those that its dimension cannot have are skipped.

    >>> from exactspline import example
    >>> for each in inspected(example("six_segment_cubic"), ["inflections"], 3)["inflections"]:
    ...     print(each.kind, each.parameter, each.low, each.high)
    inflection None 2.804 2.805
    inflection None 3.270 3.271

    Raises `ShapeError` for a curve that is neither in the plane nor in space.
    """
    wanted = [name for name in names if curve.dimension == 3 or name not in IN_SPACE]
    return {name: tuple(_told(each, digits) for each in INSPECTIONS[name](curve)) for name in wanted}


def _told(each: Feature | Joint | CurvePiece, digits: int) -> Found:
    if isinstance(each, Feature):
        low, high = enclosed(each.root, digits)
        return Found(str(each.kind), low if low == high else None, low, high)
    if isinstance(each, Joint):
        return Found(str(each.kind), str(each.parameter), str(each.parameter), str(each.parameter))
    return Found("piece across the seam" if each.across_seam else "piece", None, str(each.start), str(each.end))


def enclosed(root: Root, digits: int) -> tuple[str, str]:
    """Where a root lies, in a way that does not depend on what was asked of it before: a rational one exactly, an
    irrational one between two neighbouring decimals.

    >>> from exactspline import BSpline, zeros
    >>> t = BSpline.identity(0, 1)
    >>> [enclosed(root, 4) for root in zeros((3 * t - 1) * (2 * t * t - 1))]
    [('1/3', '1/3'), ('0.7071', '0.7072')]
    """
    if root.exact is not None:
        return str(root.exact), str(root.exact)
    scale, more = 10**digits, digits + BEYOND
    while True:
        low, high = root.refine(more)
        below = int((low * scale).numerator // (low * scale).denominator)
        if high * scale < below + 1:
            return _decimal(below, digits), _decimal(below + 1, digits)
        more += 10


def _decimal(scaled: int, digits: int) -> str:
    """A whole number divided by a power of ten, as a decimal."""
    sign, text = "-" if scaled < 0 else "", str(abs(scaled)).rjust(digits + 1, "0")
    return f"{sign}{text[:-digits]}.{text[-digits:]}" if digits else f"{sign}{text}"
