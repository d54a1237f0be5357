"""Arguments of formulas beside curves: constants, hodographs, implicit curves and surfaces.

What the readings say of them is held against curves and functions given by hand.
"""

import pytest
import sympy
from gmpy2 import mpq

from exactspline import example, prove
from exactspline.errors import FormulaError, InapplicableError
from exactspline.language import (
    Vector,
    complex_product,
    complex_quotient,
    conjugate,
    cross,
    det,
    dot,
    formula,
    norm2,
    perp,
)
from exactspline.language.kinds import HODOGRAPH, IMPLICIT, IMPLICIT_SURFACE, INTERSECTION, common_kind, kind_of
from exactspline.readings import DegreeReading, JetReading, trace
from exactspline.readings.leading_terms import LeadingTermsReading, generic_true_degree
from exactspline.readings.sympy_expression import SympyReading
from exactspline.readings.taylor import taylor
from exactspline.verification.evaluation import CONSTANTS, argument

READINGS = [JetReading(3), SympyReading()]


def join_rows(c, t):
    return Vector(dot(c.hessian_fx, t), dot(c.hessian_fy, t))


@formula("a test", on="plane")
def turning(c):
    """[γ′ γ″]."""
    return det(c.gamma.d(1), c.gamma.d(2))


@formula("a test", on="implicit")
def wanted(c):
    """What [γ′ γ″] is in the derivatives of F."""
    t = perp(c.gradient_f)
    return c.pace**3 * dot(t, join_rows(c, t))


def test_the_curvature_of_an_implicit_curve_is_that_of_the_curve():
    assert prove(turning, wanted)
    assert str(prove(turning, wanted, "2")) == "not turning = 2 · wanted in R2: the quotient is 1"


@pytest.mark.parametrize("reading", READINGS, ids=lambda r: r.name)
def test_curves_stay_in_what_is_given(reading):
    for kind, functions in ((IMPLICIT, "f"), (IMPLICIT_SURFACE, "f"), (INTERSECTION, "fg")):
        c = reading.argument(kind, kind.dimensions[0])
        for f in functions:
            assert dot(getattr(c, f"gradient_{f}"), c.gamma.d(1)).is_zero
            axes = "xyz"[: kind.dimensions[0]]
            rows = [getattr(c, f"hessian_{f}{x}") for x in axes]
            gradient = getattr(c, f"gradient_{f}")
            assert all((g.d(1) - dot(row, c.gamma.d(1))).is_zero for g, row in zip(gradient, rows, strict=True))


def test_the_chain_rule_is_that_of_functions():
    """F = y³ + x y − x⁴ + 2 − … along a curve with F constant on it, differentiated by sympy."""
    s, x, y = sympy.symbols("s x y")
    f = (y - x**3) * (1 + x * y + y**2)
    on_curve = {x: s**2 + s, y: (s**2 + s) ** 3}
    names = IMPLICIT.partials["f"]
    values = {n: sympy.diff(f, *[{"x": x, "y": y}[v] for v in n[1:]]).subs(on_curve) for n in names}
    values["pace"] = -sympy.diff(on_curve[x], s) / values["fy"]
    assert sympy.simplify(values["pace"] * values["fx"] - sympy.diff(on_curve[y], s)) == 0
    for name, rule in IMPLICIT.rules(2).items():
        if len(name) in (2, 3):
            assert sympy.simplify(rule(values) - sympy.diff(values[name], s)) == 0


def test_what_is_not_known_of_an_implicit_curve_is_told():
    c = JetReading(9).argument(IMPLICIT, 2)
    with pytest.raises(FormulaError, match="partial derivative fxxx"):
        c.fxxx.d(1)
    with pytest.raises(InapplicableError, match="has no degrees"):
        DegreeReading().argument(IMPLICIT, 2)
    for kind in (IMPLICIT, HODOGRAPH):
        with pytest.raises(InapplicableError, match="does not apply to the kind"):
            LeadingTermsReading(1).argument(kind, 2)
    with pytest.raises(InapplicableError, match="one curve is not an example of 'implicit"):
        argument("implicit", example("ellipse"))


@pytest.mark.parametrize("reading", READINGS, ids=lambda r: r.name)
@pytest.mark.parametrize("polynomial", [False, True])
def test_the_speed_of_a_hodograph_is_polynomial(reading, polynomial):
    c = reading.argument(HODOGRAPH, 2, polynomial=polynomial)
    assert norm2(c.gamma.d(1)) == c.speed * c.speed
    z = Vector(c.u, c.v)
    assert complex_product(z, z) * c.h == c.velocity
    assert (c.gamma.d(3) - c.velocity.d(2)).is_zero


def test_a_curve_is_read_as_the_preimage_of_a_hodograph():
    curve = example("rational_cubic")
    c, told, _ = argument("hodograph", curve)
    assert c.p.d(1) == c.velocity
    assert c.p(curve.domain[0]) == (0, 0)
    assert str(told) == "as u, v and h of a hodograph"
    point = c.mapped(lambda spline: taylor(spline, mpq(1, 3), 3))
    assert point.p.d(1)[0].value == c.velocity[0](mpq(1, 3))


def test_degrees_of_a_hodograph():
    c = DegreeReading().argument(HODOGRAPH, 2, polynomial=True)
    assert str(c.p.degree) == "2d + 1"
    assert str(c.speed.degree) == "2d"
    assert str(c.velocity.degree) == "2d"
    own, *_ = argument("hodograph", example("six_segment_cubic"))
    assert own.p.degree == 7


def test_constants_have_no_derivative_and_a_value_on_a_curve():
    kind = kind_of("plane with r, delta")
    assert kind is kind_of("plane with delta,r")
    assert kind.name == "plane with delta, r"
    for reading in READINGS:
        c = reading.argument(kind, 2)
        assert c.delta.d(1).is_zero
        assert not c.r.is_zero
        assert ((c.p[0] * c.delta).d(1) - c.p[0].d(1) * c.delta).is_zero
    own, told, _ = argument("plane with r, delta", example("circle"))
    assert own.delta(0) == CONSTANTS[0]
    assert str(told) == "with δ = 37/29, r = -53/41"
    assert common_kind([kind_of("plane with r"), kind_of("plane point")]).name == "plane point with r"


def test_constants_at_infinity():
    @formula("a test", on="plane with delta")
    def still(c):
        return c.delta.d(1) + c.w * c.delta

    assert str(generic_true_degree(still, 2)) == "d"


WRONG_CONSTANTS = ["plane with x", "plane with __class__", "plane with ", "surface with r", "plain"]
WRONG_CONSTANTS += ["hodograph with u", "hodograph with speed", "framed plane with sigma", "framed plane with rho"]


@pytest.mark.parametrize("name", WRONG_CONSTANTS)
def test_no_constant_takes_the_name_of_an_operand(name):
    with pytest.raises(FormulaError):
        kind_of(name)


def test_complex_numbers_in_every_reading():
    for reading in READINGS:
        c = reading.argument(kind_of("plane"), 2)
        a, b = c.p, c.p.d(1)
        assert complex_product(a, conjugate(a)) == Vector(norm2(a), a[0].constant(0))
        assert complex_product(a, b) == complex_product(b, a)
        assert complex_product(conjugate(a), b) == Vector(dot(a, b), det(a, b))
    curve = example("rational_cubic")
    assert complex_quotient(complex_product(curve.p, curve.gamma.d(1)), curve.p) == curve.gamma.d(1)

    @formula("a test", on="plane")
    def squared(c):
        return complex_product(c.p, c.p)

    assert str(trace(squared, 2)) == "(p[0] p[0] − p[1] p[1], p[0] p[1] + p[1] p[0])"


def test_the_curvature_of_a_surface_cut_by_planes():
    """Euler and Meusnier: ∇F·γ″ depends on the tangent alone, and the tangent is any vector orthogonal to ∇F."""
    c = JetReading(2).argument(IMPLICIT_SURFACE, 3)
    t = c.gamma.d(1)
    rows = Vector(*[dot(getattr(c, f"hessian_f{x}"), t) for x in "xyz"])
    assert (dot(c.gradient_f, c.gamma.d(2)) + dot(t, rows)).is_zero
    assert t == cross(c.gradient_f, c.cut)
