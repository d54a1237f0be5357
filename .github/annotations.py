"""Decide the claims of a paper's folder, and write what is not as recorded as annotations of a workflow.

usage: python annotations.py FOLDER
"""

import json
import re
import subprocess
import sys
from pathlib import Path


def place(folder: Path, claim: str) -> tuple[str, int]:
    """The file and the line of the claim with this id; the first line where it is not found."""
    for file in sorted(folder.glob("claims*.toml")):
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            if re.match(rf"""id\s*=\s*["']{re.escape(claim)}["']""", line):
                return str(file), number
    return str(folder / "claims.toml"), 1


def annotations(folder: Path, rows: list[dict[str, object]]) -> list[str]:
    """An annotation for each verdict that is not the recorded one."""
    found = []
    for row in rows:
        if not row["as_recorded"]:
            file, line = place(folder, str(row["id"]))
            said = (
                f"{row['verdict']} (recorded: {row['expected']}): {row['statement']} {row['witness'] or row['reason']}"
            )
            escaped = said.strip().replace("%", "%25").replace("\n", "%0A")
            found.append(f"::error file={file},line={line},title=claim {row['id']}::{escaped}")
    return found


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    done = subprocess.run(
        [sys.executable, "-m", "exactspline", "prove", "--paper", str(folder), "--json"],
        stdout=subprocess.PIPE,
        text=True,
        check=False,
    )
    if done.stdout:
        print("\n".join(annotations(folder, json.loads(done.stdout)["rows"])))
    sys.exit(done.returncode)
