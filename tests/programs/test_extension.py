"""The optional extension: what it decides is what exact arithmetic decides, in every rounding mode, also where its
numbers overflow; it touches no memory that is not its own; and nothing depends on it.
"""

import gc
import importlib
import os
import pickle
import random
import shutil
import subprocess
import sys
import weakref
from array import array
from ctypes import byref, c_void_p
from functools import cache
from hashlib import sha256
from math import isnan
from pathlib import Path
from typing import Any

import pytest
from gmpy2 import mpq

from exactspline import Nurbs, analyse, example
from exactspline.geometry.analysis.curves import Analysis
from exactspline.geometry.curves.plane_programs import CRITICAL, CURVATURE, plane_program
from exactspline.geometry.filter.certain import certain
from exactspline.numbers import extension
from exactspline.programs import accelerator
from exactspline.programs.certain_pairs import ARCH, LINE, certain_pair, segment_in_doubles, table_of
from tests.campaigns import filter as campaign
from tests.support.rounding import FLUSHED, MODES, rounding

ROOT = Path(__file__).parents[2]

needs_extension = pytest.mark.skipif(accelerator.filter_curve is None, reason="there is no extension here")


@needs_extension
def test_what_is_certain_is_what_exact_arithmetic_decides(capsys):
    assert campaign.main(1500, seed=32) == 0
    assert "0 wrong" in capsys.readouterr().out


@needs_extension
@pytest.mark.parametrize("mode", [*MODES, *FLUSHED])
def test_answers_do_not_depend_on_the_rounding_of_the_processor(mode):
    chance = random.Random(mode)
    for _ in range(40):
        curve = chance.choice(campaign.FAMILIES)(chance)
        facts = Analysis(curve)
        with rounding(mode):
            known = certain(facts)
        if known is not None:
            true = campaign.exact(curve)
            assert [f.kind for f in known.inflections] == [f.kind for f in true.inflections]
            for mine, other in zip(known.critical_points, true.critical_points, strict=True):
                assert mine.kind == other.kind
                assert mine.root == other.root


@needs_extension
@pytest.mark.parametrize("mode", [*MODES, *FLUSHED])
def test_the_nearest_doubles_are_known_where_the_processor_rounds_to_nearest(mode):
    """Nearly all of them; in the other modes exact arithmetic decides."""
    chance, some, unknown = random.Random(5), 0, 0
    for _ in range(60):
        known = certain(Analysis(chance.choice((campaign.closed, campaign.contour))(chance)))
        if known is not None:
            count = sum(map(known.found.count, (CURVATURE, CRITICAL)))
            with rounding(mode):
                unknown += sum(isnan(known.nearest(k)) for k in range(count))
            some += count
    assert some > 100
    assert unknown <= some // 50 if mode in ("nearest", *FLUSHED) else unknown == some


@needs_extension
def test_single_segments_of_a_long_curve_do_not_leave_the_others_undecided():
    """Far from the origin the zeros of κ and κ′ of some segments are not told apart at first: the whole curve was left
    to exact arithmetic for one such segment.
    """
    chance, segments = random.Random(1), 1200
    points = [(i, chance.randint(-9, 9)) for i in range(segments + 3)]
    curve = Nurbs(3, [0] * 3 + list(range(segments + 1)) + [segments] * 3, points)
    count, what = campaign.differing(curve)
    assert what == ""
    assert count is not None
    assert count > segments
    assert analyse(curve).straight_pieces == campaign.exact(curve).straight_pieces


@needs_extension
@pytest.mark.parametrize("size", [mpq(1, 2**2000), mpq(1, 2**600), mpq(2) ** 499, mpq(2) ** 600, mpq(2) ** 2000])
def test_numbers_of_any_size_are_decided_rightly(size):
    curve = example("six_segment_cubic")
    points = [(x * size, y) for x, y in curve.control_points]
    for own in (points, [(y * size, x * size) for x, y in curve.control_points]):
        count, what = campaign.differing(Nurbs(3, curve.knots, own))
        assert what == ""
        assert count is None or count > 0


@needs_extension
def test_a_curve_far_from_the_origin_is_decided_like_one_near_it():
    """Before, a curve moved by 10¹² was left to exact arithmetic, and 3,346 of 8,000 segments of one that proceeds from
    x = 0 to x = 8,000.
    """
    near = example("six_segment_cubic")
    far = near.transform([[1, 0, 10**12], [0, 1, -(3**20)]])
    known = [certain(Analysis(curve)) for curve in (near, far)]
    assert [len(zeros) for one in known for zeros in (one.inflections, one.critical_points)] == [2, 8, 2, 8]


@needs_extension
def test_a_known_root_is_the_exact_number_and_can_be_kept():
    curve = Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (1, 2), (2, -2), (3, 0)])
    (bend,) = analyse(curve).inflections
    assert bend.root.exact == mpq(1, 2)
    low, high = bend.root.refine(50)
    assert low <= mpq(1, 2) <= high
    kept = pickle.loads(pickle.dumps(analyse(curve).curvature_extrema))
    assert kept == analyse(curve).curvature_extrema
    for one, other in zip(kept, campaign.exact(curve).curvature_extrema, strict=True):
        assert float(one.root) == float(other.root)
        assert one.root.polynomial == other.root.polynomial


def test_an_analysed_curve_is_freed_without_the_collector():
    curve = example("six_segment_cubic").insert_knot("1/7")
    gc.disable()
    try:
        analysis = analyse(curve)
        known = [f.root for f in (*analysis.inflections, *analysis.curvature_extrema, *analysis.singular_points)]
        assert known
        assert analysis.joints
        assert analyse(curve) is analysis
        gone = weakref.ref(curve), weakref.ref(analysis)
        del analysis
        assert gone[1]() is None
        assert analyse(curve).inflections[0].root is known[0]
        del curve
        assert gone[0]() is None
    finally:
        gc.enable()


@pytest.fixture
def builder(monkeypatch) -> Any:
    """The program that compiles the extension."""
    monkeypatch.syspath_prepend(ROOT)
    return importlib.import_module("hatch_build")


def in_a_checkout(test: Any) -> Any:
    """A test that compiles the extension."""
    there = (ROOT / "hatch_build.py").exists() and shutil.which("cc") is not None
    return pytest.mark.skipif(not there, reason="there is no compiler, or no checkout")(test)


SANITIZED = ("-fsanitize=address,undefined", "-fno-sanitize-recover=undefined", "-g")


@pytest.mark.skipif(sys.platform != "linux", reason="the sanitizer is loaded before Python as on Linux")
@in_a_checkout
@pytest.mark.parametrize("campaign_of", ["filter 60", "certain_pairs 110"])
def test_no_memory_but_its_own_is_touched(tmp_path, campaign_of, builder):
    library = tmp_path / "filter.lib"
    if not builder.compiled(library, *SANITIZED):
        pytest.skip("there is no compiler with sanitizers")
    asan = subprocess.run(["cc", "-print-file-name=libasan.so"], capture_output=True, text=True, check=False)
    environment = os.environ | {
        "LD_PRELOAD": asan.stdout.strip(),
        "ASAN_OPTIONS": "detect_leaks=0",
        "EXACTSPLINE_EXTENSION": str(library),
    }
    command = [sys.executable, "-m", *f"tests.campaigns.{campaign_of} 5".split()]
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "0 wrong" in done.stdout


@in_a_checkout
def test_the_extension_of_this_checkout_is_used():
    assert accelerator.filter_curve is not None, "compile it anew: python hatch_build.py"


@in_a_checkout
def test_it_compiles_without_a_warning_and_with_all_words_of_the_compiler(tmp_path, builder, monkeypatch, capsys):
    """A warning of a user's compiler ended the build, of CC the first word alone was run, and 70 kB of results lay on
    the stack of whatever thread asked.
    """
    monkeypatch.setenv("CC", "env cc")
    assert builder.compiled(tmp_path / "strict.lib", "-Werror", "-Wframe-larger-than=8192")
    assert builder.compiled(tmp_path / "filter.lib", "-O0", "-Wframe-larger-than=16")
    assert capsys.readouterr().err == ""
    assert {file.suffix for file in tmp_path.iterdir()} == {".lib", ".sha256"}


@in_a_checkout
def test_operations_in_another_order_are_refused_by_source_and_by_builder(tmp_path, builder, monkeypatch):
    """Part of -ffast-math, chosen alone, was compiled: sums in another order have other errors than those proved."""
    reordered = "cc -fassociative-math -fno-signed-zeros -fno-trapping-math"
    command = [*reordered.split(), "-std=c11", "-fsyntax-only", str(builder.SOURCE)]
    macros = subprocess.run(
        [*reordered.split(), "-dM", "-E", "-"], input="", capture_output=True, text=True, check=True
    )
    if "__ASSOCIATIVE_MATH__" in macros.stdout:
        assert subprocess.run(command, capture_output=True, check=False).returncode != 0
    monkeypatch.setenv("CC", reordered)
    assert builder.compiled(tmp_path / "filter.lib", "-O0")


@in_a_checkout
def test_what_a_distribution_asks_of_the_compiler_is_asked_but_for_what_changes_results(
    tmp_path, builder, monkeypatch, capsys
):
    """CFLAGS were ignored; those that let sums be taken in another order are taken back."""
    monkeypatch.setenv("CFLAGS", "-O3 -fassociative-math -fno-such-option")
    assert not builder.compiled(tmp_path / "filter.lib")
    assert "fno-such-option" in capsys.readouterr().err
    monkeypatch.setenv("CFLAGS", "-O3 -fassociative-math -fno-signed-zeros -fno-trapping-math")
    assert builder.compiled(tmp_path / "filter.lib")


@pytest.mark.parametrize(
    ("platform", "flags", "tag"),
    [
        ("linux-x86_64", "", "py3-none-linux_x86_64"),
        ("macosx-11.0-arm64", "", "py3-none-macosx_11_0_arm64"),
        ("macosx-11.0-arm64", "-arch x86_64", "py3-none-macosx_11_0_x86_64"),
        ("macosx-10.13-x86_64", "-arch arm64 -arch x86_64", "py3-none-macosx_10_13_universal2"),
    ],
)
def test_the_tag_is_that_of_what_was_compiled(builder, monkeypatch, platform, flags, tag):
    monkeypatch.setattr(builder.sysconfig, "get_platform", lambda: platform)
    monkeypatch.setenv("ARCHFLAGS", flags)
    assert builder.tag() == tag


#: Asked of a library: whether it is used, and an answer to 30 digits.
ASKED = """
from exactspline import Nurbs, analyse
from exactspline.programs import accelerator
a = analyse(Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (1, 2), (2, -2), (3, 1)]))
found = [(f.kind.value, f.root.decimal(30)) for f in (*a.inflections, *a.curvature_extrema)]
print(accelerator.filter_curve is None, found)
"""


@cache
def asked_with(library: object) -> str:
    """Whether a fresh Python does without this library, and what it answers."""
    environment = os.environ | {"EXACTSPLINE_EXTENSION": str(library)}
    command = [sys.executable, "-c", ASKED]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False, timeout=30)
    assert done.returncode == 0, (done.returncode, done.stderr)
    return done.stdout


def truncated(made: bytes) -> bytes:
    """Half of a file."""
    return made[: len(made) // 2]


def flipped(made: bytes) -> bytes:
    """A file behind whose header a bit of every 61st byte is changed."""
    changed = bytearray(made)
    for k in range(1024, len(made), 61):
        changed[k] ^= 4
    return bytes(changed)


@needs_extension
@pytest.mark.parametrize("damaged", [truncated, flipped])
def test_a_damaged_library_is_not_loaded(tmp_path, damaged):
    """It ended Python without a word (SIGBUS, SIGSEGV), or was believed."""
    made = Path(extension.LIBRARY)
    for file in made.parent.glob(f"{made.name}*"):
        shutil.copy(file, tmp_path)
    library = tmp_path / made.name
    library.write_bytes(damaged(made.read_bytes()))
    assert asked_with(library) == asked_with("none")


@in_a_checkout
def test_a_library_of_another_source_is_not_believed(tmp_path, builder, monkeypatch):
    """With two instructions exchanged the refinement of a zero never ended, with two others a maximum was a minimum.
    The first has the digest of its own source, the second one that is forged: what the instructions do tells.
    """
    here = builder.SOURCE.read_bytes()
    exchanged = {"own": b"RAISE, SUM, DERIVE, DU, DV,", "forged": b"SUM, RAISE, DERIVE, DV, DU,"}
    for digest, instructions in exchanged.items():
        other, library = tmp_path / "filter.c", tmp_path / f"{digest}.lib"
        other.write_bytes(here.replace(b"SUM, RAISE, DERIVE, DU, DV,", instructions))
        monkeypatch.setattr(builder, "SOURCE", other)
        assert builder.compiled(library, "-O0")
        if digest == "forged":
            forged = sha256(here + library.read_bytes()).hexdigest()
            library.with_name(f"{library.name}.sha256").write_text(forged, encoding="ascii")
        assert asked_with(library) == asked_with("none")


@needs_extension
def test_what_is_not_a_number_is_not_made_small():
    """0/0 was asked for its exponent, which C leaves open."""
    program = accelerator._in_c(plane_program(3, False))
    data, found = array("d", [0, 1, 2, 3] * 2 + [0]), array("d", bytes(8 * 99))
    assert accelerator.filter_curve(byref(program), data.buffer_info()[0], 1, found.buffer_info()[0], 8) == -1
    for k in range(len(segment_in_doubles(*ARCH))):
        ours = array("d", segment_in_doubles(*ARCH))
        ours[k] = float("nan")
        assert certain_pair(ours.tobytes(), 0, table_of([LINE]), 0) is None


def test_without_the_extension_the_answers_are_the_same():
    code = (
        "from exactspline import analyse, example; from exactspline.programs import accelerator; "
        "a = analyse(example('six_segment_cubic')); print(accelerator.filter_curve is None, "
        "[(f.kind.value, f.by_jump, float(f.root)) for f in (*a.inflections, *a.curvature_extrema)])"
    )
    told = []
    for library in ("none", ""):
        environment = os.environ | {"EXACTSPLINE_EXTENSION": library}
        done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True)
        told.append(done.stdout.split(" ", 1))
    assert told[0][0] == "True"
    assert told[0][1] == told[1][1]


@needs_extension
def test_who_loads_a_function_without_types_leaves_those_of_others():
    """Ended the process before: there was one function for all, and then its pointers were cut to 32 bits."""
    typed = extension.loaded("curve_points", lambda function: True, *[c_void_p] * 5)
    assert extension.loaded("curve_points", lambda function: True) is not typed
    assert [*typed.argtypes] == [c_void_p] * 5
