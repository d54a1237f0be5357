"""exactspline: B-splines and NURBS in exact rational arithmetic, and the proofs that go with them.

>>> from exactspline import BSpline
>>> f = BSpline(2, [0, 0, 0, 1, 2, 2, 2], [0, 1, 0, "1/2"])
>>> (f * f - f**2).is_zero
True
"""

from importlib import import_module
from typing import Any

from exactspline.language.services import register

__version__ = "0.1.0"

_SERVICES = {
    "quotient": "exactspline.language.rational:Rational",
    "formula_text": "exactspline.readings.printing.text:print_text",
    "html": "exactspline.display.notebook:html",
    "latex": "exactspline.display.latex:latex",
    "short": "exactspline.display.notebook:short",
}
register(_SERVICES)

_HOMES = {
    "BSpline": "splines.bspline",
    "KnotVector": "splines.knots",
    "Nurbs": "splines.nurbs",
    "Vector": "language.vector",
    "Rational": "language.rational",
    "formula": "language.formula",
    "dot": "language.vector",
    "cross": "language.vector",
    "det": "language.vector",
    "perp": "language.vector",
    "norm2": "language.vector",
    "triple": "language.vector",
    "generalized_cross": "language.vector",
    "wronskian": "language.vector",
    "rational": "exact",
    "from_float": "exact",
}

__all__ = [*_HOMES, "__version__"]  # noqa: PLE0604


def __getattr__(name: str) -> Any:
    """Import a public name when it is first used, so that importing the package costs next to nothing."""
    if name not in _HOMES:
        raise AttributeError(f"module 'exactspline' has no attribute {name!r}")
    return getattr(import_module(f"exactspline.{_HOMES[name]}"), name)


def __dir__() -> list[str]:
    return sorted(__all__)
