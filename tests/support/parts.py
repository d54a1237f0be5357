"""A curve and its two parts: what is inside of the parts, together, is what the curve has there."""

from gmpy2 import mpq

from exactspline.questions.entry import Answered
from exactspline.roots.answers import Places
from tests.support.images import Image, known, rings
from tests.support.matrix import ask, dimension_of
from tests.support.transport import Refused, To, rows, same, shown


def of_parts(entry):
    """Whether the answer consists of places, joints or pieces alone, so that it can be put together from parts."""
    return entry.about.answered in (Answered.PLACES, Answered.JOINTS, Answered.PIECES)


def somewhere(curve, random):
    """A parameter that is no end: a knot, or between knots."""
    a, b = curve.domain
    return random.choice([*curve.breakpoints[1:-1], a + (b - a) * mpq(random.randint(1, 30), 31)])


def told(curve, entry, given, cuts):
    """What is told of the inside: places and joints but for those at the cuts, and the ends of pieces."""
    answer = ask(curve, entry.name, given)
    if isinstance(answer, Refused):
        return rows(answer, None)
    ring = rings(curve)[0]._replace(closed=False)
    to = To(curve, Image(), (ring, ring), dimension_of(curve), entry.name, given)
    points, pieces = (tuple(answer), answer.everywhere) if isinstance(answer, Places) else ((), answer)
    if not isinstance(answer, Places) and entry.about.answered is Answered.JOINTS:
        points, pieces = answer, ()
    found = [row for row in rows(points, to) if row[1][0].exact not in cuts]
    ends = {t for piece in pieces for part in piece.parts for t in part} - cuts
    return found + [(("an end",), (known(t),)) for t in sorted(ends)]


def differing_parts(curve, entry, given, t):
    """What the parts and the whole say, where they differ."""
    cuts = {*curve.domain, t}
    expected = told(curve, entry, given, cuts)
    found = [row for part in curve.split(t) for row in told(part, entry, given, cuts)]
    if found and all(words[0] == "refused" for words, _ in found):
        found = found[:1]
    return None if same(found, expected) else (shown(found), shown(expected))
