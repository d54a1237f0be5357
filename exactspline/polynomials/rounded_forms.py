"""Forms on a patch whose coefficients are integers of few bits with a common bound of their errors, for searches that
exclude boxes: signs and ranges are those of the form itself, or not known.

Halving takes means of coefficients, so that each adds one unit to the error. Where the coefficients are no longer
large compared with it, they are computed once more from the form itself.
"""

from __future__ import annotations

from flint import fmpz, fmpz_mat

from exactspline.numbers.intervals import UNIT, Box
from exactspline.polynomials.cost import height_bits
from exactspline.polynomials.patch_forms import PatchForm, halving, restriction_rounded

#: The bits of a coefficient: products with binomial coefficients fit into two words; and the bits by which the largest
#: must exceed the error.
BITS, KEPT = 60, 24
#: The number of precisions, each twice the former one, at which a form is restricted before this is done exactly.
TRIED = 3


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

    def derivative(self, direction: int) -> RoundedForm:
        """The derivative with respect to x (direction 0) or y, with the same constant."""
        return RoundedForm(super().derivative(direction).matrix, 2 * self.degree[direction] * self.error)

    def primitive(self) -> RoundedForm:
        """Itself: the constant is that of the error."""
        return self


def rounded(form: PatchForm, box: Box = UNIT) -> PatchForm:
    """A form on a box, in few bits; the zero form itself."""
    if box != UNIT and box.longest and UNIT.contains(box):
        low, high = form.range
        known, bits = int(max(-low, high)).bit_length(), 2 * (BITS + int(1 / box.longest).bit_length())
        for _ in range(TRIED):
            matrix = _restricted(form, box, known - bits, bits)
            spare = height_bits(matrix.entries()) - BITS
            if spare >= 2:
                return RoundedForm(_shifted(matrix, spare), fmpz(2), (form, box))
            bits *= 2
    part = form.part(box)
    if part.is_zero:
        return part
    bits = height_bits(part.entries) - BITS
    return RoundedForm(_shifted(part.matrix, bits), fmpz(int(bits > 0)), (form, box))


def _shifted(matrix: fmpz_mat, bits: int) -> fmpz_mat:
    """Every entry over a power of two, rounded down."""
    if bits <= 0:
        return matrix * (1 << -bits)
    return fmpz_mat(matrix.nrows(), matrix.ncols(), [x >> bits for x in matrix.entries()])


def _restricted(form: PatchForm, box: Box, dropped: int, bits: int) -> fmpz_mat:
    """The coefficients on a part of the square over a power of two, less errors from −1/2 to 7/2: those of the form
    have this many bits, and means of them have weights that are rounded down.

    Each of both products adds at most a quarter on either side for the weights, and a unit for its own rounding; the
    coefficients of the form add the first unit, which means do not enlarge.
    """
    m, n = form.degree
    scale = bits + max(m, n).bit_length() + 4
    left, right = (restriction_rounded(k, *side, scale) for k, side in zip((m, n), box, strict=True))
    middle = _shifted(left * _shifted(form.matrix, dropped), scale)
    return _shifted(middle * right.transpose(), scale)
