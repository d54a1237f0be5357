"""Regions of several contours: against sums over grids of points, and the contours of glyphs."""

import random

import pytest
from gmpy2 import mpq

from exactspline import Nurbs, example, read
from exactspline.errors import ShapeError
from exactspline.geometry.pairs.regions import Region


def square(x, y, size, *, clockwise=False):
    corners = [(x, y), (x + size, y), (x + size, y + size), (x, y + size), (x, y)]
    return Nurbs(1, [0, 0, 1, 2, 3, 4, 4], corners[::-1] if clockwise else corners)


@pytest.mark.parametrize("rule", ["nonzero", "even-odd"])
@pytest.mark.parametrize("seed", range(4))
def test_moments_are_sums_over_the_cells_of_a_grid(seed, rule):
    """Nested squares with integer corners, of both directions: each cell is inside or outside as its middle is."""
    draw = random.Random(seed)
    curves = [square(2 * k, 2 * k, 22 - 4 * k, clockwise=draw.random() < 0.5) for k in range(draw.randint(1, 5))]
    curves.append(square(28, draw.randint(0, 9), 4, clockwise=draw.random() < 0.5))
    draw.shuffle(curves)
    region = Region(curves, rule)
    half, cells = mpq(1, 2), []
    for x in range(-1, 34):
        for y in range(-1, 24):
            if region.contains((x + half, y + half)) == "inside":
                cells.append((x, y))
    moments = {(x.facts["x"], x.facts["y"]): x.values["moment"] for x in region.moments(2)}
    assert moments[0, 0] == region.area == len(cells)
    assert moments[1, 0] == sum((x + half for x, _ in cells), mpq(0))
    assert moments[1, 1] == sum(((x + half) * (y + half) for x, y in cells), mpq(0))
    assert moments[0, 2] == sum((mpq((y + 1) ** 3 - y**3, 3) for _, y in cells), mpq(0))


def test_the_area_of_a_path_with_a_hole():
    """As a file has it: the contours of one path."""
    path = '<path d="M0 0L4 0L4 4Q2 6 0 4ZM1 1L1 2L2 2L2 1Z"/>'
    curves = [named.curve for named in read(f'<svg xmlns="http://www.w3.org/2000/svg">{path}</svg>'.encode()).curves]
    # the parabola adds two thirds of the chord times the height 1
    assert all(Region(curves, rule).area == 16 + mpq(8, 3) - 1 for rule in ("nonzero", "even-odd"))


def test_winding_numbers_of_a_region():
    region = Region([square(0, 0, 4), square(1, 1, 2)])
    assert [region.winding_number(p) for p in ((2, 2), ("1/2", 2), (5, 5))] == [2, 1, 0]
    assert Region(region.curves, "even-odd").contains((2, 2)) == "outside"


@pytest.mark.parametrize(("curves", "why"), [
    ([square(0, 0, 4), square(2, 2, 4)], "meet each other"),
    ([square(0, 0, 4), square(4, 0, 4)], "meet each other"),
    ([Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (2, 2), (2, 0), (0, 2), (0, 0)])], "meets itself"),
    ([example("cubic_s")], "closed"),
])  # fmt: skip
def test_what_has_no_area_says_why(curves, why):
    with pytest.raises(ShapeError, match=why):
        _ = Region(curves).area
