"""TrueType and CFF outlines by fontTools (the extra `fonts`): one curve per contour, in font units.

fontTools gives the numbers of the file unrounded: integers, and for components and CFF fractions exact dyadic doubles.
A TrueType contour becomes one quadratic B-spline: simple knots within a run of off-curve points, double knots at
on-curve points; a CFF contour one cubic with triple knots. Of a variable font the default instance is read. Components
are placed exactly; one placed by matching points is skipped.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from io import BytesIO
from typing import TYPE_CHECKING, Any

from exactspline.errors import CurveFileError, ExactSplineError, ShapeError
from exactspline.exact import mpq
from exactspline.interchange.bridges.fonttools import ContourPen
from exactspline.interchange.bridges.values import exact
from exactspline.interchange.collector import Collector
from exactspline.interchange.records import Format, Piece, Reading, Source

if TYPE_CHECKING:
    from fontTools.ttLib import TTFont

MAGIC = (b"\0\1\0\0", b"OTTO", b"true", b"ttcf")
SCALED_OFFSET = 0x0800


def looks_like(head: bytes) -> bool:
    """Whether a file begins as a TrueType or OpenType font does."""
    return head[:4] in MAGIC


def read(source: Source) -> Reading:
    """The contours of the glyph asked for (by its name or its character), or of all glyphs."""
    found = [piece.reading for piece in pieces(source)]
    curves = tuple(curve for reading in found for curve in reading.curves)
    return Reading("font", curves, tuple(skipped for reading in found for skipped in reading.skipped))


def pieces(source: Source) -> Iterator[Piece]:
    """The same, one glyph after the other."""
    found = Collector("font", source)
    try:
        from fontTools.ttLib import TTFont
    except ImportError:
        raise CurveFileError("fontTools is not installed", remedy="pip install 'exactspline[fonts]'") from None
    try:
        font = TTFont(BytesIO(source.data), lazy=True, fontNumber=0)
        names = list(font.getGlyphOrder())
        wanted = [_named(font, names, source.part)] if source.part else names
        notes = ["the default instance of a variable font"] if "fvar" in font else []
        glyphs = font["glyf"] if "glyf" in font else font.getGlyphSet()
    except ExactSplineError:
        raise
    # a damaged font may raise any exception
    except Exception as error:
        raise CurveFileError(
            f"is not a font that can be read ({type(error).__name__})", remedy="repair the font"
        ) from None
    for number, name in enumerate(wanted, 1):
        _add(found, glyphs, name, notes)
        yield Piece(found.taken(), number, len(wanted))


def _add(found: Collector, glyphs: Any, name: str, notes: Sequence[str]) -> None:
    """The contours of one glyph."""
    try:
        contours = _Glyph(found, glyphs, name).drawn()
    except ExactSplineError as error:
        found.skip("glyph", name, str(error))
        return
    except Exception as error:
        found.skip("glyph", name, f"its outline is damaged ({type(error).__name__})")
        return
    for i, (degree, knots, points) in enumerate(contours, 1):
        found.add("contour", f"glyph {name}, contour {i}", degree, knots, points, name=f"{name}.{i}", notes=notes)


def _named(font: TTFont, names: Sequence[str], part: str) -> str:
    if part in names:
        return part
    if len(part) == 1 and (name := (font.getBestCmap() or {}).get(ord(part))):
        return str(name)
    raise CurveFileError(f"there is no glyph called {part[:40]!r}", remedy=f"there are {', '.join(names[:5])}, …")


class _Glyph:
    """A glyph and its components, drawn from the tables without the shift by the left side bearing."""

    def __init__(self, found: Collector, glyphs: Any, name: str) -> None:
        self.found, self.glyphs, self.name = found, glyphs, name

    def drawn(self) -> list[tuple[int, list[mpq], list[tuple[mpq, ...]]]]:
        """Degree, knots and points of the contours."""
        pen = ContourPen(self.found.limits.objects)
        if not hasattr(self.glyphs, "glyphOrder"):
            self.glyphs[self.name].draw(pen)
            return pen.contours
        self._place(pen, self.name, (1, 0, 0, 1, 0, 0), 0)
        return pen.contours

    def _place(self, pen: ContourPen, name: str, placed: Sequence[mpq | int], depth: int) -> None:
        self.found.count(1)
        if depth > self.found.limits.depth:
            raise ShapeError("components are nested too deep", remedy="a glyph must not contain itself")
        glyph = self.glyphs[name]
        if not glyph.isComposite():
            pen.placed = tuple(map(mpq, placed))
            glyph.draw(pen, self.glyphs)
            return
        for component in glyph.components:
            if hasattr(component, "firstPt"):
                raise ShapeError("a component placed by matching points", remedy="decompose the glyph")
            inner_name, numbers = component.getComponentInfo()
            a, b, c, d, x, y = map(exact, numbers)
            if component.flags & SCALED_OFFSET and not (a == d == 1 and b == c == 0):
                raise ShapeError("a component with a scaled offset", remedy="decompose the glyph")
            p, q, r, s, u, v = placed
            inner = (p * a + r * b, q * a + s * b, p * c + r * d, q * c + s * d, p * x + r * y + u, q * x + s * y + v)
            self._place(pen, inner_name, inner, depth + 1)


FORMAT = Format("font", "TrueType and CFF outlines", (".ttf", ".otf", ".ttc"), looks_like, read, pieces=pieces)
