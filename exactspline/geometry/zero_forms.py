"""The forms whose zeros are the features of a curve, and these zeros."""

from __future__ import annotations

from exactspline.geometry.analysis import analyse
from exactspline.geometry.constructions import Variant
from exactspline.roots.zero_set import ZeroSet
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs


def zero_form(curve: Nurbs, name: str, variant: Variant | str = Variant.MINIMAL) -> tuple[BSpline, ZeroSet]:
    """The form of a zero-set construction on a curve, with the sign it has for a positive weight function, and its
    certified zeros.

    >>> from exactspline.interchange.examples import example
    >>> form, zeros = zero_form(example("cubic_s"), "zero_curvature")
    >>> form.degree, len(zeros)
    (1, 1)

    Raises `ShapeError` for a curve of another dimension.
    """
    solved = analyse(curve).zero_form(name, variant)
    return solved.form, solved.zeros
