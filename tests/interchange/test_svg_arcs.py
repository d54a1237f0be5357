"""Arcs of SVG whose centres are irrational: the rest of a path is read, and on request a near arc stands for them."""

from fractions import Fraction
from itertools import pairwise, product
from math import atan2, cos, hypot, pi, sin, sqrt

import pytest

from exactspline import read
from exactspline.errors import NumberError
from tests.support.command import run
from tests.support.sampled import sample

SVG = '<svg xmlns="http://www.w3.org/2000/svg">{}</svg>'


def drawn(text, **options):
    return read(SVG.format(text).encode(), "svg", **options)


def test_the_other_segments_of_a_path_survive():
    """The whole subpath was left out."""
    reading = drawn('<path id="p" d="M0 0H1A1 1 0 0 1 2 1.5C3 3 1 3 0 0z"/>')
    assert [(named.name, named.curve.degree, named.curve.segments) for named in reading.curves] == [
        ("p.1", 1, 1), ("p.3", 3, 1)
    ]  # fmt: skip
    assert [named.curve(named.curve.domain[0]) for named in reading.curves] == [(0, 0), (2, 1.5)]
    assert all("an arc next to it is left out" in named.notes[0] for named in reading.curves)
    [skipped] = reading.skipped
    assert "its centre is irrational" in skipped.why
    assert not reading.complete


@pytest.mark.parametrize("large", [0, 1])
@pytest.mark.parametrize("sweep", [0, 1])
@pytest.mark.parametrize(("rx", "ry"), [(1, 1), (3, 2), (1, 7)])
@pytest.mark.parametrize("error", ["1/10", "1e-9"])
def test_a_near_arc_is_near(large, sweep, rx, ry, error):
    """Points of either arc, computed here in floats by the formulas of the standard, are that near to the other."""
    reading = drawn(f'<path d="M0 0A{rx} {ry} 0 {large} {sweep} 1 .5"/>', approximate=error)
    [named] = reading.curves
    curve = named.curve
    a, b = curve.domain
    assert (curve(a), curve(b), reading.skipped) == ((0, 0), (1, 0.5), ())
    assert f"within a distance of {'1/1000000000' if error == '1e-9' else error}" in named.notes[0]
    x, y = 1 / rx, 0.5 / ry
    square = x * x + y * y
    offset = sqrt(1 / square - 1 / 4) * (1 if large == sweep else -1)
    cx, cy = x / 2 + offset * y, y / 2 - offset * x
    start, end = atan2(-cy, -cx), atan2(y - cy, x - cx)
    turn = (end - start) % (2 * pi) if sweep else -((start - end) % (2 * pi))
    assert (abs(turn) > pi) == large
    exact = [(rx * (cx + cos(start + turn * k / 400)), ry * (cy + sin(start + turn * k / 400))) for k in range(401)]
    own = [tuple(map(float, curve(a + (b - a) * k / 100))) for k in range(101)]
    step = max(hypot(p[0] - q[0], p[1] - q[1]) for p, q in pairwise(exact))
    allowed = 0.1 if error == "1/10" else 1e-9
    for point in own:
        # to the chords of the exact arc, which are nearer than step² from it
        assert min(_distance(point, p, q) for p, q in pairwise(exact)) <= allowed + step * step
    for p in exact[::20]:
        assert min(_distance(p, s, t) for s, t in pairwise(own)) <= allowed + 16 * step * step
    near = max(abs(hypot(px / rx - cx, py / ry - cy) - 1) for px, py in own)
    assert near <= 2 * allowed + 1e-12


def _distance(point, p, q):
    dx, dy = q[0] - p[0], q[1] - p[1]
    t = ((point[0] - p[0]) * dx + (point[1] - p[1]) * dy) / ((dx * dx + dy * dy) or 1)
    t = min(max(t, 0), 1)
    return hypot(p[0] + t * dx - point[0], p[1] + t * dy - point[1])


def test_the_distance_is_that_on_the_page():
    """Under a transform that enlarges a thousand times, the arc itself must be nearer."""
    path = '<path transform="scale(1000)" d="M0 0A1 1 0 0 1 1 .5"/>'
    curve = drawn(path, approximate="1/10").curves[0].curve
    offset = sqrt(1 / 1.25 - 1 / 4)
    cx, cy = 1000 * (0.5 - offset * 0.5), 1000 * (0.25 + offset)
    a, b = curve.domain
    points = [tuple(map(float, curve(a + (b - a) * k / 50))) for k in range(51)]
    assert max(abs(hypot(x - cx, y - cy) - 1000) for x, y in points) <= 0.1


def test_a_distance_is_positive():
    with pytest.raises(NumberError, match="above 0"):
        drawn("", approximate=0)


def test_conversion_names_what_it_approximates(tmp_path):
    place = tmp_path / "arc.svg"
    place.write_text(SVG.format('<path d="M0 0A1 1 0 0 1 1 .5"/>'), encoding="utf-8")
    done = run("convert", place, tmp_path / "arc.json", "--approximate", "1e-6")
    assert done.returncode == 0, done.stderr
    assert "within a distance of 1/1000000" in done.stderr
    assert run("convert", place, tmp_path / "other.json").returncode == 2


def test_every_command_that_reads_drawings_approximates(tmp_path):
    """Only `convert` and the library did."""
    place = tmp_path / "arc.svg"
    place.write_text(SVG.format('<path id="p" d="M0 0A1 1 0 0 1 1 .5"/>'), encoding="utf-8")
    for command in (("inspect", place), ("inspect", place, "--ask", "value@0"), ("sweep", place)):
        assert run(*command).returncode == 2
        done = run(*command, "--approximate", "1e-6")
        assert done.returncode == 0, done.stderr
        assert "within a distance of 1/1000000" in done.stderr + done.stdout
        assert run(*command, "--approximate", "0").returncode == 2


def by_the_standard(end, radii, degrees, large, sweep):
    """401 points of an arc from the origin, in floats, by the formulas of the standard (SVG 2, appendix B.2)."""
    (x, y), (rx, ry), turn = end, radii, degrees * pi / 180
    u, v = -(cos(turn) * x + sin(turn) * y) / 2, -(cos(turn) * y - sin(turn) * x) / 2
    grown = max(1.0, hypot(u / rx, v / ry))
    rx, ry = rx * grown, ry * grown
    square = max(0.0, (rx * rx * ry * ry - rx * rx * v * v - ry * ry * u * u) / (rx * rx * v * v + ry * ry * u * u))
    root = sqrt(square) * (1 if large != sweep else -1)
    cx, cy = root * rx * v / ry, -root * ry * u / rx
    first, last = atan2((v - cy) / ry, (u - cx) / rx), atan2((-v - cy) / ry, (-u - cx) / rx)
    angle = (last - first) % (2 * pi) if sweep else -((first - last) % (2 * pi))
    points = []
    for k in range(401):
        a, b = rx * cos(first + angle * k / 400) + cx, ry * sin(first + angle * k / 400) + cy
        points.append((cos(turn) * a - sin(turn) * b + x / 2, sin(turn) * a + cos(turn) * b + y / 2))
    return points


TURNED = product(
    [30, 45, -17.5, 123.25, 359, 1e-3], (0, 1), (0, 1), [(3, 2), (1, 7), (0.25, 0.125), (40, 1)], ["1/10", "1e-7"]
)


@pytest.mark.parametrize(("degrees", "large", "sweep", "radii", "error"), sample(list(TURNED), 64))
def test_the_arc_of_a_turned_ellipse_is_near(degrees, large, sweep, radii, error):
    """It was left out whatever was allowed. Radii that are too small are scaled up: half of an ellipse."""
    rx, ry = radii
    reading = drawn(f'<path d="M0 0A{rx} {ry} {degrees} {large} {sweep} 1 .5"/>', approximate=error)
    assert not reading.skipped
    curve = reading.curves[0].curve
    a, b = curve.domain
    assert (curve(a), curve(b)) == ((0, 0), (1, 0.5))
    exact = by_the_standard((1, 0.5), radii, degrees, large, sweep)
    assert hypot(exact[0][0], exact[0][1]) < 1e-6
    own = [tuple(map(float, curve(a + (b - a) * k / 60))) for k in range(61)]
    # a chord is at most an eighth of the square of its length in units of the radii away from its arc
    slack = max(rx, ry) * 2e-4 * max(1, 2 / min(rx, ry)) ** 2 + float(Fraction(error))
    for point in own:
        assert min(_distance(point, p, q) for p, q in pairwise(exact)) <= slack
    for p in exact[::20]:
        assert min(_distance(p, s, t) for s, t in pairwise(own)) <= 64 * slack


@pytest.mark.parametrize("degrees", [30, -17.5, 89.999])
@pytest.mark.parametrize("error", ["1/10", "1e-7"])
def test_the_points_of_a_turned_arc_are_near_its_ellipse(degrees, error):
    """To nearly full precision: where the centre is known, the form of the ellipse is 1 within the error allowed."""
    reading = drawn(f'<path d="M0 0A3 2 {degrees} 1 1 1 .5"/>', approximate=error)
    turn, curve = degrees * pi / 180, reading.curves[0].curve
    u, v = cos(turn) + sin(turn) / 2, cos(turn) / 2 - sin(turn)
    square = (u / 3) ** 2 + (v / 2) ** 2
    offset = sqrt(1 / square - 1 / 4)
    cx, cy = u / 6 - offset * v / 2, v / 4 + offset * u / 3
    candidates = [(cx, cy), (u / 6 + offset * v / 2, v / 4 - offset * u / 3)]
    a, b = curve.domain
    points = [tuple(map(float, curve(a + (b - a) * k / 50))) for k in range(51)]

    def worst(centre):
        turned = [(cos(turn) * x + sin(turn) * y, cos(turn) * y - sin(turn) * x) for x, y in points]
        return max(abs(hypot(x / 3 - centre[0], y / 2 - centre[1]) - 1) for x, y in turned)

    assert min(map(worst, candidates)) <= float(Fraction(error)) / 2 + 1e-12
