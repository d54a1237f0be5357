"""The constructions of the paper and the forms each can be computed in.

A construction is a name with formulas: ``naive`` as the algorithm computes it, ``paper`` as the paper reduces it, others by their own names;
``minimal`` is none of them but the naive form in lowest terms, found by exact division.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from exactspline.errors import FormulaError
from exactspline.factors import split, substitute
from exactspline.formulas import find
from exactspline.language import Curve, Formula, RuledSurface, Vector
from exactspline.measure import in_lowest_terms
from exactspline.quotients import Rational
from exactspline.readings.degree import Degree, parse
from exactspline.readings.fraction import JetFraction, fraction_argument, fraction_curve
from exactspline.readings.infinity import drop_of, expansion_argument, expansion_curve
from exactspline.readings.jet import Jet, jet_curve
from exactspline.readings.order import is_polynomial, order_of

MINIMAL = "minimal"


@dataclass(frozen=True)
class Construction:
    """A derived object: its name, its forms as names of formulas, and whether only its zero set matters (then a positive factor may go).

    A ruled surface is directrix and generator side by side; what its minimal form is, `exactspline.measure.in_lowest_terms` says.
    """

    name: str
    title: str
    curve: str
    forms: dict[str, str]
    zero_set: bool
    ruled: bool = False

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
            return in_lowest_terms(numerator(value)) if self.zero_set else joined(value)
        return numerator(value) if self.zero_set else joined(value)


CONSTRUCTIONS = {
    c.name: c
    for c in (
        Construction("zero_curvature", "zero curvature", "plane", {"naive": "f0", "paper": "f2"}, True),
        Construction(
            "critical_curvature", "critical curvature", "plane", {"direct": "g0", "squaring": "curvature_squared_derivative", "paper": "g2"}, True
        ),
        Construction("curvature_squared", "squared curvature", "plane", {"naive": "curvature_squared"}, False),
        Construction("evolute", "evolute", "plane", {"naive": "evolute", "paper": "evolute_reduced"}, False),
        Construction("zero_torsion", "zero torsion", "space", {"naive": "velocity_acceleration_jerk", "paper": "D1_D2_D3"}, True),
        Construction("torsion", "torsion", "space", {"naive": "torsion", "paper": "torsion_reduced"}, False),
        Construction("focal_curve", "focal curve", "space", {"naive": "focal_curve", "reduced": "focal_curve_reduced"}, False),
        Construction("circle_centres", "centres of the osculating circles", "space", {"naive": "osculating_circle_centre"}, False),
        Construction(
            "space_critical_curvature",
            "critical curvature of a space curve",
            "space",
            {"direct": "space_critical_curvature", "squaring": "space_curvature_squared_derivative", "reduced": "space_critical_curvature_reduced"},
            True,
        ),
        *(
            Construction(name, title, "space", {"naive": name, "paper": f"{name}_reduced"}, False, ruled=True)
            for name, title in (
                ("tangent_developable", "tangent developable"),
                ("binormal_scroll", "binormal scroll"),
                ("normal_scroll", "normal scroll"),
                ("rectifying_developable", "rectifying developable"),
                ("focal_surface", "focal surface"),
            )
        ),
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


def joined(value: Any) -> Any:
    """Of a ruled surface directrix and generator side by side, anything else as it is."""
    return value.joined if isinstance(value, RuledSurface) else value


def symbolic_minimum(c: Construction, dimension: int, *, polynomial: bool = False) -> Degree:
    """The true degree of the minimal form on the generic curve of degree d, for symbolic d: an upper bound on every curve.

    In the jet ring numerator and denominator lose their common factor; at infinity the leading terms that vanish are counted.

    >>> symbolic_minimum(construction("zero_curvature"), 2), symbolic_minimum(construction("critical_curvature"), 2)
    (3d − 6, 8d − 12)
    """
    orders = max(order_of(c.formula(form), dimension) for form in c.forms)
    jets = fraction_curve(dimension, orders, polynomial=polynomial)
    value = c.formula(MINIMAL)(jets)
    if isinstance(value, RuledSurface):
        at_infinity = ("curve", dimension, orders, polynomial)
        return _degree_of_quotient(list(value.directrix), *at_infinity).max(_degree_of_generator(c, value, dimension, polynomial))
    if not c.zero_set:
        return lowest_degree(c.formula(MINIMAL), dimension, polynomial=polynomial)
    parts, _ = split(value)
    form = next((c.formula(f) for f in c.forms if polynomial or is_polynomial(c.formula(f), dimension)), None)
    minimal = Vector(Jet(parts[0].ring, parts[0].top))
    if form is None:
        return _true_degree(minimal, "curve", dimension, orders, polynomial)
    return _degree_below(form, minimal, dimension, polynomial)


def lowest_degree(formula: Formula, dimension: int, *, polynomial: bool = False) -> Degree:
    """The degree of a formula in lowest terms on the generic argument of its kind, for symbolic d: an upper bound on every one.

    Of two curves the degree in the parameter of the first is meant.

    >>> lowest_degree(find("plane_bisector"), 2)
    4d − 2
    """
    order = order_of(formula, dimension)
    parts, _ = split(formula(fraction_argument(formula.curve, dimension, order, polynomial=polynomial)))
    return _degree_of_quotient(parts, formula.curve, dimension, order, polynomial)


def _degree_of_generator(c: Construction, surface: RuledSurface, dimension: int, polynomial: bool) -> Degree:
    """The degree of the generator as a primitive polynomial vector."""
    generator, _ = _over_common_denominator(list(surface.generator))
    common = generator[0].polynomial
    for jet in generator[1:]:
        common = common.gcd(jet.polynomial)
    last = c.formula(list(c.forms)[-1])

    def form(curve: Curve) -> Any:
        return numerator(last(curve).generator)

    return _degree_below(form, Vector(*[Jet(jet.ring, jet.polynomial / common) for jet in generator]), dimension, polynomial)


def _over_common_denominator(parts: list[JetFraction]) -> tuple[list[Jet], Jet]:
    """Numerators and least common denominator of jet fractions."""
    denominator = parts[0].bottom
    for part in parts[1:]:
        denominator = denominator * (part.bottom / denominator.gcd(part.bottom))
    return [Jet(part.ring, part.top * (denominator / part.bottom)) for part in parts], Jet(parts[0].ring, denominator)


def _degree_of_quotient(parts: list[JetFraction], kind: str, dimension: int, order: int, polynomial: bool) -> Degree:
    """The larger of the true degrees of numerators and denominator."""
    tops, denominator = _over_common_denominator(parts)
    numerators = _true_degree(Vector(*tops), kind, dimension, order, polynomial)
    if denominator.polynomial.total_degree() <= 0:
        return numerators
    return numerators.max(_true_degree(Vector(denominator), kind, dimension, order, polynomial))


def _degree_below(form: Callable[[Curve], Any], minimal: Vector, dimension: int, polynomial: bool) -> Degree:
    """The degree of a polynomial form less that of the factor by which it exceeds the minimal one: cheaper than expanding the minimal form."""
    ring, curve = minimal[0].ring, jet_curve(dimension, minimal[0].ring.order, polynomial=polynomial)
    exceeding = form(curve)
    pairs = zip(exceeding if isinstance(exceeding, Vector) else [exceeding], minimal, strict=True)
    excess = next(Jet(ring, top.polynomial / least.polynomial) for top, least in pairs if least.polynomial)
    k, m, drop, _ = drop_of(form, lambda terms: expansion_curve(dimension, terms, polynomial=polynomial), "the form")
    if excess.polynomial.total_degree() <= 0:
        return parse(f"{k}d-{m + drop}")

    def factor(expansion: Curve) -> Any:
        return substitute(excess, expansion)

    less_k, less_m, less_drop, _ = drop_of(factor, lambda terms: expansion_curve(dimension, terms, polynomial=polynomial), "the factor")
    return parse(f"{k - less_k}d-{m + drop - less_m - less_drop}")


def _true_degree(jets: Vector, kind: str, dimension: int, order: int, polynomial: bool) -> Degree:
    def reading(expansion: Any) -> Vector:
        return Vector(*[substitute(jet, expansion) for jet in jets])

    k, m, drop, _ = drop_of(reading, lambda terms: expansion_argument(kind, dimension, terms, order, polynomial=polynomial), "the minimal form")
    return parse(f"{k}d-{m + drop}") if k else Degree.number(-m - drop)
