"""Questions to the oracle and their answers; answers as data."""

from __future__ import annotations

from collections.abc import Container, Mapping
from dataclasses import dataclass, field

from exactspline.display.pair_data import form_data
from exactspline.errors import ExactSplineError, as_text, counted, nearest
from exactspline.geometry.analysis.curves import QUESTIONS, analyse
from exactspline.numbers.exact import mpq, rational, text
from exactspline.questions.entry import Answered
from exactspline.reals.real import Real
from exactspline.roots.answers import Places
from exactspline.roots.values import exact_place
from exactspline.splines.nurbs import Nurbs

#: Digits after the point of an interval.
DIGITS = 30


class QuestionError(ExactSplineError):
    """A question that cannot be read, or that has no answer for a curve."""


def parts_of(asked: str, forms: Mapping[str, str], optional: Container[str] = ()) -> tuple[str, str, str]:
    """The name, the argument and the place of a question, whose `forms` are given by its names, as
    ``derivative:K@T``. The argument of the `optional` ones may be left out.

    >>> parts_of("derivative:2@0,1/3", {"derivative": "derivative:K@T"})
    ('derivative', '2', '0,1/3')

    Raises `QuestionError` for another name, with the nearest, and with the form of the question for what it does not
    take and for what it lacks.
    """
    asked = as_text(asked, "a question").strip()
    name = asked.partition("@")[0].partition(":")[0]
    if name not in forms:
        remedy = nearest(name, forms, listed_by="list questions")
        raise QuestionError(f"there is no question called {name!r}", remedy=remedy)
    form, rest = forms[name], asked.removeprefix(name)
    argument, _, place = rest.partition("@") if "@" in form else (rest, "", "")
    given = argument.startswith(":") and argument != ":"
    fits = given if argument else name in optional or ":" not in form
    if not fits or given > (":" in form) or bool(place) != ("@" in form):
        raise QuestionError(f"the question {asked!r}", remedy=f"write it like {form!r}")
    return name, argument[1:], place


@dataclass(frozen=True)
class Item:
    """One result: what it is, its numbers by name, and further facts."""

    what: str
    values: Mapping[str, Real]
    facts: Mapping[str, object] = field(default_factory=dict)


@dataclass(frozen=True)
class Answer:
    """The answer to a question: items in order, and the certificates of the zero sets on which it relies."""

    question: str
    items: tuple[Item, ...]
    certificates: tuple[dict[str, object], ...] = ()

    def __repr__(self) -> str:
        return f"<Answer to {self.question}: {counted(len(self.items), 'item')}>"


@dataclass(frozen=True)
class Question:
    """A question as it was read: its name, its argument (empty where there is none), its parameters."""

    text: str
    name: str
    argument: str
    places: tuple[str, ...]

    def number(self, otherwise: int | None = None) -> int:
        """The argument as a small integer."""
        if self.argument.isascii() and self.argument.isdecimal() and len(self.argument) < 4:
            return int(self.argument)
        if otherwise is not None and not self.argument:
            return otherwise
        raise QuestionError(f"{self.text!r} needs an integer up to 999 after the colon", remedy=f"{self.name}:2")

    def parameters(self, curve: Nurbs) -> list[mpq | Real]:
        """The parameters: exact numbers, or those of features of the curve, given by their name."""
        if not all(self.places or [""]):
            raise QuestionError(
                f"{self.text!r} names no parameter", remedy=f"{self.name}@1/2, or {self.name}@inflections"
            )
        return [t for place in self.places for t in _parameters(curve, place)]

    def single(self, curve: Nurbs) -> mpq:
        """The only parameter, a rational one."""
        parameters = self.parameters(curve)
        if len(parameters) != 1 or isinstance(parameters[0], Real):
            raise QuestionError(f"{self.text!r} needs one rational parameter", remedy=f"{self.name}@1/2")
        return parameters[0]


def _parameters(curve: Nurbs, place: str) -> list[mpq | Real]:
    """An exact number, or the parameters of features with a given name."""
    facts = analyse(curve)
    if place == "knots":
        return list(facts.breaks)
    entry = QUESTIONS.get(place)
    if entry is not None and entry.about.answered == Answered.PLACES and not entry.about.argument:
        places = entry.answer(facts)
        assert isinstance(places, Places)  # by the type of its answer
        if places.everywhere:
            raise QuestionError(
                f"{place} fill all of {places.everywhere[0]}", remedy="name parameters there, as in value@1/2"
            )
        return [exact_place(feature.root) for feature in places]
    return [rational(place)]


def answer_data(answer: Answer, digits: int = DIGITS) -> dict[str, object]:
    """An answer as data (see ``exactspline schema oracle``)."""
    return {
        "question": answer.question,
        "items": [
            {
                "what": item.what,
                "values": {name: number_data(value, digits) for name, value in item.values.items()},
                "facts": dict(item.facts),
            }
            for item in answer.items
        ],
        "certificates": list(answer.certificates),
    }


def number_data(value: Real, digits: int = DIGITS) -> dict[str, object]:
    """A number: exactly if it is rational or of the form ``a + b√c`` (null if it is neither; ``open`` if that is not
    decided), in a certified interval, and as the correctly rounded double (null where it is too large, or where its
    ball does not determine it).

    >>> number_data(Real("1/3"))
    {'exact': '1/3', 'low': '1/3', 'high': '1/3', 'double': 0.3333333333333333}
    """
    form, (low, high) = form_data(value), value.around(digits)
    try:
        rounded: float | None = value.double()
    except (ExactSplineError, OverflowError):
        rounded = None
    return {**form, "low": text(low), "high": text(high), "double": rounded}
