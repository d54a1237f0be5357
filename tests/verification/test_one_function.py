"""Functions typed at the prompt or run unchecked: what is no function of a curve proves nothing."""

import random
from itertools import count

import pytest

import exactspline as xs
from exactspline import Verdict, decide, degree, formula_of
from exactspline.errors import FormulaError, ReachError
from exactspline.language import Vector, formula
from exactspline.papers import papers
from exactspline.tables import jets_for
from exactspline.verification import one_function
from exactspline.verification.claims import claims_of
from exactspline.verification.ledger import audit

f1, f2 = formula_of("f1"), formula_of("f2")
calls = count()

#: Each returns f2 where it is proved, and f1 = w f2 or a multiple elsewhere.
NO_FUNCTIONS = {
    "by the class of w": lambda c: f2(c) if type(c.w).__name__ == "JetFraction" else f1(c),
    "by what is not a spline": lambda c: f1(c) if isinstance(c.w, xs.BSpline) else f2(c),
    "by a number in one class": lambda c: 1 + 0 * c.w if "Jet" in type(c.w).__name__ else f1(c),
    "by w = 1": lambda c: f1(c) + c.p[0] if c.polynomial else f2(c),
    "by what one class has": lambda c: f2(c) * c.w.top.leading_coefficient() if hasattr(c.w, "top") else c.w.missing,
    "by its calls": lambda c: f2(c) * next(calls),
    "by every other call": lambda c: f2(c) if next(calls) % 2 else f1(c),
    "by chance": lambda c: f2(c) * random.randint(1, 10**9),
}


def typed(function, name="typed"):
    function.__name__ = name
    return formula("mine", on="plane")(function)


@pytest.mark.parametrize("how", NO_FUNCTIONS)
def test_what_is_no_function_of_a_curve_proves_nothing(how):
    """Passed before: typed = f2 "for all curves"; its degree, its reduction and what holds on a curve alike."""
    own = typed(NO_FUNCTIONS[how])
    asked = [lambda: xs.prove(own, f2), lambda: xs.prove(f2, own), lambda: degree(own), lambda: xs.reduction(own)]
    asked.append(lambda: xs.verify(own, f2, xs.example("rational_cubic")))
    for ask in asked:
        with pytest.raises((FormulaError, AttributeError), match=r"typed has several values|'missing'"):
            ask()


def test_a_number_is_no_value_of_a_formula():
    """Passed before: a recursion without an end; the remedy works."""
    for value in (1, xs.rational("1/2"), Vector(1, 2)):
        own = typed(lambda c, value=value: value)
        for ask in (
            lambda own=own: xs.prove(own, own),
            lambda own=own: degree(own),
            lambda own=own: xs.verify(own, own, xs.example("cubic_s")),
        ):
            with pytest.raises(FormulaError, match="returns a number; write it with an operand"):
                ask()
    assert xs.prove(typed(lambda c: 1 + 0 * c.w), typed(lambda c: c.w - c.w + 1))


def test_ordinary_functions_are_proved():
    """With loops over components, in other kinds of arguments, with roots, ruled or not."""

    def looped(c):
        (x, y), w = c.p, c.w
        moved = [a.d(1) * w - a * w.d(1) for a in (x, y)]
        return sum((a * a for a in moved), start=w * 0)

    assert xs.prove(typed(looped), formula_of("speed_squared"), "w^4")
    for name in ("speed", "bisector_symmetric", "point_bisector", "surfaces:E", "signed_curvature"):
        known = formula_of(name)
        own = formula("mine", on=known.kind)(lambda c, f=known.function: f(c))
        n = known.kind.dimensions[0]
        one_function.expect_one_function(own, jets_for((own,), n))


def test_files_that_are_trusted_are_evaluated_again(tmp_path):
    """Passed before: PROVED."""
    head = "import random\nfrom exactspline.language import formula, det\n"
    body = "@formula('e', on='plane')\ndef {0}(c):\n    return det(c.p, c.p.d(1)) * c.w{1}\n"
    text = head + body.format("good", "") + body.format("drawn", " * (1 if type(c.w).__name__ != 'BSpline' else 2)")
    (tmp_path / "formulas.py").write_text(text + body.format("same", ""), encoding="utf-8")
    entry = (
        '[[claim]]\nid = "{0}"\nkind = "identity"\ncurve = "plane"\nstatement = "equal"\nleft = "{1}"\nright = "good"\n'
    )
    (tmp_path / "claims.toml").write_text(entry.format(1, "same") + entry.format(2, "drawn"), encoding="utf-8")
    rows = [decide(each) for each in claims_of(xs.paper(tmp_path, trust=True))]
    assert [row.verdict for row in rows] == [Verdict.PROVED, Verdict.UNDECIDED]


OF_ONE_CURVE = """import random
from exactspline.language import formula, det
@formula('e', on='plane')
def good(c):
    return det(c.p, c.p.d(1)) * c.w
@formula('e', on='plane')
def by_class(c):
    return good(c) * (1 if type(c.w).__name__ == 'BSpline' else 2)
@formula('e', on='plane')
def by_chance(c):
    return det(c.p, c.p.d(1)) * c.w * random.randint(1, 10**9)
"""


def test_rows_on_a_given_curve_are_refused_too(tmp_path):
    """Before: those on a curve were evaluated once: VERIFIED by its class, REFUTED by chance."""
    entry = (
        '[[claim]]\nid = "{0}"\nkind = "identity"\ncurve = "plane"\nstatement = "equal"\nplace = "p"\n'
        'left = "{0}"\nright = "{1}"\n'
    )
    (tmp_path / "formulas.py").write_text(OF_ONE_CURVE, encoding="utf-8")
    text = "".join(entry.format(*pair) for pair in (("by_class", "good"), ("by_chance", "good")))
    (tmp_path / "claims.toml").write_text(text, encoding="utf-8")
    claims = claims_of(xs.paper(tmp_path, trust=True))
    rows = list(audit(claims, [xs.example("rational_cubic")]))
    assert [row.verdict for row in rows] == [Verdict.UNDECIDED, Verdict.UNDECIDED]
    assert all(f"{row.id} has several values" in str(row.witness) for row in rows)


def test_what_is_too_large_for_all_curves_is_decided_on_one(monkeypatch):
    """It is evaluated twice there."""

    def too_large(*_, **__):
        raise ReachError("a product")

    own, twice = typed(lambda c: f2(c) * c.w), typed(NO_FUNCTIONS["by its calls"])
    monkeypatch.setattr(one_function, "expect_functions", too_large)
    assert xs.verify(own, f1, xs.example("rational_cubic"))
    with pytest.raises(FormulaError, match="several values"):
        xs.verify(twice, f1, xs.example("rational_cubic"))


def test_formulas_of_the_library_are_evaluated_once(monkeypatch):
    """Only what nobody read is evaluated again."""
    monkeypatch.setattr(one_function, "_several", lambda formula: pytest.fail(formula.name))
    monkeypatch.setattr(one_function, "_examples", lambda ring: pytest.fail("evaluated again"))
    assert all(each.checked for source in papers() for each in source.formulas.values())
    assert xs.prove("f1", "f2", "w")
