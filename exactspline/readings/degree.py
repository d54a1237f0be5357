"""The degree reading: max-plus expressions in named degrees, ``9d − 6`` or ``max(2d − 1, d1 + d2)``.

The degree of a product is the sum of the degrees, that of a sum their maximum, and a derivative lowers it by one.
Constants have degree 0. These are the rules of Table 1 of the paper.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import cache, reduce
from typing import cast

from exactspline.errors import FormulaError, InapplicableError, as_text
from exactspline.language.arguments import Curve, Evaluated, Pair
from exactspline.language.formula import Formula, Reading
from exactspline.language.kinds import Kind, Symbol
from exactspline.language.operand import CONSTANTS, Constant, Counting, Parameter, PartlyOrdered
from exactspline.language.provenance import DERIVATIVE, MULTIPLE, PRODUCT, SUM, UNIT, Provenance, leaf
from exactspline.language.rational import Rational, RingOperand
from exactspline.numbers.exact import mpq
from exactspline.one_line import one_line
from exactspline.words import choice

#: One affine form: coefficients by name in alphabetical order, and the constant.
Term = tuple[tuple[tuple[str, int], ...], int]


def _plus(a: Term, b: Term) -> Term:
    coefficients = dict(a[0])
    for name, k in b[0]:
        coefficients[name] = coefficients.get(name, 0) + k
    return tuple(sorted((name, k) for name, k in coefficients.items() if k)), a[1] + b[1]


def _dominates(a: Term, b: Term, start: int = 1) -> bool:
    """Whether a ≥ b for all degrees ≥ `start`: no coefficient of a is smaller, and neither is the value if all degrees
    are `start`.
    """
    difference = _plus(a, (tuple((name, -k) for name, k in b[0]), -b[1]))
    return all(k >= 0 for _, k in difference[0]) and sum(k for _, k in difference[0]) * start + difference[1] >= 0


class Degree(RingOperand, PartlyOrdered):
    """A maximum of affine forms in named degrees, which are at least 1; a degree with respect to the parameter
    `counted`.

    A `still` degree belongs to an operand that does not depend on this parameter: derivatives leave it unchanged.

    >>> d = Degree.named("d")
    >>> (d + d).elevated_to(d), d * d, (d * d).d(3)
    (d, 2d, 2d − 3)
    """

    __slots__ = ("counted", "provenance", "still", "terms")

    def __init__(
        self,
        terms: Iterable[Term],
        provenance: Provenance | None = None,
        *,
        still: bool = False,
        counted: Parameter = Parameter.FIRST,
    ) -> None:
        terms = set(terms)
        self.still, self.counted = still, counted
        self.provenance = leaf() if provenance is None else provenance
        self.terms = frozenset(t for t in terms if not any(s != t and _dominates(s, t) for s in terms))

    @classmethod
    def named(cls, name: str, counted: Parameter = Parameter.FIRST) -> Degree:
        """The degree with this name."""
        return cls([(((name, 1),), 0)], counted=counted)

    @classmethod
    def number(cls, n: int, *, still: bool = False, counted: Parameter = Parameter.FIRST) -> Degree:
        """A fixed degree."""
        return cls([((), n)], still=still, counted=counted)

    def _made(self, terms: Iterable[Term], provenance: Provenance, still: bool) -> Degree:
        return Degree(terms, provenance, still=still, counted=self.counted)

    @property
    def degree(self) -> Degree:
        """The degree itself."""
        return self

    def max(self, other: Degree) -> Degree:
        """The larger of two degrees."""
        return Degree(self.terms | other.terms)

    def elevated_to(self, other: Degree) -> Degree:
        """The degree after elevation: the larger of the two."""
        return self._made(self.terms | other.terms, self.provenance, self.still)

    def _plus(self, right: Degree) -> Degree:
        provenance = (SUM, self.provenance, right.provenance)
        return self._made(self.terms | right.terms, provenance, self.still and right.still)

    def __mul__(self, other: object) -> Degree:
        if isinstance(other, CONSTANTS):
            return self.scaled(other)
        if not isinstance(other, Degree):
            return NotImplemented
        terms = (_plus(a, b) for a in self.terms for b in other.terms)
        return self._made(terms, (PRODUCT, self.provenance, other.provenance), self.still and other.still)

    def scaled(self, constant: Constant) -> Degree:
        """The degree itself: a constant factor does not change it."""
        return self._made(self.terms, (MULTIPLE, self.provenance, mpq(constant)), self.still)

    def constant(self, value: Constant) -> Degree:
        """The degree 0 of a constant, `still` if this degree is."""
        return self._made([((), 0)], (MULTIPLE, UNIT, mpq(value)), self.still)

    def d(self, order: int = 1, *, by: str | None = None) -> Degree:
        """The degree lowered by one for every derivative with respect to the parameter `counted`, possibly below 0."""
        provenance = self.provenance
        for _ in range(order):
            provenance = (DERIVATIVE, provenance, by)
        if self.still or by not in (None, self.counted):
            return self._made(self.terms, provenance, self.still)
        return self._made(((name, constant - order) for name, constant in self.terms), provenance, False)

    @property
    def is_zero(self) -> bool:
        """Always False: a degree never shows that an operand vanishes."""
        return False

    def at(self, values: Mapping[str, int]) -> int:
        """The value for given values of the named degrees.

        >>> parse_degree("9d - 6").at({"d": 3})
        21
        """
        return max(
            sum(k * values[name] for name, k in coefficients) + constant for coefficients, constant in self.terms
        )

    @property
    def names(self) -> frozenset[str]:
        """The names of the degrees that occur in this expression."""
        return frozenset(name for coefficients, _ in self.terms for name, _ in coefficients)

    def where(self, name: str, value: Degree) -> Degree:
        """The degree with an affine form in place of a name.

        >>> parse_degree("2n - 1").where("n", parse_degree("2d + e + 1"))
        4d + 2e + 1
        """
        [(slopes, constant)] = value.terms
        terms = []
        for coefficients, rest in self.terms:
            k = dict(coefficients).get(name, 0)
            kept = tuple(each for each in coefficients if each[0] != name)
            terms.append(_plus((kept, rest), (tuple((other, k * n) for other, n in slopes), k * constant)))
        return self._made(terms, self.provenance, self.still)

    def __eq__(self, other: object) -> bool:
        """Whether two degrees are equal for all named degrees ≥ 1; see `equal_from` for equality above a larger
        bound.
        """
        return isinstance(other, Degree) and equal_from(self, other) == 1

    def __hash__(self) -> int:
        return hash(self.at(dict.fromkeys(sorted(self.names), 1_000_003)))

    @one_line
    def __repr__(self) -> str:
        parts = [_term_text(t) for t in sorted(self.terms, reverse=True)]
        return parts[0] if len(parts) == 1 else f"max({', '.join(parts)})"


def _term_text(term: Term) -> str:
    coefficients, constant = term
    text = ""
    for name, k in coefficients:
        sign = " − " if k < 0 else " + " if text else ""
        text += (sign if text or k > 0 else "−") + (f"{abs(k)}" if abs(k) != 1 else "") + name
    if constant or not text:
        text += f"{' − ' if constant < 0 else ' + '}{abs(constant)}" if text else str(constant).replace("-", "−")
    return text


def equal_from(a: Degree, b: Degree, limit: int = 1000) -> int | None:
    """The least d₀ ≥ 1 such that both are equal whenever all named degrees are ≥ d₀; None if there is none up to
    `limit`.

    >>> d = Degree.named("d")
    >>> equal_from(d.max(Degree.number(4)), d)
    4
    >>> equal_from(d, d * d) is None
    True
    """
    if not (_below(a, b, limit) and _below(b, a, limit)):
        return None
    low, high = 0, limit
    while high - low > 1:
        middle = (low + high) // 2
        if _below(a, b, middle) and _below(b, a, middle):
            high = middle
        else:
            low = middle
    return high


def _below(a: Degree, b: Degree, start: int) -> bool:
    """Whether a ≤ b whenever all degrees are ≥ `start`."""
    return all(any(_dominates(s, t, start) for s in b.terms) or _in_hull(t, b, start) for t in a.terms)


def _in_hull(term: Term, b: Degree, start: int) -> bool:
    """Whether a convex combination of the terms of b dominates `term`, decided by exact linear programming. By LP
    duality this is also necessary for ``term ≤ b``.
    """
    if len(b.terms) == 1:
        return False
    from sympy.solvers.simplex import InfeasibleLPError, linprog

    terms, names = sorted(b.terms), sorted(b.names | {name for name, _ in term[0]})
    slopes = [[-dict(t[0]).get(name, 0) for t in terms] for name in names]
    target = [-dict(term[0]).get(name, 0) for name in names]
    corner = [-sum(k for _, k in t[0]) * start - t[1] for t in terms]
    try:
        linprog(
            [0] * len(terms),
            [*slopes, corner],
            [*target, -sum(k for _, k in term[0]) * start - term[1]],
            [[1] * len(terms)],
            [1],
        )
    except InfeasibleLPError:
        return False
    return True


def parse_degree(text: str) -> Degree:
    """Parse a degree such as ``9d-6``, ``12(d−1)``, ``d1 + d2`` or ``max(d1, d2)``.

    >>> parse_degree("12(d-1)"), parse_degree("max(d1, d2)")
    (12d − 12, max(d2, d1))

    Raises `FormulaError` if the text is not a degree.
    """
    return _parsed(as_text(text, "a degree"))


@cache
def _parsed(text: str) -> Degree:
    source = text.replace("−", "-").replace(" ", "")
    if source.startswith("max(") and source.endswith(")"):
        return reduce(Degree.max, map(_parsed, source[4:-1].split(",")))
    if match := re.fullmatch(r"(\d+)\((.+)\)", source):
        inner = _parsed(match[2])
        return Degree((tuple((n, k * int(match[1])) for n, k in c), m * int(match[1])) for c, m in inner.terms)
    term: Term = ((), 0)
    for sign, number, name in re.findall(r"([+-]?)(\d*)([a-zA-Z]\w*)?", source):
        if number or name:
            k = int(number or 1) * (-1 if sign == "-" else 1)
            term = _plus(term, (((name, k),), 0) if name else ((), k))
    if not source or re.sub(r"[+-]?(\d+[a-zA-Z]\w*|\d+|[a-zA-Z]\w*)", "", source):
        raise FormulaError(f"{text!r} is not a degree", remedy='write for example "9d - 6" or "max(d1, d2)"')
    return Degree([term])


class _DifferentiatedPartByPart(Rational[Degree]):
    """A quotient whose derivative is counted as if numerator and denominator were differentiated separately. This is
    not a rule of Table 1 of the paper, but the way in which its equations (24) and (35) give γ′ the degree d − 1
    "either polynomial or rational".
    """

    __slots__ = ()

    def d(self, order: int = 1, *, by: str | None = None) -> _DifferentiatedPartByPart:
        """The quotient with the degrees of numerator and denominator lowered."""
        return _DifferentiatedPartByPart(self.numerator.d(order, by=by), self.denominator.d(order, by=by))


class DegreeReading(Reading):
    """The reading whose operands are degrees in one parameter: ``s`` of the first curve, ``s̄`` of the second curve,
    ``u`` or ``v`` of a surface. With the `counting` ``part by part``, a rational curve is differentiated as in eq. (24)
    of the paper of 2007. `degree` is the name of the degree of the curve.

    >>> from exactspline.language.kinds import PAIR
    >>> c = DegreeReading().argument(PAIR, 3)
    >>> (c.first.p.d(1) * c.second.w.d(1)).degree
    d − 1
    """

    name = "degree"

    def __init__(
        self,
        degree: str = "d",
        parameter: Parameter | str = Parameter.FIRST,
        counting: Counting | str = Counting.TABLE_1,
    ) -> None:
        self.degree = degree
        self.parameter = choice(Parameter, parameter, "parameter")
        self.counting = choice(Counting, counting, "counting")

    def count(self, formula: Formula, dimension: int, *, polynomial: bool = False) -> Degree:
        """Return the degree of a formula. For a value with several parts, this is the largest degree of a part.

        >>> from exactspline.papers import find
        >>> DegreeReading().count(find("g2"), 2)
        9d − 6
        """
        return cast(Degree, formula(self.argument(formula.kind, dimension, polynomial=polynomial)).degree)

    def argument(self, kind: Kind, dimension: int, *, polynomial: bool = False) -> Evaluated:
        """Return the degrees of the operands. Operands that do not depend on the parameter have degree 0."""
        parameter = self.parameter

        def operand(symbol: Symbol) -> Degree:
            if parameter not in symbol.parameters:
                return Degree.number(0, still=True, counted=parameter)
            if not symbol.degree:
                raise InapplicableError(f"{kind.name!r} has no degrees", remedy="ask for an identity")
            degree = symbol.degree_in(parameter)
            if degree.isidentifier():
                renamed = degree.startswith("d")  # the degree of the factor h of a hodograph is its own
                return Degree.named(self.degree + degree[1:] if renamed else degree, parameter)
            return Degree(parse_degree(degree).terms, counted=parameter)

        argument = kind.argument(dimension, operand, Degree.number(0, counted=parameter), polynomial=polynomial)
        if polynomial and isinstance(argument, Pair):
            uncounted = argument.first if parameter is Parameter.SECOND else argument.second
            uncounted.w = Degree.number(0, still=True, counted=parameter)
        if self.counting is Counting.PART_BY_PART:
            for curve in argument.together():
                if isinstance(curve, Curve) and not polynomial:
                    curve.gamma = _DifferentiatedPartByPart(curve.p, curve.w)
        return argument
