"""Write the table of docs/approximated.md, computed exactly, and draw its picture: ``python -m docs.approximated``.

The page shows what polynomial approximations do to the curvature, the evolute and the torsion of rational curves.

A circle, an ellipse and a space curve over the circle are interpolated with their derivatives by the angle, by cubics
to first and by quintics to second order, at rational points. A tolerance is proved to be met: some polynomials have no
zero.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import exactspline as xs
from exactspline.geometry.curves.kinds import JointKind
from exactspline.geometry.curves.poles import between_poles
from exactspline.geometry.derived.derive import derive
from exactspline.numbers.exact import mpq
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs

PAGE = Path(__file__).with_name("approximated.md")
PICTURE = Path(__file__).with_name("pictures") / "approximated.png"
BEGIN, END = "<!-- written by python -m docs.approximated -->\n", "<!-- end -->\n"
DEGREES, TOLERANCES = (3, 5), tuple(mpq(1, 10**k) for k in range(2, 9, 2))
#: Angles are rounded to this many parts of a radian: the knots are rational.
PARTS = 10**15
HALF = mpq(1, 2)
#: The ellipse is the circle stretched along x by this factor, so that distances are at most doubled.
STRETCH = 2
NAMES = {"circle": "circle", "ellipse": "ellipse", "space": "space curve"}
DEGREE_NAMES = {0: "", 3: "cubics", 5: "quintics"}
SUPERSCRIPTS = "²⁴⁶⁸"
HEADS = ("curve", "by", "segments", "jumps of κN", "extrema of κ", "inflections", "cusps of the evolute", "zeros of τ")
#: Joints at which the curvature vector jumps.
JUMPS = (JointKind.TURN, JointKind.CURVATURE_JUMP)
Jet = tuple[mpq, mpq, mpq]


@dataclass(frozen=True)
class Found:
    """The numbers of features of an approximation or of the curve itself. If `constant`, the curvature is constant
    on some piece.
    """

    shape: str
    degree: int
    tolerance: mpq | None
    segments: int
    jumps: int
    extrema: int
    inflections: int
    cusps: int
    torsion_zeros: int | None
    constant: bool = False


def angle(v: mpq) -> mpq:
    """Return ``2 arctan v``, 0 ≤ v ≤ 1, to 15 decimals by the series of arctan; if v > 1/2, ``arctan(1/2)`` is
    subtracted first.
    """
    if v > HALF:
        return angle(HALF) + angle((v - HALF) / (1 + v * HALF))
    total, power, k = mpq(0), v, 1
    while power > mpq(1, PARTS):
        total += power / k * (1 if k % 4 == 1 else -1)
        power, k = power * v * v, k + 2
    return mpq(round(2 * total * PARTS), PARTS)


@cache
def stations(quarter: int) -> tuple[tuple[mpq, mpq, mpq], ...]:
    """Return the knot, the cosine and the sine of each of ``4 · quarter + 1`` rational points around the circle."""
    tangents = [mpq(k, quarter) for k in range(quarter + 1)]
    points = [((1 - u * u) / (1 + u * u), 2 * u / (1 + u * u)) for u in tangents[:-1]]
    steps = [angle((b - a) / (1 + a * b)) for a, b in itertools.pairwise(tangents)]
    around = [((x, y), (-y, x), (-x, -y), (y, -x)) for x, y in points]
    found, knot = [], mpq(0)
    for turn in range(4):
        for turned, step in zip(around, steps, strict=True):
            found.append((knot, *turned[turn]))
            knot += step
    return (*found, (knot, mpq(1), mpq(0)))


def hermite(knots: list[mpq], jets: list[Jet], degree: int) -> BSpline:
    """Return the spline of degree 3 or 5 with these values and derivatives at the knots."""
    order = degree // 2
    forms = []
    for (a, one), (b, other) in zip(zip(knots, jets, strict=True), zip(knots[1:], jets[1:], strict=True), strict=False):
        h = b - a
        first, last = ends(one, h, degree), ends(other, -h, degree)
        forms.append([*first[: order + 1], *last[order::-1]])
    full = [knots[0], *[t for t in knots for _ in range(degree)], knots[-1]]
    points = [c for i, form in enumerate(forms) for c in form[bool(i) :]]
    return BSpline(degree, full, points)


def ends(jet: Jet, h: mpq, n: int) -> list[mpq]:
    """Return the first three Bézier coefficients in degree n of a function on an interval of length h, with this value
    and these derivatives at the start.
    """
    f, d, dd = jet
    b0 = f
    b1 = b0 + d * h / n
    b2 = 2 * b1 - b0 + dd * h * h / (n * (n - 1))
    return [b0, b1, b2]


def approximation(shape: str, degree: int, quarter: int) -> Nurbs:
    """Return the polynomial spline of ``4 · quarter`` segments."""
    own = stations(quarter)
    knots = [t for t, _, _ in own]
    x = hermite(knots, [(x, -y, -x) for _, x, y in own], degree)
    y = hermite(knots, [(y, x, -y) for _, x, y in own], degree)
    if shape == "circle":
        return Nurbs.from_splines([x, y])
    if shape == "ellipse":
        return Nurbs.from_splines([STRETCH * x, y])
    z = hermite(knots, [(x * y / 2, (x * x - y * y) / 2, -2 * x * y) for _, x, y in own], degree)
    return Nurbs.from_splines([x, y, z])


def exact(shape: str) -> Nurbs:
    """Return the rational curve itself, over four quarters of the circle."""
    circle = xs.example("circle")
    (x, y), w = circle.p, circle.w
    if shape == "circle":
        return circle
    if shape == "ellipse":
        return Nurbs.from_splines([STRETCH * x, y], w)
    return Nurbs.from_splines([x * w, y * w, x * y * mpq(1, 2)], w * w)


def within(curve: Nurbs, shape: str, tolerance: mpq) -> bool:
    """Return whether it is proved that the distance from the circle, and the difference of z and xy/2, are below the
    tolerance.

    Stretching the circle to the ellipse at most doubles distances.
    """
    x = curve.p[0] * mpq(1, STRETCH) if shape == "ellipse" else curve.p[0]
    y = curve.p[1]
    most = tolerance / STRETCH if shape == "ellipse" else tolerance
    square = x * x + y * y
    bounds = [(1 + most) ** 2 - square, square - (1 - most) ** 2]
    if shape == "space":
        bounds += [curve.p[2] - x * y * mpq(1, 2) + most, x * y * mpq(1, 2) - curve.p[2] + most]
    start = curve.domain[0]
    return all(f(start) > 0 and not len(zeros(f)) for f in bounds)


def least(shape: str, degree: int, tolerance: mpq) -> Nurbs:
    """Return the approximation within the tolerance that has the fewest segments (4, 8, 12, …)."""
    low, high = 0, 1
    while not within(approximation(shape, degree, high), shape, tolerance):
        low, high = high, 2 * high
    while high - low > 1:
        middle = (low + high) // 2
        if within(approximation(shape, degree, middle), shape, tolerance):
            high = middle
        else:
            low = middle
    return approximation(shape, degree, high)


def found(shape: str, degree: int, tolerance: mpq | None) -> Found:
    """Return the numbers of features of an approximation, or of the curve itself (degree 0)."""
    curve = least(shape, degree, tolerance) if tolerance is not None else exact(shape)
    own = xs.analyse(curve)
    space = curve.dimension == 3
    return Found(
        shape,
        degree,
        tolerance,
        len(curve.breakpoints) - 1,
        sum(joint.kind in JUMPS for joint in own.joints),
        len(own.curvature_extrema),
        0 if space else len(own.inflections),
        0 if space or own.constant_pieces else len(between_poles(derive("evolute", curve)).reversals),
        len(own.torsion_zeros) if space else None,
        bool(own.constant_pieces),
    )


# ---- the page


def rows() -> list[Found]:
    """Return the rows of the table: each curve itself, followed by its approximations."""
    made = []
    for shape in NAMES:
        made.append(found(shape, 0, None))
        made += [found(shape, degree, tolerance) for degree in DEGREES for tolerance in TOLERANCES]
    return made


def table(made: list[Found]) -> str:
    """Return the rows as Markdown."""
    lines = [f"| {' | '.join(HEADS)} |", "|---|---|" + "---:|" * (len(HEADS) - 2)]
    for row in made:
        tolerance = "itself" if row.tolerance is None else f"10⁻{SUPERSCRIPTS[TOLERANCES.index(row.tolerance)]}"
        degree = DEGREE_NAMES[row.degree]
        extrema = "everywhere" if row.constant else str(row.extrema)
        zeros_of_torsion = "–" if row.torsion_zeros is None else str(row.torsion_zeros)
        flat = row.shape == "space"
        cells = (NAMES[row.shape], f"{degree} {tolerance}".strip(), row.segments, row.jumps, extrema)
        rest = ("–" if flat else row.inflections, "–" if flat else ("a point" if row.constant else row.cusps))
        lines.append(f"| {' | '.join(map(str, (*cells, *rest, zeros_of_torsion)))} |")
    return "\n".join(lines) + "\n"


def draw() -> None:
    """Draw the evolutes of a circle, of an ellipse and of their approximations."""
    import matplotlib as mpl

    mpl.use("Agg")
    import matplotlib.pyplot as plt

    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.6))
    star = least("circle", 5, mpq(1, 10**4))
    for axes, curve, label in (
        (left, star, "quintics, 10⁻⁴"),
        (right, least("ellipse", 3, mpq(1, 10)), "cubics, 10⁻¹"),
        (right, exact("ellipse"), "the ellipse"),
    ):
        axes.plot(*zip(*_evolute_points(curve), strict=True), label=label, linewidth=1.2)
    left.plot([0], [0], "k+", markersize=12, label="the circle")
    left.set_title("Evolute of a circle")
    right.set_title("Evolute of an ellipse")
    for axes in (left, right):
        axes.legend(loc="upper right", fontsize=11)
        axes.set_aspect("equal", adjustable="datalim")
        axes.tick_params(labelsize=10)
    left.ticklabel_format(style="sci", scilimits=(0, 0))
    figure.tight_layout()
    figure.savefig(PICTURE, dpi=110)


def _evolute_points(curve: Nurbs) -> list[tuple[float, float]]:
    found = []
    for piece in between_poles(derive("evolute", curve)).pieces:
        for a, b in itertools.pairwise(piece.breakpoints):
            found += [tuple(map(float, piece(a + (b - a) * mpq(k, 60)))) for k in range(60)]
    return [(x, y) for x, y in found]


def main() -> None:
    """Write the table into the page, and the picture."""
    text = PAGE.read_text(encoding="utf-8")
    head, tail = text.split(BEGIN)[0], text.split(END)[1]
    PAGE.write_text(f"{head}{BEGIN}{table(rows())}{END}{tail}", encoding="utf-8")
    draw()


if __name__ == "__main__":
    main()
