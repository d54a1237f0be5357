"""A reproducible search for curves whose reduced form is worse, or better, conditioned than an unreduced one.

``python -m tests.campaigns.conditioning COUNT SEED`` searches this many curves of each family; the exit status is 1
where the reduced form is better though the theorem says that it is not.
"""

import sys
from dataclasses import dataclass
from random import Random

from exactspline.errors import ShapeError
from exactspline.geometry.derived.constructions import Variant
from exactspline.numbers.exact import mpq
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.verification.conditioning import conditioning

#: The zero-set constructions included in the search.
SEARCHED = ("zero_curvature", "critical_curvature")


@dataclass
class Tally:
    """The results of the search in one family, construction and form: zeros at which the reduced (minimal) form is
    worse or better conditioned.

    `proved` counts the zeros at which it is not better by the theorem, `contradicted` those among them at which it is
    (there are none). `smallest` and `largest` are the extreme ratios of the condition number of the reduced form to
    that of the form, each with its curve. `double_worse` and `double_better` count by the error of double precision,
    where that was measured and the two errors differ by more than one rounding unit (a form in which the zero is not
    found counts as worse).
    """

    family: str
    construction: str
    form: str
    worse: int = 0
    better: int = 0
    equal: int = 0
    proved: int = 0
    contradicted: int = 0
    double_worse: int = 0
    double_better: int = 0
    smallest: tuple[mpq, Nurbs] | None = None
    largest: tuple[mpq, Nurbs] | None = None

    def add(self, row, curve):
        """Count one zero."""
        sign, ratio, own = row.compare(self.form), row.ratio(self.form), row[self.form]
        self.worse, self.better, self.equal = (
            self.worse + (sign > 0),
            self.better + (sign < 0),
            self.equal + (sign == 0),
        )
        if own.one_sign and own.growth is not None:
            self.proved, self.contradicted = self.proved + 1, self.contradicted + (sign < 0)
        if self.smallest is None or ratio < self.smallest[0]:
            self.smallest = ratio, curve
        if self.largest is None or ratio > self.largest[0]:
            self.largest = ratio, curve
        ours, theirs = row[Variant.MINIMAL].double, own.double
        if ours is not None and theirs is not None:
            lost = mpq(2**53)
            gap = (lost if ours.units is None else ours.units) - (lost if theirs.units is None else theirs.units)
            self.double_worse, self.double_better = self.double_worse + (gap > 1), self.double_better + (gap < -1)


def search_witnesses(seed=0, count=10, *, doubles=False):
    """Compare the forms at the zeros of `count` random curves of each family, of degree 2 or 3 with one segment and
    small integer control points.

    The families: positive small integers as weights; the same with one weight near zero; weights of which one is
    negative, such that the denominator comes close to zero inside the segment but stays positive, and the discarded
    denominator with it. The same seed always gives the same curves. With `doubles` the errors of double precision are
    compared too, which takes about a second per curve.

    Raises `ShapeError` when `count` is negative.
    """
    if count < 0:
        raise ShapeError(f"{count} curves", where="count", remedy="give an integer ≥ 0")
    tallies = {}
    for family, make in FAMILIES.items():
        for curve in _curves(family, make, Random(seed), count):
            for name in SEARCHED:
                for row in conditioning(curve, name, doubles=doubles).roots:
                    for form in row.forms:
                        if form.form != Variant.MINIMAL:
                            key = (family, name, form.form)
                            tallies.setdefault(key, Tally(*key)).add(row, curve)
    return list(tallies.values())


def _curves(family, make, random, count):
    for i in range(count):
        n = random.choice((2, 3))
        points = [(random.randint(-9, 9), random.randint(-9, 9)) for _ in range(n + 1)]
        yield Nurbs(n, [0] * (n + 1) + [1] * (n + 1), points, make(random, n), name=f"{family}, curve {i}")


def _positive(random, n):
    return [mpq(random.randint(1, 9)) for _ in range(n + 1)]


def _near_zero(random, n):
    weights = _positive(random, n)
    weights[random.randrange(n + 1)] = mpq(1, 10 ** random.randint(1, 6))
    return weights


def _dip(random, n):
    """``(t − a)² + ε``, for degree 3 times ``1 + c t``."""
    t = BSpline.identity(0, 1)
    w = (t - mpq(random.randint(3, 7), 10)) ** 2 + mpq(1, 10 ** random.randint(2, 5))
    return list((w if n == 2 else w * (1 + random.randint(1, 3) * t)).control_points)


FAMILIES = {"positive weights": _positive, "a weight near zero": _near_zero, "a denominator near zero": _dip}


def main(count, seed):
    contradicted = 0
    for t in search_witnesses(seed, count):
        contradicted += t.contradicted
        ratios = ", ".join(f"{float(ratio):.3g}" for ratio, _ in (t.smallest, t.largest))
        said = f"worse {t.worse}, better {t.better}, proved not better {t.proved} ({t.contradicted} wrongly)"
        print(f"{t.family}, {t.construction}, {t.form}: {said}; ratios {ratios}")
    return int(bool(contradicted))


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:])))
