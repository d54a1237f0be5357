"""The proof that the common points of two plane curves are complete, as JSON data for `exactspline.certificates`."""

from __future__ import annotations

from typing import Any

from flint import fmpz_poly

from exactspline.certificates import INTERSECTIONS
from exactspline.certificates import certificate as written
from exactspline.certificates.intersections import END, INSIDE, OUTSIDE, START
from exactspline.errors import ReachError, ShapeError
from exactspline.numbers.exact import mpq, text
from exactspline.polynomials.bernstein import ONE, restrict
from exactspline.polynomials.bezout import PlaneForms
from exactspline.polynomials.plane_pairs import SEVERAL, Elimination, elimination
from exactspline.polynomials.zero_places import Place, places
from exactspline.roots.segment_forms import SegmentForms, segment_forms
from exactspline.roots.zero_set import isolation_data
from exactspline.splines.nurbs import Nurbs

#: The largest number of pairs of segments of one certificate.
PAIRS = 10_000
REMEDY = "ask for the points; they are exact also without a certificate"


def intersection_certificate(first: Nurbs, second: Nurbs) -> dict[str, object]:
    """The certificate of all common points of two plane curves.

    >>> from exactspline import Nurbs, check_certificate
    >>> parabola = Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), ("1/2", 0), (1, 1)])
    >>> line = Nurbs(1, [0, 0, 1, 1], [(0, "1/2"), (1, "1/3")])
    >>> check_certificate(intersection_certificate(parabola, line))
    {'points': 1}

    Raises `ShapeError` for curves that are not in the plane or have weights of different signs, and `ReachError` where
    the curves have arcs in common, one passes several times through a common point, or there are too many segments.
    """
    if first.dimension != 2 or second.dimension != 2:
        raise ShapeError("a certificate of points in space", remedy="give curves in the plane")
    if first.segments * second.segments > PAIRS:
        raise ReachError(f"a certificate of {first.segments * second.segments} pairs of segments", remedy=REMEDY)
    segments = [[_positive(segment_forms(curve, i)) for i in range(curve.segments)] for curve in (first, second)]
    pairs = [
        {"segments": [i, j]} | _pair(one, other)
        for i, one in enumerate(segments[0])
        for j, other in enumerate(segments[1])
    ]
    data: dict[str, object] = {
        name: [_forms(curve) for curve in each] for name, each in zip(("first", "second"), segments, strict=True)
    }
    return written(INTERSECTIONS, data | {"pairs": pairs})


def _positive(segment: SegmentForms) -> PlaneForms:
    n, (x, y, w) = segment
    weights = [w[i] for i in range(n + 1)]
    if n == 0 or min(weights) <= 0 <= max(weights):
        raise ShapeError("weights of different signs, or a segment that is a point", remedy=REMEDY)
    return PlaneForms(n, x, y, w) if weights[0] > 0 else PlaneForms(n, -x, -y, -w)


def _forms(curve: PlaneForms) -> dict[str, list[str]]:
    return {
        name: [str(form[i]) for i in range(curve.degree + 1)]
        for name, form in zip(("x", "y", "w"), curve.forms, strict=True)
    }


def _pair(first: PlaneForms, second: PlaneForms) -> dict[str, Any]:
    for axis in (0, 1):
        (a, b), (c, d) = (_extent(curve, axis) for curve in (first, second))
        if b < c or d < a:
            return {"apart": {"axis": axis, "at": text((b + c) / 2 if b < c else (d + a) / 2)}}
    exchanged = first.degree > second.degree or (second.degree == first.degree > 1 and first.is_straight)
    one, other = (second, first) if exchanged else (first, second)
    found = elimination(one, other)
    if not found.determinant:
        raise ReachError("a certificate of curves with arcs in common", remedy=REMEDY)
    isolation = found.isolation
    zeros = [_zero(found, place) for place in places(isolation)]
    return {"exchanged": exchanged, "elimination": isolation_data(isolation), "zeros": zeros}


def _extent(curve: PlaneForms, axis: int) -> tuple[mpq, mpq]:
    form = curve.forms[axis]
    values = [mpq(int(form[i]), int(curve.w[i])) for i in range(curve.degree + 1)]
    return min(values), max(values)


def _zero(found: Elimination, place: Place) -> dict[str, str]:
    """An interval around a zero of the determinant on which the entries of the adjugate have the signs that are
    claimed.
    """
    partner = found.partner(Place(place.zero))
    if partner is SEVERAL:
        raise ReachError("a certificate of a point through which a curve passes several times", remedy=REMEDY)
    carried = found.map
    degree, strict = carried.degree, [carried.bottom, carried.top]
    where = OUTSIDE if partner is None else INSIDE
    if isinstance(partner, Place):
        where = START if partner.exact == 0 else END
        strict = [carried.bottom if where is START else found.last_entry]
    bits = 4
    while True:
        low, high = place.refine(bits)
        if low == high or (_is_isolated(place, low, high) and all(_is_strict(f, degree, low, high) for f in strict)):
            return {"low": text(low), "high": text(high), "s": where}
        bits *= 2


def _is_isolated(place: Place, low: mpq, high: mpq) -> bool:
    """Whether the factor has different signs, neither of them zero, at two numbers."""
    factor = place.zero.factor.polynomial
    part, _ = restrict((factor, ONE), factor.degree(), low, high)
    return bool(part[0] * part[factor.degree()] < 0)


def _is_strict(form: fmpz_poly, n: int, low: mpq, high: mpq) -> bool:
    """Whether all Bernstein coefficients of a form on an interval have one sign."""
    part, _ = restrict((form, ONE), n, low, high)
    values = [part[i] for i in range(n + 1)]
    return bool(min(values) > 0 or max(values) < 0)
