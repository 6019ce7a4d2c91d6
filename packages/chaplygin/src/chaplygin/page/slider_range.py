"""Ranges of sliders."""

from __future__ import annotations

import math

import sympy as sp

from flowlanes.system.parameters import satisfies
from flowlanes.system.system import Parameter, System

#: Factor by which a slider extends beyond the value.
_FACTOR = 3.0


def parameter_range(parameter: Parameter, system: System) -> tuple[float, float]:
    """The range of the slider of a parameter, with round ends.

    Conditions that compare several parameters restrict it further; the engine checks them.
    """
    value = float(parameter.default)
    low, high = value_range(value)
    own = [
        sp.sympify(condition)
        for item in system.parameters
        for condition in item.admissible
        if sp.sympify(condition).free_symbols == {parameter.symbol}
    ]

    def is_admissible(x: float) -> bool:
        return all(bool(satisfies(condition, {parameter.symbol: x})) for condition in own)

    if value > 0.0 and not is_admissible(-value):
        low = round_number(value / (2.0 * _FACTOR))
    while not is_admissible(high) and high > value:
        high = value + (high - value) / 2.0 if high - value > 1e-6 * abs(value) else value
    return low, high


def value_range(value: float) -> tuple[float, float]:
    """A round range around a value."""
    if value == 0.0:
        return -1.0, 1.0
    reach = round_number(_FACTOR * abs(value))
    return -reach, reach


def round_number(value: float) -> float:
    """The nearest of 1, 1.5, 2, 3, 5 times a power of ten."""
    power = 10.0 ** math.floor(math.log10(value))
    return min((s * power for s in (1.0, 1.5, 2.0, 3.0, 5.0, 10.0)), key=lambda x: abs(x - value))
