"""The least value of a quotient of functions of two parameters on a rectangle, and where it is taken, exactly: at
points inside, on edges, at corners, along curves.

Inside a patch the least value is taken at common zeros of both derivatives; those with a value above a known value are
not computed. Along the zeros of a common factor of the derivatives the value is constant.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from flint import fmpz, fmpz_mat

from exactspline.bivariate.across_borders import Place, Spot, single_places, together
from exactspline.bivariate.answers import SurfacePart, SurfacePlaces
from exactspline.bivariate.borders import EDGES, Patch, along
from exactspline.bivariate.common_zeros import CommonZero
from exactspline.bivariate.quotients import BOUND, Quotient, keep_least, quotient_on
from exactspline.bivariate.zeros import budget_for, patches_of
from exactspline.errors import ReachError
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.polynomials.certified_boxes import only_zero_in
from exactspline.polynomials.cost import drawing_on
from exactspline.polynomials.patch_forms import PatchForm, jets, not_positive_part
from exactspline.polynomials.two_parameters import as_form
from exactspline.reals.real import Real
from exactspline.roots.of_polynomials import distinct, roots_in
from exactspline.roots.root import Root
from exactspline.splines.surface import Along
from exactspline.splines.tensor import TensorSpline, aligned

#: Newton's steps, and the unit of the parameters; the bits of a bound; and how often a part of a patch is narrowed.
NEWTON, ONE, SHORT, LEVELS = 9, 1 << 128, 90, 6

#: A value, and the place where it is taken: a point, or a part all of whose points have the value.
Found = tuple[Real, Place | SurfacePart]


def minima(
    top: TensorSpline, bottom: TensorSpline, closed: Callable[[], Sequence[Along]] = tuple
) -> tuple[Real, SurfacePlaces[Place]]:
    """The least value of a quotient with a positive denominator, and where it is taken; at knots the limits from all
    sides count as values. `closed` answers in which parameters the two ends are identified.

    >>> knots = [0, 0, 0, 1, 1, 1]
    >>> f = TensorSpline((2, 2), knots, knots, [[2, 0, 2], [0, -2, 0], [2, 0, 2]])  # (2s − 1)² + (2t − 1)²
    >>> value, places = minima(f + 3, f.constant(1))
    >>> value, places[0].exact
    (<Real 3>, (mpq(1,2), mpq(1,2)))

    Raises `ReachError` if this would take too long.
    """
    (f, g), ends = aligned(top, bottom), set[Spot]()
    with drawing_on(budget_for(f)):
        given = [(patch, quotient_on(patch, f, g)) for patch, _ in patches_of(f)]
        corners = [zip(*[form.corners for form in x.forms], strict=True) for _, x in given]
        bound = min(_short(mpq(int(p)) / int(w)) for own in corners for p, w in own)
        lowest = [(patch, x, _descended(x, excess)) for patch, x in given if (excess := x.excess(bound)).sign != 1]
        bound = min(bound, *(_short(value) for _, _, (value, _) in lowest))
        near = [(patch, x, e, at) for patch, x, (_, at) in lowest if (e := x.excess(bound)).sign != 1]
        found = [one for patch, x, excess, _ in near for one in _on_border(patch, x, excess)]
        for patch, x, excess, place in near:
            zeros = _only(x, excess, place)
            whole = _inside(patch, x, bound, ends) if zeros is None and any(x.slopes) else ()
            found += [*whole, *((x.at(zero), Place((patch,), zero.on(x.sides))) for zero in zeros or ())]
        keep_least(found, BOUND)
    parts = dict.fromkeys(part for _, part in found if isinstance(part, SurfacePart))
    places, boxes = [x for _, x in found if isinstance(x, Place)], [x.sides for x in parts if not x.along_curve]
    groups = single_places(places, boxes, ends, f.domain, () if all(x.is_inside for x in places) else closed())
    return found[0][0], SurfacePlaces(tuple(map(together, groups)), tuple(parts))


def _short(value: mpq) -> mpq:
    """A number of few digits that is not below another one."""
    scale = mpq(2) ** (SHORT + value.denominator.bit_length() - value.numerator.bit_length())
    return mpq(-(-value * scale // 1)) / scale


def _descended(f: Quotient, excess: PatchForm) -> tuple[mpq, list[mpq]]:
    """A value of a quotient, and where: often nearly the least one, by Newton's method on the square from the least of
    its coefficients.
    """
    start = excess.entries.index(excess.range[0])
    place = [ONE * k // max(n, 1) for k, n in zip(divmod(start, excess.degree[1] + 1), excess.degree, strict=True)]
    found = list[tuple[mpq, list[int]]]()
    for _ in range(NEWTON):
        jet, ((w, wt, wtt), (ws, wst, _), (wss, *_)) = jets(f.forms, place, ONE)
        (v, vt, vtt), (vs, vst, _), (vss, *_) = jet
        found.append((mpq(int(v)) / int(w), place))
        slopes, mixed, crossed = [vs * w - v * ws, vt * w - v * wt], vst * w - v * wst, vs * wt - vt * ws
        rows = [[vss * w - v * wss, mixed + crossed], [mixed - crossed, vtt * w - v * wtt]]
        for k in (0, 1):
            if (place[k] == 0 and slopes[k] > 0) or (place[k] == ONE and slopes[k] < 0):
                slopes[k], rows[k] = fmpz(0), [fmpz(k == 0), fmpz(k == 1)]
        (a, b), (c, d) = rows
        if (determinant := a * d - b * c) <= 0 or place in [at for _, at in found[:-1]]:
            break
        steps = b * slopes[1] - d * slopes[0], c * slopes[0] - a * slopes[1]
        place = [min(max(x + int(ONE * y // determinant), 0), ONE) for x, y in zip(place, steps, strict=True)]
    value, place = min(found)
    return value, [mpq(x, ONE) for x in place]


def _line(patch: Patch, sides: Box, direction: int, local: mpq) -> SurfacePart:
    """A line of a patch at a local parameter."""
    return SurfacePart(patch, sides.with_side(direction, Interval.point(sides[direction].at(local))))


def _on_border(patch: Patch, f: Quotient, excess: PatchForm) -> Iterator[Found]:
    """The points of edges at which a quotient may be least, and edges and patches on which it is constant, if the value
    is at most a bound.
    """
    whole = SurfacePart(patch, f.sides)
    rows = ((edge, excess.edge(*edge)) for edge in EDGES)
    kept = [(edge, not_positive_part(PatchForm(fmpz_mat(1, len(row), row)))) for edge, row in rows]
    for edge, (low, high) in ((edge, box.second) for edge, box in kept if box):
        slope = along(f.slope_forms[1 - edge.direction], edge, UNIT)
        part = _line(patch, f.sides, edge.direction, mpq(edge.end)) if any(f.slopes) else whole
        places = distinct([*(x for x in UNIT.first if low <= x <= high), *roots_in(slope, low, high)])
        for local in [edge.place(UNIT, t) for t in places]:
            yield f.value(*local), Place((patch,), CommonZero(f.sides, local)) if slope else part


def _inside(patch: Patch, f: Quotient, bound: mpq, ends: set[Spot]) -> Iterator[Found]:
    """The points inside a patch at which a quotient may be least, and curves on which it is constant; the end points of
    these curves are added to `ends`.
    """
    points, arcs, undecided = f.critical(bound)
    if undecided:
        raise ReachError(f"the least value over {f.sides.shortly}", remedy="take a part of the surface (restrict)")
    met = {place for _, arc in arcs for place in (arc.start, arc.end)}
    ends |= {CommonZero(f.sides, place).place for place in met}
    for _, arc in arcs:
        lines = [(k, x) for k, x in enumerate(arc.start) if x == arc.end[k] and not isinstance(x, Root)]
        parts = [_line(patch, f.sides, k, x) for k, x in lines] or [SurfacePart(patch, f.sides, along_curve=True)]
        yield f.value(*arc.inner), parts[0]
    for zero, pair in points:
        if not arcs or zero.local not in met:
            yield f.at(zero, pair), Place((patch,), zero.on(f.sides))


def _only(f: Quotient, excess: PatchForm, near: Sequence[mpq]) -> list[CommonZero] | None:
    """The critical point inside of a patch, near a given point, whose value is not above the bound, where boxes show
    that there is at most one; None where they do not.
    """
    box, factor = UNIT, as_form(f.shared)
    for _ in range(LEVELS if all(f.slopes) else 0):
        if (kept := not_positive_part(excess.part(box))) is None:
            return []
        box = box.part(kept)
        if factor.part(box).sign is None:
            continue
        if any(form.part(box).sign for form in f.coprime):
            return []
        if (isolated := only_zero_in(f.coprime, box, near)) is not None:
            return [CommonZero(UNIT, isolated=isolated)] if isolated.box.is_inside(UNIT) else None
    return None
