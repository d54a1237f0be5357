"""The guide's fields, tested against the template of `paper new`: what docs/your-own-paper.md says of a claim is
accepted, and what a kind of claims has is in the guide.
"""

import re
from dataclasses import fields

import pytest

from exactspline import Verdict, decide, paper
from exactspline.symbolic.assumptions import ASSUMPTIONS
from exactspline.verification.claims import claims_of
from exactspline.verification.kinds import KINDS
from tests.support.command import invoke, new_paper
from tests.verification.test_own_paper import DOCS, text_of

pytestmark = pytest.mark.skipif(not DOCS.exists(), reason="the documents are in the checkout only")


def fields_of(kind):
    """The fields that an entry of a kind may have."""
    return {each.name for each in fields(kind)} - {"paper"}


COMMON = set.intersection(*map(fields_of, KINDS.values()))
#: A claim of every kind about the formulas of the template and these, with every field of the guide, and its verdict.
MORE = """
from exactspline.language import ruled

@formula("e", on="plane")
def bent(c):
    return det(c.p.d(1), c.p.d(2))

@formula("e", on="framed plane")
def curvature(c):
    return turning(c) / c.sigma**3

@formula("e", on="plane pair")
def tangent(c):
    return det(c.first.gamma.d(1), c.second.gamma - c.first.gamma)

@formula("e", on="plane point")
def to_point(c):
    return c.gamma - c.point

@formula("e", on="point")
def cone(c):
    return ruled(c.gamma - c.point, c.gamma.d(1))

@formula("e", on="space")
def tangents(c):
    return ruled(c.gamma, c.gamma.d(1))

@formula("e", on="space")
def tangents_too(c):
    return ruled(c.gamma + c.gamma.d(1), c.gamma.d(1) * 2)
"""
CLAIMS = [
    ({"kind": "identity", "left": "turning", "right": "turning_by_normal", "factor": "1"}, Verdict.PROVED),
    ({"kind": "vanishing", "left": "bent", "expected": "REFUTED"}, Verdict.REFUTED),
    (
        {"kind": "degree", "formula": "bent", "claimed": "2d - 3", "measure": "nominal", "relation": "=", "least_d": 2}
        | {"parameter": "s", "counting": "Table 1"},
        Verdict.PROVED,
    ),
    ({"kind": "zero set", "formulas": ["turning", "turning_by_normal"]}, Verdict.PROVED),
    ({"kind": "same surface", "left": "tangents", "right": "tangents_too", "curve": "space"}, Verdict.PROVED),
    ({"kind": "iso-curve", "left": "to_point", "right": "cone", "curve": "plane point"}, Verdict.PROVED),
    ({"kind": "contact", "formula": "tangent", "order": 1, "relation": "=", "curve": "plane pair"}, Verdict.PROVED),
    ({"kind": "invariance", "formula": "turning", "under": "motion", "weight": 0, "nature": "scalar"}, Verdict.PROVED),
    (
        {"kind": "sign", "formula": "speed_squared", "sign": "≥ 0", "squares": ["velocity"], "factor": "1"},
        Verdict.PROVED,
    ),
    ({"kind": "square class", "formula": "turning", "right": "turning_by_normal"}, Verdict.PROVED),
    ({"kind": "type", "formula": "curvature_squared", "claimed": "rational"}, Verdict.PROVED),
    ({"kind": "applies", "formula": "turning"}, Verdict.PROVED),
    ({"kind": "existence", "formula": "curvature_squared", "definition": "curvature"}, Verdict.UNDECIDED),
    (
        {"kind": "count", "formula": "turning", "example": "arch", "claimed": "0 roots", "interval": [0, 1]},
        Verdict.VERIFIED,
    ),
    ({"kind": "at", "formula": "bent", "example": "arch", "parameter": 0, "claimed": 0}, Verdict.REFUTED),
    ({"kind": "limit", "formula": "bent", "example": "arch", "parameter": 0, "claimed": "∞"}, Verdict.REFUTED),
    ({"kind": "bound", "formula": "bent", "example": "arch", "bound": "≥ -9999", "interval": [0, 1]}, Verdict.VERIFIED),
    ({"kind": "distance", "example": "arch", "other": "circle", "bound": "≤ 100"}, Verdict.VERIFIED),
    (
        {"kind": "coefficients", "formula": "bent", "sign": "≥ 0", "curves": "every", "on": "curve", "example": "arch"},
        Verdict.REFUTED,
    ),
    ({"kind": "condition", "left": "turning", "right": "turning_by_normal", "example": "arch"}, None),
    ({"kind": "not asked", "why": "an integral"}, Verdict.NOT_ASKED),
]


def page():
    return DOCS.read_text(encoding="utf-8")


def fields_in_the_guide():
    """The fields of each kind, as its row of the guide names them."""
    rows = re.findall(r"^\| `([\w -]+)` \| (.*?) \| .*\|$", page().partition("## Claims")[2], re.MULTILINE)
    return {kind: set(re.findall(r"(?:^|, )`(\w+)`", fields)) for kind, fields in rows if kind in KINDS}


def own_paper(tmp_path, *claims):
    """The template with these claims at its end; of its own claims none."""
    folder = new_paper(tmp_path / "mine")
    with (folder / "formulas.py").open("a") as file:
        file.write(MORE)
    entries = [{"id": f"{i}", "statement": "said", "curve": "plane"} | claim for i, claim in enumerate(claims)]
    lines = [["[[claim]]", *[f"{name} = {text_of(value)}" for name, value in each.items()]] for each in entries]
    (folder / "claims.toml").write_text("\n".join(line for each in lines for line in each))
    return folder


def test_every_field_of_every_kind_is_in_the_guide_and_no_other():
    guide = fields_in_the_guide()
    assert guide.keys() == KINDS.keys()
    for name, kind in KINDS.items():
        own = fields_of(kind) - COMMON
        assert own <= guide[name] <= fields_of(kind), name


def test_what_any_claim_may_have_is_in_the_guide():
    table = page().partition("Any claim may also have these fields:")[2].partition("\n\n")[2].partition("\n\n")[0]
    named = set(re.findall(r"`(\w+)`", "".join(re.findall(r"^\| (.*?) \|", table, re.MULTILINE))))
    elsewhere = {"id", "statement", "source", "status", "on", "example"}
    assert named | elsewhere == COMMON


def test_a_claim_of_every_kind_is_accepted_at_the_first_try(tmp_path):
    assert {claim["kind"] for claim, _ in CLAIMS} == set(KINDS)
    assert all(fields_in_the_guide()[claim["kind"]] - {"on"} <= set(claim) for claim, _ in CLAIMS)
    own = claims_of(paper(own_paper(tmp_path, *[claim for claim, _ in CLAIMS])))
    for claim, (_, verdict) in zip(own, CLAIMS, strict=True):
        found = decide(claim)
        assert verdict in (None, found.verdict), (claim.kind, str(found.witness))
        assert (found.verdict == Verdict.NOT_ASKED) == (claim.kind == "not asked")


@pytest.mark.parametrize("place", [{"place": "eq. (3)"}, {"words": "so it is"}, {"place": "eq. (3)", "words": "so"}])
def test_a_place_alone_and_an_error_without_a_name(place, tmp_path):
    """Before: "a printed claim belongs to an error exactly if it is refuted"."""
    false = {"kind": "identity", "left": "turning", "right": "turning_by_normal", "factor": "2", "expected": "REFUTED"}
    folder = own_paper(tmp_path, false | place, false | place | {"expected": "PROVED", "factor": "1"})
    done = invoke("prove", "--paper", folder)
    assert done.exit_code == 0
    listed = invoke("errata", "--paper", folder).output
    assert "1 error of the paper" in listed
    assert "said" in listed
    assert "1. said" in listed


def test_assumptions_of_the_guide_on_the_template(tmp_path):
    """Before: "speed_squared ≠ 0", which the guide writes, was refused on the template: it is a quotient."""
    base = {"kind": "zero set", "formulas": ["speed_squared", "bent"]}
    stated = ["speed_squared ≠ 0", "turning ≢ 0", "curvature_squared ≠ 0", *ASSUMPTIONS]
    in_guide = re.findall(r'`"([^"`]*(?:≠|≢) 0)"`', page())
    assert set(in_guide) - {"delta ≠ 0"} <= set(stated)
    folder = own_paper(tmp_path, *[base | {"assumes": [each]} for each in stated[:3]])
    assert not any(claim.kind == "not asked" for claim in claims_of(paper(folder)))


def test_an_assumption_about_a_quotient_says_no_more_than_it_says(tmp_path):
    """That κ² ≠ 0 excludes zeros of [γ′ γ″], of ‖γ′‖² and of w; that ‖γ′‖² ≠ 0 excludes none of [γ′ γ″]."""
    both = {"kind": "zero set", "formulas": ["turning", "speed_squared"]}
    nothing = {"kind": "zero set", "formulas": ["turning", "velocity"]}
    own = claims_of(
        paper(
            own_paper(
                tmp_path,
                both | {"assumes": ["curvature_squared ≠ 0"]},
                both | {"assumes": ["speed_squared ≠ 0"]},
                nothing | {"assumes": ["turning ≢ 0"]},
            )
        )
    )
    assert [decide(claim).verdict for claim in own] == [Verdict.PROVED, Verdict.REFUTED, Verdict.REFUTED]
    curve = own[0].curve_named("straight_line")
    assert own[0].check(curve).verdict == Verdict.INAPPLICABLE


def test_the_kinds_of_claims_on_framed_arguments_are_those_of_the_guide():
    [listed] = re.findall(
        r"Claims on `framed` arguments are of the kinds (.*?):", DOCS.read_text(encoding="utf-8"), re.DOTALL
    )
    assert set(re.findall(r"`([^`]+)`", listed)) == {name for name, kind in KINDS.items() if kind.of_frames}
