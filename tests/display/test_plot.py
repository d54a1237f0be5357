"""Pictures: what is drawn is what was computed, nothing is joined that is apart, and files are there whole or not at
all.
"""

import os
import subprocess
import sys
from itertools import pairwise
from xml.etree import ElementTree

import pytest
from gmpy2 import mpq

from exactspline import examples

pytest.importorskip("matplotlib")

import exactspline as xs
from exactspline import BSpline, ExactSplineError, Nurbs, example, write, zeros
from exactspline.display import plot
from exactspline.display.plot import PlotError, canvas, curves
from exactspline.display.plot.functions import inspect_figure
from exactspline.errors import DomainError, ShapeError
from exactspline.geometry.analysis.inspection import solved
from exactspline.language import Rational, Vector
from exactspline.tables import construction, greville_abscissae
from tests.support import command

ZIGZAG = BSpline(1, [0, 0, 1, 2, 2], [1, -1, 1])
#: Jumps through zero at 1, vanishes on [2, 3], jumps off zero at 3.
JUMPING = BSpline(2, [0, 0, 0, 1, 1, 1, 2, 3, 3, 3, 4, 4, 4], [1, -1, 2, -1, 0, 0, 0, 3, -1, "1/2"])


def lines(ax, label):
    return [line for line in ax.lines if line.get_label() == label]


def data(line):
    columns = line.get_data_3d() if hasattr(line, "get_data_3d") else line.get_data()
    return list(zip(*[map(float, column) for column in columns], strict=True))


def floats(points):
    return [tuple(map(float, point)) for point in points]


def legend(ax):
    return [text.get_text() for text in ax.get_legend().get_texts()]


def critical(curve, form):
    f = construction("critical_curvature").on(curve, form)
    return f, zeros(f)


# ---- curves


@pytest.mark.parametrize("name", ["ellipse", "six_segment_cubic", "jump", "twisted_cubic", "unclamped"])
def test_a_curve_is_drawn_segment_by_segment_through_its_exact_points(name):
    curve = example(name)
    ax = plot.plot_curve(curve)
    drawn = lines(ax, name.replace("_", " ")) + lines(ax, "every second segment") + lines(ax, "_segment")
    assert len(drawn) == curve.segments
    assert len({line.get_color() for line in drawn}) == min(2, curve.segments)
    for line, (a, b) in zip(drawn, pairwise(curve.breakpoints), strict=True):
        points = data(line)
        n = len(points) - 1
        assert points[-1] == floats([curve(b, "left")])[0]
        assert points[: n : n // 4] == floats(curve(a + (b - a) * mpq(k, n)) for k in range(0, n, n // 4))
    assert sum(len(line.get_xdata()) for line in lines(ax, "_control points")) == len(curve.control_points)
    assert set(data(lines(ax, "knots")[0])) == set(
        floats(curve(t, side) for t in curve.breakpoints for side in ("left", "right"))
    )


def test_axes_given_are_drawn_on_and_parts_can_be_left_out():
    ax = plot.new_figure().add_subplot()
    assert plot.plot_curve(example("circle"), ax, control_polygon=False, knots=False, label="round") is ax
    assert legend(ax) == ["round", "every second segment"]
    assert len(ax.lines) == 4
    assert ax.get_aspect() == 1


def test_the_control_polygon_has_no_leg_across_a_jump_or_to_a_direction():
    curve = example("jump")
    assert [data(line) for line in lines(plot.plot_curve(curve), "_legs")] == [
        floats(curve.control_points[:3]),
        floats(curve.control_points[3:]),
    ]
    half_circle = Nurbs.from_homogeneous(2, [0, 0, 0, 1, 1, 1], [(1, 0, 1), (0, 1, 0), (-1, 0, 1)])
    assert [data(line) for line in lines(plot.plot_curve(half_circle), "_legs")] == [[(1, 0)], [(-1, 0)]]


def test_names_are_shown_as_they_stand(tmp_path):
    ax = plot.plot_curve(Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 1)], name="_$x^{$"))
    canvas.save(ax, tmp_path / "odd.svg")
    assert legend(ax)[1] == r"\$x^{\$"


def test_every_example_curve_can_be_drawn():
    for name in examples("curves"):
        assert plot.plot_curve(example(name)).has_data()


def test_features_are_marked_at_exact_parameters_roots_and_whatever_has_a_parameter():
    curve = example("six_segment_cubic")
    _, found = critical(curve, "paper")
    ax = plot.plot_features(curve, [*found, *found.jumps, "1/2"], plot.plot_curve(curve), marker="s", label="critical")
    drawn = data(lines(ax, "critical")[0])
    assert drawn[6:] == floats(curve(t) for t in [3, 4, "1/2"])
    for point, root in zip(drawn, found, strict=False):
        low, high = root.refine(30)
        assert point == pytest.approx(floats([curve((low + high) / 2)])[0], rel=1e-15)
    assert (lines(ax, "critical")[0].get_marker(), len(found), len(found.jumps)) == ("s", 6, 2)
    before = len(ax.lines)
    assert len(plot.plot_features(curve, [], ax).lines) == before


# ---- evolutes


def test_the_evolute_of_an_ellipse_reaches_its_cusps_and_is_shown_whole():
    ax = plot.plot_evolute(example("ellipse"))
    points = {point for line in ax.lines for point in data(line)}
    assert {(1.5, 0), (-1.5, 0), (0, 3), (0, -3)} <= points
    assert max(abs(y) for _, y in points) == 3
    assert all(abs((2 * abs(x)) ** (2 / 3) + abs(y) ** (2 / 3) - 3 ** (2 / 3)) < 1e-9 for x, y in points)
    assert ax.get_ylim()[1] > 3


def test_an_evolute_is_not_joined_across_its_poles_and_stays_near():
    curve = example("cubic_s")
    (pole,) = zeros(construction("zero_curvature").on(curve, "paper"))
    ax = plot.plot_evolute(curve)
    drawn = lines(ax, "evolute") + lines(ax, "_evolute")
    assert len(drawn) == 2
    assert 0 < pole < 1
    # the branches lie on opposite sides of the curve: one below at its upper end, one above at its lower end
    assert (data(drawn[0])[0][1] < 0, data(drawn[1])[-1][1] > 0) == (True, True)
    assert max(abs(x) for line in drawn for point in data(line) for x in point) < 10


@pytest.mark.parametrize("factor", [[-1, "1/2", 2], [-1, -1, 1]])
def test_a_pole_between_two_samples_is_not_jumped_over(factor):
    t, wide = BSpline.identity(0, 1), ((mpq(-(10**9)),) * 2, (mpq(10**9),) * 2)
    runs = curves.runs_between_poles(Rational(Vector(t + 1, t), BSpline.bezier(factor)), wide)
    assert [{x > 0 for x, _ in run} for run in runs] == [{False}, {True}]


def test_evolutes_of_a_circle_and_of_a_curve_with_a_straight_piece():
    circle = plot.plot_evolute(example("circle"))
    assert {point for line in circle.lines for point in data(line)} == {(0, 0)}
    assert {line.get_marker() for line in circle.lines} == {"."}
    assert len(plot.plot_evolute(example("straight_between_arcs")).lines) == 2


# ---- functions


@pytest.mark.parametrize(
    "f",
    [
        ZIGZAG,
        JUMPING,
        BSpline(2, [0, 1, 2, 3, 4, 5], [1, "1/3", 2]),
        BSpline(0, [0, 1, 2], [1, 2]),
        BSpline.bezier([1]).d(),
    ],
)
def test_greville_abscissae_reproduce_the_identity(f):
    abscissae = greville_abscissae(f)
    assert len(abscissae) == len(f.control_points)
    if f.degree > 0:
        a, b = f.domain
        assert BSpline(f.degree, f.knots, abscissae) == BSpline.identity(a, b)


def test_a_function_is_drawn_with_its_control_polygon_zero_line_and_roots():
    ax = plot.plot_function(ZIGZAG, roots=zeros(ZIGZAG))
    assert data(lines(ax, "_control points")[0]) == data(lines(ax, "_legs")[0]) == [(0, 1), (1, -1), (2, 1)]
    graph = data(lines(ax, "graph")[0])
    assert graph[0] == (0, 1)
    assert all(y == float(ZIGZAG(mpq(t))) for t, y in graph)
    assert data(lines(ax, "2 roots")[0]) == [(0.5, 0), (1.5, 0)]
    assert [line.get_ydata() for line in ax.lines if list(line.get_ydata()) == [0, 0] and line.get_label() != "2 roots"]
    assert legend(ax) == ["control polygon (3 points)", "graph", "2 roots"]
    assert ax.get_yscale() == "linear"
    assert "root" not in " ".join(legend(plot.plot_function(ZIGZAG, control_polygon=False)))


def test_jumps_are_gaps_and_stretches_are_thick():
    ax = plot.plot_function(JUMPING, roots=zeros(JUMPING))
    graph = lines(ax, "graph") + lines(ax, "_graph")
    assert [(data(line)[0], data(line)[-1]) for line in graph] == [
        ((0, 1), (1, 2)),
        ((1, -1), (3, 0)),
        ((3, 3), (4, 0.5)),
    ]
    assert [len(line.get_xdata()) for line in lines(ax, "_legs")] == [3, 4, 3]
    assert [data(line)[0] for line in lines(ax, "_limit")] == [(1, 2), (3, 0)]
    assert [data(line)[0] for line in lines(ax, "_value")] == [(1, -1), (3, 3)]
    assert data(lines(ax, "1 jump through zero")[0]) == [(1, 0)]
    assert data(lines(ax, "zero throughout")[0]) == [(2, 0), (3, 0)]


def test_knots_without_a_jump_leave_graph_and_polygon_whole():
    f, found = critical(example("ellipse"), "paper")
    assert set(f.continuity) == {-1}
    ax = plot.plot_function(f, roots=found)
    assert len(lines(ax, "graph")) == len(lines(ax, "_legs")) == 1
    assert not lines(ax, "_graph") + lines(ax, "_limit")
    assert [len(line.get_xdata()) for line in lines(ax, "_control points")] == [52]
    assert "control polygon (52 points)" in legend(ax)


def test_the_scale_follows_the_sizes():
    f, _ = critical(example("ellipse"), "squaring")
    uneven = plot.plot_function(f)
    assert uneven.get_yscale() == "asinh"
    assert sorted(uneven.yaxis.get_majorticklocs()) == sorted(-y for y in uneven.yaxis.get_majorticklocs())
    wild = BSpline.bezier([(-1) ** i * (8 <= i < 16) for i in range(24)])
    assert plot.plot_function(wild).get_yscale() == "symlog"
    assert plot.plot_function(wild, scale="linear").get_yscale() == "linear"
    clipped = plot.plot_function(wild, scale="clip")
    low, high = clipped.get_ylim()
    assert -0.2 < low < min(y for _, y in data(lines(clipped, "graph")[0]))
    assert max(y for _, y in data(lines(clipped, "graph")[0])) < high < 0.2
    assert plot.plot_function(ZIGZAG, scale="symlog").get_yscale() == "symlog"


@pytest.mark.parametrize("power", [400, -400])
def test_numbers_beyond_floats_are_divided_by_a_power_of_ten(power):
    ax = plot.plot_function(ZIGZAG * mpq(10) ** power)
    assert ax.get_ylabel() == f"value / $10^{{{power}}}$"
    assert data(lines(ax, "_control points")[0]) == [(0, 1), (1, -1), (2, 1)]
    with pytest.raises(PlotError, match="beyond 1e100"):
        plot.plot_curve(Nurbs(1, [0, 0, 1, 1], [(0, 0), (10**400, 1)]))


@pytest.mark.parametrize("f", [BSpline.bezier([0, 0]), BSpline.bezier([1]).d(2)])
def test_the_zero_function(f):
    ax = plot.plot_function(f, roots=zeros(f))
    assert "zero throughout" in legend(ax)
    assert plot.plot_function(f, scale="clip").get_ylim()[1] > 0


# ---- whole pictures


def test_one_picture_of_a_curve_and_its_functions(tmp_path):
    curve = example("six_segment_cubic")
    panels = [("squared", *critical(curve, "squaring")), ("direct", *critical(curve, "direct"))]
    figure = inspect_figure(curve, panels, evolute=True)
    left, first, second = figure.axes
    extrema = "maximum of κ, minimum of κ"
    squared, direct = f"squared (10): inflection, {extrema}", f"direct (8): {extrema}"
    assert {"evolute", squared, direct} <= set(legend(left))
    assert [len(data(lines(left, name)[0])) for name in (squared, direct)] == [10, 8]
    assert first.get_title() == "squared: degree 24, 150 points"
    assert {"8 roots", "2 jumps through zero"} <= set(legend(first))
    assert {"6 roots", "2 jumps through zero"} <= set(legend(second))
    assert (
        lines(first, "8 roots")[0].get_color()
        == lines(left, squared)[0].get_color()
        != lines(second, "6 roots")[0].get_color()
    )
    canvas.save(figure, tmp_path / "six.png")
    assert (tmp_path / "six.png").read_bytes().startswith(b"\x89PNG\r\n")


@pytest.mark.parametrize(
    ("points", "expected"),
    [
        ([(0, 0), (1, 2), (2, -2), (3, 0)], ["κ = 0 (1): inflection", "κ′ = 0 (2): minimum of κ, maximum of κ"]),
        ([(-1, -1), (-2, 1), (2, 2), (-1, -1)], ["κ′ = 0 (4): minimum of κ, maximum of κ"]),
    ],
    ids=["behind a zero", "at the parameter 0"],
)
def test_jumps_are_marked_among_the_zeros_and_no_kind_is_left_out(tmp_path, points, expected):
    """`inspect CURVE --plot FILE`, the first command of the README, ended in a TypeError for these two: jumps stood
    behind the zeros in one list. At the seam of a closed curve a jump at 0 was taken for one without a parameter.
    """
    curve = Nurbs(2, [0, 0, 0, 1, 2, 2, 2], points)
    panels = [(title, f, zero_set) for _, title, f, zero_set in solved(curve)]
    labels = legend(inspect_figure(curve, panels).axes[0])
    assert [label for label in labels if "κ" in label] == expected
    write(curve, tmp_path / "curve.json")
    assert command.run("inspect", tmp_path / "curve.json", "--plot", tmp_path / "curve.png").returncode == 0


def test_pictures_without_panels_and_in_space():
    assert len(inspect_figure(example("circle"), []).axes) == 1
    line = BSpline.bezier([1, -1])
    space, function = inspect_figure(example("twisted_cubic"), [("line", line, zeros(line))]).axes
    assert (space.name, function.name) == ("3d", "rectilinear")


def test_files_are_written_atomically_and_repeatably(tmp_path, monkeypatch):
    target = tmp_path / "circle.SVG"
    for _ in range(2):
        canvas.save(plot.plot_curve(example("circle")), target)
        before = target.read_bytes()
        assert ElementTree.fromstring(before).tag.endswith("svg")
    other = tmp_path / "again.svg"
    canvas.save(plot.plot_curve(example("circle")), other)
    assert other.read_bytes() == before
    monkeypatch.setattr(os, "replace", lambda *_: (_ for _ in ()).throw(OSError(28, "No space left on device")))
    with pytest.raises(PlotError, match="No space left"):
        canvas.save(plot.plot_curve(example("ellipse")), target)
    assert target.read_bytes() == before
    assert sorted(entry.name for entry in tmp_path.iterdir()) == ["again.svg", "circle.SVG"]


def test_a_picture_as_pdf(tmp_path):
    """PlotErrors before: neither SVG nor PNG."""
    write(example("cubic_s"), tmp_path / "curve.json")
    for name in ("first.pdf", "second.PDF"):
        assert command.run("inspect", tmp_path / "curve.json", "--plot", tmp_path / name).returncode == 0
    data = (tmp_path / "first.pdf").read_bytes()
    assert data.startswith(b"%PDF-")
    assert b"/Subject" in data
    assert data == (tmp_path / "second.PDF").read_bytes()


def test_errors_say_what_would_be_right(tmp_path, monkeypatch):
    ax = plot.plot_curve(example("circle"))
    for path in ("a.gif", "a", "a.svg.gz"):
        with pytest.raises(PlotError, match=r"\.svg or \.png"):
            canvas.save(ax, tmp_path / path)
    (tmp_path / "file").write_text("")
    for path in ("nowhere/a.svg", "file/a.png"):
        with pytest.raises(PlotError, match="folder that can be written"):
            canvas.save(ax, tmp_path / path)
    with pytest.raises(PlotError, match="scales are linear, symlog, clip"):
        plot.plot_function(ZIGZAG, scale="log")
    with pytest.raises(PlotError, match="3d"):
        plot.plot_curve(example("twisted_cubic"), ax)
    with pytest.raises(PlotError, match="R4"):
        plot.plot_curve(Nurbs(1, [0, 0, 1, 1], [(0, 0, 0, 0), (1, 1, 1, 1)]))
    with pytest.raises(ShapeError, match="Vector"):
        plot.plot_function(example("circle").p)
    with pytest.raises(ShapeError, match="straight"):
        plot.plot_evolute(example("straight_line"))
    with pytest.raises(DomainError):
        plot.plot_features(example("circle"), [5], ax)
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    with pytest.raises(PlotError, match="pip install matplotlib"):
        plot.plot_curve(example("circle"))
    assert issubclass(PlotError, ExactSplineError)


def test_importing_loads_no_matplotlib_and_drawing_no_pyplot():
    code = (
        "import sys; from exactspline.display import plot; from exactspline.interchange.examples import example; "
        "assert 'matplotlib' not in sys.modules;"
        "plot.plot_curve(example('circle')); assert 'matplotlib' in sys.modules; assert 'matplotlib.pyplot' not "
        "in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.mark.parametrize("name", ["twisted_cubic", "torus", "circle"])
def test_the_front_door_draws_in_the_plane_and_in_space(name):
    """Passed before: whatever lies in space was drawn, and then refused, *axes that do not fit R2*."""
    thing = xs.example(name)
    in_space = thing.dimension == 3
    assert (xs.plot(thing).name == "3d") is in_space
    assert (xs.plot([thing, thing]).name == "3d") is in_space
    if name == "twisted_cubic":
        ruled = xs.tables.ruled_surface("tangent_developable", thing)
        assert xs.plot(thing, ruled).name == "3d"
        assert xs.plot(xs.derive("focal_curve", thing)).name == "3d"
        assert xs.plot(xs.bisector(thing, (5, 5, 5))).name == "3d"
