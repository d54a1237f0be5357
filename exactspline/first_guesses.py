"""What a user types first: the questions and public functions as attributes of objects and of the package itself; for
any other name an error with the call that works.
"""

from __future__ import annotations

import re
from functools import partial
from importlib.util import find_spec
from operator import attrgetter
from types import MethodType, ModuleType
from typing import Any

from exactspline.errors import ExactSplineError, nearest
from exactspline.geometry.analysis.ask import REGISTRY, facts_about, kind_of
from exactspline.geometry.analysis.curves import Analysis, questions_about
from exactspline.hooks import DERIVED, LENT, QUESTIONS, Written, first_guesses

#: Modules with their own public names.
ROOMS = ("interchange", "constructors", "display", "language", "readings", "tables", "teaching")
#: Calls that are found by another name: an attribute or a method, and a function with its arguments.
OWN = re.compile(r"x\.(\w+)(\(\w*\))?")
FUNCTION = re.compile(r'exactspline\.([\w.]+)\((\w+)(?:, \w+)*(?:, (\w+)="(\w+)")?\)')


class Found(tuple[Any, ...]):
    """An answer with several parts, which may also be written as a call: ``curve.corners()`` is ``curve.corners``."""

    __slots__ = ()

    def __call__(self) -> Found:
        """The answer itself."""
        return self


def of_object(front: ModuleType, name: str, thing: object) -> object:
    """The value of a name that is not an attribute of the object itself: a public function of the package, the answer
    to a question, or the meaning of a name from another library. For a class it is the function itself; for
    ``questions`` the names of the questions about the object.

    >>> from exactspline import example
    >>> circle = example("circle")
    >>> circle.length, circle.corners(), circle.plot.__name__, circle.is_closed
    (<Real 2π>, (), 'plot', True)

    Raises `AttributeError`, which names the call that works.
    """
    guesses, thing = first_guesses(), getattr(thing, "given", thing)
    if isinstance(thing, type):
        if name in guesses[LENT] or (name in front.__all__ and name.startswith("from_")):
            return getattr(front, name)
        problem = f"type object {thing.__name__!r} has no attribute {name!r}"
        raise AttributeError(f"{problem}; {_remedy(front, name, thing)}", name=name, obj=thing)
    if isinstance(thing, Written):
        return MethodType(getattr(front.tables, name), thing)
    if name in guesses[LENT]:
        return MethodType(getattr(front, name), thing)
    if name in guesses[DERIVED]:
        return partial(front.derive, name, thing)
    for call in _calls(name):
        if (own := OWN.fullmatch(call)) and hasattr(thing, own[1]):
            return getattr(thing, own[1])
        if (function := FUNCTION.fullmatch(call)) and function[2] == "x":
            return MethodType(_called(front, function), thing)
    problem = f"{type(thing).__name__!r} object has no attribute {name!r}"
    if name not in (QUESTIONS, *guesses[QUESTIONS]):
        raise AttributeError(f"{problem}; {_remedy(front, name, thing)}", name=name, obj=thing)
    try:
        facts: Any = facts_about(thing)  # type: ignore[arg-type]  # which refuses what it does not take
        asked = questions_about(facts.given) if isinstance(facts, Analysis) else REGISTRY[kind_of(facts)]
    except ExactSplineError as error:
        if name == QUESTIONS:
            return ()
        raise AttributeError(f"{problem}: {error}", name=name, obj=thing) from None
    if name == QUESTIONS:
        return tuple(each for each in asked if each in guesses[QUESTIONS])
    if name not in asked:
        raise AttributeError(f"{problem}: it is not asked of a {kind_of(facts)}", name=name, obj=thing)
    answer = getattr(facts, name)
    return Found(answer) if type(answer) is tuple else answer


def _called(front: ModuleType, call: re.Match[str]) -> Any:
    """The function of a call, with the last argument if the call contains it."""
    function = attrgetter(call[1])(front)
    return partial(function, **{call[3]: call[4]}) if call[3] else function


def of_package(front: ModuleType, name: str) -> object:
    """The question of this name as a function, such as ``exactspline.length(curve)``; or the public name of a module;
    or the meaning of a name from another library.

    >>> import exactspline
    >>> exactspline.length(exactspline.example("circle")), exactspline.intersect is exactspline.intersections
    (<Real 2π>, True)

    Raises `AttributeError`, which names the call that works.
    """
    if name in first_guesses()[QUESTIONS]:
        return partial(_answered, front, name)
    if name in first_guesses()[DERIVED]:
        return partial(front.derive, name)
    problem = f"module 'exactspline' has no attribute {name!r}"
    if find_spec(f"exactspline.{name}"):
        raise AttributeError(problem, name=name)
    calls = [f"exactspline.{room}.{name}(x)" for room in ROOMS if name in getattr(front, room).__all__]
    for call in (*calls, *_calls(name)):
        if function := FUNCTION.fullmatch(call):
            return _called(front, function)
    raise AttributeError(f"{problem}; {_remedy(front, name, front)}", name=name)


def _answered(front: ModuleType, name: str, about: object, *arguments: object) -> object:
    """The answer to a question about an object, with its arguments."""
    found: Any = of_object(front, name, about)
    return found(*arguments) if arguments else found


def _calls(name: str) -> list[str]:
    """The calls that have this name as an alternative name."""
    return [call for call, guesses in first_guesses().items() if name in guesses and not call.isalpha()]


def _remedy(front: ModuleType, name: str, thing: object) -> str:
    """The call that works in place of a guess, or the nearest names of an object."""
    for call in (f"exactspline.{name}",) if name in front.__all__ else _calls(name):
        return "write " + re.sub(r"\bx\b", "curve", call)
    return nearest(name, filter(str.isidentifier, dir(thing)))
