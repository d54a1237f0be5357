"""One module per library: the library's calls behind a common set of questions.

An adapter converts numbers and picks out results; it never repairs an answer. Questions that a library does not offer,
or does not claim to support, are not asked.
"""

from __future__ import annotations

from importlib import import_module

from workshop.grade.adapters.common import Adapter

#: The modules here by the names of the libraries.
LIBRARIES = {
    "scipy": "scipy_splines",
    "geomdl": "geomdl_curves",
    "splinepy": "splinepy_splines",
    "bezier": "bezier_curves",
    "fontTools": "fonttools_bezier",
    "Open CASCADE": "open_cascade",
    "svgpathtools": "svgpathtools_paths",
    "svgelements": "svgelements_paths",
    "rhino3dm": "rhino3dm_curves",
    "splipy": "splipy_curves",
    "nurbspy": "nurbspy_curves",
    "bezier-js": "bezier_js",
}


def adapter(library: str) -> Adapter:
    """The adapter of a library; ImportError where it is not installed."""
    module = import_module(f"workshop.grade.adapters.{LIBRARIES[library]}")
    made: Adapter = module.ADAPTER()
    return made
