"""IGES text: rational B-spline curves (126) and surfaces (128, without their trims), lines (110), circular arcs (100)
and conic arcs (104), moved by their transformation (124).

An arc is exact if its two ends are exactly at the same distance from its centre, a conic if its equation holds exactly
at its ends; otherwise it is skipped, with the reason. A spline is restricted to the parameter interval that its entity
uses. Coordinates are in the units of the file, which a note states. Curves in the parameter space of a surface (entity
use 05) are read as plane curves.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

from exactspline.errors import CurveFileError, counted
from exactspline.extras.cad import NAMES
from exactspline.interchange.collector import UNREAD, Collector, domain, used
from exactspline.interchange.format import Format, Spline
from exactspline.interchange.numbers import NumberText, decimal, whole, with_point
from exactspline.interchange.records import Limits, Reading, Source
from exactspline.interchange.segments import RIGHT, Affine, Round, Segment, conic_arc, mapped, polynomial, through_ends
from exactspline.numbers.exact import mpq
from exactspline.splines.nurbs import Nurbs

# ---- records


@dataclass
class _DirectoryEntry:
    """A directory entry: its number (odd), type, form, matrix (the number of its entry, or 0), use flag, whether it is
    blanked, its label, and its parameters as text.
    """

    number: int
    kind: int
    form: int
    matrix: int
    use: str
    blanked: bool
    label: str
    parameters: list[str]

    @property
    def place(self) -> str:
        """The type, and the number."""
        return f"entity {self.kind} (DE {self.number})"

    @property
    def name(self) -> str:
        """The label, or the type, and the number."""
        return f"{self.label or self.kind} {self.number}"


def _sections(text: str) -> dict[str, list[str]]:
    """The lines of each section by its letter; raises `CurveFileError` for letters other than S, G, D, P, T."""
    by_letter: dict[str, list[str]] = {letter: [] for letter in "SGDPT"}
    for number, line in enumerate(text.splitlines(), 1):
        if not line.strip():
            continue
        letter = line[72:73]
        if letter in ("B", "C"):
            raise CurveFileError("is binary or compressed IGES", where=f"line {number}", remedy="save it as IGES text")
        if letter not in by_letter:
            raise CurveFileError(f"{letter!r} in column 73", where=f"line {number}", remedy="S, G, D, P or T is there")
        by_letter[letter].append(line)
    return by_letter


def _delimiters(lines: list[str]) -> tuple[str, str, str]:
    """The parameter delimiter and the record delimiter, from the global section, and the rest of the section."""
    text = "".join(line[:72] for line in lines).lstrip()
    separator = text[2:3] if text[:2] == "1H" else ","
    rest = text[4:] if text[:2] == "1H" else text[1:]
    ending = rest[2:3] if rest[:2] == "1H" else ";"
    if not separator.strip() or not ending.strip() or separator == ending:
        raise CurveFileError("unusable delimiters", where="global section", remedy='the usual ones are "," and ";"')
    return separator, ending, rest[4:] if rest[:2] == "1H" else rest[1:]


def _parameters(text: str, separator: str, ending: str, limits: Limits) -> list[str]:
    """The parameters of a record, without blanks, and with strings as their text.

    >>> _parameters("126,3H,;a, 1.D0,;", ",", ";", Limits())
    ['126', ',;a', '1.D0', '']
    """
    values: list[str] = []
    position = 0
    plain = re.compile(f"[^{re.escape(separator + ending)}]*")
    hollerith = re.compile(r"\s*(\d{1,6})H")
    while position < len(text) and len(values) <= limits.objects:
        string = hollerith.match(text, position)
        if string:
            end = string.end() + int(string[1])
            values.append(text[string.end() : end])
            tail = plain.match(text, end)
            position = tail.end() if tail else end
        else:
            match = plain.match(text, position)
            assert match is not None
            values.append("".join(match[0].split()))
            position = match.end()
        if text[position : position + 1] == ending:
            return values
        position += 1
    raise CurveFileError("a record is not terminated", remedy=f"records end with {ending!r}")


def _unit_of(text: str) -> str:
    """The unit of length given in the global section, "" if there is none."""
    separator, ending, rest = _delimiters(_sections(text)["G"])
    try:
        values = _parameters(rest, separator, ending, Limits())
    except CurveFileError:
        return ""
    # parameters 14 and 15 of the section, the first two of which are the delimiters
    flag, name = (values[i] if i < len(values) else "" for i in (11, 12))
    return name if flag == "3" else str(NAMES["iges units"].get(flag, ""))


def _entries(text: str, limits: Limits) -> list[_DirectoryEntry]:
    """All directory entries with their parameters."""
    lines = _sections(text)
    if len(lines["D"]) % 2:
        raise CurveFileError("an odd number of directory lines", remedy="each entry takes two lines")
    separator, ending, _ = _delimiters(lines["G"])
    blocks: dict[int, list[str]] = {}
    for line in lines["P"]:
        pointer = line[64:72].strip() or "0"
        blocks.setdefault(whole(pointer.lstrip("0") or "0"), []).append(line[:64].ljust(64))
    result = []
    for i in range(0, len(lines["D"]), 2):
        first, second = lines["D"][i].ljust(80), lines["D"][i + 1].ljust(80)
        block = "".join(blocks.get(i + 1, []))
        status = first[64:72].replace(" ", "0")
        numbers = _field(first, 0), _field(second, 4), _field(first, 6)
        values = _parameters(block, separator, ending, limits) if block else []
        result.append(_DirectoryEntry(i + 1, *numbers, status[4:6], status[:2] == "01", second[56:64].strip(), values))
    return result


def _field(line: str, index: int) -> int:
    text = line[8 * index : 8 * index + 8].strip()
    return whole(text) if text else 0


def formatted(entities: list[tuple[int, int, int, str, list[str]]], title: str) -> bytes:
    """An IGES file with these entities (type, form, use flag, label, parameters)."""
    directory: list[str] = []
    data: list[str] = []
    for number, (kind, form, use, label, values) in enumerate(entities):
        pointer = 2 * number + 1
        lines = _wrapped([str(kind), *values], 64)
        status = f"0000{use:02}00"
        directory.append(f"{kind:8}{len(data) + 1:8}" + f"{0:8}" * 6 + status)
        directory.append(f"{kind:8}{0:8}{0:8}{len(lines):8}{form:8}" + " " * 16 + f"{label[:8]:>8}{0:8}")
        data += [f"{line:<64} {pointer:7}" for line in lines]
    settings = _wrapped(NAMES["iges settings"], 72)
    sheets = {"S": [title[:72]], "G": settings, "D": directory, "P": data}
    sheets["T"] = ["".join(f"{letter}{len(lines):7}" for letter, lines in sheets.items())]
    return "".join(
        f"{line:<72}{letter}{i:7}\n" for letter, lines in sheets.items() for i, line in enumerate(lines, 1)
    ).encode("ascii", "replace")


def _wrapped(values: list[str], width: int) -> list[str]:
    lines = [""]
    for i, value in enumerate(values):
        piece = value + (";" if i == len(values) - 1 else ",")
        if len(lines[-1]) + len(piece) > width:
            lines.append("")
        lines[-1] += piece
    return lines


ARC, COMPOSITE, CONIC, LINE, MATRIX, SPLINE, SURFACE = 100, 102, 104, 110, 124, 126, 128
#: Entities that are curves, or that contain curves not read elsewhere.
CURVES = (106, 112, 130, 308, 320, 408, 412, 414, 420)
PARAMETER_SPACE = "05"


def _looks_like(head: bytes) -> bool:
    """Whether column 73 of the first line is S, followed by a number."""
    return bool(re.match(rb"[^\r\n]{72}S[ 0]*1\b", head))


class _Values:
    """The parameters of an entity, read in sequence."""

    def __init__(self, entry: _DirectoryEntry, collector: Collector) -> None:
        self.texts, self.position, self.collector = entry.parameters, 1, collector

    def text(self) -> str:
        """The next parameter as text, empty if it is omitted."""
        if self.position >= len(self.texts):
            raise CurveFileError(f"only {counted(len(self.texts), 'parameter')}", remedy="complete the record")
        self.position += 1
        return self.texts[self.position - 1]

    def whole(self) -> int:
        """The next parameter as an integer, 0 if it is omitted."""
        return whole(self.text() or "0")

    def numbers(self, count: int) -> list[mpq]:
        """The next `count` parameters as decimals, 0 for each that is omitted."""
        self.collector.count(count)
        return [decimal(self.text() or "0", self.collector.limits) for _ in range(count)]

    def rows(self, count: int) -> list[list[mpq]]:
        """The next `count` points in space."""
        return [self.numbers(3) for _ in range(count)]


def _read(source: Source) -> Reading:
    """The curves of a file."""
    collector = Collector("iges", source)
    directory = {entry.number: entry for entry in _entries(source.text, source.limits)}
    collector.unit(_unit_of(source.text))
    # curves that consist of other curves come last
    for entry in sorted(directory.values(), key=lambda entry: entry.kind == COMPOSITE):
        where = entry.place
        reader = partial(_composite, directory) if entry.kind == COMPOSITE else _READERS.get(entry.kind)
        if entry.kind == MATRIX:
            continue
        if reader is None:
            name = NAMES["iges"].get(str(entry.kind), f"entity {entry.kind}")
            why = NAMES["iges reasons"].get(str(entry.kind), UNREAD)
            collector.skip(name, where, why, curve=entry.kind in CURVES)
            continue
        with collector.skipping(f"entity {entry.kind}", where, curve=entry.kind not in (SURFACE, COMPOSITE)):
            reader(collector, entry, where, _placement(collector, directory, entry))
    return collector.reading()


def _composite(
    directory: dict[int, _DirectoryEntry], collector: Collector, entry: _DirectoryEntry, where: str, placed: Affine
) -> None:
    """Join the parts of a composite curve."""
    values = _Values(entry, collector)
    held = [directory.get(values.whole()) for _ in range(values.whole())]
    if not placed.is_identity:
        raise CurveFileError("moved as a whole", remedy="its parts are read where they are defined")
    collector.join(f"entity {entry.kind}", where, [(each.place if each else "", True) for each in held], entry.name)


def _placement(collector: Collector, directory: dict[int, _DirectoryEntry], entry: _DirectoryEntry) -> Affine:
    """The transformation of an entity, composed with those that its matrix entity refers to."""
    whole_map = Affine.identity(3)
    for _ in range(collector.limits.depth):
        if not entry.matrix:
            return whole_map
        following = directory.get(abs(entry.matrix))
        if following is None or following.kind != MATRIX:
            raise CurveFileError(f"no matrix at DE {entry.matrix}", remedy="field 7 must refer to an entity 124")
        numbers = _Values(following, collector).numbers(12)
        whole_map = Affine([numbers[i : i + 4] for i in (0, 4, 8)]) @ whole_map
        entry = following
    raise CurveFileError("matrices form a cycle or are too many", remedy="correct field 7")


def _spline(collector: Collector, entry: _DirectoryEntry, where: str, placed: Affine) -> None:
    values = _Values(entry, collector)
    last, degree = values.whole(), values.whole()
    _planar, closed, flagged_polynomial, periodic = (values.whole() for _ in range(4))
    if last < 0 or degree < 0:
        raise CurveFileError(f"{last + 1} points of degree {degree}", remedy="both must be positive")
    knots, weights = values.numbers(last + degree + 2), values.numbers(last + 1)
    points = [placed(point) for point in values.rows(last + 1)]
    start, end = values.numbers(2)
    within, notes = used(domain(degree, knots), start, end)
    if flagged_polynomial and len(set(weights)) > 1:
        notes.append("flagged polynomial, but its weights differ: read as rational")
    plain = None if len(set(weights)) == 1 and weights[0] == 1 and flagged_polynomial else weights
    flagged = ["periodic"] * bool(periodic) + ["closed"] * bool(closed and within is None)
    flat, remarks = _remarks(entry, points, notes)
    parts = degree, knots, [point[: 2 if flat else 3] for point in points], plain
    more: dict[str, Any] = {"name": entry.name, "notes": remarks, "within": within, "flagged": flagged}
    collector.add(f"entity {entry.kind}", where, *parts, **more)


def _surface(collector: Collector, entry: _DirectoryEntry, where: str, placed: Affine) -> None:
    values = _Values(entry, collector)
    last_u, last_v, m, n = (values.whole() for _ in range(4))
    _closed_u, _closed_v, polynomial, _periodic_u, _periodic_v = (values.whole() for _ in range(5))
    if min(last_u, last_v, m, n) < 0:
        raise CurveFileError(f"{last_u + 1} × {last_v + 1} points of degree {m} × {n}", remedy="all must be positive")
    count = (last_u + 1) * (last_v + 1)
    collector.room(4 * count)
    knots = values.numbers(last_u + m + 2), values.numbers(last_v + n + 2)
    weights, points = values.numbers(count), [placed(point) for point in values.rows(count)]
    ends = values.numbers(4)
    whole = [domain(*side) for side in zip((m, n), knots, strict=True)]
    sides = [used(*side) for side in zip(whole, ends[::2], ends[1::2], strict=True)]
    notes = [remark for _, remarks in sides for remark in remarks]
    used_u, used_v = (part or all_of_it for (part, _), all_of_it in zip(sides, whole, strict=True))
    plain = None if polynomial and set(weights) == {1} else weights
    more: dict[str, Any] = {"name": entry.name, "notes": notes, "within": (used_u, used_v)}
    collector.add_surface(f"entity {SURFACE}", where, (m, n), knots, points, plain, **more)


def _add(
    collector: Collector, entry: _DirectoryEntry, where: str, segments: Sequence[Segment], notes: Sequence[str] = ()
) -> None:
    """Add the curve made of segments."""
    flat, notes = _remarks(entry, [point for segment in segments for point in segment], notes)
    if flat:
        segments = [tuple((x, y, w) for x, y, _, w in segment) for segment in segments]
    collector.add_segments(f"entity {entry.kind}", where, segments, entry.name, notes)


def _remarks(
    entry: _DirectoryEntry, points: Sequence[Sequence[mpq]], notes: Sequence[str]
) -> tuple[bool, Sequence[str]]:
    """Whether a curve lies in the parameter plane of a surface, and notes on the entity."""
    flat = entry.use == PARAMETER_SPACE and all(point[2] == 0 for point in points)
    remarks = ["in the parameter plane of a surface"] if flat else []
    return flat, [*notes, *remarks, *(["blanked: not to be displayed"] if entry.blanked else [])]


def _line(collector: Collector, entry: _DirectoryEntry, where: str, placed: Affine) -> None:
    if entry.form:
        raise CurveFileError("an unbounded line or ray", remedy="write a segment, which is form 0")
    _add(collector, entry, where, [polynomial(*(placed(point) for point in _Values(entry, collector).rows(2)))])


def _arc(collector: Collector, entry: _DirectoryEntry, where: str, placed: Affine) -> None:
    z, *numbers = _Values(entry, collector).numbers(7)
    centre, start, end = numbers[:2], numbers[2:4], numbers[4:]
    x, y = (a - b for a, b in zip(start, centre, strict=True))
    # the circle through the start, whose radius may be irrational
    within = collector.source.within
    curve = Round(Affine([[x, -y, centre[0]], [y, x, centre[1]]]), within and within / placed.stretch)
    arc = curve.arc(RIGHT[0], curve.at_point(end))
    _add(collector, entry, where, _lifted(arc, placed, z), curve.notes)


def _conic(collector: Collector, entry: _DirectoryEntry, where: str, placed: Affine) -> None:
    *numbers, z, x1, y1, x2, y2 = _Values(entry, collector).numbers(11)
    start, notes, within = (x1, y1), list[str](), collector.source.within
    form, end = through_ends(numbers, start, (x2, y2), within and within / placed.stretch, notes)
    _add(collector, entry, where, _lifted(conic_arc(form, start, end), placed, z), notes)


def _lifted(segments: Sequence[Segment], placed: Affine, z: mpq) -> list[Segment]:
    """Segments of a plane at this height, placed in space."""
    return mapped([tuple((x, y, z * w, w) for x, y, w in segment) for segment in segments], placed)


_READERS = {SPLINE: _spline, SURFACE: _surface, LINE: _line, ARC: _arc, CONIC: _conic}

#: The longest text of a number: it must fit on a line of 64 columns.
LONGEST_NUMBER = 63


def _write(splines: Sequence[Spline], numbers: NumberText) -> bytes:
    """The curves as entities 126, surfaces as entities 128. Plane curves are placed at z = 0 and flagged planar, maps
    of the plane are placed at z = 0.
    """
    numbers.longest = LONGEST_NUMBER
    entities = []
    for i, spline in enumerate(splines, 1):
        of, points = spline.of, spline.in_space()
        flags, normal = [0, 0, int(of.polynomial), 0, 0], list[mpq]()
        kind, name, domain = SURFACE, f"SURF{i}", [end for side in spline.domains for end in side]
        if isinstance(of, Nurbs):
            plane = int(of.dimension == 2)
            flags, normal = [plane, int(of.closed), int(of.polynomial), 0], [mpq(0), mpq(0), mpq(plane)]
            kind, name = SPLINE, f"CURVE{i}"
        weights = [mpq(1) if of.polynomial else weight for _, weight in points]
        coordinates = [x for point, _ in points for x in point]
        reals = [*(t for knots in spline.knots for t in knots), *weights, *coordinates, *domain, *normal]
        values = [*(count - 1 for count in spline.counts), *spline.degrees, *flags]
        entities.append((kind, 0, 0, name, [*map(str, values), *(with_point(numbers(x)) for x in reals)]))
    what = "Surfaces" if splines[0].is_surface else "Curves"
    return formatted(entities, f"{what} written by exactspline: every number is exact unless rounding was asked for.")


FORMAT = Format("iges", "IGES text", (".igs", ".iges"), _looks_like, _read, _write, surfaces=True)
