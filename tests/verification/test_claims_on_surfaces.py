"""Claims checked on single surfaces: what holds, what is vacuous there, and statements that are false."""

import json
import re
from dataclasses import replace
from functools import cache

import pytest

from exactspline import ExactSplineError, Verdict, example, paper, write
from exactspline.display.ledger import reasons
from exactspline.verification.claims import claims_of
from exactspline.verification.ledger import audit
from tests.support.command import invoke
from tests.support.sampled import FULL

CLAIMS = claims_of(paper("surfaces"))


@cache
def on(name):
    """All claims on an example surface."""
    return checked(name, CLAIMS)


def checked(name, claims):
    return list(audit(claims, [example(name)]))


def named(key):
    return next(claim for claim in CLAIMS if claim.key == key)


@pytest.mark.parametrize("name", ["rational_biquadratic", "monkey_saddle", "planar_map", *["cone", "torus"] * FULL])
def test_no_claim_is_refuted_on_a_surface(name):
    rows = on(name)
    assert rows
    assert all(
        row.as_recorded and row.verdict in (Verdict.VERIFIED, Verdict.UNDECIDED, Verdict.VACUOUS, Verdict.INAPPLICABLE)
        for row in rows
    )
    assert any(row.verdict == Verdict.VERIFIED for row in rows)


def test_what_vanishes_on_a_plane_patch_is_vacuous():
    rows = {row.key: row for row in on("cone")}
    assert rows["S3-parabolic-parabolic_lifted"].verdict == Verdict.VACUOUS
    assert rows["S1-E-E_reduced"].verdict == Verdict.VERIFIED


def test_what_is_not_multiplied_out_is_undecided_and_not_said_to_be_outside_of_the_claim():
    (long,) = checked("torus", [claim for claim in CLAIMS if "brioschi" in claim.named])
    assert (long.verdict, long.expected, long.as_recorded) == (Verdict.UNDECIDED, (Verdict.UNDECIDED,), True)
    assert str(long.witness).startswith("decided by the proof for all curves: brioschi as written has degree 208 in u")
    assert not any("brioschi" in str(row.witness) for row in on("bicubic"))


def test_curves_are_named_by_what_they_are_where_claims_say_nothing_of_a_surface():
    claims = claims_of(paper("chen_riesenfeld_cohen_2007"))
    torus = example("torus")
    silent = [claim for claim in claims if not claim.applies_to(3, False, surface=True)]
    told = reasons(silent, torus)
    assert "both" not in told
    assert sum(map(int, re.findall(r"\d+(?= of)", told))) == len(claims)


def test_claims_of_polynomial_surfaces_are_silent_of_rational_ones():
    assert not checked("torus", [claim for claim in CLAIMS if claim.key.startswith("PM1")])
    assert any(row.key.startswith("PM1") and row.verdict == Verdict.VERIFIED for row in on("bicubic"))


@pytest.mark.parametrize("factor", ["w^-3", "2 w^-4", "1"])
def test_a_wrong_factor_is_refuted_on_a_rational_surface(factor):
    wrong = replace(named("S2-L-L_lifted"), factor=factor, expected=Verdict.REFUTED, key="S2-wrong")
    (row,) = checked("rational_biquadratic", [wrong])
    assert row.verdict == Verdict.REFUTED
    assert "at the parameters" in str(row.witness)


def test_a_wrong_power_of_w_holds_where_w_is_one():
    wrong = replace(named("S2-L-L_lifted"), factor="w^-3", expected=Verdict.REFUTED, key="S2-wrong")
    (row,) = checked("bicubic", [wrong])
    assert (row.verdict, str(row.factor)) == (Verdict.VERIFIED, "w⁻³ = 1 (polynomial: w = 1)")


def test_a_proof_that_fails_on_a_surface_is_a_contradiction(monkeypatch):
    wrong = replace(named("S2-L-L_lifted"), factor="2 w^-4", key="S2-wrong")
    right = named("S2-L-L_lifted")
    monkeypatch.setattr(type(wrong), "prove", lambda self: ("jet", right.decide(3, False)))
    (row,) = checked("rational_biquadratic", [wrong])
    assert (row.verdict, row.as_recorded) == (Verdict.CONTRADICTION, False)


def test_the_command(tmp_path):
    path = tmp_path / "own.json"
    write(example("biquadratic"), path)
    told = invoke("prove", "--surface", str(path), "--surface", "paraboloid", "--json")
    assert told.exit_code == 0
    rows = json.loads(told.stdout)["rows"]
    assert {row["curve"] for row in rows} == {"biquadratic", "paraboloid"}
    assert len({row["key"] for row in rows}) == len(rows)
    text = invoke("prove", "--paper", "surfaces", "--claim", "S3", "--surface", "cone", "-q")
    assert "VACUOUS" in text.output
    assert text.output.splitlines()[0].startswith("cone: rational, degree 2 × 1")
    assert "4 × 1 patches, 9 × 2 control points in R3" in " ".join(text.output.split())


@pytest.mark.parametrize("arguments", [["--surface", "tours"], ["--surface", "circle"]])
def test_a_name_that_is_no_surface_is_told(arguments):
    told = invoke("prove", "--paper", "surfaces", *arguments)
    assert told.exit_code == 2


def test_another_judge_and_a_surface():
    told = invoke("prove", "--paper", "surfaces", "--surface", "torus", "--judge", "sympy")
    assert isinstance(told.exception, ExactSplineError)
    assert "--surface" in str(told.exception)
