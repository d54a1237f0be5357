"""Words for evidence of single kinds of claims: differences and factors, degrees, zeros, surfaces, contact."""

from __future__ import annotations

from exactspline.display.evidence.dispatch import words
from exactspline.display.numbers import EXACT, Numbers
from exactspline.numbers.exact import mpq
from exactspline.readings.jet import polynomial_text
from exactspline.symbolic.factorization import Factor
from exactspline.verification import evidence as e
from exactspline.verification.evidence import Found
from exactspline.verification.kinds.invariance import weight_text, with_article
from exactspline.verification.vocabulary import Counter

#: The terms that are written of a polynomial.
TERMS = 3


def is_one(factor: Found | None) -> bool:
    """Whether a factor is the number 1."""
    if isinstance(factor, e.StatedFactor):
        return all(name == "1" for name, _ in factor.powers)
    return isinstance(factor, Factor) and factor.is_one


# ---- identities

_DIFFER = {e.Sides.SIDES: "the sides differ", e.Sides.ZERO: "it differs from 0", e.Sides.SURFACES: "they differ"}


@words.register
def _(found: e.Difference, numbers: Numbers = EXACT) -> str:
    return f"{_DIFFER[found.of]} by {numbers(found.by)} {words(found.at, numbers)}"


@words.register
def _(found: e.StatedFactor, numbers: Numbers = EXACT) -> str:
    stated = " ".join(name if exponent == 1 else f"{name}^{exponent}" for name, exponent in found.powers)
    return f"{stated} = 1 (polynomial: w = 1)" if found.is_one else stated


@words.register
def _(found: e.Relating, numbers: Numbers = EXACT) -> str:
    factor = "" if is_one(found.factor) else f"{words(found.factor, numbers)} · "
    return f"{found.left} = {factor}{found.right}"


@words.register
def _(found: e.ExactQuotient, numbers: Numbers = EXACT) -> str:
    return f"the exact quotient is {words(found.quotient, numbers)}"


@words.register
def _(found: e.Components, numbers: Numbers = EXACT) -> str:
    return f"{found.left} components, and {found.right}"


@words.register
def _(found: e.ComponentDiffers, numbers: Numbers = EXACT) -> str:
    return f"component {found.component} differs"


@words.register
def _(found: e.ComponentNotZero, numbers: Numbers = EXACT) -> str:
    return f"component {found.component} is not zero"


@words.register
def _(found: e.Remainder, numbers: Numbers = EXACT) -> str:
    return numbers.within(polynomial_text(found.polynomial, TERMS))


@words.register
def _(found: e.NotItsDefinition, numbers: Numbers = EXACT) -> str:
    return f"{found.formula} is not {found.definition}"


@words.register
def _(found: e.RationalForm, numbers: Numbers = EXACT) -> str:
    return f"{found.formula} is a quotient of polynomials in the curve, and is {found.definition}"


@words.register
def _(found: e.RationalOfDegree, numbers: Numbers = EXACT) -> str:
    return f"rational of degree {found.degree}"


# ---- degrees and counts


@words.register
def _(found: e.DegreeFound, numbers: Numbers = EXACT) -> str:
    parts = [str(found.degree)]
    if found.as_written:
        parts.append(", as it is written: it vanishes on every curve")
    if found.grading:
        parts.append(f" (k, m, j = {', '.join(map(str, found.grading))})")
    if found.start > 1:
        parts.append(f" (so from d = {found.start} on)")
    for what, exceptions in (("lower", found.lower), ("0", found.zero)):
        if exceptions:
            parts.append(f" ({what} for d = {', '.join(map(str, exceptions))})")
    return "".join(parts)


@words.register
def _(found: e.DegreeHere, numbers: Numbers = EXACT) -> str:
    return str(found.degree)


@words.register
def _(found: e.ZeroHere, numbers: Numbers = EXACT) -> str:
    return "0"


@words.register
def _(found: e.WrongDegree, numbers: Numbers = EXACT) -> str:
    wrong = f"{found.degree}, not {found.relation.bound(found.claimed)}"
    if found.at is None:
        return wrong
    where = " and ".join(f"{name} = {d}" for name, d in found.at)
    return f"at {where}: {wrong}" if where else f"for every d: {wrong}"


@words.register
def _(found: e.Counted, numbers: Numbers = EXACT) -> str:
    return ", ".join(_count(n, what) for n, what in found.numbers)


def _count(n: int | None, what: Counter) -> str:
    if n is None:
        return "infinitely many roots" if what == Counter.ROOTS else "not a form whose sign is that of κ′"
    number = f"{'−' if n < 0 else ''}{abs(n)}"
    return f"degree {number}" if what == Counter.DEGREE else f"{number} {what}"


@words.register
def _(found: e.OnlyForDegrees, numbers: Numbers = EXACT) -> str:
    return f"none vanishes for {words(found.degrees, numbers)}"


@words.register
def _(found: e.ZeroForDegree, numbers: Numbers = EXACT) -> str:
    if found.index is None:
        return f"zero for degree {found.degree}"
    return f"coefficient {found.index} of degree {found.degree}"


@words.register
def _(found: e.CoefficientIsZero, numbers: Numbers = EXACT) -> str:
    what = "it" if found.index is None else f"coefficient {found.index}"
    return f"{what} is zero for every curve of degree {found.degree}"


@words.register
def _(found: e.ZeroCoefficient, numbers: Numbers = EXACT) -> str:
    return f"coefficient {found.index} of {found.formula} is 0"


# ---- zeros, signs, squares


@words.register
def _(found: e.VanishesAlways, numbers: Numbers = EXACT) -> str:
    return f"{found.formula} vanishes on every curve"


@words.register
def _(found: e.VanishesAlone, numbers: Numbers = EXACT) -> str:
    return f"{found.formula} vanishes {words(found.place, numbers)}, {found.other} does not"


@words.register
def _(found: e.ZeroAt, numbers: Numbers = EXACT) -> str:
    return f"zero {words(found.place, numbers)}"


@words.register
def _(found: e.HasSign, numbers: Numbers = EXACT) -> str:
    return str(found.sign)


@words.register
def _(found: e.SumOfSquares, numbers: Numbers = EXACT) -> str:
    return f"a sum of {found.squares} squares" if found.squares > 1 else "a square"


@words.register
def _(found: e.Quotients, numbers: Numbers = EXACT) -> str:
    quotients = [
        f"{found.formula}/{name} = {'not proportional' if factor is None else words(factor, numbers)}"
        for name, factor in found.by
    ]
    return ", ".join(quotients)


@words.register
def _(found: e.OddPowers, numbers: Numbers = EXACT) -> str:
    return f"odd powers of {'·'.join(found.names)}"


@words.register
def _(found: e.Squares, numbers: Numbers = EXACT) -> str:
    zero = f", 0 on {found.zero}" if found.zero else ""
    segments = f"{found.squares} of {found.segments} segments"
    return f"{found.formula} is a square up to a constant on {segments}{zero}"


@words.register
def _(found: e.SquareOnSegment, numbers: Numbers = EXACT) -> str:
    return f"on segment {found.segment} one is a square and the other is not"


# ---- surfaces


@words.register
def _(found: e.OneSurface, numbers: Numbers = EXACT) -> str:
    return f"one surface, but where {' or '.join(found.but)} vanishes" if found.but else "one surface"


@words.register
def _(found: e.OneSurfaceBut, numbers: Numbers = EXACT) -> str:
    return f"one surface, but {words(found.place, numbers)}, where the generator of {found.formula} vanishes"


@words.register
def _(found: e.NoGenerator, numbers: Numbers = EXACT) -> str:
    if found.formula is None:
        return "no surface: the generator vanishes"
    return f"no surface: the generator of {found.formula} vanishes on every curve"


@words.register
def _(found: e.Rulings, numbers: Numbers = EXACT) -> str:
    shift = "" if found.shift is None else f"{words(found.shift, numbers)} + "
    scale = "" if found.scale.is_one else f"{words(found.scale, numbers)} "
    return f"ζ = {shift}{scale}λ"


# ---- contact, invariance, condition


@words.register
def _(found: e.ContactOrder, numbers: Numbers = EXACT) -> str:
    return "none: it does not pass through the point" if found.order < 0 else found.relation.bound(found.order)


@words.register
def _(found: e.AtLeast, numbers: Numbers = EXACT) -> str:
    return f"at least {found.order}"


@words.register
def _(found: e.Vanishes, numbers: Numbers = EXACT) -> str:
    return f"0 {words(found.where, numbers)}"


@words.register
def _(found: e.DerivativeAt, numbers: Numbers = EXACT) -> str:
    what = f"the derivative of order {found.order} by s̄" if found.order else "the value"
    place = f" {words(found.place, numbers)}" if found.place else " on every curve" if found.is_zero else ""
    return f"{what} is {'= 0' if found.is_zero else '≠ 0'} at s̄ = s{place}"


@words.register
def _(found: e.Weight, numbers: Numbers = EXACT) -> str:
    return weight_text(found.under, found.weight)


@words.register
def _(found: e.UnderMap, numbers: Numbers = EXACT) -> str:
    under = f"under {with_article(found.map)}"
    if found.factor is None:
        return f"{under} the sides are not proportional"
    return f"{under} it is {words(found.factor, numbers)} times what is claimed"


@words.register
def _(found: e.DifferUnder, numbers: Numbers = EXACT) -> str:
    return f"under {with_article(found.map)} the sides differ {words(found.place, numbers)}"


@words.register
def _(found: e.Conditions, numbers: Numbers = EXACT) -> str:
    return ", ".join(f"{_middle(a)} against {_middle(b)}" for a, b in found.pairs)


def _middle(enclosure: e.Enclosure) -> str:
    low, high = enclosure
    return f"{float(mpq((low + high) / 2)):.4g}"


@words.register
def _(found: e.NotBetter, numbers: Numbers = EXACT) -> str:
    return f"not better at the zero {words(found.zero, numbers)}"
