"""Doors that fit: each public function, given any public value, answers or says what it takes instead."""

import contextlib
import inspect
import pickle
from collections.abc import Iterator
from itertools import islice

import numpy
import pytest
from gmpy2 import mpq

import exactspline as xs
from exactspline.certificates import CertificateError
from exactspline.display import plot as plots
from exactspline.errors import ShapeError
from exactspline.extras import pictures3d
from exactspline.geometry.analysis.curves import QUESTIONS
from exactspline.numbers.exact import from_float
from tests.support.command import run
from tests.support.sampled import sample

T = xs.BSpline.identity(0, 2)
ROOT = xs.zeros(T * T - 2)[0]
CUSP = xs.example("cusp")
STILL = xs.Nurbs(1, [0, 0, 1, 1], [(1, 2, 3), (1, 2, 3)])
AT_INFINITY = xs.Nurbs.from_homogeneous(2, [0, 0, 0, 1, 1, 1], [(0, 0, 1), (1, 1, 0), (2, 0, 1)])
DEEP: list[object] = []
for _ in range(100_000):
    DEEP = [DEEP]
#: Every kind of public value, and what is none.
VALUES = {
    "None": None,
    "int": 3,
    "text": "no such thing",
    "float": 0.5,
    "bytes": b"ab",
    "list": [1, 2],
    "nothing": [],
    "points": [(0, 0), (1, 1)],
    "dict": {},
    "mpq": mpq(1, 3),
    "root": ROOT,
    "surd": xs.curvature(xs.example("ellipse_skew"), "1/3"),
    "zero set": xs.zeros(T * T - 2),
    "enclosure": xs.evaluate(xs.Nurbs(1, [0, 0, 2, 2], [(0, 0), (1, 1)]), ROOT)[0],
    "spline": T,
    "vector": xs.language.Vector(T, T * T),
    "vector of numbers": xs.language.Vector(1, 2),
    "quotient": T / (T + 1),
    "vector quotient": CUSP.gamma,
    "plane curve": CUSP,
    "space curve": xs.example("twisted_cubic"),
    "curve in R4": xs.Nurbs(2, [0] * 3 + [1] * 3, [(0, 0, 0, 0), (1, 0, 0, 1), (0, 1, 0, 0)]),
    "one point": STILL,
    "weight 0": AT_INFINITY,
    "knots": xs.KnotVector([0, 0, 1, 1]),
    "surface": xs.example("torus"),
    "tensor spline": xs.TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[0, 1], [2, 3]]),
    "evolute": xs.derive("evolute", CUSP),
    "piece": xs.derive("evolute", CUSP).pieces[0],
    "feature": xs.analyse(CUSP).singular_points[0],
    "formula": xs.formula_of("f2"),
    "class": xs.Nurbs,
    "nan": float("nan"),
    "true": True,
    "object": object(),
    "function": repr,
    "set": {1, 2},
    "negative": -5,
    "too long to print": 10**5000,
    "nested": [[[1]]],
    "nested deeply": DEEP,
    "array": numpy.array([[0.0, 1], [2, 3]]),
    "array of integers": numpy.array([1, 2]),
    "array without dimensions": numpy.array(3.0),
    "claim": xs.claims("C4.1a")[0],
    "paper": xs.paper("lifted"),
    "analysis": xs.analyse(CUSP),
    "analysis of a surface": xs.analyse(xs.example("torus")),
}
#: What stands in the other places while one of them is varied.
OTHERS = ("plane curve", "space curve", "surface", "spline", "int", "text", "formula", "claim", "points")
#: The checker of certificates shares no code with the library, its errors neither.
OWN_ERRORS = {"check_certificate": CertificateError}


def of_geomdl():
    abstract = pytest.importorskip("geomdl.BSpline")
    surface = abstract.Surface()
    surface.degree_u = surface.degree_v = 1
    surface.set_ctrlpts([[0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 1]], 2, 2)
    surface.knotvector_u = surface.knotvector_v = [0, 0, 1, 1]
    return surface


def places(function):
    """How many arguments by position a function takes, at least and at most (three of those that it takes any number
    of).
    """
    parameters = inspect.signature(function).parameters.values()
    named = [p for p in parameters if p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD)]
    least = sum(p.default is p.empty for p in named)
    return least, len(named) + 2 * any(p.kind is p.VAR_POSITIONAL for p in parameters)


def handed(function):
    """Every value in each place, with each of the others in the other places."""
    least, most = places(function)
    for count in range(max(least, 1), most + 1):
        for other in OTHERS if count > 1 else OTHERS[:1]:
            for i in range(count):
                for name, value in VALUES.items():
                    yield name, [value if j == i else VALUES[other] for j in range(count)]


#: Every public function and class by its name; none is public twice.
PUBLIC = {
    name: getattr(room, name)
    for room in (xs, xs.teaching, xs.interchange, xs.language, xs.readings, xs.tables, plots, pictures3d)
    for name in room.__all__
    if callable(getattr(room, name))
}


@pytest.mark.parametrize("name", PUBLIC)
def test_every_public_name(name, tmp_path, monkeypatch):
    """AttributeErrors, TypeErrors, KeyErrors, ValueErrors or RecursionErrors from inside before, of 59 of 130 names."""
    monkeypatch.chdir(tmp_path)
    if name.startswith(("from_", "to_")) and name != "from_floats":
        pytest.importorskip(name.partition("_")[2])
    function = PUBLIC[name]
    # to draw takes long
    calls = sample(
        list(handed(function)), 16 if name in ("plot", *plots.__all__, *pictures3d.__all__) else 100, seed=name
    )
    wrong = [error for _, arguments in calls if (error := raised(name, function, arguments)) is not None]
    assert not wrong


def raised(name, function, arguments):
    """What else a call raised than an error that says what to do instead."""
    try:
        function(*arguments)
    except OverflowError:
        return None  # as ``float`` has it, of a number for which there is no double
    except xs.ExactSplineError as error:
        return None if error.remedy else error
    except TypeError as error:
        return None if error.__traceback__.tb_next is None else error  # Python's own: too many arguments
    except Exception as error:
        return None if type(error) is OWN_ERRORS.get(name) else error


def curve_file():
    xs.write([CUSP], "cusp.json")
    return ("cusp.json",)


SPACE = VALUES["space curve"]
SCROLL = xs.formula_of("tangent_developable_reduced")(xs.example("rational_space_cubic"))
CUBIC_OF_SCIPY = pytest.importorskip("scipy.interpolate").CubicSpline([0, 1, 2], [0, 1, 0])
#: For every function with arguments that have defaults, what it is given in the other places.
OPTIONS = {
    "evaluate": (T, "1/2"),
    "check_certificate": (xs.zeros(T * T - 2).certificate(),),
    "common_zeros": (VALUES["tensor spline"], VALUES["tensor spline"]),
    "contains": (xs.example("circle"), (0, 0)),
    "curvature": (CUSP, "1/3"),
    "degree": ("f2",),
    "derive": ("evolute", CUSP),
    "circle": ((0, 0), 2),
    "claims": ("C4.1a",),
    "elevation_triangles": (T,),
    "errata": (),
    "examples": (),
    "factor_of": ("f1", "f2", 2),
    "features_of_curves": ([[[0.0, 0], [1, 1], [2, 0], [3, 1]]],),
    "floats": ([1, 2],),
    "formula": ("here",),
    "read_scipy": (CUBIC_OF_SCIPY,),
    "interpolate": ([(0, 0), (1, 1), (2, 0)],),
    "from_floats": ([0.5, 1],),
    "text": (CUSP,),
    "to_sympy": (CUSP,),
    "from_scipy": (CUBIC_OF_SCIPY,),
    "insertion_triangle": (T, "1/2"),
    "inspection_data": (CUSP,),
    "intersections": (CUSP, CUSP),
    "jets_for": (["f2"], 2),
    "paper": ("no such folder",),
    "new_figure": (),
    "plot": (CUSP,),
    "plot_bisector": (CUSP, (3, 1)),
    "plot_curve": (CUSP,),
    "plot_evolute": (CUSP,),
    "plot_features": (CUSP, ["1/2"], None),
    "plot_function": (T,),
    "plot_quotient": (CUSP.gamma,),
    "plot_roots": (xs.zeros(T * T - 2),),
    "plot_ruled_surface": (SCROLL,),
    "plot_surface": (VALUES["surface"].S,),
    "prove": ("f2", "f2"),
    "decide": (VALUES["claim"],),
    "plot_stability": (CUSP,),
    "read": curve_file,
    "reading_along": ("4.3",),
    "reduction": ("f2",),
    "ruled_surface": ("binormal_scroll", SPACE),
    "self_intersections": (CUSP,),
    "series_curve": (CUSP, "1/3", 3),
    "sweep": ([CUSP],),
    "symbolic_table": (),
    "table_1_splines": (),
    "to_dict": (CUSP, "cusps"),
    "to_records": (CUSP,),
    "torsion": (SPACE, "1/3"),
    "trace": (xs.formula_of("f2"),),
    "verdicts": ("C4.1a",),
    "verify": ("f2", "f2", CUSP),
    "write": ([CUSP], "written.json"),
    "wronskian": (xs.language.Vector(T, T * T),),
    "zero_curve": (VALUES["tensor spline"],),
    "zeros": (T * T - 2,),
}


def options(name):
    """The names of the arguments that a function has beside those that it is given (not of what it calls), and for
    `plot` those of what it draws.
    """
    if name == "plot":
        return ["color", "label", "knots", "control_polygon", "box", "no such option"]
    parameters = list(inspect.signature(PUBLIC[name]).parameters.values())
    given = () if callable(OPTIONS[name]) else OPTIONS[name]
    return [
        p.name
        for i, p in enumerate(parameters)
        if p.default is not p.empty and (i >= len(given) or p.kind is p.KEYWORD_ONLY) and p.name != "tick"
    ]


def test_every_option_is_tried():
    functions = {name: inspect.signature(found) for name, found in PUBLIC.items() if inspect.isfunction(found)}
    having = [name for name, own in functions.items() if any(p.default is not p.empty for p in own.parameters.values())]
    assert sorted({*having, "plot"}) == sorted(OPTIONS)


@pytest.mark.parametrize("name", OPTIONS)
def test_every_option_of_every_function(name, tmp_path, monkeypatch):
    """Before: TypeErrors, KeyErrors, ValueErrors of matplotlib, of 27 functions; `verdicts(without="identity")` left
    out whatever kind is a part of that word.
    """
    monkeypatch.chdir(tmp_path)
    arguments = OPTIONS[name]() if callable(OPTIONS[name]) else OPTIONS[name]
    function, wrong = PUBLIC[name], []
    for option in options(name):
        for label, value in sample(list(VALUES.items()), 10, seed=f"{name} {option}"):
            error = raised(name, lambda: drained(function(*arguments, **{option: value})), ())  # noqa: B023
            wrong += [(option, label, error)] if error is not None else []
    assert not wrong


def drained(answer):
    """An answer, its first parts where it is an iterator."""
    return list(islice(answer, 2)) if isinstance(answer, Iterator) else answer


@pytest.mark.parametrize("name", QUESTIONS)
def test_every_question_about_every_curve(name):
    """An answer, or an error of ours: for curves in R1 to R4, single points, and curves that stand still."""
    asked = QUESTIONS[name]
    for value in VALUES.values():
        if isinstance(value, xs.Nurbs):
            with contextlib.suppress(xs.ExactSplineError):
                asked.answer(xs.analyse(value), asked.about.argument, asked.about.place)


def test_what_an_error_says():
    """Each was a bare TypeError or AttributeError before, or did not end."""
    for call, told in (
        (lambda: xs.Side("middle"), "the side 'middle' is unknown; there are left, right"),
        (lambda: xs.formula_of(None), "a NoneType, where a formula is expected; give one, such as"),
        (
            lambda: xs.prove(3, "f2"),
            'an int, where a formula is expected; give one, such as exactspline.formula_of("f2")',
        ),
        (lambda: xs.claims(3), "an int, where the id of a claim is expected"),
        (lambda: xs.degree("f2", dimension="3"), "'3', where a dimension is expected; give an integer from 1 to"),
        (
            lambda: xs.teaching.elevation_triangles(T, 10**9),
            "degree elevation by 1000000000; an integer from 1 to 1000",
        ),
        (lambda: T.elevate_degree(10**9), "degree elevation by 1000000000; an integer from 0 to 1000 "),
        (lambda: T.d(10**9), "a derivative of order 1000000000; orders are 0, 1, 2, …, 1000"),
        (lambda: CUSP.derivative(10**9, 0), "a derivative of order 1000000000; orders are 0, 1, 2, …, 1000"),
        (lambda: (T / (T + 1)).d(-1), "a derivative of order -1; orders are 0, 1, 2, …, 1000"),
        (lambda: CUSP.p.d(10**9), "a derivative of order 1000000000; orders are 0, 1, 2, …, 1000"),
        (lambda: xs.language.wronskian(xs.language.Vector(1, 2)), "the derivative of a vector of numbers"),
        (
            lambda: xs.from_floats(DEEP),
            "lists nested more than 8 levels deep; give a list of floats, or of rows of floats",
        ),
    ):
        with pytest.raises(xs.ExactSplineError) as error:
            call()
        assert told in str(error.value)


def test_errors_name_what_is_expected():
    """Before: "'Piece' object has no attribute '_analysis'" before."""
    with pytest.raises(xs.ExactSplineError, match="a Piece, where a curve is expected"):
        xs.analyse(VALUES["piece"])
    with pytest.raises(xs.ExactSplineError, match="from_splines"):
        xs.analyse(VALUES["piece"].value)
    value = VALUES["piece"].value
    assert xs.analyse(xs.Nurbs.from_splines(value.numerator, value.denominator)).singular_points is not None


# ---- bridges


def test_piecewise_polynomials_of_scipy():
    """AttributeErrors before: "'CubicSpline' object has no attribute 'k'"."""
    np, si = pytest.importorskip("numpy"), pytest.importorskip("scipy.interpolate")
    x, y = np.array([0.0, 0.5, 2, 3, 4.25]), np.array([0.0, 1, 0.1, 2, 3])
    scalars = [
        si.CubicSpline(x, y),
        si.Akima1DInterpolator(x, y),
        si.PchipInterpolator(x, y),
        si.PPoly(np.array([[1.0, 2], [3, 4], [0.1, 5]]), np.array([0.0, 0.7, 2])),
        si.BPoly(np.array([[1.0, 2], [3, 4], [0.1, 5]]), np.array([0.0, 0.7, 2])),
    ]
    for spline in scalars:
        found = xs.interchange.from_scipy(spline)
        for t in np.linspace(spline.x[0], spline.x[-1], 33)[:-1]:
            assert float(found(from_float(float(t)))) == pytest.approx(float(spline(t)), rel=1e-12, abs=1e-12)
    for spline in scalars[:1] + scalars[3:4]:  # in powers, exactly
        found, powers = xs.interchange.from_scipy(spline, literal=True), spline.c[::-1]
        for i, a in enumerate(map(from_float, map(float, spline.x[:-1]))):
            t = a + mpq(1, 7)
            assert found(t) == sum(from_float(float(c)) * mpq(1, 7) ** k for k, c in enumerate(powers[:, i]))
    with pytest.raises(ShapeError, match="breakpoints that decrease"):
        xs.interchange.from_scipy(si.PPoly(np.array([[1.0, 2], [3, 4]]), np.array([2.0, 1, 0])))
    pair = xs.interchange.from_scipy(si.CubicSpline(x, np.stack([x, y], 1)))
    assert (pair.dimension, pair.degree, pair.segments) == (2, 3, 4)


def test_knots_coefficients_and_degree_of_scipy():
    """An AttributeError before: "'tuple' object has no attribute 'k'"."""
    np, si = pytest.importorskip("numpy"), pytest.importorskip("scipy.interpolate")
    x, y = np.array([0.0, 1, 2, 3, 4]), np.array([0.0, 1, 0.5, 2, 3])
    tck = si.splrep(x, y)
    assert xs.interchange.from_scipy(tck) == xs.interchange.from_scipy(si.BSpline(*tck))
    (t, c, k), _ = si.splprep([x, y], s=0)
    curve = xs.interchange.from_scipy((t, c, k))
    assert (curve.dimension, curve.degree) == (2, 3)
    assert float(curve(curve.domain[1])[1]) == pytest.approx(3)
    three = si.NdBSpline((np.array([0.0, 0, 1, 1]),) * 3, np.ones((2, 2, 2)), 1)
    for other in (three, (1, 2, 3), "tck", None):
        with pytest.raises(xs.ExactSplineError, match="not a scipy spline in one parameter"):
            xs.interchange.from_scipy(other)


def test_surfaces_and_texts_for_curves_of_geomdl():
    """Before: "[0.0, 0.0, 1.0, 1.0] is not a finite number", and an AttributeError, before."""
    with pytest.raises(xs.ExactSplineError, match="a Surface, where a geomdl curve is expected"):
        xs.interchange.from_geomdl(of_geomdl())
    with pytest.raises(xs.ExactSplineError, match="a str, where a geomdl curve is expected"):
        xs.interchange.from_geomdl("a")


# ---- values


def test_a_spline_at_a_root():
    """Nothing took a spline and a root: "'BSpline' object has no attribute 'at'"."""
    assert xs.evaluate(T, mpq(1, 3)) == mpq(1, 3)
    assert xs.evaluate(T * T, ROOT) == 2
    assert xs.evaluate(T * T * T, ROOT) ** 2 == 8
    with pytest.raises(xs.ExactSplineError, match=r"a root, which need not be rational; .* exactspline.evaluate takes"):
        T(ROOT)


def test_singular_points_in_four_dimensions():
    """Before: "too many values to unpack" before."""
    there_and_back = xs.Nurbs(2, [0] * 3 + [1] * 3, [(0, 0, 0, 0), (1, 0, 0, 1), (0, 0, 0, 0)])
    assert [(f.kind.value, f.root.exact) for f in xs.analyse(there_and_back).singular_points] == [("cusp", mpq(1, 2))]
    assert xs.analyse(VALUES["curve in R4"]).singular_points.points == ()


@pytest.mark.parametrize("end", ["1/10", "2/3", "0.1", "1e300/3", "1e-300", "123456789.123456789"])
def test_the_double_nearest_to_an_end_is_in_the_domain(end):
    """A DomainError before, where the double lies outside: floats([0.1]) on [0, 1/10]."""
    numerator, _, denominator = end.partition("/")
    b = xs.rational(numerator) / xs.rational(denominator or "1")
    for curve in (xs.Nurbs(1, [0, 0, b, b], [(0, 0), (1, 1)]), xs.Nurbs(1, [b, b, 2 * b, 2 * b], [(0, 0), (1, 1)])):
        for t in map(float, curve.domain):
            ((x, _),) = curve.floats([t])
            assert x == pytest.approx(float(t > b * mpq(3, 2)) if curve.domain[0] else float(t > 0), abs=1e-15)
            assert curve.floats([t], of="curvature") == 0
    with pytest.raises(xs.ExactSplineError, match="outside the domain"):
        xs.Nurbs(1, [0, 0, b, b], [(0, 0), (1, 1)]).floats([float(b) * 1.0001])


def test_one_overflow_does_not_end_the_others():
    """An OverflowError for the whole batch before."""
    curve = xs.Nurbs(1, [0, 0, 1, 1], [(0, 0), ("-1e400", 1)])
    assert curve.floats([0, "1/2", 1]).tolist() == [[0.0, 0.0], [-float("inf"), 0.5], [-float("inf"), 1.0]]
    assert curve.floats(1, rounding="up")[0] == -1.7976931348623157e308
    steep = xs.Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), ("1e-400", 0), (1, 1)])
    with pytest.raises(OverflowError):
        float(xs.curvature(steep, 0))
    assert xs.curvature(steep, 0) > mpq(10) ** 399


def test_features_of_curves_curves_can_be_pickled():
    """Before: "cannot pickle 'mappingproxy' object" before."""
    found = xs.features_of_curves([[(0, 0), (1, 2), (2, -2), (3, 0.5)], [(0, 0), (1, float("nan")), (2, 2), (3, 0)]])
    again = pickle.loads(pickle.dumps(found))
    assert again.curve.tolist() == found.curve.tolist()
    assert [*again.refused] == [*found.refused] == [1]
    with pytest.raises(TypeError):
        again.refused[0] = None
    # a ValueError before: "The truth value of an array with more than one element is ambiguous"
    assert again == found
    assert found != xs.features_of_curves([[(0, 0), (1, 2), (2, -2), (3, 0.5)]])


# ---- equality


def test_a_quotient_equals_the_spline_that_it_is():
    """t · t / t was not t / 1."""
    square = T * T / T
    pairs = [(square, T), (xs.language.Vector(T * T, T) / T, xs.language.Vector(T, T.constant(1)))]
    s, one = VALUES["tensor spline"], VALUES["tensor spline"].constant(1)
    pairs += [(s * s / s, s), (xs.language.Vector(s, s) / one, xs.language.Vector(s, s))]
    for quotient, spline in pairs:
        assert quotient == spline
        assert spline == quotient
        assert hash(quotient) == hash(spline)
        assert len({quotient, spline}) == 1
    assert square != T + 1
    other = T + 1
    assert other != square
    assert square != xs.BSpline.identity(0, 1)
    assert T / T != 1
    assert T * 0 / (T * 0) != T
    assert xs.language.Vector(T, T) / T != xs.language.Vector(T, T, T)
    half = xs.BSpline.identity(0, 1)
    assert (half * half / half == square) is False


# ---- degenerate curves, files


def test_a_point_and_a_curve_of_one_point():
    """In space it is a plane, and no surface over the curve; in the plane the line x + 2y = 5/2, which was refused."""
    with pytest.raises(xs.ExactSplineError, match=r"the curve is one point, \(1, 2"):
        xs.bisector(STILL, (0, 0, 0))
    flat = xs.Nurbs(1, [0, 0, 1, 1], [(1, 2), (1, 2)])
    (line,) = xs.bisector(flat, (0, 0)).pieces
    assert (line.low, line.high) == (-1, 1)
    points = [line(xs.rational(k) / 7) for k in range(-6, 7)]
    assert [x + 2 * y for x, y in points] == [xs.rational("5/2")] * 13
    assert points == sorted(points, reverse=True)


def test_examples_by_name_where_files_are_wanted(tmp_path):
    """Before: "cannot be read (No such file or directory)" before."""
    done = run("convert", "ellipse", tmp_path / "e.json")
    assert done.returncode == 0
    assert xs.read(str(tmp_path / "e.json")).curve == xs.example("ellipse")
    assert xs.read("ellipse").curves[0].curve == xs.example("ellipse")
    with pytest.raises(xs.ExactSplineError, match="neither a file nor an example"):
        xs.read("ellipze")


def test_a_point_of_weight_0_is_remarked(tmp_path):
    """Nothing was said of it; then a point that adds nothing was called a direction."""

    def described(curve):
        xs.write(curve, tmp_path / "curve.json")
        lines = run("prove", "--claim", "C41a-f1-f2", "--curve", tmp_path / "curve.json").stdout.splitlines()
        return next(line for line in lines if "control points in R" in line)

    assert described(AT_INFINITY).endswith("3 control points in R2, of these 1 direction")
    idle = xs.Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), (1, 1), (2, 0)], [1, 0, 1])
    assert described(idle).endswith("3 control points in R2, 1 with the weight 0 (without effect)")
    both = xs.Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (1, 1), xs.Direction(1, 0), (2, 0)], [1, 0, 0, 1])
    assert described(both).endswith("of these 1 direction, 1 with the weight 0 (without effect)")
    assert "weight 0" not in described(CUSP)
