"""Notebooks with their outputs: each run by IPython in a process of its own, forked from one that has imported what
takes long, as many at once as there are processors.
"""

from __future__ import annotations

import base64
import os
import warnings
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from io import BytesIO
from multiprocessing import get_context
from multiprocessing.connection import Connection
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import nbformat
from nbformat.v4 import new_output

from docs.site.kept import kept

LIBRARIES = ["IPython.core.interactiveshell", "matplotlib.pyplot", "exactspline.display.notebook", "exactspline.tables"]


@dataclass(frozen=True)
class Shown:
    """What a notebook showed: the outputs cell by cell, how many pictures there were and what was noted of them."""

    outputs: tuple[list[Any], ...]
    looked_at: int
    noted: tuple[str, ...]
    error: str = ""

    @property
    def kinds(self) -> set[str]:
        """The kinds of what was shown."""
        return {kind for cell in self.outputs for each in cell for kind in each.get("data", ())}

    @property
    def written(self) -> str:
        """What was written to standard error."""
        return "".join(each.text for cell in self.outputs for each in cell if each.get("name") == "stderr")


def execute(folder: Path) -> None:
    """Execute all notebooks of a folder and store their outputs in them; what tests have kept is taken from there.

    Raises `RuntimeError` where a cell fails.
    """
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(_execute, sorted(folder.glob("*.ipynb"))))


def _execute(file: Path) -> None:
    book = nbformat.read(file, as_version=4)
    before = kept(file.name)
    if before and before.exists():
        done = nbformat.read(before, as_version=4)
        if [cell.source for cell in done.cells] == [cell.source for cell in book.cells]:
            nbformat.write(done, file)
            return
    with TemporaryDirectory() as place:
        shown = shown_by(code_cells(book), place)
    if shown.error:
        raise RuntimeError(f"{file.name}: {shown.error}")
    store(book, shown, file)


def code_cells(book: Any) -> list[str]:
    """The sources of the cells that are executed."""
    return [cell.source for cell in book.cells if cell.cell_type == "code"]


def store(book: Any, shown: Shown, file: Path) -> None:
    """Write a notebook with what it showed."""
    cells = (cell for cell in book.cells if cell.cell_type == "code")
    for number, (cell, outputs) in enumerate(zip(cells, shown.outputs, strict=True), 1):
        cell.outputs, cell.execution_count = outputs, number
    file.parent.mkdir(parents=True, exist_ok=True)
    nbformat.write(book, file)


def shown_by(
    cells: Sequence[str],
    folder: str | Path,
    look: Callable[[Any], list[str]] | None = None,
    within: Callable[[], AbstractContextManager[None]] = nullcontext,
    *,
    narrow: bool = True,
) -> Shown:
    """Run cells one after the other, as a kernel does that was just started; `look` notes something of each picture,
    all cells run `within` a context, and pictures are also drawn `narrow`.
    """
    context = get_context("forkserver")
    context.set_forkserver_preload([*LIBRARIES, *([look.__module__] if look else [])])
    ours, theirs = context.Pipe(duplex=False)
    process = context.Process(target=_run, args=(cells, str(folder), look, within, narrow, theirs))
    process.start()
    theirs.close()
    try:
        shown: Shown = ours.recv()
    finally:
        process.join()
    return shown


def _run(
    cells: Sequence[str],
    folder: str,
    look: Callable[[Any], list[str]] | None,
    within: Callable[[], AbstractContextManager[None]],
    narrow: bool,
    answer: Connection,
) -> None:
    os.chdir(folder)
    os.environ["IPYTHONDIR"] = os.path.join(folder, "ipython")
    warnings.resetwarnings()
    from IPython.core.displayhook import CapturingDisplayHook
    from IPython.core.interactiveshell import InteractiveShell
    from IPython.utils.capture import capture_output

    from docs.site.narrow import narrowed, png, saved

    looked_at, noted = [], []
    small: dict[bytes, bytes] = {}

    def seen(figure: Any, target: Any) -> None:
        looked_at.append(figure)
        noted.extend(look(figure) if look else [])
        if narrow and isinstance(target, BytesIO):
            small[target.getvalue()] = png(narrowed(figure))

    class Shell(InteractiveShell):
        def enable_gui(self, gui: Any = None) -> None:
            """There is no window: pictures are shown inline."""

    shell, outputs, error = Shell.instance(), [], ""
    with within():
        for cell in cells:
            with capture_output() as captured, saved(seen):
                # what the last line returns comes after what was displayed before it
                shell.display_trap.hook = CapturingDisplayHook(shell=shell, outputs=shell.display_pub.outputs)
                done = shell.run_cell(cell)
            outputs.append(_outputs(captured, small))
            if not done.success:
                error = f"{done.error_before_exec or done.error_in_exec!r} in:\n{cell}"
                break
    answer.send(Shown(tuple(outputs), len(looked_at), tuple(noted), error))


def _outputs(captured: Any, small: dict[bytes, bytes]) -> list[Any]:
    """What a cell wrote and displayed, each picture followed by the one for narrow windows, where there is one."""
    streams = [("stdout", captured.stdout), ("stderr", captured.stderr)]
    outputs = [new_output("stream", name=name, text=text) for name, text in streams if text]
    for each in captured.outputs:
        shown = {kind: _encoded(data) for kind, data in each.data.items()}
        outputs.append(new_output("display_data", data=shown))
        if picture := small.get(each.data.get("image/png")):
            outputs.append(new_output("display_data", data={"image/png": _encoded(picture)}))
    return outputs


def _encoded(data: Any) -> Any:
    """Pictures as notebooks store them."""
    return base64.b64encode(data).decode() if isinstance(data, bytes) else data
