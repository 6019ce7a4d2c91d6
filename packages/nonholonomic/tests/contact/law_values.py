"""Force, couple, power and guards of a law of friction as numbers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp

from contact.friction_formulas import ContactState
from flowlanes.system.named_formulas import flat_pairs
from flowlanes.system.vectors import to_components
from nonholonomic.contact.friction import symbols as names
from nonholonomic.contact.friction.friction_law import FrictionLaw
from nonholonomic.contact.friction.modes import Mode

#: What the course of a motion sets.
FLOORS = {names.slip_floor: 1e-9, names.rolling_floor: 1e-9}


@dataclass(frozen=True)
class LawValues:
    """The parts of a reaction, the power lost to it, and the guards by name."""

    p: Any
    q: Any
    force: Any
    couple: Any
    power: float
    guards: dict[str, float]


def law_values(
    law: FrictionLaw,
    mode: Mode,
    at: ContactState,
    normal_force: float = 1.0,
    friction: Any = (0.0, 0.0, 0.0),
    holding_couple: float = 0.0,
) -> LawValues:
    """What a law says at a contact; `friction` and `holding_couple` are what holds it."""
    wandering = -at.spread @ np.cross(at.gamma, at.rolling)
    size = np.linalg.norm(wandering)
    contour = np.cross(at.gamma, at.spread @ wandering / size) if size else np.zeros(3)
    vectors = {
        names.slip: at.slip,
        names.rolling: at.rolling,
        names.gamma: at.gamma,
        names.contour_couple: contour,
        names.friction: friction,
    }
    known = {s: float(x) for v, xs in vectors.items() for s, x in zip(v.symbols, xs, strict=True)}
    known |= FLOORS | {
        names.slip_speed: float(np.linalg.norm(at.slip)),
        names.rolling_speed: float(np.linalg.norm(at.rolling)),
        names.spin: float(at.spin),
        names.spin_sign: float(np.sign(at.spin)),
        names.N: normal_force,
        names.holding_couple: holding_couple,
    }
    known |= {p.symbol: p.default for p in law.parameters}

    def number(formula: Any) -> Any:
        components = to_components(formula)
        if isinstance(components, sp.MatrixBase):
            return np.array([float(x.xreplace(known)) for x in components])
        return float(components.xreplace(known))

    for symbol, formula in flat_pairs(law.definitions(mode)):
        known[symbol] = number(formula)
    reaction = law.reaction(mode)
    return LawValues(
        *(number(part) for part in (reaction.p, reaction.q, reaction.force, reaction.couple)),
        number(reaction.power),
        {guard.name: number(guard.value) for guard in law.guards(mode)},
    )


def random_contact_state(random: np.random.Generator) -> ContactState:
    """A contact that slides, spins and rolls."""
    gamma = random.normal(size=3)
    gamma /= np.linalg.norm(gamma)
    across = np.eye(3) - np.outer(gamma, gamma)
    root = across @ random.normal(size=(3, 3))
    return ContactState(
        across @ random.normal(size=3),
        float(random.normal()),
        across @ random.normal(size=3),
        gamma,
        root @ root.T,
    )
