"""What degrees for all d are made of, held against the polynomials themselves: the reading at infinity, the theorem's
products, reduced parts; and what does not exist is told to be missing.
"""

import pytest
from flint import Ordering, fmpq, fmpq_mpoly_ctx, fmpq_poly
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from exactspline import Nurbs, claims, example, formula_of
from exactspline.language.kinds import CURVE
from exactspline.readings import JetReading
from exactspline.readings.leading_terms import LeadingTermsReading, common_roots
from exactspline.symbolic.covariants import degree_of_product, true_degree
from exactspline.symbolic.reduction import reduction

coefficients = st.lists(st.integers(-9, 9), min_size=4, max_size=8).filter(lambda c: c[-1])


def leading(p, degree, terms):
    """The first coefficients of a polynomial from ``t^degree`` downwards."""
    return [p[degree - i] if degree >= i else fmpq(0) for i in range(terms)]


@given(coefficients, coefficients, st.integers(1, 3))
def test_an_expansion_has_the_leading_coefficients_of_the_polynomial(a, b, order):
    """x, w of degree d in the power basis: of x⁽ᵏ⁾, of x⁽ᵏ⁾w and of (x w′)⁽ᵏ⁾ the first three, for this d."""
    d, terms = max(len(a), len(b)) - 1, 3
    x, w = fmpq_poly([0] * (d + 1 - len(a)) + a), fmpq_poly([0] * (d + 1 - len(b)) + b)
    c = LeadingTermsReading(terms).argument(CURVE, 2)
    names = c.w.context.names()
    known = {"d": fmpq(d)} | {n: fmpq(0) for n in names if n[0] == "y"}
    for name, p in (("x", x), ("w", w)):
        known |= {f"{name}{i}": value for i, value in enumerate(leading(p, d, terms))}

    def told(expansion):
        (coefficients_told,) = expansion.parts.values()
        return [t.subs(known).leading_coefficient() if t.subs(known) else fmpq(0) for t in coefficients_told]

    def differentiated(p, n):
        for _ in range(n):
            p = p.derivative()
        return p

    assert told(c.p[0].d(order)) == leading(differentiated(x, order), d - order, terms)
    assert told(c.p[0].d(order) * c.w) == leading(differentiated(x, order) * w, 2 * d - order, terms)
    both = differentiated(x * w.derivative(), order)
    assert told((c.p[0] * c.w.d()).d(order)) == leading(both, 2 * d - 1 - order, terms)


@pytest.mark.parametrize(
    ("roots", "also", "expected"),
    [
        ([3], [], (3,)),
        ([-3], [], ()),
        ([2, 5, -1], [], (2, 5)),
        ([0, 1], [], (1,)),
        ([3, 4], [3], (3,)),
        ([7], [8], ()),
    ],
)
def test_common_roots_are_the_degrees_at_which_all_coefficients_vanish(roots, also, expected):
    """Π (d − r) · x, and beside it Π (d − s) · y."""
    context = fmpq_mpoly_ctx.get(["d", "x", "y"], Ordering.degrevlex)
    d, x, y = context.gens()
    p = x
    for r in roots:
        p = p * (d - r)
    if also:
        rest = y
        for r in also:
            rest = rest * (d - r)
        p = p + rest
    assert common_roots(p) == expected
    assert common_roots(p * (2 * d - 1)) == expected


def test_common_roots_tell_powers_of_one_variable_apart():
    context = fmpq_mpoly_ctx.get(["d", "x"], Ordering.degrevlex)
    d, x = context.gens()
    assert common_roots((d - 3) * x + (d - 5) * x**2) == ()
    assert common_roots((d - 3) * x + (d - 3) * (d - 5) * x**2) == (3,)


@pytest.mark.parametrize(
    ("one", "other", "dimension"),
    [("f2", "f2", 2), ("f2", "D1_squared", 2), ("vertices_lifted", "f2", 2), ("torsion_zeros_lifted", "D1_squared", 3)],
)
@pytest.mark.parametrize("exponent", [1, 2])
def test_a_product_has_the_degree_that_its_factors_tell(one, other, dimension, exponent):
    c = JetReading(3).argument(CURVE, dimension)
    f, g = formula_of(one)(c), formula_of(other)(c)
    told = degree_of_product([(true_degree(f), 1), (true_degree(g), exponent)])
    assert told == true_degree(f * g**exponent)
    assert all(told.at(d) == true_degree(f * g**exponent).at(d) for d in range(1, 7))


def some_curve(dimension, d, seed=7):
    """A Bézier curve of degree d with weights, generic enough."""
    state = seed

    def number():
        nonlocal state
        state = (1103515245 * state + 12345) % 2**31
        return mpq(state // 65536 % 97 + 1)

    points = [tuple(number() for _ in range(dimension)) for _ in range(d + 1)]
    return Nurbs(d, [0] * (d + 1) + [1] * (d + 1), points, [number() for _ in range(d + 1)])


@pytest.mark.parametrize(
    ("name", "dimension"),
    [
        ("f0", 2),
        ("curvature_squared", 2),
        ("curvature_squared_derivative", 2),
        ("f0_g0", 2),
        ("g2", 2),
        ("D1_D2_D3", 3),
    ],
)
@pytest.mark.parametrize("d", [4, 5])
def test_a_reduced_part_has_the_degree_it_tells_on_a_curve(name, dimension, d):
    part = reduction(name, dimension, False).main
    curve = some_curve(dimension, d)
    assert part.on(curve).true_degree == part.generic.at({"d": d})
    told = part.true
    assert told is not None
    assert told.at(d) == part.generic.at({"d": d})


def test_what_exists_nowhere_on_a_curve_is_told_to_be_missing_also_of_ruled_surfaces():
    """On a straight line γ′ × γ″ = 0: quotients and ruled surfaces with that denominator do not exist."""
    line, found = example("space_line"), set()
    for claim in claims():
        if claim.kind == "same surface" and "focal_surface" in claim.named and claim.applies_to(3, line.polynomial):
            finding = claim.check(line)
            assert finding.verdict == "INAPPLICABLE"
            assert str(finding.witness) == "γ′×γ″ vanishes on all of [0, 1]"
            assert "does not exist" in str(finding.computed)
            found.add(claim.id)
    assert found
