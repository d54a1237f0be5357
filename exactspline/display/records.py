"""An answer as data, as records (the kind of each thing, with its numbers and words by name), and as a table."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import NamedTuple, cast, overload

from exactspline.display.answer_forms import FORMS, form_of, placed
from exactspline.display.features import ends_text
from exactspline.display.forms import DIGITS, Form, double_of, real_text, word
from exactspline.display.sheet import Sheet
from exactspline.errors import ShapeError, as_integer
from exactspline.geometry.analysis.ask import About, Asked, asked_of
from exactspline.geometry.analysis.curves import QUESTIONS
from exactspline.geometry.curves.facts import Facts
from exactspline.hooks import Written
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval
from exactspline.questions.entry import Remembers, questions_of
from exactspline.reals.real import Real, real
from exactspline.roots.answers import Answer, CurvePiece

#: The types of exact numbers.
NUMBER = Real | type(mpq())


class _Record(NamedTuple):
    """One thing of an answer: its kind, and its numbers and words by name."""

    what: str
    values: Mapping[str, object]


def answer_data(asked: Asked, digits: int) -> object:
    """The answer to a question as data for programs."""
    return form_of(asked.entry).write(placed(asked.facts, asked.answer), digits)


def records(asked: Asked) -> list[_Record]:
    """The records of an answer, one for each thing in it.

    >>> from exactspline import example
    >>> [(each.what, dict(each.values)) for each in records(asked_of(example("circle"), "bounding_box"))]
    [('x', {'low': <Real -1>, 'high': <Real 1>}), ('y', {'low': <Real -1>, 'high': <Real 1>})]
    """
    return _records_of(form_of(asked.entry), placed(asked.facts, asked.answer), asked.entry.name)


def _records_of(form: Form, value: object, name: str) -> list[_Record]:
    what = name.removesuffix("_within")
    return [*_records(form, value, what if form.elements is None else what.removesuffix("s"))]


def _records(form: Form, value: object, what: str) -> Iterator[_Record]:
    if form.elements is None:
        values = dict(form.leaves(value))
        kind = str(values.pop("kind", values.pop("what", what)))
        # an absent thing has neither numbers nor a kind
        if values or kind != what:
            yield _Record(kind.replace("_", " "), {name or "value": x for name, x in values.items()})
        return
    for group, element, each in form.elements(value):
        own = what if group in ("", "points") else group.removesuffix("s")
        yield from _records(element if element.divided else replace(element, elements=None), each, own)


def answer_sheet(title: str, found: list[_Record], digits: int) -> Sheet:
    """An answer as a table: one row for each number, with its exact value if that is short and with the nearest double,
    and one row for the words.
    """
    made = Sheet("what", "name", "value", "double", title=title, name=title, prose=["value"])
    for each in found:
        words = list[str]()
        for name, value in each.values.items():
            if isinstance(value, NUMBER):
                double = double_of(real(value))
                shown = "–" if double is None else repr(double)
                made.add_row(each.what, name.replace("_", " "), real_text(value, digits), shown)
            else:
                words.append(f"{name.replace('_', ' ')} {_outwards(value)}")
        if words or not each.values:
            made.add_row(each.what, "", "; ".join(words).removeprefix("value "), "")
    if not found:
        made.add_row("nothing", "", "there is none", "")
    return made


def _outwards(value: object) -> str:
    """A word as text. An interval is rounded outwards, since the JSON has its exact ends."""
    if not isinstance(value, Interval | CurvePiece):
        return word(value)
    parts = value.parts if isinstance(value, CurvePiece) else [value]
    return " ∪ ".join(f"[{', '.join(ends_text(part))}]" for part in parts)


@overload
def to_dict(about: About, question: str, digits: int = 20) -> dict[str, object]:
    """The answer to a question (see `ask`) about an object, as data."""


@overload
def to_dict(about: Written, *, digits: int = 20) -> dict[str, object]:
    """An answer."""


def to_dict(about: About | Written, question: str = "", digits: int = 20) -> dict[str, object]:
    """Return the answer to a question (see `ask`) as data for ``json.dumps``, with this many digits of irrational
    numbers. ``answer.to_dict()`` returns the same.

    >>> from exactspline import example
    >>> to_dict(example("torus"), "umbilics")
    {'question': 'umbilics', 'answer': {'points': [], 'everywhere': [], 'undecided': []}}
    """
    digits = as_integer(digits, "a number of digits", 1)
    if isinstance(about, Written) and not question:
        form, value, _ = _form_of_answer(about)
        data: dict[str, object] = form.write(value, digits)
        return data
    return {"question": question, "answer": answer_data(asked_of(cast(About, about), question), digits)}


@overload
def to_records(about: About, question: str) -> list[dict[str, object]]:
    """The answer to a question about an object."""


@overload
def to_records(about: Written) -> list[dict[str, object]]:
    """An answer."""


def to_records(about: About | Written, question: str = "") -> list[dict[str, object]]:
    """Return the answer to a question (see `ask`) as a list of records for ``pandas.DataFrame`` and
    ``polars.DataFrame``, with correctly rounded doubles as numbers. ``answer.to_records()`` returns the same.

    >>> from exactspline import example
    >>> to_records(example("cubic_s"), "inflections")[0]["parameter"]
    0.5
    """
    if isinstance(about, Written) and not question:
        found = _records_of(*_form_of_answer(about))
    else:
        found = records(asked_of(cast(About, about), question))
    return [{"what": each.what} | {name: _plain(x) for name, x in each.values.items()} for each in found]


def answer_table(answer: Written) -> Sheet:
    """An answer as a table.

    >>> from exactspline import example
    >>> answer_table(example("cubic_s").inflections).rows[0]
    ('inflection', 'parameter', '1/2', '0.5')
    """
    form, value, name = _form_of_answer(answer)
    return answer_sheet(name.replace("_", " "), _records_of(form, value, name), DIGITS)


def _form_of_answer(answer: Written) -> tuple[Form, object, str]:
    """The form of an answer, the value that is written, and its name."""
    if isinstance(answer, Answer) and answer.asked is not None:
        name, again = answer.asked
        facts = cast(Remembers, again())  # an answer that knows its question
        entry = (QUESTIONS if isinstance(facts, Facts) else questions_of(type(facts)))[name]
        return form_of(entry), placed(facts, answer), name
    for kind in type(answer).__mro__:
        if kind in FORMS:
            return FORMS[kind], answer, kind.__name__.lower()
    raise ShapeError(f"an answer of unknown origin ({type(answer).__name__})", remedy="take it from exactspline.ask")


def _plain(value: object) -> object:
    """A number as a double, a word as text."""
    if isinstance(value, NUMBER):
        return double_of(real(value))
    return value if isinstance(value, bool | int) else str(value)
