"""What strangers stumbled over at the command line: each told what is wrong, or given what they asked for."""

import json
import os
import re
import subprocess
import sys
from contextlib import suppress

import pytest
from gmpy2 import mpq
from mpmath import mp

from exactspline import example, read
from exactspline.errors import CurveFileError, DomainError, KnotError, NumberError
from exactspline.extras.teaching import de_boor_triangle, insertion_triangle
from exactspline.interchange import text
from exactspline.interchange.formats import formats
from exactspline.language import formula
from exactspline.papers import named_papers
from exactspline.readings import trace
from exactspline.verification.claims import claims_in, select
from tests.support.claims import one_verdict
from tests.support.command import invoke, leaves

JUNK = b"{\x00\x01\xffjunk"
OTHERS = sorted({suffix for known in formats() for suffix in known.suffixes} - {".json"})


@pytest.mark.parametrize("suffix", OTHERS)
def test_bytes_that_begin_with_a_brace_are_what_the_suffix_says(tmp_path, suffix):
    place = tmp_path / f"junk{suffix}"
    place.write_bytes(JUNK)
    refused = invoke("inspect", place)
    assert refused.exit_code != 0
    assert "JSON" not in f"{refused.exception}{refused.output}"
    with suppress(CurveFileError, NumberError):
        assert not read(place).curves


def test_one_curve_under_any_other_suffix_is_read(tmp_path):
    place = tmp_path / "curve.txt"
    place.write_text(text(example("circle")), encoding="utf-8")
    assert invoke("convert", place, tmp_path / "again.json").exit_code == 0
    assert read(tmp_path / "again.json").curve == example("circle")


def test_a_list_of_curves_is_read_by_commands(tmp_path):
    both = [json.loads(text(example(name))) for name in ("circle", "ellipse")]
    place = tmp_path / "list.json"
    place.write_text(json.dumps(both), encoding="utf-8")
    rows = json.loads(invoke("inspect", place, "--json").stdout)["rows"]
    assert [row["curve"] for row in rows] == ["circle", "ellipse"]


def test_claims_that_say_nothing_of_a_curve_say_why_and_print_no_table():
    told = invoke("prove", "--claim", "C4.1", "--curve", "twisted_cubic").stdout
    claims = select(["C4.1"])
    plane = sum(claim.curve == "plane" for claim in claims)
    assert f"{len(claims)} claims do not apply to this curve: {plane} of plane curves" in told
    assert "statement" not in told
    assert told.rstrip().endswith("no rows")


def test_the_decimals_of_irrational_answers_are_those_of_the_number():
    row = invoke("inspect", "ellipse", "--ask", "length", "--digits", "40").stdout
    shown = next(word for word in row.split() if word.startswith("9.68")).removesuffix("…")
    with mp.workdps(60):
        assert str(8 * mp.ellipe(mp.mpf(3) / 4)).startswith(shown[:-1])
        assert abs(8 * mp.ellipe(mp.mpf(3) / 4) - mp.mpf(shown)) < mp.mpf(10) ** -38
    assert len(shown) > 35


def test_long_numbers_are_told_as_decimals():
    with pytest.raises(DomainError) as caught:
        de_boor_triangle(example("circle"), mpq(10) ** 400)
    assert len(str(caught.value)) < 120
    assert "1e+400…" in str(caught.value)


def test_how_often_a_knot_can_be_inserted_is_told():
    with pytest.raises(KnotError, match=r"1/2 of multiplicity 0 inserted 9 times.* may reach the degree 2"):
        insertion_triangle(example("circle"), "1/2", 9)


def test_help_names_arguments_without_the_types_of_python():
    for command in leaves():
        told = invoke(*command.split(), "--help").stdout
        usage = told.splitlines()[0]
        assert "[[" not in usage
        assert "...]" not in usage
        assert "<" not in told.partition("Options:")[0]
        assert usage.split("[OPTIONS]")[1] == usage.split("[OPTIONS]")[1].upper()


def test_help_names_the_command_as_it_was_called_and_fits_80_columns():
    """Passed before: `see exactspline schema` in the help of `./run inspect`, an example of 85 columns."""
    code = """
from click.testing import CliRunner
from exactspline.cli import app
from exactspline.cli.commands import leaves
for command in ("", *leaves()):
    print(CliRunner().invoke(app, [*command.split(), "--help"], prog_name="./run", terminal_width=80).stdout)
"""
    called = os.environ | {"EXACTSPLINE_COMMAND": "./run"}
    texts = subprocess.run([sys.executable, "-c", code], env=called, capture_output=True, text=True, check=True).stdout
    assert texts.count("Usage: ./run") == len(leaves()) + 1
    assert not re.findall(r".*exactspline [a-z].*", texts)
    assert [line for line in texts.splitlines() if len(line) > 80] == []


@pytest.mark.parametrize(
    ("command", "said"),
    [("sweep", "130 interrupted"), ("teach check", "1 the answer is not right"), ("inspect", "0 success; 2 bad input")],
)
def test_help_says_what_the_exit_statuses_of_a_command_mean(command, said):
    told = " ".join(invoke(*command.split(), "--help").stdout.split())
    assert said in told
    assert ("1 a verdict" in told) == (command == "sweep")


def test_open_slices_are_printed():
    def shown(index):
        return repr(trace(formula("here")(lambda c: c.p[index]), 3))

    slices = [slice(1, None), slice(None, 2), slice(None), slice(None, -1), slice(0, 3, 2)]
    assert [shown(each) for each in slices] == ["p[1…]", "p[0…1]", "p[0…]", "p[:-1]", "p[0:3:2]"]


def test_sums_without_a_symbol_are_in_parentheses_where_they_are_factors():
    claims = claims_in(named_papers(["primer_on_bezier_curves"]))
    factors = [str(one_verdict(claim).factor) for claim in claims if claim.key.startswith(("PB5e-cusp_edge", "PB5f-"))]
    assert len(factors) == 2
    for factor in factors:
        assert re.fullmatch(r"(144·)?\(-18 P2\[0\] P1\[1\] .* \+ 18 P2\[0\] P3\[1\]\)⁻²", factor)


@pytest.mark.parametrize("words", [(), ("--markdown",), ("--csv",)], ids=" ".join)
def test_no_name_steers_the_terminal(tmp_path, words):
    data = {"degree": 1, "knots": [0, 0, 1, 1], "control_points": [[0, 0], [1, 1]], "name": "a\x1b[31m\x9b2Jb\u202e"}
    path = tmp_path / "\x1b[2J.json"
    path.write_text(json.dumps(data))
    told = invoke("inspect", str(path), *words).output
    told += invoke("derive", "evolute", str(path)).output
    path.write_text("{")
    told += invoke("inspect", str(path)).output
    assert "\\x1b[31m" in told
    assert not re.search("[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e]", told)
