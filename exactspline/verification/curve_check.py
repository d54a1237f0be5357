"""Claims checked exactly on one concrete curve: in the spline reading, by multiplication and never by sampling."""

from __future__ import annotations

import re
from types import SimpleNamespace
from typing import Any

from flint import fmpz_poly
from gmpy2 import mpq

from exactspline.errors import ClaimError
from exactspline.exact import text
from exactspline.geometry.features import curvature_extrema
from exactspline.geometry.ruled_surfaces import differences
from exactspline.language.arguments import Curve, Pair, embedded
from exactspline.language.parts import split
from exactspline.language.rational import Rational
from exactspline.language.ruled import RuledSurface
from exactspline.language.vector import Vector
from exactspline.papers import find
from exactspline.readings.degree import parse
from exactspline.roots.zero_set import zeros
from exactspline.splines.bernstein import is_square_class, zero_on_segment
from exactspline.splines.bspline import BSpline
from exactspline.splines.lowest_terms import control_point_count, in_lowest_terms, true_degree
from exactspline.splines.tensor import TensorSpline
from exactspline.splines.tensor_lines import Degrees
from exactspline.symbolic.reduction import reduction
from exactspline.verification.check_arguments import argument
from exactspline.verification.claim_factor import factor_of_text
from exactspline.verification.claims import Claim
from exactspline.verification.verdict import REFUTED, UNDECIDED, VACUOUS, VERIFIED, Finding


def check(claim: Claim, curve: Any) -> Finding:
    """What one curve says of a claim."""
    curve = _handed(claim.curve, curve)
    if claim.curve != "table" and claim.kind != "iso-curve" and (gone := _missing(claim, curve)):
        return Finding(UNDECIDED, claim.claimed or claim.factor, gone, witness=VACUOUS)
    return _CHECKS[claim.kind](claim, curve)


#: The curve that was checked last, and what formulas were handed for it, by kind: they remember their values from claim
#: to claim.
_last: tuple[Any, dict[str, Any]] = (None, {})


def _handed(kind: str, curve: Any) -> Any:
    global _last  # noqa: PLW0603
    if kind == "table":
        return curve
    if _last[0] is not curve:
        _last = (curve, {})
    if kind not in _last[1]:
        _last[1][kind] = argument(kind, curve)[0].remembering()
    return _last[1][kind]


def _missing(claim: Claim, curve: Any) -> str:
    """The formula of a claim that does not exist on this curve, because a denominator vanishes on a whole segment;
    empty when all exist.
    """
    for name in claim.named:
        value = find(name)(curve)
        parts = [value.directrix, value.generator] if isinstance(value, RuledSurface) else [value]
        if any(isinstance(part, Rational) and not all(part.denominator.polynomials) for part in parts):
            return f"{name} does not exist on all of this curve: 0/0"
    return ""


def identity(claim: Claim, curve: Any) -> Finding:
    """``left · (denominators) = factor · right · (denominators)``, multiplied out on the spline."""
    (ps, k), (qs, m) = split(find(claim.left)(curve)), split(find(claim.right)(curve))
    top, bottom = factor_of_text(claim.factor, curve)
    factor = printed_factor(claim.factor, curve)
    if all(p.is_zero for p in ps) and all(q.is_zero for q in qs):
        return Finding(UNDECIDED, claim.factor, "0 = 0", factor, VACUOUS)
    left = bottom if m is None else bottom * m
    right = top if k is None else top * k
    for p, q in zip(ps, qs, strict=True):
        difference = p * left - q * right
        if not difference.is_zero:
            return Finding(REFUTED, claim.factor, "not identical", factor, f"the sides differ {_where(difference)}")
    return Finding(VERIFIED, claim.factor, factor, factor)


def printed_factor(factor: str, curve: Any) -> str:
    """The factor on this curve: powers of w are 1 where the curve is polynomial."""
    only_w = all(part.split("^")[0] in ("w", "W") for part in factor.split())
    polynomial = all(c.polynomial for c in curve.together() if isinstance(c, Curve))
    return f"{factor} = 1 (polynomial: w = 1)" if polynomial and only_w and factor != "1" else factor


def _where(difference: Any) -> str:
    """A parameter (two, of a spline in two) at which a spline that is not zero does not vanish, and its value there."""
    if isinstance(difference, TensorSpline):
        (a, b), (c, d) = difference.domain
        line = next(line for j in range(1, 10**6) if not (line := difference.at_t(c + (d - c) / mpq(j + 1))).is_zero)
        return f"{_where(line)} of the first curve and an inner one of the second"
    for i, c in enumerate(difference.polynomials):
        if c:
            a, b = difference.breakpoints[i : i + 2]
            for j in range(1, difference.degree + 3):
                t = a + (b - a) * mpq(j, difference.degree + 3)
                if value := difference(t):
                    return f"by {text(value)} at the parameter {text(t)}"
    return "nowhere"


def vanishing(claim: Claim, curve: Any) -> Finding:
    """All components are the zero spline."""
    for p in split(find(claim.left)(curve))[0]:
        if not p.is_zero:
            return Finding(REFUTED, "0", "not zero", witness=f"it differs from 0 {_where(p)}")
    return Finding(VERIFIED, "0", "0")


def zero_set(claim: Claim, curve: Any) -> Finding:
    """On every segment, what is left of each numerator after removing the other's factors has no zero."""
    values = [(name, find(name)(curve)) for name in claim.formulas]
    if claim.measure == "lowest terms":
        values = [(name, _lowest(value)) for name, value in values]
    numerators = [(name, split(value)[0][0]) for name, value in values]
    if all(p.is_zero for _, p in numerators):
        return Finding(UNDECIDED, "one zero set", "0 = 0", witness=VACUOUS)
    first_name, first = numerators[0]
    for name, other in numerators[1:]:
        for (a_name, a), (b_name, b) in (((first_name, first), (name, other)), ((name, other), (first_name, first))):
            place = _extra_zero(a, b)
            if place:
                return Finding(
                    REFUTED,
                    "one zero set",
                    "different zero sets",
                    witness=f"{a_name} vanishes {place}, {b_name} does not",
                )
    return Finding(VERIFIED, "one zero set", "one zero set")


def _lowest(value: Any) -> Any:
    return in_lowest_terms(value) if isinstance(value, Rational) and all(value.denominator.polynomials) else value


def _extra_zero(a: BSpline, b: BSpline) -> str:
    """Where a vanishes and b does not, as text; empty when nowhere."""
    for i, (p, q) in enumerate(zip(a.polynomials, b.polynomials, strict=True)):
        if not p and not q:
            continue
        low, high = a.breakpoints[i : i + 2]
        if not p:
            return f"on all of [{text(low)}, {text(high)}]"
        rest, n = _without(p, q)
        found = zero_on_segment(rest, n) if n > 0 else None
        if found and not (found[0] == found[1] == 1 and q[b.degree] == 0):
            s, t = (low + (high - low) * x for x in found)
            return f"at the parameter {text(s)}" if s == t else f"between the parameters {text(s)} and {text(t)}"
        if p[a.degree] == 0 and q and q[b.degree] != 0:
            return f"at the parameter {text(high)} (from the left)"
    return ""


def _without(p: fmpz_poly, q: fmpz_poly) -> tuple[fmpz_poly, int]:
    """p without the factors it shares with q, and its own degree (roots at the right end, z = ∞, left out)."""
    common = p.gcd(q)
    while common.degree() > 0:
        p = p // common
        common = p.gcd(q)
    return p, p.degree()


def degree(claim: Claim, curve: Any) -> Finding:
    """The degree of the spline at hand against the claim."""
    value = _measured(claim, curve)
    claimed = parse(claim.claimed).at(
        {
            name: curve.degrees[name] if claim.curve == "table" else _curve_degree(claim, curve)
            for name in parse(claim.claimed).names
        }
    )
    if claim.measure == "lowest terms":
        computed = true_degree(_profile(value))
        return Finding(
            VERIFIED if computed <= claimed else REFUTED,
            str(claimed),
            f"{computed}{' (lower here)' if computed < claimed else ''}",
        )
    if claim.measure in ("true", "reduced"):
        computed = max(p.true_degree for p in split(value)[0])
        if computed < 0:
            return Finding(UNDECIDED, str(claimed), "0", witness=VACUOUS)
        lower = " (lower on this curve)" if computed < claimed else ""
        return Finding(VERIFIED if computed <= claimed else REFUTED, str(claimed), f"{computed}{lower}")
    computed = value.degree
    if isinstance(computed, Degrees):
        computed = computed.s if claim.parameter == "s" else computed.t
    holds = computed >= claimed if claim.relation == "≥" else computed == claimed
    return Finding(
        VERIFIED if holds else REFUTED,
        f"{'≥ ' if claim.relation == '≥' else ''}{claimed}",
        str(computed),
        witness="" if holds else f"{computed}, not {claimed}",
    )


def _curve_degree(claim: Claim, curve: Any) -> int:
    """The degree of the curve whose parameter is counted."""
    if isinstance(curve, Pair):
        curve = curve.first if claim.parameter == "s" else curve.second
        return int(max(max(p.degree) for p in curve.p))
    return int(max(p.degree for p in curve.p))


def _profile(value: Any) -> Any:
    """A quotient in two parameters at a fixed second one; any other as it is."""
    if not isinstance(value.denominator, TensorSpline):
        return value
    a, b = value.denominator.domain[1]
    t = a + (b - a) * mpq(2, 7)
    return Rational(Vector(*[x.at_t(t) for x in value.numerator]), value.denominator.at_t(t))


def _measured(claim: Claim, curve: Any) -> Any:
    """What the degree of a claim is the degree of."""
    if claim.measure == "reduced":
        return reduction(claim.formula, curve.dimension, curve.polynomial).main.on(curve)
    return find(claim.formula)(curve)


def coefficients(claim: Claim, curve: Any) -> Finding:
    """No control point is zero (of a vector: none is the zero vector)."""
    value = find(claim.formula)(curve)
    components = list(value) if isinstance(value, Vector) else [value]
    if all(p.is_zero for p in components):
        return Finding(UNDECIDED, "none vanishes", "all vanish", witness=VACUOUS)
    for i, point in enumerate(zip(*[p.control_points for p in components], strict=True)):
        if not any(point):
            return Finding(REFUTED, "none vanishes", "one vanishes", witness=f"coefficient {i} of {claim.formula} is 0")
    return Finding(VERIFIED, "none vanishes", "none vanishes")


def count(claim: Claim, curve: Any) -> Finding:
    """The numbers of a caption, out of the objects themselves: only those that are claimed are computed."""
    handed, _ = argument(claim.curve, curve)
    value = find(claim.formula)(handed)
    value = getattr(value, "joined", value)
    numerators = split(value)[0]
    counters = {
        "degree": lambda: value.degree,
        "control points": lambda: control_point_count(value),
        "roots": lambda: len(zeros(numerators[0], periodic=curve.closed)),
        "extrema": lambda: len(curvature_extrema(curve)),
        "nominal continuity": lambda: min(min(p.continuity) for p in numerators),
        "true continuity": lambda: min(p.continuity_at(t) for p in numerators for t in p.breakpoints[1:-1]),
    }
    parts = [part.strip() for part in claim.claimed.replace("−", "-").split(",")]
    computed = []
    for part in parts:
        number = re.search(r"-?\d+", part)
        what = part.replace(number[0] if number else "", "").strip()
        if number is None or what not in counters:
            raise ClaimError(f"the count {part!r} cannot be read", remedy=f"counts are of {', '.join(counters)}")
        computed.append(part.replace(number[0], str(counters[what]())))
    found = ", ".join(computed).replace("-", "−")
    agree = computed == parts
    return Finding(
        VERIFIED if agree else REFUTED,
        claim.claimed,
        found,
        witness="" if agree else f"on the example curve {curve.name}: {found}",
    )


def square_class(claim: Claim, curve: Any) -> Finding:
    """On every segment both are squares up to a constant, or neither is."""
    (n, m), (p, q) = [
        (numerators[0], w) for numerators, w in (split(find(name)(curve)) for name in (claim.formula, claim.right))
    ]
    if n.is_zero or p.is_zero:
        return Finding(UNDECIDED, "a square", "0 = 0", witness=VACUOUS)
    left, right = (n if m is None else n * m), (p if q is None else p * q)
    pairs = [
        (is_square_class(a, left.degree), is_square_class(b, right.degree))
        for a, b in zip(left.polynomials, right.polynomials, strict=True)
    ]
    for i, (a, b) in enumerate(pairs):
        if left.polynomials[i] and a != b:
            return Finding(
                REFUTED, "the same", "different", witness=f"on segment {i} one is a square and the other is not"
            )
    squares = sum(b for _, b in pairs)
    return Finding(
        VERIFIED, "the same", f"{claim.right} is a square up to a constant on {squares} of {len(pairs)} segments"
    )


def same_surface(claim: Claim, curve: Any) -> Finding:
    """``G × Ḡ = 0`` and ``(δ − δ̄) × G = 0``, multiplied out on the splines."""
    a, b = find(claim.left)(curve), find(claim.right)(curve)
    if any(all(x.is_zero for x in split(surface.generator)[0]) for surface in (a, b)):
        return Finding(UNDECIDED, "one surface", "no surface: the generator vanishes", witness=VACUOUS)
    for product in differences(a, b):
        for x in split(product)[0]:
            if not x.is_zero:
                return Finding(REFUTED, "one surface", "two surfaces", witness=f"they differ {_where(x)}")
    return Finding(VERIFIED, "one surface", "one surface")


def existence(claim: Claim, curve: Any) -> Finding:
    """The rational form on this curve."""
    value = find(claim.formula)(curve)
    _, denominator = split(value)
    if denominator is not None and denominator.is_zero:
        return Finding(UNDECIDED, "not rational", "does not exist here", witness=VACUOUS)
    return Finding(
        REFUTED,
        "not rational",
        f"rational of degree {value.degree}",
        witness=f"degree {value.degree} over {len(denominator.mesh)} segments",
    )


def spline_table(d1: int = 2, d2: int = 3) -> Any:
    """Operands of Table 1 as splines of unequal degrees and knots: control points from a fixed recurrence, positive
    denominators.
    """
    state = 12345

    def number() -> int:
        nonlocal state
        state = (1103515245 * state + 12345) % 2**31
        return state // 65536 % 100 + 1

    def spline(d: int, inner: list[Any]) -> BSpline:
        knots = [0] * (d + 1) + inner + [3] * (d + 1)
        return BSpline(d, knots, [number() for _ in range(len(knots) - d - 1)])

    one, two = [spline(d1, [1, 2]) for _ in range(5)], [spline(d2, ["1/2", 2, 2]) for _ in range(5)]
    return SimpleNamespace(
        p1=one[0],
        w1=one[1],
        v1=Vector(*one[2:]),
        p2=two[0],
        w2=two[1],
        v2=Vector(*two[2:]),
        degrees={"d1": d1, "d2": d2},
    )


def iso_curve(claim: Claim, curve: Any) -> Finding:
    """The plane curve and the directrix, compared as quotients."""
    plane, space = find(claim.left)(curve), find(claim.right)(embedded(curve)).directrix
    if plane.denominator.is_zero:
        return Finding(UNDECIDED, "the curve ζ = 0", "does not exist here", witness=VACUOUS)
    agree = plane[0] == space[0] and plane[1] == space[1] and space[2].is_zero
    return Finding(VERIFIED if agree else REFUTED, "the curve ζ = 0", "the curve ζ = 0" if agree else "another curve")


_CHECKS = {
    "identity": identity,
    "vanishing": vanishing,
    "zero set": zero_set,
    "degree": degree,
    "coefficients": coefficients,
    "square class": square_class,
    "same surface": same_surface,
    "existence": existence,
    "iso-curve": iso_curve,
}
