"""False claims about surfaces, planar maps, curves on surfaces and pairs of forms: none is ever PROVED or VERIFIED."""

from dataclasses import replace

import pytest

from exactspline import Verdict, decide, paper
from exactspline.papers import Table
from exactspline.readings import parse_degree
from exactspline.readings.degree import Degree
from exactspline.verification.claims import claim_of, claims_of
from tests.support.sampled import sample
from tests.verification.test_own_paper import written

TRUE = claims_of("surfaces")
#: One coefficient for another.
LETTERS = {"_uu": "_vv", "_uv": "_uu", "_vv": "_uv", "L": "N", "M": "L", "N": "M", "E": "G", "F": "E", "G": "F"}
NAMES = {name for claim in TRUE for name in claim.named}


def exchanged(name):
    """The name of a formula with one letter exchanged for another, where there is such a formula."""
    for old, new in LETTERS.items():
        if old in name and (changed := name.replace(old, new, 1)) in NAMES and changed != name:
            return changed
    return None


def of_identity(claim):
    """A sign, a power of w (not where w = 1), one coefficient for another."""
    yield replace(claim, factor=f"-1 {claim.factor}")
    if claim.of != "polynomial" and claim.curve != "forms":
        yield replace(claim, factor=f"w {claim.factor}")
    for side in ("left", "right"):
        if other := exchanged(getattr(claim, side)):
            yield replace(claim, **{side: other})


def of_degree(claim):
    """One more as a lower bound; the degree in one parameter told in terms of the other one."""
    yield replace(claim, claimed=str(parse_degree(claim.claimed) * Degree.number(1)), relation="≥")
    if (letter := {"u": "v", "v": "u"}.get(claim.parameter.value)) is None:
        return
    turned = claim.claimed.replace(f"d_{claim.parameter.value}", f"d_{letter}")
    yield replace(claim, claimed=turned)


@pytest.mark.parametrize("kind", ["identity", "degree"])
def test_no_changed_claim_of_the_paper_is_proved(kind):
    makers = {"identity": of_identity, "degree": of_degree}
    false = [each for claim in TRUE if claim.kind == kind for each in makers[kind](claim)]
    assert len(false) > 100
    fooled = [each for each in sample(false, 70) if decide(each).verdict in (Verdict.PROVED, Verdict.VERIFIED)]
    assert fooled == []


def stated(kind, curve, **more):
    return {"kind": kind, "curve": curve} | more


def identity(curve, left, right, **more):
    return stated("identity", curve, left=left, right=right, **more)


def zero_set(curve, *formulas, **more):
    return stated("zero set", curve, formulas=list(formulas), **more)


ON_SURFACE = "curve on a surface"
#: Statements by what they ask for, each false for a reason of its own.
FALSE = {
    "a planar map has no area for nothing": stated("vanishing", "planar map", left="jacobian"),
    "the other orientation": identity("planar map", "jacobian", "jacobian_lifted", factor="-1 w^-3"),
    "not all of a curve's curvature is normal": identity(
        ON_SURFACE, "space_curvature_squared", "normal_curvature_squared", of="polynomial"
    ),
    "nor geodesic": identity(ON_SURFACE, "space_curvature_squared", "geodesic_curvature_squared", of="polynomial"),
    "the speed is not that of u alone": identity(ON_SURFACE, "E", "first_form"),
    "not every curve is a line of curvature": stated("vanishing", ON_SURFACE, left="line_form"),
    "nor a geodesic": stated("vanishing", ON_SURFACE, left="geodesic_determinant"),
    "a speed and an element of area": zero_set(ON_SURFACE, "speed_squared", "first_form", "area_squared"),
    "parabolic points and those where H = 0": zero_set("surface", "parabolic", "minimality", assumes=["w"]),
    "K is not there where the normal vanishes": zero_set("surface", "gaussian_curvature", "parabolic", assumes=["w"]),
    "w may vanish": zero_set("surface", "parabolic", "parabolic_lifted"),
    "the normal may vanish": stated(
        "sign", "surface", assumes=["w"], formula="area_squared", sign="> 0", squares=["normal"]
    ),
    "K has any sign": stated("sign", "surface", assumes=["w"], formula="parabolic", sign="≥ 0", squares=["L", "N"]),
    "a discriminant of forms that need not be definite": stated(
        "sign", "forms", formula="umbilicity_of_forms", sign="≥ 0", squares=["line_uv_of_forms", "line_uu_of_forms"]
    ),
    "areas are not squares of lengths": stated(
        "square class", "surface", assumes=["w"], formula="area_squared", right="E"
    ),
    "one power too many": identity(
        "forms", "ridges_by_definition", "ridges_of_forms", factor="64 line_uu_of_forms area_of_forms^3"
    ),
}


@pytest.mark.parametrize("what", FALSE)
def test_false_statements_of_every_kind(what):
    entry = {"id": "F", "key": f"F-{FALSE[what]['kind'].replace(' ', '-')}", "statement": what, **FALSE[what]}
    assert decide(claim_of(Table("here", entry), paper("surfaces"))).verdict not in (Verdict.PROVED, Verdict.VERIFIED)


def test_formulas_of_curves_and_of_surfaces_in_one_claim_of_a_folder(tmp_path):
    """Neither side alone says that the claim speaks of a curve on a surface."""
    formulas = """
@formula("e", on="surface")
def speed_along_u(c):
    return norm2(c.S.d(1, by="u"))


@formula("e", on="space")
def speed(c):
    return norm2(c.gamma.d(1))
"""
    told = {"kind": "identity", "statement": "s", "curve": "curve on a surface"}
    claims = [
        {"id": "1", "left": "speed_along_u", "right": "speed", **told},
        {"id": "2", "left": "speed", "right": "speed_along_u", **told},
    ]
    rows = [decide(claim) for claim in claims_of(paper(written(tmp_path / "mixed", formulas, claims)))]
    assert [row.verdict for row in rows] == [Verdict.REFUTED, Verdict.REFUTED]
