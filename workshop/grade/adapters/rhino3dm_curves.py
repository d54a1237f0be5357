"""rhino3dm (openNURBS): `NurbsCurve` in space; plane curves at z = 0."""

from __future__ import annotations

from typing import Any

from workshop.grade.adapters.common import Given, IncreasingDegree
from workshop.grade.data import Rows


class Rhino3dm(IncreasingDegree):
    """``PointAt``, ``DerivativeAt``, ``TangentAt``, ``CurvatureAt``, ``IncreaseDegree``, ``Split``."""

    name = "rhino3dm"

    def _curve(self, given: Given) -> Any:
        import rhino3dm

        weights = given.weights or [1] * len(given.points)
        curve = rhino3dm.NurbsCurve(3, given.weights is not None, given.degree + 1, len(given.points))
        for i, (p, w) in enumerate(zip(given.points, weights, strict=True)):
            x, y, z = (*p, 0)[:3]
            curve.Points[i] = rhino3dm.Point4d(x * w, y * w, z * w, w)
        # openNURBS leaves out the first and the last knot
        for i, t in enumerate(given.knots[1:-1]):
            curve.Knots[i] = t
        return curve

    def _triple(self, v: Any, given: Given) -> list[float]:
        return [float(v.X), float(v.Y), float(v.Z)][: given.dimension]

    def _rows(self, curve: Any, given: Given) -> Rows:
        points = [curve.Points[i] for i in range(len(curve.Points))]
        if given.weights is None:
            return [self._triple(p, given) for p in points]
        return [[*(x / p.W for x in self._triple(p, given)), p.W / points[0].W] for p in points]

    def value(self, given: Given) -> list[float]:
        """``curve.PointAt(t)``."""
        return self._triple(self._curve(given).PointAt(given.t), given)

    def first(self, given: Given) -> list[float]:
        """``curve.DerivativeAt(t, 1)[1]``."""
        return self._triple(self._curve(given).DerivativeAt(given.t, 1)[1], given)

    def second(self, given: Given) -> list[float]:
        """``curve.DerivativeAt(t, 2)[2]``."""
        return self._triple(self._curve(given).DerivativeAt(given.t, 2)[2], given)

    def tangent(self, given: Given) -> list[float]:
        """``curve.TangentAt(t)``."""
        return self._triple(self._curve(given).TangentAt(given.t), given)

    def curvature(self, given: Given) -> list[float]:
        """The length of ``curve.CurvatureAt(t)``."""
        v = self._curve(given).CurvatureAt(given.t)
        return [float((v.X**2 + v.Y**2 + v.Z**2) ** 0.5)]

    def split(self, given: Given) -> Rows:
        """``curve.Split(t)``."""
        return [row for part in self._curve(given).Split(given.t) for row in self._rows(part, given)]


ADAPTER = Rhino3dm
