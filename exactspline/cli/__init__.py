"""The command line. Exit status 0: everything as recorded; 1: a verdict differs from the record; 2: bad input."""

from __future__ import annotations

import sys

import typer

from exactspline.cli import (
    bisector,
    conditioning,
    convert,
    curves,
    degrees,
    derive,
    errata,
    figures,
    inspect,
    prove,
    reduce,
    show,
)
from exactspline.errors import ExactSplineError

app = typer.Typer(
    help="B-splines and NURBS in exact rational arithmetic: identities proved or refuted, never 'up to 1e-9'.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)
for command in (
    prove.prove,
    show.show,
    errata.errata,
    degrees.degrees,
    derive.derive,
    curves.curves,
    inspect.inspect,
    bisector.bisector,
    conditioning.conditioning,
    figures.figures,
    reduce.reduce,
    convert.convert,
):
    app.command()(command)


def main() -> None:
    """Entry point: bad input ends in one line on standard error and exit status 2."""
    try:
        try:
            app()
        finally:
            sys.stdout.flush()
    except ExactSplineError as error:
        from exactspline.display.console import show_error

        show_error(error)
        sys.exit(2)
    except BrokenPipeError:
        sys.stderr.close()
        sys.exit(0)
    except OSError as error:
        # what could not be written must not be tried again when Python closes its files
        sys.stdout = None  # type: ignore[assignment]
        sys.stderr.write(f"error: the output cannot be written ({error.strerror})\n")
        sys.exit(2)
