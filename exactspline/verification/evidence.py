"""The results of checks as data: computed values, and witnesses of failures. Only `exactspline.display.evidence` puts
them into words, and no code parses those words.

The fields are numbers, names, members of enumerations, and objects of algebra.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum, auto
from typing import dataclass_transform

from exactspline.errors import ExactSplineError
from exactspline.hooks import Worded
from exactspline.language.choices import Parameter
from exactspline.numbers.exact import mpq
from exactspline.readings.degree import Degree
from exactspline.readings.jet import Jet
from exactspline.symbolic.assumptions import Assumption
from exactspline.symbolic.factorization import Factor
from exactspline.verification.vocabulary import Counter, Group, Name, Relation, Sign, ValueType


@dataclass_transform(frozen_default=True)
class Evidence(Worded):
    """A computed value, a witness, a place, or a part of the arguments of a claim; `str` puts it into words.

    Every kind of evidence is a frozen dataclass.
    """

    def __init_subclass__(cls) -> None:
        if not issubclass(cls, Enum):
            dataclass(frozen=True)(cls)


class Fact(Evidence, Enum):
    """Evidence without numbers."""

    # nothing to decide
    NOTHING = auto()
    VANISHES = auto()
    ALL_VANISH = auto()
    NO_SIDE = auto()
    NOWHERE = auto()
    NO_FACTOR = auto()
    NO_VALUE = auto()
    NO_COMMON_ZERO = auto()
    NO_JOINT = auto()
    NOT_HERE = auto()
    # what holds
    ZERO = auto()
    NONE_VANISHES = auto()
    NONE_VANISHES_FOR_ANY_DEGREE = auto()
    RATIONAL = auto()
    SQUARE = auto()
    SQUARES_ONE_WITHOUT_ZERO = auto()
    ONE_ZERO_SET = auto()
    CURVE_OF_ZERO_ZETA = auto()
    APPLIES = auto()
    # what does not
    NOT_PROPORTIONAL = auto()
    NOT_IDENTICAL = auto()
    NOT_ZERO = auto()
    DIVIDED_BY_ZERO = auto()
    ONE_VANISHES = auto()
    DIFFERENT = auto()
    DIFFERENT_ZERO_SETS = auto()
    TWO_SURFACES = auto()
    OTHER_CURVE = auto()
    OTHER_SIGN = auto()
    HAS_ZERO = auto()
    NOT_SO = auto()
    NO_CONTACT = auto()
    LESS_CONTACT = auto()
    # why
    FACTOR_DIVIDED_BY_ZERO = auto()
    POLYNOMIALS_NOT_PROPORTIONAL = auto()
    POLYNOMIAL_NOT_ZERO = auto()
    RIGHT_SIDE_VANISHES = auto()
    OTHER_NUMBER_OF_COMPONENTS = auto()
    GENERATORS_APART = auto()
    CURVES_DIFFER = auto()
    OTHER_SQUARES = auto()
    NO_SQUARES = auto()
    SQUARES_MAY_VANISH = auto()
    SINGULAR_CONTACT = auto()
    NO_COUNTEREXAMPLE = auto()
    DENOMINATOR_DIVIDES_OUT = auto()
    MADE_BY_ARITHMETIC = auto()
    NO_CURVE_OF_THIS_TYPE = auto()
    # why nothing is decided of one curve
    LOWER_DEGREE_HERE = auto()
    HIGHER_CONTACT_HERE = auto()
    TOO_FEW_DERIVATIVES = auto()
    ZEROS_IN_TWO_PARAMETERS = auto()
    NO_COMMON_KNOTS = auto()
    ROOT_IS_RATIONAL = auto()
    NOT_OF_THIS_JUDGE = auto()
    COQ_NOT_INSTALLED = auto()
    NOT_ACCEPTED = auto()
    # the part that was tried
    FIRST_SEGMENTS = auto()
    FIRST_PATCH = auto()
    ONE_LINE = auto()
    AS_HODOGRAPH = auto()
    WITH_ITSELF = auto()


# ---- places


class At(Evidence):
    """One parameter; `from_left` where the limit from the left is meant."""

    parameter: mpq
    from_left: bool = False


class Between(Evidence):
    """One parameter, isolated."""

    low: mpq
    high: mpq


class OnAllOf(Evidence):
    """A whole segment."""

    low: mpq
    high: mpq


class On(Evidence):
    """Somewhere on a segment."""

    low: mpq
    high: mpq


class AtBoth(Evidence):
    """Values of two parameters."""

    s: mpq
    t: mpq


class OnPatch(Evidence):
    """A patch by its indices; `perhaps` where signs could not be decided."""

    i: int
    j: int
    perhaps: bool = False


class OnWholePatch(Evidence):
    """Some patch as a whole."""


class AtKnot(Evidence):
    """A zero at a knot."""

    parameter: mpq


class Isolated(Evidence):
    """A zero in an interval."""

    low: mpq
    high: mpq


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


class UnderEvery(Evidence):
    """Every element of a group."""

    group: Group


class ForDegrees(Evidence):
    """The degrees for which something was tried."""

    first: int
    last: int


# ---- witnesses of any kind of claim


class Stopped(Evidence):
    """A decision that ended in an error."""

    error: ExactSplineError


class LeftToTheProof(Evidence):
    """Not tried: the proof for all curves decides it."""

    why: Evidence


class TooLong(Evidence):
    """A formula whose value as written has too high a degree in a parameter to be multiplied out."""

    formula: Name
    degree: int
    parameter: Parameter


class HeldOn(Evidence):
    """It was tried on a part only, and held there; more could not be tried because of an error."""

    part: Evidence
    error: ExactSplineError | None = None


class OnExample(Evidence):
    """A witness on an example."""

    name: Name
    witness: Evidence | None
    surface: bool = False


class OnPart(Evidence):
    """A witness on a part."""

    witness: Evidence | None
    part: Evidence


class FailsWithOthers(Evidence):
    """It fails at a place for some additional operands, though not for those that were tried."""

    place: Place
    operands: AnyOperands
    part: Evidence


class Refutes(Evidence):
    """A witness against a statement proved for all curves."""

    witness: Evidence | None


class JudgesDisagree(Evidence):
    """One judge proves what another one refutes."""

    proved: Name
    refuted: Name
    witness: Evidence | None


class AssumptionFails(Evidence):
    """An assumption that fails on this curve."""

    assumption: Assumption
    place: Place


class Undefined(Evidence):
    """A formula that does not exist on the whole curve."""

    formula: Name


class UndefinedAt(Evidence):
    """A value with a division by zero on a segment, or for all operands."""

    where: On | AnyOperands


# ---- proof assistants


class Theorem(Evidence):
    """A theorem that a kernel accepted, and the axioms that it uses."""

    name: Name
    axioms: tuple[Name, ...] = ()


class NoTheorem(Evidence):
    """Why a claim is not stated as a theorem."""

    error: ExactSplineError


#: An enclosure of a number.
Enclosure = tuple[mpq, mpq]


# ---- identities


class Sides(Enum):
    """What differs."""

    SIDES = auto()
    ZERO = auto()
    SURFACES = auto()


class Difference(Evidence):
    """The difference of two sides at one place."""

    of: Sides
    by: mpq
    at: At | AtBoth


class StatedFactor(Evidence):
    """A factor as stated in a claim; `is_one` where it is 1 on this curve."""

    powers: tuple[tuple[Name, int], ...]
    is_one: bool = False


class Relating(Evidence):
    """``left = factor · right``, the sides by name."""

    left: Name
    factor: Factor | StatedFactor
    right: Name


class ExactQuotient(Evidence):
    """The true quotient of two sides."""

    quotient: Factor


class Components(Evidence):
    """Vectors of different numbers of components."""

    left: int
    right: int


class ComponentDiffers(Evidence):
    """The first component (counted from 1) in which two sides differ."""

    component: int


class ComponentNotZero(Evidence):
    """The first component (counted from 1) that is not zero."""

    component: int


class Remainder(Evidence):
    """A differential polynomial that is not zero."""

    polynomial: Jet


class NotItsDefinition(Evidence):
    """A formula that does not equal its definition."""

    formula: Name
    definition: Name


class RationalForm(Evidence):
    """A formula that is a quotient of polynomials, and the definition claimed not to be one."""

    formula: Name
    definition: Name


class RationalOfDegree(Evidence):
    """Rational of some degree on this curve."""

    degree: int


# ---- degrees and counts


class DegreeFound(Evidence):
    """A degree for all d: `grading` are k, m and j; it is as claimed for d ≥ `start`; for single exceptional d it
    differs, or the value is 0; `as_written` where the value vanishes on every curve.
    """

    degree: Degree
    grading: tuple[int, int, int] | None = None
    as_written: bool = False
    start: int = 1
    lower: tuple[int, ...] = ()
    zero: tuple[int, ...] = ()


class DegreeHere(Evidence):
    """The degree of splines, and the claimed number."""

    degree: int
    claimed: int
    relation: Relation


class ZeroHere(Evidence):
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
    """Numbers of a caption; None where there is none."""

    numbers: tuple[tuple[int | None, Counter], ...]


class CoefficientIsZero(Evidence):
    """A coefficient that is zero for every curve of a degree (None: all are)."""

    degree: int
    index: int | None = None


class OnlyForDegrees(Evidence):
    """No coefficient vanishes for some degrees."""

    degrees: ForDegrees


class ZeroCoefficient(Evidence):
    """A coefficient of a formula that is zero on this curve."""

    formula: Name
    index: int


class ZeroForDegree(Evidence):
    """Coefficients that vanish for every curve of a degree: one, or (None) all."""

    degree: int
    index: int | None = None


# ---- zeros, signs, squares


class VanishesAlways(Evidence):
    """A formula that vanishes on every curve."""

    formula: Name


class VanishesAlone(Evidence):
    """A zero of one formula that is not a zero of another."""

    formula: Name
    place: Place
    other: Name


class ZeroAt(Evidence):
    """A zero."""

    place: Place


class HasSign(Evidence):
    """A sign."""

    sign: Sign


class SumOfSquares(Evidence):
    """A sum of this many squares."""

    squares: int


class Quotients(Evidence):
    """The quotients of one formula by others; None where they are not proportional."""

    formula: Name
    by: tuple[tuple[Name, Factor | None], ...]


class OddPowers(Evidence):
    """Irreducible factors that occur an odd number of times."""

    names: tuple[Name, ...]


class Squares(Evidence):
    """The number of segments on which a formula is a square up to a constant, and of those on which it is 0."""

    formula: Name
    squares: int
    segments: int
    zero: int


class SquareOnSegment(Evidence):
    """A segment on which one of two formulas is a square and the other is not."""

    segment: int


# ---- surfaces


class OneSurface(Evidence):
    """One surface, except where irreducible factors vanish."""

    but: tuple[Name, ...] = ()


class OneSurfaceBut(Evidence):
    """One surface, except where the generator of a formula vanishes."""

    place: Place
    formula: Name


class NoGenerator(Evidence):
    """A generator that vanishes: that of a formula on every curve, or (None) on a whole segment of this one."""

    formula: Name | None = None


class Rulings(Evidence):
    """How the ruling parameters ζ and λ of one surface are related: ``ζ = shift + scale · λ``."""

    scale: Factor
    shift: Factor | None = None


# ---- contact, invariance, condition


class ContactOrder(Evidence):
    """An order of contact (−1: the object does not pass through the point)."""

    order: int
    relation: Relation = Relation.EQUAL


class AtLeast(Evidence):
    """At least this order."""

    order: int


class Vanishes(Evidence):
    """A value that is 0 on a segment."""

    where: On


class DerivativeAt(Evidence):
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
    """The value under a map: a multiple of the claimed one, or (None) not proportional to it."""

    map: Name
    factor: Factor | None = None


class DifferUnder(Evidence):
    """Where the sides differ under a map."""

    map: Name
    place: At | On


class Conditions(Evidence):
    """Enclosures of two condition numbers, zero by zero."""

    pairs: tuple[tuple[Enclosure, Enclosure], ...]


class NotBetter(Evidence):
    """A zero at which the condition number is not smaller."""

    zero: AtKnot | Isolated


# ---- types


class OfType(Evidence):
    """The type of a value."""

    type: ValueType


class TypeOnExample(Evidence):
    """The type on an example curve, or on cubic polynomials where the name is empty; `rational_everywhere` where the
    value is a quotient of polynomials on every curve.
    """

    type: ValueType
    curve: Name
    rational_everywhere: bool


class TypeHere(Evidence):
    """The type on the given curve; `special` where it is more special than on the generic curve."""

    type: ValueType
    special: bool = False


class OfKind(Evidence):
    """The kind of argument of a formula."""

    kind: Name


class OfAnotherKind(Evidence):
    """A formula, the kind of its argument, and the requested kind."""

    formula: Name
    kind: Name
    asked: Name


#: The type of a computed result: evidence, or a factor of differential polynomials.
Found = Evidence | Factor
