"""The parts of claims, each on small cases: what they assume, what they refuse, what is tried where."""

from dataclasses import replace

import pytest

from exactspline.verification.claims import claims_of, select


def claim(key):
    (found,) = select([key])
    return found


def offset_claim(**changes):
    one = next(c for c in claims_of("levien_parallel_curves") if c.curve == "plane with delta" and not c.assumes)
    return replace(one, **changes)


@pytest.mark.parametrize(("sign", "everywhere"), [("≠", True), ("≢", False)])
@pytest.mark.parametrize("what", ["delta", "turning"])
def test_what_an_author_assumes_is_of_the_constant_or_the_formula_named(what, sign, everywhere):
    if what == "turning":
        one = next(c for c in claims_of("levien_parallel_curves") if c.named)
        what = next(name for name in one.named)
        if one.curve != "plane with delta":
            pytest.skip("no formula of that kind")
    (told,) = offset_claim(assumes=(f"delta {sign} 0",)).assumes
    assert told.everywhere is everywhere
    assert told.name == f"delta {sign} 0"
