"""What hypothesis draws from, biased to trouble: jumps, repeated knots, tiny and far-off intervals, huge and tiny
coordinates, coinciding points.
"""

from gmpy2 import mpq
from hypothesis import strategies as st

from exactspline import BSpline, Nurbs, TensorSpline
from exactspline.language import Vector
from exactspline.splines.tensor import lifted

KINK = BSpline(1, [0, 0, "1/2", 1, 1], [0, 1, 0])
JUMP = BSpline(0, [0, "1/2", 1], [0, 1])
TINY, HUGE = mpq(1, 10**12), mpq(10**20)
DOMAINS = [
    (mpq(0), mpq(1)),
    (mpq(-1), mpq(2)),
    (mpq(0), TINY),
    (HUGE, HUGE + 1),
    (mpq(-1, 3), mpq(1, 7)),
    (mpq(0), HUGE),
]
#: Where interior breakpoints may lie, as parts of the domain.
PARTS = [mpq(1, 2), mpq(1, 3), mpq(2, 3), mpq(1, 2) + TINY, TINY, 1 - TINY, mpq(1, 5), mpq(3, 7)]


def numbers():
    """Exact numbers, mostly small, some huge, tiny or with long denominators."""
    small = st.integers(-3, 3).map(mpq)
    fractions = st.builds(mpq, st.integers(-50, 50), st.integers(1, 12))
    special = st.sampled_from([HUGE, -HUGE, TINY, -TINY, HUGE + TINY, mpq(2**89 - 1, 3**40), mpq(0)])
    return st.one_of(small, small, fractions, special)


def positive_numbers():
    """Weights: positive, not all of one size."""
    return st.one_of(
        st.sampled_from([mpq(1), mpq(1), mpq(2), mpq(1, 2)]),
        st.builds(mpq, st.integers(1, 9), st.integers(1, 9)),
        st.just(TINY),
    )


@st.composite
def ends(draw, n, a, outwards):
    """Knots at one end of the domain, from outside to inside: of any multiplicity, the missing ones farther out."""
    multiplicity = draw(st.sampled_from([n + 1, n + 1, *range(1, n + 2)]))
    missing = (
        draw(st.integers(n + 1 - multiplicity, n))
        if multiplicity <= n and draw(st.booleans())
        else n + 1 - multiplicity
    )
    steps = draw(st.lists(st.sampled_from([mpq(0), mpq(1), mpq(1, 3), TINY]), min_size=missing, max_size=missing))
    knots, t = [a] * multiplicity, a
    for i, step in enumerate(steps):
        t += outwards * (step if i else step or 1)
        knots.append(t)
    return knots[::-1]


@st.composite
def knot_vectors(draw, n, domain, most=2):
    """Knots for degree n over the domain: interior multiplicities up to n + 1, clamped ends or not."""
    a, b = domain
    inner = sorted(draw(st.lists(st.sampled_from(PARTS), max_size=most, unique=True)))
    multiplicities = [draw(st.sampled_from([1, n or 1, n + 1, *range(1, n + 2)])) for _ in inner]
    middle = [a + (b - a) * x for x, m in zip(inner, multiplicities, strict=True) for _ in range(m)]
    return [*draw(ends(n, a, -1)), *middle, *draw(ends(n, b, 1))[::-1]]


@st.composite
def control_points(draw, count, values=None):
    """Control points, now and then all equal or equal in runs."""
    values = numbers() if values is None else values
    if draw(st.integers(0, 4)) == 0:
        return [draw(values)] * count
    points = draw(st.lists(values, min_size=count, max_size=count))
    return [points[i // 2 * 2] for i in range(count)] if draw(st.integers(0, 4)) == 0 else points


@st.composite
def splines(draw, low=0, high=4, domain=None, values=None, most=2):
    """A scalar spline of a degree from low to high."""
    n = draw(st.integers(low, high))
    knots = draw(knot_vectors(n, domain or draw(st.sampled_from(DOMAINS)), most))
    return BSpline(n, knots, draw(control_points(len(knots) - n - 1, values)))


@st.composite
def splines_on_one_domain(draw, count=2, low=0, high=4, values=None):
    """Splines over one domain with knots and degrees of their own."""
    domain = draw(st.sampled_from(DOMAINS))
    return [draw(splines(low, high, domain, values)) for _ in range(count)]


@st.composite
def vectors(draw, dimension=3, low=0, high=3):
    """A vector of splines of different degrees and knots."""
    return Vector(*draw(splines_on_one_domain(dimension, low, high)))


@st.composite
def nurbs(draw, dimension=2, low=2, high=3, most=1):
    """A rational curve with positive weights: general, with a cusp or a run of equal points, straight, or straight up
    to a hair.
    """
    n = draw(st.integers(low, high))
    knots = draw(knot_vectors(n, draw(st.sampled_from(DOMAINS[:5])), most))
    count = len(knots) - n - 1
    kind = draw(st.sampled_from(["general", "general", "doubled", "straight", "nearly straight", "flat"]))
    rows = draw(st.lists(st.tuples(*[numbers()] * dimension), min_size=count, max_size=count))
    if kind == "doubled":
        rows = [rows[i // 2 * 2] for i in range(count)]
    elif kind in ("straight", "nearly straight"):
        rows = [tuple(row[0] * (k + 1) + k for k in range(dimension)) for row in rows]
    elif kind == "flat":
        rows = [(*row[:-1], mpq(1)) for row in rows]
    if kind == "nearly straight":
        rows[-1] = (*rows[-1][:-1], rows[-1][-1] + TINY)
    return Nurbs(n, knots, rows, draw(st.lists(positive_numbers(), min_size=count, max_size=count)))


@st.composite
def tensor_splines(draw, domains=None, high=2, most=1, values=None):
    """A spline in two parameters: over a net, or of one parameter only, known as such or not, or a constant."""
    domains = domains or (draw(st.sampled_from(DOMAINS)), draw(st.sampled_from(DOMAINS)))
    m, n = (draw(st.integers(0, high)) for _ in range(2))
    knots = [draw(knot_vectors(k, domain, most)) for k, domain in zip((m, n), domains, strict=True)]
    rows, columns = len(knots[0]) - m - 1, len(knots[1]) - n - 1
    kind = draw(st.sampled_from(["net", "net", "net", "s", "t", "s, as a net", "t, as a net", "constant"]))
    if kind == "net":
        return TensorSpline((m, n), *knots, [draw(control_points(columns, values)) for _ in range(rows)])
    first = draw(control_points(rows, values)) if kind.startswith("s") else [mpq(1)] * rows
    second = draw(control_points(columns, values)) if kind.startswith("t") else [mpq(1)] * columns
    spline = TensorSpline((m, n), *knots, [[a * b for b in second] for a in first])
    if kind == "constant":
        return spline.constant(draw(numbers() if values is None else values))
    if kind in ("s", "t"):
        return lifted(
            spline.at_t(domains[1][0]) if kind == "s" else spline.at_s(domains[0][0]), spline.meshes, "st".index(kind)
        )
    return spline


@st.composite
def tensor_splines_on_one_rectangle(draw, count=2, high=2, most=1, values=None):
    """Splines in two parameters over one rectangle, with knots and degrees of their own."""
    domains = draw(st.sampled_from(DOMAINS)), draw(st.sampled_from(DOMAINS))
    return [draw(tensor_splines(domains, high, most, values)) for _ in range(count)]
