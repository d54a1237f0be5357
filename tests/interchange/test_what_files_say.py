"""What a file says of its curves beyond their control points is honoured or named: nothing is left out in silence."""

import time
import tracemalloc

import pytest
from gmpy2 import mpq

from exactspline import read
from exactspline.errors import CurveFileError, ShapeError
from exactspline.interchange import Limits
from tests.support.interchange_seeds import SPLINE, STEP, dxf, truetype


def svg(inside, **of_root):
    given = "".join(f' {key}="{value}"' for key, value in of_root.items())
    return read(f'<svg xmlns="http://www.w3.org/2000/svg"{given}>{inside}</svg>'.encode(), "svg")


def ends(reading):
    return [tuple(tuple(map(int, named.curve(t))) for t in named.curve.domain) for named in reading.curves]


LINE = '<path d="M0 0L8 0"/>'


def line(given):
    return LINE.replace("/>", f" {given}/>")


# ---- SVG: where a transform acts, and what CSS says


@pytest.mark.parametrize(("given", "expected"), [
    ('transform="rotate(90)" transform-origin="4 0"', ((4, -4), (4, 4))),
    ('transform="rotate(90)" style="transform-origin: 4px 0"', ((4, -4), (4, 4))),
    ('transform="scale(2)" transform-origin="1in 96"', ((-96, -96), (-80, -96))),
    ('transform="scale(2)" transform-origin="left top"', ((0, 0), (16, 0))),
    ('transform-origin="50% 50%"', ((0, 0), (8, 0))),
    ('transform="scale(2)" style="transform: none"', ((0, 0), (8, 0))),
])  # fmt: skip
def test_a_transform_acts_about_its_origin(given, expected):
    """False before: a rotation with transform-origin="4 0" was read as one about (0, 0)."""
    assert ends(svg(line(given))) == [expected]


@pytest.mark.parametrize("given", [
    'transform="scale(2)" transform-origin="50% 50%"', 'transform="scale(2)" transform-origin="center"',
    'transform="scale(2)" transform-origin="1 1" transform-box="fill-box"', 'style="rotate: 20deg"',
    'style="tr\\61nsform: scale(2)"', 'style="d: path(\'M0 0L1 1\')"', 'style="fill: red; scale: 2"',
    'transform="scale(2)" style="transform-origin: 1 1"', 'style="/* a */TRANSFORM:scale(2)"',
])  # fmt: skip
def test_what_moves_a_shape_in_a_way_that_is_not_followed_skips_it(given):
    """False before: transforms, origins and path data in CSS were left out, and the curve read where it is not."""
    reading = svg(line(given))
    assert not reading.curves
    assert not reading.complete


@pytest.mark.parametrize(("sheet", "moved"), [
    ("path { transform: rotate(20deg) }", True), (".a:hover > path.b, circle { d: none }", True),
    ("#p { transform-origin: 1px 1px }", True), ("@media print { svg|path { translate: 1px } }", True),
    (":is(.x, .b) { transform: none }", True), (".a\\:b { transform: none }", True),
    ("g { .b { transform: none } }", True), ("* { all: unset }", True), ("path { transform: scale(2)", True),
    ("circle { transform: scale(2) }", False), (".c { d: none }", False), ("path { fill: red; stroke: 'd:e' }", False),
    ("path { r: 3px }", False), ("/* path { transform: scale(2) } */", False), ("path.b#q { d: none }", False),
    ("@font-face { transform: none } @keyframes k { from { transform: none } }", False),
    ('path { content: "} path { d: none"; fill: url(a;b) }', False),
])  # fmt: skip
def test_style_sheets_that_may_move_or_shape_a_curve_skip_it(sheet, moved):
    """False before: a style sheet's transform, r or d was ignored, and the attribute's shape was given."""
    reading = svg(f"<style>{sheet.replace('>', '&gt;')}</style>" + line('class="b" id="p"'))
    assert len(reading.curves) == (not moved)
    assert reading.complete is not moved


@pytest.mark.parametrize("shape", ['circle r="2"', 'rect width="2" height="1"', 'ellipse rx="2" ry="1"'])
def test_shapes_whose_sizes_are_set_in_css_are_skipped(shape):
    """False before: a circle of radius 2 where a style sheet says r: 5px."""
    assert len(svg(f"<{shape}/>").curves) == 1
    size = "r" if shape.startswith("circle") else "rx"
    assert not svg(f'<{shape} style="{size}: 5px"/>').curves
    assert not svg(f"<style>{shape.split()[0]} {{ {size}: 5px }}</style><{shape}/>").curves


def test_a_sheet_in_another_file_and_a_script_are_named():
    assert svg("<style>@import 'more.css';</style>" + LINE).notes
    assert read(b'<?xml-stylesheet href="a.css"?><svg><path d="M0 0L1 1"/></svg>', "svg").notes
    assert svg("<script>move()</script>" + LINE).notes
    assert svg(LINE[:-2] + '><animateTransform type="rotate"/></path>').notes
    assert not svg(LINE).notes


def test_a_sheet_with_anything_in_it_ends():
    sheet = "{" * 10_000 + "}" * 20_000 + "(" * 10_000 + '"' + "\\" * 1001
    assert len(svg(f"<style>{sheet}</style>" + LINE).curves) == 1


# ---- SVG: what is drawn


def test_the_first_child_of_a_switch_that_can_be_drawn_is_drawn():
    """False before: all alternatives of a switch were curves of the drawing."""
    inside = (
        '<switch><path requiredExtensions="http://e.org/x" d="M0 0L1 1"/><path systemLanguage="de" d="M0 0L2 2"/>'
        '<desc>text</desc><g display="none"><path d="M0 0L3 3"/></g><path d="M0 0L4 4"/></switch>'
    )
    reading = svg(inside)
    assert not reading.curves
    assert len(reading.skipped) == 4
    # nothing that is drawn is missing
    assert reading.complete
    assert ends(svg(inside.replace(' display="none"', ""))) == [((0, 0), (3, 3))]


def test_elements_of_other_namespaces_are_not_drawn():
    """False before: elements of other programs that are called path, circle or g were curves of the drawing."""
    other = '<x:g xmlns:x="urn:x"><path id="b" d="M0 0L2 0"/></x:g><i:path d="M0 0L3 0"/>'
    late = '<s:path xmlns:s="http://www.w3.org/2000/svg" d="M0 0L4 0"/><g xmlns="urn:y"><circle r="1"/></g>'
    reading = svg(f'{LINE}{other}{late}<switch><x:g xmlns:x="urn:x"/>{LINE}</switch><use href="#b"/>')
    assert ends(reading) == [((0, 0), (8, 0)), ((0, 0), (4, 0)), ((0, 0), (8, 0)), ((0, 0), (2, 0))]
    assert [s.what for s in reading.skipped] == ["path", "path", "circle"]
    assert all("namespace" in s.why and not s.curve for s in reading.skipped)
    for root, given in (("svg", ""), ("s:svg", ' xmlns:s="http://www.w3.org/2000/svg"')):
        alone = read(f'<{root}{given}><path d="M0 0L1 0"/><s:path d="M0 0L2 0"/></{root}>'.encode(), "svg")
        assert ends(alone) == [((0, 0), (1 if root == "svg" else 2, 0))]
    page = f'<html xmlns="http://www.w3.org/1999/xhtml"><p/><svg xmlns="http://www.w3.org/2000/svg">{LINE}</svg></html>'
    assert ends(read(page.encode(), "svg")) == [((0, 0), (8, 0))]


def test_copies_are_placed():
    """False before: a use was left out, and the command ended with 0."""
    reading = svg(
        '<defs><g id="g" transform="scale(2)"><path id="l" d="M1 0L2 0"/></g>'
        '<symbol id="s"><path d="M0 0L1 1"/></symbol></defs>'
        '<use href="#g" x="1" y="1" transform="translate(10)"/><use xlink:href="#s" y="5"/>',
        **{"xmlns:xlink": "http://www.w3.org/1999/xlink"},
    )
    assert ends(reading) == [((13, 1), (15, 1)), ((0, 5), (1, 6))]
    assert reading.complete


@pytest.mark.parametrize("inside", [
    '<use href="#none"/>', '<use href="other.svg#a"/>', '<use/>', '<g id="g"><use href="#g"/></g>',
    '<symbol id="s" viewBox="0 0 1 1"><path d="M0 0L1 1"/></symbol><use href="#s"/>',
    '<svg viewBox="0 0 9 9"><path d="M0 0L1 1"/></svg>',
])  # fmt: skip
def test_copies_and_views_that_are_not_followed_are_named(inside):
    reading = svg(inside)
    assert not reading.curves
    assert not reading.complete


def test_copies_of_copies_are_counted():
    bomb = "".join(f'<g id="a{i}">' + f'<use href="#a{i + 1}"/>' * 10 + "</g>" for i in range(9))
    with pytest.raises(ShapeError, match="objects"):
        read(f'<svg>{bomb}<path id="a9" d="M0 0L1 1"/></svg>'.encode(), "svg", limits=Limits(objects=5_000))


@pytest.mark.parametrize(("given", "drawn"), [
    ('display="none"', False), ('style="display: none"', False), ('visibility="hidden"', True),
    ('clip-path="url(#c)"', True), ('mask="url(#m)"', True), ('style="clip-path: circle(3px)"', True),
])  # fmt: skip
def test_what_hides_a_curve_or_a_part_of_it_is_named(given, drawn):
    """False before: what is not displayed, and what is cut by a clip path, was read without a word."""
    for inside in (line(given), f"<g {given}>{LINE}</g>"):
        reading = svg(inside)
        assert len(reading.curves) == drawn
        assert reading.complete
        assert bool(reading.skipped) is not drawn
        assert all(named.notes for named in reading.curves)


def test_a_style_sheet_that_may_hide_a_curve_is_named():
    [named] = svg("<style>path { display: none }</style>" + LINE).curves
    assert "may hide" in named.notes[0]


@pytest.mark.parametrize("data", ["L1 1", "M1", "M0 0 L", "M0 0 L 1", "#", "M0 0 A1 1 0 2 0 1 1"])
def test_path_data_whose_first_segment_fails_are_named(data):
    """False before: such a path was neither a curve nor among the skipped."""
    reading = svg(f'<path d="{data}"/>')
    assert not reading.curves
    assert reading.skipped
    assert not reading.complete


@pytest.mark.parametrize("shape", ["path", 'path d=""', 'path d="M1 1"', 'circle r="0"', 'rect width="-1" height="1"'])
def test_shapes_of_which_nothing_is_drawn_are_named(shape):
    """False before: a rectangle of negative width was a curve; paths without a segment were nowhere."""
    reading = svg(f"<{shape}/>")
    assert (len(reading.curves), len(reading.skipped)) == (0, 1)
    assert reading.complete


def test_lengths_have_units_and_a_radius_left_out_is_the_other():
    assert svg('<line x2="1in" y2="2.54cm"/>').curves[0].curve(1) == (96, 96)
    assert svg('<ellipse rx="3"/>').curves[0].curve(1) == (0, 3)
    assert not svg('<line x2="50%"/>').complete
    [odd] = svg('<polyline points="0 0 1 1 2"/>').curves
    assert "odd number" in odd.notes[0]
    [unknown] = svg("<thing>" + LINE + "</thing>").curves
    assert "<thing>" in unknown.notes[0]


def test_segments_are_counted_before_they_are_built():
    """False before: not an answer but its cost, 33 s and 2.1 GB for a million segments that are refused in the end."""
    data = b'<svg><path d="M0 0' + b"h1v1" * 100_000 + b'"/></svg>'
    start = time.process_time()
    tracemalloc.start()
    with pytest.raises(ShapeError, match="objects"):
        read(data, "svg", limits=Limits(objects=400_000))
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert time.process_time() - start < 4
    assert peak < 30e6


@pytest.mark.parametrize(
    "letters", ["h1", "v1", "l1 1", "c1 2 3 4 5 6", "q1 2 3 4", "t1 1", "s1 2 3 4", "a1 1 0 111 1"]
)
def test_the_count_beforehand_is_never_too_large(letters):
    reading = svg(f'<path d="M0 0{letters * 20}"/>')
    curve = reading.curves[0].curve
    own = len(curve.knots) + len(curve.control_points)
    limits = Limits(objects=own + 40)
    assert read(f'<svg><path d="M0 0{letters * 20}"/></svg>'.encode(), "svg", limits=limits).curves


# ---- XML


def test_entities_without_entities_in_them_are_read():
    """False before: a file of Adobe Illustrator with a declared entity was refused whole."""
    head = '<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "svg11.dtd" [<!ENTITY ns "http://e.org"><!ENTITY x "L1 1">]>'
    reading = read(f'{head}<svg xmlns:i="&ns;"><path d="M0 0&x;"/></svg>'.encode(), "svg")
    assert ends(reading) == [((0, 0), (1, 1))]


@pytest.mark.parametrize(("data", "why"), [
    ('<!DOCTYPE svg [<!ENTITY x "y"><!ENTITY z "&x;">]><svg>&z;</svg>', "contains entities"),
    ('<!DOCTYPE svg [<!ENTITY x "y"><!ENTITY z "&#38;x;">]><svg>&z;</svg>', "contains entities"),
    ('<!DOCTYPE svg [<!ENTITY x SYSTEM "/etc/passwd">]><svg>&x;</svg>', "another file"),
    ('<!DOCTYPE svg [<!ENTITY % p "q"> %p;]><svg/>', "parameter entity"),
    ('<!DOCTYPE svg SYSTEM "x.dtd"><svg d="M0 0&x;"/>', "not declared"),
    ('<svg d="&x;"/>', "undefined entity"),
    (f'<!DOCTYPE svg [<!ENTITY x "{"y" * 100_000}">]><svg d="{"&x;" * 1000}"/>', "1000 times"),
], ids=["nested", "nested by a character", "file", "parameter", "not declared", "no doctype", "quadratic"])  # fmt: skip
def test_other_entities_are_refused(data, why):
    """False before: an entity of a DTD that is not read was replaced by nothing, without a word."""
    with pytest.raises(CurveFileError, match=why):
        read(data.encode(), "svg")


def test_an_ampersand_in_a_comment_is_no_entity():
    data = b'<!DOCTYPE svg SYSTEM "x"><svg><!-- &x; --><text><![CDATA[&y;]]></text><path d="M0 0L1 1"/></svg>'
    assert len(read(data, "svg").curves) == 1


# ---- fonts


def collection(count=2):
    """A collection of fonts that are equal but for the width of the first."""
    from io import BytesIO

    from fontTools.ttLib import TTFont
    from fontTools.ttLib.ttCollection import TTCollection

    found, made = BytesIO(), TTCollection()
    made.fonts = [TTFont(BytesIO(truetype())) for _ in range(count)]
    made.save(found)
    return found.getvalue()


def test_all_fonts_of_a_collection_are_read(tmp_path):
    """False before: the curves of a collection were those of its first font."""
    one, both = read(truetype()).curves, read(collection(3)).curves
    assert [named.name for named in both[len(one) : 2 * len(one)]] == [f"2/{named.name}" for named in one]
    assert [named.curve for named in both] == [named.curve for named in one] * 3
    place = tmp_path / "a.ttc"
    place.write_bytes(collection())
    [first, second] = read(f"{place}:a").curves
    assert (first.name, second.name) == ("a.1", "2/a.1")
    assert [named.name for named in read(f"{place}:2/a").curves] == ["2/a.1"]
    with pytest.raises(CurveFileError, match="no glyph"):
        read(f"{place}:3/a")


def test_fonts_say_their_unit_and_overlaps():
    reading = read(truetype())
    assert any("per em" in note for note in reading.notes)
    from io import BytesIO

    from fontTools.ttLib import TTFont

    font, out = TTFont(BytesIO(truetype())), BytesIO()
    font["glyf"]["a"].flags[0] |= 0x40
    font.save(out)
    marked = {named.name for named in read(out.getvalue()).curves if "marked: contours may overlap" in named.notes}
    assert marked == {"a.1"}


# ---- IGES


def iges_spline(start, end, status="00000000"):
    from exactspline.extras.cad.iges import formatted

    *rest, _, _, x, y, z = SPLINE.split(",")
    data = formatted([(126, 0, 0, "S", [*rest, start, end, x, y, z])], "one spline")
    return data.replace(b"00000000D", status.encode() + b"D", 1)


@pytest.mark.parametrize(("start", "end", "domain"), [
    ("0.25", "0.75", ("1/4", "3/4")), ("0.", "1.", (0, 1)), ("0.5", "7.", ("1/2", 1)), ("1.", "2.", (0, 1)),
    ("0.", "0.", (0, 1)),
])  # fmt: skip
def test_a_spline_is_read_over_the_parameters_that_its_entity_uses(start, end, domain):
    """False before: the whole spline where V(0), V(1) are inside of the knots."""
    whole = read(iges_spline("0.", "1.")).curves[0].curve
    [named] = read(iges_spline(start, end)).curves
    a, b = map(mpq, domain)
    assert named.curve.domain == (a, b)
    assert all(named.curve(a + (b - a) * k / 4) == whole(a + (b - a) * k / 4) for k in range(5))
    assert any("parameters" in note for note in named.notes) is ((start, end) != ("0.", "1."))


def test_iges_units_and_blanked_entities_are_named():
    reading = read(iges_spline("0.", "1.", "01000000"))
    assert reading.notes == ("lengths in millimetres: read as written",)
    assert any("blanked" in note for note in reading.curves[0].notes)


# ---- DXF, STEP


def test_dxf_says_units_blocks_and_what_is_hidden():
    """False before: a curve of a block, in paper space or invisible was read like any other, without a note."""
    at = "10 0 20 0 11 1 21 1"
    reading = read(dxf(f"0 LINE 67 1 {at} 0 LINE 60 1 {at} 0 LINE 39 2.5 {at} 0 LINE 39 0.0 {at} 0 INSERT 2 B"))
    assert [bool(named.notes) for named in reading.curves] == [True, True, True, False]
    assert [(skipped.what, skipped.curve) for skipped in reading.skipped] == [("INSERT", True)]
    head = "0 SECTION 2 HEADER 9 $INSUNITS 70 4 0 ENDSEC 0 SECTION 2 BLOCKS 0 BLOCK 2 B"
    block = f"{head} 0 LINE {at} 0 ENDBLK 0 ENDSEC 0 EOF"
    reading = read("".join(f"{word}\n" for word in block.split()).encode())
    assert reading.notes == ("lengths in millimetres: read as written",)
    assert "block" in reading.curves[0].notes[0]


def test_step_says_units_placements_and_parameter_planes():
    """False before: a curve in the parameter plane of a surface looked like one of the part."""
    more = (
        b"#40=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));#41=(CONVERSION_BASED_UNIT('INCH',#42)"
        b"LENGTH_UNIT()NAMED_UNIT(#43));#44=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#41))"
        b"REPRESENTATION_CONTEXT('',''));#45=DEFINITIONAL_REPRESENTATION('',(#4),#46);"
        b"#47=MAPPED_ITEM('',#1,#2);#48=CURVE_REPLICA('',#4,#1);ENDSEC;\nEND-ISO"
    )
    reading = read(STEP.replace(b"ENDSEC;\nEND-ISO", more))
    assert set(reading.notes) == {
        "lengths in inch: read as written", "the file places parts: curves are read where they are defined",
    }  # fmt: skip
    inside = [named.name for named in reading.curves if "in the parameter plane of a surface" in named.notes]
    assert inside == ["it's"]
    assert ("CURVE_REPLICA", True) in [(skipped.what, skipped.curve) for skipped in reading.skipped]


def test_step_names_what_it_does_not_read_of_complex_instances():
    """Passed before: a file is complete whose trimmed curve is a complex instance, known by its first keyword alone."""
    rest = "CURVE()GEOMETRIC_REPRESENTATION_ITEM()"
    more = (
        f"#40=(BOUNDED_CURVE(){rest}REPRESENTATION_ITEM('')TRIMMED_CURVE(#4,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(0.5)),"
        f".T.,.PARAMETER.));#41=(BOUNDED_CURVE()COMPOSITE_CURVE((#42),.F.){rest}REPRESENTATION_ITEM(''));"
        "#43=(MAPPED_ITEM(#1,#2)REPRESENTATION_ITEM(''));ENDSEC;\nEND-ISO"
    )
    reading = read(STEP.replace(b"ENDSEC;\nEND-ISO", more.encode()))
    assert ("TRIMMED_CURVE", True) in [(skipped.what, skipped.curve) for skipped in reading.skipped]
    assert ("COMPOSITE_CURVE", False) in [(skipped.what, skipped.curve) for skipped in reading.skipped]
    assert "the file places parts: curves are read where they are defined" in reading.notes


@pytest.mark.parametrize("text", [
    "#40=CARTESIAN_POINT('',(0.,0.));#41=VERTEX_POINT('',#40);#42=DIRECTION('',(1.,0.,0.));#43=VECTOR('',#42,1.);"
    "#44=LINE('',#1,#43);#45=EDGE_CURVE('',#41,#41,#44,.T.);",
    "#42=DIRECTION('',(1.,0.));#43=VECTOR('',#42,1.);#44=LINE('',#1,#43);"
    "#45=TRIMMED_CURVE('',#44,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(1.)),.T.,.PARAMETER.);",
    "#40=CARTESIAN_POINT('',(0.,0.));#41=AXIS2_PLACEMENT_3D('',#40,$,$);#45=CIRCLE('',#41,2.);",
])  # fmt: skip
def test_points_in_the_plane_and_in_space_together_are_named(text):
    """A traceback before."""
    found = read(STEP.replace(b"ENDSEC;\nEND-ISO", f"{text}ENDSEC;\nEND-ISO".encode()))
    [why] = [skipped.why for skipped in found.skipped if skipped.where == "#45"]
    assert "coordinates; write as many for each" in why


def test_a_file_that_is_cut_off_says_so():
    """Passed before: files that end within an instance, or without their last line, held all of their curves."""
    whole = read(STEP)
    assert not [note for note in whole.notes if "cut off" in note]
    cut = read(STEP[: STEP.index(b"(#1,#2,#3))", STEP.index(b"#6=POLYLINE"))])
    assert ("#6", True) in [(skipped.where, skipped.curve) for skipped in cut.skipped]
    assert [note for note in cut.notes if "END-ISO-10303-21 is missing" in note]
    twice = read(STEP.replace(b"#6=POLYLINE('',(#1,#2,#3));", b"#6=POLYLINE('',(#1,#2,#3));#6=POLYLINE('',(#1,#2));"))
    assert ("#6", True) in [(skipped.where, skipped.curve) for skipped in twice.skipped]
    assert len(twice.curves) == len(whole.curves)
    line = dxf("0 LINE 10 0 20 0 11 1 21 1")
    assert not read(line).notes
    assert read(line.replace(b"EOF", b"")).notes == ("EOF is missing: the file may be cut off",)
    without_knots = b"#40=RATIONAL_B_SPLINE_CURVE('',2,(#1,#2,#3),.UNSPECIFIED.,.F.,.F.,(1.,2.,1.));ENDSEC;\nEND-ISO"
    assert "#40" in [skipped.where for skipped in read(STEP.replace(b"ENDSEC;\nEND-ISO", without_knots)).skipped]
    plane = b"CASCADE Topology V1\nCurve2ds 1\n6 0 1 0 0 1 1\n"
    assert not read(plane + b"Curves 0\n").notes
    assert read(plane).notes == ("there is no section Curves: the file may be cut off",)


def test_notes_in_our_own_json_are_kept():
    """False before: the note of a curve in {"curves": […]} was lost."""
    entry = '{"degree": 1, "knots": [0, 0, 1, 1], "control_points": [[0, 0], [1, 1]], "note": "from a paper"}'
    assert read(f'{{"curves": [{entry}]}}'.encode()).curves[0].notes == ("from a paper",)


# ---- beside other readers, on files made here


@pytest.mark.parametrize("inside", [
    '<defs><path id="a" d="M1 2C3 4 5 6 7 9"/></defs><use href="#a" x="3" y="4" transform="scale(2)"/>',
    '<g transform="translate(3 4) rotate(90)"><use href="#a" x="1"/></g><path id="a" d="M1 2L5 7"/>',
    '<path d="M0 0Q4 1 2 3" transform="matrix(1 2 3 5 7 11) scale(2 3) skewX(45)"/>',
    '<ellipse cx="1in" cy="2cm" rx="3mm" ry="4pt" transform="translate(1)"/>', '<rect width="3" height="4"/>',
])  # fmt: skip
def test_placed_shapes_beside_svgelements(inside):
    """Ends of all segments of what is drawn, by a reader that shares no code."""
    svgelements = pytest.importorskip("svgelements")
    from io import StringIO

    text = f'<svg xmlns="http://www.w3.org/2000/svg">{inside}</svg>'
    shapes = [each for each in svgelements.SVG.parse(StringIO(text), ppi=96).elements()
              if isinstance(each, svgelements.Shape)]  # fmt: skip
    theirs = [
        (round(float(point.x), 3), round(float(point.y), 3))
        for shape in shapes
        for segment in svgelements.Path(shape).reify()
        if not isinstance(segment, svgelements.Move) and segment.start != segment.end
        for point in (segment.start, segment.end)
    ]
    ours = [
        tuple(round(float(x), 3) for x in named.curve(t))
        for named in read(text.encode(), "svg").curves
        for t in named.curve.breakpoints
    ]
    assert theirs
    assert set(theirs) == set(ours)
