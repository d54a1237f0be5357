"""The Bernstein coefficients of one patch as a matrix of integers: subdivision, restriction, derivatives, signs.

A `PatchForm` is ``Σ c_ij B_i(x) B_j(y)`` times a positive constant, over the unit square of its local parameters. Signs
and zeros do not depend on this constant; forms derived by the same operations from forms with a common constant have a
common constant.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from math import comb
from operator import sub
from typing import NamedTuple

from flint import fmpz, fmpz_mat, fmpz_poly

from exactspline.numbers.exact import common_divisor, lcm, mpq
from exactspline.numbers.intervals import UNIT, Box, Interval, hull
from exactspline.polynomials.cost import height_bits


class PatchForm:
    """A polynomial on a patch, given by its Bernstein coefficients up to a positive constant.

    >>> from exactspline.numbers.intervals import UNIT, Interval
    >>> f = PatchForm.of_net([[-1, 0], [0, 1]])  # x + y − 1
    >>> high, higher = UNIT.halves(0)[1].first, Interval(mpq(3, 4), mpq(1))
    >>> f.sign, f.part(Box(high, higher)).sign
    (None, 1)
    """

    __slots__ = ("_entries", "_range", "matrix")
    #: A bound of the errors of the coefficients.
    error: fmpz = fmpz(0)

    def __init__(self, matrix: fmpz_mat) -> None:
        self.matrix = matrix
        self._entries: list[fmpz] | None = None
        self._range: tuple[fmpz, fmpz] | None = None

    def __reduce__(self) -> tuple[object, ...]:
        return PatchForm.of_net, ([[int(x) for x in row] for row in self.matrix.tolist()],)

    @classmethod
    def of_net(cls, net: Sequence[Sequence[int]]) -> PatchForm:
        """The form with these coefficients."""
        return cls(fmpz_mat([list(row) for row in net]))

    @classmethod
    def of_rows(cls, rows: Sequence[fmpz_poly], m: int) -> PatchForm:
        """The form with these rows in the scaled Bernstein basis, forms of degree m in x, one for each power of y.

        >>> PatchForm.of_rows([fmpz_poly([1, 4, 1]), fmpz_poly([0, 2])], 2).entries  # C(2, i) b_i
        [1, 0, 2, 1, 1, 0]
        """
        n = len(rows) - 1
        common = lcm(*[comb(m, i) * comb(n, j) for i in range(m + 1) for j in range(n + 1)])
        weights = [[int(common // (comb(m, i) * comb(n, j))) for j in range(n + 1)] for i in range(m + 1)]
        return cls(fmpz_mat([[row[i] * weights[i][j] for j, row in enumerate(rows)] for i in range(m + 1)])).primitive()

    @property
    def degree(self) -> tuple[int, int]:
        """The degrees in x and y."""
        return int(self.matrix.nrows()) - 1, int(self.matrix.ncols()) - 1

    @property
    def entries(self) -> list[fmpz]:
        """All coefficients, row by row."""
        if self._entries is None:
            self._entries = self.matrix.entries()
        return self._entries

    @property
    def is_zero(self) -> bool:
        """Whether the form is the zero polynomial."""
        return not any(self.entries)

    @property
    def sign(self) -> int | None:
        """The sign on the whole closed square, if it follows from the coefficients: 1, −1, or 0 for the zero
        polynomial; otherwise None.
        """
        low, high = self.range
        if low > 0:
            return 1
        if high < 0:
            return -1
        return 0 if low == high == 0 else None

    @property
    def range(self) -> tuple[fmpz, fmpz]:
        """Bounds of all values on the square: the smallest and the largest coefficient."""
        if self._range is None:
            self._range = min(self.entries), max(self.entries)
        return self._range

    @property
    def corners(self) -> tuple[fmpz, fmpz, fmpz, fmpz]:
        """The values at the corners: (0, 0), (0, 1), (1, 0), (1, 1)."""
        entries, (m, n) = self.entries, self.degree
        return entries[0], entries[n], entries[m * (n + 1)], entries[-1]

    def halves(self, direction: int) -> tuple[PatchForm, PatchForm]:
        """The form on the two halves of the square (direction 0: in x), with a common constant."""
        matrix, (first, second) = self.matrix, _halving(self.degree[direction])
        if direction == 0:
            return PatchForm(first * matrix), PatchForm(second * matrix)
        return PatchForm(matrix * first.transpose()), PatchForm(matrix * second.transpose())

    def part(self, box: Box) -> PatchForm:
        """The form on a box, which may extend beyond the square; the constant depends only on box and degree."""
        if box == UNIT:
            return self
        left, right = (restriction(n, *side)[0] for n, side in zip(self.degree, box, strict=True))
        return PatchForm(left * self.matrix * right.transpose())

    def value(self, x: mpq, y: mpq) -> mpq:
        """The value at a point, up to the constant of the form."""
        left, a = _weights(self.degree[0], x)
        right, b = _weights(self.degree[1], y)
        total = (left * self.matrix * right.transpose())[0, 0]
        return mpq(int(total)) / (a * b)

    def on_line(self, direction: int, x: mpq) -> list[fmpz]:
        """The Bernstein coefficients along the line on which x (direction 0) or y has this value, up to a positive
        constant for 0 ≤ x ≤ 1.
        """
        weights, _ = _weights(self.degree[direction], x)
        return (weights * self.matrix if direction == 0 else self.matrix * weights.transpose()).entries()

    def derivative(self, direction: int) -> PatchForm:
        """The derivative with respect to x (direction 0) or y, with the same constant; for degree 0 the zero form of
        degree 0.
        """
        (rows, columns), n = self._shape, self.degree[direction]
        if n == 0:
            return PatchForm(self.matrix * 0)
        shape = (rows, columns - 1) if direction else (rows - 1, columns)
        return PatchForm(fmpz_mat(*shape, self._differences(direction)) * n)

    def slopes(self, direction: int) -> tuple[fmpz, fmpz]:
        """Bounds of the derivative with respect to x (direction 0) or y: its smallest and its largest coefficient."""
        n = self.degree[direction]
        if n == 0:
            return fmpz(0), fmpz(0)
        differences = self._differences(direction)
        return n * min(differences), n * max(differences)

    @property
    def monotonic(self) -> int | None:
        """The first direction in which the coefficients prove that the derivative has no zero on the closed square, or
        None.
        """
        return next((k for k, (low, high) in enumerate(map(self.slopes, (0, 1))) if low > 0 or high < 0), None)

    def _differences(self, direction: int) -> list[fmpz]:
        """The differences of neighbouring coefficients, row by row."""
        step = 1 if direction else self._shape[1]
        found = [*map(sub, self.entries[step:], self.entries)]
        if direction:
            del found[self.degree[1] :: self._shape[1]]
        return found

    @property
    def steeper(self) -> int:
        """The direction in which neighbouring coefficients differ more, provided that both sides are halved as often as
        this helps.
        """
        changes = [
            max(-low, high) / max(n, 1) for n, (low, high) in zip(self.degree, map(self.slopes, (0, 1)), strict=True)
        ]
        return int(changes[1] > changes[0])

    def edge(self, direction: int, end: int) -> list[fmpz]:
        """The Bernstein coefficients along the edge on which x (direction 0) or y is 0 or 1."""
        (m, n), entries = self.degree, self.entries
        if direction == 0:
            return entries[m * (n + 1) :] if end else entries[: n + 1]
        return entries[n :: n + 1] if end else entries[:: n + 1]

    def without_border(self, directions: Sequence[int] = (0, 1)) -> tuple[PatchForm, Borders]:
        """The form without its factors x, 1 − x (direction 0), y and 1 − y, and the multiplicity of each factor; the
        form must not be zero.

        >>> f, times = PatchForm.of_net([[0, 0], [2, 2], [0, 0]]).without_border()  # 4 x (1 − x)
        >>> f.degree, times
        ((0, 0), Borders(u_low=1, u_high=1, v_low=0, v_high=0))
        """
        first, low, high = _without_ends(self.matrix) if 0 in directions else (self.matrix, 0, 0)
        turned = first.transpose()
        second, left, right = _without_ends(turned) if 1 in directions else (turned, 0, 0)
        return PatchForm(_lowest(_lowest(second).transpose())), Borders(low, high, left, right)

    def elevated(self, degree: tuple[int, int]) -> PatchForm:
        """The same polynomial elevated to a higher degree, up to a constant."""
        if degree == self.degree:
            return self
        left, right = (_elevation(n, to) for n, to in zip(self.degree, degree, strict=True))
        return PatchForm(left * self.matrix * right.transpose())

    def combined(self, a: fmpz, other: PatchForm, b: fmpz) -> PatchForm:
        """``a · self + b · other``, for two forms of the same degree."""
        return PatchForm(self.matrix * a + other.matrix * b)

    def primitive(self) -> PatchForm:
        """The form divided by the common factor of its coefficients."""
        common = common_divisor(self.entries)
        return PatchForm(fmpz_mat(*self._shape, [x // common for x in self.entries])) if common > 1 else self

    @property
    def _shape(self) -> tuple[int, int]:
        m, n = self.degree
        return m + 1, n + 1


class Borders(NamedTuple):
    """A value for each of the four edges of a patch, on which x or y is 0 or 1."""

    u_low: int
    u_high: int
    v_low: int
    v_high: int


class Sized(NamedTuple):
    """A box, and the forms restricted to the box."""

    box: Box
    forms: list[PatchForm]


def halved(part: Sized, direction: int | None = None) -> tuple[Sized, Sized]:
    """The two halves of the part, by bisection of one of its sides; without a direction the longer side is bisected."""
    if direction is None:
        direction = 0 if part.box.first.width >= part.box.second.width else 1
    pairs = [f.halves(direction) for f in part.forms]
    first, second = (
        Sized(box, [pair[k].primitive() if len(pairs) == 1 else pair[k] for pair in pairs])
        for k, box in enumerate(part.box.halves(direction))
    )
    return first, second


def jacobian_sign(f: PatchForm, g: PatchForm) -> int:
    """The sign on the square of ``f_x g_y − f_y g_x`` for two forms, as far as bounds of the derivatives prove it; 0
    where they do not.
    """
    (a, b), (c, d) = ([h.slopes(k) for k in (0, 1)] for h in (f, g))
    first = [x * y for x in a for y in d]
    second = [x * y for x in b for y in c]
    if min(first) > max(second):
        return 1
    return -1 if max(first) < min(second) else 0


def clusters(boxes: Sequence[Box]) -> list[tuple[Box, list[Box]]]:
    """Boxes in groups, each with its bounding box: no horizontal or vertical line separates the boxes of one group.

    >>> from exactspline.numbers.intervals import Interval
    >>> near, next_to_it, far = (Interval(mpq(k, 12), mpq(k + 3, 12)) for k in (0, 3, 8))
    >>> [len(own) for _, own in clusters([Box(near, near), Box(near, far), Box(near, next_to_it)])]
    [2, 1]
    """
    done: list[tuple[Box, list[Box]]] = []
    todo = [(list(boxes), 0, 0)]
    while todo:
        members, direction, kept = todo.pop()
        groups: list[list[Box]] = []
        reached = mpq(0)
        for box in sorted(members, key=lambda one: one[direction]):
            low, high = box[direction]
            if groups and low <= reached:
                groups[-1].append(box)
                reached = max(reached, high)
            else:
                groups.append([box])
                reached = high
        kept = kept + 1 if len(groups) == 1 else 1
        if kept > 1:
            done.append((hull(members), members))
        else:
            todo += [(group, 1 - direction, kept) for group in reversed(groups)]
    return done


def not_positive_part(form: PatchForm) -> Box | None:
    """A box outside of which a form is shown to be positive on the square, made of products of quarters; None where it
    is positive everywhere.

    >>> not_positive_part(PatchForm.of_net([[-1, 4], [4, 9]]))
    Box(Interval(0, 1/4), Interval(0, 1/4))
    """
    first, second = map(_quarters, form.degree)
    values = (first * form.matrix * second.transpose()).entries()
    found = [divmod(k, second.nrows()) for k, x in enumerate(values) if x <= 0]
    if not found:
        return None
    places = [[4 * k // matrix.nrows() for k in own] for own, matrix in zip(zip(*found), (first, second), strict=True)]
    left, right = (Interval(mpq(min(own), 4), mpq(max(own) + 1, 4)) for own in places)
    return Box(left, right)


# ---- the matrices of all this


def _without_ends(matrix: fmpz_mat) -> tuple[fmpz_mat, int, int]:
    """The coefficients without the factors x and 1 − x (x varies along the columns), and the multiplicities of both."""
    rows = matrix.table()
    low = next(i for i, row in enumerate(rows) if any(row))
    high = next(i for i, row in enumerate(reversed(rows)) if any(row))
    if not low and not high:
        return matrix, 0, 0
    n = len(rows) - 1
    kept = n - low - high
    # C(n, i) b_i are the coefficients without binomials; the coefficients of the quotient are divided by its own
    # binomials
    common = lcm(*[comb(kept, k) for k in range(kept + 1)])
    quotient = [
        [x * int(comb(n, low + k) * (common // comb(kept, k))) for x in row]
        for k, row in enumerate(rows[low : n + 1 - high])
    ]
    return PatchForm(fmpz_mat(quotient)).primitive().matrix, low, high


def _lowest(matrix: fmpz_mat) -> fmpz_mat:
    """The coefficients at the lowest degree of x, up to a constant."""
    n = int(matrix.nrows()) - 1
    rows = (_to_powers(n) * matrix).table()
    degree = max((k for k, row in enumerate(rows) if any(row)), default=0)
    return PatchForm(_from_powers(degree) * fmpz_mat(rows[: degree + 1])).primitive().matrix if degree < n else matrix


def of_powers(rows: Sequence[Sequence[fmpz]]) -> PatchForm:
    """The form of ``Σ rows[i][j] xⁱ yʲ``, whose constant depends only on the degree.

    >>> of_powers([[-1, 1], [1, 0]]).entries == PatchForm.of_net([[-1, 0], [0, 1]]).entries
    True
    """
    matrix = fmpz_mat([list(row) for row in rows])
    left, right = _from_powers(int(matrix.nrows()) - 1), _from_powers(int(matrix.ncols()) - 1)
    return PatchForm(left * matrix * right.transpose())


def powers_of(form: PatchForm) -> list[list[fmpz]]:
    """The coefficients of ``xⁱ yʲ``, up to the constant of the form.

    >>> powers_of(PatchForm.of_net([[-1, 0], [0, 1]]))
    [[-1, 1], [1, 0]]
    """
    m, n = form.degree
    return (_to_powers(m) * form.matrix * _to_powers(n).transpose()).table()


@lru_cache(maxsize=256)
def _to_powers(n: int) -> fmpz_mat:
    """The matrix from Bernstein coefficients to coefficients of powers."""
    return fmpz_mat(
        [[(-1) ** (k - i) * comb(n, k) * comb(k, i) if i <= k else 0 for i in range(n + 1)] for k in range(n + 1)]
    )


@lru_cache(maxsize=256)
def _from_powers(n: int) -> fmpz_mat:
    """The matrix from coefficients of powers to Bernstein coefficients, times the lcm of the binomial coefficients."""
    common = lcm(*[comb(n, k) for k in range(n + 1)])
    return fmpz_mat(
        [[int(comb(i, k) * (common // comb(n, k))) if k <= i else 0 for k in range(n + 1)] for i in range(n + 1)]
    )


@lru_cache(maxsize=256)
def _halving(n: int) -> tuple[fmpz_mat, fmpz_mat]:
    """The matrices to Bernstein coefficients on the left and on the right half, times 2ⁿ."""
    left = [[comb(i, k) << (n - i) if k <= i else 0 for k in range(n + 1)] for i in range(n + 1)]
    return fmpz_mat(left), fmpz_mat([row[::-1] for row in left[::-1]])


@lru_cache(maxsize=1024)
def _elevation(n: int, to: int) -> fmpz_mat:
    """The matrix to Bernstein coefficients of a higher degree, times the lcm of its binomial coefficients."""
    if n == to:
        return _identity(n)
    common = lcm(*[comb(to, i) for i in range(to + 1)])
    rows = [
        [comb(n, k) * comb(to - n, i - k) if 0 <= i - k <= to - n else 0 for k in range(n + 1)] for i in range(to + 1)
    ]
    return fmpz_mat([[int(x * (common // comb(to, i))) for x in row] for i, row in enumerate(rows)])


@lru_cache(maxsize=64)
def restriction(n: int, a: mpq, b: mpq) -> tuple[fmpz_mat, fmpz]:
    """The matrix to Bernstein coefficients over [a, b] and its denominator, the n-th power of that of a and b. Its
    entries are blossoms at a and b.

    >>> restriction(1, mpq(0), mpq(1, 2))
    ([2, 0]
    [1, 1], 2)
    """
    m = lcm(a.denominator, b.denominator)
    if a == 0 and b == 1:
        return _identity(n), fmpz(1)
    at_a, at_b = (_powers(fmpz_poly([int(m - x), int(x)]), n) for x in (a * m, b * m))
    # the blossom at n − i times a and i times b: its weights are the coefficients of a product of two polynomials
    return fmpz_mat([_padded(at_a[n - i] * at_b[i], n) for i in range(n + 1)]), fmpz(int(m)) ** n


@lru_cache(maxsize=64)
def _quarters(n: int) -> fmpz_mat:
    """The matrix to Bernstein coefficients on all quarters, up to one constant."""
    return fmpz_mat([row for k in range(4) for row in restriction(n, mpq(k, 4), mpq(k + 1, 4))[0].table()])


@lru_cache(maxsize=64)
def _restriction_rounded(n: int, a: mpq, b: mpq, bits: int) -> fmpz_mat:
    """The weights with which coefficients over [a, b] are means, times ``2^bits`` and rounded down."""
    matrix, bottom = restriction(n, a, b)
    return fmpz_mat(n + 1, n + 1, [(x << bits) // bottom for x in matrix.entries()])


@lru_cache(maxsize=64)
def _identity(n: int) -> fmpz_mat:
    return fmpz_mat([[int(i == k) for k in range(n + 1)] for i in range(n + 1)])


def _powers(p: fmpz_poly, n: int) -> list[fmpz_poly]:
    powers = [fmpz_poly([1])]
    for _ in range(n):
        powers.append(powers[-1] * p)
    return powers


def _padded(p: fmpz_poly, n: int) -> list[fmpz]:
    coefficients: list[fmpz] = p.coeffs()
    return coefficients + [fmpz(0)] * (n + 1 - len(coefficients))


@lru_cache(maxsize=256)
def _weights(n: int, x: mpq) -> tuple[fmpz_mat, mpq]:
    """The Bernstein polynomials at x, over a denominator."""
    top, bottom = int(x.numerator), int(x.denominator)
    return fmpz_mat([_padded(fmpz_poly([bottom - top, top]) ** n, n)]), mpq(bottom**n)


def jets(forms: Sequence[PatchForm], place: Sequence[int], one: int) -> list[list[list[fmpz]]]:
    """The values of forms of one degree at a point in units of 1/one and their derivatives, up to second ones in x
    (rows) and in y, all times one positive constant.
    """
    left, right = (_derivatives(n, at, one) for n, at in zip(forms[0].degree, place, strict=True))
    return [(left * form.matrix * right.transpose()).table() for form in forms]


def _derivatives(n: int, x: int, one: int) -> fmpz_mat:
    """The Bernstein polynomials at x/one with their first and second derivatives, over a denominator."""
    p, step = fmpz_poly([one - x, x]), fmpz_poly([-one, one])
    low = p ** max(n - 2, 0)
    first = low * p if n > 1 else low
    rows = [first * p if n else first, n * step * first, n * (n - 1) * step * step * low]
    return fmpz_mat([_padded(row, n) for row in rows])


# ---- rounded forms
# Halving takes means of coefficients, so that each halving adds one unit to the error. If the coefficients are no
# longer large compared with the error, they are computed again from the form itself.


#: The bits of a coefficient, such that products with binomial coefficients fit into two words; and the bits by which
#: the largest coefficient must exceed the error.
BITS, KEPT = 60, 24
#: The number of precisions, each twice the previous one, at which a form is restricted before it is restricted exactly.
TRIED = 3


class RoundedForm(PatchForm):
    """A form on a box, up to a positive constant: each coefficient differs from its integer by at most `error`, and so
    does the difference of any two coefficients.

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
        """The form on the two halves of the box, with different constants if it is computed again."""
        assert self._source is not None, "a form on a box of its own"
        form, box = self._source
        boxes = box.halves(direction)
        low, high = self.range
        if max(-low, high) >> KEPT < self.error:
            return rounded(form, boxes[0]), rounded(form, boxes[1])
        n = self.degree[direction]
        halves = []
        for by, half in zip(_halving(n), boxes, strict=True):
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
        """The form itself, because its constant also belongs to the error."""
        return self


def rounded(form: PatchForm, box: Box = UNIT) -> PatchForm:
    """A form on a box, rounded to few bits; the zero form is unchanged."""
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
    """Every entry divided by a power of two, rounded down."""
    if bits <= 0:
        return matrix * (1 << -bits)
    return fmpz_mat(matrix.nrows(), matrix.ncols(), [x >> bits for x in matrix.entries()])


def _restricted(form: PatchForm, box: Box, dropped: int, bits: int) -> fmpz_mat:
    """The coefficients on a part of the square over a power of two, up to errors from −1/2 to 7/2. The coefficients of
    the form have this many bits, and their means are taken with weights that are rounded down.

    Each of the two products adds at most a quarter on either side for the weights, and a unit for its own rounding. The
    rounding of the coefficients of the form adds another unit; taking means does not enlarge it.
    """
    m, n = form.degree
    scale = bits + max(m, n).bit_length() + 4
    left, right = (_restriction_rounded(k, *side, scale) for k, side in zip((m, n), box, strict=True))
    middle = _shifted(left * _shifted(form.matrix, dropped), scale)
    return _shifted(middle * right.transpose(), scale)
