"""The certified filter: its bounds hold on hostile data in every rounding mode, its answers are the exact ones."""

import random
import subprocess
import sys
from fractions import Fraction
from math import ceil, comb

import pytest

from exactspline import Nurbs, formula_of, from_floats
from exactspline.errors import FormulaError, NumberError, ShapeError, WeightError
from exactspline.language.kinds import PLANE
from exactspline.programs.program import program_of
from exactspline.programs.reading import Signature
from tests.campaigns import filter as campaign
from tests.support.rounding import FLUSHED, MODES, rounding
from tests.support.sampled import sample

np = pytest.importorskip("numpy")

from exactspline.geometry.analysis.many_curves import features_in_parts, features_of_curves, filtered, scaled_operands  # noqa: E402
from exactspline.geometry.curves.plane_programs import plane_program  # noqa: E402
from exactspline.polynomials.doubles import Bounded, isolated, ordinates, values_at  # noqa: E402
from exactspline.programs.doubles import in_doubles  # noqa: E402


def hostile(degree, rational):
    """Curves whose forms cancel, all but vanish, underflow and differ in size."""
    numbers = np.random.default_rng(degree)
    points = numbers.uniform(-1, 1, (60, degree + 1, 2))
    weights = numbers.uniform(0.5, 1, (60, degree + 1))
    line = np.linspace(0, 1, degree + 1)
    points[:10, :, 1] = points[:10, :, 0] * 3
    points[10:20] += 1 - 2.0**-20
    points[20:30] = 2.0**-30 * points[20:30] + line[None, :, None]
    points[30:35] *= 1e-150
    points[35:40, ::2] *= 1e-310
    points[40:45, 1:] *= 5e-324
    points[45:50] = np.round(points[45:50] * 4) / 4
    weights[50:55] = 1
    weights[55:60, 1:] *= 1e-300
    points /= np.maximum(1, np.abs(points).max(axis=(1, 2), keepdims=True))
    return points, weights if rational else None


def exactly(program, rows):
    """The outputs of a program on exact coefficients, by its instructions alone."""
    known = {-1: [Fraction(1)]}

    def times(a, b):
        product = [Fraction(0)] * (len(a) + len(b) - 1)
        for i, x in enumerate(a):
            for j, y in enumerate(b):
                product[i + j] += x * y
        return product

    def derived(name, c, n):
        up = [(i + 1) * c[i + 1] for i in range(n)]
        down = [(n - i) * c[i] for i in range(n)]
        return {"dv": up, "du": down}.get(name) or [x - y for x, y in zip(up, down, strict=True)]

    for i, (name, arguments, numbers) in enumerate(program.instructions.listed):
        a, b = ([*(known[k] for k in arguments), None, None])[:2]
        if name == "load":
            known[i] = rows[numbers[0]]
        elif name == "mul":
            known[i] = times(a, b)
        elif name == "sum":
            known[i] = [numbers[0] * x + numbers[1] * y for x, y in zip(a, b, strict=True)]
        elif name == "raise":
            known[i] = times(a, [Fraction(comb(numbers[0], k)) for k in range(numbers[0] + 1)])
        elif name == "scale":
            known[i] = [numbers[0] * x for x in a]
        else:
            known[i] = derived(name, a, numbers[0])
    return [known[i] for i in program.outputs]


def signature(degree, rational):
    count = 3 if rational else 2
    return Signature(PLANE, 2, not rational, (degree,) * count, (0,) * count, True)


CURVES = [(3, False), (2, True), (3, True)]
FORMS = [(name, *each) for name in ("f2", "g2", "vertices_lifted", "D1_squared") for each in CURVES]


@pytest.mark.parametrize("mode", [*MODES, *FLUSHED])
@pytest.mark.parametrize(("name", "degree", "rational"), sample(FORMS, 6))
def test_no_number_is_farther_from_the_exact_one_than_its_bound(name, degree, rational, mode):
    program = program_of(formula_of(name), signature(degree, rational))
    points, weights = hostile(degree, rational)
    scale = np.array([comb(degree, i) for i in range(degree + 1)], dtype=float)
    with rounding(mode):
        v = np.ones_like(points[:, :, 0]) if weights is None else weights
        operands = [points[:, :, 0] * v * scale, points[:, :, 1] * v * scale, v * scale]
        (found,) = in_doubles(program, operands[: 3 if rational else 2], 2)
    certain = 0
    for k in range(0, len(points), 5):
        w = [Fraction(1)] * (degree + 1) if weights is None else [Fraction(x) for x in weights[k].tolist()]
        exact = [[comb(degree, i) * Fraction(x) * w[i] for i, x in enumerate(points[k, :, j].tolist())] for j in (0, 1)]
        exact.append([comb(degree, i) * x for i, x in enumerate(w)])
        (form,) = exactly(program, exact[: 3 if rational else 2])
        for value, bound, true in zip(found.values[k].tolist(), found.errors[k].tolist(), form, strict=True):
            assert abs(Fraction(value) - true) <= Fraction(bound)
            certain += abs(value) > bound
    assert certain > 20


def test_bounds_are_those_of_as_many_roundings_as_the_coefficients_went_through():
    numbers = np.random.default_rng(7)
    points, weights = numbers.uniform(0.5, 1, (400, 4, 2)), numbers.uniform(0.5, 1, (400, 4))
    with rounding("up"):
        operands = scaled_operands(points, weights)
        found = filtered(3, operands)
        assert found is not None
        rows = zip(operands[0][:, 1].tolist(), points[:, 1, 0].tolist(), weights[:, 1].tolist(), strict=True)
        farthest = max(Fraction(x) / (3 * Fraction(p) * Fraction(w)) - 1 for x, p, w in rows)
        needed = ceil(farthest * 2**52)
        form, *_ = in_doubles(plane_program(3, True), operands, needed)
        bounds = ordinates(form.values, form.errors).errors
    assert needed == 2
    assert (found.curvature.rows.errors >= bounds).all()


@pytest.mark.parametrize("mode", MODES)
def test_pieces_and_values_of_a_form_keep_to_their_bounds(mode):
    numbers = np.random.default_rng(2)
    c = numbers.uniform(-1, 1, (40, 8)) * 2.0 ** numbers.integers(-40, 40, (40, 8))
    errors = np.abs(c) * 2.0**-45
    t = numbers.uniform(0, 1, 40)
    with rounding(mode):
        rows = ordinates(c, errors)
        values, bounds = values_at(rows, np.arange(40), t)
    for k in range(40):
        s = Fraction(float(t[k]))
        # the worst form within the bounds: every coefficient off to the same side
        for off in (-1, 0, 1):
            exact = sum(
                (Fraction(float(c[k, i])) + off * Fraction(float(errors[k, i]))) * (1 - s) ** (7 - i) * s**i
                for i in range(8)
            )
            assert abs(Fraction(float(values[k])) - exact) <= Fraction(float(bounds[k]))


def test_what_is_not_certain_is_left():
    values = np.array([[1.0, -0.5, 1.0], [0.0, 1.0, 2.0], [1.0, np.nan, -1.0], [np.inf, 1, -1]])
    # what overflows has an infinite bound
    errors = np.where(np.isinf(values), np.inf, 1e-3)
    found, left = isolated(Bounded(values, errors))
    assert left.tolist() == [False, True, False, True]
    # of 1, none, −1 whatever the middle is there is one sign change
    assert found.row.tolist() == [2]
    double = Bounded(np.array([[1.0, -1.0, 1.0]]), np.full((1, 3), 1e-12))
    assert isolated(double)[1].tolist() == [True]


def expected(points, weights):
    degree = len(points) - 1
    w = None if weights is None else from_floats(weights.tolist())
    curve = Nurbs(degree, [0] * (degree + 1) + [1] * (degree + 1), from_floats(points.tolist()), w)
    found = campaign.exact(curve)  # `analyse` would go through a filter itself
    return [*found.inflections, *found.curvature_extrema]


def same_as_exact(points, weights=None, found=None):
    """Hold every answer against the exact one: how many curves there are, and how many went to exact arithmetic."""
    found = features_of_curves(points, weights) if found is None else found
    for k in range(len(points)):
        own = found.curve == k
        true = expected(points[k], None if weights is None else weights[k])
        assert found.kind[own].tolist() == [str(f.kind) for f in true]
        for low, high, feature in zip(found.low[own].tolist(), found.high[own].tolist(), true, strict=True):
            assert Fraction(low) <= feature.root <= Fraction(high)
    return len(points), len(found.exact)


@pytest.mark.parametrize(("degree", "rational"), [(2, True), (3, False), (3, True), (5, False)])
def test_answers_are_the_exact_ones(degree, rational):
    numbers = np.random.default_rng(degree)
    points = numbers.uniform(-9, 9, (150, degree + 1, 2))
    weights = numbers.uniform(0.5, 4, (150, degree + 1)) if rational else None
    count, exact = same_as_exact(points, weights)
    assert exact < count / 10


def test_answers_on_hostile_curves_are_the_exact_ones():
    for degree, rational in ((2, True), (3, False)):
        points, weights = hostile(degree, rational)
        same_as_exact(points[::2], None if weights is None else weights[::2])


def test_the_seam_of_a_closed_curve_is_a_knot():
    """Passed before: what changes its sign by a jump at the seam was in no answer, unless doubles did not suffice."""
    loop = [(2, -3), (-2, 2), (-1, -2), (6, -8), (2, -3)]
    assert features_of_curves([loop]) == features_of_curves([Nurbs(4, [0] * 5 + [1] * 5, loop)])
    assert features_of_curves([loop]).kind.tolist() == ["minimum", "maximum", "minimum", "maximum"]
    chance = random.Random(5)
    compared = [campaign.differing_arrays(*campaign.closed_arrays(chance, 40)) for _ in range(4)]
    assert [wrong for _, wrong in compared] == [[]] * 4
    assert sum(count for count, _ in compared) > 150


def test_symmetric_and_special_curves():
    arc = [(1, 0), (1, 1), (0, 1)]
    assert features_of_curves([arc], [[1, 1, 2]]).curve.tolist() == []
    bump, cusp, line = [(0, 0), (1, 2), (2, 0)], [(0, 0), (1, 1), (0, 1), (1, 0)], [(0, 0), (1, 1), (2, 2), (3, 3)]
    found = features_of_curves([bump])
    assert (found.kind.tolist(), found.exact.tolist()) == (["minimum"], [])
    assert found.low[0] <= 0.5 <= found.high[0]
    assert features_of_curves([cusp]).exact.tolist() == [0]
    same_as_exact(np.array([cusp, line], dtype=float))


def test_huge_numbers_are_made_small_by_powers_of_two():
    points = np.random.default_rng(4).uniform(-1, 1, (40, 4, 2))
    kinds = [features_of_curves(points * 2.0**e).kind.tolist() for e in (0, 900, -900)]
    assert kinds[0] == kinds[1] == kinds[2]
    assert len(features_of_curves(points * 2.0**900).exact) < 4


def test_stopping_early_keeps_what_was_done():
    points = np.random.default_rng(1).uniform(-9, 9, (50, 4, 2))
    whole, parts = features_of_curves(points), features_in_parts(points, at_once=20)
    first, second = next(parts), next(parts)
    upto = whole.curve < 40
    assert [*first.curve, *second.curve] == whole.curve[upto].tolist()
    assert [*first.low, *second.low] == whole.low[upto].tolist()


def test_what_is_no_batch_is_refused():
    with pytest.raises(ShapeError):
        features_of_curves([[0, 1], [2, 3]])
    with pytest.raises(ShapeError):
        features_of_curves(np.zeros((3, 4, 2)), np.ones((3, 3)))
    with pytest.raises(ShapeError, match="not an array"):
        features_of_curves([[(0, 0), (1, 1)], [(0, 0)]])
    for numbers in (np.zeros((1, 2, 2), dtype=complex), [[("0", "1"), ("1", "2")]], np.zeros((1, 2, 2), dtype=bool)):
        with pytest.raises(NumberError, match="of the type"):
            features_of_curves(numbers)


def test_one_bad_curve_does_not_stop_the_others():
    numbers = np.random.default_rng(8)
    points, weights = numbers.uniform(-9, 9, (12, 4, 2)), numbers.uniform(0.5, 4, (12, 4))
    whole = features_of_curves(points, weights)
    points[1, 2, 0], points[3, 0, 1], points[5], weights[6, 1] = np.nan, np.inf, -np.inf, np.nan
    weights[8], weights[9] = [1, -5, -5, 1], 0
    for at_once in (3, 100):
        parts = list(features_in_parts(points, weights, at_once=at_once))
        refused = {i: error for part in parts for i, error in part.refused.items()}
        assert {i: type(error) for i, error in refused.items()} == {
            1: NumberError, 3: NumberError, 5: NumberError, 6: NumberError, 8: WeightError, 9: WeightError
        }  # fmt: skip
        assert "points[1]" in str(refused[1])
        assert "weights[6]" in str(refused[6])
        good = ~np.isin(whole.curve, list(refused))
        for name in ("curve", "kind", "low", "high"):
            assert [x for part in parts for x in getattr(part, name).tolist()] == getattr(whole, name)[good].tolist()


def test_arrays_of_any_make_are_read_as_what_they_hold():
    points = np.round(np.random.default_rng(9).uniform(-9, 9, (20, 4, 2)), 2).astype(np.float32)
    double = points.astype(float)
    expected = features_of_curves(double)
    wide = np.zeros((20, 8, 4))
    wide[:, ::2, 1::2] = double
    swapped = np.asfortranarray(double)
    others = (points, double.astype(">f8"), wide[:, ::2, 1::2], swapped, double.astype(np.longdouble),
              double.astype(object), np.ma.array(double), double[::-1][::-1])  # fmt: skip
    for other in others:
        found = features_of_curves(other)
        assert all(np.array_equal(a, b) for a, b in zip(found[:5], expected[:5], strict=True))
        assert not found.refused
    whole = np.round(double * 100).astype(np.int16)
    assert features_of_curves(whole).low.tolist() == features_of_curves(whole.astype(float)).low.tolist()


def test_a_number_that_is_no_double_is_not_rounded():
    points = np.random.default_rng(9).integers(-9, 9, (4, 4, 2))
    good = features_of_curves(points)
    beyond, between, thirds = points.copy(), points.astype(np.longdouble), points.astype(object)
    beyond[2, 1, 1] = 2**53 + 1
    between[2, 1, 1] += np.longdouble(2) ** -60
    thirds[2, 1, 1] = Fraction(1, 3)
    huge = points.astype(object)
    huge[2, 1, 1] = 10**400
    hidden = np.ma.array(points.astype(float), mask=False)
    hidden.mask[2, 1, 1] = True
    for numbers in (beyond, between, thirds, huge, hidden):
        found = features_of_curves(numbers)
        if numbers is between and np.finfo(np.longdouble).nmant == 52:
            continue
        assert list(found.refused) == [2]
        assert isinstance(found.refused[2], NumberError)
        assert found.kind.tolist() == good.kind[good.curve != 2].tolist()
    beyond[2, 1, 1] = 2**54
    thirds[2, 1, 1] = Fraction(1, 4)
    assert not features_of_curves(beyond).refused
    assert not features_of_curves(thirds).refused


@pytest.mark.parametrize("mode", FLUSHED)
def test_a_processor_that_flushes_subnormal_numbers_is_not_believed(mode):
    points, weights = hostile(3, True)
    tiny = np.array([[(0, 0), (3, 2), (5, -4), (7, 1)]] * 2) * np.array([[[5e-324]], [[1]]])
    for p, w in ((points[33:42], weights[33:42]), (points[58:], weights[58:]), (tiny, None), (tiny + 0, weights[:2])):
        with rounding(mode):
            found = features_of_curves(p, w)
        assert found.curve.tolist() == features_of_curves(p, w).curve.tolist()
        same_as_exact(p, w, found)


def test_curves_with_zero_and_negative_weights():
    numbers = np.random.default_rng(3)
    points, weights = numbers.uniform(-9, 9, (30, 4, 2)), numbers.uniform(0.5, 4, (30, 4))
    weights[:10, 1] = 0
    weights[10:20] *= -1
    weights[20:30, 1] = -0.125
    same_as_exact(points, weights)


def test_programs_that_doubles_cannot_hold_are_refused():
    program = program_of(formula_of("g2"), Signature(PLANE, 2, False, (3,) * 3, (0, 0, 2), False))
    with pytest.raises(FormulaError, match="in doubles"):
        in_doubles(program, [np.ones((1, 4))] * 3, 2)
    steep = program_of(formula_of("g2"), signature(60, True))
    with pytest.raises(FormulaError, match="doubles"):
        in_doubles(steep, [np.ones((1, 61))] * 3, 2)


def test_the_front_door_loads_no_numpy():
    code = "import sys, exactspline; exactspline.analyse; print('numpy' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout == "False\n"
