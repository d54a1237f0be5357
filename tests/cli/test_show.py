"""``show``: a claim spelled out, for people, for LaTeX, for programs."""

import json
import re

import pytest
from click.testing import CliRunner

from exactspline import Verdict, example
from exactspline.cli import app
from exactspline.display.latex_prose import in_mathematics, prose
from exactspline.display.theorem import theorem
from exactspline.papers import papers
from exactspline.tables import statements
from exactspline.verification.claims import claims_in, select
from exactspline.verification.evidence import Fact
from exactspline.verification.statement import Statement, definitions, sides
from exactspline.verification.verdict import Finding

runner = CliRunner()


def show(*arguments):
    result = runner.invoke(app, ["show", *arguments])
    assert result.exit_code == 0, result.output
    return result.output


def test_a_claim_has_its_sides_factor_degrees_verdict_and_source():
    output = show("C4.1a")
    for part in ("f1 = w f2", "[D1 D2]", "naive", "reduced", "3d − 3", "PROVED", "eq. (8)", "factor"):
        assert part in output


def test_of_many_claims_the_first_is_spelled_out_and_the_others_are_named():
    """`show C5.4a` printed thirteen claims one after the other."""
    claims = select(["C5.4a"])
    told = show("C5.4a")
    assert told.count("statement: ") == 1
    assert all(f"{claim.key} {claim.expected}: " in told for claim in claims[1:])


def test_latex_is_not_broken_into_lines():
    lines = show("C4.2c", "--latex").splitlines()
    assert r"\[ g_2 = w\,g_1 \]" in lines
    assert any(len(line) > 120 and line.count("{") == line.count("}") for line in lines)


def test_a_claim_is_a_theorem_with_its_proof():
    told = show("C42b-g1-g0-both", "--latex")
    assert told.count(r"\begin{theorem}") == told.count(r"\end{proof}") == 1
    for part in (
        "% PROVED",
        "corrected",
        r"g_1 = w^{8}\,g_0",
        r"Found: $g_{1} = w^{8} \cdot g_{0}$",
        "--judge sympy",
        "evaluation mode",
    ):
        assert part in told
    assert r"\gamma '$ has no zero" in told


def test_what_is_refuted_is_a_theorem_that_it_fails():
    told = show("C42b-g1-g0", "--latex").split(r"\end{proof}")[0]
    assert r"It is \emph{not} true that $g_{1} = w^{4}\,g_{0}$" in told
    assert r"Instead: $g_{1} = w^{8}\,g_{0}$ (C42b-g1-g0-both)" in told
    assert "multiplied out" not in told


def can_be_set(told):
    """Whether braces and dollars are balanced, and no sign is left that LaTeX does not know."""
    stripped = re.sub(r"\\[\\{}$%&#_]", "", told)
    assert stripped.count("{") == stripped.count("}"), told
    assert stripped.count("$") % 2 == 0, told
    assert all(letter.isalpha() for letter in set(told) if not letter.isascii()), told
    assert not re.search("[\u0370-\u03ff]", told), told
    return True


def test_every_text_of_every_claim_is_latex_that_can_be_set():
    for claim in claims_in(papers()):
        assert can_be_set(prose("; ".join((claim.statement, claim.assumed, claim.note, claim.source, claim.claims))))
        assert can_be_set(in_mathematics(claim.latex))


@pytest.mark.parametrize("verdict", [Verdict.PROVED, Verdict.VERIFIED, Verdict.REFUTED, Verdict.UNDECIDED])
def test_a_theorem_of_any_verdict_can_be_set(verdict):
    for claim in claims_in(papers())[::40]:
        finding = Finding(verdict, witness=Fact.NOWHERE if verdict == Verdict.REFUTED else None)
        told = theorem(Statement(claim, claim.latex, sides(claim), definitions(claim, finding), claim.reading, finding))
        assert can_be_set(told)
        assert ("conjecture" in told) == (verdict == Verdict.UNDECIDED)


def test_a_theorem_is_complete_in_itself():
    """Letters were not defined, the two sides of C4.3a were both E, and a counterexample was a name only."""
    (evolute, *_), (printed, *_) = (list(statements(wanted)) for wanted in ("C4.3a", "C6.2g"))
    assert {each.text for each in evolute.defined} >= {"D1 = p′ w − p w′", "f0 = [γ′ γ″]", "f1 = [D1 D2]"}
    assert r"\mathrm{evolute} = \mathrm{evolute\_reduced}" in theorem(evolute)
    assert "D_1 = p'" in theorem(evolute)
    curve = example("ellipse_in_space")
    assert f"Knots: ${', '.join(map(str, curve.knots))}$" in theorem(printed)
    assert r"\usepackage{amsmath" in show("C4.1a", "--latex")


def test_every_letter_of_a_formula_is_defined_with_it():
    (_, _, along_tangent, *_) = statements("C5.4a")
    assert [each.text for each in along_tangent.defined] == ["B = γ′ × γ″", "D1 = p′ w − p w′", "γ′ = D1/w²"]
    assert str(along_tangent.finding.factor) == "w⁻⁴·‖D1‖²"
    assert "where: B = γ′ × γ″" in show(along_tangent.claim.key)


def test_a_unit_vector_is_not_called_by_the_letter_of_another_one():
    """The unit binormal was called B next to B = γ′ × γ″, and the factor in D1 was not led back to γ′."""
    told = show("C54a-rectifying_along_binormal-binormal_squared", "--latex")
    assert r"along the unit binormal $\mathbf{B} = B/\|B\|$, that is" in told
    assert r"\gamma' = \frac{D_1}{w^{2}}" in told
    for claim in claims_in(papers()):
        assert not re.search(r"unit (binormal|tangent|normal) [BTN]\b", claim.statement), claim.key


@pytest.mark.parametrize(
    ("text", "latex"),
    [
        ("τ𝐓 + κ𝐁, with a curve", r"$\tau \mathbf{T} + \kappa \mathbf{B}$, with a curve"),
        ("generator·γ′ = ‖γ′‖² τ (of s)", r"$\mathrm{generator}\cdot \gamma ' = \|\gamma '\|^{2}\,\tau$ (of $s$)"),
        ("at d = 3: 6, not 7; §5.4, eq. (8), C5.4a", r"at $d = 3$: 6, not 7; \S{}5.4, eq. (8), C5.4a"),
        ("(γ, a curve) of degree 2d − 1.", r"($\gamma$, a curve) of degree $2d - 1$."),
        ("½(p² − wQ²) − a × b", r"$\tfrac{1}{2}(p^{2} - wQ^{2}) - a \times b$"),
    ],
)
def test_a_formula_in_a_text_is_one_formula(text, latex):
    """Each sign stood between dollars of its own."""
    assert prose(text) == latex


def test_what_others_write_cannot_be_a_command():
    assert prose(r"\input{secret} $x$ 100 % a_b & ~ #1 ^") == (
        r"\textbackslash{}input\{secret\} \$x\$ 100 \% a\_b \& \textasciitilde{} \#1 \^{}"
    )


@pytest.mark.parametrize("wanted", ["C4.2", "Fig. 2", "T17", "C6.2f"])
def test_programs_get_every_statement_with_both_sides(wanted):
    found = json.loads(show(wanted, "--json"))["rows"]
    claims = select([wanted])
    assert [s["statement"] for s in found] == [claim.statement for claim in claims]
    for s, claim in zip(found, claims, strict=True):
        assert {side["name"] for side in s["sides"]} == set(claim.named)
        assert s["verdict"] == s["expected"]
        assert s["latex"]


def test_a_witness_in_two_parameters_is_written():
    """A TypeError before: a formula of two curves has no value at one parameter."""
    asked = ["show", "PZ7d-off_the_printed_sphere", "--paper", "petrunin_zamora_barrera", "--latex"]
    done = CliRunner().invoke(app, asked)
    assert (done.exit_code, "Witness: on the example curve" in done.output) == (0, True)
