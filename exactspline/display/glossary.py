"""The words and symbols of the tables, and the meaning of each."""

from __future__ import annotations

import tomllib
from collections.abc import Iterable
from functools import cache
from html import escape
from importlib import resources

from exactspline.display.page import definitions
from exactspline.errors import ExactSplineError, nearest
from exactspline.geometry.registry import terms_of_questions


class GlossaryError(ExactSplineError):
    """A term that is not in the glossary."""


@cache
def glossary() -> dict[str, dict[str, str]]:
    """Terms and their meanings, by topic.

    >>> glossary()["verdicts"]["REFUTED"]
    'it fails, and a witness shows where'
    """
    written = tomllib.loads(resources.files(__package__).joinpath("glossary.toml").read_text(encoding="utf-8"))
    taken = {term for topic in written.values() for term in topic}
    return written | {"questions": terms_of_questions(taken)}


@cache
def terms() -> dict[str, str]:
    """Every term with its meaning."""
    return {term: meaning for topic in glossary().values() for term, meaning in topic.items()}


def meaning(term: str) -> str:
    """The meaning of a term; upper and lower case are distinguished only where both are terms.

    >>> meaning("proved") == meaning("PROVED")
    True

    Raises `GlossaryError` with the nearest terms.
    """
    known = terms()
    for each in (term, *[name for name in known if name.lower() == term.lower()]):
        if each in known:
            return known[each]
    raise GlossaryError(f"the glossary has no term {term!r}", remedy=nearest(term, known, listed_by="list words"))


def explained(words: Iterable[str]) -> list[tuple[str, str]]:
    """The terms among the words, each once, with their meanings.

    >>> [term for term, _ in explained(["curve", "nominal", "true", "nominal"])]
    ['nominal', 'true']
    """
    return [(word, terms()[word]) for word in dict.fromkeys(words) if word in terms()]


def glossary_list(names: Iterable[str]) -> str:
    """What some terms mean, as a list in HTML."""
    return definitions((term, escape(said)) for term, said in explained(names))
