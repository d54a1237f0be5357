"""Points through which a plane curve passes several times: all its parameters there, and the intersection multiplicity
of two of the branches that meet there.
"""

from __future__ import annotations

from functools import reduce

from flint import arb_poly, ctx, fmpq_poly, fmpz_poly

from exactspline.numbers.exact import mpq, to_fmpq
from exactspline.polynomials.bernstein import backwards
from exactspline.polynomials.bezout import PlaneForms
from exactspline.polynomials.common_arcs import RationalMap
from exactspline.polynomials.elimination import resultant
from exactspline.polynomials.factorization import divided_out
from exactspline.polynomials.factors import factorize_square_free
from exactspline.polynomials.over_root import OverRoot
from exactspline.polynomials.two_parameters import S, T, lifted, rows_of
from exactspline.polynomials.zero_places import FIRST, Place, at


class Fibre:
    """All parameters of the first curve at one point of the second, as zeros of a polynomial over the field of the
    place; without those of a map from the second curve to the first.
    """

    def __init__(self, first: PlaneForms, second: PlaneForms, place: Place, carried: RationalMap | None = None) -> None:
        self.place = place
        self.modulus = fmpq_poly([0, 1] if place.exact is not None else place.irreducible)
        x, y, w = (self._element(form, second.degree) for form in second.forms)
        rows = [(first.x, w, first.w, x), (first.y, w, first.w, y), (first.x, y, first.y, x)]
        minors = [p for row in rows if (p := self._minor(*row))]
        common = reduce(lambda p, q: p.gcd(q), minors)
        self.at_end = max(p.degree for p in minors) < first.degree
        if carried is not None:
            common = self._without(common, carried)
        self.at_start = not common.coefficients[0]
        common = OverRoot(common.coefficients[next(i for i, c in enumerate(common.coefficients) if c) :], self.modulus)
        self.polynomial = common.radical

    @property
    def size(self) -> int:
        """The number of parameters, real and complex, each counted once."""
        return self.polynomial.degree + self.at_start + self.at_end

    def _element(self, form: fmpz_poly, n: int) -> fmpq_poly:
        t = self.place.exact
        if t is None:
            return fmpq_poly(form) % self.modulus
        return fmpq_poly([form[n] if t == 1 else form(to_fmpq(t / (1 - t)))])

    def _minor(self, p: fmpz_poly, a: fmpq_poly, q: fmpz_poly, b: fmpq_poly) -> OverRoot:
        return OverRoot([a * p[i] - b * q[i] for i in range(max(p.degree(), q.degree()) + 1)], self.modulus)

    def _without(self, common: OverRoot, carried: RationalMap) -> OverRoot:
        top, bottom = self._element(carried.top, carried.degree), self._element(carried.bottom, carried.degree)
        factor = OverRoot([-top, bottom], self.modulus)
        if factor.degree == 0:
            self.at_end = False
            return common
        return divided_out(common, factor)

    def contains(self, s: Place) -> bool:
        """Whether a parameter belongs to it. All real zeros of the polynomial must be among the zeros from which the
        place was isolated.
        """
        bits = FIRST
        while (t := s.exact) is None:
            low, high = s.refine(bits)
            if low != high < 1:
                before, behind = (self._sign(end / (1 - end)) for end in (low, high))
                if before and behind:
                    return before != behind
            bits *= 2
        if t in (0, 1):
            return self.at_start if t == 0 else self.at_end
        return self._sign(t / (1 - t)) == 0

    def _sign(self, z: mpq) -> int:
        return self.place.sign_of_element(self.polynomial(z))


# ---- multiplicity


def local_multiplicity(
    first: PlaneForms, second: PlaneForms, s: Place, t: Place, carried: RationalMap | None = None
) -> int:
    """The intersection multiplicity of two branches at a common point through which both curves may pass several
    times: that of the value ``z_t + λ z_s`` as a zero of the resultant, the least over as many λ as there may be
    zeros: one of them separates it from the values of all other common zeros. A factor that belongs to a map from the
    second to the first is divided out.
    """
    if s.exact == 1:
        first, s = _reversed(first), at(mpq(0))
        carried = carried and RationalMap(carried.degree, carried.bottom, carried.top)
    if t.exact == 1:
        second, t = _reversed(second), at(mpq(0))
        carried = carried and RationalMap(
            carried.degree, backwards(carried.top, carried.degree), backwards(carried.bottom, carried.degree)
        )
    equations = [
        lifted(p, 0) * lifted(second.w, 1) - lifted(first.w, 0) * lifted(q, 1)
        for p, q in zip(first.forms[:2], second.forms[:2], strict=True)
    ]
    if carried is not None:
        factor = S * lifted(carried.bottom, 1) - lifted(carried.top, 1)
        equations = [divided_out(p, factor) for p in equations]
    found = list[int]()
    while True:
        slope = len(found) + 1
        eliminant = resultant(*[rows_of(p.compose(S, T - slope * S).compose(T, S)) for p in equations])
        found.append(multiplicity_of_sum(eliminant, s, t, slope))
        if found[-1] == 1 or slope > eliminant.degree():
            return min(found)


def _reversed(curve: PlaneForms) -> PlaneForms:
    return PlaneForms(curve.degree, *[backwards(form, curve.degree) for form in curve.forms])


def multiplicity_of_sum(eliminant: fmpz_poly, s: Place, t: Place, slope: int) -> int:
    """The multiplicity of ``z_t + λ z_s`` as a zero, which it is."""
    powers, bits = list(factorize_square_free(eliminant).powers), FIRST
    while True:
        with ctx.workprec(4 * bits):
            value = t.z(bits) + s.z(bits) * slope
            possible = [e for g, e in powers if arb_poly(g)(value).contains(0)]
        if len(possible) == 1:
            (only,) = possible
            return only
        bits *= 2
