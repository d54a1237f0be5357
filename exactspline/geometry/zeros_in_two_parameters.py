"""The zeros of functions of two parameters: those that several have in common, and the curves on which one vanishes.

Common zeros are found by elimination (`exactspline.roots.common_zeros`), curves of zeros by boxes in which they are
graphs, and by elimination where these do not suffice (`exactspline.geometry.surface.zero_curve`), patch by patch.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from enum import StrEnum
from functools import cached_property
from itertools import combinations, product
from typing import NamedTuple, cast

from flint import fmpz_mpoly

from exactspline.errors import ReachError
from exactspline.geometry.common_zeros_certificate import common_zeros_certificate
from exactspline.geometry.singular_points import PointKind, SingularPoint, singular_on_patch
from exactspline.geometry.surface.chains import Piece, ZeroComponent, chained, place_of
from exactspline.geometry.surface.common_factor import square_free
from exactspline.geometry.surface.forms import Patch
from exactspline.geometry.surface.zero_curve import Shape, ZeroCurve
from exactspline.geometry.surface.zero_lines import LinesOfPatch, ZeroLine, without_lines, zero_lines
from exactspline.geometry.zero_curve_certificate import zero_curve_certificate
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Box
from exactspline.polynomials.cost import PATCH, QUESTION, Budget, drawing_on
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.polynomials.patch_forms import PatchForm
from exactspline.polynomials.two_parameters import as_form, over
from exactspline.questions.answers import SurfacePart, SurfacePlaces
from exactspline.reals.real import Real, real
from exactspline.roots import common_zeros as elimination
from exactspline.roots.borders import EDGES
from exactspline.roots.of_polynomials import Parameter, Place
from exactspline.roots.root import Root
from exactspline.roots.vanishing import vanish_at
from exactspline.splines.expected import function_of_two
from exactspline.splines.tensor import TensorSpline, aligned

#: Digits of the points of a picture.
DRAWN = 16


class ZeroKind(StrEnum):
    """How functions vanish together at a point."""

    #: The gradients of two of them are linearly independent.
    TRANSVERSAL = "transversal"
    #: The curves on which they vanish have one tangent.
    TOUCHING = "touching"
    #: One of them vanishes there with both its derivatives.
    MULTIPLE = "multiple"
    #: A function, or a factor that all of them share, vanishes at this point and at no other one around it.
    ISOLATED = "isolated"
    #: On a knot line; of different kinds on the patches that meet, or not a zero on all of them.
    KNOT = "different on patches that meet"


class ZeroPlace(StrEnum):
    """Where a point is in the rectangle of both parameters."""

    INSIDE = "inside a patch"
    KNOT = "on a knot line"
    BORDER = "on the border"
    CORNER = "at a corner"


@dataclass(frozen=True)
class CommonZero:
    """A point at which functions vanish together: its two parameters, of which `kind` it is and `where`, and the
    patches on which it was found.

    `multiplicity` is the intersection multiplicity: 1 where it is transversal, at knots the least of those of the
    patches. It is None for more than two functions at other points, and where a common factor vanishes at this point
    alone. Both `kind` and `multiplicity` are None where it would take too long to compute them.
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
        """Both parameters, rational ones as such."""
        return _plain(self.first), _plain(self.second)

    def box(self, digits: int = 20) -> Box:
        """A box that contains it, its sides at most ``10^−digits`` long."""
        return Box(self.first.enclosure(digits), self.second.enclosure(digits))

    def __repr__(self) -> str:
        kind = "" if self.kind in (None, ZeroKind.TRANSVERSAL, ZeroKind.ISOLATED) else f", {self.kind}"
        times = "" if self.multiplicity in (None, 1) else f", multiplicity {self.multiplicity}"
        return f"<zero at {self.first.shortly()} and {self.second.shortly()}{kind}{times}>"


@dataclass(frozen=True, repr=False)
class CommonZeros(SurfacePlaces[CommonZero]):
    """All common zeros of functions of two parameters."""

    functions: tuple[TensorSpline, ...] = field(default=(), compare=False)

    def certificate(self) -> dict[str, object]:
        """A proof, as JSON data with exact strings, that these are all, and of two functions also of their
        multiplicities (see `exactspline.certificates`).

        >>> from exactspline import TensorSpline, check_certificate
        >>> flat, knots = [0, 0, 1, 1], [0, 0, 0, 1, 1, 1]
        >>> line = TensorSpline((1, 1), flat, flat, [[0, -1], [1, 0]])  # s − t
        >>> circle = TensorSpline((2, 2), knots, knots, [[-1, -1, 0], [-1, -1, 0], [0, 0, 1]])  # s² + t² − 1
        >>> check_certificate(common_zeros(circle, line).certificate())
        {'zeros': 1, 'multiplicity': 1}
        >>> check_certificate(common_zeros(circle, line * line).certificate())
        {'zeros': 1, 'multiplicity': 2}

        Raises `ReachError` where something is `undecided` or `everywhere`, and where the proof is too long.
        """
        if not self.functions or self.everywhere or self.undecided:
            raise ReachError(
                "a certificate where functions vanish together along a curve, or something is undecided",
                remedy="divide by the common factor; ask for the points",
            )
        return common_zeros_certificate(self.functions, [(x.place, x.patches) for x in self.points])


@dataclass(frozen=True)
class ZeroArc:
    """An arc of a curve of zeros, between two singular points or points on the border, by the parameters of both. An
    end is None in an undecided box; both are of a `closed` curve without such points.
    """

    curve: ZeroComponent = field(compare=False)
    start: tuple[Real, Real] | None
    end: tuple[Real, Real] | None
    closed: bool = False

    def __repr__(self) -> str:
        if self.closed:
            return "<closed loop>"
        start, end = ("?" if x is None else " and ".join(t.shortly() for t in x) for x in (self.start, self.end))
        return f"<arc from {start} to {end}>"


@dataclass(frozen=True, repr=False)
class ZeroCurves:
    """All zeros of a function of two parameters: `lines` parallel to an axis, other connected `curves`, single
    `points`, and `everywhere` the patches on which it vanishes. `undecided` are rectangles in which there may be more.
    """

    lines: tuple[ZeroLine, ...] = ()
    curves: tuple[ZeroComponent, ...] = ()
    points: tuple[CommonZero, ...] = ()
    everywhere: tuple[SurfacePart, ...] = ()
    undecided: tuple[Box, ...] = ()
    function: TensorSpline | None = field(default=None, compare=False)

    @property
    def complete(self) -> bool:
        """Whether every zero is accounted for."""
        return not self.undecided

    @cached_property
    def singular_points(self) -> tuple[SingularPoint, ...]:
        """The multiple points: nodes, cusps, tacnodes, isolated points and those of higher multiplicity, by their exact
        parameters. Where the curve continues beyond the border of the domain, the kind is that of all of it.

        >>> from exactspline import TensorSpline
        >>> knots = [0, 0, 0, 0, 1, 1, 1, 1]
        >>> rows = [[0, 0, -1, -3], [0, 0, -1, -3], [0, 0, -1, -3], [1, 1, 0, -2]]  # s³ − 3t²
        >>> zero_curve(TensorSpline((3, 3), knots, knots, rows)).singular_points
        (<cusp at 0 and 0>,)

        Raises `ReachError` where that would take too long.
        """
        if self.function is None:
            return ()
        single = {x.place for x in self.points}
        found: dict[Place, list[SingularPoint]] = {}
        with drawing_on(_budget(self.function)):
            for patch, sides in _patches(self.function):
                form = self.function.patch_form(*patch)
                for place, kind, order, milnor in () if form.is_zero else singular_on_patch(form, sides, single):
                    s, t = map(real, place)
                    found.setdefault(place, []).append(SingularPoint(s, t, kind, order, milnor, (patch,)))
        points = [_of_all_patches(own) for own in found.values()]
        return tuple(sorted(points, key=lambda point: (point.first, point.second)))

    @cached_property
    def arcs(self) -> tuple[ZeroArc, ...]:
        """The arcs of all `curves` between singular points and points on the border; a closed curve without any of them
        is one arc without ends. They run on through points at which a curve crosses one of the `lines`.

        >>> from exactspline import TensorSpline
        >>> knots = [0, 0, 0, 1, 1, 1]
        >>> cross = TensorSpline((2, 2), knots, knots, [[0, -1, 0], [1, 0, 1], [0, -1, 0]])  # (s − t)(1 − s − t)
        >>> len(zero_curve(cross).arcs), zero_curve(cross).arcs[0]
        (4, <arc from 0 and 0 to 1/2 and 1/2>)

        Raises `ReachError` where that would take too long.
        """
        if self.function is None:
            return ()
        with drawing_on(_budget(self.function)):
            return tuple(
                ZeroArc(curve, _reals(start), _reals(end), closed)
                for curve in self.curves
                for start, end, closed in curve.arcs(self.function.domain)
            )

    def sampled(self, steps: int = 40) -> list[list[tuple[mpq, mpq]]]:
        """The `lines` and `curves` as runs of rational points on or near them, for pictures; on an arc as many steps as
        are asked for along a side of a patch, fewer where it is shorter.

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
            own = piece.curve.points(arc, count) if count > 1 else ends  # of short arcs the ends suffice
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

        Raises `ReachError` where something is `undecided`, the function vanishes on a patch, or the proof is too long.
        """
        if self.function is None or self.undecided:
            raise ReachError("a certificate where something is undecided", remedy="ask for the curves")
        return zero_curve_certificate(self.function)

    def __bool__(self) -> bool:
        return any((self.lines, self.curves, self.points, self.everywhere, self.undecided))

    def __repr__(self) -> str:
        parts = ["a line"] * len(self.lines) + [curve.shape.value for curve in self.curves]
        parts += [*map(repr, self.points), *(f"everywhere on {part}" for part in self.everywhere)]
        return ", ".join(parts + [f"undecided in {SurfacePart((0, 0), box)}" for box in self.undecided]) or "nowhere"


def common_zeros(first: TensorSpline, second: TensorSpline, *more: TensorSpline) -> CommonZeros:
    """All points at which two or more functions of two parameters vanish together: simple and multiple ones, on borders
    and at knots, each once; and `everywhere` the patches, lines and curves on which they do.

    >>> from exactspline import TensorSpline
    >>> knots = [0, 0, 0, 1, 1, 1]
    >>> circle = TensorSpline((2, 2), knots, knots, [[-1, -1, 0], [-1, -1, 0], [0, 0, 1]])  # s² + t² − 1
    >>> line = TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[0, -1], [1, 0]])  # s − t
    >>> (point,) = common_zeros(circle, line)
    >>> point, point.first == point.second, point.first.minimal_polynomial()
    (<zero at 0.707107… and 0.707107…>, True, [-1, 0, 2])
    >>> common_zeros(circle, circle * line)
    everywhere on a curve in [0, 1] × [0, 1]
    >>> common_zeros(line, line.partial(1, 0))
    nowhere

    A point of a patch or of an edge on which the functions vanish everywhere is not listed; one on a curve of another
    patch is. The work is limited to about ten seconds (somewhat more for many patches); patches for which this does not
    suffice are `undecided`.

    Raises `ShapeError` for anything but functions of two parameters, and `DomainError` for different domains.

    Source: Berberich, Emeliyanenko, Kobel and Sagraloff, Exact symbolic-numeric computation of planar algebraic curves,
    Theoretical Computer Science 2013.
    """
    functions = aligned(*[function_of_two(f) for f in (first, second, *more)])
    found, whole, undecided = list[_Zero](), list[SurfacePart](), list[Box]()
    with drawing_on(_budget(functions[0])):
        for patch, sides in _patches(functions[0]):
            try:
                points, parts, open_boxes = _common_on_patch([f.patch_form(*patch) for f in functions], patch, sides)
            except ReachError:
                undecided.append(sides)
                continue
            found += points
            whole += parts
            undecided += open_boxes
    kept = [zero for zero in found if not _is_on(zero.place, whole)]
    return CommonZeros(_each_once(kept, functions[0]), tuple(whole), tuple(undecided), tuple(functions))


def zero_curve(function: TensorSpline) -> ZeroCurves:
    """All zeros of a function of two parameters with their topology: lines parallel to an axis, connected curves
    (loops, arcs, branches that cross; followed across knots), and single points.

    >>> from exactspline import TensorSpline
    >>> knots = [0, 0, 0, 1, 1, 1]
    >>> zero_curve(TensorSpline((2, 2), knots, knots, [[-1, -1, 0], [-1, -1, 0], [0, 0, 1]]))  # s² + t² − 1
    arc from border to border
    >>> zero_curve(TensorSpline((2, 2), knots, knots, [[2, 0, 2], [0, -2, 0], [2, 0, 2]]))  # (2s − 1)² + (2t − 1)²
    <zero at 1/2 and 1/2>
    >>> (line,) = zero_curve(TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[-1, -1], [1, 1]])).lines
    >>> line.value
    mpq(1,2)

    The work is limited as for `common_zeros`; what this does not suffice for is `undecided`.

    Raises `ShapeError` for anything but a function of two parameters.
    """
    f = function_of_two(function)
    whole, lines_of, pieces, undecided = list[SurfacePart](), list[LinesOfPatch](), list[Piece](), list[Box]()
    with drawing_on(_budget(f)):
        for patch, sides in _patches(f):
            form = f.patch_form(*patch)
            if form.sign is not None:
                whole += [SurfacePart(patch, sides)] * form.is_zero
                lines_of.append(LinesOfPatch(patch, sides, (), (), form.is_zero))
                continue
            try:
                own, curve = _on_patch(form, patch, sides)
            except ReachError:
                undecided.append(sides)
                continue
            lines_of.append(own)
            pieces += [Piece(patch, sides, curve, part) for part in curve.parts]
            undecided += [sides.part(box) for box in curve.undecided]
        lines = zero_lines((len(f.meshes[0]), len(f.meshes[1])), f.domain, lines_of)
        components = chained(pieces, f.domain, (), undecided)
        points, open_boxes = _single(component for component in components if component.shape is Shape.POINT)
    kept = [zero for zero in points if not (_is_on(zero.place, whole) or any(_is_in(zero.place, x.box) for x in lines))]
    curves = tuple(component for component in components if component.shape is not Shape.POINT)
    return ZeroCurves(lines, curves, _each_once(kept, f), tuple(whole), (*undecided, *open_boxes), f)


def _near(x: Parameter) -> mpq:
    return x.refine(DRAWN).middle if isinstance(x, Root) else x


def _of_all_patches(own: Sequence[SingularPoint]) -> SingularPoint:
    """One point that is singular on several patches."""
    first, patches = own[0], tuple(patch for point in own for patch in point.patches)
    if len(set(own)) == 1:
        return replace(first, patches=patches)
    least = min(point.multiplicity for point in own)
    return SingularPoint(first.first, first.second, PointKind.KNOT, least, None, patches)


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


def _patches(f: TensorSpline) -> list[tuple[Patch, Box]]:
    return [(patch, f.patch(*patch)) for patch in product(range(len(f.meshes[0])), range(len(f.meshes[1])))]


def _budget(f: TensorSpline) -> Budget:
    return Budget(QUESTION + PATCH * (len(f.meshes[0]) * len(f.meshes[1]) - 1))


def _common_on_patch(
    forms: Sequence[PatchForm], patch: Patch, sides: Box
) -> tuple[list[_Zero], list[SurfacePart], list[Box]]:
    """The single zeros of a patch, where all of it, an edge or a curve consists of zeros, and what is not decided."""
    polynomials = [over(form, sides) for form in forms if not form.is_zero]
    if not polynomials:
        return [], [SurfacePart(patch, sides)], []
    shared = greatest_common_divisor(polynomials)
    if shared.total_degree() > 0:
        found, whole, undecided = _of_factor(shared, patch, sides)
    else:
        found, whole, undecided = [], [], []
    rest = [p / shared for p in polynomials]
    for zero in elimination.common_zeros(rest, sides):
        if shared.total_degree() == 0 or not vanish_at([shared], *zero.place):
            found.append(_Zero(zero.place, *_nature(zero, rest), patch))
    return found, whole, undecided


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


def _of_factor(p: fmpz_mpoly, patch: Patch, sides: Box) -> tuple[list[_Zero], list[SurfacePart], list[Box]]:
    """The zeros of a common factor: single ones, edges and curves, and boxes in which there may be more."""
    lines, curve = _on_patch(as_form(p).part(sides), patch, sides)
    components = chained([Piece(patch, sides, curve, part) for part in curve.parts], sides, ())
    points, undecided = _single(component for component in components if component.shape is Shape.POINT)
    points = [zero for zero in points if not any(zero.place[1 - x.direction] == value for x, value in lines.inner)]
    whole = [SurfacePart(patch, edge.box(sides)) for edge in lines.edges]
    if lines.inner or any(component.shape is not Shape.POINT for component in components):
        whole.append(SurfacePart(patch, sides, along_curve=True))
    return points, whole, [*undecided, *(sides.part(box) for box in curve.undecided)]


def _on_patch(form: PatchForm, patch: Patch, sides: Box) -> tuple[LinesOfPatch, ZeroCurve]:
    """The lines on which a form vanishes, and its other zeros."""
    rest, borders = form.without_border()
    edges = tuple(edge for edge, times in zip(EDGES, borders, strict=True) if times)
    rest, lines = without_lines(square_free(rest), sides)
    return LinesOfPatch(patch, sides, edges, lines, False), ZeroCurve(rest)


def _single(components: Iterable[ZeroComponent]) -> tuple[list[_Zero], list[Box]]:
    """The single points of curves of zeros by their exact parameters; boxes of those for which that takes too long."""
    points, undecided = list[_Zero](), list[Box]()
    for component in components:
        for piece in component.pieces:
            try:
                points.append(_Zero(place_of(piece).spot, ZeroKind.ISOLATED, None, piece.patch))
            except ReachError:
                undecided += [piece.sides.part(cell) for cell in piece.part.cells]
    return points, undecided


def _is_on(place: Place, parts: Sequence[SurfacePart]) -> bool:
    """Whether a point is on one of the patches or edges that consist of zeros."""
    return any(_is_in(place, part.sides) for part in parts if not part.along_curve)


def _is_in(place: Place, box: tuple[tuple[Parameter, Parameter], tuple[Parameter, Parameter]]) -> bool:
    return all(low <= x <= high for x, (low, high) in zip(place, box, strict=True))


def _each_once(found: Sequence[_Zero], f: TensorSpline) -> tuple[CommonZero, ...]:
    """The points in order, those at knots once."""
    inner, at_knots = list[list[_Zero]](), dict[Place, list[_Zero]]()
    for zero in found:
        if any(not isinstance(x, Root) and x in mesh.breaks for x, mesh in zip(zero.place, f.meshes, strict=True)):
            at_knots.setdefault(zero.place, []).append(zero)
        else:
            inner.append([zero])
    points = []
    for group in (*inner, *at_knots.values()):
        first, second = map(real, group[0].place)
        times = min((zero.multiplicity for zero in group if zero.multiplicity is not None), default=None)
        patches, kinds = tuple(zero.patch for zero in group), {zero.kind for zero in group}
        where, around = _where(group[0].place, f)
        kind = kinds.pop() if len(kinds) == 1 and len(patches) == around else ZeroKind.KNOT
        points.append(CommonZero(first, second, times, patches, kind, where))
    return tuple(sorted(points, key=lambda point: (point.first, point.second)))


def _where(place: Place, f: TensorSpline) -> tuple[ZeroPlace, int]:
    """Where a point is, and the number of patches that meet there."""
    ends = knots = 0
    for x, mesh in zip(place, f.meshes, strict=True):
        if not isinstance(x, Root):
            is_end = x in (mesh.breaks[0], mesh.breaks[-1])
            ends, knots = ends + is_end, knots + (not is_end and x in mesh.breaks)
    if ends:
        return (ZeroPlace.CORNER if ends == 2 else ZeroPlace.BORDER), 1 << knots
    return (ZeroPlace.KNOT if knots else ZeroPlace.INSIDE), 1 << knots
