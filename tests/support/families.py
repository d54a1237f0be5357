"""Campaigns that draw cases of families, each with a dial from small integers to doubles: their command."""

import argparse
import time
from collections import Counter
from itertools import product

from exactspline.errors import ReachError

#: What stands in the place of a difference where an answer is refused, is left open or is not judged: counted, and no
#: error.
REFUSED = ("ShapeError", "ReachError", "left out", "open", "not judged")
#: Seconds of processor time after which a case is named.
SLOW = 10


def by_families(doc, families, dials, differs, arguments, *, in_turn=False, ceiling=None):
    """Whether anything differs: COUNT cases of each family and dial, or of each family, the dials `in_turn`; or more of
    a family is refused than `ceiling` per mille.
    """
    parser = argparse.ArgumentParser(description=doc.splitlines()[0])
    parser.add_argument(
        "count", type=int, help="cases of each family" + (", the dials in turn" if in_turn else " and dial")
    )
    parser.add_argument("seed", type=int)
    parser.add_argument("--family", choices=families, action="append")
    parser.add_argument("--dial", choices=dials, action="append")
    given = parser.parse_args(arguments)
    wrong, dials, seeds = 0, given.dial or list(dials), range(given.seed, given.seed + given.count)
    for family in given.family or families:
        counts = Counter()
        for dial, k in ((dials[k % len(dials)], k) for k in seeds) if in_turn else product(dials, seeds):
            begun = time.process_time()
            try:
                difference = differs(family, dial, k)
            except ReachError as error:
                difference = type(error).__name__
            seconds = time.process_time() - begun
            kind = difference if difference in REFUSED else "wrong" if difference else "right"
            counts[kind] += 1
            if kind == "wrong" or seconds > SLOW:
                print(f"{family}, {dial}, {k}: {difference}, {seconds:.1f} s", flush=True)
        wrong += counts["wrong"]
        if ceiling is not None:
            wrong += 1000 * sum(counts[kind] for kind in REFUSED) > ceiling * counts.total()
        print(family, dict(counts), flush=True)
    return bool(wrong)
