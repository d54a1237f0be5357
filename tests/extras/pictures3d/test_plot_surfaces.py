"""Surfaces, roots and approaches in pictures: what is drawn lies on what was computed, and nothing is joined across a
pole.
"""

import pytest
from gmpy2 import mpq

from exactspline import formula_of
from exactspline.extras import pictures3d

pytest.importorskip("matplotlib")

from exactspline import BSpline, TensorSpline, example, zeros
from exactspline.display.plot import PlotError, new_figure, plot_curve, plot_function, plot_quotient, plot_roots
from exactspline.display.plot.canvas import homogeneous, inside, save
from exactspline.errors import FormulaError, ShapeError
from exactspline.extras.pictures3d.html import Scene, scenes_data, turning_page
from exactspline.extras.pictures3d.meshes import ruled_mesh, tensor_mesh
from exactspline.extras.pictures3d.surfaces import plot_mesh
from exactspline.language import Rational, Vector, cross, dot
from exactspline.language.ruled import RuledSurface
from exactspline.papers.chen_riesenfeld_cohen_2007.figures import approaches_table, plot_approaches
from exactspline.tables import surface_pair

SADDLE = Vector(
    *[
        TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], net)
        for net in ([[0, 0], [1, 1]], [[0, 1], [0, 1]], [[0, 0], [0, 1]])
    ]
)


def legend(ax):
    return [text.get_text() for text in ax.get_legend().get_texts()]


@pytest.mark.parametrize(
    "name",
    ["tangent_developable_reduced", "binormal_scroll", "normal_scroll_reduced", "rectifying_developable_reduced"],
)
def test_the_points_of_a_ruled_surface_lie_on_its_rulings(name):
    surface = formula_of(name)(example("rational_space_cubic_spline"))
    mesh = ruled_mesh(surface, ("-1/3", 1), box=((-(10**9),) * 3, (10**9,) * 3))
    assert mesh.faces
    parameters = [mpq(k, 7) for k in range(3)]
    for s in parameters:
        for z in ("-1/3", 1):
            assert surface.at(mpq(z))(s) is not None
    for rows in mesh.patches:
        for row in rows[:: max(1, len(rows) // 5)]:
            a, b = row[0], row[-1]
            direction = [y - x for x, y in zip(a, b, strict=True)]
            for p in row[1:-1]:
                offset = [y - x for x, y in zip(a, p, strict=True)]
                assert all(offset[i] * direction[i - 1] == offset[i - 1] * direction[i] for i in range(3))


def test_the_net_of_a_ruled_surface_is_that_of_its_bounding_curves():
    surface = formula_of("binormal_scroll_reduced")(example("rational_space_cubic"))
    mesh = ruled_mesh(surface, (0, 1), box=((-(10**9),) * 3, (10**9,) * 3))
    drawn = {p for run in mesh.net for p in run}
    for z in (0, 1):
        rows, _, degree = homogeneous(surface.at(mpq(z)))
        assert degree == surface.degree
        assert {tuple(x / w for x in xs) for *xs, w in rows} <= drawn
    assert mesh.points == len(drawn)


def test_no_face_reaches_across_a_pole():
    t, one = BSpline.identity(-1, 1), BSpline.identity(-1, 1) * 0 + 1
    surface = RuledSurface(Rational(Vector(one, t, t * 0), t), Vector(t * 0, t * 0, one))
    mesh = ruled_mesh(surface, (0, 1))
    assert all(len({p[0] > 0 for p in face}) == 1 for face in mesh.faces)
    assert {face[0][0] > 0 for face in mesh.faces} == {True, False}
    saddle = Rational(SADDLE, SADDLE[0] - SADDLE[1] * 2 + mpq(1, 3))
    poles = tensor_mesh(saddle)
    assert poles.faces
    assert all(len({(p[0] - 2 * p[1]) < 1 for p in face}) == 1 for face in poles.faces)


def test_a_surface_reaches_the_border_of_what_is_shown():
    """Before: only whole cells of the grid were drawn, so that a bisector was a bundle of splinters."""
    box = ((mpq(0),) * 3, (mpq(1, 3), mpq(2, 7), mpq(1)))
    mesh = tensor_mesh(SADDLE, box)
    points = [p for face in mesh.faces for p in face]
    assert all(inside(p, box) for p in points)
    assert {p[0] for p in points} >= {mpq(0), mpq(1, 3)}
    assert {p[1] for p in points} >= {mpq(0), mpq(2, 7)}
    # what is drawn is all of the part of the saddle over the rectangle
    assert sum(area(face) for face in mesh.faces) == mpq(1, 3) * mpq(2, 7)


def area(face):
    """Of the projection of a polygon to the first two coordinates."""
    pairs = zip(face, [*face[1:], face[0]], strict=True)
    return abs(sum(p[0] * q[1] - p[1] * q[0] for p, q in pairs)) / 2


def test_a_tensor_surface_is_drawn_through_its_exact_points_with_its_net():
    mesh = tensor_mesh(SADDLE)
    assert all(z == x * y for rows in mesh.patches for row in rows for x, y, z in row)
    assert {p for run in mesh.net for p in run} == {(x, y, mpq(x * y)) for x in (0, 1) for y in (0, 1)}
    ax = pictures3d.plot_surface(SADDLE)
    assert legend(ax)[-1] == "control net (4 points)"
    assert legend(pictures3d.plot_surface(SADDLE, control_net=False)) == ["surface"]


def test_of_surfaces_that_cross_both_are_seen_and_their_faces_are_one_picture_in_a_file(tmp_path):
    from matplotlib.image import imread

    ax = new_figure(4, 4).add_subplot(projection="3d")
    for height, color in ((SADDLE[0], "#ff0000"), (1 - SADDLE[0], "#0000ff")):
        plot_mesh(tensor_mesh(Vector(SADDLE[0], SADDLE[1], height)), ax, color=color, control_net=False)
    ax.set_axis_off()
    pixels, vector = tmp_path / "a.png", tmp_path / "a.svg"
    save(ax, pixels)
    save(ax, vector)
    colours = imread(pixels)[..., :3].reshape(-1, 3)
    red, blue = colours[:, 0], colours[:, 2]
    assert min((red > blue + 0.2).sum(), (blue > red + 0.2).sum()) > 100
    # where one lies behind the other it is seen through it
    assert ((red < 0.9) & (blue < 0.9) & (red > 0.2) & (blue > 0.2)).mean() > 0.03
    written = vector.read_text(encoding="utf-8")
    assert (written.count("<image "), written.count("<path ") < 500) == (1, True)


@pytest.mark.parametrize(
    "variant", ["point_bisector_polynomial", "point_bisector_direct_z", "point_bisector_direct_naive"]
)
def test_bisectors_of_a_point_are_equidistant_where_they_are_drawn(variant):
    curve, q = example("helix_like"), (mpq(1, 3), mpq(1, 4), mpq(1))
    surface = formula_of(variant)(curve.with_point(q))
    mesh = ruled_mesh(surface, (0, 1))
    start, end = mesh.patches[0][0][0], mesh.patches[0][0][-1]
    foot = curve(curve.domain[0])
    for p in (start, end):
        assert sum((a - b) ** 2 for a, b in zip(p, foot, strict=True)) == sum(
            (a - b) ** 2 for a, b in zip(p, q, strict=True)
        )
    ax = pictures3d.plot_bisector(curve, q, formula=variant)
    assert f"bisector: degree {surface.degree}" in legend(ax)


def test_bisectors_of_curves_and_in_the_plane():
    lines = [example("space_line"), example("twisted_cubic")]
    ax = pictures3d.plot_bisector(*lines)
    degree = formula_of("bisector_symmetric")(surface_pair(*lines)).degree
    assert f"bisector: degree {degree.s} × {degree.t}" in legend(ax)
    flat = pictures3d.plot_bisector(example("ellipse"), (0, 0))
    value = formula_of("plane_bisector_polynomial")(example("ellipse").with_point((0, 0)))
    assert flat.name == "rectilinear"
    assert legend(flat)[-1] == f"bisector: degree {value.degree}"


def test_a_derived_curve_has_the_polygon_of_its_representation():
    value = formula_of("evolute")(example("ellipse"))
    ax = plot_quotient(value)
    assert legend(ax)[0] == "control polygon (108 points)"
    drawn = sum(len(line.get_xdata()) for line in ax.lines if line.get_label() == "_control points")
    assert drawn == 108
    parabola = plot_quotient(formula_of("D1")(example("parabola")))
    assert legend(parabola)[0].startswith("control polygon (")


def test_roots_are_inside_their_bars():
    f = BSpline(2, [0, 0, 0, 1, 1, 1, 2, 3, 3, 3, 4, 4, 4], [1, -1, 2, -1, 0, 0, 0, 3, -1, "1/2"])
    found = zeros(f)
    intervals = [(float(r.low), float(r.high)) for r in found]
    ax = plot_roots(found)
    bars = [line for line in ax.lines if line.get_label() in ("isolating interval", "_interval")]
    dots = [line.get_xdata()[0] for line in ax.lines if line.get_label() == "_root"]
    assert [tuple(line.get_xdata()) for line in bars] == intervals
    assert all(low <= x <= high for (low, high), x in zip(intervals, dots, strict=True))
    assert "zero throughout" in legend(ax)


def test_a_stretch_across_the_seam_is_drawn_in_the_domain_in_two_parts():
    f = BSpline(1, [0, 0, 1, 2, 3, 4, 4], [0, 0, 1, 0, 0])
    found = zeros(f, periodic=True)
    for ax in (plot_roots(found), plot_function(f, roots=found)):
        stretches = [line for line in ax.lines if line.get_label() in ("zero throughout", "_zero throughout")]
        assert [tuple(line.get_xdata()) for line in stretches] == [(3, 4), (0, 1)]


def test_approaches_are_compared_by_what_they_cost():
    ax = plot_approaches(example("ellipse"))
    entries = legend(ax)
    assert "squaring: degree 96, 388 control points" in entries
    assert "paper: degree 12, 52 control points" in entries
    graphs = [line for line in ax.lines if not line.get_label().startswith(("_child", "4 roots"))]
    assert all(-1 <= y <= 1 for line in graphs for y in line.get_ydata())
    table = approaches_table(example("ellipse"))
    costs = zip(table["approach"], table["degree"], table["control points"], strict=True)
    assert [f"{name}: degree {degree}, {points} control points" for name, degree, points in costs] == entries[:5]
    assert table["roots"] == ["4"] * 5
    assert legend(plot_approaches(example("cubic_s"), name="zero_curvature", forms=["naive", "paper"]))[:2] == [
        "naive: degree 3, 4 control points",
        "paper: degree 3, 4 control points",
    ]


def test_pages_need_no_network_and_show_scenes_in_one_box():
    mesh = ruled_mesh(formula_of("tangent_developable")(example("twisted_cubic")), (0, 1))
    curve = [[(mpq(0),) * 3, (mpq(9),) * 3]]
    scenes = [Scene("a", mesh, [("</script>", curve)], [("Q", (mpq(0),) * 3)]), Scene("b", mesh)]
    page = turning_page(scenes, "title")
    assert "<script src=" not in page
    assert page.count("</script>") == 1
    assert page == turning_page(scenes, "title")
    first, second = scenes_data(scenes)
    assert first["box"] == second["box"]
    assert first["box"][1][0] > 9
    (shown,) = second["surfaces"]
    assert [[shown["points"][k] for k in face] for face in shown["faces"]] == [
        [[pytest.approx(float(x), rel=1e-4) for x in p] for p in face] for face in mesh.faces
    ]


def test_a_surface_between_two_heights_is_the_same_part_by_either_approach():
    argument = example("helix_like").with_point(("1/3", "1/4", 1))
    for name, rulings in (("point_bisector_polynomial", ("-1/4", "1/4")), ("point_bisector_direct_z", ("-1/2", "5/2"))):
        mesh = ruled_mesh(formula_of(name)(argument), rulings, heights=("-1/2", "5/2"))
        rows = [row for rows in mesh.patches for row in rows]
        assert {(row[0][2], row[-1][2]) for row in rows} == {(mpq(-1, 2), mpq(5, 2))}
        if name == "point_bisector_polynomial":
            before = rows
    assert rows == before


@pytest.mark.parametrize(
    ("formula", "argument", "shown"),
    [
        ("point_bisector_polynomial", "point", {"heights": ("-1/2", "5/2")}),
        ("point_bisector_direct_z", "point", {"heights": ("-1/2", "5/2")}),
        ("tangent_developable", "curve", {"box": ((-1, -1, 0), (2, 2, 2))}),
    ],
)
def test_the_parameters_of_each_point_of_a_ruled_surface_are_those_of_the_point(formula, argument, shown):
    """Hovering over figures 4 to 6 said nothing; a ruling that is cut ends at other parameters than asked for."""
    curve = example("helix_like")
    surface = formula_of(formula)(curve.with_point(("1/3", "1/4", 1)) if argument == "point" else curve)
    mesh = ruled_mesh(surface, (-1, 1), **shown)
    points, _ = mesh.indexed
    assert len(points) == len(mesh.located) > 1000
    for point, (s, zeta) in list(zip(points, mesh.located, strict=True))[::97]:
        assert surface.at(zeta)(s) == point


def test_the_parameters_of_a_surface_of_two_parameters_are_those_of_its_points_but_where_it_is_cut():
    mesh = tensor_mesh(SADDLE, box=((0, 0, 0), (1, 1, mpq(1, 3))))
    points, _ = mesh.indexed
    assert 1000 < len(mesh.located) < len(points)
    assert all(point == (s, t, s * t) for point, (s, t) in zip(points, mesh.located, strict=False))


def test_a_level_ruling_has_no_part_between_two_heights():
    line, level = BSpline(1, [0, 0, 1, 1], [0, 1]), BSpline(1, [0, 0, 1, 1], [1, 1])
    rising = BSpline(1, [0, 0, 1, 1], [0, 1])
    surface = RuledSurface(Vector(line, 0 * line, 0 * line), Vector(0 * line, level, rising))
    rows = ruled_mesh(surface, (0, 1), heights=(1, 2)).patches[0]
    assert rows[0] == [None] * len(rows[0])
    assert all(p is None or 1 <= p[2] <= 2 for row in rows for p in row)


def test_errors_say_what_would_be_right():
    surface = formula_of("tangent_developable")(example("twisted_cubic"))
    with pytest.raises(ShapeError, match="smaller one"):
        ruled_mesh(surface, (1, 0))
    with pytest.raises(ShapeError, match="ruled surface of splines"):
        ruled_mesh(RuledSurface(Vector(1, 2, 3), Vector(0, 0, 1)))
    with pytest.raises(ShapeError, match="two parameters"):
        tensor_mesh(example("twisted_cubic").p)
    with pytest.raises(PlotError, match="fit"):
        pictures3d.plot_ruled_surface(surface, ax=new_figure().add_subplot())
    with pytest.raises(PlotError, match="larger box"):
        plot_mesh(ruled_mesh(surface, box=((5, 5, 5), (6, 6, 6))))
    with pytest.raises(PlotError, match="nothing to draw"):
        plot_quotient(formula_of("focal_curve_reduced")(example("helix_like")))
    with pytest.raises(ShapeError, match="segment"):
        ruled_mesh(formula_of("focal_surface")(example("space_line")))
    with pytest.raises(ShapeError, match="both in the plane"):
        pictures3d.plot_bisector(example("ellipse"), (0, 0, 0))
    with pytest.raises(ShapeError, match="two curves in space"):
        pictures3d.plot_bisector(example("ellipse"), example("circle"))
    with pytest.raises(FormulaError, match="'point'"):
        pictures3d.plot_bisector(example("helix_like"), (0, 0, 0), formula="plane_bisector")


def test_a_surface_goes_with_the_curve_on_one_pair_of_axes():
    curve = example("rational_space_cubic")
    ax = plot_curve(curve, control_polygon=False)
    surface = formula_of("binormal_scroll_reduced")(curve)
    assert pictures3d.plot_ruled_surface(surface, (0, "1/40"), ax) is ax
    assert legend(ax)[0] == "rational space cubic"
    assert dot(cross(formula_of("D1")(curve), formula_of("D2")(curve)), formula_of("D1")(curve)).is_zero
