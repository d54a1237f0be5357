"""The figures of the paper, in its layout; every number in a caption is counted on the drawn objects. And the
approaches that the paper compares, on any curve.

Formulas and claims lie below everything that computes with them; what draws lies above it, and is loaded by the name of
this folder alone.
"""

from exactspline.papers.chen_riesenfeld_cohen_2007.figures.approaches import (
    approaches_table,
    compare_approaches,
    plot_approaches,
)
from exactspline.papers.chen_riesenfeld_cohen_2007.figures.in_space import figure_4, figure_5, figure_6
from exactspline.papers.chen_riesenfeld_cohen_2007.figures.plane import figure_1, figure_2, figure_3

__all__ = ["FIGURES", "approaches_table", "compare_approaches", "plot_approaches"]

#: The figures by number.
FIGURES = {1: figure_1, 2: figure_2, 3: figure_3, 4: figure_4, 5: figure_5, 6: figure_6}
