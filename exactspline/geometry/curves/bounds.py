"""Bounds of a function on a whole curve, by the zeros of forms: the largest speed, |κ|, |dκ/ds| and |τ|, where they are
attained, and where |κ| is above a number.

On each segment such a function, or its square, is a quotient of splines in lowest terms, so that a singular point at
which the function has a limit needs no special treatment. At a knot both limits count. Where a denominator vanishes,
the function is not bounded.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from exactspline.errors import DomainError, ShapeError
from exactspline.formulas.lifted import (
    binormal_lifted_squared,
    critical_curvature_lifted,
    curvature_squared_lifted,
    space_critical_curvature_lifted,
    space_curvature_squared_lifted,
    tangent_lifted_squared,
    torsion_lifted,
)
from exactspline.geometry.curves.facts import Facts
from exactspline.geometry.curves.values import refuse_singular, segment_at
from exactspline.geometry.derived.derive import part
from exactspline.language.arguments import Curve
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector
from exactspline.language.wronskians import wronskians
from exactspline.numbers.exact import mpq, text
from exactspline.numbers.intervals import Side
from exactspline.questions.answers import NamedNumbers
from exactspline.reals.real import Extreme, RationalNumber, Real, between, real, square_root
from exactspline.roots.values import exact_place, sign_at, signed_root, value_at
from exactspline.roots.zero_set import ZeroSet, zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.lowest_terms import in_lowest_terms
from exactspline.splines.nurbs import Nurbs


def slope(curve: Nurbs, axis: int) -> BSpline:
    """A spline with the sign of the derivative of a coordinate."""
    return wronskians(curve.w, Vector(curve.p[axis]))[0]


def slope_zeros(curve: Nurbs, axis: int | str) -> ZeroSet:
    """The zeros of the derivative of a coordinate; raises `ShapeError` for a coordinate that the curve does not
    have.
    """
    return zeros(slope(curve, _number_of(curve, axis)), periodic=curve.closed)


def _number_of(curve: Nurbs, axis: int | mpq | str) -> int:
    number = next((i for i in range(curve.dimension) if str(i) == str(axis)), None)
    if number is None:
        raise ShapeError(f"the coordinate {axis} of a curve in R{curve.dimension}", remedy="0 is x, 1 is y, 2 is z")
    return number


def value_zeros(curve: Nurbs, axis: int | mpq, value: mpq) -> ZeroSet:
    """The parameters at which a coordinate has a given value; raises `ShapeError` for a coordinate that the curve does
    not have.
    """
    return zeros(curve.p[_number_of(curve, axis)] - curve.w.scaled(value), periodic=curve.closed)


def coordinate_range(curve: Nurbs, axis: int) -> tuple[Real, Real]:
    """The smallest and the largest value of a coordinate, known exactly.

    >>> from exactspline import example
    >>> coordinate_range(example("circle"), 0)
    (<Real -1>, <Real 1>)
    """
    values = [Real(curve(t, side)[axis]) for t in curve.breakpoints for side in ("left", "right")]
    values += [
        value_at(curve.p[axis], curve.w, exact_place(root)) for root in slope_zeros(curve, axis) if not root.at_knot
    ]
    return _extreme(values, -1), _extreme(values, 1)


def _extreme(values: Sequence[Real], side: int) -> Real:
    """The largest (side 1) or smallest (−1) of several numbers, without deciding which of them is attained."""
    choose = max if side > 0 else min
    best = choose(x for x in values if isinstance(x, RationalNumber))
    rest = [x for x in values if not isinstance(x, RationalNumber) and (x > best if side > 0 else x < best)]
    return Extreme(side, rest) if len(rest) > 1 else rest[0] if rest else best


Place = mpq | Real


@dataclass(frozen=True)
class _Size:
    """A function on curves, whose absolute value is bounded: its name, and the computation of the function, or of its
    square, on a segment.
    """

    name: str
    of: Callable[[Curve[BSpline]], Any]
    squared: bool = True


def _speed_squared(c: Curve[BSpline]) -> Any:
    return tangent_lifted_squared(c) / c.w**4


def _derivative_in_plane(c: Curve[BSpline]) -> Any:
    """``dκ/ds = J w⁴/(2 A³)``: ``(κ²)′/κ²`` is J/(F A w), κ is F w³/√A³ and ‖γ′‖ is √A/w², with the Wronskian F of P
    and ``A = ‖D1‖²``.
    """
    return critical_curvature_lifted(c) * c.w**4 / (2 * tangent_lifted_squared(c) ** 3)


def _derivative_in_space(c: Curve[BSpline]) -> Any:
    """``(dκ/ds)² = J² w⁸/(4 A⁶ B)``: ``(κ²)′/κ²`` is J/(A B w), and κ² is B w⁶/A³; 0 on a straight segment."""
    speed, bending = tangent_lifted_squared(c), binormal_lifted_squared(c)
    if bending.is_zero:
        return bending / speed
    return space_critical_curvature_lifted(c) ** 2 * c.w**8 / (4 * speed**6 * bending)


#: The functions that are bounded, by the dimension of the curve.
SPEED = dict.fromkeys((2, 3), _Size("speed", _speed_squared))
CURVATURE = {2: _Size("curvature", curvature_squared_lifted), 3: _Size("curvature", space_curvature_squared_lifted)}
CURVATURE_DERIVATIVE = {
    2: _Size("curvature derivative", _derivative_in_plane, squared=False),
    3: _Size("curvature derivative", _derivative_in_space),
}
TORSION = {3: _Size("torsion", torsion_lifted, squared=False)}


def _of(sizes: Mapping[int, _Size], facts: Facts) -> _Size:
    facts.check_dimension()
    if facts.curve.dimension not in sizes:
        raise ShapeError("the torsion of a curve in R2", remedy="this needs a curve in space")
    return sizes[facts.curve.dimension]


class Form:
    """A function or its square on a segment: a quotient in lowest terms with a positive denominator, and a form with
    the sign of its derivative.
    """

    def __init__(self, value: Rational[BSpline]) -> None:
        self.top, self.bottom = value.scalar, value.denominator
        self.slope = self.top.d(1) * self.bottom - self.top * self.bottom.d(1)

    def at(self, place: Place) -> Real:
        """The value at a parameter."""
        return value_at(self.top, self.bottom, place)


def _extremes_of(form: Form) -> list[Place]:
    """The parameters of a segment at which a form may be largest: the ends, and the critical points between."""
    a, b = form.top.domain
    return [a] if form.slope.is_zero else [a, b, *_inside(form.slope)]


def _inside(form: BSpline) -> list[Place]:
    """The zeros of the form of a segment strictly inside the segment."""
    return [exact_place(root) for root in zeros(form) if not root.at_knot]


def _form_on(facts: Facts, size: _Size, i: int) -> Form | None:
    """The function on a segment; None where it is not defined there."""

    def form() -> Form | None:
        value = size.of(part(facts.curve, *facts.breaks[i : i + 2]))
        return None if value.denominator.is_zero else Form(in_lowest_terms(value))

    return facts.once(("form", size.name, i), form)


def largest(facts: Facts, sizes: Mapping[int, _Size]) -> tuple[NamedNumbers, ...]:
    """The maximum of |f|, with each parameter and each piece at which it is attained; or, if |f| is unbounded, the
    parameters of its poles. The result is empty if f is defined nowhere.

    >>> from exactspline import example
    >>> from exactspline.geometry.curves.facts import facts_of
    >>> largest(facts_of(example("circle")), CURVATURE)
    (<largest curvature on a piece: curvature 1, start 0, end 4>,)

    Raises `ShapeError` for a curve of a dimension in which f is not defined.
    """
    size = _of(sizes, facts)
    forms = {i: form for i in range(len(facts.breaks) - 1) if (form := _form_on(facts, size, i))}
    if poles := [(i, exact_place(root)) for i, form in forms.items() for root in zeros(form.bottom)]:
        return tuple(_at_points(facts, "unbounded near", poles, {}))
    found = [(i, t, form.at(t)) for i, form in forms.items() for t in _extremes_of(form)]
    values = [x if size.squared else abs(x) for *_, x in found]
    best = max(values, default=Real(0))
    hits = [(i, t) for (i, t, _), x in zip(found, values, strict=True) if x == best]
    what, value = f"largest {size.name}", {size.name: square_root(best) if size.squared else best}
    constant = {i for i, _ in hits if forms[i].slope.is_zero}
    holds = [i in constant for i in range(len(facts.breaks) - 1)]
    pieces = facts.pieces_where(holds, [facts.closed, *[True] * (len(holds) - 1)])
    ends = [_once(facts, t) for x in pieces for t in (x.start, x.end)]
    points = [(i, t) for i, t in hits if i not in constant and _once(facts, t) not in ends]
    on_pieces = [NamedNumbers(f"{what} on a piece", value | _ends(real(x.start), real(x.end))) for x in pieces]
    return (*_at_points(facts, what, points, value), *on_pieces)


def _ends(start: Real, end: Real) -> dict[str, Real]:
    return {"start": start, "end": end}


def _once(facts: Facts, t: Place) -> Place:
    """The parameter; at the seam of a closed curve the start of the domain."""
    return facts.breaks[0] if facts.closed and t == facts.breaks[-1] else t


def _at_points(
    facts: Facts, what: str, hits: list[tuple[int, Place]], values: dict[str, Real]
) -> Iterator[NamedNumbers]:
    """Each parameter once, in order; at a knot with its side, if the value is attained as the limit from one side
    only.
    """
    inside = [t for i, t in hits if t not in facts.breaks[i : i + 2]]
    sides: dict[Place, list[Side]] = {}
    for i, t in hits:
        if t in facts.breaks[i : i + 2]:
            sides.setdefault(_once(facts, t), []).append(Side.RIGHT if t == facts.breaks[i] else Side.LEFT)
    for t in sorted([*inside, *sides], key=real):
        two_sided = not isinstance(t, Real) and (facts.closed or t not in facts.curve.domain)
        of_knot = sides.get(t, ()) if two_sided else ()
        side = {"side": str(of_knot[0])} if len(of_knot) == 1 else {}
        yield NamedNumbers(what, {"parameter": real(t), **values}, side)


def derivative_by_arc_length(facts: Facts, place: Place, side: Side) -> Real:
    """dκ/ds at a parameter. In the plane κ is the signed curvature; in space the value where κ = 0 is the limit from
    the side.

    >>> from exactspline import example
    >>> from exactspline.geometry.curves.facts import facts_of
    >>> derivative_by_arc_length(facts_of(example("circle")), mpq(1, 3), Side.RIGHT)
    <Real 0>

    Raises `DomainError` where γ′ = 0 or the limit does not exist.
    """
    size = _of(CURVATURE_DERIVATIVE, facts)
    i = segment_at(facts.curve, place, side)
    refuse_singular(facts.curve, i, place, side)
    form, squared = _form_on(facts, size, i), _form_on(facts, _of(CURVATURE, facts), i)
    if form is None or squared is None or sign_at(form.bottom, place) == 0:
        raise DomainError("dκ/ds has a pole at this parameter", remedy="choose another parameter")
    value = form.at(place)
    if not size.squared:
        return value
    slope = sign_at(squared.slope, place)
    return signed_root(slope or (-1 if side is Side.LEFT else 1), value)


def parts_above(facts: Facts, bound: mpq) -> tuple[NamedNumbers, ...]:
    """Whether |κ| is at most a number, and the parts of the curve where it is larger; the end of a part across the seam
    of a closed curve is below its start.

    >>> from exactspline import example
    >>> from exactspline.geometry.curves.facts import facts_of
    >>> parts_above(facts_of(example("ellipse")), mpq(2))
    (<curvature bound: bound 2>,)
    """
    if bound < 0:
        raise ShapeError(f"a curvature of at most {text(bound)}", remedy="give a number that is not negative")
    forms = [_form_on(facts, _of(CURVATURE, facts), i) for i in range(len(facts.breaks) - 1)]
    over = [None if x is None else x.top - x.bottom.scaled(bound * bound) for x in forms]
    parts: list[tuple[Real, Real]] = []
    runs_on = False
    for (a, b), form in zip(pairwise(facts.breaks), over, strict=True):
        for low, high in _parts_above(form):
            start = parts.pop()[0] if runs_on and low == a and _positive(form, a) else low
            parts.append((start, high))
        runs_on = _positive(form, b)
    if facts.closed and runs_on and len(parts) > 1 and _positive(over[0], facts.breaks[0]):
        parts = [*parts[1:-1], (parts[-1][0], parts[0][1])]
    holds = NamedNumbers("curvature bound", {"bound": Real(bound)}, {"holds": "no" if parts else "yes"})
    return (holds, *[NamedNumbers("above", _ends(*each)) for each in parts])


def _positive(form: BSpline | None, t: mpq) -> bool:
    return form is not None and form(t) > 0


def _parts_above(form: BSpline | None) -> Iterator[tuple[Real, Real]]:
    """The parts of a segment on which a form is positive."""
    if form is not None:
        a, b = form.domain
        places = [real(t) for t in (a, *_inside(form), b)]
        yield from (pair for pair in pairwise(places) if form(between(*pair)) > 0)
