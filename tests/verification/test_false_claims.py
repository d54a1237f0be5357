"""False statements made from true ones, each with the reason why it is false: none is ever PROVED or VERIFIED."""

from dataclasses import replace

import pytest
from gmpy2 import mpq

from exactspline import Nurbs, Verdict, claims, example, formula_of, paper
from exactspline.errors import FormulaError, ReachError
from exactspline.language.ruled import split
from exactspline.readings import parse_degree
from exactspline.readings.degree import Degree
from exactspline.verification.evaluation import Evaluation
from exactspline.verification.notation import factor_parts
from tests.support.sampled import sample
from tests.verification.test_own_paper import written

#: Curves on which what is generic is seen, and no formula of a claim vanishes: by dimension.
GENERIC = {2: "rational_cubic_s", 3: "rational_space_cubic"}
#: Polynomial ones, of degree 3 like the others.
POLYNOMIAL = {2: "six_segment_cubic", 3: "twisted_cubic"}
#: Formulas that are not zero: by what they speak of.
NOT_ZERO = {"curve": "D1", "plane": "f2", "space": "D1_D2_D3", "pair": "bisector_determinant_symmetric"}
NOT_ZERO |= {"point": "point_bisector_determinant_polynomial", "plane point": "plane_bisector_determinant"}
#: Ruled surfaces that are none of those that are claimed to be one with another.
OTHER = {"space": ("tangent_developable", "binormal_scroll"), "point": ("tangent_developable", "binormal_scroll")}
TRUE = [claim for claim in claims() if claim.expected in (Verdict.PROVED, Verdict.VERIFIED)]
#: What is recorded of polynomial curves: where it is another degree, none holds of both.
POLYNOMIAL_DEGREES = {(c.formula, c.measure): c.claimed for c in TRUE if c.kind == "degree" and c.of == "polynomial"}
EVERYWHERE, IN_GENERAL = "false on every curve", "false in general"


def shifted(claim, by):
    return str(parse_degree(claim.claimed) * Degree.number(by))


def is_value_one(factor):
    """Whether a factor is 1 or −1 on every curve: then both sides may change places."""
    return all(not name[0].isalpha() and abs(mpq(name)) == 1 for name, _ in factor_parts(factor))


def of_identity(c):
    """What is not zero is not twice itself; w is not 1 on a rational curve; k² ≠ 1."""
    yield replace(c, factor=f"2 {c.factor}"), EVERYWHERE
    yield replace(c, factor=f"-1 {c.factor}"), EVERYWHERE
    if c.of != "polynomial" and c.curve != "table":
        yield replace(c, factor=f"w {c.factor}"), IN_GENERAL
    if not is_value_one(c.factor):
        yield replace(c, left=c.right, right=c.left), IN_GENERAL


def of_vanishing(c):
    """These formulas are not zero."""
    if c.curve in NOT_ZERO:
        yield replace(c, left=NOT_ZERO[c.curve]), IN_GENERAL


def of_degree(c):
    """A degree is one number; less is not an upper bound of it, more no lower one; nominal and true degree differ."""
    where = EVERYWHERE if c.measure == "nominal" else IN_GENERAL
    if c.relation == "=":
        yield replace(c, claimed=shifted(c, 1)), IN_GENERAL if c.measure != "nominal" else EVERYWHERE
        yield replace(c, claimed=shifted(c, -1)), where
        if c.measure not in ("height",):
            yield replace(c, claimed=shifted(c, -1), relation="≤"), where
            yield replace(c, claimed=shifted(c, 1), relation="≥"), where
    if c.of == "rational" and POLYNOMIAL_DEGREES.get((c.formula, c.measure), c.claimed) != c.claimed:
        yield replace(c, of="both"), IN_GENERAL
    if c.measure in ("reduced", "lowest terms"):
        yield replace(c, measure="nominal"), IN_GENERAL


def of_zero_set(c):
    """f0·g0 vanishes where g0 does, f0 need not; and what is assumed and used is dropped."""
    if c.curve == "plane" and "f0_g0" not in c.formulas:
        yield replace(c, formulas=(*c.formulas, "f0_g0")), IN_GENERAL
    for each in c.prove()[1].assumptions:
        yield replace(c, assumes=tuple(a for a in c.assumes if a.name != each)), "no longer proved"


def of_same_surface(c):
    """One has its rulings along the tangents, the other along the binormals."""
    for other in OTHER[c.curve]:
        if not c.left.startswith(other) and not c.right.startswith(other):
            yield replace(c, right=other), IN_GENERAL
            yield replace(c, left=other), IN_GENERAL


def of_square_class(c):
    """f2 changes its sign where ‖γ′‖² does not."""
    yield replace(c, formula="f2"), IN_GENERAL
    yield replace(c, right="f2"), IN_GENERAL


def of_count(c):
    """A number is one number."""
    digits = next(word for word in c.claimed.replace(",", " ").split() if word.lstrip("-").isdigit())
    yield replace(c, claimed=c.claimed.replace(digits, str(int(digits) + 1), 1)), EVERYWHERE


def of_coefficients(c):
    """D21 is zero where w is 1."""
    yield replace(c, formula="D21", of="polynomial"), IN_GENERAL


def of_iso_curve(c):
    """The curve is not its bisector with a point."""
    yield replace(c, right="tangent_developable"), IN_GENERAL
    yield replace(c, right="focal_surface"), IN_GENERAL


def of_condition(c):
    """Not both are better."""
    yield replace(c, left=c.right, right=c.left), EVERYWHERE


MAKERS = {
    "identity": of_identity,
    "vanishing": of_vanishing,
    "degree": of_degree,
    "zero set": of_zero_set,
    "same surface": of_same_surface,
    "square class": of_square_class,
    "count": of_count,
    "coefficients": of_coefficients,
    "iso-curve": of_iso_curve,
    "condition": of_condition,
}


def false_claims(kind):
    for claim in TRUE:
        if claim.kind == kind:
            for false, where in MAKERS[kind](claim):
                yield claim, false, where


def is_true_after_all(claim, false):
    """The generator's own doubts, decided without the judge: what is known to be equal although it was changed."""
    if false.kind == "degree" and false.measure == "nominal" and claim.measure != "nominal":
        names = POLYNOMIAL if false.of == "polynomial" else GENERIC
        own = Evaluation(example(names[false.dimensions[0]]))
        degree = formula_of(false.formula)(own.argument(false.curve)).degree
        return getattr(degree, "s", degree) == parse_degree(false.claimed).at({"d": 3})
    if false.kind == "zero set" and not any(each.name == "w" for each in false.assumes):
        # numerators all of which vanish where w does have one zero set without that assumption, too
        curve = Nurbs(3, [0] * 4 + [1] * 4, [(1, 0, 3), (2, 5, 1), (0, 1, 1), (3, 1, 4)], [1, 2, -1, 3])
        return 3 in false.dimensions and false.check(curve).verdict == Verdict.VERIFIED
    return False


@pytest.mark.parametrize("kind", MAKERS)
def test_no_false_claim_is_proved(kind):
    fooled, tried = [], 0
    for claim, false, _ in sample(list(false_claims(kind)), 40):
        if is_true_after_all(claim, false):
            continue
        tried += 1
        try:
            verdict = false.prove()[1].verdict
        except FormulaError:  # a false identity may cancel nothing and grow beyond what is worked with: no verdict
            continue
        if verdict in (Verdict.PROVED, Verdict.VERIFIED):
            fooled.append((claim.key, false))
    assert tried
    assert fooled == []


@pytest.mark.parametrize("kind", ["identity", "degree"])
def test_what_is_false_everywhere_is_verified_on_no_curve(kind):
    own = {n: Evaluation(example(name)) for n, name in GENERIC.items()}
    fooled, tried = [], 0
    for claim, false, where in false_claims(kind):
        n = false.dimensions[0]
        if where == EVERYWHERE and false.applies_to(n, False) and _is_not_zero(false, own[n]):
            tried += 1
            if false.check(own[n]).verdict == Verdict.VERIFIED:
                fooled.append((claim.key, false))
    assert tried > 40
    assert fooled == []


def _is_not_zero(claim, own):
    handed = own.argument(claim.curve)
    return any(not x.is_zero for name in claim.named for x in split(claim.find(name)(handed))[0])


def test_there_are_more_than_enough():
    assert sum(1 for kind in MAKERS for _ in false_claims(kind)) > 500


# ---- what is too long is decided for w = 1 only where it is about γ alone


@pytest.mark.parametrize("kind", ["pair", "plane pair"])
def test_a_denominator_of_a_part_is_a_denominator(kind, tmp_path):
    """Before, PROVED: leaves of a pair are called first.w, and only those called p and w were looked for."""
    formulas = f"""

@formula("a", on="{kind}")
def long(c):
    return norm2(c.first.gamma.d(3)) ** 12

@formula("b", on="{kind}")
def weighted(c):
    return norm2(c.first.gamma.d(3)) ** 12 * c.first.w
"""
    folder = written(
        tmp_path / "p",
        formulas,
        [{"id": "1", "kind": "identity", "curve": kind, "statement": "w = 1", "left": "weighted", "right": "long"}],
    )
    (claim,) = claims(paper=paper(folder))
    with pytest.raises(ReachError):
        claim.prove()
