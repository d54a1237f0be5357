"""Claims about one curve, as in numerical examples: what is true is VERIFIED, and what a careless check would pass is
not.
"""

import json

import pytest

import exactspline
from exactspline import Nurbs, Verdict, decide, example, paper
from exactspline.verification.claims import claims_of
from exactspline.verification.judges import Sympy
from exactspline.verification.ledger import audit
from tests.campaigns import one_curve
from tests.support.claims import refusal
from tests.support.command import invoke
from tests.verification.test_own_paper import plane_formulas, written

#: κ < 0 all along it; x and y both vanish at 0.
ARCH = Nurbs(3, [0, 0, 0, 0, 1, 1, 1, 1], [(0, 0), ("0.3", "0.8"), ("0.9", "1.1"), ("1.5", "0.2")])
#: A corner at 1: the tangent jumps from (1, 0) to (0, 1).
CORNER = Nurbs(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (1, 1)])
#: (t, t²) for −1 ≤ t ≤ 1: y/x = t, though 0/0 at 0.
PARABOLA = Nurbs(2, [-1, -1, -1, 1, 1, 1], [(-1, 1), (0, -1), (1, 1)])
#: y = t on [−1, 0] and 1 on [0, 1].
JUMP = Nurbs(1, [-1, -1, 0, 0, 1, 1], [(-1, -1), (0, 0), (0, 1), (1, 1)])
#: (t, t²) on [0, 1], and straight back: y′ is 0 at the seam from the right alone.
CLOSED = Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 2], [(0, 0), ("1/2", 0), (1, 1), ("1/2", "1/2"), (0, 0)])
#: There and back on (t, t²): y and y′ are 0 at the seam from both sides.
THERE_AND_BACK = Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 2], [(0, 0), ("1/2", 0), (1, 1), ("1/2", 0), (0, 0)])
#: A control point with y < 0, and y > 0 in all Bézier points.
HIGH = Nurbs(3, [0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5], [(i, 1 if i != 3 else "-1/10") for i in range(8)])
#: No control point has y = 0; the Bézier point at the knot 1 has.
FALLING = Nurbs(2, [0, 0, 0, 1, 2, 2, 2], [(0, 1), (1, 1), (2, -1), (3, -1)])
CURVES = {
    "arch": ARCH,
    "corner": CORNER,
    "parabola_2": PARABOLA,
    "leap": JUMP,
    "closed": CLOSED,
    "there_and_back": THERE_AND_BACK,
    "high": HIGH,
    "falling": FALLING,
}
FORMULAS = plane_formulas(
    turning="det(c.gamma.d(1), c.gamma.d(2))",
    bent="det(c.p.d(1), c.p.d(2))",
    twice="2 * det(c.gamma.d(1), c.gamma.d(2))",
    curvature_squared="det(c.gamma.d(1), c.gamma.d(2))**2 / norm2(c.gamma.d(1))**3",
    point="c.gamma",
    velocity="c.gamma.d(1)",
    x="c.gamma[0]",
    px="c.p[0]",
    px_less_one="c.p[0] - c.w",
    y="c.gamma[1]",
    py="c.p[1]",
    rise="c.gamma.d(1)[1]",
    slope="c.gamma[1] / c.gamma[0]",
    pole="c.w / (c.gamma[0] - rational('1/2') * c.w)",
    one="c.w / c.w",
    less_one="c.gamma[0] - 1",
    square="(c.gamma[0] - 1) ** 2",
    ratio="c.gamma[1] ** 2 / c.gamma[0] ** 2",
)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    made = written(tmp_path_factory.mktemp("on") / "paper", FORMULAS, [])
    (made / "curves").mkdir()
    for name, curve in CURVES.items():
        exactspline.write(curve, made / "curves" / f"{name}.json")
    return made


def decided(folder, tmp_path, **fields):
    """The row of one claim about the arch, whatever its other fields."""
    claim = {"id": "1", "statement": "said", "curve": "plane", "example": "arch"} | fields
    own = tmp_path / "p"
    if not own.exists():
        own.mkdir()
        for name in ("formulas.py", "curves"):
            (own / name).symlink_to(folder / name)
    lines = [f"{name} = {json.dumps(value, ensure_ascii=False)}" for name, value in claim.items() if value is not None]
    (own / "claims.toml").write_text("\n".join(["[[claim]]", *lines]))
    (row,) = audit(claims_of(paper(own)))
    return row


HOLD = [
    {"kind": "at", "formula": "turning", "parameter": 0, "claimed": -7.02},
    {"kind": "at", "formula": "point", "parameter": 0.5, "claimed": ["51/80", 0.7375]},
    {"kind": "at", "formula": "point", "parameter": "1", "claimed": [1.5, "1/5"]},
    {"kind": "at", "formula": "x", "parameter": 1, "claimed": 1, "example": "corner"},
    {"kind": "limit", "formula": "slope", "parameter": 0, "claimed": "8/3"},
    {"kind": "limit", "formula": "turning", "parameter": 0, "claimed": "-7.02"},
    {"kind": "limit", "formula": "pole", "parameter": 0.5, "claimed": "∞", "example": "corner"},
    {"kind": "bound", "formula": "turning", "bound": "< 0"},
    {"kind": "bound", "formula": "point", "bound": "≤ 1", "interval": [0, 0.5]},
    {"kind": "bound", "formula": "point", "bound": ">= -3"},
    {"kind": "bound", "formula": "x", "bound": "≤ 1.5"},
    {"kind": "bound", "formula": "x", "bound": "< 1.5", "interval": [0, "999/1000"]},
    {"kind": "bound", "formula": "one", "bound": "≤ 1"},
    {"kind": "bound", "formula": "pole", "bound": "> 0", "interval": ["3/4", 1], "example": "corner"},
    {"kind": "count", "formula": "less_one", "claimed": "1 roots", "interval": [0.5, 1]},
    {"kind": "count", "formula": "less_one", "claimed": "0 roots", "interval": [0, 0.5]},
    {"kind": "count", "formula": "y", "claimed": "1 roots"},
    {"kind": "count", "formula": "slope", "claimed": "1 roots", "example": "parabola_2"},
    {"kind": "count", "formula": "y", "claimed": "0 roots", "interval": ["1/100", 1], "example": "leap"},
    {"kind": "count", "formula": "y", "claimed": "1 roots", "example": "there_and_back"},
    {"kind": "count", "formula": "y", "claimed": "1 roots", "interval": [0, 2], "example": "there_and_back"},
    {"kind": "count", "formula": "y", "claimed": "1 roots", "interval": [1, 2], "example": "there_and_back"},
    {"kind": "bound", "formula": "slope", "bound": "≤ 0", "interval": [-1, 0], "example": "parabola_2"},
    {"kind": "coefficients", "formula": "bent", "sign": "< 0", "on": "curve"},
    {"kind": "coefficients", "formula": "py", "sign": "> 0", "on": "curve", "example": "high"},
    {"kind": "distance", "other": "circle", "bound": "= 0"},
    {"kind": "distance", "other": "corner", "bound": "<= 0.001"},
    {"kind": "sign", "formula": "turning", "sign": "< 0", "on": "curve"},
    {"kind": "identity", "left": "twice", "right": "turning", "factor": "2", "on": "curve"},
    {"kind": "identity", "left": "bent", "right": "turning", "on": "curve"},
    {"kind": "vanishing", "left": "turning", "on": "curve", "example": "straight_line"},
    {"kind": "zero set", "formulas": ["turning", "twice"], "on": "curve"},
    {"kind": "type", "formula": "turning", "claimed": "polynomial", "on": "curve"},
    {"kind": "degree", "formula": "bent", "claimed": "2", "measure": "true", "on": "curve"},
    {"kind": "degree", "formula": "bent", "claimed": "2d - 4", "measure": "true", "on": "curve"},
]

#: What a careless check would pass, each for the reason beside it.
FAIL = {
    "another value": ({"kind": "at", "formula": "turning", "parameter": 0, "claimed": -7.0200001}, Verdict.REFUTED),
    "a decimal rounded to a double": (
        {"kind": "at", "formula": "x", "parameter": 0.1, "claimed": "0.1140000000000000013"},
        Verdict.REFUTED,
    ),
    "one component is right": ({"kind": "at", "formula": "point", "parameter": 0, "claimed": [0, 1]}, Verdict.REFUTED),
    "a number for a vector": ({"kind": "at", "formula": "point", "parameter": 0, "claimed": 0}, Verdict.REFUTED),
    "from the right alone": (
        {"kind": "at", "formula": "velocity", "parameter": 1, "claimed": [0, 1], "example": "corner"},
        Verdict.REFUTED,
    ),
    "from the left alone": (
        {"kind": "limit", "formula": "velocity", "parameter": 1, "claimed": [1, 0], "example": "corner"},
        Verdict.REFUTED,
    ),
    "0/0 is no value": ({"kind": "at", "formula": "slope", "parameter": 0, "claimed": "8/3"}, Verdict.VACUOUS),
    "a pole is no value": (
        {"kind": "at", "formula": "pole", "parameter": 0.5, "claimed": 0, "example": "corner"},
        Verdict.VACUOUS,
    ),
    "another limit": ({"kind": "limit", "formula": "slope", "parameter": 0, "claimed": "3/8"}, Verdict.REFUTED),
    "no pole": ({"kind": "limit", "formula": "slope", "parameter": 0, "claimed": "∞"}, Verdict.REFUTED),
    "outside the domain": ({"kind": "at", "formula": "x", "parameter": 2, "claimed": 0}, Verdict.UNDECIDED),
    "attained at the end": ({"kind": "bound", "formula": "x", "bound": "< 1.5"}, Verdict.REFUTED),
    "touched inside": ({"kind": "bound", "formula": "square", "bound": "> 0"}, Verdict.REFUTED),
    "holds at the ends alone": ({"kind": "bound", "formula": "y", "bound": "≤ 1/5"}, Verdict.REFUTED),
    "holds at a hundred places": ({"kind": "bound", "formula": "square", "bound": "≥ 1/100000000"}, Verdict.REFUTED),
    "a constant that is equal": ({"kind": "bound", "formula": "one", "bound": "< 1"}, Verdict.REFUTED),
    "a length and not its square": ({"kind": "bound", "formula": "point", "bound": "≤ 1.53"}, Verdict.VERIFIED),
    "a negative length": ({"kind": "bound", "formula": "point", "bound": "≤ -2"}, Verdict.REFUTED),
    "a pole inside, of both signs": (
        {"kind": "bound", "formula": "pole", "bound": "> 0", "example": "corner"},
        Verdict.REFUTED,
    ),
    "outside the interval": ({"kind": "bound", "formula": "x", "bound": "≤ 1", "interval": [0, 1]}, Verdict.REFUTED),
    "an interval outside the domain": (
        {"kind": "bound", "formula": "x", "bound": "≤ 9", "interval": [0, 2]},
        Verdict.UNDECIDED,
    ),
    "a root outside the interval": (
        {"kind": "count", "formula": "less_one", "claimed": "1 roots", "interval": [0, 0.5]},
        Verdict.REFUTED,
    ),
    "a root seen from the left alone": (
        {"kind": "count", "formula": "y", "claimed": "0 roots", "example": "leap"},
        Verdict.UNDECIDED,
    ),
    "the same in the interval before": (
        {"kind": "count", "formula": "y", "claimed": "1 roots", "interval": [-1, 0], "example": "leap"},
        Verdict.UNDECIDED,
    ),
    "the same in the interval behind": (
        {"kind": "count", "formula": "y", "claimed": "0 roots", "interval": [0, 1], "example": "leap"},
        Verdict.UNDECIDED,
    ),
    "a root on one side of the seam": (
        {"kind": "count", "formula": "rise", "claimed": "0 roots", "example": "closed"},
        Verdict.UNDECIDED,
    ),
    "the same in the whole domain": (
        {"kind": "count", "formula": "rise", "claimed": "1 roots", "interval": [0, 2], "example": "closed"},
        Verdict.UNDECIDED,
    ),
    "the same at the end": (
        {"kind": "count", "formula": "rise", "claimed": "0 roots", "interval": ["3/2", 2], "example": "closed"},
        Verdict.UNDECIDED,
    ),
    "a seam counted twice": (
        {"kind": "count", "formula": "y", "claimed": "2 roots", "interval": [0, 2], "example": "there_and_back"},
        Verdict.REFUTED,
    ),
    "0/0, whose continuation is 0": (
        {"kind": "bound", "formula": "slope", "bound": "< 0", "interval": [-1, 0], "example": "parabola_2"},
        Verdict.REFUTED,
    ),
    "a sign where the continuation is 0": (
        {"kind": "sign", "formula": "ratio", "sign": "> 0", "on": "curve", "example": "parabola_2"},
        Verdict.REFUTED,
    ),
    "a Bézier point that is no control point": (
        {"kind": "coefficients", "formula": "py", "on": "curve", "example": "falling"},
        Verdict.REFUTED,
    ),
    "a coefficient of the other sign": (
        {"kind": "coefficients", "formula": "px_less_one", "sign": "< 0", "on": "curve"},
        Verdict.REFUTED,
    ),
    "a coefficient that is 0": (
        {"kind": "coefficients", "formula": "px", "sign": "> 0", "on": "curve"},
        Verdict.REFUTED,
    ),
    "not that far": ({"kind": "distance", "other": "circle", "bound": "> 0"}, Verdict.REFUTED),
    "not a tenth": ({"kind": "distance", "other": "circle", "bound": "≥ 0.1"}, Verdict.REFUTED),
    "a distance is not negative": ({"kind": "distance", "other": "circle", "bound": "≤ -1"}, Verdict.REFUTED),
    "the other sign": ({"kind": "sign", "formula": "turning", "sign": "> 0", "on": "curve"}, Verdict.REFUTED),
    "another factor": (
        {"kind": "identity", "left": "twice", "right": "turning", "factor": "3", "on": "curve"},
        Verdict.REFUTED,
    ),
    "not zero here": ({"kind": "vanishing", "left": "turning", "on": "curve"}, Verdict.REFUTED),
    "other zeros": ({"kind": "zero set", "formulas": ["turning", "y"], "on": "curve"}, Verdict.REFUTED),
    "a polynomial here": (
        {"kind": "type", "formula": "turning", "claimed": "rational", "on": "curve"},
        Verdict.REFUTED,
    ),
    "a lower degree here": (
        {"kind": "degree", "formula": "bent", "claimed": "2d - 2", "measure": "true", "on": "curve"},
        Verdict.REFUTED,
    ),
}


@pytest.mark.parametrize("claim", HOLD, ids=lambda claim: claim["kind"])
def test_what_holds_on_the_curve_is_verified(claim, folder, tmp_path):
    row = decided(folder, tmp_path, **claim)
    assert row.verdict == Verdict.VERIFIED, str(row.witness)
    assert row.as_recorded


@pytest.mark.parametrize("reason", FAIL)
def test_what_is_false_of_the_curve_is_not(reason, folder, tmp_path):
    claim, verdict = FAIL[reason]
    row = decided(folder, tmp_path, **claim)
    assert row.verdict == verdict, str(row.witness)
    if verdict == Verdict.REFUTED:
        assert str(row.witness).startswith(f"on the example curve {claim.get('example', 'arch')}")


REFUSED = [
    ({"kind": "identity", "left": "twice", "right": "turning", "factor": "2"}, "belong together"),
    ({"kind": "sign", "formula": "turning", "on": "curve", "example": None}, "belong together"),
    ({"kind": "at", "formula": "x", "parameter": 0, "claimed": 0, "on": "all curves"}, "belong together"),
    ({"kind": "at", "formula": "x", "parameter": "1/0", "claimed": 0}, "1/0"),
    ({"kind": "at", "formula": "x", "parameter": [0], "claimed": 0}, "not a number"),
    ({"kind": "at", "formula": "x", "parameter": True, "claimed": 0}, "not a number"),
    ({"kind": "bound", "formula": "x", "bound": "about 3"}, "no bound"),
    ({"kind": "bound", "formula": "x", "bound": "= 3"}, "no equation"),
    ({"kind": "bound", "formula": "x", "bound": "≤ 3", "interval": [1, 0]}, "no interval"),
    ({"kind": "count", "formula": "x", "claimed": "degree 3", "interval": [0, 1]}, "only roots"),
    ({"kind": "coefficients", "formula": "px", "sign": "> 0", "example": None}, "signs on all curves"),
    ({"kind": "at", "formula": "x", "parameter": 0, "claimed": 0, "example": "twisted_cubic"}, "not a curve to which"),
    ({"kind": "vanishing", "left": "x", "on": "curve", "of": "rational"}, "not a curve to which"),
    ({"kind": "applies", "formula": "x", "on": "curve", "curve": "framed plane"}, "not a curve to which"),
    ({"kind": "bound", "formula": "x", "bound": "≤ 9", "curve": "hodograph"}, "not a curve to which"),
    ({"kind": "distance", "other": "nowhere", "bound": "= 0"}, "no example curve called"),
]


@pytest.mark.parametrize(("claim", "problem"), REFUSED)
def test_what_cannot_be_meant_is_refused(claim, problem, folder, tmp_path):
    assert decided(folder, tmp_path, **claim).verdict == Verdict.NOT_ASKED
    assert problem in refusal(tmp_path / "p")


def test_a_constant_of_our_choice_is_no_value(tmp_path):
    """A claim with a constant holds for all of its values, or is not said to hold."""
    formulas = "@formula('e', on='plane with delta')\ndef shifted(c):\n    return c.gamma[0] + c.delta - c.delta\n"
    formulas += "@formula('e', on='plane with delta')\ndef scaled(c):\n    return c.gamma[0] * c.delta\n"
    base = {"kind": "at", "statement": "s", "curve": "plane with delta", "example": "circle", "parameter": "0"}
    x = str(example("circle")(0)[0] * exactspline.rational("37/29"))
    claims = [
        base | {"id": "1", "formula": "scaled", "claimed": x},
        base | {"id": "2", "formula": "scaled", "claimed": "0"},
    ]
    rows = [decide(claim) for claim in claims_of(paper(written(tmp_path / "p", formulas, claims)))]
    assert [row.verdict for row in rows] == [Verdict.UNDECIDED, Verdict.REFUTED]


@pytest.mark.parametrize(
    ("kind", "formula", "fields"),
    [
        ("plane with delta", "c.gamma[1] - c.delta", {"kind": "count", "formula": "f", "claimed": "0 roots"}),
        ("plane point", "norm2(c.gamma - c.point)", {"kind": "count", "formula": "f", "claimed": "0 roots"}),
        ("plane with delta", "c.gamma[0] - c.delta / 10", {"kind": "condition", "left": "f", "right": "g"}),
    ],
)
def test_roots_are_not_counted_for_one_constant_or_point(kind, formula, fields, tmp_path):
    """y = δ has two roots on (t, t²) for δ = 1/4, none for δ = 37/29; a point may lie on the curve."""
    formulas = "".join(
        f"@formula('e', on='{kind}')\ndef {name}(c):\n    return {body}\n"
        for name, body in (("f", formula), ("g", f"({formula}) * (c.gamma[0] - rational('1/8'))"))
    )
    claim = {"id": "1", "statement": "s", "curve": kind, "example": "straight_line"} | fields
    own = written(tmp_path / "p", formulas, [claim])
    (own / "curves").mkdir()
    exactspline.write(PARABOLA, own / "curves" / "straight_line.json")
    (row,) = map(decide, claims_of(paper(own)))
    assert row.verdict in (Verdict.UNDECIDED, Verdict.REFUTED, Verdict.VACUOUS)


@pytest.mark.parametrize(
    ("claim", "words"),
    [
        (
            {"kind": "bound", "formula": "y", "bound": "≤ 1", "interval": [0, "1/2"]},
            ["[0, ", "1/2", "of the curve arch"],
        ),
        ({"kind": "count", "formula": "y", "claimed": "1 roots", "interval": [0, "1/2"]}, ["[0, ", "1/2"]),
        (
            {"kind": "coefficients", "formula": "bent", "sign": "≤ 0", "on": "curve"},
            ["every Bernstein coefficient", r"\le"],
        ),
        ({"kind": "coefficients", "formula": "bent", "on": "curve"}, ["every Bernstein coefficient", r"\neq 0"]),
        ({"kind": "limit", "formula": "slope", "parameter": 0, "claimed": "8/3"}, [r"\lim_{t \to 0}"]),
        ({"kind": "distance", "other": "corner", "bound": "≤ 1"}, ["arch", "corner"]),
    ],
)
def test_what_is_printed_is_what_was_decided(claim, words, folder, tmp_path):
    assert decided(folder, tmp_path, **claim).verdict == Verdict.VERIFIED
    printed = invoke("show", "1", "--paper", tmp_path / "p", "--latex").output
    assert all(word in printed for word in words)
    if "interval" in claim:
        invoke("prove", "--paper", tmp_path / "p", "--report", tmp_path / "r.html")
        for text in (invoke("show", "1", "--paper", tmp_path / "p").output, (tmp_path / "r.html").read_text()):
            assert "on [0, 1/2] of the curve arch" in text


def test_a_curve_of_the_paper_with_the_name_of_an_undulation_is_the_one_meant(tmp_path):
    """What is refuted by the undulation alone is not refuted by a line of that name."""
    formulas = plane_formulas(
        velocity="c.gamma.d(1)",
        bend="det(c.gamma.d(1), c.gamma.d(2))",
        more="det(c.gamma.d(1), c.gamma.d(2)) * norm2(c.gamma.d(3))",
    )
    claim = {"id": "1", "statement": "s", "curve": "plane", "kind": "zero set", "formulas": ["bend", "more"]}
    own = written(tmp_path / "p", formulas, [claim])
    (own / "curves").mkdir()
    exactspline.write(ARCH, own / "curves" / "undulation_2d.json")
    (claim,) = claims_of(paper(own))
    examples = {name: curve for _, name, curve in claim._examples()}
    assert examples["undulation_2d"] == ARCH


def test_other_judges_are_not_asked_of_one_curve(folder, tmp_path):
    """sympy would refute for all curves what holds on one."""
    row = decided(folder, tmp_path, kind="identity", left="bent", right="turning", on="curve")
    assert Sympy().decide(row.claim).verdict == Verdict.UNDECIDED
    done = invoke("prove", "--paper", tmp_path / "p", "--judge", "sympy")
    assert done.exit_code == 0
    assert "VERIFIED" in done.output


def test_every_door_takes_them(folder, tmp_path):
    for claim in HOLD[::5]:
        row = decided(folder, tmp_path, **claim)
        assert row.claim.latex
        for command in (
            ["show", "1"],
            ["show", "1", "--latex"],
            ["errata"],
            ["prove", "--report", tmp_path / "r.html"],
        ):
            assert invoke(*command, "--paper", tmp_path / "p").exit_code == 0
    wrong = decided(folder, tmp_path, kind="identity", left="twice", right="turning", factor="3", on="curve")
    assert wrong.verdict == Verdict.REFUTED
    found = invoke("prove", "--paper", tmp_path / "p").output
    assert "twice = 3" not in found  # the claimed relation was shown as what is found
    assert "Remark: said" in invoke("errata", "--paper", tmp_path / "p").output


def test_no_perturbed_claim_keeps_its_verdict():
    """A sample of the campaign."""
    tally, wrong = one_curve.campaign(1, 7)
    assert wrong == []
    assert sum(n for (_, holds, _), n in tally.items() if not holds) > 30
