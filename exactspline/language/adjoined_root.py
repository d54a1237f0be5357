"""Adjoined square roots: ``a + b σ`` with ``σ² = S``, over any reading with division.

Over the quotients of differential polynomials (`exactspline.readings.jet`) this is an algebraic extension of
that field: with σ = ‖γ′‖, the root of γ′·γ′, unit vectors and Frenet frames are elements of it, and an equality there
is a proof for all curves. Extensions can be repeated: ρ = ‖γ′ × γ″‖ is adjoined to the extension by σ. The derivative
follows from σ² = S: ``σ′ = S′ / (2 S) · σ``.
"""

from __future__ import annotations

from typing import cast

from exactspline.errors import FormulaError
from exactspline.language.arguments import Accompanied, Curve, T
from exactspline.language.operand import Constant, FieldOperand, Operand
from exactspline.language.vector import Vector, cross, norm2
from exactspline.one_line import one_line


class Adjoined(FieldOperand):
    """``plain + rooted · σ`` with σ² = `square`, where S is an operand of the base reading that is not a square in that
    reading.
    >>> from exactspline.language.kinds import CURVE
    >>> from exactspline.readings.jet import RationalJetReading
    >>> c = RationalJetReading(2).argument(CURVE, 2)
    >>> sigma = root_of(norm2(c.gamma.d(1)))
    >>> sigma * sigma == sigma.lifted(norm2(c.gamma.d(1)))
    True
    >>> (1 / sigma) * sigma == sigma.constant(1), (sigma * sigma).d() == 2 * sigma * sigma.d()
    (True, True)
    """

    __slots__ = ("plain", "rooted", "square")
    degree = provenance = 0

    def __init__(self, plain: Operand, rooted: Operand, square: Operand) -> None:
        self.plain, self.rooted, self.square = plain, rooted, square

    def lifted(self, operand: Operand) -> Adjoined:
        """An operand of the base reading as an element of this extension."""
        return Adjoined(operand, operand.constant(0), self.square)

    def constant(self, value: Constant) -> Adjoined:
        """An exact constant."""
        return self.lifted(self.square.constant(value))

    def coerced(self, other: object) -> Adjoined | None:
        """Another element of this extension, constants converted; None for anything else.

        Raises `FormulaError` for an element of another extension.
        """
        element = super().coerced(other)
        if isinstance(element, Adjoined) and element.square is not self.square and not element.square == self.square:
            raise FormulaError(
                "elements of different extensions in one operation",
                remedy="adjoin one root to the extension by the other",
            )
        return element

    def _plus(self, right: Adjoined) -> Adjoined:
        return Adjoined(self.plain + right.plain, self.rooted + right.rooted, self.square)

    def _times(self, right: Adjoined) -> Adjoined:
        plain = self.plain * right.plain + self.rooted * right.rooted * self.square
        return Adjoined(plain, self.plain * right.rooted + self.rooted * right.plain, self.square)

    @property
    def norm(self) -> Operand:
        """``a² − b² S``, an operand of the base reading."""
        return self.plain * self.plain - self.rooted * self.rooted * self.square

    def reciprocal(self) -> Adjoined:
        """``1 / (a + b σ)``; raises `FormulaError` for 0, and if the norm vanishes because S is a square."""
        inverse = self.square.constant(1) / self.norm
        return Adjoined(self.plain * inverse, -self.rooted * inverse, self.square)

    def scaled(self, constant: Constant) -> Adjoined:
        """The element times an exact constant."""
        return Adjoined(self.plain.scaled(constant), self.rooted.scaled(constant), self.square)

    def _first_derivative(self, by: str | None) -> Adjoined:
        """The derivative: ``a′ + (b′ + b S′/(2 S)) σ``."""
        log_derivative = self.square.d(1, by=by) / (self.square * 2)
        return Adjoined(self.plain.d(1, by=by), self.rooted.d(1, by=by) + self.rooted * log_derivative, self.square)

    @property
    def is_zero(self) -> bool:
        """Whether both parts are zero, since 1 and σ are linearly independent over the base reading."""
        return bool(self.plain.is_zero and self.rooted.is_zero)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Adjoined) and self.plain == other.plain and self.rooted == other.rooted

    __hash__ = None  # type: ignore[assignment]  # not hashable

    @one_line
    def __repr__(self) -> str:
        return f"{self.plain!r} + {self.rooted!r} √({self.square!r})"


def root_of(square: Operand) -> Adjoined:
    """The root σ of an operand of a reading with division; the operand must not be a square.

    Raises `FormulaError` for 0, which is a square.
    """
    if square.is_zero:
        raise FormulaError("the root of zero", remedy="adjoin roots of operands that are not squares")
    return Adjoined(square.constant(0), square.constant(1), square)


class FramedCurve(Accompanied[Adjoined]):
    """A curve with the roots required for its Frenet frame: ``sigma`` = ‖γ′‖, and in space ``rho`` = ‖γ′ × γ″‖.

    In the plane the operands are ``a + b σ``, in space ``(a + b σ) + (c + e σ) ρ``.
    """

    def __init__(self, curve: Curve[Adjoined], sigma: Adjoined, rho: Adjoined | None = None) -> None:
        super().__init__(curve, curve.additional if isinstance(curve, Accompanied) else {})
        self.sigma, self.rho = sigma, rho

    def copied(self) -> FramedCurve:
        """A new curve with the same operands and roots."""
        return FramedCurve(self, self.sigma, self.rho)


def framed(curve: Curve[T]) -> FramedCurve:
    """A curve of a reading with division (jets, Taylor series, sympy), with the roots of its frame adjoined.
    >>> from exactspline.language.kinds import CURVE
    >>> from exactspline.readings.jet import RationalJetReading
    >>> c = framed(RationalJetReading(3).argument(CURVE, 2))
    >>> tangent = c.gamma.d(1) / c.sigma
    >>> norm2(tangent) == c.sigma.constant(1)
    True
    """
    gamma = cast("Vector[T]", curve.gamma)  # a reading with division divides componentwise
    first = gamma.d(1)
    sigma = root_of(norm2(first))
    if curve.dimension == 2:
        return FramedCurve(curve.mapped(sigma.lifted), sigma)
    rho = root_of(sigma.lifted(norm2(cross(first, gamma.d(2)))))
    return FramedCurve(curve.mapped(lambda operand: rho.lifted(sigma.lifted(operand))), rho.lifted(sigma), rho)
