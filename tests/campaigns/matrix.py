"""The matrix, long: words of one to three changes at random, all questions of the registry after each, also those that
take long.

python -m tests.campaigns.matrix COUNT SEED

Prints each failure with its shortest word, and the numbers of cells, of exemptions, of words, of answers compared and
of failures. Fewer words are about surfaces, maps and pairs, whose questions take longer.
"""

import sys
import time
from random import Random

from exactspline.questions.entry import Of
from tests.support.matrix import Counts, cells, exempt_cells, run_word

SEED = 2028
#: Of a hundred words, how many are about which kind of object.
SHARES = {Of.PLANE_CURVE: 50, Of.SPACE_CURVE: 30, Of.TWO_CURVES: 4, Of.SURFACE: 6, Of.PLANAR_MAP: 10}
KINDS = [of for of, share in SHARES.items() for _ in range(share)]
#: Ridges take about a minute: they are asked of one of 200 surfaces.
DEAR = 200


def campaign(count, seed=SEED, told=print):
    """What was run, and what differed: a failure is told as soon as it is found."""
    counts, known = Counts(), 0
    for i in range(count):
        random = Random(f"{seed} {i}")
        of = KINDS[i % len(KINDS)]
        run_word(of, random, counts, dear=i % (DEAR * len(KINDS)) == KINDS.index(of))
        for failure in counts.failures[known:]:
            told(f"word {i} of {count}, seed {seed}: {failure}")
        known = len(counts.failures)
    return counts


def main(count, seed):
    """The campaign from the command line."""
    started = time.process_time()
    counts = campaign(count, seed)
    print(f"cells {len(cells())}, exemptions {len(exempt_cells())}, cells compared {len(counts.compared)}")
    print(f"words {counts.words}, answers compared {counts.asked}, failures {len(counts.failures)}")
    print(f"{time.process_time() - started:.0f} s of processor time")
    return 1 if counts.failures else 0


if __name__ == "__main__":
    given = (*sys.argv[1:], *("1000", str(SEED))[len(sys.argv) - 1 :])
    sys.exit(main(*map(int, given[:2])))
