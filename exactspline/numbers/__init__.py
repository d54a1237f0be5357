"""Numbers: conversion of input to exact numbers, intervals, rounding to doubles, immutable values, sides of a point.

gmpy2 is loaded here first. gmpy2 asks `importlib.metadata` for its own version, and loading this module (with modules
for mail, archives and sockets) takes longer than loading gmpy2. Therefore a stand-in is used here, which reads the
version from the name of the folder next to the package.
"""

from __future__ import annotations

import sys
from importlib.util import find_spec
from os import listdir
from types import ModuleType

_METADATA = "importlib.metadata"


def _versions(name: str) -> list[str]:
    """The versions of a package by the folders with its metadata; more than one, or none, if the version is not
    clear.
    """
    spec = find_spec(name)
    places = spec.submodule_search_locations if spec else None
    beside = [folder for place in places or () for folder in listdir(f"{place}/..")]
    own = [folder for folder in beside if folder.startswith(f"{name}-") and folder.endswith(".dist-info")]
    return [folder.removesuffix(".dist-info").removeprefix(f"{name}-") for folder in own]


if _METADATA not in sys.modules and "gmpy2" not in sys.modules and len(found := _versions("gmpy2")) == 1:
    stand_in = sys.modules[_METADATA] = ModuleType(_METADATA)
    vars(stand_in)["version"] = lambda name: found[0]
    try:
        import gmpy2  # noqa: F401  # it is used by others
    finally:
        del sys.modules[_METADATA]
