"""Claims of contact, of invariance and of signs: what is true is proved, what is false is refuted or left undecided."""

import pytest

from exactspline import Verdict, example, formula_of, paper
from exactspline.errors import ClaimError
from exactspline.language import det, dot, formula, norm2
from tests.support.claims import one_verdict, stated

PLANE, SPACE = ("rational_cubic", "six_segment_cubic"), ("rational_space_cubic", "twisted_cubic")


@formula("a test", on="plane pair")
def osculating_circle(c):
    """|γ(s̄) − C|² − R² for the centre C and the radius R of curvature at s, without denominators."""
    first, second = c.first.gamma, c.second.gamma
    way, speed = second - first, norm2(first.d(1))
    return norm2(way) * det(first.d(1), first.d(2)) - 2 * speed * det(first.d(1), way)


@formula("a test", on="plane pair")
def tangent(c):
    """[γ′ γ(s̄) − γ]."""
    return det(c.first.gamma.d(1), c.second.gamma - c.first.gamma)


@formula("a test", on="pair")
def osculating_plane(c):
    """[γ′ γ″ γ(s̄) − γ]."""
    first = c.first.gamma
    return det(first.d(1), first.d(2), c.second.gamma - first)


@formula("a test", on="plane pair")
def circle_through(c):
    """A circle about the origin: it touches no general curve."""
    return norm2(c.second.gamma) - norm2(c.first.gamma)


@formula("a test", on="plane pair")
def nothing(c):
    """0."""
    return det(c.first.p, c.first.p)


OWN = {f.name: f for f in (osculating_circle, tangent, osculating_plane, circle_through, nothing)}


@pytest.fixture(autouse=True)
def own_formulas(monkeypatch):
    source = type(paper("lifted"))
    known = source.find
    monkeypatch.setattr(source, "find", lambda self, name: OWN[name] if name in OWN else known(self, name))


def contact(name, order, **more):
    return stated("contact", **{"curve": "plane pair", "formula": name, "order": order, **more})


def invariance(name, under, weight=0, **more):
    return stated("invariance", **{"curve": "plane", "formula": name, "under": under, "weight": weight, **more})


def sign(name, told, squares=(), **more):
    return stated("sign", **{"curve": "plane", "formula": name, "sign": told, "squares": squares, **more})


def assert_verdict(claim, verdict):
    assert one_verdict(claim).verdict == verdict
    for name in PLANE if 2 in claim.dimensions else SPACE:
        curve = example(name)
        if claim.applies_to(curve.dimension, curve.polynomial):
            found = claim.check(curve).verdict
            assert found == Verdict.VERIFIED if verdict == Verdict.PROVED else found != Verdict.VERIFIED


CONTACTS = {"osculating_circle": 2, "tangent": 1, "circle_through": 0}


@pytest.mark.parametrize(("name", "order"), CONTACTS.items())
def test_contact_is_exactly_what_it_is(name, order):
    assert_verdict(contact(name, order), Verdict.PROVED)
    assert one_verdict(contact(name, order, relation="≥")).verdict == Verdict.PROVED
    assert_verdict(contact(name, order + 1), Verdict.REFUTED)
    assert str(contact(name, order + 1).prove()[1].computed) == str(order)
    if order:
        assert one_verdict(contact(name, order - 1)).verdict == Verdict.REFUTED
        assert one_verdict(contact(name, order - 1, relation="≥")).verdict == Verdict.PROVED


def test_contact_in_space_and_what_does_not_exist():
    assert_verdict(contact("osculating_plane", 2, curve="pair"), Verdict.PROVED)
    assert_verdict(contact("osculating_plane", 3, curve="pair"), Verdict.REFUTED)
    assert one_verdict(contact("nothing", 1)).verdict == Verdict.VACUOUS
    with pytest.raises(ClaimError, match="two points"):
        contact("f2", 1, curve="plane")
    with pytest.raises(ClaimError, match="higher contact"):
        contact("tangent", 1, relation="≤")


INVARIANT = [
    ("f2", "reparametrization", 3),
    ("f2", "common factor", 3),
    ("f2", "projective map", 1),
    ("f2", "affine map", 1),
    ("f2", "similarity", 2),
    ("f2", "scaling", 2),
    ("f2", "reflection", 1),
    ("f2", "motion", 0),
    ("curvature_squared", "reparametrization", 0),
    ("curvature_squared", "common factor", 0),
    ("curvature_squared", "similarity", -2),
    ("curvature_squared", "rotation", 0),
    ("curvature_squared", "translation", 0),
]


@pytest.mark.parametrize(("name", "under", "weight"), INVARIANT)
def test_the_weight_is_the_one_there_is(name, under, weight):
    assert_verdict(invariance(name, under, weight), Verdict.PROVED)
    units = under not in ("motion", "rotation", "translation")
    for wrong in (weight + 1, weight - 1) if units else ():
        assert_verdict(invariance(name, under, wrong), Verdict.REFUTED)


@pytest.mark.parametrize(
    "claim",
    [
        ("curvature_squared", "affine map", 1),
        ("curvature_squared", "projective map", 0),
        ("D1_squared", "Möbius map", 2),
        ("D1_squared", "common factor", 2),
        ("p_squared", "translation", 0),
        ("across", "reflection", 0),
    ],
)
def test_what_changes_is_not_invariant(claim, monkeypatch):
    for f in (p_squared, across):
        monkeypatch.setitem(OWN, f.__name__, formula("a test", on="plane")(f))
    assert_verdict(invariance(*claim), Verdict.REFUTED)


def across(c):
    """x′², which a reflection in the y-axis does not change, and one in another line does."""
    return c.gamma.d(1)[0] ** 2


def p_squared(c):
    return norm2(c.p)


def square_of_speed(c):
    return norm2(c.gamma.d(1))


def vertices(c):
    """κ′ ‖γ′‖⁵, whose zeros Möbius maps keep."""
    v, a, b = c.gamma.d(1), c.gamma.d(2), c.gamma.d(3)
    return norm2(v) * det(v, b) - 3 * dot(v, a) * det(v, a)


def test_moebius_maps_keep_vertices(monkeypatch):
    """κ_s ds² is invariant, so κ_s ‖γ′‖⁶ = (κ′ ‖γ′‖⁵) has the weight 4."""
    for f in (vertices, square_of_speed):
        monkeypatch.setitem(OWN, f.__name__, formula("a test", on="plane")(f))
    assert_verdict(invariance("square_of_speed", "Möbius map", 2), Verdict.PROVED)
    assert_verdict(invariance("vertices", "Möbius map", 4), Verdict.PROVED)
    assert_verdict(invariance("vertices", "Möbius map", 3), Verdict.REFUTED)
    assert_verdict(invariance("f2", "Möbius map", 3), Verdict.REFUTED)


def test_what_moves_along_is_told():
    assert_verdict(invariance("evolute", "similarity", nature="point"), Verdict.PROVED)
    assert_verdict(invariance("evolute", "similarity", nature="vector"), Verdict.REFUTED)
    assert_verdict(invariance("evolute", "similarity"), Verdict.REFUTED)
    assert_verdict(invariance("evolute", "affine map", nature="point"), Verdict.REFUTED)


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"under": "motion", "weight": 1}, "has no unit"),
        ({"under": "reparametrization", "nature": "point"}, "moves nothing"),
        ({"under": "Möbius map", "nature": "vector"}, "not linear"),
        ({"under": "similarity", "curve": "plane with delta"}, "constants"),
        ({"under": "similarity", "curve": "hodograph"}, "not decided"),
        ({"under": "shear"}, "unknown"),
        ({"under": "scaling", "weight": True}, "not an integer"),
    ],
)
def test_invariance_that_says_nothing_is_refused(changes, told):
    with pytest.raises(ClaimError, match=told):
        stated("invariance", **({"curve": "plane", "formula": "f2"} | changes))


@pytest.mark.parametrize("words", ["an affine map", "a scaling", "a reversal"])
def test_a_change_is_named_with_its_article(words):
    assert rf"under {words}:" in invariance("f2", words.split(" ", 1)[1]).latex


def test_signs():
    assert_verdict(sign("D1_squared", "≥ 0", ("D1",)), Verdict.PROVED)
    assert_verdict(sign("D1_squared", "≤ 0", ("D1",)), Verdict.REFUTED)
    assert one_verdict(sign("D1_squared", "> 0", ("D1",))).verdict == Verdict.REFUTED
    assert one_verdict(sign("D1_squared", "> 0", ("D1",), assumes=("γ′",))).verdict == Verdict.PROVED
    assert one_verdict(sign("D1_squared", "≥ 0")).verdict == Verdict.UNDECIDED
    assert one_verdict(sign("D1_squared", "≥ 0", ("f2",))).verdict == Verdict.UNDECIDED
    assert one_verdict(sign("f2", "≥ 0", ("D1",))).verdict == Verdict.REFUTED
    assert sign("D1_squared", "≥ 0").check(example("cusp")).verdict == Verdict.VERIFIED
    assert sign("D1_squared", "> 0").check(example("cusp")).verdict == Verdict.REFUTED
    for wrong in ("-1", "w^3", "f2", "-2 w^2"):
        with pytest.raises(ClaimError, match="has no sign"):
            sign("D1_squared", "≥ 0", ("D1",), factor=wrong)


def test_a_square_that_is_zero_makes_nothing_positive(monkeypatch):
    monkeypatch.setitem(OWN, "zero", formula("a test", on="plane")(lambda c: c.w - c.w))
    assert one_verdict(sign("D1_squared", "≥ 0", ("D1", "zero"))).verdict == Verdict.PROVED
    assert one_verdict(sign("D1_squared", "> 0", ("D1", "zero"))).verdict == Verdict.REFUTED
    assert one_verdict(sign("D1_squared", "> 0", ("zero", "D1"), assumes=("w",))).verdict == Verdict.REFUTED


def test_a_square_with_a_positive_factor_only(monkeypatch):
    def product(c):
        return 3 * c.w**2 * norm2(formula_of("D1")(c))

    monkeypatch.setitem(OWN, "product", formula("a test", on="plane")(product))
    assert_verdict(sign("product", "≥ 0", ("D1",), factor="3 w^2"), Verdict.PROVED)
    assert one_verdict(sign("product", "≥ 0", ("D1",), factor="2 w^2")).verdict == Verdict.UNDECIDED
    assert one_verdict(sign("product", "≤ 0", ("D1",), factor="3 w^2")).verdict == Verdict.REFUTED
