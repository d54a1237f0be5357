"""Nasty curves to test programs with: families of curves whose numbers are doubles, the same in every run.

Each case is a curve, a parameter for questions, and its origin. Random and integer control points, outlines as in type
design, arcs and offsets as in CAD files, curves that are almost degenerate (a cusp, a threefold zero, a straight line,
up to 2⁻⁵²), and curves from public bug reports of other libraries, each with its link.

>>> case = next(case for case in all_cases() if case.key == "near 2 cusp")
>>> case.curve.control_points[2], case.note
((mpq(1,4), mpq(1,1)), 'ε = 2⁻ᵏ, k = 2')
"""

from exactspline.testing.families import FAMILIES as FAMILIES
from exactspline.testing.families import REPORTED as REPORTED
from exactspline.testing.families import VERSION as VERSION
from exactspline.testing.families import Case as Case
from exactspline.testing.families import Reported as Reported
from exactspline.testing.families import all_cases as all_cases
from exactspline.testing.strategies import nasty_curves as nasty_curves
from exactspline.testing.strategies import near as near
from exactspline.testing.strategies import near_cusps as near_cusps
from exactspline.testing.strategies import near_double_inflections as near_double_inflections
from exactspline.testing.strategies import near_lines as near_lines
