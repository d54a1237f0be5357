"""Splines in lowest terms. Three degrees are distinguished: nominal (counted as in Table 1 of the paper, Chen,
Riesenfeld and Cohen 2007), represented (of the given spline) and true (after exact division).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeVar, cast

from flint import Ordering, fmpz, fmpz_mpoly, fmpz_mpoly_ctx, fmpz_poly

from exactspline.errors import ReductionError
from exactspline.language.provenance import leaf
from exactspline.language.rational import Rational
from exactspline.language.ruled import RuledSurface, split
from exactspline.language.vector import Vector
from exactspline.numbers.exact import common_divisor, text
from exactspline.polynomials import tensor_bernstein
from exactspline.polynomials.bernstein import ONE, divide_u_plus_v, over_common_denominator, raiser
from exactspline.polynomials.factors import certainly_coprime, greatest_common_divisor
from exactspline.splines.bspline import BSpline, from_parts
from exactspline.splines.common import with_common_knots
from exactspline.splines.knots import Mesh
from exactspline.splines.tensor import TensorSpline, aligned, make
from exactspline.splines.tensor_patches import Degrees
from exactspline.splines.type_checks import spline_of

#: Vectors of splines: polynomial, or over a common denominator.
SplineVector = Vector[BSpline] | Rational[BSpline]
#: Ruled surfaces of such vectors.
SplineSurface = RuledSurface[SplineVector]
#: Quotients of splines.
RationalSurface = RuledSurface[Rational[BSpline]]
#: The values of formulas.
SplineValue = BSpline | SplineVector | SplineSurface


def common_factor(v: Vector[BSpline]) -> BSpline:
    """A spline that vanishes exactly where all components do: their greatest common divisor, segment by segment.

    >>> t = BSpline.identity(0, 1)
    >>> common_factor(Vector(t * (t + 1), t * (t + 2))).true_degree
    1
    """
    rows = []
    for parts in zip(*[c.numerators for c in v], strict=True):
        common = _greatest_common_divisor(parts)
        at_end = min((x.degree - c.degree() for x, c in zip(v, parts, strict=True) if c), default=0)
        rows.append(([common], max(common.degree(), 0) + at_end))
    return _raised(rows, v[0].mesh)[0]


def _greatest_common_divisor(parts: Sequence[fmpz_poly]) -> fmpz_poly:
    if len(parts) > 1 and parts[0] and certainly_coprime(parts[0], parts[1]):
        return fmpz_poly([common_divisor(c.content() for c in parts)])
    return greatest_common_divisor(parts)


def _scalars(value: SplineValue) -> list[BSpline]:
    components: list[BSpline]
    components, denominator = split(value)
    return components if denominator is None else [*components, denominator]


def control_point_count(value: SplineValue) -> int:
    """Return the number of control points of a spline, a vector or a quotient, if all components are written with their
    largest degree, their lowest continuity, and the knots of all components.
    """
    common = with_common_knots(spline_of(each) for each in _scalars(value))[0]
    inner_points: int = sum(max(common.degree - c, 0) for c in common.continuity)
    ends: int = max(common.degree + 1, 0)
    return ends + inner_points


def true_degree(value: BSpline | SplineVector) -> int:
    """The degree after exact division by u + v and, for a quotient, by the common factor of numerator and denominator;
    the largest over the segments.
    """
    if not isinstance(value, Rational):
        components: list[BSpline] = list(value) if isinstance(value, Vector) else [value]
        return max(c.true_degree for c in components)
    return -1 if value.is_zero else max(n for _, n in lowest_terms(value))


def true_degree_or_none(value: BSpline | SplineVector) -> int | None:
    """The true degree; None if a denominator vanishes on a whole segment."""
    try:
        return true_degree(value)
    except ReductionError:
        return None


def lowest_terms(value: Rational[BSpline]) -> list[tuple[list[fmpz_poly], int]]:
    """Segment by segment the components of a quotient without their common factor, the denominator last and positive,
    and the remaining degree.

    The components are homogeneous forms of the same degree, so that the factors u (a zero at the right end), v and u +
    v (a degree too high) are common factors like any other. Raises `ReductionError` if the denominator vanishes on a
    whole segment.
    """
    if (gap := next((i for i, c in enumerate(value.denominator.numerators) if not c), None)) is not None:
        a, b = value.denominator.breakpoints[gap : gap + 2]
        raise ReductionError(
            f"the denominator vanishes on all of [{text(a)}, {text(b)}]",
            where=f"segment {gap}",
            remedy="restrict the spline to the other segments",
            segment=gap,
        )
    return _lowest_rows(_scalars(value))


def _lowest_rows(scalars: list[BSpline]) -> list[tuple[list[fmpz_poly], int]]:
    """The lowest terms of several splines segment by segment; 0/1 on segments on which the last spline vanishes."""
    n = max(s.degree for s in scalars)
    rows = []
    for forms in zip(*[s.forms for s in scalars], strict=True):
        polynomials, _ = over_common_denominator(forms)
        homogeneous = [c * raiser(n - s.degree) for c, s in zip(polynomials, scalars, strict=True)]
        rows.append(
            _lowest(homogeneous, n) if homogeneous[-1] else ([*[fmpz_poly([])] * (len(scalars) - 1), fmpz_poly([1])], 0)
        )
    return rows


def _lowest(forms: list[fmpz_poly], n: int, *, sign_of_last: bool = True) -> tuple[list[fmpz_poly], int]:
    """Forms of degree n without their common factor. The sign is chosen such that the common factor, or with
    `sign_of_last` the last form, is positive at a parameter inside.
    """
    common = greatest_common_divisor(forms)
    left = n - common.degree() - (n - max(c.degree() for c in forms))
    forms = [c // common for c in forms]
    judge, most = (forms[-1], left) if sign_of_last else (common, n)
    positive = next(value > 0 for j in range(1, most + 3) if (value := judge(j)))
    return (forms if positive else [-c for c in forms]), left


def without_factor(f: BSpline, w: BSpline, times: int) -> BSpline:
    """`f` divided, segment by segment, by its common factor with a power of `w`, which has no zeros; the sign is
    preserved. Without a common factor the spline is unchanged; otherwise each segment is divided by a different
    positive factor.
    """
    if w.degree <= 0 or f.is_zero or f.mesh.breaks != w.mesh.breaks:
        return f
    rows = [
        _without(p, divide_u_plus_v(q, w.degree)[0], times) for p, q in zip(f.numerators, w.numerators, strict=True)
    ]
    if not any(lost for _, lost in rows):
        return f
    least = min(lost for p, lost in rows if p)
    forms = [(p * raiser(lost - least) if p else p, m) for (p, lost), m in zip(rows, f.denominators, strict=True)]
    return BSpline.from_forms(f.degree - least, f.mesh, (-1,) * (len(f.mesh) - 1), forms)


def _without(p: fmpz_poly, q: fmpz_poly, times: int) -> tuple[fmpz_poly, int]:
    """p without its common factor with a power of q, made positive, and the degree of this factor."""
    lost = 0
    if q.degree() > 0 and p and certainly_coprime(p, q):
        return p, lost
    for _ in range(times if p else 0):
        common = greatest_common_divisor([p, q])
        common = common // (common.content() if common(1) > 0 else -common.content())
        if common.degree() <= 0:
            break
        p, lost = p // common, lost + common.degree()
    return p, lost


def primitive(f: BSpline) -> BSpline:
    """`f` times the positive constant that makes the integers of all its forms coprime; the continuity does not change.

    >>> primitive(BSpline.bezier(["2/3", "4/3"])).control_points
    (mpq(1,1), mpq(2,1))
    """
    if f.is_zero:
        return f
    polynomials, _ = over_common_denominator(list(zip(f.numerators, f.denominators, strict=True)))
    content = common_divisor(c.content() for c in polynomials)
    if content != 1:
        polynomials = [c // content for c in polynomials]
    return from_parts(f.degree, f.mesh, f.continuity, tuple(polynomials), (ONE,) * len(polynomials), leaf())


V = TypeVar("V", bound=SplineValue)


def in_lowest_terms(value: V) -> V:
    """The same scalar, vector or quotient, in the lowest degree that suffices on all segments.

    A quotient is reduced segment by segment, each by a different factor, so that numerator and denominator are only C⁻¹
    although the continuity of their quotient does not change. Other values lose powers of u + v and keep their
    continuity.

    >>> from exactspline.interchange.examples import example
    >>> from exactspline.papers import find
    >>> in_lowest_terms(find("evolute")(example("circle"))).degree
    0

    For a ruled surface the directrix is reduced to q/v like any quotient; the ruling parameter is free, so that any
    factor may be removed from the generator: it becomes g/v with the primitive polynomial vector g of its direction,
    segment by segment. As a quotient (q + ζ g)/v, the surface then has the least degree in s among surfaces with this
    directrix.
    """
    reduced: Any = value
    if isinstance(value, RuledSurface):
        directrix, generator = in_lowest_terms(value.directrix), primitive_part(value.generator)
        over = generator if isinstance(directrix, Vector) else Rational(generator, directrix.product)
        reduced = RuledSurface(directrix, over)
    elif isinstance(value, Vector):
        by = min(c.degree - c.true_degree for c in value if not c.is_zero) if not value.is_zero else 0
        reduced = Vector(*[c.reduce_degree(by) if not c.is_zero else c for c in value])
    elif isinstance(value, Rational):
        reduced = _over_rows(value, lowest_terms(value))
    elif value.is_zero:
        reduced = value.constant(0)
    elif value.true_degree < value.degree or any(c >= value.degree for c in value.continuity):
        reduced = value.reduce_degree(value.degree - value.true_degree)
    return cast(V, reduced)


def primitive_part(value: SplineVector) -> Vector[BSpline]:
    """The polynomial vector of least degree with the direction of a vector or a vector quotient, segment by segment.

    The result has the direction of the vector in the first half of each segment (except at parameters where the vector
    vanishes).

    >>> from exactspline.interchange.examples import example
    >>> from exactspline.papers import find
    >>> primitive_part(find("chen_riesenfeld_cohen_2007:normal")(example("rational_space_cubic"))).degree
    7
    """
    vector = in_lowest_terms(value).numerator if isinstance(value, Rational) else value
    assert isinstance(vector, Vector)
    n, rows = vector.degree, []
    for forms in zip(*[c.forms for c in vector], strict=True):
        polynomials, _ = over_common_denominator(forms)
        parts = [c * raiser(n - x.degree) for c, x in zip(polynomials, vector, strict=True)]
        rows.append(_lowest(parts, n, sign_of_last=False) if any(parts) else (parts, 0))
    return Vector(*_raised(rows, vector[0].mesh))


def where_it_exists(value: Rational[BSpline]) -> Rational[BSpline]:
    """A quotient in lowest terms segment by segment, 0/1 on segments where its denominator vanishes identically.

    >>> from exactspline.interchange.examples import example
    >>> from exactspline.papers import find
    >>> where_it_exists(find("torsion")(example("space_line")))(0)
    mpq(0,1)
    """
    return _over_rows(value, _lowest_rows(_scalars(value)))


def _over_rows(value: Rational[BSpline], rows: list[tuple[list[fmpz_poly], int]]) -> Rational[BSpline]:
    """The quotient whose segments are the rows, raised to a common degree."""
    *numerator, denominator = _raised(rows, value.denominator.mesh)
    return Rational(Vector(*numerator) if value.is_vector else numerator[0], denominator)


def _raised(rows: list[tuple[list[fmpz_poly], int]], mesh: Mesh) -> list[BSpline]:
    """The splines whose segments are the rows, raised to a common degree."""
    n = max(degree for _, degree in rows)
    columns = zip(*[[(c * raiser(n - degree), ONE) for c in forms] for forms, degree in rows], strict=True)
    return [BSpline.from_forms(n, mesh, (-1,) * (len(mesh) - 1), forms) for forms in columns]


# ---- in two parameters


CONTEXT = fmpz_mpoly_ctx.get(["z", "y"], Ordering.lex)


def as_mpoly(c: fmpz_poly, stride: int) -> fmpz_mpoly:
    """A packed patch as a polynomial in two variables, z for the first parameter."""
    return CONTEXT.from_dict({(i % stride, i // stride): x for i, x in enumerate(c.coeffs()) if x})


def as_packed(p: fmpz_mpoly, stride: int) -> fmpz_poly:
    """The packed patch of a polynomial in z and y."""
    coefficients = [fmpz(0)] * (1 + max((int(i) + stride * int(j) for i, j in p.monoms()), default=0))
    for (i, j), x in p.terms():
        coefficients[int(i) + stride * int(j)] = x
    return fmpz_poly(coefficients)


def surface_in_lowest_terms(value: Rational[TensorSpline]) -> Rational[TensorSpline]:
    """The same quotient without common factors of numerator and denominator, in the lowest degrees that suffice on all
    patches.

    Each patch is divided by a different factor, so that numerator and denominator are only C⁻¹ although the continuity
    of their quotient does not change.

    >>> from exactspline.interchange.examples import example
    >>> from exactspline.papers import find
    >>> from exactspline.splines.tensor import surface_pair
    >>> pair = surface_pair(example("rational_space_cubic"), example("twisted_cubic"))
    >>> surface_in_lowest_terms(find("bisector_symmetric")(pair)).degree
    Degrees(s=10, t=8)

    Raises `ReductionError` if the denominator vanishes on a whole patch.
    """
    top, w = value.elevated()
    scalars = aligned(*top, w) if isinstance(top, Vector) else aligned(top, w)
    w = scalars[-1]
    stride = max(s.stride for s in scalars)
    lowest = []
    columns = [zip(s.at_stride(stride), s.denominators, strict=True) for s in scalars]
    for at, forms in enumerate(zip(*columns, strict=True)):
        polynomials, _ = over_common_denominator(forms)
        if not polynomials[-1]:
            raise ReductionError(
                f"the denominator vanishes on all of {place(w, at)}", remedy="restrict the surface to the other patches"
            )
        lowest.append(_lowest_on_patch([as_mpoly(c, stride) for c in polynomials]))
    return _joined(value, w, lowest)


def _lowest_on_patch(forms: list[fmpz_mpoly]) -> tuple[list[fmpz_mpoly], Degrees]:
    """The forms without their common factor, and the remaining degree: factors u and ū lower it."""
    common = greatest_common_divisor(forms)
    forms = [form / common for form in forms]
    s, t = (max(int(form.degrees()[i]) for form in forms if form) for i in range(2))
    return forms, Degrees(s, t)


def _joined(
    value: Rational[TensorSpline], w: TensorSpline, lowest: list[tuple[list[fmpz_mpoly], Degrees]]
) -> Rational[TensorSpline]:
    """The quotient with these patches, raised to a common degree."""
    degree = Degrees(max(d.s for _, d in lowest), max(d.t for _, d in lowest))
    stride = tensor_bernstein.stride_for(degree.s)
    first, second = w.meshes
    rough = (-1,) * (len(first) - 1), (-1,) * (len(second) - 1)
    columns = []
    for forms, own in lowest:
        lift = raiser(degree.s - own.s) * raiser(degree.t - own.t).inflate(stride)
        columns.append([as_packed(form, stride) * lift for form in forms])
    ones = (ONE,) * len(lowest)
    *top, bottom = [
        make(degree, w.meshes, rough, stride, column, ones, leaf()) for column in zip(*columns, strict=True)
    ]
    return Rational(Vector(*top) if value.is_vector else top[0], bottom)


def place(f: TensorSpline, at: int) -> str:
    """The patch with this number, as text."""
    i, j = divmod(at, len(f.meshes[1]))
    (a, b), (c, d) = f.meshes[0].breaks[i : i + 2], f.meshes[1].breaks[j : j + 2]
    return f"[{text(a)}, {text(b)}] × [{text(c)}, {text(d)}]"
