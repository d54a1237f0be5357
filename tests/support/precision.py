"""The type checker, and how many expressions outside the papers have a precise type.

``python tests/support/precision.py`` fails where mypy finds an error, and below `LEAST` %.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

#: Percent of the expressions whose type contains no Any.
LEAST = 95
#: Formulas keep their plain form: nothing in them is annotated.
FORMULAS = re.compile(r"exactspline\.papers\.\w+\.")
ROW = re.compile(r"\s*(exactspline\S*)\s+(\d+)\s+(\d+)\s")


def precision(report: str) -> float:
    """The percentage that a report of mypy (``any-exprs.txt``) tells, the formulas left out."""
    rows = [m.groups() for line in report.splitlines() if (m := ROW.match(line)) and not FORMULAS.match(m[1])]
    return 100 - 100 * sum(int(loose) for _, loose, _ in rows) / sum(int(every) for _, _, every in rows)


def main() -> int:
    """Ask mypy once for both, say what it found, and return 1 where that is an error or too little."""
    from mypy import api

    with TemporaryDirectory() as folder:
        found, errors, status = api.run(["--any-exprs-report", folder])
        report = Path(folder, "any-exprs.txt")
        sys.stderr.write(found + errors)
        if status or not report.exists():
            return 1
        percent = precision(report.read_text(encoding="utf-8"))
    print(f"{percent:.1f} % of the expressions outside the papers have a precise type (at least {LEAST} % must)")
    return 0 if percent >= LEAST else 1


if __name__ == "__main__":
    sys.exit(main())
