"""A pack of vectors: a file per family, a case per line, every number as exact text or as the doubles below, nearest to
and above it.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any
from zlib import crc32

from exactspline.atomic_write import write_text
from exactspline.errors import ExactSplineError
from exactspline.geometry.analysis.curves import QUESTIONS, questions_about
from exactspline.geometry.analysis.pairs import CurvePair
from exactspline.geometry.curves.planarity import in_the_plane
from exactspline.numbers.exact import double, text
from exactspline.questions.answers import NamedNumbers
from exactspline.questions.entry import Answered, questions_of
from exactspline.reals.real import Real
from exactspline.splines.nurbs import Nurbs
from exactspline.testing import Case
from workshop.grade.questions import MEETINGS, PLACES, STRAIGHT, ULPS
from workshop.grade.questions import QUESTIONS as ASKED
from workshop.vectors.items import items

#: Increased whenever a field changes its meaning.
VERSION = 2
#: Questions at the parameter of the case.
AT = {
    "value": f"the point; off by at most {ULPS}",
    "derivative": f"the first derivative; off by at most degree / (shortest segment) times {ULPS}",
    "curvature": "the curvature (signed in the plane); off by what follows from the errors allowed for γ′ and γ″",
    "torsion": "the torsion; off by what follows from the errors allowed for γ′, γ″ and γ‴",
}
#: Questions of the registry: those about places, joints, pieces and pairs.
LISTED = (Answered.PLACES, Answered.JOINTS, Answered.PIECES, Answered.PAIRS)
#: Questions about the curve and its partner, and about the curve and the first control point of the partner.
PAIRS = {name: entry for name, entry in questions_of(CurvePair).items() if entry.about.reported}
ABOUT_POINT = ("nearest", "winding_number")


def questions() -> dict[str, dict[str, str]]:
    """Every question of a pack: its meaning, and when an answer in doubles counts as right."""
    found = {name: {"meaning": meaning, "right": "see meaning"} for name, meaning in AT.items()}
    found["bounding_box"] = {"meaning": "the smallest and largest coordinates", "right": f"2¹⁶ times {ULPS}"}
    for name in _of_registry():
        found[name] = {"meaning": QUESTIONS[name].meaning, "right": f"{PLACES}; {STRAIGHT}"}
    rights = {"intersections": MEETINGS, "winding_number": "the integer"}
    for name, entry in {**PAIRS, **{name: QUESTIONS[name] for name in ABOUT_POINT}}.items():
        of = "its partner" if name in PAIRS else "the point"
        found[name] = {
            "meaning": f"{entry.meaning}: of the curve and {of}",
            "right": rights.get(name, ASKED["nearest"].allowed),
        }
    return found


def _of_registry() -> list[str]:
    return [name for name, entry in QUESTIONS.items() if entry.about.answered in LISTED and not entry.about.argument]


def case_data(case: Case) -> dict[str, Any]:
    """A case with its answers as data.

        >>> from workshop.vectors.items import items
    from workshop.vectors.corpus import corpus
        >>> data = case_data(next(corpus("near", 1)))
        >>> data["dial"], data["answers"]["cusps"]["answer"], data["answers"]["inflections"]["answer"]
        ({'sign': 1, 'k': 2}, 'none', 'these')
    """
    case = replace(case, curve=in_the_plane(case.curve))
    curve, dial = case.curve, case.dial
    return {
        "key": case.key,
        "link": case.link,
        "note": case.note,
        "dial": {"sign": -1 if dial < 0 else 1, "k": abs(dial)} if dial else None,
        "degree": curve.degree,
        **_numbers(curve),
        # over the same knots
        "partner": _numbers(case.partner, with_knots=False),
        "parameter": {"exact": text(case.parameter), "double": double(case.parameter).hex()},
        "answers": dict(_answers(case)),
    }


def _numbers(curve: Nurbs, with_knots: bool = True) -> dict[str, dict[str, object]]:
    """The numbers of a curve as exact text and as hexadecimal doubles."""
    return {
        name: {
            **({"knots": list(map(write, curve.knots))} if with_knots else {}),
            "points": [list(map(write, point)) for point in curve.control_points],
            "weights": list(map(write, curve.weights)),
        }
        for name, write in (("exact", text), ("doubles", lambda x: double(x).hex()))
    }


def _answers(case: Case) -> Iterator[tuple[str, object]]:
    curve = case.curve
    asked = {name: f"{name}@{text(case.parameter)}" for name in AT} | {"bounding_box": "bounding_box"}
    asked |= {name: name for name in _of_registry() if name in questions_about(curve)}
    point = ",".join(map(text, case.point))
    asked |= {name: f"{name}:{point}" for name in ABOUT_POINT if name in questions_about(curve)}
    pair = CurvePair(curve, case.partner)
    ways: dict[str, Callable[[], Iterable[NamedNumbers]]] = {
        name: partial(items, curve, question) for name, question in asked.items()
    }
    ways |= {name: partial(items, pair, name) for name in PAIRS}
    for name, way in ways.items():
        try:
            yield name, answer_data(way())
        except ExactSplineError as error:
            yield name, {"answer": "undefined", "why": str(error).split(";")[0]}


def answer_data(given: Iterable[NamedNumbers]) -> dict[str, object]:
    """None, all of a piece, or these; each with its numbers in doubles (below, nearest, above; None beyond the largest
    double) and its facts.
    """
    found = [
        {"what": item.what}
        | {name: _doubles(value) for name, value in item.values.items()}
        | {"facts": dict(item.facts)}
        for item in given
    ]
    everywhere = any(each["what"] == "everywhere" for each in found)
    return {"answer": "all" if everywhere else "these" if found else "none", "items": found}


def _doubles(value: Real) -> list[str] | None:
    try:
        doubles = value.doubles()
    except OverflowError:
        return None
    return [doubles[way].hex() for way in ("down", "nearest", "up")]


def line_of(case: Case) -> str:
    """A case as a line of a pack: its text and the digest (CRC-32) of that text."""
    body = json.dumps(case_data(case), ensure_ascii=True, separators=(",", ":"))
    return f'{{"digest":"{crc32(body.encode()):08x}","case":{body}}}'


def write_pack(place: Path, family: str, cases: Iterable[Case]) -> int:
    """Write the file of a family; returns the number of its cases."""
    head = {"schema": "exactspline/vectors", "version": VERSION, "family": family, "questions": questions()}
    lines = [line_of(case) for case in cases]
    opening = json.dumps(head, ensure_ascii=True)[:-1]
    write_text(place, f'{opening}, "cases": [\n' + ",\n".join(lines) + "\n]}\n")
    return len(lines)
