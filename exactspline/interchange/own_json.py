"""The JSON of exactspline: one curve as read by `exactspline.interchange.curve_files`, or ``{"curves": […]}``.

The published schema is `exactspline/interchange/curve.schema.json`. Every curve is represented exactly: numbers are
integers, decimals or strings such as "1/3".
"""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from importlib import resources
from pathlib import Path
from typing import Any

from exactspline.errors import CurveFileError
from exactspline.interchange.collector import Collector, whole
from exactspline.interchange.curve_files import (
    SIZED,
    curve_data,
    curve_from_data,
    numbers_of,
    parsed,
    surface_data,
    surface_from_data,
)
from exactspline.interchange.format import Format, Spline
from exactspline.interchange.numbers import NumberText
from exactspline.interchange.records import Limits, Reading, Source
from exactspline.splines.knots import KnotVector
from exactspline.splines.surface import NurbsSurface

#: An object, or a list of them.
_BEGINNING = re.compile(rb"(\xef\xbb\xbf)?\s*(\[\s*)?\{")


def _schema() -> dict[str, object]:
    """The JSON Schema of the format.

    >>> schema()["title"]
    'exactspline curve file'
    """
    text = resources.files("exactspline.interchange").joinpath("curve.schema.json").read_text(encoding="utf-8")
    data: dict[str, Any] = json.loads(text)
    return data


def looks_like(head: bytes) -> bool:
    """Whether a file begins like a curve file."""
    return _BEGINNING.match(head) is not None


def read(source: Source) -> Reading:
    """The curves and surfaces of a file. If there are several, an invalid one is skipped; the error of a single one is
    raised.
    """
    collector = Collector("json", source)
    try:
        data: Any = parsed(source.data.decode("utf-8-sig"))
    except UnicodeDecodeError:
        raise CurveFileError("is not UTF-8 text", remedy="a curve file is JSON") from None
    if isinstance(data, dict) and "curves" not in data:
        _add(collector, data, "curve 1")
        return collector.reading()
    entries = data["curves"] if isinstance(data, dict) else data
    if not isinstance(entries, list):
        raise CurveFileError("the JSON text holds no curves", remedy='write one curve or {"curves": […]}')
    for number, entry in enumerate(entries, 1):
        what = "surface" if _is_surface(entry) else "curve"
        name = entry.get("name") if isinstance(entry, dict) else None
        where = f"{what} {number}" + (f" ({name})" if isinstance(name, str) and name else "")
        with collector.skipping(what, where, curve=what == "curve"):
            _add(collector, entry, where)
    return collector.reading()


def _is_surface(entry: Any) -> bool:
    return isinstance(entry, dict) and isinstance(entry.get("degree"), list)


def _add(collector: Collector, entry: Any, where: str) -> None:
    (_surface if _is_surface(entry) else _curve)(collector, entry, where)


def _curve(collector: Collector, entry: Any, where: str) -> None:
    if not isinstance(entry, dict):
        raise CurveFileError("is not an object", remedy='write {"degree": …, "knots": […], "control_points": […]}')
    collector.count(sum(len(entry[key]) for key in SIZED if isinstance(entry.get(key), list)))
    piece = "pieces" in entry or "kind" in entry
    entry, unrolled = (entry, []) if piece else _whole(entry, collector.limits)
    curve = curve_from_data(entry, where if piece else Path(collector.source.name).stem, collector.limits)
    remarks = [curve.note, f"source: {curve.source}" if curve.source else ""]
    notes = ["written by `derive`"] if piece else [*filter(None, remarks), *unrolled]
    collector.keep(curve, notes, rational=not piece and entry.get("weights") is not None)


def _whole(entry: dict[str, Any], limits: Limits) -> tuple[dict[str, Any], Sequence[str]]:
    """The data of a curve, and notes. If only one period of the curve is listed, the data are continued."""
    degree, listed = entry.get("degree"), {key: entry[key] for key in SIZED if isinstance(entry.get(key), list)}
    knots, points = listed.get("knots", []), listed.get("control_points", [])
    # a degree beyond the limits is refused later
    n = int(degree) if isinstance(degree, str) and degree.isdecimal() and len(degree) < 9 else limits.degree + 1
    if n > limits.degree or len(knots) == len(points) + n + 1:
        return entry, ()
    full = whole(n, [*KnotVector(numbers_of(knots, "knots", limits))], len(points))
    more = {key: full.continued(values) for key, values in listed.items()} | {"knots": list(map(str, full.knots))}
    return (entry | more, full.notes) if full.notes else (entry, ())


def _surface(found: Collector, entry: Any, where: str) -> None:
    rows = entry.get("control_points", entry.get("points", ()))
    found.count(sum(len(row) for row in rows if isinstance(row, list)) if isinstance(rows, list) else 1)
    found.surfaces.append(surface_from_data(entry, Path(found.source.name).stem or where, found.limits))


def write(splines: Sequence[Spline], numbers: NumberText) -> bytes:
    """A single curve or surface as an object, several curves as ``{"curves": […]}``, surfaces as a list; always
    exact.
    """
    entries = [
        (surface_data(s.of) if isinstance(s.of, NurbsSurface) else curve_data(s.of)) | {"name": s.name} for s in splines
    ]
    several: Any = entries if splines[0].is_surface else {"curves": entries}
    return (json.dumps(entries[0] if len(entries) == 1 else several, indent=1, ensure_ascii=False) + "\n").encode()


FORMAT = Format("json", "exactspline JSON", (".json",), looks_like, read, write, surfaces=True)
