"""What is known of a file format."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from exactspline.interchange.numbers import NumberText
from exactspline.interchange.records import Piece, Reading, Source
from exactspline.interchange.writing import Spline
from exactspline.one_line import OneLine


@dataclass(frozen=True, repr=False)
class Format(OneLine):
    """A file format: its name, its title, the suffixes of its files, a function that recognizes the beginning of a
    file, its reader and writer, and a note on what is lost in writing; for formats with large files, also a reader that
    yields piece after piece; whether surfaces are written, too, and whether parts can be named, as a glyph of a font.
    """

    name: str
    title: str
    suffixes: tuple[str, ...]
    looks_like: Callable[[bytes], bool]
    read: Callable[[Source], Reading]
    write: Callable[[Sequence[Spline], NumberText], bytes] | None = None
    loses: str = ""
    pieces: Callable[[Source], Iterator[Piece]] | None = None
    surfaces: bool = False
    parts: bool = False
