"""Answers about surfaces as data: values at a place, and the questions of the registry."""

from __future__ import annotations

from exactspline.display.reals import real_data
from exactspline.display.surface_data import surface_answer_data
from exactspline.geometry.analysis.ask import asked_of
from exactspline.geometry.analysis.planar_maps import MapInspection
from exactspline.geometry.analysis.registry import REGISTRY
from exactspline.geometry.analysis.surfaces import SurfaceInspection
from exactspline.questions.answers import NamedNumbers
from exactspline.questions.entry import Of
from exactspline.questions.takes import name_of
from exactspline.splines.surface import NurbsSurface


def applies(surface: NurbsSurface, asked: str) -> bool:
    """Whether a question is one about surfaces of this dimension.

    >>> from exactspline import example
    >>> [applies(example(name), "umbilics") for name in ("torus", "folded_map")]
    [True, False]
    """
    return name_of(asked) in REGISTRY[Of.SURFACE if surface.dimension == 3 else Of.PLANAR_MAP]


def surface_answer(
    surface: NurbsSurface, asked: str, digits: int, found: SurfaceInspection | MapInspection | None = None
) -> object:
    """The answer to a question about a surface as data; `found` is its inspection where there is one already.

    >>> from exactspline import example
    >>> surface_answer(example("sphere"), "curvature@1/3,1/3", 5)["values"]["K"]["exact"]
    '1'

    Raises `QuestionError` for an unknown question, and another `ExactSplineError` where the question has no answer for
    the surface.
    """
    answer = asked_of(found or surface, asked).answer
    if isinstance(answer, tuple) and answer and isinstance(answer[0], NamedNumbers):
        return {"values": {name: real_data(value, digits) for name, value in answer[0].values.items()}}
    return surface_answer_data(answer, digits)
