"""Notebooks with their outputs: executed by kernels, as many at once as there are processors."""

from __future__ import annotations

import asyncio
import os
from pathlib import Path

import nbformat
from nbclient import NotebookClient

#: Seconds for a cell.
TIMEOUT = 300


def execute(folder: Path) -> None:
    """Execute all notebooks of a folder and store their outputs in them.

    Raises `nbclient.exceptions.CellExecutionError` where a cell fails.
    """
    asyncio.run(_execute_all(sorted(folder.glob("*.ipynb"))))


async def _execute_all(files: list[Path]) -> None:
    free = asyncio.Semaphore(os.cpu_count() or 1)
    await asyncio.gather(*(_execute(file, free) for file in files))


async def _execute(file: Path, free: asyncio.Semaphore) -> None:
    book = nbformat.read(file, as_version=4)
    where = {"metadata": {"path": str(file.parent)}}
    async with free:
        await NotebookClient(
            book, timeout=TIMEOUT, resources=where, extra_arguments=["--log-level=ERROR"]
        ).async_execute()
    nbformat.write(book, file)
