"""The sweep: one line per curve of a corpus, in order. With results on disk, existing lines are read and compared with
the corpus, and missing lines are computed. The work on each curve is picklable, so that it can be done in any process.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import takewhile
from pathlib import Path
from time import process_time
from typing import TYPE_CHECKING, Any

from exactspline.batch.backends import ALONE, check_backend, mapped
from exactspline.batch.corpus import CURVES, Item, Member, Problem, Source, Taken, items
from exactspline.batch.inspections import USUAL, checked_names, entry_of, inspected
from exactspline.batch.lines import VERSION, Found, Judged, Line, Summary, Way
from exactspline.batch.results import JsonLines, Parquet, Results, ResultsError, Settings
from exactspline.display.answer_forms import answer_data
from exactspline.errors import ShapeError, as_flag, as_integer, as_text, as_texts
from exactspline.geometry.analysis.ask import REGISTRY, asked_of, check_question, kind_of
from exactspline.geometry.analysis.curves import analyse
from exactspline.numbers.exact import Number
from exactspline.one_line import OneLine
from exactspline.programs.accelerator import filter_curve
from exactspline.questions.entry import Answered, Of
from exactspline.questions.takes import name_of
from exactspline.release import releases
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface

if TYPE_CHECKING:
    from exactspline.verification.claim import Claim
    from exactspline.verification.combined import Proofs


#: Answers to questions that take a time in proportion to the segments of a curve.
QUICK = (Answered.PLACES, Answered.PIECES, Answered.JOINTS)
#: The default and the largest number of digits of irrational parameters.
DIGITS, MOST_DIGITS = 10, 10_000


class _OneByOne(ABC):
    """Work that makes one line for each curve or surface."""

    def line(self, item: Item) -> Line:
        """The line of one item. An error is recorded in the line, so that other items are not affected."""
        start, fields = process_time(), dict[str, Any]()
        try:
            if isinstance(item.given, Problem):
                fields["error"] = item.given
            else:
                self._fill(fields, item)
        # one curve must not end a sweep of a million: an unexpected exception is recorded by its type
        except Exception as failure:
            fields["error"] = Problem.of(failure)
        fields |= {"notes": item.notes, "curve_digest": item.digest, "seconds": process_time() - start}
        return Line(item.index, item.source, item.name, **fields)

    @abstractmethod
    def _fill(self, fields: dict[str, Any], item: Item) -> None:
        """Fill the fields of the line of one item."""

    def lines(self, group: list[Item]) -> Iterator[Line]:
        """The lines of several items. Items are removed from the list, so that none is kept after its line is done."""
        while group:
            yield self.line(group.pop(0))


@dataclass(frozen=True)
class Work(_OneByOne):
    """The features to search for on each curve, by the names of questions; the claims that are checked on it, by
    paper and key; the digits of irrational parameters; and whether points get their coordinates and curvature.

    >>> from exactspline.batch.corpus import items
    >>> line = Work.of().line(next(items(["six_segment_cubic"])))
    >>> line.segments, {name: len(points) for name, points in line.found.items()}, line.error
    (6, {'inflections': 2, 'curvature_extrema': 8, 'corners': 0}, None)
    """

    find: tuple[str, ...]
    claims: tuple[tuple[str, str], ...]
    digits: int
    values: bool = False

    @classmethod
    def of(
        cls, find: Iterable[str] | None = None, claims: Iterable[str] = (), digits: int = DIGITS, values: bool = False
    ) -> Work:
        """The work that the arguments describe: names of questions (by default `USUAL`, or none where claims are given)
        and ids of claims.

        Raises `QuestionError` or `ClaimError` with the nearest names.
        """
        digits = as_integer(digits, "a number of digits", 0, MOST_DIGITS)
        located = _located(as_texts(claims, "ids of claims", "the id of a claim"))
        names = checked_names((() if located else USUAL) if find is None else find)
        return cls(names, located, digits, as_flag(values, "whether points get their values"))

    def settings(self) -> dict[str, object]:
        """The settings on which the lines depend, as data."""
        return {
            "find": list(self.find),
            "claims": [list(claim) for claim in self.claims],
            "digits": self.digits,
            "values": self.values,
        }

    def _fill(self, fields: dict[str, Any], item: Item) -> None:
        """Fill in the data of the curve and the answers about it."""
        curve = item.curve()
        fields |= {name: getattr(curve, name) for name in ("degree", "dimension", "segments", "polynomial")}
        fields["found"], fields["claims"], fields["way"] = self._answered(curve)

    def weight(self, item: Item) -> int:
        """The part of a group that a curve fills. For a plane curve with quick questions only, it is the number of
        segments times the cube of the degree, for a family the largest such value; otherwise it is `ALONE`.

        >>> from exactspline.batch.corpus import items
        >>> from exactspline.batch.corpus import Family
        >>> families = [Family.parsed(f"degree=2-5 dimension={n} count=1") for n in (2, 3)]
        >>> [Work.of().weight(item) for item in items(["six_segment_cubic", *families])]
        [162, 125, 16384]
        """
        given = item.given
        asked = [entry_of(name)[0].about for name in self.find]
        if self.claims or any(about.takes or about.answered not in QUICK for about in asked):
            return ALONE
        if isinstance(given, Member) and given.family.dimension == 2:
            return given.family.segments[1] * given.family.degree[1] ** 3
        return given.segments * given.degree**3 if isinstance(given, Nurbs) and given.dimension == 2 else ALONE

    def _answered(self, curve: Nurbs) -> tuple[dict[str, tuple[Found, ...]], tuple[Judged, ...], Way | None]:
        analysis = analyse(curve)
        found = inspected(curve, self.find, self.digits, self.values)
        way = None
        if analysis.decided_in_doubles is not None and curve.dimension == 2 and curve.degree > 1:
            way = Way.DECIDED if analysis.decided_in_doubles else Way.EXACT if filter_curve else Way.MISSING
        return found, self._judged(curve), way

    def _judged(self, curve: Nurbs) -> tuple[Judged, ...]:
        if not self.claims:
            return ()
        from exactspline.display.evidence import worded
        from exactspline.verification.evaluation import Evaluation
        from exactspline.verification.ledger import UNNAMED, checked
        from exactspline.verification.vocabulary import Name

        evaluation = Evaluation(curve)
        speaking = [claim for claim in _claims(self.claims) if claim.applies_to(curve.dimension, curve.polynomial)]
        rows = [(claim, checked(claim, evaluation, Name(curve.name) or UNNAMED, _proofs())) for claim in speaking]
        return tuple(Judged(claim.key, row.verdict, row.as_recorded, worded(row.witness)) for claim, row in rows)


def _located(ids: Sequence[str]) -> tuple[tuple[str, str], ...]:
    if not ids:
        return ()
    from exactspline.verification.claims import all_claims, located

    keep = {claim for name in ids for claim in located(name)}
    return tuple((claim.paper, claim.key) for claim in all_claims() if claim in keep)


@cache
def _claims(keys: tuple[tuple[str, str], ...]) -> tuple[Claim, ...]:
    from exactspline.verification.claims import all_claims

    return tuple(claim for claim in all_claims() if (claim.paper, claim.key) in keys)


@cache
def _proofs() -> Proofs:
    """The proofs of this process, each made once. They are needed for a claim that is refuted on a curve."""
    from exactspline.verification.combined import Proofs

    return Proofs()


# ---- surfaces


@dataclass(frozen=True)
class _SurfaceWork(_OneByOne):
    """The questions to ask of each surface, and the digits of irrational parameters.

    >>> from exactspline import example
    >>> from exactspline.batch.corpus import Taken, items
    >>> line = _SurfaceWork.of(["umbilics"]).line(next(items([example("enneper")], Taken(surfaces=True))))
    >>> line.degrees, line.patches, line.answers, line.error
    ((3, 3), 1, {'umbilics': {'points': [], 'everywhere': [], 'undecided': []}}, None)
    """

    find: tuple[str, ...]
    digits: int

    @classmethod
    def of(cls, find: Iterable[str] | None = None, digits: int = DIGITS) -> _SurfaceWork:
        """The work that the arguments describe: questions about surfaces and maps of the plane; all questions of the
        registry if none is named, or for ``all``.

        Raises `QuestionError` with the nearest names.
        """
        every = dict.fromkeys(
            name
            for of in (Of.SURFACE, Of.PLANAR_MAP)
            for name, entry in REGISTRY[of].items()
            if not (entry.about.takes or entry.about.on_request)
        )
        asked = dict[str, None]()
        for each in ["all"] if find is None else as_texts(find, "names of questions", "the name of a question"):
            if each != "all":
                check_question(each, Of.SURFACE, Of.PLANAR_MAP)
            asked |= every if each == "all" else {each: None}
        return cls(tuple(asked), as_integer(digits, "a number of digits", 0, MOST_DIGITS))

    def settings(self) -> dict[str, object]:
        """The settings on which the lines depend, as data."""
        return {"find": list(self.find), "claims": [], "digits": self.digits, "values": False}

    def weight(self, item: Item) -> int:
        """Surfaces are computed one by one."""
        return ALONE

    def _fill(self, fields: dict[str, Any], item: Item) -> None:
        """Fill in the data of the surface and the answers; questions that do not apply to surfaces of its dimension are
        skipped.
        """
        surface = item.given
        assert isinstance(surface, NurbsSurface)  # this work gets only surfaces
        first, second = (len(mesh.breaks) - 1 for mesh in surface.meshes)
        fields |= {"dimension": surface.dimension, "polynomial": surface.polynomial, "degrees": surface.degree}
        fields["patches"] = first * second
        found = analyse(surface)
        fields["answers"] = {
            asked: answer_data(asked_of(found, asked), self.digits)
            for asked in self.find
            if name_of(asked) in REGISTRY[kind_of(found)]
        }


def sweep(
    curves: Iterable[Source] | Source,
    *,
    find: Iterable[str] | None = None,
    claims: Iterable[str] = (),
    digits: int = DIGITS,
    values: bool = False,
    jobs: int = 1,
    backend: str = "processes",
    scheduler: str = "",
    surfaces: bool = False,
    approximate: Number | None = None,
) -> Iterator[Line]:
    """Yield the features of many curves, one line per curve, in order. A curve is given by itself, by the name of a
    file, a folder, a font or an example, or by a `Family` of random curves. `find` names the questions to ask
    (`asked_by_sweeps`); `claims` are the ids of the claims to check. With `values` every point has its coordinates and
    the curvature, as correctly rounded doubles. `backend` is one of `BACKENDS`. A curve that cannot be read or handled
    yields a line with the error. With `surfaces`, the surfaces are taken instead of the curves, and `find` names
    questions about surfaces (by default all). For `approximate`, see `exactspline.interchange.read`.

    Plane curves are computed in groups of 16 to 512, with several processes up to 4096 curves ahead for each process.

    >>> for line in sweep(["circle", "six_segment_cubic"], find=["turning_points:0"]):
    ...     print(line.curve, [each.low for each in line.found["turning_points:0"]])
    circle ['0', '2']
    six_segment_cubic ['1.9264459962', '5.1715728752']

    Raises `QuestionError`, `ClaimError` or `BackendError` for unknown names, and `ShapeError` for claims or values of
    surfaces, before anything is computed.
    """
    jobs, scheduler = as_integer(jobs, "a number of processes", 1), as_text(scheduler, "the address of a scheduler")
    taken = Taken.of(surfaces=surfaces, approximate=approximate)
    work = work_of(taken, find, claims, digits, values)
    check_backend(backend)
    one = isinstance(curves, (Nurbs, NurbsSurface, str)) or not isinstance(curves, Iterable)
    given: Any = [curves] if one else curves
    return mapped(work.lines, items(given, taken), backend, jobs, scheduler, work.weight)


def work_of(
    taken: Taken, find: Iterable[str] | None, claims: Iterable[str], digits: int, values: bool
) -> Work | _SurfaceWork:
    """The work on each curve, or each surface, that the arguments of `sweep` describe."""
    if not taken.surfaces:
        return Work.of(find, claims, digits, values)
    if as_texts(claims, "ids of claims", "the id of a claim"):
        raise ShapeError("a sweep of surfaces with claims", remedy="prove --surface checks claims on surfaces")
    if values:
        raise ShapeError("a sweep of surfaces with values", remedy="ask for them at places, as in value@1/2,1/3")
    return _SurfaceWork.of(find, digits)


@dataclass(frozen=True, repr=False)
class Where(OneLine):
    """The place where a sweep is computed: see `exactspline.batch.backends.mapped`."""

    backend: str = "processes"
    jobs: int = 1
    scheduler: str = ""


def _settings(sources: Sequence[Source], work: Work | _SurfaceWork, taken: Taken = CURVES) -> dict[str, object]:
    """The settings on which results depend: a sweep may only be continued with the same ones."""
    return {
        "schema": "exactspline/sweep_line",
        "version": VERSION,
        "releases": releases(),
        "corpus": [each.name if isinstance(each, (Nurbs, NurbsSurface)) else str(each) for each in sources],
        **work.settings(),
        **taken.settings(),
    }


def sweep_into_file(
    sources: Sequence[Source],
    work: Work | _SurfaceWork,
    where: Where,
    output: str,
    summary: Summary,
    tick: Callable[[float, Line, bool], None] = lambda *_: None,
    stopped: Callable[[], bool] = lambda: False,
    taken: Taken = CURVES,
) -> None:
    """Sweep a corpus into a file (`_opened`), or nowhere, and count all of its lines.

    If the file exists, its lines are counted and the sweep continues after them. `tick` is called with the fraction of
    the corpus that is done, the line, and whether it existed before. Once `stopped` returns true, no further curve is
    started; those in progress are finished.

    Raises `ResultsError` if the results cannot be written or belong to another corpus.
    """
    given = takewhile(lambda _: not stopped(), items(sources, taken))
    if not output:
        _compute(given, work, where, None, summary, tick)
        return
    with _opened(output, _settings(sources, work, taken)) as results:
        for line in results.existing():
            item = next(given, None)
            if item is None and stopped():
                return
            if item is None or not _about(line, item):
                raise ResultsError(
                    f"line {line.index + 1} is about {line.source or line.curve}, which is no longer in the corpus, or "
                    "has changed",
                    where=output,
                    remedy="the corpus has changed: write to another file",
                )
            summary.add(line, known=True)
            tick(item.share, line, True)
        _compute(given, work, where, results, summary, tick)


def _about(line: Line, item: Item) -> bool:
    """Whether a line is about this item of the corpus, and the item has not changed."""
    problem = item.given if isinstance(item.given, Problem) else line.error
    return (item.source, item.name, item.digest, problem) == (line.source, line.curve, line.curve_digest, line.error)


def _opened(place: str, settings: Settings) -> Results:
    """Results at a place, new or continued: Parquet for ``*.parquet``, JSON Lines otherwise.

    Raises `ResultsError`, also where pyarrow is needed and missing.
    """
    return Parquet(Path(place), settings) if place.endswith(".parquet") else JsonLines(Path(place), settings)


def _compute(
    given: Iterator[Item],
    work: Work | _SurfaceWork,
    where: Where,
    results: Results | None,
    summary: Summary,
    tick: Callable[[float, Line, bool], None],
) -> None:
    shares: dict[int, float] = {}

    def noted() -> Iterator[Item]:
        for item in given:
            shares[item.index] = item.share
            yield item

    for line in mapped(work.lines, noted(), where.backend, where.jobs, where.scheduler, work.weight):
        if results is not None:
            results.add(line)
        summary.add(line)
        tick(shares.pop(line.index), line, False)
