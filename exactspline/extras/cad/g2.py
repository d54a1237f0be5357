"""``.g2``, the text format of SISL and GoTools: a sequence of objects, each a header followed by numbers.

A curve (class 100) is ``dimension rational``, ``number order``, the full knot vector, the control points; points of a
rational curve are homogeneous, weight last. A surface (class 200) has ``number order`` and knots of u, then of v, and
its points along u first. Volumes, point and line clouds are skipped, as are objects of other classes, whose data are
taken to end at the next header.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from math import prod

from exactspline.extras.cad import NAMES
from exactspline.interchange.collector import Collector
from exactspline.interchange.format import Format, Spline
from exactspline.interchange.numbers import NumberText, Tokens
from exactspline.interchange.records import Reading, Source
from exactspline.numbers.exact import mpq

CURVE, SURFACE, POINTS, LINES, VOLUME = 100, 200, 400, 410, 700
#: Classes of curves that are not read.
OTHER_CURVES = (110, 120, 130, 140, 150, 160, 170)
_BEGINNING = re.compile(rb"\s*(\d+)\s+[01]\s+\d+\s+\d+\s")
_HEADER = re.compile(r"^[ \t]*([1-9]\d\d)[ \t]+([01])[ \t]+([09])[ \t]+(\d+)(?:[ \t]+\d+){0,4}[ \t]*\r?$", re.M)


def _looks_like(head: bytes) -> bool:
    """Whether a file begins with the header of a known class."""
    found = _BEGINNING.match(head)
    return found is not None and found[1].decode() in NAMES["g2"]


def _read(source: Source) -> Reading:
    """The spline curves and surfaces of a file."""
    collector = Collector("g2", source)
    text, words = source.text, Tokens(source.text, source.limits)
    number = 0
    while not words.ended:
        kind, _major, _minor = words.whole(), words.whole(), words.whole()
        number += 1
        where = f"object {number} (line {words.line})"
        words.numbers(words.count())
        if kind in (CURVE, SURFACE):
            _spline(collector, words, where, kind)
            continue
        collector.skip(NAMES["g2"].get(str(kind), f"class {kind}"), where, curve=kind in OTHER_CURVES)
        if kind == VOLUME:
            _net(words, 3)
        elif kind in (POINTS, LINES):
            words.rows(words.count(), 3 if kind == POINTS else 6)
        else:
            header = _HEADER.search(text, words.position + 1)
            words.move(header.start() if header else len(text))
    return collector.reading()


def _spline(collector: Collector, words: Tokens, where: str, kind: int) -> None:
    rational, sides, points = _net(words, 1 if kind == CURVE else 2)
    what = NAMES["g2"][str(kind)]
    with collector.skipping(what, where, curve=kind == CURVE):
        degrees, knots = [order - 1 for order, _ in sides], [knots for _, knots in sides]
        collector.add_spline(what, where, degrees, knots, points, homogeneous=rational)


def _net(words: Tokens, parameters: int) -> tuple[bool, list[tuple[int, list[mpq]]], list[list[mpq]]]:
    """Whether a spline is rational, the order and the knots of each direction, and the control points."""
    dimension, rational = words.count(), words.whole() != 0
    sides = []
    for _ in range(parameters):
        count, order = words.count(), words.count()
        sides.append((order, words.numbers(count + order)))
    return rational, sides, words.rows(prod(len(knots) - order for order, knots in sides), dimension + rational)


def _write(splines: Sequence[Spline], numbers: NumberText) -> bytes:
    """One object per curve or surface."""
    lines = []
    for spline in splines:
        rational, kind = int(not spline.polynomial), SURFACE if spline.is_surface else CURVE
        lines += [f"{kind} 1 0 0", f"{spline.dimension} {rational}"]
        for degree, knots, count in zip(spline.degrees, spline.knots, spline.counts, strict=True):
            lines += [f"{count} {degree + 1}", " ".join(map(numbers, knots))]
        lines += [*(" ".join(map(numbers, row)) for row in spline.rows()), ""]
    return "\n".join(lines).encode()


FORMAT = Format("g2", "SISL and GoTools text", (".g2",), _looks_like, _read, _write, surfaces=True)
