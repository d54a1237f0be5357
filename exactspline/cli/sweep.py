"""``sweep``: many curves, or many surfaces, one line for each."""

from __future__ import annotations

import logging
import signal
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING, Annotated

from exactspline.cli.common import Approximate, check_approximate, with_distance
from exactspline.cli.output import (
    INTERRUPTED,
    Argument,
    Exit,
    Option,
    OptionsError,
    Output,
    bar,
    leave_out,
    printing,
    seldom,
    to_stderr,
)
from exactspline.display.sheet import Sheet
from exactspline.errors import CurveFileError, counted

if TYPE_CHECKING:
    from exactspline.batch.corpus import Source
    from exactspline.batch.lines import Line, Summary

Tick = Callable[[float, "Line", bool], None]


def _completed(given: str) -> list[str]:
    """The example curves whose names begin with a text; the shell itself completes names of files."""
    from exactspline.interchange.examples import example_names

    return [name for name in example_names() if name.startswith(given)]


def _inspections(given: str) -> list[str]:
    from exactspline.batch.inspections import asked_by_sweeps

    return [name for name in [*asked_by_sweeps(), "all"] if name.startswith(given)]


def _backends(given: str) -> list[str]:
    from exactspline.batch.backends import BACKENDS

    return [name for name in BACKENDS if name.startswith(given)]


Corpus = Annotated[
    list[str] | None,
    Argument(
        metavar="CORPUS",
        help="Files of curves in any readable format, folders of such files, fonts (every contour of every "
        "glyph), and names of example curves; with --surfaces files of surfaces and names of example "
        "surfaces.",
        completion=_completed,
    ),
]
Random = Annotated[
    list[str] | None,
    Option(
        "--random",
        metavar="WORDS",
        help="Random curves, described by words such as degree=2-5 segments=1-4 dimension=2 "
        "rational=no|yes|half bits=10 count=100 seed=1, separated by spaces or commas. May be "
        "repeated if commas separate the words.",
    ),
]
Find = Annotated[
    list[str] | None,
    Option(
        "--find",
        metavar="WHAT",
        help="A question about points, joints or pieces (see `list questions`), or all: every such "
        "question without an argument. An argument follows after a colon, as in offset_cusps:1/10. "
        "With --surfaces, a question about surfaces, also at parameters, as in value@1/2,1/3. May be "
        "repeated. [default: inflections, curvature_extrema, corners; all about surfaces]",
        completion=_inspections,
    ),
]
Claims = Annotated[
    list[str] | None, Option("--claim", metavar="ID", help="Check a claim on every curve (see prove). May be repeated.")
]
Places = Annotated[
    int, Option("--digits", metavar="N", min=0, max=10_000, help="The number of digits of irrational parameters.")
]
Values = Annotated[
    bool,
    Option(
        "--values", help="Also write the coordinates and the curvature of every point, as correctly rounded doubles."
    ),
]
Surfaces = Annotated[
    bool, Option("--surfaces", help="Take the surfaces of the corpus, and report the curves as skipped.")
]
Epsilon = Annotated[
    str,
    Option(
        "--epsilon",
        metavar="E",
        help="Also consider all curves (surfaces) whose control points and weights differ by at most E "
        "from those of the given one: find the features that each of them has, and the features that "
        "some of them may have. E also answers the questions of --find that end in _within. E is a "
        "number, or 'written', which means half a unit of the last digit.",
    ),
]
OutputFile = Annotated[
    str,
    Option(
        "--output",
        "-o",
        metavar="FILE",
        help="The file for the lines: JSON Lines, or Parquet (a folder of parts) for *.parquet; - for standard output, "
        "without a summary. If FILE exists, the sweep continues after its last complete line.",
    ),
]
Jobs = Annotated[int, Option("--jobs", "-j", metavar="N", min=1, max=4096, help="The number of processes.")]
Backend = Annotated[
    str,
    Option(
        "--backend",
        metavar="NAME",
        help="Where the curves are computed: serial, processes or dask.",
        completion=_backends,
    ),
]
Scheduler = Annotated[
    str, Option("--scheduler", metavar="ADDRESS", help="The Dask cluster to use. [default: one on this machine]")
]


@printing
def sweep(
    out: Output,
    corpus: Corpus = None,
    random: Random = None,
    find: Find = None,
    claim: Claims = None,
    digits: Places = 10,
    values: Values = False,
    surfaces: Surfaces = False,
    approximate: Approximate = "",
    epsilon: Epsilon = "",
    output: OutputFile = "",
    jobs: Jobs = 1,
    backend: Backend = "processes",
    scheduler: Scheduler = "",
) -> None:
    """Find the features of many curves or surfaces, or the verdicts of claims on many curves. The output has one line
    for each curve or surface, in order, and a summary. A curve or surface that cannot be read gives a line with the
    error. After an interruption, the same command continues where the sweep stopped.
    """
    from exactspline.batch.backends import check_backend
    from exactspline.batch.corpus import Family, Taken
    from exactspline.batch.inspections import USUAL
    from exactspline.batch.lines import Summary
    from exactspline.batch.sweep import Where, sweep_into_file, work_of

    check_approximate(approximate)
    if epsilon:
        usual = ("shapes_within", "umbilics_within") if surfaces else ("features_within", "self_intersections_within")
        find = with_distance(find or (["all"] if surfaces else USUAL), epsilon, usual)
    taken = Taken.of(surfaces=surfaces, approximate=approximate or None)
    if surfaces and random:
        raise OptionsError("--random and --surfaces", remedy="omit one of them: the families are of curves")
    sources, work = _sources(corpus or [], random or []), work_of(taken, find, claim or (), digits, values)
    check_backend(backend)
    # the remarks of fontTools on dates in fonts do not concern outlines
    logging.getLogger("fontTools").setLevel(logging.ERROR)
    families = frozenset(str(source) for source in sources if isinstance(source, Family))
    summary, where, to_stdout = Summary(families), Where(backend, jobs, scheduler), output == "-"
    start = monotonic()
    with _interruptible(jobs > 1) as stopped:
        with _progress() as tick:
            reported = _printing(tick) if to_stdout else tick
            sweep_into_file(sources, work, where, "" if to_stdout else output, summary, reported, stopped, taken)
        interrupted = stopped()
    if interrupted:
        goes_on = f"; the same command continues after them in {output}" if output and not to_stdout else ""
        to_stderr(f"interrupted after {counted(summary.lines, 'surface' if surfaces else 'curve')}{goes_on}")
        raise Exit(INTERRUPTED)
    if not to_stdout:
        seconds = monotonic() - start
        out.give("sweep", _rows(summary), [_sheet(summary)], lambda: _print(out, summary, seconds))
    if summary.errors or not summary.all_decided:
        leave_out()
    if not summary.as_expected:
        raise Exit(1)
    if not summary.all_read:
        raise Exit(2)


def _sources(corpus: Sequence[str], random: Sequence[str]) -> list[Source]:
    """The curves to sweep. Words of a family that are separate (``--random degree=5 count=100``) arrive among the
    files.
    """
    from exactspline.batch.corpus import Family, is_word

    words = [word for word in corpus if random and is_word(word) and not Path(word).exists()]
    if words and len(random) > 1:
        raise CurveFileError(f"it is unclear to which --random {words[0]} belongs", remedy="join its words by commas")
    families = [Family.parsed([*text.replace(",", " ").split(), *words]) for text in random]
    sources: list[Source] = [*[word for word in corpus if word not in words], *families]
    if not sources:
        raise CurveFileError("there is nothing to sweep", remedy="name files, folders, fonts, or a family by --random")
    return sources


def _printing(tick: Tick) -> Tick:
    """Lines on standard output."""
    from exactspline.batch.results import line_text

    def printed(share: float, line: Line, known: bool) -> None:
        sys.stdout.write(line_text(line))
        tick(share, line, known)

    return printed


@contextmanager
def _interruptible(several: bool) -> Iterator[Callable[[], bool]]:
    """Handle Ctrl-C. Pressed once, the curve in progress is finished and written. Pressed twice, or with `several`
    processes, the curves in progress are dropped, and computed when the sweep continues.
    """
    presses = 0

    def pressed(*_: object) -> None:
        nonlocal presses
        presses += 1
        if presses > 1 or several:
            threading.excepthook = lambda _: None  # the threads that watch over the processes would report their end
            raise KeyboardInterrupt
        to_stderr("")
        to_stderr("finishing the curves in progress; press Ctrl-C again to drop them")

    try:
        before = signal.signal(signal.SIGINT, pressed)
    except ValueError:  # not the main thread
        yield lambda: False
        return
    try:
        yield lambda: presses > 0
    except KeyboardInterrupt:
        to_stderr("interrupted; what has been written is kept")
        raise Exit(INTERRUPTED) from None
    finally:
        signal.signal(signal.SIGINT, before)


@contextmanager
def _progress() -> Iterator[Tick]:
    """A bar on a terminal with the curves, their rate and the time left; elsewhere a line every ten seconds."""
    from rich.progress import BarColumn, TextColumn, TimeRemainingColumn

    columns = (
        TextColumn("{task.fields[curves]} curves"),
        BarColumn(),
        TextColumn("{task.percentage:>3.0f} %"),
        TextColumn("{task.fields[rate]}/s"),
        TimeRemainingColumn(),
    )
    with bar(*columns) as shown:
        if shown is None:
            write = seldom()
            yield lambda share, line, known: write(f"{line.index + 1} curves, {share:.0%}")
            return
        task = shown.add_task("", total=1, curves=0, rate="–")
        start, computed, known_share, last = monotonic(), 0, None, monotonic()

        def tick(share: float, line: Line, known: bool) -> None:
            nonlocal computed, known_share, last, start
            if known:
                known_share, start = share, monotonic()
                return
            if known_share is not None:
                shown.reset(task, total=1, curves=line.index, rate="–")
                shown.update(task, completed=known_share)
                known_share = None
            computed += 1
            if monotonic() - last > 1 / 5:
                last = monotonic()
                shown.update(task, completed=share, curves=line.index + 1, rate=f"{computed / (last - start):.0f}")

        yield tick


def _rows(summary: Summary) -> list[dict[str, object]]:
    from dataclasses import asdict

    return [{"key": f"{i}: {each.what} {each.name}".strip()} | asdict(each) for i, each in enumerate(summary.entries())]


def _sheet(summary: Summary) -> Sheet:
    numbers = ("count", "seconds")
    cells = [
        (each.what, each.name, "" if each.count is None else each.count, "" if seconds is None else f"{seconds:.3f}")
        for each in summary.entries()
        for seconds in (each.seconds,)
    ]
    return Sheet("what", "name", *numbers, rows=cells, numbers=numbers, prose=["name"], heads=2)


def _print(out: Output, summary: Summary, seconds: float) -> None:
    from exactspline.display import console

    shown = console.console()
    shown.print(_sheet(summary))
    if not out.quiet:
        console.lines(shown, f"{counted(summary.lines, 'line')} in {seconds:.1f} s")
