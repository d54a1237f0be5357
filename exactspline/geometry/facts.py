"""What is known of one curve, each fact computed once and when it is first asked for: the forms whose zeros its
features are, these zeros, its joints and its singular points.

Nothing here is recomputed, and everything takes time linear in the segments (sorting apart). Which parameter a form
depends on is no business of this module: it asks the zero sets.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass
from threading import RLock
from time import perf_counter
from typing import Any, Generic, TypeVar, overload

from exactspline.errors import ShapeError
from exactspline.exact import mpq
from exactspline.geometry.constructions import Variant, construction
from exactspline.geometry.domain import plane, space
from exactspline.geometry.joints import (
    Ends,
    Jet,
    Joint,
    bend_of,
    curvature_of,
    distance,
    geometric_order,
    limit_direction,
    turned,
)
from exactspline.geometry.kinds import CurvePiece, Feature, FeatureKind, JointKind
from exactspline.geometry.pieces import pieces, runs
from exactspline.language.arguments import Curve
from exactspline.language.choices import Side
from exactspline.language.vector import Vector, cross
from exactspline.papers import find
from exactspline.roots.root import Root, knot_root
from exactspline.roots.zero_set import ZeroSet, jump_root, zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.lowest_terms import common_factor
from exactspline.splines.nurbs import Nurbs

T = TypeVar("T")


class Fact(Generic[T]):
    """A property that is computed once for its object, under the object's lock, and kept."""

    def __init__(self, compute: Callable[[Any], T]) -> None:
        self.compute, self.__doc__ = compute, compute.__doc__

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    @overload
    def __get__(self, facts: None, owner: type) -> Fact[T]: ...

    @overload
    def __get__(self, facts: Facts, owner: type) -> T: ...

    def __get__(self, facts: Facts | None, owner: type) -> T | Fact[T]:
        if facts is None:
            return self
        return facts.once(self.name, lambda: self.compute(facts))


@dataclass(frozen=True)
class ZeroForm:
    """A form on a curve, its zeros, and the seconds that it took to find them."""

    form: BSpline
    zeros: ZeroSet
    seconds: float

    def sign_at(self, root: Root, side: Side | str = Side.RIGHT) -> int:
        """The sign of the form at a root of whatever form (at a knot the limit from a side): from the certified zeros
        alone, nothing is evaluated.
        """
        breaks = self.form.mesh.breaks
        if root.exact is not None:
            value = self.form(root.exact, side)
            return int(value > 0) - int(value < 0)
        segment = bisect_right(breaks, root) - 1
        isolation = self.zeros.isolations[segment]
        if isolation is None:
            return 0
        found = self.zeros.roots
        position = bisect_left(found, root)
        if position < len(found) and found[position] == root:
            return 0
        before = found[position - 1] if position else None
        if before is not None and before > breaks[segment]:
            return before.signs[1] or 0
        return isolation.signs[0]

    def vanishes_on(self, breaks: Sequence[mpq]) -> list[bool]:
        """Whether the form vanishes identically between breakpoints that are at least as fine as its own."""
        mesh, isolations = self.form.mesh, self.zeros.isolations
        return [isolations[mesh.locate(a)] is None for a in breaks[:-1]]


def located(found: ZeroSet) -> list[tuple[Root, bool]]:
    """The roots of a zero set and its changes of sign by a jump, in order, each with whether it is a jump."""
    jumps = [(jump_root(jump), True) for jump in found.jumps if jump.sign_change]
    return sorted([*((root, False) for root in found), *jumps], key=lambda pair: pair[0])


def among(roots: Sequence[Root], others: Sequence[Root]) -> list[bool]:
    """Which of some roots are also among others; both in the order of the parameter."""
    found, j = [], 0
    for root in roots:
        while j < len(others) and others[j] < root:
            j += 1
        found.append(j < len(others) and others[j] == root)
    return found


class Facts:
    """The facts of one curve that its features are read from."""

    def __init__(self, curve: Nurbs) -> None:
        self.curve = curve
        self._known: dict[Any, Any] = {}
        self._lock = RLock()
        negative = curve.w(curve.domain[0]) < 0
        #: The curve as operands of formulas, with a positive weight function: forms of odd degree in (p, w) would
        #: change their sign with it.
        self.operands = Curve(
            -curve.p if negative else curve.p, -curve.w if negative else curve.w, polynomial=curve.polynomial
        )
        self.closed: bool = curve.closed
        self.breaks: tuple[mpq, ...] = curve.breakpoints

    def once(self, key: Hashable, compute: Callable[[], T]) -> T:
        """What is kept under a key, computed by the first who asks."""
        if key not in self._known:
            with self._lock:
                if key not in self._known:
                    self._known[key] = compute()
        found: T = self._known[key]
        return found

    # ---- forms

    def zero_form(self, name: str, variant: Variant | str = Variant.MINIMAL) -> ZeroForm:
        """The form of a zero-set construction, with the sign it has for a positive weight function, and its certified
        zeros; `ShapeError` for a curve of another dimension.
        """
        made = construction(name)
        {"plane": plane, "space": space}[made.curve](self.curve)

        def form() -> BSpline:
            found = made.on(self.operands, variant)
            assert isinstance(found, BSpline)
            return found

        return self.once((name, variant), lambda: self.solved(form))

    def solved(self, form: Callable[[], BSpline]) -> ZeroForm:
        """A form and its zeros, and how long they took."""
        start = perf_counter()
        f = form()
        return ZeroForm(f, zeros(f, periodic=self.closed), perf_counter() - start)

    def sign_of(self, name: str, root: Root, side: Side | str = Side.RIGHT) -> int:
        """The sign of a zero-set construction at a root of whatever form, exactly: apart from what form answers it."""
        return self.zero_form(name).sign_at(root, side)

    @Fact
    def velocity(self) -> Vector[BSpline]:
        """D1, a positive multiple of γ′."""
        return Vector(*find("D1")(self.operands))

    @Fact
    def speed(self) -> ZeroForm:
        """The common factor of the components of γ′, which vanishes where γ′ does."""
        return self.solved(lambda: common_factor(self.velocity))

    @Fact
    def binormal(self) -> Vector[BSpline]:
        """A positive multiple of γ′ × γ″, of a space curve."""
        return Vector(*find("binormal_form")(space(self.operands)))

    # ---- knots

    def sides(self, t: mpq) -> tuple[mpq, mpq]:
        """The parameters whose left and right limits meet at a knot: the same one, but for the seam."""
        a, b = self.curve.domain
        return (b, a) if self.closed and t in (a, b) else (t, t)

    @Fact
    def standing(self) -> list[bool]:
        """Segment by segment whether the curve stands still."""
        return [not any(parts) for parts in zip(*[x.polynomials for x in self.velocity], strict=True)]

    @Fact
    def ends(self) -> Ends:
        """The derivatives at both ends of every segment."""
        return Ends(self.operands)

    @Fact
    def joints(self) -> tuple[Joint, ...]:
        """All joints in the order of the parameter, the seam of a closed curve first."""
        count = len(self.breaks) - 1
        return tuple(self._joint(i - 1, i % count) for i in range(0 if self.closed else 1, count))

    @Fact
    def _joints_by_parameter(self) -> dict[mpq, Joint]:
        found = {joint.parameter: joint for joint in self.joints}
        if self.closed:
            found[self.breaks[-1]] = self.joints[0]
        return found

    def joint(self, t: mpq) -> Joint | None:
        """The joint at a parameter, None where there is none."""
        return self._joints_by_parameter.get(t)

    def _joint(self, before: int, behind: int) -> Joint:
        t, seam = self.breaks[behind], before < 0
        left, right = self.ends.jet(before, Side.LEFT), self.ends.jet(behind, Side.RIGHT)
        if left[0] != right[0]:
            return Joint(t, JointKind.GAP, -1, seam, gap=distance(left[0], right[0]))
        if self.standing[before] and self.standing[behind]:
            return Joint(t, JointKind.STILL, None, seam)
        if not any(left[1]) or not any(right[1]):
            angle = turned(*self._directions(self.velocity, t))
            return Joint(t, JointKind.SINGULAR, None if angle is None else 0, seam, angle)
        order = geometric_order(left, right)
        if order == 0:
            return Joint(t, JointKind.CORNER, 0, seam, turned(left[1], right[1]))
        curvatures = (curvature_of(left), curvature_of(right)) if order == 1 else None
        return Joint(t, self._smooth_kind(t, left, right, order), order, seam, curvatures=curvatures)

    def _smooth_kind(self, t: mpq, left: Jet, right: Jet, order: int) -> JointKind:
        """The kind of a joint with one tangent."""
        if self.curve.dimension == 3:
            a, b = bend_of(left), bend_of(right)
            if not any(a) or not any(b):
                a, b = self._directions(self.binormal, t)
            if any(a) and any(b) and any(cross(Vector(*a), Vector(*b))):
                return JointKind.TURN
        return JointKind.CONTINUOUS if order >= 2 else JointKind.CURVATURE_JUMP

    def _directions(self, v: Vector[BSpline], t: mpq) -> tuple[tuple[mpq, ...], tuple[mpq, ...]]:
        """The directions of a vector just left and just right of a knot."""
        left, right = self.sides(t)
        return limit_direction(v, left, Side.LEFT), limit_direction(v, right, Side.RIGHT)

    def binormal_limits(self, t: mpq) -> tuple[tuple[mpq, ...], tuple[mpq, ...]]:
        """The directions of the binormal just left and just right of a knot; zeros where the curve is straight."""
        return self._directions(self.binormal, t)

    # ---- singular points

    @Fact
    def singular_points(self) -> list[Feature]:
        """The parameters where γ′ = 0; of an interval on which the curve stands still its ends."""
        inner = [
            Feature(FeatureKind.CUSP if root.multiplicity % 2 else FeatureKind.STOP, root, "D1")
            for root in self.speed.zeros
            if not root.at_knot
        ]
        knots = [
            Feature(self._singular_kind(joint), knot_root(joint.parameter), "D1")
            for joint in self.joints
            if joint.kind is JointKind.SINGULAR
        ]
        if not self.closed:
            ends = zip((self.breaks[0], self.breaks[-1]), (Side.RIGHT, Side.LEFT), strict=True)
            stands = [t for t, side in ends if all(x(t, side) == 0 for x in self.velocity)]
            knots += [Feature(FeatureKind.SINGULAR_END, knot_root(t), "D1") for t in stands]
        return sorted(inner + knots, key=lambda f: f.root)

    def _singular_kind(self, joint: Joint) -> FeatureKind:
        if joint.angle is not None:
            return FeatureKind.CUSP if joint.angle.sine == 0 else FeatureKind.CORNER
        directions = self._directions(self.velocity, joint.parameter)
        return FeatureKind.STOP if all(map(any, directions)) else FeatureKind.REST

    @Fact
    def _singular_roots(self) -> list[Root]:
        return [f.root for f in self.singular_points]

    def is_singular(self, root: Root) -> bool:
        """Whether γ′ = 0 at a root (seen from one side at least)."""
        position = bisect_left(self._singular_roots, root)
        return position < len(self._singular_roots) and self._singular_roots[position] == root

    def regular(self, found: ZeroSet) -> list[tuple[Root, bool]]:
        """The roots and the changes of sign by a jump of a zero set that are no singular points (see `located`)."""
        return self.regular_pairs(located(found))

    def regular_pairs(self, found: list[tuple[Root, bool]]) -> list[tuple[Root, bool]]:
        """What is no singular point, out of roots in order."""
        singular = among([root for root, _ in found], self._singular_roots)
        return [pair for pair, here in zip(found, singular, strict=True) if not here]

    # ---- pieces

    def pieces_where_zero(self, found: ZeroForm) -> list[CurvePiece]:
        """The pieces on which a form vanishes and the curve does not stand still, cut where its curvature jumps."""
        vanishes = found.vanishes_on(self.breaks)
        holds = [zero and not still for zero, still in zip(vanishes, self.standing, strict=True)]
        joined = [joint.same_curvature for joint in self.joints]
        return pieces(self.breaks, runs(holds, joined if self.closed else [False, *joined]))

    @Fact
    def standing_pieces(self) -> list[CurvePiece]:
        """The pieces on which the curve stands still."""
        joined = [joint.kind is JointKind.STILL for joint in self.joints]
        return pieces(self.breaks, runs(self.standing, joined if self.closed else [False, *joined]))

    def check_dimension(self) -> None:
        """`ShapeError` for a curve that is neither in the plane nor in space."""
        if self.curve.dimension not in (2, 3):
            raise ShapeError(f"a curve in R{self.curve.dimension}", remedy="give a curve in the plane or in space")
