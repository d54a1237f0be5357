"""Certificates of intersections: those of the library are accepted by the standard-library checker, corrupted ones are
not, and false ones made on purpose are not either.
"""

import json
from fractions import Fraction
from random import Random

import pytest

from exactspline import check_certificate, example, intersections, self_intersections
from exactspline.certificates.intersections import polynomial_determinant, sign_throughout
from exactspline.errors import ReachError, ShapeError
from exactspline.geometry.pairs.intersection_certificate import intersection_certificate
from tests.campaigns.certificates import SORTS, campaign, of_intersections
from tests.support.bisector_oracle import bezier

#: How many certificates of each sort are to be rejected.
CORRUPTED = 60


def test_determinants_take_a_time_bounded_by_a_power_of_their_size():
    """Before, the checker went through all sets of columns: a pair of degree 14 took minutes, one of 20 no end."""
    size = 18
    rows = [[[i + j, 0] if i < j else [-i, 1] if i == j else [0, 0] for j in range(size)] for i in range(size)]
    expected = [1]
    for i in range(size):
        expected = [a - i * b for a, b in zip([0, *expected], [*expected, 0], strict=True)]
    assert polynomial_determinant(rows[::-1]) == [-x for x in expected]  # 153 exchanges of rows
    assert not any(polynomial_determinant([*rows[:-1], rows[0]]))


@pytest.mark.parametrize("seed", range(45))
def test_the_checker_counts_the_same_points(seed):
    curves, certificate = of_intersections(Random(seed))
    again, found = json.loads(json.dumps(certificate)), intersections(*curves)
    # a point at a knot is one of each pair of segments
    if not any(c.closed or c.segments > 1 for c in curves):
        assert check_certificate(again) == {"points": len(found)}
    else:
        assert check_certificate(again)["points"] >= len(found)


@pytest.mark.parametrize("sort", SORTS)
def test_a_changed_certificate_is_rejected_or_true_of_its_data(sort):
    """Parts are changed, left out, repeated or exchanged, of the data too; what is accepted is true by elimination."""
    found = campaign(sort, CORRUPTED, 7)
    assert found["accepted and false"] == []
    assert 0 < found["accepted with other data"] < found["accepted"] < found["rejected"]


def forged(change):
    """The certificate of a parabola and a line with two points, changed."""
    parabola, line = bezier((-1, 1), (0, -1), (1, 1)), bezier((-2, "1/3"), (2, "1/2"))
    certificate = json.loads(json.dumps(intersection_certificate(line, parabola)))
    assert check_certificate(certificate) == {"points": 2}
    change(certificate)
    return certificate


@pytest.mark.parametrize(
    ("change", "flaw"),
    [
        (lambda c: c["pairs"][0]["zeros"].pop(), "another number claimed"),
        (lambda c: c["pairs"].pop(), "not every pair"),
        (lambda c: c["pairs"].append(c["pairs"][0]), "not every pair"),
        (lambda c: c.update(first=[], pairs=[]), "a curve without segments"),  # accepted before
        (lambda c: c.update(first=[], second=[], pairs=[]), "a curve without segments"),
        (lambda c: c["pairs"][0]["zeros"][0].update(s="outside"), "signs do not prove"),
        (lambda c: c["pairs"][0]["zeros"][0].update(s="start"), "not the start"),
        (lambda c: c["pairs"][0]["zeros"][0].update(s="somewhere"), "unknown place"),
        (lambda c: c["pairs"][0]["zeros"][0].update(low="0", high="1"), "outside the leaf"),
        (lambda c: c["pairs"][0].update(apart={"axis": 1, "at": "0"}), "not apart"),
        (lambda c: c["pairs"][0].update(exchanged=1), "neither true nor false"),
        (lambda c: c["first"][0]["w"].__setitem__(0, "-1"), "not positive"),
        (lambda c: c["first"][0]["w"].pop(), "different degrees"),
        (lambda c: c["pairs"][0]["elimination"].update(leaves=[["0", "1", 0]]), "sign changes"),
    ],
)
def test_a_false_certificate_is_rejected_with_its_flaw(change, flaw):
    with pytest.raises(ValueError, match=flaw):
        check_certificate(forged(change))


def test_a_certificate_of_splines_names_pairs_that_are_apart():
    certificate = intersections(example("circle"), example("ellipse_skew")).certificate()
    assert check_certificate(certificate)["points"] == len(intersections(example("circle"), example("ellipse_skew")))


def test_what_has_no_certificate_says_so():
    loop = bezier((0, 0), (3, 3), (-2, 3), (1, 0))
    with pytest.raises(ReachError, match="arcs in common"):
        intersections(loop, loop).certificate()
    with pytest.raises(ShapeError, match="space"):
        intersections(example("twisted_cubic"), example("helix_like")).certificate()
    with pytest.raises(ShapeError, match="itself"):
        self_intersections(loop).certificate()


#: A parabola whose parameters 1/2 and 3/4 are on the x-axis, and a segment of that axis.
PARABOLA, AXIS = bezier((0, 3), (1, -2), (2, 1)), bezier((-1, 0), (3, 0))


def of_two_zeros(point, leaves, *places):
    """The certificate of both points with the zeros of the determinant proved by other leaves, and at other places."""
    certificate = json.loads(json.dumps(intersection_certificate(AXIS, PARABOLA)))
    pair = certificate["pairs"][0]
    pair["elimination"] = {"factors": [], "points": [point], "leaves": leaves}
    pair["zeros"] = [{"low": low, "high": high, "s": "inside"} for low, high in places]
    return certificate


AFTER, BEFORE = [["0", "1/2", 0], ["1/2", "1", 1]], [["0", "3/4", 1], ["3/4", "1", 0]]


def test_a_zero_at_the_end_of_a_leaf_is_not_the_one_inside():
    """Mutants passed: both points proved at the parameter 1/2, or both at 3/4, or one at 5/8, where there is none."""
    assert check_certificate(of_two_zeros("1/2", AFTER, ("1/2", "1/2"), ("5/8", "7/8"))) == {"points": 2}
    assert check_certificate(of_two_zeros("3/4", BEFORE, ("1/4", "5/8"), ("3/4", "3/4"))) == {"points": 2}
    for leaves, point in ((AFTER, "1/2"), (BEFORE, "3/4")):
        with pytest.raises(ValueError, match="a place that is not the zero"):
            check_certificate(of_two_zeros(point, leaves, (point, point), (point, point)))
    with pytest.raises(ValueError, match="a place that is not the zero"):
        check_certificate(of_two_zeros("1/2", AFTER, ("1/2", "1/2"), ("5/8", "5/8")))


@pytest.mark.parametrize("place", [("5/8", "3/4"), ("3/4", "7/8"), ("1/2", "7/8")])
def test_a_place_does_not_end_at_a_zero(place):
    """A mutant passed: an interval at whose end there is a zero, which it need not contain."""
    with pytest.raises(ValueError, match="a place without the zero"):
        check_certificate(of_two_zeros("1/2", AFTER, ("1/2", "1/2"), place))


def test_a_start_of_a_segment_is_proved_around_a_rational_zero():
    """A mutant refused a zero that one linear factor has, where the place is an interval."""
    curve = bezier((0, 0), ("1/2", 0), (1, 1))
    certificate = json.loads(json.dumps(intersection_certificate(bezier(("1/3", "1/9"), ("1/3", 1)), curve)))
    pair = certificate["pairs"][0]
    pair["elimination"] = {"factors": [], "points": [], "leaves": [["0", "1", 1]]}
    pair["zeros"] = [{"low": "1/4", "high": "1/2", "s": "start"}]
    assert check_certificate(certificate) == {"points": 1}
    pair["zeros"] = [{"low": "2/5", "high": "1/2", "s": "start"}]
    with pytest.raises(ValueError, match="without the zero"):
        check_certificate(certificate)


def apart(first, second, axis=0):
    """The certificate of two segments apart in a coordinate, at 5."""
    return {
        "format": "exactspline certificate 1",
        "what": "intersections",
        "first": [first],
        "second": [second],
        "pairs": [{"segments": [0, 0], "apart": {"axis": axis, "at": "5"}}],
    }


def segment(x, weights=("1", "1")):
    return {"x": x, "y": x, "w": list(weights)[: len(x)]}


@pytest.mark.parametrize("axis", [0, 1])
def test_segments_are_apart_in_either_coordinate(axis):
    assert check_certificate(apart(segment(["0", "1"]), segment(["6", "7"]), axis)) == {"points": 0}


@pytest.mark.parametrize(
    ("first", "flaw"), [(segment(["0"]), "of degree 0"), (segment(["-1", "-1"], ["1", "0"]), "not positive")]
)
def test_what_is_not_a_segment_is_refused(first, flaw):
    """A mutant passed: a single point, and a point at infinity."""
    with pytest.raises(ValueError, match=flaw):
        check_certificate(apart(first, segment(["6", "7"])))


@pytest.mark.parametrize(("form", "low", "high", "expected"), [
    ([1, 2], 0, 1, 1), ([-1, -2], 0, 1, -1), ([1, -2], 0, 1, 0), ([-1, 2], 0, 1, 0),
    ([-1, 3], "1/8", "1/8", -1), ([-1, 3], "1/4", "1/4", 0), ([-1, 3], "1/2", "1/2", 1),
])  # fmt: skip
def test_a_form_has_a_sign_where_all_its_coefficients_have_it(form, low, high, expected):
    """A checker that asks one coefficient, or none at a point, would pass our own certificates."""
    assert sign_throughout(form, Fraction(low), Fraction(high)) == expected
