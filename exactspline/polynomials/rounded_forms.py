"""Forms on a patch whose coefficients are integers of few bits with a common bound of their errors, for searches that
exclude boxes: signs and ranges are those of the form itself, or not known.

Halving takes means of coefficients, so that each adds one unit to the error. Where the coefficients are no longer
large compared with it, they are computed once more from the form itself.
"""

from __future__ import annotations

from flint import fmpz, fmpz_mat

from exactspline.numbers.intervals import UNIT, Box
from exactspline.polynomials.cost import height_bits
from exactspline.polynomials.patch_forms import PatchForm, halving

#: The bits of a coefficient: products with binomial coefficients fit into two words; and the bits by which the largest
#: must exceed the error.
BITS, KEPT = 60, 24


class RoundedForm(PatchForm):
    """A form on a box, up to a positive constant: each coefficient differs from its integer by at most `error`, and the
    differences of any two of them by no more than that.

    >>> f = rounded(PatchForm.of_net([[-(10**40), 10**40 + 1], [0, 10**41]]))
    >>> f.error, f.sign, f.halves(1)[1].sign, f.halves(0)[1].halves(1)[1].sign
    (1, None, None, 1)
    """

    __slots__ = ("_source", "error")

    def __init__(self, matrix: fmpz_mat, error: fmpz, source: tuple[PatchForm, Box] | None = None) -> None:
        super().__init__(matrix)
        self.error, self._source = error, source

    def __reduce__(self) -> tuple[object, ...]:
        assert self._source is not None, "a form on a box of its own"
        return rounded, self._source

    @property
    def range(self) -> tuple[fmpz, fmpz]:
        """Bounds of all values on the box."""
        if self._range is None:
            self._range = min(self.entries) - self.error, max(self.entries) + self.error
        return self._range

    def halves(self, direction: int) -> tuple[PatchForm, PatchForm]:
        """The form on the two halves of the box, with different constants where it is computed once more."""
        assert self._source is not None, "a form on a box of its own"
        form, box = self._source
        boxes = box.halves(direction)
        low, high = self.range
        if max(-low, high) >> KEPT < self.error:
            return rounded(form, boxes[0]), rounded(form, boxes[1])
        n = self.degree[direction]
        halves = []
        for by, half in zip(halving(n), boxes, strict=True):
            product = by * self.matrix if direction == 0 else self.matrix * by.transpose()
            means = fmpz_mat(*self._shape, [x >> n for x in product.entries()])
            halves.append(RoundedForm(means, self.error + 1, (form, half)))
        return halves[0], halves[1]

    def slopes(self, direction: int) -> tuple[fmpz, fmpz]:
        """Bounds of the derivative with respect to x (direction 0) or y."""
        low, high = super().slopes(direction)
        wide = self.degree[direction] * self.error
        return low - wide, high + wide

    def combined(self, a: fmpz, other: PatchForm, b: fmpz) -> RoundedForm:
        """``a · self + b · other``, for two rounded forms of the same degree."""
        assert isinstance(other, RoundedForm), "both are rounded"
        return RoundedForm(super().combined(a, other, b).matrix, abs(a) * self.error + abs(b) * other.error)

    def primitive(self) -> RoundedForm:
        """Itself: the constant is that of the error."""
        return self


def rounded(form: PatchForm, box: Box = UNIT) -> PatchForm:
    """A form on a box, in few bits; the zero form itself."""
    part = form if box == UNIT else form.part(box)
    if part.is_zero:
        return part
    bits = height_bits(part.entries) - BITS
    if bits <= 0:
        return RoundedForm(part.matrix * (1 << -bits), fmpz(0), (form, box))
    return RoundedForm(fmpz_mat(*part._shape, [x >> bits for x in part.entries]), fmpz(1), (form, box))
