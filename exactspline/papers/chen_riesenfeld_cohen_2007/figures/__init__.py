"""The figures of the paper, in its layout, with captions whose numbers are counted on the drawn objects; and a
comparison of the paper's approaches on any curve.

Modules that compute import formulas and claims. The modules in this folder draw; they import those modules, and are
loaded by the name of this folder only.
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
