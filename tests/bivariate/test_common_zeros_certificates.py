"""Certificates of common zeros of functions: accepted by the standard-library checker; false ones are refused with
their flaw.
"""

import json
from fractions import Fraction
from random import Random

import pytest
from gmpy2 import mpq

from exactspline import check_certificate, common_zeros
from exactspline.certificates import certificate
from exactspline.errors import ReachError
from tests.campaigns.certificates import of_common_zeros, of_multiple_zeros
from tests.support.squares import function


def certificate_of(*functions):
    found = common_zeros(*functions)
    return found, json.loads(json.dumps(found.certificate()))


@pytest.mark.parametrize("seed", range(40))
def test_the_checker_counts_the_same_zeros(seed):
    functions, certificate = of_common_zeros(Random(seed))
    found = common_zeros(*functions)
    count = sum(len(zero.patches) for zero in found)
    assert check_certificate(certificate)["zeros"] == count


@pytest.mark.parametrize("seed", range(20))
def test_the_checker_counts_the_same_multiplicities(seed):
    """Curves that touch, nodes and cusps, at rational and irrational points; before, they had no certificate."""
    functions, certificate = of_multiple_zeros(Random(seed))
    found = common_zeros(*functions)
    expected = {"zeros": len(found)}
    if len(functions) == 2:
        expected["multiplicity"] = sum(zero.multiplicity for zero in found)
    assert check_certificate(certificate) == expected
    scaled = [f * mpq(float(mpq(seed + 3, 7))) for f in functions]  # numbers of doubles
    assert check_certificate(common_zeros(*scaled).certificate()) == expected


@pytest.mark.parametrize(
    ("functions", "zeros", "by"),
    [
        ((lambda s, t: s * s + t * t - 1, lambda s, t: s - t, lambda s, t: (s - t) * (3 * s - t)), 1, "eliminated"),
        ((lambda s, t: s - t, lambda s, t: 2 * s - 1, lambda s, t: 2 * t - 1), 1, "point"),
        ((lambda s, t: t, lambda s, t: t * s, lambda s, t: 2 * s * s - 1 + t), 1, "edge"),
        ((lambda s, t: s * s + t * t - 1, lambda s, t: s - t, lambda s, t: 3 * s - 2), 0, None),
    ],
)
def test_certificates_of_three_functions(functions, zeros, by):
    _, certificate = certificate_of(*map(function, functions))
    assert check_certificate(certificate) == {"zeros": zeros}
    assert [zero["by"] for zero in certificate["patches"][0]["zeros"]] == [by] * zeros


def test_a_certificate_has_a_thousand_bytes():
    """A random pair of cubics: the differences of their coordinates."""
    circle, line = function(lambda s, t: s * s + t * t - 1), function(lambda s, t: s - t)
    _, certificate = certificate_of(circle, line)
    assert check_certificate(certificate) == {"zeros": 1, "multiplicity": 1}
    assert len(json.dumps(certificate)) < 1000


def of_all_kinds():
    """Zeros at (1, 1/3), proved by a point, at (√½, 0), by an edge, at (√½, √⅓), by opposite signs, and a double one at
    (1, 0), by elimination.
    """
    f = function(lambda s, t: (2 * s * s - 1) * (s - 1) * (s + 3 * t - 1))
    g = function(lambda s, t: t * (3 * t * t - 1) * (s + 3 * t - 2))
    return common_zeros(f, g)


def test_zeros_inside_on_edges_and_at_rational_points():
    found = of_all_kinds()
    certificate = found.certificate()
    assert check_certificate(certificate) == {"zeros": 6, "multiplicity": 7}
    proofs = sorted(zero["by"] for zero in certificate["patches"][0]["zeros"])
    assert proofs == ["crossed", "crossed", "edge", "edge", "eliminated", "point"]


def forged(change):
    certificate = json.loads(json.dumps(of_all_kinds().certificate()))
    zeros = {zero["by"]: zero for zero in certificate["patches"][0]["zeros"]}
    change(certificate["patches"][0], zeros)
    return certificate


def exchanged(zero):
    zero["combinations"].reverse()


@pytest.mark.parametrize(
    ("change", "flaw"),
    [
        (lambda patch, zeros: patch["functions"].pop(), "fewer functions than two"),
        (lambda patch, zeros: patch["functions"][0].pop(), "different degrees"),
        (lambda patch, zeros: patch["functions"][1][0].pop(), "different degrees"),
        (lambda patch, zeros: patch.update(functions=[[], []], zeros=[]), "different degrees"),
        (lambda patch, zeros: patch.update(functions=[[[]], [[]]], zeros=[]), "different degrees"),
        (lambda patch, zeros: patch["boxes"].pop(), "boxes that are missing"),
        (lambda patch, zeros: patch["boxes"].append(["1", "0"]), "more boxes"),
        (lambda patch, zeros: patch["boxes"].__setitem__(0, ["1", "0"]), "does not have one sign"),
        (lambda patch, zeros: patch["boxes"].__setitem__(0, 0), "not inside the region"),
        (lambda patch, zeros: patch["boxes"].__setitem__(0, 6), "does not exist"),
        (lambda patch, zeros: patch["boxes"].__setitem__(0, "12"), "neither a cut"),
        (lambda patch, zeros: patch["zeros"].append(patch["zeros"][0]), "regions of two zeros that meet"),
        (lambda patch, zeros: zeros["crossed"].update(region=[["0", "1"], ["0", "1"]]), "may be singular"),
        (lambda patch, zeros: zeros["crossed"].update(region=[["0", "2"], ["0", "1"]]), "not in the square"),
        (lambda patch, zeros: zeros["crossed"].update(region=[["0", "1"], ["-1/2", "1"]]), "not in the square"),
        (lambda patch, zeros: zeros["crossed"].update(region=[["-1/2", "1"], ["0", "1"]]), "not in the square"),
        (lambda patch, zeros: zeros["crossed"].update(region=[["0", "1"], ["1/2", "1/2"]]), "not in the square"),
        (lambda patch, zeros: zeros["crossed"].update(combinations=[["1", "0"]] * 2), "may be singular"),
        (lambda patch, zeros: zeros["crossed"].update(by="nothing"), "unknown by"),
        (lambda patch, zeros: exchanged(zeros["crossed"]), "without opposite signs"),
        (lambda patch, zeros: zeros["edge"].update(by="crossed"), "without opposite signs"),
        (lambda patch, zeros: zeros["edge"].update(edge=[0, 0]), "not in the region"),
        (lambda patch, zeros: zeros["edge"].update(edge=[2, 0]), "not in the region"),
        (lambda patch, zeros: zeros["edge"].update(edge=[0, 2]), "not in the region"),
        (lambda patch, zeros: zeros["point"].update(point=["1", "1/2"]), "outside its region"),
        (lambda patch, zeros: zeros["point"].update(point=["1", "334/1000"]), "is not zero"),
        (lambda patch, zeros: zeros["point"].update(combinations=[["1", "0"]]), "a list of 1, where 2"),
        (lambda patch, zeros: zeros["eliminated"].update(slope="0"), "slope that is not positive"),
        (lambda patch, zeros: zeros["eliminated"].update(minimal=["2"]), "constant"),
        (lambda patch, zeros: zeros["eliminated"].update(below="0"), "not reduced"),
        (lambda patch, zeros: zeros["eliminated"].update(pair=[["0", "0"], ["0", "1"]]), "a pair without s"),
        (lambda patch, zeros: zeros["eliminated"].update(pair=[["1"], ["0", "1"]]), "another number of functions"),
        (lambda patch, zeros: zeros["eliminated"].update(pair=[["1", "0"], ["1", "0"]]), "resultant that vanishes"),
        (lambda patch, zeros: zeros["eliminated"].update(at=["0", "5"]), "a root outside the box"),
        (lambda patch, zeros: zeros["eliminated"].update(minimal=["-1", "2"]), "a place without a root"),
        (lambda patch, zeros: zeros["eliminated"].update(region=[["0", "1"], ["0", "1"]]), "another root"),
        (lambda patch, zeros: zeros["eliminated"].update(above=["1/2"]), "not an integer"),
        (lambda patch, zeros: zeros["eliminated"].update(above=["2"]), "a function that is not zero"),
        (lambda patch, zeros: zeros["eliminated"].update(power=0), "a power that is not positive"),
        (lambda patch, zeros: zeros["eliminated"].update(power=2), "a power that does not divide"),
    ],
)
def test_a_false_certificate_is_refused_with_its_flaw(change, flaw):
    with pytest.raises(ValueError, match=flaw):
        check_certificate(forged(change))


def of_lines(regions, boxes, sign=1):
    """A certificate about 2s − 1 and 2t − 1, with each region for their only zero; without regions about s and t."""
    at = -1 if regions else 0
    functions = [[[at, at], [sign, sign]], [[at, sign], [at, sign]]]
    proof = {"combinations": [["1", "0"], ["0", "1"]], "by": "point", "point": ["1/2", "1/2"]}
    patch = {
        "functions": [[[str(x) for x in row] for row in net] for net in functions],
        "zeros": [{"region": region, **proof} for region in regions],
        "boxes": boxes,
    }
    return certificate("common zeros", {"knots": [["0", "1"]] * 2, "patches": [{"patch": [0, 0], **patch}]})


WHOLE, LOW, HIGH = [["0", "1"], ["0", "1"]], [["0", "1/2"], ["0", "1"]], [["1/2", "1"], ["0", "1"]]


@pytest.mark.parametrize(
    ("regions", "boxes"), [((LOW, HIGH), ["first", 0, 1]), ((HIGH, LOW), ["first", 1, 0]), ((WHOLE, LOW), [0])]
)
def test_one_zero_is_not_counted_in_two_regions(regions, boxes):
    """Mutants passed: two zeros, where regions touch in the only one, or one lies in the other."""
    assert check_certificate(of_lines((WHOLE,), [0])) == {"zeros": 1, "multiplicity": 1}
    with pytest.raises(ValueError, match="regions of two zeros that meet"):
        check_certificate(of_lines(regions, boxes))


@pytest.mark.parametrize("sign", [1, -1])
def test_a_function_that_vanishes_at_a_corner_has_not_one_sign(sign):
    """A mutant passed: that s and t have no zero in common, as no coefficient of −s is positive."""
    with pytest.raises(ValueError, match="does not have one sign"):
        check_certificate(of_lines((), [["1", "0"]], sign))


def test_a_region_beside_an_edge_does_not_prove_a_zero_on_it():
    """The common divisor on the edge has its zero elsewhere."""

    def moved(patch, zeros):
        region = next(zero["region"] for zero in patch["zeros"] if zero["by"] == "edge")
        high = Fraction(region[0][1])
        region[0] = [str(high), str(high + Fraction(1, 64))]

    with pytest.raises(ValueError, match="an edge without a zero"):
        check_certificate(forged(moved))


def test_two_zeros_over_one_root_are_not_counted_as_one():
    """It was accepted that these have one zero: (s + t − 1)(s + 5) vanishes over the root 1 of s + t, and its degree in
    s was taken for a bound on that of the common divisor, which is (4s − 1)(4s − 3).
    """
    found, certificate = certificate_of(
        function(lambda s, t: (s + t - 1) * (s + 5)), function(lambda s, t: (4 * s - 1) * (4 * s - 3))
    )
    assert check_certificate(certificate) == {"zeros": len(found), "multiplicity": 2} == {"zeros": 2, "multiplicity": 2}
    one = {"region": WHOLE, "by": "eliminated", "slope": "1", "minimal": ["-1", "1"], "above": ["1"], "below": "4"}
    one |= {"pair": [["1", "0"], ["0", "1"]], "power": 1, "at": ["1", "1"]}
    certificate["patches"][0].update(zeros=[one], boxes=[0])
    with pytest.raises(ValueError, match="another zero over the root"):
        check_certificate(certificate)


def test_a_function_of_the_projection_alone():
    """Our own certificate was refused where a function depends on s + t only: "a pair without s"."""
    f, g = function(lambda s, t: (4 * s + 4 * t - 3) * (4 * s + 4 * t - 7)), function(lambda s, t: (s - t) ** 2)
    _, certificate = certificate_of(f, g)
    assert check_certificate(certificate) == {"zeros": 2, "multiplicity": 4}


def test_a_function_that_vanishes_over_the_root():
    """Our own certificate was refused: "a power that does not divide" it, as its degree in s is lower."""
    f, g = function(lambda s, t: (s + t - 1) * (s + 5)), function(lambda s, t: (2 * s - 1) ** 3)
    _, certificate = certificate_of(f, g)
    assert check_certificate(certificate) == {"zeros": 1, "multiplicity": 3}


def test_what_has_no_certificate_says_so():
    line, parabola = function(lambda s, t: t), function(lambda s, t: t - (2 * s - 1) ** 2)
    with pytest.raises(ReachError, match="along a curve"):
        common_zeros(line, line * parabola).certificate()
    point = function(lambda s, t: (2 * s - 1) ** 2 + (2 * t - 1) ** 2)
    with pytest.raises(ReachError, match="a common factor"):  # did not end
        common_zeros(point, point * (line + 1)).certificate()
    high = function(lambda s, t: t - (2 * s - 1) ** 14), function(lambda s, t: t - t**13)
    with pytest.raises(ReachError, match="of these degrees"):
        common_zeros(*high).certificate()
