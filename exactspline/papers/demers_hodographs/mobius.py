"""Möbius maps: of rational curves in the plane, in complex notation, and in the conformal model."""

from exactspline.formulas.lifted import conformal_lift
from exactspline.language.complex_numbers import complex_product, complex_quotient, conjugate
from exactspline.language.formula import formula
from exactspline.language.vector import join, norm2

#: Two complex polynomials P = x + iy and Q = z + iw, formed from the four functions of a rational space curve.
PAIR = "space"
WITH_CONSTANTS = "space with a, b, m, n"


@formula("In the plane, Möbius is a linear map", on="plane")
def real_inversion(c):
    """``1/z = z̄/|z|²`` of a rational curve."""
    return conjugate(c.p) * c.w / norm2(c.p)


@formula("In the plane, Möbius is a linear map", on="plane")
def inversion_times_curve(c):
    """``z · 1/z − 1``."""
    product = complex_product(c.gamma, real_inversion(c))
    return join(product[0] - 1, product[1])


@formula("PH in one line", on=PAIR, symbol="P")
def complex_numerator(c):
    """``P = x + iy``."""
    return join(c.p[0], c.p[1])


@formula("PH in one line", on=PAIR, symbol="Q")
def complex_denominator(c):
    """``Q = z + iw``."""
    return join(c.p[2], c.w)


@formula("PH in one line", on=PAIR)
def functions_squared(c):
    """``|P|² + |Q|²``: the squares of four functions."""
    return norm2(complex_numerator(c)) + norm2(complex_denominator(c))


@formula("PH in one line", on=PAIR, symbol="M")
def complex_wronskian(c):
    """``M = P′Q − PQ′``."""
    p, q = complex_numerator(c), complex_denominator(c)
    return complex_product(p.d(1), q) - complex_product(p, q.d(1))


@formula("PH in one line", on=PAIR)
def complex_velocity(c):
    """The derivative of ``z = P/Q``."""
    return complex_quotient(complex_numerator(c), complex_denominator(c)).d(1)


@formula("PH in one line", on=PAIR)
def complex_velocity_by_wronskian(c):
    """``M/Q²``."""
    q = complex_denominator(c)
    return complex_quotient(complex_wronskian(c), complex_product(q, q))


@formula("PH in one line", on=PAIR)
def complex_speed_squared(c):
    """``|z′|²``."""
    return norm2(complex_velocity(c))


@formula("PH in one line", on=PAIR)
def complex_speed_squared_by_wronskian(c):
    """``M M̄/(Q Q̄)²``."""
    return norm2(complex_wronskian(c)) / norm2(complex_denominator(c)) ** 2


@formula("PH in one line", on=PAIR)
def inverted_wronskian(c):
    """M of ``1/z = Q/P``."""
    p, q = complex_numerator(c), complex_denominator(c)
    return complex_product(q.d(1), p) - complex_product(q, p.d(1))


@formula("PH in one line", on=WITH_CONSTANTS)
def affine_numerator(c):
    """``(a + ib) P + (m + in) Q``."""
    return complex_product(join(c.a, c.b), complex_numerator(c)) + complex_product(
        join(c.m, c.n), complex_denominator(c)
    )


@formula("PH in one line", on=WITH_CONSTANTS)
def affine_image(c):
    """The map of the pair, as a quotient."""
    return complex_quotient(affine_numerator(c), complex_denominator(c))


@formula("PH in one line", on=WITH_CONSTANTS)
def affine_image_of_point(c):
    """``(a + ib) z + (m + in)`` for ``z = P/Q``."""
    z = complex_quotient(complex_numerator(c), complex_denominator(c))
    turned = complex_product(join(c.a, c.b), z)
    return join(turned[0] + c.m, turned[1] + c.n)


@formula("PH in one line", on=WITH_CONSTANTS)
def affine_wronskian(c):
    """M of ``(a + ib) z + (m + in)``."""
    p, q = affine_numerator(c), complex_denominator(c)
    return complex_product(p.d(1), q) - complex_product(p, q.d(1))


@formula("PH in one line", on=WITH_CONSTANTS)
def turned_wronskian(c):
    """``(a + ib) M``."""
    return complex_product(join(c.a, c.b), complex_wronskian(c))


def _form(a, b, e):
    """``‖b‖² − a e``: the Minkowski form in which ``(‖p‖², w p, w²)`` is null."""
    return norm2(b) - a * e


@formula("Möbius invariance is two lines", on="space")
def conformal_square(c):
    """The form on P."""
    lift = conformal_lift(c)
    return _form(lift[0], lift[1:4], lift[4])


@formula("Möbius invariance is two lines", on="space")
def conformal_speed_squared(c):
    """The form on P′: h², the squared numerator of the speed."""
    lift = conformal_lift(c).d(1)
    return _form(lift[0], lift[1:4], lift[4])
