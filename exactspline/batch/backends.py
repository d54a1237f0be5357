"""The backends of a sweep: this process, processes of this machine, or a Dask cluster.

joblib runs the last two. The number of pending tasks is bounded, and the results come in the order of the curves.
"""

from __future__ import annotations

import os
import threading
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import BrokenExecutor
from contextlib import ExitStack, contextmanager, suppress
from importlib.util import find_spec
from itertools import chain
from typing import TYPE_CHECKING, TypeVar

from exactspline.errors import ExactSplineError, as_text, nearest
from exactspline.release import releases
from exactspline.system import end_with, interrupts_ignored

if TYPE_CHECKING:
    from distributed import Client

T = TypeVar("T")
V = TypeVar("V")

#: Name → the package that it needs besides joblib.
BACKENDS = {"serial": "", "processes": "", "dask": "distributed"}
#: The number of curves that are computed together: a few at first (`FIRST`), so that the first results come soon and
#: all processes have work, then `GROWTH` times as many as each process has had before, at most `MOST` and of a total
#: weight of about `HEAVY`.
FIRST, GROWTH, MOST, HEAVY = 16, 3, 512, 1 << 18
#: Curves of this weight are sent a few at a time, and one by one within this process, since an interruption waits for
#: the current one.
ALONE = HEAVY // FIRST
#: The limit per process of curves that are pending or whose results have not been fetched; beyond it the results are
#: fetched first.
WINDOW = 4096
#: No processes are started for this many curves of less weight than `HEAVY`: starting two takes the processor time of
#: some thousand of them.
FEW = 512
#: Groups sent to a process before a result is awaited.
PENDING = 3


class BackendError(ExactSplineError):
    """The error for a backend that does not exist or is not installed, or for a cluster that cannot be reached."""


def check_backend(name: str) -> None:
    """Raise `BackendError` if a backend is unknown or its package is missing."""
    if as_text(name, "the name of a backend") not in BACKENDS:
        raise BackendError(f"there is no backend called {name!r}", remedy=nearest(name, BACKENDS))
    if (needed := BACKENDS[name]) and find_spec(needed) is None:
        problem = f"the backend {name} needs {needed}, which is not installed"
        raise BackendError(problem, remedy=f"pip install {needed}, or use another backend")


def mapped(
    call: Callable[[list[T]], Iterable[V]],
    given: Iterable[T],
    backend: str = "serial",
    jobs: int = 1,
    scheduler: str = "",
    weight: Callable[[T], int] = lambda _: 0,
) -> Iterator[V]:
    """The results of `call` for groups of the input, in order.

    `call` may modify the list it receives. For a few items (`FEW`) no processes are started. At most `WINDOW` items
    plus one group per process are held at a time, however long the input is and however slowly the results are
    consumed; within this process the results of a group are consumed one by one. Closing the generator ends the work
    when the groups in progress are finished.

    >>> list(mapped(lambda group: [2 * x for x in group], [3, 1, 2]))
    [6, 2, 4]

    Raises `BackendError`.
    """
    check_backend(backend)
    closed = threading.Event()
    if backend == "processes" and jobs > 1:
        given, few = _counted(given, weight)
        backend = "serial" if few else backend
    if backend == "serial" or (backend == "processes" and jobs == 1):
        for group in _groups(given, weight, 1, closed, alone=ALONE):
            yield from call(group)
        return
    groups = _groups(given, weight, jobs, closed)
    from joblib import Parallel, delayed

    with ExitStack() as stack:
        with interrupts_ignored():
            stack.enter_context(_on_dask(jobs, scheduler) if backend == "dask" else _in_processes(jobs))
            sent = f"{PENDING}*{jobs}"
            parallel = stack.enter_context(Parallel(return_as="generator", batch_size=1, pre_dispatch=sent))
            for _ in parallel(delayed(int)() for _ in range(jobs)):
                pass
        for first in groups:
            window = _window(first, groups, WINDOW * jobs)
            yield from _taken(parallel(delayed(_called)(call, group) for group in window), closed)


def _counted(given: Iterable[T], weight: Callable[[T], int]) -> tuple[Iterable[T], bool]:
    """The input again, after its first items were read, and whether these items are all of it and are quickly computed.

    >>> given, few = _counted(iter([3, 1, 2]), lambda _: 1)
    >>> list(given), few
    ([3, 1, 2], True)
    """
    rest, first, heavy = iter(given), list[T](), 0
    for each in rest:
        first.append(each)
        heavy += weight(each)
        if len(first) > FEW or heavy >= HEAVY:
            return chain(first, rest), False
    return first, True


def _groups(
    given: Iterable[T], weight: Callable[[T], int], jobs: int, closed: threading.Event, alone: int = HEAVY
) -> Iterator[list[T]]:
    """The input in groups (see `FIRST`). An item of the weight `alone` ends its group. No group begins after `closed`
    is set.
    """
    group: list[T] = []
    before, heavy = 0, 0
    for each in given:
        group.append(each)
        own = weight(each)
        heavy += own
        if len(group) >= min(max(FIRST, GROWTH * before // jobs), MOST) or heavy >= HEAVY or own >= alone:
            before, heavy = before + len(group), 0
            yield group
            group = []
            if closed.is_set():
                return
    if group:
        yield group


def _window(first: list[T], groups: Iterator[list[T]], most: int) -> Iterator[list[T]]:
    """A group and those that follow it, until they hold this many items."""
    count = len(first)
    yield first
    while count < most and (group := next(groups, None)) is not None:
        count += len(group)
        yield group


def _taken(results: Iterator[list[V]], closed: threading.Event) -> Iterator[V]:
    """The results of groups. When the consumer stops, groups in progress are awaited, since killed processes print
    errors.
    """
    try:
        for group in results:
            yield from group
    except GeneratorExit:
        closed.set()
        for _ in results:
            pass
        raise


@contextmanager
def _in_processes(jobs: int) -> Iterator[None]:
    from joblib import parallel_config

    ended = {"initializer": end_with, "initargs": (os.getpid(),)}
    try:
        with parallel_config(backend="loky", n_jobs=jobs, **ended):
            yield
    except BrokenExecutor:
        raise BackendError(
            "a process was ended from outside, usually for its memory", remedy="repeat it with fewer jobs"
        ) from None


@contextmanager
def _on_dask(jobs: int, scheduler: str) -> Iterator[None]:
    """The cluster of this scheduler, or that of the current Dask client, or a local cluster; a cluster that was made
    here ends with the sweep.

    Raises `BackendError` if there is no cluster, and if a worker has other releases, since its answers may differ.
    """
    from distributed import KilledWorker
    from joblib import parallel_config

    with ExitStack() as stack:
        try:
            client = _client(stack, jobs, scheduler)
        except (OSError, ValueError) as error:
            raise BackendError(f"no Dask scheduler at {scheduler}: {error}", remedy="name a running one") from None
        for worker, own in client.run(releases).items():
            if own != releases():
                raise BackendError(f"{worker} has {own}", remedy=f"install {releases()} there")
        stack.enter_context(parallel_config(backend="dask", client=client, n_jobs=jobs))
        try:
            yield
        except KilledWorker as error:
            raise BackendError(f"workers ended again and again: {error}", remedy="give each more memory") from None


def _client(stack: ExitStack, jobs: int, scheduler: str) -> Client:
    from distributed import Client, LocalCluster

    if not scheduler:
        with suppress(ValueError):
            return Client.current()
    local = None if scheduler else LocalCluster(n_workers=jobs, threads_per_worker=1, dashboard_address=":0")
    if local is not None:
        stack.enter_context(local)
    return stack.enter_context(Client(scheduler or local, set_as_default=False))


def _called(call: Callable[[list[T]], Iterable[V]], group: list[T]) -> list[V]:
    return list(call(group))
