"""Trimmed curves of Open CASCADE's text: the part of each kind of curve between two parameters."""

import math

import pytest
from gmpy2 import mpq

from exactspline import Nurbs, read

CUBIC = "7 0 0 3 4 2  0 0 1  1 2 1  3 2 1  4 0 1   0 4 1 4"
#: A closed quadratic by one period of length 4, and the whole of it.
PERIODIC = "7 0 1 2 4 5  0 0 0  4 0 0  4 4 0  0 4 0   0 1 1 1 2 1 3 1 4 1"
SQUARE = [(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0)]


def of_brep(*curves, **more):
    head = "DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\nCurve2ds 0\n"
    text = "\n".join([f"Curves {len(curves)}", *curves, "Polygon3D 0", ""])
    return read((head + text).encode(), **more)


def at_ends(curve):
    return [tuple(curve(t, side)) for t, side in zip(curve.domain, ("right", "left"), strict=True)]


def test_a_part_of_a_spline_and_the_outer_one_of_two():
    whole = of_brep(CUBIC).curve
    for text in ("8 0.25 0.75\n", "8 0.25 0.75\n8 0 1\n"):
        assert of_brep(text + CUBIC).curve == whole.restrict(mpq(1, 4), mpq(3, 4))


def test_a_part_beyond_the_domain_has_a_note():
    [named] = of_brep(f"8 0.5 2\n{CUBIC}").curves
    assert named.curve.domain == (mpq(1, 2), 1)
    assert "only 0 to 1 is in the domain" in named.notes[0]


@pytest.mark.parametrize(
    ("low", "high"), [(0, 4), ("0.5", "2.25"), ("3.5", "5.25"), ("1", "5"), (3, 4), (-1, 1), ("40.5", 42), (-8, -4)]
)
def test_a_part_of_a_periodic_spline_may_run_over_its_seam(low, high):
    curve = of_brep(f"8 {low} {high}\n{PERIODIC}").curve
    twice = Nurbs(2, range(-2, 11), [*SQUARE, *SQUARE, *SQUARE[:2]])
    moved = of_brep(PERIODIC).curve.domain[0]
    assert curve.domain == (mpq(low), mpq(high))
    for k in range(9):
        t = mpq(low) + (mpq(high) - mpq(low)) * mpq(k, 8)
        side = "left" if k == 8 else "right"
        # in the first period of `twice`, or in the second where the part runs over the seam
        within = t - mpq(low) + (mpq(low) - moved) % 4
        assert curve(t, side) == twice(within, side)


def test_a_part_that_runs_backwards_is_named_as_such():
    [named] = of_brep(f"8 0.75 0.25\n{CUBIC}").curves
    assert (named.curve.domain, "run backwards" in named.notes[0]) == ((0, 1), True)


def test_parts_of_lines_and_parabolas_are_exact():
    line = of_brep("8 -2 3\n1 1 0 5  0 1 0").curve
    assert (line.degree, at_ends(line)) == (1, [(1, -2, 5), (1, 3, 5)])
    parabola = of_brep("8 -2 4\n4 1 0 0  0 0 1  1 0 0  0 1 0  0.5").curve
    a, b = parabola.domain
    for k in range(9):
        x, y, z = parabola(a + (b - a) * mpq(k, 8), "left" if k == 8 else "right")
        # C + u²/(4 f) X + u Y, with f = 1/2
        assert (x, z) == (1 + y * y / 2, 0)
    assert [y for _, y, _ in at_ends(parabola)] == [-2, 4]


def test_a_quarter_of_an_ellipse_is_exact():
    ellipse = of_brep(f"8 {math.pi / 2!r} {math.pi!r}\n3 0 0 0  0 0 1  1 0 0  0 1 0  2 1").curve
    assert at_ends(ellipse) == [(0, 1, 0), (-2, 0, 0)]
    assert all((x / 2) ** 2 + y * y == 1 for x, y, _ in (ellipse(mpq(k, 7)) for k in range(7)))


def test_other_parts_of_circles_are_within_an_error_or_named():
    text = "8 0.3 2\n2 0 0 0  0 0 1  1 0 0  0 1 0  5"
    [skipped] = of_brep(text).skipped
    assert "--approximate E" in skipped.why
    assert skipped.curve
    [named] = of_brep(text, approximate="1e-9").curves
    for (x, y, _), angle in zip(at_ends(named.curve), (0.3, 2), strict=True):
        assert x * x + y * y == 25
        assert math.dist((x, y), (5 * math.cos(angle), 5 * math.sin(angle))) < 2e-9
    assert any("ends are moved along the curve" in note for note in named.notes)


def test_what_is_not_read_has_a_reason_and_the_rest_goes_on():
    hyperbola, flat = "5 0 0 0  0 0 1  1 0 0  0 1 0  2 1", "4 0 0 0  0 0 1  1 0 0  0 1 0  0"
    offset = f"9 0.5\n0 0 1\n{CUBIC}"
    found = of_brep(f"8 0 1\n{hyperbola}", f"8 0 1\n{flat}", "1 0 0 0 1 0 0", hyperbola, f"8 0.25 0.5\n{offset}", CUBIC)
    assert [(x.what, x.curve) for x in found.skipped] == [
        ("hyperbola", True), ("parabola", True), ("line", False), ("hyperbola", True), ("offset curve", True),
    ]  # fmt: skip
    assert all("write it as a spline" in x.why or "write its part as a spline" in x.why for x in found.skipped)
    assert [x.curve.domain for x in found.curves] == [(mpq(1, 4), mpq(1, 2)), (0, 1)]
    assert not found.complete


def with_edges(curves, *edges, **more):
    """Curves, and edges by the number of their curve and two parameters as text."""
    head = "DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\nCurve2ds 0\n"
    shapes = [f"Ed\n 1e-07 1 1 0\n1  {k} 0 {low} {high}\n0\n\n0101000\n+2 0 -1 0 *" for k, low, high in edges]
    shapes.append("Ed\n 1e-07 1 1 1\n2  1 1 0 0 1\n0\n\n0101000\n*")  # degenerate: no curve in space
    text = "\n".join([f"Curves {len(curves)}", *curves, f"TShapes {len(shapes)}", *shapes, ""])
    return read((head + text).encode(), **more)


CIRCLE, LINE = "2 0 0 0  0 0 1  1 0 0  0 1 0  5", "1 1 0 5  0 1 0"


def test_edges_are_parts_of_their_curves():
    """Before: every straight edge was missing, with exit status 0, and an arc was its full circle."""
    half = "3.14159265358979"
    found = with_edges([LINE, CIRCLE, CUBIC], (1, "-2", "3"), (2, "0", half), (2, half, "6.28318530717959"))
    assert not found.skipped
    line, upper, lower, whole = (named.curve for named in found.curves)
    assert at_ends(line) == [(1, -2, 5), (1, 3, 5)]
    assert [at_ends(upper), at_ends(lower)] == [[(5, 0, 0), (-5, 0, 0)], [(-5, 0, 0), (5, 0, 0)]]
    assert (upper(1), lower(1)) == ((0, 5, 0), (0, -5, 0))
    # what no edge uses is whole
    assert whole.domain == (0, 1)
    assert found.complete


def test_an_edge_that_several_wires_use_is_one_curve():
    assert len(with_edges([CUBIC], (1, "0", "1"), (1, "0", "1")).curves) == 1
    two = with_edges([CUBIC], (1, "0", "0.5"), (1, "0.5", "1")).curves
    assert [named.curve.domain for named in two] == [(0, mpq(1, 2)), (mpq(1, 2), 1)]


def test_a_parameter_rounded_to_fewer_digits_than_the_knots_is_the_end():
    longer = CUBIC.replace("0 4 1 4", "0 4 0.98765432109876543 4")
    [named] = with_edges([longer], (1, "0", "0.987654321098765")).curves
    assert named.curve.domain[1] == mpq("0.98765432109876543")
    assert not named.notes
    for shorter in ("0.9876543210987", "0.9876"):
        [named] = with_edges([longer], (1, "0", shorter)).curves
        assert named.curve.domain[1] == mpq(shorter)
        assert "the entity uses the parameters" in named.notes[0]


def test_the_whole_of_a_circle_by_its_edge_and_by_itself():
    by_edge, alone = with_edges([CIRCLE], (1, "0", "6.28318530717959")).curve, of_brep(CIRCLE).curve
    assert by_edge == alone
    assert by_edge.closed


def test_numbers_of_an_edge_that_are_none_are_named():
    [skipped] = with_edges([CUBIC], (1, "0", "x")).skipped
    assert "not a decimal number" in skipped.why
