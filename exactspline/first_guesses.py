"""What a user types first: questions and functions of the front door where they are looked for, on objects and on the
package itself, and otherwise an error that names the call that works.
"""

from __future__ import annotations

import re
from functools import partial
from importlib.util import find_spec
from types import ModuleType
from typing import Any

from exactspline.errors import ExactSplineError, nearest
from exactspline.geometry.analysis.ask import facts_about, kind_of
from exactspline.geometry.analysis.curves import Analysis, questions_about
from exactspline.geometry.analysis.registry import REGISTRY
from exactspline.hooks import LENT, QUESTIONS, Written, first_guesses

#: Rooms with public names of their own.
ROOMS = ("interchange", "constructors", "display", "language", "readings", "tables", "teaching")
#: Calls that an object finds by another name: an attribute or a method, a function that takes it first.
OWN, FUNCTION = re.compile(r"x\.(\w+)(\(\w*\))?"), re.compile(r"exactspline\.(\w+)\(x(, \w+)*\)")


def of_object(front: ModuleType, name: str, thing: object) -> object:
    """What an object has by a name that is not its own: a function of the front door, the answer to a question, or what
    is meant by a name of other libraries.

    >>> from exactspline import example
    >>> circle = example("circle")
    >>> circle.length, circle.plot.func.__name__, circle.is_closed
    (<Real 6.2831853…>, 'plot', True)

    Raises `AttributeError`, which names the call that works.
    """
    guesses = first_guesses()
    if isinstance(thing, Written):
        return partial(getattr(front.tables, name), thing)
    if name in guesses[LENT]:
        return partial(getattr(front, name), thing)
    for call in _calls(name):
        if (own := OWN.fullmatch(call)) and hasattr(thing, own[1]):
            return getattr(thing, own[1])
        if function := FUNCTION.fullmatch(call):
            return partial(getattr(front, function[1]), thing)
    problem = f"{type(thing).__name__!r} object has no attribute {name!r}"
    if name not in guesses[QUESTIONS]:
        raise AttributeError(f"{problem}; {_remedy(front, name, dir(thing))}", name=name, obj=thing)
    try:
        facts: Any = facts_about(thing)  # type: ignore[arg-type]  # which refuses what it does not take
        asked = questions_about(facts.given) if isinstance(facts, Analysis) else REGISTRY[kind_of(facts)]
    except ExactSplineError as error:
        raise AttributeError(f"{problem}: {error}", name=name, obj=thing) from None
    if name not in asked:
        raise AttributeError(f"{problem}: it is not asked of a {kind_of(facts)}", name=name, obj=thing)
    return getattr(facts, name)


def of_package(front: ModuleType, name: str) -> object:
    """The question of that name as a function: ``exactspline.length(curve)``.

    >>> import exactspline
    >>> exactspline.length(exactspline.example("circle"))
    <Real 6.2831853…>

    Raises `AttributeError`, which names the call that works.
    """
    if name in first_guesses()[QUESTIONS]:
        return partial(_answered, front, name)
    problem = f"module 'exactspline' has no attribute {name!r}"
    remedy = "" if find_spec(f"exactspline.{name}") else f"; {_remedy(front, name, dir(front))}"
    raise AttributeError(problem + remedy, name=name)


def _answered(front: ModuleType, name: str, about: object, *arguments: object) -> object:
    """The answer to a question about an object, with what it takes."""
    found: Any = of_object(front, name, about)
    return found(*arguments) if arguments else found


def _calls(name: str) -> list[str]:
    """The calls of which a name is another name."""
    return [call for call, guesses in first_guesses().items() if name in guesses and call not in (LENT, QUESTIONS)]


def _remedy(front: ModuleType, name: str, known: list[str]) -> str:
    """The call that works instead of a guess, or the nearest of the known names."""
    calls = [f"exactspline.{name}"] * (name in dir(front)) or _calls(name)
    if not calls:
        homes = [room for room in ROOMS if name in getattr(front, room).__all__]
        calls = [f"exactspline.{room}.{name}" for room in homes]
    found = nearest(name, filter(str.isidentifier, known))
    return "write " + re.sub(r"\bx\b", "curve", calls[0]) if calls else found
