"""bezier-js: quadratic and cubic segments, by node; the answers come from `bezier_js.mjs`.

The library is found by `workshop.npm`.
"""

from __future__ import annotations

import json
import shutil
import subprocess
from importlib import resources

from workshop.grade.adapters.common import Adapter, Given
from workshop.npm import folder_of

QUESTIONS = (
    "value", "first", "second", "curvature", "tangent", "box", "turns", "roots", "inflections", "length", "split",
    "elevate", "nearest", "meetings",
)  # fmt: skip


class BezierJs(Adapter):
    """``new Bezier(points)`` in a separate node process."""

    name = "bezier-js"

    def __init__(self) -> None:
        folder, node = folder_of(self.name), shutil.which("node")
        if folder is None or node is None:
            raise ImportError("bezier-js and node")
        self.folder = folder
        script = resources.files(__package__).joinpath("bezier_js.mjs")
        self.command = [node, str(script), str(folder)]
        self._start()

    def _start(self) -> None:
        self.process = subprocess.Popen(self.command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

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
        if self.process.poll() is not None:
            self._start()  # it ended in the question before
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        other = given.partner.points if given.partner else []
        asked = {"question": question, "points": given.points, "t": given.t, "other": other, "point": given.point}
        self.process.stdin.write(json.dumps(asked) + "\n")
        self.process.stdin.flush()
        answer = json.loads(self.process.stdout.readline())
        if "raised" in answer:
            raise RuntimeError(answer["raised"])
        return answer["answer"]


ADAPTER = BezierJs
