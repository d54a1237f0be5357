"""What the moving pages read besides the library: curves to start from, the ledger, degrees; all of it computed."""

from __future__ import annotations

import base64
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import exactspline as xs
from docs.play.python import page
from docs.site.pages import figure
from exactspline.display.evidence import worded
from exactspline.display.latex_prose import parts
from exactspline.display.ledger import claimed, statement_data
from exactspline.display.plot.canvas import Run, sampled
from exactspline.extras.pictures3d.html import Scene, inspected_scene, scenes_data
from exactspline.extras.pictures3d.meshes import ruled_mesh, tensor_mesh
from exactspline.papers import papers
from exactspline.verification.claims import claims_in
from exactspline.verification.degree_tables import GenericRow, generic_table
from exactspline.verification.evidence import Evidence, OnExample
from exactspline.verification.statement import statement, true_relation

CURVES = ("six_segment_cubic", "cubic_s", "rational_cubic", "ellipse", "cusp")
DEGREES = range(2, 13)
#: The first formula of the page that reduces.
SAMPLE = """from exactspline.language import det


def numerator(c):
    return det(c.gamma.d(1), c.gamma.d(2))
"""
#: Inspected interactive 3-D surfaces, with their titles.
TITLES = {
    "torus": "Torus: its two parabolic circles",
    "bicubic": "Bicubic patch: parabolic curves and umbilics",
    "ellipsoid": "Ellipsoid: its four umbilics",
}


def write(folder: Path, ledger: list[dict[str, Any]]) -> None:
    """The files of the pages, as JSON."""
    folder.mkdir(parents=True, exist_ok=True)
    shown = surfaces()
    (folder / "surfaces").mkdir(exist_ok=True)
    listed = [{key: one[key] for key in ("name", "title", "caption")} for one in shown]
    told: dict[str, Any] = {
        "curves": curves(),
        "first": first_answers(),
        "pairs": pairs(),
        "degrees": degrees(),
        "claims": ledger,
        "surfaces": listed,
    }
    told |= {f"surfaces/{one['name']}": one["scenes"] for one in shown}
    for name, made in told.items():
        text = json.dumps(made, ensure_ascii=False, separators=(",", ":"))
        (folder / f"{name}.json").write_text(text, encoding="utf-8")


def curves() -> list[dict[str, Any]]:
    """Example curves of the plane, as the pages hold curves, with the answers that are shown until the library runs."""
    made = []
    for curve in map(curve_data, map(xs.example, CURVES)):
        asked = {"curve": curve, "variants": ["squaring", "paper", "minimal"]}
        made.append(curve | {"answers": {"features": page.features(curve), "forms": page.forms(asked)}})
    return made


def first_answers() -> dict[str, Any]:
    """What the pages show of their first curve, or formula, until the library runs."""
    cubic = curve_data(xs.example("cubic_s"))
    at = {"curve": cubic, "share": "20/60"}
    sample = {"text": SAMPLE, "dimension": 2, "polynomial": False}
    return {
        "triangle": page.triangle(at),
        "product": page.product(at | {"factors": ["x", "y"]}),
        "bisector": page.bisector({"curve": cubic, "point": ["7/4", "3/2"]}),
        "reduce": page.reduce(sample),
        "sample": SAMPLE,
    }


def pairs() -> list[dict[str, Any]]:
    """Pairs of curves to start from, the first one with its answer."""

    def bezier(*points: tuple[int, int]) -> xs.Nurbs:
        n = len(points) - 1
        return xs.Nurbs(n, [0] * (n + 1) + [1] * (n + 1), points)

    chosen = {
        "two crossings 0.012 apart": (bezier((2, 8), (2, 3), (3, 0), (2, 5)), bezier((2, 2), (8, 8), (5, 8), (10, 8))),
        "five crossings": (bezier((0, 0), (2, 9), (4, -8), (6, 2)), bezier((0, 1), (9, 3), (-4, -2), (6, 0))),
        "a parabola and its tangent": (bezier((-2, 4), (0, -4), (2, 4)), bezier((-1, -3), (3, 5))),
        "a part of the same curve": (bezier((0, 0), (1, 3), (3, -2), (4, 1)), bezier((0, 0), (1, 3), (3, -2), (4, 1))),
        "an ellipse and a cubic": (xs.example("ellipse"), xs.example("cubic_s")),
    }
    made: list[dict[str, Any]] = [
        {"name": name, "first": curve_data(first), "second": curve_data(second)}
        for name, (first, second) in chosen.items()
    ]
    made[3]["second"] = curve_data(chosen["a part of the same curve"][1].restrict("1/4", "3/4").reverse())
    made[0]["answer"] = page.pair(made[0] | {"bisector": False})
    return made


def curve_data(curve: xs.Nurbs) -> dict[str, Any]:
    """A curve as the pages hold it: every number is text."""
    return {
        "name": curve.name,
        "degree": curve.degree,
        "knots": [str(t) for t in curve.knots],
        "points": [[str(x) for x in point] for point in curve.control_points],
        "weights": [str(w) for w in curve.weights],
    }


def degrees() -> dict[str, list[dict[str, Any]]]:
    """The degrees of the constructions as expressions and at d = 2, 3, …."""

    def both(row: GenericRow, name: str) -> dict[str, Any]:
        values = {d: row.at(d)[name] for d in DEGREES}
        return {"text": vars(row)[name], "values": {d: n for d, n in values.items() if n is not None}}

    made: dict[str, list[dict[str, Any]]] = {}
    for polynomial in (False, True):
        table = [call() for call in generic_table(polynomial=polynomial)]
        made["polynomial" if polynomial else "rational"] = [
            {"object": row.object} | {name: both(row, name) for name in ("naive", "paper", "true")} for row in table
        ]
    return made


def surfaces() -> list[dict[str, Any]]:
    """Surfaces as the pages turn them: a name, a title, a caption, and the scenes that stand side by side."""
    figures = {4: "Point and helix-like curve: two bisectors", 6: "Point and ellipse: bisectors, and that in the plane"}
    made = []
    for number, title in figures.items():
        drawn = figure(number)
        made.append(_turned(f"figure-{number}", title, drawn.caption, drawn.scenes))
    cubic, rational = xs.example("twisted_cubic"), xs.example("rational_space_cubic")
    tangents = ruled_mesh(xs.formula_of("tangent_developable_reduced")(rational), (0, "1/4"))
    binormals = ruled_mesh(xs.formula_of("binormal_scroll_reduced")(rational), ("-1/150", "1/150"))
    scenes = [Scene(title, m, [_runs(rational)]) for title, m in (("tangents", tangents), ("binormals", binormals))]
    caption = "The ruled surfaces of the tangents and of the binormals of a rational cubic, with their control nets."
    made.append(_turned("ruled", "Tangents and binormals of a space curve", caption, scenes))
    focal = ruled_mesh(xs.formula_of("focal_surface_reduced")(cubic), (-1, 1), ((-3, -4, -2), (4, 4, 5)))
    caption = "The focal surface of the twisted cubic: through every centre of curvature a line along the binormal."
    made.append(_turned("focal", "The focal surface of the twisted cubic", caption, [Scene("", focal, [_runs(cubic)])]))
    lines = [
        xs.Nurbs(1, [-2, -2, 2, 2], [(-2, 0, -1), (2, 0, -1)], name="one line"),
        xs.Nurbs(1, [-2, -2, 2, 2], [(0, -2, 1), (0, 2, 1)], name="the other"),
    ]
    saddle = tensor_mesh(xs.formula_of("bisector_symmetric")(xs.tables.surface_pair(*lines)))
    caption = "All points equally far from two lines: a hyperbolic paraboloid."
    made.append(_turned("lines", "The bisector of two lines", caption, [Scene("", saddle, list(map(_runs, lines)))]))
    for name, title in TITLES.items():
        found = xs.analyse(xs.example(name))
        caption = "Regions of positive and of negative Gaussian curvature; lines of curvature; umbilics."
        made.append({"name": name, "title": title, "caption": caption, "scenes": [inspected_scene(found)]})
    return made


def _turned(name: str, title: str, caption: str, scenes: Sequence[Scene]) -> dict[str, Any]:
    return {"name": name, "title": title, "caption": caption, "scenes": scenes_data(scenes)}


def _runs(curve: xs.Nurbs) -> tuple[str, list[Run]]:
    return curve.name, [[p for _, p in part] for part in sampled(curve, curve.breakpoints)]


def claims() -> list[dict[str, Any]]:
    """Every claim spelled out, with the title of its source; a refuted one with the curve on which it fails."""
    titles = {source.name: source.title for source in papers()}
    made = []
    for s in map(statement, claims_in(papers())):
        told = statement_data(s)
        told |= {"paper": s.claim.paper, "title": titles[s.claim.paper], "verdict": str(told["verdict"])}
        told["quoted"] = parts(s.claim.words)
        told["section"] = s.claim.section
        found = worded(true_relation(s.claim, s.finding) or s.finding.computed)
        told["found"] = "" if found == claimed(s.claim) else found or told["witness"]
        told["curve"] = _address(_witness(s.finding.witness))
        made.append(told)
    return made


def _witness(found: Evidence | None) -> xs.Nurbs | None:
    """The plane example curve that a witness names."""
    if not isinstance(found, OnExample) or found.surface or found.name not in xs.examples("curves"):
        return None
    curve = xs.example(found.name)
    return curve if curve.dimension == 2 else None


def _address(curve: xs.Nurbs | None) -> str:
    """The fragment of an address that restores a curve."""
    if curve is None:
        return ""
    data = {key: value for key, value in curve_data(curve).items() if key != "name"}
    return base64.urlsafe_b64encode(json.dumps(data).encode()).decode().rstrip("=")
