"""Claims about zeros and signs: formulas have one zero set, a value has a sign, two formulas are squares on the same
curves.

For all curves, zeros are those of the irreducible factors of a value, or of its numerator as written, that may have
zeros under the assumptions. On every curve the order of a zero is the sum of the orders of these factors. The
components of a vector are real, so that the vector vanishes at the zeros of the sum of their squares, whose orders are
doubled. So do multiples of the roots of a frame: only squares are factored, and exponents are counted twice.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import field, replace
from functools import partial, reduce
from itertools import pairwise, product
from math import gcd
from operator import methodcaller, mul
from typing import Any, ClassVar, cast

from flint import fmpq_mpoly

from exactspline.errors import ClaimError, ExactSplineError, FormulaError, ReachError
from exactspline.language.adjoined_root import Adjoined
from exactspline.language.arguments import PARAMETERS, Evaluated
from exactspline.language.formula import Formula
from exactspline.language.kinds import FramedKind, kind_of
from exactspline.language.rational import Rational
from exactspline.language.ruled import Value, split
from exactspline.numbers.exact import mpq
from exactspline.polynomials.bernstein import is_square_class
from exactspline.polynomials.common_arcs import rational_between
from exactspline.polynomials.factors import Factorization, factorize
from exactspline.polynomials.isolation import is_nonnegative, isolate
from exactspline.polynomials.zero_places import Place as PlaceOfZero
from exactspline.polynomials.zero_places import at
from exactspline.readings.jet import Jet, JetFraction, JetRing, terms_of
from exactspline.readings.printing import Operation
from exactspline.readings.tree import Node, nodes, trace
from exactspline.splines.bspline import BSpline
from exactspline.splines.lowest_terms import SplineValue, in_lowest_terms
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface
from exactspline.symbolic.assumptions import Assumption, zero_free
from exactspline.symbolic.factorization import Factor, Named, factored, find_factor, jets_for, naming_formulas
from exactspline.verification import divisors
from exactspline.verification import phrases as say
from exactspline.verification.claim import Claim, claim_kind, formula_name, formula_names, one_of, read
from exactspline.verification.decision import SquaresAddUp, common_zeros, extra_zero
from exactspline.verification.evaluation import Evaluation, evaluation, zero_of
from exactspline.verification.evidence import At, Evidence, Fact, OnExample, Place, Said, ZeroAt
from exactspline.verification.generic_proof import factor_of
from exactspline.verification.kinds.equality import checked_factor
from exactspline.verification.notation import factor_formulas, factor_of_text, factor_parts
from exactspline.verification.paper_curves import curve_names, undulations
from exactspline.verification.verdict import PROVED, REFUTED, UNDECIDED, VERIFIED, Finding, vacuous
from exactspline.verification.vocabulary import ArgumentKind, Name, Sign


def _squared(value: Value) -> Factor | None:
    """The sum of the squares of the components of a nonzero value of jet fractions, in factors; None if the roots of a
    frame do not cancel.

    >>> from exactspline.papers import find
    >>> from exactspline.symbolic.factorization import jets_for
    >>> c = jets_for(("D1", "f2"), 2)
    >>> [str(_squared(find(name)(c))) for name in ("D1", "f2")]
    ['‖D1‖²', 'f2²']
    """
    components: list[Any] = split(cast(Any, value))[0]
    pivot = next(x for x in components if not x.is_zero)
    ratios = [x / pivot for x in components]
    rest = _without_roots(sum((x * x for x in ratios), pivot.constant(0)))
    first, power = _without_roots(pivot), 2
    if first is None:
        first, power = _without_roots(pivot * pivot), 1
    if first is None or rest is None:
        return None
    own, more = (factored(x.ring, x.top, x.bottom) for x in (first, rest))
    return Factor(own.constant**power * more.constant, own.powers**power * more.powers, own.ring)


def _without_roots(value: Any) -> JetFraction | None:
    """A value over the roots of a frame as a quotient of polynomials in the curve; None where a root remains."""
    while isinstance(value, Adjoined):
        if not value.rooted.is_zero:
            return None
        value = value.plain
    found: JetFraction = value
    ring = found.ring
    if isinstance(ring.kind, FramedKind):
        ring = JetRing(ring.kind.without_roots, ring.dimension, ring.order, polynomial=ring.polynomial)
    return JetFraction(ring, *(ring.of_terms(terms_of(p)) for p in (found.top, found.bottom)))


def _have_one_zero_set(exponents: Sequence[Sequence[int]]) -> bool:
    """Whether products of powers vanish together for all possible orders of their bases at a point. Without
    denominators, their bases must be the same; otherwise the exponents must be proportional, since zeros may cancel.

    >>> [_have_one_zero_set(pairs) for pairs in ([(1, 2), (3, 1)], [(1, 0), (1, 1)], [(1, -1), (2, -2)])]
    [True, False, True]
    >>> [_have_one_zero_set([(1, -1), other]) for other in [(1, 0), (1, -2), (0, -1)]]
    [False, False, False]
    """

    def kind(powers: Sequence[int]) -> tuple[int, ...]:
        if min(powers, default=0) >= 0 or max(powers) <= 0:
            return tuple(int(e > 0) for e in powers)
        return tuple(e // gcd(*powers) for e in powers)

    return len({kind(powers) for powers in exponents}) == 1


def _may_vanish(factor: Factor, zero_free: Callable[[Jet], bool]) -> list[Named]:
    """The irreducible parts of a factor that may have zeros."""
    return [base for base, _ in factor.powers if not zero_free(Jet(factor.ring, base.polynomial))]


def _excluded_by(guilty: Iterable[Named], ring: JetRing, find: Callable[[str], Formula]) -> Said:
    """Irreducible polynomials that may have zeros, and the assumptions, as claims write them, that exclude these
    zeros.
    """
    names, assume = [], list[Name]()
    for base in guilty:
        names.append(Name(base.name))
        alone = Factor(mpq(1), Factorization([(base, 1)]), ring)
        constants = [name for (name, _), x in zip(ring.variables, ring.gens, strict=True) if x == base.polynomial]
        if reason := zero_free(Jet(ring, base.polynomial)):
            assume.append(Name(reason.name))
        elif constants and not ring.symbols[constants[0]].parameters:
            assume.append(Name(f"{constants[0]} ≠ 0"))
        else:
            # claims of this paper cannot name the formulas of another one, of which an assumption may be
            with suppress(ExactSplineError):
                assume += [Name(f"{f.name} ≠ 0") for f in naming_formulas(alone) if find(f.name) is f][:1]
    return say.may_vanish(tuple(dict.fromkeys(names)), tuple(dict.fromkeys(assume)))


class _ZeroFree:
    """Which irreducible polynomials have no zero: by assumption, or because they are sums of squares, one of which has
    no zero: term by term, or as divisors of the numerator of a value in the formulas that is such a sum over
    denominators without zeros.

    `used` are the names of the assumptions that were needed since the list was last emptied.
    """

    def __init__(
        self, formulas: Iterable[Formula], c: Evaluated, dimension: int, assumed: Iterable[Assumption]
    ) -> None:
        self.assumed, self.used = tuple(assumed), list[Name]()
        self._value, self._positive = divisors.Evaluation(c), list[tuple[fmpq_mpoly, list[Name]]]()
        self._sums = [x for each in formulas for x in nodes(trace(each, dimension)) if x.op is Operation.PLUS]

    def __call__(self, jet: Jet) -> bool:
        """Whether an irreducible polynomial has no zero."""
        if reason := zero_free(jet, self.assumed):
            self.used.append(Name(reason.name))
            return True
        before = self.used
        if self._has_square_terms(jet):
            return True
        while self._sums:
            node, self.used = self._sums.pop(), []
            with suppress(FormulaError, ReachError):  # of what is too large to be multiplied out nothing is known
                if self._is_square(node):
                    self._has_no_zero(node)
        self.used = before
        found = [names for each, names in self._positive if not divmod(each, jet.polynomial)[1]]
        self.used += found[0] if found else []
        return bool(found)

    def _has_square_terms(self, jet: Jet) -> bool:
        """Whether all terms are multiples of squares of monomials, of one sign, and one of them has no zero."""
        terms, before = list(jet.polynomial.terms()), self.used
        if len({c > 0 for _, c in terms}) > 1 or any(int(e) % 2 for powers, _ in terms for e in powers):
            return False
        for powers, _ in terms:
            self.used = [*before]
            if all(self(Jet(jet.ring, x)) for x, e in zip(jet.ring.gens, powers, strict=True) if int(e)):
                return True
        self.used = before
        return False

    def _is_square(self, node: Node) -> bool:
        """Whether a scalar is ≥ 0 wherever it exists: squares, and sums, products and quotients of such."""
        first, last = (node.args or (node,))[0], (node.args or (node,))[-1]
        match node.op:
            case Operation.NUMBER:
                return bool(node.value >= 0)
            case Operation.POWER:
                return node.value % 2 == 0 or self._is_square(first)
            case Operation.TIMES | Operation.DOT if not node.is_vector and first.is_vector == last.is_vector:
                if self._value(first) == self._value(last):
                    return True
        made = node.op in (Operation.PLUS, Operation.TIMES, Operation.OVER, Operation.NAMED)
        return made and not node.is_vector and all(map(self._is_square, node.args))

    def _has_no_zero(self, node: Node) -> bool:
        """Whether a scalar exists everywhere, and has no zero."""
        value = self._fraction(node)
        if value is None:
            return node.op is Operation.NUMBER and node.value != 0
        squares = node.op is Operation.PLUS and self._is_square(node) and all(map(self._exists, node.args))
        if squares and any(map(self._has_no_zero, node.args)):
            self._positive.append((value.top, [*self.used]))
            return True
        return self._exists(node) and self._holds_of(value.ring, value.top)

    def _exists(self, node: Node) -> bool:
        value = self._fraction(node)
        return node.op is Operation.NUMBER or (value is not None and self._holds_of(value.ring, value.bottom))

    def _fraction(self, node: Node) -> JetFraction | None:
        value: Any = self._value(node)
        return _without_roots(value) if isinstance(value, JetFraction | Adjoined) else None

    def _holds_of(self, ring: JetRing, polynomial: fmpq_mpoly) -> bool:
        return bool(polynomial) and all(self(Jet(ring, p)) for p in factorize(polynomial).bases)


@claim_kind
class ZeroSet(Claim):
    """All of ``formulas`` have one zero set. Their values are quotients in lowest terms."""

    kind: ClassVar[str] = "zero set"
    value: ClassVar[str] = "one zero set"
    of_frames: ClassVar[bool] = True
    asks_for_zeros: ClassVar[bool] = True

    formulas: tuple[Name, ...] = field(metadata=read(formula_names))

    def validate(self) -> None:
        """Reject fewer than two formulas, and the operands of Table 1."""
        if len(set(self.formulas)) < 2 or len(set(self.formulas)) < len(self.formulas):
            raise ClaimError(
                "a zero set is compared with itself", where="formulas", remedy="name two formulas or more, each once"
            )
        if self.curve == ArgumentKind.TABLE:
            raise ClaimError("zero sets of 'table' are not compared", where="curve", remedy="name a curve")

    @property
    def latex(self) -> str:
        """Zero sets that are equal."""
        return " = ".join(rf"\{{{self.symbol(name)} = 0\}}" for name in self.formulas)

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """The formulas are identical up to factors that have no zero, or vanish where the same factors do."""
        formulas = [self.find(name) for name in self.formulas]
        c = jets_for(formulas, dimension, polynomial=polynomial)
        zero = [name for name, f in zip(self.formulas, formulas, strict=True) if _is_zero(f(c))]
        if len(zero) == len(formulas):
            return vacuous()
        if zero:
            return Finding(REFUTED, Fact.DIFFERENT_ZERO_SETS, witness=say.vanishes_always(zero[0]))
        zero_free = _ZeroFree(formulas, c, dimension, self.assumes)
        found = self._by_quotients(formulas, c, zero_free)
        if found.verdict != PROVED:
            found = self._by_factors(formulas, c, polynomial, zero_free) or found
        if found.verdict == PROVED:
            return replace(found, assumptions=tuple(dict.fromkeys(zero_free.used)))
        if found.verdict == REFUTED:
            return found
        refuted = self.refuted_on_examples()
        if refuted.verdict == REFUTED:
            return Finding(REFUTED, Fact.DIFFERENT_ZERO_SETS, witness=refuted.witness)
        return found

    def _by_quotients(self, formulas: list[Formula], c: Evaluated, zero_free: _ZeroFree) -> Finding:
        """The proof that no quotient by the first formula has zeros or poles; None if some quotient may have them."""
        if kind_of(self.curve).adjoins_roots:
            return Finding(UNDECIDED, witness=Fact.ROOTS_REMAIN)
        first, *others = formulas
        factors = [find_factor(first(c), other(c)) for other in others]
        quotients = say.quotients(self.formulas[0], tuple(zip(self.formulas[1:], factors, strict=True)))
        known = [factor for factor in factors if factor is not None]
        if len(known) < len(factors):
            return Finding(UNDECIDED, None, quotients, Fact.NOT_PROPORTIONAL)
        guilty = [base for factor in known for base in _may_vanish(factor, zero_free)]
        if not guilty:
            return Finding(PROVED, Fact.ONE_ZERO_SET, quotients)
        return Finding(UNDECIDED, None, quotients, _excluded_by(guilty, known[0].ring, self.find))

    def _by_factors(
        self, formulas: list[Formula], c: Evaluated, polynomial: bool, zero_free: _ZeroFree
    ) -> Finding | None:
        """The proof that all formulas vanish at the zeros of the same irreducible factors; None if one cannot be
        factored.
        """
        try:
            factors = [_squared(formula(c)) for formula in formulas]
        except (FormulaError, ReachError):
            return None
        known = [factor for factor in factors if factor is not None]
        if len(known) < len(factors):
            return None
        ring, table = known[0].ring, [factor.powers for factor in known]
        bases: list[Named] = []
        for powers in table:
            bases += [base for base, _ in powers if base not in bases]

        def agree_without(gone: list[Named]) -> bool:
            left = [base for base in bases if base not in gone]
            return _have_one_zero_set([[row.exponent(base) for base in left] for row in table])

        gone = [base for base in bases if zero_free(Jet(ring, base.polynomial))]
        if agree_without(gone):
            for base in gone:
                others = [each for each in gone if each is not base]
                gone = others if agree_without(others) else gone
            zero_free.used.clear()
            for base in gone:
                zero_free(Jet(ring, base.polynomial))
            weighted = ring.polynomial and not polynomial  # rational curves by the derivatives of γ
            if weighted and not any(each.name == "w" for each in self.assumes):
                return Finding(UNDECIDED, witness=say.may_vanish((Name("w"),), (Name("w"),)))
            zero_free.used += [Name("w")] * weighted
            left = tuple(Name(base.name) for base in bases if base not in gone and table[0].exponent(base) > 0)
            return Finding(PROVED, Fact.ONE_ZERO_SET, say.zeros_of(left))
        differing = self._with_roots(known, ring.dimension) if kind_of(self.curve).adjoins_roots else None
        if differing and differing.verdict == REFUTED:
            return differing
        unequal = [base for base in bases if len({row.exponent(base) for row in table}) > 1]
        return Finding(UNDECIDED, witness=_excluded_by([base for base in unequal if base not in gone], ring, self.find))

    def _examples(self) -> Iterator[tuple[bool, str, Nurbs | NurbsSurface]]:
        """The examples, with curves of vanishing curvature: a false statement often fails on these alone."""
        yield from super()._examples()
        for name in undulations():
            curve = self.curve_named(name)
            if self.applies_to(curve.dimension, curve.polynomial):
                yield False, name, curve

    def examine(self, argument: Evaluated, own: Evaluation) -> Finding:
        """The finding: on every segment, no numerator has a zero after the factors of the other one are removed. For
        two curves, a few points of one of them are tried.
        """
        values = [(name, self.find(name)(argument)) for name in self.formulas]
        if self.of_pair:
            return self._along_lines(values)
        numerators = [(name, common_zeros(split(continued(value))[0])) for name, value in values]
        if all(p.is_zero for _, p in numerators):
            return vacuous()
        return _compared(numerators)

    def _along_lines(self, values: list[tuple[Name, Any]]) -> Finding:
        """A zero of only one formula on lines of constant parameter, at a place where all values exist."""
        parts = [(name, *split(value)) for name, value in values]
        for fixed, k in product(range(2), range(1, LINES)):
            low, high = parts[0][1][0].domain[fixed]
            t = low + (high - low) * mpq(k, LINES)
            line = methodcaller(("at_s", "at_t")[fixed], t)
            below = [line(w) for _, _, w in parts if w is not None]
            tops = [(name, common_zeros([line(x) for x in components])) for name, components, _ in parts]
            found = _compared(tops, below, partial(say.along_line, PARAMETERS[fixed], t))
            if found.verdict == REFUTED:
                return found
        return Finding(VERIFIED, Fact.ONE_ZERO_SET)

    def _with_roots(self, factors: list[Factor], dimension: int) -> Finding:
        """The first polynomial example curve on which values with roots, squared, differ in their zeros."""
        for name in (*curve_names(self.source_paper), *undulations()):
            curve = self.curve_named(name)
            if (curve.dimension, curve.polynomial) != (dimension, True):
                continue
            own, _, part = evaluation(curve).given(factors[0].ring.kind.name)
            parts = [factor.on(cast(Any, own)) for factor in factors]
            if not any(below.vanishes_somewhere for _, below in parts):
                tops = [continued(top / below) for top, below in parts]
                found = _compared(list(zip(self.formulas, [split(each)[0][0] for each in tops], strict=True)))
                if found.verdict == REFUTED and not evaluation(curve).failing(self.curve, self.assumes):
                    witness = say.on_part(found.witness, part) if part else found.witness
                    return replace(found, witness=OnExample(Name(name), witness))
        return Finding(UNDECIDED)


#: Zeros in two parameters are compared along one line less in each direction.
LINES = 4


def _compared(
    numerators: list[tuple[Name, BSpline]], below: Iterable[BSpline] = (), where: Callable[[Place], Any] = lambda at: at
) -> Finding:
    """Whether the first of some splines vanishes at the zeros of each of the others, outside the zeros of `below`."""
    first = numerators[0]
    for other in numerators[1:]:
        for (a_name, a), (b_name, b) in ((first, other), (other, first)):
            if place := extra_zero(a, reduce(mul, below, b)):
                witness = say.vanishes_alone(a_name, where(place), b_name)
                return Finding(REFUTED, Fact.DIFFERENT_ZERO_SETS, witness=witness)
    return Finding(VERIFIED, Fact.ONE_ZERO_SET)


def _is_zero(value: Any) -> bool:
    return all(x.is_zero for x in split(value)[0])


def continued(value: SplineValue) -> SplineValue:
    """A quotient without the common zeros of numerator and denominator; any other value unchanged."""
    return in_lowest_terms(value) if isinstance(value, Rational) else value


def _positive_factor(claim: Claim, name: str, value: str) -> str:
    """A factor that is positive on every curve: a positive number, and even powers."""
    for part, exponent in factor_parts(value):
        if part[0] == "-" or (part[0].isalpha() and exponent % 2):
            raise ClaimError(f"the factor {value!r} has no sign", where=part, remedy="positive numbers and even powers")
    return checked_factor(claim, name, value)


@claim_kind
class SignClaim(Claim):
    """The value of ``formula`` has a ``sign`` wherever it exists, or can be continued: on all curves because, up to
    that sign, it is ``factor`` times the sum of the ``squares`` (for a vector, its squared length).
    """

    kind: ClassVar[str] = "sign"
    value: ClassVar[str] = "$sign"
    of_one_curve: ClassVar[bool] = True
    asks_for_zeros: ClassVar[bool] = True

    formula: Name = field(metadata=read(formula_name))
    sign: Sign = field(default=Sign.NONNEGATIVE, metadata=read(one_of(Sign)))
    squares: tuple[Name, ...] = field(default=(), metadata=read(formula_names))
    factor: str = field(default="1", metadata=read(_positive_factor))

    def validate(self) -> None:
        """Reject a factor without squares."""
        if self.factor != "1" and not self.squares:
            raise ClaimError("a factor of no squares", where="factor", remedy="name the squares")

    @property
    def latex(self) -> str:
        """The formula and its sign."""
        sign = self.claims.replace("≥", r"\ge").replace("≤", r"\le")
        return f"{self.symbol(self.formula)} {sign}"

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """The sum of squares is the value up to the factor, as differential polynomials."""
        formula, squares = self.find(self.formula), tuple(map(self.find, self.squares))
        named = factor_formulas(self.factor, self.find_in_factor)
        c: Any = jets_for((formula, *squares, *named), dimension, polynomial=polynomial)
        value = formula(c)
        if value.is_vector:
            raise ClaimError(f"{self.formula!r} is a vector", where=self.key, remedy="a vector has no sign")
        if value.is_zero:
            return vacuous()
        if squares:
            finding = SquaresAddUp(formula, squares, self.factor, self.sign.direction, self.find_in_factor).decide(c)
            if finding.verdict == PROVED:
                if not self.sign.strict:
                    return finding
                zero_free = _ZeroFree((formula, *squares, *named), c, dimension, self.assumes)
                return self._strict([square(c) for square in squares], c, zero_free)
        return self._refuted_or_undecided(Fact.OTHER_SQUARES if squares else Fact.NO_SQUARES)

    def _strict(self, squares: list[Any], c: Any, zero_free: _ZeroFree) -> Finding:
        """The factor, and one of the squares, have no zeros."""
        above: Any = factor_of_text(self.factor, c, self.find_in_factor)[0]
        factors = [_squared(each) for each in (above, *squares) if not _is_zero(each)]
        first, *others = [_may_vanish(Factor(f.constant, f.powers.above, f.ring), zero_free) for f in factors if f]
        if not first and not all(others):
            return Finding(PROVED, Fact.SQUARES_ONE_WITHOUT_ZERO, assumptions=tuple(dict.fromkeys(zero_free.used)))
        return self._refuted_or_undecided(_excluded_by(first or others[0], above.ring, self.find))

    def _refuted_or_undecided(self, reason: Evidence) -> Finding:
        """What an example refutes; otherwise the sign is undecided, with this reason."""
        refuted = self.refuted_on_examples()
        return refuted if refuted.verdict == REFUTED else Finding(UNDECIDED, witness=reason)

    def examine(self, argument: Evaluated, own: Evaluation) -> Finding:
        """The finding, segment by segment: there is no root at which the sign changes, and one value has that sign."""
        (p, *others), below = split(continued(self.find(self.formula)(argument)))
        if others:
            raise ClaimError(f"{self.formula!r} is a vector", where=self.key, remedy="a vector has no sign")
        return vacuous(Fact.ZERO) if p.is_zero else sign_found(p, below, self.sign)


def sign_found(p: BSpline, below: BSpline | None, sign: Sign) -> Finding:
    """Whether a function that is not zero, or a quotient, has a sign wherever it exists: segment by segment there is no
    root at which it changes, and one value has it.
    """
    value = p * sign.direction
    value = value if below is None else value * below
    for i, c in enumerate(value.numerators):
        if not is_nonnegative(c, value.degree):
            return Finding(REFUTED, Fact.OTHER_SIGN, witness=At(_negative(value, i)))
    zero = zero_of(p) if below is None else extra_zero(p, below)  # 0/0 is not a value
    if sign.strict and zero:
        return Finding(REFUTED, Fact.HAS_ZERO, witness=ZeroAt(zero))
    return Finding(VERIFIED, say.of_sign(sign))


def _negative(f: BSpline, i: int) -> mpq:
    """A parameter at which a spline is negative, on a segment on which it has negative values: in the middle between
    zeros, or an end of the segment and a zero.
    """
    a, b = f.breakpoints[i : i + 2]
    places = [at(mpq(0)), *map(PlaceOfZero, isolate(f.numerators[i], f.degree).inner), at(mpq(1))]
    inside = (a + (b - a) * rational_between(*pair) for pair in pairwise(places))
    return next(t for t in inside if f(t) < 0)


@claim_kind
class SquareClass(Claim):
    """On every curve ``formula`` is a square up to constants exactly where ``right`` is."""

    kind: ClassVar[str] = "square class"
    value: ClassVar[str] = "a square"
    notation: ClassVar[str] = r"$formula \,/\, $right \;\text{is a square up to a constant}"
    sides: ClassVar[tuple[str, ...]] = ("formula", "right")
    of_one_curve: ClassVar[bool] = True
    asks_for_zeros: ClassVar[bool] = True

    formula: Name = field(metadata=read(formula_name))
    right: Name = field(metadata=read(formula_name))

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """The quotient of the two is a square times a constant: every irreducible factor occurs an even number of
        times. The product of a square up to constants and such a quotient is again a square up to constants.
        """
        formula, right = self.find(self.formula), self.find(self.right)
        c = jets_for((formula, right), dimension, polynomial=polynomial)
        if any(self.only_component(f.name, split(f(c))[0]).is_zero for f in (formula, right)):
            return vacuous()
        factor = factor_of(formula, right, dimension, polynomial=polynomial)
        odd = () if factor is None else tuple(Name(base.name) for base, e in factor.powers if e % 2)
        quotient = say.quotients(self.formula, ((self.right, factor),))
        if factor is not None and not odd:
            return Finding(PROVED, Fact.SQUARE, quotient)
        difference = Fact.NOT_PROPORTIONAL if factor is None else say.odd_powers(odd)
        refuted = self.refuted_on_examples()
        verdict = REFUTED if refuted.verdict == REFUTED else UNDECIDED
        return Finding(verdict, difference, quotient, refuted.witness or difference)

    def examine(self, argument: Evaluated, own: Evaluation) -> Finding:
        """The finding: on every segment both formulas are squares up to a constant, or neither is. A segment on which
        one is 0 is skipped.
        """
        (n, m), (p, q) = [
            (self.only_component(name, numerators), w)
            for name in (self.formula, self.right)
            for numerators, w in [split(self.find(name)(argument))]
        ]
        left, right = (n if m is None else n * m), (p if q is None else p * q)
        pairs = {
            i: (is_square_class(a, left.degree), is_square_class(b, right.degree))
            for i, (a, b) in enumerate(zip(left.numerators, right.numerators, strict=True))
            if a and b
        }
        if not pairs:
            return vacuous()
        for i, (a, b) in pairs.items():
            if a != b:
                return Finding(REFUTED, Fact.DIFFERENT, witness=say.one_is_square(i))
        squares, whole = sum(b for _, b in pairs.values()), len(left.numerators)
        return Finding(VERIFIED, say.squares_on(self.right, squares, whole, whole - len(pairs)))
