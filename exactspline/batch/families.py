"""Families of random curves: a curve depends only on the seed and its index, wherever it is generated."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass, fields
from functools import lru_cache
from random import Random

from exactspline.errors import CurveFileError, nearest
from exactspline.one_line import OneLine
from exactspline.splines.knots import KnotVector
from exactspline.splines.nurbs import Nurbs

Range = tuple[int, int]
#: The parameters of a family that are not numbers.
KINDS = ("no", "yes", "half")
#: Beyond these a single random curve takes minutes.
MOST = {"degree": 60, "segments": 100_000, "bits": 100_000}


@dataclass(frozen=True, repr=False)
class Family(OneLine):
    """Random curves with simple knots 0, 1, 2, …, integer control points of a given number of bits and weights of 1 to
    20.

    >>> family = Family.parsed("degree=2-5 segments=1-4 rational=half count=400 seed=1")
    >>> curve = family.curve(7)
    >>> curve == family.curve(7), 2 <= curve.degree <= 5, curve.name
    (True, True, '7')
    """

    degree: Range = (3, 3)
    segments: Range = (1, 1)
    dimension: int = 2
    rational: str = "no"
    bits: int = 10
    count: int = 100
    seed: int = 1

    @classmethod
    def parsed(cls, text: str | Iterable[str]) -> Family:
        """The family that ``degree=5 count=1000 seed=1`` describes, words separated by blanks or commas.

        Raises `CurveFileError` for an unknown word or a number out of range.
        """
        words = text.replace(",", " ").split() if isinstance(text, str) else list(text)
        said: dict[str, str] = {}
        for word in words:
            name, equals, value = word.partition("=")
            if name not in names() or not equals or name in said:
                raise CurveFileError(
                    f"--random does not know {word!r}" if name not in said else f"--random names {name} twice",
                    remedy=f"write name=value; {nearest(name, names())}",
                )
            said[name] = value
        values = {name: _value(name, value) for name, value in said.items()}
        return cls(**values)  # type: ignore[arg-type]  # each field gets a value of its own type

    def curve(self, number: int) -> Nurbs:
        """The curve with this index, counted from 0."""
        chance = Random(f"exactspline {self.seed} {number}")
        degree, segments = chance.randint(*self.degree), chance.randint(*self.segments)
        most = 1 << self.bits
        points = [tuple(chance.randint(-most, most) for _ in range(self.dimension)) for _ in range(degree + segments)]
        rational = self.rational == "yes" or (self.rational == "half" and number % 2 == 1)
        weights = [chance.randint(1, 20) for _ in points] if rational else None
        return Nurbs(degree, _knots(degree, segments), points, weights, name=str(number))

    def __str__(self) -> str:
        """The words that describe it."""
        return "random " + " ".join(f"{name}={_shown(value)}" for name, value in asdict(self).items())


@lru_cache(256)
def _knots(degree: int, segments: int) -> KnotVector:
    """Simple knots 0, 1, 2, …, clamped."""
    return KnotVector([0] * degree + list(range(segments + 1)) + [segments] * degree)


def names() -> tuple[str, ...]:
    """The parameters of a family."""
    return tuple(field.name for field in fields(Family))


def is_word(text: str) -> bool:
    """Whether a word of the command line is a parameter of a family.

    >>> is_word("count=100"), is_word("fonts=new.ttf")
    (True, False)
    """
    name, equals, _ = text.partition("=")
    return bool(equals) and name in names()


def _shown(value: Range | int | str) -> str:
    return "-".join(map(str, dict.fromkeys(value))) if isinstance(value, tuple) else str(value)


def _value(name: str, text: str) -> Range | int | str:
    """The value of a word; the ends of a range may be equal."""
    if name == "rational":
        if text not in KINDS:
            raise CurveFileError(f"--random rational={text}", remedy=f"there are {', '.join(KINDS)}")
        return text
    ends = text.split("-") if name in ("degree", "segments") else [text]
    if not 1 <= len(ends) <= 2 or not all(end.isascii() and end.isdigit() for end in ends):
        raise CurveFileError(f"--random {name}={text}", remedy="write an integer, for degree and segments also 2-5")
    low, high = int(ends[0]), int(ends[-1])
    least: Mapping[str, int] = {"seed": 0, "dimension": 2}
    most = MOST.get(name, {"dimension": 3}.get(name, high))
    if not least.get(name, 1) <= low <= high <= most:
        allowed = f"{least.get(name, 1)} to {most}" if most != high else f"at least {least.get(name, 1)}"
        raise CurveFileError(f"--random {name}={text} is out of range", remedy=allowed)
    return (low, high) if name in ("degree", "segments") else low
