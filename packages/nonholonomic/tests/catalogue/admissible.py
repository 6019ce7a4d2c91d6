"""Admissible parameters and starts at random, for every system of the catalogue."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np

from catalogue import built
from catalogue.built import Example, example_of
from evaluation import on_conditions, parameter_values
from flowlanes.system.system import System
from flowlanes.system.vectors import to_components, vectors
from nonholonomic.catalogue import Entry

#: A hollow ball of twice the radius of its sphere: the case k = −1 is kept.
TWICE = ("ball-around-sphere", "ball-around-sphere-bruns", "rubber-ball-around-sphere")

omega, gamma = vectors("omega gamma")


def random_parameters(entry: Entry, rng: np.random.Generator) -> dict[str, float]:
    """Every parameter up to a quarter away from its default; the inertia that of a rigid body."""
    numbers = {name: x * rng.uniform(0.8, 1.25) for name, x in entry.defaults.items()}
    if entry.name in TWICE:
        numbers["R"] = 2 * numbers["a"]
    return numbers | _random_inertia(entry, rng)


def _random_inertia(entry: Entry, rng: np.random.Generator) -> dict[str, float]:
    """Moments of inertia of three pairs of masses on the axes, each scaled on its own."""
    names = [name for name in ("I_1", "I_2", "I_3") if name in entry.defaults]
    first, third = entry.defaults["I_1"], entry.defaults["I_3"]
    second = entry.defaults.get("I_2", first)
    half = (first + second + third) / 2
    x, y, z = ((half - moment) * rng.uniform(0.8, 1.25) for moment in (first, second, third))
    if "I_2" not in names:
        y = x
    moments = {"I_1": y + z, "I_2": x + z, "I_3": x + y}
    return {name: moments[name] for name in names}


def random_example(
    entry: Entry, rng: np.random.Generator, parameters: dict[str, float] | None = None
) -> Example:
    """The system with a start not far from that of the catalogue."""
    system = entry.system(parameters)
    choose = _random_velocity if entry.start.state is None else _random_state
    return example_of(entry, system, choose(system, entry, rng))


def _random_velocity(
    system: System, entry: Entry, rng: np.random.Generator
) -> dict[str, list[float]]:
    """ω and γ, with the constraint that the relations put on ω."""
    given = (*entry.start.omega, *entry.start.gamma)
    reach = np.repeat([0.3, 0.2], 3)
    names = (*omega.symbols, *gamma.symbols)
    known = dict(zip(names, given + reach * rng.uniform(-1, 1, 6), strict=True))
    constraints = [r for r in system.relations if to_components(r).free_symbols & set(names)]
    found = _projected(system, constraints, known)
    return {str(vector): [float(found[s]) for s in vector.symbols] for vector in (omega, gamma)}


def _random_state(system: System, entry: Entry, rng: np.random.Generator) -> dict[str, Any]:
    """The variables of the state, on the phase space."""
    example = built.example(entry.name).reduced_start
    size = max(map(abs, map(float, example)))
    known = {
        symbol: float(x) + 0.05 * size * rng.uniform(-1, 1)
        for symbol, x in zip(system.symbols, example, strict=True)
    }
    found = _projected(system, system.relations, known)
    return {
        str(name): float(found[name]) if name in found else [float(found[s]) for s in name.symbols]
        for name in system.state
    }


def _projected(system: System, conditions: Any, known: dict[Any, float]) -> dict[Any, Any]:
    with mpmath.workdps(30):
        state = {symbol: mpmath.mpf(x) for symbol, x in known.items()}
        point = state | parameter_values(system, mpmath.mpf)
        return on_conditions(system, [to_components(c) for c in conditions], point, tuple(state))
