"""What the front door lends to every room: printers for notebooks, and the names of its functions."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from enum import Enum
from functools import cache
from importlib import import_module
from os.path import dirname, join
from typing import TYPE_CHECKING, Any, ClassVar, Protocol, cast, dataclass_transform

from exactspline.one_line import OneLine, fields_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

#: From the name of a format (``html``, ``latex``, ``short``, ``words``) and an object to a text, None where there is
#: none.
Printers = Callable[[str, object], str | None]


def named(home: str) -> Any:
    """What a table names as ``module:name``, its module loaded.

    >>> named("exactspline.words:choice").__name__
    'choice'
    """
    module, _, name = home.partition(":")
    return getattr(import_module(module), name)


def _plain(form: str, shown: object) -> str | None:
    return repr(shown) if form == "short" else None


_printers: list[Printers] = [_plain]
#: What the front door knows of a name and an object that has no attribute of that name.
_outside: list[Callable[[str, object], object]] = []
#: The first rows of what users type first: functions that are methods, too, questions, and what `derive` makes.
LENT, QUESTIONS, DERIVED = "lent", "questions", "derived"


def set_printers(printers: Printers) -> None:
    """Let notebooks show objects as these printers write them."""
    _printers[0] = printers


@cache
def first_guesses() -> dict[str, list[str]]:
    """What users type first, by the call that works (``guesses.txt``), where x is the object: functions of the front
    door that are methods, too, questions about one curve or surface, derived curves and surfaces, and other names.

    >>> first_guesses()["x.closed"][:2]
    ['is_closed', 'isclosed']
    """
    with open(join(dirname(__file__), "guesses.txt"), encoding="utf-8") as stream:
        rows = [line.rpartition(": ") for line in stream]
    return {call: guesses.split() for call, _, guesses in rows}


def set_functions(names: Iterable[str], outside: Callable[[str, object], object]) -> None:
    """Let objects find by `outside` these functions of the front door, and what users type first, as attributes."""
    guesses = first_guesses()
    calls = {name: f"exactspline.{name}" for name in names}
    calls |= {name: call for call, others in reversed(guesses.items()) for name in others}
    for name in calls.keys() - set(dir(FunctionsOutside)):
        found = _question(name) if calls[name] == QUESTIONS else _Outside(name, calls[name])
        setattr(FunctionsOutside if calls[name] in (LENT, QUESTIONS) else OtherNames, name, found)
    _outside[:] = [outside]


class Writer(Protocol):
    """What IPython hands to `_repr_pretty_`."""

    def text(self, text: str, /) -> object:
        """Write a text."""


class Displayed:
    """An object that a notebook shows as formulas, tables and small pictures."""

    __slots__ = ()

    def _repr_html_(self) -> str | None:
        return _printers[0]("html", self)

    def _repr_latex_(self) -> str | None:
        return _printers[0]("latex", self)

    def _repr_pretty_(self, writer: Writer, cycle: bool) -> None:
        writer.text(_printers[0]("short", self) or repr(self))


class Written(Displayed):
    """An answer that is written as `exactspline.tables` writes it."""

    __slots__ = ()

    def to_dict(self, digits: int = 20) -> dict[str, object]:
        """The answer as ``json.dumps`` takes it, irrational numbers to this many digits."""
        return cast("Callable[..., dict[str, object]]", _outside[0]("to_dict", self))(digits=digits)

    def to_records(self) -> list[dict[str, object]]:
        """The things of which the answer consists, numbers as correctly rounded doubles: what ``pandas.DataFrame`` and
        ``polars.DataFrame`` take.
        """
        return cast("Callable[..., list[dict[str, object]]]", _outside[0]("to_records", self))()


class Worded(OneLine):
    """What a sentence is made of: `str` puts it into words, as `display` writes them: those given with a class, with
    fields between braces: ``{name?yes|no}`` is one of two such texts, as the field is true, ``{name:, }`` its parts
    with commas between them.
    """

    __slots__ = ()
    template: ClassVar[str] = ""

    def __init_subclass__(cls, words: str = "") -> None:
        cls.template = words

    def __str__(self) -> str:
        return _printers[0]("words", self) or fields_of(self)


@dataclass_transform(frozen_default=True)
class WordedData(Worded):
    """The same, as a base of kinds of things, every class of which is a frozen dataclass or an enumeration."""

    __slots__ = ()

    def __init_subclass__(cls, words: str = "") -> None:
        super().__init_subclass__(words)
        if WordedData not in cls.__bases__ and not issubclass(cls, Enum):
            dataclass(frozen=True, repr=False)(cls)


class _Outside:
    """An attribute that the front door finds: a function that takes the object, or an error that names the call that
    works; of a class the function itself.
    """

    def __init__(self, name: str, call: str) -> None:
        self.name, self.__doc__ = name, call

    def __get__(self, instance: object, owner: type) -> object:
        """What is found."""
        return _outside[0](self.name, owner if instance is None else instance)


def _question(name: str) -> property:
    """A question as an attribute; a property, so that completion does not ask it."""
    return property(lambda thing: _outside[0](name, thing), doc=f"``exactspline.analyse(self).{name}``: see there.")


class OtherNames:
    """What other libraries call by another name, and what the front door does with other things: found, or named by an
    error, but not listed.
    """

    __slots__ = ()


class FunctionsOutside(OtherNames):
    """An object that functions of the front door take: ``curve.plot()`` is ``exactspline.plot(curve)``, and
    ``curve.length`` the answer to a question. The last of the bases, so that its attributes come after all others.

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
        """Correctly rounded doubles at parameters, as an array: of points, and by ``of="curvature"``, ``order=1``, … of
        other quantities: what `exactspline.floats` returns for this object.
        """
        evaluate = cast("Callable[..., NDArray[np.float64]]", _outside[0]("floats", self))
        return evaluate(*parameters, of=of, order=order, rounding=rounding, side=side)

    def __dir__(self) -> list[str]:
        """Its own names, the functions that take it, and the questions that are asked of it."""
        own = {name for each in type(self).__mro__ if each not in FunctionsOutside.__mro__[:2] for name in vars(each)}
        asked = cast("Iterable[str]", _outside[0](QUESTIONS, self))
        return sorted({*own, *getattr(self, "__dict__", ()), *first_guesses()[LENT], *asked})
