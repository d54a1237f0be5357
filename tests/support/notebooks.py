"""A notebook run by IPython in a process of its own, forked from one that has imported what takes long."""

import os
import warnings
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path

LIBRARIES = ["IPython.core.interactiveshell", "matplotlib.pyplot", "tests.support.looking"]


@dataclass(frozen=True)
class Shown:
    """What a notebook showed: the kinds of its outputs, what it wrote to standard error, how many pictures there
    were and what cannot be read in them."""

    kinds: frozenset[str]
    written: str
    looked_at: int
    unreadable: tuple[str, ...]
    error: str = ""


def shown_by(cells: list[str], folder: Path) -> Shown:
    """Run cells one after the other, as a kernel does that was just started."""
    context = get_context("forkserver")
    context.set_forkserver_preload(LIBRARIES)
    ours, theirs = context.Pipe(duplex=False)
    process = context.Process(target=_run, args=(cells, str(folder), theirs))
    process.start()
    theirs.close()
    try:
        return ours.recv()
    finally:
        process.join()


def _run(cells, folder, answer):
    os.chdir(folder)
    os.environ["IPYTHONDIR"] = os.path.join(folder, "ipython")
    warnings.resetwarnings()
    from IPython.core.displayhook import CapturingDisplayHook
    from IPython.core.interactiveshell import InteractiveShell
    from IPython.utils.capture import capture_output
    from matplotlib.figure import Figure

    from tests.support.looking import unreadable

    plain, looked_at, noted = Figure.savefig, [], []

    def savefig(figure, *given, **options):
        plain(figure, *given, **options)
        looked_at.append(figure)
        noted.extend(unreadable(figure))

    Figure.savefig = savefig

    class Shell(InteractiveShell):
        def enable_gui(self, gui=None):
            """There is no window: pictures are shown inline."""

    shell, kinds, written, error = Shell.instance(), set(), "", ""
    results = []
    shell.display_trap.hook = CapturingDisplayHook(shell=shell, outputs=results)
    for cell in cells:
        with capture_output() as captured:
            done = shell.run_cell(cell)
        kinds |= {kind for output in captured.outputs for kind in output.data}
        written += captured.stderr
        if not done.success:
            error = f"{done.error_before_exec or done.error_in_exec!r} in:\n{cell}"
            break
    kinds |= {kind for result in results for kind in result["data"]}
    answer.send(Shown(frozenset(kinds), written, len(looked_at), tuple(noted), error))
