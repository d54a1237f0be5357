"""A zero that is computed when it is asked for is told as the zero of the whole form is, which isolation finds."""

import pickle
import subprocess
import sys

import pytest
from flint import fmpz_poly
from gmpy2 import mpq

from exactspline import Nurbs, Root, analyse
from exactspline.numbers.intervals import Interval
from exactspline.polynomials.isolation import LocalPolynomial, LocalZero, isolate
from exactspline.polynomials.zero_places import enclosures
from exactspline.roots.root import LazyRoot, root_inside

Z = fmpz_poly([0, 1])
UNIT = Interval(mpq(0), mpq(1))


class Given:
    """A form, and how often its zeros were isolated."""

    def __init__(self, p):
        self.form, self.asked = LocalPolynomial(p), 0

    @property
    def inner(self):
        self.asked += 1
        return isolate(self.form.polynomial, self.form.polynomial.degree()).inner


FORMS = [(Z - 1) * (Z**2 - 3 * Z + 1), (Z - 2) * (3 * Z - 1) * (Z**2 - 3), (5 * Z - 2) * (Z - 7), (Z - 1) * (Z - 3)]


def around(zero):
    """An interval of doubles with no other zero of these forms."""
    low, high = (float(end) for end in zero[:2])
    return (low - 2**-6, high + 2**-6) if low == high else (low, high)


@pytest.mark.parametrize("p", FORMS)
def test_it_is_the_zero_that_isolation_finds(p):
    """Also where it is rational, and hit by a midpoint or not."""
    for number, own in enumerate(isolate(p, p.degree()).inner):
        late = LazyRoot(Given(p), number, own.signs[0], around(own))
        assert (late.signs, late.multiplicity) == (own.signs, 1) == (late.exactly.signs, late.exactly.multiplicity)
        (factor, sign), middle = late.changing, (own.low + own.high) / 2
        assert sign == own.signs[0] if factor is late.form.form else sign in (1, -1)
        assert 0 <= late.low < late.high <= 1
        (*_, found) = enclosures(factor, late.low, late.high, sign, 60)
        assert found[0] <= middle <= found[1] if own.low == own.high else own.low <= found[0] <= found[1] <= own.high
        assert pickle.loads(pickle.dumps(late))[:4] == late.exactly[:4]


@pytest.mark.parametrize("p", FORMS)
def test_balls_find_what_isolation_finds(p):
    """Intervals of any width, and doubles, of a zero on a segment."""
    side = Interval(mpq(1, 3), mpq(9, 7))
    for number, own in enumerate(isolate(p, p.degree()).inner):
        exact = Root(side.at(own.low), side.at(own.high), (1, 1), own.signs, own, side)
        local = Root(own.low, own.high, (1, 1), own.signs, own, UNIT)
        late = LazyRoot(Given(p), number, own.signs[0], around(local.refine(4)))
        for bits in (10, 40, 100):
            low, high = late.part(bits)
            assert (high - low) * 2**bits <= 1
            assert side.at(low) <= exact <= side.at(high)
        assert root_inside(late, side).double() == exact.double()


def test_an_interval_around_a_zero_is_a_part_of_the_one_given():
    """However few bits are asked for: it was grown on both sides, beyond the end that is next to the zero."""
    late = LazyRoot(Given(Z - 1), 0, -1, (0.5 - 2**-40, 0.75))
    low, high = late.part(10)
    assert 0.5 - 2**-40 <= low < 0.5 < high < 0.5 + 2**-10
    low, high = root_inside(late, UNIT).refine(3)
    assert late.low < low <= 0.5 <= high < late.high


def test_balls_say_nothing_of_a_promise_that_is_not_kept():
    """No zero in the interval, one from − to +, two of them."""
    for interval, before in (((0.0, 0.25), 1), ((0.25, 0.3), -1), ((0.2, 0.8), 1)):
        late = LazyRoot(Given(Z**2 - 3 * Z + 1), 0, before, interval)
        assert (late.ball, late.part(20)) == (None, None)
    assert LazyRoot(Given(Z**2 - 3 * Z + 1), 0, 1, (0.25, 0.3)).ball is not None


@pytest.mark.parametrize("p", [3 * Z - 1, Z**2 - 3 * Z + 1, Z**3 - 2])
def test_no_zeros_are_isolated_where_that_is_not_needed(p):
    (given, *_), before = [Given(p)], int(p[0] > 0) * 2 - 1
    late = LazyRoot(given, 0, before, (0.125, 0.5))
    assert (late.low, late.high) == (mpq(1, 8), mpq(1, 2))
    assert late.changing == (given.form, before)
    assert late.signs == (before, -before)
    assert given.asked == 0
    with pytest.raises(AttributeError):
        late.unknown  # noqa: B018 (it is asked for)
    assert given.asked == 0
    assert isinstance(late.exactly, LocalZero)
    assert late.factor is late.exactly.factor
    assert given.asked == 1


#: Promises of a zero of 1 − 3z + z² that are not kept: no zero, one from − to +, one that is elsewhere.
BROKEN = """
from flint import fmpz_poly
from exactspline import Nurbs, analyse
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval
from exactspline.polynomials.isolation import LocalPolynomial
from exactspline.polynomials.zero_places import enclosures
form = LocalPolynomial(fmpz_poly([1, -3, 1]))
for low, high, sign in ((mpq(0), mpq(1, 4), 1), (mpq(0), mpq(1, 2), -1), (mpq(1, 3), mpq(2, 3), 1)):
    try:
        print(list(enclosures(form, low, high, sign, 200)))
    except AssertionError as error:
        print(error)
"""


def test_a_promised_change_of_sign_that_is_not_there_is_an_error():
    """Its refinement never ended, in a process of its own therefore."""
    done = subprocess.run([sys.executable, "-c", BROKEN], capture_output=True, text=True, check=True, timeout=30)
    assert [line.split(" between ")[0] for line in done.stdout.splitlines()] == [
        "the sign does not change from +1",
        "the sign does not change from -1",
        "the sign does not change from +1",
    ]


def test_a_zero_that_changes_its_sign_in_another_way_than_promised_is_an_error():
    """It was told with the signs that were promised."""
    with pytest.raises(AssertionError, match="change of sign"):
        LazyRoot(Given(Z**2 - 3 * Z + 1), 0, -1, (0.25, 0.3)).exactly  # noqa: B018  # what raises


def test_few_digits_come_from_balls_and_are_reported():
    """Before: to seven digits the form was isolated exactly, and `progress` was not called."""
    curve = Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (1, 3), (2, -2), (3, 1)])
    for digits in (3, 7, 20):
        (found,), seen = analyse(Nurbs(3, curve.knots, curve.control_points)).inflections, []
        low, high = found.root.refine(digits, seen.append)
        assert (high - low <= mpq(1, 10**digits), seen) == (True, [digits])
        assert low < found.root.exact < high
