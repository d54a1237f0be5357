"""Hooks that the top-level package fills and every package may use: printers for notebooks, and names of functions."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import cache
from importlib import import_module
from os.path import dirname, join
from typing import TYPE_CHECKING, Any, Protocol, cast

from exactspline.one_line import OneLine, fields_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

#: From the name of a format (``html``, ``latex``, ``short``, ``words``) and an object to a text; None if there is none.
Printers = Callable[[str, object], str | None]


def named(home: str) -> Any:
    """The object that a table names as ``module:name``; its module is imported.

    >>> named("exactspline.words:choice").__name__
    'choice'
    """
    module, _, name = home.partition(":")
    return getattr(import_module(module), name)


def _plain(form: str, shown: object) -> str | None:
    return repr(shown) if form == "short" else None


_printers: list[Printers] = [_plain]
#: The function of the top-level package that finds a name for an object without an attribute of that name.
_outside: list[Callable[[str, object], object]] = []
#: The first rows of the first guesses: functions that are also methods, questions, and derived objects.
LENT, QUESTIONS, DERIVED = "lent", "questions", "derived"


def set_printers(printers: Printers) -> None:
    """Let notebooks show objects as these printers write them."""
    _printers[0] = printers


@cache
def first_guesses() -> dict[str, list[str]]:
    """The names that users try first, by the call that works (``guesses.txt``), where x is the object: functions of the
    package that are also methods, questions about one curve or surface, derived curves and surfaces, and other names.

    >>> first_guesses()["x.closed"][:2]
    ['is_closed', 'isclosed']
    """
    with open(join(dirname(__file__), "guesses.txt"), encoding="utf-8") as stream:
        rows = [line.rpartition(": ") for line in stream]
    return {call: guesses.split() for call, _, guesses in rows}


def set_functions(names: Iterable[str], outside: Callable[[str, object], object]) -> None:
    """Give objects these functions of the package, and the names that users try first, as attributes; `outside` finds
    them.
    """
    guesses = first_guesses()
    calls = {name: f"exactspline.{name}" for name in names}
    calls |= {name: call for call, others in reversed(guesses.items()) for name in others}
    for name in calls.keys() - set(dir(FunctionsOutside)):
        found = _question(name) if calls[name] == QUESTIONS else _Outside(name, calls[name])
        setattr(FunctionsOutside if calls[name] in (LENT, QUESTIONS) else OtherNames, name, found)
    _outside[:] = [outside]


class _Writer(Protocol):
    """The object that IPython passes to `_repr_pretty_`."""

    def text(self, text: str, /) -> object:
        """Write a text."""


class Displayed:
    """An object that a notebook shows as formulas, tables and small pictures."""

    __slots__ = ()

    def _repr_html_(self) -> str | None:
        return _printers[0]("html", self)

    def _repr_latex_(self) -> str | None:
        return _printers[0]("latex", self)

    def _repr_pretty_(self, writer: _Writer, cycle: bool) -> None:
        writer.text(_printers[0]("short", self) or repr(self))


class Written(Displayed):
    """An answer that is written as `exactspline.tables` writes it."""

    __slots__ = ()

    def to_dict(self, digits: int = 20) -> dict[str, object]:
        """Return the answer as data for ``json.dumps``, with this many digits of irrational numbers."""
        return cast("Callable[..., dict[str, object]]", _outside[0]("to_dict", self))(digits=digits)

    def to_records(self) -> list[dict[str, object]]:
        """Return the parts of the answer as records for ``pandas.DataFrame`` and ``polars.DataFrame``, with correctly
        rounded doubles as numbers.
        """
        return cast("Callable[..., list[dict[str, object]]]", _outside[0]("to_records", self))()


class Worded(OneLine):
    """An object that `str` puts into words, as `display` writes them."""

    __slots__ = ()

    def __str__(self) -> str:
        return _printers[0]("words", self) or fields_of(self)


class _Outside:
    """An attribute that the top-level package finds: a function that takes the object, or an error that names the call
    that works; on a class, the function itself.
    """

    def __init__(self, name: str, call: str) -> None:
        self.name, self.__doc__ = name, call

    def __get__(self, instance: object, owner: type) -> object:
        """The function or the answer; or raise the error that names the call that works."""
        return _outside[0](self.name, owner if instance is None else instance)


def _question(name: str) -> property:
    """A question as an attribute; a property, so that completion does not ask it."""
    return property(lambda thing: _outside[0](name, thing), doc=f"The same as ``exactspline.analyse(self).{name}``.")


class OtherNames:
    """Names that other libraries use, and functions of the package for other objects. They are found, or named by an
    error, but not listed.
    """

    __slots__ = ()


class FunctionsOutside(OtherNames):
    """An object that functions of the package take: ``curve.plot()`` is ``exactspline.plot(curve)``, and
    ``curve.length`` the answer to a question. This is the last base class, so that its attributes come after all
    others.

    There is no ``__getattr__``: with one, every attribute of a class is found more slowly.
    """

    __slots__ = ()

    def floats(
        self,
        *parameters: object,
        of: str = "point",
        order: int | tuple[int, int] = 0,
        rounding: str = "nearest",
        side: str = "right",
    ) -> NDArray[np.float64]:
        """Return an array of correctly rounded doubles at parameters: of points or, with ``of="curvature"``,
        ``order=1``, …, of other quantities. `exactspline.floats` of this object returns the same.
        """
        evaluate = cast("Callable[..., NDArray[np.float64]]", _outside[0]("floats", self))
        return evaluate(*parameters, of=of, order=order, rounding=rounding, side=side)

    def __dir__(self) -> list[str]:
        """The names of the object, the functions that take it, and the questions about it."""
        own = {name for each in type(self).__mro__ if each not in FunctionsOutside.__mro__[:2] for name in vars(each)}
        asked = cast("Iterable[str]", _outside[0](QUESTIONS, self))
        return sorted({*own, *getattr(self, "__dict__", ()), *first_guesses()[LENT], *asked})
