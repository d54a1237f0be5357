"""The laws of the house, each with a gate: what it forbids is not in the code, and is found where it is planted.

Where the code still breaks a law it is named with the reason; a name that is no longer needed fails.
(Law 1, imports, and formulas without branches: `test_architecture`. Law 2, a formula stands once: with the formulas.)
"""

import ast
from pathlib import Path

import pytest

from exactspline.cli.commands import leaves
from exactspline.geometry.analysis.ask import ASKED, REGISTRY
from exactspline.questions.entry import Answered, questions_of
from tests.support import gates, import_graph

CHECKOUT = Path(__file__).parents[2]


def planted(code, finder):
    """What a finder finds in a text."""
    return list(finder(ast.parse(code)))


# ---- law 3: a decision is data

#: Rooms that decide.
DECIDING = (
    "geometry/",
    "symbolic/",
    "extras/teaching/",
    "questions/",
    "bivariate/",
    "roots/",
    "polynomials/",
    "reals/",
    "programs/",
)
BY_SENTENCES = {
    "batch/lines.py: Summary.entries": "how many different notes there are",
    "extras/teaching/display/exercises.py: solution_lines": "a heading that a triangle has is not shown twice",
    "display/ledger_pages.py: Run._listed": "a sheet is found by its name, which is shown too",
    "extras/teaching/display/exercises.py: _result_html": "the name of an algorithm",
    "extras/teaching/display/exercises.py: _result_sheets": "the name of an algorithm",
    "extras/teaching/display/exercises.py: scheme_data": "the name of an algorithm",
    "papers/__init__.py: find": "the name of a paper, written before that of its formula",
    "verification/claims.py: located": "a user searches in the statements",
    "extras/coq/emission.py: _Attempt.text": "a type of Coq",
    "verification/statement.py: numbered": "a number that a statement tells already is not told again",
}
SENTENCES = {
    "its beginning": "def f(row):\n    return row.computed.startswith('no zero')",
    "a word in it": "def f(row):\n    return 'straight' in row.reason",
    "all of it": "def f(row):\n    return row.text == 'the curve is straight'",
    "a slice of it": "def f(row):\n    return row.reason[:3] == 'the'",
    "a pattern": "def f(error):\n    return re.fullmatch(r'-?\\d+', str(error))",
    "what stands before a colon": "def f(row):\n    return row.remark.partition(': ')[0]",
    "a table of sentences": "def f(row):\n    return VERDICTS[row.reason]",
    "a case": "def f(row):\n    match row.text:\n        case 'holds everywhere':\n            return True",
    "what is cut off": "def f(row):\n    return row.statement.removesuffix(' ≡ 0')",
    "the number of its words": "def f(row):\n    return row.note.count(' ')",
    "its place in a message": "def f(error):\n    return 'no single value' in str(error)",
    "a variable that holds it": "def f(row):\n    text = row.message\n    return text.startswith(row.file)",
    "what is made of it": "def f(row):\n    a = row.message or ''\n    b = a.lower()\n    return b.find(row.file) >= 0",
    "one after the other": "def f(row):\n    return [each for each in row.notes if each.startswith(row.file)]",
    "a parameter": "def f(message, file):\n    return message.startswith(file)",
    "a table asked for it": "def f(row):\n    return VERDICTS.get(row.message)",
    "its length": "def f(row):\n    return len(row.message) > 40",
    "what is left without a word": "def f(row):\n    return row.message.replace('no ', '') == row.message",
    "another sentence": "def f(row, other):\n    return row.remark == other.remark",
    "a name in it": "def f(row):\n    return row.file in row.message",
    "the beginning of a witness": "row.witness.startswith('the exact quotient is')",
    "a pattern of a witness": "re.fullmatch(r'-?\\d+, not -?\\d+', row.witness)",
    "a pattern of its text": "PATTERN.match(str(row.witness))",
    "words in what is computed": "'not proportional' in finding.computed",
    "the text of a factor": "finding.factor == '1'",
    "a variable with the words of a witness": "def f(row):\n    told = worded(row.witness)\n    told.endswith('1/0')",
    "a text with a witness in it": "def f(row):\n    told = f'{row.witness}'\n    return '1/0' in told",
    "a witness of a row of JSON": "row['witness'].partition(': ')",
    "a slice of the text of a witness": "str(finding.witness)[:5]",
    "a case of what is computed": "match found.computed:\n    case '0 = 0':\n        pass",
    "words that are split": "words(x).split(', not ')",
    "the text of a verdict": "row.verdict != 'PROVED'",
}
DATA = (
    "def f(text):\n    return text.startswith('a')",
    "row.witness is Fact.NOT_SO",
    "isinstance(row.witness, ExactQuotient)",
    "row.verdict == REFUTED",
    "f'{row.witness}'",
)


def test_no_sentence_decides():
    assert gates.found_in(gates.trees(), gates.decisions_by_sentences) == BY_SENTENCES.keys()


@pytest.mark.parametrize("code", SENTENCES.values(), ids=SENTENCES)
def test_a_sentence_that_decides_is_found(code):
    """Passed before: the summary of a sweep asked whether a message, held by a variable, begins with the file."""
    assert planted(code, gates.decisions_by_sentences)


@pytest.mark.parametrize("code", DATA)
def test_what_reads_no_sentence_is_not_found(code):
    """Nor is a variable of another function."""
    assert planted(f"def g(row):\n    text = row.message\n{code}", gates.decisions_by_sentences) == []


def test_no_part_of_a_name_decides():
    """Passed before: an object whose name begins with "evolute" does not exist where the curve is straight."""
    assert gates.found_in(gates.trees(), gates.names_taken_apart, DECIDING) == NAMES_TAKEN_APART.keys()
    assert planted("def f(name):\n    return name.startswith('evolute')", gates.names_taken_apart)
    assert planted("def f(row):\n    return re.match('D1', row.name)", gates.names_taken_apart)


NAMES_TAKEN_APART = {
    "extras/teaching/display/exercises.py: _symbol_latex": "how a symbol is written, nothing is decided",
    "questions/takes.py: parts_of": "reads what stands behind the name in the text of a question",
}


# ---- law 4: a question is an entry

UNREGISTERED = {
    "geometry/filter/certain.py: Certain.critical_points": "the answer of critical_points, where it is certain",
    "geometry/filter/certain.py: Certain.inflections": "the answer of inflections, where it is certain",
    "geometry/analysis/inspection.py: Report.places": "the answer of an entry",
    "geometry/analysis/inspection.py: Report.coordinate_extrema": "the answers of turning_points",
}
QUESTION = "class A(Facts):\n    @{}\n    def loops(self) -> Places[Feature]:\n        return Places(())"


def test_an_answer_about_places_is_that_of_an_entry():
    assert gates.found_in(gates.trees(), gates.unregistered, ("geometry/", "questions/")) == UNREGISTERED.keys()
    assert planted(QUESTION.format("property"), gates.unregistered) == ["A.loops"]
    assert planted(QUESTION.format("question(Of.PLANE_CURVE)"), gates.unregistered) == []


def test_every_class_with_questions_is_in_the_registry():
    """Passed before: a class of surfaces whose questions no schema, glossary or command has."""
    known = {each.__name__ for owner in ASKED for each in owner.__mro__}
    assert {place.rpartition(": ")[2] for place in gates.found_in(gates.trees(), gates.asked_classes)} <= known
    assert planted(QUESTION.format("question(Of.SURFACE)"), gates.asked_classes) == ["A"]
    assert "A" not in known
    for owner in ASKED:
        for name, entry in questions_of(owner).items():
            assert all(REGISTRY[of][name] is entry for of in entry.about.of)


NAMED = {
    name
    for entries in REGISTRY.values()
    for name, entry in entries.items()
    if entry.about.answered in (Answered.PLACES, Answered.PIECES, Answered.JOINTS, Answered.CURVES)
}
LISTS_OF_QUESTIONS = {
    "batch/inspections.py: ": "what a sweep asks where nothing is said",
    "display/plot/functions.py: ": "markers and colours",
}
SPELLED = {
    "texts": "ASKED = ['inflections', 'corners', 'cusps']",
    "attributes": "def f(found):\n    return found.inflections, found.corners, found.singular_points",
    "keys": "WORDS = {'inflections': 1, 'cusps': 2, 'straight_pieces': 3}",
    "a call": "check('umbilics', 'poles', 'parabolic_points')",
}


def test_no_second_list_of_questions():
    def finder(tree):
        return gates.lists_of_questions(tree, NAMED)

    assert gates.found_in(gates.trees(), finder) == LISTS_OF_QUESTIONS.keys()
    for code in SPELLED.values():
        assert planted(code, finder), code
    assert planted("ASKED = ['inflections', 'corners']", finder) == []


# ---- law 5: a number is a number

SECOND_NUMBERS = {
    "reals/algebraic.py: Algebraic": "inside the one real type: FLINT's algebraic numbers, wrapped",
    "reals/algebraic.py: Digits": "a view: digits as they are shown",
    "roots/answers.py: OneNumber": "no number: what has one, such as a feature its parameter",
}
WAYS = {
    "extras/pictures3d/patches.py: lines_of_curvature": "curves on a surface",
    "geometry/curves/values.py: curvature_function": "curvature as a function",
    "geometry/curves/facts.py: Facts.same_curvature": "a comparison",
    "geometry/curves/joints.py: Joint.same_curvature": "a comparison",
    "geometry/curves/joints.py: curvature_of": "curvature of one side of a knot, from its derivatives",
    "geometry/curves/features.py: SpaceFacts.reduced_torsion": "what torsion(curve, t) evaluates",
    "geometry/curves/features.py: SpaceFacts.torsion_numerator": "a form, whose zeros are asked for",
    "geometry/curves/features.py: torsion_zeros": "the answer of the question torsion_zeros",
    "geometry/surfaces/forms.py: constant_curvature": "of a patch of a surface",
    "geometry/surfaces/forms.py: SurfaceForms.curvatures": "of a surface: K and H at a place",
    "geometry/surfaces/forms.py: has_curvature": "of a patch of a surface",
    "geometry/surfaces/forms.py: SurfaceForms.curvature": "of a surface: numerator and denominator",
    "geometry/analysis/surfaces.py: SurfaceInspection.constant_curvature": "of a surface, where it is constant",
    "geometry/curves/values.py: curvature": "curvature at a parameter",
    "geometry/curves/values.py: torsion": "torsion at a parameter",
}
SURD = """
class Surd:
    def __add__(self, other): ...
    def __float__(self): ...
"""
VIEW = "class Root(Real):\n    def __lt__(self, other): ...\n    def refine(self, digits): ..."
ENCLOSURE = "class Enclosure:\n    def __lt__(self, other): ...\n    def refine(self, digits): ..."


def test_there_is_one_real_type():
    assert gates.found_in(gates.trees(), gates.numbers) == SECOND_NUMBERS.keys()
    assert planted(SURD, gates.numbers) == ["Surd"]
    assert planted(ENCLOSURE, gates.numbers) == ["Enclosure"]
    assert planted(VIEW, gates.numbers) == []


def test_there_is_one_way_to_a_curvature():
    rooms = ("geometry", "splines", "roots", "programs", "display", "extras", "reals", "verification")
    assert gates.found_in(gates.trees(), gates.ways_to_a_curvature, (*rooms, "batch/inspections")) == WAYS.keys()
    assert planted("class Curve:\n    def curvature_at(self, t): ...", gates.ways_to_a_curvature) == [
        "Curve.curvature_at"
    ]


# ---- law 6: none, all of these, or these

BARE_LISTS = {
    "geometry/analysis/surfaces.py: SurfaceInspection.umbilics_below_rounding": "some of the points of an answer",
    "bivariate/borders.py: roots_along": "a step of a search",
    "bivariate/quotients.py: border_pairs": "a step of a search",
    "geometry/bisectors/components.py: LinePiece.poles": "its denominator does not vanish throughout",
    "geometry/curves/facts.py: Facts.regular": "some of the roots given",
    "geometry/curves/facts.py: Facts.regular_pairs": "some of the roots given",
    "geometry/curves/facts.py: located": "the roots of a zero set, whose intervals the answer has beside them",
    "geometry/curves/features.py: critical_points": "the points of an entry's answer, which adds the pieces",
    "geometry/curves/features.py: flat_points": "the points of an entry's answer, which adds the pieces",
    "geometry/derived/derive.py: Derived.poles": "its denominator does not vanish throughout",
    "geometry/curves/poles.py: BetweenPoles.reversals": "its cusps and its corners of 180°, both of them answers",
    "geometry/curves/features.py: torsion_zeros": "the points of an entry's answer, which adds the pieces",
    "bivariate/singular_points.py: singular_on_patch": "isolated, of a square-free function: there are no pieces",
    "bivariate/across_borders.py: single_places": "the points of an entry's answer, which adds the parts of patches",
}


def test_no_answer_is_a_bare_list_of_points():
    """Passed before: the umbilics of a sphere, the zeros of a map that vanishes on a patch."""
    assert (
        gates.found_in(gates.trees(), gates.lists_of_places, ("geometry/", "bivariate/", "questions/"))
        == BARE_LISTS.keys()
    )
    code = "@question(Of.SURFACE)\ndef umbilics(self) -> {}: ..."
    for bad in (
        "tuple[Umbilic, ...]",
        "list[Feature]",
        "Sequence[Place]",
        "tuple[Feature, ...] | None",
        "'list[Root]'",
    ):
        assert planted(code.format(bad), gates.lists_of_places)
    assert planted(code.format("SurfacePlaces[Umbilic]"), gates.lists_of_places) == []


def test_an_entry_about_places_is_annotated_as_one():
    for entries in REGISTRY.values():
        for entry in entries.values():
            result = str(entry.compute.__annotations__["return"])
            assert (entry.about.answered is Answered.PLACES) == ("Places[" in result), entry.name


# ---- exact rooms

ROUNDED = {
    "extras/teaching/topics.py: exercise": "chooses by a seed",
    "numbers/exact.py: _finite": "the door for floats",
    "numbers/exact.py: _refuse_float": "refuses floats",
    "numbers/exact.py: _rounded": "rounds to a double, on request",
    "numbers/exact.py: _unrounded": "rounds to a double, on request",
    "numbers/exact.py: double_between": "rounds to a double, on request",
    "numbers/exact.py: _from_float": "the door for floats",
    "numbers/exact.py: _from_floats": "the door for floats",
    "numbers/exact.py: from_float": "the door for floats",
    "geometry/curves/angles.py: degrees": "digits that are shown",
    "geometry/analysis/floats.py: _doubles": "rounds to a double, on request",
    "geometry/analysis/floats.py: _rounded": "rounds to a double, on request",
    "geometry/analysis/floats.py: _values": "rounds to doubles, on request",
    "geometry/analysis/floats.py: _place_of": "rounds to a double, on request",
    "numbers/exact.py: double_root": "rounds to a double, on request",
    "numbers/intervals.py: double_in": "rounds to a double, on request",
    "geometry/rounded/forms.py: Family.crossing": "a guess: a number that any may be, certified afterwards",
    "geometry/rounded/stability.py: _Lifting._moved": "a guess: a curve, whose features are counted exactly afterwards",
    "geometry/rounded/stability.py: _Lifting._rows": "the same",
    "geometry/rounded/stability.py: _Lifting.curves": "the same",
    "geometry/rounded/stability.py: _best": "the same",
    "geometry/analysis/many_curves.py: _double": "the certified filter",
    "geometry/analysis/many_curves.py: _doubles": "the certified filter",
    "geometry/analysis/many_curves.py: _found": "the certified filter, which counts what has no double",
    "geometry/analysis/many_curves.py: _outside": "the certified filter",
    "geometry/analysis/many_curves.py: scaled_operands": "the certified filter",
    "interchange/segments.py: _about": "digits that are shown",
    "interchange/bridges.py: _joined": "the unit in the last place of a double",
    "interchange/bridges.py: _periodic": "the unit in the last place of a double",
    "extras/cad/rhino.py: _write": "writes a file of doubles, and names the numbers that are rounded",
    "extras/cad/rhino_process.py: _hex": "doubles of a file, bit by bit",
    "programs/accelerator.py: nearest": "the certified filter",
    "programs/certain_pairs.py: segment_in_doubles": "the certified filter",
    "programs/certain_pairs.py: precise_table_of": "the same, with what rounding leaves",
    "programs/error_bounds.py: factors": "the certified filter",
    "programs/doubles.py: _carried_out": "the certified filter",
    "polynomials/doubles.py: ordinates": "a guess, certified afterwards",
    "reals/algebraic.py: Digits.__float__": "rounds to a double, on request",
    "roots/root.py: Root.double": "rounds to a double, on request",
    "roots/segment_forms.py: ImageValue.double": "rounds to a double, on request",
    "reals/algebraic.py: Digits.__format__": "writes a number that is rounded exactly",
    "reals/real.py: RationalNumber.double": "rounds to a double, on request",
    "roots/answers.py: OneNumber.__float__": "rounds to a double, on request",
    "splines/evaluation.py: Evaluation._nearest": "rounds to a double, on request",
    "verification/conditioning.py: _at_root": "what is measured is the error of doubles",
    "verification/generic_proof.py: witness": "chooses by a seed",
    "verification/degree_tables.py: _witness_patch": "chooses by a seed",
}
ROUNDS = {
    "float": "def f(x):\n    return float(x) > 0",
    "in a formula": "f = lambda x: float(x)",
    "round": "def f(x):\n    return round(x, 9) == 0",
    "math": "import math\ndef f(x):\n    return math.sqrt(x)",
    "a name of math": "from math import sqrt\ndef f(x):\n    return sqrt(x)",
    "as another name": "from math import sqrt as root\ndef f(x):\n    return root(x)",
    "the method": "def f(x):\n    return x.__float__()",
    "of numpy": "import numpy\ndef f(x):\n    return numpy.float64(x)",
    "handed on": "def f(xs):\n    return list(map(float, xs))",
    "under another name": "def f(x):\n    number = float\n    return number(x)",
    "a method": "def f(x):\n    return x.double() > 0",
    "a tolerance": "import math\ndef f(x):\n    return math.isclose(x, 0)",
}


#: What draws the figures of a paper lies in its folder.
DRAWS = "/figures/"


def test_exact_rooms_round_nothing():
    exact = {name: tree for name, tree in gates.trees().items() if DRAWS not in name}
    assert gates.found_in(exact, gates.rounding, gates.EXACT) == ROUNDED.keys()


@pytest.mark.parametrize("code", ROUNDS.values(), ids=ROUNDS)
def test_what_rounds_is_found(code):
    assert planted(code, gates.rounding)
    assert not planted("from math import gcd, isqrt\ndef f(x):\n    return gcd(x, isqrt(x))", gates.rounding)


# ---- no cost without a bound

#: Where FLINT's own functions may be called: the doors, and what costs nothing.
UNBOUNDED = {
    "geometry/measures/integrals.py: _Rooted._roots": "paid for, by degree and bits, where the zeros are apart",
    "geometry/measures/integrals.py: _Logarithmic.ball": "where the zeros are apart",
    "geometry/measures/integrals.py: _reduced": "after the bound was checked",
    "geometry/measures/integrals.py: integral": "the same",
    "geometry/bisectors/system.py: common_divisor_along": "over the field of a root: Euclid's algorithm, bounded",
    "bivariate/common_zeros_certificate.py: _part_at": "over the field of a root: a door with an estimated cost",
    "numbers/exact.py: common_divisor": "integers",
    "polynomials/bernstein.py: add": "integers",
    "polynomials/bernstein.py: common_denominators": "integers",
    "polynomials/bernstein.py: without_content": "integers",
    "polynomials/elimination.py: discriminant": "the door: by values at integers, after the bound was checked",
    "polynomials/elimination.py: resultant": "the same",
    "polynomials/factors.py: _by_flint": "the door",
    "polynomials/factors.py: _certainly_coprime_on_a_line": "modulo a prime, in one variable",
    "polynomials/factors.py: _certainly_primitive": "modulo a prime, in one variable",
    "polynomials/elimination.py: _good_primes": "modulo a small prime, in one variable",
    "polynomials/elimination.py: _is_large": "modulo a small prime, in one variable",
    "polynomials/elimination.py: _no_zero_modulo": "modulo a small prime, in one variable",
    "polynomials/factors.py: _certainly_without": "modulo a prime, in one variable",
    "polynomials/factors.py: _divisor_in_many": "the door",
    "polynomials/factors.py: _divisor_of_two": "the door",
    "polynomials/factors.py: _one_degree": "modulo a prime, paid for",
    "polynomials/factors.py: _split": "the door",
    "polynomials/factors.py: certainly_coprime": "modulo a prime, in one variable",
    "polynomials/factors.py: certainly_square_free": "modulo a prime, in one variable",
    "polynomials/factors.py: factorize_square_free": "the door",
    "polynomials/factors.py: prime_factors": "integers, of a bounded number of bits",
    "polynomials/plane_pairs.py: Fibre.__init__": "over the field of a place: Euclid's algorithm, bounded",
    "polynomials/over_root.py: _inverse": "a step of Euclid's algorithm, whose cost is bounded as a whole",
    "polynomials/over_root.py: OverRoot.radical": "over the field of a root: a door with an estimated cost",
    "polynomials/over_root.py: _divisor_modulo": "modulo a prime, in one variable",
    "bivariate/common_zeros.py: Column.of": "over the field of a root: a door with an estimated cost",
    "verification/generic_proof.py: bezout_combination": "modulo a prime, in one variable",
}


def test_every_costly_call_goes_through_a_bounded_door():
    """Passed before: a common divisor of polynomials in many variables that takes minutes and cannot be interrupted."""
    assert gates.found_in(gates.trees(), gates.unbounded_costs) == UNBOUNDED.keys()
    for name in ("gcd", "factor", "factor_squarefree", "resultant", "discriminant", "complex_roots"):
        assert planted(f"def f(p, q):\n    return p.{name}(q)", gates.unbounded_costs) == ["f"]
    assert planted("def f(ps):\n    return reduce(fmpz_poly.gcd, ps)", gates.unbounded_costs) == ["f"]


# ---- no error is hidden

CAUGHT = {
    "batch/sweep.py: _OneByOne.line": "one curve does not end a batch: the type of the error is its answer",
    "interchange/collector.py: Collector.skipping": "fontTools raises anything for a damaged outline; that is named",
    "interchange/formats/fonts.py: _opened": "the same for a damaged font",
    "interchange/formats/fonts.py: _requested": "the same for a damaged font",
    "cli/formula.py: _guarded": "code of the user may raise any error: its type and text are told",
    "papers/loading.py: run_file": "the same, with the line",
}


def test_no_exception_is_caught_whole():
    """Passed before: a mistake of ours between question and answer that is told as bad data."""
    assert gates.found_in(gates.trees(), gates.caught_whole) == CAUGHT.keys()
    for caught in ("except Exception", "except (ValueError, BaseException) as error", "except"):
        assert planted(f"def f(x):\n    try:\n        x()\n    {caught}:\n        pass", gates.caught_whole) == ["f"]
    assert planted("def f(x):\n    with suppress(Exception):\n        x()", gates.caught_whole) == ["f"]
    assert not planted("def f(x):\n    try:\n        x()\n    except ValueError:\n        pass", gates.caught_whole)


def test_no_cast_needs_a_name_that_only_the_type_checker_has():
    """Passed before, also by mypy: a `NameError` where the cast is run."""
    assert not gates.found_in(gates.trees(), gates.casts_without_a_type)
    code = "if TYPE_CHECKING:\n    from a import A\n\ndef f(x):\n    return cast({}, x)"
    assert [planted(code.format(name), gates.casts_without_a_type) for name in ("A", "'A'", "B")] == [["f"], [], []]


# ---- law 7: what only developers run is not in the wheel

BY_NAME = {
    "testing": "imported by those who test programs",
    "testing.families": "the same",
    "testing.plugin": "a plugin of pytest",
    "testing.strategies": "imported by those who test programs",
}


def test_what_only_developers_run_is_not_in_the_wheel():
    graph = import_graph.module_graph()
    papers = [name for name in graph if name.startswith(("papers.", "formulas."))]  # with formulas of their tables
    commands = [entry.home.partition(":")[0] for entry in leaves().values()]
    trees = import_graph.trees()
    rows = {name for table in import_graph.TABLES for name in import_graph.named(trees[table], set(trees))}
    displays = [name for name in graph if name.startswith("extras.") and name.endswith(".display")]
    entrances = ["", "__main__", *papers, *commands, *rows, *displays]
    assert graph.keys() - gates.reached(graph, entrances) == BY_NAME.keys()


def test_a_module_that_only_tests_import_is_found():
    graph = {"": {"a"}, "a": {"b.c"}, "b": set(), "b.c": set(), "only_for_tests": {"a"}}
    assert graph.keys() - gates.reached(graph, [""]) == {"only_for_tests"}


# ---- what is served on this machine is seen on this machine alone


@pytest.mark.skipif(not (CHECKOUT / "run").exists(), reason="the pages are served from a checkout")
def test_a_server_that_is_started_or_recommended_listens_on_this_machine_alone():
    """Passed before: that which the builder of the site recommends for another folder listened on all interfaces."""
    files = [CHECKOUT / "run", *CHECKOUT.glob("*.md"), *(CHECKOUT / "docs").rglob("*.md")]
    files += [file for room in ("docs", "exactspline", "workshop") for file in (CHECKOUT / room).rglob("*.py")]
    lines = [line for file in files for line in file.read_text(encoding="utf-8").splitlines()]
    serving = [line for line in lines if "-m http.server" in line]
    assert len(serving) >= 2
    assert [line for line in serving if "--bind 127.0.0.1" not in line] == []
