"""scipy: `BSpline` and `PPoly`; polynomial curves."""

from __future__ import annotations

from math import isnan
from typing import Any

from workshop.grade.adapters.common import Adapter, Given, floats, rows
from workshop.grade.data import Rows


class SciPy(Adapter):
    """``scipy.interpolate.BSpline``, and ``PPoly`` for zeros."""

    name = "scipy"

    def can(self, question: str, given: Given) -> bool:
        """Polynomial curves."""
        return super().can(question, given) and given.weights is None

    def _spline(self, given: Given, column: int | None = None) -> Any:
        import numpy as np
        from scipy.interpolate import BSpline

        c = np.array(given.points, dtype=float)
        return BSpline(np.array(given.knots, dtype=float), c if column is None else c[:, column], given.degree)

    def value(self, given: Given) -> list[float]:
        """``spline(t)``."""
        return floats(self._spline(given)(given.t))

    def first(self, given: Given) -> list[float]:
        """``spline(t, nu=1)``."""
        return floats(self._spline(given)(given.t, nu=1))

    def second(self, given: Given) -> list[float]:
        """``spline(t, nu=2)``."""
        return floats(self._spline(given)(given.t, nu=2))

    def insert(self, given: Given) -> Rows:
        """``spline.insert_knot(t)``."""
        return rows(self._spline(given).insert_knot(given.t).c)

    def _zeros(self, spline: Any) -> list[float]:
        from scipy.interpolate import PPoly

        # for an interval on which it vanishes scipy gives the start and then NaN
        roots = PPoly.from_spline(spline).roots(extrapolate=False)
        return [float(x) for x in roots if not isnan(x)]

    def roots(self, given: Given) -> list[list[float]]:
        """``PPoly.from_spline(spline).roots(extrapolate=False)``."""
        return [self._zeros(self._spline(given, 1))]

    def turns(self, given: Given) -> list[list[float]]:
        """The roots of ``spline.derivative()``."""
        return [self._zeros(self._spline(given, axis).derivative()) for axis in range(given.dimension)]


ADAPTER = SciPy
