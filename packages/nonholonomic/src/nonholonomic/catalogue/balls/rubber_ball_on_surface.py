"""A homogeneous rubber ball on a surface (§2.3): its centre is a particle on the parallel surface.

Everything is written in space axes.  The centre R moves on a surface f = 0, whose unit normal
n = ∇f/|∇f| points away from the supporting surface; r = −bn leads to the contact point.  With the
reactions N and N₀r of both constraints the equations of motion are

    m v̇ = N + F,      μ ω̇ = r×N + N₀r,      v = r×ω,      (ω, r) = 0.

The constraints give b²ω = v×r, N − (N, n)n = −(μ/b²)/(m + μ/b²) (F − (F, n)n) and
N₀ = μ(ω, ṅ)/b.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Identity, Integral, Law
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import unit_vector
from flowlanes.system.vectors import constant, cross, dot, real_symbol, vectors

from ...mechanics.ball.ball import RollingBall
from ...mechanics.ball.equations import ball_equations, ball_parameters, centre_surface
from ..vector_rates import rate
from .ball_on_any_surface import TANGENT, particle, tangential

R, omega, v, n, r, N, F = vectors("R omega v n r N F")
m, mu, b, g, N_0, mtilde = (real_symbol(name) for name in ("m", "mu", "b", "g", "N_0", "mtilde"))
x, y, z = R.symbols

NAME = "rubber-ball-on-surface"
TITLE = "Homogeneous rubber ball on a surface"

#: Any surface above the plane, and any force that depends on place and angular velocity.
GRAPH = z - sp.Function("f_s")(x, y)
FORCE = constant([sp.Function(f"F_{i}")(*R.symbols, *omega.symbols) for i in (1, 2, 3)])


def laws() -> tuple[Law, ...]:
    """The laws that hold on every surface and under every force."""
    heavier = m + mu / b**2
    push = -dot(F, n) - heavier * dot(v, rate(n))
    return (
        Identity(
            "balance",
            (m * rate(v) - N - F, mu * rate(omega) - cross(r, N) - N_0 * r),
            "Newton's and Euler's equations with the reactions of both constraints",
            source="(2.10)",
        ),
        Identity(
            "particle",
            heavier * rate(v) - F - push * n,
            "the centre moves on its surface as a particle of mass m + μ/b²",
            source="(2.9), Proposition 3",
            as_printed=Identity(
                "particle", heavier * rate(v) - F - push * constant([s**2 for s in n])
            ),
            misprint="λ is a number; printed is a vector, with a further factor n (it is "
            "multiplied by n component by component here)",
        ),
    )


def any_graph(force: MatrixExpr = FORCE) -> System:
    """The ball over any surface z = f(x, y), with ω₃ = (∂f/∂x) ω₁ + (∂f/∂y) ω₂ as a definition."""
    numbers = ball_parameters(1.0, 0.4, 1.0)
    system = ball_equations("rubber", centre_surface(GRAPH), force, numbers, NAME, TITLE)
    return tangential(replace(system, reconstruction=None))


def general() -> System:
    """Any surface z = f(x, y) and any force at the centre."""
    stays = Integral("surface", GRAPH, "the centre stays on its surface", source="(2.7)")
    return any_graph().with_laws(stays, *laws())


def particle_laws(ball: RollingBall) -> tuple[Law, ...]:
    """The ball in the bowl is a particle that falls more slowly."""
    fall = real_symbol("w")
    falling = Parameter(fall, "acceleration of the particle in free fall", 7.0, "m/s^2")
    on_bowl = particle(
        ball.kinematics.surface, -mtilde * fall * unit_vector(3), *ball.surface.parameters, falling
    )
    heavier = m + mu / b**2
    return (
        *laws(),
        Isomorphism(
            "particle-on-a-surface",
            on_bowl,
            {R: R, v: v},
            constants={mtilde: heavier, fall: m * g / heavier},
            meaning="the centre is a particle of mass m + μ/b²",
            onto=(ball.kinematics.surface, *TANGENT),
            source="Proposition 3, Remark 6",
        ),
    )
