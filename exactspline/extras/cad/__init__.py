"""Formats of CAD programs: STEP, IGES, BREP, DXF, 3dm, g2, G+Smo, IRIT, geomdl."""

from __future__ import annotations

import json
from importlib import resources
from typing import Any

# ---- the meanings of codes and keywords of the formats


#: The table of each kind.
NAMES: dict[str, Any] = json.loads(resources.files(__package__).joinpath("names.json").read_text(encoding="utf-8"))
