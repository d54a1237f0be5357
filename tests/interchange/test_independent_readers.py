"""Our readers beside independent ones on the real files of others: Open CASCADE, pyiges, ezdxf, svgelements, FreeType,
splinepy, splipy, and the evaluation of openNURBS.

Every curve that we read lies on a curve that they read, to 1e-6 of its size; what is left out is said why.
"""

import os
import re
from fractions import Fraction
from itertools import pairwise
from math import comb
from pathlib import Path

import pytest

from exactspline import read
from exactspline.interchange.collector import Collector

FILES = Path(os.environ.get("EXACTSPLINE_FILES", Path(__file__).resolve().parents[3] / "shared" / "files"))
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
    ("as_CircularBSpl.brep", 1), ("as_edge_deg14.brep", 1), ("igestoolbox_example.igs", 37),
    ("splinelib_read2.iges", 1), ("igesio_single_rounded_cube.iges", 20), ("rhino_curve_geom_plate.igs", 6),
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


@pytest.mark.parametrize(("name", "count"), [
    ("igestoolbox_example.igs", 224), ("rhino_curve_geom_plate.igs", 6),
    ("splinelib_read2.iges", 1), ("igesio_single_rounded_cube.iges", 30),
])  # fmt: skip
def test_entities_126_beside_pyiges(name, count, monkeypatch):
    """Degree, knots, control points and weights, in the order of the file, before any placing and joining."""
    pyiges = pytest.importorskip("pyiges")
    monkeypatch.setattr(Collector, "join", lambda *_: None)
    theirs = {int(entity.sequence_number): entity for entity in pyiges.read(str(FILES / name)).bsplines()}
    ours = {int(named.name.split()[-1]): named.curve for named in read(FILES / name).curves}
    assert len(theirs) == count
    assert set(theirs) <= set(ours)
    for number, entity in theirs.items():
        curve = ours[number]
        assert curve.degree == entity.M
        assert list(map(float, curve.knots)) == pytest.approx(list(entity.T), abs=0)
        their_weights = [float(w) / float(entity.W[0]) for w in entity.W]
        assert [float(w / curve.weights[0]) for w in curve.weights] == pytest.approx(their_weights, rel=1e-15)
        points = [[float(x) for x in p] for p in curve.control_points]
        assert points == [[float(x) for x in p][: curve.dimension] for p in entity.control_points]


def _pieces(outline):
    """Start, middle and end of every piece of an outline of FreeType, contour by contour, exactly."""
    contours = []

    def place(v):
        return (Fraction(v.x, 2), Fraction(v.y, 2))

    def piece(*control):
        n = len(control) - 1
        middle = tuple(sum(comb(n, k) * p[i] for k, p in enumerate(control)) / 2**n for i in (0, 1))
        if len(set(control)) > 1:
            contours[-1].append((control[0], middle, control[-1]))
        return control[-1]

    state = {}

    def move(a, _):
        close()
        contours.append([])
        state["first"] = state["last"] = place(a)

    def close():
        if contours:
            piece(state["last"], state["first"])

    def onward(*points):
        *vectors, _ = points
        state["last"] = piece(state["last"], *map(place, vectors))

    # twice as large (a shift by one bit), as a point between two points off the curve would be rounded to integers
    outline.decompose(move_to=move, line_to=onward, conic_to=onward, cubic_to=onward, shift=1)
    close()
    return sorted(sorted(contour) for contour in contours)


def _own_pieces(curves):
    """The same of our curves."""

    def at(curve, t):
        return tuple(Fraction(int(x.numerator), int(x.denominator)) for x in curve(t))

    found = []
    for curve in curves:
        ends = list(pairwise(curve.breakpoints))
        triples = [tuple(at(curve, t) for t in (a, (a + b) / 2, b)) for a, b in ends]
        found.append(sorted(triple for triple in triples if len(set(triple)) > 1))
    return sorted(found)


@pytest.mark.parametrize(("name", "least"), [("Karla_wght.ttf", 200), ("Lobster.subset.otf", 9)])
def test_outlines_beside_freetype(name, least):
    """Every piece of every glyph that is drawn in whole font units: FreeType rounds scaled components to these."""
    freetype = pytest.importorskip("freetype")
    font_tools = pytest.importorskip("fontTools.ttLib")
    names = font_tools.TTFont(FILES / name).getGlyphOrder()
    face, ours = freetype.Face(str(FILES / name)), {}
    for named in read(FILES / name).curves:
        ours.setdefault(named.name.rpartition(".")[0], []).append(named.curve)
    compared = 0
    for index, glyph in enumerate(names):
        face.load_glyph(index, freetype.FT_LOAD_NO_SCALE)
        curves = ours.get(glyph, [])
        if face.get_format() == b"CFF" or all(x.denominator == 1 for c in curves for p in c.control_points for x in p):
            assert _own_pieces(curves) == _pieces(face.glyph.outline), glyph
            compared += bool(curves)
    assert compared >= least


def test_splines_beside_splinepy():
    """The first two entries of an IRIT file; behind them stand surfaces."""
    irit = pytest.importorskip("splinepy.io.irit")
    theirs = irit.load(str(FILES / "splinelib_test.itd"))[:2]
    ours = [named.curve for named in read(FILES / "splinelib_test.itd").curves]
    for curve, other in zip(ours, theirs, strict=True):
        assert [curve.degree] == list(other.degrees)
        assert list(map(float, curve.knots)) == list(other.knot_vectors[0])
        points = [[float(x) for x in p] for p in curve.control_points]
        assert points == [pytest.approx(list(map(float, p)), rel=1e-15) for p in other.control_points]


def test_a_rational_curve_beside_splipy():
    io = pytest.importorskip("splipy.io")
    with io.G2(str(FILES / "gotools_rational_spline_cv_2.g2")) as file:
        [theirs] = file.read()
    [ours] = [named.curve for named in read(FILES / "gotools_rational_spline_cv_2.g2").curves]
    for k in range(9):
        point = [float(x) for x in ours(Fraction(k, 8))]
        assert point == pytest.approx(list(theirs(k / 8)), abs=1e-15)


@pytest.mark.parametrize(("name", "count"), [("opennurbs_v2_Flow1.3dm", 4), ("opennurbs_v6_my_curves.3dm", 4)])
def test_curves_beside_the_evaluation_of_opennurbs(name, count):
    """openNURBS is the one reader of this format: its numbers are read by us, its evaluation is its own."""
    rhino3dm = pytest.importorskip("rhino3dm")
    model = rhino3dm.File3dm.Read(str(FILES / name))
    curves = [x.Geometry for x in model.Objects if isinstance(x.Geometry, rhino3dm.Curve)]
    ours = read(FILES / name).curves
    assert len(ours) == len(curves) == count
    for named, other in zip(ours, (c.ToNurbsCurve() for c in curves), strict=True):
        curve, theirs = named.curve, other.Domain
        a, b = curve.domain
        # a circle by its angle and by rational pieces agree at the quarters
        steps = 4 if any("angle" in note for note in named.notes) else 16
        for k in range(steps + 1):
            t, at = a + (b - a) * k / steps, theirs.T0 + (theirs.T1 - theirs.T0) * k / steps
            point, found = [*map(float, curve(t)), 0.0][:3], other.PointAt(at)
            size = 1 + max(map(abs, point))
            assert max(abs(x - y) for x, y in zip(point, (found.X, found.Y, found.Z), strict=True)) < 1e-12 * size
