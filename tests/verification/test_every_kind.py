"""Every kind of claim with every kind of argument: each has a verdict, or is not asked with the reason; none is silent,
and none tells the name of an exception of Python.
"""

import re

import pytest

from exactspline import Verdict, example, paper
from exactspline.language.kinds import kind_of
from exactspline.verification.claims import claims_of
from exactspline.verification.kinds import KINDS
from exactspline.verification.ledger import tasks
from tests.verification.test_own_paper import written

V, A = "c.gamma.d(1)", "c.gamma.d(2)"
RULED = f"ruled(c.gamma, {V})"
BY = "c.first.gamma.d(1, by='s')", "c.second.gamma.d(1, by='s̄')"
MET = ("norm2(c.first.gamma - c.second.gamma)", "c.first.gamma", "ruled(c.first.gamma, c.second.gamma)")
IN_S = ("norm2(c.S.d(1, by='v'))", "c.S.d(1, by='u')", "ruled(c.S, c.S.d(1, by='u'))")
ONE, WAY = "c.first.gamma.d(1)", "(c.second.gamma - c.first.gamma)"
UNIT = f"{V} / c.sigma"
#: Two scalars, a vector and a ruled surface in arguments of each kind; three curves are none.
SORTS = {
    "curve": (f"norm2({A})", f"norm2({V})", V, RULED),
    "plane": (f"det({V}, {A})", f"norm2({V})", V, RULED),
    "space": (f"norm2(cross({V}, {A}))", f"norm2({V})", V, RULED),
    "plane point": (f"det({V}, c.point)", f"norm2({V})", "c.gamma - c.point", f"ruled(c.point, {V})"),
    "point": (f"dot({V}, c.point)", f"norm2({V})", "c.gamma - c.point", f"ruled(c.point, {V})"),
    "plane with delta": (f"c.delta * det({V}, {A})", f"norm2({V})", f"c.delta * {V}", RULED),
    "space with h, r": (f"c.r * norm2({V})", "c.h + c.gamma[0]", f"c.h * {V}", RULED),
    "plane pair": (f"det({BY[0]}, {BY[1]})", *MET),
    "pair": (f"dot({BY[0]}, {BY[1]})", *MET),
    "three curves": (f"det({V}, {A})", f"norm2({V})", V, RULED),
    "framed": (f"norm2({A}) / c.sigma", "c.sigma", UNIT, f"ruled(c.gamma, {UNIT})"),
    "framed plane": (f"det({V}, {A}) / c.sigma", "c.sigma", UNIT, f"ruled(c.gamma, {UNIT})"),
    "framed space": ("c.rho / c.sigma", "c.sigma", UNIT, f"ruled(c.gamma, {UNIT})"),
    "framed plane with delta": ("c.delta / c.sigma", "c.sigma", f"c.delta * {UNIT}", f"ruled(c.gamma, {UNIT})"),
    "hodograph": ("c.u + c.h", "c.speed", "c.velocity", RULED),
    "hodograph with delta": ("c.u + c.delta * c.h", "c.speed", "c.velocity", RULED),
    "surface": ("norm2(c.S.d(1, by='u'))", *IN_S),
    "planar map": ("norm2(c.S.d(1, by='u'))", *IN_S),
    "curve on a surface": (f"norm2({V})", "norm2(c.S.d(1, by='v'))", V, RULED),
    "forms": ("c.E * c.G - c.F**2", "c.L * c.N", "join(c.E, c.F)", "ruled(join(c.E, c.F, c.G), join(c.L, c.M, c.N))"),
    "implicit": ("c.fx * c.fy", "norm2(c.gradient_f)", "c.gradient_f", RULED),
    "implicit surface": ("c.fx * c.fy", "norm2(c.gradient_f)", "c.gradient_f", RULED),
    "intersection": ("c.fx * c.gy", "norm2(c.gradient_f)", "c.gradient_f", RULED),
    "table": ("c.p1 * c.p2", "c.p1 + c.p2", "c.v1", "ruled(c.v1, c.v2)"),
}
HUGE = f"(norm2({V}) + norm2({A}) + 1) ** 11 * (norm2(c.gamma) + norm2(c.gamma.d(3)) + 1) ** 11"


def fields_of(kind, f, g, h, v, r):
    """Claims of a kind about two scalars f and h, g = 2f, a vector v and a ruled surface r."""
    at = {"parameter": "1/2", "claimed": "1", "example": ""}
    return {
        "identity": [{"left": g, "right": f, "factor": "2"}, {"left": f, "right": v}, {"left": r, "right": h}],
        "vanishing": [{"left": f}, {"left": v}, {"left": r}],
        "zero set": [{"formulas": [f, g]}, {"formulas": [f, h]}, {"formulas": [v, r]}],
        "coefficients": [{"formula": x, "curves": "generic"} for x in (f, v)],
        "condition": [{"left": f, "right": h, "example": ""}, {"left": v, "right": h, "example": ""}],
        "count": [
            {"formula": x, "claimed": claimed, "example": ""}
            for x, claimed in (
                (f, "3 roots"),
                (f, "3 extrema"),
                (v, "degree 3"),
                (v, "1 cusps"),
                (r, "8 control points"),
            )
        ],
        "square class": [{"formula": f, "right": h}, {"formula": v, "right": h}],
        "same surface": [{"left": r, "right": f"again_{r}"}, {"left": f, "right": h}, {"left": r, "right": h}],
        "existence": [{"formula": f, "definition": h}, {"formula": v, "definition": r}],
        "iso-curve": [{"left": v, "right": x} for x in ("r_point", "v_point", "f_point", r)]
        + [{"left": x, "right": "r_point"} for x in (f, r)],
        "contact": [{"formula": x, "order": 1} for x in (f, h, v, r)],
        "invariance": [
            {"formula": f, "under": "motion"},
            {"formula": h, "under": "reparametrization", "weight": 2},
            {"formula": v, "under": "rotation", "nature": "vector"},
            {"formula": r, "under": "scaling", "nature": "point"},
        ],
        "sign": [{"formula": h}, {"formula": f, "sign": "> 0"}, {"formula": h, "squares": [v]}, {"formula": v}],
        "type": [{"formula": f, "claimed": "rational"}, {"formula": v, "claimed": "polynomial"}],
        "applies": [{"formula": f}, {"formula": r}],
        "at": [{"formula": x} | at for x in (f, v, r)],
        "limit": [{"formula": x} | at for x in (f, v, r)],
        "bound": [{"formula": x, "bound": "≤ 3", "example": ""} for x in (f, v, r)],
        "distance": [{"other": "ellipse", "bound": "= 1", "example": ""}],
        "degree": [{"formula": f, "claimed": "3d"}, {"formula": v, "claimed": "d", "measure": "lowest terms"}],
        "not asked": [{"why": "an integral"}],
    }[kind]


def slug(sort):
    return re.sub(r"\W+", "_", sort)


def formulas(sort):
    f, h, v, r = SORTS[sort]
    bodies = {"f": f, "g": f"2 * ({f})", "h": h, "v": v, "r": r, "again_r": r}
    return "".join(f"@formula('e', on='{sort}')\ndef {n}_{slug(sort)}(c):\n    return {b}\n" for n, b in bodies.items())


def entries(sort):
    """A claim of each kind about arguments of a sort, for all of them and on one curve."""
    names = [f"{x}_{slug(sort)}" for x in "fghvr"]
    space = sort != "three curves" and 2 not in kind_of(sort).dimensions
    one = {"example": "rational_space_cubic" if space else "rational_cubic"}
    for kind in KINDS:
        for fields in fields_of(kind, *names):
            both = [fields | one] if "example" in fields else [fields, fields | one | {"on": "curve"}]
            for each in both[: 1 if kind == "not asked" else 2]:
                yield {"kind": kind, "statement": "s", "curve": sort} | each


def rows_of(folder, text, claims):
    """The rows of claims: for all curves, and on one curve or surface of each dimension."""
    told = [{"id": f"{i}"} | each for i, each in enumerate(claims, 1)]
    for claim in claims_of(paper(written(folder, text, told))):
        yield claim, tasks([claim], None, 20)[0]()
        kind, n = kind_of(claim.curve), claim.dimensions[0]
        if kind.made_of_a_surface:
            on = example({2: "planar_map", 3: "rational_biquadratic"}[n])
        else:
            on = example({2: "rational_cubic", 3: "rational_space_cubic"}[n])
        if kind.made_of_a_surface or kind.made_of_a_curve:
            yield from ((claim, task()) for task in tasks([claim], [on], 20))


def told(row):
    return " ".join(str(x) for x in (row.computed, row.witness) if x is not None)


@pytest.mark.parametrize("sort", SORTS)
def test_no_kind_is_silent_about_any_argument(tmp_path, sort):
    """Told before: AttributeError of pairs, RecursionError of ``applies`` on one curve, 'right' is of type Side."""
    text = "".join(formulas(each) for each in {sort, "point"} - {"three curves"})
    claims = list(entries(sort))
    asked = 0
    for claim, row in rows_of(tmp_path / "p", text, claims):
        asked += 1
        assert row.verdict != Verdict.CONTRADICTION, (claim.statement, told(row))
        assert row.verdict in (Verdict.PROVED, Verdict.VERIFIED) or told(row), (claim.kind, claim)
        assert not re.search(r"(;|\bin)\s*$", told(row)), told(row)
        assert not re.search(r"\b[A-Z]\w+Error|Warning|object has|NoneType|exactspline\.", told(row)), told(row)
    assert asked >= len(claims)


#: Formulas for claims of each outcome: plane curves, one with a constant, two curves, a curve and a point.
BODIES = {
    "plane": {"f": SORTS["plane"][0], "g": f"2 * det({V}, {A})", "h": f"norm2({V})", "v": V, "r": RULED, "q": RULED}
    | {"huge": HUGE, "p": "c.p[0]", "bent": f"det({V}, {A}) * (1 + norm2({V}))"},
    "plane with delta": {"moved": "c.gamma[0] + 0 * c.delta"},
    "framed plane": {"defined": f"det({V}, {A}) * c.sigma / c.sigma", "root": "c.sigma"},
    "plane point": {"beside": "c.gamma - c.point", "iso": "c.gamma"},
    "point": {"lines": "ruled(c.gamma, join(c.w, c.w, c.w))", "no_lines": "c.gamma"},
    "plane pair": {"tangent": f"det({ONE}, {WAY})", "both": f"norm2({WAY})"},
}
ON, AT, PART = (
    {"example": "cubic_s"},
    {"example": "cubic_s", "parameter": "0"},
    {"curve": "plane with delta", "formula": "moved"},
)
PAIR, BESIDE = {"curve": "plane pair"}, {"curve": "plane point"}
#: Of each kind a claim that is decided, one that is not, with a word of the reason, and one that is refused.
OUTCOMES = {
    "degree": ({"formula": "f", "claimed": "4d"}, {"formula": "huge", "claimed": "d", "measure": "lowest terms"}, {}),
    "identity": ({"left": "g", "right": "f", "factor": "2"}, {"left": "huge", "right": "f"}, {"left": "f"}),
    "vanishing": ({"left": "f"}, {"left": "huge"}, {"left": "none"}),
    "zero set": ({"formulas": ["f", "g"]}, {"formulas": ["f", "huge"]}, {"formulas": ["f"]}),
    "coefficients": ({"formula": "p", "on": "curve", **ON}, {"formula": "p", "curves": "generic"}, {"formula": "f"}),
    "condition": ({"left": "f", "right": "bent", **ON}, {"left": "v", "right": "f", **ON}, {"left": "f"}),
    "count": ({"formula": "f", "claimed": "1 roots", **ON}, {"formula": "v", "claimed": "1 roots", **ON}, PAIR),
    "square class": ({"formula": "f", "right": "h"}, {"formula": "f", "right": "huge"}, PAIR),
    "same surface": ({"left": "r", "right": "q"}, {"left": "f", "right": "g"}, {"left": "r", "right": "r"}),
    "existence": ({"formula": "f", "definition": "defined"}, {"formula": "f", "definition": "root"}, {"formula": "f"}),
    "iso-curve": (
        BESIDE | {"left": "iso", "right": "lines"},
        BESIDE | {"left": "iso", "right": "no_lines"},
        BESIDE | {"left": "iso"},
    ),
    "contact": (PAIR | {"formula": "tangent", "order": 1}, PAIR | {"formula": "both", "order": 1}, {"formula": "f"}),
    "invariance": ({"formula": "f", "under": "motion"}, {"formula": "huge", "under": "motion"}, {"formula": "f"}),
    "sign": ({"formula": "h", "squares": ["v"]}, {"formula": "h"}, PAIR | {"formula": "both"}),
    "type": ({"formula": "p", "claimed": "polynomial"}, {"formula": "huge", "claimed": "rational"}, {"formula": "f"}),
    "applies": ({"formula": "f"}, {"formula": "huge"}, {"formula": "none"}),
    "at": ({"formula": "p", "claimed": "7", **AT}, {**PART, "claimed": "0", **AT}, {"formula": "p"}),
    "limit": ({"formula": "p", "claimed": "7", **AT}, {**PART, "claimed": "0", **AT}, {"formula": "p"}),
    "bound": ({"formula": "p", "bound": "≤ 99", **ON}, PART | {"bound": "≤ 99", **ON}, PAIR),
    "distance": ({"other": "ellipse", "bound": "≤ 99", **ON}, {"other": "twisted_cubic", "bound": "= 1", **ON}, {}),
}


def test_of_each_kind_one_is_decided_one_undecided_and_one_refused(tmp_path):
    assert OUTCOMES.keys() == KINDS.keys() - {"not asked"}
    text = "".join(
        f"@formula('e', on='{sort}')\ndef {name}(c):\n    return {body}\n"
        for sort, bodies in BODIES.items()
        for name, body in bodies.items()
    )
    common = {"statement": "s", "curve": "plane", "of": "polynomial"}
    claims = [common | {"kind": kind} | each for kind, three in OUTCOMES.items() for each in three]
    told_claims = [{"id": f"{i}"} | each for i, each in enumerate(claims)]
    rows = [tasks([claim], None, 20)[0]() for claim in claims_of(paper(written(tmp_path / "p", text, told_claims)))]
    for kind, decided, not_decided, refused in zip(OUTCOMES, rows[::3], rows[1::3], rows[2::3], strict=True):
        assert decided.verdict in (Verdict.PROVED, Verdict.VERIFIED, Verdict.REFUTED), (
            kind,
            decided.verdict,
            told(decided),
        )
        assert not_decided.verdict == Verdict.UNDECIDED, (kind, not_decided.verdict, told(not_decided))
        assert not_decided.witness is not None, kind
        assert refused.verdict == Verdict.NOT_ASKED, (kind, refused.verdict, told(refused))
        assert refused.witness is not None, kind
