"""bezier: polynomial Bézier curves of every degree."""

from __future__ import annotations

from typing import Any

from workshop.grade.adapters.common import Adapter, Given, floats, rows
from workshop.grade.data import Rows


class Bezier(Adapter):
    """``bezier.Curve``, and the curvature of its documented helpers."""

    name = "bezier"

    def can(self, question: str, given: Given) -> bool:
        """One polynomial segment; curvature and intersection in the plane."""
        flat = given.dimension == 2 or question not in ("curvature", "roots", "meetings")
        return super().can(question, given) and given.is_bezier and given.weights is None and flat

    def _nodes(self, given: Given) -> Any:
        import numpy as np

        return np.asfortranarray(np.array(given.points, dtype=float).T)

    def _curve(self, given: Given) -> Any:
        import bezier

        return bezier.Curve(self._nodes(given), degree=given.degree)

    def value(self, given: Given) -> list[float]:
        """``curve.evaluate(t)``."""
        return floats(self._curve(given).evaluate(given.t)[:, 0])

    def first(self, given: Given) -> list[float]:
        """``curve.evaluate_hodograph(t)``."""
        return floats(self._curve(given).evaluate_hodograph(given.t)[:, 0])

    def curvature(self, given: Given) -> list[float]:
        """``bezier.hazmat.curve_helpers.get_curvature``."""
        from bezier.hazmat import curve_helpers

        tangent = self._curve(given).evaluate_hodograph(given.t)
        return [abs(float(curve_helpers.get_curvature(self._nodes(given), tangent, given.t)))]

    def elevate(self, given: Given) -> Rows:
        """``curve.elevate()``."""
        return rows(self._curve(given).elevate().nodes.T)

    def split(self, given: Given) -> Rows:
        """``curve.specialize(0, t)`` and ``curve.specialize(t, 1)``."""
        curve = self._curve(given)
        return [row for a, b in ((0, given.t), (given.t, 1)) for row in rows(curve.specialize(a, b).nodes.T)]

    def length(self, given: Given) -> list[float]:
        """``curve.length``."""
        return [float(self._curve(given).length)]

    def roots(self, given: Given) -> list[list[float]]:
        """``curve.intersect(line)`` with a line along y = 0 that extends beyond the control points."""
        import bezier
        import numpy as np

        xs = [p[0] for p in given.points]
        line = bezier.Curve(np.asfortranarray([[min(xs) - 1.0, max(xs) + 1.0], [0.0, 0.0]]), degree=1)
        return [floats(self._curve(given).intersect(line)[0])]

    def meetings(self, given: Given) -> Rows:
        """``curve.intersect(other)``."""
        curve, other = self.pair(given, self._curve)
        return rows(curve.intersect(other).T)


ADAPTER = Bezier
