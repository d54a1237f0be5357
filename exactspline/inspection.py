"""Everything `inspect` tells of a plane curve: features with their curvature to any precision, and the approaches side by side."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from time import perf_counter
from typing import Any

from gmpy2 import mpq

from exactspline.constructions import MINIMAL
from exactspline.errors import ExactSplineError, FormulaError
from exactspline.features import constant_pieces, critical_points, curvature_sign, inflections, singularities, straight_pieces, zero_form
from exactspline.formulas import find
from exactspline.interrogate import plane
from exactspline.language import Curve, Vector
from exactspline.measure import control_point_count
from exactspline.readings.series import Series
from exactspline.zeros import Root, ZeroSet

#: The approaches to critical curvature by the names of the paper, and the forms they solve.
APPROACHES = {"squaring": "squaring", "direct": "direct", "reduced": "paper", "minimal": MINIMAL}


@dataclass(frozen=True)
class Inspection:
    """The features of a curve, each list in the order of the parameter; intervals where the curve is straight or of constant curvature."""

    approach: str
    singularities: list[Any]
    inflections: list[Any]
    critical: list[Any]
    straight: list[tuple[mpq, mpq]]
    constant: list[tuple[mpq, mpq]]


def inspect_curve(curve: Any, approach: str = "minimal") -> Inspection:
    """The features of a plane curve by one of the `APPROACHES`.

    >>> from exactspline.curves import example
    >>> len(inspect_curve(example("ellipse")).critical)
    4

    Raises `ShapeError` for a curve that is not in the plane, `FormulaError` for an unknown approach.
    """
    if approach not in APPROACHES:
        raise FormulaError(f"no approach is called {approach!r}", remedy=f"there are {', '.join(APPROACHES)}, all")
    plane(curve)
    critical = critical_points(curve, APPROACHES[approach])
    return Inspection(approach, singularities(curve), inflections(curve), critical, straight_pieces(curve), constant_pieces(curve))


@dataclass(frozen=True)
class Approach:
    """What one approach to critical curvature costs and finds.

    ``invented`` are roots at which κ′ does not vanish (the inflections that squaring adds, and singular points).
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
    [('squaring', 24, 8, 2), ('direct', 6, 6, 0), ('reduced', 6, 6, 0), ('minimal', 5, 6, 0)]
    """
    found: dict[str, tuple[Any, ZeroSet, float]] = {}
    for name, form in APPROACHES.items():
        start = perf_counter()
        f, zero_set = zero_form(curve, "critical_curvature", form)
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

    sign = curvature_sign(curve, root)
    if sign == 0:
        return mp.mpf(0)
    precision = digits + 10
    while True:
        low, high = root.refine(precision)
        saved = iv.dps
        try:
            iv.dps = precision + 10
            c = _enclosed(curve, low, high, side, iv)
            squared = find("curvature_squared")(c).value
            if squared.a > 0:
                kappa = iv.sqrt(squared) * sign
                if kappa.delta <= mp.mpf(10) ** -digits * max(1, abs(kappa.mid)):
                    with mp.workdps(digits + 5):
                        return mp.mpf(kappa.mid)
        finally:
            iv.dps = saved
        precision *= 2


def _enclosed(curve: Any, low: mpq, high: mpq, side: str, iv: Any) -> Curve:
    """The curve as a Taylor series with interval coefficients over [low, high]."""

    def interval(a: mpq, b: mpq) -> Any:
        ends = [iv.mpf(int(x.numerator)) / iv.mpf(int(x.denominator)) for x in (a, b)]
        return iv.mpf([ends[0].a, ends[1].b])

    def series(spline: Any) -> Series:
        coefficients, factorial = [], 1
        for order in range(3):
            derivative = spline.d(order)
            i = derivative.mesh.locate(low, left=side == "left")
            a, b = derivative.mesh.breaks[i : i + 2]
            t = interval((low - a) / (b - a), (high - a) / (b - a))
            points = [interval(x, x) for x in derivative.segments[i]] or [iv.mpf(0)]
            while len(points) > 1:
                points = [(1 - t) * p + t * q for p, q in pairwise(points)]
            factorial *= max(order, 1)
            coefficients.append(points[0] / factorial)
        return Series(coefficients)

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
    if f.of_absolute:
        data |= {"of_absolute": f.of_absolute, "curvature": value_of(curve, f, digits)}
    return data


def decimal_of(root: Root, digits: int) -> str:
    """A root to so many digits behind the point."""
    from mpmath import mp, nstr

    with mp.workdps(digits + 10):
        value = root.mpf(digits + 2)
        return str(nstr(value, digits + max(int(mp.floor(mp.log10(abs(value)))) + 1, 1) if value else 1, strip_zeros=True))


def value_of(curve: Any, f: Any, digits: int) -> str:
    """κ at an extremum to so many digits; the reason where it cannot be told."""
    from mpmath import mp, nstr

    try:
        with mp.workdps(digits + 10):
            return str(nstr(curvature_value(curve, f.root, digits), digits, strip_zeros=True))
    except ExactSplineError as error:
        return str(error)


def inspection_data(curve: Any, found: Inspection, digits: int, tick: Callable[[], None] = lambda: None) -> dict[str, Any]:
    """All of it as data for programs; `tick` is called after every feature."""
    groups = {"singularities": found.singularities, "inflections": found.inflections, "critical": found.critical}
    data: dict[str, Any] = {"curve": curve.name, "approach": found.approach, "closed": curve.closed, "digits": digits}
    for name, features in groups.items():
        data[name] = []
        for f in features:
            data[name].append(feature_data(curve, f, digits))
            tick()
    intervals = {"straight": found.straight, "constant_curvature": found.constant}
    return data | {name: [[str(a), str(b)] for a, b in pieces] for name, pieces in intervals.items()}
