"""Immutable values: objects that do not change after construction."""

from __future__ import annotations

from collections.abc import Callable
from typing import NoReturn, Self

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
