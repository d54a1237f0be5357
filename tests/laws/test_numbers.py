"""What is known of a number does not depend on who asked before."""

import pickle
from contextlib import suppress

import pytest
from gmpy2 import mpq

import exactspline as xs
from exactspline.display.forms import real_data
from exactspline.errors import ExactSplineError, OpenError, ReachError
from exactspline.interchange.examples import example_names
from exactspline.reals.real import square_root
from tests.support.sampled import sample
from workshop.vectors.items import items

ASKED = [
    "critical_points", "offset_cusps:1", "turning_points:0", "nearest:1/3,2", "nearest:1/3,2,1", "intersections:circle",
    "frame@critical_points", "frame@1/3", "bounding_box", "length", "joints",
]  # fmt: skip


def numbers_of(curve, asked):
    with suppress(ExactSplineError):  # a question about other curves
        return [x for item in items(curve, asked) for x in item.values.values()]
    return []


def decided(question, *given):
    try:
        return question(*given)
    except (ReachError, OpenError) as error:
        return type(error)


#: What anybody can see of a number.
SEEN = {
    "repr": repr,
    "decimal 3": lambda x: x.decimal(3),
    "decimal 40": lambda x: x.decimal(40),
    "closed form": lambda x: x.closed_form,
    "between": lambda x: real_data(x, 20),
    "exact": lambda x: x.exact,
    "mpf": lambda x: str(x.mpf(17)),
    "significant": lambda x: str(x.significant(7)),
    "near": lambda x: x.rational_near(9),
    "shown": lambda x: (str(x + 1), repr(x * x - 1), repr(2 * x)),
}


@pytest.mark.parametrize(("name", "asked"), sample([(n, a) for n in example_names() for a in ASKED], 60))
def test_what_is_seen_of_a_number_does_not_depend_on_the_order_of_questions(name, asked):
    """Passed: a `repr` with digits that is 1 after `exact` was read, `null` beside 4/15, other last digits after a
    refinement.
    """
    found = numbers_of(xs.example(name), asked)
    for x in sample(found, 6):
        first, last = pickle.loads(pickle.dumps(x)), pickle.loads(pickle.dumps(x))
        forwards = {what: decided(see, first) for what, see in SEEN.items()}
        decided(last.enclosure, 90)
        decided(getattr, last, "exact")
        assert {what: decided(see, last) for what, see in reversed(SEEN.items())} == forwards
        assert {what: decided(see, first) for what, see in SEEN.items()} == forwards


@pytest.mark.parametrize("name", ["cubic_s", "ellipse", "vanishing_coefficient"])
@pytest.mark.parametrize("distance", [mpq(1), mpq(1, 2)])
def test_the_curvature_at_the_cusps_of_an_offset_is_one_over_the_distance(name, distance):
    """Was `null`, between 0.999… and 1.000…."""
    found = items(xs.example(name), f"offset_cusps:{distance}")
    assert found
    for item in found:
        value = xs.curvature(xs.example(name), item.values["parameter"])
        assert (real_data(value, 30)["exact"], str(value)) == (str(1 / distance), str(1 / distance))


T = xs.BSpline.identity(0, 4)
#: α is the zero of t³ − t − 1, β that of t⁴ − 10 t² + 1 in [3, 4], which is √2 + √3.
ALPHA, BETA = xs.zeros(T * T * T - T - 1).roots[0], xs.zeros((T * T - 5) * (T * T - 5) - 24).roots[-1]


@pytest.mark.parametrize(("number", "form"), [
    (lambda: xs.evaluate(T * T * T - T, ALPHA), "1"),
    (lambda: ALPHA * (ALPHA * ALPHA - 1), "1"),
    (lambda: square_root(ALPHA**3 - ALPHA + 7), "2√2"),
    (lambda: xs.evaluate((T * T - 3) / 4, BETA), "(1 + √6)/2"),
    (lambda: (BETA - square_root(2)) * 5 - 1, "-1 + 5√3"),
    (lambda: square_root(5 + 2 * square_root(6)) - square_root(3), "√2"),
    (lambda: xs.zeros((T * T * T - 2) * (T * T - 3)).roots[1], "√3"),
    (lambda: 1 / xs.zeros(3 * T * T - 7 * T + 3).roots[0], "(7 + √13)/6"),
    (lambda: ALPHA, None), (lambda: BETA, None), (lambda: ALPHA + BETA, None), (lambda: ALPHA * square_root(2), None),
    (lambda: xs.evaluate(T * T - T * 3, ALPHA), None), (lambda: square_root(2) + square_root(3), None),
    (lambda: square_root(1 + square_root(2)), None),
])  # fmt: skip
def test_numbers_of_degree_at_most_2_are_known_as_such(number, form):
    """All of them were said to have no closed form; numbers of a higher degree have none, and that is proved."""
    x = number()
    assert x.closed_form == form
    assert real_data(x, 30).items() >= {"exact": form}.items()
    assert "open" not in real_data(x, 30)
    if form is not None:
        assert str(x) == repr(x)[6:-1] == form or isinstance(x, xs.Root)
        assert len(x.minimal_polynomial()) <= 3


def test_what_is_not_decided_is_told_from_what_is_proved():
    """Both were `null`."""
    long = ALPHA * mpq(1, 10**50_000 + 1) + BETA
    assert real_data(long, 30)["open"] is True
    with pytest.raises(ReachError, match="coefficients of"):
        long.closed_form  # noqa: B018
    assert repr(long) == "<Real 3.1462644…>"
    assert real_data(xs.ask(xs.example("parabola"), "length"), 30)["open"] is True
    bent = xs.Nurbs(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (4, 4)])
    degrees = next(item.values["degrees"] for item in items(bent, "corners"))
    assert degrees.exact is degrees.closed_form is None, "an angle is a rational number of degrees or transcendental"
