"""Claims by their keys and as an author states them, and what is said of them."""

from exactspline import claims, paper
from exactspline.language import formula
from exactspline.papers import Table
from exactspline.verification.claims import claim_of
from exactspline.verification.combined import combined


def claim(key):
    """The one claim with this key."""
    (found,) = claims(key)
    return found


def stated(kind, *, source="lifted", **fields):
    """A claim of a kind, as an entry in the table of a paper states it."""
    entry = {"id": "X", "kind": kind, "statement": "a statement", "status": "ours"} | fields
    return claim_of(
        Table("a test", {name: [*x] if isinstance(x, tuple) else x for name, x in entry.items()}), paper(source)
    )


def lent(monkeypatch, name, function, on, *, source="lifted"):
    """The name of a formula that a paper has while a test runs."""
    function.__name__ = name
    monkeypatch.setitem(paper(source).formulas, name, formula("a test", on=on)(function))
    return name


def one_verdict(claim):
    """The one verdict on a claim: its proof, compared with every example curve to which it applies."""
    return combined(claim)[1]


def refusal(folder):
    """Why the one entry of a user's folder that is refused is not asked."""
    (found,) = (each for each in claims(paper=paper(folder)) if each.kind == "not asked")
    return found.why
