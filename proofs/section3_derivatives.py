"""§3 of the paper (Chen, Riesenfeld and Cohen 2007): derivatives of a rational curve γ = p/w.

The derivatives are expressed by D1 = p′w − pw′, D2 = p″w − pw″, D3 = p‴w − pw‴ and D21 = p″w′ − p′w″, which have lower
degrees than the quotient rule gives.
"""

from theorem import establish, verdict_for_all

from exactspline.interchange.examples import example, example_names
from exactspline.papers import find
from exactspline.readings.taylor import series_curve


def test_equations_1_2_3_and_5():
    """γ′, γ″ and γ‴ by the quotient rule agree with equations (1), (2), (3) and (5)."""
    for equation in ("E1", "E2", "E3"):
        assert set(verdict_for_all(equation)) == {"PROVED"}
    assert verdict_for_all("E5") == ["PROVED", "PROVED"]


def test_derivatives_are_taylor_coefficients():
    """The definition: division of power series, which does not use the quotient rule, gives the same derivatives on
    every example curve.
    """
    for name in example_names():
        curve = example(name)
        a, b = curve.domain
        t = a + (b - a) * 3 / 7
        for order, formula in enumerate(("velocity", "acceleration", "jerk"), start=1):
            definition = series_curve(curve, t, 4).gamma.d(order)
            value = find(formula)(curve)
            assert tuple(c.value for c in definition) == (
                value(t) if hasattr(value, "denominator") else tuple(c(t) for c in value)
            )


def test_remark_3_1_degrees():
    """D1, D2, D3, [D1 D2] and [D1 D2 D3] have the degrees stated in Remark 3.1."""
    assert set(verdict_for_all("C3a")) == {"PROVED"}


def test_degrees_in_the_power_basis():
    """The degree of each Di in the power basis is lower by one, on the generic curve of every degree."""
    assert set(verdict_for_all("C3b")) == {"PROVED"}


def test_d21_lies_in_the_span_of_d1_and_d2():
    """The paper prints [D1 D2 D3] = 0, which is false; the computation printed below this is for [D1 D2 D21] = 0, which
    is true.
    """
    assert verdict_for_all("C3c", "[D1 D2 D3] = 0") == ["REFUTED"]
    assert verdict_for_all("C3c", "[D1 D2 D21] = 0") == ["PROVED"]
    assert verdict_for_all("C3c", "D21 = ") == ["PROVED"]


def test_remark_3_2():
    """The other terms of γ″ and γ‴ are in the span of lower derivatives, and cancel in the determinants."""
    assert set(verdict_for_all("C3d")) == {"PROVED"}


def test_naive_and_shared_degrees():
    """The degrees are 2d, 4d, 8d by the quotient rule, and 2d, 3d, 4d with shared denominators."""
    assert set(verdict_for_all("C3e")) == {"PROVED"}


def test_coefficients_of_d1():
    """Some coefficients of D1 vanish on some curves; on the generic curve of any degree no coefficient vanishes."""
    assert verdict_for_all("C3f") == ["REFUTED", "PROVED"]


def test_degrees_of_the_lower_terms():
    """The degrees of the lower terms exceed that of Di/w² by at least d, except for D21/w² as printed in equation
    (5).
    """
    refuted = [row for row in establish("C3g") if not row.curve and row.verdict == "REFUTED"]
    assert [str(row.computed) for row in refuted] == ["2d"]


def test_replacing_derivatives_by_di():
    """Derivatives can be replaced by Di in [γ′ γ″] and [γ′ γ″ γ‴], but not in every zero-set problem, as printed: [γ′
    γ‴] is a counterexample.
    """
    assert sorted(verdict_for_all("C3h")) == ["PROVED"] * 6 + ["REFUTED"]
