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

#: The number of terms shown of a polynomial.
TERMS = 3


def is_one(factor: Found | None) -> bool:
    """Whether a factor is the number 1."""
    if isinstance(factor, e.StatedFactor):
        return all(name == "1" for name, _ in factor.powers)
    return isinstance(factor, Factor) and factor.is_one


# ---- identities

_DIFFER = {e.Sides.SIDES: "the sides differ", e.Sides.ZERO: "it differs from 0", e.Sides.SURFACES: "they differ"}


@words.register
def _(item: e.Difference, numbers: Numbers = EXACT) -> str:
    return f"{_DIFFER[item.of]} by {numbers(item.by)} {words(item.at, numbers)}"


@words.register
def _(item: e.StatedFactor, numbers: Numbers = EXACT) -> str:
    stated = " ".join(name if exponent == 1 else f"{name}^{exponent}" for name, exponent in item.powers)
    return f"{stated} = 1 (polynomial: w = 1)" if item.is_one else stated


@words.register
def _(item: e.Relating, numbers: Numbers = EXACT) -> str:
    factor = "" if is_one(item.factor) else f"{words(item.factor, numbers)} · "
    return f"{item.left} = {factor}{item.right}"


@words.register
def _(item: e.ExactQuotient, numbers: Numbers = EXACT) -> str:
    return f"the exact quotient is {words(item.quotient, numbers)}"


@words.register
def _(item: e.Components, numbers: Numbers = EXACT) -> str:
    return f"{item.left} components, and {item.right}"


@words.register
def _(item: e.ComponentDiffers, numbers: Numbers = EXACT) -> str:
    return f"component {item.component} differs"


@words.register
def _(item: e.ComponentNotZero, numbers: Numbers = EXACT) -> str:
    return f"component {item.component} is not zero"


@words.register
def _(item: e.Remainder, numbers: Numbers = EXACT) -> str:
    return numbers.within(polynomial_text(item.polynomial, TERMS))


@words.register
def _(item: e.NotItsDefinition, numbers: Numbers = EXACT) -> str:
    return f"{item.formula} is not {item.definition}"


@words.register
def _(item: e.RationalForm, numbers: Numbers = EXACT) -> str:
    return f"{item.formula} is a quotient of polynomials in the curve, and is {item.definition}"


@words.register
def _(item: e.RationalOfDegree, numbers: Numbers = EXACT) -> str:
    return f"rational of degree {item.degree}"


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
    for what, exceptions in (("lower", item.lower), ("0", item.zero)):
        if exceptions:
            parts.append(f" ({what} for d = {', '.join(map(str, exceptions))})")
    return "".join(parts)


@words.register
def _(item: e.DegreeHere, numbers: Numbers = EXACT) -> str:
    return str(item.degree)


@words.register
def _(item: e.ZeroHere, numbers: Numbers = EXACT) -> str:
    return "0"


@words.register
def _(item: e.WrongDegree, numbers: Numbers = EXACT) -> str:
    wrong = f"{item.degree}, not {item.relation.bound(item.claimed)}"
    if item.at is None:
        return wrong
    where = " and ".join(f"{name} = {d}" for name, d in item.at)
    return f"at {where}: {wrong}" if where else f"for every d: {wrong}"


@words.register
def _(item: e.Counted, numbers: Numbers = EXACT) -> str:
    return ", ".join(_count(n, what) for n, what in item.numbers)


def _count(n: int | None, what: Counter) -> str:
    if n is None:
        return "infinitely many roots" if what == Counter.ROOTS else "not a form whose sign is that of κ′"
    number = f"{'−' if n < 0 else ''}{abs(n)}"
    return f"degree {number}" if what == Counter.DEGREE else f"{number} {what}"


@words.register
def _(item: e.OnlyForDegrees, numbers: Numbers = EXACT) -> str:
    return f"none vanishes for {words(item.degrees, numbers)}"


@words.register
def _(item: e.ZeroForDegree, numbers: Numbers = EXACT) -> str:
    if item.index is None:
        return f"zero for degree {item.degree}"
    return f"coefficient {item.index} of degree {item.degree}"


@words.register
def _(item: e.CoefficientIsZero, numbers: Numbers = EXACT) -> str:
    what = "it" if item.index is None else f"coefficient {item.index}"
    return f"{what} is zero for every curve of degree {item.degree}"


@words.register
def _(item: e.ZeroCoefficient, numbers: Numbers = EXACT) -> str:
    return f"coefficient {item.index} of {item.formula} is 0"


# ---- zeros, signs, squares


@words.register
def _(item: e.VanishesAlways, numbers: Numbers = EXACT) -> str:
    return f"{item.formula} vanishes on every curve"


@words.register
def _(item: e.VanishesAlone, numbers: Numbers = EXACT) -> str:
    return f"{item.formula} vanishes {words(item.place, numbers)}, {item.other} does not"


@words.register
def _(item: e.ZeroAt, numbers: Numbers = EXACT) -> str:
    return f"zero {words(item.place, numbers)}"


@words.register
def _(item: e.HasSign, numbers: Numbers = EXACT) -> str:
    return str(item.sign)


@words.register
def _(item: e.SumOfSquares, numbers: Numbers = EXACT) -> str:
    return f"a sum of {item.squares} squares" if item.squares > 1 else "a square"


@words.register
def _(item: e.Quotients, numbers: Numbers = EXACT) -> str:
    quotients = [
        f"{item.formula}/{name} = {'not proportional' if factor is None else words(factor, numbers)}"
        for name, factor in item.by
    ]
    return ", ".join(quotients)


@words.register
def _(item: e.OddPowers, numbers: Numbers = EXACT) -> str:
    return f"odd powers of {'·'.join(item.names)}"


@words.register
def _(item: e.Squares, numbers: Numbers = EXACT) -> str:
    zero = f", 0 on {item.zero}" if item.zero else ""
    segments = f"{item.squares} of {item.segments} segments"
    return f"{item.formula} is a square up to a constant on {segments}{zero}"


@words.register
def _(item: e.SquareOnSegment, numbers: Numbers = EXACT) -> str:
    return f"on segment {item.segment} one is a square and the other is not"


# ---- surfaces


@words.register
def _(item: e.OneSurface, numbers: Numbers = EXACT) -> str:
    return f"one surface, except where {' or '.join(item.but)} vanishes" if item.but else "one surface"


@words.register
def _(item: e.OneSurfaceBut, numbers: Numbers = EXACT) -> str:
    return f"one surface, except {words(item.place, numbers)}, where the generator of {item.formula} vanishes"


@words.register
def _(item: e.NoGenerator, numbers: Numbers = EXACT) -> str:
    if item.formula is None:
        return "no surface: the generator vanishes"
    return f"no surface: the generator of {item.formula} vanishes on every curve"


@words.register
def _(item: e.Rulings, numbers: Numbers = EXACT) -> str:
    shift = "" if item.shift is None else f"{words(item.shift, numbers)} + "
    scale = "" if item.scale.is_one else f"{words(item.scale, numbers)} "
    return f"ζ = {shift}{scale}λ"


# ---- contact, invariance, condition


@words.register
def _(item: e.ContactOrder, numbers: Numbers = EXACT) -> str:
    return "none: it does not pass through the point" if item.order < 0 else item.relation.bound(item.order)


@words.register
def _(item: e.AtLeast, numbers: Numbers = EXACT) -> str:
    return f"at least {item.order}"


@words.register
def _(item: e.Vanishes, numbers: Numbers = EXACT) -> str:
    return f"0 {words(item.where, numbers)}"


@words.register
def _(item: e.DerivativeAt, numbers: Numbers = EXACT) -> str:
    what = f"the derivative of order {item.order} in s̄" if item.order else "the value"
    place = f" {words(item.place, numbers)}" if item.place else " on every curve" if item.is_zero else ""
    return f"{what} is {'= 0' if item.is_zero else '≠ 0'} at s̄ = s{place}"


@words.register
def _(item: e.Weight, numbers: Numbers = EXACT) -> str:
    return weight_text(item.under, item.weight)


@words.register
def _(item: e.UnderMap, numbers: Numbers = EXACT) -> str:
    under = f"under {with_article(item.map)}"
    if item.factor is None:
        return f"{under} the sides are not proportional"
    return f"{under} it is {words(item.factor, numbers)} times what is claimed"


@words.register
def _(item: e.DifferUnder, numbers: Numbers = EXACT) -> str:
    return f"under {with_article(item.map)} the sides differ {words(item.place, numbers)}"


@words.register
def _(item: e.Conditions, numbers: Numbers = EXACT) -> str:
    return ", ".join(f"{_middle(a)} against {_middle(b)}" for a, b in item.pairs)


def _middle(enclosure: e.Enclosure) -> str:
    low, high = enclosure
    return f"{float(mpq((low + high) / 2)):.4g}"


@words.register
def _(item: e.NotBetter, numbers: Numbers = EXACT) -> str:
    return f"not better at the zero {words(item.zero, numbers)}"
