"""The sweep: one line per curve of a corpus, in order."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from exactspline.batch.backends import check_backend, mapped
from exactspline.batch.corpus import Source, items
from exactspline.batch.lines import Line
from exactspline.batch.work import DIGITS, Work
from exactspline.errors import as_integer, as_text
from exactspline.splines.nurbs import Nurbs


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
) -> Iterator[Line]:
    """The features of each of many curves, one line per curve, in order, one at a time. A source is a curve, the name
    of a file, a folder, a font or an example, or a `Family` of random curves. `find` names the questions to ask
    (`asked_by_sweeps`), `claims` the claims to check, by id; with `values` every point that is found has its
    coordinates and the curvature, as correctly rounded doubles; `backend` is one of `BACKENDS`. A curve that cannot be
    read or handled yields a line with its error.

    Plane curves are read and computed in groups, the first of 16, later ones of up to 512: the generator computes ahead
    by the rest of a group, with several processes by up to 4096 curves each.

    >>> for line in sweep(["circle", "six_segment_cubic"], find=["turning_points:0"]):
    ...     print(line.curve, [each.low for each in line.found["turning_points:0"]])
    circle ['0', '2']
    six_segment_cubic ['1.9264459962', '5.1715728752']

    Raises `FormulaError`, `ClaimError` or `BackendError` for unknown names, before anything is computed.
    """
    jobs, scheduler = as_integer(jobs, "a number of processes", 1), as_text(scheduler, "the address of a scheduler")
    work = Work.of(find, claims, digits, values)
    check_backend(backend)
    given = [curves] if isinstance(curves, (Nurbs, str)) or not isinstance(curves, Iterable) else curves
    return mapped(work.lines, items(given), backend, jobs, scheduler, work.weight)
