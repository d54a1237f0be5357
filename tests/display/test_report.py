"""The report that a journal would take: witnesses that can be checked by hand, what was not entered, its origin."""

import re
from html import unescape

from exactspline import paper
from tests.support.command import invoke, new_paper

CLAIMS = """
[[claim]]
id = "5"
kind = "zero set"
statement = "turning and speed have one zero set"
formulas = ["turning", "speed_squared"]
on = "curve"
example = "cubic_s"
[[claim]]
id = "6"
kind = "at"
statement = "the value at 1/2 is 3"
formula = "turning"
parameter = 0.5
claimed = 3
example = "arch"
[[claim]]
id = "7"
kind = "not asked"
statement = "∫κ ds < π"
why = "an integral"
[[claim]]
id = "8"
kind = "limits"
statement = "a kind that there is not"
"""
READING = """
[[page]]
number = 1
spans = [
  {begins = "So it is", claims = ["1-identity"]}, {begins = "We thank", nothing = "thanks"}, {begins = "Hence <b>"},
]
"""


def folder_in(tmp_path):
    folder = new_paper(tmp_path / "mine")
    with (folder / "claims.toml").open("a") as file:
        file.write(CLAIMS)
    (folder / "reading.toml").write_text(READING)
    return folder


def test_the_report_has_what_a_reader_needs_to_check_it(tmp_path):
    folder = folder_in(tmp_path)
    done = invoke("prove", "--paper", folder, "--report", tmp_path / "report.html")
    assert done.exit_code == 2
    page = unescape(re.sub(r"<[^>]+>", " ", (tmp_path / "report.html").read_text()))
    arch = paper(folder).folder / "curves" / "arch.json"
    assert arch.exists()
    assert "arch of degree" in page
    assert "control points (" in page
    value = re.search(r"it is (\S+) at the parameter 1/2", page)[1]
    assert f"turning(1/2) = {value}" in page
    assert re.search(r"reason\s+mine′*/claims.toml, claim 8, kind: the kind 'limits' is unknown", page)
    for heading in ("What was not entered", "date", "command", "digest of the verdicts", "python-flint"):
        assert heading in page
    assert "7 (not asked)" in page
    assert "2 of 3 are read; p. 1, span 3: Hence <b>" in page
    assert (
        "<b>" not in (tmp_path / "report.html").read_text().partition("passages of the text")[2].partition("</dl>")[0]
    )


def test_a_reading_that_names_no_claim_is_reported(tmp_path):
    """Before: a claim that does not exist counted as read, and a span without its first letters was a KeyError."""
    folder, report = folder_in(tmp_path), tmp_path / "report.html"
    file = folder / "reading.toml"
    file.write_text(READING.replace("1-identity", "1-identities"))
    invoke("prove", "--paper", folder, "--report", report)
    assert "claims that do not exist: 1-identities; p. 1" in report.read_text()
    file.write_text(READING.replace('begins = "We', 'bgins = "We'))
    done = invoke("prove", "--paper", folder, "--report", report)
    assert "reading.toml, page 1, span 2: a span without its first letters" in str(done.exception)


def test_every_formula_without_a_claim_is_named(tmp_path):
    folder = folder_in(tmp_path)
    with (folder / "formulas.py").open("a") as file:
        file.write('\n\n@formula("eq. (9)", on="plane")\ndef forgotten(c):\n    return c.w\n')
    invoke("prove", "--paper", folder, "--report", tmp_path / "report.html")
    assert re.search(r"formulas without a claim</dt><dd>forgotten<", (tmp_path / "report.html").read_text())


def test_a_verdict_changes_the_digest(tmp_path):
    folder, report = folder_in(tmp_path), tmp_path / "report.html"
    table = folder / "claims.toml"
    entries = table.read_text().split("[[claim]]")

    def digest(*chosen):
        table.write_text("[[claim]]".join(chosen))
        invoke("prove", "--paper", folder, "--report", report)
        return re.search(r"digest of the verdicts(?:<[^>]*>\s*)+(\w{64})", report.read_text())[1]

    whole = digest(*entries)
    assert digest(entries[0], *entries[2:0:-1], *entries[3:]) == whole
    assert digest(*entries[:-1]) != whole


def test_the_whole_paper_as_theorems_and_its_bibliography(tmp_path):
    folder = folder_in(tmp_path)
    tex, bib = tmp_path / "claims.tex", tmp_path / "claims.bib"
    assert invoke("prove", "--paper", folder, "--tex", tex, "--bib", bib).exit_code == 2
    text = tex.read_text()
    assert text.count(r"\begin{proof}") == text.count(r"\end{proof}") == 8
    assert text.count(r"\begin{theorem}") == 6
    assert "There turning(1/2)" in text.replace(r"\_", "_")
    assert re.findall(r"^@misc\{(\w+),", bib.read_text(), re.MULTILINE)[-1] == "exactspline"
    assert "A small paper, to be changed" in bib.read_text()
