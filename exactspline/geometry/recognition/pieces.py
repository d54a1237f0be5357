"""The pieces of a curve that are lines, circles or conics, exactly or within a proved distance: the shape of a run of
segments is guessed from some of its points, and then proved.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import chain, count, pairwise
from operator import mul

from exactspline.geometry.recognition.candidates import candidates, farthest, planes
from exactspline.geometry.recognition.shapes import (
    Conic,
    CurveShape,
    Homogeneous,
    Plane,
    Point,
    Shape,
    ShapeKind,
    cross_product,
    upper_square_root,
)
from exactspline.numbers.exact import Number, decimal_unit, mpq, sign
from exactspline.numbers.intervals import Interval
from exactspline.numbers.once import cached_property
from exactspline.questions.answers import Described
from exactspline.reals.real import Real, real
from exactspline.roots.answers import CurvePiece
from exactspline.roots.values import sign_at
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.precision import distance
from exactspline.splines.type_checks import in_plane_or_space

# ---- proof


#: The factors, tried first, by which the proved bound may exceed the distance found at points.
FACTORS = tuple(mpq(n, 16) for n in (17, 20, 24, 32))


def proved_distance(
    shape: Shape, of: Homogeneous, found: mpq, limit: mpq, never_negative: Callable[..., bool]
) -> mpq | None:
    """A proved distance from a shape, at most a limit: 0 if all points are on the shape. Otherwise bounds slightly
    above the distance `found` at points are tried, then larger ones, because other points may be farther away. None if
    no distance is proved. `never_negative` decides whether a function on the curve or the surface is nowhere negative.
    """
    if shape.holds(of):
        return mpq(0)
    for within in (rounded_up(found * factor) for factor in chain(FACTORS, (mpq(2) ** k for k in count(2)))):
        if not within or within > limit or (shape.most is not None and within > shape.most):
            return None
        if all(never_negative(f) for f in shape.margins(of, within)):
            return within
    return None


def _never_negative(f: BSpline) -> bool:
    """Whether a function of one parameter is nowhere negative.

    >>> t = BSpline.identity(-1, 1)
    >>> _never_negative(t * t), _never_negative(t)
    (True, False)
    """
    return signs(f) <= {0, 1}


def signs(f: BSpline) -> set[int]:
    """The signs that a function has on whole intervals: 0 where it vanishes on a segment.

    >>> t = BSpline.identity(-1, 1)
    >>> signs(t * t + 1), signs(t * t), signs(-t * t), sorted(signs(t)), signs(t - t)
    ({1}, {1}, {-1}, [-1, 1], {0})
    """
    found, hard = set[int](), set[Interval]()
    for ends, points in zip(pairwise(f.breakpoints), f.bezier_points, strict=True):
        of_points = {sign(x) for x in points}
        if len(of_points) > 1:
            of_points -= {0}
        if len(of_points) == 1 or len({sign(points[0]), sign(points[-1])} - {0}) == 2:
            found |= of_points
        else:
            hard.add(Interval(*ends))
    if hard:
        roots = [root for root in zeros(f) if root.segment in hard]
        found |= {side for root in roots for side in root.signs if side}
        found |= {sign(f(segment.middle)) for segment in hard - {root.segment for root in roots}}
    return found


def rounded_up(x: mpq) -> mpq:
    """The least decimal with four digits that is not below a positive number.

    >>> rounded_up(mpq(1, 3)), rounded_up(mpq(0))
    (mpq(1667,5000), mpq(0,1))
    """
    if not x:
        return x
    unit = decimal_unit(x) / 1000
    return -(-x // unit) * unit


#: A segment is divided into this many parts, at whose ends points are taken to guess a shape.
PARTS = 6
#: The default distance, in units of the size of the curve.
SMALL = mpq(1, 10**9)
#: Shapes of planar pieces of a space curve, each proposed for a run of points.
Guess = Callable[[Sequence[Point], mpq], Iterator[Shape]]


@dataclass(frozen=True, repr=False)
class RecognizedPiece(Described):
    """A piece of a curve, and the shape on which it lies exactly or nearly.

    Every point of the piece is at most `within` away from the shape. Unless the shape is a plane, every point of the
    arc between the ends is also within this distance of the piece, and the curve runs along the arc once, without
    turning back. `within` is 0 if the piece lies on the shape exactly. `whole`: the piece runs around the whole circle
    or ellipse.
    """

    piece: CurvePiece
    shape: Shape
    within: mpq
    whole: bool

    @property
    def kind(self) -> ShapeKind:  # type: ignore[override]  # by its shape
        """The kind of the shape."""
        return self.shape.kind

    @property
    def values(self) -> dict[str, tuple[Real, ...]]:
        """The distance, and the numbers of the shape."""
        return {"within": (real(self.within),), **self.shape.numbers}

    @property
    def facts(self) -> dict[str, bool]:
        """Whether the piece runs around the whole of a closed shape."""
        return {"whole": self.whole}

    @property
    def exact(self) -> bool:
        """Whether the piece lies on the shape exactly."""
        return not self.within


class _Run:
    """Consecutive segments of a curve without a gap between them, as a curve of their own, and points of it."""

    def __init__(self, curve: Nurbs, first: int, last: int, points: Sequence[Sequence[Point]]) -> None:
        self.first, self.last, self._of = first, last, curve
        self.points = [point for segment in points[first : last + 1] for point in segment]

    @cached_property
    def curve(self) -> Nurbs:
        """The segments alone."""
        breaks = self._of.breakpoints
        if self.last - self.first == len(breaks) - 2:
            return self._of
        return self._of.restrict(breaks[self.first], breaks[self.last + 1])

    @property
    def closed(self) -> bool:
        """Whether the run ends at its start."""
        return self.points[0] == self.points[-1]


class _Remembered:
    """The items of an iterator, each computed once, when first needed."""

    def __init__(self, source: Iterator[Shape]) -> None:
        self._source, self._made = source, list[Shape]()

    def __iter__(self) -> Iterator[Shape]:
        yield from self._made
        for shape in self._source:
            self._made.append(shape)
            yield shape


def recognized(curve: Nurbs, epsilon: Number | None = None) -> tuple[RecognizedPiece, ...]:
    """The pieces of a curve that run along a line, a circle or a conic, within the distance epsilon; without it, within
    10⁻⁹ of the curve's size. Pieces begin and end at knots; of several shapes that fit, the simplest is reported. A
    single segment of degree 2, which is always a conic, is not reported unless it is the whole curve. For a space
    curve, other pieces that are near a plane but not in a plane are reported, too.

    >>> from exactspline import Nurbs, example
    >>> (found,) = recognized(example("circle"))
    >>> print(found.shape, found.exact, found.whole)
    circle: centre (0, 0), radius 1 True True
    >>> rounded = Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], [1, "0.7071", 1])
    >>> (found,) = recognized(rounded, "1e-4")
    >>> found.shape.kind.value, found.exact, found.within < mpq(1, 10**5)
    ('circle', False, True)
    >>> recognized(rounded, "1e-9")[0].shape.kind.value
    'ellipse'

    Raises `ShapeError` for a curve that is neither in the plane nor in space, and for an epsilon that is not positive.
    Theory: docs/rounded-input.md.
    """
    given = in_plane_or_space(curve, "shapes")
    points = _points(given)
    limit = longest_side(points) * SMALL if epsilon is None else distance(epsilon, given)
    found = list(_pieces(given, points, limit, candidates))
    if given.dimension == 3:
        spans = [(each.piece.start, each.piece.end) for each in found]
        flat = [each for each in _pieces(given, points, limit, planes) if not each.exact]
        found += [x for x in flat if not any(a <= x.piece.start and x.piece.end <= b for a, b in spans)]
    return tuple(sorted(found, key=lambda each: each.piece.start))


def near(curve: Nurbs, piece: CurvePiece, shape: Shape, limit: mpq) -> RecognizedPiece | None:
    """A piece of a curve near a given shape, with a proved distance of at most a limit; None if no such distance is
    proved.

    >>> from exactspline import example
    >>> from exactspline.geometry.recognition.shapes import Circle
    >>> s = example("cubic_s")
    >>> print(near(s, CurvePiece((s.domain,)), Circle((mpq(0), mpq(0)), mpq(1)), mpq(1, 10**9)))
    None
    """
    alone = curve.restrict(piece.start, piece.end)
    points = _points(alone)
    return _proved(_Run(alone, 0, len(points) - 1, points), shape, limit)


def small_distance(curve: Nurbs) -> mpq:
    """The default distance within which shapes are sought: 10⁻⁹ of the size of a curve.

    >>> from exactspline import example
    >>> small_distance(example("circle"))
    mpq(1,500000000)
    """
    return longest_side(_points(curve)) * SMALL


def _points(curve: Nurbs) -> list[list[Point]]:
    """Points of each segment, from its start to its end."""
    n, found = curve.degree, []
    basis = [[(PARTS - i) ** (n - k) * i**k for k in range(n + 1)] for i in range(PARTS + 1)]
    splines = list(curve.p) if curve.polynomial else [*curve.p, curve.w]
    for i in range(curve.segments):
        rows = [([*map(int, f.numerators[i].coeffs())], int(f.denominators[i])) for f in splines]
        values = [[mpq(sum(map(mul, c, own)), below) for own in basis] for c, below in rows]
        below = [mpq(PARTS**n)] * (PARTS + 1) if curve.polynomial else values.pop()
        found.append([tuple([x / w for x in point]) for *point, w in zip(*values, below, strict=True)])
    return found


def longest_side(points: Sequence[Sequence[Point]]) -> mpq:
    """The longest side of the box around the points."""
    columns = list(zip(*[point for segment in points for point in segment], strict=True))
    sides: list[mpq] = [max(column) - min(column) for column in columns]
    return max(sides)


def _pieces(curve: Nurbs, points: Sequence[Sequence[Point]], limit: mpq, guess: Guess) -> Iterator[RecognizedPiece]:
    """The longest pieces from the start of the curve on."""
    i, end, n = 0, -1, len(points)
    while i < n:
        if i > end:  # of each connected part of the curve once
            end = next((k for k in range(i, n - 1) if points[k][-1] != points[k + 1][0]), n - 1)
        found = _longest(curve, points, i, end, limit, guess)
        if found is None:
            i += 1
            continue
        last, piece = found
        if n == 1 or last > i or curve.degree > 2 or not isinstance(piece.shape, Conic | Plane):
            yield piece
        i = last + 1


def _longest(
    curve: Nurbs, points: Sequence[Sequence[Point]], first: int, end: int, limit: mpq, guess: Guess
) -> tuple[int, RecognizedPiece] | None:
    """The longest run from a segment on that is proved to be near a shape, with its last segment."""

    proposed = cache(lambda last: _Remembered(guess(_Run(curve, first, last, points).points, limit)))
    last = _last_that(lambda last: any(True for _ in proposed(last)), first, end)
    while last >= first:
        run = _Run(curve, first, last, points)
        for shape in proposed(last):
            if (found := _proved(run, shape, limit)) is not None:
                return last, found
        last = first + (last - first) // 2 if last > first else first - 1
    return None


def _last_that(holds: Callable[[int], bool], first: int, end: int) -> int:
    """The last number up to which a property seems to hold, found by doubling steps; first − 1 if there is none."""
    good, step = first - 1, 1
    while step:
        tried = min(good + step, end)
        if tried > good and holds(tried):
            good, step = tried, step * 2
        else:
            step //= 2
    return good


def _proved(run: _Run, shape: Shape, limit: mpq) -> RecognizedPiece | None:
    """The run near this shape, with a proved distance, or None."""
    if isinstance(shape, CurveShape) and not _runs_once(run, shape):
        return None
    within = proved_distance(shape, run.curve, upper_square_root(farthest(shape, run.points)), limit, _never_negative)
    if within is None:
        return None
    piece = CurvePiece((run.curve.domain,))
    return RecognizedPiece(piece, shape, within, isinstance(shape, CurveShape) and shape.closes and run.closed)


def _runs_once(run: _Run, shape: CurveShape) -> bool:
    """Whether the curve runs along the shape without turning back, and over no part of the shape twice."""
    if signs(shape.advance(run.curve)) not in ({1}, {-1}):
        return False
    return not shape.closes or not passes_its_start(run.curve, shape)


def passes_its_start(curve: Nurbs, shape: CurveShape) -> bool:
    """Whether a curve around a centre meets the ray from the centre to its start again, before its end."""
    a, b = curve.domain
    centre = shape.centre  # type: ignore[attr-defined]  # a shape that closes has a centre
    start = [x - c for x, c in zip(curve(a), centre, strict=True)]
    ahead = _linear(curve, centre, start)
    across = _across(curve, centre, start, shape)
    side = sign(curve.w(a))
    return any(root > a and root < b and sign_at(ahead, root) == side for root in zeros(across))


def _linear(curve: Nurbs, centre: Point, direction: Sequence[mpq]) -> BSpline:
    """w times the scalar product of a vector with the vector from a point to the curve."""
    terms = [(x - curve.w * c) * u for x, c, u in zip(curve.p, centre, direction, strict=True)]
    return sum(terms[1:], start=terms[0])


def _across(curve: Nurbs, centre: Point, start: Sequence[mpq], shape: CurveShape) -> BSpline:
    """A function that vanishes where the curve, seen from a centre, is in the direction of its start or opposite."""
    turned = cross_product(shape.normal, start) if shape.normal else [-start[1], start[0]]
    return _linear(curve, centre, turned)
