"""Andoyer variables of a momentum M and a unit vector γ, both in body axes.

L = M₃, G = |M|, H = (M, γ); M₁ = √(G² − L²) sin l, M₂ = √(G² − L²) cos l; g is the angle about M
from the line of nodes e₃ × M to the line of nodes M × γ.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray, IntArray
from flowlanes.system.system import System
from flowlanes.system.vectors import Vector

#: Below this the sine of an angle is rounding, and the corresponding rotation angle is undefined.
_FLAT = 1e-7


class Andoyer:
    """Maps between states and (l, L/G, g, G, H).

    Parameters
    ----------
    system : System
        Its state must be a momentum and the unit vector γ (or Γ).

    Raises
    ------
    InputError
        If it is not.
    """

    names = ("l", "L/G", "g", "G", "H")

    def __init__(self, system: System) -> None:
        self.size = len(system.symbols)
        self.momentum, self.normal = momentum_of(system)

    def states(self, points: FloatArray) -> tuple[IntArray, FloatArray]:
        """Indices of the points (5, k) that have a state, and these states (size, n)."""
        l, x, g, G, H = points
        here = np.flatnonzero((G > 0) & (np.abs(H) <= G) & (np.abs(x) <= 1))
        l, x, g, G, H = points[:, here]
        y = H / G
        s, c = np.sqrt((1 - x) * (1 + x)), np.sqrt((1 - y) * (1 + y))
        across = y * s + c * x * np.cos(g)
        along = c * np.sin(g)
        states = np.zeros((self.size, here.size))
        states[self.momentum] = G * np.stack([s * np.sin(l), s * np.cos(l), x])
        states[self.normal] = np.stack(
            [
                across * np.sin(l) + along * np.cos(l),
                across * np.cos(l) - along * np.sin(l),
                y * x - s * c * np.cos(g),
            ]
        )
        return here, states

    def points(self, states: FloatArray) -> FloatArray:
        """(l, L/G, g, G, H) of states (size, k); NaN for undefined angles."""
        M, gamma = states[self.momentum], states[self.normal]
        with np.errstate(invalid="ignore", divide="ignore"):
            G = np.sqrt((M * M).sum(axis=0))
            m = M / G
        H = (M * gamma).sum(axis=0)
        level = np.hypot(m[0], m[1])
        l = np.where(level > _FLAT, np.arctan2(m[0], m[1]), np.nan)
        along = gamma[0] * np.cos(l) - gamma[1] * np.sin(l)
        across = (gamma[0] * np.sin(l) + gamma[1] * np.cos(l)) * m[2] - gamma[2] * level
        g = np.where(np.hypot(along, across) > _FLAT, np.arctan2(along, across), np.nan)
        return np.stack([l, m[2], g, G, H])

    @staticmethod
    def span(name: str, others: Mapping[str, float]) -> tuple[float, float]:
        """The range of one variable, given the others."""
        if name == "G":
            return np.abs(others["H"]), np.inf
        if name == "H":
            return -others["G"], others["G"]
        return (-1.0, 1.0) if name == "L/G" else (0.0, 2 * np.pi)


def momentum_of(system: System) -> tuple[list[int], list[int]]:
    """Indices of the momentum and of the unit vector in the flat state.

    Raises
    ------
    InputError
        If the state is not a momentum and γ.
    """
    vectors = {v.name: v for v in system.state if isinstance(v, Vector)}
    normal = next((vectors[name] for name in ("gamma", "Gamma") if name in vectors), None)
    momentum = next((vectors[name] for name in ("M", "L", "K") if name in vectors), None)
    if normal is None or momentum is None or len(system.symbols) != 6:
        raise InputError(
            f"{system.name}: Andoyer variables need a momentum and a unit vector gamma as state, "
            f"not {', '.join(map(str, system.state))}"
        )
    places = {symbol: i for i, symbol in enumerate(system.symbols)}
    first, second = ([places[s] for s in v.symbols] for v in (momentum, normal))
    return first, second
