"""The benchmarks that the site shows: measured by ``python -m docs.site.benchmarks [SECTION …]``, kept with the date.

The page is generated from that record, never typed.
"""

from __future__ import annotations

import json
import os
import platform
import subprocess
import sys
from dataclasses import dataclass
from datetime import UTC, datetime
from importlib.metadata import version as installed_version
from itertools import groupby
from pathlib import Path
from typing import Any

import exactspline
from exactspline.batch.bench.row import Row
from exactspline.batch.bench.table import sheet

RECORD = Path(__file__).parent.parent / "benchmarks.json"
LIBRARIES = ("python-flint", "gmpy2", "sympy", "mpmath")


def measure(sections: list[str]) -> None:
    """Measure and keep: rows of ``exactspline bench``, where and when, with which versions, beside what load."""
    command = [sys.executable, "-m", "exactspline", "bench", *sections, "--json", "--quiet"]
    told = subprocess.run(command, stdout=subprocess.PIPE, check=False, text=True).stdout
    record = {
        "date": datetime.now(UTC).date().isoformat(),
        "exactspline": exactspline.__version__,
        "commit": _commit(),
        "python": platform.python_version(),
        "system": f"{platform.system()} {platform.machine()}",
        "processor": _processor(),
        "processors": os.cpu_count(),
        "load": round(os.getloadavg()[0], 1),
        "libraries": {name: installed_version(name) for name in LIBRARIES},
        "rows": json.loads(told)["rows"],
    }
    RECORD.write_text(json.dumps(record, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")


def _commit() -> str:
    command = ["git", "rev-parse", "--short", "HEAD"]
    return subprocess.run(command, stdout=subprocess.PIPE, check=False, text=True).stdout.strip()


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    lines = info.read_text(encoding="utf-8").splitlines() if info.exists() else []
    return next((line.partition(":")[2].strip() for line in lines if line.startswith("model name")), "")


def write_page(file: Path) -> None:
    """The record as a page: a table a section, and what it was measured on."""
    record = json.loads(RECORD.read_text(encoding="utf-8"))
    versions = ", ".join(f"{name} {version}" for name, version in record["libraries"].items() if version)
    lines = [
        "# Benchmarks",
        f"Measured on {record['date']} by `exactspline bench` ({record['exactspline']}, commit {record['commit']}): "
        f"Python {record['python']} on {record['system']}, {record['processors']} processors ({record['processor']}), "
        f"load {record['load']} at the end; {versions}. Times are processor time; ours / theirs below 1 means that "
        "exactspline is faster. A target that was missed is shown as missed. What is measured and how: "
        "[How fast](bench.md).",
    ]
    for name, rows in groupby(map(_row, record["rows"]), lambda row: row.section):
        lines += [f"## {name.capitalize()}", sheet(rows).markdown()]
    file.write_text("\n\n".join(lines) + "\n", encoding="utf-8")


@dataclass(frozen=True)
class Recorded(Row):
    """A row with the version that was measured, whatever is installed now."""

    recorded: str = ""

    @property
    def version(self) -> str:
        """The version as it was recorded."""
        return self.recorded


def _row(data: dict[str, Any]) -> Recorded:
    known = {key: value for key, value in data.items() if key not in ("key", "version")}
    return Recorded(**known, recorded=data["version"])


if __name__ == "__main__":
    measure(sys.argv[1:])
