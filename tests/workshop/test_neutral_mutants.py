"""Changes that are explained by their place: only those on which no answer can depend."""

import ast

import pytest

from workshop.mutation import mutants, neutral

SOURCE = """
def _check(cost, what):
    scaled = 3 * cost
    check_reach(scaled, lambda: what)

def _size(p):
    m, n = p.degree, 4
    return m * n

class _Kept:
    def cost(self, k):
        return 5 * k

    def used(self, k):
        return 6 * k

def answer(p, kept, digits):
    bound = p.degree + 7
    bits, least = 16, 8
    _check(bound * 9 + _size(p) + kept.cost(p), "a product")
    cost, other = 0, 10
    cost = kept.used(p) * 11
    cost += 12
    if not affords(cost):
        return other
    while True:
        with ctx.workprec(13 * bits):
            value = p.value(bits)
        if kept.used(value) > 14:
            return value, bound
        bits *= 2

def tried(p):
    for digits in (20, 21):
        with ctx.workprec(22 * digits):
            return p.value(digits)

def once(p, bits):
    bits = 15
    cost = 19 * bits
    check_reach(cost, lambda: "a product")
    with ctx.workprec(17 * bits):
        return p.value(bits), cost
"""


@pytest.fixture
def reasons(monkeypatch, tmp_path):
    """Of which constants in the source a change is neutral, and why."""
    (tmp_path / "engine.py").write_text(SOURCE)
    monkeypatch.setattr(mutants, "ROOT", tmp_path)
    for cached in (mutants.parsed, mutants.node_of, neutral._estimates):
        cached.cache_clear()
    found = {}
    for one in mutants.mutants("engine.py"):
        old, (_, _, new) = list(mutants.changes(mutants.node_of("engine.py", one.function)))[one.number]
        if isinstance(old, ast.Constant):
            found[old.value, new.value] = neutral.neutral(one)
    yield found
    for cached in (mutants.parsed, mutants.node_of, neutral._estimates):
        cached.cache_clear()


def test_what_only_an_estimate_uses_is_neutral(reasons):
    """Not what an answer uses besides (7, 8, 6), nor a limit with which a value is compared (14, 19)."""
    estimates = {old for (old, _), why in reasons.items() if why == neutral.ESTIMATE}
    assert estimates == {3, 4, 5, 9, 11, 12}


def test_a_precision_is_neutral_where_a_loop_lets_it_grow(reasons):
    """Not a factor 1, with which the loop would not end, nor a precision that does not grow (15, 17)."""
    precisions = {change for change, why in reasons.items() if why == neutral.PRECISION}
    assert precisions == {(16, 17), (16, 15), (13, 14), (13, 12), (2, 3), (22, 23), (22, 21)}
