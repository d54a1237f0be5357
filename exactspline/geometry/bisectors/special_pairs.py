"""The pairs of parameters of two curves whose planes have more than one point in common, patch by patch and completely.

The reasoning is in ``docs/bisectors.md``: on one patch the minors of the system vanish together along the zeros of
their greatest common divisor and at finitely many other pairs. A plane of solutions occurs only at a common point with
a common tangent, or at a cusp.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache, partial
from itertools import pairwise, product
from operator import itemgetter

from flint import ctx, fmpz_mpoly, fmpz_poly

from exactspline.bivariate.common_zeros import common_zeros
from exactspline.bivariate.quotients import border_pairs
from exactspline.bivariate.signs import Sign, sign_on_patch
from exactspline.errors import ReachError, counted
from exactspline.geometry.bisectors.common import parts_where
from exactspline.geometry.bisectors.components import (
    Branch,
    Cause,
    Correspondence,
    LineComponent,
    LinePiece,
    PairEquation,
    PlaneComponent,
    PoleCurve,
    RealZeros,
    SinglePair,
    Solutions,
    SpecialPairs,
)
from exactspline.geometry.bisectors.lines import (
    ALL,
    ONE,
    PARAMETER,
    Conditions,
    Path,
    constant,
    lines_along,
    lines_over_root,
)
from exactspline.geometry.bisectors.single_pairs import at_cusp, brief, crossings, singles, touching, zeros_of_vector
from exactspline.geometry.bisectors.system import (
    SegmentOfCurve,
    System,
    common_divisor_along,
    divides,
    irreducible_factors,
    piece,
    vanish_together,
)
from exactspline.language.rational import Rational
from exactspline.numbers.exact import from_flint, mpq, to_fmpq
from exactspline.numbers.intervals import Box, Interval, Side
from exactspline.polynomials.cost import Budget, drawing_on
from exactspline.polynomials.elimination import discriminant
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.polynomials.two_parameters import as_form, at, enclosed, in_one, lifted, rows_of
from exactspline.reals.real import between
from exactspline.roots.of_polynomials import Parameter, Place, as_splines, ball, distinct, exactly, roots_in
from exactspline.roots.root import Root
from exactspline.roots.vanishing import vanish_at
from exactspline.splines.nurbs import Nurbs

# ---- cusps
# Over the other curve there are lines, and planes where the other curve passes through the cusp or has no tangent
# either.


#: The remaining conditions where the first curve has no tangent.
WITHOUT_FIRST = Conditions.SECOND | Conditions.MIDDLE


def _standing(system: System) -> SpecialPairs:
    """The exceptional pairs of two segments, at least one of which is a point."""
    first, second = system.first, system.second
    if not first.stands_still:
        return _standing(system.transposed()).transposed()
    if second.stands_still:
        solutions = Solutions.PLANE if any(system.chord) else Solutions.SPACE
        return SpecialPairs(planes=(PlaneComponent(solutions, Cause.BOTH_STILL, system.sides, None),))
    surface = lines_along(system, Path(constant(first.interval[0]), (PARAMETER, ONE)), second.interval, WITHOUT_FIRST)
    lines: tuple[LineComponent, ...] = ()
    if surface is not None:
        own = LinePiece(1, *second.interval, None, surface)
        lines = (LineComponent(Correspondence.ALL, Cause.FIRST_STILL, system, None, (own,)),)
    return SpecialPairs(lines, _planes_over_a_point(system))


def _planes_over_a_point(system: System) -> tuple[PlaneComponent, ...]:
    """The planes where the second curve passes through the single point of the first curve, and at cusps of the second
    curve.
    """
    side = system.second.interval
    meetings, cusps = roots_in(in_one(greatest_common_divisor(system.chord), 1), *side), _cusps_of(system.second)
    planes = [
        _plane_at(Solutions.SPACE if t in cusps else Solutions.PLANE, Cause.FIRST_STILL, system, t) for t in meetings
    ]
    planes += [_plane_at(Solutions.PLANE, Cause.BOTH_STILL, system, t) for t in cusps if t not in meetings]
    return tuple(planes)


def _cusps_of(own: SegmentOfCurve) -> list[Root]:
    """The parameters of a segment at which γ′ = 0."""
    return [root for q in own.cusps for root in roots_in(q, *own.interval)]


def _plane_at(solutions: Solutions, cause: Cause, system: System, t: Root) -> PlaneComponent:
    equation = PairEquation.of(lifted(fmpz_poly(t.minimal_polynomial()), 1))
    return PlaneComponent(solutions, cause, system.sides, equation, of=1, fixed=exactly(t))


def _over_cusps(system: System) -> SpecialPairs:
    """Lines over the second curve at the cusps of the first, and the pairs at which the second curve passes through a
    cusp.
    """
    pairs = SpecialPairs()
    for q in system.first.cusps:
        for s in roots_in(q, *system.first.interval):
            pairs += _over_cusp(system, lifted(q, 0), exactly(s))
    return pairs


def _over_cusp(system: System, equation: fmpz_mpoly, s: Parameter) -> SpecialPairs:
    second = system.second
    found = _lines_at(system, s, Cause.FIRST_CUSP, PairEquation.of(equation), WITHOUT_FIRST)
    meetings, undecided = _meetings(system, equation, s)
    cusps = _cusps_of(second)
    pairs = [SinglePair(*x, Solutions.PLANE, Cause.FIRST_CUSP, system) for x in meetings if x[1] not in cusps]
    return found + SpecialPairs(pairs=tuple(pairs), undecided=undecided)


def _lines_at(
    system: System, s: Parameter, cause: Cause, equation: PairEquation, conditions: Conditions
) -> SpecialPairs:
    """The lines over all of the second curve at one parameter of the first; none where the planes are parallel."""
    second, fixed = system.second, Correspondence.FIRST_FIXED
    if isinstance(s, Root):
        over_root = lines_over_root(system, s, conditions)
        if over_root is None:
            return SpecialPairs()
        undecided = () if over_root.poles is not None else (f"the poles of the lines over {brief((s,))} of one curve",)
        return SpecialPairs((LineComponent(fixed, cause, system, equation, over_root=over_root),), undecided=undecided)
    surface = lines_along(system, Path(constant(s), (PARAMETER, ONE)), second.interval, conditions)
    if surface is None:
        return SpecialPairs()
    pieces = (LinePiece(1, *second.interval, s, surface),)
    return SpecialPairs((LineComponent(fixed, cause, system, equation, pieces),))


def _meetings(system: System, equation: fmpz_mpoly, s: Parameter) -> tuple[list[Place], tuple[str, ...]]:
    """The pairs with this s at which the curves meet."""
    if not isinstance(s, Root):
        shared = common_divisor_along(at(f, 0, s) for f in system.chord)
        return [(s, exactly(t)) for t in roots_in(shared, *system.second.interval)], ()
    places, undecided = zeros_of_vector(equation, list(system.chord), system.sides)
    return [place for place in places if place[0] == s], undecided


def over_both_cusps(system: System) -> SpecialPairs:
    """The pairs at which neither curve has a tangent: the plane between the points, or all of space."""
    pairs: list[SinglePair] = []
    undecided: list[str] = []
    for s, t in product(*[map(exactly, _cusps_of(own)) for own in (system.first, system.second)]):
        meet = vanish_together(list(system.chord), s, t)
        if meet is None:
            undecided.append(f"whether the cusps at {brief((s, t))} coincide")
            continue
        pairs.append(SinglePair(s, t, Solutions.SPACE if meet else Solutions.PLANE, Cause.BOTH_CUSPS, system))
    return SpecialPairs(pairs=tuple(pairs), undecided=tuple(undecided))


# ---- correspondence


def graph_intervals(
    top: fmpz_poly, bottom: fmpz_poly, own: Interval, range_: Interval
) -> list[tuple[Parameter, Parameter]]:
    """The maximal closed intervals on which the quotient lies in a closed range, single parameters included.

    >>> graph_intervals(fmpz_poly([0, 1]), fmpz_poly([1]), (mpq(0), mpq(2)), (mpq(1), mpq(3)))
    [(mpq(1,1), mpq(2,1))]
    """
    low, high = own
    borders = [top * int(y.denominator) - bottom * int(y.numerator) for y in range_]
    hits = distinct(root for border in borders for root in roots_in(border, low, high))
    cuts = distinct([low, *roots_in(bottom, low, high), *hits, high])
    intervals = parts_where(lambda x: range_[0] <= from_flint(top(to_fmpq(x)) / bottom(to_fmpq(x))) <= range_[1], cuts)
    single = [t for t in hits if not any(a <= t <= b for a, b in intervals)]
    return sorted([*intervals, *((t, t) for t in single)], key=itemgetter(0))


def branches(g: fmpz_mpoly, sides: Box) -> list[Branch]:
    """The real branches of an equation of degree at least 2 in both parameters, strictly inside the rectangle.

    Between two parameters s at which the discriminant, the first coefficient or the value on a side of the rectangle
    vanishes, the number of roots inside does not change. Raises `ReachError` if the discriminant would take too long.

    >>> from exactspline.polynomials.two_parameters import S, T
    >>> square = (mpq(-2), mpq(2))
    >>> [(b.index, b.sample[0]) for b in branches(S * S + T * T - 1, (square, square))]
    [(0, mpq(0,1)), (1, mpq(0,1))]
    """
    own, other = sides
    critical = [discriminant(rows_of(g)), rows_of(g)[-1], *(at(g, 1, y) for y in other)]
    cuts = distinct([*own, *(root for p in critical for root in roots_in(p, *own))])
    branches_of_equation = []
    for low, high in pairwise(cuts):
        s = between(low, high)
        inside = [exactly(t) for t in roots_in(at(g, 0, s), *other)]
        branches_of_equation += [Branch(low, high, k, (s, t)) for k, t in enumerate(inside)]
    return branches_of_equation


def _nodes(g: fmpz_mpoly, sides: Box) -> list[Place]:
    """The singular pairs of an irreducible equation that need not be limits of branches (where the Hessian is negative,
    two branches cross). Raises `ReachError` if this would take too long.

    >>> from exactspline.polynomials.two_parameters import S, T
    >>> side = Interval(mpq(-1, 2), mpq(1, 2))
    >>> _nodes(S**3 - S * S - T * T, Box(side, side))
    [(mpq(0,1), mpq(0,1))]
    """
    first, second = g.derivative(0), g.derivative(1)
    crossing = first.derivative(1) ** 2 - first.derivative(0) * second.derivative(1)
    singular = (zero.place for zero in common_zeros([g, first, second], sides))
    return [place for place in singular if not _certainly_positive(crossing, place)]


def _certainly_positive(p: fmpz_mpoly, place: Place) -> bool:
    with ctx.workprec(400):
        return bool(enclosed(p, ball(place[0], 40), ball(place[1], 40)) > 0)


def special_pairs(first: Nurbs, second: Nurbs, budget: Budget | None = None) -> SpecialPairs:
    """All pairs of two space curves whose solutions are lines, planes or all of space, and the poles. Parts that exceed
    the budget of work are listed in ``undecided``.

    >>> from exactspline import Nurbs
    >>> low, high = (Nurbs(1, [0, 0, 1, 1], [(0, 0, z), (2, 0, z)]) for z in (0, 1))
    >>> [line.equation.text for line in special_pairs(low, high).lines]
    ['s - t']
    """
    one, other = (cache(partial(piece, c)) for c in (first, second))
    pairs, not_tried = SpecialPairs(), list[str]()

    def of_segments(i: int, j: int) -> SpecialPairs:
        return _of_system(System(one(i), other(j)))

    with drawing_on(budget or Budget()) as paid:
        for i, j in product(range(first.segments), range(second.segments)):
            where = Box(Interval(*first.breakpoints[i : i + 2]), Interval(*second.breakpoints[j : j + 2])).shortly
            if paid.spent:
                not_tried.append(where)
            else:
                pairs += _in_reach(f"the parts other than the surface on {where}", partial(of_segments, i, j))
    if not_tried:
        more = f" and {counted(len(not_tried) - 1, 'rectangle')} more" if len(not_tried) > 1 else ""
        parts = f"the parts other than the surface on {not_tried[0]}{more}"
        pairs += SpecialPairs(undecided=(f"{parts}: the bound on the whole answer was reached before",))
    return _without_repetition(pairs, first, second)


def _of_system(system: System) -> SpecialPairs:
    if system.first.stands_still or system.second.stands_still:
        return _standing(system)
    pairs = _over_cusps(system) + _over_cusps(system.transposed()).transposed() + over_both_cusps(system)
    others = f"lines, planes and poles on {system.sides.shortly} except those at cusps"
    return pairs + _in_reach(others, lambda: _with_tangents(system))


def _in_reach(what: str, compute: Callable[[], SpecialPairs]) -> SpecialPairs:
    """The computed pairs or, if they would take too long, the name of this part in ``undecided``."""
    try:
        return compute()
    except ReachError as error:
        return SpecialPairs(undecided=(f"{what}: {error.problem}",))


def _with_tangents(system: System) -> SpecialPairs:
    """The special pairs of the system in which zeros of the tangents are divided out."""
    factor = system.factor
    pairs = SpecialPairs() if factor else _everywhere(system)
    # if all minors vanish everywhere, other pairs exist only where the curves overlap
    factors = irreducible_factors(factor if factor else greatest_common_divisor(system.chord))
    where = system.sides.shortly
    for g in factors:
        if sign_on_patch(as_form(g).part(system.sides)).sign not in (Sign.POSITIVE, Sign.NEGATIVE):
            what = f"lines or planes of {PairEquation.of(g).short_text} on {where}"
            pairs += _in_reach(what, partial(_along, system, g))
    pairs += _in_reach(f"single pairs on {where}", lambda: _single(system, factors))
    return pairs + _in_reach(f"poles on {where}", lambda: _poles(system)) if factor else pairs


def _single(system: System, factors: list[fmpz_mpoly]) -> SpecialPairs:
    """The single pairs except those at cusps."""
    meetings, undecided = crossings(system)
    pairs = singles(system, factors, meetings) if system.factor else touching(system, meetings)
    return pairs + SpecialPairs(undecided=undecided)


def _everywhere(system: System) -> SpecialPairs:
    """Every pair is singular: for two arcs of the same circle the three planes share its axis, for two parts of the
    same line they have no common point.
    """
    (a, b), side = system.sides
    surface = lines_along(system, Path(constant(mpq((2 * a + b) / 3)), (PARAMETER, ONE)), side)
    if surface is None:
        return SpecialPairs()
    own = LinePiece(1, *side, None, surface)
    return SpecialPairs((LineComponent(Correspondence.ALL, Cause.DEPENDENT, system, None, (own,)),))


# ---- along an irreducible equation


def _along(system: System, g: fmpz_mpoly) -> SpecialPairs:
    """The lines, or the planes, along an irreducible equation."""
    m, n = (int(k) for k in g.degrees())
    if m == 0 or (m == 1 and n > 1):
        return _along(system.transposed(), PairEquation.of(g).transposed().polynomial).transposed()
    return (_along_fixed, _along_rational, _along_algebraic)[min(n, 2)](system, g)


def _kind(system: System, g: fmpz_mpoly) -> Solutions | None:
    """The solutions of a general pair of an equation; None when its planes are parallel and distinct."""
    if not all(divides(g, v) for v in system.crosses()):
        return Solutions.LINE
    return Solutions.PLANE if divides(g, system.chord) else None


def _along_rational(system: System, g: fmpz_mpoly) -> SpecialPairs:
    """An equation of degree 1 in t."""
    equation, kind = PairEquation.of(g), _kind(system, g)
    cause = Cause.OVERLAP if kind == Solutions.PLANE else Cause.DEPENDENT
    top, bottom = rows_of(g)
    intervals = graph_intervals(-top, bottom, *system.sides)
    wide = tuple((low, high) for low, high in intervals if low < high)
    narrow = [(low, _value(-top, bottom, low, system.second.interval)) for low, high in intervals if low == high]
    singular = [
        SinglePair(*x, kind, cause, system) for x in narrow if kind and not at_cusp(system, x) and _has(system, x, kind)
    ]
    pairs = SpecialPairs(pairs=tuple(singular))
    if kind == Solutions.PLANE and wide:
        pairs += SpecialPairs(planes=(PlaneComponent(kind, cause, system.sides, equation, wide),))
    if kind == Solutions.LINE and wide:
        pairs += SpecialPairs((_graph(system, equation, wide),))
    return pairs


def _has(system: System, place: Place, kind: Solutions) -> bool:
    """Whether a single pair of an equation has the same kind of solutions as a general pair; raises `ReachError` if
    this would take too long.
    """
    return kind == Solutions.PLANE or not vanish_at([f for v in system.crosses() for f in v if f], *place)


def _value(top: fmpz_poly, bottom: fmpz_poly, s: Parameter, side: Interval) -> mpq:
    """The quotient at a parameter at which its value is an end of the side."""
    borders = [(y, lifted(top * int(y.denominator) - bottom * int(y.numerator), 0)) for y in side]
    return next(y for y, border in borders if vanish_at([border], s, y))


def _graph(system: System, equation: PairEquation, intervals: tuple[tuple[Parameter, Parameter], ...]) -> LineComponent:
    top, bottom = rows_of(equation.polynomial)
    own = system.first.interval
    surface = lines_along(system, Path((PARAMETER, ONE), (-top, bottom)), own)
    above, below = as_splines([-top, bottom], *own)
    pieces = [
        LinePiece(0, low, high, Rational(above, below), surface) for low, high in intervals if surface is not None
    ]
    return LineComponent(Correspondence.RATIONAL, Cause.DEPENDENT, system, equation, tuple(pieces))


def _along_fixed(system: System, g: fmpz_mpoly) -> SpecialPairs:
    """An equation in s alone."""
    pairs, equation = SpecialPairs(), PairEquation.of(g)
    if _kind(system, g) == Solutions.LINE:
        for root in roots_in(in_one(g, 0), *system.first.interval):
            pairs += _lines_at(system, exactly(root), Cause.DEPENDENT, equation, ALL)
    return pairs


def _along_algebraic(system: System, g: fmpz_mpoly) -> SpecialPairs:
    """An equation of degree at least 2 in both parameters."""
    kind, sides, equation = _kind(system, g), system.sides, PairEquation.of(g)
    if kind is None:
        return SpecialPairs()
    # nearly all zeros are on branches, which therefore use the budget of the whole answer first
    found_branches, borders = branches(g, sides), border_pairs(g, sides)
    singular, undecided = list[Place](), tuple[str, ...]()
    try:
        singular = _nodes(g, sides)
    except ReachError:
        undecided = (f"isolated real pairs of {equation.short_text} on {sides.shortly}, if there are any",)
    real = RealZeros(tuple(found_branches), tuple(borders), tuple(singular))
    pairs = SpecialPairs(undecided=undecided)
    if not real:
        return pairs
    if kind == Solutions.PLANE:
        return pairs + SpecialPairs(planes=(PlaneComponent(kind, Cause.OVERLAP, sides, equation, real=real),))
    component = LineComponent(Correspondence.ALGEBRAIC, Cause.DEPENDENT, system, equation, real=real)
    return pairs + SpecialPairs((component,))


# ---- poles


def _poles(system: System) -> SpecialPairs:
    """The factors of the determinant in lowest terms that have zeros on the rectangle."""
    determinant = system.determinant / system.factor
    poles = []
    for g in irreducible_factors(determinant) if determinant else []:
        form = as_form(g).part(system.sides)
        sign = sign_on_patch(form).sign
        if sign not in (Sign.POSITIVE, Sign.NEGATIVE):
            certain = sign is not Sign.UNDECIDED or not all(form.corners)
            poles.append(PoleCurve(PairEquation.of(g), system.sides, certain))
    return SpecialPairs(poles=tuple(poles))


# ---- neighbours


def _without_repetition(special: SpecialPairs, first: Nurbs, second: Nurbs) -> SpecialPairs:
    """The special pairs without repetition: where the curves continue smoothly to the next patch, each single pair and
    the lines at each cusp are listed once. A single pair at which a curve of pairs of the next patch ends is dropped.
    """
    curves = first, second

    def shared(pair: SinglePair) -> bool:
        return any(
            own == side[0] and runs_on(curve, side[0])
            for own, side, curve in zip(pair.place, pair.sides, curves, strict=True)
        )

    def on_line(pair: SinglePair) -> bool:
        return pair.solutions == Solutions.LINE and any(
            line.sides != pair.sides
            and all(_reaches(*each) for each in zip(pair.place, pair.sides, line.sides, curves, strict=True))
            and _lies_on(line, *pair.place)
            for line in special.lines
        )

    def shared_line(line: LineComponent) -> bool:
        fixed = {Correspondence.FIRST_FIXED: 0, Correspondence.SECOND_FIXED: 1}.get(line.correspondence)
        if fixed is None or not line.pieces:
            return False
        start, curve = line.sides[fixed][0], curves[fixed]
        return bool(line.pieces[0].other == start and runs_on(curve, start))

    return replace(
        special,
        lines=tuple(line for line in special.lines if not shared_line(line)),
        pairs=tuple(pair for pair in special.pairs if not shared(pair) and not on_line(pair)),
    )


def _reaches(t: Parameter, own: Interval, other: Interval, curve: Nurbs) -> bool:
    """Whether a parameter of one segment also belongs to another segment, with the same tangent."""
    return own == other or (not isinstance(t, Root) and t in own and t in other and runs_on(curve, t))


def _lies_on(line: LineComponent, s: Parameter, t: Parameter) -> bool:
    """Whether a component contains a pair of its rectangle."""
    if line.equation is not None and not vanish_together([line.equation.polynomial], s, t):
        return False
    return not line.pieces or any(one.low <= (s, t)[one.of] <= one.high for one in line.pieces)


def runs_on(curve: Nurbs, t: mpq) -> bool:
    """Whether a segment ends where another segment begins, with the same point and tangent direction (or with γ′ = 0 on
    both sides).
    """
    if t == curve.domain[0] or curve(t, Side.LEFT) != curve(t, Side.RIGHT):
        return False
    i = curve.breakpoints.index(t)
    try:
        before, behind = piece(curve, i - 1), piece(curve, i)
    except ReachError:  # the special pairs there are in `undecided`, so that none can be listed twice
        return False
    stops = [one.stands_still or t in _cusps_of(one) for one in (before, behind)]
    if any(stops):
        return all(stops)
    (a, b, c), (x, y, z) = ([from_flint(f(to_fmpq(t))) for f in one.tangent] for one in (before, behind))
    return bool(a * y == b * x and b * z == c * y and a * z == c * x)
