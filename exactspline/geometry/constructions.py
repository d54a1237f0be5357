"""The constructions of the paper and the forms each can be computed in.

A construction is a name with formulas: ``naive`` as the algorithm computes it, ``paper`` as the paper reduces it,
others by their own names, ``lifted`` from the lifts of the curve. ``minimal`` is the lifted form after division by
whatever the curve at hand allows: the naive variant in lowest terms.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache

from exactspline.errors import FormulaError, nearest
from exactspline.language.arguments import Curve
from exactspline.language.formula import Formula
from exactspline.language.parts import joined, numerator
from exactspline.papers import default_papers, find
from exactspline.splines.bspline import BSpline
from exactspline.splines.lowest_terms import in_lowest_terms, primitive, without_factor
from exactspline.splines.values import SplineVector
from exactspline.splines.wronskian import lowest_wronskian
from exactspline.symbolic.factorization import Factor, find_factor, jets_for

LIFTED = "lifted"
MINIMAL = "minimal"


@dataclass(frozen=True)
class Construction:
    """A derived object: its name, its variants as names of formulas, and whether only its zero set matters (then a
    positive factor may go).

    A ruled surface is directrix and generator side by side; what its minimal form is,
    `exactspline.splines.lowest_terms.in_lowest_terms` says.
    """

    name: str
    title: str
    curve: str
    variants: dict[str, str]
    zero_set: bool = False
    ruled: bool = False
    #: The lift whose Wronskian the lifted form is.
    wronskian_of: str = ""

    @property
    def all_variants(self) -> tuple[str, ...]:
        """The names of the variants, the lowest last."""
        return (*self.variants, MINIMAL)

    @property
    def unlifted(self) -> dict[str, str]:
        """The variants that make no use of a lift."""
        return {name: formula for name, formula in self.variants.items() if name != LIFTED}

    @property
    def lifted(self) -> str:
        """The name of the lifted variant's formula."""
        return self.variants[LIFTED]

    def formula(self, variant: str) -> Formula:
        """The formula of a variant; the minimal one is made from the lifted one."""
        if variant not in self.all_variants:
            raise FormulaError(
                f"{self.name} has no variant {variant!r}", remedy=f"variants are {', '.join(self.all_variants)}"
            )
        return find(self.variants.get(variant, self.lifted))

    @property
    def dimension(self) -> int:
        """That of the curves it speaks of."""
        return {"plane": 2, "space": 3}[self.curve]

    def on(self, curve: Curve[BSpline], variant: str) -> BSpline | SplineVector:
        """The object on a curve; of a zero-set problem the numerator alone.

        The minimal form of a zero-set problem has the sign of the first form, whatever the sign of w, and loses the
        factors it shares with w; where there are none it is as continuous as the lifted form. A quotient is reduced
        segment by segment.
        """
        if variant != MINIMAL:
            value = self.formula(variant)(curve)
            taken: BSpline | SplineVector = numerator(value) if self.zero_set else joined(value)
            return taken
        if not self.zero_set:
            reduced: BSpline | SplineVector = joined(in_lowest_terms(self.formula(variant)(curve)))
            return reduced
        at_once = self.wronskian_of and not curve.polynomial
        value = lowest_wronskian(find(self.wronskian_of)(curve)) if at_once else self.formula(variant)(curve)
        power = self.power_of_w(LIFTED)
        return primitive(in_lowest_terms(without_factor(value.scaled(self.sign(curve, LIFTED)), curve.w, power)))

    def power_of_w(self, variant: str) -> int:
        """The e with ``form = constant · wᵉ · first form`` and a positive constant, of a zero-set problem."""
        factor = _factor(self.formula(variant).name, next(iter(self.variants.values())), self.dimension)
        if factor is None or not factor.names <= {"w"} or factor.constant < 0:
            raise FormulaError(
                f"the form {variant!r} of {self.name} is no power of w away from the first",
                remedy="its sign is another one",
            )
        return next((e for _, _, e in factor.powers), 0)

    def sign(self, curve: Curve[BSpline], variant: str) -> int:
        """The sign of a form where the first form is positive: −1 for an odd power of a negative w."""
        return -1 if self.power_of_w(variant) % 2 and curve.w(curve.w.domain[0]) < 0 else 1


@cache
def _factor(left: str, right: str, dimension: int) -> Factor | None:
    jets = jets_for((left, right), dimension)
    return find_factor(find(left)(jets), find(right)(jets))


@cache
def all_constructions() -> dict[str, Construction]:
    """Every construction that a paper declares, with the variants that later papers add to it."""
    made: dict[str, Construction] = {}
    for source in default_papers():
        for name, table in source.construction_tables().items():
            entry = dict(table.entry)
            variants = {v: source.find(f).name for v, f in entry.pop("variants").items()}
            if name in made:
                made[name] = replace(made[name], variants=made[name].variants | variants, **entry)
            else:
                made[name] = Construction(name, variants=variants, **entry)
    return made


def construction(name: str) -> Construction:
    """The construction with this name.

    >>> construction("evolute").variants
    {'naive': 'evolute', 'paper': 'evolute_reduced', 'lifted': 'evolute_lifted'}

    Raises `FormulaError` with the names there are.
    """
    if name not in all_constructions():
        raise FormulaError(
            f"no construction is called {name!r}",
            remedy=nearest(name, all_constructions(), listed_by="exactspline derive"),
        )
    return all_constructions()[name]


def constructions_for(dimension: int) -> list[Construction]:
    """The constructions that curves of this dimension have."""
    return [c for c in all_constructions().values() if c.curve == {2: "plane", 3: "space"}.get(dimension)]
