"""The work on each surface of a sweep, picklable, so that it can be done in any process."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from exactspline.batch.backends import ALONE
from exactspline.batch.corpus import Item
from exactspline.batch.work import DIGITS, MOST_DIGITS, OneByOne
from exactspline.display.records import answer_data
from exactspline.errors import as_integer, as_texts
from exactspline.geometry.analysis.ask import asked_of, check_question, kind_of
from exactspline.geometry.analysis.curves import analyse
from exactspline.geometry.analysis.registry import REGISTRY
from exactspline.questions.entry import Of
from exactspline.questions.takes import name_of
from exactspline.splines.surface import NurbsSurface


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
        """The work that the arguments describe: questions about surfaces and maps of the plane, all of the registry
        where none is named or by ``all``.

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
        """On what the lines depend, as data."""
        return {"find": list(self.find), "claims": [], "digits": self.digits, "values": False}

    def weight(self, item: Item) -> int:
        """Surfaces are computed one by one."""
        return ALONE

    def _fill(self, fields: dict[str, Any], item: Item) -> None:
        """What is known of the surface, and the answers; questions that do not apply to surfaces of its dimension are
        skipped.
        """
        surface = item.given
        assert isinstance(surface, NurbsSurface)  # no other is given to this work
        first, second = (len(mesh.breaks) - 1 for mesh in surface.meshes)
        fields |= {"dimension": surface.dimension, "polynomial": surface.polynomial, "degrees": surface.degree}
        fields["patches"] = first * second
        found = analyse(surface)
        fields["answers"] = {
            asked: answer_data(asked_of(found, asked), self.digits)
            for asked in self.find
            if name_of(asked) in REGISTRY[kind_of(found)]
        }
