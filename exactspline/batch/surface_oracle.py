"""The exact oracle for surfaces: values at a place, and the questions of the registry, as data.

A question is text: ``value@1/2,1/3``, ``derivative:1,2@0,1`` (once by u, twice by v), ``curvature@1/2,1/2``,
``umbilics``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from exactspline.batch.oracle_answers import QuestionError, number_data, parts_of
from exactspline.display.surface_data import surface_answer_data
from exactspline.geometry.analysis.planar_maps import MapInspection, jacobian_sign
from exactspline.geometry.analysis.registry import REGISTRY
from exactspline.geometry.analysis.surfaces import SurfaceInspection
from exactspline.geometry.surfaces.forms import SurfaceForms
from exactspline.numbers.exact import mpq, rational
from exactspline.questions.entry import Of
from exactspline.reals.real import Real, square_root
from exactspline.splines.surface import NurbsSurface

#: The highest order of a derivative by u or v.
HIGHEST = 99


def surface_question(asked: str) -> tuple[str, str, str]:
    """The name, the argument and the place of a question; raises `QuestionError` as `parts_of` does.

    >>> surface_question("derivative:1,2@0,1/3")
    ('derivative', '1,2', '0,1/3')
    """
    of_registry = REGISTRY[Of.PLANAR_MAP] | REGISTRY[Of.SURFACE]
    return parts_of(asked, FORMS | {name: entry.form for name, entry in of_registry.items()})


def inspection_of(surface: NurbsSurface) -> SurfaceInspection | MapInspection:
    """What the questions of the registry are asked of: in space the surface, in the plane the map."""
    return SurfaceInspection(surface) if surface.dimension == 3 else jacobian_sign(surface)


def applies(surface: NurbsSurface, asked: str) -> bool:
    """Whether a question is one about surfaces of this dimension.

    >>> from exactspline import example
    >>> [applies(example(name), "umbilics") for name in ("torus", "folded_map")]
    [True, False]
    """
    name, _, _ = surface_question(asked)
    if name in AT_A_PLACE:
        return name != "curvature" or surface.dimension == 3
    return name in REGISTRY[_kind(surface)]


def _kind(surface: NurbsSurface) -> Of:
    return Of.SURFACE if surface.dimension == 3 else Of.PLANAR_MAP


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
    name, argument, place = surface_question(asked)
    if name in AT_A_PLACE:
        values = AT_A_PLACE[name](surface, argument, *_place(place))
        return {"values": {each: number_data(value, digits) for each, value in values.items()}}
    of = _kind(surface)
    entry = REGISTRY[of].get(name)
    if entry is None:
        known = ", ".join([*AT_A_PLACE, *REGISTRY[of]])
        raise QuestionError(f"{name} of a surface in R{surface.dimension}", remedy=f"these can be asked: {known}")
    return surface_answer_data(entry.answer(found or inspection_of(surface), argument), digits)


def _place(text: str) -> tuple[mpq, mpq]:
    parts = text.split(",")
    if len(parts) != 2:
        raise QuestionError(f"{text!r} is not a place", remedy="give u and v, as in value@1/2,1/3")
    return rational(parts[0]), rational(parts[1])


def _point(surface: NurbsSurface, argument: str, u: mpq, v: mpq) -> dict[str, Real]:
    return _by_axis(surface(u, v))


def _derivative(surface: NurbsSurface, argument: str, u: mpq, v: mpq) -> dict[str, Real]:
    orders = argument.split(",")
    if len(orders) != 2 or not all(n.isascii() and n.isdecimal() and int(n) <= HIGHEST for n in orders):
        raise QuestionError(f"a derivative of the orders {argument!r}", remedy="derivative:1,0@1/2,1/3 is S_u")
    _inside(surface, u, v)
    return _by_axis(surface.partial(int(orders[0]), int(orders[1]), u, v))


def _curvature(surface: NurbsSurface, argument: str, u: mpq, v: mpq) -> dict[str, Real]:
    """K and H, for the normal ``S_u × S_v``: ``H = w⁸ (EN − 2FM + GL) w √a / (2 a²)`` with ``a = w⁶ (EG − F²)``."""
    _inside(surface, u, v)
    forms = SurfaceForms(surface)
    numerator, denominator = (form(u, v) for form in forms.curvature)
    if not denominator:
        raise QuestionError(f"no tangent plane at {u}, {v}", remedy="see singular_points")
    mean = forms.minimality(u, v) * surface.w(u, v) / (2 * denominator)
    return {"K": Real(numerator / denominator), "H": square_root(forms.area(u, v)) * mean}


def _by_axis(point: tuple[mpq, ...]) -> dict[str, Real]:
    return {axis: Real(x) for axis, x in zip("xyz", point, strict=False)}


def _inside(surface: NurbsSurface, u: mpq, v: mpq) -> None:
    """Raise `QuestionError` on a knot line inside of the surface: derivatives of its two sides may differ."""
    for t, mesh, name in zip((u, v), surface.meshes, "uv", strict=True):
        if t in mesh.breaks[1:-1]:
            raise QuestionError(
                f"{name} = {t} is a knot, where derivatives of the two sides may differ", remedy="ask inside a patch"
            )


#: How questions at a place are written.
FORMS = {"value": "value@1/2,1/3", "derivative": "derivative:1,0@1/2,1/3", "curvature": "curvature@1/2,1/3"}
#: What can be asked at a place.
AT_A_PLACE: Mapping[str, Callable[[NurbsSurface, str, mpq, mpq], dict[str, Real]]] = {
    "value": _point,
    "derivative": _derivative,
    "curvature": _curvature,
}
