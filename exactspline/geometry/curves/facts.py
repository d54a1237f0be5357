"""The facts of one curve, each computed once, when first needed: the forms whose zeros are the features of the curve,
these zeros, the joints and the singular points.

Every computation takes time linear in the number of segments, apart from sorting.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Sequence, Set
from dataclasses import dataclass
from functools import partial
from time import perf_counter
from typing import TypeVar, cast
from weakref import ref

from flint import fmpz

from exactspline.formulas.lifted import (
    binormal_lifted,
    critical_curvature_lifted,
    inflections_lifted,
    space_critical_curvature_lifted,
    tangent_lifted,
    torsion_zeros_lifted,
)
from exactspline.geometry.curves.angles import Angle
from exactspline.geometry.curves.joints import (
    Ends,
    Jet,
    Joint,
    Point,
    curvature_of,
    distance,
    end_direction,
    geometric_order,
    limit_direction,
    order_of,
    same_direction,
    turned,
)
from exactspline.geometry.curves.kinds import Feature, FeatureKind, JointKind
from exactspline.geometry.derived.constructions import Variant, construction
from exactspline.geometry.derived.derive import plane, space
from exactspline.language.arguments import Curve
from exactspline.language.formula import Formula
from exactspline.language.kinds import PLANE, SPACE, Kind
from exactspline.language.vector import Vector, cross
from exactspline.numbers.exact import mpq, ratio, sign
from exactspline.numbers.intervals import Side
from exactspline.numbers.once import Lock
from exactspline.one_line import OneLine
from exactspline.polynomials.bernstein import ONE, variations
from exactspline.polynomials.factors import certainly_coprime
from exactspline.programs import program
from exactspline.programs.program import Given, operands_of
from exactspline.questions.entry import CURVES, Answered, Fact, Remembers, question
from exactspline.roots.answers import CurvePiece, Places
from exactspline.roots.root import Root, knot_root
from exactspline.roots.zero_set import ZeroSet, jump_root, zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import intervals_of, runs
from exactspline.splines.lowest_terms import SplineValue, common_factor
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import of_dimension
from exactspline.words import choice

F = TypeVar("F", bound=Remembers)
_LOCK = Lock()
KINDS: dict[int, Kind] = {2: PLANE, 3: SPACE}
#: The formulas that one program computes together for a plane curve and for a space curve, at their true degrees.
TOGETHER: dict[int, tuple[Formula, ...]] = {
    2: (tangent_lifted, inflections_lifted, critical_curvature_lifted),
    3: (tangent_lifted, binormal_lifted, torsion_zeros_lifted, space_critical_curvature_lifted),
}


@dataclass(frozen=True, repr=False)
class ZeroForm(OneLine):
    """A form on a curve, its zeros, and the time that it took to find them, in seconds."""

    form: BSpline
    zeros: ZeroSet
    seconds: float

    def sign_at(self, root: Root, side: Side | str = Side.RIGHT) -> int:
        """The sign of the form at a root of any form (at a knot the limit from a side): from the certified zeros alone,
        without an evaluation.
        """
        breaks = self.form.mesh.breaks
        if root.low == root.high:
            return sign(self.form(root.low, side))
        segment = bisect_right(breaks, root.low) - 1
        if root.segment != breaks[segment : segment + 2]:
            while segment + 1 < len(breaks) - 1 and breaks[segment + 1] <= root:
                segment += 1
            if breaks[segment] == root:
                return self.sign_at(knot_root(breaks[segment]), side)
        isolation = self.zeros.isolations[segment]
        if isolation is None:
            return 0
        before = None
        for zero in self._inside(segment, len(isolation.inner)):
            if root < zero:
                break
            before = zero
        if before is None:
            return isolation.signs[0]
        return 0 if before == root else before.signs[1] or 0

    def _inside(self, segment: int, count: int) -> Sequence[Root]:
        """The number of roots strictly inside a segment."""
        if not count:
            return ()
        roots, start = self.zeros.roots, self.form.mesh.breaks[segment]
        first = bisect_left(roots, start, key=lambda zero: zero.low)
        first += roots[first].at_knot
        return roots[first : first + count]

    def vanishes_on(self, breaks: Sequence[mpq]) -> list[bool]:
        """For each interval between breakpoints, which must include those of the form, whether the form vanishes
        identically there.
        """
        mesh, isolations = self.form.mesh, self.zeros.isolations
        return [isolations[mesh.locate(a)] is None for a in breaks[:-1]]


def located(zeros: ZeroSet) -> list[tuple[Root, bool]]:
    """The roots of a zero set and its changes of sign by a jump, in order, each with True if it is a jump."""
    jumps = [(jump_root(jump), True) for jump in zeros.jumps if jump.sign_change]
    if not jumps:
        return [(root, False) for root in zeros]
    return sorted([*((root, False) for root in zeros), *jumps], key=lambda pair: pair[0])


def among(roots: Sequence[Root], others: Sequence[Root]) -> list[bool]:
    """For each of some roots whether it is also among the others; both sequences are in the order of the parameter."""
    contained, j = [], 0
    for root in roots:
        while j < len(others) and others[j] < root:
            j += 1
        contained.append(j < len(others) and others[j] == root)
    return contained


class _Kept(Remembers):
    """The results computed for one curve, and weak references to the objects that answer questions about it, as a
    parametrized curve and as a point set. (With strong references neither would be freed before the garbage collector
    runs.)
    """

    def __init__(self) -> None:
        super().__init__()
        self._readers: dict[str, Callable[[], object]] = {}

    def reader(self, make: Callable[[_Kept], F], of: str = "") -> F:
        """The object that answers questions, created if there is none yet."""
        with _LOCK.held():
            found = self._readers.get(of, lambda: None)()
            if found is None:
                found = make(self)
                self._readers[of] = ref(found)
        return cast(F, found)


def kept_by(curve: Nurbs) -> _Kept:
    """The results stored with a curve, which are not part of its value."""
    if curve.kept_analysis is None:
        # of two threads the first one sets it
        curve.kept_analysis = _Kept()
    assert isinstance(curve.kept_analysis, _Kept)
    return curve.kept_analysis


def _bend_of(jet: Jet) -> Point:
    """γ′ × γ″ of a jet in space."""
    return tuple(cross(Vector(*jet[1]), Vector(*jet[2])))


class Facts(Remembers):
    """The facts of one curve, from which its features are derived. Results are stored in `known`, which has no
    reference to the curve or to this object: both are freed when nothing else refers to them.
    """

    def __init__(self, curve: Nurbs, known: Remembers | None = None) -> None:
        super().__init__(known)
        self.curve = curve

    @property
    def again(self) -> Callable[[], Facts]:
        """A function that makes the facts of an equal curve, and holds no reference to this curve or to its results."""
        make, data = self.curve.__reduce__()
        return partial(_facts_again, make, *data)

    @Fact
    def operands(self) -> Curve[BSpline]:
        """The curve as operands of formulas, with a positive weight function: forms of odd degree in (p, w) would
        change their sign with the sign of w.
        """
        curve = self.curve
        negative = curve.w.numerators[0][0] < 0
        return Curve(-curve.p if negative else curve.p, -curve.w if negative else curve.w, polynomial=curve.polynomial)

    @Fact
    def closed(self) -> bool:
        """Whether the two ends of the curve agree."""
        return self.curve.closed

    @property
    def breaks(self) -> tuple[mpq, ...]:
        """The distinct knots of the domain, ends included."""
        return self.curve.breakpoints

    # ---- forms

    def zero_form(self, name: str, variant: Variant | str = Variant.MINIMAL) -> ZeroForm:
        """The form of a zero-set construction, and its certified zeros; the sign of the form is that for a positive
        weight function. Raises `ShapeError` for a curve of another dimension.
        """
        if isinstance(name, str) and isinstance(variant, str) and (name, variant) in self._known:
            return cast(ZeroForm, self._known[name, variant])
        made, variant = construction(name), choice(Variant, variant, "variant")
        {"plane": plane, "space": space}[made.curve](self.curve)

        def form() -> BSpline:
            return made.form_on(self.operands, variant, self.value_of, self.lowest_of)

        return self.once((name, variant), lambda: self.solved(form))

    @Fact
    def _given(self) -> Given | None:
        kind = KINDS.get(self.curve.dimension)
        return operands_of(kind, self.operands) if kind else None

    def value_of(self, formula: Formula) -> SplineValue:
        """The value of a formula on the curve (with a positive weight function)."""
        if self._given is None:
            return cast(SplineValue, formula(self.operands))
        return program.value(formula, self._given)

    def lowest_of(self, formula: Formula) -> SplineValue:
        """The value of a formula on the curve (with a positive weight function), at its true degree."""
        return self._together[formula] if formula in self._together else self.value_of(formula)

    @Fact
    def _together(self) -> dict[Formula, SplineValue]:
        kind, formulas = KINDS.get(self.curve.dimension), TOGETHER.get(self.curve.dimension, ())
        given = operands_of(kind, self.operands, true_degree=True) if kind else None
        return program.values(formulas, given) if given else {}

    def solved(self, form: Callable[[], BSpline]) -> ZeroForm:
        """A form, its zeros, and the time it took to find them."""
        start = perf_counter()
        f = form()
        return ZeroForm(f, zeros(f, periodic=self.closed), perf_counter() - start)

    def sign_of(self, name: str, root: Root, side: Side | str = Side.RIGHT) -> int:
        """The sign of a zero-set construction at a root of any form, exactly, whichever form decides it."""
        return self.zero_form(name).sign_at(root, side)

    @Fact
    def velocity(self) -> Vector[BSpline]:
        """A positive multiple of γ′."""
        return self._vector(tangent_lifted)

    @Fact
    def speed(self) -> ZeroForm:
        """The common factor of the components of γ′, which vanishes where γ′ does."""
        return self.solved(lambda: common_factor(self.velocity))

    @Fact
    def binormal(self) -> Vector[BSpline]:
        """A positive multiple of γ′ × γ″, of a space curve."""
        space(self.operands)
        return self._vector(binormal_lifted)

    def _vector(self, formula: Formula) -> Vector[BSpline]:
        value = self.lowest_of(formula)
        assert isinstance(value, Vector)
        return value

    # ---- knots

    def sides(self, t: mpq) -> tuple[mpq, mpq]:
        """The parameters whose left and right limits meet at a knot: equal except at the seam."""
        a, b = self.curve.domain
        return (b, a) if self.closed and t in (a, b) else (t, t)

    @Fact
    def standing(self) -> tuple[bool, ...]:
        """For each segment whether the curve is constant there."""
        return tuple([not any(parts) for parts in zip(*[x.numerators for x in self.velocity], strict=True)])

    @Fact
    def ends(self) -> Ends:
        """The derivatives at both ends of every segment."""
        return Ends(self.operands)

    @question(*CURVES, answered=Answered.JOINTS)
    def joints(self) -> tuple[Joint, ...]:
        """How the curve continues at every knot inside its domain and at the seam of a closed curve: kind, order of
        geometric continuity, the angle of a corner, the width of a gap, the curvatures of both sides where they differ.

        The joints are in the order of the parameter, the seam first.

        >>> from exactspline import analyse, example
        >>> [(joint.parameter, joint.order) for joint in analyse(example("straight_between_arcs")).joints]
        [(mpq(1,1), 1), (mpq(2,1), 1)]
        """
        return tuple(self._joint(i) for i in range(0 if self.closed else 1, len(self.breaks) - 1))

    def joint(self, t: mpq) -> Joint | None:
        """The joint at a parameter, None where there is none."""
        i = self._joint_at(t)
        return None if i is None else self._joint(i)

    def has_corner(self, t: mpq) -> bool:
        """Whether there is a corner at a parameter, without its angle; False proves nothing."""
        i = self._joint_at(t)
        return i is not None and self._tangents(i - 1, i) is not None

    def _joint_at(self, t: mpq) -> int | None:
        i = bisect_left(self.breaks, t)
        if self.breaks[i] != t:
            return None
        if i in (0, len(self.breaks) - 1):
            return 0 if self.closed else None
        return i

    def _joint(self, i: int) -> Joint:
        """The joint at the i-th breakpoint, 0 the seam."""
        return self.once(("joint", i), lambda: self._met(i - 1, i))

    def _met(self, before: int, behind: int) -> Joint:
        """The joint of two segments."""
        t, seam = self.breaks[behind], before < 0
        if (tangents := self._tangents(before, behind)) is not None:
            first, second = ([ratio(x, ONE) for x in tangent] for tangent in tangents)
            return Joint(t, JointKind.CORNER, 0, seam, Angle(first, second))
        left, right = self.ends.jet(before, Side.LEFT), self.ends.jet(behind, Side.RIGHT)
        if left[0] != right[0]:
            return Joint(t, JointKind.GAP, -1, seam, gap=distance(left[0], right[0]))
        if not any(left[1]) or not any(right[1]):
            # only here the forms of all segments are needed
            if self.standing[before] and self.standing[behind]:
                return Joint(t, JointKind.STILL, None, seam)
            angle = turned(*self.directions(self.velocity, t))
            return Joint(t, JointKind.SINGULAR, order_of(left, right, angle), seam, angle)
        order = geometric_order(left, right)
        if order == 0:
            return Joint(t, JointKind.CORNER, 0, seam, turned(left[1], right[1]))
        curvatures = (curvature_of(left), curvature_of(right)) if order == 1 else None
        return Joint(t, self._smooth_kind(t, left, right, order), order, seam, curvatures=curvatures)

    def tangent_continuous(self, i: int) -> bool:
        """Whether the tangent is continuous at the i-th breakpoint (0: the seam), γ′ ≠ 0 on both sides."""
        if (self.curve.p[0].continuity[i - 1] if i else 0) == 0:
            return self._tangents(i - 1, i) is None
        return self._joint(i).tangent_continuous

    def same_curvature(self, i: int) -> bool:
        """Whether tangent and curvature are continuous at the i-th breakpoint (0: the seam)."""
        return self._joint(i).same_curvature

    def _tangents(self, before: int, behind: int) -> tuple[tuple[fmpz, ...], tuple[fmpz, ...]] | None:
        """The tangent directions of two segments that certainly meet, if the directions differ and γ′ ≠ 0 on both
        sides; None proves nothing.
        """
        if before >= 0 and self.curve.p[0].continuity[before]:
            return None
        left = end_direction(self.operands, before, Side.LEFT)
        right = end_direction(self.operands, behind, Side.RIGHT)
        return (left, right) if any(left) and any(right) and not same_direction(left, right) else None

    def _smooth_kind(self, t: mpq, left: Jet, right: Jet, order: int) -> JointKind:
        """The kind of a joint with a common tangent."""
        if self.curve.dimension == 3:
            a, b = _bend_of(left), _bend_of(right)
            if not any(a) or not any(b):
                a, b = self.directions(self.binormal, t)
            if any(a) and any(b) and any(cross(Vector(*a), Vector(*b))):
                return JointKind.TURN
        return JointKind.CONTINUOUS if order >= 2 else JointKind.CURVATURE_JUMP

    def directions(self, v: Vector[BSpline], t: mpq) -> tuple[tuple[mpq, ...], tuple[mpq, ...]]:
        """The directions of a vector just left and just right of a knot."""
        left, right = self.sides(t)
        return limit_direction(v, left, Side.LEFT), limit_direction(v, right, Side.RIGHT)

    # ---- singular points

    @question(*CURVES, proof=lambda facts: (facts.speed.zeros,))
    def singular_points(self) -> Places[Feature]:
        """The points with γ′ = 0.

        ``cusp``, ``stop`` or ``corner``: the direction of the curve is reversed, kept, or turned by another angle;
        ``rest``: an end of an interval on which the curve is constant; ``singular end``: the domain ends there.

        >>> from exactspline import analyse, example
        >>> [(f.kind.value, f.root.exact) for f in analyse(example("cusp")).singular_points]
        [('cusp', mpq(1,2))]
        """
        inner = [
            Feature(FeatureKind.CUSP if root.multiplicity % 2 else FeatureKind.STOP, root, "D1")
            for root in (() if self._moves_between_knots else self.speed.zeros)
            if not root.at_knot
        ]
        resting = [joint for joint in map(self._joint, self._knots_at_rest) if joint.kind is JointKind.SINGULAR]
        knots = [Feature(self._singular_kind(joint), knot_root(joint.parameter), "D1") for joint in resting]
        if not self.closed:
            ends = [(x.numerators, x.degree) for x in self.velocity]
            stands = all(c[0][0] == 0 for c, _ in ends), all(c[-1][n] == 0 for c, n in ends)
            where = [t for t, still in zip((self.breaks[0], self.breaks[-1]), stands, strict=True) if still]
            knots += [Feature(FeatureKind.SINGULAR_END, knot_root(t), "D1") for t in where]
        return Places(tuple(sorted(inner + knots, key=lambda f: f.root)), self.standing_pieces)

    @question(*CURVES, part_of="singular_points", proof=lambda facts: (facts.speed.zeros,))
    def cusps(self) -> Places[Feature]:
        """The singular points at which the direction of the curve is reversed.

        >>> from exactspline import analyse, example
        >>> len(analyse(example("cusp")).cusps), len(analyse(example("cubic_s")).cusps)
        (1, 0)
        """
        return Places(tuple(f for f in self.singular_points if f.kind is FeatureKind.CUSP))

    @question(*CURVES, answered=Answered.JOINTS, part_of="joints")
    def corners(self) -> tuple[Joint, ...]:
        """The joints at which the direction of the tangent jumps, whether or not γ′ = 0 there, each with its angle.

        >>> from exactspline import Nurbs, analyse
        >>> square = Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)])
        >>> [(joint.parameter, joint.angle.degrees(5)) for joint in analyse(square).corners][:2]
        [(mpq(0,1), mpf('90.0')), (mpq(1,1), mpf('90.0'))]
        """
        self.check_dimension()
        smooth = [0, *self.curve.p[0].continuity]
        corners = []
        for i in range(0 if self.closed else 1, len(self.breaks) - 1):
            left = end_direction(self.operands, i - 1, Side.LEFT)
            right = end_direction(self.operands, i, Side.RIGHT)
            meets = smooth[i] > 0 or (smooth[i] == 0 and same_direction(left, right))
            if not (meets and any(left) and any(right)) and (joint := self._joint(i)).angle is not None:
                corners.append(joint)
        return tuple(corners)

    @property
    def _moves_between_knots(self) -> bool:
        """A quick test that γ′ ≠ 0 strictly between knots: a component has coefficients of one sign there, or two
        components have no common factor; False proves nothing.
        """
        return all(
            any(c and variations(c) == 0 for c in parts) or bool(parts[0] and certainly_coprime(parts[0], parts[1]))
            for parts in zip(*[x.numerators for x in self.velocity], strict=True)
        )

    @property
    def _knots_at_rest(self) -> list[int]:
        """The breakpoints, including a closed curve's seam, at which γ′ = 0 on at least one side."""
        ends = [(x.numerators, x.degree) for x in self.velocity]
        count = len(self.breaks) - 1
        return [
            i
            for i in range(0 if self.closed else 1, count)
            if all(c[i][0] == 0 for c, _ in ends) or all(c[i - 1][n] == 0 for c, n in ends)
        ]

    def _singular_kind(self, joint: Joint) -> FeatureKind:
        if joint.angle is not None:
            return FeatureKind.CUSP if joint.angle.reverses else FeatureKind.CORNER
        return FeatureKind.STOP if all(map(any, self.directions(self.velocity, joint.parameter))) else FeatureKind.REST

    @Fact
    def _singular_roots(self) -> list[Root]:
        return [f.root for f in self.singular_points]

    def is_singular(self, root: Root) -> bool:
        """Whether γ′ = 0 at a root (as a limit from at least one side)."""
        position = bisect_left(self._singular_roots, root)
        return position < len(self._singular_roots) and self._singular_roots[position] == root

    def regular(self, zeros: ZeroSet) -> list[tuple[Root, bool]]:
        """The roots and the changes of sign by a jump of a zero set that are not singular points (see `located`)."""
        return self.regular_pairs(located(zeros))

    def regular_pairs(self, located_roots: list[tuple[Root, bool]]) -> list[tuple[Root, bool]]:
        """The roots, in order, that are not singular points."""
        singular = among([root for root, _ in located_roots], self._singular_roots)
        return [pair for pair, here in zip(located_roots, singular, strict=True) if not here]

    # ---- pieces

    def pieces_where_zero(self, zero_form: ZeroForm) -> list[CurvePiece]:
        """The pieces on which a form vanishes and the curve is not constant, cut where its curvature jumps."""
        if not zero_form.zeros.intervals:
            return []
        vanishes = zero_form.vanishes_on(self.breaks)
        holds = [zero and not still for zero, still in zip(vanishes, self.standing, strict=True)]

        def joined(i: int) -> bool:
            """Whether a piece continues across the i-th breakpoint; called only where both segments belong to it."""
            if not (holds[i - 1] and holds[i]) or (i == 0 and not self.closed):
                return False
            return self._tangents(i - 1, i) is None and self._joint(i).same_curvature

        return self.pieces_where(holds, [joined(i) for i in range(len(holds))])

    def straight_runs(self, straight: Set[int]) -> tuple[CurvePiece, ...]:
        """The straight pieces of the curve, given its straight segments, on which γ′ ≠ 0."""
        holds = [i in straight for i in range(len(self.breaks) - 1)]

        def joined(i: int) -> bool:
            return holds[i - 1] and holds[i] and (i > 0 or self.closed) and self.tangent_continuous(i)

        return tuple(self.pieces_where(holds, [joined(i) for i in range(len(holds))]))

    def pieces_where(self, holds: Sequence[bool], joined: Sequence[bool]) -> list[CurvePiece]:
        """The maximal pieces made of segments on which something holds (see `runs`)."""
        return [CurvePiece(intervals_of(self.breaks, *run)) for run in runs(holds, joined)]

    @question(*CURVES, answered=Answered.PIECES, of_piece="stands still")
    def standing_pieces(self) -> tuple[CurvePiece, ...]:
        """The pieces on which the curve is constant."""
        if not any(self.standing):
            return ()
        joined = [joint.kind is JointKind.STILL for joint in self.joints]
        return tuple(self.pieces_where(self.standing, joined if self.closed else [False, *joined]))

    def check_dimension(self) -> None:
        """Raise `ShapeError` for a curve that is neither in the plane nor in space."""
        of_dimension(self.curve, "give a curve in the plane or in space", 2, 3)


def _facts_again(make: Callable[..., Nurbs], *data: object) -> Facts:
    """The facts of a curve, which is made from its data again."""
    return facts_of(make(*data))


def facts_of(curve: Nurbs) -> Facts:
    """The facts of a curve, shared by everything that asks for them.

    >>> from exactspline import example
    >>> facts_of(example("straight_between_arcs")).tangent_continuous(1)
    True
    """
    return Facts(curve, kept_by(curve))
