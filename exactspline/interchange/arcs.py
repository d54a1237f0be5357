"""Arcs of circles and ellipses between ends that a file gives as angles, or as points.

Of angles only multiples of a right angle have a sine and a cosine that are exactly known. Where an error is allowed,
any other end is moved along the curve, which itself stays exact, to a rational point of it.
"""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb, ctx

from exactspline.errors import ShapeError
from exactspline.interchange.affine import APPROXIMATE, Affine, dot, minus
from exactspline.interchange.numbers import about, dyadic, root_below, square_root
from exactspline.interchange.segments import Point, Segment, arc_around_origin, mapped
from exactspline.numbers.exact import mpq, rational, text, to_fmpq
from exactspline.numbers.intervals import ball_ends

ZERO = mpq(0)
#: A right angle in degrees and in radians, these to 80 digits: more than any decimal in a file has.
DEGREES = mpq(90)
RADIANS = rational("1.57079632679489661923132169163975144209858469968755291048747229615390820314310449")
#: The directions of the first four multiples of a right angle.
RIGHT = [(mpq(1), mpq(0)), (mpq(0), mpq(1)), (mpq(-1), mpq(0)), (mpq(0), mpq(-1))]


def quarter_turns(angle: mpq, right: mpq, digit: mpq = ZERO) -> int | None:
    """The number of right angles in an angle of which the last digit is worth `digit`, None where it is not an
    integer: the angle must be a multiple of a right angle rounded, up or down, to that digit, or to a double.

    >>> quarter_turns(mpq("6.2831853"), RADIANS, mpq("1e-7")), quarter_turns(mpq("-90.00000000000001"), DEGREES)
    (4, -1)
    >>> quarter_turns(mpq("89.9999999"), DEGREES, mpq("1e-7"))
    """
    turns = int((angle / right + mpq(1, 2)) // 1)
    exact = turns * right
    written = {exact // digit * digit, -(-exact // digit) * digit} if 0 < digit <= mpq(1, 10_000) else set()
    near = abs(angle - exact) <= max(abs(exact), right) / 2**50
    return turns if near or angle in written else None


def turn_near(angle: mpq, right: mpq, error: mpq) -> Point:
    """The cosine and sine, both rational, of an angle that differs from one by at most this many radians.

    >>> cosine, sine = turn_near(mpq(120), DEGREES, mpq(1, 1000))
    >>> cosine**2 + sine**2 == 1, abs(cosine + mpq(1, 2)) < mpq(1, 1000)
    (True, True)
    """
    bits = 64
    while True:
        with ctx.workprec(bits):
            turned = arb(to_fmpq(angle)) if right == RADIANS else arb.pi() * arb(to_fmpq(angle / (2 * right)))
            x, y = ball_ends(turned.cos()), ball_ends(turned.sin())
        if x.width + y.width < min(error, mpq(1)) / 8:
            return on_circle(x.low, y.low, error / 2)
        bits *= 2


def on_circle(x: mpq, y: mpq, error: mpq) -> Point:
    """The rational point of the unit circle in the direction of (x, y); where there is none, one whose direction
    differs from it by at most this many radians.

    >>> on_circle(mpq(3), mpq(-4), mpq(1)), on_circle(mpq(1), mpq(1), mpq(1, 100))
    ((mpq(3,5), mpq(-4,5)), (mpq(13575,19193), mpq(13568,19193)))
    """
    if not x or abs(y) > x:
        cosine, sine = on_circle(y, -x, error)
        return -sine, cosine
    square = x * x + y * y
    length = square_root(square)
    if length is not None:
        return x / length, y / length
    # the tangent of half the angle is off by at most a quarter of the error, twice: by the root, and rounded
    t = dyadic(y / (x + root_below(square, min(error, mpq(1)) * x / 4)), error / 4)
    return (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)


class Round:
    """The image of the unit circle under a map that keeps its two axes perpendicular, its arcs, and notes on them.

    >>> circle = Round(Affine([[2, 0, 0], [0, 2, 0]]), mpq(1, 100))
    >>> [arc] = circle.arc(circle.at_angle(mpq(30), DEGREES), circle.at_angle(mpq(90), DEGREES))
    >>> arc[-1], *circle.notes
    ((mpq(0,1), mpq(2,1), mpq(1,1)), 'its ends are moved along the curve by at most 1/100')
    """

    def __init__(self, frame: Affine, within: mpq | None, near: bool = False) -> None:
        if not all(map(any, list(zip(*frame.rows, strict=True))[:-1])):
            raise ShapeError("a circle or an ellipse of radius 0", remedy="its radius must be positive")
        self.frame, self.within = frame, within
        #: The note where the axes are irrational, and the map is only near to the one that is meant.
        self.notes = [f"its axes are irrational: it is read within {text(within)} of it"] if within and near else []
        #: By what angle an end may have been turned.
        self.turned = ZERO
        #: By what angle an end may be turned.
        self.error = None if within is None else within / (2 * frame.stretch)

    def at_angle(self, angle: mpq, right: mpq, digit: mpq = ZERO) -> Point:
        """The point of the unit circle at an angle (see `quarter_turns`)."""
        turns = quarter_turns(angle, right, digit)
        if turns is not None:
            if angle != turns * right:
                self.notes.append("an angle is read as the multiple of 90° of which it is a rounding")
            return RIGHT[turns % 4]
        if self.error is None:
            raise ShapeError("an angle that is not a multiple of 90°", remedy=f"its ends are irrational; {APPROXIMATE}")
        self.turned = max(self.turned, self.error)
        self.notes.append(f"its ends are moved along the curve by at most {text(self.within or mpq(0))}")
        return turn_near(angle, right, self.error)

    def at_point(self, point: Sequence[mpq], reach: mpq | None = None) -> Point:
        """The point of the unit circle whose image is a point, or is near to it: by default, within the error."""
        *columns, centre = zip(*self.frame.rows, strict=True)
        away = minus(point, centre)
        x, y = (dot(away, column) / dot(column, column) for column in columns)
        if x * x + y * y == 1 and self.frame((x, y)) == tuple(point):
            return x, y
        if self.error is None:
            raise ShapeError("an end that is not exactly on the curve", remedy=f"correct it; {APPROXIMATE}")
        found = on_circle(x, y, self.error / 2**16) if x or y else RIGHT[0]
        self.notes.append(moved(self.frame(found), point, reach or self.within))
        self.turned = max(self.turned, (reach or self.within or ZERO) / (2 * self.frame.stretch))
        return found

    def arc(self, start: Point, end: Point) -> list[Segment]:
        """The arc counter-clockwise between two points of the unit circle, the whole curve where they are the same."""
        gap = minus(start, end)
        if dot(gap, gap) < 16 * self.turned**2:
            raise ShapeError("the ends are nearer to each other than E", remedy="give a smaller --approximate E")
        return mapped(arc_around_origin(start, end), self.frame)


def through_ends(
    form: Sequence[mpq], start: Point, end: Point, within: mpq | None, notes: list[str]
) -> tuple[Sequence[mpq], Point]:
    """The ellipse about the same centre, given by its equation (see `conic_arc`), that passes through the start of an
    arc, and the end of the arc moved onto it, both by at most half of an error. Another conic stays as it is,
    and every one without an error.

    >>> form, notes = [mpq(1), mpq(0), mpq(1), mpq(0), mpq(0), mpq(-24, 25)], []
    >>> form, end = through_ends(form, (mpq(1), mpq(0)), (mpq(0), mpq(99, 100)), mpq(1, 5), notes)
    >>> form[-1], end[0] ** 2 + end[1] ** 2 == 1, notes[1:]
    (mpq(-1,1), True, ['an end is moved by 0.0141 onto the curve'])

    Raises `ShapeError` where they are further away.
    """
    (a, b, c, d, e, f), w = form, [q - p for p, q in zip(start, end, strict=True)]
    determinant = 4 * a * c - b * b
    if within is None or determinant <= 0:
        return form, end

    def value(x: mpq, y: mpq) -> mpq:
        return (a * x + b * y + d) * x + (c * y + e) * y

    centre = (b * e - 2 * c * d) / determinant, (b * d - 2 * a * e) / determinant
    level, size = -value(*start), -value(*centre) - f
    # its points move away from the centre in proportion; the squared half axis is at most 4 (a + c) size / determinant
    if not size or not 0 <= 16 * (f - level) ** 2 * (a + c) / (size * determinant) <= within**2:
        raise ShapeError("a start of an arc that is not near its ellipse", remedy=f"correct it; {APPROXIMATE}")
    notes += [f"the ellipse is moved by at most {text(within / 2)} onto its start"] if f != level else []
    if any(w):
        # the other point of the line through both ends
        (x, y), square = start, value(*w) - d * w[0] - e * w[1]
        t = 1 - (value(x + w[0], y + w[1]) - value(x, y)) / square
        found = (x + t * w[0], y + t * w[1])
        notes += [moved(found, end, within / 2)] if found != tuple(end) else []
        end = found
    return [a, b, c, d, e, level], end


def moved(to: Sequence[mpq], point: Sequence[mpq], within: mpq | None, onto: str = "the curve") -> str:
    """A note on an end that is moved onto a curve; raises `ShapeError` where that is further than allowed."""
    gap = minus(to, point)
    if within is None or dot(gap, gap) > within**2:
        raise ShapeError(f"an end {distance_text(gap)} away from {onto}", remedy=f"correct it; {APPROXIMATE}")
    return f"an end is moved by {distance_text(gap)} onto {onto}"


def distance_text(gap: Sequence[mpq]) -> str:
    """The length of a vector, to three digits."""
    square = dot(gap, gap)
    return about(root_below(square, square / (1 + square) / 10_000)) if square else "0"
