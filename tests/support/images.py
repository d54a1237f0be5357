"""Where parameters and points go when a curve, a pair of curves or a surface is written otherwise."""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

from gmpy2 import mpq

from exactspline import Nurbs, NurbsSurface, Real
from exactspline.errors import OpenError, ReachError
from exactspline.geometry.analysis.pairs import CurvePair
from exactspline.geometry.analysis.surface_pairs import SurfacePair
from exactspline.geometry.bisectors.two_curves import CurveBisector
from exactspline.geometry.pairs.regions import Region
from exactspline.splines.surface import Along

#: Digits of numbers that are not rational; two of them agree where their enclosures overlap.
DIGITS = 30
#: Where that takes too much work.
FEWER = 6


class Known(NamedTuple):
    """A number: its value where it is rational, and both ends of an interval around it; whether it is out of reach to
    decide whether it is rational.
    """

    exact: mpq | None
    low: mpq
    high: mpq
    open: bool = False

    def agrees(self, other):
        """Equal where both are rational, and near each other where neither is, or where that is not decided."""
        if (self.exact is not None or other.exact is not None) and not (self.open or other.open):
            return self.exact == other.exact
        return self.low <= other.high and other.low <= self.high

    def mapped(self, function):
        """The image under a monotone rational function."""
        ends = function(self.low), function(self.high)
        return Known(None if self.exact is None else function(self.exact), min(ends), max(ends), self.open)

    def times(self, factor):
        """A rational multiple."""
        return self.mapped(lambda x: x * factor)

    def __str__(self):
        return f"{float(self.low):.17g}" if self.exact is None else str(self.exact)


def in_reach(x):
    """An interval around a number, with fewer digits where more take too much work, as for some arc lengths."""
    try:
        return x.enclosure(DIGITS)
    except OpenError:
        return x.enclosure(FEWER)


def known(x):
    """A real number, a rational one or an integer."""
    if not isinstance(x, Real):
        return Known(mpq(x), mpq(x), mpq(x))
    try:
        exact = x.exact
    except (ReachError, OpenError):
        return Known(None, *in_reach(x), open=True)
    return Known(exact, *(x.enclosure(DIGITS) if exact is None else (exact, exact)))


def total(numbers):
    """The sum of numbers, rational where all are; intervals are added, and the sum may be rational."""
    exact = [x.exact for x in numbers]
    value = None if None in exact else sum(exact, mpq(0))
    low, high = (sum((x[k] for x in numbers), mpq(0)) for k in (1, 2))
    return Known(value, low, high, open=any(x.open for x in numbers) or sum(x.exact is None for x in numbers) > 1)


@dataclass(frozen=True)
class Motion:
    """A similarity: an orthogonal matrix times `scale`, then a translation."""

    matrix: tuple[tuple[mpq, ...], ...] = ()
    shift: tuple[mpq, ...] = ()
    scale: mpq | int = 1
    #: Whether left and right change places.
    turns: bool = False

    def of_vector(self, vector):
        """The image of a vector."""
        return [sum((a * x for a, x in zip(row, vector, strict=True)), mpq(0)) for row in self.rows(len(vector))]

    def rows(self, dimension):
        """Its matrix, also where it is the identity."""
        return self.matrix or [[mpq(i == j) for j in range(dimension)] for i in range(dimension)]

    def __call__(self, point):
        moved = self.of_vector(point)
        return tuple(x + d for x, d in zip(moved, self.shift or [0] * len(moved), strict=True))

    def of_known(self, vector, *, point=True):
        """The image of a point or vector whose coordinates may be irrational."""
        rows = self.rows(len(vector))
        moved = [total([x.times(a) for a, x in zip(row, vector, strict=True) if a]) for row in rows]
        shift = self.shift if point and self.shift else [mpq(0)] * len(moved)
        return [x.mapped(lambda y, d=d: y + d) for x, d in zip(moved, shift, strict=True)]

    def then(self, other):
        """This one, then another."""
        if not other.matrix:
            return self
        dimension = len(other.matrix)
        columns = [other.of_vector(column) for column in zip(*self.rows(dimension), strict=True)]
        shift = other(self.shift or [mpq(0)] * dimension)
        matrix = tuple(zip(*columns, strict=True))
        return Motion(matrix, shift, self.scale * other.scale, self.turns != other.turns)


class Way(NamedTuple):
    """Where a parameter goes, and whether it runs the other way then; the first two derivatives of the new one by the
    old one. `before` is where its left side goes if that is elsewhere, as at a seam.
    """

    to: Callable[[mpq], mpq] = lambda t: t
    backwards: bool = False
    slopes: Callable[[mpq], tuple[mpq, mpq]] = lambda t: (mpq(1), mpq(0))
    before: Callable[[mpq], mpq] | None = None

    def left(self, t):
        """Where what is left of a parameter goes."""
        return (self.before or self.to)(t)

    def then(self, other):
        """This one, then another."""
        right, left = (other.left, other.to) if self.backwards else (other.to, other.left)
        backwards = self.backwards != other.backwards

        def slopes(t):
            (first, second), (outer, bend) = self.slopes(t), other.slopes(self.to(t))
            return outer * first, bend * first**2 + outer * second

        return Way(lambda t: right(self.to(t)), backwards, slopes, lambda t: left(self.left(t)))


THIRD = mpq(1, 3)
#: The plane into other planes of space. As seen from the tip of the normal whose first nonzero coordinate is positive,
#: left and right change places in the last one.
TILTED = (
    Motion(((THIRD, -2 * THIRD), (2 * THIRD, 2 * THIRD), (-2 * THIRD, THIRD)), (mpq(1), mpq(0), mpq(5))),
    Motion(((mpq(0), mpq(1)), (mpq(0), mpq(0)), (mpq(1), mpq(0))), (mpq(0), mpq(7), mpq(0))),
    Motion(((2 * THIRD, -2 * THIRD), (THIRD, 2 * THIRD), (2 * THIRD, THIRD)), (mpq(0), mpq(7), mpq(-1, 3)), turns=True),
)


@dataclass(frozen=True)
class Image:
    """Where each parameter goes; whether the two parameters, or the two curves, are exchanged; where points go."""

    ways: tuple[Way, ...] = (Way(), Way())
    exchanged: bool = False
    motion: Motion = Motion()

    def then(self, other):
        """This one, then another."""
        ways = other.ways[::-1] if self.exchanged else other.ways
        joined = tuple(own.then(way) for own, way in zip(self.ways, ways, strict=True))
        return Image(joined, self.exchanged != other.exchanged, self.motion.then(other.motion))

    @property
    def turns(self):
        """Whether a plane curve that turned left turns right."""
        return self.ways[0].backwards != self.motion.turns

    @property
    def turns_over(self):
        """Whether a map of the plane changes its orientation."""
        flips = (self.ways[0].backwards, self.ways[1].backwards, self.exchanged, self.motion.turns)
        return sum(flips) % 2 == 1


@dataclass(frozen=True)
class BothImages:
    """Where the parameters of each of two surfaces go, whether the surfaces are exchanged, and where points go."""

    images: tuple[Image, Image] = (Image(), Image())
    exchanged: bool = False
    motion: Motion = Motion()

    def then(self, other):
        """This one, then another."""
        images = other.images[::-1] if self.exchanged else other.images
        joined = tuple(own.then(image) for own, image in zip(self.images, images, strict=True))
        return BothImages(joined, self.exchanged != other.exchanged, self.motion.then(other.motion))

    turns = turns_over = False


class Ring(NamedTuple):
    """The domain of one parameter, and its knots; whether its ends are one point."""

    low: mpq
    high: mpq
    closed: bool
    breaks: tuple[mpq, ...]

    def once(self, x):
        """A parameter by the one of its names that is told."""
        return known(self.low) if self.closed and x.exact == self.high else x

    def cut(self, low, high):
        """The parts of an interval between knots."""
        ends = [low, *[t for t in self.breaks if low < t < high], high]
        return list(pairwise(ends))


def rings(thing):
    """The rings of the parameters of a curve, of two curves, of a surface."""
    if isinstance(thing, Nurbs):
        return (Ring(*thing.domain, thing.closed, tuple(thing.breakpoints)),) * 2
    if isinstance(thing, CurvePair | CurveBisector | Region):
        return tuple(rings(curve)[0] for curve in thing.curves)
    if isinstance(thing, SurfacePair):
        return tuple(map(rings, thing.surfaces))
    assert isinstance(thing, NurbsSurface)
    return tuple(
        Ring(*thing.domain[along.direction], closed_in(thing, along), breaks_of(thing, along)) for along in Along
    )


def breaks_of(surface, along):
    """The different knots of a surface in one of its parameters, inside the domain and at its ends."""
    low, high = surface.domain[along.direction]
    return tuple(sorted({t for t in surface.knots[along.direction] if low <= t <= high}))


def closed_in(surface, along):
    """Whether the two ends of a surface are one curve, in one of its parameters."""
    other = Along.V if along is Along.U else Along.U
    first, last = (surface.isocurve(other, t) for t in surface.domain[along.direction])
    return first == last
