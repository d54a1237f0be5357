"""The registry of all questions about a curve, a surface, a map of the plane, or a pair of curves. An entry is defined
where its exact answer is computed; this module only lists the classes that have entries.
"""

from __future__ import annotations

from collections.abc import Container

from exactspline.geometry.analysis.curves import Analysis
from exactspline.geometry.analysis.pairs import CurvePair
from exactspline.geometry.analysis.planar_maps import MapInspection
from exactspline.geometry.analysis.surface_pairs import SurfacePair
from exactspline.geometry.analysis.surfaces import SurfaceInspection
from exactspline.geometry.bisectors.two_curves import CurveBisector
from exactspline.geometry.pairs.regions import Region
from exactspline.questions.entry import Entry, Of, questions_of

#: The classes whose properties are questions.
ASKED = (Analysis, SurfaceInspection, MapInspection, CurveBisector, CurvePair, SurfacePair, Region)
#: The questions by the kind of object that they are asked of, and by their names.
REGISTRY: dict[Of, dict[str, Entry]] = {
    of: {name: entry for owner in ASKED for name, entry in questions_of(owner).items() if of in entry.about.of}
    for of in Of
}


def terms_of_questions(other: Container[str] = ()) -> dict[str, str]:
    """The meanings of the questions by their names; if two questions share a name, the question that is not about
    curves is listed with its object, as is a question with the name of another term.

    >>> terms_of_questions()["umbilics"]
    'the points with a tangent plane at which the two principal curvatures are equal'
    >>> terms_of_questions()["singular points of a surface in space"]
    'the points without a tangent plane'
    """
    named: dict[str, Entry] = {}
    for of, entries in REGISTRY.items():
        for name, entry in entries.items():
            words = name.replace("_", " ")
            taken = words in other or named.get(words, entry) is not entry
            named[f"{words} of a {of}" if taken else words] = entry
    return {words: entry.meaning for words, entry in named.items()}
