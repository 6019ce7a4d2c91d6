"""The Chaplygin ball in n dimensions (§12, problem 3): a ball that rolls on a hyperplane.

The angular velocity ω, body axes, is a skew matrix, and γ a unit vector fixed in space: γ̇ = −ωγ.
A ball of radius R that rolls without slipping on a hyperplane with normal γ has the velocity Rωγ of
its centre, so that its momentum about the contact point,

    k = I(ω) + m R² (ω Γ + Γ ω),    Γ = γ γᵀ,    k̇ = k ω − ω k,

is constant in space (Fedorov and Kozlov 1995).  With moments I_ij, u = ωγ solves n linear equations
B u = f, where f = I⁻¹(k) γ; with a mass tensor, k = T ω + ω T where T = J + m R² Γ.

The density (det B)^(−1/2) of an invariant measure belongs to every operator of inertia and every n:
see :mod:`nonholonomic.catalogue.so_n.any_inertia`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from flowlanes.system.laws import Integral, Law, Measure
from flowlanes.system.matrices import Column, Jacobian, MatrixProduct, Skew, SymmetricMatrix, wedge
from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import outer
from flowlanes.system.vectors import real_symbol

from ...mechanics.conventions import BodyConventions
from ..catalogue_entry import Values
from ..so_n.elimination import solution
from ..so_n.entry_of_dimension import MOMENTUM, SOURCE, D, Family, R, cycle, direction
from ..so_n.inertia import Inertia, MassTensor, Moments, pairs
from ..so_n.invariants import invariants
from ..so_n.motion_in_space import (
    angular_velocity,
    gamma_of,
    motion_in_space,
    omega_of,
    unit_length,
)
from ..so_n.theorems import of_ball
from ..so_n.three_dimensions import onto_three_dimensions

HALF = sp.Rational(1, 2)
DENSITY = "invariant measure; Δ up to a constant factor"
Delta = real_symbol("Delta")


def momentum_of(dimension: int) -> Skew:
    """The momentum k about the contact point, body axes."""
    return Skew("k", dimension)


def by_moments(inertia: Moments) -> tuple[Pairs, Pairs]:
    """ω by n linear equations: the steps, and their printed form."""
    n = inertia.dimension
    k, omega, gamma, u = momentum_of(n), omega_of(n), gamma_of(n), Column("u", n)
    B, y = SymmetricMatrix("B", n), gamma.symbols
    matrix = sp.eye(n)
    for i, j in pairs(n):
        share = D / inertia.moment(i, j)
        matrix[i, i] += share * y[j] ** 2
        matrix[j, j] += share * y[i] ** 2
        matrix[i, j] = matrix[j, i] = -share * y[i] * y[j]
    entries = k.entries
    free = sp.Matrix(
        n, n, lambda i, j: entries[i, j] / inertia.moment(i, j) if i != j else sp.S.Zero
    )
    steps = solution(B.entries, list(free * gamma.entries), list(u.symbols), Delta)
    turned = wedge(u, gamma)
    spin = sp.Matrix(
        n,
        n,
        lambda i, j: (entries[i, j] - D * turned[i, j]) / inertia.moment(i, j) if i != j else 0,
    )
    around = outer(gamma, gamma)
    definitions = (
        *inertia.definitions,
        (B, sp.ImmutableDenseMatrix(matrix)),
        *steps,
        (omega, sp.ImmutableDenseMatrix(spin)),
    )
    page = (
        *inertia.definitions,
        (k, inertia.image(omega) + D * (omega * around + around * omega)),
    )
    return definitions, page


def by_mass_tensor(inertia: MassTensor) -> tuple[Pairs, Pairs]:
    """ω by n(n − 1)/2 linear equations T ω + ω T = k."""
    n = inertia.dimension
    k, omega, gamma = momentum_of(n), omega_of(n), gamma_of(n)
    T = SymmetricMatrix("T", n)
    places = pairs(n)
    columns = []
    for a, b in places:
        unit = sp.zeros(n)
        unit[a, b], unit[b, a] = 1, -1
        image = T.entries * unit + unit * T.entries
        columns.append([image[i, j] for i, j in places])
    steps = solution(sp.Matrix(columns).T, list(k.symbols), list(omega.symbols), Delta)
    tensor = inertia.matrix + D * outer(gamma, gamma)
    definitions = ((T, tensor), *steps)
    return definitions, ((k, T * omega + omega * T), (T, tensor))


def velocity_steps(inertia: Inertia) -> tuple[Pairs, Pairs]:
    """ω by the momentum: the steps, and their printed form."""
    match inertia:
        case MassTensor():
            return by_mass_tensor(inertia)
        case Moments():
            return by_moments(inertia)
    raise TypeError(type(inertia).__name__)


@dataclass(frozen=True, kw_only=True)
class ChaplyginBall(Family):
    """The Chaplygin ball of every dimension."""

    def start(self, dimension: int) -> Values:
        """A generic momentum and direction."""
        return {
            "k": cycle((1.0, -0.6, 0.3, 0.8, -0.2, 1.4), len(pairs(dimension))),
            "gamma": direction(dimension),
        }

    def variables(self) -> Mapping[str, tuple[str, str]]:
        """Meaning and unit of the variables of the state."""
        return {
            "k": ("momentum about the contact point", MOMENTUM),
            "gamma": ("normal of the hyperplane, body axes", "1"),
        }

    def equations(self, inertia: Inertia, parameters: tuple[Parameter, ...]) -> System:
        """The equations reduced by the translations, in k and γ."""
        n = inertia.dimension
        k, omega, gamma = momentum_of(n), omega_of(n), gamma_of(n)
        solved, page = velocity_steps(inertia)
        named, integrals = invariants(k, gamma)
        energy = HALF * MatrixProduct(k, omega)
        laws: tuple[Law, ...] = (
            Integral("energy", energy, "energy", source=SOURCE, unit="J"),
            *integrals,
            Measure("measure", {Delta: -HALF}, DENSITY, source=SOURCE),
            *onto_three_dimensions(self.name, inertia, k),
        )
        around = outer(gamma, gamma)
        return System(
            name=self.name,
            title=self.title,
            summary=f"{self.summary} {inertia.words}",
            source=SOURCE,
            parameters=(*inertia.parameters, *parameters),
            definitions=(*solved, *named),
            printed_definitions=(
                *page,
                (Delta, Jacobian(k, omega, Delta)),
                *named,
            ),
            field={k: k * omega - omega * k, gamma: -omega * gamma},
            relations=(unit_length(gamma),),
            laws=laws,
            observables=(angular_velocity(n),),
            reconstruction=motion_in_space(n, R),
            conventions=BodyConventions(
                {k: inertia.image(omega) + D * (omega * around + around * omega)}
            ),
            theorems=of_ball(n, Delta, tuple(law.name for law in integrals)),
        )


BALL = ChaplyginBall(name="chaplygin-ball-nd", rolls=True)

ENTRIES = (BALL.entry(),)
