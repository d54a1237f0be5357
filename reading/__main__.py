"""``python -m reading``: how many spans of each page of the paper are claims, definitions, citations, or decide
nothing, how many make claims, and how many of these are decided wholly. With ``--open`` what a span says that nothing
here decides, with ``--slips`` the misprints of notation, with ``--second`` where a second reader of a drawn tenth read
something else, with ``--undecided`` what a reader of spans and claims alone found that the claims did not decide.
"""

from __future__ import annotations

import argparse
from collections import Counter

from reading.readings import READINGS, counted, decided, readings
from reading.second import READ, second_readings, undecided

COLUMNS = ("spans", *READINGS, "slip")


def main() -> None:
    """Print the table, or the spans that are asked for."""
    parser = argparse.ArgumentParser(prog="python -m reading", description=__doc__)
    parser.add_argument("--open", action="store_true", help="what is left undecided, span by span")
    parser.add_argument("--slips", action="store_true", help="misprints of notation, span by span")
    parser.add_argument("--second", action="store_true", help="where a second reader of a tenth read something else")
    parser.add_argument("--undecided", action="store_true", help="what claims did not decide when they were read again")
    asked = parser.parse_args()
    own = readings()
    for name, wanted in (("open", asked.open), ("slip", asked.slips)):
        if wanted:
            print("\n".join(f"{one.place}\n  {one.read[name]}" for one in own if name in one.read))
    if asked.second:
        _print_second()
    if asked.undecided:
        _print_undecided()
    if not (asked.open or asked.slips or asked.second or asked.undecided):
        rows, total = counted(own), Counter[str]()
        print("page " + " ".join(f"{name:>10}" for name in COLUMNS))
        for page, row in rows.items():
            total += row
            print(f"{page:>4} " + " ".join(f"{row[name]:>10}" for name in COLUMNS))
        print(" all " + " ".join(f"{total[name]:>10}" for name in COLUMNS))
        claiming, wholly = decided(own)
        print(f"\n{claiming} spans make claims, which decide {wholly} of them wholly")


def _print_second() -> None:
    """How many were read alike, and the others with what became of them."""
    theirs = second_readings()
    others = [one for one in theirs if one.outcome]
    print(f"{len(theirs)} spans drawn, {len(theirs) - len(others)} read alike")
    for one in others:
        print(f"p. {one.page}, span {one.order}: {one.states}\n  {one.outcome}: {one.why}")


def _print_undecided() -> None:
    """Span by span what was missing, and the claims that decide it now."""
    theirs = undecided()
    neighbours = sum(one.decided == "nothing" for one in theirs)
    print(f"of {READ} spans {READ - len(theirs)} were decided wholly, {len(theirs) - neighbours} in part")
    print(f"{neighbours} not at all: their claims were neighbours")
    for one in theirs:
        print(f"p. {one.page}, span {one.order}, {one.decided}: {one.missing}")
        if one.added:
            print(f"  now {', '.join(one.added)}")


if __name__ == "__main__":
    main()
