"""What the moving pages read besides the library: curves to start from, the ledger, degrees; all of it computed."""

from __future__ import annotations

import base64
import json
from pathlib import Path
from typing import Any

import exactspline as xs
from exactspline.papers import papers
from exactspline.readings.degree import parse
from exactspline.verification.claims import claims_in
from exactspline.verification.degree_tables import generic_table
from exactspline.verification.statement import statement

CURVES = ("six_segment_cubic", "cubic_s", "rational_cubic", "ellipse", "cusp")
DEGREES = range(2, 13)


def write(folder: Path) -> None:
    """The files of the pages, as JSON."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, made in (("curves", curves()), ("degrees", degrees()), ("claims", claims())):
        (folder / f"{name}.json").write_text(json.dumps(made, ensure_ascii=False), encoding="utf-8")


def curves() -> list[dict[str, Any]]:
    """Example curves of the plane, as the pages hold curves."""
    return [curve_data(xs.example(name)) for name in CURVES]


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

    def both(text: str) -> dict[str, Any]:
        if not text.strip("–"):
            return {"text": "–", "values": {}}
        degree = parse(text)
        return {"text": text, "values": {d: int(degree.at({"d": d})) for d in DEGREES}}

    made: dict[str, list[dict[str, Any]]] = {}
    for polynomial in (False, True):
        table = [call() for call in generic_table(polynomial=polynomial)]
        made["polynomial" if polynomial else "rational"] = [
            {"object": r.object, "naive": both(r.naive), "paper": both(r.paper), "lowest": both(r.true)} for r in table
        ]
    return made


def claims() -> list[dict[str, Any]]:
    """Every claim spelled out, with the title of its source; a refuted one with the curve on which it fails."""
    titles = {source.name: source.title for source in papers()}
    made = []
    for s in map(statement, claims_in(papers())):
        told = s.data()
        told |= {"paper": s.claim.paper, "title": titles[s.claim.paper], "verdict": str(told["verdict"])}
        told["curve"] = _address(_witness(str(told["witness"])))
        made.append(told)
    return made


def _witness(text: str) -> xs.Nurbs | None:
    """The plane example curve that a witness names."""
    named = [name for name in xs.example_names() if f"example curve {name}:" in text]
    curve = xs.example(named[0]) if named else None
    return curve if curve is not None and curve.dimension == 2 else None


def _address(curve: xs.Nurbs | None) -> str:
    """The fragment of an address that restores a curve."""
    if curve is None:
        return ""
    data = {key: value for key, value in curve_data(curve).items() if key != "name"}
    return base64.urlsafe_b64encode(json.dumps(data).encode()).decode().rstrip("=")
