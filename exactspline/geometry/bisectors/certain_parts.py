"""Fast certified answers ahead of the exact ones: for which parameters a family of forms certainly has a negative
value, and for which it certainly has none.

A family has one form in u for every local parameter z; it is given by rows, forms of degree n in z, one for each power
of u, and judged by its sign against that of a form e.
"""

from __future__ import annotations

from collections.abc import Sequence

from flint import fmpz_poly

from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import UNIT, Box, Interval, joined
from exactspline.polynomials.bernstein import ONE, halves, restrict
from exactspline.polynomials.patch_forms import PatchForm

#: An interval of the local parameter. How often the parameter is halved, and how often both are.
DEPTH, DEPTH_OF_BOTH = 10, 10


def possible_parts(families: Sequence[Sequence[fmpz_poly]], e: fmpz_poly, n: int) -> list[Interval]:
    """The parts of [0, 1] on which no family is certainly of the other sign than e at the beginning or in the middle
    of its range, neighbours joined; parts with a zero of e only where all families could have one sign.

    >>> possible_parts([[fmpz_poly([-1, 3])]], fmpz_poly([1, 1]), 1)
    [Interval(255/1024, 1)]
    """
    samples = [form for rows in families for form in (rows[0], _total(rows))]
    todo = [(Interval(mpq(0), mpq(1)), 0, e, samples)]
    possible: list[Interval] = []
    while todo:
        interval, depth, below, forms = todo.pop()
        sign = _sign(below, n)
        signs = {_sign(form, n) for form in forms}
        # where e has a zero, forms of both signs exclude both of its sides
        if -sign in signs if sign else {1, -1} <= signs:
            continue
        if depth == DEPTH or (sign and not any(_has_sign(form, -sign) for form in forms)):
            possible.append(interval)
            continue
        parts = [halves(form, n) for form in forms if not sign or _has_sign(form, -sign)]
        left, right = halves(below, n)
        first, second = interval.halves
        todo.append((second, depth + 1, right, [part for _, part in parts]))
        todo.append((first, depth + 1, left, [part for part, _ in parts]))
    return joined(possible)


def _total(rows: Sequence[fmpz_poly]) -> fmpz_poly:
    """The family in the middle of its range, up to a positive constant."""
    return sum(rows, start=fmpz_poly([]))


def _sign(form: fmpz_poly, n: int) -> int:
    """The strict sign of all coefficients of a form of degree n, 0 where they have none."""
    first = form[0]
    if first == 0 or form.degree() < n:
        return 0
    sign = 1 if first > 0 else -1
    return sign if all(x * sign > 0 for x in form.coeffs()) else 0


def _has_sign(form: fmpz_poly, sign: int) -> bool:
    return any(x * sign > 0 for x in form.coeffs())


def holds_certainly(
    rows: Sequence[fmpz_poly], e: fmpz_poly, n: int, interval: Interval, degree: int | None = None
) -> bool:
    """Whether a family has the sign of e, or is zero, all over a part: by coefficients on smaller and smaller boxes.

    Its rows have the degree n of e, or another degree.
    """
    sign = _sign(restrict((e, ONE), n, *interval)[0], n)
    return bool(sign) and keeps_sign(rows, n if degree is None else degree, interval, sign)


def keeps_sign(rows: Sequence[fmpz_poly], m: int, interval: Interval, sign: int) -> bool:
    """Whether a family of degree m in z has a sign, or is zero, all over a part; certainly, as above.

    >>> keeps_sign([fmpz_poly([1, -1]), fmpz_poly([2, 1])], 1, Interval(mpq(0), mpq(1, 4)), 1)
    True
    """
    todo = [(0, PatchForm.of_rows(rows, m).part(Box(interval, UNIT.second)))]
    while todo:
        depth, form = todo.pop()
        low, high = form.range
        if (low if sign > 0 else -high) >= 0:
            continue
        if depth == DEPTH_OF_BOTH or any(x * sign < 0 for x in form.corners):
            return False
        todo += [(depth + 1, half) for half in form.halves(1 - depth % 2)]
    return True
