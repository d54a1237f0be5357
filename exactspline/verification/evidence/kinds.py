"""Evidence for single kinds of claims: differences and factors, degrees, zeros, surfaces, contact."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum, auto

from exactspline.numbers.exact import mpq
from exactspline.readings.degree import Degree
from exactspline.readings.jet import Jet
from exactspline.symbolic.factorization import Factor
from exactspline.verification.evidence.general import At, AtBoth, AtKnot, Evidence, ForDegrees, Isolated, On, Place
from exactspline.verification.vocabulary import Counter, Group, Name, Relation, Sign

#: An enclosure of a number.
Enclosure = tuple[mpq, mpq]


# ---- identities


class Sides(Enum):
    """What differs."""

    SIDES = auto()
    ZERO = auto()
    SURFACES = auto()


@dataclass(frozen=True)
class Difference(Evidence):
    """The difference of two sides at one place."""

    of: Sides
    by: mpq
    at: At | AtBoth


@dataclass(frozen=True)
class StatedFactor(Evidence):
    """A factor as stated in a claim; `is_one` where it is 1 on this curve."""

    powers: tuple[tuple[Name, int], ...]
    is_one: bool = False


@dataclass(frozen=True)
class Relating(Evidence):
    """``left = factor · right``, the sides by name."""

    left: Name
    factor: Factor | StatedFactor
    right: Name


@dataclass(frozen=True)
class ExactQuotient(Evidence):
    """The true quotient of two sides."""

    quotient: Factor


@dataclass(frozen=True)
class Components(Evidence):
    """Vectors of different numbers of components."""

    left: int
    right: int


@dataclass(frozen=True)
class ComponentDiffers(Evidence):
    """The first component (counted from 1) in which two sides differ."""

    component: int


@dataclass(frozen=True)
class ComponentNotZero(Evidence):
    """The first component (counted from 1) that is not zero."""

    component: int


@dataclass(frozen=True)
class Remainder(Evidence):
    """A differential polynomial that is not zero."""

    polynomial: Jet


@dataclass(frozen=True)
class NotItsDefinition(Evidence):
    """A formula that does not equal its definition."""

    formula: Name
    definition: Name


@dataclass(frozen=True)
class RationalForm(Evidence):
    """A formula that is a quotient of polynomials, and the definition claimed not to be one."""

    formula: Name
    definition: Name


@dataclass(frozen=True)
class RationalOfDegree(Evidence):
    """Rational of some degree on this curve."""

    degree: int


# ---- degrees and counts


@dataclass(frozen=True)
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


@dataclass(frozen=True)
class DegreeHere(Evidence):
    """The degree of splines, and the claimed number."""

    degree: int
    claimed: int
    relation: Relation


@dataclass(frozen=True)
class ZeroHere(Evidence):
    """A value that is 0, so that it has no degree, and the claimed number."""

    claimed: int
    relation: Relation


@dataclass(frozen=True)
class WrongDegree(Evidence):
    """A degree that differs from the claimed one, for some degrees of the operands (None: on one curve; empty: for
    all).
    """

    degree: int
    claimed: int
    relation: Relation
    at: tuple[tuple[Name, int], ...] | None = None


@dataclass(frozen=True)
class Counted(Evidence):
    """Numbers of a caption; None where there is none."""

    numbers: tuple[tuple[int | None, Counter], ...]


@dataclass(frozen=True)
class CoefficientIsZero(Evidence):
    """A coefficient that is zero for every curve of a degree (None: all are)."""

    degree: int
    index: int | None = None


@dataclass(frozen=True)
class OnlyForDegrees(Evidence):
    """No coefficient vanishes for some degrees."""

    degrees: ForDegrees


@dataclass(frozen=True)
class ZeroCoefficient(Evidence):
    """A coefficient of a formula that is zero on this curve."""

    formula: Name
    index: int


@dataclass(frozen=True)
class ZeroForDegree(Evidence):
    """Coefficients that vanish for every curve of a degree: one, or (None) all."""

    degree: int
    index: int | None = None


# ---- zeros, signs, squares


@dataclass(frozen=True)
class VanishesAlways(Evidence):
    """A formula that vanishes on every curve."""

    formula: Name


@dataclass(frozen=True)
class VanishesAlone(Evidence):
    """A zero of one formula that is not a zero of another."""

    formula: Name
    place: Place
    other: Name


@dataclass(frozen=True)
class ZeroAt(Evidence):
    """A zero."""

    place: Place


@dataclass(frozen=True)
class HasSign(Evidence):
    """A sign."""

    sign: Sign


@dataclass(frozen=True)
class SumOfSquares(Evidence):
    """A sum of this many squares."""

    squares: int


@dataclass(frozen=True)
class Quotients(Evidence):
    """The quotients of one formula by others; None where they are not proportional."""

    formula: Name
    by: tuple[tuple[Name, Factor | None], ...]


@dataclass(frozen=True)
class OddPowers(Evidence):
    """Irreducible factors that occur an odd number of times."""

    names: tuple[Name, ...]


@dataclass(frozen=True)
class Squares(Evidence):
    """The number of segments on which a formula is a square up to a constant, and of those on which it is 0."""

    formula: Name
    squares: int
    segments: int
    zero: int


@dataclass(frozen=True)
class SquareOnSegment(Evidence):
    """A segment on which one of two formulas is a square and the other is not."""

    segment: int


# ---- surfaces


@dataclass(frozen=True)
class OneSurface(Evidence):
    """One surface, except where irreducible factors vanish."""

    but: tuple[Name, ...] = ()


@dataclass(frozen=True)
class OneSurfaceBut(Evidence):
    """One surface, except where the generator of a formula vanishes."""

    place: Place
    formula: Name


@dataclass(frozen=True)
class NoGenerator(Evidence):
    """A generator that vanishes: that of a formula on every curve, or (None) on a whole segment of this one."""

    formula: Name | None = None


@dataclass(frozen=True)
class Rulings(Evidence):
    """How the ruling parameters ζ and λ of one surface are related: ``ζ = shift + scale · λ``."""

    scale: Factor
    shift: Factor | None = None


# ---- contact, invariance, condition


@dataclass(frozen=True)
class ContactOrder(Evidence):
    """An order of contact (−1: the object does not pass through the point)."""

    order: int
    relation: Relation = Relation.EQUAL


@dataclass(frozen=True)
class AtLeast(Evidence):
    """At least this order."""

    order: int


@dataclass(frozen=True)
class Vanishes(Evidence):
    """A value that is 0 on a segment."""

    where: On


@dataclass(frozen=True)
class DerivativeAt(Evidence):
    """A derivative with respect to s̄ at s̄ = s that is zero on every curve, or one that is not (at a place, on one
    curve).
    """

    order: int
    is_zero: bool = False
    place: At | On | None = None


@dataclass(frozen=True)
class Weight(Evidence):
    """The power of the unit of a group by which a value is multiplied."""

    under: Group
    weight: int


@dataclass(frozen=True)
class UnderMap(Evidence):
    """The value under a map: a multiple of the claimed one, or (None) not proportional to it."""

    map: Name
    factor: Factor | None = None


@dataclass(frozen=True)
class DifferUnder(Evidence):
    """Where the sides differ under a map."""

    map: Name
    place: At | On


@dataclass(frozen=True)
class Conditions(Evidence):
    """Enclosures of two condition numbers, zero by zero."""

    pairs: tuple[tuple[Enclosure, Enclosure], ...]


@dataclass(frozen=True)
class NotBetter(Evidence):
    """A zero at which the condition number is not smaller."""

    zero: AtKnot | Isolated
