"""Our files in other programs, their evaluation of what we read: where the libraries are installed."""

import pytest

from exactspline import Nurbs, example, read
from exactspline.interchange.files import encoded
from exactspline.interchange.formats import formats
from exactspline.numbers.exact import from_float
from tests.support.interchange_seeds import ARC, CUBIC, SPACE

PERIODIC = b"""DBRep_DrawableShape

CASCADE Topology V1, (c) Matra-Datavision
Locations 0
Curve2ds 0
Curves 1
7 1 1  3 5 5  0 0 0 1  4 0 1 0.5  5 3 0 2  2 5 1 1  -1 2 0 1
 0 1 1 1 2.5 2 3 1 4 1
Polygon3D 0
PolygonOnTriangulations 0
Surfaces 0
Triangulations 0

TShapes 2
Ve
1e-07
0 0 0
0 0

0101101
*
Ed
 1e-07 1 1 0
1  1 0 0 4
0

0101000
+2 0 -2 0 *

+1 0
"""


def occt_curves(path):
    """The curves of the edges of a BRep file, by Open CASCADE."""
    pytest.importorskip("OCP")
    from OCP.BRep import BRep_Builder, BRep_Tool
    from OCP.BRepTools import BRepTools
    from OCP.TopAbs import TopAbs_EDGE
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS, TopoDS_Shape

    shape = TopoDS_Shape()
    assert BRepTools.Read_s(shape, str(path), BRep_Builder())
    found, edges = [], TopExp_Explorer(shape, TopAbs_EDGE)
    while edges.More():
        cast = getattr(TopoDS, "Edge", None) or TopoDS.Edge_s
        curve = BRep_Tool.Curve_s(cast(edges.Current()), 0.0, 1.0)
        found += [curve] if curve is not None else []
        edges.Next()
    return found


def agree(ours, theirs):
    a, b = ours.domain
    for i in range(12):
        t = float(a + (b - a) * i / 12)
        point = theirs.Value(t)
        exact = ours(min(max(from_float(t), a), b))
        if any(abs(float(x) - y) > 1e-10 for x, y in zip(exact, (point.X(), point.Y(), point.Z()), strict=True)):
            return False
    return True


def test_open_cascade_reads_our_brep_and_evaluates_alike(tmp_path):
    unclamped = Nurbs(2, [0, 1, 2, 3, 4, 5, 6], [(0, 0, 1), (1, 2, 0), (3, 1, 2), (4, 0, 1)])
    place = tmp_path / "a.brep"
    place.write_bytes(encoded([SPACE, CUBIC, SPACE], "brep")[0])
    theirs = occt_curves(place)
    assert len(theirs) == 2
    assert all(agree(SPACE, curve) for curve in theirs)
    # OCCT wants end knots of a multiplicity that clamps: an unclamped curve is held by the file, not by OCCT
    assert read(encoded([unclamped], "brep")[0]).curves[0].curve.knots == unclamped.knots


def test_open_cascade_evaluates_a_periodic_curve_alike(tmp_path):
    place = tmp_path / "periodic.brep"
    place.write_bytes(PERIODIC)
    [theirs] = occt_curves(place)
    [named] = read(place).curves
    assert agree(named.curve, theirs)


@pytest.mark.parametrize(("name", "reader"), [("step", "STEPControl"), ("iges", "IGESControl")])
def test_open_cascade_reads_our_step_and_iges(tmp_path, name, reader):
    module = pytest.importorskip(f"OCP.{reader}")
    suffix = next(known.suffixes[0] for known in formats() if known.name == name)
    place = tmp_path / f"a{suffix}"
    place.write_bytes(encoded([SPACE, SPACE], name)[0])
    control = getattr(module, f"{reader}_Reader")()
    control.ReadFile(str(place))
    assert control.TransferRoots() > 0
    assert not control.OneShape().IsNull()


def test_ezdxf_reads_our_dxf_without_complaint(tmp_path):
    ezdxf = pytest.importorskip("ezdxf")
    place = tmp_path / "a.dxf"
    curves = [ARC, CUBIC, SPACE, example("circle")]
    place.write_bytes(encoded(curves, "dxf")[0])
    document = ezdxf.readfile(place)
    assert not document.audit().errors
    for ours, theirs in zip(curves, document.query("SPLINE"), strict=True):
        assert [float(t) for t in ours.knots] == list(theirs.knots)
        assert theirs.closed == ours.closed


def test_geomdl_imports_our_json(tmp_path):
    exchange = pytest.importorskip("geomdl.exchange")
    place = tmp_path / "a.json"
    place.write_bytes(encoded([ARC, SPACE], "geomdl")[0])
    for ours, theirs in zip([ARC, SPACE], exchange.import_json(str(place)), strict=True):
        assert theirs.evaluate_single(0.5) == pytest.approx([float(x) for x in ours("1/2")])
