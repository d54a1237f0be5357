"""The algorithms of lessons as tables of fractions: de Boor's triangle, knot insertion, degree elevation, the
product of two functions. The algorithms that splines use internally (`exactspline.polynomials.bernstein`) are faster;
here every intermediate point can be read, drawn and checked.

Sources: C. de Boor, On calculating with B-splines, J. Approx. Theory 6 (1972) 50-62; M. G. Cox, The numerical
evaluation of B-splines, IMA J. Appl. Math. 10 (1972) 134-149; W. Boehm, Inserting new knots into B-spline curves, CAD
12 (1980) 199-201.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import comb

from exactspline.errors import KnotError, ShapeError, counted, shown
from exactspline.numbers.exact import Number, mpq, rational
from exactspline.one_line import OneLine, short_text
from exactspline.splines.bspline import BSpline
from exactspline.splines.control_points import Point, projected
from exactspline.splines.inputs import MAX_DEGREE
from exactspline.splines.knots import KnotVector
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.refinement import inner
from exactspline.splines.type_checks import curve_of, spline_of

#: A tuple of coordinates: the value of a function, the point of a polynomial curve, or ``(w x, …, w)`` of a rational
#: curve.
Row = tuple[mpq, ...]


@dataclass(frozen=True)
class Triangle:
    """Columns of points; each column after the first is computed from neighbours in the previous one.

    In de Boor's algorithm and knot insertion a column has one point fewer than the previous one: ``columns[r][k] = (1 −
    s) columns[r−1][k] + s columns[r−1][k+1]`` with ``s = ratios[r−1][k]``. In degree elevation a column has one point
    more: ``columns[r][k] = s columns[r−1][k−1] + (1 − s) columns[r−1][k]``, where s is 0 for the first point and 1 for
    the last.
    """

    #: ``de Boor``, ``insertion`` or ``elevation``.
    method: str
    degree: int
    #: The span or the segment to which the points belong.
    span: tuple[mpq, mpq]
    #: The index among the control points of the first point of the first column; −1 for Bézier points of a segment.
    first: int
    columns: tuple[tuple[Row, ...], ...]
    ratios: tuple[tuple[mpq, ...], ...]
    #: Whether the last coordinate is a weight.
    rational: bool
    #: The parameter; None for degree elevation.
    parameter: mpq | None = None
    #: The knots and the control points (rows) of the result, if it is a spline.
    knots: KnotVector | None = None
    made: tuple[Row, ...] = ()

    def __repr__(self) -> str:
        return f"<Triangle of {self.method}: degree {self.degree}>"

    @property
    def tip(self) -> Point:
        """The point at the parameter, in Cartesian coordinates: the only one of the last column of de Boor's triangle.

        Raises `ShapeError` if there is more than one.
        """
        if len(self.columns[-1]) != 1:
            raise ShapeError(
                f"{counted(len(self.columns[-1]), 'point')} in the last column", remedy="take de Boor's triangle"
            )
        return self.cartesian(self.columns[-1][0])

    def cartesian(self, row: Row) -> Point:
        """A row as a control point: divided by its weight if it has one (a `Direction` if the weight is 0)."""
        return projected(row) if self.rational else row


@dataclass(frozen=True, repr=False)
class ProductTable(OneLine):
    """The product of two functions on one segment. For Bézier points multiplied by binomial coefficients it is a
    product of polynomials: the sums along the diagonals of a table.
    """

    span: tuple[mpq, mpq]
    #: The scaled Bézier points ``C(n, i) bᵢ`` of both factors.
    left: tuple[mpq, ...]
    right: tuple[mpq, ...]

    @property
    def table(self) -> tuple[tuple[mpq, ...], ...]:
        """``left[i]·right[k]`` in row i and column k."""
        return tuple(tuple(a * b for b in self.right) for a in self.left)

    @property
    def sums(self) -> tuple[mpq, ...]:
        """The sums of the diagonals i + k = m."""
        degree = len(self.left) + len(self.right) - 2
        rows = list(enumerate(self.table))
        return tuple(
            sum((row[m - i] for i, row in rows if 0 <= m - i < len(self.right)), mpq(0)) for m in range(degree + 1)
        )

    @property
    def points(self) -> tuple[mpq, ...]:
        """The Bézier points of the product: the sums divided by the binomial coefficients of its degree."""
        sums = self.sums
        return tuple(total / comb(len(sums) - 1, m) for m, total in enumerate(sums))


def de_boor_triangle(curve: Nurbs | BSpline, t: Number) -> Triangle:
    """Return de Boor's triangle at a parameter. The tip of the triangle is the point of the curve (at a jump, the limit
    from the right).

    >>> triangle = de_boor_triangle(BSpline(2, [0, 0, 0, 1, 2, 2, 2], [0, 4, 8, 2]), "1/2")
    >>> triangle.columns[1], triangle.ratios, triangle.tip
    (((mpq(2,1),), (mpq(5,1),)), ((mpq(1,2), mpq(1,4)), (mpq(1,2),)), (mpq(7,2),))

    Raises `DomainError` outside the domain.
    """
    _expected(curve)
    parameter = rational(t)
    curve.mesh.locate(parameter)
    return _downwards(curve, parameter, "de Boor", curve.degree)


def insertion_triangle(curve: Nurbs | BSpline, t: Number, times: int = 1) -> Triangle:
    """Return the triangle of Boehm's insertion of a knot: `times` columns of de Boor's triangle. The edges of the
    triangle are the new control points (`Triangle.made`, over `Triangle.knots`); the other control points do not
    change.

    >>> triangle = insertion_triangle(BSpline.bezier([0, 2, 4, 0]), "1/2")
    >>> [row[0] for row in triangle.made] == list(BSpline.bezier([0, 2, 4, 0]).insert_knot("1/2").control_points)
    True

    Raises `DomainError` unless the parameter is inside the domain, `KnotError` if its multiplicity would exceed the
    degree.
    """
    _expected(curve)
    parameter, degree = inner(curve.mesh, t), curve.degree
    present = curve.knots.multiplicity(parameter)
    if type(times) is not int or times < 1 or present + times > degree:
        times_text = counted(times, "time") if type(times) is int else shown(times)
        raise KnotError(
            f"the knot {short_text(parameter)} of multiplicity {present} inserted {times_text}",
            remedy=f"insert it at least once; its multiplicity may reach the degree {degree}",
            knot=parameter,
        )
    return _downwards(curve, parameter, "insertion", times)


def elevation_triangles(curve: Nurbs | BSpline, by: int = 1) -> tuple[Triangle, ...]:
    """Return one triangle per segment, whose columns are the Bézier points of the degrees n, n + 1, n + 2, ….

    >>> (triangle,) = elevation_triangles(BSpline.bezier([0, 3]), 2)
    >>> [[str(row[0]) for row in column] for column in triangle.columns]
    [['0', '3'], ['0', '3/2', '3'], ['0', '1', '2', '3']]
    >>> triangle.columns[-1] == tuple((b,) for b in BSpline.bezier([0, 3]).elevate_degree(2).control_points)
    True

    Raises `ShapeError` for a number of steps below 1.
    """
    _expected(curve)
    if type(by) is not int or not 1 <= by <= MAX_DEGREE:
        raise ShapeError(f"degree elevation by {shown(by)}", remedy=f"an integer from 1 to {MAX_DEGREE}")
    splines, has_weight = _splines(curve)
    breaks = curve.breakpoints
    return tuple(
        _upwards(tuple(zip(*[f.bezier_points[i] for f in splines], strict=True)), (a, b), by, has_weight)
        for i, (a, b) in enumerate(pairwise(breaks))
    )


def product_tables(left: BSpline, right: BSpline) -> tuple[ProductTable, ...]:
    """Return the multiplication tables of two functions, one table per segment of the product.

    >>> t = BSpline.identity(0, 1)
    >>> (table,) = product_tables(t, t)
    >>> table.sums, table.points == (t * t).control_points
    ((mpq(0,1), mpq(0,1), mpq(1,1)), True)

    Raises `DomainError` if their domains differ.
    """
    mesh = spline_of(left).mesh.union(spline_of(right).mesh)

    def scaled(f: BSpline, a: mpq, b: mpq) -> tuple[mpq, ...]:
        (points,) = f.restrict(a, b).bezier_points
        return tuple(comb(f.degree, i) * x for i, x in enumerate(points))

    return tuple(ProductTable((a, b), scaled(left, a, b), scaled(right, a, b)) for a, b in pairwise(mesh.breaks))


def _expected(curve: Nurbs | BSpline) -> Nurbs | BSpline:
    return curve if isinstance(curve, BSpline) else curve_of(curve)


def _splines(curve: Nurbs | BSpline) -> tuple[list[BSpline], bool]:
    """The coordinates, with the weight of a rational curve, and whether there is a weight."""
    if isinstance(curve, BSpline):
        return [curve], False
    curve = curve_of(curve)
    return ([*curve.p] if curve.polynomial else [*curve.p, curve.w]), not curve.polynomial


def _downwards(curve: Nurbs | BSpline, t: mpq, method: str, steps: int) -> Triangle:
    n, knots, (splines, has_weight) = curve.degree, curve.knots, _splines(curve)
    rows = tuple(zip(*[f.control_points for f in splines], strict=True))
    # the last nonempty span that begins at or before the parameter: the last span at the end of the domain
    j = max(i for i in range(n, len(rows)) if knots[i] <= t and knots[i] < knots[i + 1])
    columns, ratios = [rows[j - n : j + 1]], []
    for r in range(1, steps + 1):
        shares = tuple((t - knots[i]) / (knots[i + n + 1 - r] - knots[i]) for i in range(j - n + r, j + 1))
        above = columns[-1]
        columns.append(tuple(_between(s, a, b) for s, a, b in zip(shares, above[:-1], above[1:], strict=True)))
        ratios.append(shares)
    made: tuple[Row, ...] = ()
    if method == "insertion":
        upper, lower = [c[0] for c in columns[1:-1]], [c[-1] for c in columns[-2:0:-1]]
        made = (*rows[: j - n + 1], *upper, *columns[-1], *lower, *rows[j:])
    finer = knots.insert(t, steps) if made else None
    span = (knots[j], knots[j + 1])
    return Triangle(method, n, span, j - n, tuple(columns), tuple(ratios), has_weight, t, finer, made)


def _upwards(points: tuple[Row, ...], span: tuple[mpq, mpq], by: int, has_weight: bool) -> Triangle:
    columns, ratios = [points], []
    for _ in range(by):
        above = columns[-1]
        size = len(above)
        shares = tuple(mpq(k, size) for k in range(size + 1))
        # the first and the last point have a neighbour only on one side
        pairs = zip((above[0], *above), (*above, above[-1]), strict=True)
        columns.append(tuple(_between(1 - s, a, b) for s, (a, b) in zip(shares, pairs, strict=True)))
        ratios.append(shares)
    return Triangle("elevation", len(points) - 1, span, -1, tuple(columns), tuple(ratios), has_weight)


def _between(s: mpq, a: Sequence[mpq], b: Sequence[mpq]) -> Row:
    return tuple((1 - s) * x + s * y for x, y in zip(a, b, strict=True))
