"""Words for evidence of any kind of claim: facts, places, what was tried."""

from __future__ import annotations

from exactspline.display.evidence.dispatch import worded, words
from exactspline.display.numbers import EXACT, Numbers
from exactspline.language.kinds import constant_text
from exactspline.symbolic.factorization import Factor
from exactspline.verification import evidence as e
from exactspline.verification.evidence import Fact

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
    Fact.NO_COUNTEREXAMPLE: "no degrees are found for which it fails",
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
def _(found: Fact, numbers: Numbers = EXACT) -> str:
    return FACTS[found]


@words.register
def _(found: Factor, numbers: Numbers = EXACT) -> str:
    return numbers.within(str(found))


# ---- places


@words.register
def _(found: e.At, numbers: Numbers = EXACT) -> str:
    return f"at the parameter {numbers(found.parameter)}{' (from the left)' if found.from_left else ''}"


@words.register
def _(found: e.Between, numbers: Numbers = EXACT) -> str:
    near = numbers.common(found.low, found.high)
    if near:
        return f"near the parameter {near}"
    return f"between the parameters {numbers(found.low)} and {numbers(found.high)}"


@words.register
def _(found: e.OnAllOf, numbers: Numbers = EXACT) -> str:
    return f"on all of [{numbers(found.low)}, {numbers(found.high)}]"


@words.register
def _(found: e.On, numbers: Numbers = EXACT) -> str:
    return f"on [{numbers(found.low)}, {numbers(found.high)}]"


@words.register
def _(found: e.AtBoth, numbers: Numbers = EXACT) -> str:
    return f"at the parameters {numbers(found.s)} and {numbers(found.t)}"


@words.register
def _(found: e.OnPatch, numbers: Numbers = EXACT) -> str:
    return f"{'perhaps ' if found.perhaps else ''}on patch {found.i}, {found.j}"


@words.register
def _(found: e.OnWholePatch, numbers: Numbers = EXACT) -> str:
    return "on a whole patch"


@words.register
def _(found: e.AtKnot, numbers: Numbers = EXACT) -> str:
    return f"at the knot {numbers(found.parameter)}"


@words.register
def _(found: e.Isolated, numbers: Numbers = EXACT) -> str:
    return f"between {numbers(found.low)} and {numbers(found.high)}"


# ---- what is free, and the part that was tried


@words.register
def _(found: e.Chosen, numbers: Numbers = EXACT) -> str:
    point = [f"the point ({', '.join(map(numbers, found.point))})"] if found.point else []
    constants = [f"{constant_text(name)} = {numbers(value)}" for name, value in found.constants]
    return f"with {', '.join([*point, *constants])}"


@words.register
def _(found: e.AnyOperands, numbers: Numbers = EXACT) -> str:
    if found.second_curve:
        return "with any second curve"
    free = [*(["point"] if found.point else []), *map(constant_text, found.constants)]
    return f"with any {', '.join(free)}"


@words.register
def _(found: e.UnderEvery, numbers: Numbers = EXACT) -> str:
    return f"under every {found.group}"


@words.register
def _(found: e.ForDegrees, numbers: Numbers = EXACT) -> str:
    return f"d = {found.first}…{found.last}"


# ---- witnesses of any kind of claim


@words.register
def _(found: e.Stopped, numbers: Numbers = EXACT) -> str:
    return numbers.within(str(found.error))


@words.register
def _(found: e.LeftToTheProof, numbers: Numbers = EXACT) -> str:
    return f"left to the proof for all: {words(found.why, numbers)}"


@words.register
def _(found: e.TooLong, numbers: Numbers = EXACT) -> str:
    degree = f"degree {found.degree} in {found.parameter}"
    return f"{found.formula} as it stands has {degree} there, too much to be multiplied out"


@words.register
def _(found: e.HeldOn, numbers: Numbers = EXACT) -> str:
    stopped = f": {numbers.within(found.error.problem)}" if found.error else ""
    return f"it holds, but was tried on a part only: {words(found.part, numbers)}{stopped}"


@words.register
def _(found: e.OnExample, numbers: Numbers = EXACT) -> str:
    what = "surface" if found.surface else "curve"
    return f"on the example {what} {found.name}: {worded(found.witness, numbers)}"


@words.register
def _(found: e.OnPart, numbers: Numbers = EXACT) -> str:
    return ", ".join(filter(None, (worded(found.witness, numbers), words(found.part, numbers))))


@words.register
def _(found: e.FailsWithOthers, numbers: Numbers = EXACT) -> str:
    place, operands, part = (words(each, numbers) for each in (found.place, found.operands, found.part))
    return f"it fails {place} {operands}, though not {part}"


@words.register
def _(found: e.Refutes, numbers: Numbers = EXACT) -> str:
    return f"proved for all curves, but refuted: {worded(found.witness, numbers)}"


@words.register
def _(found: e.JudgesDisagree, numbers: Numbers = EXACT) -> str:
    witness = worded(found.witness, numbers)
    return f"proved by {found.proved}, but refuted by {found.refuted}{f': {witness}' if witness else ''}"


@words.register
def _(found: e.AssumptionFails, numbers: Numbers = EXACT) -> str:
    return f"{found.assumption.subject} vanishes {words(found.place, numbers)}"


@words.register
def _(found: e.Undefined, numbers: Numbers = EXACT) -> str:
    return f"{found.formula} does not exist on all of this curve: 0/0"


@words.register
def _(found: e.UndefinedAt, numbers: Numbers = EXACT) -> str:
    return f"it does not exist {words(found.where, numbers)}: 1/0"


# ---- proof assistants


@words.register
def _(found: e.Theorem, numbers: Numbers = EXACT) -> str:
    return f"axioms {', '.join(found.axioms)}" if found.axioms else "no axioms"


@words.register
def _(found: e.NoTheorem, numbers: Numbers = EXACT) -> str:
    return f"not stated, {found.error.problem}"
