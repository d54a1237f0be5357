"""Grading: every library on every case, against certified exact answers, each library in a separate process."""

from __future__ import annotations

import gzip
import hashlib
import json
import os
import random
import select
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from math import isfinite
from pathlib import Path
from typing import Any

from exactspline.atomic_write import write_atomically
from exactspline.numbers.exact import double, text
from exactspline.splines.control_points import lifted
from exactspline.splines.nurbs import Nurbs
from exactspline.testing import VERSION, Case
from workshop.grade.data import Answer, CurveData, GivenData, Reply
from workshop.grade.judge import WRONG, Verdict, judged
from workshop.grade.questions import QUESTIONS
from workshop.grade.recheck import recheck
from workshop.grade.tolerance import tolerated
from workshop.grade.truth import inserted, truth

#: The limit, in seconds of processor time, for a reply; and how many times as long, by the clock, it is waited for.
PATIENCE, WAITING = 5, 20
#: How often it is looked, in seconds.
GLANCE = 0.5
#: What takes longer than all other questions is asked for only in every n-th case.
EVERY = {"length": 4, "nearest": 8, "distance": 8, "meetings": 8}


@dataclass(frozen=True)
class Judged:
    """A verdict on one library's answer to one question about one case."""

    case: Case
    question: str
    verdict: Verdict
    #: What the library replied and what is true, kept where the reply is wrong.
    reply: Reply | None = None
    answer: Answer | None = None


@dataclass
class Report:
    """A library's verdicts."""

    library: str
    version: str
    judged: list[Judged] = field(default_factory=list)
    #: Questions excluded because their exact answer could not be certified.
    uncertified: int = 0


def questions_for(case: Case, number: int) -> list[str]:
    """The questions about a case."""
    return [q for q in QUESTIONS if number % EVERY.get(q, 1) == 0 or case.family == "named"]


def sample(cases: Iterable[Case], share: float) -> Iterator[Case]:
    """Each case with a probability, the same ones at each run; those of bug reports always.

    >>> from exactspline.testing import all_cases
    >>> sum(1 for _ in sample(all_cases(10), 0)), sum(1 for _ in sample(all_cases(10), 1))
    (10, 60)
    """
    chance = random.Random(VERSION)
    for case in cases:
        if chance.random() < share or case.family == "named":
            yield case


def given_data(curve: Nurbs, case: Case) -> GivenData:
    """A curve as it is passed to a library."""
    return {
        "degree": curve.degree,
        "knots": [double(t) for t in curve.knots],
        "points": [[double(x) for x in p] for p in curve.control_points],
        "weights": None if curve.polynomial else [double(w) for w in curve.weights],
        "t": double(case.parameter),
    }


def request_data(case: Case) -> GivenData:
    """A case as it is passed to a library."""
    finer = inserted(case)
    return {
        **given_data(case.curve, case),
        "finer": None if finer is None else given_data(finer, case),
        "partner": given_data(case.partner, case),
        "point": [double(x) for x in case.point],
    }


def curve_data(case: Case) -> CurveData:
    """A curve as it is passed to the independent checker."""
    curve, partner = case.curve, case.partner
    return {
        "degree": curve.degree,
        "knots": [text(t) for t in curve.knots],
        "rows": _homogeneous(curve),
        "rational": not curve.polynomial,
        "partner": _homogeneous(partner),
    }


def _homogeneous(curve: Nurbs) -> list[list[str]]:
    points = zip(curve.control_points, curve.weights, strict=True)
    return [[text(x) for x in (*lifted(p, w), w)] for p, w in points]


class Truths:
    """Exact answers, stored in a file with their certificates; each is checked again whenever it is used.

    An answer that the checker rejects is not used (`uncertified`).
    """

    def __init__(self, place: Path | None) -> None:
        self.place, self.known, self.grown = place, dict[str, dict[str, Answer | None]](), False
        self.uncertified: list[tuple[str, str, str]] = []
        if place is not None and place.exists():
            with gzip.open(place, "rt", encoding="utf-8") as stream:
                for line in stream:
                    row = json.loads(line)
                    self.known[row["key"]] = row["answers"]

    def of(self, case: Case, questions: Iterable[str]) -> dict[str, Answer]:
        """The certified answers to the questions that apply to a case."""
        curve = curve_data(case)
        key = hashlib.sha256(json.dumps([VERSION, curve, text(case.parameter)]).encode()).hexdigest()
        answers = self.known.setdefault(key, {})
        certified = {}
        for question in questions:
            if question not in answers:
                answers[question], self.grown = truth(case, question), True
            answer = answers[question]
            if answer is None:
                continue
            try:
                recheck(curve, text(case.parameter), question, answer)
                certified[question] = answer
            except (ValueError, ArithmeticError) as error:
                self.uncertified.append((case.key, question, str(error)))
        return certified

    def save(self) -> None:
        """Write the answers to the file."""
        if self.place is None or not self.grown:
            return
        self.place.parent.mkdir(parents=True, exist_ok=True)
        lines = "".join(json.dumps({"key": k, "answers": a}) + "\n" for k, a in self.known.items())
        data = gzip.compress(lines.encode(), 6, mtime=0)
        write_atomically(self.place, lambda stream: stream.write(data))


class Worker:
    """A library's process, started again when it ends or hangs."""

    def __init__(self, library: str, command: Sequence[str] = ()) -> None:
        self.library, self.version = library, ""
        self.command = command or (sys.executable, "-m", "workshop.grade.worker", library)
        self._start()

    def _start(self) -> None:
        # a group of its own: a library may run in a process that this one starts
        self.process = subprocess.Popen(
            self.command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )
        self.received = b""
        first = self._line(WAITING * PATIENCE)
        if first is None:
            self.close()
            raise ImportError(self.library)
        self.version = json.loads(first)["version"]

    def _line(self, seconds: float = PATIENCE) -> bytes | None:
        """The next line of the process, None where it ended or did not write one in time."""
        assert self.process.stdout is not None
        used, start = None, time.monotonic()
        while b"\n" not in self.received:
            ready, _, _ = select.select([self.process.stdout], [], [], GLANCE)
            if ready:
                more = os.read(self.process.stdout.fileno(), 1 << 16)
                if not more:
                    return None
                self.received += more
                continue
            now = _processor_time(self.process.pid)
            used = now if used is None else used
            if now - used > seconds or time.monotonic() - start > WAITING * seconds:
                return None
        line, _, self.received = self.received.partition(b"\n")
        return line

    def _send(self, request: Mapping[str, object]) -> None:
        assert self.process.stdin is not None
        # one that has ended is noticed where its reply is read
        with suppress(BrokenPipeError):
            self.process.stdin.write(json.dumps(request).encode() + b"\n")
            self.process.stdin.flush()

    def _ended(self) -> Reply:
        """Start the process again, which died or hangs; what is said of the question that it did not answer."""
        hung = self.process.poll() is None
        self.close()
        self._start()
        return {"late": f"no reply within {PATIENCE} s"} if hung else {"raised": "the process ended"}

    def exchange(self, request: Mapping[str, object]) -> dict[str, Any]:
        """The single line that the process replies, or that there is none."""
        self._send(request)
        line = self._line()
        return dict(self._ended()) if line is None else dict(json.loads(line))

    def ask(self, given: GivenData, questions: Sequence[str]) -> dict[str, Reply]:
        """The replies to those of the questions that the library answers; after one that it dies of, the rest."""
        replies, remaining = dict[str, Reply](), list(questions)
        self._send({"given": given, "questions": remaining})
        while remaining:
            question, line = remaining.pop(0), self._line()
            if line is None:
                replies[question] = self._ended()
                self._send({"given": given, "questions": remaining})
            elif (reply := json.loads(line)) is not None:
                replies[question] = reply
        return replies

    def close(self) -> None:
        """End the process, and those that it started."""
        with suppress(ProcessLookupError):
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.communicate()


def _processor_time(session: int) -> float:
    """The seconds that the processes of a session have used; those of the clock where that is not to be had."""
    if not _PROCESSES.exists():
        return time.monotonic()
    ticks = 0
    for place in _PROCESSES.glob("[0-9]*/stat"):
        with suppress(OSError):
            fields = place.read_text(encoding="utf-8", errors="replace").rpartition(")")[2].split()
            # the numbers of proc(5), which are those of the fields plus 3: the session, and what was used
            ticks += sum(map(int, fields[11:15])) if int(fields[3]) == session else 0
    return ticks / os.sysconf("SC_CLK_TCK")


_PROCESSES = Path("/proc")


def failures(reports: Iterable[Report]) -> Iterator[dict[str, object]]:
    """Every wrong answer: what the library was given, its reply, and the certified answer."""
    for report in reports:
        for one in report.judged:
            if one.verdict.outcome in WRONG:
                yield {
                    "library": report.library,
                    "version": report.version,
                    "case": one.case.key,
                    "family": one.case.family,
                    "note": one.case.note,
                    "link": one.case.link,
                    "question": one.question,
                    "given": request_data(one.case),
                    "reply": one.reply,
                    "truth": one.answer,
                    "outcome": one.verdict.outcome,
                    "ulps": one.verdict.ulps if isfinite(one.verdict.ulps) else None,
                    "why": one.verdict.note,
                }


def grade(
    libraries: Iterable[str], cases: Iterable[Case], place: Path | None = None, tick: Callable[[], None] = lambda: None
) -> tuple[list[Report], Truths]:
    """The reports of the installed libraries, and the exact answers with which they were compared."""
    workers = []
    for library in libraries:
        try:
            workers.append(Worker(library))
        except ImportError:
            continue
    reports = [Report(worker.library, worker.version) for worker in workers]
    truths = Truths(place)
    try:
        for number, case in enumerate(cases):
            answers = truths.of(case, questions_for(case, number))
            given, asked = request_data(case), list(answers)
            for worker, report in zip(workers, reports, strict=True):
                for question, reply in worker.ask(given, asked).items():
                    verdict = judged(case, question, answers[question], reply)
                    verdict = tolerated(worker.library, case, question, verdict, answers[question], reply.get("answer"))
                    kept = (reply, answers[question]) if verdict.outcome in WRONG else ()
                    report.judged.append(Judged(case, question, verdict, *kept))
            tick()
    finally:
        for worker in workers:
            worker.close()
        truths.save()
    return reports, truths
