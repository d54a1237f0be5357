"""Proof scripts: the polynomials that do not vanish, with reasons, and the checks that imply an equality."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from flint import fmpq_mpoly

from exactspline.errors import FormulaError
from exactspline.extras.coq.formulas import Writer
from exactspline.extras.coq.settings import Setting
from exactspline.numbers.exact import from_flint, mpq, over_one_denominator
from exactspline.polynomials.factors import Factored, Factorization, prime_factors
from exactspline.readings.jet import Jet, JetFraction
from exactspline.readings.printing import Operation
from exactspline.readings.tree import Node
from exactspline.verification.divisors import Evaluation, factored

#: A denominator with more terms is not factored.
LARGE = 100
#: A polynomial that does not vanish, or a prime number.
Atom = fmpq_mpoly | int


@dataclass(frozen=True)
class Premise:
    """An assumption of a theorem: a tree that is not zero, and its value."""

    name: str
    node: Node
    value: Any


def _base(node: Node) -> tuple[Node, int]:
    """The base and the exponent of a tree that is a power; the base vanishes where the tree does."""
    power = 1
    while node.op is Operation.POWER and node.value > 0:
        node, power = node.args[0], power * node.value
    return node, power


@dataclass(kw_only=True)
class Nonzero:
    """Polynomials and prime numbers that do not vanish, and the products of them that occur, by their exponents in
    numerator and denominator.
    """

    atoms: list[Atom] = field(default_factory=list)
    known: list[tuple[tuple[int, ...], tuple[int, ...]]] = field(default_factory=list)

    def recognize(self, value: Factored[fmpq_mpoly]) -> None:
        """Register a product, and its factors, for the checker."""
        constant = ((value.constant.numerator, 1), (value.constant.denominator, -1))
        primes = [(p, sign * e) for number, sign in constant for p, e in prime_factors(int(number)).items()]
        for atom, _ in (*primes, *value.powers):
            if self.place(atom) is None:
                self.meet(atom)
        above, below = [0] * len(self.atoms), [0] * len(self.atoms)
        for atom, e in (*primes, *value.powers):
            if (place := self.place(atom)) is None:
                raise FormulaError("it divides by something that may vanish", remedy="assume that it does not")
            above[place] += max(e, 0)
            below[place] += max(-e, 0)
        entry = tuple(above), tuple(below)
        if entry not in self.known:
            self.known.append(entry)

    def place(self, atom: Atom) -> int | None:
        """The position of an atom; None for an unknown atom."""
        same = (i for i, each in enumerate(self.atoms) if isinstance(each, int) is isinstance(atom, int))
        return next((i for i in same if self.atoms[i] == atom), None)

    def meet(self, atom: Atom) -> None:
        """Add an atom."""
        self.atoms.append(atom)

    @property
    def known_list(self) -> str:
        """The products known to the checker."""
        pairs = [f"([{'; '.join(map(str, a))}], [{'; '.join(map(str, b))}])" for a, b in self.known]
        return f"[{'; '.join(pairs)}] : list (list nat * list nat)"


@dataclass
class Proof(Nonzero):
    """The atoms of one theorem, the reasons why they do not vanish, and the assumptions beyond those of the claim."""

    setting: Setting
    name: str
    premises: list[Premise]
    evaluation: Evaluation
    writer: Writer
    reasons: list[str] = field(default_factory=list)
    texts: list[str] = field(default_factory=list)
    primes: list[int] = field(default_factory=list)
    existing: list[Premise] = field(default_factory=list)

    def met(self) -> None:
        """Add all denominators that occur; one about which nothing is known is assumed not to vanish, since the claim
        divides by it.
        """
        for node, value in self.evaluation.denominators:
            parts = factored(value)
            if not isinstance(value, JetFraction) or all(self.follows(each) for each, _ in parts.powers):
                self.recognize(parts)
                continue
            base, power = _base(node)
            assumed = Premise(f"D{len(self.existing) + 1}", base, self.setting.flat(self.evaluation(base)))
            self.existing.append(assumed)
            if assumed.value.bottom.is_one() and len(assumed.value.top) > LARGE:
                self.known.append(((*[0] * len(self.atoms), power), ()))
                self._add(assumed.value.top, f"vm_cast_no_check {assumed.name}", self.writer(base))
            else:
                for polynomial, _ in parts.powers:
                    if not self.follows(polynomial):
                        self._divides(polynomial, assumed)
                self.recognize(parts)

    def meet(self, atom: Atom) -> None:
        """Prove that a polynomial does not vanish; for a prime number, assume that it does not vanish."""
        if isinstance(atom, int):
            self.prime(atom)
        else:
            self._prove(atom)

    def prime(self, p: int) -> None:
        """Assume that a prime number does not vanish."""
        if self.place(p) is None:
            self.primes.append(p)
            self._add(p, f"exact P{p}")

    def _add(self, atom: Atom, reason: str, text: str = "") -> None:
        self.atoms.append(atom)
        self.reasons.append(reason)
        self.texts.append(text or (f"num {atom}" if isinstance(atom, int) else self.setting.expression(atom)))

    def _prove(self, polynomial: fmpq_mpoly) -> None:
        """Prove that a polynomial does not vanish: the polynomial is a denominator of a curve, or it divides a
        polynomial that is assumed not to vanish, or its zeros would be common zeros of such a polynomial and its
        derivative.
        """
        if hypothesis := self._given(polynomial):
            self._add(polynomial, f"exact {hypothesis}")
        elif not any(self._divides(polynomial, premise) for premise in self.premises):
            for premise in self.premises:
                if self._divides_with_derivative(polynomial, premise):
                    break

    def _given(self, polynomial: fmpq_mpoly) -> str | None:
        """The hypothesis that it does not vanish, if it is the denominator of a curve or a root."""
        setting = self.setting
        names = {f"H{name}": name for name in setting.weights} | {f"N{name}": name for name in setting.roots}
        return next((h for h, name in names.items() if polynomial == setting.ring[name].polynomial), None)

    def _divides(self, polynomial: fmpq_mpoly, premise: Premise) -> bool:
        value = premise.value
        rest, remainder = divmod(value.top, polynomial)
        if remainder:
            return False
        below = factored(JetFraction(value.ring, value.ring.context.constant(1), value.bottom))
        _, scale = over_one_denominator(map(from_flint, rest.coeffs()))
        if below.powers or scale != 1:
            self.recognize(factored(JetFraction(value.ring, value.bottom * scale, value.ring.context.constant(1))))
        cofactor = self._fraction(rest * scale, value.bottom * scale)
        given = f"({self.writer(premise.node)} : expr)%formula"
        self._add(
            polynomial,
            f"apply (factor_nonzero K l r R roots Q {self._list()} known N {given} {cofactor} "
            f"{self._expression(polynomial)}); [vm_cast_no_check (eq_refl true) | vm_cast_no_check {premise.name}]",
        )
        return True

    def _divides_with_derivative(self, polynomial: fmpq_mpoly, premise: Premise) -> bool:
        """``4 B = b S − S′ S′`` implies that S does not vanish where B does not; this applies to ‖γ′‖² and ‖γ′ × γ″‖²
        (in the plane ``[γ′ γ″]²``).
        """
        whole_factor = self._whole(polynomial, premise)
        if whole_factor is None:
            return False
        whole, power, rest, derivative = whole_factor
        self.recognize(factored(mpq(2)))
        if self.place(whole) is None:
            self._prove(whole)
        self.recognize(Factored(mpq(4), Factorization([(whole, power)])))
        left = f"(num 4 * ({self.setting.expression(whole)}) ^ {power})%formula"
        self._add(
            polynomial,
            f"apply (differential_factor_nonzero K l r R roots Q {self._list()} known N {left} "
            f"{self._expression(rest)} {self._expression(-derivative)} {self._expression(polynomial)}); "
            f"[vm_cast_no_check (eq_refl true) | apply (unit_nonzero K l r R roots Q {self._list()} known N); "
            "vm_cast_no_check (eq_refl true)]",
        )
        return True

    def _whole(self, polynomial: fmpq_mpoly, premise: Premise) -> tuple[fmpq_mpoly, int, fmpq_mpoly, fmpq_mpoly] | None:
        """A factor B of something nonvanishing, whether B or its square is meant, and b and S′ as above."""
        derivative = self._derivative(polynomial)
        if derivative is None or not isinstance(premise.value, JetFraction):
            return None
        for whole, _ in factored(premise.value).powers:
            for power in (1, 2):
                rest, remainder = divmod(whole**power * 4 + derivative**2, polynomial)
                if not remainder and whole != polynomial:
                    return whole, power, rest, derivative
        return None

    def follows(self, polynomial: fmpq_mpoly) -> bool:
        """Whether the assumptions imply that a polynomial does not vanish."""
        if self.place(polynomial) is not None or self._given(polynomial):
            return True
        return any(
            isinstance(h.value, JetFraction)
            and (not divmod(h.value.top, polynomial)[1] or self._whole(polynomial, h) is not None)
            for h in self.premises
        )

    def _derivative(self, polynomial: fmpq_mpoly) -> fmpq_mpoly | None:
        try:
            return Jet(self.setting.ring, polynomial).d(by="s").polynomial
        except FormulaError:
            return None

    def _expression(self, polynomial: fmpq_mpoly) -> str:
        return f"({self.setting.expression(polynomial)})%formula"

    def _fraction(self, top: fmpq_mpoly, bottom: fmpq_mpoly) -> str:
        above = self.setting.expression(top)
        return f"({above})%formula" if bottom.is_one() else f"(({above}) / ({self.setting.expression(bottom)}))%formula"

    def _list(self) -> str:
        return f"(firstn {len(self.atoms)} atoms)"

    def script(self) -> list[str]:
        """The lines of the proof that the atoms do not vanish."""
        lines = [
            *self.setting.preamble([(h.name, self.writer(h.node), h.value) for h in self.premises]),
            f"pose (c := {self.setting.spelling.deep}).",
            f"pose (atoms := [{'; '.join(self.texts)}]%formula : list expr).",
            f"pose (known := {self.known_list}).",
            "assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.",
        ]
        for i, reason in enumerate(self.reasons):
            lines.append(f"assert (N{i + 1} : all_nonzero K l (firstn {i + 1} atoms)).")
            lines.append(f"{{ apply (and_nonzero K l (firstn {i} atoms) (nth {i} atoms (num 0)) N). {reason}. }}")
            lines.append(f"clear N. rename N{i + 1} into N.")
        return lines
