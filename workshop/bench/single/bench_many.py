"""Inflections and curvature extrema of many plane curves: one by one in exact arithmetic, and as a batch of arrays.

``python -m workshop.bench.single.bench_many [count]`` prints processor milliseconds per curve. The 400 curves of the
first table have degrees 2 to 5 and one to four segments, half of them are rational; once with small integers, once with
doubles. The batches are random Bézier curves, each answer certified; the share decided by exact arithmetic is shown.
"""

import random
import sys
from time import process_time

import numpy as np

from exactspline import Nurbs, analyse
from exactspline.geometry.analysis.many_curves import features_of_curves
from exactspline.numbers.exact import from_float


def curves(count, seed=1, *, doubles=False):
    """The data of random plane curves."""
    numbers = random.Random(seed)

    def coordinate():
        return from_float(numbers.uniform(-9, 9)) if doubles else numbers.randint(-9, 9)

    def weight():
        return from_float(numbers.uniform(0.5, 4)) if doubles else numbers.randint(1, 5)

    for i in range(count):
        degree, segments = numbers.randint(2, 5), numbers.randint(1, 4)
        knots = [0] * (degree + 1) + list(range(1, segments)) + [segments] * (degree + 1)
        points = [(coordinate(), coordinate()) for _ in range(degree + segments)]
        yield degree, knots, points, [weight() for _ in points] if i % 2 else None


def features(curve):
    """Inflections and extrema of one curve."""
    analysis = analyse(curve)
    return analysis.inflections, analysis.curvature_extrema


def milliseconds(work, count):
    """Processor time per item, the best of three runs."""
    best = float("inf")
    for _ in range(3):
        start = process_time()
        work()
        best = min(best, process_time() - start)
    return 1000 * best / count


def main(count):
    """Print both tables."""
    for doubles in (False, True):
        data = list(curves(400, doubles=doubles))
        making = milliseconds(lambda data=data: [Nurbs(*each) for each in data], len(data))
        both = milliseconds(lambda data=data: [features(Nurbs(*each)) for each in data], len(data))
        name = "doubles" if doubles else "integers"
        print(f"400 curves, {name}: {both - making:.3f} ms per curve, construction {making:.3f}", flush=True)
    numbers = np.random.default_rng(1)
    for degree in (2, 3, 4, 5):
        points, weights = numbers.uniform(-9, 9, (count, degree + 1, 2)), numbers.uniform(0.5, 4, (count, degree + 1))
        for w in (None, weights):
            features_of_curves(points[:64], None if w is None else w[:64])
            start = process_time()
            many = features_of_curves(points, w)
            each, exact = 1000 * (process_time() - start) / count, 100 * len(many.exact) / count
            kind = "polynomial" if w is None else "rational"
            print(
                f"{count} Bézier curves of degree {degree}, {kind}: {each:.4f} ms per curve, {exact:.2f} % exactly, "
                f"{len(many.curve)} features, median width {np.median(many.high - many.low):.0e}",
                flush=True,
            )


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 10**5)
