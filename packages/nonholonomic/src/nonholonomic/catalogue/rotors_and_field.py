"""Parameters of rotors and of Bruns' field, wherever a body is given both."""

from __future__ import annotations

from collections.abc import Mapping

from flowlanes.system.system import Parameter
from flowlanes.system.vectors import Vector, real_symbol

k = Vector("k")
K = real_symbol("K")


def rotors_and_field(numbers: Mapping[str, float]) -> tuple[Parameter, ...]:
    """k₁, k₂, k₃ and K with the given values by symbol name.

    Examples
    --------
    >>> [str(p.symbol) for p in rotors_and_field({"k_1": 0.1, "k_2": 0, "k_3": 0, "K": 2.0})]
    ['k_1', 'k_2', 'k_3', 'K']
    """
    rotors = (
        Parameter(s, f"gyrostatic momentum, body axis {i}", numbers[str(s)], "kg m^2/s")
        for i, s in enumerate(k.symbols, 1)
    )
    return (*rotors, Parameter(K, "strength of the Bruns field", numbers["K"], "1/s^2"))
