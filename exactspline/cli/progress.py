"""Progress bars: on a terminal only, and only for what takes longer than half a second."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from threading import Timer
from typing import TYPE_CHECKING, TypeVar

from exactspline.cli.output import is_quiet

if TYPE_CHECKING:
    from rich.progress import Progress

__all__ = ["bar", "ticking", "tracked"]

V = TypeVar("V")
#: Seconds before a bar is shown.
DELAY = 1 / 2


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
            yield lambda: None
            return
        from rich.markup import escape

        from exactspline.display.wrapping import visible

        task = shown.add_task(escape(visible(label)), total=total)
        yield lambda: shown.advance(task)


def tracked(calls: Sequence[Callable[[], V]], label: str) -> list[V]:
    """The results of the calls, with a progress bar."""
    with ticking(label, len(calls)) as tick:
        found = []
        for call in calls:
            found.append(call())
            tick()
        return found
