"""Corpora: curve files, folders, fonts, families and single curves, or files of surfaces and surfaces, read one after
the other, never all together.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from operator import itemgetter
from pathlib import Path
from typing import NamedTuple

from exactspline.batch.families import Family
from exactspline.errors import CurveFileError, ExactSplineError, NumberError, as_flag
from exactspline.interchange.curve_files import curve_digest, surface_digest
from exactspline.interchange.examples import example, example_names
from exactspline.interchange.files import read_in_pieces
from exactspline.interchange.formats import formats
from exactspline.interchange.records import Reading, Skipped
from exactspline.numbers.exact import Number, mpq, rational
from exactspline.one_line import OneLine
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface

#: The sources of a corpus: curves, surfaces, families, and the names of files, folders and examples.
Source = Nurbs | NurbsSurface | Family | str
#: The weight of a generated curve in the progress, in bytes of a file.
BYTES_A_CURVE = 1000
#: The kinds of problem for contents of a file that are not curves, and for curves that its reader skipped.
SKIPPED, NOT_READ = "Skipped", "NotRead"


@dataclass(frozen=True, repr=False)
class Problem(OneLine):
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


@dataclass(frozen=True, repr=False)
class Taken(OneLine):
    """What is taken from sources: curves, or surfaces; and the distance within which an arc that has no rational
    control points is replaced (see `exactspline.interchange.files.read`), None for no distance.
    """

    surfaces: bool = False
    approximate: mpq | None = None

    @classmethod
    def of(cls, *, surfaces: bool = False, approximate: Number | None = None) -> Taken:
        """What arguments of a user name; raises `NumberError` for a distance that is not above 0."""
        within = None if approximate is None else rational(approximate)
        if within is not None and within <= 0:
            raise NumberError(f"a distance of {within}", where="approximate", remedy="give a number above 0")
        return cls(as_flag(surfaces, "whether surfaces are taken"), within)

    def settings(self) -> dict[str, object]:
        """As data, for the results of a sweep."""
        return {"surfaces": self.surfaces, "approximate": None if self.approximate is None else str(self.approximate)}


CURVES = Taken()


@dataclass(frozen=True, repr=False)
class Member(OneLine):
    """A curve of a family, generated when it is needed."""

    family: Family
    number: int


@dataclass(frozen=True, repr=False)
class Item(OneLine):
    """A curve or surface of a corpus, or the problem where none can be read; `share` is the fraction of the corpus read
    so far, this one included.
    """

    index: int
    source: str
    name: str
    given: Nurbs | NurbsSurface | Member | Problem
    share: float
    #: Notes of the file's reader about the curve.
    notes: tuple[str, ...] = ()

    @property
    def digest(self) -> str:
        """A digest of the exact data of the curve or surface, so that one that changes under its name is noticed; empty
        where the source and the name determine it.
        """
        if isinstance(self.given, NurbsSurface):
            return surface_digest(self.given)
        return curve_digest(self.given) if isinstance(self.given, Nurbs) else ""

    def curve(self) -> Nurbs:
        """The curve itself; only where `given` is no `Problem`."""
        if isinstance(self.given, Member):
            return self.given.family.curve(self.given.number)
        assert isinstance(self.given, Nurbs)
        return self.given


def items(sources: Iterable[Source], taken: Taken = CURVES) -> Iterator[Item]:
    """All curves, or all surfaces, of a corpus in order. An unreadable one is an item with its problem, never an
    exception.

    Sources with a length are scanned first, so that the fraction read so far is known.

    >>> from exactspline import example
    >>> [(item.index, item.source, item.name) for item in items(["circle", example("cusp"), Family(count=1)])]
    [(0, 'circle', 'circle'), (1, '', 'cusp'), (2, 'random degree=3 segments=1 dimension=2 rational=no bits=10 \
count=1 seed=1', '0')]
    """
    if not isinstance(sources, (list, tuple)):
        parts = (part for each in sources for part in _parts(each, taken))
        for index, (source, name, given, _, notes) in enumerate(parts):
            yield Item(index, source, name, given, 0, notes)
        return
    places = [place for source in sources for place in _places(source)]
    total, before, index = sum(map(_size, places)) or 1, 0, 0
    for place in places:
        size = _size(place)
        for source, name, given, (done, count), notes in _parts(place, taken):
            yield Item(index, source, name, given, (before + size * done / count) / total, notes)
            index += 1
        before += size


Part = tuple[str, str, Nurbs | NurbsSurface | Member | Problem, tuple[int, int], tuple[str, ...]]


def _places(source: Source) -> list[Source]:
    """The files of a folder in the order of their names, those with the suffix of a readable format; any other source,
    a folder without such a file included, is returned unchanged.
    """
    if not isinstance(source, str) or not os.path.isdir(source):
        return [source]
    suffixes = {suffix for known in formats() for suffix in known.suffixes}
    paths = sorted(path for path in Path(source).rglob("*") if path.suffix.lower() in suffixes and path.is_file())
    return list(map(str, paths)) or [source]


def _size(source: Source) -> int:
    if isinstance(source, Family):
        return source.count * BYTES_A_CURVE
    if isinstance(source, str) and os.path.isfile(source):
        return os.path.getsize(source)
    return BYTES_A_CURVE


def _parts(source: Source, taken: Taken) -> Iterator[Part]:
    """The curves, or the surfaces, of one source, each with the number read so far and the total, and notes of the
    reader.
    """
    if isinstance(source, (Nurbs, NurbsSurface)):
        wrong = isinstance(source, NurbsSurface) != taken.surfaces
        yield "", source.name, Problem(SKIPPED, _other(taken)) if wrong else source, (1, 1), ()
    elif isinstance(source, Family) and taken.surfaces:
        yield str(source), "", Problem(SKIPPED, _other(taken)), (1, 1), ()
    elif isinstance(source, Family):
        said = str(source)
        for number in range(source.count):
            yield said, str(number), Member(source, number), (number + 1, source.count), ()
    else:
        for place in _places(source):
            yield from _of_file(str(place), taken)


def _of_file(place: str, taken: Taken) -> Iterator[Part]:
    """The curves, or surfaces, of a file and what was skipped in it, in the order of the file, or the problem of the
    whole file. No reference to a returned curve is kept here, since a curve stores everything computed from it.
    """
    found = others = 0
    try:
        if os.path.isdir(place):
            raise CurveFileError("is a folder without a file of a format that is read", remedy="name another folder")
        if place in example_names() and not os.path.exists(place) and not taken.surfaces:
            yield place, place, example(place), (1, 1), ()
            return
        for reading, done, count in read_in_pieces(place, taken.approximate):
            entries = _entries(reading, taken, others)
            others += len(reading.curves if taken.surfaces else reading.surfaces)
            size = len(entries)
            del reading
            while entries:
                name, given, notes = entries.pop()
                found += 1
                # only a part of the piece read last has been processed
                yield place, name, given, (size * done - len(entries), size * count), notes
                del given
    except ExactSplineError as error:
        yield place, "", Problem.of(error), (1, 1), ()
        return
    if not found:
        what = "surface" if taken.surfaces else "curve"
        yield place, "", Problem.of(CurveFileError(f"holds no {what}")), (1, 1), ()


class _FileItem(NamedTuple):
    """What a file holds: a curve, a surface, or the problem of what was skipped; its name, and the notes on it."""

    name: str
    given: Nurbs | NurbsSurface | Problem
    notes: tuple[str, ...]


def _entries(reading: Reading, taken: Taken, others: int) -> list[_FileItem]:
    """The curves or surfaces taken of a part of a file and the problems of what was skipped, the last first. What is
    not taken, after this many others, comes behind the rest.
    """
    curves = [_FileItem(each.name, each.curve, (*reading.notes, *each.notes)) for each in reading.curves]
    surfaces = [_FileItem(each.name, each, reading.notes) for each in reading.surfaces]
    kept, left, what = (surfaces, curves, "curve") if taken.surfaces else (curves, surfaces, "surface")
    behind = len(curves), len(surfaces)
    more = [
        Skipped(what, f"{what} {i}", f"{each.name}: {_other(taken)}", False, behind)
        for i, each in enumerate(left, others + 1)
    ]
    placed = list(enumerate(kept))
    for each in reversed((*reading.skipped, *more)):
        problem = Problem(NOT_READ if each.curve else SKIPPED, f"{each.what}: {each.why}")
        placed.append((each.after[taken.surfaces], _FileItem(each.where, problem, ())))
    # of those at one place the curve is the last, and these are read backwards
    return [entry for _, entry in sorted(placed, key=itemgetter(0), reverse=True)]


def _other(taken: Taken) -> str:
    return "not a surface" if taken.surfaces else "not a curve; --surfaces takes surfaces"
