"""exactspline: B-splines and NURBS in exact rational arithmetic, and the proofs that go with them.

>>> import exactspline as xs
>>> f = xs.BSpline(2, [0, 0, 0, 1, 2, 2, 2], [0, 1, 0, "1/2"])
>>> (f * f - f**2).is_zero
True

Everything that a user looks for is here; a name is imported when it is first used.
"""

from importlib import import_module
from typing import TYPE_CHECKING

from exactspline.language.services import register

if TYPE_CHECKING:
    from exactspline.display.plot.anything import plot as plot
    from exactspline.display.tables import degree_table as degree_table
    from exactspline.errors import ExactSplineError as ExactSplineError
    from exactspline.exact import from_float as from_float
    from exactspline.exact import from_floats as from_floats
    from exactspline.exact import rational as rational
    from exactspline.geometry.any_bisector import bisector as bisector
    from exactspline.geometry.curvature import curvature as curvature
    from exactspline.geometry.derived import derive as derive
    from exactspline.geometry.derived import evolute as evolute
    from exactspline.geometry.derived import focal_curve as focal_curve
    from exactspline.geometry.derived import torsion as torsion
    from exactspline.geometry.plane_features import curvature_extrema as curvature_extrema
    from exactspline.geometry.plane_features import inflections as inflections
    from exactspline.geometry.ruled_surfaces import ruled_surface as ruled_surface
    from exactspline.geometry.singular_points import singularities as singular_points  # noqa: F401
    from exactspline.geometry.space_features import torsion_zeros as torsion_zeros
    from exactspline.geometry.trimmed_bisector import trimmed_bisector as trimmed_bisector
    from exactspline.language.formula import formula as formula
    from exactspline.language.rational import Rational as Rational
    from exactspline.language.vector import Vector as Vector
    from exactspline.language.vector import cross as cross
    from exactspline.language.vector import det as det
    from exactspline.language.vector import dot as dot
    from exactspline.language.vector import generalized_cross as generalized_cross
    from exactspline.language.vector import norm2 as norm2
    from exactspline.language.vector import perp as perp
    from exactspline.language.vector import triple as triple
    from exactspline.language.vector import wronskian as wronskian
    from exactspline.papers import find as find
    from exactspline.roots.enclosure import Enclosure as Enclosure
    from exactspline.roots.root import Root as Root
    from exactspline.roots.zero_set import ZeroSet as ZeroSet
    from exactspline.roots.zero_set import zeros as zeros
    from exactspline.splines.bspline import BSpline as BSpline
    from exactspline.splines.control_points import Direction as Direction
    from exactspline.splines.curve_files import curve_from_text as curve_from_text
    from exactspline.splines.curve_files import save as save
    from exactspline.splines.examples import example as example
    from exactspline.splines.examples import example_names as example_names
    from exactspline.splines.examples import load as load
    from exactspline.splines.knots import KnotVector as KnotVector
    from exactspline.splines.nurbs import Nurbs as Nurbs
    from exactspline.splines.surd import Surd as Surd
    from exactspline.splines.tensor import TensorSpline as TensorSpline
    from exactspline.verification.errata import errata as errata
    from exactspline.verification.questions import prove as prove
    from exactspline.verification.questions import reduction as reduction
    from exactspline.verification.questions import verify as verify

__version__ = "0.1.0"

#: The front door: name → ``module:attribute`` inside the package; what type checkers read stands above.
_HOMES = {
    # values
    "BSpline": "splines.bspline:BSpline",
    "Direction": "splines.control_points:Direction",
    "Enclosure": "roots.enclosure:Enclosure",
    "ExactSplineError": "errors:ExactSplineError",
    "KnotVector": "splines.knots:KnotVector",
    "Nurbs": "splines.nurbs:Nurbs",
    "Rational": "language.rational:Rational",
    "Root": "roots.root:Root",
    "Surd": "splines.surd:Surd",
    "TensorSpline": "splines.tensor:TensorSpline",
    "Vector": "language.vector:Vector",
    "ZeroSet": "roots.zero_set:ZeroSet",
    # numbers and files
    "from_float": "exact:from_float",
    "from_floats": "exact:from_floats",
    "rational": "exact:rational",
    "curve_from_text": "splines.curve_files:curve_from_text",
    "example": "splines.examples:example",
    "example_names": "splines.examples:example_names",
    "load": "splines.examples:load",
    "save": "splines.curve_files:save",
    # what a curve has
    "curvature_extrema": "geometry.plane_features:curvature_extrema",
    "inflections": "geometry.plane_features:inflections",
    "singular_points": "geometry.singular_points:singularities",
    "torsion_zeros": "geometry.space_features:torsion_zeros",
    "zeros": "roots.zero_set:zeros",
    # what is made of curves
    "bisector": "geometry.any_bisector:bisector",
    "curvature": "geometry.curvature:curvature",
    "derive": "geometry.derived:derive",
    "evolute": "geometry.derived:evolute",
    "focal_curve": "geometry.derived:focal_curve",
    "ruled_surface": "geometry.ruled_surfaces:ruled_surface",
    "torsion": "geometry.derived:torsion",
    "trimmed_bisector": "geometry.trimmed_bisector:trimmed_bisector",
    # the language of formulas
    "cross": "language.vector:cross",
    "det": "language.vector:det",
    "dot": "language.vector:dot",
    "find": "papers:find",
    "formula": "language.formula:formula",
    "generalized_cross": "language.vector:generalized_cross",
    "norm2": "language.vector:norm2",
    "perp": "language.vector:perp",
    "triple": "language.vector:triple",
    "wronskian": "language.vector:wronskian",
    # statements
    "degree_table": "display.tables:degree_table",
    "errata": "verification.errata:errata",
    "prove": "verification.questions:prove",
    "reduction": "verification.questions:reduction",
    "verify": "verification.questions:verify",
    # pictures
    "plot": "display.plot.anything:plot",
}

#: What objects offer though it lives further right than they do (see `exactspline.language.services`).
_SERVICES = {
    "at": "roots.enclosure:at",
    "curvature": "geometry.values_along:curvature",
    "html": "display.notebook:html",
    "latex": "display.latex:latex",
    "plot": "display.plot.curves:plot_curve",
    "short": "display.notebook:short",
    "torsion": "geometry.values_along:torsion",
}
register({name: f"exactspline.{home}" for name, home in _SERVICES.items()})

__all__ = [*_HOMES, "__version__"]  # noqa: PLE0604

if not TYPE_CHECKING:

    def __getattr__(name):
        """Import a public name when it is first used, so that importing the package costs next to nothing."""
        if name not in _HOMES:
            raise AttributeError(f"module 'exactspline' has no attribute {name!r}")
        module, _, attribute = _HOMES[name].partition(":")
        found = globals()[name] = getattr(import_module(f"exactspline.{module}"), attribute)
        return found


def __dir__() -> list[str]:
    return sorted(__all__)
