"""Commands made from typed functions and what ``commands.toml`` says of them; and the output of commands:
tables for people, and JSON, CSV or Markdown for programs. Standard output survives a reader that closes it.
"""

from __future__ import annotations

import inspect
import io
import json
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import wraps
from itertools import count
from threading import Timer
from time import monotonic
from typing import TYPE_CHECKING, Any, TypeVar, get_args, get_origin, get_type_hints

import click
from click.exceptions import Exit

from exactspline.cli.commands import Entry, Taken
from exactspline.display.sheet import Sheet, csv_of, in_markdown
from exactspline.errors import ExactSplineError, shown
from exactspline.hooks import named
from exactspline.release import releases

if TYPE_CHECKING:
    from rich.progress import Progress
    from typing_extensions import Buffer


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


def command_of(function: Callable[..., object], name: str, entry: Entry, epilog: str) -> click.Command:
    """The command that calls a function with the values typed by the user; its annotations say of which types they
    are.
    """
    hints = get_type_hints(function)
    given = inspect.signature(function).parameters.values()
    return Command(
        name,
        callback=function,
        params=[_parameter(each, hints[each.name], entry.taken(each.name)) for each in given],
        help=inspect.getdoc(function),
        short_help=entry.short,
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


def _parameter(given: inspect.Parameter, hint: Any, taken: Taken) -> click.Parameter:
    parts = [part for part in get_args(hint) or (hint,) if part is not type(None)]
    several = get_origin(hint) is list or any(get_origin(part) is list for part in parts)
    required = given.default is inspect.Parameter.empty
    fields: dict[str, Any] = {"required": required}
    if several:
        fields["callback"] = _listed
    elif not required:
        fields["default"] = given.default
    if taken.completion:
        fields["shell_complete"] = lambda ctx, parameter, typed: _begun(taken.completion, typed)
    if taken.is_argument:
        metavar = _shown(taken.metavar or given.name.upper(), several, required)
        made = _Explained([given.name], nargs=-1 if several else 1, metavar=metavar, **fields)
        made.explained, made.instead_of = taken.help, taken.instead_of
        return made
    names = [given.name, *(taken.flags or [f"--{given.name.replace('_', '-')}"])]
    if bool in parts:
        return click.Option(names, is_flag=True, help=taken.help, default=False)
    number = int in parts or any(int in get_args(part) for part in parts)
    return click.Option(
        names,
        multiple=several,
        type=_Integer(taken.min, taken.max) if number else str,
        help=taken.help,
        metavar=taken.metavar,
        show_default=not several and bool(given.default) and not required,
        **fields,
    )


def _begun(words: str, typed: str) -> list[str]:
    """Of words, or of those that a function returns (``module:name``), the ones that begin with what was typed."""
    found = named(f"exactspline.{words}")
    return [word for word in (found() if callable(found) else found) if word.startswith(typed)]


def _shown(metavar: str, several: bool, required: bool) -> str:
    dots = "..." if several else ""
    return f"{metavar}{dots}" if required else f"[{metavar}]{dots}"


def _listed(ctx: click.Context, parameter: click.Parameter, values: tuple[Any, ...]) -> list[Any] | None:
    return list(values) or None


#: The version of every JSON document; it increases when a field changes its meaning or is removed.
VERSION = 3


class OptionsError(ExactSplineError):
    """Options that contradict each other."""


class _State:
    """The state of the command that runs; it is set when the command begins."""

    quiet = False
    #: Whether something was skipped (read, but not a curve) or is undecided.
    lacking = False


#: The exit status after Ctrl-C, as shells have it: 128 and the number of the signal.
INTERRUPTED = 130


def to_stderr(line: str) -> None:
    """Write a line to standard error. No other function does: a line may hold names from files, and their control
    characters must not reach the terminal.
    """
    from exactspline.display.sheet import visible

    sys.stderr.write(visible(line).replace("\n", "\\n") + "\n")


def is_quiet() -> bool:
    """Whether only the result is to be printed."""
    return _State.quiet


def leave_out() -> None:
    """Record that something was skipped or is undecided: with --strict the command then ends with exit status 2."""
    _State.lacking = True


#: The fields of rows that list the missing parts of an answer.
LACKING = ("missing", "undecided", "skipped")


def _lacks(value: object) -> bool:
    """Whether data say, at any depth, that an answer is incomplete.

    >>> _lacks({"points": [], "undecided": []}), _lacks([{"curvature": {"undecided": ["[0, 1] × [0, 1]"]}}])
    (False, True)
    """
    if isinstance(value, Mapping):
        return value.get("complete") is False or any(
            bool(part) if name in LACKING else _lacks(part) for name, part in value.items()
        )
    return isinstance(value, (list, tuple)) and any(map(_lacks, value))


@dataclass(frozen=True)
class Output:
    """The format in which the result of a command is printed."""

    format: str
    quiet: bool
    strict: bool = False

    @property
    def for_people(self) -> bool:
        """Whether the format is text for people."""
        return self.format == "text"

    def give(
        self,
        schema: str,
        rows: Iterable[Mapping[str, object]],
        sheets: Iterable[Sheet],
        people: Callable[[], None] | None = None,
        by: str = "",
    ) -> None:
        """Print the result: `rows` as JSON, or `sheets` as CSV or Markdown (`by` heads the column of their names). For
        people, `people` is called; without it the sheets are printed with their legend. Rows and sheets may be
        generators, so that only what is printed is computed.
        """
        if self.strict:
            rows = list(rows)
            _State.lacking |= _lacks(rows)
        remark = f"{RAN}: {', '.join(unchecked())}" if unchecked() else ""
        if self.format == "json":
            print_json(document(schema, rows))
        elif self.format == "csv":
            sys.stdout.write(csv_of(list(sheets), by, unchecked=unchecked()))
        elif self.format == "markdown":
            remarks = [in_markdown(remark)] if remark else []
            sys.stdout.write("\n\n".join([*[sheet.markdown() for sheet in sheets], *remarks]) + "\n")
        elif self.format == "latex":
            sys.stdout.write("\n\n".join([sheet.latex() for sheet in sheets] + [f"% {remark}"] * bool(remark)) + "\n")
        else:
            people() if people else self.show(list(sheets))
            if remark:
                from exactspline.display import console

                console.lines(console.console(), remark, style="bold")

    def show(self, sheets: Sequence[Sheet]) -> None:
        """Print tables one below the other, then the meaning of their columns."""
        from exactspline.display import console

        out = console.console()
        console.below_each_other(out, sheets)
        if not self.quiet:
            tags = [tag for sheet in sheets for tag in sheet.tags]
            console.legend(out, [*[name for sheet in sheets for name in sheet.columns], *tags])


#: The remark that is printed if formulas ran unchecked.
RAN = "formulas that ran unchecked (--trust)"


def unchecked() -> tuple[str, ...]:
    """The files of formulas that this command ran unchecked."""
    loading = sys.modules.get("exactspline.papers.loading")  # where it was not needed nothing ran
    return loading.ran_unchecked() if loading else ()


def document(schema: str, rows: Iterable[Mapping[str, object]]) -> dict[str, object]:
    """Rows for programs, under the name of their schema (`exactspline schema NAME`) and its version, with the releases
    that made them. If formulas ran unchecked, their files are listed.
    """
    head: dict[str, object] = {"schema": f"exactspline/{schema}", "version": VERSION, "releases": releases()}
    made = list(rows)
    return head | ({"unchecked": list(unchecked())} if unchecked() else {}) | {"rows": made}


def print_json(data: object) -> None:
    """Print JSON on standard output."""
    sys.stdout.write(json.dumps(data, ensure_ascii=False, indent=1) + "\n")


#: The options of all commands that print something.
_FLAGS = ("as_json", "as_csv", "as_markdown", "strict", "quiet")


def printing(command: Callable[..., None]) -> Callable[..., None]:
    """Make of a function a command: its parameter ``out`` is the `Output` that the options of all commands describe."""

    @wraps(command)
    def run(**values: Any) -> None:
        chosen = [name for name in ("json", "csv", "markdown", "latex") if values.pop(f"as_{name}", False)]
        if len(chosen) > 1:
            raise OptionsError(f"--{chosen[0]} and --{chosen[1]}", remedy="choose one of them")
        _State.quiet, _State.lacking, strict = values.pop("quiet"), False, values.pop("strict")
        if loading := sys.modules.get("exactspline.papers.loading"):
            loading.forget_what_ran()
        try:
            command(out=Output(chosen[0] if chosen else "text", _State.quiet, strict), **values)
            if strict and _State.lacking:
                raise Exit(2)
        finally:
            _State.quiet = False

    hints = get_type_hints(command)
    own = [
        p.replace(annotation=hints[p.name], kind=inspect.Parameter.KEYWORD_ONLY)
        for p in inspect.signature(command).parameters.values()
        if p.name != "out"
    ]
    shared = [
        inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=False, annotation=bool) for name in _FLAGS
    ]
    run.__signature__ = inspect.Signature([*own, *shared])  # type: ignore[attr-defined]  # what the command line reads
    run.__annotations__ = {p.name: p.annotation for p in [*own, *shared]}
    return run


class _Guarded(io.FileIO):
    """Standard output that its reader may close (``| head``): the rest of the output is dropped, and the command ends
    with its usual status. After any other failure the rest is dropped, too, so that the end of the process does not
    fail.
    """

    failed = False

    def write(self, data: Buffer, /) -> int:
        """Write, unless the reader has closed the pipe."""
        try:
            if not self.failed:
                return super().write(data) or 0
        except BrokenPipeError:
            pass
        except OSError:
            self.failed = True
            raise
        return memoryview(data).nbytes


def guard_output() -> None:
    """Let standard output survive a reader that leaves and a terminal whose encoding lacks a character."""
    old = sys.stdout
    if isinstance(old, io.TextIOWrapper):
        old.flush()
        raw = _Guarded(old.fileno(), "wb", closefd=False)
        encoding, by_line = old.encoding, old.line_buffering
        sys.stdout = io.TextIOWrapper(
            io.BufferedWriter(raw), encoding=encoding, errors="backslashreplace", line_buffering=by_line
        )


# ---- progress


__all__ = ["Command", "Exit", "bar", "command_of", "seldom", "ticking", "tracked"]

V = TypeVar("V")
#: Seconds before a bar is shown, and between two lines if there is no terminal.
DELAY, BETWEEN = 1 / 2, 10


@contextmanager
def bar(*columns: object) -> Iterator[Progress | None]:
    """A bar on standard error that is shown after half a second; None in a pipe and with ``--quiet``."""
    if is_quiet() or not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import Progress

    made = Progress(*columns, console=Console(stderr=True), transient=True)  # type: ignore[arg-type]  # columns of rich
    delay = Timer(DELAY, made.start)
    delay.daemon = True
    delay.start()
    try:
        yield made
    finally:
        delay.cancel()
        delay.join()
        made.stop()


@contextmanager
def ticking(label: str, total: int) -> Iterator[Callable[[], None]]:
    """A function whose every call advances a bar by one of `total` steps."""
    with bar() as shown:
        if shown is None:
            write, done = seldom(), count(1)
            yield lambda: write(f"{label}: {next(done)} of {total}")
            return
        from rich.markup import escape

        from exactspline.display.sheet import visible

        task = shown.add_task(escape(visible(label)), total=total)
        yield lambda: shown.advance(task)


def seldom() -> Callable[[str], None]:
    """A function that writes a line on standard error, at most once every ten seconds, and never with ``--quiet``."""
    last = monotonic()

    def write(line: str) -> None:
        nonlocal last
        if monotonic() - last >= BETWEEN and not is_quiet():
            last = monotonic()
            print(line, file=sys.stderr, flush=True)

    return write


def tracked(calls: Sequence[Callable[[], V]], label: str) -> list[V]:
    """The results of the calls, with a progress bar."""
    with ticking(label, len(calls)) as tick:
        found = []
        for call in calls:
            found.append(call())
            tick()
        return found
