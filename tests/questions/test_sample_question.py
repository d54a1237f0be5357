"""A new question is one entry: added to one file of a copy of the package, it is asked wherever questions are."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import exactspline
from exactspline.questions.entry import Of
from tests.support.changes import CHANGES

NAME = "sideways_extrema"
ENTRY = f'''
    @question(*CURVES, proof=lambda facts: (slope_zeros(facts.curve, 0),))
    def {NAME}(self) -> Places[Feature]:
        """The extrema of the first coordinate."""
        return self.turning_points(0)

    @property
    def flatness(self)'''
ASKED = '''
import json
from click.testing import CliRunner
import exactspline as xs
from exactspline.geometry.analysis.ask import asked_of
from exactspline.cli import app
from tests.support.command import schema_of
from exactspline.display.features import feature_sheet
from exactspline.display.console import glossary
from exactspline.geometry.analysis.inspection import inspect_curve

def told(*arguments):
    """What a command prints."""
    done = CliRunner().invoke(app, list(arguments))
    assert done.exit_code == 0, done.output
    return done.output

def row(*arguments):
    """The first row of what it prints as JSON."""
    return json.loads(told(*arguments, "--json"))["rows"][0]

circle = xs.example("circle")
sheet = feature_sheet(inspect_curve(circle))
fields = schema_of("inspect")["properties"]["rows"]["items"]["properties"]
print(json.dumps({
    "attribute": len(getattr(xs.analyse(circle), NAME)),
    "inspect": len(row("inspect", "circle")[NAME]["points"]),
    "table": sum(line[0] in ("maximum of κ", "minimum of κ") for line in sheet.rows),
    "inspect --ask": len(row("inspect", "circle", "--ask", NAME)["answer"]["points"]),
    "certificate": len([*asked_of(circle, NAME).proofs]),
    "as a place": len(xs.ask(circle, f"value@{NAME}")),
    "sweep --find": len(json.loads(told("sweep", "circle", "--find", NAME, "--output", "-"))["found"][NAME]),
    "schema": fields[NAME]["description"],
    "glossary": glossary()["questions"][NAME.replace("_", " ")],
    "list questions": NAME in told("list", "questions"),
    "list words": NAME.replace("_", " ") in told("list", "words"),
}))
'''


#: One of two curves, with a parameter; and the doors to it.
NAME_OF_TWO = "intersections_right_of"
PLACE_OF_TWO = "\n    @question(Of.TWO_CURVES, answered=Answered.PAIRS)\n    def distance(self)"
ENTRY_OF_TWO = f'''
    from exactspline.questions.takes import DISTANCE

    @question_with(DISTANCE, Of.TWO_CURVES, answered=Answered.PAIRS)
    def {NAME_OF_TWO}(self, x: Number) -> Intersections:
        """The common points whose first coordinate is larger than this."""
        found = self.intersections
        return Intersections(tuple(each for each in found if each.point[0] > x), undecided=found.undecided)
{PLACE_OF_TWO}'''
ASKED_OF_TWO = '''
import json
from random import Random
import exactspline as xs
from click.testing import CliRunner
from exactspline.cli import app
from tests.support.command import schema_of
from exactspline.display.console import glossary
from exactspline.geometry.analysis.pairs import CurvePair
from exactspline.interchange.files import write
from exactspline.questions.entry import Of
from exactspline.tables import to_dict, to_records
from tests.support.matrix import Counts, cells, compared, drawn, questions, without_transport
import jsonschema

def told(*arguments):
    """What a command prints."""
    done = CliRunner().invoke(app, list(arguments))
    assert done.exit_code == 0, done.output
    return done.output

def refused(question):
    """Why a question is not answered."""
    try:
        xs.ask((circle, line), question)
    except xs.ExactSplineError as error:
        return str(error)

def row(*arguments):
    """The first row of what it prints as JSON."""
    document = json.loads(told(*arguments, "--json"))
    jsonschema.validate(document, schema_of(document["schema"].split("/")[1]))
    return document["rows"][0]

circle, line = xs.example("circle"), xs.Nurbs(1, [0, 0, 1, 1], [(-2, 0), (2, 0)])
write(line, "line.json")
asked, of_one = f"{NAME}:1/2", f"{NAME}:line.json,1/2"
counts = Counts()
for seed in range(5):
    random = Random(seed)
    pair, letters = drawn(Of.TWO_CURVES, random, "exchanged")
    (entry,) = [each for each in questions(Of.TWO_CURVES) if each.name == NAME]
    compared(pair, entry, letters[:1], random, counts)
print(json.dumps({
    "attribute": len(getattr(CurvePair(circle, line), NAME)("1/2")),
    "xs.ask": len(xs.ask((circle, line), asked)),
    "of one curve": len(xs.ask(circle, of_one)),
    "between --ask": len(row("between", "circle", "line.json", "--ask", asked)["answer"]["points"]),
    "inspect --ask": len(row("inspect", "circle", "--ask", of_one)["answer"]["points"]),
    "table": told("between", "circle", "line.json", "--ask", asked, "--csv").count("crossing,first,"),
    "data": len(to_dict((circle, line), asked)["answer"]["points"]),
    "records": len(to_records((circle, line), asked)),
    "none": len(row("between", "circle", "line.json", "--ask", f"{NAME}:1")["answer"]["points"]),
    "surplus": refused(NAME),
    "report": NAME in row("between", "circle", "line.json"),
    "glossary": glossary()["questions"][NAME.replace("_", " ")],
    "list questions": [form in told("list", "questions") for form in (f"{NAME}:1/10", f"{NAME}:CURVE,1/10")],
    "list words": NAME.replace("_", " ") in told("list", "words"),
    "cells": len([cell for cell in cells() if cell[1] == NAME]),
    "without transport": without_transport(),
    "matrix": [counts.asked, list(map(str, counts.failures))],
}))
'''


PLACES = {"curves.py": ("\n    @property\n    def flatness(self)", ENTRY), "pairs.py": (PLACE_OF_TWO, ENTRY_OF_TWO)}


@pytest.fixture(scope="module")
def answers_of_both(tmp_path_factory):
    """What scripts say in a copy of the package with both entries: of the question of a curve, and of two curves."""
    folder = tmp_path_factory.mktemp("copy")
    shutil.copytree(Path(exactspline.__file__).parent, folder / "exactspline")
    for name, (place, entry) in PLACES.items():
        file = folder / "exactspline" / "geometry" / "analysis" / name
        code = file.read_text(encoding="utf-8")
        assert code.count(place) == 1
        file.write_text(code.replace(place, entry), encoding="utf-8")
    scripts = f"NAME = {NAME!r}\n{ASKED}\nNAME = {NAME_OF_TWO!r}\n{ASKED_OF_TWO}"
    command = [sys.executable, "-c", scripts]
    path = os.pathsep.join([str(folder), str(Path(__file__).parents[2])])
    environment = {**os.environ, "PYTHONPATH": path, "PYTHONDONTWRITEBYTECODE": "1"}
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=folder, env=environment)
    assert done.returncode == 0, done.stderr
    return [json.loads(line) for line in done.stdout.splitlines()]


def test_an_entry_is_asked_wherever_questions_are(answers_of_both):
    """It would fail if a command, the schema or the glossary had a list of questions of its own."""
    answers, _ = answers_of_both
    counted = ("attribute", "inspect", "inspect --ask", "as a place", "sweep --find", "table")
    assert {name: answers[name] for name in counted} == dict.fromkeys(counted, 2)
    assert answers["certificate"] == 1
    assert answers["schema"] == answers["glossary"] == "the extrema of the first coordinate"
    assert answers["list questions"]
    assert answers["list words"]


def test_a_question_of_two_curves_is_asked_wherever_questions_are(answers_of_both):
    """One entry in one file: no door has a list of its own."""
    _, found = answers_of_both
    counted = ("attribute", "xs.ask", "of one curve", "between --ask", "inspect --ask", "table", "data", "records")
    assert {name: found[name] for name in counted} == dict.fromkeys(counted, 1)
    assert found["none"] == 0
    assert "write it like 'intersections_right_of:1/10'" in found["surplus"]
    assert not found["report"]
    assert found["glossary"] == "the common points whose first coordinate is larger than this"
    assert found["list questions"] == [True, True]
    assert found["list words"]


def test_a_question_of_two_curves_is_in_the_matrix(answers_of_both):
    _, found = answers_of_both
    assert found["cells"] == len(CHANGES[Of.TWO_CURVES])
    assert found["without transport"] == []
    assert found["matrix"] == [5, []]


def test_without_the_entry_nothing_of_it_is_there():
    folder = Path(exactspline.__file__).parent
    texts = [file.read_text(encoding="utf-8") for file in folder.rglob("*.py")]
    assert not any(name in text for name in (NAME, NAME_OF_TWO) for text in texts)
