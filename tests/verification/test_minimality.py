"""Certificates of minimality: the proved degree is attained, the checker is independent, and a wrong certificate is
caught.
"""

import copy
import json
import random
from itertools import product

import pytest
from flint import fmpz, fmpz_poly, nmod_poly
from gmpy2 import mpq

from exactspline import BSpline, Nurbs, check_certificate, example
from exactspline.certificates.degrees import is_irreducible, is_prime
from exactspline.certificates.numbers import integer
from exactspline.errors import ReductionError, ShapeError
from exactspline.geometry.derived.constructions import all_constructions
from exactspline.verification.generic_proof import attained, bezout_combination, certificate, witness
from tests.support.sampled import sample

#: What every answer of the checker says of a certificate that this library writes.
PROVED = {"construction checked": False, "curve checked": False, "intervals checked": False}


def test_what_is_not_checked_is_named():
    """Before: the construction, the curve and the intervals could be exchanged for others, and the answer was the same,
    {'degree': 12}, as if they had been checked.
    """
    data = certificate("evolute", example("rational_cubic_s"))
    assert set(data) == {"format", "what", "kind", "segments", "not checked"}
    assert data["not checked"] == {"construction": "evolute", "curve": "rational_cubic_s", "intervals": [["0", "1"]]}
    assert set(data["segments"][0]) == {"degree", "prime", "forms", "cofactors"}
    assert check_certificate(data) == PROVED | {"degree": 12}
    with pytest.raises(ValueError, match="not checked is missing"):
        check_certificate({name: value for name, value in data.items() if name != "not checked"})


@pytest.mark.parametrize(
    ("name", "d", "polynomial"), sample([*product(all_constructions(), range(2, 7), (False, True))], 60), ids=str
)
def test_the_witness_attains_the_proved_degree(name, d, polynomial):
    found = attained(name, d, polynomial=polynomial)
    assert found.agrees
    if found.attained is None:
        assert d == 2  # planar: no torsion, no osculating spheres
    else:
        checked = check_certificate(json.loads(json.dumps(found.certificate)))
        assert checked["degree"] == found.proved
        assert ("irreducible" in checked) == (found.certificate["kind"] == "zero set")


@pytest.mark.parametrize(
    "name", ["ellipse_skew", "rational_cubic_spline", "six_segment_cubic", "straight_between_arcs"]
)
def test_certificates_on_curves_of_several_segments(name):
    for construction in ("evolute", "zero_curvature", "critical_curvature"):
        data = certificate(construction, example(name))
        assert check_certificate(data)["degree"] == max(segment["degree"] for segment in data["segments"])


def test_a_multiple_factor_is_not_part_of_a_zero_set():
    """Before, it was certified, and the checker accepted, that the zero set {1/2} of (1 − 2t)² needs degree 2; written
    by hand also (z − 1)²(z − 2), z² and 1 + z with a double zero at the right end.
    """
    quartic = Nurbs(4, [0] * 5 + [1] * 5, [(mpq(k, 4), mpq((-1) ** k, 16)) for k in range(5)])  # y = (t − 1/2)⁴
    data = certificate("zero_curvature", quartic)
    assert check_certificate(data) == PROVED | {"degree": 1, "irreducible": True}
    for form in ([-2, 5, -4, 1], [0, 0, 1], [1, 1, 0, 0]):
        with pytest.raises(ValueError, match="not square-free"):
            check_certificate(by_hand(data, form))
    # (1 + z²)(z − 2): of its three factors two have no zero, and that it is irreducible is not said
    assert check_certificate(by_hand(data, [-2, 1, -2, 1])) == PROVED | {"degree": 3, "irreducible": False}
    # zeros at the right end are zeros like others: 2 (z − 1) with t = 1, where z is infinite
    assert check_certificate(by_hand(data, [-2, 2, 0])) == PROVED | {"degree": 2, "irreducible": False}


def by_hand(data, form):
    """A certificate of the zero set of a form."""
    forms, degree = [list(map(str, form))], len(form) - 1
    own = {"forms": forms, "degree": degree, "cofactors": [[], ["1"]], "irreducible modulo": None}
    return data | {"segments": [data["segments"][0] | own]}


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

    for change, flaw in ((blank, "not an integer"), (arabic, "not an integer"), (lambda s: s.pop("prime"), "prime is")):
        with pytest.raises(ValueError, match=flaw):
            check_certificate(spoilt(change))


def test_integers_of_any_length_are_read():
    """Before: "Exceeds the limit (4300 digits)", a refusal of our own certificates."""
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
    f, g = BSpline.bezier([1, 2, 5]).numerators[0], BSpline.bezier([3, -1]).numerators[0]
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


@pytest.mark.parametrize("form", [["1"], ["2", "0", "3", "0", "1"]], ids=["a constant", "a product"])
def test_what_is_not_irreducible_is_refused(form):
    """Accepted before: a certificate that a constant is irreducible modulo 101."""
    data = certificate("critical_curvature", example("ellipse_skew"))
    other = {"forms": [form], "weight": ["1"], "degree": len(form) - 1, "cofactors": [[], ["1"]]}
    first = data["segments"][0]
    data["segments"] = [first | other | {"irreducible modulo": None}, first]
    expected = PROVED | {"degree": max(len(form) - 1, first["degree"]), "irreducible": len(form) == 1}
    assert check_certificate(data) == expected
    with pytest.raises(ValueError, match="unknown kind"):
        check_certificate(data | {"kind": "something else"})
    data["segments"][0]["irreducible modulo"] = 101
    with pytest.raises(ValueError, match="not irreducible"):
        check_certificate(data)


def test_a_prime_beyond_the_bound_of_the_bases_is_none():
    """The bases of the test of Miller and Rabin are proved to suffice below 3·10²⁴."""
    bound = 3 * 10**24
    below, beyond = (next(n for n in range(bound + s, bound + 1000 * s, 2 * s) if fmpz(n).is_prime()) for s in (-1, 1))
    assert is_prime(below)
    assert not is_prime(beyond)


def test_witnesses_are_the_same_every_time():
    assert isinstance(witness(2, 3), Nurbs)
    assert witness(3, 4).control_points == witness(3, 4).control_points
    assert witness(2, 3, polynomial=True).polynomial


# ---- combinations to 1, primes, small certificates written by hand


@pytest.mark.parametrize(
    "forms",
    [[[5]], [[7, 3], [2, 1]], [[1, 0, 1], [0, 0, 3]], [[-6, 1, 1], [4, 4, 1], [9]], [[2, 0, 2], [3, 3], [0, 5, 0, 1]]],
)
def test_polynomials_without_common_factor_are_combined_to_one(forms):
    polynomials = [fmpz_poly(c) for c in forms]
    p, cofactors = bezout_combination(polynomials, [len(c) - 1 for c in forms])
    total = nmod_poly([], p)
    for c, a in zip(polynomials, cofactors, strict=True):
        total = total + nmod_poly([int(x) for x in a], p) * nmod_poly(c.coeffs(), p)
    assert total == nmod_poly([1], p)
    assert any(int(c[len(f) - 1]) % p for c, f in zip(polynomials, forms, strict=True))


def test_primes_are_told_from_all_others():
    primes = [n for n in range(2, 2000) if all(n % q for q in range(2, int(n**0.5) + 1))]
    assert [n for n in range(-5, 2000) if is_prime(n)] == primes
    for n in (2**61 - 1, 10**18 + 9, 2**31 - 1, 1000003, 1000033):
        assert is_prime(n)
    for n in (561, 1105, 1729, 3215031751, 2**61 + 1, 1000003 * 1000033, 43 * 43, 318665857834031151167461):
        assert not is_prime(n)
    assert not is_prime(2**89 - 1)  # a prime, but beyond what the bases decide


def certificate_of(forms, cofactors):
    """A certificate of a quotient of degree 1, modulo 5."""
    segment = {"degree": 1, "prime": 5, "forms": forms, "cofactors": cofactors}
    head = {"format": "exactspline certificate 2", "what": "degree", "kind": "quotient", "not checked": {}}
    return head | {"segments": [segment]}


def test_a_component_that_vanishes_does_not_lower_the_degree():
    """2 (1 + u) − (1 + 2u) = 1."""
    forms = [["1", "1"], ["0", "0"], ["1", "2"]]
    assert check_certificate(certificate_of(forms, [["2"], [], ["4"]])) == {"degree": 1}


@pytest.mark.parametrize("forms", [[["1", "1"], ["1"]], [["0", "0"], ["0", "0"]]])
def test_every_form_has_the_degree_claimed(forms):
    """A mutant passed: degree 1 proved of a form of degree 1 and a number."""
    with pytest.raises(ValueError, match="a form of another degree"):
        check_certificate(certificate_of(forms, [[], ["1"]]))


@pytest.mark.parametrize("length", [599, 600, 601, 602, 603, 1201, 1207])
def test_integers_of_many_digits_are_read_in_parts(length):
    """A mutant read digits twice where their number is odd."""
    digits = "".join(str(i * i % 9 + 1) for i in range(length))
    assert integer(digits) == sum(int(x) * 10**i for i, x in enumerate(reversed(digits)))


def zero_set(form, weight, cofactors):
    """A certificate of a zero set of degree 1, modulo 5."""
    segment = {"degree": 1, "prime": 5, "forms": [form], "weight": weight, "cofactors": cofactors}
    return certificate_of([], []) | {"kind": "zero set", "segments": [segment | {"irreducible modulo": None}]}


def test_a_form_of_lower_degree_in_the_parameter_is_refused():
    """A mutant passed: (1 − t) + t proved to be of degree 1; and it refused (1 − t) + 2t."""
    assert check_certificate(zero_set(["1", "2"], ["1", "1"], [["4"], ["2"]]))["degree"] == 1
    with pytest.raises(ValueError, match="the degree in the parameter is lower"):
        check_certificate(zero_set(["1", "1"], ["1", "2"], [["2"], ["4"]]))


def test_a_prime_that_divides_the_highest_coefficient_shows_no_irreducibility():
    """A mutant passed: 1 + 10u irreducible modulo 5, where it is 1."""
    certificate = zero_set(["1", "10"], ["1", "1"], [["1"], []])
    assert check_certificate(certificate)["degree"] == 1
    certificate["segments"][0]["irreducible modulo"] = 5
    with pytest.raises(ValueError, match="not irreducible"):
        check_certificate(certificate)
