"""Balls of n dimensions that roll on or in a sphere (§12, problem 3).

The normal γ of a sphere of radius a at the contact with a ball of radius R has, in body axes,

    γ̇ = −εωγ,    ε = a/(R + a),

with a < 0 inside; a hollow ball that surrounds the sphere has |a| < R.  For a ball that does not
slip the momentum about the contact point stays constant in space, k̇ = [k, ω], as on a plane.  If it
does not twist either, ω = u∧γ and p = kγ obey (Jovanović 2018)

    ṗ = (u, p)γ + (1 − ε)ku,    γ̇ = −εu,    k = I(ω) + m R² ω.

The densities of the invariant measures are (det ∂k/∂ω)^(−1/2) and (det ∂p/∂u)^(1/(2ε) − 1), for any
operator of inertia and every n: see :mod:`nonholonomic.catalogue.so_n.any_inertia`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Integral, Measure, of_kind
from flowlanes.system.matrices import Column, Skew
from flowlanes.system.system import Observable, Parameter, Reconstruction, System
from flowlanes.system.vectors import Components, dot, real_symbol

from ..catalogue_entry import Numbers
from ..so_n.entry_of_dimension import SOURCE, D, Family, R
from ..so_n.equal_radii import bracket, hamiltonian
from ..so_n.inertia import Inertia
from ..so_n.motion_in_space import attitude_of, gamma_of, omega_of
from ..so_n.theorems import of_ball, of_rubber_ball_on_sphere
from .chaplygin_ball import DENSITY, ChaplyginBall, Delta, momentum_of
from .veselova import Veselova

a, epsilon = real_symbol("a"), real_symbol("epsilon")
HALF = sp.Rational(1, 2)
#: Radius of the sphere in the example, m.
SPHERE = 2.0
NORMAL = ("outward normal of the sphere at the contact, body axes", "1")


@dataclass(frozen=True, kw_only=True)
class OnSphere(Family):
    """The properties of balls on a sphere that differ from those of balls on a hyperplane."""

    #: Radius of the sphere in the example, m.
    sphere: float = SPHERE

    @property
    def upright(self) -> bool:
        """The normal of a sphere moves in space."""
        return False

    @property
    def settings(self) -> tuple[str, ...]:
        """The radius of the sphere, too."""
        return (*super().settings, "a")

    def _ball(self, settings: dict[str, object]) -> dict[str, float]:
        given = settings.pop("a", self.sphere)
        numbers = super()._ball(settings)
        sphere = float(given) if isinstance(given, int | float) else float("nan")
        if not abs(sphere) < float("inf") or sphere in (0.0, -numbers["R"]):
            raise InputError(
                f"a: must be the radius of the sphere, negative for a ball inside, and neither 0 "
                f"nor {-numbers['R']:g}, where the ball fills it; it is {given!r}"
            )
        return {**numbers, "a": sphere}

    def _ball_parameters(self, values: Numbers) -> tuple[Parameter, ...]:
        meaning = "radius of the sphere, negative inside"
        sphere = Parameter(a, meaning, values["a"], "m", (sp.Ne(a, 0), sp.Ne(a + R, 0)))
        return (*super()._ball_parameters(values), sphere)


def lift(n: int) -> Reconstruction:
    """The attitude, of which γ is no row, and the contact point.

    Parameters
    ----------
    n : int
        The dimension of space.
    """
    g = attitude_of(n)
    point = Components(a * g.entries * gamma_of(n).entries)
    rows = [g.entries.row(i) for i in range(n)]
    return Reconstruction(
        field={g: g * omega_of(n)},
        relations=tuple(
            (rows[i] * rows[j].T)[0] - int(i == j) for i in range(n) for j in range(i, n)
        ),
        observables=(
            Observable(
                "contact", point, "contact point from the sphere's centre", "m", "space_axis"
            ),
        ),
    )


#: ε, as it stands before the definitions of a ball.
RATIO = (epsilon, a / (R + a))


@dataclass(frozen=True, kw_only=True)
class BallOnSphere(OnSphere, ChaplyginBall):
    """The marble ball on a sphere of every dimension."""

    def variables(self) -> Mapping[str, tuple[str, str]]:
        """Meaning and unit of the variables of the state."""
        return {**super().variables(), "gamma": NORMAL}

    def equations(self, inertia: Inertia, parameters: tuple[Parameter, ...]) -> System:
        """The equations in k and γ."""
        n = inertia.dimension
        *ball, _ = parameters
        plain = super().equations(inertia, tuple(ball))
        k, omega, gamma = momentum_of(n), omega_of(n), gamma_of(n)
        laws = tuple(law for law in plain.laws if not law.name.startswith("lever"))
        kept = tuple(x.name for x in of_kind(laws, Integral) if x.name != "energy")
        # kγ, k²γ, … are not constant in space
        levers = {name for name, _ in plain.definitions if isinstance(name, Column)} - {
            Column("u", n)
        }
        return replace(
            plain,
            parameters=(*inertia.parameters, *parameters),
            definitions=(RATIO, *(pair for pair in plain.definitions if pair[0] not in levers)),
            printed_definitions=(
                RATIO,
                *(pair for pair in plain.printed_definitions if pair[0] not in levers),
            ),
            field={k: k * omega - omega * k, gamma: -epsilon * (omega * gamma)},
            laws=laws,
            reconstruction=lift(n),
            theorems=of_ball(n, Delta, kept),
        )


@dataclass(frozen=True, kw_only=True)
class RubberBallOnSphere(OnSphere, Veselova):
    """The rubber ball on a sphere of every dimension."""

    def variables(self) -> Mapping[str, tuple[str, str]]:
        """Meaning and unit of the variables of the state."""
        return {**super().variables(), "gamma": NORMAL}

    def equations(self, inertia: Inertia, parameters: tuple[Parameter, ...]) -> System:
        """The equations in p and γ."""
        n = inertia.dimension
        *ball, _ = parameters
        plain = super().equations(inertia, tuple(ball))
        p, u, gamma, omega, k = (
            Column("p", n),
            Column("u", n),
            gamma_of(n),
            omega_of(n),
            Skew("k", n),
        )
        energy = next(law for law in plain.integrals if law.name == "energy")
        density = {Delta: HALF / epsilon - 1}
        powers = {name for name, _ in plain.definitions if str(name)[0] in "gh"} - {gamma}
        momentum = (k, inertia.image(omega) + D * omega)
        page = [pair for pair in plain.printed_definitions if pair[0] not in {*powers, p}]
        return replace(
            plain,
            parameters=(*inertia.parameters, *parameters),
            definitions=(
                RATIO,
                *(pair for pair in plain.definitions if pair[0] not in powers),
                momentum,
            ),
            printed_definitions=(RATIO, *page[:-1], momentum, (p, k * gamma), page[-1]),
            field={p: dot(u, p) * gamma + (1 - epsilon) * (k * u), gamma: -epsilon * u},
            laws=(
                energy,
                Measure("measure", density, DENSITY, source=SOURCE),
                bracket(p),
                hamiltonian(p, energy.value),
                *plain.laws_of(Isomorphism),
            ),
            reconstruction=lift(n),
            theorems=of_rubber_ball_on_sphere(n, Delta),
        )


BALL = BallOnSphere(name="chaplygin-ball-on-sphere-nd", rolls=True)
RUBBER_BALL = RubberBallOnSphere(name="rubber-ball-on-sphere-nd", rolls=True)

ENTRIES = (
    BALL.entry(),
    RUBBER_BALL.entry(),
)
