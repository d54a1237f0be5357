"""One registry: what can be asked of a curve is an entry, and every list of questions is made from the entries."""

import doctest
import json

import jsonschema
import pytest

import exactspline as xs
from exactspline import analyse
from exactspline.batch.inspections import LISTED, asked_by_sweeps, checked_names, inspected
from exactspline.errors import ReachError, ShapeError
from exactspline.geometry.analysis import curves as analysis
from exactspline.geometry.analysis import surfaces as inspection
from exactspline.geometry.analysis.ask import REGISTRY, questions
from exactspline.geometry.analysis.curves import QUESTIONS, Analysis, questions_about
from exactspline.questions import takes
from exactspline.questions.entry import ALL_CURVES, CURVES, Of, question, question_with, questions_of
from exactspline.roots.answers import CurvePiece, Places
from tests.support.command import invoke, schema_of
from workshop.vectors.items import items

LINE = xs.Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 1)])
SPACE_LINE = xs.Nurbs(1, [0, 0, 1, 1], [(0, 0, 0), (1, 1, 1)])
FLAT = [[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]]
STILL = xs.Nurbs(1, [0, 0, 1, 1], [(1, 1), (1, 1)])


ALL = [(of, name) for of, entries in REGISTRY.items() for name in entries]


def test_every_entry_says_what_is_asked():
    assert set(QUESTIONS) == {name for of in ALL_CURVES for name in REGISTRY[of]}
    for of, name in ALL:
        entry = REGISTRY[of][name]
        assert entry.name == name
        assert of in entry.about.of
        assert entry.meaning.strip()
        assert not entry.meaning.endswith(".")
        assert entry.about.part_of in ("", *REGISTRY[of])


def fields_of_curves():
    """The fields of an inspected curve, as they are published now."""
    return json.loads(invoke("schema", "inspect").stdout)["properties"]["rows"]["items"]["properties"]


def glossary():
    """The words of the glossary with their meanings."""
    return json.loads(invoke("list", "words", "--json").stdout)["rows"]


#: Each entry once, though it is one of several kinds of object.
ONCE = {id(REGISTRY[of][name]): (of, name) for of, name in ALL}.values()


@pytest.mark.parametrize(("of", "name"), ONCE)
def test_the_example_of_an_entry_runs(of, name):
    """pytest looks for examples in functions and classes alone."""
    names = {"analyse": analyse, "mpq": xs.rational("1/2").__class__}
    text = REGISTRY[of][name].__doc__
    assert of in CURVES or ">>>" in text
    example = doctest.DocTestParser().get_doctest(text, {**vars(analysis), **names}, name, name, 0)
    assert doctest.DocTestRunner(verbose=False).run(example).failed == 0


@pytest.mark.parametrize(("of", "names"), [(Of.SURFACE, ("torus", "sphere")), (Of.PLANAR_MAP, ("folded_map",))])
def test_of_surfaces_every_question_of_the_registry_is_answered(of, names):
    """Passed before: a question about surfaces that the schema or the glossary does not have."""
    for name in names:
        document = json.loads(invoke("inspect", name, "--json").output)
        jsonschema.validate(document, schema_of("inspect surface"))
        assert {name for name, entry in REGISTRY[of].items() if entry.about.reported} <= set(document["rows"][0])
    assert {entry.meaning for entry in REGISTRY[of].values()} <= {row["meaning"] for row in glossary()}


def test_of_a_pair_every_question_of_the_registry_is_answered():
    document = json.loads(invoke("bisector", "space_line", "twisted_cubic", "--json").output)
    jsonschema.validate(document, schema_of("bisector"))
    assert set(REGISTRY[Of.PAIR]) <= set(document["rows"][0])


def test_of_a_sphere_every_point_is_an_umbilic_and_of_a_plane_parabolic():
    """Passed before: a sphere, a torus and a surface whose umbilics were not found had the same answer."""
    sphere, torus = (xs.analyse(xs.example(name)) for name in ("sphere", "torus"))
    assert len(sphere.umbilics.everywhere) == len(sphere.patches)
    assert not torus.umbilics
    flat = xs.analyse(xs.NurbsSurface((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], FLAT))
    assert str(flat.parabolic_points) == str(flat.umbilics) == "everywhere on [0, 1] × [0, 1]"
    assert flat.singular_points == type(flat.singular_points)(())


def test_what_is_undecided_is_not_nowhere(monkeypatch):
    """Passed before: no umbilics and no singular points on a patch that was out of reach."""

    def out_of_reach(forms, patch):
        raise ReachError("too long")

    monkeypatch.setattr(inspection, "inspect_patch", out_of_reach)
    found = xs.analyse(xs.example("paraboloid"))
    assert not found.complete
    for answer in (found.umbilics, found.parabolic_points, found.singular_points):
        assert answer.undecided
        assert answer
        assert not answer.points


def test_zeros_of_a_folded_map_are_curves():
    """Passed before: they were undecided."""
    found = xs.analyse(xs.example("folded_map"))
    assert found.complete
    assert found.zero_curves or found.zero_lines


def test_every_list_of_questions_is_that_of_the_registry():
    listed = {(of, each.name) for each in questions() for of in each.of}
    assert set(ALL) <= listed
    of_one = {(of, name) for of in CURVES for name in REGISTRY[Of.TWO_CURVES] if name not in REGISTRY[of]}
    assert listed - set(ALL) == of_one
    # one whose name has another meaning too is named with what it is asked of
    named = {term.split(" of a ")[0] for term in (row["key"] for row in glossary())}
    assert {name.replace("_", " ") for name in QUESTIONS} <= named
    assert {name for of in CURVES for name, entry in REGISTRY[of].items() if entry.about.reported} <= set(
        fields_of_curves()
    )
    for name in ("circle", "twisted_cubic"):
        row = json.loads(invoke("inspect", name, "--json").output)["rows"][0]
        expected = {n for n, q in questions_about(xs.example(name)).items() if q.about.reported}
        assert expected <= set(row)
    assert set(asked_by_sweeps()) == {n for n, q in QUESTIONS.items() if q.about.answered in LISTED}
    abouts = {name: entry.about for name, entry in asked_by_sweeps().items()}
    assert checked_names(["all"]) == tuple(n for n, a in abouts.items() if not (a.takes or a.on_request))


def test_a_question_that_stands_nowhere_else_is_asked_everywhere(monkeypatch):
    """An entry added to the class is in all lists at once."""

    class Added(Analysis):
        @question(*CURVES)
        def left_half(self) -> Places[CurvePiece]:
            """The left half of the curve."""
            a, b = self.curve.domain
            return Places((), (xs_piece(a, (a + b) / 2),))

        @question_with(takes.Takes("1/2", lambda part, facts: xs.rational(part)), *CURVES)
        def beginning(self, part) -> Places[CurvePiece]:
            """The beginning of the curve, up to this part of it."""
            a, b = self.curve.domain
            return Places((), (xs_piece(a, a + part * (b - a)),))

    def xs_piece(a, b):
        return CurvePiece(((a, b),))

    assert set(questions_of(Added)) - set(QUESTIONS) == {"left_half", "beginning"}
    monkeypatch.setattr(analysis, "Analysis", Added)
    for name, entry in questions_of(Added).items():
        monkeypatch.setitem(QUESTIONS, name, entry)
        for of in CURVES:
            monkeypatch.setitem(REGISTRY[of], name, entry)
    curve = xs.Nurbs(1, [0, 0, 2, 2], [(0, 0), (1, 1)])
    assert inspected(curve, checked_names(["left_half"]), 5)["left_half"][0].high == "1"
    assert inspected(curve, checked_names(["beginning:1/4"]), 5)["beginning:1/4"][0].high == "1/2"
    assert "left_half" in questions_about(curve)
    assert fields_of_curves()["left_half"]["description"] == "the left half of the curve"
    assert str(analyse(curve).beginning("1/2")) == "everywhere on [0, 1]"


@pytest.mark.parametrize(
    ("curve", "asked", "where"),
    [
        (LINE, "inflections", "[0, 1]"),
        (LINE, "critical_points", "[0, 1]"),
        (SPACE_LINE, "inflections", "[0, 1]"),
        (xs.example("circle"), "curvature_extrema", "[0, 4]"),
        (xs.example("planar_in_space"), "torsion_zeros", None),
        (STILL, "singular_points", "[0, 1]"),
    ],
)
def test_none_and_all_are_two_answers(curve, asked, where):
    """False before: a line has no inflections, a circle no extrema, a point that stands still no singular points."""
    found = getattr(analyse(curve), asked)
    assert found
    assert where is None or [str(piece) for piece in found.everywhere] == [where]
    told = [item.what for item in items(curve, asked)]
    assert "everywhere" in told
    listed = [each.kind for each in inspected(curve, [asked], 5)[asked]]
    assert "everywhere" in listed


def test_none_is_none():
    assert not analyse(xs.example("ellipse")).inflections
    assert items(xs.example("ellipse"), "inflections") == ()
    assert inspected(xs.example("ellipse"), ["inflections"], 5) == {"inflections": ()}


def test_a_question_about_another_kind_of_curve_is_refused():
    with pytest.raises(ShapeError):
        analyse(xs.example("circle")).torsion_zeros  # noqa: B018
    with pytest.raises(xs.ExactSplineError, match="space curve"):
        xs.ask(xs.example("circle"), "torsion_zeros")


def test_answers_say_of_which_curve_they_are(tmp_path):
    """Before: curves of one name had one key, and no answer said from which file it came."""
    curve = {"name": "icon", "degree": 1, "knots": [0, 0, 1, 1], "control_points": [[0, 0], [1, 1]]}
    files = []
    for name in ("a.json", "b.json"):
        other = curve | {"control_points": [[0, 0], [2 if name == "a.json" else 3, 1]]}
        (tmp_path / name).write_text(json.dumps({"curves": [curve, other]}))
        files.append(str(tmp_path / name))
    for command in (["inspect", *files, "--ask", "bounding_box"], ["inspect", *files]):
        rows = json.loads(invoke(*command, "--json").stdout)["rows"]
        assert len({row["key"] for row in rows}) == 4
        assert [(row["source"], row["index"]) for row in rows] == [(file, i) for file in files for i in (0, 1)]
        assert rows[0]["digest"] == rows[2]["digest"]
        assert len({row["digest"] for row in rows}) == 3
