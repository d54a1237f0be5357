"""Certificates of minimality: the proved degree is attained, the checker is independent, and a wrong certificate is
caught.
"""

import copy
import json
import random
from itertools import product

import pytest

from exactspline import BSpline, Nurbs
from exactspline.certificates import check_certificate
from exactspline.certificates.degrees import is_irreducible
from exactspline.errors import ReductionError, ShapeError
from exactspline.geometry.constructions import all_constructions
from exactspline.interchange.examples import example
from exactspline.verification.minimality import attained, bezout_combination, certificate, witness
from tests.support.sampled import sample


@pytest.mark.parametrize(
    ("name", "d", "polynomial"), sample([*product(all_constructions(), range(2, 7), (False, True))], 60), ids=str
)
def test_the_witness_attains_the_proved_degree(name, d, polynomial):
    found = attained(name, d, polynomial=polynomial)
    assert found.agrees
    if found.attained is None:
        assert d == 2  # planar: no torsion, no osculating spheres
    else:
        assert check_certificate(json.loads(json.dumps(found.certificate))) == {"degree": found.proved}


@pytest.mark.parametrize(
    "name", ["ellipse_skew", "rational_cubic_spline", "six_segment_cubic", "straight_between_arcs"]
)
def test_certificates_on_curves_of_several_segments(name):
    for construction in ("evolute", "zero_curvature", "critical_curvature"):
        data = certificate(construction, example(name))
        assert check_certificate(data) == {"degree": max(segment["degree"] for segment in data["segments"])}


def test_what_vanishes_has_no_certificate():
    with pytest.raises(ShapeError, match="vanishes"):
        certificate("critical_curvature", example("circle"))
    with pytest.raises(ShapeError, match="straight"):
        certificate("evolute", example("straight_line"))


def spoilt(change):
    data = copy.deepcopy(certificate("critical_curvature", example("ellipse_skew")))
    change(data["segments"][0])
    return data


def multiply(segment):
    """The form times 2t − 1, whose factor nobody told."""
    old = [int(x) for x in segment["forms"][0]]
    new = [str((old[i - 1] if i else 0) - (old[i] if i < len(old) else 0)) for i in range(len(old) + 1)]
    segment["forms"], segment["degree"] = [new], segment["degree"] + 1


SPOILT = {
    "another cofactor": lambda s: s["cofactors"].reverse(),
    "a composite modulus": lambda s: s.update(prime=s["prime"] - 1),
    "a wrong degree": lambda s: s.update(degree=3),
    "a form of another curve": lambda s: s["forms"][0].reverse(),
    "a factor in common with w": lambda s: s.update(forms=[s["weight"]], degree=len(s["weight"]) - 1),
    "a factor more": multiply,
    "not irreducible": lambda s: s.update({"irreducible modulo": 4}),
    "an underscore": lambda s: s["forms"][0].__setitem__(0, "1_0"),
    "a blank": lambda s: s["forms"][0].__setitem__(0, " " + s["forms"][0][0]),
    "a plus": lambda s: s["forms"][0].__setitem__(0, "+1"),
    "other digits": lambda s: s["forms"][0].__setitem__(0, "\u0663"),
    "no text": lambda s: s.update(forms=[[int(x) for x in form] for form in s["forms"]]),
    "a prime in floating point": lambda s: s.update(prime=float(s["prime"])),
    "a degree that is true": lambda s: s.update(degree=True),
    "no forms": lambda s: s.pop("forms"),
}


@pytest.mark.parametrize("what", SPOILT)
def test_a_wrong_certificate_is_caught(what):
    with pytest.raises(ValueError, match=r"\w"):
        check_certificate(spoilt(SPOILT[what]))


def test_whitespace_and_underscores_do_not_change_a_number():
    """Before: accepted, since ``int`` reads them; a field missing was a KeyError."""

    def blank(segment):
        segment["forms"] = [[f" {x}" for x in form] for form in segment["forms"]]

    def arabic(segment):
        segment["forms"] = [[x.translate({48 + k: 0x660 + k for k in range(10)}) for x in f] for f in segment["forms"]]

    for change, flaw in ((blank, "not an integer"), (arabic, "not an integer"), (lambda s: s.pop("prime"), "not a c")):
        with pytest.raises(ValueError, match=flaw):
            check_certificate(spoilt(change))


def test_integers_of_any_length_are_read():
    """Before: "Exceeds the limit (4300 digits)", a refusal of our own certificates."""
    from exactspline.certificates.numbers import integer

    assert integer("-1" + "0" * 9000) == -(10**9000)


@pytest.mark.parametrize("scale", [1, 10**400], ids=["as it is", "huge"])
def test_a_degree_too_high_is_caught(scale):
    """(u + v) times a form of degree 4 is a form of degree 5 of the same function, also beyond the range of doubles."""

    def raised(segment):
        old = [int(x) * scale for x in segment["forms"][0]]
        segment["forms"] = [
            [str((old[i - 1] if i else 0) + (old[i] if i < len(old) else 0)) for i in range(len(old) + 1)]
        ]
        segment["degree"] += 1
        from flint import fmpz_poly

        forms = [fmpz_poly([int(x) for x in f]) for f in (segment["forms"][0], segment["weight"])]
        segment["prime"], segment["cofactors"] = bezout_combination(forms, [f.degree() for f in forms])
        segment["irreducible modulo"] = None

    with pytest.raises(ValueError, match="lower"):
        check_certificate(spoilt(raised))


def test_a_common_factor_has_no_certificate():
    f, g = BSpline.bezier([1, 2, 5]).polynomials[0], BSpline.bezier([3, -1]).polynomials[0]
    with pytest.raises(ReductionError, match="common factor"):
        bezout_combination([f * g, g * g], [3, 2])


def test_rabin_test_against_flint():
    from flint import nmod_poly

    numbers = random.Random(5)
    for p in (101, 103):
        for _ in range(40):
            form = [numbers.randint(0, p - 1) for _ in range(numbers.randint(2, 7))] + [1]
            factors = nmod_poly(form, p).factor()[1]
            assert is_irreducible(form, p) == ([e for _, e in factors] == [1])


def test_witnesses_are_the_same_every_time():
    assert isinstance(witness(2, 3), Nurbs)
    assert witness(3, 4).control_points == witness(3, 4).control_points
    assert witness(2, 3, polynomial=True).polynomial
