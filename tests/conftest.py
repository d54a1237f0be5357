"""How hypothesis searches: the same examples every time; `--hypothesis-profile=search` looks further, with new ones.
And how often memory is collected: what was loaded before the first test stays, and need not be looked through again.
And where claims are decided, and generic degrees measured, once for all tests: in rooms that change no engine, whose
tests come first, so that of two processes one has them all.
"""

import gc
import os
import sys

import pytest
from hypothesis import HealthCheck, settings

#: No test decides by what an earlier run has left in the cache of whoever runs them.
os.environ["EXACTSPLINE_CACHE"] = "none"
SLOW = [HealthCheck.too_slow, HealthCheck.data_too_large, HealthCheck.filter_too_much]
settings.register_profile(
    "repeat", deadline=None, max_examples=25, derandomize=True, database=None, suppress_health_check=SLOW
)
settings.register_profile("search", deadline=None, max_examples=1000, suppress_health_check=SLOW)
settings.load_profile("repeat")
#: The rooms that decide claims and change no engine; in the room of the judge only some files do.
DECIDING = ("cli", "display", "journeys")


def pytest_collection_modifyitems(items):
    items.sort(key=lambda item: item.path.parent.name not in (*DECIDING, "verification", "proofs"))


def pytest_sessionfinish():
    """What was decided is kept for the site, where the folder for that is named."""
    decided = sys.modules.get("tests.support.decided")
    if decided and "EXACTSPLINE_KEPT" in os.environ:
        from docs.site.kept import keep

        keep(decided.proofs())


def pytest_collection_finish():
    gc.collect()
    gc.freeze()
    gc.set_threshold(50_000, 20, 20)


@pytest.fixture(autouse=True, scope="module")
def decided_by_room(request):
    if request.path.parent.name not in DECIDING:
        yield
        return
    from tests.support.decided import decided_once

    with decided_once():
        yield
