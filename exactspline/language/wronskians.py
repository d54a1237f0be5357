"""Wronskians, the vector orthogonal to a vector and its derivatives, and the numerator of a logarithmic derivative.

In most readings these are computed as determinants and sums of products of derivatives. But a determinant of
derivatives of forms of degree n has a lower degree than the products in it: a reading that can compute such an
operation at its true degree implements `OwnWronskians`. Formulas do not depend on this.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from functools import reduce
from operator import add
from typing import Any, Self, TypeVar, cast

from exactspline.errors import FormulaError, as_integer
from exactspline.language.operand import R
from exactspline.language.vector import Vector, det, expect_vector, generalized_cross

T = TypeVar("T")


class OwnWronskians(ABC):
    """An operand whose reading implements the operations of this module itself."""

    __slots__ = ()

    @abstractmethod
    def wronskian(self, functions: Sequence[Self]) -> Self:
        """The Wronskian of functions, of which this is one."""

    @abstractmethod
    def logarithmic_numerator(self, powers: Sequence[tuple[Self, int]]) -> Self:
        """``Π f · F′/F`` for ``F = Π fᵉ``, where this is one of the f."""


def wronskian(a: Vector[R], order: int | None = None) -> R:
    """Return the determinant of a vector of n components and its first n−1 derivatives.

    The determinant vanishes identically if the components are linearly dependent. `order` is n, required only if `a` is
    a node of a formula's tree.

    >>> from exactspline import BSpline
    >>> from exactspline.language import Vector
    >>> t = BSpline.identity(0, 1)
    >>> wronskian(Vector(t, t * t)) == t * t
    True
    """
    expect_vector(a)
    if (implementer := _implementer(a)) is not None:
        return cast(R, implementer.wronskian(cast(Any, a.components)))
    n = len(a) if order is None else as_integer(order, "a number of components", 1)
    return det(a, *[a.d(k) for k in range(1, n)])


def wronskians(w: R, p: Vector[R]) -> Vector[R]:
    """``w p′ − w′ p``, the Wronskians of a function and each component of a vector: ``w²`` times the derivative of the
    quotient.

    >>> from exactspline import BSpline
    >>> from exactspline.language import Vector
    >>> t = BSpline.identity(0, 1)
    >>> wronskians(t, Vector(t * t, t))[0] == t * t
    True
    """
    if isinstance(w, OwnWronskians):
        return Vector(*[cast(R, w.wronskian((cast(Any, w), cast(Any, x)))) for x in p])
    return p.d(1) * w - p * w.d(1)


def osculating(a: Vector[R], order: int) -> Vector[R]:
    """The vector orthogonal to `a` and its first ``order − 1`` derivatives, where `a` has ``order + 1`` components: the
    line, plane or sphere through `order` consecutive points. Each component is, up to sign, the Wronskian of all other
    components of `a`.

    >>> from exactspline import BSpline
    >>> from exactspline.language import Vector
    >>> t = BSpline.identity(0, 1)
    >>> [x(0) for x in osculating(Vector(t.constant(1), t, t * t), 2)]
    [mpq(0,1), mpq(0,1), mpq(1,1)]
    """
    if (implementer := _implementer(a)) is not None and len(a) == order + 1:
        components: tuple[Any, ...] = a.components
        minors: list[Any] = [
            implementer.wronskian([x for k, x in enumerate(components) if k != j]) for j in range(order + 1)
        ]
        return Vector(*[-minor if (order + j) % 2 else minor for j, minor in enumerate(minors)])
    return generalized_cross(a, *[a.d(k) for k in range(1, order)])


def logarithmic_numerator(*powers: tuple[R, int]) -> R:
    """``Π f · F′/F`` for ``F = Π fᵉ``, the numerator of a logarithmic derivative: ``Σ e f′ Π (the other f)``.

    >>> from exactspline import BSpline
    >>> t = BSpline.identity(0, 1)
    >>> logarithmic_numerator((t, 2), (t + 1, -1)) == 2 * (t + 1) - t
    True

    Raises `FormulaError` if no function is given.
    """
    if not powers:
        raise FormulaError("the logarithmic derivative of nothing", remedy="give functions with their exponents")
    implementer: object = powers[0][0]
    if isinstance(implementer, OwnWronskians):
        return cast(R, implementer.logarithmic_numerator(cast(Any, powers)))
    return logarithmic_sum([(f, f.d(1), e) for f, e in powers])


def logarithmic_sum(parts: Sequence[tuple[R, R, int]]) -> R:
    """``Σ e g Π (the other f)`` over triples (f, g, e)."""
    terms: list[Any] = []
    for k, (_, derivative, e) in enumerate(parts):
        product: Any = derivative
        for other, _, _ in (*parts[:k], *parts[k + 1 :]):
            product = product * other
        terms.append(product * e)
    return cast(R, reduce(add, terms))


def _implementer(a: Vector[T]) -> OwnWronskians | None:
    """A component that implements these operations itself, or None."""
    first: object = a[0] if type(a) is Vector and len(a) else None
    return first if isinstance(first, OwnWronskians) else None
