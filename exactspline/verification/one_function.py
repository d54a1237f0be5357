"""Formulas that ran unchecked, typed at the prompt or from trusted files. A formula that counts its calls, draws random
numbers or asks for the types of its operands is not a function of a curve, and it is refused.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from typing import Any

from exactspline.errors import ExactSplineError, FormulaError, InapplicableError, VanishingDivisorError
from exactspline.interchange.examples import example, example_surface
from exactspline.language.adjoined_root import Adjoined
from exactspline.language.arguments import Evaluated
from exactspline.language.formula import Formula
from exactspline.language.operand import Operand
from exactspline.language.ruled import split
from exactspline.polynomials.cost import Budget, drawing_on
from exactspline.readings.differential_order import order_of
from exactspline.readings.jet import InOtherParameter, Jet, JetFraction, JetRing
from exactspline.symbolic.factorization import jets_for
from exactspline.symbolic.substitution import substitute
from exactspline.verification.evaluation import argument

#: A rational and a polynomial example on which values are compared, by dimension: curves and surfaces.
CURVES = {2: ("rational_cubic", "cubic_s"), 3: ("rational_space_cubic", "flat_point")}
SURFACES = {2: ("planar_map", "folded_map"), 3: ("rational_biquadratic", "bicubic")}


class _SeveralValuesError(FormulaError):
    """A formula that has several values for one argument."""


def expect_functions(formulas: Iterable[Formula], dimension: int, *, polynomial: bool = False) -> None:
    """`expect_one_function` of each formula, on an indeterminate argument of its own."""
    for each in formulas:
        if not each.checked:
            n = dimension if dimension in each.kind.dimensions else each.kind.dimensions[0]
            expect_one_function(each, jets_for((each,), n, polynomial=polynomial))


def expect_one_function(formula: Formula, c: Evaluated) -> None:
    """Refuse a formula whose value on an indeterminate argument differs in a second evaluation, for the same operands
    in another class (that of curves with a second parameter), or on examples of splines.

    Raises `FormulaError`, naming the formula, for different values, and for a formula without a value.
    """
    if formula.checked:
        return
    _expect_same_again(formula, c)
    found = split(formula(c))[0]
    rings = [x.ring for x in map(_inner, c.operands().values()) if isinstance(x, JetFraction)]
    try:
        for ring in rings[:1]:
            if found != [unwrapped(x) for x in split(formula(_in_another_class(ring)))[0]]:
                raise _several(formula)
            if not all(_same_on(found, formula, each) for each in _examples(ring)):
                raise _several(formula)
    except (TypeError, AttributeError, IndexError):  # values of other shapes, or attributes that only one class has
        raise _several(formula) from None


def _expect_same_again(formula: Formula, c: Evaluated) -> None:
    """Refuse an unchecked formula whose value differs when it is evaluated again, or is a plain number.

    Raises `FormulaError`, naming the formula.
    """
    if not formula.checked:
        order_of(formula, formula.kind.dimensions[0])
    if not formula.checked and split(formula(c)) != split(formula(c.copied())):
        raise _several(formula)


def expect_functions_on(formulas: Iterable[Formula], c: Evaluated | None, dimension: int, polynomial: bool) -> None:
    """Refuse, where claims are decided on one curve or surface, a formula that `expect_functions` refuses, or that has
    another value there (on `c`, if one is given) in a second evaluation.

    Raises `FormulaError`, naming the formula.
    """
    for each in formulas:
        if not each.checked:
            if several := _refusal(each, dimension, polynomial):
                raise several
            if c is not None:
                _expect_same_again(each, c)


@cache
def _refusal(formula: Formula, dimension: int, polynomial: bool) -> _SeveralValuesError | None:
    """The reason why a formula is refused on all curves; None if it is not refused, or if the check exceeds its
    budget.
    """
    try:
        with drawing_on(Budget()):
            expect_functions((formula,), dimension, polynomial=polynomial)
    except _SeveralValuesError as error:
        return error
    except ExactSplineError:
        return None
    return None


def _several(formula: Formula) -> _SeveralValuesError:
    return _SeveralValuesError(
        f"{formula.name} has several values for one argument: in a second evaluation, or in another reading",
        where=formula.source,
        remedy="compute with the argument alone: no counters, no random numbers, no questions about types",
    )


def _in_another_class(ring: JetRing) -> Evaluated:
    one = JetFraction(ring, ring.context.constant(1), ring.context.constant(1))

    def operand(jet: Jet) -> InOtherParameter:
        return InOtherParameter(JetFraction(ring, jet.polynomial, one.bottom), one)

    named, unit = (lambda symbol: operand(ring[symbol.name])), operand(ring.number(1))
    return ring.kind.argument(ring.dimension, named, unit, polynomial=ring.polynomial)


def _inner(x: Any) -> Any:
    return _inner(x.plain) if isinstance(x, Adjoined) else x


def unwrapped(x: Operand) -> Operand:
    """A value in the class of the indeterminates, with the same roots adjoined."""
    if isinstance(x, Adjoined):
        return Adjoined(*map(unwrapped, (x.plain, x.rooted, x.square)))
    return x.value if isinstance(x, InOtherParameter) else x


def _examples(ring: JetRing) -> list[Evaluated]:
    """Arguments on examples; empty if roots are adjoined, and for kinds for which one curve or surface is not an
    argument.
    """
    kind = ring.kind
    if kind.adjoins_roots or not (kind.made_of_a_curve or kind.made_of_a_surface):
        return []
    names, read = (SURFACES, example_surface) if kind.made_of_a_surface else (CURVES, example)
    try:
        return [argument(kind.name, read(name)).argument for name in names[ring.dimension][ring.polynomial :]]
    except InapplicableError:
        return []


def _same_on(found: list[Any], formula: Formula, given: Any) -> bool:
    """Whether the value of a formula on an example is its value for indeterminates; true if it does not exist there."""
    try:
        components, below = split(formula(given))
    except VanishingDivisorError:
        return True

    def agree(x: Any, general: Any) -> bool:
        if not isinstance(general, JetFraction):
            return bool(x == general)
        top, bottom = (substitute(Jet(general.ring, part), given) for part in (general.top, general.bottom))
        return bool(x * bottom == (top if below is None else top * below))

    return len(components) == len(found) and all(map(agree, components, found))
