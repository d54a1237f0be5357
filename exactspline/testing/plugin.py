"""A plugin of pytest with a fixture of nasty curves: ``pytest -p exactspline.testing.plugin``, or ``pytest_plugins =
["exactspline.testing.plugin"]`` in ``conftest.py``. A test with the argument ``nasty_case`` runs once for every case;
``--nasty N`` takes N of each family (by default 20), ``--nasty all`` every one.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from exactspline.testing.families import all_cases

if TYPE_CHECKING:
    import pytest

#: The number of cases of each family that are taken by default.
USUAL = "20"


def pytest_addoption(parser: pytest.Parser) -> None:
    """The option ``--nasty``."""
    parser.addoption("--nasty", default=USUAL, metavar="N", help="Nasty curves of each family, or all (exactspline).")


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """The cases of a test that takes ``nasty_case``."""
    if "nasty_case" in metafunc.fixturenames:
        given = metafunc.config.getoption("nasty")
        cases = list(all_cases(None if given == "all" else int(given)))
        metafunc.parametrize("nasty_case", cases, ids=[case.key for case in cases])
