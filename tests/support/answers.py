"""The answers to all questions of the registry about one curve, for tests that compare two curves."""

from exactspline import analyse
from exactspline.geometry.analysis.curves import questions_about
from exactspline.questions.entry import Answered


def answers(curve, answered):
    """The answers that consist of the same, by question; none with an argument, none that is part of another."""
    return {
        name: entry.answer(analyse(curve))
        for name, entry in questions_about(curve).items()
        if entry.about.answered is answered and not entry.about.part_of and not entry.about.argument
    }


def places(curve):
    """The answers about single points."""
    return answers(curve, Answered.PLACES)


def pieces(curve):
    """The answers that are pieces, each by its intervals."""
    return {name: [piece.parts for piece in found] for name, found in answers(curve, Answered.PIECES).items()}
