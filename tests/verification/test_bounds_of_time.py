"""What a question may cost is bounded, and what exceeds the bound is named."""

import json
from functools import partial

import pytest

import exactspline as xs
from exactspline.errors import ReachError
from exactspline.polynomials import cost
from exactspline.verification import combined
from tests.support.command import run

FORMULAS = """from exactspline.language import formula, norm2
@formula("a", on="plane")
def a(c):
    return norm2(c.gamma.d(4)) ** 24
@formula("b", on="plane")
def b(c):
    return c.w * a(c)
"""
CLAIM = (
    '[[claim]]\nid = "1"\nkind = "identity"\nplace = "p"\nstatement = "s"\nleft = "a"\nright = "b"\ncurve = "plane"\n'
)


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "formulas.py").write_text(FORMULAS)
    (tmp_path / "claims.toml").write_text(CLAIM)
    return tmp_path


def test_a_formula_on_a_curve_has_a_bound_of_time(folder, monkeypatch):
    """False before: products of splines cost nothing, so that a check had no bound (minutes for each curve)."""
    small = partial(cost.Budget, 5 * 10**7)
    monkeypatch.setattr(combined, "Budget", small)
    out = json.loads(run("prove", "--paper", folder, "--curve", "rational_cubic_s", "--json").stdout)
    [row] = [row for row in out["rows"] if row["curve"]]
    assert (row["verdict"], row["reason"]) == ("UNDECIDED", "out of reach")
    monkeypatch.setattr(cost, "Budget", small)
    with pytest.raises(ReachError, match="line 4, a: a spline of degree"):
        xs.derive(xs.paper(folder).find("a"), xs.example("rational_cubic_s"))
