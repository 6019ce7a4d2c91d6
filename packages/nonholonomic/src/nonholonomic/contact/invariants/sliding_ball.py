"""A homogeneous ball that slides on a plane (§11.2), in space axes.

With the velocity V of the centre, the contact r = −R e_z, the slip u = V + ω×r and the forces N e_z
and F of the plane,

    m V̇ = F + (N − mg) e_z,      I ω̇ = r×F + K e_z.

Since r×e_z = 0, the momentum about the contact point Iω − m r×V has the rate K e_z, whatever F
is.  For a force against the slip, F = −φ u, the slip keeps its direction.
"""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Identity, Integral, Law, Rate
from flowlanes.system.system import Guard, Observable, Parameter, System
from flowlanes.system.vectors import constant, real_symbol, vectors

(place, V, omega, u) = vectors("place V omega u")
m, R, g, inertia, mu, slip_speed = (
    real_symbol(s) for s in ("m", "R", "g", "I", "mu", "slip_speed")
)
SOURCE = "§11.2"
_STATE = (*place.symbols, *V.symbols, *omega.symbols)


def _unspecified_function(name: str) -> sp.Expr:
    """An unspecified function of the state."""
    value: sp.Expr = sp.Function(name)(*_STATE)
    return value


#: Unspecified force of the plane and couple about the normal; unspecified coefficient of a force
#: opposite to u.
ANY_FORCE = tuple(_unspecified_function(f"F_{i}") for i in (1, 2, 3))
ANY_COUPLE, ANY_COEFFICIENT = _unspecified_function("K"), _unspecified_function("phi")

SpaceForce = tuple[sp.Expr, sp.Expr, sp.Expr]


def ball_parameters(
    mass: float = 1.0, moment: float = 0.4, radius: float = 1.0, gravity: float = 9.81
) -> tuple[Parameter, ...]:
    """Mass, moment of inertia, radius and gravity."""
    return (
        Parameter(m, "mass", mass, "kg", (m > 0,)),
        Parameter(inertia, "moment of inertia", moment, "kg m^2", (inertia > 0,)),
        Parameter(R, "radius", radius, "m", (R > 0,)),
        Parameter(g, "acceleration of gravity", gravity, "m/s^2", (g > 0,)),
    )


def sliding_ball(
    force: SpaceForce,
    couple: sp.Expr = sp.S.Zero,
    parameters: tuple[Parameter, ...] | None = None,
    name: str = "sliding-ball",
) -> System:
    """The equations of a homogeneous ball under a force of the plane.

    Parameters
    ----------
    force : three formulas
        Force of the plane, normal force included (N, space axes); it may use `u` and `slip_speed`.
    couple : sympy.Expr
        Couple about the normal (N m).
    parameters : tuple of Parameter, optional
        By default a ball of 1 kg and 1 m.
    name : str

    Returns
    -------
    System
        State: centre `place`, its velocity `V`, and `omega`, all in space axes.

    Examples
    --------
    >>> import lawproof
    >>> from nonholonomic.contact.invariants.sliding_ball import ANY_FORCE, momenta, sliding_ball
    >>> [lawproof.prove(sliding_ball(ANY_FORCE), law).decision for law in momenta()]
    ['proven', 'proven', 'proven']
    """
    F_1, F_2, F_3 = force
    turning = constant([R * F_2 / inertia, -R * F_1 / inertia, couple / inertia])
    omega_1, omega_2, _ = omega.symbols
    return System(
        name=name,
        title="Homogeneous ball that slides",
        field={
            place: constant(list(V.symbols)),
            V: constant([F_1 / m, F_2 / m, F_3 / m - g]),
            omega: turning,
        },
        definitions={
            u: constant([V.symbols[0] - R * omega_2, V.symbols[1] + R * omega_1, V.symbols[2]]),
            slip_speed: sp.sqrt(sum(s**2 for s in u.symbols[:2])),
        },
        parameters=parameters or ball_parameters(),
        observables=(
            Observable("centre", place, "centre", "m", "space"),
            Observable("slip", u, "velocity of the contact over the plane", "m/s", "space"),
            Observable("energy", ENERGY, "kinetic energy and that of the height", "J"),
        ),
        source=SOURCE,
        summary="A homogeneous ball on a plane on which it slides with friction.",
    )


def _energy() -> sp.Expr:
    translation = m * sp.Add(*(s**2 for s in V.symbols))
    rotation = inertia * sp.Add(*(s**2 for s in omega.symbols))
    return (translation + rotation) / 2 + m * g * place.symbols[2]


#: Kinetic and potential energy (J).
ENERGY = _energy()


def against_slip(coefficient: sp.Expr = ANY_COEFFICIENT) -> SpaceForce:
    """The force −φu along the plane with the normal force mg."""
    first, second, _ = u.symbols
    return -coefficient * first, -coefficient * second, m * g


def dry_ball(parameters: tuple[Parameter, ...], name: str = "sliding-ball") -> System:
    """A ball under dry friction: the force −μmg u/|u|.

    Parameters
    ----------
    parameters : tuple of Parameter
        Those of `ball_parameters`, and μ.
    name : str
    """
    from dataclasses import replace

    system = sliding_ball(against_slip(mu * m * g / slip_speed), parameters=parameters, name=name)
    guard = Guard("slip", sp.Add(*(s**2 for s in u.symbols[:2])), "sliding ends")
    return replace(system, relations=(V.symbols[2],), guards=(guard,))


def momenta() -> tuple[Integral, ...]:
    """The momentum about the contact point, Iω − m r×V, by components."""
    V_1, V_2, _ = V.symbols
    values = (-m * R * V_2, m * R * V_1, sp.S.Zero)
    return tuple(
        Integral(
            f"momentum_{axis}",
            inertia * s + value,
            f"momentum about the contact point along {axis}",
            unit="kg m^2/s",
            source=SOURCE,
        )
        for axis, s, value in zip("xyz", omega.symbols, values, strict=True)
    )


def slip_direction() -> tuple[Integral, ...]:
    """Integrals that state that the slip has a constant direction, one for each component."""
    return tuple(
        Integral(
            f"direction_{axis}",
            part / slip_speed,
            f"direction of the slip along {axis}",
            unit="1",
            source=SOURCE,
        )
        for axis, part in zip("xy", u.symbols[:2], strict=True)
    )


def dry_laws() -> tuple[Law, ...]:
    """The laws of dry friction: parabolic path, linearly decreasing slip, energy loss."""
    slowing = mu * g * (1 + m * R**2 / inertia)
    jerks = tuple(Rate(Rate(Rate(s))) for s in place.symbols[:2])
    return (
        Identity("parabola", jerks, "the acceleration of the centre is constant", source=SOURCE),
        Identity(
            "slip_rate",
            Rate(slip_speed) + slowing,
            "the slip falls at the constant rate μg(1 + mR²/I)",
            source=SOURCE,
        ),
        Identity(
            "energy_decrease",
            Rate(ENERGY) + mu * m * g * slip_speed,
            "the energy falls by the power μmg|u|",
            source="§11.1",
        ),
    )
