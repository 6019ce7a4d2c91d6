"""Admissible parameters and starts at random, for every system of the catalogue."""

from __future__ import annotations

import numpy as np

from chaplygin.mechanics.start import starting_state
from chaplygin.system import System
from chaplygin.systems import Entry

#: A hollow ball of twice the radius of its sphere: the case k = −1 is kept.
TWICE = ("ball-around-sphere", "rubber-ball-around-sphere")


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


def random_start(system: System, entry: Entry, rng: np.random.Generator) -> tuple[object, ...]:
    """A state not far from the start of the catalogue."""
    gamma = np.array(entry.start.gamma) + rng.uniform(-0.2, 0.2, 3)
    gamma /= np.linalg.norm(gamma)
    omega = np.array(entry.start.omega) + rng.uniform(-0.3, 0.3, 3)
    if "rubber" in entry.name or entry.name == "veselova":
        omega -= (omega @ gamma) * gamma
    return starting_state(system, tuple(omega), tuple(gamma))
