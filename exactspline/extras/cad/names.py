"""What codes and keywords of the formats mean: units of length, entities that are not read."""

from __future__ import annotations

import json
from importlib import resources
from typing import Any

#: The table of each kind.
NAMES: dict[str, Any] = json.loads(resources.files(__package__).joinpath("names.json").read_text(encoding="utf-8"))
