"""The transform attribute of SVG and the point about which it acts, and lengths, exactly."""

from __future__ import annotations

import re
from collections.abc import Mapping

from exactspline.errors import NumberError, ShapeError, counted
from exactspline.interchange.affine import Affine
from exactspline.interchange.arcs import DEGREES, RIGHT, quarter_turns
from exactspline.interchange.limits import Limits
from exactspline.interchange.numbers import decimal
from exactspline.interchange.svg_names import NAMES
from exactspline.numbers.exact import mpq

_CALL = re.compile(r"[\s,]*([A-Za-z]+)\s*\(([^()]*)\)")


#: CSS pixels per unit of length (CSS Values and Units, absolute lengths).
UNITS = {unit: mpq(pixels) for unit, pixels in NAMES["units"].items()}
#: What can be done about a transform of which no number is rational.
APPLY = "write it as matrix(…), whose decimals are read exactly, or apply it to the shape"
_SIDES = {"left": "0", "top": "0"}
_LENGTH = re.compile(r"(.*?)(px|in|cm|mm|q|pt|pc)?", re.ASCII | re.IGNORECASE | re.DOTALL)


def length(text: str, limits: Limits) -> mpq:
    """A length in user units.

    >>> length("2.5", Limits()), length("1in", Limits()), length("25.4mm", Limits())
    (mpq(5,2), mpq(96,1), mpq(96,1))

    Raises `NumberError` for anything else, such as percentages and lengths relative to a font size.
    """
    match = _LENGTH.fullmatch(text.strip())
    assert match is not None
    return decimal(match[1], limits) * UNITS[(match[2] or "px").lower()]


def about(matrix: Affine, attributes: Mapping[str, str], style: Mapping[str, str], limits: Limits) -> Affine:
    """A transform about the point that `transform-origin` names, in the coordinates of the nearest viewport.

    >>> about(transform("scale(2)", Limits()), {"transform-origin": "5 1in"}, {}, Limits())((5, 0))
    (mpq(5,1), mpq(-96,1))

    Raises `ShapeError` if the point depends on a box: that of the viewport (percentages) or of the shape.
    """
    given = style.get("transform-origin", attributes.get("transform-origin", "")).lower()
    box = style.get("transform-box", attributes.get("transform-box", "view-box")).strip().lower()
    words = [_SIDES.get(word, word) for word in given.split()]
    if not words:
        return matrix
    try:
        if box != "view-box" or not 2 <= len(words) <= 3:
            raise NumberError("a box is required")
        if "transform-origin" in style and any(word.strip("+-.0") and not word[-1].isalpha() for word in words):
            raise NumberError("CSS has no lengths without a unit")
        x, y = (length(word, limits) for word in words[:2])
    except NumberError:
        problem = f"the transform-origin {given[:40]!r} in the transform-box {box[:20]!r}"
        raise ShapeError(problem, remedy="give two lengths in the view-box") from None
    there, back = (Affine([[1, 0, sign * x], [0, 1, sign * y]]) for sign in (1, -1))
    return there @ matrix @ back


def transform(text: str, limits: Limits) -> Affine:
    """The map described by a transform attribute; the leftmost transform is applied last.

    >>> transform("translate(1) rotate(90)", Limits())((2, 0))
    (mpq(1,1), mpq(2,1))

    Raises `NumberError` for angles with an irrational sine, cosine or tangent, and `ShapeError` for text that is not a
    transform.
    """
    whole = Affine.identity(2)
    position, calls = 0, 0
    while match := _CALL.match(text, position):
        position, calls = match.end(), calls + 1
        if calls > limits.depth:
            raise ShapeError("too many transforms", remedy="combine them into one matrix")
        numbers = [decimal(word, limits) for word in re.sub(r"\s*,\s*|\s+", " ", match[2]).split()]
        whole = whole @ _one(match[1], numbers)
    if text[position:].strip(" \t\r\n,"):
        raise ShapeError(f"{text[position : position + 20]!r} is not a transform", remedy="write translate(…), …")
    return whole


def _one(name: str, n: list[mpq]) -> Affine:
    if name == "matrix" and len(n) == 6:
        return Affine([n[0::2], n[1::2]])
    if name == "translate" and len(n) in (1, 2):
        return Affine([[1, 0, n[0]], [0, 1, n[1] if n[1:] else 0]])
    if name == "scale" and len(n) in (1, 2):
        return Affine([[n[0], 0, 0], [0, n[-1], 0]])
    if name == "rotate" and len(n) in (1, 3):
        turns = quarter_turns(n[0], DEGREES)
        if turns is None:
            raise NumberError("an angle that is not a multiple of 90°", remedy=APPLY)
        cosine, sine = RIGHT[turns % 4]
        turn = Affine([[cosine, -sine, 0], [sine, cosine, 0]])
        there, back = (Affine([[1, 0, s * x], [0, 1, s * y]]) for s in (1, -1) for x, y in [n[1:] or (0, 0)])
        return there @ turn @ back
    if name in ("skewX", "skewY") and len(n) == 1:
        slope = _tangent(n[0])
        return Affine([[1, slope, 0], [0, 1, 0]] if name == "skewX" else [[1, 0, 0], [slope, 1, 0]])
    remedy = "matrix, translate, scale, rotate, skewX, skewY are read"
    raise ShapeError(f"{name[:20]} of {counted(len(n), 'number')}", remedy=remedy)


def _tangent(degrees: mpq) -> int:
    """The tangent of a multiple of 45 degrees: of rational angles in degrees, only these have a rational tangent."""
    eighths = degrees / 45
    if eighths.denominator != 1 or eighths % 4 == 2:
        raise NumberError("a skew whose tangent is not rational", remedy=APPLY)
    return (0, 1, 0, -1)[int(eighths % 4)]
