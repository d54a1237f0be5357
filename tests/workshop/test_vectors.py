"""Packs of vectors: written, checked again, and read by programs in four languages that agree."""

import copy
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
from workshop.vectors.pack import line_of

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


def _up(name):
    """A number of the first item changed by one."""
    return lambda items: items[0].update({name: [(float.fromhex(x) + 1).hex() for x in items[0][name]]})


def _fact(**facts):
    return lambda items: items[0]["facts"].update(facts)


WRONG = {
    "value": ("random", "value", lambda items: items[0].update(x=items[0]["x"][::-1])),
    "inflection": ("near", "inflections", list.pop),
    "intersection": ("near", "intersections", list.pop),
    "nearest": ("random", "nearest", lambda items: items[0].update(distance=items[0]["distance"][:1] * 3)),
    "nearest point": ("random", "nearest", _up("parameter")),
    "pair": ("random", "distance", lambda items: items[0].update(parameter=["0x0p+0"] * 3)),
    "distance": ("random", "distance", _up("distance")),
    "winding number": ("integers", "winding_number", _up("value")),
    "curvature": ("random", "curvature", _up("curvature")),
    "torsion": ("integers", "torsion", _up("torsion")),
    "box": ("fonts", "bounding_box", _up("high")),
    "kind": ("near", "critical_points", lambda items: items[0].update(what="stationary")),
    "extremum": ("near", "curvature_extrema", list.pop),
    "invented": ("random", "critical_points", _up("parameter")),
    "joint": ("cad", "joints", _fact(geometric_continuity=0)),
    "corner": ("named", "corners", list.clear),
    "piece": ("integers", "straight_pieces", list.clear),
    "cusp": ("integers", "cusps", lambda items: items[-1].update(what="stop")),
    "loop": ("integers", "self_intersections", _up("parameter")),
}


@pytest.fixture(scope="module")
def lines():
    """The first case of a family with an answer to a question that is not empty."""
    known = {}

    def first(family, question):
        for number, case in enumerate(corpus(family, 60)):
            if (family, number) not in known:
                known[family, number] = json.loads(line_of(case))["case"]
            made = known[family, number]
            if made["answers"].get(question, {}).get("items"):
                return copy.deepcopy(made)
        raise LookupError(question)

    return first


@pytest.mark.parametrize("what", WRONG)
def test_a_wrong_answer_is_found(lines, what, tmp_path):
    """Doubles, kinds and facts changed, or something taken away, under a digest that fits."""
    family, question, spoil = WRONG[what]
    case, place = lines(family, question), tmp_path / "changed.json"

    def checked_again():
        body = json.dumps(case, ensure_ascii=True, separators=(",", ":"))
        line = {"digest": f"{crc32(body.encode()):08x}", "case": case}
        place.write_text(json.dumps({"cases": [line]}), encoding="utf-8")
        return checked(place, share=1)

    assert checked_again()[1][question] == 1
    spoil(case["answers"][question]["items"])
    with pytest.raises(ValueError, match=re.escape(case["key"])):
        checked_again()


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
