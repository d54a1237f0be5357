"""Common zeros of several forms on a patch by exact subdivision in Bernstein form: simple zeros, each certified in a
box, and small boxes that contain all other zeros.

A box is excluded if the coefficients of a form are all positive or all negative. This is tried for each given form, and
for the combinations of two forms by the inverse of their Jacobian on the box. Near a simple zero of the two forms the
combinations G₁, G₂ are approximately ``x − x₀`` and ``y − y₀``: if the ranges of their derivatives are strictly
diagonally dominant, there is at most one zero, and if G₁ has opposite signs on the left and right sides and G₂ on the
lower and upper sides, there is at least one (Miranda). All computations are in integers; computations that only exclude
boxes use rounded integers.

A zero is certified if Krawczyk's operator contracts a box around it by a fixed factor; then refinement terminates.

Source: Miranda, Un'osservazione su un teorema di Brouwer, Bollettino UMI 1940; Mourrain and Pavone, Subdivision methods
for solving polynomial equations, 2009 (the preconditioning).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial, reduce
from itertools import combinations, islice
from typing import NamedTuple

from flint import fmpz

from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.numbers.search import Search
from exactspline.polynomials.cost import affords, height_bits
from exactspline.polynomials.patch_forms import PatchForm, Sized, halved, rounded

#: The fraction of its width by which a box is enlarged on each side before certification.
MARGIN = mpq(1, 4)
#: The number of bisections of a box after which all pairs of forms are tried, not only the most promising pair.
FEW = 16
#: The number of bisections after which a box is small; and the number of small boxes, per square of the number of
#: coefficients of a form, beyond which elimination is cheaper.
SMALL, PER_SQUARE = 4, 1 / 16
#: The maximal number of bisections of a box, and of boxes, after which the remaining boxes are reported as undecided.
DEPTH, BOXES = 48, 5000
#: The cost of bisecting a patch: nanoseconds per coefficient, and in addition per 100 bits of a coefficient.
HALVING, HALVING_BITS = 4000, 500
#: The precision (bits) of a box at which a simple rational zero is searched for, and the largest denominator tried.
SIMPLE_BITS, SIMPLE = 32, 4096
#: The contraction factor of Krawczyk's operator required for certification.
KEPT = 3, 4
#: Half the sides of a box in which a zero near a point is expected.
NARROW = mpq(1, 1 << 120)

Pair = tuple[PatchForm, PatchForm]


class Isolated:
    """A common zero of two forms of the same degree: the only one in `region`.

    The box shrinks when the zero is refined; everything else is immutable.
    """

    __slots__ = ("_box", "_exact", "at", "forms", "region")

    def __init__(self, forms: Pair, region: Box, at: tuple[int, int] = (0, 1)) -> None:
        #: `at` are the indices of the two forms among the given forms.
        self.forms, self.region, self.at, self._box = forms, region, at, region
        self._exact: tuple[mpq, mpq] | None = None

    @property
    def box(self) -> Box:
        """The smallest box computed so far."""
        return self._box

    @property
    def exact(self) -> tuple[mpq, mpq] | None:
        """Both coordinates if they are simple rational numbers (verified by evaluation), else None."""
        if self._exact is None:
            box = self.refine(SIMPLE_BITS)
            place = simplest(*box[0]), simplest(*box[1])
            simple = max(x.denominator for x in place) <= SIMPLE
            if simple and all(f.value(*place) == 0 for f in self.forms):
                self._exact = place
                self._box = Box.point(*place)
        return self._exact

    def refine(self, bits: int) -> Box:
        """A box that contains the zero, with sides of length at most ``2^−bits``."""
        limit = mpq(1, 1 << max(bits, 0))
        while self._box.longest > limit:
            self._box = self._contracted(self._box)
        return self._box

    def _contracted(self, box: Box) -> Box:
        """A smaller box that contains the zero: ``c − Y F(c) + (1 − Y J)(X − c)``, Krawczyk's operator with the
        preconditioned pair G.

        The pair preconditioned on the box contracts each side by the factor `KEPT`, later quadratically. If it does
        not, the pair preconditioned on the region contracts the longer side, relative to the sides of the region.
        """
        pair = preconditioned(*(rounded(f, box) for f in self.forms))
        ranges = pair and contracting(pair)
        if pair is None or ranges is None:
            pair = _preconditioned_on(self.forms, self.region, box)
            ranges = [_ranges(g, k) for k, g in enumerate(pair)]
        half = mpq(1, 2)
        sides = []
        for g, (diagonal, off_diagonal) in zip(pair, ranges, strict=True):
            scale = mpq(int(diagonal[0] + diagonal[1]), 2)
            radius = (int(diagonal[1]) - scale + int(max(-off_diagonal[0], off_diagonal[1]) + 2 * g.error)) / scale / 2
            middle = half - g.value(half, half) / scale
            sides.append(Interval(max(mpq(0), middle - radius), min(mpq(1), middle + radius)))
        first, second = (_rounded(side.part(local), side) for local, side in zip(sides, box, strict=True))
        return Box(first, second)


def only_zero_in(forms: Sequence[PatchForm], box: Box, near: Sequence[mpq]) -> Isolated | None:
    """The only common zero of two forms in a box or close to it, where it is shown that there is one; it may be near a
    point.
    """
    given = _pair(*forms)
    region = certified(given, box, PatchForm.part)
    if region is None:
        return None
    zero, (x, y) = Isolated(given, region), near
    around = Box(Interval(x - NARROW, x + NARROW), Interval(y - NARROW, y + NARROW))
    if region.contains(around) and (narrow := certified(given, around, PatchForm.part)) is not None:
        zero._box = narrow
    return zero


class Isolation(NamedTuple):
    """Certified zeros, each of two of the forms, and undecided boxes, which may contain other zeros."""

    zeros: list[Isolated]
    undecided: list[Box]


def isolate(
    forms: Sequence[PatchForm], not_positive: Sequence[PatchForm] = (), also: int = 0, before: Isolation | None = None
) -> Isolation:
    """The common zeros of forms in the closed unit square or close to it, except those at which one of `not_positive`
    is certainly positive. The last forms (`also` is their number) only exclude. The search ends where elimination would
    be cheaper; boxes that an isolation `before` left undecided are bisected as often as possible.

    Every common zero in the square is in the region of one of the zeros returned or in an undecided box; a region may
    extend beyond the square. A certified zero is a zero of two of the forms; whether the other forms vanish there is
    not decided.

    >>> circle = PatchForm.of_net([[-1, -1, 0], [-1, -1, 0], [0, 0, 1]])  # x² + y² − 1
    >>> line = PatchForm.of_net([[0, -1], [1, 0]])  # x − y
    >>> found = isolate([circle, line])
    >>> len(found.zeros), found.undecided, float(found.zeros[0].refine(40)[0][0])
    (1, [], 0.70710678118...)
    """
    zeros, start = ([], [UNIT]) if before is None else before
    vanishing, effort = len(forms), _Effort(forms, BOXES if before else None)
    given = {(i, j): _pair(forms[i], forms[j]) for i, j in combinations(range(vanishing - also), 2)}
    searched = [*_of_one_degree(*forms[: vanishing - also]), *forms[vanishing - also :], *not_positive]
    search = Search(Sized(box, [rounded(f, box) for f in searched]) for box in start)
    for part in search:
        known = any(zero.region.contains(part.box) for zero in zeros)
        if known or any(f.sign is not None for f in part.forms[:vanishing]):
            continue
        if any(f.sign == 1 for f in part.forms[vanishing:]):
            continue
        order = sorted(given, key=partial(_dependence, part.forms)) if len(given) > 1 else given
        tried = order if search.depth > FEW else islice(order, 1)
        if not any(_is_decided(part, given[at], at, zeros) for at in tried):
            search.split(halved(part) if effort.allows(search.depth) else None)
    return Isolation(zeros, [part.box for part in search.open])


class _Effort:
    """The limits on the number of boxes that are bisected; the remaining boxes are left to elimination, or are
    undecided.
    """

    def __init__(self, forms: Sequence[PatchForm], most: int | None) -> None:
        self.cost = sum(map(_halving, forms))
        self.most = most or PER_SQUARE * max(len(f.entries) for f in forms) ** 2
        self.boxes = self.small = 0

    def allows(self, depth: int) -> bool:
        """Whether one more box, which has been bisected this many times, may be bisected."""
        self.boxes += 1
        self.small += depth > SMALL
        return depth < DEPTH and self.boxes <= BOXES and self.small <= self.most and affords(self.cost)


def _is_decided(part: Sized, given: Pair, at: tuple[int, int], zeros: list[Isolated]) -> bool:
    """Whether two of the forms exclude a box, or certify a zero, which is then among the zeros."""
    pair = preconditioned(part.forms[at[0]], part.forms[at[1]])
    if pair is None:
        return False
    if any(g.sign is not None for g in pair):
        return True
    region = certified(given, part.box) if contracting(pair) else None
    if region is not None:
        _add(zeros, Isolated(given, region, at))
    return region is not None


def _halving(form: PatchForm) -> int:
    """An estimate in nanoseconds of the cost of bisecting a patch on the way to small boxes."""
    m, n = form.degree
    bits = height_bits(form.entries) + DEPTH // 4 * (m + n)
    return (m + 1) * (n + 1) * (HALVING + HALVING_BITS * bits // 100)


def _pair(first: PatchForm, second: PatchForm) -> Pair:
    one, other = _of_one_degree(first, second)
    return one, other


def _of_one_degree(*forms: PatchForm) -> tuple[PatchForm, ...]:
    m, n = (max(f.degree[k] for f in forms) for k in (0, 1))
    return tuple(f.elevated((m, n)) for f in forms)


def _dependence(forms: Sequence[PatchForm], at: tuple[int, int]) -> int:
    """How close two forms are to having parallel or small gradients, in bits. The number only selects the two forms
    that are tried.
    """
    (a, b), (c, d) = (mean_slopes(forms[k]) for k in at)
    determinant = a * d - b * c
    sizes = sum(max(map(abs, forms[k].range)).bit_length() for k in at)
    return int(sizes - determinant.bit_length()) if determinant else 2 * sizes


def preconditioned(first: PatchForm, second: PatchForm) -> Pair | None:
    """The pair multiplied by the adjugate of its Jacobian, estimated from the corners. Near a simple zero the two forms
    are approximately multiples of ``x − x₀`` and ``y − y₀``. None if the estimate is singular.
    """
    (a, b), (c, d) = mean_slopes(first), mean_slopes(second)
    determinant = a * d - b * c
    if determinant == 0:
        return None
    sign = 1 if determinant > 0 else -1
    return first.combined(d * sign, second, -b * sign), first.combined(-c * sign, second, a * sign)


def _preconditioned_on(forms: Pair, region: Box, box: Box) -> Pair:
    """The pair preconditioned on a region, restricted to a part of the region."""
    pair = preconditioned(*(f.part(region) for f in forms))
    assert pair is not None, "the region was certified"
    local = region.local(box)
    return pair[0].part(local), pair[1].part(local)


def mean_slopes(f: PatchForm) -> tuple[fmpz, fmpz]:
    """Twice the mean derivatives in x and in y between the corners.

    >>> mean_slopes(PatchForm.of_net([[0, 1], [3, 5]]))
    (7, 3)
    """
    low, up, right, top = f.corners
    return right + top - low - up, up + top - low - right


def _ranges(g: PatchForm, k: int) -> tuple[tuple[fmpz, fmpz], tuple[fmpz, fmpz]]:
    """Bounds of the derivatives of a form with respect to the k-th parameter and to the other one."""
    return g.slopes(k), g.slopes(1 - k)


def contracting(pair: Pair) -> list[tuple[tuple[fmpz, fmpz], tuple[fmpz, fmpz]]] | None:
    """Bounds of the derivatives of both forms, if these are so strongly diagonally dominant on the whole square that
    Krawczyk's operator contracts each side by the factor `KEPT`; then the pair is injective.
    """
    (part, whole), found = KEPT, []
    for k, g in enumerate(pair):
        diagonal, off_diagonal = ranges = _ranges(g, k)
        if not diagonal[0] > 0 or whole * (
            diagonal[1] - diagonal[0] + 2 * max(-off_diagonal[0], off_diagonal[1])
        ) > part * (diagonal[0] + diagonal[1]):
            return None
        found.append(ranges)
    return found


def certified(forms: Pair, box: Box, on: Callable[[PatchForm, Box], PatchForm] = rounded) -> Box | None:
    """A box around this one that is proved to contain exactly one zero, or None."""
    first, second = (side.grown(side.width * MARGIN) for side in box)
    region = Box(first, second)
    pair = preconditioned(*(on(f, region) for f in forms))
    if pair is None or not contracting(pair):
        return None
    crossed = all(max(g.edge(k, 0)) < -g.error and g.error < min(g.edge(k, 1)) for k, g in enumerate(pair))
    return region if crossed else None


def _add(zeros: list[Isolated], new: Isolated) -> None:
    """Append a zero, unless a common zero in its box must be equal to a known one."""
    for known in zeros:
        bits = 8
        while new.box.meets(known.box):
            if known.region.contains(new.box):
                return
            new.refine(bits)
            known.refine(bits)
            bits += 8
    zeros.append(new)


def _rounded(part: Interval, side: Interval) -> Interval:
    """An interval with short ends around a part and inside the whole side. The result is never a single point, because
    a degenerate box has no Jacobian.
    """
    pad = max(part.width / 64, side.width / (1 << 48))
    return part.grown(pad).outward(mpq(1, 1 << int(1 / pad).bit_length())).inside(side)


def simplest(low: mpq, high: mpq) -> mpq:
    """The rational number with the smallest denominator in a closed interval.

    >>> simplest(mpq(31, 100), mpq(35, 100))
    mpq(1,3)
    """
    terms = []
    while (whole := -((-low) // 1)) > high:
        terms.append(base := low // 1)
        low, high = 1 / (high - base), 1 / (low - base)
    return reduce(lambda x, base: base + 1 / x, reversed(terms), mpq(whole))
