"""Packs of vectors: written, checked again, and read by programs in four languages that agree."""

import json
import re
import shutil
import subprocess
from pathlib import Path
from zlib import crc32

import pytest

from workshop.vectors.__main__ import main
from workshop.vectors.check import checked
from workshop.vectors.corpus import SIZES, corpus

READERS = Path(__file__).parents[2] / "workshop" / "vectors" / "readers"
#: How each reader is made ready and run.
RUN = {
    "python3": ("reader.py", None, ["python3"]),
    "node": ("reader.mjs", None, ["node"]),
    "g++": ("reader.cpp", ["g++", "-O1", "-std=c++17", "-ffp-contract=off"], []),
    "rustc": ("reader.rs", ["rustc"], []),
}


@pytest.fixture(scope="module")
def pack(tmp_path_factory):
    folder = tmp_path_factory.mktemp("vectors")
    assert main(["pack", str(folder), "--cases", "3"]) == 0
    return folder


def test_every_case_is_checked_again(pack):
    assert main(["check", str(pack), "--share", "1"]) == 0
    index = json.loads((pack / "index.json").read_text(encoding="utf-8"))
    assert {family: entry["cases"] for family, entry in index["families"].items()} == dict.fromkeys(SIZES, 3)


WRONG = {
    "value": ("random", "value", lambda items: items[0].update(x=items[0]["x"][::-1])),
    "inflection": ("near", "inflections", list.pop),
    "intersection": ("near", "intersections", list.pop),
    "nearest": ("random", "nearest", lambda items: items[0].update(distance=items[0]["distance"][:1] * 3)),
    "distance": ("random", "distance", lambda items: items[0].update(parameter=["0x0p+0"] * 3)),
}


@pytest.mark.parametrize("what", WRONG)
def test_a_wrong_answer_is_found(pack, what, tmp_path):
    """Doubles changed, or an inflection or a common point taken away, under a digest that fits."""
    family, question, spoil = WRONG[what]
    data = json.loads((pack / f"{family}.json").read_text(encoding="utf-8"))
    number, case = next(
        (number, line["case"])
        for number, line in enumerate(data["cases"])
        if line["case"]["answers"][question]["answer"] == "these"
    )
    spoil(case["answers"][question]["items"])
    body = json.dumps(case, ensure_ascii=True, separators=(",", ":"))
    data["cases"][number]["digest"] = f"{crc32(body.encode()):08x}"
    place = tmp_path / "changed.json"
    place.write_text(json.dumps(data), encoding="utf-8")
    with pytest.raises(ValueError, match=re.escape(case["key"])):
        checked(place, share=1)


@pytest.mark.parametrize("program", RUN)
def test_a_reader_counts_what_python_counts(program, pack, tmp_path):
    if shutil.which(program) is None:
        pytest.skip(f"{program} is not installed")
    name, compiled, run = RUN[program]
    source = READERS / name
    assert len(source.read_text(encoding="utf-8").splitlines()) <= 150
    command = [*run, str(source)]
    if compiled:
        command = [str(tmp_path / "reader")]
        subprocess.run([*compiled, str(source), "-o", command[0]], check=True)
    damaged = tmp_path / "damaged.json"
    text = (pack / "cad.json").read_text(encoding="utf-8")
    damaged.write_text(text.replace('"note":""', '"note":"."', 1), encoding="utf-8")
    for place, bad in ((pack / "cad.json", 0), (pack / "named.json", 0), (damaged, 1)):
        counted = subprocess.run([*command, str(place)], check=True, capture_output=True, text=True).stdout
        cases = [line["case"] for line in json.loads(place.read_text(encoding="utf-8"))["cases"]]
        answers = [answer["answer"] for case in cases for answer in case["answers"].values()]
        expected = {word: answers.count(word) for word in ("none", "these", "all", "undefined")}
        assert f"cases {len(cases)} damaged {bad} " + " ".join(f"{k} {n}" for k, n in expected.items()) in counted
        pairs = [item for case in cases for item in case["answers"]["intersections"].get("items", ())]
        assert f" meetings {sum('parameter' in item for item in pairs)} apart 0" in counted


def test_more_curves_of_a_family(tmp_path):
    keys = [case.key for case in corpus("near", 4000)]
    assert len(set(keys)) == len(keys) == 4000
    assert [case.curve for case in corpus("integers", 1900)][-1] != next(corpus("integers", 1)).curve
    assert [c.key for c in corpus("cad", 3, seed=9)] == [c.key for c in corpus("cad", 3)]
    assert [c.curve for c in corpus("cad", 3, seed=9)] != [c.curve for c in corpus("cad", 3)]
    assert main(["corpus", str(tmp_path / "near.json"), "--family", "near", "--count", "3"]) == 0
    assert checked(tmp_path / "near.json", share=1)[0] == 3


#: Issues that are named for what they ask of a program, and not for a curve.
CRITERIA = {"https://github.com/linebender/kurbo/issues/277"}


def test_every_public_issue_that_is_named_is_a_case():
    """An issue that a page or a test names, and whose curve nobody can find in the pack."""
    root = READERS.parents[2]
    pages = [*root.glob("docs/*.md"), root / "README.md", *root.glob("tests/workshop/*.py")]
    pattern = re.compile(r"https://github\.com/[\w.-]+/[\w.-]+/(?:issues|pull)/\d+")
    named = {link for page in pages for link in pattern.findall(page.read_text(encoding="utf-8"))}
    cases = {case.link: case.key for case in corpus("named", SIZES["named"])}
    assert named > CRITERIA
    assert named - CRITERIA <= set(cases)
    assert all(re.search(r"\d", key) for key in cases.values())
