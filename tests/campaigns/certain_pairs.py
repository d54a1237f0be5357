"""Pairs of plane segments that the extension decides in doubles against exact arithmetic: seeded.

python -m tests.campaigns.certain_pairs COUNT SEED

Of each family it tells how many pairs are decided. What is decided must have exactly the common points that Bézout's
matrix has in integers, each inside its intervals, and the sign before it. Where its parameters are known to twice the
precision of doubles, they are those, and so are the doubles nearest to them.
"""

import sys
import time
from collections import Counter
from fractions import Fraction
from math import isnan
from random import Random

from exactspline.geometry.pairs.lazy_intersections import PairForm
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import UNIT
from exactspline.polynomials.plane_pairs import meetings
from exactspline.polynomials.zero_places import sign_at
from exactspline.programs.certain_pairs import certain_pair, closer, points_of, precise_table_of, table_of
from exactspline.roots.root import InDoubles
from exactspline.roots.segment_forms import parameter, plane_forms, segment_rows
from tests.campaigns import intersections as pairs

#: Digits to which the exact parameters are compared.
DIGITS = 40


def cubics(chance):
    """Two cubics, their control points any doubles between −1 and 1."""
    return [[(*(Fraction(chance.uniform(-1, 1)) for _ in range(2)), Fraction(1)) for _ in range(4)] for _ in range(2)]


def of_some_degrees(chance, highest=5):
    """Degrees from 1 to 5, of integers, with weights, of either sign at times."""
    found = []
    for _ in range(2):
        w = chance.choice([1, 1, -1]) * Fraction(1, chance.choice([1, 3]))
        weights = [w * chance.choice([1, 1, chance.randint(1, 5)]) for _ in range(chance.randint(2, highest + 1))]
        size = chance.choice([3, 20, 10**6])
        found.append([(*(chance.randint(-size, size) * u for _ in range(2)), u) for u in weights])
    return found


def of_high_degrees(chance):
    """Degrees up to 10."""
    return of_some_degrees(chance, 10)


def of_large_weights(chance):
    """Degrees up to 8, of doubles, with weights from 10⁻³ to 10³."""
    weights = [[Fraction(10 ** chance.uniform(-3, 3)) for _ in range(chance.randint(2, 9))] for _ in range(2)]
    return [[(*(w * Fraction(chance.uniform(-1, 1)) for _ in range(2)), w) for w in own] for own in weights]


def far_away(chance):
    """Small segments far from the origin."""
    x, y = (Fraction(chance.choice([10**3, 10**9, 2**60 + 1])) for _ in range(2))
    return [[(a * Fraction(1, 16) + x, b * Fraction(1, 16) - y, w) for a, b, w in rows] for rows in cubics(chance)]


def moved_together(chance):
    """An inner point of one all but on an end, or on any point, of the other."""
    given = cubics(chance)
    places = [chance.choice([Fraction(0), Fraction(1)]), Fraction(chance.randint(0, 8), 8)]
    off = Fraction(chance.choice([0, 1, -1]), 1 << chance.randint(20, 90))
    (x, y), on = (at(rows, t) for rows, t in zip(given, places, strict=True))
    given[1] = [(a - on[0] + x + off, b - on[1] + y, w) for a, b, w in given[1]]
    return given[:: chance.choice([1, -1])]


def at(rows, t):
    """The point of a polynomial cubic."""
    weights = [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t**3]
    return [sum(w * row[k] for w, row in zip(weights, rows, strict=True)) for k in range(2)]


def known(family):
    """The two curves of a family of the other campaign."""

    def made(chance):
        return family(chance)[:2]

    made.__name__ = family.__name__
    return made


def raised(family):
    """The two curves of another family in higher degrees."""

    def made(chance):
        return [higher(rows, chance.randint(1, 5)) for rows in family(chance)[:2]]

    made.__name__ = f"raised_{family.__name__}"
    return made


def higher(rows, times):
    """A curve in a higher degree."""
    for _ in range(times):
        n = len(rows)
        pairs_of = zip([(0, 0, 0), *rows], [*rows, (0, 0, 0)], range(n + 1), strict=True)
        rows = [tuple((k * x + (n - k) * y) / n for x, y in zip(a, b, strict=True)) for a, b, k in pairs_of]
    return rows


#: With the share of pairs that must be decided, per mille.
FAMILIES = {
    cubics: 999,
    of_some_degrees: 900,
    of_high_degrees: 900,
    of_large_weights: 900,
    far_away: 930,
    moved_together: 100,
    known(pairs.tangent): 0,
    known(pairs.nearly_touching): 0,
    known(pairs.of_no_kind): 900,
    known(pairs.doubles): 980,
    known(pairs.circles): 700,
    known(pairs.through_a_node): 0,
    known(pairs.overlapping): 0,
    raised(moved_together): 0,
    raised(pairs.tangent): 0,
    raised(pairs.nearly_touching): 0,
    raised(pairs.of_no_kind): 0,
    raised(pairs.through_a_node): 0,
}
#: What chance alone may leave of a few pairs.
FEW = 5


def differing(rows, decide=certain_pair):
    """How many common points were compared (None where exact arithmetic decides), and what differs ("" for nothing)."""
    curves = [pairs.curve(one) for one in rows]
    given = [segment_rows(curve, 0) for curve in curves]
    table = table_of(given)
    certain = decide(table, 0, table, 1)
    if certain is None:
        return None, ""
    found = points_of(certain)
    true = meetings(*(plane_forms(curve, 0) for curve in curves))
    if true.arcs or true.rests or len(true.points) != len(found):
        return 0, f"{found} where {true} is right"
    form = PairForm(*given)
    of_degree = 0 if form.exchanged else 1
    numbers = [[parameter(local, *UNIT) for local in (point.first, point.second)] for point in true.points]
    rest, (precise, other) = list(range(len(found))), (precise_table_of([segment], UNIT[0]) for segment in given)
    for one in found:
        inside = [k for k in rest if all(map(is_inside, numbers[k], (one[:2], one[2:4])))]
        if len(inside) != 1:
            return 0, f"{[numbers[k] for k in inside]} are in {one}"
        rest.remove(inside[0])
        if true.points[inside[0]].multiplicity != 1:
            return 0, f"{one} is not simple"
        near = closer(precise, 0, other, 0, one[:4])
        for real, interval, own in zip(numbers[inside[0]], (one[:2], one[2:4]), (near[:4], near[4:]), strict=True):
            a, b = real.enclosure(DIGITS)
            if own and not abs((a + b) / 2 - mpq(own[0]) - mpq(own[1])) <= mpq(own[2]) + (b - a):
                return 0, f"{real} is not {own}"
            double = InDoubles(interval, own, UNIT[0]).nearest(UNIT[0], "nearest")
            if not isnan(double) and double != real.double():
                return 0, f"{double} is not the double nearest to {real}"
        (low, high), (before, number) = one[2 * of_degree :][:2], one[4:]
        if number < 0:
            continue
        if sign_at(form.form.polynomial, mpq(low)) != before:
            return 0, f"the sign before {one}"
        if sign_at(form.form.polynomial, mpq(high)) != -before:
            return 0, f"the sign behind {one}"
        exact = form.inner[int(number)]
        if not (exact.low < high and low < exact.high):
            return 0, f"{one} is another zero"
    return len(found), ""


def is_inside(real, interval):
    """Whether a parameter is in an interval, and inside its segment."""
    (a, b), (low, high) = real.enclosure(DIGITS), interval
    return low <= a and b <= high and 0 <= low <= high <= 1 and a > 0 and b < 1


def campaign(count, seed, decide=certain_pair):
    """The pairs, the decided ones and their common points of every family, and what differs."""
    made, decided, points, wrong = Counter(), Counter(), Counter(), []
    chance, families = Random(seed), list(FAMILIES)
    for k in range(count):
        family = families[k % len(families)]
        rows, name = family(chance), family.__name__
        found, what = differing(rows, decide)
        made[name] += 1
        decided[name] += found is not None
        points[name] += found or 0
        if what:
            wrong.append(f"{name}: {what}: {rows}")
    return made, decided, points, wrong


def below_floor(made, decided):
    """The families of which fewer pairs are decided than must be."""
    floors = {family.__name__: floor for family, floor in FAMILIES.items()}
    return [name for name in made if 1000 * (decided[name] + FEW) < floors[name] * made[name]]


def main(count, seed):
    """Compare and print."""
    began = time.process_time()
    made, decided, points, wrong = campaign(count, seed)
    for name in made:
        share = 100 * decided[name] / made[name]
        print(f"{name}: {made[name]} pairs, {decided[name]} decided ({share:.2f} %), {points[name]} points")
    print(*wrong[:10], sep="\n")
    print(f"{len(wrong)} wrong of {sum(decided.values())} decided, {time.process_time() - began:.0f} s")
    for name in (below := below_floor(made, decided)):
        print(f"{name}: fewer are decided than must be")
    return int(bool(wrong or below))


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]), int(sys.argv[2])))
