"""How objects show themselves: complete, well-formed, escaped, and no longer than one can read."""

import re
import subprocess
import sys
from html.parser import HTMLParser
from xml.etree import ElementTree

import pytest

from exactspline import Verdict, claims, examples, formula_of

pytest.importorskip("matplotlib")

from exactspline import BSpline, Nurbs, derive, example, latex, zeros
from exactspline.display import html, short
from exactspline.language import Vector
from exactspline.language.kinds import CURVE
from exactspline.papers import all_formulas, papers
from exactspline.readings import DegreeReading, JetReading, parse_degree, trace
from exactspline.readings.degree import Degree
from exactspline.tables import (
    Grid,
    construction,
    control_point_count,
    degree_table,
    measured,
    printed_numbers,
    reduction_table,
    statements,
    symbolic_table,
    verdicts,
)
from exactspline.verification.statement import sides
from tests.support.decided import errors_in_print


class Balanced(HTMLParser):
    """A parser that insists on every tag being closed."""

    def __init__(self, text):
        super().__init__()
        self.open, self.text = [], []
        self.feed(text)
        self.close()
        assert not self.open

    def handle_starttag(self, tag, attrs):
        if tag not in ("br", "wbr"):
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        pass

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.text.append(data)


def text_of(x):
    return " ".join(Balanced(html(x)).text)


def is_latex(text):
    """Whether it is plain LaTeX: no sign that only the text printer writes, and braces that match."""
    depth = 0
    for sign in text.replace(r"\{", "").replace(r"\}", ""):
        depth += (sign == "{") - (sign == "}")
        assert depth >= 0, text
    return depth == 0 and text.isascii() and text.isprintable() and text.count(r"\left") == text.count(r"\right")


# ---- HTML and pictures


def picture_of(thing):
    """The picture in what a notebook shows of an object; empty where there is none."""
    found = re.search(r"<svg.*?</svg>", html(thing), re.DOTALL)
    return found[0] if found else ""


@pytest.mark.parametrize("name", examples("curves"))
def test_every_example_curve_shows_a_picture_and_its_facts(name):
    curve = example(name)
    text = text_of(curve)
    assert name in text
    assert f"degree {curve.degree}" in text
    picture = ElementTree.fromstring(picture_of(curve))
    colours = [line.get("stroke") for line in picture.iter("{http://www.w3.org/2000/svg}polyline")]
    assert sum(colour in ("currentColor", "#7A7A7A") for colour in colours) == curve.segments


def test_the_picture_of_a_curve_has_equal_scales_and_stays_inside():
    square = Nurbs(1, [0, 0, 1, 2, 3, 3], [(0, 0), (7, 0), (7, 7), (0, 7)])
    picture = ElementTree.fromstring(picture_of(square))
    points = [
        tuple(map(float, p.split(",")))
        for line in picture.iter("{http://www.w3.org/2000/svg}polyline")
        for p in line.get("points").split()
    ]
    (x0, x1), (y0, y1) = [(min(c), max(c)) for c in zip(*points, strict=True)]
    assert x1 - x0 == y1 - y0
    assert 0 <= x0 < x1 <= float(picture.get("width"))
    assert 0 <= y0 < y1 <= float(picture.get("height"))
    assert picture_of(Nurbs(1, [0, 0, 1, 1], [(0, 0, 0, 0), (1, 1, 1, 1)])) == ""


def test_a_function_shows_its_graph_unless_it_has_no_points():
    f = formula_of("g2")(example("ellipse"))
    assert f"{len(f.control_points)}: " in text_of(f)
    assert "<circle" in picture_of(f)
    assert picture_of(f.d(f.degree + 1)) == ""
    wild = BSpline.bezier([(-1) ** i * i * (40 - i) for i in range(41)])
    assert "<circle" not in picture_of(wild)


def test_roots_jumps_and_stretches_are_all_listed():
    f = BSpline(2, [0, 0, 0, 1, 1, 1, 2, 3, 3, 3, 4, 4, 4], [1, -1, 2, -1, 0, 0, 0, 3, -1, "1/2"])
    found = zeros(f)
    text = text_of(found)
    assert (text.count("jump at "), text.count("zero on [")) == (len(found.jumps), len(found.intervals))
    assert min(len(found.jumps), len(found.intervals)) > 0
    # the words of the interpreter stood on the page
    assert "Jump at" not in text
    assert "ZeroInterval" not in text
    across = zeros(BSpline(1, [0, 0, 1, 2, 3, 4, 4], [0, 0, 1, 0, 0]), periodic=True)
    assert "zero on [3, 4] and [0, 1]" in across._repr_html_()
    golden = zeros(BSpline.bezier([-1, "-1/2", 1]))
    assert latex(golden[0]) == r"$$s = (-1 + \sqrt{5})/2$$"
    assert latex(zeros(BSpline.bezier([-1, 1]))[0]) == r"$$s = \tfrac{1}{2}$$"


def test_pieces_and_what_is_missing_are_told():
    text = text_of(derive("evolute", example("straight_between_arcs")))
    assert "straight" in text
    assert "[1, 2]" in text


def test_text_is_escaped():
    curve = Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 1)], name="<b>&", note="</td>")
    assert "<b>&" in text_of(curve)
    assert Balanced(Grid(["<i>"], [["<script>"]], "a < b").html()).text == ["a < b", "<i>", "<script>"]


def test_claims_statements_rows_and_errata_show_themselves():
    for claim in claims():
        assert claim.id in text_of(claim)
        assert len(sides(claim)) == len(set(claim.named))
    entry = errors_in_print()[0]
    assert entry.statements[0].statement in text_of(entry)
    assert str(next(statements("C4.2b")).finding.witness) in text_of(next(statements("C4.2b")))
    assert Verdict.REFUTED in text_of(verdicts("C4.2b").rows_of_ledger[0])


# ---- LaTeX


def test_every_formula_is_latex():
    for formula in all_formulas().values():
        printed = latex(formula)
        assert is_latex(printed), formula
        symbol, equals, body = printed.strip("$").partition(" = ")
        assert symbol != body, formula
        assert equals or symbol == formula.symbol, formula


def test_a_tree_is_spelled_out_only_where_it_would_repeat_the_symbol():
    spelled = 0
    for formula in all_formulas().values():
        if formula.kind.name not in ("curve", "plane", "space") or not formula.symbol:
            continue
        plain, full = (
            latex(trace(formula, formula.kind.dimensions[-1], expand=way)).strip("$") for way in (False, True)
        )
        repeats = plain.replace(r"\left", "").replace(r"\right", "") == formula.symbol
        assert latex(formula).strip("$").split(" = ")[-1] == (full if repeats else plain), formula
        spelled += repeats
    assert spelled


def test_numbers_degrees_jets_and_vectors_are_latex():
    d = DegreeReading().argument(CURVE, 2)
    assert latex(formula_of("f2")(d)) == "$$3d - 3$$"
    assert latex(Degree.named("d1").max(Degree.named("d2"))) == r"$$\max(d_2, d_1)$$"
    assert is_latex(latex(formula_of("f2")(JetReading(2).argument(CURVE, 2))))
    assert is_latex(latex(Vector(BSpline.bezier([0, "1/2"]), BSpline.bezier([1, 2]))))


@pytest.mark.parametrize("source", papers(), ids=lambda source: source.name)
def test_every_claim_of_every_paper_is_latex(source):
    for claim in claims(paper=source):
        assert is_latex(claim.latex.replace("−", "-").replace("…", "").replace("δ", "").replace("ö", "o")), claim.key
        if source.default:
            assert all(is_latex(side.latex) for side in sides(claim)), claim.key


# ---- short texts and tables


def test_what_would_be_long_is_described_in_one_line():
    value = formula_of("evolute")(example("ellipse"))
    assert "108 control points" in short(value)
    assert len(short(formula_of("curvature_squared_derivative")(example("ellipse")))) < 200
    assert short(BSpline.bezier([0, 1])) == repr(BSpline.bezier([0, 1]))
    assert "ruled surface" in short(formula_of("tangent_developable")(example("rational_space_cubic")))
    assert "control points" in html(value)


def test_tables_hold_what_was_computed():
    curve = example("ellipse")
    table = degree_table(curve)
    evolutes = [row for row in table.rows if row[0] == "evolute"]
    for row, form in zip(evolutes, construction("evolute").unlifted, strict=False):
        assert row[table.columns.index("control points")] == str(
            control_point_count(construction("evolute").on(curve, form))
        )
    assert measured(curve, "f2")["degree here"] == [str(formula_of("f2")(curve).degree)]
    assert len(measured(curve)) == len(measured(curve)["formula"]) > 20
    assert all(parse_degree(cell).names == {"d"} for cell in symbolic_table()["minimal"])
    assert "w" in reduction_table("g0")["cancelled"][0]
    assert "degree" in repr(table)


def test_the_numbers_of_the_paper_are_all_there_and_as_recorded():
    numbers = [claim for claim in claims() if claim.kind in ("degree", "count") and claim.status != "ours"]
    table = printed_numbers()
    assert table.as_recorded
    assert table["statement"] == [claim.statement for claim in numbers]
    for claim, printed, computed, verdict in zip(
        numbers, table["printed"], table["computed"], table["verdict"], strict=True
    ):
        assert claim.claimed in printed
        if verdict == Verdict.REFUTED:
            assert claim.claimed != computed


def test_verdicts_for_all_curves_and_on_one():
    assert verdicts("C4.1").as_recorded
    assert "on" not in verdicts("C4.1").columns
    one = verdicts("C4.1", curves=[example("circle")])
    assert set(one["on"]) == {"circle"}
    assert {c.kind for c in claims("C4.2")} - {"degree", "count"} == {
        r.claim.kind for r in verdicts("C4.2", without=["degree", "count"]).rows_of_ledger
    }


def test_showing_loads_what_it_needs_only_when_asked():
    code = (
        "import sys; from exactspline import BSpline; f = BSpline.bezier([0, 1]); assert 'exactspline.display' "
        "not in sys.modules;"
        "assert f._repr_html_() and f._repr_latex_(); assert 'exactspline.display' in sys.modules; assert "
        "'matplotlib' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
