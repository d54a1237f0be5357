"""Certificates: written as JSON, read back, checked; and no tampering gets through."""

import ast
import copy
import json
from pathlib import Path

import pytest

from exactspline import BSpline, certificates
from exactspline.certificates import check_certificate
from exactspline.roots.zero_set import zeros

T = BSpline.identity(0, 1)
WITH_EVERYTHING = BSpline(
    3, [0] * 4 + [1] * 4 + [2] * 4 + [3] * 4, [1, -2, "-5/3", 1, -1, 2, "-1/3", 0, 0, 0, 0, 0]
)  # roots, a jump, a one-sided end and a interval  # fmt: skip
CASES = {
    "simple": WITH_EVERYTHING,
    "multiple": (T**2 + T - 1) ** 3 * (3 * T - 1) ** 2 * (2 * T - 1) ** 2 * (T**2 + 1),
    "midpoints": (2 * T - 1) * (4 * T - 1) ** 3 * (T - 1) * T**2 * (T * T * 3 - 1),
}


def written(name):
    found = zeros(CASES[name])
    found.refine(20)
    return json.loads(json.dumps(found.certificate()))


@pytest.mark.parametrize("name", CASES)
def test_round_trip(name):
    found = zeros(CASES[name])
    counts = {"roots": len(found), "jumps": len(found.jumps), "intervals": len(found.intervals)}
    assert check_certificate(written(name)) == counts
    assert check_certificate(written(name), sturm=False) == counts


def test_cases_have_what_they_should():
    found = zeros(WITH_EVERYTHING)
    assert (len(found.roots), len(found.jumps), len(found.intervals)) == (4, 1, 1)
    multiple = written("multiple")
    assert [[k for _, k in s["factors"]] for s in multiple["segments"]] == [[1, 2, 3]]
    assert written("midpoints")["segments"][0]["points"] == ["1/4", "1/2"]


def paths(data, path=()):
    """Every place in the JSON data."""
    yield path
    items = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    for key, value in items:
        yield from paths(value, (*path, key))


def at(data, path):
    for key in path:
        data = data[key]
    return data


def tampered(certificate):
    """The certificate with one thing wrong each time: a number moved, a list shortened or doubled."""
    for path in paths(certificate):
        if not path or path[-1] in ("format", "periodic"):
            continue
        value = at(certificate, path)
        others = []
        if isinstance(value, str):
            others = ["-" + value.removeprefix("-") if value != "0" else "1", "7/3"]
        elif isinstance(value, int):
            others = [value + 1, value - 1]
        elif isinstance(value, list) and value:
            others = [value[:-1], [*value, value[-1]]]
        for other in others:
            copied = copy.deepcopy(certificate)
            at(copied, path[:-1])[path[-1]] = other
            if at(copied, path) != value:
                yield path, other, copied


def harmless(path, other):
    """Another form or another domain may well have zeros at the places given, and a point named twice is the same
    point.
    """
    return "coefficients" in path or path[0] == "breakpoints" or (path[-1] == "points" and len(set(other)) < len(other))


@pytest.mark.parametrize("name", CASES)
def test_tampering_is_detected(name):
    count = 0
    for path, other, certificate in tampered(written(name)):
        if harmless(path, other):
            continue
        with pytest.raises((ValueError, StopIteration, IndexError, TypeError, ZeroDivisionError)):
            print(path, other, check_certificate(certificate))
        count += 1
    assert count > 40


@pytest.mark.parametrize("name", CASES)
def test_roots_left_out_or_invented(name):
    certificate = written(name)
    for i in range(len(certificate["roots"])):
        fewer = copy.deepcopy(certificate)
        del fewer["roots"][i]
        with pytest.raises(ValueError, match="roots proved"):
            check_certificate(fewer)
        more = copy.deepcopy(certificate)
        more["roots"].insert(i, more["roots"][i])
        with pytest.raises(ValueError, match="roots proved"):
            check_certificate(more)


def test_another_form_under_the_same_proof():
    certificate = written("simple")
    certificate["segments"][0]["coefficients"] = ["1", "1", "1", "1"]
    with pytest.raises(ValueError, match="sign changes"):
        check_certificate(certificate)


def test_the_checker_is_independent_and_short():
    """Nothing but the standard library and the folder itself."""
    files = sorted(Path(certificates.__file__).parent.glob("*.py"))
    assert len(files) == 4
    for file in files:
        source = file.read_text(encoding="utf-8")
        assert len(source.splitlines()) <= 225
        names = {
            name.removeprefix("exactspline.").split(".")[0]
            for node in ast.walk(ast.parse(source))
            if isinstance(node, (ast.Import, ast.ImportFrom))
            for name in ([node.module] if isinstance(node, ast.ImportFrom) else [a.name for a in node.names])
        }
        assert names <= {"certificates", "collections", "fractions", "math", "itertools", "typing"}


def test_a_proof_of_something_else_is_refused():
    changes = {"format": "unknown format", "what": "a proof of something unknown"}
    for field, flaw in changes.items():
        with pytest.raises(ValueError, match=flaw):
            check_certificate(written("simple") | {field: "zero"})
    with pytest.raises(ValueError, match="not a certificate"):
        check_certificate(written("simple") | {"what": "degree"})
