"""False claims with constants, through every door: seeded.

python -m tests.campaigns.false_claims COUNT SEED

Each claim has two constants, called by every letter in turn; that its sides differ is seen on numbers, by polynomials
of its own. They go through `prove --paper FOLDER`, the same with `--judge sympy` and with `--curve`, `identity`, and
`prove` in Python, of formulas that were checked and of ones that nobody read. The exit status is 1 where one of them is
PROVED or VERIFIED, or holds for the second judge.
"""

import json
import sys
from collections import Counter
from fractions import Fraction
from itertools import zip_longest
from pathlib import Path
from random import Random
from string import ascii_letters
from tempfile import TemporaryDirectory
from types import SimpleNamespace

from exactspline.errors import ExactSplineError
from exactspline.language.formula import Formula
from exactspline.language.kinds import RESERVED
from exactspline.papers import load_paper
from exactspline.verification.questions import prove
from tests.support.command import run
from tests.verification.test_own_paper import written

LETTERS = [*sorted({*ascii_letters} - RESERVED), "delta", "lambda_1", "mu2"]
KINDS = ("plane", "space", "plane point", "point")
#: The curves on which claims are checked, by dimension.
CURVES = {2: "rational_cubic", 3: "rational_space_cubic"}
#: The sentence of the documentation that is judged.
COMPARED = (
    "A statement that is false for some values of its constants is neither proved for all curves nor verified on one, "
    "whatever its constants are called",
)
#: Claims in one folder.
FOLDER = 50
SPEED = "norm2(c.gamma.d(1))"


class Polynomial:
    """A polynomial in t with its coefficients."""

    def __init__(self, *coefficients):
        self.coefficients = coefficients

    def __add__(self, other):
        pairs = zip_longest(self.coefficients, other.coefficients, fillvalue=0)
        return Polynomial(*[a + b for a, b in pairs])

    def __mul__(self, other):
        own, its = self.coefficients, other.coefficients if isinstance(other, Polynomial) else (other,)
        made = [Fraction(0)] * (len(own) + len(its) - 1)
        for i, a in enumerate(own):
            for j, b in enumerate(its):
                made[i + j] += a * b
        return Polynomial(*made)

    __rmul__ = __mul__

    def __sub__(self, other):
        return self + other * -1

    def __pow__(self, n):
        return self if n == 1 else self * self ** (n - 1)

    def d(self, n):
        """The n-th derivative."""
        made = [i * a for i, a in enumerate(self.coefficients)][1:] or [Fraction(0)]
        return Polynomial(*made) if n == 1 else Polynomial(*made).d(n - 1)

    def at(self, t):
        """The value at a parameter."""
        return sum(a * t**i for i, a in enumerate(self.coefficients))


class Vector(tuple):
    """Polynomials."""

    def d(self, n):
        """The n-th derivative."""
        return Vector(x.d(n) for x in self)


def dot(a, b):
    """The inner product."""
    return sum((x * y for x, y in zip(a, b, strict=True)), start=Polynomial(Fraction(0)))


PRODUCTS = {"dot": dot, "norm2": lambda a: dot(a, a), "det": lambda a, b: a[0] * b[1] - a[1] * b[0]}


def differ(chance, n, names, left, right):
    """Whether two sides differ on a curve of numbers."""

    def drawn(terms):
        return Polynomial(*[Fraction(chance.randint(-9, 9), chance.randint(1, 7)) for _ in range(terms)])

    c = SimpleNamespace(p=Vector(drawn(5) for _ in range(n)), w=drawn(5), point=Vector(drawn(1) for _ in range(n)))
    vars(c).update({name: drawn(1) for name in names})
    sides = [eval(side, {"c": c, **PRODUCTS}) for side in (left, right)]
    return sides[0].at(Fraction(3, 7)) != sides[1].at(Fraction(3, 7))


def sides_of(chance, kind, a, b):
    """A sum of products, and what is false of it: another constant, a coordinate or a number for the constant, another
    sign or order of derivative, a constant that is not one.
    """
    pieces = ["c.w", "c.p[0]", "c.p[1].d(1)", "c.w.d(1)", "dot(c.p, c.p.d(1))", "norm2(c.p.d(1))", "c.p[1].d(2)", b]
    pieces += ["c.point[1]"] * 2 * ("point" in kind) + ["det(c.p, c.p.d(1))"] * ("plane" in kind)
    inner, other, beside = chance.sample(pieces[:5], 3)
    more = " * ".join(chance.sample(pieces, 2))
    place = f"c.{'point' if 'point' in kind else 'p'}[{chance.randint(0, 1)}]"
    return chance.choice(
        [
            (f"{a} * {inner} + {more}", f"{b} * {inner} + {more}"),
            (f"{a} * {inner} + {more}", f"{place} * {inner} + {more}"),
            (f"{a} * {inner} - {more}", f"{a} * {inner} + {more}"),
            (f"{a} ** 2 * {inner} * {more}", f"{a} * {inner} * {more}"),
            (f"({a} * {inner} * {other}).d(1)", f"{a} * ({inner}).d(1) * ({other}).d(1)"),
            (f"({a} * {inner}).d(1) * {more}", f"{a} * ({inner}).d(1) * {more} + {inner}"),
            (f"({a} - {b}) * ({inner} + {other})", f"{a} * {inner} - {b} * {other}"),
            (f"({a} * {inner} + {b} * {other}) * {beside}", f"({b} * {inner} + {a} * {other}) * {beside}"),
        ]
    )


def drawn_claim(chance, i):
    """A false claim: its entry without names, and the bodies of the formulas that it names."""
    first = i < len(LETTERS)  # every letter is held against a coordinate of the point once
    kind = chance.choice(KINDS[2 * first :])
    names = [LETTERS[i % len(LETTERS)], chance.choice(LETTERS)]
    if names[0] == names[1] or {*names} == {"lambda_1", "mu2"}:
        names[1] = next(each for each in LETTERS if each != names[0])
    a, b = (f"c.{name}" for name in names)
    told = {"curve": f"{kind} with {', '.join(names)}"}
    while True:
        left, right = sides_of(chance, kind, a, b)
        if first:
            place = f"c.point[{(ord(names[0][0]) - ord('a')) % (2 if 'plane' in kind else 3)}]"
            left, right = f"{a} * c.w", f"{place} * c.w"
        if differ(chance, 2 if "plane" in kind else 3, names, left, right):
            break
    sort = 0 if first else i // len(LETTERS) % 8 if chance.random() < 0.6 else chance.randint(0, 3)
    wrong = chance.choice(
        [
            ({"kind": "type", "claimed": "rational"}, {"formula": f"({left}) / {a}"}),
            ({"kind": "type", "claimed": "polynomial"}, {"formula": f"c.p[0] / (c.w * {a})"}),
            ({"kind": "type", "claimed": "not rational"}, {"formula": f"{a} * c.gamma[0]"}),
            ({"kind": "degree", "of": "polynomial", "claimed": "2d"}, {"formula": f"{a} * dot(c.p, c.p.d(1))"}),
            ({"kind": "degree", "of": "polynomial", "claimed": "d"}, {"formula": f"({a} + {b}) * c.p[0].d(1)"}),
            ({"kind": "square class"}, {"formula": f"{SPEED} * (c.w ** 2 + {a} * c.p[0])", "right": SPEED}),
            ({"kind": "degree", "claimed": "2d + 1"}, {"formula": f"{a} * c.w ** 2 + {b} * c.w * c.p[0]"}),
            (
                {"kind": "same surface"},
                {"left": f"ruled(c.gamma * {a}, c.gamma.d(1))", "right": "ruled(c.gamma, c.gamma.d(1))"},
            ),
            ({"kind": "sign", "sign": chance.choice(["> 0", "≥ 0", "< 0"])}, {"formula": f"{a} * {SPEED}"}),
            ({"kind": "square class"}, {"formula": f"{SPEED} * (c.w + {a} * c.p[0])", "right": SPEED}),
        ]
    )
    found = {
        0: ({"kind": "identity"}, {"left": left, "right": right}),
        1: ({"kind": "identity", "factor": "w", "of": "rational"}, {"left": f"({left}) * c.w ** 2", "right": left}),
        2: ({"kind": "vanishing"}, {"left": f"({left}) - ({right})"}),
        3: ({"kind": "zero set"}, {"formulas": (left, f"{left} + {b} * c.w")}),
    }.get(sort, wrong)
    return told | found[0], found[1]


def folder_of(place, chance, start, count):
    """A folder of false claims."""
    text, claims = "", []
    for i in range(start, start + count):
        told, bodies = drawn_claim(chance, i)
        named = {}
        for field, body in bodies.items():
            names = [f"{field[0]}{i}_{j}" for j in range(len(body))] if isinstance(body, tuple) else [f"{field[0]}{i}"]
            named[field] = names if isinstance(body, tuple) else names[0]
            for name, each in zip(names, body if isinstance(body, tuple) else [body], strict=True):
                text += f"@formula('e', on='{told['curve']}')\ndef {name}(c):\n    return {each}\n"
        claims.append({"id": str(i), "statement": "false", "status": "ours"} | told | named)
    return written(place, text, claims), claims


def asked(folder, claims):
    """What every door answers: the door, the claim, and the verdict."""
    own = ("prove", "--paper", folder, "--json")
    for door, more in (("prove", ()), ("prove --judge sympy", ("--judge", "sympy"))):
        for row in json.loads(run(*own, *more).stdout)["rows"]:
            if not row["curve"]:
                yield door, row["id"], row["verdict"]
                if "sympy" in row:
                    says = row["sympy"].partition(",")[0]
                    yield "sympy", row["id"], {"holds": "PROVED", "fails": "REFUTED"}.get(says, "no equality")
    curves = [argument for name in CURVES.values() for argument in ("--curve", name)]
    for row in json.loads(run(*own, *curves).stdout)["rows"]:
        yield "prove --curve", row["id"], row["verdict"]
    paper = load_paper(folder)
    for each in claims:
        if each["kind"] == "identity":
            left, right, factor = each["left"], each["right"], each.get("factor", "1")
            said = run("identity", f"{folder / 'formulas.py'}:{left} = {factor} * {right}", "--json").stdout
            yield "identity", each["id"], json.loads(said)["rows"][0]["verdict"]
            sides = [paper.find(name) for name in (left, right)]
            typed = [Formula(side.function, "typed", side.kind, "") for side in sides]
            for door, (f, g) in (("prove in Python", sides), ("of typed functions", typed)):
                try:
                    yield door, each["id"], prove(f, g, factor).verdict
                except ExactSplineError as error:
                    yield door, each["id"], type(error).__name__


def campaign(count, seed):
    """The answers of every door by verdict, and what is wrong."""
    chance, tally, wrong = Random(seed), Counter(), []
    with TemporaryDirectory() as place:
        for start in range(0, count, FOLDER):
            folder, claims = folder_of(Path(place) / f"folder{start}", chance, start, min(FOLDER, count - start))
            by = {each["id"]: each for each in claims}
            for door, name, verdict in asked(folder, claims):
                tally[door, str(verdict)] += 1
                tally["kinds", by[name]["kind"]] += door == "prove"
                if verdict in ("PROVED", "VERIFIED"):
                    wrong.append((door, str(verdict), by[name]))
    return tally, wrong


if __name__ == "__main__":
    tallied, found = campaign(int(sys.argv[1]), int(sys.argv[2]))
    for (door, verdict), n in sorted(tallied.items()):
        print(f"{door}: {verdict} {n}")
    for each in found:
        print(*each)
    sys.exit(bool(found))
