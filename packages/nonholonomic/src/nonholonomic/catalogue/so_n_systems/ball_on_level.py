"""The Chaplygin ball in n dimensions without momentum in planes across γ (§12, problem 3).

The momentum k of the ball about its contact point is constant in space.  Where its part in the
planes of the hyperplane is zero, k = p∧γ with (p, γ) = 0, and this stays so: the equations become

    ṗ = −ωp,    γ̇ = −ωγ,    I(ω) + m R² (ω Γ + Γ ω) = p∧γ,    Γ = γ γᵀ,

on the cotangent bundle of the sphere.  A rigid body has n − 1 independent quadratic integrals
there, as the Veselova top has (docs/quadratic-integrals.md), and the measure is that of the ball.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from flowlanes.system.laws import Integral, Law, Measure
from flowlanes.system.matrices import Column, Jacobian, MatrixProduct, wedge
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import norm_squared

from ..catalogue_entry import Values
from ..so_n.entry_of_dimension import (
    SOURCE,
    SQUARE,
    Family,
    R,
    across,
    cycle,
    direction,
    momentum_and_direction,
)
from ..so_n.inertia import Inertia
from ..so_n.motion_in_space import (
    angular_velocity,
    gamma_of,
    motion_in_space,
    omega_of,
    unit_length,
)
from ..so_n.theorems import of_ball_on_level, of_quadratic_integrals
from ..so_n.weighted_integrals import lemma
from .chaplygin_ball import Delta, momentum_of, velocity_steps
from .veselova import DENSITY, HALF, quadratic_integrals


@dataclass(frozen=True, kw_only=True)
class BallOnLevel(Family):
    """The Chaplygin ball of every dimension on the level k = p∧γ."""

    def start(self, dimension: int) -> Values:
        """A generic momentum across a generic direction."""
        gamma = direction(dimension)
        return {"p": across(cycle((1.0, 0.7, 0.2, 0.2), dimension), gamma), "gamma": gamma}

    def variables(self) -> Mapping[str, tuple[str, str]]:
        """Meaning and unit of the variables of the state."""
        return momentum_and_direction(self.rolls)

    def equations(self, inertia: Inertia, parameters: tuple[Parameter, ...]) -> System:
        """The equations on the cotangent bundle of the sphere, in p and γ."""
        n = inertia.dimension
        p, k, gamma, omega = Column("p", n), momentum_of(n), gamma_of(n), omega_of(n)
        steps, page = velocity_steps(inertia)
        powers, quadratic = quadratic_integrals(inertia, p)
        laws: tuple[Law, ...] = (
            Integral("energy", HALF * MatrixProduct(k, omega), "energy", source=SOURCE, unit="J"),
            Integral(
                "momentum", norm_squared(p), "square of the momentum", source=SOURCE, unit=SQUARE
            ),
            *quadratic,
            Measure("measure", {Delta: -HALF}, DENSITY, source=SOURCE),
        )
        return System(
            name=self.name,
            title=self.title,
            summary=f"{self.summary} {inertia.words}",
            source=SOURCE,
            parameters=(*inertia.parameters, *parameters),
            definitions=((k, sp.ImmutableDenseMatrix(wedge(p, gamma))), *steps, *powers),
            printed_definitions=(
                (k, p * gamma.T - gamma * p.T),
                *page,
                (Delta, Jacobian(k, omega, Delta)),
                *powers,
            ),
            field={p: -omega * p, gamma: -omega * gamma},
            relations=(unit_length(gamma), sp.Add(*(a * b for a, b in zip(p, gamma, strict=True)))),
            laws=laws,
            observables=(angular_velocity(n),),
            reconstruction=motion_in_space(n, R),
            theorems=(
                *of_ball_on_level(n, Delta),
                *of_quadratic_integrals(tuple(law.name for law in quadratic), lemma),
            ),
        )


BALL = BallOnLevel(name="chaplygin-ball-on-level-nd", rolls=True, tensor_by_default=True)

ENTRIES = (BALL.entry(),)
