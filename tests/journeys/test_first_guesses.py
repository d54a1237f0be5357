"""What a user types first works, or the error names the call that works; every such call, in errors, docstrings and
pages, is that of the front door.
"""

import ast
import inspect
import pydoc
import re
from contextlib import suppress
from fractions import Fraction
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

import pytest

import exactspline as xs
from exactspline import language
from exactspline.geometry.analysis.ask import REGISTRY
from exactspline.geometry.derived.constructions import all_constructions
from exactspline.hooks import DERIVED, LENT, QUESTIONS, first_guesses
from exactspline.questions.entry import Of
from tests.support.import_graph import files, nodes

np = pytest.importorskip("numpy")
pytest.importorskip("matplotlib").use("Agg")


def table(name):
    """The guesses of a table, and what is told."""
    rows = Path(__file__).with_name(name).read_text(encoding="utf-8").splitlines()
    return [row.rpartition(" → ")[::2] for row in rows if not row.startswith("#")]


GUESSES, SIXTY = table("first_guesses.txt"), table("sixty_guesses.txt")
#: Errors of Python itself, which name nothing.
PYTHON = 4


@pytest.fixture(scope="module")
def names(tmp_path_factory):
    interpolate, pandas = pytest.importorskip("scipy.interpolate"), pytest.importorskip("pandas")
    geomdl = pytest.importorskip("geomdl.BSpline")
    knots, points = [0, 0, 0, 0, 1, 1, 1, 1], [(0, 0), (1, 2), (3, 2), (4, 0)]
    of_geomdl = geomdl.Curve()
    of_geomdl.degree, of_geomdl.ctrlpts, of_geomdl.knotvector = 3, list(map(list, points)), knots
    curve = xs.Nurbs(3, knots, [(0, 0), (1, 2), (2, -2), (3, 0)])
    place = str(tmp_path_factory.mktemp("guesses") / "curve.json")
    xs.write(curve, place)
    return {
        "xs": xs, "np": np, "Fraction": Fraction, "knots": knots, "points": points, "numbers": [0, 1, 0, 1],
        "weights": [1, 2, 2, 1], "path": place, "c": curve, "d": xs.Nurbs(3, knots, points),
        "f": xs.BSpline(3, knots, [0, 1, 0, 1]), "geomdl_curve": of_geomdl,
        "arc": xs.Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], weights=[1, 1, 2]),
        "x": np.linspace(0, 3, 7), "y": np.sin(np.linspace(0, 3, 7)), "si": interpolate, "pd": pandas,
        "plt": import_module("matplotlib.pyplot"),
        "scipy_curve": interpolate.BSpline(np.array(knots, float), np.array(points, float), 3),
    }  # fmt: skip


@pytest.mark.parametrize(("guess", "told"), dict(GUESSES + SIXTY).items(), ids=dict(GUESSES + SIXTY))
def test_a_guess_works_or_its_error_names_the_call(guess, told, names):
    if "c.area" in guess or "area(c" in guess:  # of a closed curve
        names = names | {"c": xs.Nurbs.bezier([(0, 0), (1, 2), (3, 2), (0, 0)])}
    if told == "works":
        eval(guess, names)
        return
    with pytest.raises((xs.ExactSplineError, AttributeError, TypeError)) as caught:
        eval(guess, names)
    assert told == "Python" or told in str(caught.value)


def test_most_guesses_work():
    """41 of 111 before, 26 of 60."""
    for guesses, count, most in ((GUESSES, 111, 97), (SIXTY, 60, 45)):
        told = [told for _, told in guesses]
        assert len(told) == len(dict(guesses)) == count
        assert told.count("works") >= most
        assert told.count("Python") <= PYTHON


def test_the_questions_are_those_of_the_registry():
    of = [of for of in Of if of not in (Of.TWO_CURVES, Of.TWO_SURFACES, Of.REGION, Of.PAIR, Of.PLANAR_MAP)]
    assert set(first_guesses()[QUESTIONS]) == {name for each in of for name in REGISTRY[each]}
    assert set(first_guesses()[LENT]) <= set(dir(xs))


def test_a_name_that_moved_is_told_and_does_not_work():
    for name, call in (("find", 'exactspline.formula_of("f2")'), ("proved", "exactspline.decide(")):
        with pytest.raises(AttributeError, match=re.escape(f"; write {call}")):
            getattr(xs, name)


def test_what_is_derived_is_found_by_its_name():
    """AttributeErrors before: a user looks for the focal curve, not for `derive`."""
    assert (
        {*first_guesses()[DERIVED], *first_guesses()[QUESTIONS]} >= {*all_constructions()} > {*first_guesses()[DERIVED]}
    )
    space = xs.example("rational_space_cubic")
    assert xs.focal_curve(space).pieces == space.focal_curve().pieces == xs.derive("focal_curve", space).pieces
    assert space.tangent_developable("naive").variant == "naive"
    with pytest.raises(xs.ExactSplineError):
        xs.example("circle").focal_curve()


def test_every_other_name_leads_to_a_call_that_is_there():
    curve, spline, surface = xs.example("circle"), xs.BSpline.identity(0, 1), xs.example("torus")
    for call in first_guesses():
        name, _, _ = call.partition("(")
        room, _, attribute = name.rpartition(".")
        if room == "x":
            assert any(hasattr(thing, attribute.split()[0]) for thing in (curve, spline, surface)), call
        elif room.startswith("exactspline"):
            assert callable(named(name)), call
        elif not call.isalpha():
            assert eval(call, {"x": curve, "exactspline": xs, "pandas": pytest.importorskip("pandas")}) is not None


def named(dotted):
    """What a dotted name of the front door means; AttributeError where it means nothing."""
    found = xs
    for i, part in enumerate(dotted.split(".")[1:], 2):
        place = ".".join(dotted.split(".")[:i])
        found = import_module(place) if not hasattr(found, part) and find_spec(place) else getattr(found, part)
    return found


def test_completion_shows_what_is_there():
    """The names alone, without asking a question; other libraries' names are found, but not listed."""
    curve, spline, surface, analysis = xs.example("circle"), xs.BSpline.identity(0, 1), xs.example("torus"), "analyse"
    shown = {thing: set(dir(thing)) for thing in (curve, spline, surface)}
    assert set(first_guesses()[LENT]) <= shown[curve] & shown[spline] & shown[surface]
    assert "inflections" in shown[curve] - shown[spline] - shown[surface]
    assert "umbilics" in shown[surface] - shown[curve] - shown[spline]
    assert not {"torsion_zeros", "ctrlpts", "Bezier", analysis + "d"} & shown[curve]
    assert {"length", "plot", "interchange"} <= set(dir(xs))
    assert isinstance(vars(type(curve).__mro__[-3])["length"], property)  # which completion does not evaluate


def test_help_shows_what_is_lent():
    """Passed before for the names alone: there were no signatures."""
    text = pydoc.plain(pydoc.render_doc(xs.Nurbs))
    for shown in ("plot(*things:", "exactspline.analyse(self).inflections", "contains(curves:", "x.control_points"):
        assert shown in text
    assert str(inspect.signature(xs.example("circle").torsion)).startswith("(t: ")
    assert xs.Nurbs.distance is xs.distance
    assert xs.Nurbs.from_scipy is xs.from_scipy
    with pytest.raises(AttributeError, match=r"type object 'Nurbs' has no attribute 'solve'; write exactspline\.zeros"):
        xs.Nurbs.solve  # noqa: B018


@pytest.mark.parametrize(("thing", "name", "says"), [
    ("circle", "torsion_zeros", "it is not asked of a plane curve"),
    ("circle", "umbilics", "it is not asked of a plane curve"),
    ("torus", "inflections", "it is not asked of a surface in space"),
    ("torus", "degree_elevation", None),
])  # fmt: skip
def test_what_objects_do_not_have(thing, name, says):
    if says is None:
        assert getattr(xs.example(thing), name)() == xs.example(thing).elevate_degree()
        return
    with pytest.raises(AttributeError, match=f"has no attribute '{name}'.*{says}"):
        getattr(xs.example(thing), name)


def test_questions_are_functions_too():
    assert xs.length(xs.example("circle")) == xs.example("circle").length
    assert xs.umbilics(xs.example("torus")) == xs.analyse(xs.example("torus")).umbilics
    assert xs.features_within(xs.example("cubic_s"), "1/1000") == xs.example("cubic_s").features_within("1/1000")
    with pytest.raises(AttributeError, match=r"exactspline\.graph"):
        xs.length(xs.BSpline.identity(0, 1))


CALL = re.compile(r"\bexactspline((?:\.\w+)+)\(")
ROOT = Path(xs.__file__).parent


@cache
def code():
    """Every node of the code, with the name of its file."""
    return [(path.name, node) for path, tree in files().items() for node in nodes(tree)]


def texts():
    """Every text in the code, with the name of its file."""
    return [(name, x.value) for name, x in code() if isinstance(x, ast.Constant) and isinstance(x.value, str)]


def calls():
    """Every call ``exactspline.name(…)`` in a text of the code and of the pages."""
    for place, text in texts():
        yield from ((place, name) for name in CALL.findall(text))
    for path in [ROOT.parent / "README.md", *(ROOT.parent / "docs").glob("*.md")]:
        if path.exists():
            yield from ((path.name, name) for name in CALL.findall(path.read_text(encoding="utf-8")))


def test_every_call_that_a_text_names_is_there():
    """`from_float` before, which errors named and the front door has not."""
    found = set(calls())
    assert len(found) > 15
    for place, name in found:
        assert callable(named(f"exactspline{name}")), (place, name)


#: A call in a text, and one with nothing but texts and numbers between its parentheses.
ANY_CALL = re.compile(r"(?<![\w.])([A-Za-z_]\w*(?:\.\w+)*)\(")
WHOLE = re.compile(r"""exactspline(?:\.\w+)+\((?:"[^"]*"|[\d. ,()\[\]]+)\)(?:\[0\])?""")
#: Calls in remedies that are no names of Python here: of a file's format, of a text of a degree, of another library.
FOREIGN = {"NAME", "translate", "max", "scipy.interpolate.make_interp_spline"}


def remedies():
    """The texts of all remedies in the code, and of those that are put together their parts."""
    for place, node in code():
        named = isinstance(node, ast.keyword) and node.arg == "remedy"
        if named or (isinstance(node, ast.Assign) and getattr(node.targets[0], "id", "") == "remedy"):
            parts = [each.value for each in ast.walk(node.value) if isinstance(each, ast.Constant)]
            yield from ((place, part) for part in parts if isinstance(part, str))


def test_every_call_in_a_remedy_is_there():
    """Of the front door, of the language of formulas, or of a curve, a function or their classes, also where
    ``exactspline.`` is not written.
    """
    things = {"curve": xs.example("circle"), "exactspline": xs}
    things |= {name: getattr(owner, name) for owner in (language, xs) for name in owner.__all__}
    found = [(place, call) for place, text in remedies() for call in ANY_CALL.findall(text) if call not in FOREIGN]
    assert len(found) > 15
    for place, call in found:
        first, *rest = call.split(".")
        owner = things.get(first, getattr(xs.BSpline, first, None))  # ``d(1, by=…)`` is said of functions
        for name in rest:
            owner = getattr(owner, name, None)
        assert callable(owner), (place, call)


def test_every_whole_call_in_a_text_is_executed():
    found = {(place, call) for place, text in texts() for call in WHOLE.findall(text)}
    assert len(found) >= 8
    for place, call in found:
        assert eval(call, {"exactspline": xs}) is not None, (place, call)


def test_every_call_of_the_table_is_executed(names, tmp_path, monkeypatch):
    """Of a curve or of a function, with what its placeholders mean."""
    monkeypatch.chdir(tmp_path)
    knots, net = [0, 0, 1, 1], [[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]]
    given = names | {
        "exactspline": xs, "numpy": np, "pandas": names["pd"], "other": names["d"], "point": (1, 1), "place": "a.json",
        "t": "1/2", "ts": [0, 0.5], "rows": [[0.5, 1.0]], "vector": (1, 2), "factor": 2, "question": "inflections",
        "degrees": (1, 1), "knots_u": knots, "knots_v": knots, "net": net, "start": (1, 0), "middle": (0, 1),
        "end": (-1, 0),
    }  # fmt: skip
    for call in first_guesses():
        if not call.isalpha() and not ("splinepy" in call and not find_spec("splinepy")):
            expression = call.partition(", of a function")[0].partition(", and for")[0]
            assert any(works(expression, given | {"x": names[x]}) for x in ("c", "f")), call


def works(expression, names):
    """Whether it is evaluated without an error of the package or an AttributeError."""
    with suppress(xs.ExactSplineError, AttributeError):
        eval(expression, names)
        return True
    return False


@pytest.mark.parametrize("given", [0.1, np.float32(0.1), np.float64(0.5)], ids=repr)
def test_what_the_error_of_a_float_names_is_executed(given):
    curve = xs.example("circle")
    with pytest.raises(xs.ExactSplineError) as caught:
        curve(given)
    data = re.search(r"exactspline\.\w+\(.*?\)", str(caught.value))[0]
    place = re.search(r"curve\.\w+\(.*?\)", str(caught.value))[0]
    names = {"curve": curve, "exactspline": xs}
    assert curve.floats(given).tolist() == eval(place, names).tolist() == [float(x) for x in curve(eval(data, names))]


def test_what_a_curve_is_read_from_is_a_curve():
    """ShapeErrors before: a NamedCurve, where a curve is expected."""
    reading, circle, step = xs.read("circle"), xs.example("circle"), (1, 0)
    for given in (reading, reading.curves[0]):
        assert xs.curvature(given, 0) == 1
        assert float(xs.analyse(given).length) == float(circle.length)
        assert xs.intersections(given, circle + step) == xs.intersections(circle, circle + step)
        assert xs.plot(given).get_legend()
        assert xs.floats(given, 0).tolist() == [1, 0]
        assert xs.evaluate(given, "1/2") == circle("1/2")
    with pytest.raises(xs.ExactSplineError, match=r"exactspline\.graph\(f\)"):
        xs.analyse(xs.BSpline.identity(0, 1))


def test_sums_and_multiples():
    vector = (1, 2)
    arc, line = xs.example("circle"), xs.Nurbs.bezier([(0, 0), (8, 4)], a=0, b=4)
    arc = arc.restrict(0, 4)
    assert (arc + line)(1) == tuple(a + b for a, b in zip(arc(1), line(1), strict=True))
    assert (arc - line + line) == arc == arc * 2 / 2 == vector + arc - vector == vector - (vector - arc)
    assert arc * -1 == -arc
    assert np.array(vector) + arc == arc + vector
    assert (arc @ arc).scalar == (arc @ arc).denominator
    assert arc.derivative()(1) == arc.derivative(1, 1)
    assert arc.derivative(2)("1/3") == arc.derivative(2, "1/3")
    assert line.derivative(2)(0) == (0, 0)
    space = xs.example("twisted_cubic")
    assert (arc - vector)(0) == (arc(0)[0] - 1, arc(0)[1] - 2)
    for wrong in (
        lambda: arc - 1,
        lambda: arc @ 1,
        lambda: arc + space(0),
        lambda: arc @ space,
        lambda: arc * line,
        lambda: arc * 0.5,
    ):
        with pytest.raises(xs.ExactSplineError):
            wrong()


@pytest.mark.skipif(not (ROOT.parent / "notebooks").is_dir(), reason="the notebooks are in the checkout only")
def test_twelve_tasks_take_three_lines_each():
    """Sections of a notebook, which the tests of notebooks run; the cell after each looks at the result."""
    nbformat = pytest.importorskip("nbformat")
    cells = nbformat.read(ROOT.parent / "notebooks" / "13_first_steps.ipynb", as_version=4).cells
    tasks = [cells[i + 1].source for i, cell in enumerate(cells) if re.match(r"## \d+\. ", cell.source)]
    assert len(tasks) == 12
    assert all(len(task.splitlines()) <= 3 for task in tasks)


@pytest.mark.parametrize(
    ("name", "call"),
    [
        ("order", "curve.degree + 1"),
        ("is_periodic", "analyse(curve).joints"),
        ("extrema", "turning_points:0"),
        ("tck", "to_scipy(curve).tck"),
    ],
)
def test_a_name_that_means_something_else_is_not_answered(name, call):
    """Passed before: the order of a cubic was 3, its `tck` the knots, and a closed polygon was periodic."""
    curve = xs.example("cubic_s")
    with pytest.raises(AttributeError, match=re.escape(call)) as refused:
        getattr(curve, name)
    remedy = str(refused.value).rpartition("; write ")[2].partition(", of a function")[0]
    assert eval(remedy, {"curve": curve, "exactspline": xs}) is not None
    with pytest.raises(AttributeError):
        xs.example("circle").ctrlptsw  # noqa: B018  # homogeneous in geomdl
