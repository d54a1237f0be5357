"""What claims assume, one by one: where it holds all formulas exist; where one is dropped there is a
curve on which one does not.
"""

from functools import cache

import pytest

from exactspline import Nurbs, Verdict, claims, example, examples, formula_of
from exactspline.language.kinds import CURVE, PAIR, SPACE, kind_of
from exactspline.readings import JetReading
from exactspline.symbolic.assumptions import ASSUMPTIONS, assumption, zero_free
from exactspline.symbolic.factorization import named_by
from exactspline.verification import phrases as say
from exactspline.verification.evaluation import Evaluation
from exactspline.verification.evidence import Fact, Said
from tests.support.sampled import sample

SEGMENT, PLANE_SEGMENT = [(0, 0, 0), (1, 0, 1), (2, 2, 0), (3, 1, 2)], [(0, 0), (1, 0), (2, 2), (3, 1)]


def chain(*segments, weights=None):
    """Cubic segments, each over an interval of its own."""
    knots = [t for t in range(len(segments) + 1) for _ in range(4)]
    return Nurbs(3, knots, [p for segment in segments for p in segment], weights)


WEIGHTS = [1, 2, 1, 3, 3, 1, 2, 1]
#: On one segment at least they stand still, are straight or plane, or lie in one plane with their moved copy.
SPECIAL = [
    chain(SEGMENT, [(3, 1, 2)] * 4),
    chain(SEGMENT, [(3, 1, 2)] * 4, weights=WEIGHTS),
    chain(SEGMENT, [(3, 1, 2), (4, 1, 3), (5, 1, 4), (6, 1, 5)]),
    chain(SEGMENT, [(3, 1, 2), (4, 1, 3), (5, 2, 4), (6, 5, 5)], weights=WEIGHTS),
    chain([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)], weights=WEIGHTS[:4]),
    Nurbs(1, [0, 0, 1, 1], [(0, 0, 0), (1, 1, 1)]),
    chain(PLANE_SEGMENT, [(3, 1)] * 4),
    chain(PLANE_SEGMENT, [(3, 1)] * 4, weights=WEIGHTS),
    chain(PLANE_SEGMENT, [(3, 1), (4, 1), (5, 1), (7, 1)]),
]
CURVES = [*SPECIAL, *map(example, sample(list(examples("curves")), 8))]
#: Claims with values on single curves; of an iso-curve the check itself asks whether it exists.
CHECKED = [
    claim
    for claim in claims()
    if any(not each.everywhere for each in claim.assumes)
    and claim.kind in ("identity", "vanishing", "same surface", "zero set", "square class", "iso-curve")
    and not kind_of(claim.curve).adjoins_roots
]


#: What says that something does not exist.
ABSENT = (say.no_generator, say.undefined, say.undefined_there)


@cache
def evaluated(i):
    return Evaluation(CURVES[i])


def does_not_exist(claim, own):
    """Why a formula of the claim does not exist on a curve: 0/0, or a ruled surface without rulings."""
    if gone := claim.missing(own.argument(claim.curve)):
        return gone
    found = claim.check(own)
    nothing = found.verdict in (Verdict.VACUOUS, Verdict.INAPPLICABLE)
    gone = found.computed in (Fact.NO_SIDE, Fact.NO_FACTOR, Fact.NOT_HERE, Fact.NO_GENERATOR)
    said = isinstance(found.computed, Said) and found.computed.phrase in ABSENT
    return found.computed if nothing and (gone or said) else None


def findings(claim):
    """Curve by curve what is not there, and the assumptions that fail on a whole segment."""
    for i, curve in enumerate(CURVES):
        if claim.applies_to(curve.dimension, curve.polynomial):
            own = evaluated(i)
            with named_by(claim.source_paper):
                failing = [each.name for each in claim.assumes if own.failing(claim.curve, [each])]
                yield does_not_exist(claim, own), [name for name in failing if name.endswith("≢ 0")], failing


@pytest.mark.parametrize("claim", CHECKED, ids=lambda claim: claim.key)
def test_what_is_assumed_is_enough_and_no_more_than_needed(claim):
    rows = list(findings(claim))
    for gone, somewhere, failing in rows:
        assert failing or not gone
        assert gone or not somewhere
    dropped = {name for gone, somewhere, _ in rows if gone for name in somewhere}
    assert dropped == {each.name for each in claim.assumes if not each.everywhere}


def test_what_every_other_claim_speaks_of_exists_where_its_assumptions_hold():
    others = [
        claim
        for claim in claims()
        if claim.kind in ("identity", "vanishing", "same surface", "zero set", "square class")
        and claim.curve != "table"
        and all(each.everywhere for each in claim.assumes)
        and not kind_of(claim.curve).adjoins_roots
    ]
    assert len(others) > 60
    for i, curve in enumerate(SPECIAL):
        for claim in others:
            own = evaluated(i)
            if claim.applies_to(curve.dimension, curve.polynomial) and claim.missing(own.argument(claim.curve)):
                assert own.failing(claim.curve, claim.assumes), claim.key


def test_assumptions_speak_of_the_curve_that_they_name():
    pair = JetReading(1).argument(PAIR, 3)
    assert assumption("w").polynomial(pair) == pair.first.w
    assert assumption("w̄").polynomial(pair) == pair.second.w
    assert assumption("γ′").polynomial(pair) == formula_of("D1_squared")(pair.first)
    assert assumption("γ̄′").polynomial(pair) == formula_of("D1_squared")(pair.second)
    name = "[γ′ γ̄′ γ−γ̄] ≢ 0"
    assert assumption(name).polynomial(pair) == formula_of("bisector_determinant_symmetric")(pair)
    space = JetReading(2).argument(SPACE, 3)
    bend = formula_of("binormal_form")(space)
    assert assumption("γ′×γ″").polynomial(space) == sum((x * x for x in bend), space.w.constant(0))
    assert {each.everywhere for name, each in ASSUMPTIONS.items() if "≢" in name} == {False}


def test_what_has_no_zero_is_what_divides_a_polynomial_without_one():
    plane = JetReading(1).argument(CURVE, 2)
    assert zero_free(formula_of("D1_squared")(plane)).name == "γ′"
    assert zero_free(plane.w).name == "w"
    assert zero_free(plane.p[0]) is None
    assert zero_free(plane.w, [assumption("γ′")]) is None
    assert zero_free(plane.w, [assumption("γ′ ≢ 0")]) is None
    space = JetReading(2).argument(SPACE, 3)
    assert zero_free(assumption("γ′×γ″").polynomial(space)).name == "γ′×γ″"
    assert zero_free(formula_of("D1_squared")(JetReading(1).argument(SPACE, 3))).name == "γ′"
    polynomial = JetReading(1).argument(CURVE, 2, polynomial=True)
    assert zero_free(formula_of("D1_squared")(polynomial)).name == "γ′"
    assert zero_free(polynomial.w).name == "γ′"
