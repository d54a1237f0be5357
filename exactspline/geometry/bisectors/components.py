"""The parts of a bisector outside its surface: lines along a curve of pairs of parameters, planes, single pairs,
poles.
"""

from __future__ import annotations

from dataclasses import dataclass, field, fields, replace
from enum import StrEnum
from typing import Any, TypeVar, cast

from flint import arb, fmpz_mpoly

from exactspline.errors import ShapeError
from exactspline.geometry.bisectors.common import within
from exactspline.geometry.bisectors.lines import ALL, Conditions, Flat, RootLines, enclosed_flat, flat_at
from exactspline.geometry.bisectors.system import System
from exactspline.language.rational import Rational
from exactspline.numbers.exact import Number, mpq, rational
from exactspline.numbers.intervals import Box
from exactspline.one_line import OneLine
from exactspline.polynomials.two_parameters import CONTEXT, S, T, at
from exactspline.roots.of_polynomials import Parameter, exactly, roots_in
from exactspline.roots.root import Root
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.lowest_terms import RationalSurface

#: Longer equations are shown by their degree only.
SHORT = 40
W = TypeVar("W", bound=StrEnum)


class Solutions(StrEnum):
    """The solutions for one pair of parameters."""

    LINE = "line"
    PLANE = "plane"
    SPACE = "all of space"


class Cause(StrEnum):
    """The reason why the system of a pair of parameters is singular and has solutions."""

    DEPENDENT = "the three planes have a line in common"
    OVERLAP = "the curves run through one point with one tangent"
    CROSSING = "the curves meet"
    FIRST_CUSP = "the first curve has no tangent"
    SECOND_CUSP = "the second curve has no tangent"
    BOTH_CUSPS = "neither curve has a tangent"
    FIRST_STILL = "the first curve stands still"
    SECOND_STILL = "the second curve stands still"
    BOTH_STILL = "both curves stand still"


class Correspondence(StrEnum):
    """The relation between the parameters of a curve of pairs."""

    ALL = "all pairs"
    FIRST_FIXED = "s fixed"
    SECOND_FIXED = "t fixed"
    RATIONAL = "one parameter is a rational function of the other"
    ALGEBRAIC = "algebraic"


@dataclass(frozen=True, repr=False)
class PairEquation(OneLine):
    """An irreducible integer polynomial in both parameters; its zeros form a curve of pairs.

    >>> equation = PairEquation.of(S - T)
    >>> equation.text, equation(2, 2)
    ('s - t', mpq(0,1))
    """

    #: The exponents of s and t, and the integer coefficients.
    terms: tuple[tuple[tuple[int, int], int], ...]

    @classmethod
    def of(cls, p: fmpz_mpoly) -> PairEquation:
        """The equation ``p = 0``, its first coefficient made positive."""
        sign = 1 if p.leading_coefficient() > 0 else -1
        return cls(tuple(((int(i), int(j)), sign * int(x)) for (i, j), x in p.terms()))

    @property
    def polynomial(self) -> fmpz_mpoly:
        """The equation as a polynomial of FLINT in s and t."""
        return CONTEXT.from_dict(dict(self.terms))

    @property
    def text(self) -> str:
        """The polynomial as text."""
        return str(self.polynomial)

    @property
    def is_short(self) -> bool:
        """Whether the equation is short enough to be shown."""
        return len(self.terms) <= SHORT and len(self.text) + 4 <= SHORT

    @property
    def short_text(self) -> str:
        """The equation as text if it is short, otherwise its degree.

        >>> PairEquation.of(S - T).short_text, PairEquation.of(S**40 * 10**40 - T**3).short_text
        ('s - t = 0', 'equation of degree 40 × 3')
        """
        if self.is_short:
            return f"{self.text} = 0"
        m, n = (max(powers[i] for powers, _ in self.terms) for i in (0, 1))
        return f"equation of degree {m} × {n}"

    def __call__(self, s: Number, t: Number) -> mpq:
        """The exact value of the polynomial."""
        u, v = rational(s), rational(t)
        return sum((x * u**i * v**j for (i, j), x in self.terms), mpq(0))

    def transposed(self) -> PairEquation:
        """The equation with the parameters exchanged."""
        return PairEquation.of(self.polynomial.compose(T, S))


@dataclass(frozen=True, repr=False)
class LinePiece(OneLine):
    """Lines as a ruled surface over [low, high] of one parameter: ``of`` is 0 if this parameter is s, 1 if it is t.

    The other parameter is a constant, a quotient of splines, or None where it is arbitrary. Directrix and generator are
    splines over the whole segment.
    """

    of: int
    low: Parameter
    high: Parameter
    other: Parameter | Rational[BSpline] | None
    surface: RationalSurface

    def pair(self, parameter: Number) -> tuple[Parameter | None, Parameter | None]:
        """The pair of parameters for a parameter of the piece."""
        u = within(parameter, self.low, self.high)
        other = self.other.number(u) if isinstance(self.other, Rational) else self.other
        return (u, other) if self.of == 0 else (other, u)

    def __call__(self, parameter: Number, ruling: Number) -> tuple[mpq, ...]:
        """A point of a line; raises `ShapeError` outside the piece, `ZeroDivisionError` where the line is at
        infinity.
        """
        return self.surface.at(rational(ruling)).point(within(parameter, self.low, self.high))

    @property
    def poles(self) -> list[Root]:
        """The parameters of the piece whose line is at infinity."""
        return [t for t in zeros(self.surface.directrix.denominator) if self.low <= t <= self.high]

    def transposed(self) -> LinePiece:
        """The piece of the exchanged curves."""
        return replace(self, of=1 - self.of)


@dataclass(frozen=True, repr=False)
class Branch(OneLine):
    """A real branch of a curve of pairs: over the open interval (low, high) of s, the root of the equation with this
    `index` (counted from 0 in increasing order) among the roots t inside the side of the rectangle; ``sample`` is a
    pair on the branch.
    """

    low: Parameter
    high: Parameter
    index: int
    sample: tuple[mpq, Parameter]


@dataclass(frozen=True, repr=False)
class RealZeros(OneLine):
    """The real zeros of an equation on a closed rectangle: its branches and their limits, the pairs on the border, and
    singular pairs at which no branches cross.
    """

    branches: tuple[Branch, ...] = ()
    ends: tuple[tuple[Parameter, Parameter], ...] = ()
    nodes: tuple[tuple[Parameter, Parameter], ...] = ()

    def __bool__(self) -> bool:
        return bool(self.branches or self.ends or self.nodes)


@dataclass(frozen=True, repr=False)
class LineComponent(OneLine):
    """Lines of solutions along a curve of pairs.

    The component has ``pieces`` if the pairs are parametrized rationally, ``over_root`` if one parameter is an
    irrational constant, and otherwise the ``real`` zeros of the equation. ``equation`` is None if all pairs of the
    rectangle have lines.
    """

    correspondence: Correspondence
    cause: Cause
    system: System = field(repr=False, compare=False)
    equation: PairEquation | None
    pieces: tuple[LinePiece, ...] = ()
    real: RealZeros = RealZeros()
    over_root: RootLines | None = None

    @property
    def fixed(self) -> Root | None:
        """The parameter that is an irrational constant."""
        return None if self.over_root is None else self.over_root.other

    @property
    def sides(self) -> Box:
        """The patch on which the component lies."""
        return self.system.sides

    def partners(self, s: Number) -> list[Parameter]:
        """The parameters t of the pairs with a rational s, in order, also where the line is at infinity (see the poles
        of the pieces); raises `ShapeError` if all pairs have lines.
        """
        if self.equation is None:
            raise ShapeError("all pairs have lines", remedy="take any parameter")
        return [exactly(t) for t in roots_in(at(self.equation.polynomial, 0, rational(s)), *self.sides[1])]

    def line(self, s: Parameter, t: Parameter, digits: int = 20) -> Flat[arb]:
        """The line of a pair, in balls."""
        return enclosed_flat(self.system, s, t, _conditions(self.cause), digits, plane=False)

    def transposed(self) -> LineComponent:
        """The component of the exchanged curves (without branches)."""
        return replace(
            self,
            correspondence=_exchanged(self.correspondence),
            cause=_exchanged(self.cause),
            system=self.system.transposed(),
            equation=self.equation and self.equation.transposed(),
            pieces=tuple(one.transposed() for one in self.pieces),
            over_root=self.over_root and self.over_root.transposed(),
        )


@dataclass(frozen=True, repr=False)
class PlaneComponent(OneLine):
    """A plane (or all of space) for every pair of a curve of pairs, or of a rectangle (then the equation is None).

    ``intervals`` are the intervals of s (of t where ``of`` is 1) on which the equation gives the other parameter as a
    quotient; ``fixed`` is t (s where ``of`` is 0) if this parameter is constant; otherwise there are branches as for
    lines.
    """

    solutions: Solutions
    cause: Cause
    sides: Box
    equation: PairEquation | None
    intervals: tuple[tuple[Parameter, Parameter], ...] = ()
    of: int = 0
    fixed: Parameter | None = None
    real: RealZeros = RealZeros()

    def transposed(self) -> PlaneComponent:
        """The component of the exchanged curves (without branches)."""
        return replace(
            self,
            of=1 - self.of,
            cause=_exchanged(self.cause),
            sides=Box(self.sides.second, self.sides.first),
            equation=self.equation and self.equation.transposed(),
        )


@dataclass(frozen=True, repr=False)
class SinglePair(OneLine):
    """One pair of parameters whose system is singular and has solutions."""

    s: Parameter
    t: Parameter
    solutions: Solutions
    cause: Cause
    system: System = field(repr=False, compare=False)

    @property
    def sides(self) -> Box:
        """The patch on which the pair lies."""
        return self.system.sides

    @property
    def place(self) -> tuple[Parameter, Parameter]:
        """The two parameters of the pair."""
        return self.s, self.t

    @property
    def exact(self) -> Flat[mpq] | None:
        """The line or the plane with exact coordinates where both parameters are rational, otherwise None."""
        if isinstance(self.s, Root) or isinstance(self.t, Root):
            return None
        return flat_at(self.system, self.s, self.t, _conditions(self.cause), plane=self.solutions == Solutions.PLANE)

    def enclosed(self, digits: int = 20) -> Flat[arb]:
        """The line or the plane in balls, from the parameters to a given number of digits."""
        return enclosed_flat(
            self.system, self.s, self.t, _conditions(self.cause), digits, plane=self.solutions == Solutions.PLANE
        )

    def transposed(self) -> SinglePair:
        """The pair of the exchanged curves."""
        return replace(self, s=self.t, t=self.s, cause=_exchanged(self.cause), system=self.system.transposed())


@dataclass(frozen=True, repr=False)
class PoleCurve(OneLine):
    """An irreducible factor of the determinant of the surface. Along the zeros of the factor on the rectangle the
    surface is at infinity.

    ``certain`` means that the factor certainly has zeros there, because it takes both signs.
    """

    equation: PairEquation
    sides: Box
    certain: bool


@dataclass(frozen=True, repr=False)
class SpecialPairs(OneLine):
    """All pairs of parameters that do not have exactly one point: pairs with lines, planes or all of space, and the
    poles.

    ``undecided`` lists what could not be decided; if it is empty, the answer is complete.
    """

    lines: tuple[LineComponent, ...] = ()
    planes: tuple[PlaneComponent, ...] = ()
    pairs: tuple[SinglePair, ...] = ()
    poles: tuple[PoleCurve, ...] = ()
    undecided: tuple[str, ...] = ()

    def transposed(self) -> SpecialPairs:
        """The special pairs of the exchanged curves (without poles and branches)."""
        own: dict[str, Any] = {"lines": self.lines, "planes": self.planes, "pairs": self.pairs}
        turned = {name: tuple(x.transposed() for x in found) for name, found in own.items()}
        return replace(self, **turned, poles=())

    def __add__(self, other: SpecialPairs) -> SpecialPairs:
        return SpecialPairs(*[getattr(self, each.name) + getattr(other, each.name) for each in fields(self)])


def _conditions(cause: Cause) -> Conditions:
    """The effective planes: a curve without a tangent has no normal plane."""
    void = {
        Cause.FIRST_CUSP: Conditions.FIRST,
        Cause.SECOND_CUSP: Conditions.SECOND,
        Cause.FIRST_STILL: Conditions.FIRST,
        Cause.SECOND_STILL: Conditions.SECOND,
        Cause.BOTH_CUSPS: Conditions.FIRST | Conditions.SECOND,
    }
    return ALL & ~void[cause] if cause in void else ALL


#: The causes and correspondences that are exchanged with the curves.
_EXCHANGED: dict[Any, Any] = {
    Cause.FIRST_CUSP: Cause.SECOND_CUSP,
    Cause.FIRST_STILL: Cause.SECOND_STILL,
    Correspondence.FIRST_FIXED: Correspondence.SECOND_FIXED,
}
_EXCHANGED |= {second: first for first, second in _EXCHANGED.items()}


def _exchanged(of: W) -> W:
    """The cause, or the correspondence, of the exchanged curves."""
    return cast(W, _EXCHANGED.get(of, of))
