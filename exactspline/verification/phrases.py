"""What evidence says that no code reads: the phrases, each with the types of the things that it is about."""

from __future__ import annotations

from exactspline.language.arguments import constant_text
from exactspline.language.operand import Parameter
from exactspline.numbers.exact import mpq
from exactspline.reals.real import Real
from exactspline.symbolic.factorization import Factor
from exactspline.verification.evidence import Evidence, Fact, Phrase, Place
from exactspline.verification.vocabulary import Counter, Group, Name, Relation, Sign, ValueType

# ---- places


@Phrase
def on_all_of(low: mpq, high: mpq) -> str:
    """A whole segment."""
    return f"on all of [{low}, {high}]"


@Phrase
def somewhere_on(low: mpq, high: mpq) -> str:
    """An unknown place on a segment."""
    return f"on [{low}, {high}]"


@Phrase
def at_both(s: mpq, t: mpq) -> str:
    """Values of two parameters."""
    return f"at the parameters {s} and {t}"


@Phrase
def on_patch(i: int, j: int) -> str:
    """A patch by its indices."""
    return f"on patch {i}, {j}"


@Phrase
def possibly_on_patch(i: int, j: int) -> str:
    """A patch by its indices, on which signs could not be decided."""
    return f"possibly on patch {i}, {j}"


@Phrase
def on_whole_patch() -> str:
    """Some patch as a whole."""
    return "on a whole patch"


@Phrase
def along_line(parameter: Parameter, value: mpq, place: Place) -> str:
    """A place on one of two curves, the point on the other being fixed."""
    return f"{place}, at {parameter} = {value} of the other curve"


# ---- free arguments, and the part that was tried


@Phrase
def chosen(point: tuple[mpq, ...], constants: tuple[tuple[Name, mpq], ...]) -> str:
    """A point and constants in addition to the curve."""
    given = [f"the point {point}"] if point else []
    return f"with {', '.join([*given, *[f'{constant_text(name)} = {value}' for name, value in constants]])}"


@Phrase
def with_any(operands: tuple[Name, ...]) -> str:
    """The free operands in addition to the curve, a point and constants."""
    return f"with any {', '.join(map(constant_text, operands))}"


@Phrase
def under_every(group: Group) -> str:
    """Every element of a group."""
    return f"under every {group}"


@Phrase
def for_degrees(first: int, last: int) -> str:
    """The degrees for which something was tried."""
    return f"d = {first}…{last}"


# ---- witnesses of any kind of claim


@Phrase
def left_to_the_proof(why: Evidence) -> str:
    """Not tried: the proof for all curves decides it."""
    return f"decided by the proof for all curves: {why}"


@Phrase
def too_long(formula: Name, degree: int, parameter: Parameter) -> str:
    """A formula whose value as written has too high a degree in a parameter to be multiplied out."""
    return f"{formula} as written has degree {degree} in {parameter} there, too high to be multiplied out"


@Phrase
def on_part(witness: Evidence | None, part: Evidence) -> str:
    """A witness on a part."""
    return f"{witness}, {part}" if witness else f"{part}"


@Phrase
def fails_with_others(place: Place, operands: Evidence, part: Evidence) -> str:
    """It fails at a place for some additional operands, though not for those that were tried."""
    return f"it fails {place} {operands}, though not {part}"


@Phrase
def refutes(witness: Evidence | None) -> str:
    """A witness against a statement proved for all curves."""
    return f"proved for all curves, but refuted: {witness or ''}"


@Phrase
def judges_disagree(proved: Name, refuted: Name, witness: Evidence | None) -> str:
    """One verifier proves a claim that another one refutes."""
    return f"proved by {proved}, but refuted by {refuted}{f': {witness}' if witness else ''}"


@Phrase
def vanishes(subject: Name, place: Place) -> str:
    """The subject of an assumption that fails on this curve, and where."""
    return f"{subject} vanishes {place}"


@Phrase
def undefined(formula: Name) -> str:
    """A formula that does not exist on the whole curve."""
    return f"{formula} does not exist on all of this curve: 0/0"


@Phrase
def undefined_there(where: Evidence) -> str:
    """A value with a division by zero on a segment, or for all operands."""
    return f"it does not exist {where}: 1/0"


@Phrase
def accepted_with(axioms: tuple[Name, ...]) -> str:
    """A kernel accepted a theorem, which uses these axioms."""
    return f"axioms {', '.join(axioms)}" if axioms else "no axioms"


# ---- identities


@Phrase
def components(left: int, right: int) -> str:
    """Vectors of different numbers of components."""
    return f"{left} components, and {right}"


@Phrase
def component_differs(component: int) -> str:
    """The first component (counted from 1) in which two sides differ."""
    return f"component {component} differs"


@Phrase
def component_is_not_zero(component: int) -> str:
    """The first component (counted from 1) that is not zero."""
    return f"component {component} is not zero"


@Phrase
def not_its_definition(formula: Name, definition: Name) -> str:
    """A formula that does not equal its definition."""
    return f"{formula} is not {definition}"


@Phrase
def rational_form(formula: Name, definition: Name) -> str:
    """A formula that is a quotient of polynomials, and the definition claimed not to be one."""
    return f"{formula} is a quotient of polynomials in the curve, and is {definition}"


@Phrase
def rational_of_degree(degree: int) -> str:
    """Rational of some degree on this curve."""
    return f"rational of degree {degree}"


# ---- counts and coefficients


@Phrase
def counts(numbers: tuple[tuple[int | None, Counter], ...]) -> str:
    """Numbers of a caption; None if there is none."""
    return ", ".join(_count(n, what) for n, what in numbers)


def _count(n: int | None, what: Counter) -> str:
    if n is None:
        return f"infinitely many {what}"
    number = f"{'−' if n < 0 else ''}{abs(n)}"
    return f"degree {number}" if what == Counter.DEGREE else f"{number} {what}"


@Phrase
def all_are_zero(degree: int) -> str:
    """All coefficients are zero for every curve of a degree."""
    return f"it is zero for every curve of degree {degree}"


@Phrase
def coefficient_is_zero(index: int, degree: int) -> str:
    """A coefficient that is zero for every curve of a degree."""
    return f"coefficient {index} is zero for every curve of degree {degree}"


@Phrase
def none_vanishes(degrees: Evidence) -> str:
    """No coefficient vanishes for some degrees."""
    return f"none vanishes for {degrees}"


@Phrase
def coefficient_here(index: int, formula: Name, segment: Place, value: mpq) -> str:
    """A Bézier coefficient of a formula on a segment of this curve that is zero, or has another sign."""
    return f"coefficient {index} of {formula} {segment} is {value}"


# ---- zeros, signs, squares


@Phrase
def vanishes_always(formula: Name) -> str:
    """A formula that vanishes on every curve."""
    return f"{formula} vanishes on every curve"


@Phrase
def vanishes_alone(formula: Name, place: Place, other: Name) -> str:
    """A zero of one formula that is not a zero of another."""
    return f"{formula} vanishes {place}, {other} does not"


@Phrase
def zeros_of(factors: tuple[Name, ...]) -> str:
    """The irreducible factors on whose zeros formulas vanish together."""
    return f"where {' or '.join(factors)} vanishes" if factors else "nowhere"


@Phrase
def may_vanish(factors: tuple[Name, ...], assume: tuple[Name, ...]) -> str:
    """Irreducible factors that prevent a proof, and the assumptions that exclude their zeros."""
    excluded = f": assume {' and '.join(assume)}" if assume else ""
    return f"{' and '.join(factors)} may have zeros{excluded}"


@Phrase
def equal_to(value: tuple[mpq | Real, ...]) -> str:
    """A value: a number, or the components of a vector; nothing for ∞."""
    return f"{value or '∞'}"


@Phrase
def equal_there(value: tuple[mpq, ...], place: Place) -> str:
    """A value at a place; nothing for ∞."""
    return f"it is {value or '∞'} {place}"


@Phrase
def length_there(square: tuple[mpq, ...], place: Place) -> str:
    """The square of a length at a place."""
    return f"its length has the square {square} {place}"


@Phrase
def of_sign(sign: Sign) -> str:
    """A sign."""
    return str(sign)


@Phrase
def sum_of_squares(squares: int) -> str:
    """A sum of this many squares."""
    return f"a sum of {squares} squares" if squares > 1 else "a square"


@Phrase
def quotients(formula: Name, by: tuple[tuple[Name, Factor | None], ...]) -> str:
    """The quotients of one formula by others; None for a formula that is not proportional."""
    return ", ".join(f"{formula}/{name} = {factor or 'not proportional'}" for name, factor in by)


@Phrase
def odd_powers(names: tuple[Name, ...]) -> str:
    """Irreducible factors that occur an odd number of times."""
    return f"odd powers of {'·'.join(names)}"


@Phrase
def squares_on(formula: Name, squares: int, segments: int, zero: int) -> str:
    """The number of segments on which a formula is a square up to a constant, and of those on which it is 0."""
    more = f", 0 on {zero}" if zero else ""
    return f"{formula} is a square up to a constant on {squares} of {segments} segments{more}"


@Phrase
def one_is_square(segment: int) -> str:
    """A segment on which one of two formulas is a square and the other is not."""
    return f"on segment {segment} one is a square and the other is not"


# ---- surfaces


@Phrase
def one_surface_except(factors: tuple[Name, ...]) -> str:
    """One surface, except where irreducible factors vanish."""
    return f"one surface, except where {' or '.join(factors)} vanishes"


@Phrase
def one_surface_but(place: Place, formula: Name) -> str:
    """One surface, except where the generator of a formula vanishes."""
    return f"one surface, except {place}, where the generator of {formula} vanishes"


@Phrase
def no_generator(formula: Name) -> str:
    """The generator of a formula vanishes on every curve."""
    return f"no surface: the generator of {formula} vanishes on every curve"


# ---- contact, invariance, condition


@Phrase
def contact(order: int, relation: Relation) -> str:
    """An order of contact (−1: the object does not pass through the point)."""
    return "none: it does not pass through the point" if order < 0 else relation.bound(order)


@Phrase
def at_least(order: int) -> str:
    """At least this order."""
    return f"at least {order}"


@Phrase
def zero_on(segment: Place) -> str:
    """A value that is 0 on a segment."""
    return f"0 {segment}"


@Phrase
def derivative_vanishes(order: int) -> str:
    """A derivative with respect to s̄ at s̄ = s that is zero on every curve."""
    return f"{_derivative(order)} is = 0 at s̄ = s on every curve"


@Phrase
def derivative_remains(order: int, place: Place | None) -> str:
    """A derivative with respect to s̄ at s̄ = s that is not zero (at a place, on one curve)."""
    return f"{_derivative(order)} is ≠ 0 at s̄ = s{f' {place}' if place else ''}"


def _derivative(order: int) -> str:
    return f"the derivative of order {order} in s̄" if order else "the value"


#: The base of the power with the weight as exponent.
UNITS = {
    Group.REPARAMETRIZATION: "ds/dt",
    Group.COMMON_FACTOR: "the factor",
    **dict.fromkeys((Group.REVERSAL, Group.REFLECTION), "−1"),
    Group.SCALING: "the scale",
    Group.SIMILARITY: "the scale",
    Group.AFFINE: "the determinant",
    Group.PROJECTIVE: "the determinant",
    Group.MOEBIUS: "the local scale",
}


@Phrase
def weight(under: Group, power: int) -> str:
    """The power of the unit of a group by which a value is multiplied."""
    unit = UNITS.get(under)
    return f"weight {power} in {unit}".replace("-", "−") if unit else "no change"


@Phrase
def multiple_under(map_name: Name, factor: Factor) -> str:
    """The value under a map: a multiple of the claimed one."""
    return f"under {with_article(map_name)} it is {factor} times what is claimed"


@Phrase
def differ_under(map_name: Name, place: Place | None) -> str:
    """The sides differ under a map (at a place, on one curve)."""
    return f"under {with_article(map_name)} the sides differ{f' {place}' if place else ''}"


def with_article(name: str) -> str:
    """A name with its article."""
    return f"an {name}" if name[0] in "ai" else f"a {name}"


@Phrase
def not_better(place: Place) -> str:
    """A zero at which the condition number is not smaller."""
    return f"not better {place}"


# ---- types


@Phrase
def of_type(found: ValueType) -> str:
    """The type of a value."""
    return str(found)


@Phrase
def type_on_example(found: ValueType, curve: Name, why: Fact | None) -> str:
    """The type on an example curve, or on cubic polynomials where the name is empty; why it is rational on every
    curve.
    """
    there = f"on the example curve {curve}" if curve else "for cubic polynomials"
    return f"{found} {there}{f'; {why}' if why else ''}"


@Phrase
def type_here(found: ValueType) -> str:
    """The type on the given curve."""
    return f"it is {found} on this curve"


@Phrase
def more_special_here(found: ValueType) -> str:
    """The type on the given curve, which is more special than that on the generic curve."""
    return f"it is {found} on it, as it may be on special curves"


@Phrase
def of_kind(kind: Name) -> str:
    """The kind of argument of a formula."""
    return f"its arguments are of the kind '{kind}'"


@Phrase
def of_another_kind(formula: Name, kind: Name, asked: Name) -> str:
    """A formula, the kind of its argument, and the requested kind."""
    return f"{formula} is a formula of '{kind}', not of '{asked}'"
