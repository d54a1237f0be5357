"""Whether two sides are equal: decided in one place, for values of any kind (differential polynomials, splines,
expressions of sympy). If both sides vanish, or a division by zero occurs, nothing is decided.

Every kind of claim that states the equality of two values is decided here: identities and vanishing values, ruled
surfaces, directrices, values on changed curves, sums of squares.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import Enum, auto
from typing import Any, Protocol

from exactspline.errors import FormulaError
from exactspline.language.arguments import Curve, Evaluated, embedded
from exactspline.language.formula import Formula
from exactspline.language.ruled import RuledSurface, Value, differences, split
from exactspline.language.vector import Vector
from exactspline.papers import find as find_anywhere
from exactspline.readings.jet import JetFraction
from exactspline.splines.bspline import BSpline
from exactspline.splines.tensor import TensorSpline
from exactspline.symbolic.factorization import find_factor
from exactspline.verification.curve_check import stated_factor, where_it_differs
from exactspline.verification.evidence import (
    ComponentDiffers,
    Components,
    Difference,
    Evidence,
    Fact,
    NoGenerator,
    OneSurface,
    Rulings,
    Sides,
    SumOfSquares,
)
from exactspline.verification.notation import factor_formulas, factor_of_text
from exactspline.verification.verdict import PROVED, REFUTED, Finding, vacuous
from exactspline.verification.vocabulary import Name, Verdict


class Outcome(Enum):
    """How two sides compare."""

    EQUAL = auto()
    #: The sides differ; the component in which they differ, and the difference, are known.
    DIFFERENT = auto()
    #: The sides are vectors with different numbers of components.
    UNLIKE = auto()
    #: Both sides vanish: 0 = 0.
    NOTHING = auto()
    #: A side does not exist (on a whole segment, or anywhere), because of a division by zero.
    NO_SIDE = auto()
    #: The factor does not exist (on a whole segment, or anywhere), because of a division by zero.
    NO_FACTOR = auto()


@dataclass(frozen=True)
class _Decision:
    """How two sides compare, and the component in which they differ: by `difference` over the product of `divisors`."""

    outcome: Outcome
    component: int = 0
    difference: Any = None
    divisors: Sequence[Any] = ()


class Statement(Protocol):
    """The equality of two values, which can be decided for an argument of formulas in any exact reading."""

    def decide(self, c: Evaluated, holds: Verdict = PROVED) -> Finding:
        """The finding, `holds` if the statement is true. A factor that exists for no curve makes the statement false;
        on a curve on which the factor does not exist, nothing is decided.
        """

    def residues(self, c: Evaluated) -> list[JetFraction]:
        """The values that vanish exactly if the statement is true, for an argument in an evaluation mode with
        division.
        """


@dataclass(frozen=True)
class Equation:
    """``left = factor · right``; `find` gives the formulas in the factor.

    >>> from exactspline.papers import find
    >>> from exactspline.symbolic.factorization import jets_for
    >>> c = jets_for(("f1", "f2"), 2)
    >>> found = [Equation(find("f1"), find("f2"), factor).decide(c) for factor in ("w", "w^2")]
    >>> [(str(each.verdict), str(each.computed)) for each in found]
    [('PROVED', 'w'), ('REFUTED', 'not identical')]
    """

    left: Formula
    right: Formula
    factor: str = "1"
    find: Callable[[str], Formula] = find_anywhere

    @property
    def formulas(self) -> tuple[Formula, ...]:
        """Both sides, and the formulas in the factor."""
        return (self.left, self.right, *factor_formulas(self.factor, self.find))

    def compare(self, c: Evaluated) -> _Decision:
        """The comparison of the sides."""
        return decide_identity(self.left(c), self.right(c), factor_of_text(self.factor, c, self.find))

    def decide(self, c: Evaluated, holds: Verdict = PROVED) -> Finding:
        """The finding on an argument."""
        found, factor, general = self.compare(c), stated_factor(self.factor, c), holds is PROVED
        match found.outcome:
            case Outcome.EQUAL:
                return Finding(holds, factor, factor)
            case Outcome.NOTHING:
                return vacuous(factor=None if general else factor)
            case Outcome.NO_SIDE:
                return vacuous(Fact.NOWHERE) if general else vacuous(Fact.NO_SIDE, factor)
            case Outcome.NO_FACTOR if not general:
                return vacuous(Fact.NO_FACTOR, factor)
            case Outcome.NO_FACTOR:
                return Finding(REFUTED, Fact.DIVIDED_BY_ZERO, witness=Fact.FACTOR_DIVIDED_BY_ZERO)
            case Outcome.UNLIKE:
                sizes = (len(split(each(c))[0]) for each in (self.left, self.right))
                return Finding(REFUTED, Components(*sizes), witness=Fact.OTHER_NUMBER_OF_COMPONENTS)
        where = _where(found.difference, Sides.SIDES, found.component, found.divisors)
        return Finding(REFUTED, Fact.NOT_IDENTICAL, None if general else factor, where)

    def residues(self, c: Evaluated) -> list[JetFraction]:
        """The left side times the denominator of the factor, minus the right side times its numerator."""
        top: Any
        bottom: Any
        top, bottom = factor_of_text(self.factor, c, self.find)
        if bottom.is_zero:
            raise FormulaError("the factor is divided by zero")
        sides = (split(each(c))[0] for each in (self.left, self.right))
        return [p * bottom - q * top for p, q in zip(*sides, strict=True)]


@dataclass(frozen=True)
class Zero:
    """The formula vanishes."""

    formula: Formula

    def decide(self, c: Evaluated, holds: Verdict = PROVED) -> Finding:
        """Every component is zero."""
        parts, below = split(self.formula(c))
        for i, part in enumerate(parts):
            if not part.is_zero:
                divisors = () if below is None else (below,)
                return Finding(REFUTED, Fact.NOT_ZERO, witness=_where(part, Sides.ZERO, i, divisors))
        return Finding(holds, Fact.ZERO)

    def residues(self, c: Evaluated) -> list[JetFraction]:
        """The components of the value: the statement is that all of them vanish."""
        return list(split(self.formula(c))[0])


@dataclass(frozen=True)
class OneRuledSurface:
    """Two ruled surfaces are equal: their generators are parallel, and their directrices differ by a multiple of the
    generators.
    """

    left: Formula
    right: Formula

    def decide(self, c: Evaluated, holds: Verdict = PROVED) -> Finding:
        """``G × Ḡ = 0`` and ``(δ − δ̄) × G = 0``, where neither generator vanishes."""
        a, b = _ruled(self.left, c), _ruled(self.right, c)
        for surface, formula in ((a, self.left), (b, self.right)):
            if _vanish_together(split(surface.generator)[0]):
                return vacuous(NoGenerator(Name(formula.name) if holds is PROVED else None))
        if isinstance(split(a.generator)[0][0], JetFraction):
            return self._by_quotients(a, b, holds)
        for x in self.residues(c):
            if not x.is_zero:
                return Finding(REFUTED, Fact.TWO_SURFACES, witness=_where(x, Sides.SURFACES))
        return Finding(holds, OneSurface())

    def residues(self, c: Evaluated) -> list[JetFraction]:
        """The components of the vector products with a generator."""
        return [x for product in differences(self.left(c), self.right(c)) for x in split(product)[0]]

    @staticmethod
    def _by_quotients(a: Any, b: Any, holds: Verdict) -> Finding:
        """The same decision by the relation of the ruling parameters: vectors parallel to a nonzero vector are
        multiples of that vector, and a quotient is computed faster than a product.
        """
        offset = b.directrix - a.directrix
        scale, shift = find_factor(b.generator, a.generator), find_factor(offset, a.generator)
        if scale is None or shift is None:
            return Finding(REFUTED, Fact.TWO_SURFACES, witness=Fact.GENERATORS_APART)
        return Finding(holds, OneSurface(), Rulings(scale, None if offset.is_zero else shift))


@dataclass(frozen=True)
class DirectrixOf:
    """A plane curve is the curve ζ = 0 of a ruled surface of the same curve in space."""

    plane: Formula
    surface: Formula

    def decide(self, c: Evaluated, holds: Verdict = PROVED) -> Finding:
        """The plane curve and the directrix, compared as quotients."""
        assert isinstance(c, Curve)  # with its point
        plane, space = self.plane(c), _ruled(self.surface, embedded(c)).directrix
        if not getattr(plane, "is_vector", False):
            raise FormulaError(f"{self.plane.name!r} is not a curve", remedy="name one")
        below = [denominator for _, denominator in map(split, (plane, space)) if denominator is not None]
        if any(_vanishes(each) for each in below):
            return vacuous(Fact.NOT_HERE)
        if all(plane[i].is_zero and space[i].is_zero for i in range(2)) and space[2].is_zero:
            return vacuous()
        if plane[0] == space[0] and plane[1] == space[1] and space[2].is_zero:
            return Finding(holds, Fact.CURVE_OF_ZERO_ZETA)
        return Finding(REFUTED, Fact.OTHER_CURVE, witness=Fact.CURVES_DIFFER)

    def residues(self, c: Evaluated) -> list[JetFraction]:
        """The differences of the coordinates."""
        assert isinstance(c, Curve)
        plane, space = self.plane(c), self.surface(embedded(c)).directrix
        return [plane[0] - space[0], plane[1] - space[1], space[2]]


@dataclass(frozen=True)
class Changed:
    """A value on a changed curve equals the claimed one: `sides` gives both, component by component, `evidence` is
    reported if they are equal, and `where` gives the place of a difference.
    """

    sides: Callable[[Evaluated], tuple[Vector[Any], Vector[Any]]]
    evidence: Evidence
    where: Callable[[Any], Evidence]

    def decide(self, c: Evaluated, holds: Verdict = PROVED) -> Finding:
        """The finding on an argument of a reading with division."""
        found = decide_identity(*self.sides(c))
        if found.outcome is Outcome.NOTHING:
            return vacuous()
        if found.outcome is Outcome.EQUAL:
            return Finding(holds, self.evidence)
        return Finding(REFUTED, Fact.NOT_SO, witness=self.where(found.difference))


@dataclass(frozen=True)
class SquaresAddUp:
    """A formula, or its negative, is a factor times the sum of the squares of others (for a vector, its squared
    length).

    >>> from exactspline.papers import find
    >>> from exactspline.symbolic.factorization import jets_for
    >>> c = jets_for((find("f2"), find("D1")), 2)
    >>> [str(SquaresAddUp(find("f2"), (find(name),)).decide(c).verdict) for name in ("D1", "f2")]
    ['REFUTED', 'REFUTED']
    """

    formula: Formula
    squares: tuple[Formula, ...]
    factor: str = "1"
    sign: int = 1
    find: Callable[[str], Formula] = find_anywhere

    def decide(self, c: Evaluated, holds: Verdict = PROVED) -> Finding:
        """The finding on an argument; a different sum does not determine a sign."""
        value: Any = self.formula(c)
        total = value.constant(0)
        for square in self.squares:
            for x in split(square(c))[0]:
                total = total + x * x
        found = decide_identity(value * self.sign, total, factor_of_text(self.factor, c, self.find))
        if found.outcome is Outcome.NOTHING:
            return vacuous()
        if found.outcome is Outcome.EQUAL:
            return Finding(holds, SumOfSquares(len(self.squares)))
        return Finding(REFUTED, Fact.OTHER_SQUARES)


def decide_identity(left: Value, right: Value, factor: tuple[Value, Value] | None = None) -> _Decision:
    """Whether one value is another value times a factor, which is given as numerator and denominator (None: 1).

    >>> from exactspline.papers import find
    >>> from exactspline.symbolic.factorization import jets_for
    >>> c = jets_for(("f1", "f2"), 2)
    >>> f1, f2 = find("f1")(c), find("f2")(c)
    >>> [decide_identity(f1, f2, each).outcome.name for each in ((c.w, c.w / c.w), (c.w, f1 - f1), None)]
    ['EQUAL', 'NO_FACTOR', 'DIFFERENT']
    >>> decide_identity(f1 - f1, f2 - f2).outcome.name
    'NOTHING'
    """
    (ps, k), (qs, m) = _parts(left), _parts(right)
    parts = [(None, None)] * 2 if factor is None else [_parts(each) for each in factor]
    (top, above), (bottom, below) = parts
    if any(each is not None and _vanishes(each) for each in (k, m)):
        return _Decision(Outcome.NO_SIDE)
    nothing = top is not None and top[0].is_zero
    if all(x.is_zero for x in ps) and (nothing or all(x.is_zero for x in qs)):
        return _Decision(Outcome.NOTHING)
    if any(each is not None and _vanishes(each) for each in (above, below, bottom and bottom[0])):
        return _Decision(Outcome.NO_FACTOR)
    if len(ps) != len(qs):
        return _Decision(Outcome.UNLIKE)
    for i, (p, q) in enumerate(zip(ps, qs, strict=True)):
        ours = _product(p, m, bottom and bottom[0], above)
        theirs = _product(q, k, top and top[0], below)
        if not (difference := ours - theirs).is_zero:
            divisors = [each for each in (k, m, bottom and bottom[0], above) if each is not None]
            return _Decision(Outcome.DIFFERENT, i, difference, divisors)
    return _Decision(Outcome.EQUAL)


def _ruled(formula: Formula, c: Evaluated) -> RuledSurface[Any]:
    """The value of a formula that must be a ruled surface."""
    if isinstance(value := formula(c), RuledSurface):
        return value
    raise FormulaError(f"{formula.name!r} is not a ruled surface", remedy="name one")


def _where(difference: Any, of: Sides, component: int = 0, divisors: Sequence[Any] = ()) -> Evidence:
    """The place where two sides differ: a parameter for splines, the component in other evaluation modes."""
    if isinstance(difference, BSpline | TensorSpline):
        return Difference(of, *where_it_differs(difference, divisors))
    if of is Sides.SURFACES:
        return Fact.GENERATORS_APART
    return ComponentDiffers(component + 1, from_zero=of is Sides.ZERO)


def _parts(value: Any) -> tuple[Any, Any]:
    return split(value)


def _product(value: Any, *others: Any) -> Any:
    for other in others:
        value = value if other is None else value * other
    return value


def _vanishes(value: Any) -> bool:
    """Whether a denominator vanishes identically, a spline on a whole segment."""
    return value.is_zero or not all(getattr(value, "polynomials", ()))


def _vanish_together(components: list[Any]) -> bool:
    """Whether all components vanish identically, splines on one whole segment."""
    if not hasattr(components[0], "polynomials"):
        return all(x.is_zero for x in components)
    return any(not any(pieces) for pieces in zip(*[x.numerators for x in components], strict=True))
