"""One curve, evaluated for many claims: the arguments of formulas, and the assumptions that hold."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from functools import cache
from itertools import pairwise, product
from typing import Any, NamedTuple, cast

from flint import fmpq_poly

from exactspline.errors import InapplicableError, VanishingDivisorError, counted
from exactspline.language.arguments import (
    BARRED,
    COORDINATES,
    PARAMETERS,
    Accompanied,
    Curve,
    Evaluated,
    Kind,
    Operands,
    Pair,
    Rule,
    Symbol,
    T,
)
from exactspline.language.formula import Formula
from exactspline.language.kinds import (
    PLANAR_MAP,
    SURFACE,
    CurveKind,
    HodographKind,
    PairKind,
    curve_of_hodograph,
    kind_of,
)
from exactspline.language.vector import Vector
from exactspline.numbers.exact import mpq, to_fmpq
from exactspline.numbers.intervals import Interval
from exactspline.numbers.once import cached_property, while_set
from exactspline.polynomials.isolation import zero_on_segment
from exactspline.readings.degree import DegreeReading
from exactspline.readings.jet import JetFraction, JetRing
from exactspline.splines.bspline import BSpline, in_powers
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface
from exactspline.splines.tensor import TensorSpline, surface_pair
from exactspline.symbolic.assumptions import Assumption
from exactspline.verification import phrases as say
from exactspline.verification.evidence import At, Between, Evidence, Fact, Place, Said
from exactspline.verification.vocabulary import ArgumentKind, Name

# ---- the arguments


#: Values of constants on one curve, chosen arbitrarily.
CONSTANTS = tuple(mpq(p, q) for p, q in ((37, 29), (-53, 41), (61, 17), (19, 67), (-71, 83), (97, 47)))


def point_beside(curve: Nurbs) -> tuple[mpq, ...]:
    """A point off the curve: the mean of its control points, moved by unequal fractions of their extent.

    >>> from exactspline.interchange.examples import example
    >>> point_beside(example("circle"))
    (mpq(1,3), mpq(4,11))
    """
    point = []
    for i, column in enumerate(zip(*curve.control_points, strict=True)):
        extent = max(column) - min(column)
        point.append(sum(column) / len(column) + (extent or 1) * mpq(i + 1, 2 * i + 9))
    return tuple(point)


def moved_copy(curve: Nurbs) -> Curve[BSpline]:
    """The curve with its coordinates exchanged cyclically and moved by the vector of its test point."""
    move = point_beside(curve)
    p = Vector(*[curve.p[(i + 1) % curve.dimension] + curve.w * move[i] for i in range(curve.dimension)])
    return Curve(p, curve.w, polynomial=curve.polynomial)


def beginning(curve: Curve[BSpline]) -> Curve[BSpline]:
    """The first segment of a curve: further segments show nothing new about a pair, and the number of patches of a pair
    is the product of both numbers of segments.
    """
    a, b, *_ = curve.w.breakpoints
    return Curve(Vector(*[x.restrict(a, b) for x in curve.p]), curve.w.restrict(a, b), polynomial=curve.polynomial)


def pair_with(curve: Nurbs, other: Curve[BSpline] | None = None) -> Pair[TensorSpline]:
    """The first segments of two curves, or of a curve and its moved copy."""
    return surface_pair(beginning(curve), beginning(moved_copy(curve) if other is None else other))


def with_hodograph(curve: Nurbs, constants: Mapping[str, BSpline]) -> Accompanied[BSpline]:
    """The Pythagorean-hodograph curve whose u, v and h are the numerators and the denominator of a plane curve, with
    constants.
    """
    u, v = curve.p
    x, y = ((f * curve.w).integral() for f in (u * u - v * v, u * v + u * v))
    return curve_of_hodograph({"x": x, "y": y, "u": u, "v": v, "h": curve.w, **constants}, x.constant(1), constants)


#: The largest number of patches of a surface on which claims are multiplied out.
PATCHES = 16


def is_tried_whole(surface: NurbsSurface) -> bool:
    """Whether claims are checked on all patches of a surface, and not only on the first."""
    m, n = surface.patches
    return m * n <= PATCHES


class _Given(NamedTuple):
    """The argument of formulas of a kind on one curve or surface, with a description of the additional operands, and of
    the part of all such arguments that it represents (None if it is the only argument).
    """

    argument: Evaluated
    beside: Evidence | None = None
    part: Evidence | None = None


def argument(kind: str, curve: Nurbs | NurbsSurface) -> _Given:
    """The argument of formulas of a kind on one curve or surface.

    Raises `InapplicableError` for a kind of which a single curve or surface is not an example.
    """
    asked = kind_of(kind)
    if isinstance(curve, NurbsSurface):
        if asked not in (SURFACE, PLANAR_MAP):
            raise InapplicableError(
                f"one surface is not an example of {str(kind)!r}", remedy="such claims are decided for all"
            )
        if is_tried_whole(curve):
            return _Given(curve)
        (a, b, *_), (c, d, *_) = (mesh.breaks for mesh in curve.meshes)
        return _Given(curve.mapped(lambda f: f.restrict((a, b), (c, d))), Fact.FIRST_PATCH, Fact.FIRST_PATCH)
    if isinstance(asked, PairKind):
        return _Given(pair_with(curve), Fact.FIRST_SEGMENTS, Fact.FIRST_SEGMENTS)
    if not isinstance(asked, (CurveKind, HodographKind)):
        raise InapplicableError(
            f"one curve is not an example of {str(kind)!r}", remedy="such claims are decided for all curves"
        )
    handed: Curve[BSpline] = curve
    point: tuple[mpq, ...] = ()
    values: dict[str, mpq] = {}
    if isinstance(asked, CurveKind) and asked.with_point:
        point = point_beside(curve)
        handed = curve.with_point(point)
    if asked.constants:
        values = dict(zip(asked.constants, CONSTANTS, strict=False))
        if len(values) < len(asked.constants):
            raise InapplicableError(
                f"{counted(len(asked.constants), 'constant')}", remedy=f"at most {len(CONSTANTS)} are tried"
            )
    constants = {name: curve.w.constant(value) for name, value in values.items()}
    named = tuple((Name(name), value) for name, value in values.items())
    chosen = say.chosen(point, named) if point or named else None
    if isinstance(asked, HodographKind):
        return _Given(with_hodograph(curve, constants), Fact.AS_HODOGRAPH, chosen)
    if constants:
        handed = Accompanied(handed, constants)
    return _Given(handed, chosen, chosen)


def free_operands(kind: str) -> Evidence | None:
    """The free operands next to the curve in arguments of a kind; None if there are none.

    >>> for kind in ("plane pair", "plane point", "plane with delta"):
    ...     print(free_operands(kind))
    with any second curve
    with any point
    with any δ
    """
    asked = kind_of(kind)
    if isinstance(asked, PairKind):
        return Fact.ANY_SECOND_CURVE
    with_point = isinstance(asked, CurveKind) and asked.with_point
    if not with_point and not asked.constants:
        return None
    return say.with_any((*[Name("point")] * with_point, *map(Name, asked.constants)))


#: The largest degree in a parameter to which formulas are multiplied out on single surfaces.
LARGEST = 100


def too_long(formulas: Iterable[Formula], surface: NurbsSurface) -> Said | None:
    """The first formula whose value as written has too high a degree on a surface; None if there is none.

    >>> from exactspline.papers import find
    >>> from exactspline.interchange.examples import example_surface
    >>> print(too_long([find("surfaces:E"), find("surfaces:brioschi")], example_surface("torus")))
    brioschi as written has degree 208 in u there, too high to be multiplied out
    """
    for formula in formulas:
        for parameter, d in zip(formula.kind.counted, surface.degree, strict=True):
            reading = DegreeReading(parameter=parameter)
            degree = reading.count(formula, surface.dimension, polynomial=surface.polynomial)
            if (n := degree.at(dict.fromkeys(degree.names, d))) > LARGEST:
                return say.too_long(Name(formula.name), n, parameter)
    return None


class Evaluation:
    """One curve with the values of formulas on it. It belongs to one run of the ledger: curves can be shared between
    threads, evaluations are not.

    >>> from exactspline.interchange.examples import example
    >>> own = Evaluation(example("cusp"))
    >>> own.argument("plane") is own.argument("plane"), own.argument("plane") is own.curve
    (True, False)
    """

    def __init__(self, curve: Nurbs | NurbsSurface | Operands) -> None:
        self.curve: Any = curve
        self._arguments: dict[str, _Given] = {}
        self._pair: Evaluated | None = None
        self._failing: dict[tuple[str, Assumption], Said | None] = {}

    def given(self, kind: str) -> _Given:
        """The argument of formulas of a kind, which memoizes their values, with its description."""
        if kind == ArgumentKind.TABLE:
            return _Given(self.curve)
        if kind not in self._arguments:
            given = argument(kind, self.curve)
            made = self._bare if given.argument is self.curve else given.argument.remembering()
            self._arguments[kind] = given._replace(argument=made)
        return self._arguments[kind]

    @cached_property
    def _bare(self) -> Evaluated:
        """The curve itself, for all kinds without additional operands."""
        return cast(Evaluated, self.curve.remembering())

    def argument(self, kind: str) -> Evaluated:
        """The argument of formulas of a kind."""
        return self.given(kind).argument

    def _assumed_of(self, kind: str) -> Evaluated:
        """The argument about which assumptions are made: all segments of both curves of a pair."""
        if not isinstance(kind_of(kind), PairKind):
            return self.argument(kind)
        if self._pair is None:
            self._pair = surface_pair(self.curve, moved_copy(self.curve)).remembering()
        return self._pair

    def failing(self, kind: str, assumed: Iterable[Assumption]) -> Said | None:
        """The first assumption that fails on this curve, with the place; None when all hold."""
        for each in assumed:
            if (kind, each) not in self._failing:
                on_surface = isinstance(self.curve, NurbsSurface)
                own = self._assumed_of(kind)
                place = fails_on_surface(each, each.polynomial(own)) if on_surface else _fails(each, own)
                self._failing[kind, each] = say.vanishes(Name(each.subject), place) if place else None
            if failing := self._failing[kind, each]:
                return failing
        return None


#: The evaluations of a context, by the identity of the curve (which they keep alive).
_SHARED: ContextVar[dict[int, Evaluation] | None] = ContextVar("shared evaluations", default=None)


@contextmanager
def sharing_evaluations() -> Iterator[None]:
    """A context in which each curve has one evaluation."""
    with while_set(_SHARED, {}):
        yield


def evaluation(curve: Nurbs | NurbsSurface | Operands | Evaluation) -> Evaluation:
    """The evaluation of a curve; an evaluation is returned unchanged.

    >>> from exactspline.interchange.examples import example
    >>> with sharing_evaluations():
    ...     evaluation(example("cusp")) is evaluation(example("cusp"))
    True
    """
    if isinstance(curve, Evaluation):
        return curve
    shared = _SHARED.get()
    return Evaluation(curve) if shared is None else shared.setdefault(id(curve), Evaluation(curve))


def _fails(each: Assumption, argument: object) -> Place | None:
    value = each.polynomial(argument)
    if isinstance(value, TensorSpline):
        return _fails_on_pair(each, value)
    if not each.everywhere:
        return next((segment(value, i) for i, p in enumerate(value.numerators) if not p), None)
    return zero_of(value)


def _fails_on_pair(each: Assumption, value: TensorSpline) -> Place | None:
    """The same for the parameters of two curves. A value that depends on one parameter alone is constant in the other
    one, so that one line of constant parameter decides.
    """
    if not each.everywhere:
        return None if all(value.numerators) else say.on_whole_patch()
    other = PARAMETERS[0 if each.second else 1]
    if not value.d(1, by=other).is_zero:
        return fails_on_surface(each, value)
    line = value.at_s if each.second else value.at_t
    middles = [(a + b) / 2 for a, b in pairwise(value.meshes[0 if each.second else 1].breaks)]
    return next((place for t in middles if (place := zero_of(line(t)))), None)


def fails_on_surface(each: Assumption, value: TensorSpline) -> Place | None:
    """The place where a value in two parameters violates an assumption; an undecided place counts as a zero."""
    from exactspline.bivariate.signs import Sign, sign_on_patch  # most evaluations are of curves

    patches = product(*[range(len(mesh)) for mesh in value.meshes])
    for form, (i, j) in ((value.patch_form(*patch), patch) for patch in patches):
        if not each.everywhere:
            if form.is_zero:
                return say.on_whole_patch()
            continue
        sign = Sign.ZERO if form.is_zero else sign_on_patch(form).sign
        if sign not in (Sign.POSITIVE, Sign.NEGATIVE):
            return say.possibly_on_patch(i, j) if sign is Sign.UNDECIDED else say.on_patch(i, j)
    return None


def segment(f: BSpline, i: int) -> Said:
    """A whole segment."""
    return say.on_all_of(*f.breakpoints[i : i + 2])


def zero_of(f: BSpline) -> Place | None:
    """A place where a spline has a zero, including zeros as one-sided limits; None if the spline has no zero.

    >>> str(zero_of(BSpline.identity(0, 1))), zero_of(BSpline.identity(0, 1) + 1)
    ('at the parameter 0', None)
    """
    for i, p in enumerate(f.numerators):
        if not p:
            return segment(f, i)
        a, b = f.breakpoints[i : i + 2]
        if zero := zero_on_segment(p, f.degree):
            return place_between(Interval(a, b).part(zero))
    return None


def place_between(interval: Interval) -> At | Between:
    """The place of a zero."""
    s, t = interval
    return At(s) if s == t else Between(s, t)


# ---- one segment
# Statements about these values hold on the whole segment for all values of the free operands: no single values are
# tried.


#: The parameters minus those at which a segment begins; names that no operand has.
OWN, BAR = "_s", "_s_bar"
#: The number of values tried for a witness.
TRIES = 40


class _OnSegment(Kind):
    """A kind some of whose functions are polynomials in their parameters: instead of these functions the parameters are
    operands, with derivative 1.
    """

    def __init__(self, kind: Kind, *, both: bool) -> None:
        self.whole, self.name, self.dimensions = kind, f"{kind.name}, on a segment", kind.dimensions
        self.both = both

    def __reduce__(self) -> tuple[object, ...]:
        return with_explicit_curve, (self.whole, self.both)

    def explicit(self, dimension: int) -> set[str]:
        """The names of the operands that are polynomials."""
        if isinstance(self.whole, HodographKind):
            return {"x", "y", "u", "v", "h"}
        return {*COORDINATES[:dimension], "w"} | ({*BARRED[:dimension], "W"} if self.both else set())

    def symbols(self, dimension: int, *, polynomial: bool = False) -> tuple[Symbol, ...]:
        """The parameters, and the operands that are free."""
        given = self.explicit(dimension)
        parameters = [Symbol(OWN, "s", PARAMETERS[:1]), *([Symbol(BAR, "s̄", PARAMETERS[1:])] if self.both else [])]
        rest = self.whole.symbols(dimension, polynomial=polynomial)
        return (*parameters, *[symbol for symbol in rest if symbol.name not in given])

    def names(self, dimension: int) -> dict[str, bool]:
        """The names of the kind's operands."""
        return self.whole.names(dimension)

    def rules(self, dimension: int) -> dict[str, Rule]:
        """The derivative of a parameter with respect to itself."""
        return {name: lambda named: named[OWN].constant(1) for name in (OWN, *([BAR] if self.both else []))}

    def argument(
        self, dimension: int, operand: Callable[[Symbol], T], one: T, *, polynomial: bool = False
    ) -> Evaluated:
        """The argument of the kind, its polynomials included."""
        return self.whole.argument(dimension, operand, one, polynomial=polynomial)

    def of_operands(self, named: Mapping[str, T], dimension: int, one: T) -> Evaluated:
        """The argument of the kind."""
        return self.whole.of_operands(named, dimension, one)


@cache
def with_explicit_curve(kind: Kind, both: bool) -> Kind:
    """A kind whose curve, or both of whose curves, are polynomials in the parameter."""
    return _OnSegment(kind, both=both)


class OnSegment(NamedTuple):
    """An argument on the segment [low, high]."""

    argument: Any
    low: mpq
    high: mpq

    @property
    def interval(self) -> Said:
        """The segment as a place."""
        return say.somewhere_on(self.low, self.high)

    def place(self, value: JetFraction) -> At | Said:
        """A parameter at which a nonzero value does not vanish (for some values of the free operands), or the interval
        if no such parameter is found quickly.
        """
        variables = value.ring.variables
        for k in range(2, 2 + TRIES):
            step = (self.high - self.low) / k
            at = [
                to_fmpq(step if name in (OWN, BAR) else mpq(3 * i + k, k + 1)) for i, (name, _) in enumerate(variables)
            ]
            if value.top(*at) and value.bottom(*at):
                return At(self.low + step)
        return self.interval


def on_segments(kind: Kind, curve: Nurbs, order: int, *, same: bool = False) -> Iterator[OnSegment]:
    """The argument of a kind on each segment of a curve: the curve (of a pair the first one, or with `same` both) by
    explicit polynomials, everything else indeterminate with derivatives up to `order`. For a hodograph, u, v and h are
    explicit, too: those of the curve.

    >>> from exactspline.language.kinds import kind_of
    >>> from exactspline.interchange.examples import example
    >>> [segment] = on_segments(kind_of("plane with delta"), example("parabola"), 2)
    >>> str(segment.interval), segment.argument.p[0].d(2) * segment.argument.delta
    ('on [0, 1]', (0) / (1))
    """
    both = same and isinstance(kind, PairKind)
    ring = JetRing(with_explicit_curve(kind, both), curve.dimension, order, polynomial=curve.polynomial)
    one = JetFraction(ring, ring.context.constant(1), ring.context.constant(1))
    own = with_hodograph(curve, {}) if isinstance(kind, HodographKind) else curve
    splines: dict[str, BSpline] = dict(own.operands())
    for i, (a, b) in enumerate(zip(curve.breakpoints, curve.breakpoints[1:], strict=False)):

        def operand(symbol: Symbol, i: int = i) -> JetFraction:
            if symbol.name not in ring.symbols:
                spline, parameter = splines[symbol.name.lower()], BAR if symbol.name.isupper() else OWN
                return _polynomial(spline, i, ring, parameter)
            return JetFraction(ring, ring[symbol.name].polynomial, ring.context.constant(1))

        made = kind.argument(curve.dimension, operand, one, polynomial=curve.polynomial)
        yield OnSegment(made.remembering(), a, b)


def _polynomial(f: BSpline, i: int, ring: JetRing, parameter: str) -> JetFraction:
    """A segment of a spline as a polynomial in the parameter minus its value at the start of the segment."""
    local = in_powers(f, i)(fmpq_poly([to_fmpq(f.breakpoints[i]), 1]))
    t, polynomial = ring[parameter].polynomial, ring.context.constant(0)
    for c in reversed(local.coeffs()):
        polynomial = polynomial * t + c
    return JetFraction(ring, polynomial, ring.context.constant(1))


def at_equal_parameters(value: JetFraction) -> JetFraction:
    """A value in both parameters of `on_segments(…, same=True)` where these are equal.

    Raises `VanishingDivisorError` if its denominator vanishes there.
    """
    return equated(value, {BAR: OWN})


def equated(value: JetFraction, images: Mapping[str, str]) -> JetFraction:
    """A quotient with some of its operands replaced by others, and their derivatives by theirs.

    Raises `VanishingDivisorError` if its denominator then vanishes.
    """
    ring = value.ring
    places = [ring.gens[ring.index[images.get(name, name), order]] for name, order in ring.variables]
    top, bottom = (p.compose(*places, ctx=ring.context) for p in (value.top, value.bottom))
    if not bottom:
        raise VanishingDivisorError("a denominator vanishes where the points meet", remedy="multiply the formula by it")
    return JetFraction(ring, top, bottom)
