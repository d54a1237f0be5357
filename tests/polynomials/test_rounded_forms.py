"""Rounded forms: what they say of signs and slopes is true of the form, wherever it is halved, and their errors are
bounds.
"""

import pickle
from random import Random

import pytest
from gmpy2 import mpq

from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.polynomials.cost import height_bits
from exactspline.polynomials.patch_forms import BITS, KEPT, PatchForm, RoundedForm, rounded


def drawn(chance, bits):
    m, n = chance.randint(1, 7), chance.randint(1, 7)
    return PatchForm.of_net([[chance.randint(-(2**bits), 2**bits) for _ in range(n + 1)] for _ in range(m + 1)])


def scale_of(one, exact):
    """The constant between a rounded form and the form itself, from their largest coefficients, within bounds."""
    k = max(range(len(exact.entries)), key=lambda k: abs(exact.entries[k]))
    x, y = mpq(int(one.entries[k])), mpq(int(exact.entries[k]))
    return sorted([(x - int(one.error)) / y, (x + int(one.error)) / y])


@pytest.mark.parametrize("bits", [2, 50, 64, 400])
def test_errors_are_bounds_on_every_box(bits):
    chance = Random(bits)
    for _ in range(30):
        form = drawn(chance, bits)
        one, box = rounded(form), UNIT
        for _ in range(25):
            direction, side = chance.randrange(2), chance.randrange(2)
            one, box = one.halves(direction)[side], box.halves(direction)[side]
            exact = form.part(box)
            if exact.is_zero:
                break
            assert isinstance(one, RoundedForm)
            low, high = scale_of(one, exact)
            assert 0 < low <= high
            for x, y in zip(one.entries, exact.entries, strict=True):
                ends = sorted([low * int(y), high * int(y)])
                assert ends[0] - int(one.error) <= int(x) <= ends[1] + int(one.error)
            assert one.sign in (None, exact.sign)
            for k in (0, 1):
                if one.slopes(k)[0] > 0 or one.slopes(k)[1] < 0:
                    assert exact.derivative(k).sign in (1, -1)
                    assert (one.slopes(k)[0] > 0) == (exact.slopes(k)[0] > 0)


@pytest.mark.parametrize("bits", [50, 64, 400])
def test_ranges_and_slopes_are_those_of_the_form_but_for_the_error(bits):
    """By the powers of two between both. Also where coefficients differ by less than the error."""
    chance = Random(bits)
    for spread in (0, bits // 2, bits - 40, bits):
        for _ in range(12):
            m, n = chance.randint(1, 4), chance.randint(0, 4)
            net = [[2**bits + chance.randint(-(2**spread), 2**spread) for _ in range(n + 1)] for _ in range(m + 1)]
            exact = PatchForm.of_net(net)
            one, shift = rounded(exact), height_bits(exact.entries) - BITS
            for _ in range(4):
                scale, error = mpq(2) ** -shift, int(one.error)
                bounds = [(one.range, exact.range, error)]
                bounds += [(one.slopes(k), exact.slopes(k), exact.degree[k] * error) for k in (0, 1)]
                for (low, high), (least, most), wide in bounds:
                    assert 0 <= scale * int(least) - int(low) <= 2 * wide
                    assert 0 <= int(high) - scale * int(most) <= 2 * wide
                direction, side = chance.randrange(2), chance.randrange(2)
                if one.error << KEPT > max(map(abs, one.range)):
                    break
                one, exact = (f.halves(direction)[side] for f in (one, exact))
                shift += exact.degree[direction]


def test_few_bits_are_exact_until_they_are_halved():
    """Small integers had an error of one unit of their own: half of the box x > 0 of this form was never excluded."""
    one = rounded(PatchForm.of_net([[1, 1], [2, 3]]))
    assert (one.error, one.sign) == (0, 1)
    assert max(one.entries).bit_length() == BITS
    assert [rounded(PatchForm.of_net([[1, 2**k]])).error for k in (BITS - 2, BITS - 1, BITS)] == [0, 0, 1]


def test_a_sign_that_the_error_hides_is_not_told():
    tiny = PatchForm.of_net([[1, 1], [1, 2**300]])
    assert tiny.sign == 1
    assert rounded(tiny).sign is None
    # it is computed once more where it is small
    one = rounded(tiny)
    for _ in range(400):
        one = one.halves(0)[0]
        if one.sign is not None:
            break
    assert one.sign == 1


def test_slopes_are_the_range_of_the_derivative():
    chance = Random(5)
    for _ in range(40):
        form = drawn(chance, 20)
        for k in (0, 1):
            assert form.slopes(k) == form.derivative(k).range


def test_combinations_and_copies_keep_their_errors():
    f, g = (rounded(PatchForm.of_net([[2**90 + k, -1], [5, 7]])) for k in (0, 1))
    assert f.combined(3, g, -2).error == 3 * f.error + 2 * g.error == 5
    assert f.combined(3, g.halves(0)[0], -2).error == 3 * 1 + 2 * 2 == f.halves(0)[0].combined(2, g, 3).error
    again = pickle.loads(pickle.dumps(f.halves(0)[1]))
    assert isinstance(again, RoundedForm)
    assert again.error >= 1
    assert rounded(PatchForm.of_net([[0, 0]])).sign == 0


@pytest.mark.parametrize("bits", [8, 50, 200, 900])
@pytest.mark.parametrize("width", [1, 12, 70])
def test_a_restriction_in_few_bits_is_the_exact_one_but_for_its_error(bits, width):
    """By one power of two for all coefficients; second differences, too."""
    chance = Random(bits * width)
    for _ in range(12):
        form, unit = drawn(chance, bits), mpq(1, 3 * 2**width)
        low = [mpq(chance.randint(0, 3 * 2**width - 1), 3 * 2**width) for _ in range(2)]
        box = Box(*(Interval(x, x + unit) for x in low))
        exact, one = form.part(box), rounded(form, box)
        k = max(range(len(exact.entries)), key=lambda k: abs(exact.entries[k]))
        # rounded to the nearest power of two times the common denominator
        bottom = (3 * 2**width) ** sum(form.degree)
        ratio = mpq(int(one.entries[k])) / mpq(int(exact.entries[k]), bottom)
        power = mpq(2) ** (ratio.numerator.bit_length() - ratio.denominator.bit_length())
        scale = min((power / 2, power, power * 2), key=lambda x: abs(x / ratio - 1))
        found = [(one, exact)]
        found += [(one.derivative(i).derivative(j), exact.derivative(i).derivative(j)) for i, j in ((0, 0), (0, 1))]
        for few, whole in found:
            for x, y in zip(few.entries, whole.entries, strict=True):
                assert abs(int(x) - scale * mpq(int(y), bottom)) <= int(few.error)
        assert one.sign in (None, exact.sign)


def test_ranges_of_combinations_hold_for_the_forms_themselves():
    """Errors of one sign have both where one form is subtracted."""
    chance, shift = Random(7), mpq(1) / 2**40
    for _ in range(30):
        nets = [[[chance.randint(2**99, 2**100 - 1) for _ in range(2)] for _ in range(3)] for _ in range(2)]
        forms = [PatchForm.of_net([*net[:2], [2**100 - 1] * 2]) for net in nets]
        own = [rounded(form) for form in forms]
        for a, b in ((1, -1), (-2, 3), (1, 2)):
            given, exact = own[0].combined(a, own[1], b), forms[0].combined(a, forms[1], b)
            assert int(given.range[0]) <= shift * int(exact.range[0])
            assert shift * int(exact.range[1]) <= int(given.range[1])
