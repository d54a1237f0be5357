"""Interactive 3-D surfaces: a self-contained HTML page for any browser, without a network.

The page consists of data and of ``turning.js``, which draws the data by WebGL; the pages of the site use the same data
and script.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from html import escape
from importlib.resources import files
from itertools import cycle
from typing import NotRequired, TypedDict

from exactspline.display.page import page
from exactspline.display.plot.canvas import (
    BLACK,
    BLUE,
    GREEN,
    GREY,
    SKY,
    VERMILLION,
    Box,
    Point,
    Run,
    box_around,
    grown,
    three_ticks,
)
from exactspline.extras.pictures3d.meshes import SurfaceMesh
from exactspline.numbers.exact import mpq

#: The colour of isolines.
DARK = "#24556F"
#: The margin around a scene, as a fraction of its longest side.
ROOM = mpq(1, 20)
#: The text of a page around its scenes.
STYLE = "body{max-width:80rem}"
#: Significant digits of the coordinates on a page.
DIGITS = 5
#: A point: exact, or from a grid of doubles.
Place = Iterable[mpq | float]


class SurfaceData(TypedDict):
    """A surface on a page: points, and faces as indices of them."""

    label: str
    color: str
    points: list[list[float]]
    faces: list[list[int]]
    #: The two parameters of the first points (of all but those at which a face is cut), shown under the pointer.
    parameters: list[list[float]]
    #: The names of the two parameters.
    letters: list[str]


class LineData(TypedDict):
    """Lines of one kind on a page."""

    label: str
    color: str
    width: float
    runs: list[list[list[float]]]


class DotData(TypedDict):
    """Dots of one kind on a page."""

    label: str
    color: str
    size: float
    places: list[list[float]]
    #: The text that is shown under the pointer for each dot.
    names: NotRequired[list[str]]


class SceneData(TypedDict):
    """The data for ``turning.js``: meshes, lines and dots in doubles, their box, and a few ticks on its edges."""

    title: str
    box: list[list[float]]
    ticks: list[list[float]]
    surfaces: list[SurfaceData]
    lines: list[LineData]
    dots: list[DotData]


@dataclass
class Scene:
    """The contents of one frame: a surface with its control net, curves in runs, single points, each with a label."""

    title: str
    mesh: SurfaceMesh
    curves: list[tuple[str, list[Run]]] = field(default_factory=list)
    points: list[tuple[str, Point]] = field(default_factory=list)

    @property
    def box(self) -> Box:
        """The bounding box with a margin."""
        runs = [*self.mesh.net, *[run for _, runs in self.curves for run in runs]]
        return grown(box_around([*self.mesh.indexed[0], *[p for run in runs for p in run]]), ROOM)

    def data(self, box: Box | None = None) -> SceneData:
        """The scene as plain data, in a box (None: the scene's box).

        >>> rows = [[(mpq(i), mpq(j), mpq(i * j)) for j in range(2)] for i in range(2)]
        >>> data = Scene("a saddle", SurfaceMesh([rows], [], 0, 0)).data()
        >>> data["surfaces"][0]["faces"], data["box"], data["ticks"][0]
        ([[0, 1, 3, 2]], [[-0.05, -0.05, -0.05], [1.05, 1.05, 1.05]], [0, 0.5, 1])
        """
        points, faces = self.mesh.indexed
        net = self.mesh.net
        lines = [line_of("isolines", DARK, 0.7, self.mesh.isolines())]
        lines += [line_of("control net", GREEN, 1, net)] if net else []
        lines += [
            line_of(name.replace("_", " "), color, 3, runs)
            for (name, runs), color in zip(self.curves, cycle((BLACK, VERMILLION)), strict=False)
        ]
        dots = [dots_of("control points", BLUE, 5, dict.fromkeys(p for run in net for p in run))] if net else []
        dots += [dots_of(name, GREY, 13, [p]) for name, p in self.points]
        box = box or self.box
        surface: SurfaceData = {
            "label": "surface",
            "color": SKY,
            "points": places_of(points),
            "faces": [list(face) for face in faces],
            "parameters": places_of(self.mesh.located),
            "letters": [*self.mesh.letters],
        }
        return {
            "title": self.title,
            "box": places_of(box),
            "ticks": [[_rounded(x) for x in three_ticks(*ends)] for ends in zip(*box, strict=True)],
            "surfaces": [surface],
            "lines": lines,
            "dots": dots,
        }


def scenes_data(scenes: Sequence[Scene]) -> list[SceneData]:
    """Scenes shown side by side, in one box, so that they have the same scale."""
    box = box_around([corner for scene in scenes for corner in scene.box])
    return [scene.data(box) for scene in scenes]


def dots_of(label: str, color: str, size: float, places: Iterable[Place]) -> DotData:
    """Dots of one kind, as data."""
    return {"label": label, "color": color, "size": size, "places": places_of(places)}


def line_of(label: str, color: str, width: float, runs: Iterable[Iterable[Place]]) -> LineData:
    """Lines of one kind, as data."""
    return {"label": label, "color": color, "width": width, "runs": [places_of(run) for run in runs]}


def places_of(points: Iterable[Place]) -> list[list[float]]:
    """Points as doubles with a few digits."""
    return [[_rounded(x) for x in point] for point in points]


def _rounded(x: mpq | float) -> float:
    short = float(f"{float(x):.{DIGITS}g}")
    return int(short) if short == int(short) else short


def turning_page(scenes: Sequence[Scene], title: str) -> str:
    """The page: the scenes side by side, rotated together with the mouse, a finger or the arrow keys.

    >>> from exactspline.interchange.examples import example
    >>> from exactspline.papers import find
    >>> from exactspline.extras.pictures3d.meshes import ruled_mesh
    >>> mesh = ruled_mesh(find("tangent_developable")(example("twisted_cubic")), (0, 1))
    >>> made = turning_page([Scene("tangents", mesh)], "a surface")
    >>> "<script src=" in made, "tangents" in made
    (False, True)
    """
    return page_of(scenes_data(scenes), title)


def page_of(scenes: Sequence[SceneData], title: str) -> str:
    """The page of scenes given as data."""
    here = files("exactspline.extras.pictures3d")
    script, style = (here.joinpath(f"turning.{kind}").read_text(encoding="utf-8") for kind in ("js", "css"))
    data = json.dumps(scenes, ensure_ascii=False, separators=(",", ":")).replace("<", "\\u003c")
    body = f"""<p>{escape(title)}</p>
<div id="scenes"></div>
<script type="module">
{script}
turning(document.getElementById("scenes"), {data});
</script>"""
    return page(title.partition(":")[0], body, STYLE + style)
