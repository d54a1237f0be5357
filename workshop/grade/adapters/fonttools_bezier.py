"""fontTools: `misc.bezierTools` and `pens.areaPen`; quadratic and cubic segments in the plane."""

from __future__ import annotations

from typing import Any

from workshop.grade.adapters.common import Adapter, Given, rows
from workshop.grade.data import Rows

#: The tolerance at which ``calcCubicArcLength`` stops subdividing. It does not promise an error bound; this fraction of
#: the length is accepted.
TOLERANCE = 0.005


class FontTools(Adapter):
    """The functions of ``fontTools.misc.bezierTools``."""

    name = "fontTools"

    def can(self, question: str, given: Given) -> bool:
        """Segments of degree 2 and 3 in the plane; contours for the area."""
        segment = given.is_bezier and given.degree in (2, 3)
        fits = given.degree == 3 and not given.is_bezier if question == "area" else segment
        return super().can(question, given) and given.weights is None and given.dimension == 2 and fits

    def _points(self, given: Given) -> list[tuple[float, float]]:
        return [(p[0], p[1]) for p in given.points]

    def value(self, given: Given) -> list[float]:
        """``cubicPointAtT`` or ``quadraticPointAtT``."""
        from fontTools.misc import bezierTools

        at = bezierTools.cubicPointAtT if given.degree == 3 else bezierTools.quadraticPointAtT
        return list(map(float, at(*self._points(given), given.t)))

    def split(self, given: Given) -> Rows:
        """``splitCubicAtT`` or ``splitQuadraticAtT``."""
        from fontTools.misc import bezierTools

        at = bezierTools.splitCubicAtT if given.degree == 3 else bezierTools.splitQuadraticAtT
        return [row for part in at(*self._points(given), given.t) for row in rows(part)]

    def box(self, given: Given) -> list[float]:
        """``calcCubicBounds`` or ``calcQuadraticBounds``."""
        from fontTools.misc import bezierTools

        of = bezierTools.calcCubicBounds if given.degree == 3 else bezierTools.calcQuadraticBounds
        x0, y0, x1, y1 = of(*self._points(given))
        return [float(x) for x in (x0, x1, y0, y1)]

    def roots(self, given: Given) -> list[list[float]]:
        """``solveCubic`` or ``solveQuadratic`` of ``calcCubicParameters``, in [0, 1]."""
        from fontTools.misc import bezierTools

        cubic = given.degree == 3
        parameters: Any = (bezierTools.calcCubicParameters if cubic else bezierTools.calcQuadraticParameters)(
            *self._points(given)
        )
        solved = (bezierTools.solveCubic if cubic else bezierTools.solveQuadratic)(*[c[1] for c in parameters])
        return [[float(t) for t in solved if 0 <= t <= 1]]

    def length(self, given: Given) -> list[float]:
        """``calcCubicArcLength`` or ``calcQuadraticArcLength``; the second number is the accepted error."""
        from fontTools.misc import bezierTools

        if given.degree == 3:
            arc_length = float(bezierTools.calcCubicArcLength(*self._points(given), TOLERANCE))
            return [arc_length, TOLERANCE * arc_length]
        return [float(bezierTools.calcQuadraticArcLength(*self._points(given)))]

    def meetings(self, given: Given) -> Rows:
        """``curveCurveIntersections``."""
        from fontTools.misc import bezierTools

        found = bezierTools.curveCurveIntersections(*self.pair(given, self._points))
        return [[float(each.t1), float(each.t2)] for each in found]

    def area(self, given: Given) -> list[float]:
        """``AreaPen`` along the contour."""
        from fontTools.pens.areaPen import AreaPen

        pen, points = AreaPen(None), self._points(given)
        pen.moveTo(points[0])
        for i in range(1, len(points), 3):
            pen.curveTo(*points[i : i + 3])
        pen.closePath()
        return [float(pen.value)]


ADAPTER = FontTools
