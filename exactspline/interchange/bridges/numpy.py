"""numpy arrays: correctly rounded doubles of a curve and of its points."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, NamedTuple

from exactspline.errors import as_items
from exactspline.interchange.bridges.values import doubles
from exactspline.numbers.exact import Number, from_float, is_float
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


def points_at(curve: Nurbs, parameters: Iterable[Number]) -> np.ndarray:
    """The points at the given parameters, as an array of shape (number, dimension). Floating-point parameters are taken
    at their exact values, and each coordinate is rounded correctly.

    Raises `DomainError` outside the domain.
    """
    import numpy as np

    curve = curve_of(curve)
    points = [doubles(curve(from_float(t) if is_float(t) else t)) for t in as_items(parameters, "parameters")]
    return np.reshape(np.array(points, dtype=float), (-1, curve.dimension))
