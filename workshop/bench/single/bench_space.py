"""Torsion and the rectifying developable of a rational space curve: naive (26d, 39d) and reduced (8d − 6, 13d − 8),
each against raw python-flint.

`extra_info` of a result (`--benchmark-json`) has the size: degree, control points, and bits of all integers together.
"""

from functools import partial

import pytest

from exactspline.language.ruled import split
from exactspline.papers.chen_riesenfeld_cohen_2007.space import (
    rectifying_developable,
    rectifying_developable_reduced,
    torsion,
    torsion_reduced,
)
from exactspline.splines.lowest_terms import control_point_count
from workshop.bench.inline import U_PLUS_V, cross, differences, dot
from workshop.bench.inline import form_derivative as d
from workshop.bench.inline import torsion as inline_torsion_reduced
from workshop.bench.single.ground import curve, fresh

DEGREES = (3, 4, 5)


def quotient_rule(p, w, n):
    """Numerators, all over w², raised to its degree."""
    dw = d(w, n)
    return [(d(x, n) * w - x * dw) * U_PLUS_V for x in p], w * w


def inline_frame(p, w, n):
    a, wa = quotient_rule(p, w, n)
    b, wb = quotient_rule(a, wa, 2 * n)
    binormal, wab = cross(a, b), wa * wb
    return a, wa, b, wb, binormal, wab


def inline_torsion(p, w, n):
    _, _, b, wb, binormal, wab = inline_frame(p, w, n)
    c, wc = quotient_rule(b, wb, 4 * n)
    return dot(binormal, c) * (wab * wab), wab * wc * dot(binormal, binormal)


def inline_rectifying(p, w, n):
    a, wa, _, _, binormal, wab = inline_frame(p, w, n)
    top, bottom = inline_torsion(p, w, n)
    speed, w_speed = dot(a, a), wa * wa
    first, w_first = [top * x for x in a], bottom * wa
    second, w_second = [x * w_speed for x in binormal], wab * speed
    generator = [x * w_second + y * w_first for x, y in zip(first, second, strict=True)]
    below = w_first * w_second
    return [*[x * below for x in p], *[x * w for x in generator]], w * below


def inline_rectifying_reduced(p, w, n):
    a, b, c = differences(p, w, n, d)
    binormal = cross(a, b)
    turning, bend, speed = dot(binormal, c), dot(binormal, binormal), dot(a, a)
    generator = [x * turning * speed + y * bend for x, y in zip(a, binormal, strict=True)]
    below = bend * speed
    return [*[x * below for x in p], *[x * w for x in generator]], w * below


WHAT = {
    "torsion, naive": (torsion, inline_torsion),
    "torsion, reduced": (torsion_reduced, partial(inline_torsion_reduced, d=d)),
    "rectifying developable, naive": (lambda c: rectifying_developable(c).joined, inline_rectifying),
    "rectifying developable, reduced": (lambda c: rectifying_developable_reduced(c).joined, inline_rectifying_reduced),
}


def size(value):
    """Degree, control points, and bits of all integers of numerators and denominator."""
    numerators, denominator = split(value)
    bits = sum(abs(int(x)).bit_length() for s in (*numerators, denominator) for c in s.numerators for x in c.coeffs())
    return {"degree": value.degree, "control points": control_point_count(value), "bits": bits}


@pytest.mark.parametrize("degree", DEGREES)
@pytest.mark.parametrize("who", ["exactspline", "python-flint inline"])
@pytest.mark.parametrize("what", WHAT)
def test_space(benchmark, what, who, degree):
    benchmark.group = f"{what}, rational Bézier curve of degree {degree}"
    compute, inline = WHAT[what]
    c = curve(degree, dimension=3)
    *p, w = [spline.numerators[0] for spline in (*c.p, c.w)]
    if who == "python-flint inline":
        assert benchmark.pedantic(inline, args=(p, w, degree), rounds=50)
        return
    value = benchmark.pedantic(compute, setup=lambda: fresh(c), rounds=50)
    numerators, denominator = split(value)
    top, bottom = inline(p, w, degree)
    tops = top if isinstance(top, list) else [top]
    assert all(x.numerators[0] * bottom == y * denominator.numerators[0] for x, y in zip(numerators, tops, strict=True))
    benchmark.extra_info |= size(value)
