"""What not every operating system has: locks, limits of a process, signals that are held back, new parents of orphans.

Where the system has none of them nothing happens, and what was asked is done without.
"""

from __future__ import annotations

import gc
import os
import signal
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

#: Whether a process can be given a limit of memory and of processor time, and the exit status of one that has used up
#: its time.
LIMITS = sys.platform != "win32"
OUT_OF_TIME = -getattr(signal, "SIGXCPU", 24)
#: Seconds between two checks whether the process that started this one is still running.
LOOK = 1


def lock(handle: int | None) -> bool:
    """Keep other processes from locking what was opened under this number, until it is closed or this process ends;
    whether none of them has locked it.
    """
    try:
        import fcntl

        if handle is not None:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except (ImportError, BlockingIOError) as error:
        return isinstance(error, ImportError)
    return True


def open_folder(place: Path) -> int | None:
    """A number for a folder, to be locked and closed; `None` where folders cannot be opened.

    Raises `OSError`.
    """
    return None if sys.platform == "win32" else os.open(place, os.O_RDONLY)


def limit(memory: int, seconds: int) -> None:
    """Limit the memory of this process, in bytes, and its processor time: it is killed when that is used up."""
    try:
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))  # killed without a reason at the second
    except (ImportError, ValueError, OSError):
        pass


@contextmanager
def collector_quiet() -> Iterator[None]:
    """Within this context unused cycles of objects are not searched for: where very many objects are made that stay,
    each search looks at all of them.

    >>> with collector_quiet():
    ...     gc.isenabled()
    False
    """
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()


@contextmanager
def interrupts_ignored() -> Iterator[None]:
    """Start processes that ignore Ctrl-C, which the terminal sends to all. Child processes inherit that the signal is
    blocked; here it is served afterwards.
    """
    if threading.current_thread() is not threading.main_thread() or not hasattr(signal, "pthread_sigmask"):
        yield
        return
    from multiprocessing import resource_tracker  # there is none in a browser

    # Python's tracker of resources unblocks the signal when it starts: it has to be there before
    resource_tracker.ensure_running()
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def end_with(parent: int) -> None:
    """End this process soon after the process that started it was killed, also before there was any work: nothing else
    would. Nothing is done where orphans keep their parent (Windows).
    """

    def watch() -> None:
        while os.getppid() == parent:
            time.sleep(LOOK)
        os._exit(1)

    threading.Thread(target=watch, name="parent", daemon=True).start()
