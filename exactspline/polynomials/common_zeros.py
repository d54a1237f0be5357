"""Certified common zeros of two polynomials on a patch, by exact subdivision in Bernstein form.

A box is excluded if the coefficients of one of the polynomials, or of their combinations by the inverse of their
Jacobian there, are all positive or all negative. Near a simple zero the combinations G₁, G₂ are approximately
``x − x₀`` and ``y − y₀``: if the ranges of their derivatives are strictly diagonally dominant, there is at most one
zero, and if G₁ has opposite signs on the left and right sides and G₂ on the lower and upper sides, there is at least
one (Miranda). All computations are in integers.

A zero is certified if Krawczyk's operator contracts a box around it by a fixed factor; then refinement terminates.

Source: Miranda, Un'osservazione su un teorema di Brouwer, Bollettino UMI 1940; Mourrain and Pavone, Subdivision methods
for solving polynomial equations, 2009 (the preconditioning).
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from typing import NamedTuple

from flint import fmpz

from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.polynomials.patch_forms import PatchForm, Sized, halved

#: The fraction of its width by which a box is enlarged on each side before certification.
MARGIN = mpq(1, 4)
#: The maximal number of bisections of a box, and of boxes, after which the remaining boxes are reported as undecided.
DEPTH, BOXES = 48, 5000
#: The precision (bits) of a box at which a simple rational zero is searched for, and the largest denominator tried.
SIMPLE_BITS, SIMPLE = 60, 4096
#: The contraction factor of Krawczyk's operator required for certification.
KEPT = 3, 4
#: Refinement limit (bits) for separating two zeros.
EQUAL_BITS = 200


class Zero:
    """A certified common zero of two forms: the only one in `region`.

    Its box shrinks when it is refined; everything else is immutable.
    """

    __slots__ = ("_box", "_exact", "forms", "region")

    def __init__(self, forms: tuple[PatchForm, PatchForm], region: Box) -> None:
        self.forms, self.region, self._box = forms, region, region
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

    def is_at(self, x: mpq, y: mpq) -> bool:
        """Whether the zero is this point."""
        return self.region.contains(Box.point(x, y)) and all(f.value(x, y) == 0 for f in self.forms)

    def _contracted(self, box: Box) -> Box:
        """The zero is in ``c − Y F(c) + (1 − Y J)(X − c)``: Krawczyk's operator with the preconditioned pair G.

        The pair preconditioned on the box contracts each side by the factor `KEPT`, later quadratically. If it does
        not, the pair preconditioned on the region contracts the longer side, relative to the sides of the region.
        """
        pair = preconditioned(*(f.part(box) for f in self.forms))
        if pair is None or not _contracts(pair):
            pair = _preconditioned_on(self.forms, self.region, box)
        half = mpq(1, 2)
        sides = []
        for k, g in enumerate(pair):
            diagonal, off_diagonal = g.derivative(k).range, g.derivative(1 - k).range
            scale = mpq(int(diagonal[0] + diagonal[1]), 2)
            radius = (int(diagonal[1]) - scale + int(max(-off_diagonal[0], off_diagonal[1]))) / scale / 2
            middle = half - g.value(half, half) / scale
            sides.append(Interval(max(mpq(0), middle - radius), min(mpq(1), middle + radius)))
        first, second = (_rounded(side.part(local), side) for local, side in zip(sides, box, strict=True))
        return Box(first, second)


class Zeros(NamedTuple):
    """Certified zeros, and boxes for which it could not be decided which zeros they contain, if any."""

    zeros: list[Zero]
    undecided: list[Box]


def isolate(
    first: PatchForm,
    second: PatchForm,
    also: Sequence[PatchForm] = (),
    box: Box = UNIT,
    not_positive: Sequence[PatchForm] = (),
) -> Zeros:
    """The common zeros of two forms of the same degree and with a common constant that are in a closed box or close to
    it, except those at which one of the forms in `also` is certainly not zero, or one of `not_positive` certainly
    positive.

    Every zero in the box is in the region of one of the zeros returned or in an undecided box; a region may extend
    beyond the box.

    >>> circle = PatchForm.of_net([[-1, -1, 0], [-1, -1, 0], [0, 0, 1]])  # x² + y² − 1
    >>> line = PatchForm.of_net([[0, -1, -2], [1, 0, -1], [2, 1, 0]])  # 2 (x − y)
    >>> found = isolate(circle, line)
    >>> len(found.zeros), found.undecided, float(found.zeros[0].refine(40)[0][0])
    (1, [], 0.70710678118...)
    """
    result = Zeros([], [])
    todo = deque([Sized(box, [f.part(box) for f in (first, second, *also, *not_positive)], 0)])
    boxes, vanishing = 0, 2 + len(also)
    while todo:
        part = todo.popleft()
        if is_known(part.box, result.zeros) or any(f.sign is not None for f in part.forms[:vanishing]):
            continue
        if any(f.sign == 1 for f in part.forms[vanishing:]):
            continue
        boxes += 1
        pair = preconditioned(part.forms[0], part.forms[1])
        if pair is not None:
            if any(g.sign is not None for g in pair):
                continue
            if _contracts(pair) and (region := _certified((first, second), part.box)):
                _add(result.zeros, Zero((first, second), region))
                continue
        if part.depth >= DEPTH or boxes > BOXES:
            result.undecided.append(part.box)
        else:
            todo.extend(halved(part))
    return result


def preconditioned(first: PatchForm, second: PatchForm) -> tuple[PatchForm, PatchForm] | None:
    """The pair multiplied by the adjugate of its Jacobian, estimated from the corners: near a simple zero approximately
    multiples of ``x − x₀`` and ``y − y₀``. None if the estimate is singular.
    """
    (a, b), (c, d) = _slopes(first), _slopes(second)
    determinant = a * d - b * c
    if determinant == 0:
        return None
    sign = 1 if determinant > 0 else -1
    return first.combined(d * sign, second, -b * sign), first.combined(-c * sign, second, a * sign)


def _preconditioned_on(forms: tuple[PatchForm, PatchForm], region: Box, box: Box) -> tuple[PatchForm, PatchForm]:
    """The pair preconditioned on a region, restricted to a part of it."""
    pair = preconditioned(*(f.part(region) for f in forms))
    assert pair is not None, "the region was certified"
    local = region.local(box)
    return pair[0].part(local), pair[1].part(local)


def _slopes(f: PatchForm) -> tuple[fmpz, fmpz]:
    low, up, right, top = f.corners
    return right + top - low - up, up + top - low - right


def _contracts(pair: tuple[PatchForm, PatchForm]) -> bool:
    """Whether the derivatives are so strongly diagonally dominant on the whole square that Krawczyk's operator
    contracts each side by the factor `KEPT`; then the pair is injective.
    """
    part, whole = KEPT
    for k, g in enumerate(pair):
        diagonal, off_diagonal = g.derivative(k).range, g.derivative(1 - k).range
        if not diagonal[0] > 0 or whole * (
            diagonal[1] - diagonal[0] + 2 * max(-off_diagonal[0], off_diagonal[1])
        ) > part * (diagonal[0] + diagonal[1]):
            return False
    return True


def _certified(forms: tuple[PatchForm, PatchForm], box: Box) -> Box | None:
    """A box around this one that is proved to contain exactly one zero, or None."""
    first, second = (side.grown(side.width * MARGIN) for side in box)
    region = Box(first, second)
    pair = preconditioned(*(f.part(region) for f in forms))
    if pair is None or not _contracts(pair):
        return None
    crossed = all(max(g.edge(k, 0)) < 0 < min(g.edge(k, 1)) for k, g in enumerate(pair))
    return region if crossed else None


def _add(zeros: list[Zero], new: Zero) -> None:
    """Append a zero unless it is equal to a known one."""
    for known in zeros:
        bits = 8
        while new.box.meets(known.box):
            if known.region.contains(new.box):
                return
            new.refine(bits)
            known.refine(bits)
            bits += 8
    zeros.append(new)


def is_known(box: Box, zeros: Sequence[Zero]) -> bool:
    """Whether a zero of the forms in a box, if there is one, must be one of these."""
    return any(zero.region.contains(box) for zero in zeros)


def _rounded(part: Interval, side: Interval) -> Interval:
    """An interval with short ends around a part and inside the whole side. It is never a single point, because a
    degenerate box has no Jacobian.
    """
    pad = max(part.width / 64, side.width / 1024)
    scale = mpq(1 << int(1 / pad).bit_length())
    low, high = mpq(((part.low - pad) * scale) // 1) / scale, mpq(-((-(part.high + pad) * scale) // 1)) / scale
    return Interval(max(side.low, low), min(side.high, high))


def simplest(low: mpq, high: mpq) -> mpq:
    """The rational number with the smallest denominator in a closed interval.

    >>> simplest(mpq(31, 100), mpq(35, 100))
    mpq(1,3)
    """
    whole = -((-low) // 1)
    if whole <= high:
        return mpq(whole)
    base = low // 1
    return base + 1 / simplest(1 / (high - base), 1 / (low - base))


def same(one: Zero, other: Zero) -> bool:
    """Whether two certified zeros are equal: they are if the box of `one` is in the region of `other`.

    Both must be zeros of the forms of `other`; False is also a proof.
    """
    bits = 16
    while True:
        box = one.refine(bits)
        if not box.meets(other.box):
            return False
        if other.region.contains(box):
            return True
        other.refine(bits)
        bits *= 2


def are_one(one: Zero, other: Zero) -> bool | None:
    """Whether two certified points, zeros of different pairs of forms, are equal; None if the refinement limit is
    reached.
    """
    if one.exact is not None and other.exact is not None:
        return one.exact == other.exact
    return None if one.refine(EQUAL_BITS).meets(other.refine(EQUAL_BITS)) else False


__all__ = ["Zero", "Zeros", "are_one", "is_known", "isolate", "preconditioned", "same", "simplest"]
