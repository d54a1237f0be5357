"""``python -m workshop.boolean``: is the result of a Boolean operation right, outside of a tube around the paths?

``judge A OPERATION B RESULT --within E`` decides one result; ``grade`` asks engines about pairs that nearly coincide.
Exit status: 0 right, or graded; 1 wrong (a witness is shown) or not decided; 2 bad input.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections import Counter
from collections.abc import Sequence

from exactspline.atomic_write import write_text
from exactspline.display.sheet import Sheet
from exactspline.errors import CurveFileError
from exactspline.geometry.pairs.winding import FillRule
from exactspline.numbers.exact import rational, text
from workshop.boolean.grading import ENGINES, Graded, Outcome, graded, started
from workshop.boolean.judge import Operation, judged
from workshop.boolean.pairs import pairs
from workshop.boolean.pieces import Region
from workshop.boolean.shrink import shrunk
from workshop.printing import add_formats, ended, show


def arguments(given: Sequence[str] | None) -> argparse.Namespace:
    """The parsed command line."""
    parser = argparse.ArgumentParser(
        prog="python -m workshop.boolean", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    commands = parser.add_subparsers(dest="command", required=True)
    one = commands.add_parser("judge", help="decide one result")
    one.add_argument("first", metavar="A", help="path data of SVG")
    one.add_argument("operation", choices=[str(each) for each in Operation])
    one.add_argument("second", metavar="B")
    one.add_argument("result", metavar="RESULT")
    one.add_argument("--rule", choices=[str(each) for each in FillRule], default="nonzero", help="of A and B")
    one.add_argument("--result-rule", choices=[str(each) for each in FillRule], default="nonzero")
    many = commands.add_parser("grade", help="ask engines")
    many.add_argument("engine", nargs="*", metavar="ENGINE", help=f"{', '.join(ENGINES)}; all that are installed")
    many.add_argument("--count", metavar="N", type=int, default=100, help="pairs")
    many.add_argument("--seed", metavar="N", type=int, default=1)
    many.add_argument("--hunt", action="store_true", help="judge at some points alone: quicker, nothing is found right")
    many.add_argument("--shrink", action="store_true", help="search for smaller pairs with the same failure")
    many.add_argument(
        "--failures", metavar="FILE", default="", help="write every result that is not right (JSON Lines)"
    )
    add_formats(many)
    for each in (one, many):
        each.add_argument("--within", metavar="E", default="1/16", help="the width of the tube")
    return parser.parse_args(given)


def main(given: Sequence[str] | None = None) -> int:
    """Judge or grade; returns the exit status."""
    options = arguments(given)
    return _judge(options) if options.command == "judge" else _grade(options)


def _judge(options: argparse.Namespace) -> int:
    rule, result_rule = FillRule(options.rule), FillRule(options.result_rule)
    first, second = Region.of(options.first, rule), Region.of(options.second, rule)
    result, within = Region.of(options.result, result_rule), rational(options.within)
    found = judged(first, second, Operation(options.operation), result, within)
    if found.witness is not None:
        where = ", ".join(map(text, found.witness))
        print(f"wrong: ({where}) should be {'inside' if found.inside else 'outside'}")
    elif found.undecided:
        print(f"not decided in {len(found.undecided)} squares")
    else:
        print(f"right further than {text(within)} from both paths")
    return 0 if found.right else 1


def _grade(options: argparse.Namespace) -> int:
    unknown = [name for name in options.engine if name not in ENGINES]
    if unknown:
        raise CurveFileError(f"there is no engine called {unknown[0]!r}", remedy=f"there are {', '.join(ENGINES)}")
    rows, failures = list[dict[str, object]](), list[Graded]()
    for name in options.engine or ENGINES:
        try:
            worker = started(name)
        except ImportError:
            continue
        try:
            within = rational(options.within)
            chosen = pairs(options.count, options.seed)
            found = list(graded(worker, chosen, Operation, within, whole=not options.hunt))
            passed = (Outcome.RIGHT, Outcome.UNDECIDED) if options.hunt else (Outcome.RIGHT,)
            not_right = [each for each in found if each.outcome not in passed]
            failures += [shrunk(worker, each, within) for each in not_right] if options.shrink else not_right
        finally:
            worker.close()
        for operation in Operation:
            own = [each for each in found if each.operation is operation]
            counts = Counter(each.outcome for each in own)
            rows.append(
                {"key": f"{name}: {operation}", "engine": name, "version": worker.version, "operation": operation}
                | {"asked": len(own)}
                | {str(outcome): counts[outcome] for outcome in Outcome}
                | {"confirmed": sum(each.confirmed is True for each in own)}
            )
    if options.failures:
        write_text(options.failures, "".join(json.dumps(each.data(), ensure_ascii=False) + "\n" for each in failures))
    numbers = ("asked", *map(str, Outcome), "confirmed")
    names = ("engine", "version", "operation", *numbers)
    cells = [[row[name] for name in names] for row in rows]
    show(options.format, "boolean", rows, Sheet(*names, rows=cells, numbers=numbers, heads=3))
    return 0


if __name__ == "__main__":
    sys.exit(ended(main))
