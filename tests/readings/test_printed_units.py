"""Zeros and ones left out where formulas are written: the value stays, also that of random trees."""

import random
from operator import add, mul, neg, sub
from types import SimpleNamespace

import pytest
from gmpy2 import mpq

from exactspline.readings.printing import Operation, print_text, without_units
from exactspline.readings.tree import Node, nodes
from exactspline.verification.divisors import Evaluation


def random_tree(chance, depth):
    """Sums, differences, products and negatives of x, y, z and of small numbers, which are often 0, 1 or −1."""
    if depth == 0:
        number = chance.random() < 0.5
        value = chance.choice([0, 0, 1, -1, 2]) if number else chance.choice("xyz")
        return Node(Operation.NUMBER if number else Operation.LEAF, value=value)
    operation = chance.choice([add, sub, mul, mul, neg])
    parts = [random_tree(chance, chance.randrange(depth)) for _ in range(1 if operation is neg else 2)]
    return operation(*parts)


@pytest.mark.parametrize("seed", range(5))
def test_the_value_stays(seed):
    chance = random.Random(seed)
    for _ in range(300):
        tree = random_tree(chance, 5)
        place = SimpleNamespace(**{name: mpq(chance.randint(-99, 99), 7) for name in "xyz"})
        assert Evaluation(place)(without_units(tree)) == Evaluation(place)(tree), print_text(tree)


@pytest.mark.parametrize("seed", range(5))
def test_no_zero_is_left_in_a_sum_and_no_one_in_a_product(seed):
    chance = random.Random(seed)
    for _ in range(300):
        for node in nodes(without_units(random_tree(chance, 5))):
            numbers = [part.value for part in node.args if part.op is Operation.NUMBER]
            if node.op is Operation.TIMES:
                assert not {0, 1, -1} & set(numbers)
            elif node.op in (Operation.PLUS, Operation.MINUS):
                assert 0 not in numbers


def test_shared_parts_stay_shared_and_what_has_no_units_is_itself():
    x, y = (Node(Operation.LEAF, value=name) for name in "xy")
    part = x * 1 + y
    cleaned = without_units(part * part)
    assert cleaned.args[0] is cleaned.args[1]
    plain = x * y + y
    assert without_units(plain) is plain
