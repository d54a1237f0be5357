"""What a reader hands back: curves by name, and by name what it did not read."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from exactspline.interchange.limits import Limits
from exactspline.splines.nurbs import Nurbs

if TYPE_CHECKING:
    from exactspline.interchange.numbers import NumberText


@dataclass(frozen=True)
class NamedCurve:
    """A curve as a file names it, with notes on what its format says and a `Nurbs` does not."""

    name: str
    curve: Nurbs
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Skipped:
    """Something in a file that is not read: what it is, where it stands, why it is skipped."""

    what: str
    where: str
    why: str

    def __str__(self) -> str:
        return f"{self.where}: {self.what} skipped, {self.why}"


@dataclass(frozen=True)
class Reading:
    """The curves of a file in their order, and what was skipped."""

    format: str
    curves: tuple[NamedCurve, ...]
    skipped: tuple[Skipped, ...] = ()


@dataclass(frozen=True)
class Source:
    """What a reader is given: the bytes, the name of the file, the part asked for (a glyph), and, for formats that hold
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
    """A file format: its name, a title, the suffixes of its files, how its beginning is told, its reader and its
    writer, and what every curve written loses.
    """

    name: str
    title: str
    suffixes: tuple[str, ...]
    looks_like: Callable[[bytes], bool]
    read: Callable[[Source], Reading]
    write: Callable[[Sequence[NamedCurve], NumberText], bytes] | None = None
    loses: str = ""
