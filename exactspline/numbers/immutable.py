"""Values: objects that are made once and never change."""

from __future__ import annotations

from typing import NoReturn, Self

_set = object.__setattr__


class Immutable:
    """A value: nothing of it can be set or deleted, a copy of it is the value itself.

    What is computed lazily is kept by `fill`; two threads that compute the same thing keep equal results, so
    that none of them has to wait.

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
    """Set the fields of a value: when it is made, and when a part that is computed lazily is kept."""
    for name, content in fields.items():
        _set(value, name, content)
