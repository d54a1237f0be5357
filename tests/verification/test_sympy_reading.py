"""A second judge: sympy decides every identity of the ledger as the jets do, and refutes false ones."""

import json
from dataclasses import replace

import pytest
import sympy
from click.testing import CliRunner

from exactspline import ExactSplineError, decide, formula_of
from exactspline.cli import app
from exactspline.errors import ClaimError, FormulaError
from exactspline.language.kinds import CURVE, PAIR, POINT_IN_SPACE
from exactspline.readings.sympy_expression import FIRST, SympyReading, vanishes
from exactspline.verification.claims import all_claims, select
from exactspline.verification.judges import Sympy, second_opinion
from tests.support import command
from tests.support.sampled import FULL, sample
from tests.verification.test_own_paper import plane_formulas, written

#: Developable surfaces whose sides take sympy longer than all other identities together.
SLOW = {"C54a-rectifying_development", "C54a-darboux_development", "C56a-focal_development"}

x, y, w = (sympy.Function(name)(FIRST) for name in "xyw")


def test_every_identity_of_the_ledger_is_decided_alike():
    """A part of them, by a seed; with EXACTSPLINE_FULL every one."""
    kinds = {"identity", "vanishing", "same surface", "iso-curve"}
    equalities = [claim for claim in all_claims() if claim.kind in kinds and (FULL or claim.key not in SLOW)]
    few = [claim for claim in equalities if claim.kind == "iso-curve"]  # of which a sample may have none
    claims = list(dict.fromkeys([*sample(equalities, 30), *few]))
    rows = [second_opinion(Sympy(), decide(claim)) for claim in claims]
    assert [(r.id, r.statement, r.verdict) for r in rows if r.differs] == []
    assert len(rows) == len(claims)
    assert {c.kind for c in claims} == kinds
    assert {r.second.verdict for r in rows} == {"PROVED", "REFUTED"}


@pytest.mark.parametrize("factor", ["1", "w^2", "2 w", "-1 w", "f2"])
def test_a_false_factor_is_refuted(factor):
    claim = select(["C4.1a"])[0]
    assert Sympy().decide(claim).verdict == "PROVED"
    assert Sympy().decide(replace(claim, factor=factor)).verdict == "REFUTED"


def test_what_vanishes_on_both_sides_or_divides_by_zero_is_no_proof():
    true = next(c for c in all_claims() if c.key == "C3d-velocity_acceleration_jerk-D1_D2_D3")
    assert Sympy().decide(true).verdict == "PROVED"
    assert Sympy().decide(replace(true, factor="D1_D2_D21")).verdict == "REFUTED"
    assert Sympy().decide(replace(true, factor="D1_D2_D21^-1")).verdict == "REFUTED"
    nothing = Sympy().decide(replace(true, left="rectifying_plane", right="D1_D2_D21", factor="1"))
    assert (nothing.verdict, str(nothing.computed)) == ("VACUOUS", "0 = 0")


def test_false_vanishing_and_false_surfaces_are_refuted():
    claim = next(c for c in select(["C3c"]) if c.left == "D1_D2_D21")
    assert Sympy().decide(replace(claim, left="D1_D2_D3")).verdict == "REFUTED"
    surface = next(c for c in all_claims() if c.kind == "same surface" and c.left == "binormal_scroll")
    assert Sympy().decide(surface).verdict == "PROVED"
    assert Sympy().decide(replace(surface, left="normal_scroll")).verdict == "REFUTED"


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        ((x / w).diff(FIRST) - (x.diff(FIRST) * w - x * w.diff(FIRST)) / w**2, True),
        ((x / w).diff(FIRST) + (x.diff(FIRST) * w - x * w.diff(FIRST)) / w**2, False),
        ((x + y) ** 5 / (x + y) ** 4 - x - y, True),
        ((x**2 - y**2) / (x - y) - x - y, True),
        ((x**2 - y**2) / (x - y) - x + y, False),
        (1 / (2 * x + 2 * y) - 1 / (x + y) / 2, True),
        (1 / (x - y) + 1 / (y - x), True),
        (1 / (x - y) - 1 / (y - x), False),
        (x**2 * w - w * x**2, True),
        (sympy.Integer(3), False),
        ((6 * x * y + 4 * y) / (3 * x + 2) - 2 * y, True),
        ((6 * x * y + 4 * y) / (3 * x + 2) - 3 * y, False),
    ],
)
def test_vanishing_is_decided(expression, expected):
    assert vanishes(expression) is expected


def test_what_is_no_rational_expression_is_refused():
    with pytest.raises(FormulaError, match="not a rational expression"):
        vanishes(sympy.sin(x) - y)
    c = SympyReading().argument(CURVE, 2)
    with pytest.raises(FormulaError, match="division by an expression that vanishes"):
        c.w / (c.p[0] - c.p[0])
    with pytest.raises(FormulaError, match="division by an expression that vanishes"):
        vanishes(1 / ((x + y) ** 2 - x**2 - y**2 - 2 * x * y) - w)


def test_each_curve_has_its_own_parameter():
    c = SympyReading().argument(PAIR, 3)
    assert c.first.w.d().expression.variables != c.second.w.d().expression.variables
    with pytest.raises(FormulaError, match="two parameters"):
        (c.first.w * c.second.w).d()
    assert SympyReading().argument(POINT_IN_SPACE, 3).point[0].d().is_zero


def test_a_formula_is_an_expression_of_sympy():
    found = formula_of("f2")(SympyReading().argument(CURVE, 2)).expression
    by_hand = sympy.Matrix([[w, x, y]] + [[f.diff(FIRST, k) for f in (w, x, y)] for k in (1, 2)]).det()
    assert sympy.expand(found - by_hand) == 0


def test_the_option_of_the_command_line():
    run = CliRunner().invoke
    told = run(app, ["prove", "--claim", "C4.1a", "--judge", "sympy"])
    assert told.exit_code == 0
    assert "sympy: 2 PROVED; all as recorded" in " ".join(told.output.split())
    assert isinstance(run(app, ["prove", "--judge", "nobody"]).exception, ClaimError)
    both = run(app, ["prove", "--judge", "sympy", "--curve", "circle"])
    assert isinstance(both.exception, ExactSplineError)


def test_a_claim_that_sympy_does_not_decide_keeps_its_row_and_its_verdict(tmp_path):
    """Before, `--judge sympy` left out every claim that is not an equality: of a folder with a false degree it said
    "no rows", with exit status 0; and no curve was tried.
    """
    equality = {"id": "1", "kind": "identity", "curve": "plane", "statement": "f is g", "left": "f", "right": "g"}
    degree = {"id": "2", "kind": "degree", "curve": "plane", "statement": "f", "formula": "f", "claimed": "d"}
    folder = written(tmp_path / "own", plane_formulas(f="c.w * c.w", g="c.w * c.w"), [equality, degree])
    told = command.run("prove", "--paper", folder, "--judge", "sympy", "--rows", "--json")
    rows = json.loads(told.stdout)["rows"]
    assert [(r["verdict"], r["sympy"]) for r in rows if not r["curve"]] == [
        ("PROVED", "holds, 1"),
        ("REFUTED", "not asked: it decides equalities alone"),
    ]
    assert {r["verdict"] for r in rows if r["curve"] and r["id"] == "1"} == {"VERIFIED"}
    assert told.returncode == 1
