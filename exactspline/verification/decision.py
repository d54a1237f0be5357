"""Whether two sides are equal: decided in one place, for values of any kind (differential polynomials, splines,
expressions of sympy). If both sides vanish, or a division by zero occurs, nothing is decided. Checks on a concrete
curve are exact, by multiplication and never by sampling.

Every kind of claim that states the equality of two values is decided here: identities and vanishing values, ruled
surfaces, directrices, values on changed curves, sums of squares.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import Enum, auto
from itertools import pairwise
from math import prod
from typing import Any, Protocol, cast

from flint import fmpz_poly

from exactspline.errors import FormulaError
from exactspline.language.arguments import Curve, Evaluated, Operands, embedded
from exactspline.language.formula import Formula
from exactspline.language.ruled import RuledSurface, Value, differences, split
from exactspline.language.surface_kind import Surface
from exactspline.language.vector import Vector
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval
from exactspline.papers import find as find_anywhere
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.polynomials.isolation import zero_on_segment
from exactspline.readings.jet import JetFraction
from exactspline.splines.bspline import BSpline
from exactspline.splines.inputs import checked_degree
from exactspline.splines.lowest_terms import common_factor
from exactspline.splines.tensor import TensorSpline
from exactspline.symbolic.factorization import find_factor
from exactspline.verification import phrases as say
from exactspline.verification.evaluation import place_between, segment
from exactspline.verification.evidence import At, Difference, Evidence, Fact, Place, Rulings, Sides, StatedFactor
from exactspline.verification.notation import WEIGHTS, factor_formulas, factor_of_text, factor_parts
from exactspline.verification.verdict import PROVED, REFUTED, Finding, vacuous
from exactspline.verification.vocabulary import Name, Verdict


def where_it_differs(
    difference: BSpline | TensorSpline, divisors: Sequence[BSpline | TensorSpline] = ()
) -> tuple[mpq, Place]:
    """The value of a nonzero spline divided by others at a parameter (a pair for splines in two parameters) at which
    none of them vanishes; no divisor vanishes on a whole segment.
    """
    if isinstance(difference, TensorSpline):
        return _not_zero_at_both(difference, cast("Sequence[TensorSpline]", divisors))
    t, value = _not_zero(difference, cast("Sequence[BSpline]", divisors))
    return value, At(t)


def _not_zero_at_both(f: TensorSpline, divisors: Sequence[TensorSpline]) -> tuple[mpq, Place]:
    n = sum(g.degree.t * len(g.meshes[0]) for g in (f, *divisors))
    # in every segment one line more than the number of lines of zeros that a patch can have
    inside = (c + (d - c) / mpq(j) for c, d in pairwise(f.meshes[1].breaks) for j in range(2, n + 3))
    lines = ((t, f.at_t(t), [g.at_t(t) for g in divisors]) for t in inside)
    t, line, below = next(x for x in lines if not (x[1].is_zero or any(g.vanishes_somewhere for g in x[2])))
    s, value = _not_zero(line, below)
    return value, say.at_both(s, t)


def _not_zero(f: BSpline, divisors: Sequence[BSpline]) -> tuple[mpq, mpq]:
    """A parameter at which a nonzero spline and its divisors do not vanish, and the quotient there."""
    n = f.degree + sum(g.degree for g in divisors) + 3
    return next(
        (t, value / prod(below))
        for p, (a, b) in zip(f.numerators, pairwise(f.breakpoints), strict=True)
        if p
        for t in (a + (b - a) * mpq(j, n) for j in range(1, n))
        if (value := f(t)) and all(below := [g(t) for g in divisors])
    )


def _stated_factor(factor: str, c: Evaluated | Operands) -> StatedFactor:
    """A factor as stated; for splines also whether the factor is 1, as powers of w are on polynomial curves.

    >>> from exactspline.interchange.examples import example
    >>> [str(_stated_factor("w^-3", example(name))) for name in ("circle", "parabola")]
    ['w⁻³', 'w⁻³ = 1 (polynomial: w = 1)']
    """
    powers = tuple((Name(name), exponent) for name, exponent in factor_parts(factor))
    known = [each for each in c.together() if isinstance(each, (Curve, Surface))]
    splines = all(isinstance(each.w, BSpline | TensorSpline) for each in known)
    polynomial = bool(known) and splines and all(each.polynomial for each in known)
    return StatedFactor(powers, polynomial and all(name in WEIGHTS for name, _ in powers))


def common_zeros(components: list[BSpline]) -> BSpline:
    """A spline that vanishes exactly where all the components do."""
    return components[0] if len(components) == 1 else common_factor(Vector(*components))


def extra_zero(a: BSpline, b: BSpline) -> Place | None:
    """A place where a vanishes and b does not vanish; None if there is none.

    >>> t = BSpline.identity(0, 1)
    >>> extra_zero(t * (t - 1), t), extra_zero(t, t * t)
    (<at the parameter 1 (from the left)>, None)
    """
    for i, (p, q) in enumerate(zip(a.numerators, b.numerators, strict=True)):
        if not p and not q:
            continue
        if not p:
            return segment(a, i)
        low, high = a.breakpoints[i : i + 2]
        rest, n = _without(p, q)
        zero = zero_on_segment(rest, n)
        if zero and not (zero[0] == zero[1] == 1 and q and q[b.degree] == 0):
            return place_between(Interval(low, high).part(zero))
        if p[a.degree] == 0 and q and q[b.degree] != 0:
            return At(high, from_left=True)
    return None


def _without(p: fmpz_poly, q: fmpz_poly) -> tuple[fmpz_poly, int]:
    """p without the factors it shares with q, and the degree of p (without roots at the right end, z = ∞)."""
    common = greatest_common_divisor([p, q])
    while common.degree() > 0:
        p = p // common
        common = greatest_common_divisor([p, q])
    return p, p.degree()


def table_1_splines(d1: int = 2, d2: int = 3) -> Operands:
    """Return splines as the operands of the paper's Table 1, with different degrees and knots and with positive
    denominators.
    """
    d1, d2 = checked_degree(d1), checked_degree(d2)
    state = 12345

    def number() -> int:
        nonlocal state
        state = (1103515245 * state + 12345) % 2**31
        return state // 65536 % 100 + 1

    def spline(d: int, inner: list[Any]) -> BSpline:
        knots = [0] * (d + 1) + inner + [3] * (d + 1)
        return BSpline(d, knots, [number() for _ in range(len(knots) - d - 1)])

    one, two = [spline(d1, [1, 2]) for _ in range(5)], [spline(d2, ["1/2", 2, 2]) for _ in range(5)]
    return Operands(p1=one[0], w1=one[1], v1=Vector(*one[2:]), p2=two[0], w2=two[1], v2=Vector(*two[2:]))


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
        found, factor, general = self.compare(c), _stated_factor(self.factor, c), holds is PROVED
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
                return Finding(REFUTED, say.components(*sizes), witness=Fact.OTHER_NUMBER_OF_COMPONENTS)
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
                return vacuous(say.no_generator(Name(formula.name)) if holds is PROVED else Fact.NO_GENERATOR)
        if isinstance(split(a.generator)[0][0], JetFraction):
            return self._by_quotients(a, b, holds)
        for x in self.residues(c):
            if not x.is_zero:
                return Finding(REFUTED, Fact.TWO_SURFACES, witness=_where(x, Sides.SURFACES))
        return Finding(holds, Fact.ONE_SURFACE)

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
        return Finding(holds, Fact.ONE_SURFACE, Rulings(scale, None if offset.is_zero else shift))


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
            return Finding(holds, say.sum_of_squares(len(self.squares)))
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
    return say.component_is_not_zero(component + 1) if of is Sides.ZERO else say.component_differs(component + 1)


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
