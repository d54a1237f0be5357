"""Automatic reduction: a formula is evaluated naively over the indeterminate curve, and its numerator and denominator
are factored. The result is an identity of differential polynomials, ``numerator = constant · factors · core``. Products
are kept as products while the formula is evaluated, and every factorization is verified by expanding it. A factor
proportional to a named formula is replaced by this formula, sign included; a factor without a name has coprime integer
coefficients, the first positive. The constant therefore carries the sign.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from contextlib import nullcontext
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

from flint import fmpq_mpoly

from exactspline.errors import FormulaError, ReductionError, ShapeError
from exactspline.hooks import Displayed
from exactspline.language.arguments import Curve, Pair, T
from exactspline.language.formula import Formula, expect_formula
from exactspline.language.kinds import CURVE, TABLE, Kind
from exactspline.language.operand import Operand, Parameter
from exactspline.language.rational import Rational
from exactspline.language.ruled import RuledSurface
from exactspline.language.vector import Vector
from exactspline.numbers.exact import from_flint, mpq
from exactspline.numbers.once import cached_property
from exactspline.one_line import OneLine, one_line
from exactspline.papers import find, owner
from exactspline.polynomials.factors import Factorization, bounded_product, greatest_common_divisor
from exactspline.readings.degree import Degree, DegreeReading
from exactspline.readings.differential_order import order_of
from exactspline.readings.factored_jet import FactoredJet, FactoredJetReading, Powers, divided_out, multiplied
from exactspline.readings.jet import Jet, JetRing
from exactspline.symbolic.assumptions import Assumption, zero_free
from exactspline.symbolic.covariants import TrueDegree, degree_of_product, generic_degree, true_degree
from exactspline.symbolic.factorization import Factor, Named, factored, name_of_vector, named_by
from exactspline.symbolic.substitution import Substitution

#: The role of a part of a formula: its value matters or, for a generator (whose ruling parameter is free), only its
#: direction.
VALUE, DIRECTRIX, GENERATOR = "value", "directrix", "generator"


@dataclass(frozen=True, repr=False)
class Power(OneLine):
    """An irreducible differential polynomial that divides the numerator `above` times and the denominator `below`
    times.
    """

    name: str
    jet: Jet
    above: int
    below: int

    @cached_property
    def assumption(self) -> Assumption | None:
        """The assumption by which the polynomial has no zero."""
        return zero_free(self.jet)

    @property
    def meaning(self) -> str:
        """The reason why the polynomial has no zero, or the statement that it may have zeros."""
        return self.assumption.meaning if self.assumption else "may have zeros"

    @property
    def has_roots(self) -> bool:
        """Whether the polynomial may vanish somewhere on a regular curve without points of zero curvature."""
        return self.assumption is None


@dataclass(frozen=True, repr=False)
class Part(OneLine):
    """One part of a formula: ``constant · Π power^above · core / Π power^below``. The core is a vector without common
    factor, 1 for a scalar.
    """

    role: str
    naive: Degree
    constant: mpq
    powers: tuple[Power, ...]
    core: tuple[Jet, ...]
    core_name: str
    is_scalar: bool
    is_quotient: bool
    #: The parameter in which degrees are counted.
    parameter: Parameter

    @property
    def cancelled(self) -> Factor:
        """The factors removed from the numerator to obtain the reduced form: those without zeros, and for a generator
        all factors.
        """
        gone = [p for p in self.powers if not self._kept(p) and (not p.has_roots or self.role == GENERATOR)]
        return self._factor([(p, p.above - p.below) for p in gone], self.constant)

    @property
    def rooted(self) -> Factor:
        """The factors that may have zeros, which are kept. For a generator, these factors are listed although they are
        removed.
        """
        return self._factor([(p, p.above - p.below) for p in self.powers if p.has_roots and p.above > p.below], mpq(1))

    @property
    def poles(self) -> Factor:
        """The remaining factors of the denominator that may have zeros; at these zeros the value is undefined."""
        return self._factor([(p, p.below - p.above) for p in self.powers if p.has_roots and p.below > p.above], mpq(1))

    @property
    def shared(self) -> Factor:
        """The common factor of numerator and denominator."""
        return self._factor([(p, min(p.above, p.below)) for p in self.powers], mpq(1))

    @property
    def kept(self) -> tuple[tuple[Jet, int], ...]:
        """The factors of the reduced form other than its core, with exponents."""
        return tuple((p.jet, p.above - p.below) for p in self.powers if self._kept(p))

    def _kept(self, p: Power) -> bool:
        return p.has_roots and p.above > p.below and self.role != GENERATOR

    def _factor(self, powers: Sequence[tuple[Power, int]], constant: mpq) -> Factor:
        return Factor(
            constant, Factorization((Named(p.name, p.jet.polynomial), e) for p, e in powers), self.core[0].ring
        )

    @cached_property
    def reduced(self) -> tuple[Jet, ...]:
        """The reduced form of zero-set problems and directions: the numerator without factors that have no zeros."""
        ring = self.core[0].ring
        kept = Jet(ring, multiplied(ring, Powers((jet.polynomial, e) for jet, e in self.kept)))
        return tuple(kept * c for c in self.core)

    @cached_property
    def _substitutions(self) -> tuple[Substitution, ...]:
        return tuple(map(Substitution, self.reduced))

    @cached_property
    def lowest(self) -> tuple[tuple[Jet, ...], Jet]:
        """Numerator and denominator in lowest terms; the value is unchanged."""
        top = self._product((p, p.above - p.below) for p in self.powers).scaled(self.constant)
        return tuple(top * c for c in self.core), self._product((p, p.below - p.above) for p in self.powers)

    def _product(self, powers: Any) -> Jet:
        ring = self.core[0].ring
        return Jet(ring, multiplied(ring, Powers((p.jet.polynomial, e) for p, e in powers if e > 0)))

    @cached_property
    def true(self) -> TrueDegree | None:
        """(k, m, j) of the reduced form, which are additive for products; None if it is zero or not homogeneous."""
        try:
            counted = [(true_degree(jet, self.parameter), e) for jet, e in self.kept]
            return degree_of_product([*counted, (true_degree(self.core, self.parameter), 1)])
        except FormulaError:
            return None

    @cached_property
    def generic(self) -> Degree:
        """The true degree of the reduced form on the generic curve, by the degree theorem."""
        return self._generic(self.kept)

    def _generic(self, powers: Iterable[tuple[Jet, int]]) -> Degree:
        return Degree.number(-1) if self.is_zero else self._times(self._of_core, powers)

    def _times(self, total: Degree, powers: Iterable[tuple[Jet, int]]) -> Degree:
        """The degree of a product with powers of factors, each degree computed once."""
        for jet, e in powers:
            if e > 0:
                if id(jet) not in self._of_factors:
                    self._of_factors[id(jet)] = generic_degree([jet], self.parameter)
                for _ in range(e):
                    total = total * self._of_factors[id(jet)]
        return total

    @cached_property
    def _of_factors(self) -> dict[int, Degree]:
        """Known degrees of factors by id; the factors belong to this part and live as long."""
        return {}

    @cached_property
    def _of_core(self) -> Degree:
        return generic_degree([c for c in self.core if not c.is_zero], self.parameter)

    @cached_property
    def generic_lowest(self) -> Degree:
        """The true degree of the value in lowest terms on the generic curve: the larger of the degrees of numerator and
        denominator.
        """
        numerator = self._generic((p.jet, p.above - p.below) for p in self.powers)
        below = [(p.jet, p.below - p.above) for p in self.powers if p.below > p.above]
        return numerator if not below or self.is_zero else numerator.max(self._times(Degree.number(0), below))

    @property
    def is_zero(self) -> bool:
        """Whether the value vanishes on every curve."""
        return all(c.is_zero for c in self.core)

    def data(self) -> dict[str, object]:
        """The part as data for JSON."""
        true = self.true
        return {
            "part": self.role,
            "naive": str(self.naive),
            "cancelled": str(self.cancelled),
            "reduced": self.text,
            "poles": "" if self.poles.is_one else str(self.poles),
            "shared": "" if self.shared.is_one else str(self.shared),
            "meaning": {p.name: p.meaning for p in self.powers},
            "k": true and true.k,
            "m": true and true.m,
            "j": true and true.j,
            "nominal": str(true.nominal) if true else "",
            "true": str(self.generic),
            "lower": {str(d): n for d, n in true.lower} if true else {},
            "lowest terms": str(self.generic_lowest) if self.is_quotient else "",
        }

    @property
    def text(self) -> str:
        """The reduced form in terms of named factors."""
        if self.is_zero:
            return "0"
        names = [str(self.rooted)] if self.role != GENERATOR and self.rooted.powers else []
        return "·".join([*names, *([] if self.is_scalar else [self.core_name])]) or "1"

    def on(self, curve: Curve[T] | Pair[T]) -> T | Vector[T]:
        """The reduced form on a curve, in any reading; splines are returned at the true degree guaranteed by the degree
        theorem, by exact division.
        """
        values: list[Any] = [each.on(curve) for each in self._substitutions]
        in_one_parameter = hasattr(values[0], "reduce_degree") and isinstance(values[0].degree, int)
        surplus = self.true.surplus if self.true and in_one_parameter else 0
        lowered = [
            value.reduce_degree(min(surplus, value.degree)) if surplus > 0 and value.degree > 0 else value
            for value in values
        ]
        return lowered[0] if self.is_scalar else Vector(*lowered)


@dataclass(frozen=True)
class Reduction:
    """The result of `reduce`: one part, or the directrix and generator of a ruled surface."""

    name: str
    dimension: int
    polynomial: bool
    parts: tuple[Part, ...]
    kind: Kind

    @one_line
    def __repr__(self) -> str:
        return f"<Reduction of {self.name} in R{self.dimension}>"

    @property
    def joined(self) -> list[Jet]:
        """The components of all parts over their least common denominator, followed by this denominator."""
        denominator = self.parts[0].lowest[1]
        for part in self.parts[1:]:
            other = part.lowest[1].polynomial
            common = greatest_common_divisor([denominator.polynomial, other])
            denominator = Jet(denominator.ring, bounded_product(denominator.polynomial, other / common))
        raised = []
        for part in self.parts:
            top, bottom = part.lowest
            lift = Jet(denominator.ring, denominator.polynomial / bottom.polynomial)
            raised += [jet * lift for jet in top]
        return [*raised, denominator]

    @property
    def main(self) -> Part:
        """The only part, or the generator."""
        return self.parts[-1]


def reduce(
    formula: Formula | Callable[..., object],
    *,
    dimension: int | None = None,
    polynomial: bool = False,
    parameter: Parameter | None = None,
) -> Reduction:
    """The reduction of a formula, or of any function that takes a curve and returns a scalar, a vector, a quotient or a
    ruled surface.

    `dimension` is the dimension of the curve, `polynomial` restricts it to curves with w = 1, `parameter` is the
    parameter with respect to which degrees are counted, by default the first. Without a dimension, a formula is
    evaluated in the dimension of its kind, and a plain function is tried in the plane and then in space.

    >>> from exactspline.papers import find, owner
    >>> part = reduce(find("curvature_squared_derivative")).main
    >>> str(part.naive), str(part.cancelled), part.text
    ('48d', 'w⁵·(‖D1‖²)⁻⁴', '[X X′ X″ X‴]·f2')
    >>> part.true.j, part.generic
    (0, 11d − 18)

    Raises `FormulaError` if the function returns anything else, `ShapeError` if it does not fit the dimension.
    """
    known = _dimensions(formula)
    chosen = [dimension] if dimension else known
    source = owner(formula) if isinstance(formula, Formula) else None
    with nullcontext() if source is None or source.default else named_by(source):
        for n in chosen[:-1]:
            try:
                return _reduced(formula, n, polynomial, parameter)
            except ShapeError:
                continue
        return _reduced(formula, chosen[-1], polynomial, parameter)


@cache
def reduction(name: str, dimension: int, polynomial: bool = False, parameter: Parameter | None = None) -> Reduction:
    """The reduction of a formula of the library, cached."""
    return reduce(find(name), dimension=dimension, polynomial=polynomial, parameter=parameter)


def _dimensions(formula: Any) -> list[int]:
    kind = _kind(formula)
    if kind is TABLE:
        raise FormulaError(f"{_name_of_function(formula)} is a row of Table 1", remedy="give a formula of a curve")
    if kind.adjoins_roots:
        raise FormulaError(
            f"{_name_of_function(formula)} contains square roots", remedy="give a rational formula, such as its square"
        )
    return list(kind.dimensions)


def _kind(formula: Any) -> Kind:
    """The kind of argument of a formula; a curve for any other function."""
    if isinstance(formula, Displayed | type) or not callable(formula):  # curves are callable as well
        expect_formula(formula)
    return formula.kind if isinstance(formula, Formula) else CURVE


def _name_of_function(formula: object) -> str:
    """The name of a formula or a function."""
    return formula.name if isinstance(formula, Formula) else str(getattr(formula, "__name__", formula))


def _reduced(formula: Any, dimension: int, polynomial: bool, parameter: Parameter | None) -> Reduction:
    name = _name_of_function(formula)
    kind = _kind(formula)
    counted = parameter or kind.parameters(dimension)[0]
    degrees = _naive(formula, kind, dimension, polynomial, counted)
    value = formula(FactoredJetReading(order_of(formula, dimension)).argument(kind, dimension, polynomial=polynomial))
    parts = [
        _part(role, naive, part, counted) for naive, (role, part) in zip(degrees, _parts(value, name), strict=True)
    ]
    return Reduction(name, dimension, polynomial, tuple(parts), kind)


def _naive(formula: Any, kind: Kind, dimension: int, polynomial: bool, counted: Parameter) -> list[Degree]:
    """The degrees of the parts before reduction, by the rules of Table 1."""
    argument = DegreeReading(parameter=counted).argument(kind, dimension, polynomial=polynomial)
    return [part.degree for _, part in _parts(formula(argument), _name_of_function(formula))]


def counted_in(reduction: Reduction, formula: Formula, parameter: Parameter) -> Reduction:
    """The same reduction with degrees counted in another parameter.

    >>> f = find("surfaces:L")
    >>> [str(counted_in(reduce(f), f, parameter).main.generic) for parameter in (Parameter.U, Parameter.V)]
    ['4d_u − 6', '4d_v − 2']
    """
    degrees = _naive(formula, reduction.kind, reduction.dimension, reduction.polynomial, parameter)
    parts = (replace(part, naive=n, parameter=parameter) for part, n in zip(reduction.parts, degrees, strict=True))
    return replace(reduction, parts=tuple(parts))


def _parts(value: Any, name: str) -> list[tuple[str, Any]]:
    if isinstance(value, RuledSurface):
        return [(DIRECTRIX, value.directrix), (GENERATOR, value.generator)]
    if not isinstance(value, (Operand, Vector)):
        problem = f"{name} returns {type(value).__name__}"
        raise FormulaError(problem, remedy="a formula returns a scalar, a vector, a quotient or a ruled surface")
    return [(VALUE, value)]


def _part(role: str, naive: Degree, value: Any, parameter: Parameter) -> Part:
    numerator, denominator = _over_one_denominator(value)
    ring = numerator[0].ring
    if denominator is not None and denominator.is_zero:
        raise FormulaError("a denominator vanishes on every curve", remedy="check the formula")
    below = _irreducible(ring, denominator.powers if denominator is not None else Powers(), mpq(1))
    common, cores = _content(ring, numerator, [base.polynomial for base, _ in below.powers])
    above = _irreducible(ring, common, mpq(1))
    is_scalar = not getattr(value, "is_vector", False)
    core, core_name, unit = _named(ring, cores, is_scalar)
    constant = unit * above.constant / below.constant / (from_flint(denominator.unit) if denominator is not None else 1)
    powers = _powers(ring, above, below)
    return Part(role, naive, constant, powers, core, core_name, is_scalar, denominator is not None, parameter)


def _irreducible(ring: JetRing, powers: Powers, constant: mpq) -> Factor:
    """A product as a product of irreducible factors; each factorization is verified by expanding it."""
    factors = Factorization[Named]()
    for base, e in powers:
        factor = factored(ring, base, ring.context.constant(1))
        if factor.fraction()[0] != base * int(factor.constant.denominator):
            raise ReductionError("the product of the factors is not what was factored", remedy="report this")
        constant *= factor.constant**e
        factors = factors * factor.powers**e
    return Factor(constant, factors, ring)


def _named(ring: JetRing, cores: list[fmpq_mpoly], is_scalar: bool) -> tuple[tuple[Jet, ...], str, mpq]:
    """The normalized core, its name, and the constant by which it was divided."""
    core = tuple(Jet(ring, c) for c in cores)
    if not any(cores):
        return core, "", mpq(1)
    name, unit = ("", from_flint(cores[0].leading_coefficient())) if is_scalar else name_of_vector(core)
    return tuple(jet.scaled(1 / unit) for jet in core), name, unit


def _powers(ring: JetRing, above: Factor, below: Factor) -> tuple[Power, ...]:
    rows: list[Power] = [Power(name, Jet(ring, p), e, 0) for (name, p), e in above.powers]
    for (name, p), e in below.powers:
        i = next((i for i, row in enumerate(rows) if row.jet.polynomial == p), None)
        if i is None:
            rows.append(Power(name, Jet(ring, p), 0, e))
        else:
            rows[i] = Power(name, rows[i].jet, rows[i].above, e)
    return tuple(sorted(rows, key=lambda row: (row.name != "w", row.name)))


def _over_one_denominator(value: Any) -> tuple[list[FactoredJet], FactoredJet | None]:
    """The components of the numerator, and the denominator; for a vector of quotients a common denominator."""
    if isinstance(value, Rational):
        numerator: Any = value.numerator
        return (list(numerator) if isinstance(numerator, Vector) else [numerator]), value.denominator
    if not isinstance(value, Vector):
        return [value], None
    if not any(isinstance(c, Rational) for c in value):
        return list(value), None
    one = next(c for c in value if isinstance(c, Rational)).denominator.constant(1)
    components = [c if isinstance(c, Rational) else Rational(c, one) for c in value]
    numerators, total = [], one
    for i, c in enumerate(components):
        product: Any = c.numerator
        for j, other in enumerate(components):
            product = product * other.denominator if i != j else product
        numerators.append(product)
        total = total * c.denominator
    return numerators, total


def _content(
    ring: JetRing, components: list[FactoredJet], divisors: list[fmpq_mpoly]
) -> tuple[Powers, list[fmpq_mpoly]]:
    """The greatest common divisor of the components and their quotients by it; known common factors are divided out
    first, to avoid large computations.
    """
    present = [c for c in components if not c.is_zero]
    if not present:
        return Powers(), [ring.context.constant(0) for _ in components]
    common = present[0].powers
    for c in present[1:]:
        common = common.shared(c.powers)
    rests = [multiplied(ring, (Powers() if c.is_zero else c.powers.without(common))) * c.unit for c in components]
    if len(components) == 1:
        return common, rests
    for q in sorted(divisors, key=len, reverse=True):
        e, rests = divided_out(rests, q)
        common = common * Powers([(q, e)])
    content = greatest_common_divisor(rests)
    content = content / content.leading_coefficient()
    cores = [p / content for p in rests]
    if any(core * content != p for core, p in zip(cores, rests, strict=True)):
        raise ReductionError("the product of the factors is not what was factored", remedy="report this")
    return (common * Powers([(content, 1)]) if content.total_degree() > 0 else common), cores
