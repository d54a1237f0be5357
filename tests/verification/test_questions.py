"""`prove` and `verify` of the front door: nothing false holds, 0 = 0 is told, and what cannot be compared is refused in
plain words.
"""

import pytest

import exactspline as xs
from exactspline.papers import all_formulas

LINE = xs.Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 1)])
#: One formula of each kind of argument.
OF_EACH_KIND = list({f.kind.name: f.name for f in all_formulas().values()}.values())


def test_zero_equal_to_zero_is_no_success():
    """Both sides vanish on a line, so that a false factor holds there too: before, `verify` held with any."""
    for factor in ("w", "17"):
        check = xs.verify("f1", "f2", LINE, factor)
        assert not check
        assert check.vacuous
        assert str(check).endswith("decides nothing on this curve: 0 = 0")


def test_what_is_divided_by_zero_is_neither_proved_nor_verified():
    """Before, D1_D2_D3 = 0/0 · velocity_acceleration_jerk was proved, and 0 = 0 · f2 as well."""
    sides, zero = ("D1_D2_D3", "velocity_acceleration_jerk"), "D1_D2_D21"
    found = xs.prove(*sides, f"{zero} {zero}^-1")
    assert (bool(found), found.verdict) == (False, "REFUTED")
    assert str(xs.prove(*sides).quotient) in str(found)
    nothing = xs.prove(zero, "velocity_acceleration_jerk", zero)
    assert (bool(nothing), nothing.verdict) == (False, "VACUOUS")
    assert "0 = 0" in str(nothing)
    assert xs.prove(zero, zero).verdict == "VACUOUS"
    assert xs.prove("D1_D2_D3", zero).verdict == "REFUTED"
    cubic = xs.example("rational_space_cubic")
    found = xs.verify(*sides, cubic, f"{zero} {zero}^-1")
    assert (bool(found), found.verdict) == (False, "VACUOUS")
    assert xs.verify(*sides, cubic, "w^6").holds


def test_a_proper_identity_is_verified():
    proper = xs.verify("f1", "f2", xs.example("circle"), "w")
    assert proper.holds
    assert not proper.vacuous
    assert "0" not in str(proper)


@pytest.mark.parametrize("left", OF_EACH_KIND)
@pytest.mark.parametrize("right", OF_EACH_KIND)
def test_formulas_of_any_two_kinds_are_compared_or_refused(left, right):
    """Whichever two are given, the answer is a verdict or an `ExactSplineError`; none of these is another one."""
    try:
        holds = xs.prove(left, right).holds
    except xs.ExactSplineError:
        holds = None
    assert holds is not (left != right)


def test_a_formula_is_itself():
    assert all(xs.prove(name, name) for name in ("T1", "D1", "f2", "torsion", "second_normal", "plane_bisector"))


@pytest.mark.parametrize("factor", ["W", "second_normal", "T1"])
def test_a_factor_that_the_curve_does_not_have_is_refused(factor):
    with pytest.raises(xs.ExactSplineError):
        xs.prove("f1", "f2", factor)


@pytest.mark.parametrize("name", ["torsion", "second_normal", "T1", "plane_bisector"])
def test_a_formula_of_other_curves_is_refused_by_name(name):
    with pytest.raises(xs.ExactSplineError, match=f"{name} is a formula of the kind"):
        xs.verify(name, name, xs.example("circle"))


def test_sides_that_are_not_proportional_have_no_factor():
    """The last height of (34) as printed: no factor makes both sides equal, and none is shown."""
    (printed,) = [claim for claim in xs.claims("C6.2g") if claim.expected == xs.Verdict.REFUTED]
    finding = printed.prove()[1]
    assert (finding.verdict, str(finding.computed), finding.factor) == (xs.Verdict.REFUTED, "not proportional", None)
