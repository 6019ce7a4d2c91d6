"""Equations of motion with inputs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import sympy as sp

from flowlanes.arguments import NamedFormulas, arguments_checked
from flowlanes.errors import InputError
from flowlanes.parsing import parse
from flowlanes.parsing.exact_decimals import with_exact_decimals
from flowlanes.system.named_formulas import as_pairs, flat_pairs
from flowlanes.system.overview import Overview, WithOverview
from flowlanes.system.system import Parameter, System

from ..mechanics.lagrangian.mechanism import TIME


@arguments_checked
@dataclass(frozen=True, repr=False)
class ControlledSystem(WithOverview):
    """A vector field that depends on inputs.

    Attributes
    ----------
    name : str
    field : pairs of Vector or Symbol and formula
        Rates of the state in state, inputs, definitions and parameters.
    inputs : tuple of Symbol
    definitions : pairs
        Named quantities in state, inputs, parameters and earlier ones.
    parameters : tuple of Parameter
    relations : tuple of formula
        Expressions that vanish on the state space.
    output : pair of Symbol
        The state variables that shall follow a path.

    Examples
    --------
    >>> import nonholonomic
    >>> from nonholonomic.control import Rotor, SphericalRobot, controlled_system
    >>> robot = SphericalRobot(1.0, (0.4, 0.5, 0.6), 1.0, (Rotor((0, 0, 1), 0.1),))
    >>> system = controlled_system(robot)
    >>> isinstance(system, nonholonomic.control.ControlledSystem), system.inputs
    (True, (u_1,))
    """

    name: str
    field: NamedFormulas
    inputs: tuple[sp.Symbol, ...]
    definitions: NamedFormulas
    parameters: tuple[Parameter, ...]
    relations: tuple[sp.Expr, ...]
    output: tuple[sp.Symbol, sp.Symbol]

    def __post_init__(self) -> None:
        object.__setattr__(self, "field", as_pairs(self.field))
        object.__setattr__(self, "definitions", as_pairs(self.definitions))

    def overview(self) -> Overview:
        """State, inputs, parameters and output."""
        return Overview(
            f"{self.name}: equations with {len(self.inputs)} inputs",
            (
                ("state", ", ".join(str(name) for name, _ in self.field)),
                ("inputs", ", ".join(map(str, self.inputs))),
                ("parameters", ", ".join(str(p.symbol) for p in self.parameters)),
                ("follows a path", ", ".join(map(str, self.output))),
            ),
        )

    @cached_property
    def state(self) -> tuple[sp.Symbol, ...]:
        """The state as scalars, in flat order."""
        return tuple(symbol for symbol, _ in flat_pairs(self.field))

    @cached_property
    def whole(self) -> System:
        """State and inputs as one System, in which the inputs are constant."""
        return System(
            self.name,
            self.name,
            (*self.field, *((u, sp.S.Zero) for u in self.inputs)),
            self.parameters,
            self.definitions,
            self.relations,
        )


def input_formulas(
    name: str,
    inputs: Sequence[sp.Symbol],
    state: Sequence[sp.Symbol],
    texts: Mapping[str, str | sp.Expr],
) -> dict[sp.Symbol, sp.Expr]:
    """Parse and check formulas of inputs, by symbol.

    Parameters
    ----------
    name : str
        Name of the system, for messages.
    inputs, state : sequence of Symbol
    texts : mapping of str to formula
        A formula for each input, in the time t and the state.

    Raises
    ------
    InputError
        If an input is missing or unknown, or a formula cannot be read.
    """
    names = [str(u) for u in inputs]
    if set(texts) != set(names):
        raise InputError(
            f"{name}: the inputs are {', '.join(names)}, one formula for each; given are "
            f"{', '.join(sorted(map(str, texts))) or 'none'}"
        )
    known = {str(s): s for s in (TIME, *state)}
    formulas = {}
    for symbol in inputs:
        text = texts[str(symbol)]
        formula = (
            parse(text, known, f"input {symbol}")
            if isinstance(text, str)
            else with_exact_decimals(sp.sympify(text))
        )
        unknown = sorted(map(str, formula.free_symbols - set(known.values())))
        if unknown:
            raise InputError(
                f"{name}: the input {symbol} uses {', '.join(unknown)}; it may use the time t and "
                f"the state {', '.join(map(str, state))}"
            )
        formulas[symbol] = formula
    return formulas
