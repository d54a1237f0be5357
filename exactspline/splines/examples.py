"""Named example curves, and readers and writers of curve files."""

from __future__ import annotations

from functools import cache
from importlib import resources
from pathlib import Path

from exactspline.errors import CurveFileError, nearest
from exactspline.splines.curve_files import curve_from_text, read_curve, write_json
from exactspline.splines.nurbs import Nurbs

__all__ = ["curve_from_text", "example", "example_names", "load", "read_curve", "write_json"]


@cache
def example_names() -> tuple[str, ...]:
    """The names of the example curves.

    >>> "circle" in example_names()
    True
    """
    return tuple(
        sorted(
            entry.name.removesuffix(".json")
            for entry in resources.files(__package__).joinpath("example_curves").iterdir()
            if entry.name.endswith(".json")
        )
    )


@cache
def example(name: str) -> Nurbs:
    """The example curve with this name.

    >>> example("circle")("1/2")
    (mpq(3,5), mpq(4,5))

    Raises `CurveFileError` with the nearest names.
    """
    if name not in example_names():
        remedy = nearest(name, example_names(), listed_by="exactspline curves")
        raise CurveFileError(f"no file and no example curve is called {name!r}", remedy=remedy)
    return curve_from_text(
        resources.files(__package__).joinpath("example_curves", f"{name}.json").read_text(encoding="utf-8"), name
    )


def load(name_or_path: str) -> Nurbs:
    """An example curve by its name, otherwise a curve file by its path; what looks like a name and is none gets the
    nearest ones.
    """
    is_name = name_or_path.isidentifier() and not Path(name_or_path).exists()
    return example(name_or_path) if name_or_path in example_names() or is_name else read_curve(name_or_path)
