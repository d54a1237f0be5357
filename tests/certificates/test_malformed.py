"""Malformed certificates of every kind: the error is the checker's own, and names what is wrong and where."""

import copy
import json
import re
from functools import cache
from random import Random

import pytest

from exactspline import (
    BSpline,
    TensorSpline,
    check_certificate,
    common_zeros,
    example,
    intersections,
    zero_curve,
    zeros,
)
from exactspline.certificates import CertificateError
from exactspline.verification.generic_proof import certificate as of_degree
from tests.campaigns.certificates import of_multiple_zeros, spots
from tests.support.bisector_oracle import bezier
from tests.support.squares import function

KNOTS = [0, 0, 1, 2, 2]
STEPPED = TensorSpline((1, 1), KNOTS, KNOTS, [[-2, -1, 0], [-1, 0, 1], [0, 1, 3]])
KINDS = {
    "zeros": lambda: zeros(BSpline(1, [0, 0, 1, 1, 2, 2], [0, 1, -1, 1])),
    "multiple zeros": lambda: zeros(BSpline.bezier([1, -1, 1])),
    "intersections": lambda: intersections(bezier((-2, "1/3"), (2, "1/2")), bezier((-1, 1), (0, -1), (1, 1))),
    "apart": lambda: intersections(bezier((0, 0), (1, 0)), bezier((0, 1), (1, 1))),
    "common zeros": lambda: common_zeros(STEPPED, function(lambda s, t: s - t, 0, 2)),
    "multiple common zeros": lambda: common_zeros(*of_multiple_zeros(Random(1))[0]),
    "curves": lambda: zero_curve(STEPPED),
    "a cusp": lambda: zero_curve(function(lambda s, t: (s - t) * ((2 * s - 1) ** 3 - (2 * t - 1) ** 2) * s)),
    "a node": lambda: zero_curve(function(lambda s, t: (2 * s - 1) ** 2 - 2 * (2 * t - 1) ** 2 + (2 * s - 1) ** 3)),
}
DEGREES = {"a degree": "evolute", "the degree of a zero set": "critical_curvature"}
#: What no certificate has anywhere, and what may be in the place of something else.
FOREIGN = 1.5
OTHERS = None, True, -1, 10**30, "x", "1/0", "", "1", [], {}, [[]], [1, 2], ["1"], {"a": 1}, [None], [FOREIGN]
#: Whose values the checker does not read, and says so.
UNREAD = {"construction", "curve", "intervals"}


@cache
def text_of(name):
    data = of_degree(DEGREES[name], example("ellipse_skew")) if name in DEGREES else KINDS[name]().certificate()
    return json.dumps(data)


def changed(name, path, value):
    data = json.loads(text_of(name))
    holder = data
    for key in path[:-1]:
        holder = holder[key]
    if value is ...:
        del holder[path[-1]]
    else:
        holder[path[-1]] = value
    return data


@pytest.mark.parametrize("name", [*KINDS, *DEGREES])
def test_what_is_not_of_the_form_is_named_with_its_place(name):
    """Before: “not a certificate: TypeError: 'float' object is not iterable”, “not enough values to unpack”."""
    data = json.loads(text_of(name))
    check_certificate(data)
    every = [path for path in spots(data)[1:] if not UNREAD & set(path)]
    for path in Random(name).sample(every, min(len(every), 60)):
        with pytest.raises(CertificateError) as caught:
            check_certificate(changed(name, path, FOREIGN))
        assert caught.value.where == path, (path, caught.value)
        if isinstance(path[-1], str) and path[-1] != "apart":  # without it another proof is expected
            with pytest.raises(CertificateError) as caught:
                check_certificate(changed(name, path, ...))
            assert (caught.value.where, caught.value.flaw) == (path[:-1], f"{path[-1]} is missing")


@pytest.mark.parametrize("name", [*KINDS, *DEGREES])
def test_nothing_but_its_own_error_is_raised(name):
    """Things of another form in the place of any part, of the form of another part, too."""
    chance, flaws = Random(name), set()
    every = spots(json.loads(text_of(name)))[1:]
    for _ in range(150):
        forged = changed(name, chance.choice(every), copy.deepcopy(chance.choice(OTHERS)))
        flaws |= flaws_of(forged)
    assert len(flaws) > 3
    assert not [flaw for flaw in flaws if not flaw or re.search("Error|unpack|zip|argument", flaw)]


def flaws_of(certificate):
    try:
        check_certificate(certificate)
    except CertificateError as error:
        return {error.flaw}
    return set()
