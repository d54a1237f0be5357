"""Commands made from typed functions: annotations declare options and arguments, and click parses them."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any, get_args, get_origin, get_type_hints

import click
from click.exceptions import Exit

from exactspline.errors import shown

__all__ = ["Argument", "Command", "Exit", "Option", "command_of"]

#: A function that returns the words that complete a typed text.
Completion = Callable[[str], Sequence[str]]


class Option:
    """An option of a command: its names, the placeholder of its value in the help, and the range of a number."""

    def __init__(
        self,
        *names: str,
        help: str,
        metavar: str | None = None,
        min: int | None = None,
        max: int | None = None,
        completion: Completion | None = None,
    ) -> None:
        self.names, self.help, self.metavar = names, help, metavar
        self.min, self.max, self.completion = min, max, completion


class _Integer(click.IntRange):
    """An integer in a range; the error for other text names the expected numbers."""

    def convert(self, value: object, param: click.Parameter | None, ctx: click.Context | None) -> int:
        """The integer that the text denotes."""
        with suppress(ValueError):
            number = int(str(value))
            if (self.min is None or number >= self.min) and (self.max is None or number <= self.max):
                return number
        name = param.opts[-1] if param else ""
        return self.fail(f"{name} takes {self._range()}, not {shown(value)}", param, ctx)

    def _range(self) -> str:
        if self.max is not None:
            return f"an integer from {self.min or 0} to {self.max}"
        return "an integer" if self.min is None else f"an integer ≥ {self.min}"


@dataclass(kw_only=True)
class Argument:
    """An argument of a command. The help shows the name of the parameter, or `metavar`. `instead_of` are options under
    which other commands take such a value, each with an example of the value; under ``-`` stands the form of a value
    that begins with a minus.
    """

    help: str
    metavar: str | None = None
    completion: Completion | None = None
    instead_of: Mapping[str, str] = field(default_factory=dict)


def command_of(function: Callable[..., object], name: str, short_help: str, epilog: str) -> click.Command:
    """The command that calls a function with the values typed by the user; the annotations say what it takes."""
    hints = get_type_hints(function, include_extras=True)
    return Command(
        name,
        callback=function,
        params=[_parameter(each, hints[each.name]) for each in inspect.signature(function).parameters.values()],
        help=inspect.getdoc(function),
        short_help=short_help,
        epilog=epilog,
    )


class Command(click.Command):
    """A command whose help also explains the arguments."""

    def without_option(self, option: str) -> str:
        """An example of the argument to give in place of an option that this command lacks; empty for no such
        argument.
        """
        key = option if option.startswith("--") else "-"
        return next((each.instead_of[key] for each in self._explained() if key in each.instead_of), "")

    def _explained(self) -> list[_Explained]:
        return [each for each in self.params if isinstance(each, _Explained)]

    def format_help_text(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write what the command does, then its arguments."""
        super().format_help_text(ctx, formatter)
        rows = [(each.make_metavar(ctx), each.explained) for each in self._explained()]
        if rows:
            with formatter.section("Arguments"):
                formatter.write_dl(rows)


class _Explained(click.Argument):
    """An argument with a line in the help."""

    explained = ""
    instead_of: Mapping[str, str]


def _parameter(given: inspect.Parameter, hint: Any) -> click.Parameter:
    annotated, mark = get_args(hint)
    parts = [part for part in get_args(annotated) or (annotated,) if part is not type(None)]
    several = get_origin(annotated) is list or any(get_origin(part) is list for part in parts)
    required = given.default is inspect.Parameter.empty
    fields: dict[str, Any] = {"required": required}
    if several:
        fields["callback"] = _listed
    elif not required:
        fields["default"] = given.default
    if mark.completion:
        fields["shell_complete"] = lambda ctx, parameter, typed: list(mark.completion(typed))
    if isinstance(mark, Argument):
        metavar = mark.metavar or given.name.upper()
        made = _Explained(
            [given.name], nargs=-1 if several else 1, metavar=_shown(metavar, several, required), **fields
        )
        made.explained, made.instead_of = mark.help, mark.instead_of
        return made
    if bool in parts:
        return click.Option([given.name, *mark.names], is_flag=True, help=mark.help, default=False)
    number = int in parts or any(int in get_args(part) for part in parts)
    return click.Option(
        [given.name, *mark.names],
        multiple=several,
        type=_Integer(mark.min, mark.max) if number else str,
        help=mark.help,
        metavar=mark.metavar,
        show_default=not several and bool(given.default) and not required,
        **fields,
    )


def _shown(metavar: str, several: bool, required: bool) -> str:
    dots = "..." if several else ""
    return f"{metavar}{dots}" if required else f"[{metavar}]{dots}"


def _listed(ctx: click.Context, parameter: click.Parameter, values: tuple[Any, ...]) -> list[Any] | None:
    return list(values) or None
