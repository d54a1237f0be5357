"""The results of grading: as data, and as the page in the documentation."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from pathlib import Path

from exactspline.display.plot.canvas import BLACK, BLUE, ORANGE, PAGE, PURPLE, SILVER, SKY, VERMILLION, new_figure, save
from exactspline.errors import counted
from exactspline.numbers.exact import double, mpq, text
from exactspline.testing import VERSION, Case, all_cases
from workshop.grade.judge import CRASHED, DECLINED, INVENTED, LATE, MISSED, OFF, OUTCOMES, RIGHT, TOLERATED, WRONG
from workshop.grade.questions import QUESTIONS, TOLERANCES
from workshop.grade.runner import EVERY, PATIENCE, Judged, Report
from workshop.grade.shrink import Defect
from workshop.grade.tolerance import DOCUMENTED


def rows(reports: Sequence[Report], defects: Sequence[Defect]) -> list[dict[str, object]]:
    """One row per library and question."""
    examples = {(d.library, d.question): d for d in reversed(defects)}
    data: list[dict[str, object]] = []
    for report in reports:
        for question in QUESTIONS:
            asked = [one for one in report.judged if one.question == question]
            if not asked:
                continue
            found = Counter(one.verdict.outcome for one in asked)
            defect = examples.get((report.library, question))
            data.append(
                {
                    "key": f"{report.library}: {question}",
                    "library": report.library,
                    "version": report.version,
                    "question": question,
                    "asked": len(asked),
                    **{outcome: found[outcome] for outcome in OUTCOMES},
                    "worst_ulps_of_right": max(
                        (j.verdict.ulps for j in asked if j.verdict.outcome == RIGHT), default=0
                    ),
                    "example": None if defect is None else example_data(defect.example),
                }
            )
    return data


def example_data(one: Judged) -> dict[str, object]:
    """An example as a curve file and the parameter, and the answer of the library."""
    curve = one.case.curve
    return {
        "case": one.case.key,
        "degree": curve.degree,
        "knots": [text(t) for t in curve.knots],
        "control_points": [[text(x) for x in p] for p in curve.control_points],
        "weights": None if curve.polynomial else [text(w) for w in curve.weights],
        "parameter": text(one.case.parameter),
        "outcome": one.verdict.outcome,
        "note": one.verdict.note or _ulps(one.verdict.ulps),
        "link": one.case.link,
    }


def _ulps(ulps: float) -> str:
    return f"wrong by {ulps:.3g} ulps"


#: Where the page expects its picture, and the colours there.
PICTURE = "pictures/scoreboard.png"
COLOURS = {
    OFF: VERMILLION,
    MISSED: BLUE,
    INVENTED: ORANGE,
    CRASHED: BLACK,
    DECLINED: SILVER,
    LATE: PURPLE,
    TOLERATED: SKY,
}

#: What is said of one answer, and of several answers, with an outcome.
VERBS = {
    RIGHT: ("is right", "are right"),
    OFF: ("has a wrong value", "have a wrong value"),
    MISSED: ("lacks a parameter", "lack a parameter"),
    INVENTED: ("invents a parameter", "invent a parameter"),
    CRASHED: ("crashed", "crashed"),
    DECLINED: ("was declined", "were declined"),
    LATE: ("timed out", "timed out"),
    TOLERATED: ("is tolerated", "are tolerated"),
}

#: What of a page `placed` replaces lies between these marks.
BEGIN, END = "<!-- written by ./run grade --page -->", "<!-- end of what ./run grade writes -->"

HEAD = """{libraries} libraries answered {questions} questions about difficult curves: {cases} of the {all} cases of
version {version} (by family: {families}). The command `./run grade --page docs/measurements.md{share}` compared
{answers} answers with exact answers. An exact answer is used only if an independent checker
(`workshop/grade/recheck.py`, `exactspline/certificates`) accepted its certificate in this run. This excludes
{uncertified}. A library gets only the questions that its public functions answer for the given curve
(`workshop/grade/adapters`: one file per library). The tolerance of each question is
[below](#what-counts-as-the-same-answer).

- *Missed*: the answer lacks a true parameter. *Invented*: the answer has a parameter that is not true.
- *Declined*: the library reports that it has no answer. *Timed out*: the library takes more than {patience} s of
  processor time.
- *Tolerated*: a parameter is missed or invented, but the library documents such a limit. These limits are:

{documented}

Slow questions are asked in some of the cases: {every}.
"""


def page(
    reports: Sequence[Report],
    defects: Sequence[Defect],
    cases: Sequence[Case],
    uncertified: Sequence[tuple[str, str, str]],
    share: str = "",
) -> str:
    """The results in Markdown, of all cases or a share of them: how that was asked for."""
    families = Counter(case.family for case in cases)
    head = HEAD.format(
        share=share,
        all=sum(1 for _ in all_cases()),
        patience=PATIENCE,
        every=", ".join(f"*{question}* in one of {n}" for question, n in EVERY.items()),
        cases=len(cases),
        version=VERSION,
        families=", ".join(f"{count} {name}" for name, count in families.items()),
        questions=len({one.question for report in reports for one in report.judged}),
        libraries=len(reports),
        answers=sum(len(report.judged) for report in reports),
        uncertified=counted(len(uncertified), "exact answer"),
        documented="\n".join(f"- {name}: {each}." for name, each in DOCUMENTED.items()),
    )
    return "\n".join(
        [
            BEGIN,
            "",
            head,
            _overview(reports),
            _scores(reports),
            _meanings(),
            _accuracy(reports),
            _defects(defects),
            _named(cases),
            _left_out(uncertified),
            END,
            "",
        ]
    )


def placed(file: Path, results: str) -> str:
    """The text of a page with its results replaced by these; of a file that has no marks for them, the results."""
    text = file.read_text(encoding="utf-8") if file.exists() else ""
    before, begin, rest = text.partition(BEGIN)
    return before + results.strip() + rest.partition(END)[2] if begin else results


def _overview(reports: Sequence[Report]) -> str:
    """All questions together, one library per row."""
    lines = ["### All libraries", "", "| library | asked | " + " | ".join(OUTCOMES) + " |"]
    lines += ["|---|---:|" + "---:|" * len(OUTCOMES)]
    for report in reports:
        found = Counter(one.verdict.outcome for one in report.judged)
        cells = [str(found.total()), *(str(found[outcome]) for outcome in OUTCOMES)]
        lines.append(f"| {report.library} {report.version} | " + " | ".join(cells) + " |")
    picture = "![answers that are not right, by library, in per cent, one colour per outcome]"
    return "\n".join([*lines, "", f"{picture}({PICTURE})", ""])


def draw(reports: Sequence[Report], path: str) -> None:
    """Draw how many answers of each library are not right, in per cent, by outcome. Raises `PlotError`."""
    figure = new_figure(PAGE, 2 + len(reports) / 3)
    axes, names, left = figure.subplots(), [report.library for report in reports], [0.0] * len(reports)
    for outcome, colour in COLOURS.items():
        counts = [sum(one.verdict.outcome == outcome for one in report.judged) for report in reports]
        widths = [100 * n / max(len(report.judged), 1) for n, report in zip(counts, reports, strict=True)]
        axes.barh(names, widths, left=left, color=colour, label=outcome)
        left = [a + b for a, b in zip(left, widths, strict=True)]
    for row, report in enumerate(reports):
        axes.annotate(
            f"{left[row]:.2g} % of {len(report.judged)}", (left[row], row), (4, -4), textcoords="offset points"
        )
    axes.set_xlim(0, 1.25 * max(left, default=0) or 1)
    axes.invert_yaxis()
    axes.set_xlabel("per cent of the answers that are not right")
    axes.legend(loc="lower right")
    save(figure, path)


def _scores(reports: Sequence[Report]) -> str:
    """A line per library: the questions that were not all answered rightly, with the outcomes."""
    lines = ["### By question", "", "All answers to questions that are not listed are right.", ""]
    for report in reports:
        others = list[str]()
        for question in QUESTIONS:
            found = Counter(one.verdict.outcome for one in report.judged if one.question == question)
            rest = [_said(o, found[o]) for o in OUTCOMES if o != RIGHT and found[o]]
            if rest:
                listed = ", ".join([_said(RIGHT, found[RIGHT]), *rest[:-1]])
                others.append(f"Of {counted(found.total(), 'answer')} to *{question}* {listed} and {rest[-1]}.")
        if others:
            lines.append(f"- **{report.library}**: {' '.join(others)}")
    return "\n".join([*lines, ""])


def _said(outcome: str, times: int) -> str:
    """How many answers have an outcome, with a verb."""
    one, several = VERBS[outcome]
    return f"{times} {one if times == 1 else several}"


def _meanings() -> str:
    lines = ["### What counts as the same answer", "", "| question | what is asked | tolerance |", "|---|---|---|"]
    lines += [f"| {q.name} | {q.meaning} | {q.allowed} |" for q in QUESTIONS.values()]
    lines += ["", *(f"- *{word}*: {meaning}." for word, meaning in TOLERANCES.items())]
    return "\n".join([*lines, ""])


def _accuracy(reports: Sequence[Report]) -> str:
    """The largest error of right answers, in ulps of the largest coordinate."""
    asked = ("value", "first", "second")
    lines = ["### The largest error among right answers", ""]
    unit = "The errors are in ulps of the largest coordinate. Errors of derivatives are divided by the factor of u"
    lines += [f"{unit} in the table above.", ""]
    lines += ["| library | " + " | ".join(asked) + " |", "|---|" + "---:|" * len(asked)]
    for report in reports:
        worst = [
            max((j.verdict.ulps for j in report.judged if j.question == q and j.verdict.outcome == RIGHT), default=None)
            for q in asked
        ]
        lines.append(f"| {report.library} | " + " | ".join("–" if w is None else f"{w:.3g}" for w in worst) + " |")
    return "\n".join([*lines, ""])


def _defects(defects: Sequence[Defect]) -> str:
    lines = ["### Defects, each with its smallest example", ""]
    for defect in defects:
        one = defect.example
        note = " ".join((one.verdict.note or _ulps(one.verdict.ulps)).split())[:160]
        what = f"of the answers to *{defect.question}*, {_said(defect.outcome, defect.times)}"
        lines.append(f"- **{defect.library}**: {what}. Example: {_curve(one)}: {note}.")
    return "\n".join([*lines, ""])


def _curve(one: Judged) -> str:
    curve = one.case.curve
    points = " ".join(f"({', '.join(map(_short, p))})" for p in curve.control_points)
    inner = [t for t in curve.knots if curve.domain[0] < t < curve.domain[1]]
    knots = f", knots inside {' '.join(map(_short, inner))}" if inner else ""
    weights = "" if curve.polynomial else f", weights {' '.join(map(_short, curve.weights))}"
    return f"degree {curve.degree}, {points}{knots}{weights}, t = {_short(one.case.parameter)}"


def _short(x: mpq) -> str:
    """A number in full where it is short, otherwise as a double."""
    return text(x) if len(text(x)) <= 8 else repr(double(x))


def _named(cases: Sequence[Case]) -> str:
    named = [case for case in cases if case.link]
    links = ", ".join(f"[{case.key.removeprefix('named ')}]({case.link})" for case in named)
    return "\n".join(["### Cases from public bug reports", "", f"{links}.", ""])


def _left_out(uncertified: Sequence[tuple[str, str, str]]) -> str:
    lines = ["### Not used: no certificate", ""]
    lines += [f"- {case}, {question}: {flaw}" for case, question, flaw in uncertified]
    return "\n".join([*lines, ""]) if uncertified else ""


def wrong(report: Report) -> list[Judged]:
    """The wrong answers."""
    return [one for one in report.judged if one.verdict.outcome in WRONG]
