"""What commands print and write on the examples, as digests: whether a change of the code's form changed an answer.

``python -m tests.campaigns.outputs`` runs every command of the list and names those whose output is another than on
record (exit status 1); ``--record`` writes the record anew. Seconds, and the releases of libraries, are no part of a
digest. Pictures are compared as files, so that a record holds for one release of matplotlib: it is made before a change
and compared after it, on one machine.
"""

from __future__ import annotations

import json
import re
import shlex
import sys
from collections.abc import Iterator
from contextlib import chdir
from hashlib import sha256
from pathlib import Path
from tempfile import TemporaryDirectory

from exactspline.geometry.analysis.ask import REGISTRY
from exactspline.interchange.examples import example_names, example_surface_names
from exactspline.questions.entry import Of
from tests.support.command import run

RECORD = Path(__file__).with_suffix(".json")
#: Times, and the releases of what made a file.
VARYING = re.compile(
    r"\d+(\.\d+)? ?s\b|\"seconds\": ?[\d.e-]+|matplotlib v?[\d.]+|<dc:date>.*?</dc:date>|\b\d+\.\d{3}\b|\d+ ms\b"
)
#: An object of each kind, of which every question is asked.
ASKED = {
    Of.PLANE_CURVE: "rational_cubic_s",
    Of.SPACE_CURVE: "twisted_cubic",
    Of.SURFACE: "biquadratic",
    Of.PLANAR_MAP: "folded_map",
}
#: Surfaces that take seconds.
SLOW = {"bicubic", "cyclide", "rational_biquadratic", "ellipsoid"}
SUFFIXES = ("json", "svg", "dxf", "stp", "igs", "g2", "itd", "xml", "brep", "cptw", "glif")
DERIVED = {
    "rational_cubic": ("evolute", "curvature_squared", "zero_curvature", "critical_curvature", "f2", "g2", "D21"),
    "rational_space_cubic": ("torsion", "focal_curve", "circle_centres", "zero_torsion", "tangent_developable"),
}
PAIRS = (
    ("circle", "ellipse"),
    ("cubic_s", "rational_cubic_s"),
    ("twisted_cubic", "helix_like"),
    ("parabola", "hyperbola"),
    ("straight_line", "straight_cubic"),
)
OTHERS = """\
prove
prove --rows
prove --json --rows
prove --paper all --json
prove --surface bicubic
prove --claim C4.1 --judge sympy
errata
errata --json
errata C4.2b --exact
show
show C4.2 --latex
show "eq. (12)"
identity "f1 = w * f2"
identity "f1 = w^2 * f2"
bisector ellipse --point 1,1/2
bisector ellipse --point 1,1/2 --json
bisector cubic_s parabola --json
bisector twisted_cubic helix_like --json
bisector twisted_cubic --point 0,0,2
formula degrees
formula degrees --json
formula degrees --generic
formula degrees --at 3
formula degrees --formulas
formula degrees evolute --curve cubic_s --certify
formula reduce rectifying_developable
formula reduce curvature_squared_derivative --json
formula conditioning
sweep --random degree=2-5 count=100 seed=1 -o -
sweep --random degree=2-4 count=10 seed=2 --find self_intersections --values -o -
teach triangle cubic_s --at 1/3
teach triangle parabola --elevate 1 --product x,y --latex
teach exercise all --seed 3 --count 2 --solutions
teach exercise all --seed 3 --html
teach check --topic evaluation --seed 0 --text '1, -1'
list curves
list surfaces --json
list formulas
list papers
list questions
list words
schema
schema inspect
schema sweep
coq theorems
paper figures --out pictures
paper new mine
inspect cubic_s --plot picture.svg
inspect ellipse --certificate certificate.json
inspect six_segment_cubic --stability --epsilon 1e-6
inspect space_quartic --stability
inspect cylinder --epsilon 1e-3
inspect cubic_s --emit-coq cubic.v
inspect nothing_of_this_name
between circle ellipse --plot picture.svg
between circle ellipse --epsilon 1e-6
between circle ellipse --emit-coq pair.v
bisector ellipse --point 1,1/2 --plot picture.svg
inspect torus --plot picture.html
derive evolute ellipse_skew -o evolute.json
"""


def commands() -> Iterator[list[str]]:
    """The list."""
    for name in (*example_names(), *(each for each in example_surface_names() if each not in SLOW)):
        yield ["inspect", name]
        yield ["inspect", name, "--json"]
    for of, name in ASKED.items():
        for question, entry in REGISTRY[of].items():
            argument = f":{entry.about.argument}" if entry.about.argument else ""
            if not entry.about.on_request:
                yield ["inspect", name, "--ask", question + argument]
    for name, derived in DERIVED.items():
        for what in derived:
            yield ["derive", what, name, "--json"]
    for pair in PAIRS:
        yield ["between", *pair]
        yield ["between", *pair, "--json"]
    for suffix in SUFFIXES:
        yield ["convert", "rational_cubic_spline", f"curve.{suffix}", "--round"]
    yield from map(shlex.split, OTHERS.splitlines())


def digest(arguments: list[str]) -> str:
    """Of the exit status, of both streams, and of all files that the command wrote."""
    with TemporaryDirectory() as folder, chdir(folder):
        done = run(*arguments)
        texts = [str(done.returncode), done.stdout, done.stderr]
        for path in sorted(Path(folder).rglob("*")):
            if path.is_file():
                texts += [str(path.relative_to(folder)), path.read_bytes().decode("latin-1")]
    return sha256(VARYING.sub("", "\0".join(texts)).encode()).hexdigest()[:16]


def main(*arguments: str) -> int:
    """Compare with the record, or write it."""
    found = {}
    for each in commands():
        found[shlex.join(each)] = digest(each)
        print(".", end="", flush=True)
    print()
    if "--record" in arguments:
        RECORD.write_text(json.dumps(found, indent=0) + "\n", encoding="utf-8")
        return 0
    known = json.loads(RECORD.read_text(encoding="utf-8"))
    changed = sorted(name for name in known.keys() | found.keys() if known.get(name) != found.get(name))
    print(f"{len(found)} outputs, {len(changed)} not as on record", *changed, sep="\n")
    return int(bool(changed))


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
