"""Surfaces through every format that holds them: the same surface comes back, other programs read the same points, and
what a file cuts off a surface is named.
"""

from fractions import Fraction
from pathlib import Path

import pytest

from exactspline import NurbsSurface, example, read, write
from exactspline.errors import CurveFileError, NumberError
from exactspline.interchange.files import encoded
from tests.interchange.test_shared_files import needs_files, opened

HALF = "1/2"
#: Different degrees, numbers of control points and knots in u and in v, so that no exchange of the two is unnoticed.
PLAIN = NurbsSurface(
    (1, 2),
    [0, 0, HALF, 1, 1],
    [2, 2, 2, 3, 5, 5, 5],
    [[(i, j * j, i * j + i) for j in range(4)] for i in range(3)],
    name="plain",
)
RATIONAL = NurbsSurface(
    PLAIN.degree,
    *PLAIN.knots,
    PLAIN.control_points,
    [[1, 2, "3/4", 1], [1, "1/4", 1, 8], [2, 1, 1, 1]],
    name="weighted",
)
FORMATS = {"step": ".stp", "iges": ".igs", "g2": ".g2", "itd": ".itd", "gismo": ".xml", "geomdl": ".json",
           "json": ".json", "3dm": ".3dm"}  # fmt: skip
PLACES = [("0", "2"), ("1/4", "5/2"), ("3/4", "4"), ("1", "5")]


@pytest.mark.parametrize("format", FORMATS)
def test_what_is_written_is_read(format):
    if format == "3dm":
        pytest.importorskip("rhino3dm")
    data, notes = encoded([PLAIN, RATIONAL, example("sphere")], format)
    reading = read(data, format)
    assert reading.surfaces == (PLAIN, RATIONAL, example("sphere"))
    assert [surface.polynomial for surface in reading.surfaces] == [True, False, False]
    assert (reading.curves, reading.skipped, notes) == ((), (), ())


@pytest.mark.parametrize("format", sorted(set(FORMATS) - {"json"}))
def test_a_number_that_the_format_cannot_hold_is_not_written(format):
    if format == "3dm":
        pytest.importorskip("rhino3dm")
    with pytest.raises(NumberError):
        encoded([example("enneper")], format)
    data, notes = encoded([example("enneper")], format, rounding=True)
    assert read(data, format).surface != example("enneper")
    assert "rounded to doubles" in notes[0]


def points_of_open_cascade(place):
    from OCP.BRep import BRep_Tool
    from OCP.IGESControl import IGESControl_Reader
    from OCP.STEPControl import STEPControl_Reader
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    reader = STEPControl_Reader() if place.suffix == ".stp" else IGESControl_Reader()
    reader.ReadFile(str(place))
    reader.TransferRoots()
    explorer, found = TopExp_Explorer(reader.OneShape(), TopAbs_ShapeEnum.TopAbs_FACE), []
    while explorer.More():
        surface = BRep_Tool.Surface_s(TopoDS.Face(explorer.Current()))
        found.append(lambda u, v, s=surface: (s.Value(u, v).X(), s.Value(u, v).Y(), s.Value(u, v).Z()))
        explorer.Next()
    return found


def points_of_rhino(place):
    import rhino3dm

    model = rhino3dm.File3dm.Read(str(place))
    return [
        lambda u, v, s=each.Geometry: (s.PointAt(u, v).X, s.PointAt(u, v).Y, s.PointAt(u, v).Z)
        for each in model.Objects
    ]


def points_of_geomdl(place):
    from geomdl import exchange

    return [lambda u, v, s=each: s.evaluate_single((u, v)) for each in exchange.import_json(str(place))]


def points_of_splipy(place):
    from splipy.io import G2

    with G2(str(place)) as stream:
        return list(stream.read())


def points_of_splinepy(place):
    import splinepy

    return [lambda u, v, s=each: s.evaluate([[u, v]])[0] for each in splinepy.io.irit.load(str(place))]


OTHERS = {"step": ("OCP", points_of_open_cascade), "iges": ("OCP", points_of_open_cascade),
          "3dm": ("rhino3dm", points_of_rhino), "geomdl": ("geomdl", points_of_geomdl),
          "g2": ("splipy", points_of_splipy), "itd": ("splinepy", points_of_splinepy)}  # fmt: skip


@pytest.mark.parametrize("format", OTHERS)
def test_others_read_the_same_surface(format, tmp_path):
    """Control points in another order, or knots of u and v exchanged, give other points."""
    library, reader = OTHERS[format]
    pytest.importorskip(library)
    place = tmp_path / f"surface{FORMATS[format]}"
    for surface in (PLAIN, RATIONAL):
        write(surface, place, format)
        [theirs] = reader(place)
        domain = surface.domain
        for u, v in PLACES:
            exact = [float(x) for x in surface(u, v)]
            # geomdl maps the parameters of a file to [0, 1]
            own = _number(u), _number(v)
            if format == "geomdl":
                own = tuple((t - float(a)) / float(b - a) for t, (a, b) in zip(own, domain, strict=True))
            assert list(theirs(*own)) == pytest.approx(exact, abs=1e-12), (u, v)


def _number(text):
    return float(Fraction(text))


#: File: surfaces, of which are rational, and what is said of their trims.
REAL = {
    "rhino_splinecage.stp": (4, 0, "ADVANCED_FACE"),
    "igestoolbox_example.igs": (22, 7, "trimmed surface"),
    "igesio_single_rounded_cube.iges": (6, 0, "trimmed surface"),
    "splinelib_read2.iges": (1, 1, ""),
    "splinelib_test.itd": (3, 1, ""),
}


@needs_files
@pytest.mark.parametrize("name", REAL)
def test_surfaces_of_others(name):
    reading = opened(name)
    count, rational, trimmed = REAL[name]
    assert (len(reading.surfaces), sum(not s.polynomial for s in reading.surfaces)) == (count, rational)
    assert trimmed in " ".join([*reading.notes, *(f"{s.what}: {s.why}" for s in reading.skipped)])


@needs_files
def test_points_of_a_real_surface_lie_on_those_of_open_cascade():
    pytest.importorskip("OCP")
    from OCP.BRep import BRep_Tool
    from OCP.GeomAPI import GeomAPI_ProjectPointOnSurf
    from OCP.gp import gp_Pnt
    from OCP.STEPControl import STEPControl_Reader
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    reading = opened("rhino_splinecage.stp")
    reader = STEPControl_Reader()
    reader.ReadFile(str(Path(__file__).resolve().parents[3] / "shared" / "files" / "rhino_splinecage.stp"))
    reader.TransferRoots()
    explorer, theirs = TopExp_Explorer(reader.OneShape(), TopAbs_ShapeEnum.TopAbs_FACE), []
    while explorer.More():
        theirs.append(BRep_Tool.Surface_s(TopoDS.Face(explorer.Current())))
        explorer.Next()
    for surface in reading.surfaces:
        (a, b), (c, d) = surface.domain
        point = gp_Pnt(*map(float, surface((a + 2 * b) / 3, (3 * c + d) / 4)))
        assert min(GeomAPI_ProjectPointOnSurf(point, each).LowerDistance() for each in theirs) < 1e-6


BEZIER = b"""ISO-10303-21;
DATA;
#1=CARTESIAN_POINT('',(0.,0.,0.));
#2=CARTESIAN_POINT('',(0.,1.,0.1));
#3=CARTESIAN_POINT('',(1.,0.,0.));
#4=CARTESIAN_POINT('',(1.,1.,0.));
#5=BEZIER_SURFACE('patch',1,1,((#1,#2),(#3,#4)),.UNSPECIFIED.,.F.,.F.,.F.);
#6=B_SPLINE_SURFACE_WITH_KNOTS('bad',1,1,((#1,#2),(#3)),.UNSPECIFIED.,.F.,.F.,.F.,(2,2),(2,2),(0.,1.),(0.,1.),.U.);
#7=PLANE('',#8);
#8=ADVANCED_FACE('',(#9),#5,.T.);
ENDSEC;
END-ISO-10303-21;
"""


def test_a_surface_that_is_not_one_is_skipped_and_others_are_read():
    reading = read(BEZIER, "step")
    assert reading.surface(0, 1) == (0, 1, Fraction(1, 10))
    [skipped] = reading.skipped
    assert "different lengths" in skipped.why
    assert not skipped.curve
    assert any("PLANE" in note for note in reading.notes)
    assert any("trims are not read" in note for note in reading.notes)


def test_curves_and_surfaces_are_not_written_into_one_file(tmp_path):
    with pytest.raises(CurveFileError, match="two files"):
        write([PLAIN, example("circle")], tmp_path / "both.g2")
