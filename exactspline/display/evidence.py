"""Evidence of checks in words. No other code reads these words."""

from __future__ import annotations

from enum import Enum
from functools import singledispatch

from exactspline.display.numbers import EXACT, Numbers
from exactspline.errors import ExactSplineError
from exactspline.language.ruled import split
from exactspline.numbers.exact import mpq, point_text, text
from exactspline.polynomials.factors import power_text
from exactspline.readings.jet import polynomial_text
from exactspline.reals.real import Real
from exactspline.splines.nurbs import Nurbs
from exactspline.symbolic.factorization import Factor
from exactspline.verification import evidence as e
from exactspline.verification.claim import Claim
from exactspline.verification.evaluation import Evaluation
from exactspline.verification.evidence import At, Found, OnExample, Said
from exactspline.verification.questions import Check, Proof
from exactspline.verification.verdict import Finding
from exactspline.verification.vocabulary import Verdict

#: What a point consists of.
_NUMBER = (type(mpq()), Real)


def worded(item: Found | None, numbers: Numbers = EXACT) -> str:
    """Evidence in words; empty for no evidence.

    >>> from exactspline.numbers.exact import mpq
    >>> from exactspline.verification.evidence import At, ZeroAt
    >>> worded(ZeroAt(At(mpq(1, 3)))), worded(None)
    ('zero at the parameter 1/3', '')
    """
    return "" if item is None else words(item, numbers)


@singledispatch
def words(item: object, numbers: Numbers = EXACT) -> str:
    """One piece of evidence in words, with its numbers formatted by `numbers`."""
    raise TypeError(f"{type(item).__name__} has no words")


@words.register(type(mpq()))
def _(item: mpq, numbers: Numbers = EXACT) -> str:
    return numbers(item)


@words.register
def _(item: tuple, numbers: Numbers = EXACT) -> str:  # type: ignore[type-arg]  # of numbers
    parts = [words(each, numbers) for each in item]
    return parts[0] if len(parts) == 1 else f"({', '.join(parts)})"


@words.register
def _(item: Real, numbers: Numbers = EXACT) -> str:
    return item.shortly()


@words.register
def _(item: Enum, numbers: Numbers = EXACT) -> str:
    return str(item.value)


@words.register
def _(item: Said, numbers: Numbers = EXACT) -> str:
    return item.phrase.words(*[_as_taken(each, numbers) for each in item.about])


def _as_taken(about: object, numbers: Numbers) -> object:
    """What a phrase is about, as it takes it: names and counts as they are, everything else in words."""
    if isinstance(about, str | int | None):
        return about
    if isinstance(about, tuple) and not (about and isinstance(about[0], _NUMBER)):
        return tuple(_as_taken(each, numbers) for each in about)
    return words(about, numbers)


@words.register(ExactSplineError)
@words.register(Factor)
def _(item: object, numbers: Numbers = EXACT) -> str:
    return numbers.within(str(item))


# ---- places


@words.register
def _(item: e.At, numbers: Numbers = EXACT) -> str:
    return f"at the parameter {numbers(item.parameter)}{' (from the left)' if item.from_left else ''}"


@words.register
def _(item: e.Between, numbers: Numbers = EXACT) -> str:
    near = numbers.common(item.low, item.high)
    if near:
        return f"near the parameter {near}"
    return f"between the parameters {numbers(item.low)} and {numbers(item.high)}"


# ---- witnesses of any kind of claim


@words.register
def _(item: e.Stopped, numbers: Numbers = EXACT) -> str:
    return words(item.error, numbers)


@words.register
def _(item: e.HeldOn, numbers: Numbers = EXACT) -> str:
    stopped = f": {numbers.within(item.error.problem)}" if item.error else ""
    return f"it holds, but was tried on a part only: {words(item.part, numbers)}{stopped}"


@words.register
def _(item: e.OnExample, numbers: Numbers = EXACT) -> str:
    return f"on the example {'surface' if item.surface else 'curve'} {item.name}: {worded(item.witness, numbers)}"


@words.register
def _(item: e.NoTheorem, numbers: Numbers = EXACT) -> str:
    return f"not stated, {item.error.problem}"


#: The number of terms shown of a polynomial.
TERMS = 3


# ---- identities


@words.register
def _(item: e.Difference, numbers: Numbers = EXACT) -> str:
    return f"{words(item.of)} by {numbers(item.by)} {words(item.at, numbers)}"


@words.register
def _(item: e.StatedFactor, numbers: Numbers = EXACT) -> str:
    stated = "·".join(power_text(name, exponent) for name, exponent in item.powers)
    return f"{stated} = 1 (polynomial: w = 1)" if item.is_one else stated


@words.register
def _(item: e.Relating, numbers: Numbers = EXACT) -> str:
    factor = item.factor
    is_one = factor.is_one if isinstance(factor, Factor) else all(name == "1" for name, _ in factor.powers)
    return f"{item.left} = {'' if is_one else f'{words(factor, numbers)} · '}{item.right}"


@words.register
def _(item: e.ExactQuotient, numbers: Numbers = EXACT) -> str:
    return f"the exact quotient is {words(item.quotient, numbers)}"


@words.register
def _(item: e.Remainder, numbers: Numbers = EXACT) -> str:
    return numbers.within(polynomial_text(item.polynomial, TERMS))


# ---- degrees and counts


@words.register
def _(item: e.DegreeFound, numbers: Numbers = EXACT) -> str:
    parts = [str(item.degree)]
    if item.as_written:
        parts.append(", as written: it vanishes on every curve")
    if item.grading:
        parts.append(f" (k, m, j = {', '.join(map(str, item.grading))})")
    if item.start > 1:
        parts.append(f"  (for d ≥ {item.start})")
    for what, exceptions in (("lower", item.lower), ("identically zero", item.zero)):
        if exceptions:
            parts.append(f" ({what} for d = {', '.join(map(str, exceptions))})")
    return "".join(parts)


@words.register
def _(item: e.DegreeHere, numbers: Numbers = EXACT) -> str:
    return "0" if item.degree is None else str(item.degree)


@words.register
def _(item: e.WrongDegree, numbers: Numbers = EXACT) -> str:
    degree = item.degree if item.degree >= 0 else "identically zero"
    wrong = f"{degree}, not {item.relation.bound(text(item.claimed))}"
    if item.at is None:
        return wrong
    where = " and ".join(f"{name} = {d}" for name, d in item.at)
    return f"at {where}: {wrong}" if where else f"for every d: {wrong}"


# ---- zeros, signs, squares


@words.register
def _(item: e.ZeroAt, numbers: Numbers = EXACT) -> str:
    return f"zero {words(item.place, numbers)}"


# ---- surfaces


@words.register
def _(item: e.Rulings, numbers: Numbers = EXACT) -> str:
    shift = "" if item.shift is None else f"{words(item.shift, numbers)} + "
    scale = "" if item.scale.is_one else f"{words(item.scale, numbers)} "
    return f"ζ = {shift}{scale}λ"


# ---- contact, invariance, condition


@words.register
def _(item: e.Conditions, numbers: Numbers = EXACT) -> str:
    return ", ".join(f"{_middle(a)} against {_middle(b)}" for a, b in item.pairs)


def _middle(enclosure: e.Enclosure) -> str:
    low, high = enclosure
    return f"{float(mpq((low + high) / 2)):.4g}"


def opinion(item: Finding | None) -> str:
    """The result of a second verifier for a claim."""
    if item is None:
        return "not asked"
    says = {Verdict.PROVED: "holds, ", Verdict.REFUTED: "fails, "}.get(item.verdict, "")
    return says + worded(item.witness or item.computed)


def _equation(left: str, factor: str, right: str) -> str:
    return f"{left} = {'' if factor == '1' else f'{factor} · '}{right}"


@words.register
def _(item: Proof, numbers: Numbers = EXACT) -> str:
    stated, where = _equation(item.left, item.factor, item.right), f"in {item.spaces}"
    if item.holds:
        return f"{stated} for all curves {where}"
    if item.verdict == Verdict.VACUOUS:
        return f"{stated} decides nothing {where}: {worded(item.finding.computed)}"
    different = "they differ" if item.roots else "they are not parallel"
    return f"not {stated} {where}: {different if item.quotient is None else f'the quotient is {item.quotient}'}"


@words.register
def _(item: Check, numbers: Numbers = EXACT) -> str:
    stated = _equation(item.left, item.factor, item.right)
    if item.vacuous:
        return f"{stated} decides nothing on this curve: {worded(item.finding.computed)}"
    return f"{stated} on this curve" if item.holds else f"not {stated} at the parameter {item.parameter}"


# ---- the curve of a witness


def curve_of_witness(claim: Claim, finding: Finding) -> Nurbs | None:
    """The curve that a witness names, or that the claim is about."""
    witness = finding.witness
    name = witness.name if isinstance(witness, OnExample) and not witness.surface else claim.example
    return claim.curve_named(name) if name else None


def written_out(curve: Nurbs) -> dict[str, str]:
    """The knots, control points and weights of a curve.

    >>> from exactspline import example
    >>> written_out(example("parabola"))["control points"]
    '(-1, 1), (0, -1), (1, 1)'
    """
    points = ", ".join(map(point_text, curve.control_points))
    knots, weights = (", ".join(map(str, numbers)) for numbers in (curve.knots, curve.weights))
    return {"knots": knots, "control points": points, "weights": weights}


def values_there(claim: Claim, finding: Finding) -> list[str]:
    """The values of the formulas of a claim at the parameter of its witness."""
    curve, t = curve_of_witness(claim, finding), _parameter(finding.witness)
    if curve is None or t is None or claim.of_pair:
        return []
    values = []
    for name in claim.named:
        try:
            parts, below = split(claim.find(name)(Evaluation(curve).argument(claim.curve)))
            divisor = mpq(1) if below is None else below(t)
            values.append(f"{name}({t}) = {point_text([x(t) / divisor for x in parts])}")
        except (ExactSplineError, ZeroDivisionError):  # a surface, or no value there
            continue
    return values


def _parameter(evidence: object) -> mpq | None:
    """The parameter of a place; None if the place is not a parameter."""
    if isinstance(evidence, At):
        return evidence.parameter
    fields = (getattr(evidence, name) for name in ("witness", "at", "place") if hasattr(evidence, name))
    inner = evidence.about if isinstance(evidence, Said) else fields
    return next((t for each in inner if (t := _parameter(each)) is not None), None)
