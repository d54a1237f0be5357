"""Small files of every format, made here: what the tests of the readers start from."""

import re
from io import BytesIO

from exactspline import Nurbs, example
from exactspline.extras.cad.iges import formatted
from exactspline.interchange.files import encoded

ARC = Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], weights=[1, 1, 2], name="arc")
CUBIC = Nurbs(3, [0, 0, 0, 0, "0.5", 1, 1, 1, 1], [(0, 0), ("0.1", 1), (2, -1), (3, "1.25"), (4, 0)], name="cubic")
SPACE = Nurbs(
    2, [0, 0, 0, "0.25", 1, 1, 1], [(0, 0, 1), (1, "0.5", 2), (2, 0, 3), (1, 1, 1)], weights=[1, 2, "0.5", 1], name="s"
)
UNCLAMPED = Nurbs(2, [0, 1, 2, 3, 4, 5, 6], [(0, 0), (1, 2), (3, 1), (4, 0)], name="unclamped")
CURVES = [ARC, CUBIC, SPACE, UNCLAMPED, example("circle")]

SVG = b"""<?xml version="1.0"?>
<svg xmlns="http://www.w3.org/2000/svg"><g transform="translate(1,2) scale(2)">
<path id="p" d="M0,0 L1 0 h1 v1 H0 Q1 1 2 0 T4 0 C1 2 3 4 5 6 S7 8 9 9 A5 5 0 0 1 14 14 Z m1-1.5.5e1z"/>
<rect x="1" y="1" width="2" height="3"/><circle r="2"/><polygon points="0,0 1,0 1,1"/></g>
<defs><path d="M0 0L1 1"/></defs></svg>
"""


GLIF = b"""<?xml version="1.0"?><glyph name="a" format="2"><outline><component base="b"/>
<contour><point x="0" y="0.1" type="line"/><point x="10.3" y="0" type="line"/><point x="10" y="5"/>
<point x="5" y="10"/><point x="0" y="10" type="curve"/></contour><contour><point x="0" y="0"/><point x="4" y="0"/>
<point x="4" y="4"/></contour><contour><point x="1" y="1" type="move"/><point x="2" y="2"/>
<point x="3" y="2" type="qcurve"/></contour></outline></glyph>"""


def dxf(words: str) -> bytes:
    """Group codes and values, by blanks, as the lines of a DXF file."""
    return "".join(f"{word}\n" for word in f"0 SECTION 2 ENTITIES {words} 0 ENDSEC 0 EOF".split()).encode()


DXF = dxf("""
0 LINE 10 0 20 0 11 1 21 1.5
0 CIRCLE 10 1 20 2 40 0.5
0 ARC 10 0 20 0 40 2 50 90 51 270 210 0 220 0 230 -1
0 ELLIPSE 10 0 20 0 11 2 21 1 40 0.5 41 0 42 6.283185307179586
0 LWPOLYLINE 90 3 70 1 10 0 20 0 42 0.5 10 1 20 0 10 1 20 1 42 -1
0 TEXT 1 hello
""")
STEP = b"""ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=CARTESIAN_POINT('',(0.,0.,0.));#2=CARTESIAN_POINT('',(1.,0.5,0.));
#3=CARTESIAN_POINT('',(2.,0.E+000,/* comment ; */1.));\n#4=BEZIER_CURVE('it''s',2,(#1,#2,#3),.UNSPECIFIED.,.F.,.F.);
#5=(BOUNDED_CURVE()B_SPLINE_CURVE(2,(#1,#2,#3),.UNSPECIFIED.,.F.,.F.)B_SPLINE_CURVE_WITH_KNOTS((3,3),(0.,1.),
.UNSPECIFIED.)CURVE()GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE((1.,0.5,1.))REPRESENTATION_ITEM('r'));
#6=POLYLINE('',(#1,#2,#3));#7=LINE('',#1,#2);#8=QUASI_UNIFORM_CURVE('',1,(#1,#2,#3),.UNSPECIFIED.,.F.,.F.);
#9=UNIFORM_CURVE('',2,(#1,#2,#3),.UNSPECIFIED.,.F.,.F.);
#10=DIRECTION('',(0.,0.,1.));#11=AXIS2_PLACEMENT_3D('',#1,#10,$);#12=CIRCLE('',#11,2.5);#13=CARTESIAN_POINT('',(2.5,0.,0.));
#14=CARTESIAN_POINT('',(0.,2.5,0.));#15=VERTEX_POINT('',#13);#16=VERTEX_POINT('',#14);#17=EDGE_CURVE('',#15,#16,#12,.T.);
#18=VECTOR('',#10,1.);#19=LINE('',#1,#18);#20=VERTEX_POINT('',#1);#21=EDGE_CURVE('',#20,#20,#22,.F.);
#22=SURFACE_CURVE('',#19,(#9),.CURVE_3D.);#23=ELLIPSE('',#11,2.,1.);\nENDSEC;\nEND-ISO-10303-21;\n"""
BREP = b"""DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\nLocations 0\nCurve2ds 3
7 1 1  2 3 4  0 0 1  2 0 1  1 2 0.5 \n 0 1 1 1 2 1 3 1\n1 0 0 1 0\n2 1 2 1 0 0 1 2.5\nCurves 3
6 0 2 0 0 0  1 0 0  1 1 1\n8 0.25 0.75\n7 0 0  1 2 2  0 0 0  1 1 1\n 0 2 1 2\n3 0 0 0 0 0 1 1 0 0 0 1 0 3 2\nPolygon3D 0
"""
ITD = b"""comment [OBJECT [rgb "1,2,[3"] NAME [CURVE BSPLINE 3 3 P2 [KV 0 0 0 1 1 1] [1 0 0] [0.5 1 0.25] [1. 2 2]]]
[OBJECT B [CURVE BEZIER 3 E2 [0 0] [1 1] [2 0]]] [OBJECT C [CURVE BSPLINE 4 3 E2 [KVP 0 1 2 3 4 5 6 7 8] [0 0] [1 0]
[1 1] [0 1]]] [OBJECT [SURFACE BEZIER 1 1 E3 [0 0 0]]]\n"""
G2 = b"""400 1 0 0\n1\n1 2 3\n130 1 0 0\n2\n1\n100 1 0 0\n2 0\n2 2\n0 0 1 1\n0 0\n0.1 1e-3\n
200 1 0 0\n1 0\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n1 2 3 4\n100 0 9 0\n2 1\n3 3\n0 0 0 1 1 1\n1 0 1\n1 1 1\n0 2 2\n"""
GEOMDL = b"""{"shape": {"type": "curve", "count": 2, "data": [
{"type": "spline", "rational": true, "dimension": 2, "degree": 2, "knotvector": [0, 0, 0, 1, 1, 1],
 "control_points": {"points": [[1, 0], [1, 1], [0, 1]], "weights": [1, 0.7, 1]}}, {"type": "spline", "degree": 1}]}}"""


SPLINE = "2,2,0,0,1,0, 0.,0.,0.,1.,1.,1., 1.,1.,1., 0.,0.,0.,1.,2.D0,0.,2.,0.,1., 0.,1., 0.,0.,0."


def iges() -> bytes:
    """A spline, an arc moved by a matrix, a conic, a line and a surface."""
    entities = [
        (126, 0, 0, "SPLINE", SPLINE.split(",")),
        (100, 0, 0, "ARC", ["0.5", "0.", "0.", "1.", "0.", "-1.", "0."]),
        (104, 1, 0, "CONIC", ["1.", "0.", "4.", "0.", "0.", "-4.", "0.", "2.", "0.", "0.", "1."]),
        (110, 0, 0, "LINE", ["0.", "0.", "0.", "1.", "1.", "1."]),
        (124, 0, 0, "MATRIX", ["0.", "-1.", "0.", "5.", "1.", "0.", "0.", "0.", "0.", "0.", "1.", "0."]),
        (128, 0, 0, "SURFACE", ["1", "3H;,,"]),
    ]
    # field 7 of the arc names the matrix, the fifth entity
    text = formatted(entities, "test").decode()
    return re.sub(r"(?m)^( {5}100[ 0-9]{8}( {7}0){4}) {7}0", r"\1       9", text).encode()


NAMES = [".notdef", "a", "ring", "both"]


def truetype() -> bytes:
    """A font with a line, a run of off-curve points, a contour of off-curve points alone, and a composite."""
    from fontTools.fontBuilder import FontBuilder
    from fontTools.pens.ttGlyphPen import TTGlyphPen

    def glyph(draw):
        pen = TTGlyphPen(None)
        draw(pen)
        return pen.glyph()

    def simple(pen):
        pen.moveTo((0, 0))
        pen.lineTo((100, 0))
        pen.qCurveTo((150, 50), (100, 100), (0, 100))
        pen.closePath()

    def ring(pen):
        pen.qCurveTo((0, 0), (100, 0), (100, 100), (0, 100), None)
        pen.closePath()

    def composite(pen):
        pen.addComponent("a", (1, 0, 0, 1, 10, 20))
        pen.addComponent("ring", (0.5, 0, 0, 0.5, 0, 0))

    glyphs = {".notdef": glyph(simple), "a": glyph(simple), "ring": glyph(ring), "both": _with(composite)}
    return _built(FontBuilder(1000, isTTF=True), lambda builder: builder.setupGlyf(glyphs))


def _with(draw):
    from fontTools.pens.ttGlyphPen import TTGlyphPen

    pen = TTGlyphPen({"a": None, "ring": None})
    draw(pen)
    return pen.glyph()


def _built(builder, outlines):
    builder.setupGlyphOrder(NAMES)
    builder.setupCharacterMap({97: "a"})
    outlines(builder)
    builder.setupHorizontalMetrics(dict.fromkeys(NAMES, (500, 0)))
    builder.setupHorizontalHeader()
    builder.setupNameTable({"familyName": "Test", "styleName": "Regular"})
    builder.setupOS2()
    builder.setupPost()
    stream = BytesIO()
    builder.font.save(stream)
    return stream.getvalue()


def cff() -> bytes:
    """A font with a cubic contour."""
    from fontTools.fontBuilder import FontBuilder
    from fontTools.pens.t2CharStringPen import T2CharStringPen

    def charstring():
        pen = T2CharStringPen(500, None)
        pen.moveTo((0, 0))
        pen.curveTo((50, 100), (100, 100), (150, 0))
        pen.lineTo((75, -50))
        pen.closePath()
        return pen.getCharString()

    names = [".notdef", "a", "ring", "both"]
    return _built(
        FontBuilder(1000, isTTF=False), lambda b: b.setupCFF("Test", {}, {n: charstring() for n in names}, {})
    )


def seeds() -> dict[str, list[bytes]]:
    """Files of every text format and of fonts, by the name of the format."""
    written = {
        name: [encoded([c], name)[0] for c in CURVES]
        for name in ("json", "g2", "geomdl", "gismo", "itd", "iges", "step", "brep", "dxf")
    }
    by_hand = {"g2": G2, "geomdl": GEOMDL, "itd": ITD, "step": STEP, "brep": BREP, "dxf": DXF, "iges": iges()}
    for name, data in by_hand.items():
        written[name].append(data)
    written["json"].append(encoded(CURVES, "json")[0])
    return written | {
        "glif": [GLIF],
        "svg": [SVG, encoded([CUBIC], "svg")[0]],
        "cptw": [b"0,-1,1\n-0.7,-0.7,0.7\n-1,0,1"],
    }
