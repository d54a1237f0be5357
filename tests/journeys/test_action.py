"""The action and the hook for a paper's folder: what is not as recorded is an annotation at its claim."""

import subprocess
import sys
from pathlib import Path

import pytest

from tests.support.command import invoke

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = ROOT / ".github" / "annotations.py"
pytestmark = pytest.mark.skipif(not SCRIPT.exists(), reason="there is no checkout")


def test_a_verdict_that_is_not_the_recorded_one_is_an_annotation_at_its_claim(tmp_path):
    paper = tmp_path / "my-paper"
    assert invoke("paper", "new", str(paper)).exit_code == 0
    claims = paper / "claims.toml"
    for wrong in (False, True):
        if wrong:
            claims.write_text(
                claims.read_text(encoding="utf-8").replace("weight = ", "weight = 1", 1), encoding="utf-8"
            )
        done = subprocess.run([sys.executable, str(SCRIPT), str(paper)], capture_output=True, text=True, check=False)
        assert done.returncode == wrong, done.stderr
        if not wrong:
            assert done.stdout.strip() == ""
    first, *_ = done.stdout.splitlines()
    assert first.startswith(f"::error file={claims},line=")
    line = int(first.partition("line=")[2].partition(",")[0])
    assert claims.read_text(encoding="utf-8").splitlines()[line - 1].startswith("id = ")
    assert "REFUTED (recorded: PROVED)" in first
