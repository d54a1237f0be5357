"""Work in forked processes: each starts from the state of this one, may change anything, and ends."""

from __future__ import annotations

import json
import os
import resource
import signal
import sys
from collections.abc import Callable, Iterable, Iterator
from tempfile import TemporaryFile
from time import monotonic, sleep
from typing import Any, TypeVar

Task = TypeVar("Task")
Result = dict[str, Any]
#: The memory limit of a forked process: a mutant may never stop allocating.
MEMORY = 3 << 30


def forked(
    tasks: Iterable[Task], work: Callable[[Task], Result], seconds: float, jobs: int
) -> Iterator[tuple[Task, Result]]:
    """The result of `work` for every task, in the order in which they finish; ``{"verdict": "timeout"}`` where it takes
    longer than this many seconds.
    """
    waiting = iter(tasks)
    running: dict[int, tuple[Task, Any, float]] = {}
    more = True
    while more or running:
        while more and len(running) < jobs:
            task = next(waiting, None)
            if task is None:
                more = False
                break
            file = TemporaryFile("w+", encoding="utf-8")  # noqa: SIM115 (closed when the child is done)
            if not (child := os.fork()):
                _child(task, work, file)
            running[child] = task, file, monotonic()
        for child, (task, file, start) in list(running.items()):
            done, status = os.waitpid(child, os.WNOHANG)
            late = monotonic() - start > seconds
            if not done and not late:
                continue
            if not done:
                os.killpg(child, signal.SIGKILL)
                os.waitpid(child, 0)
            del running[child]
            file.seek(0)
            text = file.read()
            file.close()
            result = json.loads(text) if text else _silent(done, status)
            yield task, {**result, "seconds": round(monotonic() - start, 2)}
        sleep(0.005)


def _silent(done: int, status: int) -> Result:
    """The result of a process that returned none: it took too long, or it crashed."""
    if not done:
        return {"verdict": "timeout"}
    endless = os.WIFSIGNALED(status) and os.WTERMSIG(status) == signal.SIGPROF
    return {"verdict": "killed", "by": "a test does not end" if endless else f"crash, status {status}"}


def end_after(seconds: float) -> None:
    """End this process after this many seconds of processor time, unless the limit is changed before."""
    signal.signal(signal.SIGPROF, signal.SIG_DFL)
    signal.setitimer(signal.ITIMER_PROF, seconds)


def _child(task: Any, work: Callable[[Any], Result], file: Any) -> None:
    """Never returns."""
    os.setpgid(0, 0)
    nothing = os.open(os.devnull, os.O_RDWR)
    for stream in (0, 1, 2):
        os.dup2(nothing, stream)
    sys.setrecursionlimit(3000)
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    try:
        json.dump(work(task), file)
        file.flush()
    except BaseException as error:
        file.seek(0)
        file.truncate()
        json.dump({"verdict": "broken", "by": repr(error)[:200]}, file)
        file.flush()
    finally:
        os._exit(0)
