"""The bisector of two plane curves, as the zeros of a function of both parameters
(`exactspline.geometry.bisectors.plane_pair`).

Source: Elber and Kim, Bisector curves of planar rational curves, Computer-Aided Design 1998.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from itertools import chain, compress, product

from exactspline.bivariate.zeros import ZeroArc, ZeroCurves, zero_curve
from exactspline.errors import ReachError, ShapeError
from exactspline.geometry.bisectors.common import Bisector
from exactspline.geometry.bisectors.plane_pair import PlanePair, tangent
from exactspline.geometry.bisectors.true_pairs import TruePairs, true_pairs
from exactspline.numbers.exact import Number, mpq
from exactspline.numbers.intervals import Box
from exactspline.numbers.once import cached_property
from exactspline.numbers.sides import Side
from exactspline.questions.answers import NamedNumbers
from exactspline.reals.real import Real, real
from exactspline.roots.values import evaluate, exact_place, sign_at
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import Along
from exactspline.splines.tensor import TensorSpline
from exactspline.splines.type_checks import curve_of


class PlaneBisector(Bisector):
    """The points equally far from a point of each of two plane curves, on the normals of both: for the pairs (s, t) at
    which `function` vanishes. Its `pairs` are these zeros, complete with their topology; its `pieces` the arcs.

    It is not trimmed: another part of a curve may be nearer, and a foot may be a point of greatest distance. `trimmed`
    says for which pairs that is not so. Along
    `pairs.lines` a curve has no tangent, or all pairs with one of its points have such a point (an arc of a circle and
    its centre).

    >>> line, other = (Nurbs(1, [0, 0, 1, 1], points) for points in ([(0, 0), (2, 0)], [(0, 1), (3, 4)]))
    >>> found = PlaneBisector(line, other)
    >>> found.pieces
    (<arc from (-1 + √2)/2 and 0 to 1 and (-2 + 3√2)/6>,)
    """

    def __init__(self, first: Nurbs, second: Nurbs) -> None:
        for curve in (curve_of(first), curve_of(second)):
            if curve.dimension != 2:
                raise ShapeError(f"a curve in R{curve.dimension}", remedy="give curves in the plane")
        self.curves = first, second

    @cached_property
    def function(self) -> TensorSpline:
        """``F(s, t) = (a·E) [E b] − [a E] (b·E)``."""
        return PlanePair.of_curves(*self.curves).equidistant

    @cached_property
    def pairs(self) -> ZeroCurves:
        """All zeros of the function; they run on over the seam of a closed curve where that is no corner."""
        closed = [curve.closed and _has_one_tangent(curve, *curve.domain[::-1]) for curve in self.curves]
        return zero_curve(self.function, compress(Along, closed))

    @cached_property
    def trimmed(self) -> TruePairs:
        """Where the pairs are true feet: no point of either curve is nearer. Points whose feet are ends or corners of
        the curves are not among the pairs.

        >>> line, other = (Nurbs(1, [0, 0, 1, 1], points) for points in ([(0, 0), (2, 0)], [(0, 1), (3, 4)]))
        >>> PlaneBisector(line, other).trimmed.undecided
        ()
        """
        return true_pairs(*self.curves)

    @property
    def pieces(self) -> tuple[ZeroArc, ...]:  # type: ignore[override]  # computed when it is asked for
        """The arcs of pairs between singular points and borders."""
        return self.pairs.arcs

    @property
    def missing(self) -> tuple[Box, ...]:  # type: ignore[override]  # computed when it is asked for
        """The rectangles in which pairs are not decided."""
        return self.pairs.undecided

    def point(self, s: Number | Real, t: Number | Real) -> tuple[mpq | Real, ...]:
        """The point of a pair at which the function vanishes, exactly; on a common normal the one in the middle. At a
        corner it is that of the side from which the function vanishes, the right one if it does from both.

        Raises `ReachError` where the normals are parallel and apart, and where a curve has no tangent.
        """
        place = exact_place(s), exact_place(t)
        pairs = [PlaneBisector(*pair) for pair in product(*map(_sides, self.curves, place))]
        first, second = next((pair for pair in pairs[:-1] if pair._vanishes(*place)), pairs[-1]).curves
        p, q = evaluate(first, s), evaluate(second, t)
        a, b = ([evaluate(f, x) for f in tangent(curve)] for curve, x in ((first, s), (second, t)))
        chord = [y - x for x, y in zip(p, q, strict=True)]
        across = a[0] * b[1] - a[1] * b[0]
        if across == 0:
            if not all(any(x != 0 for x in own) for own in (a, b)):
                raise ReachError("a point where a curve has no tangent", remedy="give a pair next to it")
            if a[0] * chord[0] + a[1] * chord[1] != 0:
                raise ReachError("a point on two normals that are parallel", remedy="give a pair next to it")
            return (p[0] + q[0]) / 2, (p[1] + q[1]) / 2
        along = (b[0] * chord[0] + b[1] * chord[1]) / across
        return p[0] - along * a[1], p[1] + along * a[0]

    @property
    def items(self) -> Iterator[NamedNumbers]:
        """The arcs of pairs and the single ones: the points of their ends but those at infinity, then the parameters;
        lines and rectangles of pairs by their sides.
        """
        for arc in self.pairs.arcs:
            places = [] if arc.start is None or arc.end is None else [("start", arc.start), ("end", arc.end)]
            yield NamedNumbers("arc of pairs" if places else "loop of pairs", self._by_name(places))
        for point in self.pairs.points:
            yield NamedNumbers("pair", self._by_name([("parameter", (point.first, point.second))]))
        boxes = [("line of pairs", line.box) for line in self.pairs.lines]
        boxes += [("rectangle of pairs", (part.sides[0], part.sides[1])) for part in self.pairs.everywhere]
        for what, box in boxes:
            ends = zip(("start", "end", "other start", "other end"), chain(*box), strict=True)
            yield NamedNumbers(what, {name: real(x) for name, x in ends})

    def _by_name(self, places: Sequence[tuple[str, tuple[Real, Real]]]) -> dict[str, Real]:
        """Pairs of parameters by name, before them their points."""
        values, parameters = dict[str, Real](), dict[str, Real]()
        for name, (s, t) in places:
            with suppress(ReachError):
                values |= zip((f"{name} x", f"{name} y"), map(real, self.point(s, t)), strict=True)
            parameters |= {name: s, f"other {name}": t}
        return values | parameters

    def _vanishes(self, s: mpq | Real, t: mpq | Real) -> bool:
        """Whether the function vanishes at a pair of which one number is rational."""
        if not isinstance(t, Real):
            return sign_at(self.function.at_t(t), s) == 0
        assert not isinstance(s, Real)
        return sign_at(self.function.at_s(s), t) == 0


def _has_one_tangent(curve: Nurbs, before: mpq, behind: mpq) -> bool:
    """Whether the tangents left and right of a point are parallel, also where the curve turns back, or there is none;
    both parameters are of this point.
    """
    last, first = ([f(t, side) for f in tangent(curve)] for t, side in ((before, Side.LEFT), (behind, Side.RIGHT)))
    return any(first) == any(last) and first[0] * last[1] == first[1] * last[0]


def _sides(curve: Nurbs, t: mpq | Real) -> list[Nurbs]:
    """The parts of a curve behind and before a corner at a parameter, those with a tangent there; elsewhere all of
    it.
    """
    low, high = curve.domain
    if isinstance(t, Real) or t not in curve.breakpoints[1:-1] or _has_one_tangent(curve, t, t):
        return [curve]
    return [part for part in (curve.restrict(t, high), curve.restrict(low, t)) if any(f(t) for f in tangent(part))]
