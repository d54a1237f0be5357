"""Our readers beside independent ones on the real files of others: Open CASCADE, ezdxf, svgelements.

Every curve that we read lies on a curve that they read, to 1e-6 of its size; what is left out is said why.
"""

import os
import re
from itertools import pairwise
from pathlib import Path

import pytest

from exactspline.interchange import read

FILES = Path(os.environ.get("EXACTSPLINE_FILES", Path(__file__).resolve().parents[2] / "shared" / "files"))
pytestmark = pytest.mark.skipif(not FILES.exists(), reason="the real files are not here")


def samples(curve, count=6):
    a, b = curve.domain
    for k in range(count):
        point = [float(x) for x in curve(a + (b - a) * k / (count - 1))]
        yield [*point, 0.0][:3]


def open_cascade_curves(path):
    """All curves of edges, placed as the file places them, and the raw ones of the file."""
    from OCP.BRep import BRep_Builder, BRep_Tool
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopLoc import TopLoc_Location
    from OCP.TopoDS import TopoDS, TopoDS_Shape

    if path.suffix == ".brep":
        from OCP.BRepTools import BRepTools

        shape = TopoDS_Shape()
        BRepTools.Read_s(shape, str(path), BRep_Builder())
    else:
        from OCP.IGESControl import IGESControl_Reader
        from OCP.STEPControl import STEPControl_Reader

        reader = IGESControl_Reader() if path.suffix in (".igs", ".iges") else STEPControl_Reader()
        reader.ReadFile(str(path))
        reader.TransferRoots()
        shape = reader.OneShape()
    found, explorer = [], TopExp_Explorer(shape, TopAbs_ShapeEnum.TopAbs_EDGE)
    while explorer.More():
        edge = TopoDS.Edge(explorer.Current())
        # without its location: as it stands in the file
        curve = BRep_Tool.Curve_s(edge, TopLoc_Location(), 0.0, 1.0)
        if curve is not None:
            found.append(curve)
        explorer.Next()
    return found


def distance_to(point, curves):
    from OCP.GeomAPI import GeomAPI_ProjectPointOnCurve
    from OCP.gp import gp_Pnt

    best = float("inf")
    for curve in curves:
        projected = GeomAPI_ProjectPointOnCurve(gp_Pnt(*point), curve)
        if projected.NbPoints():
            best = min(best, projected.LowerDistance())
        for t in (curve.FirstParameter(), curve.LastParameter()):
            if abs(t) < 1e50:
                best = min(best, curve.Value(t).Distance(gp_Pnt(*point)))
    return best


#: Curves that Open CASCADE has no edge for, and the factor from the units of the file to its millimetres.
LEFT_OUT = {"igesio_single_rounded_cube.iges": 1}  # a line that only makes a surface
UNITS = {"splinelib_read2.iges": 25.4}  # inches


@pytest.mark.parametrize(("name", "count"), [
    ("oce_screw.step", 9), ("rhino_splinecage.stp", 22), ("as1_tc_214.stp", 126), ("as_BSplHelix.brep", 3),
    ("as_CircularBSpl.brep", 1), ("as_edge_deg14.brep", 1), ("igestoolbox_example.igs", 112),
    ("splinelib_read2.iges", 1), ("igesio_single_rounded_cube.iges", 32), ("rhino_curve_geom_plate.igs", 6),
])  # fmt: skip
def test_curves_beside_open_cascade(name, count):
    pytest.importorskip("OCP")
    others, unit = open_cascade_curves(FILES / name), UNITS.get(name, 1)
    ours = [named.curve for named in read(FILES / name).curves if named.curve.dimension == 3]
    assert len(ours) == count
    off = [
        curve
        for curve in ours
        if any(distance_to([x * unit for x in p], others) > 1e-6 * (1 + max(map(abs, p))) for p in samples(curve))
    ]
    assert len(off) == LEFT_OUT.get(name, 0)


@pytest.mark.parametrize("name", ["w3c_paths-data-01-t.svg", "w3c_paths-data-02-t.svg", "w3c_paths-data-18-f.svg"])
def test_path_data_beside_svgelements(name):
    """Every path by itself, without viewport and transforms: where each segment ends, and its middle."""
    svgelements = pytest.importorskip("svgelements")
    text = (FILES / name).read_text(encoding="utf-8")
    paths = [d for d in re.findall(r"\sd=\"([^\"]*)\"", text) if len(d) > 4]
    assert paths
    for d in paths:
        reading = read(f'<svg xmlns="http://www.w3.org/2000/svg"><path d="{d}"/></svg>'.encode(), "svg")
        if reading.skipped:
            continue
        segments = [x for x in svgelements.Path(d) if not isinstance(x, svgelements.Move) and x.start != x.end]
        theirs = sorted((round(x.point(t).x, 6), round(x.point(t).y, 6)) for x in segments for t in (0, 0.5, 1))
        ours = set()
        for named in reading.curves:
            c = named.curve
            middles = [(a + b) / 2 for a, b in pairwise(c.breakpoints)]
            ours |= {tuple(round(float(x), 6) for x in c(t)) for t in (*c.breakpoints, *middles)}
        assert set(theirs) <= ours


@pytest.mark.parametrize("name", ["skym_squircle2.dxf", "ezdxf_no_layouts.dxf"])
def test_splines_beside_ezdxf(name):
    recover = pytest.importorskip("ezdxf.recover")
    document, _ = recover.readfile(FILES / name)
    theirs = [e.construction_tool() for e in document.modelspace().query("SPLINE") if e.control_point_count()]
    ours = [named.curve for named in read(FILES / name).curves if named.curve.degree > 1]
    assert len(ours) == len(theirs)
    for curve, tool in zip(ours, theirs, strict=True):
        a, b = curve.domain
        for k in range(1, 8):
            t = a + (b - a) * k / 8
            point = [*(float(x) for x in curve(t)), 0.0][:3]
            assert max(abs(x - y) for x, y in zip(point, tool.point(float(t)), strict=True)) < 1e-6 * (
                1 + max(map(abs, point))
            )
