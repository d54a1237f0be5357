"""The parts of reductions, factors and motions, each held against what it means, with known answers."""

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from exactspline import BSpline
from exactspline.interchange.examples import example
from exactspline.language.choices import Parameter
from exactspline.language.kinds import CURVE, PAIR, SPACE
from exactspline.language.ruled import ruled
from exactspline.language.vector import Vector, det, norm2
from exactspline.papers import find
from exactspline.readings.differential_order import order_of
from exactspline.readings.factored_jet import FactoredJetReading
from exactspline.readings.jet import JetReading
from exactspline.symbolic import covariants, factorization
from exactspline.symbolic.assumptions import ASSUMPTIONS, assumption, zero_free
from exactspline.symbolic.covariants import TrueDegree, product_of
from exactspline.symbolic.factorization import (
    Factor,
    factors_of,
    find_factor,
    irreducible_on_a_line,
    jets_for,
    name_of_vector,
)
from exactspline.symbolic.motions import MAPS
from exactspline.symbolic.motions import rotation_rows as rotation
from exactspline.symbolic.reduction import reduce, reduction
from exactspline.symbolic.substitution import substitute
from exactspline.verification.kinds.invariance import image_of_point as image_of

T = BSpline.identity(0, 1)
fractions = st.fractions(min_value=-5, max_value=5, max_denominator=9)


@pytest.mark.parametrize("name", ["f2", "vertices_lifted", "D1_squared", "g2"])
def test_a_jet_on_a_curve_is_the_formula_there(name):
    curve = example("rational_cubic")
    f = find(name)
    jet = f(JetReading(order_of(f, 2)).argument(CURVE, 2))
    assert substitute(jet, curve) == f(curve)


def test_a_jet_with_constants_on_a_curve():
    curve, c = example("rational_cubic"), JetReading(1).argument(CURVE, 2)
    x, y, w = *c.p, c.w
    p, q, v = *curve.p, curve.w
    for jet, expected in (
        (x * x * x + 2 * x + 1, p * p * p + 2 * p + 1),
        (x * x + y * w - 3, p * p + q * v - 3),
        (5 - x * x * w + x * y, 5 - p * p * v + p * q),
        (x * y * y + x * x * y + y, p * q * q + p * p * q + q),
        (w.constant(4), v.constant(4)),
        (x - x, v.constant(0)),
        (x.d(1) * y + 2, p.d(1) * q + 2),
    ):
        assert substitute(jet, curve) == expected


def test_assumptions_speak_of_the_curve_that_they_name():
    pair = JetReading(1).argument(PAIR, 3)
    assert assumption("w").polynomial(pair) == pair.first.w
    assert assumption("w̄").polynomial(pair) == pair.second.w
    assert assumption("γ′").polynomial(pair) == find("D1_squared")(pair.first)
    assert assumption("γ̄′").polynomial(pair) == find("D1_squared")(pair.second)
    name = "[γ′ γ̄′ γ−γ̄] ≢ 0"
    assert assumption(name).polynomial(pair) == find("bisector_determinant_symmetric")(pair)
    space = JetReading(2).argument(SPACE, 3)
    bend = find("binormal_form")(space)
    assert assumption("γ′×γ″").polynomial(space) == sum((x * x for x in bend), space.w.constant(0))
    assert {each.everywhere for name, each in ASSUMPTIONS.items() if "≢" in name} == {False}


def test_what_has_no_zero_is_what_divides_a_polynomial_without_one():
    plane = JetReading(1).argument(CURVE, 2)
    assert zero_free(find("D1_squared")(plane)).name == "γ′"
    assert zero_free(plane.w).name == "w"
    assert zero_free(plane.p[0]) is None
    assert zero_free(plane.w, [assumption("γ′")]) is None
    assert zero_free(plane.w, [assumption("γ′ ≢ 0")]) is None
    space = JetReading(2).argument(SPACE, 3)
    assert zero_free(assumption("γ′×γ″").polynomial(space)).name == "γ′×γ″"
    assert zero_free(find("D1_squared")(JetReading(1).argument(SPACE, 3))).name == "γ′"
    polynomial = JetReading(1).argument(CURVE, 2, polynomial=True)
    assert zero_free(find("D1_squared")(polynomial)).name == "γ′"
    assert zero_free(polynomial.w).name == "γ′"


def test_vectors_are_named_by_what_they_are_multiples_of():
    c = JetReading(2).argument(SPACE, 3)
    first = list(find("D1")(c))
    assert name_of_vector(first) == ("D1", 1)
    assert name_of_vector([-3 * x for x in first]) == ("D1", -3)
    assert name_of_vector([x * 0 for x in first]) == ("0", 1)
    assert name_of_vector([first[0], first[1], first[0]])[0].startswith("(")
    x, w = c.p[0], c.w
    name, unit = name_of_vector([(-4 * x * w.d(1)), 6 * w * w])
    assert unit == -2
    assert name == "(2·x·w′, −3·w²)"
    name, unit = name_of_vector([x * mpq(2, 3), w * w * mpq(4, 9)])
    assert (name, unit) == ("(3·x, 2·w²)", mpq(2, 9))
    assert name_of_vector([first[2], x * w])[0].startswith("(")
    assert name_of_vector([x * 0, first[1], first[2] * 2])[0].startswith("(")


def test_factors_are_quotients():
    c = jets_for(("f1", "f2"), 2)
    f1, f2 = find("f1")(c), find("f2")(c)
    assert str(find_factor(f1, f2)) == "w"
    assert str(find_factor(f2, f1)) == "w⁻¹"
    zero = find_factor(f1 * 0, f2)
    assert zero.is_zero
    assert not zero.is_one
    assert find_factor(-f2, f2).constant == -1
    assert not find_factor(-f2, f2).is_zero
    assert not find_factor(-f2, f2).is_one
    assert find_factor(f2, f2).is_one
    assert str(find_factor(f2 * mpq(3, 2), f2)) == "3/2"
    assert find_factor(Vector(f1, f2), Vector(f2, f1)) is None
    assert str(find_factor(Vector(f1, f1), Vector(f2, f2))) == "w"
    assert isinstance(zero, Factor)


def test_the_degree_of_a_product_is_the_sum_and_lower_where_a_factor_is():
    """1·d at every d but 2, where it is 1; 0 at d = 1."""
    a = TrueDegree(1, 0, 0, ((1, -1), (2, 1)))
    b = TrueDegree(3, 3, 1, ())
    told = product_of([(a, 1), (b, 2)])
    assert (told.k, told.m, told.j) == (7, 6, 2)
    assert told.lower == ((1, -1), (2, 1 + 2 * b.at(2)))
    assert [told.at(d) for d in (1, 2, 3)] == [-1, 1 + 2 * b.at(2), 3 + 2 * b.at(3)]
    assert b.at(5) == 3 * 5 - 6 + 1
    plain = product_of([(b, 1)])
    assert plain == b
    same = TrueDegree(1, 0, 0, ((4, 4),))
    assert product_of([(same, 1)]).lower == ()
    assert product_of([(TrueDegree(1, 1, 0, ((4, 2),)), 1)]).lower == ()


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


@given(st.tuples(fractions, fractions, fractions))
def test_a_rotation_keeps_lengths_and_orientation_and_its_axis(quaternion):
    """R Rᵀ = 1, det R = 1; the axis (a, b, c) stays; about the third axis it is the rotation of the plane."""
    a, b, c = map(mpq, quaternion)
    rows = rotation(3, {"turn1": a, "turn2": b, "turn3": c})
    assert [[sum(x * y for x, y in zip(p, q, strict=True)) for q in rows] for p in rows] == [
        [int(i == j) for j in range(3)] for i in range(3)
    ]
    assert det(*[Vector(*row) for row in rows]) == 1
    assert [row[0] * a + row[1] * b + row[2] * c for row in rows] == [a, b, c]
    flat, about = rotation(2, {"turn1": c}), rotation(3, {"turn1": 0, "turn2": 0, "turn3": c})
    assert [row[:2] for row in about[:2]] == flat
    cosine, sine = (1 - c * c) / (1 + c * c), 2 * c / (1 + c * c)
    assert flat == [[cosine, -sine], [sine, cosine]]


@pytest.mark.parametrize("name", ["f2", "g2", "D1_squared", "vertices_lifted", "D1_D2_D3"])
def test_what_lowers_degrees_is_the_same_for_symbols_and_numbers(name):
    """L = Σ i (d − i + 1) f⁽ⁱ⁻¹⁾ ∂/∂f⁽ⁱ⁾."""
    n = 3 if name == "D1_D2_D3" else 2
    jet = find(name)(JetReading(order_of(find(name), n)).argument(CURVE, n))
    symbolic = covariants.lowered(jet.ring, covariants.with_degree(jet.ring, jet.polynomial), Parameter.FIRST)
    again = covariants.lowered(jet.ring, symbolic, Parameter.FIRST)
    gens = [jet.ring.context.gen(i) for i in range(len(jet.ring.gens))]
    for d in range(1, 9):
        at = lambda p, d=d: p.compose(jet.ring.context.constant(d), *gens, ctx=jet.ring.context)  # noqa: E731
        once = covariants.lowered_at(jet.ring, jet.polynomial, d)
        assert at(symbolic) == once
        assert at(again) == covariants.lowered_at(jet.ring, once, d)


def test_what_lowers_degrees_kills_covariants_and_lowers_one_derivative_at_a_time():
    c = JetReading(2).argument(CURVE, 2)
    x, y = c.p
    d = 7
    assert covariants.lowered_at(x.ring, (x * y.d(1) - x.d(1) * y).polynomial, d) == 0
    assert covariants.lowered_at(x.ring, (d * x * x.d(2) - (d - 1) * x.d(1) * x.d(1)).polynomial, d) == 0
    assert covariants.lowered_at(x.ring, x.d(2).polynomial, d) == (2 * (d - 1) * x.d(1)).polynomial
    assert covariants.lowered_at(x.ring, x.d(1).polynomial, d) == (d * x).polynomial


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


# ---- motions


def constants_of(made, n):
    return {name: mpq(3 * i + 2, 2 * i + 5) * (-1) ** i for i, name in enumerate(made.constants(n))}


def points_of(n):
    return [Vector(*[mpq((3 * i + 5 * j * j + i * j) % 11 - 4, j + 2) for j in range(n)]) for i in range(n + 2)]


def moved(made, p, n):
    image, w = made.image(p, mpq(1), constants_of(made, n))
    return Vector(*[x / w for x in image])


def volume(points):
    return det(*[p - points[0] for p in points[1:]])


@pytest.mark.parametrize("n", [2, 3])
@pytest.mark.parametrize("name", ["translation", "rotation", "motion", "reflection", "scaling", "similarity"])
def test_similarities_multiply_all_lengths_and_volumes(name, n):
    made, points = MAPS[name], points_of(n)
    images = [moved(made, p, n) for p in points]
    scale = constants_of(made, n).get("scale", 1)
    for i, p in enumerate(points):
        for j in range(i):
            assert norm2(images[i] - images[j]) == scale**2 * norm2(p - points[j])
    turn = -1 if name == "reflection" else 1
    assert volume(images[: n + 1]) == turn * scale**n * volume(points[: n + 1])
    assert any(image != p for image, p in zip(images, points, strict=True))


@pytest.mark.parametrize("n", [2, 3])
def test_affine_maps_multiply_all_volumes_by_their_determinant(n):
    made, points = MAPS["affine map"], points_of(n)
    images = [moved(made, p, n) for p in points]
    unit = made.unit(points[0], mpq(1), constants_of(made, n))
    for some, others in ((points[:-1], images[:-1]), (points[1:], images[1:])):
        assert volume(others) == unit * volume(some)
    k, one = constants_of(made, n), T.constant(1)
    vectors = [made.of_vector(p.mapped(T.constant), one, k).mapped(lambda f: f(0)) for p in points]
    for p, image, v in zip(points, images, vectors, strict=True):
        assert image - images[0] == v - vectors[0]
        assert p == points[0] or v != vectors[0]


@pytest.mark.parametrize("n", [2, 3])
def test_projective_maps_multiply_determinants_of_homogeneous_coordinates(n):
    made, points = MAPS["projective map"], points_of(n)[: n + 1]
    k = constants_of(made, n)
    images = [made.image(p, mpq(i + 1), k) for i, p in enumerate(points)]
    before = det(*[Vector(*p, mpq(i + 1)) for i, p in enumerate(points)])
    assert det(*[Vector(*p, w) for p, w in images]) == made.unit(points[0], mpq(1), k) * before


@pytest.mark.parametrize("n", [2, 3])
def test_the_inversion_divides_distances_by_those_from_the_origin(n):
    made, points = MAPS["inversion"], [p for p in points_of(n) if norm2(p)]
    images = [moved(made, p, n) for p in points]
    for i, p in enumerate(points):
        assert norm2(images[i]) * norm2(p) == 1
        assert made.unit(p, mpq(1), {}) * norm2(p) == 1
        for j in range(i):
            assert norm2(images[i] - images[j]) * norm2(p) * norm2(points[j]) == norm2(p - points[j])
    if n == 2:
        z = points[0]
        u = images[0]
        assert Vector(z[0] * u[0] - z[1] * u[1], z[0] * u[1] + z[1] * u[0]) == Vector(1, 0)


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


def test_a_jet_with_fractions_for_coefficients_on_a_curve():
    curve, c = example("rational_cubic"), JetReading(1).argument(CURVE, 2)
    x, y, w = *c.p, c.w
    p, q, v = *curve.p, curve.w
    for jet, expected in (
        (x * y * mpq(2, 3) - w * w * mpq(5, 4), p * q * mpq(2, 3) - v * v * mpq(5, 4)),
        (x * mpq(1, 7), p * mpq(1, 7)),
        (w.constant(mpq(3, 5)), v.constant(mpq(3, 5))),
        (x.d(1) * mpq(1, 6) + mpq(1, 4), p.d(1) * mpq(1, 6) + mpq(1, 4)),
        (x * 6 + y * 4, p * 6 + q * 4),
    ):
        assert substitute(jet, curve) == expected


def test_points_are_moved_by_their_coordinates():
    p = Vector(mpq(3), mpq(4))
    assert image_of(p, MAPS["inversion"], {}, mpq(1)) == [mpq(3, 25), mpq(-4, 25)]
    k = {"move1": mpq(1), "move2": mpq(-2)}
    assert image_of(p, MAPS["translation"], k, mpq(1)) == [4, 2]
    matrix = {f"m{i}{j}": mpq(3 * i + j * j) for i in (1, 2, 3) for j in (1, 2, 3)}
    top, below = MAPS["projective map"].image(p, mpq(1), matrix)
    assert image_of(p, MAPS["projective map"], matrix, mpq(1)) == [x / below for x in top]
    assert below not in (0, 1)


def test_values_on_a_line_show_what_has_no_factors_and_never_what_has():
    c = JetReading(2).argument(SPACE, 3)
    form = norm2(c.p.d(1)) * c.w + det(c.p, c.p.d(1), c.p.d(2))
    plain, product = form.polynomial, (form * c.w).polynomial
    assert irreducible_on_a_line(plain)
    assert not irreducible_on_a_line(product)
    assert not irreducible_on_a_line((form * form).polynomial)


def test_long_polynomials_are_factored_as_short_ones_are(monkeypatch):
    c = JetReading(2).argument(SPACE, 3)
    p = det(c.p, c.p.d(1), c.p.d(2)).polynomial
    for q in (p * -3 / 7, p * c.w.polynomial * 2, p * p):
        monkeypatch.setattr(factorization, "LONG", 10**9)
        expected = factors_of(q)
        monkeypatch.setattr(factorization, "LONG", 1)
        assert factors_of(q) == expected
