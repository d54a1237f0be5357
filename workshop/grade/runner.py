"""Grading: every library on every case, against certified exact answers, each library in a separate process."""

from __future__ import annotations

import gzip
import hashlib
import json
import os
import select
import signal
import subprocess
import sys
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

#: The time limit, in seconds, for all questions to a library about a case.
PATIENCE = 20
#: What takes longer than all other questions is asked for only in every n-th case.
EVERY = {"length": 4, "nearest": 8, "meetings": 8}


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
            text=True,
            start_new_session=True,
        )
        first = self._line(60)
        if first is None:
            self.close()
            raise ImportError(self.library)
        self.version = json.loads(first)["version"]

    def _line(self, seconds: int) -> str | None:
        assert self.process.stdout is not None
        ready, _, _ = select.select([self.process.stdout], [], [], seconds)
        return (self.process.stdout.readline() or None) if ready else None

    def exchange(self, request: Mapping[str, object]) -> dict[str, Any]:
        """What the process replies; where it dies or hangs, it is started again, and the reply is what it `raised`."""
        assert self.process.stdin is not None
        try:
            self.process.stdin.write(json.dumps(request) + "\n")
            self.process.stdin.flush()
            line = self._line(PATIENCE)
        except BrokenPipeError:
            line = None
        if line is not None:
            reply: dict[str, Any] = json.loads(line)
            return reply
        hung = self.process.poll() is None
        self.close()
        self._start()
        return {"raised": f"no answer in {PATIENCE} s" if hung else "the process ended"}

    def ask(self, given: GivenData, questions: list[str]) -> dict[str, Reply]:
        """The replies; where the process dies, the questions are asked again one by one."""
        found = self.exchange({"given": given, "questions": questions})
        if "answers" in found:
            replies: dict[str, Reply] = found["answers"]
            return replies
        if len(questions) == 1:
            return {questions[0]: {"raised": found["raised"]}}
        return {q: reply for one in questions for q, reply in self.ask(given, [one]).items()}

    def close(self) -> None:
        """End the process, and those that it started."""
        with suppress(ProcessLookupError):
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.communicate()


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
