"""The value of a formula on a surface as data: control nets at their lowest degrees."""

from __future__ import annotations

from typing import Any

from exactspline.display.bisector_data import control_net
from exactspline.errors import FormulaError
from exactspline.geometry.surface.forms import lowest
from exactspline.language.formula import Formula
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector
from exactspline.splines.surface import NurbsSurface
from exactspline.splines.tensor import TensorSpline
from exactspline.splines.tensor_lowest_terms import in_lowest_terms


def surface_value_data(formula: Formula, surface: NurbsSurface, name: str) -> dict[str, object]:
    """The value of a formula on a surface, exactly: a quotient in lowest terms by homogeneous control points ``(w f,
    w)``, a polynomial by its control points.

    >>> from exactspline import example
    >>> from exactspline.papers import find
    >>> data = surface_value_data(find("surfaces:gaussian_curvature"), example("sphere"), "sphere")
    >>> data["degree"], data["homogeneous_control_net"][0][0]
    ([0, 0], ['1', '1'])

    Raises `FormulaError` for a formula that is not about such a surface.
    """
    if surface.dimension not in formula.kind.dimensions or formula.kind.name not in ("surface", "planar map"):
        raise FormulaError(
            f"{formula.name} of a surface in R{surface.dimension}",
            remedy=f"it is defined for a {formula.kind.name} in R{formula.kind.dimensions[0]}",
        )
    value = surface.remembering().calls(formula)
    if isinstance(value, Rational):
        reduced = in_lowest_terms(value)
        top, bottom = reduced.numerator, reduced.denominator
        splines: list[TensorSpline] = [*(top if isinstance(top, Vector) else [top]), bottom]
        layout = "quotient"
    else:
        parts: list[Any] = list(value) if isinstance(value, Vector) else [value]
        splines = [lowest(f) for f in parts]
        layout = "polynomial"
    return {"name": formula.name, "surface": name, "layout": layout} | control_net(splines)
