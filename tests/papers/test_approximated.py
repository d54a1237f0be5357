"""What the page on approximations says is what is found."""

from gmpy2 import mpq

from docs.approximated import PAGE, angle, approximation, found, least, table, within
from exactspline import analyse


def test_rows_of_the_page_are_computed():
    page = PAGE.read_text(encoding="utf-8")
    for row in (
        found("circle", 0, None),
        found("circle", 5, mpq(1, 10**4)),
        found("ellipse", 0, None),
        found("ellipse", 5, mpq(1, 10**4)),
        found("space", 0, None),
        found("space", 3, mpq(1, 100)),
        found("space", 5, mpq(1, 100)),
    ):
        assert table([row]).splitlines()[-1] in page


def test_a_tolerance_is_met_and_no_smaller_one():
    curve = least("circle", 3, mpq(1, 100))
    assert within(curve, "circle", mpq(1, 100))
    assert not within(approximation("circle", 3, 1), "circle", mpq(1, 100))
    x, y = curve(mpq(1, 3))
    assert abs(x * x + y * y - 1) < mpq(21, 1000)


def test_splines_meet_as_smoothly_as_is_said():
    cubics, quintics = (analyse(approximation("circle", degree, 2)).joints for degree in (3, 5))
    assert {joint.order for joint in cubics} == {1}
    assert all(joint.order >= 2 for joint in quintics)


def test_angles_are_those_of_the_circle():
    assert abs(angle(mpq(1)) - mpq("1.570796326794897")) < mpq(1, 10**14)
    assert abs(2 * angle(mpq(1, 2)) + 2 * angle(mpq(1, 3)) - mpq("3.141592653589793")) < mpq(1, 10**14)
