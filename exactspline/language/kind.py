"""Kinds of arguments. A kind declares its operands, parameters and constants, and the derivatives of dependent
operands.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from types import MappingProxyType

from exactspline.language.arguments import Evaluated, T
from exactspline.language.operand import Operand, Parameter

_DIGITS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")


@dataclass(frozen=True)
class Symbol:
    """An operand of a kind of argument.

    `name` is its name in the argument, `text` its notation; `parameters` are the variables of which it is a function,
    none for a constant. `degree` is its degree, expressed in the degrees that claims may use; empty for a function
    without a degree.

    >>> Symbol("x", "x", (Parameter.FIRST,)).degree_in(Parameter.FIRST)
    'd'
    >>> Symbol("x", "x", (Parameter.U, Parameter.V)).degree_in(Parameter.V)
    'd_v'
    """

    name: str
    text: str
    parameters: tuple[Parameter, ...]
    degree: str = "d"

    def degree_in(self, parameter: Parameter) -> str:
        """The degree in one of its parameters; a function of several parameters has a separate degree in each."""
        return self.degree if len(self.parameters) == 1 or not self.degree else f"{self.degree}_{parameter}"


#: Greek letters by their names.
GREEK = {
    **{"alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "zeta": "ζ", "eta": "η", "theta": "θ"},
    **{"kappa": "κ", "lambda": "λ", "lamda": "λ", "mu": "μ", "nu": "ν", "xi": "ξ", "pi": "π", "rho": "ρ"},
    **{"sigma": "σ", "tau": "τ", "phi": "φ", "chi": "χ", "psi": "ψ", "omega": "ω"},
}


def constant_text(name: str) -> str:
    """The mathematical notation for the name of a constant.

    >>> constant_text("delta"), constant_text("lambda_1"), constant_text("r")
    ('δ', 'λ₁', 'r')
    """
    stem = name.rstrip("0123456789")
    return GREEK.get(stem.rstrip("_"), stem.rstrip("_")) + name[len(stem) :].translate(_DIGITS)


#: The derivative of an operand, computed from all operands by name: the chain rule, where operands depend on each
#: other.
Rule = Callable[[Mapping[str, Operand]], object]


class Kind(ABC):
    """A kind of argument of formulas.

    `dimensions` are the dimensions in which the kind exists. A kind that `adjoins_roots` exists only in readings with
    division, not for splines or degrees; `made_of_a_curve` states whether a single curve determines an argument.
    """

    adjoins_roots: bool = False
    name: str
    dimensions: tuple[int, ...]
    made_of_a_curve = True
    #: Whether a single surface determines an argument.
    made_of_a_surface = False
    #: The parameters in which tables count degrees; for two curves, only that of the first.
    counted: tuple[Parameter, ...] = (Parameter.FIRST,)
    #: If a parameter of some operands is itself a function of the parameter of the curve: the operand for it.
    composed: Mapping[Parameter, str] = MappingProxyType({})
    #: The names of constants that accompany a curve, such as the distance of an offset.
    constants: tuple[str, ...] = ()

    @abstractmethod
    def symbols(self, dimension: int, *, polynomial: bool = False) -> tuple[Symbol, ...]:
        """The operands, numerators before denominators; a polynomial curve has no denominator."""

    @abstractmethod
    def of_operands(self, named: Mapping[str, T], dimension: int, one: T) -> Evaluated:
        """The argument made from its operands, given by name; `one` is the denominator of polynomial curves."""

    def argument(
        self, dimension: int, operand: Callable[[Symbol], T], one: T, *, polynomial: bool = False
    ) -> Evaluated:
        """The argument, each of its operands made from its symbol."""
        named = {symbol.name: operand(symbol) for symbol in self.symbols(dimension, polynomial=polynomial)}
        return self.of_operands(named, dimension, one)

    @abstractmethod
    def names(self, dimension: int) -> dict[str, bool]:
        """The names that formulas may use for such an argument, and whether each is a vector."""

    def rules(self, dimension: int) -> dict[str, Rule]:
        """The derivatives of the operands that depend on other operands, by name."""
        return {}

    @property
    def parts(self) -> dict[str, Kind]:
        """The kinds of the arguments that it consists of, by their names in formulas."""
        return {}

    def parameters(self, dimension: int) -> tuple[Parameter, ...]:
        """The parameters of its operands.

        >>> from exactspline.language.kinds import PAIR, SURFACE
        >>> *PAIR.parameters(3), *SURFACE.parameters(3)
        (<Parameter.FIRST: 's'>, <Parameter.SECOND: 's̄'>, <Parameter.U: 'u'>, <Parameter.V: 'v'>)
        """
        return _parameters(self, dimension)

    def takes(self, other: Kind, dimension: int) -> bool:
        """Whether formulas of another kind can be evaluated on such an argument, because it has their operands.

        >>> from exactspline.language.kinds import CURVE, PAIR, PLANE, PLANE_POINT, kind_of
        >>> PLANE_POINT.takes(PLANE, 2), PLANE.takes(PLANE_POINT, 2), PAIR.takes(CURVE, 3)
        (True, False, False)
        >>> kind_of("plane with delta").takes(PLANE, 2)
        True
        """
        alike = dimension in other.dimensions and isinstance(self, type(other))
        return alike and _has_operands(self, other, dimension)

    def __repr__(self) -> str:
        return f"<kind {self.name}>"


@lru_cache(1024)
def _parameters(kind: Kind, dimension: int) -> tuple[Parameter, ...]:
    return tuple(dict.fromkeys(p for symbol in kind.symbols(dimension) for p in symbol.parameters))


@lru_cache(1024)
def _has_operands(kind: Kind, other: Kind, dimension: int) -> bool:
    return set(other.symbols(dimension)) <= set(kind.symbols(dimension))


def constants_of(kind: Kind) -> tuple[Symbol, ...]:
    """The symbols of the constants of a kind."""
    return tuple(Symbol(name, constant_text(name), ()) for name in kind.constants)
