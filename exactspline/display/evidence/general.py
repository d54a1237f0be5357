"""Words for evidence of any kind of claim: facts, places, attempts."""

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
def _(item: e.At, numbers: Numbers = EXACT) -> str:
    return f"at the parameter {numbers(item.parameter)}{' (from the left)' if item.from_left else ''}"


@words.register
def _(item: e.Between, numbers: Numbers = EXACT) -> str:
    near = numbers.common(item.low, item.high)
    if near:
        return f"near the parameter {near}"
    return f"between the parameters {numbers(item.low)} and {numbers(item.high)}"


@words.register
def _(item: e.OnAllOf, numbers: Numbers = EXACT) -> str:
    return f"on all of [{numbers(item.low)}, {numbers(item.high)}]"


@words.register
def _(item: e.On, numbers: Numbers = EXACT) -> str:
    return f"on [{numbers(item.low)}, {numbers(item.high)}]"


@words.register
def _(item: e.AtBoth, numbers: Numbers = EXACT) -> str:
    return f"at the parameters {numbers(item.s)} and {numbers(item.t)}"


@words.register
def _(item: e.OnPatch, numbers: Numbers = EXACT) -> str:
    return f"{'perhaps ' if item.perhaps else ''}on patch {item.i}, {item.j}"


@words.register
def _(item: e.OnWholePatch, numbers: Numbers = EXACT) -> str:
    return "on a whole patch"


@words.register
def _(item: e.AtKnot, numbers: Numbers = EXACT) -> str:
    return f"at the knot {numbers(item.parameter)}"


@words.register
def _(item: e.Isolated, numbers: Numbers = EXACT) -> str:
    return f"between {numbers(item.low)} and {numbers(item.high)}"


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


@words.register
def _(item: e.UnderEvery, numbers: Numbers = EXACT) -> str:
    return f"under every {item.group}"


@words.register
def _(item: e.ForDegrees, numbers: Numbers = EXACT) -> str:
    return f"d = {item.first}…{item.last}"


# ---- witnesses of any kind of claim


@words.register
def _(item: e.Stopped, numbers: Numbers = EXACT) -> str:
    return numbers.within(str(item.error))


@words.register
def _(item: e.LeftToTheProof, numbers: Numbers = EXACT) -> str:
    return f"decided by the proof for all curves: {words(item.why, numbers)}"


@words.register
def _(item: e.TooLong, numbers: Numbers = EXACT) -> str:
    degree = f"degree {item.degree} in {item.parameter}"
    return f"{item.formula} as written has {degree} there, too high to be multiplied out"


@words.register
def _(item: e.HeldOn, numbers: Numbers = EXACT) -> str:
    stopped = f": {numbers.within(item.error.problem)}" if item.error else ""
    return f"it holds, but was tried on a part only: {words(item.part, numbers)}{stopped}"


@words.register
def _(item: e.OnExample, numbers: Numbers = EXACT) -> str:
    what = "surface" if item.surface else "curve"
    return f"on the example {what} {item.name}: {worded(item.witness, numbers)}"


@words.register
def _(item: e.OnPart, numbers: Numbers = EXACT) -> str:
    return ", ".join(filter(None, (worded(item.witness, numbers), words(item.part, numbers))))


@words.register
def _(item: e.FailsWithOthers, numbers: Numbers = EXACT) -> str:
    place, operands, part = (words(each, numbers) for each in (item.place, item.operands, item.part))
    return f"it fails {place} {operands}, though not {part}"


@words.register
def _(item: e.Refutes, numbers: Numbers = EXACT) -> str:
    return f"proved for all curves, but refuted: {worded(item.witness, numbers)}"


@words.register
def _(item: e.JudgesDisagree, numbers: Numbers = EXACT) -> str:
    witness = worded(item.witness, numbers)
    return f"proved by {item.proved}, but refuted by {item.refuted}{f': {witness}' if witness else ''}"


@words.register
def _(item: e.AssumptionFails, numbers: Numbers = EXACT) -> str:
    return f"{item.assumption.subject} vanishes {words(item.place, numbers)}"


@words.register
def _(item: e.Undefined, numbers: Numbers = EXACT) -> str:
    return f"{item.formula} does not exist on all of this curve: 0/0"


@words.register
def _(item: e.UndefinedAt, numbers: Numbers = EXACT) -> str:
    return f"it does not exist {words(item.where, numbers)}: 1/0"


# ---- proof assistants


@words.register
def _(item: e.Theorem, numbers: Numbers = EXACT) -> str:
    return f"axioms {', '.join(item.axioms)}" if item.axioms else "no axioms"


@words.register
def _(item: e.NoTheorem, numbers: Numbers = EXACT) -> str:
    return f"not stated, {item.error.problem}"
