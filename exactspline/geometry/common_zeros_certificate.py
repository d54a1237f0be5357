"""The proof of all common zeros of two functions of two parameters, as JSON data for `exactspline.certificates`."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import product
from typing import Any

from flint import fmpz

from exactspline.certificates import COMMON_ZEROS
from exactspline.certificates import certificate as written
from exactspline.certificates.common_zeros import CROSSED, EDGE, FIRST, POINT, SECOND
from exactspline.errors import ReachError
from exactspline.geometry.surface.borders import EDGES
from exactspline.numbers.exact import mpq, text
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.polynomials.patch_forms import PatchForm, Sized, halved
from exactspline.reals.real import Real
from exactspline.splines.tensor import TensorSpline

#: The sizes of regions (bits) that are tried, and the largest number of boxes.
BITS, BOXES = (1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256), 20_000
#: The bits of the coefficients of combinations.
SHORT = 16
REMEDY = "ask for the points; they are exact also without a certificate"

#: A zero of two functions, and the patches on which it was found.
Found = tuple[tuple[Real, Real], Iterable[tuple[int, int]]]


def common_zeros_certificate(first: TensorSpline, second: TensorSpline, found: Sequence[Found]) -> dict[str, object]:
    """The certificate of all common zeros of two functions on one mesh, given these zeros and the patches that have
    them.

    Raises `ReachError` where one of the zeros is not simple, or there are too many boxes.
    """
    patches = []
    for patch in product(range(len(first.meshes[0])), range(len(first.meshes[1]))):
        sides = first.patch(*patch)
        places = [place for place, own in found if patch in own]
        patches.append(
            {"sides": [[text(end) for end in side] for side in sides]}
            | _patch([f.patch_form(*patch) for f in (first, second)], sides, places)
        )
    return written(COMMON_ZEROS, {"patches": patches})


def _patch(forms: Sequence[PatchForm], sides: Box, places: Sequence[tuple[Real, Real]]) -> dict[str, Any]:
    degree = max(f.degree[0] for f in forms), max(f.degree[1] for f in forms)
    f, g = (form.elevated(degree) for form in forms)
    zeros = [_ZeroOnPatch(f, g, sides, place) for place in places]
    regions = [zero.region(bits) for zero, bits in zip(zeros, _sizes(zeros), strict=True)]
    return {
        "functions": [[[str(x) for x in row] for row in form.matrix.tolist()] for form in (f, g)],
        "zeros": [zero.data(region) for zero, region in zip(zeros, regions, strict=True)],
        "boxes": list(_boxes(f, g, regions)),
    }


def _sizes(zeros: Sequence[_ZeroOnPatch]) -> list[int]:
    """For each zero the size of the largest region that serves, apart from the others."""
    sizes = [next((bits for bits in BITS if zero.serves(bits)), 0) for zero in zeros]
    if not all(sizes):
        raise ReachError("a certificate of a common zero that is not simple", remedy=REMEDY)
    for i, j in product(range(len(zeros)), repeat=2):
        while i < j and zeros[i].region(sizes[i]).meets(zeros[j].region(sizes[j])):
            for k in (i, j):
                sizes[k] += 1
                while not zeros[k].serves(sizes[k]):
                    sizes[k] += 1
    return sizes


@dataclass
class _ZeroOnPatch:
    """A zero on a patch, in the parameters of its unit square."""

    f: PatchForm
    g: PatchForm
    sides: Box
    place: tuple[Real, Real]

    @cached_property
    def exact(self) -> tuple[mpq, ...] | None:
        """Both parameters where they are rational."""
        known = [x.exact for x in self.place]
        local = [side.local(x) for side, x in zip(self.sides, known, strict=True) if x is not None]
        return tuple(local) if len(local) == len(known) else None

    @cached_property
    def edge(self) -> tuple[int, int] | None:
        """The edge that it is on: a direction and an end."""
        ends = ((k, end) for k, end in EDGES if self.place[k] == self.sides[k][end])
        return next(ends, None)

    def region(self, bits: int) -> Box:
        """A box around it, about ``2^(1−bits)`` wide, in the square."""
        width, digits = mpq(1, 1 << bits), bits // 3 + 2
        around = []
        for side, x in zip(self.sides, self.place, strict=True):
            scale = max(mpq(1), 1 / side.width)
            more = len(str(int(scale)))
            enclosed = x.enclosure(digits + more)
            middle = side.local(Interval(*enclosed).middle)
            middle = mpq((middle / width + mpq(1, 2)) // 1) * width  # few digits
            around.append(Interval(max(mpq(0), middle - width), min(mpq(1), middle + width)))
        return Box(*around)

    def combinations(self, region: Box) -> list[list[int]]:
        """Combinations that are nearly multiples of the distances in both parameters."""
        return _preconditioning(self.f.part(region), self.g.part(region))

    def _pair(self, region: Box) -> list[PatchForm]:
        f, g = self.f.part(region), self.g.part(region)
        return [f.combined(fmpz(a), g, fmpz(b)) for a, b in self.combinations(region)]

    def serves(self, bits: int) -> bool:
        """Whether a region has one zero at most, and this one's existence can be proved in it."""
        region = self.region(bits)
        pair = self._pair(region)
        (a, b), (c, d) = ([form.derivative(k).range for k in (0, 1)] for form in pair)
        straight, across = [x * y for x in a for y in d], [x * y for x in b for y in c]
        if not (min(straight) > max(across) or max(straight) < min(across)):
            return False
        return self.exact is not None or self.edge is not None or self._is_crossed(pair)

    def _is_crossed(self, pair: Sequence[PatchForm]) -> bool:
        signs = [[_sign(form.edge(k, end)) for end in (0, 1)] for k, form in enumerate(pair)]
        return all(one * other == -1 for one, other in signs)

    def data(self, region: Box) -> dict[str, object]:
        """The region, the combinations, and the proof of existence."""
        combined = [[str(x) for x in row] for row in self.combinations(region)]
        data: dict[str, object] = {"region": [[text(x) for x in side] for side in region], "combinations": combined}
        if self.exact is not None:
            return data | {"by": POINT, "point": [text(x) for x in self.exact]}
        return data | ({"by": CROSSED} if self.edge is None else {"by": EDGE, "edge": list(self.edge)})


def _short(a: Any, b: Any) -> list[int]:
    """Two integers in nearly the same ratio, of few bits."""
    shift = max(0, max(int(a).bit_length(), int(b).bit_length()) - SHORT)
    return [int(a) >> shift, int(b) >> shift]


def _sign(values: Sequence[Any]) -> int:
    return 1 if min(values) > 0 else -1 if max(values) < 0 else 0


def _boxes(f: PatchForm, g: PatchForm, regions: Sequence[Box]) -> Iterator[object]:
    """Cuts of boxes, regions and combinations with one sign."""
    todo, boxes = [Sized(UNIT, [f, g], 0)], 0
    while todo:
        part, boxes = todo.pop(), boxes + 1
        if boxes > BOXES:
            raise ReachError(f"a certificate of more than {BOXES} boxes", remedy=REMEDY)
        k = next((k for k, region in enumerate(regions) if region.contains(part.box)), None)
        if k is not None:
            yield k
            continue
        excluded = next((pair for pair in _candidates(*part.forms) if _excludes(pair, *part.forms)), None)
        if excluded is not None:
            yield [str(x) for x in excluded]
            continue
        yield FIRST if part.box.first.width >= part.box.second.width else SECOND
        todo += reversed(halved(part))


def _candidates(f: PatchForm, g: PatchForm) -> Iterator[list[int]]:
    """Combinations that may have one sign."""
    yield from ([1, 0], [0, 1])
    yield from _preconditioning(f, g)


def _preconditioning(f: PatchForm, g: PatchForm) -> list[list[int]]:
    """The rows of the adjugate of the Jacobian, estimated from the corners."""
    (a, b), (c, d) = (
        (right + top - low - up, up + top - low - right) for low, up, right, top in (f.corners, g.corners)
    )
    return [_short(d, -b), _short(-c, a)]


def _excludes(pair: Sequence[int], f: PatchForm, g: PatchForm) -> bool:
    return bool(f.combined(fmpz(pair[0]), g, fmpz(pair[1])).sign)
