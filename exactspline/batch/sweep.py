"""The sweep: one line per curve of a corpus, in order. With results on disk, existing lines are read and compared with
the corpus, and missing lines are computed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import takewhile
from pathlib import Path
from typing import Any

from exactspline.batch.backends import check_backend, mapped
from exactspline.batch.corpus import CURVES, Item, Problem, Source, Taken, items
from exactspline.batch.lines import VERSION, Line
from exactspline.batch.results import JsonLines, Parquet, Results, ResultsError, Settings
from exactspline.batch.summary import Summary
from exactspline.batch.work import DIGITS, SurfaceWork, Work
from exactspline.errors import ShapeError, as_integer, as_text, as_texts
from exactspline.numbers.exact import Number
from exactspline.one_line import OneLine
from exactspline.release import releases
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface


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
) -> Work | SurfaceWork:
    """The work on each curve, or each surface, that the arguments of `sweep` describe."""
    if not taken.surfaces:
        return Work.of(find, claims, digits, values)
    if as_texts(claims, "ids of claims", "the id of a claim"):
        raise ShapeError("a sweep of surfaces with claims", remedy="prove --surface checks claims on surfaces")
    if values:
        raise ShapeError("a sweep of surfaces with values", remedy="ask for them at places, as in value@1/2,1/3")
    return SurfaceWork.of(find, digits)


@dataclass(frozen=True, repr=False)
class Where(OneLine):
    """The place where a sweep is computed: see `exactspline.batch.backends.mapped`."""

    backend: str = "processes"
    jobs: int = 1
    scheduler: str = ""


def _settings(sources: Sequence[Source], work: Work | SurfaceWork, taken: Taken = CURVES) -> dict[str, object]:
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
    work: Work | SurfaceWork,
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
    work: Work | SurfaceWork,
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
