"""A simple zero that is certain in doubles, computed exactly when it is asked for."""

from __future__ import annotations

from typing import Protocol

from flint import fmpz_poly

from exactspline.numbers.exact import mpq
from exactspline.numbers.once import cached_property
from exactspline.polynomials.isolation import LocalPolynomial, LocalZero


class LazyForm(Protocol):
    """A form on a segment, computed when it is asked for."""

    @property
    def form(self) -> LocalPolynomial:
        """The form, which is not zero at the ends."""

    @property
    def inner(self) -> list[LocalZero]:
        """Its zeros inside the segment, by exact arithmetic."""


class LazyRoot:
    """A simple zero inside a segment that is computed exactly when it is asked for: it has the attributes of a
    `LocalZero`. `number` is its number among the zeros of the form; with an interval, it is the only one inside.
    """

    multiplicity = 1

    def __init__(self, form: LazyForm, number: int, before: int, interval: tuple[float, float] | None = None) -> None:
        self.form, self.number, self.before, self.signs = form, number, before, (before, -before)
        self._interval = interval

    @cached_property
    def exactly(self) -> LocalZero:
        """The zero in exact arithmetic; a rational one as the zero of its linear polynomial."""
        zero = self.form.inner[self.number]
        if zero.signs != self.signs:
            raise AssertionError(f"a change of sign {zero.signs} where {self.signs} was certain in doubles")
        if zero.low < zero.high:
            return zero
        p, q = int(zero.low.numerator), int(zero.low.denominator)
        return LocalZero(mpq(0), mpq(1), 1, zero.signs, LocalPolynomial(fmpz_poly([-p, q - p])), -1)

    @property
    def changing(self) -> tuple[LocalPolynomial, int]:
        """As that of a `LocalZero`; the form itself, without isolating the zero anew, where it is linear or the zero is
        certainly irrational.
        """
        form = self.form.form
        whole = form.polynomial.degree() == 1 or form.without_rational_zero
        return (form, self.before) if whole else self.exactly.changing

    @property
    def low(self) -> mpq:
        """The ends of the interval, as those of a `LocalZero`."""
        return self.exactly.low if self._interval is None else mpq(self._interval[0])

    @property
    def high(self) -> mpq:
        """See `low`."""
        return self.exactly.high if self._interval is None else mpq(self._interval[1])

    @property
    def factor(self) -> LocalPolynomial:
        """A factor of the form with this zero, as that of a `LocalZero`."""
        return self.exactly.factor

    def __reduce__(self) -> tuple[object, ...]:
        return LocalZero, tuple(self.exactly)
