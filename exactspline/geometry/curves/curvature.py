"""The curvature of a plane curve as a function of the parameter, in closed form where it has one."""

from __future__ import annotations

from dataclasses import dataclass

from flint import fmpz_poly

from exactspline.geometry.derived.domain import plane, segments
from exactspline.language.arguments import Curve
from exactspline.language.rational import Rational
from exactspline.numbers.exact import mpq, ratio
from exactspline.numbers.intervals import Interval
from exactspline.papers import find
from exactspline.polynomials.bernstein import ONE, is_square_class, without_content
from exactspline.polynomials.factors import factorize_square_free
from exactspline.polynomials.isolation import zero_on_segment
from exactspline.reals.real import square_root_parts
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.lowest_terms import in_lowest_terms
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of


@dataclass(frozen=True)
class CurvaturePiece:
    """Curvature on one segment: ``√radicand · value``; `value` is None where the curvature is not of that form."""

    interval: Interval
    radicand: int
    value: Rational[BSpline] | BSpline | None
    reason: str = ""

    def __repr__(self) -> str:
        return f"<CurvaturePiece on [{self.interval[0]}, {self.interval[1]}]>"


def curvature_function(curve: Nurbs) -> list[CurvaturePiece]:
    """Signed curvature (positive where the curve turns left), segment by segment, where it is rational up to a constant
    square root.

    This holds exactly where ‖γ′‖² is a positive constant times a square: the curve is a Pythagorean hodograph there
    (claim C4.1d; Farouki and Sakkalis 1990).

    >>> from exactspline.interchange.examples import example
    >>> [(piece.radicand, piece.value(piece.interval[0])) for piece in curvature_function(example("circle"))][:2]
    [(1, mpq(1,1)), (1, mpq(1,1))]

    Raises `ShapeError` for a curve that is not in the plane.
    """
    return [_curvature_on(c, interval) for interval, c in segments(plane(curve_of(curve)))]


def _curvature_on(c: Curve[BSpline], interval: Interval) -> CurvaturePiece:
    turning = find("f2")(c)
    if turning.is_zero:
        return CurvaturePiece(interval, 1, turning.constant(0))
    squared = in_lowest_terms(find("curvature_squared")(c))
    roots = [polynomial_root(part) for part in (squared.numerator, squared.denominator)]
    if None in roots:
        return CurvaturePiece(
            interval, 0, None, "‖γ′‖² is not a constant times a square: the curve is not a Pythagorean hodograph here"
        )
    (n, up), (m, down) = roots  # type: ignore[misc]  # None is excluded
    if any(zero_on_segment(c, m.degree) is not None for c in m.numerators):
        return CurvaturePiece(interval, 0, None, "γ′ has a zero here: the curvature has a pole, and its sign may jump")
    t = next(t for j in range(1, n.degree + turning.degree + 3) if n(t := interval.at(mpq(1, j + 1))) and turning(t))
    coefficient, radicand = square_root_parts(up / down)
    # [γ′ γ″] is f2/w³: its sign is that of f2 only where w > 0
    agreement = n * m * turning * c.w
    if any(root.sign_change for root in zeros(agreement)):
        return CurvaturePiece(interval, 0, None, "the curve turns back here, where γ′ = 0: the sign of κ jumps")
    sign = 1 if agreement(t) > 0 else -1
    return CurvaturePiece(interval, radicand, n.scaled(sign * coefficient) / m)


def polynomial_root(f: BSpline) -> tuple[BSpline, mpq] | None:
    """A spline r and a constant c with ``f = c r²``, for a spline f of one segment; None where they do not exist.

    >>> polynomial_root(BSpline.bezier([2, -4, 8]))
    (BSpline(1, [0, 0, 1, 1], [-1, 2]), mpq(2,1))
    """
    c, m = without_content(f.forms[0])
    if f.degree % 2 or not is_square_class(c, f.degree):
        return None
    unit, factors = factorize_square_free(c)
    root = fmpz_poly([1])
    for p, e in factors:
        root = root * p ** (e // 2)
    return BSpline.from_forms(f.degree // 2, f.mesh, (), [(root, ONE)]), ratio(unit, m)
