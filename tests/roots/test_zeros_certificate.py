"""Corrupted certificates, of every kind of corruption and by both routes: what is accepted is a true statement."""

import ast
import copy
import json
import random
from math import comb
from pathlib import Path

import pytest
from gmpy2 import mpq

from exactspline import BSpline, Nurbs, certificates, check_certificate, zeros
from exactspline.certificates.zeros import product_of, sturm_count
from exactspline.geometry.analysis.inspection import solved
from tests.support.sampled import sample

T = BSpline.identity(0, 1)
LINE = Nurbs(1, [0, 0, 1, 1], [(0, 0, 0), (1, 2, 3)])
DIGITS = 4_400
#: Small integers, thirds, decimals, doubles, 1e±300; roots, jumps, touches, intervals, seams, midpoints, nothing.
CASES = {
    "everything": lambda: zeros(
        BSpline(3, [0] * 4 + [1] * 4 + [2] * 4 + [3] * 4, [1, -2, "-5/3", 1, -1, 2, "-1/3", 0, 0, 0, 0, 0])
    ),
    "multiple": lambda: zeros((T**2 + T - 1) ** 2 * (3 * T - 1) ** 2 * (T**2 + 1)),
    "midpoints": lambda: zeros((2 * T - 1) * (4 * T - 1) ** 3 * (T - 1) * T**2),
    "periodic": lambda: zeros(BSpline(1, [0, 0, 1, 2, 3, 4, 4], [0, 0, 1, -1, 0]), periodic=True),
    "an interval of two segments": lambda: zeros(BSpline(1, [0, 0, 1, 2, 3, 4, 4], [1, 0, 0, 0, 1])),
    "two intervals": lambda: zeros(BSpline(1, [0, 0, 1, 2, 3, 4, 4], [0, 0, 1, 0, 0])),
    "two intervals, one of two segments": lambda: zeros(BSpline(1, [0, 0, 1, 2, 3, 4, 5, 5], [0, 0, 1, 0, 0, 0])),
    "periodic, an end": lambda: zeros(BSpline(1, [0, 0, 1, 2, 3, 4, 5, 6, 6], [0, 1, 0, 0, -1, 0, 0]), periodic=True),
    "periodic, a start": lambda: zeros(BSpline(1, [0, 0, 1, 2, 3, 4, 5, 6, 6], [0, 0, 1, 0, 0, -1, 0]), periodic=True),
    "periodic, both ends": lambda: zeros(BSpline(1, [0, 0, 1, 2, 3, 4, 5, 5], [0, 0, 1, -1, 0, 0]), periodic=True),
    "jumps from nothing": lambda: zeros(BSpline(1, [0, 0, 1, 1, 2, 2, 3, 3], [0, 0, 1, 2, 0, 0])),
    "without zeros": lambda: zeros(T * T - T + 1),
    "doubles": lambda: zeros(BSpline.bezier([mpq(*x.as_integer_ratio()) for x in (0.1, -1e300, 1e-300, 0.7)])),
    "degree 8": lambda: zeros((T**2 - mpq(1, 2)) * (3 * T - 2) ** 3 * (T**3 + 5)),
    "line in space": lambda: solved(LINE)[0][3],
    "long integers": lambda: zeros(BSpline.bezier([-1, mpq(10) ** DIGITS, 1])),
}


def written(name):
    found = CASES[name]()
    found.refine(3)
    return json.loads(json.dumps(found.certificate()))


@pytest.mark.parametrize("sturm", [True, False])
@pytest.mark.parametrize("name", CASES)
def test_our_own_certificates_are_accepted(name, sturm):
    """Refused before: a line in space ("degree": −3), and every integer of more than 4,300 digits."""
    found = CASES[name]()
    counts = {"roots": len(found), "jumps": len(found.jumps), "intervals": len(found.intervals)}
    assert check_certificate(written(name), sturm=sturm) == counts


# ---- what a certificate claims, computed anew


def still_true(certificate):
    """Whether what a certificate states is so: its spline is built from the coefficients and solved again."""
    n, breaks = certificate["degree"], [mpq(t) for t in certificate["breakpoints"]]
    if n < 0:
        return not certificate["roots"] and not certificate["jumps"] and len(certificate["intervals"]) == 1
    rows = [[mpq(x) / comb(n, i) for i, x in enumerate(s["coefficients"])] for s in certificate["segments"]]
    knots = [t for t in breaks for _ in range(n + 1)]
    found = zeros(BSpline(n, knots, [x for row in rows for x in row]), periodic=certificate["periodic"])
    jumps = [(j.parameter, [j.left.sign, j.right.sign]) for j in found.jumps]
    return (
        len(found.roots) == len(certificate["roots"])
        and all(_is(root, claim) for root, claim in zip(found.roots, certificate["roots"], strict=True))
        and jumps == [(mpq(j["at"]), j["signs"]) for j in certificate["jumps"]]
        and [[i.low, i.high] for i in found.intervals] == [list(map(mpq, pair)) for pair in certificate["intervals"]]
    )


def _is(root, claim):
    low, high = mpq(claim["low"]), mpq(claim["high"])
    return (
        (low < root < high or low == root == high)
        and [root.left_multiplicity, root.right_multiplicity] == claim["multiplicities"]
        and list(root.signs) == claim["signs"]
    )


# ---- corruptions


def places(data, path=()):
    yield path
    items = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    for key, value in items:
        yield from places(value, (*path, key))


def others(value):
    """What could stand in the place of a value."""
    if isinstance(value, bool):
        return [not value, "true", 1, None]
    if isinstance(value, int):
        return [value + 1, value - 1, -value, 0, -1, 7, str(value), float(value), bool(value), None, [value]]
    if isinstance(value, str):
        number = [] if len(value) > 50 else _numbers(value)
        return [*number, "", "x", f"{value} ", f"{value}/0", f"{value}e1", None, [value]]
    if isinstance(value, list):
        found = [[], value + value[-1:], value[:1] + value, value[::-1], value[1:], value[:-1], None, {}, "1"]
        swapped = [[*value[:i], value[i + 1], value[i], *value[i + 2 :]] for i in range(len(value) - 1)]
        return [*found, *swapped[:4]]
    if isinstance(value, dict):
        return [{k: v for k, v in value.items() if k != left_out} for left_out in value] + [None, []]
    return [0, 1, -1, "0"]


def _numbers(value):
    try:
        number = mpq(value)
    except (ValueError, ZeroDivisionError):  # corrupted before
        return []
    near = [str(number + 1), str(number - 1), str(-number), str(2 * number), str((number + 1) / 2), "0", "1/2"]
    return [*near, float(number) if abs(number) < 1e300 else 0.5, int(number)]


def changes(certificate):
    """Every place, with everything that could stand there instead."""
    for path in places(certificate):
        value = at(certificate, path)
        for other in others(value) if path else ():
            if type(other) is not type(value) or other != value:
                yield path, other


def at(data, path):
    for key in path:
        data = data[key]
    return data


def changed(certificate, path, other):
    copied = copy.deepcopy(certificate)
    at(copied, path[:-1])[path[-1]] = other
    return copied


@pytest.mark.parametrize("sturm", [True, False])
@pytest.mark.parametrize("name", CASES)
def test_what_is_accepted_is_true(name, sturm):
    """Accepted before, without Sturm's sequence: powers of 0, factors that vanish, reversed leaves; with it, numbers
    that were cut off (1.5 read as 1).
    """
    tried = accepted = 0
    given = written(name)
    for path, other in sample([*changes(given)], 250, seed=f"{name} {sturm}"):
        tried += 1
        certificate = changed(given, path, other)
        try:
            check_certificate(certificate, sturm=sturm)
        except ValueError:
            continue
        accepted += 1
        assert still_true(certificate), (path, other)
    assert tried > 100
    assert accepted < tried / 4


@pytest.mark.parametrize("name", CASES)
def test_what_is_accepted_of_two_corruptions_is_true(name):
    """Accepted before: a factor of power 0 with the sign change it adds."""
    given, chance = written(name), random.Random(f"two of {name}")
    for first in chance.sample(list(changes(given)), 60):
        one = changed(given, *first)
        for second in chance.sample(list(changes(one)), 8):
            certificate = changed(one, *second)
            try:
                check_certificate(certificate, sturm=False)
            except ValueError:
                continue
            assert still_true(certificate), (first, second)


# ---- attacks of more than one change


def one_segment(coefficients, leaves, factors=(), points=(), roots=()):
    return {
        "format": "exactspline certificate 1",
        "what": "zeros",
        "degree": len(coefficients) - 1,
        "periodic": False,
        "breakpoints": ["0", "1"],
        "segments": [{"coefficients": coefficients, "factors": factors, "points": points, "leaves": leaves}],
        "roots": [{"low": a, "high": b, "multiplicities": [m, m], "signs": signs} for a, b, m, signs in roots],
        "jumps": [],
        "intervals": [],
    }


WHOLE = [["0", "1", 0]]
POSITIVE, CROSSING, TOUCHING = ["1", "1", "1"], ["-1", "1"], ["1", "-2", "1"]
ATTACKS = {
    "a power of 0": one_segment(
        POSITIVE, [["0", "1", 1]], [[["-1", "1"], 0], [POSITIVE, 1]], roots=[("0", "1", 0, [1, 1])]
    ),
    "a negative power": one_segment(
        POSITIVE, [["0", "1", 1]], [[["-1", "1"], -1], [POSITIVE, 1]], roots=[("0", "1", -1, [1, 1])]
    ),
    "a factor that vanishes": one_segment(CROSSING, WHOLE, [[["0", "0"], 1]]),
    "a factor that vanishes, and its power": one_segment(TOUCHING, WHOLE, [[["0", "0"], 2]]),
    "a leaf that goes back": one_segment(
        CROSSING,
        [["0", "1/2", 0], ["1/2", "3/4", 0], ["3/4", "1/2", 0], ["1/2", "1", 0]],
        points=["1/2"],
        roots=[("1/2", "1/2", 1, [-1, 1])] * 2,
    ),
    "an empty leaf": one_segment(
        CROSSING,
        [["0", "1/2", 0], ["1/2", "1/2", 0], ["1/2", "1", 0]],
        points=["1/2"],
        roots=[("1/2", "1/2", 1, [-1, 1])] * 2,
    ),
    "leaves beyond the segment": one_segment(
        ["-2", "1"], [["0", "2", 1], ["2", "1", 1]], roots=[("1/2", "3/4", 1, [-1, 1])] * 2
    ),
    "one zero for two": one_segment(
        ["3", "-4", "1"],
        [["0", "1/2", 0], ["1/2", "1", 1]],
        points=["1/2"],
        roots=[("1/2", "1/2", 1, [1, -1]), ("1/2", "1/2", 1, [-1, 1])],
    ),
    "another zero at the end": one_segment(
        ["3", "-4", "1"],
        [["0", "3/4", 1], ["3/4", "1", 0]],
        points=["3/4"],
        roots=[("3/4", "3/4", 1, [1, -1]), ("3/4", "3/4", 1, [-1, 1])],
    ),
    "a power that does not end": one_segment(POSITIVE, WHOLE, [[["1"], 10**18], [POSITIVE, 1]]),
    "a degree that does not end": one_segment(POSITIVE, WHOLE, [[["1", "1"], 10**18]]),
    "an exponent that does not end": one_segment(["-1", "1e999999999"], WHOLE),
    "factors of another form": one_segment(
        POSITIVE, [["0", "1/2", 0], ["1/2", "1", 0]], [[TOUCHING, 1]], ["1/2"], [("1/2", "1/2", 0, [1, 1])]
    ),
    "no segment": one_segment([], []) | {"breakpoints": ["0"], "segments": [], "roots": [
        {"low": "0", "high": "0", "multiplicities": [None, None], "signs": [None, None]}]},
    "another degree below 0": one_segment(CROSSING, WHOLE) | {"degree": -1},
    "no certificate": {},
}  # fmt: skip


@pytest.mark.parametrize("sturm", [True, False])
@pytest.mark.parametrize("name", ATTACKS)
def test_attacks_are_refused(name, sturm):
    """Proved before, without Sturm's sequence: a zero of 1 + uv, that t − 1/2 has no zero, that it has two; with it,
    that both zeros of (2t − 1)(4t − 3) are at 1/2. A mutant passed: a zero of a form that its factors do not give.
    """
    with pytest.raises(ValueError, match=r"."):
        check_certificate(ATTACKS[name], sturm=sturm)


@pytest.mark.parametrize("thing", [None, 3, "text", [], LINE, T])
def test_what_is_no_certificate_is_refused_by_a_value_error(thing):
    """A TypeError before."""
    with pytest.raises(ValueError, match="not a certificate"):
        check_certificate(thing)


def test_the_checker_is_independent_and_short():
    """Nothing but the standard library and the folder itself."""
    files = sorted(Path(certificates.__file__).parent.glob("*.py"))
    assert len(files) == 7
    assert sum(len(file.read_text(encoding="utf-8").splitlines()) for file in files) <= 1_900
    for file in files:
        source = file.read_text(encoding="utf-8")
        names = {
            name.removeprefix("exactspline.").split(".")[0]
            for node in ast.walk(ast.parse(source))
            if isinstance(node, (ast.Import, ast.ImportFrom))
            for name in ([node.module] if isinstance(node, ast.ImportFrom) else [a.name for a in node.names])
        }
        assert names <= {"certificates", "collections", "fractions", "functools", "math", "itertools", "typing"}


def test_a_proof_of_something_else_is_refused():
    changes = {"format": "unknown format", "what": "a proof of something unknown"}
    for field, flaw in changes.items():
        with pytest.raises(ValueError, match=flaw):
            check_certificate(written("everything") | {field: "zero"})
    with pytest.raises(ValueError, match="certificates of degree have the format"):
        check_certificate(written("everything") | {"what": "degree"})
    with pytest.raises(ValueError, match="kind is missing"):
        check_certificate(written("everything") | {"what": "degree", "format": "exactspline certificate 2"})


@pytest.mark.parametrize(
    ("zeros_of", "expected"),
    [([], 0), ([1], 1), ([-1], 0), ([1, 2], 2), ([1, 1, 2], 2), ([-3, 5, 7, -2], 2), ([3] * 4, 1)],
)
def test_a_sturm_sequence_counts_the_distinct_positive_zeros(zeros_of, expected):
    for complex_pairs in ([], [[1, 0, 1]], [[1, 0, 1], [5, 4, 1]], [[5, -4, 1]]):
        c = [-2]
        for factor in [*[[-z, 1] for z in zeros_of], *complex_pairs]:
            c = product_of(c, factor)
        assert sturm_count(c) == expected


def test_a_certificate_of_a_spline_that_vanishes():
    nothing = BSpline(0, [0, 1, 2], [0, 0])
    told = zeros(nothing).certificate()
    assert check_certificate(told) == {"roots": 0, "jumps": 0, "intervals": 1}
