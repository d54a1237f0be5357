"""What begins with an underscore belongs to its module: no other one asks for it."""

import ast

import pytest

from tests.support.gates import foreign_private_names, found_in, trees
from tests.support.import_graph import ROOT

#: Names of other libraries that begin with an underscore.
THEIRS = {"_exit", "_lru_cache_wrapper", "_mpf_", "_replace", "_value2member_map_"}


def files():
    """The modules of the package and of the workshop."""
    paths = sorted((ROOT.parent / "workshop").rglob("*.py"))
    return trees() | {p.relative_to(ROOT.parent).as_posix(): ast.parse(p.read_text(encoding="utf-8")) for p in paths}


def test_no_module_asks_for_the_private_names_of_another():
    assert found_in(files(), lambda tree: foreign_private_names(tree, THEIRS)) == set()


@pytest.mark.parametrize(
    ("code", "found"),
    [
        ("def zeros(f):\n    return f._polynomials\n", ["zeros: _polynomials"]),
        ("from exactspline.splines import blossom\nblossom._weights(3)\n", [": _weights"]),
        ("from exactspline.splines.blossom import _weights\n", [": _weights"]),
        ("def changed(f):\n    f._points = ()\n", ["changed: _points"]),
        ("row = row._replace(a=1)\n", []),
        ("class A:\n    _b: int\n    def __eq__(self, other):\n        return other._b\n", []),
        ("class A(B):\n    def sum(self, other):\n        return self._b + other._b\n", []),
        ("class A:\n    def _b(self): ...\ndef c(a):\n    return a._b() + a.__dict__\n", []),
    ],
)
def test_it_finds_a_planted_one(code, found):
    assert list(foreign_private_names(ast.parse(code), THEIRS)) == found
