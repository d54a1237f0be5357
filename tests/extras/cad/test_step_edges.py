"""Edges of STEP files on lines, circles and ellipses, and GLIF: exact, or named as skipped."""

import pytest
from gmpy2 import mpq

from exactspline import ExactSplineError, read

HEAD = """ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;
#1=CARTESIAN_POINT('',(5.,0.,2.));#2=CARTESIAN_POINT('',(0.,5.,2.));#3=CARTESIAN_POINT('',(0.,0.,2.));
#4=CARTESIAN_POINT('',(1.,2.,3.));#5=CARTESIAN_POINT('',(2.,4.,6.));
#6=VERTEX_POINT('#9',#1);#7=VERTEX_POINT('',#2);#8=VERTEX_POINT('',#4);#9=VERTEX_POINT('',#5);
#10=DIRECTION('',(0.,0.,2.));#11=DIRECTION('',(3.,4.,0.));#12=DIRECTION('',(1.,1.,0.));#13=DIRECTION('',(1.,2.,3.));
#14=AXIS2_PLACEMENT_3D('',#3,#10,#11);#15=AXIS2_PLACEMENT_3D('',#3,#10,#12);#16=AXIS2_PLACEMENT_3D('',#3,$,$);
#17=CIRCLE('',#14,5.);#18=CIRCLE('',#15,5.);#19=ELLIPSE('',#16,5.,3.);#20=VECTOR('',#13,1.);#21=LINE('',#4,#20);
#22=LINE('',#3,#20);
"""


def curves(text):
    reading = read((HEAD + text + "\nENDSEC;\nEND-ISO-10303-21;\n").encode(), "step")
    used = {named.name: named.curve for named in reading.curves}
    return used, {skipped.where: skipped.why for skipped in reading.skipped}


def test_an_edge_on_a_circle_runs_from_vertex_to_vertex():
    found, _ = curves(
        "#30=EDGE_CURVE('',#6,#7,#17,.T.);#31=EDGE_CURVE('',#6,#7,#17,.F.);#32=EDGE_CURVE('',#6,#6,#17,.T.);"
    )
    quarter, rest, whole = found["#30"], found["#31"], found["#32"]
    for curve in (quarter, rest, whole):
        a, b = curve.domain
        for k in range(8):
            x, y, z = curve(a + (b - a) * mpq(k, 7))
            assert x * x + y * y == 25
            assert z == 2
    assert (quarter(quarter.domain[0]), quarter(quarter.domain[1])) == ((5, 0, 2), (0, 5, 2))
    assert quarter.segments == 1
    # the other way round the circle, reversed: from the second vertex on
    assert (rest(rest.domain[0]), rest(rest.domain[1])) == ((0, 5, 2), (5, 0, 2))
    assert rest.segments == 3
    assert whole.closed


def test_a_curve_that_no_edge_uses_is_whole_and_a_line_has_no_ends():
    found, skipped = curves("")
    assert set(found) == {"#17", "#19"}
    assert found["#19"].closed
    x, y, z = found["#19"]("1/3")
    assert (x / 5) ** 2 + (y / 3) ** 2 == 1
    assert z == 2
    assert "rational length" in skipped["#18"]
    assert "unbounded line" in skipped["#21"]


def test_an_edge_on_a_line_is_read_where_its_vertices_are_on_it():
    found, skipped = curves(
        "#30=EDGE_CURVE('#21',#8,#9,#21,.T.);#31=EDGE_CURVE('',#8,#9,#22,.T.);#32=EDGE_CURVE('',#8,#7,#21,.T.);"
    )
    # an edge is named by its entity
    assert found["#21"]("1/2") == (mpq(3, 2), 3, mpq(9, 2))
    # (0, 0, 2) + s (1, 2, 3) passes through neither vertex
    assert "away from the curve" in skipped["#31"]
    assert "away from the curve" in skipped["#32"]
    assert "#21" not in skipped


def test_a_vertex_is_moved_onto_its_curve_within_what_the_file_says():
    """Under --approximate; the circle stays exact, and the note says by how much."""
    off = "#40=CARTESIAN_POINT('',(5.00000001,0.,2.));#41=VERTEX_POINT('',#40);#42=EDGE_CURVE('',#41,#7,#17,.T.);"
    measure = "#43=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),#99,'a','');"
    texts = [(HEAD + each + "\nENDSEC;\nEND-ISO-10303-21;\n").encode() for each in (off, off + measure)]
    refused = [*read(texts[0], "step", approximate="1e-12").skipped, *read(texts[1], "step").skipped]
    why = [skipped.why for skipped in refused if skipped.where == "#42"]
    assert "away from the curve" in why[0]
    assert "not exactly on the curve" in why[1]
    found = {named.name: named for named in read(texts[1], "step", approximate="1e-12").curves}["#42"]
    x, y, z = found.curve(found.curve.domain[0])
    assert (x * x + y * y, z) == (25, 2)
    assert abs(x - 5) < mpq(1, 10**11)
    assert "an end is moved by 1.00E-8 onto the curve" in found.notes


def test_an_edge_on_a_surface_curve_is_followed():
    found, skipped = curves("#40=SURFACE_CURVE('',#21,(#99),.CURVE_3D.);#41=EDGE_CURVE('',#8,#9,#40,.T.);")
    assert found["#41"](1) == (2, 4, 6)
    assert "#21" not in skipped


@pytest.mark.parametrize("text", [
    "#30=EDGE_CURVE('',#6,#7,#17);", "#30=EDGE_CURVE('',#6,#7,#30,.T.);", "#30=EDGE_CURVE('',#8,#7,#17,.T.);",
    "#30=CIRCLE('',#14,0.);", "#30=CIRCLE('',#1,1.);", "#30=CIRCLE('',#30,1.);", "#30=ELLIPSE('',#14,1.,-1.);",
    "#30=EDGE_CURVE((),(),(),(),());", "#30=EDGE_CURVE('',#6,#7,(#17),.T.);", "#30=EDGE_CURVE('',$,$,#21,.T.);",
    "#33=DIRECTION('',(0.,0.));#34=AXIS2_PLACEMENT_3D('',#3,#33,$);#30=CIRCLE('',#34,1.);",
    "#33=DIRECTION('',(0.,0.,0.));#34=AXIS2_PLACEMENT_3D('',#3,#33,$);#30=CIRCLE('',#34,1.);",
])  # fmt: skip
def test_broken_edges_are_skipped_and_the_rest_goes_on(text):
    found, skipped = curves(text)
    assert "#30" not in found
    assert "#17" in found or "#17" not in skipped
    # an edge on anything else is left to the reader of that
    assert "#30" in skipped or "#7,#30" in text


GLIF = b"""<?xml version="1.0"?><glyph name="a" format="2"><unicode hex="0061"/><outline>
<component base="b"/>
<contour><point x="0" y="0.1" type="line"/><point x="10.3" y="0" type="line"/><point x="10" y="5"/>
<point x="5" y="10"/><point x="0" y="10" type="curve"/></contour>
<contour><point x="0" y="0"/><point x="4" y="0"/><point x="4" y="4"/><point x="0" y="4"/></contour>
<contour><point x="1" y="1" type="move"/><point x="2" y="2" type="line"/></contour>
<contour><point x="1" y="1" type="curl"/></contour><contour><point x="nan" y="1" type="line"/></contour>
<contour><point x="1" y="1" type="line"/><point x="1" y="2"/><point x="1" y="3"/><point x="3" y="3"/>
<point x="1" y="4" type="curve"/></contour></outline></glyph>"""


def test_glif_keeps_its_decimals():
    pytest.importorskip("fontTools")
    reading = read(GLIF)
    assert reading.format == "glif"
    cubic, ring, line, *more = [named.curve for named in reading.curves]
    assert cubic(0)[1] == mpq(1, 10)
    assert cubic(1)[0] == mpq(103, 10)
    assert cubic.closed
    assert (ring.degree, ring.closed, ring.segments) == (2, True, 4)
    assert line.degree == 1
    kinds = {skipped.what for skipped in reading.skipped}
    assert kinds == {"component", "contour"}
    assert len(reading.skipped) + len(more) >= 4
    for broken in (b"<glyph", b"<glyph/>x", b"<svg><glyph/></svg>"):
        with pytest.raises(ExactSplineError):
            read(broken, "glif")


def test_glif_against_the_reader_of_fonttools():
    pytest.importorskip("fontTools")
    from fontTools.pens.recordingPen import RecordingPen
    from fontTools.ufoLib.glifLib import readGlyphFromString

    class Glyph:
        pass

    good = GLIF.replace(b'<contour><point x="1" y="1" type="curl"/></contour>', b"")
    good = good.replace(b'<contour><point x="nan" y="1" type="line"/></contour>', b"")
    good = good[: good.rindex(b"<contour>")] + b"</outline></glyph>"
    from fontTools.pens.pointPen import PointToSegmentPen

    pen = RecordingPen()
    readGlyphFromString(good, Glyph(), PointToSegmentPen(pen))
    ends = [args[-1] for name, args in pen.value if name in ("lineTo", "curveTo") and args]
    curve = read(good).curves[0].curve
    ours = [curve(t) for t in curve.breakpoints[1:]]
    assert all(any(abs(float(a) - b) < 1e-9 and abs(float(c) - d) < 1e-9 for a, c in ours) for b, d in ends[:2])
