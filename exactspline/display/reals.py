"""A real number as data for programs, and as text in a table: one form for all that is written of it."""

from __future__ import annotations

from exactspline.display.data import Data
from exactspline.display.forms import FLAG, TEXT, Form, optional, or_null, record
from exactspline.display.numbers import decimal
from exactspline.errors import ExactSplineError, OpenError, ReachError
from exactspline.numbers.exact import mpq, text
from exactspline.reals.real import Real, real

#: Characters of an exact number that a table shows.
READABLE = 14
#: Digits of a number in a table.
DIGITS = 12


def real_data(x: Real | mpq, digits: int) -> Data:
    """A number: exactly if it is rational or of the form ``a + b√c``, or known with π and angles (null if it is proved
    to be neither rational nor of that form; with ``open`` if that is not decided), between two rational bounds, and as
    the correctly rounded double (null where it is too large, or where its enclosures do not determine it).

    >>> real_data(mpq(1, 3), 20)
    {'exact': '1/3', 'low': '1/3', 'high': '1/3', 'double': 0.3333333333333333}
    """
    number = real(x)
    # the closed form first: what turns out to be rational has equal bounds
    form, (low, high) = closed_form_data(number), number.around(digits + 1)
    return {**form, "low": text(low), "high": text(high), "double": double_of(number)}


def double_of(x: Real) -> float | None:
    """The correctly rounded double; None where it is too large, or where the enclosures do not determine it.

    >>> double_of(Real("1/3")), double_of(Real(10) ** 400)
    (0.3333333333333333, None)
    """
    try:
        return x.double()
    except (ExactSplineError, OverflowError):
        return None


def closed_form_data(x: Real) -> Data:
    """The closed form of a number, null if it is proved to have none; ``open`` where that is not decided.

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
    """A number in a table: in closed form where that is short, otherwise to this many significant digits.

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
