"""The command line. The exit status is 0 if everything is as recorded, 1 if a verdict differs from the record, 2 for
bad input, and 130 after Ctrl-C.
"""

from __future__ import annotations

import gc
import sys
from collections.abc import Callable, Sequence

import click

from exactspline.cli.commands import COMMANDS, ELSEWHERE, Entry
from exactspline.cli.output import INTERRUPTED, guard_output, to_stderr
from exactspline.errors import ExactSplineError, command_name
from exactspline.hooks import named
from exactspline.release import __version__, all_releases

#: The number of new objects after which Python looks for unused cycles: most objects of a command live to its end.
YOUNG = 100_000
SHELLS = ("bash", "zsh", "fish")
ABOUT = "B-splines and NURBS in exact rational arithmetic: identities proved or refuted, never 'up to 1e-9'."
FIRST = ("prove", "errata", "inspect ellipse")


def _examples(examples: Sequence[str], title: str) -> str:
    """Examples, one per line: click keeps the lines of a paragraph that begins with a backspace."""
    lines = "\n".join(f"  {command_name()} {example}" for example in examples)
    return f"\b\n{title}:\n{lines}"


def _statuses(entry: Entry) -> str:
    one = f" 1 {entry.status_1};" if entry.status_1 else ""
    return f"Exit status: 0 success;{one} 2 {entry.status_2}."


class _Commands(click.Group):
    """A group of commands. Only the command that is called is imported; a misspelt name is answered by the nearest
    ones.
    """

    def __init__(self, name: str, help: str, entries: dict[str, Entry], **fields: object) -> None:
        super().__init__(name, help=help, no_args_is_help=True, **fields)  # type: ignore[arg-type]  # what click takes
        self.entries = entries

    def list_commands(self, ctx: click.Context) -> list[str]:
        """The names of the commands, in the order of the help."""
        return [*self.entries]  # `list` is the module of a command here

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """The command with this name."""
        entry = self.entries.get(cmd_name)
        if entry is None:
            return None
        if entry.commands:
            return _Commands(cmd_name, entry.short, entry.commands, epilog=_examples(entry.examples, "Examples"))
        from exactspline.cli.output import command_of

        made = named(f"exactspline.{entry.home}")
        epilog = f"{_examples(entry.examples, 'Examples')}\n\n{_statuses(entry)}"
        return command_of(made, cmd_name, entry, epilog)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the commands, each with a short description."""
        with formatter.section("Commands"):
            formatter.write_dl([(name, entry.short) for name, entry in self.entries.items()])

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """The command that the first word names; the error for another word names the nearest commands, also of
        subgroups.
        """
        name = args[0]
        if name not in self.entries and not name.startswith("-"):
            below = {sub: f"{group} {sub}" for group, entry in self.entries.items() for sub in entry.commands}
            raise _unknown(name, ELSEWHERE | {each: each for each in self.entries} | below, ctx)
        return super().resolve_command(ctx, args)


def _unknown(name: str, known: dict[str, str], ctx: click.Context) -> click.UsageError:
    from difflib import get_close_matches

    near = [known[each] for each in ([name] if name in known else get_close_matches(name, known))]
    hint = f" Did you mean {' or '.join(map(repr, near))}?" if near else ""
    return click.UsageError(f"No such command {name!r}.{hint}", ctx)


def _usage_message(error: click.UsageError) -> str:
    """The error for bad usage in one line: the error itself, and the command that explains the right usage."""
    said = error.message if isinstance(error, click.BadParameter) and error.message else error.format_message()
    asked = error.ctx.command_path if error.ctx else command_name()
    if isinstance(error, click.NoSuchOption) and (example := _without_option(error)):
        said = f"{error.message.rstrip('.')}; write `{asked} {example}`"
    elif isinstance(error, click.NoSuchOption) and (others := _with_option(error)):
        named = " and ".join(f"`{name}`" for name in others)
        said = f"{error.message.rstrip('.')}; {named} {'have' if others[1:] else 'has'} it"
    said = f"{said[:1].lower()}{said[1:]}".replace(". Did", "; did").rstrip(".?")
    return f"{said}; `{asked} --help` explains it"


def _without_option(error: click.NoSuchOption) -> str:
    """The argument to give in this command instead of the option; empty if there is none."""
    from exactspline.cli.output import Command

    command = error.ctx.command if error.ctx else None
    return command.without_option(error.option_name) if isinstance(command, Command) else ""


def _with_option(error: click.NoSuchOption) -> list[str]:
    """Other commands of the same group that have the option which this one lacks; at most two."""
    ctx = error.ctx.parent if error.ctx else None
    if ctx is None or not isinstance(ctx.command, _Commands):
        return []
    others = [(name, ctx.command.get_command(ctx, name)) for name in ctx.command.list_commands(ctx)]
    found = [name for name, each in others if each and any(error.option_name in param.opts for param in each.params)]
    return [f"{ctx.command_path} {name}" for name in found[:2]]


def _version(ctx: click.Context, parameter: click.Parameter, requested: bool) -> None:
    if requested:
        click.echo(f"exactspline {__version__}")
        ctx.exit()


def _versions(ctx: click.Context, parameter: click.Parameter, requested: bool) -> None:
    if requested:
        from exactspline.programs.accelerator import filter_curve

        for name, found in all_releases().items():
            click.echo(f"{name} {found}")
        click.echo(f"compiled filter: {'none, answers are the same' if filter_curve is None else 'runs'}")
        ctx.exit()


def _completion(ctx: click.Context, parameter: click.Parameter, shell: str | None) -> None:
    if shell:
        from click.shell_completion import get_completion_class

        kind = get_completion_class(shell)
        assert kind is not None, "one of those that the option names"
        click.echo(kind(app, {}, "exactspline", "_EXACTSPLINE_COMPLETE").source())
        ctx.exit()


def _eager(name: str, callback: Callable[..., None], help: str, **fields: object) -> click.Option:
    """An option that prints something in place of a command."""
    return click.Option([name], is_eager=True, expose_value=False, callback=callback, help=help, **fields)  # type: ignore[arg-type]  # what click takes


app = _Commands(
    "exactspline",
    ABOUT,
    COMMANDS,
    epilog=f"{_examples(FIRST, 'Begin with')}\n\nExit status: 0 success; 1 {COMMANDS['prove'].status_1}; 2 bad input.",
    params=[
        _eager("--version", _version, "Show the version.", is_flag=True),
        _eager(
            "--versions", _versions, "Show the versions of exactspline, of Python and of the libraries.", is_flag=True
        ),
        _eager("--completion", _completion, "Print the script that completes commands.", type=click.Choice(SHELLS)),
    ],
)


def main() -> None:
    """Run the command line: bad input ends in one line on standard error and exit status 2."""
    gc.set_threshold(YOUNG)
    guard_output()
    try:
        try:
            status = app.main(prog_name=command_name(), complete_var="_EXACTSPLINE_COMPLETE", standalone_mode=False)
        finally:
            gc.freeze()  # the process ends: a search for unused cycles in a million objects would only delay it
            sys.stdout.flush()
        sys.exit(status)
    except click.exceptions.NoArgsIsHelpError as error:
        error.show()
        sys.exit(2)
    except (ExactSplineError, click.UsageError) as error:
        to_stderr(f"error: {_usage_message(error) if isinstance(error, click.UsageError) else error}")
        sys.exit(2)
    except (click.Abort, KeyboardInterrupt):
        to_stderr("interrupted")
        sys.exit(INTERRUPTED)
    except OSError as error:
        # output that could not be written must not be written again when Python closes its files
        sys.stdout = None  # Python itself sets it so where there is none
        to_stderr(f"error: the output cannot be written ({error.strerror})")
        sys.exit(2)
