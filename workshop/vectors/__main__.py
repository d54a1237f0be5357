"""``python -m workshop.vectors``: curves with exact answers, as plain JSON; more curves of a family; a check.

``pack FOLDER`` writes all families and an index, ``corpus --family near --count 1000 FILE`` one file of as many cases
as asked for, ``check FOLDER`` recomputes a tenth. Exit status: 0 written or right; 1 an answer is wrong; 2 bad input.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections import Counter
from collections.abc import Sequence
from hashlib import sha256
from pathlib import Path

from exactspline.atomic_write import write_text
from exactspline.testing.families import FAMILIES
from exactspline.testing.families import VERSION as SEED
from workshop.printing import ended
from workshop.vectors.check import checked
from workshop.vectors.corpus import SIZES, corpus
from workshop.vectors.pack import VERSION, write_pack


def arguments(given: Sequence[str] | None) -> argparse.Namespace:
    """The parsed command line."""
    parser = argparse.ArgumentParser(
        prog="python -m workshop.vectors", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    commands = parser.add_subparsers(dest="command", required=True)
    pack = commands.add_parser("pack", help="write all families")
    pack.add_argument("folder", metavar="FOLDER", type=Path)
    pack.add_argument("--cases", metavar="N", type=int, default=0, help="at most N of each family; 0 for all")
    more = commands.add_parser("corpus", help="write cases of one family")
    more.add_argument("file", metavar="FILE", type=Path)
    more.add_argument("--family", choices=sorted(FAMILIES), default="near")
    more.add_argument("--count", metavar="N", type=int, default=1000)
    more.add_argument("--seed", metavar="N", type=int, default=SEED)
    again = commands.add_parser("check", help="recompute a sample")
    again.add_argument("folder", metavar="FOLDER", type=Path)
    again.add_argument("--share", metavar="X", type=float, default=0.1)
    again.add_argument("--seed", metavar="N", type=int, default=1)
    return parser.parse_args(given)


def main(given: Sequence[str] | None = None) -> int:
    """Write or check; returns the exit status."""
    options = arguments(given)
    if options.command == "corpus":
        count = write_pack(options.file, options.family, corpus(options.family, options.count, options.seed))
        print(f"{count} cases of {options.family}")
        return 0
    return _pack(options.folder, options.cases) if options.command == "pack" else _check(options)


def _pack(folder: Path, limit: int) -> int:
    folder.mkdir(parents=True, exist_ok=True)
    files = {}
    for family, size in SIZES.items():
        place = folder / f"{family}.json"
        count = write_pack(place, family, corpus(family, min(size, limit or size)))
        files[family] = {"file": place.name, "cases": count, "sha256": sha256(place.read_bytes()).hexdigest()}
        print(f"{count} cases of {family}")
    index = {"schema": "exactspline/vectors index", "version": VERSION, "seed": SEED, "families": files}
    write_text(folder / "index.json", json.dumps(index, indent=1) + "\n")
    return 0


def _check(options: argparse.Namespace) -> int:
    index = json.loads((options.folder / "index.json").read_text(encoding="utf-8"))
    right, given = Counter[str](), Counter[str]()
    for family, entry in index["families"].items():
        place = options.folder / entry["file"]
        if sha256(place.read_bytes()).hexdigest() != entry["sha256"]:
            sys.stderr.write(f"{place}: another digest\n")
            return 1
        try:
            cases, own, asked = checked(place, options.share, options.seed)
        except ValueError as error:
            sys.stderr.write(f"{place}: {error}\n")
            return 1
        print(f"{family}: {cases} cases, {own.total()} answers right")
        right, given = right + own, given + asked
    print("checked, of those that there are:")
    for question in given:
        print(f"  {question}: {right[question]} of {given[question]}")
    return 0


if __name__ == "__main__":
    sys.exit(ended(main))
