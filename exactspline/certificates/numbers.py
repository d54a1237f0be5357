"""The data of certificates: numbers and words, lists and objects, read without the rest of the library; and the error
for invalid data, with the flaw and its place.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from itertools import product
from math import prod
from typing import Any, TypeVar

Found = TypeVar("Found")
Part = TypeVar("Part")


class CertificateError(ValueError):
    """The error for an invalid certificate: the `flaw`, and its place `where`, as fields and indices from the outside
    in.

    >>> print(CertificateError("a leaf that is empty", ("segments", 2, "leaves")))
    segments[2].leaves: a leaf that is empty
    """

    def __init__(self, flaw: str, where: tuple[str | int, ...] = ()) -> None:
        self.flaw, self.where = flaw, where
        place = "".join(f"[{x}]" if isinstance(x, int) else f".{x}" for x in where).removeprefix(".")
        super().__init__(f"{place}: {flaw}" if place else flaw)


def require(condition: bool, flaw: str) -> None:
    """Raise `CertificateError` with the flaw unless a condition holds."""
    if not condition:
        raise CertificateError(flaw)


def require_each_once(given: Sequence[tuple[int, ...]], lists: Sequence[Sequence[object]], flaw: str) -> None:
    """Raise `CertificateError` with the flaw unless the pairs are all pairs of indices of two lists, each once.

    >>> require_each_once([(0, 1), (0, 0)], ["a", "bc"], "not every pair once")
    """
    require(len(given) == prod(map(len, lists)) and set(given) == set(product(*(range(len(x)) for x in lists))), flaw)


def within(place: str | int, check: Callable[..., Found], *given: object) -> Found:
    """The result for a part of a certificate; flaws name the place of this part.

    >>> within("degree", count, 2)
    2
    """
    try:
        return check(*given)
    except CertificateError as error:
        raise CertificateError(error.flaw, (place, *error.where)) from error


def each(name: str, check: Callable[[Part], Found], given: Iterable[Part]) -> list[Found]:
    """The results for the parts of a list with this name.

    >>> each("points", fraction, ["0", "2/4"])
    [Fraction(0, 1), Fraction(1, 2)]
    """
    return [within(name, within, i, check, part) for i, part in enumerate(given)]


def read(given: object, form: object) -> Any:
    """Data in this form, with numbers as numbers. Raises `CertificateError` for data in another form.

    A form is a function that reads one thing, `[form]` for any number of them, a tuple for one of each, or a dictionary
    for an object with these fields; fields of other names are not read.

    >>> read({"at": "1/2", "signs": [-1, 1]}, {"at": fraction, "signs": (count, count)})
    {'at': Fraction(1, 2), 'signs': (-1, 1)}
    """
    if isinstance(form, dict):
        fields: Any = given
        require(isinstance(given, Mapping), "not an object")
        missing = [name for name in form if name not in fields]
        require(not missing, f"{', '.join(missing)} is missing")
        return {name: within(name, read, fields[name], own) for name, own in form.items()}
    if callable(form):
        return form(given)
    if not isinstance(given, (list, tuple)):
        raise CertificateError("not a list")
    forms: Any = form * len(given) if isinstance(form, list) else form
    require(len(given) == len(forms), f"a list of {len(given)}, where {len(forms)} are expected")
    return type(forms)(within(i, read, *pair) for i, pair in enumerate(zip(given, forms, strict=True)))


def one_of(name: str, forms: Mapping[str, Mapping[str, object]]) -> Callable[[object], object]:
    """A form that depends on the word in a field.

    >>> read({"by": "point", "at": "1"}, one_of("by", {"point": {"at": fraction}}))
    {'by': 'point', 'at': Fraction(1, 1)}
    """

    def chosen(given: object) -> object:
        word = read(given, {name: text})[name]
        require(word in forms, f"unknown {name}, none of {', '.join(forms)}")
        return {name: word, **read(given, forms[word])}

    return chosen


def optional(form: object) -> Callable[[object], object]:
    """A form of a value that may also be None.

    >>> read([None, 1], [optional(count)])
    [None, 1]
    """
    return lambda given: None if given is None else read(given, form)


def _of_type(given: object, kind: type[Found], flaw: str) -> Found:
    """What is given, of exactly this type."""
    if not isinstance(given, kind) or type(given) is not kind:
        raise CertificateError(flaw)
    return given


def count(given: object) -> int:
    """A count, given as an integer."""
    return _of_type(given, int, "not an integer, where one is counted")


def truth(given: object) -> bool:
    """True or false."""
    return _of_type(given, bool, "neither true nor false")


def text(given: object) -> str:
    """A text."""
    return _of_type(given, str, "not a text")


def integer(given: object) -> int:
    """An integer written in decimal digits.

    >>> integer("-12")
    -12
    """
    written = _number(given)
    digits = written.removeprefix("-")
    require(digits.isascii() and digits.isdigit(), "a text that is not an integer")
    return -_value(digits) if written != digits else _value(digits)


def _number(given: object) -> str:
    return _of_type(given, str, "a number that is not written as text")


def _value(digits: str) -> int:
    """The value of digits, converted in parts: Python does not convert thousands of digits in one step."""
    if len(digits) <= 600:
        return int(digits)
    half = len(digits) // 2
    return int(_value(digits[:-half]) * 10**half + _value(digits[-half:]))


def fraction(given: object) -> Fraction:
    """A fraction or an integer written in decimal digits.

    >>> fraction("2/6")
    Fraction(1, 3)
    """
    above, line, below = _number(given).partition("/")
    denominator = integer(below) if line else 1
    require(denominator > 0, "a denominator that is not positive")
    return Fraction(integer(above), denominator)
