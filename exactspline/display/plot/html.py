"""Surfaces that turn: a page of HTML with everything in it, for any browser, without a network. Needs plotly (the extra
``html``).
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from importlib import import_module
from itertools import cycle
from textwrap import wrap
from typing import Any

from exactspline.atomic_write import write_atomically
from exactspline.display.plot.canvas import BLACK, BLUE, GREEN, GREY, SKY, VERMILLION, PlotError, Point, Run
from exactspline.display.plot.meshes import SurfaceMesh

#: Height of the page's picture in pixels, and characters in a line of its title.
HEIGHT, LINE = 800, 150


@dataclass
class Scene:
    """What is seen in one frame: a surface with its control net, curves in runs, single points, each with a label."""

    title: str
    mesh: SurfaceMesh
    curves: list[tuple[str, list[Run]]] = field(default_factory=list)
    points: list[tuple[str, Point]] = field(default_factory=list)


def turning_page(scenes: Sequence[Scene], title: str) -> str:
    """The page: the scenes side by side, each turned with the mouse.

    >>> from exactspline.splines.examples import example
    >>> from exactspline.papers import find
    >>> from exactspline.display.plot.meshes import ruled_mesh
    >>> mesh = ruled_mesh(find("tangent_developable")(example("twisted_cubic")), (0, 1))
    >>> page = turning_page([Scene("tangents", mesh)], "a surface")
    >>> "<script src=" in page, "tangents" in page
    (False, True)

    Raises `PlotError` without plotly.
    """
    try:
        graphs, subplots = import_module("plotly.graph_objects"), import_module("plotly.subplots")
    except ImportError:
        raise PlotError(
            "pages that turn need plotly, which is not installed", remedy="pip install 'exactspline[html]'"
        ) from None
    figure = subplots.make_subplots(
        1, len(scenes), specs=[[{"type": "scene"}] * len(scenes)], subplot_titles=[s.title for s in scenes]
    )
    for i, scene in enumerate(scenes):
        for trace in _traces(graphs, scene, shown=i == 0):
            figure.add_trace(trace, row=1, col=i + 1)
    figure.update_scenes(aspectmode="data", camera={"eye": {"x": 1.5, "y": -1.5, "z": 0.9}})
    heading = {"text": "<br>".join(wrap(title, LINE)), "font": {"size": 13}}
    figure.update_layout(title=heading, height=HEIGHT, legend={"orientation": "h"}, margin={"l": 0, "r": 0})
    page: str = figure.to_html(include_plotlyjs=True, full_html=True, div_id="figure")
    return page


def save_page(page: str, path: str | os.PathLike[str]) -> None:
    """Write a page; the file is there whole or not at all. Raises `PlotError` where nothing can be written."""
    write_atomically(path, lambda stream: stream.write(page.encode()), PlotError)


def _traces(graphs: Any, scene: Scene, *, shown: bool) -> Iterable[Any]:
    for i, rows in enumerate(scene.mesh.patches):
        x, y, z = ([[None if p is None else float(p[k]) for p in row] for row in rows] for k in range(3))
        one = {"colorscale": [[0, SKY], [1, SKY]], "showscale": False, "hoverinfo": "skip"}
        yield graphs.Surface(x=x, y=y, z=z, name="surface", showlegend=shown and not i, **one)
    yield _lines(graphs, scene.mesh.net, GREEN, f"control net ({scene.mesh.points} points)", shown, width=2)
    corners = list(dict.fromkeys(p for run in scene.mesh.net for p in run))
    yield _dots(graphs, corners, BLUE, "control points", shown, size=3)
    for (label, runs), color in zip(scene.curves, cycle((BLACK, VERMILLION)), strict=False):
        yield _lines(graphs, runs, color, label, shown, width=6)
    for label, point in scene.points:
        yield _dots(graphs, [point], GREY, label, shown, size=7)


def _columns(points: Iterable[Point | None]) -> dict[str, list[float | None]]:
    listed = list(points)
    return {axis: [None if p is None else float(p[k]) for p in listed] for k, axis in enumerate("xyz")}


def _lines(graphs: Any, runs: Iterable[Run], color: str, label: str, shown: bool, width: int) -> Any:
    spread = [p for run in runs for p in (*run, None)]
    return graphs.Scatter3d(
        **_columns(spread),
        mode="lines",
        line={"color": color, "width": width},
        name=label,
        showlegend=shown,
        hoverinfo="skip",
    )


def _dots(graphs: Any, points: Iterable[Point], color: str, label: str, shown: bool, size: int) -> Any:
    return graphs.Scatter3d(
        **_columns(points), mode="markers", marker={"color": color, "size": size}, name=label, showlegend=shown
    )
