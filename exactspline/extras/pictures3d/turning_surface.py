"""An inspected surface for interactive 3-D pages: coloured by the sign of its curvature, with parabolic curves, lines
of curvature and umbilics.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from exactspline.bivariate.signs import Point
from exactspline.display.plot.canvas import BLACK, GREEN, VERMILLION, box_around, grown, three_ticks
from exactspline.extras.pictures3d.curvature_lines import FAMILIES, Samples, lines_of_curvature
from exactspline.extras.pictures3d.html import (
    ROOM,
    DotData,
    LineData,
    SceneData,
    SurfaceData,
    dots_of,
    line_of,
    page_of,
    places_of,
)
from exactspline.extras.pictures3d.patches import (
    ELLIPTIC,
    FLAT,
    GRID,
    HYPERBOLIC,
    LEAST,
    colour_of,
    has_lines,
    parabolic_runs,
    singular_spots,
    umbilic_spots,
)
from exactspline.geometry.analysis.surfaces import PatchInspection, SurfaceInspection
from exactspline.numbers.exact import from_float

#: The meanings of the colours of faces.
LABELS = {ELLIPTIC: "K > 0", HYPERBOLIC: "K < 0", FLAT: "K = 0"}


def inspected_scene(inspection: SurfaceInspection) -> SceneData:
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
        "box": places_of(box),
        "ticks": places_of(three_ticks(*ends) for ends in zip(*box, strict=True)),
        "surfaces": surfaces,
        "lines": list(_lines(inspection, samples)),
        "dots": list(_dots(inspection)),
    }


def _surfaces(inspection: SurfaceInspection, samples: Samples) -> Iterator[SurfaceData]:
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
                        points += places_of([own[k, h]])
                        parameters += places_of([(us[k], vs[h])])
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


def _lines(inspection: SurfaceInspection, samples: Samples) -> Iterator[LineData]:
    families = lines_of_curvature(samples) if has_lines(inspection) else ([], [])
    for family, (label, colour) in zip(families, FAMILIES.items(), strict=True):
        if family:
            yield line_of(label, colour, 1, [samples.lifted(line) for line in family])
    if runs := list(parabolic_runs(inspection)):
        yield line_of("parabolic curve", BLACK, 3, [_on(inspection, run) for run in runs])


def _dots(inspection: SurfaceInspection) -> Iterator[DotData]:
    kinds = [f"umbilic, {umbilic.kind.value}" for umbilic in inspection.umbilics]
    singular = ["singular point"] * len(inspection.singular_points.points)
    marked = (("umbilics", VERMILLION, umbilic_spots, kinds), ("singular points", GREEN, singular_spots, singular))
    for label, colour, spots, names in marked:
        if places := list(spots(inspection)):
            named = [
                f"{name}: u ≈ {float(u):.5g}, v ≈ {float(v):.5g}" for name, (u, v) in zip(names, places, strict=True)
            ]
            yield dots_of(label, colour, 12, _on(inspection, places)) | {"names": named}


def _on(inspection: SurfaceInspection, parameters: Iterable[Point]) -> Sequence[Sequence[float]]:
    return [[float(x) for x in inspection.surface(u, v)] for u, v in parameters]


def inspected_page(found: SurfaceInspection) -> str:
    """The page of an inspected surface."""
    scene = inspected_scene(found)
    return page_of([scene], scene["title"])
