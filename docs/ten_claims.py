"""Write ``docs/ten-claims.md``: ten claims in print, in Python and in Coq, with their verdicts.

``python -m docs.ten_claims`` also runs Coq and needs its ``coqc``. A test compares the page with the expected verdicts.
"""

from __future__ import annotations

import inspect
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path

from exactspline import example
from exactspline.display.evidence import opinion
from exactspline.display.latex import latex
from exactspline.extras.coq import judge as coq_judge
from exactspline.extras.coq.emission import Stated, library
from exactspline.extras.coq.formulas import Formulas
from exactspline.language.formula import Formula
from exactspline.papers import papers
from exactspline.verification.claim import Claim
from exactspline.verification.claims import claims_of
from exactspline.verification.ledger import decide, tasks
from exactspline.verification.vocabulary import Verdict

PAGE = Path(__file__).parent / "ten-claims.md"
#: The claims, by paper and key.
CLAIMS = {
    "chen_riesenfeld_cohen_2007": (
        "C41a-f0-f2",
        "C42b-g1-g0",
        "C42a-signed_curvature_derivative-g0",
        "E12-evolute_contact_1",
        "E13-unit_normal_derivative-turn_of_normal",
        "E19-focal_contact_1",
        "C54a-rectifying_developable-rectifying_developable_reduced",
        "E22-bisector_equidistance",
    ),
    "petrunin_zamora_barrera": ("PZ3d-spherical_identity-off_the_unit_sphere",),
    "surfaces": ("S3-parabolic-brioschi",),
}
#: The claim whose formulas are shown as definitions of Coq, too.
FIRST = "C41a-f0-f2"
#: The example curves on which claims about curves are checked.
CURVES = ("cubic_s", "twisted_cubic", "rational_cubic", "rational_space_cubic")
INTRODUCTION = """# Ten claims, side by side

Each section shows a claim, its formulas as Python functions (*naive*: by the definition, without cancellation), and the
claim, or its refutation, as a theorem of Coq. Three verdicts follow: the verdict for all curves, the verdicts on
example curves (“–” where the claim has none), and the verdict of Coq, whose kernel accepts the theorem without axioms.
For the first claim, Coq's definitions of the functions are also shown; `./run coq DIR` writes all definitions, with the
operations of [`Base.v`](../exactspline/extras/coq/theory/Base.v). [The trusted
base](what-is-trusted.md) lists what the verdicts rely on.

<!-- written by python -m docs.ten_claims -->
"""


def chosen() -> list[Claim]:
    """Return the ten claims."""
    return [claim for paper, keys in CLAIMS.items() for key in keys for claim in claims_of(paper) if claim.key == key]


def expected(claim: Claim) -> str:
    """Return the verdict that is expected of Coq."""
    return f"{'fails' if claim.expected == Verdict.REFUTED else 'holds'}, no axioms"


def page(kernel: Mapping[str, str]) -> str:
    """Return the text of the page, given Coq's verdict on each claim by its key."""
    stated = {each.claim.key: each for own in library().theorems.values() for each in own}
    parts = [_section(claim, stated[claim.key], kernel[claim.key]) for claim in chosen()]
    return "\n".join([INTRODUCTION, *parts])


def _section(claim: Claim, theorem: Stated, kernel: str) -> str:
    formulas = Formulas(papers())
    named = list(dict.fromkeys(claim.find(name) for name in claim.named))
    lines = [f"## {claim.id}: {claim.statement}\n", f"{claim.source_paper.title}, {claim.place or claim.source}."]
    lines += [f"In print: `` {' '.join(claim.words.split())} ``\n" if claim.words else ""]
    lines += [f"{latex(formula)}\n" for formula in named]
    lines += ["```python", "\n\n\n".join(_python(formula) for formula in named), "```\n"]
    definitions = [_definition(formula, formulas) for formula in named if claim.key == FIRST]
    statement = theorem.text[: theorem.text.index("Proof.")].strip()
    lines += ["```coq", "\n".join([*definitions, statement]), "```\n"]
    lines += ["| for all curves | on example curves | Coq |", "|---|---|---|"]
    lines.append(f"| {decide(claim).verdict} | {', '.join(_on_curves(claim)) or '–'} | {kernel} |\n")
    return "\n".join(lines)


def _python(formula: Formula) -> str:
    return inspect.getsource(formula.function).strip()


def _definition(formula: Formula, formulas: Formulas) -> str:
    return formulas.definition(formula, formulas.owner[formula]).strip().split("\n", 1)[1] + "\n"


def _on_curves(claim: Claim) -> Iterator[str]:
    """Yield the verdicts on the example curves to which the claim applies."""
    for name in CURVES:
        for task in tasks([claim], [example(name)]):
            yield f"{task().verdict} on `{name}`"


def main() -> int:
    """Write the page; the exit code is 1 if a verdict of Coq differs from the expected verdict."""
    claims = chosen()
    found = {key: opinion(each) for (_, key), each in coq_judge.findings(claims).items()}
    PAGE.write_text(page(found), encoding="utf-8")
    return int(any(found[claim.key] != expected(claim) for claim in claims))


if __name__ == "__main__":
    sys.exit(main())
