"""Plain English: phrases of a private dialect stand in no docstring, comment, message, page or notebook.

Each phrase comes with what to write instead. Quotations of papers (the TOML files of `exactspline/papers`) are theirs.
"""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]

#: A regular expression, and what a reader of the field expects in its place.
PHRASES = {
    r"whole numbers?": "integer",
    r"one an? (segment|span|point|knot|patch|curve|line|row)": "one per …",
    r"so many": "this many, or the number's name",
    r"and leave\.": "and exit",
    r"(pages?|HTML|surfaces) that (turn|move)s?": "interactive pages, interactive 3-D surfaces",
    r"given up to tell": "refinement limit for …",
    r"says nothing of": "does not apply to",
    r"(?<!there )is no (spline|curve|surface|square|plane|weight|number|proof|point|file|polynomial|double|knot|claim)":
        "is not a …",
    r"(?<!there )are no (splines|curves|numbers|zeros|points|polynomials|doubles|arrays?)": "are not …",
}  # fmt: skip
#: The same for code in these folders alone, where also names of variables count.
IN_CODE = {
    r"_?told": "reported, shown; a variable is named by what it holds: message, rows, data, …",
    r"tells (of|whether|how|why|what)": "states whether …",
    r"wanted": "required, requested",
    r"given up": "refinement limit for …",
    r"at fault": "the place of the error",
    r"(as it stands|as they stand)": "as written, unchanged",
    r"speaks? of(?! it\. \*)": "applies to, is about",
    r"what is left": "the remaining …",
    r"says? nothing": "decides nothing, does not apply",
    r"from so many on": "≥ this many",
    r"left to exact": "decided by exact arithmetic",
    r"beside (the|its|it|their|them|each|one)": "next to, in addition to",
}  # fmt: skip
#: The same for all but the tests.
READ = {
    r"told (as|apart|from)": "reported as, distinguished from",
    r"(is|are) told": "is reported, listed, distinguished",
    r"to and fro": "back and forth",
    r"to be turned": "to rotate",
    r"standing pieces?": "constant piece",
    r"speaks? of nothing": "is vacuous",
    r"stands? beside": "is given in addition, is shown next to",
    r"shares s": "weights s, the local parameter",
    r"all but (coincide|meet|touch)": "nearly coincident",
    r"the house": "the project, the design",
    r"as it must read": "corrected statement",
    r"beyond the paper": "our own statements",
    r"perhaps": "possibly",
    r"what (a|the|each) (curve|surface) has": "its features",
    r"has to be trusted": "the trusted base",
    r"(arc|loop)s? of pairs": "correspondence of parameters",
    r"as meant": "rounded input",
    r"judges? of Boolean": "verifier of Boolean results",
    r"covered (once|twice)": "injective projection",
    r"gone within": "destroyed by a perturbation of size",
    r"certain up to": "stable up to",
    r"curves of one dimension": "curves of the same dimension",
}
FOLDERS = ("exactspline/", "workshop/")
#: Folders that are not of the project.
OTHERS = {".venv", "build", "node_modules"}
TEXTS = ("*.py", "*.pyi", "*.md", "*.ipynb", "*.js", "*.html")


def phrases_in(text: str, phrases: dict[str, str] = PHRASES) -> list[str]:
    """The phrases in a text, with what to write instead."""
    plain = re.sub(r"\s+(#:? )?", " ", text)
    return [
        f"{found[0]!r}: write {instead}"
        for phrase, instead in phrases.items()
        for found in re.finditer(rf"\b{phrase}(?!\w)", plain, re.IGNORECASE)
    ]


def texts() -> list[Path]:
    """Every file with words for people, but the history and this list itself."""
    listed = subprocess.run(["git", "ls-files", "-z", *TEXTS], cwd=ROOT, capture_output=True, text=True, check=False)
    files = [ROOT / name for name in listed.stdout.split("\0") if name] or [
        path for form in TEXTS for path in ROOT.rglob(form) if not OTHERS & {*path.relative_to(ROOT).parts}
    ]
    return [path for path in files if path.exists() and path.name != "CHANGELOG.md" and path != Path(__file__)]


def test_texts_are_plain():
    wrong = [
        f"{path.relative_to(ROOT)}: {each}" for path in texts() for each in phrases_in(path.read_text(encoding="utf8"))
    ]
    assert not wrong, "\n".join(wrong)


def test_what_people_read_is_plain():
    wrong = [
        f"{path.relative_to(ROOT)}: {each}"
        for path in texts()
        if not path.relative_to(ROOT).as_posix().startswith("tests/")
        for each in phrases_in(path.read_text(encoding="utf8"), READ)
    ]
    assert not wrong, "\n".join(wrong)


def test_code_is_plain():
    wrong = [
        f"{path.relative_to(ROOT)}: {each}"
        for path in texts()
        if path.suffix == ".py" and path.relative_to(ROOT).as_posix().startswith(FOLDERS)
        for each in phrases_in(path.read_text(encoding="utf8"), IN_CODE)
    ]
    assert not wrong, "\n".join(wrong)


@pytest.mark.parametrize("planted", ["told = []", "def _told(x):", '"""What the\n    formula speaks\n    of."""'])
def test_a_phrase_in_code_is_found(planted):
    assert phrases_in(planted, IN_CODE)


@pytest.mark.parametrize(
    "planted",
    [
        '"""One a segment."""',
        "#: After so\n#: many rounds.",
        "raise NumberError('2.5 is no number')",
        "a whole\n    number of them",
        "Pages that turn",
        "an HTML page that turns",
    ],
)
def test_a_phrase_is_found(planted):
    assert phrases_in(planted)


def test_natural_words_are_not_found():
    assert not phrases_in("there is no curve called 'a'; there are no zeros; one point per segment")
