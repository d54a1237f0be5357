"""A formula stands once and has a claim; no function asks what reading its operand belongs to; what is independent on
purpose shares no code.
"""

import ast
import doctest
import gc
from collections import defaultdict
from collections.abc import Iterable, Iterator
from functools import cache
from importlib import import_module
from pathlib import Path
from random import Random

import pytest

import exactspline
from exactspline.formulas import lifted
from exactspline.language.formula import Formula, formula
from exactspline.language.operand import Operand
from exactspline.language.ruled import split
from exactspline.language.surface_kind import BOTH
from exactspline.language.vector import det, norm2
from exactspline.numbers.exact import mpq
from exactspline.papers import papers
from exactspline.readings.differential_order import order_of
from exactspline.readings.jet import RationalJetReading
from exactspline.readings.taylor import DoubleSeries, Series
from exactspline.verification.claims import claims_in
from tests.support.import_graph import imported, nodes, trees
from workshop.mutation.formulas import every_formula, home, reached, spoken_of


@cache
def all_claims():
    """The claims of all papers of the library."""
    return [claim for source in papers() for claim in claims_in([source])]


# ---- every formula is one of a paper or of the room of formulas


def strays(formulas: Iterable[Formula]) -> list[Formula]:
    """Formulas that no paper of the library has."""
    known = set(every_formula())
    return [f for f in formulas if f not in known]


def alive() -> list[Formula]:
    """All formulas that there are once all modules with formulas are loaded, but for those of tests: also of the
    examples in docstrings, where these ran before in this process.
    """
    for name in trees():
        if name.split(".")[0] in ("formulas", "papers", "programs", "geometry", "verification", "symbolic"):
            import_module(f"exactspline.{name}".rstrip("."))
    gc.unfreeze()  # what `conftest` froze is not among the objects
    found = [f for f in gc.get_objects() if isinstance(f, Formula) and f.__module__.startswith("exactspline.")]
    gc.freeze()
    return [f for f in found if not _of_an_example(f)]


def _of_an_example(f: Formula) -> bool:
    """Whether a formula was made by an example in a docstring, which something may keep alive."""
    return getattr(f.function, "__code__", at_a_point.__code__).co_filename.startswith("<doctest")


#: What makes formulas of others, and why.
MAKERS = {
    "language.formula": "the decorator",
    "papers": "a function of a user's file",
    "papers.formula_check": "a function of a user's file",
    "symbolic.assumptions": "the polynomial of an assumption, for its order",
    "verification.questions": "a function, or a formula in one line, typed at the prompt",
    "verification.generic_proof": "a formula of a pair with its curves exchanged",
}


def test_every_formula_belongs_to_a_paper():
    """Passed before: eight formulas of `programs.invariants`, which no claim knew."""
    loaded = [f for f in alive() if "<l" not in getattr(f.function, "__qualname__", "<lambda>")]
    assert strays(loaded) == []
    assert len(loaded) >= 680


def test_formulas_of_examples_in_docstrings_are_none_of_them():
    """Failed before, when the example of `readings.leading_terms` had run in this process and its formula was kept."""
    names = {"__name__": "exactspline.readings.leading_terms"}
    text = ">>> @formula('an example')\n... def kept(c):\n...     return c.w\n"
    example = doctest.DocTestParser().get_doctest(text, names | {"formula": formula}, "kept", None, None)
    assert doctest.DocTestRunner().run(example, clear_globs=False).failed == 0
    assert example.globs["kept"].__module__ == names["__name__"]
    assert example.globs["kept"] not in alive()


def makers(modules: dict[str, ast.Module]) -> set[str]:
    """The modules outside of the rooms of formulas that make formulas."""
    return {
        name
        for name, tree in modules.items()
        if name.split(".")[0] != "formulas" and not (name.startswith("papers.") and name.count(".") > 1)
        for node in nodes(tree)
        for call in [node, *getattr(node, "decorator_list", ())]
        if isinstance(call, ast.Call) and getattr(call.func, "id", "") == ("Formula" if call is node else "formula")
    }


def test_formulas_are_made_nowhere_else():
    found = makers(trees())
    assert found <= MAKERS.keys() | {"papers.new"}
    planted = ast.parse("@formula('here')\ndef turning(c):\n    return c.w")
    assert makers(trees() | {"programs.invariants": planted}) - found == {"programs.invariants"}


# ---- every formula has a claim


def without_a_claim(formulas: Iterable[Formula]) -> list[Formula]:
    """Formulas of which no claim speaks, by their names or by that of a formula that calls them."""
    spoken = {place for claim in all_claims() for f in spoken_of(claim) for place in reached(home(f))}
    return [f for f in formulas if home(f) not in spoken]


def test_every_formula_has_a_claim():
    """Passed before: the polynomial of the ridges, and three formulas that nothing used."""
    assert without_a_claim(every_formula()) == []


@formula("planted", on="plane")
def planted(c):
    """The zeros of the curvature, once more."""
    return det(c.gamma.d(1), c.gamma.d(2)) * c.w**3


def test_a_formula_without_a_claim_is_found():
    assert without_a_claim([*every_formula(), planted]) == [planted]
    assert strays([planted]) == [planted]


# ---- a formula stands once

#: How many derivatives are random numbers: of a curve, of a surface.
TERMS, DOUBLE_TERMS = 9, 6


def at_a_point(f: Formula, dimension: int) -> tuple[object, ...] | None:
    """The value of a formula where all derivatives are random numbers: of operands that are functions of the same
    parameters and independent of each other; None for others.
    """
    kind = f.kind
    symbols = kind.symbols(dimension)
    parameters = {symbol.parameters for symbol in symbols if symbol.parameters}
    if kind.rules(dimension) or kind.composed or len(parameters) > 1:
        return None
    double = parameters == {BOTH}
    if not double and any(len(each) > 1 for each in parameters):
        return None

    def operand(symbol):
        random = Random(f"{symbol.name} {dimension}")
        if double:
            size = DOUBLE_TERMS if symbol.parameters else 1
            places = [(i, j) for i in range(size) for j in range(size - i)]
            return DoubleSeries({place: mpq(random.randint(1, 99)) for place in places}, DOUBLE_TERMS)
        rest = [random.randint(1, 99) if symbol.parameters else 0 for _ in range(TERMS - 1)]
        return Series(map(mpq, [random.randint(1, 99), *rest]))

    unit = DoubleSeries({(0, 0): mpq(1)}, DOUBLE_TERMS) if double else Series(map(mpq, [1, *[0] * (TERMS - 1)]))
    components, _ = split(f(kind.argument(dimension, operand, unit)))
    parts = _parts(components)
    return tuple(x.coefficients.get((0, 0), mpq(0)) if double else x.coefficients[0] for x in parts)


def _parts(components: Iterable[object]) -> Iterator[object]:
    """What numbers are made of: those with an adjoined root of three."""
    for x in components:
        yield from _parts((x.plain, x.rooted, x.square)) if hasattr(x, "rooted") else (x,)


@cache
def meaning(f: Formula) -> tuple[object, ...]:
    """What two formulas share that are equal for all curves, in the lowest dimension of their kind."""
    dimension = f.kind.dimensions[0]
    value = at_a_point(f, dimension)
    if value is None:
        c = RationalJetReading(order_of(f, dimension)).argument(f.kind, dimension)
        value = tuple(_written(x) for x in split(f(c))[0])
    return f.kind.name, f.kind.dimensions, *value


def _written(x):
    return (str(x.top), str(x.bottom)) if hasattr(x, "top") else tuple(map(_written, (x.plain, x.rooted, x.square)))


def vanishes(value: Iterable[object]) -> bool:
    return all(x in (0, ("0", "1")) for x in value)


#: Formulas that are equal and of which a claim speaks as parts of what is equal.
PARTS = [
    {"jerk", "third_derivative", "jerk_terms", "jerk_shared", "jet_3"},
    {"radius_squared", "inverse_curvature_squared", "curvature_radius_squared"},
    {"radius_vector", "towards_the_circle"},
    {"rectifying_vector_reduced", "lancret_vector"},
    {"bisector_numerators", "bisector_numerators_levelled"},
    {"point_bisector_directrix", "point_bisector_directrix_levelled", "point_bisector_directrix_polynomial"},
    {"chord", "moved_4"},
    {"rotated_tangent", "velocity_turned", "velocity_turned_by_D1"},
    {"curvature_vector_in_plane", "tangent_by_arc_length", "curvature_vector_by_radius"},
    {"towards_the_centre", "radius_vector_in_plane"},
    {"mapped_x", "x43"},
    {"mapped_y", "y_by_x43"},
]


def second_copies(formulas: Iterable[Formula]) -> list[set[str]]:
    """Formulas that are the same function although no claim says so, those that vanish apart."""
    tied: dict[object, object] = {}

    def root(x: object) -> object:
        while tied.setdefault(x, x) != x:
            x = tied[x]
        return x

    for claim in all_claims():
        first, *others = [claim.find(name) for name in claim.named] or [None]
        for other in others:
            tied[root(other)] = root(first)
    equal = defaultdict(list)
    for f in formulas:
        equal[meaning(f)].append(f)
    for names in PARTS:
        own = [f for f in formulas if f.name in names]
        for f in own[1:]:
            tied[root(f)] = root(own[0])
    return [
        {f.name for f in same}
        for key, same in equal.items()
        if len({root(f) for f in same}) > 1 and not vanishes(key[2:])
    ]


def test_no_formula_stands_twice():
    """Equal for all curves means: a claim says so, of them or of what they are parts of."""
    assert second_copies(every_formula()) == []


def test_a_second_copy_is_found():
    """Passed before: the Wronskian of the lift as `turning`, the numerator of (κ²)′ as `slope`."""
    (found,) = second_copies([*every_formula(), planted])
    assert "planted" in found
    assert "inflections_lifted" in found
    squared = formula("planted", on="plane")(lambda c: norm2(lifted.tangent_lifted.function(c)) * 2 - 0)
    assert second_copies([lifted.tangent_lifted_squared, squared]) == []


# ---- no function asks what reading its operand belongs to


@cache
def readings() -> set[str]:
    """The names of the scalars of all readings."""
    found, todo, rooms = set(), [Operand], ("language", "readings", "programs", "splines")
    for name in trees():
        if name.split(".")[0] in rooms:
            import_module(f"exactspline.{name}")
    for each in todo:
        todo += each.__subclasses__()
        if each.__module__.startswith(tuple(f"exactspline.{room}." for room in rooms)):
            found.add(each.__name__)
    return found - {"Operand", "Rational", "RingOperand", "FieldOperand"}


PRODUCTS = {"det", "dot", "cross", "norm2", "perp", "triple", "join", "generalized_cross", "find"}


def _computes(function: ast.AST) -> bool:
    """Whether a function is written as a formula is: products, derivatives, products of vectors."""
    for node in ast.walk(function):
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult):
            return True
        if isinstance(node, ast.Call):
            name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
            if name in PRODUCTS or "wronskian" in name or (name == "d" and isinstance(node.func, ast.Attribute)):
                return True
    return False


def _asks(function: ast.AST) -> bool:
    """Whether a function asks whether something is a scalar of one reading, but to assert that it is."""
    asserted = {id(n) for node in ast.walk(function) if isinstance(node, ast.Assert) for n in ast.walk(node)}
    for node in ast.walk(function):
        if id(node) in asserted:
            continue
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") in ("isinstance", "issubclass"):
            names = {n.id for n in ast.walk(node.args[1]) if isinstance(n, ast.Name)}
        elif isinstance(node, ast.Compare) and "type(" in ast.unparse(node):
            names = {n.id for n in ast.walk(node) if isinstance(n, ast.Name)}
        else:
            continue
        if names & readings():
            return True
    return False


def asking(modules: dict[str, ast.Module]) -> Iterator[str]:
    """Functions that compute and ask for the reading of an operand, methods of the readings' own scalars apart."""
    for name, tree in modules.items():
        own = {n for c in nodes(tree) if isinstance(c, ast.ClassDef) and c.name in readings() for n in ast.walk(c)}
        for node in nodes(tree):
            if isinstance(node, ast.FunctionDef) and node not in own and _asks(node) and _computes(node):
                yield f"{name}:{node.name}"


#: What asks for the type of a value to show it, to prove something of it or to see what can be done: no formulas.
ALLOWED = {
    "display.plot.functions:plot_function": "a spline or a quotient is drawn",
    "interchange.bridges:to_sympy": "a spline or a curve is written for another library",
    "geometry.analysis.floats:_of_curve": "a curve or a function at parameters, rounded",
    "geometry.analysis.floats:_of_surface": "a surface or a function at parameters, rounded",
    "interchange.bridges:_joined": "a function or a curve is read",
    "interchange.bridges:read_scipy": "a function or a curve is read",
    "programs.program:operands_of": "whether there is a program",
    "readings.bernstein_term:every_coefficient": "a proof about values of its own reading",
    "verification.divisors:factored": "a denominator in factors, a number or a fraction",
    "extras.coq.settings:flat": "fractions with and without roots",
    "extras.coq.theorems:_whole": "what is assumed of a fraction",
    "extras.coq.theorems:met": "what is assumed of a fraction",
    "verification.one_function:agree": "the values of one formula in two classes, compared",
    "verification.one_function:_same_on": "the same, on splines",
    "verification.kinds.equality:_but": "zeros in two parameters are not compared",
    "verification.kinds.types:_independent": "roots within roots: whether they are independent",
}


def test_no_function_that_computes_asks_for_the_type_of_its_operand():
    assert set(asking(trees())) == ALLOWED.keys()


PLANTED = {
    "a conditional": "def f(c):\n    return c.w.by_v() if isinstance(c.w, Term) else c.w.d(1)",
    "a flag": "def f(c):\n    over_u = isinstance(c.w, Term)\n    return g(over_u) * c.w",
    "its exact type": "def f(x, y):\n    return det(x, y) if type(x) is BSpline else None",
    "one of several": "def f(v):\n    return lowest_wronskian(v) if isinstance(v[0], (Jet, Degree)) else other(v)",
}


@pytest.mark.parametrize("code", PLANTED.values(), ids=PLANTED)
def test_a_function_that_asks_is_found(code):
    assert list(asking({"programs.invariants": ast.parse(code)})) == ["programs.invariants:f"]


# ---- what is independent on purpose

REPOSITORY = Path(exactspline.__file__).parent.parent
#: Files that share no formula with what is held against them; those marked, nothing else of the library.
INDEPENDENT = {
    "workshop/bench/inline.py": True,
    "exactspline/certificates/__init__.py": True,
    "exactspline/certificates/degrees.py": True,
    "exactspline/certificates/zeros.py": True,
    "tests/support/oracles.py": False,
    "tests/support/numeric_reading.py": False,
}


def rooms_of(text: str) -> set[str]:
    """The rooms from which a file imports."""
    return {name.split(".")[0] for name in imported(ast.parse(text), set(trees()))}


def shared(text: str) -> set[str]:
    """The rooms from which a file imports formulas, or what computes with them."""
    return rooms_of(text) & {"formulas", "papers", "programs", "symbolic", "geometry"}


@pytest.mark.parametrize(("file", "alone"), INDEPENDENT.items(), ids=INDEPENDENT)
def test_what_is_independent_says_so_and_shares_no_formula(file, alone):
    text = (REPOSITORY / file).read_text(encoding="utf-8")
    assert shared(text) == set()
    assert not (alone and rooms_of(text) - {"certificates"})
    said = " ".join((ast.get_docstring(ast.parse(text)) or "").split()).lower()
    assert any(word in said for word in ("shares no", "sharing no", "without this library", "standard library")), said


def test_shared_code_is_found():
    assert shared("from exactspline.formulas.lifted import conformal_lift") == {"formulas"}
    assert shared("x = find('f2')") == {"papers"}
