"""What a question takes: places on a curve with a side."""

import pytest
from gmpy2 import mpq

import exactspline as xs
from exactspline.questions import takes

JUMP = xs.example("jump")
#: y = x² and then y = 0: κ jumps at 1, and so does the tangent.
CORNER = xs.Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 2], [(0, 0), ("1/2", 0), (1, 1), ("3/2", 1), (2, 1)])


def numbers(curve, asked):
    """The numbers without the parameter, and the side that is told."""
    return [(list(found.values.values())[1:], found.facts.get("side")) for found in xs.ask(curve, asked)]


def test_a_side_is_that_of_the_limit():
    assert numbers(JUMP, "value@1-,1+,1") == [
        ([mpq(2), mpq(0)], "left"),
        ([mpq(2), mpq(1)], "right"),
        ([mpq(2), mpq(1)], None),
    ]
    assert numbers(CORNER, "derivative@1-,1+") == [([mpq(1), mpq(2)], "left"), ([mpq(1), mpq(0)], "right")]
    (before, behind) = (values[0] for values, _ in numbers(CORNER, "curvature@1-,1+"))
    assert (before * before, behind) == (mpq(4, 125), 0)
    assert numbers(CORNER, "frame@1+")[0][0] == [1, 0, 0, 1]


def test_a_side_of_knots_or_features():
    assert [side for _, side in numbers(JUMP, "value@knots-")] == [None, "left", "left"]
    assert [side for _, side in numbers(JUMP, "value@knots+")] == ["right", "right", None]


@pytest.mark.parametrize("asked", ["value@0-", "value@2+", "split@1-", "insert:1@1+"])
def test_a_side_that_is_outside_or_has_no_meaning_is_refused(asked):
    with pytest.raises(takes.QuestionError, match=r"outside of the domain|one rational parameter"):
        xs.ask(JUMP, asked)


def test_the_sides_of_a_seam_are_the_ends_of_the_domain():
    """Refused before, though the seam of a closed curve is a knot like any other: here a corner."""
    loop = xs.Nurbs.bezier([(0, 0), (3, 3), (-2, 3), (0, 0)])
    first, last = xs.ask(loop, "frame@0"), xs.ask(loop, "frame@1")
    for seam in ("0", "1"):
        before, behind = (xs.ask(loop, f"frame@{seam}{sign}")[0].values for sign in "-+")
        assert before == last[0].values != first[0].values == behind
    assert [found.values["parameter"] for found in xs.ask(loop, "value@knots-")] == [1]
    moved = xs.constructors.joined(loop.split("1/3")[::-1])
    seam = [t for t in moved.breakpoints[1:-1] if moved(t) == (0, 0)]
    there = xs.ask(moved, f"frame@{seam[0]}-")[0].values
    assert [there[name] for name in ("Tx", "Ty")] == [last[0].values[name] for name in ("Tx", "Ty")]
