"""A homogeneous rubber ball on a surface (§2.3): its centre is a particle on the parallel surface.

Everything is written in space axes.  The centre R moves on a surface f = 0, whose unit normal
n = ∇f/|∇f| points away from the supporting surface; r = −bn leads to the contact point.  With the
reactions N and N₀r of both constraints the equations of motion are

    m v̇ = N + F,      μ ω̇ = r×N + N₀r,      v = r×ω,      (ω, r) = 0.

The constraints give b²ω = v×r, N − (N, n)n = −(μ/b²)/(m + μ/b²) (F − (F, n)n) and
N₀ = −μ(ω, ṙ)/b².
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import sympy as sp

from ..mechanics.body import check_inertia, check_mass
from ..statements import Identity, Integral, Isomorphism, Law
from ..system import Guard, Observable, Parameter, System
from ..vectors import constant, cross, dot, explicit, gradient, normed, scalar, unit, vectors
from .entry import Entry, Numbers, Start
from .rates import rate

__all__ = ["ENTRIES", "FORCE", "any_graph", "ball", "particle"]

R, omega, v, n, ndot, r, N, F, df = vectors("R omega v n ndot r N F df")
m, mu, b, g, p, q = (scalar(name) for name in ("m", "mu", "b", "g", "p", "q"))
ell, N_0, mtilde, lambda_ = (scalar(name) for name in ("ell", "N_0", "mtilde", "lambda"))
x, y, z = R.symbols

NAME = "rubber-ball-on-surface"
TITLE = "Homogeneous rubber ball on a surface"
SUMMARY = (
    "A heavy homogeneous ball rolls in a bowl with neither slipping nor spinning; its centre moves "
    "like a particle on an elliptic paraboloid."
)
SOURCE = "§2.3, (2.7)–(2.11)"

#: Any surface above the plane, and any force that depends on place and angular velocity.
GRAPH = z - sp.Function("f_s")(x, y)
FORCE = constant([sp.Function(f"F_{i}")(*R.symbols, *omega.symbols) for i in (1, 2, 3)])
BOWL = z - x**2 / (2 * p) - y**2 / (2 * q)


def _normal(surface: sp.Expr) -> dict[Any, Any]:
    """Definitions of the normal."""
    return {df: gradient(surface, R, "f"), ell: sp.sqrt(normed(df)), n: df / ell}


def _turning(surface: sp.Expr) -> dict[Any, Any]:
    """Definition of the rate of the normal in the velocity v."""
    turned = constant(sp.hessian(surface, R.symbols)) * v
    return {ndot: (turned - dot(n, turned) * n) / ell}


def _body(numbers: Numbers) -> tuple[Parameter, ...]:
    check_mass(numbers["m"])
    check_inertia((numbers["mu"],) * 3)
    return (
        Parameter(m, "mass", numbers["m"], "kg", (m > 0,)),
        Parameter(mu, "moment of inertia about the centre", numbers["mu"], "kg m^2", (mu > 0,)),
        Parameter(b, "radius of the ball", numbers["b"], "m", (b > 0,)),
    )


def ball(numbers: Numbers, surface: sp.Expr, force: Any, *further: Parameter) -> System:
    """The ball whose centre moves on `surface` = 0 under a force at the centre.

    Parameters
    ----------
    numbers : mapping
        ``m``, ``mu`` and ``b``.
    surface : sympy.Expr
        f in ``R_1``, ``R_2``, ``R_3``, of the form R_3 − φ(R_1, R_2).
    force : vector
        F in space axes, in the state.
    """
    heavier = m + mu / b**2
    return System(
        name=NAME,
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        parameters=_body(numbers) + further,
        definitions={
            **_normal(surface),
            r: -b * n,
            v: cross(r, omega),
            **_turning(surface),
            F: force,
            N: -(mu / b**2 / heavier) * (F - dot(F, n) * n) - (m * dot(v, ndot) + dot(F, n)) * n,
            N_0: mu * dot(omega, ndot) / b,
        },
        field={R: v, omega: (cross(r, N) + N_0 * r) / mu},
        relations=(dot(omega, df),),
        observables=(
            Observable("velocity", v, "velocity of the centre", "m/s", "space", "(2.8)"),
            Observable("contact", R + r, "contact point", "m", "space", "(2.8)"),
            Observable("normal_force", dot(N, n), "normal force", "N", source="(2.10)"),
        ),
        guards=(Guard("contact", dot(N, n), "the normal force changes sign", lift_off=True),),
    )


def laws(surface: sp.Expr) -> tuple[Law, ...]:
    """What holds on every surface and under every force."""
    heavier = m + mu / b**2
    push = -dot(F, n) - heavier * dot(v, rate(n))
    return (
        Integral("surface", surface, "the centre stays on its surface", source="(2.7)"),
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


def particle(surface: sp.Expr, force: Any, *further: Parameter) -> System:
    """A particle of mass m̃ on `surface` = 0, by Lagrange's equations of the first kind."""
    return System(
        name="particle-on-a-surface",
        title="Particle on a surface",
        field={R: v, v: (F + lambda_ * n) / mtilde},
        parameters=(Parameter(mtilde, "mass", 1.4, "kg", (mtilde > 0,)), *further),
        definitions={
            **_normal(surface),
            **_turning(surface),
            F: force,
            lambda_: -dot(F, n) - mtilde * dot(v, ndot),
        },
        relations=(dot(v, df),),
        source="(2.9)",
    )


def build(numbers: Numbers) -> System:
    """A heavy ball in a bowl."""
    weight = -m * g * unit(3)
    shape = (
        Parameter(p, "curvature radius at the lowest point, along x", numbers["p"], "m", (p > 0,)),
        Parameter(q, "curvature radius at the lowest point, along y", numbers["q"], "m", (q > 0,)),
    )
    gravity = Parameter(g, "acceleration of gravity", numbers["g"], "m/s^2", (g >= 0,))
    half, heavier = sp.Rational(1, 2), m + mu / b**2
    v_1, v_2, _ = v.symbols
    fall = scalar("w")
    return ball(numbers, BOWL, weight, *shape, gravity).with_laws(
        Integral(
            "energy",
            half * m * normed(v) + half * mu * normed(omega) + m * g * z,
            "energy",
            source="(2.10)",
            unit="J",
        ),
        Integral(
            "quadratic",
            ell**2 * (v_1**2 / p + v_2**2 / q + m * g / heavier),
            "Joachimsthal's integral of the paraboloid, in gravity",
            source="§2.3",
            unit="m/s^2",
        ),
        *laws(BOWL),
        Isomorphism(
            "particle-on-a-surface",
            particle(
                BOWL,
                -mtilde * fall * unit(3),
                *shape,
                Parameter(fall, "acceleration of the particle in free fall", 7.0, "m/s^2"),
            ),
            {R: R, v: v},
            constants={mtilde: heavier, fall: m * g / heavier},
            meaning="the centre is a particle of mass m + μ/b²",
            source="Proposition 3, Remark 6",
        ),
    )


def any_graph(force: Any = FORCE) -> System:
    """The ball over any surface z = f(x, y), with ω₃ = (∂f/∂x) ω₁ + (∂f/∂y) ω₂ as a definition."""
    system = ball(_DEFAULTS, GRAPH, force)
    turn_1, turn_2, turn_3 = omega.symbols
    slope_1, slope_2, _ = df.symbols
    field = dict(system.field)
    first, second, _ = explicit(field[omega])
    normal, rest = system.definitions[:1], system.definitions[1:]
    return replace(
        system,
        field={R: field[R], turn_1: first, turn_2: second},
        definitions=(*normal, (turn_3, -slope_1 * turn_1 - slope_2 * turn_2), *rest),
        relations=(),
    )


def general() -> System:
    """Any surface z = f(x, y) and any force at the centre."""
    return any_graph().with_laws(*laws(GRAPH))


_DEFAULTS = {"m": 1.0, "mu": 0.4, "b": 1.0, "p": 3.0, "q": 4.0, "g": 9.81}

ENTRIES = (
    Entry(
        name=NAME,
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        defaults=_DEFAULTS,
        build=build,
        start=Start(
            state={"R": (1.0, 0.0, 1.0 / 6.0), "omega": (-0.6, 0.9, -0.2)},
            until=60.0,
        ),
        general=general,
    ),
)
