"""The zeros of formulas, for all curves: the irreducible factors of a value, or of its numerator as written, that may
have zeros under the assumptions. On every curve the order of a zero is the sum of the orders of these factors.

The components of a vector are real, so that the vector vanishes at the zeros of the sum of their squares, whose orders
are doubled. So do multiples of the roots of a frame: only squares are factored, and exponents are counted twice.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from math import gcd
from typing import Any, cast

from flint import fmpq_mpoly

from exactspline.errors import ExactSplineError, FormulaError, ReachError
from exactspline.language.adjoined_root import Adjoined
from exactspline.language.arguments import Evaluated
from exactspline.language.formula import Formula
from exactspline.language.kinds import FramedKind
from exactspline.language.ruled import Value, split
from exactspline.numbers.exact import mpq
from exactspline.polynomials.factors import Factorization, factorize
from exactspline.readings.jet import Jet, JetFraction, JetRing, terms_of
from exactspline.readings.printing import Operation
from exactspline.readings.tree import Node, nodes, trace
from exactspline.symbolic.assumptions import Assumption, zero_free
from exactspline.symbolic.factorization import Factor, Named, factored, naming_formulas
from exactspline.verification.divisors import Evaluation
from exactspline.verification.evidence import MayVanish
from exactspline.verification.vocabulary import Name


def squared(value: Value) -> Factor | None:
    """The sum of the squares of the components of a nonzero value of jet fractions, in factors; None if the roots of a
    frame do not cancel.

    >>> from exactspline.papers import find
    >>> from exactspline.symbolic.factorization import jets_for
    >>> c = jets_for(("D1", "f2"), 2)
    >>> [str(squared(find(name)(c))) for name in ("D1", "f2")]
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


def have_one_zero_set(exponents: Sequence[Sequence[int]]) -> bool:
    """Whether products of powers vanish together for all possible orders of their bases at a point. Without
    denominators, their bases must be the same; otherwise the exponents must be proportional, since zeros may cancel.

    >>> have_one_zero_set([(1, 2), (3, 1)]), have_one_zero_set([(1, 0), (1, 1)]), have_one_zero_set([(1, -1), (2, -2)])
    (True, False, True)
    >>> [have_one_zero_set([(1, -1), other]) for other in [(1, 0), (1, -2), (0, -1)]]
    [False, False, False]
    """

    def kind(powers: Sequence[int]) -> tuple[int, ...]:
        if min(powers, default=0) >= 0 or max(powers) <= 0:
            return tuple(int(e > 0) for e in powers)
        return tuple(e // gcd(*powers) for e in powers)

    return len({kind(powers) for powers in exponents}) == 1


def may_vanish(factor: Factor, zero_free: Callable[[Jet], bool]) -> list[Named]:
    """The irreducible parts of a factor that may have zeros."""
    return [base for base, _ in factor.powers if not zero_free(Jet(factor.ring, base.polynomial))]


def excluded_by(guilty: Iterable[Named], ring: JetRing, find: Callable[[str], Formula]) -> MayVanish:
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
            with suppress(
                ExactSplineError
            ):  # an assumption of another paper, whose formulas claims of this paper cannot name
                assume += [Name(f"{f.name} ≠ 0") for f in naming_formulas(alone) if find(f.name) is f][:1]
    return MayVanish(tuple(dict.fromkeys(names)), tuple(dict.fromkeys(assume)))


class ZeroFree:
    """Which irreducible polynomials have no zero: by assumption, or because they are sums of squares, one of which has
    no zero: term by term, or as divisors of the numerator of a value in the formulas that is such a sum over
    denominators without zeros.

    `used` are the names of the assumptions that were needed since the list was last emptied.
    """

    def __init__(
        self, formulas: Iterable[Formula], c: Evaluated, dimension: int, assumed: Iterable[Assumption]
    ) -> None:
        self.assumed, self.used = tuple(assumed), list[Name]()
        self._value, self._positive = Evaluation(c), list[tuple[fmpq_mpoly, list[Name]]]()
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
