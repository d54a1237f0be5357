"""``python -m reading``: how many spans of each page of the paper are claims, definitions, citations, or decide
nothing; with ``--open`` what a span says that nothing here decides, with ``--slips`` the misprints of notation, with
``--second`` where a second reader of a drawn tenth read something else.
"""

from __future__ import annotations

import argparse
from collections import Counter

from reading.readings import READINGS, counted, readings
from reading.second import second_readings

COLUMNS = ("spans", *READINGS, "slip")


def main() -> None:
    """Print the table, or the spans that are asked for."""
    parser = argparse.ArgumentParser(prog="python -m reading", description=__doc__)
    parser.add_argument("--open", action="store_true", help="what is left undecided, span by span")
    parser.add_argument("--slips", action="store_true", help="misprints of notation, span by span")
    parser.add_argument("--second", action="store_true", help="where a second reader of a tenth read something else")
    asked = parser.parse_args()
    own = readings()
    for name, wanted in (("open", asked.open), ("slip", asked.slips)):
        if wanted:
            print("\n".join(f"{one.place}\n  {one.read[name]}" for one in own if name in one.read))
    if asked.second:
        _print_second()
    if not (asked.open or asked.slips or asked.second):
        rows, total = counted(own), Counter[str]()
        print("page " + " ".join(f"{name:>10}" for name in COLUMNS))
        for page, row in rows.items():
            total += row
            print(f"{page:>4} " + " ".join(f"{row[name]:>10}" for name in COLUMNS))
        print(" all " + " ".join(f"{total[name]:>10}" for name in COLUMNS))


def _print_second() -> None:
    """How many were read alike, and the others with what became of them."""
    theirs = second_readings()
    others = [one for one in theirs if one.outcome]
    print(f"{len(theirs)} spans drawn, {len(theirs) - len(others)} read alike")
    for one in others:
        print(f"p. {one.page}, span {one.order}: {one.states}\n  {one.outcome}: {one.why}")


if __name__ == "__main__":
    main()
