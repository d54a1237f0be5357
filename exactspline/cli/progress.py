"""Progress: on a terminal a bar, for what takes longer than half a second; elsewhere a line every ten seconds."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from itertools import count
from threading import Timer
from time import monotonic
from typing import TYPE_CHECKING, TypeVar

from exactspline.cli.output import is_quiet

if TYPE_CHECKING:
    from rich.progress import Progress

__all__ = ["bar", "seldom", "ticking", "tracked"]

V = TypeVar("V")
#: Seconds before a bar is shown, and between two lines where there is no terminal.
DELAY, BETWEEN = 1 / 2, 10


@contextmanager
def bar(*columns: object) -> Iterator[Progress | None]:
    """A bar on standard error that is shown after half a second; None in a pipe and with ``--quiet``."""
    if is_quiet() or not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import Progress

    made = Progress(*columns, console=Console(stderr=True), transient=True)  # type: ignore[arg-type]  # columns of rich
    delay = Timer(DELAY, made.start)
    delay.daemon = True
    delay.start()
    try:
        yield made
    finally:
        delay.cancel()
        delay.join()
        made.stop()


@contextmanager
def ticking(label: str, total: int) -> Iterator[Callable[[], None]]:
    """A function whose every call advances a bar by one of `total` steps."""
    with bar() as shown:
        if shown is None:
            write, done = seldom(), count(1)
            yield lambda: write(f"{label}: {next(done)} of {total}")
            return
        from rich.markup import escape

        from exactspline.display.wrapping import visible

        task = shown.add_task(escape(visible(label)), total=total)
        yield lambda: shown.advance(task)


def seldom() -> Callable[[str], None]:
    """What writes a line on standard error, at most one every ten seconds; none with ``--quiet``."""
    last = monotonic()

    def write(line: str) -> None:
        nonlocal last
        if monotonic() - last >= BETWEEN and not is_quiet():
            last = monotonic()
            print(line, file=sys.stderr, flush=True)

    return write


def tracked(calls: Sequence[Callable[[], V]], label: str) -> list[V]:
    """The results of the calls, with a progress bar."""
    with ticking(label, len(calls)) as tick:
        found = []
        for call in calls:
            found.append(call())
            tick()
        return found
