"""svgpathtools: quadratic and cubic segments, and paths of them."""

from __future__ import annotations

from typing import Any

from workshop.grade.adapters.common import Adapter, Given, rows
from workshop.grade.data import Rows


def _coincide(given: Given) -> bool:
    """Whether all control points are within 2⁻⁸ of the size from those of the partner."""
    assert given.partner is not None
    points = list(zip(given.points, given.partner.points, strict=True))
    size = max(abs(x) for p, _ in points for x in p)
    return all(abs(x - y) <= size / 256 for p, q in points for x, y in zip(p, q, strict=True))


def _pair(z: complex) -> list[float]:
    return [float(z.real), float(z.imag)]


class SvgPathTools(Adapter):
    """``CubicBezier``, ``QuadraticBezier``, ``Path``."""

    name = "svgpathtools"

    def can(self, question: str, given: Given) -> bool:
        """Segments of degree 2 and 3 in the plane; contours for the area.

        Not pairs that nearly coincide: ``intersect`` is documented to fail where segments coincide, and halves such
        ones without end.
        """
        if question == "meetings" and _coincide(given):
            return False
        fits = given.degree == 3 and not given.is_bezier if question == "area" else given.is_bezier
        usual = given.weights is None and given.dimension == 2 and given.degree in (2, 3)
        return super().can(question, given) and usual and fits

    def _segment(self, given: Given) -> Any:
        from svgpathtools import CubicBezier, QuadraticBezier

        return (CubicBezier if given.degree == 3 else QuadraticBezier)(*[complex(*p) for p in given.points])

    def value(self, given: Given) -> list[float]:
        """``segment.point(t)``."""
        return _pair(self._segment(given).point(given.t))

    def first(self, given: Given) -> list[float]:
        """``segment.derivative(t)``."""
        return _pair(self._segment(given).derivative(given.t))

    def second(self, given: Given) -> list[float]:
        """``segment.derivative(t, n=2)``."""
        return _pair(self._segment(given).derivative(given.t, n=2))

    def tangent(self, given: Given) -> list[float]:
        """``segment.unit_tangent(t)``."""
        return _pair(self._segment(given).unit_tangent(given.t))

    def curvature(self, given: Given) -> list[float]:
        """``segment.curvature(t)``."""
        return [abs(float(self._segment(given).curvature(given.t)))]

    def split(self, given: Given) -> Rows:
        """``segment.split(t)``."""
        return [_pair(z) for part in self._segment(given).split(given.t) for z in part.bpoints()]

    def box(self, given: Given) -> list[float]:
        """``segment.bbox()``."""
        return [float(x) for x in self._segment(given).bbox()]

    def length(self, given: Given) -> list[float]:
        """``segment.length()``."""
        return [float(self._segment(given).length())]

    def nearest(self, given: Given) -> list[float]:
        """``segment.radialrange(point)``."""
        return [float(self._segment(given).radialrange(complex(*given.point))[0][0])]

    def meetings(self, given: Given) -> Rows:
        """``segment.intersect(other)``."""
        segment, other = self.pair(given, self._segment)
        return rows(segment.intersect(other))

    def area(self, given: Given) -> list[float]:
        """``Path(…).area()``."""
        from svgpathtools import CubicBezier, Path

        z = [complex(*p) for p in given.points]
        return [float(Path(*[CubicBezier(*z[i : i + 4]) for i in range(0, len(z) - 1, 3)]).area())]


ADAPTER = SvgPathTools
