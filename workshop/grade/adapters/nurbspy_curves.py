"""nurbspy: `NurbsCurve`."""

from __future__ import annotations

from typing import Any

from workshop.grade.adapters.common import Adapter, Given, floats


class Nurbspy(Adapter):
    """``get_value``, ``get_derivative``, ``get_tangent``, ``get_curvature``, ``get_torsion``."""

    name = "nurbspy"

    def _curve(self, given: Given) -> Any:
        import numpy as np
        import nurbspy

        weights = np.array(given.weights or [1] * len(given.points), dtype=float)
        points = np.array(given.points, dtype=float).T
        return nurbspy.NurbsCurve(
            control_points=points, weights=weights, degree=given.degree, knots=np.array(given.knots, dtype=float)
        )

    def value(self, given: Given) -> list[float]:
        """``curve.get_value(t)``."""
        return floats(self._curve(given).get_value(given.t)[:, 0])

    def first(self, given: Given) -> list[float]:
        """``curve.get_derivative(t, 1)``."""
        return floats(self._curve(given).get_derivative(given.t, 1)[:, 0])

    def second(self, given: Given) -> list[float]:
        """``curve.get_derivative(t, 2)``."""
        return floats(self._curve(given).get_derivative(given.t, 2)[:, 0])

    def tangent(self, given: Given) -> list[float]:
        """``curve.get_tangent(t)``."""
        return floats(self._curve(given).get_tangent(given.t)[:, 0])

    def curvature(self, given: Given) -> list[float]:
        """``curve.get_curvature(t)``."""
        return [abs(float(self._curve(given).get_curvature(given.t)[0]))]

    def torsion(self, given: Given) -> list[float]:
        """``curve.get_torsion(t)``."""
        return [float(self._curve(given).get_torsion(given.t)[0])]

    def nearest(self, given: Given) -> list[float]:
        """``curve.project_point_to_curve(point)``."""
        import numpy as np

        curve, point = self._curve(given), np.array(given.point, dtype=float)
        u = curve.project_point_to_curve(point)
        return [float(np.linalg.norm(curve.get_value(u)[:, 0] - point))]


ADAPTER = Nurbspy
