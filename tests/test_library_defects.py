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
from exactspline.batch.grade.adapters.bezier_js import installed


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
    assert xs.Nurbs.from_homogeneous(3, [0] * 4 + [1] * 4, rows).torsion("1/2") == mpq(121, 114)


def node(script):
    folder, program = installed(), shutil.which("node")
    if folder is None or program is None:
        pytest.skip("bezier-js is not installed")
    if json.loads((folder / "package.json").read_text(encoding="utf-8"))["version"] != "6.1.4":
        pytest.skip("another bezier-js was graded")
    text = f"import {{Bezier}} from {json.dumps(str(folder.resolve() / 'src' / 'bezier.js'))};\n{script}"
    done = subprocess.run([program, "--input-type=module", "-e", text], capture_output=True, text=True, check=True)
    return json.loads(done.stdout)
