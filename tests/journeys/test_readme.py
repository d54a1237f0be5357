"""What the README and the errata tell people to type works as it stands."""

import contextlib
import io
import re
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest
from rich.cells import cell_len

from exactspline.cli.commands import leaves
from exactspline.display.code import code_lines
from exactspline.papers import default_papers
from exactspline.verification.claims import all_claims
from tests.support.decided import errors_in_print, remarks

README = Path(__file__).resolve().parents[2] / "README.md"


@pytest.mark.skipif(not README.exists(), reason="the README is in the checkout only")
@pytest.mark.parametrize("page", ["README.md", "docs/concepts.md", "docs/two-parameters.md"])
def test_python_blocks_of_a_page_run(page):
    """One after the other, as they are read."""
    blocks = re.findall(r"```python\n(.*?)```", (README.parent / page).read_text(encoding="utf-8"), re.DOTALL)
    assert blocks
    subprocess.run([sys.executable, "-c", "\n".join(blocks)], check=True)


@pytest.mark.skipif(not README.exists(), reason="the README is in the checkout only")
def test_the_readme_names_every_command():
    text = README.read_text(encoding="utf-8")
    missing = [name for name in leaves() if f"`./run {name}" not in text and f"`{name.split()[-1]}`" not in text]
    assert not missing


def test_every_refuted_claim_of_a_paper_belongs_to_one_error_that_says_what_is_true():
    found = list(errors_in_print())
    printed = {claim.key for claim in all_claims() if claim.expected == "REFUTED" and claim.status == "printed"}
    keys = [each.key for entry in found for each in entry.statements]
    assert set(keys) == printed
    assert len(keys) == len(printed)
    assert all(entry.truth for entry in found)


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


def test_one_check_runs_in_a_process_of_its_own():
    for _, each in checks()[:1]:
        done = subprocess.run([sys.executable, "-c", "\n".join(each.check)], capture_output=True, text=True, check=True)
        assert done.stdout.strip()
