"""Two plane curves over both parameters: their tangents, their chord, and the function of the bisector.

Let a and b be the tangents and E the chord from one point to the other. The normals meet in ``P + α a⊥`` with
``α = (b·E)/[a b]``, and this point is equally far from both curves where ``F = (a·E) [E b] − [a E] (b·E)`` vanishes.

Source: Elber and Kim, Bisector curves of planar rational curves, Computer-Aided Design 1998.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Generic, TypeVar, cast

from flint import fmpz_mpoly

from exactspline.language.vector import Vector, det, dot
from exactspline.language.wronskians import wronskians
from exactspline.numbers.once import cached_property
from exactspline.polynomials.two_parameters import lifted as lifted_polynomial
from exactspline.roots.values import segment_polynomials
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.tensor import TensorSpline, lifted

#: Functions of two parameters.
R = TypeVar("R", bound=Any)
#: The functions p and w of a curve, and its tangent.
Sides = Sequence[Sequence[R]]


class PlanePair(Generic[R]):
    """Two plane curves, each given by p and w, with their tangents a, b and their chord as functions of both
    parameters.
    """

    def __init__(self, first: Sides[R], second: Sides[R]) -> None:
        (*p, w), a = first
        (*q, v), b = second
        self.a, self.b = Vector(*a), Vector(*b)
        #: ``w w̄``, and the chord times ``w w̄``.
        self.weight, self.chord = w * v, Vector(*[w * y - v * x for x, y in zip(p, q, strict=True)])

    @classmethod
    def of_segments(cls, one: tuple[Nurbs, int], other: tuple[Nurbs, int]) -> PlanePair[fmpz_mpoly]:
        """Two segments, each as a curve and a number, as polynomials in their parameters."""
        lists = []
        for k, (curve, segment) in enumerate((one, other)):
            forms = segment_polynomials((*curve.p, curve.w), segment)
            *p, w = forms
            velocity = [f.derivative() * w - f * w.derivative() for f in p]
            lists.append([[lifted_polynomial(f, k) for f in own] for own in (forms, velocity)])
        return PlanePair(*lists)

    @classmethod
    def of_curves(cls, first: Nurbs, second: Nurbs) -> PlanePair[TensorSpline]:
        """The pair of two whole curves."""
        meshes = first.w.mesh, second.w.mesh
        lists = [
            [[lifted(f, meshes, k) for f in own] for own in ((*curve.p, curve.w), tangent(curve))]
            for k, curve in enumerate((first, second))
        ]
        return PlanePair(*lists)

    @cached_property
    def across(self) -> R:
        """``[a b]``, which is zero where the normals are parallel."""
        return det(self.a, self.b)

    @cached_property
    def equidistant(self) -> R:
        """F, without the positive powers of both weights."""
        a, b, e = self.a, self.b, self.chord
        return cast(R, dot(a, e) * det(e, b) - det(a, e) * dot(b, e))


def tangent(curve: Nurbs) -> tuple[BSpline, ...]:
    """``w² γ′``."""
    return tuple(wronskians(curve.w, curve.p))
