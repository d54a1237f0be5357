"""The rows of the degree tables, and derived objects as data."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, partial
from time import perf_counter
from typing import Any

from exactspline.constructions import MINIMAL, Construction, construction, constructions_for, symbolic_minimum
from exactspline.errors import ReductionError
from exactspline.formulas import find
from exactspline.interrogate import Derived
from exactspline.language import Vector
from exactspline.measure import control_point_count, measurable, measure, true_degree_or_none
from exactspline.printers.text import print_text
from exactspline.quotients import Rational
from exactspline.readings.degree import Degree, degree_curve
from exactspline.readings.tree import trace


@dataclass(frozen=True)
class DegreeRow:
    """One line of a degree table: symbolic in d (``nominal``, ``generic``) and on the curve at hand, with the time it took."""

    formula: str
    form: str
    nominal: str
    represented: int
    true: int | None
    control_points: int
    generic: str
    text: str
    seconds: float = 0

    def data(self) -> dict[str, Any]:
        """The row for a program."""
        return vars(self)


@cache
def minimum(name: str, dimension: int, polynomial: bool) -> Degree:
    """The degree of the minimal form of a construction on the generic curve, computed once."""
    return symbolic_minimum(construction(name), dimension, polynomial=polynomial)


def construction_table(curve: Any) -> list[Callable[[], DegreeRow]]:
    """The rows for the constructions of a curve in every form, as calls."""
    return [partial(_row, c, form, curve) for c in constructions_for(curve.dimension) for form in (*c.forms, MINIMAL)]


def _row(c: Construction, form: str, curve: Any) -> DegreeRow:
    formula = c.formula(form)
    lowest = minimum(c.name, curve.dimension, curve.polynomial)
    if form == MINIMAL:
        text = "directrix in lowest terms, the generator without its common factor" if c.ruled else "the first form in lowest terms"
        nominal = "–"
    else:
        text, nominal = print_text(trace(formula, curve.dimension)), str(formula(degree_curve(curve.dimension, polynomial=curve.polynomial)).degree)
    start = perf_counter()
    try:
        value = c.on(curve, form)
    except ReductionError as error:
        return DegreeRow(c.name, form, nominal, -1, None, 0, "–", str(error))
    seconds = perf_counter() - start
    generic = str(lowest) if form == MINIMAL else "–"
    return DegreeRow(c.name, form, nominal, value.degree, true_degree_or_none(value), control_point_count(value), generic, text, seconds)


def formula_table(curve: Any) -> list[Callable[[], DegreeRow]]:
    """The rows for every formula that speaks of such a curve, as calls."""
    return [partial(_formula_row, f.name, curve) for f in measurable(curve.dimension)]


def _formula_row(name: str, curve: Any) -> DegreeRow:
    formula = find(name)
    start = perf_counter()
    m = measure(formula, curve)
    seconds = perf_counter() - start
    text = print_text(trace(formula, curve.dimension))
    return DegreeRow(name, "as it stands", str(m.nominal), m.represented, m.true, m.control_points, "–", text, seconds)


def derived_data(derived: Derived, curve: str) -> dict[str, Any]:
    """A derived object as JSON data: control points as exact text, piece by piece.

    A quotient is given by homogeneous control points ``(w x, w y, …, w)``, a scalar one by ``(w f, w)``.
    """
    return {
        "name": derived.name,
        "form": derived.form,
        "curve": curve,
        "layout": "directrix, generator" if derived.ruled else "",
        "pieces": [piece_data(piece.interval, piece.value) for piece in derived.pieces],
        "missing": [{"interval": [str(a), str(b)], "reason": reason} for (a, b), reason in derived.missing],
    }


def piece_data(interval: Any, value: Any) -> dict[str, Any]:
    """A spline, a vector of them or a `Rational` over an interval, by its control points."""
    head = {"interval": [str(t) for t in interval]}
    if isinstance(value, Rational):
        numerator, denominator = value.raised()
        components = [*(numerator if isinstance(numerator, Vector) else [numerator]), denominator]
        return head | {"kind": "rational"} | _net(components, "homogeneous_control_points")
    if isinstance(value, Vector):
        return head | {"kind": "polynomial"} | _net(list(value), "control_points")
    points = [str(b) for b in value.control_points]
    return head | {"kind": "function", "degree": value.degree, "knots": [str(t) for t in value.knots], "control_points": points}


def _net(components: list[Any], field: str) -> dict[str, Any]:
    """Control points of several splines over the knots that carry them all."""
    common = components[0] * 0
    for c in components[1:]:
        common = common + c * 0
    raised = [c + common for c in components]
    knots = raised[0].knots
    return {
        "degree": raised[0].degree,
        "knots": [str(t) for t in knots],
        field: [[str(x) for x in row] for row in zip(*[c.control_points for c in raised])],
    }
