"""Attributes and locks for values that are computed when first needed, by several threads or in forked processes. A
forked child has only one of the threads of its parent, and would wait forever for a lock held by another thread.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from contextvars import ContextVar
from os import getpid
from threading import RLock
from typing import TYPE_CHECKING, Any, NoReturn, Self, TypeVar

__all__ = ["Lock", "cached_property"]

if TYPE_CHECKING:
    from functools import cached_property  # noqa: TID251  # for type checkers
else:

    class cached_property(functools.cached_property):  # noqa: N801, TID251  # a decorator
        """An attribute that is computed when first needed. No lock is held during the computation, unlike in Python
        3.11, which holds one lock for all objects: two threads may compute the same value, and both get the value that
        was stored first.

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
    """A lock that one thread at a time can hold, also more than once; in a forked child no thread holds it.

    >>> lock = Lock()
    >>> with lock.held(), lock.held():
    ...     pass
    """

    def __init__(self) -> None:
        self._lock, self._process = RLock(), getpid()

    def held(self) -> AbstractContextManager[object]:
        """A context in which no other thread of this process holds the lock."""
        if self._process != getpid():
            self._lock, self._process = RLock(), getpid()
        return self._lock


V = TypeVar("V")


@contextmanager
def while_set(variable: ContextVar[V], value: V) -> Iterator[V]:
    """A context in which a variable has a value; afterwards it has again the one that it had before.

    >>> depth = ContextVar("depth", default=0)
    >>> with while_set(depth, 1):
    ...     depth.get()
    1
    >>> depth.get()
    0
    """
    token = variable.set(value)
    try:
        yield value
    finally:
        variable.reset(token)


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
    """Functions that set these slots of a class, one function for each slot. These functions are used in constructors
    for which `fill` is too slow.

    >>> class Point(Immutable):
    ...     __slots__ = ("x",)
    >>> (set_x,), origin = setters(Point, "x"), Point()
    >>> set_x(origin, 0)
    >>> origin.x
    0
    """
    return [getattr(owner, name).__set__ for name in names]
