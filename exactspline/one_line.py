"""How a value is written in one line: short, and without the names of its fields."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from decimal import Context, Decimal
from functools import wraps
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from gmpy2 import mpq

#: Characters of a line, and of an exact number (a longer one is shown as a decimal); things of a list that are shown.
LONGEST, LONGEST_NUMBER, FEW = 120, 40, 4


def _shortened(text: str) -> str:
    """A text in one line; of a long one the beginning, with an ellipsis and the bracket at its end.

    >>> len(_shortened(f"<{'very ' * 50}long>")), _shortened(f"<{'very ' * 50}long>")[-6:]
    (120, 'y ve…>')
    """
    line = " ".join(text.split("\n"))
    end = line[-1] if line.endswith((">", ")")) else ""
    return line if len(line) <= LONGEST else f"{line[: LONGEST - 1 - len(end)].rstrip()}…{end}"


def one_line(written: Callable[..., str]) -> Callable[..., str]:
    """What writes a value, kept to one line."""
    return wraps(written)(lambda value: _shortened(written(value)))


def short_text(value: mpq) -> str:
    """The exact text of a number or, if it is long, a decimal with an ellipsis.

    >>> from gmpy2 import mpq
    >>> short_text(mpq(3, 4)), short_text(mpq(10) ** 50 / 3)
    ('3/4', '3.3333333e+49…')
    """
    whole, top, bottom = str(value), Decimal(int(value.numerator)), Decimal(int(value.denominator))
    return whole if len(whole) <= LONGEST_NUMBER else f"{Context(8).divide(top, bottom).normalize():.8g}…"


class OneLine:
    """A value that `repr` shows in one line: by its own text, where its class writes one, otherwise by the values of
    its fields; of what is true or false the name, where it is true.

    >>> from exactspline import example, analyse
    >>> analyse(example("circle")).shapes
    (<RecognizedPiece [0, 4], circle: centre (0, 0), radius 1, 0, whole>,)
    """

    __slots__ = ()

    @one_line
    def __repr__(self) -> str:
        name, own = type(self).__name__, type(self).__str__ is not object.__str__
        text = str(self) if own else fields_of(self)
        return f"<{text}>" if text.startswith(name.lower()) else f"<{name}{' ' * bool(text)}{text}>"


def fields_of(value: object) -> str:
    """The values of the fields of a data class, with commas between them."""
    fields = {x.name: getattr(value, x.name) for x in getattr(value, "__dataclass_fields__", {}).values() if x.repr}
    return ", ".join(filter(None, map(_field, fields, fields.values())))


def _field(name: str, value: Any) -> str:
    """What is said of a field; empty for nothing."""
    if isinstance(value, bool):
        return name.replace("_", " ") * value
    if value is None or (callable(value) and not isinstance(value, Sequence)):
        return ""
    if isinstance(value, (list, dict)) or type(value) is tuple:
        parts = [_field("", each) for each in [*value][:FEW]] + ["…"] * (len(value) > FEW)
        return f"({', '.join(parts)})" if value else ""
    return short_text(value) if type(value).__name__ == "mpq" else str(value)
