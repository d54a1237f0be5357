"""The intersection multiplicity of two polynomials at a rational point by linear algebra: the dimension of the quotient
of polynomials up to some degree by the multiples of both. It uses neither resultants nor factors.
"""

from flint import fmpq_mat

from exactspline.polynomials.two_parameters import CONTEXT, S, T


def local_dimension(f, g, place, most=12):
    """How often f and g vanish together at a point, less than `most`."""
    moved = [_moved(p, place) for p in (f, g)]
    before = -1
    for k in range(1, most + 2):
        # multiples of both, without what is of degree k or more
        monomials = [(i, j) for i in range(k) for j in range(k - i)]
        rows = [[p.get((a - i, b - j), 0) for a, b in monomials] for p in moved for i, j in monomials]
        found = len(monomials) - fmpq_mat(rows).rank()
        if found == before:
            return found
        before = found
    raise AssertionError("the polynomials have a common factor through the point, or it is of a higher multiplicity")


def _moved(p, place):
    """The coefficients in parameters that are 0 at the point, up to a constant."""
    (a, b), (c, d) = ((int(x.numerator), int(x.denominator)) for x in place)
    m, n = (max(int(k), 0) for k in p.degrees())
    total = CONTEXT.from_dict({})
    for (i, j), x in p.terms():
        total += x * (d * T + c) ** int(j) * d ** (n - int(j)) * (b * S + a) ** int(i) * b ** (m - int(i))
    return {(int(i), int(j)): x for (i, j), x in total.terms()}
