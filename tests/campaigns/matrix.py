"""The matrix, long: words of one to three changes at random, all questions of the registry after each, also those that
take long.

python -m tests.campaigns.matrix COUNT SEED

Prints each failure with its shortest word, and the numbers of cells, of exemptions, of words, of answers compared and
of failures; then by how much questions take longer per segment after knots are inserted, of which more than three times
is a failure. Fewer words are about surfaces, maps and pairs, whose questions take longer.
"""

import sys
import time
from collections import Counter
from itertools import pairwise
from random import Random

from exactspline.questions.entry import Of
from tests.support.changes import curve_from, inserted, rows_of
from tests.support.drawn import DRAWN
from tests.support.matrix import Counts, ask, cells, exempt_cells, given_to, questions, run_word
from tests.support.paths import again

SEED = 2028
#: Of a hundred words, how many are about which kind of object.
SHARES = {Of.PLANE_CURVE: 48, Of.SPACE_CURVE: 28, Of.TWO_CURVES: 4, Of.PAIR: 4, Of.SURFACE: 6, Of.PLANAR_MAP: 8}
SHARES |= {Of.REGION: 2}
KINDS = [of for of, share in SHARES.items() for _ in range(share)]
#: What takes long is asked once in this many hundreds of words: ridges take about a minute.
DEAR = {Of.SURFACE: 33, Of.TWO_CURVES: 1, Of.PLANE_CURVE: 1}
#: Knots that are inserted into each segment, and by which factor a segment may take longer then.
INSERTED, MOST = 7, 3


def campaign(count, seed=SEED, told=print):
    """What was run, and what differed: a failure is told as soon as it is found."""
    counts, known = Counts(), 0
    for i in range(count):
        random = Random(f"{seed} {i}")
        hundred, k = divmod(i, len(KINDS))
        of = KINDS[k]
        run_word(of, random, counts, dear=of in DEAR and k == KINDS.index(of) and hundred % DEAR[of] == 0)
        for failure in counts.failures[known:]:
            told(f"word {i} of {count}, seed {seed}: {failure}")
        known = len(counts.failures)
    return counts


def with_many_knots(curve):
    """The same curve with knots in each segment, at a seventh and so on."""
    rows = rows_of(curve)
    for low, high in pairwise(rows.breaks):
        for n in range(1, INSERTED + 1):
            rows = inserted(rows, low + (high - low) * n / (INSERTED + 1))
    return curve_from(rows)


def slower(count, seed=SEED):
    """How many times as long questions about curves take per segment after knots are inserted."""
    spent = Counter()
    for i in range(count):
        random = Random(f"{seed} knots {i}")
        of = (Of.PLANE_CURVE, Of.SPACE_CURVE)[i % 2]
        curve = DRAWN[of](random)
        for entry in questions(of):
            given = given_to(entry, curve, random)
            for dense in (False, True):
                asked = with_many_knots(curve) if dense else again(curve)
                started = time.process_time()
                ask(asked, entry.name, given)
                spent[entry.name, dense] += (time.process_time() - started) / asked.segments
    return {name: spent[name, True] / spent[name, False] for name, dense in spent if dense}


def main(count, seed):
    """The campaign from the command line."""
    started = time.process_time()
    counts = campaign(count, seed)
    print(f"cells {len(cells())}, exemptions {len(exempt_cells())}, cells compared {len(counts.compared)}")
    print(f"words {counts.words}, answers compared {counts.asked}, failures {len(counts.failures)}")
    print(f"{time.process_time() - started:.0f} s of processor time")
    ratios = slower(max(2, min(count // 10, 100)), seed)
    print("times per segment after knots are inserted: " + ", ".join(f"{k} {x:.1f}" for k, x in ratios.items()))
    slow = [name for name, x in ratios.items() if x > MOST]
    print(f"more than {MOST} times: {', '.join(slow) or 'none'}")
    return 1 if counts.failures or slow else 0


if __name__ == "__main__":
    given = (*sys.argv[1:], *("1000", str(SEED))[len(sys.argv) - 1 :])
    sys.exit(main(*map(int, given[:2])))
