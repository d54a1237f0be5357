"""Every derived object at random parameters against its definition at 80 digits: an expansion that shares no code with
the splines, and linear systems solved by mpmath.
"""

import random

import pytest
from gmpy2 import mpq

from exactspline import derive, example, examples, formula_of, zeros
from exactspline.errors import DomainError
from exactspline.geometry.bisectors.point_and_curve import point_bisector
from exactspline.geometry.bisectors.two_curves import curve_bisector
from exactspline.readings import series_curve
from tests.support.numeric_reading import arithmetic, number, numeric_curve
from tests.support.sampled import sample
from tests.support.vectors import cross, dot

DIGITS = 80
PLANE = ["ellipse", "rational_cubic", "cubic_s", "rational_quartic", "six_segment_cubic", "hyperbola"]
SPACE = ["rational_space_cubic", "twisted_cubic", "space_quartic", "rational_space_cubic_spline", "helix_like"]


def parameters(curve, count=4, seed=11):
    draw, (a, b) = random.Random(f"{seed} {curve.name}"), curve.domain
    return [a + (b - a) * mpq(draw.randint(1, 10**6 - 1), 10**6) for _ in range(count)]


def jets(curve, t, order=3):
    """γ, γ′, … at a parameter as lists of mpf, and the arithmetic."""
    c = numeric_curve(curve, t, order + 3, DIGITS + 20)
    return [[x.value for x in c.gamma.d(k)] for k in range(order + 1)], c.w.context


def less(a, b):
    return [x - y for x, y in zip(a, b, strict=True)]


def solved(ctx, rows, right):
    return list(ctx.lu_solve(ctx.matrix(rows), ctx.matrix(right)))


def agree(ctx, exact, found):
    size = 1 + max(abs(x) for x in found)
    assert all(abs(number(ctx, e) - x) < size * ctx.mpf(10) ** -DIGITS for e, x in zip(exact, found, strict=True))


def parallel(ctx, exact, direction):
    a = [number(ctx, x) for x in exact]
    assert max(map(abs, a)) > 0
    size = max(map(abs, a)) * max(map(abs, direction))
    assert all(abs(x) < size * ctx.mpf(10) ** -DIGITS for x in cross(a, direction))


@pytest.mark.parametrize("name", sample(sorted(examples("curves")), 9))
def test_the_expansion_is_that_of_the_splines(name):
    curve = example(name)
    for t in [*parameters(curve, 2), *curve.breakpoints[:2]]:
        exact = series_curve(curve, t, 5)
        found = numeric_curve(curve, t, 5, DIGITS)
        wide = numeric_curve(curve, t, 5, 15, intervals=True)
        for a, b, c in zip((*exact.p, exact.w), (*found.p, found.w), (*wide.p, wide.w), strict=True):
            for x, y, z in zip(a.coefficients, b.coefficients, c.coefficients, strict=True):
                size = 1 + max(abs(v) for v in a.coefficients)
                assert abs(number(b.context, x) - y) <= number(b.context, size) * b.context.mpf(10) ** -(DIGITS - 8)
                assert z.a <= number(arithmetic(200), x) <= z.b


def test_a_parameter_outside_is_refused():
    with pytest.raises(DomainError, match="outside the domain"):
        numeric_curve(example("circle"), 99, 3, 20)


@pytest.mark.parametrize("name", PLANE)
def test_evolute_is_the_centre_of_second_order_contact(name):
    curve = example(name)
    made = {variant: derive("evolute", curve, variant) for variant in ("naive", "paper", "minimal")}
    for t in parameters(curve):
        (p, a, b, _), ctx = jets(curve, t)
        centre = [x + y for x, y in zip(p, solved(ctx, [a, b], [0, dot(a, a)]), strict=True)]
        for value in made.values():
            agree(ctx, value(t), centre)


@pytest.mark.parametrize("name", [name for name in SPACE if name != "helix_like"])
def test_centres_of_osculating_circles_and_spheres_and_the_torsion(name):
    curve = example(name)
    made = [derive(what, curve) for what in ("circle_centres", "focal_curve", "torsion")]
    for t in parameters(curve):
        (p, a, b, e), ctx = jets(curve, t)
        speed, up = dot(a, a), cross(a, b)
        circle = solved(ctx, [a, b, up], [0, speed, 0])
        sphere = solved(ctx, [a, b, e], [0, speed, 3 * dot(a, b)])
        for value, offset in zip(made, (circle, sphere), strict=False):
            agree(ctx, value(t), [x + y for x, y in zip(p, offset, strict=True)])
        found = made[2](t)
        agree(ctx, [found] if isinstance(found, type(mpq())) else found, [dot(up, e) / dot(up, up)])


@pytest.mark.parametrize("name", SPACE)
def test_ruled_surfaces_go_through_the_curve_in_their_direction(name):
    curve = example(name)
    made = {
        what: derive(what, curve)
        for what in (
            "tangent_developable",
            "normal_scroll",
            "binormal_scroll",
            "rectifying_developable",
            "focal_surface",
        )
    }
    for t in parameters(curve, 2):
        (p, a, b, e), ctx = jets(curve, t)
        up = cross(a, b)
        tau = dot(up, e) / dot(up, up)
        darboux = [tau * x + y / dot(a, a) for x, y in zip(a, up, strict=True)]
        centre = [x + y for x, y in zip(p, solved(ctx, [a, b, up], [0, dot(a, a), 0]), strict=True)]
        through = {
            "tangent_developable": (p, a),
            "normal_scroll": (p, cross(up, a)),
            "binormal_scroll": (p, up),
            "rectifying_developable": (p, darboux),
            "focal_surface": (centre, up),
        }
        for what, (place, direction) in through.items():
            value = made[what](t)
            parallel(ctx, value[3:], direction)
            offset = less([number(ctx, x) for x in value[:3]], place)
            size = (1 + max(map(abs, offset))) * max(map(abs, direction))
            assert all(abs(x) < size * ctx.mpf(10) ** -DIGITS for x in cross(offset, direction))


@pytest.mark.parametrize("names", [("rational_space_cubic", "twisted_cubic"), ("space_quartic", "helix_like")])
def test_bisector_points_have_equal_critical_distances(names):
    first, second = map(example, names)
    surface = curve_bisector(first, second)
    for s, t in zip(parameters(first), parameters(second, seed=5), strict=True):
        (p, a, *_), ctx = jets(first, s)
        (q, b, *_), _ = jets(second, t)
        middle = [dot(a, p), dot(b, q), (dot(p, p) - dot(q, q)) / 2]
        agree(ctx, surface(s, t), solved(ctx, [a, b, less(p, q)], middle))


@pytest.mark.parametrize("name", SPACE)
@pytest.mark.parametrize("variant", ["naive", "explicit", "direct"])
def test_point_bisectors_are_the_lines_of_equal_critical_distance(name, variant):
    curve, point = example(name), (mpq(3, 7), mpq(-2), mpq(5, 3))
    found = point_bisector(curve, point, variant)
    for t in parameters(curve, 2):
        (p, a, *_), ctx = jets(curve, t)
        q = [number(ctx, x) for x in point]
        surface = next(x for x in found.pieces if x.interval[0] <= t <= x.interval[1]).surface
        for ruling in (0, 1, mpq(-7, 2)):
            place = [number(ctx, x) for x in surface.at(ruling)(t)]
            size = (1 + max(map(abs, place))) ** 2 * (1 + max(map(abs, a)))
            near = less(place, p)
            assert abs(dot(near, a)) < size * ctx.mpf(10) ** -DIGITS
            assert abs(dot(near, near) - dot(less(place, q), less(place, q))) < size * ctx.mpf(10) ** -DIGITS


def test_roots_refined_by_mpmath_agree_to_all_digits_printed():
    """The zeros of κ and κ′ by mpmath's secant method on the numeric reading, started within our interval."""
    for name in ("six_segment_cubic", "rational_cubic", "rational_cubic_spline", "cubic_s"):
        curve = example(name)
        for form in ("f2", "g2"):
            formula = formula_of(form)
            for root in zeros(formula(curve)):
                if root.at_knot or root.multiplicity > 1:
                    continue
                low, high = root.refine(60)
                ctx = arithmetic(80)

                def value(t, formula=formula, curve=curve, ctx=ctx):
                    sign, mantissa, exponent, _ = t._mpf_
                    exact = (-1) ** sign * mantissa * mpq(2) ** exponent
                    return ctx.make_mpf(formula(numeric_curve(curve, exact, 7, 80)).value._mpf_)

                rough = (low + high) / 2
                start = number(ctx, rough + (root.segment[1] - rough) / 10**6)
                found = ctx.findroot(value, (start, number(ctx, rough)), tol=ctx.mpf(10) ** -130, verify=False)
                assert number(ctx, low) - ctx.mpf(10) ** -58 <= found <= number(ctx, high) + ctx.mpf(10) ** -58
