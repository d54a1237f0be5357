"""What the tests of the same sources have computed, in a folder that the environment names: notebooks with their
outputs, and what was decided of claims.
"""

from __future__ import annotations

import os
import pickle
from pathlib import Path

from exactspline.verification.combined import Proofs

KEPT = "EXACTSPLINE_KEPT"


def kept(name: str) -> Path | None:
    """A file that tests keep; None where none are kept."""
    return Path(os.environ[KEPT], name) if KEPT in os.environ else None


def keep(proofs: Proofs) -> None:
    """Keep what a process has decided."""
    if file := kept(f"{os.getpid()}.proofs"):
        file.parent.mkdir(exist_ok=True)
        file.write_bytes(pickle.dumps(proofs))


def proofs() -> Proofs:
    """What all processes have decided."""
    folder, found = kept(""), Proofs()
    for file in sorted(folder.glob("*.proofs")) if folder else ():
        found.update(pickle.loads(file.read_bytes()))
    return found
