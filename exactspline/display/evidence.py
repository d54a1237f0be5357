"""Evidence of checks in words: a template for each type of evidence, or a function where a template is not enough.
Nothing reads what they write.
"""

from __future__ import annotations

import re
from functools import partial, singledispatch
from operator import attrgetter
from types import NoneType

from exactspline.classroom import differences as wrong
from exactspline.classroom.answers import shown
from exactspline.classroom.differences import Entries, Shape
from exactspline.classroom.parts import Point
from exactspline.display.numbers import EXACT, Numbers
from exactspline.errors import ExactSplineError, counted
from exactspline.language.kinds import constant_text
from exactspline.numbers.exact import mpq, text
from exactspline.polynomials.factorization import power_text
from exactspline.readings.jet import polynomial_text
from exactspline.symbolic.factorization import Factor
from exactspline.verification import evidence as e
from exactspline.verification.evidence import Fact, Found
from exactspline.verification.kinds.invariance import weight_text, with_article
from exactspline.verification.questions import Check, Proof
from exactspline.verification.verdict import Finding
from exactspline.verification.vocabulary import Counter, Verdict

#: Words for types of evidence, with fields between braces: ``{name?yes|no}`` is one of two texts, as the field is true.
TEMPLATES: dict[type, str] = {
    e.At: "at the parameter {parameter}{from_left? (from the left)}",
    e.OnAllOf: "on all of [{low}, {high}]",
    e.On: "on [{low}, {high}]",
    e.AtBoth: "at the parameters {s} and {t}",
    e.OnWholePatch: "on a whole patch",
    e.OnPatch: "{perhaps?perhaps }on patch {i}, {j}",
    e.AtKnot: "at the knot {parameter}",
    e.Isolated: "between {low} and {high}",
    e.UnderEvery: "under every {group}",
    e.ForDegrees: "d = {first}…{last}",
    e.Stopped: "{error}",
    e.TooLong: "{formula} as written has degree {degree} in {parameter} there, too high to be multiplied out",
    e.OnExample: "on the example {surface?surface|curve} {name}: {witness}",
    e.OnPart: "{witness}{witness?, }{part}",
    e.FailsWithOthers: "it fails {place} {operands}, though not {part}",
    e.Refutes: "proved for all curves, but refuted: {witness}",
    e.JudgesDisagree: "proved by {proved}, but refuted by {refuted}{witness?: }{witness}",
    e.AssumptionFails: "{assumption.subject} vanishes {place}",
    e.NoTheorem: "not stated, {error.problem}",
    e.Difference: "{of} by {by} {at}",
    e.LeftToTheProof: "decided by the proof for all curves: {why}",
    e.Undefined: "{formula} does not exist on all of this curve: 0/0",
    e.UndefinedAt: "it does not exist {where}: 1/0",
    e.ExactQuotient: "the exact quotient is {quotient}",
    e.Components: "{left} components, and {right}",
    e.ComponentDiffers: "component {component} differs",
    e.ComponentNotZero: "component {component} is not zero",
    e.NotItsDefinition: "{formula} is not {definition}",
    e.RationalForm: "{formula} is a quotient of polynomials in the curve, and is {definition}",
    e.RationalOfDegree: "rational of degree {degree}",
    e.DegreeHere: "{degree}",
    e.ZeroHere: "0",
    e.OnlyForDegrees: "none vanishes for {degrees}",
    e.ZeroCoefficient: "coefficient {index} of {formula} is 0",
    e.VanishesAlways: "{formula} vanishes on every curve",
    e.VanishesAlone: "{formula} vanishes {place}, {other} does not",
    e.ZeroAt: "zero {place}",
    e.HasSign: "{sign}",
    e.SquareOnSegment: "on segment {segment} one is a square and the other is not",
    e.OneSurfaceBut: "one surface, except {place}, where the generator of {formula} vanishes",
    e.NoGenerator: "no surface: the generator{formula? of }{formula} vanishes{formula? on every curve}",
    e.AtLeast: "at least {order}",
    e.Vanishes: "0 {where}",
    e.NotBetter: "not better at the zero {zero}",
    e.OfType: "{type}",
    e.TypeHere: "it is {type} on {special?it, as it may be on special curves|this curve}",
    e.OfKind: "its arguments are of the kind '{kind}'",
    e.OfAnotherKind: "{formula} is a formula of '{kind}', not of '{asked}'",
    wrong.OtherNumber: "{name} is {right}, not {given}",
    wrong.OtherPoint: "control point {index} is {right}, not {given}",
    wrong.OtherCoefficient: "{name}: the coefficient of t^{power} is {right}, not {given}",
    wrong.OtherValue: "{name}{name?: }at t = {at} it gives {given} instead of {right}",
    wrong.Missing: "t = {parameter} is missing",
    wrong.Invented: "t = {parameter} is not one of them",
    wrong.OtherDimension: "it is in R{given}, not in R{right}",
    wrong.NotProved: "{proof}",
}
#: A field in a template: its name, and the texts between which it chooses.
_FIELD = re.compile(r"\{([\w.]+)(?:\?([^|}]*)\|?([^}]*))?\}")


def worded(item: Found | None, numbers: Numbers = EXACT) -> str:
    """Evidence in words; empty where there is none.

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
    return shown(item)


@words.register(str)
@words.register(int)
@words.register(NoneType)
def _(item: object, numbers: Numbers = EXACT) -> str:
    return "" if item is None else str(item)


@words.register
def _(item: ExactSplineError, numbers: Numbers = EXACT) -> str:
    return numbers.within(str(item))


def _filled(template: str, item: object, numbers: Numbers = EXACT) -> str:
    """A template with the fields of a piece of evidence."""

    def field(match: re.Match[str]) -> str:
        value = attrgetter(match[1])(item)
        if match[2] is not None:
            return match[2] if value else match[3]
        return words(value, numbers)

    return _FIELD.sub(field, template)


for _kind, _template in TEMPLATES.items():
    words.register(_kind, partial(_filled, _template))


FACTS = {
    Fact.NOTHING: "0 = 0",
    Fact.VANISHES: "0",
    Fact.ALL_VANISH: "all vanish",
    Fact.NO_SIDE: "a side does not exist on all of this curve: 0/0",
    Fact.NOWHERE: "a side exists on no curve: 0/0",
    Fact.NO_FACTOR: "the factor does not exist on all of this curve: 1/0",
    Fact.NO_VALUE: "it does not exist on all of this curve: 1/0",
    Fact.NO_COMMON_ZERO: "no zero in common",
    Fact.NO_JOINT: "one segment: nothing is joined",
    Fact.NOT_HERE: "does not exist here",
    Fact.ZERO: "0",
    Fact.NONE_VANISHES: "none vanishes",
    Fact.NONE_VANISHES_FOR_ANY_DEGREE: (
        "none vanishes for any d ≥ 1: coefficients 2k and 2k + 1 contain the product of control point k + 1 and "
        "weight k"
    ),
    Fact.RATIONAL: "rational",
    Fact.SQUARE: "a square",
    Fact.SQUARES_ONE_WITHOUT_ZERO: "a sum of squares, one without a zero",
    Fact.ONE_ZERO_SET: "one zero set",
    Fact.CURVE_OF_ZERO_ZETA: "the curve ζ = 0",
    Fact.APPLIES: "it applies",
    Fact.NOT_PROPORTIONAL: "not proportional",
    Fact.NOT_IDENTICAL: "not identical",
    Fact.NOT_ZERO: "not zero",
    Fact.DIVIDED_BY_ZERO: "1/0",
    Fact.ONE_VANISHES: "one vanishes",
    Fact.DIFFERENT: "different",
    Fact.DIFFERENT_ZERO_SETS: "different zero sets",
    Fact.TWO_SURFACES: "two surfaces",
    Fact.OTHER_CURVE: "another curve",
    Fact.OTHER_SIGN: "the other sign",
    Fact.HAS_ZERO: "zero",
    Fact.NOT_SO: "not so",
    Fact.NO_CONTACT: "no contact",
    Fact.LESS_CONTACT: "less",
    Fact.FACTOR_DIVIDED_BY_ZERO: "the factor is divided by zero",
    Fact.POLYNOMIALS_NOT_PROPORTIONAL: "the jet polynomials are not proportional",
    Fact.POLYNOMIAL_NOT_ZERO: "the jet polynomial is not zero",
    Fact.RIGHT_SIDE_VANISHES: "the right side vanishes, the left does not",
    Fact.OTHER_NUMBER_OF_COMPONENTS: "not as many components",
    Fact.GENERATORS_APART: "the generators are not parallel, or the directrices differ across them",
    Fact.CURVES_DIFFER: "the two curves differ",
    Fact.OTHER_SQUARES: "not the sum of these squares",
    Fact.NO_SQUARES: "no squares are named",
    Fact.SQUARES_MAY_VANISH: "every square may vanish under the assumptions",
    Fact.SINGULAR_CONTACT: (
        "as a function of the point at s̄ it is singular where the points meet: it defines no object there"
    ),
    Fact.NO_COUNTEREXAMPLE: "no degrees were found for which it fails",
    Fact.DENOMINATOR_DIVIDES_OUT: "its denominator divides out on every curve",
    Fact.MADE_BY_ARITHMETIC: (
        "it is made of the operands by + − × ÷ and derivatives: a quotient of polynomials on every curve"
    ),
    Fact.NO_CURVE_OF_THIS_TYPE: "no example curve shows of which type it is",
    Fact.LOWER_DEGREE_HERE: "the degree is lower on it, as it may be on special ones",
    Fact.HIGHER_CONTACT_HERE: "the contact is of a higher order on it, as it may be on special curves",
    Fact.TOO_FEW_DERIVATIVES: "its degree is lower than the order of a derivative",
    Fact.ZEROS_IN_TWO_PARAMETERS: "zeros in two parameters are not compared on one surface",
    Fact.NO_COMMON_KNOTS: "the operands of Table 1 have no knots in common",
    Fact.ROOT_IS_RATIONAL: "a root is itself rational on it",
    Fact.NOT_OF_THIS_JUDGE: "this judge does not decide claims of this kind",
    Fact.COQ_NOT_INSTALLED: "Coq is not installed",
    Fact.NOT_ACCEPTED: "not accepted",
    Fact.FIRST_SEGMENTS: "first segment, with its moved copy",
    Fact.FIRST_PATCH: "the first patch",
    Fact.ONE_LINE: "one value of the other parameter",
    Fact.AS_HODOGRAPH: "as u, v and h of a hodograph",
    Fact.WITH_ITSELF: "with itself",
}


@words.register
def _(item: Fact, numbers: Numbers = EXACT) -> str:
    return FACTS[item]


@words.register
def _(item: Factor, numbers: Numbers = EXACT) -> str:
    return numbers.within(str(item))


# ---- places


@words.register
def _(item: e.Between, numbers: Numbers = EXACT) -> str:
    near = numbers.common(item.low, item.high)
    if near:
        return f"near the parameter {near}"
    return f"between the parameters {numbers(item.low)} and {numbers(item.high)}"


# ---- free arguments, and the part that was tried


@words.register
def _(item: e.Chosen, numbers: Numbers = EXACT) -> str:
    point = [f"the point ({', '.join(map(numbers, item.point))})"] if item.point else []
    constants = [f"{constant_text(name)} = {numbers(value)}" for name, value in item.constants]
    return f"with {', '.join([*point, *constants])}"


@words.register
def _(item: e.AnyOperands, numbers: Numbers = EXACT) -> str:
    if item.second_curve:
        return "with any second curve"
    free = [*(["point"] if item.point else []), *map(constant_text, item.constants)]
    return f"with any {', '.join(free)}"


# ---- witnesses of any kind of claim


@words.register
def _(item: e.HeldOn, numbers: Numbers = EXACT) -> str:
    stopped = f": {numbers.within(item.error.problem)}" if item.error else ""
    return f"it holds, but was tried on a part only: {words(item.part, numbers)}{stopped}"


# ---- proof assistants


@words.register
def _(item: e.Theorem, numbers: Numbers = EXACT) -> str:
    return f"axioms {', '.join(item.axioms)}" if item.axioms else "no axioms"


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
def _(item: e.Sides, numbers: Numbers = EXACT) -> str:
    return _DIFFER[item]


@words.register
def _(item: e.StatedFactor, numbers: Numbers = EXACT) -> str:
    stated = "·".join(power_text(name, exponent) for name, exponent in item.powers)
    return f"{stated} = 1 (polynomial: w = 1)" if item.is_one else stated


@words.register
def _(item: e.Relating, numbers: Numbers = EXACT) -> str:
    factor = "" if is_one(item.factor) else f"{words(item.factor, numbers)} · "
    return f"{item.left} = {factor}{item.right}"


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
def _(item: e.WrongDegree, numbers: Numbers = EXACT) -> str:
    degree = item.degree if item.degree >= 0 else "identically zero"
    wrong = f"{degree}, not {item.relation.bound(text(item.claimed))}"
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
def _(item: e.ZeroForDegree, numbers: Numbers = EXACT) -> str:
    if item.index is None:
        return f"zero for degree {item.degree}"
    return f"coefficient {item.index} of degree {item.degree}"


@words.register
def _(item: e.CoefficientIsZero, numbers: Numbers = EXACT) -> str:
    what = "it" if item.index is None else f"coefficient {item.index}"
    return f"{what} is zero for every curve of degree {item.degree}"


# ---- zeros, signs, squares


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


# ---- surfaces


@words.register
def _(item: e.OneSurface, numbers: Numbers = EXACT) -> str:
    return f"one surface, except where {' or '.join(item.but)} vanishes" if item.but else "one surface"


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
def _(item: e.TypeOnExample, numbers: Numbers = EXACT) -> str:
    where = f"on the example curve {item.curve}" if item.curve else "for cubic polynomials"
    why = f"; {words(e.Fact.MADE_BY_ARITHMETIC, numbers)}" if item.rational_everywhere else ""
    return f"{item.type} {where}{why}"


def opinion(item: Finding) -> str:
    """The result of a proof assistant's kernel for a claim."""
    says = {Verdict.PROVED: "holds, ", Verdict.REFUTED: "fails, "}.get(item.verdict, "")
    return says + worded(item.witness or item.computed)


def _equation(left: str, factor: str, right: str) -> str:
    return f"{left} = {'' if factor == '1' else f'{factor} · '}{right}"


@words.register
def _(item: Proof, numbers: Numbers = EXACT) -> str:
    stated, where = _equation(item.left, item.factor, item.right), f"in R{item.dimension}"
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


# ---- answers of students

ENTRIES = {Entries.NUMBERS: "number", Entries.POINTS: "point", Entries.POLYNOMIALS: "polynomial"}
SHAPES = {Shape.CIRCLE: "it is a circle", Shape.NOT_A_CIRCLE: "it is not a circle", Shape.REVERSED: "it is reversed"}


@words.register
def _(item: Shape, numbers: Numbers = EXACT) -> str:
    return SHAPES[item]


@words.register
def _(item: wrong.OtherCount, numbers: Numbers = EXACT) -> str:
    return f"{counted(item.right, ENTRIES[item.of])} required, not {item.given}"


@words.register
def _(item: wrong.OtherCoordinates, numbers: Numbers = EXACT) -> str:
    return f"points with {counted(item.right, 'coordinate')} are required"


@words.register
def _(item: wrong.OtherDomain, numbers: Numbers = EXACT) -> str:
    here, there = (", ".join(map(text, domain)) for domain in (item.given, item.right))
    return f"its domain is [{here}], not [{there}]"


@words.register
def _(item: wrong.OtherOnExample, numbers: Numbers = EXACT) -> str:
    right = f"{item.factor} · {_value(item.right)}" if item.factor else _value(item.right)
    return f"on the example curve {item.curve} at t = {text(item.at)} it gives {_value(item.given)} instead of {right}"


def _value(value: Point | None) -> str:
    return "no value" if value is None else shown(value)
