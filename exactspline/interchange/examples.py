"""Named example curves and surfaces."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Literal, overload

from exactspline.errors import CurveFileError, FormulaError, as_text, nearest
from exactspline.interchange import curve_files
from exactspline.interchange.records import Reading, Source
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface


@cache
def example_names() -> tuple[str, ...]:
    """The names of the example curves.

    >>> "circle" in example_names()
    True
    """
    return _names("example_curves")


#: The example surfaces, for type checkers: any other name is that of a curve.
SurfaceName = Literal[
    "bicubic", "biquadratic", "cone", "cross_cap", "cyclide", "cylinder", "developable", "ellipsoid", "enneper",
    "folded_map", "hyperbolic_paraboloid", "monkey_saddle", "paraboloid", "planar_map", "rational_biquadratic",
    "sphere", "torus",
]  # fmt: skip


def examples(of: str = "") -> tuple[str, ...]:
    """Return the names of the example ``curves`` or ``surfaces``, by default of both.

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
    """Return the example curve or surface with this name (see `examples`).

    >>> example("circle")("1/2")
    (mpq(3,5), mpq(4,5))
    >>> example("sphere")(0, 1)
    (mpq(1,1), mpq(0,1), mpq(0,1))

    Raises `CurveFileError`, with the nearest names, for an unknown name.
    """
    known = as_text(name, "the name of an example") in example_surface_names()
    return example_surface(name) if known else _example_curve(name)


@cache
def _example_curve(name: str) -> Nurbs:
    if name not in example_names():
        remedy = nearest(name, examples(), listed_by="list curves")
        raise CurveFileError(f"there is neither a file nor an example called {name!r}", remedy=remedy)
    return _read("example_curves", name).curve


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

    Raises `CurveFileError`, with the nearest names, for an unknown name.
    """
    if as_text(name, "the name of a surface") not in example_surface_names():
        remedy = nearest(name, example_surface_names(), listed_by="list surfaces")
        raise CurveFileError(f"there is neither a file nor an example surface called {name!r}", remedy=remedy)
    return _read("example_surfaces", name).surface


def _names(folder: str) -> tuple[str, ...]:
    files = Path(__file__).with_name(folder).iterdir()
    return tuple(sorted(entry.name.removesuffix(".json") for entry in files if entry.name.endswith(".json")))


def _read(folder: str, name: str) -> Reading:
    return curve_files.read(Source(_text(folder, name).encode(), f"{name}.json"))


def _text(folder: str, name: str) -> str:
    return (Path(__file__).with_name(folder) / f"{name}.json").read_text(encoding="utf-8")
