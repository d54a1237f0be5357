"""Surfaces: the form with the sign of K, its sign proved, all umbilics of bicubics; compared with the same forms inline
over bare polynomials of python-flint and over sympy's.
"""

import os

os.environ.setdefault("SYMPY_GROUND_TYPES", "gmpy")

import random
import statistics
import time

import pytest
import sympy
from flint import Ordering, fmpz_mpoly_ctx
from sympy.polys.rings import ring

from exactspline import NurbsSurface, analyse, example
from exactspline.bivariate.signs import sign_on_patch
from exactspline.bivariate.zero_curve import ZeroCurve
from exactspline.geometry.surfaces.forms import SurfaceForms, on_patch
from exactspline.geometry.surfaces.umbilics import umbilics_of_patch

BICUBICS = range(20)


def patch(degree, seed, rational):
    """A patch with a net of integers of 8 bits."""
    drawn, n = random.Random(seed), range(degree + 1)
    knots = [0] * (degree + 1) + [1] * (degree + 1)
    net = [[[drawn.randint(-128, 127) for _ in range(3)] for _ in n] for _ in n]
    weights = [[drawn.randint(1, 20) for _ in n] for _ in n] if rational else None
    return NurbsSurface((degree, degree), knots, knots, net, weights)


def fresh(surface):
    """The surface constructed anew, without memoized values."""
    return (NurbsSurface(surface.degree, *surface.knots, surface.control_points, surface.weights),), {}


def homogeneous(surface, one, u, v):
    """``(w, p)`` as polynomials in u and v, of Bézier points."""
    (m, n) = surface.degree
    polynomials = []
    for f in (surface.w, *surface.p):
        net = f.elevate_degree(m - f.degree.s, n - f.degree.t).bezier_net(0, 0)
        total = one * 0
        for i in range(m + 1):
            for j in range(n + 1):
                factor = sympy.binomial(m, i) * sympy.binomial(n, j) * int(net[i][j])
                total += one * int(factor) * u**i * (1 - u) ** (m - i) * v**j * (1 - v) ** (n - j)
        polynomials.append(total)
    return polynomials


def inline_parabolic(lift, d):
    """[P P_u P_v P_uu][P P_u P_v P_vv] − [P P_u P_v P_uv]², d(f, k) is the derivative with respect to parameter k."""
    first = [[d(x, k) for x in lift] for k in (0, 1)]
    uu, uv, vv = [d(x, 0) for x in first[0]], [d(x, 1) for x in first[0]], [d(x, 1) for x in first[1]]

    def minor(rows):
        (a, b, c), (e, f, g), (h, i, j) = rows
        return a * (f * j - g * i) - b * (e * j - g * h) + c * (e * i - f * h)

    rows = [lift, *first]
    plane = [(-1) ** k * minor([[row[h] for h in range(4) if h != k] for row in rows]) for k in range(4)]

    def against(second):
        return sum((x * y for x, y in zip(plane[1:], second[1:], strict=True)), plane[0] * second[0])

    return against(uu) * against(vv) - against(uv) ** 2


@pytest.mark.parametrize("who", ["exactspline", "python-flint inline", "sympy"])
@pytest.mark.parametrize("degree", [1, 2, 3])
def test_the_form_with_the_sign_of_k(benchmark, degree, who):
    benchmark.group = f"w⁸ (LN − M²), rational patch of degree {degree} × {degree}"
    surface = patch(degree, 1, rational=True)
    if who == "exactspline":
        form = benchmark.pedantic(lambda s: SurfaceForms(s).parabolic, setup=lambda: fresh(surface), rounds=20)
        assert not form.is_zero
        return
    if who == "python-flint inline":
        context = fmpz_mpoly_ctx.get(["u", "v"], Ordering.lex)
        u, v = context.gens()
        lift = homogeneous(surface, context.from_dict({(0, 0): 1}), u, v)
        form = benchmark.pedantic(inline_parabolic, args=(lift, lambda f, k: f.derivative(k)), rounds=20)
    else:
        domain, u, v = ring("u,v", sympy.ZZ)
        lift = homogeneous(surface, domain.one, u, v)
        form = benchmark.pedantic(inline_parabolic, args=(lift, lambda f, k: f.diff((u, v)[k])), rounds=3)
    # the same function as the library's, at a point
    value = SurfaceForms(surface).parabolic("1/3", "2/5")
    u, v = sympy.Rational(1, 3), sympy.Rational(2, 5)
    assert sum(int(x) * u ** int(i) * v ** int(j) for (i, j), x in form.terms()) == sympy.Rational(str(value))


@pytest.mark.parametrize("name", ["rational_biquadratic", "seeded"])
def test_the_sign_of_k_on_a_rational_biquadratic(benchmark, name):
    surface = patch(2, 3, rational=True) if name == "seeded" else example(name)

    def proved(s):
        return sign_on_patch(on_patch(SurfaceForms(s).parabolic, (0, 0)).form).sign

    benchmark.group = "sign of K proved on a rational biquadratic"
    assert benchmark.pedantic(proved, setup=lambda: fresh(surface), rounds=20)


@pytest.mark.parametrize("rational", [False, True])
def test_all_umbilics_of_bicubics(benchmark, rational):
    benchmark.group = f"all umbilics of 20 {'rational' if rational else 'polynomial'} bicubics, certified"
    seconds = []

    def all_of_them():
        for seed in BICUBICS:
            start = time.process_time()
            found = umbilics_of_patch(SurfaceForms(patch(3, seed, rational)), (0, 0))
            seconds.append(time.process_time() - start)
            assert not found.undecided

    benchmark.pedantic(all_of_them, rounds=1)
    benchmark.extra_info["median of a patch (processor seconds)"] = statistics.median(seconds)
    benchmark.extra_info["longest"] = max(seconds)


def test_parabolic_curves_of_bicubics(benchmark):
    benchmark.group = "topology of the parabolic curves of 20 bicubics"

    def all_of_them():
        for seed in BICUBICS:
            (one,) = analyse(patch(3, seed, rational=False)).patches
            assert isinstance(one.curve, ZeroCurve)
            assert one.complete

    benchmark.pedantic(all_of_them, rounds=1)


def test_the_torus_drawn(benchmark):
    from exactspline.extras.pictures3d.patches import surface_figure

    benchmark.group = "the torus, inspected and drawn"
    benchmark.pedantic(lambda: surface_figure(analyse(example("torus"))), rounds=1)
