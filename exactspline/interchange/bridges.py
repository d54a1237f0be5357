"""Bridges to other libraries: each function imports its library only when it is called."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import groupby, pairwise
from math import comb, ulp
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

from exactspline.errors import ShapeError, a_kind, as_instance, counted, shown
from exactspline.interchange.format import homogeneous, pen_segments
from exactspline.interchange.numbers import MOST_ULPS, doubles, exact
from exactspline.interchange.pens import ContourPen
from exactspline.numbers.exact import double, mpq
from exactspline.splines.blossom import with_smooth_knots
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface
from exactspline.splines.tensor import TensorSpline
from exactspline.splines.type_checks import curve_of

if TYPE_CHECKING:
    import geomdl.abstract
    import mpmath
    import splinepy.spline
    import sympy
    from matplotlib.path import Path


# ---- scipy


if TYPE_CHECKING:
    import numpy as np
    import scipy.interpolate

    #: scipy's classes of splines in one parameter; `CubicSpline`, `PchipInterpolator` and the like are `PPoly`.
    Piecewise: TypeAlias = (
        scipy.interpolate.BSpline
        | scipy.interpolate.PPoly
        | scipy.interpolate.BPoly
        | scipy.interpolate.UnivariateSpline
        | tuple[np.ndarray, np.ndarray | list[np.ndarray], int]
    )
    #: The classes of splines in two parameters.
    InTwo: TypeAlias = scipy.interpolate.NdBSpline | scipy.interpolate.BivariateSpline


class ReadSpline(NamedTuple):
    """A curve, a function, a surface or a function of two parameters, and notes on the changes that were made to it."""

    curve: Nurbs | BSpline | NurbsSurface | TensorSpline
    notes: tuple[str, ...] = ()


def from_scipy(spline: Piecewise | InTwo, *, literal: bool = False) -> Nurbs | BSpline | NurbsSurface | TensorSpline:
    """Return the exact curve of a vector-valued spline, or the exact `BSpline` of a scalar spline. A spline in two
    parameters becomes a `NurbsSurface` or a `TensorSpline`. `read_scipy` returns the same with notes.

    >>> from scipy.interpolate import CubicSpline
    >>> spline = from_scipy(CubicSpline([0, 1, 2, 3], [0, 1, 0, 2]))
    >>> spline.continuity_at(1), from_scipy(CubicSpline([0, 1, 2], [0, 1, 0], bc_type="periodic")).d().segments
    (2, 2)
    """
    return read_scipy(spline, literal=literal).curve


def _periodic(degree: int, knots: Sequence[mpq], points: Sequence[object]) -> tuple[Sequence[mpq], str]:
    """The knots of a curve whose last control points are its first ones, and a note on moved knots. If the knots are
    periodic up to rounding, those outside of the domain are moved, by at most `MOST_ULPS`, so that they are exactly
    periodic; other knots are kept.

    >>> rounded = [mpq(t) if t > -3 else mpq(t) - mpq(1, 10**16) for t in range(-3, 9)]
    >>> knots, note = _periodic(3, rounded, "abcdeabc")
    >>> knots[0], note
    (mpq(-3,1), 'closed: knots outside of the domain were moved by at most 1e-16')
    """
    count, made = len(points), list(knots)
    if not 0 < degree < count or knots[0] == knots[degree] or points[:degree] != points[count - degree :]:
        return knots, ""
    ahead, width = count - degree, knots[count] - knots[degree]
    for i in reversed(range(degree)):
        made[i] = made[i + ahead] - width
    for i in range(count + 1, len(knots)):
        made[i] = made[i - ahead] + width
    change = max(abs(a - b) for a, b in zip(made, knots, strict=True))
    if not 0 < change <= MOST_ULPS * exact(ulp(max(map(float, map(abs, knots))))):
        return knots, ""
    return made, f"closed: knots outside of the domain were moved by at most {double(change, 'up'):.3g}"


def read_scipy(spline: Piecewise | InTwo, *, literal: bool = False) -> ReadSpline:
    """Return the exact spline of a spline of scipy, with the binary value of every double, and notes on the changes
    that were made.

    The spline is a `BSpline`, a `PPoly` (such as `CubicSpline`), a `BPoly`, a `UnivariateSpline`, the ``(t, c, k)`` of
    `splrep` and `splprep`, an `NdBSpline` of one or two parameters, or a `RectBivariateSpline`.

    Neighbouring pieces of a `PPoly` agree only up to rounding at their common breakpoint, as do the ends of a periodic
    spline. The smoothness that the class of the spline promises is restored: a `CubicSpline` becomes C²; a
    `PchipInterpolator`, an `Akima1DInterpolator` or a `CubicHermiteSpline` becomes C¹. A periodic spline becomes closed
    and equally smooth at its seam. A note gives the largest change of a Bézier coefficient. With `literal` the pieces
    are not changed.

    >>> from scipy.interpolate import CubicSpline
    >>> read_scipy(CubicSpline([0, 0.1, 1], [0, 1, 0.3])).notes
    ('made C2: a Bézier coefficient is changed by at most 4.48e-16, 2 units in the last place of the largest',)

    Raises `ShapeError` for anything else, for coefficients of more than two axes, and for a change of a coefficient by
    more than 8 units in the last place of the largest one; and the errors of `Nurbs`.
    """
    import numpy as np
    import scipy.interpolate as si

    given: Any = getattr(spline, "_eval_args", spline)  # (t, c, k) of a UnivariateSpline
    if isinstance(given, (tuple, list)) and len(given) == 3:
        t, c, k = given
        # splprep lists the coefficients of each coordinate
        given = si.BSpline(t, np.stack(c, axis=1) if isinstance(c, (list, tuple)) else c, k) if _is_tck(t, k) else None
    if isinstance(given, si.NdBSpline) and len(given.t) == 1:
        given = si.BSpline(given.t[0], given.c, given.k[0])
    if isinstance(given, si.NdBSpline) and len(given.t) == 2:
        return ReadSpline(_in_two(given.k, given.t, given.c))
    if isinstance(given, si.RectBivariateSpline):
        (tx, ty, c), (m, n) = given.tck, given.degrees
        return ReadSpline(_in_two((m, n), (tx, ty), np.reshape(c, (len(tx) - m - 1, len(ty) - n - 1))))
    if isinstance(given, (si.PPoly, si.BPoly)):
        breaks, pieces = _pieces(given.c, given.x, powers=isinstance(given, si.PPoly))
        order = 2 if isinstance(given, si.CubicSpline) else 1 if isinstance(given, si.CubicHermiteSpline) else -1
        order = -1 if literal else order
        counts = [len(given.c) - 1 - order] * len(pieces)
        return _joined(breaks, pieces, counts, periodic=order >= 0 and given.extrapolate == "periodic")
    if not isinstance(given, si.BSpline):
        problem = f"{shown(spline)} is not a scipy spline in one parameter or two"
        raise ShapeError(problem, remedy="give a BSpline, PPoly or BPoly of scipy.interpolate, or (t, c, k)")
    degree, knots = int(given.k), [exact(t) for t in given.t]
    # scipy allows more coefficients than the knots require
    c = given.c[: len(knots) - degree - 1]
    whole, note = (knots, "") if literal else _periodic(degree, knots, c.tolist())
    made = _made(degree, whole, c)
    if literal or note or given.extrapolate != "periodic":
        return ReadSpline(made, (note,) * bool(note))
    parts = [made] if isinstance(made, BSpline) else list(made.p)
    rows = [zip(*row, strict=True) for row in zip(*[part.bezier_points for part in parts], strict=True)]
    counts = [min(len([*same]), degree) for t, same in groupby(knots) if t in parts[0].breakpoints[:-1]]
    return _joined(list(parts[0].breakpoints), [*map(list, rows)], counts, periodic=True)


def _is_tck(t: object, k: object) -> bool:
    import numpy as np

    return isinstance(t, (np.ndarray, list, tuple)) and isinstance(k, (int, np.integer))


def _exact_rows(rows: Iterable[Iterable[object]]) -> list[list[mpq]]:
    """The exact values of rows of numbers."""
    return [[exact(value) for value in row] for row in rows]


def _made(degree: int, knots: Sequence[mpq], coefficients: np.ndarray) -> Nurbs | BSpline:
    if coefficients.ndim == 1:
        return BSpline(degree, knots, [exact(c) for c in coefficients])
    if coefficients.ndim != 2:
        raise ShapeError(f"coefficients of shape {coefficients.shape}", remedy="a curve has one row per control point")
    return Nurbs(degree, knots, _exact_rows(coefficients))


def _in_two(degrees: Any, knots: Any, net: np.ndarray) -> NurbsSurface | TensorSpline:
    """The function of two parameters, or the surface, with these coefficients."""
    m, n = map(int, degrees)
    u, v = ([exact(t) for t in row] for row in knots)
    if net.ndim == 2:
        return TensorSpline((m, n), u, v, _exact_rows(net))
    return NurbsSurface((m, n), u, v, [_exact_rows(row) for row in net])


def _pieces(c: np.ndarray, x: np.ndarray, *, powers: bool) -> tuple[list[mpq], list[list[tuple[mpq, ...]]]]:
    """The breakpoints and the Bézier points of pieces given by Bernstein coefficients ``c[i, piece]``, or by
    coefficients of the powers of the distance from the start of the piece, highest power first.
    """
    import numpy as np

    degree, breaks = len(c) - 1, [exact(t) for t in x]
    if breaks[0] > breaks[-1]:
        raise ShapeError("breakpoints that decrease", remedy="give the spline of −x, whose breakpoints increase")
    if c.ndim > 3:
        raise ShapeError(f"coefficients of shape {c.shape}", remedy="a curve has one row per coordinate")
    exactly = np.vectorize(exact, otypes=[object])(c)
    if powers:
        exactly = exactly[::-1].copy()
        for piece, (a, b) in enumerate(pairwise(breaks)):
            scaled = [exactly[j, piece] * (b - a) ** j for j in range(degree + 1)]
            for i in range(degree + 1):
                exactly[i, piece] = sum(scaled[j] * mpq(comb(i, j), comb(degree, j)) for j in range(i + 1))
    rows = np.swapaxes(exactly, 0, 1)
    return breaks, [[tuple(np.atleast_1d(point)) for point in piece] for piece in rows]


def _joined(breaks: list[mpq], pieces: list[list[tuple[mpq, ...]]], counts: list[int], *, periodic: bool) -> ReadSpline:
    """The spline of pieces over knots of these multiplicities, with a note on the changes that its smoothness
    requires.
    """
    degree, scalar = len(pieces[0]) - 1, len(pieces[0][0]) == 1
    knots, points = with_smooth_knots(degree, breaks, pieces, counts, periodic=periodic)
    curve = BSpline(degree, knots, [x for (x,) in points]) if scalar else Nurbs(degree, knots, points)
    parts = [curve] if isinstance(curve, BSpline) else list(curve.p)
    old = [x for piece in pieces for point in piece for x in point]
    rows = zip(*[part.bezier_points for part in parts], strict=True)
    new = [x for row in rows for point in zip(*row, strict=True) for x in point]
    change = max(abs(x - y) for x, y in zip(old, new, strict=True))
    units = -(-change // exact(ulp(float(max(map(abs, old))))))
    if not change:
        return ReadSpline(curve)
    order = f"C{degree - max(counts)}{' and closed' * periodic}"
    most = f"{double(change, 'up'):.3g}, {counted(int(units), 'unit')} in the last place of the largest"
    by = f"a Bézier coefficient is changed by at most {most}"
    if units > MOST_ULPS:
        raise ShapeError(f"not {order}: {by}", remedy="literal=True takes the pieces as they are")
    return ReadSpline(curve, (f"made {order}: {by}",))


def to_scipy(curve: Nurbs | BSpline) -> scipy.interpolate.BSpline:
    """Return a scipy spline with the correctly rounded knots and control points.

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


# ---- geomdl


def from_geomdl(curve: geomdl.abstract.Curve) -> Nurbs:
    """Return the curve defined by exactly the numbers that geomdl stores. By default geomdl maps the knots to [0, 1],
    which rounds the knots: if the last control points equal the first ones, the knots outside of the domain are moved,
    by at most 8 units in the last place, so that the curve is closed, and a note says so.

    Raises `ShapeError` for a surface, a volume, and objects that are not from geomdl.
    """
    from geomdl import abstract

    if not isinstance(curve, abstract.Curve):
        raise ShapeError(
            f"a {type(curve).__name__}, where a geomdl curve is expected", remedy="give a BSpline.Curve or NURBS.Curve"
        )
    degree, points = int(curve.degree), _exact_rows(curve.ctrlptsw if curve.rational else curve.ctrlpts)
    knots, note = _periodic(degree, [exact(t) for t in curve.knotvector], points)
    make = Nurbs.from_homogeneous if curve.rational else Nurbs
    return make(degree, knots, points, name=str(curve.name), note=note)


def to_geomdl(curve: Nurbs) -> geomdl.abstract.Curve:
    """Return a geomdl curve with the correctly rounded knots and points; the knots are not normalized to [0, 1]."""
    curve = curve_of(curve)

    from geomdl import NURBS
    from geomdl import BSpline as Polynomial

    made = Polynomial.Curve(normalize_kv=False) if curve.polynomial else NURBS.Curve(normalize_kv=False)
    made.degree = curve.degree
    if curve.polynomial:
        made.ctrlpts = [doubles(point) for point in curve.control_points]
    else:
        made.ctrlptsw = [doubles(homogeneous(*each)) for each in zip(curve.control_points, curve.weights, strict=True)]
    made.knotvector = doubles(curve.knots)
    return made


# ---- splinepy


def from_splinepy(curve: splinepy.spline.Spline) -> Nurbs:
    """Return the curve defined by exactly the numbers that splinepy stores, for any of the four spline classes. The
    domain of a Bézier curve is [0, 1]. If the last control points equal the first ones, the curve is closed as by
    `from_geomdl`.

    Raises `ShapeError` for a surface or a volume, and for an object that is not a spline of splinepy.
    """
    if not isinstance(getattr(curve, "para_dim", None), int) or not hasattr(curve, "degrees"):
        raise ShapeError(f"{a_kind(curve)}, where a spline of splinepy is expected", remedy="give a splinepy.BSpline")
    if curve.para_dim != 1:
        raise ShapeError(f"a spline in {curve.para_dim} parameters", remedy="a curve has one")
    degree = int(curve.degrees[0])
    if curve.has_knot_vectors:
        knots = [exact(t) for t in curve.knot_vectors[0]]
    else:
        knots = [exact(int(i > degree)) for i in range(2 * degree + 2)]
    weights = [exact(w) for row in curve.weights for w in row] if curve.is_rational else [exact(1)] * len(curve.cps)
    points = _exact_rows(curve.control_points)
    whole, note = _periodic(degree, knots, [*zip(points, weights, strict=True)])
    return Nurbs(degree, whole, points, weights, note=note)


def to_splinepy(curve: Nurbs) -> splinepy.spline.Spline:
    """Return a splinepy ``BSpline`` or ``NURBS`` with the correctly rounded knots, points and weights."""
    curve = curve_of(curve)
    import splinepy

    points = [doubles(point) for point in curve.control_points]
    knots = [doubles(curve.knots)]
    if curve.polynomial:
        return splinepy.BSpline([curve.degree], knots, points)
    return splinepy.NURBS([curve.degree], knots, points, [[w] for w in doubles(curve.weights)])


# ---- matplotlib


#: The method of a pen for each code of a path: MOVETO, LINETO, CURVE3, CURVE4.
STEPS = {1: "moveTo", 2: "lineTo", 3: "qCurveTo", 4: "curveTo"}


def from_matplotlib(path: Path) -> list[Nurbs]:
    """Return the curves of a path, one for each part that begins with ``MOVETO``, with the exact values of the doubles.

    >>> from matplotlib.path import Path
    >>> (triangle,) = from_matplotlib(Path([(0, 0), (4, 0), (0, 2), (0, 0)], closed=True))
    >>> triangle.closed, triangle("3/2")
    (True, (mpq(2,1), mpq(1,1)))

    Raises `ShapeError` for an object that is not a path, and `NumberError` for NaN and infinities.
    """
    from matplotlib.path import Path

    path, pen = as_instance(path, Path, "a path", "give a matplotlib.path.Path"), ContourPen()
    start: list[float] = []
    for row, code in path.iter_segments(remove_nans=False, simplify=False):
        points = row.reshape(-1, 2).tolist()
        if code in STEPS:
            getattr(pen, STEPS[int(code)])(*points)
            start = points[0] if code == Path.MOVETO else start
        elif code == Path.CLOSEPOLY:
            pen.closePath()
            pen.moveTo(start)  # segments that follow without MOVETO begin at this point
    pen.endPath()
    return pen.curves()


def to_matplotlib(curve: Nurbs) -> Path:
    """Return the path of a polynomial plane curve of degree 1 to 3, with correctly rounded points.

    >>> path = to_matplotlib(Nurbs.bezier([(0, 0), (1, 2), (3, 0)]))
    >>> path.codes.tolist(), path.vertices.tolist()
    ([1, 3, 3], [[0.0, 0.0], [1.0, 2.0], [3.0, 0.0]])

    Raises `ShapeError` for other curves and at a jump.
    """
    from matplotlib.path import Path

    curve = curve_of(curve)
    points = [doubles(point) for segment in pen_segments(curve) for point in segment]
    ends = points[:1] * curve.closed
    del points[curve.degree + 1 :: curve.degree + 1]  # the next segment begins here
    # LINETO, CURVE3, CURVE4 are 2, 3, 4
    codes: list[int] = [1, *[curve.degree + 1] * (len(points) - 1), *[int(Path.CLOSEPOLY)] * curve.closed]
    return Path(points + ends, codes)


# ---- mpmath


def to_mpmath(curve: Nurbs) -> Callable[[object], list[mpmath.mpf]]:
    """Return the function that maps a parameter to a point. Every coordinate is rounded once, to the working precision
    at the time of the call.

    >>> from mpmath import mpf, workdps
    >>> from exactspline.interchange.examples import example
    >>> with workdps(30):
    ...     print(to_mpmath(example("circle"))(mpf("0.25"))[0])
    0.882352941176470588235294117647
    """
    curve = curve_of(curve)

    def value(parameter: object) -> list[mpmath.mpf]:
        import mpmath
        from mpmath.libmp import from_rational, round_nearest, to_rational

        numerator, denominator = to_rational(mpmath.mpmathify(parameter)._mpf_)
        point = curve(mpq(int(numerator), int(denominator)))
        return [
            mpmath.mpf(from_rational(int(x.numerator), int(x.denominator), mpmath.mp.prec, round_nearest))
            for x in point
        ]

    return value


# ---- sympy


def to_sympy(curve: Nurbs | BSpline, symbol: sympy.Symbol | None = None) -> tuple[sympy.Expr, ...]:
    """Return the coordinates, each as a `Piecewise` in the symbol, by default t. The segments are half-open intervals
    [a, b), except that the last interval is closed.

    >>> to_sympy(BSpline(2, [0, 0, 0, 1, 1, 1], [0, 1, 0]))
    (Piecewise((-2*t**2 + 2*t, (t >= 0) & (t <= 1))),)

    Raises `ExactSplineError` for an object that is not a curve, a spline or a symbol.
    """
    import sympy

    symbol = sympy.Symbol("t") if symbol is None else symbol
    as_instance(symbol, sympy.Symbol, "a symbol", 'give sympy.Symbol("t")')
    parts = [curve] if isinstance(curve, BSpline) else list(curve_of(curve).p)
    numerators = [_polynomials(part, symbol) for part in parts]
    denominators = [1] * len(numerators[0]) if isinstance(curve, BSpline) else _polynomials(curve.w, symbol)
    breaks = [sympy.Rational(str(t)) for t in curve.breakpoints]
    conditions = [sympy.And(symbol >= a, symbol < b) for a, b in pairwise(breaks)]
    conditions[-1] = sympy.And(symbol >= breaks[-2], symbol <= breaks[-1])
    return tuple(
        sympy.Piecewise(*((p / w, where) for p, w, where in zip(row, denominators, conditions, strict=True)))
        for row in numerators
    )


def _polynomials(spline: BSpline, symbol: sympy.Symbol) -> list[sympy.Expr]:
    """One polynomial per segment, in powers of the symbol."""
    import sympy

    rows = ([sympy.Rational(int(c.p), int(c.q)) for c in p.coeffs()[::-1]] for p in spline.polynomials)
    return [sympy.Poly(row or [0], symbol).as_expr() for row in rows]
