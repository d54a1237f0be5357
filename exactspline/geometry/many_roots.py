"""The parameters at which κ or κ′ of many plane curves vanishes, through the certified filter: exact where they are
rational, and proved to be irrational otherwise.

The filter decides how many zeros there are, and on which segments. Only on these are the forms computed in integers, by
the same programs, rounded once, and evaluated in doubles with proved bounds around every zero; a form without zeros
modulo some small prime has no rational zero (`exactspline.polynomials.doubles`). Derivation: docs/certified-filter.md.
This module loads numpy.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from flint import fmpz_poly

from exactspline.geometry.many_curves import KINDS
from exactspline.geometry.many_splines import Jumps, Segments, components, of_few_segments, rounded, whole
from exactspline.geometry.plane_programs import plane_program
from exactspline.numbers.exact import mpq
from exactspline.numbers.immutable import fill
from exactspline.numbers.intervals import Interval
from exactspline.polynomials.bernstein import ONE
from exactspline.polynomials.doubles import Bounded, Flags, Isolated, narrowed, ordinates, without_rational_zero
from exactspline.polynomials.roundings import ROUNDING, UNDERFLOW
from exactspline.programs.program import Program
from exactspline.questions.answers import CurvePiece, Places
from exactspline.reals.real import Real
from exactspline.roots.root import Root, knot_root
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import Mesh
from exactspline.splines.nurbs import Nurbs


@dataclass
class OnSegment:
    """A form on one segment of a curve, in exact arithmetic."""

    degree: int
    polynomial: fmpz_poly
    ends: Interval

    @cached_property
    def roots(self) -> tuple[Root, ...]:
        """Its zeros."""
        return zeros(BSpline.from_forms(self.degree, Mesh(self.ends), (), [(self.polynomial, ONE)])).roots

    def irrational(self, number: int, low: float, high: float) -> LateRoot:
        """The irrational zero with this index, between two local parameters of the segment, from 0 to 1."""
        return LateRoot(self.ends.at(mpq(low)), self.ends.at(mpq(high)), self, number)


class LateRoot(Real):
    """An irrational zero strictly between two numbers, and what it is computed from to any number of digits: the
    segment and the index of the zero on it.
    """

    __slots__ = ("high", "low", "number", "on")
    low: mpq
    high: mpq
    on: OnSegment
    number: int

    def __init__(self, low: mpq, high: mpq, on: OnSegment, number: int) -> None:
        fill(self, low=low, high=high, on=on, number=number, _exact=False, _isolating=None, _minimal=None)

    def __reduce__(self) -> tuple[object, ...]:
        return LateRoot, (self.low, self.high, self.on, self.number)

    @property
    def root(self) -> Root:
        """The zero in exact arithmetic."""
        return self.on.roots[self.number]

    def _enclosed(self, digits: int) -> Interval:
        return self.root.refine(digits)

    def _against_number(self, t: mpq) -> int:
        return self.root._against_number(t)

    def _annihilator(self) -> fmpz_poly:
        return self.root._annihilator()


class Point(NamedTuple):
    """An inflection or an extremum: its kind (the value of a `FeatureKind`) and its parameter."""

    kind: str
    place: Root | LateRoot

    @property
    def order(self) -> tuple[mpq, mpq]:
        """The key by which points are sorted: a knot comes before what follows it."""
        return self.place.low, self.place.high


class Settled(NamedTuple):
    """The zeros of κ and of κ′ of a curve for which everything is certified, in the order of the parameter, and its
    straight pieces. It has no other zeros of κ and κ′, no singular points and no arcs of circles.
    """

    curvature: Places[Point]
    critical: Places[Point]
    straight: tuple[CurvePiece, ...]


def settled(curves: Sequence[Nurbs]) -> Iterator[tuple[list[int], list[Settled | None]]]:
    """What is certified for plane curves, group by group: their indices, and for each its points, or None where exact
    arithmetic must decide.

    >>> from exactspline import example
    >>> [(numbers, [found])] = settled([example("six_segment_cubic")])
    >>> [(point.kind, round(float(point.place.low), 8)) for point in found.curvature]
    [('inflection', 2.80476011), ('inflection', 3.27088178)]
    """
    groups: dict[tuple[int, bool], list[int]] = {}
    for i, curve in enumerate(curves):
        groups.setdefault((curve.degree, curve.polynomial), []).append(i)
    for members in groups.values():
        for part in of_few_segments(curves, members):
            yield part, _settled([curves[i] for i in part])


def _settled(curves: Sequence[Nurbs]) -> list[Settled | None]:
    """The same for curves of one degree, all polynomial or all rational."""
    segments = Segments(curves)
    done, undecided = segments.filtered(narrow=False)
    if done is None:
        return [None] * len(curves)
    at_knots = segments.jumps(done, undecided)
    points: list[tuple[list[Point], list[Point]] | None] = [None if left else ([], []) for left in undecided.tolist()]
    program = plane_program(curves[0].degree, not curves[0].polynomial)
    for which, form in enumerate((done.curvature, done.critical)):
        for i, point in (
            *_inside(segments, form.zeros, which, program, undecided),
            *_at_knots(segments, at_knots[which]),
        ):
            if (own := points[i]) is not None:
                own[which].append(point)
    return [None if own is None else _known(*own, segments.straight.get(i, ())) for i, own in enumerate(points)]


def _known(curvature: list[Point], critical: list[Point], straight: tuple[CurvePiece, ...]) -> Settled:
    """The points of a curve in order, and its straight pieces."""
    first, second = (tuple(sorted(points, key=lambda point: point.order)) for points in (curvature, critical))
    return Settled(Places(first, straight), Places(second, straight), straight)


def _inside(
    segments: Segments, isolated: Isolated, which: int, program: Program, undecided: Flags
) -> Iterator[tuple[int, Point]]:
    """The zeros of a form inside segments of decided curves, each with the index of its curve."""
    isolated = isolated.where(~undecided[segments.owner[isolated.row]])
    if not len(isolated.row):
        return
    rows, first, place = np.unique(isolated.row, return_index=True, return_inverse=True)
    owner = segments.owner[rows].tolist()
    where = [(segments.curves[i], r - segments.first[i]) for r, i in zip(rows.tolist(), owner, strict=True)]
    degree, forms = program.terms[which].degree, _exactly(program, which, where)
    on = [
        OnSegment(degree, c, Interval(*curve.breakpoints[k : k + 2]))
        for c, (curve, k) in zip(forms, where, strict=True)
    ]
    numbers = [whole(c, degree) for c in forms]
    irrational = without_rational_zero(numbers)
    near = narrowed(_in_doubles(numbers), isolated._replace(row=place))
    kinds = np.where(isolated.before > 0, *KINDS[1:]) if which else np.full(len(place), KINDS[0])
    columns = (place, np.arange(len(place)) - first[place], irrational[place], near.low, near.high, kinds)
    for j, number, proved, a, b, kind in zip(*(column.tolist() for column in columns), strict=True):
        one = on[j]
        yield owner[j], Point(kind, one.irrational(number, a, b) if proved else one.roots[number])


def _exactly(program: Program, which: int, where: Sequence[tuple[Nurbs, int]]) -> list[fmpz_poly]:
    """The integers of an output of a program on segments of curves, over some denominators."""
    splines = [components(curve) for curve, _ in where]
    operands = [
        [own[k]._polynomials[j] for own, (_, j) in zip(splines, where, strict=True)] for k in range(len(splines[0]))
    ]
    below = [own[0].denominators[j] for own, (_, j) in zip(splines, where, strict=True)]
    return [fmpz_poly(row[which]) for row in program.run(operands, [below], [(ONE, ONE)] * len(where))]


def _in_doubles(forms: Sequence[list[int]]) -> Bounded:
    """Forms in doubles, each divided by a power of two so that no coefficient is larger than 1, and rounded once."""
    values = np.array([rounded(form, 1, max(map(abs, form)).bit_length()) for form in forms])
    return ordinates(values, ROUNDING * np.abs(values) + UNDERFLOW)


def _at_knots(segments: Segments, jumps: Jumps) -> Iterator[tuple[int, Point]]:
    """The changes of sign by a jump, each with the index of its curve."""
    for i, k, kind in zip(jumps.curve.tolist(), jumps.knot.tolist(), jumps.kind.tolist(), strict=True):
        yield i, Point(kind, knot_root(segments.curves[i].breakpoints[k]))
