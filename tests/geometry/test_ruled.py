"""Ruled surfaces: one surface or two, the relation of the ruling parameters, developability, minimal forms."""

import pytest
from gmpy2 import mpq
from hypothesis import assume, given

from exactspline import BSpline, claims, example, examples, formula_of
from exactspline.errors import DomainError, ReductionError, ShapeError
from exactspline.geometry.derived.constructions import all_constructions
from exactspline.geometry.derived.ruled_surfaces import point_at, same_surface
from exactspline.language import Rational, Vector, cross
from exactspline.language.ruled import RuledSurface
from exactspline.splines.lowest_terms import in_lowest_terms, primitive_part
from exactspline.tables import as_tensor_product, is_developable, ruled_surface
from tests.support.strategies import splines_on_one_domain

RULED = [name for name, made in all_constructions().items() if made.ruled]
SPACE = [name for name in examples("curves") if example(name).dimension == 3]
TWISTED = ["rational_space_cubic", "twisted_cubic", "space_quartic", "flat_point"]


@pytest.mark.parametrize("curve", TWISTED)
@pytest.mark.parametrize("name", RULED)
def test_all_forms_are_one_surface_point_by_point(name, curve):
    """Through the relation found, and not only by the criterion."""
    forms = [ruled_surface(name, example(curve), variant) for variant in ("naive", "paper", "minimal")]
    a, b = example(curve).domain
    for other in forms[1:]:
        relation = same_surface(forms[0], other)
        for s in (a + (b - a) * mpq(k, 11) for k in (1, 4, 9)):
            for ruling in (0, 1, "-7/3"):
                assert point_at(forms[0], s, relation(s, ruling)) == point_at(other, s, ruling)
    assert forms[2].degree <= forms[1].degree <= forms[0].degree


@pytest.mark.parametrize("name", RULED)
def test_the_stretch_on_a_curve_is_the_one_proved_for_all_curves(name):
    curve = example("rational_space_cubic")
    (claim,) = [c for c in claims() if c.kind == "same surface" and (c.left, c.right) == (name, f"{name}_reduced")]
    relation = same_surface(ruled_surface(name, curve, "naive"), ruled_surface(name, curve, "paper"))
    power = {"ζ = w λ": 1, "ζ = w³ λ": 3, "ζ = w⁵ λ": 5, "ζ = w² λ": 2, "ζ = w⁻¹ λ": -1, "ζ = λ": 0}[
        str(claim.decide(3, False).factor)
    ]
    w = curve.w
    expected = (
        Rational(w**power, w.constant(1))
        if power > 0
        else Rational(w.constant(1), w.constant(1) if power == 0 else w ** (-power))
    )
    assert relation.scale == expected
    assert relation.shift.is_zero


@pytest.mark.parametrize("variant", ["naive", "paper", "minimal"])
@pytest.mark.parametrize("curve", ["rational_space_cubic_spline", "twisted_cubic"])
@pytest.mark.parametrize("name", RULED)
def test_a_ruled_surface_is_a_tensor_product(name, curve, variant):
    """The same points, linear in the ruling parameter; the edges of the net are the curves of the bounds."""
    surface = ruled_surface(name, example(curve), variant)
    patch = as_tensor_product(surface, "-1/2", 3)
    splines = [
        *(patch.numerator if isinstance(patch, Rational) else patch),
        *([patch.denominator] if isinstance(patch, Rational) else []),
    ]
    assert {s.degree.s for s in splines} == {surface.degree}
    assert {s.degree.t for s in splines} == {1}
    assert len({s.knots for s in splines}) == 1
    for s in (mpq(1, 7), mpq(3, 5)):
        for ruling in (mpq(-1, 2), mpq(0), mpq(5, 3), mpq(3)):
            found = patch(s, ruling) if isinstance(patch, Rational) else tuple(f(s, ruling) for f in patch)
            assert found == point_at(surface, s, ruling)
    first, last = ([f.control_points[0][side] for f in splines] for side in (0, -1))
    a = example(curve).domain[0]
    for corner, ruling in ((first, "-1/2"), (last, 3)):
        weight = corner[3] if len(corner) == 4 else 1
        assert tuple(x / weight for x in corner[:3]) == point_at(surface, a, ruling)


def test_bounds_must_be_an_interval():
    with pytest.raises(DomainError, match="not an interval"):
        as_tensor_product(ruled_surface("tangent_developable", example("twisted_cubic")), 1, 1)


def test_two_surfaces_are_told_apart():
    curve = example("rational_space_cubic")
    surfaces = [ruled_surface(name, curve) for name in RULED]
    for i, one in enumerate(surfaces):
        for j, other in enumerate(surfaces):
            assert (same_surface(one, other) is not None) == (i == j)
    tangents = surfaces[RULED.index("tangent_developable")]
    shifted = RuledSurface(tangents.directrix + tangents.generator * 2, tangents.generator)
    assert same_surface(tangents, shifted).shift == Rational(curve.w.constant(2), curve.w.constant(1))


@pytest.mark.parametrize("curve", [name for name in SPACE if name != "space_line"])
def test_developability(curve):
    """The developables are; the scrolls of the normals and binormals only where the torsion vanishes (Frenet)."""
    c = example(curve)
    for name in ("tangent_developable", "focal_surface", "rectifying_developable"):
        assert is_developable(ruled_surface(name, c))
    flat = formula_of("D1_D2_D3")(c).is_zero
    for name in ("binormal_scroll", "normal_scroll"):
        assert is_developable(ruled_surface(name, c)) == flat


def test_what_is_no_surface_is_refused():
    with pytest.raises(ReductionError):
        in_lowest_terms(ruled_surface("rectifying_developable", example("space_line"), "naive"))
    with pytest.raises(ShapeError, match="generator vanishes"):
        is_developable(ruled_surface("rectifying_developable", example("space_line")))
    with pytest.raises(ShapeError, match="generator vanishes"):
        is_developable(ruled_surface("binormal_scroll", example("space_line")))
    with pytest.raises(ShapeError, match="not a ruled surface"):
        ruled_surface("focal_curve", example("twisted_cubic"))
    with pytest.raises(ShapeError, match="in space"):
        ruled_surface("tangent_developable", example("circle"))


@given(splines_on_one_domain(count=8, low=0, high=2))
def test_a_surface_written_in_another_way_is_the_same_surface(operands):
    directrix, generator, (shift, scale) = Vector(*operands[:3]), Vector(*operands[3:6]), operands[6:]
    total = shift * 0 + scale * 0
    for x in operands[:6]:
        total = total + x * 0
    directrix, generator = Vector(*[x + total for x in directrix]), Vector(*[x + total for x in generator])
    shift, scale = shift + total, scale + total
    assume(all(any(parts) for parts in zip(*[x.numerators for x in generator], strict=True)) and all(scale.numerators))
    a, b = RuledSurface(directrix, generator), RuledSurface(directrix + generator * shift, generator * scale)
    relation = same_surface(a, b)
    one = shift.constant(1)
    assert relation.shift == Rational(shift, one)
    assert relation.scale == Rational(scale, one)
    assert same_surface(a, RuledSurface(directrix, generator)).scale == Rational(one, one)
    primitive = primitive_part(generator)
    assert cross(primitive, generator).is_zero
    assert primitive.degree <= generator.degree
    assert primitive_part(generator * scale).degree == primitive.degree
    assert is_developable(a) == is_developable(b) == is_developable(in_lowest_terms(a))


def test_cones_cylinders_and_a_helicoid_like_scroll():
    t = BSpline.identity(0, 1)
    one, zero = t.constant(1), t.constant(0)
    apex, base = Vector(zero, zero, zero), Vector(t, t * t, one)
    assert is_developable(RuledSurface(apex, base))
    assert is_developable(RuledSurface(base, Vector(zero, one, one)))
    assert not is_developable(RuledSurface(Vector(zero, zero, t), Vector(one, t, zero)))
