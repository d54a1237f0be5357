"""Zero sets for all curves: what is true is proved where a student sees it, what is false is not, and what is undecided
says which factors may have zeros.
"""

import ast
import re
from pathlib import Path

import pytest

import exactspline
from exactspline import Verdict, claims, example, paper
from tests.campaigns import zero_sets
from tests.support.claims import one_verdict
from tests.verification.test_own_paper import written

V, A, J = "c.gamma.d(1)", "c.gamma.d(2)", "c.gamma.d(3)"
F = f"det({V}, {A})"
ONE, WAY = "c.first.gamma.d(1)", "(c.second.gamma - c.first.gamma)"


def claimed(folder, *bodies, curve="plane", assumes=("w",), **more):
    """A claim that formulas with these bodies have one zero set."""
    text = "@formula('e', on='plane')\ndef turning(c):\n    return det(c.p.d(1) * c.w - c.p * c.w.d(1), {})\n"
    text = text.format("c.p.d(2) * c.w - c.p * c.w.d(2)") if "turning ≠ 0" in assumes or more.pop("turning", 0) else ""
    for i, body in enumerate(bodies):
        text += f"@formula('e', on='{curve}')\ndef f{i}(c):\n    return {body}\n"
    told = {"id": "1", "kind": "zero set", "statement": "s", "status": "ours", "curve": curve, "assumes": list(assumes)}
    told |= {"formulas": [f"f{i}" for i in range(len(bodies))]}
    (claim,) = claims(paper=paper(written(folder, text, [told | more])))
    return claim


def verdict(*args, **more):
    found = one_verdict(claimed(*args, **more))
    assert found.verdict != Verdict.UNDECIDED or found.witness is not None
    return found.verdict


TRUE = {
    "a cube": (F, f"{F} ** 3"),
    "a radical that divides": (f"{F} * c.p[0] ** 2", f"{F} ** 5 * c.p[0]"),
    "positive by a square": (f"{F}", f"{F} * (1 + {V}[0] ** 2)"),
    "positive by a product with itself": (f"{F}", f"{F} * (2 + ({V}[0] - 1) * ({V}[0] - 1))"),
    "positive by an inner product with itself": (f"{F}", f"{F} * (2 + dot({A} + {V}, {V} + {A}))"),
    "a vector and its length": (V, f"norm2({V})"),
    "a vector and a scalar": (f"{V} * {F}", f"{F} * norm2({V})"),
}


@pytest.mark.parametrize("bodies", TRUE.values(), ids=TRUE)
def test_what_a_student_sees_is_proved(tmp_path, bodies):
    assert verdict(tmp_path, *bodies) == Verdict.PROVED


#: What would pass a careless look at factors and squares.
FALSE = {
    "a difference of squares": (F, f"{F} * (1 - norm2({V}))"),
    "a negative constant": (F, f"{F} * (-1 + norm2({V}))"),
    "a cube": (F, f"{F} * (1 + {V}[0] ** 3)"),
    "a product with another": (F, f"{F} * (1 + {V}[0] * {A}[0])"),
    "an inner product with another": (F, f"{F} * (1 + dot({V}, {A}))"),
    "a multiple of a square": (F, f"{F} * (1 + -2 * {V}[0] ** 2)"),
    "no square at all": (F, f"{F} * (1 + {V}[0])"),
    "squares without a positive one": (f"{A}[0]", f"{A}[0] * ({V}[0] ** 2 + {V}[1] ** 2)"),
    "a factor in one alone": (F, f"{F} ** 2 * c.p[0]"),
    "a component of a vector": (V, f"{V}[0]"),
    "a vector with a content that vanishes": (f"{V} * c.p[0]", f"norm2({V})"),
}


X = "c.gamma[0]"
#: f·(1 + x′²) beside a frame, and what is written nearly so.
SPELLED = {
    f"{X} * c.sigma * (1 + {X}.d(1) ** 2)": Verdict.PROVED,
    f"{X} * (c.sigma + c.sigma * {X}.d(1) ** 2)": Verdict.PROVED,
    f"{X} * c.sigma + {X} * c.sigma * {X}.d(1) * {X}.d(1)": Verdict.PROVED,
    f"-{X} * c.sigma * (3 + {X}.d(1) ** 2 + {X}.d(1) ** 2 * {X} ** 2)": Verdict.PROVED,
    f"{X} * c.sigma * (norm2({V}) + {X}.d(1) ** 2)": Verdict.PROVED,
    f"{X} * c.sigma * (1 - {X}.d(1) ** 2)": Verdict.REFUTED,
    f"{X} * c.sigma * (1 + {X}.d(1) ** 3)": Verdict.REFUTED,
    f"{X} * c.sigma * (1 + {X}.d(1) * {V}[1])": Verdict.REFUTED,
    f"{X} * c.sigma * {X}.d(1) ** 2": Verdict.REFUTED,
    f"{V}[1] * c.sigma * ({X}.d(1) ** 2 + {X} ** 2)": Verdict.REFUTED,
    f"{X} * c.sigma * ({V}[0] ** 2 + {A}[0] ** 2)": Verdict.UNDECIDED,
}


@pytest.mark.parametrize(("body", "found"), SPELLED.items(), ids=SPELLED)
def test_the_answer_beside_a_frame_does_not_depend_on_spelling(tmp_path, body, found):
    """UNDECIDED before: (x′² + 1) might have zeros wherever a formula names σ."""
    told = {"curve": "framed plane", "assumes": ("w", "γ′")}
    assert verdict(tmp_path, f"{X} * c.sigma", body, **told) == found


@pytest.mark.parametrize("bodies", FALSE.values(), ids=FALSE)
def test_what_is_false_is_refuted_or_undecided_with_its_reason(tmp_path, bodies):
    assert verdict(tmp_path, *bodies) in (Verdict.REFUTED, Verdict.UNDECIDED)


def test_a_zero_that_cancels_is_no_zero_of_the_value(tmp_path):
    """x y / y² = x / y has no zero where both vanish to first order: supports alone would prove it."""
    x, y = f"{V}[0]", f"{A}[0]"
    assert verdict(tmp_path, f"{x}", f"{x} / {y}") in (Verdict.REFUTED, Verdict.UNDECIDED)
    assert verdict(tmp_path, f"{x} / {y}", f"{x} ** 2 / {y}") in (Verdict.REFUTED, Verdict.UNDECIDED)
    assert verdict(tmp_path, f"{x} / {y}", f"{x} ** 2 / {y} ** 2") == Verdict.PROVED
    assert verdict(tmp_path, f"{x} / {x} ** 2", f"{y} / {y} ** 3") == Verdict.PROVED  # neither has a zero


def test_a_sum_of_squares_with_a_pole_does_not_count(tmp_path):
    """1 + 1/y² has no zero but y² of it may: y² + 1 is not shown to be positive, and nothing is proved by it."""
    x, y = f"{V}[0]", f"{A}[0]"
    assert verdict(tmp_path, x, f"{x} * {y} ** 2 * (1 + 1 / {y} ** 2)") != Verdict.REFUTED  # it is x (1 + y²)
    assert verdict(tmp_path, x, f"{x} * (1 + 1 / {y} ** 2)") in (Verdict.REFUTED, Verdict.UNDECIDED)


VERTEX = f"3 * dot({V}, {A}) * {F} - norm2({V}) * det({V}, {J})"
EVOLUTE = f"(c.gamma + perp({V}) * (norm2({V}) / {F})).d(1)"


@pytest.mark.parametrize("velocity", [EVOLUTE, f"norm2({EVOLUTE})"])
def test_the_evolute_has_a_cusp_where_the_curvature_is_stationary_but_at_inflections(tmp_path, velocity):
    """At 0 of (t, t⁴) the vertex form vanishes and the velocity has a pole; no example has such a point."""
    bodies, assumes = (velocity, VERTEX), ("w", "γ′")
    assert verdict(tmp_path / "a", *bodies, assumes=(*assumes, "turning ≠ 0")) == Verdict.PROVED
    found = one_verdict(claimed(tmp_path / "b", *bodies, assumes=assumes))
    assert (found.verdict, str(found.witness.name)) == (Verdict.REFUTED, "undulation_2d")
    rational = one_verdict(claimed(tmp_path / "c", *bodies, assumes=assumes, of="rational"))
    assert (rational.verdict, str(rational.witness.name)) == (Verdict.REFUTED, "rational_undulation_2d")


def test_two_curves_are_compared_along_lines(tmp_path):
    form, pair = f"det({ONE}, {WAY})", {"curve": "plane pair", "assumes": ("w", "w̄")}
    true = claimed(tmp_path / "a", form, f"{form} * (1 + norm2({WAY}))", **pair)
    assert one_verdict(true).verdict == Verdict.PROVED
    assert true.check(example("rational_cubic")).verdict == Verdict.UNDECIDED  # on the part that was tried it holds
    false = claimed(tmp_path / "b", form, f"{form} * dot({ONE}, {WAY})", **pair)
    found = one_verdict(false)
    assert found.verdict == Verdict.REFUTED
    assert re.search(r"at s̄? = .* of the other curve, [^,]", str(found.witness))
    assert verdict(tmp_path / "c", f"{ONE}[0]", f"{ONE}[0] / ({ONE}[0] - c.second.p[0])", **pair) != Verdict.PROVED


def test_roots_are_squared_away(tmp_path):
    framed = {"curve": "framed plane", "assumes": ("w", "γ′")}
    assert verdict(tmp_path / "b", F, f"{F} / c.sigma ** 3", **framed) == Verdict.PROVED
    assert verdict(tmp_path / "c", F, f"{F} * (c.sigma - 1)", **framed) == Verdict.UNDECIDED
    assert verdict(tmp_path / "d", F, f"{F} * c.sigma * dot({V}, {A})", **framed) == Verdict.REFUTED
    cusp = one_verdict(claimed(tmp_path / "e", F, f"{F} / c.sigma ** 3", **framed | {"assumes": ("w",)}))
    assert cusp.verdict == Verdict.REFUTED
    assert verdict(tmp_path / "f", F, f"{F} / c.sigma ** 3", **framed | {"assumes": ("γ′",)}) != Verdict.PROVED


@pytest.mark.parametrize(
    ("bodies", "curve"),
    [
        ((F, f"{F} * c.w"), "plane"),
        ((F, f"{F} * norm2({V})"), "plane"),
        (("c.p[0]", f"c.p[0] * {F} / c.w ** 3"), "plane"),
        (("c.p[0]", "c.p[0] * c.delta"), "plane with delta"),
        (("c.p[0]", f"c.p[0] * norm2(cross({V}, {A}))"), "space"),
    ],
)
def test_the_assumption_that_is_advised_proves_it_when_typed(tmp_path, bodies, curve):
    """Passed before: UNDECIDED, and not a word."""
    more = {"curve": curve, "turning": curve.startswith("plane"), "witness": ""}
    bare = claimed(tmp_path / "a", *bodies, assumes=(), **more)
    guilty = []
    for polynomial in bare.of.worlds:
        found = bare.decide(bare.dimensions[0], polynomial)
        guilty += found.witness.about[1] if found.verdict == Verdict.UNDECIDED else ()
    if guilty:
        assert verdict(tmp_path / "b", *bodies, assumes=tuple(dict.fromkeys(guilty)), **more) == Verdict.PROVED


#: Where nothing is said of a search that found nothing, or of all curves where one alone is asked about: what is
#: decided then says why.
SEARCHES = {"refuted_on_examples", "_with_roots", "_on_its_curve"}


def test_nothing_is_undecided_without_its_reason():
    """Passed before: zero sets whose quotients have factors that may vanish, and condition numbers that overlap."""
    silent = []
    for file in (Path(exactspline.__file__).parent / "verification").rglob("*.py"):
        for function in ast.walk(ast.parse(file.read_text(encoding="utf8"))):
            if isinstance(function, ast.FunctionDef) and function.name not in SEARCHES:
                silent += [
                    (file.name, function.name)
                    for call in ast.walk(function)
                    if isinstance(call, ast.Call)
                    and getattr(call.func, "id", "") == "Finding"
                    and any(getattr(each, "id", "") == "UNDECIDED" for each in call.args)
                    and len(call.args) < 4
                    and not any(keyword.arg == "witness" for keyword in call.keywords)
                ]
    assert silent == []


def test_no_changed_claim_keeps_its_verdict():
    """A sample of the campaign."""
    tally, wrong = zero_sets.campaign(step=9)
    assert wrong == []
    assert tally["changed", "REFUTED"]
