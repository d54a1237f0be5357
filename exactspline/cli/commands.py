"""Every command, as ``commands.toml`` beside this file describes it: the function that it calls, a short description,
examples, the meaning of its exit status, and what the help says of its arguments and options.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from os.path import dirname, join
from typing import Any

try:  # compiled
    import tomli as toml
except ModuleNotFoundError:  # in a browser
    import tomllib as toml  # type: ignore[no-redef]  # has the same functions

from exactspline.errors import command_name


@dataclass(frozen=True)
class Taken:
    """What is said of an argument or an option. The help shows `metavar`, or the name of the parameter; an option is
    called as its parameter, or by `flags`. Words complete what is typed (`completion`: the name of a function).
    `instead_of` are options under which other commands take the value of an argument, each with an example of the
    value; under ``-`` stands the form of a value that begins with a minus.
    """

    help: str
    is_argument: bool
    metavar: str | None = None
    flags: Sequence[str] = ()
    min: int | None = None
    max: int | None = None
    completion: str = ""
    instead_of: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Entry:
    """A command (``module:function`` of exactspline), or a group of commands. `arguments` and `options` hold what it
    says itself of its parameters; the rest is shared (see `taken`).
    """

    short: str
    examples: Sequence[str]
    home: str = ""
    status_1: str = ""
    status_2: str = "bad input"
    commands: dict[str, Entry] = field(default_factory=dict)
    arguments: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    options: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)

    def taken(self, name: str) -> Taken:
        """What is said of a parameter."""
        kind = "arguments" if name in self.arguments else "options"
        own = getattr(self, kind).get(name, {"like": name})
        said = _TABLE["shared"][kind][own["like"]] if "like" in own else own
        text = said["help"].replace("$curve", _TABLE["curve"]).replace("$command", command_name())
        return Taken(**said | {"help": text, "is_argument": kind == "arguments"})


def _entries(tables: Mapping[str, Mapping[str, Any]]) -> dict[str, Entry]:
    return {name: Entry(**{**each, "commands": _entries(each.get("commands", {}))}) for name, each in tables.items()}


with open(join(dirname(__file__), "commands.toml"), "rb") as _stream:
    _TABLE = toml.load(_stream)
COMMANDS = _entries(_TABLE["commands"])
#: Words that users try as commands, and the commands that they mean.
ELSEWHERE: dict[str, str] = _TABLE["elsewhere"]


def leaves(commands: dict[str, Entry] = COMMANDS, above: str = "") -> dict[str, Entry]:
    """Every command, without the groups of commands, by the words that call it.

    >>> [name for name in leaves() if name.startswith("teach")]
    ['teach triangle', 'teach exercise', 'teach check']
    """
    found: dict[str, Entry] = {}
    for name, entry in commands.items():
        found |= leaves(entry.commands, f"{above}{name} ") if entry.commands else {f"{above}{name}": entry}
    return found
