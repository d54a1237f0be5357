"""The user's interface to the derived objects of a curve, in any variant; the places where they do not exist are
reported.

Parameters and coordinates are unitless exact numbers.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, TypeVar, overload

from exactspline.errors import DomainError, FormulaError, ShapeError, counted, shown
from exactspline.formulas.lifted import binormal_lifted, inflections_lifted, tangent_lifted, torsion_zeros_lifted
from exactspline.geometry.derived.constructions import Absence, Construction, Variant, all_constructions, construction
from exactspline.hooks import Written
from exactspline.language.arguments import Curve
from exactspline.language.formula import Formula, expect_formula
from exactspline.language.kinds import CURVE, PLANE, SPACE, kind_of
from exactspline.language.rational import Rational
from exactspline.language.ruled import RuledSurface, joined, numerator, split
from exactspline.language.vector import Vector
from exactspline.numbers.exact import Number, mpq, rational
from exactspline.numbers.intervals import Interval
from exactspline.numbers.intervals import joined as joined_intervals
from exactspline.numbers.once import cached_property
from exactspline.one_line import one_line, short_text
from exactspline.papers import formula_of
from exactspline.polynomials.cost import bounded
from exactspline.roots.root import Root
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.lowest_terms import control_point_count, in_lowest_terms, true_degree
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of, of_dimension

# ---- parts of the domain


C = TypeVar("C", bound=Curve[BSpline])


def part(curve: Nurbs, a: mpq, b: mpq) -> Curve[BSpline]:
    """The curve over [a, b], as operands for formulas."""
    whole = curve.domain == (a, b)
    restricted = Curve(
        curve.p if whole else Vector(*[x.restrict(a, b) for x in curve.p]),
        curve.w if whole else curve.w.restrict(a, b),
        polynomial=curve.polynomial,
    )
    restricted.domain = (a, b)  # type: ignore[attr-defined]  # a plain curve is given its domain, a Nurbs has one
    return restricted


def intervals_where(breaks: Sequence[mpq], holds: Sequence[bool]) -> list[Interval]:
    """The maximal intervals made of segments on which something holds."""
    return joined_intervals(interval for interval, here in zip(pairwise(breaks), holds, strict=True) if here)


def plane(curve: C) -> C:
    """The curve itself if it is in the plane; raises `ShapeError` otherwise."""
    return of_dimension(curve, "this needs a curve in the plane", 2)


def space(curve: C) -> C:
    """The curve itself if it is in space; raises `ShapeError` otherwise."""
    return of_dimension(curve, "this needs a curve in space", 3)


@dataclass(frozen=True)
class Piece:
    """A derived object over an interval of the curve's parameter: a spline, a vector of them, or a `Rational`."""

    interval: Interval
    value: Any

    @one_line
    def __repr__(self) -> str:
        return f"<Piece on {self.interval}>"


@dataclass(frozen=True)
class Derived(Written):
    """A derived object in pieces, the intervals on which it does not exist, each with the reason, and its poles."""

    name: str
    variant: Variant
    pieces: tuple[Piece, ...]
    missing: tuple[tuple[Interval, Absence], ...]
    #: Whether the object is a ruled surface; the values are then those of the directrix and the generator.
    ruled: bool = False

    @one_line
    def __repr__(self) -> str:
        return f"<Derived {self.name}, {self.variant}: {counted(len(self.pieces), 'piece')}>"

    @property
    def degree(self) -> int:
        """The highest represented degree of the pieces."""
        degrees: list[int] = [piece.value.degree for piece in self.pieces]
        return max(degrees)

    @property
    def true_degree(self) -> int:
        """The highest degree of the pieces in lowest terms."""
        return max(true_degree(piece.value) for piece in self.pieces)

    @property
    def control_points(self) -> int:
        """The number of control points of all pieces together."""
        return sum(control_point_count(piece.value) for piece in self.pieces)

    @cached_property
    def poles(self) -> tuple[Root, ...]:
        """The parameters at which the object has no value: the zeros of its denominator in lowest terms, in order.

        >>> from exactspline.interchange.examples import example
        >>> [pole.exact for pole in derive("evolute", example("cubic_s")).poles]
        [mpq(1,2)]
        """
        denominators = (split(in_lowest_terms(piece.value))[1] for piece in self.pieces)
        return tuple(pole for w in denominators if w is not None for pole in zeros(w))

    @property
    def existence(self) -> str:
        """A text that says where the object exists, and where it does not exist and why.

        >>> from exactspline.interchange.examples import example
        >>> print(derive("evolute", example("straight_between_arcs")).existence)
        on [0, 1] and [2, 3]; not on [1, 2]: the curvature vanishes identically (straight segments)
        >>> print(derive("evolute", example("cubic_s")).existence)
        on [0, 1] except a pole at 1/2
        """
        there = " and ".join(str(piece.interval) for piece in self.pieces)
        if self.poles:
            places = ", ".join(pole.shortly() for pole in self.poles)
            there += f" except {'a pole' if len(self.poles) == 1 else 'poles'} at {places}"
        gaps = [f"not on {interval}: {reason.words}" for interval, reason in self.missing]
        return "; ".join([f"on {there}", *gaps])

    @overload
    def __call__(self) -> Derived: ...
    @overload
    def __call__(self, t: Number) -> mpq | tuple[mpq, ...]: ...
    def __call__(self, t: Number | None = None) -> Derived | mpq | tuple[mpq, ...]:
        """The value at a parameter, from the first piece that contains the parameter; raises `ShapeError` where no
        piece does, and `DomainError` at a pole. Without a parameter the object itself: ``curve.evolute()`` is
        ``curve.evolute``.
        """
        if t is None:
            return self
        t = rational(t)
        for piece in self.pieces:
            if piece.interval[0] <= t <= piece.interval[1]:
                return self._value(piece, t)
        raise ShapeError(
            f"{self.name} does not exist at the parameter {short_text(t)}",
            remedy="; ".join(reason.words for (a, b), reason in self.missing if a <= t <= b) or "stay in the domain",
        )

    def _value(self, piece: Piece, t: mpq) -> mpq | tuple[mpq, ...]:
        value, w = piece.value, split(piece.value)[1]
        if w is not None and w(t) == 0:
            # numerator and denominator as written may both vanish at a parameter where the quotient has a value
            value = in_lowest_terms(value)
            if value.denominator(t) == 0:
                problem = f"{self.name} has a pole at the parameter {short_text(t)}"
                raise DomainError(problem, where=short_text(t), remedy="choose another parameter")
        return tuple(c(t) for c in value) if isinstance(value, Vector) else value(t)


def derive(what: str | Formula, curve: Nurbs, variant: Variant | str = Variant.MINIMAL) -> Derived:
    """Return the value of a construction or of a formula on a curve.

    `what` is the name of a construction, a formula, or the name of a formula (``f2``, ``g0``, …). Constructions are,
    for example, the ``evolute`` of a plane curve, and the ``torsion`` and the ``focal_curve`` (centres of osculating
    spheres) of a space curve. The result is in lowest terms unless another variant is requested; the variant ``naive``
    of a formula is the formula as written. If the object does not exist on an interval (as the evolute on a straight
    piece), the interval is listed as missing.

    >>> from exactspline.interchange.examples import example
    >>> derive("evolute", example("circle"))("1/2")
    (mpq(0,1), mpq(0,1))

    Raises `FormulaError` for an unknown name or variant, and `ShapeError` for a curve of the wrong dimension, or if the
    object exists nowhere.
    """
    curve = curve_of(curve)
    name = what if isinstance(what, str) else expect_formula(what).name
    made = construction(name) if isinstance(what, str) and name in all_constructions() else None
    if made is not None:
        needed, compute = kind_of(made.curve), lambda c: made.on(c, variant)
        formula = made.formula(variant)
    else:
        formula = formula_of(what)
        if not isinstance(variant, str) or variant not in (Variant.MINIMAL, Variant.NAIVE):
            raise FormulaError(
                f"{name} has no variant {shown(variant)}",
                remedy=f"a formula has the variants {Variant.MINIMAL} and {Variant.NAIVE} (as written)",
            )
        needed = formula.kind
        compute = (
            (lambda c: joined(in_lowest_terms(formula(c))))
            if variant == Variant.MINIMAL
            else (lambda c: joined(formula(c)))
        )
    if needed not in (CURVE, PLANE, SPACE) or curve.dimension not in needed.dimensions:
        of = f"{needed.name} curve" if needed.made_of_a_curve else needed.name
        raise ShapeError(f"{name} of a curve in R{curve.dimension}", remedy=f"it is defined for a {of}")
    with bounded():
        value = formula(curve)
    ruled = isinstance(value, RuledSurface)
    exists, breaks = _exists(value), curve.breakpoints
    reasons = [None if here else _why_missing(made, curve, i) for i, here in enumerate(exists)]
    missing = tuple(
        sorted(
            (interval, reason)
            for reason in {each for each in reasons if each is not None}
            for interval in intervals_where(breaks, [each is reason for each in reasons])
        )
    )
    parts = intervals_where(breaks, exists)
    pieces = tuple(Piece(interval, _nonnegative(compute(part(curve, *interval)))) for interval in parts)
    if not pieces:
        everywhere = ", ".join(f"on {interval} {reason.words}" for interval, reason in missing)
        raise ShapeError(f"{curve.name or 'the curve'} has no {name}: {everywhere}", remedy="choose another curve")
    return Derived(name, Variant(variant), pieces, missing, ruled)


def _nonnegative(value: Any) -> Any:
    """The value, in which each zero spline of negative formal degree is replaced by the constant 0."""
    if isinstance(value, Rational):
        return Rational(_nonnegative(value.numerator), value.product)
    if isinstance(value, Vector):
        return Vector(*map(_nonnegative, value))
    return value.constant(0) if value.degree < 0 else value


def _exists(value: Any) -> list[bool]:
    """For each segment whether a denominator, and the generator of a ruled surface, are not identically zero."""
    if isinstance(value, RuledSurface):
        ends = [_exists(part) for part in (value.directrix, value.generator)]
        generator = zip(*[c.numerators for c in numerator(value.generator)], strict=True)
        return [all(here) and any(parts) for *here, parts in zip(*ends, generator, strict=True)]
    if isinstance(value, Rational):
        return [bool(c) for c in value.denominator.numerators]
    return [True] * len((value[0] if isinstance(value, Vector) else value).mesh)


def _why_missing(made: Construction | None, curve: Nurbs, i: int) -> Absence:
    """The reason why a construction does not exist on a segment: a quantity of the curve itself that vanishes
    identically there.
    """
    if made is not None and curve.dimension in (2, 3):
        here = part(curve, *curve.breakpoints[i : i + 2])
        bend, in_space = (inflections_lifted, False) if curve.dimension == 2 else (binormal_lifted, True)
        if _vanishes(tangent_lifted(here)):
            return Absence.STILL
        if _vanishes(bend(here)):
            return Absence.STRAIGHT
        if in_space and _vanishes(torsion_zeros_lifted(here)):
            return Absence.PLANAR
    return Absence.DENOMINATOR


def _vanishes(value: Vector[BSpline] | BSpline) -> bool:
    """Whether all components are identically zero."""
    return all(c.is_zero for c in (value if isinstance(value, Vector) else [value]))
