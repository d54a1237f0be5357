"""svgelements: quadratic and cubic segments."""

from __future__ import annotations

from typing import Any

from workshop.grade.adapters.common import Adapter, Given


class SvgElements(Adapter):
    """``CubicBezier`` and ``QuadraticBezier``."""

    name = "svgelements"

    def can(self, question: str, given: Given) -> bool:
        """Segments of degree 2 and 3 in the plane."""
        usual = given.weights is None and given.dimension == 2 and given.degree in (2, 3)
        return super().can(question, given) and usual and given.is_bezier

    def _segment(self, given: Given) -> Any:
        from svgelements import CubicBezier, QuadraticBezier

        return (CubicBezier if given.degree == 3 else QuadraticBezier)(*[complex(*p) for p in given.points])

    def value(self, given: Given) -> list[float]:
        """``segment.point(t)``."""
        point = self._segment(given).point(given.t)
        return [float(point.x), float(point.y)]

    def box(self, given: Given) -> list[float]:
        """``segment.bbox()``."""
        x0, y0, x1, y1 = self._segment(given).bbox()
        return [float(x) for x in (x0, x1, y0, y1)]

    def length(self, given: Given) -> list[float]:
        """``segment.length(error=1e-9)``."""
        return [float(self._segment(given).length(error=1e-9, min_depth=5))]


ADAPTER = SvgElements
