"""``./run mutate``: the mutants of this seed, their verdicts as JSON lines, and a score.

An interrupted run continues where it stopped; functions changed since are judged again. Known survivors are explained
in ``survivors.toml``, or by their place (`neutral`); any other is printed, and the exit code is 1. With ``--witnesses``
a sample of the mutants of engines that were detected is judged again by the tests that detected them, as recorded in
``witnesses.json``: the exit code is 1 below the target.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tomllib
from collections import Counter
from collections.abc import Callable
from datetime import date
from pathlib import Path
from time import monotonic
from typing import Any

from workshop.mutation.coverage_map import MAP, ROOT
from workshop.mutation.mutants import Mutant, drawn
from workshop.mutation.neutral import neutral

RESULTS = MAP.parent / "results.jsonl"
PAGE = ROOT / "docs" / "mutation.md"
#: The lines of the page between which the table is written.
BEGIN, END = "<!-- written by ./run mutate --record -->\n", "<!-- end -->\n"
#: The mutants that are open, by their keys, with their names: known on every machine.
OPEN = ROOT / "workshop" / "mutation" / "open.json"
SURVIVORS = ROOT / "workshop" / "mutation" / "survivors.toml"
#: Verdicts that are not failures: refuted, or no change at all. A run that did not end, or failed, proves neither.
HARMLESS = ("killed", "equivalent")
#: The target: how many of the unexplained mutants of engines must be detected, in per cent.
TARGET = 95
Known = dict[str, dict[str, Any]]
#: The columns of the table; the last one is the day on which a row was written from verdicts.
COLUMNS = ("room", "judged", "noticed", "equal", "explained", "open", "score", "as of")
#: The verdicts by room; the rows of the table, each with its day.
Rooms = dict[str, Counter[str]]
Rows = dict[str, tuple[str, Counter[str]]]


def read(path: Path) -> Known:
    """The verdicts so far, by the keys of the mutants."""
    if not path.is_file():
        return {}
    return {r["key"]: r for line in path.read_text(encoding="utf-8").splitlines() if (r := json.loads(line))}


def explained() -> dict[str, str]:
    """The known survivors: name and explanation, and the functions on which no answer depends, whatever they return."""
    if not SURVIVORS.is_file():
        return {}
    data = tomllib.loads(SURVIVORS.read_text(encoding="utf-8"))
    return {entry["mutant"]: entry["because"] for entry in data.get("survivor", [])} | {
        entry["of"]: entry["because"] for entry in data.get("function", [])
    }


def is_explained(mutant: Mutant, why: dict[str, str]) -> bool:
    """Whether it is known by its name or by its place that no answer depends on a change."""
    return mutant.stable in why or f"{mutant.file}:{mutant.function}" in why or neutral(mutant) is not None


def arguments() -> argparse.Namespace:
    """The parsed command line."""
    parser = argparse.ArgumentParser(
        prog="./run mutate", description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("--only", choices=("formulas", "engines"), help="only the mutants of one sort")
    parser.add_argument(
        "--sample", type=int, default=0, help="this many mutants of each sort (0: all formulas, 500 engines)"
    )
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument(
        "--minutes", type=float, default=40, help="stop after this many minutes; the next run continues"
    )
    parser.add_argument(
        "--budget", type=float, default=30, help="this many seconds of tests for one mutant of an engine"
    )
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument(
        "--file", default="", help="only mutants of files whose names contain one of these: roots/,symbolic/"
    )
    parser.add_argument("--function", default="", help="only mutants of functions whose names contain this")
    parser.add_argument(
        "--again",
        default="",
        help="only judge again the mutants with this verdict (survived, timeout, broken) that are not explained",
    )
    parser.add_argument("--results", type=Path, default=RESULTS)
    parser.add_argument("--witnesses", action="store_true", help="judge again a sample of the detected mutants")
    parser.add_argument("--table", action="store_true", help="only print the table of the verdicts so far")
    parser.add_argument(
        "--edited",
        action="store_true",
        help="judge again the mutants detected in functions that have been edited since, by the recorded tests",
    )
    parser.add_argument(
        "--record", action="store_true", help="write witnesses.json and the table of docs/mutation.md from the verdicts"
    )
    return parser.parse_args()


def main() -> int:
    """Judge the mutants without a verdict."""
    options = arguments()
    known, end = {} if options.witnesses else read(options.results), monotonic() + 60 * options.minutes
    options.once_more = {name for name, result in known.items() if result["verdict"] in options.again.split(",")}
    known = {name: result for name, result in known.items() if name not in options.once_more}
    options.results.parent.mkdir(parents=True, exist_ok=True)

    def write_verdict(mutant: Mutant, result: dict[str, Any]) -> bool:
        known[mutant.key] = {"key": mutant.key, "mutant": mutant.name, **result}
        # for an edited function only the recorded tests are run: others may detect what these do not
        if not options.witnesses and not (options.edited and result["verdict"] != "killed"):
            with options.results.open("a", encoding="utf-8") as stream:
                stream.write(json.dumps(known[mutant.key], ensure_ascii=False) + "\n")
        return bool(monotonic() < end)

    if options.record:
        return record(known)
    if options.table:
        return table(known)
    chosen: list[Mutant] = []
    if options.only != "engines":
        chosen += judge_formulas(options, known, write_verdict)
    if options.only != "formulas":
        chosen += judge_engines(options, known, write_verdict)
    return report(chosen, known, by_score=options.witnesses)


def judge_formulas(
    options: argparse.Namespace, known: Known, write_verdict: Callable[[Mutant, dict[str, Any]], bool]
) -> list[Mutant]:
    """Judge the mutants of formulas; returns all that were drawn."""
    from workshop.mutation import formulas

    chosen = _drawn(formulas.all_mutants(), options, 10**6)
    if todo := [m for m in chosen if m.key not in known]:
        for mutant, result in formulas.judged(todo, 300, options.jobs):
            if not write_verdict(mutant, result):
                break
    return chosen


def judge_engines(
    options: argparse.Namespace, known: Known, write_verdict: Callable[[Mutant, dict[str, Any]], bool]
) -> list[Mutant]:
    """Judge the mutants of engines; returns all that were drawn."""
    from workshop.mutation import engines

    everything = engines.all_mutants()
    if options.witnesses:
        witnesses = engines.Witnesses()
        chosen = _drawn([m for m in everything if m.key in witnesses.recorded], options, 60)
        engines.judged(
            engines.Judge(chosen, witnesses, options.budget, options.jobs), write_verdict, witnesses.files(chosen)
        )
        return chosen
    if options.edited:
        witnesses = engines.Witnesses()
        again = witnesses.of_edited(m for m in everything if m.key not in known)
        chosen = _drawn(again, options, 10**6)
        engines.judged(
            engines.Judge(chosen, witnesses, options.budget, options.jobs), write_verdict, witnesses.files(chosen)
        )
        return [m for m in chosen if known.get(m.key, {}).get("verdict") == "killed"]
    chosen = _drawn(everything, options, 500)
    todo = [m for m in chosen if m.key not in known]
    if not todo:
        return chosen
    if not MAP.is_file():
        print("which tests execute what: the suite runs once under coverage", flush=True)
        subprocess.run(
            [sys.executable, "-m", "pytest", "-q", "-p", "workshop.mutation.coverage_map"], cwd=ROOT, check=False
        )
    tests = engines.Tests()
    tests.learn((m, known[m.key]) for m in everything if m.key in known)

    def learned(mutant: Mutant, result: dict[str, Any]) -> bool:
        tests.learn([(mutant, result)])
        return write_verdict(mutant, result)

    engines.judged(engines.Judge(todo, tests, options.budget, options.jobs), learned, tests.files)
    return chosen


def record(known: Known) -> int:
    """Write which test detected which mutant, for samples, and the table of the page."""
    from workshop.mutation import engines

    everything = engines.all_mutants()
    witnesses = engines.recorded(everything, known)
    engines.WITNESSES.write_text(json.dumps(witnesses, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
    print(f"{len(witnesses)} mutants, each with a test that detects it, in {engines.WITNESSES.relative_to(ROOT)}")
    before, rest = PAGE.read_text(encoding="utf-8").split(BEGIN)
    written, after = rest.split(END)
    named = Counter(room_of(key) for key in still_open())
    rows, kept = merged(counted(known), read_rows(written), named, date.today().isoformat())
    OPEN.write_text(json.dumps(open_here(known), ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
    PAGE.write_text(before + BEGIN + "\n".join(lines(rows)) + "\n" + END + after, encoding="utf-8")
    for room in kept:
        print(f"kept as of {rows[room][0]}: {room}, of which verdicts are missing on this machine")
    return 0


def still_open() -> dict[str, str]:
    """The open mutants of the last record, by their keys."""
    return dict(json.loads(OPEN.read_text(encoding="utf-8"))) if OPEN.is_file() else {}


def open_here(known: Known) -> dict[str, str]:
    """The mutants that nothing noticed and nothing explains, as they are known now."""
    from workshop.mutation import engines, formulas

    why, before, found = explained(), still_open(), {}
    for mutant in (*formulas.all_mutants(), *engines.all_mutants()):
        verdict = known[mutant.key]["verdict"] if mutant.key in known else "survived" if mutant.key in before else ""
        if verdict and verdict not in HARMLESS and not is_explained(mutant, why):
            found[mutant.key] = mutant.name
    return found


def room_of(file: str) -> str:
    """The room of a file, or of the key of a mutant: for a paper with its folder."""
    return "/".join(Path(file.partition(":")[0]).parts[1 : 3 if "/papers/" in file else 2])


def table(known: Known) -> int:
    """The verdicts on all functions as they are now, package by package, whatever was drawn."""
    print("\n".join(lines({room: (date.today().isoformat(), counts) for room, counts in counted(known).items()})))
    return 0


def counted(known: Known) -> Rooms:
    """The verdicts by room. They include mutants recorded as detected by earlier runs, and those that are explained."""
    from workshop.mutation import engines, formulas

    why, witnesses, left = explained(), engines.Witnesses().recorded, still_open()
    rooms: Rooms = {}
    # the judged mutants first: an explanation that applies to none of them is counted once, though it may apply to
    # several
    everything = sorted((*formulas.all_mutants(), *engines.all_mutants()), key=lambda m: m.key not in known)
    seen = set()
    for mutant in everything:
        verdict = known.get(mutant.key, {}).get("verdict") or ("killed" if mutant.key in witnesses else "")
        verdict = verdict or ("survived" if mutant.key in left else "")
        if verdict not in ("", "killed") and is_explained(mutant, why):
            verdict = "explained"
            seen.add(mutant.stable)
        if not verdict and mutant.stable in why and mutant.stable not in seen:
            verdict = "explained"
            seen.add(mutant.stable)
        room = rooms.setdefault(room_of(mutant.file), Counter())
        if verdict:
            room[verdict] += 1
    return rooms


def merged(here: Rooms, on_page: Rows, named: Counter[str], today: str) -> tuple[Rows, list[str]]:
    """The rows to be written, and the rooms whose row on the page is kept: those of which fewer mutants were judged
    here, or open ones are not known by `named`, which counts the open mutants of the last record by room. A room that
    does not exist any more is left out.
    """
    rows = {room: (today, counts) for room, counts in here.items() if counts}

    def loses(room: str, counts: Counter[str]) -> bool:
        unknown = counts["survived"] - named[room]
        return here[room].total() < counts.total() or (unknown > 0 and here[room]["survived"] < unknown)

    kept = [room for room, (_, counts) in on_page.items() if room in here and loses(room, counts)]
    return rows | {room: on_page[room] for room in kept}, kept


def read_rows(written: str) -> Rows:
    """The rows of a table, without its sums."""
    rows: Rows = {}
    for line in written.splitlines():
        room, *cells = (cell.strip() for cell in line.strip("| ").split("|"))
        if len(cells) == len(COLUMNS) - 1 and cells[0].isdecimal() and not room.startswith("**"):
            _, killed, equivalent, explained_, remaining = map(int, cells[:5])
            of = Counter(killed=killed, equivalent=equivalent, explained=explained_, survived=remaining)
            rows[room] = cells[-1], +of
    return rows


def lines(rows: Rows) -> list[str]:
    """The table of the page."""
    text = ["| " + " | ".join(COLUMNS) + " |", "|---" * len(COLUMNS) + "|"]
    for name, of in (("formulas", "papers/"), ("engines", "")):
        mine = {room: row for room, row in sorted(rows.items()) if room.startswith("papers/") == bool(of)}
        text += [_row(room, *row) for room, row in mine.items()]
        text.append(_row(f"**all {name}**", "", sum((counts for _, counts in mine.values()), Counter())))
    return text


def _row(name: str, day: str, counts: Counter[str]) -> str:
    judged = counts.total()
    real = judged - counts["equivalent"] - counts["explained"]
    cells = judged, counts["killed"], counts["equivalent"], counts["explained"], real - counts["killed"]
    score = f"{100 * counts['killed'] / real:.1f} %" if real else "–"
    return f"| {name} | " + " | ".join(map(str, cells)) + f" | {score} | {day} |"


def _drawn(mutants: list[Mutant], options: argparse.Namespace, most: int) -> list[Mutant]:
    parts = options.file.split(",")
    if options.again:
        why = explained()
        mutants = [m for m in mutants if m.key in options.once_more and not is_explained(m, why)]
    return drawn(
        [m for m in mutants if any(part in m.file for part in parts) and options.function in m.function],
        options.sample or most,
        options.seed,
    )


def report(chosen: list[Mutant], known: Known, *, by_score: bool) -> int:
    """Print the score and the unexplained survivors."""
    why = explained()
    judged = [m for m in chosen if m.key in known]
    scores = []
    for sort in ("papers", "engines"):
        mine = [m for m in judged if ("/papers/" in m.file) == (sort == "papers")]
        if not mine:
            continue
        counts = Counter(known[m.key]["verdict"] for m in mine)
        accounted = sum(known[m.key]["verdict"] == "survived" and is_explained(m, why) for m in mine)
        real = len(mine) - counts["equivalent"] - accounted
        words = ", ".join(f"{n} {verdict}" for verdict, n in sorted(counts.items()))
        scores.append(100 * counts["killed"] / real if real else 100.0)
        print(
            f"{sort}: {len(mine)} mutants: {words} ({accounted} of the survivors explained); score {scores[-1]:.1f} %"
        )
    unexplained = [m for m in judged if known[m.key]["verdict"] not in HARMLESS and not is_explained(m, why)]
    for m in unexplained:
        print(f"{known[m.key]['verdict']}: {m.name} ({known[m.key].get('by', '')})")
    if len(judged) < len(chosen):
        print(f"{len(chosen) - len(judged)} mutants remain: run it again")
    return int(min(scores, default=100) < TARGET if by_score else bool(unexplained))


if __name__ == "__main__":
    sys.exit(main())
