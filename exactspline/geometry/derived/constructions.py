"""The constructions of the paper (Chen, Riesenfeld and Cohen 2007), and the forms in which each can be computed.

A construction is a name with variants, each of which is a formula: ``naive`` as the algorithm computes it, ``paper`` as
the paper reduces it, ``lifted`` from the lifts of the curve, others by their own names. ``minimal`` is the lifted form
after division by all common factors on the given curve: the naive variant in lowest terms.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import cache
from typing import cast

from exactspline.errors import FormulaError, as_text, nearest, shown
from exactspline.language.arguments import Curve
from exactspline.language.formula import Formula
from exactspline.language.kinds import kind_of
from exactspline.language.ruled import joined, numerator
from exactspline.one_line import one_line
from exactspline.papers import default_papers, find
from exactspline.splines.bspline import BSpline
from exactspline.splines.lowest_terms import SplineValue, SplineVector, in_lowest_terms, primitive, without_factor
from exactspline.symbolic.factorization import find_factor, jets_for
from exactspline.words import Word, choice

#: A function that evaluates formulas on a curve.
Values = Callable[[Formula], SplineValue]


class Variant(Word):
    """A method by which a construction is computed."""

    #: As the algorithm computes it.
    NAIVE = "naive"
    #: Critical curvature by the derivative of the squared curvature, and by the derivative of the curvature.
    SQUARING = "squaring"
    DIRECT = "direct"
    #: As the paper reduces it, and in a reduced form that the paper does not print.
    PAPER = "paper"
    REDUCED = "reduced"
    #: From the lifts of the curve, and then divided by all common factors on the given curve.
    LIFTED = "lifted"
    MINIMAL = "minimal"


class Absence(StrEnum):
    """Why a derived object does not exist on a whole piece of a curve."""

    STRAIGHT = "straight"
    PLANAR = "planar"
    STILL = "still"
    #: The reason is not known.
    DENOMINATOR = "denominator"

    @property
    def words(self) -> str:
        """The reason in words."""
        return {
            Absence.STRAIGHT: "the curvature vanishes identically (straight segments)",
            Absence.PLANAR: "the torsion vanishes identically (segments in planes)",
            Absence.STILL: "the velocity vanishes identically (the curve stands still)",
        }.get(self, "the denominator vanishes identically")


@dataclass(frozen=True)
class Construction:
    """A derived object: its name, its variants as names of formulas, and whether only its zero set matters (then
    positive factors may be dropped).

    A ruled surface is given by its directrix and its generator; its minimal form is defined in
    `exactspline.splines.lowest_terms.in_lowest_terms`.
    """

    name: str
    title: str
    curve: str
    variants: dict[Variant, str]
    zero_set: bool = False
    ruled: bool = False
    #: The formula of the minimal form, if this is not the lifted form.
    lowest: str = ""

    @one_line
    def __repr__(self) -> str:
        return f"<Construction {self.name} of a {self.curve} curve>"

    @property
    def all_variants(self) -> tuple[Variant, ...]:
        """The names of the variants, the one of lowest degree last."""
        return (*self.variants, Variant.MINIMAL)

    @property
    def unlifted(self) -> dict[Variant, str]:
        """The variants that do not use a lift."""
        return {name: formula for name, formula in self.variants.items() if name != Variant.LIFTED}

    @property
    def lifted(self) -> str:
        """The name of the lifted variant's formula."""
        return self.variants[Variant.LIFTED]

    def formula(self, variant: Variant | str) -> Formula:
        """The formula of a variant; the minimal one is made from `lowest`, or from the lifted one."""
        if not isinstance(variant, str) or variant not in self.all_variants:
            raise FormulaError(
                f"{self.name} has no variant {shown(variant)}", remedy=f"variants are {', '.join(self.all_variants)}"
            )
        return find(self.variants.get(Variant(variant), self.lowest or self.lifted))

    @property
    def dimension(self) -> int:
        """The dimension of the space in which its curves lie."""
        return kind_of(self.curve).dimensions[0]

    def on(
        self,
        curve: Curve[BSpline],
        variant: Variant | str,
        value_of: Values | None = None,
        lowest_of: Values | None = None,
    ) -> BSpline | SplineVector:
        """The form of a zero-set problem on a curve, or the value of another construction; the minimal value is reduced
        segment by segment. `value_of` evaluates formulas on the curve, `lowest_of` at their true degree.
        """
        if self.zero_set:
            return self.form_on(curve, variant, value_of, lowest_of)
        value = (value_of or (lambda formula: formula(curve)))(self.formula(variant))
        return cast("BSpline | SplineVector", joined(in_lowest_terms(value) if variant == Variant.MINIMAL else value))

    def form_on(
        self,
        curve: Curve[BSpline],
        variant: Variant | str,
        value_of: Values | None = None,
        lowest_of: Values | None = None,
    ) -> BSpline:
        """The form whose zeros a zero-set problem asks for: the numerator of a variant, or the minimal form."""
        value_of = value_of or (lambda formula: formula(curve))
        if variant == Variant.MINIMAL:
            return self._minimal_form(curve, lowest_of or value_of)
        return cast(BSpline, numerator(value_of(self.formula(variant))))

    def _minimal_form(self, curve: Curve[BSpline], value_of: Values) -> BSpline:
        """The form with the sign of the first variant, whatever the sign of w, without factors in common with w; where
        there are no such factors, its continuity is that of the lifted form.
        """
        power, form = self.power_of_w(Variant.MINIMAL), value_of(self.formula(Variant.MINIMAL))
        assert isinstance(form, BSpline)
        if power % 2 and curve.w.numerators[0][0] < 0:
            form = -form
        return primitive(in_lowest_terms(without_factor(form, curve.w, power)))

    def power_of_w(self, variant: Variant | str) -> int:
        """The e with ``form = constant · wᵉ · first form`` and a positive constant, of a zero-set problem."""
        first = next(iter(self.variants.values()))
        return _power_of_w(self.formula(variant).name, self.name, first, self.dimension)


@cache
def _power_of_w(form: str, construction: str, first: str, dimension: int) -> int:
    jets = jets_for((form, first), dimension)
    factor = find_factor(find(form)(jets), find(first)(jets))
    if factor is None or not factor.names <= {"w"} or factor.constant < 0:
        problem = f"the form {form!r} of {construction} is not the first form times a power of w"
        raise FormulaError(problem, remedy="its sign cannot be derived from the first form's")
    return next((e for _, e in factor.powers), 0)


@cache
def all_constructions() -> dict[str, Construction]:
    """Every construction that a paper declares, with the variants that later papers add to it."""
    made: dict[str, Construction] = {}
    for source in default_papers():
        for name, table in source.construction_tables().items():
            entry = dict(table.entry)
            variants = {
                choice(Variant, v, "variant", where=table.place): source.find(f).name
                for v, f in entry.pop("variants").items()
            }
            if "lowest" in entry:
                entry["lowest"] = source.find(entry["lowest"]).name
            if name in made:
                made[name] = replace(made[name], variants=made[name].variants | variants, **entry)
            else:
                made[name] = Construction(name, variants=variants, **entry)
    return made


def construction(name: str) -> Construction:
    """Return the construction with this name.

    >>> [f"{variant}: {formula}" for variant, formula in construction("evolute").variants.items()]
    ['naive: evolute', 'paper: evolute_reduced', 'lifted: evolute_lifted']

    Raises `FormulaError`, with the names of all constructions, for an unknown name.
    """
    if as_text(name, "the name of a construction") not in all_constructions():
        problem = f"there is no construction called {name!r}"
        raise FormulaError(problem, remedy=nearest(name, all_constructions(), listed_by="list formulas"))
    return all_constructions()[name]


def constructions_for(dimension: int) -> list[Construction]:
    """The constructions defined for curves of this dimension."""
    return [c for c in all_constructions().values() if c.dimension == dimension]
