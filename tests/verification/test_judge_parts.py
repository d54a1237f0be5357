"""Parts of the judge held against what they mean, found by changes of the code that no other test noticed."""

from dataclasses import replace
from itertools import cycle

import pytest
from gmpy2 import mpq

from exactspline import Nurbs, TensorSpline, Verdict, analyse, claims, decide, example, formula_of, zeros
from exactspline.errors import ClaimError
from exactspline.language import Vector, formula, join
from exactspline.language.kinds import CURVE
from exactspline.language.operand import Parameter
from exactspline.language.ruled import split
from exactspline.numbers.intervals import Interval
from exactspline.readings.degree import Degree
from exactspline.readings.jet import JetFraction, RationalJetReading
from exactspline.symbolic.assumptions import Assumption
from exactspline.verification import phrases as say
from exactspline.verification.claims import stands_at
from exactspline.verification.decision import Equation, Outcome, decide_identity
from exactspline.verification.evaluation import Evaluation, fails_on_surface
from exactspline.verification.evidence import Fact, HeldOn
from exactspline.verification.kinds import examples
from exactspline.verification.kinds.contact import partial_derivative, rank_of
from exactspline.verification.kinds.degree import agreed_degree
from exactspline.verification.kinds.invariance import MAPS, image_of_point
from exactspline.verification.verdict import Finding, sampled


@pytest.mark.parametrize(
    ("left", "right", "verdict"),
    [
        ((1, 2), (3, 4), Verdict.VERIFIED),
        ((3, 4), (1, 2), Verdict.REFUTED),
        ((2, 3), (1, 2), Verdict.REFUTED),
        ((1, 3), (2, 4), Verdict.UNDECIDED),
        ((1, 4), (2, 3), Verdict.UNDECIDED),
        ((2, 3), (1, 4), Verdict.UNDECIDED),
    ],
)
def test_enclosures_that_overlap_decide_nothing(monkeypatch, left, right, verdict):
    """Passed by a mutant: an enclosure around another one is "not better"."""
    (claim,) = claims("O1-g2-curvature_squared_derivative")
    enclosures = cycle([left, right])
    monkeypatch.setattr(examples, "_condition", lambda form, root: Interval(*map(mpq, next(enclosures))))
    own = Evaluation(example("cubic_s"))
    assert claim.examine(own.curve, own).verdict == verdict


def jets(order=2, dimension=2):
    return RationalJetReading(order).argument(CURVE, dimension)


def test_the_witness_of_an_identity_is_what_differs():
    def told(left, right, factor="1"):
        found = Equation(left, right, factor).decide(jets(3))
        return found.verdict, found.computed, found.witness

    third = formula("a test", on="curve")(lambda c: join(*c.p, c.w))
    other = formula("a test", on="curve")(lambda c: join(*c.p, c.w * 2))
    assert told(formula_of("f2"), formula_of("D1")) == (
        Verdict.REFUTED,
        say.components(1, 2),
        Fact.OTHER_NUMBER_OF_COMPONENTS,
    )
    assert told(third, other) == (Verdict.REFUTED, Fact.NOT_IDENTICAL, say.component_differs(3))
    nothing = formula("a test", on="curve")(lambda c: c.w - c.w)
    found = decide_identity(formula_of("f2")(jets(3)), formula_of("f2")(jets(3)), (jets(3).w, nothing(jets(3))))
    assert found.outcome is Outcome.NO_FACTOR


@pytest.mark.parametrize(
    ("key", "begins"),
    [
        ("C53a-tangent_developable-tangent_developable_reduced", "ζ = w λ"),
        ("C54a-rectifying_developable-rectifying_developable_reduced", "ζ = λ"),
        ("C62e-point_bisector_direct_x-point_bisector_direct_z", "ζ = 1/2·w⁻²·("),
    ],
)
def test_ruling_parameters_differ_by_a_shift_where_directrices_do(key, begins):
    (claim,) = claims(key)
    factor = str(decide(claim).factor)
    assert factor.startswith(begins)
    assert (")⁻¹ + (" in factor) == (begins[-1] == "(")


def test_a_derivative_by_a_variable_is_that_of_the_quotient():
    """By the quotient rule, up to the square of the denominator: compared with differences of values."""
    x, y = jets().p
    w = jets().w
    value = (x * x * w + y) / (x + w * 3)
    (part,) = split(value)[0]
    ring = part.ring
    i = ring.index["x", (0,)]
    top, bottom = x * x * w + y, x + w * 3
    expected = x * w * 2 * bottom - top
    found = partial_derivative(part, i)
    square = JetFraction(ring, part.bottom**2, ring.context.constant(1))
    ratio = split(expected / (bottom * bottom))[0][0]
    assert (found - ratio * square).is_zero


def test_zeros_on_a_whole_segment_are_no_extrema():
    """A straight segment: κ′ vanishes on all of it, and what is counted elsewhere does not apply to it."""
    s = example("cubic_s")
    line = [s.control_points[-1], *[tuple(x + k for x in s.control_points[-1]) for k in (1, 2, 3)]]
    curve = Nurbs(3, [0] * 4 + [1] * 4 + [2] * 4, [*s.control_points, *line])
    for one, count in ((s, len(analyse(s).curvature_extrema)), (curve, None)):
        assert examples.count_of_extrema(zeros(formula_of("g2")(one)), Evaluation(one)) == count


@pytest.mark.parametrize("name", ["projective map", "inversion", "translation"])
def test_the_image_of_a_point_is_that_of_a_curve_that_stays_there(name):
    made = MAPS[name]
    k = {constant: mpq(i * i + 2) for i, constant in enumerate(made.constants(2))}
    point = Vector(mpq(3), mpq(5))
    top, below = made.image(point, mpq(1), k)
    assert [x * (1 if made.affine else below) for x in image_of_point(point, made, k, mpq(1))] == list(top)
    assert made.affine or below != 1


def test_a_form_that_vanishes_has_no_degree():
    nothing = formula("a test", on="curve")(lambda c: c.w - c.w)
    assert agreed_degree(nothing, 2, False, Parameter.FIRST) == (Degree.number(-1), {})


def test_a_rational_form_that_does_not_exist_says_nothing():
    (claim,) = claims("N9-torsion")
    line = Nurbs(3, [0] * 4 + [1] * 4, [(k, 2 * k, 3 * k) for k in (0, 1, 2, 4)])
    for curve, verdict in ((line, Verdict.VACUOUS), (example("twisted_cubic"), Verdict.REFUTED)):
        assert claim.examine(curve, Evaluation(curve)).verdict == verdict


def test_where_an_assumption_fails_on_a_surface():
    """A sign that changes, one that does not, and nothing: as an assumption of all points, and of whole patches."""

    def net(*values):
        return TensorSpline((1, 1), [0, 0, 1, 1, 2, 2], [0, 0, 1, 1], [[x, x] for x in values])

    def fails(spline, everywhere):
        told = Assumption("a", "a", "a", "a", lambda _: spline, ("surface",), everywhere=everywhere)
        return fails_on_surface(told, spline)

    assert [fails(net(1, 2, 2, 3), everywhere) for everywhere in (True, False)] == [None, None]
    assert [fails(net(1, 2, 2, -3), everywhere) for everywhere in (True, False)] == [say.on_patch(1, 0), None]
    places = [fails(net(1, 2, 0, 0), everywhere) for everywhere in (True, False)]
    assert places == [say.on_patch(1, 0), say.on_whole_patch()]


def test_the_rank_of_a_matrix_of_quotients():
    (x, y), w = jets().p, jets().w
    one = w / w

    def rank(*rows):
        return rank_of([[split(entry * one)[0][0] for entry in row] for row in rows])

    assert rank((w, x), (w * w, x * w)) == 1
    assert rank((w, x), (w * w, x * w + y)) == 2
    assert rank((w - w, x), (w - w, y)) == 1
    assert rank((w - w, x), (y, w)) == 2
    assert rank((x, y, w), (y, w, x), (x + y, y + w, w + x)) == 2
    assert rank((w - w, x - x)) == 0
    assert rank((w, x - x, x - x), (x, w, x - x), (x, y, w)) == 3


def test_what_was_tried_on_a_part_says_so():
    found = sampled(Finding(Verdict.VERIFIED, Fact.NOTHING), say.on_patch(0, 0))
    assert (found.verdict, found.reason) == (Verdict.UNDECIDED, "tried on a part")
    assert found.witness == HeldOn(say.on_patch(0, 0))


def test_a_place_is_not_one_with_more_digits():
    assert [stands_at(place, "theorem 1") for place in ("Theorem 12", "Theorem 1", "see theorem 1.", "Theorem")] == [
        False,
        True,
        True,
        False,
    ]
    assert [stands_at(place, "remark") for place in ("remark2", "remark")] == [True, True]
    assert [stands_at("§5, Equation (12)", wanted) for wanted in ("(12)", "(1)", "eq. (12)", "5")] == [
        True,
        False,
        True,
        False,
    ]


@pytest.mark.parametrize("key", ["X9-torsion", "N9torsion", "N9", "N9-", "N9-a b", "N9-a;b"])
def test_a_key_is_the_id_and_words(key):
    """Passed by a mutant: an id of as many letters, or no words."""
    (claim,) = claims("N9-torsion")
    assert replace(claim, key="N9-other-words").key == "N9-other-words"
    with pytest.raises(ClaimError, match="does not begin with the id"):
        replace(claim, key=key)
