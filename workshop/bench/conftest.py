"""Before a timing the garbage of the program is collected: not of all that was tested before it."""

import gc

import pytest


@pytest.fixture(autouse=True, scope="module")
def only_new_garbage() -> None:
    """What was made before a module is not looked through again."""
    gc.freeze()
