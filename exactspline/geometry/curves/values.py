"""Points, directions, curvature and torsion of a curve at a parameter, rational or not, as real numbers."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise, starmap
from typing import Any

from flint import fmpz, fmpz_poly

from exactspline.errors import DomainError, ShapeError
from exactspline.geometry.curves.facts import facts_of
from exactspline.geometry.curves.planarity import in_the_plane
from exactspline.geometry.curves.plane_programs import BENDING, CURVATURE, SPEED, TORSION, plane_program, space_program
from exactspline.geometry.derived.derive import part, plane, space
from exactspline.language.arguments import Curve
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector, cross, det, norm2
from exactspline.numbers.exact import Number, mpq, ratio, text
from exactspline.numbers.exact import sign as sign_of
from exactspline.numbers.intervals import Interval, Side
from exactspline.papers import find
from exactspline.polynomials.bernstein import ONE, is_square_class, without_content
from exactspline.polynomials.factors import factorize_square_free
from exactspline.polynomials.isolation import zero_on_segment
from exactspline.reals.real import Real, square_root_parts
from exactspline.roots.values import exact_place, segment_of, sign_at, signed_root, value_at, within
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.inputs import checked_side
from exactspline.splines.knots import Mesh
from exactspline.splines.lowest_terms import in_lowest_terms
from exactspline.splines.nurbs import Nurbs, derivative_splines
from exactspline.splines.type_checks import curve_of


def point_at(curve: Nurbs, place: mpq | Real, order: int = 0, side: Side | str = Side.RIGHT) -> tuple[Real, ...]:
    """The point or a derivative of a curve at a rational parameter or an irrational root.

    >>> from exactspline import example, zeros
    >>> circle = example("circle")
    >>> [x.double() for x in point_at(circle, zeros(circle.p[0] - circle.p[1]).roots[0], 1)]
    [-1.2071067811865475, 1.2071067811865475]
    """
    place = exact_place(place)
    if not isinstance(place, Real):
        return tuple(map(Real, curve.derivative(order, place, side) if order else curve(place, side)))
    within(curve.domain, place)
    numerators, denominator = derivative_splines(curve, order)
    return tuple(value_at(f, denominator, place) for f in numerators)


def unit(vector: Vector[BSpline], place: mpq | Real, name: str = "T", side: Side = Side.RIGHT) -> list[Real]:
    """The components of a vector divided by its length at a parameter, from this `side`.

    >>> from exactspline import BSpline
    >>> t = BSpline.identity(0, 2)
    >>> unit(Vector(t, t * t), mpq(1))
    [<Real √2/2>, <Real √2/2>]

    Raises `DomainError` if the vector vanishes there.
    """
    signs = [sign_at(x, place, side) for x in vector]
    if not any(signs):
        raise DomainError(f"{name} is undefined: the vector vanishes there", remedy="choose another parameter")
    squared = norm2(vector)
    return [signed_root(s, value_at(x * x, squared, place, side)) for x, s in zip(vector, signs, strict=True)]


def curvature(curve: Nurbs, t: Number | Real, side: Side | str = Side.RIGHT) -> Real:
    """Return the curvature of a curve at a parameter; at a knot, the limit from `side`. In the plane, and in the plane
    z = 0 of space, the curvature is positive where the curve turns left and negative where it turns right; elsewhere it
    is not negative.

    >>> from exactspline import Nurbs, zeros
    >>> parabola = Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), ("1/2", 0), (1, 1)])
    >>> curvature(parabola, 0), curvature(parabola, "1/2")
    (<Real 2>, <Real √2/2>)
    >>> curvature(parabola, zeros(parabola.p[1].scaled(2) - 1).roots[0]).minimal_polynomial()
    [-4, 0, 27]

    Raises `DomainError` where γ′ = 0 and outside the domain, `ShapeError` unless in the plane or in space.
    """
    curve, place = in_plane_or_space(curve), exact_place(t)
    if not isinstance(place, Real):
        sign, top, bottom = signed_square(curve, place, left=checked_side(side))
        if not bottom:
            raise DomainError(f"γ′ = 0 {_named(place)}", remedy="choose another parameter")
        return signed_root(sign, Real(mpq(top, bottom)))
    i = segment_at(curve, place, side)
    refuse_singular(curve, i, place, side)
    turning, above, below = facts_of(curve).once(("curvature on a segment", i), lambda: _curvature_forms(curve, i))
    return signed_root(1 if curve.dimension == 3 else sign_at(turning, place), value_at(above, below, place))


def in_plane_or_space(curve: Nurbs) -> Nurbs:
    """A curve in the plane or in space; one in the plane z = 0 as a plane curve."""
    curve = curve_of(curve)
    if curve.dimension not in (2, 3):
        raise ShapeError(f"a curve in R{curve.dimension}", remedy="curvature needs a curve in the plane or in space")
    return in_the_plane(curve)


def signed_square(curve: Nurbs, t: mpq, *, left: bool) -> tuple[int, int, int]:
    """The sign of κ (in space not negative) and κ² as a quotient of integers at a rational parameter; where γ′ = 0 its
    denominator is 0.

    For γ = p/w and the vectors ``N = w p′ − w′ p`` and ``M = w p″ − w″ p`` it is γ′ = N/w² and γ″ = M/w² − 2(w′/w) γ′,
    so that γ′ × γ″ = (N × M)/w⁴.

    >>> from exactspline import Nurbs
    >>> signed_square(Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), ("1/2", 0), (1, 1)]), mpq(1, 2), left=False)
    (1, 67108864, 134217728)
    """
    *p, (w, slope, bend) = curve.evaluation.numbers(t, 2, left=left)
    first, second = (Vector(*[w * row[k] - of_w * row[0] for row in p]) for k, of_w in ((1, slope), (2, bend)))
    if curve.dimension == 3:
        sign, turned = 1, norm2(cross(first, second))
    else:
        turning = det(first, second)
        sign, turned = sign_of(turning), turning * turning
    return sign, turned * w**4, norm2(first) ** 3


def _forms_on(curve: Nurbs, i: int) -> list[BSpline]:
    """What the program for its dimension computes on a segment, as functions of its parameter, and the weight function
    there.
    """
    return facts_of(curve).once(("forms on a segment", i), lambda: _computed_forms(curve, i))


def _computed_forms(curve: Nurbs, i: int) -> list[BSpline]:
    program = (plane_program if curve.dimension == 2 else space_program)(curve.degree, not curve.polynomial)
    mesh, (rows, below) = Mesh(curve.breakpoints[i : i + 2]), curve.rows[i]
    operands = [fmpz_poly(list(row)) for row in rows]
    made = program.run([[c] for c in operands], [[fmpz(below)]], [(ONE, ONE)])[0]
    degrees = [*(term.degrees[0] for term in program.terms), 0 if curve.polynomial else curve.degree]
    w = (fmpz_poly([1]), ONE) if curve.polynomial else (operands[-1], fmpz(below))
    forms: list[Any] = [*zip(made, made[len(program.terms) :], strict=False), w]
    return [BSpline.from_forms(degree, mesh, (), [form]) for degree, form in zip(degrees, forms, strict=True)]


def _curvature_forms(curve: Nurbs, i: int) -> tuple[BSpline, BSpline, BSpline]:
    """In the plane a spline with the sign of κ on a segment; numerator and denominator of κ² there."""
    *forms, w = _forms_on(curve, i)
    bent = forms[BENDING] if curve.dimension == 3 else forms[CURVATURE] ** 2
    return forms[CURVATURE] * w, bent * w**6, forms[SPEED] ** 3


def torsion(curve: Nurbs, t: Number | Real, side: Side | str = Side.RIGHT) -> Real:
    """Return the torsion of a space curve at a parameter: where the curvature is 0, the limit of the torsion; at a
    knot, the limit from `side`. The torsion of a right-handed helix is positive.

    >>> from exactspline import example
    >>> torsion(example("twisted_cubic"), 0)
    <Real 3>

    Raises `DomainError` where γ′ = 0 or the torsion has a pole, `ShapeError` unless the curve is in space and not
    straight at the parameter.
    """
    curve, place = curve_of(curve), exact_place(t)
    i = segment_at(space(curve), place, side)
    refuse_singular(curve, i, place, side)
    tau = facts_of(curve).once(("torsion on a segment", i), lambda: _torsion_form(curve, i))
    if sign_at(tau.denominator, place, side) == 0:
        raise DomainError(f"the torsion has a pole {_named(place)}", remedy="choose another parameter")
    return value_at(tau.scalar, tau.denominator, place, side)


def _torsion_form(curve: Nurbs, i: int) -> Rational[BSpline]:
    """τ on a segment in lowest terms."""
    *forms, w = _forms_on(curve, i)
    if forms[BENDING].is_zero:
        raise ShapeError("the torsion of a straight piece", remedy="choose a parameter where the curve is not straight")
    return in_lowest_terms(Rational(forms[TORSION] * w**2, forms[BENDING]))


def segment_at(curve: Nurbs, place: mpq | Real, side: Side | str) -> int:
    """The index of the segment that contains a parameter or a root."""
    left = checked_side(side)
    if not isinstance(place, Real):
        return curve.mesh.locate(place, left=left)
    within(curve.domain, place)
    return segment_of(curve.w, place)


def refuse_singular(curve: Nurbs, i: int, place: mpq | Real, side: Side | str) -> None:
    """Raise `DomainError` where γ′ = 0 at a parameter on a segment."""
    if is_singular(curve, i, place, side):
        raise DomainError(f"γ′ = 0 {_named(place)}", remedy="choose another parameter")


def is_singular(curve: Nurbs, i: int, place: mpq | Real, side: Side | str) -> bool:
    """Whether γ′ = 0 at a parameter on a segment."""
    return sign_at(_forms_on(curve, i)[SPEED], place, side) == 0


def _named(place: mpq | Real) -> str:
    return "at the root" if isinstance(place, Real) else f"at the parameter {text(place)}"


# ---- curvature as a function


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
    """Return the signed curvature (positive where the curve turns left) of each segment on which the curvature is
    rational up to a constant square root.

    This is so exactly where ‖γ′‖² is a positive constant times a square: where the curve is a Pythagorean-hodograph
    curve (Farouki and Sakkalis 1990).

    >>> from exactspline.interchange.examples import example
    >>> [(piece.radicand, piece.value(piece.interval[0])) for piece in curvature_function(example("circle"))][:2]
    [(1, mpq(1,1)), (1, mpq(1,1))]

    Raises `ShapeError` for a curve that is not in the plane.
    """
    given = curve_of(curve)
    plane(given)
    return [_curvature_on(part(given, *ends), ends) for ends in starmap(Interval, pairwise(given.breakpoints))]


def _curvature_on(c: Curve[BSpline], interval: Interval) -> CurvaturePiece:
    turning = find("f2")(c)
    if turning.is_zero:
        return CurvaturePiece(interval, 1, turning.constant(0))
    squared = in_lowest_terms(find("curvature_squared")(c))
    roots = [_polynomial_root(part) for part in (squared.numerator, squared.denominator)]
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


def _polynomial_root(f: BSpline) -> tuple[BSpline, mpq] | None:
    """A spline r and a constant c with ``f = c r²``, for a spline f of one segment; None where they do not exist.

    >>> _polynomial_root(BSpline.bezier([2, -4, 8]))
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
