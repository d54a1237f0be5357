"""What the command line says around its tables: schemas, glossary, nearest names, pages, numbers, habits."""

import csv
import json
import re
import shlex
from enum import StrEnum
from functools import cache
from importlib import import_module
from importlib.metadata import version
from pkgutil import walk_packages

import jsonschema
import pytest

import exactspline
from exactspline import Verdict, example, examples
from exactspline.display.sheet import code_lines
from exactspline.programs import accelerator
from tests.support.command import invoke, leaves, run, schema_of
from tests.verification.test_own_paper import plane_formulas, written

WORDS = [*Verdict]


@cache
def whole_ledger():
    return invoke("prove").stdout


#: Commands with documents in JSON, by the names of their schemas.
DOCUMENTS = {
    "between": "between circle ellipse --json",
    "prove": "prove --claim C4.1 --json",
    "show": "show C4.2b --json",
    "claims": "show --json",
    "errata": "errata --json",
    "degrees": "formula degrees --curve straight_between_arcs --json",
    "generic": "formula degrees --generic --json",
    "degrees at": "formula degrees --at 3 --json",
    "patch degrees": "formula degrees --paper surfaces --patch 1,2 parabolic L --json",
    "formula degrees": "formula degrees --paper lifted --generic evolute_lifted --json",
    "identity": 'identity "f1 = w f2" --json',
    "certificates": "formula degrees --certify --curve circle",
    "reduce": "formula reduce rectifying_developable --json",
    "derivable": "list formulas --json",
    "inspect": "inspect six_segment_cubic planar_in_space --json",
    "inspect surface": "inspect monkey_saddle folded_map --json",
    "bisector": "bisector ellipse --point=-1,1/3 --json",
    "conditioning": "formula conditioning ellipse_skew --json",
    "curves": "list curves --json",
    "surfaces": "list surfaces --json",
    "papers": "list papers --json",
    "glossary": "list words --json",
    "answers": "inspect cubic_s --ask inflections --ask length --certificates --json",
    "questions": "list questions --json",
    "topics": "teach exercise --json",
    "exercise": "teach exercise all --solutions --json",
    "check-answer": "teach check cubic_s --reference cubic_s --json",
    "triangle": "teach triangle rational_cubic --at 1/3 --insert 1/2 --elevate 2 --product x,w --json",
    "sweep": "sweep six_segment_cubic planar_in_space --json",
}


@pytest.mark.parametrize("name", DOCUMENTS)
def test_json_follows_its_schema_and_every_row_has_a_key_of_its_own(name):
    result = invoke(*shlex.split(DOCUMENTS[name]))
    assert result.exit_code == 0
    data = json.loads(result.stdout)
    jsonschema.validate(data, schema_of(name))
    keys = [row["key"] for row in data["rows"]]
    assert keys
    assert len(keys) == len(set(keys))


def test_every_schema_is_published():
    listed = json.loads(invoke("schema").stdout)["schemas"]
    assert {*DOCUMENTS, "figures", "convert", "convert surface", "sweep_line"} == {*listed}
    assert json.loads(invoke("schema", "sweep_line").stdout)["title"] == "exactspline/sweep_line, version 7"
    assert json.loads(invoke("schema", "prove").stdout)["title"] == "exactspline/prove, version 3"


def test_keys_of_the_whole_ledger_on_one_curve_are_unique():
    rows = json.loads(invoke("prove", "--curve", "planar_in_space", "--json").stdout)["rows"]
    assert len({row["key"] for row in rows}) == len(rows) > 50
    assert {row["verdict"] for row in rows} <= set(WORDS)


@cache
def terms():
    """The words of the glossary."""
    return {row["key"] for row in json.loads(invoke("list", "words", "--json").stdout)["rows"]}


@pytest.mark.parametrize("term", [*WORDS, "nominal", "true", "minimal", "lifted", "k", "m", "j", "X", "P", "γ"])
def test_the_glossary_has_every_word_of_the_tables(term):
    assert invoke("list", "words", term).stdout.startswith(f"{term}: ")


@cache
def kinds():
    """Everything that is said of features, joints, patches, pieces: enumerations of words in the rooms of geometry."""
    for room in ("bivariate", "geometry"):
        for module in walk_packages([f"{exactspline.__path__[0]}/{room}"], f"exactspline.{room}."):
            import_module(module.name)
    return [
        each
        for each in StrEnum.__subclasses__()
        if each.__name__ in ("Gap", "Shape", "Solutions")
        or (each.__name__.endswith("Kind") and each.__module__.startswith("exactspline.geometry"))
    ]


#: Curves, surfaces and bisectors whose tables have many kinds of rows.
TABLES = [
    *(["inspect", name] for name in (*examples("curves"), "torus", "sphere", "monkey_saddle", "bicubic", "folded_map")),
    ["bisector", "cubic_s", "--point", "7/4,3/2"],
    ["bisector", "twisted_cubic", "--point", "1,0,1"],
    ["bisector", "twisted_cubic", "space_line"],
    ["inspect", "straight_between_arcs", "--ask", "joints", "--ask", "straight_pieces", "--ask", "cusps"],
]


def test_every_kind_of_thing_is_in_the_glossary():
    assert [str(each) for kind in kinds() for each in kind if not begins_with_a_term(str(each))] == []


@pytest.mark.parametrize("asked", TABLES, ids=" ".join)
def test_every_row_and_remark_begins_with_a_word_of_the_glossary(asked):
    """Before: "stationary", "singular end", "straight", "closed", "G3" were printed and explained nowhere."""
    rows = list(csv.DictReader(invoke(*asked, "--csv").stdout.splitlines()))
    said = {row.get("what") or row.get("piece") or "nothing" for row in rows}
    said |= {part for row in rows for part in re.split(", ", row.get("remark") or "") if part[:1].islower()}
    assert [each for each in said if not begins_with_a_term(each)] == []


def begins_with_a_term(text):
    return any(text == term or text.startswith((f"{term} ", f"{term}:")) for term in terms())


@pytest.mark.parametrize(
    ("arguments", "near"),
    [
        (["show", "C4.2z"], "C4.2"),
        (["prove", "--claim", "C4.2z"], "C4.2"),
        (["errata", "spann"], "span"),
        (["derive", "evolut", "circle"], "evolute"),
        (["formula", "reduce", "g22"], "g2"),
        (["inspect", "elipse"], "ellipse"),
        (["formula", "conditioning", "circle", "--construction", "zero_curvatur"], "zero_curvature"),
        (["prove", "--verdict", "vacous"], "VACUOUS"),
        (["list", "words", "nominl"], "nominal"),
        (["schema", "proof"], "prove"),
    ],
)
def test_an_unknown_name_gets_the_nearest_ones(arguments, near):
    result = invoke(*arguments)
    told = str(result.exception) + result.stderr
    assert "the nearest are" in told
    assert near in told
    assert len(told) < 250


def test_help_shows_examples_and_exit_statuses():
    for name in leaves():
        told = invoke(*name.split(), "--help").stdout
        assert "Exit status: 0 success" in told
        assert f"  exactspline {name}" in told
    assert "..." not in invoke("--help").stdout.split("Commands:")[1]
    assert "[default: 12" in invoke("inspect", "--help").stdout


def test_version():
    assert invoke("--version").stdout == f"exactspline {version('exactspline')}\n"


def test_all_versions_are_those_of_what_is_installed_and_no_library_of_developers():
    shown = dict(line.rsplit(" ", 1) for line in invoke("--versions").stdout.splitlines()[:-1])
    assert shown.items() >= {name: version(name) for name in ("exactspline", "python-flint", "gmpy2", "sympy")}.items()
    assert shown.keys() & {"mypy", "ruff", "pytest", "hypothesis"} == set()
    last = "runs" if accelerator.filter_curve is not None else "none, answers are the same"
    assert invoke("--versions").stdout.endswith(f"compiled filter: {last}\n")


def test_a_curve_on_standard_input():
    text = exactspline.interchange.text(example("ellipse_skew"))
    rows = json.loads(invoke("inspect", "-", "--json", input=text).stdout)["rows"]
    assert len(rows[0]["critical_points"]["points"]) == 4
    assert "standard input" in str(invoke("derive", "evolute", "-", input="{}").exception)


def test_quiet_leaves_the_legend_out():
    asked = "formula", "degrees", "rectifying_developable", "--generic"
    loud, quiet = invoke(*asked).stdout, invoke(*asked, "--quiet").stdout
    assert loud.startswith(quiet)
    assert "nominal" not in quiet


def test_an_equation_is_found_by_its_number():
    told = " ".join(invoke("show", "eq. (12)").stdout.split())
    assert "1/κ, with its sign, is ‖γ′‖³ / [γ′ γ″]" in told
    assert "REFUTED" in told
    assert "(8)" not in told


def test_a_researcher_finds_an_answer_by_its_words():
    assert "the rectifying developable" in invoke("show", "rectifying developable").stdout
    table = invoke("formula", "degrees", "rectifying_developable", "--generic", "--csv").stdout.splitlines()
    assert len(table) == 3
    assert all("rectifying developable" in line for line in table[1:])
    assert "10d − 18" in table[1]
    own = json.loads(invoke("formula", "degrees", "evolute", "--curve", "ellipse_skew", "--json").stdout)["rows"]
    assert {row["formula"] for row in own} == {"evolute"}
    assert {row["variant"]: row["true"] for row in own}["minimal"] == 6
    assert "the nearest are" in str(invoke("formula", "degrees", "evolvent", "--curve", "circle").exception)


def test_options_that_contradict_each_other_are_bad_input():
    assert "--json and --csv" in str(invoke("list", "curves", "--json", "--csv").exception)
    assert "--judge and --curve" in str(invoke("prove", "--judge", "sympy", "--curve", "circle").exception)


def test_nothing_that_vanishes_or_does_not_exist_has_a_degree():
    rows = invoke("formula", "degrees", "--curve", "straight_line", "--csv").stdout.splitlines()[1:]
    assert not any(re.search(r",-\d", row) for row in rows)
    assert sum("zero" in row for row in rows) > 5
    evolutes = [row for row in rows if row.startswith("straight_line,evolute,")]
    assert all(row.split(",")[-2] != "0" for row in evolutes)
    assert any("straight" in row.split(",", 3)[3] for row in evolutes)


def test_identities_are_printed_as_equations():
    told = invoke("prove", "--claim", "C4.2b").stdout
    assert told.count("g1 = w⁸ · g0") == 2
    assert "computed" not in told


def test_prove_answers_first():
    first = invoke("prove", "--section", "4.2", "--verdict", "refuted").stdout
    assert "REFUTED  C4.2b" in first
    assert "PROVED" not in first.split("\n\n")[0]
    whole = whole_ledger()
    assert re.match(r"\d+ statements of the paper refuted \(\d+ errors, \d+ rows\); \d+ hold", whole)
    assert "true: g1 = w⁸ g0" in whole
    assert len(whole.splitlines()) < 300


def test_long_fractions_are_decimals_and_stand_in_full_on_demand(tmp_path):
    at = {"statement": "said", "kind": "at", "curve": "plane", "formula": "second", "example": "cubic_s", "claimed": 7}
    entries = [{"id": str(i), **at, "parameter": t} for i, t in enumerate(("1/3", "12345/67891"))]
    folder = written(tmp_path / "p", plane_formulas(second="c.p[1] / c.w"), entries)
    short, long = (example("cubic_s")(each["parameter"])[1] for each in entries)
    told, full = (
        invoke("prove", "--paper", folder, "--rows", *more, env={"COLUMNS": "200"}).stdout for more in ([], ["--exact"])
    )
    assert str(short) in told
    assert str(short) in full
    assert f"it is ≈ {float(long):.6g}" in told
    assert f"it is {long}" not in told
    assert f"it is {long}" in full


def test_the_page_has_every_row_and_asks_nothing_of_the_network(tmp_path):
    file, asked = tmp_path / "ledger.html", ("prove", "--claim", "C4.1", "--claim", "C4.2b", "--curve", "circle")
    assert invoke(*asked, "--html", file).exit_code == 0
    text = file.read_text(encoding="utf-8")
    assert text.count("<tr data-verdict=") == len(json.loads(invoke(*asked, "--json").stdout)["rows"])
    assert not re.search(r"https?:|src=|@import|<link", text)
    assert {"verdict", "section", "curve"} <= set(re.findall(r'<select name="(\w+)"', text))
    assert "f1 = w · f2" in text


@pytest.mark.parametrize("width", [24, 40, 60])
def test_code_is_broken_where_it_stays_code(width):
    line = 'found = [x for x in ("a long text that is broken too", 2 + 3, {"k": max(4, 5)}["k"])]'
    parts = code_lines(line, width)
    assert all(len(part) <= width for part in parts)
    names = {}
    exec("\n".join(parts), names)
    assert names["found"] == ["a long text that is broken too", 5, 5]


@pytest.mark.parametrize("place", ["5.4", "§5.4", "C5.4", "C5.4a", "p. 15"])
def test_errors_are_found_by_their_place(place):
    told = invoke("errata", place, "-q").stdout
    assert "λ is ζ divided by ‖γ′‖" in told
    assert "1 error of the paper, 1 statement refuted" in told


def test_where_nothing_is_wrong_it_is_said():
    told = invoke("errata", "4.1")
    assert told.exit_code != 0
    assert "nothing at '4.1' is refuted" in str(told.exception)


def test_prove_and_errata_count_alike():
    head, end = whole_ledger().splitlines()[0], invoke("errata", "-q").stdout.splitlines()[-1]
    statements, errors = re.match(r"(\d+) statements of the paper refuted \((\d+) errors", head).groups()
    assert end == f"{errors} errors of the paper, {statements} statements refuted"


def test_the_theorem_that_errata_names_can_be_printed():
    """Before, "no claim has the id …" for every paper but the default one."""
    words = run("errata", "--paper", "primer_on_bezier_curves").stdout.split("a theorem to cite: ", 1)[1]
    arguments = " ".join(words.split("(", 1)[0].split("\n\n")[0].split()).split()[1:]
    shown = run(*arguments)
    assert (arguments[0], shown.returncode) == ("show", 0)
    assert r"--paper primer\_on\_bezier\_curves" in shown.stdout


def test_names_of_files_do_not_steer_the_terminal(tmp_path):
    """Before, notes on standard error held the escape sequences of names as they are: this one renames the window; and
    a name with `<svg ` in it made the file one of SVG.
    """
    curve = {"degree": 1, "knots": [0, 0, 1, 1], "control_points": [["0", "0"], ["1", "2"]]}
    names = {"name": "\x1b[31mred<svg b", "source": "\x1b]0;owned\x07\nnote: forged"}
    file = tmp_path / "a.json"
    file.write_text(json.dumps({"curves": [curve | names, curve | {"name": "b"}]}), encoding="ascii")
    done = run("inspect", file)
    assert done.returncode == 0
    assert "\\x1b]0;owned\\x07\\nnote: forged" in done.stderr
    assert not {"\x1b", "\x07"} & {*done.stdout, *done.stderr}


def test_an_interrupted_command_ends_as_shells_expect(monkeypatch):
    """Before, with exit status 1, which says that a verdict differs from the record."""

    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr("exactspline.cli.inspect.each_read", interrupted)
    done = run("inspect", "circle")
    assert (done.returncode, done.stderr.split()) == (130, ["interrupted"])
