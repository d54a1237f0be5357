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
from typing import TYPE_CHECKING

from exactspline.cli.common import check_approximate, with_distance
from exactspline.cli.output import INTERRUPTED, Exit, OptionsError, Output, bar, leave_out, printing, seldom, to_stderr
from exactspline.display.sheet import Sheet
from exactspline.errors import CurveFileError, counted

if TYPE_CHECKING:
    from exactspline.batch.corpus import Source
    from exactspline.batch.lines import Line, Summary

Tick = Callable[[float, "Line", bool], None]


def _findable() -> list[str]:
    """What completes the option ``--find``."""
    from exactspline.batch.inspections import asked_by_sweeps

    return [*asked_by_sweeps(), "all"]


@printing
def sweep(
    out: Output,
    corpus: list[str] | None = None,
    random: list[str] | None = None,
    find: list[str] | None = None,
    claim: list[str] | None = None,
    digits: int = 10,
    values: bool = False,
    surfaces: bool = False,
    approximate: str = "",
    epsilon: str = "",
    output: str = "",
    jobs: int = 1,
    backend: str = "processes",
    scheduler: str = "",
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
