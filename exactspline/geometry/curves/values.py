"""Points, directions, curvature and torsion of a curve at a parameter, rational or not, as real numbers."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, partial
from itertools import pairwise, starmap
from typing import Any, cast

from flint import arb, ctx, fmpz, fmpz_poly

from exactspline.errors import DomainError, ShapeError
from exactspline.geometry.curves.facts import facts_of
from exactspline.geometry.curves.planarity import in_the_plane
from exactspline.geometry.curves.plane_programs import BENDING, CURVATURE, SPEED, TORSION, plane_program, space_program
from exactspline.geometry.derived.derive import part, plane, space
from exactspline.language.arguments import Curve
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector, norm2
from exactspline.numbers.exact import Number, mpq, ratio, scalar, text
from exactspline.numbers.exact import sign as sign_of
from exactspline.numbers.intervals import Interval, Side, ball_around
from exactspline.numbers.once import fill
from exactspline.papers import find
from exactspline.polynomials.bernstein import ONE, is_square_class, over_common_denominator, raiser, without_content
from exactspline.polynomials.elimination import primitive, without_quadratic_zero
from exactspline.polynomials.factors import factorize_square_free
from exactspline.polynomials.isolation import zero_on_segment
from exactspline.reals.algebraic import PRECISION
from exactspline.reals.ball import InBalls
from exactspline.reals.real import Real, square_root_parts
from exactspline.roots.root import Root
from exactspline.roots.values import exact_place, local_ball, segment_of, sign_at, signed_root, value_at, within
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.inputs import checked_side
from exactspline.splines.knots import Mesh
from exactspline.splines.lowest_terms import in_lowest_terms
from exactspline.splines.nurbs import Nurbs, derivative_splines
from exactspline.splines.type_checks import curve_of, of_dimension


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
    found = local_ball(curve.mesh, place)
    near = found and _curvature_near(curve, *found, cast(Root, place))
    return _exact_curvature(curve, place, side) if near is None else near


def _exact_curvature(curve: Nurbs, place: Real, side: Side | str = Side.RIGHT) -> Real:
    """The curvature at an irrational parameter by exact forms."""
    i = segment_at(curve, place, side)
    refuse_singular(curve, i, place, side)
    *forms, w = _forms_on(curve, i)
    bent = forms[BENDING] if curve.dimension == 3 else forms[CURVATURE] ** 2
    sign = 1 if curve.dimension == 3 else sign_at(forms[CURVATURE] * w, place)
    return signed_root(sign, value_at(bent * w**6, forms[SPEED] ** 3, place))


class CurvatureAt(InBalls):
    """The curvature at a root inside a segment, which is not 0, by a ball; `large` may prove that it is neither
    rational nor quadratic.
    """

    __slots__ = ("large",)
    large: Callable[[], bool]

    def __init__(self, near: arb, large: Callable[[], bool], exactly: Callable[[], Real]) -> None:
        super().__init__(partial(_ball, near, exactly), exactly)
        fill(self, large=large)

    def __reduce__(self) -> tuple[object, ...]:
        return cast("tuple[object, ...]", cast(Any, self.exactly)().__reduce__())

    def _at_hand(self) -> arb:
        return self.ball(0)

    def _found(self) -> Real | None:
        return None if self.large() else super()._found()


def _ball(near: arb, exactly: Callable[[], Real], bits: int) -> arb:
    """A ball around a number for this many bits."""
    return near if near.rad() < arb((1, 30 - bits)) else ball_around(*exactly().enclosure(3 * bits // 10))


def _curvature_near(curve: Nurbs, i: int, z: arb, place: Root) -> Real | None:
    """The curvature at a root inside a segment by the ball around its local parameter z; None if the ball does not show
    that γ′ ≠ 0 and which sign κ has.
    """
    polynomials = _local_polynomials(curve, i)
    turning, top, bottom = _squared([[p, p.derivative(), p.derivative().derivative()] for p in polynomials])
    with ctx.workprec(PRECISION):
        sign, below = 1 if curve.dimension == 3 else sign_of(turning(z)), bottom(z)
        squared = top(z) / below
        near = squared.sqrt() * sign
    if not below > 0 or (sign and not squared > 0):
        return None
    if sign:
        large = partial(without_quadratic_zero, place.local_polynomial, top, bottom, squared=True)
        return CurvatureAt(near, large, cache(partial(_exact_curvature, curve, place)))
    return None if turning % primitive(place.local_polynomial) else Real(0)


def in_plane_or_space(curve: Nurbs) -> Nurbs:
    """A curve in the plane or in space; one in the plane z = 0 as a plane curve."""
    return in_the_plane(of_dimension(curve_of(curve), "curvature needs a curve in the plane or in space", 2, 3))


def signed_square(curve: Nurbs, t: mpq, *, left: bool) -> tuple[int, int, int]:
    """The sign of κ (in space not negative) and κ² as a quotient of integers at a rational parameter; where γ′ = 0 its
    denominator is 0.

    For γ = p/w and the vectors ``N = w p′ − w′ p`` and ``M = w p″ − w″ p`` it is γ′ = N/w² and γ″ = M/w² − 2(w′/w) γ′,
    so that γ′ × γ″ = (N × M)/w⁴.

    >>> from exactspline import Nurbs
    >>> signed_square(Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), ("1/2", 0), (1, 1)]), mpq(1, 2), left=False)
    (1, 67108864, 134217728)
    """
    turning, top, bottom = _squared(curve.evaluation.numbers(t, 2, left=left))
    return sign_of(turning), top, bottom


def _local_polynomials(curve: Nurbs, i: int) -> list[fmpz_poly]:
    """The coordinates and the weight function of a segment, up to a common factor, as polynomials of
    ``z = t/(1 − t)`` for its local parameter t.
    """
    splines = curve.p if curve.polynomial else (*curve.p, curve.w)
    parts, common = over_common_denominator([(f.numerators[i], f.denominators[i]) for f in splines])
    return [*parts, raiser(curve.degree) * common] if curve.polynomial else parts


def _squared(rows: Sequence[Sequence[Any]]) -> tuple[Any, Any, Any]:
    """A number with the sign of κ (in space 1) and κ² as a quotient, by the coordinates and the weight, each with its
    first two derivatives.
    """
    *p, (w, slope, bend) = rows
    first, second = [w * x[1] - slope * x[0] for x in p], [w * x[2] - bend * x[0] for x in p]
    squared = scalar(first, first)
    turning = 1 if len(p) == 3 else first[0] * second[1] - first[1] * second[0]
    turned = squared * scalar(second, second) - scalar(first, second) ** 2 if len(p) == 3 else turning * turning
    return turning, turned * w**4, squared**3


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
    if sign_at(_forms_on(curve, i)[SPEED], place, side) == 0:
        raise DomainError(f"γ′ = 0 {_named(place)}", remedy="choose another parameter")


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
