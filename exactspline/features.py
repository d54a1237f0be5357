"""Points of interest of a plane curve: singular points, inflections, extrema of the curvature, each certified and told apart exactly.

All are zeros of a form of the curve (see `exactspline.constructions`), found by `exactspline.zeros`; a zero where γ′ vanishes is a singular point and
nothing else. On a closed curve the seam is a knot like any other and counts once.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from flint import fmpz_poly
from gmpy2 import mpq

from exactspline.constructions import MINIMAL, construction
from exactspline.form import ONE, raiser
from exactspline.formulas import find
from exactspline.interrogate import plane
from exactspline.language import Vector
from exactspline.spline import BSpline
from exactspline.zeros import Jump, Root, ZeroSet, zeros

#: The form whose sign is that of κκ′; the sign of all others is that of κ′, with the paper's f2 and g2 an odd power of w away from it.
SQUARING, PAPER = "squaring", "paper"
#: What can happen at a knot, from bad to good.
GAP, CORNER, SINGULAR, CURVATURE_JUMP, CONTINUOUS = "gap", "corner", "singular", "jump of the curvature", "continuous curvature"


@dataclass(frozen=True)
class Feature:
    """A point of the curve: what it is, its parameter as a certified root, and how it was found.

    ``kind`` is ``cusp``, ``stop`` or ``corner`` (γ′ = 0, the direction turned round, kept, or turned by an angle), ``singular end`` (γ′ = 0 where
    the domain ends), ``rest`` (an end of a stretch on which the curve stands still), ``inflection``, ``undulation`` or ``flat end`` (κ = 0, its
    sign changed, kept, or the domain ends there), ``maximum`` or ``minimum`` (of κ), ``stationary`` (κ′ = 0, no extremum). ``of_absolute`` is
    ``maximum`` or ``minimum`` of the absolute curvature, empty where it is neither. ``by_jump`` tells that the sign changes at a knot without a
    zero on both sides.
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

    Raises `ShapeError` for a curve that is not in the plane.
    """
    common = _common_factor(find("D1")(plane(curve)))
    found = zeros(common, periodic=curve.closed)
    inner = [Feature("cusp" if root.multiplicity % 2 else "stop", root, "D1") for root in found if not root.at_knot]
    a, b = curve.domain
    seam = [a] if curve.closed else []
    knots = [Feature(_at_knot(curve, t), _knot_root(t), "D1") for t in (*seam, *curve.breakpoints[1:-1]) if joint(curve, t) == SINGULAR]
    if not curve.closed:
        stands = [t for t, side in ((a, "right"), (b, "left")) if all(c(t, side) == 0 for c in find("D1")(curve))]
        knots += [Feature("singular end", _knot_root(t), "D1") for t in stands]
    return sorted(inner + knots, key=lambda f: f.root)


def cusps(curve: Any) -> list[Feature]:
    """The parameters where the direction of the curve turns round.

    >>> from exactspline.curves import example
    >>> len(cusps(example("cusp"))), len(cusps(example("cubic_s")))
    (1, 0)
    """
    return [f for f in singularities(curve) if f.kind == "cusp"]


def _common_factor(v: Vector) -> BSpline:
    """A spline that vanishes exactly where all components do: their greatest common divisor, segment by segment."""
    rows = []
    for parts in zip(*[c.polynomials for c in v], strict=True):
        common = fmpz_poly([])
        for c in parts:
            common = common.gcd(c)
        at_end = min((x.degree - c.degree() for x, c in zip(v, parts, strict=True) if c), default=0)
        rows.append((common, max(common.degree(), 0) + at_end))
    n, mesh = max(degree for _, degree in rows), v[0].mesh
    return BSpline.from_forms(n, mesh, (-1,) * (len(mesh) - 1), [(c * raiser(n - degree), ONE) for c, degree in rows])


def _knot_root(t: mpq) -> Root:
    return Root(t, t, (1, 1), (0, 0))


def _sides(curve: Any, t: mpq) -> tuple[mpq, mpq]:
    """The parameters whose left and right limits meet at a knot: the same one, but for the seam of a closed curve."""
    a, b = curve.domain
    return (b, a) if curve.closed and t in (a, b) else (t, t)


def joint(curve: Any, t: mpq) -> str:
    """What happens at a knot: a gap, a corner, a singular point, a jump of the curvature, or nothing up to second order.

    >>> from exactspline.curves import example
    >>> joint(example("circle"), mpq(1)), joint(example("jump"), mpq(1))
    ('continuous curvature', 'gap')
    """
    left, right = _sides(curve, t)
    if curve(left, "left") != curve(right, "right"):
        return GAP
    d1, kappa = find("D1")(curve), find("curvature_squared")(curve)
    (ax, ay), (bx, by) = [tuple(c(s, side) for c in d1) for s, side in ((left, "left"), (right, "right"))]
    if ax == ay == 0 or bx == by == 0:
        return SINGULAR
    if ax * by != ay * bx or ax * bx + ay * by < 0:
        return CORNER
    turning = find("f2")(curve)
    signs = [(turning * curve.w)(s, side) for s, side in ((left, "left"), (right, "right"))]
    same = kappa(left, "left") == kappa(right, "right") and signs[0] * signs[1] >= 0
    return CONTINUOUS if same else CURVATURE_JUMP


def _at_knot(curve: Any, t: mpq) -> str:
    """Whether the direction turns round at a singular knot: by the limits of the direction on both sides."""
    left, right = _sides(curve, t)
    (ax, ay), (bx, by) = _direction(curve, left, "left"), _direction(curve, right, "right")
    if ax == ay == 0 or bx == by == 0:
        return "rest"
    return "stop" if ax * by == ay * bx and ax * bx + ay * by > 0 else "cusp" if ax * by == ay * bx else CORNER


def _direction(curve: Any, t: mpq, side: str) -> tuple[mpq, mpq]:
    """The first derivative of γ that does not vanish, as a direction of motion."""
    for order in range(1, 2 * curve.degree + 2):
        x, y = (c.d(order - 1)(t, side) for c in find("D1")(curve))
        if x or y:
            backwards = side == "left" and order % 2 == 0
            return (-x, -y) if backwards else (x, y)
    return mpq(0), mpq(0)


def zero_form(curve: Any, name: str, form: str = MINIMAL) -> tuple[BSpline, ZeroSet]:
    """The form of a zero-set construction on a curve, and its certified zeros."""
    f = construction(name).on(plane(curve), form)
    if form == PAPER and curve.w(curve.domain[0]) < 0:
        f = -f
    return f, zeros(f, periodic=curve.closed)


def inflections(curve: Any, form: str = MINIMAL) -> list[Feature]:
    """The zeros of the curvature at regular points: inflections, and undulations where its sign stays.

    At a knot with a common tangent the curvature may change its sign by a jump. Pieces that are straight are not listed here (`straight_pieces`).

    >>> from exactspline.curves import example
    >>> [f.kind for f in inflections(example("six_segment_cubic"))]
    ['inflection', 'inflection']

    Raises `ShapeError` for a curve that is not in the plane.
    """
    singular = {f.root for f in singularities(curve)}
    _, found = zero_form(curve, "zero_curvature", form)
    features = [Feature(_flat(root), root, form) for root in found if root not in singular and _tangent_at(curve, root)]
    for jump in found.jumps:
        if jump.sign_change and joint(curve, jump.parameter) in (CURVATURE_JUMP, CONTINUOUS):
            features.append(Feature("inflection", _jump_root(jump), form, by_jump=True))
    return sorted(features, key=lambda f: f.root)


def _tangent_at(curve: Any, root: Root) -> bool:
    """Whether the curve has one tangent at a root: everywhere but at knots that are gaps, corners or singular."""
    return not root.at_knot or not _inside(curve, root.low) or joint(curve, root.low) in (CURVATURE_JUMP, CONTINUOUS)


def _flat(root: Root) -> str:
    if None in root.signs:
        return "flat end"
    return "inflection" if root.sign_change else "undulation"


def straight_pieces(curve: Any) -> list[tuple[mpq, mpq]]:
    """The intervals on which the curve is straight.

    >>> from exactspline.curves import example
    >>> straight_pieces(example("straight_between_arcs"))
    [(mpq(1,1), mpq(2,1))]
    """
    return _split_at_joints(curve, zero_form(curve, "zero_curvature")[1])


def constant_pieces(curve: Any) -> list[tuple[mpq, mpq]]:
    """The intervals on which the curvature is constant: circular arcs and straight pieces."""
    return _split_at_joints(curve, zero_form(curve, "critical_curvature")[1])


def _split_at_joints(curve: Any, found: ZeroSet) -> list[tuple[mpq, mpq]]:
    """The stretches of a zero set, cut at the knots where the curve is not smooth to second order."""
    pieces: list[tuple[mpq, mpq]] = []
    for stretch in found.stretches:
        cuts = [t for t in curve.breakpoints[1:-1] if stretch.low < t < stretch.high and joint(curve, t) != CONTINUOUS]
        pieces += pairwise([stretch.low, *cuts, stretch.high])
    return pieces


def curvature_extrema(curve: Any, form: str = MINIMAL) -> list[Feature]:
    """The extrema of the curvature: inside segments, and at knots where κ is continuous and κ′ changes its sign, with or without a jump.

    >>> from exactspline.curves import example
    >>> found = curvature_extrema(example("six_segment_cubic"))
    >>> len(found), sum(f.by_jump for f in found)
    (8, 2)
    >>> [f.kind for f in curvature_extrema(example("ellipse"))]
    ['maximum', 'minimum', 'maximum', 'minimum']

    Raises `ShapeError` for a curve that is not in the plane.
    """
    return [f for f in critical_points(curve, form) if f.kind != "stationary"]


def critical_points(curve: Any, form: str = MINIMAL) -> list[Feature]:
    """The extrema of the curvature and the points where κ′ = 0 without an extremum (``stationary``)."""
    singular = {f.root for f in singularities(curve)}
    _, found = zero_form(curve, "critical_curvature", form)
    true = list(zero_form(curve, "critical_curvature")[1]) if form == SQUARING else []
    features = []
    for solved in found:
        # squaring adds roots where κ = 0; what remains is judged by κ′ itself
        root = next((r for r in true if r == solved), None) if form == SQUARING else solved
        if root is None or root in singular or (root.at_knot and _inside(curve, root.low) and joint(curve, root.low) != CONTINUOUS):
            continue
        features.append(_extremum(curve, root, form, by_jump=False))
    for jump in found.jumps:
        if jump.sign_change and joint(curve, jump.parameter) == CONTINUOUS:
            features.append(_extremum(curve, _jump_root(jump), form, by_jump=True))
    return sorted(features, key=lambda f: f.root)


def _inside(curve: Any, t: mpq) -> bool:
    return curve.closed or t not in curve.domain


def _jump_root(jump: Jump) -> Root:
    t = jump.parameter
    return Root(t, t, (jump.left.multiplicity, jump.right.multiplicity), (jump.left.sign, jump.right.sign))


def _extremum(curve: Any, root: Root, form: str, *, by_jump: bool) -> Feature:
    left, right = root.signs
    if left is None or right is None or left * right >= 0:
        return Feature("stationary", root, form)
    sign = curvature_sign(curve, root)
    if form == SQUARING and by_jump:
        left *= sign
    if left == 0:
        return Feature("stationary", root, form)
    kind = "maximum" if left > 0 else "minimum"
    if sign == 0:
        return Feature(kind, root, form, by_jump, "minimum")
    return Feature(kind, root, form, by_jump, kind if sign > 0 else {"maximum": "minimum", "minimum": "maximum"}[kind])


def curvature_sign(curve: Any, root: Root) -> int:
    """The sign of κ at a root of another form, exactly: 0 when the root is one of the curvature's too."""
    turning = find("f2")(curve) * curve.w
    if root.exact is not None:
        return _sign(turning(root.exact))
    if any(root == other for other in zeros(turning)):
        return 0
    digits = 10
    while True:
        low, high = root.refine(digits)
        if not any(low <= other.low <= high or low <= other.high <= high for other in zeros(turning.restrict(low, high))) or low == high:
            return _sign(turning((low + high) / 2))
        digits *= 2


def _sign(value: mpq) -> int:
    return int(value > 0) - int(value < 0)
