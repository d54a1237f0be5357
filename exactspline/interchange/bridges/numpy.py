"""numpy arrays: correctly rounded doubles of a curve."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from exactspline.interchange.bridges.values import doubles
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of

if TYPE_CHECKING:
    import numpy as np


class Arrays(NamedTuple):
    """A curve as arrays; the control points are Cartesian and have shape (number, dimension)."""

    degree: int
    knots: np.ndarray
    control_points: np.ndarray
    weights: np.ndarray


def to_arrays(curve: Nurbs) -> Arrays:
    """The correctly rounded data of a curve."""
    import numpy as np

    curve = curve_of(curve)
    points = np.array([doubles(point) for point in curve.control_points])
    return Arrays(curve.degree, np.array(doubles(curve.knots)), points, np.array(doubles(curve.weights)))
