"""The optional extension: what it decides is what exact arithmetic decides, in every rounding mode, also where its
numbers overflow; it touches no memory that is not its own; and nothing depends on it.
"""

import gc
import os
import pickle
import random
import subprocess
import sys
import weakref
from pathlib import Path

import pytest

from exactspline import Nurbs, analyse, example
from exactspline.geometry.analysis import Analysis
from exactspline.geometry.certain import certain
from exactspline.numbers.exact import mpq
from exactspline.programs import accelerator
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
    assert [len(zeros) for one in known for zeros in one.zeros] == [2, 8, 2, 8]


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


SANITIZED = ("-fsanitize=address,undefined", "-fno-sanitize-recover=undefined", "-g")


@pytest.mark.skipif(sys.platform != "linux", reason="the sanitizer is loaded before Python as on Linux")
@pytest.mark.parametrize("campaign_of", ["filter 400", "certain_pairs 660"])
def test_no_memory_but_its_own_is_touched(tmp_path, campaign_of):
    sys.path.insert(0, str(ROOT))
    try:
        import hatch_build
    finally:
        sys.path.remove(str(ROOT))
    library = tmp_path / "filter.lib"
    if not hatch_build.compiled(library, *SANITIZED):
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
