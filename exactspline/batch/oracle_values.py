"""Values for the oracle at a parameter: point, derivatives, curvature, torsion, frame."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from exactspline.batch.oracle_answers import Item, Question
from exactspline.errors import DomainError
from exactspline.exact import mpq
from exactspline.geometry.analysis import analyse
from exactspline.geometry.values_along import curvature_at, point_at, torsion_at
from exactspline.language.vector import Vector, cross
from exactspline.roots.enclosure import sign_at
from exactspline.roots.real import Real
from exactspline.roots.root import Root
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surd import square_root

Found = tuple[Iterable[Item], Iterable[dict[str, object]]]


def axes(curve: Nurbs) -> list[str]:
    """The names of the coordinates.

    >>> from exactspline import example
    >>> axes(example("circle"))
    ['x', 'y']
    """
    n = curve.dimension
    return list("xyz"[:n]) if n <= 3 else [f"x{i}" for i in range(1, n + 1)]


def _told(curve: Nurbs, question: Question, what: str, values: Callable[[mpq | Root], dict[str, Real]]) -> Found:
    """One item per parameter."""
    places = question.parameters(curve)
    return [Item(what, {"parameter": Real.of(t)} | values(t)) for t in places], ()


def value(curve: Nurbs, question: Question) -> Found:
    """The points."""
    return _told(curve, question, "point", lambda t: dict(zip(axes(curve), point_at(curve, t), strict=True)))


def derivative(curve: Nurbs, question: Question) -> Found:
    """The derivatives of one order."""
    order = question.number(1)
    return _told(
        curve, question, "derivative", lambda t: dict(zip(axes(curve), point_at(curve, t, order), strict=True))
    )


def curvature(curve: Nurbs, question: Question) -> Found:
    """The curvatures."""
    return _told(curve, question, "curvature", lambda t: {"curvature": curvature_at(curve, t)})


def torsion(curve: Nurbs, question: Question) -> Found:
    """The torsions."""
    return _told(curve, question, "torsion", lambda t: {"torsion": torsion_at(curve, t)})


def frame(curve: Nurbs, question: Question) -> Found:
    """The Frenet frames: N is to the left of a plane curve, towards the centre of curvature in space."""
    facts = analyse(curve)
    tangent = facts.velocity
    if not facts.in_space:
        vectors = {"T": tangent, "N": Vector(-tangent[1], tangent[0])}
    else:
        vectors = {"T": tangent, "N": Vector(*cross(facts.binormal, tangent)), "B": facts.binormal}

    def values(t: mpq | Root) -> dict[str, Real]:
        return {
            f"{name}{axis}": x
            for name, vector in vectors.items()
            for axis, x in zip(axes(curve), unit(list(vector), t, name), strict=True)
        }

    return _told(curve, question, "frame", values)


def unit(vector: Sequence[BSpline], place: mpq | Root, name: str = "T") -> list[Real]:
    """The components of a vector divided by its length at a parameter.

    >>> t = BSpline.identity(0, 2)
    >>> [x.exact for x in unit([t, t * t], mpq(1))]
    [Surd(1/2, 2), Surd(1/2, 2)]

    Raises `DomainError` where the vector vanishes.
    """
    signs = [sign_at(x, place) for x in vector]
    if not any(signs):
        raise DomainError(f"{name} is not defined: the vector vanishes there", remedy="choose another parameter")
    if not isinstance(place, Root):
        values = [x(place) for x in vector]
        length = sum((x * x for x in values), start=mpq(0))
        return [Real.of(square_root(x * x / length) * s) for x, s in zip(values, signs, strict=True)]
    squared = sum((x * x for x in vector[1:]), start=vector[0] * vector[0])
    return [Real.root_of_quotient_at(s, x * x, squared, place) for x, s in zip(vector, signs, strict=True)]
