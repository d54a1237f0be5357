"""exactspline: B-splines and NURBS in exact rational arithmetic, and the proofs that go with them.

>>> import exactspline as xs
>>> f = xs.BSpline(2, [0, 0, 0, 1, 2, 2, 2], [0, 1, 0, "1/2"])
>>> (f * f - f**2).is_zero
True

Everything that a user looks for is here; a name is imported when it is first used.
"""

from importlib import import_module
from typing import TYPE_CHECKING

from exactspline.hooks import set_functions, set_printers

if TYPE_CHECKING:
    from exactspline.batch.families import Family as Family
    from exactspline.batch.oracle import oracle as oracle
    from exactspline.batch.sweep import sweep as sweep
    from exactspline.classroom.topics import exercise as exercise
    from exactspline.display.figures.bisectors import figure_4 as figure_4
    from exactspline.display.figures.bisectors import figure_5 as figure_5
    from exactspline.display.figures.bisectors import figure_6 as figure_6
    from exactspline.display.figures.plane import figure_1 as figure_1
    from exactspline.display.figures.plane import figure_2 as figure_2
    from exactspline.display.figures.plane import figure_3 as figure_3
    from exactspline.display.latex import mathematics as mathematics
    from exactspline.display.plot.anything import plot as plot
    from exactspline.display.plot.canvas import new_figure as new_figure
    from exactspline.display.plot.comparisons import plot_approaches as plot_approaches
    from exactspline.display.plot.curves import plot_curve as plot_curve
    from exactspline.display.plot.curves import plot_evolute as plot_evolute
    from exactspline.display.plot.curves import plot_features as plot_features
    from exactspline.display.plot.curves import plot_quotient as plot_quotient
    from exactspline.display.plot.functions import plot_function as plot_function
    from exactspline.display.plot.functions import plot_roots as plot_roots
    from exactspline.display.plot.patches import surface_figure as surface_figure
    from exactspline.display.plot.surfaces import plot_bisector as plot_bisector
    from exactspline.display.plot.surfaces import plot_ruled_surface as plot_ruled_surface
    from exactspline.display.serialize import derived_data as derived_data
    from exactspline.display.serialize import inspection_data as inspection_data
    from exactspline.display.tables import Grid as Grid
    from exactspline.display.tables import approaches_table as approaches_table
    from exactspline.display.tables import degree_table as degree_table
    from exactspline.display.tables import measured as measured
    from exactspline.display.tables import numerical_claims as numerical_claims
    from exactspline.display.tables import printed_numbers as printed_numbers
    from exactspline.display.tables import reduction_table as reduction_table
    from exactspline.display.tables import symbolic_table as symbolic_table
    from exactspline.display.tables import verdicts as verdicts
    from exactspline.errors import ExactSplineError as ExactSplineError
    from exactspline.geometry.analysis import analyse as analyse
    from exactspline.geometry.bisector.any_pair import bisector as bisector
    from exactspline.geometry.bisector.trimmed import trimmed_bisector as trimmed_bisector
    from exactspline.geometry.constructions import Variant as Variant
    from exactspline.geometry.constructions import construction as construction
    from exactspline.geometry.curvature import curvature_function as curvature_function
    from exactspline.geometry.derived import derive as derive
    from exactspline.geometry.derived import evolute as evolute
    from exactspline.geometry.derived import focal_curve as focal_curve
    from exactspline.geometry.derived import torsion_function as torsion_function
    from exactspline.geometry.floats import at_floats as at_floats
    from exactspline.geometry.floats import floats as floats
    from exactspline.geometry.inspection import Approach as Approach
    from exactspline.geometry.inspection import inspect_curve as inspect_curve
    from exactspline.geometry.many_curves import features_of_many as features_of_many
    from exactspline.geometry.many_splines import features_of_curves as features_of_curves
    from exactspline.geometry.ruled_surfaces import ruled_surface as ruled_surface
    from exactspline.geometry.surface.inspection import inspect_surface as inspect_surface
    from exactspline.geometry.surface.planar_maps import jacobian_sign as jacobian_sign
    from exactspline.geometry.values_along import curvature as curvature
    from exactspline.geometry.values_along import torsion as torsion
    from exactspline.geometry.zero_forms import zero_form as zero_form
    from exactspline.interchange.bridges.geomdl import from_geomdl as from_geomdl
    from exactspline.interchange.bridges.geomdl import to_geomdl as to_geomdl
    from exactspline.interchange.bridges.scipy import from_scipy as from_scipy
    from exactspline.interchange.bridges.scipy import to_scipy as to_scipy
    from exactspline.interchange.files import read as read
    from exactspline.interchange.files import write as write
    from exactspline.language.complex_numbers import complex_product as complex_product
    from exactspline.language.complex_numbers import complex_quotient as complex_quotient
    from exactspline.language.complex_numbers import conjugate as conjugate
    from exactspline.language.formula import formula as formula
    from exactspline.language.parts import numerator as numerator
    from exactspline.language.rational import Rational as Rational
    from exactspline.language.ruled import ruled as ruled
    from exactspline.language.vector import Vector as Vector
    from exactspline.language.vector import cross as cross
    from exactspline.language.vector import det as det
    from exactspline.language.vector import dot as dot
    from exactspline.language.vector import generalized_cross as generalized_cross
    from exactspline.language.vector import join as join
    from exactspline.language.vector import norm2 as norm2
    from exactspline.language.vector import perp as perp
    from exactspline.language.vector import triple as triple
    from exactspline.language.wronskians import wronskian as wronskian
    from exactspline.numbers.exact import from_float as from_float
    from exactspline.numbers.exact import from_floats as from_floats
    from exactspline.numbers.exact import rational as rational
    from exactspline.numbers.sides import Side as Side
    from exactspline.papers import find as find
    from exactspline.papers import load_paper as load_paper
    from exactspline.papers import paper as paper
    from exactspline.readings.degree import DegreeReading as DegreeReading
    from exactspline.readings.degree import parse as parse_degree  # noqa: F401
    from exactspline.readings.jet import JetReading as JetReading
    from exactspline.readings.taylor import series_curve as series_curve
    from exactspline.readings.tree import trace as trace
    from exactspline.reals.real import Real as Real
    from exactspline.reals.real import square_root as square_root
    from exactspline.roots.checker import check as check_certificate  # noqa: F401
    from exactspline.roots.root import Root as Root
    from exactspline.roots.values import at as at
    from exactspline.roots.zero_set import ZeroSet as ZeroSet
    from exactspline.roots.zero_set import zeros as zeros
    from exactspline.splines.bspline import BSpline as BSpline
    from exactspline.splines.control_points import Direction as Direction
    from exactspline.splines.control_points import greville_abscissae as greville_abscissae
    from exactspline.splines.curve_files import curve_from_text as curve_from_text
    from exactspline.splines.curve_files import save as save
    from exactspline.splines.examples import example as example
    from exactspline.splines.examples import example_names as example_names
    from exactspline.splines.examples import example_surface as example_surface
    from exactspline.splines.examples import example_surface_names as example_surface_names
    from exactspline.splines.examples import load as load
    from exactspline.splines.examples import load_surface as load_surface
    from exactspline.splines.knots import KnotVector as KnotVector
    from exactspline.splines.lowest_terms import control_point_count as control_point_count
    from exactspline.splines.nurbs import Nurbs as Nurbs
    from exactspline.splines.surface import NurbsSurface as NurbsSurface
    from exactspline.splines.surface_files import save_surface as save_surface
    from exactspline.splines.surface_files import surface_from_text as surface_from_text
    from exactspline.splines.tensor import TensorSpline as TensorSpline
    from exactspline.splines.tensor import surface_pair as surface_pair
    from exactspline.splines.triangles import de_boor_triangle as de_boor_triangle
    from exactspline.splines.triangles import elevation_triangles as elevation_triangles
    from exactspline.splines.triangles import insertion_triangle as insertion_triangle
    from exactspline.splines.triangles import product_tables as product_tables
    from exactspline.symbolic.factorization import jets_for as jets_for
    from exactspline.verification.claims import all_claims as all_claims
    from exactspline.verification.claims import claims_of as claims_of
    from exactspline.verification.claims import select as select_claims  # noqa: F401
    from exactspline.verification.curve_check import spline_table as table_1_splines  # noqa: F401
    from exactspline.verification.errata import errata as errata
    from exactspline.verification.generic_proof import degree_table as table_1_degrees  # noqa: F401
    from exactspline.verification.generic_proof import factor_of as factor_of
    from exactspline.verification.ledger import proved as proved
    from exactspline.verification.measure import measurable as measurable
    from exactspline.verification.measure import measure as measure
    from exactspline.verification.patch_degrees import patch_table as patch_table
    from exactspline.verification.patch_degrees import variants_table as variants_table
    from exactspline.verification.questions import degree as degree
    from exactspline.verification.questions import prove as prove
    from exactspline.verification.questions import reduction as reduction
    from exactspline.verification.questions import verify as verify
    from exactspline.verification.statement import statements as statements
    from exactspline.verification.verdict import PROVED as PROVED
    from exactspline.verification.verdict import REFUTED as REFUTED
    from exactspline.verification.verdict import VERIFIED as VERIFIED

__version__ = "0.2.0"

#: The front door: name → ``module:attribute`` inside the package; what type checkers read stands above.
_HOMES = {
    # values
    "BSpline": "splines.bspline:BSpline",
    "Direction": "splines.control_points:Direction",
    "ExactSplineError": "errors:ExactSplineError",
    "KnotVector": "splines.knots:KnotVector",
    "Nurbs": "splines.nurbs:Nurbs",
    "NurbsSurface": "splines.surface:NurbsSurface",
    "Rational": "language.rational:Rational",
    "Real": "reals.real:Real",
    "Root": "roots.root:Root",
    "TensorSpline": "splines.tensor:TensorSpline",
    "Vector": "language.vector:Vector",
    "ZeroSet": "roots.zero_set:ZeroSet",
    # words that are chosen from
    "Approach": "geometry.inspection:Approach",
    "Side": "numbers.sides:Side",
    "Variant": "geometry.constructions:Variant",
    # numbers and files
    "from_float": "numbers.exact:from_float",
    "from_floats": "numbers.exact:from_floats",
    "at": "roots.values:at",
    "at_floats": "geometry.floats:at_floats",
    "floats": "geometry.floats:floats",
    "from_geomdl": "interchange.bridges.geomdl:from_geomdl",
    "from_scipy": "interchange.bridges.scipy:from_scipy",
    "rational": "numbers.exact:rational",
    "square_root": "reals.real:square_root",
    "read": "interchange.files:read",
    "to_geomdl": "interchange.bridges.geomdl:to_geomdl",
    "to_scipy": "interchange.bridges.scipy:to_scipy",
    "write": "interchange.files:write",
    "curve_from_text": "splines.curve_files:curve_from_text",
    "example": "splines.examples:example",
    "example_names": "splines.examples:example_names",
    "example_surface": "splines.examples:example_surface",
    "example_surface_names": "splines.examples:example_surface_names",
    "load": "splines.examples:load",
    "load_surface": "splines.examples:load_surface",
    "save": "splines.curve_files:save",
    "save_surface": "splines.surface_files:save_surface",
    "surface_from_text": "splines.surface_files:surface_from_text",
    # what a curve has
    "construction": "geometry.constructions:construction",
    "analyse": "geometry.analysis:analyse",
    "inspect_curve": "geometry.inspection:inspect_curve",
    "features_of_curves": "geometry.many_splines:features_of_curves",
    "features_of_many": "geometry.many_curves:features_of_many",
    "zero_form": "geometry.zero_forms:zero_form",
    "zeros": "roots.zero_set:zeros",
    "check_certificate": "roots.checker:check",
    "oracle": "batch.oracle:oracle",
    # what is made of curves
    "bisector": "geometry.bisector.any_pair:bisector",
    "curvature": "geometry.values_along:curvature",
    "curvature_function": "geometry.curvature:curvature_function",
    "derive": "geometry.derived:derive",
    "evolute": "geometry.derived:evolute",
    "focal_curve": "geometry.derived:focal_curve",
    "ruled_surface": "geometry.ruled_surfaces:ruled_surface",
    "torsion": "geometry.values_along:torsion",
    "torsion_function": "geometry.derived:torsion_function",
    "trimmed_bisector": "geometry.bisector.trimmed:trimmed_bisector",
    # what a surface has
    "inspect_surface": "geometry.surface.inspection:inspect_surface",
    "jacobian_sign": "geometry.surface.planar_maps:jacobian_sign",
    # the classroom: exercises, and the algorithms step by step
    "exercise": "classroom.topics:exercise",
    "de_boor_triangle": "splines.triangles:de_boor_triangle",
    "elevation_triangles": "splines.triangles:elevation_triangles",
    "insertion_triangle": "splines.triangles:insertion_triangle",
    "product_tables": "splines.triangles:product_tables",
    # the language of formulas
    "complex_product": "language.complex_numbers:complex_product",
    "complex_quotient": "language.complex_numbers:complex_quotient",
    "conjugate": "language.complex_numbers:conjugate",
    "cross": "language.vector:cross",
    "det": "language.vector:det",
    "dot": "language.vector:dot",
    "find": "papers:find",
    "load_paper": "papers:load_paper",
    "paper": "papers:paper",
    "formula": "language.formula:formula",
    "generalized_cross": "language.vector:generalized_cross",
    "join": "language.vector:join",
    "norm2": "language.vector:norm2",
    "perp": "language.vector:perp",
    "ruled": "language.ruled:ruled",
    "triple": "language.vector:triple",
    "wronskian": "language.wronskians:wronskian",
    # readings: what a formula can be handed
    "DegreeReading": "readings.degree:DegreeReading",
    "JetReading": "readings.jet:JetReading",
    "jets_for": "symbolic.factorization:jets_for",
    "series_curve": "readings.taylor:series_curve",
    "surface_pair": "splines.tensor:surface_pair",
    "table_1_degrees": "verification.generic_proof:degree_table",
    "table_1_splines": "verification.curve_check:spline_table",
    "trace": "readings.tree:trace",
    # statements
    "PROVED": "verification.verdict:PROVED",
    "REFUTED": "verification.verdict:REFUTED",
    "VERIFIED": "verification.verdict:VERIFIED",
    "all_claims": "verification.claims:all_claims",
    "claims_of": "verification.claims:claims_of",
    "control_point_count": "splines.lowest_terms:control_point_count",
    "degree_table": "display.tables:degree_table",
    "errata": "verification.errata:errata",
    "factor_of": "verification.generic_proof:factor_of",
    "measurable": "verification.measure:measurable",
    "measure": "verification.measure:measure",
    "numerator": "language.parts:numerator",
    "parse_degree": "readings.degree:parse",
    "degree": "verification.questions:degree",
    "prove": "verification.questions:prove",
    "proved": "verification.ledger:proved",
    "reduction": "verification.questions:reduction",
    "patch_table": "verification.patch_degrees:patch_table",
    "variants_table": "verification.patch_degrees:variants_table",
    "select_claims": "verification.claims:select",
    "statements": "verification.statement:statements",
    "verify": "verification.questions:verify",
    # many curves
    "Family": "batch.families:Family",
    "sweep": "batch.sweep:sweep",
    # tables
    "Grid": "display.tables:Grid",
    "approaches_table": "display.tables:approaches_table",
    "derived_data": "display.serialize:derived_data",
    "inspection_data": "display.serialize:inspection_data",
    "mathematics": "display.latex:mathematics",
    "measured": "display.tables:measured",
    "numerical_claims": "display.tables:numerical_claims",
    "printed_numbers": "display.tables:printed_numbers",
    "reduction_table": "display.tables:reduction_table",
    "symbolic_table": "display.tables:symbolic_table",
    "verdicts": "display.tables:verdicts",
    # pictures
    "figure_1": "display.figures.plane:figure_1",
    "figure_2": "display.figures.plane:figure_2",
    "figure_3": "display.figures.plane:figure_3",
    "figure_4": "display.figures.bisectors:figure_4",
    "figure_5": "display.figures.bisectors:figure_5",
    "figure_6": "display.figures.bisectors:figure_6",
    "greville_abscissae": "splines.control_points:greville_abscissae",
    "new_figure": "display.plot.canvas:new_figure",
    "plot": "display.plot.anything:plot",
    "plot_approaches": "display.plot.comparisons:plot_approaches",
    "plot_bisector": "display.plot.surfaces:plot_bisector",
    "plot_curve": "display.plot.curves:plot_curve",
    "plot_evolute": "display.plot.curves:plot_evolute",
    "plot_features": "display.plot.curves:plot_features",
    "plot_function": "display.plot.functions:plot_function",
    "surface_figure": "display.plot.patches:surface_figure",
    "plot_quotient": "display.plot.curves:plot_quotient",
    "plot_roots": "display.plot.functions:plot_roots",
    "plot_ruled_surface": "display.plot.surfaces:plot_ruled_surface",
}


def _printed(form: str, shown: object) -> str | None:
    """The text of an object in a notebook, or what was found in words."""
    home = "exactspline.display.evidence" if form == "words" else "exactspline.display.notebook"
    found: str | None = getattr(import_module(home), form)(shown)
    return found


set_printers(_printed)
set_functions(name for name in _HOMES if name.islower())

__all__ = [*_HOMES, "__version__"]  # noqa: PLE0604

if not TYPE_CHECKING:

    def __getattr__(name):
        """Import a public name when it is first used, so that importing the package is cheap."""
        if name not in _HOMES:
            raise AttributeError(f"module 'exactspline' has no attribute {name!r}")
        module, _, attribute = _HOMES[name].partition(":")
        found = globals()[name] = getattr(import_module(f"exactspline.{module}"), attribute)
        return found


def __dir__() -> list[str]:
    return sorted(__all__)
