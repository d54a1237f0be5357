"""Arguments whose derivatives obey rules: hodographs, and curves along which a function is constant."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from exactspline.errors import FormulaError
from exactspline.language.arguments import COORDINATES
from exactspline.language.implicit_kinds import ImplicitKind
from exactspline.language.kinds import Symbol
from exactspline.readings.jet import JetRing
from exactspline.verification.coq.settings import Setting


@dataclass(frozen=True)
class HodographSetting(Setting):
    """A polynomial plane curve with γ′ = (u² − v², 2uv) h; a polynomial one has h = 1."""

    @property
    def shape(self) -> str:
        """Its name in the base."""
        return "primitive_hodograph" if self.polynomial else "hodograph"

    @property
    def quantifier(self) -> str:
        """The quantifier at the beginning of the theorem."""
        return f"every_{self.shape}"

    @property
    def weights(self) -> tuple[str, ...]:
        """None: the denominator is 1."""
        return ()

    @property
    def introduced(self) -> list[str]:
        """The curve, then the functions that define its derivatives."""
        return [*[self.named(symbol.name) for symbol in self.symbols], "Hx", "Hy"]

    @property
    def _factor(self) -> str:
        return "number 1" if self.polynomial else self.variable("h")

    @property
    def own_rules(self) -> list[str]:
        """The derivatives of the coordinates."""
        x, y = self.position("x"), self.position("y")
        u, v = self.variable("u"), self.variable("v")
        return [
            f"({x}%positive, ({u} * {u} - {v} * {v}) * {self._factor})",
            f"({y}%positive, ({u} * {v} + {u} * {v}) * {self._factor})",
        ]

    @property
    def deep(self) -> str:
        """The argument as expressions."""
        beside = f"[{self.variable('u')}; {self.variable('v')}; {self._factor}]"
        return f"Accompanied (homogeneous s {self.variables('xy')} (number 1) []) {beside}"


@dataclass(frozen=True)
class ImplicitSetting(Setting):
    """A curve along which a function F of the coordinates is constant, and the partial derivatives of F."""

    @property
    def shape(self) -> str:
        """Its name in the base."""
        assert isinstance(self.kind, ImplicitKind)
        if self.kind.functions != "f":
            raise FormulaError(f"no quantifier over the kind {self.kind.name!r}", remedy="add one to the base")
        return "implicit_curve" if self.dimension == 2 else "implicit_surface"

    @property
    def quantifier(self) -> str:
        """The quantifier at the beginning of the theorem."""
        return f"every_{self.shape}"

    @cached_property
    def ring(self) -> JetRing:
        """The jets; F's partial derivatives are differentiated along the curve by the chain rule."""
        return JetRing(self.kind, self.dimension, self.order)

    @property
    def symbols(self) -> tuple[Symbol, ...]:
        """Coordinates, free operands, and the partial derivatives up to the second order."""
        return tuple(
            symbol for symbol in self.kind.symbols(self.dimension) if len(symbol.name) <= 3 or self._free(symbol)
        )

    def _free(self, symbol: Symbol) -> bool:
        assert isinstance(self.kind, ImplicitKind)
        return symbol.name in self.kind.free

    @property
    def weights(self) -> tuple[str, ...]:
        """None: the denominator is 1."""
        return ()

    @property
    def _axes(self) -> str:
        return COORDINATES[: self.dimension]

    @property
    def introduced(self) -> list[str]:
        """The coordinates, the free operands, the partial derivatives; then the hypotheses about derivatives."""
        names = [self.named(symbol.name) for symbol in self.symbols]
        hypotheses = [f"H{x}" for x in self._axes] + [f"Hf{x}" for x in self._axes]
        return [*names, *(f"d{x}_" for x in self._axes), *hypotheses]

    @property
    def jets(self) -> str:
        """The jets of the free operands, then the other symbols."""
        rest = [self.named(symbol.name) for symbol in self.symbols if not self._free(symbol)]
        free = [f"jets s {self.order} {self.named(symbol.name)}" for symbol in self.symbols if self._free(symbol)]
        return " ++ ".join([*free, f"[{'; '.join(rest)}]"])

    @property
    def _velocity(self) -> list[str]:
        f = [self.variable(f"f{x}") for x in self._axes]
        if self.dimension == 2:
            pace = self.variable("pace")
            return [f"(- ({f[1]}) * {pace})", f"({f[0]} * {pace})"]
        cut = [self.variable(f"cut{x}") for x in self._axes]
        return [f"({f[i]} * {cut[j]} - {f[j]} * {cut[i]})" for i, j in ((1, 2), (2, 0), (0, 1))]

    def _second(self, x: str, y: str) -> str:
        return self.variable("f" + "".join(sorted(x + y)))

    @property
    def own_rules(self) -> list[str]:
        """The velocity of the curve, and the chain rule."""
        rules = [f"({self.position(x)}%positive, {v})" for x, v in zip(self._axes, self._velocity, strict=True)]
        for x in self._axes:
            terms = [f"{self._second(x, y)} * {v}" for y, v in zip(self._axes, self._velocity, strict=True)]
            rules.append(f"({self.position(f'f{x}')}%positive, {' + '.join(terms)})")
        return rules

    @property
    def deep(self) -> str:
        """The argument as expressions."""
        assert isinstance(self.kind, ImplicitKind)
        rows = ["[" + "; ".join(self._second(x, y) for y in self._axes) + "]" for x in self._axes]
        gradient = self.variables([f"f{x}" for x in self._axes])
        curve = f"homogeneous s {self.variables(self._axes)} (number 1) []"
        return f"Implicit ({curve}) {self.variables(self.kind.free)} {gradient} [{'; '.join(rows)}]"
