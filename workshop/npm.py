"""Where libraries of npm are: installed by ``npm install --prefix workshop``, or anywhere else."""

from __future__ import annotations

import os
from pathlib import Path


def folder_of(library: str) -> Path | None:
    """The folder of a library, None where it is not installed.

    It is looked for in the folder that EXACTSPLINE_NODE_MODULES names, or without it in ``node_modules`` of the current
    folder, of those above, and of this one.
    """
    named = os.environ.get("EXACTSPLINE_NODE_MODULES")
    here = Path.cwd()
    places = (
        [Path(named)] if named else [each / "node_modules" for each in (here, *here.parents, Path(__file__).parent)]
    )
    return next((place.resolve() / library for place in places if (place / library).is_dir()), None)
