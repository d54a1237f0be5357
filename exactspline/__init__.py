"""exactspline: B-splines and NURBS in exact rational arithmetic, and the proofs that go with them.

>>> import exactspline as xs
>>> f = xs.BSpline(2, [0, 0, 0, 1, 2, 2, 2], [0, 1, 0, "1/2"])
>>> (f * f - f**2).is_zero
True

Everything that a user looks for is here; a name is imported when it is first used.
"""

from importlib import import_module
from sys import modules

import lazy_loader

from exactspline import hooks
from exactspline.release import __version__ as __version__

#: The names stand in ``__init__.pyi``, which type checkers read too.
_loaded, _, _names = lazy_loader.attach_stub(__name__, __file__)
__all__ = [*_names, "__version__"]  # noqa: PLE0604


def __dir__() -> list[str]:
    """The names of the front door, and the questions."""
    return sorted({*__all__, *hooks.first_guesses()[hooks.QUESTIONS]})


def _printed(form: str, shown: object) -> str | None:
    """The text of an object in a notebook, or what was found in words."""
    own = type(shown).__module__.split(".")[:3]
    if own[1:2] == ["extras"]:
        import_module(".".join([*own, "display"]))
    home = {"words": "evidence", "latex": "latex"}.get(form, "notebook")
    found: str | None = getattr(import_module(f"exactspline.display.{home}"), form)(shown)
    return found


hooks.set_printers(_printed)


def _outside(name: str, thing: object) -> object:
    """What objects do not have themselves: see `exactspline.first_guesses`."""
    return import_module("exactspline.first_guesses").of_object(modules[__name__], name, thing)


def __getattr__(name: str) -> object:
    """A name of the front door, or what was meant."""
    if name in _names or name[0] == "_":
        return _loaded(name)
    return import_module("exactspline.first_guesses").of_package(modules[__name__], name)


hooks.set_functions((name for name in _names if name.islower()), _outside)
