"""Corpora: curve files, folders, fonts, families and single curves, read one after the other, never all together."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from hashlib import blake2b
from pathlib import Path

from exactspline.batch.families import Family
from exactspline.errors import CurveFileError, ExactSplineError
from exactspline.interchange.examples import example, example_names
from exactspline.interchange.files import read_in_pieces
from exactspline.interchange.formats import FORMATS
from exactspline.interchange.records import Skipped
from exactspline.splines.nurbs import Nurbs

#: The sources of a corpus: curves, families, and the names of files, folders and example curves.
Source = Nurbs | Family | str
#: The weight of a generated curve in the progress, in bytes of a file.
BYTES_A_CURVE = 1000
#: The kinds of problem for contents of a file that are not curves, and for curves that its reader skipped.
SKIPPED, NOT_READ = "Skipped", "NotRead"


@dataclass(frozen=True)
class Problem:
    """Why there is no result: the kind of the error, its message (without the file, which the item names), and whether
    the input is to blame.
    """

    kind: str
    message: str
    bad_input: bool = True

    @classmethod
    def of(cls, error: Exception) -> Problem:
        """The problem that an exception reports."""
        return cls(type(error).__name__, str(error), isinstance(error, ExactSplineError))


def short_digest(text: str) -> str:
    """Sixteen hexadecimal digits that change with the text: a protection against accidents, not against forgery."""
    return blake2b(text.encode("utf-8", "surrogatepass"), digest_size=8).hexdigest()


def curve_digest(curve: Nurbs) -> str:
    """A digest of a curve's exact data, whatever its name."""
    points = [*curve.knots, *curve.weights, *(x for row in curve.control_points for x in row)]
    return short_digest(f"{curve.degree} {curve.dimension} {' '.join(map(str, points))}")


@dataclass(frozen=True)
class Member:
    """A curve of a family, generated when it is needed."""

    family: Family
    number: int


@dataclass(frozen=True)
class Item:
    """A curve of a corpus, or the problem where none can be read; `share` is the fraction of the corpus read so far,
    this curve included.
    """

    index: int
    source: str
    name: str
    given: Nurbs | Member | Problem
    share: float
    #: Notes of the file's reader about the curve.
    notes: tuple[str, ...] = ()

    @property
    def digest(self) -> str:
        """A digest of the curve's exact data, so that a curve that changes under its name is noticed; empty where the
        source and the name determine the curve.
        """
        return curve_digest(self.given) if isinstance(self.given, Nurbs) else ""

    def curve(self) -> Nurbs:
        """The curve itself; only where `given` is no `Problem`."""
        if isinstance(self.given, Member):
            return self.given.family.curve(self.given.number)
        assert isinstance(self.given, Nurbs)
        return self.given


def items(sources: Iterable[Source]) -> Iterator[Item]:
    """All curves of a corpus in order. An unreadable one is an item with its problem, never an exception.

    Sources with a length are scanned first, so that the fraction read so far is known.

    >>> from exactspline import example
    >>> [(item.index, item.source, item.name) for item in items(["circle", example("cusp"), Family(count=1)])]
    [(0, 'circle', 'circle'), (1, '', 'cusp'), (2, 'random degree=3 segments=1 dimension=2 rational=no bits=10 \
count=1 seed=1', '0')]
    """
    if not isinstance(sources, (list, tuple)):
        for index, (source, name, given, _, notes) in enumerate(part for each in sources for part in _parts(each)):
            yield Item(index, source, name, given, 0, notes)
        return
    places = [place for source in sources for place in _places(source)]
    total, before, index = sum(map(_size, places)) or 1, 0, 0
    for place in places:
        size = _size(place)
        for source, name, given, (done, count), notes in _parts(place):
            yield Item(index, source, name, given, (before + size * done / count) / total, notes)
            index += 1
        before += size


Part = tuple[str, str, Nurbs | Member | Problem, tuple[int, int], tuple[str, ...]]


def _places(source: Source) -> list[Source]:
    """The files of a folder in the order of their names, those with the suffix of a readable format; any other source
    is returned unchanged.
    """
    if not isinstance(source, str) or not os.path.isdir(source):
        return [source]
    suffixes = {suffix for known in FORMATS for suffix in known.suffixes}
    paths = sorted(path for path in Path(source).rglob("*") if path.suffix.lower() in suffixes and path.is_file())
    return list(map(str, paths))


def _size(source: Source) -> int:
    if isinstance(source, Family):
        return source.count * BYTES_A_CURVE
    if isinstance(source, str) and os.path.isfile(source):
        return os.path.getsize(source)
    return BYTES_A_CURVE


def _parts(source: Source) -> Iterator[Part]:
    """The curves of one source, each with the number read so far and the total, and notes of the reader."""
    if isinstance(source, Nurbs):
        yield "", source.name, source, (1, 1), ()
    elif isinstance(source, Family):
        said = str(source)
        for number in range(source.count):
            yield said, str(number), Member(source, number), (number + 1, source.count), ()
    else:
        for place in _places(source):
            yield from _of_file(str(place))


def _of_file(place: str) -> Iterator[Part]:
    """The curves of a file followed by what was skipped in it, or the problem of the whole file. No reference to a
    returned curve is kept here, since a curve stores everything computed from it.
    """
    curves_read, surfaces, skipped = 0, 0, list[Skipped]()
    try:
        if place in example_names() and not os.path.exists(place):
            yield place, place, example(place), (1, 1), ()
            return
        for reading, done, count in read_in_pieces(place):
            skipped += [
                Skipped("surface", f"surface {surfaces + i}", f"{surface.name} is not a curve", curve=False)
                for i, surface in enumerate(reading.surfaces, 1)
            ]
            surfaces += len(reading.surfaces)
            skipped += reading.skipped
            kept, notes = [*reversed(reading.curves)], reading.notes
            size = len(kept)
            del reading
            while kept:
                named = kept.pop()
                curves_read += 1
                # only a part of the piece read last has been processed
                yield place, named.name, named.curve, (size * done - len(kept), size * count), (*notes, *named.notes)
                del named
    except ExactSplineError as error:
        yield place, "", Problem.of(error), (1, 1), ()
        return
    if not curves_read and not skipped:
        yield place, "", Problem.of(CurveFileError("holds no curve")), (1, 1), ()
    for each in skipped:
        kind = NOT_READ if each.curve else SKIPPED
        yield place, each.where, Problem(kind, f"{each.what}: {each.why}"), (1, 1), ()
