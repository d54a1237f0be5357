"""The constructions of the paper and the forms each can be computed in.

A construction is a name with formulas: ``naive`` as the algorithm computes it, ``paper`` as the paper reduces it, others by their own names,
``lifted`` from the lifts of the curve. ``minimal`` is the lifted form after division by whatever the curve at hand allows: the naive form in lowest
terms.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

from exactspline.covariants import degree_at, generic_degree, truncated, without_content
from exactspline.errors import FormulaError
from exactspline.factors import Factor, find_factor, jets_for
from exactspline.formulas import find
from exactspline.language import Formula, RuledSurface
from exactspline.measure import in_lowest_terms, primitive, without_factor
from exactspline.quotients import Rational
from exactspline.readings.degree import Degree
from exactspline.readings.jet import Jet
from exactspline.reduce import Reduction, reduction
from exactspline.transvectants import lowest_wronskian

LIFTED = "lifted"
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
    lifted: str
    ruled: bool = False
    #: The lift whose Wronskian the lifted form is.
    wronskian_of: str = ""

    @property
    def all_forms(self) -> tuple[str, ...]:
        """The names of the forms, the lowest last."""
        return (*self.forms, LIFTED, MINIMAL)

    def formula(self, form: str) -> Formula:
        """The formula of a form; the minimal one is made from the lifted one."""
        if form not in self.all_forms:
            raise FormulaError(f"{self.name} has no form {form!r}", remedy=f"forms are {', '.join(self.all_forms)}")
        return find(self.forms.get(form, self.lifted))

    @property
    def dimension(self) -> int:
        """That of the curves it speaks of."""
        return {"plane": 2, "space": 3}[self.curve]

    def on(self, curve: Any, form: str) -> Any:
        """The object on a curve; of a zero-set problem the numerator alone.

        The minimal form of a zero-set problem has the sign of the first form, whatever the sign of w, and loses the factors it shares with w; where
        there are none it is as continuous as the lifted form. A quotient is reduced segment by segment.
        """
        if form != MINIMAL:
            value = self.formula(form)(curve)
            return numerator(value) if self.zero_set else joined(value)
        if not self.zero_set:
            return joined(in_lowest_terms(self.formula(form)(curve)))
        at_once = self.wronskian_of and not curve.polynomial
        value = lowest_wronskian(find(self.wronskian_of)(curve)) if at_once else self.formula(form)(curve)
        power = self.power_of_w(LIFTED)
        return primitive(in_lowest_terms(without_factor(value.scaled(self.sign(curve, LIFTED)), curve.w, power)))

    def power_of_w(self, form: str) -> int:
        """The e with ``form = constant · wᵉ · first form`` and a positive constant, of a zero-set problem."""
        factor = _factor(self.formula(form).name, next(iter(self.forms.values())), self.dimension)
        if factor is None or not factor.names <= {"w"} or factor.constant < 0:
            raise FormulaError(f"the form {form!r} of {self.name} is no power of w away from the first", remedy="its sign is another one")
        return next((e for _, _, e in factor.powers), 0)

    def sign(self, curve: Any, form: str) -> int:
        """The sign of a form where the first form is positive: −1 for an odd power of a negative w."""
        return -1 if self.power_of_w(form) % 2 and curve.w(curve.w.domain[0]) < 0 else 1


@cache
def _factor(left: str, right: str, dimension: int) -> Factor | None:
    jets = jets_for((left, right), dimension)
    return find_factor(find(left)(jets), find(right)(jets))


#: The lifts, by the names of their formulas.
P, X = "projective_lift", "conformal_lift"

CONSTRUCTIONS = {
    c.name: c
    for c in (
        Construction("zero_curvature", "zero curvature", "plane", {"naive": "f0", "paper": "f2"}, True, "inflections_lifted", wronskian_of=P),
        Construction(
            "critical_curvature",
            "critical curvature",
            "plane",
            {"direct": "g0", "squaring": "curvature_squared_derivative", "paper": "g2"},
            True,
            "vertices_lifted",
            wronskian_of=X,
        ),
        Construction("curvature_squared", "squared curvature", "plane", {"naive": "curvature_squared"}, False, "curvature_squared_lifted"),
        Construction("evolute", "evolute", "plane", {"naive": "evolute", "paper": "evolute_reduced"}, False, "evolute_lifted"),
        Construction(
            "zero_torsion",
            "zero torsion",
            "space",
            {"naive": "velocity_acceleration_jerk", "paper": "D1_D2_D3"},
            True,
            "torsion_zeros_lifted",
            wronskian_of=P,
        ),
        Construction("torsion", "torsion", "space", {"naive": "torsion", "paper": "torsion_reduced"}, False, "torsion_lifted"),
        Construction("focal_curve", "focal curve", "space", {"naive": "focal_curve", "reduced": "focal_curve_reduced"}, False, "focal_curve_lifted"),
        Construction(
            "circle_centres", "centres of the osculating circles", "space", {"naive": "osculating_circle_centre"}, False, "circle_centre_lifted"
        ),
        Construction(
            "space_critical_curvature",
            "critical curvature of a space curve",
            "space",
            {"direct": "space_critical_curvature", "squaring": "space_curvature_squared_derivative", "reduced": "space_critical_curvature_reduced"},
            True,
            "space_critical_curvature_lifted",
        ),
        *(
            Construction(name, title, "space", {"naive": name, "paper": f"{name}_reduced"}, False, f"{name}_lifted", ruled=True)
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
    """The true degree of the minimal form on the generic curve of degree d, for symbolic d: no curve has a higher one.

    In the jet ring numerator and denominator lose their common factor; the degree theorem (`exactspline.covariants`) does the rest.

    >>> symbolic_minimum(construction("zero_curvature"), 2), symbolic_minimum(construction("critical_curvature"), 2)
    (3d − 6, 8d − 12)
    """
    found = reduction(c.lifted, dimension, polynomial)
    if c.ruled:
        return found.parts[0].generic_lowest.max(found.main.generic)
    return generic_degree(found.main.lowest[0]) if c.zero_set else found.main.generic_lowest


def lowest_degree(formula: Formula, dimension: int, *, polynomial: bool = False) -> Degree:
    """The degree of a formula in lowest terms on the generic argument of its kind, for symbolic d: an upper bound on every one.

    Of two curves the degree in the parameter of the first is meant.

    >>> lowest_degree(find("plane_bisector"), 2)
    4d − 2
    """
    numerator, denominator = _joined(reduction(formula.name, dimension, polynomial))
    return generic_degree([jet for jet in (*numerator, denominator) if not jet.is_zero and jet.polynomial.total_degree() > 0])


def _joined(found: Reduction) -> tuple[list[Jet], Jet]:
    """All components of all parts over the least common denominator."""
    denominator = found.parts[0].lowest[1]
    for part in found.parts[1:]:
        other = part.lowest[1]
        denominator = Jet(other.ring, denominator.polynomial * (other.polynomial / denominator.polynomial.gcd(other.polynomial)))
    lifts = [(part.lowest[0], Jet(denominator.ring, denominator.polynomial / part.lowest[1].polynomial)) for part in found.parts]
    return [jet * lift for top, lift in lifts for jet in top], denominator


def minimum_at(c: Construction, d: int, *, polynomial: bool = False) -> int | None:
    """The true degree of the minimal form on the generic curve of one degree d, also below the order of the formula: −1 for 0, None for 0/0.

    >>> minimum_at(construction("torsion"), 3), minimum_at(construction("torsion"), 2), minimum_at(construction("focal_curve"), 2)
    (6, -1, None)
    """
    found = reduction(c.lifted, c.dimension, polynomial)
    numerator, denominator = found.parts[0].lowest
    top, (bottom,) = truncated(numerator, d), truncated([denominator], d)
    if bottom.is_zero:
        return None
    if c.ruled:
        generator = truncated(found.main.reduced, d)
        if all(jet.is_zero for jet in generator):
            return None
        return max(degree_at(without_content([*top, bottom]), d), degree_at(without_content(generator), d))
    if all(jet.is_zero for jet in top):
        return -1
    if not c.zero_set:
        return degree_at(without_content([*top, bottom]), d)
    shared = bottom.ring.number(1) if polynomial else bottom.ring["w"] ** c.power_of_w(LIFTED)
    return degree_at(without_content([top[0], shared])[:1], d)
