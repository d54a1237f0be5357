"""splinepy: `BSpline` and `NURBS`."""

from __future__ import annotations

from typing import Any

from workshop.grade.adapters.common import Adapter, Given, floats, with_knots, with_weights
from workshop.grade.data import Rows, WithKnots


class Splinepy(Adapter):
    """``evaluate``, ``derivative``, ``insert_knots``, ``remove_knots``, ``elevate_degrees``."""

    name = "splinepy"

    def can(self, question: str, given: Given) -> bool:
        """Inner knots only: at the ends the wheel is known to abort the process (isosuite/splinepy#215)."""
        inside = given.knots[0] < given.t < given.knots[-1]
        return super().can(question, given) and (inside or question not in ("insert", "remove"))

    def _curve(self, given: Given) -> Any:
        import splinepy

        if given.weights is None:
            return splinepy.BSpline([given.degree], [given.knots], given.points)
        return splinepy.NURBS([given.degree], [given.knots], given.points, given.weights)

    def _rows(self, curve: Any) -> Rows:
        rational = hasattr(curve, "weights") and curve.is_rational
        return with_weights(curve.cps, [w for row in curve.weights for w in row] if rational else None)

    def value(self, given: Given) -> list[float]:
        """``curve.evaluate([[t]])``."""
        return floats(self._curve(given).evaluate([[given.t]])[0])

    def first(self, given: Given) -> list[float]:
        """``curve.derivative([[t]], [1])``."""
        return floats(self._curve(given).derivative([[given.t]], [1])[0])

    def second(self, given: Given) -> list[float]:
        """``curve.derivative([[t]], [2])``."""
        return floats(self._curve(given).derivative([[given.t]], [2])[0])

    def insert(self, given: Given) -> Rows:
        """``curve.insert_knots(0, [t])``."""
        curve = self._curve(given)
        curve.insert_knots(0, [given.t])
        return self._rows(curve)

    def remove(self, given: Given) -> Rows:
        """``curve.remove_knots(0, [t], tolerance=1e-9)``."""
        assert given.finer is not None
        curve = self._curve(given.finer)
        curve.remove_knots(0, [given.t], tolerance=1e-9)
        return self._rows(curve)

    def elevate(self, given: Given) -> WithKnots:
        """``curve.elevate_degrees([0])``."""
        curve = self._curve(given)
        curve.elevate_degrees([0])
        return with_knots(self._rows(curve), curve.knot_vectors[0])

    def nearest(self, given: Given) -> list[float]:
        """``curve.proximities([point], return_verbose=True)``, the distance."""
        return [float(self._curve(given).proximities([given.point], return_verbose=True)[3][0, 0])]


ADAPTER = Splinepy
