"""The transform attribute of SVG, exactly."""

from __future__ import annotations

import re

from exactspline.errors import NumberError, ShapeError
from exactspline.exact import mpq
from exactspline.interchange.affine import Affine
from exactspline.interchange.angles import quarter_turns_of_degrees
from exactspline.interchange.limits import Limits
from exactspline.interchange.numbers import decimal

_CALL = re.compile(r"[\s,]*([A-Za-z]+)\s*\(([^()]*)\)")
_TURNS = ((1, 0), (0, 1), (-1, 0), (0, -1))


def transform(text: str, limits: Limits) -> Affine:
    """The map that a transform attribute describes, the leftmost outermost.

    >>> transform("translate(1) rotate(90)", Limits())((2, 0))
    (mpq(1,1), mpq(2,1))

    Raises `NumberError` for angles whose sine, cosine or tangent is irrational, `ShapeError` for what is not a
    transform.
    """
    whole = Affine.identity(2)
    position, calls = 0, 0
    while match := _CALL.match(text, position):
        position, calls = match.end(), calls + 1
        if calls > limits.depth:
            raise ShapeError("too many transforms", remedy="multiply them out")
        numbers = [decimal(word, limits) for word in re.sub(r"\s*,\s*|\s+", " ", match[2]).split()]
        whole = whole @ _one(match[1], numbers)
    if text[position:].strip(" \t\r\n,"):
        raise ShapeError(
            f"{text[position : position + 20]!r} is not a transform", remedy="write translate(…) or the like"
        )
    return whole


def _one(name: str, n: list[mpq]) -> Affine:
    if name == "matrix" and len(n) == 6:
        return Affine([n[0::2], n[1::2]])
    if name == "translate" and len(n) in (1, 2):
        return Affine([[1, 0, n[0]], [0, 1, n[1] if n[1:] else 0]])
    if name == "scale" and len(n) in (1, 2):
        return Affine([[n[0], 0, 0], [0, n[-1], 0]])
    if name == "rotate" and len(n) in (1, 3):
        cosine, sine = _TURNS[quarter_turns_of_degrees(n[0]) % 4]
        turn = Affine([[cosine, -sine, 0], [sine, cosine, 0]])
        there, back = (Affine([[1, 0, s * x], [0, 1, s * y]]) for s in (1, -1) for x, y in [n[1:] or (0, 0)])
        return there @ turn @ back
    if name in ("skewX", "skewY") and len(n) == 1:
        slope = _tangent(n[0])
        return Affine([[1, slope, 0], [0, 1, 0]] if name == "skewX" else [[1, 0, 0], [slope, 1, 0]])
    raise ShapeError(
        f"{name[:20]} of {len(n)} numbers", remedy="matrix, translate, scale, rotate, skewX, skewY are read"
    )


def _tangent(degrees: mpq) -> int:
    """The tangent of a multiple of 45 degrees, the only rational ones."""
    eighths = degrees / 45
    if eighths.denominator != 1 or eighths % 4 == 2:
        raise NumberError("a skew whose tangent is not rational", remedy="multiples of 45 degrees are exact")
    return (0, 1, 0, -1)[int(eighths % 4)]
