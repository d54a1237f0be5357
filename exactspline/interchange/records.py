"""The results of readers: named curves, and the names of what was skipped."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple

from exactspline.errors import CurveFileError, counted
from exactspline.interchange.limits import Limits
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface

if TYPE_CHECKING:
    from exactspline.interchange.numbers import NumberText


@dataclass(frozen=True)
class NamedCurve:
    """A curve with its name in a file, and notes on what its format says beyond a `Nurbs`."""

    name: str
    curve: Nurbs
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Skipped:
    """Something in a file that is not read: what it is, where it is, why it is skipped, and whether a curve is missing
    from the reading because of it (not for surfaces, texts, or definitions that are not drawn).
    """

    what: str
    where: str
    why: str
    curve: bool = True

    def __str__(self) -> str:
        return f"{self.where}: {self.what} skipped, {self.why}"


@dataclass(frozen=True)
class Reading:
    """The curves of a file in their order, its surfaces (of our JSON), what was skipped, and notes on what the file
    says of all of them (a unit of length, say).
    """

    format: str
    curves: tuple[NamedCurve, ...]
    skipped: tuple[Skipped, ...] = ()
    notes: tuple[str, ...] = ()
    surfaces: tuple[NurbsSurface, ...] = ()

    @property
    def curve(self) -> Nurbs:
        """The only curve; `CurveFileError` where there are none or several."""
        if len(self.curves) != 1:
            raise self._not_one(len(self.curves), "curve", ".curves")
        return self.curves[0].curve

    @property
    def surface(self) -> NurbsSurface:
        """The only surface; `CurveFileError` where there are none or several."""
        if len(self.surfaces) != 1:
            raise self._not_one(len(self.surfaces), "surface", ".surfaces")
        return self.surfaces[0]

    def _not_one(self, count: int, what: str, all_of_them: str) -> CurveFileError:
        if count or not self.skipped:
            return CurveFileError(f"{counted(count, what)}, where one is wanted", remedy=f"take {all_of_them}")
        first = self.skipped[0]
        return CurveFileError(f"the {first.what} is skipped: {first.why}", where=first.where, remedy="correct the file")

    def __repr__(self) -> str:
        parts = [counted(len(self.curves), "curve")] if self.curves or not self.surfaces else []
        parts += [counted(len(self.surfaces), "surface")] if self.surfaces else []
        parts += [f"{len(self.skipped)} skipped"] if self.skipped else []
        return f"<Reading of {self.format}: {', '.join(parts)}>"

    @property
    def complete(self) -> bool:
        """Whether no curve of the file was left out."""
        return not any(skipped.curve for skipped in self.skipped)


class Piece(NamedTuple):
    """A part of what a file holds, in the order of the file, and how much of the file is done with it."""

    reading: Reading
    done: int
    total: int


@dataclass(frozen=True)
class Source:
    """The input of a reader: the bytes, the name of the file, the part asked for (a glyph), and, for formats that hold
    control points alone, degree and knots.
    """

    data: bytes
    name: str = ""
    part: str = ""
    degree: int | None = None
    knots: tuple[str, ...] | None = None
    limits: Limits = field(default_factory=Limits)

    @property
    def text(self) -> str:
        """The bytes as UTF-8 text (a byte order mark dropped), or, where they are not, as Latin-1: numbers and keywords
        are ASCII in every format.
        """
        try:
            return self.data.decode("utf-8-sig")
        except UnicodeDecodeError:
            return self.data.decode("latin-1")


@dataclass(frozen=True)
class Format:
    """A file format: its name, a title, the suffixes of its files, how its beginning is recognized, its reader and its
    writer, and what every curve written loses; where files are large, also a reader of one piece after the other.
    """

    name: str
    title: str
    suffixes: tuple[str, ...]
    looks_like: Callable[[bytes], bool]
    read: Callable[[Source], Reading]
    write: Callable[[Sequence[NamedCurve], NumberText], bytes] | None = None
    loses: str = ""
    pieces: Callable[[Source], Iterator[Piece]] | None = None
