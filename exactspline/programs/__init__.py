"""Formulas as straight-line programs: traced once for a kind of argument and run segment by segment on integers.

>>> from exactspline.papers import find
>>> from exactspline.interchange.examples import example
>>> curve = example("rational_cubic")
>>> on_segments = program_for(find("g2"), curve)
>>> on_segments(curve) == find("g2")(curve), on_segments.count("mul")
(True, 31)

For two curves, terms that depend on one curve are computed segment by segment, and only the other terms patch by patch.

>>> from exactspline.splines.tensor import surface_pair
>>> pair = surface_pair(example("rational_space_cubic"), example("ellipse_in_space"))
>>> evaluated(find("bisector_symmetric"), pair) == find("bisector_symmetric")(pair)
True
"""

from exactspline.programs.program import Program, evaluated, program_for

__all__ = ["Program", "evaluated", "program_for"]
