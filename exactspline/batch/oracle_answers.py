"""Answers of the oracle as data."""

from __future__ import annotations

from dataclasses import dataclass

from exactspline.display.pair_data import form_data
from exactspline.errors import ExactSplineError, counted
from exactspline.numbers.exact import text
from exactspline.questions.answers import NamedNumbers
from exactspline.reals.real import Real

#: Digits after the point of an interval.
DIGITS = 30


@dataclass(frozen=True)
class Answer:
    """The answer to a question: items in order, and the certificates of the zero sets on which it relies."""

    question: str
    items: tuple[NamedNumbers, ...]
    certificates: tuple[dict[str, object], ...] = ()

    def __repr__(self) -> str:
        return f"<Answer to {self.question}: {counted(len(self.items), 'item')}>"


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
