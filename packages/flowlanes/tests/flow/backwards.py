"""That a change of signs makes the motions run backwards, as an identity for the prover."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from flowlanes.system.laws import Identity, Rate
from flowlanes.system.system import System


def runs_backwards(system: System, signs: Mapping[sp.Symbol, int]) -> Identity:
    """v(Rx) = −R v(x) for the state x, and parameters with their signs changed as well."""
    turned = {symbol: sign * symbol for symbol, sign in signs.items()}
    rates = (system.expand(rate).xreplace(turned) for rate in system.rates)
    return Identity(
        "reversal",
        tuple(
            rate + signs.get(symbol, 1) * Rate(symbol)
            for symbol, rate in zip(system.symbols, rates, strict=True)
        ),
    )
