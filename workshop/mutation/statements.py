"""``python -m workshop.mutation.statements``: every printed statement of a paper is changed on purpose, and the ledger
decides the changed statement.

A statement is changed in its claim (a degree by one, an exponent, a sign, an index, its type, two sides exchanged, a
condition dropped) or in the formula that it prints, where only this statement uses the changed copy: a sign, an order
of derivative, an operand, a term. The claims decide, first that of the statement. A change after which its verdict is
the same must say the same (equal in the jets and in naive degrees), or something else that is true and proved; what
remains is *open*. A statement that is false as it is printed may stay false.
"""

from __future__ import annotations

import argparse
import ast
import json
import re
import sys
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from random import Random
from time import monotonic
from types import FunctionType
from typing import Any

from exactspline.errors import ClaimError, ExactSplineError
from exactspline.interchange.examples import example, example_names
from exactspline.language.formula import Formula
from exactspline.language.ruled import split
from exactspline.papers import Paper, Table, paper
from exactspline.readings.differential_order import order_of
from exactspline.readings.jet import RationalJetReading
from exactspline.verification.claim import Claim
from exactspline.verification.claims import claim_of, claims_of
from exactspline.verification.ledger import Row, decide, tasks
from exactspline.verification.notation import factor_parts
from exactspline.verification.vocabulary import Status, ValueType, Verdict
from workshop.mutation.forked import Result, forked
from workshop.mutation.formulas import CURVES, degrees_counted, in_the_jets, quick, refuted, speaking
from workshop.mutation.mutants import ROOT, Mutant, changes, node_of

PAPER = "chen_riesenfeld_cohen_2007"
RECORD = Path(__file__).with_name("statements.jsonl")
PAGE = ROOT / "docs" / "mutation.md"
#: Between these lines of the page stands the table.
BEGIN, END = "<!-- written by python -m workshop.mutation.statements --record -->\n", "<!-- end of statements -->\n"
SEED, EACH, SECONDS = 20, 3, 40
#: The fields in which a claim names formulas.
NAMED = ("left", "right", "formula", "formulas")
#: The fields of a printed entry in addition to its claim.
BESIDE = ("words", "place", "error", "vacuous", "witness", "note", "expected", "section")
#: What is assumed of every curve, and is no condition of the statement.
CONVENTIONS = ("w", "γ′")
#: Kinds of changes of formulas by those of mutants.
KIND = {"operand": "symbols exchanged", "order": "derivative", "operation": "operation", "dropped": "term dropped"}
VERDICTS = (
    "killed",
    "killed by another",
    "false before",
    "equivalent",
    "true too",
    "refused",
    "broken",
    "timeout",
    "open",
)


@dataclass(frozen=True)
class Change:
    """A change of a statement: of fields of its entry, or of the formula in a field (the one with that number)."""

    claim: str
    kind: str
    says: str
    fields: dict[str, Any] = field(default_factory=dict, hash=False)
    side: str = ""
    number: int = -1

    @property
    def name(self) -> str:
        """What the record calls it."""
        return f"{self.claim}: {self.says} [{self.kind}]"


@cache
def entries() -> dict[str, Table]:
    """The entries of the printed claims, by their keys."""
    source = paper(PAPER)
    printed = {claim.key for claim in claims_of(source) if claim.status is Status.PRINTED}
    return {table.entry["key"]: table for table in source.claim_tables() if table.entry.get("key") in printed}


# ---- all changes


def changes_of(key: str) -> list[Change]:
    """Every change of a statement; where its own formulas have too few kinds of changes, also in those they call."""
    entry = entries()[key].entry
    found = [*_of_claimed(key, entry), *_of_factor(key, entry), *_of_names(key, entry), *_of_formulas(key, entry)]
    return found if len({change.kind for change in found}) >= EACH else [*found, *_of_called(key, entry)]


def _of_claimed(key: str, entry: dict[str, Any]) -> Iterator[Change]:
    """Numbers by one, another type, the other curves, conditions."""
    claimed = str(entry.get("claimed", ""))
    kind = "degree" if entry["kind"] == "degree" else "number"
    for match in re.finditer(r"(?<![a-z])\d+", claimed) if entry["kind"] in ("degree", "count") else ():
        for by in (1, -1):
            new = f"{claimed[: match.start()]}{max(int(match[0]) + by, 0)}{claimed[match.end() :]}"
            if new != claimed:
                yield Change(key, kind, f"{claimed} → {new}", {"claimed": new})
    if entry["kind"] == "degree":
        for new, said in ((f"{claimed} + 1", "degree"), (f"{claimed} − 1", "degree")):
            yield Change(key, said, f"{claimed} → {new}", {"claimed": new})
        if signs := re.search(" [−-] ", claimed):
            new = f"{claimed[: signs.start()]} + {claimed[signs.end() :]}"
            yield Change(key, "sign", f"{claimed} → {new}", {"claimed": new})
        other = {"polynomial": "rational", "rational": "polynomial"}.get(str(entry.get("of", "")))
        if other:
            yield Change(key, "condition", f"{entry['of']} → {other}", {"of": other})
    if entry["kind"] == "type":
        for value in ValueType:
            if value != claimed:
                yield Change(key, "type", f"{claimed} → {value}", {"claimed": str(value)})
    for each in entry.get("assumes", ()):
        if each in CONVENTIONS:
            continue
        rest = [one for one in entry["assumes"] if one != each]
        yield Change(key, "condition", f"without {each}", {"assumes": rest})
    if entry["kind"] in ("condition", "same surface", "iso-curve", "identity") and "right" in entry:
        both = {"left": entry["right"], "right": entry["left"]}
        if entry["kind"] == "condition" or entry.get("factor", "1") != "1":
            yield Change(key, "sides exchanged", f"{entry['right']}, {entry['left']}", both)


def _of_factor(key: str, entry: dict[str, Any]) -> Iterator[Change]:
    """The sign of a factor, its exponents by one, one w more or less."""
    if entry["kind"] != "identity":
        return
    text = entry.get("factor", "1")
    parts = factor_parts(text)
    yield Change(key, "sign", f"factor {text} → -1 {text}", {"factor": f"-1 {text}"})
    for i, (name, exponent) in enumerate(parts):
        for by in (1, -1) if name[0].isalpha() else ():
            new = [*parts[:i], (name, exponent + by), *parts[i + 1 :]]
            changed_text = " ".join(f"{n}^{k}" for n, k in new if k) or "1"
            yield Change(key, "exponent", f"factor {text} → {changed_text}", {"factor": changed_text})
    if entry.get("of") != "polynomial" and entry.get("curve") != "table":
        for power in (1, -1):
            yield Change(key, "exponent", f"factor {text} → {text} w^{power}", {"factor": f"{text} w^{power}"})


def _of_names(key: str, entry: dict[str, Any]) -> Iterator[Change]:
    """A formula by that with the next index."""
    source = paper(PAPER)
    for side in NAMED:
        names = entry.get(side, ())
        for i, name in enumerate([names] if isinstance(names, str) else names):
            for match in re.finditer(r"\d+", name):
                for by in (1, -1):
                    other = f"{name[: match.start()]}{int(match[0]) + by}{name[match.end() :]}"
                    if other not in source.formulas or other in (entry.get("left"), entry.get("right")):
                        continue
                    new = other if isinstance(names, str) else [*names[:i], other, *names[i + 1 :]]
                    yield Change(key, "index", f"{side} {name} → {other}", {side: new})


def _of_formulas(key: str, entry: dict[str, Any]) -> Iterator[Change]:
    """One change in the body of a formula that it names."""
    for side in NAMED:
        for name in _listed(entry.get(side, ())):
            if formula := _formula(name):
                yield from _of_body(key, formula, f"{side} {name}")


def _of_called(key: str, entry: dict[str, Any]) -> Iterator[Change]:
    """One change in the body of a formula that one that it names calls, for that one alone."""
    for side in NAMED:
        for name in _listed(entry.get(side, ())):
            if formula := _formula(name):
                function: Any = formula.function
                for called in dict.fromkeys(function.__code__.co_names):
                    if isinstance(helper := function.__globals__.get(called), Formula):
                        yield from _of_body(key, helper, f"{side} {name}>{called}")


def _of_body(key: str, formula: Formula, side: str) -> Iterator[Change]:
    for number, (kind, says, new) in enumerate(_changes(formula)):
        if not isinstance(new, ast.Name) or _is_known(new.id, formula):
            yield Change(key, kind, f"{side.split(' ')[1]}: {says} (change {number})", {}, side, number)


@cache
def _changes(formula: Formula) -> list[tuple[str, str, ast.expr]]:
    """The changes in the body of a formula: the kind, both texts, and what is new."""
    function: Any = formula.function
    node = node_of(_file(function), function.__name__)
    return [
        ("derivative" if kind == "constant" and _is_order(node, old) else KIND.get(kind, kind), says, new)
        for old, (kind, says, new) in changes(node)
    ]


def _file(function: Any) -> str:
    """The file of a function of the library."""
    return f"{function.__module__.replace('.', '/')}.py"


def _is_known(name: str, formula: Formula) -> bool:
    """Whether a name has a meaning in the function of a formula."""
    function: Any = formula.function
    return name in function.__globals__ or name in function.__code__.co_varnames


def _is_order(node: ast.FunctionDef, old: ast.AST) -> bool:
    """Whether what is changed is the order of a derivative."""
    calls = [call for call in ast.walk(node) if isinstance(call, ast.Call)]
    return any(old in call.args and isinstance(call.func, ast.Attribute) and call.func.attr == "d" for call in calls)


def _formula(name: str) -> Formula | None:
    """The formula of the paper with that name, where it is a separate function in a file of the library."""
    try:
        found = paper(PAPER).find(name)
        node_of(_file(found.function), found.function.__name__)
    except (ExactSplineError, KeyError):
        return None
    return found


@cache
def drawn(seed: int = SEED, each: int = EACH) -> list[Change]:
    """Some changes of every printed statement, of as many kinds as there are: the same for the same seed."""
    found: list[Change] = []
    for key in entries():
        random = Random(f"{seed} {key}")
        by_kind: dict[str, list[Change]] = {}
        for change in {each.name: each for each in changes_of(key)}.values():
            by_kind.setdefault(change.kind, []).append(change)
        for pile in by_kind.values():
            random.shuffle(pile)
        kinds = sorted(by_kind)
        random.shuffle(kinds)
        chosen: list[Change] = []
        while len(chosen) < each and any(by_kind.values()):
            for kind in kinds:
                if by_kind[kind] and len(chosen) < each:
                    chosen.append(by_kind[kind].pop())
        found += chosen
    return found


# ---- judging


def changed_claim(change: Change) -> Claim:
    """The statement as changed, as a claim of ours; `ClaimError` for what the ledger refuses to read."""
    source, table = paper(PAPER), entries()[change.claim]
    entry = {name: value for name, value in table.entry.items() if name not in BESIDE}
    if change.side:
        side, path = change.side.split(" ")
        name, _, called = path.partition(">")
        entry[side] = _renamed(entry[side], name, _put_in(source, name, called, change.number))
    return _read(source, table.place, entry | change.fields)


def _read(source: Paper, place: str, entry: dict[str, Any]) -> Claim:
    """An entry as a claim that is recorded as refuted, so that no proof is required where a curve refutes it."""
    begin = re.sub(r"[ .]+", "", str(entry["id"]))
    changed_text = {"status": "ours", "expected": "REFUTED", "key": f"{begin}-{entry['kind']}".replace(" ", "-")}
    return claim_of(Table(place, entry | changed_text), source)


def _renamed(names: Any, name: str, other: str) -> Any:
    return other if isinstance(names, str) else [other if each == name else each for each in names]


def _put_in(source: Paper, name: str, called: str, number: int) -> str:
    """A changed copy of a formula (or one that calls a changed copy of another) among those of the paper, which nothing
    else calls; its name.
    """
    original = source.find(name)
    function: Any = original.function
    if called:
        helper = _copy(function.__globals__[called], number)
        made = _copy(original, instead={called: helper})
    else:
        made = _copy(original, number)
    source.formulas[made.name] = made
    return made.name


def _copy(original: Formula, number: int | None = None, instead: Mapping[str, Formula] | None = None) -> Formula:
    """A copy of a formula with a change, or with other formulas for some that it calls."""
    function: Any = original.function
    code = function.__code__
    if number is not None:
        code = Mutant(_file(function), function.__name__, "", 0, 0, "", number).code()
    known = {**function.__globals__, **(instead or {})}
    copy = FunctionType(code, known, f"{function.__name__}_changed", function.__defaults__, function.__closure__)
    copy.__kwdefaults__, copy.__module__ = function.__kwdefaults__, function.__module__
    return Formula(copy, original.source, original.kind, original.symbol)


def verdict(claim: Claim, curves: Iterable[str] = CURVES) -> Verdict:
    """REFUTED where one of some example curves refutes it, else what is shown for all curves."""
    for row in _on_curves(claim, curves):
        if row.verdict == Verdict.REFUTED:
            return Verdict.REFUTED
    return decide(claim).verdict


def _on_curves(claim: Claim, curves: Iterable[str]) -> Iterator[Row]:
    for task in tasks([claim], [example(name) for name in curves]) if claim.kind != "degree" else ():
        yield task()


def judge(change: Change) -> Result:
    """What becomes of a statement by a change."""
    before = next(claim for claim in claims_of(PAPER) if claim.key == change.claim)
    try:
        claim = changed_claim(change)
        # without a condition it must hold on every curve that there is, cusps and flat points included
        after = verdict(claim, example_names() if "assumes" in change.fields else CURVES)
    except (ClaimError, TypeError, AttributeError, IndexError) as error:  # a vector less a number
        return {"verdict": "refused", "by": str(error)[:120]}
    if after != before.expected:
        return {"verdict": "killed", "by": str(after)}
    if after == Verdict.REFUTED:
        return {"verdict": "false before", "by": str(after)}
    if change.side and _equal(*_both(change)):
        return {"verdict": "equivalent", "by": "equal in the jets and in naive degrees"}
    if change.side and (other := _refuting(change)):
        return {"verdict": "killed by another", "by": other}
    good = after in (Verdict.PROVED, Verdict.VERIFIED)
    return {"verdict": "true too" if good else "open", "by": str(after)}


def _both(change: Change) -> tuple[Formula, Formula]:
    source, name = paper(PAPER), _named(change)
    return source.find(name), source.find(f"{name}_changed")


def _named(change: Change) -> str:
    """The formula of the statement that was changed, or that calls what was."""
    return change.side.split(" ")[1].partition(">")[0]


def _equal(one: Formula, other: Formula) -> bool:
    """Whether two formulas are one rational function of the derivatives, with the same naive degrees."""
    for dimension in one.kind.dimensions:
        try:
            order = max(order_of(each, dimension) for each in (one, other))
            c = RationalJetReading(order).argument(one.kind, dimension)
            if [in_the_jets(part) for part in split(one(c))[0]] != [in_the_jets(part) for part in split(other(c))[0]]:
                return False
        except ExactSplineError:
            return False
        for polynomial in () if one.kind.adjoins_roots else (False, True):
            if degrees_counted(one, dimension, polynomial) != degrees_counted(other, dimension, polynomial):
                return False
    return True


def _refuting(change: Change) -> str:
    """The key of another claim that is refuted: one that names the formula, of its changed copy, or one of a formula
    that calls it, with the change in its place. Empty where there is none.
    """
    source, name = paper(PAPER), _named(change)
    for table in source.claim_tables():
        sides = [side for side in NAMED if name in _listed(table.entry.get(side, ()))]
        recorded = table.entry.get("expected", "PROVED")
        if not sides or recorded == "REFUTED" or table.entry["key"] == change.claim:
            continue
        entry = {field: value for field, value in table.entry.items() if field not in BESIDE}
        entry[sides[0]] = _renamed(entry[sides[0]], name, f"{name}_changed")
        try:
            if verdict(_read(source, table.place, entry)) == Verdict.REFUTED:
                return str(table.entry["key"])
        except ExactSplineError:
            continue
    function: Any = source.find(name).function
    if called := change.side.partition(">")[2]:
        function = function.__globals__[called].function
    place = function.__module__, function.__name__
    callers = sorted((claim for claim in speaking([place]) if claim.paper == PAPER), key=lambda each: each.key)
    Mutant(_file(function), place[1], "", 0, 0, "", change.number).apply()
    return next(filter(None, (refuted(claim, quick) for claim in callers)), "")


def _listed(names: Any) -> list[str]:
    return [names] if isinstance(names, str) else list(names)


# ---- the record


def recorded() -> dict[str, dict[str, Any]]:
    """The record, by the names of changes."""
    if not RECORD.is_file():
        return {}
    lines = RECORD.read_text(encoding="utf-8").splitlines()
    return {line["change"]: line for line in map(json.loads, lines)}


def table(found: dict[str, dict[str, Any]]) -> str:
    """Kinds of changes against what became of them, as Markdown."""
    kinds: dict[str, Counter[str]] = {}
    for line in found.values():
        kinds.setdefault(line["kind"], Counter())[line["verdict"]] += 1
    rows = [f"| change of | all | {' | '.join(VERDICTS)} |", "|---" * (len(VERDICTS) + 2) + "|"]
    total = Counter[str]()
    for kind, row in sorted(kinds.items()):
        total += row
        rows.append(f"| {kind} | {row.total()} | {' | '.join(str(row[name]) for name in VERDICTS)} |")
    rows.append(f"| **all** | {total.total()} | {' | '.join(str(total[name]) for name in VERDICTS)} |")
    return "\n".join(rows) + "\n"


def main() -> int:
    """Judge what is drawn and not yet in the record, and print the table."""
    parser = argparse.ArgumentParser(
        prog="python -m workshop.mutation.statements",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--minutes", type=float, default=30, help="stop after this many minutes; the next run goes on")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--claim", default="", help="only statements whose keys begin so; nothing is recorded")
    parser.add_argument("--anew", action="store_true", help="judge everything anew")
    parser.add_argument("--record", action="store_true", help="write the table to docs/mutation.md")
    options = parser.parse_args()
    known = {} if options.anew else recorded()
    chosen = [change for change in drawn() if change.claim.startswith(options.claim)]
    found = {change.name: known[change.name] for change in chosen if change.name in known and not options.claim}
    end = monotonic() + 60 * options.minutes
    for change, result in forked([c for c in chosen if c.name not in found], judge, SECONDS, options.jobs):
        found[change.name] = {"change": change.name, "kind": change.kind, **result}
        del found[change.name]["seconds"]
        if options.claim:
            print(json.dumps(found[change.name], ensure_ascii=False), flush=True)
        if monotonic() > end:
            break
    ordered = {change.name: found[change.name] for change in chosen if change.name in found}
    if not options.claim:
        lines = [json.dumps(line, ensure_ascii=False) + "\n" for line in ordered.values()]
        RECORD.write_text("".join(lines), encoding="utf-8")
    if options.record:
        text = PAGE.read_text(encoding="utf-8")
        head, tail = text.split(BEGIN)[0], text.split(END)[1]
        PAGE.write_text(f"{head}{BEGIN}{table(ordered)}{END}{tail}", encoding="utf-8")
    print(f"{len(ordered)} of {len(chosen)} changes judged\n{table(ordered)}")
    return int(any(line["verdict"] in ("open", "timeout", "broken") for line in ordered.values()))


if __name__ == "__main__":
    sys.exit(main())
