"""What the features of plane and of space curves share: singular points, what happens at knots, the zeros of a
construction's form.

On a closed curve the seam is a knot like any other and counts once.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from gmpy2 import mpq

from exactspline.geometry.continuity import CORNER, SINGULAR, limit_direction, same_direction, sides, tangent_joint
from exactspline.language.vector import Vector
from exactspline.papers import find
from exactspline.roots.root import Root, knot_root
from exactspline.roots.zero_set import zeros
from exactspline.splines.lowest_terms import common_factor


@dataclass(frozen=True)
class Feature:
    """A point of the curve: what it is, its parameter as a certified root, and how it was found.

    ``kind`` is ``cusp``, ``stop`` or ``corner`` (γ′ = 0, the direction turned round, kept, or turned by an angle),
    ``singular end`` (γ′ = 0 where the domain ends), ``rest`` (an end of a stretch on which the curve stands still),
    ``inflection``, ``undulation`` or ``flat end`` (κ = 0, its sign, in space the direction of κN, changed, kept, or the
    domain ends there), ``flat point`` (in space, at a knot: κ = 0 and neither of the first two), ``maximum`` or
    ``minimum`` (of κ), ``stationary`` (κ′ = 0, no extremum), ``torsion zero``, ``torsion touch`` or ``torsion end`` (τ
    = 0, its sign changed, kept, or the domain ends there). ``of_absolute`` is ``maximum`` or ``minimum`` of the
    absolute curvature, empty where it is neither. ``by_jump`` tells that the sign changes at a knot without a zero on
    both sides.
    """

    kind: str
    root: Root
    form: str
    by_jump: bool = False
    of_absolute: str = ""

    @property
    def at_knot(self) -> bool:
        """Whether the parameter is a knot."""
        return self.root.at_knot


def singularities(curve: Any) -> list[Feature]:
    """The parameters where γ′ = 0.

    >>> from exactspline.splines.examples import example
    >>> [(f.kind, f.root.exact) for f in singularities(example("cusp"))]
    [('cusp', mpq(1,2))]
    """
    d1 = find("D1")(curve)
    found = zeros(common_factor(d1), periodic=curve.closed)
    inner = [Feature("cusp" if root.multiplicity % 2 else "stop", root, "D1") for root in found if not root.at_knot]
    a, b = curve.domain
    seam = [a] if curve.closed else []
    stuck = [t for t in (*seam, *curve.breakpoints[1:-1]) if tangent_joint(curve, d1, t) == SINGULAR]
    knots = [Feature(_at_knot(curve, d1, t), knot_root(t), "D1") for t in stuck]
    if not curve.closed:
        stands = [t for t, side in ((a, "right"), (b, "left")) if all(c(t, side) == 0 for c in d1)]
        knots += [Feature("singular end", knot_root(t), "D1") for t in stands]
    return sorted(inner + knots, key=lambda f: f.root)


def cusps(curve: Any) -> list[Feature]:
    """The parameters where the direction of the curve turns round.

    >>> from exactspline.splines.examples import example
    >>> len(cusps(example("cusp"))), len(cusps(example("cubic_s")))
    (1, 0)
    """
    return [f for f in singularities(curve) if f.kind == "cusp"]


def _at_knot(curve: Any, d1: Vector, t: mpq) -> str:
    """Whether the direction turns round at a singular knot: by the limits of the direction on both sides."""
    left, right = sides(curve, t)
    a, b = limit_direction(d1, left, "left"), limit_direction(d1, right, "right")
    if not any(a) or not any(b):
        return "rest"
    return "stop" if same_direction(a, b) else "cusp" if same_direction(a, tuple(-x for x in b)) else CORNER
