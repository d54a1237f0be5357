"""The features that a sweep can search for, by name."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, TypeAlias

from exactspline.batch.lines import Found
from exactspline.errors import FormulaError, nearest
from exactspline.exact import mpq, mpz
from exactspline.geometry import features
from exactspline.geometry.corners import Corner, corner_places
from exactspline.geometry.joints import Joint
from exactspline.geometry.kinds import CurvePiece, Feature
from exactspline.roots.root import Root
from exactspline.splines.nurbs import Nurbs

if TYPE_CHECKING:
    from exactspline.geometry.many_roots import Irrational, Point, Settled

Points: TypeAlias = "Sequence[Point] | Sequence[Corner] | Sequence[Feature] | Sequence[Joint] | Sequence[CurvePiece]"
#: Name → the function that finds it.
INSPECTIONS: dict[str, Callable[[Nurbs], Points]] = {
    "inflections": features.inflections,
    "extrema": features.curvature_extrema,
    "corners": corner_places,
    "critical_points": features.critical_points,
    "singular_points": features.singular_points,
    "joints": features.joints,
    "straight_pieces": features.straight_pieces,
    "constant_pieces": features.constant_pieces,
    "torsion_zeros": features.torsion_zeros,
}
#: Name → what the filter, where it is certain, knows of it: a critical point is then an extremum.
FROM_THE_FILTER: dict[str, Callable[[Settled], Sequence[Point]]] = {
    "inflections": lambda settled: settled.inflections,
    "extrema": lambda settled: settled.extrema,
    "critical_points": lambda settled: settled.extrema,
    "singular_points": lambda _: (),
    "straight_pieces": lambda _: (),
    "constant_pieces": lambda _: (),
}
#: What no polygon has: its curvature vanishes identically.
NOT_OF_POLYGONS = ("inflections", "extrema", "critical_points", "torsion_zeros")
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


def inspected(
    curve: Nurbs, names: Iterable[str], digits: int, settled: Settled | None = None
) -> dict[str, tuple[Found, ...]]:
    """The features of a curve, by name; those that its dimension cannot have are skipped. `settled` is what the
    certified filter knows of it.

    >>> from exactspline import example
    >>> for each in inspected(example("six_segment_cubic"), ["inflections"], 3)["inflections"]:
    ...     print(each.kind, each.parameter, each.low, each.high)
    inflection None 2.804 2.805
    inflection None 3.270 3.271

    Raises `ShapeError` for a curve that is neither in the plane nor in space.
    """
    wanted = [name for name in names if curve.dimension == 3 or name not in IN_SPACE]
    return {name: tuple(_told(each, digits) for each in _points(curve, name, settled)) for name in wanted}


def _points(curve: Nurbs, name: str, settled: Settled | None) -> Points:
    if curve.degree == 1 and curve.dimension in (2, 3) and name in NOT_OF_POLYGONS:
        return ()
    if settled is None:
        return INSPECTIONS[name](curve)
    if name in FROM_THE_FILTER:
        return FROM_THE_FILTER[name](settled)
    # γ′ vanishes nowhere and is continuous
    smooth = name == "corners" and not curve.closed and all(order > 0 for order in curve.p[0].continuity)
    return () if smooth else INSPECTIONS[name](curve)


def _told(each: Point | Corner | Feature | Joint | CurvePiece, digits: int) -> Found:
    if isinstance(each, (Corner, Joint, CurvePiece)):
        return _told_exactly(each)
    low, high = enclosed(each.place if isinstance(each, tuple) else each.root, digits)
    return Found(str(each.kind), low if low == high else None, low, high)


def _told_exactly(each: Corner | Joint | CurvePiece) -> Found:
    if isinstance(each, (Corner, Joint)):
        return Found(str(each.kind), str(each.parameter), str(each.parameter), str(each.parameter))
    return Found("piece across the seam" if each.across_seam else "piece", None, str(each.start), str(each.end))


def enclosed(place: Root | Irrational, digits: int) -> tuple[str, str]:
    """Where a root lies, in a way that does not depend on what was asked of it before: a rational one exactly, an
    irrational one between two neighbouring decimals.

    >>> from exactspline import BSpline, zeros
    >>> t = BSpline.identity(0, 1)
    >>> [enclosed(root, 4) for root in zeros((3 * t - 1) * (2 * t * t - 1))]
    [('1/3', '1/3'), ('0.7071', '0.7072')]
    """
    scale = mpz(10) ** digits
    if not isinstance(place, Root):
        if (below := _neighbour(place.low, place.high, scale)) is not None:
            return _decimal(below, digits), _decimal(below + 1, digits)
        place = place.root
    if place.exact is not None:
        return str(place.exact), str(place.exact)
    more = digits + BEYOND
    while (below := _neighbour(*place.refine(more), scale)) is None:
        more += 10
    return _decimal(below, digits), _decimal(below + 1, digits)


def _neighbour(low: mpq, high: mpq, scale: mpz) -> int | None:
    """The integer k where [low, high] is inside of [k, k + 1] over a scale; None where there is none."""
    below = low.numerator * scale // low.denominator
    return int(below) if high.numerator * scale <= (below + 1) * high.denominator else None


def _decimal(scaled: int, digits: int) -> str:
    """A whole number divided by a power of ten, as a decimal."""
    sign, text = "-" if scaled < 0 else "", str(abs(scaled)).rjust(digits + 1, "0")
    return f"{sign}{text[:-digits]}.{text[-digits:]}" if digits else f"{sign}{text}"
