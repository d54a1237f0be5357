"""Lines of solutions at an irrational parameter: control points in the field of the root."""

from __future__ import annotations

from dataclasses import dataclass, replace

from flint import arb, ctx, fmpz_poly

from exactspline.errors import ReachError, ShapeError
from exactspline.geometry.bisectors.flats import Flat
from exactspline.geometry.bisectors.polynomials import vanish_together
from exactspline.numbers.exact import Number, mpq, rational, to_fmpq
from exactspline.numbers.intervals import Interval
from exactspline.one_line import OneLine, short_text
from exactspline.polynomials.elimination import resultant
from exactspline.polynomials.two_parameters import S, T, lifted, rows_of
from exactspline.roots.of_polynomials import Parameter, ball, exactly, roots_in
from exactspline.roots.root import Root
from exactspline.roots.values import segment_polynomials
from exactspline.splines.bspline import BSpline

#: A coordinate: the coefficients of 1, r, r², … for a root r.
Coordinate = tuple[BSpline, ...]


@dataclass(frozen=True, repr=False)
class RootLines(OneLine):
    """Lines as a ruled surface over a segment of one parameter (``of``: 0 is s, 1 is t) at an irrational value r of the
    other one.

    Every coordinate of the ``directrix`` (homogeneous: wx, wy, wz, w) and of the ``generator`` is a tuple of splines,
    the coefficients of 1, r, r², … below the degree of r: exact numbers of the field of r. ``poles`` are the parameters
    whose line is at infinity, decided exactly; None where that is out of reach.
    """

    of: int
    other: Root
    interval: Interval
    directrix: tuple[Coordinate, ...]
    generator: tuple[Coordinate, ...]
    poles: tuple[Parameter, ...] | None

    @classmethod
    def over(
        cls, other: Root, interval: Interval, directrix: tuple[Coordinate, ...], generator: tuple[Coordinate, ...]
    ) -> RootLines:
        """The lines over the second curve at an irrational parameter of the first, with their poles."""
        return cls(1, other, interval, directrix, generator, _poles(directrix[-1], other, interval))

    @property
    def degree(self) -> int:
        """The degree of the surface in its parameter."""
        return max(self.directrix[0][0].degree, self.generator[0][0].degree)

    def line(self, parameter: Number, digits: int = 20) -> Flat[arb]:
        """A point and the direction of a line, in balls that are not finite where it is at infinity; raises
        `ShapeError` outside the segment.
        """
        u = rational(parameter)
        if not self.interval[0] <= u <= self.interval[1]:
            raise ShapeError(f"{short_text(u)} is outside this piece", remedy="stay inside the segment")
        with ctx.workprec(8 * digits + 128):
            root = ball(self.other, digits + 10)
            *top, w = (_value(x, u, root) for x in self.directrix)
            return Flat(tuple(x / w for x in top), tuple(_value(x, u, root) for x in self.generator))

    def transposed(self) -> RootLines:
        """The lines of the exchanged curves."""
        return replace(self, of=1 - self.of)


def _poles(weight: Coordinate, r: Root, interval: Interval) -> tuple[Parameter, ...] | None:
    """The zeros of the weight of a directrix, a polynomial in r and the parameter."""
    p = lifted(fmpz_poly([]), 0)
    for k, part in enumerate(segment_polynomials(weight, 0)):
        p += lifted(part, 1) * S**k
    try:
        # among the zeros of the product of the weights at all conjugates of r
        minimal = [fmpz_poly([x]) for x in r.minimal_polynomial()]
        candidates = [exactly(t) for t in roots_in(resultant(minimal, rows_of(p.compose(T, S))), *interval)]
        vanishing = [vanish_together([p], r, t) for t in candidates]
    except ReachError:
        return None
    return None if None in vanishing else tuple(t for t, is_zero in zip(candidates, vanishing, strict=True) if is_zero)


def _value(x: Coordinate, u: mpq, root: arb) -> arb:
    total = arb(0)
    for f in reversed(x):
        total = total * root + arb(to_fmpq(f(u)))
    return total
