"""Curves that pass through infinity, such as the evolute of a curve with an inflection: their poles, and their features
between the poles.

A pole is a zero of the denominator, usually an irrational number. The curve is analysed on pieces with rational ends so
close to the poles that no feature is lost: between a piece and a pole, the forms whose zeros are features have no zero.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby, pairwise

from exactspline.errors import ShapeError
from exactspline.formulas.lifted import PLANE_FORMS
from exactspline.geometry.curves.facts import Facts, facts_of
from exactspline.geometry.curves.joints import Joint
from exactspline.geometry.derived.derive import Derived, Piece
from exactspline.hooks import Displayed
from exactspline.language.arguments import Curve
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval
from exactspline.numbers.once import cached_property
from exactspline.one_line import OneLine
from exactspline.roots.root import Root
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs

#: The initial precision (digits) of a pole, and the refinement limit (digits) for separating two zeros.
FIRST_DIGITS, MOST_DIGITS = 6, 4096


@dataclass(frozen=True, repr=False)
class BetweenPoles(OneLine, Displayed):
    """A plane curve in pieces without poles, and the poles, each with an interval that contains no feature.

    Features at the poles are not reported: the curve has no point there.
    """

    poles: tuple[Root, ...]
    around: tuple[Interval, ...]
    pieces: tuple[Nurbs, ...]

    @cached_property
    def facts(self) -> tuple[Facts, ...]:
        """The facts of each piece."""
        return tuple(facts_of(piece) for piece in self.pieces)

    @property
    def corners(self) -> tuple[Joint, ...]:
        """The joints at which the direction of the tangent jumps."""
        return tuple(joint for own in self.facts for joint in own.corners)

    @property
    def reversals(self) -> tuple[Root | mpq, ...]:
        """The parameters at which the curve turns back: its cusps, and its corners of 180°, in order.

        >>> from exactspline.geometry.derived.derive import derive
        >>> from exactspline.interchange.examples import example
        >>> own = between_poles(derive("evolute", example("six_segment_cubic")))
        >>> len(own.poles), len(own.reversals), [str(t) for t in own.reversals if not isinstance(t, Root)]
        (2, 8, ['3', '4'])
        """
        found: list[Root | mpq] = [each.root for own in self.facts for each in own.cusps]
        found += [each.parameter for each in self.corners if each.angle is not None and each.angle.reverses]
        return tuple(t for t, _ in groupby(sorted(found)))


def between_poles(derived: Derived) -> BetweenPoles:
    """A derived plane curve, in pieces between its poles.

    >>> from exactspline.geometry.derived.derive import derive
    >>> from exactspline.interchange.examples import example
    >>> own = between_poles(derive("evolute", example("cubic_s")))
    >>> [round(float(pole), 3) for pole in own.poles], len(own.pieces)
    ([0.5], 2)

    Raises `ShapeError` for anything that is not a plane curve.
    """
    poles: list[Root] = []
    around: list[Interval] = []
    pieces: list[Nurbs] = []
    for piece in derived.pieces:
        p, w = _operands(piece)
        found = [] if w is None else list(zeros(w))
        gaps = [] if w is None else _gaps(p, w, found, piece.interval)
        poles += found
        around += gaps
        pieces += [_curve(p, w, a, b) for a, b in _between(piece.interval, gaps)]
    return BetweenPoles(tuple(poles), tuple(around), tuple(pieces))


def _operands(piece: Piece) -> tuple[Vector[BSpline], BSpline | None]:
    value = piece.value
    numerators = value.numerator if isinstance(value, Rational) else value
    if not isinstance(numerators, Vector) or len(numerators) != 2:
        raise ShapeError("this is not a plane curve", remedy="give for example an evolute")
    return numerators, value.denominator if isinstance(value, Rational) else None


def _gaps(p: Vector[BSpline], w: BSpline, poles: Sequence[Root], domain: Interval) -> list[Interval]:
    """An interval around each pole that contains no other pole, no knot, and no zero of a form except the pole."""
    curve = Curve(p, w)
    others: list[Root | mpq] = [t for t in w.breakpoints if all(pole != t for pole in poles)]
    for form in PLANE_FORMS:
        others += [root for root in zeros(form(curve)) if all(root != pole for pole in poles)]
    return [_gap(pole, [*others, *(each for each in poles if each is not pole)], domain) for pole in poles]


def _gap(pole: Root, others: Sequence[Root | mpq], domain: Interval) -> Interval:
    digits = FIRST_DIGITS
    while digits <= MOST_DIGITS:
        low, high = pole.refine(digits)
        width = mpq(1, 10**digits)
        gap = Interval(max(low - width, domain[0]), min(high + width, domain[1]))
        if not any(gap[0] <= other <= gap[1] for other in others):
            return gap
        digits *= 2
    raise ShapeError("a pole is too close to something else", remedy="report this")


def _between(domain: Interval, gaps: Sequence[Interval]) -> Iterator[tuple[mpq, mpq]]:
    ends = [domain[0], *[t for gap in gaps for t in gap], domain[1]]
    yield from ((a, b) for a, b in list(pairwise(ends))[::2] if a < b)


def _curve(p: Vector[BSpline], w: BSpline | None, a: mpq, b: mpq) -> Nurbs:
    """The curve on [a, b], where w has no zero."""
    numerators = [x.restrict(a, b) for x in p]
    if w is None:
        return Nurbs.from_splines(numerators)
    weight = w.restrict(a, b)
    sign = 1 if weight((a + b) / 2) > 0 else -1
    return Nurbs.from_splines([sign * x for x in numerators], sign * weight)
