"""The results of readers: named curves, and records of skipped entities."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import groupby
from typing import NamedTuple

from exactspline.errors import CurveFileError, counted
from exactspline.numbers.exact import mpq
from exactspline.one_line import OneLine, one_line
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface

# ---- limits


#: The remedy for a file beyond the limits.
LARGER = "divide the file, or read it in Python with limits=Limits(…)"


@dataclass(frozen=True, repr=False)
class Limits(OneLine):
    """Limits on an input file. To raise a limit, write `read(…, limits=Limits(megabytes=200))`.

    `digits` limits the characters of a number, `exponent` the power of ten of a number, `depth` the nesting of brackets
    and elements, and `objects` the number of entities, points and numbers in the file. `work` limits the cost of
    converting one curve to Bézier segments (10⁸ is about two seconds). `seconds` limits the processor time per megabyte
    of a library that reads the file in another process (``3dm``).
    """

    megabytes: int = 32
    digits: int = 1_200
    exponent: int = 400
    depth: int = 60
    degree: int = 100
    objects: int = 2_000_000
    work: int = 50_000_000
    seconds: int = 2


def work(degree: int, knots: Sequence[mpq], numbers: int) -> int:
    """An estimate of the cost of converting a spline to Bézier segments: the number of knots to be inserted, times the
    fourth power of the order, times the length of the numbers in machine words.

    >>> work(3, [mpq(t) for t in (0, 0, 0, 0, 1, 1, 1, 1)], 53)
    1
    """
    if len(knots) < 2 * degree + 2:
        return 1
    inner = knots[degree : len(knots) - degree]
    missing = sum(max(degree - len(list(same)), 0) for _, same in groupby(inner[1:-1]))
    missing += sum(max(degree + 1 - sum(t == end for t in knots), 0) for end in (inner[0], inner[-1]))
    return max(missing * (degree + 1) ** 4 * max(numbers, 53) // 53, 1)


@dataclass(frozen=True, repr=False)
class NamedCurve(OneLine):
    """A curve of a file with its name, and notes on information that a `Nurbs` does not hold."""

    name: str
    curve: Nurbs
    notes: tuple[str, ...] = ()


@dataclass(frozen=True, repr=False)
class Skipped(OneLine):
    """An entity of a file that is not read: the type, the place in the file, the reason, whether a curve is missing as
    a result (not for a surface, a text, or a definition that is not drawn), and the numbers of curves and of surfaces
    that were read before the entity, in a font within the same glyph.
    """

    what: str
    where: str
    why: str
    curve: bool = True
    after: tuple[int, int] = (0, 0)

    def __str__(self) -> str:
        return f"{self.where}: {self.what} skipped, {self.why}"


@dataclass(frozen=True)
class Reading:
    """The contents of a file: the curves in their order, the surfaces (without trims), the skipped entities, and notes
    that apply to the whole file (such as the unit of length).
    """

    format: str
    curves: tuple[NamedCurve, ...]
    skipped: tuple[Skipped, ...] = ()
    notes: tuple[str, ...] = ()
    surfaces: tuple[NurbsSurface, ...] = ()

    @property
    def curve(self) -> Nurbs:
        """The only curve of the file. Raises `CurveFileError` for none or several."""
        if len(self.curves) != 1:
            raise self._not_one(len(self.curves), "curve", ".curves")
        return self.curves[0].curve

    @property
    def surface(self) -> NurbsSurface:
        """The only surface of the file. Raises `CurveFileError` for none or several."""
        if len(self.surfaces) != 1:
            raise self._not_one(len(self.surfaces), "surface", ".surfaces")
        return self.surfaces[0]

    def _not_one(self, count: int, what: str, all_of_them: str) -> CurveFileError:
        if count or not self.skipped:
            return CurveFileError(f"{counted(count, what)}, where one is expected", remedy=f"take {all_of_them}")
        first = self.skipped[0]
        return CurveFileError(f"the {first.what} is skipped: {first.why}", where=first.where, remedy="correct the file")

    @one_line
    def __repr__(self) -> str:
        parts = [counted(len(self.curves), "curve")] if self.curves or not self.surfaces else []
        parts += [counted(len(self.surfaces), "surface")] if self.surfaces else []
        parts += [f"{len(self.skipped)} skipped"] if self.skipped else []
        return f"<Reading of {self.format}: {', '.join(parts)}>"

    @property
    def complete(self) -> bool:
        """Whether every curve of the file was read."""
        return not any(skipped.curve for skipped in self.skipped)


class Piece(NamedTuple):
    """A part of the contents of a file, in the order of the file; `done` of `total` parts are read with it."""

    reading: Reading
    done: int
    total: int


@dataclass(frozen=True, repr=False)
class Source(OneLine):
    """The input of a reader: the bytes, the name of the file, the requested part (a glyph), for formats that hold only
    control points degree and knots, and the distance within which an arc without an exact representation is replaced.
    """

    data: bytes
    name: str = ""
    part: str = ""
    degree: int | None = None
    knots: tuple[str, ...] | None = None
    limits: Limits = field(default_factory=Limits)
    within: mpq | None = None

    @property
    def text(self) -> str:
        """The bytes decoded as UTF-8 without a byte order mark or, if they are not valid UTF-8, as Latin-1: numbers and
        keywords are ASCII in every format.
        """
        try:
            return self.data.decode("utf-8-sig")
        except UnicodeDecodeError:
            return self.data.decode("latin-1")
