"""Ordinary numbers of every size, for curves of tests: one seeded generator for each."""

import pytest
from gmpy2 import mpq

from exactspline.numbers.exact import from_float
from tests.support.sampled import FULL

DIALS = {
    "small integers": lambda random: mpq(random.randint(-4, 4)),
    "thirds": lambda random: mpq(random.randint(-9, 9), 3),
    "ten decimals": lambda random: mpq(random.randrange(-(10**10), 10**10), 10**10),
    "doubles": lambda random: from_float(random.uniform(-1, 1)),
    "doubles · 1e300": lambda random: from_float(random.uniform(-1, 1) * 1e300),
    "doubles · 1e-300": lambda random: from_float(random.uniform(-1, 1) * 1e-300),
}
#: What every run takes; the campaigns, and ``EXACTSPLINE_FULL=1``, take all.
ALWAYS = DIALS if FULL else {name: DIALS[name] for name in ("small integers", "doubles", "doubles · 1e-300")}
over_dials = pytest.mark.parametrize("number", ALWAYS.values(), ids=ALWAYS)


def factors(number, random, count):
    """Numbers of a dial, none of them 0."""
    return [number(random) or mpq(1) for _ in range(count)]
