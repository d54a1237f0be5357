"""Shared by checks on a concrete surface: which formulas are not multiplied out."""

from __future__ import annotations

from collections.abc import Iterable

from exactspline.language.formula import Formula
from exactspline.readings.degree import DegreeReading
from exactspline.splines.surface import NurbsSurface
from exactspline.verification.evidence import TooLong
from exactspline.verification.vocabulary import Name

#: The largest degree in a parameter to which formulas are multiplied out on single surfaces.
LARGEST = 100


def too_long(formulas: Iterable[Formula], surface: NurbsSurface) -> TooLong | None:
    """The first formula whose value as written has too high a degree on a surface; None where there is none.

    >>> from exactspline.papers import find
    >>> from exactspline.interchange.examples import example_surface
    >>> print(too_long([find("surfaces:E"), find("surfaces:brioschi")], example_surface("torus")))
    brioschi as written has degree 208 in u there, too high to be multiplied out
    """
    for formula in formulas:
        for parameter, d in zip(formula.kind.counted, surface.degree, strict=True):
            reading = DegreeReading(parameter=parameter)
            degree = reading.count(formula, surface.dimension, polynomial=surface.polynomial)
            if (n := degree.at(dict.fromkeys(degree.names, d))) > LARGEST:
                return TooLong(Name(formula.name), n, parameter)
    return None
