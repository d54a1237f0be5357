"""Symbols are typography: no verdict depends on how a formula prints."""

import random

import pytest

from exactspline import claims, decide, formula_of
from exactspline.papers import all_formulas
from exactspline.symbolic import factorization, reduction
from exactspline.symbolic.assumptions import zero_free
from exactspline.tables import jets_for
from exactspline.verification import generic_proof
from tests.support.claims import stated
from tests.support.sampled import sample

#: Kinds whose proofs ask for factors; degrees only where a reduction decides.
CLAIMS = sample(
    [
        claim
        for claim in claims()
        if claim.kind in ("identity", "zero set", "same surface", "square class")
        or (claim.kind == "degree" and claim.measure != "nominal")
    ],
    30,
)


def forget():
    """What was computed under other symbols."""
    for module in (generic_proof, reduction, factorization):
        for function in vars(module).values():
            if hasattr(function, "cache_clear"):
                function.cache_clear()


def empty():
    return dict.fromkeys(all_formulas(), "")


def alike():
    return dict.fromkeys(all_formulas(), formula_of("D1_squared").symbol)


def permuted():
    names = list(all_formulas())
    symbols = [all_formulas()[name].symbol for name in names]
    random.Random(7).shuffle(symbols)
    return dict(zip(names, symbols, strict=True))


def disguised():
    return {"f2": formula_of("D1_squared").symbol}


@pytest.fixture(scope="module")
def honest():
    forget()
    return [decide(claim).verdict for claim in CLAIMS]


@pytest.mark.parametrize("symbols", [empty, alike, permuted, disguised])
def test_no_verdict_changes_with_the_symbols(symbols, honest, monkeypatch):
    for name, symbol in symbols().items():
        monkeypatch.setattr(all_formulas()[name], "symbol", symbol)
    forget()
    try:
        assert [decide(claim).verdict for claim in CLAIMS] == honest
    finally:
        forget()


def test_a_disguise_does_not_take_away_zeros(monkeypatch):
    """f2 under the symbol of ‖D1‖²: the quotient f2² / f2 prints as what has no zero, and has some."""
    monkeypatch.setattr(formula_of("f2"), "symbol", formula_of("D1_squared").symbol)
    forget()
    try:
        false = stated("zero set", curve="plane", formulas=("f0_g0", "g0"), assumes=("w", "γ′"))
        assert "‖D1‖²" in str(generic_proof.factor_of("f0_g0", "g0", 2))
        assert false.prove()[1].verdict == "REFUTED"
    finally:
        forget()


def test_assumptions_are_found_by_the_polynomial_whatever_its_constant():
    c = jets_for(("g0",), 2)
    for name, free in (("D1_squared", "γ′"), ("f2", None)):
        value = formula_of(name)(c)
        jet = factorization.Jet(value.ring, value.top * -3)
        found = zero_free(jet)
        assert (found and found.name) == free
