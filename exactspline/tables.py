"""This module has tables of degrees, control points, verdicts, printed and computed numbers, and sections of a paper,
and the objects that the tables compare: constructions with their variants, and factors between formulas.

>>> from exactspline.papers import find
>>> from exactspline.interchange.examples import example
>>> measure(find("f2"), example("ellipse"))
<Measure f2: degree 3d − 3, here 3, true degree 0, 16 control points>
"""

from exactspline.display.answer_forms import inspection_data, to_dict, to_records
from exactspline.display.forms import derived_data
from exactspline.display.latex import mathematics
from exactspline.display.tables import (
    Grid,
    degree_table,
    measured,
    numerical_claims,
    printed_numbers,
    reduction_table,
    symbolic_table,
    verdicts,
)
from exactspline.display.theorem import reading_along
from exactspline.geometry.curves.values import curvature_function
from exactspline.geometry.derived.constructions import Variant, construction
from exactspline.geometry.derived.ruled_surfaces import as_tensor_product, is_developable, ruled_surface
from exactspline.splines.control_points import greville_abscissae
from exactspline.splines.lowest_terms import control_point_count
from exactspline.splines.tensor import surface_pair
from exactspline.symbolic.factorization import jets_for
from exactspline.verification.decision import table_1_splines
from exactspline.verification.degree_tables import measurable, measure, patch_table, variants_table
from exactspline.verification.generic_proof import factor_of, table_1_degrees
from exactspline.verification.statement import errata, statements

__all__ = [
    "Grid",
    "Variant",
    "as_tensor_product",
    "construction",
    "control_point_count",
    "curvature_function",
    "degree_table",
    "derived_data",
    "errata",
    "factor_of",
    "greville_abscissae",
    "inspection_data",
    "is_developable",
    "jets_for",
    "mathematics",
    "measurable",
    "measure",
    "measured",
    "numerical_claims",
    "patch_table",
    "printed_numbers",
    "reading_along",
    "reduction_table",
    "ruled_surface",
    "statements",
    "surface_pair",
    "symbolic_table",
    "table_1_degrees",
    "table_1_splines",
    "to_dict",
    "to_records",
    "variants_table",
    "verdicts",
]
