"""Answers about one curve as theorems: the zeros of its curvature, of the derivative of its curvature, and of its
torsion.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from importlib.resources import files
from itertools import pairwise, zip_longest
from math import lcm
from string import Template

from flint import fmpq_poly

from exactspline.errors import ClaimError, DomainError, counted
from exactspline.extras.coq.formulas import Formulas, comment
from exactspline.language.formula import Formula
from exactspline.numbers.exact import from_flint, mpq, to_fmpq
from exactspline.numbers.intervals import Interval
from exactspline.numbers.search import Search
from exactspline.papers import find, papers
from exactspline.polynomials.bezout import determinant
from exactspline.polynomials.cost import Budget, drawing_on
from exactspline.polynomials.isolation import Cell, cells_of, one_sign
from exactspline.splines.bspline import in_powers
from exactspline.splines.control_points import lifted
from exactspline.splines.nurbs import Nurbs

#: The forms by the dimension of the curve: the name of the theorem, the formula, and the quantity that vanishes with
#: it.
FORMS = {
    2: (
        ("curvature", "f2", "the curvature"),
        ("curvature_derivative", "vertices_lifted", "the derivative of the curvature"),
    ),
    3: (("torsion", "torsion_zeros_lifted", "the torsion"),),
}


@dataclass(frozen=True)
class _Answer:
    """A form of a curve: its polynomials span by span, and their cells."""

    name: str
    formula: Formula
    what: str
    polynomials: tuple[fmpq_poly, ...]
    cells: tuple[tuple[Cell, ...], ...]

    @property
    def points(self) -> list[tuple[mpq, mpq]]:
        """The intervals or points, each containing exactly one zero."""
        points: list[tuple[mpq, mpq]] = []
        for i, (f, cells) in enumerate(zip(self.polynomials, self.cells, strict=True)):
            last = i == len(self.cells) - 1
            if cells[0].sign is None:
                points += [(cells[-1].high, cells[-1].high)] if last else []
                continue
            for cell in cells:
                points += [(cell.low, cell.low)] if f(to_fmpq(cell.low)) == 0 else []
                points += [(cell.low, cell.high)] if cell.one else []
            points += [(cells[-1].high, cells[-1].high)] if last and f(to_fmpq(cells[-1].high)) == 0 else []
        return points

    @property
    def stretches(self) -> list[tuple[mpq, mpq]]:
        """The spans on which the form vanishes identically."""
        return [(cells[0].low, cells[0].high) for cells in self.cells if cells[0].sign is None]


def answers(curve: Nurbs) -> list[_Answer]:
    """The forms of a curve with their cells.

    Raises `ClaimError` for a curve that is neither in the plane nor in space.
    """
    if curve.dimension not in FORMS:
        raise ClaimError(f"a curve in R{curve.dimension}", remedy="answers are proved in the plane and in space")
    spans, forms = list(pairwise(curve.breakpoints)), []
    for name, formula, what in FORMS[curve.dimension]:
        value = find(formula)(curve)
        polynomials = tuple(in_powers(value, i) for i in range(len(spans)))
        cells = tuple(tuple(cells_of(f, a, b)) for f, (a, b) in zip(polynomials, spans, strict=True))
        forms.append(_Answer(name, find(formula), what, polynomials, cells))
    return forms


def theorem_of(curve: Nurbs) -> str:
    """A file with theorems about this curve, given by its control points."""
    forms = answers(curve)
    formulas = Formulas(papers())
    own = {formulas.owner[answer.formula].name for answer in forms}
    return _written(
        "curve",
        title=comment(curve.name or "without a name"),
        required="\n".join(f"From ExactSpline.formulas Require {name}." for name in sorted(own)),
        definition=_definition("this_curve", curve),
        domain=", ".join(map(_number_in_q, curve.domain)),
        theorems="\n".join(_theorem(curve, answer, formulas) for answer in forms),
    )


def _written(text: str, /, **parts: object) -> str:
    """A text of ``answers.toml`` with what was computed."""
    texts = tomllib.loads(files(__package__).joinpath("answers.toml").read_text(encoding="utf-8"))
    return Template(texts[text]).substitute(parts)


def _definition(name: str, curve: Nurbs) -> str:
    """A curve as a record of Coq."""
    *coordinates, weights = map(_list, _homogeneous_columns(curve))
    own = {"coordinates": "; ".join(coordinates), "weights": weights}
    return _written("record", name=name, knots=_list(curve.knots), degree=curve.degree, **own)


def _homogeneous_columns(curve: Nurbs) -> list[list[mpq]]:
    """The coordinates times the weights, coordinate by coordinate, and the weights."""
    rows = [(*lifted(point, weight), weight) for point, weight in zip(curve.control_points, curve.weights, strict=True)]
    return [list(column) for column in zip(*rows, strict=True)]


def _theorem(curve: Nurbs, answer: _Answer, formulas: Formulas) -> str:
    form = formulas.named(answer.formula)
    low, high = _number_in_q(answer.cells[0][0].low), _number_in_q(answer.cells[-1][-1].high)
    cells = ";\n  ".join("[" + "; ".join(map(_cell_text, own)) + "]" for own in answer.cells)
    pieces = ";\n  ".join(
        f"({_number_in_q(own[-1].high)}, {_coefficients_text(f)})"
        for f, own in zip(answer.polynomials, answer.cells, strict=True)
    )
    points, stretches = _pairs_text(answer.points), _pairs_text(answer.stretches)
    places = counted(len(answer.points), "point")
    places += f" and {counted(len(answer.stretches), 'stretch')}" if answer.stretches else ""
    numbers = {"points": points, "stretches": stretches, "low": low, "high": high}
    return _written(
        "form", name=answer.name, what=answer.what, form=form, cells=cells, pieces=pieces, places=places, **numbers
    )


def _number_in_q(value: object) -> str:
    """An exact number in the scope of Q."""
    exact = mpq(value)
    return f"{exact.numerator}" if exact.denominator == 1 else f"{exact.numerator} # {exact.denominator}"


def _list(values: Iterable[object]) -> str:
    return "[" + "; ".join(map(_number_in_q, values)) + "]"


def _pairs_text(pairs: Iterable[tuple[mpq, mpq]]) -> str:
    """Pairs of exact numbers as a list of Coq."""
    return "[" + "; ".join(f"({_number_in_q(a)}, {_number_in_q(b)})" for a, b in pairs) + "]"


def _coefficients_text(f: fmpq_poly) -> str:
    """A polynomial as the list of its coefficients."""
    return _list(from_flint(c) for c in f.coeffs())


def _boolean(value: bool) -> str:
    """A truth value in Coq."""
    return "true" if value else "false"


def _cell_text(cell: Cell) -> str:
    """A cell as a term of Coq."""
    ends = f"({_number_in_q(cell.low)}) ({_number_in_q(cell.high)})"
    if cell.sign is None:
        return f"Null {ends}"
    if cell.factor is not None and cell.rest is not None:
        return (
            f"Multiple {ends} {_coefficients_text(cell.factor)} {_boolean(cell.sign)} {cell.power} "
            f"{_coefficients_text(cell.rest)} {_boolean(cell.rest_sign)}"
        )
    return f"{'One' if cell.one else 'Sign'} {ends} {_boolean(cell.sign)}"


# ---- the common points of two plane curves
#
# The resultant and the first subresultant are given with their cofactors, so that Coq checks polynomial identities.
#
# Source: Brown and Traub, On Euclid's algorithm and the theory of subresultants, JACM 1971 (as determinants).


#: A polynomial in s whose coefficients are polynomials in t.
Rows = list[fmpq_poly]
#: The number of bisections after which the place of a point is not decided, and the widths of boxes (bits).
DEPTH, WIDTH = 120, 10
REMEDY = "theorems are about simple points, inside or at rational parameters, of plane curves with positive weights"


@dataclass(frozen=True)
class _BoxedPoint:
    """An interval of the second parameter with one zero of the resultant, or a point, and the interval of the first
    parameter, None if it is outside the curve. `sign` is the sign of the slope; `above` says on which side the first
    parameter is outside.
    """

    second: Interval
    first: Interval | None
    sign: bool
    above: bool = False


@dataclass(frozen=True)
class _Elimination:
    """The resultant, a combination ``slope s + offset``, and the combinations that prove both."""

    eliminant: fmpq_poly
    slope: fmpq_poly
    offset: fmpq_poly
    exponent: int
    combinations: tuple[tuple[Rows, Rows], ...]


def meeting_theorem(first: Nurbs, second: Nurbs) -> str:
    """A file for Coq with the theorem about all common points of two curves.

    >>> parabola = Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), ("1/2", 0), (1, 1)])
    >>> line = Nurbs(1, [0, 0, 1, 1], [(0, "1/2"), (1, "1/2")])
    >>> "meet at exactly 1 point" in meeting_theorem(parabola, line)
    True

    Raises `ClaimError` if there is no such theorem.
    """
    for curve in (first, second):
        if curve.dimension != 2 or curve.segments != 1 or min(curve.weights) <= 0:
            raise ClaimError("not a plane curve of one segment with positive weights", where=curve.name, remedy=REMEDY)
    with drawing_on(Budget()):
        found = _elimination(*(_difference(first, second, k) for k in (0, 1)))
    try:
        cells, places = _places(found, first.domain, second.domain)
    except DomainError as error:
        raise ClaimError("a common point that bisection does not place", remedy=REMEDY) from error
    spans = [sum(t <= c.domain.low for t in c.knots) - 1 for c in (first, second)]
    pieces = [f"(curve_piece {name} {j})" for name, j in zip(("first_curve", "second_curve"), spans, strict=True)]
    boxes = [(x.first, x.second) for x in places if x.first is not None]
    listed = "; ".join(f"({_interval(s)}, {_interval(t)})" for s, t in boxes)
    ends = " ".join(f"({_number_in_q(t)})" for c in (first, second) for t in c.domain)
    named = ", ".join(comment(c.name or "a curve") for c in (first, second))
    return _written(
        "meetings",
        titles=named,
        definitions="\n".join(_definition(f"{k}_curve", c) for k, c in (("first", first), ("second", second))),
        elimination=_elimination_text(found),
        cells=";\n  ".join(map(_cell_text, cells)),
        places=";\n  ".join(f"({_interval(x.second)}, {_place_text(x)})" for x in places),
        many=counted(len(boxes), "point"),
        pieces=" ".join(pieces),
        ends=ends,
        boxes=listed,
        seconds=_pairs_text(x.second for x in places),
    )


# ---- elimination


def _difference(first: Nurbs, second: Nurbs, k: int) -> Rows:
    """``x(s) w(t) − w(s) x(t)``."""
    (x, w), (y, v) = ((in_powers(c.p[k], 0), in_powers(c.w, 0)) for c in (first, second))
    return _trimmed([v * x[i] - y * w[i] for i in range(max(x.degree(), w.degree()) + 1)])


def _trimmed(rows: Rows) -> Rows:
    while rows and not rows[-1]:
        rows = rows[:-1]
    return rows


def _sum(f: Rows, g: Rows, a: fmpq_poly, b: fmpq_poly) -> Rows:
    zero = fmpq_poly([])
    return _trimmed([a * x + b * y for x, y in zip_longest(f, g, fillvalue=zero)])


def _product(f: Rows, g: Rows) -> Rows:
    rows = [fmpq_poly([])] * max(len(f) + len(g) - 1, 0)
    for i, x in enumerate(f):
        for j, y in enumerate(g):
            rows[i + j] = rows[i + j] + x * y
    return _trimmed(rows)


def _exactly(x: fmpq_poly, divisor: fmpq_poly) -> fmpq_poly:
    quotient, rest = divmod(x, divisor)
    if rest:
        raise ClaimError("a common point that is not simple", remedy=REMEDY)
    return quotient


def _elimination(f: Rows, g: Rows) -> _Elimination:
    if not f or not g:
        raise ClaimError("curves on one line parallel to an axis", remedy=REMEDY)
    of_resultant, of_line = _subresultant(f, g, 0), _subresultant(f, g, 1)
    constant, line = (_combined(cofactors, f, g) for cofactors in (of_resultant, of_line))
    if len(constant) != 1 or len(line) != 2:
        raise ClaimError("curves with arcs in common, or no combination of degree 1", remedy=REMEDY)
    exponent = max(len(f), len(g)) - 1
    others = (_by_line(p, line, constant[0], exponent) for p in (f, g))
    return _Elimination(constant[0], line[1], line[0], exponent, (of_resultant, of_line, *others))


def _combined(cofactors: tuple[Rows, Rows], f: Rows, g: Rows) -> Rows:
    one = fmpq_poly([1])
    return _sum(_product(cofactors[0], f), _product(cofactors[1], g), one, one)


def _subresultant(f: Rows, g: Rows, j: int) -> tuple[Rows, Rows]:
    """The cofactors of a combination of degree j: the determinant of multiples of f and g by powers of s, their
    coefficients above ``sʲ`` in all columns but the last one, by its last column.
    """
    m, n, one = len(f) - 1, len(g) - 1, [fmpq_poly([1])]
    if j in (m, n):
        return (one, []) if m == j else ([], one)
    zero, powers = fmpq_poly([]), range(j + 1, m + n - j)
    rows = [[zero] * i + p for p, count in ((f, n - j), (g, m - j)) for i in range(count)]
    matrix = [[row[k] if k < len(row) else zero for k in powers] for row in rows]
    minors = [
        rational_determinant(matrix[:i] + matrix[i + 1 :]) * (-1 if (len(rows) - 1 - i) % 2 else 1)
        for i in range(len(rows))
    ]
    return _trimmed(minors[: n - j]), _trimmed(minors[n - j :])


def rational_determinant(matrix: Sequence[Rows]) -> fmpq_poly:
    """Over one denominator, by the integers of the numerators."""
    entries = [x for row in matrix for x in row]
    bottom = lcm(*[int(x.denom()) for x in entries])
    whole = [[(x * bottom).numer() for x in row] for row in matrix]
    numerator = fmpq_poly(determinant(whole, max((x.degree() for x in entries), default=0)))
    return numerator * to_fmpq(mpq(1, bottom ** len(matrix)))


def _by_line(p: Rows, line: Rows, resultant: fmpq_poly, exponent: int) -> tuple[Rows, Rows]:
    """A power of the slope times p as a combination of the line and the resultant."""
    quotient, rest = list[fmpq_poly](), [x * line[1] ** exponent for x in p]
    while len(rest) > 1:
        own = [fmpq_poly([])] * (len(rest) - 2) + [_exactly(rest[-1], line[1])]
        rest = _sum(rest, _product(own, line), fmpq_poly([1]), fmpq_poly([-1]))
        quotient = _sum(quotient, own, fmpq_poly([1]), fmpq_poly([1]))
    return quotient, [_exactly(x, resultant) for x in rest]


# ---- places


def _places(found: _Elimination, first: Interval, second: Interval) -> tuple[list[Cell], list[_BoxedPoint]]:
    """Cells of the resultant, so narrow that each of its zeros has a place, and these places."""
    search = Search(cells_of(found.eliminant, *second), depth_first=True)
    cells, places = list[Cell](), list[_BoxedPoint]()
    for cell in search:
        place = None
        if cell.one and (place := _place(found, first, Interval(cell.low, cell.high))) is None:
            if search.depth == DEPTH:
                raise DomainError("the place of a zero is not decided", remedy=REMEDY)
            halves = Interval(cell.low, cell.high).halves
            search.split([c for a, b in halves for c in cells_of(found.eliminant, a, b)])
            continue
        cells.append(cell)
        places += _at_point(found, first, cell.low)
        places += [] if place is None else [place]
    return cells, places + _at_point(found, first, second.high)


def _at_point(found: _Elimination, first: Interval, t: mpq) -> list[_BoxedPoint]:
    """The place of a zero, if its parameter is rational."""
    if found.eliminant(to_fmpq(t)) != 0:
        return []
    a, b = (from_flint(p(to_fmpq(t))) for p in (found.slope, found.offset))
    if a == 0:
        raise ClaimError("a point through which a curve passes several times", remedy=REMEDY)
    s = -b / a
    inside = Interval.point(s) if first.low <= s <= first.high else None
    return [_BoxedPoint(Interval.point(t), inside, a > 0, s > first.high)]


def _place(found: _Elimination, first: Interval, second: Interval) -> _BoxedPoint | None:
    """The place of the zero in an interval, if forms have one sign there."""
    sign = one_sign(found.slope, *second)
    if sign is None:
        return None
    if one_sign(_line_at(found, first.low), *second) == sign:
        return _BoxedPoint(second, None, sign)
    if one_sign(_line_at(found, first.high), *second) == (not sign):
        return _BoxedPoint(second, None, sign, above=True)
    t = to_fmpq(second.middle)
    if not found.slope(t):
        return None
    middle, width = from_flint(-found.offset(t) / found.slope(t)), first.width / (1 << WIDTH)
    middle = first.low + (middle - first.low) / width // 1 * width
    box = Interval(max(first.low, middle - width), min(first.high, middle + 2 * width))
    signs = [one_sign(_line_at(found, s), *second) for s in box]
    return _BoxedPoint(second, box, sign) if box.low < box.high and signs == [not sign, sign] else None


def _line_at(found: _Elimination, s: mpq) -> fmpq_poly:
    return found.slope * to_fmpq(s) + found.offset


# ---- text


def _interval(side: Interval) -> str:
    return f"({_number_in_q(side.low)}, {_number_in_q(side.high)})"


def _rows(rows: Iterable[fmpq_poly]) -> str:
    return "[" + "; ".join(map(_coefficients_text, rows)) + "]"


def _elimination_text(found: _Elimination) -> str:
    names = ("of_resultant", "of_line", "first_form", "second_form")
    pairs = (f"{n} := ({_rows(f)}, {_rows(g)})" for n, (f, g) in zip(names, found.combinations, strict=True))
    polynomials = (
        f"{n} := {_coefficients_text(p)}"
        for n, p in (("resultant", found.eliminant), ("slope", found.slope), ("offset", found.offset))
    )
    own = ";\n  ".join([*polynomials, f"exponent := {found.exponent}", *pairs])
    return f"Definition the_elimination : elimination := {{|\n  {own}\n|}}.\n"


def _place_text(place: _BoxedPoint) -> str:
    if place.first is None:
        return f"Outside {_boolean(place.sign)} {_boolean(place.above)}"
    return f"Inside {_boolean(place.sign)} ({_number_in_q(place.first.low)}) ({_number_in_q(place.first.high)})"
