"""Verdicts say no more than was shown: witnesses are some, what is counted is counted, a name means one thing."""

from dataclasses import replace

import pytest

from exactspline import Verdict, claims, decide, example, paper
from exactspline.errors import FormulaError
from exactspline.language.kinds import kind_of
from exactspline.numbers.exact import to_fmpq
from exactspline.papers import Table
from exactspline.readings import JetReading
from exactspline.verification.claims import claim_of
from exactspline.verification.evaluation import on_segments
from tests.support.claims import refusal
from tests.verification.test_own_paper import plane_formulas, written


def claim(source="chen_riesenfeld_cohen_2007", **entry):
    told = {"id": "X", "key": f"X-{entry['kind']}", "statement": "s"} | entry
    return claim_of(Table("here", told), paper(source))


@pytest.mark.parametrize(("claimed", "relation"), [("2d − 2", "≥"), ("2d − 2", "="), ("d", "≤"), ("d + 1", "≥")])
def test_the_witness_of_a_degree_is_one(claimed, relation):
    """Passed before: "at d = 3: 6, not 6" as the witness of a bound that fails at another d."""
    found = claim(kind="degree", curve="plane", formula="f2", of="polynomial", claimed=claimed, relation=relation)
    verdict = found.prove()[1]
    if verdict.verdict == Verdict.REFUTED:
        computed, said = str(verdict.witness).split(": ")[1].split(", not ")
        assert not found.relation.holds(int(computed), int(said.split()[-1]))
        assert (relation == "=") == (said.split()[-1] == said)


def test_a_witness_of_unequal_degrees_is_sought_where_equal_ones_show_nothing():
    """Passed before: d1 + d2 against 2 d1 of Table 1 was refuted "at d1 = 3 and d2 = 3: 6, not 6"."""
    product = next(c for c in claims() if c.curve == "table" and str(c.claims).replace(" ", "") in ("d1+d2", "d2+d1"))
    wrong = replace(product, claimed="2d1").prove()[1]
    assert wrong.verdict == Verdict.REFUTED
    computed, said = str(wrong.witness).split(": ")[1].split(", not ")
    assert computed != said


def test_a_form_that_vanishes_has_no_number_of_roots(tmp_path):
    """Passed before: "0 roots" of 0, and of the numerator of f/f those of f."""
    formulas = plane_formulas(
        nothing="det(c.gamma.d(1), c.gamma.d(1))",
        turning="det(c.gamma.d(1), c.gamma.d(2))",
        one="turning(c) / turning(c)",
        speed="norm2(c.gamma.d(1))",
    )
    told = {"kind": "count", "curve": "plane", "example": "six_segment_cubic", "statement": "s"}
    counted = [("nothing", "0 roots"), ("one", "2 roots"), ("one", "0 roots"), ("speed", "8 extrema")]
    entries = [told | {"id": f"{i}", "formula": f, "claimed": n} for i, (f, n) in enumerate(counted)]
    rows = [decide(each) for each in claims(paper=paper(written(tmp_path / "counts", formulas, entries)))]
    assert [row.verdict for row in rows] == [Verdict.VACUOUS, Verdict.REFUTED, Verdict.VERIFIED, Verdict.UNDECIDED]
    assert "does not change its sign exactly where the curvature has its extrema" in str(rows[3].witness)


def test_a_formula_is_not_called_like_a_constant_of_its_kind(tmp_path):
    """Passed before: the factor "delta" meant the formula with this name, whatever it was."""
    text = "@formula('e', on='plane with delta')\ndef delta(c):\n    return c.delta * c.delta\n"
    text += "@formula('e', on='plane with delta')\ndef speed(c):\n    return norm2(c.gamma.d(1))\n"
    text += "@formula('e', on='plane with delta')\ndef twice(c):\n    return c.delta * c.delta * speed(c)\n"
    entry = {"id": "1", "kind": "identity", "curve": "plane with delta", "left": "twice", "right": "speed"}
    folder = written(tmp_path / "named", text, [entry | {"factor": "delta", "statement": "s"}])
    assert "a constant of 'plane with delta'" in refusal(folder)


@pytest.mark.parametrize(("kind", "letter"), [("surface", "s"), ("plane", "u"), ("pair", "v"), ("forms", "s̄")])
def test_jets_refuse_a_parameter_that_the_kind_lacks(kind, letter):
    """Passed before: ∂/∂s of a surface was 0."""
    c = JetReading(1).argument(kind_of(kind), 2 if kind == "plane" else 3)
    operand = next(iter(c.operands().values()))
    with pytest.raises(FormulaError, match=f"a derivative with respect to '{letter}'"):
        operand.d(1, by=letter)


def test_a_segment_is_the_curve():
    """Polynomials in the parameter, less that at which the segment begins, with the derivatives of the curve."""
    curve = example("rational_cubic_spline")
    for segment in on_segments(kind_of("plane"), curve, 2):
        x = segment.argument.p[0]
        t = (segment.high - segment.low) / 3
        for order in range(3):
            value = x.d(order).top(*[to_fmpq(t)])
            assert str(value) == str(to_fmpq(curve.p[0].d(order)(segment.low + t)))


def test_a_sign_beside_a_hodograph_is_not_that_of_one_factor(tmp_path):
    """h > 0 was VERIFIED "on all of the curve", with the weight function for h, which is any function."""
    head = "[common]\nstatus = 'ours'\nplace = 'e'\nstatement = 's'\nid = '1'\n"
    claim = {"kind": "sign", "curve": "hodograph", "formula": "factor", "sign": "> 0"}
    text = "@formula('e', on='hodograph')\ndef factor(c):\n    return c.h\n"
    (own,) = claims(paper=paper(written(tmp_path / "h", text, [claim], head)))
    found = own.check(example("rational_cubic"))
    assert found.verdict == "UNDECIDED"
    assert "u, v and h" in str(found.witness)
