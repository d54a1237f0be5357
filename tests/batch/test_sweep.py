"""Sweeps: the same lines everywhere, in order, each once, whatever is killed on the way."""

import gc
import json
import os
import signal
import subprocess
import sys
import time
import tracemalloc
from itertools import count, islice
from pathlib import Path

import jsonschema
import pytest
from gmpy2 import mpq

import exactspline as xs
from exactspline import ExactSplineError, Family, read
from exactspline.batch import backends, results
from exactspline.batch import sweep as sweeping
from exactspline.batch.corpus import Problem, items
from exactspline.batch.inspections import asked_by_sweeps, enclosed, inspected
from exactspline.batch.lines import Summary, line_schema
from exactspline.batch.results import JsonLines, ResultsError
from exactspline.batch.sweep import Where, Work, sweep_into_file
from exactspline.errors import CurveFileError
from exactspline.interchange.files import read_in_pieces
from exactspline.questions import takes
from exactspline.verification.ledger import audit
from tests.support.command import invoke
from tests.support.interchange_seeds import SVG, truetype

FAMILY = Family.parsed("degree=2-4 segments=1-3 rational=half count=40 seed=3")
SOURCES = ["six_segment_cubic", FAMILY, "no_such_file.json", "cusp"]


def run(*arguments):
    return invoke("sweep", *map(str, arguments))


# ---- what is in a line


def test_a_line_says_what_the_functions_of_the_library_say():
    (line,) = xs.sweep("six_segment_cubic", find=["all"], digits=6)
    curve = xs.example("six_segment_cubic")
    abouts = {name: entry.about for name, entry in asked_by_sweeps().items()}
    without = {name for name, about in abouts.items() if not (about.argument or about.on_request)}
    assert set(line.found) == without - {"torsion_zeros"}
    for name in line.found:
        assert len(line.found[name]) == len(getattr(xs.analyse(curve), name))
    for told, feature in zip(line.found["inflections"], xs.analyse(curve).inflections, strict=True):
        assert mpq(told.low) < feature.root < mpq(told.high)
        assert mpq(told.high) - mpq(told.low) == mpq(1, 10**6)
    (space,) = xs.sweep("rational_space_cubic", find=["torsion_zeros"])
    assert len(space.found["torsion_zeros"]) == len(xs.analyse(xs.example("rational_space_cubic")).torsion_zeros)


@pytest.mark.parametrize("negative", [False, True])
def test_a_decimal_does_not_depend_on_what_was_asked_of_the_root_before(negative):
    def made():
        t = xs.BSpline.identity(-1, 1)
        return xs.zeros(t * t - mpq(1, 10**12) - mpq(1, 2))[0 if negative else 1]

    fresh, asked = made(), made()
    asked.refine(100)
    assert enclosed(fresh, 5) == enclosed(asked, 5)
    assert enclosed(fresh, 5) == (("-0.70711", "-0.70710") if negative else ("0.70710", "0.70711"))
    assert enclosed(made(), 0) == (("-1", "0") if negative else ("0", "1"))


def test_verdicts_are_those_of_the_ledger():
    (line,) = xs.sweep("rational_cubic", claims=["C4.1a", "C4.2b"])
    rows = audit(xs.claims("C4.1a", "C4.2b"), [xs.example("rational_cubic")])
    assert [(each.claim, each.verdict) for each in line.claims] == [(row.key, str(row.verdict)) for row in rows]
    assert not line.found


def test_every_line_follows_its_schema(tmp_path):
    font = tmp_path / "f.ttf"
    font.write_bytes(truetype())
    jsonschema.Draft202012Validator.check_schema(line_schema())
    schema = jsonschema.Draft202012Validator(line_schema())
    for line in xs.sweep([str(font), *SOURCES[:1], "rational_space_cubic", "nothing.svg"], find=["all"]):
        schema.validate(line.data())
    with pytest.raises(jsonschema.ValidationError):
        schema.validate(line.data() | {"verdict": "PROVED"})


# ---- corpora


def test_a_member_of_a_family_depends_on_seed_and_number_alone():
    longer = Family.parsed("degree=2-4 segments=1-3 rational=half count=4000 seed=3")
    other = Family.parsed("degree=2-4 segments=1-3 rational=half count=40 seed=4")
    assert all(FAMILY.curve(i) == longer.curve(i) for i in range(40))
    assert not any(FAMILY.curve(i) == other.curve(i) for i in range(40))
    curves = [FAMILY.curve(i) for i in range(40)]
    assert {c.degree for c in curves} == {2, 3, 4}
    assert {c.segments for c in curves} == {1, 2, 3}
    assert sum(c.polynomial for c in curves) == 20
    assert Family.parsed(str(FAMILY).removeprefix("random ")) == FAMILY


@pytest.mark.parametrize(
    "words", ["degre=3", "degree", "degree=x", "degree=5-2", "degree=0", "count=0", "dimension=4", "rational=maybe",
              "degree=3 degree=4", "seed=1-2", "degree=61"],
)  # fmt: skip
def test_words_of_a_family_that_say_nothing_are_refused(words):
    with pytest.raises(CurveFileError):
        Family.parsed(words)


def test_a_corpus_is_read_in_order_and_what_is_broken_is_named(tmp_path):
    (tmp_path / "b").mkdir()
    xs.write(xs.example("cusp"), tmp_path / "b" / "one.json")
    (tmp_path / "a.svg").write_bytes(SVG)
    (tmp_path / "c.json").write_text("{}")
    (tmp_path / "README.md").write_text("no curve")
    found = list(items([str(tmp_path), "circle", FAMILY]))
    assert [item.index for item in found] == list(range(len(found)))
    assert list(dict.fromkeys(Path(item.source).name for item in found))[:4] == [
        "a.svg",
        "one.json",
        "c.json",
        "circle",
    ]
    assert [item.given.kind for item in found if isinstance(item.given, Problem) and item.source.endswith("c.json")]
    shares = [item.share for item in found]
    assert shares == sorted(shares)
    assert shares[-1] == 1


# ---- everywhere the same


@pytest.fixture(scope="module")
def serial():
    return list(xs.sweep(SOURCES, backend="serial"))


def test_serial_lines_are_in_order_and_a_bad_curve_is_one_of_them(serial):
    assert [line.index for line in serial] == list(range(43))
    assert serial[41].error.kind == "CurveFileError"
    assert [line.index for line in serial if line.error] == [41]


@pytest.mark.parametrize("backend", ["processes", "dask"])
def test_all_backends_say_the_same(serial, backend, monkeypatch):
    monkeypatch.setattr(backends, "FEW", 0)
    pytest.importorskip({"processes": "joblib", "dask": "distributed"}[backend])
    assert list(xs.sweep(SOURCES, backend=backend, jobs=2)) == serial


def test_another_release_does_not_go_on(tmp_path, monkeypatch):
    """Passed before: lines of two releases in one file, whose answers may differ, and nothing said so."""
    place = str(tmp_path / "lines.jsonl")
    sweep_into_file(["circle"], Work.of(), Where("serial"), place, Summary())
    monkeypatch.setattr(sweeping, "releases", lambda: {"exactspline": "0.0.1", "python-flint": "0.8.0"})
    with pytest.raises(ResultsError, match="releases"):
        sweep_into_file(["circle"], Work.of(), Where("serial"), place, Summary())


def test_a_worker_with_another_release_is_refused(monkeypatch):
    """Each process says that it has another release."""
    pytest.importorskip("distributed")
    monkeypatch.setattr(backends, "FEW", 0)
    monkeypatch.setattr(backends, "releases", lambda: {"exactspline": str(os.getpid())})
    with pytest.raises(backends.BackendError, match="install"):
        list(xs.sweep(["circle"], backend="dask", jobs=1))


@pytest.mark.parametrize(("count", "each", "pooled"), [(512, 1, False), (513, 1, True), (16, backends.ALONE, True)])
def test_processes_are_started_only_where_they_pay(count, each, pooled):
    """Two processes for 200 curves took three times the processor time of one before."""
    pytest.importorskip("joblib")
    found = list(backends.mapped(_process_of, range(count), "processes", 2, weight=lambda _: each))
    assert len(found) == count
    assert (os.getpid() not in found) is pooled


def _process_of(group):
    return [os.getpid()] * len(group)


def test_an_endless_corpus_is_swept_as_far_as_it_is_asked_for():
    taken = []

    def endless():
        for i in count():
            taken.append(i)
            yield FAMILY.curve(i % 40)

    lines = xs.sweep(endless(), backend="processes", jobs=2)
    assert [line.index for line in islice(lines, 5)] == list(range(5))
    lines.close()
    assert len(taken) <= 2 * (backends.WINDOW + backends.MOST)


def test_memory_does_not_grow_with_the_corpus():
    def at_the_end_of(size):
        tracemalloc.start()
        for line in xs.sweep(Family.parsed(f"degree=1 count={size}"), find=["corners"]):
            if line.index == size - 1:
                gc.collect()
                found = tracemalloc.get_traced_memory()[0]
        return found

    gc.freeze()  # what was there before is not looked at
    at_the_end_of(30)
    try:
        assert at_the_end_of(150) < at_the_end_of(50) + 5_000
    finally:
        tracemalloc.stop()


def test_no_curve_is_kept_when_its_line_is_done(tmp_path):
    drawing = tmp_path / "d.svg"
    path = "".join(f'<path d="M 0 0 C 1 2 3 {k} 4 0"/>' for k in range(30))
    drawing.write_text(f'<svg xmlns="http://www.w3.org/2000/svg">{path}</svg>')

    def alive():
        gc.collect()
        curves = [each for each in gc.get_objects() if type(each) is xs.Nurbs]
        return sum(each.source.startswith("d.svg") for each in curves)

    lines, left = xs.sweep([str(drawing)], find=["inflections"]), []
    gc.freeze()  # what was there before is not looked at
    for i, line in enumerate(lines):
        assert line.error is None
        if i % 10 == 9:
            left.append(alive())
    # one may still be held by the generators
    assert all(count <= 30 - i for i, count in zip((9, 19, 29), left, strict=True))
    assert left[-1] <= 1


def test_a_font_is_read_glyph_by_glyph_as_it_is_read_at_once(tmp_path):
    pytest.importorskip("fontTools")
    font = tmp_path / "f.ttf"
    font.write_bytes(truetype())
    whole, pieces = read(str(font)), list(read_in_pieces(str(font)))
    assert len(pieces) > 1
    assert [piece.done for piece in pieces] == list(range(1, pieces[-1].total + 1))
    named = [each for piece in pieces for each in piece.reading.curves]
    assert [(each.name, each.curve, each.notes) for each in named] == [
        (each.name, each.curve, each.notes) for each in whole.curves
    ]
    assert [each for piece in pieces for each in piece.reading.skipped] == list(whole.skipped)
    found = list(items([str(font)]))
    assert [item.name for item in found][: len(named)] == [each.name for each in named]
    assert [item.share for item in found] == sorted(item.share for item in found)
    assert found[-1].share == 1


def test_what_is_not_there_is_told_before_anything_is_computed(monkeypatch):
    for wrong in ({"find": ["inflexions"]}, {"claims": ["C99"]}, {"backend": "dusk"}, {"jobs": 0}, {"digits": -1}):
        with pytest.raises(ExactSplineError):
            xs.sweep("circle", **wrong)
    with pytest.raises(takes.QuestionError, match="nearest are inflections"):
        xs.sweep("circle", find=["inflexions"])
    monkeypatch.setattr(backends, "find_spec", lambda name: None)
    with pytest.raises(backends.BackendError, match="pip install distributed"):
        xs.sweep("circle", backend="dask")


def test_a_defect_of_the_program_is_a_line_and_an_alarm(monkeypatch, tmp_path):
    monkeypatch.setattr(asked_by_sweeps()["corners"], "compute", lambda curve: 1 / 0)
    curves = [xs.Nurbs(1, [0, 0, 1, 2, 2], [(0, 0), (k, 1), (2, 0)]) for k in (1, 2)]
    lines = list(xs.sweep(curves, find=["corners"]))
    assert [line.error for line in lines] == [Problem("ZeroDivisionError", "division by zero", bad_input=False)] * 2
    summary = Summary()
    for line in lines:
        summary.add(line)
    assert summary.alarms == 2
    assert not summary.as_expected
    # an example's corners may be known already
    xs.write(xs.Nurbs(1, [0, 0, 1, 2, 2], [(0, 0), (5, 1), (2, 0)]), tmp_path / "fresh.json")
    assert run(tmp_path / "fresh.json", "--find", "corners").exit_code == 1


# ---- killed, and gone on with


def lines_of(place):
    with JsonLines(place, json.loads(Path(f"{place}.settings.json").read_text())) as results:
        return list(results.existing())


def record(place, sources=SOURCES, **how):
    summary = Summary()
    sweep_into_file(sources, Work.of(**how), Where("serial"), str(place), summary)
    return summary


def test_a_file_torn_anywhere_is_made_whole_without_losing_or_repeating_a_line(tmp_path, serial):
    place = tmp_path / "lines.jsonl"
    record(place)
    whole = place.read_bytes()
    assert lines_of(place) == serial
    ends = [i for i, byte in enumerate(whole) if byte == ord("\n")]
    cuts = {0, 1, ends[0], ends[0] + 1, ends[0] + 2, *range(37, len(whole), 2500), ends[-1], len(whole)}
    for cut in sorted(cuts):
        place.write_bytes(whole[:cut])
        summary = record(place)
        assert lines_of(place) == serial
        assert place.read_bytes()[: whole.rfind(b"\n", 0, cut) + 1] == whole[: whole.rfind(b"\n", 0, cut) + 1]
        assert summary.lines == len(serial)


def test_results_of_another_sweep_are_not_touched(tmp_path):
    place = tmp_path / "lines.jsonl"
    record(place)
    before = place.read_bytes()
    for sources, how in ((SOURCES, {"digits": 9}), (SOURCES, {"find": ["corners"]}), (SOURCES[:-1], {})):
        with pytest.raises(ResultsError, match="other settings"):
            record(place, sources, **how)
    foreign = tmp_path / "notes.txt"
    foreign.write_text("my notes, no line break")
    with pytest.raises(ResultsError, match="was not written by a sweep"):
        record(foreign)
    assert (place.read_bytes(), foreign.read_text()) == (before, "my notes, no line break")
    # a list where the settings should be was an AttributeError
    (tmp_path / "lines.jsonl.settings.json").write_text("[]")
    with pytest.raises(ResultsError, match="other settings"):
        record(place)


def test_a_corpus_that_has_changed_is_told(tmp_path):
    corpus, place = tmp_path / "corpus", tmp_path / "lines.jsonl"
    corpus.mkdir()
    (corpus / "m.svg").write_bytes(SVG)
    record(place, [str(corpus)])
    (corpus / "a.svg").write_bytes(SVG)
    with pytest.raises(ResultsError, match=r"line 1 is about .*the corpus has changed"):
        record(place, [str(corpus)])


@pytest.mark.parametrize("damage", ["gone", "twice", "no json"])
def test_a_file_damaged_in_its_middle_is_refused(tmp_path, damage):
    place = tmp_path / "lines.jsonl"
    record(place)
    text = place.read_text().splitlines(keepends=True)
    text[5:6] = {"gone": [], "twice": [text[5]] * 2, "no json": ["{}\n"]}[damage]
    place.write_text("".join(text))
    with pytest.raises(ResultsError, match=f"line {7 if damage == 'twice' else 6} is not"):
        record(place)


def test_only_one_sweep_writes_at_a_time(tmp_path):
    pytest.importorskip("fcntl")
    with JsonLines(tmp_path / "a.jsonl", {}), pytest.raises(ResultsError, match="another sweep"):
        JsonLines(tmp_path / "a.jsonl", {})


def test_parquet_in_parts_goes_on_behind_the_last_one(tmp_path, serial, monkeypatch):
    dataset = pytest.importorskip("pyarrow.dataset")
    monkeypatch.setattr(results, "ROWS", 10)
    place = tmp_path / "lines.parquet"
    record(place)
    parts = sorted(place.glob("*.parquet"))
    assert len(parts) == 5
    parts[-1].unlink()
    (place / ".part-000000040.parquet.torn").write_bytes(b"PAR1")
    record(place)
    settings = json.loads((place / "_settings.json").read_text())
    with results.Parquet(place, settings) as kept:
        assert list(kept.existing()) == serial
    table = dataset.dataset(place).to_table()
    assert table["index"].to_pylist() == list(range(43))
    assert [len(x or []) for x in table["curvature_extrema"].to_pylist()] == [
        len(x.found.get("curvature_extrema", ())) for x in serial
    ]
    parts[1].unlink()
    with pytest.raises(ResultsError, match="begins at row 10"):
        record(place)


MANY = "degree=4-5 count=800 rational=yes"


def started(place, *options, family=MANY):
    command = [sys.executable, "-m", "exactspline", "sweep", "--random", *family.split()]
    started = subprocess.Popen(
        [*command, "-o", str(place), *options], start_new_session=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    deadline = time.monotonic() + 60
    while (not place.exists() or place.read_bytes().count(b"\n") < 20) and time.monotonic() < deadline:
        time.sleep(0.01)
    return started


@pytest.mark.skipif(not hasattr(os, "killpg"), reason="there are no process groups")
def test_killed_and_interrupted_and_gone_on_with(tmp_path):
    killed, place = tmp_path / "killed.jsonl", tmp_path / "interrupted.jsonl"
    process = started(killed, "--jobs", "2")
    os.killpg(process.pid, signal.SIGKILL)
    process.communicate()
    assert 20 <= killed.read_bytes().count(b"\n") < 800
    process = started(place, "--backend", "serial")
    os.killpg(process.pid, signal.SIGINT)
    told = process.communicate(timeout=60)[1].decode()
    assert process.returncode == 130
    assert f"interrupted after {place.read_bytes().count(bytes([10]))} curves" in told
    assert "Traceback" not in told
    expected = list(xs.sweep(Family.parsed(MANY)))
    for each in (killed, place):
        kept = each.read_bytes()
        kept = kept[: kept.rfind(b"\n") + 1]
        record(each, [Family.parsed(MANY)])
        assert each.read_bytes().startswith(kept)
        assert lines_of(each) == expected


@pytest.mark.skipif(not hasattr(os, "killpg"), reason="there are no process groups")
def test_several_processes_are_interrupted_at_once(tmp_path):
    """Before, Ctrl-C waited for all curves that the processes had been sent: 10 to 15 seconds of these."""
    slow = "degree=9 segments=6 dimension=3 count=4000"
    process = started(tmp_path / "a.jsonl", "--jobs", "2", family=slow)
    os.killpg(process.pid, signal.SIGINT)
    pressed = time.monotonic()
    told = process.communicate(timeout=60)[1].decode()
    assert time.monotonic() - pressed < 8
    # a process that is interrupted outside of the work may print that, and does on a busy machine
    assert (process.returncode, told.splitlines()[-1]) == (130, "interrupted; what has been written is kept")


# ---- the command


def test_the_command_counts_what_is_there(tmp_path):
    done = run("six_segment_cubic", "circle", "--json", "-o", tmp_path / "a.jsonl")
    assert done.exit_code == 0
    rows = {(row["what"], row["name"]): row["count"] for row in json.loads(done.stdout)["rows"]}
    assert rows["curves", ""] == 2
    assert rows["segments", ""] == 6 + 4
    assert rows["inflections", "inflection"] == 2
    again = json.loads(run("six_segment_cubic", "circle", "--json", "-o", tmp_path / "a.jsonl").stdout)["rows"]
    for way in [name for what, name in rows if what == "filter"]:
        rows.pop(("filter", way))
    assert {(row["what"], row["name"]): row["count"] for row in again} == rows | {("filter", "computed before"): 2}


def test_lines_go_to_standard_output_in_a_pipe():
    done = run("circle", "no_file.svg", "-o", "-", "--random", "degree=3", "count=2", "seed=5")
    assert done.exit_code == 2
    lines = [json.loads(text) for text in done.stdout.splitlines()]
    assert [(line["curve"], line["error"] is None) for line in lines] == [
        ("circle", True), ("", False), ("0", True), ("1", True)
    ]  # fmt: skip
    assert done.stderr == ""


@pytest.mark.parametrize(
    "arguments", [[], ["--random", "degree=3,count=2", "--random", "degree=4", "count=2"],
                  ["--random", "colour=red"], ["circle", "--backend", "dusk"], ["circle", "-o", "/no/such/folder/a"]],
)  # fmt: skip
def test_bad_words_are_errors_of_the_input(arguments):
    # `exactspline.cli.main` makes one line and exit status 2 of these
    assert isinstance(run(*arguments).exception, ExactSplineError)


def test_a_verdict_that_is_not_as_recorded_is_named(monkeypatch):
    monkeypatch.setattr(xs.verification.ledger.Row, "as_recorded", property(lambda row: False))
    done = run("rational_cubic", "--claim", "C4.1a")
    assert done.exit_code == 1
    assert "not as expected" in done.stdout
    assert "is VERIFIED" in done.stdout


def test_the_summary_gives_the_reason_for_every_curve_that_is_refused(tmp_path):
    """Passed before: a part of a file that could not be read was named, and the file once more."""
    broken = tmp_path / "broken.ttf"
    broken.write_text("broken", encoding="ascii")
    field = tmp_path / "field.json"
    field.write_text("{}", encoding="ascii")
    empty = tmp_path / "empty.svg"
    empty.write_text('<svg xmlns="http://www.w3.org/2000/svg"/>', encoding="ascii")
    sources = [str(broken), f"{broken}:ampersand", str(field), str(empty), str(tmp_path / "missing.json")]
    summary = Summary()
    for line in xs.sweep([*sources, "circle"]):
        summary.add(line)
        assert line.error is None or str(tmp_path) not in line.error.message
    told = [each.name for each in summary.entries() if each.what == "refused"]
    assert told[0].startswith(f"{broken}: is not a readable font")
    for source, text in zip(sources, told, strict=True):
        assert text.startswith(f"{source}: ")
        assert text.count(str(tmp_path)) == 1


def test_a_question_with_an_argument_is_asked_of_every_curve():
    """Before, `offset_cusps`, a question of the registry, could not be asked in a sweep."""
    (line,) = xs.sweep("ellipse", find=["offset_cusps:1", "turning_points:0", "corners"])
    facts = xs.analyse(xs.example("ellipse"))
    assert list(line.found) == ["offset_cusps:1", "turning_points:0", "corners"]
    assert [each.kind for each in line.found["offset_cusps:1"]] == [str(f.kind) for f in facts.offset_cusps(1)]
    assert len(line.found["turning_points:0"]) == len(facts.turning_points(0)) > 0
    (around,) = xs.sweep("circle", find=["offset_cusps:1"])
    assert [each.kind for each in around.found["offset_cusps:1"]] == ["everywhere"]
    (space,) = xs.sweep("twisted_cubic", find=["offset_cusps:1", "turning_points:2"])
    assert list(space.found) == ["turning_points:2"]


@pytest.mark.parametrize(
    ("asked", "told"),
    [
        ("offset_cusps", "write it like 'offset_cusps:1/10'"),
        ("corners:1", "write it like 'corners'"),
        ("offset_cusps:one", "'one' is not a number"),
        ("offset_cusps:0", "offset_cusps:0"),
        ("turning_points:7", "turning_points:7"),
        ("offset_cusp:1", "offset_cusps"),
    ],
)
def test_an_argument_that_is_none_is_refused_before_the_first_curve(asked, told):
    with pytest.raises(xs.ExactSplineError, match=told):
        next(iter(xs.sweep("ellipse", find=[asked])))


def test_self_intersections_are_pairs_of_parameters():
    """Passed before: a sweep could not ask for them."""
    loop = xs.Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (3, 3), (-2, 3), (1, 0)])
    there_and_back = xs.Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), (4, 4), (0, 0)])
    (node,), (arc,) = (
        inspected(c, ["self_intersections"], 3, values=True)["self_intersections"] for c in (loop, there_and_back)
    )
    assert (node.kind, node.low, node.high, node.other_low, node.other_high) == (
        ("crossing", "0.066", "0.067", "0.933", "0.934")
    )
    assert (node.x, node.y) == (0.5, 0.5625)
    assert (arc.kind, arc.low, arc.high, arc.other_low, arc.other_high) == ("everywhere", "0", "1/2", "1/2", "1")


# ---- processes that die


CURVES = Family.parsed("degree=3 count=400 seed=1")


def test_a_worker_of_the_current_client_that_dies_loses_no_line_and_the_client_stays(monkeypatch):
    """Before, a cluster was made beside the client that was there."""
    distributed = pytest.importorskip("distributed")
    monkeypatch.setattr(backends, "FEW", 0)
    how = {"n_workers": 2, "threads_per_worker": 1, "dashboard_address": ":0", "silence_logs": "CRITICAL"}
    with distributed.LocalCluster(**how) as cluster, distributed.Client(cluster) as client:
        workers = set(client.run(os.getpid).values())
        found = []
        for line in xs.sweep(CURVES, backend="dask", jobs=2):
            found.append(line)
            if len(found) == 5:
                os.kill(min(workers), signal.SIGKILL)
        assert client.status == "running"
        assert set(client.run(os.getpid).values()) != workers
    assert found == list(xs.sweep(CURVES, backend="serial"))


def test_a_process_that_was_killed_is_said_in_a_sentence(monkeypatch):
    """Before, a traceback of joblib."""
    pytest.importorskip("joblib")
    monkeypatch.setattr(backends, "FEW", 0)
    with pytest.raises(backends.BackendError, match="fewer jobs"):
        list(backends.mapped(_killed_at_40, range(60), "processes", 2))


def _killed_at_40(group):
    if 40 in group:
        os.kill(os.getpid(), signal.SIGKILL)
    return group


# ---- a system that lacks what this one has


def test_without_locks_limits_and_signals_all_is_answered(tmp_path):
    """A folder cannot be opened on Windows: results in Parquet could not be written there."""
    program = f"""
import sys, signal, os
sys.modules["fcntl"] = sys.modules["resource"] = None
del signal.pthread_sigmask, signal.SIGXCPU
import exactspline.system
exactspline.system.sys = type("Windows", (), {{"platform": "win32"}})
import exactspline as xs
from exactspline.batch import backends
from exactspline.cli import main
backends.FEW = 0
for name in ("lines.jsonl", "table.parquet"):
    place = os.path.join({str(tmp_path)!r}, name)
    try:
        sys.argv = ["exactspline", "sweep", "circle", "cusp", "--jobs", "2", "-o", place, "--quiet"]
        main()
    except SystemExit as end:
        assert not end.code, end.code
    assert os.path.exists(place)
"""
    pytest.importorskip("pyarrow")
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False, timeout=120)
    assert done.returncode == 0, done.stderr
