"""Cells around singular points of curves of zeros, and the intervals of which they consist."""

from random import Random

import pytest
from flint import fmpz_poly
from gmpy2 import mpq

from exactspline import Root
from exactspline.bivariate.singular_points import interval_around, kind_on, singular_cells
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.polynomials.two_parameters import S, T, as_form
from exactspline.roots.of_polynomials import exactly, roots_in


def test_intervals_around_numbers_keep_from_others():
    """None where another number, or an end of the unit interval, is in the interval or next to it."""
    random, (root,), seen = Random(3), roots_in(fmpz_poly([-1, 0, 2]), *UNIT.first), set()
    for t in (mpq(1, 3), exactly(root), mpq(0), mpq(1)):
        for bits in (2, 5, 9, 16):
            width = mpq(1, 1 << bits)
            for _ in range(40):
                place = root.enclosure(20)[0] if isinstance(t, Root) else t
                other = place + random.choice((1, -1)) * width * random.randint(0, 48) / 8
                if other == t:
                    continue
                found = interval_around(t, [other], bits)
                distance = abs(other - place) / width
                ends = [x for x in (0, 1) if x != t and abs(x - place) / width < 6]
                if found is None:
                    assert distance <= 6 or ends
                else:
                    assert found.low <= t <= found.high
                    assert not found.low - width <= other <= found.high + width
                    assert (found.low == 0) == (t == 0)
                    assert (found.high == 1) == (t == 1)
                    assert found.width <= 6 * width
                    assert found.low < t or t == 0
                    assert t < found.high or t == 1
                    theirs = interval_around(other, [t], bits) if 0 < other < 1 else None
                    assert theirs is None or theirs.high < found.low or found.high < theirs.low
                seen.add((bits, found is None))
    assert len(seen) == 8


@pytest.mark.parametrize(
    ("p", "box", "kind"),
    [
        (S * S + T * T, (-1, 1), "single point"),
        (-S * S - S * T - T * T, (-1, 1), "single point"),
        (S * S - T * T, (-1, 1), "two branches that cross"),
        (S * T, (-1, 1), "two branches that cross"),
        (S * S + 3 * S * T + T * T, (-1, 1), "two branches that cross"),
        (S * S + 2 * S * T + T * T, (-1, 1), None),
        (T * T - S**3, (-1, 1), None),
        (T * T - S * S - S**3, (-1, 1), None),
    ],
)
def test_kinds_of_hessians(p, box, kind):
    """Definite, indefinite, or of both kinds."""
    moved = as_form(p.compose(2 * S - 1, 2 * T - 1))
    middle = Interval(*(mpq(1, 2) + mpq(x, 4) for x in box))
    assert kind_on(moved, Box(middle, middle)) == kind


def test_cells_are_around_each_point():
    """A node and a cusp above one number."""
    found = singular_cells(as_form((5 * T - 1) * (5 * T - 1 - (2 * S - 1)) * ((4 * T - 3) ** 2 - (2 * S - 1) ** 3)))
    places = sorted(cell.zero.exact for cell in found)
    assert places == [(mpq(1, 2), mpq(1, 5)), (mpq(1, 2), mpq(3, 4))]
    for cell in found:
        s, t = cell.zero.exact
        (a, b), (c, d) = cell.box
        assert a < s < b
        assert c < t < d
    boxes = [cell.box for cell in found]
    assert not boxes[0].overlaps(boxes[1])
