"""bezier-js: quadratic and cubic segments, by node; the answers come from `bezier_js.mjs`.

The library is found where ``npm install bezier-js`` puts it: in a folder above the current one, or in the one that
EXACTSPLINE_NODE_MODULES names.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from importlib import resources
from pathlib import Path

from workshop.grade.adapters.common import Adapter, Given

QUESTIONS = (
    "value", "first", "second", "curvature", "tangent", "box", "turns", "roots", "inflections", "length", "split",
    "elevate",
)  # fmt: skip


def installed() -> Path | None:
    """The folder of the library."""
    named = os.environ.get("EXACTSPLINE_NODE_MODULES")
    here = Path.cwd()
    places = [Path(named)] if named else [folder / "node_modules" for folder in (here, *here.parents)]
    return next((place / "bezier-js" for place in places if (place / "bezier-js").is_dir()), None)


class BezierJs(Adapter):
    """``new Bezier(points)`` in a separate node process."""

    name = "bezier-js"

    def __init__(self) -> None:
        folder, node = installed(), shutil.which("node")
        if folder is None or node is None:
            raise ImportError("bezier-js and node")
        self.folder = folder
        script = resources.files(__package__).joinpath("bezier_js.mjs")
        self.process = subprocess.Popen(
            [node, str(script), str(folder.resolve())], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )

    def version(self) -> str:
        """The version in its package.json."""
        package: dict[str, str] = json.loads((self.folder / "package.json").read_text(encoding="utf-8"))
        return package["version"]

    def can(self, question: str, given: Given) -> bool:
        """Segments of degree 2 and 3 in the plane."""
        usual = given.weights is None and given.dimension == 2 and given.degree in (2, 3)
        return question in QUESTIONS and usual and given.is_bezier

    def ask(self, question: str, given: Given) -> object:
        """The answer of the node process."""
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        self.process.stdin.write(json.dumps({"question": question, "points": given.points, "t": given.t}) + "\n")
        self.process.stdin.flush()
        answer = json.loads(self.process.stdout.readline())
        if "raised" in answer:
            raise RuntimeError(answer["raised"])
        return answer["answer"]


ADAPTER = BezierJs
