"""From control points to all vertices: squaring, the paper's form and the lowest one, on the same curves in one run.

As a script it prints a table and draws it: ``python -m workshop.bench.single.bench_lowest --plot lowest.svg``; with
``--most 600`` a form whose degree times number of segments would exceed that is omitted (squaring soon does).
"""

import argparse
import random
from dataclasses import dataclass
from time import perf_counter

import pytest

from exactspline import Nurbs
from exactspline.geometry.analysis.curves import analyse
from exactspline.roots.zero_set import zeros

FORMS = ("squaring", "paper", "minimal")
DEGREES, SEGMENTS = (2, 3, 4, 5, 6), (1, 3, 10, 30, 100)
#: The degrees 48d, 9d − 6, 8d − 12: an estimate of the cost of a form before it is computed.
EXPECTED = {"squaring": lambda d: 48 * d, "paper": lambda d: 9 * d - 6, "minimal": lambda d: 8 * d - 12}


def curve(degree, segments, seed=1):
    """A random rational curve with uniform knots, integer control points and integer weights."""
    numbers = random.Random(seed + 1000 * degree + segments)
    knots = [0] * degree + list(range(segments + 1)) + [segments] * degree
    x, y, points = 0, 0, []
    for _ in range(segments + degree):
        x, y = x + numbers.randint(-3, 9), y + numbers.randint(-9, 9)
        points.append((x, y))
    return Nurbs(degree, knots, points, [numbers.randint(1, 9) for _ in points])


@dataclass
class Cost:
    """The cost of one form on one curve."""

    form: str
    degree: int
    segments: int
    form_degree: int
    control_points: int
    bits: int
    build: float
    solve: float
    roots: int


def cost(form, degree, segments, rounds=3):
    """Build the form from control points, then all its zeros, certified: the best of several rounds, each on a newly
    constructed curve.
    """
    build = solve = float("inf")
    for _ in range(rounds):
        c = curve(degree, segments)
        start = perf_counter()
        f = zero_form_only(c, form)
        built = perf_counter()
        zero_set = zeros(f)
        build, solve = min(build, built - start), min(solve, perf_counter() - built)
    bits = sum(int(x).bit_length() for p in f.numerators for x in p.coeffs())
    return Cost(form, degree, segments, f.degree, len(f.control_points), bits, build, solve, len(list(zero_set)))


def zero_form_only(c, form):
    from exactspline.geometry.derived.constructions import construction

    return construction("critical_curvature").on(c, form)


def measured(most):
    for degree in DEGREES:
        for segments in SEGMENTS:
            for form in FORMS:
                if EXPECTED[form](degree) * segments <= most:
                    yield cost(form, degree, segments)


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("degree", [2, 3, 4])
def test_vertices(benchmark, degree, form):
    c = curve(degree, 3)
    benchmark.group = f"all vertices of a rational curve of degree {degree}, 3 segments"
    found = benchmark.pedantic(analyse(c).zero_form, args=("critical_curvature", form), rounds=3).zeros
    true = analyse(c).zero_form("critical_curvature").zeros
    assert all(root in list(found) for root in true)


def table(rows):
    head = (
        f"{'d':>2} {'segments':>8} {'form':>9} {'degree':>6} {'points':>7} {'kbits':>9} {'build s':>9} "
        f"{'zeros s':>9} {'roots':>6}"
    )
    lines = [head]
    for r in rows:
        sizes = f"{r.form_degree:>6} {r.control_points:>7} {r.bits / 1000:>9.1f}"
        lines.append(f"{r.degree:>2} {r.segments:>8} {r.form:>9} {sizes} {r.build:>9.4f} {r.solve:>9.4f} {r.roots:>6}")
    return "\n".join(lines)


def draw(rows, path):
    import matplotlib as mpl

    mpl.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(1, 2, figsize=(11, 4.5))
    for axis, measure, label in (
        (axes[0], lambda r: r.build + r.solve, "seconds to all vertices"),
        (axes[1], lambda r: r.bits, "bits of the form"),
    ):
        for form, colour in zip(FORMS, ("tab:red", "tab:orange", "tab:blue"), strict=True):
            for degree, style in zip(DEGREES, ("-", "--", "-.", ":", (0, (1, 3))), strict=True):
                mine = [r for r in rows if r.form == form and r.degree == degree]
                axis.plot(
                    [r.segments for r in mine],
                    [measure(r) for r in mine],
                    color=colour,
                    linestyle=style,
                    label=f"{form}, d = {degree}",
                )
        axis.set(xscale="log", yscale="log", xlabel="segments", ylabel=label)
    axes[1].legend(fontsize=6, ncols=3)
    figure.tight_layout()
    figure.savefig(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--plot", default="", help="an SVG or PNG file to draw into")
    parser.add_argument("--most", type=int, default=10**9, help="omit forms whose degree times segments exceeds this")
    chosen = parser.parse_args()
    rows = []
    for row in measured(chosen.most):
        rows.append(row)
        print(table([row]).splitlines()[-1] if len(rows) > 1 else table([row]), flush=True)
    if chosen.plot:
        draw(rows, chosen.plot)


if __name__ == "__main__":
    main()
