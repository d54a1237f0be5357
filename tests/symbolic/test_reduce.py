"""`reduce` finds every reduction of the paper without being told, and those of formulas that the paper does not
have.
"""

import pytest
from gmpy2 import mpq

from exactspline import example
from exactspline.errors import FormulaError, ReachError, ShapeError
from exactspline.language import Vector, cross, det, dot, formula, norm2, perp, ruled
from exactspline.language.kinds import CURVE, SPACE
from exactspline.language.ruled import RuledSurface, split
from exactspline.papers import all_formulas, find, known_as
from exactspline.readings import JetReading
from exactspline.readings.differential_order import order_of
from exactspline.readings.factored_jet import FactoredJet, FactoredJetReading
from exactspline.readings.jet import Jet
from exactspline.splines.lowest_terms import in_lowest_terms
from exactspline.symbolic.assumptions import ASSUMPTIONS
from exactspline.symbolic.reduction import GENERATOR, reduce, reduction
from tests.support.sampled import sample

#: Formula, part, what is cancelled, what is left, its k, m, j, and the true degree; by hand from §4, §5 and §6 and the
#: theorem.
FOUND = {
    "f0": ("w⁻³", "f2", (3, 3, 0), "3d − 6"),
    "f1": ("w", "f2", (3, 3, 0), "3d − 6"),
    "g0": ("1/2·w⁻⁸", "[X X′ X″ X‴]", (8, 6, 0), "8d − 12"),
    "g2": ("1/2·w", "[X X′ X″ X‴]", (8, 6, 0), "8d − 12"),
    "curvature_squared": ("w⁶·(‖D1‖²)⁻³", "f2²", (6, 6, 0), "6d − 12"),
    "curvature_squared_derivative": ("w⁵·(‖D1‖²)⁻⁴", "[X X′ X″ X‴]·f2", (11, 9, 0), "11d − 18"),
    "evolute": ("1/2·w⁻³", "S[1…2]", (6, 3, 0), "6d − 6"),
    "velocity_acceleration_jerk": ("w⁻⁴", "[P P′ P″ P‴]", (4, 6, 0), "4d − 12"),
    "D1_D2_D3": ("w²", "[P P′ P″ P‴]", (4, 6, 0), "4d − 12"),
    "torsion": ("w²·(‖b‖²)⁻¹", "[P P′ P″ P‴]", (4, 6, 0), "4d − 12"),
    "torsion_reduced": ("w²·(‖b‖²)⁻¹", "[P P′ P″ P‴]", (4, 6, 0), "4d − 12"),
    "binormal": ("w⁻³", "b", (3, 3, 0), "3d − 6"),
    "tangent_developable": ("w⁻²", "D1", (2, 1, 0), "2d − 2"),
    "binormal_scroll": ("w⁻³", "b", (3, 3, 0), "3d − 6"),
    "normal_scroll": ("w⁻⁵", "b × D1", (5, 4, 0), "5d − 8"),
    "rectifying_developable": ("(‖D1‖²)⁻¹·(‖b‖²)⁻¹", "[P P′ P″ P‴] ‖D1‖² D1 + w ‖b‖² b", (10, 9, 0), "10d − 18"),
    "osculating_circle_centre": ("-1/2·w⁻³·(‖b‖²)⁻¹", "S[1…3]", (9, 6, 0), "9d − 12"),
    "focal_curve": ("1/2·w⁻⁴", "S[1…3]", (8, 6, 0), "8d − 12"),
    "focal_curve_by_arc_length": ("1/2·w⁻⁴", "S[1…3]", (8, 6, 0), "8d − 12"),
    "space_critical_curvature": ("1/2·w⁻¹¹", "Jκ", (11, 9, 0), "11d − 18"),
    "space_curvature_squared_derivative": ("w⁵·(‖D1‖²)⁻⁴", "Jκ", (11, 9, 0), "11d − 18"),
    "bisector": (None, None, (4, 1, 0), "4d − 2"),
    "plane_bisector": (None, None, (4, 1, 0), "4d − 2"),
    "point_bisector": (None, "Π[1…3]", (2, 1, 0), "2d − 2"),
}


@pytest.mark.parametrize("name", FOUND)
def test_the_reductions_of_the_paper_are_found(name):
    cancelled, left, grading, true = FOUND[name]
    part = reduction(name, 2 if find(name).curve in ("plane", "plane point") else 3).main
    assert cancelled in (None, str(part.cancelled))
    assert left in (None, part.text)
    assert (part.true.k, part.true.m, part.true.j) == grading
    assert str(part.generic) == true


def test_factors_with_roots_are_kept_apart_and_named():
    part = reduction("curvature_squared_derivative", 2).main
    assert {p.name for p in part.powers if p.has_roots} == {"f2", "[X X′ X″ X‴]"}
    assert {base.name for base, _ in part.rooted.powers} == {"f2", "[X X′ X″ X‴]"}
    assert not part.cancelled.names & {"f2", "[X X′ X″ X‴]"}
    assert all(p.assumption in ASSUMPTIONS.values() and p.meaning for p in part.powers if not p.has_roots)
    # of the naive numerator of degree 48d: the powers that are in it and in the denominator
    assert {p.name: (p.above, p.below) for p in part.powers} == {
        "w": (29, 24),
        "‖D1‖²": (2, 6),
        "f2": (1, 0),
        "[X X′ X″ X‴]": (1, 0),
    }


def test_poles_are_told():
    assert reduction("evolute", 2).main.poles.names == {"f2"}
    assert reduction("focal_curve", 3).main.poles.names == {"[P P′ P″ P‴]"}
    assert reduction("torsion", 3).main.poles.is_one


SMALL = [
    known_as(f)
    for f in all_formulas().values()
    if f.curve != "table" and not f.kind.adjoins_roots and order_of(f, 2 if "plane" in f.curve else 3) <= 2
]


@pytest.mark.parametrize("name", [*sample(SMALL, 45), "g0", "torsion"])
def test_the_identity_holds_in_plain_jets(name):
    """The naive numerator and denominator of the jet reading, multiplied out, against the product of what was found."""
    f = find(name)
    dimension = 2 if "plane" in f.curve else 3
    value = f(JetReading(order_of(f, dimension)).argument(f.kind, dimension))
    sides = [value.directrix, value.generator] if isinstance(value, RuledSurface) else [value]
    for side, part in zip(sides, reduction(name, dimension).parts, strict=True):
        numerators, denominator = split(side)
        top = part._product((p, p.above) for p in part.powers).scaled(part.constant)
        bottom = part._product((p, p.below) for p in part.powers)
        below = numerators[0].constant(1) if denominator is None else denominator
        for core, numerator in zip(part.core, numerators, strict=True):
            assert top * core * below == numerator * bottom


@pytest.mark.parametrize(
    "name", ["rational_cubic", "ellipse_skew", "six_segment_cubic", "rational_space_cubic", "twisted_cubic"]
)
def test_the_reduced_form_on_a_curve_is_the_naive_one_without_the_factor(name):
    curve = example(name)
    for formula_name in FOUND:
        if find(formula_name).curve != {2: "plane", 3: "space"}[curve.dimension] or isinstance(
            find(formula_name)(curve), RuledSurface
        ):
            continue
        part = reduction(formula_name, curve.dimension, curve.polynomial).main
        numerators, denominator = split(find(formula_name)(curve))
        value = part.on(curve)
        reduced = list(value) if isinstance(value, Vector) else [value]
        top, bottom = part.cancelled.on(curve)
        poles, _ = part.poles.on(curve)
        below = curve.w.constant(1) if denominator is None else denominator
        for naive, left in zip(numerators, reduced, strict=True):
            assert naive * bottom * poles == left * top * below
        assert max(left.degree for left in reduced) <= max(part.true.at(curve.degree), 0)


# ---- formulas that the paper does not have


def critical_torsion(c):
    """The derivative of the torsion."""
    return find("torsion")(c).d(1)


def pedal(c):
    """The pedal curve with respect to the origin: the feet of the perpendiculars onto the tangents."""
    normal = perp(c.gamma.d(1))
    return normal * dot(c.gamma, normal) / norm2(normal)


def offset_cusps(c):
    """Where an offset at distance r of either side has a cusp, ``κ² r² = 1``, for r = 1: the numerator of κ² − 1."""
    return find("curvature_squared")(c) - 1


@formula("curvature extrema of a space curve", on="space")
def space_vertices(c):
    """The numerator of the derivative of ``‖γ′ × γ″‖² / ‖γ′‖⁶``, from the definition."""
    a, b = c.gamma.d(1), cross(c.gamma.d(1), c.gamma.d(2))
    return (norm2(b) / norm2(a) ** 3).d(1)


def test_critical_torsion():
    part = reduce(critical_torsion, dimension=3).main
    assert str(part.cancelled) == "w·(‖b‖²)⁻²"
    assert (str(part.naive), str(part.generic)) == ("52d", "11d − 26")
    assert (part.true.k, part.true.m, part.true.j) == (11, 13, 0)
    # independently: τ′ = 0 as w (2w′W‖b‖² + wW′‖b‖² − wW(‖b‖²)′), the factor w apart
    curve = example("space_quartic")
    W, b2, w = find("torsion_zeros_lifted")(curve), norm2(find("binormal_lifted")(curve)), curve.w
    by_hand = 2 * w.d() * W * b2 + w * W.d() * b2 - w * W * b2.d()
    assert proportional(part_on(critical_torsion, curve), by_hand)


def part_on(function, curve):
    return reduce(function, dimension=curve.dimension, polynomial=curve.polynomial).main.on(curve)


def proportional(f, g):
    t = next(t for j in range(1, 50) if f(t := mpq(j, 53) * f.domain[1] + (1 - mpq(j, 53)) * f.domain[0]))
    return f * g(t) == g * f(t)


def test_the_pedal_curve():
    part = reduce(pedal, dimension=2).main
    assert (part.true.k, part.true.m, part.true.j) == (4, 2, 0)
    assert str(part.generic_lowest) == "4d − 4"
    curve = example("rational_cubic")
    naive = in_lowest_terms(pedal(curve))
    assert naive.degree == 4 * 3 - 4
    for t in (mpq(1, 3), mpq(4, 7)):
        (x, y), (dx, dy) = naive(t), (c(t) for c in find("D1")(curve))
        px, py = curve(t)
        assert x * dx + y * dy == 0
        assert (x - px) * dy == (y - py) * dx


def test_the_cusps_of_an_offset():
    part = reduce(offset_cusps, dimension=2).main
    assert (
        str(part.cancelled) == "-1·(‖D1‖²)⁻³"
    )  # what is left has a positive leading coefficient: it is ‖D1‖⁶ − w⁶ f2²
    # homogeneous of degree 12 and weight 6, a covariant
    assert (part.true.k, part.true.m, part.true.j) == (12, 6, 0)
    assert str(part.generic) == "12d − 12"
    # on a polynomial curve the two terms differ in degree: f2² has (4, 6), ‖p′‖⁶ has (6, 6)
    part = reduce(offset_cusps, dimension=2, polynomial=True).main
    assert part.true is None
    assert str(part.generic) == "6d − 6"
    circle = reduce(offset_cusps, dimension=2).main.on(example("circle"))
    assert circle.is_zero  # the offset inwards of the unit circle is a point


def test_the_curvature_extrema_of_a_space_curve():
    part = reduce(space_vertices).main
    assert part.text == "Jκ"
    assert str(part.generic) == "11d − 18"


def test_a_value_that_vanishes():
    part = reduction("D1_D2_D21", 3).main
    assert part.is_zero
    assert (part.text, str(part.generic), part.true) == ("0", "−1", None)


def test_a_vector_of_quotients_and_mixed_gradings():
    part = reduce(lambda c: Vector(c.gamma[0], c.gamma[1] / c.w, c.gamma[0] + 1), dimension=2).main
    numerator, denominator = part.lowest
    assert denominator == denominator.ring["w"] ** 2
    assert numerator[2] == (denominator.ring["x"] + denominator.ring["w"]) * denominator.ring["w"]


def test_bad_formulas_are_refused():
    with pytest.raises(FormulaError, match="returns int"):
        reduce(lambda c: 5, dimension=2)
    with pytest.raises(FormulaError, match="vanishes on every curve"):
        reduce(lambda c: c.w / (c.w - c.w), dimension=2)
    with pytest.raises(FormulaError, match="Table 1"):
        reduce(find("T1"))
    with pytest.raises(ShapeError):
        reduce(lambda c: det(c.p, c.p.d(1)), dimension=3)


def test_a_plain_function_finds_its_dimension():
    assert reduce(lambda c: det(c.p, c.p.d(1))).dimension == 2
    assert reduce(lambda c: cross(c.p, c.p.d(1))).dimension == 3


def test_the_factored_reading_is_the_jet_reading():
    """Sums, products, derivatives and equality of products against polynomials multiplied out."""
    c, plain = FactoredJetReading(3).argument(CURVE, 2), JetReading(3).argument(CURVE, 2)

    def expression(c):
        a = c.p[0] * c.w * c.w + c.p[1] * c.w
        return (a * a).d(2) * 3 - a * c.w.d(1) * 2 - (a - a) * c.w + 5

    assert expression(c).expanded() == expression(plain).polynomial
    assert isinstance(expression(plain), Jet)
    a = c.p[0] * c.w + c.w
    assert a * c.w == FactoredJet.of(Jet(plain.w.ring, (a * c.w).expanded()))
    assert (a - a).is_zero
    assert a != c.w


def test_generators_lose_any_factor():
    """A generator times f2 is the same ruling: the factor is told, and dropped."""

    def surface(c):
        from exactspline.language import ruled

        return ruled(c.gamma, c.gamma.d(1) * norm2(c.p))

    part = reduce(surface, dimension=3).main
    assert part.role == GENERATOR
    assert part.text == "D1"
    assert "may have zeros" in next(p.meaning for p in part.powers if p.name.startswith("("))


@pytest.mark.parametrize(
    ("formula_of", "error", "words"),
    [
        (lambda c: c.w ** (10**9), FormulaError, "a power with exponent 1000000000"),
        (lambda c: c.w.d(20_000), FormulaError, "derivatives of order 20000"),
        (lambda c: sum(c.p, c.w) ** 60 + sum(c.p.d(1), c.w.d()) ** 60, ReachError, "the factorization"),
    ],
)
def test_what_is_out_of_reach_is_named_beforehand(formula_of, error, words):
    """Before: a loop of a billion products; the process ended by FLINT for lack of memory; minutes in one call."""
    with pytest.raises(error, match=words):
        reduce(formula_of, dimension=2)


def test_reduced_forms_keep_what_the_numerator_has_more():
    """f2³ w / (f2 w³): kept is f2², a pole nothing, cancelled w⁻²."""
    f2 = find("f2")
    part = reduce(lambda c: f2(c) ** 3 * c.w / (f2(c) * c.w**3), dimension=2).main
    c = JetReading(2).argument(CURVE, 2)
    own = f2(c)
    assert part.reduced == (own * own,)
    assert str(part.rooted) == "f2²"
    assert part.poles.is_one
    top, bottom = part.lowest
    assert top[0] * c.w * c.w == own * own * bottom
    upside = reduce(lambda c: c.w / f2(c) ** 2, dimension=2).main
    assert str(upside.poles) == "f2²"
    assert upside.rooted.is_one
    assert str(upside.generic_lowest) == "max(6d − 12, d)"
    assert upside.data()["k"] == 0
    assert str(part.generic) == "6d − 12"
    assert str(part.generic_lowest) == "max(6d − 12, 2d)"


def test_what_vanishes_has_no_degree_over_whatever_stands():
    nothing = reduce(lambda c: (c.p[0] - c.p[0]) / find("f2")(c), dimension=2).main
    assert nothing.is_zero
    assert str(nothing.generic) == str(nothing.generic_lowest) == "−1"
    assert nothing.text == "0"
    assert nothing.true is None
    data = nothing.data()
    assert (data["k"], data["m"], data["j"], data["nominal"], data["lower"]) == (None, None, None, "", {})
    some = reduction("f0", 2).main.data()
    assert (some["k"], some["m"], some["j"], some["nominal"]) == (3, 3, 0, "3d − 3")
    assert some["true"] == "3d − 6"


def test_factored_jets_are_equal_when_their_products_are():
    c = FactoredJetReading(1).argument(CURVE, 2)
    x, y, w = *c.p, c.w
    assert x * (y + w) == x * y + x * w
    assert x != x * y
    assert x * y != x
    assert x * y != x * w
    assert 2 * x * y != x * y
    assert x * (y + w) != x * (y - w)
    assert x - x == w - w
    assert x - x != x


@pytest.mark.parametrize("name", ["tangent_developable", "normal_scroll", "plane_bisector", "evolute", "focal_curve"])
def test_what_is_joined_is_every_part_over_one_denominator(name):
    dimension = 2 if name in ("plane_bisector", "evolute") else 3
    found = reduction(name, dimension)
    *components, denominator = [jet.polynomial for jet in found.joined]
    for part in found.parts:
        top, bottom = part.lowest
        own, components = components[: len(top)], components[len(top) :]
        assert [x * bottom.polynomial for x in own] == [x.polynomial * denominator for x in top]
        assert denominator % bottom.polynomial == 0
    assert not components


def test_parts_with_unequal_denominators_are_joined_over_their_least_multiple():
    found = reduce(lambda c: ruled(c.p / c.w, Vector(*[x / (c.w * c.p[0]) for x in c.p.d(1)])), dimension=3)
    c = JetReading(1).argument(SPACE, 3)
    *components, denominator = found.joined
    bottoms = [part.lowest[1] for part in found.parts]
    assert any(bottom != denominator for bottom in bottoms)
    assert c.w.polynomial.total_degree() == 1
    for part in found.parts:
        top, bottom = part.lowest
        own, components = components[: len(top)], components[len(top) :]
        assert all(x * bottom == y * denominator for x, y in zip(own, top, strict=True))
