"""Lets the proofs import the module `theorem`."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
