"""False identities of derivatives of frames and of a focal curve, each a true one with one thing changed.

python -m tests.campaigns.derivatives

The right side of a true identity is multiplied by something, something is added to it, or it is derived once more or
less. The exit status is 1 where a changed one is PROVED, or a true one is not.
"""

import sys

from tests.support.changed_claims import judged, told

#: The sentence of the documentation that is judged.
COMPARED = ("left = factor · right",)
SIDES = ("left", "right")
V, A, J = "c.gamma.d(1)", "c.gamma.d(2)", "c.gamma.d(3)"
B = f"cross({V}, {A})"
FORMULAS = f"""
@formula("frame", on="framed space")
def t(c):
    return {V} / c.sigma
@formula("frame", on="framed space")
def b(c):
    return {B} / c.rho
@formula("frame", on="framed space")
def n(c):
    return cross(b(c), t(c))
@formula("Gram and Schmidt", on="framed space")
def by_projection(c):
    return ({A} - {V} * (dot({A}, {V}) / norm2({V}))) * c.sigma / c.rho
@formula("frame", on="framed space")
def k(c):
    return c.rho / c.sigma ** 3
@formula("frame", on="framed space")
def w(c):
    return det({V}, {A}, {J}) / c.rho ** 2
@formula("Darboux", on="framed space")
def darboux(c):
    return (t(c) * w(c) + b(c) * k(c)) * c.sigma
@formula("centre of the osculating sphere", on="space")
def centre(c):
    return c.gamma + (cross({J}, {V}) * norm2({V}) + {B} * (3 * dot({V}, {A}))) / det({V}, {A}, {J})
@formula("binormal", on="space")
def line(c):
    return {B}
@formula("E′ = λ γ′×γ″", on="space")
def scale(c):
    return centre(c).d(1)[0] / line(c)[0]
"""
TRUE = [
    ("framed space", "t(c).d(1)", "n(c) * (k(c) * c.sigma)"),
    ("framed space", "n(c).d(1)", "(b(c) * w(c) - t(c) * k(c)) * c.sigma"),
    ("framed space", "b(c).d(1)", "n(c) * (w(c) * c.sigma * -1)"),
    ("framed space", "by_projection(c).d(1)", "n(c).d(1)"),
    ("framed space", "by_projection(c).d(2)", "n(c).d(2)"),
    ("framed space", "t(c).d(1)", "cross(darboux(c), t(c))"),
    ("framed space", "n(c).d(1)", "cross(darboux(c), n(c))"),
    ("framed space", "b(c).d(1)", "cross(darboux(c), b(c))"),
    ("framed space", "dot(n(c).d(1), n(c).d(1))", "(k(c) ** 2 + w(c) ** 2) * c.sigma ** 2"),
    ("framed space", "dot(n(c).d(1), b(c))", "w(c) * c.sigma"),
    ("space", "centre(c).d(1)", "line(c) * scale(c)"),
    ("space", "det(centre(c).d(1), centre(c).d(2), centre(c).d(3))", "det({0}, {0}.d(1), {0}.d(2)) * scale(c) ** 3"),
]
TRUE = [(kind, left, right.format("line(c)")) for kind, left, right in TRUE]
SCALES = {
    "framed space": ["2", "-1", "c.sigma", "(1 / c.rho)", "k(c)", f"(1 + dot({V}, {A}))", "(c.w ** 2)"],
    "space": ["2", "-1", "scale(c)", f"(1 / norm2({V}))", f"(1 + dot({V}, {A}))"],
}
TERMS = {"framed space": ["t(c)", "b(c)", "n(c) * w(c)"], "space": [V, "line(c)"]}


def changed():
    """The true identities, and those that are false, each with the number of the true one."""
    for i, (kind, left, right) in enumerate(TRUE):
        yield i, True, kind, (left, right)
        for scale in SCALES[kind]:
            yield i, False, kind, (left, f"({right}) * {scale}")
        for term in TERMS[kind]:
            scalar = left.startswith(("dot", "det"))
            yield i, False, kind, (left, f"{right} + {f'norm2({term})' if scalar else term}")
        yield i, False, kind, (left, f"({right}).d(1)")
        if "d(2)" not in left:
            yield i, False, kind, (f"({left}).d(1)", right)


def campaign(step=1):
    """The verdicts on true and on changed identities, and what is wrong."""
    return judged(FORMULAS, changed(), lambda names: {"kind": "identity"} | dict(zip(SIDES, names, strict=True)), step)


if __name__ == "__main__":
    sys.exit(told(*campaign()))
