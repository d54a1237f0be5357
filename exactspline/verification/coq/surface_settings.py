"""Functions of two parameters: surfaces, maps of the plane, and quadratic forms of which nothing else is known."""

from __future__ import annotations

from dataclasses import dataclass

from exactspline.language.arguments import COORDINATES
from exactspline.language.choices import Parameter
from exactspline.verification.coq.settings import Setting


@dataclass(frozen=True)
class SurfaceSetting(Setting):
    """A rational surface in space, or a rational map of the plane, with all partial derivatives up to an order."""

    @property
    def shape(self) -> str:
        """Its word in the base."""
        return "planar_map" if self.dimension == 2 else "surface"

    @property
    def quantifier(self) -> str:
        """What the theorem begins with."""
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
        """The number of a function, or of its derivative by u."""
        return self._place(self.ring.index[name, (order, 0)])

    @property
    def rules(self) -> str:
        """What the derivatives of the jets are."""
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
        """Its word in the base."""
        return "two_forms"

    @property
    def opening(self) -> str:
        """The first step of a proof."""
        return "unfold every_two_forms"

    @property
    def weights(self) -> tuple[str, ...]:
        """None: nothing is known of w."""
        return ()

    @property
    def deep(self) -> str:
        """The argument as expressions."""
        return f"Accompanied (rational_curve s [] ({self.variable('w')}) []) {self.variables('EFGLMN')}"
