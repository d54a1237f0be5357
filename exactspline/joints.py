"""What the features of plane and of space curves share: singular points, what happens at knots, the zeros of a construction's form.

On a closed curve the seam is a knot like any other and counts once.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from flint import fmpz_poly
from gmpy2 import mpq

from exactspline.constructions import MINIMAL, construction
from exactspline.form import ONE, raiser
from exactspline.formulas import find
from exactspline.interrogate import plane, space
from exactspline.language import Curve, Vector
from exactspline.spline import BSpline
from exactspline.zeros import Jump, Root, ZeroSet, zeros

#: What can happen at a knot, from bad to good; the turn of the osculating plane in space only.
GAP, CORNER, SINGULAR, TURN = "gap", "corner", "singular", "jump of the osculating plane"
CURVATURE_JUMP, CONTINUOUS = "jump of the curvature", "continuous curvature"


@dataclass(frozen=True)
class Feature:
    """A point of the curve: what it is, its parameter as a certified root, and how it was found.

    ``kind`` is ``cusp``, ``stop`` or ``corner`` (γ′ = 0, the direction turned round, kept, or turned by an angle), ``singular end`` (γ′ = 0 where
    the domain ends), ``rest`` (an end of a stretch on which the curve stands still), ``inflection``, ``undulation`` or ``flat end`` (κ = 0, its
    sign, in space the direction of κN, changed, kept, or the domain ends there), ``flat point`` (in space, at a knot: κ = 0 and neither of the
    first two), ``maximum`` or ``minimum`` (of κ), ``stationary`` (κ′ = 0, no extremum), ``torsion zero``, ``torsion touch`` or ``torsion end``
    (τ = 0, its sign changed, kept, or the domain ends there). ``of_absolute`` is ``maximum`` or ``minimum`` of the absolute curvature, empty where
    it is neither. ``by_jump`` tells that the sign changes at a knot without a zero on both sides.
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

    >>> from exactspline.curves import example
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

    >>> from exactspline.curves import example
    >>> len(cusps(example("cusp"))), len(cusps(example("cubic_s")))
    (1, 0)
    """
    return [f for f in singularities(curve) if f.kind == "cusp"]


def common_factor(v: Vector) -> BSpline:
    """A spline that vanishes exactly where all components do: their greatest common divisor, segment by segment.

    >>> t = BSpline.identity(0, 1)
    >>> common_factor(Vector(t * (t + 1), t * (t + 2))).true_degree
    1
    """
    rows = []
    for parts in zip(*[c.polynomials for c in v], strict=True):
        common = fmpz_poly([])
        for c in parts:
            common = common.gcd(c)
        at_end = min((x.degree - c.degree() for x, c in zip(v, parts, strict=True) if c), default=0)
        rows.append((common, max(common.degree(), 0) + at_end))
    n, mesh = max(degree for _, degree in rows), v[0].mesh
    return BSpline.from_forms(n, mesh, (-1,) * (len(mesh) - 1), [(c * raiser(n - degree), ONE) for c, degree in rows])


def knot_root(t: mpq) -> Root:
    """A knot as a root."""
    return Root(t, t, (1, 1), (0, 0))


def jump_root(jump: Jump) -> Root:
    """The knot of a jump as a root, with the signs on both sides."""
    t = jump.parameter
    return Root(t, t, (jump.left.multiplicity, jump.right.multiplicity), (jump.left.sign, jump.right.sign))


def sides(curve: Any, t: mpq) -> tuple[mpq, mpq]:
    """The parameters whose left and right limits meet at a knot: the same one, but for the seam of a closed curve."""
    a, b = curve.domain
    return (b, a) if curve.closed and t in (a, b) else (t, t)


def inside(curve: Any, t: mpq) -> bool:
    """Whether the curve goes on at both sides of a parameter."""
    return curve.closed or t not in curve.domain


def tangent_joint(curve: Any, d1: Vector, t: mpq) -> str:
    """What happens at a knot up to first order: a gap, a singular point, a corner, or nothing (then the text is empty); `d1` is D1 of the curve."""
    left, right = sides(curve, t)
    if curve(left, "left") != curve(right, "right"):
        return GAP
    a, b = tuple(c(left, "left") for c in d1), tuple(c(right, "right") for c in d1)
    if not any(a) or not any(b):
        return SINGULAR
    return "" if same_direction(a, b) else CORNER


def same_direction(a: Sequence[mpq], b: Sequence[mpq]) -> bool:
    """Whether two vectors that are not zero point the same way (exactly: a·b > 0 and (a·b)² = ‖a‖²‖b‖²).

    >>> same_direction((1, 2), (2, 4)), same_direction((1, 2), (-1, -2))
    (True, False)
    """
    product = sum(x * y for x, y in zip(a, b, strict=True))
    return bool(product > 0 and product**2 == sum(x * x for x in a) * sum(y * y for y in b))


def limit_direction(v: Vector, t: mpq, side: str) -> tuple[mpq, ...]:
    """The direction in which a vector points just beside a parameter; zeros where it vanishes all along that side.

    >>> s = BSpline.identity(-1, 1)
    >>> limit_direction(Vector(s, s * s), mpq(0), "left")
    (mpq(-1,1), mpq(0,1))
    """
    for order in range(v.degree + 1):
        values = tuple(c.d(order)(t, side) for c in v)
        if any(values):
            return tuple(-x for x in values) if side == "left" and order % 2 else values
    return (mpq(0),) * len(v)


def _at_knot(curve: Any, d1: Vector, t: mpq) -> str:
    """Whether the direction turns round at a singular knot: by the limits of the direction on both sides."""
    left, right = sides(curve, t)
    a, b = limit_direction(d1, left, "left"), limit_direction(d1, right, "right")
    if not any(a) or not any(b):
        return "rest"
    return "stop" if same_direction(a, b) else "cusp" if same_direction(a, tuple(-x for x in b)) else CORNER


def zero_form(curve: Any, name: str, form: str = MINIMAL) -> tuple[BSpline, ZeroSet]:
    """The form of a zero-set construction on a curve, with the sign it has for a positive weight function, and its certified zeros.

    Raises `ShapeError` for a curve of another dimension.
    """
    made = construction(name)
    {"plane": plane, "space": space}[made.curve](curve)
    f = made.on(_with_positive_weight(curve), form)
    return f, zeros(f, periodic=curve.closed)


def _with_positive_weight(curve: Any) -> Any:
    """The same curve as operands, (p, w) replaced by (−p, −w) where w is negative: forms of odd degree in (p, w) change their sign with it."""
    return curve if curve.w(curve.domain[0]) > 0 else Curve(-curve.p, -curve.w, polynomial=curve.polynomial)


def split_at_joints(curve: Any, found: ZeroSet, smooth: Callable[[mpq], bool]) -> list[tuple[mpq, mpq]]:
    """The stretches of a zero set, cut at the inner knots that are not smooth."""
    pieces: list[tuple[mpq, mpq]] = []
    for stretch in found.stretches:
        cuts = [t for t in curve.breakpoints[1:-1] if stretch.low < t < stretch.high and not smooth(t)]
        pieces += pairwise([stretch.low, *cuts, stretch.high])
    return pieces
