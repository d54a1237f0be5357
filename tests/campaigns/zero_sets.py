"""False claims of zero sets, each a true one with one thing changed.

python -m tests.campaigns.zero_sets

A true claim is changed in its last formula: a factor is multiplied with it that has zeros on some curve, a value is
divided by one, a sum of squares becomes a difference, or an assumption is dropped on which it depends. The exit status
is 1 where a changed claim is PROVED, one is UNDECIDED without a reason, or a true one is not PROVED.
"""

import sys

from tests.support.changed_claims import judged, told

#: The sentence of the documentation that is judged.
COMPARED = ("all formulas have the same zeros, wherever the assumptions hold",)
V, A, J = "c.gamma.d(1)", "c.gamma.d(2)", "c.gamma.d(3)"
F = f"det({V}, {A})"
EVOLUTE = f"(c.gamma + perp({V}) * (norm2({V}) / {F})).d(1)"
VERTEX = f"(3 * dot({V}, {A}) * {F} - norm2({V}) * det({V}, {J}))"
WAY = "(c.second.gamma - c.first.gamma)"
ONE = "c.first.gamma.d(1)"
#: Factors with zeros on some curves on which the formulas of the claims have none.
HARMFUL = {
    "plane": [f"dot({V}, {A})", f"(norm2({V}) - 1)", f"(norm2({A}) - norm2({V}))", "c.p[0]", f"(1 - {F} ** 2)"],
    "space": [
        f"dot({V}, {A})",
        f"(norm2({V}) - 1)",
        "c.p[2]",
        f"(norm2({A}) - norm2({V}))",
        f"(1 - dot({V}, {A}) ** 2)",
    ],
    "plane point": ["c.point[0]", f"dot({V}, c.gamma - c.point)", "(norm2(c.point) - 1)", "c.p[0]"],
    "plane pair": [f"dot({ONE}, {WAY})", f"(norm2({WAY}) - 1)", f"(norm2({ONE}) - norm2({WAY}))", "c.second.p[0]"],
}
HARMFUL["framed plane"], HARMFUL["framed space"] = HARMFUL["plane"], HARMFUL["space"]
#: Kind, formulas, and assumptions.
TRUE = [
    ("plane", (F, f"{F} ** 3"), ("w",)),
    ("plane", (F, f"{F} * (1 + norm2({V}))"), ("w",)),
    ("plane", (F, f"{F} * (1 + {F} ** 2)"), ("w",)),
    ("plane", (F, f"{F} * (norm2({V}) + norm2({A}))"), ("w", "γ′")),
    ("plane", (VERTEX, f"norm2({EVOLUTE})"), ("w", "γ′", "turning ≠ 0")),
    ("plane", (VERTEX, EVOLUTE), ("w", "γ′", "turning ≠ 0")),
    ("plane", (F, f"2 * {F}"), ("w",)),
    ("plane", (F, f"{F} ** 2 / norm2({V}) ** 3"), ("w", "γ′")),
    ("space", (f"cross({V}, {A})", f"norm2(cross({V}, {A}))"), ("w",)),
    ("space", (f"det({V}, {A}, {J})", f"det({V}, {A}, {J}) / norm2(cross({V}, {A}))"), ("w", "γ′×γ″")),
    ("space", (f"det({V}, {A}, {J})", f"det({V}, {A}, {J}) * (3 + dot({V}, {A}) ** 2)"), ("w",)),
    ("plane point", ("c.gamma - c.point", "norm2(c.gamma - c.point)"), ("w",)),
    ("plane point", (f"det({V}, c.gamma - c.point)", f"det({V}, c.gamma - c.point) * (2 + norm2(c.point))"), ("w",)),
    ("plane pair", (f"det({ONE}, {WAY})", f"det({ONE}, {WAY}) ** 3"), ("w", "w̄")),
    ("plane pair", (f"det({ONE}, {WAY})", f"det({ONE}, {WAY}) * (1 + norm2({WAY}))"), ("w", "w̄")),
    ("framed plane", (F, f"{F} / c.sigma ** 3"), ("w", "γ′")),
    ("framed space", (f"cross({V}, {A})", f"({V} / c.sigma).d(1)"), ("w", "γ′")),
]
TURNING = """
@formula("e", on="plane")
def turning(c):
    p, w = c.p, c.w
    return det(p.d(1) * w - p * w.d(1), p.d(2) * w - p * w.d(2))
"""
#: Those that hold without the last assumption, too.
INDEPENDENT = {3, 4, 5, 13, 14}


def changed():
    """The true claims, and those that are false, each with the number of the true one."""
    for i, (kind, (first, last), assumes) in enumerate(TRUE):
        yield i, True, kind, (first, last), assumes
        for h in HARMFUL[kind]:
            yield i, False, kind, (first, f"({last}) * {h}"), assumes
            yield i, False, kind, (first, f"({last}) / {h}"), assumes
        for sign in (" - ", " + -2 * "):
            if " + " in last and EVOLUTE not in last:
                yield i, False, kind, (first, sign.join(last.split(" + "))), assumes
        if i not in INDEPENDENT and len(assumes) > 1:
            yield i, False, kind, (first, last), assumes[:-1]


def campaign(step=1):
    """The verdicts on true and on changed claims, and what is wrong."""

    def entry(names, assumes):
        return {"kind": "zero set", "formulas": names, "assumes": list(assumes)}

    return judged(TURNING, changed(), entry, step)


if __name__ == "__main__":
    sys.exit(told(*campaign()))
