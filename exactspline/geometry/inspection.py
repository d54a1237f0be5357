"""Everything `inspect` tells of a curve: features with curvature and torsion to any precision, and the approaches side
by side.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from time import perf_counter
from typing import Any

from gmpy2 import mpq

from exactspline.errors import FormulaError
from exactspline.geometry import space_features
from exactspline.geometry.constructions import MINIMAL, construction
from exactspline.geometry.domain import plane
from exactspline.geometry.planarity import Plane, planar_pieces, plane_of
from exactspline.geometry.plane_features import constant_pieces, critical_points, inflections, straight_pieces
from exactspline.geometry.singular_points import singularities
from exactspline.geometry.zero_forms import zero_form
from exactspline.roots.zero_set import ZeroSet
from exactspline.splines.lowest_terms import control_point_count

#: The approaches to critical curvature by the names of the paper, and the forms they solve, in the plane and in space.
APPROACHES = {"squaring": "squaring", "direct": "direct", "reduced": "paper", "lifted": "lifted", "minimal": MINIMAL}


SPACE_APPROACHES = APPROACHES | {"reduced": "reduced"}


Interval = tuple[mpq, mpq]


@dataclass(frozen=True)
class Inspection:
    """The features of a curve, each list in the order of the parameter; intervals where the curve is straight or of
    constant curvature.

    Of a space curve also the zeros of the torsion and the intervals on which it lies in one plane, with that plane;
    ``inflections`` are then all regular points with κ = 0.
    """

    approach: str
    singularities: list[Any]
    inflections: list[Any]
    critical: list[Any]
    straight: list[Interval]
    constant: list[Interval]
    torsion: list[Any] = field(default_factory=list)
    planar: list[tuple[Interval, Plane]] = field(default_factory=list)
    plane: Plane | None = None


def inspect_curve(curve: Any, approach: str = "minimal") -> Inspection:
    """The features of a curve in the plane or in space by one of the `APPROACHES`.

    >>> from exactspline.splines.examples import example
    >>> len(inspect_curve(example("ellipse")).critical), len(inspect_curve(example("rational_space_cubic")).critical)
    (4, 2)

    Raises `ShapeError` for a curve that is neither in the plane nor in space, `FormulaError` for an unknown approach.
    """
    if approach not in APPROACHES:
        raise FormulaError(f"no approach is called {approach!r}", remedy=f"there are {', '.join(APPROACHES)}, all")
    if curve.dimension == 3:
        s = space_features
        return Inspection(
            approach,
            singularities(curve),
            s.flat_points(curve),
            s.space_critical_points(curve, SPACE_APPROACHES[approach]),
            s.space_straight_pieces(curve),
            s.space_constant_pieces(curve),
            s.torsion_zeros(curve),
            planar_pieces(curve),
            plane_of(curve),
        )
    critical = critical_points(plane(curve), APPROACHES[approach])
    return Inspection(
        approach, singularities(curve), inflections(curve), critical, straight_pieces(curve), constant_pieces(curve)
    )


def solved(curve: Any, approach: str) -> list[tuple[str, str, Any, ZeroSet]]:
    """What an inspection solves: names, titles, functions and their zeros.

    >>> from exactspline.splines.examples import example
    >>> [name for name, *_ in solved(example("twisted_cubic"), "minimal")]
    ['zero_torsion', 'space_critical_curvature', 'zero_curvature']
    """
    if curve.dimension == 3:
        forms = (("zero_torsion", "paper"), ("space_critical_curvature", SPACE_APPROACHES[approach]))
        extra = [("zero_curvature", "common factor of γ′ × γ″", *space_features.curvature_zeros(curve))]
    else:
        forms, extra = (("zero_curvature", MINIMAL), ("critical_curvature", APPROACHES[approach])), []
    return [(name, construction(name).title, *zero_form(curve, name, form)) for name, form in forms] + extra


@dataclass(frozen=True)
class Approach:
    """What one approach to critical curvature costs and finds.

    ``extraneous`` are roots that the minimal form does not have (the inflections of a plane curve that squaring adds,
    and singular points).
    """

    name: str
    degree: int
    control_points: int
    roots: int
    extraneous: int
    missing: int
    seconds: float


def compare_approaches(curve: Any) -> list[Approach]:
    """All approaches on one curve, their roots held exactly against those of the minimal form.

    >>> from exactspline.splines.examples import example
    >>> [(a.name, a.degree, a.roots, a.extraneous) for a in compare_approaches(example("six_segment_cubic"))]
    [('squaring', 24, 8, 2), ('direct', 6, 6, 0), ('reduced', 6, 6, 0), ('lifted', 6, 6, 0), ('minimal', 5, 6, 0)]
    """
    found: dict[str, tuple[Any, ZeroSet, float]] = {}
    in_space = curve.dimension == 3
    for name, form in (SPACE_APPROACHES if in_space else APPROACHES).items():
        start = perf_counter()
        f, zero_set = zero_form(curve, "space_critical_curvature" if in_space else "critical_curvature", form)
        found[name] = (f, zero_set, perf_counter() - start)
    true = list(found["minimal"][1])
    rows = []
    for name, (f, zero_set, seconds) in found.items():
        own = list(zero_set)
        extraneous, missing = sum(root not in true for root in own), sum(root not in own for root in true)
        rows.append(Approach(name, f.degree, control_point_count(f), len(own), extraneous, missing, seconds))
    return rows
