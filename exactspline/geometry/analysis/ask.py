"""``ask``: the answer to any question, given as text, about a curve, a surface, a map of the plane, two curves or
surfaces; and the registry of all questions.

An entry is defined where its exact answer is computed; this module only lists the classes that have entries.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple, TypeAlias, overload

from exactspline.errors import as_items
from exactspline.geometry.analysis.curves import QUESTIONS, Analysis, analyse, kind_of_curve, questions_about
from exactspline.geometry.analysis.pairs import CurvePair
from exactspline.geometry.analysis.planar_maps import MapInspection
from exactspline.geometry.analysis.surface_pairs import SurfacePair
from exactspline.geometry.analysis.surface_values import NearestOnSurface
from exactspline.geometry.analysis.surfaces import SurfaceInspection
from exactspline.geometry.bisectors.two_curves import CurveBisector
from exactspline.geometry.curves.planarity import in_common_plane
from exactspline.geometry.pairs.nearest import Nearest
from exactspline.geometry.pairs.nearest import nearest as of_curve
from exactspline.geometry.pairs.regions import Region
from exactspline.interchange.files import read
from exactspline.numbers.exact import Number
from exactspline.one_line import OneLine
from exactspline.questions.entry import ALL_CURVES, CURVES, Entry, Of, Remembers, questions_of
from exactspline.questions.takes import QuestionError, name_of, parts_of, unknown
from exactspline.roots.zero_set import ZeroSet
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface

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


#: The objects of questions: curves, surfaces, pairs of these, or their analyses.
About: TypeAlias = Nurbs | NurbsSurface | tuple[Nurbs, Nurbs] | tuple[NurbsSurface, NurbsSurface] | Remembers
#: The kinds of questions about two objects of the same kind.
PAIRS = (Of.TWO_CURVES, Of.TWO_SURFACES)
#: The kinds of objects by the classes of their analyses.
KINDS: dict[type, Of] = {
    SurfaceInspection: Of.SURFACE,
    MapInspection: Of.PLANAR_MAP,
    CurvePair: Of.TWO_CURVES,
    SurfacePair: Of.TWO_SURFACES,
    CurveBisector: Of.PAIR,
    Region: Of.REGION,
}


@dataclass(frozen=True, repr=False)
class Asked(OneLine):
    """A question about an object: its entry in the registry, and its arguments as text."""

    entry: Entry
    facts: Remembers
    argument: str
    place: str

    @property
    def answer(self) -> object:
        """The exact answer."""
        return self.entry.answer(self.facts, self.argument, self.place)

    @property
    def proofs(self) -> Iterable[ZeroSet]:
        """The zero sets whose certificates show that the answer is complete."""
        return self.entry.proofs(self.facts, self.argument, self.place)


def ask(about: About, question: str) -> object:
    """Return the exact answer to a question, given as text, about a curve, a surface, two curves, or two surfaces.

    ``exactspline list questions`` lists the questions. The object that `analyse` returns has the same answers as
    attributes and methods.

    >>> from exactspline import example
    >>> circle = example("circle")
    >>> ask(circle, "length").double(), ask(circle, "nearest:0,3")
    (6.283185307179586, [<nearest point at 1: distance 2>])
    >>> ask((circle, example("ellipse")), "distance").value
    <Real 0>
    >>> ask(example("torus"), "umbilics")
    nowhere

    Raises `QuestionError`, which names the right form, for an unknown question and for a question about other kinds of
    objects, and another `ExactSplineError` if the question has no answer.
    """
    return asked_of(about, question).answer


def asked_of(about: About, question: str) -> Asked:
    """A question about an object, found in the registry; raises `QuestionError` as `ask` does.

    >>> from exactspline import example
    >>> asked_of(example("cusp"), "derivative:2@cusps").entry.name
    'derivative'
    """
    facts = facts_about(about)
    name, kind = name_of(question), kind_of(facts)
    entry = REGISTRY[kind].get(name)
    if isinstance(facts, Analysis) and entry is None:
        entry = questions_about(facts.given).get(name)
        if entry is None and name in REGISTRY[Of.TWO_CURVES]:
            return _of_two(facts.given, question)
        if entry is None and facts.curve.dimension == 3 and in_common_plane(facts.curve):
            kind = Of.PLANAR_CURVE
    if entry is None:
        raise _not_asked(name, kind)
    return Asked(entry, facts, *read_as(entry, question))


def read_as(entry: Entry, question: str, form: str = "") -> tuple[str, str]:
    """The text behind the colon and the text behind the @ of a question; raises `QuestionError` for too much or too
    little text.
    """
    forms = {name: other.form for name, other in REGISTRY[entry.about.of[0]].items()} | {entry.name: form or entry.form}
    _, argument, place = parts_of(question, forms, (entry.name,) if entry.optional else ())
    return argument, place


@overload
def nearest(thing: Nurbs, point: Iterable[Number]) -> Nearest:
    """The nearest points of a curve."""


@overload
def nearest(thing: NurbsSurface, point: Iterable[Number]) -> NearestOnSurface:
    """The nearest points of a surface."""


def nearest(thing: Nurbs | NurbsSurface, point: Iterable[Number]) -> Nearest | NearestOnSurface:
    """Return all points of a curve, or of a surface in space, that are nearest to a point, exactly.

    >>> from exactspline import example
    >>> nearest(example("circle"), (0, 3)), nearest(example("torus"), (0, 0, 0)).distance
    ([<nearest point at 1: distance 2>], <Real 1>)

    Raises `ShapeError` for a point of another dimension.
    """
    point = tuple(as_items(point, "a point"))
    return SurfaceInspection(thing).nearest(point) if isinstance(thing, NurbsSurface) else of_curve(thing, point)


def check_question(question: str, *of: Of) -> None:
    """Check that a text is a question about one of these kinds of objects; raises `QuestionError` as `ask` does.

    >>> check_question("derivative:1,2@0,1/3", Of.SURFACE)
    """
    name = name_of(question)
    found = next((REGISTRY[kind][name] for kind in of if name in REGISTRY[kind]), None)
    if found is not None:
        read_as(found, question)
    elif name in REGISTRY[Of.TWO_CURVES] and {*of} & {*ALL_CURVES}:
        entry = REGISTRY[Of.TWO_CURVES][name]
        read_as(entry, question, _form_for_a_curve(entry))
    else:
        raise _not_asked(name, *of)


def facts_about(about: About) -> Remembers:
    """The analysis of an object, which answers the questions about it.

    >>> from exactspline import example
    >>> facts_about((example("circle"), example("ellipse")))
    <CurvePair of circle and ellipse>
    """
    if isinstance(about, Remembers):
        return about
    if not isinstance(about, tuple):
        return analyse(about)
    return (SurfacePair if isinstance(about[0], NurbsSurface) else CurvePair)(*about)


def kind_of(facts: Remembers) -> Of:
    """The kind of object of an analysis.

    >>> from exactspline import analyse, example
    >>> [str(kind_of(analyse(example(name)))) for name in ("circle", "twisted_cubic", "torus")]
    ['plane curve', 'space curve', 'surface in space']
    """
    if isinstance(facts, Analysis):
        return kind_of_curve(facts.curve)
    return KINDS[type(facts)]


def _form_for_a_curve(entry: Entry) -> str:
    """The form of a question about two curves when it is asked of one of them: the other curve comes before the
    arguments.

    >>> _form_for_a_curve(REGISTRY[Of.TWO_CURVES]["intersections_within"])
    'intersections_within:CURVE,1/1000000'
    """
    argument = entry.about.argument
    return f"{entry.name}:CURVE{',' * bool(argument)}{argument}"


def _of_two(curve: Nurbs, question: str) -> Asked:
    """A question about this curve and another curve, which comes before the arguments of the question."""
    entry = REGISTRY[Of.TWO_CURVES][name_of(question)]
    form = _form_for_a_curve(entry)
    given, _ = read_as(entry, question, form)
    other, *argument = given.rsplit(",", len(entry.about.argument.split(",")) if entry.about.argument else 0)
    if not other:
        raise QuestionError(f"{question!r} is incomplete", remedy=f"write it like {form!r}")
    return Asked(entry, CurvePair(curve, read(other).curve), ",".join(argument), "")


def _not_asked(name: str, *of: Of) -> QuestionError:
    """The error for a question that is not asked of such objects."""
    kinds = [kind for kind, entries in REGISTRY.items() if name in entries]
    if not kinds:
        return unknown(name, [each for entries in REGISTRY.values() for each in entries])
    how = " (--region even-odd, in Python Region(curves))" if Of.REGION in kinds else ""
    return QuestionError(f"{name} of {_either(of)}", remedy=f"it is asked of {_either(kinds)}{how}")


def _either(kinds: Sequence[Of]) -> str:
    """Kinds of objects as words."""
    of_all = set(ALL_CURVES) <= {*kinds}
    rest = [kind for kind in kinds if not (of_all and kind in ALL_CURVES)]
    return " or ".join(["a curve"] * of_all + [kind if kind in PAIRS else f"a {kind}" for kind in rest])


class Listed(NamedTuple):
    """A question with the kinds of objects that it is asked of: its name, its form as text, its meaning."""

    name: str
    form: str
    of: tuple[Of, ...]
    meaning: str


def questions() -> list[Listed]:
    """All questions; a question about two curves is also listed in the form in which it is asked of one of them.

    >>> [each.form for each in questions() if each.name == "distance"]
    ['distance', 'distance:CURVE']
    """
    entries = {id(entry): entry for of in REGISTRY.values() for entry in of.values()}
    found = [Listed(entry.name, entry.form, entry.about.of, entry.meaning) for entry in entries.values()]
    # a question that is also asked of a single curve takes other arguments there
    pairs = [entry for entry in REGISTRY[Of.TWO_CURVES].values() if entry.name not in QUESTIONS]
    return found + [Listed(entry.name, _form_for_a_curve(entry), CURVES, entry.meaning) for entry in pairs]
