"""Nothing is cropped: at every width, in a pipe and in a terminal, every table of every command shows all its cells."""

import os
import re
import struct
import subprocess
import sys
from collections import Counter

import pytest
from hypothesis import given
from hypothesis import strategies as st
from rich.cells import cell_len

from exactspline import examples
from exactspline.display.sheet import PIPE, Sheet, csv_of, hanging
from tests.support.command import invoke
from tests.support.sampled import sample

WIDTHS = (60, 100)
texts = st.text(alphabet="ab−′² ‖κ", min_size=0, max_size=90)


@given(st.lists(st.lists(st.integers(1, 9), min_size=3, max_size=3), min_size=1, max_size=4), st.integers(20, 130))
def test_every_cell_is_shown_once_and_no_line_is_too_long(lengths, width):
    """The words of the cells are all different, so that none can stand for another."""
    sheet = Sheet("one", "two", "three", numbers=["two"], prose=["three"])
    for i, row in enumerate(lengths):
        sheet.add_row(*[" ".join(f"{i}{'xyz'[j]}{k}" for k in range(n)) for j, n in enumerate(row)])
    for chosen in (width, PIPE):
        shown = sheet.text(chosen)
        found = Counter(re.findall(r"\d[xyz]\d", shown))
        assert found == Counter(word for row in sheet.rows for cell in row for word in cell.split())
        assert all(cell_len(line) <= chosen for line in shown.splitlines())
    assert len(sheet.text().splitlines()) == 1 + len(lengths)


@given(texts, st.integers(20, 100))
def test_breaking_lines_loses_nothing(text, width):
    lines = hanging(text, width)
    assert "".join("".join(lines).split()) == "".join(text.split())
    assert all(cell_len(line) <= width for line in lines)


def words(text):
    """Short words with how often they stand there, whatever sign stands behind them."""
    return Counter(word for part in text.split() if len(word := part.rstrip(",:")) <= 12)


def assert_whole(narrow, cells, width):
    """All that stands in the cells stands in the narrow text too, in lines that fit."""
    assert all(cell_len(line) <= width for line in narrow.splitlines())
    assert words(cells) - words(narrow) == Counter()
    squeezed = "".join(narrow.split())
    assert all(word in squeezed for word in cells.split() if len(word) > 12)


#: What heads a block needs no heading of its own.
HEADINGS = {
    "point",
    "section",
    "claim",
    "construction",
    "curve",
    "form",
    "formula",
    "name",
    "parameter",
    "variant",
    "verdict",
    "what",
    "witness",
    "zero",
}


COMMANDS = (
    "prove --claim C4.2",
    "prove --section 3 --verdict refuted",
    "prove --curve straight_line",
    "show C4.2b",
    "show --quiet",
    "formula degrees --curve straight_between_arcs",
    "formula degrees --generic",
    "formula reduce curvature_squared_derivative",
    "list formulas",
    "inspect six_segment_cubic planar_in_space",
    "bisector ellipse --point=-1,1/3",
    "formula conditioning",
    "teach triangle rational_cubic --at 1/3 --insert 1/2 --elevate 2 --product x,w",
    "teach exercise",
    "list curves",
    "list words",
)


@pytest.mark.parametrize("command", COMMANDS)
def test_a_command_says_the_same_at_every_width(command):
    arguments = command.split()
    full = invoke(*arguments, env={"COLUMNS": ""})
    assert full.exit_code == 0, full.output
    # every width of every table of a command: below
    shown = invoke(*arguments, env={"COLUMNS": str(WIDTHS[0])}).stdout
    missing = words(full.stdout) - words(shown)
    assert set(missing) <= HEADINGS
    assert_whole(shown, " ".join(word for word in full.stdout.split() if word not in HEADINGS), WIDTHS[0])


def test_lines_of_errata_fit():
    """Code is broken between tokens: what is pasted is tested with the README."""
    shown = invoke("errata", env={"COLUMNS": "60"})
    assert shown.exit_code == 0
    assert all(cell_len(line) <= 60 for line in shown.output.splitlines())


def test_every_table_on_every_example_curve_is_whole(monkeypatch):
    made, render = [], Sheet.lines

    def recorded(sheet, width=PIPE):
        made.append(sheet)
        return render(sheet, width)

    monkeypatch.setattr(Sheet, "lines", recorded)
    names = [option for name in sample(examples("curves"), 12) for option in ("--curve", name)]
    ledger = ["prove", "--rows", "--section", "5"]
    for arguments in (ledger, ["formula", "degrees", *names], ["inspect", *examples("curves")]):
        result = invoke(*arguments, env={"COLUMNS": ""})
        assert result.exit_code == 0, result.output[-300:]
    monkeypatch.undo()
    assert len(made) > 2 * len(examples("curves"))
    for sheet in made:
        for width in WIDTHS:
            assert_whole(sheet.text(width), " ".join(cell for row in sheet.rows for cell in row), width)


def test_csv_and_markdown_have_every_row():
    sheet = Sheet("form", "degree", name="circle")
    sheet.add_row("|κ|, squared", 2)
    assert csv_of([sheet], "curve") == 'curve,form,degree\ncircle,"|κ|, squared",2\n'
    full = invoke("list", "curves", "--csv").output.splitlines()
    assert len(full) == 1 + len(examples("curves"))
    assert len(invoke("list", "curves", "--markdown").output.splitlines()) == 2 + len(examples("curves"))


def environment(**more):
    kept = {name: value for name, value in os.environ.items() if name not in ("COLUMNS", "NO_COLOR", "FORCE_COLOR")}
    return kept | more


@pytest.mark.skipif(sys.platform == "win32", reason="a pseudo-terminal is needed")
@pytest.mark.parametrize("width", [60])
def test_in_a_terminal_lines_fit_and_no_color_is_heeded(width):
    import fcntl
    import pty
    import termios

    for more, coloured in (({}, True), ({"NO_COLOR": "1"}, False)):
        ours, theirs = pty.openpty()
        fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 40, width, 0, 0))
        command = [sys.executable, "-m", "exactspline", "prove", "--claim", "C4.1"]
        with subprocess.Popen(
            command, stdout=theirs, stderr=subprocess.DEVNULL, env=environment(TERM="xterm-256color", **more)
        ) as process:
            os.close(theirs)
            shown = b""
            while True:
                try:
                    part = os.read(ours, 65536)
                except OSError:
                    break
                if not part:
                    break
                shown += part
        os.close(ours)
        assert process.returncode == 0
        text = shown.decode()
        assert ("\x1b[" in text) == coloured
        plain = re.sub(r"\x1b\[[0-9;]*m", "", text)
        assert all(cell_len(line) <= width for line in plain.splitlines())


@pytest.mark.parametrize("arguments", [["prove", "--claim", "T1", "--rows"], ["--help"]])
def test_a_reader_that_leaves_changes_no_verdict(arguments):
    with subprocess.Popen(
        [sys.executable, "-m", "exactspline", *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env=environment(),
    ) as process:
        process.stdout.close()
        complaint = process.stderr.read()
    assert (process.returncode, complaint) == (0, b"")


@pytest.mark.parametrize(
    "options", ["--generic", "--at 3 evolute", "--formulas", "--paper surfaces --patch 2,1 normal normal_squared"]
)
def test_degrees_as_latex(options):
    """There was no such option. LaTeX knows every sign, and every row has as many cells as columns."""
    shown = invoke("formula", "degrees", *options.split(), "--latex", "-q").stdout
    tables = [table.splitlines() for table in shown.rstrip().split("\n\n")]
    plain = invoke("formula", "degrees", *options.split(), "--csv").stdout
    assert sum(len(lines) - 5 for lines in tables) == len(plain.splitlines()) - 1
    for title, begin, head, rule, *rows, end in tables:
        assert (title[:2], rule, end) == ("% ", r"\hline", r"\end{tabular}")
        columns = re.fullmatch(r"\\begin\{tabular\}\{([lr]+)\}", begin)[1]
        for row in (head, *rows):
            assert row.isascii()
            assert row.endswith(r" \\")
            assert len(re.findall(r"(?<!\\)&", row)) == len(columns) - 1
            assert len(re.findall(r"(?<!\\)\$", row)) % 2 == 0
