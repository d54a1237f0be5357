"""The JSON of exactspline: one curve as read by `exactspline.interchange.curve_files`, or ``{"curves": […]}``.

The published schema is `exactspline/interchange/curve.schema.json`. Every curve is represented exactly: numbers are
integers, decimals or strings such as "1/3".
"""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from importlib import resources
from typing import Any

from exactspline.errors import CurveFileError, ExactSplineError, NumberError, shown
from exactspline.interchange.collector import Collector
from exactspline.interchange.curve_files import curve_data, curve_from_data
from exactspline.interchange.json_files import CURVE, check_fields, parsed
from exactspline.interchange.numbers import NumberText, whole
from exactspline.interchange.records import Format, NamedCurve, Reading, Source
from exactspline.interchange.surface_files import surface_from_data
from exactspline.numbers.exact import mpq, rational
from exactspline.splines.control_points import Direction

_EXPONENT = re.compile(r"[+-]?\d{1,7}", re.ASCII)


def schema() -> dict[str, object]:
    """The JSON Schema of the format.

    >>> schema()["title"]
    'exactspline curve file'
    """
    text = resources.files("exactspline.interchange").joinpath("curve.schema.json").read_text(encoding="utf-8")
    data: dict[str, Any] = json.loads(text)
    return data


def looks_like(head: bytes) -> bool:
    """Whether a file begins like a curve file."""
    return head.lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"{")


def read(source: Source) -> Reading:
    """The curves of a file."""
    collector = Collector("json", source)
    data: Any = parsed(source.text)
    entries = data.get("curves", [data]) if isinstance(data, dict) else data
    if not isinstance(entries, list):
        raise CurveFileError("the JSON text holds no curves", remedy='write one curve or {"curves": […]}')
    for number, entry in enumerate(entries, 1):
        is_surface = isinstance(entry, dict) and isinstance(entry.get("degree"), list)
        what = "surface" if is_surface else "curve"
        where = f"{what} {number}"
        try:
            (_surface if is_surface else _curve)(collector, entry, where)
        except ExactSplineError as error:
            collector.skip(what, where, str(error), curve=not is_surface)
    return collector.reading()


def _curve(collector: Collector, entry: Any, where: str) -> None:
    if not isinstance(entry, dict):
        raise CurveFileError("is not an object", remedy='write {"degree": …, "knots": […], "control_points": […]}')
    if "pieces" in entry or "kind" in entry:
        curve = curve_from_data(entry, where)
        collector.curves.append(NamedCurve(curve.name, curve, ("written by `derive`",)))
        return
    check_fields(entry, CURVE)
    collector.add(
        "curve",
        where,
        whole(str(entry["degree"])),
        _row(collector, entry["knots"], "knots"),
        [_point(collector, row, f"control_points[{i}]") for i, row in enumerate(_list(entry["control_points"]))],
        None if entry.get("weights") is None else _row(collector, entry["weights"], "weights"),
        name=str(entry.get("name") or "") or collector.source.name,
        notes=[f"{key}: {entry[key]}" for key in ("note", "source") if entry.get(key)],
        source=str(entry.get("source") or ""),
        note=str(entry.get("note") or ""),
    )


def _surface(found: Collector, entry: Any, where: str) -> None:
    rows = entry.get("control_points", entry.get("points", ()))
    found.count(sum(len(row) for row in rows if isinstance(row, list)) if isinstance(rows, list) else 1)
    found.surfaces.append(surface_from_data(entry, found.source.name or where))


def _list(value: Any) -> list[Any]:
    if not isinstance(value, list):
        raise CurveFileError("a list is missing", remedy="write JSON lists")
    return value


def _row(collector: Collector, values: Any, where: str) -> list[mpq]:
    collector.count(len(_list(values)))
    return [_number(value, collector, f"{where}[{i}]") for i, value in enumerate(values)]


def _point(collector: Collector, row: Any, where: str) -> Sequence[mpq]:
    """A point, written as a list, or a direction (of weight zero), written as an object."""
    if isinstance(row, dict) and set(row) == {"vector"}:
        return Direction(*_row(collector, row["vector"], where))
    return _row(collector, row, where)


def _number(value: Any, collector: Collector, where: str) -> mpq:
    if not isinstance(value, str):
        raise NumberError(f"{shown(value)} is not a number", where=where, remedy='write 3, 0.1 or "1/3"')
    mark, most = ("p", 4 * collector.limits.exponent) if "x" in value.lower() else ("e", collector.limits.exponent)
    exponent = value.lower().partition(mark)[2].strip()
    # an exponent of a few digits could exhaust the memory
    if exponent and (not _EXPONENT.fullmatch(exponent) or abs(int(exponent)) > most):
        raise NumberError(f"the exponent {exponent[:20]!r}", where=where, remedy=f"exponents up to {most} are read")
    if len(value) > 50 * collector.limits.digits:
        raise NumberError(
            f"a number of {len(value)} characters", where=where, remedy="read with a larger limit of digits"
        )
    return rational(str(value))


def write(curves: Sequence[NamedCurve], numbers: NumberText) -> bytes:
    """A single curve as an object, several as ``{"curves": […]}``; always exact."""
    entries = [curve_data(named.curve) | {"name": named.name} for named in curves]
    data: Any = entries[0] if len(entries) == 1 else {"curves": entries}
    return (json.dumps(data, indent=1, ensure_ascii=False) + "\n").encode()


FORMAT = Format("json", "exactspline JSON", (".json",), looks_like, read, write)
