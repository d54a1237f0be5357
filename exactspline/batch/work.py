"""The work on each curve of a sweep, picklable, so that it can be done in any process."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from time import process_time
from typing import TYPE_CHECKING, Any

from exactspline.batch.backends import ALONE
from exactspline.batch.corpus import Item, Member, Problem
from exactspline.batch.inspections import USUAL, checked_names, entry_of, inspected
from exactspline.batch.lines import Found, Judged, Line, Way
from exactspline.display.records import answer_data
from exactspline.errors import as_flag, as_integer, as_texts
from exactspline.geometry.analysis.ask import asked_of, check_question, kind_of
from exactspline.geometry.analysis.curves import analyse
from exactspline.geometry.analysis.registry import REGISTRY
from exactspline.programs.accelerator import filter_curve
from exactspline.questions.entry import Answered, Of
from exactspline.questions.takes import name_of
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface

if TYPE_CHECKING:
    from exactspline.verification.claim import Claim
    from exactspline.verification.combined import Proofs


#: Answers to questions that take a time in proportion to the segments of a curve.
QUICK = (Answered.PLACES, Answered.PIECES, Answered.JOINTS)
#: The default and the largest number of digits of irrational parameters.
DIGITS, MOST_DIGITS = 10, 10_000


class OneByOne(ABC):
    """Work that makes one line for each curve or surface."""

    def line(self, item: Item) -> Line:
        """The line of one item. An error is recorded in the line, so that other items are not affected."""
        start, fields = process_time(), dict[str, Any]()
        try:
            if isinstance(item.given, Problem):
                fields["error"] = item.given
            else:
                self._fill(fields, item)
        # one curve must not end a sweep of a million: an unexpected exception is recorded by its type
        except Exception as failure:
            fields["error"] = Problem.of(failure)
        fields |= {"notes": item.notes, "curve_digest": item.digest, "seconds": process_time() - start}
        return Line(item.index, item.source, item.name, **fields)

    @abstractmethod
    def _fill(self, fields: dict[str, Any], item: Item) -> None:
        """Fill the fields of the line of one item."""

    def lines(self, group: list[Item]) -> Iterator[Line]:
        """The lines of several items. Items are removed from the list, so that none is kept after its line is done."""
        while group:
            yield self.line(group.pop(0))


@dataclass(frozen=True)
class Work(OneByOne):
    """The features to search for on each curve, by the names of questions; the claims that are checked on it, by
    paper and key; the digits of irrational parameters; and whether points get their coordinates and curvature.

    >>> from exactspline.batch.corpus import items
    >>> line = Work.of().line(next(items(["six_segment_cubic"])))
    >>> line.segments, {name: len(points) for name, points in line.found.items()}, line.error
    (6, {'inflections': 2, 'curvature_extrema': 8, 'corners': 0}, None)
    """

    find: tuple[str, ...]
    claims: tuple[tuple[str, str], ...]
    digits: int
    values: bool = False

    @classmethod
    def of(
        cls, find: Iterable[str] | None = None, claims: Iterable[str] = (), digits: int = DIGITS, values: bool = False
    ) -> Work:
        """The work that the arguments describe: names of questions (by default `USUAL`, or none where claims are given)
        and ids of claims.

        Raises `QuestionError` or `ClaimError` with the nearest names.
        """
        digits = as_integer(digits, "a number of digits", 0, MOST_DIGITS)
        located = _located(as_texts(claims, "ids of claims", "the id of a claim"))
        names = checked_names((() if located else USUAL) if find is None else find)
        return cls(names, located, digits, as_flag(values, "whether points get their values"))

    def settings(self) -> dict[str, object]:
        """The settings on which the lines depend, as data."""
        return {
            "find": list(self.find),
            "claims": [list(claim) for claim in self.claims],
            "digits": self.digits,
            "values": self.values,
        }

    def _fill(self, fields: dict[str, Any], item: Item) -> None:
        """Fill in the data of the curve and the answers about it."""
        curve = item.curve()
        fields |= {name: getattr(curve, name) for name in ("degree", "dimension", "segments", "polynomial")}
        fields["found"], fields["claims"], fields["way"] = self._answered(curve)

    def weight(self, item: Item) -> int:
        """The part of a group that a curve fills. For a plane curve with quick questions only, it is the number of
        segments times the cube of the degree, for a family the largest such value; otherwise it is `ALONE`.

        >>> from exactspline.batch.corpus import items
        >>> from exactspline.batch.corpus import Family
        >>> families = [Family.parsed(f"degree=2-5 dimension={n} count=1") for n in (2, 3)]
        >>> [Work.of().weight(item) for item in items(["six_segment_cubic", *families])]
        [162, 125, 16384]
        """
        given = item.given
        asked = [entry_of(name)[0].about for name in self.find]
        if self.claims or any(about.takes or about.answered not in QUICK for about in asked):
            return ALONE
        if isinstance(given, Member) and given.family.dimension == 2:
            return given.family.segments[1] * given.family.degree[1] ** 3
        return given.segments * given.degree**3 if isinstance(given, Nurbs) and given.dimension == 2 else ALONE

    def _answered(self, curve: Nurbs) -> tuple[dict[str, tuple[Found, ...]], tuple[Judged, ...], Way | None]:
        analysis = analyse(curve)
        found = inspected(curve, self.find, self.digits, self.values)
        way = None
        if analysis.decided_in_doubles is not None and curve.dimension == 2 and curve.degree > 1:
            way = Way.DECIDED if analysis.decided_in_doubles else Way.EXACT if filter_curve else Way.MISSING
        return found, self._judged(curve), way

    def _judged(self, curve: Nurbs) -> tuple[Judged, ...]:
        if not self.claims:
            return ()
        from exactspline.display.evidence import worded
        from exactspline.verification.evaluation import Evaluation
        from exactspline.verification.ledger import UNNAMED, checked
        from exactspline.verification.vocabulary import Name

        evaluation = Evaluation(curve)
        speaking = [claim for claim in _claims(self.claims) if claim.applies_to(curve.dimension, curve.polynomial)]
        rows = [(claim, checked(claim, evaluation, Name(curve.name) or UNNAMED, _proofs())) for claim in speaking]
        return tuple(Judged(claim.key, row.verdict, row.as_recorded, worded(row.witness)) for claim, row in rows)


def _located(ids: Sequence[str]) -> tuple[tuple[str, str], ...]:
    if not ids:
        return ()
    from exactspline.verification.claims import all_claims, located

    keep = {claim for name in ids for claim in located(name)}
    return tuple((claim.paper, claim.key) for claim in all_claims() if claim in keep)


@cache
def _claims(keys: tuple[tuple[str, str], ...]) -> tuple[Claim, ...]:
    from exactspline.verification.claims import all_claims

    return tuple(claim for claim in all_claims() if (claim.paper, claim.key) in keys)


@cache
def _proofs() -> Proofs:
    """The proofs of this process, each made once. They are needed for a claim that is refuted on a curve."""
    from exactspline.verification.combined import Proofs

    return Proofs()


# ---- surfaces


@dataclass(frozen=True)
class SurfaceWork(OneByOne):
    """The questions to ask of each surface, and the digits of irrational parameters.

    >>> from exactspline import example
    >>> from exactspline.batch.corpus import Taken, items
    >>> line = SurfaceWork.of(["umbilics"]).line(next(items([example("enneper")], Taken(surfaces=True))))
    >>> line.degrees, line.patches, line.answers, line.error
    ((3, 3), 1, {'umbilics': {'points': [], 'everywhere': [], 'undecided': []}}, None)
    """

    find: tuple[str, ...]
    digits: int

    @classmethod
    def of(cls, find: Iterable[str] | None = None, digits: int = DIGITS) -> SurfaceWork:
        """The work that the arguments describe: questions about surfaces and maps of the plane; all questions of the
        registry if none is named, or for ``all``.

        Raises `QuestionError` with the nearest names.
        """
        every = dict.fromkeys(
            name
            for of in (Of.SURFACE, Of.PLANAR_MAP)
            for name, entry in REGISTRY[of].items()
            if not (entry.about.takes or entry.about.on_request)
        )
        asked = dict[str, None]()
        for each in ["all"] if find is None else as_texts(find, "names of questions", "the name of a question"):
            if each != "all":
                check_question(each, Of.SURFACE, Of.PLANAR_MAP)
            asked |= every if each == "all" else {each: None}
        return cls(tuple(asked), as_integer(digits, "a number of digits", 0, MOST_DIGITS))

    def settings(self) -> dict[str, object]:
        """The settings on which the lines depend, as data."""
        return {"find": list(self.find), "claims": [], "digits": self.digits, "values": False}

    def weight(self, item: Item) -> int:
        """Surfaces are computed one by one."""
        return ALONE

    def _fill(self, fields: dict[str, Any], item: Item) -> None:
        """Fill in the data of the surface and the answers; questions that do not apply to surfaces of its dimension are
        skipped.
        """
        surface = item.given
        assert isinstance(surface, NurbsSurface)  # this work gets only surfaces
        first, second = (len(mesh.breaks) - 1 for mesh in surface.meshes)
        fields |= {"dimension": surface.dimension, "polynomial": surface.polynomial, "degrees": surface.degree}
        fields["patches"] = first * second
        found = analyse(surface)
        fields["answers"] = {
            asked: answer_data(asked_of(found, asked), self.digits)
            for asked in self.find
            if name_of(asked) in REGISTRY[kind_of(found)]
        }
