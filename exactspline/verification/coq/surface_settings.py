"""Functions of two parameters: surfaces, maps of the plane, and quadratic forms about which nothing else is known."""

from __future__ import annotations

from dataclasses import dataclass

from exactspline.language.arguments import COORDINATES
from exactspline.language.choices import Parameter
from exactspline.language.kinds import Symbol
from exactspline.readings.rational_jet import JetFraction
from exactspline.verification.coq.settings import Setting


@dataclass(frozen=True)
class SurfaceSetting(Setting):
    """A rational surface in space, or a rational map of the plane, with all partial derivatives up to an order."""

    @property
    def shape(self) -> str:
        """Its name in the base."""
        return "planar_map" if self.dimension == 2 else "surface"

    @property
    def quantifier(self) -> str:
        """The quantifier at the beginning of the theorem."""
        return f"every_{self.shape}"

    @property
    def introduced(self) -> list[str]:
        """The functions, that derivatives commute, and that the denominator has no zero."""
        return [*[self.named(symbol.name) for symbol in self.symbols], "C", *[f"H{weight}" for weight in self.weights]]

    @property
    def jets(self) -> str:
        """The list of partial derivatives."""
        return " ++ ".join(f"partials {self.order} {self.named(symbol.name)}" for symbol in self.symbols)

    def position(self, name: str, order: int = 0) -> int:
        """The number of a function, or of its derivative with respect to u."""
        return self._place(self.ring.index[name, (order, 0)])

    @property
    def rules(self) -> str:
        """The rules for the derivatives of the jets."""
        first, second = (
            " ++ ".join(f"grid {self.position(symbol.name)} {self.order} {i}" for symbol in self.symbols)
            for i, _ in enumerate((Parameter.U, Parameter.V))
        )
        return f"of_parameters ({first}) ({second})"

    @property
    def deep(self) -> str:
        """The argument as expressions."""
        return f"Patch (homogeneous s {self.variables(COORDINATES[: self.dimension])} ({self.variable('w')}) [])"


@dataclass(frozen=True)
class FormsSetting(SurfaceSetting):
    """Two quadratic forms, functions of u and v, and a function w."""

    @property
    def shape(self) -> str:
        """Its name in the base."""
        return "two_forms"

    @property
    def opening(self) -> str:
        """The first step of a proof."""
        return "unfold every_two_forms"

    @property
    def weights(self) -> tuple[str, ...]:
        """None: nothing is assumed about w."""
        return ()

    @property
    def deep(self) -> str:
        """The argument as expressions."""
        return f"Accompanied (rational_curve s [] ({self.variable('w')}) []) {self.variables('EFGLMN')}"


@dataclass(frozen=True)
class SurfaceCurveSetting(Setting):
    """A curve on a rational surface: its parameters u and v with their derivatives, and the partial derivatives of the
    surface, which are differentiated along the curve by the chain rule.
    """

    @property
    def shape(self) -> str:
        """Its name in the base."""
        return "curve_on_a_surface"

    @property
    def quantifier(self) -> str:
        """The quantifier at the beginning of the theorem."""
        return f"every_{self.shape}"

    @property
    def _route(self) -> tuple[str, ...]:
        return tuple(self.kind.composed.values())

    @property
    def _coordinates(self) -> tuple[str, ...]:
        return tuple(symbol.name for symbol in self.symbols if symbol.name not in self._route)

    def _operand(self, symbol: Symbol) -> JetFraction:
        return self._jet(symbol.name) if symbol.name in self._route else super()._operand(symbol)

    @property
    def introduced(self) -> list[str]:
        """The functions, that derivatives commute, the chain rule, and that the denominator has no zero."""
        names = [self.named(name) for name in (*self._route, *self._coordinates)]
        return [*names, "C", *[f"F{name}" for name in self._coordinates], *[f"H{weight}" for weight in self.weights]]

    @property
    def jets(self) -> str:
        """The derivatives of the parameters, then the partial derivatives of the surface."""
        route = [f"jets time {self.order} {self.named(name)}" for name in self._route]
        return " ++ ".join([*route, *[f"partials {self.order} {self.named(name)}" for name in self._coordinates]])

    def position(self, name: str, order: int = 0) -> int:
        """The number of a parameter or its derivative, or of a coordinate or its derivative with respect to u."""
        orders = (order,) if name in self._route else (order, 0)
        return self._place(self.ring.index[name, orders])

    @property
    def rules(self) -> str:
        """The rules for the derivatives of the jets: with respect to u, to v, and along the curve."""
        by_u, by_v = ([f"grid {self.position(name)} {self.order} {i}" for name in self._coordinates] for i in (0, 1))
        along = [f"chain {self.position(name)} {self.order}" for name in self._route]
        paces = " ".join(str(self.position(name, 1)) for name in self._route)
        along += [f"chained {self.position(name)} {self.order} {paces}" for name in self._coordinates]
        first, second, third = (" ++ ".join(rules) for rules in (by_u, by_v, along))
        return f"of_three_parameters ({first}) ({second}) ({third})"

    @property
    def deep(self) -> str:
        """The argument as expressions."""
        net = f"homogeneous time {self.variables(COORDINATES[: self.dimension])} ({self.variable('w')}) []"
        return f"Path (Patch ({net})) {self.variables(self._route)}"
