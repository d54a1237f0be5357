"""The result of a sweep for one curve or surface: a line, as an object and as data under a published schema. The
summary of a sweep is gathered line by line in constant memory.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, fields, is_dataclass
from enum import StrEnum
from heapq import heappush, heappushpop
from typing import Any, get_args, get_origin, get_type_hints

from exactspline.batch.corpus import SKIPPED, Problem
from exactspline.interchange.curve_files import short_digest
from exactspline.one_line import OneLine, one_line
from exactspline.questions.entry import Of

#: The version of a line's schema; it is raised when a field changes its meaning or is removed.
VERSION = 7


#: The kind of a piece all of whose points answer a question about points.
EVERYWHERE = "everywhere"
#: The kind of a part of a surface in which something is not decided.
UNDECIDED = "undecided"


@dataclass(frozen=True, repr=False)
class Found(OneLine):
    """A point or a piece that was found: its kind, its parameter if that is rational, and its place. A piece all of
    whose points answer a question about points has the kind `EVERYWHERE`.

    A rational parameter is `low` and `high`; an irrational one lies strictly between these two, neighbouring decimals
    with the requested number of digits; a piece runs from `low` to `high`, for a piece across the seam of a closed
    curve through the end of its domain.

    If values are asked for, a point has its coordinates and the curvature as correctly rounded doubles. A missing value
    is None: `z` in the plane, the curvature at γ′ = 0 or at a knot whose two sides differ, a number beyond the largest
    double.

    If two parameters belong together, as at self-intersections, the second one lies between `other_low` and
    `other_high`, or runs between them.
    """

    kind: str
    parameter: str | None
    low: str
    high: str
    x: float | None = None
    y: float | None = None
    z: float | None = None
    curvature: float | None = None
    other_low: str | None = None
    other_high: str | None = None


class Way(StrEnum):
    """The way in which the certified filter, or the exact fallback, decided a curve."""

    DECIDED = "decided in doubles"
    EXACT = "decided by exact arithmetic"
    MISSING = "decided by exact arithmetic, without the compiled filter"


@dataclass(frozen=True, repr=False)
class Judged(OneLine):
    """A claim checked on this curve: its verdict, whether that is the recorded verdict, and the witness if there is
    one.
    """

    claim: str
    verdict: str
    as_recorded: bool
    witness: str


@dataclass(frozen=True)
class Line:
    """Everything about one curve or one surface. A surface has `degrees` in place of a degree, `patches` in place of
    segments, and the `answers` to questions about it as data, as `inspect` prints them. Lines are equal if their
    results are equal: the processor time is part of the data of a line, but is not compared; the way in which the
    results were obtained is not part of its data.
    """

    index: int
    source: str
    curve: str
    degree: int | None = None
    dimension: int | None = None
    segments: int | None = None
    polynomial: bool | None = None
    found: Mapping[str, tuple[Found, ...]] = field(default_factory=dict)
    claims: tuple[Judged, ...] = ()
    degrees: tuple[int, ...] = ()
    patches: int | None = None
    answers: Mapping[str, Any] = field(default_factory=dict)
    error: Problem | None = None
    #: Notes of the file's reader about the curve.
    notes: tuple[str, ...] = ()
    #: The digest of the exact data of the curve (see `Item.digest`).
    curve_digest: str = ""
    seconds: float = field(default=0, compare=False)
    #: The way in which the certified filter decided; None if it was not used, and for lines that were read.
    way: Way | None = field(default=None, compare=False)

    @one_line
    def __repr__(self) -> str:
        return f"<Line {self.index}: {self.curve}>"

    def data(self) -> dict[str, object]:
        """The line as data, as `line_schema` describes it."""
        fields = {name: getattr(self, name) for name in DATA}
        fields |= {
            "found": {name: [dict(vars(each)) for each in points] for name, points in self.found.items()},
            "claims": [dict(vars(each)) for each in self.claims],
            "error": None if self.error is None else dict(vars(self.error)),
            "notes": list(self.notes),
            "degrees": list(self.degrees),
            "answers": dict(self.answers),
        }
        return fields | {"digest": _digest_of(fields)}

    def kinds(self) -> Iterator[tuple[str, str]]:
        """The question and the kind of each point or piece that was found. Undecided ones have the kind `UNDECIDED`.

        >>> from exactspline import example
        >>> from exactspline.batch.sweep import sweep
        >>> [*next(sweep([example("monkey_saddle")], find=["umbilics"], surfaces=True)).kinds()]
        [('umbilics', 'star')]
        """
        for name, points in self.found.items():
            yield from ((name, each.kind) for each in points)
        for name, answer in self.answers.items():
            if isinstance(answer, dict) and "points" in answer:
                yield from ((name, each.get("kind", "point")) for each in answer["points"])
                yield from ((name, EVERYWHERE) for _ in answer["everywhere"])
                yield from ((name, UNDECIDED) for _ in answer["undecided"])
            elif isinstance(answer, list):
                kinds = [str(each.get("kind", each.get("what", ""))) for each in answer if isinstance(each, dict)]
                yield from ((name, kind) for kind in kinds)
            elif isinstance(answer, str):
                yield name, answer

    @classmethod
    def from_data(cls, data: Mapping[str, object]) -> Line:
        """The line of which this is the `data`.

        >>> line = Line(0, "font.ttf", "A.1", error=Problem("ShapeError", "no area"))
        >>> Line.from_data(line.data()) == line
        True

        Raises `KeyError` or `TypeError` for data that are not a line, and `ValueError` for a line that was changed.
        """
        given: dict[str, object] = dict(data)
        if given.pop("digest") != _digest_of(given):
            raise ValueError("the digest of the line does not match its data")
        found, claims, error = (given.pop(name) for name in ("found", "claims", "error"))
        assert isinstance(found, dict)
        assert isinstance(claims, list)
        given["found"] = {name: tuple(Found(**each) for each in points) for name, points in found.items()}
        given["claims"] = tuple(Judged(**each) for each in claims)
        for name in ("notes", "degrees"):
            given[name] = tuple(given[name])  # type: ignore[arg-type]  # a list, as its digest says
        given["error"] = Problem(**error) if isinstance(error, dict) else None
        return cls(**given)  # type: ignore[arg-type]  # data just parsed, whose contents the schema checks


def _digest_of(data: Mapping[str, object]) -> str:
    """A digest of all fields of a line except the processor time, which differs each time. Thus a line that was changed
    by hand, or by a damaged disk, is noticed when its sweep is continued.
    """
    fields = {name: value for name, value in data.items() if name != "seconds"}
    return short_digest(json.dumps(fields, ensure_ascii=False, sort_keys=True, separators=(",", ":")))


#: The fields of a line that make up its data.
DATA = tuple(each.name for each in fields(Line) if each.name != "way")


def line_schema() -> dict[str, object]:
    """The JSON Schema of a line.

    >>> line_schema()["title"]
    'exactspline/sweep_line, version 7'
    """
    from exactspline.display.answer_forms import form_of
    from exactspline.geometry.analysis.ask import REGISTRY

    properties = {
        name: _form(kind) for name, kind in get_type_hints(Line).items() if name in DATA and name != "answers"
    }
    # the arguments of a question follow its name
    properties["answers"] = {
        "type": "object",
        "additionalProperties": False,
        "patternProperties": {
            f"^{name}([:@]|$)": form_of(entry).schema
            for of in (Of.SURFACE, Of.PLANAR_MAP)
            for name, entry in REGISTRY[of].items()
        },
    }
    properties["index"] |= {"minimum": 0}
    properties["seconds"] |= {"minimum": 0}
    return _object(properties | {"digest": _form(str)}) | {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": f"exactspline/sweep_line, version {VERSION}",
    }


_SIMPLE = {str: "string", int: "integer", bool: "boolean", float: "number"}


def _form(kind: Any) -> dict[str, Any]:
    """The JSON Schema of the type of a field."""
    parts = get_args(kind)
    if kind in _SIMPLE:
        return {"type": _SIMPLE[kind]}
    if is_dataclass(kind):
        return _object({name: _form(each) for name, each in get_type_hints(kind).items()})
    if get_origin(kind) is tuple:
        return {"type": "array", "items": _form(parts[0])}
    if get_origin(kind) is Mapping:
        return {"type": "object", "additionalProperties": _form(parts[1])}
    inner = _form(parts[0])  # or None
    return {"type": [inner["type"], "null"]} if parts[0] in _SIMPLE else {"anyOf": [{"type": "null"}, inner]}


def _object(properties: Mapping[str, object]) -> dict[str, Any]:
    return {"type": "object", "required": list(properties), "additionalProperties": False, "properties": properties}


#: Words in place of the decision of the filter, for lines of a sweep that is continued, and for curves that were not
#: given to the filter.
BEFORE, NOT_ASKED = "computed before", "not asked"
#: The number of slowest curves, and of verdicts that differ from the recorded ones, that are named.
NAMED = 5
#: The number of notes of readers that are listed, the most frequent first, since notes may differ only in a number.
NOTES = 20
#: The counts per family.
REFUSED, FALLBACK, OPEN = "refused", "decided by exact arithmetic after the filter", "with an undecided claim"
UNDECIDED_CLAIM = "UNDECIDED"


@dataclass(frozen=True, repr=False)
class Tally(OneLine):
    """A line of the summary: the kind of the counted thing, its name, and the count or the processor time."""

    what: str
    name: str = ""
    count: int | None = None
    seconds: float | None = None


@dataclass
class Summary:
    """Counts over all lines.

    >>> from exactspline.batch.sweep import sweep
    >>> summary = Summary()
    >>> for line in sweep(["circle", "six_segment_cubic", "cusp"]):
    ...     summary.add(line)
    >>> [(each.name, each.count) for each in summary.entries() if each.what == "degree"]
    [('2', 1), ('3', 2)]
    """

    #: The families of random curves, by their descriptions: for each, the curves that were not decided by the filter
    #: are counted.
    families: frozenset[str] = frozenset()
    lines: int = 0
    segments: int = 0
    patches: int = 0
    seconds: float = 0
    degrees: Counter[int] = field(default_factory=Counter)
    errors: Counter[str] = field(default_factory=Counter)
    found: Counter[tuple[str, str]] = field(default_factory=Counter)
    verdicts: Counter[tuple[str, str]] = field(default_factory=Counter)
    #: The ways in which the certified filter decided the curves of this run.
    filter: Counter[str] = field(default_factory=Counter)
    notes: Counter[str] = field(default_factory=Counter)
    #: By family, the curves that were not decided or decided by a fallback; and the number of curves of the family.
    aside: Counter[tuple[str, str]] = field(default_factory=Counter)
    of_family: Counter[str] = field(default_factory=Counter)
    differing: int = 0
    #: Claims with a recorded verdict that were too costly to decide on a curve.
    open: int = 0
    #: Failures on valid input: defects of this program.
    alarms: int = 0
    examples: list[str] = field(default_factory=list)
    #: The first curves that could not be read or handled, each with the reason.
    refused: list[str] = field(default_factory=list)
    _slowest: list[tuple[float, int, str]] = field(default_factory=list)

    def add(self, line: Line, *, known: bool = False) -> None:
        """Count one line; `known` means that an earlier sweep computed the line, so that the way in which it was
        decided is unknown.
        """
        if known or line.error is None:
            self.filter[BEFORE if known else line.way or NOT_ASKED] += 1
        self.lines += 1
        self.segments += line.segments or 0
        self.seconds += line.seconds
        if line.degree is not None:
            self.degrees[line.degree] += 1
        name = ": ".join(dict.fromkeys(filter(None, (line.source, line.curve)))) or f"curve {line.index}"
        if line.error is not None:
            self.errors[line.error.kind] += 1
            if not line.error.bad_input:
                self.alarms += 1
                self._remember(f"{name}: {line.error.kind}: {line.error.message}")
            elif line.error.kind != SKIPPED and len(self.refused) < NAMED:
                self.refused.append(f"{name}: {line.error.message}")
        self.notes.update(line.notes)
        if line.source in self.families:
            self.of_family[line.source] += 1
            self.aside.update((line.source, what) for what in _set_aside(line))
        self.found.update(line.kinds())
        self.patches += line.patches or 0
        self.verdicts.update((each.claim, each.verdict) for each in line.claims)
        for each in line.claims:
            if not each.as_recorded:
                self.differing += each.verdict != UNDECIDED_CLAIM
                self.open += each.verdict == UNDECIDED_CLAIM
                self._remember(f"{name}: {each.claim} is {each.verdict}")
        put = heappush if len(self._slowest) < NAMED else heappushpop
        put(self._slowest, (line.seconds, -line.index, name))

    def _remember(self, text: str) -> None:
        if len(self.examples) < NAMED:
            self.examples.append(text)

    @property
    def as_expected(self) -> bool:
        """Whether no verdict contradicts the record and nothing failed except on bad input."""
        return not self.differing and not self.alarms

    @property
    def all_decided(self) -> bool:
        """Whether no claim, and no part of an answer about a surface, is left undecided."""
        return not self.open and not any(kind == UNDECIDED for _, kind in self.found)

    @property
    def all_read(self) -> bool:
        """Whether every curve has a result; entities that are not curves are rightly skipped."""
        return set(self.errors) <= {SKIPPED}

    def entries(self) -> Iterator[Tally]:
        """The summary in the order in which it is printed."""
        read = self.lines - self.errors.total()
        if self.patches:
            yield Tally("surfaces", "", read)
            yield Tally("patches", "", self.patches)
        else:
            yield Tally("curves", "", read)
            yield Tally("segments", "", self.segments)
        yield from (Tally("degree", str(degree), count) for degree, count in sorted(self.degrees.items()))
        yield from (Tally(what, kind, count) for (what, kind), count in sorted(self.found.items()))
        yield from (Tally(claim, verdict, count) for (claim, verdict), count in sorted(self.verdicts.items()))
        yield from (Tally("error", kind, count) for kind, count in sorted(self.errors.items()))
        yield from (Tally("refused", text) for text in self.refused)
        yield from (Tally("not as expected", text) for text in self.examples)
        yield from (Tally("note", text, count) for text, count in self.notes.most_common(NOTES))
        if len(self.notes) > NOTES:
            yield Tally("note", "others", sum(self.notes.values()) - sum(n for _, n in self.notes.most_common(NOTES)))
        for family in sorted(self.of_family):
            yield Tally("family", family, self.of_family[family])
            counted = ((what, count) for (own, what), count in sorted(self.aside.items()) if own == family)
            yield from (Tally(f"family: {what}", family, count) for what, count in counted)
        yield from (Tally("filter", way, count) for way, count in sorted(self.filter.items()))
        yield Tally("processor time", "", None, self.seconds)
        yield from (Tally("slowest", name, None, seconds) for seconds, _, name in sorted(self._slowest, reverse=True))


def _set_aside(line: Line) -> Iterator[str]:
    """The parts of a line that were refused, undecided, or decided by a fallback."""
    if line.error is not None:
        yield REFUSED
    if line.way is Way.EXACT:
        yield FALLBACK
    if any(each.verdict == UNDECIDED_CLAIM for each in line.claims):
        yield OPEN
