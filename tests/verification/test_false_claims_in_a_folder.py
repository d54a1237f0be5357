"""False claims of every kind, made from true ones and written into the folder of a paper: none is ever proved."""

from dataclasses import fields
from enum import StrEnum

from exactspline.interchange.examples import example
from exactspline.papers import load_paper
from exactspline.verification.claims import claims_of
from exactspline.verification.evaluation import Evaluation
from exactspline.verification.ledger import proved
from exactspline.verification.verdict import PROVED, VERIFIED
from tests.verification.test_false_claims import MAKERS, false_claims, is_true_after_all
from tests.verification.test_own_paper import written

OWN = """
@formula("e", on="plane")
def turning(c):
    return det(c.gamma.d(1), c.gamma.d(2))


@formula("e", on="plane")
def velocity(c):
    return c.gamma.d(1)


@formula("e", on="plane")
def speed_squared(c):
    return norm2(velocity(c))


@formula("e", on="plane")
def curvature_squared(c):
    return turning(c) ** 2 / speed_squared(c) ** 3


@formula("e", on="plane pair")
def circle(c):
    first = c.first.gamma
    way = c.second.gamma - first
    return norm2(way) * det(first.d(1), first.d(2)) - 2 * norm2(first.d(1)) * det(first.d(1), way)


@formula("e", on="plane pair")
def tangent(c):
    return det(c.first.gamma.d(1), c.second.gamma - c.first.gamma)


@formula("e", on="hodograph")
def length(c):
    return norm2(c.gamma.d(1))


@formula("e", on="hodograph")
def speed(c):
    return c.speed * c.speed


@formula("e", on="implicit")
def bending(c):
    return det(c.gamma.d(1), c.gamma.d(2))


@formula("e", on="implicit")
def in_derivatives(c):
    t = perp(c.gradient_f)
    return c.pace**3 * (t[0] * dot(c.hessian_fx, t) + t[1] * dot(c.hessian_fy, t))


@formula("e", on="plane with delta")
def scaled(c):
    return norm2(c.gamma.d(1) * c.delta)


@formula("e", on="plane with delta")
def twice(c):
    return c.delta * c.delta * speed_squared(c)
"""
WEIGHTS = [
    *[
        ("turning", u, w)
        for u, w in (("reparametrization", 3), ("affine map", 1), ("similarity", 2), ("reflection", 1))
    ],
    *[("curvature_squared", u, w) for u, w in (("reparametrization", 0), ("similarity", -2), ("scaling", -2))],
    *[("speed_squared", u, w) for u, w in (("reparametrization", 2), ("Möbius map", 2), ("scaling", 2))],
]
SIDES = [
    ("length", "speed", "hodograph"),
    ("bending", "in_derivatives", "implicit"),
    ("scaled", "twice", "plane with delta"),
]


def of_own_kinds():
    """True claims of the kinds that authors make, each with what is made of it and false."""
    for name, under, weight in WEIGHTS:
        claim = {"kind": "invariance", "formula": name, "under": under, "weight": weight}
        yield claim, [claim | {"weight": weight + k} for k in (1, -1, 3)]
    for name, order in (("circle", 2), ("tangent", 1)):
        claim = {"kind": "contact", "curve": "plane pair", "formula": name, "order": order}
        wrong = [claim | {"order": n} for n in range(5) if n != order]
        yield claim, [*wrong, *[claim | {"order": order + k, "relation": "≥"} for k in (1, 2)]]
    claim = {"kind": "sign", "formula": "speed_squared", "squares": ["velocity"]}
    wrong = [{"sign": "≤ 0"}, {"sign": "< 0"}, {"sign": "> 0"}, {"squares": ["turning"]}, {"factor": "2"}]
    yield (
        claim,
        [*[claim | each for each in wrong], claim | {"formula": "turning"}, claim | {"squares": ["velocity"] * 2}],
    )
    strict = claim | {"sign": "> 0", "assumes": ["γ′"]}
    yield strict, [strict | {"assumes": []}, strict | {"assumes": ["w"]}, strict | {"assumes": ["γ′ ≢ 0"]}]
    for left, right, curve in SIDES:
        claim = {"kind": "identity", "left": left, "right": right, "curve": curve}
        yield claim, [claim | {"factor": factor} for factor in ("2", "-1", "1/3")]
        yield claim, [{"kind": "vanishing", "left": name, "curve": curve} for name in (left, right)]


def as_entry(claim):
    """A claim as it stands in a file."""
    left_out = {"paper", "id", "key", "error", "words", "place", "status", "expected", "source", "witness", "vacuous"}
    values = {f.name: getattr(claim, f.name) for f in fields(claim) if f.name not in left_out}
    told = {name: str(v) if isinstance(v, StrEnum) else v for name, v in values.items() if v not in ((), "")}
    return told | {"kind": claim.kind}


def test_the_claims_from_which_false_ones_are_made_hold(tmp_path):
    claims = [{"id": f"T{i}", "statement": "true", "curve": "plane"} | c for i, (c, _) in enumerate(of_own_kinds())]
    for claim in claims_of(load_paper(written(tmp_path / "true", OWN, claims))):
        assert proved(claim).verdict == PROVED, claim


def test_false_claims_of_every_kind_in_a_folder_are_never_proved(tmp_path):
    own = [{"curve": "plane"} | each for _, wrong in of_own_kinds() for each in wrong]
    others = []
    for kind in MAKERS:
        made = [f for claim, f, _ in false_claims(kind) if not is_true_after_all(claim, f) and cheap(f)]
        others += [as_entry(f) for f in made[:: max(1, len(made) // 25)]]
    head = 'uses = ["chen_riesenfeld_cohen_2007", "lifted"]\n'
    entries = [
        [{"id": f"F{i}", "statement": "false"} | each for i, each in enumerate(false)] for false in (own, others)
    ]
    claims = claims_of(load_paper(written(tmp_path / "own", OWN, entries[0])))
    claims += claims_of(load_paper(written(tmp_path / "others", "", entries[1], head)))
    assert len(claims) == len(own) + len(others) >= 200
    assert {claim.kind for claim in claims} >= {*MAKERS, "invariance", "contact", "sign"}
    fooled = [claim for claim in claims if proved(claim).verdict in (PROVED, VERIFIED)]
    assert fooled == []
    curve = Evaluation(example("rational_cubic_s"))
    everywhere = [c for c in claims[: len(own)] if c.kind != "sign" and c.speaks_of(2, False)]
    assert len(everywhere) > 40
    assert [claim for claim in everywhere if claim.check(curve).verdict == VERIFIED] == []


def cheap(claim):
    """Whether it takes less than a second to decide."""
    return "by_parameter" not in str(claim.named) and claim.curve != "pair"
