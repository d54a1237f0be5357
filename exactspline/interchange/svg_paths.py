"""The path data of SVG: ``M L H V C S Q T A Z``, absolute and relative, as exact segments."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from exactspline.errors import ExactSplineError, NumberError
from exactspline.interchange.numbers import decimal, root_below, square_root
from exactspline.interchange.records import Limits
from exactspline.interchange.segments import (
    APPROXIMATE,
    DEGREES,
    Affine,
    Segment,
    arc_around_origin,
    mapped,
    polynomial,
    quarter_turns,
    turn_near,
)
from exactspline.numbers.exact import mpq

Point = tuple[mpq, mpq]

_NUMBER = re.compile(r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?", re.ASCII)
_GAP = re.compile(r"[ \t\r\n\f]*,?[ \t\r\n\f]*")
_SPACE = re.compile(r"[ \t\r\n\f]*")
#: The number of arguments of each command.
_COUNTS = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "A": 7, "Z": 0}


@dataclass
class Subpath:
    """Connected segments of a subpath, or the reason why an arc has no exact representation."""

    segments: list[Segment] = field(default_factory=list)
    problem: str = ""
    #: Whether an arc next to the segments is omitted, and whether an arc among them replaces another arc.
    divided: bool = False
    approximated: bool = False


class _Pen:
    """The state of a path."""

    def __init__(self, within: mpq | None) -> None:
        self.within = within
        self.at: Point = (mpq(0), mpq(0))
        self.start = self.at
        self.control: Point | None = None
        self.degree = 0
        self.parts: list[Subpath] = []

    def draw(self, *points: Point) -> None:
        """Append the Bézier segment from the current point with these further control points."""
        self.parts[-1].segments.append(polynomial(self.at, *points))
        self.control, self.degree = (points[-2] if len(points) > 1 else None), len(points)
        self.at = points[-1]

    def mirrored(self, degree: int) -> Point:
        """The reflection in the current point of the last inner control point, if the previous command drew a segment
        of this degree; otherwise the current point.
        """
        if self.control is None or self.degree != degree:
            return self.at
        return (2 * self.at[0] - self.control[0], 2 * self.at[1] - self.control[1])

    def arc(self, radii: Point, degrees: mpq, large: bool, sweep: bool, end: Point) -> None:
        """Append an elliptic arc to `end`."""
        start, self.control, self.at = self.at, None, end
        if start == end:
            return
        if not all(radii):
            self.parts[-1].segments.append(polynomial(start, end))
            return
        try:
            try:
                self.parts[-1].segments += elliptic_arc(start, end, radii, degrees, large, sweep)
            except NumberError:
                if self.within is None:
                    raise
                self.parts[-1].segments += elliptic_arc(start, end, radii, degrees, large, sweep, self.within)
                self.parts[-1].approximated = True
        except ExactSplineError as error:
            self.parts[-1].divided = True
            self.parts += [Subpath(problem=f"an arc: {error}"), Subpath(divided=True)]


def elliptic_arc(
    start: Point, end: Point, radii: Point, degrees: mpq, large: bool, sweep: bool, within: mpq | None = None
) -> list[Segment]:
    """The arc described by the command A; radii that are too small are scaled up, as the standard requires. If its
    centre is irrational and `within` is given, an arc with the same ends within that distance.

    In units of the radii both arcs are parts of circles through the ends, whose centres are δ apart on the bisector of
    the ends. Their radii differ by at most δ, so points in the same direction from their centres are at most 2 δ apart;
    where one arc ends before that direction, its end is at most π δ / 2 away. An ellipse whose axes are not those of
    the plane is turned by a near angle of which sine and cosine are rational (see `_greatest_turn`).

    >>> one, zero = mpq(1), mpq(0)
    >>> [len(elliptic_arc((one, zero), (zero, one), (one, one), zero, large, True)) for large in (False, True)]
    [1, 3]

    Raises `NumberError` if the centre or the axes are irrational and no approximation is allowed.
    """
    if not sweep:
        return [segment[::-1] for segment in reversed(elliptic_arc(end, start, radii, degrees, large, True, within))]
    rx, ry = abs(radii[0]), abs(radii[1])
    turns = quarter_turns(degrees, DEGREES)
    if rx != ry and turns is None:
        if within is None:
            raise NumberError("its axes are rotated by an angle that is not a multiple of 90°", remedy=APPROXIMATE)
        return _turned_arc(start, end, (rx, ry), degrees, large, within)
    if turns and turns % 2:
        rx, ry = ry, rx
    # in units of the radii the ellipse is the unit circle, or a larger one where the radii are too small
    p, q = ((x / rx, y / ry) for x, y in (start, end))
    chord = (q[0] - p[0], q[1] - p[1])
    square = chord[0] ** 2 + chord[1] ** 2
    offset = square_root(1 / square - mpq(1, 4)) if square < 4 else mpq(0)
    if offset is None and within is not None:
        # δ is the error of the offset times the chord, which is shorter than 2
        offset = root_below(1 / square - mpq(1, 4), within / (4 * max(rx, ry)))
    if offset is None:
        raise NumberError("its centre is irrational", remedy=f"it has no rational control points; {APPROXIMATE}")
    side = -offset if large else offset
    centre = ((p[0] + q[0]) / 2 - side * chord[1], (p[1] + q[1]) / 2 + side * chord[0])
    arcs = arc_around_origin(*((x - centre[0], y - centre[1]) for x, y in (p, q)))
    return mapped(arcs, Affine([[rx, 0, rx * centre[0]], [0, ry, ry * centre[1]]]))


def _turned_arc(start: Point, end: Point, radii: Point, degrees: mpq, large: bool, within: mpq) -> list[Segment]:
    """An arc near that of a turned ellipse, counter-clockwise in the coordinates of the drawing."""
    cosine, sine = turn_near(degrees, DEGREES, _greatest_turn(start, end, radii, within / 2))
    turn, back = (Affine([[cosine, -s, 0], [s, cosine, 0]]) for s in (sine, -sine))
    first, last = ((x, y) for x, y in (back(point) for point in (start, end)))
    return mapped(elliptic_arc(first, last, radii, mpq(0), large, True, within / 2), turn)


def _greatest_turn(start: Point, end: Point, radii: Point, within: mpq) -> mpq:
    """The largest angle by which an ellipse may be rotated such that its arc between two points moves by at most a
    distance.

    In units of the radii R ≥ r, with the start as origin, a turn by η moves the chord w = M⁻¹ d, d being the chord of
    the drawing, by at most ε = |d| η / r. The radius of the circle is max(1, |w|/2), and its centre is at the distance
    h = √max(0, 1 − |w|²/4) from the middle of the chord. So the radius changes by at most ε/2, h by at most √ε, the
    direction of the bisector by at most 2 ε/|w| ≤ 2 η R/r, the centre by at most ε/2 + √ε + 2 η R/r: for ε ≤ 1 radius,
    centre and ends together by at most κ = 3 √ε + 2 η R/r. As for two circles through the same ends, no point is more
    than 3 κ from the other arc. The turn of the plane adds 2 ρ η, where ρ ≤ 1 + |d|/(2 r). The distance is at most R
    times the sum 9 √ε + (6 R/r + 2 + |d|/r) η, of which each part gets half.
    """
    far, near = max(radii), min(radii)
    chord = abs(end[0] - start[0]) + abs(end[1] - start[1])
    room = min(within / far, mpq(1))
    return min((room / 18) ** 2 * near / chord, room / 2 / (6 * far / near + 2 + chord / near))


_COMMAND = re.compile(r"[MLHVCSQTAZ][^MLHVCSQTAZ]*", re.IGNORECASE)
#: The degree of the segments of each command; for an arc a lower bound, that of a line.
_DEGREES = {"L": 1, "H": 1, "V": 1, "C": 3, "S": 3, "Q": 2, "T": 2, "A": 1}


def least_size(data: str) -> int:
    """A lower bound on the number of control points and knots of the curves in path data, assuming that the data have
    no error; nothing is built for it.

    >>> least_size("M0 0 1 1h1 1e0C1 2 3 4 5 6"), least_size("M0 0A1 1 0 012 2z")
    (12, 2)
    """
    total = 0
    for command in _COMMAND.finditer(data):
        text = command[0]
        letter = text[0].upper()
        numbers = len(_NUMBER.findall(text))
        if letter == "M":
            total += 2 * max(numbers // 2 - 1, 0)
        elif letter in _DEGREES:
            # the two flags of an arc may be followed by the next number without a separator
            total += 2 * _DEGREES[letter] * (numbers // (5 if letter == "A" else _COUNTS[letter]))
    return total


def subpaths(data: str, limits: Limits, within: mpq | None = None) -> tuple[list[Subpath], str]:
    """The subpaths of path data up to the first error, and a description of that error ("" if there is none). An arc
    that has no exact representation divides its subpath; with `within` it is replaced by an arc within that distance,
    if its axes allow that.

    >>> parts, problem = subpaths("M1 2h3v4zM0 0Q1 1 2 0T4 0#", Limits())
    >>> [len(part.segments) for part in parts], problem
    ([3, 2], "'#' at character 25 is not path data")
    """
    pen = _Pen(within)
    problem = _run(pen, data, limits)
    return [part for part in pen.parts if part.segments or part.problem], problem


def _run(pen: _Pen, data: str, limits: Limits) -> str:
    """Draw path data up to the first error; return its description."""
    position = _skipped(_SPACE, data, 0)
    while position < len(data):
        letter = data[position]
        if letter.upper() not in _COUNTS or not (pen.parts or letter in "Mm"):
            return f"{letter!r} at character {position} is not path data"
        following, first = _skipped(_SPACE, data, position + 1), True
        while first or (_COUNTS[letter.upper()] and _NUMBER.match(data, following)):
            numbers, position = _arguments(letter.upper(), data, following, limits)
            if numbers is None:
                return f"command {letter} is incomplete at character {position}"
            _step(pen, letter, numbers, first)
            following, first = _skipped(_GAP, data, position), False
        position = _skipped(_SPACE, data, position)
    return ""


def _skipped(pattern: re.Pattern[str], data: str, position: int) -> int:
    match = pattern.match(data, position)
    return match.end() if match else position


def _arguments(letter: str, data: str, position: int, limits: Limits) -> tuple[list[mpq] | None, int]:
    numbers = []
    for i in range(_COUNTS[letter]):
        if i:
            position = _skipped(_GAP, data, position)
        if letter == "A" and i in (3, 4):
            if data[position : position + 1] not in ("0", "1"):
                return None, position
            numbers.append(mpq(int(data[position])))
            position += 1
            continue
        match = _NUMBER.match(data, position)
        if not match:
            return None, position
        try:
            numbers.append(decimal(match[0], limits))
        except NumberError:
            return None, position
        position = match.end()
    return numbers, position


def _step(pen: _Pen, letter: str, n: list[mpq], first: bool) -> None:
    """Execute one command with its arguments; further pairs after M are lines."""
    command = letter.upper()
    x0, y0 = pen.at if letter.islower() else (mpq(0), mpq(0))
    if command == "M" and first:
        pen.at = pen.start = (n[0] + x0, n[1] + y0)
        pen.parts.append(Subpath())
        pen.control = None
        return
    if command == "Z":
        if pen.at != pen.start:
            pen.draw(pen.start)
        pen.parts.append(Subpath())
        pen.control = None
        return
    if command in "HV":
        pen.draw((n[0] + x0, pen.at[1]) if command == "H" else (pen.at[0], n[0] + y0))
        return
    if command == "A":
        pen.arc((n[0], n[1]), n[2], n[3] == 1, n[4] == 1, (n[5] + x0, n[6] + y0))
        return
    points = [(x + x0, y + y0) for x, y in zip(n[::2], n[1::2], strict=True)]
    if command in "ST":
        points.insert(0, pen.mirrored(3 if command == "S" else 2))
    pen.draw(*points)
