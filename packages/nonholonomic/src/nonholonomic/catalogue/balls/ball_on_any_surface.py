"""Laws of a homogeneous ball on every surface, with f and forces unspecified.

A rubber ball moves like a particle of mass m̃ = m + μ/b² on the surface of its centre
(Proposition 3), a marble ball like one on which its spin σ = (ω, n) acts besides,

    m̃ v̇ = F + λn + (μ/b) σ n×ṅ,      b σ̇ = (n×v, ṅ).

On a plane, where ṅ = 0, this is Proposition 2.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Identity, Integral, Law, Measure, Rate
from flowlanes.system.named_formulas import scalars
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import constant, cross, dot, norm_squared, real_symbol, vectors, zero

from ...mechanics.ball.equations import (
    Contact,
    Kinematics,
    ball_equations,
    ball_parameters,
    centre_surface,
    supporting_surface,
)
from ...mechanics.ball.mechanism import ball_mechanism
from ...mechanics.lagrangian.poincare_suslov import equations_of_motion
from ..vector_rates import rate

R, x, omega, v, n, ndot, r, N, F, df = vectors("R x omega v n ndot r N F df")
m, mu, b, N_0, ell = (real_symbol(name) for name in ("m", "mu", "b", "N_0", "ell"))
mtilde, sigma, lambda_, Delta = (real_symbol(s) for s in ("mtilde", "sigma", "lambda", "Delta"))
beta = real_symbol("beta")
half = sp.Rational(1, 2)

SURFACE = sp.Function("f")(*R.symbols)
SUPPORT = sp.Function("f")(*x.symbols)
POTENTIAL = sp.Function("U")(*R.symbols)
NUMBERS = ball_parameters(1.0, 0.4, 1.0)

NEWTON = "Newton's and Euler's equations with the reactions of all constraints"
PARTICLE = "the centre is a particle of mass m + μ/b²"
#: What vanishes for a particle that stays on its surface, in the definitions of `particle`.
TANGENT = (dot(v, df),)


def _particle_on(
    surface: sp.Expr,
    force: MatrixExpr,
    push: MatrixExpr,
    further: dict[sp.Expr, sp.Expr],
    parameters: tuple[Parameter, ...],
) -> System:
    bent = constant(sp.hessian(surface, R.symbols)) * v
    return System(
        name="particle-on-a-surface",
        title="Particle on a surface",
        field={R: v, v: (F + push + lambda_ * n) / mtilde, **further},
        parameters=(Parameter(mtilde, "mass", 1.4, "kg", (mtilde > 0,)), *parameters),
        definitions={
            df: gradient(surface, R, "f"),
            ell: sp.sqrt(norm_squared(df)),
            n: df / ell,
            ndot: (bent - dot(n, bent) * n) / ell,
            F: force,
            lambda_: -dot(F, n) - mtilde * dot(v, ndot),
        },
        source="(2.9)",
    )


def particle(surface: sp.Expr, force: MatrixExpr, *parameters: Parameter) -> System:
    """A particle on a surface, by Lagrange's equations of the first kind; state R and v."""
    return _particle_on(surface, force, zero, {}, parameters)


def spinning_particle(surface: sp.Expr, force: MatrixExpr, *parameters: Parameter) -> System:
    """A particle with a spin σ that turns it aside where the surface bends; state R, v and σ.

    The spin acts by the force βσ n×ṅ, with β = μ/b for a ball, and changes by b σ̇ = (n×v, ṅ).
    """
    spin = Parameter(beta, "moment of inertia over radius", 0.4, "kg m", (beta > 0,))
    radius = Parameter(b, "radius", 1.0, "m", (b > 0,))
    turned = dot(cross(n, v), ndot) / b
    return _particle_on(
        surface,
        force,
        beta * sigma * cross(n, ndot),
        {sigma: turned},
        (spin, radius, *parameters),
    )


def balance(contact: Contact) -> Identity:
    """Newton's and Euler's equations, (2.6) or (2.10)."""
    spin = N_0 * r if contact == "rubber" else zero
    return Identity(
        "balance",
        (m * rate(v) - N - F, mu * rate(omega) - cross(r, N) - spin, v + cross(omega, r)),
        NEWTON,
        source="(2.6)" if contact == "marble" else "(2.10)",
    )


def _turning() -> Identity:
    """R and n move as they should."""
    return Identity(
        "turning",
        (rate(R) - v, rate(n) - ndot),
        "the velocity of the centre and the turning of the normal",
        source="(2.7)",
    )


def _common(kinematics: Kinematics, density: dict[sp.Expr, sp.Expr]) -> tuple[Law, ...]:
    energy = half * m * norm_squared(v) + half * mu * norm_squared(omega) + POTENTIAL
    volume = "area of the surface times volume of ω, on every surface and in every potential"
    stays = "the ball stays on its surface"
    return (
        Integral("surface", kinematics.surface, stays, source="(2.7)"),
        Integral("energy", energy, "energy", source="Theorem 1", unit="J"),
        Measure("volume", density, volume, source="§2.2"),
    )


def _system(contact: Contact, kinematics: Kinematics) -> System:
    force = -gradient(POTENTIAL, R)
    system = ball_equations(contact, kinematics, force, NUMBERS)
    return replace(system, reconstruction=None)


def _derived_system(contact: Contact) -> System:
    """The equations that follow from Lagrangian, frame and constraints alone."""
    system = equations_of_motion(ball_mechanism(contact, SURFACE, POTENTIAL, NUMBERS))
    return replace(system, laws=(), reconstruction=None)


def _first_principles(target: System) -> Isomorphism:
    return Isomorphism(
        "first_principles",
        target,
        {s: s for s in target.symbols},
        meaning="the Poincaré–Suslov equations of the ball's Lagrangian and constraints",
        source="(1.9), (2.8)",
    )


def tangential(system: System) -> System:
    """Solve the constraint (ω, ∇f) = 0 for ω₃, which leaves a system without relations."""
    place, field = system.state[0], dict(system.field)
    turn_1, turn_2, turn_3 = omega.symbols
    slope_1, slope_2, slope_3 = df.symbols
    first, second, _ = scalars(field[omega])
    index = [name for name, _ in system.definitions].index(n) + 1
    solved = (turn_3, -(slope_1 * turn_1 + slope_2 * turn_2) / slope_3)
    return replace(
        system,
        field={place: field[place], turn_1: first, turn_2: second},
        definitions=(*system.definitions[:index], solved, *system.definitions[index:]),
        relations=(),
    )


def any_marble() -> System:
    """A marble ball whose centre moves on any surface, in any potential."""
    kinematics = centre_surface(SURFACE)
    return _system("marble", kinematics).with_laws(
        *_common(kinematics, {ell: 1}),
        balance("marble"),
        _first_principles(_derived_system("marble")),
        Identity(
            "spin",
            Rate(sigma) - dot(omega, ndot),
            "the spin changes only where the normal turns",
            source="(2.6)",
        ),
        Isomorphism(
            "particle",
            spinning_particle(SURFACE, -gradient(POTENTIAL, R)),
            {R: R, v: v, sigma: sigma},
            constants={mtilde: mtilde, beta: mu / b},
            meaning=f"{PARTICLE} on which the spin acts",
            onto=TANGENT,
            source="Propositions 2, 3",
        ),
    )


def any_rubber() -> System:
    """A rubber ball whose centre moves on any surface, in any potential."""
    kinematics = centre_surface(SURFACE)
    density = {ell: 2, df.symbols[2]: -1}
    return tangential(_system("rubber", kinematics)).with_laws(
        *_common(kinematics, density),
        balance("rubber"),
        _first_principles(tangential(_derived_system("rubber"))),
        Isomorphism(
            "particle",
            particle(SURFACE, -gradient(POTENTIAL, R)),
            {R: R, v: v},
            constants={mtilde: mtilde},
            meaning=PARTICLE,
            onto=TANGENT,
            source="Proposition 3",
        ),
    )


def any_supported_marble() -> System:
    """A marble ball on any supporting surface, in any potential."""
    kinematics = supporting_surface(SUPPORT)
    return _system("marble", kinematics).with_laws(
        *_common(kinematics, {ell: 1, Delta: 1}), _turning()
    )


def any_supported_rubber() -> System:
    """A rubber ball on any supporting surface, in any potential."""
    kinematics = supporting_surface(SUPPORT)
    density = {ell: 2, Delta: 1, df.symbols[2]: -1}
    return tangential(_system("rubber", kinematics)).with_laws(
        *_common(kinematics, density), _turning()
    )
