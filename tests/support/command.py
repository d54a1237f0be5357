"""The command line: in this process, where what is loaded and computed once stays; in its own where that matters."""

import gc
import io
import json
import os
import re
import subprocess
import sys
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from unittest import mock

from click.testing import CliRunner, Result

from exactspline.cli import app, main

#: Tables have room for everything, as long as a test asks for no other width.
WIDE = {"COLUMNS": "200"}


@dataclass(frozen=True)
class Done:
    """What a command ended with and what it said."""

    returncode: int
    stdout: str
    stderr: str


def invoke(*arguments: object, **options: object) -> Result:
    """The command without what `main` adds: an error is the result's exception."""
    return CliRunner().invoke(app, [str(argument) for argument in arguments], **options)


@cache
def leaves(*above: str) -> tuple[str, ...]:
    """Every command that does something, by the words that call it, as the help lists them."""
    _, listed, rest = invoke(*above, "--help").stdout.partition("\nCommands:\n")
    if not listed:
        return (" ".join(above),)
    names = re.findall(r"^  (\S+)", rest.partition("\n\n")[0], re.MULTILINE)
    return tuple(leaf for name in names for leaf in leaves(*above, name))


def new_paper(folder: Path) -> Path:
    """A folder with an example of a formula and of a claim, as a new author gets it."""
    assert invoke("paper", "new", folder).exit_code == 0
    return folder


@cache
def schema_of(name: str) -> dict[str, object]:
    """The JSON Schema of a document, as it is published."""
    return dict(json.loads(invoke("schema", name).stdout))


def run(*arguments: object) -> Done:
    """The command as `main` runs it, with a traceback where a user would see one."""
    stdout, stderr, threshold = io.StringIO(), io.StringIO(), gc.get_threshold()
    argv = ["exactspline", *map(str, arguments)]
    status: object = 0
    with (
        mock.patch.object(sys, "argv", argv),
        mock.patch.dict(os.environ, WIDE),
        mock.patch.object(gc, "freeze"),  # this process does not end
        redirect_stdout(stdout),
        redirect_stderr(stderr),
    ):
        try:
            main()
        except SystemExit as end:
            status = end.code or 0
        finally:
            gc.set_threshold(*threshold)
    assert isinstance(status, int)
    return Done(status, stdout.getvalue(), stderr.getvalue())


def run_alone(*arguments: object) -> subprocess.CompletedProcess[str]:
    """The command in a process of its own, as a user runs it."""
    command = [sys.executable, "-m", "exactspline", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False, env=os.environ | WIDE)
