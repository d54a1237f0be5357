"""Questions about ruled surfaces on a curve: points, degrees, developability, and whether two ruled surfaces are the
same surface.

A `RuledSurface` is ``δ(s) + ζ G(s)``: directrix δ, generator G, ruling parameter ζ. In this module directrix and
generator are vectors of splines, or quotients of such vectors.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, TypeVar, cast

from exactspline.errors import DomainError, ShapeError, shown
from exactspline.geometry.derived.constructions import Variant, construction
from exactspline.geometry.derived.derive import space
from exactspline.language.operand import Operand
from exactspline.language.rational import Rational
from exactspline.language.ruled import RuledSurface, development, differences, numerator, split
from exactspline.language.vector import Vector, dot, norm2
from exactspline.numbers.exact import Number, mpq, rational, text
from exactspline.numbers.intervals import Side
from exactspline.one_line import OneLine
from exactspline.splines.bspline import BSpline
from exactspline.splines.common import with_common_knots
from exactspline.splines.knots import Mesh
from exactspline.splines.lowest_terms import SplineSurface, in_lowest_terms, where_it_exists
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.tensor import TensorSpline, lifted
from exactspline.splines.type_checks import curve_of

V = TypeVar("V", bound=Vector[Any] | Operand)


@dataclass(frozen=True, repr=False)
class RulingRelation(OneLine):
    """The relation between the ruling parameters ζ and λ of two forms of the same surface: ``ζ = shift(s) + scale(s)
    λ``, with shift and scale in lowest terms.
    """

    shift: Rational[BSpline]
    scale: Rational[BSpline]

    def __call__(self, s: Number, ruling: Number, side: Side | str = Side.RIGHT) -> mpq:
        """ζ for λ on the ruling of the parameter s; `ZeroDivisionError` where the relation has a pole."""
        return self.shift.number(s, side=side) + self.scale.number(s, side=side) * rational(ruling)


def ruled_surface(name: str, curve: Nurbs, variant: Variant | str = Variant.MINIMAL) -> SplineSurface:
    """Return a ruled surface of §5 of the paper (Chen, Riesenfeld and Cohen 2007) on a space curve. The `variant` is
    ``naive`` (without cancellation), ``paper`` (as in the paper) or ``minimal`` (in lowest terms).

    >>> from exactspline.interchange.examples import example
    >>> curve = example("rational_space_cubic")
    >>> [ruled_surface("tangent_developable", curve, variant).degree for variant in ("naive", "paper", "minimal")]
    [9, 5, 4]

    Raises `ShapeError` for a curve that is not in space, and for a construction that is not a ruled surface, and
    `ReductionError` if the surface does not exist on a whole segment.
    """
    curve = curve_of(curve)
    value = construction(name).formula(variant)(space(curve))
    if not isinstance(value, RuledSurface):
        raise ShapeError(f"{name} is not a ruled surface", remedy="choose a developable, a scroll or the focal surface")
    return cast(SplineSurface, in_lowest_terms(value) if variant == Variant.MINIMAL else value)


def point_at(surface: SplineSurface, s: Number, ruling: Number, side: Side | str = Side.RIGHT) -> tuple[mpq, ...]:
    """The point of the parameters s and ζ, exactly; `ZeroDivisionError` at a pole.

    >>> from exactspline.interchange.examples import example
    >>> point_at(ruled_surface("tangent_developable", example("twisted_cubic")), 1, 2)
    (mpq(3,1), mpq(5,1), mpq(7,1))
    """
    ends = [_value(part, s, side) for part in (surface.directrix, surface.generator)]
    return tuple(x + rational(ruling) * y for x, y in zip(*ends, strict=True))


def _value(part: Any, s: Any, side: Side | str) -> tuple[mpq, ...]:
    return tuple(c(s, side) for c in part) if isinstance(part, Vector) else part(s, side)


def as_tensor_product(surface: SplineSurface, a: Number, b: Number) -> Vector[TensorSpline] | Rational[TensorSpline]:
    """Return the surface between the ruling parameters a and b as a tensor-product B-spline: a `Vector` of
    `TensorSpline`, or a `Rational` of them.

    The degree in the ruling parameter is 1. All components have the same knots, so that their control points, with the
    control points of the denominator as weights, are the net of a NURBS surface in homogeneous coordinates.

    >>> from exactspline.interchange.examples import example
    >>> tangents = ruled_surface("tangent_developable", example("rational_space_cubic"), "paper")
    >>> patch = as_tensor_product(tangents, -1, 2)
    >>> tuple(patch.denominator.degree), patch("1/2", "3/2") == point_at(tangents, "1/2", "3/2")
    ((5, 1), True)

    Raises `DomainError` unless a < b, `ShapeError` for anything that is not a ruled surface.
    """
    _check_is_ruled(surface)
    low, high = rational(a), rational(b)
    if not low < high:
        raise DomainError(f"[{text(low)}, {text(high)}] is not an interval of ruling parameters", remedy="give a < b")
    meshes = split(surface.directrix)[0][0].mesh, Mesh([low, high])
    ruling = lifted(BSpline.identity(low, high), meshes, 1)
    points = _lifted(surface.directrix, meshes) + _lifted(surface.generator, meshes) * ruling
    components = [*numerator(points), *([points.denominator] if isinstance(points, Rational) else [])]
    components = with_common_knots(components)
    return Rational(Vector(*components[:3]), components[3]) if isinstance(points, Rational) else Vector(*components)


def _lifted(part: Any, meshes: tuple[Mesh, Mesh]) -> Any:
    """A vector, or a vector quotient, of splines in s as a vector or quotient of splines in both parameters."""
    top = Vector(*[lifted(c, meshes, 0) for c in numerator(part)])
    return Rational(top, lifted(part.denominator, meshes, 0)) if isinstance(part, Rational) else top


def is_developable(surface: SplineSurface) -> bool:
    """Return whether the tangent plane of the ruled surface δ + ζ G is constant along every ruling: whether the
    determinant ``[δ′ G G′]`` vanishes identically.

    >>> from exactspline.interchange.examples import example
    >>> curve = example("rational_space_cubic")
    >>> [is_developable(ruled_surface(name, curve)) for name in ("rectifying_developable", "binormal_scroll")]
    [True, False]

    Raises `ShapeError` for anything that is not a ruled surface, and where the generator vanishes on a whole segment.
    """
    _check_is_ruled(surface)
    _check_generator(surface)
    return development(cast("RuledSurface[Vector[BSpline]]", in_lowest_terms(surface))).is_zero


def _check_is_ruled(surface: object) -> None:
    if not isinstance(surface, RuledSurface):
        raise ShapeError(f"{shown(surface)} is not a ruled surface", remedy="make one with exactspline.ruled_surface")


def _check_generator(surface: SplineSurface) -> None:
    for i, parts in enumerate(zip(*[c.numerators for c in split(surface.generator)[0]], strict=True)):
        if not any(parts):
            a, b = split(surface.generator)[0][0].breakpoints[i : i + 2]
            problem = f"the generator vanishes on all of [{text(a)}, {text(b)}]: there is no ruled surface"
            raise ShapeError(problem, remedy="leave this segment out")


def same_surface(a: SplineSurface, b: SplineSurface) -> RulingRelation | None:
    """The relation between the ruling parameters ζ of `a` and λ of `b` when both are the same surface with the same
    rulings for the same s, else None.

    Where ``ζ = shift + scale λ``, the points are the same: ``a(s, ζ) = b(s, λ)``.

    >>> from exactspline.interchange.examples import example
    >>> curve = example("rational_space_cubic")
    >>> naive, paper = (ruled_surface("binormal_scroll", curve, variant) for variant in ("naive", "paper"))
    >>> relation = same_surface(naive, paper)
    >>> relation.scale == Rational(curve.w**3, curve.w.constant(1)), relation.shift.is_zero
    (True, True)

    Raises `ShapeError` where a generator vanishes on a whole segment.
    """
    for surface in (a, b):
        _check_generator(surface)
    if not all(part.is_zero for part in differences(a, b)):
        return None
    first, second, between = cast(Any, a.generator), cast(Any, b.generator), cast(Any, b.directrix) - a.directrix
    along = norm2(first)
    return RulingRelation(_ratio(dot(between, first), along), _ratio(dot(second, first), along))


def _ratio(top: Any, bottom: Any) -> Rational[BSpline]:
    """A quotient of scalars that may be quotients themselves, in lowest terms."""
    return where_it_exists(top / bottom)
