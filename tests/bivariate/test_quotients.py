"""The least of several numbers, which may be out of reach."""

import pytest
from flint import arb

from exactspline import Real
from exactspline.bivariate.quotients import keep_least
from exactspline.errors import ReachError
from exactspline.reals.ball import InBalls


def out_of_reach():
    raise ReachError("equality", remedy="none")


def test_what_may_be_least_is_kept_where_equality_is_out_of_reach():
    """A pair that is farther was told among the nearest ones, beside what was undecided."""
    one, other = (InBalls(lambda bits: arb(2).sqrt(), out_of_reach) for _ in range(2))
    found = [(Real(5), "far"), (one, "one"), (other, "other")]
    with pytest.raises(ReachError):
        keep_least(found, 12)
    assert [name for _, name in found] == ["one", "other"]
