"""Everything that `inspect` computes of a cubic spline, from ten segments up: the time per segment must not grow.

As a program (``python -m workshop.bench.single.bench_analysis [most]``) it goes up to 10⁵ segments and prints the
growth of the time per segment from a hundred segments upwards (below that, the constant cost per curve dominates); it
fails when the time per segment doubles.
"""

import random
import sys
from time import process_time

import pytest

from exactspline import Nurbs
from exactspline.geometry.analysis.inspection import inspect_curve


def spline(segments, dimension):
    """A cubic spline with knots 0, 1, 2, …, that is monotone in x and otherwise random."""
    numbers = random.Random(1)
    points = [[i, *(numbers.randint(-9, 9) for _ in range(dimension - 1))] for i in range(segments + 3)]
    return Nurbs(3, [0] * 3 + list(range(segments + 1)) + [segments] * 3, points)


def milliseconds(segments, dimension):
    """Processor time per segment of the whole analysis, in milliseconds; for small splines the best of three runs."""
    best = float("inf")
    for _ in range(3 if segments <= 1000 else 1):
        curve = spline(segments, dimension)
        start = process_time()
        inspect_curve(curve)
        best = min(best, process_time() - start)
    return 1000 * best / segments


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("segments", [10, 100, 1000])
def bench_analysis(benchmark, segments, dimension):
    benchmark.pedantic(
        inspect_curve, setup=lambda: ((spline(segments, dimension),), {}), rounds=3, warmup_rounds=segments == 10
    )


def main(most):
    """Print the times up to this many segments; the largest growth determines the exit status."""
    worst = 0.0
    for dimension in (2, 3):
        times = {}
        for segments in (10**k for k in range(1, 6) if 10**k <= most):
            times[segments] = milliseconds(segments, dimension)
            print(f"R{dimension} {segments:>7} segments: {times[segments]:.3f} ms per segment", flush=True)
        worst = max([worst, *[time / times[100] for segments, time in times.items() if segments > 100]])
    print(f"the time per segment grows by at most {worst:.2f}")
    return worst < 2


if __name__ == "__main__":
    sys.exit(not main(int(sys.argv[1]) if len(sys.argv) > 1 else 10**5))
