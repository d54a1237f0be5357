"""Files that take a while, or are too large: what is refused is counted before it is built, and reading is shown."""

import os
import pty
import subprocess
import sys
import time

import pytest

from exactspline import ExactSplineError, Nurbs, read
from exactspline.interchange import Limits
from exactspline.interchange.collector import Collector
from exactspline.interchange.files import encoded
from tests.interchange.test_shared_files import FOLDER, needs_files
from tests.support.interchange_seeds import STEP, seeds


def step(splines, points=8, kind="B_SPLINE_CURVE_WITH_KNOTS"):
    """A file with cubics, each of points of its own."""
    lines, k = ["ISO-10303-21;", "HEADER;", "ENDSEC;", "DATA;"], 0
    knots = f",(4,{'1,' * (points - 4)}4),({','.join(f'{i}.' for i in range(points - 2))}),.UNSPECIFIED."
    for i in range(splines):
        listed = []
        for j in range(points):
            k += 1
            lines.append(f"#{k}=CARTESIAN_POINT('',({i}.5,{j}.25,{i * j}.));")
            listed.append(f"#{k}")
        k += 1
        own = knots if kind == "B_SPLINE_CURVE_WITH_KNOTS" else ""
        lines.append(f"#{k}={kind}('',3,({','.join(listed)}),.UNSPECIFIED.,.F.,.F.{own});")
    return "\n".join([*lines, "ENDSEC;", "END-ISO-10303-21;"]).encode()


@pytest.fixture
def counts(monkeypatch):
    """How many objects a reader said to be there before it built any, and how many it counted in the end."""
    told, whole = [], {}
    room, count = Collector.room, Collector.count

    def told_room(self, objects):
        if not self.curves and not self._objects:
            told.append(objects)
        room(self, objects)

    def counted(self, objects):
        count(self, objects)
        whole[id(self)] = self._objects

    monkeypatch.setattr(Collector, "room", told_room)
    monkeypatch.setattr(Collector, "count", counted)
    return told, whole


@pytest.mark.parametrize("kind", ["B_SPLINE_CURVE_WITH_KNOTS", "UNIFORM_CURVE", "QUASI_UNIFORM_CURVE"])
@pytest.mark.parametrize("points", [4, 8, 40])
def test_what_is_counted_before_is_less_than_what_is_there_but_not_by_much(counts, kind, points):
    told, whole = counts
    assert len(read(step(20, points, kind)).curves) == 20
    [least] = told
    assert 0.75 * max(whole.values()) < least <= max(whole.values())


@needs_files
@pytest.mark.parametrize("name", ["as1_tc_214.stp", "oce_screw.step", "rhino_splinecage.stp"])
def test_no_real_file_is_refused_that_could_be_read(counts, name):
    told, whole = counts
    read(FOLDER / name)
    assert told[0] <= max(whole.values())


def test_no_small_file_is_refused_that_could_be_read(counts):
    told, whole = counts
    for data in (STEP, *seeds()["dxf"]):
        told.clear()
        whole.clear()
        read(data)
        assert told[0] <= max(whole.values())


@pytest.mark.parametrize("data", [step(300), b"0\nSECTION\n2\nENTITIES\n" + b"0\nLINE\n10\n0\n" * 9000 + b"0\nEOF\n"])
def test_a_file_beyond_the_limits_is_refused_before_anything_is_built(data, monkeypatch):
    """Seconds before: when as many curves were built as the limits allow."""
    built = []
    monkeypatch.setattr(Collector, "built", lambda *a, **b: built.append(a))
    with pytest.raises(ExactSplineError, match=r"more than 17000 objects; divide the file, or read it in Python"):
        read(data, limits=Limits(objects=17_000))
    assert not built


@pytest.fixture(scope="module")
def long_file():
    """One that takes more than a second."""
    curve = Nurbs(3, [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4], [(i, i * i % 5) for i in range(7)], name="c")
    return encoded([curve] * 6000, "dxf")[0]


@pytest.mark.parametrize(("command", "shown"), [
    (["inspect", "long.dxf", "--emit-coq", "several.v"], True),
    (["convert", "long.dxf", "out.json", "--only", "nothing"], True),
    (["inspect", "long.dxf:nowhere", "--quiet"], False),
])  # fmt: skip
def test_reading_is_shown_on_a_terminal(tmp_path, command, shown, long_file):
    (tmp_path / "long.dxf").write_bytes(long_file)
    ours, theirs = pty.openpty()
    done = subprocess.Popen(
        [sys.executable, "-m", "exactspline", *command], stdout=subprocess.DEVNULL, stderr=theirs, cwd=tmp_path,
        env=os.environ | {"TERM": "xterm", "COLUMNS": "80"},
    )  # fmt: skip
    os.close(theirs)
    told = b""
    start = time.monotonic()
    while time.monotonic() - start < 120:
        try:
            told += os.read(ours, 4096)
        except OSError:
            break
    assert done.wait() == 2
    assert (b"reading long.dxf" in told) == shown
    assert b"error" in told


def test_nothing_is_shown_in_a_pipe(tmp_path, long_file):
    (tmp_path / "long.dxf").write_bytes(long_file)
    done = subprocess.run(
        [sys.executable, "-m", "exactspline", "inspect", "long.dxf:nowhere"], capture_output=True, cwd=tmp_path,
        check=False,
    )  # fmt: skip
    assert b"reading" not in done.stderr
