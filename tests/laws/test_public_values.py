"""Everything that the front door returns survives pickle, copies and a process pool, and stays equal."""

import copy
import pickle
import re
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import suppress
from functools import cache
from multiprocessing import get_context
from types import ModuleType

import pytest
from gmpy2 import mpq

import exactspline as xs
from exactspline.batch.corpus import Family
from exactspline.display.tables import Grid
from exactspline.geometry.analysis.ask import REGISTRY, facts_about, kind_of
from exactspline.language.arguments import Argument
from exactspline.language.formula import Reading
from exactspline.language.kinds import PLANE
from exactspline.language.vector import Vector
from exactspline.readings.taylor import Series
from exactspline.readings.tree import Node
from tests.support.decided import decided_once

PLANE_CURVE, SPLINE, CUSP = xs.example("ellipse_skew"), xs.example("rational_cubic_spline"), xs.example("cusp")
STRAIGHT = xs.Nurbs(1, [0, 0, 1, 1], [(0, 0), (2, 0)])
SPACE, RATIONAL = xs.example("twisted_cubic"), xs.example("rational_space_cubic")
SURFACE = xs.example("torus")
PATCH = xs.TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[-1, 1], [2, -3]])
LINE = xs.Nurbs(1, [0, 0, 1, 1], [(-4, 0), (4, 0)])
T = xs.BSpline.identity(0, 2)
ROOT = xs.zeros(T * T - 2).roots[0]
POINTS = b"100 1 0 0\n2 0\n2 2\n0 0 1 1\n0 0\n0.1 2\n"


@xs.language.formula("a test", on="plane")
def own_formula(c):
    """[p′ p″]."""
    return xs.language.det(c.p.d(1), c.p.d(2))


#: What each name of the front door is or returns.
RETURNED = {
    "BSpline": lambda: T,
    "DegreeReading": lambda: xs.readings.DegreeReading("d"),
    "Direction": lambda: xs.Direction(0, 1),
    "ExactSplineError": lambda: xs.ExactSplineError("a", where="b", remedy="c", data=1),
    "Family": lambda: xs.Family.parsed(["degree=3", "count=2", "seed=1"]),
    "Grid": lambda: xs.tables.Grid(["a"], [["b"]]),
    "JetReading": lambda: xs.readings.JetReading(2),
    "KnotVector": lambda: xs.KnotVector([0, 0, 1, 1]),
    "Nurbs": lambda: SPLINE,
    "NurbsSurface": lambda: SURFACE,
    "Real": lambda: [
        xs.Real("1/3"),
        xs.evaluate(LINE, xs.zeros(xs.BSpline.identity(0, 1) ** 2 - mpq(1, 2)).roots[0])[0],
    ],
    "Rational": lambda: SPLINE.gamma,
    "Root": lambda: ROOT,
    "Side": lambda: list(xs.Side),
    "TensorSpline": lambda: xs.TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[0, 1], [2, 3]]),
    "Verdict": lambda: list(xs.Verdict),
    "Variant": lambda: list(xs.tables.Variant),
    "Vector": lambda: SPLINE.p,
    "ZeroSet": lambda: xs.zeros(T * T - 2),
    "claims": lambda: [*xs.claims()[:40], *xs.claims(paper="lifted")[:40]],
    "bisector": lambda: [xs.bisector(SPACE, RATIONAL), xs.bisector(SPACE, (0, 1, 2)), xs.bisector(LINE, (0, 2))],
    "pieces of a bisector": lambda: [
        *xs.bisector(SPACE, (0, 1, 2)).pieces,
        xs.bisector(SPACE, (0, 1, 2)).pieces[0].interval,
        *xs.bisector(SPACE, RATIONAL).patches,
    ],
    "stability": lambda: list(xs.analyse(xs.example("cubic_s")).stability),
    "parts of a curve of zeros": lambda: [
        xs.zero_curve(PATCH).curves[0],
        xs.zero_curve(PATCH).curves[0].pieces[0],
        xs.zero_curve(PATCH).curves[0].pieces[0].sides,
    ],
    "complex_product": lambda: xs.language.complex_product(xs.language.Vector(1, 2), xs.language.Vector(3, 4)),
    "construction": lambda: xs.tables.construction("evolute"),
    "curvature": lambda: [xs.curvature(PLANE_CURVE, "1/3"), xs.curvature(PLANE_CURVE, ROOT)],
    "curvature_function": lambda: xs.tables.curvature_function(PLANE_CURVE),
    "de_boor_triangle": lambda: xs.teaching.de_boor_triangle(SPLINE, "1/2"),
    "degree": lambda: xs.degree("g2"),
    "degree_table": lambda: xs.tables.degree_table(LINE),
    "derive": lambda: xs.derive("evolute", PLANE_CURVE),
    "elevation_triangles": lambda: xs.teaching.elevation_triangles(LINE),
    "errata": lambda: errata()[0],
    "exercise": lambda: [
        xs.teaching.exercise("evaluation", 1),
        xs.teaching.exercise("evaluation", 1).answer.check("0, 0"),
    ],
    "factor_of": lambda: xs.tables.factor_of("f1", "f2", 2),
    "analyse": lambda: [
        xs.analyse(SPLINE).inflections,
        xs.analyse(CUSP).singular_points,
        xs.analyse(SPLINE).joints,
        xs.analyse(RATIONAL).torsion_zeros,
        xs.analyse(xs.example("sphere")),
        xs.analyse(xs.example("planar_map")),
    ],
    "formula_of": lambda: xs.formula_of("f2"),
    "formula": lambda: own_formula,
    "insertion_triangle": lambda: xs.teaching.insertion_triangle(SPLINE, "1/3"),
    "jets_for": lambda: xs.tables.jets_for(("f2",), 2),
    "measure": lambda: xs.tables.measure(xs.formula_of("f2"), SPLINE),
    "numerical_claims": lambda: xs.tables.numerical_claims("C4.2"),
    "ask": lambda: [xs.ask(SPLINE, "inflections"), xs.ask(SPLINE, "value@1/3"), xs.ask(SPLINE, "bounding_box")],
    "ask box": lambda: xs.ask(xs.example("circle"), "bounding_box"),
    "paper": lambda: xs.paper("lifted"),
    "parse_degree": lambda: xs.readings.parse_degree("max(9d - 6, 12d)"),
    "product_tables": lambda: xs.teaching.product_tables(T, T),
    "patch_table": lambda: [row() for row in xs.tables.patch_table([xs.paper("surfaces").find("parabolic")], (2, 2))],
    "prove": lambda: xs.prove("f1", "f2", "w"),
    "decide": lambda: xs.decide(xs.claims("C4.1a")[0]),
    "read": lambda: xs.read(POINTS),
    "reduction": lambda: xs.reduction("g0"),
    "ruled": lambda: xs.language.ruled(xs.language.Vector(1, 2, 3), xs.language.Vector(1, 0, 0)),
    "ruled_surface": lambda: xs.tables.ruled_surface("tangent_developable", RATIONAL),
    "series_curve": lambda: xs.readings.series_curve(SPLINE, "1/2", 3),
    "statements": lambda: list(xs.tables.statements("C4.1a")),
    "common_zeros": lambda: xs.common_zeros(PATCH, PATCH.partial(1, 0)),
    "zero_curve": lambda: xs.zero_curve(PATCH),
    "intersections": lambda: xs.intersections(xs.example("circle"), STRAIGHT),
    "self_intersections": lambda: xs.self_intersections(xs.example("cubic_s")),
    "nearest": lambda: xs.nearest(xs.example("circle"), (2, 0)),
    "distance": lambda: xs.distance(xs.example("circle"), STRAIGHT),
    "reading_along": lambda: xs.tables.reading_along("4.3"),
    "surface_pair": lambda: xs.tables.surface_pair(SPACE, RATIONAL),
    "sweep": lambda: list(xs.sweep([PLANE_CURVE])),
    "table_1_degrees": xs.tables.table_1_degrees,
    "table_1_splines": xs.tables.table_1_splines,
    "square_root": lambda: xs.square_root(2) + xs.square_root(3),
    "torsion": lambda: xs.torsion(RATIONAL, "1/3"),
    "trace": lambda: xs.readings.trace(xs.formula_of("f2")),
    "verify": lambda: xs.verify("f1", "f2", SPLINE, "w"),
    "variants_table": lambda: xs.tables.variants_table(xs.paper("lifted")),
    # values of a formula in each reading
    "in jets": lambda: own_formula(xs.readings.JetReading(2).argument(PLANE, 2)),
    "in fractions": lambda: own_formula(xs.tables.jets_for((own_formula,), 2)),
    "in degrees": lambda: own_formula(xs.readings.DegreeReading("d").argument(PLANE, 2)),
}
#: Names that return what one of those above returns, plain data, numbers, text, pictures or nothing.
COVERED = {
    *("evaluate", "read_scipy", "circle", "graph", "interpolate", "latex"),
    *("complex_quotient", "conjugate", "cross", "det", "dot", "generalized_cross", "join", "norm2", "perp", "triple"),
    *("wronskian", "numerator", "control_point_count", "greville_abscissae", "zeros", "rational"),
    *("from_floats", "floats", "features_of_curves", "check_certificate"),
    *("derived_data", "inspection_data", "to_dict", "to_records"),
    *("example", "examples"),
    *("write", "text", "from_geomdl", "from_scipy", "to_geomdl", "to_scipy"),
    *(
        "from_splinepy",
        "to_splinepy",
        "to_sympy",
        "to_mpmath",
        "from_matplotlib",
        "to_matplotlib",
        "Limits",
        "NamedCurve",
    ),
    *("Reading", "Skipped"),
    *("measurable", "mathematics", "measured", "printed_numbers", "reduction_table"),
    *("symbolic_table", "verdicts", "winding_number", "contains", "as_tensor_product", "is_developable"),
}


@cache
def errata():
    """What is in error in print, decided once."""
    with decided_once():
        return xs.tables.errata()


@cache
def returned(name):
    return RETURNED[name]()


def kept(value):
    """What must stay: the value, or where it has no equality of its own what it shows."""
    if isinstance(value, list):
        return [kept(each) for each in value]
    if isinstance(value, BaseException | Node):
        return repr(value)
    if isinstance(value, Argument):
        return {name: kept(x) for name, x in value.operands().items()} if hasattr(value, "operands") else None
    if isinstance(value, Vector):
        return [kept(each) for each in value]
    if isinstance(value, Series):
        return value.coefficients
    if isinstance(value, Reading):
        return {name: x for name, x in vars(value).items() if isinstance(x, (int, str))}
    return value


def same(a, b):
    return type(a) is type(b) and kept(a) == kept(b)


def test_every_public_name_is_looked_at():
    rooms = (xs, xs.teaching, xs.interchange, xs.language, xs.readings, xs.tables)
    names = {name for room in rooms for name in room.__all__ if not name.startswith(("plot", "__"))}
    names -= {name for name in xs.__all__ if isinstance(getattr(xs, name), ModuleType)}
    assert names - RETURNED.keys() - COVERED == set()
    assert names >= COVERED


#: What the field dump of a dataclass looks like, and an object without a text of its own.
DUMP = re.compile(r"\w=| object at 0x|\n|mpq\(")
#: What `str` is by its nature not one line without an equals sign: a table, and what is typed (``degree=3``).
WRITTEN_OTHERWISE = (Grid, Family)
#: Things of a list that are looked at, and how deep they are looked into.
FEW, DEEP = 5, 5
#: What questions of the registry are asked of.
OBJECTS = (
    *("ellipse_skew", "cusp", "circle", "straight_between_arcs", "twisted_cubic", "planar_in_space"),
    *("sphere", "enneper", "hyperbolic_paraboloid", "planar_map"),
    *("circle ellipse_skew", "twisted_cubic rational_space_cubic"),
)


def parts(value, depth=0):
    """A value of the package, what is in it, and what is in a list of them."""
    if isinstance(value, BaseException) or depth > DEEP:
        return
    if type(value) in (list, tuple, set, frozenset, dict):
        inside = [*(value.values() if isinstance(value, dict) else value)][:FEW]
    elif not type(value).__module__.startswith("exactspline"):
        return
    else:
        yield value
        inside = [getattr(value, name) for name in getattr(value, "__dataclass_fields__", ()) if name[0] != "_"]
        inside += list(value)[:FEW] if isinstance(value, Sequence) and not isinstance(value, str) else []
    for each in inside:
        yield from parts(each, depth + 1)


def shown_badly(value):
    """What of a value, and of what is in it, is no line of its own."""
    seen = {type(each): each for each in parts(value)}.values()
    texts = [(type(each), text) for each in seen for text in {repr(each), str(each)}]
    return [x for x in texts if (len(x[1]) > 120 or DUMP.search(x[1])) and not issubclass(x[0], WRITTEN_OTHERWISE)]


@pytest.mark.parametrize("name", RETURNED)
def test_it_prints_itself_in_one_line(name):
    """Passed before: ``Proof(left='f1', …, ring=<… object at 0x…>)``."""
    assert shown_badly(returned(name)) == []


@pytest.mark.parametrize("names", OBJECTS)
def test_every_answer_prints_itself_in_one_line(names):
    """Of 42 types of answers and of what they consist of the fields were printed."""
    objects = tuple(map(xs.example, names.split()))
    facts, asked = facts_about(objects if len(objects) > 1 else objects[0]), 0
    for entry in REGISTRY[kind_of(facts)].values():
        if entry.name in ("umbilics_within", "stability"):  # dear, and of types that the others have
            continue
        with suppress(xs.ExactSplineError):  # such as the area of a curve that is not closed
            assert shown_badly(xs.ask(facts, entry.form)) == []
            asked += 1
    assert asked >= 2
    assert shown_badly(facts) == []


def test_dear_answers_are_lines_too():
    umbilics = xs.analyse(xs.example("monkey_saddle")).umbilics_within("1/10")
    assert shown_badly([xs.analyse(xs.example("cubic_s")).stability, umbilics]) == []


def test_dumps_are_found():
    assert all(DUMP.search(text) for text in ("P(left=mpq(1,2))", "<P object at 0x7f>", "a\nb", "Q(kind=<K.A: 'a'>)"))


HUGE = mpq(10**300 + 1, 3**600)


def long_curve(dimension=2):
    """A curve with a long name, a hundred segments, and numbers of 300 digits."""
    points = [tuple(HUGE * k ** (i + 1) for i in range(dimension)) for k in range(100)]
    return xs.Nurbs(1, [0, *range(99), HUGE, HUGE], points, name="a very long name " * 20)


def test_long_objects_are_shortened():
    curve = long_curve()
    x, point = curve.p[0], xs.ask(curve, "value@1/3")
    values = [curve, curve.p, curve.knots, curve.gamma, x, curve.domain, xs.zeros(x - HUGE), xs.Real(HUGE), point]
    values += [xs.analyse(curve), facts_about((curve, curve)), xs.Direction(HUGE, HUGE, HUGE), xs.analyse(curve).joints]
    values += [xs.analyse(curve).straight_pieces, xs.analyse(curve).shapes[0], xs.nearest(curve, (0, HUGE))]
    assert shown_badly(values) == []
    assert repr(x) == "<BSpline: degree 1, 100 control points on [0, 5.3363852e+13…], 99 segments>"


@pytest.mark.parametrize("digits", [40, 41])
def test_a_number_is_shown_exactly_up_to_forty_characters(digits):
    number = int("12" * digits) // 10**digits
    exact = digits == 40
    assert len(str(number)) == digits
    assert repr(xs.Real(number)) == (f"<Real {number}>" if exact else "<Real 1.2121212e+40…>")
    assert str(xs.Real(number)) == (str(number) if exact else "1.21212121212121e+40…")


def test_float_is_a_number_or_a_parameter():
    circle, s = xs.analyse(xs.example("circle")), xs.analyse(xs.example("cubic_s"))
    assert [float(joint) for joint in circle.joints] == [0, 1, 2, 3]
    assert [float(each) for each in s.inflections] == [0.5]
    assert [float(each) for each in s.stability] == [float(each.place) for each in s.stability]
    assert [float(each) for each in xs.nearest(circle.curve, (0, 2))] == [1]
    assert float(xs.distance(circle.curve, xs.Nurbs(1, [0, 0, 1, 1], [(2, -1), (2, 1)]))) == 1
    assert float(xs.square_root(2)) == float(ROOT) == 2**0.5
    jump = xs.zeros(xs.BSpline(0, [0, "1/3", 1], [-1, 1])).jumps[0]
    assert float(jump) == 1 / 3


def along(names, shape):
    return [tuple(map(int, getattr(shape, name))) for name in names]


@pytest.mark.parametrize("scale", [1, mpq(-4, 3)])
def test_directions_are_coprime_integers(scale):
    """A line through (0, 0) and (2, 4) had the direction (2, 4), its reverse (−2, −4)."""
    tilted = [[scale * x for x in row] for row in ([2, 2, 1], [-2, 1, 2], [1, -2, 2])]  # its last column is (1, 2, 2)
    line = xs.Nurbs(1, [0, 0, 1, 1], [(0, 0), (2 * scale, -4 * scale)])
    circle = xs.Nurbs.from_homogeneous(
        2,
        xs.example("circle").knots,
        [(x * w, y * w, 0, w) for (x, y), w in zip(xs.example("circle").control_points, xs.example("circle").weights)],
    ).transform(tilted)
    parabola = xs.Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), (scale, scale), (2 * scale, 0)])
    flat = xs.Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0, 0), (1, 2, 0), (3, 0, 0)]).transform(tilted)
    assert along(["direction"], xs.analyse(line).shapes[0].shape) == [(1, -2)]
    assert along(["normal"], xs.analyse(circle).shapes[0].shape) == [(1, 2, 2)]
    assert along(["normal"], xs.analyse(flat).planar_pieces[0][1]) == [(1, 2, 2)]
    for name in ("torus", "cone", "cylinder"):
        surface = xs.example(name).transform(tilted)
        assert along(["axis"], xs.analyse(surface).shapes[0].shape) == [(1, 2, 2)], name
    opening = xs.analyse(parabola).shapes[0].shape.numbers["axis"]
    assert opening == (0, -1 if scale > 0 else 1)  # it opens there: the sense means something


def test_errata_and_claims_are_sequences():
    for found in (errata(), xs.claims()):
        assert isinstance(found, Sequence)
        assert found[0] == found[:2][0] == next(iter(found))
        assert found[-1] == found[len(found) - 1]


@pytest.mark.parametrize("name", RETURNED)
def test_it_survives_pickle_and_copies_and_stays_equal(name):
    value = returned(name)
    for other in (pickle.loads(pickle.dumps(value)), copy.deepcopy(value), copy.copy(value)):
        assert same(other, value)
        try:
            own = hash(value)
        except TypeError:
            continue
        if other == value:
            assert hash(other) == own


def there_and_back(value):
    return value


def test_it_comes_back_from_a_process_pool():
    names = [name for name in RETURNED if name != "formula"]  # of this file, which no other process imports
    with ProcessPoolExecutor(1, mp_context=get_context("fork")) as pool:
        for name, other in zip(names, pool.map(there_and_back, map(returned, names)), strict=True):
            assert same(other, returned(name)), name


@pytest.mark.parametrize("name", ["cubic_s", "twisted_cubic"])
def test_an_analysis_is_pickled_with_its_curve(name):
    """Before: "cannot pickle '_thread.RLock' object"."""
    analysis = xs.analyse(xs.example(name))
    again = pickle.loads(pickle.dumps(analysis))
    assert again.curve == analysis.curve
    assert again is xs.analyse(again.curve)
    assert again.inflections == analysis.inflections
    assert copy.copy(analysis) is analysis
