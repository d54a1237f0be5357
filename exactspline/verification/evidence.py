"""The results of checks as data: computed values, and witnesses of failures. What code reads has a class; everything
else is `Said`. Only `exactspline.display.evidence` puts them into words, and no code reads those words.

The fields are numbers, names, members of enumerations, and objects of algebra.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from functools import update_wrapper
from typing import Any, Generic, TypeVarTuple, dataclass_transform

from exactspline.errors import ExactSplineError
from exactspline.hooks import Worded
from exactspline.numbers.exact import mpq
from exactspline.readings.degree import Degree
from exactspline.readings.jet import Jet
from exactspline.symbolic.factorization import Factor
from exactspline.verification.vocabulary import Name, Relation

Ts = TypeVarTuple("Ts")


@dataclass_transform(frozen_default=True)
class Evidence(Worded):
    """A computed value, a witness, a place, or a part of the arguments of a claim; `str` puts it into words. Classes of
    evidence are frozen dataclasses or enumerations.
    """

    def __init_subclass__(cls) -> None:
        if not issubclass(cls, Enum):
            dataclass(frozen=True, repr=False)(cls)


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
    NO_GENERATOR = "no surface: the generator vanishes"
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
    ONE_SURFACE = "one surface"
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
    # the part that was tried, and the operands for which it was not
    FIRST_SEGMENTS = "first segment, with its moved copy"
    FIRST_PATCH = "the first patch"
    ONE_LINE = "one value of the other parameter"
    AS_HODOGRAPH = "as u, v and h of a hodograph"
    WITH_ITSELF = "with itself"
    ANY_SECOND_CURVE = "with any second curve"


class Said(Evidence):
    """A phrase, and the things that it is about."""

    phrase: Phrase[*tuple[Any, ...]]
    about: tuple[object, ...]


class Phrase(Generic[*Ts]):
    """A sentence about things of these types, written as the function that returns it. A call only keeps the things:
    the sentence is made where it is printed, by `words` of names and counts as they are, and of everything else in
    words, since there it is known how numbers are written.

    >>> from exactspline.verification.phrases import vanishes_always
    >>> said = vanishes_always("f1")
    >>> said.about, str(said)
    (('f1',), 'f1 vanishes on every curve')
    """

    def __init__(self, words: Callable[[*Ts], str]) -> None:
        self.words = words
        update_wrapper(self, words)

    def __call__(self, *about: *Ts) -> Said:
        """The phrase about these things."""
        return Said(self, about)

    def __repr__(self) -> str:
        return f"<Phrase {self.words.__name__}>"

    def __reduce__(self) -> str:
        return self.words.__name__


# ---- places


class At(Evidence):
    """One parameter; `from_left` where the limit from the left is meant."""

    parameter: mpq
    from_left: bool = False


class Between(Evidence):
    """One parameter, isolated."""

    low: mpq
    high: mpq


Place = At | Between | Said


# ---- witnesses of any kind of claim


class Stopped(Evidence):
    """A decision that ended in an error."""

    error: ExactSplineError


class HeldOn(Evidence):
    """A statement that was tried on a part only and held there; an error prevented further trials."""

    part: Evidence
    error: ExactSplineError | None = None


class OnExample(Evidence):
    """A witness on an example."""

    name: Name
    witness: Evidence | None
    surface: bool = False


class NoTheorem(Evidence):
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


class Difference(Evidence):
    """The difference of two sides at one place."""

    of: Sides
    by: mpq
    at: Place


class StatedFactor(Evidence):
    """A factor as stated in a claim; `is_one` if the factor is 1 on this curve."""

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


class Remainder(Evidence):
    """A differential polynomial that is not zero."""

    polynomial: Jet


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


class DegreeHere(Evidence):
    """The degree of splines (None for the value 0 of a claim about the generic curve), and the claimed number."""

    degree: int | None
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


# ---- zeros, signs, squares


class ZeroAt(Evidence):
    """A zero."""

    place: Place


# ---- surfaces


class Rulings(Evidence):
    """The relation of the ruling parameters ζ and λ of one surface: ``ζ = shift + scale · λ``."""

    scale: Factor
    shift: Factor | None = None


# ---- contact, invariance, condition


class Conditions(Evidence):
    """Enclosures of two condition numbers, zero by zero."""

    pairs: tuple[tuple[Enclosure, Enclosure], ...]


#: The type of a computed result: evidence, or a factor of differential polynomials.
Found = Evidence | Factor
