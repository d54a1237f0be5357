"""geomdl (NURBS-Python): `BSpline.Curve`, `NURBS.Curve`, `operations`."""

from __future__ import annotations

from typing import Any

from workshop.grade.adapters.common import Adapter, Given, floats, with_knots, with_weights
from workshop.grade.data import Rows, WithKnots


class Geomdl(Adapter):
    """``evaluate_single``, ``derivatives``, and the functions of ``geomdl.operations``."""

    name = "geomdl"

    def _curve(self, given: Given) -> Any:
        from geomdl import NURBS, BSpline

        if given.weights is None:
            curve = BSpline.Curve(normalize_kv=False)
            curve.degree, curve.ctrlpts = given.degree, [list(map(float, p)) for p in given.points]
        else:
            curve = NURBS.Curve(normalize_kv=False)
            curve.degree, curve.ctrlptsw = given.degree, given.homogeneous
        curve.knotvector = list(map(float, given.knots))
        return curve

    def _rows(self, curve: Any) -> Rows:
        return with_weights(curve.ctrlpts, curve.weights if curve.rational else None)

    def value(self, given: Given) -> list[float]:
        """``curve.evaluate_single(t)``."""
        return floats(self._curve(given).evaluate_single(given.t))

    def first(self, given: Given) -> list[float]:
        """``curve.derivatives(t, 1)[1]``."""
        return floats(self._curve(given).derivatives(given.t, 1)[1])

    def second(self, given: Given) -> list[float]:
        """``curve.derivatives(t, 2)[2]``."""
        return floats(self._curve(given).derivatives(given.t, 2)[2])

    def tangent(self, given: Given) -> list[float]:
        """``operations.tangent(curve, t, normalize=True)[1]``."""
        from geomdl import operations

        return floats(operations.tangent(self._curve(given), given.t, normalize=True)[1])

    def insert(self, given: Given) -> Rows:
        """``operations.insert_knot(curve, [t], [1])``."""
        from geomdl import operations

        return self._rows(operations.insert_knot(self._curve(given), [given.t], [1]))

    def remove(self, given: Given) -> Rows:
        """``operations.remove_knot(curve, [t], [1])``."""
        from geomdl import operations

        assert given.finer is not None
        return self._rows(operations.remove_knot(self._curve(given.finer), [given.t], [1]))

    def elevate(self, given: Given) -> WithKnots:
        """``operations.degree_operations(curve, [1])``."""
        from geomdl import operations

        curve = operations.degree_operations(self._curve(given), [1])
        return with_knots(self._rows(curve), curve.knotvector)

    def split(self, given: Given) -> Rows:
        """``operations.split_curve(curve, t)``."""
        from geomdl import operations

        return [row for part in operations.split_curve(self._curve(given), given.t) for row in self._rows(part)]


ADAPTER = Geomdl
