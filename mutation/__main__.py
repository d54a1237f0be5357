"""``./run mutate``: the mutants of this seed, their verdicts as JSON lines, and a score.

A run that was interrupted goes on where it stopped. Survivors that are known and explained stand in ``survivors.toml``;
any other is printed, and the exit code is 1.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tomllib
from collections import Counter
from pathlib import Path
from time import monotonic
from typing import Any

from mutation.coverage_map import MAP, ROOT
from mutation.mutants import Mutant, drawn

RESULTS = MAP.parent / "results.jsonl"
SURVIVORS = ROOT / "mutation" / "survivors.toml"
#: Verdicts that are no failure: refuted, or no change at all. A run that did not end, or broke, says nothing.
HARMLESS = ("killed", "equivalent")


def read(path: Path) -> dict[str, dict[str, Any]]:
    """The verdicts so far, by the name of the mutant."""
    if not path.is_file():
        return {}
    return {r["mutant"]: r for line in path.read_text(encoding="utf-8").splitlines() if (r := json.loads(line))}


def explained() -> dict[str, str]:
    """The survivors that are known: name and explanation."""
    if not SURVIVORS.is_file():
        return {}
    found = tomllib.loads(SURVIVORS.read_text(encoding="utf-8")).get("survivor", [])
    return {entry["mutant"]: entry["because"] for entry in found}


def stable(name: str) -> str:
    """A mutant without its line and column, which change with every edit above it."""
    file, function, _, _, rest = name.split(":", 4)
    return f"{file}:{function}:{rest}"


def main() -> int:
    """Judge what is left to judge."""
    parser = argparse.ArgumentParser(
        prog="./run mutate", description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("--only", choices=("formulas", "engines"), help="only the mutants of one sort")
    parser.add_argument(
        "--sample", type=int, default=0, help="so many mutants of each sort (0: all formulas, 500 engines)"
    )
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--minutes", type=float, default=40, help="stop after so many minutes; the next run goes on")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--file", default="", help="only mutants of files whose names contain this")
    parser.add_argument("--again", default="", help="judge anew what has this verdict: survived, timeout, broken")
    parser.add_argument("--results", type=Path, default=RESULTS)
    options = parser.parse_args()
    known, end = read(options.results), monotonic() + 60 * options.minutes
    known = {name: result for name, result in known.items() if result["verdict"] not in options.again.split(",")}
    options.results.parent.mkdir(parents=True, exist_ok=True)
    chosen: list[Mutant] = []

    def told(mutant: Mutant, result: dict[str, Any]) -> bool:
        known[mutant.name] = {"mutant": mutant.name, **result}
        with options.results.open("a", encoding="utf-8") as stream:
            stream.write(json.dumps(known[mutant.name], ensure_ascii=False) + "\n")
        return monotonic() < end

    if options.only != "engines":
        from mutation import formulas

        mine = _drawn(formulas.all_mutants(), options, 10**6)
        chosen += mine
        todo = [m for m in mine if m.name not in known]
        for mutant, result in formulas.judged(todo, 120, options.jobs) if todo else ():
            if not told(mutant, result):
                break
    if options.only != "formulas":
        from mutation import engines

        if not MAP.is_file():
            print("which tests execute what: the suite runs once under coverage", flush=True)
            subprocess.run([sys.executable, "-m", "pytest", "-q", "-p", "mutation.coverage_map"], cwd=ROOT, check=False)
        mine = _drawn(engines.all_mutants(), options, 500)
        chosen += mine
        todo = [m for m in mine if m.name not in known]
        if todo and monotonic() < end:
            engines.judged(todo, told, 150, options.jobs)
    return report(chosen, known)


def _drawn(mutants: list[Mutant], options: argparse.Namespace, most: int) -> list[Mutant]:
    return drawn([m for m in mutants if options.file in m.file], options.sample or most, options.seed)


def report(chosen: list[Mutant], known: dict[str, dict[str, Any]]) -> int:
    """Print the score and the survivors that nobody explained."""
    why = explained()
    judged = [m for m in chosen if m.name in known]
    for sort in ("papers", "engines"):
        mine = [m for m in judged if ("/papers/" in m.file) == (sort == "papers")]
        if not mine:
            continue
        counts = Counter(known[m.name]["verdict"] for m in mine)
        real = len(mine) - counts["equivalent"]
        told = sum(known[m.name]["verdict"] == "survived" and stable(m.name) in why for m in mine)
        words = ", ".join(f"{n} {verdict}" for verdict, n in sorted(counts.items()))
        score = 100 * counts["killed"] / real if real else 100
        print(f"{sort}: {len(mine)} mutants: {words} ({told} of the survivors explained); score {score:.1f} %")
    left = [m.name for m in judged if known[m.name]["verdict"] not in HARMLESS and stable(m.name) not in why]
    for name in left:
        print(f"{known[name]['verdict']}: {name} ({known[name].get('by', '')})")
    if len(judged) < len(chosen):
        print(f"{len(chosen) - len(judged)} mutants are left: run it again")
    return 1 if left else 0


if __name__ == "__main__":
    sys.exit(main())
