"""A separation in the symbols of another system with the same field."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

import sympy as sp

from flowlanes.system.named_formulas import definition_values, flat_pairs
from flowlanes.system.system import System
from flowlanes.system.vectors import constant, real_symbol, to_components

from .separation import SeparatedSystem


def in_symbols_of(
    separable: SeparatedSystem, system: System, parameters: Mapping[sp.Symbol, sp.Expr]
) -> SeparatedSystem:
    """Translate the separation to a system with the field of ``separable.system``.

    Parameters
    ----------
    system : System
        With states that follow each other in the same order; its lift to space may be another.
    parameters : mapping of Symbol to formula
        The parameters of ``separable.system`` in those of `system`.

    Returns
    -------
    SeparatedSystem
        With all formulas in state and parameters of `system`, definitions written out; its laws
        are left out, since they are claimed of the other system.
    """
    known = {**translation(separable.system, system, parameters), **_constants(separable, system)}
    names = dict(zip(separable.system.symbols, system.symbols, strict=True))

    def image(formula: sp.Expr) -> sp.Expr:
        value = to_components(sp.sympify(formula))
        translated = value.xreplace(known)
        return constant(list(translated)) if isinstance(value, sp.MatrixBase) else translated

    def images(formulas: Iterable[sp.Expr]) -> Any:
        return tuple(image(formula) for formula in formulas)

    return replace(
        separable,
        system=system,
        level=images(separable.level),
        constants=tuple(
            (known.get(symbol, symbol), image(formula)) for symbol, formula in separable.constants
        ),
        direction=image(separable.direction),
        turning=image(separable.turning),
        poles=images(separable.poles),
        weights=images(separable.weights),
        leading=image(separable.leading),
        roots=images(separable.roots),
        speeds=images(separable.speeds),
        along=None if separable.along is None else images(separable.along),
        time_rescaling=image(separable.time_rescaling),
        state=tuple((names[symbol], image(part)) for symbol, part in flat_pairs(separable.state)),
        fixed=images(separable.fixed),
        laws=(),
    )


def translation(
    home: System, system: System, parameters: Mapping[sp.Symbol, sp.Expr]
) -> dict[sp.Symbol, sp.Expr]:
    """State, parameters and definitions of one system in the symbols of another."""
    names = dict(zip(home.symbols, system.symbols, strict=True))
    return definition_values(home.scalar_definitions, {**names, **parameters})


def _constants(separable: SeparatedSystem, system: System) -> dict[sp.Symbol, sp.Symbol]:
    """New names for constants whose symbols are already used in a system."""
    names = {
        *system.symbols,
        *system.defaults,
        *(symbol for symbol, _ in system.scalar_definitions),
    }
    clashes = [symbol for symbol, _ in separable.constants if symbol in names]
    return {symbol: real_symbol(f"{symbol}_const") for symbol in clashes}
