"""The page has no gmpy2: with its stand-in the library gives the same answers."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

import exactspline as xs

PYTHON = Path(__file__).parents[2] / "docs" / "play" / "python"
pytestmark = pytest.mark.skipif(not PYTHON.exists(), reason="the pages are not part of the package")

#: The page has none of these modules either: before, the library could not be imported there.
ASK = """
import json, sys
sys.modules |= dict.fromkeys(["_multiprocessing", "fcntl", "numpy", "resource", "scipy", "sympy"])
import gmpy2, page
for line in sys.stdin:
    print(page.answer(*json.loads(line)))
print(gmpy2.__file__)
"""


def as_the_page_holds_it(curve: xs.Nurbs) -> dict[str, object]:
    """Every number as text."""
    points = [[str(x) for x in point] for point in curve.control_points]
    knots, weights = [str(t) for t in curve.knots], [str(w) for w in curve.weights]
    return {"degree": curve.degree, "knots": knots, "points": points, "weights": weights}


def answers(questions: list[tuple[str, str]], folder: Path) -> list[str]:
    """What a fresh Python answers whose gmpy2 is the one in a folder, if there is one."""
    environment = {**os.environ, "MPMATH_NOGMPY": "1", "PYTHONPATH": os.pathsep.join([str(folder), *sys.path])}
    lines = "\n".join(map(json.dumps, questions))
    command = [sys.executable, "-c", ASK]
    done = subprocess.run(command, input=lines, env=environment, capture_output=True, text=True, check=True)
    return done.stdout.splitlines()


def test_the_pages_answers_do_not_depend_on_gmpy2(tmp_path):
    (tmp_path / "page.py").write_text((PYTHON / "page.py").read_text(encoding="utf-8"), encoding="utf-8")
    curves = [xs.example(name) for name in ("cubic_s", "ellipse", "rational_cubic", "cusp", "six_segment_cubic")]
    held = [as_the_page_holds_it(curve) for curve in curves]
    questions = [("features", json.dumps(curve)) for curve in held]
    questions += [("forms", json.dumps({"curve": held[0], "variants": ["squaring", "paper", "minimal"]}))]
    questions += [("bisector", json.dumps({"curve": held[0], "point": ["7/4", "3/2"]}))]
    questions += [("pair", json.dumps({"first": held[0], "second": held[1], "bisector": True}))]
    questions += [("triangle", json.dumps({"curve": curve, "share": "17/60"})) for curve in held]
    questions += [("refined", json.dumps({"curve": curve, **how})) for curve in held for how in ({"knot": "2/7"}, {})]
    text = "from exactspline.language import det\n\n\ndef f(c):\n    return det(c.gamma.d(1), c.gamma.d(2))\n"
    questions += [("reduce", json.dumps({"text": text, "dimension": 2, "polynomial": False}))]
    with_gmpy2, stand_in = answers(questions, tmp_path), answers(questions, PYTHON)
    assert [told[-1].startswith(str(PYTHON)) for told in (stand_in, with_gmpy2)] == [True, False]
    assert all("error" not in json.loads(answer) for answer in with_gmpy2[:-1])
    assert stand_in[:-1] == with_gmpy2[:-1]
    same = [told["same"] for answer in stand_in[:-1] if "same" in (told := json.loads(answer)["answer"])]
    assert same == [True] * (2 * len(held))
