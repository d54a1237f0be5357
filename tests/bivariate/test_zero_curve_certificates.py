"""Certificates of curves of zeros: the checker finds the topology that the library finds; false ones are refused with
their flaw.
"""

import json
from functools import cache
from random import Random

import pytest
from gmpy2 import mpq

from exactspline import TensorSpline, check_certificate, common_zeros, zero_curve
from exactspline.errors import ReachError
from tests.bivariate.test_zeros_in_two_parameters import DIALS, around
from tests.campaigns.certificates import campaign, of_zero_curves, topology_of
from tests.campaigns.certificates import counts_of as counted
from tests.support.squares import function


def proved(p):
    found = check_certificate(json.loads(json.dumps(zero_curve(p).certificate())))
    return {key: count for key, count in found.items() if count}


@pytest.mark.parametrize("dial", DIALS)
@pytest.mark.parametrize(
    ("p", "counts"),
    [
        (lambda x, y: x * x + y * y - 1, {"loops": 1}),
        (lambda x, y: x**2 * (x + 1) - y**2, {"crossed": 1}),  # a node
        (lambda x, y: x**3 - y**2, {"arcs": 1}),  # a cusp
        (lambda x, y: x**4 - y**2, {"crossed": 1}),  # a tacnode
        (lambda x, y: x**4 + y**2, {"points": 1}),
        (lambda x, y: x**2 * (x - 1) - y**2, {"arcs": 1, "points": 1}),
        (lambda x, y: (x * x + y * y) ** 2 - x * (x * x - 3 * y * y), {"crossed": 1}),  # three branches
        (lambda x, y: x * (x - 2 * y) ** 2, {"lines": 1, "arcs": 1}),
        (lambda x, y: x * x + y * y + 1, {}),
    ],
)
def test_the_topology_of_known_curves(p, counts, dial):
    """There was no certificate of a curve of zeros. The curves in small integers, and moved and scaled by doubles."""
    a, c = DIALS[dial](mpq(0)), DIALS[dial](mpq(1))
    if dial == "doubles":
        a, c = mpq(1 / 3 - 1 / 7), mpq(0.9876543210987654)
    assert proved(around(lambda x, y: p(c * x - a, c * y - a))) == counts


@pytest.mark.parametrize(
    ("p", "counts"),
    [
        (lambda s, t: s**3 - t**2, {"arcs": 1}),  # singular points at a corner and on the border
        (lambda s, t: s * s + t * t, {"points": 1}),
        (lambda s, t: (2 * s - 1) ** 3 - t * t, {"arcs": 1}),
        (lambda s, t: (2 * s * s - 1) ** 2 - t**3, {"crossed": 1}),
        (lambda s, t: (s - t) * (s - 1) + t**3, {"crossed": 1, "points": 1}),
        (lambda s, t: s + t, {"points": 1}),
        (lambda s, t: s * (1 - t) * (2 * s * s - 1), {"lines": 3}),
        (lambda s, t: (20 * s - 9) * (2 * s - 1) * (20 * s - 11) * (t + 1), {"lines": 3}),
        # two points with the same s + t, which need another projection
        (lambda s, t: ((4 * s - 1) ** 2 + (4 * t - 3) ** 2) * ((4 * s - 3) ** 2 + (4 * t - 1) ** 2), {"points": 2}),
    ],
)
def test_singular_points_on_the_border(p, counts):
    assert topology_of(zero_curve(function(p)).certificate()) == counted(
        dict.fromkeys(("lines", "loops", "arcs", "crossed", "points"), 0) | proved(function(p))
    )


@pytest.mark.parametrize(
    ("p", "counts"),
    [
        (lambda s, t: s * (s + t), {"lines": 1}),
        (lambda s, t: t * (s + t), {"lines": 1}),
        (lambda s, t: (2 * s - 1) * (s + t), {"lines": 1, "points": 1}),
        # points on a side at an irrational place
        (lambda s, t: (2 * t * t - 1) * (s + (2 * t * t - 1) ** 2), {"lines": 1}),
        (lambda s, t: (3 * t * t - 1) * (s + (2 * t * t - 1) ** 2), {"lines": 1, "points": 1}),
        # inside, with a definite Hessian and without
        (lambda s, t: (2 * s - 1) * ((2 * s - 1) ** 2 + (2 * t - 1) ** 2), {"lines": 1}),
        (lambda s, t: (2 * t * t - 1) * ((2 * s * s - 1) ** 2 + (2 * t * t - 1) ** 2), {"lines": 1}),
        (lambda s, t: (3 * s * s - 1) * ((2 * s * s - 1) ** 2 + (2 * t * t - 1) ** 2), {"lines": 1, "points": 1}),
        (lambda s, t: (2 * s - 1) * ((2 * s - 1) ** 4 + (2 * t - 1) ** 2), {"lines": 1}),
        (lambda s, t: (2 * t * t - 1) * ((2 * s * s - 1) ** 4 + (2 * t * t - 1) ** 2), {"lines": 1}),
        (lambda s, t: (5 * t * t - 2) * ((2 * s * s - 1) ** 4 + (2 * t * t - 1) ** 2), {"lines": 1, "points": 1}),
    ],
)
def test_a_point_on_a_line_is_not_a_single_point(p, counts):
    """Proved before: `points: 1` for each, where the first vanishes on a line alone."""
    assert proved(function(p)) == counts
    found = zero_curve(function(p))
    assert (len(found.lines), len(found.points)) == (counts["lines"], counts.get("points", 0))


def test_a_point_on_a_line_cannot_be_told_as_one_beside_it():
    """A region that the line meets does not show that the point is elsewhere."""

    def widened(patch):
        first(patch, "branches")["region"][1] = ["0", "1"]

    p = lambda s, t: (5 * t * t - 2) * ((2 * s * s - 1) ** 4 + (2 * t * t - 1) ** 2)  # noqa: E731
    with pytest.raises(ValueError, match="not in its box"):
        check_certificate(forged(widened, p))

    def near(patch):
        cell = first(patch, "branches")
        cell["region"][1] = cell["box"][1]

    with pytest.raises(ValueError, match="may be on a line"):
        check_certificate(forged(near, lambda s, t: (10 * t - 7) * ((2 * s * s - 1) ** 4 + (2 * t * t - 1) ** 2)))


OTHER = TensorSpline((1, 1), [0, 0, 2, 2], [0, 0, 2, 2], [[1, -2], [3, 1]])


@pytest.mark.parametrize("write", [zero_curve, lambda f: common_zeros(f, OTHER)])
@pytest.mark.parametrize(
    ("change", "flaw"),
    [
        (lambda data: data.update(patches=[]), "patches between the knots that are not given"),
        (lambda data: data.update(patches=[], knots=[[], []]), "fewer knots than two"),
        (lambda data: data.update(patches=[], knots=[["0"], ["0"]]), "fewer knots than two"),
        (lambda data: data["patches"].pop(), "patches between the knots that are not given"),
        (lambda data: data["patches"].append(data["patches"][0]), "patches between the knots that are not given"),
        (lambda data: data["patches"][0].update(patch=[1, 1]), "patches between the knots that are not given"),
        (lambda data: data["patches"][0].update(patch=[-1, 0]), "patches between the knots that are not given"),
        (lambda data: data["knots"][0].insert(1, "1/2"), "patches between the knots that are not given"),
        (lambda data: data["knots"][1].reverse(), "do not ascend"),
        (lambda data: data.update(format="exactspline certificate 1"), "have the format exactspline certificate 2"),
    ],
)
def test_a_certificate_says_of_what_it_is(change, flaw, write):
    """Accepted before: no patch at all, one left out, one written twice, none of them with knots."""
    knots = [0, 0, 1, 2, 2]
    f = TensorSpline((1, 1), knots, knots, [[-2, -1, 0], [-1, 0, 1], [0, 1, 3]])
    certificate = json.loads(json.dumps(write(f).certificate()))
    check_certificate(certificate)
    change(certificate)
    with pytest.raises(ValueError, match=flaw):
        check_certificate(certificate)


def test_patches_are_counted_one_by_one():
    knots = [0, 0, 1, 2, 2]
    assert proved(TensorSpline((1, 1), knots, knots, [[-2, -1, 0], [-1, 0, 1], [0, 1, 3]])) == {"arcs": 2, "points": 2}


@pytest.mark.parametrize("seed", range(24))
def test_the_checker_counts_what_the_library_finds(seed):
    certificate = of_zero_curves(Random(seed))[1]
    assert counted(check_certificate(certificate)) == topology_of(certificate)


def test_changed_certificates_are_refused_or_true():
    found = campaign("zero curves", 60, 7)
    assert found["accepted and false"] == [], found


def with_a_cusp(s, t):
    return ((2 * s - 1) ** 3 - (2 * t - 1) ** 2) * (s - t) * s


@cache
def text_of(p):
    return json.dumps(zero_curve(function(p)).certificate())


def forged(change, p=with_a_cusp):
    certificate = json.loads(text_of(p))
    change(certificate["patches"][0])
    return certificate


def first(patch, kind):
    return next(cell for cell in patch["cells"] if cell["kind"] == kind)


def away(patch):
    """The first box with one sign is said to have a monotone derivative, and so on."""
    patch["boxes"][patch["boxes"].index("first monotone")] = "sign"


@pytest.mark.parametrize(
    ("change", "flaw"),
    [
        (lambda patch: patch["function"].pop(), "do not multiply"),
        (lambda patch: patch["function"][0].pop(), "different lengths"),
        (lambda patch: patch["factors"].pop(), "do not multiply"),
        (lambda patch: patch["factors"][0].update(power=0), "whose power is not positive"),
        (lambda patch: patch["factors"][0].update(power=10**9), "whose power is too high"),  # multiplied without end
        (lambda patch: patch["boxes"].pop(), "boxes that are missing"),
        (lambda patch: patch["boxes"].append("sign"), "more boxes"),
        (away, "does not have one sign"),
        (lambda patch: patch["zeros"].pop(0), "not given"),
        (lambda patch: patch["zeros"][0][2]["places"].append(["0", "0"]), "another number of zeros"),
        (lambda patch: patch["cuts"][0].pop(), "miss the border"),
        (lambda patch: patch["cuts"][0].insert(1, "0"), "do not ascend"),
        (lambda patch: patch["cells"].append(patch["cells"][0]), "not a box"),
        (lambda patch: patch["cells"][0].update(kind="nothing"), "unknown kind"),
        (lambda patch: patch["cells"][0].update(box=[["0", "1"], ["0", "1"]]), "not that of its cell"),
        (lambda patch: first(patch, "branches").update(minimal=["-1", "3"]), "a place without a root"),
        (
            lambda patch: first(patch, "branches").update(region=[["15/16", "1"], ["1/2", "1/2"]]),
            "a place without a root",
        ),
        (lambda patch: first(patch, "branches").update(below="0"), "denominator that is not positive"),
        (lambda patch: first(patch, "branches").update(power=1), "another zero over the root"),
        (lambda patch: first(patch, "branches").update(power=5), "does not divide"),
        (lambda patch: first(patch, "branches").update(factor=[["1"]]), "not monic"),
    ],
)
def test_a_false_certificate_is_refused_with_its_flaw(change, flaw):
    with pytest.raises(ValueError, match=flaw):
        check_certificate(forged(change))


def test_a_node_is_not_a_point():
    def changed(patch):
        first(patch, "node").update(kind="point")

    with pytest.raises(ValueError, match="may not be definite"):
        check_certificate(forged(changed, lambda s, t: (2 * s - 1) ** 2 - 2 * (2 * t - 1) ** 2 + (2 * s - 1) ** 3))


@pytest.mark.parametrize("kind", ["point", "node"])
def test_a_singular_point_on_the_border_is_neither(kind):
    zero = {"slope": "1", "minimal": ["0", "1"], "above": [], "below": "1", "power": 1, "at": ["0", "0"]}
    zero["pair"] = [["1", "0", "0"], ["0", "1", "0"]]
    with pytest.raises(ValueError, match="a box on the border"):
        check_certificate(
            forged(lambda patch: patch["cells"][0].update(kind=kind, zero=zero), lambda s, t: s * s + t * t)
        )


def test_one_line_is_not_counted_twice_nor_as_an_arc():
    """It was accepted that (2s − 1)² vanishes on two lines, and that 2s − 1 does on an arc."""

    def twice(patch):
        (factor,) = patch["factors"]
        patch["factors"] = [dict(factor, power=1)] * 2

    def curved(patch):
        (line,) = patch["factors"]
        ends = [[1, end, {"isolation": line["isolation"], "places": [["1/4", "3/4"]]}] for end in "01"]
        none = {"isolation": {"factors": [], "points": [], "leaves": [["0", "1", 0]]}, "places": []}
        patch["factors"] = [{"net": [["-1", "-1"], ["1", "1"]], "power": 1}]
        patch.update(cuts=[["0", "1"]] * 2, boxes=["first monotone"], zeros=[*ends, *([0, end, none] for end in "01")])

    assert check_certificate(forged(lambda patch: None, lambda s, t: (2 * s - 1) ** 2))["lines"] == 1
    with pytest.raises(ValueError, match="a line of two factors"):
        check_certificate(forged(twice, lambda s, t: (2 * s - 1) ** 2))
    with pytest.raises(ValueError, match="a line among the curves"):
        check_certificate(forged(curved, lambda s, t: 2 * s - 1))


def test_what_has_no_certificate_says_so():
    knots = [0, 0, 1, 2, 2]
    with pytest.raises(ReachError, match="vanishes on a patch"):
        zero_curve(TensorSpline((1, 1), knots, knots, [[0, 0, 1], [0, 0, 1], [1, 1, 1]])).certificate()
