"""The zeros of functions of two parameters: the common zeros of several functions, and the curves of zeros of one
function.

Common zeros are found by elimination (`exactspline.bivariate.common_zeros`), curves of zeros by boxes in which they are
graphs, and by elimination where these do not suffice (`exactspline.bivariate.zero_curve`), patch by patch.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from enum import StrEnum
from itertools import combinations, pairwise, product
from typing import NamedTuple, TypeVar, cast

from flint import fmpz_mpoly

from exactspline.bivariate import common_zeros as elimination
from exactspline.bivariate.across_borders import alike, is_in, once
from exactspline.bivariate.borders import EDGES, Patch, vanishes_at
from exactspline.bivariate.common_zeros_certificate import common_zeros_certificate, zero_curve_certificate
from exactspline.bivariate.joined_curves import Piece, ZeroComponent, chained, place_of
from exactspline.bivariate.singular_points import PointKind, SingularPoint, singular_on_patch
from exactspline.bivariate.zero_curve import Shape, ZeroCurve
from exactspline.bivariate.zero_lines import LinesOfPatch, ZeroLine, square_free, without_lines, zero_lines
from exactspline.errors import ReachError, as_instance, as_items
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Box, Interval
from exactspline.numbers.once import cached_property
from exactspline.one_line import OneLine, one_line
from exactspline.polynomials.cost import PATCH, QUESTION, Budget, drawing_on
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.polynomials.patch_forms import PatchForm
from exactspline.polynomials.two_parameters import as_form, over
from exactspline.reals.real import Real, real
from exactspline.roots.answers import Answer
from exactspline.roots.of_polynomials import Parameter, Place
from exactspline.roots.root import Root
from exactspline.roots.vanishing import vanish_at
from exactspline.splines.surface import Along
from exactspline.splines.tensor import TensorSpline, aligned

T_co = TypeVar("T_co", covariant=True)


@dataclass(frozen=True, repr=False)
class SurfacePart(OneLine):
    """A part of one patch of a surface: a rectangle of parameters, an edge (one side of the rectangle is a single
    number), or a curve inside the rectangle.

    >>> from gmpy2 import mpq
    >>> from exactspline.numbers.intervals import Interval
    >>> print(SurfacePart((0, 0), Box(Interval(mpq(0), mpq(1)), Interval.point(mpq(2)))))
    [0, 1] × [2, 2]
    """

    patch: tuple[int, int]
    sides: Box
    along_curve: bool = False

    @one_line
    def __str__(self) -> str:
        return f"{'a curve in ' * self.along_curve}{self.sides.shortly}"


@dataclass(frozen=True, repr=False)
class SurfacePlaces(Answer[T_co, SurfacePart]):
    """The places of a surface at which something holds: points, each once, and `everywhere` parts of patches.
    `undecided` are rectangles of parameters in which there may be more. An answer with such a rectangle is not
    "nowhere".

    >>> from gmpy2 import mpq
    >>> from exactspline.numbers.intervals import Interval
    >>> unit = Box(Interval(mpq(0), mpq(1)), Interval(mpq(0), mpq(1)))
    >>> SurfacePlaces((), undecided=(unit,)), bool(SurfacePlaces((), undecided=(unit,)))
    (undecided in [0, 1] × [0, 1], True)
    """

    undecided: tuple[Box, ...] = ()

    def __bool__(self) -> bool:
        return super().__bool__() or bool(self.undecided)

    def _parts(self) -> list[str]:
        return super()._parts() + [f"undecided in {SurfacePart((0, 0), box)}" for box in self.undecided]


#: The digits of the points of a picture.
DRAWN = 16


class ZeroKind(StrEnum):
    """The kind of a common zero of functions."""

    #: The gradients of two of the functions are linearly independent.
    TRANSVERSAL = "transversal"
    #: The curves on which the functions vanish have a common tangent.
    TOUCHING = "touching"
    #: One of the functions vanishes there together with both its derivatives.
    MULTIPLE = "multiple"
    #: A function, or a common factor of all functions, vanishes at this point and at no other point around it.
    ISOLATED = "isolated"
    #: A point on a knot line that has different kinds on the patches that meet, or is not a zero on all of them.
    KNOT = "different on patches that meet"


class ZeroPlace(StrEnum):
    """The position of a point in the rectangle of both parameters."""

    INSIDE = "inside a patch"
    KNOT = "on a knot line"
    BORDER = "on the border"
    CORNER = "at a corner"


@dataclass(frozen=True)
class CommonZero:
    """A common zero of functions: its two parameters, its `kind`, its position `where`, and the patches on which it was
    found.

    `multiplicity` is the intersection multiplicity: 1 at a transversal zero, and at knots the least multiplicity on the
    patches. For more than two functions it is None except at transversal zeros; it is also None if a common factor
    vanishes at this point alone. Both `kind` and `multiplicity` are None if computing them would take too long.
    """

    first: Real
    second: Real
    multiplicity: int | None = None
    patches: tuple[Patch, ...] = field(default=(), compare=False)
    kind: ZeroKind | None = None
    where: ZeroPlace = ZeroPlace.INSIDE

    @property
    def contact(self) -> int | None:
        """The order of contact of two curves that meet transversally (0) or touch: the multiplicity less one."""
        if self.kind not in (ZeroKind.TRANSVERSAL, ZeroKind.TOUCHING) or self.multiplicity is None:
            return None
        return self.multiplicity - 1

    @property
    def place(self) -> Place:
        """Both parameters; a rational parameter is a rational number."""
        return _plain(self.first), _plain(self.second)

    def box(self, digits: int = 20) -> Box:
        """A box that contains the zero, its sides at most ``10^−digits`` long."""
        return Box(self.first.enclosure(digits), self.second.enclosure(digits))

    @one_line
    def __repr__(self) -> str:
        kind = "" if self.kind in (None, ZeroKind.TRANSVERSAL, ZeroKind.ISOLATED) else f", {self.kind}"
        times = "" if self.multiplicity in (None, 1) else f", multiplicity {self.multiplicity}"
        return f"<zero at {self.first.shortly()} and {self.second.shortly()}{kind}{times}>"


@dataclass(frozen=True, repr=False)
class CommonZeros(SurfacePlaces[CommonZero]):
    """All common zeros of functions of two parameters."""

    functions: tuple[TensorSpline, ...] = field(default=(), compare=False)

    def certificate(self) -> dict[str, object]:
        """A proof, as JSON data with exact strings, that these are all common zeros; for two functions it also proves
        the multiplicities (see `exactspline.certificates`).

        >>> from exactspline import TensorSpline, check_certificate
        >>> flat, knots = [0, 0, 1, 1], [0, 0, 0, 1, 1, 1]
        >>> line = TensorSpline((1, 1), flat, flat, [[0, -1], [1, 0]])  # s − t
        >>> circle = TensorSpline((2, 2), knots, knots, [[-1, -1, 0], [-1, -1, 0], [0, 0, 1]])  # s² + t² − 1
        >>> check_certificate(common_zeros(circle, line).certificate())
        {'zeros': 1, 'multiplicity': 1}
        >>> check_certificate(common_zeros(circle, line * line).certificate())
        {'zeros': 1, 'multiplicity': 2}

        Raises `ReachError` if something is `undecided` or `everywhere`, and if the proof is too long.
        """
        if not self.functions or self.everywhere or self.undecided:
            problem = "a certificate where functions vanish together along a curve, or something is undecided"
            raise ReachError(problem, remedy="divide by the common factor; ask for the points")
        return common_zeros_certificate(self.functions, [(x.place, x.patches) for x in self.points])


@dataclass(frozen=True)
class ZeroArc:
    """An arc of a curve of zeros between two singular points or points on the border, by the parameters of its ends. An
    end in an undecided box is None; both ends of a `closed` curve without such points are None.
    """

    curve: ZeroComponent = field(compare=False)
    start: tuple[Real, Real] | None
    end: tuple[Real, Real] | None
    closed: bool = False

    @one_line
    def __repr__(self) -> str:
        if self.closed:
            return "<closed loop>"
        start, end = ("?" if x is None else " and ".join(t.shortly() for t in x) for x in (self.start, self.end))
        return f"<arc from {start} to {end}>"


@dataclass(frozen=True, repr=False)
class ZeroCurves:
    """All zeros of a function of two parameters: `lines` parallel to an axis, other connected `curves`, single
    `points`, and `everywhere` the patches on which the function vanishes. `undecided` are rectangles in which there may
    be more.
    """

    lines: tuple[ZeroLine, ...] = ()
    curves: tuple[ZeroComponent, ...] = ()
    points: tuple[CommonZero, ...] = ()
    everywhere: tuple[SurfacePart, ...] = ()
    undecided: tuple[Box, ...] = ()
    function: TensorSpline | None = field(default=None, compare=False)
    #: The parameters whose two ends are identified.
    closed: tuple[Along, ...] = ()

    @property
    def complete(self) -> bool:
        """Whether no rectangle is undecided."""
        return not self.undecided

    @cached_property
    def singular_points(self) -> tuple[SingularPoint, ...]:
        """The multiple points: nodes, cusps, tacnodes, isolated points and points of higher multiplicity, by their
        exact parameters, and points at knots at which more than two branches meet. If the curve continues beyond the
        border of the domain, the kind is that of the whole curve.

        >>> from exactspline import TensorSpline
        >>> knots = [0, 0, 0, 0, 1, 1, 1, 1]
        >>> rows = [[0, 0, -1, -3], [0, 0, -1, -3], [0, 0, -1, -3], [1, 1, 0, -2]]  # s³ − 3t²
        >>> zero_curve(TensorSpline((3, 3), knots, knots, rows)).singular_points
        (<cusp at 0 and 0>,)

        Raises `ReachError` if this would take too long.
        """
        if self.function is None:
            return ()
        single = {x.place for x in self.points}
        found: dict[Place, list[SingularPoint]] = {}
        with drawing_on(budget_for(self.function)):
            for patch, sides in patches_of(self.function):
                form = self.function.patch_form(*patch)
                for place, kind, order, milnor in () if form.is_zero else singular_on_patch(form, sides, single):
                    s, t = map(real, place)
                    found.setdefault(place, []).append(SingularPoint(s, t, kind, order, milnor, (patch,)))
            places = dict.fromkeys([*found, *_met(self.curves, self.lines, self.function)])
            points = [_of_all_patches(place, found.get(place, []), self.function) for place in places]
        return tuple(sorted(points, key=lambda point: (point.first, point.second)))

    @cached_property
    def arcs(self) -> tuple[ZeroArc, ...]:
        """The arcs of all `curves` between singular points and points on the border; a closed curve without such points
        is one arc without ends. Arcs continue through points at which a curve crosses one of the `lines`.

        >>> from exactspline import TensorSpline
        >>> knots = [0, 0, 0, 1, 1, 1]
        >>> cross = TensorSpline((2, 2), knots, knots, [[0, -1, 0], [1, 0, 1], [0, -1, 0]])  # (s − t)(1 − s − t)
        >>> len(zero_curve(cross).arcs), zero_curve(cross).arcs[0]
        (4, <arc from 0 and 0 to 1/2 and 1/2>)

        Raises `ReachError` if this would take too long.
        """
        if self.function is None:
            return ()
        with drawing_on(budget_for(self.function)):
            return tuple(
                ZeroArc(curve, _reals(start), _reals(end), closed)
                for curve in self.curves
                for start, end, closed in curve.arcs(self.function.domain, self.closed)
            )

    def sampled(self, steps: int = 40) -> list[list[tuple[mpq, mpq]]]:
        """The `lines` and `curves` as sequences of rational points on or near them, for pictures. `steps` is the number
        of steps on an arc as long as a side of a patch; shorter arcs have fewer steps.

        >>> from exactspline import TensorSpline
        >>> line = TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[-1, -1], [1, 1]])  # 2s − 1
        >>> zero_curve(line).sampled()
        [[(mpq(1,2), mpq(0,1)), (mpq(1,2), mpq(1,1))]]
        """
        runs = [[(_near(s), _near(t)) for s, t in zip(*line.box, strict=True)] for line in self.lines]
        pieces = [piece for curve in self.curves for piece in curve.pieces]
        for piece, arc in [(own, arc) for own in pieces for arc in own.part.arcs]:
            ends = [tuple(map(_near, piece.curve.place(vertex))) for vertex in (arc.first, arc.last)]
            count = int(steps * max(abs(a - b) for a, b in zip(*ends, strict=True)))
            own = piece.curve.points(arc, count) if count > 1 else ends  # for short arcs the ends suffice
            runs.append([piece.sides.at(*place) for place in own])
        return runs

    def certificate(self) -> dict[str, object]:
        """A proof, as JSON data with exact strings, of the numbers of lines, loops, arcs, curves with crossings and
        single points, each counted on every patch that has it (see `exactspline.certificates`).

        >>> from exactspline import TensorSpline, check_certificate
        >>> knots = [0, 0, 0, 1, 1, 1]
        >>> cross = TensorSpline((2, 2), knots, knots, [[0, -1, 0], [1, 0, 1], [0, -1, 0]])  # (s − t)(1 − s − t)
        >>> check_certificate(zero_curve(cross).certificate())
        {'lines': 0, 'loops': 0, 'arcs': 0, 'crossed': 1, 'points': 0}

        Raises `ReachError` if something is `undecided`, if the function vanishes on a patch, or if the proof is too
        long.
        """
        if self.function is None or self.undecided:
            raise ReachError("a certificate where something is undecided", remedy="ask for the curves")
        return zero_curve_certificate(self.function)

    def __bool__(self) -> bool:
        return any((self.lines, self.curves, self.points, self.everywhere, self.undecided))

    @one_line
    def __repr__(self) -> str:
        parts = ["a line"] * len(self.lines) + [curve.shape.value for curve in self.curves]
        parts += [*map(repr, self.points), *(f"everywhere on {part}" for part in self.everywhere)]
        return ", ".join(parts + [f"undecided in {SurfacePart((0, 0), box)}" for box in self.undecided]) or "nowhere"


def _function_of_two(given: object) -> TensorSpline:
    """The function of two parameters itself; raises `ShapeError` for anything else."""
    remedy = "give a TensorSpline, one component of a surface at a time"
    return as_instance(given, TensorSpline, "a function of two parameters", remedy)


def common_zeros(
    first: TensorSpline, second: TensorSpline, *more: TensorSpline, closed: Iterable[Along] = ()
) -> CommonZeros:
    """Return all points at which two or more functions of two parameters vanish together, each point once. `everywhere`
    lists the patches, lines and curves on which the functions vanish together.

    >>> from exactspline import TensorSpline
    >>> knots = [0, 0, 0, 1, 1, 1]
    >>> circle = TensorSpline((2, 2), knots, knots, [[-1, -1, 0], [-1, -1, 0], [0, 0, 1]])  # s² + t² − 1
    >>> line = TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[0, -1], [1, 0]])  # s − t
    >>> (point,) = common_zeros(circle, line)
    >>> point, point.first == point.second, point.first.minimal_polynomial()
    (<zero at √2/2 and √2/2>, True, [-1, 0, 2])
    >>> common_zeros(circle, circle * line)
    everywhere on a curve in [0, 1] × [0, 1]
    >>> common_zeros(line, line.partial(1, 0))
    nowhere

    Points of parts in `everywhere` are not listed, even as points of a neighbouring patch. The two ends of a `closed`
    parameter are identified. The work is limited to about ten seconds (somewhat more for many patches); patches that
    would take more are `undecided`.

    Raises `ShapeError` for anything except functions of two parameters, and `DomainError` for different domains.

    Source: Berberich, Emeliyanenko, Kobel and Sagraloff, Exact symbolic-numeric computation of planar algebraic curves,
    Theoretical Computer Science 2013.
    """
    functions, ring = aligned(*[_function_of_two(f) for f in (first, second, *more)]), _ring(closed)
    found, whole, factors, undecided = list[_Zero](), list[SurfacePart](), list[_OnPatch](), list[Box]()
    with drawing_on(budget_for(functions[0])):
        for patch, sides in patches_of(functions[0]):
            try:
                points, own = _common_on_patch([f.patch_form(*patch) for f in functions], patch, sides)
            except ReachError:
                undecided.append(sides)
                continue
            found += points
            whole += own.parts
            factors.append(own)
            undecided += own.undecided
        *_, points, undecided = _joined(factors, undecided, functions[0], found, ring)
    return CommonZeros(_each_once(points, functions[0], ring), tuple(whole), tuple(undecided), tuple(functions))


def zero_curve(function: TensorSpline, closed: Iterable[Along] = ()) -> ZeroCurves:
    """Return all zeros of a function of two parameters with their topology: lines parallel to an axis, connected curves
    (loops, arcs, and branches that cross), and single points.

    >>> from exactspline import TensorSpline
    >>> knots = [0, 0, 0, 1, 1, 1]
    >>> zero_curve(TensorSpline((2, 2), knots, knots, [[-1, -1, 0], [-1, -1, 0], [0, 0, 1]]))  # s² + t² − 1
    arc from border to border
    >>> zero_curve(TensorSpline((2, 2), knots, knots, [[2, 0, 2], [0, -2, 0], [2, 0, 2]]))  # (2s − 1)² + (2t − 1)²
    <zero at 1/2 and 1/2>
    >>> (line,) = zero_curve(TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[-1, -1], [1, 1]])).lines
    >>> line.value
    mpq(1,2)

    Curves continue across knots and across the two ends of a `closed` parameter.

    The work is limited as for `common_zeros`; rectangles that would take more are `undecided`.

    Raises `ShapeError` for anything except a function of two parameters.
    """
    f = _function_of_two(function)
    found, undecided, ring = list[_OnPatch](), list[Box](), _ring(closed)
    with drawing_on(budget_for(f)):
        for patch, sides in patches_of(f):
            try:
                found.append(_on_patch(f.patch_form(*patch), patch, sides))
            except ReachError:
                undecided.append(sides)
        undecided += [box for own in found for box in own.undecided]
        lines, curves, points, undecided = _joined(found, undecided, f, closed=ring)
    whole = tuple(SurfacePart(own.lines.patch, own.lines.sides) for own in found if own.lines.flat)
    return ZeroCurves(lines, curves, _each_once(points, f, ring), whole, tuple(undecided), f, ring)


def _ring(closed: Iterable[Along]) -> tuple[Along, ...]:
    return tuple(as_instance(x, Along, "a direction", "write Along.U") for x in as_items(closed, "directions"))


def _near(x: Parameter) -> mpq:
    return x.refine(DRAWN).middle if isinstance(x, Root) else x


def _met(curves: Sequence[ZeroComponent], lines: Sequence[ZeroLine], f: TensorSpline) -> list[Place]:
    """The points on borders of patches at which more than two branches of curves and lines meet."""
    met = {place: arcs for curve in curves for place, arcs in curve.met.items()}
    for place, line in product(met, lines):
        if is_in(place, line.box, f.domain, ()):
            met[place] += 1 if place[line.along.direction] in line.interval else 2
    return [place for place, branches in met.items() if branches > 2]


def _of_all_patches(place: Place, own: Sequence[SingularPoint], f: TensorSpline) -> SingularPoint:
    """The singular point made of a point that is singular on several patches, or at which branches of several patches
    meet.
    """
    around = _around(place, f)
    if len(set(own)) == 1 and len(own) == len(around):
        return replace(own[0], patches=tuple(around))
    orders = {patch: point.multiplicity for point in own for patch in point.patches}
    for patch in around:
        form = f.patch_form(*patch)
        if patch not in orders and not form.is_zero and vanishes_at(form, place, f.patch(*patch)):
            orders[patch] = 1
    s, t = map(real, place)
    return SingularPoint(s, t, PointKind.KNOT, min(orders.values()), None, tuple(orders))


def _around(place: Place, f: TensorSpline) -> list[Patch]:
    """The patches that meet at a point."""
    first, second = (
        [k for k, (low, high) in enumerate(pairwise(mesh.breaks)) if low <= x <= high]
        for x, mesh in zip(place, f.meshes, strict=True)
    )
    return list(product(first, second))


def _reals(place: Place | None) -> tuple[Real, Real] | None:
    return None if place is None else (real(place[0]), real(place[1]))


def _plain(x: Real) -> Parameter:
    return x if isinstance(x, Root) else cast(mpq, x.exact)


class _Zero(NamedTuple):
    """A zero on one patch."""

    place: Place
    kind: ZeroKind | None
    multiplicity: int | None
    patch: Patch


def patches_of(f: TensorSpline) -> list[tuple[Patch, Box]]:
    """The patches of a function with their rectangles."""
    return [(patch, f.patch(*patch)) for patch in product(range(len(f.meshes[0])), range(len(f.meshes[1])))]


def budget_for(f: TensorSpline) -> Budget:
    """The budget of work for a question about a function."""
    return Budget(QUESTION + PATCH * (len(f.meshes[0]) * len(f.meshes[1]) - 1))


class _OnPatch(NamedTuple):
    """The zeros of a form on a patch: the lines on which it vanishes, or that it vanishes everywhere, and the other
    curves.
    """

    lines: LinesOfPatch
    curve: ZeroCurve | None = None

    @property
    def pieces(self) -> list[Piece]:
        """The parts of the curves."""
        patch, sides, curve = self.lines.patch, self.lines.sides, self.curve
        return [Piece(patch, sides, curve, part) for part in curve.parts] if curve else []

    @property
    def undecided(self) -> list[Box]:
        """The boxes in which there may be more zeros."""
        return [self.lines.sides.part(box) for box in self.curve.undecided] if self.curve else []

    @property
    def parts(self) -> list[SurfacePart]:
        """The parts on which the form vanishes: the whole patch, its edges and other lines, and a part for curves
        inside or lines at irrational values.
        """
        patch, sides, edges, inner, flat = self.lines
        lines = [(edge.direction, edge.value(sides)) for edge in edges]
        lines += [(1 - along.direction, x) for along, x in inner if not isinstance(x, Root)]
        boxes = [sides] * flat + [sides.with_side(k, Interval.point(x)) for k, x in lines]
        inside = any(isinstance(x, Root) for _, x in inner) or any(x.part.shape is not Shape.POINT for x in self.pieces)
        return [SurfacePart(patch, box) for box in boxes] + [SurfacePart(patch, sides, along_curve=True)] * bool(inside)


def _common_on_patch(forms: Sequence[PatchForm], patch: Patch, sides: Box) -> tuple[list[_Zero], _OnPatch]:
    """The single zeros of a patch that are not zeros of a common factor, and the zeros of the common factor."""
    polynomials = [over(form, sides) for form in forms if not form.is_zero]
    if not polynomials:
        return [], _OnPatch(LinesOfPatch(patch, sides, (), (), True))
    shared, found = greatest_common_divisor(polynomials), list[_Zero]()
    rest = [p / shared for p in polynomials]
    for zero in elimination.common_zeros(rest, sides):
        if shared.total_degree() == 0 or not vanish_at([shared], *zero.place):
            found.append(_Zero(zero.place, *_nature(zero, rest), patch))
    return found, _on_patch(as_form(shared).part(sides), patch, sides)


def _nature(zero: elimination.CommonZero, polynomials: Sequence[fmpz_mpoly]) -> tuple[ZeroKind | None, int | None]:
    """The kind and the multiplicity of a common zero of polynomials without a common factor."""
    slopes = [(p.derivative(0), p.derivative(1)) for p in polynomials]
    try:
        for (a, b), (c, d) in combinations(slopes, 2):
            if (jacobian := a * d - b * c) and not vanish_at([jacobian], *zero.place):
                return ZeroKind.TRANSVERSAL, 1
        is_multiple = any(vanish_at([f for f in pair if f], *zero.place) for pair in slopes)
        kind = ZeroKind.MULTIPLE if is_multiple else ZeroKind.TOUCHING
        return kind, elimination.multiplicity(zero, *polynomials) if len(polynomials) == 2 else None
    except ReachError:
        return None, None


def _on_patch(form: PatchForm, patch: Patch, sides: Box) -> _OnPatch:
    """The zeros of a form."""
    if form.sign is not None:
        return _OnPatch(LinesOfPatch(patch, sides, (), (), form.is_zero))
    rest, borders = form.without_border()
    edges = tuple(edge for edge, times in zip(EDGES, borders, strict=True) if times)
    rest, lines = without_lines(square_free(rest), sides)
    return _OnPatch(LinesOfPatch(patch, sides, edges, lines, False), ZeroCurve(rest))


def _joined(
    found: Sequence[_OnPatch],
    undecided: Sequence[Box],
    f: TensorSpline,
    others: Sequence[_Zero] = (),
    closed: Sequence[Along] = (),
) -> tuple[tuple[ZeroLine, ...], tuple[ZeroComponent, ...], list[_Zero], list[Box]]:
    """The joined lines and curves of all patches, the single points and `others` that are not on them, and the
    undecided boxes.
    """
    lines = zero_lines((len(f.meshes[0]), len(f.meshes[1])), f.domain, [own.lines for own in found], closed)
    components = chained([piece for own in found for piece in own.pieces], f.domain, closed, undecided)
    curves = tuple(component for component in components if component.shape is not Shape.POINT)
    points, open_boxes = _single(component for component in components if component.shape is Shape.POINT)
    spots = {spot for curve in curves for spot, arcs in curve.met.items() if arcs}
    parts = [line.box for line in lines] + [own.lines.sides for own in found if own.lines.flat]
    beside = [zero for zero in (*others, *points) if once(zero.place, f.domain, closed) not in spots]
    single = [zero for zero in beside if not any(is_in(zero.place, part, f.domain, closed) for part in parts)]
    return lines, curves, single, [*undecided, *open_boxes]


def _single(components: Iterable[ZeroComponent]) -> tuple[list[_Zero], list[Box]]:
    """The single points of curves of zeros by their exact parameters; and boxes around points for which this takes too
    long.
    """
    points, undecided = list[_Zero](), list[Box]()
    for component in components:
        for piece in component.pieces:
            try:
                points.append(_Zero(place_of(piece).spot, ZeroKind.ISOLATED, None, piece.patch))
            except ReachError:
                undecided += [piece.sides.part(cell) for cell in piece.part.cells]
    return points, undecided


def _each_once(found: Sequence[_Zero], f: TensorSpline, closed: Sequence[Along] = ()) -> tuple[CommonZero, ...]:
    """The points in order, with points at knots listed once."""
    inner, at_knots = list[list[_Zero]](), dict[Place, list[_Zero]]()
    for zero in found:
        if any(not isinstance(x, Root) and x in mesh.breaks for x, mesh in zip(zero.place, f.meshes, strict=True)):
            at_knots.setdefault(once(zero.place, f.domain, closed), []).append(zero)
        else:
            inner.append([zero])
    points = []
    for group in (*inner, *at_knots.values()):
        first, second = map(real, group[0].place)
        times = min((zero.multiplicity for zero in group if zero.multiplicity is not None), default=None)
        patches, kinds = tuple(zero.patch for zero in group), {zero.kind for zero in group}
        around = {patch for spot in alike(group[0].place, f.domain, closed) for patch in _around(spot, f)}
        kind = kinds.pop() if len(kinds) == 1 and len(patches) == len(around) else ZeroKind.KNOT
        points.append(CommonZero(first, second, times, patches, kind, _where(group[0].place, f)))
    return tuple(sorted(points, key=lambda point: (point.first, point.second)))


def _where(place: Place, f: TensorSpline) -> ZeroPlace:
    """The position of a point."""
    given = [(x, mesh.breaks) for x, mesh in zip(place, f.meshes, strict=True) if not isinstance(x, Root)]
    ends = sum(x in (breaks[0], breaks[-1]) for x, breaks in given)
    if ends:
        return ZeroPlace.CORNER if ends == 2 else ZeroPlace.BORDER
    return ZeroPlace.KNOT if any(x in breaks for x, breaks in given) else ZeroPlace.INSIDE
