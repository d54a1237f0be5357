"""What a question may cost is bounded, and what exceeds the bound is named."""

import json
from functools import partial
from itertools import count

import pytest

import exactspline as xs
from exactspline import decide
from exactspline.errors import ReachError
from exactspline.polynomials import cost
from exactspline.readings.sympy_expression import vanishes
from exactspline.verification import combined
from exactspline.verification.claims import select
from exactspline.verification.judges import Sympy, second_opinion
from exactspline.verification.ledger import Proofs, audit, tasks
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


def test_a_row_ends_within_the_processor_time_that_the_user_allows(folder, monkeypatch):
    """Before: there was no --limit; 25 rows took a minute and a half."""
    ticks = count()
    monkeypatch.setattr(cost, "thread_time", lambda: next(ticks))
    for words in (["--curve", "rational_cubic_s"], []):
        rows = json.loads(run("prove", "--paper", folder, "--limit", 2, "--json", *words).stdout)["rows"]
        slow = [row for row in rows if row["curve"] in ("", "rational_cubic_s")]
        assert [(row["verdict"], row["reason"]) for row in slow] == [("UNDECIDED", "out of reach")] * len(slow)
        assert all("not decided within 2 s of processor time; raise the limit" in row["witness"] for row in slow)
    for command in (["identity", f"{folder}:a = w * {folder}:b"], ["formula", "reduce", f"{folder}:a"]):
        done = run(*command, "--limit", 1)
        assert done.returncode == 2
        assert "not decided within 1 s of processor time" in done.stderr
    for words in (["--generic"], []):
        assert "not decided within 1 s" in run("formula", "degrees", "--paper", folder, "--limit", 1, *words).stdout


def test_the_time_allowed_changes_no_verdict_and_is_not_remembered():
    """Whenever the time ends, a row is the one without a limit, or undecided for that reason; afterwards all are as
    without a limit.
    """
    claims, curves = select(["C4.1", "C4.2"]), [xs.example("rational_cubic"), xs.example("cusp")]
    free = [row.verdict for row in audit(claims, curves)] + [row.verdict for row in map(decide, claims)]
    for limit in (0, 0.001, 0.01):
        proofs = Proofs()
        timed = [task() for task in tasks(claims, curves, limit)] + [decide(each, proofs, limit) for each in claims]
        for row, verdict in zip(timed, free, strict=True):
            assert row.verdict == verdict or (row.verdict == "UNDECIDED" and "not decided within" in str(row.witness))
        assert limit or any(row.verdict == "UNDECIDED" for row in timed)
        assert [decide(each, proofs).verdict for each in claims] == free[-len(claims) :]


def test_the_second_judge_ends_within_the_time_too():
    """Before: nothing that sympy computes was bounded."""
    row = decide(select(["C4.1a"])[0])
    vanishes.cache_clear()
    assert "not decided within 0 s" in str(second_opinion(Sympy(), row, 0).second.witness)
    assert second_opinion(Sympy(), row).second.verdict == "PROVED"
