"""Words and numbers of a text file, read one at a time."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from typing import TypeAlias

from exactspline.errors import CurveFileError, ShapeError, counted
from exactspline.interchange.limits import LARGER, Limits
from exactspline.interchange.numbers import decimal, whole
from exactspline.numbers.exact import mpq

#: A word, or what is in a pair of brackets.
Nested: TypeAlias = "str | list[Nested]"
_WORD = re.compile(r"\S+")


def nested(tokens: Iterable[str], brackets: str, limits: Limits, extra: Callable[[], object]) -> list[Nested]:
    """Words in brackets as lists of lists; `extra` is called for a bracket that closes nothing.

    >>> nested(["a", "(", "b", ")"], "()", Limits(), list)
    ['a', ['b']]
    """
    opened: list[list[Nested]] = [[]]
    for token in tokens:
        if token not in (brackets[0], brackets[1]):
            opened[-1].append(token)
        elif token == brackets[1]:
            opened.pop() if len(opened) > 1 else extra()
        elif len(opened) > limits.depth:
            raise CurveFileError("brackets are nested too deeply", remedy=LARGER)
        else:
            inner: list[Nested] = []
            opened[-1].append(inner)
            opened.append(inner)
    if len(opened) > 1:
        raise CurveFileError(f"{counted(len(opened) - 1, 'bracket')} not closed", remedy="balance the brackets")
    return opened[0]


class Tokens:
    """The words of a text from a position on, read lazily.

    >>> words = Tokens("2 0.5 x", Limits())
    >>> words.whole(), words.number(), words.word(), words.ended
    (2, mpq(1,2), 'x', True)
    """

    def __init__(self, text: str, limits: Limits, position: int = 0) -> None:
        self.text, self.limits = text, limits
        self._counted = (0, 1)
        self.move(position)

    def move(self, position: int) -> None:
        """Continue reading at a later position."""
        self._matches: Iterator[re.Match[str]] = _WORD.finditer(self.text, position)
        self._next = next(self._matches, None)
        self.position = position

    @property
    def ended(self) -> bool:
        """Whether all words have been read."""
        return self._next is None

    @property
    def line(self) -> int:
        """The line of the last word read."""
        start, line = self._counted
        self._counted = (self.position, line + self.text.count("\n", start, self.position))
        return self._counted[1]

    def word(self) -> str:
        """The next word; raises `CurveFileError` at the end."""
        if self._next is None:
            raise CurveFileError("the file ends too early", where=f"line {self.line}", remedy="complete the file")
        self.position = self._next.start()
        word = self._next[0]
        self._next = next(self._matches, None)
        return word

    def number(self) -> mpq:
        """The next word as an exact decimal."""
        return decimal(self.word(), self.limits)

    def numbers(self, count: int) -> list[mpq]:
        """The next `count` words as decimals."""
        return [self.number() for _ in range(self._checked(count))]

    def rows(self, count: int, length: int) -> list[list[mpq]]:
        """The next `count` rows of `length` decimals."""
        self._checked(count * length)
        return [self.numbers(length) for _ in range(count)]

    def whole(self) -> int:
        """The next word as a small integer."""
        return whole(self.word())

    def count(self) -> int:
        """The next word as a count."""
        return self._checked(self.whole())

    def _checked(self, count: int) -> int:
        if not 0 <= count <= self.limits.objects:
            remedy = f"it must be between 0 and {self.limits.objects}"
            raise ShapeError(f"a count of {count}", where=f"line {self.line}", remedy=remedy)
        return count
