"""Corpora: curve files, folders, fonts, families and single curves, or files of surfaces and surfaces. They are read
one after another, never all together.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import asdict, dataclass, fields
from functools import lru_cache
from operator import itemgetter
from pathlib import Path
from random import Random
from typing import NamedTuple

from exactspline.errors import CurveFileError, ExactSplineError, NumberError, as_flag, nearest
from exactspline.interchange.curve_files import curve_digest, surface_digest
from exactspline.interchange.examples import example, example_names
from exactspline.interchange.files import read_in_pieces
from exactspline.interchange.formats import formats
from exactspline.interchange.records import Reading, Skipped
from exactspline.numbers.exact import Number, mpq, rational
from exactspline.one_line import OneLine
from exactspline.splines.knots import KnotVector
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface

# ---- families of random curves


Range = tuple[int, int]
#: The parameters of a family that are not numbers.
KINDS = ("no", "yes", "half")
#: The largest values of parameters: beyond them a single random curve takes minutes.
MOST = {"degree": 60, "segments": 100_000, "bits": 100_000}


@dataclass(frozen=True, repr=False)
class Family(OneLine):
    """A family of random curves with the simple knots 0, 1, 2, …, integer control points of a given number of bits, and
    weights from 1 to 20.

    >>> family = Family.parsed("degree=2-5 segments=1-4 rational=half count=400 seed=1")
    >>> curve = family.curve(7)
    >>> curve == family.curve(7), 2 <= curve.degree <= 5, curve.name
    (True, True, '7')
    """

    degree: Range = (3, 3)
    segments: Range = (1, 1)
    dimension: int = 2
    rational: str = "no"
    bits: int = 10
    count: int = 100
    seed: int = 1

    @classmethod
    def parsed(cls, text: str | Iterable[str]) -> Family:
        """Return the family that a text such as ``degree=5 count=1000 seed=1`` describes; blanks or commas separate the
        words.

        Raises `CurveFileError` for an unknown word or a number out of range.
        """
        words = text.replace(",", " ").split() if isinstance(text, str) else list(text)
        said: dict[str, str] = {}
        for word in words:
            name, equals, value = word.partition("=")
            if name not in _names() or not equals or name in said:
                raise CurveFileError(
                    f"--random does not know {word!r}" if name not in said else f"--random names {name} twice",
                    remedy=f"write name=value; {nearest(name, _names())}",
                )
            said[name] = value
        values = {name: _value(name, value) for name, value in said.items()}
        return cls(**values)  # type: ignore[arg-type]  # each field gets a value of its own type

    def curve(self, number: int) -> Nurbs:
        """Return the curve with this index, counted from 0."""
        chance = Random(f"exactspline {self.seed} {number}")
        degree, segments = chance.randint(*self.degree), chance.randint(*self.segments)
        most = 1 << self.bits
        points = [tuple(chance.randint(-most, most) for _ in range(self.dimension)) for _ in range(degree + segments)]
        rational = self.rational == "yes" or (self.rational == "half" and number % 2 == 1)
        weights = [chance.randint(1, 20) for _ in points] if rational else None
        return Nurbs(degree, _knots(degree, segments), points, weights, name=str(number))

    def __str__(self) -> str:
        """The words that describe the family."""
        return "random " + " ".join(f"{name}={_shown(value)}" for name, value in asdict(self).items())


@lru_cache(256)
def _knots(degree: int, segments: int) -> KnotVector:
    """Simple knots 0, 1, 2, …, clamped."""
    return KnotVector([0] * degree + list(range(segments + 1)) + [segments] * degree)


def _names() -> tuple[str, ...]:
    """The parameters of a family."""
    return tuple(field.name for field in fields(Family))


def is_word(text: str) -> bool:
    """Whether a word of the command line is a parameter of a family.

    >>> is_word("count=100"), is_word("fonts=new.ttf")
    (True, False)
    """
    name, equals, _ = text.partition("=")
    return bool(equals) and name in _names()


def _shown(value: Range | int | str) -> str:
    return "-".join(map(str, dict.fromkeys(value))) if isinstance(value, tuple) else str(value)


def _value(name: str, text: str) -> Range | int | str:
    """The value of a word; the ends of a range may be equal."""
    if name == "rational":
        if text not in KINDS:
            raise CurveFileError(f"--random rational={text}", remedy=f"there are {', '.join(KINDS)}")
        return text
    ends = text.split("-") if name in ("degree", "segments") else [text]
    if not 1 <= len(ends) <= 2 or not all(end.isascii() and end.isdigit() for end in ends):
        raise CurveFileError(f"--random {name}={text}", remedy="write an integer, for degree and segments also 2-5")
    low, high = int(ends[0]), int(ends[-1])
    least: Mapping[str, int] = {"seed": 0, "dimension": 2}
    most = MOST.get(name, {"dimension": 3}.get(name, high))
    if not least.get(name, 1) <= low <= high <= most:
        allowed = f"{least.get(name, 1)} to {most}" if most != high else f"at least {least.get(name, 1)}"
        raise CurveFileError(f"--random {name}={text} is out of range", remedy=allowed)
    return (low, high) if name in ("degree", "segments") else low


#: The sources of a corpus: curves, surfaces, families, and the names of files, folders and examples.
Source = Nurbs | NurbsSurface | Family | str
#: The weight of a generated curve in the progress, in bytes of a file.
BYTES_A_CURVE = 1000
#: The kinds of problem for contents of a file that are not curves, and for curves that its reader skipped.
SKIPPED, NOT_READ = "Skipped", "NotRead"


@dataclass(frozen=True, repr=False)
class Problem(OneLine):
    """The reason why there is no result: the kind of the error, its message (without the file, which the item names),
    and whether the input is to blame.
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
    """The kind of objects that are taken from sources, curves or surfaces, and the distance within which an arc without
    rational control points is replaced (see `exactspline.interchange.files.read`), None for no distance.
    """

    surfaces: bool = False
    approximate: mpq | None = None

    @classmethod
    def of(cls, *, surfaces: bool = False, approximate: Number | None = None) -> Taken:
        """The choice that arguments of a user describe; raises `NumberError` for a distance that is not above 0."""
        within = None if approximate is None else rational(approximate)
        if within is not None and within <= 0:
            raise NumberError(f"a distance of {within}", where="approximate", remedy="give a number above 0")
        return cls(as_flag(surfaces, "whether surfaces are taken"), within)

    def settings(self) -> dict[str, object]:
        """The choice as data, for the results of a sweep."""
        return {"surfaces": self.surfaces, "approximate": None if self.approximate is None else str(self.approximate)}


CURVES = Taken()


@dataclass(frozen=True, repr=False)
class Member(OneLine):
    """A curve of a family, generated when it is needed."""

    family: Family
    number: int


@dataclass(frozen=True, repr=False)
class Item(OneLine):
    """A curve or surface of a corpus, or the problem if it cannot be read; `share` is the fraction of the corpus that
    has been read, including this item.
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
        """A digest of the exact data of the curve or surface, so that a change under the same name is noticed; empty if
        the source and the name determine the data.
        """
        if isinstance(self.given, NurbsSurface):
            return surface_digest(self.given)
        return curve_digest(self.given) if isinstance(self.given, Nurbs) else ""

    def curve(self) -> Nurbs:
        """The curve itself; it exists only if `given` is not a `Problem`."""
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
    """The curves, or surfaces, of a file and its skipped entities, in the order of the file, or the problem of the
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
    """An entry of a file: a curve, a surface, or the problem of a skipped entity, with its name and notes."""

    name: str
    given: Nurbs | NurbsSurface | Problem
    notes: tuple[str, ...]


def _entries(reading: Reading, taken: Taken, others: int) -> list[_FileItem]:
    """The curves or surfaces taken from a part of a file, and the problems of skipped entities, in reverse order.
    Entities that are not taken come last in the file; `others` is the number of such entities before this part.
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
    # of the entries at one place the curve is the last one, and entries are read backwards
    return [entry for _, entry in sorted(placed, key=itemgetter(0), reverse=True)]


def _other(taken: Taken) -> str:
    return "not a surface" if taken.surfaces else "not a curve; --surfaces takes surfaces"
