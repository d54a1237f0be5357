"""Pieces that are nearly lines or arcs, replaced by exact ones."""

from random import Random

import pytest
from gmpy2 import mpq
from mpmath import mp, mpf

import exactspline as xs
from exactspline.errors import ShapeError
from exactspline.geometry.recognition.pieces import recognized
from exactspline.geometry.recognition.snapping import snapped
from exactspline.splines.precision import written_precision
from tests.support.vectors import mpf_of

EPSILON = mpq(1, 10**6)


@pytest.fixture(autouse=True)
def thirty_digits():
    with mp.workdps(30):
        yield


def chain(random):
    """A line, an arc and a wave, rounded to eight digits: knots 0, 1, 2, 3."""
    cosine = mpq(random.randint(1, 9), 10)
    sine = mp.sqrt(1 - mpf(int(cosine * 10)) ** 2 / 100)
    end = (sine, 1 - mpf(int(cosine * 10)) / 10)
    legs = (1 - mpf(int(cosine * 10)) / 10) / sine
    weight = mp.sqrt((1 + mpf(int(cosine * 10)) / 10) / 2)
    exact = [(-2, 0), (-1, 0), (0, 0), (legs, 0), end, (3, 4), (1, 5)]
    points = [tuple(mpq(mp.nstr(mpf(x), 8)) for x in point) for point in exact]
    # a line that is not quite straight
    points[1] = (points[1][0], mpq(random.choice([1, -1]), 10**8))
    weights = [1, 1, 1, mpq(mp.nstr(weight, 8)), 1, 1, 1]
    return xs.Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 3, 3, 3], points, weights)


def test_pieces_become_exact_and_all_else_stays():
    """The distance that is said is that of points computed in 40 digits; the curve elsewhere is the same at its own
    parameters."""
    random = Random(7)
    for _ in range(12):
        curve = chain(random)
        found = snapped(curve, ["line", "circle"], EPSILON)
        line, arc = found.replaced
        assert (str(line.piece), str(arc.piece), found.kept) == ("[0, 1]", "[1, 2]", ())
        assert [piece.exact for piece in recognized(found.curve, EPSILON)][:2] == [True, True]
        assert {t: found.curve(t) for t in (0, 1, 2, 3)} == {t: curve(t) for t in (0, 1, 2, 3)}
        assert all(found.curve(2 + mpq(k, 7)) == curve(2 + mpq(k, 7)) for k in range(8))
        centre, radius = arc.shape.centre, arc.shape.radius
        for k in range(50):
            x, y = curve(1 + mpq(k, 49), "left")
            away = abs(mp.sqrt(mpf_of((x - centre[0]) ** 2 + (y - centre[1]) ** 2)) - mpf_of(radius.enclosure(30).low))
            assert away <= mpf_of(arc.within) * (1 + mpf(10) ** -20)
        before, behind = curve("3/2"), found.curve("3/2")
        assert sum((a - b) ** 2 for a, b in zip(before, behind, strict=True)) < 1, "the other arc of the circle"


def test_a_polynomial_curve_of_several_segments():
    """Passed before: a traceback, as the weight function of a polynomial curve has degree 0."""
    points = [(0, 0), (1, "1e-12"), (2, 0), (3, 1), (2, 3)]
    curve = xs.Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 2], points)
    found = snapped(curve)
    assert [str(piece.piece) for piece in found.replaced] == ["[0, 1]"]
    assert [found.curve(t) for t in ("1/2", "3/2")] == [(1, 0), curve("3/2")]


def test_an_arc_runs_in_the_direction_of_the_curve():
    clockwise = xs.Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 1), (1, 1), (1, 0)], [1, "0.7071067811865476", 1])
    found = snapped(clockwise)
    assert len(found.replaced) == 1
    assert min(found.curve("1/2")) > 0


def test_a_whole_circle_stays_whole():
    """The arc from a point to itself is not one point."""
    half = "0.7071067811865476"
    points = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)]
    curve = xs.Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4], points, [1, half, 1, half, 1, half, 1, half, 1])
    found = snapped(curve, ["circle"])
    (piece,) = recognized(found.curve)
    assert (piece.exact, piece.whole, piece.shape.kind) == (True, True, "circle")


def test_what_is_exact_and_what_lies_in_space_stays():
    circle = xs.example("circle")
    assert snapped(circle).curve is circle
    arc = [(1, 0, 0), (1, 1, 0), (0, 1, 0)]
    in_space = xs.Nurbs(2, [0, 0, 0, 1, 1, 1], arc, [1, "0.7071067811865476", 1])
    found = snapped(in_space)
    assert (found.curve, found.replaced, len(found.kept)) == (in_space, (), 1)
    nearly = xs.Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0, 0), (1, 1, "1e-12"), (2, 2, 0)])
    assert recognized(snapped(nearly).curve)[0].exact


def test_other_shapes_are_refused():
    with pytest.raises(ShapeError, match="line or circle"):
        snapped(xs.example("circle"), ["ellipse"])
    with pytest.raises(ShapeError, match="unknown"):
        snapped(xs.example("circle"), ["cirkle"])


@pytest.mark.parametrize(
    ("weight", "expected"),
    [("0.70710678", mpq(1, 2 * 10**8)), (mpq(0.5**0.5), mpq(1, 2**54)), (mpq(1, 3), mpq(1, 2)), ("1e-300", mpq(1, 2))],
)
def test_the_precision_that_was_written(weight, expected):
    """The numbers with the most digits say it, a fraction nothing; a double has 53 bits."""
    assert written_precision(xs.Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], [1, weight, 1])) == expected


def test_a_large_number_with_a_zero_at_its_end_has_the_last_digit():
    """1234.5670 written as 1234.567 was as precise as 123.45678."""
    points = [("1234.567", 0), ("123.45678", 1), (0, 1)]
    assert written_precision(xs.Nurbs(2, [0, 0, 0, 1, 1, 1], points)) == mpq(1, 2 * 10**4)
