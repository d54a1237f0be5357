"""What a call that cannot be interrupted may cost, in nanoseconds, and the bounds on it: for one call, for a loop, and
for all calls that one question makes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass

from flint import fmpz

from exactspline.errors import ReachError

#: The longest estimate for a call into FLINT, and for a loop of such calls (which can be interrupted), in nanoseconds.
LONGEST, LONGEST_LOOP = 2_000_000_000, 10_000_000_000
#: The bound on the sum of the estimates for one question: they are upper ones, two to four times what is measured, so
#: that this is about ten seconds; and what is added to it for each further pair of segments, as two cubics need it.
QUESTION, PATCH = 20_000_000_000, 200_000_000
#: What to do about a computation that is out of reach.
REMEDY = "take curves of lower degree, or numbers of fewer digits"


@dataclass
class Budget:
    """What all parts of one question may cost together, and what remains of that, in nanoseconds.

    Estimates are drawn from it, never measured times: an answer does not depend on the machine.

    >>> budget = Budget(5 * 10**9)
    >>> with drawing_on(budget):
    ...     check_reach(10**9, lambda: "the resultant")
    >>> budget.left
    4000000000
    """

    total: int = QUESTION
    left: int = -1

    def __post_init__(self) -> None:
        if self.left < 0:
            self.left = self.total

    @property
    def spent(self) -> bool:
        """Whether nothing of any size can be paid for any more."""
        return 50 * self.left < self.total


_BUDGET: ContextVar[Budget | None] = ContextVar("budget", default=None)


@contextmanager
def drawing_on(budget: Budget) -> Iterator[Budget]:
    """In this context all estimates are drawn from one budget."""
    token = _BUDGET.set(budget)
    try:
        yield budget
    finally:
        _BUDGET.reset(token)


def check_reach(nanoseconds: int, what: Callable[[], str], longest: int = LONGEST) -> None:
    """Refuse what is estimated to take longer than that, or longer than what remains of the budget of the question:
    `ReachError`. Otherwise it is drawn from that budget.

    >>> check_reach(10**10, lambda: "the resultant")
    Traceback (most recent call last):
    exactspline.errors.ReachError: the resultant is out of reach (about 10 s); ...
    >>> with drawing_on(Budget(10**9)):
    ...     check_reach(2 * 10**9, lambda: "the resultant")
    Traceback (most recent call last):
    exactspline.errors.ReachError: the resultant (about 2 s) exceeds what remains of the bound on the whole answer; ...
    """
    budget = _BUDGET.get()
    if nanoseconds > longest:
        raise ReachError(
            f"{what()} is out of reach ({_told(nanoseconds)})", remedy=REMEDY, seconds=_seconds(nanoseconds)
        )
    if budget is not None:
        if nanoseconds > budget.left:
            raise ReachError(
                f"{what()} ({_told(nanoseconds)}) exceeds what remains of the bound on the whole answer",
                remedy=REMEDY,
                seconds=_seconds(nanoseconds),
            )
        budget.left -= nanoseconds


def affords(nanoseconds: int, longest: int = LONGEST) -> bool:
    """Whether something that need not be done can be paid for; it is then drawn from the budget."""
    budget = _BUDGET.get()
    if nanoseconds > longest or (budget is not None and nanoseconds > budget.left):
        return False
    if budget is not None:
        budget.left -= nanoseconds
    return True


def _seconds(nanoseconds: int) -> int:
    return max(1, nanoseconds // 10**9)


def _told(nanoseconds: int) -> str:
    seconds = _seconds(nanoseconds)
    if nanoseconds < 10**9:
        return "less than a second"
    return f"about {seconds} s" if seconds < 10**6 else "more than a week"


def height_bits(coefficients: Iterable[fmpz]) -> int:
    """The number of bits of the largest of some integers of FLINT.

    >>> from flint import fmpz
    >>> height_bits([fmpz(3), fmpz(-8)])
    4
    """
    return max((int(abs(x).height_bits()) for x in coefficients), default=0)
