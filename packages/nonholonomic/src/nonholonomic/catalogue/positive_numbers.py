"""Numbers of a mechanism that must be positive: masses, moments of inertia, lengths."""

from __future__ import annotations

import math

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.system import Parameter

from ..mechanics.rolling.body import check_mass


def positive(symbol: sp.Symbol, meaning: str, value: float, unit: str) -> Parameter:
    """A parameter that must be positive.

    Raises
    ------
    InputError
        If it is not, or not finite.
    """
    if unit == "kg":
        check_mass(value)
    if not (math.isfinite(value) and value > 0):
        raise InputError(f"{meaning} {symbol} = {value}: it must be a positive finite number")
    return Parameter(symbol, meaning, value, unit, (symbol > 0,))
