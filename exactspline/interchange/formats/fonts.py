"""TrueType and CFF outlines, read with fontTools (the extra `formats`): one curve per contour, in font units.

fontTools returns the numbers of the file without rounding: integers and, for components and CFF fractions, dyadic
rationals that are exact as doubles. A TrueType contour becomes one quadratic B-spline: simple knots within a run of
off-curve points, double knots at on-curve points. A CFF contour becomes one cubic with triple knots. For a variable
font the default instance is read. Components are placed exactly; a glyph with a component placed by matching points is
skipped. All fonts of a collection (``.ttc``) are read; the names of curves from the second font begin with ``2/``, and
``fonts.ttc:2/A`` is a glyph of the second font.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from io import BytesIO
from typing import TYPE_CHECKING, Any

from exactspline.errors import CurveFileError, ExactSplineError, ShapeError, counted
from exactspline.interchange.collector import Collector
from exactspline.interchange.format import Format
from exactspline.interchange.numbers import exact
from exactspline.interchange.pens import ContourPen
from exactspline.interchange.records import Piece, Reading, Source
from exactspline.numbers.exact import mpq

if TYPE_CHECKING:
    from fontTools.ttLib import TTFont

MAGIC = (b"\0\1\0\0", b"OTTO", b"true", b"ttcf")
SCALED_OFFSET, OVERLAP_COMPOUND, OVERLAP_SIMPLE = 0x0800, 0x0400, 0x40
#: Tables other than `glyf` and `CFF ` that hold outlines.
OTHER_OUTLINES = ("VARC", "SVG ", "COLR", "CBDT", "sbix", "EBDT")


def _looks_like(head: bytes) -> bool:
    """Whether a file begins with the signature of a TrueType or OpenType font."""
    return head[:4] in MAGIC


def read(source: Source) -> Reading:
    """The contours of the requested glyph (given by its name or its character), or of all glyphs."""
    readings = [piece.reading for piece in pieces(source)]
    curves = tuple(curve for reading in readings for curve in reading.curves)
    notes = tuple(dict.fromkeys(note for reading in readings for note in reading.notes))
    return Reading("font", curves, tuple(skipped for reading in readings for skipped in reading.skipped), notes)


def pieces(source: Source) -> Iterator[Piece]:
    """The contours that `read` returns, glyph by glyph."""
    collector = Collector("font", source)
    try:
        from fontTools.ttLib import TTFont
    except ImportError:
        raise CurveFileError("fontTools is not installed", remedy="pip install fonttools") from None
    requested = _requested([_opened(TTFont, source, number) for number in range(_count(source))], source.part)
    for number, (font, name) in enumerate(requested, 1):
        for note in font.notes:
            collector.note(note)
        _add(collector, font, name)
        yield Piece(collector.taken(), number, len(requested))


@dataclass
class _Font:
    """A font of a file: its tables, glyph names and outlines, the prefix of the names of its curves, notes on the font,
    and notes on each of its curves.
    """

    tables: TTFont
    names: list[str]
    glyphs: Any
    prefix: str
    notes: list[str]
    on_each: list[str]


def _count(source: Source) -> int:
    """The number of fonts that the header of the file declares."""
    if source.data[:4] != b"ttcf":
        return 1
    count = int.from_bytes(source.data[8:12], "big")
    if not 0 < count <= source.limits.objects or 12 + 4 * count > len(source.data):
        raise CurveFileError(f"a collection of {counted(count, 'font')}", remedy="repair the font")
    return count


def _opened(reader: type[TTFont], source: Source, number: int) -> _Font:
    try:
        font = reader(BytesIO(source.data), lazy=True, fontNumber=number)
        names = list(font.getGlyphOrder())
        glyphs = font["glyf"] if "glyf" in font else font.getGlyphSet()
        em = font["head"].unitsPerEm if "head" in font else None
        other = [tag for tag in OTHER_OUTLINES if tag in font]
    except ExactSplineError:
        raise
    # a damaged font may raise any exception
    except Exception as error:
        raise _damaged(error) from None
    notes = [f"in font units, {em} per em"] if em else []
    notes += [f"outlines in the table {tag.strip()} are not read" for tag in other]
    on_each = ["the default instance of a variable font"] if "fvar" in font else []
    return _Font(font, names, glyphs, f"{number + 1}/" if number else "", notes, on_each)


def _damaged(error: Exception) -> CurveFileError:
    return CurveFileError(f"is not a readable font ({type(error).__name__})", remedy="repair the font")


def _requested(fonts: Sequence[_Font], part: str) -> list[tuple[_Font, str]]:
    """The glyphs to read, each with its font."""
    if not part:
        return [(font, name) for font in fonts for name in font.names]
    try:
        requested = [(font, name) for font in fonts if (name := _named(font, part)) is not None]
    # a damaged font may raise any exception
    except Exception as error:
        raise _damaged(error) from None
    if not requested:
        some = ", ".join(fonts[0].names[:5])
        raise CurveFileError(f"there is no glyph called {part[:40]!r}", remedy=f"the glyphs are {some}, …")
    return requested


def _add(collector: Collector, font: _Font, name: str) -> None:
    """The contours of one glyph."""
    glyph, notes = f"{font.prefix}{name}", list(font.on_each)
    with collector.skipping("glyph", glyph, damaged="its outline is damaged"):
        contours = _Glyph(collector, font.glyphs, name).drawn()
        notes += ["marked: contours may overlap"] if _overlaps(font.glyphs, name) else []
        for i, (degree, knots, points) in enumerate(contours, 1):
            where = f"glyph {glyph}, contour {i}"
            collector.add("contour", where, degree, knots, points, name=f"{glyph}.{i}", notes=notes)


def _overlaps(glyphs: Any, name: str) -> bool:
    """Whether a TrueType glyph is marked as having overlapping contours, by the flag of its first point or first
    component.
    """
    if not hasattr(glyphs, "glyphOrder"):
        return False
    glyph = glyphs[name]
    if glyph.isComposite():
        return bool(glyph.components and glyph.components[0].flags & OVERLAP_COMPOUND)
    return bool(glyph.numberOfContours and glyph.flags[0] & OVERLAP_SIMPLE)


def _named(font: _Font, part: str) -> str | None:
    """The name of the glyph with this name or for this character in this font, or None."""
    if font.prefix and part.startswith(font.prefix):
        part = part[len(font.prefix) :]
    if part in font.names:
        return part
    name = (font.tables.getBestCmap() or {}).get(ord(part)) if len(part) == 1 else None
    return None if name is None else str(name)


class _Glyph:
    """A glyph and its components, drawn from the tables without the shift by the left side bearing."""

    def __init__(self, collector: Collector, glyphs: Any, name: str) -> None:
        self.collector, self.glyphs, self.name = collector, glyphs, name

    def drawn(self) -> list[tuple[int, list[mpq], list[tuple[mpq, ...]]]]:
        """Degree, knots and points of the contours."""
        pen = ContourPen(self.collector.limits.objects)
        if not hasattr(self.glyphs, "glyphOrder"):
            self.glyphs[self.name].draw(pen)
            return pen.contours
        self._place(pen, self.name, (1, 0, 0, 1, 0, 0), 0)
        return pen.contours

    def _place(self, pen: ContourPen, name: str, placed: Sequence[mpq | int], depth: int) -> None:
        self.collector.count(1)
        if depth > self.collector.limits.depth:
            raise ShapeError("components are nested too deeply", remedy="a glyph must not contain itself")
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


FORMAT = Format(
    "font", "TrueType and CFF outlines", (".ttf", ".otf", ".ttc"), _looks_like, read, pieces=pieces, parts=True
)
