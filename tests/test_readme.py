"""What the README and the errata tell people to type works as it stands."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

from exactspline.papers import papers
from exactspline.verification.claims import all_claims
from exactspline.verification.errata import errata

README = Path(__file__).resolve().parents[1] / "README.md"


@pytest.mark.skipif(not README.exists(), reason="the README is in the checkout only")
def test_python_blocks_of_the_readme_run():
    blocks = re.findall(r"```python\n(.*?)```", README.read_text(encoding="utf-8"), re.DOTALL)
    assert blocks
    for block in blocks:
        subprocess.run([sys.executable, "-c", block], check=True)


@pytest.mark.skipif(not README.exists(), reason="the README is in the checkout only")
def test_the_readme_names_every_command():
    from exactspline.cli import app

    text = README.read_text(encoding="utf-8")
    assert all(f"`exactspline {command.callback.__name__}" in text for command in app.registered_commands)


def test_every_refuted_claim_is_an_erratum_that_says_what_is_true():
    found = list(errata())
    printed = [claim for claim in all_claims() if claim.expected == "REFUTED" and claim.status == "printed"]
    assert [e.key for e in found] == [claim.key for claim in printed]
    assert {e.error for e in found} == {name for source in papers() for name in source.errors}
    assert all(e.truth and e.found and len(e.check) == 3 for e in found)


@pytest.mark.parametrize("entry", list(errata()), ids=lambda e: f"{e.id} {e.where}")
def test_three_lines_show_that_the_claim_fails(entry):
    done = subprocess.run([sys.executable, "-c", "\n".join(entry.check)], capture_output=True, text=True, check=True)
    assert done.stdout.strip() not in ("", "0", "None")
