"""The coordinates that are known for the states of rigid bodies.

``"andoyer"``
    (L, G, H, l, g) of a momentum and γ.
``"andoyer-ratio"``
    The same as (l, L/G, g, G, H).
``"directions"``
    (theta, phi, psi, energy): the direction of γ, that of ω (a rubber contact) or of M (on a level
    of the area integral) across γ, and the energy.

So (l, L/G) are coordinates of a section g = π/2 on a level of energy and area integral::

    variables = chart(system, "andoyer-ratio")
    plane = variables.with_fixed({"g": pi / 2, "H": 0.3}).without_coordinate("G", "energy", 1.0)
    states = plane.state([[0.5, 0.1]])
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

import numpy as np

from flowlanes.arguments import Parameters
from flowlanes.errors import InputError
from flowlanes.scans.state_coordinates import ChartMaker, StateCoordinates
from flowlanes.system.arrays import FloatArray, IntArray
from flowlanes.system.system import System

from .andoyer import Andoyer
from .directions import Directions

_TURN = 2 * np.pi


def _ratio(system: System, level: Mapping[str, float], parameters: Parameters) -> StateCoordinates:
    _require_no_level("andoyer-ratio", level)
    maps = Andoyer(system)
    return StateCoordinates(
        system=system,
        parameters=parameters,
        names=maps.names,
        periods=(_TURN, 0.0, _TURN, 0.0, 0.0),
        domain="the coordinates need G > 0, -G <= H <= G and -1 <= L/G <= 1",
        all_states=maps.states,
        coordinates_of=maps.points,
        span=maps.span,
    )


def _andoyer(
    system: System, level: Mapping[str, float], parameters: Parameters
) -> StateCoordinates:
    _require_no_level("andoyer", level)
    ratio = _ratio(system, level, parameters)

    def every(points: FloatArray) -> tuple[IntArray, FloatArray]:
        L, G, H, l, g = points
        with np.errstate(invalid="ignore", divide="ignore"):
            return ratio.all_states(np.stack([l, L / G, g, G, H]))

    def point(states: FloatArray) -> FloatArray:
        l, x, g, G, H = ratio.coordinates_of(states)
        return np.stack([G * x, G, H, l, g])

    def span(name: str, others: Mapping[str, float]) -> tuple[float, float]:
        if name == "G":
            return np.maximum(np.abs(others["H"]), np.abs(others["L"])), np.inf
        return (-others["G"], others["G"]) if name == "L" else ratio.span(name, others)

    return replace(
        ratio,
        names=("L", "G", "H", "l", "g"),
        periods=(0.0, 0.0, 0.0, _TURN, _TURN),
        domain="the coordinates need G > 0, -G <= L <= G and -G <= H <= G",
        all_states=every,
        coordinates_of=point,
        span=span,
    )


def _directions(
    system: System, level: Mapping[str, float], parameters: Parameters
) -> StateCoordinates:
    maps = Directions(system, level, parameters)
    return StateCoordinates(
        system=system,
        parameters=parameters,
        names=maps.names,
        periods=(0.0, _TURN, _TURN, 0.0),
        domain="the energy must be above its least value at this gamma",
        all_states=maps.states,
        coordinates_of=maps.points,
        span=maps.span,
    )


def _require_no_level(name: str, level: Mapping[str, float]) -> None:
    if level:
        raise InputError(
            f"coordinates {name!r} are those of all states: use .with_fixed({{'H': ...}}) and "
            ".without_coordinate('G', 'energy', ...) for a level"
        )


#: The charts by name.
CHARTS: Mapping[str, ChartMaker] = MappingProxyType(
    {"andoyer": _andoyer, "andoyer-ratio": _ratio, "directions": _directions}
)
