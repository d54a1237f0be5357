"""``show``: a claim spelled out, for people, for LaTeX, for programs."""

import json

import pytest
from click.testing import CliRunner

from exactspline.cli import app
from exactspline.errors import ClaimError
from exactspline.verification.claims import select

runner = CliRunner()


def show(*arguments):
    result = runner.invoke(app, ["show", *arguments])
    assert result.exit_code == 0, result.output
    return result.output


def test_a_claim_has_its_sides_factor_degrees_verdict_and_source():
    output = show("C4.1a")
    for part in ("f1 = w f2", "[D1 D2]", "naive", "reduced", "3d − 3", "PROVED", "eq. (8)", "factor"):
        assert part in output


def test_latex_is_not_broken_into_lines():
    lines = [line.strip() for line in show("C4.2c", "--latex").splitlines()]
    assert any(line.endswith(r"g_2 = w\,g_1") for line in lines)
    assert any("reduced" in line and line.count("{") == line.count("}") for line in lines)


@pytest.mark.parametrize("wanted", ["C4.2", "Fig. 2", "T17", "C6.2f"])
def test_programs_get_every_statement_with_both_sides(wanted):
    found = json.loads(show(wanted, "--json"))["rows"]
    claims = select([wanted])
    assert [s["statement"] for s in found] == [claim.statement for claim in claims]
    for s, claim in zip(found, claims, strict=True):
        assert {side["name"] for side in s["sides"]} == set(claim.named)
        assert s["verdict"] == s["expected"]
        assert s["latex"]


def test_an_unknown_claim_is_bad_input():
    result = runner.invoke(app, ["show", "C4.9"])
    assert isinstance(result.exception, ClaimError)
    assert "C4" in str(result.exception)
    assert len(str(result.exception)) < 200
