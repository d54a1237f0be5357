"""Comparison of a student's curve or formula with the reference: they are equal, or the places where they differ."""

from __future__ import annotations

from itertools import pairwise

from exactspline.errors import ExactSplineError
from exactspline.extras.teaching.answers import Finding, simple_parameters
from exactspline.extras.teaching.differences import (
    Difference,
    NotProved,
    OtherDimension,
    OtherDomain,
    OtherOnExample,
    OtherPoint,
    OtherValue,
    Wrong,
)
from exactspline.extras.teaching.parts import Point
from exactspline.interchange.examples import example, example_names
from exactspline.language.formula import Formula
from exactspline.language.ruled import split
from exactspline.numbers.exact import mpq
from exactspline.splines.nurbs import Nurbs
from exactspline.verification.questions import prove, verify
from exactspline.verification.vocabulary import Name


def compare_curves(given: Nurbs, reference: Nurbs) -> Finding:
    """Whether two curves are the same function, regardless of degrees and knots; if not, a parameter with both points.

    >>> line = Nurbs(1, [0, 0, 1, 1], [(0, 0), (2, 4)])
    >>> compare_curves(line.elevate_degree(), line).right
    True
    >>> print(*compare_curves(Nurbs(1, [0, 0, 1, 1], [(0, 0), (2, 3)]), line).differences, sep="; ")
    control point 1 is (2, 4), not (2, 3); at t = 1 it gives (2, 3) instead of (2, 4)
    """
    if given.dimension != reference.dimension:
        return Finding((OtherDimension(reference.dimension, given.dimension),))
    if given.domain != reference.domain:
        return Finding((OtherDomain(reference.domain, given.domain),))
    if given == reference:
        return Finding(())
    differences: list[Difference] = [Wrong.REVERSED] if given == reference.reverse() else _points(given, reference)
    # on one segment polynomials differ at all but finitely many parameters; elsewhere the curves may be the same
    breaks = sorted({*given.breakpoints, *reference.breakpoints})
    a, b = next((a, b) for a, b in pairwise(breaks) if given.restrict(a, b) != reference.restrict(a, b))
    t = next(t for t in simple_parameters(a, b) if given(t) != reference(t))
    return Finding((*differences, OtherValue(t, reference(t), given(t))))


def _points(given: Nurbs, reference: Nurbs) -> list[Difference]:
    """The control points that differ, if the curves have the same degree, knots and weights."""
    alike = (given.degree, given.knots) == (reference.degree, reference.knots)
    if not (alike and given.polynomial and reference.polynomial):
        return []
    pairs = enumerate(zip(given.control_points, reference.control_points, strict=True))
    return [OtherPoint(i, right, wrong) for i, (wrong, right) in pairs if wrong != right]


def compare_formulas(given: Formula, reference: Formula, factor: str = "1") -> Finding:
    """Whether ``given = factor · reference`` for all curves, proved with indeterminate derivatives; if not, the true
    quotient, and a curve and a parameter with both values.

    >>> from exactspline.papers import find
    >>> compare_formulas(find("f1"), find("f2"), "w").right
    True
    >>> print(compare_formulas(find("f1"), find("f2")).differences[0])
    not f1 = f2 in R2: the quotient is w

    Raises `FormulaError` for formulas that cannot be compared.
    """
    proof = prove(given, reference, factor)
    if proof:
        return Finding(())
    witness = _witness(given, reference, factor, proof.dimension)
    return Finding((NotProved(proof), *([witness] if witness else [])))


def _witness(given: Formula, reference: Formula, factor: str, dimension: int) -> OtherOnExample | None:
    """Values of both sides at a point of an example curve where they differ; None if the formulas do not apply to a
    single curve.
    """
    for name in example_names():
        curve = example(name)
        if curve.dimension != dimension:
            continue
        try:
            result = verify(given, reference, curve, factor)
        except ExactSplineError:
            continue
        if (t := result.parameter) is not None:
            left, right = (_value(f, curve, t) for f in (given, reference))
            return OtherOnExample(Name(name), t, right, left, None if factor == "1" else Name(factor))
    return None


def _value(formula: Formula, curve: Nurbs, t: mpq) -> Point | None:
    parts, denominator = split(formula(curve))
    below = mpq(1) if denominator is None else denominator(t)
    return tuple(part(t) / below for part in parts) if below else None
