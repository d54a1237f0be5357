"""Answers of the oracle as data."""

from __future__ import annotations

from dataclasses import dataclass

from exactspline.display.reals import real_data
from exactspline.errors import counted
from exactspline.one_line import one_line
from exactspline.questions.answers import NamedNumbers

#: Digits after the point of an interval.
DIGITS = 30


@dataclass(frozen=True)
class Answer:
    """The answer to a question: items in order, and the certificates of the zero sets on which it relies."""

    question: str
    items: tuple[NamedNumbers, ...]
    certificates: tuple[dict[str, object], ...] = ()

    @one_line
    def __repr__(self) -> str:
        return f"<Answer to {self.question}: {counted(len(self.items), 'item')}>"


def answer_data(answer: Answer, digits: int = DIGITS) -> dict[str, object]:
    """An answer as data (see ``exactspline schema oracle``)."""
    return {
        "question": answer.question,
        "items": [
            {
                "what": item.what,
                "values": {name: real_data(value, digits) for name, value in item.values.items()},
                "facts": dict(item.facts),
            }
            for item in answer.items
        ],
        "certificates": list(answer.certificates),
    }
