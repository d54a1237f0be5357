"""Forms of data: what is written of an object for programs, and the JSON Schema of what is written, in one."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import Enum
from operator import attrgetter
from typing import Any, cast

from exactspline.display.data import Data, plain
from exactspline.numbers.exact import mpq, text

Schema = dict[str, object]
#: How a value is found in an object: the path of an attribute, or a function.
Source = str | Callable[..., object]


@dataclass(frozen=True)
class Form:
    """The form of a value: its ``schema``, and what is to ``write`` of a value, irrational numbers to this many digits.
    In an object a field of an ``optional`` form is left out where its value is None.
    """

    schema: Schema
    write: Callable[[Any, int], Any] = lambda value, digits: plain(value)
    optional: bool = False

    def of(self, source: Source) -> Form:
        """The form of an object that is written by a value found in it."""
        take = attrgetter(source) if isinstance(source, str) else source
        return replace(self, write=lambda of, digits: self.write(take(of), digits))


def _exactly(value: object, digits: int) -> str:
    return text(value) if isinstance(value, int | type(mpq())) else str(value)


TEXT = Form({"type": "string"}, _exactly)
FLAG = Form({"type": "boolean"})
INTEGER = Form({"type": "integer"})


def list_of(form: Form, least: int = 0, most: int | None = None) -> Form:
    """The form of a list.

    >>> list_of(TEXT).write((mpq(1, 2), 3), 20)
    ['1/2', '3']
    """
    schema: Schema = {"type": "array", "items": form.schema, "minItems": least}
    return Form(
        schema | ({} if most is None else {"maxItems": most}),
        lambda x, digits: [form.write(each, digits) for each in x],
    )


def pair_of(form: Form) -> Form:
    """The form of a list of two."""
    return list_of(form, 2, 2)


def or_null(form: Form) -> Form:
    """The form of what may be missing."""
    return Form(
        {"anyOf": [form.schema, {"type": "null"}]}, lambda x, digits: None if x is None else form.write(x, digits)
    )


def optional(form: Form) -> Form:
    """The form of a field that is left out where its value is missing."""
    return replace(form, write=or_null(form).write, optional=True)


def one_of(kinds: type[Enum]) -> Form:
    """The form of a member of an enumeration."""
    return Form({"enum": [kind.value for kind in kinds]})


def record(*parts: Form, **fields: Form | tuple[Form, Source]) -> Form:
    """The form of an object with the fields of other forms and with these. The value of a field is found in the object
    under its name, unless it comes with a source.

    >>> form = record(size=(INTEGER, "numerator"), denominator=TEXT)
    >>> form.write(mpq(1, 2), 20), form.schema["required"]
    ({'size': mpz(1), 'denominator': '2'}, ['size', 'denominator'])
    """
    found = {name: field if isinstance(field, tuple) else (field, name) for name, field in fields.items()}
    forms = {name: form.of(source) for name, (form, source) in found.items()}
    properties: Schema = {}
    required: list[str] = []
    for part in parts:
        properties |= cast(Schema, part.schema["properties"])
        required += cast("list[str]", part.schema["required"])
    properties |= {name: form.schema for name, form in forms.items()}
    required += [name for name, form in forms.items() if not form.optional]

    def write(of: Any, digits: int) -> Data:
        data: Data = {}
        for part in parts:
            data |= part.write(of, digits)
        for name, form in forms.items():
            value = form.write(of, digits)
            if value is not None or not form.optional:
                data[name] = value
        return data

    return Form(
        {"type": "object", "required": required, "additionalProperties": False, "properties": properties}, write
    )


INTERVAL = pair_of(TEXT)
#: A rectangle of parameters.
BOX = record(u=(INTERVAL, "first"), v=(INTERVAL, "second"))
