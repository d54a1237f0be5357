"""The concrete curve: degree, knots, control points, weights, and the operands ``p``, ``w``, ``gamma`` that formulas
ask for.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from gmpy2 import mpq

from exactspline.errors import NumberError, ShapeError, WeightError, shown
from exactspline.exact import rational, text
from exactspline.language.arguments import Curve
from exactspline.language.vector import Vector
from exactspline.splines.bernstein import rescaled, zero_on_segment
from exactspline.splines.bspline import BSpline, checked_degree
from exactspline.splines.knots import KnotVector


class Nurbs(Curve):
    """A polynomial or rational B-spline curve with exact data.

    `control_points` are Cartesian, all of one dimension; `weights` are optional. Equal weights mean that the curve is
    polynomial: then ``w`` is the constant 1 of degree 0 and ``gamma`` the vector ``p``, and `polynomial` says so.
    Otherwise ``gamma`` is the `Rational` ``p/w``.

    >>> arc = Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], weights=[1, 1, 2])
    >>> arc("1/2"), arc.polynomial
    ((mpq(3,5), mpq(4,5)), False)

    Raises `ShapeError`, `KnotError`, `NumberError` with the place at fault, and `WeightError` when the denominator has
    a zero on the domain, with the parameter (or an interval around it) as witness.
    """

    degree: int
    knots: KnotVector
    control_points: tuple[tuple[mpq, ...], ...]
    weights: tuple[mpq, ...]
    #: What `exactspline.geometry.analyse` knows of the curve, set once: no part of its value.
    _analysis: Any = None

    def __init__(
        self,
        degree: int,
        knots: Iterable[Any],
        control_points: Iterable[Iterable[Any]],
        weights: Iterable[Any] | None = None,
        *,
        name: str = "",
        source: str = "",
        note: str = "",
    ) -> None:
        points = _points(control_points)
        exact_weights = (mpq(1),) * len(points) if weights is None else _row(weights, "weights")
        if len(exact_weights) != len(points):
            raise ShapeError(
                f"{len(exact_weights)} weights for {len(points)} control points",
                where="weights",
                remedy="give one weight a control point",
            )
        self.name, self.source, self.note = name, source, note
        self._set(checked_degree(degree), KnotVector(knots), points, exact_weights)

    @classmethod
    def from_homogeneous(
        cls, degree: int, knots: Iterable[Any], points: Iterable[Iterable[Any]], *, name: str = "", source: str = ""
    ) -> Nurbs:
        """The curve by homogeneous control points ``(w x, w y, …, w)``; a point with w = 0 is a control vector.

        >>> Nurbs.from_homogeneous(1, [0, 0, 1, 1], [(2, 4, 2), (0, 3, 1)]).control_points
        ((mpq(1,1), mpq(2,1)), (mpq(0,1), mpq(3,1)))
        """
        rows = _points(points, least=3)
        curve = cls.__new__(cls)
        curve.name, curve.source, curve.note = name, source, ""
        weights = tuple(row[-1] for row in rows)
        cartesian = tuple(tuple(x / row[-1] if row[-1] else x for x in row[:-1]) for row in rows)
        curve._set(checked_degree(degree), KnotVector(knots), cartesian, weights)
        return curve

    def _set(
        self, degree: int, knots: KnotVector, points: tuple[tuple[mpq, ...], ...], weights: tuple[mpq, ...]
    ) -> None:
        self.degree, self.knots, self.control_points, self.weights = degree, knots, points, weights
        polynomial = len(set(weights)) == 1 and weights[0] != 0
        knots.check(degree)
        if len(points) != len(knots) - degree - 1:
            raise ShapeError(
                f"{len(points)} control points for {len(knots)} knots of degree {degree}",
                where="control_points",
                remedy=f"there must be {len(knots) - degree - 1} (knots − degree − 1)",
            )
        lifted = [tuple(x if polynomial else x * (w or 1) for x in row) for row, w in zip(points, weights, strict=True)]
        rows = [*zip(*lifted, strict=True), *([] if polynomial else [weights])]
        splines = _shared(BSpline(degree, knots, row) for row in rows)
        w = splines[0].constant(1) if polynomial else splines.pop()
        _check_weight(w)
        super().__init__(Vector(*splines), w, polynomial=polynomial)

    def __call__(self, t: Any, side: str = "right") -> tuple[mpq, ...]:
        """The exact point at a parameter (at a jump the limit from the right, or from the `side` asked for)."""
        w = self.w(t, side)
        return tuple(x(t, side) / w for x in self.p)

    @property
    def domain(self) -> tuple[mpq, mpq]:
        """The parameter interval."""
        domain: tuple[mpq, mpq] = self.w.domain
        return domain

    @property
    def breakpoints(self) -> tuple[mpq, ...]:
        """The distinct knots of the domain, ends included."""
        breaks: tuple[mpq, ...] = self.w.breakpoints
        return breaks

    @property
    def segments(self) -> int:
        """Number of polynomial or rational segments."""
        return len(self.w.mesh)

    @property
    def closed(self) -> bool:
        """Whether the ends agree exactly."""
        a, b = self.domain
        return self(a) == self(b, "left")

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in self.__dict__.items() if name != "_analysis"}

    def __repr__(self) -> str:
        kind = "polynomial" if self.polynomial else "rational"
        return (
            f"<Nurbs {self.name or 'curve'}: {kind}, degree {self.degree}, {len(self.control_points)} "
            f"control points in R{self.dimension}>"
        )


def _row(values: Iterable[Any], place: str) -> tuple[mpq, ...]:
    exact = []
    for i, value in enumerate(values):
        try:
            exact.append(rational(value))
        except NumberError as error:
            raise error.at(f"{place}[{i}]") from None
    return tuple(exact)


def _points(rows: Iterable[Iterable[Any]], least: int = 2) -> tuple[tuple[mpq, ...], ...]:
    points = []
    for i, row in enumerate(rows):
        if isinstance(row, str) or not isinstance(row, Iterable):
            raise ShapeError(
                f"{shown(row)} is no point", where=f"control_points[{i}]", remedy="write a list of coordinates"
            )
        points.append(_row(row, f"control_points[{i}]"))
    if not points:
        raise ShapeError("no control points", where="control_points", remedy="give at least degree + 1")
    for i, point in enumerate(points):
        if len(point) != len(points[0]):
            raise ShapeError(
                f"{len(point)} coordinates where control_points[0] has {len(points[0])}",
                where=f"control_points[{i}]",
                remedy="use one dimension",
            )
        if len(point) < least:
            raise ShapeError(
                f"{len(point)} coordinates", where=f"control_points[{i}]", remedy=f"at least {least} are needed"
            )
    return tuple(points)


def _shared(splines: Iterable[BSpline]) -> list[BSpline]:
    """The components of one curve over one mesh and, segment by segment, over one denominator, so that sums stay
    cheap.
    """
    splines = list(splines)
    mesh, continuity = splines[0].mesh, splines[0].continuity
    columns = []
    for forms in zip(*[s.forms for s in splines], strict=True):
        common = forms[0][1]
        for _, m in forms[1:]:
            common = common * (m // common.gcd(m))
        columns.append([rescaled(form, common) for form in forms])
    shared = []
    for s, forms in zip(splines, zip(*columns, strict=True), strict=True):
        one = BSpline.from_forms(s.degree, mesh, continuity, forms, s.provenance)
        one._knots, one._points = s._knots, s._points
        shared.append(one)
    return shared


def _check_weight(w: BSpline) -> None:
    sign: mpq | None = None
    for i, (c, _) in enumerate(w.forms):
        a, b = w.breakpoints[i : i + 2]
        witness = zero_on_segment(c, w.degree)
        if witness is not None:
            low, high = (a + (b - a) * t for t in witness)
            place = (
                f"at the parameter {text(low)}"
                if low == high
                else f"between the parameters {text(low)} and {text(high)}"
            )
            raise WeightError(
                f"the denominator w has a zero {place}",
                where="weights",
                remedy="w must keep its sign on the domain",
                witness=(low, high),
            )
        value = w((a + b) / 2)
        if sign is not None and sign * value < 0:
            raise WeightError(
                f"the denominator w changes sign by a jump at the parameter {text(a)}",
                where="weights",
                remedy="w must keep its sign on the domain",
                witness=(a, a),
            )
        sign = value


def weight_sequence(curve: Nurbs) -> Sequence[mpq]:
    """The weights, all one for a polynomial curve."""
    return (mpq(1),) * len(curve.weights) if curve.polynomial else curve.weights
