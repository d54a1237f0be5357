"""Formulas: functions with a name, a symbol and a reference to their source."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from functools import cache
from typing import Any, ClassVar

from exactspline.errors import FormulaError, InapplicableError, a_kind, as_text
from exactspline.hooks import Displayed
from exactspline.language.arguments import GREEK, Argument, Kind, Symbol
from exactspline.language.kinds import CURVE, kind_of
from exactspline.language.operand import Letter


class Formula(Displayed):
    """A formula with its name, its symbol and a reference to its source; calling it evaluates it in the reading of its
    argument.

    `kind` states what the argument must be (see `exactspline.language.kinds`). `symbol` is its LaTeX name, if the
    source gives it one; it is used only for display. A reading may intercept the call (the tree reading keeps a symbol
    as a node).
    """

    def __init__(self, function: Callable[..., object], source: str, kind: Kind, symbol: str) -> None:
        #: The undecorated function.
        self.function: Callable[..., Any] = function
        self.source, self.kind, self.symbol = source, kind, symbol
        self.name = self.__name__ = function.__name__
        #: Whether the text of the formula was checked before it ran, in the library or by
        #: `exactspline.papers.formula_check`.
        self.checked = False
        #: The dimensions in which the parameters of its derivatives have been checked.
        self._lettered: set[int] = set()
        self.__doc__, self.__module__ = function.__doc__, function.__module__

    def __reduce__(self) -> str:
        return self.name  # pickled by reference: the formula with this name in its module

    @property
    def curve(self) -> str:
        """The name of the kind of its argument."""
        return self.kind.name

    def __call__(self, c: object) -> Any:
        """The value of the formula in the reading of `c`.

        Raises `FormulaError` for a derivative with respect to a parameter that arguments of this kind do not have.
        """
        if not isinstance(c, Argument):
            return self.function(c)
        self._check_letters(getattr(c, "dimension", self.kind.dimensions[0]))
        return c.calls(self)

    def _check_letters(self, dimension: int) -> None:
        """Raise `FormulaError` for derivatives with respect to unknown parameters, once per dimension and independently
        of the reading. For a kind with a single parameter, the readings themselves reject all other parameters.
        """
        if dimension in self._lettered or dimension not in self.kind.dimensions:
            return
        parameters = self.kind.parameters(dimension)
        if len(parameters) > 1:
            self.function(self.kind.argument(dimension, self._letter(parameters), Letter(parameters)))
        self._lettered.add(dimension)

    def _letter(self, parameters: tuple[str, ...]) -> Callable[[Symbol], Letter]:
        """The operand of a symbol. If ``u`` is both a parameter of a surface and a function along a curve, the
        derivative of the function with respect to the parameter would be 0 in one sense and 1 in another.
        """
        along = self.kind.composed.values()
        return lambda symbol: Letter(symbol.parameters if symbol.name in along else parameters)

    def __repr__(self) -> str:
        return f"<formula {self.name}, {self.source}>"


def expect_formula(given: object) -> Formula:
    """The argument itself if it is a formula; raises `FormulaError` for anything else."""
    if isinstance(given, Formula):
        return given
    raise FormulaError(
        f"{a_kind(given)}, where a formula is expected", remedy='give one, such as exactspline.formula_of("f2")'
    )


def formula(source: str, *, on: Kind | str = CURVE, symbol: str = "") -> Callable[[Callable[..., object]], Formula]:
    """Declare a function as a formula, of a paper or of a user, for arguments of a kind. The kind is a `Kind` or its
    name.

    >>> @formula("Table 1, T16")
    ... def velocity(c):
    ...     return c.p.d(1)
    >>> velocity
    <formula velocity, Table 1, T16>

    Raises `FormulaError` for an unknown kind.
    """
    kind = kind_of(on) if isinstance(on, str) else on
    if not isinstance(kind, Kind):
        raise FormulaError(f"{a_kind(kind)}, where a kind of argument is expected", remedy="give its name")
    as_text(source, "the place of a formula in its source")
    as_text(symbol, "the symbol of a formula")
    return lambda function: Formula(function, source, kind, symbol)


@cache
def constant_formula(kind: Kind, name: str) -> Formula:
    """A constant that arguments of a kind have, as a formula.

    >>> constant_formula(kind_of("plane with delta"), "delta")
    <formula delta, a constant>
    """

    def value(c: Any) -> Any:
        return getattr(c, name)

    value.__name__ = name
    made = Formula(value, "a constant", kind, f"\\{name}" if name in GREEK else "")
    made.checked = True
    return made


# ---- readings


class Reading(ABC):
    """A reading: one way to evaluate formulas. A new reading is one new file with a subclass; nothing else changes.

    `name` is its name in the ledger; the file of a reading says what the equality of two values proves.
    """

    name: ClassVar[str]

    def __repr__(self) -> str:
        fields = ", ".join(str(x) for x in vars(self).values() if isinstance(x, int | str))
        return f"<{type(self).__name__}{' of ' * bool(fields)}{fields}>"

    @abstractmethod
    def argument(self, kind: Kind, dimension: int, *, polynomial: bool = False) -> Argument:
        """Return the argument for formulas of a kind in a dimension. Polynomial curves have no denominator."""

    def of(self, formula: Formula, dimension: int, *, polynomial: bool = False) -> object:
        """Return the value of a formula in this reading (type of operands).

        >>> from exactspline.papers import find
        >>> from exactspline.readings.degree import DegreeReading
        >>> DegreeReading().of(find("g2"), 2)
        9d − 6
        """
        return formula(self.argument(formula.kind, dimension, polynomial=polynomial))


def freely_differentiable(
    kind: Kind, reading: Reading, dimension: int, *, polynomial: bool = False
) -> tuple[Symbol, ...]:
    """The operands of a kind, for a reading in which they are independent functions, all of the same degree.

    Raises `InapplicableError` for a kind whose operands depend on each other.
    """
    if kind.rules(dimension) or kind.composed:
        raise InapplicableError(
            f"the reading {reading.name!r} does not apply to the kind {kind.name!r}",
            remedy="its operands depend on each other: prove an identity, or check a single curve",
        )
    return kind.symbols(dimension, polynomial=polynomial)
