"""Named example curves and surfaces, and readers and writers of their files."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Literal, TypeVar, overload

from exactspline.errors import CurveFileError, FormulaError, as_path, as_text, nearest
from exactspline.interchange.curve_files import curve_from_text, read_curve, read_surface, surface_from_text
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface

V = TypeVar("V")


@cache
def example_names() -> tuple[str, ...]:
    """The names of the example curves.

    >>> "circle" in example_names()
    True
    """
    return _names("example_curves")


#: The example surfaces, for type checkers: any other name is that of a curve.
SurfaceName = Literal[
    "bicubic",
    "biquadratic",
    "cone",
    "cross_cap",
    "cyclide",
    "cylinder",
    "developable",
    "ellipsoid",
    "enneper",
    "folded_map",
    "hyperbolic_paraboloid",
    "monkey_saddle",
    "paraboloid",
    "planar_map",
    "rational_biquadratic",
    "sphere",
    "torus",
]


def examples(of: str = "") -> tuple[str, ...]:
    """The names of the example ``curves`` or ``surfaces``, of both without a word.

    >>> "circle" in examples("curves"), "torus" in examples("surfaces"), "circle" in examples()
    (True, True, True)

    Raises `FormulaError` for another word.
    """
    known = {"curves": example_names(), "surfaces": example_surface_names()}
    if as_text(of, "what the examples are of") and of not in known:
        raise FormulaError(f"there are no examples of {of!r}", remedy="there are curves and surfaces")
    return known[of] if of else tuple(name for names in known.values() for name in names)


@overload
def example(name: SurfaceName) -> NurbsSurface:  # type: ignore[overload-overlap]  # the other names are curves'
    """The example surface with this name."""


@overload
def example(name: str) -> Nurbs:
    """The example curve with this name."""


def example(name: str) -> Nurbs | NurbsSurface:
    """The example curve or surface with this name (see `examples`).

    >>> example("circle")("1/2")
    (mpq(3,5), mpq(4,5))
    >>> example("sphere")(0, 1)
    (mpq(1,1), mpq(0,1), mpq(0,1))

    Raises `CurveFileError` with the nearest names.
    """
    known = as_text(name, "the name of an example") in example_surface_names()
    return example_surface(name) if known else _example_curve(name)


@cache
def _example_curve(name: str) -> Nurbs:
    if name not in example_names():
        remedy = nearest(name, examples(), listed_by="list curves")
        raise CurveFileError(f"there is neither a file nor an example called {name!r}", remedy=remedy)
    return curve_from_text(_text("example_curves", name), name)


def example_text(name: str) -> str:
    """The file of an example."""
    return _text("example_surfaces" if name in example_surface_names() else "example_curves", name)


@cache
def example_surface_names() -> tuple[str, ...]:
    """The names of the example surfaces.

    >>> "torus" in example_surface_names()
    True
    """
    return _names("example_surfaces")


@cache
def example_surface(name: str) -> NurbsSurface:
    """The example surface with this name.

    >>> example_surface("sphere")(0, 1)
    (mpq(1,1), mpq(0,1), mpq(0,1))

    Raises `CurveFileError` with the nearest names.
    """
    if as_text(name, "the name of a surface") not in example_surface_names():
        remedy = nearest(name, example_surface_names(), listed_by="list surfaces")
        raise CurveFileError(f"there is neither a file nor an example surface called {name!r}", remedy=remedy)
    return surface_from_text(_text("example_surfaces", name), name)


def load_surface(name_or_path: str) -> NurbsSurface:
    """An example surface by its name, otherwise a surface file by its path; for an unknown name the error lists the
    nearest ones.

    >>> load_surface("enneper").degree
    (3, 3)
    """
    return _loaded(name_or_path, example_surface_names(), example_surface, read_surface)


def load(name_or_path: str) -> Nurbs:
    """An example curve by its name, otherwise a curve file by its path; for an unknown name the error lists the nearest
    ones.
    """
    return _loaded(name_or_path, example_names(), _example_curve, read_curve)


def _loaded(given: str, names: tuple[str, ...], named: Callable[[str], V], read: Callable[[str], V]) -> V:
    place = as_path(given)
    is_name = place in names or (place.isidentifier() and not Path(place).exists())
    return named(place) if is_name else read(place)


def _names(folder: str) -> tuple[str, ...]:
    files = resources.files(__package__).joinpath(folder).iterdir()
    return tuple(sorted(entry.name.removesuffix(".json") for entry in files if entry.name.endswith(".json")))


def _text(folder: str, name: str) -> str:
    return resources.files(__package__).joinpath(folder, f"{name}.json").read_text(encoding="utf-8")
