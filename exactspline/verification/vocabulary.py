"""The words of claims: each is a member of an enumeration, so that none has two spellings."""

from __future__ import annotations

from enum import StrEnum
from typing import NewType, TypeVar

from exactspline.errors import ClaimError
from exactspline.numbers.exact import mpq
from exactspline.reals.real import Real
from exactspline.words import Word, choice

E = TypeVar("E", bound=StrEnum)
#: The name or the key of a formula, a curve, a constant, a map or a theorem; never a sentence.
Name = NewType("Name", str)


class Verdict(Word):
    """The result of a check. PROVED means for all curves, VERIFIED on one curve, VACUOUS that there was nothing to
    decide (0 = 0 or 0/0), INAPPLICABLE that the claim is not about such a curve, CONTRADICTION that two computations
    contradict each other, NOT ASKED that the statement was not checked.
    """

    PROVED = "PROVED"
    VERIFIED = "VERIFIED"
    REFUTED = "REFUTED"
    UNDECIDED = "UNDECIDED"
    VACUOUS = "VACUOUS"
    INAPPLICABLE = "INAPPLICABLE"
    CONTRADICTION = "CONTRADICTION"
    NOT_ASKED = "NOT ASKED"


class Reason(StrEnum):
    """The reason why nothing was decided: the claim was not tried, because the proof for all curves decides it; it
    held, but only a part was tried (one segment, one point, one value of a constant); or it exceeds the bound on the
    cost.
    """

    LEFT = "not tried"
    SAMPLED = "tried on a part"
    COST = "out of reach"


class Status(StrEnum):
    """The source of a statement: the paper as printed, a correction of the paper, or this project."""

    PRINTED = "printed"
    MEANT = "meant"
    OURS = "ours"


class Scope(StrEnum):
    """The curves to which a claim applies: polynomial, rational, or both."""

    BOTH = "both"
    POLYNOMIAL = "polynomial"
    RATIONAL = "rational"

    @property
    def worlds(self) -> tuple[bool, ...]:
        """The cases of curves: False for rational ones, which come first, and True for polynomial ones."""
        return {"both": (False, True), "polynomial": (True,), "rational": (False,)}[self.value]


class Extent(StrEnum):
    """Whether a claim is about all curves, or about the one curve that it names."""

    ALL = "all curves"
    CURVE = "curve"


class ArgumentKind(StrEnum):
    """The arguments of the formulas of a claim: the kinds that are treated specially. There are more
    (`exactspline.language.kinds`).
    """

    CURVE = "curve"
    PLANE = "plane"
    SPACE = "space"
    TABLE = "table"
    PAIR = "pair"
    POINT = "point"
    PLANE_POINT = "plane point"


class Measure(StrEnum):
    """The degree that a claim is about: as counted by Table 1 of the paper, of the polynomial, of the value, or of the
    reduced form; or the height of a differential polynomial.
    """

    NOMINAL = "nominal"
    TRUE = "true"
    LOWEST_TERMS = "lowest terms"
    REDUCED = "reduced"
    HEIGHT = "height"

    @property
    def is_generic(self) -> bool:
        """Whether the degree on single curves may be lower than on the generic curve."""
        return self in (Measure.TRUE, Measure.LOWEST_TERMS, Measure.REDUCED)


class Relation(StrEnum):
    """The relation of a degree to the claimed number: equal, at most or at least."""

    EQUAL = "="
    AT_MOST = "≤"
    AT_LEAST = "≥"

    def holds(self, computed: int, claimed: int) -> bool:
        """Whether the relation holds between two numbers.

        >>> Relation.AT_MOST.holds(10, 11), Relation.EQUAL.holds(10, 11)
        (True, False)
        """
        return {"=": computed == claimed, "≤": computed <= claimed, "≥": computed >= claimed}[self.value]

    def bound(self, degree: object) -> str:
        """A degree preceded by the relation; without it for equality.

        >>> Relation.AT_MOST.bound(10), Relation.EQUAL.bound(10)
        ('≤ 10', '10')
        """
        return str(degree) if self is Relation.EQUAL else f"{self} {degree}"


class Sign(StrEnum):
    """The claimed sign of a value."""

    NONNEGATIVE = "≥ 0"
    POSITIVE = "> 0"
    NONPOSITIVE = "≤ 0"
    NEGATIVE = "< 0"

    @property
    def direction(self) -> int:
        """The sign that makes the value ≥ 0 when multiplied with it."""
        return 1 if self in (Sign.NONNEGATIVE, Sign.POSITIVE) else -1

    @property
    def strict(self) -> bool:
        """Whether zero is excluded."""
        return self in (Sign.POSITIVE, Sign.NEGATIVE)

    def holds(self, value: mpq | Real) -> bool:
        """Whether a number has the sign."""
        return value * self.direction > 0 or not (value or self.strict)


class Group(StrEnum):
    """The changes applied to a curve."""

    REPARAMETRIZATION = "reparametrization"
    REVERSAL = "reversal"
    COMMON_FACTOR = "common factor"
    TRANSLATION = "translation"
    ROTATION = "rotation"
    MOTION = "motion"
    REFLECTION = "reflection"
    SCALING = "scaling"
    SIMILARITY = "similarity"
    AFFINE = "affine map"
    PROJECTIVE = "projective map"
    MOEBIUS = "Möbius map"


class Curves(StrEnum):
    """Whether something is claimed for every curve or for the generic one."""

    EVERY = "every"
    GENERIC = "generic"


class Counter(StrEnum):
    """The quantities that captions count."""

    DEGREE = "degree"
    CONTROL_POINTS = "control points"
    ROOTS = "roots"
    EXTREMA = "extrema"
    ENDS = "extrema at the ends of one segment"
    CUSPS = "cusps"
    NOMINAL_CONTINUITY = "nominal continuity"
    TRUE_CONTINUITY = "true continuity"


def word(kind: type[E], value: object, what: str) -> E:
    """The member of an enumeration that a word names.

    >>> word(Relation, "≤", "relation").name
    'AT_MOST'

    Raises `ClaimError` with the existing words.
    """
    return choice(kind, value, what, raised=ClaimError)


class ValueType(StrEnum):
    """The three types of a piecewise function: a polynomial, a quotient of polynomials that is not a polynomial, or
    neither.
    """

    POLYNOMIAL = "polynomial"
    RATIONAL = "rational"
    NOT_RATIONAL = "not rational"
