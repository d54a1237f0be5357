"""What a constant is called decides nothing; which operand it is does."""

from string import ascii_letters

import pytest

from exactspline.errors import ExactSplineError, FormulaError
from exactspline.language.kinds import FRAMED_PLANE, HODOGRAPH, IMPLICIT, RESERVED, common_kind, kind_of
from exactspline.papers import load_paper
from exactspline.readings.sympy_expression import SympyReading
from exactspline.verification.claims import claims_of
from exactspline.verification.questions import degree, proof_of, prove
from tests.campaigns import false_claims
from tests.verification.test_own_paper import written

LETTERS = sorted({*ascii_letters} - RESERVED)
KINDS = ("plane", "space", "curve", "plane point", "point")
FORMULAS = """
@formula('e', on='{kind} with {letter}')
def plain_{letter}(c):
    return c.{letter} * c.w

@formula('e', on='{kind} with {letter}')
def over_{letter}(c):
    return c.p[0] / c.{letter}
"""
PLACE = "@formula('e', on='{kind}')\ndef place(c):\n    return c.{first} * c.w\n"


@pytest.mark.parametrize("kind", KINDS)
def test_the_letter_of_a_constant_decides_nothing(kind, tmp_path):
    """ "The constant a is the first coordinate of the point" was proved of a curve and a point, "x/a is a polynomial"
    was proved and "x/δ is a polynomial" refuted; for a, b, c, e, f, g and h.
    """
    letters, first = ["delta", *LETTERS], "point[0]" if "point" in kind else "p[0]"
    text = PLACE.format(kind=kind, first=first)
    claims = []
    for i, letter in enumerate(letters):
        text += FORMULAS.format(kind=kind, letter=letter)
        own = {"curve": f"{kind} with {letter}", "id": str(i)}
        claims.append({"kind": "identity", "left": f"plain_{letter}", "right": "place"} | own)
        claims.append({"kind": "type", "formula": f"over_{letter}", "claimed": "polynomial"} | own)
    folder = written(tmp_path / "letters", text, claims, "[common]\nstatus = 'ours'\nplace = 'e'\nstatement = 's'\n")
    paper = load_paper(folder)
    verdicts = [str(each.prove()[1].verdict) for each in claims_of(paper)]
    assert verdicts == ["REFUTED", "PROVED"] * len(letters)
    n, told = kind_of(kind).dimensions[0], set()
    sympy = SympyReading()
    for letter in letters:
        plain, over = (paper.find(f"{name}_{letter}") for name in ("plain", "over"))
        found = prove(plain, paper.find("place"))
        shown = "δ" if letter == "delta" else letter
        quotient = frozenset("own" if each == shown else each for each in str(found.quotient).split("·"))
        told.add((found.verdict, found.dimensions, quotient, str(degree(over, dimension=n).lowest)))
        c = sympy.argument(common_kind([plain.kind, paper.find("place").kind]), n)
        assert plain(c) != paper.find("place")(c)
    assert len(told) == 1


@pytest.mark.parametrize("kind", KINDS)
def test_a_factor_names_a_constant_whatever_its_letter(kind, tmp_path):
    """Refused before: a factor named formulas alone. The point's coordinate is not the constant a, x is none."""
    letters, first = ["delta", *LETTERS], "point[0]" if "point" in kind else "p[0]"
    text = PLACE.format(kind=kind, first=first) + f"@formula('e', on='{kind}')\ndef weight(c):\n    return c.w\n"
    claims = []
    for i, letter in enumerate(letters):
        text += FORMULAS.format(kind=kind, letter=letter)
        own = {"kind": "identity", "curve": f"{kind} with {letter}", "id": str(i), "right": "weight"}
        claims.append(own | {"left": f"plain_{letter}", "factor": letter})
        claims.append(own | {"left": "place", "factor": letter, "key": f"{i}-place"})
        claims.append(own | {"left": f"plain_{letter}", "factor": f"{letter}^2", "key": f"{i}-2"})
        claims.append(own | {"left": f"plain_{letter}", "factor": "x", "key": f"{i}-x"})
    folder = written(tmp_path / "factors", text, claims, "[common]\nstatus = 'ours'\nplace = 'e'\nstatement = 's'\n")
    verdicts = [str(each.prove()[1].verdict) for each in claims_of(load_paper(folder))]
    assert verdicts == ["PROVED", "REFUTED", "REFUTED", "NOT ASKED"] * len(letters)


@pytest.mark.parametrize("body", ["c.p[0]", "0.5 * c.p[0]"])
def test_a_factor_that_means_a_constant_or_a_formula_is_refused(body, tmp_path):
    """Also where the formula of this name is itself refused."""
    text = PLACE.format(kind="plane", first="p[0]") + FORMULAS.format(kind="plane", letter="r")
    text += f"@formula('e', on='plane')\ndef r(c):\n    return {body}\n"
    claim = {"id": "1", "kind": "identity", "statement": "s", "curve": "plane with r", "left": "plain_r"}
    folder = written(tmp_path / "p", text, [claim | {"right": "place", "factor": "r"}])
    (one, *_) = claims_of(load_paper(folder, partly=True))
    assert one.prove()[1].verdict == "NOT ASKED"
    assert "a factor could mean either" in one.why or "the float 0.5" in one.why


def test_a_constant_is_not_the_operand_of_another_kind_that_has_its_name():
    """One kind was given for both, the function h of a hodograph for the constant h."""
    for kind, name in ((HODOGRAPH, "h"), (FRAMED_PLANE, "sigma"), (IMPLICIT, "pace")):
        with pytest.raises(FormulaError, match="formulas of the kinds"):
            common_kind([kind, kind_of(f"plane with {name}")])


def test_constants_that_are_written_alike_are_two_in_sympy_too():
    """Both alpha_1 and alpha1 are written α₁, and were one symbol for the second judge."""
    c = SympyReading().argument(kind_of("plane with alpha_1, alpha1"), 2)
    assert c.alpha_1 != c.alpha1


TWO = "@formula('e', on='plane')\ndef {}(c):\n    return {}\n"


def test_an_identity_is_read_by_the_parser_of_factors(tmp_path):
    """``twice = w**2 * once`` was read as w · 2 · once, and proved; a formula in the factor was the library's f2 where
    the file has its own.
    """
    text = TWO.format("once", "c.p[0]") + TWO.format("twice", "2 * c.w * c.p[0]") + TWO.format("f2", "c.w")
    text += TWO.format("square", "c.w * c.w * c.p[0]")
    file = written(tmp_path / "own", text, [], "") / "formulas.py"
    assert not proof_of(f"{file}:twice = w**2 * once")
    assert proof_of(f"{file}:twice = 2·w  once")
    for power in ("w**2 *", "w ** 2", "w^2 ·", "w * w *", "f2^2", "f2 * w *"):
        assert proof_of(f"{file}:square = {power} once"), power
    assert proof_of(f"{file}:square = w ^ 2 once")
    assert not proof_of(f"{file}:square = w / once")
    assert not proof_of(f"{file}:square = w + once")
    for right in ("w * * once", "* once", "once *", "w***2 * once", "w^2^1 once"):
        with pytest.raises(ExactSplineError):
            proof_of(f"{file}:square = {right}")


def test_no_door_proves_what_is_false_of_constants():
    """A sample of the campaign. Passed before: c.a w = Q₁ w, of a curve and its point."""
    tally, wrong = false_claims.campaign(20, 2)
    assert wrong == []
    assert {door for door, _ in tally} >= {"prove", "sympy", "prove --curve", "identity", "of typed functions"}
