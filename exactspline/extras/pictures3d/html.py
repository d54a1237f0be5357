"""Interactive 3-D surfaces: a self-contained HTML page for any browser, without a network. An inspected surface is
coloured by the sign of its curvature, with parabolic curves, lines of curvature and umbilics.

The page consists of data and of ``turning.js``, which draws the data by WebGL; the pages of the site use the same data
and script.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Sequence
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
from exactspline.extras.pictures3d.patches import (
    ELLIPTIC,
    FAMILIES,
    FLAT,
    GRID,
    HYPERBOLIC,
    LEAST,
    Samples,
    colour_of,
    has_lines,
    lines_of_curvature,
    parabolic_runs,
    singular_spots,
    umbilic_spots,
)
from exactspline.geometry.analysis.surfaces import PatchInspection, SurfaceInspection
from exactspline.numbers.exact import from_float, mpq

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


class _SurfaceData(TypedDict):
    """A surface on a page: points, and faces as indices of them."""

    label: str
    color: str
    points: list[list[float]]
    faces: list[list[int]]
    #: The two parameters of the first points (of all but those at which a face is cut), shown under the pointer.
    parameters: list[list[float]]
    #: The names of the two parameters.
    letters: list[str]


class _LineData(TypedDict):
    """Lines of one kind on a page."""

    label: str
    color: str
    width: float
    runs: list[list[list[float]]]


class _DotData(TypedDict):
    """Dots of one kind on a page."""

    label: str
    color: str
    size: float
    places: list[list[float]]
    #: The text that is shown under the pointer for each dot.
    names: NotRequired[list[str]]


class _SceneData(TypedDict):
    """The data for ``turning.js``: meshes, lines and dots in doubles, their box, and a few ticks on its edges."""

    title: str
    box: list[list[float]]
    ticks: list[list[float]]
    surfaces: list[_SurfaceData]
    lines: list[_LineData]
    dots: list[_DotData]


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

    def data(self, box: Box | None = None) -> _SceneData:
        """The scene as plain data, in a box (None: the scene's box).

        >>> rows = [[(mpq(i), mpq(j), mpq(i * j)) for j in range(2)] for i in range(2)]
        >>> data = Scene("a saddle", SurfaceMesh([rows], [], 0, 0)).data()
        >>> data["surfaces"][0]["faces"], data["box"], data["ticks"][0]
        ([[0, 1, 3, 2]], [[-0.05, -0.05, -0.05], [1.05, 1.05, 1.05]], [0, 0.5, 1])
        """
        points, faces = self.mesh.indexed
        net = self.mesh.net
        lines = [_line_of("isolines", DARK, 0.7, self.mesh.isolines())]
        lines += [_line_of("control net", GREEN, 1, net)] if net else []
        lines += [
            _line_of(name.replace("_", " "), color, 3, runs)
            for (name, runs), color in zip(self.curves, cycle((BLACK, VERMILLION)), strict=False)
        ]
        dots = [_dots_of("control points", BLUE, 5, dict.fromkeys(p for run in net for p in run))] if net else []
        dots += [_dots_of(name, GREY, 13, [p]) for name, p in self.points]
        box = box or self.box
        surface: _SurfaceData = {
            "label": "surface",
            "color": SKY,
            "points": _places_of(points),
            "faces": [list(face) for face in faces],
            "parameters": _places_of(self.mesh.located),
            "letters": [*self.mesh.letters],
        }
        return {
            "title": self.title,
            "box": _places_of(box),
            "ticks": [[_rounded(x) for x in three_ticks(*ends)] for ends in zip(*box, strict=True)],
            "surfaces": [surface],
            "lines": lines,
            "dots": dots,
        }


def scenes_data(scenes: Sequence[Scene]) -> list[_SceneData]:
    """Scenes shown side by side, in one box, so that they have the same scale."""
    box = box_around([corner for scene in scenes for corner in scene.box])
    return [scene.data(box) for scene in scenes]


def _dots_of(label: str, color: str, size: float, places: Iterable[Place]) -> _DotData:
    """Dots of one kind, as data."""
    return {"label": label, "color": color, "size": size, "places": _places_of(places)}


def _line_of(label: str, color: str, width: float, runs: Iterable[Iterable[Place]]) -> _LineData:
    """Lines of one kind, as data."""
    return {"label": label, "color": color, "width": width, "runs": [_places_of(run) for run in runs]}


def _places_of(points: Iterable[Place]) -> list[list[float]]:
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
    return _page_of(scenes_data(scenes), title)


def _page_of(scenes: Sequence[_SceneData], title: str) -> str:
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


#: The meanings of the colours of faces.
LABELS = {ELLIPTIC: "K > 0", HYPERBOLIC: "K < 0", FLAT: "K = 0"}


def inspected_scene(inspection: SurfaceInspection) -> _SceneData:
    """An inspected surface as the data of an interactive scene.

    >>> from exactspline import analyse, example
    >>> scene = inspected_scene(analyse(example("torus")))
    >>> [one["label"] for one in scene["surfaces"]], [one["label"] for one in scene["lines"]]
    (['K > 0', 'K < 0'], ['lines of the larger curvature', 'lines of the smaller curvature', 'parabolic curve'])

    Raises `PlotError` without matplotlib, which brings the arrays used for sampling.
    """
    samples = Samples.of(inspection.surface, GRID, LEAST)
    surfaces = list(_surfaces(inspection, samples))
    box = grown(box_around([tuple(from_float(float(x)) for x in p) for one in surfaces for p in one["points"]]), ROOM)
    return {
        "title": inspection.surface.name.replace("_", " ") or "surface",
        "box": _places_of(box),
        "ticks": _places_of(three_ticks(*ends) for ends in zip(*box, strict=True)),
        "surfaces": surfaces,
        "lines": list(_lines(inspection, samples)),
        "dots": list(_dots(inspection)),
    }


def _surfaces(inspection: SurfaceInspection, samples: Samples) -> Iterator[_SurfaceData]:
    """The faces of each colour, with the points that they need."""
    for colour, label in LABELS.items():
        points: list[list[float]] = []
        parameters: list[list[float]] = []
        known: dict[tuple[int, int, int], int] = {}
        faces = []
        for which, one in enumerate(inspection.patches):
            own, us, vs = samples.points[one.patch], samples.us[one.patch[0]], samples.vs[one.patch[1]]
            for i, j in _faces(one, samples, colour):
                face = []
                for k, h in ((i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)):
                    if (which, k, h) not in known:
                        known[which, k, h] = len(points)
                        points += _places_of([own[k, h]])
                        parameters += _places_of([(us[k], vs[h])])
                    face.append(known[which, k, h])
                faces.append(face)
        if faces:
            yield {
                "label": label,
                "color": colour,
                "points": points,
                "faces": faces,
                "parameters": parameters,
                "letters": ["u", "v"],
            }


def _faces(one: PatchInspection, samples: Samples, colour: str) -> Iterator[tuple[int, int]]:
    """The faces of a patch that have a colour."""
    signs = samples.signs[one.patch]
    for i in range(signs.shape[0] - 1):
        for j in range(signs.shape[1] - 1):
            if colour_of(one, float(signs[i : i + 2, j : j + 2].mean())) == colour:
                yield i, j


def _lines(inspection: SurfaceInspection, samples: Samples) -> Iterator[_LineData]:
    families = lines_of_curvature(samples) if has_lines(inspection) else ([], [])
    for family, (label, colour) in zip(families, FAMILIES.items(), strict=True):
        if family:
            yield _line_of(label, colour, 1, [samples.lifted(line) for line in family])
    if runs := list(parabolic_runs(inspection)):
        yield _line_of("parabolic curve", BLACK, 3, [_on(inspection, run) for run in runs])


def _dots(inspection: SurfaceInspection) -> Iterator[_DotData]:
    kinds = [f"umbilic, {umbilic.kind.value}" for umbilic in inspection.umbilics]
    singular = ["singular point"] * len(inspection.singular_points.points)
    marked = (("umbilics", VERMILLION, umbilic_spots, kinds), ("singular points", GREEN, singular_spots, singular))
    for label, colour, spots, names in marked:
        if places := list(spots(inspection)):
            named = [
                f"{name}: u ≈ {float(u):.5g}, v ≈ {float(v):.5g}" for name, (u, v) in zip(names, places, strict=True)
            ]
            yield _dots_of(label, colour, 12, _on(inspection, places)) | {"names": named}


def _on(inspection: SurfaceInspection, parameters: Iterable[tuple[mpq, mpq]]) -> Sequence[Sequence[float]]:
    return [[float(x) for x in inspection.surface(u, v)] for u, v in parameters]


def inspected_page(found: SurfaceInspection) -> str:
    """The page of an inspected surface."""
    scene = inspected_scene(found)
    return _page_of([scene], scene["title"])
