"""Lines, circles and ellipses of a STEP file, bounded by the vertices of the edges that use them."""

from __future__ import annotations

import re
from collections.abc import Sequence
from operator import sub

from exactspline.errors import ShapeError
from exactspline.extras.cad.step_records import StepFile, Value
from exactspline.interchange.affine import Affine, cross, unit
from exactspline.interchange.segments import arc_around_origin, ellipse, mapped
from exactspline.numbers.exact import mpq

EDGE, ELEMENTARY = "EDGE_CURVE", ("LINE", "CIRCLE", "ELLIPSE")
#: Curves given together with the surfaces they lie on; their first reference is the curve in space.
ON_SURFACES = ("SURFACE_CURVE", "SEAM_CURVE", "INTERSECTION_CURVE")
#: Entities that contain curves in the parameter plane of a surface.
PARAMETERS = "DEFINITIONAL_REPRESENTATION"
_TEXT = re.compile(r"'[^']*'")
_REFERENCE = re.compile(r"#\d{1,12}", re.ASCII)


class Edges:
    """The edges of a file, and the elementary curves that they use."""

    def __init__(self, file: StepFile) -> None:
        self.file = file
        self.used: set[str] = set()
        self.in_parameters: set[str] = set()
        for text in file.instances.values():
            kind, _, rest = text.partition("(")
            if kind.strip() == PARAMETERS:
                self.in_parameters.update(_REFERENCE.findall(_TEXT.sub("", rest).partition(")")[0]))
            if kind.strip() == EDGE or kind.strip() in ON_SURFACES:
                # the referenced curve, possibly on a continuation line
                self.used.update(_REFERENCE.findall(_TEXT.sub("", rest))[2 * (kind.strip() == EDGE) :][:1])

    def notes(self, number: int) -> list[str]:
        """Notes on how edges and surfaces use a spline."""
        used = f"#{number}" in self.used
        in_parameters = f"#{number}" in self.in_parameters
        return [
            *(["edges may use only a part of it, or reverse it"] if used else []),
            *(["in the parameter plane of a surface"] if in_parameters else []),
        ]

    def read(self, keyword: str, number: int, where: str) -> None:
        """Add the curve of an edge, or an elementary curve that no edge uses."""
        if keyword == EDGE:
            self._edge(number, where)
        elif f"#{number}" not in self.used:
            if keyword == "LINE":
                self.file.collector.skip(keyword, where, "an unbounded line that no edge uses", curve=False)
                return
            frame, _ = self._frame(keyword, f"#{number}")
            self.file.collector.add_segments(keyword, where, ellipse(frame), where, ["the full curve"])

    def _edge(self, number: int, where: str) -> None:
        _, first, last, curve, sense = self.file.named(f"#{number}", EDGE, 5)
        keyword = self._kind(curve)
        if keyword in ON_SURFACES:
            curve = self.file.named(curve, keyword, 4)[1]
            keyword = self._kind(curve)
        if keyword not in ELEMENTARY:
            # a spline is read where it is defined
            return
        ends = [self.file.point(self.file.named(end, "VERTEX_POINT", 2)[1]) for end in (first, last)]
        if keyword == "LINE":
            _, through, along = self.file.named(curve, "LINE", 3)
            direction = self.file.numbers(self.file.named(self.file.named(along, "VECTOR", 3)[1], "DIRECTION", 2)[1])
            start = self.file.point(through)
            if any(any(cross(list(map(sub, end, start)), direction)) for end in ends):
                raise ShapeError("a vertex that is not exactly on the line", remedy="only exact curves are read")
            self.file.collector.add(EDGE, where, 1, [mpq(0), mpq(0), mpq(1), mpq(1)], ends, name=where)
            return
        frame, inverse = self._frame(keyword, curve)
        u, v = (self._local(inverse, end) for end in (ends if sense == ".T." else ends[::-1]))
        note = f"on {curve}" + ("" if sense == ".T." else ", reversed")
        self.file.collector.add_segments(EDGE, where, mapped(arc_around_origin(u, v), frame), where, [note])

    def _kind(self, reference: Value) -> str:
        found = _REFERENCE.fullmatch(reference) if isinstance(reference, str) else None
        text = self.file.instances.get(int(found[0][1:]), "") if found else ""
        if not text:
            raise ShapeError("an edge without a curve", remedy="refer to one")
        return text.partition("(")[0].strip()

    def _local(self, inverse: Affine, point: Sequence[mpq]) -> tuple[mpq, mpq]:
        """The corresponding point of the unit circle; raises `ShapeError` for a point not exactly on the curve."""
        x, y, *off = inverse(point)
        if x * x + y * y != 1 or any(off):
            raise ShapeError("a vertex that is not exactly on the curve", remedy="only exact curves are read")
        return x, y

    def _frame(self, keyword: str, reference: Value) -> tuple[Affine, Affine]:
        """The map from the unit circle to a circle or an ellipse in space, and its inverse."""
        _, placement, *sizes = self.file.named(reference, keyword, 3 if keyword == "CIRCLE" else 4)
        radii = self.file.numbers(sizes)
        a, b = radii[0], radii[-1]
        _, centre, axis, reference_direction = self.file.named(placement, "AXIS2_PLACEMENT_3D", 4)
        z = unit(self._direction(axis, (0, 0, 1)))
        given = self._direction(reference_direction, (1, 0, 0))
        along = sum((p * q for p, q in zip(given, z, strict=True)), start=mpq(0))
        x = unit([p - along * q for p, q in zip(given, z, strict=True)])
        y, shift = cross(z, x), self.file.point(centre)
        if not a > 0 < b or len(shift) != 3:
            raise ShapeError("a circle without a positive radius", remedy="its radius must be positive")
        rows = [[p * a, q * b, r, c] for p, q, r, c in zip(x, y, z, shift, strict=True)]
        back = [[c / size for c in v] for v, size in ((x, a), (y, b), (z, mpq(1)))]
        inverse = [[*row, -sum((p * q for p, q in zip(row, shift, strict=True)), start=mpq(0))] for row in back]
        return Affine([[row[0], row[1], row[3]] for row in rows]), Affine(inverse)

    def _direction(self, reference: Value, usual: Sequence[int]) -> list[mpq]:
        if reference == "$":
            return list(map(mpq, usual))
        ratios = self.file.numbers(self.file.named(reference, "DIRECTION", 2)[1])
        if len(ratios) != 3:
            raise ShapeError("a direction that is not in space", remedy="write three ratios")
        return ratios
