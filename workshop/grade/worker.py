"""One library in a separate process: ``python -m workshop.grade.worker scipy``.

A line of JSON with a curve and questions in; out a line with the reply to each question, null to one that the library
does not answer of such a curve. The output of the library is discarded, and an exception is an answer; if the process
dies, the runner notices.
"""

from __future__ import annotations

import json
import os
import sys
import warnings
from collections.abc import Iterator

from workshop.grade.adapters import adapter
from workshop.grade.adapters.common import Adapter, DeclinedError, Given
from workshop.grade.data import Reply, Request


def replies_to(library: Adapter, request: Request) -> Iterator[Reply | None]:
    """The replies to the questions, in their order."""
    given = Given.of(request["given"])
    for question in request["questions"]:
        if not library.can(question, given):
            yield None
            continue
        try:
            yield {"answer": library.ask(question, given)}
        except (DeclinedError, NotImplementedError) as error:
            yield {"declined": f"{error}"[:300]}
        except Exception as error:  # an exception of a library is its answer
            yield {"raised": f"{type(error).__name__}: {error}"[:300]}


def main() -> None:
    """Answer until there are no more requests."""
    warnings.simplefilter("ignore")
    replies = os.fdopen(os.dup(1), "w", encoding="utf-8")
    silence = os.open(os.devnull, os.O_WRONLY)
    os.dup2(silence, 1)
    os.dup2(silence, 2)
    library = adapter(sys.argv[1])
    print(json.dumps({"version": library.version()}), file=replies, flush=True)
    for line in sys.stdin:
        for reply in replies_to(library, json.loads(line)):
            print(json.dumps(reply), file=replies, flush=True)


if __name__ == "__main__":
    main()
