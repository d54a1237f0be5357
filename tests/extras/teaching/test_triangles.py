"""The algorithms step by step against the operations of splines, which know nothing of them."""

import re
import subprocess
import sys
from xml.etree import ElementTree

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from exactspline import BSpline, Direction, ExactSplineError, Nurbs, example, examples
from exactspline.errors import DomainError, KnotError, ShapeError
from exactspline.extras.teaching import de_boor_triangle, elevation_triangles, insertion_triangle, product_tables
from exactspline.extras.teaching.display.exercises import schemes_page, sheets
from exactspline.numbers.exact import text
from exactspline.tables import mathematics
from tests.support.command import invoke

SMALL = st.integers(-9, 9)
CURVES = [example(name) for name in examples("curves")]


@st.composite
def functions(draw):
    """Splines over knots of every multiplicity up to degree + 1, clamped or not."""
    degree = draw(st.integers(0, 4))
    inner = draw(
        st.lists(st.tuples(st.integers(1, 3), st.integers(1, degree + 1)), max_size=3, unique_by=lambda k: k[0])
    )
    ends = [0] * (degree + 1), [4] * (degree + 1)
    if draw(st.booleans()):
        ends = list(range(-degree, 1)), list(range(4, 5 + degree))
    knots = [*ends[0], *sorted(t for t, times in inner for _ in range(times)), *ends[1]]
    count = len(knots) - degree - 1
    return BSpline(degree, knots, draw(st.lists(SMALL, min_size=count, max_size=count)))


def parameters(low=0, high=4):
    return st.fractions(low, high, max_denominator=6).map(lambda x: mpq(x.numerator, x.denominator))


@given(functions(), parameters())
def test_the_tip_is_the_value(f, t):
    triangle = de_boor_triangle(f, t)
    assert triangle.tip == (f(t),)
    assert [len(column) for column in triangle.columns] == list(range(f.degree + 1, 0, -1))
    # inside its span every point lies between those it is made of
    assert all(0 <= s <= 1 for shares in triangle.ratios for s in shares)


@pytest.mark.parametrize("curve", CURVES, ids=lambda c: c.name)
def test_the_tip_is_the_point_of_a_curve(curve):
    a, b = curve.domain
    for t in (a, *curve.breakpoints, (3 * a + 4 * b) / 7, b):
        assert de_boor_triangle(curve, t).tip == curve(t)


@given(functions(), st.data())
def test_the_edges_of_insertion_are_the_control_points_over_the_finer_knots(f, data):
    t = data.draw(parameters(mpq(1, 6), mpq(23, 6)))
    room = f.degree - f.knots.multiplicity(t)
    if room < 1:
        with pytest.raises(KnotError):
            insertion_triangle(f, t)
        return
    times = data.draw(st.integers(1, room))
    triangle = insertion_triangle(f, t, times)
    finer = BSpline(f.degree, triangle.knots, [row[0] for row in triangle.made])
    assert finer == f
    assert triangle.knots.multiplicity(t) == f.knots.multiplicity(t) + times
    assert len(triangle.made) == len(f.control_points) + times


def test_a_rational_curve_is_combined_with_its_weights():
    half = Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), Direction(0, 1), (-1, 0)])
    triangle = insertion_triangle(half, "1/2")
    finer = Nurbs.from_homogeneous(2, triangle.knots, triangle.made)
    assert finer == half
    assert triangle.cartesian(triangle.columns[0][1]) == Direction(0, 1)
    # the points of the triangle between two weights are not their Cartesian means
    arc = example("circle")
    first = de_boor_triangle(arc, mpq(1, 3))
    (_, p, q), share = [first.cartesian(row) for row in first.columns[0]], first.ratios[0][1]
    assert first.cartesian(first.columns[1][1]) != tuple((1 - share) * x + share * y for x, y in zip(p, q, strict=True))


@given(functions(), st.integers(1, 3))
def test_elevation_gives_the_bezier_points_of_a_higher_degree(f, by):
    triangles = elevation_triangles(f, by)
    higher = f.elevate_degree(by)
    assert tuple(tuple(row[0] for row in each.columns[-1]) for each in triangles) == higher.bezier_points


@given(functions(), functions())
def test_the_diagonals_sum_to_the_product(f, g):
    tables = product_tables(f, g)
    assert tuple(table.points for table in tables) == (f * g).bezier_points


def test_what_no_triangle_exists_of_is_refused():
    f = BSpline(2, [0, 0, 0, 1, 2, 2, 2], [0, 1, 2, 3])
    for t in (-1, 3, "201/100"):
        with pytest.raises(DomainError):
            de_boor_triangle(f, t)
    for t in (0, 2, 5):
        with pytest.raises(DomainError):
            insertion_triangle(f, t)
    for times in (0, 2, True):
        with pytest.raises(KnotError):
            insertion_triangle(f, 1, times)
    with pytest.raises(ShapeError):
        elevation_triangles(f, 0)
    with pytest.raises(ShapeError):
        _ = insertion_triangle(f, "1/2").tip


def fractions_in(latex):
    """The numbers of a formula in LaTeX, in order, indices left out."""
    bare = re.sub(r"[db]_\{\d+\}|\\\\\[4pt\]|\\begin.*", "", latex)
    pattern = r"(-?)(?:\\tfrac\{(\d+)\}\{(\d+)\}|(\d+))"
    return [mpq(int(f"{sign}{top or whole}"), int(below or 1)) for sign, top, below, whole in re.findall(pattern, bare)]


@pytest.mark.parametrize(
    "curve", [example(name) for name in ("cubic_s", "rational_cubic", "twisted_cubic", "unclamped")]
)
def test_every_printing_has_the_same_numbers(curve):
    a, b = curve.domain
    for scheme in (de_boor_triangle(curve, (2 * a + b) / 3), *elevation_triangles(curve, 2)):
        numbers = [x for column in scheme.columns for row in column for x in row]
        assert sorted(fractions_in(mathematics(scheme))) == sorted(numbers)
        table = sheets(scheme)[0].text(80)
        page = schemes_page([scheme], "page")
        assert ("Weights s:" in page) == bool(getattr(scheme, "ratios", ()))
        for x in numbers:
            assert text(x) in table
            top, slash, below = text(abs(x)).partition("/")
            assert f"<mn>{top}</mn><mn>{below}</mn>" in page if slash else f"<mn>{top}</mn>" in page
        ElementTree.fromstring(page[page.index("<math") : page.index("</math>") + 7])
        assert "http" not in page


def test_the_command_wants_something_to_do():
    for arguments in (
        ["teach", "triangle", "cubic_s"],
        ["teach", "triangle", "cubic_s", "--at", "2"],
        ["teach", "triangle", "cubic_s", "--at", "half"],
        ["teach", "triangle", "cubic_s", "--product", "x,z"],
        ["teach", "triangle", "cubic_s", "--at", "0", "--html", "--json"],
        ["teach", "triangle", "cubic_s", "--insert", "1/2", "--times", "4"],
    ):
        result = invoke(*arguments)
        assert isinstance(result.exception, ExactSplineError), arguments
    done = invoke("teach", "triangle", "cubic_s", "--at", "1/3", "--latex")
    assert done.exit_code == 0
    assert r"\begin{array}" in done.output


def test_a_notebook_shows_schemes_before_anything_else_has_been_shown():
    """Passed before: the representation of a table of products, since what writes it was not loaded."""
    code = """
from IPython.core.interactiveshell import InteractiveShell
import exactspline as xs
shell = InteractiveShell.instance()
xs.display.load_ipython_extension(shell)
latex = shell.display_formatter.formatters["text/latex"]
f = xs.BSpline.bezier([0, 1])
print(*["begin{array}" in latex(x) for x in (*xs.teaching.product_tables(f, f), xs.teaching.de_boor_triangle(f, 0))])
"""
    pytest.importorskip("IPython")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.stdout.split() == ["True", "True"], done.stderr
