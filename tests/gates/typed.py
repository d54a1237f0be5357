"""What a type checker knows of code that uses the package: nothing here runs, ``./run check`` reads it."""

from typing import assert_type

import exactspline as xs
from exactspline.geometry.analysis.planar_maps import MapInspection
from exactspline.geometry.analysis.surfaces import SurfaceInspection
from exactspline.geometry.curves.kinds import Feature
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector
from exactspline.roots.answers import Places
from exactspline.roots.root import Root
from exactspline.roots.zero_set import ZeroSet


def known(circle: xs.Nurbs, torus: xs.NurbsSurface) -> None:
    """The types of what the front door gives."""
    assert_type(xs.Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 1)]), xs.Nurbs)
    assert_type(xs.zeros(xs.BSpline.bezier([1, -1])), ZeroSet)
    assert_type(xs.example("circle").insert_knot("1/2"), xs.Nurbs)
    assert_type(xs.example("circle").split("1/2")[0], xs.Nurbs)
    assert_type(xs.prove("f1", "f2").holds, bool)
    assert_type(circle.w, xs.BSpline)
    assert_type(circle.w * 2 - circle.p[0], xs.BSpline)
    assert_type(circle.w * circle.p, Vector[xs.BSpline])
    assert_type(circle.p * circle.w, Vector[xs.BSpline])
    assert_type(circle.p[0] / circle.w, Rational[xs.BSpline])
    assert_type(circle.p / circle.w, Rational[xs.BSpline])
    assert_type(xs.zeros(circle.w).roots[0], Root)
    assert_type(xs.analyse(circle).inflections, Places[Feature])
    assert_type(xs.analyse(circle).turning_points(0), Places[Feature])
    assert_type(xs.analyse(torus), SurfaceInspection | MapInspection)


def refused(circle: xs.Nurbs, sphere: xs.NurbsSurface) -> None:
    """Functions, not methods; passed before: `curve.plot()`."""
    circle.plot()  # type: ignore[attr-defined]  # has to be refused
    sphere.plot  # type: ignore[attr-defined]  # noqa: B018  # has to be refused
