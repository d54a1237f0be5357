"""Defects that grading found, each in the library's own words and in the version that was graded.

What is exact stands in the comparison. A later version may have mended it: then there is nothing to show, and the
scoreboard is to be made again.
"""

import json
import math
import shutil
import subprocess
from importlib.metadata import PackageNotFoundError, version

import pytest
from gmpy2 import mpq

import exactspline as xs
from workshop.npm import folder_of
from workshop.vectors.items import items


def needs(package, graded):
    """Skip where the package is not installed in the version that was graded."""
    try:
        found = version(package)
    except PackageNotFoundError:
        pytest.skip(f"{package} is not installed")
    if found != graded:
        pytest.skip(f"{package} {found} was not graded, {graded} was")


def test_geomdl_a_knot_inserted_and_removed_is_another_curve():
    """https://github.com/orbingol/NURBS-Python/issues/135"""
    needs("geomdl", "5.4.0")
    from geomdl import BSpline, operations

    curve = BSpline.Curve()
    curve.degree, curve.ctrlpts, curve.knotvector = 2, [[0, 0], [1, 0], [1, 1]], [0, 0, 0, 1, 1, 1]
    back = operations.remove_knot(operations.insert_knot(curve, [0.5], [1]), [0.5], [1])
    assert back.knotvector == [0, 0, 0, 1, 1, 1]
    assert back.ctrlpts == [[0, 0], [1, 0.5], [1, 1]]
    assert back.evaluate_single(0.5) == [0.75, 0.5]
    exact = xs.Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), (1, 0), (1, 1)])
    assert exact("1/2") == (mpq(3, 4), mpq(1, 4))


def test_geomdl_degree_elevation_loses_the_curve_at_a_knot():
    """https://github.com/orbingol/NURBS-Python/issues/125"""
    needs("geomdl", "5.4.0")
    from geomdl import BSpline, operations

    curve = BSpline.Curve(normalize_kv=False)
    curve.degree, curve.ctrlpts, curve.knotvector = 2, [[0, 0], [1, 0], [1, 1], [0, 1]], [0, 0, 0, 1, 2, 2, 2]
    assert curve.evaluate_single(0.5) == [0.75, 0.125]
    operations.degree_operations(curve, [1])
    # a cubic that may be C1 at the knot needs it twice
    assert curve.knotvector == [0, 0, 0, 0, 1, 2, 2, 2, 2]
    assert math.dist(curve.evaluate_single(0.5), (0.75, 0.125)) > 0.09
    exact = xs.Nurbs(2, [0, 0, 0, 1, 2, 2, 2], [(0, 0), (1, 0), (1, 1), (0, 1)])
    assert len(exact.elevate_degree().control_points) == 6
    assert exact.elevate_degree()("1/2") == (mpq(3, 4), mpq(1, 8))


def test_splipy_the_torsion_of_a_rational_curve():
    needs("splipy", "1.10.1")
    import splipy

    rows = [[1, 0, 0, 1], [1, 1, 0, 1], [0, 1, 1, 2], [0, 0, 1, 1]]
    curve = splipy.Curve(splipy.BSplineBasis(4, [0, 0, 0, 0, 1, 1, 1, 1]), rows, rational=True, raw=True)
    assert abs(curve.torsion(0.5)) < 1e-12
    assert curve.torsion([0.5]).shape == (1, 3)
    assert xs.torsion(xs.Nurbs.from_homogeneous(3, [0] * 4 + [1] * 4, rows), "1/2") == mpq(121, 114)


def node(script):
    folder, program = folder_of("bezier-js"), shutil.which("node")
    if folder is None or program is None:
        pytest.skip("bezier-js is not installed")
    if json.loads((folder / "package.json").read_text(encoding="utf-8"))["version"] != "6.1.4":
        pytest.skip("another bezier-js was graded")
    text = f"import {{Bezier}} from {json.dumps(str(folder.resolve() / 'src' / 'bezier.js'))};\n{script}"
    done = subprocess.run([program, "--input-type=module", "-e", text], capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def test_bezier_js_the_box_of_a_cubic_that_is_almost_a_quadratic():
    """https://github.com/uxebu/bonsai/issues/224 has such a curve: a tiny leading term, and an extremum is lost."""
    found = node(
        "const p = [[0, 0], [0, 2], [0, 2], [0, 2 ** -52]].map(([x, y]) => ({x, y})), b = new Bezier(p);"
        "console.log(JSON.stringify([b.bbox().y.max, b.get(0.5).y]))"
    )
    assert found == [2.0**-52, 1.5]
    curve = xs.Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (0, 2), (0, 2), (0, mpq(1, 2**52))])
    assert items(curve, "bounding_box")[1].values["high"].double() == 1.5


def test_fonttools_three_roots_taken_for_one():
    needs("fonttools", "4.68.0")
    from fontTools.misc.bezierTools import calcCubicParameters, solveCubic

    y = [-1, 257 / 256, -257 / 256, 1]
    parameters = calcCubicParameters(*[(0, v) for v in y])
    assert solveCubic(*[c[1] for c in parameters]) == [0.5, 0.5, 0.5]
    exact = xs.floats(xs.zeros(xs.BSpline.bezier(xs.from_floats(map(float, y)))))
    assert exact == [0.47297626273344123, 0.5, 0.5270237372665587]


def test_open_cascade_a_box_that_does_not_hold_the_curve():
    needs("cadquery-ocp-novtk", "8.0.1.1.0")
    from OCP.Bnd import Bnd_Box
    from OCP.BndLib import BndLib_Add3dCurve
    from OCP.collections import Array1_double, Array1_gp_Pnt, Array1_int
    from OCP.Geom import Geom_BSplineCurve
    from OCP.GeomAdaptor import GeomAdaptor_Curve
    from OCP.gp import gp_Pnt

    def filled(kind, values):
        made = kind(1, len(values))
        for i, value in enumerate(values, 1):
            made.SetValue(i, value)
        return made

    knots, points = [0, 0.8678392314693726, 0.9998000781786818, 1.0], [(0, 0), (0, 0), (0, 0), (1, 0), (0, 0)]
    curve = Geom_BSplineCurve(
        filled(Array1_gp_Pnt, [gp_Pnt(x, y, 0.0) for x, y in points]),
        filled(Array1_double, knots), filled(Array1_int, [3, 1, 1, 3]), 2,
    )  # fmt: skip
    box = Bnd_Box()
    BndLib_Add3dCurve.AddOptimal_s(GeomAdaptor_Curve(curve), 0.0, 1.0, 0.0, box)
    assert box.CornerMax().X() < 0.61
    assert curve.Value(knots[2]).X() > 0.998
    exact = xs.Nurbs.from_floats(2, [0, 0, 0, *knots[1:3], 1, 1, 1], points)
    assert items(exact, "bounding_box")[0].values["high"].double() > 0.998


def test_fonttools_roots_at_the_ends_that_are_half_a_percent_inside():
    needs("fonttools", "4.68.0")
    from fontTools.misc.bezierTools import calcCubicParameters, solveCubic

    y = [0, 2 - 2.0**-24, 2, -(2.0**-24)]
    found = solveCubic(*[c[1] for c in calcCubicParameters(*[(0, v) for v in y])])
    assert [t for t in found if 0 <= t <= 1] == [0.005236, 0.994764]
    exact = xs.floats(xs.zeros(xs.BSpline.bezier(xs.from_floats(map(float, y)))))
    assert exact[0] == 0
    assert 1 - 1e-7 < exact[1] < 1


def test_open_cascade_an_inflection_at_another_parameter():
    needs("cadquery-ocp-novtk", "8.0.1.1.0")
    from OCP.collections import Array1_gp_Pnt2d
    from OCP.Geom2d import Geom2d_BezierCurve
    from OCP.GeomLProp import GeomLProp_CurAndInf2d
    from OCP.gp import gp_Pnt2d

    points, poles = [(0, 0), (1, 1 - 2.0**-12), (2, 2), (3, 3)], Array1_gp_Pnt2d(1, 4)
    for i, (x, y) in enumerate(points, 1):
        poles.SetValue(i, gp_Pnt2d(x, y))
    found = GeomLProp_CurAndInf2d()
    found.Perform(Geom2d_BezierCurve(poles))
    assert found.IsDone()
    assert found.NbPoints() == 1
    assert abs(found.Parameter(1) - 0.68333) < 1e-4
    curve = xs.Nurbs.from_floats(3, [0, 0, 0, 0, 1, 1, 1, 1], points)
    [inflection] = xs.analyse(curve).inflections
    assert inflection.root.exact == mpq(2, 3)
    assert inflection.root.sign_change


def test_bezier_js_an_inflection_of_an_almost_straight_cubic():
    """The curve is straight to 1.5e-8, where bezier-js takes it for a line."""
    found = node(
        "const p = [[0, 0], [1, 1 - 2 ** -26], [2, 2], [3, 3]].map(([x, y]) => ({x, y}));"
        "console.log(JSON.stringify(new Bezier(p).inflections()))"
    )
    assert found == []
    curve = xs.Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (1, 1 - mpq(1, 2**26)), (2, 2), (3, 3)])
    assert [f.root.exact for f in xs.analyse(curve).inflections] == [mpq(2, 3)]


def test_bezier_the_intersection_of_a_point_and_a_line():
    needs("bezier", "2024.6.20")
    import bezier
    import numpy as np

    point = bezier.Curve(np.asfortranarray([[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]]), degree=2)
    line = bezier.Curve(np.asfortranarray([[-2.0, 0.0], [0.0, 0.0]]), degree=1)
    with np.errstate(all="ignore"):
        assert np.isnan(point.intersect(line)).any()
