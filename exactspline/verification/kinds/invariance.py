"""Claims that a formula does not change, or is multiplied by a power, when the curve is reparametrized or moved.

Each map of the plane, of space and of curves is written once, for coordinates and denominators of any reading and
constants of any type: indeterminates in a proof, numbers on a given curve.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from functools import partial
from typing import Any, ClassVar, TypeVar, cast

from exactspline.errors import ClaimError, VanishingDivisorError, counted
from exactspline.language.adjoined_root import framed
from exactspline.language.arguments import PARAMETERS, Accompanied, Curve, Evaluated, Symbol, T
from exactspline.language.formula import Formula
from exactspline.language.kinds import CurveKind, Kind, kind_of
from exactspline.language.operand import Operand
from exactspline.language.ruled import RuledSurface
from exactspline.language.vector import Vector, det, norm2
from exactspline.polynomials.cost import at_its_cost
from exactspline.readings.differential_order import order_of
from exactspline.readings.jet import InOtherParameter, RationalJetReading
from exactspline.symbolic.factorization import find_factor, without_denominator
from exactspline.verification import phrases as say
from exactspline.verification.claim import Claim, claim_kind, formula_name, one_of, read
from exactspline.verification.decision import Changed
from exactspline.verification.evaluation import Evaluation, OnSegment, on_segments
from exactspline.verification.evidence import Evidence, Said
from exactspline.verification.one_function import unwrapped
from exactspline.verification.verdict import PROVED, REFUTED, VACUOUS, VERIFIED, Finding, vacuous
from exactspline.verification.vocabulary import Group, Name

Constants = Mapping[str, Any]
M = TypeVar("M", bound=Operand)
N = TypeVar("N")


@dataclass(frozen=True)
class _Map:
    """A map of points. ``image`` returns numerators and denominator of the image of p/w. ``unit`` is the quantity (the
    scale, the determinant) such that invariants are multiplied by one of its powers, or None.

    ``constants`` returns the names of the constants for a dimension. An affine map does not change the denominator.
    """

    constants: Callable[[int], Sequence[str]]
    image: Callable[[Vector[Any], Any, Constants], tuple[Vector[Any], Any]]
    unit: Callable[[Vector[Any], Any, Constants], Any] | None
    affine: bool = True
    dimensions: tuple[int, ...] = (2, 3)

    def of_vector(self, v: Vector[M], one: M, constants: Mapping[str, object]) -> Vector[M]:
        """The image of a vector under an affine map: the image of its end point minus the image of the origin."""
        moved, _ = self.image(v, one, constants)
        origin, _ = self.image(v.mapped(lambda x: x.constant(0)), one, constants)
        return cast("Vector[M]", moved - origin)


def _move(n: int) -> list[str]:
    return [f"move{i}" for i in range(1, n + 1)]


def _turn(n: int) -> list[str]:
    return [f"turn{i}" for i in range(1, 2 if n == 2 else 4)]


def _matrix(n: int) -> list[str]:
    return [f"m{i}{j}" for i in range(1, n + 1) for j in range(1, n + 1)]


def _translated(p: Vector[Any], w: Any, k: Constants) -> tuple[Vector[Any], Any]:
    return Vector(*[x + w * k[name] for x, name in zip(p, _move(len(p)), strict=True)]), w


def _rotated(p: Vector[Any], w: Any, k: Constants) -> tuple[Vector[Any], Any]:
    """Rotations by Cayley's parameters: all rotations except half turns, which are limits of other rotations."""
    return Vector(*[_combination(row, p) for row in rotation_rows(len(p), k)]), w


def rotation_rows(n: int, constants: Mapping[str, N]) -> list[list[N]]:
    """The rows of a rotation matrix: given by the tangent of half its angle in the plane, by a quaternion 1 + a i + b j
    + c k in space.

    >>> from exactspline.numbers.exact import mpq
    >>> rotation_rows(2, {"turn1": mpq(1, 2)})
    [[mpq(3,5), mpq(-4,5)], [mpq(4,5), mpq(3,5)]]
    """
    k: Constants = constants
    if n == 2:
        q = k["turn1"]
        length = q * q + 1
        return [[(1 - q * q) / length, -2 * q / length], [2 * q / length, (1 - q * q) / length]]
    a, b, c = (k[name] for name in _turn(3))
    length = a * a + b * b + c * c + 1
    rows = [
        [1 + a * a - b * b - c * c, 2 * (a * b - c), 2 * (a * c + b)],
        [2 * (a * b + c), 1 - a * a + b * b - c * c, 2 * (b * c - a)],
        [2 * (a * c - b), 2 * (b * c + a), 1 - a * a - b * b + c * c],
    ]
    return [[entry / length for entry in row] for row in rows]


def _reflected(p: Vector[Any], w: Any, k: Constants) -> tuple[Vector[Any], Any]:
    """A reflection combined with motions: every isometry that reverses orientation."""
    return _displaced(Vector(-p[0], *p[1:]), w, k)


def _scaled(p: Vector[Any], w: Any, k: Constants) -> tuple[Vector[Any], Any]:
    return p.mapped(lambda x: x * k["scale"]), w


def _displaced(p: Vector[Any], w: Any, k: Constants) -> tuple[Vector[Any], Any]:
    return _translated(*_rotated(p, w, k), k)


def _similar(p: Vector[Any], w: Any, k: Constants) -> tuple[Vector[Any], Any]:
    return _displaced(*_scaled(p, w, k), k)


def _affine(p: Vector[Any], w: Any, k: Constants) -> tuple[Vector[Any], Any]:
    n = len(p)
    rows = [[k[f"m{i}{j}"] for j in range(1, n + 1)] for i in range(1, n + 1)]
    return _translated(Vector(*[_combination(row, p) for row in rows]), w, k)


def _projective(p: Vector[Any], w: Any, k: Constants) -> tuple[Vector[Any], Any]:
    n, whole = len(p) + 1, [*p, w]
    *image, below = [_combination([k[f"m{i}{j}"] for j in range(1, n + 1)], whole) for i in range(1, n + 1)]
    return Vector(*image), below


def _inverted(p: Vector[Any], w: Any, k: Constants) -> tuple[Vector[Any], Any]:
    """z ↦ 1/z in the plane; in space the inversion in the unit sphere, after a reflection."""
    return Vector(p[0], -p[1], *p[2:]).mapped(lambda x: x * w), norm2(p)


def _combination(row: Sequence[Any], p: Sequence[Any] | Vector[Any]) -> Any:
    total = None
    for a, x in zip(row, p, strict=True):
        total = x * a if total is None else total + x * a
    return total


def _determinant(size: Callable[[int], int]) -> Callable[[Vector[Any], Any, Constants], Any]:
    def unit(p: Vector[Any], w: Any, k: Constants) -> Any:
        n = size(len(p))
        return det(*[Vector(*[k[f"m{i}{j}"] for j in range(1, n + 1)]) for i in range(1, n + 1)])

    return unit


#: The maps by name. A Möbius map is composed of similarities and z ↦ 1/z, whose local scale is w²/‖p‖².
MAPS = {
    "translation": _Map(_move, _translated, None),
    "rotation": _Map(_turn, _rotated, None),
    "motion": _Map(lambda n: [*_turn(n), *_move(n)], _displaced, None),
    "reflection": _Map(lambda n: [*_turn(n), *_move(n)], _reflected, lambda p, w, k: w.constant(-1)),
    "scaling": _Map(lambda n: ["scale"], _scaled, lambda p, w, k: k["scale"]),
    "similarity": _Map(lambda n: ["scale", *_turn(n), *_move(n)], _similar, lambda p, w, k: k["scale"]),
    "affine map": _Map(lambda n: [*_matrix(n), *_move(n)], _affine, _determinant(lambda n: n)),
    "projective map": _Map(lambda n: _matrix(n + 1), _projective, _determinant(lambda n: n + 1), affine=False),
    "inversion": _Map(lambda n: [], _inverted, lambda p, w, k: w * w / norm2(p), affine=False),
}


class _Nature(StrEnum):
    """The nature of the value of a formula: a number (or numbers), a vector or a point that moves with the curve."""

    SCALAR = "scalar"
    VECTOR = "vector"
    POINT = "point"


#: The factor of a value is reported only if the sides have fewer terms than this.
SHORT = 400
#: The name of the function by which a parameter is changed, which constants cannot have.
SPEED = "_speed"
#: The largest weight.
LARGEST_WEIGHT = 200


#: The changes that move no point, and the changes that preserve lengths, and hence the roots of a frame.
UNMOVED = (Group.REPARAMETRIZATION, Group.REVERSAL, Group.COMMON_FACTOR)
ISOMETRIES = (Group.REVERSAL, Group.TRANSLATION, Group.ROTATION, Group.MOTION, Group.REFLECTION)
#: The maps by which a group is generated.
GENERATED = {Group.MOEBIUS: ("similarity", "inversion")}


def _whole_number(claim: Claim, name: str, value: object) -> int:
    """A weight: an integer, which may be negative."""
    if isinstance(value, bool) or not isinstance(value, int) or abs(value) > LARGEST_WEIGHT:
        raise ClaimError(f"{value!r} is not a weight", where=name, remedy=f"an integer, at most {LARGEST_WEIGHT}")
    return value


@claim_kind
class Invariance(Claim):
    """Under every element of a group the value of ``formula`` is multiplied by the power ``weight`` of the unit of the
    group; a value whose ``nature`` is that of a vector or a point moves with the curve. The group ``under`` consists of
    changes of the curve: a *reparametrization* (unit ds/dt), the *reversal* of the direction in which it is traversed
    (unit −1), a *common factor* of numerators and denominator (unit that factor), a translation, a rotation, a motion
    (no unit), a reflection (unit −1), a scaling or a similarity (unit the scale), an affine or a projective map (unit
    the determinant), a Möbius map (unit the local scale).
    """

    kind: ClassVar[str] = "invariance"
    tries_all: ClassVar[bool] = True
    of_frames: ClassVar[bool] = True

    formula: Name = field(metadata=read(formula_name))
    under: Group = field(metadata=read(one_of(Group)))
    weight: int = field(default=0, metadata=read(_whole_number))
    nature: _Nature = field(default=_Nature.SCALAR, metadata=read(one_of(_Nature)))

    def validate(self) -> None:
        """Reject claims without meaning: a weight without a unit, constants whose image is not stated."""
        kind = kind_of(self.curve)
        if not isinstance(kind, CurveKind):
            raise ClaimError(f"invariance of {self.curve!r} is not decided", where="curve", remedy="name a curve")
        if kind.adjoins_roots and self.under not in ISOMETRIES:
            problem = f"the images of roots under {say.with_article(self.under)} are not decided"
            raise ClaimError(problem, where="under", remedy=f"one of {', '.join(ISOMETRIES)}")
        if self.weight and self.under not in say.UNITS:
            raise ClaimError(f"a {self.under} has no unit", where="weight", remedy="leave the weight out")
        if kind.constants and self.under not in UNMOVED:
            raise ClaimError(
                "the images of the constants are not stated", where="curve", remedy="claim it of a curve alone"
            )
        if self.nature != _Nature.SCALAR and self.under in UNMOVED:
            raise ClaimError(f"a {self.under} moves nothing", where="nature", remedy='write "scalar"')
        if self.nature == _Nature.VECTOR and self.under in (Group.PROJECTIVE, Group.MOEBIUS):
            raise ClaimError(f"a {self.under} is not linear", where="nature", remedy='write "point" or "scalar"')

    @property
    def claims(self) -> str:
        """The power of the unit."""
        return say.weight.words(self.under, self.weight)

    @property
    def latex(self) -> str:
        """The name, the group, the weight."""
        return rf"{self.symbol(self.formula)}\;\text{{under {say.with_article(self.under)}: {self.claims}}}"

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """By substitution in the jets, with indeterminates for the constants of the group."""
        formula = self.find(self.formula)
        for name in GENERATED.get(self.under, (str(self.under),)):
            finding = self._under(formula, name, dimension, polynomial)
            if finding.verdict != PROVED:
                return finding
        return finding

    def _under(self, formula: Formula, name: str, dimension: int, polynomial: bool) -> Finding:
        roots = formula.kind if formula.kind.adjoins_roots else None
        polynomial |= roots is not None and without_denominator((formula,), "1", dimension)
        reading, kind = RationalJetReading(order_of(formula, dimension, roots)), _wider(formula.kind, name, dimension)
        curve = reading.argument(kind, dimension, polynomial=polynomial)
        statement = self._statement(formula, name, lambda difference: say.differ_under(Name(name), None))
        found = statement.decide(curve)
        if found.verdict != REFUTED or roots:
            return found
        moved, expected = statement.sides(curve)
        short = sum(len(x.top) + len(x.bottom) for x in (*moved, *expected)) < SHORT
        factor = find_factor(moved, expected) if short and any(not x.is_zero for x in expected) else None
        changed = say.multiple_under(Name(name), factor) if factor else say.differ_under(Name(name), None)
        return Finding(REFUTED, changed, witness=self.refuted_on_examples().witness or changed)

    def beside(self, own: Evaluation) -> Evidence:
        """The group: all its elements are covered together."""
        return say.under_every(self.under)

    def examine(self, argument: Evaluated, own: Evaluation) -> Finding:
        """The finding on every segment of the curve, with indeterminates for the constants of the group, or for the
        change of parameter.
        """
        formula, curve, nothing = self.find(self.formula), own.curve, True
        for name in GENERATED.get(self.under, (str(self.under),)):
            kind = _wider(formula.kind, name, curve.dimension)
            for segment in on_segments(kind, curve, order_of(formula, curve.dimension)):
                statement = self._statement(formula, name, partial(_differs_under, Name(name), segment))
                try:
                    finding = statement.decide(segment.argument, VERIFIED)
                except VanishingDivisorError:
                    return vacuous(say.undefined_there(segment.interval))
                if finding.verdict == REFUTED:
                    return finding
                nothing = nothing and finding.verdict == VACUOUS
        return vacuous() if nothing else Finding(VERIFIED, say.weight(self.under, self.weight))

    def _statement(self, formula: Formula, name: str, where: Callable[[Any], Evidence]) -> Changed:
        """The statement that the value is as claimed under one map."""

        def sides(c: Any) -> tuple[Vector[Any], Vector[Any]]:
            moved, expected = self._sides(formula, name, c, vars(c))
            return Vector(*moved), Vector(*expected)

        return Changed(sides, say.weight(self.under, self.weight), where)

    def _sides(self, formula: Formula, name: str, curve: Any, k: Mapping[str, Any]) -> tuple[list[Any], list[Any]]:
        """The components of the value on the changed curve, and their claimed values."""
        if name == Group.REPARAMETRIZATION:
            return self._in_other_parameter(formula, curve, k[SPEED])
        if name == Group.REVERSAL:
            return self._in_other_parameter(formula, curve, curve.w.constant(-1))
        if name == Group.COMMON_FACTOR:
            factor = k[SPEED]
            plain = Curve(curve.p * factor, curve.w * factor, point=curve.point)
            beside = {each: curve.operands()[each] for each in formula.kind.constants}
            value = _times_unit(_components(formula(curve)), factor, self.weight)
            return _components(formula(Accompanied(plain, beside))), value
        made, whole = MAPS[name], _with_roots(formula, curve)
        value = self._carried(_components(formula(whole)), made, vars(whole), whole.w.constant(1), curve.dimension)
        unit = made.unit(whole.p, whole.w, vars(whole)) if made.unit else None
        return _components(formula(_with_roots(formula, _moved(curve, made, k)))), _times_unit(value, unit, self.weight)

    def _in_other_parameter(self, formula: Formula, curve: Any, rho: Any) -> tuple[list[Any], list[Any]]:
        """The curve differentiated with respect to another parameter, where ds/dt is ρ."""
        changed = curve.mapped(lambda x: InOtherParameter(x, rho))
        moved = [unwrapped(x) for x in _components(formula(_with_roots(formula, changed)))]
        value = _components(formula(whole := _with_roots(formula, curve)))
        return moved, _times_unit(value, rho if whole is curve else whole.w.constant(-1), self.weight)

    def _carried(self, value: list[Any], made: _Map, k: Mapping[str, Any], one: Any, dimension: int) -> list[Any]:
        """The value; a vector or a point is mapped."""
        if self.nature == _Nature.SCALAR:
            return value
        if len(value) != dimension:
            problem = f"{self.formula!r} has {counted(len(value), 'component')}, a {self.nature} has {dimension}"
            raise ClaimError(problem, where=self.key, remedy='write "scalar"')
        if self.nature == _Nature.VECTOR:
            return list(made.of_vector(Vector(*value), one, k))
        return image_of_point(Vector(*value), made, k, one)


def _with_roots(formula: Formula, curve: Any) -> Any:
    """The curve, with the positive roots of its frame if the formula needs them."""
    return framed(curve) if formula.kind.adjoins_roots else curve


def _differs_under(name: Name, segment: OnSegment, difference: Any) -> Said:
    """The place on a segment where the sides differ."""
    return say.differ_under(name, segment.place(difference))


class _Wider(CurveKind):
    """The kind of a formula, with the constants of a group and with an additional function, the speed ρ."""

    def symbols(self, dimension: int, *, polynomial: bool = False) -> tuple[Symbol, ...]:
        """The symbols of a curve, and ρ."""
        return (*super().symbols(dimension, polynomial=polynomial), Symbol(SPEED, "ρ", PARAMETERS[:1]))

    def of_operands(self, named: Mapping[str, T], dimension: int, one: T) -> Evaluated:
        """The curve, with the constants and with ρ."""
        plain = CurveKind(self.name, self.dimensions, with_point=self.with_point)
        curve: Any = plain.of_operands(named, dimension, one)
        return Accompanied(curve, {name: named[name] for name in (*self.constants, SPEED)})


@at_its_cost
def _wider(kind: Kind, name: str, dimension: int) -> _Wider:
    """The kind in which a formula is compared with its value on the changed curve."""
    assert isinstance(kind, CurveKind)
    constants = MAPS[name].constants(dimension) if name in MAPS else ()
    both = (*kind.constants, *constants)
    return _Wider(f"{kind.name}, changed", kind.dimensions, with_point=kind.with_point, constants=both)


def _components(value: Any) -> list[Any]:
    """The components of a value, as quotients if the value is a quotient."""
    if isinstance(value, RuledSurface):
        value = value.joined
    return [value[i] for i in range(len(value))] if value.is_vector else [value]


def _times_unit(value: list[N], unit: N | None, weight: int) -> list[N]:
    """A value times a power of the unit."""
    if unit is None or not weight:
        return value
    base: Any = unit
    power = base ** abs(weight)
    return [x * power if weight > 0 else x / power for x in value]


def _moved(curve: Any, made: _Map, k: Mapping[str, Any]) -> Curve[Any]:
    """The curve under a map, and its point with it."""
    p, w = made.image(curve.p, curve.w, k)
    point = None if curve.point is None else Vector(*image_of_point(curve.point, made, k, curve.w.constant(1)))
    return Curve(p, w, polynomial=curve.polynomial and made.affine, point=point)


def image_of_point(point: Vector[N], made: _Map, k: Mapping[str, N], one: N) -> list[N]:
    """The coordinates of a point's image under a map."""
    top, below = made.image(point, one, k)
    return list(top) if made.affine else [x / below for x in top]
