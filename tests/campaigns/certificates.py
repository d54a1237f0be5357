"""Certificates of intersections, common zeros and curves of zeros, changed at random: what the checker accepts must be
true of the changed data, by elimination (`tests.support.elimination_oracle`) or, of curves, by the library; neither
shares code with the checker.

python -m tests.campaigns.certificates --count 1000 --seed 1 --record campaign.json
"""

import argparse
import copy
import json
import sys
from collections import Counter
from fractions import Fraction
from itertools import product
from math import comb
from operator import itemgetter
from pathlib import Path
from random import Random

from exactspline import TensorSpline, check_certificate, common_zeros, intersections, zero_curve
from exactspline.bivariate.zero_curve import Shape
from exactspline.errors import ReachError, ShapeError
from exactspline.polynomials.two_parameters import as_form
from tests.campaigns.common_zeros import any_polynomial, irrational, tangent, through
from tests.campaigns.intersections import FAMILIES, curve
from tests.support.elimination_oracle import S, T, common_points, solutions

#: Texts in certificates that are not numbers.
WORDS = (
    ("crossed", "point", "edge", "eliminated"),
    ("first", "second"),
    ("sign", "first monotone", "second monotone"),
    ("node", "point", "branches"),
)


# ---- certificates


def of_intersections(random):
    """A pair of the campaign of intersections, without common arcs, and its certificate."""
    while True:
        family = random.choice([f for name, f in FAMILIES.items() if name not in ("overlapping", "elevated", "itself")])
        curves = [curve(rows) for rows in family(random)[:2]]
        try:
            return curves, intersections(*curves).certificate()
        except (ReachError, ShapeError):
            continue


def of_common_zeros(random):
    """Two functions on one or two patches, perhaps with zeros on borders and in corners, and their certificate."""
    while True:
        m, n = random.randint(1, 3), random.randint(1, 2)
        first, second = (
            [0] * (m + 1) + [1] * (m + 1),
            random.choice([[0] * (n + 1) + [1] * (n + 1), [0] * (n + 1) + [1] + [2] * (n + 1)]),
        )
        shape = len(first) - m - 1, len(second) - n - 1
        nets = [[[random.randint(-5, 5) for _ in range(shape[1])] for _ in range(shape[0])] for _ in range(2)]
        for net in nets:
            if random.random() < 0.5:
                net[0][0] = 0
        if random.random() < 0.3:  # the same function on a border
            nets[1][-1] = nets[0][-1]
        functions = [TensorSpline((m, n), first, second, net) for net in nets]
        try:
            return functions, common_zeros(*functions).certificate()
        except ReachError:
            continue


def of_multiple_zeros(random):
    """Two functions or three with zeros of any multiplicity, of the campaign of common zeros, and their certificate."""
    while True:
        pair = random.choice([through, irrational, tangent])(random)
        functions = [spline(p) for p in (*pair, *[pair[0] + pair[1] * (S - T)] * (random.random() < 0.2))]
        try:
            found = common_zeros(*functions)
            if any(zero.multiplicity != 1 for zero in found):
                return functions, found.certificate()
        except ReachError:
            continue


def spline(p):
    """A polynomial in s and t as a function on the unit square."""
    net = as_form(p).matrix.tolist()
    m, n = len(net) - 1, len(net[0]) - 1
    knots = ([0] * (k + 1) + [1] * (k + 1) for k in (m, n))
    return TensorSpline((m, n), *knots, [[int(x) for x in row] for row in net])


def of_zero_curves(random):
    """A function with loops, arcs, crossings, singular points, lines or multiple factors, and the certificate of its
    zeros.
    """
    while True:
        x, y = random.randint(1, 4) * S - random.randint(0, 2), random.randint(1, 4) * T - random.randint(0, 2)
        p = random.choice(
            [
                any_polynomial(random, random.randint(1, 4), random.randint(1, 3)),
                any_polynomial(random, 2, 1) * any_polynomial(random, 1, 2),
                sum((f * any_polynomial(random, 1, 1, 4) for f in (x * x, x * y, y * y)), S * 0),
                any_polynomial(random, 1, 0) * any_polynomial(random, 1, 1) ** 2,
                y**2 - random.randint(1, 3) * x ** random.randint(3, 5),
            ]
        )
        if p.total_degree() > 0:
            found = zero_curve(spline(p))
            try:
                return found, found.certificate()
            except ReachError:
                continue


def of_corners(random):
    """A function on one to three patches whose net has zeros in corners, perhaps along edges, and perhaps a factor that
    vanishes on lines, and the certificate of its zeros.
    """
    while True:
        m, n = random.randint(1, 3), random.randint(1, 2)
        net = [[random.randint(-4, 4) for _ in range(n + 1)] for _ in range(m + 1)]
        for i, j in random.sample([(0, 0), (0, -1), (-1, 0), (-1, -1)], random.randint(1, 3)):
            net[i][j] = 0
        if random.random() < 0.2:
            net[random.choice([0, -1])] = [0] * (n + 1)
        if random.random() < 0.6:  # one sign, so that corners are single points
            net = [[abs(x) for x in row] for row in net]
        f = TensorSpline((m, n), *([0] * (k + 1) + [1] * (k + 1) for k in (m, n)), net)
        if random.random() < 0.5:
            lines = [S, T, 1 - T, 2 * S - 1, 2 * T * T - 1, (3 * S - 1) * T, 3 * T * T - 2]
            f = f * spline(random.choice(lines))
        for direction in range(2):
            if random.random() < 0.2:
                f = f.insert_knot(direction, "1/2")
        if any(map(any, net)):
            try:
                found = zero_curve(f)
                return found, found.certificate()
            except ReachError:
                continue


# ---- changes


def spots(data, path=()):
    """The paths to everything in a certificate."""
    inside = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    return [path, *[spot for key, x in inside for spot in spots(x, (*path, key))]]


def changed(certificate, random):
    """A copy with one thing changed, removed, repeated or exchanged."""
    forged = copy.deepcopy(certificate)
    path = random.choice(spots(forged)[1:])
    holder = forged
    for key in path[:-1]:
        holder = holder[key]
    key, value = path[-1], holder[path[-1]]
    if isinstance(value, (list, dict)) or random.random() < 0.2:
        if not isinstance(holder, list) or (way := random.randrange(3)) == 0:
            del holder[key]
        elif way == 1:
            holder.insert(key, copy.deepcopy(value))
        else:
            other = random.randrange(len(holder))
            holder[key], holder[other] = holder[other], holder[key]
    else:
        holder[key] = another(value, random)
    return forged


def another(value, random):
    """Another value of the same type."""
    if isinstance(value, bool):
        return not value
    if isinstance(value, int):
        return value + random.choice([-1, 1])
    for words in WORDS:
        if value in words:
            return random.choice([word for word in words if word != value])
    try:
        number = Fraction(value)
    except ValueError:
        return value + "x"
    return str(random.choice([number - 1, number + 1, number + Fraction(1, 3), -number, 2 * number]))


# ---- what is true of the data


def points_of(certificate):
    """The number of common points of all pairs of segments, None where two have an arc in common."""
    curves = [[rows_of(segment) for segment in certificate[side]] for side in ("first", "second")]
    counts = [number_of_points(*pair) for pair in product(*curves)]
    return None if None in counts else sum(counts)


def rows_of(segment):
    """The control points of a segment, their coordinates times the weight, and this."""
    return list(zip(*([Fraction(x) for x in segment[name]] for name in "xyw"), strict=True))


def number_of_points(*rows):
    """By elimination; where there is a common component, of which the segments may be arcs apart, by the library."""
    points, shared = common_points(*rows)
    if not shared:
        return len(points)
    found = intersections(*(curve([own]) for own in rows))
    return None if found.everywhere else len(found)


def zeros_of(certificate):
    """The number of common zeros on all patches, None where a component is common."""
    found = [solutions([polynomial(net) for net in patch["functions"]]) for patch in certificate["patches"]]
    return None if any(shared for _, shared in found) else sum(len(zeros) for zeros, _ in found)


def polynomial(net):
    m, n = len(net) - 1, len(net[0]) - 1
    terms = [
        int(x) * comb(m, i) * comb(n, j) * S**i * (1 - S) ** (m - i) * T**j * (1 - T) ** (n - j)
        for i, row in enumerate(net)
        for j, x in enumerate(row)
    ]
    return sum(terms, S * 0)


def topology_of(certificate):
    """“The checker counts lines, loops, arcs, curves with crossings and single points on every patch”
    (docs/two-parameters.md): these counts of the answers; None where something is undecided.
    """
    total = Counter()
    for patch in certificate["patches"]:
        net = [[int(x) for x in row] for row in patch["function"]]
        knots = ([0] * len(own) + [1] * len(own) for own in (net, net[0]))
        found = zero_curve(TensorSpline((len(net) - 1, len(net[0]) - 1), *knots, net))
        if found.undecided or found.everywhere:
            return None
        total += Counter(SHAPES[curve.shape] for curve in found.curves)
        total += {"lines": len(found.lines), "points": len(found.points)}
    return counts_of(total)


SHAPES = {Shape.LOOP: "loops", Shape.ARC: "arcs", Shape.CROSSED: "crossed"}


def counts_of(found):
    return [found[what] for what in ("lines", "loops", "arcs", "crossed", "points")]


#: A certificate of each sort; what is true of its data; and the same in what the checker returns.
SORTS = {
    "intersections": (of_intersections, points_of, itemgetter("points")),
    "common zeros": (of_common_zeros, zeros_of, itemgetter("zeros")),
    "multiple zeros": (of_multiple_zeros, zeros_of, itemgetter("zeros")),
    "zero curves": (of_zero_curves, topology_of, counts_of),
    "zeros in corners": (of_corners, topology_of, counts_of),
}


def campaign(sort, count, seed, every=8):
    """Change certificates until this many are rejected; a new certificate for each `every` changes."""
    write, true_of, what = SORTS[sort]
    random, counts, wrong = Random(seed), Counter(), []
    while counts["rejected"] < count:
        if counts["changed"] % every == 0:
            certificate = json.loads(json.dumps(write(random)[1]))
            counts["written"] += 1
            if what(check_certificate(certificate)) != true_of(certificate):
                wrong.append(certificate)
        counts["changed"] += 1
        forged = changed(certificate, random)
        try:
            claimed = what(check_certificate(forged))
        except ValueError:
            counts["rejected"] += 1
            continue
        counts["accepted"] += 1
        data = "first", "second", "patches"
        counts["accepted with other data"] += any(forged.get(key) != certificate.get(key) for key in data)
        if claimed != true_of(forged):
            wrong.append(forged)
    return {"sort": sort, "seed": seed, **counts, "accepted and false": wrong}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--every", type=int, default=8, help="changes of each certificate")
    parser.add_argument("--sort", choices=SORTS, action="append")
    parser.add_argument("--record", type=Path)
    chosen = parser.parse_args()
    found = [campaign(sort, chosen.count, chosen.seed, chosen.every) for sort in chosen.sort or SORTS]
    text = json.dumps(found, indent=2)
    if chosen.record:
        chosen.record.write_text(text, encoding="utf-8")
    print(text)
    return int(any(each["accepted and false"] for each in found))


if __name__ == "__main__":
    sys.exit(main())
