"""The ledger: claims are data, verdicts are computed, and a wrong claim is caught."""

from dataclasses import replace

import pytest

from exactspline import claims, example, formula_of
from exactspline.errors import ClaimError
from exactspline.papers import papers
from exactspline.readings import parse_degree
from exactspline.readings.degree import Degree, equal_from
from exactspline.tables import jets_for
from exactspline.verification.notation import factor_of_text
from tests.support.decided import ledger


def claim(claim_id, index=0):
    return claims(claim_id)[index]


@pytest.mark.parametrize("source", [source.name for source in papers()])
def test_every_verdict_is_as_recorded(source):
    rows = ledger(source)
    assert [(row.key, row.curve, row.verdict, str(row.witness)) for row in rows if not row.as_recorded] == []
    assert "PROVED" in {row.verdict for row in rows if not row.curve}
    assert all(0 <= row.seconds < 60 for row in rows)
    assert all(str(row.witness) for row in rows if row.verdict == "REFUTED" and not row.curve)


def test_ids_select_what_they_begin():
    assert {c.id for c in claims("C4.1")} == {"C4.1a", "C4.1b", "C4.1c", "C4.1d", "C4.1e"}
    assert [c.key for c in claims("T2")] == ["T2-degree", "T2-T2-polynomial"]
    with pytest.raises(ClaimError, match="no claim has the id 'C9'"):
        claims("C9")


@pytest.mark.parametrize(
    ("field", "wrong"),
    [("factor", "w^2"), ("factor", "2 w"), ("factor", "1"), ("right", "f1_expanded"), ("left", "velocity_jerk")],
)
def test_a_wrong_identity_is_refuted_with_the_exact_quotient(field, wrong):
    false = replace(claim("C4.1a"), **{field: wrong})
    reading, finding = (false).prove()
    assert (reading, finding.verdict) == ("jet", "REFUTED")
    assert finding.witness is not None
    assert false.check(example("rational_cubic")).verdict == "REFUTED"


def test_a_wrong_vanishing_is_refuted_at_a_parameter_where_it_does_not_vanish():
    finding = replace(claim("C3c"), left="D1_D2_D3").check(example("rational_space_cubic"))
    assert finding.verdict == "REFUTED"
    assert "at the parameter" in str(finding.witness)


def test_a_zero_set_that_differs_is_seen_on_the_curve():
    false = replace(claim("C4.1b"), formulas=("f2", "velocity_jerk"))
    assert false.check(example("rational_cubic_s")).verdict == "REFUTED"
    assert claim("C4.1b").check(example("rational_cubic_s")).verdict == "VERIFIED"


def test_factors_are_read_as_they_are_written():
    c = jets_for(("f1",), 2)
    top, bottom = factor_of_text("2 w^3 f2^-1", c)
    assert top == 2 * c.w**3
    assert bottom == formula_of("f2")(c)
    with pytest.raises(ClaimError, match="cannot be read"):
        factor_of_text("w^", c)


def test_degrees_are_equal_from_some_degree_on():
    d = Degree.named("d")
    assert equal_from(parse_degree("max(2d - 1, d)"), parse_degree("2d − 1")) == 1
    assert equal_from(parse_degree("max(d, 7)"), d) == 7
    assert equal_from(parse_degree("2d"), parse_degree("2d - 1")) is None
    assert equal_from(parse_degree("max(d1, d2)") * parse_degree("max(d1, d2)"), parse_degree("max(2d1, 2d2)")) == 1
    assert equal_from(parse_degree("max(2d1, 2d2)"), parse_degree("d1 + d2")) is None
    assert str(parse_degree("d1 + d2") * parse_degree("max(d1, 4)")) == "max(2d1 + d2, d1 + d2 + 4)"
