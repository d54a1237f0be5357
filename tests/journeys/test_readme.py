"""What the README and the errata tell people to type works as it stands."""

import contextlib
import io
import re
import shlex
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest
from rich.cells import cell_len

from exactspline.display.sheet import code_lines
from exactspline.papers import default_papers
from tests.support.command import leaves, run
from tests.support.decided import errors_in_print, remarks

README = Path(__file__).resolve().parents[2] / "README.md"
COMMANDS = README.parent / "docs" / "commands.md"
RUN = [
    README.parent / name
    for name in (
        "README.md",
        "docs/commands.md",
        "docs/library.md",
        "docs/concepts.md",
        "docs/two-parameters.md",
        "docs/rounded-input.md",
        "docs/questions.md",
    )
] + sorted(README.parent.glob("docs/how-to/*.md"))
in_the_checkout = pytest.mark.skipif(not README.exists(), reason="the pages are in the checkout only")


def blocks_of(page, kind):
    # all blocks: the end of one of another kind is not the beginning of one
    found = re.findall(r"^```(\w*)\n(.*?)^```", page.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)
    return [block for each, block in found if each == kind]


@in_the_checkout
@pytest.mark.parametrize("page", RUN, ids=lambda page: page.stem)
def test_what_a_page_shows_is_what_is_printed(page, monkeypatch):
    """Every block that begins with a prompt, up to the dots."""
    monkeypatch.setenv("EXACTSPLINE_COMMAND", "./run")
    for block in blocks_of(page, ""):
        prompt, *shown = block.splitlines()
        if not prompt.startswith("$ "):
            continue
        command, *arguments = shlex.split(prompt.removeprefix("$ "))
        assert command == "./run"
        done = run(*arguments)
        rest = "\n".join(line.rstrip() for line in done.stdout.splitlines()) + "\n"
        for part in "\n".join([*shown, ""]).split("…\n"):
            if not part:
                continue
            assert part in rest, (prompt, part)
            rest = rest.partition(part)[2]
        assert done.returncode == 0


@in_the_checkout
def test_the_blocks_of_the_readme_fit_a_page():
    """A table of 95 columns had to be scrolled."""
    shown = [block for block in blocks_of(README, "") if block.startswith("$ ")]
    assert shown
    assert all(cell_len(line) <= 80 for block in shown for line in block.splitlines())


@in_the_checkout
def test_the_picture_of_a_curve_is_that_of_the_command(tmp_path):
    """`./run inspect six_segment_cubic --plot docs/pictures/inspect.png`: its words were those of an older version."""
    image = pytest.importorskip("PIL.Image")
    drawn = tmp_path / "inspect.png"
    assert run("inspect", "six_segment_cubic", "--plot", drawn).returncode == 0
    said = [image.open(file).text["Description"] for file in (drawn, README.parent / "docs/pictures/inspect.png")]
    assert said[0] == said[1]


@in_the_checkout
def test_the_commands_of_the_readme_run(tmp_path, monkeypatch):
    """As printed; the others, which take long, are run by CI."""
    (block,) = blocks_of(README, "sh")
    monkeypatch.chdir(tmp_path)
    command, *arguments = shlex.split(block.splitlines()[0], comments=True)
    assert command == "./run"
    assert run(*arguments).returncode == 0
    assert (tmp_path / "cubic_s.svg").read_text(encoding="utf-8").startswith("<?xml")
    named = [line.split()[1] for line in block.splitlines()]
    assert named == ["inspect", "prove", "test"]
    assert set(named) <= {*leaves(), *re.findall(r"^    (\w+)\)", (README.parent / "run").read_text(), re.MULTILINE)}


@in_the_checkout
@pytest.mark.parametrize(
    "page", [page for page in RUN if page.exists() and blocks_of(page, "python")], ids=lambda page: page.stem
)
def test_python_blocks_of_a_page_run(page, tmp_path):
    """One after the other, as they are read; what they write is not left in the checkout."""
    executed = pytest.importorskip("docs.site.executed")
    assert executed.shown_by(blocks_of(page, "python"), tmp_path, narrow=False).error == ""


@in_the_checkout
@pytest.mark.parametrize(
    "name",
    [
        "check-a-formula",
        "how-curved-at-most",
        "how-two-edges-meet",
        "nearest-point-of-a-surface",
        "ray-meets-a-surface",
    ],
)
def test_the_commands_of_a_how_to_run(name, tmp_path, monkeypatch):
    """As they are copied: the first block of Python is the file that they name, where they name one."""
    page = README.parent / f"docs/how-to/{name}.md"
    lines = [line for block in blocks_of(page, "sh") for line in block.splitlines()]
    monkeypatch.chdir(tmp_path)
    for file in set(re.findall(r"\w+\.py", " ".join(lines))):
        (tmp_path / file).write_text(blocks_of(page, "python")[0], encoding="utf-8")
    for line in lines:
        command, *arguments = shlex.split(line, comments=True)
        assert (command, run(*arguments).returncode) == ("./run", 0), line


@in_the_checkout
def test_the_page_of_commands_names_every_command():
    text = COMMANDS.read_text(encoding="utf-8")
    missing = [name for name in leaves() if f"`./run {name}" not in text and f"`{name.split()[-1]}`" not in text]
    assert not missing


def test_every_error_of_a_paper_is_listed_once_and_a_remark_is_none():
    listed = [entry.error for entry in errors_in_print()]
    remarked = [entry.error for entry in remarks()]
    assert sorted([*listed, *remarked]) == sorted(name for source in default_papers() for name in source.errors)
    assert "second-parameter" in remarked


@cache
def checks():
    return [(entry, each) for source in (errors_in_print, remarks) for entry in source() for each in entry.statements]


@pytest.mark.parametrize("width", [60, 80, 10_000])
def test_three_lines_show_that_each_statement_fails(width):
    """Pasted as they are printed at this width, all in one process."""
    for entry, each in checks():
        shown = [part for line in each.check for part in code_lines(line, width)]
        assert all(cell_len(line) <= width for line in shown), shown
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            exec("\n".join(shown), {})
        assert out.getvalue().strip() not in ("", "0", "None"), (entry.error, each.key)


def test_every_statement_of_an_entry_is_printed_by_its_snippet(monkeypatch):
    """The second of two statements was looked up and not printed: its last line was dropped as a repetition."""
    for source in (errors_in_print, remarks):
        for entry in source():
            lines, printed = dict.fromkeys(line for each in entry.statements for line in each.check), []
            exec("\n".join(lines), {"print": printed.append})
            assert len(printed) == len({each.check for each in entry.statements}), entry.error


def test_one_check_runs_in_a_process_of_its_own():
    for _, each in checks()[:1]:
        done = subprocess.run([sys.executable, "-c", "\n".join(each.check)], capture_output=True, text=True, check=True)
        assert done.stdout.strip()


def test_the_first_installation_says_what_it_fetches_and_fails_where_pip_fails(tmp_path):
    """It was silent for minutes."""
    shutil.copy(README.parent / "run", tmp_path)
    (tmp_path / "pyproject.toml").touch()
    python = tmp_path / ".venv" / "bin" / "python"
    python.parent.mkdir(parents=True)
    lines = (
        "Collecting a-b>=1 (from x)\n  Using cached a\nInstalling collected packages: a-b\nSuccessfully installed a-b-1"
    )
    for status in (0, 1):
        python.write_text(f'#!/bin/sh\necho "{lines}"\nexit {status}\n', encoding="utf-8")
        python.chmod(0o755)
        done = subprocess.run(["./run", "install", "plot"], cwd=tmp_path, capture_output=True, text=True, check=False)
        assert done.returncode == status
        assert "fetching\na-b \nputting all that in place\ninstalled\n" in done.stderr
        assert (tmp_path / ".venv" / ".installed-plot").exists() == (status == 0)
        (tmp_path / ".venv" / ".installed-plot").unlink(missing_ok=True)
