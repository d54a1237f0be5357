"""Claims about the type of a formula (a polynomial, a quotient of polynomials, or neither) and about its arguments."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import field, replace
from typing import Any, ClassVar

from exactspline.errors import ClaimError, ExactSplineError, VanishingDivisorError
from exactspline.language.adjoined_root import Adjoined
from exactspline.language.arguments import Evaluated, Operands
from exactspline.language.formula import Formula
from exactspline.language.kinds import FRAMED, FRAMED_PLANE, FRAMED_SPACE, CurveKind, Kind, kind_of, with_constants
from exactspline.language.ruled import joined, split
from exactspline.polynomials.cost import at_its_cost
from exactspline.polynomials.factors import factorize_square_free
from exactspline.readings.jet import JetFraction
from exactspline.splines.nurbs import Nurbs
from exactspline.symbolic.factorization import jets_for
from exactspline.verification import phrases as say
from exactspline.verification.claim import Claim, any_formula, claim_kind, formula_name, one_of, read
from exactspline.verification.decision import Equation
from exactspline.verification.evaluation import Evaluation, on_segments
from exactspline.verification.evidence import Evidence, Fact
from exactspline.verification.generic_proof import SHOWN
from exactspline.verification.paper_curves import curve_names
from exactspline.verification.verdict import PROVED, REFUTED, UNDECIDED, VERIFIED, Finding, inapplicable, left, vacuous
from exactspline.verification.vocabulary import ArgumentKind, Extent, Name, ValueType


@claim_kind
class TypeClaim(Claim):
    """The value of ``formula`` is of the type ``claimed``: ``"polynomial"`` on every curve; ``"rational"`` on every
    curve, and not a polynomial on all of them; ``"not rational"`` in general, that is on the generic curve.

    A formula whose roots cancel is a quotient of polynomials on every curve. That its type is not more special is shown
    by a witness: on one curve the denominator in lowest terms is not constant, or the coefficient of a root does not
    vanish, and the square of the root is not a square of a rational function (an irreducible factor occurs an odd
    number of times). A value that is a polynomial, or rational, on the generic curve of a degree is so on every curve
    of that degree: one witness decides.
    """

    kind: ClassVar[str] = "type"
    value: ClassVar[str] = "$claimed"
    notation: ClassVar[str] = r"$formula \;\text{is $claimed}"
    tries_all: ClassVar[bool] = True
    of_frames: ClassVar[bool] = True

    formula: str = field(metadata=read(formula_name))
    claimed: ValueType = field(metadata=read(one_of(ValueType)))

    def validate(self) -> None:
        """Reject arguments that cannot be obtained from a curve."""
        kind = kind_of(self.curve)
        if self.curve != ArgumentKind.TABLE and not kind.made_of_a_curve and not kind.adjoins_roots:
            raise ClaimError(f"types of {str(self.curve)!r} are not decided", where="curve", remedy="name a curve")

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """The most special type that holds on every curve, and a witness that it is not more special than claimed."""
        values = self._on_all_curves(dimension, polynomial)
        if all(x.is_zero for x in values):
            return vacuous(Fact.ZERO)
        rooted = any(not x.is_zero for value in values for x in _coefficients(value)[1:])
        always = ValueType.NOT_RATIONAL if rooted else ValueType.RATIONAL
        if not rooted and not any(_is_quotient(_coefficients(value)[0]) for value in values):
            always = ValueType.POLYNOMIAL
        if always == ValueType.POLYNOMIAL:
            return self._found(always, Fact.DENOMINATOR_DIVIDES_OUT)
        for name, type_there in self._types_of_examples(dimension, polynomial):
            if type_there == always:
                why = None if rooted else Fact.MADE_BY_ARITHMETIC
                return self._found(always, say.type_on_example(type_there, Name(name), why))
        if self.claimed == ValueType.NOT_RATIONAL and not rooted:
            return self._found(always, Fact.MADE_BY_ARITHMETIC)
        return Finding(UNDECIDED, witness=Fact.NO_CURVE_OF_THIS_TYPE)

    def _found(self, found: ValueType, why: Evidence) -> Finding:
        return Finding(PROVED if found == self.claimed else REFUTED, say.of_type(found), witness=why)

    def _on_all_curves(self, dimension: int, polynomial: bool) -> list[Any]:
        """The components on the indeterminate argument."""
        formula = self.find(self.formula)
        return split(joined(formula(jets_for((formula,), dimension, polynomial=polynomial))))[0]

    def _types_of_examples(self, dimension: int, polynomial: bool) -> Iterator[tuple[str, ValueType | None]]:
        """The type on the example curves, the one named as witness first."""
        if self.curve == ArgumentKind.TABLE:
            values = map(on_cubics, self._on_all_curves(dimension, polynomial))
            yield "", ValueType.RATIONAL if any(map(_is_quotient, values)) else ValueType.POLYNOMIAL
            return
        first = (self.witness, SHOWN.get((dimension, polynomial), ""))
        for name in sorted(curve_names(self.source_paper), key=lambda name: (name != first[0], name != first[1])):
            curve = self.curve_named(name)
            if curve.dimension == dimension and curve.polynomial == polynomial:
                try:
                    yield name, self.type_on(curve)
                except ExactSplineError:  # the formula does not exist there
                    continue

    def type_on(self, curve: Nurbs) -> ValueType | None:
        """The type on one curve, for all values of the free operands; None if it is undecided because of dependent
        roots.

        Raises `VanishingDivisorError` if the formula does not exist.
        """
        formula, type_here = self.find(self.formula), ValueType.POLYNOMIAL
        for segment in on_segments(kind_of(self.curve), curve, self.highest_derivative(curve.dimension)):
            components = split(joined(formula(segment.argument)))[0]
            here = [_type_of(x) for x in components]
            if ValueType.NOT_RATIONAL in here:
                return ValueType.NOT_RATIONAL
            if None in here:
                return None
            type_here = ValueType.RATIONAL if ValueType.RATIONAL in here else type_here
        return type_here

    def beside(self, own: Evaluation) -> None:
        """No operands in addition: all free operands are indeterminate."""

    def examine(self, argument: Evaluated, own: Evaluation) -> Finding:
        """The finding on one curve. A type that is more special than that of the generic curve decides nothing."""
        if isinstance(own.curve, Operands):
            return left(Fact.NO_COMMON_KNOTS)
        try:
            type_here = self.type_on(own.curve)
        except VanishingDivisorError:
            return vacuous(Fact.NO_VALUE)
        if type_here is None:
            return Finding(UNDECIDED, witness=Fact.ROOT_IS_RATIONAL)
        if type_here == self.claimed:
            return Finding(VERIFIED, say.of_type(type_here))
        order = list(ValueType)
        if self.on == Extent.ALL and order.index(type_here) < order.index(self.claimed):
            return inapplicable(say.more_special_here(type_here), say.of_type(type_here))
        return Finding(REFUTED, say.of_type(type_here), witness=say.type_here(type_here))


def _coefficients(value: Any) -> list[Any]:
    """The coefficients of 1 and of the adjoined roots: a and b for ``a + b σ``; with a second root ρ, the coefficients
    of 1, σ, ρ and σρ.
    """
    if not isinstance(value, Adjoined):
        return [value]
    return [*_coefficients(value.plain), *_coefficients(value.rooted)]


def _type_of(value: Any) -> ValueType | None:
    """The type of a function of one parameter; None if the roots are not independent, or one of them is rational."""
    parts = _coefficients(value)
    if any(not x.is_zero for x in parts[1:]):
        return ValueType.NOT_RATIONAL if _independent(value) else None
    return ValueType.RATIONAL if _is_quotient(parts[0]) else ValueType.POLYNOMIAL


def _independent(value: Adjoined) -> bool:
    """Whether the squares of the roots, and their product, are not squares: then 1 and the roots are independent over
    the rational functions.
    """
    if not isinstance(value.plain, Adjoined):
        return not _is_square(value.square)
    outer: Any = value.square
    rho, sigma = _coefficients(outer)[0], value.plain.square
    return not any(_is_square(x) for x in (rho, sigma, rho * sigma))


def _is_square(value: Any) -> bool:
    """Whether a quotient of polynomials is a square up to a constant: no factor occurs an odd number of times."""
    powers = (power for p in (value.top, value.bottom) for power in factorize_square_free(p).powers)
    return all(exponent % 2 == 0 or base.is_constant() for base, exponent in powers)


def on_cubics(value: JetFraction) -> JetFraction:
    """A quotient of differential polynomials in functions of one parameter where these are cubic polynomials, without
    common zeros: the first indeterminate of the ring represents the parameter.
    """
    ring = value.ring
    s, names = ring.gens[0], list(dict.fromkeys(name for name, _ in ring.variables))

    def image(name: str, order: int) -> Any:
        i = names.index(name) + 1
        powers = [i * i, i + 1, 0, 1]
        for _ in range(order):
            powers = [k * c for k, c in enumerate(powers)][1:]
        return sum((c * s**k for k, c in enumerate(powers)), ring.context.constant(0))

    places = [image(name, sum(order)) for name, order in ring.variables]
    one = ring.context.constant(1)
    top, bottom = (JetFraction(ring, p.compose(*places, ctx=ring.context), one) for p in (value.top, value.bottom))
    return top / bottom


def _is_quotient(value: JetFraction) -> bool:
    """Whether a denominator in lowest terms involves more than constants."""
    used = [value.ring.variables[i][0] for i, n in enumerate(value.bottom.degrees()) if int(n)]
    return any(value.ring.symbols[name].parameters for name in used)


@claim_kind
class Existence(Claim):
    """The function defined by the formula ``definition`` is not rational: refuted where ``formula``, a quotient of
    polynomials in the curve, equals it for all curves. The definition may contain the unit vectors of a frame, which
    are roots.
    """

    kind: ClassVar[str] = "existence"
    value: ClassVar[str] = "not rational"
    notation: ClassVar[str] = r"$definition \;\text{is not rational}"
    evaluated_first: ClassVar[bool] = False  # splines have no roots

    formula: Name = field(metadata=read(formula_name))
    definition: Name = field(metadata=read(formula_name))

    def kind_of_field(self, name: str) -> Kind:
        """A definition may have zeros."""
        own = super().kind_of_field(name)
        if name != "definition" or type(own) is not CurveKind:
            return own
        framed = FRAMED if len(own.dimensions) > 1 else FRAMED_PLANE if own.dimensions == (2,) else FRAMED_SPACE
        return with_constants(framed, own.constants) or own

    def validate(self) -> None:
        """Reject a formula given as its own definition, which would always be rational."""
        if self.formula == self.definition:
            problem = f"{self.formula!r} is given as its own definition"
            raise ClaimError(problem, where="definition", remedy="name the formula that defines it")

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """The finding: a nonzero rational form that equals the definition refutes the claim."""
        equation = Equation(self.find(self.formula), self.find(self.definition))
        c = jets_for(equation.formulas, dimension, polynomial=polynomial)
        if all(x.is_zero for x in split(equation.left(c))[0]):
            return vacuous()
        if equation.decide(c).verdict == PROVED:
            return Finding(REFUTED, Fact.RATIONAL, witness=say.rational_form(self.formula, self.definition))
        return Finding(UNDECIDED, witness=say.not_its_definition(self.formula, self.definition))

    @property
    def compared(self) -> list[Formula]:
        """Both formulas, each once."""
        return [self.find(self.formula), self.find(self.definition)]

    def examine(self, argument: Evaluated, own: Evaluation) -> Finding:
        """The rational form on this curve."""
        general = _decided(self, own.curve.dimension, own.curve.polynomial)
        if general.verdict != REFUTED:
            return general
        value = self.find(self.formula)(argument)
        denominator = split(value)[1]
        if denominator is not None and denominator.vanishes_somewhere:
            return vacuous(say.undefined(self.formula))
        return replace(general, computed=say.rational_of_degree(int(value.degree)))


@at_its_cost
def _decided(claim: Existence, dimension: int, polynomial: bool) -> Finding:
    return claim.decide(dimension, polynomial)


@claim_kind
class Applies(Claim):
    """The equation of ``formula``, which a source cites for such arguments, applies to them and can be evaluated. A
    determinant of two vectors, for example, requires vectors in the plane.
    """

    kind: ClassVar[str] = "applies"
    value: ClassVar[str] = "it applies"
    notation: ClassVar[str] = r"$formula \;\text{exists for arguments of the kind $curve}"
    of_frames: ClassVar[bool] = True
    tries_all: ClassVar[bool] = True

    formula: str = field(metadata=read(any_formula))

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """The finding, by the operands that the formula needs and the dimension in which its products are defined. A
        formula that divides by 0 for all arguments is not decided.
        """
        formula, asked = self.find(self.formula), kind_of(self.curve)
        own = formula.kind
        if asked.takes(own, dimension):
            try:
                formula(jets_for((formula,), dimension, polynomial=polynomial))
            except VanishingDivisorError:
                return vacuous(Fact.NO_VALUE)
            return Finding(PROVED, Fact.APPLIES)
        witness = say.of_another_kind(Name(self.formula), Name(own.name), Name(asked.name))
        return Finding(REFUTED, say.of_kind(Name(own.name)), witness=witness)

    def examine(self, argument: Evaluated, own: Evaluation) -> Finding:
        """The finding, which is the same for every curve."""
        found = self.decide(own.curve.dimension, own.curve.polynomial)
        return replace(found, verdict=VERIFIED) if found.verdict == PROVED else found
