"""The oracle: every question against something that does not share its arithmetic."""

import json
import random
import time
from contextlib import suppress
from pathlib import Path

import mpmath
import pytest
from flint import arb, ctx
from gmpy2 import mpq

import exactspline as xs
from exactspline import ExactSplineError, Family, check_certificate
from exactspline.batch.inspections import entry_of
from exactspline.errors import OpenError
from exactspline.geometry.analysis.ask import REGISTRY, asked_of, check_question, questions
from exactspline.geometry.analysis.pairs import CurvePair
from exactspline.questions import takes
from exactspline.questions.entry import ALL_CURVES, Answered, Of
from exactspline.reals.ball import InBalls
from tests.support.command import invoke
from tests.support.sampled import FULL
from tests.support.vectors import mpf_of
from workshop.vectors.items import items

#: What the answers of questions that are asked below consist of.
VALUES = (Answered.NUMBERS, Answered.SPLINES, Answered.VALUE)
SQUARE = xs.Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (2, 0), (2, 1), (0, 1), (0, 0)], name="box")
CURVES = ["cubic_s", "circle", "twisted_cubic", "cusp", "six_segment_cubic", "rational_space_cubic"]


def value(curve, asked, name):
    return items(curve, asked)[0].values[name]


@pytest.mark.parametrize("name", CURVES)
def test_values_frames_and_curvature_belong_together(name):
    """In 60 digits: T is γ′ by its length, the frame is orthonormal, κ is as the frame turns."""
    curve = xs.example(name)
    t = curve.domain[0] + (curve.domain[1] - curve.domain[0]) / 3
    frame = {k: _mpf(v) for k, v in items(curve, f"frame@{t}")[0].values.items()}
    axes = "xy" if curve.dimension == 2 else "xyz"
    vectors = {n: [frame[n + a] for a in axes] for n in ("TN" if curve.dimension == 2 else "TNB")}
    first, second = ([_mpf(items(curve, f"derivative:{k}@{t}")[0].values[a]) for a in axes] for k in (1, 2))
    kappa = _mpf(value(curve, f"curvature@{t}", "curvature"))
    with mpmath.workdps(60):
        speed = mpmath.sqrt(sum(x * x for x in first))
        assert all(abs(x - y * speed) < 1e-40 for x, y in zip(first, vectors["T"], strict=True))
        for a, u in vectors.items():
            for b, v in vectors.items():
                assert abs(sum(x * y for x, y in zip(u, v, strict=True)) - (a == b)) < 1e-40
        assert abs(sum(x * y for x, y in zip(second, vectors["N"], strict=True)) - kappa * speed**2) < 1e-40


def _mpf(x):
    with mpmath.workdps(60):
        low, high = x.enclosure(55)
        return mpf_of((low + high) / 2)


@pytest.mark.parametrize("asked", ["insert:2@1/3", "elevate:2", "elevate", "insert@1/3"])
@pytest.mark.parametrize("name", CURVES)
def test_other_control_points_are_the_same_curve(name, asked):
    curve = xs.example(name)
    assert _rebuilt(items(curve, asked)) == curve


def _rebuilt(found):
    head, *points = found
    rows = [
        [v.exact for k, v in p.values.items() if k != "weight"]
        if p.what == "control point"
        else xs.Direction(*[v.exact for k, v in p.values.items() if k != "weight"])
        for p in points
    ]
    weights = [p.values["weight"].exact for p in points]
    return xs.Nurbs(head.facts["degree"], head.facts["knots"], rows, weights)


def test_a_knot_goes_in_and_out():
    curve = xs.example("six_segment_cubic")
    t = curve.domain[0] + (curve.domain[1] - curve.domain[0]) / 7
    finer = _rebuilt(items(curve, f"insert@{t}"))
    assert len(finer.control_points) == len(curve.control_points) + 1
    assert _rebuilt(items(finer, f"remove@{t}")).control_points == curve.control_points
    with pytest.raises(ExactSplineError, match="jumps"):
        xs.ask(SQUARE, "remove@1")


def test_split_parts_are_the_parts():
    curve = xs.example("circle")
    found = items(curve, "split@1/3")
    middle = next(i for i, item in enumerate(found) if item.facts.get("part") == "behind")
    assert _rebuilt(found[:middle]) == curve.restrict(0, "1/3")
    assert _rebuilt(found[middle:]) == curve.restrict("1/3", 4)


def test_products():
    curve = xs.example("circle")
    head, *points = items(curve, "product:01")
    knots = head.facts["knots"]
    top, bottom = (
        xs.BSpline(head.facts["degree"], knots, [p.values[n].exact for p in points]) for n in ("w*product", "w")
    )
    x, y = curve("1/3")
    assert top("1/3") / bottom("1/3") == x * y
    head, *points = items(xs.example("cubic_s"), "product:11")
    square = xs.BSpline(head.facts["degree"], head.facts["knots"], [p.values["product"].exact for p in points])
    assert square("1/3") == xs.example("cubic_s")("1/3")[1] ** 2
    for asked in ("product", "product:02", "product:é1"):
        with pytest.raises(takes.QuestionError):
            xs.ask(xs.example("cubic_s"), asked)


def test_the_evolute_is_where_the_normals_meet():
    curve = xs.example("ellipse")
    head, *points = items(curve, "evolute")
    knots, degree = head.facts["knots"], head.facts["degree"]
    x, y, w = (xs.BSpline(degree, knots, [p.values[n].exact for p in points if p.what == "control point"])
               for n in ("w*x", "w*y", "w"))  # fmt: skip
    t = mpq(1, 3)
    towards = [a - b for a, b in zip((x(t) / w(t), y(t) / w(t)), curve(t), strict=True)]
    assert sum(a * b for a, b in zip(towards, curve.derivative(1, t), strict=True)) == 0
    assert sum(a * a for a in towards) * xs.curvature(curve, t) ** 2 == 1
    missing = [item for item in items(xs.example("straight_between_arcs"), "evolute") if item.what == "missing"]
    assert "straight" in missing[0].facts["reason"]


@pytest.mark.parametrize("name", CURVES)
def test_the_box_holds_the_curve_and_is_touched(name):
    curve = xs.example(name)
    a, b = curve.domain
    samples = [curve(a + (b - a) * mpq(k, 400)) for k in range(401)]
    for i in range(curve.dimension):
        low, high = xs.ask(curve, "bounding_box")[i].values.values()
        least, most = min(p[i] for p in samples), max(p[i] for p in samples)
        assert low <= least
        assert most <= high
        size = max(most - least, mpq(1, 10))
        assert least - size / 100 <= low
        assert high <= most + size / 100
        assert low.double("down") <= low.double("up") <= float(least)


def test_the_box_of_two_equal_irrational_extrema():
    """Two maxima of one irrational height: which is higher needs no answer."""
    t = xs.BSpline.identity(-2, 2)
    height = 4 * t * t - t * t * t * t + t.constant(0)
    bent = xs.Nurbs.from_splines([t, height - (t * t).scaled("1/3")])
    [low, high] = xs.ask(bent, "bounding_box")[1].values.values()
    # s = t² has its maximum 11/6, at t = ±√(11/6): the height is rational there, at an irrational parameter
    assert high.double() == 121 / 36
    assert high == mpq(121, 36)
    assert high.closed_form == "121/36"
    assert low.exact == mpq(-4, 3)


def test_area_and_moments():
    assert value(SQUARE, "area", "area").exact == 2
    found = {(m.facts["x"], m.facts["y"]): m.values["moment"].exact for m in items(SQUARE, "moments:2")}
    assert found == {(0, 0): 2, (1, 0): 2, (0, 1): 1, (2, 0): mpq(8, 3), (1, 1): 1, (0, 2): mpq(2, 3)}
    assert value(SQUARE.reverse(), "area", "area").exact == -2
    moved = SQUARE.transform([["3/5", "-4/5", 7], ["4/5", "3/5", 1]])
    assert value(moved, "area", "area").exact == 2
    assert [x.exact for x in items(moved, "centroid")[0].values.values()] == [mpq(36, 5), mpq(21, 10)]
    centre = [items(moved, "moments:1")[k].values["moment"].exact / 2 for k in (1, 2)]
    assert tuple(centre) == (mpq(3, 5) - mpq(2, 5) + 7, mpq(4, 5) + mpq(3, 10) + 1)
    for curve in (xs.example("cubic_s"), xs.example("twisted_cubic")):
        with pytest.raises(ExactSplineError, match=r"closed|of a space curve"):
            xs.ask(curve, "area")


@pytest.mark.parametrize("name", ["cubic_s", "twisted_cubic", "cusp", "six_segment_cubic", "ellipse_skew"])
def test_lengths_against_mpmath(name):
    curve = xs.example(name)

    def speed(i):
        def at(u):
            a, b = curve.breakpoints[i : i + 2]
            t = a + (b - a) * mpq(*map(int, mpmath.libmp.to_rational(mpmath.mpf(u)._mpf_)))
            return mpmath.sqrt(sum(mpmath.mpf(int(x.numerator)) ** 2 / int(x.denominator) ** 2
                                   for x in curve.derivative(1, t))) * float(b - a)  # fmt: skip

        return at

    with mpmath.workdps(20):
        stops = [0, mpmath.mpf(1) / 2, 1] if name == "cusp" else [0, 1]
        total = sum(mpmath.quad(speed(i), stops) for i in range(curve.segments))
    assert abs(xs.ask(curve, "length").double() / float(total) - 1) < 1e-13
    low, high = xs.ask(curve, "length").enclosure(40)
    assert 0 < high - low <= mpq(1, 10**40)


def test_exact_lengths():
    for p, q in ((3, 4), (1, 1), (5, 12), (2, 1)):
        line = xs.Nurbs(1, [0, 0, 1, 1], [(0, 0), (p, q)])
        assert xs.ask(line, "length") * xs.ask(line, "length") == p * p + q * q
    # a Pythagorean hodograph: γ′ = (u² − v², 2uv), u = 1 + t, v = 1
    t = xs.BSpline.identity(0, 1)
    u = t + 1
    x = _antiderivative((u * u - 1).control_points)
    y = _antiderivative((2 * u).elevate_degree().control_points)
    assert xs.ask(xs.Nurbs.from_splines([x, y]), "length").exact == mpq(7, 3) + 1
    assert xs.ask(SQUARE, "length").exact == 6
    # a speed that changes its sign is not integrated as it stands
    back = xs.Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), (1, 0), (0, 0)])
    assert xs.ask(back, "length").to_dict(30).items() >= {"exact": None, "open": True, "double": 1.0}.items()
    assert xs.ask(back, "length").double() == 1.0


def _antiderivative(points):
    sums, total = [mpq(0)], mpq(0)
    for p in points:
        total += p / len(points)
        sums.append(total)
    return xs.BSpline.bezier(sums)


def test_a_ball_that_leaves_the_answer_open_says_so():
    number = InBalls(lambda bits: arb(2).sqrt() ** 2 / 2 + arb("1"))
    for question in (lambda: number.closed_form, lambda: number > mpq(2)):
        with pytest.raises(OpenError):
            question()
    assert number.to_dict(30).items() >= {"exact": None, "open": True, "double": 2.0}.items()
    before = ctx.prec
    xs.ask(xs.example("circle"), "length").double()
    assert ctx.prec == before


@pytest.mark.parametrize(
    ("first", "second", "degree"),
    [
        ((1, 0), (0, 1), 90),
        ((1, 0), (-1, 0), 180),
        ((1, 0), (0, -1), -90),
        ((1, -1, 0), (0, 1, -1), 120),
        ((1, 1, 0), (1, 0, 1), 60),
        ((1, 0, 0), (1, 1, 1), None),
    ],
)
def test_degrees_of_30_45_and_no_others(first, second, degree):
    """Of the angle between two straight segments: rational, or not an algebraic number."""
    points = [[0] * len(first), first, [x + y for x, y in zip(first, second, strict=True)]]
    corners = {c.values["parameter"].exact: c for c in items(xs.Nurbs(1, [0, 0, 1, 2, 2], points), "corners")}
    told = corners[1].values["degrees"]
    assert (told.closed_form, told.closed_form and told.exact) == (degree and str(degree), degree)


def test_joints_and_corners():
    found = items(SQUARE, "corners")
    assert [(c.values["parameter"].exact, c.values["degrees"].exact) for c in found] == [(k, 90) for k in range(4)]
    assert {c.facts["geometric_continuity"] for c in found} == {0}
    assert [i.facts["geometric_continuity"] for i in items(xs.example("straight_between_arcs"), "joints")] == [1, 1]


def test_zero_sets_carry_certificates_that_the_checker_accepts():
    for name, asked in (("cubic_s", "inflections"), ("ellipse", "curvature_extrema"), ("cusp", "cusps"),
                        ("cusp", "singular_points"),
                        ("circle", "turning_points:1"), ("circle", "bounding_box"),
                        ("twisted_cubic", "torsion_zeros")):  # fmt: skip
        certificates = [proof.certificate() for proof in asked_of(xs.example(name), asked).proofs]
        assert certificates
        for certificate in certificates:
            proved = check_certificate(json.loads(json.dumps(certificate)))
            assert proved["roots"] >= (len(items(xs.example(name), asked)) if asked in ("inflections", "cusps") else 0)
    assert [i.what for i in items(xs.example("cusp"), "cusps")] == ["cusp"]


def test_a_question_at_features():
    points = items(xs.example("six_segment_cubic"), "value@inflections")
    assert len(points) == 2
    assert [i.values["curvature"].exact for i in items(xs.example("cubic_s"), "curvature@inflections")] == [0]
    assert len(items(xs.example("six_segment_cubic"), "value@knots")) == 7


def test_bounds_of_a_parabola():
    """y = x² for x from −2 to 2 at the speed 4√(1 + 4x²): dκ/ds is −24x/(1 + 4x²)³."""
    parabola = xs.Nurbs(2, [0, 0, 0, 1, 1, 1], [(-2, 4), (0, -4), (2, 4)])
    assert value(parabola, "largest_speed", "speed") == 4 * xs.square_root(17)
    assert [i.values["curvature"].exact for i in items(parabola, "largest_curvature")] == [2]
    steepest = [i.values["curvature derivative"] for i in items(parabola, "largest_curvature_derivative")]
    assert steepest == [24 * xs.square_root("1/20") / mpq(6, 5) ** 3] * 2
    assert value(parabola, "curvature_derivative@1/4", "curvature derivative") == mpq(24, 125)
    assert [i.what for i in items(parabola, "curvature_at_most:1")] == ["curvature bound", "above"]
    assert value(xs.example("twisted_cubic"), "largest_torsion", "torsion") == 3


@pytest.mark.parametrize("asked", [
    "", "nothing", "value", "value@", "value@x", "derivative:-1@0", "derivative:x@0", "insert@0,1",
    "turning_points:2", "torsion@0", "moments:99", "value@1/0", "elevate:99999", "split@7",
])  # fmt: skip
def test_what_cannot_be_answered_is_said(asked):
    with pytest.raises(ExactSplineError):
        xs.ask(xs.example("cubic_s"), asked)


def test_random_enclosures_hold_their_doubles():
    chance = random.Random(11)
    for _ in range(20):
        points = [(chance.randint(-9, 9), chance.randint(-9, 9)) for _ in range(4)]
        curve = xs.Nurbs(3, [0] * 4 + [1] * 4, points)
        for asked in ("inflections", "turning_points:0", "bounding_box", "at_coordinate:0,1/2", "length_between@0,1/3",
                      "at_length:1/3", "equally_spaced:2"):  # fmt: skip
            found = [*numbers(xs.tables.to_dict(curve, asked, 30))]
            assert found or asked != "bounding_box"
            for number in found:
                low, high = mpq(number["low"]), mpq(number["high"])
                near = xs.from_floats(number["double"])
                assert low <= high
                assert abs(near - low) <= abs(near) / 2**52 + mpq(1, 10**29)
                if number["exact"] and "√" not in number["exact"]:
                    assert low == high == mpq(number["exact"])


def numbers(data):
    """All real numbers in the data of an answer."""
    if isinstance(data, dict) and "double" in data:
        yield data
    elif isinstance(data, (dict, list)):
        for each in data.values() if isinstance(data, dict) else data:
            yield from numbers(each)


def test_every_question_is_asked_here():
    asked = Path(__file__).read_text(encoding="utf-8")
    taken = {name: entry for of in ALL_CURVES for name, entry in REGISTRY[of].items() if entry.about.answered in VALUES}
    assert len(taken) > 14
    assert all(name in asked for name in taken)
    assert type(items(SQUARE, "length")[0]).__name__ == "NamedNumbers"
    assert items(SQUARE, "offset_parts:1/10")


@pytest.mark.parametrize(("asked", "told"), [("derivative:1000000@1", "up to 999"), ("value@", "like 'value@1/2'")])
def test_what_is_wrong_with_a_question_is_named(asked, told):
    with pytest.raises(takes.QuestionError, match=told):
        xs.ask(xs.example("ellipse"), asked)


@pytest.mark.parametrize("asked", questions(), ids=lambda x: x.form)
def test_what_a_question_does_not_take_is_refused(asked):
    """Before, `length@1/2` answered the length of the whole curve, and so did every question that takes no place, or no
    argument; `distance:circle:7` left out the part that a curve file does not have.
    """
    name, place = asked.name, "@1/2,1/3" if "@" in asked.form else ""
    wrong = [f"{name}:{place}", f"{name}@", f"{name}:2" if place else f"{name}@1/2"]
    for each in wrong if ":" in asked.form else [*wrong, f"{name}:3{place}"]:
        with pytest.raises(takes.QuestionError, match="write it like"):
            check_question(each, *asked.of)
    for each in ("nearest:1,2@1/2", "distance:circle:7"):
        with pytest.raises(ExactSplineError, match=r"2@1/2|no part '7'"):
            xs.ask(xs.example("ellipse"), each)


def about_curves(asked):
    check_question(asked, *ALL_CURVES)


def about_surfaces(asked):
    check_question(asked, Of.SURFACE)


def test_the_form_is_the_same_for_sweeps_and_surfaces():
    """Before, a sweep said `there is no question called 'corners@1/2'`, a surface nothing of `umbilics@`."""
    for ask, asked in ((about_curves, "area:7"), (entry_of, "corners@1/2"), (about_surfaces, "umbilics@")):
        with pytest.raises(takes.QuestionError, match=f"^the question '{asked}'; write it like '[a-z]*'"):
            ask(asked)


def test_a_file_of_which_a_curve_could_not_be_read_ends_with_2(tmp_path):
    """False before: exit status 0, as if the answers were those of the whole file; notes were not shown."""
    place = tmp_path / "a.svg"
    place.write_text('<svg><path d="M0 0L3 4" clip-path="url(#c)"/><path d="M0 0A3 2 30 0 1 1 1"/></svg>')
    done = invoke("inspect", str(place), "--ask", "length")
    assert done.exit_code == 2
    assert "clip-path" in done.stderr
    assert "5.0" in done.output


@pytest.mark.parametrize(
    ("question", "curve"), [("length", "degree=40 count=1"), ("elevate:900", "degree=3 segments=30 count=1")]
)
def test_the_work_on_an_answer_has_a_bound(question, curve):
    """False before: nothing; the arc length of a thousand segments took minutes, one of degree 90 half a minute."""
    start = time.process_time()
    with suppress(ExactSplineError):
        xs.tables.to_dict(Family.parsed(curve).curve(0), question)
    assert time.process_time() - start < 60


@pytest.mark.parametrize(
    ("points", "far"),
    [
        ("0,0 1e{},1 0,1 1e-{},1", 100),
        ("0,0 1,1 0,1 1,1e-{}", 300),
        ("0,0 1e{},0 1e-{},1 1,1", 60),
        *[("0,0 1e{},1 0,1 1e-{},1", 300)] * FULL,
    ],
)
def test_a_length_ends_whatever_the_size_of_the_numbers(points, far):
    """Passed before: with numbers of 1e-100 beside 1 the roots of the speed were isolated in one call for minutes."""
    net = [point.split(",") for point in points.format(far, far).split()]
    curve, start = xs.Nurbs(3, [0, 0, 0, 0, 1, 1, 1, 1], net), time.process_time()
    with suppress(OpenError):
        assert xs.ask(curve, "length").double() > 0
    assert time.process_time() - start < 60


@pytest.mark.parametrize("far", [20, 60, 100, 200, 300])
def test_the_length_of_a_curve_with_nearly_a_cusp(far):
    """Passed before: a refusal, or minutes; the limit curves have the lengths 4(√2 − 1) + …, measured by mpmath."""
    near, flat = f"1e-{far}", [0, 0, 0, 0, 0, 1, 1, 1, 1, 1]
    for curve, limit in (
        (xs.Nurbs(3, [0, 0, 0, 0, 1, 1, 1, 1], [[0, 0], [1, 1], [near, 1], [1, 0]]), "1.8284271247461900976"),
        (xs.Nurbs(3, [0, 0, 0, 0, 1, 1, 1, 1], [[0, 0], [1, 1], [0, 1], [1, near]]), "1.8284271247461900976"),
        (xs.Nurbs(4, flat, [[0, 0], [1, near], [2, 0], [3, near], [5, 0]]), "5"),
    ):
        assert abs(xs.ask(curve, "length").enclosure(15).middle - mpq(limit)) < mpq(1, 10**14)
        part = curve.restrict("1/8", "1/4")
        assert 0 < xs.ask(part, "length") < xs.ask(curve, "length")


def test_too_much_work_is_said():
    many = Family.parsed("degree=3 segments=500 count=1").curve(0)
    with pytest.raises(ExactSplineError, match="too much work"):
        xs.tables.to_dict(many, "length", 300)


def test_self_intersections_are_pairs_of_parameters_and_what_is_not_decided_is_an_error():
    loop = xs.Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (3, 3), (-2, 3), (1, 0)])
    (item,) = items(loop, "self_intersections")
    assert item.values["parameter"] + item.values["other parameter"] == 1
    assert item.values["x"] == mpq(1, 2)
    fold = xs.Nurbs(4, [0] * 5 + [1] * 5, [(0, 0), (1, 0), (1, 2), (1, 0), (0, 0)])
    (item,) = items(fold, "self_intersections")
    assert item.facts == {"reversed": True}
    # (x, x²) for x = t (t − 1/2) (t − 1): three times over one arc
    x = xs.BSpline.identity(0, 1)
    x = x * (x - mpq(1, 2)) * (x - 1)
    thrice = xs.Nurbs.from_splines([x, x * x])
    with pytest.raises(takes.QuestionError, match="not decided"):
        items(thrice, "self_intersections")


def test_two_curves_a_curve_and_a_point():
    """Entries about two curves are asked with the name or the file of the other one.

    Of an open curve whose end is the nearest point the oracle said that "the root is outside the domain".
    """
    line = xs.Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 0)])
    assert [value(line, f"nearest:{x},0", "parameter") for x in (-2, 3)] == [0, 1]
    circle = xs.example("circle")
    assert [item.what for item in items(circle, "intersections:ellipse")] == ["touching", "touching"]
    assert value(circle, "distance:ellipse", "distance") == 0
    (near,) = items(xs.example("ellipse"), "intersections_within:cubic_s,1/1000")
    assert near.facts == {"robust": True}
    (near,) = items(circle, "nearest:0,3")
    assert (near.values["parameter"], near.values["distance"], near.values["y"]) == (1, 2, 1)
    assert [item.what for item in items(circle, "nearest:0,0")] == ["everywhere"]
    assert value(circle.reverse(), "winding_number:1/2,1/3", "value") == -1
    for asked in (
        "intersections",
        "intersections:nothing",
        "intersections_within:ellipse",
        "nearest:1",
        "winding_number:1,0",
        "nearest:x,y",
    ):
        with pytest.raises(ExactSplineError):
            xs.ask(circle, asked)


def test_arcs_at_the_least_distance_are_told_in_every_form():
    """Passed before: of parallel segments, with doubles of 17 digits, two pairs alone, as if no other points were as
    near; `between` had the arc.
    """
    a, b = (xs.Nurbs.from_floats(1, [0, 0, 1, 1], [(x, y), (x + 4.1, y)]) for x, y in ((0.1, 0.3), (1.7, 1.9)))
    told = items(CurvePair(a, b), "distance")
    assert [item.what for item in told] == ["pair", "pair", "everywhere"]
    (arc,) = xs.distance(a, b).everywhere
    assert (told[2].values["start"], told[2].values["other end"]) == (arc.first[0], arc.second[1])
    assert [item.what for item in items(CurvePair(a, a), "intersections")][-1] == "everywhere"
