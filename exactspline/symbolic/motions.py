"""Maps of the plane, of space and of curves, under which claims state invariance.

Each map is written once, for coordinates and denominators of any reading and constants of any type: indeterminates in a
proof, numbers on a given curve.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

from exactspline.language.operand import Operand
from exactspline.language.vector import Vector, det, norm2

Constants = Mapping[str, Any]
M = TypeVar("M", bound=Operand)
N = TypeVar("N")


@dataclass(frozen=True)
class Map:
    """A map of points. ``image`` returns numerators and denominator of the image of p/w. ``unit`` is the quantity (the
    scale, the determinant) such that invariants are multiplied by one of its powers, or None.

    ``constants`` returns the names of the constants for a dimension. An affine map does not change the denominator.
    """

    constants: Callable[[int], Sequence[str]]
    image: Callable[[Vector[Any], Any, Constants], tuple[Vector[Any], Any]]
    unit: Callable[[Vector[Any], Any, Constants], Any] | None
    affine: bool = True
    dimensions: tuple[int, ...] = (2, 3)

    def of_vector(self, v: Vector[M], one: M, constants: Mapping[str, object]) -> Vector[M]:
        """The image of a vector under an affine map: the image of its end point minus the image of the origin."""
        moved, _ = self.image(v, one, constants)
        origin, _ = self.image(v.mapped(lambda x: x.constant(0)), one, constants)
        difference: Vector[M] = moved - origin
        return difference


def _move(n: int) -> list[str]:
    return [f"move{i}" for i in range(1, n + 1)]


def _turn(n: int) -> list[str]:
    return [f"turn{i}" for i in range(1, 2 if n == 2 else 4)]


def _matrix(n: int) -> list[str]:
    return [f"m{i}{j}" for i in range(1, n + 1) for j in range(1, n + 1)]


def _translated(p: Vector[Any], w: Any, k: Constants) -> tuple[Vector[Any], Any]:
    return Vector(*[x + w * k[name] for x, name in zip(p, _move(len(p)), strict=True)]), w


def _rotated(p: Vector[Any], w: Any, k: Constants) -> tuple[Vector[Any], Any]:
    """Rotations by Cayley's parameters: all rotations except half turns, which are limits of other rotations."""
    return Vector(*[_combination(row, p) for row in rotation_rows(len(p), k)]), w


def rotation_rows(n: int, constants: Mapping[str, N]) -> list[list[N]]:
    """The rows of a rotation matrix: given by the tangent of half its angle in the plane, by a quaternion 1 + a i + b j
    + c k in space.

    >>> from exactspline.numbers.exact import mpq
    >>> rotation_rows(2, {"turn1": mpq(1, 2)})
    [[mpq(3,5), mpq(-4,5)], [mpq(4,5), mpq(3,5)]]
    """
    k: Constants = constants
    if n == 2:
        q = k["turn1"]
        length = q * q + 1
        return [[(1 - q * q) / length, -2 * q / length], [2 * q / length, (1 - q * q) / length]]
    a, b, c = (k[name] for name in _turn(3))
    length = a * a + b * b + c * c + 1
    rows = [
        [1 + a * a - b * b - c * c, 2 * (a * b - c), 2 * (a * c + b)],
        [2 * (a * b + c), 1 - a * a + b * b - c * c, 2 * (b * c - a)],
        [2 * (a * c - b), 2 * (b * c + a), 1 - a * a - b * b + c * c],
    ]
    return [[entry / length for entry in row] for row in rows]


def _reflected(p: Vector[Any], w: Any, k: Constants) -> tuple[Vector[Any], Any]:
    """A reflection combined with motions: every isometry that reverses orientation."""
    return _moved(Vector(-p[0], *p[1:]), w, k)


def _scaled(p: Vector[Any], w: Any, k: Constants) -> tuple[Vector[Any], Any]:
    return p.mapped(lambda x: x * k["scale"]), w


def _moved(p: Vector[Any], w: Any, k: Constants) -> tuple[Vector[Any], Any]:
    return _translated(*_rotated(p, w, k), k)


def _similar(p: Vector[Any], w: Any, k: Constants) -> tuple[Vector[Any], Any]:
    return _moved(*_scaled(p, w, k), k)


def _affine(p: Vector[Any], w: Any, k: Constants) -> tuple[Vector[Any], Any]:
    n = len(p)
    rows = [[k[f"m{i}{j}"] for j in range(1, n + 1)] for i in range(1, n + 1)]
    return _translated(Vector(*[_combination(row, p) for row in rows]), w, k)


def _projective(p: Vector[Any], w: Any, k: Constants) -> tuple[Vector[Any], Any]:
    n, whole = len(p) + 1, [*p, w]
    *image, below = [_combination([k[f"m{i}{j}"] for j in range(1, n + 1)], whole) for i in range(1, n + 1)]
    return Vector(*image), below


def _inverted(p: Vector[Any], w: Any, k: Constants) -> tuple[Vector[Any], Any]:
    """z ↦ 1/z in the plane; in space the inversion in the unit sphere, after a reflection."""
    return Vector(p[0], -p[1], *p[2:]).mapped(lambda x: x * w), norm2(p)


def _combination(row: Sequence[Any], p: Sequence[Any] | Vector[Any]) -> Any:
    total = None
    for a, x in zip(row, p, strict=True):
        total = x * a if total is None else total + x * a
    return total


def _determinant(size: Callable[[int], int]) -> Callable[[Vector[Any], Any, Constants], Any]:
    def unit(p: Vector[Any], w: Any, k: Constants) -> Any:
        n = size(len(p))
        return det(*[Vector(*[k[f"m{i}{j}"] for j in range(1, n + 1)]) for i in range(1, n + 1)])

    return unit


#: The maps by name. A Möbius map is composed of similarities and z ↦ 1/z, whose local scale is w²/‖p‖².
MAPS = {
    "translation": Map(_move, _translated, None),
    "rotation": Map(_turn, _rotated, None),
    "motion": Map(lambda n: [*_turn(n), *_move(n)], _moved, None),
    "reflection": Map(lambda n: [*_turn(n), *_move(n)], _reflected, lambda p, w, k: w.constant(-1)),
    "scaling": Map(lambda n: ["scale"], _scaled, lambda p, w, k: k["scale"]),
    "similarity": Map(lambda n: ["scale", *_turn(n), *_move(n)], _similar, lambda p, w, k: k["scale"]),
    "affine map": Map(lambda n: [*_matrix(n), *_move(n)], _affine, _determinant(lambda n: n)),
    "projective map": Map(lambda n: _matrix(n + 1), _projective, _determinant(lambda n: n + 1), affine=False),
    "inversion": Map(lambda n: [], _inverted, lambda p, w, k: w * w / norm2(p), affine=False),
}
