"""Equality up to a factor: the factor is computed in the jet ring by exact division, factored, and named."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from dataclasses import dataclass
from functools import cache, partial
from operator import attrgetter
from typing import Any, NamedTuple, cast

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from exactspline.errors import ClaimError, ExactSplineError, FormulaError, ReachError, as_flag, as_integer, as_items
from exactspline.hooks import Displayed
from exactspline.language.arguments import Curve, Evaluated, Pair, T
from exactspline.language.formula import Formula
from exactspline.language.kinds import Kind, common_kind
from exactspline.language.ruled import Value, split
from exactspline.language.surface_kind import BOTH
from exactspline.language.vector import Vector
from exactspline.numbers.exact import content, from_flint, mpq, sign, to_fmpq
from exactspline.numbers.once import Lock, while_set
from exactspline.one_line import OneLine
from exactspline.papers import Paper, default_papers, formula_of
from exactspline.polynomials.cost import Budget, Priced, drawing_on
from exactspline.polynomials.factors import Factorization, factorize, multiplied, power_text
from exactspline.readings.degree import Degree, DegreeReading
from exactspline.readings.differential_order import is_polynomial, order_of
from exactspline.readings.jet import Jet, JetReading, JetRing, RationalJetReading, Terms, polynomial_text, terms_of
from exactspline.readings.printing import POWER, SUM, print_text, symbol_text
from exactspline.readings.tree import speaks_of_gamma_alone, trace
from exactspline.symbolic.substitution import substitute


class Named(NamedTuple):
    """An irreducible jet polynomial and its name: that of a formula or, if there is none, its text."""

    name: str
    polynomial: fmpq_mpoly

    def __repr__(self) -> str:
        return f"<Named {self.name}>"


@dataclass(frozen=True, repr=False)
class Factor(OneLine, Displayed):
    """A quotient of jet polynomials, as a constant times powers of named irreducible polynomials."""

    constant: mpq
    powers: Factorization[Named]
    ring: JetRing

    def __reduce__(self) -> tuple[object, ...]:
        powers = tuple((base.name, terms_of(base.polynomial), e) for base, e in self.powers)
        return _factor, (self.constant, powers, self.ring)

    def __str__(self) -> str:
        names, parts = [base.name for base, _ in self.powers], list[str]()
        for i, (base, e) in enumerate(self.powers):  # different factors look different
            before = names[:i].count(base.name)
            parts.append(power_text(f"[{base.name}, no. {before + 1}]" if before else base.name, e))
        if self.constant != 1 or not parts:
            parts.insert(0, str(self.constant))
        return "·".join(parts)

    @property
    def names(self) -> frozenset[str]:
        """The names of the factors."""
        return frozenset(base.name for base, _ in self.powers)

    @property
    def is_zero(self) -> bool:
        """Whether the factor is the constant 0."""
        return self.constant == 0

    @property
    def is_one(self) -> bool:
        """Whether the factor is the constant 1."""
        return self.constant == 1 and not self.powers

    def fraction(self) -> tuple[fmpq_mpoly, fmpq_mpoly]:
        """Numerator and denominator as jet polynomials."""
        one = self.ring.context.constant(1)
        top, bottom = one * int(self.constant.numerator), one * int(self.constant.denominator)
        polynomials = self.powers.mapped(attrgetter("polynomial"))
        return multiplied(polynomials.above, top), multiplied(polynomials.below**-1, bottom)

    def on(self, curve: Curve[T] | Pair[T]) -> tuple[T, T]:
        """Numerator and denominator in the reading of a concrete curve."""
        top, bottom = self.fraction()
        return substitute(Jet(self.ring, top), curve), substitute(Jet(self.ring, bottom), curve)


def _factor(constant: mpq, powers: tuple[tuple[str, Terms, int], ...], ring: JetRing) -> Factor:
    """Unpickles a factor."""
    return Factor(constant, Factorization([(Named(name, ring.of_terms(terms)), e) for name, terms, e in powers]), ring)


#: The name of the option `polynomial` in errors.
POLYNOMIAL = "whether curves are polynomial"


def jets_for(
    formulas: Iterable[str | Formula], dimension: int, *, polynomial: bool = False, factor: str = "1"
) -> Evaluated:
    """Return the argument of the formulas (such as a curve, or a curve and a point) whose coordinates, with as many
    derivatives as the formulas need, are indeterminates. The denominator w is 1 if `polynomial` is set. It is also 1 if
    the formulas need the square roots of a moving frame, and w does not occur in the formulas and in `factor`.

    >>> jets_for(("f2",), 2, polynomial=True).w
    (1) / (1)
    """
    chosen = list(map(formula_of, as_items(formulas, "formulas")))
    dimension, polynomial = as_integer(dimension, "a dimension", 1), as_flag(polynomial, POLYNOMIAL)
    kind = common_kind(each.kind for each in chosen)
    if kind.adjoins_roots:
        polynomial = polynomial or without_denominator(chosen, factor, dimension)
    # with roots, every derivative needs derivatives of higher order
    order = max((order_of(each, dimension, kind if kind.adjoins_roots else None) for each in chosen), default=0)
    shared, key = _SHARED.get(), (kind, dimension, order, polynomial)
    make = partial(RationalJetReading(order).argument, kind, dimension, polynomial=polynomial)
    if shared is None:
        return make()
    if key not in shared:
        shared.setdefault(key, Priced(lambda: make().remembering()))
    return shared[key].value


#: Indeterminate curves by kind, dimension, order and whether w = 1; they memoize the values of formulas.
SharedJets = dict[tuple[Kind, int, int, bool], Priced[Evaluated]]
_SHARED: ContextVar[SharedJets | None] = ContextVar("shared jets", default=None)


@contextmanager
def sharing(jets: SharedJets | None = None) -> Iterator[None]:
    """A context in which `jets_for` reuses and extends these arguments (by default those of the enclosing context), so
    that a formula is computed once for many proofs.
    """
    shared = _SHARED.get() if jets is None else jets
    with while_set(_SHARED, {} if shared is None else shared):
        yield


def without_denominator(formulas: Iterable[Formula], factor: str, dimension: int) -> bool:
    """Whether the formulas, and a factor in the notation of claims, involve only γ and not its denominator."""
    weighted = {"w", "W"} & {part.partition("^")[0] for part in factor.split()}
    return not weighted and all(speaks_of_gamma_alone(each, dimension) for each in formulas)


def find_factor(left: Value, right: Value) -> Factor | None:
    """The quotient left/right of two formulas in the fraction reading, or None if they are not proportional; the
    constant 0 if only the left side vanishes.

    >>> from exactspline.papers.chen_riesenfeld_cohen_2007.plane import f1, f2
    >>> c = jets_for(("f1", "f2"), 2)
    >>> str(find_factor(f1(c), f2(c)))
    'w'

    Raises `ClaimError` if the right side vanishes identically.
    """
    (ps, _), (qs, _) = split(cast(Any, left)), split(cast(Any, right))
    pivot = next((i for i, q in enumerate(qs) if not q.is_zero), None)
    if pivot is None:
        raise ClaimError("the right side vanishes identically", remedy="then the factor is not determined")
    if len(ps) != len(qs):
        return None
    quotient = ps[pivot] / qs[pivot]
    if any(p != quotient * q for i, (p, q) in enumerate(zip(ps, qs, strict=True)) if i != pivot):
        return None
    return factored(quotient.ring, quotient.top, quotient.bottom)


def factored(ring: JetRing, top: fmpq_mpoly, bottom: fmpq_mpoly) -> Factor:
    """A quotient of jet polynomials as a product of named irreducible polynomials."""
    a, tops = factors_of(top)
    b, bottoms = factors_of(bottom)
    constant = from_flint(a) / from_flint(b)
    powers: list[tuple[Named, int]] = []
    for side, factors in ((1, tops), (-1, bottoms)):
        for p, e in factors:
            name, unit = _name_of(Jet(ring, p))
            constant *= unit ** (side * int(e))
            powers.append((Named(name, p / int(unit.numerator) * int(unit.denominator)), side * int(e)))
    in_order = sorted(powers, key=lambda power: (power[0].name != "w", power[0].name))
    return Factor(constant, Factorization(in_order), ring)


#: A polynomial with at least this many terms is first restricted to a line.
LONG = 2000


def factors_of(p: fmpq_mpoly) -> tuple[fmpq, list[tuple[fmpq_mpoly, int]]]:
    """A constant, and irreducible factors with their exponents; they have coprime integer coefficients, the first
    positive.

    >>> from flint import Ordering, fmpq_mpoly_ctx
    >>> x, y = fmpq_mpoly_ctx.get(["x", "y"], Ordering.degrevlex).gens()
    >>> factors_of(-2 * x**2 + 2 * y**2)
    (-2, [(x - y, 1), (x + y, 1)])
    """
    if len(p) >= LONG and irreducible_on_a_line(p):
        unit = to_fmpq(content(map(from_flint, p.coeffs())) * sign(p.leading_coefficient()))
        return unit, [(p / unit, 1)]
    constant, factors = factorize(p)
    return constant, list(factors)


def irreducible_on_a_line(p: fmpq_mpoly) -> bool:
    """Whether a polynomial is proved irreducible by its restriction to a line on which it keeps its total degree: then
    its factors keep their degrees, so that a factorization would give a factorization on the line.

    By Hilbert's irreducibility theorem most lines prove this for an irreducible polynomial; False decides nothing.
    """
    line = fmpq_mpoly_ctx.get(["t"], Ordering.lex)
    (t,) = line.gens()
    values = [(7 * i * i + 3) % 19 - 9 + ((5 * i * i + i + 1) % 17 - 8) * t for i in range(p.context().nvars())]
    restricted = p.compose(*values, ctx=line)
    if restricted.total_degree() < p.total_degree():
        return False
    try:
        return sum(e for _, e in factorize(restricted).powers) == 1
    except ReachError:
        return False


#: Polynomials with more terms have no text as names.
TERMS = 12


def _name_of(jet: Jet) -> tuple[str, mpq]:
    """The name of an irreducible jet polynomial (its text if there is none), and its quotient by the polynomial with
    this name.
    """
    for name, other in _named_parts(jet.ring):
        if len(other.polynomial) == len(jet.polynomial):
            quotient = jet.polynomial.leading_coefficient() / other.polynomial.leading_coefficient()
            if jet.polynomial == other.polynomial * quotient:
                return name, from_flint(quotient)
    if (count := len(jet.polynomial)) > TERMS:
        with suppress(FormulaError):  # where it is not homogeneous
            return "(a new form of degree {}, weight {})".format(*jet.grading), mpq(1)
        return f"(a new form of {count} terms)", mpq(1)
    text = polynomial_text(jet)
    return (f"({text})" if " " in text else text), mpq(1)


def name_of_vector(core: Sequence[Jet]) -> tuple[str, mpq]:
    """The name of a vector of jet polynomials, and its quotient by the vector with this name, like `_name_of`."""
    ring, n = core[0].ring, len(core)
    if all(jet.is_zero for jet in core):
        return "0", mpq(1)
    vectors = [(name, list(value)) for name, value in _all_named_values(ring) if isinstance(value, Vector)]
    whole = [(name, value) for name, value in vectors if len(value) == n]
    parts = [
        (f"{name}[{i}…{i + n - 1}]", value[i : i + n])
        for name, value in vectors
        for i in range(len(value) - n + 1)
        if len(value) > n
    ]
    for name, other in whole + parts:
        if (quotient := _proportion(core, other)) is not None:
            return name, quotient
    coefficients = [from_flint(c) for jet in core for c in jet.polynomial.coeffs()]
    unit = content(coefficients) * sign(coefficients[0])
    return f"({', '.join(polynomial_text(jet.scaled(1 / unit), 2) for jet in core)})", unit


def _proportion(core: Sequence[Jet], other: Sequence[Jet]) -> mpq | None:
    """The constant by which a vector is a multiple of another one; None if it is not a multiple."""
    pivot = next((i for i, jet in enumerate(other) if not jet.is_zero), None)
    if pivot is None or core[pivot].is_zero:
        return None
    quotient = core[pivot].polynomial.leading_coefficient() / other[pivot].polynomial.leading_coefficient()
    same = all(a.polynomial == b.polynomial * quotient for a, b in zip(core, other, strict=True))
    return from_flint(quotient) if same else None


def _named_parts(ring: JetRing) -> Iterator[tuple[str, Jet]]:
    """The denominators and the scalar polynomial formulas of the library that can be expressed in this ring."""
    return ((name, value) for name, value in _all_named_values(ring) if isinstance(value, Jet) and not value.is_zero)


def _all_named_values(ring: JetRing) -> Iterator[tuple[str, object]]:
    """The denominators and the polynomial formulas of the library, including vectors, that can be expressed in this
    ring; each is computed when it is first reached.
    """
    yield from _denominators(ring.kind, ring.dimension, ring.order, ring.polynomial)
    for source in naming():
        yield from _named_values(source, ring.kind, ring.dimension, ring.order, ring.polynomial)


def naming_formulas(factor: Factor) -> Iterator[Formula]:
    """The formulas from which the factors of a quotient have their names.

    >>> from exactspline.papers.chen_riesenfeld_cohen_2007.space import rectifying_along_tangent, torsion
    >>> c = jets_for(("rectifying_along_tangent", "torsion"), 3)
    >>> [each.name for each in naming_formulas(find_factor(rectifying_along_tangent(c), torsion(c)))]
    ['D1_squared']
    """
    ring = factor.ring
    key = (ring.kind, ring.dimension, ring.order, ring.polynomial)
    remaining = set(factor.names) - {name for name, _ in _denominators(*key)}
    for source in naming():
        names = _named_values(source, *key)
        for name, _ in names if remaining else ():
            if name in remaining:
                remaining.remove(name)
                yield names.formulas[name]


#: The paper whose names take precedence; None if there is no current paper.
_NAMED_BY: ContextVar[Paper | None] = ContextVar("named by", default=None)


def naming() -> tuple[Paper, ...]:
    """The papers whose formulas give factors their names: the current paper and those that it uses, then the default
    papers.
    """
    source = _NAMED_BY.get()
    sources = (source, *source.uses) if source is not None and not source.default else ()
    return tuple(dict.fromkeys((*sources, *default_papers())))


@contextmanager
def named_by(source: Paper) -> Iterator[None]:
    """A context in which factors have the names given by a paper."""
    with while_set(_NAMED_BY, source):
        yield


@cache
def _denominators(kind: Kind, dimension: int, order: int, polynomial: bool) -> list[tuple[str, object]]:
    """The denominators of the curves by their names."""
    if polynomial:
        return []
    known: Mapping[str, Any] = JetReading(order).argument(kind, dimension).operands()
    jets = [(name, known[name]) for name in ("w", "W") if name in known and name in known[name].ring.symbols]
    return [(jet.ring.symbols[name].text, jet) for name, jet in jets]


class _Names:
    """The polynomial formulas of one paper that can be expressed in a ring, with their values, each computed on first
    use.
    """

    def __init__(self, source: Paper, kind: Kind, dimension: int, order: int, polynomial: bool) -> None:
        argument = JetReading(order).argument(kind, dimension, polynomial=polynomial)
        self._formulas, self._kind, self._polynomial = tuple(source.formulas.values()), kind, polynomial
        self._dimension, self._order, self._of_library = dimension, order, bool(source.package)
        self._argument = argument.remembering()
        self._known: list[tuple[str, object] | None] = []
        self.formulas: dict[str, Formula] = {}
        #: One budget for all values, since they are computed in a fixed order: a name does not depend on what a claim
        #: spent before.
        self._budget = Budget()
        self._lock = Lock()

    def __iter__(self) -> Iterator[tuple[str, object]]:
        for i, formula in enumerate(self._formulas):
            if i == len(self._known):
                with self._lock.held():
                    if i == len(self._known):
                        self._known.append(self._named(formula))
            if (known := self._known[i]) is not None:
                yield known

    def _named(self, formula: Formula) -> tuple[str, object] | None:
        """The name and the value of a formula; None if it has no value in this ring. A formula of a user that raises an
        error is skipped, so that it does not affect verdicts on others.
        """
        try:
            with drawing_on(self._budget):
                return self._value(formula)
        except ExactSplineError:
            if self._of_library:
                raise
            return None

    def _value(self, formula: Formula) -> tuple[str, object] | None:
        n, kind = self._dimension, self._kind
        if not kind.takes(formula.kind, n) or order_of(formula, n) > self._order:
            return None
        if not is_polynomial(formula, n) and (self._of_library or not self._polynomial):  # γ is a polynomial if w = 1
            return None
        if kind.counted == BOTH and _degree_in_surface(formula, n, self._polynomial) > NAMED_DEGREE:
            return None
        value = formula(self._argument)
        least = SUM if isinstance(value, Vector) else POWER  # scalars are factors of products
        name = symbol_text(formula.symbol) or print_text.at(trace(formula, n), least)
        self.formulas.setdefault(name, formula)
        return name, value


@cache
def _named_values(source: Paper, kind: Kind, dimension: int, order: int, polynomial: bool) -> _Names:
    return _Names(source, kind, dimension, order, polynomial)


#: Formulas of a higher degree in a surface are not compared with factors: they have millions of terms.
NAMED_DEGREE = 10


def _degree_in_surface(formula: Formula, dimension: int, polynomial: bool) -> int:
    """The maximal number of operands multiplied in a term."""
    argument = DegreeReading(parameter=BOTH[0]).argument(formula.kind, dimension, polynomial=polynomial)
    (components, _) = split(formula(argument))
    return max(sum(k for _, k in names) for x in components for names, _ in cast(Degree, x.degree).terms)
