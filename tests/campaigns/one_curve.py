"""Perturbed claims about one curve, and perturbed identities in one line: seeded.

python -m tests.campaigns.one_curve COUNT SEED

COUNT curves with polynomials of its own: what is claimed of each is known from their coefficients, and every claim has
one that differs from it by as little as 10⁻³⁰ and is false. The exit status is 1 where a true one is not VERIFIED (or
PROVED), or a false one is.
"""

import json
import sys
from collections import Counter
from fractions import Fraction
from math import comb
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory

import exactspline as xs
from exactspline.papers import load_paper
from exactspline.verification.claims import claims_of
from exactspline.verification.combined import computed_once
from exactspline.verification.ledger import decide
from tests.verification.test_own_paper import plane_formulas

#: The sentence of the documentation that is judged.
COMPARED = ("If such a claim holds, it is VERIFIED",)
TINY = Fraction(1, 10**30)
FORMULAS = plane_formulas(
    x="c.gamma[0]",
    y="c.gamma[1]",
    px="c.p[0]",
    py="c.p[1]",
    point="c.gamma",
    slope="c.gamma[1] / c.gamma[0]",
    bent="det(c.p.d(1), c.p.d(2))",
    twice="2 * det(c.p.d(1), c.p.d(2))",
    shifted="c.gamma[1] * (c.gamma[0] + 1)",
    through="c.gamma[1] * (c.gamma[0] - rational('1/2'))",
)
#: Identities in one line, with a factor that is 1 or nearly so.
LINES = (
    "{} 2*f1 = f1 + f1",
    "{} det(γ', γ'') = w^-3 * f2",
    "{} f1 = w f2",
    "{} norm2(γ') = dot(γ', γ')",
    "{} (w f2)' = w' f2 + w f2'",
)


def value(coefficients, t):
    """A polynomial with these coefficients at t."""
    return sum((c * t**k for k, c in enumerate(coefficients)), Fraction(0))


def derivative(coefficients):
    """The coefficients of the derivative."""
    return [k * c for k, c in enumerate(coefficients)][1:]


def product(one, other):
    """The coefficients of a product."""
    made = [Fraction(0)] * (len(one) + len(other) - 1)
    for i, a in enumerate(one):
        for j, b in enumerate(other):
            made[i + j] += a * b
    return made


def points(coefficients, degree):
    """Its Bézier coefficients."""
    rest = [*coefficients, *[Fraction(0)] * (degree + 1 - len(coefficients))]
    return [sum(Fraction(comb(i, k), comb(degree, k)) * rest[k] for k in range(i + 1)) for i in range(degree + 1)]


def text(number):
    """A fraction as the table writes it."""
    return f"{number.numerator}/{number.denominator}"


def curve_of(x, y):
    """The Bézier curve with these coordinates over [0, 1]."""
    n = max(len(x), len(y)) - 1
    rows = [(text(a), text(b)) for a, b in zip(points(x, n), points(y, n), strict=True)]
    return xs.Nurbs(n, [0] * (n + 1) + [1] * (n + 1), rows)


def pairs_of(chance, name, x, y, roots):
    """What is claimed of a curve (x, y) with x increasing from 0: a true claim, and a false one beside it."""
    t, n = Fraction(chance.randint(1, 9), 10), max(len(x), len(y)) - 1
    at = {"kind": "at", "formula": "y", "parameter": text(t), "claimed": text(value(y, t))}
    yield at, at | {"claimed": text(value(y, t) + TINY)}
    vector = at | {"formula": "point", "claimed": [text(value(x, t)), text(value(y, t))]}
    yield vector, vector | {"claimed": [text(value(x, t) - TINY), text(value(y, t))]}
    yield vector, vector | {"parameter": text(t + TINY)}
    end = value(y, Fraction(1)) / value(x, Fraction(1))
    limit = {"kind": "limit", "formula": "slope", "parameter": 1, "claimed": text(end)}
    yield limit, limit | {"claimed": text(end + TINY)}
    pole = limit | {"parameter": 0, "claimed": "∞"}
    yield pole, pole | {"claimed": text(end)}
    high, seen = max(points(y, n)), max(value(y, Fraction(k, 64)) for k in range(65))
    bound = {"kind": "bound", "formula": "y", "bound": f"≤ {text(high)}"}
    yield bound, bound | {"bound": f"< {text(seen)}"}
    yield bound, bound | {"bound": f"≤ {text(seen - TINY)}"}
    part = bound | {"formula": "x", "bound": f"≤ {text(value(x, t))}", "interval": ["0", text(t)]}
    yield part, part | {"interval": ["0", text(t + TINY)]}
    yield part, part | {"bound": part["bound"].replace("≤", "<")}
    length = bound | {"formula": "point", "bound": f"≤ {text(abs(high) + abs(min(points(y, n))) + max(points(x, n)))}"}
    yield length, length | {"bound": f"< {text(abs(value(y, Fraction(1, 3))))}"}
    inside = sum(Fraction(1, 4) <= root <= Fraction(3, 4) for root in set(roots))
    count = {"kind": "count", "formula": "y", "claimed": f"{inside} roots", "interval": ["1/4", "3/4"]}
    yield count, count | {"claimed": f"{inside + 1} roots"}
    yield count, count | {"claimed": f"{len(set(roots)) + 1} roots", "interval": ["0", "1"]}
    turned = product(derivative(x), derivative(derivative(y)) or [Fraction(0)])
    other = product(derivative(y), derivative(derivative(x)) or [Fraction(0)])
    bent = [(a or 0) - (b or 0) for a, b in zip([*turned, *[0] * 9], [*other, *[0] * 9], strict=False)]
    degree = max(k for k, c in enumerate(bent) if c)
    own = {"on": "curve", "kind": "identity", "left": "twice", "right": "bent", "factor": "2"}
    yield own, own | {"factor": f"{2 * 10**30 + 1}/{10**30}"}
    true = {"on": "curve", "kind": "degree", "formula": "bent", "measure": "true", "claimed": str(degree)}
    yield true, true | {"claimed": str(degree + 1)}
    kind = {"on": "curve", "kind": "type", "formula": "slope", "claimed": "rational"}
    yield kind, kind | {"claimed": "polynomial"}
    sets = {"on": "curve", "kind": "zero set", "formulas": ["y", "shifted"]}
    if all(value(x, root) != Fraction(1, 2) for root in roots):  # otherwise it is true
        yield sets, sets | {"formulas": ["y", "through"]}
    sign = {"on": "curve", "kind": "sign", "formula": "x", "sign": "≥ 0"}
    yield sign, sign | {"sign": "> 0"}
    all_of = {"on": "curve", "kind": "coefficients", "formula": "px", "sign": "≥ 0"}
    yield all_of, all_of | {"sign": "> 0"}
    apart = {"kind": "distance", "other": f"{name}-above", "bound": "= 3"}
    for wrong in ("= 3.000000000000000000000000000001", "< 3", "> 3"):
        yield apart, apart | {"bound": wrong}


def drawn(chance):
    """Coordinates: x increases from 0 to more than 1/2, y has zeros that are known."""
    roots = [Fraction(chance.randint(1, 15), 16) for _ in range(chance.randint(1, 3))]
    y = [Fraction(chance.choice((-3, -1, 1, 2)))]
    for root in roots:
        y = product(y, [-root, Fraction(1)])
    x = [Fraction(0), *[Fraction(chance.randint(1, 5)) for _ in range(len(y))]]
    return x, y, roots


def campaign(count, seed):
    """The number of true and false claims by kind, and those with a wrong verdict."""
    chance, tally, wrong = Random(seed), Counter(), []
    with TemporaryDirectory() as place:
        folder = Path(place) / "paper"
        (folder / "curves").mkdir(parents=True)
        words = "det, formula"
        (folder / "formulas.py").write_text(
            f"from exactspline import rational\nfrom exactspline.language import {words}\n{FORMULAS}"
        )
        entries = []
        for i in range(count):
            x, y, roots = drawn(chance)
            xs.write(curve_of(x, y), folder / "curves" / f"c{i}.json")
            xs.write(curve_of([Fraction(0), Fraction(1)], [Fraction(0)]), folder / "curves" / f"c{i}-low.json")
            xs.write(curve_of([Fraction(0), Fraction(1)], [Fraction(3)]), folder / "curves" / f"c{i}-above.json")
            for pair in pairs_of(chance, f"c{i}", x, y, roots):
                curve = f"c{i}-low" if pair[0]["kind"] == "distance" else f"c{i}"
                entries += [
                    (holds, {"curve": "plane", "example": curve} | each)
                    for holds, each in zip((True, False), pair, strict=True)
                ]
        claims = [{"id": f"{i}", "statement": "drawn"} | each for i, (_, each) in enumerate(entries)]
        lines = [
            ["[[claim]]", *[f"{k} = {json.dumps(v, ensure_ascii=False)}" for k, v in each.items()]] for each in claims
        ]
        (folder / "claims.toml").write_text("\n".join(line for each in lines for line in each))
        with computed_once():
            for (holds, each), claim in zip(entries, claims_of(load_paper(folder)), strict=True):
                verdict = str(decide(claim).verdict)
                tally[each["kind"], holds, verdict] += 1
                if (verdict == "VERIFIED") != holds:
                    wrong.append((verdict, holds, each))
    for line in LINES:
        for factor, holds in ((Fraction(1), True), (1 + TINY, False), (1 - TINY, False), (Fraction(-1), False)):
            verdict = str(xs.prove(line.format(f"{factor.numerator}/{factor.denominator} *")).verdict)
            tally["one line", holds, verdict] += 1
            if (verdict == "PROVED") != holds:
                wrong.append((verdict, holds, line))
    return tally, wrong


if __name__ == "__main__":
    tallied, found = campaign(int(sys.argv[1]), int(sys.argv[2]))
    for (kind, holds, verdict), n in sorted(tallied.items()):
        print(f"{kind}, {'true' if holds else 'false'}: {verdict} {n}")
    print(f"{sum(n for (_, holds, _), n in tallied.items() if not holds)} false claims, {len(found)} wrong verdicts")
    for each in found:
        print(*each)
    sys.exit(bool(found))
