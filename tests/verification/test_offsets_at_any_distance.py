"""Offsets at a distance δ that is a constant: curves with the root ‖γ′‖ adjoined, and Pythagorean-hodograph curves.

What is true of them is proved; wrong signs, factors and types, and δ taken for a function, are refuted.
"""

import pickle

import pytest

from exactspline import Verdict, example, paper
from exactspline.errors import FormulaError
from exactspline.extras.coq.formulas import type_of
from exactspline.language.kinds import FRAMED, HODOGRAPH, common_kind, kind_of
from exactspline.verification.claims import claims_of
from tests.support.claims import refusal
from tests.verification.test_own_paper import written

#: The kinds, and the speed on each.
SPEEDS = {"framed plane with delta": "sigma", "hodograph with delta": "speed"}
FORMULAS = {
    "place": "c.gamma",
    "normal": "perp(c.gamma.d(1)) / c.{speed}",
    "kappa": "det(c.gamma.d(1), c.gamma.d(2)) / c.{speed}**3",
    "shrunk": "1 - c.delta * kappa(c)",
    "offset": "c.gamma + normal(c) * c.delta",
    "velocity": "offset(c).d(1)",
    "kappa_delta": "det(velocity(c), velocity(c).d(1)) / (c.{speed} * shrunk(c)) ** 3",
    "radius": "1 / kappa_delta(c)",
    "centre": "offset(c) + normal(c) / kappa_delta(c)",
    "distance_squared": "norm2(offset(c) - c.gamma)",
    "speed_squared": "norm2(velocity(c))",
    "delta_derivative": "(c.delta * c.gamma).d(1)",
    "along": "dot(velocity(c), normal(c))",
}
#: For each formula what it is, and what a careless version takes it for.
RIGHT = {
    "velocity": "c.gamma.d(1) * shrunk(c)",
    "kappa_delta": "kappa(c) / (1 - c.delta * kappa(c))",
    "radius": "1 / kappa(c) - c.delta",
    "centre": "c.gamma + normal(c) / kappa(c)",
    "distance_squared": "c.delta**2",
    "speed_squared": "c.{speed}**2 * shrunk(c) ** 2",
    "delta_derivative": "c.delta * c.gamma.d(1)",
}
WRONG = {
    "velocity": (
        "c.gamma.d(1) * (1 + c.delta * kappa(c))",
        "c.gamma.d(1) * (1 - kappa(c))",
        "c.gamma.d(1) * (c.delta * kappa(c) - 1)",
        "c.gamma.d(1) * (1 - c.delta * kappa(c) * c.{speed})",
        "perp(c.gamma.d(1)) * shrunk(c)",
        "c.gamma.d(1)",
    ),
    "kappa_delta": (
        "kappa(c) / (1 + c.delta * kappa(c))",
        "kappa(c) / (c.delta * kappa(c) - 1)",
        "kappa(c) / (1 - c.delta)",
        "kappa(c) / (1 - c.delta * kappa(c)) ** 2",
        "kappa(c) * (1 - c.delta * kappa(c))",
        "kappa(c)",
        "kappa(c) / (1 - kappa(c))",
    ),
    "radius": ("1 / kappa(c) + c.delta", "1 / kappa(c)", "c.delta - 1 / kappa(c)", "1 / kappa(c) - 1"),
    "centre": (
        "c.gamma - normal(c) / kappa(c)",
        "c.gamma + normal(c) * (1 / kappa(c) + c.delta)",
        "offset(c) + normal(c) / kappa(c)",
    ),
    "distance_squared": ("c.delta", "c.delta**3", "-(c.delta**2)", "c.delta**2 * c.{speed}**2", "1 + 0 * c.delta"),
    "speed_squared": (
        "c.{speed}**2 * (1 + c.delta * kappa(c)) ** 2",
        "c.{speed}**2 * shrunk(c)",
        "shrunk(c) ** 2",
        "c.{speed}**2",
    ),
    "delta_derivative": ("c.gamma.d(1)", "c.delta * c.gamma.d(1) + c.gamma", "c.gamma + 0 * c.delta * c.gamma.d(1)"),
}
TYPES = {
    ("framed plane with delta", "offset"): "not rational",
    ("framed plane with delta", "kappa_delta"): "not rational",
    ("framed plane with delta", "distance_squared"): "polynomial",
    ("framed plane with delta", "speed_squared"): "not rational",
    ("hodograph with delta", "offset"): "rational",
    ("hodograph with delta", "kappa_delta"): "rational",
    ("hodograph with delta", "distance_squared"): "polynomial",
    ("hodograph with delta", "place"): "polynomial",
}
HEAD = "[common]\nstatus = 'ours'\nplace = 'e'\nstatement = 's'\n"


def paper_of(folder, kind, claims, **more):
    """A paper with these formulas of a kind, and its claims."""
    text = "".join(
        f"@formula('e', on='{kind}')\ndef {name}(c):\n    return {body.format(speed=SPEEDS[kind])}\n"
        for name, body in (FORMULAS | more).items()
    )
    entries = [{"curve": kind, "id": str(i)} | each for i, each in enumerate(claims)]
    return claims_of(paper(written(folder, text, entries, HEAD)))


@pytest.mark.parametrize("kind", SPEEDS)
def test_what_is_true_of_offsets_is_proved(kind, tmp_path):
    claims = [{"kind": "identity", "left": name, "right": f"right_{name}"} for name in RIGHT]
    claims.append({"kind": "vanishing", "left": "along"})
    right = {f"right_{name}": body for name, body in RIGHT.items()}
    assert [each.prove()[1].verdict for each in paper_of(tmp_path / "o", kind, claims, **right)] == [Verdict.PROVED] * 8


@pytest.mark.parametrize("kind", SPEEDS)
def test_no_careless_version_is_proved(kind, tmp_path):
    """32 of each kind: wrong signs of δ, wrong powers, δ taken for 1 and for a function of the parameter."""
    pairs = [(name, body) for name, bodies in WRONG.items() for body in bodies]
    wrong = {f"wrong_{i}": body for i, (_, body) in enumerate(pairs)}
    claims = [{"kind": "identity", "left": name, "right": f"wrong_{i}"} for i, (name, _) in enumerate(pairs)]
    found = [each.prove()[1].verdict for each in paper_of(tmp_path / "o", kind, claims, **wrong)]
    assert len(found) == 32
    assert set(found) == {Verdict.REFUTED}


def test_offsets_are_rational_for_pythagorean_hodographs_only(tmp_path):
    for kind, speed in SPEEDS.items():
        own = {name: right for (each, name), right in TYPES.items() if each == kind}
        known = ("polynomial", "rational", "not rational")
        claims = [{"kind": "type", "formula": name, "claimed": claimed} for name in own for claimed in known]
        found = [each.prove()[1].verdict for each in paper_of(tmp_path / speed, kind, claims)]
        assert found == [
            Verdict.PROVED if claimed == right else Verdict.REFUTED for right in own.values() for claimed in known
        ]


def test_the_witness_of_a_hodograph_is_one(tmp_path):
    """``‖γ′‖²/σ² is a polynomial`` was proved and, with u, v and h that had nothing to do with the curve, refuted."""
    more = {"unit": "norm2(c.gamma.d(1)) / c.speed**2 + 0 * c.delta"}
    (claim,) = paper_of(
        tmp_path / "o", "hodograph with delta", [{"kind": "type", "formula": "unit", "claimed": "polynomial"}], **more
    )
    assert claim.prove()[1].verdict == Verdict.PROVED
    for name in ("circle", "rational_cubic", "six_segment_cubic"):
        assert claim.check(example(name)).verdict == Verdict.VERIFIED
    assert claim.check(example("straight_line")).verdict in (Verdict.VERIFIED, Verdict.INAPPLICABLE, Verdict.VACUOUS)


def test_true_of_one_distance_is_not_true_of_all(tmp_path):
    """With the distance that a check tries, 37/29, the square of the distance is that number."""
    more = {"tried": "c.delta * 37 / 29", "right": RIGHT["kappa_delta"]}
    claims = [
        {"kind": "identity", "left": "distance_squared", "right": "tried"},
        {"kind": "identity", "left": "kappa_delta", "right": "right"},
    ]
    wrong, right = paper_of(tmp_path / "o", "hodograph with delta", claims, **more)
    assert wrong.prove()[1].verdict == Verdict.REFUTED
    for name in ("circle", "six_segment_cubic"):
        assert wrong.check(example(name)).verdict == Verdict.REFUTED
        assert right.check(example(name)).verdict == Verdict.VERIFIED


def test_kinds_with_constants():
    kind = kind_of("framed plane with delta")
    assert pickle.loads(pickle.dumps(kind)) is kind is kind_of(kind.name)
    assert kind.without_roots is kind_of("plane with delta")
    assert common_kind([kind_of("plane with delta"), FRAMED]).name == "framed plane with delta"
    assert common_kind([kind_of("plane with delta"), kind_of("framed plane with r")]).name == (
        "framed plane with delta, r"
    )
    assert common_kind([kind_of("plane with delta"), kind_of("plane with r")]) is kind_of("plane with r, delta")
    assert common_kind([kind_of("plane with delta"), HODOGRAPH]) is kind_of("hodograph with delta")
    assert kind_of("hodograph with delta").takes(HODOGRAPH, 2)
    assert not HODOGRAPH.takes(kind_of("hodograph with delta"), 2)
    assert not HODOGRAPH.takes(kind_of("plane with delta"), 2)
    assert not kind_of("hodograph with delta").takes(kind_of("framed plane with delta"), 2)


def test_no_theorem_for_coq_takes_a_constant_for_another_operand():
    for name in SPEEDS:
        with pytest.raises(FormulaError, match="no type in Coq"):
            type_of(kind_of(name))


#: Degrees of a Pythagorean-hodograph curve of degree n = 2d + e + 1: formula, degree, relation, for which curves.
DEGREES = [
    ("place", "n", "=", "both"),
    ("place", "2d + e + 1", "=", "both"),
    ("place", "2d + 1", "=", "polynomial"),
    ("tangent", "n - 1", "=", "both"),
    ("offset", "2n - 1", "=", "both"),
    ("offset", "4d + 2e + 1", "=", "both"),
    ("offset", "4d + 1", "=", "polynomial"),
    ("offset", "n + 2d + e", "=", "both"),
    ("offset", "2n", "≤", "both"),
    ("offset", "2n - 2", "≥", "both"),
    ("kappa", "3n - 3", "=", "both"),
]
WRONG_DEGREES = [
    *[("offset", n, "=", "both") for n in ("2n", "2n - 2", "2n + 1", "3n - 1", "n", "n - 1", "2n - d", "2n - e")],
    *[("offset", n, "=", "both") for n in ("4d + 1", "4d + e + 1", "4d + 2e", "4d + 2e + 2", "2d + e + 1", "4d - 1")],
    *[("offset", n, "=", "polynomial") for n in ("2n", "2n - 2", "4d", "4d + 2", "4d + 2e", "n")],
    ("offset", "2n - 2", "≤", "both"),
    ("offset", "2n", "≥", "both"),
    ("place", "n - 1", "=", "both"),
    ("place", "2d + 1", "=", "both"),
    ("place", "d", "=", "both"),
    ("tangent", "n", "=", "both"),
    ("kappa", "3n - 4", "=", "both"),
    ("kappa", "2n - 3", "=", "both"),
]


def degrees_of(folder, rows):
    """Claims of nominal degrees of curves given by their hodographs."""
    names = ("formula", "claimed", "relation", "of")
    claims = [{"kind": "degree"} | dict(zip(names, row, strict=True)) for row in rows]
    return paper_of(folder, "hodograph with delta", claims, tangent="c.gamma.d(1)")


def test_degrees_of_pythagorean_hodograph_curves(tmp_path):
    """The offset of a curve of degree n is a rational curve of degree 2n − 1 (Farouki, Sakkalis 1990)."""
    for claim in degrees_of(tmp_path / "o", DEGREES):
        assert claim.prove()[1].verdict == Verdict.PROVED, claim
        for name in ("circle", "rational_cubic", "six_segment_cubic"):
            curve = example(name)
            if claim.applies_to(2, curve.polynomial):
                assert claim.check(curve).verdict == Verdict.VERIFIED, (claim, name)


def test_wrong_degrees_are_refuted_at_degrees_that_exist(tmp_path):
    """The degree of h was counted as another one, ``4d + 2de``; where h = 1, it has no degree at which to fail."""
    for claim in degrees_of(tmp_path / "o", WRONG_DEGREES):
        found = claim.prove()[1]
        assert found.verdict == Verdict.REFUTED, claim
        names = {str(name) for name, _ in found.witness.at}
        assert names <= ({"d"} if claim.of == "polynomial" else {"d", "e"})
        assert all(n >= 1 for _, n in found.witness.at)


def test_a_curve_without_a_hodograph_has_no_degree_n(tmp_path):
    text = "@formula('e', on='plane with delta')\ndef place(c):\n    return c.gamma\n"
    entry = {"kind": "degree", "formula": "place", "claimed": "n", "curve": "plane with delta", "id": "1"}
    assert "contains 'n'" in refusal(written(tmp_path / "o", text, [entry], HEAD))


def test_zeros_and_factors_beside_a_frame(tmp_path):
    """The constant is a factor by a formula that returns it; that it is not zero is assumed as the answer says."""
    text = """
@formula('e', on='framed plane with delta')
def step(c):
    return perp(c.gamma.d(1)) * (c.delta / c.sigma)
@formula('e', on='framed plane')
def normal(c):
    return perp(c.gamma.d(1)) / c.sigma
@formula('e', on='framed plane with delta')
def scaled(c):
    return det(c.gamma.d(1), c.gamma.d(2)) * (c.delta / c.sigma)
@formula('e', on='plane with delta')
def distance(c):
    return c.delta
"""
    own = {"curve": "framed plane with delta"}
    zeros = own | {"kind": "zero set", "formulas": ["step", "normal"]}
    times = own | {"kind": "identity", "left": "step", "right": "normal"}
    claims = [
        zeros | {"assumes": ["w", "delta ≠ 0"]},
        zeros | {"assumes": ["w"]},
        zeros | {"formulas": ["scaled", "normal"], "assumes": ["w", "delta ≠ 0"]},
        times | {"factor": "distance"},
        times | {"factor": "distance^2"},
        times | {"factor": "-1 distance"},
    ]
    entries = [each | {"id": str(i)} for i, each in enumerate(claims)]
    found = [each.prove()[1] for each in claims_of(paper(written(tmp_path / "o", text, entries, HEAD)))]
    assert [each.verdict for each in found] == [
        Verdict.PROVED,
        Verdict.UNDECIDED,
        Verdict.REFUTED,
        Verdict.PROVED,
        Verdict.REFUTED,
        Verdict.REFUTED,
    ]
    assert str(found[1].witness) == "δ may have zeros: assume delta ≠ 0"
    assert str(found[2].witness).endswith("with δ = 37/29")
