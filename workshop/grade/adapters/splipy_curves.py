"""splipy: `Curve` over a `BSplineBasis`."""

from __future__ import annotations

from typing import Any

from workshop.grade.adapters.common import Adapter, Given, floats
from workshop.grade.data import Rows


class Splipy(Adapter):
    """``curve(t)``, ``derivative``, ``curvature``, ``torsion``, ``insert_knot``, ``raise_order``, ``split``."""

    name = "splipy"

    def _curve(self, given: Given) -> Any:
        import splipy

        basis = splipy.BSplineBasis(given.degree + 1, given.knots)
        if given.weights is None:
            return splipy.Curve(basis, given.points)
        return splipy.Curve(basis, given.homogeneous, rational=True, raw=True)

    def _rows(self, curve: Any) -> Rows:
        points = curve.controlpoints
        if not curve.rational:
            return [floats(p) for p in points]
        return [[*floats(p[:-1] / p[-1]), float(p[-1] / points[0][-1])] for p in points]

    def value(self, given: Given) -> list[float]:
        """``curve(t)``."""
        return floats(self._curve(given)(given.t))

    def first(self, given: Given) -> list[float]:
        """``curve.derivative(t)``."""
        return floats(self._curve(given).derivative(given.t))

    def second(self, given: Given) -> list[float]:
        """``curve.derivative(t, 2)``."""
        return floats(self._curve(given).derivative(given.t, 2))

    def tangent(self, given: Given) -> list[float]:
        """``curve.tangent(t)``."""
        return floats(self._curve(given).tangent(given.t))

    def curvature(self, given: Given) -> list[float]:
        """``curve.curvature(t)``."""
        return [abs(float(self._curve(given).curvature(given.t)))]

    def torsion(self, given: Given) -> list[float]:
        """``curve.torsion([t])``; of a single t it is (v × a) · a, which is 0 for every curve."""
        return floats(self._curve(given).torsion([given.t]).ravel())

    def insert(self, given: Given) -> Rows:
        """``curve.insert_knot(t)``."""
        curve = self._curve(given)
        curve.insert_knot(given.t)
        return self._rows(curve)

    def elevate(self, given: Given) -> Rows:
        """``curve.raise_order(1)``."""
        curve = self._curve(given)
        curve.raise_order(1)
        return self._rows(curve)

    def split(self, given: Given) -> Rows:
        """``curve.split(t)``."""
        return [row for part in self._curve(given).split(given.t) for row in self._rows(part)]


ADAPTER = Splipy
