"""Evidence for any kind of claim: facts without numbers, places, attempts."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum, auto

from exactspline.errors import ExactSplineError
from exactspline.hooks import Worded
from exactspline.language.choices import Parameter
from exactspline.numbers.exact import mpq
from exactspline.symbolic.assumptions import Assumption
from exactspline.symbolic.factorization import Factor
from exactspline.verification.vocabulary import Group, Name


class Evidence(Worded):
    """A computed value, a witness, a place, or a part of the arguments of a claim; `str` puts it into words."""

    __slots__ = ()


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


@dataclass(frozen=True)
class At(Evidence):
    """One parameter; `from_left` where the limit from the left is meant."""

    parameter: mpq
    from_left: bool = False


@dataclass(frozen=True)
class Between(Evidence):
    """One parameter, isolated."""

    low: mpq
    high: mpq


@dataclass(frozen=True)
class OnAllOf(Evidence):
    """A whole segment."""

    low: mpq
    high: mpq


@dataclass(frozen=True)
class On(Evidence):
    """Somewhere on a segment."""

    low: mpq
    high: mpq


@dataclass(frozen=True)
class AtBoth(Evidence):
    """Values of two parameters."""

    s: mpq
    t: mpq


@dataclass(frozen=True)
class OnPatch(Evidence):
    """A patch by its indices; `perhaps` where signs could not be decided."""

    i: int
    j: int
    perhaps: bool = False


@dataclass(frozen=True)
class OnWholePatch(Evidence):
    """Some patch as a whole."""


@dataclass(frozen=True)
class AtKnot(Evidence):
    """A zero at a knot."""

    parameter: mpq


@dataclass(frozen=True)
class Isolated(Evidence):
    """A zero in an interval."""

    low: mpq
    high: mpq


Place = At | Between | OnAllOf | On | AtBoth | OnPatch | OnWholePatch


# ---- free arguments, and the part that was tried


@dataclass(frozen=True)
class Chosen(Evidence):
    """A point and constants in addition to the curve."""

    point: tuple[mpq, ...] = ()
    constants: tuple[tuple[Name, mpq], ...] = ()


@dataclass(frozen=True)
class AnyOperands(Evidence):
    """The free operands in addition to the curve: a second curve, or a point and constants."""

    second_curve: bool = False
    point: bool = False
    constants: tuple[Name, ...] = ()


@dataclass(frozen=True)
class UnderEvery(Evidence):
    """Every element of a group."""

    group: Group


@dataclass(frozen=True)
class ForDegrees(Evidence):
    """The degrees for which something was tried."""

    first: int
    last: int


# ---- witnesses of any kind of claim


@dataclass(frozen=True)
class Stopped(Evidence):
    """A decision that ended in an error."""

    error: ExactSplineError


@dataclass(frozen=True)
class LeftToTheProof(Evidence):
    """Not tried: the proof for all curves decides it."""

    why: Evidence


@dataclass(frozen=True)
class TooLong(Evidence):
    """A formula whose value as written has too high a degree in a parameter to be multiplied out."""

    formula: Name
    degree: int
    parameter: Parameter


@dataclass(frozen=True)
class HeldOn(Evidence):
    """It was tried on a part only, and held there; more could not be tried because of an error."""

    part: Evidence
    error: ExactSplineError | None = None


@dataclass(frozen=True)
class OnExample(Evidence):
    """A witness on an example."""

    name: Name
    witness: Evidence | None
    surface: bool = False


@dataclass(frozen=True)
class OnPart(Evidence):
    """A witness on a part."""

    witness: Evidence | None
    part: Evidence


@dataclass(frozen=True)
class FailsWithOthers(Evidence):
    """It fails at a place for some additional operands, though not for those that were tried."""

    place: Place
    operands: AnyOperands
    part: Evidence


@dataclass(frozen=True)
class Refutes(Evidence):
    """A witness against a statement proved for all curves."""

    witness: Evidence | None


@dataclass(frozen=True)
class JudgesDisagree(Evidence):
    """One judge proves what another one refutes."""

    proved: Name
    refuted: Name
    witness: Evidence | None


@dataclass(frozen=True)
class AssumptionFails(Evidence):
    """An assumption that fails on this curve."""

    assumption: Assumption
    place: Place


@dataclass(frozen=True)
class Undefined(Evidence):
    """A formula that does not exist on the whole curve."""

    formula: Name


@dataclass(frozen=True)
class UndefinedAt(Evidence):
    """A value with a division by zero on a segment, or for all operands."""

    where: On | AnyOperands


# ---- proof assistants


@dataclass(frozen=True)
class Theorem(Evidence):
    """A theorem that a kernel accepted, and the axioms that it uses."""

    name: Name
    axioms: tuple[Name, ...] = ()


@dataclass(frozen=True)
class NoTheorem(Evidence):
    """Why a claim is not stated as a theorem."""

    error: ExactSplineError


#: The type of a computed result: evidence, or a factor of differential polynomials.
Found = Evidence | Factor
