"""Rows of earlier runs: taken only where nothing they depend on has changed, and from a file that is whole."""

import shutil
from dataclasses import replace
from pathlib import Path

import pytest

from exactspline import Nurbs, example
from exactspline.verification import ledger
from exactspline.verification.claims import select
from exactspline.verification.ledger import Memory, Row, cache_file, settled, tasks
from exactspline.verification.verdict import CONTRADICTION, REFUTED
from tests.support.command import run


def decided(place, claims, curves=None, limit=None):
    memory = Memory(place)
    rows = settled([task() for task in tasks(claims, curves, limit, memory.around)])
    memory.save()
    return [replace(row, seconds=0) for row in rows], memory.found


def test_rows_are_those_of_the_first_run(tmp_path):
    place, claims = tmp_path / "made" / "rows", select(["C4.1", "C4.2b"])
    first, none = decided(place, claims)
    again, found = decided(place, claims)
    anew, _ = decided(None, claims)
    assert (none, found) == (0, len(first))
    assert first == again == anew
    # a claim that is proved anew and one that is known, on a curve that is new
    other = Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (1, 5), (2, -3), (4, 1)])
    both, some = decided(place, [*claims, *select(["C4.3c"])], [example("ellipse"), other])
    assert 0 < some < len(both)
    assert both == decided(None, [*claims, *select(["C4.3c"])], [example("ellipse"), other])[0]


def test_another_curve_of_the_same_name_is_another(tmp_path):
    claims = select(["C4.1a"])
    curves = [replaced(example("ellipse"), x) for x in (0, 1)]
    assert [decided(tmp_path / "rows", claims, [c])[1] for c in (*curves, *curves)] == [0, 0, 2, 2]


def replaced(curve, x):
    points = [(*p[:-1], p[-1] + x) if i == 0 else p for i, p in enumerate(curve.control_points)]
    return Nurbs(curve.degree, curve.knots, points, curve.weights, name=curve.name)


@pytest.mark.parametrize(
    "damage", [lambda b: b"", lambda b: b[:-1], lambda b: b[:99] + b"?" + b[100:], lambda b: b[5:]]
)
def test_a_damaged_file_is_ignored_and_written_anew(tmp_path, damage):
    place, claims = tmp_path / "rows", select(["C4.1a"])
    first, _ = decided(place, claims)
    place.write_bytes(damage(place.read_bytes()))
    assert decided(place, claims) == (first, 0)
    assert decided(place, claims) == (first, len(first))


def test_other_code_and_other_versions_decide_anew(tmp_path, monkeypatch):
    place, claims = tmp_path / "rows", select(["C4.1a"])
    decided(place, claims)
    monkeypatch.setattr(ledger, "_version", lambda library: f"another {library}")
    assert decided(place, claims)[1] == 0
    monkeypatch.undo()
    copy = tmp_path / "package"
    shutil.copytree(Path(ledger.__file__).parents[1] / "certificates", copy)
    monkeypatch.setattr(ledger.resources, "files", lambda name: copy)
    before = ledger.digest_of_code()
    (copy / "new.toml").write_text("")
    assert ledger.digest_of_code() != before
    within = ledger.digest_of_code()
    (copy / "new.toml").write_text("x")
    assert ledger.digest_of_code() not in (before, within)


def test_code_that_changes_during_a_run_leaves_nothing(tmp_path, monkeypatch):
    claims = select(["C4.1a"])
    memory = Memory(tmp_path / "rows")
    assert [task() for task in tasks(claims, None, None, memory.around)]
    monkeypatch.setattr(ledger, "_version", lambda library: "")
    memory.save()
    assert not (tmp_path / "rows").exists()


def test_what_cannot_be_written_is_left_alone(tmp_path):
    (tmp_path / "file").write_text("")
    rows, _ = decided(tmp_path / "file" / "rows", select(["C4.1a"]))
    assert rows
    (tmp_path / "rows").mkdir()
    assert decided(tmp_path / "rows", select(["C4.1a"])) == (rows, 0)


def test_open_rows_are_decided_each_time(tmp_path):
    place, claims = tmp_path / "rows", select(["C4.1a"])
    rows, _ = decided(place, claims, limit=0)
    open_rows = sum(row.out_of_reach for row in rows)
    assert open_rows
    assert decided(place, claims)[1] == len(rows) - open_rows


FORMULAS = """
from exactspline.language import formula


@formula("mine", on="plane")
def doubled(c):
    return c.w + c.w


@formula("mine", on="plane")
def other(c):
    return {other}
"""
CLAIMS = """
title = "Mine"
formulas = ["plane"]

[[claim]]
id = "1"
kind = "identity"
statement = "2w is w + w"
curve = "plane"
left = "doubled"
right = "other"
"""


def written(folder, other):
    folder.mkdir(exist_ok=True)
    (folder / "plane.py").write_text(FORMULAS.format(other=other))
    (folder / "claims.toml").write_text(CLAIMS)
    return folder


def test_another_formula_in_a_folder_is_decided_anew(tmp_path, monkeypatch):
    monkeypatch.setenv("EXACTSPLINE_CACHE", str(tmp_path / "cache"))
    folder = written(tmp_path / "mine", "2 * c.w")
    first, again = (run("prove", "--paper", folder) for _ in range(2))
    assert "earlier runs" not in first.stdout
    assert "earlier runs" in again.stdout
    assert "earlier runs" not in run("prove", "--paper", folder, "--fresh").stdout
    written(folder, "3 * c.w")
    changed = run("prove", "--paper", folder)
    assert "earlier runs" not in changed.stdout
    assert "REFUTED" in changed.stdout
    assert "earlier runs" not in run("prove", "--paper", folder, "--trust").stdout


def test_where_the_file_is(monkeypatch, tmp_path):
    monkeypatch.delenv("EXACTSPLINE_CACHE")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(ledger.sys, "platform", "linux")
    assert cache_file() == tmp_path / "exactspline" / "rows"
    monkeypatch.setattr(ledger.sys, "platform", "win32")
    monkeypatch.setenv("LOCALAPPDATA", str(tmp_path / "local"))
    assert cache_file() == tmp_path / "local" / "exactspline" / "rows"
    monkeypatch.setattr(ledger.sys, "platform", "darwin")
    assert cache_file() == Path.home() / "Library" / "Caches" / "exactspline" / "rows"
    monkeypatch.setenv("EXACTSPLINE_CACHE", str(tmp_path / "named"))
    assert cache_file() == tmp_path / "named" / "rows"
    monkeypatch.setenv("EXACTSPLINE_CACHE", "none")
    assert cache_file() is None


def test_a_known_proof_is_compared_with_a_new_curve(tmp_path, monkeypatch):
    """A claim that is on record as refuted, and that a changed engine proves: a curve that refutes it contradicts."""
    place = tmp_path / "rows"
    claim = next(c for c in select(["C4.2b"]) if c.expected == REFUTED)
    memory = Memory(place)
    curve = example("ellipse")
    (proof, *_) = tasks([claim], None, None, memory.around)
    known = proof()
    key = memory._key(claim, None)
    wrong = replace(known, finding=replace(known.finding, verdict="PROVED"))
    fields = wrong.reading, wrong.curve, wrong.finding, wrong.expected, wrong.seconds, wrong.beside
    memory._rows[key] = ledger.pickle.dumps(fields)
    checks = tasks([claim], None, None, memory.around)
    rows = [task() for task in checks]
    assert isinstance(rows[0], Row)
    assert curve is not None
    assert any(row.verdict == CONTRADICTION for row in rows[1:])
