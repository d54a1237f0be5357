"""What is true of common zeros whatever the polynomials: the same by boxes and by elimination, under exchange of the
parameters, reflection and restriction; multiplicities are dimensions of local algebras.
"""

import pickle
from itertools import cycle, product
from random import Random

import pytest
from flint import arb_poly, ctx, fmpz_poly
from gmpy2 import mpq

from exactspline import Root
from exactspline.bivariate import common_zeros as solver
from exactspline.bivariate.common_zeros import Column, common_zeros, multiplicity, projected, zeros_of
from exactspline.errors import ReachError
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.polynomials.certified_boxes import Isolated, Isolation, certified, contracting, isolate, preconditioned
from exactspline.polynomials.patch_forms import PatchForm
from exactspline.polynomials.two_parameters import S, T, as_form, enclosed
from exactspline.roots import vanishing
from exactspline.roots.of_polynomials import as_splines, ball, distinct, exactly, roots_in
from tests.campaigns.common_zeros import FAMILIES
from tests.support.local_algebra import local_dimension


def pairs(seed, count):
    """Pairs without a common factor, of all families of the campaign."""
    for k, family in zip(range(count), cycle(FAMILIES.values())):
        f, g = family(Random(f"{seed} {k}"))
        if f and g and f.gcd(g).total_degree() == 0:
            yield f, g


def places(polynomials, sides=UNIT, **more):
    return [zero.place for zero in common_zeros(polynomials, sides, **more)]


@pytest.mark.parametrize("seed", range(3))
def test_multiplicities_are_dimensions_of_local_algebras(seed):
    found = []
    for f, g in pairs(seed, 50):
        for zero in common_zeros([f, g], UNIT):
            if zero.exact:
                found.append(multiplicity(zero, f, g))
                assert found[-1] == local_dimension(f, g, zero.exact)
    assert {1, 2, 3, 4} <= {*found}


@pytest.mark.parametrize("seed", range(4))
def test_a_projection_says_where_the_zero_is(seed):
    """The value of z is a root of the factor, s is a polynomial in it, and no other zero has it."""
    for f, g in pairs(f"projection {seed}", 15):
        for zero in common_zeros([f, g], UNIT):
            slope, minimal, times, s, power = projected(zero, f, g)
            assert 1 <= power <= times
            with ctx.workprec(600):
                x, y = ball(zero.s, 150), ball(zero.t, 150)
                z = y + slope * x
                assert minimal(z).contains(0)
                assert (arb_poly(s)(z) - x).contains(0)
            assert minimal.factor()[1] == [(minimal, 1)]


@pytest.mark.parametrize("seed", range(4))
def test_zeros_under_exchange_reflection_and_other_multiples(seed):
    for f, g in pairs(f"law {seed}", 6):
        found = places([f, g])
        assert found == sorted(found)
        assert places([-3 * g, 5 * f]) == found
        assert sorted((s, t) for t, s in places([p.compose(T, S) for p in (f, g)])) == found
        turned = common_zeros([p.compose(1 - S, 1 - T) for p in (f, g)], UNIT)
        assert len(turned) == len(found)
        for zero, (s, t) in zip(turned[::-1], found, strict=True):
            (a, b), (c, d) = zero.box(20)
            for low, high, x in ((a, b, s), (c, d, t)):
                assert 1 - high - mpq(1, 10**20) <= x <= 1 - low + mpq(1, 10**20)
        halves = [Interval(mpq(0), mpq(2, 5)), Interval(mpq(2, 5), mpq(1))]
        parts = {place for first in halves for second in halves for place in places([f, g], Box(first, second))}
        assert sorted(parts) == found
        assert places([f, g, f * (S + 2) + g * (T - 3)]) == found
        assert places([f * f, g, f * (S + 2)]) == found
        assert places([f, g], also=[(S + T - 1) * f + g, S + T + 1 - 9 * (S - T) ** 2]) == [
            place for place in found if not vanishing.is_certainly_not_zero(S + T + 1 - 9 * (S - T) ** 2, *place)
        ]


@pytest.mark.parametrize("seed", range(4))
def test_elimination_finds_what_boxes_find(seed, monkeypatch):
    """Without boxes, and with boxes alone: what these leave open contains the rest."""
    for f, g in pairs(f"route {seed}", 20):
        found = places([f, g])
        forms = [as_form(p) for p in (f, g)]
        by_boxes = isolate(forms)
        for place in found:
            boxes = [zero.region for zero in by_boxes.zeros] + by_boxes.undecided
            inside = [box for box in boxes if all(low <= x <= high for x, (low, high) in zip(place, box, strict=True))]
            assert inside
        for zero in by_boxes.zeros:
            own = [
                place
                for place in found
                if all(low <= x <= high for x, (low, high) in zip(place, zero.region, strict=True))
            ]
            assert len(own) <= 1
            again = Isolated(zero.forms, zero.region, zero.at)
            assert all(again.refine(bits).longest <= mpq(1, 1 << bits) for bits in range(12))
            for place in own:
                box = zero.refine(50)
                assert box.longest <= mpq(1, 1 << 50)
                assert all(low <= x <= high for x, (low, high) in zip(place, box, strict=True))
        halves = [Interval(mpq(0), mpq(1, 2)), Interval(mpq(1, 2), mpq(1))]
        quarters = [Box(*sides) for sides in product(halves, halves)]
        with monkeypatch.context() as patch:
            patch.setattr(solver, "isolate", lambda *_, own=quarters: Isolation([], list(own)))
            assert places([f, g]) == found


def test_the_parts_of_a_zero_say_the_same():
    """Of zeros in boxes, of elimination, on the border, and given: numbers, boxes, forms that vanish there."""
    sides = Box(Interval(mpq(1), mpq(3)), Interval(mpq(-1), mpq(0)))
    p, q = (S - 1) ** 2 - 2, (T + 1) ** 2 * 3 - 1
    kinds = {
        "in a box": [p, q],
        "multiple": [p, q * q],
        "on the border": [p, T + 1],
        "rational": [2 * S - 5, 3 * T + 1],
    }
    for name, polynomials in kinds.items():
        (zero,) = common_zeros(polynomials, sides)
        again = solver.CommonZero.at(sides, zero.place)
        for one in (zero, again, pickle.loads(pickle.dumps(zero))):
            s, t = one.place
            assert (one.s, one.t) == (s, t)
            x, y = one.local
            assert [side.low <= a <= side.high for side, a in zip(sides, (s, t), strict=True)] == [True, True]
            assert one.is_inside == (name != "on the border")
            for bits in (3, 60):
                box = one.refine(bits)
                assert box.longest <= mpq(1, 1 << bits)
                assert all(low <= a <= high for a, (low, high) in zip((x, y), box, strict=True))
            for digits in (1, 30):
                box = one.box(digits)
                assert box.longest <= mpq(1, 10**digits)
                assert all(low <= a <= high for a, (low, high) in zip((s, t), box, strict=True))
            assert one.is_at(zero)
            local = [f.compose(2 * S + 1, T - 1) for f in polynomials]
            assert all(one.is_zero_of(as_form(f)) for f in local)
            assert not one.is_zero_of(as_form(local[0] * 10**40 + 1))
        assert (zero.exact is None) == (name != "rational")
    assert zero.exact == (mpq(5, 2), mpq(-1, 3))
    for k in (0, 1):
        (fresh,) = zeros_of([as_form(2 * S * S - 1), as_form(3 * T * T - 1)]).zeros
        assert (fresh.s, fresh.t)[k].minimal_polynomial() == [-1, 0, 2 + k]
        assert fresh._number(k) == fresh.place[k]
    assert repr(zero) == "<common zero near 2.500000 and -0.333333>"


def test_points_of_columns():
    """Over ±√2/2 there are two numbers t each, of which one is in [0, 1] over both."""
    minimal = fmpz_poly([-1, 0, 2])
    column = Column.of([(3 * T - 1) * (T - S) ** 2, (3 * T - 1) * (T - S) * (T + S + 2)], minimal)
    assert (column.degree, column.zeros.degree) == (2, 2)
    low, high = (exactly(x) for x in roots_in(minimal, mpq(-1), mpq(1)))
    assert len(column.candidates) == 2
    assert [[column.contains(s, t) for t in column.candidates] for s in (low, high)] == [[True, False], [True, True]]
    assert [column.sign(high, x) for x in (mpq(0), mpq(1, 3), mpq(1, 2), mpq(1))] == [1, 0, -1, 1]
    assert column.may_be_in(high, Interval(mpq(2, 5), mpq(1, 2)))  # two zeros: signs do not tell
    single = Column.of([(T - S) ** 2, (T - S) * (T + S + 2)], minimal)
    assert [single.may_be_in(high, Interval(mpq(a), mpq(b))) for a, b in (("0", "7/10"), ("7/10", "1"))] == [
        False,
        True,
    ]
    assert Column.of([S * T + 1, S * T + 2], minimal).candidates == []


# ---- values at numbers


def test_values_that_vanish_and_nearly_vanish():
    """Against balls of 3000 bits, for rational and irrational numbers on either side."""
    (s,) = roots_in(fmpz_poly([-1, 0, 2]), mpq(0), mpq(1))
    (t,) = roots_in(fmpz_poly([-1, 0, 0, 3]), mpq(0), mpq(1))
    numbers = (s, t, mpq(1, 3), mpq(2, 5))
    tiny = 10**250
    for x in numbers:
        for y in numbers:
            p, q = (_vanishing(one, variable) for one, variable in ((x, S), (y, T)))
            for f in (p * (T + 3), q * (S + 1), p * (S - T) + q * (T + 5), p * T + q * S):
                assert vanishing.vanish_at([f], x, y)
                assert not vanishing.is_certainly_not_zero(f, x, y)
                assert not vanishing.vanish_at([f, tiny * f + 1], x, y)
                assert not vanishing.vanish_at([tiny * f - 1], x, y)
            assert vanishing.vanish_at([S * 0, p], x, y)
            for f in (S + T - 1, 3 * S - 1, 5 * T - 2, S * T - 7):
                with ctx.workprec(3000):
                    value = enclosed(f, *(ball(one, 500) for one in (x, y)))
                assert vanishing.vanish_at([f], x, y) is value.contains(0)
                assert vanishing.is_certainly_not_zero(f, x, y) is not value.contains(0)
    assert vanishing.vanish_at([2 * S**2 * T**2 - 1 + 2 * S * (T - S)], s, s) is False
    assert vanishing.vanish_at([S - T, 2 * S * T - 1], s, s)


def _vanishing(x, variable):
    if isinstance(x, Root):
        return sum(c * variable**k for k, c in enumerate(x.minimal_polynomial()))
    return int(x.denominator) * variable - int(x.numerator)


def test_a_value_below_its_bound_is_zero(monkeypatch):
    """Where balls alone decide: the bound of Liouville is reached from the shortest precision on."""
    (s,) = roots_in(fmpz_poly([-1, 0, 2]), mpq(0), mpq(1))
    (t,) = roots_in(fmpz_poly([-1, 0, 8]), mpq(0), mpq(1))
    for shortest in (8, 64, 512):
        monkeypatch.setattr(vanishing, "SHORTEST", shortest)
        assert vanishing.vanish_at([S - 2 * T], s, t)
        assert vanishing.vanish_at([(S - 2 * T) * (S + T + 1) ** 3], s, t)
        assert not vanishing.vanish_at([(S - 2 * T) * 10**90 + 1], s, t)
        assert not vanishing.vanish_at([S * T * 4 - 1 + (S - T) * (S + T)], s, t)
    monkeypatch.setattr(vanishing, "LONGEST", 512)
    with pytest.raises(ReachError, match="vanishes at two irrational numbers"):
        vanishing.vanish_at([(S - 2 * T) * (S + 10**400 * T + 1) ** 3], s, t)


def test_numbers_in_intervals():
    p = fmpz_poly([0, -1, 0, 4]) * fmpz_poly([-1, 0, 2])
    roots = roots_in(p, mpq(-1), mpq(1, 2))
    assert [exactly(x) for x in roots[1:]] == [mpq(-1, 2), 0, mpq(1, 2)]
    assert roots[0].minimal_polynomial() == [-1, 0, 2]
    assert [len(roots_in(p, mpq(a), mpq(b))) for a, b in ((-1, 1), (0, 1), (1, 2))] == [5, 3, 0]
    assert roots_in(fmpz_poly([]), mpq(0), mpq(1)) == []
    assert len(roots_in(p, mpq(0), mpq(1), whole=True)) == 3
    highest = roots_in(p, mpq(3, 5), mpq(1))
    every = distinct([mpq(1), *roots, *highest, mpq(0), *highest])
    assert every == [*map(exactly, roots), *highest, 1]
    assert [isinstance(x, Root) for x in every] == [True, False, False, False, True, False]
    one, other = as_splines([p, fmpz_poly([3])], mpq(-1), mpq(2))
    assert one.degree == other.degree == 5
    assert [one(x) * 3 for x in (-1, 0, 1, 2)] == [int(p(x)) * other(x) for x in (-1, 0, 1, 2)]
    assert other(2) > 0


# ---- boxes


@pytest.mark.parametrize("seed", range(30))
def test_a_preconditioned_pair_has_a_diagonal_jacobian(seed):
    """Estimated from the corners, with positive entries; its zeros are those of the pair."""
    draw = Random(seed)
    pair = [PatchForm.of_net([[draw.randint(-9, 9) for _ in range(3)] for _ in range(3)]) for _ in range(2)]
    found = preconditioned(*pair)
    (a, b), (c, d) = (_slopes(f) for f in pair)
    if a * d == b * c:
        assert found is None
        return
    size = abs(a * d - b * c)
    assert [_slopes(g) for g in found] == [(size, 0), (0, size)]
    for x, y in ((mpq(1, 3), mpq(2, 5)), (mpq(2), mpq(-1))):
        f, g = (p.value(x, y) for p in pair)
        sign = 1 if a * d > b * c else -1
        assert [p.value(x, y) for p in found] == [sign * (d * f - b * g), sign * (a * g - c * f)]


def _slopes(f):
    low, up, right, top = map(int, f.corners)
    return right + top - low - up, up + top - low - right


@pytest.mark.parametrize("seed", range(60))
def test_pairs_contract_where_the_bounds_say_so(seed):
    """Exactly where the derivatives are as dominant as Krawczyk's operator needs."""
    draw = Random(seed)
    sizes = [(1, 0), (4, 1), (8, 1), (12, 2)][seed % 4]
    net = [
        [[sizes[0] * (i, j)[k] + draw.randint(-sizes[1], sizes[1]) for j in range(3)] for i in range(3)] for k in (0, 1)
    ]
    forms = [PatchForm.of_net(own) for own in net]
    if seed % 4 == 0:
        forms = [PatchForm.of_net([[(i, j)[k] for j in range(2)] for i in range(2)]) for k in (0, 1)]
    holds = True
    for k, form in enumerate(forms):
        own, other = (tuple(map(int, form.derivative(k if own else 1 - k).range)) for own in (True, False))
        wide = own[1] - own[0] + 2 * max(abs(x) for x in other)
        holds = holds and own[0] > 0 and 4 * wide <= 3 * (own[0] + own[1])
    assert (contracting(forms) is not None) is holds


def test_a_certified_box_has_its_zero_inside():
    """Not on its border, where a box beside it would have the same one."""
    quarter = mpq(1, 4)
    for x, is_certified in ((mpq(0), True), (quarter, False), (mpq(1, 3), True), (mpq(7, 4), False), (mpq(2), False)):
        forms = tuple(as_form(p).elevated((1, 1)) for p in (int(x.denominator) * S - int(x.numerator), 3 * T - 2))
        box = Box(Interval(quarter * 2, quarter * 6), Interval(mpq(1, 3), mpq(1)))
        expected = is_certified and quarter < x
        assert (certified(forms, box) is not None) is expected
    first, second = (as_form(p).elevated((1, 1)) for p in (2 * S - 1, 2 * T - 1))
    for pair in ((first, second), (second, first), (first, as_form(1 - 2 * T).elevated((1, 1)))):
        region = certified(pair, UNIT)
        assert region is not None
        assert region.contains(UNIT)


def test_what_several_forms_leave_out():
    """The last ones only exclude; a third one, whose gradient is not that of the first, helps."""
    f, g, h = (as_form(p) for p in ((2 * S - 1) * (3 * T - 1), (2 * S - 1) * (T + 2), 5 * S - 2 * T - 1))
    found = zeros_of([f, h], not_positive=[as_form(4 * S - 1)])
    assert [zero.exact for zero in found.zeros] == []
    assert len(zeros_of([f, h]).zeros) == 2
    assert sorted(zero.exact for zero in zeros_of([f, h]).zeros) == [(mpq(1, 3), mpq(1, 3)), (mpq(1, 2), mpq(3, 4))]
    assert [zero.exact for zero in zeros_of([g, f, h]).zeros] == [(mpq(1, 2), mpq(3, 4))]
    assert [zero.exact for zero in zeros_of([f, h], also=[as_form(2 * S - 1)]).zeros] == [(mpq(1, 2), mpq(3, 4))]


def test_points_that_differ_in_one_number_are_two():
    """By less than boxes of 400 bits show."""
    far = 10**150
    one, other = common_zeros([2 * S * S - 1, (3 * T - 1) * (3 * far * T - far - 1)], UNIT)
    for first, second in ((one, other), (other, one)):
        assert not first.is_at(second)
        assert first.is_at(first)


def test_a_value_that_is_all_but_zero_at_an_irrational_and_a_rational_number():
    (s,) = roots_in(fmpz_poly([-1, 0, 2]), mpq(0), mpq(1))
    assert vanishing.is_certainly_not_zero(10**300 * (2 * S * S - 1) + 3 * T, s, mpq(1, 3))
    assert vanishing.is_certainly_not_zero(10**300 * (2 * T * T - 1) + 3 * S, mpq(1, 3), s)
