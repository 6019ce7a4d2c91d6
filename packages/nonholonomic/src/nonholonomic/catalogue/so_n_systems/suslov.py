"""Suslov's problem in n dimensions (§12, problem 3).

A body about a fixed point turns only in planes that contain its n-th axis.  With ω_ij = 0 for
i, j < n and w_i = ω_in, a mass tensor J with the upper block J′ and the column j_i = J_in gives
(Fedorov and Kozlov 1995)

    B ẇ = (j, w) w − w² j,    B = J′ + J_nn,    γ̇ = −ωγ.

An axis is principal if j = 0; then w is constant.  Otherwise

    (j, Bw)˙ = (j, w)² − j² w² = −Σ (j_a w_b − j_b w_a)² over a < b,

so that every motion goes from the steady rotation w = sj, s > 0, to w = −sj: no measure with a
continuous positive density is invariant, and every continuous integral of ẇ is a function of the
energy.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from flowlanes.system.laws import Identity, Integral, Law, Measure, Rate
from flowlanes.system.matrices import Blocks, Column, SymmetricMatrix
from flowlanes.system.named_formulas import Pairs, scalars
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import Components, dot, norm_squared

from ...mechanics.conventions import BodyConventions
from ..catalogue_entry import Values
from ..so_n.elimination import elimination
from ..so_n.entry_of_dimension import SOURCE, Family, cycle, direction
from ..so_n.inertia import Inertia, MassTensor, Moments
from ..so_n.motion_in_space import (
    angular_velocity,
    gamma_of,
    motion_in_space,
    omega_of,
    unit_length,
)
from ..so_n.theorems import of_suslov

HALF = sp.Rational(1, 2)


@dataclass(frozen=True, kw_only=True)
class Suslov(Family):
    """Suslov's problem of every dimension."""

    def start(self, dimension: int) -> Values:
        """A generic velocity and direction."""
        return {"w": cycle((0.9, -0.5, 0.4), dimension - 1), "gamma": direction(dimension)}

    def variables(self) -> Mapping[str, tuple[str, str]]:
        """Meaning and unit of the variables of the state."""
        return {
            "w": ("angular velocity in planes with the last body axis", "rad/s"),
            "gamma": ("direction fixed in space, body axes", "1"),
        }

    @property
    def constraint(self) -> str:
        """The condition on ω."""
        return "it must turn in planes with the last body axis alone"

    def admissible(self, omega: Sequence[Sequence[Any]], gamma: Sequence[Any]) -> list[list[Any]]:
        """Its last row and column alone."""
        last = len(omega) - 1
        return [
            [x if last in (i, j) else 0 * x for j, x in enumerate(row)]
            for i, row in enumerate(omega)
        ]

    def equations(self, inertia: Inertia, parameters: tuple[Parameter, ...]) -> System:
        """The equations in w and γ."""
        n = inertia.dimension
        w, gamma, omega = Column("w", n - 1), gamma_of(n), omega_of(n)
        spin = sp.zeros(n)
        for i, s in enumerate(w.symbols):
            spin[i, n - 1], spin[n - 1, i] = s, -s
        solved, page, rate, laws = (
            _by_mass_tensor(inertia, w)
            if isinstance(inertia, MassTensor)
            else _principal(inertia, w)
        )
        return System(
            name=self.name,
            title=self.title,
            summary=f"{self.summary} {inertia.words}",
            source=SOURCE,
            parameters=(*inertia.parameters, *parameters),
            definitions=(*solved, (omega, sp.ImmutableDenseMatrix(spin))),
            printed_definitions=(*page, *_spin_shown(omega, w)),
            field={w: rate, gamma: -omega * gamma},
            relations=(unit_length(gamma),),
            laws=laws,
            observables=(angular_velocity(n),),
            reconstruction=motion_in_space(n),
            conventions=BodyConventions(
                {w: Components([omega.entries[i, n - 1] for i in range(n - 1)])}
            ),
            theorems=of_suslov(n) if isinstance(inertia, MassTensor) else (),
        )


def _spin_shown(omega: sp.MatrixSymbol, w: Column) -> Pairs:
    """ω with its only column w."""
    size = int(omega.shape[0]) - 1
    return ((omega, Blocks([[sp.ZeroMatrix(size, size), w], [-w.T, sp.S.Zero]])),)


def _volume(on: tuple[sp.Expr, ...]) -> Measure:
    return Measure(
        "volume",
        {sp.S.One: sp.S.One},
        "volume of w and γ, when the last body axis is a principal axis",
        level=on,
        source=SOURCE,
    )


def _energy(value: sp.Expr) -> Integral:
    return Integral("energy", value, "energy", source=SOURCE, unit="J")


def _by_mass_tensor(
    inertia: MassTensor, w: Column
) -> tuple[Pairs, Pairs, sp.MatrixExpr, tuple[Law, ...]]:
    """Definitions, their printed form, the rate of w, and the laws."""
    n = inertia.dimension
    entries = inertia.matrix.entries
    j, acceleration = Column("j", n - 1), Column("wdot", n - 1)
    B, M = SymmetricMatrix("B", n - 1), Column("M", n - 1)
    block = Components(entries[: n - 1, : n - 1] + entries[n - 1, n - 1] * sp.eye(n - 1))
    torque = dot(j, w) * w - norm_squared(w) * j
    steps, _ = elimination(B.entries, scalars(torque), list(acceleration.symbols))
    first = (
        (j, Components(entries[: n - 1, n - 1])),
        (B, block),
        (M, B * w),
    )
    laws = (
        _energy(HALF * dot(M, w)),
        Identity(
            "monotone",
            Rate(dot(j, M)) - dot(j, w) ** 2 + norm_squared(j) * norm_squared(w),
            "the momentum along j never grows",
            source=SOURCE,
        ),
        _volume(tuple(entries[: n - 1, n - 1])),
    )
    upper, last = SymmetricMatrix("A", n - 1), entries[n - 1, n - 1]
    page = (
        (inertia.matrix, Blocks([[upper, j], [j.T, last]])),
        (B, upper + last * sp.Identity(n - 1)),
        (B * acceleration, torque),
        first[2],
    )
    return (*first, *steps), page, acceleration, laws


def _principal(inertia: Inertia, w: Column) -> tuple[Pairs, Pairs, sp.MatrixExpr, tuple[Law, ...]]:
    """These for moments in the coordinate planes: the last body axis is a principal axis."""
    if not isinstance(inertia, Moments):
        raise TypeError(type(inertia).__name__)
    n = inertia.dimension
    energy = HALF * sp.Add(*(inertia.moment(i, n - 1) * s**2 for i, s in enumerate(w.symbols)))
    still = Components([0] * (n - 1))
    return inertia.definitions, inertia.definitions, still, (_energy(energy), _volume(()))


SUSLOV = Suslov(name="suslov-nd", tensor_by_default=True)

ENTRIES = (SUSLOV.entry(),)
