"""The constructions of the paper and the forms each can be computed in.

A construction is a name with formulas: ``naive`` as the algorithm computes it, ``paper`` as the paper reduces it, others by their own names;
``minimal`` is none of them but the naive form in lowest terms, found by exact division.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from exactspline.errors import FormulaError
from exactspline.factors import split, substitute
from exactspline.formulas import find
from exactspline.language import Curve, Formula, Vector
from exactspline.measure import in_lowest_terms
from exactspline.quotients import Rational
from exactspline.readings.degree import Degree, parse
from exactspline.readings.infinity import drop_of, expansion_curve
from exactspline.readings.jet import Jet, jet_curve
from exactspline.readings.order import order_of

MINIMAL = "minimal"


@dataclass(frozen=True)
class Construction:
    """A derived object: its name, its forms as names of formulas, and whether only its zero set matters (then a positive factor may go)."""

    name: str
    title: str
    curve: str
    forms: dict[str, str]
    zero_set: bool

    def formula(self, form: str) -> Formula:
        """The formula of a form; the minimal one is made from the first."""
        if form not in self.forms and form != MINIMAL:
            raise FormulaError(f"{self.name} has no form {form!r}", remedy=f"forms are {', '.join([*self.forms, MINIMAL])}")
        return find(self.forms.get(form) or next(iter(self.forms.values())))

    def on(self, curve: Any, form: str) -> Any:
        """The object on a curve; of a zero-set problem the numerator alone."""
        value = self.formula(form)(curve)
        if form == MINIMAL:
            value = in_lowest_terms(value)
            return in_lowest_terms(numerator(value)) if self.zero_set else value
        return numerator(value) if self.zero_set else value


CONSTRUCTIONS = {
    c.name: c
    for c in (
        Construction("zero_curvature", "zero curvature", "plane", {"naive": "f0", "paper": "f2"}, True),
        Construction(
            "critical_curvature", "critical curvature", "plane", {"direct": "g0", "squaring": "curvature_squared_derivative", "paper": "g2"}, True
        ),
        Construction("curvature_squared", "squared curvature", "plane", {"naive": "curvature_squared"}, False),
        Construction("evolute", "evolute", "plane", {"naive": "evolute", "paper": "evolute_reduced"}, False),
    )
}


def construction(name: str) -> Construction:
    """The construction with this name.

    >>> construction("evolute").forms
    {'naive': 'evolute', 'paper': 'evolute_reduced'}

    Raises `FormulaError` with the names there are.
    """
    if name not in CONSTRUCTIONS:
        raise FormulaError(f"no construction is called {name!r}", remedy=f"there are {', '.join(CONSTRUCTIONS)}")
    return CONSTRUCTIONS[name]


def constructions_for(dimension: int) -> list[Construction]:
    """The constructions that curves of this dimension have."""
    return [c for c in CONSTRUCTIONS.values() if c.curve == {2: "plane", 3: "space"}.get(dimension)]


def numerator(value: Any) -> Any:
    """The numerator of a quotient, anything else as it is."""
    return value.numerator if isinstance(value, Rational) else value


def symbolic_minimum(c: Construction, dimension: int, *, polynomial: bool = False) -> Degree:
    """The true degree of the minimal form on the generic curve of degree d, for symbolic d: an upper bound on every curve.

    In the jet ring numerator and denominator lose their common factor; at infinity the leading terms that vanish are counted.

    >>> symbolic_minimum(construction("zero_curvature"), 2), symbolic_minimum(construction("critical_curvature"), 2)
    (3d − 6, 8d − 12)
    """
    formula = c.formula(MINIMAL)
    jets = jet_curve(dimension, order_of(formula, dimension), polynomial=polynomial)
    parts, denominator = split(formula(jets))
    everything = parts if denominator is None else [*parts, denominator]
    common = everything[0].polynomial
    if denominator is not None:
        for part in everything[1:]:
            common = common.gcd(part.polynomial)
        everything = [Jet(part.ring, part.polynomial / common) for part in everything]
    kept = everything[: len(parts)] if c.zero_set else everything
    degrees = [_true_degree(Vector(*kept[: len(parts)]), dimension, polynomial)]
    degrees += [_true_degree(Vector(kept[-1]), dimension, polynomial)] if len(kept) > len(parts) else []
    return degrees[0] if len(degrees) == 1 else degrees[0].max(degrees[1])


def _true_degree(jets: Vector, dimension: int, polynomial: bool) -> Degree:
    def reading(expansion: Curve) -> Vector:
        return Vector(*[substitute(jet, expansion) for jet in jets])

    k, m, drop, _ = drop_of(reading, lambda terms: expansion_curve(dimension, terms, polynomial=polynomial), "the minimal form")
    return parse(f"{k}d-{m + drop}") if k else Degree.number(-m - drop)
