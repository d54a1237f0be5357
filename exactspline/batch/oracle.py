"""The exact oracle: questions about a curve, answered exactly, in certified intervals and as correctly rounded doubles.

A question is text: a name, an argument after a colon, parameters after an @. ``value@1/2``, ``derivative:2@0,1/3``,
``value@cusps``, ``elevate:2``, ``cusps``.
"""

from __future__ import annotations

from exactspline.batch.oracle_answers import Answer, Question, QuestionError
from exactspline.batch.oracle_questions import QUESTIONS
from exactspline.errors import as_text, nearest
from exactspline.splines.expected import curve_of
from exactspline.splines.nurbs import Nurbs


def question_of(asked: str) -> Question:
    """The question that a text describes; raises `QuestionError` with the nearest names.

    >>> question_of("derivative:2@0,1/3")
    Question(text='derivative:2@0,1/3', name='derivative', argument='2', places=('0', '1/3'))
    """
    head, at, tail = as_text(asked, "a question").strip().partition("@")
    name, _, argument = head.partition(":")
    if name not in QUESTIONS:
        remedy = nearest(name, QUESTIONS, listed_by="list questions")
        raise QuestionError(f"there is no question called {name!r}", remedy=remedy)
    return Question(asked.strip(), name, argument, tuple(tail.split(",")) if at else ())


def oracle(curve: Nurbs, asked: str) -> Answer:
    """The answer to a question about a curve.

    >>> from exactspline import example
    >>> [item] = oracle(example("cusp"), "cusps").items
    >>> item.what, item.values["parameter"].exact, item.values["parameter"].double()
    ('cusp', mpq(1,2), 0.5)
    >>> oracle(example("circle"), "length").items[0].values["length"].double("up")
    6.283185307179587

    Raises `QuestionError` for an unknown question, and another `ExactSplineError` where the question has no answer for
    the curve.
    """
    question = question_of(asked)
    items, certificates = QUESTIONS[question.name].answer(curve_of(curve), question)
    return Answer(question.text, tuple(items), tuple(certificates))
