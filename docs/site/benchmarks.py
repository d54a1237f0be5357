"""The benchmarks that the site shows: measured by ``python -m docs.site.benchmarks [--full] [SECTION …]``.

The tables of the page are generated from that record, never typed.
"""

from __future__ import annotations

import json
import os
import platform
import subprocess
import sys
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import UTC, datetime
from importlib.metadata import version as installed_version
from pathlib import Path
from typing import Any

import exactspline
from docs.site.narrow import beside
from docs.site.pages import picture
from workshop.bench.picture import draw
from workshop.bench.row import OURS, Row
from workshop.bench.table import SECTIONS, chosen_sections, sheet

RECORD = Path(__file__).parent.parent / "benchmarks.json"
LIBRARIES = ("python-flint", "gmpy2", "sympy", "mpmath")


def measure(sections: Iterable[str], *, full: bool) -> None:
    """Measure sections one after the other and keep each when it is done, in the place of what was kept of it before:
    rows of ``./run bench``, where and when, with which versions, beside what load.
    """
    for name in sections:
        command = [sys.executable, "-m", "workshop.bench", name, *["--full"] * full, "--json", "--quiet"]
        told = subprocess.run(command, stdout=subprocess.PIPE, check=False, text=True).stdout
        measured = {
            "section": name,
            "command": f"./run bench {name}{' --full' * full}",
            "date": datetime.now(UTC).date().isoformat(),
            "exactspline": exactspline.__version__,
            "commit": _commit(),
            "python": platform.python_version(),
            "system": f"{platform.system()} {platform.machine()}",
            "processor": _processor(),
            "processors": os.cpu_count(),
            "load": round(os.getloadavg()[0], 1),
            "libraries": {library: installed_version(library) for library in LIBRARIES},
            "rows": json.loads(told)["rows"],
        }
        kept = {each["section"]: each for each in recorded()} | {name: measured}
        text = json.dumps([kept[each] for each in SECTIONS if each in kept], ensure_ascii=False, indent=1)
        RECORD.write_text(text + "\n", encoding="utf-8")


def recorded() -> list[dict[str, Any]]:
    """What is kept, section by section."""
    found: list[dict[str, Any]] = json.loads(RECORD.read_text(encoding="utf-8"))
    return found


def _commit() -> str:
    command = ["git", "rev-parse", "--short", "HEAD"]
    return subprocess.run(command, stdout=subprocess.PIPE, check=False, text=True).stdout.strip()


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    lines = info.read_text(encoding="utf-8").splitlines() if info.exists() else []
    return next((line.partition(":")[2].strip() for line in lines if line.startswith("model name")), "")


def add_tables(page: Path, pictures: Path) -> None:
    """The record at the end of a page: a chart of the ratios, a table per section, and what it was measured on."""
    pictures.mkdir(parents=True, exist_ok=True)
    rows = [_row(row) for record in recorded() for row in record["rows"]]
    draw(rows, str(pictures / "benchmarks.svg"))
    draw(rows, str(beside(pictures / "benchmarks.svg")), narrow=True)
    lines = [
        page.read_text(encoding="utf-8").rstrip(),
        picture(
            "gallery/benchmarks.svg",
            "the times of other libraries divided by those of exactspline, case by case; and the growth of the times "
            "with the degree",
        ),
    ]
    for record in recorded():
        lines += [f"### {record['section'].capitalize()}", _measured_on(record)]
        lines += [sheet(map(_row, record["rows"])).markdown(), _peers(record)]
    page.write_text("\n\n".join(filter(None, lines)) + "\n", encoding="utf-8")


def _measured_on(record: dict[str, Any]) -> str:
    """A line about when, where and beside what load a section was measured."""
    versions = ", ".join(f"{name} {version}" for name, version in record["libraries"].items() if version)
    return (
        f"`{record['command']}` on {record['date']}, exactspline {record['exactspline']} (commit {record['commit']}), "
        f"Python {record['python']} on {record['system']}, {record['processors']} processors ({record['processor']}), "
        f"load {record['load']} at the end; {versions}."
    )


def _peers(record: dict[str, Any]) -> str:
    """A line with the versions of the other libraries of a section."""
    versions = {row["peer"]: row["version"] for row in record["rows"] if row["peer"] != OURS and row["version"]}
    return f"Beside: {', '.join(f'{peer} ({version})' for peer, version in versions.items())}." if versions else ""


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
    words = sys.argv[1:]
    measure(chosen_sections(word for word in words if word != "--full"), full="--full" in words)
