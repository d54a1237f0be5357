"""Everything `inspect` tells of a curve: features with curvature and torsion to any precision, and the approaches side by side."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import pairwise
from time import perf_counter
from typing import Any

from gmpy2 import mpq

from exactspline import space_features
from exactspline.constructions import MINIMAL, construction
from exactspline.errors import ExactSplineError, FormulaError
from exactspline.features import constant_pieces, critical_points, curvature_sign, inflections, singularities, straight_pieces
from exactspline.formulas import find
from exactspline.interrogate import plane
from exactspline.joints import inside, knot_root, sides, zero_form
from exactspline.language import Curve, Vector
from exactspline.measure import control_point_count
from exactspline.planar import Plane, planar_pieces, plane_of
from exactspline.readings.series import Series
from exactspline.zeros import Root, ZeroSet

#: The approaches to critical curvature by the names of the paper, and the forms they solve, in the plane and in space.
APPROACHES = {"squaring": "squaring", "direct": "direct", "reduced": "paper", "lifted": "lifted", "minimal": MINIMAL}
SPACE_APPROACHES = APPROACHES | {"reduced": "reduced"}
Interval = tuple[mpq, mpq]


@dataclass(frozen=True)
class Inspection:
    """The features of a curve, each list in the order of the parameter; intervals where the curve is straight or of constant curvature.

    Of a space curve also the zeros of the torsion and the intervals on which it lies in one plane, with that plane; ``inflections`` are then all
    regular points with κ = 0.
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

    >>> from exactspline.curves import example
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
    return Inspection(approach, singularities(curve), inflections(curve), critical, straight_pieces(curve), constant_pieces(curve))


def solved(curve: Any, approach: str) -> list[tuple[str, str, Any, ZeroSet]]:
    """What an inspection solves: names, titles, functions and their zeros.

    >>> from exactspline.curves import example
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

    ``invented`` are roots that the minimal form does not have (the inflections of a plane curve that squaring adds, and singular points).
    """

    name: str
    degree: int
    control_points: int
    roots: int
    invented: int
    missing: int
    seconds: float


def compare_approaches(curve: Any) -> list[Approach]:
    """All approaches on one curve, their roots held exactly against those of the minimal form.

    >>> from exactspline.curves import example
    >>> [(a.name, a.degree, a.roots, a.invented) for a in compare_approaches(example("six_segment_cubic"))]
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
        invented, missing = sum(root not in true for root in own), sum(root not in own for root in true)
        rows.append(Approach(name, f.degree, control_point_count(f), len(own), invented, missing, seconds))
    return rows


def curvature_value(curve: Any, root: Root, digits: int, side: str = "right") -> Any:
    """κ at a root as an mpmath number that is off by less than ``10^−digits`` (relatively, where it is larger than one).

    The Taylor coefficients at an enclosure of the root are taken in interval arithmetic, which bounds the error; the enclosure is refined until
    the bound holds.

    >>> from exactspline.curves import example
    >>> curvature_value(example("ellipse"), inspect_curve(example("ellipse")).critical[0].root, 10)
    mpf('2.0')
    """
    from mpmath import iv, mp

    in_space = curve.dimension == 3
    sign = space_features.curvature_sign_in_space(curve, root, side) if in_space else curvature_sign(curve, root)
    if sign == 0:
        return mp.mpf(0)
    formula = find("space_curvature_squared" if in_space else "curvature_squared")

    def enclosure(low: mpq, high: mpq) -> Any:
        squared = formula(_enclosed(curve, low, high, side)).value
        return iv.sqrt(squared) * sign if squared.a > 0 else None

    return _certified(root, digits, enclosure)


def torsion_value(curve: Any, root: Root, digits: int, side: str = "right") -> Any:
    """τ at a root (where κ = 0 its limit) as an mpmath number that is off by less than ``10^−digits``, as `curvature_value`.

    >>> from exactspline.curves import example
    >>> torsion_value(example("twisted_cubic"), inspect_curve(example("twisted_cubic")).critical[0].root, 10)
    mpf('3.0')

    Raises `FormulaError` at a singular point, where τ may have a pole.
    """
    if any(root == f.root for f in singularities(curve)):
        raise FormulaError("the torsion at a singular point", remedy="ask for it at regular points")
    tau = space_features.torsion_in_lowest_terms(curve)

    def enclosure(low: mpq, high: mpq) -> Any:
        top, bottom = [_enclose(f, low, high, side) for f in (tau.numerator, tau.denominator)]
        return top / bottom if bottom.a > 0 or bottom.b < 0 else None

    return _certified(root, digits, enclosure)


def _certified(root: Root, digits: int, enclosure: Callable[[mpq, mpq], Any]) -> Any:
    """A quantity at a root to so many digits: the root is refined until its enclosure (None: not yet known) is narrow enough."""
    from mpmath import iv, mp

    precision = digits + 10
    while True:
        low, high = root.refine(precision)
        saved = iv.dps
        try:
            iv.dps = precision + 10
            value = enclosure(low, high)
            if value is not None and value.delta <= mp.mpf(10) ** -digits * max(1, abs(value.mid)):
                with mp.workdps(digits + 5):
                    return mp.mpf(value.mid)
        finally:
            iv.dps = saved
        precision *= 2


def _interval(a: mpq, b: mpq) -> Any:
    """[a, b] in interval arithmetic."""
    from mpmath import iv

    ends = [iv.mpf(int(x.numerator)) / iv.mpf(int(x.denominator)) for x in (a, b)]
    return iv.mpf([ends[0].a, ends[1].b])


def _enclose(spline: Any, low: mpq, high: mpq, side: str) -> Any:
    """The values of a spline on [low, high], by de Casteljau's algorithm in interval arithmetic."""
    i = spline.mesh.locate(low, left=side == "left")
    a, b = spline.mesh.breaks[i : i + 2]
    t = _interval((low - a) / (b - a), (high - a) / (b - a))
    points = [_interval(x, x) for x in spline.segments[i]] or [_interval(mpq(0), mpq(0))]
    while len(points) > 1:
        points = [(1 - t) * p + t * q for p, q in pairwise(points)]
    return points[0]


def _enclosed(curve: Any, low: mpq, high: mpq, side: str) -> Curve:
    """The curve as a Taylor series with interval coefficients over [low, high]."""

    def series(spline: Any) -> Series:
        return Series([_enclose(spline.d(order), low, high, side) / max(order, 1) for order in range(3)])

    return Curve(Vector(*[series(x) for x in curve.p]), series(curve.w), polynomial=curve.polynomial)


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
        return str(nstr(value, digits + max(int(mp.floor(mp.log10(abs(value)))) + 1, 1) if value else 1, strip_zeros=True))


def value_of(quantity: Callable[..., Any], curve: Any, f: Any, digits: int) -> str:
    """κ or τ at a feature to so many digits, where it jumps its limits from both sides; the reason where it cannot be told."""
    from mpmath import mp, nstr

    def shown(side: str) -> str:
        at = sides(curve, f.root.low)[side == "right"] if f.at_knot else None
        root = f.root if at is None else knot_root(at)
        with mp.workdps(digits + 10):
            return str(nstr(quantity(curve, root, digits + 5, side), digits, strip_zeros=True))

    try:
        values = [shown(side) for side in (("left", "right") if curve.dimension == 3 and f.at_knot and inside(curve, f.root.low) else ("right",))]
    except ExactSplineError as error:
        return str(error)
    return " | ".join(dict.fromkeys(values))


def inspection_data(curve: Any, found: Inspection, digits: int, tick: Callable[[], None] = lambda: None) -> dict[str, Any]:
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
