"""The pairs of parameters of two curves whose planes have more than one point in common, patch by patch and completely.

The reasoning is in ``docs/bisectors.md``: on one patch the minors of the system vanish together along the zeros of
their greatest common divisor and at finitely many pairs besides; a plane of solutions needs a common point with a
common tangent, or a cusp.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache, partial
from itertools import product

from flint import fmpz_mpoly, fmpz_poly

from exactspline.bivariate.monotone_arcs import border_pairs
from exactspline.bivariate.signs import Sign, sign_on_patch
from exactspline.errors import ReachError, counted
from exactspline.geometry.bisectors.components import (
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
from exactspline.geometry.bisectors.correspondence import branches, graph_intervals, nodes
from exactspline.geometry.bisectors.cusps import cusps_of, lines_at, over_both_cusps, over_cusps, standing
from exactspline.geometry.bisectors.flats import ALL
from exactspline.geometry.bisectors.lines import ONE, PARAMETER, Path, constant, lines_along
from exactspline.geometry.bisectors.polynomials import vanish_together
from exactspline.geometry.bisectors.single_pairs import at_cusp, crossings, singles, touching
from exactspline.geometry.bisectors.system import System, divides, irreducible_factors, piece
from exactspline.language.rational import Rational
from exactspline.numbers.exact import from_flint, mpq, to_fmpq
from exactspline.numbers.intervals import Box, Interval
from exactspline.numbers.sides import Side
from exactspline.polynomials.cost import Budget, drawing_on
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.polynomials.two_parameters import as_form, in_one, lifted, rows_of
from exactspline.roots.of_polynomials import Parameter, Place, as_splines, exactly, roots_in
from exactspline.roots.root import Root
from exactspline.roots.vanishing import vanish_at
from exactspline.splines.nurbs import Nurbs


def special_pairs(first: Nurbs, second: Nurbs, budget: Budget | None = None) -> SpecialPairs:
    """All pairs of two space curves whose solutions are lines, planes or all of space, and the poles. What exceeds the
    budget of work is named in ``undecided``.

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
        return standing(system)
    pairs = over_cusps(system) + over_cusps(system.transposed()).transposed() + over_both_cusps(system)
    others = f"lines, planes and poles on {system.sides.shortly} except those at cusps"
    return pairs + _in_reach(others, lambda: _with_tangents(system))


def _in_reach(what: str, compute: Callable[[], SpecialPairs]) -> SpecialPairs:
    """The computed pairs or, where that would take too long, the name of this part in ``undecided``."""
    try:
        return compute()
    except ReachError as error:
        return SpecialPairs(undecided=(f"{what}: {error.problem}",))


def _with_tangents(system: System) -> SpecialPairs:
    """The special pairs of the system in which zeros of the tangents are divided out."""
    factor = system.factor
    pairs = SpecialPairs() if factor else _everywhere(system)
    # where all minors vanish everywhere, there is more only where the curves overlap
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
    """Every pair is singular: for two arcs of one circle the planes share its axis, for parts of one line they share
    nothing.
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
    """Whether a single pair of an equation has the solutions that a general one has; raises `ReachError` where that
    would take too long.
    """
    return kind == Solutions.PLANE or not vanish_at([f for v in system.crosses() for f in v if f], *place)


def _value(top: fmpz_poly, bottom: fmpz_poly, s: Parameter, side: Interval) -> mpq:
    """The quotient at a parameter at which it is an end of the side."""
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
            pairs += lines_at(system, exactly(root), Cause.DEPENDENT, equation, ALL)
    return pairs


def _along_algebraic(system: System, g: fmpz_mpoly) -> SpecialPairs:
    """An equation of degree at least 2 in both parameters."""
    kind, sides, equation = _kind(system, g), system.sides, PairEquation.of(g)
    if kind is None:
        return SpecialPairs()
    # nearly all zeros are on branches: these draw on the budget of the whole answer first
    found_branches, borders = branches(g, sides), border_pairs(g, sides)
    singular, undecided = list[Place](), tuple[str, ...]()
    try:
        singular = nodes(g, sides)
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
    """Each single pair, and the lines at each cusp, once where the curves continue smoothly to the next patch; a single
    pair is dropped where a curve of pairs of the next patch ends.
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
    """Whether a parameter of one segment also belongs to another one with the same tangent."""
    return own == other or (not isinstance(t, Root) and t in own and t in other and runs_on(curve, t))


def _lies_on(line: LineComponent, s: Parameter, t: Parameter) -> bool:
    """Whether a component contains a pair of its rectangle."""
    if line.equation is not None and not vanish_together([line.equation.polynomial], s, t):
        return False
    return not line.pieces or any(one.low <= (s, t)[one.of] <= one.high for one in line.pieces)


def runs_on(curve: Nurbs, t: mpq) -> bool:
    """Whether a segment ends where another one begins, with the same point and tangent direction (or with γ′ = 0 on
    both sides).
    """
    if t == curve.domain[0] or curve(t, Side.LEFT) != curve(t, Side.RIGHT):
        return False
    i = curve.breakpoints.index(t)
    try:
        before, behind = piece(curve, i - 1), piece(curve, i)
    except ReachError:  # the special pairs there are in `undecided`, so that none can be listed twice
        return False
    stops = [one.stands_still or t in cusps_of(one) for one in (before, behind)]
    if any(stops):
        return all(stops)
    (a, b, c), (x, y, z) = ([from_flint(f(to_fmpq(t))) for f in one.tangent] for one in (before, behind))
    return bool(a * y == b * x and b * z == c * y and a * z == c * x)
