"""Surfaces are drawn by depth: what is nearer hides what is behind it, pixel by pixel, as no order of faces does."""

import pytest
from gmpy2 import mpq

pytest.importorskip("matplotlib")
pytest.importorskip("pyvista")

from exactspline.display.plot.canvas import new_figure, save
from exactspline.extras.pictures3d import depth
from exactspline.extras.pictures3d.meshes import SurfaceMesh
from exactspline.extras.pictures3d.surfaces import plot_mesh

RED, BLUE = "#ff0000", "#0000ff"

pytestmark = pytest.mark.skipif(not depth.knows_depth(), reason="VTK has nothing to draw with here")


def sheet(*corners):
    """Two triangles' worth of a plane: corners row by row."""
    return SurfaceMesh([[[tuple(map(mpq, p)) for p in row] for row in corners]], [], 0, 0)


def crossing():
    """Two single faces that cross along the middle: seen from above each is nearer on one side."""
    up = sheet([(0, 0, 0), (0, 1, 0)], [(1, 0, 1), (1, 1, 1)])
    down = sheet([(0, 0, 1), (0, 1, 1)], [(1, 0, 0), (1, 1, 0)])
    figure = new_figure(4, 4)
    ax = figure.add_subplot(projection="3d")
    for mesh, color in ((up, RED), (down, BLUE)):
        plot_mesh(mesh, ax, color=color)
    ax.view_init(90, -90)
    figure.draw_without_rendering()
    return ax, [(up, RED), (down, BLUE)]


def colours(image):
    """In the middle row: whether red or blue prevails, where anything is."""
    row = image[image.shape[0] // 2]
    shown = row[row[:, 3] > 200].astype(int)
    return ["red" if r > b else "blue" for r, _, b, _ in shown]


def test_of_two_faces_that_cross_each_is_seen_where_it_is_nearer():
    ax, surfaces = crossing()
    for order in (surfaces, surfaces[::-1]):
        seen = colours(depth.rendered(ax, order, [], opacity=1))
        half = len(seen) // 2
        assert len(seen) > 100
        assert seen[: half - 10].count("blue") > 0.95 * (half - 10)
        assert seen[half + 10 :].count("red") > 0.95 * (half - 10)


def test_a_line_behind_an_opaque_surface_is_hidden_and_one_before_it_is_not():
    flat = sheet([(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)])
    ax = plot_mesh(flat, color=BLUE)
    for height in (-1, 1):
        ax.plot([0.3, 0.7], [0.5, 0.5], [height, height], color="#00ff00", linewidth=6)
    ax.set_zlim(-1, 1)
    ax.view_init(90, -90)
    ax.figure.draw_without_rendering()
    low, high = ax.lines[-2:]
    for line, is_seen in ((low, False), (high, True)):
        image = depth.rendered(ax, [(flat, BLUE)], [line], opacity=1).astype(int)
        green = (image[..., 1] > 200) & (image[..., 0] < 100) & (image[..., 2] < 100)
        assert green.any() == is_seen


def test_a_picture_is_the_same_twice_and_keeps_its_lines(tmp_path):
    ax, _ = crossing()
    ax.plot([0, 1], [0, 1], [1, 1], color="#000000", label="diagonal")
    files = [tmp_path / name for name in ("a.png", "b.png")]
    for file in files:
        save(ax, file)
    assert files[0].read_bytes() == files[1].read_bytes()
    ax.lines[-1].remove()
    save(ax, files[1])
    assert files[0].read_bytes() != files[1].read_bytes()


def test_a_scene_is_rendered_once_for_all_files_and_again_where_it_changes(tmp_path, monkeypatch):
    made, render = [], depth.rendered
    monkeypatch.setattr(depth, "rendered", lambda *given: made.append(given) or render(*given))
    ax, _ = crossing()
    ax.plot([0, 1], [0, 1], [1, 1], color="#000000")
    for name in ("a.svg", "a.png"):
        save(ax, tmp_path / name)
    assert len(made) == 1
    for change in (lambda: ax.view_init(60, -90), lambda: ax.lines[-1].set_color(RED), ax.lines[-1].remove):
        change()
        before = len(made)
        save(ax, tmp_path / "a.png")
        assert len(made) == before + 1


def test_a_file_shows_every_surface(tmp_path):
    from matplotlib.image import imread

    ax, _ = crossing()
    ax.set_axis_off()
    file = tmp_path / "a.png"
    save(ax, file)
    pixels = imread(file)[..., :3]
    middle = pixels[pixels.shape[0] // 3 : pixels.shape[0] // 2].reshape(-1, 3)
    for channel, other in ((0, 2), (2, 0)):
        assert (middle[:, channel] > middle[:, other] + 0.2).mean() > 0.05
    vector = tmp_path / "a.svg"
    save(ax, vector)
    assert len(vector.read_bytes()) > 20_000
    assert vector.read_text(encoding="utf-8").count("<image ") == 1


def test_without_pyvista_the_faces_are_drawn_and_it_is_said(tmp_path, monkeypatch, capsys):
    from exactspline.cli.common import tell_how_surfaces_are_drawn

    monkeypatch.setattr(depth, "knows_depth", lambda: False)
    monkeypatch.setattr(depth, "rendered", None)
    ax, _ = crossing()
    save(ax, tmp_path / "a.svg")
    tell_how_surfaces_are_drawn()
    assert "pip install pyvista" in capsys.readouterr().err
