"""What is computed when it is first asked for, also where several threads ask, or a process is forked while one does:
of the threads of a process its child has one alone, and would wait for ever for a lock that another of them held.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from contextlib import AbstractContextManager
from os import getpid
from threading import RLock
from typing import TYPE_CHECKING, Any, NoReturn, Self

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


# ---- values that do not change


_set = object.__setattr__


class Immutable:
    """An immutable value: its attributes cannot be set or deleted, and a copy of it is the value itself.

    Lazily computed attributes are stored with `fill`. Two threads that compute the same attribute store equal results,
    so that no lock is needed.

    >>> from exactspline import BSpline
    >>> BSpline.bezier([0, 1]).degree = 2
    Traceback (most recent call last):
    AttributeError: a BSpline is a value: its 'degree' cannot be set
    """

    __slots__ = ()

    def __setattr__(self, name: str, value: object) -> NoReturn:
        raise AttributeError(f"a {type(self).__name__} is a value: its {name!r} cannot be set")

    def __delattr__(self, name: str) -> NoReturn:
        raise AttributeError(f"a {type(self).__name__} is a value: its {name!r} cannot be deleted")

    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, memo: dict[int, object]) -> Self:
        return self


def fill(value: Immutable, /, **fields: object) -> None:
    """Set the attributes of a value: at construction, and to store lazily computed ones."""
    for name, content in fields.items():
        _set(value, name, content)


def setters(owner: type, *names: str) -> list[Callable[[Immutable, object], None]]:
    """What sets these slots of a class, one function for each: at the construction of values for which `fill` takes too
    long.

    >>> class Point(Immutable):
    ...     __slots__ = ("x",)
    >>> (set_x,), origin = setters(Point, "x"), Point()
    >>> set_x(origin, 0)
    >>> origin.x
    0
    """
    return [getattr(owner, name).__set__ for name in names]
