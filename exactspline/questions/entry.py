"""A question that can be asked about a geometric object: an entry of the registry. An entry is an attribute of the
class of the object, next to the code of the exact answer, and has all other data about the question. `questions_of` is
the registry. The command line, the oracle, sweeps, the JSON and its schema, the comparison of libraries and the
glossary use it.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Hashable, Iterable
from dataclasses import dataclass
from enum import StrEnum
from functools import partial
from inspect import Parameter, cleandoc, signature
from typing import Any, Concatenate, Generic, ParamSpec, TypeVar, cast, overload

from exactspline.numbers.once import Lock
from exactspline.questions.takes import Takes
from exactspline.roots.answers import Answer
from exactspline.roots.zero_set import ZeroSet

T = TypeVar("T")
P = ParamSpec("P")


class Remembers:
    """An object that keeps its computed properties, each computed once, also if several threads ask for it."""

    def __init__(self, shared: Remembers | None = None) -> None:
        self._known: dict[Any, Any]
        self._lock: Lock
        self._known, self._lock = ({}, Lock()) if shared is None else (shared._known, shared._lock)

    def once(self, key: Hashable, compute: Callable[[], T]) -> T:
        """The value kept under a key, computed at the first request."""
        if key not in self._known:
            with self._lock.held():
                if key not in self._known:
                    self._known[key] = compute()
        return cast(T, self._known[key])

    @property
    def again(self) -> Callable[[], Remembers]:
        """A function that makes an equal object; it holds neither this object nor its computed properties."""
        raise NotImplementedError

    def asked_as(self, of: tuple[Of, ...]) -> Remembers:
        """The computed properties of the object as one of these kinds, if it is of several kinds."""
        return self


class Inspected(Remembers):
    """An inspected object as a value: two are equal if they are about the same object (`of`); copies and pickles keep
    the computed properties.
    """

    def __init__(self, *of: Hashable) -> None:
        super().__init__()
        self.of = of

    @property
    def again(self) -> Callable[[], Remembers]:
        """A function that makes an equal object."""
        return partial(type(self), *self.of)

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and isinstance(other, Inspected) and self.of == other.of

    def __hash__(self) -> int:
        return hash(self.of)

    def __getstate__(self) -> dict[str, object]:
        return {name: kept for name, kept in vars(self).items() if name != "_lock"}

    def __setstate__(self, kept: dict[str, object]) -> None:
        vars(self).update(kept, _lock=Lock())


F = TypeVar("F", bound=Remembers)


class Of(StrEnum):
    """The kinds of objects that a question can be about."""

    PLANE_CURVE = "plane curve"
    SPACE_CURVE = "space curve"
    #: Only questions without lengths and angles are asked about these as about plane curves; curves in the plane z = 0
    #: are treated as plane curves.
    PLANAR_CURVE = "space curve in another plane than z = 0"
    SURFACE = "surface in space"
    PLANAR_MAP = "map of a rectangle into the plane"
    #: A curve that is neither in the plane nor in space.
    CURVE = "curve of another dimension"
    PAIR = "pair of space curves"
    TWO_CURVES = "two curves"
    TWO_SURFACES = "two surfaces in space"
    REGION = "region of several curves"


#: A question about curves in the plane and in space, and about curves of any dimension.
CURVES = (Of.PLANE_CURVE, Of.SPACE_CURVE)
ALL_CURVES = (*CURVES, Of.CURVE)


class Answered(StrEnum):
    """The kinds of things of which an answer consists."""

    #: Points, and parts all of whose points belong to the answer (`exactspline.roots.answers.Answer`).
    PLACES = "places"
    #: Joints of the segments of a curve.
    JOINTS = "joints"
    #: Pieces of a curve.
    PIECES = "pieces"
    #: Pieces of a curve, each with its plane; or one plane.
    PLANAR_PIECES = "planar pieces"
    PLANE = "plane"
    #: Pieces of a curve, each with its description (`exactspline.questions.answers.Described`).
    DESCRIBED = "described pieces"
    #: The patches of a surface, each with its properties.
    PATCHES = "patches"
    #: Patches of a surface with their shapes.
    SHAPES = "patches with their shapes"
    #: Whole curves on a surface.
    CURVES = "curves"
    #: Parts of a bisector; unknown parts are listed next to them.
    SOLUTIONS = "solutions"
    #: Pairs of parameters of two curves, and common arcs; undecided places are listed.
    PAIRS = "pairs"
    #: The points of a curve at the least distance, and pieces all of whose points are at this distance.
    NEAREST = "nearest points"
    #: A value, or one point.
    VALUE = "value"
    POINT = "point"
    #: Numbers by their names (`exactspline.questions.answers.NamedNumbers`).
    NUMBERS = "numbers"
    #: Curves or functions by their control points.
    SPLINES = "control points"


@dataclass(frozen=True)
class _About:
    """The data of a question in addition to its name, its meaning and its exact answer.

    ``of``: the kinds of objects. ``answered``: the things of which the answer consists. ``part_of``: another question,
    whose answer contains this one. ``proof``: the zero set whose certificate shows that an answer is complete, by the
    object and the arguments. ``takes``: the arguments. ``of_piece``: the words of a table for one of the pieces.
    ``on_request``: whether it is answered only if it is asked by its name. ``nearby``: whether it is asked about all
    objects within a distance, which is its argument.
    """

    of: tuple[Of, ...]
    answered: Answered = Answered.PLACES
    part_of: str = ""
    proof: Callable[..., Iterable[ZeroSet]] | None = None
    takes: tuple[Takes, ...] = ()
    of_piece: str = ""
    on_request: bool = False
    nearby: bool = False

    @property
    def argument(self) -> str:
        """An example of the argument after the colon, as text; empty if there is none."""
        return ",".join(each.example for each in self.takes if not each.placed)

    @property
    def place(self) -> str:
        """An example of the parameters after the @, as text; empty if there are none."""
        return ",".join(each.example for each in self.takes if each.placed)

    @property
    def reported(self) -> bool:
        """Whether the answer is part of a full report."""
        return not (self.part_of or self.takes or self.on_request)


class Entry(ABC):
    """A question as an entry of the registry, whatever its answer is."""

    name: str
    about: _About

    @abstractmethod
    def answer(self, facts: Remembers, argument: str = "", place: str = "") -> object:
        """The exact answer; the arguments are given as text (see `exactspline.questions.takes`)."""

    @abstractmethod
    def proofs(self, facts: Remembers, argument: str = "", place: str = "") -> Iterable[ZeroSet]:
        """The zero sets whose certificates show that the answer is complete."""

    #: Whether the argument after the colon may be omitted.
    optional: bool = False

    @property
    def form(self) -> str:
        """The question as text: its name, with examples of its arguments."""
        argument, place = self.about.argument, self.about.place
        return f"{self.name}{':' * bool(argument)}{argument}{'@' * bool(place)}{place}"

    @property
    def meaning(self) -> str:
        """The meaning of the question in one line: the first paragraph of the docstring, as a part of a sentence."""
        paragraph = " ".join(cleandoc(self.__doc__ or "").split("\n\n")[0].split())
        return (paragraph[:1].lower() + paragraph[1:]).removesuffix(".").replace("``", "")


class Fact(Generic[F, T]):
    """A property that is computed once for its object, under the object's lock, and kept: among the object's own
    attributes, where Python looks first.
    """

    def __init__(self, compute: Callable[[F], T]) -> None:
        self.compute, self.__doc__ = compute, compute.__doc__

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    def found(self, facts: F) -> T:
        """The computed property."""
        return self.compute(facts)

    @overload
    def __get__(self, facts: None, owner: type) -> Fact[F, T]: ...

    @overload
    def __get__(self, facts: Remembers, owner: type) -> T: ...

    def __get__(self, facts: Remembers | None, owner: type) -> T | Fact[F, T]:
        if facts is None:
            return self
        found: T = facts.once(self.name, lambda: self.found(cast(F, facts)))
        vars(facts)[self.name] = found
        return found


def _remembering(entry: Entry, facts: Remembers, answer: T) -> T:
    """The answer; if its class can remember the question, it does."""
    return answer.asked_with(entry.name, facts.again) if isinstance(answer, Answer) else answer


class Question(Fact[F, T], Entry):
    """A fact that can be asked for by its name."""

    def __init__(self, compute: Callable[[F], T], about: _About) -> None:
        super().__init__(compute)
        self.about = about

    def found(self, facts: F) -> T:
        """The answer, computed for the object as one of the kinds of the question."""
        asked = facts.asked_as(self.about.of)
        return _remembering(self, facts, self.compute(facts)) if asked is facts else getattr(asked, self.name)

    def answer(self, facts: Remembers, argument: str = "", place: str = "") -> object:
        """The exact answer."""
        return getattr(facts, self.name)

    def proofs(self, facts: Remembers, argument: str = "", place: str = "") -> Iterable[ZeroSet]:
        """The zero sets that show that it is complete."""
        return () if self.about.proof is None else self.about.proof(facts.asked_as(self.about.of))


class QuestionWith(Entry, Generic[F, P, T]):
    """A question with arguments: a method whose answers are kept, each under the values of its arguments, which `Takes`
    reads.
    """

    def __init__(self, compute: Callable[Concatenate[F, P], T], about: _About) -> None:
        self.compute, self.__doc__, self.about = compute, compute.__doc__, about
        self.signature = signature(compute)
        _, *parameters = self.signature.parameters.values()
        self.takes = {each.name: takes for each, takes in zip(parameters, about.takes, strict=True)}
        behind = [each for each in parameters if not self.takes[each.name].placed]
        self.optional = all(each.default is not Parameter.empty for each in behind)

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    @overload
    def __get__(self, facts: None, owner: type) -> QuestionWith[F, P, T]: ...

    @overload
    def __get__(self, facts: Remembers, owner: type) -> Callable[P, T]: ...

    def __get__(self, facts: Remembers | None, owner: type) -> Callable[P, T] | QuestionWith[F, P, T]:
        if facts is None:
            return self
        facts = facts.asked_as(self.about.of)

        def ask(*args: P.args, **kwargs: P.kwargs) -> T:
            bound = self.signature.bind(facts, *args, **kwargs)
            bound.apply_defaults()
            _, *given = bound.arguments.items()
            return self._of(facts, {name: self.takes[name].read(value, facts) for name, value in given})

        return ask

    def _of(self, facts: Remembers, arguments: dict[str, Any]) -> T:
        key = (self.name, *arguments.values())
        compute: Callable[..., T] = self.compute
        return facts.once(key, lambda: _remembering(self, facts, compute(facts, **arguments)))

    def answer(self, facts: Remembers, argument: str = "", place: str = "") -> object:
        """The exact answer; the arguments are given as text."""
        facts = facts.asked_as(self.about.of)
        return self._of(facts, self._read(facts, argument, place))

    def proofs(self, facts: Remembers, argument: str = "", place: str = "") -> Iterable[ZeroSet]:
        """The zero sets that show that it is complete."""
        proof, facts = self.about.proof, facts.asked_as(self.about.of)
        return () if proof is None else proof(facts, *self._read(facts, argument, place).values())

    def _read(self, facts: Remembers, argument: str, place: str) -> dict[str, Any]:
        """The arguments after the colon and after the @, read."""
        given = {name: place if takes.placed else argument for name, takes in self.takes.items()}
        read = {name: self.takes[name].read(text, facts) for name, text in given.items() if text}
        return {name: read.get(name, self.signature.parameters[name].default) for name in given}


def question(
    *of: Of,
    answered: Answered = Answered.PLACES,
    part_of: str = "",
    proof: Callable[..., Iterable[ZeroSet]] | None = None,
    of_piece: str = "",
    on_request: bool = False,
) -> Callable[[Callable[[F], T]], Question[F, T]]:
    """Make the property that computes an answer an entry of the registry (see `_About`)."""
    about = _About(of, answered, part_of, proof, of_piece=of_piece, on_request=on_request)
    return lambda compute: Question(compute, about)


def question_with(
    takes: Takes | tuple[Takes, ...],
    *of: Of,
    answered: Answered = Answered.PLACES,
    proof: Callable[..., Iterable[ZeroSet]] | None = None,
    nearby: bool = False,
) -> Callable[[Callable[Concatenate[F, P], T]], QuestionWith[F, P, T]]:
    """Make a method that computes an answer an entry of the registry; it takes these arguments, in the order of its
    parameters: at most one after the colon, and one after the @.
    """
    given = takes if isinstance(takes, tuple) else (takes,)
    return lambda compute: QuestionWith(compute, _About(of, answered, proof=proof, takes=given, nearby=nearby))


def questions_of(owner: type) -> dict[str, Entry]:
    """The questions about the objects of a class, by their names, in the order of their definition, those of its base
    classes first.

    >>> from exactspline.geometry.analysis.curves import Analysis
    >>> list(questions_of(Analysis))[:2]
    ['joints', 'singular_points']
    """
    found: dict[str, Entry] = {}
    for each in reversed(owner.__mro__):
        found |= {name: x for name, x in vars(each).items() if isinstance(x, Entry)}
    return found
