"""What `docs/for-your-tests.md` promises to those who test programs of their own, carried out as written there."""

import json
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import find

import exactspline as xs
from exactspline import testing
from exactspline.errors import CurveFileError
from tests.support.command import run

PAGE = Path(__file__).parents[2] / "docs" / "for-your-tests.md"
BLOCKS = [part.partition("```")[0] for part in PAGE.read_text().split("```python\n")[1:]]
#: A program that finds inflections from the signs of κ at nine parameters, and therefore misses pairs of them.
SAMPLED = """
def inflections(points):
    ys = [y for _, y in points]
    xs = [x for x, _ in points]
    if xs != sorted(xs) or len(set(b - a for a, b in zip(xs, xs[1:]))) > 1:
        xs, ys = ys, xs
    bends = [a - 2 * b + c for a, b, c in zip(ys, ys[1:], ys[2:])]
    signs = [((9 - k) ** 2 * bends[0] + 2 * k * (9 - k) * bends[1] + k * k * bends[2]) > 0 for k in range(10)]
    return [k for k in range(9) if signs[k] != signs[k + 1]]
"""


def pytest_in(folder: Path, *options: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *options, str(folder)]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


def test_the_example_finds_what_a_program_misses(tmp_path: Path) -> None:
    (tmp_path / "my_library.py").write_text(SAMPLED)
    (tmp_path / "test_mine.py").write_text(BLOCKS[0])
    assert len([line for line in BLOCKS[0].splitlines() if line.strip()]) <= 10
    done = pytest_in(tmp_path)
    assert done.returncode == 1, done.stdout
    assert "AssertionError" in done.stdout
    right = "import exactspline as xs\n\ndef inflections(points):\n    degree = len(points) - 1\n"
    right += "    curve = xs.Nurbs.from_floats(degree, [0] * len(points) + [1] * len(points), points)\n"
    (tmp_path / "my_library.py").write_text(right + "    return list(xs.analyse(curve).inflections)\n")
    assert pytest_in(tmp_path).returncode == 0


def test_the_fixture_runs_once_per_case(tmp_path: Path) -> None:
    (tmp_path / "conftest.py").write_text(BLOCKS[1])
    (tmp_path / "test_mine.py").write_text("def test_it(nasty_case):\n    assert nasty_case.curve.degree < 5\n")
    assert f"{len(list(testing.all_cases(3)))} passed" in pytest_in(tmp_path, "--nasty", "3").stdout


def test_shapes_are_degenerate_as_their_names_say() -> None:
    for k, sign in ((2, 1), (52, -1)):
        assert find(testing.near("cusp"), lambda c, k=k, sign=sign: c.name == f"near {k} cusp" and sign).degree == 3
    two = find(testing.near_double_inflections(), lambda c: len(xs.analyse(c).inflections) == 2)
    none = find(testing.near_double_inflections(), lambda c: not xs.analyse(c).inflections)
    assert two != none
    with pytest.raises(CurveFileError, match="cusp"):
        testing.near("cups")
    with pytest.raises(CurveFileError, match="fonts"):
        testing.nasty_curves(["font"])


ICON = """<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0C2 2 {end} 2 0"/>{text}</svg>"""


def test_points_in_lines_have_coordinates_and_curvature(tmp_path: Path) -> None:
    (tmp_path / "a.svg").write_text(ICON.format(end="0 2", text=""))
    lines = run("sweep", str(tmp_path), "--find", "cusps", "--find", "curvature_extrema", "--values", "-o", "-").stdout
    found = json.loads(lines)["found"]
    assert [(p["x"], p["y"], p["z"], p["curvature"]) for p in found["cusps"]] == [(1.0, 1.5, None, None)]
    (line,) = xs.sweep(["ellipse"], find=["curvature_extrema"], values=True)
    assert [(p.x, p.y, p.curvature) for p in line.found["curvature_extrema"]][:2] == [(2.0, 0.0, 2.0), (0.0, 1.0, 0.25)]
    near = xs.Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (2, 2), ("1/100", 2), (2, 0)])
    (line,) = xs.sweep([near], find=["cusps_within:1/50"], values=True)
    [place] = line.found["cusps_within:1/50"]
    assert (round(place.x), round(2 * place.y)) == (1, 3), "passed before: a near cusp without coordinates"
    (line,) = xs.sweep(["straight_between_arcs"], find=["joints"], values=True)
    assert [p.curvature for p in line.found["joints"]] == [None, None], "the curvature jumps there"


def test_strict_is_2_where_anything_is_left_out(tmp_path: Path) -> None:
    whole, text = tmp_path / "whole.svg", tmp_path / "text.svg"
    whole.write_text(ICON.format(end="0 2", text=""))
    text.write_text(ICON.format(end="0 2", text="<text>not a curve</text>"))
    for words in (("inspect",), ("sweep", "-o", str(tmp_path / "lines.jsonl")), ("inspect", "--ask", "cusps")):
        assert run(words[0], str(whole), *words[1:], "--strict").returncode == 0, words
        (tmp_path / "lines.jsonl").unlink(missing_ok=True)
        loose = run(words[0], str(text), *words[1:])
        (tmp_path / "lines.jsonl").unlink(missing_ok=True)
        strict = run(words[0], str(text), *words[1:], "--strict")
        assert (loose.returncode, strict.returncode) == (0, 2), (words, strict.stderr)
        (tmp_path / "lines.jsonl").unlink(missing_ok=True)
