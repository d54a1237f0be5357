"""The results of checks as data: computed values, and witnesses of failures. Only `exactspline.display.evidence` puts
them into words, if possible by the template of their class, and no code reads those words.

The fields are numbers, names, members of enumerations, and objects of algebra.
"""

from __future__ import annotations

from enum import Enum

from exactspline.errors import ExactSplineError
from exactspline.hooks import WordedData
from exactspline.language.operand import Parameter
from exactspline.numbers.exact import mpq
from exactspline.readings.degree import Degree
from exactspline.readings.jet import Jet
from exactspline.reals.real import Real
from exactspline.symbolic.assumptions import Assumption
from exactspline.symbolic.factorization import Factor
from exactspline.verification.vocabulary import Counter, Group, Name, Relation, Sign, ValueType


class Evidence(WordedData):
    """A computed value, a witness, a place, or a part of the arguments of a claim; `str` puts it into words."""


class Fact(Evidence, Enum):
    """Evidence without numbers, each with its phrase."""

    # findings that there is nothing to decide
    NOTHING = "0 = 0"
    ALL_VANISH = "all vanish"
    NO_SIDE = "a side does not exist on all of this curve: 0/0"
    NOWHERE = "a side exists on no curve: 0/0"
    NO_FACTOR = "the factor does not exist on all of this curve: 1/0"
    NO_VALUE = "it does not exist on all of this curve: 1/0"
    NO_VALUE_THERE = "it does not exist at this parameter: 1/0"
    NO_COMMON_ZERO = "no zero in common"
    NOT_ISOLATED = "a side vanishes on a whole segment, whose points have no condition number"
    NO_JOINT = "one segment: nothing is joined"
    NOT_HERE = "does not exist here"
    # true statements
    ZERO = "0"
    NONE_VANISHES = "none vanishes"
    NONE_VANISHES_FOR_ANY_DEGREE = (
        "none vanishes for any d ≥ 1: coefficients 2k and 2k + 1 contain the product of control point k + 1 and "
        "weight k"
    )
    RATIONAL = "rational"
    SQUARE = "a square"
    SQUARES_ONE_WITHOUT_ZERO = "a sum of squares, one without a zero"
    ONE_ZERO_SET = "one zero set"
    CURVE_OF_ZERO_ZETA = "the curve ζ = 0"
    APPLIES = "it applies"
    AS_CLAIMED = "as claimed"
    EQUAL_EVERYWHERE = "equal everywhere"
    # false statements
    NOT_PROPORTIONAL = "not proportional"
    NOT_IDENTICAL = "not identical"
    NOT_ZERO = "not zero"
    DIVIDED_BY_ZERO = "1/0"
    ONE_VANISHES = "one vanishes"
    DIFFERENT = "different"
    DIFFERENT_ZERO_SETS = "different zero sets"
    TWO_SURFACES = "two surfaces"
    OTHER_CURVE = "another curve"
    OTHER_SIGN = "it has the other sign"
    HAS_ZERO = "zero"
    NOT_SO = "not so"
    NO_CONTACT = "no contact"
    LESS_CONTACT = "less"
    # why
    FACTOR_DIVIDED_BY_ZERO = "the factor is divided by zero"
    POLYNOMIALS_NOT_PROPORTIONAL = "the jet polynomials are not proportional"
    POLYNOMIAL_NOT_ZERO = "the jet polynomial is not zero"
    RIGHT_SIDE_VANISHES = "the right side vanishes, the left does not"
    OTHER_NUMBER_OF_COMPONENTS = "not as many components"
    GENERATORS_APART = "the generators are not parallel, or the directrices differ across them"
    CURVES_DIFFER = "the two curves differ"
    OTHER_SQUARES = "not the sum of these squares"
    NO_SQUARES = "no squares are named"
    SINGULAR_CONTACT = (
        "as a function of the point at s̄ it is singular where the points meet: it defines no object there"
    )
    NO_COUNTEREXAMPLE = "no degrees were found for which it fails"
    DENOMINATOR_DIVIDES_OUT = "its denominator divides out on every curve"
    MADE_BY_ARITHMETIC = (
        "it is made of the operands by + − × ÷ and derivatives: a quotient of polynomials on every curve"
    )
    NO_CURVE_OF_THIS_TYPE = "no example curve shows of which type it is"
    NOT_SEPARATED = "the enclosures of two condition numbers overlap"
    ROOTS_REMAIN = "it is not a multiple of a product of the roots ‖γ′‖ and ‖γ′×γ″‖: its zeros are not compared"
    # reasons why nothing is decided on one curve
    LOWER_DEGREE_HERE = "the degree is lower on it, as it may be on special ones"
    HIGHER_CONTACT_HERE = "the contact is of a higher order on it, as it may be on special curves"
    TOO_FEW_DERIVATIVES = "its degree is lower than the order of a derivative"
    ZEROS_IN_TWO_PARAMETERS = "zeros in two parameters are not compared on one surface"
    NO_COMMON_KNOTS = "the operands of Table 1 have no knots in common"
    ROOT_IS_RATIONAL = "a root is itself rational on it"
    NOT_OF_THIS_JUDGE = "not asked: it decides equalities alone"
    COQ_NOT_INSTALLED = "Coq is not installed"
    NOT_ACCEPTED = "not accepted"
    # the part that was tried
    FIRST_SEGMENTS = "first segment, with its moved copy"
    FIRST_PATCH = "the first patch"
    ONE_LINE = "one value of the other parameter"
    AS_HODOGRAPH = "as u, v and h of a hodograph"
    WITH_ITSELF = "with itself"


# ---- places


class At(Evidence, words="at the parameter {parameter}{from_left? (from the left)}"):
    """One parameter; `from_left` where the limit from the left is meant."""

    parameter: mpq
    from_left: bool = False


class Between(Evidence):
    """One parameter, isolated."""

    low: mpq
    high: mpq


class OnAllOf(Evidence, words="on all of [{low}, {high}]"):
    """A whole segment."""

    low: mpq
    high: mpq


class On(Evidence, words="on [{low}, {high}]"):
    """An unknown place on a segment."""

    low: mpq
    high: mpq


class AtBoth(Evidence, words="at the parameters {s} and {t}"):
    """Values of two parameters."""

    s: mpq
    t: mpq


class OnPatch(Evidence, words="{possibly?possibly }on patch {i}, {j}"):
    """A patch by its indices; `possibly` where signs could not be decided."""

    i: int
    j: int
    possibly: bool = False


class OnWholePatch(Evidence, words="on a whole patch"):
    """Some patch as a whole."""


Place = At | Between | OnAllOf | On | AtBoth | OnPatch | OnWholePatch


# ---- free arguments, and the part that was tried


class Chosen(Evidence):
    """A point and constants in addition to the curve."""

    point: tuple[mpq, ...] = ()
    constants: tuple[tuple[Name, mpq], ...] = ()


class AnyOperands(Evidence):
    """The free operands in addition to the curve: a second curve, or a point and constants."""

    second_curve: bool = False
    point: bool = False
    constants: tuple[Name, ...] = ()


class UnderEvery(Evidence, words="under every {group}"):
    """Every element of a group."""

    group: Group


class ForDegrees(Evidence, words="d = {first}…{last}"):
    """The degrees for which something was tried."""

    first: int
    last: int


# ---- witnesses of any kind of claim


class Stopped(Evidence, words="{error}"):
    """A decision that ended in an error."""

    error: ExactSplineError


class LeftToTheProof(Evidence, words="decided by the proof for all curves: {why}"):
    """Not tried: the proof for all curves decides it."""

    why: Evidence


class TooLong(
    Evidence, words="{formula} as written has degree {degree} in {parameter} there, too high to be multiplied out"
):
    """A formula whose value as written has too high a degree in a parameter to be multiplied out."""

    formula: Name
    degree: int
    parameter: Parameter


class HeldOn(Evidence):
    """A statement that was tried on a part only and held there; an error prevented further trials."""

    part: Evidence
    error: ExactSplineError | None = None


class OnExample(Evidence, words="on the example {surface?surface|curve} {name}: {witness}"):
    """A witness on an example."""

    name: Name
    witness: Evidence | None
    surface: bool = False


class OnPart(Evidence, words="{witness}{witness?, }{part}"):
    """A witness on a part."""

    witness: Evidence | None
    part: Evidence


class FailsWithOthers(Evidence, words="it fails {place} {operands}, though not {part}"):
    """It fails at a place for some additional operands, though not for those that were tried."""

    place: Place
    operands: AnyOperands
    part: Evidence


class Refutes(Evidence, words="proved for all curves, but refuted: {witness}"):
    """A witness against a statement proved for all curves."""

    witness: Evidence | None


class JudgesDisagree(Evidence, words="proved by {proved}, but refuted by {refuted}{witness?: }{witness}"):
    """One verifier proves a claim that another one refutes."""

    proved: Name
    refuted: Name
    witness: Evidence | None


class AssumptionFails(Evidence, words="{assumption.subject} vanishes {place}"):
    """An assumption that fails on this curve."""

    assumption: Assumption
    place: Place


class Undefined(Evidence, words="{formula} does not exist on all of this curve: 0/0"):
    """A formula that does not exist on the whole curve."""

    formula: Name


class UndefinedAt(Evidence, words="it does not exist {where}: 1/0"):
    """A value with a division by zero on a segment, or for all operands."""

    where: On | AnyOperands


# ---- proof assistants


class Theorem(Evidence, words="{axioms?axioms {axioms:, }|no axioms}"):
    """A theorem that a kernel accepted, and the axioms that it uses."""

    name: Name
    axioms: tuple[Name, ...] = ()


class NoTheorem(Evidence, words="not stated, {error.problem}"):
    """The reason why a claim is not stated as a theorem."""

    error: ExactSplineError


#: An enclosure of a number.
Enclosure = tuple[mpq, mpq]


# ---- identities


class Sides(Evidence, Enum):
    """The things that differ."""

    SIDES = "the sides differ"
    ZERO = "it differs from 0"
    SURFACES = "they differ"


class Difference(Evidence, words="{of} by {by} {at}"):
    """The difference of two sides at one place."""

    of: Sides
    by: mpq
    at: At | AtBoth


class StatedFactor(Evidence):
    """A factor as stated in a claim; `is_one` if the factor is 1 on this curve."""

    powers: tuple[tuple[Name, int], ...]
    is_one: bool = False


class Relating(Evidence):
    """``left = factor · right``, the sides by name."""

    left: Name
    factor: Factor | StatedFactor
    right: Name


class ExactQuotient(Evidence, words="the exact quotient is {quotient}"):
    """The true quotient of two sides."""

    quotient: Factor


class Components(Evidence, words="{left} components, and {right}"):
    """Vectors of different numbers of components."""

    left: int
    right: int


class ComponentDiffers(Evidence, words="component {component} {from_zero?is not zero|differs}"):
    """The first component (counted from 1) in which two sides differ, or that is not zero."""

    component: int
    from_zero: bool = False


class Remainder(Evidence):
    """A differential polynomial that is not zero."""

    polynomial: Jet


class NotItsDefinition(Evidence, words="{formula} is not {definition}"):
    """A formula that does not equal its definition."""

    formula: Name
    definition: Name


class RationalForm(Evidence, words="{formula} is a quotient of polynomials in the curve, and is {definition}"):
    """A formula that is a quotient of polynomials, and the definition claimed not to be one."""

    formula: Name
    definition: Name


class RationalOfDegree(Evidence, words="rational of degree {degree}"):
    """Rational of some degree on this curve."""

    degree: int


# ---- degrees and counts


class DegreeFound(Evidence):
    """A degree for all d, with its `grading` k, m and j. It is as claimed for d ≥ `start`, except for single d at which
    it differs, or the value is 0. `as_written` says that the value vanishes on every curve.
    """

    degree: Degree
    grading: tuple[int, int, int] | None = None
    as_written: bool = False
    start: int = 1
    lower: tuple[int, ...] = ()
    zero: tuple[int, ...] = ()


class DegreeHere(Evidence, words="{degree}"):
    """The degree of splines, and the claimed number."""

    degree: int
    claimed: int
    relation: Relation


class ZeroHere(Evidence, words="0"):
    """A value that is 0, so that it has no degree, and the claimed number."""

    claimed: int
    relation: Relation


class WrongDegree(Evidence):
    """A degree that differs from the claimed one, for some degrees of the operands (None: on one curve; empty: for
    all).
    """

    degree: int
    claimed: int
    relation: Relation
    at: tuple[tuple[Name, int], ...] | None = None


class Counted(Evidence):
    """Numbers of a caption; None if there is none."""

    numbers: tuple[tuple[int | None, Counter], ...]


class CoefficientIsZero(Evidence):
    """A coefficient that is zero for every curve of a degree (None: all coefficients are)."""

    degree: int
    index: int | None = None


class OnlyForDegrees(Evidence, words="none vanishes for {degrees}"):
    """No coefficient vanishes for some degrees."""

    degrees: ForDegrees


class ZeroCoefficient(Evidence, words="coefficient {index} of {formula} {segment} is {value}"):
    """A Bézier coefficient of a formula on a segment of this curve that is zero, or has another sign."""

    formula: Name
    index: int
    segment: On
    value: mpq


# ---- zeros, signs, squares


class VanishesAlways(Evidence, words="{formula} vanishes on every curve"):
    """A formula that vanishes on every curve."""

    formula: Name


class VanishesAlone(Evidence, words="{formula} vanishes {place}, {other} does not"):
    """A zero of one formula that is not a zero of another."""

    formula: Name
    place: Place | AlongLine
    other: Name


class ZerosOf(Evidence, words="{factors?where {factors: or } vanishes|nowhere}"):
    """The irreducible factors on whose zeros formulas vanish together."""

    factors: tuple[Name, ...]


class MayVanish(Evidence, words="{factors: and } may have zeros{assume?: assume {assume: and }}"):
    """Irreducible factors that prevent a proof, and the assumptions that exclude their zeros."""

    factors: tuple[Name, ...]
    assume: tuple[Name, ...] = ()


class AlongLine(Evidence, words="{place}, at {parameter} = {value} of the other curve,"):
    """A place on one of two curves, the point on the other being fixed."""

    place: Place
    parameter: Parameter
    value: mpq


class ZeroAt(Evidence, words="zero {place}"):
    """A zero."""

    place: Place


class Value(Evidence, words="{value?{value}|∞}"):
    """A value: a number, or the components of a vector; nothing for ∞."""

    value: tuple[mpq | Real, ...]


class ValueAt(Evidence, words="{squared?its length has the square|it is} {value?{value}|∞} {place}"):
    """A value at a place; `squared` if it is the square of a length."""

    value: tuple[mpq, ...]
    place: Place
    squared: bool = False


class HasSign(Evidence, words="{sign}"):
    """A sign."""

    sign: Sign


class SumOfSquares(Evidence):
    """A sum of this many squares."""

    squares: int


class Quotients(Evidence):
    """The quotients of one formula by others; None for a formula that is not proportional."""

    formula: Name
    by: tuple[tuple[Name, Factor | None], ...]


class OddPowers(Evidence, words="odd powers of {names:·}"):
    """Irreducible factors that occur an odd number of times."""

    names: tuple[Name, ...]


class Squares(
    Evidence, words="{formula} is a square up to a constant on {squares} of {segments} segments{zero?, 0 on {zero}}"
):
    """The number of segments on which a formula is a square up to a constant, and of those on which it is 0."""

    formula: Name
    squares: int
    segments: int
    zero: int


class SquareOnSegment(Evidence, words="on segment {segment} one is a square and the other is not"):
    """A segment on which one of two formulas is a square and the other is not."""

    segment: int


# ---- surfaces


class OneSurface(Evidence, words="one surface{but?, except where {but: or } vanishes}"):
    """One surface, except where irreducible factors vanish."""

    but: tuple[Name, ...] = ()


class OneSurfaceBut(Evidence, words="one surface, except {place}, where the generator of {formula} vanishes"):
    """One surface, except where the generator of a formula vanishes."""

    place: Place
    formula: Name


class NoGenerator(Evidence, words="no surface: the generator{formula? of }{formula} vanishes{formula? on every curve}"):
    """A generator that vanishes: that of a formula on every curve, or (None) on a whole segment of this one."""

    formula: Name | None = None


class Rulings(Evidence):
    """The relation of the ruling parameters ζ and λ of one surface: ``ζ = shift + scale · λ``."""

    scale: Factor
    shift: Factor | None = None


# ---- contact, invariance, condition


class ContactOrder(Evidence):
    """An order of contact (−1: the object does not pass through the point)."""

    order: int
    relation: Relation = Relation.EQUAL


class AtLeast(Evidence, words="at least {order}"):
    """At least this order."""

    order: int


class Vanishes(Evidence, words="0 {where}"):
    """A value that is 0 on a segment."""

    where: On


class DerivativeAt(
    Evidence,
    words="{order?the derivative of order {order} in s̄|the value} is {is_zero?= 0|≠ 0} at s̄ = s"
    "{place? {place}|{is_zero? on every curve}}",
):
    """A derivative with respect to s̄ at s̄ = s that is zero on every curve, or one that is not (at a place, on one
    curve).
    """

    order: int
    is_zero: bool = False
    place: At | On | None = None


class Weight(Evidence):
    """The power of the unit of a group by which a value is multiplied."""

    under: Group
    weight: int


class UnderMap(Evidence):
    """The value under a map: a multiple of the claimed one, or (None) another one."""

    map: Name
    factor: Factor | None = None


class DifferUnder(Evidence):
    """The place where the sides differ under a map."""

    map: Name
    place: At | On


class Conditions(Evidence):
    """Enclosures of two condition numbers, zero by zero."""

    pairs: tuple[tuple[Enclosure, Enclosure], ...]


class NotBetter(Evidence, words="not better {place}"):
    """A zero at which the condition number is not smaller."""

    place: Place


# ---- types


class OfType(Evidence, words="{type}"):
    """The type of a value."""

    type: ValueType


class TypeOnExample(
    Evidence,
    words="{type} {curve?on the example curve {curve}|for cubic polynomials}{rational_everywhere?; "
    f"{Fact.MADE_BY_ARITHMETIC.value}}}",
):
    """The type on an example curve, or on cubic polynomials where the name is empty; `rational_everywhere` where the
    value is a quotient of polynomials on every curve.
    """

    type: ValueType
    curve: Name
    rational_everywhere: bool


class TypeHere(Evidence, words="it is {type} on {special?it, as it may be on special curves|this curve}"):
    """The type on the given curve; `special` if this type is more special than that on the generic curve."""

    type: ValueType
    special: bool = False


class OfKind(Evidence, words="its arguments are of the kind '{kind}'"):
    """The kind of argument of a formula."""

    kind: Name


class OfAnotherKind(Evidence, words="{formula} is a formula of '{kind}', not of '{asked}'"):
    """A formula, the kind of its argument, and the requested kind."""

    formula: Name
    kind: Name
    asked: Name


#: The type of a computed result: evidence, or a factor of differential polynomials.
Found = Evidence | Factor
