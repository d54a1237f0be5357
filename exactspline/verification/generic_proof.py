"""Claims decided for all curves at once: in the jet reading, the degree reading and the reading at infinity."""

from __future__ import annotations

from functools import cache
from types import SimpleNamespace
from typing import Any

from exactspline.geometry.ruled_surfaces import differences
from exactspline.language.arguments import embedded
from exactspline.language.kinds import DIMENSIONS
from exactspline.language.parts import split
from exactspline.language.vector import Vector
from exactspline.papers import find
from exactspline.readings.bernstein_term import every_coefficient, monomial_curve
from exactspline.readings.degree import Degree, degree_argument, equal_from, parse
from exactspline.readings.differential_order import order_of
from exactspline.readings.generic_bezier import generic_curve
from exactspline.readings.jet import Jet, polynomial_text
from exactspline.readings.leading_terms import generic_drop
from exactspline.readings.rational_jet import JetFraction, fraction_argument
from exactspline.splines.examples import example, example_names
from exactspline.symbolic.factorization import Factor, find_factor, jets_for
from exactspline.symbolic.reduction import reduction
from exactspline.verification import curve_check
from exactspline.verification.claim_factor import factor_of_text
from exactspline.verification.claims import Claim
from exactspline.verification.verdict import PROVED, REFUTED, UNDECIDED, VERIFIED, Finding

#: The factor that has no zero because what a claim assumes has none.
ZERO_FREE = {"w": "w", "w̄": "w̄", "γ′": "‖D1‖²", "γ′×γ″": "‖b‖²"}
#: The degrees for which the generic Bézier segment is computed.
GENERIC_DEGREES = range(2, 7)


def dimensions(claim: Claim) -> tuple[int, ...]:
    """The dimensions a claim speaks of."""
    return DIMENSIONS[claim.curve]


def prove(claim: Claim) -> tuple[str, Finding]:
    """The reading a claim is decided in, and what was found."""
    if claim.kind == "degree":
        if claim.measure in ("reduced", "lowest terms", "height"):
            return "covariant", covariant_degree(claim)
        return ("infinity", true_degree(claim)) if claim.measure == "true" else ("degree", nominal_degree(claim))
    if claim.kind == "coefficients":
        return (
            ("generic", generic_coefficients(claim))
            if claim.measure == "generic"
            else ("spline", refute_on_examples(claim))
        )
    if claim.kind == "count":
        return "spline", curve_check.count(claim, example(claim.example))
    decide = {
        "identity": identity,
        "vanishing": vanishing,
        "zero set": zero_set,
        "square class": square_class,
        "same surface": same_surface,
        "existence": existence,
        "iso-curve": iso_curve,
    }[claim.kind]
    findings = [decide(claim, dimension) for dimension in dimensions(claim)]
    return "jet", min(findings, key=lambda f: f.verdict == PROVED)


@cache
def factor_of(left: str, right: str, dimension: int) -> Factor | None:
    """The quotient of two named formulas for all curves of that dimension."""
    c = jets_for((left, right), dimension)
    return find_factor(find(left)(c), find(right)(c))


def identity(claim: Claim, dimension: int) -> Finding:
    """``left = factor · right`` as differential polynomials."""
    factor = factor_of(claim.left, claim.right, dimension)
    if factor is None:
        witness = refute_on_examples(claim).witness
        return Finding(
            REFUTED, claim.factor, "not proportional", "none", witness or "the jet polynomials are not proportional"
        )
    top, bottom = factor_of_text(claim.factor, jets_for((claim.left, claim.right), dimension))
    found_top, found_bottom = factor.fraction()
    if top / bottom == JetFraction(factor.ring, found_top, found_bottom):
        return Finding(PROVED, claim.factor, str(factor), str(factor))
    return Finding(REFUTED, claim.factor, str(factor), str(factor), f"the exact quotient is {factor}")


def vanishing(claim: Claim, dimension: int) -> Finding:
    """``left`` is the zero polynomial."""
    components, _ = split(find(claim.left)(jets_for((claim.left,), dimension)))
    rest = next((c for c in components if not c.is_zero), None)
    if rest is None:
        return Finding(PROVED, "0", "0")
    witness = refute_on_examples(claim).witness
    return Finding(
        REFUTED, "0", polynomial_text(Jet(rest.ring, rest.top), 3), witness=witness or "the jet polynomial is not zero"
    )


def zero_set(claim: Claim, dimension: int) -> Finding:
    """Neighbours are identical up to factors without a zero."""
    first, *rest = claim.formulas
    factors = [factor_of(first, other, dimension) for other in rest]
    names = ", ".join(f"{find(first).name}/{other} = {f}" for other, f in zip(rest, factors, strict=True))
    harmless = {ZERO_FREE[name] for name in claim.without_zero}
    if claim.measure != "lowest terms" and all(f is not None and f.names <= harmless for f in factors):
        return Finding(PROVED, "one zero set", "one zero set", names)
    refuted = refute_on_examples(claim)
    if refuted.verdict == REFUTED:
        return Finding(REFUTED, "one zero set", "different zero sets", witness=refuted.witness)
    return Finding(UNDECIDED, "one zero set", "", names)


def same_surface(claim: Claim, dimension: int) -> Finding:
    """Parallel generators and directrices that differ along them; the relation of the ruling parameters ζ (left) and λ
    (right).
    """
    c = jets_for((claim.left, claim.right), dimension)
    a, b = find(claim.left)(c), find(claim.right)(c)
    offset = b.directrix - a.directrix
    if not all(part.is_zero for part in differences(a, b)):
        return Finding(
            REFUTED,
            "one surface",
            "two surfaces",
            witness="the generators are not parallel, or the directrices differ across them",
        )
    stretch = find_factor(b.generator, a.generator)
    shift = "" if offset.is_zero else f"{find_factor(offset, a.generator)} + "
    return Finding(PROVED, "one surface", "one surface", f"ζ = {shift}{stretch} λ".replace("1 λ", "λ"))


def iso_curve(claim: Claim, dimension: int) -> Finding:
    """The plane curve `left` is the curve ζ = 0 of the ruled surface `right` of the same plane curve in space."""
    left, right = find(claim.left), find(claim.right)
    c = fraction_argument(left.curve, dimension, max(order_of(left, dimension), order_of(right, dimension + 1)))
    plane, space = left(c), right(embedded(c)).directrix
    agree = plane[0] == space[0] and plane[1] == space[1] and space[2].is_zero
    return Finding(PROVED if agree else REFUTED, "the curve ζ = 0", "the curve ζ = 0" if agree else "another curve")


def existence(claim: Claim, dimension: int) -> Finding:
    """That there is no rational form is refuted by one: a formula without roots, not the constant zero."""
    value = split(find(claim.formula)(jets_for((claim.formula,), dimension)))[0]
    rational = not all(x.is_zero for x in value)
    return Finding(
        REFUTED if rational else UNDECIDED,
        "not rational",
        "rational",
        witness=f"{claim.formula} is a quotient of polynomials in the curve",
    )


def square_class(claim: Claim, dimension: int) -> Finding:
    """The quotient of the two is a square times a constant: every irreducible factor occurs an even number of times."""
    factor = factor_of(claim.formula, claim.right, dimension)
    odd = "not proportional" if factor is None else "·".join(name for name, _, e in factor.powers if e % 2)
    text = f"{claim.formula}/{claim.right} = {factor}"
    return Finding(
        PROVED if not odd else REFUTED,
        "a square",
        "a square" if not odd else f"odd powers of {odd}",
        text,
        odd and f"odd powers of {odd}",
    )


def nominal_degree(claim: Claim) -> Finding:
    """The degree reading against the claimed degree, for all degrees from some d₀ on."""
    if claim.curve == "table":
        handed = degree_table()
    else:
        kind, polynomial = find(claim.formula).curve, claim.of == "polynomial"
        handed = degree_argument(
            kind, dimensions(claim)[0], polynomial=polynomial, parameter=claim.parameter, counting=claim.counting
        )
    computed, claimed = find(claim.formula)(handed).degree, parse(claim.claimed)
    if claim.relation == "≥":
        holds = equal_from(computed.max(claimed), computed)
        return Finding(
            PROVED if holds == 1 else REFUTED,
            f"≥ {claimed}",
            str(computed),
            witness="" if holds == 1 else f"{computed} < {claimed}",
        )
    start = equal_from(computed, claimed)
    text = str(computed) if start in (None, 1) else f"{computed} (equal for d ≥ {start})"
    return Finding(
        PROVED if start else REFUTED,
        str(claimed),
        text,
        witness="" if start else f"at d = 3: {_at(computed, 3)}, not {_at(claimed, 3)}",
    )


def _at(degree: Degree, d: int) -> int:
    return degree.at(dict.fromkeys(degree.names, d))


def true_degree(claim: Claim) -> Finding:
    """The generic degree in the power basis, for symbolic d."""
    claimed, found = parse(claim.claimed), []
    for dimension in dimensions(claim):
        k, m, drop, exceptions = generic_drop(find(claim.formula), dimension)
        computed = parse(f"{k}d-{m + drop}")
        found.append(
            Finding(
                PROVED if computed == claimed else REFUTED,
                str(claimed),
                str(computed) + _but(exceptions),
                witness=f"{drop} leading terms vanish",
            )
        )
    return min(found, key=lambda f: f.verdict == PROVED)


def covariant_degree(claim: Claim) -> Finding:
    """The degree theorem: degree k, weight m and height j of the reduced form or of the value in lowest terms, for
    symbolic d.
    """
    claimed, found = parse(claim.claimed), []
    for dimension in dimensions(claim):
        part = reduction(claim.formula, dimension, claim.of == "polynomial").main
        grading = part.true
        computed = Degree.number(grading.j if grading else -1) if claim.measure == "height" else part.generic_lowest
        if claim.measure == "reduced":
            computed = part.generic
        text = (
            f"{computed} (k, m, j = {grading.k}, {grading.m}, {grading.j})"
            if grading and claim.measure == "reduced"
            else str(computed)
        )
        found.append(
            Finding(
                PROVED if computed == claimed else REFUTED,
                str(claimed),
                text,
                str(part.cancelled),
                f"the reduced form is {part.text}",
            )
        )
    return min(found, key=lambda f: f.verdict == PROVED)


def _but(exceptions: tuple[int, ...]) -> str:
    return f" (lower for d = {', '.join(map(str, exceptions))})" if exceptions else ""


def generic_coefficients(claim: Claim) -> Finding:
    """No Bézier coefficient is the zero polynomial in indeterminate control points and weights: for every degree at
    once, or degree by degree.
    """
    found = [every_coefficient(find(claim.formula)(monomial_curve(dimension))) for dimension in dimensions(claim)]
    if None not in found:
        computed = (
            "none vanishes for any d ≥ 1: coefficients 2k and 2k + 1 contain the product of control "
            "point k + 1 and weight k"
        )
        return Finding(PROVED, "none vanishes", computed)
    for d in GENERIC_DEGREES:
        for dimension in dimensions(claim):
            value = find(claim.formula)(generic_curve(dimension, d))
            for component in value if isinstance(value, Vector) else [value]:
                for i, c in enumerate(component.coefficients):
                    if not c:
                        return Finding(
                            REFUTED,
                            "none vanishes",
                            f"coefficient {i} of degree {d}",
                            witness=f"coefficient {i} is zero for every curve of degree {d}",
                        )
    return Finding(VERIFIED, "none vanishes", f"none vanishes for d = {GENERIC_DEGREES[0]}…{GENERIC_DEGREES[-1]}")


def refute_on_examples(claim: Claim) -> Finding:
    """The first example curve on which the claim fails, as a witness."""
    for name in sorted(example_names(), key=lambda name: name != claim.witness):
        curve = example(name)
        if claim.speaks_of(curve.dimension, curve.polynomial):
            finding = curve_check.check(claim, curve)
            if finding.verdict == REFUTED:
                finding.witness = f"on the example curve {name}: {finding.witness}"
                return finding
    return Finding(UNDECIDED)


def degree_table() -> Any:
    """The operands of Table 1 in the degree reading."""
    one, two = [[Degree.named(name) for _ in range(5)] for name in ("d1", "d2")]
    return SimpleNamespace(p1=one[0], w1=one[1], v1=Vector(*one[2:]), p2=two[0], w2=two[1], v2=Vector(*two[2:]))
