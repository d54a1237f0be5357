"""The parts of splines and programs, each held against what it means, with known answers."""

import pytest
from flint import fmpz, fmpz_poly
from gmpy2 import mpq

from exactspline import BSpline
from exactspline.interchange.examples import example, load, load_surface
from exactspline.language.vector import Vector
from exactspline.numbers.intervals import UNIT
from exactspline.polynomials.bernstein import LONG, value
from exactspline.polynomials.patch_forms import PatchForm, Sized
from exactspline.programs.compiled import needed
from exactspline.programs.instructions import Instruction
from exactspline.splines.lowest_terms import primitive_part
from exactspline.splines.surface import DEPTH, zero_at_corners
from exactspline.splines.tensor_lowest_terms import CONTEXT, as_mpoly, as_packed


def test_polynomials_and_forms_are_equal_piece_by_piece():
    f, g = BSpline(1, [0, 0, 1, 2, 2], [1, 2, 5]), BSpline(1, [0, 0, 1, 2, 2], [1, 2, 4])
    for own, same, other in ((f.polynomials, f.polynomials, g.polynomials), (f.forms, f.forms, g.forms)):
        assert own == same
        assert own == tuple(same)
        assert own != other
        assert own != tuple(own)[:1]
        assert own != (*own, own[0])
        assert own != 2


def test_a_primitive_part_points_where_the_vector_does():
    """(t, t²) on [0, 1] and (2, 2 t) on [1, 2]: parts of degree 1 and unequal content."""
    x = BSpline(2, [0, 0, 0, 1, 1, 1, 2, 2, 2], [0, "1/2", 1, 2, 2, 2])
    y = BSpline(2, [0, 0, 0, 1, 1, 1, 2, 2, 2], [0, 0, 1, 2, 3, 4])
    z = BSpline(2, [0, 0, 0, 1, 1, 1, 2, 2, 2], [0, 0, 2, 1, 3, 9])
    for vector in (Vector(x, y), Vector(x, y, z), Vector(x, x, x * 3)):
        part = primitive_part(vector)
        for i in range(9):
            t = mpq(2 * i + 1, 10) if i != 4 else mpq(19, 10)
            own, told = [f(t) for f in vector], [f(t) for f in part]
            k = next(i for i, a in enumerate(own) if a)
            assert [told[k] * a for a in own] == [own[k] * b for b in told]
            assert (told[k] > 0) == (own[k] > 0)
    assert primitive_part(Vector(x, x, x * 3)).degree == 0


def test_edges_of_a_patch_are_those_of_its_net():
    form = PatchForm.of_net([[1, 2, 3], [4, 5, 7]])
    assert form.edge(0, 0) == [1, 2, 3]
    assert form.edge(0, 1) == [4, 5, 7]
    assert form.edge(1, 0) == [1, 4]
    assert form.edge(1, 1) == [3, 7]


def test_packed_patches_are_polynomials_in_two_variables():
    c = fmpz_poly([5, 0, 7, 0, -3, 1, 0, 0, 9])
    assert as_packed(as_mpoly(c, 3), 3) == c
    z, y = CONTEXT.gens()
    assert as_mpoly(fmpz_poly([5, 0, 7, 0, -3]), 3) == 5 + 7 * z**2 - 3 * z * y
    assert as_packed(2 * z * y**2 + y, 4) == fmpz_poly([0, 0, 0, 0, 1, 0, 0, 0, 0, 2])
    assert as_packed(z * 0, 4) == 0


# ---- programs


def test_what_is_needed_are_instructions_and_their_arguments():
    listed = [
        Instruction("load", (), (0,)),
        Instruction("load", (), (1,)),
        Instruction("mul", (0, -1)),
        Instruction("mul", (0, 1)),
        Instruction("mul", (2, 0)),
        Instruction("mul", (4, 3)),
    ]
    assert needed(listed, [4]) == {0, 2, 4}
    assert needed(listed, [5]) == {0, 1, 2, 3, 4, 5}
    assert needed(listed, [-1, 1]) == {1}
    assert needed(listed, [-2]) == set()


def test_bounds_grow_with_the_roundings():
    np = pytest.importorskip("numpy")
    from exactspline.polynomials.roundings import ROUNDING, UNDERFLOW
    from exactspline.programs.doubles import bounded_by
    from exactspline.programs.masses import SLACK, Known

    masses = np.array([[1.0, 4.0]])
    for roundings in (1, 8, 64):
        told = bounded_by(masses, masses, Known(roundings, 5, 0))
        assert told.values.tolist() == masses.tolist()
        assert told.errors.tolist() == (masses * (SLACK * roundings * ROUNDING)).tolist()
    assert bounded_by(masses, masses * 0, Known(1, 5, 3)).errors.tolist() == [[SLACK * 3 * UNDERFLOW] * 2]


def test_parameters_are_located_in_the_segment_on_the_side_asked_for():
    mesh = BSpline(1, [0, 0, 1, 2, 4, 4], [0, 1, 2, 3]).mesh
    inside = [(mpq(1, 2), 0), (mpq(3, 2), 1), (mpq(3), 2)]
    for t, i in inside:
        assert mesh.locate(t) == mesh.locate(t, left=True) == i
    assert [mesh.locate(mpq(t)) for t in (0, 1, 2, 4)] == [0, 1, 2, 2]
    assert [mesh.locate(mpq(t), left=True) for t in (0, 1, 2, 4)] == [0, 0, 1, 2]


def test_examples_come_before_files_of_their_names(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name in ("circle", "enneper"):
        (tmp_path / name).write_text("no curve", encoding="utf-8")
    assert load("circle") == example("circle")
    assert load_surface("enneper").degree == (3, 3)


def test_a_primitive_part_vanishes_nowhere():
    """(t, 2t²) on [0, 1] is t (1, 2t), of lower degree than what follows: it stays (1, 2) at the end."""
    x = BSpline(2, [0, 0, 0, 1, 1, 1, 2, 2, 2], [0, "1/2", 1, 2, 2, 2])
    z = BSpline(2, [0, 0, 0, 1, 1, 1, 2, 2, 2], [0, 0, 2, 1, 3, 9])
    part = primitive_part(Vector(x, z))
    assert part.degree == 2
    a, b = (f(1, "left") for f in part)
    assert b == 2 * a > 0
    a, b = (f(0) for f in part)
    assert (a > 0, b) == (True, 0)


def test_a_zero_of_a_weight_lies_in_the_box_that_is_told():
    """Of −1 + 2x, of (2x − 1)(2y − 1) + ε with a corner at 0, and where no corner is negative none is told."""
    for net in ([[-1], [1]], [[1, 1], [-1, 1]], [[3, -1], [1, 1]], [[-1, -1], [-1, 2]]):
        form = PatchForm.of_net(net)
        (a, b), (c, d) = found = zero_at_corners(Sized(UNIT, [form], 0))
        values = [form.value(x, y) for x in (a, b) for y in (c, d)]
        assert min(values) <= 0 <= max(values), net
        assert found == ((a, a), (c, c)) or (b - a) * (d - c) == mpq(1, 2**DEPTH)
    for net in ([[1, 2], [3, 4]], [[1, -1, 1], [1, -1, 1]]):
        assert zero_at_corners(Sized(UNIT, [PatchForm.of_net(net)], 0)) is None
    for corner in range(4):
        values = [5, 1, 2, 3]
        values[corner] = 0
        place = mpq(corner // 2), mpq(corner % 2)
        box = (mpq(1), mpq(2)), (mpq(3), mpq(5))
        (x, _), (y, _) = zero_at_corners(Sized(box, [PatchForm.of_net([values[:2], values[2:]])], 0))
        assert (x, y) == (box[0][int(place[0])], box[1][int(place[1])])


@pytest.mark.parametrize("n", [LONG - 1, LONG, LONG + 1, 3 * LONG])
@pytest.mark.parametrize("t", [mpq(0), mpq(1), mpq(1, 3), mpq(5, 2**40), mpq(-2, 7), mpq(9, 4)])
def test_values_of_long_forms_are_those_of_the_powers(n, t):
    c = fmpz_poly([(-1) ** i * (i * i % 11) for i in range(n - 1)])  # the last two coefficients vanish
    powers = [int(c[i]) * t**i * (1 - t) ** (n - i) for i in range(n + 1)]
    assert value((c, fmpz(6)), n, t) == sum(powers) / 6
    assert value((fmpz_poly([]), fmpz(6)), n, t) == 0
