"""The bisector of two space curves, before any trimming: a surface over the pairs of parameters that have exactly one
point, and the lines and planes of the pairs that have more (`exactspline.geometry.bisectors.special_pairs`).

Parameters and coordinates are unitless exact numbers. "Bisector" means equal *critical* distances.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from itertools import pairwise, product, starmap
from typing import Any

from exactspline.errors import ReachError, ShapeError
from exactspline.geometry.bisectors.common import COPLANAR, PARALLEL, STILL, Bisector, is_zero_on
from exactspline.geometry.bisectors.components import LineComponent, PlaneComponent, PoleCurve, SinglePair, SpecialPairs
from exactspline.geometry.bisectors.special_pairs import special_pairs
from exactspline.geometry.derived.derive import part
from exactspline.language.rational import Rational
from exactspline.language.vector import cross
from exactspline.numbers.exact import Number, mpq, rational
from exactspline.numbers.intervals import Box, Interval
from exactspline.one_line import one_line, short_text
from exactspline.papers import find
from exactspline.polynomials.cost import PATCH, QUESTION, Budget, drawing_on
from exactspline.questions.entry import Answered, Fact, Inspected, Of, question
from exactspline.splines.lowest_terms import surface_in_lowest_terms
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.tensor import TensorSpline, surface_pair
from exactspline.splines.type_checks import curve_of, of_dimension
from exactspline.words import choice


@dataclass(frozen=True, repr=False)
class BisectorPatch:
    """A part of the bisector of two curves: a rectangle of parameters, and a `Rational` of splines in both."""

    sides: Box
    value: Rational[TensorSpline]

    @one_line
    def __repr__(self) -> str:
        return f"<BisectorPatch on {self.sides}>"


class SurfaceVariant(StrEnum):
    """The method by which the surface of two space curves is computed."""

    NAIVE = "naive"
    LEVELLED = "levelled"
    PAPER = "paper"
    SYMMETRIC = "symmetric"
    MINIMAL = "minimal"


#: Formulas by variant.
CURVE_FORMS = {
    SurfaceVariant.NAIVE: "bisector",
    SurfaceVariant.LEVELLED: "bisector_levelled",
    SurfaceVariant.PAPER: "bisector_polynomial",
    SurfaceVariant.SYMMETRIC: "bisector_symmetric",
    SurfaceVariant.MINIMAL: "bisector_symmetric",
}


class CurveBisector(Inspected, Bisector):
    """The bisector of two space curves: the surface in patches; the rectangles on which a general pair does not have
    exactly one point (`missing`), each with the reason; and all pairs that have more than a point, which are computed
    when first needed. The questions about a bisector are entries of the registry
    (`exactspline.geometry.analysis.ask`).

    Together ``patches``, ``lines``, ``planes`` and ``pairs`` are all points with two equal critical distances, except
    for the cases listed in ``undecided``; along ``poles`` the surface is at infinity. ``unreduced`` lists the patches
    whose lowest terms would take too much work; ``budget`` is the work that remains for the whole answer.
    """

    def __init__(self, first: Nurbs, second: Nurbs, variant: SurfaceVariant = SurfaceVariant.MINIMAL) -> None:
        super().__init__(first, second, variant)
        self.curves, self.variant = (first, second), variant
        with drawing_on(Budget(QUESTION + PATCH * (first.segments * second.segments - 1))) as self.budget:
            self._patches, self.missing, self.unreduced = _surface(first, second, variant)

    @one_line
    def __repr__(self) -> str:
        return Bisector.__repr__(self)

    @property
    def pieces(self) -> tuple[BisectorPatch, ...]:  # type: ignore[override]  # read only
        """The patches of the bisector surface."""
        return self.patches

    @Fact
    def special(self) -> SpecialPairs:
        """The pairs of parameters that do not have exactly one point."""
        return special_pairs(*self.curves, self.budget)

    @question(Of.PAIR, answered=Answered.SOLUTIONS)
    def patches(self) -> tuple[BisectorPatch, ...]:
        """The bisector surface in patches: the points of the pairs of parameters that have exactly one point.

        >>> from exactspline import bisector, example
        >>> found = bisector(example("rational_space_cubic"), example("twisted_cubic"))
        >>> [patch.value.degree for patch in found.patches]
        [Degrees(s=10, t=8)]
        """
        return self._patches

    @question(Of.PAIR, answered=Answered.SOLUTIONS)
    def lines(self) -> tuple[LineComponent, ...]:
        """The lines of solutions along curves of pairs.

        >>> from exactspline import bisector, example
        >>> len(bisector(example("rational_space_cubic"), example("twisted_cubic")).lines)
        0
        """
        return self.special.lines

    @question(Of.PAIR, answered=Answered.SOLUTIONS)
    def planes(self) -> tuple[PlaneComponent, ...]:
        """The planes of solutions along curves of pairs.

        >>> from exactspline import bisector, example
        >>> len(bisector(example("rational_space_cubic"), example("twisted_cubic")).planes)
        0
        """
        return self.special.planes

    @question(Of.PAIR, answered=Answered.SOLUTIONS)
    def pairs(self) -> tuple[SinglePair, ...]:
        """The single pairs whose solutions are a line, a plane or all of space.

        >>> from exactspline import bisector, example
        >>> len(bisector(example("rational_space_cubic"), example("twisted_cubic")).pairs)
        3
        """
        return self.special.pairs

    @question(Of.PAIR, answered=Answered.SOLUTIONS)
    def poles(self) -> tuple[PoleCurve, ...]:
        """The curves of pairs along which the bisector surface is at infinity.

        >>> from exactspline import bisector, example
        >>> len(bisector(example("rational_space_cubic"), example("twisted_cubic")).poles)
        1
        """
        return self.special.poles

    @property
    def undecided(self) -> tuple[str, ...]:
        """The parts that could not be decided or reduced; empty if the answer is complete."""
        return self.unreduced + self.special.undecided

    def __call__(self, s: Number, t: Number) -> tuple[mpq, ...]:
        """The point for two parameters; raises `ZeroDivisionError` at a pole, `ShapeError` where there is no
        surface.
        """
        u, v = rational(s), rational(t)
        for patch in self.patches:
            if all(a <= x <= b for x, (a, b) in zip((u, v), patch.sides, strict=True)):
                return patch.value.point(u, v)
        problem = f"there is no surface at ({short_text(u)}, {short_text(v)})"
        raise ShapeError(problem, remedy="; ".join(reason for _, reason in self.missing))


def curve_bisector(
    first: Nurbs, second: Nurbs, variant: SurfaceVariant | str = SurfaceVariant.MINIMAL
) -> CurveBisector:
    """The bisector of two space curves.

    `variant` is ``naive``, ``levelled`` or ``paper`` for the equations (22), (26) and (27) of the paper (Chen,
    Riesenfeld and Cohen 2007), ``symmetric`` for (27) made polynomial in both curves, or ``minimal`` for ``symmetric``
    in lowest terms.

    >>> from exactspline.interchange.examples import example
    >>> found = curve_bisector(example("rational_space_cubic"), example("twisted_cubic"))
    >>> found.patches[0].value.degree, len(found.pairs), found.undecided
    (Degrees(s=10, t=8), 3, ())

    The work on the whole answer, including what is computed when first needed, is limited to about ten seconds
    (somewhat more for many pairs of segments); parts that exceed this are listed in ``undecided``.

    Raises `ShapeError` for curves that are not in space, `FormulaError` for an unknown variant.
    """
    chosen = choice(SurfaceVariant, variant, "variant")
    first, second = curve_of(first), curve_of(second)
    for c in (first, second):
        of_dimension(c, "use curves in space; bisector(first, second) of the library takes plane curves, too", 3)
    return CurveBisector(first, second, chosen)


def _surface(
    first: Nurbs, second: Nurbs, variant: SurfaceVariant
) -> tuple[tuple[BisectorPatch, ...], tuple[tuple[Box, str], ...], tuple[str, ...]]:
    """The patches, the rectangles without a surface, and the patches that are not in lowest terms."""
    pair = surface_pair(first, second)
    determinant = find("bisector_determinant_symmetric")(pair)
    missing: list[tuple[Box, str]] = []
    rectangles: list[Box] = []
    d1, other = find("D1")(pair.first), find("D1")(pair.second)
    parallel = cross(d1, other)
    sides = [list(starmap(Interval, pairwise(mesh.breaks))) for mesh in determinant.meshes]
    for at, rectangle in enumerate(starmap(Box, product(*sides))):
        if determinant.numerators[at]:
            rectangles.append(rectangle)
        else:
            still = any(is_zero_on(v, at) for v in (d1, other))
            missing.append((rectangle, STILL if still else PARALLEL if is_zero_on(parallel, at) else COPLANAR))
    parts: list[Any] = (
        [(pair.first.w.domain, pair)]
        if not missing
        else [(r, surface_pair(part(first, *r[0]), part(second, *r[1]))) for r in rectangles]
    )
    patches, unreduced = [], []
    for sides, part_pair in parts:
        value = find(CURVE_FORMS[variant])(part_pair)
        if variant is SurfaceVariant.MINIMAL:
            try:
                value = surface_in_lowest_terms(value)
            except ReachError as error:
                unreduced.append(f"lowest terms of the surface on {sides.shortly}: {error.problem}")
        patches.append(BisectorPatch(sides, value))
    return tuple(patches), tuple(missing), tuple(unreduced)
