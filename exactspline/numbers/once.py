"""What is computed when it is first asked for, also where several threads ask, or a process is forked while one does:
of the threads of a process its child has one alone, and would wait for ever for a lock that another of them held.
"""

from __future__ import annotations

import functools
from contextlib import AbstractContextManager
from os import getpid
from threading import RLock
from typing import TYPE_CHECKING, Any

__all__ = ["Lock", "cached_property"]

if TYPE_CHECKING:
    from functools import cached_property  # noqa: TID251  # as checkers of types know it
else:

    class cached_property(functools.cached_property):  # noqa: N801, TID251  # a decorator
        """An attribute that is computed when it is first asked for. No lock is held meanwhile, as Python 3.11 holds one
        for all objects together: two threads may compute the same value, and both get the one that was kept first.

        >>> class Half:
        ...     @cached_property
        ...     def whole(self):
        ...         return object()
        >>> half = Half()
        >>> half.whole is half.whole
        True
        """

        def __get__(self, instance: Any, owner: type | None = None) -> Any:
            if instance is None:
                return self
            kept = vars(instance)
            return kept[self.attrname] if self.attrname in kept else kept.setdefault(self.attrname, self.func(instance))


class Lock:
    """A lock that one thread at a time holds, also more than once; in a forked child nobody holds it.

    >>> lock = Lock()
    >>> with lock.held(), lock.held():
    ...     pass
    """

    def __init__(self) -> None:
        self._lock, self._process = RLock(), getpid()

    def held(self) -> AbstractContextManager[object]:
        """While this is entered no other thread of this process holds the lock."""
        if self._process != getpid():
            self._lock, self._process = RLock(), getpid()
        return self._lock
