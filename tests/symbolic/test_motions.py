"""Motions and other maps of space: what they do to lengths, volumes and determinants."""

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from exactspline import BSpline
from exactspline.language import Vector, det, norm2
from exactspline.verification.kinds.invariance import MAPS
from exactspline.verification.kinds.invariance import image_of_point as image_of
from exactspline.verification.kinds.invariance import rotation_rows as rotation

T = BSpline.identity(0, 1)
fractions = st.fractions(min_value=-5, max_value=5, max_denominator=9)


@given(st.tuples(fractions, fractions, fractions))
def test_a_rotation_keeps_lengths_and_orientation_and_its_axis(quaternion):
    """R Rᵀ = 1, det R = 1; the axis (a, b, c) stays; about the third axis it is the rotation of the plane."""
    a, b, c = map(mpq, quaternion)
    rows = rotation(3, {"turn1": a, "turn2": b, "turn3": c})
    assert [[sum(x * y for x, y in zip(p, q, strict=True)) for q in rows] for p in rows] == [
        [int(i == j) for j in range(3)] for i in range(3)
    ]
    assert det(*[Vector(*row) for row in rows]) == 1
    assert [row[0] * a + row[1] * b + row[2] * c for row in rows] == [a, b, c]
    flat, about = rotation(2, {"turn1": c}), rotation(3, {"turn1": 0, "turn2": 0, "turn3": c})
    assert [row[:2] for row in about[:2]] == flat
    cosine, sine = (1 - c * c) / (1 + c * c), 2 * c / (1 + c * c)
    assert flat == [[cosine, -sine], [sine, cosine]]


def constants_of(made, n):
    return {name: mpq(3 * i + 2, 2 * i + 5) * (-1) ** i for i, name in enumerate(made.constants(n))}


def points_of(n):
    return [Vector(*[mpq((3 * i + 5 * j * j + i * j) % 11 - 4, j + 2) for j in range(n)]) for i in range(n + 2)]


def moved(made, p, n):
    image, w = made.image(p, mpq(1), constants_of(made, n))
    return Vector(*[x / w for x in image])


def volume(points):
    return det(*[p - points[0] for p in points[1:]])


@pytest.mark.parametrize("n", [2, 3])
@pytest.mark.parametrize("name", ["translation", "rotation", "motion", "reflection", "scaling", "similarity"])
def test_similarities_multiply_all_lengths_and_volumes(name, n):
    made, points = MAPS[name], points_of(n)
    images = [moved(made, p, n) for p in points]
    scale = constants_of(made, n).get("scale", 1)
    for i, p in enumerate(points):
        for j in range(i):
            assert norm2(images[i] - images[j]) == scale**2 * norm2(p - points[j])
    turn = -1 if name == "reflection" else 1
    assert volume(images[: n + 1]) == turn * scale**n * volume(points[: n + 1])
    assert any(image != p for image, p in zip(images, points, strict=True))


@pytest.mark.parametrize("n", [2, 3])
def test_affine_maps_multiply_all_volumes_by_their_determinant(n):
    made, points = MAPS["affine map"], points_of(n)
    images = [moved(made, p, n) for p in points]
    unit = made.unit(points[0], mpq(1), constants_of(made, n))
    for some, others in ((points[:-1], images[:-1]), (points[1:], images[1:])):
        assert volume(others) == unit * volume(some)
    k, one = constants_of(made, n), T.constant(1)
    vectors = [made.of_vector(p.mapped(T.constant), one, k).mapped(lambda f: f(0)) for p in points]
    for p, image, v in zip(points, images, vectors, strict=True):
        assert image - images[0] == v - vectors[0]
        assert p == points[0] or v != vectors[0]


@pytest.mark.parametrize("n", [2, 3])
def test_projective_maps_multiply_determinants_of_homogeneous_coordinates(n):
    made, points = MAPS["projective map"], points_of(n)[: n + 1]
    k = constants_of(made, n)
    images = [made.image(p, mpq(i + 1), k) for i, p in enumerate(points)]
    before = det(*[Vector(*p, mpq(i + 1)) for i, p in enumerate(points)])
    assert det(*[Vector(*p, w) for p, w in images]) == made.unit(points[0], mpq(1), k) * before


@pytest.mark.parametrize("n", [2, 3])
def test_the_inversion_divides_distances_by_those_from_the_origin(n):
    made, points = MAPS["inversion"], [p for p in points_of(n) if norm2(p)]
    images = [moved(made, p, n) for p in points]
    for i, p in enumerate(points):
        assert norm2(images[i]) * norm2(p) == 1
        assert made.unit(p, mpq(1), {}) * norm2(p) == 1
        for j in range(i):
            assert norm2(images[i] - images[j]) * norm2(p) * norm2(points[j]) == norm2(p - points[j])
    if n == 2:
        z = points[0]
        u = images[0]
        assert Vector(z[0] * u[0] - z[1] * u[1], z[0] * u[1] + z[1] * u[0]) == Vector(1, 0)


def test_points_are_moved_by_their_coordinates():
    p = Vector(mpq(3), mpq(4))
    assert image_of(p, MAPS["inversion"], {}, mpq(1)) == [mpq(3, 25), mpq(-4, 25)]
    k = {"move1": mpq(1), "move2": mpq(-2)}
    assert image_of(p, MAPS["translation"], k, mpq(1)) == [4, 2]
    matrix = {f"m{i}{j}": mpq(3 * i + j * j) for i in (1, 2, 3) for j in (1, 2, 3)}
    top, below = MAPS["projective map"].image(p, mpq(1), matrix)
    assert image_of(p, MAPS["projective map"], matrix, mpq(1)) == [x / below for x in top]
    assert below not in (0, 1)
