"""Symbols, parameters and inputs of a SymPy model in the names of this package."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import dynamicsymbols

from flowlanes.errors import InputError
from flowlanes.system.system import Parameter
from flowlanes.system.vectors import real_symbol

from ..lagrangian.mechanism import TIME

#: Values of a model's constants, by symbol or name.
Defaults: TypeAlias = Mapping[sp.Symbol | str, float | Parameter]
#: Formulas for functions of time, by function or name.
Inputs: TypeAlias = Mapping[sp.Expr | str, sp.Expr]


@dataclass(frozen=True)
class NameTranslation:
    """The translation of a model's formulas to symbols of this package.

    Attributes
    ----------
    name : str
        The model's name, for messages.
    table : mapping of SymPy objects to Expr
        Functions of time, their rates, constants and the time, as symbols of this package.
    parameters : tuple of Parameter
    """

    name: str
    table: Mapping[sp.Expr, sp.Expr]
    parameters: tuple[Parameter, ...]

    def __call__(self, formula: sp.Expr) -> sp.Expr:
        """The formula in plain symbols."""
        translated = sp.sympify(formula).xreplace(dict(self.table))
        unknown = sorted(map(str, translated.atoms(AppliedUndef)))
        if unknown:
            raise InputError(
                f"{self.name}: {', '.join(unknown)} depends on the time and is neither a "
                "coordinate nor a speed; give its formula in 'inputs'"
            )
        # derivatives of inputs
        return translated.doit() if translated.has(sp.Derivative) else translated

    def all(self, formulas: Iterable[sp.Expr]) -> list[sp.Expr]:
        """The translations of several formulas."""
        return [self(formula) for formula in formulas]


def name_translation(
    name: str,
    formulas: Sequence[sp.Expr],
    moving: Sequence[sp.Expr],
    rates: Mapping[sp.Expr, sp.Expr],
    parameters: Defaults,
    inputs: Inputs,
) -> NameTranslation:
    """The name translation of a model.

    Parameters
    ----------
    name : str
    formulas : sequence of Expr
        All formulas of the model; their constants become parameters.
    moving : sequence of functions of time
        Coordinates and speeds.
    rates : mapping of derivative to Expr
        Rates of the coordinates, in formulas of the model or plain symbols.
    parameters : mapping of Symbol or name to number or Parameter
        Defaults of the constants.
    inputs : mapping of function of time or name to Expr
        Formulas for functions of time that are neither coordinates nor speeds.

    Raises
    ------
    InputError
        If a constant has no default, or an input is not a function of the model.
    """
    time = dynamicsymbols._t
    input_formulas = _inputs(name, formulas, moving, inputs)
    used = {
        s for f in (*formulas, *input_formulas.values()) for s in sp.sympify(f).free_symbols
    } - {time}
    constants = sorted(used, key=str)
    chosen = _parameters(name, constants, parameters)
    plain: dict[sp.Expr, sp.Expr] = {f: real_symbol(str(f.func)) for f in moving}
    plain |= {s: p.symbol for s, p in zip(constants, chosen, strict=True)}
    plain[time] = TIME
    table = dict(plain)
    # the formula of an input may use plain symbols as well as those of the model
    table |= {f: formula.xreplace(plain) for f, formula in input_formulas.items()}
    table |= {rate: value.xreplace(table) for rate, value in rates.items()}
    return NameTranslation(name, table, chosen)


def _inputs(
    name: str, formulas: Sequence[sp.Expr], moving: Sequence[sp.Expr], inputs: Inputs
) -> dict[sp.Expr, sp.Expr]:
    functions = {f for formula in formulas for f in sp.sympify(formula).atoms(AppliedUndef)}
    by_name = {str(f.func): f for f in sorted(functions - set(moving), key=str)}
    formulas_by_function = {}
    for key, value in inputs.items():
        stem = str(getattr(key, "func", key))
        if stem not in by_name:
            known = ", ".join(by_name) or "none"
            raise InputError(f"{name}: inputs: the model has no input {stem}; it has {known}")
        formulas_by_function[by_name[stem]] = sp.sympify(value)
    return formulas_by_function


def _parameters(
    name: str, constants: Sequence[sp.Symbol], parameters: Defaults
) -> tuple[Parameter, ...]:
    values = {str(key): value for key, value in parameters.items()}
    unknown = sorted(values.keys() - {str(s) for s in constants})
    if unknown:
        known = ", ".join(map(str, constants)) or "none"
        raise InputError(
            f"{name}: parameters: the model has no constant {', '.join(unknown)}; it has {known}"
        )
    missing = [str(s) for s in constants if str(s) not in values]
    if missing:
        raise InputError(
            f"{name}: give a default for every constant; {', '.join(missing)} has none"
        )
    return tuple(_parameter(name, s, values[str(s)]) for s in constants)


def _parameter(name: str, symbol: sp.Symbol, value: float | Parameter) -> Parameter:
    if isinstance(value, Parameter):
        if str(value.symbol) != str(symbol):
            raise InputError(f"{name}: parameters: {symbol} is given as {value.symbol}")
        return value
    plain = real_symbol(str(symbol))
    positive = (plain > 0,) if symbol.is_positive else ()
    try:
        default = float(value)
    except (TypeError, ValueError):
        raise InputError(f"{name}: parameters: {symbol} = {value} is not a number") from None
    return Parameter(plain, f"constant {symbol} of the model", default, admissible=positive)
