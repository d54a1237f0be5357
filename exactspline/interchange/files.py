"""Reading and writing files of all formats."""

from __future__ import annotations

import os
import stat
import sys
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

from exactspline.atomic_write import write_atomically
from exactspline.errors import (
    CurveFileError,
    ExactSplineError,
    NumberError,
    as_instance,
    as_items,
    as_path,
    as_text,
    counted,
    nearest,
    written,
)
from exactspline.interchange import curve_files
from exactspline.interchange.examples import example_text, examples
from exactspline.interchange.format import Format, Spline
from exactspline.interchange.formats import formats
from exactspline.interchange.numbers import NumberText
from exactspline.interchange.records import Limits, NamedCurve, Piece, Reading, Source
from exactspline.numbers.exact import Number, mpq, rational
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface
from exactspline.splines.type_checks import curve_of

#: The number of bytes of a file that are used to recognize its format.
HEAD = 16_384
#: A byte order mark, and blanks.
BLANK = b"\xef\xbb\xbf \t\r\n"


def read(
    place: str | os.PathLike[str] | bytes,
    format: str | None = None,
    *,
    part: str = "",
    degree: int | None = None,
    knots: Sequence[object] | None = None,
    limits: Limits | None = None,
    approximate: Number | None = None,
) -> Reading:
    """Read the curves and surfaces of a file, of a part of a file (``font.ttf:glyph``, ``drawing.svg:id``,
    ``drawing.dxf:layer``), of standard input (``-``), or of bytes.

    By default the format is recognized by the content, then by the suffix. `degree` and `knots` are for formats that
    hold only control points. With `approximate`, a distance above 0, an arc without rational control points is replaced
    by a rational arc within this distance, and a note says so. In SVG the new arc has the same ends; in other formats
    the new arc is on the same circle if this circle is rational.

    >>> read(b"100 1 0 0\\n2 0\\n2 2\\n0 0 1 1\\n0 0\\n0.1 2\\n").curves[0].curve(1)
    (mpq(1,10), mpq(2,1))

    Raises `CurveFileError` if there is nothing to read or the format is unknown, and another `ExactSplineError` if the
    file as a whole is invalid; a single invalid curve is listed under `skipped`.
    """
    part = as_text(part, "a part of a file")
    given = None if knots is None else tuple(map(written, as_items(knots, "knots")))
    bounds = Limits() if limits is None else as_instance(limits, Limits, "bounds", "give Limits(megabytes=200)")
    within = _distance(approximate)
    path, named_part = ("", "") if isinstance(place, bytes) else _parted(as_path(place))
    name = _name(path)
    try:
        data = place if isinstance(place, bytes) else _bytes(path, bounds)
        source = Source(data, Path(name).name, part or named_part, degree, given, bounds, within)
        return _format(source, format).read(source)
    except ExactSplineError as error:
        raise (error.at(name) if name else error) from None


def _distance(approximate: Number | None) -> mpq | None:
    """The distance within which arcs are replaced; raises `NumberError` for a number that is not above 0."""
    within = None if approximate is None else rational(approximate)
    if within is not None and within <= 0:
        raise NumberError(f"a distance of {within}", where="approximate", remedy="give a number above 0, such as 1e-9")
    return within


def read_in_pieces(place: str, approximate: Number | None = None) -> Iterator[Piece]:
    """The curves of a file as `read` returns them, piece by piece if the format supports it, so that a large font is
    never in memory as a whole.

    >>> [(len(piece.reading.curves), piece.done, piece.total) for piece in read_in_pieces("curve.xyz")]
    Traceback (most recent call last):
    ...
    exactspline.errors.CurveFileError: cannot be read (No such file or directory); name a file or an example

    Raises the errors of `read`, but without the place of the file, which the caller knows, and only after the pieces
    before the defect have been yielded.
    """
    path, part = _parted(place)
    limits = Limits()
    source = Source(_bytes(path, limits), Path(_name(path)).name, part, None, None, limits, _distance(approximate))
    chosen = _format(source, None)
    if chosen.pieces is None:
        yield Piece(chosen.read(source), 1, 1)
    else:
        yield from chosen.pieces(source)


def _format(source: Source, named: str | None) -> Format:
    """The format of a file that is not too large: the named one, or the one recognized."""
    limits = source.limits
    if len(source.data) > limits.megabytes << 20:
        raise CurveFileError(f"{counted(len(source.data), 'byte')}", remedy=f"at most {limits.megabytes} MB are read")
    if not source.data.strip(BLANK):
        raise CurveFileError("is empty", remedy="name a file of curves")
    chosen = _recognized(source.data, source.name) if named is None else _named_format(named)
    if source.part and not chosen.parts:
        remedy = "parts are glyphs of fonts, ids of SVG, layers of DXF"
        raise CurveFileError(f"{chosen.title}: there is no part {source.part!r}", remedy=remedy)
    return chosen


def write(
    given: Nurbs | NurbsSurface | Iterable[Nurbs | NamedCurve | NurbsSurface],
    place: str | os.PathLike[str],
    format: str | None = None,
    *,
    rounding: bool = False,
) -> tuple[str, ...]:
    """Write one or several curves or surfaces in a format, by default chosen by the suffix, and return notes on lost
    information.

    >>> import tempfile
    >>> from exactspline.interchange.examples import example
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     notes = write(example("torus"), f"{folder}/torus.json")
    ...     read(f"{folder}/torus.json").surface == example("torus")
    True

    Every number is written exactly, or the file is not written: `NumberError` is raised for a number that the format
    cannot represent, unless `rounding` requests the nearest doubles, and another `ExactSplineError` for other data.
    """
    place = as_path(place)
    chosen = _by_suffix(place) if format is None else _named_format(format)
    try:
        data, notes = encoded(given, chosen.name, rounding=rounding)
    except ExactSplineError as error:
        raise error.at(os.fspath(place)) from None
    write_atomically(place, lambda stream: stream.write(data))
    return notes


def encoded(
    given: Nurbs | NurbsSurface | Iterable[Nurbs | NamedCurve | NurbsSurface], format: str, *, rounding: bool = False
) -> tuple[bytes, tuple[str, ...]]:
    """The bytes that `write` writes, and notes on lost information."""
    chosen = _named_format(format)
    several: Any = [given] if isinstance(given, (Nurbs, NurbsSurface)) else as_items(given, "curves or surfaces")
    kinds = NamedCurve | NurbsSurface
    named = [
        c if isinstance(c, kinds) else NamedCurve(curve_of(c).name or f"curve {i}", c) for i, c in enumerate(several, 1)
    ]
    surfaces = [each for each in named if isinstance(each, NurbsSurface)]
    if not named:
        raise CurveFileError("no curves to write", remedy="give at least one")
    if surfaces and len(surfaces) < len(named):
        raise CurveFileError("curves and surfaces", remedy="write them into two files")
    if surfaces and not chosen.surfaces:
        able = ", ".join(sorted(known.name for known in formats() if known.surfaces))
        raise CurveFileError(f"{chosen.title}: no surfaces are written", remedy=f"these hold surfaces: {able}")
    if chosen.write is None:
        known = ", ".join(sorted(known.name for known in formats() if known.write))
        raise CurveFileError(f"{chosen.title} can be read but not written", remedy=f"these can be written: {known}")
    numbers = NumberText(rounding)
    data = chosen.write(list(map(Spline, named)), numbers)
    notes = [f"{numbers.rounded} numbers were rounded to doubles"] if numbers.rounded else []
    return data, (*notes, *([chosen.loses] if chosen.loses else []))


def text(given: Nurbs | NurbsSurface | Iterable[Nurbs | NamedCurve | NurbsSurface], format: str = "json") -> str:
    """Return the text of the file that `write` would write, for formats that are text.

    >>> text(Nurbs.bezier([(0, 0), (1, 2), (3, 0)]), "svg").count("<path")
    1
    """
    return encoded(given, format)[0].decode()


def _named_format(name: str) -> Format:
    """The format with this name; raises `CurveFileError` listing the known names."""
    for known in formats():
        if known.name == as_text(name, "the name of a format"):
            return known
    names = ", ".join(sorted(known.name for known in formats()))
    raise CurveFileError(f"there is no format called {name!r}", remedy=f"the formats are {names}")


def _by_suffix(path: str) -> Format:
    suffix = Path(path).suffix.lower()
    # *.json means our format; other formats with that suffix are recognized by content and written only when named
    for known in sorted(formats(), key=lambda known: known.name != suffix[1:]):
        if suffix in known.suffixes:
            return known
    raise CurveFileError(f"no format has the suffix {suffix}", where=path, remedy="name the format")


def _recognized(data: bytes, name: str) -> Format:
    head, suffix = data[:HEAD], Path(name).suffix.lower()
    # a name in JSON may look like another format: <svg …, [OBJECT …
    in_json, elsewhere = curve_files.looks_like(head), any(suffix in each.suffixes for each in formats())
    for known in (each for each in formats() if not in_json or ".json" in each.suffixes):
        # text that begins with a brace is not necessarily JSON: if the suffix belongs to another format, that format is
        # used
        braced = known.suffixes == (".json",) and suffix != ".json" and elsewhere
        if known.looks_like(head) and not braced:
            return known
    try:
        return _by_suffix(name)
    except CurveFileError:
        raise CurveFileError("is not in a known format", remedy="name the format") from None


def _is_example(path: str) -> bool:
    return not os.path.lexists(path) and path in examples()


def _parted(path: str) -> tuple[str, str]:
    """The path of a file, and the part named after a colon."""
    if os.path.lexists(path) or path in examples():
        return path, ""
    if path.isidentifier():
        remedy = nearest(path, examples(), listed_by="list curves")
        raise CurveFileError(f"there is neither a file nor an example called {path!r}", remedy=remedy)
    if ":" not in path:
        return path, ""
    file, _, part = path.partition(":") if path.count(":") == 1 else path.rpartition(":")
    return file, part


def _name(path: str) -> str:
    """How messages name a file."""
    return "standard input" if path == "-" else f"{path}.json" if _is_example(path) else path


def _bytes(path: str, limits: Limits) -> bytes:
    """The bytes of a file, of standard input, or of an example. Reading stops soon after the limit on the size."""
    most = (limits.megabytes << 20) + 1
    if path == "-":
        return sys.stdin.buffer.read(most)
    if _is_example(path):
        return example_text(path).encode()
    try:
        if not stat.S_ISREG(mode := os.stat(path).st_mode):
            what = "is a directory, not a regular file" if stat.S_ISDIR(mode) else "is not a regular file"
            raise CurveFileError(what, remedy="give a curve file")
        with open(path, "rb") as stream:
            return stream.read(most)
    except (OSError, ValueError) as error:
        if isinstance(error, ExactSplineError):
            raise
        reason = getattr(error, "strerror", None) or "no file name"
        raise CurveFileError(f"cannot be read ({reason})", remedy="name a file or an example") from None
