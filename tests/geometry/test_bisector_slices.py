"""All pairs with more than a point, slice by slice, by the oracle of `tests.campaigns.bisectors`: for a rational s one
greatest common divisor in t vanishes at every such t, and its irreducible factors tell exactly of which kind the pair
is.
"""

from random import Random

import pytest
from gmpy2 import mpq

from exactspline import BSpline, Nurbs
from exactspline.geometry.bisectors.two_curves import curve_bisector
from tests.campaigns.bisectors import differences
from tests.support.bisector_answers import of_family, of_random_pair, random_pair
from tests.support.bisector_oracle import FAMILIES, bezier, circle, curve_of, mapped
from tests.support.dials import over_dials
from tests.support.sampled import FULL

U = BSpline.identity(0, 1)


def assert_no_differences(found, first, second, seed):
    """The answer is complete, and the oracle says the same."""
    assert found.undecided == ()
    assert differences(found, first, second, Random(seed)) == []


def is_special(found):
    return bool(found.lines or found.planes or found.pairs)


@pytest.mark.parametrize("name", FAMILIES)
def test_slices_of_families(name):
    first, second = FAMILIES[name]
    assert_no_differences(of_family(name), first, second, 1)
    assert_no_differences(of_family(name, exchanged=True), second, first, 1)


def test_slices_of_random_curves():
    seeds = range(40 if FULL else 24)
    for seed in seeds:
        assert_no_differences(of_random_pair(seed), *random_pair(seed), seed)
    assert sum(is_special(of_random_pair(seed)) for seed in seeds) > len(seeds) / 2


# ---- more families: both parameters of higher degree, spheres, irrational cusps, every size


def number(random, size=3):
    return mpq(random.randint(-size, size), random.choice([1, 1, 2, 3]))


def polynomial(random, degree, number=number):
    return sum((U**k * number(random) for k in range(1, degree + 1)), U * 0 + number(random))


def composed(random, number=number):
    """One curve and its mirror image, or the same, through two different polynomials: f(s) = g(t)."""
    shapes = [[number(random) for _ in range(3)] for _ in range(3)]
    inner = random.sample([U * U, U * U + U, U * 2 - 1, U * U * 2 - U, U**2 - mpq(1, 3)], 2)
    first, second = (curve_of(*[(f * c[2] + c[1]) * f + c[0] for c in shapes]) for f in inner)
    return first, random.choice([second, mapped(second, lambda x, y, z: (x, y, 1 - z))])


def on_a_sphere(random, number=number):
    """All normal planes run through the centre."""

    def one():
        u, v = polynomial(random, 1, number), polynomial(random, 1, number)
        rows = [f.elevated_to(u * u).control_points for f in (u * 2, v * 2, u * u + v * v - 1, u * u + v * v + 1)]
        return Nurbs.from_homogeneous(2, [0, 0, 0, 1, 1, 1], list(zip(*rows, strict=True)))

    return one(), one()


def cusped(random, number=number):
    """γ̄′ has a factor with a root inside, rational or not."""
    factor = random.choice([U * 2 - 1, U * U * 2 - 1, U * U * 3 - 1, U * U * 5 - U * 5 + 1])
    found = []
    for _ in range(3):
        slope, values = factor * polynomial(random, 1, number), [number(random)]
        for x in slope.control_points:
            values.append(values[-1] + x / (slope.degree + 1))
        found.append(BSpline.bezier(values, 0, 1))
    return random.choice([circle(2, 1, 1), bezier((0, 0, 1), (1, 2, 0), (2, 1, 1))]), curve_of(*found)


FACTORIES = {"composed": composed, "on a sphere": on_a_sphere, "cusped": cusped}


@pytest.mark.parametrize("scale", [mpq(1), -(mpq(10) ** 80), mpq(10) ** -80], ids=["1", "-10^80", "10^-80"])
@pytest.mark.parametrize("name", FACTORIES)
def test_slices_of_more_families(name, scale):
    special = 0
    for seed in range(4):
        pair = [mapped(c, lambda *p: [scale * mpq(x) for x in p]) for c in FACTORIES[name](Random(seed))]
        found = curve_bisector(*pair)
        assert_no_differences(found, *pair, seed)
        special += is_special(found)
    assert special


@over_dials
@pytest.mark.parametrize("name", FACTORIES)
def test_slices_of_more_families_at_every_dial(name, number):
    """Before: small integers and their multiples alone; a line of a pair of doubles was a traceback."""
    special = seed = 0
    while seed < 2 or not special:
        pair = FACTORIES[name](Random(seed), number)
        found = curve_bisector(*pair)
        assert_no_differences(found, *pair, seed)
        special += is_special(found)
        seed += 1
        assert seed < 12
