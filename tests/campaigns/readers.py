"""Damaged files by the hundred thousand: ``python -m tests.campaigns.readers --runs 80000 step svg``.

Every run changes a seed or a kept file at random and reads it. A run fails when anything but an `ExactSplineError`
comes out, when it takes more than two seconds of processor time, or when the process needs a gigabyte more than at
its start. A file that makes a reader say something new is kept in ``tests/corpus/FORMAT``, as long as it is small.
"""

import argparse
import gc
import hashlib
import json
import os
import random
import re
import resource
import signal
import sys
import time
import traceback
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from unittest import mock

from exactspline.errors import CurveFileError, ExactSplineError
from exactspline.extras.cad import rhino, rhino_process
from exactspline.interchange import read
from exactspline.interchange.files import encoded
from exactspline.interchange.records import Source
from tests.support.interchange_seeds import CURVES, cff, seeds, truetype

CORPUS = Path(__file__).parents[1] / "corpus"
SECONDS, MEMORY = 2, 1 << 30
#: Seconds of processor time that rhino3dm has for an archive: many times what a sound one takes, also where other
#: programs run, and less than one that never ends.
PATIENCE = 1.0
#: Files kept for a format, and bytes of a kept file, at most.
KEPT, SMALL = 30, 2500

NASTY = [
    *b"0 -1 1e999999999 1e400 -1e-400 99999999 999999999999999999 nan inf 1/0 - 0x1p99999 1.5.5 1e 100 7 2 50".split(),
    *b"[ ]]]]]]]]] \" ' /* &a; #1 1H, 999999H NaN ; , \0 \xff\xfe".split(),
    *(b"(" * 200, b"{" * 99, b"<g>" * 99, b"1" * 3000, b"<!DOCTYPE x [<!ENTITY a '&b;'>]>"),
    *("٣".encode(), "é".encode(), b"\r\n", b"\n", b" "),
]
WORD = re.compile(rb"[\w.+-]+")
_DETAIL = re.compile(r"\d+|'[^']*'|\"[^\"]*\"")


class TooLong(BaseException):
    """A run that takes too long."""


def archives() -> list[bytes]:
    """Archives of rhino3dm, one by one and with several curves; none where it is not installed."""
    if find_spec("rhino3dm") is None:
        return []
    return [encoded(curves, "3dm", rounding=True)[0] for curves in (*([c] for c in CURVES), CURVES)]


def address_space() -> int:
    """Bytes that this process has addresses for."""
    return int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()


def entries_by_fork(source: Source) -> list[dict[str, Any]]:
    """What `rhino._entries` gives, from a fork of this process, which has rhino3dm loaded: ten times as
    fast. On a damaged archive rhino3dm may not come back: it has a second of its own processor time here, and
    two there. Its limit of memory is counted from what this process has.
    """
    ours, theirs = os.pipe()
    child = os.fork()
    if not child:
        # the exit of a fork runs nothing of its parent's, and what that has in memory is not its to clear away
        gc.disable()
        try:
            signal.setitimer(signal.ITIMER_PROF, PATIENCE)
            os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
            rhino_process.MEMORY += address_space()
            with open(theirs, "w") as pipe:
                json.dump(rhino_process.entries(source.data, SECONDS), pipe)
        except BaseException:
            os._exit(1)
        os._exit(0)
    os.close(theirs)
    with open(ours) as pipe:
        answer = pipe.read()
    if os.waitpid(child, 0)[1]:
        raise CurveFileError("is not an archive readable by rhino3dm", remedy="repair the file")
    found: list[dict[str, Any]] = json.loads(answer)
    return found


def originals() -> dict[str, list[bytes]]:
    """What is changed, by the name of the format; the kept files of earlier runs are among it."""
    found = seeds() | {"font": [truetype(), cff()]}
    if made := archives():
        found["3dm"] = made
    for name in found:
        found[name] += [path.read_bytes() for path in sorted((CORPUS / name).glob("*"))]
    return found


def changed(data: bytes, chance: random.Random, others: list[bytes]) -> bytes:
    """A file with words replaced, bytes changed, pieces cut out, doubled, or taken from another file."""
    for _ in range(chance.randrange(1, 5)):
        kind = chance.choice(("word", "word", "word", "swap", "byte", "cut", "double", "insert", "truncate", "cross"))
        if kind in ("word", "swap"):
            words = list(WORD.finditer(data))
            if words:
                word = chance.choice(words)
                new = chance.choice(NASTY) if kind == "word" else chance.choice(words)[0]
                data = data[: word.start()] + new + data[word.end() :]
            continue
        a, b = sorted(chance.choices(range(len(data) + 1), k=2))
        match kind:
            case "byte":
                data = data[:a] + bytes(chance.choices(range(256), k=chance.randrange(4))) + data[a + 1 :]
            case "cut":
                data = data[:a] + data[b:]
            case "double":
                data = data[:b] + data[a:b] + data[b:]
            case "insert":
                data = data[:a] + chance.choice(NASTY) + data[a:]
            case "truncate":
                data = data[:b]
            case _:
                other = chance.choice(others)
                data = data[:a] + other[chance.randrange(len(other) + 1) :]
    return data


def said(data: bytes, name: str) -> str:
    """What a reader says to a file, without its numbers; whatever is not an answer goes through."""
    try:
        reading = read(data, name)
    except ExactSplineError as error:
        return "refused: " + _DETAIL.sub("…", error.problem)
    for named in reading.curves:
        assert len(named.curve.control_points) == len(named.curve.knots) - named.curve.degree - 1
    return "read: " + " ".join(sorted({_DETAIL.sub("…", f"{s.what}: {s.why}") for s in reading.skipped}))[:300]


def _stop(*_: object) -> None:
    raise TooLong


@mock.patch.object(rhino, "_entries", entries_by_fork)
def fuzz(name: str, runs: int, seed: int, keep: bool) -> tuple[int, int, float]:
    """Failures in this many runs, how many were read, and the longest of them in seconds of processor time."""
    chance, files = random.Random(f"{name} {seed}"), originals()[name]
    answers = [said(data, name) for data in files]
    whole = [data for data, answer in zip(files, answers, strict=True) if answer.startswith("read")]
    assert whole, f"{name}: none of the files that are changed is read"
    known = set(answers)
    kept, failures, good, longest = len(list((CORPUS / name).glob("*"))), 0, 0, 0.0
    signal.signal(signal.SIGVTALRM, _stop)
    for _ in range(runs):
        # every second time from a whole file: what was damaged before is seldom read far
        data = changed(chance.choice(files if chance.random() < 0.5 else whole), chance, files)
        start = time.process_time()
        signal.setitimer(signal.ITIMER_VIRTUAL, SECONDS)
        try:
            answer = said(data, name)
        except (Exception, TooLong):
            signal.setitimer(signal.ITIMER_VIRTUAL, 0)
            failures += 1
            place = Path(f"fuzz-failure-{name}-{failures}")
            place.write_bytes(data)
            sys.stdout.write(f"{name}: {place}\n{traceback.format_exc()}\n")
            continue
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        good += answer.startswith("read")
        longest = max(longest, time.process_time() - start)
        if answer not in known:
            known.add(answer)
            if len(data) <= SMALL:
                files.append(data)
                if keep and kept < KEPT:
                    kept += 1
                    (CORPUS / name).mkdir(parents=True, exist_ok=True)
                    (CORPUS / name / hashlib.sha256(data).hexdigest()[:12]).write_bytes(data)
    return failures, good, longest


def main() -> int:
    """All formats named, one after the other; the exit status tells whether a run failed."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("formats", nargs="*")
    parser.add_argument("--runs", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--keep", action="store_true", help="keep files that make a reader say something new")
    options = parser.parse_args()
    names = options.formats or sorted(originals())
    resource.setrlimit(resource.RLIMIT_AS, (address_space() + MEMORY, resource.RLIM_INFINITY))
    failed = 0
    for name in names:
        start = time.process_time()
        failures, good, longest = fuzz(name, options.runs, options.seed, options.keep)
        failed += failures
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss >> 10
        spent = time.process_time() - start
        sys.stdout.write(
            f"{name}: {options.runs} runs in {spent:.0f} s, {good} of them read, {failures} failures, "
            f"longest {longest:.2f} s, "
            f"{peak} MB at most\n"
        )
        sys.stdout.flush()
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
