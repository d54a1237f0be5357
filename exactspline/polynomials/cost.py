"""Limits on the estimated cost, in nanoseconds, of calls that cannot be interrupted: for one call, for a loop, and for
all calls made to answer one question.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field
from functools import cache, partial, wraps
from operator import methodcaller
from typing import Any, Generic, ParamSpec, TypeVar

from flint import fmpq, fmpz, fmpz_poly

from exactspline.errors import ReachError, as_integer
from exactspline.numbers.once import while_set

V = TypeVar("V")
P = ParamSpec("P")
#: The largest estimate allowed for a call into FLINT, and for a loop of such calls (which can be interrupted), in
#: nanoseconds.
LONGEST, LONGEST_LOOP = 2_000_000_000, 10_000_000_000
#: The bound on the sum of the estimates for one question, about ten seconds, because estimates are two to four times
#: the measured times; and the addition to the bound for each further pair of segments, as needed for two cubics.
QUESTION, PATCH = 20_000_000_000, 200_000_000
#: The seconds of processor time of a thread; in a browser, which has one thread, those of the process.
thread_time = getattr(time, "thread_time", time.process_time)
#: Advice for a computation that is too expensive.
REMEDY = "take curves of lower degree, or numbers of fewer digits"


@dataclass
class Budget:
    """The limit on the total cost of all parts of one question, and the remaining part of it, in nanoseconds.

    Estimates are deducted from it, never measured times, so that answers do not depend on the machine.

    >>> budget = Budget(5 * 10**9)
    >>> with drawing_on(budget):
    ...     check_reach(10**9, lambda: "the resultant")
    >>> budget.remaining
    4000000000
    """

    total: int = QUESTION
    remaining: int = -1
    #: The values, each computed once, that have been paid from this budget.
    paid: set[Priced[Any]] = field(default_factory=set, repr=False, compare=False)

    def __post_init__(self) -> None:
        if self.remaining < 0:
            self.remaining = self.total

    def pay(self, known: Priced[V]) -> None:
        """Deduct the cost at which a known value was computed, and the costs of the values that it uses, each once.

        Raises `ReachError` if this exceeds the remaining budget.
        """
        due: list[Priced[Any]] = [known]
        while due:
            each = due.pop()
            if each not in self.paid:
                self.paid.add(each)
                self.deduct(each.cost, lambda: "a value that is known")
                due += each.uses

    def deduct(self, nanoseconds: int, what: Callable[[], str]) -> None:
        """Deduct an estimate; raises `ReachError` if it exceeds the remaining budget."""
        if nanoseconds > self.remaining:
            problem = f"{what()} ({_duration(nanoseconds)}) exceeds the rest of the bound on the whole answer"
            raise ReachError(problem, remedy=REMEDY, seconds=_seconds(nanoseconds))
        self.remaining -= nanoseconds

    @property
    def spent(self) -> bool:
        """Whether less than a fiftieth of the budget remains."""
        return 50 * self.remaining < self.total


class Priced(Generic[V]):
    """A value that is computed once. The cost of the value is stored, so that every question that uses the value pays
    for it: whether a question is answered within its budget must not depend on earlier questions.

    >>> known = Priced(lambda: check_reach(10**9, lambda: "the resultant"))
    >>> with drawing_on(Budget(5 * 10**9)) as budget:
    ...     known.value, known.value
    (None, None)
    >>> budget.remaining
    4000000000
    """

    def __init__(self, compute: Callable[[], V]) -> None:
        self.cost, self.uses = 0, set[Priced[Any]]()
        with while_set(_COMPUTED, self):
            self._value = compute()
        if budget := _BUDGET.get():
            budget.paid.add(self)

    @property
    def value(self) -> V:
        """The value, paid from the budget of the question. Raises `ReachError` if its cost exceeds the remaining
        budget.
        """
        if within := _COMPUTED.get():
            within.uses.add(self)
        if budget := _BUDGET.get():
            budget.pay(self)
        return self._value


def at_its_cost(function: Callable[P, V]) -> Callable[P, V]:
    """A cache like `functools.cache`, in which every question that uses a value pays its cost."""
    known: Callable[..., Priced[V]] = cache(lambda *given, **named: Priced(partial(function, *given, **named)))

    @wraps(function)
    def call(*given: P.args, **named: P.kwargs) -> V:
        return known(*given, **named).value

    return call


class _TimeIsUp(BaseException):  # not an `ExactSplineError`, which a step might catch and store as its own result
    """The processor time allowed by the user is over."""


_BUDGET: ContextVar[Budget | None] = ContextVar("budget", default=None)
#: The time at which the processor time allowed by the user is over.
_END: ContextVar[float | None] = ContextVar("end of the time allowed", default=None)
#: The value that is being computed.
_COMPUTED: ContextVar[Priced[Any] | None] = ContextVar("computed", default=None)


@contextmanager
def drawing_on(budget: Budget) -> Iterator[Budget]:
    """A context in which all estimates are deducted from one budget."""
    with while_set(_BUDGET, budget), while_set(_COMPUTED, None):
        yield budget


@contextmanager
def bounded() -> Iterator[Budget]:
    """A context in which there is a budget: the present budget or, if there is none, a new one."""
    if budget := _BUDGET.get():
        yield budget
    else:
        with drawing_on(Budget()) as new:
            yield new


@contextmanager
def within_seconds(limit: float | None) -> Iterator[None]:
    """A context for computations that may take `limit` seconds of processor time of the thread that enters it (None: no
    limit). The time is checked wherever a cost is estimated.

    >>> with within_seconds(0):
    ...     check_reach(10**9, lambda: "the resultant")
    Traceback (most recent call last):
    exactspline.errors.ReachError: not decided within 0 s of processor time; raise the limit

    Raises `ReachError` when the time is over.
    """
    seconds = limit if limit is None or isinstance(limit, float) else as_integer(limit, "a number of seconds", 0)
    try:
        with while_set(_END, None if seconds is None else thread_time() + seconds):
            yield
    except _TimeIsUp:
        raise ReachError(
            f"not decided within {limit} s of processor time", remedy="raise the limit", seconds=limit
        ) from None


def look_at_the_time() -> None:
    """Leave the context of `within_seconds` when its time is over."""
    if (end := _END.get()) is not None and thread_time() > end:
        raise _TimeIsUp


def check_reach(nanoseconds: int, what: Callable[[], str], longest: int = LONGEST) -> None:
    """Raise `ReachError` if an estimate exceeds `longest`, or the remaining budget of the question; otherwise deduct it
    from this budget.

    >>> check_reach(10**10, lambda: "the resultant")
    Traceback (most recent call last):
    exactspline.errors.ReachError: the resultant would take too long (about 10 s); ...
    >>> with drawing_on(Budget(10**9)):
    ...     check_reach(2 * 10**9, lambda: "the resultant")
    Traceback (most recent call last):
    exactspline.errors.ReachError: the resultant (about 2 s) exceeds the rest of the bound on the whole answer; ...
    """
    look_at_the_time()
    if nanoseconds > longest:
        raise ReachError(
            f"{what()} would take too long ({_duration(nanoseconds)})", remedy=REMEDY, seconds=_seconds(nanoseconds)
        )
    if budget := _BUDGET.get():
        budget.deduct(nanoseconds, what)
    if within := _COMPUTED.get():
        within.cost += nanoseconds


def affords(nanoseconds: int, longest: int = LONGEST) -> bool:
    """Whether an optional computation is within the limits; if so, its estimate is deducted from the budget."""
    look_at_the_time()
    budget = _BUDGET.get()
    if nanoseconds > longest or (budget is not None and nanoseconds > budget.remaining):
        return False
    if budget is not None:
        budget.remaining -= nanoseconds
    if within := _COMPUTED.get():
        within.cost += nanoseconds
    return True


def _seconds(nanoseconds: int) -> int:
    return max(1, nanoseconds // 10**9)


def _duration(nanoseconds: int) -> str:
    seconds = _seconds(nanoseconds)
    if nanoseconds < 10**9:
        return "less than a second"
    return f"about {seconds} s" if seconds < 10**6 else "more than a week"


def height_bits(coefficients: Iterable[fmpz | fmpq | fmpz_poly]) -> int:
    """The number of bits of the largest absolute value among FLINT integers, among the numerators and denominators of
    FLINT rationals, or among the coefficients of polynomials.

    >>> from flint import fmpq, fmpz, fmpz_poly
    >>> height_bits([fmpz(3), fmpz(-8)]), height_bits([fmpq(1, 16)])
    (4, 5)
    """
    return max(map(methodcaller("height_bits"), coefficients), default=0)
