"""A sweep with its results on disk: existing lines are read and compared with the corpus, missing ones are computed."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import takewhile
from pathlib import Path

from exactspline.batch.backends import mapped
from exactspline.batch.corpus import Item, Problem, Source, items
from exactspline.batch.lines import VERSION, Line
from exactspline.batch.parquet import Parquet
from exactspline.batch.results import JsonLines, Results, ResultsError, Settings
from exactspline.batch.summary import Summary
from exactspline.batch.work import Work
from exactspline.splines.nurbs import Nurbs


@dataclass(frozen=True)
class Where:
    """Where a sweep is computed: see `exactspline.batch.backends.mapped`."""

    backend: str = "processes"
    jobs: int = 1
    scheduler: str = ""


def settings(sources: Sequence[Source], work: Work) -> dict[str, object]:
    """The settings on which results depend: a sweep may only be continued with the same ones."""
    return {
        "schema": "exactspline/sweep_line",
        "version": VERSION,
        "corpus": [source.name if isinstance(source, Nurbs) else str(source) for source in sources],
        "find": list(work.find),
        "claims": [list(claim) for claim in work.claims],
        "digits": work.digits,
        "values": work.values,
    }


def recorded(
    sources: Sequence[Source],
    work: Work,
    where: Where,
    output: str,
    summary: Summary,
    tick: Callable[[float, Line, bool], None] = lambda *_: None,
    stopped: Callable[[], bool] = lambda: False,
) -> None:
    """Sweep a corpus into a file (`opened`), or nowhere, and count all of its lines.

    If the file exists, its lines are counted and the sweep continues after them. `tick` is called with the fraction of
    the corpus that is done, the line, and whether it existed before. Once `stopped` returns true, no further curve is
    started; those in progress are finished.

    Raises `ResultsError` where the results cannot be written or belong to another corpus.
    """
    given = takewhile(lambda _: not stopped(), items(sources))
    if not output:
        _compute(given, work, where, None, summary, tick)
        return
    with opened(output, settings(sources, work)) as results:
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
    """Whether a line is about a curve of the corpus, as it is now."""
    problem = item.given if isinstance(item.given, Problem) else line.error
    return (item.source, item.name, item.digest, problem) == (line.source, line.curve, line.curve_digest, line.error)


def opened(place: str, settings: Settings) -> Results:
    """Results at a place, new or continued: Parquet for ``*.parquet``, JSON Lines otherwise.

    Raises `ResultsError`, also where pyarrow is needed and missing.
    """
    if place.endswith(".parquet"):
        return Parquet(Path(place), settings)
    return JsonLines(Path(place), settings)


def _compute(
    given: Iterator[Item],
    work: Work,
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
