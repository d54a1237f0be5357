"""Formulas in one line: the language of formulas, read by its checker."""

import pytest

import exactspline as xs
from exactspline.errors import ExactSplineError
from exactspline.papers import find
from exactspline.verification.one_line import formula_of_line
from tests.support.command import invoke
from tests.verification.test_own_paper import plane_formulas, written

TRUE = [
    "2*f1 = f1 + f1",
    "det(γ', γ'') = w^-3 * f2",
    "det(γ′, γ″) = w^-3 f2".replace("″", "′′"),
    "f1 = w · f2",
    "f1/2/3 = w*f2/6",
    "0.5*f1 = w*f2/2",
    "f1 - f1/2 = f1/2",
    "-f1 = f1 − 2 f1",
    "(f1 + f2) (f1 - f2) = f1^2 - f2**2",
    "w^-1 f1 = f2",
    "norm2(γ') = dot(γ', γ')",
    "γ[0]' = γ'[0]",
    "norm2(cross(γ', γ'')) = norm2(γ')*norm2(γ'') - dot(γ', γ'')^2",
    "triple(γ', γ'', γ''') = dot(cross(γ', γ''), γ''')",
    "(w f2)' = w' f2 + w f2'",
    "p = w γ",
]
FALSE = [
    "2*f1 = f1 + f2",
    "det(γ', γ'') = f2",
    "det(γ', γ'') = -w^-3 * f2",
    "f1/2/3 = 3 w*f2/2",
    "f1/2*3 = f1/6",
    "f1 - f1/2 - f1/4 = f1/2",
    "-f1^2 = f1^2",
    "2 f1^2 = (2 f1)^2",
    "w^-2 f1 = f2",
    "norm2(γ') = dot(γ', γ'')",
    "γ[0] = γ[1]",
    "γ'' = γ'",
    "0.3 f1 = 0.30000000000000001 f1",
]
REFUSED = {
    "f1": "states no identity",
    "f1 = f2 = f1": "states no identity",
    "f1 = f1 if f1 else f2": "there is no formula called 'if'",
    "f1 = __import__": "there is no formula called '__import__'",
    "f1 = open('x')": "there is no formula called 'open'",
    "f1 = w.d(1)": "there is no formula called 'd'",
    "f1 = f1[0:1]": "the index of a component",
    "f1 = (f1": "states no formula",
    "f1 = f1)": "states no formula",
    "f1 = *f1": "states no formula",
    "f1 = f1 **": "states no formula",
    "f1 = 3": "is a number; write it with an operand: 3 + 0 * w",
    "f1 = f1 / 0": "",
    "f1 = w^65": "exponent",
    "f1 = f1^^2": "states no formula",
    "f1 = γ'" + "'" * 99: "order of a derivative",
    "f1 = det(γ', γ'', γ''', γ'''')": "",
    "det(γ, γ') = triple(γ, γ', γ'')": "are not both defined",
    "f1 = " + "(" * 9999: "a line of 9999 characters",
    "f1 = " + "(" * 900 + "f1": "states no formula",
    "f1 = " + "f1 + " * 50_000 + "f1": "a line of 250002 characters",
    "f1 = " + "f1 + " * 399 + "f1": "",
    "f1 = nothing_known": "'nothing_known'",
    "f1 = none.py:f": "no such file",
}


@pytest.mark.parametrize("text", TRUE)
def test_what_is_true_is_proved(text):
    assert xs.prove(text), text
    assert str(xs.prove(text)).startswith(" = ".join(part.strip() for part in text.split("=")))


@pytest.mark.parametrize("text", FALSE)
def test_what_is_false_is_refuted(text):
    assert xs.prove(text).verdict == "REFUTED"


@pytest.mark.parametrize("text", REFUSED, ids=lambda text: text[:30])
def test_what_is_no_formula_is_refused(text):
    with pytest.raises(ExactSplineError) as caught:
        xs.prove(text)
    assert REFUSED[text] in str(caught.value)


def test_the_remedy_for_a_number_works():
    assert xs.prove("f1 - f1 = 3 + 0 * w").verdict == "REFUTED"
    assert xs.prove("f1 - f1 = 0 + 0 * w").verdict == "VACUOUS"


def test_a_dimension_is_that_of_the_question():
    assert xs.prove("norm2(γ') = dot(γ', γ')", dimension=3).dimensions == (3,)
    assert xs.prove("norm2(γ') = dot(γ', γ')").dimensions == (2, 3)
    with pytest.raises(ExactSplineError, match="not both defined in R3"):
        xs.prove("det(γ', γ'') = w^-3 f2", dimension=3)


def test_names_of_a_file_stand_for_its_formulas(tmp_path):
    """Names on both sides are looked up where the left side says, and then in the library."""
    formulas = plane_formulas(f2="c.w", own="c.w * det(c.p, c.p.d(1))")
    file = written(tmp_path / "own-paper", formulas, []) / "formulas.py"
    assert xs.prove(f"{file}:own + f2 = f2 + own")
    assert xs.prove(f"{file}:f2 = w")
    assert not xs.prove("f2 = w")
    assert xs.prove(f"{file}:own * f1 = w det(p, p') f1")
    assert invoke("identity", f"{file}:own = 2 * {file}:own").exit_code == 1
    assert invoke("identity", f"{file.parent}:own = f2 * det(p, p')").exit_code == 0


def test_a_name_alone_is_the_formula():
    assert formula_of_line(" f1 ", find) is find("f1")
    made = formula_of_line("2 f1", find)
    assert (made.name, made.kind.name, made.checked) == ("2 f1", "plane", True)
