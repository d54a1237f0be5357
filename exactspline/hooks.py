"""What the front door lends to every room: printers for notebooks, and the names of its functions."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from enum import Enum
from importlib import import_module
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
_functions = set[str]()
#: How a function of the front door is loaded by its name.
_loaded: list[Callable[[str], Callable[..., object]]] = []


def set_printers(printers: Printers) -> None:
    """Let notebooks show objects as these printers write them."""
    _printers[0] = printers


def set_functions(names: Iterable[str], loaded: Callable[[str], Callable[..., object]]) -> None:
    """Let the errors of missing methods name these functions of the front door, and methods that are lent call them."""
    _loaded[:] = [loaded]
    for name in names:
        if not hasattr(FunctionsOutside, name):
            _functions.add(name)
            setattr(FunctionsOutside, name, _FunctionOutside(name))


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


class _FunctionOutside:
    """An attribute that there is not, and a function of its name that there is."""

    def __init__(self, name: str) -> None:
        self.name = name

    def __get__(self, instance: object, owner: type) -> object:
        """Refuse it, naming the function."""
        problem = f"{owner.__name__!r} object has no attribute {self.name!r}"
        raise AttributeError(f"{problem}; use the function exactspline.{self.name}", name=self.name, obj=instance)


class FunctionsOutside:
    """An object that functions of the front door take: ``exactspline.plot(curve)``, not ``curve.plot()``. The last of
    the bases, so that its attributes come after all others.

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
        found = _loaded[0]("floats")(self, *parameters, of=of, order=order, rounding=rounding, side=side)
        return cast("NDArray[np.float64]", found)

    def __dir__(self) -> list[str]:
        missing = {name for name in _functions if isinstance(_found(type(self), name), _FunctionOutside)}
        return [name for name in super().__dir__() if name not in missing or name in getattr(self, "__dict__", ())]


def _found(owner: type, name: str) -> object:
    return next((each.__dict__[name] for each in owner.__mro__ if name in each.__dict__), None)
