"""Files that other programs write: ``python -m tests.campaigns.programs 2000 0``.

Open CASCADE (STEP, IGES, BREP), ezdxf (DXF), rhino3dm (3dm) and geomdl (JSON), as far as they are installed, write
random curves, closed and periodic ones, trimmed ones and arcs among them. Every file is read, with `WITHIN`, and the
curve compared at 100 parameters with what the program says itself: splines at the same parameters, arcs by their
distance and their ends.
"""

import math
import os
import random
import sys
import tempfile
from collections import Counter
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path

from exactspline.interchange import read

#: By how much an arc may be moved, and by how much an answer may differ from that of a program, relative to the size:
#: STEP and IGES are written with 12 and 9 digits.
WITHIN, NEAR = "1e-7", 2e-6
COUNT = 100


@contextmanager
def quiet():
    """Without what a library in C prints."""
    sys.stdout.flush()
    kept, nowhere = os.dup(1), os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)
    try:
        yield
    finally:
        os.dup2(kept, 1)
        os.close(kept)
        os.close(nowhere)


def drawn(random, *, dimension=3):
    """Degree, distinct knots with their multiplicities, points and weights of a random clamped curve."""
    degree, inner = random.randint(1, 5), random.randint(0, 4)
    breaks = sorted(random.sample(range(1, 64), inner))
    times = [degree + 1, *(random.randint(1, degree) for _ in breaks), degree + 1]
    count = sum(times) - degree - 1
    points = [[random.uniform(-100, 100) for _ in range(dimension)] for _ in range(count)]
    weights = [random.uniform(0.5, 2) for _ in range(count)] if random.random() < 0.4 else None
    return degree, [0.0, *(t / 64 for t in breaks), 1.0], times, points, weights


def parameters(low, high):
    return [low + (high - low) * i / (COUNT - 1) for i in range(COUNT)]


def values(curve, low, high):
    """Points of ours at the parameters between two ends, which may be off by rounding."""
    first, last = curve.domain
    found = []
    for t in parameters(low, high):
        exact = min(max(type(first)(t), first), last)
        point = curve(exact, "left" if exact == last else "right")
        found.append([float(x) for x in point] + [0.0] * (3 - len(point)))
    return found


def along(curve):
    """Points of ours over the whole domain."""
    return values(curve, *map(float, curve.domain))


def missed(middle, ends, points):
    """0 where points run through the middle of an arc, infinity where they do not: they are the rest of its circle."""
    nearest = min(math.dist(middle, p) for p in points)
    return 0 if 2 * nearest < min(math.dist(middle, end) for end in ends) else math.inf


# ---- Open CASCADE


def of_open_cascade(random, suffix):
    """An edge of Open CASCADE, and the check of a curve read from its file."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge
    from OCP.collections import Array1_double, Array1_gp_Pnt, Array1_int
    from OCP.Geom import Geom_BSplineCurve, Geom_Circle, Geom_Ellipse
    from OCP.GeomAPI import GeomAPI_ProjectPointOnCurve
    from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt

    def array(kind, entries):
        made = kind(1, len(entries))
        for i, entry in enumerate(entries, 1):
            made.SetValue(i, entry)
        return made

    if random.random() < 0.3:
        axes = gp_Ax2(
            gp_Pnt(*(random.uniform(-9, 9) for _ in range(3))), gp_Dir(*(random.gauss(0, 1) for _ in range(3)))
        )
        radius = random.uniform(0.5, 50)
        round_one = random.random() < 0.6
        curve = (
            Geom_Circle(axes, radius) if round_one else Geom_Ellipse(axes, radius, radius * random.uniform(0.1, 0.9))
        )
        start = random.uniform(0, 3)
        end = start + random.uniform(0.2, 3)
        whole = random.random() < 0.3
        edge = BRepBuilderAPI_MakeEdge(curve) if whole else BRepBuilderAPI_MakeEdge(curve, start, end)
        edge = trimmed(curve, start, end) if suffix == "brep" and not whole else edge.Edge()
        ends = None if whole else [curve.Value(start), curve.Value(end)]

        def check(ours):
            points = along(ours)
            off = [GeomAPI_ProjectPointOnCurve(gp_Pnt(*p), curve).LowerDistance() for p in points]
            if ends is not None:
                found = [gp_Pnt(*points[i]) for i in (0, -1)]
                off += [a.Distance(b) for a, b in zip(ends, found, strict=True)]
                places = [(p.X(), p.Y(), p.Z()) for p in (curve.Value((start + end) / 2), *ends)]
                off.append(missed(places[0], places[1:], points))
            return max(off) / radius

        return edge, check
    degree, breaks, times, points, weights = drawn(random)
    periodic = random.random() < 0.3
    if periodic:
        times = [random.randint(1, degree), *times[1:-1]]
        times.append(times[0])
        count = sum(times[:-1])
        points = [[random.uniform(-100, 100) for _ in range(3)] for _ in range(count)]
        weights = weights and [random.uniform(0.5, 2) for _ in range(count)]
    poles = array(Array1_gp_Pnt, [gp_Pnt(*p) for p in points])
    rest = array(Array1_double, breaks), array(Array1_int, times), degree, periodic
    if len(points) < 2 or (periodic and degree >= len(points)):
        return None
    curve = (
        Geom_BSplineCurve(poles, array(Array1_double, weights), *rest) if weights else Geom_BSplineCurve(poles, *rest)
    )
    low, high = 0.0, 1.0
    if random.random() < 0.5:
        low, high = random.randint(0, 20) / 64, random.randint(40, 64) / 64
        if suffix == "brep" and periodic and random.random() < 0.5:
            low, high = high, 1 + low
    if suffix == "brep" and high - low < 1:
        made = trimmed(curve, low, high)
    else:
        edge = BRepBuilderAPI_MakeEdge(curve) if high - low == 1 else BRepBuilderAPI_MakeEdge(curve, low, high)
        made = edge.Edge() if edge.IsDone() else None

    def check(ours):
        theirs = [curve.Value(t) for t in parameters(low, high)]
        return max(gp_Pnt(*p).Distance(q) for p, q in zip(values(ours, low, high), theirs, strict=True)) / 100

    return (made, check) if made else None


def trimmed(curve, low, high):
    """An edge on a trimmed curve, as BREP files keep it."""
    from OCP.BRep import BRep_Builder
    from OCP.Geom import Geom_TrimmedCurve
    from OCP.TopoDS import TopoDS_Edge

    edge = TopoDS_Edge()
    BRep_Builder().MakeEdge(edge, Geom_TrimmedCurve(curve, low, high), 1e-7)
    return edge


def open_cascade(random, folder, suffix):
    found = None
    while found is None:
        found = of_open_cascade(random, suffix)
    edge, check = found
    place = f"{folder}/a.{suffix}"
    with quiet():
        if suffix == "brep":
            from OCP.BRepTools import BRepTools

            BRepTools.Write_s(edge, place)
        elif suffix == "stp":
            from OCP.STEPControl import STEPControl_StepModelType, STEPControl_Writer

            writer = STEPControl_Writer()
            writer.Transfer(edge, STEPControl_StepModelType.STEPControl_AsIs)
            writer.Write(place)
        else:
            from OCP.IGESControl import IGESControl_Writer

            writer = IGESControl_Writer()
            writer.AddShape(edge)
            writer.ComputeModel()
            writer.Write(place)
    return place, check


# ---- ezdxf


def in_dxf(random, folder):
    import ezdxf
    from ezdxf.math import BSpline

    document = ezdxf.new()
    space = document.modelspace()
    kind = random.choice(("spline", "spline", "closed", "arc", "ellipse", "polyline"))
    size = 100.0
    if kind == "spline":
        degree, breaks, times, points, weights = drawn(random)
        knots = [t for t, n in zip(breaks, times, strict=True) for _ in range(n)]
        theirs = BSpline(points, degree + 1, knots, weights)
        space.add_spline().apply_construction_tool(theirs)

        def check(ours):
            pairs = zip(values(ours, 0, 1), theirs.points(parameters(0, 1)), strict=True)
            return max(math.dist(p, q) for p, q in pairs) / size
    elif kind == "closed":
        degree, count = random.randint(2, 4), random.randint(5, 9)
        points = [[random.uniform(-100, 100) for _ in range(3)] for _ in range(count)]
        entity = space.add_spline()
        entity.set_closed(points, degree)
        theirs = entity.construction_tool()

        def check(ours):
            low, high = map(float, ours.domain)
            pairs = zip(values(ours, low, high), theirs.points(parameters(low, high)), strict=True)
            return max(math.dist(p, q) for p, q in pairs) / size
    elif kind == "polyline":
        vertices = [(random.uniform(-9, 9), random.uniform(-9, 9), 0, 0, random.uniform(-1, 1)) for _ in range(5)]
        entity = space.add_lwpolyline(vertices, format="xyseb")
        parts = [(p.dxftype(), p) for p in entity.virtual_entities()]

        def check(ours):
            off = []
            for p in along(ours):
                off.append(min(away(part, p[:2]) for _, part in parts))
            points = [p[:2] for p in along(ours)]
            for kind, part in parts:
                a, b = ((p.x, p.y) for p in ends_of(part))
                middle = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2) if kind == "LINE" else middle_of(part)
                off.append(missed(middle, [a, b], points))
            return max(off) / 9
    else:
        centre, radius = (random.uniform(-9, 9), random.uniform(-9, 9)), random.uniform(0.5, 50)
        start, end = random.uniform(-180, 180), random.uniform(-180, 180)
        ratio = random.uniform(0.1, 1) if kind == "ellipse" else 1
        if kind == "arc":
            entity = space.add_arc(centre, radius, start, end)
            middle = middle_of(entity)
        else:
            a, b = sorted((math.radians(start), math.radians(end)))
            entity = space.add_ellipse(centre, (radius, 0), ratio, a, b)
            turned = (a + b) / 2
            middle = (centre[0] + radius * math.cos(turned), centre[1] + radius * ratio * math.sin(turned))
        ends = [(p.x, p.y) for p in (entity.start_point, entity.end_point)]

        def check(ours):
            points = [p[:2] for p in along(ours)]
            off = [abs(math.hypot((x - centre[0]) / radius, (y - centre[1]) / (radius * ratio)) - 1) for x, y in points]
            gaps = [math.dist(points[i], ends[i]) / radius for i in (0, -1)]
            return max(off + gaps + [missed(middle, ends, points)])

    place = f"{folder}/a.dxf"
    document.saveas(place)
    return place, check


def ends_of(part):
    return (part.dxf.start, part.dxf.end) if part.dxftype() == "LINE" else (part.start_point, part.end_point)


def middle_of(arc):
    start, end = arc.dxf.start_angle, arc.dxf.end_angle
    angle = math.radians(start + (end - start) % 360 / 2)
    return (arc.dxf.center.x + arc.dxf.radius * math.cos(angle), arc.dxf.center.y + arc.dxf.radius * math.sin(angle))


def away(part, point):
    """The distance of a point from a line or an arc of ezdxf."""
    if part.dxftype() == "LINE":
        a, b = part.dxf.start, part.dxf.end
        t = ((point[0] - a.x) * (b.x - a.x) + (point[1] - a.y) * (b.y - a.y)) / ((b - a).magnitude ** 2)
        t = min(max(t, 0), 1)
        return math.dist(point, (a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)))
    centre = part.dxf.center
    return abs(math.dist(point, (centre.x, centre.y)) - part.dxf.radius)


# ---- rhino3dm


def in_3dm(random, folder):
    import rhino3dm

    model = rhino3dm.File3dm()
    if random.random() < 0.5:
        plane = rhino3dm.Plane(
            rhino3dm.Point3d(*(random.uniform(-9, 9) for _ in range(3))),
            rhino3dm.Vector3d(*(random.gauss(0, 1) for _ in range(3))),
        )
        radius, angle = random.uniform(0.5, 50), random.uniform(0.1, 6.2)
        arc = rhino3dm.Arc(rhino3dm.Point3d(0, 0, 0), radius, angle)
        arc.Plane = plane
        theirs = rhino3dm.ArcCurve.CreateFromArc(arc)

        def check(ours):
            points = [rhino3dm.Point3d(*p) for p in along(ours)]
            off = [p.DistanceTo(arc.ClosestPoint(p)) for p in points]
            off += [points[0].DistanceTo(theirs.PointAtStart), points[-1].DistanceTo(theirs.PointAtEnd)]
            middle, *ends = ((p.X, p.Y, p.Z) for p in (arc.MidPoint, theirs.PointAtStart, theirs.PointAtEnd))
            off.append(missed(middle, ends, along(ours)))
            return max(off) / radius
    else:
        degree, breaks, times, points, weights = drawn(random)
        knots = [t for t, n in zip(breaks, times, strict=True) for _ in range(n)][1:-1]
        theirs = rhino3dm.NurbsCurve(3, weights is not None, degree + 1, len(points))
        for i, (p, w) in enumerate(zip(points, weights or [1.0] * len(points), strict=True)):
            theirs.Points[i] = rhino3dm.Point4d(*(x * w for x in p), w)
        for i, t in enumerate(knots):
            theirs.Knots[i] = t

        def check(ours):
            inside = parameters(0, 1)
            pairs = zip(values(ours, 0, 1), map(theirs.PointAt, inside), strict=True)
            return max(rhino3dm.Point3d(*p).DistanceTo(q) for p, q in pairs) / 100

    model.Objects.AddCurve(theirs)
    place = f"{folder}/a.3dm"
    model.Write(place, 7)
    return place, check


# ---- geomdl


def in_geomdl(random, folder):
    from geomdl import NURBS, exchange
    from geomdl import BSpline as Polynomial

    degree, breaks, times, points, weights = drawn(random)
    theirs = NURBS.Curve(normalize_kv=False) if weights else Polynomial.Curve(normalize_kv=False)
    theirs.degree = degree
    if weights:
        theirs.ctrlptsw = [[*(x * w for x in p), w] for p, w in zip(points, weights, strict=True)]
    else:
        theirs.ctrlpts = points
    theirs.knotvector = [t for t, n in zip(breaks, times, strict=True) for _ in range(n)]
    place = f"{folder}/a.json"
    exchange.export_json(theirs, place)

    def check(ours):
        pairs = zip(values(ours, 0, 1), map(theirs.evaluate_single, parameters(0, 1)), strict=True)
        return max(math.dist(p, q) for p, q in pairs) / 100

    return place, check


#: What is written, the module that writes it, and how often for one archive of rhino3dm.
PROGRAMS = {
    "step": ("OCP", lambda random, folder: open_cascade(random, folder, "stp"), 8),
    "iges": ("OCP", lambda random, folder: open_cascade(random, folder, "igs"), 8),
    "brep": ("OCP", lambda random, folder: open_cascade(random, folder, "brep"), 4),
    "dxf": ("ezdxf", in_dxf, 12),
    "geomdl": ("geomdl", in_geomdl, 7),
    "3dm": ("rhino3dm", in_3dm, 1),
}


def campaign(count, seed, names=()):
    """For how many files of each format the curves are the same, differ, or are not read."""
    known = [n for n, (module, *_) in PROGRAMS.items() if find_spec(module) and (not names or n in names)]
    wheel = [name for name in known for _ in range(PROGRAMS[name][2])]
    found, worst = Counter(), {}
    with tempfile.TemporaryDirectory() as folder:
        for number in range(count):
            name = wheel[number % len(wheel)]
            place, check = PROGRAMS[name][1](random.Random(f"{seed} {number}"), folder)
            reading = read(place, approximate=WITHIN)
            if len(reading.curves) != 1:
                found[name, "not read"] += 1
                sys.stdout.write(f"{name} {number}: {[str(each) for each in reading.skipped]}\n")
                continue
            off = check(reading.curve)
            worst[name] = max(worst.get(name, 0), off)
            found[name, "same" if off < NEAR else "differs"] += 1
            if off >= NEAR:
                sys.stdout.write(f"{name} {number}: {off:.3g} {reading.curves[0].notes}\n")
            Path(place).unlink()
    return found, worst


if __name__ == "__main__":
    results, furthest = campaign(int(sys.argv[1]), int(sys.argv[2]), sys.argv[3:])
    for (format, outcome), times in sorted(results.items()):
        sys.stdout.write(f"{format}: {times} {outcome}, at most {furthest.get(format, 0):.2g} apart\n")
    sys.exit(any(outcome != "same" for _, outcome in results))
