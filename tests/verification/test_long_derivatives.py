"""Derivatives of quotients over frames, and products of long vectors and their derivatives."""

import re

import pytest

from exactspline import Verdict, claims, paper
from exactspline.language import Vector, cross, det, dot, formula, norm2
from exactspline.language.kinds import SPACE
from exactspline.readings import jet
from exactspline.readings.differential_order import is_polynomial, order_of
from exactspline.readings.jet import RationalJetReading
from tests.campaigns import derivatives
from tests.support.claims import one_verdict
from tests.verification.test_own_paper import written


@pytest.fixture
def all_are_long(monkeypatch):
    monkeypatch.setattr(jet, "LONG", 0)


def vectors():
    """γ, another vector, and one whose first component vanishes, over an indeterminate curve."""
    c = RationalJetReading(4).argument(SPACE, 3)
    g, (x, y, z) = c.gamma, c.gamma
    return g, Vector(y * y, z, x), Vector(x - x, y, z)


@pytest.mark.parametrize("i", range(3))
def test_products_of_a_vector_and_its_derivatives_are_what_they_are(all_are_long, monkeypatch, i):
    def found():
        v = vectors()[i]
        return [det(v, v.d(1), v.d(2)), *cross(v.d(1), v.d(2)), norm2(v.d(1)), *cross(v, v.d(1))]

    ours = found()
    monkeypatch.setattr(jet, "LONG", 10**9)
    assert ours == found()


def test_what_is_not_a_vector_with_its_derivatives_is_multiplied_out(all_are_long, monkeypatch):
    """Passed by a careless rule: v·v′ = P² u·u′ leaves P P′ u·u out; and a second vector is no derivative."""

    def found():
        (v, w, _) = vectors()
        chains = [(v, w.d(1), w.d(2)), (v, v.d(2), v.d(1)), (v, v.d(1), v.d(3)), (v, v.d(1) + v, v.d(2))]
        return [
            dot(v, v.d(1)),
            dot(v.d(1), v),
            dot(v, w),
            *cross(v, w),
            *cross(v, v.d(2)),
            *(det(*each) for each in chains),
        ]

    ours = found()
    monkeypatch.setattr(jet, "LONG", 10**9)
    assert ours == found()


@formula("a test", on="plane")
def half(c):
    return c.w / 2


@formula("a test", on="plane")
def quotient(c):
    return (c.p[0] / c.w).d(2) * c.w**9


@formula("a test", on="framed space")
def unit_normal_derivative(c):
    n = cross(cross(c.gamma.d(1), c.gamma.d(2)), c.gamma.d(1)) / (c.sigma * c.rho)
    return n.d(1)


def test_a_quotient_by_a_number_is_a_polynomial_and_one_by_an_operand_is_none():
    assert (is_polynomial(half, 2), is_polynomial(quotient, 2)) == (True, False)
    assert (order_of(half, 2), order_of(quotient, 2)) == (0, 2)
    assert order_of(unit_normal_derivative, 3) >= 3  # before, more than 1024 factors


V, A, J = "c.gamma.d(1)", "c.gamma.d(2)", "c.gamma.d(3)"


def test_a_long_factor_is_a_new_form_until_it_has_a_name(tmp_path):
    form = f"3 * norm2({A}) ** 2 + dot({V}, {J}) ** 2 + det({V}, {J}) * norm2({A}) + dot({V}, {A}) * dot({A}, {J})"
    text = "".join(
        f"@formula('e', on='plane'{more})\ndef {name}(c):\n    return {body}\n"
        for name, body, more in (("left", f"({form}) * norm2({V})", ""), ("right", f"norm2({V})", ""))
    )
    claim = {"id": "1", "kind": "identity", "statement": "s", "status": "ours", "curve": "plane", "of": "polynomial"}
    claim |= {"left": "left", "right": "right"}

    def found(folder, more=""):
        (one,) = claims(paper=paper(written(tmp_path / folder, text + more, [claim])))
        return str(one_verdict(one).factor)

    assert found("a") == "(a new form of degree 4, weight 8)"
    named = f"@formula('e', on='plane', symbol='Φ')\ndef form(c):\n    return ({form}) * 5\n"
    assert found("c", named) == "1/5·Φ"


def test_two_forms_of_one_degree_and_weight_look_different(tmp_path):
    """Printed before: (a new form …)·(a new form …)⁻¹, which looks like 1."""
    form = f"norm2({A}) ** 2 + {{}} * dot({V}, {J}) ** 2 + det({V}, {J}) * norm2({A}) + dot({V}, {A}) * dot({A}, {J})"
    text = "".join(
        f"@formula('e', on='plane')\ndef {name}(c):\n    return ({form.format(n)}) * norm2({V})\n"
        for name, n in zip("lr", "12")
    )
    claim = {"id": "1", "kind": "identity", "statement": "s", "status": "ours", "curve": "plane", "of": "polynomial"}
    (one,) = claims(paper=paper(written(tmp_path / "p", text, [claim | {"left": "l", "right": "r"}])))
    factor = str(one_verdict(one).factor)
    parts = re.fullmatch(r"(\(a new form[^()]+\))·\[(\(a new form[^()]+\)), no. 2\]⁻¹", factor)
    assert parts, factor
    assert parts[1] == parts[2]


def test_the_focal_curve_is_decided_by_what_its_derivatives_have_in_common(tmp_path):
    """[E′ E″ E‴] = λ³ [b b′ b″] for E′ = λ b. Before, more than a million terms, out of reach; −λ³ must not pass."""
    text, common = derivatives.FORMULAS, {"statement": "s", "status": "ours", "curve": "space", "kind": "identity"}
    bodies = {"left": derivatives.TRUE[-1][1], "right": derivatives.TRUE[-1][2]}
    text += "".join(f"@formula('e', on='space')\ndef {name}(c):\n    return {body}\n" for name, body in bodies.items())
    sides = {"left": "left", "right": "right"}
    folder = written(tmp_path / "p", text, [common | sides | {"id": "1"}, common | sides | {"id": "2", "factor": "-1"}])
    assert [one_verdict(each).verdict for each in claims(paper=paper(folder))] == [Verdict.PROVED, Verdict.REFUTED]


def test_no_changed_identity_keeps_its_verdict():
    """A sample of the campaign."""
    tally, wrong = derivatives.campaign(step=31)
    assert wrong == []
    assert tally["changed", "REFUTED"]
