"""The user's interface to the derived objects of a curve, in any variant; the places where they do not exist are named.

Parameters and coordinates are unitless exact numbers.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from exactspline.errors import FormulaError, ShapeError, counted, shown
from exactspline.geometry.analysis import analyse
from exactspline.geometry.constructions import Absence, Construction, Variant, all_constructions, construction
from exactspline.geometry.domain import intervals_where, part
from exactspline.hooks import Displayed
from exactspline.language.formula import Formula, expect_formula
from exactspline.language.kinds import CURVE, PLANE, SPACE, kind_of
from exactspline.language.parts import joined, numerator
from exactspline.language.rational import Rational
from exactspline.language.ruled import RuledSurface
from exactspline.language.vector import Vector
from exactspline.numbers.exact import Number, mpq, rational, short_text, text
from exactspline.numbers.intervals import Interval
from exactspline.papers import formula_of
from exactspline.splines.expected import curve_of
from exactspline.splines.lowest_terms import control_point_count, in_lowest_terms, true_degree
from exactspline.splines.nurbs import Nurbs


@dataclass(frozen=True)
class Piece:
    """A derived object over an interval of the curve's parameter: a spline, a vector of them, or a `Rational`."""

    interval: Interval
    value: Any

    def __repr__(self) -> str:
        return f"<Piece on {_shown(self.interval)}>"


@dataclass(frozen=True)
class Derived(Displayed):
    """A derived object in pieces, and the intervals on which it does not exist, each with the reason."""

    name: str
    variant: Variant
    pieces: tuple[Piece, ...]
    missing: tuple[tuple[Interval, Absence], ...]
    #: Whether it is a ruled surface; the values are then those of the directrix and the generator.
    ruled: bool = False

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

    @property
    def existence(self) -> str:
        """Where it exists, and where it does not and why, in words.

        >>> from exactspline.interchange.examples import example
        >>> print(derive("evolute", example("straight_between_arcs")).existence)
        on [0, 1] and [2, 3]; not on [1, 2]: the curvature vanishes identically (straight segments)
        """
        there = " and ".join(_shown(piece.interval) for piece in self.pieces)
        gaps = [f"not on {_shown(interval)}: {reason.words}" for interval, reason in self.missing]
        return "; ".join([f"on {there}", *gaps])

    def __call__(self, t: Number) -> mpq | tuple[mpq, ...]:
        """Value at a parameter, by the first piece that contains it; raises `ShapeError` where there is none."""
        t = rational(t)
        for piece in self.pieces:
            if piece.interval[0] <= t <= piece.interval[1]:
                return piece.value(t) if not isinstance(piece.value, Vector) else tuple(c(t) for c in piece.value)
        raise ShapeError(
            f"{self.name} does not exist at the parameter {short_text(t)}",
            remedy="; ".join(reason.words for (a, b), reason in self.missing if a <= t <= b) or "stay in the domain",
        )


def _shown(interval: Interval) -> str:
    return f"[{text(interval[0])}, {text(interval[1])}]"


def derive(what: str | Formula, curve: Nurbs, variant: Variant | str = Variant.MINIMAL) -> Derived:
    """A construction or a formula on a curve.

    `what` is the name of a construction (``evolute`` of a plane curve; of a space curve ``focal_curve``, the centres of
    its osculating spheres, ``circle_centres``, those of its osculating circles, ``torsion``, …), a formula, or the name
    of a formula (``f2``, ``g0``, …). The result is in lowest terms, if no other variant is asked for: of a formula
    ``naive``, as written. Where an object does not exist (the evolute of a straight piece) the other pieces are
    returned and the missing ones named.

    >>> from exactspline.interchange.examples import example
    >>> derive("evolute", example("circle"))("1/2")
    (mpq(0,1), mpq(0,1))

    Raises `FormulaError` for an unknown name or variant, `ShapeError` for a curve of the wrong dimension or where it
    exists nowhere.
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
    pieces = tuple(Piece(interval, compute(part(curve, *interval))) for interval in intervals_where(breaks, exists))
    if not pieces:
        everywhere = ", ".join(f"on {_shown(interval)} {reason.words}" for interval, reason in missing)
        raise ShapeError(f"{curve.name or 'the curve'} has no {name}: {everywhere}", remedy="choose another curve")
    return Derived(name, Variant(variant), pieces, missing, ruled)


def _exists(value: Any) -> list[bool]:
    """Segment by segment, whether a denominator, and the generator of a ruled surface, are not identically zero."""
    if isinstance(value, RuledSurface):
        ends = [_exists(part) for part in (value.directrix, value.generator)]
        generator = zip(*[c.polynomials for c in numerator(value.generator)], strict=True)
        return [all(here) and any(parts) for *here, parts in zip(*ends, generator, strict=True)]
    if isinstance(value, Rational):
        return [bool(c) for c in value.denominator.polynomials]
    return [True] * len((value[0] if isinstance(value, Vector) else value).mesh)


def _why_missing(made: Construction | None, curve: Nurbs, i: int) -> Absence:
    """Why a construction does not exist on a segment: what vanishes identically there on the curve itself."""
    if made is not None and curve.dimension in (2, 3):
        facts = analyse(curve)
        if facts.standing[i]:
            return Absence.STILL
        if facts.flatness.vanishes_on(facts.breaks)[i]:
            return Absence.STRAIGHT
        if facts.in_space and facts.zero_form("zero_torsion", Variant.PAPER).vanishes_on(facts.breaks)[i]:
            return Absence.PLANAR
    return Absence.DENOMINATOR
