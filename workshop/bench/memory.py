"""The peak resident size of sweeps over more and more curves, which must not grow, and of bisector surfaces."""

from __future__ import annotations

from collections.abc import Iterator

from workshop.bench import alone
from workshop.bench.row import OURS, Options, Row, bounded

MEMORY = "memory"
#: Random cubics of a sweep; the last number in a full run only.
COUNTS = (1_000, 10_000, 100_000)
#: The limit on the processor time of the longest sweep is at least this many seconds.
LONGEST = 600
#: A sweep may grow by this many MB: the heap of Python and of the libraries settles in the first thousands of curves.
GROWTH = 5


def memory_rows(options: Options) -> Iterator[Row]:
    """Sweeps into a file, in one process and in two, and bisector surfaces, each in a separate process."""
    counts = COUNTS if options.full else COUNTS[:-1]
    for jobs, where in ((1, "1 process"), (2, "the first of 3 processes")):
        sizes = []
        for count in counts if jobs == 1 else counts[:2]:
            took = alone.run("sweep", count, max(options.limit, LONGEST if options.full else 0), jobs)
            note = took.note or f"{1000 * (took.seconds or 0) / count:.2f} ms of its processor time a curve"
            case = f"by how much a sweep of {count} random cubics enlarges {where}"
            yield Row(MEMORY, case, OURS, took.megabytes, "MB", note=note)
            sizes.append(took.megabytes)
        first, last = sizes[0], sizes[-1]
        grown = None if first is None or last is None else last - first
        most = counts[-1] if jobs == 1 else counts[1]
        yield bounded(MEMORY, f"growth from {counts[0]} cubics to {most}, {where}", grown, "MB", GROWTH)
    for degree in (3, 6):
        took = alone.run("bisector", degree, options.limit)
        case = f"bisector surface of two rational curves of degree {degree}, 4 × 4 segments"
        yield Row(MEMORY, case, OURS, took.megabytes, "MB", note=took.note)
