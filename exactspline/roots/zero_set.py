"""The zero set of a spline on its domain: roots, intervals on which it vanishes, and sign changes at jumps."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any, NamedTuple

from exactspline.certificates import ZEROS
from exactspline.certificates import certificate as written
from exactspline.errors import ShapeError, as_flag, as_items, counted
from exactspline.hooks import Displayed
from exactspline.numbers.exact import mpq, ratio, text
from exactspline.numbers.intervals import Interval
from exactspline.numbers.once import Immutable, fill
from exactspline.one_line import one_line, short_text
from exactspline.polynomials.isolation import Isolation, isolate
from exactspline.roots.answers import OneNumber
from exactspline.roots.root import Root
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import intervals_of, runs
from exactspline.splines.type_checks import spline_of


class _Near(NamedTuple):
    """A spline seen from one side of a knot: limit, multiplicity of the zero (None if the segment vanishes), and sign
    near the knot.
    """

    value: mpq
    multiplicity: int | None
    sign: int


@dataclass(frozen=True)
class Jump(OneNumber):
    """A knot at which the spline jumps and either changes sign without a zero on either side, or has a zero as a limit
    from one side only.

    `left` and `right` are the limit, the multiplicity and the sign on each side.
    """

    parameter: mpq
    left: _Near
    right: _Near

    @property
    def sign_change(self) -> bool:
        """Whether the spline has opposite signs on the two sides."""
        return self.left.sign * self.right.sign < 0

    @one_line
    def __repr__(self) -> str:
        at, left, right = map(short_text, (self.parameter, self.left.value, self.right.value))
        return f"<Jump at {at}: from {left} to {right}>"


@dataclass(frozen=True)
class ZeroInterval:
    """An interval on which the spline vanishes, with its sign before and after (None at an end of the domain).

    `parts` are its intervals in the domain, in the order of traversal: one, or two if it crosses the seam of a periodic
    spline, up to the end of the domain and from its start. The zero interval begins at `low` and ends at `high`, and
    ``high < low`` if and only if it crosses the seam.

    >>> f = BSpline(1, [0, 0, 1, 2, 3, 4, 4], [0, 0, 1, 0, 0])
    >>> zeros(f, periodic=True).intervals[0]
    <ZeroInterval [3, 4] and [0, 1]>
    """

    parts: tuple[Interval, ...]
    signs: tuple[int | None, int | None]

    @property
    def low(self) -> mpq:
        """The parameter where the interval begins."""
        return self.parts[0][0]

    @property
    def high(self) -> mpq:
        """The parameter where the interval ends."""
        return self.parts[-1][1]

    @one_line
    def __repr__(self) -> str:
        return f"<ZeroInterval {' and '.join(f'[{short_text(a)}, {short_text(b)}]' for a, b in self.parts)}>"


class ZeroSet(Immutable, Displayed):
    """All zeros of a spline. As a sequence, a zero set contains the roots in ascending order, each parameter once.

    `roots`, `intervals` and `jumps` are complete and disjoint: a zero at an end of an interval belongs to the interval.
    Two zero sets are equal if they have the same roots, intervals and jumps, including multiplicities and signs.
    """

    __slots__ = ("intervals", "isolations", "jumps", "periodic", "roots", "spline")
    spline: BSpline
    periodic: bool
    isolations: tuple[Isolation | None, ...]
    roots: tuple[Root, ...]
    jumps: tuple[Jump, ...]
    intervals: tuple[ZeroInterval, ...]

    def __init__(self, spline: BSpline, periodic: bool, isolations: Iterable[Isolation | None]) -> None:
        collected = _Collected(spline_of(spline), periodic, list(as_items(isolations, "isolations")))
        fill(
            self,
            spline=spline,
            periodic=periodic,
            isolations=tuple(collected.isolations),
            roots=tuple(collected.roots),
            jumps=tuple(collected.jumps),
            intervals=tuple(_zero_intervals(spline, collected.isolations, periodic)),
        )

    def __reduce__(self) -> tuple[object, ...]:
        return _restored, (self.spline, self.periodic, self.isolations, self.roots, self.jumps, self.intervals)

    def _facts(self) -> tuple[Any, ...]:
        roots = [(r, r.left_multiplicity, r.right_multiplicity, r.signs) for r in self.roots]
        return tuple(roots), self.jumps, self.intervals

    def __eq__(self, other: object) -> bool:
        return self is other or (isinstance(other, ZeroSet) and self._facts() == other._facts())

    def __hash__(self) -> int:
        return hash(self._facts())

    def __iter__(self) -> Iterator[Root]:
        return iter(self.roots)

    def __len__(self) -> int:
        return len(self.roots)

    def __getitem__(self, i: int) -> Root:
        return self.roots[i]

    @one_line
    def __repr__(self) -> str:
        parts = {"root": self.roots, "interval": self.intervals, "jump": self.jumps}
        return f"<ZeroSet: {', '.join(counted(len(found), what) for what, found in parts.items())}>"

    def refine(self, digits: int, progress: Callable[[int, int], None] | None = None) -> list[Interval]:
        """Return intervals at most ``10^−digits`` wide that contain the roots. `progress` is called after each root
        with the numbers of refined and of all roots.

        The method may be interrupted: the roots keep their current intervals.
        """
        result = []
        for i, root in enumerate(self.roots):
            result.append(root.refine(digits))
            if progress is not None:
                progress(i + 1, len(self.roots))
        return result

    def certificate(self) -> dict[str, object]:
        """Return a proof that these are all zeros, as JSON data with exact strings, for `exactspline.certificates` or
        any other checker.

        Each entry of ``segments`` contains the integers ``c_i`` of the form ``Σ c_i (1 − t)ⁿ⁻ⁱ tⁱ`` of a segment (t
        goes from 0 to 1 on the segment); the subintervals (leaves) of a subdivision of [0, 1], each with the number, 0
        or 1, of sign changes of its Bernstein coefficients; and the midpoints that are zeros. If there are multiple
        zeros, the entry may also contain factors. The product of powers of these factors is the form, up to a constant,
        the zeros at the ends and powers of ``u + v`` (with u = 1 − t, v = t), and the leaves refer to the product of
        the factors, each taken once. ``roots`` lists the roots of the whole spline, with the intervals computed so far.
        ``intervals`` lists the two ends of each interval on which the spline vanishes; if the interval crosses the seam
        of a periodic spline, its end is smaller than its beginning.

        >>> zeros(BSpline.bezier([1, -2, 1])).certificate()["segments"][0]["leaves"]
        [['0', '1/2', 1], ['1/2', '1', 1]]
        """
        f = self.spline
        data: dict[str, object] = {
            "degree": f.degree,
            "periodic": self.periodic,
            "breakpoints": [text(t) for t in f.mesh.breaks],
            "segments": [
                _segment([str(c[k]) for k in range(f.degree + 1)], i)
                for c, i in zip(f.numerators, self.isolations, strict=True)
            ],
            "roots": [
                {
                    "low": text(root.low),
                    "high": text(root.high),
                    "multiplicities": [root.left_multiplicity, root.right_multiplicity],
                    "signs": list(root.signs),
                }
                for root in self.roots
            ],
            "jumps": [{"at": text(jump.parameter), "signs": [jump.left.sign, jump.right.sign]} for jump in self.jumps],
            "intervals": [[text(interval.low), text(interval.high)] for interval in self.intervals],
        }
        return written(ZEROS, data)


def _restored(spline: BSpline, periodic: bool, isolations: Any, roots: Any, jumps: Any, intervals: Any) -> ZeroSet:
    """The unpickled zero set, with the current intervals of its roots."""
    restored = object.__new__(ZeroSet)
    fill(
        restored, spline=spline, periodic=periodic, isolations=isolations, roots=roots, jumps=jumps, intervals=intervals
    )
    return restored


#: Multiplicity and sign at an end of a segment; (None, 0) if the segment vanishes.
_End = tuple[int | None, int]
NOTHING: _End = (None, 0)


class _Collected:
    """The roots and jumps of a spline, collected from left to right."""

    def __init__(self, spline: BSpline, periodic: bool, isolations: list[Isolation | None]) -> None:
        if len(isolations) != len(spline.numerators) or not all(x is None or type(x) is Isolation for x in isolations):
            raise ShapeError("isolations that do not belong to the segments", remedy="exactspline.zeros finds them")
        self.spline, self.periodic, self.isolations = spline, periodic, isolations
        self.roots: list[Root] = []
        self.jumps: list[Jump] = []
        breaks, last = spline.mesh.breaks, len(isolations) - 1
        left = _at_right(isolations[last]) if periodic else None
        for i, isolation in enumerate(isolations):
            self._judge(i, left, _at_left(isolation))
            if isolation is not None and isolation.inner:
                self._inner(isolation, Interval(breaks[i], breaks[i + 1]))
            left = _at_right(isolation)
        if not periodic:
            self._judge(last + 1, left, None)

    def _inner(self, isolation: Isolation, segment: Interval) -> None:
        for zero in isolation.inner:
            low, high = segment.at(zero.low), segment.at(zero.high)
            self.roots.append(Root(low, high, (zero.multiplicity, zero.multiplicity), zero.signs, zero, segment))

    def _judge(self, i: int, left: _End | None, right: _End | None) -> None:
        """Record the root or jump at a knot; at an end of the domain one side is None."""
        t = self.spline.mesh.breaks[i]
        if left is not None and right is not None:
            zero_sides = (left[0] != 0) + (right[0] != 0)
            if zero_sides == 1 or (zero_sides == 0 and left[1] != right[1]):
                behind = i % len(self.isolations)
                self.jumps.append(
                    Jump(t, _Near(self._limit(behind - 1, "left"), *left), _Near(self._limit(behind, "right"), *right))
                )
                return
        if (left is None or left[0]) and (right is None or right[0]):
            multiplicities = (left and left[0], right and right[0])
            self.roots.append(Root(t, t, multiplicities, (left and left[1], right and right[1])))

    def _limit(self, i: int, side: str) -> mpq:
        """The value at the right end of a segment (the limit from the left), or at its left end."""
        f = self.spline
        c = f.numerators[i]
        return ratio(c[f.degree if side == "left" else 0], f.denominators[i]) if c else mpq(0)


def _at_left(isolation: Isolation | None) -> _End:
    return NOTHING if isolation is None else (isolation.at_left, isolation.signs[0])


def _at_right(isolation: Isolation | None) -> _End:
    return NOTHING if isolation is None else (isolation.at_right, isolation.signs[1])


def zeros(f: BSpline, *, periodic: bool = False) -> ZeroSet:
    """Return all zeros of a spline on its domain, with a proof that no zero is missing.

    With `periodic` the two ends of the domain are one knot, and a zero at this knot is reported at the start of the
    domain.

    >>> f = BSpline(1, [0, 0, 1, 2, 3, 3], [1, -1, 0, 0])
    >>> found = zeros(f)
    >>> found, found.roots, found.intervals
    (<ZeroSet: 1 root, 1 interval, 0 jumps>, (<Root 1/2: multiplicity 1, sign + to −>,), (<ZeroInterval [2, 3]>,))

    Raises `ShapeError` for anything except a `BSpline`.
    """
    f, periodic = spline_of(f), as_flag(periodic, "whether the ends of the domain are one knot")
    return ZeroSet(f, periodic, [isolate(c, f.degree) if c else None for c in f.numerators])


def _zero_intervals(f: BSpline, isolations: list[Isolation | None], periodic: bool) -> list[ZeroInterval]:
    """The segments on which the spline vanishes, with adjacent ones merged."""
    count, result = len(isolations), list[ZeroInterval]()
    if all(isolations):
        return result
    for first, number in runs([x is None for x in isolations], [periodic, *[True] * (count - 1)]):
        last = first + number
        before = isolations[first - 1] if first or periodic else None
        behind = isolations[last % count] if last < count or periodic else None
        signs = (before and before.signs[1], behind and behind.signs[0])
        result.append(ZeroInterval(intervals_of(f.mesh.breaks, first, number), signs))
    return result


def jump_root(jump: Jump) -> Root:
    """The knot of a jump as a `Root`, with the signs on both sides."""
    t = jump.parameter
    return Root(t, t, (jump.left.multiplicity, jump.right.multiplicity), (jump.left.sign, jump.right.sign))


def _segment(coefficients: list[str], isolation: Isolation | None) -> dict[str, object]:
    if isolation is None:
        return {"coefficients": coefficients, "factors": [], "points": [], "leaves": []}
    return {"coefficients": coefficients} | isolation_data(isolation)


def isolation_data(isolation: Isolation) -> dict[str, object]:
    """The data that prove the zeros of one form: factors, points and leaves."""
    leaves = sorted((mpq(k, 1 << level), mpq(k + 1, 1 << level), changes) for level, k, changes in isolation.leaves)
    return {
        "factors": [[[str(x) for x in g.polynomial.coeffs()], k] for g, k in isolation.factors or []],
        "points": [text(t) for t in sorted(mpq(k, 1 << level) for level, k in isolation.points)],
        "leaves": [[text(a), text(b), changes] for a, b, changes in leaves],
    }
