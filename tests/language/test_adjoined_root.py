"""Roots adjoined: unit vectors, the Frenet frame, its equations and offsets, proved for all curves.

The formulas are written in γ alone: what holds for indeterminate coordinates x, y, z holds for those of γ = p/w, too.
"""

import pytest
from gmpy2 import mpq

from exactspline import claims, decide, example, formula_of, prove, reduction
from exactspline.errors import ClaimError, FormulaError
from exactspline.language import cross, det, norm2
from exactspline.language.adjoined_root import Adjoined, framed, root_of
from exactspline.language.kinds import CURVE, PLANE, PLANE_POINT, kind_of
from exactspline.readings.jet import RationalJetReading
from exactspline.readings.sympy_expression import SympyReading
from exactspline.verification.judges import Sympy
from tests.support.claims import stated
from tests.support.numeric_reading import numeric_curve
from tests.support.sampled import sample


@pytest.fixture(scope="module")
def plane():
    return framed(RationalJetReading(3).argument(CURVE, 2, polynomial=True)).remembering()


def one(c):
    return c.w.constant(1)


def vanishes(value):
    return all(x.is_zero for x in value) if hasattr(value, "__len__") else value.is_zero


def test_the_root_is_a_root_and_no_element_of_the_field_below():
    c = RationalJetReading(3).argument(CURVE, 2)
    square = norm2(c.gamma.d(1))
    sigma = root_of(square)
    assert sigma**2 == sigma.lifted(square)
    assert sigma != sigma.lifted(square)
    assert sigma != -sigma
    assert (sigma * sigma).d() == sigma.lifted(square.d())
    assert sigma.d(2) == sigma.d().d()


def test_every_element_but_zero_has_an_inverse():
    c = RationalJetReading(1).argument(CURVE, 2)
    sigma = root_of(norm2(c.p))
    element = sigma.lifted(c.w) + sigma * 3
    assert element * (1 / element) == sigma.constant(1)
    assert element.norm == c.w * c.w - 9 * norm2(c.p)
    with pytest.raises(FormulaError, match="division by an expression that vanishes"):
        1 / (element - element)
    with pytest.raises(FormulaError, match="root of zero"):
        root_of(c.w - c.w)


def test_elements_of_two_extensions_do_not_mix():
    c = RationalJetReading(1).argument(CURVE, 2)
    with pytest.raises(FormulaError, match="different extensions"):
        root_of(c.w) + root_of(c.p[0])


def test_the_square_of_the_signed_curvature_has_no_root(plane):
    n, kappa = formula_of("unit_normal_in_plane")(plane), formula_of("signed_curvature")(plane)
    assert norm2(n) == one(plane)
    assert kappa**2 == formula_of("curvature_squared")(plane)


def test_footnote_b_the_frenet_normal_with_positive_curvature_gives_the_same_evolute(plane):
    """T′/σ is the positive curvature times the Frenet normal whatever the sign; over its squared length it is N/κ."""
    bend = formula_of("unit_tangent")(plane).d() / plane.sigma
    assert vanishes(plane.gamma + bend / norm2(bend) - formula_of("evolute")(plane))


def test_offsets_are_parallel_and_their_evolute_is_that_of_the_curve():
    """γ + rN for an indeterminate r: (γ + rN)′ = (1 − rκ) γ′, curvature κ/|1 − rκ|, centre E."""
    c = framed(RationalJetReading(3).argument(PLANE_POINT, 2, polynomial=True)).remembering()
    r, n, kappa = c.point[0], formula_of("unit_normal_in_plane")(c), formula_of("signed_curvature")(c)
    offset = c.gamma + n * r
    shrink = 1 - r * kappa
    assert vanishes(offset.d() - c.gamma.d() * shrink)
    speed = c.sigma * shrink
    assert det(offset.d(), offset.d(2)) / speed**3 == kappa / shrink
    assert vanishes(offset + n * (shrink / kappa) - formula_of("evolute")(c))


def test_the_same_over_sympy():
    """The frame of a polynomial plane curve over an algebra that shares no code with the jets."""
    c = framed(SympyReading().argument(PLANE, 2, polynomial=True))
    t, n, kappa = (
        formula_of("unit_tangent")(c),
        formula_of("unit_normal_in_plane")(c),
        formula_of("signed_curvature")(c),
    )
    assert norm2(t) == one(c)
    assert vanishes(t.d() - n * (c.sigma * kappa))
    assert not vanishes(t.d() + n * (c.sigma * kappa))


def test_the_same_at_eighty_digits():
    """Over Taylor series: the element's value with a true root is the frame of the curve there."""
    base = numeric_curve(example("rational_space_cubic"), "2/7", 6, 80)
    c, ctx = framed(base), base.w.context
    s = ctx.sqrt(norm2(base.gamma.d()).value)
    r = ctx.sqrt(norm2(cross(base.gamma.d(), base.gamma.d(2))).value)

    def value(x):
        assert isinstance(x, Adjoined)
        return x.plain.plain.value + x.plain.rooted.value * s + (x.rooted.plain.value + x.rooted.rooted.value * s) * r

    n = [value(x) for x in formula_of("unit_normal")(c)]
    assert abs(sum(x * x for x in n) - 1) < ctx.mpf(10) ** -75
    kappa = value(formula_of("curvature_in_space")(c))
    assert kappa > 0
    assert abs(kappa - r / s**3) < ctx.mpf(10) ** -75


def test_a_frame_needs_a_curve_that_can_be_divided_by():
    one = RationalJetReading(1).argument(CURVE, 2).w.constant(mpq(1))
    still = CURVE.argument(2, lambda _: one, one, polynomial=True)
    with pytest.raises(FormulaError, match="root of zero"):
        framed(still)


FRAMES = [claim for claim in claims() if kind_of(claim.curve).adjoins_roots]
#: What is said of types, and of what an equation speaks, is decided in one algebra alone.
EQUATIONS = [claim for claim in FRAMES if claim.kind not in ("type", "applies")]


@pytest.mark.parametrize("claim", sample(EQUATIONS, 20), ids=lambda claim: claim.key)
def test_the_claims_over_roots_are_as_recorded_also_by_sympy(claim):
    """By two algebras; on single curves nothing is said: splines have no roots."""
    assert decide(claim).verdict == claim.expected
    assert Sympy().decide(claim).verdict == claim.expected
    assert not any(claim.applies_to(n, polynomial) for n in (2, 3) for polynomial in (False, True))


def test_frames_in_the_plane_and_in_space_are_in_the_ledger():
    ids = {claim.id for claim in FRAMES}
    assert {"E12", "E13", "E14", "E15", "E16", "C4.2a", "C5.4a", "C5.5a", "N11"} <= ids


def test_what_rational_curves_need_is_not_taken_from_polynomial_ones():
    """D1 = w² γ′ speaks of w: ‖D1‖ is not ‖γ′‖."""
    assert not prove("unit_tangent", "D1", "speed^-1", dimension=3)
    assert prove("unit_tangent", "D1", "speed^-1 w^-2", dimension=3)
    assert prove("unit_tangent", "velocity", "speed^-1", dimension=2)


def test_a_degree_of_what_has_roots_is_refused():
    told = {"curve": FRAMES[0].curve, "formula": "binormal", "measure": "true", "claimed": "3d"}
    with pytest.raises(ClaimError, match="not decided where roots are adjoined"):
        stated("degree", source=FRAMES[0].paper, **told)
    with pytest.raises(FormulaError, match="contains square roots"):
        reduction("unit_normal")
