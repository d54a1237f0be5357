"""Open CASCADE through OCP (cadquery-ocp): `Geom_BSplineCurve`, `GeomLProp`, `BndLib`, `GCPnts`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Protocol, TypeVar

from workshop.grade.adapters.common import DeclinedError, Given, IncreasingDegree
from workshop.grade.data import Rows


class Array(Protocol):
    """An array of Open CASCADE."""

    def SetValue(self, index: int, value: object, /) -> None:
        """Set the entry with an index."""


A = TypeVar("A", bound=Array)
#: ``Precision::Confusion()``: the distance within which points coincide for the library, which it also adds to boxes.
CONFUSION = 1e-7


def array(kind: Callable[[int, int], A], values: Sequence[object]) -> A:
    """An array of Open CASCADE, whose indices begin at 1."""
    made = kind(1, len(values))
    for i, value in enumerate(values, 1):
        made.SetValue(i, value)
    return made


class OpenCascade(IncreasingDegree):
    """``Geom_BSplineCurve`` and ``Geom2d_BSplineCurve``."""

    name = "Open CASCADE"
    package = "cadquery-ocp-novtk"

    def can(self, question: str, given: Given) -> bool:
        """Clamped curves; inflections, extrema of the curvature and intersections in the plane."""
        return super().can(question, given) and (
            given.dimension == 2 or question not in ("inflections", "extrema", "meetings")
        )

    def _curve(self, given: Given) -> Any:
        from OCP.collections import Array1_double, Array1_gp_Pnt, Array1_int
        from OCP.Geom import Geom_BSplineCurve
        from OCP.gp import gp_Pnt

        poles = array(Array1_gp_Pnt, [gp_Pnt(*map(float, (*p, 0)[:3])) for p in given.points])
        knots, times = given.distinct
        parts = (array(Array1_double, list(map(float, knots))), array(Array1_int, times), given.degree)
        if given.weights is None:
            return Geom_BSplineCurve(poles, *parts)
        return Geom_BSplineCurve(poles, array(Array1_double, list(map(float, given.weights))), *parts)

    def _flat(self, given: Given) -> Any:
        from OCP.collections import Array1_double, Array1_gp_Pnt2d, Array1_int
        from OCP.Geom2d import Geom2d_BSplineCurve
        from OCP.gp import gp_Pnt2d

        poles = array(Array1_gp_Pnt2d, [gp_Pnt2d(float(p[0]), float(p[1])) for p in given.points])
        weights = array(Array1_double, list(map(float, given.weights or [1] * len(given.points))))
        knots, times = given.distinct
        parts = (array(Array1_double, list(map(float, knots))), array(Array1_int, times))
        return Geom2d_BSplineCurve(poles, weights, *parts, given.degree)

    def _triple(self, v: Any, given: Given) -> list[float]:
        return [float(v.X()), float(v.Y()), float(v.Z())][: given.dimension]

    def _rows(self, curve: Any, given: Given) -> Rows:
        count = range(1, curve.NbPoles() + 1)
        points = [self._triple(curve.Pole(i), given) for i in count]
        if given.weights is None:
            return points
        return [[*p, float(curve.Weight(i) / curve.Weight(1))] for i, p in zip(count, points, strict=True)]

    def value(self, given: Given) -> list[float]:
        """``curve.Value(t)``."""
        return self._triple(self._curve(given).Value(given.t), given)

    def first(self, given: Given) -> list[float]:
        """``curve.DN(t, 1)``."""
        return self._triple(self._curve(given).DN(given.t, 1), given)

    def second(self, given: Given) -> list[float]:
        """``curve.DN(t, 2)``."""
        return self._triple(self._curve(given).DN(given.t, 2), given)

    def curvature(self, given: Given) -> list[float]:
        """``GeomLProp_CLProps(curve, t, 2, 1e-12).Curvature()``."""
        from OCP.GeomLProp import GeomLProp_CLProps

        return [abs(float(GeomLProp_CLProps(self._curve(given), given.t, 2, 1e-12).Curvature()))]

    def tangent(self, given: Given) -> list[float]:
        """``GeomLProp_CLProps(curve, t, 2, 1e-12).Tangent(…)``."""
        from OCP.GeomLProp import GeomLProp_CLProps
        from OCP.gp import gp_Dir

        direction = gp_Dir()
        GeomLProp_CLProps(self._curve(given), given.t, 2, 1e-12).Tangent(direction)
        return self._triple(direction, given)

    def insert(self, given: Given) -> Rows:
        """``curve.InsertKnot(t)``."""
        curve = self._curve(given)
        curve.InsertKnot(given.t, 1, 0.0, True)
        return self._rows(curve, given)

    def remove(self, given: Given) -> Rows:
        """``curve.RemoveKnot(index, multiplicity − 1, 1e-7)``."""
        assert given.finer is not None
        curve = self._curve(given.finer)
        knots, times = given.finer.distinct
        index = knots.index(given.t)
        curve.RemoveKnot(index + 1, times[index] - 1, CONFUSION)
        return self._rows(curve, given)

    def split(self, given: Given) -> Rows:
        """``curve.Segment(a, t)`` and ``curve.Segment(t, b)``."""
        parts = []
        for a, b in ((given.knots[0], given.t), (given.t, given.knots[-1])):
            curve = self._curve(given)
            curve.Segment(float(a), float(b))
            parts += self._rows(curve, given)
        return parts

    def box(self, given: Given) -> list[float]:
        """``BndLib_Add3dCurve.AddOptimal``, whose box is enlarged by its gap; the last number is the allowed
        enlargement.
        """
        from OCP.Bnd import Bnd_Box
        from OCP.BndLib import BndLib_Add3dCurve
        from OCP.GeomAdaptor import GeomAdaptor_Curve

        box, (a, b) = Bnd_Box(), (given.knots[0], given.knots[-1])
        BndLib_Add3dCurve.AddOptimal_s(GeomAdaptor_Curve(self._curve(given)), float(a), float(b), 0.0, box)
        low, high = (self._triple(p, given) for p in (box.CornerMin(), box.CornerMax()))
        return [*[x for pair in zip(low, high, strict=True) for x in pair], 2 * CONFUSION]

    def length(self, given: Given) -> list[float]:
        """``GCPnts_AbscissaPoint.Length(curve, 1e-9)``."""
        from OCP.GCPnts import GCPnts_AbscissaPoint
        from OCP.GeomAdaptor import GeomAdaptor_Curve

        return [float(GCPnts_AbscissaPoint.Length_s(GeomAdaptor_Curve(self._curve(given)), 1e-9))]

    def _analysed(self, given: Given) -> list[tuple[str, float]]:
        from OCP.GeomLProp import GeomLProp_CurAndInf2d

        found = GeomLProp_CurAndInf2d()
        found.Perform(self._flat(given))
        if not found.IsDone():
            raise DeclinedError("IsDone() is false")
        points = range(1, found.NbPoints() + 1)
        return [(str(found.Type(i)), float(found.Parameter(i))) for i in points]

    def inflections(self, given: Given) -> list[list[float]]:
        """``CurAndInf2d``, the inflections."""
        return [[t for kind, t in self._analysed(given) if "Inflection" in kind]]

    def extrema(self, given: Given) -> list[list[float]]:
        """``CurAndInf2d``, the extrema of the curvature."""
        return [[t for kind, t in self._analysed(given) if "Inflection" not in kind]]

    def nearest(self, given: Given) -> list[float]:
        """``BRepExtrema_DistShapeShape(vertex, edge).Value()``."""
        from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeVertex
        from OCP.gp import gp_Pnt

        vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(*map(float, (*given.point, 0)[:3]))).Vertex()
        return self._apart(vertex, self._edge(given))

    def distance(self, given: Given) -> list[float]:
        """``BRepExtrema_DistShapeShape(edge, edge).Value()``."""
        return self._apart(*self.pair(given, self._edge))

    def _edge(self, given: Given) -> Any:
        from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge

        return BRepBuilderAPI_MakeEdge(self._curve(given)).Edge()

    def _apart(self, first: Any, second: Any) -> list[float]:
        from OCP.BRepExtrema import BRepExtrema_DistShapeShape

        found = BRepExtrema_DistShapeShape(first, second)
        if not found.IsDone():
            raise DeclinedError("IsDone() is false")
        return [float(found.Value())]

    def meetings(self, given: Given) -> Rows:
        """``Geom2dInt_GInter(curve, other, 1e-7, 1e-7)``, its points and the ends of its segments: what
        ``Geom2dAPI_InterCurveCurve`` calls, which in this wheel is not done even for two lines.
        """
        from OCP.Geom2dAdaptor import Geom2dAdaptor_Curve
        from OCP.Geom2dInt import Geom2dInt_GInter

        curves = self.pair(given, lambda each: Geom2dAdaptor_Curve(self._flat(each)))
        found = Geom2dInt_GInter(*curves, CONFUSION, CONFUSION)
        if not found.IsDone():
            raise DeclinedError("IsDone() is false")
        points = [found.Point(i) for i in range(1, found.NbPoints() + 1)]
        for segment in (found.Segment(i) for i in range(1, found.NbSegments() + 1)):
            points += [segment.FirstPoint()] if segment.HasFirstPoint() else []
            points += [segment.LastPoint()] if segment.HasLastPoint() else []
        return [[float(p.ParamOnFirst()), float(p.ParamOnSecond())] for p in points]


ADAPTER = OpenCascade
