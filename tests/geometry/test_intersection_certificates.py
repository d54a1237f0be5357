"""Certificates of intersections: those of the library are accepted by the standard-library checker, corrupted ones are
not, and false ones made on purpose are not either.
"""

import json
from random import Random

import pytest

from exactspline import check_certificate, example, intersections, self_intersections
from exactspline.errors import ReachError, ShapeError
from tests.campaigns.certificates import SORTS, campaign, of_intersections
from tests.support.bisector_oracle import bezier

#: How many certificates of each sort are to be rejected.
CORRUPTED = 60


@pytest.mark.parametrize("seed", range(45))
def test_the_checker_counts_the_same_points(seed):
    curves, certificate = of_intersections(Random(seed))
    again, found = json.loads(json.dumps(certificate)), intersections(*curves)
    counted = check_certificate(again)
    # a point at a knot is one of each pair of segments
    if any(c.closed or c.segments > 1 for c in curves):
        assert counted["points"] >= len(found)
    elif all(point.multiplicity for point in found):
        assert counted == {"points": len(found), "multiplicity": sum(point.multiplicity for point in found)}
    else:
        assert counted["points"] == len(found)


@pytest.mark.parametrize("sort", SORTS)
def test_a_changed_certificate_is_rejected_or_true_of_its_data(sort):
    """Parts are changed, left out, repeated or exchanged, of the data too; what is accepted is true by elimination."""
    found = campaign(sort, CORRUPTED, 7)
    assert found["accepted and false"] == []
    assert 0 < found["accepted with other data"] < found["accepted"] < found["rejected"]


PARABOLA = bezier((-1, 1), (0, -1), (1, 1))


def forged(change):
    """The certificate of a parabola and a line with two points, changed."""
    certificate = json.loads(json.dumps(intersections(bezier((-2, "1/3"), (2, "1/2")), PARABOLA).certificate()))
    assert check_certificate(certificate) == {"points": 2, "multiplicity": 2}
    change(certificate)
    return certificate


@pytest.mark.parametrize(
    ("change", "flaw"),
    [
        (lambda c: c["pairs"][0]["zeros"].pop(), "region that does not exist"),
        (lambda c: c["pairs"].pop(), "pairs of segments that are not given exactly once"),
        (lambda c: c["pairs"].append(c["pairs"][0]), "pairs of segments that are not given exactly once"),
        (lambda c: c.update(first=[], pairs=[]), "a curve without segments"),  # accepted before
        (lambda c: c.update(first=[], second=[], pairs=[]), "a curve without segments"),
        (lambda c: c["pairs"][0]["zeros"].append(c["pairs"][0]["zeros"][0]), "regions of two zeros that meet"),
        (lambda c: c["pairs"][0]["boxes"].pop(), "boxes that are missing"),
        (lambda c: c["first"][0]["w"].__setitem__(0, "-1"), "not positive"),
        (lambda c: c["first"][0]["w"].__setitem__(0, "0"), "not positive"),
        (lambda c: c["first"][0]["w"].pop(), "different lengths"),
        (lambda c: c["first"][0].update(x=["0"], y=["0"], w=["1"]), "a single point"),
        (lambda c: c["first"][0].update(y=["-5", "-5"]), "Jacobian may be singular"),
        (lambda c: c["second"][0].update(x=["3", "3", "3"]), "Jacobian may be singular"),
        (lambda c: c.update(format="exactspline certificate 1"), "format exactspline certificate 2"),
    ],
)
def test_a_false_certificate_is_rejected_with_its_flaw(change, flaw):
    with pytest.raises(ValueError, match=flaw):
        check_certificate(forged(change))


def test_a_certificate_of_splines_names_pairs_that_are_apart():
    certificate = intersections(example("circle"), example("ellipse_skew")).certificate()
    assert check_certificate(certificate)["points"] == len(intersections(example("circle"), example("ellipse_skew")))


@pytest.mark.parametrize("power", [3, 20, 60])
def test_curves_that_nearly_touch_have_a_certificate(power):
    """Before, sixteen bits of each coefficient: a certificate of two functions was refused where their gradients, or
    their sizes, differ by more.
    """
    line = bezier((-2, f"1/{1 << 2 * power}"), (2, f"1/{1 << 2 * power}"))
    found = intersections(line, PARABOLA)
    assert check_certificate(found.certificate()) == {"points": 2, "multiplicity": 2}


@pytest.mark.parametrize(
    ("other", "points", "multiplicity"),
    [
        (bezier((-1, 0), (1, 0)), 1, 2),  # the tangent at the vertex
        (bezier((-1, 1), (1, 1)), 2, 2),  # both ends
        (bezier((-1, "1/2"), (-1, 3)), 1, 1),  # through the start
    ],
)
def test_multiplicities_are_counted(other, points, multiplicity):
    certificate = json.loads(json.dumps(intersections(PARABOLA, other).certificate()))
    assert check_certificate(certificate) == {"points": points, "multiplicity": multiplicity}


def test_weights_of_one_sign_are_positive_in_a_certificate():
    circle = example("circle")
    turned = type(circle)(circle.degree, circle.knots, circle.control_points, [-w for w in circle.weights])
    line = bezier((-2, "1/2"), (2, "1/3"))
    assert intersections(turned, line).certificate() == intersections(circle, line).certificate()


def test_a_point_passed_twice_has_a_certificate():
    """Before, there was none: the loop passes (0, 0) twice, and so does the line, in two pairs of parameters."""
    loop, line = bezier((-1, -1), (2, 2), (-2, 2), (1, -1)), bezier((0, -2), (0, 3))
    found = intersections(loop, line)
    assert check_certificate(found.certificate())["points"] == len(found) > 1


def test_what_has_no_certificate_says_so():
    loop = bezier((0, 0), (3, 3), (-2, 3), (1, 0))
    with pytest.raises(ReachError, match="arcs in common"):
        intersections(loop, loop).certificate()
    with pytest.raises(ShapeError, match="space"):
        intersections(example("twisted_cubic"), example("helix_like")).certificate()
    with pytest.raises(ShapeError, match="itself"):
        self_intersections(loop).certificate()
    mixed = type(loop)(2, [0, 0, 0, 1, 1, 1], [(0, 0), (1, 1), (2, 0)], [2, -1, 2])
    with pytest.raises(ShapeError, match="different signs"):
        intersections(mixed, loop).certificate()
