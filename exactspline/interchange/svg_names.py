"""The names of elements, properties and units of SVG, by what they mean to a reader of curves."""

from __future__ import annotations

import json
from importlib import resources
from typing import Any

#: The names of each kind.
NAMES: dict[str, Any] = json.loads(resources.files(__package__).joinpath("svg_names.json").read_text(encoding="utf-8"))
