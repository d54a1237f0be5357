"""Forms of data. A form contains the way in which an object is written for programs, the JSON Schema of this text, and
the numbers and words, with their names, for tables and data frames.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from enum import Enum
from operator import attrgetter
from typing import Any, cast

from exactspline.display.numbers import decimal
from exactspline.errors import ExactSplineError, OpenError, ReachError
from exactspline.numbers.exact import mpq, text
from exactspline.reals.real import Real, real
from exactspline.splines.knots import KnotVector

# ---- data


Data = dict[str, object]


def plain(value: object) -> object:
    """A value of JSON.

    >>> plain((mpq(1, 2), [None, True], "x"))
    ['1/2', [None, True], 'x']
    """
    if isinstance(value, Enum):
        return value.value
    if isinstance(value, type(mpq())):
        return text(value)
    return [plain(each) for each in value] if isinstance(value, (tuple, list, KnotVector)) else value


def picked(of: object, *names: str) -> Data:
    """Some attributes of an object by name; ``a.b`` is given as ``b``.

    >>> picked(mpq(1, 2), "numerator", "denominator")["denominator"]
    mpz(2)
    """
    return {name.rpartition(".")[2]: plain(attrgetter(name)(of)) for name in names}


Schema = dict[str, object]
#: The way in which a value is found in an object: the path of an attribute, or a function.
Source = str | Callable[..., object]
#: A number or a word with its name.
Leaf = tuple[str, object]


@dataclass(frozen=True)
class Form:
    """The form of a value: its ``schema``, and the function ``write``, which takes the value and the number of digits
    of irrational numbers. A field of an ``optional`` form is omitted from an object if its value is None.

    ``leaves`` yields the numbers and words of a value with their names; by default the value itself without a name.
    ``elements`` yields the elements of a list, or of an object of lists (`lists`): the name of the list, the form of
    its elements, and the element. With ``divided``, an object of lists is divided into its elements even if it is an
    element itself.
    """

    schema: Schema
    write: Callable[[Any, int], Any] = lambda value, digits: plain(value)
    optional: bool = False
    leaves: Callable[[Any], Iterable[Leaf]] = lambda value: () if value is None else (("", value),)
    elements: Callable[[Any], Iterable[tuple[str, Form, Any]]] | None = None
    divided: bool = False

    def of(self, source: Source) -> Form:
        """The form of an object of which only one value is written: `source` finds the value in the object."""
        take = attrgetter(source) if isinstance(source, str) else source
        elements = self.elements
        return replace(
            self,
            write=lambda of, digits: self.write(take(of), digits),
            leaves=lambda of: self.leaves(take(of)),
            elements=elements and (lambda of: elements(take(of))),
        )


def _exactly(value: object, digits: int) -> str:
    return text(value) if isinstance(value, int | type(mpq())) else str(value)


def word(value: object) -> str:
    """A value other than a number, as text.

    >>> word(True), word((1, 2))
    ('yes', '(1, 2)')
    """
    return ("yes" if value else "no") if isinstance(value, bool) else str(value)


TEXT = Form({"type": "string"}, _exactly)
FLAG = Form({"type": "boolean"})
INTEGER = Form({"type": "integer"})


def list_of(form: Form, least: int = 0, most: int | None = None) -> Form:
    """The form of a list.

    >>> list_of(TEXT).write((mpq(1, 2), 3), 20)
    ['1/2', '3']
    """
    schema: Schema = {"type": "array", "items": form.schema, "minItems": least}

    def leaves(x: Iterable[Any]) -> Iterator[Leaf]:
        each = [[*form.leaves(one)] for one in x]
        if any(name or isinstance(value, Real | type(mpq())) for one in each for name, value in one):
            for i, one in enumerate(each, 1):
                yield from ((f"{i} {name}".strip() if len(each) > 1 else name, value) for name, value in one)
        elif each:
            yield "", f"({', '.join(word(value) for one in each for _, value in one)})"

    return Form(
        schema | ({} if most is None else {"maxItems": most}),
        lambda x, digits: [form.write(each, digits) for each in x],
        leaves=leaves,
        elements=lambda x: (("", form, each) for each in x),
    )


def pair_of(form: Form) -> Form:
    """The form of a list of two."""
    return list_of(form, 2, 2)


def or_null(form: Form) -> Form:
    """The form of a value that may be None."""
    return replace(
        form,
        schema={"anyOf": [form.schema, {"type": "null"}]},
        write=lambda x, digits: None if x is None else form.write(x, digits),
        leaves=lambda x: () if x is None else form.leaves(x),
        elements=None,
    )


def optional(form: Form) -> Form:
    """The form of a field that is omitted if its value is None."""
    return replace(or_null(form), schema=form.schema, optional=True)


def one_of(kinds: type[Enum]) -> Form:
    """The form of a member of an enumeration."""
    return Form({"enum": [kind.value for kind in kinds]})


def record(*parts: Form, **fields: Form | tuple[Form, Source]) -> Form:
    """The form of an object with the fields of other forms and with the given fields. The value of a field is the
    attribute of its name, unless a source is given.

    >>> form = record(size=(INTEGER, "numerator"), denominator=TEXT)
    >>> form.write(mpq(1, 2), 20), form.schema["required"]
    ({'size': mpz(1), 'denominator': '2'}, ['size', 'denominator'])
    >>> dict(form.leaves(mpq(1, 2)))
    {'size': mpz(1), 'denominator': mpz(2)}
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

    def leaves(of: Any) -> Iterator[Leaf]:
        for part in parts:
            yield from part.leaves(of)
        for name, form in forms.items():
            # the names 1 and 2 of the parts of a pair need the name of the pair, cosine and sine do not
            yield from (
                (inner if inner[:1].isalpha() else f"{name} {inner}".strip(), x) for inner, x in form.leaves(of)
            )

    return Form(
        {"type": "object", "required": required, "additionalProperties": False, "properties": properties},
        write,
        leaves=leaves,
    )


def lists(**fields: Form | tuple[Form, Source]) -> Form:
    """The form of an object with lists, and with further fields about them.

    >>> form = lists(factors=(list_of(TEXT), lambda n: [2, 3]), value=(INTEGER, lambda n: n))
    >>> [(name, each) for name, _, each in form.elements(6)]
    [('', 6), ('factors', 2), ('factors', 3)]
    """
    found = {name: field if isinstance(field, tuple) else (field, name) for name, field in fields.items()}
    forms = {name: form.of(source) for name, (form, source) in found.items()}
    beside = record(**{name: fields[name] for name, form in forms.items() if form.elements is None})

    def elements(of: Any) -> Iterator[tuple[str, Form, Any]]:
        if beside.schema["properties"]:
            yield "", beside, of
        for name, form in forms.items():
            for _, element, each in form.elements(of) if form.elements else ():
                yield name, element, each

    return replace(record(**fields), elements=elements, divided=True)


INTERVAL = Form(pair_of(TEXT).schema, pair_of(TEXT).write)
#: A rectangle of parameters.
BOX = record(u=(INTERVAL, "first"), v=(INTERVAL, "second"))


# ---- real numbers


#: Characters of an exact number that a table shows.
READABLE = 14
#: Digits of a number in a table.
DIGITS = 12


def real_data(x: Real | mpq, digits: int) -> Data:
    """A number: its closed form, two rational bounds, and the correctly rounded double. The closed form is given for a
    rational number, for ``a + b√c``, and for known multiples of π and angles; it is null if the number is proved to be
    neither rational nor ``a + b√c``, with ``open`` if that is not decided. The double is null for a number that is too
    large, or whose enclosures do not determine it.

    >>> real_data(mpq(1, 3), 20)
    {'exact': '1/3', 'low': '1/3', 'high': '1/3', 'double': 0.3333333333333333}
    """
    number = real(x)
    # the closed form first: a number that turns out to be rational has equal bounds
    form, (low, high) = closed_form_data(number), number.around(digits + 1)
    return {**form, "low": text(low), "high": text(high), "double": double_of(number)}


def double_of(x: Real) -> float | None:
    """The correctly rounded double; None for a number that is too large, or whose enclosures do not determine it.

    >>> double_of(Real("1/3")), double_of(Real(10) ** 400)
    (0.3333333333333333, None)
    """
    try:
        return x.double()
    except (ExactSplineError, OverflowError):
        return None


def closed_form_data(x: Real) -> Data:
    """The closed form of a number, null if it is proved to have none; with ``open`` if that is not decided.

    >>> from exactspline.reals.real import square_root
    >>> closed_form_data(square_root(8)), closed_form_data(square_root(2) + square_root(3))
    ({'exact': '2√2'}, {'exact': None})
    """
    try:
        return {"exact": x.closed_form}
    except (ReachError, OpenError):
        return {"exact": None, "open": True}


#: A real number.
REAL = Form(
    record(
        exact=or_null(TEXT), open=optional(FLAG), low=TEXT, high=TEXT, double=or_null(Form({"type": "number"}))
    ).schema,
    real_data,
)


def real_text(x: Real | mpq, digits: int = DIGITS) -> str:
    """A number in a table: in closed form if that is short, otherwise to this many significant digits.

    >>> from exactspline.reals.real import square_root
    >>> real_text(mpq(1, 3)), real_text(square_root(2) + square_root(3), 5)
    ('1/3', '3.1463')
    """
    number = real(x)
    exact = closed_form_data(number)["exact"]
    if isinstance(exact, str) and len(exact) <= max(READABLE, digits + 2):
        return exact
    value = number.rational_near(digits + 8)
    return decimal(value, digits) if value else "0"
