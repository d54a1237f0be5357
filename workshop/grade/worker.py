"""One library in a separate process: ``python -m workshop.grade.worker scipy``.

A line of JSON with a curve and questions in, a line with the answers out. The output of the library is discarded, and
an exception is an answer; if the process dies, the runner notices.
"""

from __future__ import annotations

import json
import os
import sys
import warnings

from workshop.grade.adapters import adapter
from workshop.grade.adapters.common import Adapter, DeclinedError, Given
from workshop.grade.data import Reply, Request


def answers(library: Adapter, request: Request) -> dict[str, Reply]:
    """The answers to the questions that the library accepts."""
    given, replies = Given.of(request["given"]), dict[str, Reply]()
    for question in request["questions"]:
        if not library.can(question, given):
            continue
        try:
            replies[question] = {"answer": library.ask(question, given)}
        except (DeclinedError, NotImplementedError) as error:
            replies[question] = {"declined": f"{error}"[:300]}
        except Exception as error:  # an exception of a library is its answer
            replies[question] = {"raised": f"{type(error).__name__}: {error}"[:300]}
    return replies


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
        print(json.dumps({"answers": answers(library, json.loads(line))}), file=replies, flush=True)


if __name__ == "__main__":
    main()
