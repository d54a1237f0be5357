"""scipy's piecewise polynomials: read exactly; `BSpline` written with correct rounding."""

from __future__ import annotations

from itertools import pairwise
from math import comb
from typing import TYPE_CHECKING, Any, TypeAlias

from exactspline.errors import ShapeError, shown
from exactspline.interchange.bridges.values import doubles, exact, exact_rows
from exactspline.numbers.exact import mpq
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of

if TYPE_CHECKING:
    import numpy as np
    import scipy.interpolate

    #: scipy's classes of splines in one parameter; `CubicSpline`, `PchipInterpolator` and the like are `PPoly`.
    Piecewise: TypeAlias = (
        scipy.interpolate.BSpline
        | scipy.interpolate.PPoly
        | scipy.interpolate.BPoly
        | tuple[np.ndarray, np.ndarray | list[np.ndarray], int]
    )


def from_scipy(spline: Piecewise) -> Nurbs | BSpline:
    """The exact curve of a vector-valued spline, the exact `BSpline` of a scalar one: every double is taken at its
    binary value.

    Takes scipy's `BSpline`, `PPoly` (with it `CubicSpline`, `PchipInterpolator`, `Akima1DInterpolator`), `BPoly`, and
    the ``(t, c, k)`` of `splrep` and `splprep`. Neighbouring pieces of a `PPoly` agree only up to rounding at their
    common breakpoint, so breakpoints get full multiplicity and each piece keeps its end points.

    >>> from scipy.interpolate import CubicSpline
    >>> from_scipy(CubicSpline([0, 1, 2], [0, 1, 0]))("1/2")
    mpq(3,4)

    Raises `ShapeError` for anything else and for coefficient arrays of more than two axes, and the errors of `Nurbs`.
    """
    import numpy as np
    import scipy.interpolate as si

    given: Any = spline
    if isinstance(given, (tuple, list)) and len(given) == 3:
        t, c, k = given
        # splprep lists the coefficients of each coordinate
        given = si.BSpline(t, np.stack(c, axis=1) if isinstance(c, (list, tuple)) else c, k) if _is_tck(t, k) else None
    if isinstance(given, (si.PPoly, si.BPoly)):
        return _of_pieces(given.c, given.x, powers=isinstance(given, si.PPoly))
    if not isinstance(given, si.BSpline):
        raise ShapeError(
            f"{shown(spline)} is not a scipy spline in one parameter",
            remedy="give a BSpline, PPoly or BPoly of scipy.interpolate, or (t, c, k)",
        )
    degree, knots = int(given.k), [exact(t) for t in given.t]
    # scipy allows more coefficients than the knots require
    return _made(degree, knots, given.c[: len(knots) - degree - 1])


def _is_tck(t: object, k: object) -> bool:
    import numpy as np

    return isinstance(t, (np.ndarray, list, tuple)) and isinstance(k, (int, np.integer))


def _made(degree: int, knots: list[mpq], coefficients: np.ndarray) -> Nurbs | BSpline:
    if coefficients.ndim == 1:
        return BSpline(degree, knots, [exact(c) for c in coefficients])
    if coefficients.ndim != 2:
        raise ShapeError(f"coefficients of shape {coefficients.shape}", remedy="a curve has one row per control point")
    return Nurbs(degree, knots, exact_rows(coefficients))


def _of_pieces(c: np.ndarray, x: np.ndarray, *, powers: bool) -> Nurbs | BSpline:
    """The spline of pieces given by Bernstein coefficients ``c[i, piece]``, or by coefficients of the powers of the
    distance from the start of the piece, highest power first.
    """
    import numpy as np

    degree, breaks = len(c) - 1, [exact(t) for t in x]
    if breaks[0] > breaks[-1]:
        raise ShapeError("breakpoints that decrease", remedy="give the spline of −x, whose breakpoints increase")
    exactly = np.vectorize(exact, otypes=[object])(c)
    if powers:
        exactly = exactly[::-1].copy()
        for piece, (a, b) in enumerate(pairwise(breaks)):
            scaled = [exactly[j, piece] * (b - a) ** j for j in range(degree + 1)]
            for i in range(degree + 1):
                exactly[i, piece] = sum(scaled[j] * mpq(comb(i, j), comb(degree, j)) for j in range(i + 1))
    rows = np.swapaxes(exactly, 0, 1).reshape(-1, *exactly.shape[2:])
    return _made(degree, [t for t in breaks for _ in range(degree + 1)], rows)


def to_scipy(curve: Nurbs | BSpline) -> scipy.interpolate.BSpline:
    """A scipy spline with the correctly rounded knots and control points.

    Raises `ShapeError` for a rational curve, for which scipy has no class, and for anything but a curve or a spline.
    """
    coefficients: list[float] | list[list[float]]
    if isinstance(curve, BSpline):
        coefficients = doubles(curve.control_points)
    elif curve_of(curve).polynomial:
        coefficients = [doubles(point) for point in curve.control_points]
    else:
        raise ShapeError("a rational curve", remedy="convert the components of its p and w separately")

    import numpy as np
    from scipy.interpolate import BSpline as SciPyBSpline

    return SciPyBSpline(np.array(doubles(curve.knots)), np.array(coefficients), curve.degree)
