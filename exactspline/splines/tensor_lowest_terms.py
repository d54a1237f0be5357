"""Quotients of splines in two parameters in lowest terms, patch by patch."""

from __future__ import annotations

from flint import Ordering, fmpz, fmpz_mpoly, fmpz_mpoly_ctx, fmpz_poly

from exactspline.errors import ReductionError
from exactspline.language.provenance import leaf
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector
from exactspline.numbers.exact import text
from exactspline.polynomials import tensor_bernstein
from exactspline.polynomials.bernstein import ONE, over_common_denominator, raiser
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.splines.tensor import TensorSpline, aligned, make
from exactspline.splines.tensor_patches import Degrees

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


def in_lowest_terms(value: Rational[TensorSpline]) -> Rational[TensorSpline]:
    """The same quotient with numerator and denominator without a common factor, of the lowest degrees that hold on all
    patches.

    Each patch is divided by a different factor, so that numerator and denominator are only C⁻¹ although the continuity
    of their quotient does not change.

    >>> from exactspline.interchange.examples import example
    >>> from exactspline.papers import find
    >>> from exactspline.splines.tensor import surface_pair
    >>> pair = surface_pair(example("rational_space_cubic"), example("twisted_cubic"))
    >>> in_lowest_terms(find("bisector_symmetric")(pair)).degree
    Degrees(s=10, t=8)

    Raises `ReductionError` where the denominator vanishes on a whole patch.
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
        lowest.append(_lowest([as_mpoly(c, stride) for c in polynomials]))
    return _joined(value, w, lowest)


def _lowest(forms: list[fmpz_mpoly]) -> tuple[list[fmpz_mpoly], Degrees]:
    """The forms without their common factor, and the remaining degree: factors u and ū lower it."""
    common = greatest_common_divisor(forms)
    forms = [form / common for form in forms]
    s, t = (max(int(form.degrees()[i]) for form in forms if form) for i in range(2))
    return forms, Degrees(s, t)


def _joined(
    value: Rational[TensorSpline], w: TensorSpline, lowest: list[tuple[list[fmpz_mpoly], Degrees]]
) -> Rational[TensorSpline]:
    """The patches over one degree."""
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
