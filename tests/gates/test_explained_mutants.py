"""Explanations of mutants speak of mutants that there are, each once."""

import tomllib
from pathlib import Path

from workshop.mutation.mutants import mutants

SURVIVORS = Path(__file__).resolve().parents[2] / "workshop" / "mutation" / "survivors.toml"


def test_what_is_explained_exists():
    """Passed before: explanations of functions that had been edited or moved."""
    data = tomllib.loads(SURVIVORS.read_text(encoding="utf-8"))
    entries, functions = data["survivor"], data["function"]
    for entry in functions:
        file, _, name = entry["of"].partition(":")
        assert any(mutant.function == name for mutant in mutants(file))
        assert len(entry["because"].split()) > 3
    names = [entry["mutant"] for entry in entries]
    assert len(set(names)) == len(names)
    assert all(len(entry["because"].split()) > 3 for entry in entries)
    known = {mutant.stable for file in {name.partition(":")[0] for name in names} for mutant in mutants(file)}
    assert [name for name in names if name not in known] == []
