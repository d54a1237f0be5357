"""Claims of contact, of invariance and of signs: what is true is proved, what is false is refuted or left undecided."""

import pytest

from exactspline import example, paper
from exactspline.display.evidence import worded
from exactspline.errors import ClaimError
from exactspline.language import det, dot, formula, norm2
from exactspline.papers import find
from exactspline.verification.combined import combined
from exactspline.verification.kinds.contact import Contact
from exactspline.verification.kinds.invariance import Invariance
from exactspline.verification.kinds.zeros import SignClaim
from exactspline.verification.verdict import PROVED, REFUTED, UNDECIDED, VACUOUS, VERIFIED

BASE = {"paper": "lifted", "id": "X1", "key": "X1-a", "source": "a test", "statement": "a test", "status": "ours"}
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
    return Contact(**BASE, **{"curve": "plane pair", "formula": name, "order": order, **more})


def invariance(name, under, weight=0, **more):
    return Invariance(**BASE, **{"curve": "plane", "formula": name, "under": under, "weight": weight, **more})


def sign(name, told, squares=(), **more):
    return SignClaim(**BASE, **{"curve": "plane", "formula": name, "sign": told, "squares": squares, **more})


def assert_verdict(claim, verdict):
    assert combined(claim)[1].verdict == verdict
    for name in PLANE if 2 in claim.dimensions else SPACE:
        curve = example(name)
        if claim.applies_to(curve.dimension, curve.polynomial):
            found = claim.check(curve).verdict
            assert found == VERIFIED if verdict == PROVED else found != VERIFIED


CONTACTS = {"osculating_circle": 2, "tangent": 1, "circle_through": 0}


@pytest.mark.parametrize(("name", "order"), CONTACTS.items())
def test_contact_is_exactly_what_it_is(name, order):
    assert_verdict(contact(name, order), PROVED)
    assert combined(contact(name, order, relation="≥"))[1].verdict == PROVED
    assert_verdict(contact(name, order + 1), REFUTED)
    assert worded(contact(name, order + 1).prove()[1].computed) == str(order)
    if order:
        assert combined(contact(name, order - 1))[1].verdict == REFUTED
        assert combined(contact(name, order - 1, relation="≥"))[1].verdict == PROVED


def test_contact_in_space_and_what_does_not_exist():
    assert_verdict(contact("osculating_plane", 2, curve="pair"), PROVED)
    assert_verdict(contact("osculating_plane", 3, curve="pair"), REFUTED)
    assert combined(contact("nothing", 1))[1].verdict == VACUOUS
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
    assert_verdict(invariance(name, under, weight), PROVED)
    units = under not in ("motion", "rotation", "translation")
    for wrong in (weight + 1, weight - 1) if units else ():
        assert_verdict(invariance(name, under, wrong), REFUTED)


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
    assert_verdict(invariance(*claim), REFUTED)


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
    assert_verdict(invariance("square_of_speed", "Möbius map", 2), PROVED)
    assert_verdict(invariance("vertices", "Möbius map", 4), PROVED)
    assert_verdict(invariance("vertices", "Möbius map", 3), REFUTED)
    assert_verdict(invariance("f2", "Möbius map", 3), REFUTED)


def test_what_moves_along_is_told():
    assert_verdict(invariance("evolute", "similarity", nature="point"), PROVED)
    assert_verdict(invariance("evolute", "similarity", nature="vector"), REFUTED)
    assert_verdict(invariance("evolute", "similarity"), REFUTED)
    assert_verdict(invariance("evolute", "affine map", nature="point"), REFUTED)


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"under": "motion", "weight": 1}, "has no unit"),
        ({"under": "reparametrization", "nature": "point"}, "moves nothing"),
        ({"under": "Möbius map", "nature": "vector"}, "not linear"),
        ({"under": "similarity", "curve": "plane with delta"}, "constants"),
        ({"under": "similarity", "curve": "hodograph"}, "not decided"),
        ({"under": "shear"}, "unknown"),
        ({"under": "scaling", "weight": True}, "not a weight"),
    ],
)
def test_invariance_that_says_nothing_is_refused(changes, told):
    with pytest.raises(ClaimError, match=told):
        Invariance(**BASE, **({"curve": "plane", "formula": "f2"} | changes))


def test_signs():
    assert_verdict(sign("D1_squared", "≥ 0", ("D1",)), PROVED)
    assert_verdict(sign("D1_squared", "≤ 0", ("D1",)), REFUTED)
    assert combined(sign("D1_squared", "> 0", ("D1",)))[1].verdict == REFUTED
    assert combined(sign("D1_squared", "> 0", ("D1",), assumes=("γ′",)))[1].verdict == PROVED
    assert combined(sign("D1_squared", "≥ 0"))[1].verdict == UNDECIDED
    assert combined(sign("D1_squared", "≥ 0", ("f2",)))[1].verdict == UNDECIDED
    assert combined(sign("f2", "≥ 0", ("D1",)))[1].verdict == REFUTED
    assert sign("D1_squared", "≥ 0").check(example("cusp")).verdict == VERIFIED
    assert sign("D1_squared", "> 0").check(example("cusp")).verdict == REFUTED
    for wrong in ("-1", "w^3", "f2", "-2 w^2"):
        with pytest.raises(ClaimError, match="has no sign"):
            sign("D1_squared", "≥ 0", ("D1",), factor=wrong)


def test_a_square_that_is_zero_makes_nothing_positive(monkeypatch):
    monkeypatch.setitem(OWN, "zero", formula("a test", on="plane")(lambda c: c.w - c.w))
    assert combined(sign("D1_squared", "≥ 0", ("D1", "zero")))[1].verdict == PROVED
    assert combined(sign("D1_squared", "> 0", ("D1", "zero")))[1].verdict == REFUTED
    assert combined(sign("D1_squared", "> 0", ("zero", "D1"), assumes=("w",)))[1].verdict == REFUTED


def test_a_square_with_a_positive_factor_only(monkeypatch):
    def product(c):
        return 3 * c.w**2 * norm2(find("D1")(c))

    monkeypatch.setitem(OWN, "product", formula("a test", on="plane")(product))
    assert_verdict(sign("product", "≥ 0", ("D1",), factor="3 w^2"), PROVED)
    assert combined(sign("product", "≥ 0", ("D1",), factor="2 w^2"))[1].verdict == UNDECIDED
    assert combined(sign("product", "≤ 0", ("D1",), factor="3 w^2"))[1].verdict == REFUTED
