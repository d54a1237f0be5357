"""Formulas in one line: the language of formulas, read by its checker."""

import json

import pytest

import exactspline as xs
from exactspline import ExactSplineError
from exactspline.errors import FormulaError
from tests.support.command import invoke
from tests.verification.test_own_paper import plane_formulas, written

TRUE = [
    "2*f1 = f1 + f1",
    "det(γ', γ'') = w^-3 * f2",
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
    "det(γ′, γ″) = w^-3 f2",
    "norm2(γ‴)' = 2dot(γ''', γ'''')",
    "2f1 = f1 + f1",
    "2(f1 + f2) = 2f1 + 2.0f2",
    "f1² = w² f2^2",
    "1/2 * w = w / 2",
    "(1/2) w = w / 2",
    "f1 / 2 + w f2 = 1.5f1",
    "f2 / 3 * w f1 = f1^2 / 3",
    "w^-1 w f1 = f1",
    "det(γ', γ') + w = 0 + w",
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
    "f1 = w.d(1)": "write a prime for each derivative",
    "f1 = f1[0:1]": "the index of a component",
    "f1 = (f1": "states no formula",
    "f1 = f1)": "states no formula",
    "f1 = *f1": "states no formula",
    "f1 = f1 **": "states no formula",
    "f1 = 3": "is a number; for f = 3 write f + w = 3 + w",
    "1 / w f2 = f2 / w": "an unclear divisor in '1 / w f2'; write 1 / w * f2, or",
    "det(γ', γ'') = f2 / w w w": "write f2 / w * w * w, or",
    "w = f1 + (1 - f1) / (w w) f2": "an unclear divisor in",
    "f1 = 2w/3w": "an unclear divisor in",
    "w @ w = w^2": "states no formula",
    "ruled(γ, γ') = ruled(γ, γ')": 'a ruled surface in an identity; write a claim of the kind "same surface"',
    "ruled(γ, γ') = w": "a ruled surface in an identity",
    "w = ruled(γ, γ')": "a ruled surface in an identity",
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
    assert xs.prove("f1 - f1 + w = 3 + w").verdict == "REFUTED"
    assert xs.prove("f1 - f1 + w = 0 + w").verdict == "PROVED"
    assert xs.prove("f1 - f1 = 0 + 0 * w").verdict == "VACUOUS"


@pytest.mark.parametrize("factor", ["5", "w^-3 f2", 5])
def test_a_factor_beside_one_line_is_refused(factor):
    """Passed before: f1 = w*f2 with the factor 5, which was dropped."""
    with pytest.raises(ExactSplineError, match="a factor beside a line") as caught:
        xs.prove("f1 = w*f2", factor=factor)
    assert xs.prove(caught.value.remedy.removeprefix("write ")).verdict == "REFUTED"


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


@pytest.mark.parametrize("text", ["f1 = f1", "2 f1 = f1 + f1"])
def test_a_text_is_told_as_it_was_given_with_the_space_of_its_formulas(text):
    assert invoke("identity", f" {text} ").output == f"{text} for all curves in R2\n"


KINDS = """
from exactspline.language import formula, norm2
@formula("e", on="plane")
def flat(c):
    return norm2(c.gamma.d(1))
@formula("e", on="space")
def spatial(c):
    return norm2(c.gamma.d(1))
@formula("e", on="space with r")
def radius(c):
    return c.r
@formula("e", on="curve with r")
def any_radius(c):
    return c.r
@formula("e", on="framed plane")
def speed(c):
    return c.sigma
@formula("e", on="framed")
def any_speed(c):
    return c.sigma
@formula("e", on="plane")
def w(c):
    return c.gamma[0]
@formula("e", on="plane")
def abscissa(c):
    return c.gamma[0]
"""


@pytest.fixture
def kinds(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "k.py").write_text(KINDS, encoding="utf-8")


@pytest.mark.usefixtures("kinds")
@pytest.mark.parametrize(
    ("text", "dimensions"),
    [
        ("1*k.py:flat = γ'[0]^2 + γ'[1]^2", (2,)),
        ("k.py:flat = γ'[0]^2 + γ'[1]^2", (2,)),
        ("1*k.py:spatial = norm2(γ')", (3,)),
        ("k.py:any_radius + k.py:flat = k.py:flat + k.py:any_radius", (2,)),
        ("k.py:any_radius - k.py:radius + norm2(γ') = k.py:spatial", (3,)),
        ("1*k.py:any_radius = k.py:any_radius", (2, 3)),
        ("k.py:speed^2 = norm2(γ')", (2,)),
        ("norm2(γ') = k.py:any_speed^2", (2, 3)),
        ("k.py:any_speed^2 * det(γ', γ'') = norm2(γ') det(γ', γ'')", (2,)),
    ],
)
def test_a_line_holds_for_arguments_of_all_its_formulas(text, dimensions):
    """Refuted before, or said of curves in R2 and R3: a formula of plane curves in an expression was one of any; σ was
    compared with ‖γ′‖ for too few derivatives.
    """
    found = xs.prove(text)
    assert (found.verdict, found.dimensions) == ("PROVED", dimensions)


@pytest.mark.usefixtures("kinds")
@pytest.mark.parametrize(
    "text",
    [
        "1*k.py:spatial = 1*k.py:flat",
        "f1 + k.py:spatial = k.py:spatial + f1",
        "k.py:flat + k.py:radius = k.py:radius + k.py:flat",
        "k.py:speed + k.py:spatial = k.py:spatial + k.py:speed",
    ],
)
def test_formulas_of_two_kinds_are_refused(text):
    """Passed before: an identity between formulas of the plane and of space, "for all curves in R2 and R3"."""
    with pytest.raises(ExactSplineError, match=r"formulas of the kinds|formulas of one kind of"):
        xs.prove(text)


@pytest.mark.usefixtures("kinds")
def test_places_are_printed():
    """Printed before: "not abscissa = p", and "abscissa = w for all curves" of the formula w, without the place."""
    assert str(xs.prove("k.py:abscissa = f1")).startswith("not k.py:abscissa = f1 in R2: ")
    assert str(xs.prove("k.py:abscissa = k.py:w")) == "k.py:abscissa = k.py:w for all curves in R2"
    assert str(xs.prove("w = w")) == "w = w for all curves in R2 and R3"


@pytest.mark.usefixtures("kinds")
@pytest.mark.parametrize("text", ["k.py:abscissa = w", "w = k.py:abscissa", "2 k.py:flat = w^2 norm2(γ') + w"])
def test_an_operand_that_a_formula_of_the_file_is_called_like_is_refused(text):
    """Passed before: w was the denominator, where the file has a formula called w, and the answer was REFUTED."""
    with pytest.raises(FormulaError, match=r"'w' is a word of the language, and a formula of k\.py; write k\.py:w"):
        xs.prove(text)


def test_a_function_that_a_formula_of_the_file_is_called_like_is_refused(tmp_path):
    file = tmp_path / "b.py"
    file.write_text("from exactspline.language import norm2\ndef det(c): return norm2(c.p)\ndef f(c): return c.w\n")
    with pytest.raises(FormulaError, match="'det' is a word of the language"):
        xs.prove(f"{file}:f = det(p, p')")
    assert xs.prove(f"{file}:f = w")
    assert invoke("identity", f"{file}:f = w + 0 norm2(p)", "--trust").exit_code == 0  # what it imports is no formula


def test_no_traceback_of_ruled_surfaces():
    assert isinstance(invoke("identity", "ruled(γ, γ') = ruled(γ, γ')").exception, ExactSplineError)


def test_a_false_identity_has_its_counterexample_through_every_door():
    """Before, only the text of the command line named the curve."""
    said = str(xs.prove("f1 = f2").counterexample)
    assert "rational_cubic" in said
    [row] = json.loads(invoke("identity", "f1 = f2", "--json").output)["rows"]
    assert row["counterexample"] == said
    assert xs.prove("f1", "f2").counterexample == xs.prove("f1 = f2").counterexample
    assert xs.prove("f1", "f2", "w").counterexample is None
