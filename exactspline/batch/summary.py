"""The summary of a sweep, gathered line by line in constant memory."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from heapq import heappush, heappushpop

from exactspline.batch.corpus import SKIPPED
from exactspline.batch.lines import UNDECIDED as UNDECIDED_PART
from exactspline.batch.lines import Line, Way
from exactspline.one_line import OneLine

#: Words in place of the decision of the filter, for lines of a sweep that is continued, and for curves that were not
#: given to the filter.
BEFORE, NOT_ASKED = "computed before", "not asked"
#: The number of slowest curves, and of verdicts that differ from the recorded ones, that are named.
NAMED = 5
#: The number of notes of readers that are listed, the most frequent first, since notes may differ only in a number.
NOTES = 20
#: The counts per family.
REFUSED, FALLBACK, OPEN = "refused", "decided by exact arithmetic after the filter", "with an undecided claim"
UNDECIDED = "UNDECIDED"


@dataclass(frozen=True, repr=False)
class Tally(OneLine):
    """A line of the summary: the kind of the counted thing, its name, and the count or the processor time."""

    what: str
    name: str = ""
    count: int | None = None
    seconds: float | None = None


@dataclass
class Summary:
    """Counts over all lines.

    >>> from exactspline.batch.sweep import sweep
    >>> summary = Summary()
    >>> for line in sweep(["circle", "six_segment_cubic", "cusp"]):
    ...     summary.add(line)
    >>> [(each.name, each.count) for each in summary.entries() if each.what == "degree"]
    [('2', 1), ('3', 2)]
    """

    #: The families of random curves, by their descriptions: for each, the curves that were not decided by the filter
    #: are counted.
    families: frozenset[str] = frozenset()
    lines: int = 0
    segments: int = 0
    patches: int = 0
    seconds: float = 0
    degrees: Counter[int] = field(default_factory=Counter)
    errors: Counter[str] = field(default_factory=Counter)
    found: Counter[tuple[str, str]] = field(default_factory=Counter)
    verdicts: Counter[tuple[str, str]] = field(default_factory=Counter)
    #: The ways in which the certified filter decided the curves of this run.
    filter: Counter[str] = field(default_factory=Counter)
    notes: Counter[str] = field(default_factory=Counter)
    #: By family, the curves that were not decided or decided by a fallback; and the number of curves of the family.
    aside: Counter[tuple[str, str]] = field(default_factory=Counter)
    of_family: Counter[str] = field(default_factory=Counter)
    differing: int = 0
    #: Claims with a recorded verdict that were too costly to decide on a curve.
    open: int = 0
    #: Failures on valid input: defects of this program.
    alarms: int = 0
    examples: list[str] = field(default_factory=list)
    #: The first curves that could not be read or handled, each with the reason.
    refused: list[str] = field(default_factory=list)
    _slowest: list[tuple[float, int, str]] = field(default_factory=list)

    def add(self, line: Line, *, known: bool = False) -> None:
        """Count one line; `known` means that an earlier sweep computed the line, so that the way in which it was
        decided is unknown.
        """
        if known or line.error is None:
            self.filter[BEFORE if known else line.way or NOT_ASKED] += 1
        self.lines += 1
        self.segments += line.segments or 0
        self.seconds += line.seconds
        if line.degree is not None:
            self.degrees[line.degree] += 1
        name = ": ".join(dict.fromkeys(filter(None, (line.source, line.curve)))) or f"curve {line.index}"
        if line.error is not None:
            self.errors[line.error.kind] += 1
            if not line.error.bad_input:
                self.alarms += 1
                self._remember(f"{name}: {line.error.kind}: {line.error.message}")
            elif line.error.kind != SKIPPED and len(self.refused) < NAMED:
                self.refused.append(f"{name}: {line.error.message}")
        self.notes.update(line.notes)
        if line.source in self.families:
            self.of_family[line.source] += 1
            self.aside.update((line.source, what) for what in _set_aside(line))
        self.found.update(line.kinds())
        self.patches += line.patches or 0
        self.verdicts.update((each.claim, each.verdict) for each in line.claims)
        for each in line.claims:
            if not each.as_recorded:
                self.differing += each.verdict != UNDECIDED
                self.open += each.verdict == UNDECIDED
                self._remember(f"{name}: {each.claim} is {each.verdict}")
        put = heappush if len(self._slowest) < NAMED else heappushpop
        put(self._slowest, (line.seconds, -line.index, name))

    def _remember(self, text: str) -> None:
        if len(self.examples) < NAMED:
            self.examples.append(text)

    @property
    def as_expected(self) -> bool:
        """Whether no verdict contradicts the record and nothing failed except on bad input."""
        return not self.differing and not self.alarms

    @property
    def all_decided(self) -> bool:
        """Whether no claim, and no part of an answer about a surface, is left undecided."""
        return not self.open and not any(kind == UNDECIDED_PART for _, kind in self.found)

    @property
    def all_read(self) -> bool:
        """Whether every curve has a result; entities that are not curves are rightly skipped."""
        return set(self.errors) <= {SKIPPED}

    def entries(self) -> Iterator[Tally]:
        """The summary in the order in which it is printed."""
        read = self.lines - self.errors.total()
        if self.patches:
            yield Tally("surfaces", "", read)
            yield Tally("patches", "", self.patches)
        else:
            yield Tally("curves", "", read)
            yield Tally("segments", "", self.segments)
        yield from (Tally("degree", str(degree), count) for degree, count in sorted(self.degrees.items()))
        yield from (Tally(what, kind, count) for (what, kind), count in sorted(self.found.items()))
        yield from (Tally(claim, verdict, count) for (claim, verdict), count in sorted(self.verdicts.items()))
        yield from (Tally("error", kind, count) for kind, count in sorted(self.errors.items()))
        yield from (Tally("refused", text) for text in self.refused)
        yield from (Tally("not as expected", text) for text in self.examples)
        yield from (Tally("note", text, count) for text, count in self.notes.most_common(NOTES))
        if len(self.notes) > NOTES:
            yield Tally("note", "others", sum(self.notes.values()) - sum(n for _, n in self.notes.most_common(NOTES)))
        for family in sorted(self.of_family):
            yield Tally("family", family, self.of_family[family])
            counted = ((what, count) for (own, what), count in sorted(self.aside.items()) if own == family)
            yield from (Tally(f"family: {what}", family, count) for what, count in counted)
        yield from (Tally("filter", way, count) for way, count in sorted(self.filter.items()))
        yield Tally("processor time", "", None, self.seconds)
        yield from (Tally("slowest", name, None, seconds) for seconds, _, name in sorted(self._slowest, reverse=True))


def _set_aside(line: Line) -> Iterator[str]:
    """The parts of a line that were refused, undecided, or decided by a fallback."""
    if line.error is not None:
        yield REFUSED
    if line.way is Way.EXACT:
        yield FALLBACK
    if any(each.verdict == UNDECIDED for each in line.claims):
        yield OPEN
