"""All contours of the glyphs of two fonts against an oracle in fractions: corners, inflections, extrema, straight
pieces.

The fonts are those that matplotlib brings along; fontTools reads them.
"""

import os
from functools import cache
from pathlib import Path

import pytest

from exactspline import Nurbs, analyse
from tests.support.contour_oracle import Piece, features

pytest.importorskip("fontTools")
matplotlib = pytest.importorskip("matplotlib")

FONTS = ("cmr10.ttf", "cmss10.ttf")
#: Every this many contours of a font are looked at; EXACTSPLINE_ALL_CONTOURS=1 takes all.
EVERY = 1 if os.environ.get("EXACTSPLINE_ALL_CONTOURS") else 12


@cache
def contours(font):
    """The closed contours of all glyphs: glyph, number, and three points a piece."""
    from fontTools.pens.basePen import BasePen
    from fontTools.ttLib import TTFont

    class Pieces(BasePen):
        """Lines and parabolas, one list a contour."""

        def __init__(self, glyphs):
            super().__init__(glyphs)
            self.found = []

        def _moveTo(self, p):
            self.start = self.here = p
            self.found.append([])

        def _lineTo(self, p):
            if p != self.here:
                middle = tuple((a + b) / 2 for a, b in zip(self.here, p, strict=True))
                self.found[-1].append((self.here, middle, p))
            self.here = p

        def _qCurveToOne(self, q, p):
            self.found[-1].append((self.here, q, p))
            self.here = p

        def _closePath(self):
            self._lineTo(self.start)

    place = Path(matplotlib.get_data_path()) / "fonts" / "ttf" / font
    found = []
    with TTFont(place) as read:
        glyphs = read.getGlyphSet()
        for name in glyphs:
            pen = Pieces(glyphs)
            glyphs[name].draw(pen)
            found += [(f"{name} {i}", c) for i, c in enumerate(pen.found) if len(c) > 1]
    regular = [(name, c) for name, c in found if not any(Piece(p).singular() for p in c)]
    return [c for i, c in enumerate(regular) if i % EVERY == 0]


def curve_of(pieces):
    """A quadratic spline with double knots; the doubles of fontTools are taken for what they are."""
    count = len(pieces)
    points = [pieces[0][0], *[p for piece in pieces for p in piece[1:]]]
    knots = [0, *[t for t in range(count + 1) for _ in range(2)], count]
    return Nurbs(2, knots, [tuple(str(x) for x in p) for p in points])


def expected(pieces):
    return features([Piece(p) for p in pieces])


@pytest.mark.parametrize("font", FONTS)
def test_corners_inflections_and_extrema_of_all_contours(font):
    assert contours(font)
    for name, pieces in contours(font):
        curve, count = curve_of(pieces), len(pieces)
        corners, inflections, extrema, _ = expected(pieces)
        found = analyse(curve)
        assert [joint.parameter - curve.domain[0] for joint in analyse(curve).corners] == corners, name
        assert sorted(f.root.exact % count for f in found.inflections) == inflections, name
        told = sorted((_exact(f.root) % count, f.kind) for f in found.critical_points if f.kind != "stationary")
        assert told == extrema, name


def _exact(root):
    """The roots are rational: each parabola has one vertex."""
    assert len(root.minimal_polynomial()) == 2
    return root.exact


def test_straight_pieces_of_all_contours():
    differ = []
    for name, pieces in [c for font in FONTS for c in contours(font)]:
        found = [part for piece in analyse(curve_of(pieces)).straight_pieces for part in piece.parts]
        if sorted(found) != sorted(expected(pieces)[3]):
            differ.append(name)
    assert differ == []
