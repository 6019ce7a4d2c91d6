"""The Veselova system and the rubber ball in n dimensions (§12, problem 3).

A body about a fixed point that turns only in planes through a direction γ fixed in space, ω = u ∧ γ
with (u, γ) = 0, has the momentum p = I(ω) γ, which is constant in space but for the direction γ:

    ṗ = (u, p) γ,    γ̇ = −u                                   (Fedorov and Kozlov 1995)

on the cotangent bundle of the sphere.  A ball that rolls on a hyperplane with normal γ, neither
slipping nor twisting, is the same with the inertia I + m R² (Jovanović 2009), as the operator
ω ↦ ωΓ + Γω of the marble ball leaves such ω unchanged.

u solves B u = p with a symmetric n × n matrix B, on which γγᵀ is added to make it regular.  The
density (det B)^(−1/2) of an invariant measure belongs to every operator of inertia and every n: see
:mod:`nonholonomic.catalogue.so_n.any_inertia`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from flowlanes.system.laws import Integral, Law, Measure
from flowlanes.system.matrices import Column, Jacobian, SymmetricMatrix, wedge
from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import dot, norm_squared, real_symbol

from ...mechanics.conventions import BodyConventions
from ..catalogue_entry import Values
from ..so_n.elimination import solution
from ..so_n.entry_of_dimension import (
    SOURCE,
    SQUARE,
    D,
    R,
    WithoutTwist,
    across,
    cycle,
    direction,
    momentum_and_direction,
)
from ..so_n.inertia import SMALLEST, Inertia, MassTensor, Moments, pairs
from ..so_n.mass_tensor_identities import rate_of_pencil
from ..so_n.motion_in_space import (
    angular_velocity,
    gamma_of,
    motion_in_space,
    omega_of,
    unit_length,
)
from ..so_n.theorems import of_quadratic_integrals, of_veselova
from ..so_n.three_dimensions import onto_three_dimensions
from ..so_n.weighted_integrals import lemma, weighted_integrals

HALF = sp.Rational(1, 2)
DENSITY = "invariant measure; Δ up to a constant factor"
Delta = real_symbol("Delta")


def operator(inertia: Inertia, shift: sp.Expr) -> sp.Matrix:
    """B with B e = (I(e∧γ) + added e∧γ) γ for e orthogonal to γ, and γγᵀ added."""
    n = inertia.dimension
    gamma = gamma_of(n).entries
    if isinstance(inertia, MassTensor):
        J = inertia.matrix.entries + shift / 2 * sp.eye(n)
        image = J * gamma
        return (
            J * (gamma.T * gamma)[0]
            + (gamma.T * image)[0] * sp.eye(n)
            - image * gamma.T
            - gamma * image.T
            + gamma * gamma.T
        )
    if not isinstance(inertia, Moments):
        raise TypeError(type(inertia).__name__)
    matrix = sp.Matrix(gamma * gamma.T)
    for i, j in pairs(n):
        heavier = inertia.moment(i, j) + shift
        matrix[i, i] += heavier * gamma[j] ** 2
        matrix[j, j] += heavier * gamma[i] ** 2
        matrix[i, j] -= heavier * gamma[i] * gamma[j]
        matrix[j, i] = matrix[i, j]
    return matrix


def quadratic_integrals(inertia: Inertia, p: Column) -> tuple[Pairs, tuple[Integral, ...]]:
    """The integrals besides energy and momentum for k = p∧γ, and the definitions that they use.

    With a mass tensor Σ (Jᵃp, ωJᵇγ) over a + b = m, m = 2, …, n − 2, are coefficients of the pencil
    of :mod:`nonholonomic.catalogue.so_n.quadratic_pencil`; moments have those of
    :mod:`nonholonomic.catalogue.so_n.weighted_integrals`, if any.
    """
    if isinstance(inertia, Moments):
        k = wedge(p, gamma_of(inertia.dimension))
        return (), weighted_integrals(inertia, omega_of(inertia.dimension), sp.Matrix(k))
    if not isinstance(inertia, MassTensor):
        raise TypeError(type(inertia).__name__)
    n, J = inertia.dimension, inertia.matrix
    omega, definitions = omega_of(n), []
    powers: dict[str, list[Column]] = {"g": [gamma_of(n)], "h": [p]}
    for order in range(1, n - 1 if n > SMALLEST else 1):
        for letter, vectors in powers.items():
            vectors.append(Column(f"{letter}{order}", n))
            definitions.append((vectors[-1], J * vectors[-2]))
    laws = (
        Integral(
            f"quadratic{m}",
            sp.Add(*(dot(powers["h"][a], omega * powers["g"][m - a]) for a in range(m + 1))),
            f"quadratic integral {m} of a rigid body",
            source="docs/quadratic-integrals.md",
        )
        for m in range(2, n - 1)
    )
    return tuple(definitions), tuple(laws)


@dataclass(frozen=True, kw_only=True)
class Veselova(WithoutTwist):
    """The Veselova system of every dimension; the rubber ball where it rolls."""

    def start(self, dimension: int) -> Values:
        """A generic momentum across a generic direction."""
        gamma = direction(dimension)
        return {
            "p": across(cycle((1.0, 0.7, 0.2, 0.2), dimension), gamma),
            "gamma": gamma,
        }

    def variables(self) -> Mapping[str, tuple[str, str]]:
        """Meaning and unit of the variables of the state."""
        return momentum_and_direction(self.rolls)

    def equations(self, inertia: Inertia, parameters: tuple[Parameter, ...]) -> System:
        """The equations on the cotangent bundle of the sphere, in p and γ."""
        n = inertia.dimension
        p, u, gamma, omega = Column("p", n), Column("u", n), gamma_of(n), omega_of(n)
        added = D if self.rolls else sp.S.Zero
        B = SymmetricMatrix("B", n)
        steps = solution(B.entries, list(p.symbols), list(u.symbols), Delta)
        turning = u * gamma.T - gamma * u.T
        momentum = inertia.image(omega) * gamma + added * u
        powers, quadratic = quadratic_integrals(inertia, p)
        definitions: Pairs = (
            *inertia.definitions,
            (B, sp.ImmutableDenseMatrix(operator(inertia, added))),
            *steps,
            (omega, sp.ImmutableDenseMatrix(wedge(u, gamma))),
            *powers,
        )
        laws: tuple[Law, ...] = (
            Integral("energy", HALF * dot(p, u), "energy", source=SOURCE, unit="J"),
            Integral(
                "momentum", norm_squared(p), "square of the momentum", source=SOURCE, unit=SQUARE
            ),
            *quadratic,
            Measure("measure", {Delta: -HALF}, DENSITY, source=SOURCE),
            *onto_three_dimensions(self.name, inertia, None),
        )
        return System(
            name=self.name,
            title=self.title,
            summary=f"{self.summary} {inertia.words}",
            source=SOURCE,
            parameters=(*inertia.parameters, *parameters),
            definitions=definitions,
            printed_definitions=(
                *inertia.definitions,
                (omega, turning),
                (p, momentum),
                (Delta, Jacobian(p, u, Delta)),
                *powers,
            ),
            field={p: dot(u, p) * gamma, gamma: -u},
            relations=(unit_length(gamma), sp.Add(*(a * b for a, b in zip(p, gamma, strict=True)))),
            laws=laws,
            observables=(angular_velocity(n),),
            reconstruction=motion_in_space(n, R if self.rolls else None),
            conventions=BodyConventions(
                {p: inertia.image(omega) * gamma + added * (omega * gamma)}
            ),
            theorems=(
                *of_veselova(n, Delta),
                *of_quadratic_integrals(
                    tuple(law.name for law in quadratic),
                    rate_of_pencil if isinstance(inertia, MassTensor) else lemma,
                ),
            ),
        )


VESELOVA = Veselova(name="veselova-nd")
RUBBER_BALL = Veselova(name="rubber-chaplygin-ball-nd", rolls=True)

ENTRIES = (
    VESELOVA.entry(),
    RUBBER_BALL.entry(),
)
