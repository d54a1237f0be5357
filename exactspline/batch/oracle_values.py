"""Values for the oracle at a parameter: point, derivatives, curvature, torsion, frame."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from exactspline.batch.oracle_answers import Item, Question
from exactspline.geometry import values_along
from exactspline.geometry.analysis import analyse
from exactspline.geometry.values_along import point_at
from exactspline.language.vector import Vector, cross
from exactspline.numbers.exact import mpq
from exactspline.reals.real import Real, real
from exactspline.roots.values import unit
from exactspline.splines.nurbs import Nurbs

Found = tuple[Iterable[Item], Iterable[dict[str, object]]]


def axes(curve: Nurbs) -> list[str]:
    """The names of the coordinates.

    >>> from exactspline import example
    >>> axes(example("circle"))
    ['x', 'y']
    """
    n = curve.dimension
    return list("xyz"[:n]) if n <= 3 else [f"x{i}" for i in range(1, n + 1)]


def _at_parameters(
    curve: Nurbs, question: Question, what: str, values: Callable[[mpq | Real], dict[str, Real]]
) -> Found:
    """One item per parameter."""
    places = question.parameters(curve)
    return [Item(what, {"parameter": real(t)} | values(t)) for t in places], ()


def value(curve: Nurbs, question: Question) -> Found:
    """The points."""
    return _at_parameters(curve, question, "point", lambda t: dict(zip(axes(curve), point_at(curve, t), strict=True)))


def derivative(curve: Nurbs, question: Question) -> Found:
    """The derivatives of one order."""
    order = question.number(1)
    return _at_parameters(
        curve, question, "derivative", lambda t: dict(zip(axes(curve), point_at(curve, t, order), strict=True))
    )


def curvature(curve: Nurbs, question: Question) -> Found:
    """The curvatures."""
    return _at_parameters(curve, question, "curvature", lambda t: {"curvature": values_along.curvature(curve, t)})


def torsion(curve: Nurbs, question: Question) -> Found:
    """The torsions."""
    return _at_parameters(curve, question, "torsion", lambda t: {"torsion": values_along.torsion(curve, t)})


def frame(curve: Nurbs, question: Question) -> Found:
    """The Frenet frames: N is to the left of a plane curve, towards the centre of curvature in space."""
    facts = analyse(curve)
    tangent = facts.velocity
    if not facts.in_space:
        vectors = {"T": tangent, "N": Vector(-tangent[1], tangent[0])}
    else:
        vectors = {"T": tangent, "N": Vector(*cross(facts.binormal, tangent)), "B": facts.binormal}

    def values(t: mpq | Real) -> dict[str, Real]:
        return {
            f"{name}{axis}": x
            for name, vector in vectors.items()
            for axis, x in zip(axes(curve), unit(list(vector), t, name), strict=True)
        }

    return _at_parameters(curve, question, "frame", values)
