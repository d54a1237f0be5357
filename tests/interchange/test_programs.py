"""Files written by other programs, three of each kind: a sample of `tests.campaigns.programs`."""

import pytest

from tests.campaigns.programs import PROGRAMS, campaign


@pytest.mark.parametrize("name", PROGRAMS)
def test_files_of_other_programs_are_the_curves_that_these_mean(name):
    pytest.importorskip(PROGRAMS[name][0])
    found, _ = campaign(3, 1, [name])
    assert found == {(name, "same"): 3}
