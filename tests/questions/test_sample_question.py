"""A new question is one entry: added to one file of a copy of the package, it is asked wherever questions are."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import exactspline

NAME = "sideways_extrema"
ENTRY = f'''
    @question(*CURVES, proof=lambda facts: (slope_zeros(facts.curve, 0),))
    def {NAME}(self) -> Places[Feature]:
        """The extrema of the first coordinate."""
        return turning_points(self.curve, 0)

    @property
    def flatness(self)'''
ASKED = '''
import json
from click.testing import CliRunner
import exactspline as xs
from exactspline.geometry.analysis.ask import asked_of
from exactspline.cli import app
from exactspline.cli.schema import schema_of
from exactspline.display.features import feature_sheet
from exactspline.display.glossary import glossary
from exactspline.geometry.analysis.inspection import Report, inspect_curve

def told(*arguments):
    """What a command prints."""
    done = CliRunner().invoke(app, list(arguments))
    assert done.exit_code == 0, done.output
    return done.output

def row(*arguments):
    """The first row of what it prints as JSON."""
    return json.loads(told(*arguments, "--json"))["rows"][0]

circle = xs.example("circle")
sheet = feature_sheet(Report(inspect_curve(circle)))
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


@pytest.fixture(scope="module")
def answers(tmp_path_factory):
    """What all who ask questions say in a copy of the package with the entry."""
    folder = tmp_path_factory.mktemp("copy")
    shutil.copytree(Path(exactspline.__file__).parent, folder / "exactspline")
    file = folder / "exactspline" / "geometry" / "analysis" / "curves.py"
    code = file.read_text(encoding="utf-8")
    assert code.count("\n    @property\n    def flatness(self)") == 1
    file.write_text(code.replace("\n    @property\n    def flatness(self)", ENTRY), encoding="utf-8")
    command = [sys.executable, "-c", f"NAME = {NAME!r}\n{ASKED}"]
    environment = {**os.environ, "PYTHONPATH": str(folder), "PYTHONDONTWRITEBYTECODE": "1"}
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=folder, env=environment)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def test_an_entry_is_asked_wherever_questions_are(answers):
    """It would fail if a command, the schema or the glossary had a list of questions of its own."""
    counted = ("attribute", "inspect", "inspect --ask", "as a place", "sweep --find", "table")
    assert {name: answers[name] for name in counted} == dict.fromkeys(counted, 2)
    assert answers["certificate"] == 1
    assert answers["schema"] == answers["glossary"] == "the extrema of the first coordinate"
    assert answers["list questions"]
    assert answers["list words"]


def test_without_the_entry_nothing_of_it_is_there():
    folder = Path(exactspline.__file__).parent
    assert not any(NAME in file.read_text(encoding="utf-8") for file in folder.rglob("*.py"))
