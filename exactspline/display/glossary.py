"""The words and symbols of the tables, and the meaning of each."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from importlib import resources
from typing import cast

from exactspline.errors import ExactSplineError, nearest
from exactspline.papers.folder import read_toml


class GlossaryError(ExactSplineError):
    """A term that is not in the glossary."""


@cache
def glossary() -> dict[str, dict[str, str]]:
    """Terms and their meanings, by topic.

    >>> glossary()["verdicts"]["REFUTED"]
    'it fails, and a witness shows where'
    """
    from exactspline.geometry.analysis.registry import terms_of_questions  # loads all that can be asked a question

    return _written() | {"questions": terms_of_questions(_by_term(_written()))}


@cache
def _written() -> dict[str, dict[str, str]]:
    """The words of tables and their meanings, by topic."""
    written = read_toml(resources.files(__package__).joinpath("glossary.toml"), "glossary.toml")
    return cast(dict[str, dict[str, str]], written)


def _by_term(topics: Mapping[str, Mapping[str, str]]) -> dict[str, str]:
    return {term: meaning for topic in topics.values() for term, meaning in topic.items()}


@cache
def terms() -> dict[str, str]:
    """Every term with its meaning."""
    return _by_term(glossary())


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
    """The terms of tables among the words, each once, with their meanings.

    >>> [term for term, _ in explained(["curve", "nominal", "true", "nominal"])]
    ['nominal', 'true']
    """
    known = _by_term(_written())
    return [(word, known[word]) for word in dict.fromkeys(words) if word in known]
