"""Campaigns of claims in a folder, true ones and each of them with one thing changed: what is PROVED must be true."""

from collections import Counter
from pathlib import Path
from tempfile import TemporaryDirectory

from exactspline.papers import load_paper
from exactspline.verification.claims import claims_of
from exactspline.verification.combined import combined
from tests.verification.test_own_paper import written


def judged(formulas, changed, entry, step=1):
    """The verdicts on true and on changed claims, and what is wrong: a changed one that is PROVED, a true one that is
    not, one that is UNDECIDED without a reason. `changed` has the number of each true claim, whether it is true, the
    kind of its argument, the bodies of its formulas, and more; an `entry` has its other fields by the names of these.
    """
    tally, wrong, text, claims, cases = Counter(), [], formulas, [], list(changed)
    for n, (_, _, kind, bodies, *more) in enumerate(cases):
        names = [f"{letter}{n}" for letter in ("left", "right")]
        for name, body in zip(names, bodies, strict=True):
            text += f"@formula('e', on='{kind}')\ndef {name}(c):\n    return {body}\n"
        claims.append({"id": str(n), "statement": "s", "status": "ours", "curve": kind} | entry(names, *more))
    with TemporaryDirectory() as place:
        folder = written(Path(place) / "folder", text, claims)
        for claim, (i, true, *what) in list(zip(claims_of(load_paper(folder)), cases, strict=True))[::step]:
            found = combined(claim)[1]
            tally["true" if true else "changed", str(found.verdict)] += 1
            silent = found.verdict == "UNDECIDED" and found.witness is None
            if silent or (found.verdict == "PROVED") != true:
                wrong.append((i, str(found.verdict), str(found.witness), *what))
    return tally, wrong


def told(tally, wrong):
    """Print both; whether anything is wrong."""
    for (which, verdict), n in sorted(tally.items()):
        print(f"{which}: {verdict} {n}")
    for each in wrong:
        print(*each)
    return bool(wrong)
