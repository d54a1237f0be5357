"""Invariance of formulas with the roots of a frame under isometries and reversal: signed curvature, frames, torsion."""

import pytest

from exactspline import Verdict, example, paper
from exactspline.verification.claims import claims_of
from exactspline.verification.ledger import audit
from tests.support.claims import one_verdict
from tests.verification.test_own_paper import written

V, A, J = "c.gamma.d(1)", "c.gamma.d(2)", "c.gamma.d(3)"
BODIES = {
    "framed plane": {
        "κ": f"det({V}, {A}) / c.sigma**3",
        "T": f"{V} / c.sigma",
        "N": f"perp({V}) / c.sigma",
        "centre": f"c.gamma + perp({V}) / c.sigma * (c.sigma**3 / det({V}, {A}))",
        "κ′": f"(det({V}, {A}) / c.sigma**3).d(1)",
        "placed": "c.sigma + c.gamma[0]",
        "weighted": f"c.w * det({V}, {A}) / c.sigma**3",
    },
    "framed space": {
        "κ": "c.rho / c.sigma**3",
        "B": f"cross({V}, {A}) / c.rho",
        "τ": f"triple({V}, {A}, {J}) / c.rho**2",
    },
    "framed plane with delta": {"offset": f"c.gamma + c.delta * perp({V}) / c.sigma"},
    "plane": {"turning": f"det({V}, {A})", "squared": f"norm2({V})"},
}
PLANE, SPACE, OFFSET, PLAIN = BODIES
#: With the weight, and the nature of the value; the unit of a reversal and of a reflection is −1.
HOLDS = [
    (PLANE, "κ", "motion", 0, "scalar"),
    (PLANE, "κ", "translation", 0, "scalar"),
    (PLANE, "κ", "rotation", 0, "scalar"),
    (PLANE, "κ", "reflection", 1, "scalar"),
    (PLANE, "κ", "reversal", 1, "scalar"),
    (PLANE, "κ", "reversal", -1, "scalar"),
    (PLANE, "weighted", "motion", 0, "scalar"),
    (PLANE, "T", "motion", 0, "vector"),
    (PLANE, "T", "reflection", 0, "vector"),
    (PLANE, "T", "reversal", 1, "scalar"),
    (PLANE, "N", "reflection", 1, "vector"),
    (PLANE, "centre", "motion", 0, "point"),
    (PLANE, "centre", "reflection", 0, "point"),
    (PLANE, "centre", "reversal", 0, "scalar"),
    (PLANE, "κ′", "reversal", 0, "scalar"),
    (PLANE, "κ′", "reflection", 1, "scalar"),
    (PLANE, "placed", "reversal", 0, "scalar"),
    (SPACE, "κ", "reversal", 0, "scalar"),
    (SPACE, "κ", "reflection", 0, "scalar"),
    (SPACE, "B", "reflection", 1, "vector"),
    (SPACE, "τ", "motion", 0, "scalar"),
    (SPACE, "τ", "reflection", 1, "scalar"),
    (SPACE, "τ", "reversal", 0, "scalar"),
    (PLAIN, "turning", "reversal", 1, "scalar"),
    (PLAIN, "squared", "reversal", 0, "scalar"),
]
FAILS = [
    (PLANE, "placed", "motion", 0, "scalar"),
    (PLANE, "centre", "motion", 0, "vector"),
    (PLANE, "N", "motion", 0, "scalar"),
    (OFFSET, "offset", "reversal", 0, "scalar"),
    *[(kind, name, under, weight + 1, nature) for kind, name, under, weight, nature in HOLDS if under[:3] == "ref"],
    *[(kind, name, under, weight + 1, nature) for kind, name, under, weight, nature in HOLDS if under == "reversal"],
]
REFUSED = [
    (PLANE, "κ", "scaling", -1, "scalar"),
    (PLANE, "κ", "reparametrization", 0, "scalar"),
    (PLANE, "κ", "affine map", 0, "scalar"),
    (PLANE, "κ", "Möbius map", 0, "scalar"),
    (PLANE, "T", "reversal", 1, "vector"),
    (OFFSET, "offset", "motion", 0, "point"),
]


def claims(folder, table):
    text = "".join(
        f"@formula('e', on='{kind}')\ndef f{i}_{j}(c):\n    return {body}\n"
        for i, (kind, bodies) in enumerate(BODIES.items())
        for j, body in enumerate(bodies.values())
    )
    head = "from exactspline.language import triple\n"
    told = [
        {"id": f"{k}", "kind": "invariance", "statement": "s", "curve": kind, "under": under, "nature": nature}
        | {"formula": f"f{[*BODIES].index(kind)}_{[*BODIES[kind]].index(name)}", "weight": weight}
        for k, (kind, name, under, weight, nature) in enumerate(table)
    ]
    return claims_of(paper(written(folder, head + text, told)))


def test_what_holds_beside_a_frame_is_proved(tmp_path):
    for line, claim in zip(HOLDS, claims(tmp_path / "p", HOLDS), strict=True):
        assert one_verdict(claim).verdict == Verdict.PROVED, line


def test_what_fails_beside_a_frame_is_refuted(tmp_path):
    """With ‖γ′‖ taken for a number that changes its sign, κ would be the same in both directions."""
    for line, claim in zip(FAILS, claims(tmp_path / "p", FAILS), strict=True):
        assert one_verdict(claim).verdict == Verdict.REFUTED, line


def test_what_is_not_decided_says_why(tmp_path):
    for line, claim in zip(REFUSED, claims(tmp_path / "p", REFUSED), strict=True):
        assert one_verdict(claim).verdict == Verdict.NOT_ASKED, line
        assert claim.why


@pytest.mark.parametrize("name", ["circle", "cubic_s", "rational_cubic", "six_segment_cubic"])
def test_reversal_on_one_curve(tmp_path, name):
    plain = [each for each in HOLDS if each[0] == PLAIN] + [each for each in FAILS if each[0] == PLAIN]
    rows = list(audit(claims(tmp_path / "p", plain), [example(name)]))
    assert [row.verdict for row in rows] == [Verdict.VERIFIED, Verdict.VERIFIED, Verdict.REFUTED, Verdict.REFUTED]
